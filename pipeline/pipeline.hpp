#pragma once
// The textbook chain: a scene becomes a picture in eight stages.

#include "core/image.hpp"
#include "core/observe.hpp"
#include "scene/scene.hpp"
#include "stages/1_input.hpp"
#include "stages/2_world.hpp"
#include "stages/3_perspective.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "stages/7_visibility_and_shading.hpp"
#include "stages/8_output.hpp"
#include "stages/antialiasing.hpp"
#include "stages/arrangement.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// The largest side of a picture, in pixels.
inline constexpr int largest_side = 1 << 15;

/// Refuses a picture without pixels, or with too many.
inline void expect_size(Size size) {
  const auto [width, height] = size;
  expects(1 <= width && width <= largest_side && 1 <= height && height <= largest_side,
          "a picture has 1 to {} pixels per side, not {} x {}", largest_side, width, height);
}

/// O can be told the steps of all eight stages.
template <class O>
concept ChainObserver = Observer<O, VertexRead, FaceRead, Placed, Turned, Projected, Faced, Clipped, Snapped,
                                 Covered, DepthTested, Shaded, Written>;

/// Renders a scene from the centres of the pixels.
///
/// scene: objects, camera and lights. size: of the picture; its width / height is the camera's.
///
/// Domain: finite coordinates. Nothing before the camera gives the background.
/// Steps: those of the stages, one after the other; those of stage 6 and of its z-buffer alternate: stage 1,
///   2, 3, 4, 5, (Snapped (Covered DepthTested)*)*, Shaded*, Written*.
/// Accuracy: coverage is exact for corners snapped to 1/256 pixel. The same bytes on every machine.
/// Cost: memory of about 100 bytes per pixel and 1000 bytes per triangle.
/// Errors: ContractViolation for a size or a lens out of range.
template <ChainObserver O = Unobserved>
Image render(const Scene& scene, Size size, O&& observer = {}) {
  expect_size(size);
  // 1 Input model
  auto in = input(scene, observer);
  // 2 World transformation
  auto w = to_world(scene, in, observer);
  // 3 Perspective transformation
  auto c = to_clip(scene, size, w, observer);
  // 4 Back-face removal
  auto front = cull(scene, c, observer);
  // 5 Clipping, then division by w
  auto t = clip(w, front, size, observer);
  // Painter, BSP tree: their order
  arrange(scene, front, size, t);
  // 6 Rasterization
  auto kept = z_buffer_of(size);
  auto emit = [&](auto& f) {
    // 7 Hidden surface removal
    keep_nearest(f, kept, observer);
  };
  rasterize(t, size, emit, observer);
  // 7 Shading
  auto lit = shade(scene, t, kept, observer);
  // 8 Output
  return output(lit, observer);
}

/// The light of a scene with the antialiasing that it asks for, before its background or none.
///
/// scene, size: as for render.
///
/// Domain, Errors: those of render and of antialias.
/// Accuracy: without antialiasing, the bits of render.
/// Cost: that of antialias.
inline LightPicture antialiased(const Scene& scene, Size size) {
  expect_size(size);
  // 1 to 5 as without
  const auto world = to_world(scene, input(scene));
  const auto seen = to_clip(scene, size, world);
  const auto facing = cull(scene, seen);
  Triangles triangles = clip(world, facing, size);
  arrange(scene, facing, size, triangles);
  // 6 and 7, of several places per pixel
  return antialias(scene, triangles, size);
}

/// The picture of it, before the scene's background.
inline Image render_antialiased(const Scene& scene, Size size) {
  // 8 Output
  return output(over_background(antialiased(scene, size), scene.background));
}

}  // namespace gradus::pipeline
