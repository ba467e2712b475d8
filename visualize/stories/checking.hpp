#pragma once
// What a topic knows of others' answers besides its own run: which of two answers are as good, what follows
// from a step, how conventions differ. A topic that says nothing is judged by its run alone.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stories/topic.hpp"

namespace gradus {

/// The values of a step, ours or somebody's, by their names.
using Values = std::vector<Field>;

/// The value of that name, or nullptr.
inline const Value* value_of(const Values& values, std::string_view name) {
  for (const Field& field : values) {
    if (field.name == name) return &field.value;
  }
  return nullptr;
}
/// The same where it is of that kind; a whole number is a real one, too, and a real one may be whole.
template <class T>
std::optional<T> value_as(const Values& values, std::string_view name) {
  const Value* value = value_of(values, name);
  if (!value) return std::nullopt;
  if (const T* same = std::get_if<T>(value)) return *same;
  if constexpr (std::is_same_v<T, double>) {
    if (const auto* whole = std::get_if<std::int64_t>(value)) return static_cast<double>(*whole);
  }
  return std::nullopt;
}

/// Which lists are the same answer as ours: a rule that each list of a topic states.
enum class SameList : std::uint8_t {
  set,       ///< of the same elements, in any order, some of them more than once
  segments,  ///< the same of pairs of points, each from either end
  ring,  ///< an outline: from any corner on, either way round, corners again behind themselves, closed or not
  order,  ///< of the same elements in the same places: the order is the answer
};

/// A list that answers may have: an element for each step of a type; without a type, one for each place in
/// the result, whose fields are called "A.x" and "A.y".
struct Asked {
  std::string name;  ///< "covered"
  SameList same;
  std::string type{};               ///< of the steps: "Tested"
  std::vector<std::string> fields;  ///< of each; "key": what the step is about
  std::string where{};              ///< a fact that is true of them; empty: all
  std::string method{};             ///< that has the list; empty: each
};

/// In the place of a type of steps: the pixels that a run plots.
inline constexpr std::string_view plotted = "plotted pixels";
inline Asked pixels_that_are(SameList same) {
  return {.name = "pixels", .same = same, .type = std::string(plotted), .fields = {"pixel"}};
}

/// A way to choose between two cells that are as near.
struct TieRule {
  std::string name;  ///< "larger"
  bool (*takes)(const Arguments& arguments, ivec2 one, ivec2 other);
};

/// Whether a step follows from the one before by the topic's rule.
enum class Follows : std::uint8_t { untold, yes, no };

/// Somebody's steps, each with the step of ours that it stands for.
struct OwnSteps {
  const Arguments& arguments;
  std::span<const Values> theirs;
  std::span<const TraceStep* const> ours;  ///< as many
  double tolerance;                        ///< how far real numbers may lie apart
};

struct Checking {
  std::vector<Asked> asked{};
  /// Whether this step's decision might as well have gone the other way. Without it, none is known to.
  bool (*is_tie)(const TraceStep& step) = nullptr;
  /// Whether two different cells are equally near to what is drawn, so that either is right.
  bool (*as_near)(const Arguments& arguments, ivec2 one, ivec2 other) = nullptr;
  std::vector<TieRule> tie_rules{};  ///< ours first
  /// Whether step i, 1 or later, follows from theirs before it, right or wrong as those are.
  Follows (*follows)(const OwnSteps& steps, std::size_t i) = nullptr;
  /// How many of these cells, from the first on, the rule can give from some value of its variable.
  std::size_t (*goes_on)(const Arguments& arguments, std::span<const ivec2> cells) = nullptr;
  std::string bits{};                 ///< what each digit of a code stands for: "TBRL"
  std::vector<std::string> codes{};   ///< the values that are such codes
  std::vector<std::string> matrix{};  ///< the values that are a matrix, row by row, for column vectors
  std::size_t matrix_columns = 0;
};

}  // namespace gradus
