#pragma once
// What a run is about: a control mesh, one of its vertices, and from where it is looked at.

#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "modeling/subdivision_surface/subdivision_surface.hpp"
#include "stories/given_model.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::subdivision_surface {

using Control = Surface<double>;

/// More faces than a figure of levels can show in a short time.
inline constexpr std::size_t most_control_faces = 4000;

/// With three digits behind the point, as drawings have room for.
inline std::string short_real(double value) {
  return figure_real(std::abs(value) < 0.0005 ? 0 : std::round(value * 1000) / 1000);
}
/// Weights that stand beside each other: 0.65 and 0.06 where two digits are all of each, else fractions,
/// 5/12 and 1/6.
class WeightTexts {
 public:
  explicit WeightTexts(std::span<const double> all)
      : fractions_(!std::ranges::all_of(all, [](double w) { return is_whole(100 * w); })) {}

  std::string operator()(double weight) const {
    constexpr int most_parts = 400;  // a neighbour among pentagons has 180ths
    for (int below = 1; fractions_ && below <= most_parts; ++below) {
      if (!is_whole(below * weight)) continue;
      const std::string above = figure_real(std::round(below * weight));
      return below == 1 ? above : fmt::format("{}/{}", above, below);
    }
    return short_real(weight);
  }

 private:
  static bool is_whole(double x) { return std::abs(x - std::round(x)) < 1e-9; }

  bool fractions_;
};
inline std::string short_place(dvec3 p) { return figure_place(p, short_real); }

/// Cubes side by side: the squares between inside and outside. Corners are numbered along x, then y, then z.
inline Control of_cubes(const std::vector<glm::ivec3>& cubes) {
  const auto sides = faces_of_box();
  constexpr std::array<glm::ivec3, 6> ways{
      {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}};
  std::map<std::tuple<int, int, int>, std::int32_t> numbers;
  std::vector<std::vector<std::tuple<int, int, int>>> rings;
  for (const glm::ivec3 cube : cubes) {
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (std::ranges::find(cubes, cube + ways[k]) != cubes.end()) continue;
      rings.emplace_back();
      for (const std::size_t i : sides[k]) {
        const glm::ivec3 p = cube + glm::ivec3(i & 1u, i >> 1u & 1u, i >> 2u);
        rings.back().emplace_back(p.z, p.y, p.x);
        numbers[rings.back().back()] = 0;
      }
    }
  }
  Control made;
  for (auto& [p, number] : numbers) {
    number = static_cast<std::int32_t>(made.points.size());
    made.points.emplace_back(std::get<2>(p), std::get<1>(p), std::get<0>(p));
  }
  for (const auto& ring : rings) made.faces.add(mapped(ring, [&](const auto& p) { return numbers[p]; }));
  return made;
}

/// A prism of five sides with a tip: a pentagon, quadrilaterals and triangles.
inline Control pencil() {
  Control made;
  for (const double z : {0.0, 2.0}) {
    for (const dvec2 p : {dvec2{0, 2}, dvec2{-2, 0.5}, dvec2{-1, -2}, dvec2{1, -2}, dvec2{2, 0.5}})
      made.points.emplace_back(p, z);
  }
  made.points.emplace_back(0, 0, 4);
  const std::array<std::int32_t, 5> base{4, 3, 2, 1, 0};
  made.faces.add(base);
  for (std::int32_t i = 0; i < 5; ++i) {
    const std::int32_t k = (i + 1) % 5;
    made.faces.add(std::array{i, k, 5 + k, 5 + i});
    made.faces.add(std::array{5 + i, 5 + k, 10});
  }
  return made;
}

/// The surface of a file's faces, without the vertices that none of them has.
inline Control of_model(const Mesh& mesh) {
  Control made;
  std::vector<std::int32_t> numbers(mesh.positions.size(), -1);
  for (const MeshFace& face : mesh.faces) {
    for (const Corner& corner : corners_of(mesh, face))
      numbers[static_cast<std::size_t>(corner.position)] = 0;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0) continue;
    numbers[i] = static_cast<std::int32_t>(made.points.size());
    made.points.push_back(mesh.positions[i]);
  }
  for (const MeshFace& face : mesh.faces) {
    std::vector<std::int32_t> ring;
    for (const Corner& corner : corners_of(mesh, face))
      ring.push_back(numbers[static_cast<std::size_t>(corner.position)]);
    made.faces.add(ring);
  }
  return made;
}

/// Every face as triangles round its first corner.
inline Control in_triangles(Control mesh) {
  Faces triangles;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto ring = mesh.faces[f];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      triangles.add(std::array{ring[0], ring[i], ring[i + 1]});
  }
  mesh.faces = std::move(triangles);
  return mesh;
}

