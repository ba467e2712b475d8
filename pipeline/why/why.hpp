#pragma once
// Why a pixel is what it is: every event of the chain that touched it, from the faces in their files to its
// colour.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "core/raster.hpp"
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
  double share = 0;  ///< of its colour in that of the centre; 0: nothing of it is seen
};

/// What one lamp adds at one place where light is computed.
struct LampStory {
  dvec3 place, normal;
  illumination::LightAdded<double> added;
};

/// A surface that is seen, and its light.
struct Layer {
  Shaded shaded;
  std::vector<LampStory> lamps;  ///< at its place; flat: in the face's middle; Gouraud: at each corner
  double opacity = 1;            ///< where opacities are drawn: see draws_opacity
  double share = 1;              ///< its opacity times what those before it let through
};

/// All that happened at a pixel.
struct PixelStory {
  ivec2 pixel{0};
  std::vector<FragmentStory> fragments;  ///< in the order in which they came
  std::vector<Layer> layers;             ///< from the eye on, up to the first that lets nothing through
  double background = 1;                 ///< the share of what they all let through
  Written written;                       ///< of the centre alone
  Rgba8 picture;                         ///< of the picture, with the scene's antialiasing
};

/// The fragment of a surface that is seen. layer: one of the story's.
const FragmentStory& fragment_of(const PixelStory& story, const Layer& layer);

/// Whether more than one surface, or the background through some, makes the colour of the centre.
inline bool is_mixed(const PixelStory& story) {
  return story.layers.size() > 1 || (!story.layers.empty() && story.background > 0);
}

/// The stories of the pixels of a part of a picture, all from one run of the chain.
class PixelStories {
 public:
  /// size: of the picture. window: the pixels, column and row from 0. reached: told of the share of the
  ///   antialiased picture that is done, from 0 to 1.
  ///
  /// Domain: that of render; the scene outlives the stories.
  /// Cost: the chain for the objects whose boxes may cover the window, twice, and the antialiased picture.
  /// Errors: ContractViolation for a window that is empty or not within the picture, and those of render.
  PixelStories(const Scene& scene, Size size, const Window& window,
               const std::function<void(double)>& reached = {});

  /// What happens at the pixel's centre in `render`. Keeps light that other pixels may ask for again.
  ///
  /// Accuracy: the values of the chain, bit for bit.
  /// Cost: its fragments, for each layer again, and the light of those seen.
  /// Errors: ContractViolation for a pixel beside the window.
  PixelStory of(ivec2 pixel);

  /// The window of the picture, with the scene's antialiasing.
  const Image& picture() const { return picture_; }

 private:
  void find_fragments();
  std::vector<Layer> layers_of(ivec2 pixel);
  void find_pieces(const std::vector<int>& objects);

  const Scene& scene_;
  Size size_;
  Window window_;
  SceneLight light_;
  Triangles triangles_{};
  std::vector<Snapped> snapped_{};             ///< by triangle
  Raster<std::vector<Fragment>> fragments_{};  ///< of each pixel, in the order in which they came
  std::map<PieceId, FragmentStory> pieces_{};  ///< up to clipping
  Image picture_{};                            ///< of the window, antialiased
};

/// The story of one pixel.
PixelStory why(const Scene& scene, Size size, ivec2 pixel);

/// Of how many lamps the story of a shaded pixel tells: an area's all, and of each corner with Gouraud's
/// shading.
std::int64_t lamps_told(const Scene& scene);

/// A snapped place in pixels.
inline dvec2 in_pixels(const SnappedPoint& point) {
  return dvec2(point.at) / double{triangle_coverage::subpixels};
}

/// The file that a face was read from; empty when from none.
std::string file_of(const Scene& scene, const FaceRead& face);

}  // namespace gradus::pipeline
