#pragma once
// The same plane by a grid, by independent samples and by Poisson-disc ones, about as many a pixel: above
// each picture the samples of one pixel and their power spectrum.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "antialiasing/poisson_disc/poisson_disc.hpp"
#include "core/pixels.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/chequered_plane.hpp"
#include "stories/antialiasing/spectrum.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/telling.hpp"

namespace gradus::poisson_disc {

/// Fills a tile of this size in pixels with samples.
using Fill = std::function<std::vector<dvec2>(ivec2 size, const Random& random)>;

/// With the usual number of tries, so that no pixel is left without.
inline Fill discs(double radius) {
  return [=](ivec2 size, const Random& random) {
    std::vector<dvec2> samples;
    bridson({dvec2(size), true}, radius, 30, random, [&](dvec2 p) { samples.push_back(p); });
    return samples;
  };
}
inline Fill independent(double a_pixel) {
  return [=](ivec2 size, Random random) {
    std::vector<dvec2> samples(static_cast<std::size_t>(std::round(a_pixel * size.x * size.y)));
    for (dvec2& s : samples) s = any_in({dvec2(size)}, random);
    return samples;
  };
}
inline Fill grid_of(int side) {
  return [=](ivec2 size, const Random&) {
    std::vector<dvec2> samples;
    for (const ivec2 p : pixels(Window{{0, 0}, side * size - 1}))
      samples.push_back((dvec2(p) + 0.5) / double(side));
    return samples;
  };
}

/// What copies of a tile's samples make of the plane: each pixel gets the mean of its own.
inline std::vector<double> picture_of(const ChequeredPlane& plane, ivec2 period,
                                      const std::vector<dvec2>& samples) {
  const auto number = [&](dvec2 p) {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(plane.size.x) +
           static_cast<std::size_t>(p.x);
  };
  std::vector<dvec2> sums(number({0, plane.size.y}), dvec2(0));  // their light, and how many
  for (const ivec2 copy : pixels(Window{{0, 0}, plane.size / period - 1})) {
    for (const dvec2 s : samples) {
      const dvec2 p = s + dvec2(copy * period);
      sums[number(p)] += dvec2(plane(p), 1);
    }
  }
  std::vector<double> picture;
  for (const ivec2 p : pixels(Window{{0, 0}, plane.size - 1})) {
    const dvec2 sum = sums[number(dvec2(p))];
    picture.push_back(sum.y > 0 ? sum.x / sum.y : plane(dvec2(p) + 0.5));  // few samples miss some pixels
  }
  return picture;
}

/// Root mean square of the differences of two pictures.
inline double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

/// One pattern: a pixel's samples and their spectrum above the picture, in cells.
class Column {
 public:
  static constexpr int reach = 11, side = 2 * reach + 1, gap = 2, foot = 6;
  static constexpr ChequeredPlane plane{};
  static constexpr ivec2 period{24, 18}, size{plane.size.x, side + gap + plane.size.y + foot};

  explicit Column(const Fill& fill, std::uint64_t seed) : samples_(fill(period, Random(seed))) {
    for (std::uint64_t i = 0; i < 32; ++i) spectrum_.add(fill({2, 2}, Random(seed, i + 1)));
    picture_ = picture_of(plane, period, samples_);
  }

  const std::vector<double>& picture() const { return picture_; }
  double samples_per_pixel() const {
    return std::round(10 * double(samples_.size()) / (period.x * period.y)) / 10;
  }

