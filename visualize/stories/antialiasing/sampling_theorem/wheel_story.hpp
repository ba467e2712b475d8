#pragma once
// A wheel on film: how far it turns from frame to frame, and how far its spokes seem to.

#include "antialiasing/sampling_theorem/sampling_theorem_notes.hpp"
#include "stories/telling.hpp"

namespace gradus::sampling_theorem {

struct Wheel {
  double f, fps;
  std::int64_t n, shown;
};

inline Wheel wheel_of(const Arguments& given) {
  const Wheel wheel{*given.number("revolutions"), *given.number("frames"), given.integer("spokes"),
                    given.integer("shown")};
  if (!(wheel.fps > 0)) refuse("frames", "expected a number above 0, found {}", wheel.fps);
  if (std::abs(wheel.f) > 4 * wheel.fps)
    refuse(given, {"revolutions", "frames"}, "expected at most 4 revolutions per frame");
  return wheel;
}

class WheelStory {
 public:
  /// asked: whether the rule of half the frame rate is on trial.
  WheelStory(const Words& words, const Wheel& wheel, bool asked)
      : words_(words), wheel_(wheel), asked_(asked), speed_(apparent_speed(wheel.f, wheel.fps, wheel.n)) {}

  static constexpr int width = 42, height = 26;

  void show(Board& board, const DirectionTold<double>& r) {
    told_ = true;
    said_ = r.backward;
    board.milestone(drawing());
  }
  Event say(const DirectionTold<double>& r) const {
    return {.text = r.backward ? "rule.backward" : "rule.forward",
            .facts = {{"backward", r.backward}},
            .words = {{"f", wheel_.f}, {"fps", wheel_.fps}, {"half", 0.5 * wheel_.fps}},
            .phase = words_.say("phase.rule"),
            .decides = yes_or_no(words_, "question.half", {{"f", wheel_.f}, {"half", 0.5 * wheel_.fps}},
                                 r.backward, "backward", "forward")};
  }
  void show(Board& board, const FrameTaken<double>& t) {
    taken_.push_back(t);
    board.milestone(drawing());
  }
  Event say(const FrameTaken<double>& t) const {
    const bool first = t.k == 0, same = way() == eye() && !tie();
    Event event{.text = first        ? "wheel.first"
                        : eye() == 0 ? "wheel.still"
                        : tie()      ? "wheel.tie"
                        : same       ? "wheel.true"
                                     : "wheel.seen",
                .facts = {{"k", t.k}, {"turn", t.turn}, {"seen", t.seen}},
                .words = {{"way", degrees(way())},
                          {"between", degrees(1 / static_cast<double>(wheel_.n))},
                          {"eye", degrees(eye())},
                          {"fps", wheel_.fps}},
                .row = {t.k, degrees(t.turn), degrees(t.seen)},
                .key = figure_number(t.k),
                .phase = words_.say("phase.frames")};
    if (first) event.count = wheel_.n;
    if (!first)
      event.decides = yes_or_no(
          words_, "question.nearest",
          {{"way", degrees(std::abs(way()))}, {"half", degrees(0.5 / static_cast<double>(wheel_.n))}}, same,
          "the true way", "another way");
    return event;
  }
  void show(Board& board, const steps::Finished&) { board.milestone(drawing()); }
  Event say(const steps::Finished&) const {
    const bool wrong = asked_ && speed_ != 0 && said_ != (speed_ < 0);
    return {.text = wrong         ? (said_ ? "rule.wrong_backward" : "rule.wrong_forward")
                    : speed_ == 0 ? "wheel.finished_still"
                    : speed_ < 0  ? "wheel.finished_backward"
                                  : "wheel.finished_forward",
            .facts = {{"speed", speed_}},
            .words = {{"f", wheel_.f},
                      {"fps", wheel_.fps},
                      {"size", std::abs(speed_)},
                      {"rates", std::round((wheel_.f - speed_) * static_cast<double>(wheel_.n) / wheel_.fps)},
                      {"spokes", wheel_.n}}};
  }
  double speed() const { return speed_; }

 private:
  static constexpr dvec2 hub{11.7, 13};
  static constexpr double radius = 11.3;

  static std::string degrees(double turns) { return figure_real(std::round(turns * 360 * 1e4) / 1e4) + "°"; }
  /// From one frame to the next, in revolutions.
  double way() const { return std::round(wheel_.f / wheel_.fps * 1e12) / 1e12; }
  double eye() const { return std::round(speed_ / wheel_.fps * 1e12) / 1e12; }
  bool tie() const { return 2 * eye() * static_cast<double>(wheel_.n) == 1; }

