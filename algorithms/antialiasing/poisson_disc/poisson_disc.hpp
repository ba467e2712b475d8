#pragma once
// Samples that are random and yet nowhere crowded: any two of them are at least a radius apart. The eye's
// receptors outside the fovea lie like that, so it sees noise where a grid would show false waves.
//
// Areas reach from (0, 0) to their size. One that wraps goes on at the opposite side, as a tile does beside
// its copies: then samples keep their distance across its borders too.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "antialiasing/poisson_disc/sample_grid.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/random.hpp"

namespace gradus::poisson_disc {

// --- Steps -------------------------------------------------------

/// An area is to be filled; the grid has cells so small that each holds one sample at most.
struct Started {
  Area area;
  double radius;  ///< 0 where it is not given
  ivec2 cells;    ///< 0 where there is no grid
};

/// An active sample was chosen, beside which the next one is looked for.
struct Chosen {
  dvec2 sample;
  int active;  ///< how many there are
};

/// A place was tried.
struct Tried {
  dvec2 place;
  double nearest;   ///< distance to the nearest sample that was asked; infinite where there was none
  dvec2 neighbour;  ///< that sample
  bool inside;      ///< whether the place is in the area
  bool kept;        ///< it is a sample now
};

/// No place was found beside a sample: it is active no more.
struct Retired {
  dvec2 sample;
};

/// A candidate was compared with the best one so far.
struct Compared {
  dvec2 place;
  double nearest;   ///< distance to the nearest sample; infinite for the first one
  dvec2 neighbour;  ///< that sample
  bool best;        ///< it is farther from all of them than any before
};

/// Of several candidates the one farthest from all samples was taken.
struct Taken {
  dvec2 sample;
  double nearest;  ///< distance to the nearest sample before; infinite for the first one
  int candidates;
};

/// All is done.
struct Finished {
  int samples;
};

// --- Distances ---------------------------------------------------

/// The square that rounded squares of distances must reach, so that no two samples are nearer than the
/// radius: on the way round a tile a coordinate is off by 2^-52 of the tile's size, 2^-38 of the radius.
constexpr double safe_square(double radius) { return radius * radius * (1 + 0x1p-36); }

/// The smallest distance between any two samples, infinite for fewer than two. Cost: all pairs.
inline double least_distance(const Area& area, std::span<const dvec2> samples) {
  Nearest least;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) least.ask(area, samples[i], samples[k]);
  }
  return least.distance();
}

/// Any place of the area.
constexpr dvec2 any_in(const Area& area, Random& random) {
  const double x = random.uniform(0, area.size.x);
  return {x, random.uniform(0, area.size.y)};
}

// --- Places and samples ------------------------------------------

/// What lies between one and two radii from a sample.
struct Ring {
  Area area;
  double radius;

  /// A place there, each part of the ring equally likely; of a tile, in it.
  dvec2 at(dvec2 sample, Random& random) const {
    const double angle = random.uniform(0, 6.283185307179586);
    const double distance = radius * sqrt(1 + 3 * random.unit());
    const auto [s, c] = sin_cos(angle);
    const dvec2 place = sample + distance * dvec2(c, s);
    if (!area.wraps) return place;
    const dvec2 round = place - area.size * glm::floor(place / area.size);
    return {round.x < area.size.x ? round.x : 0, round.y < area.size.y ? round.y : 0};
  }
};

/// The number of one of the active samples, each equally likely.
constexpr std::size_t any_of(const std::vector<dvec2>& active, Random& random) {
  return static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(active.size()) - 1));
}

/// Takes a sample out of the list; the last one gets its number.
constexpr void remove(std::vector<dvec2>& active, std::size_t number) {
  active[number] = active.back();
  active.pop_back();
}

/// The sample nearest to a place.
constexpr Nearest nearest(const Area& area, std::span<const dvec2> samples, dvec2 place) {
  Nearest least;
  for (const dvec2 sample : samples) least.ask(area, place, sample);
  return least;
}

