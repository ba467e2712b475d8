#pragma once
// A thin triangle that moves by parts of a pixel: what centres of pixels show of it, and what areas show.

#include "stories/antialiasing/area_sampling/subject.hpp"

namespace gradus::area_sampling {

/// The triangle was drawn both ways at one of its places.
struct PlaceDrawn {
  double shift;  ///< down, in pixels
  std::int64_t centres;
  double area;
};

class MovingStory {
 public:
  static constexpr int places = 4;

  MovingStory(const Words& words, std::vector<ivec2> corners) : words_(words), corners_(std::move(corners)) {
    const Window box = pixels_in(corners_, {{-farthest, -farthest}, {farthest - 1, farthest - 1}});
    first_ = box.lower;
    size_ = box.upper - box.lower + ivec2{1, 2};
  }

  ivec2 size() const { return size_; }
  Window paper() const { return {{0, 0}, {2 * size_.x + gap + 1, heading + places * (size_.y + 1)}}; }
  /// The source line that measures a pixel.
  int line() const { return measured_.line; }
  std::int64_t fewest() const { return fewest_; }
  double area() const { return area_; }

  /// Draws the triangle at a place.
  PlaceDrawn draw(int number) {
    const int down = number * subpixels / places;
    std::vector<ivec2> moved = corners_;
    for (ivec2& p : moved) p.y += down;
    const Window window{first_, first_ + size_ - 1};
    PlaceDrawn drawn{static_cast<double>(down) / subpixels, 0, 0};
    const triangle_coverage::Triangle t{moved[0], moved[1], moved[2]};
    triangle_coverage::cover(t, window, [&](ivec2 p, const Weights&) {
      put(0, number, p, 1);
      ++drawn.centres;
    });
    const auto add = [&](ivec2 p, double area) {
      put(1, number, p, area);
      drawn.area += area;
    };
    pixel_areas(moved, window, add, measured_);
    for (int panel = 0; panel < 2; ++panel) {
      Path path{{}, true};
      for (const ivec2 p : moved)
        path.points.push_back(dvec2(corner(panel, number) - first_) + in_pixels(dvec2(p)) - 0.5);
      base_.add({fmt::format("o {} {}", panel, number), Role::input, path});
    }
    fewest_ = std::min(fewest_, drawn.centres);
    area_ = drawn.area;
    return drawn;
  }

  void show(Board& board, const steps::Started&) {
    for (int panel = 0; panel < 2; ++panel) {
      const dvec2 at = dvec2(corner(panel, 0)) + dvec2{0.5 * size_.x - 0.5, -1.4};
      base_.add(
          {fmt::format("t {}", panel), Role::guide, Text{at, words_.say(panel == 0 ? "centres" : "areas")}});
      for (int k = 0; k < places; ++k) {
        const dvec2 a = dvec2(corner(panel, k)) - 0.5;
        base_.add({fmt::format("f {} {}", panel, k), Role::past,
                   Path{Extent{a, a + dvec2(size_)}.corners(), true}});
      }
    }
    board.milestone(base_);
  }
  Event say(const steps::Started&) const { return {.text = "moving.started", .words = {{"places", places}}}; }

  void show(Board& board, const PlaceDrawn&) { board.milestone(base_); }
  Event say(const PlaceDrawn& d) const {
    Event event{.text = d.centres == 0 ? "moving.lost" : "moving.drawn",
                .facts = {{"shift", d.shift}, {"centres", d.centres}, {"area", d.area}},
                .row = {d.shift, d.centres, d.area},
                .key = figure_real(d.shift),
                .phase = words_.say("phase.moved", {{"shift", d.shift}})};
    if (d.centres > 0) event.count = d.centres;
    return event;
  }
  void show(Board& board, const steps::Finished&) { board.milestone(base_); }
  Event say(const steps::Finished&) const {
    return {.text = "moving.finished", .words = {{"fewest", fewest_}, {"area", area_}}};
  }

 private:
  static constexpr int gap = 2, heading = 3;
  static constexpr Rgba8 ink{38, 38, 38, 255};  // not black: the outline is seen on it

  /// The cell of a panel's first pixel.
  ivec2 corner(int panel, int number) const {
    return {1 + panel * (size_.x + gap), heading + number * (size_.y + 1)};
  }
  void put(int panel, int number, ivec2 pixel, double area) {
    const ivec2 cell = corner(panel, number) + pixel - first_;
    base_.cells.insert_or_assign({cell.y, cell.x}, CellLook{Role::result, "", tone_on_paper(ink, area)});
  }

  const Words& words_;
  const std::vector<ivec2> corners_;
  ivec2 first_{}, size_{};
  View base_{};
  std::int64_t fewest_ = 1'000'000;
  double area_ = 0;
  LineOf<AreaTaken<double>> measured_{};
};

inline void tell_moving(Narrator& narrator) {
  std::vector<ivec2> corners;
  for (const dvec2 p : narrator.arguments().points("thin")) {
    if (!(glm::abs(p.x) <= 1000 && glm::abs(p.y) <= 1000))
      refuse("thin", "expected corners at most 1000 pixels out");
    corners.push_back(snap(p));
  }
  MovingStory story(narrator.words(), corners);
  if (std::max(story.size().x, story.size().y) > 24)
    refuse("thin", "expected a triangle of at most 24 columns and 22 rows");
  narrator.whole_grid(story.paper());
  narrator.subtitle("moving.subtitle", {{"places", MovingStory::places}});
  narrator.trace().goal = narrator.words().say("moving.goal");
  narrator.columns({{"shift"}, {"centres"}, {"covered"}});
  narrator.legend({{Role::input, "outline"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (int k = 0; k < MovingStory::places; ++k) {
    const PlaceDrawn drawn = story.draw(k);
    watch(drawn, story.line());
  }
  watch(steps::Finished{}, 0);
  narrator.telling({MovingStory::places, 0});
  narrator.result({{"fewest", story.fewest()}, {"area", story.area()}});
}

}  // namespace gradus::area_sampling
