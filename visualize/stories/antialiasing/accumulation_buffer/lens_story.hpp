#pragma once
// Three lamps before a lens: the rays of each eye through them to the plane of focus, and the picture there.

#include "stories/antialiasing/accumulation_buffer/subject.hpp"

namespace gradus::accumulation_buffer {

/// What the camera sees. Depths and heights in metres.
struct Stage {
  static constexpr ivec2 size{19, 45};  ///< of the picture, in pixels
  static constexpr double pixels = 25;  ///< as many are 1 in the picture at depth 1
  static constexpr std::array<dvec3, 3> lamps{dvec3{0, 1, 2}, dvec3{0, 0, 4}, dvec3{0, -2.4, 8}};

  int eyes;
  Lens lens;

  /// Where an eye sees a lamp, in the picture at depth 1.
  dvec2 place(std::size_t lamp, dvec2 eye) const { return seen(lamps[lamp], eye, lens.focus); }
  /// The same on the plane of focus.
  dvec2 on_focus(std::size_t lamp, dvec2 eye) const { return lens.focus * place(lamp, eye); }
  /// The grey that an eye sees at a place of the picture: lamps are small discs.
  double grey(dvec2 pixel, dvec2 eye) const {
    constexpr double radius = 2.3;
    for (std::size_t k = 0; k < lamps.size(); ++k) {
      const dvec2 off = pixel - in_pixels(place(k, eye));
      if (glm::dot(off, off) <= radius * radius) return 1;
    }
    return 0;
  }
  static dvec2 in_pixels(dvec2 place) { return 0.5 * dvec2(size) + pixels * dvec2{place.x, -place.y}; }
};

inline Stage stage_of(const Arguments& arguments) {
  return {static_cast<int>(arguments.integer("eyes")),
          {*arguments.number("radius"), *arguments.number("focus")}};
}
inline void require_stage(const Stage& stage) {
  if (!(0 <= stage.lens.radius && stage.lens.radius <= 0.8))
    refuse("radius", "expected a radius from 0 to 0.8, found {}", stage.lens.radius);
  if (!(3 <= stage.lens.focus && stage.lens.focus <= 8))
    refuse("focus", "expected a depth from 3 to 8, found {}", stage.lens.focus);
}

class LensStory {
 public:
  LensStory(const Words& words, const Stage& stage, Picture& sums)
      : words_(words), stage_(stage), sums_(sums) {}

  static constexpr ivec2 paper{76, 52};

  void show(Board& board, const Started&) {
    View view = stage_view();
    rays(view, {0, 0}, true);
    board.milestone(std::move(view));
  }
  Event say(const Started& s) const {
    return {.text = "lens.started",
            .facts = {{"passes", s.passes}, {"focus", stage_.lens.focus}},
            .words = {{"radius", stage_.lens.radius}},
            .count = s.passes,
            .key = "started"};
  }

  void show(Board& board, const EyeAdded& e) {
    ++passes_;
    eyes_.push_back(e.eye);
    View view = stage_view();
    rays(view, e.eye, false);
    board.milestone(std::move(view));
  }
  Event say(const EyeAdded& e) const {
    const auto y = [&](std::size_t lamp) { return noiseless(stage_.on_focus(lamp, e.eye).y); };
    return {.text = "lens.added",
            .facts = {{"pass", e.pass + 1}, {"near", y(0)}, {"middle", y(1)}, {"far", y(2)}},
            .words = {{"eye", noiseless(e.eye.y)},
                      {"near_0", noiseless(stage_.on_focus(0, {0, 0}).y)},
                      {"far_0", noiseless(stage_.on_focus(2, {0, 0}).y)}},
            .row = {e.pass + 1, noiseless(e.eye.x), noiseless(e.eye.y), y(0), y(1), y(2)},
            .key = fmt::format("pass {}", e.pass + 1),
            .phase = words_.say("phase.passes")};
  }

  void show(Board& board, const Averaged&) {
    done_ = true;
    View view = stage_view();
    circles(view);
    board.milestone(std::move(view));
  }
  Event say(const Averaged& a) const {
    const double f = stage_.lens.focus;
    const auto width = [&](std::size_t k) {
      return f * circle_of_confusion(stage_.lens.radius, f, Stage::lamps[k].z);
    };
    return {.text = "lens.averaged",
            .facts = {{"near", width(0)}, {"middle", width(1)}, {"far", width(2)}},
            .words = {{"focus", f}, {"aperture", 2 * stage_.lens.radius}},
            .count = a.passes,
            .key = "mean",
            .ends = true};
  }

 private:
  static constexpr Frame picture{{54, 4}, Stage::size};
  static constexpr double axis_y = 26;  ///< of the paper

  static double noiseless(double x) { return std::abs(x) < 1e-12 ? 0 : x; }
  /// Heights have the scale that they have in the picture when they lie on the plane of focus.
  dvec2 at(double z, double y) const { return {6 + 4.8 * z, axis_y - y * Stage::pixels / stage_.lens.focus}; }

