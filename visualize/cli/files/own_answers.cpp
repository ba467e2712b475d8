#include "cli/files/own_answers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "check/own_run.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/files/files.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

/// The flags, and the method that the file names where they name none.
GivenTexts with_method(GivenTexts given, const check::OwnAnswers& answers) {
  if (!answers.method.empty()) given.try_emplace("method", answers.method);
  return given;
}

/// What is wrong with arguments, as the file's reader is told.
template <class Call>
auto at_line(const check::OwnAnswers& answers, const check::OwnAnswer& answer, const Call& call) {
  const auto place = fmt::format("{}:{}: {}", answers.file, answer.line, answer.id);
  try {
    return call();
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("{}: {}", place, complaint_of(error)));
  } catch (const UsageError& error) {
    throw InputError(fmt::format("{}: {}", place, error.what()));
  }
}

}  // namespace

AskedRuns::AskedRuns(const TopicEntry& topic, check::OwnAnswers answers, GivenTexts given)
    : topic_(topic),
      answers_(std::move(answers)),
      given_(with_method(std::move(given), answers_)),
      cases_(topic, given_, answers_.seed,
             [&topic](const GivenTexts& texts) { return read_inputs(topic, texts).arguments; }) {}

Arguments AskedRuns::arguments_of(const check::OwnAnswer& answer) {
  return at_line(answers_, answer, [&] {
    GivenTexts texts = given_;
    if (answer.is_case && answer.arguments.empty()) {
      read_inputs(topic_, texts);  // the method there is, before cases are drawn for it
      const auto found = cases_.find(answer.id);
      if (!found) {
        check::refuse_answer(
            answers_, answer.line, "case",
            fmt::format("one that `gradus cases {} --random-seed {}` names", topic_.name, answers_.seed),
            shown(answer.id));
      }
      texts = found->arguments;
    }
    for (const auto& [name, text] : answer.arguments) {
      const bool known = name == "method" || std::ranges::find(topic_.parameters, name, &Parameter::name) !=
                                                 topic_.parameters.end();
      if (!known)
        check::refuse_answer(answers_, answer.line, "arguments", "inputs of " + topic_.name, shown(name));
      if (!text.empty()) texts[name] = text;
    }
    return read_inputs(topic_, texts).arguments;
  });
}

Trace AskedRuns::run(const check::OwnAnswer& answer, const Arguments& arguments,
                     const Wording& wording) const {
  return at_line(answers_, answer, [&] {
    Trace trace = topic_.run(arguments, {.wording = wording});
    if (!trace.whole()) {
      check::refuse_answer(answers_, answer.line, answer.id,
                           fmt::format("a run of at most {} events", Recording::default_most),
                           "a longer one");
    }
    return trace;
  });
}

check::Task AskedRuns::task(const Arguments& arguments, const Trace& ours) const {
  const auto other_method = [this, &arguments](const std::string& method) {
    GivenTexts texts;
    for (const Arguments::Entry& entry : arguments.entries()) {
      const bool is_file = !entry.hash.empty();
      const auto known = std::ranges::find(topic_.parameters, entry.name, &Parameter::name);
      const bool usual = known != topic_.parameters.end() && known->default_value == entry.text;
      if (!is_file && !usual && !entry.text.empty()) texts[entry.name] = entry.text;
    }
    texts["method"] = method;
    return topic_.run(read_inputs(topic_, texts).arguments, {});
  };
  return {topic_, arguments, ours, other_method};
}

check::OwnAnswers read_own_answers(const TopicEntry& topic, const std::string& path, std::string_view what) {
  const std::string name = path == dash ? "standard input" : std::filesystem::path(path).filename().string();
  return check::read_answers(topic, read_input(path, what), on_one_line(name));
}

NamedAnswer named_answer(const std::string& text) {
  const std::size_t hash = text.rfind('#');
  std::error_code error;
  if (hash == std::string::npos || std::filesystem::exists(text, error)) return {text, ""};
  return {text.substr(0, hash), text.substr(hash + 1)};
}

const check::OwnAnswer& find_answer(const check::OwnAnswers& answers, const std::string& id) {
  std::vector<std::string> ids;
  for (const check::OwnAnswer& answer : answers.answers) ids.push_back(answer.id);
  if (id.empty() && ids.size() == 1) return answers.answers.front();
  const auto found = std::ranges::find(ids, id);
  if (found == ids.end()) {
    const std::vector<std::string> some(
        ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(ids.size(), 8)));
    refuse_flag("trace",
                fmt::format("{}#CASE, one of {}{}", answers.file, fmt::join(some, ", "),
                            some.size() < ids.size() ? ", …" : ""),
                id.empty() ? "none" : shown(id));
  }
  return answers.answers[static_cast<std::size_t>(found - ids.begin())];
}

void set_beside(FigureSpec& spec, const AskedRuns& runs, const check::OwnAnswer& answer) {
  const Trace ours = runs.run(answer, spec.arguments, spec.wording);
  const check::Task task = runs.task(spec.arguments, ours);
  const std::string text =
      runs.answers().answers.size() > 1 ? runs.answers().file + "#" + answer.id : runs.answers().file;
  spec.panels.reset();
  spec.compare = OtherSide{spec.topic, spec.arguments, text,
                           std::make_shared<const GivenRun>(check::own_run(task, runs.answers(), answer))};
  spec.said["trace"] = text;
}

}  // namespace gradus::cli
