// The promises of subdivision surfaces: every point is the exact one but for roundings, affine maps of the
// control mesh are those of its levels, and levels never leave the limit.

#include "modeling/subdivision_surface/subdivision_surface.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/contract.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace subdivision_surface;

/// A pentagon, two quadrilaterals and a triangle with a border; a tetrahedron.
const Faces& open_faces() {
  static const Faces faces = faces_of({{0, 1, 2, 3, 4}, {1, 0, 5, 6}, {2, 1, 6, 7}, {2, 7, 3}});
  return faces;
}
const Faces& closed_faces() {
  static const Faces faces = faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  return faces;
}
constexpr std::size_t vertices = 8, sharpness_at = 3 * vertices;

/// Eight points, the sharpness of an edge, and of a vertex.
Input generate(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, sharpness_at + 2);
  for (std::size_t k = 0; k < 2; ++k)
    input[sharpness_at + k] = static_cast<double>(random.uniform_int(0, 8)) / 4;
  return input;
}

template <class T>
Surface<T> mesh_in(const Input& i, const Faces& faces, std::size_t count) {
  Surface<T> mesh{{}, faces, {{1, 2, i[sharpness_at]}}, {{3, i[sharpness_at + 1]}}};
  for (std::size_t v = 0; v < count; ++v)
    mesh.points.push_back({T(i[3 * v]), T(i[3 * v + 1]), T(i[3 * v + 2])});
  return mesh;
}

/// How far points are from the exact ones, in parts of so many u M and of the smallest numbers.
double off(const Points<double>& found, const Points<Exact>& exact, const Input& i, double parts) {
  double size = 0, most = 0;
  for (std::size_t k = 0; k < sharpness_at; ++k) size = std::max(size, std::abs(i[k]));
  const Exact bound = Exact(parts) * (Exact(0x1p-53) * Exact(size) + Exact(0x1p-1074));
  for (std::size_t v = 0; v < found.size(); ++v) {
    for (int k = 0; k < 3; ++k)
      most = std::max(most, in_bounds(abs(Exact(found[v][k]) - exact[v][k]), bound));
  }
  return most;
}
bool taken(const Input& i) {
  const auto fits = [](double x) { return std::abs(x) <= largest; };
  return std::ranges::all_of(i, fits) && i[sharpness_at] >= 0 && i[sharpness_at + 1] >= 0;
}

/// A level is judged by the same weights without rounding: those are held to OpenSubdiv's by a unit test.
template <class Level>
double level_error(const Input& i, const Faces& faces, std::size_t count, double parts, const Level& level) {
  Surface<double> found;
  const bool kept = keeps_contracts([&] { found = level(mesh_in<double>(i, faces, count)); });
  if (!taken(i)) return 0;
  if (!kept) return wrong;
  const ExactScope scope;
  return off(found.points, level(mesh_in<Exact>(i, faces, count)).points, i, parts);
}
double catmull_clark_error(const Input& i) {
  return level_error(i, open_faces(), vertices, 5 + 12,
                     [](const auto& mesh) { return catmull_clark(mesh, 1); });
}
double loop_error(const Input& i) {
  return level_error(i, closed_faces(), 4, 3 + 16, [](const auto& mesh) { return loop(mesh, 1); });
}
/// Another one for each input.
std::int32_t vertex_of(const Input& i) {
  return static_cast<std::int32_t>(4 * std::min(i[sharpness_at], 1.75));
}
double limit_error(const Input& given) {
  Input i = given;
  if (!taken(i)) return 0;
  const std::int32_t v = vertex_of(i);
  for (std::size_t k = 0; k < 2; ++k) i[sharpness_at + k] = i[sharpness_at + k] > 1 ? for_ever : 0;
  const Points<double> found{limit(mesh_in<double>(i, open_faces(), vertices), v).point};
  const ExactScope scope;
  return off(found, {limit(mesh_in<Exact>(i, open_faces(), vertices), v).point}, i, 5 + 24);
}

// --- Exact relations

/// x + 2 y, 3 z - x and y as coordinates: a map of the points before, and of those after.
bool commutes_with_maps(const Input& i) {
  const auto mapped = [](Surface<Exact> mesh) {
    for (auto& p : mesh.points) p = {p.x + Exact(2) * p.y, Exact(3) * p.z - p.x, p.y};
    return mesh;
  };
  const Surface<Exact> mesh = mesh_in<Exact>(i, open_faces(), vertices);
  return catmull_clark(mapped(mesh), 2) == mapped(catmull_clark(mesh, 2));
}
/// A level moves vertices and leaves where they end.
bool levels_keep_the_limit(const Input& i) {
  Surface<Exact> mesh = mesh_in<Exact>(i, open_faces(), vertices);
  mesh.creases.clear();
  mesh.corners.clear();
  const Surface<Exact> next = catmull_clark(mesh, 1);
  return limit(mesh, vertex_of(i)).point == limit(next, vertex_of(i)).point;
}

}  // namespace

Domain subdivision_surface() {
  const auto scaled = at_every_scale(
      generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23});
  const std::size_t numbers = sharpness_at + 2;
  return {
      "subdivision_surface",
      {{.name = "catmull_clark",
        .states =
            "coordinates within 12 u M + m u M of the exact ones, M the largest, faces of up to m corners",
        .unit = "of the bound",
        .bound = 1,
        .numbers = numbers,
        .generate = scaled,
        .error = catmull_clark_error,
        .traps = {{"all one point", Input(numbers, 1)}, {"the largest numbers", Input(numbers, 0x1p1000)}}},
       {.name = "loop",
        .states = "coordinates within 16 u M + n u M of the exact ones, vertices of up to n edges",
        .unit = "of the bound",
        .bound = 1,
        .numbers = numbers,
        .generate = scaled,
        .error = loop_error,
        .traps = {{"the smallest numbers", Input(numbers, 5e-324)}}},
       {.name = "limit",
        .states = "limits within 24 u M + m u M of the exact ones",
        .unit = "of the bound",
        .bound = 1,
        .numbers = numbers,
        .generate = scaled,
        .error = limit_error,
        .traps = {{"all one point", Input(numbers, 1)}}},
       exact_relation("maps", "levels of a mapped mesh are the mapped levels, at creases as well", numbers,
                      [](const Input& i) { return !taken(i) || commutes_with_maps(i); }),
       exact_relation("limits", "a level moves vertices and leaves their limits", numbers,
                      [](const Input& i) { return !taken(i) || levels_keep_the_limit(i); })}};
}

}  // namespace gradus::stress
