// `gradus man`: the manual, in the language of man pages (roff), made from the tables of commands and topics.

#include "cli/commands/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "cli/command_line/errors.hpp"
#include "cli/commands/help.hpp"
#include "cli/files/files.hpp"
#include "cli/files/own_files.hpp"
#include "figure/colophon.hpp"
#include "request/inputs.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

/// Running text: what roff would act on stands for itself, and a hyphen is the one that flags have.
std::string roff(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else if (c == '\'') {
      escaped += "\\(aq";
    } else if (c == '`') {
      escaped += "\\(ga";
    } else if (c == '^') {
      escaped += "\\(ha";
    } else if (c == '/') {
      escaped += "/\\:";  // a maze in one line may be cut between its rows
    } else if (c == '~') {
      escaped += "\\(ti";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

/// A line of text: it may begin with what would else be a request.
std::string line(std::string_view text) {
  const std::string escaped = roff(text);
  return (escaped.starts_with('.') ? "\\&" : "") + escaped + "\n";
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// A term and what it means.
std::string item(const std::string& term, std::string_view meaning) {
  return ".TP\n" + term + "\n" + line(meaning);
}

std::string section(std::string_view title) { return fmt::format(".SH {}\n", title); }

std::string heading(std::string_view name, int number) {
  std::string upper(name);
  std::ranges::transform(upper, upper.begin(),
                         [](char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return fmt::format("{}\n.TH {} {} \"\" \"gradus {}\" \"Gradus manual\"\n.ad l\n.nh\n", manual_mark,
                     roff(upper), number, release_version);
}

std::string examples_section(const std::vector<std::string>& examples) {
  std::string text = section("EXAMPLES") + ".nf\n";
  for (const std::string& example : examples) text += line(example);
  return text + ".fi\n";
}

std::string flag_item(const Flag& flag) {
  std::string term = flag.letter ? bold(fmt::format("-{}", flag.letter)) + ", " : "";
  term += bold("--" + flag.name);
  if (!flag.value.empty()) term += " " + italic(flag.value);
  return item(term, flag.help + (flag.many ? "; may be given several times" : ""));
}

std::string flags_section(std::span<const Flag> flags, std::string_view title) {
  if (flags.empty()) return "";
  std::string text = section(title);
  for (const Flag& flag : flags) text += flag_item(flag);
  return text;
}

std::string limits_section(const Command& command) {
  if (command.limits.empty()) return "";
  std::string text = section("LIMITS") + ".nf\n";
  for (const std::string& limit : command.limits) text += line(limit);
  return text + ".fi\n";
}

constexpr std::string_view exit_status =
    ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\nthe work failed\n.TP\n2\nthe input is wrong: one line on "
    "standard error "
    "says where, what was expected and what was found\n.TP\n130\nstopped by Ctrl\\-C\n";

std::string reference(std::string_view page, int number) { return bold(page) + fmt::format("({})", number); }

std::string see_also(const std::vector<std::string>& references) {
  return section("SEE ALSO") + fmt::format("{}\n", fmt::join(references, ",\n"));
}

std::string command_page_name(const Command& command) { return "gradus-" + command.name; }
std::string topic_page_name(const TopicEntry& topic) { return "gradus-" + topic.name; }

/// "a TOPIC" -> "TOPIC"; "one WORD" -> "[WORD]", "TOPICs" -> "[TOPIC ...]".
std::string operands_of(const Command& command) {
  const std::string last = command.operands.substr(command.operands.rfind(' ') + 1);
  const bool several = last.ends_with('s') && command.most > 1;
  const std::string name = several ? last.substr(0, last.size() - 1) + " ..." : last;
  const std::string shown = italic(name);
  return command.least == 0 ? "[" + shown + "]" : shown;
}

std::string synopsis_of(const Command& command) {
  return bold("gradus " + command.name) + " " + operands_of(command) + " [" + italic("flags") + "]\n";
}

std::string command_page(const Command& command) {
  std::string text = heading(command_page_name(command), 1);
  text += section("NAME") + roff(command_page_name(command)) + " \\- " + line(command.summary);
  text += section("SYNOPSIS") + synopsis_of(command);
  if (command.about_topic) {
    text += section("DESCRIPTION") + line(
                                         "The inputs of a topic are flags, too; its own page tells which. "
                                         "They and --method stand anywhere "
                                         "behind the command.");
  }
  text += flags_section(command.flags, "FLAGS") + flags_section(common_flags(), "FLAGS OF EVERY COMMAND");
  text +=
      limits_section(command) + examples_section(examples_of(command, nullptr)) + std::string(exit_status);
  return text + see_also({reference("gradus", 1)});
}

std::string inputs_section(const TopicEntry& topic) {
  if (topic.parameters.empty()) return "";
  std::string text = section("INPUTS");
  for (const Parameter& p : topic.parameters) {
    std::string term = bold("--" + hyphened(p.name));
    if (p.type != ParameterType::flag) term += " " + italic(shell_quoted(p.example));
    text +=
        item(term, fmt::format("{}: {}{}{}", p.help, domain_of(p),
                               p.default_value.empty() ? "" : "; default " + shell_quoted(p.default_value),
                               p.instead_of.empty() ? "" : "; instead of --" + hyphened(p.instead_of)));
  }
  return text;
}

std::string methods_section(const TopicEntry& topic) {
  std::string text = section("METHODS");
  for (const Method& method : topic.methods) {
    const std::vector<std::string> marks = marks_of(method, topic);
    text += item(bold("--method") + " " + bold(method.name) +
                     (marks.empty() ? "" : fmt::format(" ({})", fmt::join(marks, ", "))),
                 method.title + (method.note.empty() ? "" : ": " + method.note));
  }
  return text;
}

std::string topic_page(const TopicEntry& topic) {
  std::string text = heading(topic_page_name(topic), 7);
  text += section("NAME") + roff(topic_page_name(topic)) + " \\- " + line(topic.summary);
  text += section("SYNOPSIS") + bold("gradus run " + topic.name) + " [" + italic("inputs") + "]\n.br\n" +
          bold("gradus figure " + topic.name) + " [" + italic("inputs") + "] " + bold("-o") + " " +
          italic("FILE") + "\n";
  text += inputs_section(topic) + methods_section(topic);
  text += section("SYMBOLS") + line(symbols_text(topic));
  if (!topic.aliases.empty())
    text += section("ALSO CALLED") + line(fmt::format("{}", fmt::join(topic.aliases, ", ")));
  text += examples_section(examples_of(topic));
  return text + see_also({reference("gradus", 1), reference("gradus-run", 1), reference("gradus-figure", 1)});
}

std::string overview_page() {
  std::string text = heading("gradus", 1);
  text += section("NAME") + "gradus \\- " + line("draws computer-graphics algorithms step by step");
  text += section("SYNOPSIS") + bold("gradus") + " " + italic("COMMAND") + " [" + italic("operands") + "] [" +
          italic("flags") + "]\n";
  text +=
      section("DESCRIPTION") +
      line(
          "Figures, tables and a player page, made from real runs of a catalogue of algorithms. Names may be "
          "shortened; hyphens and underscores are the same.");
  text += section("COMMANDS");
  std::vector<std::string> references;
  for (const Command& command : commands()) {
    text += item(bold(command.name) + " " + operands_of(command), command.summary);
    references.push_back(reference(command_page_name(command), 1));
  }
  text += section("TOPICS");
  for (const TopicEntry* topic : catalogue()) {
    text += item(bold(topic->name), fmt::format("{}: {}", topic->title, topic->summary));
    references.push_back(reference(topic_page_name(*topic), 7));
  }
  text += flags_section(common_flags(), "FLAGS OF EVERY COMMAND");
  text += section("ENVIRONMENT");
  text += item(
      bold("NO_COLOR") + ", " + bold("CLICOLOR_FORCE") + ", " + bold("FORCE_COLOR") + ", " + bold("TERM"),
      "whether texts in the terminal are coloured, where no flag says so");
  text += item(bold("BROWSER"), "what `gradus open` shows pages with: commands with : between them");
  text += item(bold("SLURM_CPUS_PER_TASK"), "how many figures `gradus figures` draws at once, at most");
  text += examples_section(first_examples()) + std::string(exit_status);
  return text + see_also(references);
}

/// A page, and the file that man expects it in: "man1/gradus-run.1".
struct Page {
  std::string file, text;
};

std::vector<Page> all_pages() {
  std::vector<Page> pages{{"man1/gradus.1", overview_page()}};
  for (const Command& command : commands())
    pages.push_back({fmt::format("man1/{}.1", command_page_name(command)), command_page(command)});
  for (const TopicEntry* topic : catalogue())
    pages.push_back({fmt::format("man7/{}.7", topic_page_name(*topic)), topic_page(*topic)});
  return pages;
}

int write_all(const std::string& folder, Replace replace) {
  NewFiles files;
  for (const char* part : {"man1", "man7"}) make_folder(folder + "/" + part, "-o");
  for (const Page& page : all_pages()) files.add(folder + "/" + page.file, page.text, replace);
  files.commit();
  return 0;
}

}  // namespace

std::string manual_page(const std::string& word) {
  if (word.empty()) return overview_page();
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(command.name);
  const auto exact = std::ranges::find(names, folded(word));
  if (exact != names.end()) return command_page(commands()[static_cast<std::size_t>(exact - names.begin())]);
  return topic_page(find_topic(word));
}

int manual(const Request& request) {
  const auto output = request.flags.find("output");
  if (output != request.flags.end()) {
    if (!request.operands.empty()) {
      throw UsageError(fmt::format("man: expected either -o for all pages or one page, found both ({})",
                                   shown(request.operands[0])));
    }
    return write_all(output->second, replaces(request.has("force")));
  }
  write_stream(Stream::out, manual_page(request.operands.empty() ? "" : request.operands[0]));
  return 0;
}

}  // namespace gradus::cli
