// `gradus help` and --help: made from the tables of commands and topics, examples first.

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <glm/detail/setup.hpp>

#include "cairo/cairo_output.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/help.hpp"
#include "cli/files/files.hpp"
#include "figure/colophon.hpp"
#include "request/inputs.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"
#include "text/wrap.hpp"

namespace gradus::cli {
namespace {

constexpr std::string_view introduction =
    "gradus draws computer-graphics algorithms step by step: figures, tables and a player made from real "
    "runs.\n";

/// Two columns, the second aligned.
std::string columns(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::size_t width = 0;
  for (const auto& [left, right] : rows) width = std::max(width, left.size());
  std::string text;
  for (const auto& [left, right] : rows) {
    const std::string gap(width - left.size() + 2, ' ');
    text += right.empty() ? fmt::format("  {}\n", left) : fmt::format("  {}{}{}\n", left, gap, right);
  }
  return text;
}

std::string section(std::string_view title, bool color) { return "\n" + bold(title, color) + "\n"; }

std::string flag_words(const Flag& flag) {
  const std::string letter = flag.letter ? fmt::format("-{}, ", flag.letter) : "    ";
  return letter + "--" + flag.name + (flag.value.empty() ? "" : " " + flag.value);
}

std::string flag_table(std::span<const Flag> flags) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Flag& flag : flags) rows.emplace_back(flag_words(flag), flag.help);
  return columns(rows);
}

std::string range_of(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::cell:
      return fmt::format("two whole numbers, {} to {}", parameter.least, parameter.most);
    case ParameterType::window:
      return "four whole numbers, xmin <= xmax and ymin <= ymax";
    case ParameterType::integer:
      return fmt::format("a whole number, {} to {}", parameter.least, parameter.most);
    case ParameterType::choice:
      return fmt::format("one of {}", fmt::join(parameter.choices, ", "));
    case ParameterType::color:
      return "#rrggbb or a basic colour's name";
    case ParameterType::paint:
      return "#rrggbb or a basic colour's name; for a maze a letter";
    case ParameterType::picture:
      return "a PNG or JPEG file, or - for standard input";
    case ParameterType::maze:
      return "a text file, - for standard input, or rows like '#.#/...'";
    case ParameterType::number:
      return fmt::format("a number, {} to {}", parameter.least, parameter.most);
    case ParameterType::numbers:
      return fmt::format("{} numbers {}", parameter.parts.size(), fmt::join(parameter.parts, ","));
    case ParameterType::bounds:
      return fmt::format("{} numbers {}, no lower one above its upper one", parameter.parts.size(),
                         fmt::join(parameter.parts, ","));
    case ParameterType::points:
      return fmt::format("points {} with spaces between them", fmt::join(parameter.parts, ","));
    case ParameterType::rings:
      return fmt::format("points {} with spaces between them, and ; between rings",
                         fmt::join(parameter.parts, ","));
    case ParameterType::order:
      return fmt::format("{}{}, each once in any order", fmt::join(parameter.choices, ","),
                         parameter.numbered ? " or the numbers 1, 2, … to the last" : "");
    case ParameterType::factors:
      return parameter.parts.size() == 3
                 ? "translate X,Y,Z, scale S or X,Y,Z [about X,Y,Z], rotate DEGREES about x, y, z or X,Y,Z "
                   "[through X,Y,Z], with ; between them"
                 : "translate X,Y, scale S or X,Y, rotate DEGREES, shear X,Y, each but the first with [about "
                   "X,Y], reflect x, y, origin, y=x or X,Y X,Y, with ; between them";
    case ParameterType::faces:
      return fmt::format(
          "a JSON or OBJ file, or faces NAME: x,y,z x,y,z x,y,z with ; between them, of up to {} corners",
          parameter.most);
    case ParameterType::model:
      return "an OBJ file, or - for standard input; the flag may be left out";
    case ParameterType::flag:
      return "takes no value";
  }
  return "";
}

}  // namespace

