#pragma once
// An exhibit: the normal of a face as lecture notes compute it for flat shading, kept so that a figure can
// show how far it leans. Never use it to shade; polygon_shading.hpp has the right one.

#include "shading/polygon_shading/polygon_shading.hpp"

namespace gradus::polygon_shading {

/// The mean of the normals that the corners have; the place in the middle is right.
template <class T>
Surface<T> leaning_middle(std::span<const Corner<T, Surface<T>>> polygon) {
  glm::vec<3, T> sum{T(0)};
  for (const auto& corner : polygon) sum += corner.value.normal;
  return {middle_of(polygon).place, unit_vector(sum)};
}

/// FAULTY: takes the mean of the vertex normals for the normal of the face (errata E002-14). They lean to the
/// faces round about: at a corner of a cube by up to 54.7 degrees, their mean over half a face by 25.2.
///
/// polygon, picture, light, plot: as for flat.
///
/// Domain: as for flat.
/// Steps: as for flat.
/// Accuracy: right only where the vertex normals lean to all sides alike, as on a whole face of a cube.
/// Cost: as for flat.
/// Errors: as for flat.
template <
    class T, class Light, class Plot,
    class Colour = std::invoke_result_t<Light&, glm::vec<3, T>, glm::vec<3, T>>,
    Observer<PolygonLit<T, Colour>, RowBegun<T, Colour>, Shaded<T, Colour, Colour>, Finished> O = Unobserved>
void flat_by_vertex_normals(std::span<const Corner<T, Surface<T>>> polygon, const Window& picture,
                            Light&& light, Plot&& plot, O&& observer = {}) {
  expect_polygon(polygon);
  // The corners lean to other faces
  auto middle = leaning_middle(polygon);
  const auto ip = lit(light, middle);
  if constexpr (observed<O>) observer(PolygonLit<T, Colour>{middle, ip});
  std::int64_t pixels = 0;
  auto all = rows(polygon, picture);
  for (const int j : all) {
    auto [l, r] = ends(polygon, j);
    if constexpr (observed<O>) observer(RowBegun<T, Colour>{j, l, r, ip, ip});
    auto row = columns(l, r, picture);
    for (const int i : row) {
      plot(ivec2{i, j}, ip);
      if constexpr (observed<O>) observer(plain({i, j}, between(l, r, i), ip));
      ++pixels;
    }
  }
  if constexpr (observed<O>) observer(Finished{pixels, 1});
}

}  // namespace gradus::polygon_shading
