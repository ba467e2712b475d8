#pragma once
// Where in a pixel samples stand: rooks that attack no other, on a turned lattice.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::adaptive {

using triangle_coverage::subpixels;

/// The places of a lattice of `modulus` points: i to the right, generator·i down, both modulo the modulus.
struct Lattice {
  int modulus, generator;

  constexpr int down(int i) const { return static_cast<int>(std::int64_t{generator} * i % modulus); }
  /// The square of the least distance of two points, on a sheet that repeats.
  constexpr std::int64_t least_distance() const {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (int i = 1; i < modulus; ++i) {
      const std::int64_t x = std::min(i, modulus - i), y = std::min(down(i), modulus - down(i));
      least = std::min(least, x * x + y * y);
    }
    return least;
  }
};

/// The lattice of this many points, one in each row and column, that keeps them farthest apart.
constexpr Lattice best_lattice(int modulus) {
  Lattice best{modulus, 1};
  std::int64_t farthest = best.least_distance();
  for (int generator = 2; generator < modulus; ++generator) {
    const Lattice lattice{modulus, generator};
    if (std::gcd(generator, modulus) != 1 || lattice.least_distance() <= farthest) continue;
    best = lattice;
    farthest = lattice.least_distance();
  }
  return best;
}

/// Sample places in a pixel: n rooks that do not attack each other, so that a level or upright edge that
/// moves through the pixel changes its coverage n times, by 1/n each. They stand on a turned lattice: 4
/// are the rotated grid of graphics cards.
/// Source: P. Shirley, Discrepancy as a quality measure for sample distributions, Eurographics 1991, 183-194.
///
/// count: of samples.
///
/// Domain: 1 to 256 samples. One stands in the centre.
/// Accuracy: one sample in each of the n rows and n columns, in the middle of both, rounded down to 1/256.
/// Cost: n^2.
/// Errors: ContractViolation outside the domain.
inline std::vector<ivec2> n_rooks(int count) {
  expects(1 <= count && count <= subpixels, "a pixel takes 1 to {} rooks, not {}", subpixels, count);
  // A lattice through the origin has one point too many, or the origin is one of them
  const Lattice whole = best_lattice(count), less = best_lattice(count + 1);
  const auto apart = [](const Lattice& l) {
    return static_cast<double>(l.least_distance()) / (static_cast<double>(l.modulus) * l.modulus);
  };
  const bool leaves_origin = apart(less) >= apart(whole);
  const auto middle = [count](int i) { return (2 * i + 1) * subpixels / (2 * count); };
  std::vector<ivec2> places;
  for (int i = 0; i < count; ++i) {
    const int down = leaves_origin ? less.down(i + 1) - 1 : whole.down(i);
    places.push_back({middle(i), middle(down)});
  }
  return places;
}

}  // namespace gradus::adaptive