std::string domain_of(const Parameter& parameter) {
  return range_of(parameter) + (parameter.sizes.limited() ? ", each " + text_of(parameter.sizes) : "");
}

namespace {

std::string inputs_of(const TopicEntry& topic) {
  std::string text;
  for (const Parameter& p : topic.parameters) {
    const std::string first =
        "--" + hyphened(p.name) + (p.type == ParameterType::flag ? "" : " " + shell_quoted(p.example));
    text += fmt::format("  {}\n      {}\n      {}{}{}\n", first, p.help, domain_of(p),
                        p.default_value.empty() ? "" : "; default " + shell_quoted(p.default_value),
                        p.instead_of.empty() ? "" : "; instead of --" + hyphened(p.instead_of));
  }
  return text;
}

std::string_view standing_of(Standing standing) {
  constexpr std::string_view names[] = {"", "taught", "fast", "faulty"};
  return names[static_cast<std::size_t>(standing)];
}

std::string methods_of(const TopicEntry& topic) {
  std::string text;
  for (const Method& method : topic.methods) {
    const std::vector<std::string> marks = marks_of(method, topic);
    text += fmt::format("  --method {}{}\n      {}{}\n", method.name,
                        marks.empty() ? "" : fmt::format(" ({})", fmt::join(marks, ", ")), method.title,
                        method.note.empty() ? "" : ": " + method.note);
  }
  return text;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// A line each, indented.
std::string lines_of(const std::vector<std::string>& examples) {
  std::string text;
  for (const std::string& example : examples) text += "  " + example + "\n";
  return text;
}

}  // namespace

std::vector<std::string> marks_of(const Method& method, const TopicEntry& topic) {
  std::vector<std::string> marks;
  if (method.name == topic.default_method) marks.emplace_back("default");
  if (const auto standing = standing_of(method.standing); !standing.empty()) marks.emplace_back(standing);
  return marks;
}

std::vector<std::string> examples_of(const Command& command, const TopicEntry* topic) {
  if (!topic && !catalogue().empty()) topic = catalogue()[0];
  std::vector<std::string> examples;
  for (const std::string& example : command.examples) {
    examples.push_back(
        topic ? replaced(replaced(example, "TOPIC", topic->name), "NAME", topic->default_method) : example);
  }
  return examples;
}

std::vector<std::string> examples_of(const TopicEntry& topic) {
  std::vector<std::string> examples;
  for (const std::string& example : topic.examples)
    examples.push_back(fmt::format("gradus run {} {}", topic.name, example));
  if (!topic.examples.empty())
    examples.push_back(fmt::format("gradus figure {0} {1} -o {0}.svg", topic.name, topic.examples[0]));
  return examples;
}

std::string symbols_text(const TopicEntry& topic) {
  const std::vector<std::string> symbols = topic_symbols(topic.name);
  if (symbols.empty()) return "none that --label could rename";
  return fmt::format("{} (your own name for one: --label {})", fmt::join(symbols, ", "),
                     shell_quoted(symbols.front() + "=TEXT"));
}

std::vector<std::string> first_examples() {
  std::vector<std::string> examples{"gradus list", "gradus figures -o out/"};
  if (!catalogue().empty()) {
    const TopicEntry& topic = *catalogue()[0];
    const std::string arguments = topic.examples.empty() ? "" : " " + topic.examples[0];
    examples.push_back(fmt::format("gradus run {}{}", topic.name, arguments));
    examples.push_back(fmt::format("gradus figure {0}{1} -o {0}.svg", topic.name, arguments));
  }
  examples.emplace_back("gradus render letter_f.obj -o f.png");
  return examples;
}

namespace {

std::string topic_help(const TopicEntry& topic, bool color) {
  std::string text = fmt::format("{}: {}\n", bold(topic.title, color), topic.summary);
  text += section("Examples", color) + lines_of(examples_of(topic));
  text += section("Inputs", color) + inputs_of(topic);
  text += section("Methods", color) + methods_of(topic);
  text += section("Symbols", color) + "  " + symbols_text(topic) + "\n";
  if (!topic.aliases.empty())
    text += section("Also called", color) + fmt::format("  {}\n", fmt::join(topic.aliases, ", "));
  return text;
}

std::string command_help(const Command& command, const TopicEntry* topic, bool color) {
  std::string text = fmt::format("{}: {}\n", bold("gradus " + command.name, color), command.summary);
  text += section("Examples", color) + lines_of(examples_of(command, topic));
  if (topic)
    text += section("Inputs", color) + inputs_of(*topic) + section("Methods", color) + methods_of(*topic);
  if (command.about_topic && !topic) text += "\nThe inputs of a topic are flags too: gradus help TOPIC\n";
  std::vector<Flag> flags = command.flags;
  flags.insert(flags.end(), common_flags().begin(), common_flags().end());
  text += section("Flags", color) + flag_table(flags);
  if (!command.limits.empty()) text += section("Limits", color);
  for (const std::string& limit : command.limits) text += "  " + limit + "\n";
  return text;
}

std::string overview(bool color) {
  std::string text{introduction};
  text += section("Examples", color) + lines_of(first_examples());
  text += section("Commands", color);
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Command& command : commands()) rows.emplace_back(command.name, command.summary);
  text += columns(rows) + section("Flags of every command", color) + flag_table(common_flags());
  text +=
      "\nNames may be shortened; hyphens and underscores are the same. `gradus COMMAND --help` tells more.\n"
      "Exit codes: 0 done, 1 the work failed, 2 the input is wrong, 130 stopped by Ctrl-C.\n"
      "gradus is under the MIT licence; the figures it makes are CC0 1.0.\n";
  return text;
}

/// A command by its whole name; else a topic, and the beginning of a command's name if it is no topic's.
std::string help_on(const std::string& word, bool color) {
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(command.name);
  const auto exact = std::ranges::find(names, folded(word));
  if (exact != names.end()) {
    return command_help(commands()[static_cast<std::size_t>(exact - names.begin())], nullptr, color);
  }
  try {
    return topic_help(find_topic(word), color);
  } catch (const UsageError&) {
    const auto matches = matching_names(word, names);
    if (matches.size() != 1) throw;
    return command_help(commands()[matches.front()], nullptr, color);
  }
}

/// The version of a shared library that is always loaded, as it says.
template <class... Nothing>
std::string loaded_version(const char* function, Nothing... nothing) {
  void* found = dlsym(RTLD_DEFAULT, function);
  return found ? reinterpret_cast<const char* (*)(Nothing...)>(found)(nothing...) : "unknown";
}

}  // namespace

