#pragma once
// The same curve with more knots: control points give way to points on their edges, until its pieces are
// Bézier curves.

#include "stories/modeling/b_spline/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::b_spline {

class InsertStory : public Past<steps::Started, Placed<2, double>, Inserted<2, double>, Finished> {
 public:
  InsertStory(const Words& words, const Subject& subject, const SplineDrawing& drawing, bool all_knots)
      : words_(words), subject_(subject), drawing_(drawing), all_knots_(all_knots) {}

  Event say(const steps::Started&) const {
    return {.text = all_knots_ ? "pieces.started" : "insert.started",
            .words = {{"points", subject_.control.size()}, {"degree", subject_.degree()}, {"t", subject_.t}}};
  }
  Event say(const Placed<2, double>& p) const {
    const double share = share_of(p.lo, p.t, p.hi);
    const std::string name = name_of(turn() + 1, p.i);
    return {.text = "placed",
            .facts = {{"i", static_cast<std::int64_t>(p.i)},
                      {"share", share},
                      {"x", p.point.x},
                      {"y", p.point.y}},
            .words = {{"name", name},
                      {"t", p.t},
                      {"lo", figure_factor(p.lo)},
                      {"hi", p.hi},
                      {"first", name_of(turn(), p.i - 1)},
                      {"second", name_of(turn(), p.i)},
                      {"point", p.point}},
            .note = fmt::format("{} = {}", name, figure_place(p.point)),
            .row = {name, fmt::format("{} … {}", figure_real(p.lo), figure_real(p.hi)), share, p.point},
            .key = name,
            .phase = phase(p.t),
            .decides = nearer(words_, share, name, name_of(turn(), p.i - 1), name_of(turn(), p.i))};
  }
  Event say(const Inserted<2, double>& i) const {
    const auto often = std::ranges::count(i.curve.knots, i.t);
    return {.text = often >= std::ssize(i.curve.knots) - std::ssize(i.curve.control) - 1 ? "inserted.passes"
                                                                                         : "inserted",
            .facts = {{"t", i.t}, {"points", std::ssize(i.curve.control)}},
            .words = {{"before", i.curve.control.size() - 1}, {"often", often}},
            .note = words_.say("note.points", {{"points", i.curve.control.size()}}),
            .phase = phase(i.t),
            .ends = !all_knots_};
  }
  Event say(const Finished& f) const {
    return {.text = "pieces.done",
            .words = {{"degree", subject_.degree()}},
            .count = static_cast<std::int64_t>(f.count)};
  }
  /// The new polygon beside the old one, or all pieces.
  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    return all_knots_ ? std::same_as<Step, Finished> : std::same_as<Step, Inserted<2, double>>;
  }

  View draw() const {
    View view;
    const auto* placed = now<Placed<2, double>>();
    const auto* inserted = now<Inserted<2, double>>();
    const bool done = now<Finished>() != nullptr;
    const Subject& before = subjects_[subjects_.size() - (inserted ? 2 : 1)];
    const SplineDrawing drawing(before, drawing_.panel());
    if (done)
      SplineDrawing(subject_, drawing_.panel()).add_polygon(view, false);
    else
      drawing.add_polygon(view, true, turn() - (inserted ? 1 : 0));
    drawing.add_curve(view);
    if (done) add_pieces(view);
    if (inserted) add_inserted(view, inserted->curve.control);
    for (const auto& p : all_since<Placed<2, double>, Inserted<2, double>>()) {
      if (&p != placed)
        view.add_named(fmt::format("e point {:02}", p.i), Role::result, drawing_.at(p.point),
                       name_of(turn() + 1, p.i));
    }
    Subject shown = subjects_.back();
    if (placed) {
      add_placed(view, *placed);
      shown.t = placed->t;
    }
    SplineDrawing(shown, drawing_.panel()).add_knots(view, words_, around(placed));
    return view;
  }
  void take(const auto& step) {
    Past::take(step);
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Inserted<2, double>>)
      subjects_.push_back({step.curve.control, step.curve.knots, {}, step.t});
  }

 private:
  /// The polygons have letters, as far as those go.
  Index turn() const { return std::min<Index>(subjects_.size() - 1, 9); }
  std::string phase(double t) const { return words_.say("phase.knot", {{"t", t}}); }
  static std::optional<std::pair<double, double>> around(const Placed<2, double>* placed) {
    if (!placed) return std::nullopt;
    return std::pair(placed->lo, placed->hi);
  }

  void add_placed(View& view, const Placed<2, double>& p) const {
    const dvec2 a = drawing_.at(p.a), c = drawing_.at(p.c), point = drawing_.at(p.point);
    view.add({"f edge", Role::current, Stroke{point, c}});
    view.add({"f share", Role::measure, Stroke{a, point, true}});
    view.add_named("g point", Role::result, point, name_of(turn() + 1, p.i));
  }
  void add_inserted(View& view, const Control& control) const {
    view.add({"d polygon", Role::result, drawing_.path(control)});
    for (Index i = 0; i < control.size(); ++i)
      view.add({fmt::format("e point {:02}", i), Role::result, Dot{drawing_.at(control[i])}});
  }
  /// Each with its ground, its polygon and its part of the knots.
  void add_pieces(View& view) const {
    const auto pieces = pieces_of(subjects_.back().spline());
    for (Index k = 0; k < pieces.size(); ++k) {
      const Role role = k % 2 == 0 ? Role::result : Role::accepted;
      view.add({fmt::format("a ground {:02}", k), role, Area{{drawing_.panel().at(pieces[k].b)}, 2}});
      view.add({fmt::format("c polygon {:02}", k), role, drawing_.path(pieces[k].b)});
      for (Index i = 0; i < pieces[k].b.size(); ++i)
        view.add({fmt::format("e point {:02} {:02}", k, i), role, Dot{drawing_.at(pieces[k].b[i]), true}});
      const double from = pieces[k].from, to = pieces[k].to;
      view.add({fmt::format("f name {:02}", k), role,
                Label{drawing_.at(subject_.at(from + (to - from) / 2)),
                      fmt::format("{} ≤ {} ≤ {}", figure_real(from), words_.symbol("t"), figure_real(to))}});
    }
  }

  const Words& words_;
  const Subject& subject_;
  const SplineDrawing& drawing_;
  const bool all_knots_;
  std::vector<Subject> subjects_{subject_};
};

}  // namespace gradus::b_spline
