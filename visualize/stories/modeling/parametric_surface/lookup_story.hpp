#pragma once
// A point and a normal taken from the finished faces instead of the function: how far they are off, and how
// the normal jumps from face to face.

#include <numbers>

#include "stories/modeling/parametric_surface/patches_story.hpp"

namespace gradus::parametric_surface {

class LookupStory : public Past<steps::Started, CellFound<double>, Mixed<double>, FaceNormalTaken<double>> {
 public:
  LookupStory(const Words& words, const Subject& subject, const Patches<double>& mesh)
      : words_(words), subject_(subject), mesh_(mesh), right_(subject.at()), globe_(subject) {}

  double tells(const auto& step) const {
    return std::same_as<std::decay_t<decltype(step)>, FaceNormalTaken<double>> ? 1 : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = "lookup.started",
            .words = {{"s", degrees(subject_.s)}, {"t", degrees(subject_.t)}, {"faces", mesh_.faces.size()}},
            .row = row(words_.say("of_surface", {{"name", words_.symbol("P")}}), right_.point)};
  }
  Event say(const CellFound<double>& d) const {
    return {.text = "cell_found",
            .facts = {{"i", d.i}, {"j", d.j}, {"u", d.u}, {"v", d.v}},
            .words = {{"s", degrees(subject_.s)},
                      {"t", degrees(subject_.t)},
                      {"column", d.i + 1},
                      {"strip", d.j + 1}},
            .key = fmt::format("{},{}", d.i, d.j),
            .phase = words_.say("phase.cell")};
  }
  Event say(const Mixed<double>& d) const {
    const double off = length_between(d.point, right_.point);
    return {.text = "mixed",
            .facts = fields_of(d.point),
            .words = {{"point", figure_place(d.point)}, {"off", figure_real(off, 1e-15 * subject_.radius)}},
            .row = row(words_.say("of_faces", {{"name", words_.symbol("P")}}), d.point),
            .key = "P",
            .phase = words_.say("phase.point")};
  }
  Event say(const FaceNormalTaken<double>& d) const {
    const double between = angle_between(d.normal, right_.normal);
    return {.text = "normal_taken",
            .facts = {{"x", d.normal.x}, {"y", d.normal.y}, {"z", d.normal.z}, {"between", between}},
            .words = {{"between", degrees(between)}, {"jump", degrees(360.0 / subject_.n)}},
            .row = row(words_.say("of_faces", {{"name", words_.symbol("N")}}), d.normal),
            .key = "N",
            .phase = words_.say("phase.normal"),
            .decides = yes_or_no(words_, "question.same", {}, between < 1e-6, "same", "another")};
  }

  View draw() const {
    View view;
    const auto* cell = last<CellFound<double>>();
    const auto columns = static_cast<std::size_t>(subject_.n);
    add_mesh(view, globe_, mesh_, [&](int strip, std::size_t column) {
      const bool here = cell && strip == cell->j && column == static_cast<std::size_t>(cell->i) % columns;
      return here ? Role::current : Role::past;
    });
    add_aside(view, plot());
    if (const auto* d = last<Mixed<double>>()) view.add({"s point", Role::input, Dot{globe_.at(d->point)}});
    if (const auto* d = last<FaceNormalTaken<double>>()) {
      add_normal(view, "t face", Role::measure, d->normal);
      add_normal(view, "t surface", Role::boundary, right_.normal);
    }
    return view;
  }

 private:
  static double angle_between(dvec3 a, dvec3 b) {
    return 180 * std::numbers::inv_pi * gradus::atan2(length_of(glm::cross(a, b)), glm::dot(a, b));
  }
  static std::vector<Said> row(const std::string& name, dvec3 p) { return {name, p.x, p.y, p.z}; }
  void add_normal(View& view, const std::string& id, Role role, dvec3 normal) const {
    const dvec3 from = last<Mixed<double>>()->point;
    view.add({id, role, Stroke{globe_.at(from), globe_.at(from + 0.6 * globe_.radius() * normal), true}});
  }
  /// The direction of the normal round the axis, over s: of the surface a line, of the faces a stair.
  View plot() const {
    View view;
    add_axes(view, plot_, "plot", {words_.symbol("s"), words_.symbol("N")}, 4);
    add_caption(view, "u caption", plot_.place(), words_.say("direction"), 1.2);
    const dvec2 below{plot_.place().lower.x - 1.4, 4.4};
    // A sine and a cosine for each row, and for each point
    const std::size_t once = 2 * (static_cast<std::size_t>(subject_.m) + 1 + mesh_.points.size());
    view.add({"u cost 1", Role::boundary, Text{below, words_.say("cost.surface"), Align::left}});
    view.add({"u cost 2", Role::measure,
              Text{below - dvec2{0, 1.8}, words_.say("cost.faces", {{"once", once}}), Align::left}});
    view.add({"v surface", Role::boundary, Path{{plot_.at({0, 0}), plot_.at({360, 360})}}});
    std::vector<dvec2> stair;
    for (int i = 0; i < subject_.n; ++i) {
      const double middle = 360.0 * (i + 0.5) / subject_.n;
      for (const int end : {i, i + 1}) stair.push_back(plot_.at({360.0 * end / subject_.n, middle}));
    }
    view.add({"v faces", Role::measure, Path{stair}});
    const auto* cell = last<CellFound<double>>();
    if (!cell) return view;
    const double s = subject_.s_shown();
    view.add({"w here", Role::guide, Stroke{plot_.at({s, 0}), plot_.at({s, 360}), false, true, true}});
    if (!last<FaceNormalTaken<double>>()) return view;
    view.add({"w surface", Role::boundary, Dot{plot_.at({s, s})}});
    view.add({"w faces", Role::measure, Dot{plot_.at({s, 360.0 * (cell->i + 0.5) / subject_.n})}});
    return view;
  }

  const Words& words_;
  const Subject& subject_;
  const Patches<double>& mesh_;
  const SurfacePoint<double> right_;
  const Globe globe_;
  const Panel plot_{{{25.2, 7.4}, {34.6, 19.5}}, {{0, 0}, {360, 360}}, Panel::Fit::stretched};
};

}  // namespace gradus::parametric_surface
