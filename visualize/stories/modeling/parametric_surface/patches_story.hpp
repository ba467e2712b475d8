#pragma once
// The sphere made into faces: rows of points, then the strips between them; what belongs together in the
// rectangle of parameters and on the mesh.

#include <set>

#include "stories/modeling/parametric_surface/drawing.hpp"
#include "stories/past.hpp"
#include "stories/rendered_surface.hpp"

namespace gradus::parametric_surface {

/// Of more faces than this a picture is drawn, of more columns no points.
inline constexpr std::size_t most_drawn = 300;
inline constexpr int most_dotted = 24;

/// What is counted of a mesh by its faces alone.
struct Counted {
  std::set<std::pair<std::int32_t, std::int32_t>> once{}, all{};  ///< edges: with one face, with any

  explicit Counted(const Faces& faces) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto ring = faces[f];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::pair edge = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
        if (!all.insert(edge).second)
          once.erase(edge);
        else
          once.insert(edge);
      }
    }
  }
};

/// Faces of a mesh in space. role(strip): how those of a strip look, from 0 on.
template <class RoleOf>
void add_mesh(View& view, const Globe& globe, const Patches<double>& mesh, const RoleOf& role) {
  const auto of = [&](std::int32_t p) { return upright(mesh.points[static_cast<std::size_t>(p)]); };
  SpaceDrawing drawing(globe.reader().look(globe.panel()));
  const auto columns = static_cast<std::size_t>(mesh.n);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Ring ring;
    for (const std::int32_t p : mesh.faces[f]) {
      if (ring.empty() || (of(p) != ring.back() && of(p) != ring.front())) ring.push_back(of(p));
    }
    const Role its = role(static_cast<int>(f / columns), f % columns);
    if (glm::dot(area_vector(ring), globe.reader().towards) <= 0) continue;
    for (std::size_t i = 0; i < ring.size(); ++i)
      drawing.add(SpaceEdge{.id = fmt::format("f e {:04} {}", f, i),
                            .role = Role::past,
                            .a = ring[i],
                            .b = ring[(i + 1) % ring.size()],
                            .thin = true,
                            .behind = false});
    drawing.add(
        SpaceFace{.id = "f", .role = its, .ring = std::move(ring), .shade = its == Role::guide ? 1 : 0});
  }
  drawing.add_to(view, "f");
}

class PatchesStory : public Past<steps::Started, RowMade, StripMade, Finished> {
 public:
  PatchesStory(const Words& words, const Subject& subject, Patches<double> mesh)
      : words_(words), subject_(subject), mesh_(std::move(mesh)), counted_(mesh_.faces), globe_(subject) {
    globe_.add_to(background_);
    chart_.add_to(chart_background_, words, subject.n, subject.m, closed());
  }

