// The promises of Poisson discs: no two samples too near, none alone, all in their area, on paper and on
// tiles.

#include "antialiasing/poisson_disc/poisson_disc.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "antialiasing/poisson_disc/poisson_disc_batch.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::poisson_disc;

// --- An area: width, height, radius, 1 for a tile, tries, seed ---

Input area_input(Kind kind, Random& random) {
  const auto any = [&](double lower, double upper) { return random.uniform(lower, upper); };
  double width = any(0.5, 2), height = any(0.5, 2), radius = any(0.08, 0.3);
  double tries = std::floor(any(1, 12));
  const double wraps = random.unit() < 0.5;
  switch (kind) {
    case Kind::near_degenerate:  // a strip
      height = any(0.02, 0.1);
      radius = any(0.02, 0.2);
      break;
    case Kind::grazing:  // a tile of exactly two radii, or next to it
      radius = nudged(std::min(width, height) / 2, random);
      break;
    case Kind::ties:  // round numbers
      width = std::floor(any(1, 4)), height = std::floor(any(1, 4)), radius = std::ldexp(1, -2);
      break;
    case Kind::extremes:
      tries = random.unit() < 0.5 ? 1 : 40;
      radius = any(0.5, 4);  // one sample, or two
      break;
    default:
      break;
  }
  const double scale = kind == Kind::huge ? std::ldexp(1, 400) : kind == Kind::tiny ? std::ldexp(1, -400) : 1;
  Input input{width * scale, height * scale, radius * scale, wraps, tries, std::floor(any(0, 1e6))};
  if (kind == Kind::refused) {
    const double strange[] = {0, -1, std::nan(""), wrong};
    input[static_cast<std::size_t>(random.uniform_int(0, 2))] = strange[random.uniform_int(0, 3)];
  }
  return input;
}

Area area_of(const Input& i) { return {{i[0], i[1]}, i[3] != 0}; }

/// Whether it can be filled with some hundred samples; and whether it must be refused.
bool is_small(const Input& i) {
  return all_finite(i) && i[4] == std::floor(i[4]) && 1 <= i[4] && i[4] <= 100 && 0 <= i[5] &&
         i[5] < 0x1p53 && 0x1p-500 <= i[2] && i[0] / i[2] <= 40 && i[1] / i[2] <= 40 &&
         i[0] / i[2] * (i[1] / i[2]) <= 400;
}
bool is_refused(const Input& i) {
  const double shorter = std::min(i[0], i[1]), longer = std::max(i[0], i[1]);
  return !(0 < shorter && longer <= 0x1p500 && 0 < i[2] && i[2] <= 0x1p500) ||
         (i[3] != 0 && 2 * i[2] > shorter);
}

/// By how much of the radius two samples are nearer than it, in extended precision; of a tile with its
/// copies.
double too_near(const Area& area, const std::vector<dvec2>& samples, double radius) {
  long double least = radius;
  const int copies = area.wraps ? 1 : 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (int n = 0; n < 9; ++n) {
        const int x = n % 3 - 1, y = n / 3 - 1;
        if (std::max(std::abs(x), std::abs(y)) > copies) continue;
        const auto part = [&](int axis, int copy) {
          return static_cast<long double>(samples[i][axis]) - samples[k][axis] +
                 static_cast<long double>(copy) * area.size[axis];
        };
        least = std::min(least, std::hypot(part(0, x), part(1, y)));
      }
    }
  }
  return static_cast<double>((radius - least) / radius);
}

template <class Fill>
double error_of(const Input& i, Fill fill) {
  std::vector<dvec2> samples;
  const Area area = area_of(i);
  // Any number may stand for a seed; what is none counts as 0
  const std::uint64_t seed = 0 <= i[5] && i[5] < 0x1p53 ? static_cast<std::uint64_t>(i[5]) : 0;
  const auto run = [&] { fill(area, i[2], Random(seed), samples); };
  if (i.size() == 6 && !(all_finite(i) && !is_refused(i))) {
    if (!(1 <= i[4] && i[4] <= 100)) return 0;
    try {
      run();
    } catch (const ContractViolation&) {
      return 0;
    }
    return wrong;
  }
  if (!is_small(i)) return 0;
  run();
  for (const dvec2 p : samples) {
    if (!contains(area, p)) return wrong;
  }
  return samples.empty() ? wrong : too_near(area, samples, i[2]);
}

