#pragma once
// What is shaded: faces seen from straight above, the normals at their vertices, a lamp, and the pixels.

#include <map>

#include "core/surface.hpp"
#include "figure/tone_of.hpp"
#include "shading/polygon_shading/polygon_shading.hpp"
#include "shading/polygon_shading/vertex_normals.hpp"
#include "stories/shading/illumination/subject.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::polygon_shading {

using Point = Surface<double>;
using Lit = Corner<double, double>;
using Smooth = Corner<double, Point>;

/// A grey surface under one lamp, by Phong's model.
struct Lamp {
  Material material;
  Light light;
  dvec3 eye;

  double operator()(dvec3 place, dvec3 normal) const {
    const std::span<const Light> lights(&light, 1);
    return illumination::phong(place, normal, eye, material, lights, LinearRgb{1}).sum().x;
  }
};

struct Subject {
  std::vector<NamedFace> named;
  std::vector<dvec3> places{}, normals{};  ///< by vertex: what has one place is one vertex
  std::vector<std::vector<int>> rings{};   ///< vertices by face
  ivec2 size{};
  dvec2 lower{};     ///< of the picture, in the faces' x and y
  double pixel = 1;  ///< its side, there
  Lamp lamp{};
  std::vector<double> given{};  ///< intensities of corners, in turn, in place of light

  Window picture() const { return {{0, 0}, size - 1}; }
  dvec2 on_screen(dvec3 place) const { return (dvec2(place) - lower) / pixel; }
  std::size_t vertex(std::size_t face, std::size_t corner) const {
    return static_cast<std::size_t>(rings[face][corner]);
  }
  std::vector<Smooth> smooth(std::size_t face) const {
    std::vector<Smooth> corners;
    for (const int v : rings[face]) {
      const auto at = static_cast<std::size_t>(v);
      corners.push_back({on_screen(places[at]), {places[at], normals[at]}});
    }
    return corners;
  }
  /// With the colours of all vertices, or those that are given for corners.
  std::vector<Lit> lit(std::size_t face, const std::vector<double>& colours) const {
    std::size_t before = 0;
    for (std::size_t f = 0; f < face; ++f) before += rings[f].size();
    std::vector<Lit> corners;
    for (std::size_t k = 0; k < rings[face].size(); ++k) {
      const std::size_t v = vertex(face, k);
      corners.push_back(
          {on_screen(places[v]), given.empty() ? colours[v] : given[(before + k) % given.size()]});
    }
    return corners;
  }
  std::vector<double> vertex_colours() const {
    std::vector<Point> vertices;
    for (std::size_t v = 0; v < places.size(); ++v) vertices.push_back({places[v], normals[v]});
    std::vector<double> colours(vertices.size());
    light_vertices(std::span<const Point>(vertices), lamp, std::span(colours));
    return colours;
  }
  /// Seen from above, the corners run clockwise, or in a line: the face looks away.
  bool looks_away(std::size_t face) const { return area_vector(named[face].points).z <= 0; }
};

inline Weighting weighting_of(const Arguments& arguments) {
  const std::string& name = arguments.text("weighting");
  if (name == "plain") return Weighting::plain;
  return name == "area" ? Weighting::area : Weighting::angle;
}

/// Vertices, faces and normals alone.
inline Subject mesh_of(const Arguments& arguments) {
  Subject subject{.named = faces_subject::faces_of(arguments)};
  std::map<std::array<double, 3>, int> numbers;
  for (const NamedFace& face : subject.named) {
    subject.rings.emplace_back();
    for (const dvec3 p : face.points) {
      const auto [at, is_new] = numbers.try_emplace({p.x, p.y, p.z}, static_cast<int>(numbers.size()));
      if (is_new) subject.places.push_back(p);
      subject.rings.back().push_back(at->second);
    }
  }
  subject.normals.resize(subject.places.size());
  vertex_normals(std::span<const dvec3>(subject.places), subject.rings, weighting_of(arguments),
                 std::span(subject.normals));
  return subject;
}

