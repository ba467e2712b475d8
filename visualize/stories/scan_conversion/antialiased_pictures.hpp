#pragma once
// The same star of lines by four methods, beside each other.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "stories/scan_conversion/antialiased_drawing.hpp"

namespace gradus::antialiased_line {

enum class Drawn : std::size_t { bresenham, wu, gupta_sproull, exact_area };

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

/// What a line that goes on for ever in this direction has of ink a unit of length, where 1 is full width.
inline double ink_of(Drawn method, ivec2 way) {
  const auto sum_of = [&](int times) {
    std::int64_t sum = 0;
    draw_by(method, {0, 0}, times * way, [&](ivec2, int intensity) { sum += intensity; });
    return static_cast<double>(sum);
  };
  return (sum_of(200) - sum_of(100)) / (100 * length_of(extent({0, 0}, way)) * full);
}

/// A picture is done by one of the methods.
struct PictureDrawn {
  Drawn method;
  double level, diagonal;  ///< ink a unit of length
};

class PicturesStory {
 public:
  explicit PicturesStory(const Words& words) : words_(words) {}

  /// Of the drawing, whose units are pixels.
  static Window paper() { return {{0, 0}, {2 * side + gap + 1, 2 * (side + heading) + 1}}; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const { return {.text = "pictures.started"}; }
  void show(Board& board, const PictureDrawn&) {
    ++done_;
    put(board);
  }
  Event say(const PictureDrawn& p) const {
    constexpr std::array<std::string_view, 4> texts{"pictures.bresenham", "pictures.wu",
                                                    "pictures.gupta_sproull", "pictures.exact_area"};
    const auto number = static_cast<std::size_t>(p.method);
    const std::string key(texts[number].substr(9));
    return {.text = texts[number],
            .facts = {{"level", p.level}, {"diagonal", p.diagonal}},
            .words = {{"level", p.level}, {"diagonal", p.diagonal}},
            .row = {name(number), p.level, p.diagonal},
            .key = key,
            .phase = key};
  }
  void show(Board& board, const steps::Finished&) { put(board); }
  Event say(const steps::Finished&) const { return {.text = "pictures.finished"}; }

 private:
  static constexpr int reach = 12, side = 2 * reach + 1, gap = 2, heading = 3;

  std::string name(std::size_t method) const {
    constexpr std::array<std::string_view, 4> keys{"name.bresenham", "name.wu", "name.gupta_sproull",
                                                   "name.exact_area"};
    return words_.say(keys[method]);
  }
  /// Where the middle of a picture is: two a row, the first row above.
  static ivec2 middle_of(std::size_t method) {
    const int column = static_cast<int>(method % 2), row = method < 2 ? 1 : 0;
    return {reach + 1 + column * (side + gap), reach + 1 + row * (side + heading)};
  }
  void put(Board& board) const {
    View view;
    for (std::size_t m = 0; m < 4; ++m) {
      const ivec2 middle = middle_of(m);
      view.add(
          {fmt::format("name {}", m), Role::guide, Text{dvec2(middle) + dvec2(0, reach + 1.8), name(m)}});
      std::map<std::pair<int, int>, int> picture;
      for (int i = 0; i < side * side; ++i) picture[{i / side - reach, i % side - reach}] = none;
      if (m < done_) put_star(picture, static_cast<Drawn>(m));
      for (const auto& [at, intensity] : picture) {
        view.cells.insert_or_assign({at.first + middle.y, at.second + middle.x},
                                    CellLook{Role::result, "", paint_of(std::min(intensity, full))});
      }
    }
    board.milestone(std::move(view));
  }
  /// Four lines, each turned by quarters about the middle.
  static void put_star(std::map<std::pair<int, int>, int>& picture, Drawn method) {
    constexpr std::array<Segment<2, int>, 4> lines{
        {{{3, 0}, {11, 0}}, {{4, 2}, {11, 5}}, {{3, 3}, {9, 9}}, {{1, 4}, {4, 11}}}};
    for (const Segment<2, int>& line : lines) {
      for (int turn = 0; turn < 4; ++turn) {
        draw_by(method, turned(line.a, turn), turned(line.b, turn),
                [&](ivec2 p, int intensity) { picture[{p.y, p.x}] += intensity; });
      }
    }
  }
  static ivec2 turned(ivec2 p, int quarters) {
    for (; quarters > 0; --quarters) p = {-p.y, p.x};
    return p;
  }

  const Words& words_;
  std::size_t done_ = 0;
};

inline void tell_pictures(Narrator& narrator) {
  narrator.trace().subtitle = narrator.words().say("pictures.subtitle");
  narrator.grid(PicturesStory::paper());
  narrator.trace().grid.whole = true;
  narrator.trace().grid.axes = false;
  narrator.columns({{"method", false}, {"level"}, {"diagonal"}});
  for (const std::string_view below : {"gupta_sproull", "exact_area"}) narrator.list_below(below);
  PicturesStory story(narrator.words());
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (std::size_t m = 0; m < 4; ++m) {
    const auto method = static_cast<Drawn>(m);
    watch(PictureDrawn{method, ink_of(method, {1, 0}), ink_of(method, {1, 1})}, telling_line(method));
  }
  watch(steps::Finished{}, 0);
  narrator.telling({4, 0});
  narrator.result(
      {{"wu_diagonal", ink_of(Drawn::wu, {1, 1})}, {"area_diagonal", ink_of(Drawn::exact_area, {1, 1})}});
}

}  // namespace gradus::antialiased_line
