#pragma once
// A curve as chords: pieces are halved until their control points say that they are flat - or, faulty, their
// middles.

#include "modeling/bezier_curve/bezier_curve_notes.hpp"
#include "stories/modeling/bezier_curve/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::bezier_curve {

class ChordsStory : public Past<steps::Started, Flattened<2, double>, Halved<2, double>, Finished> {
 public:
  ChordsStory(const Words& words, const Subject& subject, const CurveDrawing& drawing, bool by_middle)
      : words_(words), subject_(subject), drawing_(drawing), by_middle_(by_middle) {}

  Event say(const steps::Started&) const {
    return {.text = by_middle_ ? "flatten.started.middle" : "flatten.started",
            .words = {{"tolerance", subject_.tolerance}}};
  }
  Event say(const Flattened<2, double>& k) const {
    const double distance = farthest_of(k.piece.b).distance;
    Event event = tested(k.piece, k.off, true);
    event.facts.push_back({"distance", distance});
    event.words.push_back({"number", all<Flattened<2, double>>().size()});
    event.text = !by_middle_ ? "kept" : distance > subject_.tolerance ? "kept.wrongly" : "kept.middle";
    return event;
  }
  Event say(const Halved<2, double>& h) const {
    Event event = tested(h.piece, h.off, false);
    event.words.push_back({"middle", (h.piece.from + h.piece.to) / 2});
    event.text = by_middle_ ? "halved.middle" : "halved";
    return event;
  }
  Event say(const Finished& f) const {
    const bool held = distance() <= subject_.tolerance;
    return {.text = held ? "flatten.finished" : "flatten.finished.wrong",
            .facts = {{"distance", distance()}},
            .words = {{"tolerance", subject_.tolerance}},
            .count = static_cast<std::int64_t>(f.count)};
  }
  /// The longest chord; of the faulty ones that which is farthest off.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Flattened<2, double>>) {
      const Control& b = step.piece.b;
      return by_middle_ ? farthest_of(b).distance : length_between(b.front(), b.back());
    }
    return 0;
  }

  View draw() const {
    View view;
    drawing_.add_polygon(view);
    drawing_.add_curve(view, "b curve", Role::accepted);
    for (std::size_t i = 0; i < all<Halved<2, double>>().size() && !now<Finished>(); ++i) {
      const auto& piece = all<Halved<2, double>>()[i].piece;
      view.add({fmt::format("c cut {:03}", i), Role::past, Dot{drawing_.at(point_at(piece.b, 0.5))}});
    }
    add_chords(view);
    if (const auto* k = now<Flattened<2, double>>()) add_piece(view, k->piece, true);
    if (const auto* h = now<Halved<2, double>>()) add_piece(view, h->piece, false);
    return view;
  }
  /// As far as any kept chord is from its part of the curve.
  double distance() const {
    double most = 0;
    for (const auto& k : all<Flattened<2, double>>()) most = std::max(most, farthest_of(k.piece.b).distance);
    return most;
  }

 private:
  /// What lies farthest from its place on the chord: of the control points, or the middle.
  struct Measured {
    dvec2 point, foot;
    double distance = -1;
  };
  Measured measured(const Control& b) const {
    if (by_middle_) return {point_at(b, 0.5), 0.5 * (b.front() + b.back()), 0};
    Measured most{b.front(), b.front()};
    for (Index i = 1; i + 1 < b.size(); ++i) {
      const double distance = length_between(b[i], place_on_chord(b, i));
      if (distance > most.distance) most = {b[i], place_on_chord(b, i), distance};
    }
    return most;
  }
  static dvec2 place_on_chord(const Control& b, Index i) {
    const double share = static_cast<double>(i) / static_cast<double>(b.size() - 1);
    return (1 - share) * b.front() + share * b.back();
  }
  /// "3/4": so much of that the curve may be off where the degree is 3.
  static std::string part_of(Index degree) {
    const Index whole = Index{1} << (degree - 1);
    return fmt::format("{}/{}", whole - 1, whole);
  }
  /// "3/4 · 1.584".
  std::string bound(const Control& b) const {
    return fmt::format("{} · {}", part_of(b.size() - 1), figure_real(std::max(0.0, measured(b).distance)));
  }

  Event tested(const Piece<2, double>& piece, double off, bool flat) const {
    const std::vector<std::string> answers{words_.say("answer.halve"), words_.say("answer.keep")};
    return {.facts = {{"from", piece.from}, {"to", piece.to}, {"off", off}, {"flat", flat}},
            .words = {{"tolerance", subject_.tolerance}, {"bound", bound(piece.b)}},
            .row = {piece.from, piece.to, off, answers[flat ? 1 : 0]},
            .key = fmt::format("{:g}-{:g}", piece.from, piece.to),
            .decides = Decision{words_.say("question", {{"from", piece.from},
                                                        {"to", piece.to},
                                                        {"off", off},
                                                        {"tolerance", subject_.tolerance}}),
                                answers, flat ? std::size_t{1} : std::size_t{0}, "flat"}};
  }
  /// Those that stand, with their numbers while these are few.
  void add_chords(View& view) const {
    constexpr std::size_t most_numbers = 16;
    const auto& kept = all<Flattened<2, double>>();
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const dvec2 a = drawing_.at(kept[i].piece.b.front()), b = drawing_.at(kept[i].piece.end());
      view.add({fmt::format("c chord {:03}", i), Role::result, Stroke{a, b}});
      view.add({fmt::format("d begin {:03}", i), Role::result, Dot{a}});
      view.add({fmt::format("d end {:03}", i), Role::result, Dot{b}});
      if (kept.size() <= most_numbers && !(now<Flattened<2, double>>() && i + 1 == kept.size()))
        view.add(
            {fmt::format("e number {:03}", i), Role::result, Label{0.5 * (a + b), fmt::format("{}", i + 1)}});
    }
  }
  /// The piece at hand with what is measured: the control point that is farthest from its place on the chord,
  /// or the middle.
  void add_piece(View& view, const Piece<2, double>& piece, bool kept) const {
    const Control& b = piece.b;
    const Index n = b.size() - 1;
    drawing_.add_hull(view, "a piece inside", Role::current, b);
    drawing_.add_curve(view, "f piece", Role::current, piece.from, piece.to);
    view.add({"f chord", kept ? Role::result : Role::rejected,
              Stroke{drawing_.at(b[0]), drawing_.at(b[n]), false, !kept}});
    const Measured most = measured(b);
    if (by_middle_) {
      add_swing(view, b);
    } else {
      for (Index i = 1; i < n; ++i)
        view.add(
            {fmt::format("h place {:02}", i), Role::measure, Dot{drawing_.at(place_on_chord(b, i)), true}});
      view.add({"g polygon", Role::guide, Path{drawing_.panel().at(b), false, true}});
      for (Index i = 1; i < n; ++i)
        view.add({fmt::format("h control {:02}", i), Role::guide, Dot{drawing_.at(b[i]), true}});
    }
    if (most.distance < 0) return;
    if (most.foot != most.point) {
      const dvec2 foot = drawing_.at(most.foot), end = drawing_.at(most.point);
      view.add({"i off", Role::measure, Stroke{foot, end, true}});
      if (!by_middle_)
        view.add({"i off length", Role::measure, Label{0.5 * (foot + end), figure_real(most.distance)}});
    }
    view.add({"i off end", Role::measure, Dot{drawing_.at(most.point)}});
  }
  /// How far the curve is from its chord where nobody looks.
  void add_swing(View& view, const Control& b) const {
    const Farthest swing = farthest_of(b);
    if (swing.distance <= subject_.tolerance) return;
    const dvec2 way = b.back() - b.front();
    const double square = glm::dot(way, way);
    const double share =
        square > 0 ? std::clamp(glm::dot(swing.point - b.front(), way) / square, 0.0, 1.0) : 0;
    const dvec2 from = drawing_.at(b.front() + share * way), to = drawing_.at(swing.point);
    view.add({"j swing", Role::rejected, Stroke{from, to}});
    view.add({"k swing", Role::rejected, Label{to, figure_real(swing.distance)}});
  }

  const Words& words_;
  const Subject& subject_;
  const CurveDrawing& drawing_;
  const bool by_middle_;
};

