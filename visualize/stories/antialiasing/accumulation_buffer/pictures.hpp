#pragma once
// One chequered plane in four strips, with 1, 2, 8 and 32 passes.

#include <array>
#include <utility>

#include "stories/antialiasing/accumulation_buffer/subject.hpp"
#include "stories/antialiasing/chequered_plane.hpp"
#include "stories/picture_shelf.hpp"

namespace gradus::accumulation_buffer {

/// The whole plane with a x b passes.
inline Picture plane_by(ivec2 grid) {
  const ChequeredPlane plane{{96, 36}};
  Picture picture{plane.size};
  const auto render = [&](dvec2 place, const Sums<double>& plot) { draw(plane.size, place, plane, plot); };
  accumulate(grid, render, picture.sums());
  return picture;
}

/// By how much pixels are off at most, and on average.
inline std::pair<double, double> errors_of(const Picture& picture, const Picture& right) {
  double worst = 0, sum = 0;
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    const double off = std::abs(picture.values[i] - right.values[i]);
    sum += off;
    worst = std::max(worst, off);
  }
  return {worst, sum / static_cast<double>(picture.values.size())};
}

inline void tell_side_by_side(Narrator& narrator) {
  const Words& words = narrator.words();
  constexpr std::array<ivec2, 4> grids{{{1, 1}, {2, 1}, {4, 2}, {8, 4}}};
  const Picture right = plane_by({16, 16});
  const ivec2 strip{right.size.x / static_cast<int>(grids.size()), right.size.y};
  narrator.subtitle("pictures.subtitle", {{"columns", right.size.x}, {"rows", right.size.y}});
  narrator.columns({{"passes"}, {"greys"}, {"worst"}, {"mean_error"}});
  std::vector<std::string> names;
  for (const ivec2 grid : grids) names.push_back(figure_number(grid.x * grid.y));
  PictureShelf shelf(narrator, {.size = strip, .names = names, .gap = 1, .heading = 7});
  shelf.frame(Role::past);
  shelf.start({.text = "pictures.started", .key = "started"});
  std::vector<double> means;
  for (const ivec2 grid : grids) {
    const std::int64_t passes = std::int64_t{grid.x} * grid.y;
    const Picture picture = plane_by(grid);
    const auto [worst, mean] = errors_of(picture, right);
    const double before = means.empty() ? 0 : means.back();
    const ivec2 from{static_cast<int>(means.size()) * strip.x, 0};
    means.push_back(mean);
    shelf.show("PictureAccumulated", 0, [&](ivec2 p) { return tone_of(picture.at(from + p)); },
               {.text = passes == 1 ? "pictures.one" : "pictures.more",
                .facts = {{"passes", passes}, {"worst", worst}, {"mean_error", mean}},
                .words = {{"greys", passes + 1}, {"error", mean}, {"before", before}},
                .row = {passes, passes + 1, worst, mean},
                .key = fmt::format("{} passes", passes),
                .phase = words.say("phase.pictures")});
  }
  shelf.finish({.text = "pictures.finished",
                .words = {{"first", means.front()}, {"last", means.back()}},
                .key = "finished"});
  narrator.result({{"mean_error", means.back()}});
}

}  // namespace gradus::accumulation_buffer