/// The unit square, whose copies fit together.
inline constexpr Area tile{dvec2(1), true};
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// The same in the tile.
constexpr Nearest nearest(std::span<const dvec2> samples, dvec2 place) {
  return nearest(tile, samples, place);
}

/// The samples of a list that come before one of it.
constexpr std::span<const dvec2> before(const dvec2& sample, std::span<const dvec2> samples) {
  return samples.first(static_cast<std::size_t>(&sample - samples.data()));
}
/// How many candidates a sample has after these: so many for each of them.
constexpr int count_of(std::span<const dvec2> before, int times) {
  return times * std::max(static_cast<int>(before.size()), 1);
}

/// The largest number of cells a side of the area is cut into.
inline constexpr int most_cells = 1 << 14;

/// What the methods with a radius take.
inline void expect_area(const Area& area, double radius) {
  const double width = area.size.x, height = area.size.y;
  expects(0 < width && width <= 0x1p500 && 0 < height && height <= 0x1p500,
          "an area has a size above 0, not {} x {}", width, height);
  expects(radius >= 0x1p-500, "a radius of at least 2^-500, whose square is not 0, not {}", radius);
  expects(radius <= 0x1p500 && std::max(width, height) * 1.5 <= radius * most_cells,
          "a radius above {} of the area's longer side, not {}", 1.5 / most_cells, radius);
  expects(!area.wraps || 2 * radius <= std::min(width, height),
          "a tile of at least two radii per side, not {} x {} with {}", width, height, radius);
}

// --- The methods -------------------------------------------------

/// Throws darts: any place that is far enough from all samples becomes one, until many in a row were not.
/// Source: R. L. Cook, Stochastic sampling in computer graphics, ACM Transactions on Graphics 5(1), 1986.
///
/// area: where. radius: the distance of any two samples, in its unit. misses: how many darts in a row must
///   miss, >= 1. plot(dvec2) is called for each sample, in their order.
///
/// Domain: as expect_area says: the radius is at least 1.5/2^14 of the longer side and 2^-500, and of a tile
///   at most half of the shorter.
/// Steps: Started Tried+ Finished.
/// Accuracy: no two samples are nearer than the radius, not even by a rounding. It leaves gaps: how many
///   darts must miss is all that ends it.
/// Cost: each dart asks the cells round it; the last gaps take most darts.
/// Errors: ContractViolation outside the domain.
template <class Plot, Observer<Started, Tried, Finished> O = Unobserved>
void dart_throwing(const Area& area, double radius, int misses, Random random, Plot&& plot,
                   O&& observer = {}) {
  expect_area(area, radius);
  expects(misses >= 1, "at least 1 dart must miss, not {}", misses);
  Grid grid(area, radius);
  auto least = safe_square(radius);
  int missed = 0;
  if constexpr (observed<O>) observer(Started{area, radius, grid.cells()});
  while (missed < misses) {
    // Anywhere
    auto p = any_in(area, random);
    // Far enough from all others?
    auto near = grid.nearest(p);
    bool kept = near.d2 >= least;
    if constexpr (observed<O>) observer(Tried{p, near.distance(), near.sample, true, kept});
    missed += 1;
    if (!kept) continue;
    grid.put(p);
    plot(p);
    missed = 0;
  }
  if constexpr (observed<O>) observer(Finished{grid.samples()});
}

