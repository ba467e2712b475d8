#pragma once
// A point of the sphere: the angle round the axis, the angle up the meridian, the point, both tangents, the
// normal.

#include "stories/modeling/parametric_surface/drawing.hpp"
#include "stories/modeling/parametric_surface/roots.hpp"
#include "stories/past.hpp"

namespace gradus::parametric_surface {

class PointStory : public Past<steps::Started, Turned<double>, Raised<double>, PointFound<double>,
                               AlongParallel<double>, AlongMeridian<double>, NormalFound<double>> {
 public:
  PointStory(const Words& words, const Subject& subject)
      : words_(words), subject_(subject), roots_(words, subject), globe_(subject) {
    globe_.add_to(background_);
    globe_.add_seam(background_);
    add_aside(background_, chart());
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
            .words = {{"s", degrees(subject_.s)}, {"direction", roots_.place(d.direction, 1)}},
            .row = row("e", d.direction, 1),
            .key = "e",
            .phase = words_.say("phase.angles")};
  }
  Event say(const Raised<double>& d) const {
    return {
        .text = d.ring == 0 ? "raised.pole" : "raised",
        .facts = {{"ring", d.ring}, {"height", d.height}},
        .words = {{"t", degrees(subject_.t)}, {"ring", of_radius(d.ring)}, {"height", of_radius(d.height)}},
        .note = words_.say("ring", {{"ring", of_radius(d.ring)}}),
        .row = row(words_.symbol("Q"), foot(), subject_.radius),
        .key = "Q",
        .phase = words_.say("phase.angles")};
  }
  Event say(const PointFound<double>& d) const {
    return {.text = "point_found",
            .facts = fields_of(d.point),
            .words = {{"point", roots_.place(d.point, subject_.radius)}},
            .note = fmt::format("{} = {}", words_.symbol("P"), roots_.place(d.point, subject_.radius)),
            .row = row(words_.symbol("P"), d.point, subject_.radius),
            .key = "P",
            .phase = words_.say("phase.point")};
  }
  Event say(const AlongParallel<double>& d) const {
    return {.text = d.length == 0 ? "along_parallel.pole" : "along_parallel",
            .facts = fields_of(d.tangent),
            .words = {{"tangent", roots_.place(d.tangent, subject_.radius)}, {"length", of_radius(d.length)}},
            .row = row(by_s(), d.tangent, subject_.radius),
            .key = by_s(),
            .phase = words_.say("phase.tangents"),
            .decides = yes_or_no(words_, "question.tangent", {{"t", degrees(subject_.t)}}, d.length != 0,
                                 "tangent", "none")};
  }
  Event say(const AlongMeridian<double>& d) const {
    return {.text = "along_meridian",
            .facts = fields_of(d.tangent),
            .words = {{"tangent", roots_.place(d.tangent, subject_.radius)}, {"length", of_radius(d.length)}},
            .note = words_.say("length", {{"name", by_t()}, {"length", of_radius(d.length)}}),
            .row = row(by_t(), d.tangent, subject_.radius),
            .key = by_t(),
            .phase = words_.say("phase.tangents")};
  }
  Event say(const NormalFound<double>& d) const {
    const bool found = has_normal();
    return {.text = found ? "normal_found" : "normal_found.none",
            .facts = found ? fields_of(d.normal) : std::vector<Field>{{"length", 0.0}},
            .words = {{"normal", found ? roots_.place(d.normal, 1) : "0/0"}, {"r", subject_.radius}},
            .note = found ? fmt::format("|{}| = 1", words_.symbol("N")) : words_.symbol("N") + " = 0/0",
            .row = found ? row(words_.symbol("N"), d.normal, 1)
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
        add_beyond(view, "p s name", Role::candidate, at(centre), at(0.42 * globe_.on(beside_axes(), 0)),
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
      if (subject_.t != 0) add_angle_t(view);
    }
    if (const auto* d = now<Raised<double>>()) {
      const double off = at(foot()).y < at(here).y ? -3.5 : 3.5;
      view.add({"q ring name", Role::result,
                Text{at(foot()) + dvec2{0, off}, words_.say("ring", {{"ring", of_radius(d->ring)}})}});
      view.add({"q height name", Role::result,
                Text{at(glm::mix(foot(), here, 0.8)) + dvec2{0.6, 0},
                     words_.say("height", {{"height", of_radius(d->height)}}), Align::left}});
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

  /// The rectangle with the place of s and t, and the poles as whole sides.
  View chart() const {
    View view;
    chart_.add_to(view, words_, 12, 6, true);
    for (int k = 0; k <= 12; k += 2) {
      for (const double t : {-90.0, 90.0})
        view.add({fmt::format("l pole {:02} {}", k, t < 0), Role::accepted, Dot{chart_.at(30 * k, t)}});
    }
    const dvec2 place = in_chart();
    view.add({"m down", Role::candidate, Stroke{place, {place.x, chart_.at(0, -90).y}, false, true}});
    view.add({"m left", Role::candidate, Stroke{place, {chart_.at(0, 0).x, place.y}, false, true}});
    view.add({"o dot", Role::current, Dot{place}});
    view.add({"o text", Role::current,
              Text{{chart_place.centre().x, chart_place.upper.y + 1.3},
                   words_.say("pair", {{"s", degrees(subject_.s)}, {"t", degrees(subject_.t)}}),
                   Align::centre,
                   true}});
    return view;
  }

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
  std::string of_radius(double length) const { return roots_.text(length, subject_.radius); }
  std::vector<Said> row(const std::string& name, dvec3 p, double size) const {
    return {name, roots_.text(p.x, size), roots_.text(p.y, size), roots_.text(p.z, size)};
  }
  /// Where on the arc of s its name stands: about half way, and on no axis.
  double beside_axes() const {
    const double middle = subject_.s_shown() / 2, off = std::remainder(middle, 90);
    constexpr double near = 15, away = 25;
    return middle > near && std::abs(off) < near ? middle - off - away : middle;
  }
  /// Beside Q, on the sides on which arrows from P have no names.
  void add_angle_t(View& view) const {
    const dvec2 place = at(foot()) + dvec2{-0.6, subject_.t > 0 ? -1.9 : 1.9};
    view.add({"p t name", Role::candidate,
              Text{place, words_.say("angle.t", {{"t", degrees(subject_.t)}}), Align::right}});
  }
  void add_tangent(View& view, const std::string& id, const std::string& name, const auto& found) const {
    const dvec3 here = subject_.at().point;
    if (found.length == 0) return;
    const dvec2 tip = at(here + half * found.tangent);
    view.add({id, Role::result, Stroke{at(here), tip, true}});
    add_beyond(view, id + " name", Role::result, at(here), tip, name);
  }

  const Words& words_;
  const Subject& subject_;
  const Roots roots_;
  const Globe globe_;
  const Chart chart_{};
  View background_{};
};

}  // namespace gradus::parametric_surface
