#pragma once
// Levels of a surface as pictures, and the star of a vertex with weights.

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "stories/modeling/subdivision_surface/subject.hpp"
#include "stories/rendered_surface.hpp"

namespace gradus::subdivision_surface {

/// Drawings of lines for up to so many faces; more are rendered, up to so many with lines between them.
inline constexpr std::size_t most_drawn = 300, most_faceted = 900;

inline constexpr int paper_width = 36, paper_height = 27;
/// Three pictures above.
inline constexpr std::array<Extent, 3> places{
    {{{0.2, 13.6}, {11.8, 27}}, {{12.2, 13.6}, {23.8, 27}}, {{24.2, 13.6}, {35.8, 27}}}};
/// Below them a star on the left,
inline constexpr dvec2 star_centre{8, 5.9};
inline constexpr double star_radius = 5.2;
/// and on the right lines of text, from 0 on.
inline void add_line(View& view, int line, Role role, std::string text) {
  view.add({fmt::format("y {:02}", line), role,
            Text{{18, 11.6 - 1.75 * line}, std::move(text), Align::left, true}});
}

/// Pictures of the levels, all in one scale.
class LevelPictures {
 public:
  LevelPictures(const Words& words, const Subject& subject) : words_(words), subject_(subject) {
    for (const dvec3 p : subject.mesh.points) extent_.add(subject.reader.flat(p));
    extent_ = widened(extent_, 0.02);
  }

  /// Where a place of the surface is shown.
  dvec2 at(const Extent& place, dvec3 p) const { return panel(place).at(subject_.reader.flat(p)); }

  /// A picture below its heading. star: its faces at the vertex stand out.
  void add(View& view, const std::string& id, const Extent& place, std::string heading, const Control& mesh,
           bool star = false) const {
    const double middle = place.centre().x;
    view.add({id + " h", Role::boundary,
              Text{{middle, place.upper.y - 0.6}, std::move(heading), Align::centre, true}});
    view.add({id + " n", Role::past,
              Text{{middle, place.upper.y - 2.1},
                   words_.say("counts", {{"vertices", mesh.points.size()}, {"faces", mesh.faces.size()}}),
                   Align::centre,
                   true}});
    if (mesh.faces.size() <= most_drawn)
      draw(view, id, place, mesh, star);
    else
      render(view, id, place, mesh);
  }
  void add_vertex(View& view, const std::string& id, const Extent& place, dvec3 p) const {
    view.add({id, Role::current, Dot{at(place, p)}});
  }
  /// The face of another mesh that is missing here.
  void add_outline(View& view, const std::string& id, const Extent& place, const Control& mesh,
                   std::size_t f) const {
    const auto flat = [&](dvec3 p) { return at(place, p); };
    view.add({id, Role::rejected, Path{mapped(ring_of(mesh, f), flat), true}});
  }

 private:
  /// Below the heading.
  Panel panel(const Extent& place) const {
    return Panel({place.lower, place.upper - dvec2{0, 2.6}}, extent_);
  }
  static std::vector<dvec3> ring_of(const Control& mesh, std::size_t f) {
    std::vector<dvec3> ring;
    for (const auto v : mesh.faces[f]) ring.push_back(mesh.points[static_cast<std::size_t>(v)]);
    return ring;
  }
  void draw(View& view, const std::string& id, const Extent& place, const Control& mesh, bool star) const {
    const Panel shown = panel(place);
    const SpaceLook look = subject_.reader.look(shown);
    SpaceDrawing drawing(look);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto ring = ring_of(mesh, f);
      const bool stands_out = star && std::ranges::count(mesh.faces[f], subject_.vertex) > 0;
      const Role role = stands_out ? Role::current : Role::input;
      // A bent face as triangles, all in its own shade
      const int shade = is_flat(ring) ? 0 : shade_of(look.turned(area_vector(ring)));
      const auto add = [&](std::vector<dvec3> part) {
        drawing.add(
            SpaceFace{.id = id, .role = role, .ring = std::move(part), .one_sided = false, .shade = shade});
      };
      if (is_flat(ring)) {
        add(ring);
      } else {
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) add({ring[0], ring[i], ring[i + 1]});
      }
    }
    for (const auto& [a, b] : edges_between(mesh)) {
      drawing.add(SpaceEdge{.id = fmt::format("{} e {:04}", id, edges_++),
                            .role = Role::past,
                            .a = mesh.points[static_cast<std::size_t>(a)],
                            .b = mesh.points[static_cast<std::size_t>(b)],
                            .thin = true,
                            .behind = false});
    }
    drawing.add_to(view, id + " a");
    // Control meshes of animals pierce themselves a little: not worth lines
    std::erase_if(view.marks, [&](const auto& mark) { return mark.first.starts_with(id + " meets "); });
  }
  /// Each once, also of what is no surface.
  static std::vector<std::pair<std::int32_t, std::int32_t>> edges_between(const Control& mesh) {
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto ring = mesh.faces[f];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto [a, b] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
        edges.emplace(a, b);
      }
    }
    return {edges.begin(), edges.end()};
  }

  void render(View& view, const std::string& id, const Extent& place, const Control& mesh) const {
    const Panel shown = panel(place);
    const SurfaceLook look{.right = subject_.reader.right,
                           .up = subject_.reader.up,
                           .towards = subject_.reader.towards,
                           .shown = extent_,
                           .faceted = mesh.faces.size() <= most_faceted};
    auto& picture = rendered_[mesh.faces.size()];
    if (!picture) picture = rendered_surface(mesh.points, mesh.faces, look);
    view.add({id + " a", Role::past, Picture{shown.at(extent_.lower), shown.at(extent_.upper), picture}});
  }

  const Words& words_;
  const Subject& subject_;
  Extent extent_{};
  mutable std::size_t edges_ = 0;
  mutable std::map<std::size_t, std::shared_ptr<const Image>> rendered_{};  ///< by their faces
};

