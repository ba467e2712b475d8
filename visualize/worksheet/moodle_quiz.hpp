#pragma once
// Worksheets as questions for Moodle.

#include <functional>
#include <string>
#include <vector>

#include "worksheet/task.hpp"

namespace gradus::worksheet {

/// Bytes of a PNG for a task's drawing.
using DrawPng = std::function<std::string(const Task& task)>;

/// A file in Moodle's XML format, to be imported into a question bank: a category per topic, in it an
/// embedded answers question (Cloze) per student, the table with a field for each blank, the drawing as a
/// file of the question. Whole numbers are NUMERICAL, all else SHORTANSWER, which takes fractions as 7/12 and
/// as 0.583, numbers with point and comma, both kinds of minus, and points with and without spaces.
///
/// Moodle's marks in such a question are whole numbers: they stand to one another as the points of the rows
/// do, shared evenly by the blanks of a row; what the question counts in a quiz is said there. The drawing is
/// worth nothing here: worths should be without (see worths_of). draw: nullptr leaves drawings out.
std::string moodle_quiz(const std::vector<StudentSheet>& sheets, Reckoning reckoning, const DrawPng& draw);

/// One blank as Moodle reads it: "{2:NUMERICAL:=5}".
std::string embedded_answer(const std::string& answer, int mark);

}  // namespace gradus::worksheet
