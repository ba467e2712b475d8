// `gradus check`: judges what somebody's own program answered.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "check/judge.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/figures/panel_sheets.hpp"
#include "cli/files/files.hpp"
#include "cli/files/own_answers.hpp"
#include "request/names.hpp"
#include "request/written_json.hpp"
#include "text/wrap.hpp"

namespace gradus::cli {
namespace {

using check::Judgement;
using check::Verdict;

struct Judged {
  const check::OwnAnswer* answer;
  Arguments arguments;
  Judgement judgement;
};

std::string told_ties(const Judgement& judgement) {
  const std::string count = judgement.ties == 1 ? "1 tie goes" : fmt::format("{} ties go", judgement.ties);
  return fmt::format("{} otherwise{}{}", count, judgement.tie_rule.empty() ? "" : ": ", judgement.tie_rule);
}

/// Whether what comes behind the first difference follows from it.
std::string told_later(const Judgement& judgement) {
  if (!judgement.later_text.empty()) return judgement.later_text;
  return judgement.step ? "whether later steps follow from there is not told for this answer" : "";
}

std::string told(const Judgement& judgement) {
  std::string text(check::name_of(judgement.verdict));
  if (judgement.verdict == Verdict::other_tie) text += " (" + told_ties(judgement) + ")";
  if (judgement.verdict == Verdict::wrong && judgement.step)
    text += fmt::format(" from step {} on", *judgement.step);
  if (!judgement.what.empty()) text += ": " + judgement.what;
  if (judgement.verdict == Verdict::wrong) {
    const std::string later = told_later(judgement);
    if (!later.empty()) text += "; " + later;
    if (judgement.ties > 0) text += "; " + told_ties(judgement);
  }
  for (const std::string& hint : judgement.hints) text += "; " + hint;
  return text;
}

std::string summary(const std::vector<Judged>& all, double tolerance) {
  std::string text = counted(std::ssize(all), "answer") + ":";
  const char* separator = " ";
  for (const Verdict verdict : {Verdict::right, Verdict::other_order, Verdict::other_tie, Verdict::wrong}) {
    const auto count =
        std::ranges::count_if(all, [&](const Judged& j) { return j.judgement.verdict == verdict; });
    if (count == 0) continue;
    text += fmt::format("{}{} {}", separator, count, check::name_of(verdict));
    separator = ", ";
  }
  return text + fmt::format(" (real numbers within {} of the largest)\n", tolerance);
}

std::string lines_of(const std::vector<Judged>& all) {
  std::size_t width = 0;
  for (const Judged& one : all) width = std::max(width, one.answer->id.size());
  std::string text;
  for (const Judged& one : all)
    text += fmt::format("{:{}}  {}\n", on_one_line(one.answer->id), width, on_one_line(told(one.judgement)));
  return text;
}

JsonNode judged_node(const Judged& one) {
  const Judgement& j = one.judgement;
  constexpr const char* verdicts[] = {"right", "other_order", "other_tie", "wrong"};
  constexpr const char* follows[] = {"untold", "yes", "no"};
  std::vector<JsonMember> members{{"case", 0, json_text(one.answer->id)},
                                  {"verdict", 0, json_text(verdicts[static_cast<std::size_t>(j.verdict)])}};
  if (j.step) members.push_back({"step", 0, json_number(fmt::format("{}", *j.step))});
  if (!j.what.empty()) members.push_back({"what", 0, json_text(j.what)});
  if (j.ties > 0) {
    members.push_back({"ties", 0, json_number(fmt::format("{}", j.ties))});
    members.push_back({"tie_rule", 0, json_text(j.tie_rule)});
  }
  if (j.verdict == Verdict::wrong) {
    members.push_back({"later_follow", 0, json_text(follows[static_cast<std::size_t>(j.later)])});
    if (!j.later_text.empty()) members.push_back({"later", 0, json_text(j.later_text)});
    members.push_back({"hints", 0, json_texts(j.hints)});
  }
  return json_object(std::move(members));
}

std::string as_json(const TopicEntry& topic, const std::vector<Judged>& all, double tolerance) {
  std::vector<JsonNode> nodes;
  std::size_t wrong = 0;
  for (const Judged& one : all) {
    nodes.push_back(judged_node(one));
    wrong += one.judgement.verdict == Verdict::wrong;
  }
  const auto count = [](std::size_t n) { return json_number(fmt::format("{}", n)); };
  return write_json(json_object({{"schema", 0, count(check::check_schema)},
                                 {"topic", 0, json_text(topic.name)},
                                 {"tolerance", 0, json_number(fmt::format("{}", tolerance))},
                                 {"right", 0, count(all.size() - wrong)},
                                 {"wrong", 0, count(wrong)},
                                 {"answers", 0, json_list(std::move(nodes))}}));
}

/// "ties-1.svg"; what is no letter or digit of a name becomes "_".
std::string file_name(const std::string& id) {
  std::string name = id;
  for (char& c : name) {
    const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-';
    if (!plain) c = '_';
  }
  return name + ".svg";
}

/// The first difference of each wrong answer, beside our run.
void write_figures(const Request& request, const AskedRuns& runs, const std::vector<Judged>& all) {
  const std::string& folder = request.flags.at("output");
  make_folder(folder, "-o");
  NewFiles files;
  for (const Judged& one : all) {
    if (one.judgement.verdict != Verdict::wrong) continue;
    FigureSpec spec;
    spec.topic = request.topic;
    spec.arguments = one.arguments;
    spec.theme = &themes().front();
    set_beside(spec, runs, *one.answer);
    Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec));
    const std::string path = (std::filesystem::path(folder) / file_name(one.answer->id)).string();
    files.add(path, picture_bytes(spec, takes, shown_step(spec, takes), Format::svg),
              replaces(request.has("force")));
    if (!request.quiet()) note(shown_name(path));
  }
  files.commit();
}

}  // namespace

int check(const Request& request) {
  const TopicEntry& topic = *request.topic;
  AskedRuns runs(topic, read_own_answers(topic, request.operands.at(0), "FILE"), request.arguments);
  std::vector<Judged> all;
  for (const check::OwnAnswer& answer : runs.answers().answers) {
    Arguments arguments = runs.arguments_of(answer);
    const Trace ours = runs.run(answer, arguments);
    Judgement judgement = check::judge(runs.task(arguments, ours), runs.answers(), answer);
    all.push_back({&answer, std::move(arguments), std::move(judgement)});
  }
  const double tolerance = runs.answers().conventions.tolerance;
  if (request.has("output")) write_figures(request, runs, all);
  write_stream(Stream::out, request.has("json")
                                ? as_json(topic, all, tolerance)
                                : wrapped(lines_of(all) + summary(all, tolerance), request.width()));
  const bool wrong =
      std::ranges::any_of(all, [](const Judged& j) { return j.judgement.verdict == Verdict::wrong; });
  return wrong ? 1 : 0;
}

}  // namespace gradus::cli
