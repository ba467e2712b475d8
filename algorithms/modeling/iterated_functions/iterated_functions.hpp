#pragma once
// Iterated functions: several maps that contract, applied again and again, leave one figure, their attractor,
// whatever they began with: all pieces level by level, or one point that is moved at random.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <numeric>
#include <span>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/random.hpp"

namespace gradus::iterated_functions {

using Index = std::size_t;
using Whole = std::int64_t;

template <std::floating_point T>
using Point = glm::vec<2, T>;

/// (x, y) goes to (a x + b y + e, c x + d y + f). Where a map lays the first shape is a piece: one is applied
/// to a point as well as to a piece.
template <std::floating_point T>
struct Map {
  T a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  constexpr Point<T> operator()(Point<T> p) const { return {a * p.x + b * p.y + e, c * p.x + d * p.y + f}; }
  constexpr Map operator()(const Map& p) const {
    const Point<T> at = (*this)(Point<T>{p.e, p.f});
    return {a * p.a + b * p.c, a * p.b + b * p.d, c * p.a + d * p.c, c * p.b + d * p.d, at.x, at.y};
  }
  friend constexpr bool operator==(const Map&, const Map&) = default;
};

template <std::floating_point T>
using Maps = std::span<const Map<T>>;
template <std::floating_point T>
using Pieces = std::vector<Map<T>>;

/// As many pieces as one may ask for.
inline constexpr Whole most_pieces = Whole{1} << 22;

// --- Steps -------------------------------------------------------

/// A map was applied to a piece.
template <class T>
struct Mapped {
  int level;         ///< of the image, from 1 on
  Index piece, map;  ///< of the level before, and which map, from 0 on
  Map<T> from, image;
};

/// All maps were applied to all pieces of a level.
struct LevelDone {
  int level;
  Whole pieces;
  double largest;  ///< the largest number by which a piece stretches the first shape
};

struct Finished {
  Whole pieces;
};

/// The point was moved by a map.
template <class T>
struct Moved {
  Whole move;  ///< from 1 on
  Index map;   ///< from 0 on
  Point<T> to;
  bool plotted;
};

struct GameFinished {
  Whole moves;
};

// --- Contractions ------------------------------------------------

/// By how much a map stretches lengths at most: its largest singular value.
///
/// Domain: numbers up to 2^1000 in size. Accuracy: 8 u and two of the smallest subnormal numbers.
template <std::floating_point T>
T stretch(const Map<T>& m) {
  // A turn with a scale, and a mirror image with one: their sizes add up where both agree
  return length_of(Point<T>{m.a + m.d, m.c - m.b}) / 2 + length_of(Point<T>{m.a - m.d, m.b + m.c}) / 2;
}

/// Whether a map makes all lengths smaller. Both eigenvalues of its matrix times the transposed one are below
/// 1 where their sum is below 2 and (1 - one)(1 - other) is above 0.
///
/// Domain: finite numbers. Accuracy: decided exactly.
template <std::floating_point T>
bool contracts(const Map<T>& m) {
  const double a = m.a, b = m.b, c = m.c, d = m.d;
  SumOfProducts<2> missing;
  missing.add(2.0);
  SumOfProducts<4> product;
  product.add(1.0);
  for (const double x : {a, b, c, d}) {
    missing.subtract(x, x);
    product.subtract(x, x);
  }
  product.add(a, a, d, d);
  product.add(b, b, c, c);
  product.subtract(a, b, c, d);
  product.subtract(a, b, c, d);
  return missing.sign() > 0 && product.sign() > 0;
}

/// A number c by which maps that contract stretch lengths at most, rounded up; 1 where it is no longer told
/// from 1, and then nothing is known of how fast they come to the attractor.
template <std::floating_point T>
double contraction(Maps<T> maps) {
  constexpr double above = 1 + 16 * 0x1p-53;
  double most = 0;
  for (const Map<T>& f : maps) most = std::max(most, stretch(Map<double>{f.a, f.b, f.c, f.d, 0, 0}));
  return std::min(most * above + 0x1p-1074, 1.0);
}

/// How far a shape is at most from the attractor, each point of either from the other: by the collage
/// theorem the longest way from a corner to its image, over 1 - c. What is convex is longest at a corner.
/// Source: M. F. Barnsley, Fractals everywhere, 1988, section III.10.
///
/// Accuracy: some ten roundings; infinite where c is 1.
template <std::floating_point T>
double reach(Maps<T> maps, std::span<const Point<T>> corners, double c) {
  double most = 0;
  for (const Map<T>& f : maps)
    for (const Point<T> p : corners) most = std::max(most, double{length_of(f(p) - p)});
  return most / (1 - c);
}

/// After how many moves c^k far is within: what is skipped before points are plotted.
///
/// Domain: 0 <= c < 1, within > 0; at most 2^20 moves.
inline Whole moves_until(double within, double far, double c) {
  constexpr Whole most = Whole{1} << 20;
  expects(0 <= c && c < 1 && within > 0, "a contraction below 1 and a distance above 0, not {} and {}", c,
          within);
  Whole moves = 0;
  for (; far > within; far *= c) {
    ++moves;
    expects(moves <= most, "more than 2^20 moves until a point is within {}", within);
  }
  return moves;
}

template <std::floating_point T>
void expect_maps(Maps<T> maps) {
  expects(!maps.empty(), "one map or more");
  for (Index i = 0; i < maps.size(); ++i) {
    const auto [a, b, c, d, e, f] = maps[i];
    for (const T x : {a, b, c, d, e, f}) expects(std::isfinite(x), "finite numbers in map {}", i + 1);
    expects(contracts(maps[i]), "map {} does not contract: it stretches lengths by {}", i + 1,
            stretch(maps[i]));
  }
}

template <std::floating_point T>
void expect_levels(Maps<T> maps, int levels) {
  constexpr int most_levels = 22;
  expects(0 <= levels && levels <= most_levels, "at most {} levels, not {}", most_levels, levels);
  Whole pieces = 1;
  for (int k = 0; k < levels; ++k) {
    pieces *= std::ssize(maps);
    expects(pieces <= most_pieces, "at most 2^22 pieces in the end, not {} levels of {} maps", levels,
            maps.size());
  }
}

/// What the observer is told of an image, the last of `next`.
template <class T>
Mapped<T> mapped(int level, const Pieces<T>& pieces, const Map<T>& p, Maps<T> maps, const Map<T>& f,
                 const Pieces<T>& next) {
  return {level, static_cast<Index>(&p - pieces.data()), static_cast<Index>(&f - maps.data()), p,
          next.back()};
}
template <class T>
double largest_stretch(const Pieces<T>& pieces) {
  T most = 0;
  for (const Map<T>& p : pieces) most = std::max(most, stretch(p));
  return most;
}

// --- The taught method -------------------------------------------

/// Applies every map to every piece, level after level: the pieces come to the attractor, whatever shape they
/// are of. Returns where those of the last level lie, each as a map of the first shape.
/// Source: J. E. Hutchinson, Fractals and self similarity, 1981; M. F. Barnsley, Fractals everywhere, 1988.
///
/// maps: the functions. levels: how often they are applied.
///
/// Domain: one map or more, all of finite numbers and contracting; 0 <= levels <= 22; at most 2^22 pieces.
/// Steps: (Mapped for each piece and map, LevelDone) for each level, Finished.
/// Accuracy: a piece of level n lays a point p within 6 n u (|p| + M) of its place, M the largest
///   translation of a map or piece on its way, all up to 2^1000, and 6 n of the smallest subnormal numbers.
///   Its distance to the attractor is at most c^n times that of the first shape, of which reach() is a bound.
/// Cost: 12 products and 8 sums per piece of each level.
/// Errors: ContractViolation outside the domain; it names the first map that does not contract.
template <std::floating_point T, Observer<Mapped<T>, LevelDone, Finished> O = Unobserved>
Pieces<T> deterministic(Maps<T> maps, int levels, O&& observer = {}) {
  expect_maps(maps);
  expect_levels(maps, levels);
  // The first shape, as it is
  Pieces<T> pieces{{}};
  for (int n = 0; n < levels; ++n) {
    Pieces<T> next;
    for (const auto& p : pieces) {
      for (const auto& f : maps) {
        next.push_back(f(p));
        if constexpr (observed<O>) observer(mapped(n + 1, pieces, p, maps, f, next));
      }
    }
    swap(pieces, next);
    if constexpr (observed<O>) observer(LevelDone{n + 1, std::ssize(pieces), largest_stretch(pieces)});
  }
  if constexpr (observed<O>) observer(Finished{std::ssize(pieces)});
  return pieces;
}

// --- One point at random -----------------------------------------

/// How often each map is to be drawn: as the areas of its images are, none less than one in a hundred.
/// Source: Barnsley, as above, section III.8.
template <std::floating_point T>
std::vector<double> shares_by_area(Maps<T> maps) {
  std::vector<double> shares;
  for (const Map<T>& f : maps) {
    const Map<double> m{f.a, f.b, f.c, f.d, 0, 0};
    shares.push_back(std::abs(m.a * m.d - m.b * m.c));
  }
  const double least = std::accumulate(shares.begin(), shares.end(), 0.0) / 100;
  for (double& share : shares) share = least > 0 ? std::max(share, least) : 1;
  return shares;
}

/// In whose share u lies, from 0 to 1, when all lie one behind the other.
inline Index chosen(std::span<const double> shares, double u) {
  const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
  double up_to = 0;
  for (Index i = 0; i + 1 < shares.size(); ++i) {
    up_to += shares[i];
    if (u * all < up_to) return i;
  }
  return shares.size() - 1;
}

/// Where a game begins, how many moves are made before points are plotted, how many points there are then,
/// and which random numbers.
template <std::floating_point T>
struct Game {
  Point<T> begin{0};
  Whole skip = 0, points = 10'000;
  std::uint64_t seed = 1;
};

template <std::floating_point T>
void expect_game(Maps<T> maps, std::span<const double> shares, const Game<T>& game) {
  constexpr Whole most = Whole{1} << 40;
  expect_maps(maps);
  expects(shares.size() == maps.size(), "a share for each of {} maps, not {}", maps.size(), shares.size());
  for (const double share : shares)
    expects(0 < share && share <= 0x1p1000, "shares above 0 and up to 2^1000, not {}", share);
  expects(std::isfinite(game.begin.x) && std::isfinite(game.begin.y), "a finite point to begin with");
  expects(0 <= game.skip && game.skip <= most && 0 <= game.points && game.points <= most,
          "0 to 2^40 moves, not {} and {}", game.skip, game.points);
}

/// Moves one point again and again by a map drawn at random; after the first moves it stays at the attractor
/// and comes as near to each of its points as one likes.
/// Source: M. F. Barnsley, Fractals everywhere, 1988, section III.8.
///
/// maps: the functions. shares: how often each is drawn, in proportion; see shares_by_area. game: the first
///   point, how many moves and points, the seed. plot(p) for each point.
///
/// Domain: one map or more, all of finite numbers and contracting; a share above 0 for each.
/// Steps: Moved for each move, GameFinished.
/// Accuracy: after k moves within c^k R + 6 u M / (1 - c) of the attractor, R the first point's reach() and M
///   the largest of |p|, |a translation| on the way; moves_until() says how many moves make that small.
/// Cost: a random number, 4 products and 4 sums a move, and no memory.
/// Errors: ContractViolation outside the domain; it names the first map that does not contract.
template <std::floating_point T, class Plot, Observer<Moved<T>, GameFinished> O = Unobserved>
void chaos_game(Maps<T> maps, std::span<const double> shares, const Game<T>& game, Plot&& plot,
                O&& observer = {}) {
  expect_game(maps, shares, game);
  Random random(game.seed);
  Point<T> p = game.begin;
  Whole n = game.skip + game.points;
  for (Whole k = 1; k <= n; ++k) {
    double u = random.unit();
    Index i = chosen(shares, u);
    p = maps[i](p);
    if constexpr (observed<O>) observer(Moved<T>{k, i, p, k > game.skip});
    // The first only lead there
    if (k > game.skip) plot(p);
  }
  if constexpr (observed<O>) observer(GameFinished{n});
}

// --- Known systems -----------------------------------------------

using DMap = Map<double>;

/// A triangle of three halves: W. Sierpiński, 1915.
inline constexpr std::array<DMap, 3> sierpinski{DMap{0.5, 0, 0, 0.5, 0, 0}, DMap{0.5, 0, 0, 0.5, 0.5, 0},
                                                DMap{0.5, 0, 0, 0.5, 0.25, 0.4330127018922193}};
/// A square of nine thirds without the middle one: W. Sierpiński, 1916.
inline constexpr std::array<DMap, 8> carpet = [] {
  constexpr double third = 1.0 / 3;
  std::array<DMap, 8> maps;
  Index n = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if (row != 1 || column != 1) maps[n++] = {third, 0, 0, third, column * third, row * third};
  return maps;
}();
/// Four thirds, two of them turned by 60 degrees either way: H. von Koch, 1904.
inline constexpr std::array<DMap, 4> koch = [] {
  constexpr double third = 1.0 / 3, sixth = 1.0 / 6, height = 0.28867513459481287;  // root of 3, over 6
  return std::array<DMap, 4>{DMap{third, 0, 0, third, 0, 0}, DMap{sixth, -height, height, sixth, third, 0},
                             DMap{sixth, height, -height, sixth, 0.5, height},
                             DMap{third, 0, 0, third, 2 * third, 0}};
}();
/// Two, turned by 45 and by 135 degrees, each smaller by the root of 2: J. Heighway, 1966.
inline constexpr std::array<DMap, 2> dragon{DMap{0.5, -0.5, 0.5, 0.5, 0, 0},
                                            DMap{-0.5, -0.5, 0.5, -0.5, 1, 0}};
/// Stem, all but the lowest two leaves, and those two: Barnsley, as above, table III.3, a tenth as large.
inline constexpr std::array<DMap, 4> fern{DMap{0, 0, 0, 0.16, 0, 0}, DMap{0.85, 0.04, -0.04, 0.85, 0, 0.16},
                                          DMap{0.2, -0.26, 0.23, 0.22, 0, 0.16},
                                          DMap{-0.15, 0.28, 0.26, 0.24, 0, 0.044}};

}  // namespace gradus::iterated_functions