double bridson_error(const Input& i) {
  const int tries = 1 <= i[4] && i[4] <= 100 ? static_cast<int>(i[4]) : 1;
  return error_of(i, [&](const Area& area, double radius, Random random, std::vector<dvec2>& samples) {
    bridson(area, radius, tries, random, [&](dvec2 p) { samples.push_back(p); });
  });
}
double batch_error(const Input& i) {
  const int tries = 1 <= i[4] && i[4] <= 100 ? static_cast<int>(i[4]) : 1;
  return error_of(i, [&](const Area& area, double radius, Random random, std::vector<dvec2>& samples) {
    samples = bridson_batch(area, radius, tries, random);
    std::vector<dvec2> right;
    bridson(area, radius, tries, random, [&](dvec2 p) { right.push_back(p); });
    if (right != samples) samples.assign(1, dvec2(-1));
  });
}
double dart_error(const Input& i) {
  const int misses = 1 <= i[4] && i[4] <= 100 ? static_cast<int>(i[4]) : 1;
  return error_of(i, [&](const Area& area, double radius, Random random, std::vector<dvec2>& samples) {
    dart_throwing(area, radius, misses, random, [&](dvec2 p) { samples.push_back(p); });
  });
}

/// Each sample but the first has another within two radii.
double alone_error(const Input& i) {
  if (!is_small(i) || is_refused(i)) return 0;
  const Area area = area_of(i);
  std::vector<dvec2> samples;
  bridson(area, i[2], static_cast<int>(i[4]), Random(static_cast<std::uint64_t>(i[5])), [&](dvec2 p) {
    if (!samples.empty() && nearest(area, samples, p).distance() > 2 * i[2] * (1 + 1e-12))
      samples.emplace_back(-1);
    samples.push_back(p);
  });
  for (const dvec2 p : samples) {
    if (p.x < 0) return wrong;
  }
  return 0;
}

// --- A pattern: count, candidates, seed ---

Input pattern_input(Kind kind, Random& random) {
  const double count =
      kind == Kind::extremes ? std::floor(random.uniform(0, 3)) : std::floor(random.uniform(2, 40));
  return {count, std::floor(random.uniform(1, 6)), std::floor(random.uniform(0, 1e6))};
}
double pattern_error(const Input& i) {
  const auto is_whole = [](double x, double least, double most) {
    return x == std::floor(x) && least <= x && x <= most;
  };
  if (!is_whole(i[0], 0, 64) || !is_whole(i[1], 1, 8) || !is_whole(i[2], 0, 1e9)) return 0;
  std::vector<dvec2> samples(static_cast<std::size_t>(i[0]));
  const double least =
      best_candidate(samples, static_cast<int>(i[1]), Random(static_cast<std::uint64_t>(i[2])));
  for (const dvec2 p : samples) {
    if (!contains({dvec2(1)}, p)) return wrong;
  }
  if (samples.size() < 2) return least == wrong ? 0 : wrong;
  // Nearer than said, by as much of it
  return std::abs(too_near({dvec2(1), true}, samples, least));
}

}  // namespace

Domain poisson_disc() {
  const std::vector<Trap> traps{{"a tile of two radii", {1, 1, 0.5, 1, 8, 3}},
                                {"a strip thinner than the radius", {2, 0.05, 0.2, 0, 8, 1}},
                                {"one sample", {1, 1, 4, 0, 30, 1}},
                                {"one try", {1, 1, 0.1, 1, 1, 5}}};
  const std::vector kinds{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
                          Kind::ties,   Kind::extremes,        Kind::refused};
  const auto of_area = [&](std::string name, std::string states, auto error) {
    return Property{.name = std::move(name),
                    .states = std::move(states),
                    .unit = "radii",
                    .bound = 0,
                    .numbers = 6,
                    .kinds = kinds,
                    .generate = area_input,
                    .error = error,
                    .traps = traps,
                    .cases = 2000};
  };
  return {
      "poisson_disc",
      {of_area("bridson", "samples in their area, no two nearer than the radius", bridson_error),
       of_area("batch", "the samples of bridson, to the bit", batch_error),
       of_area("dart_throwing", "samples in their area, no two nearer than the radius", dart_error),
       of_area("neighbours", "each sample of bridson but the first has one within two radii", alone_error),
       {.name = "best_candidate",
        .states = "in the unit square, and as near to each other as is returned",
        .unit = "parts of it",
        .bound = 1e-12,
        .numbers = 3,
        .kinds = {Kind::random, Kind::ties, Kind::extremes},
        .generate = pattern_input,
        .error = pattern_error,
        .traps = {{"none", {0, 1, 1}}, {"one", {1, 1, 1}}},
        .cases = 2000}}};
}

}  // namespace gradus::stress