  double tells(const auto& step) const {
    return std::same_as<std::decay_t<decltype(step)>, Finished> ? 1 : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = "patches.started",
            .words = {{"n", subject_.n}, {"m", subject_.m}, {"r", subject_.radius}}};
  }
  Event say(const RowMade& d) const {
    const bool pole = is_pole(d);
    return {
        .text = d.points == 1 ? "row_made.pole"
                : pole        ? "row_made.many"
                : closed()    ? "row_made"
                              : "row_made.twice",
        .facts = {{"row", d.row}, {"points", std::int64_t{d.points}}},
        .words = {{"t", degrees(latitude_of(d.row))}, {"first", d.first + 1}, {"last", d.first + d.points}},
        .row = {words_.say("row", {{"row", d.row}}), degrees(latitude_of(d.row)), d.points,
                d.first + d.points, 0},
        .key = fmt::format("row {}", d.row),
        .phase = words_.say("phase.points"),
        .decides =
            yes_or_no(words_, "question.pole", {{"t", degrees(latitude_of(d.row))}}, pole, "pole", "ring")};
  }
  Event say(const StripMade& d) const {
    const bool pole = d.row == 1 || d.row == subject_.m;
    return {.text = !pole      ? "strip_made"
                    : closed() ? "strip_made.pole"
                               : "strip_made.collapsed",
            .facts = {{"strip", d.row}, {"faces", static_cast<std::int64_t>(d.faces)}},
            .words = {{"from", degrees(latitude_of(d.row - 1))},
                      {"to", degrees(latitude_of(d.row))},
                      {"n", subject_.n}},
            .row = {words_.say("strip", {{"strip", d.row}}), degrees(latitude_of(d.row - 1)), subject_.n,
                    mesh_.points.size(), d.faces},
            .key = fmt::format("strip {}", d.row),
            .phase = words_.say("phase.faces")};
  }
  Event say(const Finished& d) const {
    return {.text = closed() ? "patches.finished" : "patches.finished.open",
            .facts = {{"V", static_cast<std::int64_t>(d.points)},
                      {"E", static_cast<std::int64_t>(counted_.all.size())},
                      {"F", static_cast<std::int64_t>(d.faces)},
                      {"euler", euler()},
                      {"boundary", static_cast<std::int64_t>(counted_.once.size())}},
            .words = {{"off", off_sphere(subject_.radius, subject_.n, subject_.m)}},
            .key = "mesh"};
  }

  View draw() const {
    View view = chart_background_;
    const std::size_t rows = all<RowMade>().size();
    const int strips = static_cast<int>(all<StripMade>().size());
    if (strips > 0 || now<Finished>())
      add_faces(view, strips);
    else
      view.marks.insert(background_.marks.begin(), background_.marks.end());
    for (std::size_t j = 0; j < rows; ++j) add_row(view, all<RowMade>()[j]);
    if (closed()) add_joined(view, strips);
    if (const auto* d = now<StripMade>()) {
      const Ring2 strip{chart_.at(0, latitude_of(d->row - 1)), chart_.at(360, latitude_of(d->row - 1)),
                        chart_.at(360, latitude_of(d->row)), chart_.at(0, latitude_of(d->row))};
      view.add({"j strip", Role::current, Area{{strip}}});
    }
    if (!now<Finished>()) return view;
    if (!closed()) add_boundary(view);
    add_line(view, 0, "V − E + F");
    add_line(view, 1,
             fmt::format("= {} − {} + {} = {}", mesh_.points.size(), counted_.all.size(), mesh_.faces.size(),
                         euler()));
    return view;
  }

 private:
  bool closed() const { return counted_.once.empty(); }
  bool is_pole(const RowMade& row) const { return row.row % subject_.m == 0; }
  std::int64_t euler() const {
    return std::ssize(mesh_.points) - std::ssize(counted_.all) +
           static_cast<std::int64_t>(mesh_.faces.size());
  }
  double latitude_of(int row) const { return 180.0 * row / subject_.m - 90; }
  static void add_line(View& view, int line, std::string text) {
    view.add({fmt::format("y {}", line), Role::result,
              Text{{chart_place.centre().x, 21 - 1.9 * line}, std::move(text)}});
  }
  void add_faces(View& view, int strips) const {
    if (mesh_.faces.size() > most_drawn) {
      const Extent shown = globe_.panel().shown();
      if (!picture_)
        picture_ = rendered_surface(mapped(mesh_.points, upright), mesh_.faces,
                                    {.right = globe_.reader().right,
                                     .up = globe_.reader().up,
                                     .towards = globe_.reader().towards,
                                     .shown = shown,
                                     .faceted = true});
      view.add({"f", Role::past,
                Picture{globe_.panel().at(shown.lower), globe_.panel().at(shown.upper), picture_}});
      return;
    }
    const bool done = now<Finished>() != nullptr;
    add_mesh(view, globe_, mesh_, [&](int strip, std::size_t) {
      if (done) return Role::input;
      return strip + 1 == strips ? Role::current : strip < strips ? Role::input : Role::guide;
    });
  }
  /// A row's points in the rectangle; those that another parameter has made already are rings.
  void add_row(View& view, const RowMade& row) const {
    if (subject_.n > most_dotted) return;
    const bool fresh = &row == now<RowMade>();
    const Role made = closed() && is_pole(row) ? Role::accepted : Role::past;
    for (int i = 0; i <= subject_.n; ++i) {
      const bool again = i >= row.points;
      view.add({fmt::format("p {:02} {:02}", row.row, i), fresh ? Role::current : made,
                Dot{chart_.at(360.0 * i / subject_.n, latitude_of(row.row)), again}});
    }
    if (!fresh) return;
    for (std::int32_t i = 0; i < row.points; ++i) {
      const dvec3 p = mesh_.points[static_cast<std::size_t>(row.first + i)];
      view.add({fmt::format("q {:02}", i), Role::current, Dot{globe_.at(p), !globe_.seen(p)}});
    }
  }
  /// Where sides of the rectangle lie on each other: the seam along the strips so far, and the poles.
  void add_joined(View& view, int strips) const {
    const auto first_of = [&](int row) {
      return mesh_.points[static_cast<std::size_t>(mesh_.row(row).first)];
    };
    for (int j = 0; j < strips; ++j) {
      const dvec3 p = first_of(j), q = first_of(j + 1);
      view.add({fmt::format("r seam {:02}", j), Role::boundary,
                Stroke{globe_.at(p), globe_.at(q), false, !globe_.seen(p + q)}});
    }
    for (const RowMade& row : all<RowMade>()) {
      const dvec3 p = first_of(row.row);
      if (is_pole(row) && &row != now<RowMade>())
        view.add({fmt::format("r pole {:02}", row.row), Role::accepted, Dot{globe_.at(p), !globe_.seen(p)}});
    }
  }
  /// Where the mesh is open: edges with one face.
  void add_boundary(View& view) const {
    std::size_t number = 0;
    for (const auto& [a, b] : counted_.once) {
      const dvec3 p = mesh_.points[static_cast<std::size_t>(a)],
                  q = mesh_.points[static_cast<std::size_t>(b)];
      const std::string id = fmt::format("s {:03}", number++);
      if (p == q)
        view.add({id, Role::rejected, Dot{globe_.at(p), !globe_.seen(p)}});
      else
        view.add({id, Role::rejected, Stroke{globe_.at(p), globe_.at(q), false, !globe_.seen(p + q)}});
    }
  }

  const Words& words_;
  const Subject& subject_;
  const Patches<double> mesh_;
  const Counted counted_;
  const Globe globe_;
  const Chart chart_{};
  View background_{}, chart_background_{};
  mutable std::shared_ptr<const Image> picture_{};
};

}  // namespace gradus::parametric_surface
