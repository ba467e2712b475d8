#pragma once
// What our own run answers, in the form in which others are asked for it.

#include <string>
#include <vector>

#include "stories/checking.hpp"

namespace gradus::check {

/// An element of a list: one value, or several that belong together.
using Element = std::vector<Value>;

/// Of a list of cells.
inline ivec2 cell_of(const Element& element) { return std::get<ivec2>(element.front()); }

struct ExpectedElement {
  Element values;
  std::int64_t step;  ///< the step that gives it
};
struct ExpectedList {
  std::string name;  ///< "pixels"
  SameList same;
  std::vector<std::string> fields;  ///< of an element
  std::vector<ExpectedElement> elements{};
  bool cells() const { return fields.size() == 1 && fields.front() == "pixel"; }
};

struct Expected {
  Values values;  ///< of the result
  std::vector<ExpectedList> lists;
  std::vector<const TraceStep*> steps;  ///< all whole ones
};

/// Of a whole run; the trace must outlive it.
Expected expected_of(const TopicEntry& topic, const Trace& trace);

/// What a step is called by: its facts, and where its key is a cell "4,2", pixel, x and y, unless it has
/// facts of those names.
Values values_of(const TraceStep& step);

/// Whether two values are the same; real numbers within a tolerance.
bool agree(const Value& a, const Value& b, double tolerance);
bool agree(const Element& a, const Element& b, double tolerance);
/// "(4, 2)", "-3", "yes".
std::string text_of(const Value& value);
std::string text_of(const Element& element);

}  // namespace gradus::check
