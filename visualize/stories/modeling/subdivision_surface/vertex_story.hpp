#pragma once
// What one vertex of a control mesh gets round it and where it goes, with the weights of its neighbours, then
// level by level.

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "modeling/subdivision_surface/subdivision_surface_notes.hpp"
#include "stories/modeling/subdivision_surface/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::subdivision_surface {

enum class Way { catmull_clark, loop, always_four };

template <Way way>
constexpr auto level_of = [](const Control& mesh, const auto&... a) {
  if constexpr (way == Way::catmull_clark) return catmull_clark_level(mesh, a...);
  if constexpr (way == Way::loop) return loop_level(mesh, a...);
  if constexpr (way == Way::always_four) return always_four(mesh, a...);
};

/// The levels, from the control mesh on, and the report of each: the run itself, told once all are known.
struct Levels {
  struct Report {
    LevelDone done;
    int line;
    const char* file;
  };
  std::vector<Control> meshes;
  std::vector<Report> reports{};
};
template <Way way>
Levels levels_of(const Subject& subject) {
  Levels levels{{subject.mesh}};
  const auto keep = [&]<class Step>(const Step& step, int line = __builtin_LINE(),
                                    const char* file = __builtin_FILE()) {
    if constexpr (std::same_as<Step, LevelDone>) levels.reports.push_back({step, line, file});
  };
  for (int k = 1; k <= subject.levels; ++k)
    levels.meshes.push_back(level_of<way>(levels.meshes.back(), k, keep));
  return levels;
}