int help(const Request& request) {
  const bool color = use_color(request.color(), Stream::out);
  std::string text;
  if (request.command && request.command->name != "help") {
    text = command_help(*request.command, request.topic, color);
  } else if (!request.operands.empty()) {
    text = help_on(request.operands[0], color);
  } else {
    text = overview(color);
  }
  write_stream(Stream::out, wrapped(text, request.width()));
  return 0;
}

int version() {
#if defined(__clang__)
  constexpr std::string_view compiler = "compiled by";
#else
  constexpr std::string_view compiler = "compiled by GCC";
#endif
  // Asked of the libraries themselves, whose headers belong to other folders
  const std::string zlib = loaded_version("zlibVersion"),
                    png = loaded_version<const void*>("png_get_libpng_ver", nullptr);
  write_stream(Stream::out,
               fmt::format("gradus {}\ncairo {}, pango {}, libpng {}, zlib {}, fmt {}.{}.{}, GLM "
                           "{}.{}.{}.{}, CLI11 {}; {} {}\n",
                           release_version, cairo_version(), pango_version(), png, zlib, FMT_VERSION / 10000,
                           FMT_VERSION / 100 % 100, FMT_VERSION % 100, GLM_VERSION_MAJOR, GLM_VERSION_MINOR,
                           GLM_VERSION_PATCH, GLM_VERSION_REVISION, cli11_version(), compiler, __VERSION__));
  return 0;
}

}  // namespace gradus::cli
