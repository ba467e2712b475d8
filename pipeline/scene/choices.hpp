#pragma once
// What can be chosen for each picture, and what users call it. Each list of names has the order of its enum.

#include <array>
#include <string_view>

namespace gradus::pipeline {

/// How often light is computed (shading/polygon_shading).
enum class Shading {
  flat,       ///< once per face
  gouraud,    ///< once per corner of a triangle; what lies between is mixed
  phong,      ///< once per pixel
  wireframe,  ///< never: the edges of faces alone are drawn
};
inline constexpr std::array<std::string_view, 4> shading_names{"flat", "gouraud", "phong", "wireframe"};

/// How space comes into the picture's plane.
enum class Projection3d {
  perspective,   ///< through the eye (projection/perspective)
  orthographic,  ///< along the view direction (projection/parallel)
  oblique,       ///< along a direction that leans against it
};
inline constexpr std::array<std::string_view, 3> projection_names{"perspective", "orthographic", "oblique"};

/// Whether rays meet in an eye; others run beside one another.
constexpr bool has_eye(Projection3d projection) { return projection == Projection3d::perspective; }
/// Whether rays lean against the view direction.
constexpr bool leans(Projection3d projection) { return projection == Projection3d::oblique; }

/// What decides which of two surfaces is seen where both are.
enum class HiddenSurfaces {
  z_buffer,         ///< the depth of each pixel (visibility/z_buffer)
  painter,          ///< Newell's order, with cuts where there is none (visibility/painter)
  bsp_tree,         ///< the order of a BSP tree, which cuts triangles (visibility/bsp_tree)
  farthest_vertex,  ///< an exhibit: the order of farthest corners, wrong for some (visibility/painter)
};
inline constexpr std::array<std::string_view, 4> hidden_surface_names{"z_buffer", "painter", "bsp_tree",
                                                                      "farthest_vertex"};

/// Whether a method cuts triangles by the planes of others, so that its parts depend on all of them.
constexpr bool cuts(HiddenSurfaces method) {
  return method == HiddenSurfaces::painter || method == HiddenSurfaces::bsp_tree;
}

/// Which faces are left out because they turn their backs.
enum class Culling {
  closed_bodies,  ///< those of objects that are not two-sided
  none,           ///< not one
  back,           ///< all
};
inline constexpr std::array<std::string_view, 3> culling_names{"auto", "none", "back"};

}  // namespace gradus::pipeline