class VertexStory : public Past<steps::Started, FacePointFound<double>, EdgePointFound<double>,
                                VertexPointFound<double>, LevelDone> {
 public:
  VertexStory(const Words& words, const Subject& subject, const Links& links, Way way,
              std::vector<Control> levels, const Weights& weights)
      : words_(words),
        subject_(subject),
        links_(links),
        way_(way),
        levels_(std::move(levels)),
        weights_(weights),
        right_(way == Way::always_four ? catmull_clark(subject.mesh, 1) : Control{}),
        pictures_(words, subject, levels_[1], right_),
        star_(links, subject.vertex, star_centre, star_radius),
        star_faces_(faces_at(subject.mesh, subject.vertex)) {
    background_ = outer_pictures();
  }

  dvec2 at(dvec3 p) const { return pictures_.at(control_picture(places[0]), p); }
  const Control& level(int k) const { return levels_[static_cast<std::size_t>(k)]; }

  bool concerns(const FacePointFound<double>& s) const { return s.level == 1 && is_in(star().faces, s.face); }
  bool concerns(const EdgePointFound<double>& s) const { return s.level == 1 && is_in(star().edges, s.edge); }
  bool concerns(const VertexPointFound<double>& s) const {
    return s.level == 1 && s.vertex == subject_.vertex;
  }
  static bool concerns(const LevelDone&) { return false; }  // told once all levels are

  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if (std::same_as<Step, LevelDone>) return way_ == Way::always_four ? 2 : 0;
    return std::same_as<Step, VertexPointFound<double>> ? 1 : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = star().border() ? "started.border" : "started",
            .words = {{"vertex", subject_.vertex + 1},
                      {"place", subject_.of(subject_.mesh)},
                      {"edges", star().edges.size()},
                      {"faces", star().faces.size()}},
            .row = {words_.symbol("S"), short_place(subject_.of(subject_.mesh))}};
  }
  Event say(const FacePointFound<double>& s) const {
    const std::string name = fmt::format("F{}", all<FacePointFound<double>>().size());
    return {
        .text = "face_point",
        .facts = fields_of(s.point),
        .words = {{"name", name}, {"corners", links_.ring(s.face).size()}, {"point", short_place(s.point)}},
        .note = name,
        .row = {name, short_place(s.point)},
        .key = name,
        .phase = words_.say("phase.faces")};
  }
  Event say(const EdgePointFound<double>& s) const {
    const std::string name = fmt::format("E{}", all<EdgePointFound<double>>().size());
    return {.text = s.sharp == 1        ? "edge_point.sharp"
                    : s.sharp > 0       ? "edge_point.fading"
                    : way_ == Way::loop ? "edge_point.loop"
                                        : "edge_point",
            .facts = fields_of(s.point),
            .words = {{"name", name},
                      {"point", short_place(s.point)},
                      {"middle", short_place(s.middle)},
                      {"sharp", s.sharp}},
            .note = name,
            .row = {name, short_place(s.point)},
            .key = name,
            .phase = words_.say("phase.edges")};
  }
  Event say(const VertexPointFound<double>& s) const {
    const std::size_t kind = s.rule.corner > 0 ? 2 : s.rule.crease > 0 ? 1 : 0;
    const bool fades = s.rule.smooth < 1 && s.rule.crease < 1 && s.rule.corner < 1;
    constexpr std::array branches{"smooth", "crease", "corner"};
    std::vector<std::string> answers;
    for (const char* branch : branches) answers.push_back(words_.say(fmt::format("rule.{}", branch)));
    const auto [own, near, far] = weights();
    const WeightTexts weight = texts_of(at(subject_.vertex));
    return {.text = fades                 ? "vertex_point.fading"
                    : kind == 2           ? "vertex_point.corner"
                    : kind == 1           ? "vertex_point.crease"
                    : near < 0 || far < 0 ? "vertex_point.mixed"
                    : far > 0             ? "vertex_point"
                                          : "vertex_point.loop",
            .facts = fields_of(s.point),
            .words = {{"from", short_place(s.from)},
                      {"point", short_place(s.point)},
                      {"own", weight(own)},
                      {"near", weight(near)},
                      {"far", weight(far)},
                      {"rest", weight(1 - own)},
                      {"vertex", subject_.vertex + 1},
                      {"smooth", s.rule.smooth}},
            .note = moved(),
            .row = {moved(), short_place(s.point)},
            .key = "S′",
            .phase = words_.say("phase.vertex"),
            .decides = Decision{words_.say("question"), answers, kind, branches[kind]}};
  }
  Event say(const LevelDone& d) const {
    const Control& level = levels_[static_cast<std::size_t>(d.level)];
    const bool wrong = way_ == Way::always_four && level.faces.size() != subject_.mesh.faces.corners.size();
    return {.text = wrong          ? "level_done.wrong"
                    : d.level == 1 ? "level_done.first"
                                   : "level_done",
            .facts = {{"level", d.level}, {"vertices", d.vertices}, {"faces", d.faces}},
            .words = {{"place", short_place(subject_.of(level))},
                      {"before", levels_[static_cast<std::size_t>(d.level) - 1].faces.size()},
                      {"right", subject_.mesh.faces.corners.size()}},
            .note = words_.say("counts", {{"vertices", d.vertices}, {"faces", d.faces}}),
            .row = {words_.say("level", {{"level", d.level}}), short_place(subject_.of(level))},
            .key = fmt::format("{}", d.level),
            .phase = words_.say("phase.levels")};
  }

  View draw() const {
    if (const auto* done = now<LevelDone>()) return level_picture(done->level);
    View view = background_;
    star_.add_to(view);
    add_sharp_edges(view);
    for (const auto& s : all<FacePointFound<double>>())
      add_point(view, s, face_number(s.face), Role::accepted);
    for (const auto& s : all<EdgePointFound<double>>())
      add_point(view, s, edge_number(s.edge), Role::measure);
    view.add({"w dot", Role::current, Dot{star_centre}});
    if (const auto* f = now<FacePointFound<double>>()) {
      add_weights(view, face_number(f->face), Role::accepted);
      add_sum(view, face_number(f->face), fmt::format("F{}", all<FacePointFound<double>>().size()), f->point,
              Role::accepted);
    } else if (const auto* e = now<EdgePointFound<double>>()) {
      add_weights(view, edge_number(e->edge), Role::measure);
      add_sum(view, edge_number(e->edge), fmt::format("E{}", all<EdgePointFound<double>>().size()), e->point,
              Role::measure);
    } else if (const auto* v = now<VertexPointFound<double>>()) {
      add_weights(view, at(v->vertex), Role::current);
      if (way_ != Way::loop && v->rule.smooth == 1)
        add_means(view, *v);
      else
        add_sum(view, at(v->vertex), moved(), v->point, Role::current);
    }
    return view;
  }

 private:
  static std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }
  static bool is_in(std::span<const std::int32_t> numbers, std::int32_t number) {
    return std::ranges::find(numbers, number) != numbers.end();
  }
  const Star& star() const { return star_.star(); }
  std::size_t edge_number(std::int32_t e) const { return subject_.mesh.points.size() + at(e); }
  std::size_t face_number(std::int32_t f) const {
    return subject_.mesh.points.size() + links_.edges().size() + at(f);
  }

  LevelPicture control_picture(const Extent& place, bool aside = false) const {
    return {.id = aside ? "d" : "a",
            .place = place,
            .heading = words_.say("control"),
            .aside = aside,
            .marked = star_faces_};
  }
  LevelPicture level_picture_of(const std::string& id, const Extent& place, int k, bool aside = true) const {
    return {.id = id,
            .place = place,
            .heading = words_.say("level", {{"level", k}}),
            .aside = aside,
            .close = place.upper.y - place.lower.y > paper_height - 1};
  }
  /// The control mesh, the first level, and the last one or the right one.
  View outer_pictures() const {
    View view;
    add(view, control_picture(places[0]), 0);
    const LevelPicture first = level_picture_of("b", places[1], 1);
    add(view, first, 1);
    if (way_ == Way::always_four) {
      add_right(view, first, places[2]);
    } else if (subject_.levels > 1) {
      add(view, level_picture_of("c", places[2], subject_.levels), subject_.levels);
    }
    return view;
  }
  /// A level alone, large, and what it is made from or should be.
  View level_picture(int k) const {
    View view;
    // Beside the right one the wrong one is as high as the paper
    constexpr Extent wrong{{0, 0}, {25.6, 27}}, right{{25.8, 4}, {36, 27}};
    const bool is_wrong = way_ == Way::always_four;
    const LevelPicture whole = level_picture_of("a", is_wrong ? wrong : large_places[0], k, false);
    add(view, whole, k);
    if (is_wrong) {
      add_right(view, whole, right);
    } else {
      add(view, control_picture({{18.8, places[0].lower.y}, {35.8, 27}}, true), 0);
      add_course(view, k);
    }
    return view;
  }
  void add(View& view, const LevelPicture& picture, int k) const {
    pictures_.add(view, picture, level(k));
    pictures_.add_vertex(view, picture, subject_.of(level(k)));
  }
  /// The right level, and its faces that the one in this picture lacks.
  void add_right(View& view, const LevelPicture& wrong, const Extent& place) const {
    pictures_.add(
        view,
        {.id = "c", .place = place, .heading = words_.say("right"), .aside = true, .close = wrong.close},
        right_);
    for (std::size_t f = 0; f < right_.faces.size(); ++f) {
      if (!has_face(levels_[1], right_.faces[f])) pictures_.add_outline(view, wrong, right_, f);
    }
  }
  static bool has_face(const Control& mesh, std::span<const std::int32_t> ring) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (std::ranges::equal(mesh.faces[f], ring)) return true;
    }
    return false;
  }

  void add_sharp_edges(View& view) const {
    for (std::size_t k = 0; k < star().edges.size(); ++k) {
      const Edge& e = links_.edges()[at(star().edges[k])];
      if (e.sharpness > 0)
        view.add({fmt::format("s {:02}", k), Role::boundary,
                  Stroke{star_.places().at(e.a), star_.places().at(e.b)}});
    }
  }
  /// Where the star has a point of the next level.
  dvec2 flat(std::size_t point) const {
    dvec2 sum{0};
    for (std::size_t i = 0; i < weights_.vertices().size(); ++i)
      sum += weights_.of(i, point) * star_.places().at(weights_.vertices()[i]);
    return sum;
  }
  /// A point of the star.
  template <class Found>
  void add_point(View& view, const Found& found, std::size_t point, Role role) const {
    const bool fresh = &found == now<Found>();
    view.add({fmt::format("t {:05}", point), role, Dot{flat(point), !fresh}});
  }
  WeightTexts texts_of(std::size_t point) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < weights_.vertices().size(); ++i) all.push_back(weights_.of(i, point));
    return WeightTexts(all);
  }
  void add_weights(View& view, std::size_t point, Role role) const {
    const WeightTexts weight = texts_of(point);
    for (std::size_t i = 0; i < weights_.vertices().size(); ++i) {
      const double w = weights_.of(i, point);
      if (w == 0) continue;
      const std::int32_t v = weights_.vertices()[i];
      if (v == subject_.vertex) {
        view.add({"x own", role, Label{star_centre, weight(w)}});
        continue;
      }
      view.add({fmt::format("w {:05}", v), Role::input, Dot{star_.places().at(v)}});
      view.add({fmt::format("x {:05}", v), role, Text{star_.beside(v), weight(w), Align::centre}});
    }
  }
  /// What the vertex itself, a neighbour and a corner across from it count; 0: nothing, -1: not all the same.
  std::array<double, 3> weights() const {
    std::array<double, 3> found{};
    for (std::size_t i = 0; i < weights_.vertices().size(); ++i) {
      const std::int32_t v = weights_.vertices()[i];
      const auto is_near = [&](std::int32_t e) { return links_.across(e, subject_.vertex) == v; };
      const bool near = std::ranges::any_of(star().edges, is_near);
      double& kind = found[v == subject_.vertex ? 0 : near ? 1 : 2];
      const double w = weights_.of(i, at(subject_.vertex));
      kind = kind == 0 || std::abs(kind - w) < 1e-9 ? w : -1;
    }
    return found;
  }

  // Lines beside the star

  /// The point as a sum of vertices, each with its weight.
  void add_sum(View& view, std::size_t point, const std::string& name, dvec3 sum, Role role) const {
    const WeightTexts weight = texts_of(point);
    std::vector<std::string> terms;
    for (std::size_t i = 0; i < weights_.vertices().size(); ++i) {
      const double w = weights_.of(i, point);
      const std::int32_t v = weights_.vertices()[i];
      if (w != 0)
        terms.push_back(fmt::format("{} · {}", weight(w), short_place(subject_.mesh.points[at(v)])));
    }
    const std::size_t most = terms.size() > 6 ? 5 : 6;
    int line = 0;
    for (std::size_t i = 0; i < terms.size() && i < most; ++i)
      add_line(view, line++, Role::past, (i > 0 ? "+ " : "") + terms[i]);
    if (terms.size() > most) add_line(view, line++, Role::past, "…");
    add_line(view, line, role, fmt::format("{} = {}", name, short_place(sum)));
  }
  /// S'.
  std::string moved() const { return words_.symbol("S") + "′"; }
  void add_means(View& view, const VertexPointFound<double>& s) const {
    const std::string Q = words_.symbol("Q"), R = words_.symbol("R"), S = words_.symbol("S");
    add_line(view, 0, Role::accepted, fmt::format("{} = {}", Q, short_place(s.faces)));
    add_line(view, 1, Role::measure, fmt::format("{} = {}", R, short_place(s.middles)));
    add_line(view, 2, Role::current, fmt::format("{} = {}", S, short_place(s.from)));
    const auto n = static_cast<int>(star().edges.size());
    const std::string own =
        n == 3 ? "" : fmt::format(" {} {}{}", n > 3 ? "+" : "−", n > 4 ? fmt::format("{}", n - 3) : "", S);
    add_line(view, 3, Role::current, fmt::format("{} = ({} + 2{}{}) / {}", moved(), Q, R, own, n));
    add_line(view, 4, Role::current, fmt::format("= {}", short_place(s.point)));
    if (!links_.fades(star()))
      add_line(view, 5, Role::result,
               words_.say("ends", {{"place", short_place(limit(subject_.mesh, subject_.vertex).point)}}));
  }
  void add_course(View& view, int level) const {
    int line = 0;
    const auto add = [&](const std::string& name, dvec3 p, Role role) {
      add_line(view, line++, role, fmt::format("{}: {}", name, short_place(p)));
    };
    for (int k = 0; k <= level; ++k)
      add(k == 0 ? words_.say("control") : words_.say("level", {{"level", k}}),
          subject_.of(levels_[static_cast<std::size_t>(k)]), k == level ? Role::current : Role::past);
    if (way_ == Way::catmull_clark && !links_.fades(star()))
      add(words_.say("limit"), limit(subject_.mesh, subject_.vertex).point, Role::result);
  }

  const Words& words_;
  const Subject& subject_;
  const Links& links_;
  const Way way_;
  const std::vector<Control> levels_;
  const Weights& weights_;
  const Control right_;  ///< the first level, where it is told wrong
  const LevelPictures pictures_;
  const StarDrawing star_;
  const std::vector<std::int32_t> star_faces_;
  View background_{};
};

}  // namespace gradus::subdivision_surface
