#pragma once
// The sum of all r^s over s: it falls, and where it is 1 lies the dimension.

#include "modeling/iterated_functions/similarity_dimension.hpp"
#include "stories/modeling/iterated_functions/subject.hpp"

namespace gradus::iterated_functions {

class DimensionStory : public Past<steps::Started, Widened, Halved, Enclosed> {
 public:
  DimensionStory(const Words& words, const Subject& subject, const std::vector<double>& ratios)
      : words_(words),
        subject_(subject),
        ratios_(ratios),
        chart_({{4.2, 3}, {35.2, 25.6}}, {{0, 0}, {widest(), static_cast<double>(ratios.size())}},
               Panel::Fit::stretched),
        pixels_(subject.attractor) {
    constexpr Whole enough = 20'000;
    constexpr int most_levels = 14;
    for (const dvec2 p : subject.points(subject.levels_of(enough, most_levels))) pixels_.plot(p);
  }

  Event say(const steps::Started&) const {
    return {.text = "dimension.started",
            .words = {{"maps", std::ssize(ratios_)}, {"sum", sum_at(ratios_, 1)}},
            .row = {"1", sum_at(ratios_, 1), 0, 1}};
  }
  Event say(const Widened& w) const {
    const double sum = sum_at(ratios_, w.high);
    return {.text = "widened",
            .facts = {{"high", w.high}, {"sum", sum}},
            .words = {{"low", w.low}},
            .row = {w.high, sum, w.low, w.high},
            .key = figure_real(w.high),
            .phase = words_.say("phase.widening"),
            .decides = yes_or_no(words_, "question.wide", {{"s", w.high}}, sum > 1, "above", "enclosed")};
  }
  Event say(const Halved& h) const {
    return {.text = h.sum > 1 ? "halved.above" : "halved.below",
            .facts = {{"s", h.s}, {"sum", h.sum}, {"low", h.low}, {"high", h.high}},
            .row = {h.s, h.sum, h.low, h.high},
            .key = figure_real(h.s),
            .phase = words_.say("phase.halving"),
            .decides = yes_or_no(words_, "question.above", {{"s", h.s}}, h.sum > 1, "larger", "smaller")};
  }
  Event say(const Enclosed& e) const {
    const bool similar = std::ranges::all_of(subject_.maps, is_similarity<double>);
    return {.text = similar ? "enclosed" : "enclosed.at_most",
            .facts = {{"low", e.low}, {"high", e.high}},
            .words = {{"s", (e.low + e.high) / 2}, {"half", (e.high - e.low) / 2}},
            .ends = true};
  }
  double tells(const auto& step) const {
    constexpr Index telling = 3;
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Halved>)
      return all<Halved>().size() == telling ? 1 : 0;
    return 0;
  }

  View draw() const {
    View view;
    add_chart(view);
    const auto ends = now<Enclosed>()   ? std::pair{now<Enclosed>()->low, now<Enclosed>()->high}
                      : last<Halved>()  ? std::pair{last<Halved>()->low, last<Halved>()->high}
                      : last<Widened>() ? std::pair{last<Widened>()->low, last<Widened>()->high}
                                        : std::pair{0.0, 1.0};
    if (const auto* e = now<Enclosed>()) {
      add_point(view, Role::result, (e->low + e->high) / 2);
      return view;
    }
    const auto on_curve = [&](double s) { return chart_.at({s, sum_at(ratios_, s)}); };
    view.add({"d between", Role::candidate,
              Area{{{chart_.at({ends.first, 0}), chart_.at({ends.second, 0}), on_curve(ends.second),
                     on_curve(ends.first)}}}});
    for (const double s : {ends.first, ends.second})
      view.add({fmt::format("e end {}", s == ends.first ? 1 : 2), Role::candidate,
                Stroke{chart_.at({s, 0}), on_curve(s), false, true}});
    if (const auto* h = now<Halved>()) add_point(view, Role::current, h->s);
    if (const auto* w = now<Widened>()) add_point(view, Role::current, w->high);
    return view;
  }

 private:
  double widest() const {
    double high = 1;
    while (sum_at(ratios_, high) > 1) high *= 2;
    return high;
  }
  void add_chart(View& view) const {
    constexpr int parts = 96;
    add_axes(view, chart_, "p", {"s", words_.say("axis.sum")}, 5);
    view.add({"c one", Role::boundary, Stroke{chart_.at({0, 1}), chart_.at({widest(), 1}), false, true}});
    Ring curve;
    for (int k = 0; k <= parts; ++k) {
      const double s = widest() * k / parts;
      curve.push_back(chart_.at({s, sum_at(ratios_, s)}));
    }
    view.add({"c sum", Role::input, Path{curve}});
    // Where the curve never is
    constexpr double left = 0.62;
    const dvec2 below = chart_.at({left * widest(), sum_at(ratios_, left * widest())});
    const Panel corner({{below.x, std::max(below.y + 1, 13.5)}, {34, 25}}, subject_.attractor);
    pixels_.add_to(view, corner);
  }
  void add_point(View& view, Role role, double s) const {
    const dvec2 at = chart_.at({s, sum_at(ratios_, s)});
    view.add({"f down", role, Stroke{chart_.at({s, 0}), at}});
    view.add_named("g at", role, at, figure_real(s));
  }

  const Words& words_;
  const Subject& subject_;
  const std::vector<double>& ratios_;
  const Panel chart_;
  Pixels pixels_;
};

}  // namespace gradus::iterated_functions
