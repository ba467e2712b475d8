#pragma once
// The same curve with more control points: their polygons come nearer to it.

#include "stories/modeling/bezier_curve/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::bezier_curve {

class RaisedStory : public Past<steps::Started, Raised<2, double>, Finished> {
 public:
  RaisedStory(const Words& words, const Subject& subject, const CurveDrawing& drawing)
      : words_(words), drawing_(drawing), polygons_{subject.control} {
    for (int k = 0; k < subject.times; ++k) polygons_.push_back(raise_degree<2, double>(polygons_.back()));
  }

  Event say(const steps::Started&) const {
    return {.text = "raise.started",
            .words = {{"degree", polygons_[0].size() - 1}, {"raised", polygons_.back().size() - 1}}};
  }
  Event say(const Raised<2, double>& r) const {
    return {.text = r.i + 1 == before().size() ? "raised.last" : "raised",
            .facts = {{"i", static_cast<std::int64_t>(r.i)},
                      {"share", r.share},
                      {"x", r.point.x},
                      {"y", r.point.y}},
            .words = {{"name", name_of(turn() + 1, r.i)},
                      {"first", name_of(turn(), r.i - 1)},
                      {"second", name_of(turn(), r.i)},
                      {"n", before().size()},
                      {"rest", before().size() - r.i},
                      {"point", r.point},
                      {"length", length_of_polygon(polygons_[turn() + 1])},
                      {"before", length_of_polygon(before())}},
            .row = {name_of(turn() + 1, r.i), r.share, r.point},
            .key = name_of(turn() + 1, r.i),
            .phase = phase()};
  }
  Event say(const Finished& f) const {
    return {.text = "raise.done",
            .words = {{"points", f.count},
                      {"length", length_of_polygon(polygons_[turn() + 1])},
                      {"before", length_of_polygon(before())}},
            .phase = phase(),
            .ends = turn() + 2 == polygons_.size()};
  }
  /// The last point of the last polygon.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Raised<2, double>>)
      return static_cast<double>(turn() * (most_degree + 1) + step.i);
    return 0;
  }

  View draw() const {
    View view;
    drawing_.add_polygon(view);
    drawing_.add_curve(view, "b curve", Role::accepted);
    const auto* r = now<Raised<2, double>>();
    const bool done = now<Finished>() != nullptr;
    for (std::size_t k = 1; k <= turn(); ++k)
      view.add({fmt::format("c polygon {:02}", k), Role::past, drawing_.path(polygons_[k])});
    if (!r && !done) return view;
    const Control& raised = polygons_[turn() + 1];
    // With the last one it is complete
    const std::size_t found = r && r->i + 2 < raised.size() ? r->i + 1 : raised.size();
    const auto end = raised.begin() + static_cast<std::ptrdiff_t>(found);
    view.add({"d polygon", Role::result, drawing_.path({raised.begin(), end})});
    for (std::size_t i = 1; i < found && i + 1 < raised.size(); ++i)
      view.add_named(fmt::format("e point {:02}", i), Role::result, drawing_.at(raised[i]),
                     name_of(turn() + 1, i));
    if (!r) return view;
    view.add({"f way", Role::measure, Stroke{drawing_.at(r->a), drawing_.at(r->point), true}});
    view.add({fmt::format("e point {:02}", r->i), Role::current, Dot{drawing_.at(r->point)}});
    return view;
  }

 private:
  const Control& before() const { return polygons_[turn()]; }
  std::string phase() const { return words_.say("phase.degree", {{"degree", before().size()}}); }

  const Words& words_;
  const CurveDrawing& drawing_;
  std::vector<Control> polygons_;
};

inline void tell_raised(Narrator& narrator, const Subject& subject, const CurveDrawing& drawing) {
  narrator.columns({{"point", false}, {"share"}, {"place", false}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, "curve"},
                   {Role::past, "polygons"},
                   {Role::measure, "from_before"},
                   {Role::current, "point"},
                   {Role::result, "raised"}});
  RaisedStory story(narrator.words(), subject, drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  Control control = subject.control;
  for (int k = 0; k < subject.times; ++k) {
    story.turn_to(static_cast<std::size_t>(k));
    control = raise_degree<2, double>(control, watch);
  }
  narrator.result({{"points", std::ssize(control)}, {"length", length_of_polygon(control)}});
}

}  // namespace gradus::bezier_curve
