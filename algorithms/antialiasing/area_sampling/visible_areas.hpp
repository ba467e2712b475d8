#pragma once
// What is seen of the polygons in one pixel: from each the nearer ones are subtracted, and what remains has
// an exact area. No sorting order need exist: two polygons whose depths cross each hide a part of the
// other.

#include <algorithm>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "antialiasing/area_sampling/pixel_polygon.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::area_sampling {

/// A depth that is linear in the picture; places in pixels from the pixel's upper left corner on.
template <class T>
struct Plane {
  T at_corner, per_column, per_row;

  T at(const glm::vec<2, T>& p) const { return at_corner + (per_column * p.x + per_row * p.y); }
};

/// A polygon's part in the pixel.
template <class T>
struct Fragment {
  Outline<T> outline;  ///< convex, clockwise as one sees it, from (0, 0) to (1, 1)
  Plane<T> depth;      ///< smaller is nearer
  int key;             ///< whose it is; of equal depths the smaller key is seen

  /// The least and the greatest depth, which it has at corners.
  T nearest() const {
    T least = depth.at(outline[0]);
    for (const auto& corner : outline) least = std::min(least, depth.at(corner));
    return least;
  }
  T deepest() const {
    T most = depth.at(outline[0]);
    for (const auto& corner : outline) most = std::max(most, depth.at(corner));
    return most;
  }
};

/// Several outlines that share no area.
template <class T>
using Pieces = std::vector<Outline<T>>;

// --- Steps -------------------------------------------------------

/// What is seen of this fragment is asked next.
template <class T>
struct FragmentTaken {
  Fragment<T> fragment;
};

/// The depths of another fragment were compared with those of the fragment at hand: where both parts are
/// there, the planes cross within the other one, and it is split.
template <class T>
struct Compared {
  int key, other;
  Outline<T> before;  ///< of the other one, nearer than the fragment at hand; may be empty
  Outline<T> behind;
};

/// What lies before was subtracted from what is left of the fragment at hand.
template <class T>
struct Subtracted {
  bool hides;  ///< whether that took something away
  int key, other;
  Outline<T> before;  ///< what was subtracted
  Pieces<T> left;     ///< what remains
};

/// All others were compared, or nothing is left: these pieces are seen, maybe none.
template <class T>
struct Seen {
  int key;
  Pieces<T> pieces;
  T area;
};

/// All fragments were asked.
template <class T>
struct AreasFinished {
  T covered;  ///< the sum of the areas seen
};

// --- Splitting ---------------------------------------------------

/// A convex outline on the two sides of a line; a side without area is empty.
template <class T>
struct Halves {
  Outline<T> inside, outside;
};

/// How near to a line a corner counts as on it, in pixels: rounding leaves no slivers behind.
template <class T>
constexpr T thinnest() {
  return T(0);
}
template <>
constexpr double thinnest<double>() {
  return 0x1p-50;
}

/// Splits a convex outline where a linear function changes its sign; inside is where it is positive. Both
/// sides get the same new corners, so that they fit together.
template <class T, class Height>
Halves<T> split(const Outline<T>& outline, T noise, const Height& height) {
  Halves<T> halves;
  bool has_inside = false, has_outside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::vec<2, T>&a = outline[i], &b = outline[i + 1 < outline.size() ? i + 1 : 0];
    const T at_a = height(a), at_b = height(b);
    const int is = (at_a > noise) - (at_a < -noise), will = (at_b > noise) - (at_b < -noise);
    has_inside = has_inside || is > 0;
    has_outside = has_outside || is < 0;
    if (is >= 0) halves.inside.push_back(a);
    if (is <= 0) halves.outside.push_back(a);
    if (is * will >= 0) continue;
    const T share = at_a / (at_a - at_b);
    const glm::vec<2, T> made{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    halves.inside.push_back(made);
    halves.outside.push_back(made);
  }
  if (!has_inside) halves.inside.clear();
  if (!has_outside) halves.outside.clear();
  return halves;
}

/// The parts of `other` before and behind another fragment's plane. Where both are equally deep all over, the
/// smaller key is before the other.
template <class T>
struct Sides {
  Outline<T> before, behind;
};
template <class T>
Sides<T> compare(const Fragment<T>& other, const Fragment<T>& mine) {
  const auto nearer_by = [&](const glm::vec<2, T>& p) { return mine.depth.at(p) - other.depth.at(p); };
  Halves<T> halves = split(other.outline, T{0}, nearer_by);
  const bool equal = halves.inside.empty() && halves.outside.empty();
  if (equal) (other.key < mine.key ? halves.inside : halves.outside) = other.outline;
  return {std::move(halves.inside), std::move(halves.outside)};
}

/// A convex piece on the two sides of an edge of a convex outline.
template <class T>
Halves<T> split_at(const Outline<T>& piece, const Outline<T>& outline, std::size_t edge) {
  const glm::vec<2, T>&a = outline[edge], &b = outline[edge + 1 < outline.size() ? edge + 1 : 0];
  const T wide = a.x < b.x ? b.x - a.x : a.x - b.x, high = a.y < b.y ? b.y - a.y : a.y - b.y;
  const auto within = [&](const glm::vec<2, T>& p) { return doubled_area(a, b, p); };
  return split(piece, thinnest<T>() * (wide + high), within);
}

