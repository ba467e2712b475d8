#pragma once
// A star of thin triangles by one sample a pixel and by an A-buffer, magnified below, with what the lists
// take.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "antialiasing/a_buffer/a_buffer_picture.hpp"
#include "core/arithmetic/elementary.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/a_buffer_drawing.hpp"

namespace gradus::a_buffer {

/// A picture is there.
struct PictureDrawn {
  bool with_masks;
  std::vector<double> greys;
  Memory memory;
  std::int64_t seen = 0;  ///< pixels that show something
};

/// Thin triangles round the middle, and a large one behind them.
inline std::vector<ScreenTriangle> star_of(int side) {
  std::vector<ScreenTriangle> star;
  const dvec2 middle(0.5 * side);
  constexpr int spikes = 22;
  for (int i = 0; i < spikes; ++i) {
    const double angle = 2 * 3.14159265358979323846 * (i + 0.3) / spikes;
    const dvec2 way{cos(angle), sin(angle)}, aside{-way.y, way.x};
    const dvec2 tip = middle + 0.48 * side * way, foot = middle + 0.08 * side * way;
    const auto snap = [](dvec2 p) { return triangle_coverage::snap(p); };
    star.push_back({{snap(tip), snap(foot + 0.011 * side * aside), snap(foot - 0.011 * side * aside)},
                    dvec3(0.1 + 0.01 * i)});
  }
  return star;
}

class PicturesStory {
 public:
  static constexpr int gap = 3, heading = 4;
  static constexpr Rgba8 ink{0, 0, 0, 255};

  PicturesStory(const Words& words, int side)
      : words_(words), side_(side), crop_(side / 3), zoom_(side / crop_) {}

  Window paper() const { return {{0, 0}, {2 * side_ + gap + 1, heading + 2 * side_ + gap}}; }

  void show(Board& board, const steps::Started&) {
    for (int i = 0; i < 2; ++i) {
      const dvec2 at = dvec2(corner(i)) + dvec2{0.5 * side_ - 0.5, -2.2};
      base_.add(
          {fmt::format("t {}", i), Role::guide, Text{at, words_.say(i == 0 ? "short.one" : "short.masks")}});
    }
    board.milestone(base_);
  }
  Event say(const steps::Started&) const { return {.text = "pictures.started", .words = {{"side", side_}}}; }

  void show(Board& board, const PictureDrawn& p) {
    seen_[p.with_masks] = p.seen;
    const ivec2 from = corner(p.with_masks ? 1 : 0), below = from + ivec2{0, side_ + gap};
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        put(from + ivec2{x, y}, grey(p, {x, y}));
        if (y < crop_ * zoom_ && x < crop_ * zoom_)
          put(below + ivec2{x, y}, grey(p, first() + ivec2{x, y} / zoom_));
      }
    }
    const dvec2 lower = dvec2(from + first()) - 0.5, upper = lower + double(crop_);
    const dvec2 frame = dvec2(below) - 0.5, end = frame + double(crop_ * zoom_);
    base_.add({p.with_masks ? "u 1" : "u 0", Role::current,
               Path{{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}, true}});
    base_.add({p.with_masks ? "v 1" : "v 0", Role::current,
               Path{{frame, {end.x, frame.y}, end, {frame.x, end.y}}, true}});
    board.milestone(base_);
  }
  Event say(const PictureDrawn& p) const {
    if (!p.with_masks)
      return {.text = "pictures.one", .row = {words_.say("short.one"), p.seen, "", ""}, .key = "one"};
    const Memory& m = p.memory;
    return {.text = "pictures.masks",
            .facts = {{"pixels", m.pixels},
                      {"fragments", m.fragments},
                      {"mask_bytes", m.mask_bytes},
                      {"bytes", m.bytes}},
            .words = {{"longest", m.longest}},
            .row = {words_.say("short.masks"), p.seen, m.fragments, m.mask_bytes},
            .key = "masks"};
  }
  void show(Board& board, const steps::Finished&) { board.milestone(base_); }
  Event say(const steps::Finished&) const {
    return {.text = "pictures.finished", .words = {{"one", seen_[0]}, {"masks", seen_[1]}}};
  }

 private:
  ivec2 corner(int i) const { return {1 + i * (side_ + gap), heading}; }
  ivec2 first() const { return ivec2(side_ / 2, side_ / 8); }
  double grey(const PictureDrawn& p, ivec2 at) const {
    return p.greys[static_cast<std::size_t>(at.y * side_ + at.x)];
  }
  void put(ivec2 cell, double share) {
    base_.cells.insert_or_assign({cell.y, cell.x}, CellLook{Role::result, "", tone_on_paper(ink, share)});
  }

  const Words& words_;
  const int side_, crop_, zoom_;
  View base_{};
  std::array<std::int64_t, 2> seen_{};
};

inline void tell_pictures(Narrator& narrator) {
  const int side = static_cast<int>(narrator.arguments().integer("columns"));
  const std::vector<ScreenTriangle> star = star_of(side);
  const Window window{{0, 0}, {side - 1, side - 1}};
  PicturesStory story(narrator.words(), side);
  narrator.grid(story.paper());
  narrator.trace().grid.whole = true;
  narrator.trace().grid.axes = false;
  narrator.trace().grid.y_up = false;
  narrator.trace().subtitle = narrator.words().say("pictures.subtitle", {{"side", side}});
  narrator.columns({{"way", false}, {"pixels"}, {"fragments"}, {"bytes"}});
  narrator.legend({{Role::current, "crop"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  PictureDrawn one{false, std::vector<double>(static_cast<std::size_t>(side * side)), {}};
  PictureDrawn masks{true, one.greys, {}};
  const auto count_seen = [](PictureDrawn& p) {
    p.seen = std::ranges::count_if(p.greys, [](double grey) { return grey > 0; });
  };
  const auto index = [side](ivec2 p) { return static_cast<std::size_t>(p.y * side + p.x); };
  for (const ScreenTriangle& t : star)
    triangle_coverage::cover(t.corners, window, [&](ivec2 p, const Weights&) { one.greys[index(p)] = 1; });
  count_seen(one);
  watch(one, 0);
  masks.memory = a_buffer(
      std::span<const ScreenTriangle>(star), window, [](int, ivec2, const Weights&) { return 1.0; },
      [&](ivec2 p, double sum, double) { masks.greys[index(p)] = sum; });
  count_seen(masks);
  watch(masks, narrator.last_line());
  watch(steps::Finished{}, 0);
  narrator.telling({2, 0});
  narrator.result({{"fragments", masks.memory.fragments}, {"mask_bytes", masks.memory.mask_bytes}});
}

}  // namespace gradus::a_buffer
