// The promises of the A-buffer: masks by each sub-sample in 128 bits, shared edges, weights by the nearest
// fragment of each sub-sample, light through glass.

#include "antialiasing/a_buffer/a_buffer.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::a_buffer;
__extension__ using Wide = __int128;

constexpr double limit = 1048576.0 * 256;  // in 1/256 pixel

double whole(Random& random, double lower, double upper) {
  return std::floor(random.uniform(lower, upper + 1));
}
bool is_whole(double x, double lower, double upper) { return x == std::floor(x) && lower <= x && x <= upper; }

// --- Masks: corners in 1/256 pixel ---

double coordinate(Kind kind, Random& random) {
  switch (kind) {
    case Kind::ties:  // on sub-samples and borders of their cells
      return 16 * whole(random, -4, 20);
    case Kind::near_degenerate:
      return 128 + whole(random, -3, 3);
    case Kind::huge:
      return whole(random, -limit, limit);
    case Kind::extremes:
      return random.unit() < 0.5 ? -limit : limit;
    default:
      return whole(random, -200, 460);
  }
}
template <std::size_t count>
Input corners(Kind kind, Random& random) {
  Input input(2 * count);
  for (double& x : input) x = coordinate(random.unit() < 0.3 ? Kind::random : kind, random);
  if (kind == Kind::grazing) {  // thin: the third one beside the line of the others
    const double t = random.uniform(-0.5, 1.5);
    for (std::size_t k = 0; k < 2; ++k) input[4 + k] = std::round(input[k] + t * (input[2 + k] - input[k]));
  }
  return input;
}
bool are_corners(const Input& i) {
  return std::ranges::all_of(i, [](double x) { return is_whole(x, -limit, limit); });
}
ivec2 corner(const Input& i, std::size_t k) {
  return {static_cast<int>(i[2 * k]), static_cast<int>(i[2 * k + 1])};
}

/// On which side of the way from a to b a place lies.
Wide beside(ivec2 a, ivec2 b, ivec2 p) {
  return (Wide{b.x} - a.x) * (Wide{p.y} - a.y) - (Wide{b.y} - a.y) * (Wide{p.x} - a.x);
}
/// The same with the place moved to the right by something infinitely small, and down by something
/// infinitely smaller: never 0 unless a == b. That is the top-left rule.
int side(ivec2 a, ivec2 b, ivec2 p) {
  const Wide on = beside(a, b, p);
  if (on != 0) return on > 0 ? 1 : -1;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  return b.x > a.x ? 1 : -1;
}
Mask right_mask(ivec2 a, ivec2 b, ivec2 c) {
  Mask mask = 0;
  for (int i = 0; i < samples; ++i) {
    const ivec2 p = place_of(ivec2(0), i);
    const int first = side(a, b, p);
    if (first == side(b, c, p) && first == side(c, a, p)) mask |= bit_of(i);
  }
  return mask;
}

/// Bits that are wrong.
double mask_error(const Input& i) {
  if (!are_corners(i)) return 0;
  const ivec2 a = corner(i, 0), b = corner(i, 1), c = corner(i, 2);
  if (beside(a, b, c) == 0) return 0;
  return std::popcount(mask_of(edges_of({a, b, c}), ivec2(0)) ^ right_mask(a, b, c));
}
/// Two triangles on either side of an edge: bits that both have, and those that their quadrangle has beside.
double shared_error(const Input& i) {
  if (!are_corners(i)) return 0;
  const ivec2 a = corner(i, 0), b = corner(i, 1), c = corner(i, 2), d = corner(i, 3);
  const Wide one_side = beside(a, b, c), other_side = beside(a, b, d);
  if (one_side == 0 || other_side == 0 || (one_side > 0) == (other_side > 0)) return 0;
  const Mask one = mask_of(edges_of({a, b, c}), ivec2(0)), other = mask_of(edges_of({b, a, d}), ivec2(0));
  const std::array<ivec2, 4> ring{a, d, b, c};
  return std::popcount(one & other) + std::popcount((one | other) ^ mask_of(ring, ivec2(0)));
}

// --- Lists: a mask's two halves, a depth and an opacity for each of six fragments ---

constexpr std::size_t listed = 6;

