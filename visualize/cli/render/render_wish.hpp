#pragma once
// What the flags of `gradus render`, and before them a scene's file, say of a picture.

#include <optional>
#include <string>

#include "cli/render/frame_range.hpp"
#include "cli/render/plan_flags.hpp"
#include "cli/render/render_choices.hpp"
#include "core/geometry.hpp"
#include "core/image.hpp"
#include "scene/antialiasing.hpp"
#include "scene/camera/view.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "stages/points.hpp"

namespace gradus::cli {

/// How a scene is to be seen and drawn.
struct Wish {
  pipeline::Size size;
  pipeline::View view;
  std::optional<pipeline::CameraPath> path;  ///< of the camera; what a flag tells stands still
  std::optional<int> turntable;              ///< so many frames once round take the path's place
  std::optional<FrameRange> frames;          ///< that are asked for
  std::optional<dvec3> light;
  std::optional<dvec2> depths;  ///< of the near and the far plane
  std::optional<Rgba8> background;
  bool transparent = false;
  DrawnSurfaces surfaces;
  std::optional<pipeline::TextureFilter> filter =
      pipeline::TextureFilter::mip_mapped;  ///< nothing: no textures
  pipeline::Antialiasing antialiasing = pipeline::default_antialiasing;
  int samples = pipeline::default_samples;
  PlanWish plan;     ///< read where the size is known
  std::string said;  ///< the flags in their canonical spelling, " --size 640x480", but for frames and plan
};

/// What the flags say alone. Throws UsageError.
Wish read_wish(const Flags& flags);
/// What they change of what a scene's file says: each counts, also where it says what is the default
/// elsewhere. Throws UsageError.
Wish read_wish(const Flags& flags, const pipeline::SceneFile& file);

/// The size of the picture, or of the part of it that is asked for.
pipeline::Size shown_size(const Wish& wish);

}  // namespace gradus::cli
