// Circles: windows and drawing against the definition of every pixel, for any centre and radius of int32.

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <climits>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_batch.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::bresenham_circle;
using Wide = boost::multiprecision::int128_t;
using gradus::test::require;

namespace {

using Pixels = std::vector<std::pair<int, int>>;

/// By definition: folded into the first octant, the pixel is the nearest one of its column.
bool on_circle(ivec2 center, int radius, ivec2 p) {
  const Wide x = abs(Wide(p.x) - center.x), y = abs(Wide(p.y) - center.y), r = radius;
  const Wide a = std::min(x, y), b = std::max(x, y), squared = 4 * (r * r - a * a);
  return squared >= 0 && (b == 0 || (2 * b - 1) * (2 * b - 1) < squared) &&
         squared < (2 * b + 1) * (2 * b + 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const ivec2 center = input.cell();
  const int given = input.integer();
  const int radius = given == INT_MIN ? INT_MAX : std::abs(given);
  // A window of at most 24 x 24 round a pixel of the circle, many where octants meet
  const Octant octant = octants[static_cast<std::size_t>(input.below(8))];
  const std::int64_t last = last_column(radius);
  const int kind = input.below(3);
  const std::int64_t guess =
      kind == 0   ? last - input.below(3)
      : kind == 1 ? input.below(3)
                  : static_cast<std::int64_t>(input.word() % static_cast<std::uint64_t>(last + 1));
  const std::int64_t column = std::clamp<std::int64_t>(guess, 0, last), height = height_at(radius, column);
  const auto bounded = [](std::int64_t v) {
    return static_cast<int>(std::clamp<std::int64_t>(v, INT_MIN, INT_MAX));
  };
  const std::int64_t at_x = center.x + column * octant.right.x + height * octant.up.x;
  const std::int64_t at_y = center.y + column * octant.right.y + height * octant.up.y;
  const Window window{{bounded(at_x - input.below(12)), bounded(at_y - input.below(12))},
                      {bounded(at_x + input.below(12)), bounded(at_y + input.below(12))}};
  Pixels expected, shown;
  for (std::int64_t x = window.lower.x; x <= window.upper.x; ++x) {
    for (std::int64_t y = window.lower.y; y <= window.upper.y; ++y) {
      if (on_circle(center, radius, {static_cast<int>(x), static_cast<int>(y)})) {
        expected.emplace_back(static_cast<int>(x), static_cast<int>(y));
      }
    }
  }
  in_window(center, radius, window, [&](ivec2 p) { shown.emplace_back(p.x, p.y); });
  std::sort(shown.begin(), shown.end());
  require(shown == expected, "a window shows the circle's pixels, each once");
  // On a raster whose lower left pixel is the window's
  Raster<std::uint8_t> raster(1 + input.below(40), 1 + input.below(40)),
      by_definition(raster.width(), raster.height());
  const ivec2 there{bounded(std::int64_t{center.x} - at_x), bounded(std::int64_t{center.y} - at_y)};
  draw(raster, there, radius, std::uint8_t{1});
  for (int y = 0; y < raster.height(); ++y) {
    for (int x = 0; x < raster.width(); ++x) by_definition[{x, y}] = on_circle(there, radius, {x, y});
  }
  require(raster == by_definition, "drawing gives the circle's pixels");
  if (radius > 600 || !fits_plane(center, radius)) return 0;
  std::int64_t count = 0;
  Pixels all;
  decision_parameter(center, radius, [&](ivec2 p) {
    require(on_circle(center, radius, p), "every pixel is the nearest");
    all.emplace_back(p.x, p.y);
    ++count;
  });
  require(count == pixel_count(radius), "a circle has its pixels");
  std::sort(all.begin(), all.end());
  require(std::adjacent_find(all.begin(), all.end()) == all.end(), "no pixel comes twice");
  return 0;
}
