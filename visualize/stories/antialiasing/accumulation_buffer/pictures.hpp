#pragma once
// The same fan of slivers with 1, 4, 16 and 64 passes beside each other.

#include <array>
#include <utility>

#include "stories/antialiasing/accumulation_buffer/subject.hpp"
#include "stories/picture_shelf.hpp"

namespace gradus::accumulation_buffer {

/// Slivers from one corner of a picture to the other two sides.
struct Fan {
  static constexpr ivec2 size{15, 15};
  static constexpr int slivers = 6;

  static Corners sliver(int k) {
    const dvec2 hub{0.4, 14.6};
    const auto rim = [&](double part) {
      const double turn = 1.5707963267948966 * part;
      return hub + 16.0 * dvec2{gradus::cos(turn), -gradus::sin(turn)};
    };
    const double from = (k + 0.4) / slivers;
    return {hub, rim(from), rim(from + 0.22 / slivers)};
  }
  static double colour(dvec2 place) {
    for (int k = 0; k < slivers; ++k) {
      if (holds(sliver(k), place)) return 1;
    }
    return 0;
  }
  /// The exact area of the slivers in a pixel: they touch in the hub alone.
  static double area(ivec2 pixel) {
    double area = 0;
    for (int k = 0; k < slivers; ++k) area += area_of(part_in(sliver(k), pixel));
    return area;
  }
  /// With side x side passes.
  static Picture accumulated(int side) {
    Picture picture{size};
    const auto render = [&](dvec2 place, const Sums<double>& plot) { draw(size, place, colour, plot); };
    accumulate({side, side}, render, picture.sums());
    return picture;
  }
  /// What of a sliver lies in the picture.
  static std::vector<dvec2> inside(const Corners& sliver) {
    std::vector<dvec2> scaled;
    for (const dvec2 p : sliver) scaled.push_back(p / dvec2(size));
    std::vector<dvec2> part = ring_within(scaled, dvec2(0), dvec2(1));
    for (dvec2& p : part) p *= dvec2(size);
    return part;
  }
  /// By how much the pixels are off at most, and on average.
  static std::pair<double, double> errors_of(const Picture& picture) {
    double worst = 0, sum = 0;
    for (ivec2 p{0, 0}; p.y < size.y; ++p.y) {
      for (p.x = 0; p.x < size.x; ++p.x) {
        const double off = std::abs(picture.at(p) - area(p));
        sum += off;
        worst = std::max(worst, off);
      }
    }
    return {worst, sum / static_cast<double>(picture.values.size())};
  }
};

inline void tell_side_by_side(Narrator& narrator) {
  const Words& words = narrator.words();
  constexpr std::array sides{1, 2, 4, 8};
  narrator.subtitle("pictures.subtitle", {{"columns", Fan::size.x}, {"rows", Fan::size.y}});
  narrator.columns({{"passes"}, {"greys"}, {"worst"}, {"mean_error"}});
  narrator.legend({{Role::past, "slivers"}});
  std::vector<std::string> names;
  for (const int side : sides) names.push_back(words.count("heading.passes", side * side));
  PictureShelf shelf(narrator, {.size = Fan::size, .names = names, .row = 2, .heading = 2});
  shelf.frame(Role::guide);
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (int s = 0; s < Fan::slivers; ++s) shelf.wait(k, Role::past, Fan::inside(Fan::sliver(s)));
  }
  shelf.start({.text = "pictures.started", .words = {{"slivers", Fan::slivers}}, .key = "started"});
  std::vector<double> means;
  for (const int side : sides) {
    const std::int64_t passes = std::int64_t{side} * side;
    const Picture picture = Fan::accumulated(side);
    const auto [worst, mean] = Fan::errors_of(picture);
    const double before = means.empty() ? 0 : means.back();
    means.push_back(mean);
    shelf.show("PictureAccumulated", 0, [&](ivec2 p) { return tone_of(Frame::shade(picture.at(p))); },
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
