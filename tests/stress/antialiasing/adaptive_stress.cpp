// The promises of adaptive antialiasing: the picture of all samples everywhere, and samples that stand like
// rooks.

#include "antialiasing/adaptive/adaptive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "stress/numbers.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::adaptive;
__extension__ using Wide = __int128;

constexpr int columns = 6, rows = 4;
constexpr Window sheet{{0, 0}, {columns - 1, rows - 1}};
constexpr std::size_t most_triangles = 3, of_triangle = 9;
constexpr double limit = double{triangle_coverage::farthest} * subpixels;

// --- Scenes: the samples, then of each triangle its corners in 1/256 pixel and its depths

double coordinate(Kind kind, Random& random) {
  switch (kind) {
    case Kind::ties:
    case Kind::grazing:
      return 32 * whole(random, -8, 8 * columns + 8);  // corners and samples of pixels
    case Kind::huge:
      return whole(random, -static_cast<std::int64_t>(limit), static_cast<std::int64_t>(limit));
    case Kind::extremes:
      return random.unit() < 0.5 ? -limit : limit;
    case Kind::tiny:
      return 384 + whole(random, -40, 40);  // within one pixel or two
    default:
      return whole(random, -800, columns * subpixels + 800);
  }
}
Input scene(Kind kind, Random& random) {
  Input input{whole(random, 1, 16)};
  for (std::size_t t = 0; t < most_triangles; ++t) {
    for (int k = 0; k < 6; ++k) input.push_back(coordinate(kind, random));
    // Few depths, so that surfaces touch and pierce
    for (int k = 0; k < 3; ++k) input.push_back(whole(random, 0, 4) / 4);
  }
  if (random.unit() < 0.4) {
    // The second one over the first, with depths of its own
    for (std::size_t k = 0; k < 6; ++k) input[1 + of_triangle + k] = input[1 + k];
  }
  if (kind == Kind::near_degenerate) {
    for (std::size_t k = 0; k < 2; ++k)
      input[1 + 4 + k] = std::round((input[1 + k] + input[3 + k]) / 2) + whole(random, -1, 1);
  }
  return input;
}
bool is_scene(const Input& i) {
  if (!is_whole(i[0], 1, 16)) return false;
  for (std::size_t k = 1; k < i.size(); ++k) {
    const bool depth = (k - 1) % of_triangle >= 6;
    if (depth ? !(0 <= i[k] && i[k] <= 1) : !is_whole(i[k], -limit, limit)) return false;
  }
  return true;
}
std::vector<ScreenTriangle> triangles_of(const Input& i) {
  std::vector<ScreenTriangle> all;
  for (std::size_t t = 0; t < most_triangles; ++t) {
    const std::size_t at = 1 + of_triangle * t;
    all.push_back({{pixel(i, at), pixel(i, at + 2), pixel(i, at + 4)}, {i[at + 6], i[at + 7], i[at + 8]}});
  }
  return all;
}

// --- The oracle: every sample by 128 bits

/// The side of the line from a to b on which a place lies that is moved to the right by something infinitely
/// small, and down by something infinitely smaller.
int side(ivec2 a, ivec2 b, ivec2 p) {
  const Wide on =
      Wide{p.x} * (Wide{a.y} - b.y) + Wide{p.y} * (Wide{b.x} - a.x) + Wide{a.x} * b.y - Wide{a.y} * b.x;
  if (on != 0) return on > 0 ? 1 : -1;
  const std::int64_t next = a.y != b.y ? std::int64_t{a.y} - b.y : std::int64_t{b.x} - a.x;
  return (next > 0) - (next < 0);
}
bool inside(const triangle_coverage::Triangle& t, ivec2 p) {
  const int a = side(t[0], t[1], p);
  return triangle_coverage::doubled_area(t) != 0 && a != 0 && a == side(t[1], t[2], p) &&
         a == side(t[2], t[0], p);
}
/// How many samples of a pixel show each triangle: the nearest that covers them.
std::array<int, most_triangles> shown(const std::vector<ScreenTriangle>& triangles, ivec2 p,
                                      const std::vector<ivec2>& places) {
  std::array<int, most_triangles> count{};
  for (const ivec2 place : places) {
    std::optional<std::size_t> front;
    double least = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& corners = triangles[t].corners;
      if (!inside(corners, place_in(p, place))) continue;
      const double z = triangle_coverage::Linear(corners, triangles[t].depth)
                           .at(weights_at_place(triangle_coverage::edges_of(corners), place_in(p, place)));
      if (front && z >= least) continue;
      front = t;
      least = z;
    }
    if (front) ++count[*front];
  }
  return count;
}

/// One number per pixel that tells whose colours were mixed, by which shares, from which places.
struct Found {
  dvec3 sum{0};
  double share = 0;
  friend bool operator==(const Found&, const Found&) = default;
};
using Sheet = std::array<Found, std::size_t{columns} * rows>;

