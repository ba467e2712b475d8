#pragma once
// A point as a mean of the control points: the Bernstein polynomials beside the curve, and the hull that no
// mean leaves.

#include "stories/modeling/bezier_curve/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::bezier_curve {

class WeightsStory : public Past<steps::Started, Weighed<2, double>, Reached<2, double>> {
 public:
  WeightsStory(const Words& words, const Subject& subject, const CurveDrawing& drawing)
      : words_(words), subject_(subject), drawing_(drawing) {}

  Event say(const steps::Started&) const {
    return {.text = "weights.started",
            .words = {{"points", subject_.control.size()}, {"degree", subject_.degree()}, {"t", subject_.t}}};
  }
  Event say(const Weighed<2, double>& w) const {
    const Index n = subject_.degree();
    return {.text = w.i == n ? "weighed.last" : "weighed",
            .facts = {{"i", static_cast<std::int64_t>(w.i)}, {"weight", w.weight}},
            .words = {{"name", name_of(0, w.i)},
                      {"factors", factors_of(n, w.i)},
                      {"control", w.control},
                      {"point", w.sum}},
            .row = {name_of(0, w.i), w.weight, w.sum},
            .key = name_of(0, w.i)};
  }
  Event say(const Reached<2, double>& r) const {
    return {.text = "weights.reached",
            .words = {{"points", subject_.control.size()}, {"point", r.point}},
            .ends = true};
  }
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Weighed<2, double>>)
      return static_cast<double>(step.i);
    return 0;
  }

  View draw() const {
    View view;
    const bool done = all<Weighed<2, double>>().size() > subject_.degree();
    drawing_.add_hull(view, "a hull", Role::accepted, subject_.control);
    drawing_.add_polygon(view);
    drawing_.add_curve(view, "b curve", Role::accepted);
    add_plot(view);
    const dvec2 point = drawing_.at(point_at(subject_.control, subject_.t));
    for (const Weighed<2, double>& w : all<Weighed<2, double>>()) {
      const bool is_now = now<Weighed<2, double>>() && w.i + 1 == all<Weighed<2, double>>().size();
      const Role role = is_now ? Role::current : done ? Role::result : Role::past;
      const dvec2 at = drawing_.at(w.control);
      view.add({fmt::format("c pull {:02}", w.i), role, Stroke{point, at, false, false, !is_now}});
      view.add({fmt::format("a point {:02} name", w.i), role,
                Label{at, fmt::format("{}: {}", name_of(0, w.i), figure_real(w.weight))}});
      view.add({fmt::format("a point {:02}", w.i), role, Dot{at}});
    }
    view.add({"f point", done ? Role::result : Role::measure, Dot{point, !done}});
    return view;
  }
  void let_drag(Narrator& narrator) const {
    narrator.handle("t", 0, plot_.at({subject_.t, 0}), {plot_.scale().x, 0});
  }

 private:
  /// "3 · 0.4 · 0.6²": the ways, and the powers of t and 1 - t.
  std::string factors_of(Index n, Index i) const {
    const double ways = weight<double>(n, i, 0.5) * std::ldexp(1.0, static_cast<int>(n));
    std::string text = ways > 1 ? figure_real(ways) : "";
    const auto times = [&](double base, Index power) {
      constexpr std::array digits{"", "", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "¹⁰"};
      if (power > 0) text += (text.empty() ? "" : " · ") + figure_real(base) + digits[power];
    };
    times(subject_.t, i);
    times(1 - subject_.t, n - i);
    return text;
  }
  /// The weights as functions of t, that of the step at hand strong.
  void add_plot(View& view) const {
    add_axes(view, plot_, "x plot", {words_.symbol("t"), words_.say("weight")}, 5);
    view.add(
        {"y t", Role::measure, Stroke{plot_.at({subject_.t, 0}), plot_.at({subject_.t, 1}), false, true}});
    view.add({"z t", Role::measure, Dot{plot_.at({subject_.t, 0})}});
    const Index n = subject_.degree(), known = all<Weighed<2, double>>().size();
    constexpr int pieces = 48;
    for (Index i = 0; i <= n; ++i) {
      const bool is_now = now<Weighed<2, double>>() && i + 1 == known;
      const Role role = is_now ? Role::current : i < known ? Role::past : Role::guide;
      Control points;
      for (int k = 0; k <= pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        points.push_back(plot_.at({t, weight<double>(n, i, t)}));
      }
      view.add({fmt::format("{} plot {:02}", is_now ? "w" : "v", i), role, Path{points}});
      if (i >= known) continue;
      const dvec2 at = plot_.at({subject_.t, weight<double>(n, i, subject_.t)});
      view.add_named(fmt::format("y weight {:02}", i), is_now ? Role::current : Role::past, at,
                     name_of(0, i));
    }
  }

  const Words& words_;
  const Subject& subject_;
  const CurveDrawing& drawing_;
  const Panel plot_{{{25, 5}, {34.5, 23}}, {{0, 0}, {1, 1}}, Panel::Fit::stretched};
};

inline void tell_weights(Narrator& narrator, const Subject& subject, const CurveDrawing& drawing) {
  narrator.columns({{"control", false}, {"weight"}, {"sum", false}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, "curve_in_hull"},
                   {Role::past, "weighed"},
                   {Role::current, "weighing"},
                   {Role::measure, "here"},
                   {Role::result, "mean"}});
  WeightsStory story(narrator.words(), subject, drawing);
  story.let_drag(narrator);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const dvec2 point = bernstein<2, double>(subject.control, subject.t, watch);
  narrator.result({{"x", point.x}, {"y", point.y}});
}

}  // namespace gradus::bezier_curve
