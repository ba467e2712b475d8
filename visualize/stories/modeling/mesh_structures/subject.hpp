#pragma once
// The meshes that the stories of mesh structures are about: faces, and where each of their corners is drawn.
// What has no place in space without passing through itself is drawn cut open: there a vertex has several.

#include <glm/gtc/constants.hpp>
#include <set>

#include "modeling/mesh_structures/counts.hpp"
#include "modeling/mesh_structures/mesh_structures.hpp"
#include "stories/given_model.hpp"
#include "stories/hidden_lines.hpp"
#include "stories/parameters.hpp"
#include "stories/rings.hpp"
#include "stories/telling.hpp"

namespace gradus::mesh_structures {

struct Subject {
  Faces faces{};
  std::vector<dvec3> at{};  ///< of each corner of the faces
  std::size_t vertices = 0;
  dvec3 towards{0, 0, 1};
  bool closed = false;                           ///< its faces hide each other: drawn from both sides
  bool cut_open = false;                         ///< vertices have several places
  std::vector<std::pair<Index, dvec3>> loose{};  ///< vertices in no face

  Ring ring(Index f) const {
    const auto i = static_cast<std::size_t>(f);
    return {at.begin() + faces.first[i], at.begin() + faces.first[i + 1]};
  }
};

/// More faces are no figure.
inline constexpr std::size_t most_faces = 300;

inline std::string vertex_name(Index v) { return fmt::format("v{}", v + 1); }
inline std::string face_name(Index f) { return f == none ? "–" : fmt::format("f{}", f + 1); }
inline std::string names_of(std::span<const Index> things, std::string (*name)(Index)) {
  std::string text;
  for (const Index i : things) text += (text.empty() ? "" : ", ") + name(i);
  return text;
}

// --- Meshes that come with the topic

/// Each vertex at one place.
inline Subject in_space(Faces faces, const std::vector<dvec3>& places, dvec3 towards, bool closed) {
  Subject subject{.faces = std::move(faces), .vertices = places.size(), .towards = towards, .closed = closed};
  for (const Index v : subject.faces.corners) subject.at.push_back(places[static_cast<std::size_t>(v)]);
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (!has(subject.faces.corners, static_cast<Index>(v))) subject.loose.emplace_back(v, places[v]);
  }
  return subject;
}