  /// Forwards is clockwise, from the top.
  static dvec2 at(double turn, double part) {
    const SinCos way = sin_cos_half_turns(2 * turn);
    return hub + part * radius * dvec2{way.sin, way.cos};
  }
  /// A way on the wheel, with its head; a long one winds outwards.
  static void add_way(View& view, const std::string& id, Role role, double from, double to, double inner,
                      double outer, bool dashed = false) {
    const int parts = std::max(8, static_cast<int>(std::ceil(std::abs(to - from) * 72)));
    Path path{{}, false, dashed};
    for (int i = 0; i < parts; ++i) {
      const double s = static_cast<double>(i) / parts;
      path.points.push_back(at(from + (to - from) * s, inner + (outer - inner) * s));
    }
    const dvec2 last = path.points.back();
    view.add({id, role, path});
    view.add({id + " head", role, Stroke{last, at(to, outer), true, dashed}});
  }
  void add_spokes(View& view, const std::string& id, Role role, double turn, bool before) const {
    for (std::int64_t i = 0; i < wheel_.n; ++i) {
      const double place = turn + static_cast<double>(i) / static_cast<double>(wheel_.n);
      view.add({fmt::format("{} {:02}", id, i), role,
                Stroke{at(place, 0.08), at(place, 1), false, before, before}});
    }
  }
  View drawing() const {
    View view;
    Path rim{{}, true};
    for (int i = 0; i < 96; ++i) rim.points.push_back(at(i / 96.0, 1));
    view.add({"a rim", Role::boundary, rim});
    const double turn = taken_.empty() ? 0 : taken_.back().turn;
    if (taken_.size() > 1) {
      const double before = taken_[taken_.size() - 2].turn;
      add_spokes(view, "b before", Role::past, before, true);
      add_way(view, "d way", Role::measure, before, turn, 0.4, std::abs(way()) > 1 ? 0.62 : 0.4);
      if (eye() != 0) add_way(view, "e eye", Role::result, turn - eye(), turn, 0.8, 0.8, true);
    }
    add_spokes(view, "c spoke", Role::input, turn, false);
    if (told_) add_way(view, "g rule", Role::rejected, 0, said_ ? -0.2 : 0.2, 0.22, 0.22);
    view.add({"f mark", Role::measure, Dot{at(turn, 1)}});
    add_turns(view);
    return view;
  }
  /// Turns over frames: what is and what is seen.
  void add_turns(View& view) const {
    const auto last = static_cast<double>(wheel_.shown);
    const double end = wheel_.f / wheel_.fps * last, seen = speed_ / wheel_.fps * last;
    Extent world{{0, std::min({0.0, end, seen})}, {last, std::max({0.0, end, seen})}};
    if (world.lower.y == world.upper.y) world.upper.y = 1;
    const Panel plot({{27.2, 4.4}, {40.6, 21.6}}, world, Panel::Fit::stretched);
    add_axes(view, plot, "p", {words_.symbol("k"), words_.say("turns")}, 5);
    view.add({"p zero", Role::guide, Stroke{plot.at({0, 0}), plot.at({last, 0}), false, false, true}});
    Path is, sees{{}, false, true};
    for (const FrameTaken<double>& t : taken_) {
      const auto k = static_cast<double>(t.k);
      is.points.push_back(plot.at({k, t.turn}));
      sees.points.push_back(plot.at({k, t.seen}));
      view.add({fmt::format("q true {:02}", t.k), Role::measure, Dot{is.points.back()}});
      if (t.seen != t.turn)
        view.add({fmt::format("r seen {:02}", t.k), Role::result, Dot{sees.points.back(), true}});
    }
    if (taken_.size() < 2) return;
    view.add({"q line", Role::measure, is});
    if (way() != eye()) view.add({"r line", Role::result, sees});
  }

  const Words& words_;
  const Wheel wheel_;
  const bool asked_;
  const double speed_;
  std::vector<FrameTaken<double>> taken_{};
  bool told_ = false, said_ = false;
};

inline void tell_wheel(Narrator& narrator, bool asked) {
  const Wheel wheel = wheel_of(narrator.arguments());
  narrator.paper(WheelStory::width, WheelStory::height);
  narrator.trace().subtitle =
      narrator.words().count("subtitle.wheel", wheel.n, {{"f", wheel.f}, {"fps", wheel.fps}});
  narrator.columns({{"k"}, {"turn"}, {"seen"}});
  narrator.legend({{Role::input, "spokes"},
                   {Role::past, "frame_before"},
                   {Role::measure, "turned"},
                   {Role::result, "seen"},
                   {Role::rejected, "rule"}});
  WheelStory story(narrator.words(), wheel, asked);
  const auto watch = narrator.watcher(story);
  std::vector<double> seen(static_cast<std::size_t>(wheel.shown) + 1);
  if (asked) {
    // The rule is what is listed, and it knows no frames
    film_wheel(wheel.f, wheel.fps, wheel.n, std::span(seen),
               [&](const FrameTaken<double>& taken) { watch(taken, 0); });
    half_frame_rate(wheel.f, wheel.fps, watch);
  } else {
    film_wheel(wheel.f, wheel.fps, wheel.n, std::span(seen), watch);
  }
  watch(steps::Finished{}, 0);
  narrator.telling({asked ? wheel.shown + 1 : wheel.shown, 0});  // all frames stand in the chart
  narrator.result({{"speed", story.speed()}});
}

inline void tell_wagon_wheel(Narrator& narrator) {
  narrator.list("apparent_speed");
  narrator.list_below("film_wheel");
  tell_wheel(narrator, false);
}
inline void tell_half_frame_rate(Narrator& narrator) { tell_wheel(narrator, true); }

}  // namespace gradus::sampling_theorem
