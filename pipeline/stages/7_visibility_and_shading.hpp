#pragma once
// Stage 7, hidden surface removal and shading: the z-buffer keeps the nearest fragment of each pixel, Phong's
// model gives it its colour, computed once per face, once per corner or once per pixel.

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/observe.hpp"
#include "core/pixels.hpp"
#include "core/raster.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"
#include "shading/illumination/illumination.hpp"
#include "shading/polygon_shading/polygon_shading.hpp"
#include "stages/points.hpp"
#include "stages/textures.hpp"
#include "stages/wireframe.hpp"
#include "transformation/affine_3d/affine_3d.hpp"
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
  dvec3 normal;                      ///< of length 1, on the viewer's side
  dvec2 texture;                     ///< texture coordinates
  std::optional<LinearRgb> texel{};  ///< what the texture has there
  int material;                      ///< of the object's mesh
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

/// Of a picture of this size; every pixel is free.
inline Visible z_buffer_of(Size size) { return {size.width, size.height}; }

/// The fragment that a pixel holds; nothing when it is free.
inline std::optional<Fragment> held(const PixelCell& cell) {
  return cell.taken ? std::optional(cell.key.fragment) : std::nullopt;
}

/// What is told of a fragment's test against its pixel, which stays as it is.
inline DepthTested tested(const Fragment& f, const PixelCell& cell) {
  struct {
    PixelCell cell;
    PixelCell& operator[](ivec2) { return cell; }
  } copy{cell};
  return {f, held(cell), z_buffer::keep_nearest(copy, f.pixel, f.depth, {f})};
}

/// Tests a fragment against its pixel, and keeps it when it is the nearest so far.
/// Steps: DepthTested. Accuracy: exact, in any order. Cost: a comparison.
template <Observer<DepthTested> O = Unobserved>
void keep_nearest(const Fragment& f, Visible& cells, O&& observer = {}) {
  using z_buffer::keep_nearest;
  const ivec2 p = f.pixel;
  const double z = f.depth;
  if constexpr (observed<O>) observer(tested(f, cells[p]));
  // Of two as near the lower number
  keep_nearest(cells, p, z, {f});
}

/// The mean of what the three corners have, with the fragment's weights.
template <class Value, class Member>
Value mean(const Fragment& fragment, const Triangle& triangle, Member member) {
  const auto& [a, b, c] = triangle.corners;
  return fragment.weights.x * member(a) + fragment.weights.y * member(b) + fragment.weights.z * member(c);
}

using Surface = polygon_shading::Surface<double>;
using Parts = illumination::Parts<double>;

/// What shading has done, and what a plan has spared it.
struct ShadingCount {
  std::int64_t lamps = 0, lamps_out_of_range = 0;  ///< lamps it looked at, and left out
  std::int64_t lamps_without_highlight = 0;        ///< of those it looked at
  std::int64_t places = 0, places_without_texture = 0;

  void add(const ShadingCount& more) {
    lamps += more.lamps;
    lamps_out_of_range += more.lamps_out_of_range;
    lamps_without_highlight += more.lamps_without_highlight;
    places += more.places;
    places_without_texture += more.places_without_texture;
  }
};

/// The light of a scene, computed where its shading asks for it, and kept as long as it may be asked for
/// again. A plan spares it the lights that do not reach an object, and highlights that are none.
class SceneLight {
 public:
  SceneLight(const Scene& scene, Size picture, const Plan* plan = nullptr,
             const LinearTextures* decoded = nullptr)
      : scene_(scene), plan_(plan), textures_(scene.filter, picture, decoded) {}

  const Scene& scene() const { return scene_; }
  const ShadingCount& count() const { return count_; }

