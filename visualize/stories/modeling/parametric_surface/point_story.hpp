#pragma once
// A point of the sphere: the angle round the axis, the angle up the meridian, the point, both tangents, the
// normal.

#include "stories/modeling/parametric_surface/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::parametric_surface {

class PointStory : public Past<steps::Started, Turned<double>, Raised<double>, PointFound<double>,
                               AlongParallel<double>, AlongMeridian<double>, NormalFound<double>> {
 public:
  PointStory(const Words& words, const Subject& subject) : words_(words), subject_(subject), globe_(subject) {
    globe_.add_to(background_);
    globe_.add_seam(background_);
    chart_.add_to(background_, words, 12, 6, true);
    for (int k = 0; k <= 12; k += 2) {
      for (const double t : {-90.0, 90.0})
        background_.add(
            {fmt::format("l pole {:02} {}", k, t < 0), Role::accepted, Dot{chart_.at(30 * k, t)}});
    }
    const dvec2 place = in_chart();
    const dvec2 below{place.x, chart_.at(0, -90).y}, aside{chart_.at(0, 0).x, place.y};
    background_.add({"m down", Role::candidate, Stroke{place, below, false, true}});
    background_.add({"m left", Role::candidate, Stroke{place, aside, false, true}});
    background_.add({"o dot", Role::current, Dot{place}});
    background_.add({"o text", Role::current,
                     Text{{chart_place.centre().x, chart_place.upper.y + 1.3},
                          words.say("pair", {{"s", degrees(subject.s)}, {"t", degrees(subject.t)}}),
                          Align::centre,
                          true}});
  }
  /// Where the rectangle has the parameters.
  dvec2 in_chart() const { return chart_.at(subject_.s_shown(), subject_.t); }

  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if (std::same_as<Step, NormalFound<double>>) return has_normal() ? 0 : 2;
    return std::same_as<Step, AlongMeridian<double>> ? 1 : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = "started",
            .words = {{"s", degrees(subject_.s)}, {"t", degrees(subject_.t)}, {"r", subject_.radius}}};
  }
  Event say(const Turned<double>& d) const {
    return {.text = "turned",
            .facts = fields_of(d.direction),
            .words = {{"s", degrees(subject_.s)}, {"direction", figure_place(d.direction)}},
            .row = row("e", d.direction),
            .key = "e",
            .phase = words_.say("phase.angles")};
  }
  Event say(const Raised<double>& d) const {
    return {.text = d.ring == 0 ? "raised.pole" : "raised",
            .facts = {{"ring", d.ring}, {"height", d.height}},
            .words = {{"t", degrees(subject_.t)}},
            .row = row(words_.symbol("Q"), foot()),
            .key = "Q",
            .phase = words_.say("phase.angles")};
  }
  Event say(const PointFound<double>& d) const {
    return {.text = "point_found",
            .facts = fields_of(d.point),
            .words = {{"point", figure_place(d.point)}},
            .row = row(words_.symbol("P"), d.point),
            .key = "P",
            .phase = words_.say("phase.point")};
  }
  Event say(const AlongParallel<double>& d) const {
    return {.text = d.length == 0 ? "along_parallel.pole" : "along_parallel",
            .facts = fields_of(d.tangent),
            .words = {{"tangent", figure_place(d.tangent)}, {"length", d.length}},
            .row = row(by_s(), d.tangent),
            .key = by_s(),
            .phase = words_.say("phase.tangents"),
            .decides = yes_or_no(words_, "question.tangent", {{"t", degrees(subject_.t)}}, d.length != 0,
                                 "tangent", "none")};
  }
  Event say(const AlongMeridian<double>& d) const {
    return {.text = "along_meridian",
            .facts = fields_of(d.tangent),
            .words = {{"tangent", figure_place(d.tangent)}, {"length", d.length}},
            .row = row(by_t(), d.tangent),
            .key = by_t(),
            .phase = words_.say("phase.tangents")};
  }
  Event say(const NormalFound<double>& d) const {
    const bool found = has_normal();
    return {.text = found ? "normal_found" : "normal_found.none",
            .facts = found ? fields_of(d.normal) : std::vector<Field>{{"length", 0.0}},
            .words = {{"normal", found ? figure_place(d.normal) : "0/0"}, {"r", subject_.radius}},
            .note = found ? "" : words_.symbol("N") + " = 0/0",
            .row = found ? row(words_.symbol("N"), d.normal)
                         : std::vector<Said>{words_.symbol("N"), "0/0", "0/0", "0/0"},
            .key = "N",
            .phase = words_.say("phase.normal")};
  }

  View draw() const {
    View view = background_;
    const dvec3 centre{0}, here = subject_.at().point;
    if (last<Turned<double>>()) {
      globe_.add_curve(view, "p s", Role::candidate, 0, subject_.s_shown(),
                       [&](double s) { return 0.42 * globe_.on(s, 0); });
      if (subject_.s_shown() != 0)
        add_beyond(view, "p s name", Role::candidate, at(centre),
                   at(0.42 * globe_.on(subject_.s_shown() / 2, 0)),
                   words_.say("angle.s", {{"s", degrees(subject_.s)}}));
    }
    if (const auto* d = now<Turned<double>>())
      add_arrow(view, "q e", Role::current, at(centre), at(globe_.radius() * d->direction), "e");
    if (last<Raised<double>>()) {
      view.add_named("q foot", Role::past, at(foot()), words_.symbol("Q"));
      view.add({"q ring", Role::result, Stroke{at(centre), at(foot())}});
      view.add({"q height", Role::result, Stroke{at(foot()), at(here), false, true}});
      view.add({"q radius", Role::past, Stroke{at(centre), at(here)}});
      globe_.add_curve(view, "p t", Role::candidate, 0, subject_.t,
                       [&](double t) { return 0.55 * globe_.on(subject_.s, t); });
      if (subject_.t != 0)
        beside(view, "p t name", Role::candidate, 0.3, words_.say("angle.t", {{"t", degrees(subject_.t)}}));
    }
    if (const auto* d = now<Raised<double>>()) {
      const double off = at(foot()).y < at(here).y ? -1.4 : 1.4;
      view.add({"q ring name", Role::result,
                Text{at(foot()) + dvec2{0, off}, words_.say("ring", {{"ring", d->ring}})}});
      beside(view, "q height name", Role::result, 0.8, words_.say("height", {{"height", d->height}}));
    }
    if (last<PointFound<double>>())
      view.add_named("s point", Role::current, at(here), words_.symbol("P"), !globe_.seen(here));
    if (const auto* d = last<AlongParallel<double>>()) add_tangent(view, "r by_s", by_s(), *d);
    if (const auto* d = last<AlongMeridian<double>>()) add_tangent(view, "r by_t", by_t(), *d);
    if (now<NormalFound<double>>() && has_normal()) {
      const dvec3 tip = here + half * globe_.radius() * now<NormalFound<double>>()->normal;
      view.add({"r normal", Role::result, Stroke{at(here), at(tip), true}});
      add_beyond(view, "r normal name", Role::result, at(here), at(tip), words_.symbol("N"));
    }
    return view;
  }

 private:
  /// Tangents and normals are drawn half as long as they are, so that they stay near the sphere.
  static constexpr double half = 0.5;

  dvec2 at(dvec3 p) const { return globe_.at(p); }
  dvec3 foot() const {
    const dvec3 p = subject_.at().point;
    return {p.x, p.y, 0};
  }
  std::string by_s() const { return words_.say("by_s"); }
  std::string by_t() const { return words_.say("by_t"); }
  bool has_normal() const {
    const auto* d = last<NormalFound<double>>();
    return d && d->normal == d->normal;
  }
  static std::vector<Said> row(const std::string& name, dvec3 p) { return {name, p.x, p.y, p.z}; }
  /// Right of the line from Q to P, so far up.
  void beside(View& view, const std::string& id, Role role, double part, std::string text) const {
    const dvec3 p = subject_.at().point;
    view.add({id, role, Text{at({p.x, p.y, part * p.z}) + dvec2{0.6, 0}, std::move(text), Align::left}});
  }
  /// With its length in the step that finds it.
  template <class Found>
  void add_tangent(View& view, const std::string& id, const std::string& name, const Found& found) const {
    const dvec3 here = subject_.at().point;
    if (found.length == 0) return;
    const dvec2 tip = at(here + half * found.tangent);
    view.add({id, Role::result, Stroke{at(here), tip, true}});
    add_beyond(view, id + " name", Role::result, at(here), tip,
               now<Found>() ? words_.say("length", {{"name", name}, {"length", found.length}}) : name);
  }

  const Words& words_;
  const Subject& subject_;
  const Globe globe_;
  const Chart chart_{};
  View background_{};
};

}  // namespace gradus::parametric_surface
