// The promises of triangles as pixels: the nearest grid place for a corner, and every centre to one triangle.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stress/numbers.hpp"
#include "support/coverage_oracle.hpp"

namespace gradus::stress {
namespace {

using triangle_coverage::farthest;
using triangle_coverage::subpixels;
using triangle_coverage::Triangle;
using triangle_coverage::Weights;

constexpr double limit = double{farthest} * subpixels;
constexpr int columns = 24, rows = 16;

/// Three corners in 1/256 pixel.
Input generate(Kind kind, Random& random) {
  Input input;
  const auto whole = [&](std::int64_t low, std::int64_t high) {
    return static_cast<double>(random.uniform_int(low, high));
  };
  const double ends[] = {-limit, -limit + 128, 0, 128, limit - 128, limit};
  for (int i = 0; i < 6; ++i) {
    if (kind == Kind::ties || kind == Kind::grazing) {
      input.push_back(128 * whole(-2, 2 * columns + 2));  // centres, sides and corners of pixels
    } else if (kind == Kind::huge) {
      input.push_back(std::round(random.uniform(-limit, limit)));
    } else if (kind == Kind::extremes) {
      input.push_back(ends[random.uniform_int(0, 5)]);
    } else if (kind == Kind::tiny) {
      input.push_back(128 + whole(-2, 2));
    } else {
      input.push_back(whole(-1000, columns * subpixels + 1000));
    }
  }
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third corner on the line of the others, or next to it
    const double t = kind == Kind::grazing ? whole(-2, 3) : random.uniform(-0.5, 1.5);
    for (std::size_t k = 0; k < 2; ++k) {
      const double on = std::round(input[k] + t * (input[2 + k] - input[k]));
      input[4 + k] = std::clamp(on + whole(-1, 1), -limit, limit);
    }
  }
  if (kind == Kind::refused) input[static_cast<std::size_t>(random.uniform_int(0, 5))] = limit + 1;
  return input;
}

/// How many pixels of a window are covered although their centres are outside, or the other way round.
double cover_error(const Input& i) {
  for (const double x : i) {
    if (x != std::floor(x) || std::abs(x) > 0x1p30) return 0;
  }
  const auto corner = [&](std::size_t k) {
    return ivec2{static_cast<int>(i[k]), static_cast<int>(i[k + 1])};
  };
  const Triangle t{corner(0), corner(2), corner(4)};
  const bool taken = std::ranges::all_of(i, [](double x) { return std::abs(x) <= limit; });
  std::array<int, std::size_t{columns} * rows> hits{};
  bool sums = true;
  test::int128_t area = test::int128_t{t[1].x - t[0].x} * (t[2].y - t[0].y);
  area -= test::int128_t{t[1].y - t[0].y} * (t[2].x - t[0].x);
  try {
    triangle_coverage::cover(t, {{0, 0}, {columns - 1, rows - 1}}, [&](ivec2 p, const Weights& w) {
      ++hits[static_cast<std::size_t>(p.y * columns + p.x)];
      sums &= std::min({w[0], w[1], w[2]}) >= 0 &&
              test::int128_t{w[0]} + w[1] + w[2] == (area < 0 ? -area : area);
    });
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken || !sums) return wrong;
  double error = 0;
  std::int64_t ties = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const ivec2 centre{subpixels * x + subpixels / 2, subpixels * y + subpixels / 2};
      const int a = test::side(t[0], t[1], centre, ties), b = test::side(t[1], t[2], centre, ties),
                c = test::side(t[2], t[0], centre, ties);
      const int right = area != 0 && a == b && b == c;
      error += std::abs(hits[static_cast<std::size_t>(y * columns + x)] - right);
    }
  }
  return error;
}

/// How far a place is moved, in 1/256 pixel; midway it must go to the smaller one.
double snap_error(const Input& i) {
  const bool taken = std::abs(i[0]) <= farthest && std::abs(i[1]) <= farthest;
  try {
    const ivec2 found = triangle_coverage::snap({i[0], i[1]});
    if (!taken) return wrong;
    double worst = 0;
    for (const int k : {0, 1}) {
      // Exact: both lie on the grid of the smaller one's last place, or the place is tiny
      const double moved = found[k] - i[static_cast<std::size_t>(k)] * subpixels;
      if (moved == 0.5) return wrong;
      worst = std::max(worst, std::abs(moved));
    }
    return worst;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

}  // namespace

Domain triangle_coverage() {
  return {"triangle_coverage",
          {{.name = "cover",
            .states =
                "exactly the pixels whose centres the triangle owns, by 128 bits; weights add up to its area",
            .unit = "pixels",
            .bound = 0,
            .numbers = 6,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                      Kind::extremes, Kind::refused},
            .generate = generate,
            .error = cover_error,
            .traps = {{"a product of 2^31", {0, 0, 65536, 0, 0, 32768}},
                      {"products of 1e16 that cancel", {-1e8, -1e8, 1e8, 1e8, 1e8, -1e8}},
                      {"corners on pixel centres", {128, 128, 1152, 128, 128, 1152}},
                      {"one half of a square", {0, 0, 2048, 0, 2048, 2048}},
                      {"the other half of the square", {0, 0, 2048, 2048, 0, 2048}},
                      {"a corner on another's side", {0, 0, 1024, 1024, 2048, 0}},
                      {"clockwise", {0, 0, 0, 2048, 2048, 0}},
                      {"no area", {0, 0, 256, 256, 1024, 1024}},
                      {"a sliver", {0, 0, 4096, 1, 2048, 1}},
                      {"too far out", {0, 0, limit + 1, 0, 0, 2048}}}},
           {.name = "snap",
            .states = "the nearest place on the grid, midway the smaller one",
            .unit = "of 1/256 pixel",
            .bound = 0.5,
            .numbers = 2,
            .generate =
                [](Kind kind, Random& random) {
                  Input input{number(kind, random), number(kind, random)};
                  if (kind != Kind::grazing && kind != Kind::ties) return input;
                  // Midway, or a little beside it
                  for (double& x : input) {
                    x = (std::floor(random.uniform(-0x1p28, 0x1p28)) + 0.5) / subpixels;
                    if (kind == Kind::grazing) x = nudged(x, random);
                  }
                  return input;
                },
            .error = snap_error,
            .traps = {{"midway", {0.5 / 256, -0.5 / 256}},
                      {"midway but for an ulp", {std::nextafter(0.5 / 256, 1), std::nextafter(0.5 / 256, 0)}},
                      {"a place that is no number", {std::nan(""), 0}},
                      {"as far as may be", {farthest, -farthest}}}}}};
}

}  // namespace gradus::stress
