#pragma once
// A scene ready to be rendered as somebody wishes, from where its camera stands or goes.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/render.hpp"
#include "cli/render/render_wish.hpp"
#include "engine/buffers.hpp"
#include "plan/ledger.hpp"
#include "scene/camera/view.hpp"
#include "scene/scene.hpp"

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
  double reading = 0;            ///< how long that took, in seconds
};

/// The time in seconds, from any beginning: the clock of ledgers.
double seconds_now();

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

/// Draws the pictures of a shot, by the engine where the shot and the scene let it.
class ShotArtist {
 public:
  /// shot: must outlive it. threads: of the engine, for one picture.
  ShotArtist(const Shot& shot, std::size_t threads);

  /// scene: that of the shot, its camera anywhere. ledger: gets what was done, and what was left out.
  /// reached: told of the share that is done. From any thread.
  Picture paint(const pipeline::Scene& scene, pipeline::Ledger& ledger,
                const std::function<void(double)>& reached = {}) const;
  /// How long its mip maps and buffers took, in seconds.
  double preparing() const { return preparing_; }
  /// What draws, as the report calls it.
  std::string_view drawn_by() const;

 private:
  const Shot& shot_;
  int threads_;
  double preparing_ = 0;
  std::optional<pipeline::engine::Buffers> buffers_{};  ///< where the engine draws
};

}  // namespace gradus::cli
