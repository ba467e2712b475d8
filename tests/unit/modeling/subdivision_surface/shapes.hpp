#pragma once
// Small meshes that the tests of subdivision surfaces share.

#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "core/geometry.hpp"
#include "modeling/subdivision_surface/subdivision_surface.hpp"

namespace gradus::subdivision_surface {

/// [-1, 1]^3, vertex i at the bits of i.
inline Surface<double> cube() {
  Surface<double> made;
  for (unsigned i = 0; i < 8; ++i)
    made.points.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
  made.faces = faces_of({{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  return made;
}
/// Without its top.
inline Surface<double> open_cube() {
  Surface<double> made = cube();
  made.faces = faces_of({{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  return made;
}
inline Surface<double> tetrahedron() {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
          faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})};
}
/// A pentagon, five quadrilaterals and a tip of five triangles.
inline Surface<double> pencil() {
  Surface<double> made;
  for (const double z : {0.0, 2.0}) {
    for (const dvec2 p : {dvec2{0, 2}, dvec2{-2, 0.5}, dvec2{-1, -2}, dvec2{1, -2}, dvec2{2, 0.5}})
      made.points.emplace_back(p, z);
  }
  made.points.emplace_back(0, 0, 4);
  made.faces.add(std::array{4, 3, 2, 1, 0});
  for (std::int32_t i = 0; i < 5; ++i) {
    const std::int32_t k = (i + 1) % 5;
    made.faces.add(std::array{i, k, 5 + k, 5 + i});
    made.faces.add(std::array{5 + i, 5 + k, 10});
  }
  return made;
}
/// Two cubes in an angle: a vertex with five edges among others with three and four.
inline Surface<double> arch_of_quads() {
  return {{{0, 0, 0},
           {1, 0, 0},
           {2, 0, 0},
           {0, 1, 0},
           {1, 1, 0},
           {2, 1, 0},
           {0, 2, 0},
           {1, 2, 0},
           {0, 0, 1},
           {1, 0, 1},
           {2, 0, 1},
           {0, 1, 1},
           {1, 1, 1},
           {2, 1, 1},
           {0, 2, 1},
           {1, 2, 1}},
          faces_of({{0, 3, 4, 1},
                    {1, 4, 5, 2},
                    {3, 6, 7, 4},
                    {8, 9, 12, 11},
                    {9, 10, 13, 12},
                    {11, 12, 15, 14},
                    {0, 1, 9, 8},
                    {1, 2, 10, 9},
                    {2, 5, 13, 10},
                    {5, 4, 12, 13},
                    {4, 7, 15, 12},
                    {7, 6, 14, 15},
                    {6, 3, 11, 14},
                    {3, 0, 8, 11}})};
}

/// The same in another scalar.
template <class T>
Surface<T> in(const Surface<double>& mesh) {
  Surface<T> made{{}, mesh.faces, mesh.creases, mesh.corners};
  for (const dvec3 p : mesh.points) made.points.push_back({T(p.x), T(p.y), T(p.z)});
  return made;
}

}  // namespace gradus::subdivision_surface
