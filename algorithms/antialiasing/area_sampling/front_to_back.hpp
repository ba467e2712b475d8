#pragma once
// What is seen of many polygons in one pixel, as visible_areas tells it, in less time: what lies in front
// altogether is taken away from the pixel once, instead of from each polygon behind it.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "antialiasing/area_sampling/visible_areas.hpp"

namespace gradus::area_sampling {

/// The parts of convex pieces within a convex outline.
template <class T>
Pieces<T> parts_within(const Pieces<T>& pieces, const Outline<T>& outline) {
  Pieces<T> parts;
  for (const Outline<T>& piece : pieces) {
    Outline<T> rest = piece;
    for (std::size_t i = 0; i < outline.size() && !rest.empty(); ++i)
      rest = split_at(rest, outline, i).inside;
    if (!rest.empty()) parts.push_back(std::move(rest));
  }
  return parts;
}

/// What of a pixel is still open: all but what fragments hide that end before those at hand begin.
template <class T>
class OpenPixel {
 public:
  bool empty() const { return pieces_.empty(); }
  std::size_t size() const { return pieces_.size(); }

  void hide(const Outline<T>& outline) {
    subtract(pieces_, outline);
    whole_ = false;
  }
  /// What of an outline is open: to the bit the outline where nothing is hidden.
  Pieces<T> of(const Outline<T>& outline) const {
    return whole_ ? Pieces<T>{outline} : parts_within(pieces_, outline);
  }

 private:
  Pieces<T> pieces_{{{T{0}, T{0}}, {T{1}, T{0}}, {T{1}, T{1}}, {T{0}, T{1}}}};
  bool whole_ = true;
};

/// The same as visible_areas without an observer: front to back, until nothing of the pixel is open.
/// K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, SIGGRAPH 1977, 214-222.
///
/// fragments, seen: as for visible_areas. A callable that has cuts(std::size_t) is told before so many pieces
///   are cut at an outline, and may refuse to go on.
///
/// Domain: as visible_areas.
/// Accuracy: as visible_areas; exact in rationals.
/// Cost: sorting; for each fragment a cut of each piece that is open, and of its own pieces for each other
/// one
///   whose depths overlap its own. Pieces may be as many as the square of the fragments, where all are thin.
/// Errors: as visible_areas.
template <class T, class See>
void areas_front_to_back(std::span<Fragment<T>> fragments, See&& seen) {
  const auto tell_cuts = [&](std::size_t pieces) {
    if constexpr (requires { seen.cuts(pieces); }) seen.cuts(pieces);
  };
  expect_outlines<T>(fragments);
  sort_by_depth(fragments);
  OpenPixel<T> open;
  std::vector<const Fragment<T>*> begun;  // those before that may end behind what begins here
  for (std::size_t i = 0; i < fragments.size() && !open.empty(); ++i) {
    const Fragment<T>& mine = fragments[i];
    const T begin = mine.nearest(), end = mine.deepest();
    const auto overlaps = [&](const Fragment<T>* f) { return !(f->deepest() < begin); };
    const auto ended = std::stable_partition(begun.begin(), begun.end(), overlaps);
    for (auto f = ended; f != begun.end(); ++f) {
      tell_cuts(open.size());
      open.hide((*f)->outline);
    }
    begun.erase(ended, begun.end());

    tell_cuts(open.size());
    Pieces<T> left = open.of(mine.outline);
    const auto hide_behind = [&](const Fragment<T>& other) {
      tell_cuts(left.size());
      subtract(left, compare(other, mine).before);
    };
    for (const Fragment<T>* other : begun) {
      if (left.empty()) break;
      hide_behind(*other);
    }
    for (const Fragment<T>& other : fragments.subspan(i + 1)) {
      if (left.empty() || end < other.nearest()) break;
      hide_behind(other);
    }
    // What nothing is seen of hides nothing that others don't
    if (left.empty()) continue;
    seen(mine, left, area_of(left));
    begun.push_back(&mine);
  }
}

}  // namespace gradus::area_sampling
