#pragma once
// A white polygon on black: 255 times the area taken for a tone, beside the tone of that much light.

#include "antialiasing/area_sampling/area_sampling_notes.hpp"
#include "stories/antialiasing/area_sampling/subject.hpp"

namespace gradus::area_sampling {

class TonesStory {
 public:
  static constexpr int gap = 2, heading = 2;

  TonesStory(const Words& words, const Window& window)
      : words_(words), window_(window), size_(window.upper - window.lower + 1) {}

  Window paper() const { return {{0, 0}, {2 * size_.x + gap + 1, heading + size_.y}}; }
  dvec2 on_paper(int panel, dvec2 place) const { return dvec2(corner(panel)) + place; }
  double sum() const { return sum_; }
  double shown() const { return shown_; }
  /// The pixel whose tone is farthest off.

  void show(Board& board, const steps::Started&) {
    for (const int panel : {0, 1}) {
      const dvec2 a = on_paper(panel, dvec2(-0.5)), s(size_);
      base_.add({fmt::format("f {}", panel), Role::boundary, Path{Extent{a, a + s}.corners(), true}});
      base_.add({fmt::format("t {}", panel), Role::guide,
                 Text{a + dvec2{0.5 * s.x, -0.7}, words_.say(panel == 0 ? "tones.wrong" : "tones.right")}});
      for (int y = 0; y < size_.y; ++y) {
        for (int x = 0; x < size_.x; ++x) put(panel, window_.lower + ivec2{x, y}, tone_of(0), "");
      }
    }
    board.milestone(base_);
  }
  Event say(const steps::Started&) const {
    return {.text = "tones.started", .words = {{"columns", size_.x}, {"rows", size_.y}}};
  }

  void show(Board& board, const ToneTaken& t) {
    sum_ += t.area;
    shown_ += light_of(t.tone);
    board.tells(right_of(t) - t.tone);
    const auto level = static_cast<std::uint8_t>(t.tone);
    put(0, t.pixel, Rgba8{level, level, level, 255}, figure_number(t.tone));
    put(1, t.pixel, tone_of(t.area), figure_number(right_of(t)));
    View view = base_;
    for (const int panel : {0, 1}) {
      const dvec2 a = on_paper(panel, dvec2(t.pixel - window_.lower) - 0.5);
      view.add({fmt::format("x {}", panel), Role::current, Path{Extent{a, a + 1.0}.corners(), true}});
    }
    board.milestone(std::move(view));
  }
  Event say(const ToneTaken& t) const {
    return {.text = t.tone == right_of(t) ? "tones.same" : "tones.taken",
            .facts = {{"pixel", t.pixel}, {"area", t.area}, {"tone", t.tone}, {"right", right_of(t)}},
            .words = {{"light", light_of(t.tone)}},
            .row = {t.pixel.x, t.pixel.y, t.area, t.tone, light_of(t.tone), right_of(t)},
            .key = pixel_key(t.pixel),
            .phase = words_.say("phase.row", {{"row", t.pixel.y}})};
  }

  void show(Board& board, const steps::Finished&) { board.milestone(base_); }
  Event say(const steps::Finished&) const {
    return {.text = "tones.finished", .words = {{"sum", sum_}, {"shown", shown_}}};
  }

 private:
  ivec2 corner(int panel) const { return {1 + panel * (size_.x + gap), heading}; }
  void put(int panel, ivec2 pixel, Rgba8 tone, std::string text) {
    const ivec2 cell = corner(panel) + pixel - window_.lower;
    base_.cells.insert_or_assign({cell.y, cell.x}, CellLook{Role::result, std::move(text), tone});
  }
  static int right_of(const ToneTaken& t) { return tone_of(t.area).r; }
  /// What the screen makes of a tone.
  static double light_of(int tone) {
    return static_cast<double>(linear_from_srgb8(static_cast<std::uint8_t>(tone)));
  }

  const Words& words_;
  const Window window_;
  const ivec2 size_;
  View base_{};
  double sum_ = 0, shown_ = 0;
};

inline void tell_area_as_tone(Narrator& narrator) {
  const std::vector<ivec2> corners = corners_of(narrator.arguments());
  const Window window = window_of(narrator.arguments());
  TonesStory story(narrator.words(), window);
  narrator.whole_grid(story.paper());
  narrator.subtitle("subtitle", {{"n", corners.size()}});
  narrator.trace().goal = narrator.words().say("tones.goal");
  narrator.columns({{"x"}, {"y"}, {"area"}, {"tone"}, {"light"}, {"right_tone"}});
  narrator.legend({{Role::current, "this_pixel"}});
  narrator.tell_whole(story,
                      [&](const auto& watch) { area_as_tone(corners, window, [](ivec2, int) {}, watch); });
  narrator.result({{"light", story.shown()}, {"right", story.sum()}});
}

}  // namespace gradus::area_sampling
