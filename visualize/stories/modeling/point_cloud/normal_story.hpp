#pragma once
// The normal of one point: its neighbours, how they spread, which way is across them, and which side of it
// the eye sees; then all points in the light of their normals.

#include <array>

#include "stories/modeling/point_cloud/subject.hpp"
#include "stories/past.hpp"

namespace gradus::point_cloud {

enum class Way { right, uncentred, unturned };

template <Way way, class... Watch>
Surface normal_by(const Tree<double>& tree, Index i, std::size_t k, dvec3 eye, Watch&&... watch) {
  if constexpr (way == Way::right) return normal(tree, i, k, eye, watch...);
  if constexpr (way == Way::uncentred) return uncentred(tree, i, k, eye, watch...);
  if constexpr (way == Way::unturned) return unturned(tree, i, k, eye, watch...);
}

/// The normals of all points, and what the search of one has cost.
struct Whole {
  std::vector<dvec3> normals;
  std::int64_t without = 0, away = 0;  ///< points without one, and those whose normal points away
  double worst = 0, in_the_mean = 0;   ///< angles to the known ones in degrees
  std::int64_t distances = 0;
};

/// Between two lines with these directions of length 1, in degrees.
inline double angle_between(dvec3 a, dvec3 b) {
  return gradus::asin(std::min(1.0, length_of(glm::cross(a, b)))) * 360 / two_pi;
}

template <Way way>
Whole whole_of(const Subject& subject) {
  Whole all;
  double sum = 0;
  for (Index i = 0; i < subject.points.size(); ++i) {
    const Surface n = normal_by<way>(subject.tree, i, subject.k, subject.eye);
    all.normals.push_back(n.way);
    if (n.shape != Shape::surface) {
      ++all.without;
      continue;
    }
    if (glm::dot(n.way, subject.eye - subject.points[i]) < 0) ++all.away;
    if (subject.normals.empty()) continue;
    const double angle = angle_between(n.way, subject.normals[i]);
    all.worst = std::max(all.worst, angle);
    sum += angle;
  }
  const auto count = std::ssize(subject.points) - all.without;
  all.in_the_mean = count > 0 ? sum / static_cast<double>(count) : 0;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, kd_tree::Finished>) all.distances = step.distances;
  };
  kd_tree::nearest<3, double>(subject.tree, subject.own(), subject.k, watch);
  return all;
}