inline Faces faces_of_cube() {
  return faces_of({{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}
inline std::vector<dvec3> corners_of_cube() {
  std::vector<dvec3> places;
  for (int i = 0; i < 8; ++i) places.push_back({i & 1, (i >> 1) & 1, (i >> 2) & 1});
  return places;
}

/// One face of a cube is cut round a smaller one in its middle; the others stay as they are.
inline Subject refined_cube() {
  Faces faces;
  for (const std::size_t f : {0u, 1u, 2u, 4u, 5u}) faces.add(faces_of_cube()[f]);
  const std::vector<Index> top{2, 6, 7, 3};
  std::vector<dvec3> places = corners_of_cube();
  for (std::size_t k = 0; k < 4; ++k) {
    places.push_back(0.6 * places[static_cast<std::size_t>(top[k])] + dvec3{0.2, 0.4, 0.2});
    const auto inner = static_cast<Index>(8 + k), next = static_cast<Index>(8 + (k + 1) % 4);
    faces.add(std::vector<Index>{top[k], top[(k + 1) % 4], next, inner});
  }
  faces.add(std::vector<Index>{8, 9, 10, 11});
  return in_space(faces, places, {0.45, 0.75, 1}, true);
}

/// An icosahedron, each face of which is cut into four so many times, with all vertices on the sphere.
inline Subject sphere(int levels) {
  const double g = glm::golden_ratio<double>();
  std::vector<dvec3> places{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                            {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  Faces faces = faces_of({{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                          {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                          {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
  for (dvec3& p : places) p = unit_vector(p);
  for (; levels > 0; --levels) {
    const Edges edges(faces);
    const auto old = static_cast<Index>(places.size());
    for (Index e = 0; e < edges.size(); ++e)
      places.push_back(unit_vector(places[static_cast<std::size_t>(edges[e][0].from)] +
                                   places[static_cast<std::size_t>(edges[e][0].to)]));
    Faces finer;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto ring = faces[f];
      const auto middle = [&](Index k) { return old + edges.at(faces.first[f] + k); };
      for (Index k = 0; k < 3; ++k)
        finer.add(std::vector<Index>{ring[static_cast<std::size_t>(k)], middle(k), middle((k + 2) % 3)});
      finer.add(std::vector<Index>{middle(0), middle(1), middle(2)});
    }
    faces = finer;
  }
  return in_space(faces, places, {0.25, 0.35, 1}, true);
}

/// Five triangles in a row, cut open at one edge.
inline Subject moebius_strip() {
  Subject subject{.vertices = 5, .cut_open = true};
  for (Index i = 0; i < 5; ++i) {
    subject.faces.add(std::vector<Index>{i, (i + 1) % 5, (i + 2) % 5});
    for (Index k = i; k < i + 3; ++k) subject.at.push_back({1.1 * k, k % 2 == 0 ? 0 : 2.2, 0});
  }
  return subject;
}

/// A square of 4 x 4 cells, left joined to right as they are and top to bottom turned round.
inline Subject klein_bottle() {
  Subject subject{.vertices = 16, .cut_open = true};
  const auto add = [&](std::initializer_list<ivec2> corners) {
    std::vector<Index> ring;
    for (const ivec2 p : corners) {
      const Index column = (p.y == 4 ? 4 - p.x : p.x) % 4;
      ring.push_back(column + 4 * (p.y % 4));
      subject.at.push_back({p, 0});
    }
    subject.faces.add(ring);
  };
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      add({{x, y}, {x + 1, y}, {x + 1, y + 1}});
      add({{x, y}, {x + 1, y + 1}, {x, y + 1}});
    }
  }
  return subject;
}

/// Two boxes side by side, their faces in one list: both faces between them are kept, one on the other.
inline Subject two_boxes() {
  Faces faces;
  std::vector<dvec3> places;
  for (Index i = 0; i < 12; ++i) places.push_back({i % 3, i / 3 % 2, i / 6});
  for (const Index box : {0, 1}) {
    const Faces cube = faces_of_cube();
    for (std::size_t f = 0; f < cube.size(); ++f) {
      std::vector<Index> ring;
      for (const Index v : cube[f]) ring.push_back(box + (v & 1) + 3 * (v >> 1 & 1) + 6 * (v >> 2));
      faces.add(ring);
    }
  }
  return in_space(faces, places, {0.4, 0.6, 1}, true);
}

inline Subject shape_of(std::string_view name) {
  if (name == "cube") return in_space(faces_of_cube(), corners_of_cube(), {0.5, 0.6, 1}, true);
  if (name == "refined_cube") return refined_cube();
  if (name == "sphere") return sphere(0);
  if (name == "fine_sphere") return sphere(1);
  if (name == "two_boxes") return two_boxes();
  if (name == "moebius") return moebius_strip();
  if (name == "klein") return klein_bottle();
  if (name == "open_box") {
    Faces faces;
    for (const std::size_t f : {0u, 1u, 2u, 4u, 5u}) faces.add(faces_of_cube()[f]);
    return in_space(faces, corners_of_cube(), {0.4, 2, 1}, false);
  }
  if (name == "bow_tie")
    return in_space(faces_of({{0, 1, 2}, {1, 3, 2}, {2, 5, 4}, {2, 6, 5}}),
                    {{0, 0, 0}, {2, 0.2, 0}, {2.6, 2, 0}, {4, 0.6, 0}, {1.2, 3.6, 0}, {3.2, 4, 0}, {5, 3, 0}},
                    {0, 0, 1}, false);
  // Three pages of a book
  return in_space(faces_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
                  {{0, 0, 0}, {0, 2, 0}, {-2, 1.2, -0.6}, {2, 1, -0.6}, {1.5, -0.5, 2}}, {0.15, 0.55, 1},
                  false);
}

// --- Meshes that are given

inline void check(const Faces& faces, const std::vector<dvec3>& places, const Arguments& arguments,
                  std::initializer_list<std::string_view> parameters) {
  const std::size_t vertices = places.size();
  if (faces.size() > most_faces)
    refuse(arguments, parameters, fmt::format("at most {} faces, found {}", most_faces, faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<Index> ring(faces[f].begin(), faces[f].end());
    for (const Index v : ring) {
      if (v < 0 || static_cast<std::size_t>(v) >= vertices)
        refuse(arguments, parameters,
               fmt::format("f{} names v{}, expected vertices from v1 to v{}", f + 1, v + 1, vertices));
    }
    if (std::set(ring.begin(), ring.end()).size() < ring.size())
      refuse(arguments, parameters, fmt::format("different corners expected, found one twice in f{}", f + 1));
    const Ring corners = mapped(ring, [&](Index v) { return places[static_cast<std::size_t>(v)]; });
    Bounds bounds;
    for (const dvec3 p : places) bounds.add(p);
    if (glm::length(area_vector(corners)) <= 1e-6 * bounds.radius() * bounds.radius())
      refuse(arguments, parameters, fmt::format("faces with an inside expected, found f{} without", f + 1));
  }
}

inline Subject given_triangles(const Arguments& arguments) {
  const std::vector<dvec3> places = arguments.places("vertices");
  Faces faces;
  for (const dvec3 t : arguments.places("triangles")) {
    if (t != glm::floor(t))
      refuse("triangles", "numbers of vertices expected, found {},{},{}", t.x, t.y, t.z);
    faces.add(
        std::vector{static_cast<Index>(t.x) - 1, static_cast<Index>(t.y) - 1, static_cast<Index>(t.z) - 1});
  }
  check(faces, places, arguments, {"triangles", "vertices"});
  const bool flat = std::ranges::all_of(places, [&](dvec3 p) { return p.z == places[0].z; });
  const bool closed = !flat && counts_of(faces, places.size()).boundary_edges == 0;
  return in_space(faces, places, flat ? dvec3{0, 0, 1} : dvec3{0.45, 0.6, 1}, closed);
}

inline Subject given_mesh(const Arguments& arguments) {
  const Mesh mesh = given_model(arguments, "");
  Faces faces;
  for (const MeshFace& face : mesh.faces) {
    std::vector<Index> ring;
    for (const Corner& corner : corners_of(mesh, face)) ring.push_back(static_cast<Index>(corner.position));
    faces.add(ring);
  }
  check(faces, mesh.positions, arguments, {"model"});
  if (faces.empty()) refuse("model", "a model with faces expected");
  const bool closed = counts_of(faces, mesh.positions.size()).boundary_edges == 0;
  return in_space(faces, mesh.positions, {0.45, 0.6, 1}, closed);
}

inline Subject subject_of(const Arguments& arguments) {
  if (names_a_model(arguments)) return given_mesh(arguments);
  return arguments.text("mesh") == "sample" ? given_triangles(arguments) : shape_of(arguments.text("mesh"));
}

}  // namespace gradus::mesh_structures
