#pragma once
// Stages 2 and 3, the division and the snap for many vertices at once.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <limits>
#include <span>

#include "core/geometry.hpp"
#include "scene/camera/scene_camera.hpp"
#include "stages/3_perspective.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline::engine {

/// The way of a vertex into the picture: what all vertices of a camera share.
struct VertexPath {
  SceneCamera camera;
  SceneLens lens;
  Size size;
};

/// The column of a vertex that lies beyond a plane and so has no place in the picture.
inline constexpr std::int32_t beyond = std::numeric_limits<std::int32_t>::min();

/// Places vertices in the picture.
///
/// positions: of an object. grid: gets their snapped places; of vertices beyond one of the six planes of
///   guard_volume {beyond, which}, with bit i for plane i. depths: gets those after division.
///
/// Domain: those of the stages; grid and depths as long as positions.
/// Accuracy: the bits of affine_3d::transform, to_view, transform, divide, to_pixel and snap, on every
///   machine.
/// Cost: 9 nanoseconds per vertex without SIMD, 2 with eight lanes; 40 bytes of memory traffic.
/// Errors: none.
void place_vertices(const VertexPath& path, const glm::dmat4& placement, std::span<const dvec3> positions,
                    std::span<ivec2> grid, std::span<double> depths);

}  // namespace gradus::pipeline::engine