inline Control control_of(const Arguments& arguments) {
  if (names_a_model(arguments)) return of_model(given_model(arguments, ""));
  const std::string shape = arguments.text("shape");
  if (shape == "cube" || shape == "box") {
    Control cube = of_cubes({{0, 0, 0}});
    for (dvec3& p : cube.points) p = 2.0 * p - 1.0;
    if (shape == "cube") return cube;
    Faces open;  // on top, where y is 1
    for (std::size_t f = 0; f < cube.faces.size(); ++f) {
      if (f != 3) open.add(cube.faces[f]);
    }
    cube.faces = std::move(open);
    return cube;
  }
  if (shape == "pencil") return pencil();
  if (shape == "spot" || shape == "fish" || shape == "penguin") {
    Control animal = of_model(given_model(arguments, shape + ".obj"));
    // Face to face with the reader
    if (shape == "spot") {
      for (dvec3& p : animal.points) p *= dvec3{-1, 1, -1};
    }
    return animal;
  }
  return of_cubes({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {2, 0, 0}, {0, 2, 1}});
}

struct Subject {
  Control mesh;
  std::int32_t vertex;
  int levels;
  faces_subject::Reader reader;
  dvec3 place{};  ///< of the vertex before it was moved

  /// Where the vertex is in a level.
  dvec3 of(const Control& level) const { return level.points[static_cast<std::size_t>(vertex)]; }
};

/// The faces that have the vertex as a corner, ascending.
inline std::vector<std::int32_t> faces_at(const Control& mesh, std::int32_t vertex) {
  std::vector<std::int32_t> all;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (std::ranges::count(mesh.faces[f], vertex) > 0) all.push_back(static_cast<std::int32_t>(f));
  }
  return all;
}

/// What is said of the run, with the author of a shape that asks for it.
inline void add_credit(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  std::string& subtitle = narrator.trace().subtitle;
  if (!names_a_model(given) && given.text("shape") == "penguin")
    subtitle = narrator.words().say("credit", {{"subtitle", subtitle}});
}

/// A vertex with five edges, whose weights are round numbers, or about as many; of equals the one nearest to
/// the reader.
inline std::int32_t vertex_to_tell(const Control& mesh, const Links& links, dvec3 towards) {
  std::int32_t best = 0;
  const auto rank = [&](std::int32_t v) {
    const double off = std::abs(links.star(v).valence() - 5);
    return std::pair(-off, glm::dot(mesh.points[static_cast<std::size_t>(v)], towards));
  };
  for (std::int32_t v = 1; v < std::ssize(mesh.points); ++v) {
    if (rank(v) > rank(best)) best = v;
  }
  return best;
}

inline void add_creases(Control& mesh, const Arguments& arguments) {
  const Links links(mesh);
  for (const Tuple& crease : arguments.tuples("creases")) {
    const double a = crease[0].value - 1, b = crease[1].value - 1, sharpness = crease[2].value;
    const auto is_it = [&](const Edge& e) { return (e.a == a && e.b == b) || (e.a == b && e.b == a); };
    const auto edge = std::ranges::find_if(links.edges(), is_it);
    if (edge == links.edges().end())
      refuse("creases", "expected two vertices with an edge between them, found {} and {}", a + 1, b + 1);
    if (!(sharpness >= 0)) refuse("creases", "expected a sharpness of at least 0, found {}", sharpness);
    mesh.creases.push_back({edge->a, edge->b, sharpness < 10 ? sharpness : for_ever});
  }
}

inline Subject subject_of(const Arguments& arguments, bool triangles) {
  Subject subject{control_of(arguments), 0, static_cast<int>(arguments.integer("levels")),
                  faces_subject::reader_of(arguments)};
  Control& mesh = subject.mesh;
  if (mesh.faces.size() > most_control_faces)
    refuse(arguments, {"model"},
           fmt::format("expected a control mesh of up to {} faces, found {}", most_control_faces,
                       mesh.faces.size()));
  if (triangles) mesh = in_triangles(mesh);
  if (!keeps_contracts([&] { const Links whole(mesh); }))
    refuse(arguments, {"model"},
           "expected a surface: at most two faces at an edge, in one sense, and one fan of them at a vertex");
  add_creases(mesh, arguments);
  const Links links(mesh);
  const auto count = static_cast<std::int64_t>(mesh.points.size());
  subject.vertex = vertex_to_tell(mesh, links, subject.reader.towards);
  if (arguments.has("vertex") && !arguments.text("vertex").empty()) {
    const std::int64_t v = arguments.integer("vertex");
    if (v > count) refuse("vertex", "expected a vertex up to {}, found {}", count, v);
    subject.vertex = static_cast<std::int32_t>(v - 1);
  }
  subject.place = subject.of(mesh);
  mesh.points[static_cast<std::size_t>(subject.vertex)] += *arguments.place("move");
  return subject;
}

}  // namespace gradus::subdivision_surface
