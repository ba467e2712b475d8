// Lines: every pixel against exact integers, windows against brute force, runs and drawing against the taught
// method, over all of int32.

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::bresenham_line;
using Wide = boost::multiprecision::int128_t;
using gradus::test::require;

namespace {

using Pixels = std::vector<ivec2>;

/// Pixel number k by definition: the exact point of the line, rounded aside, midway to the smaller
/// coordinate.
ivec2 exact_pixel(ivec2 from, ivec2 to, std::int64_t k) {
  const Wide dx = Wide(to.x) - from.x, dy = Wide(to.y) - from.y;
  const bool up = abs(dy) > abs(dx);
  const Wide along = up ? dy : dx, aside = up ? dx : dy;
  if (along == 0) return from;
  const Wide length = abs(along), step = along > 0 ? 1 : -1;
  // ceil(a + aside k / length - 1/2) = floor((2 aside k + length - 1) / (2 length)) + a
  const Wide n = 2 * aside * k + length - 1, d = 2 * length;
  Wide q = n / d;
  if (n % d < 0) --q;
  const int lead = static_cast<int>((up ? from.y : from.x) + step * k),
            side = static_cast<int>((up ? from.x : from.y) + q);
  return up ? ivec2{side, lead} : ivec2{lead, side};
}

void check_window(ivec2 from, ivec2 to, const Window& window) {
  const Stretch stretch = visible(from, to, window);
  Pixels shown, runs;
  in_window(from, to, window, [&](ivec2 p) { shown.push_back(p); });
  run_length_in_window(from, to, window, [&](ivec2 start, std::int64_t count) {
    require(count > 0, "a run has pixels");
    for (std::int64_t j = 0; j < count; ++j) runs.push_back(place(start, moves(from, to), j, 0));
  });
  require(shown == runs, "runs are the pixels");
  require(
      static_cast<std::int64_t>(shown.size()) == std::max<std::int64_t>(0, stretch.last - stretch.first + 1),
      "a stretch counts its pixels");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    require(window.contains(shown[i]), "nothing outside of the window");
    require(shown[i] == exact_pixel(from, to, stretch.first + static_cast<std::int64_t>(i)),
            "pixels are exact");
  }
  // Just before and after, and anywhere else: outside
  const std::int64_t last = pixel_count(from, to) - 1;
  std::int64_t hits = 0;
  for (const std::int64_t k :
       {stretch.first - 1, stretch.last + 1, std::int64_t{0}, last, last / 2, last / 3}) {
    if (k < 0 || k > last) continue;
    const bool in = stretch.first <= k && k <= stretch.last;
    require(window.contains(exact_pixel(from, to, k)) == in, "what lies in the window is shown");
    hits += in;
  }
  static_cast<void>(hits);
  if (last > 3000) return;
  Pixels expected;
  decision_parameter(from, to, [&](ivec2 p) {
    if (window.contains(p)) expected.push_back(p);
  });
  require(shown == expected, "a window shows what the whole line has there");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const ivec2 from = input.cell();
  ivec2 to = input.cell();
  if (input.below(4) == 0) to = {from.x ^ 2, from.y};
  const std::int64_t last = pixel_count(from, to) - 1;
  const auto anywhere = static_cast<std::int64_t>(input.word() % static_cast<std::uint64_t>(last + 1));
  for (const std::int64_t k : {std::int64_t{0}, last, last / 2, (last + 1) / 2, anywhere}) {
    const ivec2 p = pixel_at(from, to, k);
    require(p == exact_pixel(from, to, k), "a pixel is the nearest");
    require(p == pixel_at(to, from, last - k), "the reverse has the same pixels");
  }
  // Windows of at most 40 x 40 round a pixel of the line, and any inside out
  const ivec2 at = pixel_at(from, to, anywhere);
  const auto bounded = [](std::int64_t v) {
    return static_cast<int>(std::clamp<std::int64_t>(v, INT_MIN, INT_MAX));
  };
  const Window window{
      {bounded(std::int64_t{at.x} - input.below(24) + 2), bounded(std::int64_t{at.y} - input.below(24) + 2)},
      {bounded(std::int64_t{at.x} + input.below(24) - 2), bounded(std::int64_t{at.y} + input.below(24) - 2)}};
  check_window(from, to, window);
  if (last > 3000) return 0;
  Pixels all, runs;
  decision_parameter(from, to, [&](ivec2 p) { all.push_back(p); });
  require(static_cast<std::int64_t>(all.size()) == last + 1, "a line has its pixels");
  for (std::size_t k = 0; k < all.size(); ++k) {
    require(all[k] == exact_pixel(from, to, static_cast<std::int64_t>(k)), "every pixel is the nearest");
  }
  run_length(from, to, [&](ivec2 start, std::int64_t count) {
    for (std::int64_t j = 0; j < count; ++j) runs.push_back(place(start, moves(from, to), j, 0));
  });
  require(runs == all, "runs are the pixels of the taught method");
  Raster<std::uint8_t> raster(1 + input.below(90), 1 + input.below(60)),
      expected(raster.width(), raster.height());
  draw(raster, from, to, std::uint8_t{1});
  for (const ivec2 p : all) {
    if (expected.contains(p)) expected[p] = 1;
  }
  require(raster == expected, "drawing gives the pixels of the taught method");
  return 0;
}