/// What each vertex of a control mesh counts in the points of the next level, by running the method on
/// points that are 1 in one vertex and 0 in all others.
class Weights {
 public:
  /// level(mesh): the points of the next one.
  template <class Level>
  Weights(const Control& mesh, std::vector<std::int32_t> vertices, const Level& level)
      : vertices_(std::move(vertices)) {
    for (std::size_t i = 0; i < vertices_.size(); i += 3) {
      Control units = mesh;
      for (dvec3& p : units.points) p = dvec3{0};
      for (int k = 0; k < 3 && i + static_cast<std::size_t>(k) < vertices_.size(); ++k)
        units.points[static_cast<std::size_t>(vertices_[i + static_cast<std::size_t>(k)])][k] = 1;
      triples_.push_back(level(units));
    }
  }

  const std::vector<std::int32_t>& vertices() const { return vertices_; }
  /// Of the i-th of these vertices in a point of the next level.
  double of(std::size_t i, std::size_t point) const {
    return triples_[i / 3][point][static_cast<int>(i % 3)];
  }

 private:
  std::vector<std::int32_t> vertices_;
  std::vector<std::vector<dvec3>> triples_;
};

/// The vertices of the faces at a vertex, laid flat: its neighbours on a circle, the rest of each face
/// between two of them.
class StarDrawing {
 public:
  /// links: must outlive it.
  StarDrawing(const Links& links, std::int32_t vertex, dvec2 centre, double radius)
      : centre_(centre), star_(links.star(vertex)) {
    const auto n = static_cast<double>(star_.edges.size());
    const double turn = star_.border() ? 180 / (n - 1) : 360 / n, from = star_.border() ? 0 : 90;
    const auto on_circle = [&](double k, double part) {
      const double a = (from + turn * k) * two_pi / 360;
      return centre + part * radius * dvec2{gradus::cos(a), gradus::sin(a)};
    };
    places_[vertex] = centre;
    for (std::size_t k = 0; k < star_.edges.size(); ++k)
      places_[links.across(star_.edges[k], vertex)] = on_circle(static_cast<double>(k), 1);
    for (std::size_t k = 0; k < star_.faces.size(); ++k) {
      const auto ring = links.ring(star_.faces[k]);
      const auto at = static_cast<std::size_t>(std::ranges::find(ring, vertex) - ring.begin());
      rings_.emplace_back();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::int32_t v = ring[(at + i) % ring.size()];
        const double part = (static_cast<double>(i) - 1) / (static_cast<double>(ring.size()) - 2);
        places_.emplace(v, on_circle(static_cast<double>(k) + part, 1.22));
        rings_.back().push_back(places_[v]);
      }
    }
  }

  /// By the numbers of the vertices.
  const std::map<std::int32_t, dvec2>& places() const { return places_; }
  const std::vector<dvec2>& ring(std::size_t face) const { return rings_[face]; }
  const Star& star() const { return star_; }
  /// Where the weight of a vertex is written.
  dvec2 beside(std::int32_t v) const {
    const dvec2 way = places_.at(v) - centre_;
    const double length = length_of(way);
    return places_.at(v) + way / length * (0.85 + 0.75 * std::abs(way.x) / length);
  }
  void add_to(View& view) const {
    for (std::size_t k = 0; k < rings_.size(); ++k) {
      view.add({fmt::format("r {:02} inside", k), Role::past, Area{{rings_[k]}, 1}});
      view.add({fmt::format("r {:02}", k), Role::past, Path{rings_[k], true}});
    }
  }

 private:
  dvec2 centre_;
  Star star_;
  std::map<std::int32_t, dvec2> places_{};
  std::vector<std::vector<dvec2>> rings_{};
};

}  // namespace gradus::subdivision_surface