  Parts at(const Fragment& f, const Triangle& t, const Surface& here) {
    if (scene_.shading == Shading::wireframe) return {dvec3(ink_on(scene_.background)), {}, {}};
    if (scene_.shading == Shading::flat) return of_face(f, t);
    if (scene_.shading == Shading::gouraud) return of_corners(f, t);
    return at(f, here);
  }
  /// The colour that the surface's texture has at (u, v), if it has one.
  std::optional<LinearRgb> texel(const Fragment& f, const Triangle& t, dvec2 uv) {
    if (scene_.shading == Shading::wireframe) return std::nullopt;
    const auto texel = textures_.at(f, t, material(f), uv);
    ++count_.places;
    count_.places_without_texture += !texel;
    return texel;
  }
  const Material& material(const Fragment& f) const {
    return mesh(f).materials[static_cast<std::size_t>(face(f).material)];
  }
  /// The places whose light a fragment gets: its own, the middle of its face, or its triangle's corners.
  std::vector<Surface> surfaces_lit(const Fragment& f, const Triangle& t, const Surface& here) const {
    if (scene_.shading == Shading::wireframe) return {};
    if (scene_.shading == Shading::flat) return {middle_of_face(f, t)};
    if (scene_.shading == Shading::gouraud) return {corner_of(t, 0), corner_of(t, 1), corner_of(t, 2)};
    return {here};
  }
  const Mesh& mesh(const Fragment& f) const { return *object_at(scene_, f.id.object).mesh; }
  const MeshFace& face(const Fragment& f) const { return mesh(f).faces[static_cast<std::size_t>(f.id.face)]; }

  /// The lights that may reach an object.
  struct Lights {
    std::vector<Light> chosen;  ///< where some are left out
    std::span<const Light> reaching;
    std::int64_t lamps = 0, lamps_left_out = 0;
  };
  const Lights& lights_of(int object) {
    const auto [known, is_new] = lights_.try_emplace(plan_ ? object : 0);
    if (!is_new) return known->second;
    Lights& lights = known->second;
    lights.reaching = scene_.lights;
    if (plan_ && plan_->of(object).lights.size() < scene_.lights.size()) {
      for (int number : plan_->of(object).lights)
        lights.chosen.push_back(scene_.lights[static_cast<std::size_t>(number)]);
      lights.reaching = lights.chosen;
    }
    for (const Light& light : lights.reaching) lights.lamps += illumination::lamps(light);
    for (const Light& light : scene_.lights) lights.lamps_left_out += illumination::lamps(light);
    lights.lamps_left_out -= lights.lamps;
    return lights;
  }
  /// Whether the plan knows that a material has no highlight.
  bool is_matte(const Material& m) const { return plan_ && !plan_->highlights(m); }
  /// Counts the lamps that a place is lit by.
  void count_lamps(const Lights& lights, const Material& m) {
    count_.lamps += lights.lamps;
    count_.lamps_out_of_range += lights.lamps_left_out;
    count_.lamps_without_highlight += is_matte(m) ? lights.lamps : 0;
  }
  /// The light of a place, which is not counted.
  Parts lit(const Lights& lights, const Material& m, const Surface& at) const {
    if (is_matte(m)) return illumination::matte(at.place, at.normal, m, lights.reaching, scene_.ambient);
    return illumination::phong(at.place, at.normal, viewer_of(scene_.camera, at.place), m, lights.reaching,
                               scene_.ambient);
  }

 private:
  static Surface corner_of(const Triangle& t, std::size_t k) {
    return {t.corners[k].world.at, t.corners[k].normal};
  }

  Surface middle_of_face(const Fragment& f, const Triangle& t) const {
    std::vector<polygon_shading::Corner<double, Surface>> corners;
    const glm::dmat4& placement = object_at(scene_, f.id.object).placement;
    for (const Corner& corner : corners_of(mesh(f), face(f)))
      corners.push_back({{}, {affine_3d::transform(placement, position_of(mesh(f), corner)), {}}});
    Surface middle =
        polygon_shading::middle_of(std::span<const polygon_shading::Corner<double, Surface>>(corners));
    if (affine_3d::mirrors(placement) != t.seen_from_behind) middle.normal = -middle.normal;
    return middle;
  }