  static void frame(PictureShelf& shelf, std::size_t k) {
    const auto box = [&](std::string_view id, ivec2 corner, ivec2 extent) {
      const Extent place{shelf.on_paper(k, dvec2(corner)), shelf.on_paper(k, dvec2(corner + extent))};
      shelf.mark(k, id, Role::past, Path{place.corners(), true});
    };
    box("a pixel", {0, 0}, ivec2(side));
    box("a spectrum", spectrum_at, ivec2(side));
    box("a picture", picture_at, plane.size);
  }
  void dot(PictureShelf& shelf, std::size_t k) const {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i].x < 1 && samples_[i].y < 1)
        shelf.mark(k, fmt::format("s {:04}", i), Role::result,
                   Dot{shelf.on_paper(k, double{side} * samples_[i])});
    }
  }
  std::optional<Rgba8> tone(ivec2 p) const {
    if (Window{picture_at, picture_at + plane.size - 1}.contains(p)) {
      const ivec2 q = p - picture_at;
      return tone_of(picture_[static_cast<std::size_t>(q.y * plane.size.x + q.x)]);
    }
    if (Window{spectrum_at, spectrum_at + side - 1}.contains(p)) return spectrum_.tone(p - spectrum_at);
    return std::nullopt;
  }

 private:
  static constexpr ivec2 spectrum_at{side + gap, 0}, picture_at{0, side + gap};

  std::vector<dvec2> samples_;
  std::vector<double> picture_;
  Spectrum spectrum_{reach};
};

inline void tell_pictures(Narrator& narrator) {
  const Words& words = narrator.words();
  const Arguments& given = narrator.arguments();
  const double radius = *given.number("radius");
  if (!(radius >= 0.1 && radius <= 0.5))
    refuse("radius", "expected 0.1 to 0.5 of a pixel for pictures, found {}", given.text("radius"));
  const auto seed = static_cast<std::uint64_t>(given.integer("seed"));
  const Fill fill = discs(radius);
  const Column discs_shown(fill, seed);
  const double n = discs_shown.samples_per_pixel();
  const int side = std::max(1, static_cast<int>(std::round(std::sqrt(n))));
  const std::array columns{Column(grid_of(side), seed), Column(independent(n), seed), discs_shown};
  constexpr std::array<std::string_view, 3> told{"pictures.grid", "pictures.independent", "pictures.discs"};
  const std::vector names{words.say("short.grid"), words.say("short.independent"), words.say("short.discs")};
  narrator.trace().subtitle =
      words.say("pictures.subtitle", {{"radius", radius}, {"seed", given.integer("seed")}});
  narrator.columns({{"pattern", false}, {"per_pixel"}, {"off"}});
  PictureShelf shelf(narrator, {.size = Column::size, .names = names, .gap = 3, .heading = 7});
  for (std::size_t k = 0; k < names.size(); ++k) Column::frame(shelf, k);
  const dvec2 foot{0.5 * Column::size.x, Column::size.y - 0.4 * Column::foot};
  shelf.mark(1, "foot", Role::guide, Text{shelf.on_paper(1, foot), words.say("pictures.foot")});
  shelf.start({.text = "pictures.started", .words = {{"n", n}}});
  const std::vector<double> truth =
      picture_of(Column::plane, Column::period, grid_of(24)(Column::period, Random(0)));
  LineOf<Tried> tried;
  bridson({dvec2(1), true}, radius, 1, Random(seed), [](dvec2) {}, tried);
  std::array<double, 3> off{};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Column& column = columns[k];
    off[k] = difference(column.picture(), truth);
    column.dot(shelf, k);
    shelf.show("PictureTaken", k == 2 ? tried.line : 0, [&](ivec2 p) { return column.tone(p); },
               {.text = told[k],
                .facts = {{"per_pixel", column.samples_per_pixel()}, {"off", off[k]}},
                .words = {{"radius", radius}, {"independent", off[1]}},
                .row = {names[k], column.samples_per_pixel(), off[k]},
                .key = std::string(told[k].substr(told[k].find('.') + 1)),
                .phase = names[k]});
  }
  shelf.finish({.text = "pictures.finished",
                .words = {{"n", n}, {"grid", off[0]}, {"independent", off[1]}, {"discs", off[2]}}});
  narrator.result({{"off", off[2]}});
}

}  // namespace gradus::poisson_disc
