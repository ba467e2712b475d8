#include "cli/lecture/lecture_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {

std::string message_of(const std::exception& error) {
  const auto* argument = dynamic_cast<const ArgumentError*>(&error);
  return argument ? fmt::format("--{}: {}", argument->parameter, argument->what()) : error.what();
}

std::string flag_in(std::string_view message) {
  if (!message.starts_with("--")) return "";
  return std::string(message.substr(2, message.find_first_of(" :") - 2));
}

namespace {

/// Other flags that a message speaks of, as a lecture calls them: "--steps" -> "steps". What was found stays
/// as it is.
std::string in_words_of_lectures(std::string text) {
  std::size_t end = text.rfind(", found ");
  for (const LectureKey& key : lecture_keys()) {
    const std::string flag = " --" + hyphened(key.name);
    const std::size_t at = text.find(flag);
    if (at >= std::min(end, text.size())) continue;
    text.replace(at, flag.size(), " " + key.name);
    end = text.rfind(", found ");
  }
  return text;
}

}  // namespace

Problem problem_at(const Lecture& lecture, const Place& place, const std::string& what) {
  const std::string text = place.path.empty() ? what.substr(2) : place.path + what;
  return {place.line, fmt::format("{}:{}: {}", lecture.file, place.line, text)};
}

std::string way(const std::string& path, const std::string& key) {
  return (path.empty() ? "" : path + ".") + shown_name(key);
}

bool is_about_input(const std::exception& error) {
  return dynamic_cast<const UsageError*>(&error) || dynamic_cast<const ArgumentError*>(&error) ||
         dynamic_cast<const InputError*>(&error);
}

Problem problem_of(const Lecture& lecture, const LecturePart& part, const std::exception& error) {
  if (!is_about_input(error)) return {part.place.line, fmt::format("{}: {}", part.name, error.what())};
  const std::string message = message_of(error), flag = flag_in(message);
  if (flag.empty()) {
    const bool about_model = part.request.command->name == "render" && part.places.contains("model");
    if (!about_model) return problem_at(lecture, part.place, ": " + message);
    // The command line calls it MODEL, the model's reader by its name
    const std::string operand = "MODEL: ";
    const std::size_t start = message.starts_with(operand) ? operand.size() : 0;
    return problem_at(lecture, part.places.at("model"), ": " + message.substr(start));
  }
  const auto known = part.places.find(folded(flag));
  const Place nearby{part.place.line, way(part.place.path, folded(flag))};
  return problem_at(lecture, known == part.places.end() ? nearby : known->second,
                    in_words_of_lectures(message.substr(2 + flag.size())));
}

}  // namespace gradus::cli
