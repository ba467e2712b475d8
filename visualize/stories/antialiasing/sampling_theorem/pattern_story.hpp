#pragma once
// Pictures of test patterns: from few samples per pixel beside the mean over the pixel, and four artefacts in
// a row.

#include "antialiasing/sampling_theorem/test_patterns.hpp"
#include "core/geometry.hpp"
#include "figure/tone_of.hpp"
#include "stories/telling.hpp"

namespace gradus::sampling_theorem {

using Grey = std::vector<double>;  // the light of pixels, row by row

template <class Pattern>
Grey grey_of_pattern(const Pattern& pattern, ivec2 size, int n) {
  Grey picture;
  picture_of(pattern, size, n, [&](ivec2, double value) { picture.push_back(value); });
  return picture;
}

inline double mean_difference(const Grey& a, const Grey& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return std::round(sum / static_cast<double>(a.size()) * 1e4) / 1e4;
}

/// A picture on the paper, whose units are its pixels.
inline void put_picture(View& view, const Grey& picture, ivec2 size, ivec2 corner) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const double value = picture[static_cast<std::size_t>(y * size.x + x)];
      view.cells.insert_or_assign({y + corner.y, x + corner.x}, CellLook{Role::result, "", tone_of(value)});
    }
  }
}
inline Path frame_of(ivec2 size, ivec2 corner) {
  const dvec2 a = dvec2(corner) - 0.5, s(size);
  return {{a, a + dvec2{s.x, 0}, a + s, a + dvec2{0, s.y}}, true};
}
inline void lay_pictures(Narrator& narrator, ivec2 size) { narrator.whole_grid({{0, 0}, size - 1}); }

// --- One pattern, with more and more samples --------------------------------------------------------------

/// A picture has been taken, with n x n samples per pixel.
struct PictureTaken {
  int n;
  Grey picture;
  double limit;  ///< pixels from the centre, or rows below the horizon, where samples get too few
};

/// What is drawn of the limit in a picture, in its own places.
using Limit = std::function<std::vector<dvec2>(double limit)>;

class PatternStory {
 public:
  PatternStory(const Words& words, std::string name, ivec2 size, Grey right, Limit limit)
      : words_(words),
        name_(std::move(name)),
        size_(size),
        right_(std::move(right)),
        limit_(std::move(limit)) {}

  ivec2 paper() const { return {2 * size_.x + gap() + 2, size_.y + heading() + 1}; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    const bool zone = name_ == "zone";
    return {.text = zone ? "zone.started" : "board.started",
            .words = {{"columns", size_.x}, {"rows", size_.y}}};
  }
  void show(Board& board, const PictureTaken& p) {
    taken_ = p;
    off_.push_back(mean_difference(p.picture, right_));
    put(board);
  }
  Event say(const PictureTaken& p) const {
    const bool zone = name_ == "zone", holds = zone && p.limit > length_of(dvec2(0.5 * size_.x)) + 1;
    Event event{.text = holds  ? "zone.holds"
                        : zone ? (p.n == 1 ? "zone.one" : "zone.more")
                               : (p.n == 1 ? "board.one" : "board.more"),
                .facts = {{"n", p.n}, {"limit", p.limit}, {"off", off_.back()}},
                .words = {{"samples", fmt::format("{0} × {0}", p.n)},
                          {"limit", std::round(p.limit * 100) / 100},
                          {"centres", 2 * p.limit},
                          {"half", 0.5 * p.n},
                          {"before", off_.size() > 1 ? off_[off_.size() - 2] : 0}},
                .row = {p.n * p.n, std::round(p.limit * 100) / 100, off_.back()},
                .key = fmt::format("{}", p.n),
                .phase = words_.say("phase.pictures")};
    return event;
  }
  double off() const { return off_.back(); }

 private:
  int gap() const { return std::max(2, size_.x / 16); }
  int heading() const { return std::max(4, size_.y / 6); }
  ivec2 corner(int which) const { return {1 + which * (size_.x + gap()), heading()}; }
  void put(Board& board) const {
    View view;
    put_picture(view, right_, size_, corner(1));
    view.add({"a mean", Role::guide, Text{name_at(1), words_.say("mean")}});
    view.add({"b frame", Role::past, frame_of(size_, corner(0))});
    view.add({"b frame mean", Role::past, frame_of(size_, corner(1))});
    const std::string samples =
        taken_ ? words_.counted("per_pixel", taken_->n * taken_->n, {}) : words_.say("no_samples");
    view.add({"a samples", Role::guide, Text{name_at(0), samples}});
    if (taken_) {
      put_picture(view, taken_->picture, size_, corner(0));
      Path path;
      for (const dvec2 p : limit_(taken_->limit)) path.points.push_back(dvec2(corner(0)) + p - 0.5);
      if (path.points.size() > 1) view.add({"c limit", Role::measure, path});
    }
    board.milestone(std::move(view));
  }
  dvec2 name_at(int which) const {
    return dvec2(corner(which)) + dvec2{0.5 * size_.x - 0.5, -0.5 * heading() - 0.2};
  }

