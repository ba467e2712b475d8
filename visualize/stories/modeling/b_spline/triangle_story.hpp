#pragma once
// De Boor's triangle of points, of a polynomial curve and of a weighted one, where points are drawn divided
// by their weights.

#include "core/arithmetic/elementary.hpp"
#include "modeling/b_spline/b_spline_notes.hpp"
#include "stories/modeling/b_spline/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::b_spline {

enum class Kind { point, own_span_only, circle, unweighted };

/// A point of the triangle as it is drawn.
inline dvec2 seen(dvec2 p) { return p; }
inline dvec2 seen(dvec3 p) { return dvec2(p) / p.z; }

template <int N>
class TriangleStory : public Past<steps::Started, Mixed<N, double>, Reached<N, double>, Divided<2, double>> {
 public:
  using Between = Mixed<N, double>;
  static constexpr bool weighted = N == 3;

  TriangleStory(const Words& words, const Subject& subject, const SplineDrawing& drawing, Kind kind)
      : words_(words), subject_(subject), drawing_(drawing), kind_(kind) {}

  Event say(const steps::Started&) const {
    Event event{.text = weighted ? "circle.started" : "started",
                .words = {{"points", subject_.control.size()},
                          {"degree", subject_.degree()},
                          {"t", subject_.t},
                          {"first", name_of(0, first())},
                          {"last", name_of(0, first() + subject_.degree())}}};
    if (kind_ == Kind::unweighted) event.text = "circle.started.unweighted";
    return event;
  }
  Event say(const Between& m) const {
    const double share = share_of(m.lo, subject_.t, m.hi);
    const std::string name = name_of(m.round, m.i);
    const std::string ones[] = {name_of(m.round - 1, m.i), name_of(m.round - 1, m.i + 1)};
    Event event{.text = weighted ? "mixed.weighted" : "mixed",
                .facts = {{"round", static_cast<std::int64_t>(m.round)},
                          {"i", static_cast<std::int64_t>(m.i)},
                          {"share", share},
                          {"x", seen(m.point).x},
                          {"y", seen(m.point).y}},
                .words = {{"name", name},
                          {"first", ones[0]},
                          {"second", ones[1]},
                          {"t", subject_.t},
                          {"lo", figure_factor(m.lo)},
                          {"hi", m.hi},
                          {"share", share},
                          {"rest", share_of(-m.hi, -subject_.t, -m.lo)},
                          {"a", m.a},
                          {"c", m.c},
                          {"point", m.point}},
                .note = fmt::format("{} = {}", name, figure_place(m.point)),
                .row = {name, fmt::format("{} … {}", figure_real(m.lo), figure_real(m.hi)), share, m.point},
                .key = name,
                .phase = words_.say("phase.round", {{"round", m.round}}),
                .decides = nearer(words_, share, name, ones[0], ones[1])};
    if (kind_ == Kind::own_span_only) event.text = "mixed.own_span";
    if (m.round == subject_.degree() && !weighted) {
      event.text = kind_ != Kind::point ? "mixed.missed"
                   : m.a == m.c         ? "mixed.still"
                   : may_be_corner()    ? "mixed.corner"
                                        : "mixed.last";
      event.words.push_back({"right", right()});
      event.words.push_back({"off", length_between(seen(m.point), right())});
    }
    return event;
  }
  Event say(const Reached<N, double>& r) const {
    Event event{.text = weighted ? "reached.weighted" : "reached",
                .words = {{"point", r.point}, {"t", subject_.t}}};
    if (kind_ == Kind::own_span_only)
      event.text = "reached.missed", event.words.push_back({"right", right()});
    event.ends = !weighted;
    return event;
  }
  Event say(const Divided<2, double>& d) const {
    const double distance = length_between(d.point, {});
    return {.text = is_on_circle(d.point) ? "divided" : "divided.off",
            .facts = {{"distance", distance}},
            .words = {{"weight", d.weighted.z}, {"point", d.point}, {"off", std::abs(distance - 1)}},
            .ends = true};
  }
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Between>)
      return step.round == subject_.degree() ? 1 : 0;
    return std::same_as<std::decay_t<decltype(step)>, Divided<2, double>> ? 2 : 0;
  }

  View draw() const {
    View view;
    drawing_.add_polygon(view, !weighted);
    if (weighted) add_circle(view);
    drawing_.add_curve(view);
    add_rounds(view);
    const Between* m = this->template now<Between>();
    if (m) add_mixed(view, *m);
    if (!m && last_is_reached()) add_end(view);
    if (kind_ == Kind::own_span_only && last_is_reached()) {
      view.add_named("i right", Role::accepted, drawing_.at(right()), words_.say("right"));
      view.add({"h off", Role::rejected, Stroke{drawing_.at(seen(last()->point)), drawing_.at(right())}});
    }
    drawing_.add_knots(view, words_, m ? std::optional(std::pair(m->lo, m->hi)) : std::nullopt);
    return view;
  }

 private:
  Index first() const { return span_of(subject_.spline(), subject_.t) - subject_.degree(); }
  dvec2 right() const { return subject_.at(subject_.t); }
  /// As many knots inside are equal to t as the degree is: pieces need not have one tangent there.
  bool may_be_corner() const {
    const Spline<2, double> spline = subject_.spline();
    const auto equal = std::ranges::count(subject_.knots, subject_.t);
    return spline.begin() < subject_.t && subject_.t < spline.end() &&
           equal >= static_cast<std::ptrdiff_t>(subject_.degree());
  }
  const Between* last() const {
    return Past<steps::Started, Between, Reached<N, double>, Divided<2, double>>::template last<Between>();
  }
  bool last_is_reached() const { return last() && last()->round == subject_.degree(); }

  /// The point at hand, or the one that came out.
  const Between* shown_apart() const {
    return this->template now<Between>() || last_is_reached() ? last() : nullptr;
  }
  /// The rounds so far.
  void add_rounds(View& view) const {
    for (Index round = 1; round <= subject_.degree(); ++round) {
      Control points;
      for (const Between& m : this->template all<Between>()) {
        if (m.round != round || &m == shown_apart()) continue;
        points.push_back(seen(m.point));
        view.add_named(fmt::format("d point {:02} {:02}", round, m.i), Role::past, drawing_.at(points.back()),
                       name_of(m.round, m.i));
      }
      if (points.size() > 1)
        view.add({fmt::format("c round {:02}", round), Role::past, drawing_.path(points)});
    }
  }
  void add_mixed(View& view, const Between& m) const {
    const dvec2 a = drawing_.at(seen(m.a)), c = drawing_.at(seen(m.c)), p = drawing_.at(seen(m.point));
    if (m.round == subject_.degree() && kind_ != Kind::own_span_only && a != c && !may_be_corner()) {
      constexpr double reach = 4;
      const dvec2 way = reach / length_between(a, c) * (c - a);
      view.add({"d tangent", Role::current, Stroke{p - way, p + way, false, true}});
    }
    view.add({"e edge", Role::current, Stroke{p, c}});
    view.add({"e share", Role::measure, Stroke{a, p, true}});
    view.add_named("g point", Role::result, p, name_of(m.round, m.i));
  }
  void add_end(View& view) const {
    const dvec2 p = seen(last()->point);
    if (this->template now<Divided<2, double>>()) {
      view.add({"f radius", Role::measure, Stroke{drawing_.at({}), drawing_.at(p), true}});
      view.add(
          {"f radius name", Role::measure, Label{drawing_.at(0.5 * p), figure_real(length_between(p, {}))}});
    }
    view.add_named("g point", Role::result, drawing_.at(p), name_of(subject_.degree(), last()->i));
  }
  /// Whether the curve is the circle.
  bool is_round() const {
    const double first = subject_.knots[subject_.degree()], second = subject_.knots[subject_.degree() + 1];
    return is_on_circle(subject_.at(first + (second - first) / 2));
  }
  static bool is_on_circle(dvec2 p) {
    constexpr double noise = 1e-12;
    return std::abs(length_between(p, {}) - 1) < noise;
  }
  /// The circle that is meant, its centre, and the weights.
  void add_circle(View& view) const {
    Control round;
    constexpr int pieces = 96;
    for (int k = 0; k <= pieces; ++k) {
      const SinCos turn = sin_cos_degrees(360.0 * k / pieces);
      round.push_back({turn.cos, turn.sin});
    }
    if (!is_round()) view.add({"a circle", Role::candidate, drawing_.path(round, true)});
    view.add({"a centre", Role::guide, Dot{drawing_.at({})}});
    for (Index i = 0; i + 1 < subject_.control.size(); ++i)
      view.add({fmt::format("a point {:02} name", i), Role::input,
                Label{drawing_.at(subject_.control[i]),
                      fmt::format("{}: {}", name_of(0, i), figure_real(subject_.weights[i]))}});
  }

  const Words& words_;
  const Subject& subject_;
  const SplineDrawing& drawing_;
  const Kind kind_;
};

}  // namespace gradus::b_spline