inline Lamp lamp_of(const Arguments& arguments) {
  Lamp lamp;
  const auto share = [&](std::string_view name) {
    return static_cast<float>(illumination::share(arguments, name));
  };
  const auto grey = [&](std::string_view name) { return LinearRgb{share(name)}; };
  lamp.material.ambient = grey("ka");
  lamp.material.diffuse = grey("kd");
  lamp.material.specular = grey("ks");
  lamp.material.shininess = share("shininess");
  lamp.light.position = *arguments.place("light");
  lamp.eye = *arguments.place("eye");
  return lamp;
}

/// All there is to shade, in a picture of this size, with a margin where no window is given; in pixels.
inline Subject subject_of(const Arguments& arguments, ivec2 size, int margin) {
  Subject subject = mesh_of(arguments);
  subject.size = size;
  subject.lamp = lamp_of(arguments);
  for (const Tuple& tuple : arguments.tuples("intensities")) subject.given.push_back(tuple[0].value);
  Extent extent;
  for (std::size_t f = 0; f < subject.named.size(); ++f) {
    if (subject.looks_away(f)) continue;
    if (convex_parts(subject.named[f].points).size() > 1)
      refuse("faces", "expected faces without dents, found '{}' with one", subject.named[f].name);
    for (const dvec3 p : subject.named[f].points) extent.add(dvec2(p));
  }
  if (extent.lower.x > extent.upper.x)
    refuse(arguments, {"faces"}, "expected a face that looks to +z, from where the picture is seen");
  const std::vector<double> window = arguments.numbers("window");
  if (!window.empty()) extent = {{window[0], window[1]}, {window[2], window[3]}};
  const dvec2 sides = extent.size() / dvec2(window.empty() ? subject.size - 2 * margin : subject.size);
  subject.pixel = std::max(sides.x, sides.y);
  if (!(subject.pixel > 0)) refuse(arguments, {"window"}, "expected a window with an inside");
  subject.lower = extent.centre() - 0.5 * subject.pixel * dvec2(subject.size);
  for (const dvec3 p : subject.places) {
    const dvec2 at = subject.on_screen(p);
    if (!(std::abs(at.x) <= farthest && std::abs(at.y) <= farthest))
      refuse(arguments, {"window", "faces"}, fmt::format("expected all corners within {} pixels", farthest));
  }
  return subject;
}

inline Subject subject_of(const Arguments& arguments) {
  return subject_of(
      arguments,
      {static_cast<int>(arguments.integer("columns")), static_cast<int>(arguments.integer("rows"))}, 1);
}

/// A shaded picture: the intensities of its pixels.
using Picture = std::map<std::pair<int, int>, double>;

/// Shades all faces that look here, in their order, by `shade(face, plot)`.
template <class Shade>
Picture picture_of(const Subject& subject, const Shade& shade) {
  Picture picture;
  for (std::size_t f = 0; f < subject.rings.size(); ++f) {
    if (subject.looks_away(f)) continue;
    shade(f, [&](ivec2 p, double colour) { picture[{p.x, p.y}] = colour; });
  }
  return picture;
}

/// Light at every pixel: what the others are measured by.
inline Picture phong_picture(const Subject& subject) {
  return picture_of(subject, [&](std::size_t f, const auto& plot) {
    const std::vector<Smooth> corners = subject.smooth(f);
    phong(std::span<const Smooth>(corners), subject.picture(), subject.lamp, plot);
  });
}

/// The largest difference between two pictures, and where.
struct Worst {
  double difference = 0;
  ivec2 pixel{};
};
inline Worst worst_of(const Picture& shown, const Picture& right) {
  Worst worst;
  for (const auto& [at, colour] : right) {
    const auto there = shown.find(at);
    const double difference = there == shown.end() ? 0 : std::abs(there->second - colour);
    if (difference > worst.difference) worst = {difference, {at.first, at.second}};
  }
  return worst;
}

}  // namespace gradus::polygon_shading
