// Fills of areas of six kinds by every method, beside OpenCV's floodFill.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "stress/scan_conversion/areas.hpp"
#include "support/fill_pictures.hpp"

#ifdef GRADUS_HAS_OPENCV
#include <opencv2/imgproc.hpp>
#endif

namespace gradus::bench {
namespace {

using flood_fill::Method;
using test::Canvas;  // a byte per cell, as OpenCV's pictures in grey: 0 free, 1 wall, 2 painted
using test::comb;
using test::maze;
using test::noise;

/// A picture, its largest area, and a seed there.
struct Scene {
  Canvas canvas;
  stress::Mask area;
  ivec2 seed{0, 0};
  std::int64_t cells = 0;  ///< of the area
};

constexpr auto connectivity = flood_fill::Connectivity::four;

/// The area that a cell belongs to.
Scene scene_from(const Canvas& canvas, ivec2 seed) {
  const auto is_free = [&](ivec2 p) { return canvas[p] == 0; };
  Scene scene{canvas, stress::area_of(canvas.width(), canvas.height(), seed, connectivity, is_free), seed};
  scene.cells = std::ranges::count(scene.area.cells(), 1);
  return scene;
}

Scene scene_of(const Canvas& canvas) {
  const auto is_free = [&](ivec2 p) { return canvas[p] == 0; };
  const auto areas = stress::areas_of(canvas.width(), canvas.height(), connectivity, is_free);
  std::vector<std::int64_t> cells(areas.cells().size());
  for (const int area : areas.cells()) {
    if (area != stress::no_area) ++cells[static_cast<std::size_t>(area)];
  }
  const auto largest = std::ranges::max_element(cells);
  const int first = static_cast<int>(largest - cells.begin());
  return scene_from(canvas, {first % canvas.width(), first / canvas.width()});
}

/// One corridor that winds inwards from the corner.
Canvas spiral(int side) {
  Canvas canvas(side, side, 1);
  ivec2 at{0, 0}, way{1, 0};
  canvas[at] = 0;
  for (int turns = 0; turns < 2;) {
    // Straight on until the border or an older turn, one wall away, is ahead
    const ivec2 next = at + way, beyond = next + way;
    const bool wall = canvas.contains(next) && canvas[next] == 1;
    if (wall && !(canvas.contains(beyond) && canvas[beyond] == 0)) {
      canvas[at = next] = 0;
      turns = 0;
    } else {
      way = {-way.y, way.x};
      ++turns;
    }
  }
  return canvas;
}

/// A room of ten cells in the middle of an empty canvas.
Canvas room(int side) {
  Canvas canvas(side, side);
  const ivec2 lower = ivec2(side / 2) - ivec2(6, 1);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 12; ++x) canvas[lower + ivec2(x, y)] = y == 1 && x % 11 != 0 ? 0 : 1;
  }
  return canvas;
}

const Scene& scene(const std::string& kind, int side) {
  static std::map<std::pair<std::string, int>, Scene> made;
  const auto [at, added] = made.try_emplace({kind, side});
  if (!added) return at->second;
  if (kind == "room") return at->second = scene_from(room(side), ivec2(side / 2));
  at->second = scene_of(kind == "noise"    ? noise(side)
                        : kind == "maze"   ? maze(side)
                        : kind == "comb"   ? comb(side)
                        : kind == "spiral" ? spiral(side)
                                           : Canvas(side, side));
  if (kind == "empty") at->second.seed = {side / 2, side / 2};
  return at->second;
}

/// Cells painted that should not be, or missed.
Error error_of(const Canvas& painted, const Scene& scene) {
  const auto wrong = stress::wrong_cells(painted, scene.canvas, scene.area, std::uint8_t{2});
  const double all = static_cast<double>(painted.cells().size());
  return {wrong > 0 ? 1.0 : 0.0, std::sqrt(static_cast<double>(wrong) / all), wrong};
}

/// Every method on a picture.
void add_cases(std::vector<Case>& cases, const Scene& scene, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto fill) {
    const auto canvas = std::make_shared<Canvas>(scene.canvas);
    fill(*canvas, scene.seed);
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = workload,
                     .items = scene.cells,
                     .run = [fill, canvas, &scene] { fill(*canvas, scene.seed); },
                     .prepare = [canvas, &scene] { *canvas = scene.canvas; },
                     .error = error_of(*canvas, scene)});
  };
  const auto by = [](Method method) {
    return [method](Canvas& canvas, ivec2 seed) {
      flood_fill::fill_raster(canvas, seed, std::uint8_t{2}, method);
    };
  };
  add("depth_first", Standing::taught, by(Method::depth_first));
  add("breadth_first", Standing::taught, by(Method::breadth_first));
  add("span", Standing::robust, by(Method::span));
  add("fill_rows", Standing::batch,
      [](Canvas& canvas, ivec2 seed) { flood_fill::fill_rows(canvas, seed, std::uint8_t{2}); });
  add("fill_by_labels", Standing::batch,
      [](Canvas& canvas, ivec2 seed) { flood_fill::fill_by_labels(canvas, seed, std::uint8_t{2}); });
  add("fill_area", Standing::batch,
      [](Canvas& canvas, ivec2 seed) { flood_fill::fill_area(canvas, seed, std::uint8_t{2}); });
#ifdef GRADUS_HAS_OPENCV
  add("OpenCV floodFill", Standing::peer, [](Canvas& canvas, ivec2 seed) {
    cv::Mat picture(canvas.height(), canvas.width(), CV_8UC1, canvas.cells().data());
    cv::floodFill(picture, {seed.x, seed.y}, 2, nullptr, 0, 0, 4);
  });
#endif
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* kind : {"empty", "noise", "maze", "comb", "spiral", "room"}) {
    add_cases(all, scene(kind, 1024), {fmt::format("{} 1024", kind)});
  }
  for (const int side : {64, 256, 1024, 4096}) {
    const Scene& picture = scene("noise", side);
    add_cases(all, picture, {fmt::format("noise of side {}", side), static_cast<double>(picture.cells)});
  }
  return all;
}

}  // namespace

Subject flood_fill() {
  return {.topic = "flood_fill",
          .title = "Filling an area of a picture",
          .item = "cell",
          .unit = "cells",
          .measure = "cells of the area",
          .telling = "noise 1024",
          .cases = cases,
          .choice = {"fill_area", "rows for few runs, labels for many, whichever is faster"}};
}

}  // namespace gradus::bench
