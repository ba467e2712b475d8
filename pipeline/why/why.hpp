#pragma once
// Why a pixel is what it is: every event of the chain that touched it, from the faces in their files to its
// colour.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "stages/1_input.hpp"
#include "stages/2_world.hpp"
#include "stages/3_perspective.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "stages/7_visibility_and_shading.hpp"
#include "stages/8_output.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A corner of a piece through stages 1 to 3.
struct CornerStory {
  Placed placed;
  Projected projected;
};

/// A triangle that covers the pixel's centre, through all stages.
struct FragmentStory {
  FaceRead face;
  std::array<CornerStory, 3> corners;
  bool mirrored = false;  ///< its object's placement mirrors
  Faced faced;
  Clipped clipped;
  Snapped snapped;
  DepthTested tested;
};

/// What one lamp adds at one place where light is computed.
struct LampStory {
  dvec3 place, normal;
  illumination::LightAdded<double> added;
};

/// All that happened at a pixel.
struct PixelStory {
  ivec2 pixel{0};
  std::vector<FragmentStory> fragments;  ///< in the order in which they came
  std::optional<Shaded> shaded;          ///< the one that is seen; nothing where the background is
  std::vector<LampStory> lamps;  ///< at its place; flat: in the face's middle; Gouraud: at each corner
  Written written;               ///< of the centre alone
  Rgba8 picture;                 ///< of the picture, with the scene's antialiasing
};

/// Tells what happens at a pixel's centre in `render`.
///
/// size: of the picture. pixel: column and row, from 0.
///
/// Domain: that of render.
/// Accuracy: the values of the chain, bit for bit.
/// Cost: the chain for the objects whose boxes may cover the pixel.
/// Errors: ContractViolation for a pixel beside the picture, and those of render.
PixelStory why(const Scene& scene, Size size, ivec2 pixel);

/// The file that a face was read from; empty when from none.
std::string file_of(const Scene& scene, const FaceRead& face);

}  // namespace gradus::pipeline