  const Words& words_;
  const std::string name_;
  const ivec2 size_;
  const Grey right_;
  const Limit limit_;
  std::optional<PictureTaken> taken_{};
  std::vector<double> off_{};
};

template <class Pattern, class LimitOf>
void tell_pattern(Narrator& narrator, const std::string& name, const Pattern& pattern, ivec2 size,
                  const LimitOf& limit_of, const Limit& limit) {
  PatternStory story(narrator.words(), name, size, grey_of_pattern(pattern, size, 16), limit);
  lay_pictures(narrator, story.paper());
  narrator.columns({{"samples"}, {"limit"}, {"off"}});
  narrator.legend({{Role::measure, name + "_limit"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (const int n : {1, 2, 4}) watch(PictureTaken{n, grey_of_pattern(pattern, size, n), limit_of(n)}, 0);
  narrator.telling({1, 0});
  narrator.result({{"off", story.off()}});
}

inline void tell_zone_plate(Narrator& narrator) {
  narrator.list("rings");
  narrator.list_below("pixel_of");
  const Arguments& given = narrator.arguments();
  const int side = static_cast<int>(given.integer("pixels"));
  const double distance = *given.number("distance");
  if (!(distance > 0)) refuse("distance", "expected a number above 0, found {}", distance);
  const ivec2 size(side);
  const dvec2 middle = dvec2(side / 2) + 0.5;  // a pixel has the true centre
  narrator.subtitle("subtitle.zone", {{"columns", side}, {"distance", distance}});
  const auto circle = [=](double limit) {
    std::vector<dvec2> points;
    if (limit > 0.5 * side) return points;
    for (int i = 0; i <= 96; ++i) {
      const SinCos way = sin_cos_half_turns(i / 48.0);
      points.push_back(middle + limit * dvec2{way.cos, way.sin});
    }
    return points;
  };
  tell_pattern(
      narrator, "zone", ZonePlate{middle, distance}, size, [=](int n) { return 0.5 * n * distance; }, circle);
}

inline void tell_chequerboard(Narrator& narrator) {
  narrator.list("squares");
  narrator.list_below("pixel_of");
  const Arguments& given = narrator.arguments();
  const int side = static_cast<int>(given.integer("pixels"));
  const double square = *given.number("square");
  if (!(square > 0)) refuse("square", "expected a number above 0, found {}", square);
  const ivec2 size(side);
  const Chequerboard board{{0.5 * side, std::floor(side / 8.0)}, static_cast<double>(side), square};
  narrator.subtitle("subtitle.board", {{"columns", side}, {"square", square}});
  const auto row = [=](double limit) {
    const double y = board.vanishing.y + limit;
    if (y > side) return std::vector<dvec2>{};
    return std::vector<dvec2>{{0, y}, {static_cast<double>(side), y}};
  };
  tell_pattern(
      narrator, "board", board, size, [=](int n) { return board.finest() / gradus::sqrt(double(n)); }, row);
}

// --- Four artefacts ---------------------------------------------------------------------------------------

/// One of the patterns has been sampled.
struct ArtefactShown {
  std::size_t which;
  Grey sampled, mean;
  double is, looks;  ///< what is measured: in the pattern, and in its samples
};

class ArtefactStory {
 public:
  explicit ArtefactStory(const Words& words) : words_(words) {}

  static constexpr ivec2 size{24, 24};
  static ivec2 paper() { return {4 * size.x + 3 * gap + 2, 2 * size.y + 2 * heading + 1}; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    return {.text = "artefacts.started", .words = {{"columns", size.x}, {"rows", size.y}}};
  }
  void show(Board& board, const ArtefactShown& a) {
    done_.push_back(a);
    put(board);
  }
  Event say(const ArtefactShown& a) const {
    constexpr std::array<std::string_view, 4> texts{"artefacts.edge", "artefacts.bars", "artefacts.line",
                                                    "artefacts.wave"};
    return {.text = texts[a.which],
            .facts = {{"is", a.is}, {"looks", a.looks}},
            .row = {name(a.which), a.is, a.looks},
            .key = std::string(texts[a.which].substr(10)),
            .phase = words_.say("phase.pictures")};
  }

 private:
  static constexpr int gap = 3, heading = 9;

  std::string name(std::size_t which) const {
    constexpr std::array<std::string_view, 4> keys{"artefact.edge", "artefact.bars", "artefact.line",
                                                   "artefact.wave"};
    return words_.say(keys[which]);
  }
  static ivec2 corner(std::size_t which, int row) {
    return {1 + static_cast<int>(which) * (size.x + gap), heading + row * (size.y + heading)};
  }
  void put(Board& board) const {
    View view;
    for (std::size_t i = 0; i < 4; ++i) {
      for (const int row : {0, 1}) {
        const std::string id = fmt::format("{} {}", i, row);
        view.add({"a frame " + id, Role::past, frame_of(size, corner(i, row))});
      }
      view.add({fmt::format("b name {}", i), Role::guide,
                Text{dvec2(corner(i, 0)) + dvec2{0.5 * size.x - 0.5, -0.5 * heading}, name(i)}});
    }
    const double middle = 0.5 * paper().x - 0.5;
    view.add(
        {"b mean", Role::guide, Text{{middle, corner(0, 1).y - 0.5 * heading}, words_.say("mean_below")}});
    for (const ArtefactShown& a : done_) {
      put_picture(view, a.sampled, size, corner(a.which, 0));
      put_picture(view, a.mean, size, corner(a.which, 1));
    }
    board.milestone(std::move(view));
  }

  const Words& words_;
  std::vector<ArtefactShown> done_{};
};

/// Rows of black pixels that hang together, counted row by row.
inline std::int64_t runs_of(const Grey& picture, ivec2 size, int rows) {
  std::int64_t runs = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto at = static_cast<std::size_t>(y * size.x + x);
      runs += picture[at] == 0 && (x == 0 || picture[at - 1] > 0);
    }
  }
  return runs;
}
/// How often the height of a black ground changes from column to column.
inline std::int64_t steps_of(const Grey& picture, ivec2 size) {
  std::int64_t steps = 0;
  for (int x = 0; x + 1 < size.x; ++x) {
    const auto height = [&](int column) {
      int y = 0;
      while (y < size.y && picture[static_cast<std::size_t>(y * size.x + column)] > 0) ++y;
      return y;
    };
    steps += height(x) != height(x + 1);
  }
  return steps;
}

inline void tell_artefacts(Narrator& narrator) {
  const ivec2 size = ArtefactStory::size;
  const HalfPlane edge{10.25, 1 / 6.0};
  const Bars bars{2.25, 0.25, 0.125};
  const ThinLine line{10.53, 0.125, 0.5 / gradus::sqrt(1 + 0.125 * 0.125)};
  const Grating wave{{0.9, 0.05}};
  lay_pictures(narrator, ArtefactStory::paper());
  narrator.subtitle("subtitle.artefacts", {{"columns", size.x}, {"rows", size.y}});
  narrator.columns({{"artefact", false}, {"is"}, {"looks"}});
  ArtefactStory story(narrator.words());
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Grey jagged = grey_of_pattern(edge, size, 1), lost = grey_of_pattern(bars, size, 1),
             pieces = grey_of_pattern(line, size, 1);
  watch(ArtefactShown{0, jagged, grey_of_pattern(edge, size, 16), 0,
                      static_cast<double>(steps_of(jagged, size))},
        0);
  watch(
      ArtefactShown{1, lost, grey_of_pattern(bars, size, 16), std::ceil((size.x - bars.first) / bars.period),
                    static_cast<double>(runs_of(lost, size, 1))},
      0);
  watch(ArtefactShown{2, pieces, grey_of_pattern(line, size, 16), 1,
                      static_cast<double>(runs_of(pieces, size, size.y))},
        0);
  const auto period = [](dvec2 f) { return std::round(100 / length_of(f)) / 100; };
  watch(ArtefactShown{3, grey_of_pattern(wave, size, 1), grey_of_pattern(wave, size, 16),
                      period(wave.frequency), period(wave.alias().frequency)},
        0);
  narrator.telling({4, 0});
  narrator.result({{"steps", steps_of(jagged, size)}, {"pieces", runs_of(pieces, size, size.y)}});
}

}  // namespace gradus::sampling_theorem