  Parts at(const Fragment& f, const Surface& surface) {
    const Lights& lights = lights_of(f.id.object);
    const Material& m = material(f);
    count_lamps(lights, m);
    return lit(lights, m, surface);
  }

  /// For the middle of the whole face, on the side that is seen.
  Parts of_face(const Fragment& f, const Triangle& t) {
    const auto [known, is_new] = faces_.try_emplace({f.id.object, f.id.face, t.seen_from_behind});
    if (is_new) known->second = at(f, middle_of_face(f, t));
    return known->second;
  }

  Parts of_corners(const Fragment& f, const Triangle& t) {
    const auto [known, is_new] = corners_.try_emplace(f.triangle);
    if (is_new) {
      for (std::size_t k = 0; k < 3; ++k) known->second[k] = at(f, corner_of(t, k));
    }
    const auto mixed = [&](dvec3 Parts::* part) {
      const auto& [a, b, c] = known->second;
      return f.weights.x * (a.*part) + f.weights.y * (b.*part) + f.weights.z * (c.*part);
    };
    return {mixed(&Parts::ambient), mixed(&Parts::diffuse), mixed(&Parts::specular)};
  }

  const Scene& scene_;
  const Plan* plan_;
  ShadingCount count_{};
  Textures textures_;
  std::map<int, Lights> lights_{};  ///< by object, where a plan tells them apart
  std::map<std::array<int, 3>, Parts> faces_{};
  std::map<int, std::array<Parts, 3>> corners_{};  ///< by triangle
};

/// The place, the normal and the light of one visible fragment. A texture multiplies what the surface sends
/// on of light from everywhere and from lamps, but for the highlight.
inline Shaded shaded(SceneLight& light, const Fragment& fragment, const Triangle& triangle) {
  const auto at = [](const TriangleCorner& c) { return c.world.at; };
  const dvec3 place = mean<dvec3>(fragment, triangle, at);
  dvec3 normal =
      unit_vector(mean<dvec3>(fragment, triangle, [](const TriangleCorner& c) { return c.normal; }));
  const dvec2 texture = mean<dvec2>(fragment, triangle, [](const TriangleCorner& c) { return c.texture; });
  Parts parts = light.at(fragment, triangle, {place, normal});
  const auto texel = light.texel(fragment, triangle, texture);
  if (texel) {
    parts.ambient *= dvec3(*texel);
    parts.diffuse *= dvec3(*texel);
  }
  return {fragment,       {place},
          normal,         texture,
          texel,          light.face(fragment).material,
          parts.ambient,  parts.diffuse,
          parts.specular, LinearRgb(parts.sum())};
}

inline Size size_of(const Visible& visible) { return {visible.width(), visible.height()}; }

/// A picture in one colour.
inline Raster<LinearRgb> filled(Size size, const LinearRgb& colour) {
  return {size.width, size.height, colour};
}

/// Gives every visible fragment its colour, and every other pixel the background's.
///
/// Steps: Shaded*, row by row.
/// Accuracy: that of illumination::phong.
/// Cost: one illumination per visible pixel, per corner of a visible triangle or per visible face:
///   scene.shading.
/// Errors: none.
template <Observer<Shaded> O = Unobserved>
Raster<LinearRgb> shade(const Scene& scene, const Triangles& all, const Visible& seen, O&& observer = {}) {
  auto size = size_of(seen);
  auto back = scene.background;
  auto image = filled(size, back);
  SceneLight light(scene, size);
  auto window = seen.window();
  for (ivec2 p : pixels(window)) {
    const auto& cell = seen[p];
    if (!cell.taken) continue;
    // The triangle seen there
    auto& f = cell.key.fragment;
    auto& t = triangle_of(f, all);
    // Lit by Phong's model
    auto lit = shaded(light, f, t);
    image[p] = lit.colour;
    if constexpr (observed<O>) observer(lit);
  }
  return image;
}

}  // namespace gradus::pipeline