class NormalStory : public Past<steps::Started, Gathered<double>, Centred<double>, Fitted<double>,
                                Turned<double>, steps::Finished> {
 public:
  NormalStory(const Words& words, const Subject& subject, Way way, Whole whole)
      : words_(words),
        subject_(subject),
        way_(way),
        whole_(std::move(whole)),
        right_(way == Way::right ? std::vector<dvec3>{} : whole_of<Way::right>(subject).normals),
        panel_(space, {}) {
    for (const dvec3 p : subject.points) {
      cloud_.add(subject.reader.flat(p));
      const double forward = glm::dot(p, subject.reader.towards);
      forward_ = {std::min(forward_.x, forward), std::max(forward_.y, forward)};
    }
    Extent extent = cloud_;
    extent.add(subject.reader.flat(subject.eye));
    panel_ = Panel(space, extent);
    for (std::size_t i = 0; i < right_.size(); ++i)
      off_ += angle_between(whole_.normals[i], right_[i]) / static_cast<double>(right_.size());
  }

  const Panel& panel() const { return panel_; }
  dvec2 at(dvec3 p) const { return panel_.at(subject_.reader.flat(p)); }

  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if constexpr (std::same_as<Step, steps::Finished>) return way_ == Way::right ? 0 : 3;
    if constexpr (std::same_as<Step, Turned<double>>) return 2;
    return std::same_as<Step, Fitted<double>> ? 1 : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = "started",
            .words = {{"place", short_place(subject_.own())}, {"k", subject_.k}},
            .count = std::ssize(subject_.points)};
  }
  Event say(const Gathered<double>& g) const {
    return {.text = "gathered",
            .facts = {{"neighbours", std::ssize(g.near)}, {"distances", whole_.distances}},
            .words = {{"far", std::sqrt(g.near.back().distance)}, {"points", subject_.points.size()}},
            .count = std::ssize(g.near),
            .note = words_.say("effect.gathered", {{"far", short_real(std::sqrt(g.near.back().distance))}}),
            .key = "neighbours",
            .phase = words_.say("phase.near")};
  }
  Event say(const Centred<double>& c) const {
    return {.text = way_ == Way::uncentred ? "centred.uncentred" : "centred",
            .facts = fields_of(c.mean),
            .words = {{"mean", short_place(subject_.own() + c.mean)}},
            .row = {words_.say("mean"), short_place(subject_.own() + c.mean)},
            .key = "m",
            .phase = words_.say("phase.spread")};
  }
  Event say(const Fitted<double>& f) const {
    constexpr std::array names{"surface", "one_place", "in_line", "alike"};
    constexpr std::array branches{"surface", "one place", "in line", "alike"};
    const auto shape = static_cast<std::size_t>(f.shape);
    std::vector<std::string> answers;
    for (const char* name : names) answers.push_back(words_.say(fmt::format("shape.{}", name)));
    return {.text = fmt::format("fitted.{}", names[shape]),
            .facts = {{"least", f.variance[0]}, {"middle", f.variance[1]}, {"most", f.variance[2]}},
            .words = {{"least", figure_real(f.variance[0])},
                      {"middle", figure_real(f.variance[1])},
                      {"most", figure_real(f.variance[2])},
                      {"part", percent(variation(f))}},
            .note = fmt::format("λ₀: {} %", percent(variation(f))),
            .row = {"λ₀", figure_real(f.variance[0])},
            .key = "λ",
            .phase = words_.say("phase.spread"),
            .decides = Decision{words_.say("question.shape"), answers, shape, branches[shape]}};
  }
  Event say(const Turned<double>& t) const {
    const dvec3 before = last<Fitted<double>>()->ways[0], to_eye = unit_vector(subject_.eye - subject_.own());
    const double along = glm::dot(before, to_eye);
    Event event{.text = way_ == Way::unturned ? "unturned"
                        : t.turned            ? "turned"
                                              : "kept",
                .facts = fields_of(t.normal),
                .words = {{"before", short_place(before)},
                          {"normal", short_place(t.normal)},
                          {"along", short_real(along)}},
                .note = words_.say(t.turned ? "effect.turned" : "effect.kept"),
                .row = {words_.say("normal"), short_place(t.normal)},
                .key = "n",
                .phase = words_.say("phase.side")};
    if (way_ != Way::unturned)
      event.decides = yes_or_no(words_, "question.away", {}, t.turned, "turned", "kept");
    return event;
  }
  Event say(const steps::Finished&) const {
    return {.text = way_ == Way::uncentred  ? "finished.uncentred"
                    : way_ == Way::unturned ? "finished.unturned"
                    : is_known()            ? "finished.known"
                                            : "finished",
            .facts = {{"without", whole_.without}, {"away", whole_.away}},
            .words = {{"points", subject_.points.size()},
                      {"with", std::ssize(subject_.points) - whole_.without},
                      {"mean", degrees(whole_.in_the_mean)},
                      {"worst", degrees(whole_.worst)},
                      {"off", degrees(off_)}}};
  }

  View draw() const {
    View view;
    if (now<steps::Finished>()) {
      add_pictures(view);
      return view;
    }
    add_plane(view);
    add_points(view);
    add_normal(view);
    view.add_named("z eye", Role::measure, at(subject_.eye), words_.say("eye"));
    add_side(view);
    add_costs(view);
    return view;
  }

 private:
  static constexpr Extent space{{0.6, 0.8}, {24.8, 25.2}}, side{{27, 12}, {38.6, 23.6}};

  /// Whether there are normals, and what they ought to be.
  bool is_known() const { return !subject_.normals.empty() && whole_.without < std::ssize(subject_.points); }
  static double variation(const Fitted<double>& f) { return Surface{f.shape, {}, f.variance}.variation(); }
  std::vector<Index> near() const {
    std::vector<Index> all;
    if (const auto* g = last<Gathered<double>>()) {
      for (const auto& n : g->near) all.push_back(n.point);
    }
    return all;
  }
  dvec3 middle() const { return subject_.own() + last<Centred<double>>()->mean; }
  /// Where an arrow of the normal ends.
  double arrow() const { return 0.5 * std::max(cloud_.size().x, cloud_.size().y); }

  /// Neighbours as dots; other points smaller, so that they hide no arrow: the larger, the nearer to the
  /// reader.
  void add_points(View& view) const {
    const std::vector<Index> neighbours = near();
    const double size =
        0.24 * std::sqrt(std::clamp(140 / static_cast<double>(subject_.points.size()), 0.25, 1.0));
    const auto nearness = [&](Index i) { return glm::dot(subject_.points[i], subject_.reader.towards); };
    for (Index i = 0; i < subject_.points.size(); ++i) {
      const bool is_near = std::ranges::find(neighbours, i) != neighbours.end();
      if (i == subject_.point || (subject_.is_hidden(i) && !is_near)) continue;
      const double part = (nearness(i) - forward_.x) / std::max(forward_.y - forward_.x, 1e-300);
      const dvec2 place = at(subject_.points[i]);
      if (!is_near) {
        view.add({fmt::format("p {:04}", i), Role::boundary,
                  Area{{round_ring(place, size * (0.7 + 0.5 * part))}}});
        continue;
      }
      view.add({fmt::format("p {:04}", i), Role::candidate, Dot{place}});
      view.add({fmt::format("l {:04}", i), Role::candidate,
                Stroke{at(last<Centred<double>>() ? middle() : subject_.own()), place, false, false, true}});
    }
    if (last<Centred<double>>()) view.add({"q m", Role::accepted, Dot{at(middle())}});
    // Later their names would lie among the neighbours' dots
    if (now<Centred<double>>())
      view.add({"q m name", Role::accepted, Label{at(middle()), words_.say("mean")}});
    view.add({"r p", Role::current, Dot{at(subject_.own())}});
    if (!last<Fitted<double>>())
      view.add({"r p name", Role::current, Label{at(subject_.own()), words_.say("own")}});
  }
  /// A square across the least variance, and in it the ellipse of twice the others' lengths.
  void add_plane(View& view) const {
    const auto* f = last<Fitted<double>>();
    if (!f || f->shape != Shape::surface) return;
    const dvec3 a = 2.2 * std::sqrt(f->variance[2]) * f->ways[2],
                b = 2.2 * std::sqrt(f->variance[1]) * f->ways[1];
    const double wide = length_of(a);
    const dvec3 c = wide / std::max(length_of(b), 1e-300) * b;
    const std::vector<dvec3> ring{middle() + a + c, middle() - a + c, middle() - a - c, middle() + a - c};
    const std::vector<dvec2> flat = mapped(ring, [&](dvec3 p) { return at(p); });
    view.add({"a plane", Role::accepted, Area{{flat}, 1}});
    view.add({"b plane", Role::accepted, Path{flat, true}});
    const std::vector<dvec2> round =
        mapped(round_ring({0, 0}, 1 / 1.1, 60), [&](dvec2 p) { return at(middle() + p.x * a + p.y * b); });
    view.add({"c ellipse", Role::accepted, Path{round, true}});
  }
  void add_normal(View& view) const {
    const auto* f = last<Fitted<double>>();
    if (!f || f->shape != Shape::surface) return;
    const auto* t = last<Turned<double>>();
    const dvec3 n = t ? t->normal : f->ways[0], from = subject_.own();
    const dvec2 tip = at(from + arrow() * n), other = at(from - arrow() * n);
    view.add({"s normal", Role::result, Stroke{at(from), tip, true, !t}});
    view.add({"s other", t ? Role::rejected : Role::result, Stroke{at(from), other, true, true}});
    if (!t) return;
    view.add({"s name", Role::result, Label{tip, words_.say("normal")}});
    if (way_ == Way::unturned) return;
    view.add({"y sight", Role::measure, Stroke{at(from), at(subject_.eye), false, true, true}});
  }

  /// The neighbours as they are seen along the plane: what is least is upright.
  void add_side(View& view) const {
    const auto* f = last<Fitted<double>>();
    if (!f || f->variance[2] == 0) return;
    view.add({"u heading", Role::guide,
              Text{{side.centre().x, side.upper.y + 1.3}, words_.say("side"), Align::centre, true}});
    const auto* t = last<Turned<double>>();
    const dvec3 up = t ? t->normal : f->ways[0], along = f->ways[2];
    const auto seen = [&](dvec3 p) {
      return dvec2{glm::dot(p - middle(), along), glm::dot(p - middle(), up)};
    };
    const double reach = 2.6 * std::sqrt(f->variance[2]);
    const Panel panel(side, {{-reach, -reach}, {reach, reach}});
    const dvec2 axes{2 * std::sqrt(f->variance[2]), 2 * std::sqrt(f->variance[0])};
    view.add({"v flat", Role::accepted, Stroke{panel.at(dvec2{-reach, 0}), panel.at(dvec2{reach, 0})}});
    const std::vector<dvec2> round =
        mapped(round_ring({0, 0}, 1, 60), [&](dvec2 p) { return panel.at(p * axes); });
    view.add({"v ellipse", Role::accepted, Path{round, true}});
    for (const Index i : near())
      view.add({fmt::format("w {:04}", i), i == subject_.point ? Role::current : Role::candidate,
                Dot{panel.at(glm::clamp(seen(subject_.points[i]), -reach, reach))}});
    if (f->shape != Shape::surface) return;
    const dvec2 from = panel.at(dvec2{0, 0}), length{0, 0.8 * reach};
    view.add({"x normal", Role::result, Stroke{from, panel.at(length), true, !t}});
    if (t)
      view.add({"x name", Role::result, Label{panel.at(length), words_.say("normal")}});
    else
      view.add({"x other", Role::result, Stroke{from, panel.at(-length), true, true}});
  }
  void add_line(View& view, int line, Role role, const std::string& text) const {
    view.add({fmt::format("y {:02}", line), role, Text{{25.4, 9.6 - 1.85 * line}, text, Align::left, true}});
  }
  void add_costs(View& view) const {
    const auto* f = last<Fitted<double>>();
    if (f) {
      add_line(view, 0, Role::accepted, fmt::format("λ₂ = {}", figure_real(f->variance[2])));
      add_line(view, 1, Role::accepted, fmt::format("λ₁ = {}", figure_real(f->variance[1])));
      add_line(
          view, 2, Role::result,
          words_.say("least", {{"least", figure_real(f->variance[0])}, {"part", percent(variation(*f))}}));
    }
    if (last<Gathered<double>>())
      add_line(view, 3, Role::guide,
               words_.say("cost.distances", {{"n", whole_.distances}, {"points", subject_.points.size()}}));
    add_line(view, 4, Role::guide,
             words_.say("cost.bytes", {{"points", subject_.points.size() * sizeof(dvec3)},
                                       {"tree", subject_.points.size() * sizeof(kd_tree::Node)}}));
  }

  /// All points in the light of their normals; beside it the right ones, or points without any.
  void add_pictures(View& view) const {
    const bool wrong = way_ != Way::right;
    const Extent left{{0, 0.3}, {24, 24.3}}, right{{25.1, 9.4}, {40, 24.3}};
    add_picture(view, "a", left, words_.say(wrong ? "picture.wrong" : "picture"), whole_.normals, false);
    add_picture(view, "b", right, words_.say(wrong ? "picture.right" : "picture.plain"), right_, true);
    if (!wrong && is_known())
      add_line(view, 2, Role::result, words_.say("angle", {{"mean", degrees(whole_.in_the_mean)}}));
  }
  void add_picture(View& view, const std::string& id, const Extent& place, std::string heading,
                   std::span<const dvec3> normals, bool aside) const {
    constexpr int pixels = 560;
    const Extent shown = widened(cloud_, 0.03);
    const double longer = longer_side(shown);
    const Screen screen{shown.centre() - 0.5 * longer, longer, pixels};
    const int radius =
        std::max(1, static_cast<int>(0.3 * pixels /
                                     std::sqrt(std::max(1.0, static_cast<double>(subject_.points.size())))));
    const Panel panel(place, {screen.lower, screen.lower + longer});
    view.add({id + " picture", Role::input,
              Picture{panel.at(screen.lower), panel.at(screen.lower + longer),
                      shaded(subject_, normals, screen, radius), aside}});
    view.add({id + " heading", Role::guide,
              Text{{place.centre().x, place.upper.y + 1}, std::move(heading), Align::centre, aside}});
  }

  const Words& words_;
  const Subject& subject_;
  const Way way_;
  const Whole whole_;
  const std::vector<dvec3> right_;  ///< of a mistake
  double off_ = 0;                  ///< in the mean from these
  Extent cloud_{};
  dvec2 forward_{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  Panel panel_;
};

}  // namespace gradus::point_cloud