  View stage_view() const {
    View view;
    const double f = stage_.lens.focus, r = stage_.lens.radius;
    view.add({"a axis", Role::guide, Stroke{at(0, 0), at(9, 0), true, true, true}});
    view.add({"a depth", Role::guide, Text{at(9, 0) + dvec2{1.4, 0}, words_.symbol("z")}});
    view.add({"b lens", Role::boundary, Stroke{at(0, -r), at(0, r)}});
    view.add({"b lens name", Role::boundary, Text{at(0, -r) + dvec2{0, 2.2}, words_.say("lens")}});
    const dvec2 top{at(f, 0).x, 2}, bottom{at(f, 0).x, 48.5};
    view.add({"c focus", Role::accepted, Stroke{top, bottom, false, true}});
    view.add(
        {"c focus name", Role::accepted, Text{bottom + dvec2{0, 1.8}, words_.say("focus", {{"focus", f}})}});
    constexpr std::array<const char*, 3> names{"lamp.near", "lamp.middle", "lamp.far"};
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 lamp = Stage::lamps[k];
      view.add_named(fmt::format("p lamp {}", k), Role::input, at(lamp.z, lamp.y), words_.say(names[k]));
    }
    picture.put(view, "d picture",
                passes_ == 0 ? words_.say("heading.empty") : words_.count("heading.mean", passes_), 1.6);
    if (passes_ > 0) picture.put_picture(view, sums_, done_ ? 1 : static_cast<double>(passes_));
    for (std::size_t k = 0; k < eyes_.size(); ++k) dots(view, k);
    return view;
  }
  /// What an eye has left behind: itself, and where its rays met the plane of focus.
  void dots(View& view, std::size_t k) const {
    const dvec2 eye = eyes_[k];
    view.add({fmt::format("e eye {:02}", k), Role::past, Dot{at(0, eye.y)}});
    for (std::size_t lamp = 0; lamp < 3 && !done_; ++lamp)
      view.add({fmt::format("f foot {} {:02}", lamp, k), Role::past,
                Dot{at(stage_.lens.focus, stage_.on_focus(lamp, eye).y)}});
  }
  /// From the eye through each lamp, as far as the lamp or the plane of focus, what is farther.
  void rays(View& view, dvec2 eye, bool pinhole) const {
    const Role role = pinhole ? Role::guide : Role::current;
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 lamp = Stage::lamps[k];
      const dvec2 foot = at(stage_.lens.focus, stage_.on_focus(k, eye).y), place = at(lamp.z, lamp.y);
      view.add({fmt::format("r ray {}", k), role,
                Stroke{at(0, eye.y), foot.x < place.x ? place : foot, false, false, pinhole}});
      if (!pinhole) {
        view.add({fmt::format("s foot {}", k), Role::current, Dot{foot}});
        const dvec2 shown = picture.on_paper(Stage::in_pixels(stage_.place(k, eye)));
        view.add({fmt::format("t to picture {}", k), Role::measure, Stroke{foot, shown, false, true, true}});
        view.add({fmt::format("u shown {}", k), Role::current, Dot{shown, true}});
      }
    }
    view.add({"s eye", role, Dot{at(0, eye.y)}});
  }
  /// How wide each lamp's circle of confusion is, on the plane of focus.
  void circles(View& view) const {
    const double r = stage_.lens.radius, f = stage_.lens.focus;
    for (std::size_t k = 0; k < 3; ++k) {
      const double width = f * circle_of_confusion(r, f, Stage::lamps[k].z);
      for (const double side : {-1.0, 1.0}) {
        const dvec2 from = at(0, side * r), lamp = at(Stage::lamps[k].z, Stage::lamps[k].y);
        const dvec2 foot = at(f, stage_.on_focus(k, {0, side * r}).y);
        view.add({fmt::format("r ray {} {}", k, side), Role::measure,
                  Stroke{from, foot.x < lamp.x ? lamp : foot, false, true, true}});
      }
      if (width == 0) continue;
      const double y = stage_.on_focus(k, {0, 0}).y;
      view.add({fmt::format("w width {}", k), Role::measure,
                Stroke{at(f, y - 0.5 * width), at(f, y + 0.5 * width)}});
      // Beside the plane where no ray runs: beyond it, or before it below the blur
      const bool before = Stage::lamps[k].z > f;
      const dvec2 place = before ? at(f, y - 0.5 * width) + dvec2{-1.4, 1.8} : at(f, y) + dvec2{1.4, 0};
      view.add({fmt::format("w width {} text", k), Role::measure,
                Text{place, figure_real(width), before ? Align::right : Align::left}});
    }
  }

  const Words& words_;
  const Stage& stage_;
  Picture& sums_;
  std::vector<dvec2> eyes_{};
  std::int64_t passes_ = 0;
  bool done_ = false;
};

inline void tell_depth_of_field(Narrator& narrator) {
  const Stage stage = stage_of(narrator.arguments());
  require_stage(stage);
  narrator.subtitle("lens.subtitle", {{"radius", stage.lens.radius}, {"focus", stage.lens.focus}});
  set_paper(narrator, LensStory::paper);
  narrator.columns({{"pass"}, {"eye_x"}, {"eye_y"}, {"near"}, {"middle"}, {"far"}});
  narrator.legend({{Role::input, "lamps"},
                   {Role::boundary, "lens"},
                   {Role::accepted, "focus"},
                   {Role::current, "rays"},
                   {Role::measure, "width"},
                   {Role::past, "feet"}});
  Picture sums{Stage::size};
  LensStory story(narrator.words(), stage, sums);
  const auto render = [&](dvec2 eye, const Sums<double>& plot) {
    draw(Stage::size, dvec2(0.5), [&](dvec2 pixel) { return stage.grey(pixel, eye); }, plot);
  };
  depth_of_field(stage.eyes, stage.lens, render, sums.sums(), narrator.watcher(story));
  narrator.telling({std::max(1, 3 * stage.eyes * stage.eyes / 8), 0});
  narrator.result({{"near", stage.lens.focus *
                                circle_of_confusion(stage.lens.radius, stage.lens.focus, Stage::lamps[0].z)},
                   {"far", stage.lens.focus *
                               circle_of_confusion(stage.lens.radius, stage.lens.focus, Stage::lamps[2].z)}});
}

}  // namespace gradus::accumulation_buffer
