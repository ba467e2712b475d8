#pragma once
// A run as an exercise: its step table with blanks, and what each row is worth.

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "figure/trace.hpp"

namespace gradus::worksheet {

/// How the numbers of a table can be had.
enum class Reckoning {
  by_hand,     ///< whole numbers of up to three digits, short fractions, up to two decimals
  calculator,  ///< up to three decimals, too, and fractions of up to three digits
};

/// Whether all numbers in a cell can be had so. Names with digits (v6), masks and region codes are none.
bool can_be_had(std::string_view cell, Reckoning reckoning);

/// A row of the step table as it is handed out.
struct ExerciseRow {
  Row cells;                ///< the answers, one per column; "" where nothing stands
  std::vector<bool> asked;  ///< a cell per column: whether it is left blank
  StepNumber step;          ///< that made the row
  /// What is decided by it, "p < 0? yes", and the kind of branch. Where no row of the run is read by a
  /// decision: what led to it.
  std::string decision{}, branch{};
  bool rounded = false;  ///< a decimal in it is not all of its value
  int blanks() const;
};

/// Beginning with the first row, which is given.
struct Exercise {
  std::shared_ptr<const Trace> trace;
  std::vector<ExerciseRow> rows;
  std::size_t rows_of_run = 0;  ///< as many has the whole run, as far as it was recorded
  StepNumber drawn_until;       ///< what the drawing shows once the last of the rows is done
  bool whole() const { return rows.size() == rows_of_run; }
  int blanks() const;
  /// What is to be filled in, as one text: two exercises that differ here have different answers.
  std::string answers() const;
};

/// The first `most` rows of a run. Given are the first row and, in the first column, names of rows that
/// `model` has, too (a counter, the names of borders); blank is every other cell with something in it.
/// most >= 2. Without a model the run is its own.
Exercise exercise_of(std::shared_ptr<const Trace> trace, std::size_t most, const Exercise* model = nullptr);

/// Whether two exercises ask for the same work: as many rows and steps, as many blanks give or take one per
/// column, the same kinds of branches, each as often give or take one. With `beginnings` what a run does
/// behind its last row here doesn't count.
bool are_alike(const Exercise& a, const Exercise& b, bool beginnings = false);

// --- Points ----------------------------------------------------------------------------------------------

/// Points in whole parts of one.
struct Points {
  int parts = 0, of_one = 2;
  friend bool operator==(const Points&, const Points&) = default;
};
/// "1", "1.5"; with a decimal comma where the language has one.
std::string text_of(Points points, const Wording& wording);

/// What the parts of an exercise are worth: each row by its blanks (the first, which is given, nothing), and
/// the drawing.
struct Worth {
  std::vector<Points> rows;
  Points drawing;
};

/// Shares out the points: each blank counts as much as another, the drawing of an exercise as much as a
/// quarter of its blanks, and the parts are whole, half or quarter points. They sum up to `halves` half
/// points exactly. Empty where that are too few for so many parts.
std::vector<Worth> worths_of(const std::vector<const Exercise*>& exercises, int halves, bool with_drawings);

/// The fewest half points that worths_of can share out.
int fewest_halves(const std::vector<const Exercise*>& exercises, bool with_drawings);

}  // namespace gradus::worksheet