/// Refuses what would make more chords than a figure shows.
inline void require_tolerance(const Arguments& arguments, const Subject& subject) {
  Extent extent;
  for (const dvec2 p : subject.control) extent.add(p);
  constexpr double finest = 1.0 / 2000;
  const double size = std::max(extent.size().x, extent.size().y);
  const double least = std::max(finest * size, least_part<double> * largest_of<2, double>(subject.control));
  if (!(subject.tolerance > 0 && subject.tolerance >= least))
    refuse(arguments, {"tolerance", "control"},
           fmt::format("expected a tolerance above 0 and of at least {:.3g}, found {}", least,
                       subject.tolerance));
}

inline void tell_chords(Narrator& narrator, const Subject& subject, const CurveDrawing& drawing,
                        bool by_middle) {
  require_tolerance(narrator.arguments(), subject);
  narrator.columns({{"from"}, {"to"}, {"off"}, {"flat", false}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, "curve"},
                   {Role::current, "piece"},
                   {Role::measure, by_middle ? "off_in_middle" : "off"},
                   {Role::rejected, by_middle ? "swing" : "not_flat"},
                   {Role::past, "cuts"},
                   {Role::result, "chords"}});
  ChordsStory story(narrator.words(), subject, drawing, by_middle);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Control line = by_middle ? middle_only<2, double>(subject.control, subject.tolerance, watch)
                                 : flatten<2, double>(subject.control, subject.tolerance, watch);
  narrator.result({{"chords", std::ssize(line) - 1}, {"distance", story.distance()}});
}

}  // namespace gradus::bezier_curve
