#include "worksheet/task.hpp"

#include <fmt/format.h>

#include "stories/noted.hpp"

namespace gradus::worksheet {

using fmt::arg;

Points Task::points() const {
  Points sum{worth.drawing.parts, worth.drawing.of_one};
  for (const Points& row : worth.rows) sum.parts += row.parts;
  return sum;
}

const Wording& wording_of(const Task& task) { return task.variant->exercise.trace->wording; }

std::vector<std::string> given_arguments(const Task& task) {
  std::vector<std::string> given;
  for (const Parameter* parameter : task.parameters) {
    std::string name = parameter->name;
    for (char& c : name) c = c == '_' ? '-' : c;
    const Arguments::Entry& entry = task.variant->arguments.entry(parameter->name);
    const std::string& text =
        parameter->noted ? noted_text(entry, wording_of(task).notation().*parameter->noted) : entry.text;
    given.push_back(parameter->type == ParameterType::flag ? name : fmt::format("{} {}", name, text));
  }
  return given;
}

std::string filling_text(const Task& task, Reckoning reckoning) {
  const Wording& wording = wording_of(task);
  const Exercise& exercise = task.variant->exercise;
  std::string text = wording.say("worksheet.fill");
  if (!exercise.whole()) {
    text += " " + wording.say("worksheet.beginning", arg("rows", exercise.rows.size()));
  }
  if (reckoning == Reckoning::calculator) text += " " + wording.say("worksheet.rounded");
  return text;
}

std::string drawing_text(const Task& task) {
  return wording_of(task).say(task.variant->exercise.whole() ? "worksheet.draw" : "worksheet.draw_so_far");
}

std::string points_text(Points points, const Wording& wording) {
  const bool one = points.parts == points.of_one;
  return wording.say(one ? "worksheet.points.one" : "worksheet.points.many",
                     arg("n", text_of(points, wording)));
}

std::string scored_text(Points points, const Wording& wording) {
  const bool one = points.parts == points.of_one;
  return wording.say(one ? "worksheet.of.one" : "worksheet.of.many", arg("n", text_of(points, wording)));
}

std::string task_title(const StudentSheet& sheet, std::size_t task) {
  const Task& told = sheet.tasks[task];
  const std::string& title = told.variant->exercise.trace->title;
  if (sheet.tasks.size() == 1) return title;
  return wording_of(told).say("worksheet.task", arg("number", task + 1), arg("title", title));
}

std::string name_text(const std::string& student, const Wording& wording) {
  return wording.say("worksheet.name") + (student.empty() ? "" : " " + student);
}

}  // namespace gradus::worksheet
