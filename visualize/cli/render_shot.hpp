#pragma once
// A scene ready to be rendered as somebody wishes, from where its camera stands or goes.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/inputs.hpp"
#include "cli/render.hpp"
#include "cli/render_wish.hpp"
#include "plan/ledger.hpp"
#include "scene/scene.hpp"
#include "scene/view.hpp"

namespace gradus::cli {

/// All that a request asks for, read and ready to be rendered.
struct Shot {
  Wish wish;
  pipeline::Scene scene;  ///< with the camera of the frame that is asked for first, or of the path's first
  RenderBrief brief;
  bool lights_go_along = false;  ///< none are told, and the camera goes round what turns under them
  std::string operand;           ///< the scene's or model's name without folders, or dash
  std::string name;              ///< what it is called in titles
  std::string contents;          ///< "5856 faces, 11712 triangles"
};

/// Reads flags, scene and model, and aims the camera. find: where they lie. Throws UsageError and InputError.
Shot read_shot(const Request& request, const FindFile& find);

/// How a frame of the shot's path is seen. Throws UsageError for one that is not told what is up in it, or
/// where it looks.
pipeline::View view_of_frame(const Shot& shot, int frame);

/// The camera of a view of the shot.
pipeline::SceneCamera camera_of(const Shot& shot, const pipeline::View& view);

/// What a picture of the shot says of itself. frames: of the path, where they were asked for; eye: of the
/// camera.
Colophon colophon_of(const Shot& shot, const std::optional<FrameRange>& frames, dvec3 eye);

/// The picture, and how many of its pixels show the model.
struct Picture {
  Image image;
  std::int64_t covered = 0;
};

/// ledger: gets what was done, and what the plan left out. reached: told of the share that is done.
Picture picture_of(const pipeline::Scene& scene, const Wish& wish, pipeline::Ledger& ledger,
                   const std::function<void(double)>& reached = {});

}  // namespace gradus::cli
