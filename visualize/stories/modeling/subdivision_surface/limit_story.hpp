#pragma once
// Where a vertex ends after all levels, from the points of one level round it, and the normal there.

#include <array>
#include <utility>
#include <vector>

#include "stories/modeling/subdivision_surface/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::subdivision_surface {

class LimitStory : public Past<steps::Started, LimitFound<double>, NormalFound<double>> {
 public:
  /// levels: the control mesh, the next one, a fine one. links: of the next one.
  LimitStory(const Words& words, const Subject& subject, std::vector<Control> levels, const Links& links)
      : words_(words),
        subject_(subject),
        levels_(std::move(levels)),
        links_(links),
        pictures_(words, subject),
        star_(links, subject.vertex, star_centre, star_radius),
        rule_(links.rule(star_.star())),
        weight_(parts()) {
    const std::array headings{words.say("control"), words.say("level", {{"level", 1}}), words.say("limit")};
    const std::array marked{faces_at(subject.mesh, subject.vertex), faces_at(levels_[1], subject.vertex),
                            std::vector<std::int32_t>{}};
    for (std::size_t k = 0; k < 3; ++k) {
      const LevelPicture picture{
          .id = std::string(1, "abc"[k]), .place = places[k], .heading = headings[k], .marked = marked[k]};
      pictures_.add(background_, picture, levels_[k]);
      if (k < 2) pictures_.add_vertex(background_, picture, subject.of(levels_[k]));
    }
  }

  dvec2 at(dvec3 p) const { return pictures_.at({.place = places[0]}, p); }
  double tells(const LimitFound<double>&) const { return 1; }

  Event say(const steps::Started&) const {
    return {.text = "limit.started",
            .words = {{"vertex", subject_.vertex + 1}, {"edges", star_.star().edges.size()}},
            .row = {words_.symbol("S"), short_place(subject_.of(levels_[0]))}};
  }
  Event say(const LimitFound<double>& s) const {
    const auto [own, near, far] = parts();
    return {.text = far > 0    ? "limit.found"
                    : near > 0 ? "limit.crease"
                               : "limit.corner",
            .facts = fields_of(s.point),
            .words = {{"vertex", subject_.vertex + 1},
                      {"point", short_place(s.point)},
                      {"own", weight_(own)},
                      {"near", weight_(near)},
                      {"far", weight_(far)}},
            .row = {words_.say("limit"), short_place(s.point)},
            .key = "limit",
            .phase = words_.say("limit")};
  }
  Event say(const NormalFound<double>& n) const {
    const double length = length_of(n.normal);
    return {.text = length > 0 ? "limit.normal" : "limit.no_normal",
            .facts = fields_of(n.normal),
            .words = {{"normal", short_place(length > 0 ? n.normal / length : n.normal)}},
            .row = {"N", short_place(length > 0 ? n.normal / length : n.normal)},
            .key = "normal",
            .phase = words_.say("limit")};
  }

  View draw() const {
    View view = background_;
    star_.add_to(view);
    view.add({"w dot", Role::current, Dot{star_centre}});
    const auto* found = last<LimitFound<double>>();
    if (!found) return view;
    add_weights(view);
    add_sum(view, *found);
    view.add({"c v", Role::result, Dot{pictures_.at({.place = places[2]}, found->point)}});
    const auto* normal = now<NormalFound<double>>();
    const double length = normal ? length_of(normal->normal) : 0;
    if (length > 0) {
      const dvec3 tip = found->point + 0.3 * size() / length * normal->normal;
      view.add({"c v normal", Role::boundary,
                Stroke{pictures_.at({.place = places[2]}, found->point),
                       pictures_.at({.place = places[2]}, tip), true}});
      add_line(view, 6, Role::boundary, "N = " + short_place(normal->normal / length));
    }
    return view;
  }

 private:
  double size() const {
    Bounds bounds;
    for (const dvec3 p : levels_[0].points) bounds.add(p);
    return bounds.radius();
  }
  /// What the vertex, a neighbour and a corner across count.
  std::array<double, 3> parts() const {
    const auto n = star_.star().valence();
    if (rule_.corner == 1) return {1, 0, 0};
    if (rule_.crease == 1) return {4.0 / 6, 1.0 / 6, 0};
    return {n / (n + 5), 4 / (n * (n + 5)), 1 / (n * (n + 5))};
  }
  void add_weights(View& view) const {
    const auto [own, near, far] = parts();
    const auto is_near = [&](std::int32_t v) {
      if (rule_.crease == 1) return v == rule_.a || v == rule_.b;
      return std::ranges::any_of(star_.star().edges,
                                 [&](std::int32_t e) { return links_.across(e, subject_.vertex) == v; });
    };
    for (const auto& [v, place] : star_.places()) {
      const double w = v == subject_.vertex ? own : is_near(v) ? near : far;
      if (w == 0) continue;
      const Role role = v == subject_.vertex ? Role::current : is_near(v) ? Role::measure : Role::accepted;
      if (v == subject_.vertex) {
        view.add({"x own", role, Label{star_centre, weight_(w)}});
        continue;
      }
      view.add({fmt::format("w {:05}", v), role, Dot{place}});
      view.add({fmt::format("x {:05}", v), role, Text{star_.beside(v), weight_(w), Align::centre, true}});
    }
  }
  void add_sum(View& view, const LimitFound<double>& s) const {
    add_line(view, 0, Role::current,
             fmt::format("{}′ = {}", words_.symbol("S"), short_place(s.vertex_point)));
    const auto n = static_cast<int>(s.valence);
    if (rule_.smooth == 1) {
      add_line(view, 1, Role::measure, "E = " + short_place(s.edge_points));
      add_line(view, 2, Role::accepted, "F = " + short_place(s.face_points));
      add_line(view, 3, Role::result, fmt::format("({}{}′ + 4E + F) / {}", n, words_.symbol("S"), n + 5));
    }
    add_line(view, 4, Role::result, "= " + short_place(s.point));
  }

  const Words& words_;
  const Subject& subject_;
  const std::vector<Control> levels_;
  const Links& links_;
  const LevelPictures pictures_;
  const StarDrawing star_;
  const Rule rule_;
  const WeightTexts weight_;
  View background_{};
};

}  // namespace gradus::subdivision_surface
