#pragma once
// The engine: the picture of the textbook chain, sooner. Vertices go through the camera once, triangles are
// sorted into tiles, each tile finds what is nearest at its pixels and then lights that alone; tiles are
// shared among threads.

#include "core/image.hpp"
#include "engine/buffers.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"
#include "stages/antialiasing.hpp"

namespace gradus::pipeline::engine {

/// Whether the engine draws a scene: surfaces by the z-buffer. The textbook chain draws wireframes, and what
/// asks for the painter or a BSP tree.
bool draws(const Scene& scene);

/// The light of the part of the picture that a plan asks for, with the scene's antialiasing.
///
/// buffers: of this scene. plan: of this scene; nothing is added to it. threads: how many work at once; 0 for
///   as many as the machine has.
///
/// Domain: draws(scene), else refused; that of `antialiased`.
/// Accuracy: the bits of `antialiased`, for any number of threads.
/// Cost: stages 2 to 5 once a vertex and a piece, 6 and 7 by tile, shading as `antialias` has it. Memory: 88
///   bytes a vertex, 80 a triangle that is drawn, 32 a pixel; with antialiasing 400 more for each triangle of
///   the tiles that are being drawn, and what the method takes for their pixels.
/// Errors: ContractViolation outside of the domain.
LightPicture light_of(const Scene& scene, const Buffers& buffers, const Plan& plan, int threads = 0);

/// The picture of a scene from the centres of its pixels: the bytes of pipeline::render.
Image render(const Scene& scene, Size size, int threads = 0);

}  // namespace gradus::pipeline::engine
