#pragma once
// The same star of lines by four methods, beside each other; and one line, continued.

#include "core/raster.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/scan_conversion/antialiased_line/drawing.hpp"

namespace gradus::antialiased_line {

enum class Drawn : std::size_t { bresenham, wu, gupta_sproull, exact_area };
inline constexpr std::array<std::string_view, 4> method_keys{"bresenham", "wu", "gupta_sproull",
                                                             "exact_area"};

/// Draws a line by one of the methods: plot(pixel, intensity).
template <class Plot>
void draw_by(Drawn method, ivec2 from, ivec2 to, const Plot& plot) {
  switch (method) {
    case Drawn::bresenham:
      return bresenham_line::decision_parameter(from, to, [&](ivec2 p) { plot(p, full); });
    case Drawn::wu:
      return wu(from, to, plot);
    case Drawn::gupta_sproull:
      return gupta_sproull(from, to, plot);
    case Drawn::exact_area:
      return exact_area(from, to, [&](ivec2 p, double area) { plot(p, byte_of(area)); });
  }
}

/// The source line at which a method tells of a pixel; 0 for Bresenham's, whose source is another file.
inline int telling_line(Drawn method) {
  const ivec2 from{0, 0}, to{5, 2};
  const auto drop = [](ivec2, auto) {};
  LineOf<Paired> paired;
  LineOf<Measured> measured;
  LineOf<Cut> cut;
  switch (method) {
    case Drawn::bresenham:
      return 0;
    case Drawn::wu:
      wu(from, to, drop, paired);
      return paired.line;
    case Drawn::gupta_sproull:
      gupta_sproull(from, to, drop, measured);
      return measured.line;
    case Drawn::exact_area:
      exact_area(from, to, drop, cut);
      return cut.line;
  }
  return 0;
}

/// What a line that goes on for ever in this direction has of ink per unit of length, where 1 is full width.
inline double ink_of(Drawn method, ivec2 way) {
  const auto sum_of = [&](int times) {
    std::int64_t sum = 0;
    draw_by(method, {0, 0}, times * way, [&](ivec2, int intensity) { sum += intensity; });
    return static_cast<double>(sum);
  };
  return (sum_of(200) - sum_of(100)) / (100 * length_of(extent({0, 0}, way)) * full);
}

/// Four lines, each turned by quarters about the middle of a picture: how much ink its pixels get, row 0
/// below.
inline Raster<int> star_by(Drawn method, int reach) {
  constexpr std::array<Segment<2, int>, 4> lines{
      {{{3, 0}, {11, 0}}, {{4, 2}, {11, 5}}, {{3, 3}, {9, 9}}, {{1, 4}, {4, 11}}}};
  const auto turned = [](ivec2 p, int quarters) {
    for (; quarters > 0; --quarters) p = {-p.y, p.x};
    return p;
  };
  Raster<int> picture(2 * reach + 1, 2 * reach + 1, none);
  for (const Segment<2, int>& line : lines) {
    for (int turn = 0; turn < 4; ++turn) {
      draw_by(method, turned(line.a, turn), turned(line.b, turn),
              [&](ivec2 p, int intensity) { picture[p + reach] += intensity; });
    }
  }
  return picture;
}

inline std::vector<std::string> names_of_methods(Narrator& narrator) {
  for (const std::string_view below : {"gupta_sproull", "exact_area"}) narrator.list_below(below);
  std::vector<std::string> names;
  for (const std::string_view key : method_keys)
    names.push_back(narrator.words().say(fmt::format("name.{}", key)));
  return names;
}

inline void tell_pictures(Narrator& narrator) {
  constexpr int reach = 12;
  constexpr std::array<std::string_view, 4> texts{"pictures.bresenham", "pictures.wu",
                                                  "pictures.gupta_sproull", "pictures.exact_area"};
  narrator.subtitle("pictures.subtitle", {});
  narrator.columns({{"method", false}, {"level"}, {"diagonal"}});
  const std::vector<std::string> names = names_of_methods(narrator);
  PictureShelf shelf(narrator, {.size = ivec2(2 * reach + 1), .names = names, .row = 2, .y_up = true});
  for (std::size_t m = 0; m < 4; ++m) shelf.wait(m);
  shelf.start({.text = "pictures.started"});
  for (std::size_t m = 0; m < 4; ++m) {
    const auto method = static_cast<Drawn>(m);
    const double level = ink_of(method, {1, 0}), diagonal = ink_of(method, {1, 1});
    const Raster<int> star = star_by(method, reach);
    shelf.show("PictureDrawn", telling_line(method),
               [&](ivec2 p) { return paint_of(std::min(star[p], full)); },
               {.text = texts[m],
                .facts = {{"level", level}, {"diagonal", diagonal}},
                .row = {names[m], level, diagonal},
                .key = std::string(method_keys[m]),
                .phase = names[m]});
  }
  shelf.finish({.text = "pictures.finished"});
  narrator.result(
      {{"wu_diagonal", ink_of(Drawn::wu, {1, 1})}, {"area_diagonal", ink_of(Drawn::exact_area, {1, 1})}});
}

/// The line that was asked for, going on until its pixels are as small as on a screen.
inline void tell_continued(Narrator& narrator) {
  constexpr int columns = 48;
  constexpr std::array<std::string_view, 4> texts{"continued.bresenham", "continued.wu",
                                                  "continued.gupta_sproull", "continued.exact_area"};
  const Subject subject = subject_of(narrator.arguments(), false);
  if (subject.point()) refuse("to", "expected another pixel than the first");
  const ivec2 way = subject.to - subject.from;
  const auto times = std::max(1, columns / static_cast<int>(subject.size.dx));
  const Window line = window_around({0, 0}, times * way);
  const ivec2 size = line.upper - line.lower + 3;
  const int row = size.y > size.x ? 4 : 2;
  narrator.subtitle("subtitle", {{"from", subject.from}, {"to", subject.to}});
  narrator.columns({{"method", false}, {"ink"}});
  const std::vector<std::string> names = names_of_methods(narrator);
  PictureShelf shelf(
      narrator, {.size = size, .names = names, .row = row, .heading = 1 + row * size.x / 16, .y_up = true});
  for (std::size_t m = 0; m < 4; ++m) shelf.wait(m);
  shelf.start({.text = "continued.started", .count = times});
  for (std::size_t m = 0; m < 4; ++m) {
    const auto method = static_cast<Drawn>(m);
    const double ink = ink_of(method, way) / ink_of(method, {1, 0});
    Raster<int> picture(size.x, size.y, none);
    draw_by(method, ivec2(1) - line.lower, ivec2(1) - line.lower + times * way,
            [&](ivec2 p, int intensity) { picture[p] += intensity; });
    shelf.show("PictureDrawn", telling_line(method),
               [&](ivec2 p) { return paint_of(std::min(picture[p], full)); },
               {.text = texts[m],
                .facts = {{"ink", ink}},
                .row = {names[m], ink},
                .key = std::string(method_keys[m]),
                .phase = names[m]});
  }
  shelf.finish({.text = "continued.finished"});
  narrator.result({{"wu", ink_of(Drawn::wu, way)}, {"exact_area", ink_of(Drawn::exact_area, way)}});
}

}  // namespace gradus::antialiased_line
