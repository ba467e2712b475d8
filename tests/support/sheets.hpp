#pragma once
// Figures laid out, and what stands on them, for tests of the layout.

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "figure/figure.hpp"
#include "figure/layout/layout.hpp"
#include "support/example_traces.hpp"
#include "support/share.hpp"

namespace gradus::test {

/// All texts but the rims, which lie below their own.
std::vector<const TextShape*> texts_of(Sheet&& sheet) = delete;  // they would point into what is gone
inline std::vector<const TextShape*> texts_of(const Sheet& sheet) {
  std::vector<const TextShape*> texts;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (text && !text->is_rim()) texts.push_back(text);
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

/// Whether a shape of the drawing is one of its marks: no axis, grid, guide, tinted region, text or leader.
/// The borders of a window that go on and on are marks: it is they that are cut at.
inline bool is_mark(const Shape& shape) {
  if (shape.slot != Slot::drawing || shape.id.starts_with("leader ") || shape.id.starts_with("overview"))
    return false;
  if (shape.id == "colours" || shape.id.starts_with("border ")) return true;
  if (const auto* image = std::get_if<ImageShape>(&shape.what)) return image->smooth;
  if (std::holds_alternative<TextShape>(shape.what) || std::holds_alternative<AreaShape>(shape.what))
    return false;
  const std::optional<Role> role = role_of(shape);
  return role && *role != Role::guide && shape.id != "centres";
}

/// How far the marks of a figure reach on a slide, as parts of what they shall: 54 % of its width, or 90 % of
/// the height of its body. At least 1 is enough.
inline double reach_of(const Figure& figure, const Look& look) {
  std::optional<Box> marks;
  for (const Shape& shape : lay_out(figure, look).shapes) {
    if (is_mark(shape)) marks = marks ? united(*marks, extent_of(shape)) : extent_of(shape);
  }
  if (!marks) return 0;
  const layout::Page page = layout::page_of(*figure.trace, look);
  const double s = layout::unit_of(look);
  return std::max(marks->width / (0.54 * page.width * s), marks->height / (0.9 * page.middle.height * s));
}

/// Recorded once for all tests of a program.
inline const std::vector<Trace>& shared_traces() {
  static const std::vector<Trace> traces = telling_traces();
  return traces;
}

/// Calls f(figure, index) or f(figure) for up to `most` steps of every telling trace, evenly spread; an
/// ordinary run for one trace in `parts`, others in another `walk`.
template <class F>
std::size_t for_each_figure(F f, std::size_t most, std::size_t parts = 1, std::size_t walk = 0) {
  std::size_t count = 0, next = walk;
  for (const Trace& trace : shared_traces()) {
    if (!in_share(next++, parts)) continue;
    SCOPED_TRACE(trace.topic + " " + trace.method + " " + trace.subtitle);
    Playhead playhead(trace);
    const std::size_t stride = std::max<std::size_t>(1, (trace.steps.size() + most - 1) / most);
    for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
      SCOPED_TRACE("step " + text_of(trace.steps[i].number));
      const Figure figure = figure_of(trace, playhead, trace.steps[i].number);
      if constexpr (std::invocable<F, const Figure&>) {
        f(figure);
      } else {
        f(figure, i);
      }
      ++count;
    }
  }
  return count;
}

/// The same with f(trace, sheet, index), the figures laid out.
template <class F>
std::size_t for_each_sheet(F f, const Look& look = {}, std::size_t most = 40, std::size_t parts = 1,
                           std::size_t walk = 0) {
  return for_each_figure(
      [&](const Figure& figure, std::size_t i) { f(*figure.trace, lay_out(figure, look), i); },
      thinned(most, 4), parts, walk);
}

}  // namespace gradus::test
