#pragma once
// A point as a mean of the control points: below the curve the weights as functions of t, degree by degree,
// and how far each of them reaches.

#include "modeling/b_spline/b_spline_notes.hpp"
#include "stories/modeling/b_spline/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::b_spline {

/// The weights of a degree at t, those that are not 0.
inline Spread<double> weights_at(const Spline<2, double>& spline, double t, Index degree) {
  Spread<double> found{0, span_of(spline, t), {1}};
  basis(spline, t, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Spread<double>>) {
      if (step.degree == degree) found = step;
    }
  });
  return found;
}

class BasisStory : public Past<steps::Started, Spread<double>, Weighed<2, double>, Reached<2, double>> {
 public:
  BasisStory(const Words& words, const Subject& subject, const SplineDrawing& drawing, bool half_open)
      : words_(words), subject_(subject), drawing_(drawing), half_open_(half_open) {}

  Event say(const steps::Started&) const {
    Event event{.text = half_open_ ? "basis.started.half_open" : "basis.started",
                .words = {{"points", subject_.control.size()},
                          {"degree", subject_.degree()},
                          {"t", subject_.t},
                          {"from", subject_.knots[span()]},
                          {"to", subject_.knots[span() + 1]}}};
    event.row = {0, fmt::format("N{}", span()), half_open_ ? 0 : 1};
    return event;
  }
  Event say(const Spread<double>& s) const {
    double sum = 0;
    for (const double w : s.weights) sum += w;
    return {.text = sum == 0 ? "spread.lost" : "spread",
            .facts = {{"degree", static_cast<std::int64_t>(s.degree)}, {"sum", sum}},
            .words = {{"count", s.weights.size()}, {"spans", s.degree + 1}, {"before", s.degree - 1}},
            .note = words_.say("phase.degree", {{"degree", s.degree}}),
            .row = {s.degree, fmt::format("N{} … N{}", s.first, s.first + s.degree), sum},
            .key = fmt::format("degree {}", s.degree),
            .phase = words_.say("phase.degree", {{"degree", s.degree}})};
  }
  Event say(const Weighed<2, double>& w) const {
    const Index n = subject_.degree();
    const bool last = w.i == span();
    return {.text = half_open_ ? "weighed.lost"
                    : last     ? "weighed.last"
                               : "weighed",
            .facts = {{"i", static_cast<std::int64_t>(w.i)}, {"weight", w.weight}},
            .words = {{"name", name_of(0, w.i)},
                      {"point", w.sum},
                      {"pieces", pieces_from(w.i, w.i + n + 1)},
                      {"all", pieces_from(n, subject_.control.size())},
                      {"from", subject_.knots[w.i]},
                      {"to", subject_.knots[w.i + n + 1]}},
            .note = fmt::format("{}: {}", name_of(0, w.i), figure_real(w.weight)),
            .row = {n, name_of(0, w.i), w.weight},
            .key = name_of(0, w.i),
            .phase = words_.say("phase.mean"),
            .decides = yes_or_no(words_, "question.reaches", {{"name", name_of(0, w.i)}}, w.weight > 0,
                                 "counts", "does not count")};
  }
  Event say(const Reached<2, double>& r) const {
    return {.text = half_open_ ? "basis.lost" : "basis.reached",
            .words = {{"points", subject_.degree() + 1},
                      {"point", r.point},
                      {"t", subject_.t},
                      {"right", subject_.at(subject_.t)}},
            .ends = true};
  }
  /// The weight that counts most of those that don't reach everywhere.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Weighed<2, double>>) {
      const Knots& u = subject_.knots;
      const bool local = u[step.i] > u.front() || u[step.i + subject_.degree() + 1] < u.back();
      return step.weight + (local ? 1 : 0);
    }
    return half_open_ && std::same_as<std::decay_t<decltype(step)>, Reached<2, double>> ? 9 : 0;
  }

  /// Among several panels the curve gives way to the weights below it.
  View draw() const {
    View view;
    add_plot(view);
    for (auto [id, mark] : drawn_curve().marks) {
      mark.id = "aside " + id;
      view.add(std::move(mark));
    }
    return view;
  }
  void let_drag(Narrator& narrator) const {
    narrator.handles("control", shown_in(drawing_.panel()));
    if (!half_open_) narrator.handle("t", 0, plot_.at({subject_.t, 0}), {plot_.scale().x, 0});
    for (Index i = subject_.degree() + 1; i < subject_.control.size(); ++i)
      narrator.handle("knots", static_cast<int>(i), foot(i), {plot_.scale().x, 0});
  }

 private:
  Index span() const { return span_of(subject_.spline(), subject_.t); }
  dvec2 foot(Index knot) const { return plot_.at({subject_.knots[knot], 0}); }
  /// Pieces of the curve between two knots, counted from 0.
  Index pieces_from(Index first, Index last) const {
    Index pieces = 0;
    for (Index k = std::max(first, subject_.degree()); k < std::min(last, subject_.control.size()); ++k)
      pieces += subject_.knots[k] < subject_.knots[k + 1] ? Index{1} : Index{0};
    return pieces;
  }
  Index degree() const {
    if (!all<Weighed<2, double>>().empty()) return subject_.degree();
    return all<Spread<double>>().size();
  }

  /// The curve with what counts at t, and the mean that comes out.
  View drawn_curve() const {
    View view;
    drawing_.add_polygon(view);
    drawing_.add_curve(view);
    const auto* now_at = now<Weighed<2, double>>();
    const dvec2 right = drawing_.at(subject_.at(subject_.t));
    for (const Weighed<2, double>& w : all<Weighed<2, double>>()) {
      const bool is_now = now_at && w.i == now_at->i;
      const Role role = is_now ? Role::current : Role::past;
      const dvec2 at = drawing_.at(w.control);
      view.add({fmt::format("c pull {:02}", w.i), role, Stroke{right, at, false, false, true}});
      view.add({fmt::format("a point {:02} name", w.i), role,
                Label{at, fmt::format("{}: {}", name_of(0, w.i), figure_real(w.weight))}});
      view.add({fmt::format("a point {:02}", w.i), role, Dot{at}});
    }
    if (now_at)
      drawing_.add_curve(view, "d reach", Role::current, subject_.knots[now_at->i],
                         subject_.knots[now_at->i + subject_.degree() + 1]);
    const auto* reached = now<Reached<2, double>>();
    view.add({"f right", Role::measure, Dot{right, true}});
    if (reached) view.add({"g point", Role::result, Dot{drawing_.at(reached->point)}});
    if (reached && half_open_)
      view.add({"f off", Role::rejected, Stroke{right, drawing_.at(reached->point)}});
    return view;
  }
  /// All weights of the degree at hand, as far as the curve goes.
  void add_plot(View& view) const {
    add_axes(view, plot_, "x plot", {words_.symbol("t"), words_.say("weight")}, 6);
    const Spline<2, double> spline = subject_.spline();
    for (Index k = subject_.degree(); k <= subject_.control.size(); ++k)
      view.add({fmt::format("x knot {:02}", k), Role::boundary, Dot{foot(k)}});
    view.add(
        {"y t", Role::measure, Stroke{plot_.at({subject_.t, 0}), plot_.at({subject_.t, 1}), false, true}});
    const auto* now_at = now<Weighed<2, double>>();
    std::map<Index, Control> curves;
    for (Index k = subject_.degree(); k < subject_.control.size(); ++k) {
      if (!(subject_.knots[k] < subject_.knots[k + 1])) continue;
      for (const double t : places(subject_.knots[k], subject_.knots[k + 1], degree() < 2 ? 1 : 16)) {
        const Spread<double> s = weights_at(spline, t, degree());
        for (Index i = 0; i < s.weights.size(); ++i)
          curves[s.first + i].push_back(plot_.at({t, s.weights[i]}));
      }
    }
    const double floor = plot_.at(dvec2(0)).y;
    for (auto& [i, points] : curves) {
      // What begins or ends with a jump comes from the axis
      points.insert(points.begin(), dvec2{points.front().x, floor});
      points.push_back({points.back().x, floor});
      const bool counts = span() - degree() <= i && i <= span();
      const bool is_now = now_at ? i == now_at->i : counts && now<Spread<double>>();
      const Role role = is_now ? Role::current : counts ? Role::past : Role::guide;
      view.add({fmt::format("{} plot {:02}", is_now ? "w" : "v", i), role, Path{points}});
      const dvec2 top = *std::ranges::max_element(points, {}, &dvec2::y);
      view.add({fmt::format("x name {:02}", i), role, Label{top, fmt::format("N{}", i)}});
    }
    Spread<double> here = weights_at(spline, subject_.t, degree());
    if (half_open_) here.weights.assign(here.weights.size(), 0);
    add_values(view, here);
  }
  /// Weights that all are 0 have one place, and one name.
  void add_values(View& view, const Spread<double>& s) const {
    if (s.weights.size() > 1 && std::ranges::count(s.weights, 0.0) == std::ssize(s.weights)) {
      view.add_named("y weight", Role::measure, plot_.at({subject_.t, 0}),
                     fmt::format("N{} … N{}: 0", s.first, s.first + s.weights.size() - 1));
      return;
    }
    for (Index i = 0; i < s.weights.size(); ++i) {
      const std::string id = fmt::format("y weight {:02}", s.first + i);
      const dvec2 at = plot_.at({subject_.t, s.weights[i]});
      view.add_named(id, Role::measure, at, figure_real(s.weights[i]));
    }
  }

  const Words& words_;
  const Subject& subject_;
  const SplineDrawing& drawing_;
  const bool half_open_;
  const Panel plot_{{{4, 2.6}, {33, 10.6}},
                    {{subject_.spline().begin(), 0}, {subject_.spline().end(), 1}},
                    Panel::Fit::stretched};
};

}  // namespace gradus::b_spline
