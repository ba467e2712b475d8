#pragma once
// Stage 7, hidden surface removal and shading: the z-buffer keeps the nearest fragment of each pixel, Phong's
// model gives it its colour.

#include <compare>
#include <optional>
#include <vector>

#include "core/observe.hpp"
#include "core/raster.hpp"
#include "scene/scene.hpp"
#include "shading/illumination/illumination.hpp"
#include "stages/points.hpp"
#include "visibility/z_buffer/z_buffer.hpp"

namespace gradus::pipeline {

/// The z-buffer compared a fragment with what its pixel held.
struct DepthTested {
  Fragment fragment;
  std::optional<Fragment> before;  ///< what the pixel held
  bool nearer;                     ///< whether the newcomer takes its place
};

/// A visible fragment has its colour.
struct Shaded {
  Fragment fragment;
  WorldPoint place;
  dvec3 normal;  ///< of length 1, on the viewer's side
  dvec2 texture;
  int material;  ///< of the object's mesh
  dvec3 ambient, diffuse, specular;
  LinearRgb colour;  ///< their sum
};

/// A fragment as the z-buffer keeps it. At equal depth the lowest (object, face, piece) is kept.
struct Candidate {
  Fragment fragment;

  friend constexpr bool operator<(const Candidate& a, const Candidate& b) {
    return a.fragment.id < b.fragment.id;
  }
};

/// Per pixel the fragment that is nearest so far.
using PixelCell = z_buffer::Cell<double, Candidate>;
using Visible = Raster<PixelCell>;

/// The fragment that a pixel holds; nothing when it is free.
inline std::optional<Fragment> held(const PixelCell& cell) {
  return cell.taken ? std::optional(cell.key.fragment) : std::nullopt;
}

/// Tests a fragment against its pixel, and keeps it when it is the nearest so far.
/// Steps: DepthTested. Accuracy: exact, whatever the order. Cost: a comparison.
template <Observer<DepthTested> O = Unobserved>
void keep_nearest(const Fragment& f, Visible& cells, O&& observer = {}) {
  using z_buffer::keep_nearest;
  const ivec2 p = f.pixel;
  const double z = f.depth;
  const auto before = cells[p];
  const bool nearer =  // ties: by number
      keep_nearest(cells, p, z, {f});
  if constexpr (observed<O>) observer(DepthTested{f, held(before), nearer});
}

/// The mean of what the three corners have, with the fragment's weights.
template <class Value, class Member>
Value mean(const Fragment& fragment, const Triangle& triangle, Member member) {
  const auto& [a, b, c] = triangle.corners;
  return fragment.weights.x * member(a) + fragment.weights.y * member(b) + fragment.weights.z * member(c);
}

/// The place, the normal and the light of one visible fragment.
inline Shaded shaded(const Scene& scene, const Fragment& fragment, const Triangle& triangle) {
  const auto at = [](const TriangleCorner& c) { return c.world.at; };
  const dvec3 place = mean<dvec3>(fragment, triangle, at);
  dvec3 normal =
      unit_vector(mean<dvec3>(fragment, triangle, [](const TriangleCorner& c) { return c.normal; }));
  const dvec2 texture = mean<dvec2>(fragment, triangle, [](const TriangleCorner& c) { return c.texture; });
  const Mesh& mesh = object_at(scene, fragment.id.object).mesh;
  const int material = mesh.faces[static_cast<std::size_t>(fragment.id.face)].material;
  const auto parts = illumination::phong(place, normal, scene.camera.frame.eye,
                                         mesh.materials[static_cast<std::size_t>(material)],
                                         std::span<const Light>(scene.lights), scene.ambient);
  return {fragment,      {place},        normal,
          texture,       material,       parts.ambient,
          parts.diffuse, parts.specular, LinearRgb(parts.sum())};
}

/// Gives every visible fragment its colour, and every other pixel the background's.
///
/// Steps: Shaded*, row by row.
/// Accuracy: that of illumination::phong.
/// Cost: one illumination a visible pixel.
/// Errors: none.
template <Observer<Shaded> O = Unobserved>
Raster<LinearRgb> shade(const Scene& scene, const Triangles& triangles, const Visible& visible,
                        O&& observer = {}) {
  const int width = visible.width();
  const int height = visible.height();
  const auto back = scene.background;
  Raster<LinearRgb> light(  // nothing seen yet
      width, height, back);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const ivec2 p{x, y};
      const auto& cell = visible[p];
      if (!cell.taken) continue;
      // Phong's model, once a pixel
      auto& f = cell.key.fragment;
      auto& t =  // the one seen there
          triangle_of(f, triangles);
      auto lit = shaded(scene, f, t);
      light[p] = lit.colour;
      if constexpr (observed<O>) observer(lit);
    }
  }
  return light;
}

}  // namespace gradus::pipeline
