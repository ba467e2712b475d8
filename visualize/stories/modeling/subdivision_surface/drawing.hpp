#pragma once
// Levels of a surface as pictures, and the star of a vertex with weights.

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "figure/aside.hpp"
#include "stories/modeling/subdivision_surface/subject.hpp"
#include "stories/rendered_surface.hpp"

namespace gradus::subdivision_surface {

/// Surfaces of up to so many faces have lines between them.
inline constexpr std::size_t most_faceted = 900;

inline constexpr int paper_width = 36, paper_height = 27;
/// Three pictures above,
inline constexpr std::array<Extent, 3> places{
    {{{2.7, 13.6}, {13.3, 27}}, {{14.2, 13.6}, {24.8, 27}}, {{25.2, 13.6}, {35.8, 27}}}};
/// or two large ones.
inline constexpr std::array<Extent, 2> large_places{{{{0.2, 0}, {17.2, 27}}, {{18.8, 0}, {35.8, 27}}}};
/// Below the first picture a star,
inline constexpr dvec2 star_centre{8, 5.9};
inline constexpr double star_radius = 5.2;
/// and on the right lines of text, from 0 on; in smaller cells they would lie on each other.
inline constexpr double least_cell_of_lines = 13.5;
inline void add_line(View& view, int line, Role role, std::string text) {
  view.add({fmt::format("y {:02}", line), role,
            Text{{18, 11.6 - 1.75 * line}, std::move(text), Align::left, true}});
}

/// A picture of a surface with its heading.
struct LevelPicture {
  std::string id{};
  Extent place{};
  std::string heading{};
  bool aside = false;                      ///< no drawing among many shows it
  bool close = false;                      ///< as large as there is room for the first level
  std::span<const std::int32_t> marked{};  ///< faces that stand out

  std::string name() const { return aside ? std::string(aside_prefix) + id : id; }
};

/// Pictures of surfaces; those in places of one size are in one scale.
class LevelPictures {
 public:
  /// first: the first level, where pictures of levels alone are close to it. right: what is shown beside it.
  LevelPictures(const Words& words, const Subject& subject, const Control& first = {},
                const Control& right = {})
      : words_(words), subject_(subject), extents_{extent_of(subject.mesh), extent_of(first, right)} {}

  /// Where a place of the surface is shown.
  dvec2 at(const LevelPicture& picture, dvec3 p) const { return panel(picture).at(subject_.reader.flat(p)); }

  void add(View& view, const LevelPicture& picture, const Control& mesh) const {
    add_headings(view, picture,
                 words_.say("counts", {{"vertices", mesh.points.size()}, {"faces", mesh.faces.size()}}));
    const Panel shown = panel(picture);
    const Extent& extent = extent_in(picture);
    view.add({picture.name() + " a", Role::past,
              Picture{shown.at(extent.lower), shown.at(extent.upper), rendered(mesh, picture)}});
  }
  /// Of a surface that is not there yet.
  void add_heading(View& view, const LevelPicture& picture) const { add_headings(view, picture, ""); }
  void add_vertex(View& view, const LevelPicture& picture, dvec3 p) const {
    view.add({picture.name() + " v", Role::current, Dot{at(picture, p)}});
  }
  /// The face of another mesh that is missing here.
  void add_outline(View& view, const LevelPicture& picture, const Control& mesh, std::size_t f) const {
    std::vector<dvec2> ring;
    for (const auto v : mesh.faces[f]) ring.push_back(at(picture, mesh.points[static_cast<std::size_t>(v)]));
    view.add({fmt::format("{} missing {}", picture.name(), f), Role::rejected, Path{std::move(ring), true}});
  }

 private:
  void add_headings(View& view, const LevelPicture& picture, std::string counts) const {
    const double middle = picture.place.centre().x, top = picture.place.upper.y;
    if (picture.close && !counts.empty()) {  // so that the picture is as large as can be
      view.add({picture.name() + " h", Role::boundary,
                Text{{middle, top - 0.6},
                     fmt::format("{}: {}", picture.heading, counts),
                     Align::centre,
                     picture.aside}});
      return;
    }
    view.add({picture.name() + " h", Role::boundary,
              Text{{middle, top - 0.6}, picture.heading, Align::centre, picture.aside}});
    if (counts.empty()) return;
    view.add({picture.name() + " n", Role::past,
              Text{{middle, top - 2.1}, std::move(counts), Align::centre, picture.aside}});
  }
  /// Below the heading.
  Panel panel(const LevelPicture& picture) const {
    const dvec2 lines{0, picture.close ? 1.4 : 2.6};
    return Panel({picture.place.lower, picture.place.upper - lines}, extent_in(picture));
  }
  Extent extent_of(const Control& mesh, const Control& other = {}) const {
    Extent extent;
    for (const dvec3 p : mesh.points) extent.add(subject_.reader.flat(p));
    for (const dvec3 p : other.points) extent.add(subject_.reader.flat(p));
    return widened(extent, 0.02);
  }
  const Extent& extent_in(const LevelPicture& picture) const { return extents_[picture.close ? 1 : 0]; }
  std::shared_ptr<const Image> rendered(const Control& mesh, const LevelPicture& picture) const {
    auto& image = rendered_[{&mesh, picture.close, !picture.marked.empty()}];
    if (image) return image;
    constexpr double longer_side = 480;  // in pixels
    const Extent& extent = extent_in(picture);
    const dvec2 size = extent.size();
    image = rendered_surface(
        mesh.points, mesh.faces,
        {.right = subject_.reader.right,
         .up = subject_.reader.up,
         .towards = subject_.reader.towards,
         .shown = extent,
         .width = std::max(1, static_cast<int>(longer_side * std::min(1.0, size.x / size.y))),
         .faceted = mesh.faces.size() <= most_faceted,
         .marked = picture.marked});
    return image;
  }

  const Words& words_;
  const Subject& subject_;
  std::array<Extent, 2> extents_;
  /// By the mesh, and whether it is close, and some of its faces stand out.
  mutable std::map<std::tuple<const Control*, bool, bool>, std::shared_ptr<const Image>> rendered_{};
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
