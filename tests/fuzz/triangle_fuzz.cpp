// Triangles: pixels against the sides of centres moved by something infinitely small, in 128 bits; pairs that
// share an edge cover each centre once.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "core/exact.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::triangle_coverage;
using gradus::test::require;

namespace {

constexpr int columns = 16, rows = 12;
constexpr Window sheet{{0, 0}, {columns - 1, rows - 1}};
using Hits = std::array<int, columns * rows>;

int side(ivec2 a, ivec2 b, ivec2 p) {
  const Int128 on = Int128{p.x} * (Int128{a.y} - b.y) + Int128{p.y} * (Int128{b.x} - a.x) +
                    Int128{a.x} * b.y - Int128{a.y} * b.x;
  if (on != 0) return on < 0 ? -1 : 1;
  const std::int64_t moved = a.y != b.y ? std::int64_t{a.y} - b.y : std::int64_t{b.x} - a.x;
  return moved < 0 ? -1 : moved > 0;
}

Hits covered(const Triangle& t) {
  Hits hits{};
  cover(t, sheet, [&](ivec2 p, const Weights& w) {
    ++hits[static_cast<std::size_t>(p.y * columns + p.x)];
    require(w[0] + w[1] + w[2] == std::abs(doubled_area(t)) && std::min({w[0], w[1], w[2]}) >= 0,
            "weights are not negative and add up to the area");
  });
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const ivec2 centre{256 * x + 128, 256 * y + 128};
      const int a = side(t[0], t[1], centre), b = side(t[1], t[2], centre), c = side(t[2], t[0], centre);
      const bool in = doubled_area(t) != 0 && a == b && b == c;
      require(hits[static_cast<std::size_t>(y * columns + x)] == (in ? 1 : 0),
              "the centres inside are covered");
    }
  }
  return hits;
}

ivec2 corner(test::FuzzInput& input) {
  constexpr int most = farthest * 256;
  const int kind = input.below(4);
  const ivec2 p = input.cell();
  if (kind == 0) return {p.x % 40 * 128, p.y % 30 * 128};
  if (kind == 1) return {std::clamp(p.x, -most, most), std::clamp(p.y, -most, most)};
  return {p.x % 6000, p.y % 5000};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const ivec2 a = corner(input), b = corner(input), c = corner(input), d = corner(input);
  const Hits first = covered({a, b, c});
  require(covered({b, c, a}) == first && covered({c, b, a}) == first, "the corners' order does not matter");
  // On different sides of a common edge
  const std::int64_t one = doubled_area({a, b, c}), other = doubled_area({a, b, d});
  if ((one < 0 && other > 0) || (one > 0 && other < 0)) {
    const Hits second = covered({b, a, d});
    for (std::size_t i = 0; i < first.size(); ++i)
      require(first[i] + second[i] <= 1, "no centre is covered twice");
  }
  const dvec2 place{input.any_number(), input.any_number()};
  if (!can_snap(place)) return 0;
  const ivec2 snapped = snap(place);
  for (int i = 0; i < 2; ++i) {
    require(std::abs(snapped[i] / 256.0 - place[i]) <= 1.0 / 512, "snapping moves by 1/512 at most");
  }
  return 0;
}
