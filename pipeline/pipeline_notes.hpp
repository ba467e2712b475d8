#pragma once
// Exhibits: the textbook chain with one stage as lecture notes have it. Never render with it; pipeline.hpp
// has the right one.

#include "pipeline.hpp"
#include "stages/4_back_faces_notes.hpp"
#include "stages/6_rasterization_notes.hpp"

namespace gradus::pipeline {

/// What is wrong with a chain.
enum class Fault {
  none,
  cull_after_division,  ///< stage 4 divides, and culls before anything is clipped
  closed_half_planes,   ///< stage 6 gives centres on an edge to both sides
  expanded_edges,       ///< stage 6 has multiplied out its edge functions, far from the origin
};

/// FAULTY unless Fault::none: renders a scene with one stage exchanged.
///
/// scene, size: as for render.
///
/// Domain, Steps, Cost, Errors: as render. Accuracy: that of the stage exchanged.
template <ChainObserver O = Unobserved>
Image render_with(Fault fault, const Scene& scene, Size size, O&& observer = {}) {
  if (fault == Fault::none) return render(scene, size, observer);
  expect_size(size);
  const auto model = input(scene, observer);
  const auto world = to_world(scene, model, observer);
  const auto seen = to_clip(scene, size, world, observer);
  const auto facing = fault == Fault::cull_after_division ? cull_after_division(scene, seen, observer)
                                                          : cull(scene, seen, observer);
  Triangles triangles = clip(world, facing, size, observer);
  arrange(scene, facing, size, triangles);
  Visible kept = z_buffer_of(size);
  const auto emit = [&](const Fragment& f) { keep_nearest(f, kept, observer); };
  if (fault == Fault::closed_half_planes) {
    rasterize_closed(triangles, size, emit, observer);
  } else if (fault == Fault::expanded_edges) {
    rasterize_expanded(triangles, size, emit, observer);
  } else {
    rasterize(triangles, size, emit, observer);
  }
  return output(shade(scene, triangles, kept, observer), observer);
}

}  // namespace gradus::pipeline
