#pragma once
// What stands on a worksheet: a student's exercises, and how they are worded.

#include <string>
#include <vector>

#include "stories/topic.hpp"
#include "worksheet/variants.hpp"

namespace gradus::worksheet {

/// One exercise of a sheet.
struct Task {
  const TopicEntry* topic = nullptr;
  const Variant* variant = nullptr;
  std::vector<const Parameter*> parameters;  ///< that it depends on
  Worth worth;                               ///< of its rows and of its drawing
  Points points() const;
};

/// The exercises of one student.
struct StudentSheet {
  std::string student;  ///< empty: a line for the name
  std::vector<Task> tasks;
};

/// The input in the words of the topic's flags, an argument each: "from 0,0".
std::vector<std::string> given_arguments(const Task& task);

/// "Fill in the table. …", and how long the run is where the table is only its beginning.
std::string filling_text(const Task& task, Reckoning reckoning);
/// "Draw into the figure …".
std::string drawing_text(const Task& task);
/// "3.5 points".
std::string points_text(Points points, const Wording& wording);
/// "____ of 3.5 points", to be filled in by who corrects it.
std::string scored_text(Points points, const Wording& wording);
/// "Task 2: Bresenham line"; the title alone where there is one task.
std::string task_title(const StudentSheet& sheet, std::size_t task);
/// "Name: Ada", or "Name:" with nothing behind.
std::string name_text(const std::string& student, const Wording& wording);

/// In whose words a task is told.
const Wording& wording_of(const Task& task);

}  // namespace gradus::worksheet