/// Looks for each new sample beside one that is there, between one and two radii from it.
/// Source: R. Bridson, Fast Poisson disk sampling in arbitrary dimensions, SIGGRAPH 2007 sketches.
///
/// area, radius, plot: as for dart_throwing. k: how many places are tried beside a sample, >= 1; 30 are
///   usual.
///
/// Domain: as for dart_throwing.
/// Steps: Started (Chosen Tried+ Retired?)* Finished, before them Tried for the first sample.
/// Accuracy: no two samples are nearer than the radius, not even by a rounding. Each sample but the first has
///   another within two radii.
/// Cost: proportional to the number of samples: each is retired once, after tries that failed, and each try
///   asks some 25 cells.
/// Errors: ContractViolation outside the domain.
template <class Plot, Observer<Started, Chosen, Tried, Retired, Finished> O = Unobserved>
void bridson(const Area& area, double radius, int k, Random random, Plot&& plot, O&& observer = {}) {
  expect_area(area, radius);
  expects(k >= 1, "at least 1 try beside a sample, not {}", k);
  const Ring ring{area, radius};
  Grid grid(area, radius);
  auto least = safe_square(radius);
  std::vector<dvec2> active;
  if constexpr (observed<O>) observer(Started{area, radius, grid.cells()});
  auto keep = [&](dvec2 sample) {
    grid.put(sample);
    active.push_back(sample);
    plot(sample);
  };
  // The first one anywhere
  auto p = any_in(area, random);
  keep(p);
  if constexpr (observed<O>) observer(Tried{p, Nearest().distance(), p, true, true});
  while (!active.empty()) {
    // Any active sample
    auto i = any_of(active, random);
    const dvec2 sample = active[i];
    if constexpr (observed<O>) observer(Chosen{sample, static_cast<int>(active.size())});
    bool kept = false;
    for (int n = 0; n < k; ++n) {
      // A place in the ring
      p = ring.at(sample, random);
      bool in = contains(area, p);
      // Far enough from all others?
      auto near = grid.nearest(p);
      kept = in && near.d2 >= least;
      if constexpr (observed<O>) observer(Tried{p, near.distance(), near.sample, in, kept});
      if (!kept) continue;
      keep(p);
      break;
    }
    if (kept) continue;
    // No room beside it
    remove(active, i);
    if constexpr (observed<O>) observer(Retired{sample});
  }
  if constexpr (observed<O>) observer(Finished{grid.samples()});
}

/// Puts down exactly so many samples, each the best of several candidates: the one farthest from all samples
/// before. The unit square is a tile, so that the pattern of a pixel goes on in those beside it.
/// Source: D. P. Mitchell, Spectrally optimal sampling for distribution ray tracing, SIGGRAPH 1991.
///
/// samples: where they are put, in [0, 1) x [0, 1). times: each sample has so many times as many candidates
/// as
///   samples before it, >= 1; more make the pattern more even.
///
/// Domain: up to 4,096 samples.
/// Steps: Started (Compared+ Taken)* Finished.
/// Accuracy: promises no distance: the smallest one is returned; infinite for fewer than two samples.
/// Cost: times * n^3 / 3 distances for n samples.
/// Errors: ContractViolation outside the domain.
template <Observer<Started, Compared, Taken, Finished> O = Unobserved>
double best_candidate(std::span<dvec2> samples, int times, Random random, O&& observer = {}) {
  expects(samples.size() <= 4096, "at most 4096 samples, not {}", samples.size());
  expects(times >= 1, "at least 1 candidate per sample, not {}", times);
  double least = infinite;
  if constexpr (observed<O>) observer(Started{tile, 0, ivec2(0)});
  for (dvec2& s : samples) {
    auto old = before(s, samples);
    auto n = count_of(old, times);
    double far = -1;
    for (int k = 0; k < n; ++k) {
      // The farthest from others
      auto p = any_in(tile, random);
      auto near = nearest(old, p);
      bool better = near.d2 > far;
      if constexpr (observed<O>) observer(Compared{p, near.distance(), near.sample, better});
      if (!better) continue;
      far = near.d2;
      s = p;
    }
    least = std::min(least, far);
    if constexpr (observed<O>) observer(Taken{s, std::sqrt(far), n});
  }
  if constexpr (observed<O>) observer(Finished{static_cast<int>(samples.size())});
  return std::sqrt(least);
}

}  // namespace gradus::poisson_disc
