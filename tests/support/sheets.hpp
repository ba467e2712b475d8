#pragma once
// Figures laid out, and what stands on them, for tests of the layout.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "figure/figure.hpp"
#include "support/example_traces.hpp"

namespace gradus::test {

inline std::vector<const TextShape*> texts_of(const Sheet& sheet) {
  std::vector<const TextShape*> texts;
  for (const Shape& shape : sheet.shapes) {
    if (const TextShape* text = std::get_if<TextShape>(&shape.what)) texts.push_back(text);
  }
  return texts;
}

/// The text of that id, or nullptr.
inline const TextShape* find_text(const Sheet& sheet, std::string_view id) {
  for (const Shape& shape : sheet.shapes) {
    if (shape.id == id && std::holds_alternative<TextShape>(shape.what))
      return &std::get<TextShape>(shape.what);
  }
  return nullptr;
}

inline bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// No two texts of a sheet overlap. (Their boxes are measured once: that is what takes the time.)
inline void expect_texts_apart(const Sheet& sheet) {
  const auto texts = texts_of(sheet);
  std::vector<Box> boxes;
  for (const TextShape* text : texts) boxes.push_back(text->box());
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t k = i + 1; k < texts.size(); ++k) {
      if (overlap(boxes[i], boxes[k])) ADD_FAILURE() << texts[i]->text << " | " << texts[k]->text;
    }
  }
}

/// The smallest box round some points.
inline Box box_around(const std::vector<dvec2>& points) {
  const auto [left, right] = std::ranges::minmax(points, {}, &dvec2::x);
  const auto [top, bottom] = std::ranges::minmax(points, {}, &dvec2::y);
  return {left.x, top.y, right.x - left.x, bottom.y - top.y};
}

/// What a shape covers, but for the width of its strokes.
inline Box extent_of(const Shape& shape) {
  struct Extent {
    Box operator()(const RectShape& s) const { return s.box; }
    Box operator()(const AreaShape& s) const {
      std::vector<dvec2> points;
      for (const auto& ring : s.rings) points.insert(points.end(), ring.begin(), ring.end());
      return points.empty() ? Box{} : box_around(points);
    }
    Box operator()(const LineShape& s) const { return box_around(s.points); }
    Box operator()(const StrokesShape& s) const {
      std::vector<dvec2> points;
      for (const auto& [a, b] : s.segments) points.insert(points.end(), {a, b});
      return points.empty() ? Box{} : box_around(points);
    }
    Box operator()(const DiscShape& s) const {
      return {s.centre.x - s.radius, s.centre.y - s.radius, 2 * s.radius, 2 * s.radius};
    }
    Box operator()(const TextShape& s) const { return s.box(); }
    Box operator()(const ImageShape& s) const { return s.box; }
  };
  return std::visit(Extent{}, shape.what);
}

inline Box united(const Box& a, const Box& b) {
  return box_around({{a.x, a.y}, {a.right(), a.bottom()}, {b.x, b.y}, {b.right(), b.bottom()}});
}

/// Recorded once for all tests of a program.
inline const std::vector<Trace>& shared_traces() {
  static const std::vector<Trace> traces = telling_traces();
  return traces;
}

/// Calls f(trace, sheet, index) for up to `most` steps of every telling trace, evenly spread.
template <class F>
std::size_t for_each_sheet(F f, const Look& look = {}, std::size_t most = 40) {
  std::size_t count = 0;
  for (const Trace& trace : shared_traces()) {
    SCOPED_TRACE(trace.topic + " " + trace.method + " " + trace.subtitle);
    Playhead playhead(trace);
    const std::size_t stride = std::max<std::size_t>(1, (trace.steps.size() + most - 1) / most);
    for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
      SCOPED_TRACE("step " + text_of(trace.steps[i].number));
      f(trace, lay_out(figure_of(trace, playhead, trace.steps[i].number), look), i);
      ++count;
    }
  }
  return count;
}

}  // namespace gradus::test