/// What of a convex piece lies outside a convex outline, as convex pieces: along each edge in turn the
/// part outside is kept, the rest goes on. False, and nothing is kept, where they share no area.
template <class T>
bool keep_outside(const Outline<T>& piece, const Outline<T>& taken, Pieces<T>& kept) {
  const std::size_t before = kept.size();
  Outline<T> rest = piece;
  for (std::size_t i = 0; i < taken.size() && !rest.empty(); ++i) {
    Halves<T> halves = split_at(rest, taken, i);
    if (!halves.outside.empty()) kept.push_back(std::move(halves.outside));
    rest = std::move(halves.inside);
  }
  if (!rest.empty()) return true;
  kept.resize(before);
  return false;
}

/// Takes a convex outline away from the pieces; a piece that it does not meet stays whole. False where it
/// meets none.
template <class T>
bool subtract(Pieces<T>& pieces, const Outline<T>& taken) {
  if (taken.empty()) return false;
  Pieces<T> left;
  bool meets = false;
  for (Outline<T>& piece : pieces) {
    const bool split = keep_outside(piece, taken, left);
    if (!split) left.push_back(std::move(piece));
    meets = meets || split;
  }
  pieces = std::move(left);
  return meets;
}

template <class T>
T area_of(const Pieces<T>& pieces) {
  T sum(0);
  for (const Outline<T>& piece : pieces) sum = sum + area_of(piece);
  return sum;
}

/// What is left of a fragment.
template <class T>
struct Rest {
  Pieces<T> pieces;
  bool met = false;  ///< by what was subtracted last

  explicit Rest(const Fragment<T>& whole) : pieces{whole.outline} {}
  bool empty() const { return pieces.empty(); }
  void subtract(const Outline<T>& taken) { met = area_sampling::subtract(pieces, taken); }
};
template <class T>
T area_of(const Rest<T>& rest) {
  return area_of(rest.pieces);
}

/// The nearest first, by their nearest depths, then by key.
template <class T>
void sort_by_depth(std::span<Fragment<T>> fragments) {
  std::ranges::sort(fragments, [](const Fragment<T>& a, const Fragment<T>& b) {
    const T at_a = a.nearest(), at_b = b.nearest();
    return at_a < at_b || (at_a == at_b && a.key < b.key);
  });
}

/// Whether nothing of `other` lies before `mine`, nor of those after it in that order.
template <class T>
bool behind(const Fragment<T>& other, const Fragment<T>& mine) {
  return mine.deepest() < other.nearest();
}

/// What is asked of fragments.
template <class T>
void expect_outlines(std::span<const Fragment<T>> fragments) {
  for (const auto& f : fragments) expects(f.outline.size() >= 3, "an outline needs three corners");
}

// --- One pixel ---------------------------------------------------

/// What is seen of the fragments in one pixel: those before it are subtracted from each, and what remains is
/// measured. Where two cross, the part of the other one that lies before is subtracted.
/// E. Catmull, A hidden-surface algorithm with anti-aliasing, SIGGRAPH 1978, 6-11.
///
/// fragments: sorted by their nearest depth when it is done. seen(const Fragment<T>&, const Pieces<T>&, T
///   area) is called for each fragment of which something is seen, in this order.
///
/// Domain: outlines convex and clockwise as one sees them, in the pixel, with an area; finite depths. Planes
///   may cross, and three fragments may hide one another in a ring.
/// Steps: (FragmentTaken (Compared Subtracted)* Seen)* AreasFinished; Compared with each other one that is
///   not behind altogether, until nothing is left.
/// Accuracy: exact in rationals: the areas add up to that of the union. In double 1e-12 for planes that
///   differ by a thousandth of their depths at some corner of the pixel; nearer ones may change places.
/// Cost: at most n - 1 others for each of n fragments; each splits a piece at most once per edge.
/// Errors: ContractViolation for an outline of fewer than three corners.
///
/// Returns the sum of the areas that are seen.
template <class T, class See,
          Observer<FragmentTaken<T>, Compared<T>, Subtracted<T>, Seen<T>, AreasFinished<T>> O = Unobserved>
T visible_areas(std::span<Fragment<T>> fragments, See&& seen, O&& observer = {}) {
  expect_outlines<T>(fragments);
  sort_by_depth(fragments);
  T covered{0};
  for (auto& f : fragments) {
    Rest<T> rest(f);
    if constexpr (observed<O>) observer(FragmentTaken<T>{f});
    for (auto& g : fragments) {
      if (&g == &f) continue;
      // Nothing left, or all behind
      if (rest.empty()) break;
      if (behind(g, f)) break;
      // What of g lies before f?
      const auto at = compare(g, f);
      if constexpr (observed<O>) observer(Compared<T>{f.key, g.key, at.before, at.behind});
      // That hides what is behind
      rest.subtract(at.before);
      if constexpr (observed<O>) observer(Subtracted<T>{rest.met, f.key, g.key, at.before, rest.pieces});
    }
    // What is left is seen
    const T area = area_of(rest);
    if constexpr (observed<O>) observer(Seen<T>{f.key, rest.pieces, area});
    if (rest.empty()) continue;
    seen(f, rest.pieces, area);
    covered = covered + area;
  }
  if constexpr (observed<O>) observer(AreasFinished<T>{covered});
  return covered;
}

}  // namespace gradus::area_sampling
