#pragma once
// Ear clipping that takes care of its triangles: of all ears the one whose smallest angle is the largest.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "modeling/ear_clipping/ear_clipping.hpp"

namespace gradus::ear_clipping {

/// The square of the sine of a triangle's smallest angle: 3/4 where all sides are equal, 0 without an area.
/// It needs no root, so that rationals have it, too.
/// Domain: finite, of any size.
template <class T>
T least_sine_squared(glm::vec<2, T> a, glm::vec<2, T> b, glm::vec<2, T> c) {
  const auto size = [](const T& x) { return x < T(0) ? -x : x; };
  // Halves of sides, for whole ones may be too long for a double
  const T half(0.5);
  std::array<glm::vec<2, T>, 3> sides{half * b - half * a, half * c - half * b, half * a - half * c};
  T largest(0);
  for (const auto& side : sides) largest = std::max({largest, size(side.x), size(side.y)});
  if (!(largest > T(0))) return T(0);
  std::array<T, 3> squares;
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = {sides[i].x / largest, sides[i].y / largest};
    squares[i] = sides[i].x * sides[i].x + sides[i].y * sides[i].y;
  }
  std::ranges::sort(squares);
  const T area = sides[0].x * sides[1].y - sides[0].y * sides[1].x;
  return area / squares[2] * area / squares[1];
}

/// The corners that are left, each as it was tested last.
using Judged = std::map<int, Tested>;

/// The ear whose smallest angle is the largest, of equal ones the first corner's; none where no corner is an
/// ear.
template <class T>
std::optional<int> widest_of(std::span<const glm::vec<2, T>> polygon, const Judged& judged) {
  const auto at = [&polygon](int i) { return polygon[static_cast<std::size_t>(i)]; };
  std::optional<int> widest;
  T most(0);
  for (const auto& [corner, tested] : judged) {
    if (!tested.ear) continue;
    const T sine = least_sine_squared(at(tested.before), at(corner), at(tested.after));
    if (widest && !(sine > most)) continue;
    widest = corner;
    most = sine;
  }
  return widest;
}

inline std::vector<int> all_corners(int n) {
  std::vector<int> corners(static_cast<std::size_t>(n));
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

/// Strikes an ear off. Which corners may have become ears, or be no more: its neighbours, and those in whose
/// triangles it was found.
inline std::vector<int> without(Judged& judged, const Triangle& ear) {
  judged.erase(ear[1]);
  std::vector<int> changed{ear[0], ear[2]};
  for (const auto& [corner, tested] : judged) {
    if (tested.blocker == ear[1] && corner != ear[0] && corner != ear[2]) changed.push_back(corner);
  }
  return changed;
}

/// Cuts a polygon of the plane into triangles as triangulate does, but from among all ears it takes the one
/// whose smallest angle is the largest, so that slivers come last, if at all. What was tested is kept: after
/// a cut only its two neighbours, and corners that waited for it, are tested again. Source: D. Eberly,
/// Triangulation by ear clipping, Geometric Tools, 1998-2015, for the kept ears; which of them is cut is left
/// open there.
///
/// P, emit: as for triangulate.
///
/// Domain, Errors: as triangulate.
/// Steps: (Tested+ Cut)* Finished.
/// Accuracy: the tests are exact, so that the triangles cover a simple polygon exactly once; which of two
/// ears
///   with nearly equal angles is cut, rounding decides.
/// Cost: O(n^2) usually, O(n^3) at worst.
template <class T, std::invocable<const Triangle&> Emit, Observer<Tested, Cut, Finished> O = Unobserved>
void widest_ear(std::span<const glm::vec<2, T>> P, Emit&& emit, O&& observer = {}) {
  expect_polygon(P);
  const int n = int(P.size());
  Ring ring(n);
  Judged known;
  auto open = all_corners(n);
  while (ring.size() > 2) {
    // Test what may have changed
    for (int i : open) {
      auto v = judge(P, ring, i);
      if constexpr (observed<O>) observer(v);
      known[i] = v;
    }
    // Of all ears the widest
    auto best = widest_of(P, known);
    // None at all: another one
    if (!best) {
      best = forced(P, ring);
    }
    // Cut it off
    auto ear = ring.triangle(*best);
    emit(ear);
    ring.remove(*best);
    if constexpr (observed<O>) observer(Cut{ear, ring.size(), !known[*best].ear});
    open = without(known, ear);
  }
  if constexpr (observed<O>) observer(Finished{n - 2});
}

/// For corners in a vector, an array or braces, whose numbers are doubles.
template <OtherPointRow<2> Points = PointsInBraces<2>, class Emit, class... Observed>
void widest_ear(const Points& polygon, Emit&& emit, Observed&&... observer) {
  widest_ear(span_of(polygon), emit, std::forward<Observed>(observer)...);
}

}  // namespace gradus::ear_clipping