template <bool glass>
Input list(Kind kind, Random& random) {
  Input input;
  for (std::size_t k = 0; k < listed; ++k) {
    const bool half = kind == Kind::ties;  // halves of the pixel, equal depths
    for (int n = 0; n < 2; ++n)
      input.push_back(half ? (random.unit() < 0.5 ? 0xf0f0 : 0xffff) : whole(random, 0, 65535));
    input.push_back(whole(random, 0, half ? 2 : 1000));
    input.push_back(!glass || random.unit() < 0.2 ? 1 : random.unit());
  }
  return input;
}
std::vector<Fragment> fragments_of(const Input& i) {
  std::vector<Fragment> all;
  for (std::size_t k = 0; k < listed; ++k) {
    const double *f = &i[4 * k], high = f[0], low = f[1], z = f[2], opacity = f[3];
    if (!is_whole(high, 0, 65535) || !is_whole(low, 0, 65535) || !(std::abs(z) < 1e9) || !is_share(opacity))
      return {};
    const int number = static_cast<int>(k);
    all.push_back({static_cast<Mask>(high) << 16 | static_cast<Mask>(low), z, z, opacity, number, number});
  }
  return all;
}

/// Weights against light that goes through each sub-sample for itself, in any order of the list. Opaque
/// fragments: the nearest one's, exactly.
double weights_error(const Input& i) {
  std::vector<Fragment> fragments = fragments_of(i);
  if (fragments.empty()) return 0;
  std::ranges::sort(fragments, nearer);
  std::array<long double, listed> right{};
  long double left = 0;
  for (int s = 0; s < samples; ++s) {
    long double light = 1;
    for (const Fragment& f : fragments) {
      if ((f.mask & bit_of(s)) == 0) continue;
      right[static_cast<std::size_t>(f.source)] += light * f.opacity / samples;
      light *= 1 - static_cast<long double>(f.opacity);
    }
    left += light / samples;
  }
  double worst = 0;
  for (int turn = 0; turn < 2; ++turn) {
    std::ranges::reverse(fragments);
    std::vector<Fragment> copy = fragments;
    std::array<double, listed> found{};
    const double covered =
        resolve(copy, [&](const Fragment& f, double w) { found[static_cast<std::size_t>(f.source)] = w; });
    worst = std::max(worst, std::abs(static_cast<double>(1 - left - covered)));
    for (std::size_t k = 0; k < listed; ++k)
      worst = std::max(worst, std::abs(static_cast<double>(found[k] - right[k])));
  }
  return worst;
}

}  // namespace

Domain a_buffer() {
  const std::vector kinds{Kind::random,  Kind::ties, Kind::near_degenerate,
                          Kind::grazing, Kind::huge, Kind::extremes};
  const auto lists = [](const char* name, const char* states, double bound, auto generate) {
    return Property{.name = name,
                    .states = states,
                    .unit = "of the pixel",
                    .bound = bound,
                    .numbers = 4 * listed,
                    .kinds = {Kind::random, Kind::ties},
                    .generate = generate,
                    .error = weights_error,
                    .cases = 4000};
  };
  return {"a_buffer",
          {{.name = "mask",
            .states = "each bit as 128-bit integers say",
            .unit = "bits",
            .bound = 0,
            .numbers = 6,
            .kinds = kinds,
            .generate = corners<3>,
            .error = mask_error,
            .traps = {{"corners on sub-samples", {16, 32, 144, 32, 16, 224}},
                      {"a sliver through all rows", {0, 0, 256, 255, 256, 256}},
                      {"the whole pixel", {-1000, -1000, 3000, -1000, -1000, 3000}}}},
           {.name = "shared_edges",
            .states = "triangles on either side of an edge: no bit twice, none left out",
            .unit = "bits",
            .bound = 0,
            .numbers = 8,
            .kinds = kinds,
            .generate = corners<4>,
            .error = shared_error,
            .traps = {{"along sub-samples", {16, 0, 16, 256, 0, 100, 256, 100}}}},
           lists("weights", "opaque fragments: the sub-samples of which each is the nearest", 0, list<false>),
           lists("opacity", "light through each sub-sample", 1e-13, list<true>)}};
}

}  // namespace gradus::stress
