#pragma once
// The part of a circle that a window shows, as decision_parameter plots it: found by jumping to the pixel
// where each octant enters, however large the circle is.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

namespace gradus::bresenham_circle {

// --- Any place of an octant, without the ones before it ----------

/// The first column whose pixel is at this height or lower: the inverse of height_at. 0 when
/// all are, radius + 1 when none is.
constexpr Whole first_at_most(int radius, Whole height) {
  if (height >= radius) return 0;
  if (height < 0) return Whole{radius} + 1;
  const Whole squared = Whole{radius} * radius - height * (height + 1);
  const Whole root = square_root(squared);
  return root + (root * root < squared);
}

/// The value of p that the test at (x, y) reads. Domain: (x, y) is less than a pixel off the circle.
constexpr Whole decision_at(int radius, Whole x, Whole y) {
  const Whole outside = x * x + y * y - Whole{radius} * radius;
  return 2 * (outside + 2 * x - y) + 3;
}

// --- The part in a window ----------------------------------------

/// How far a window reaches from the centre in one of the four directions of an axis, in pixels.
constexpr Stretch reach(const Window& window, ivec2 center, ivec2 direction) {
  const int axis = direction.x == 0 ? 1 : 0;
  const Whole lower = Whole{window.lower[axis]} - center[axis];
  const Whole upper = Whole{window.upper[axis]} - center[axis];
  return direction[axis] > 0 ? Stretch{lower, upper} : Stretch{-upper, -lower};
}

/// The columns of one octant that lie in a window: always one unbroken stretch, for an octant goes one way in
/// x and in y. Cost: two square roots, and those of columns_of.
constexpr Stretch visible_columns(ivec2 center, int radius, const Octant& octant, const Window& window) {
  const Stretch own = columns_of(radius, octant);
  const Stretch x = reach(window, center, octant.right), y = reach(window, center, octant.up);
  return {std::max({own.first, x.first, first_at_most(radius, y.last)}),
          std::min({own.last, x.last, first_at_most(radius, y.first - 1) - 1})};
}

/// A part of an octant.
struct Arc {
  Octant octant;
  Stretch shown;  ///< its columns
  Circle<int> circle;

  constexpr ivec2 pixel(Whole x, Whole y) const { return pixel_of(circle.centre, octant, x, y); }
  constexpr Whole height(Whole x) const { return height_at(circle.radius, x); }
  constexpr Whole decision(Whole x, Whole y) const { return decision_at(circle.radius, x, y); }
};

/// What a window shows of a circle, octant by octant.
///
/// Domain: radius >= 0; an empty window, or an octant that misses it, gives an empty stretch.
/// Accuracy: exact, for all int32 centres and windows and every radius.
/// Cost: O(1), about 40 square roots.
constexpr std::array<Arc, 8> visible(const Circle<int>& circle, const Window& window) {
  const auto& [center, radius] = circle;
  std::array<Arc, 8> arcs{};
  for (std::size_t i = 0; i < octants.size(); ++i) {
    const Octant& octant = octants[i];
    arcs[i] = {octant, window.empty() ? Stretch{} : visible_columns(center, radius, octant, window), circle};
  }
  return arcs;
}

/// An octant is known to enter the window in column shown.first and to leave it after shown.last.
struct Jumped {
  Octant octant;
  Stretch shown;
  ivec2 at;  ///< the first place in the window, about to be plotted
  Whole p;   ///< the value for the next test
};

/// Counts the pixels of all octants.
struct PixelsShown {
  Whole count = 0;

  template <class Step>
  constexpr Step operator()(const Step& step) const {
    return step;
  }
  constexpr Jumped operator()(const Jumped& step) {
    count += step.shown.count();
    return step;
  }
  constexpr Finished operator()(Finished) const { return {count}; }
};

/// Draws the part of a circle that lies in a window: the very pixels that decision_parameter plots there, or
/// would plot on a larger plane, found by jumping to the first one of each octant.
///
/// center, radius: any int32 centre, 0 to 2^31 - 1. window: any, both corners included;
///   nothing outside it is ever plotted. Pixels come octant by octant, clockwise from (0, radius),
///   each from its axis to its diagonal.
///
/// Domain: radius >= 0; a circle that misses the window plots nothing, be it all outside or all inside.
/// Steps: Started (Jumped (Compared Stepped)*)* Finished; Jumped once for every octant that shows any pixel.
/// Accuracy: exact. Each pixel once.
/// Cost: O(window width + height), however large the circle; at most 50 square roots.
/// Errors: ContractViolation outside the domain.
template <class Plot, Observer<Started, Jumped, Compared, Stepped, Finished> O = Unobserved>
constexpr void in_window(ivec2 center, int radius, const Window& window, Plot&& plot, O&& observer = {}) {
  expects(radius >= 0, "a circle has a radius of 0 or more, not {}", radius);
  const Circle c{center, radius};
  Tally<O, PixelsShown> tally(observer);
  if constexpr (observed<O>) observer(Started{center, radius, 3 - 2 * Whole{radius}});
  auto arcs = visible(c, window);
  for (const Arc& arc : arcs) {
    const Stretch shown = arc.shown;
    if (shown.empty()) continue;
    // Jump to its first pixel shown
    Whole x = shown.first;
    Whole y = arc.height(x);
    Whole p = arc.decision(x, y);
    if constexpr (observed<O>) observer(tally.count(Jumped{arc.octant, shown, place(x, y), p}));
    plot(arc.pixel(x, y));
    while (x < shown.last) {
      if (p < 0) {
        if constexpr (observed<O>) observer(Compared{place(x, y), p, true});
        p += 4 * x + 6;
        ++x;  // E
        if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * x - 2, p, true});
      } else {
        if constexpr (observed<O>) observer(Compared{place(x, y), p, false});
        p += 4 * (x - y) + 10;
        ++x;
        --y;  // SE
        if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * (x - y) - 2, p, false});
      }
      plot(arc.pixel(x, y));
    }
  }
  if constexpr (observed<O>) observer(tally.count(Finished{}));
}

}  // namespace gradus::bresenham_circle