/// Pixels that are not those of all samples everywhere, bit for bit, or whose shares are not the oracle's.
double adaptive_error(const Input& i) {
  if (!is_scene(i)) return 0;
  const auto triangles = triangles_of(i);
  const auto places = n_rooks(static_cast<int>(i[0]));
  const auto tint = [](int t, ivec2, const Weights& w) {
    return triangle_coverage::barycentric(w) + static_cast<double>(t);
  };
  Sheet quick{}, full{};
  const auto into = [](Sheet& found) {
    return [&found](ivec2 p, const dvec3& sum, double share) {
      found[static_cast<std::size_t>(p.y * columns + p.x)] = {sum, share};
    };
  };
  std::array<std::array<int, most_triangles>, std::size_t{columns} * rows> counts{};
  const auto count = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Coloured>)
      counts[static_cast<std::size_t>(s.pixel.y * columns + s.pixel.x)]
            [static_cast<std::size_t>(s.triangle)] = s.samples;
  };
  adaptive::adaptive(triangles, sheet, places, tint, into(quick), count);
  each_sample(triangles, sheet, places, tint, into(full));
  double error = 0;
  for (std::size_t k = 0; k < quick.size(); ++k) {
    const int at = static_cast<int>(k);
    const auto right = shown(triangles, {at % columns, at / columns}, places);
    const double share = (right[0] + right[1] + right[2]) / i[0];
    error += !(quick[k] == full[k]) || counts[k] != right || quick[k].share != share;
  }
  return error;
}
/// Depths change order somewhere in a pixel that no edge crosses.
bool is_pierced(const Input& i) {
  bool found = false;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Compared>) found |= s.order == Order::changing;
  };
  adaptive::adaptive(
      triangles_of(i), sheet, n_rooks(static_cast<int>(i[0])), [](int, ivec2, const Weights&) { return 0.0; },
      [](auto...) {}, watch);
  return found;
}
/// Pixels that take all samples, and others that show something.
bool is_mixed(const Input& i) {
  std::int64_t crossed = 0, plotted = 0;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Finished>) crossed = s.crossed;
  };
  adaptive::adaptive(
      triangles_of(i), sheet, n_rooks(static_cast<int>(i[0])), [](int, ivec2, const Weights&) { return 0.0; },
      [&](auto...) { ++plotted; }, watch);
  return 0 < crossed && crossed < plotted;
}

// --- Rooks

/// Rows and columns without a sample, by integers.
double rooks_error(const Input& i) {
  const bool taken = is_whole(i[0], 1, subpixels);
  if (!is_whole(i[0])) return 0;
  try {
    const auto count = static_cast<int>(i[0]);
    const std::vector<ivec2> places = n_rooks(count);
    if (!taken) return wrong;
    double missing = std::abs(static_cast<double>(places.size()) - count);
    for (const int axis : {0, 1}) {
      std::vector<bool> held(static_cast<std::size_t>(count));
      for (const ivec2 p : places) {
        // Row r has its middle at (2r + 1) 128 / n, rounded down
        for (int r = 0; r < count; ++r)
          if (p[axis] == (2 * r + 1) * subpixels / (2 * count)) held[static_cast<std::size_t>(r)] = true;
      }
      missing += static_cast<double>(std::ranges::count(held, false));
    }
    return missing;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

}  // namespace

Domain adaptive() {
  return {
      "adaptive",
      {{.name = "equals_each_sample",
        .states = "the bits of all samples everywhere, and the shares of samples by 128 bits",
        .unit = "pixels",
        .bound = 0,
        .numbers = 1 + of_triangle * most_triangles,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                  Kind::extremes},
        .generate = scene,
        .error = adaptive_error,
        .traps = {{"two that pierce in a pixel",
                   {16, -8000, -8000, 9000, -8000, 0, 9000, 0.5, 0.5, 0.5, -8000, -8000, 9000, -8000,
                    0,  9000,  0.25,  0.75, 0.5,   0, 0,    0,   0,   0,   0,     0,     0,    0}},
                  {"twice the same", {8,  10, 20,   1400, 100, 300, 1000, 0.5, 0.25, 1, 1400, 100, 300, 1000,
                                      10, 20, 0.25, 1,    0.5, 0,   0,    0,   0,    0, 0,    0,   0,   0}},
                  {"edges on the sides of pixels",
                   {4,    256, 0, 256, 1024, 1280, 0,   0,    0,   0,   256, 1024, 1280, 1024,
                    1280, 0,   0, 0,   0,    512,  256, 1024, 256, 512, 768, 1,    1,    1}},
                  {"a sliver that hides in a pixel",
                   {16, 300,  300, 420, 301, 301, 300, 0, 0, 0, 0, 0, 1536, 0,
                    0,  1024, 1,   1,   1,   0,   0,   0, 0, 0, 0, 0, 0,    0}}},
        .shares = {{"is pierced", 0.02, is_pierced}, {"is mixed", 0.15, is_mixed}},
        .cases = 4'000},
       {.name = "n_rooks",
        .states = "one sample in the middle of each row and each column",
        .unit = "rows",
        .bound = 0,
        .numbers = 1,
        .kinds = {Kind::random, Kind::refused},
        .generate = [](Kind kind, Random& random) -> Input {
          return {whole(random, kind == Kind::refused ? -5 : 1, kind == Kind::refused ? 400 : 256)};
        },
        .error = rooks_error,
        .traps = {{"one", {1}}, {"no prime and none after it", {8}}, {"all places of a row", {256}}},
        .cases = 300}}};
}

}  // namespace gradus::stress
