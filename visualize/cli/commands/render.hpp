#pragma once
// A model as a picture: what `gradus render` makes, and `gradus again` makes again.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "cli/render/plan_flags.hpp"
#include "figure/colophon.hpp"
#include "plan/ledger.hpp"
#include "scene/scene.hpp"

namespace gradus::cli {

/// What a picture of a model says of itself, and what went into it.
struct RenderBrief {
  Colophon colophon;
  std::vector<std::string> files;    ///< paths that were read: the model, then its material libraries
  bool quotable = true;              ///< FoundFile's, of the model
  std::vector<std::string> remarks;  ///< what the user should know and what is no mistake, a line each
  int width = 0, height = 0;         ///< of the picture, in pixels
};

/// A picture of a model, as the bytes of a PNG.
struct Rendered : RenderBrief {
  std::string png;
  pipeline::Ledger ledger;      ///< what was done for it
  std::string_view drawn_by{};  ///< and by whom
};

/// The frames of a camera's path, which of them is rendered, and which show what the one before them shows.
struct PathFacts {
  int first = 0, last = 0, shown = 0;
  std::vector<int> unchanged{};
};

/// All that a request asks for, read and not yet rendered.
struct RenderJob {
  pipeline::Scene scene;
  pipeline::Size size;
  PlanWish plan;
  RenderBrief brief;
  std::optional<PathFacts> path;
};

/// Renders what a request of `gradus render` asks for. find: where the model lies; its material libraries lie
/// beside it. on_read: told what has been read, before the first pixel. Throws UsageError and InputError.
Rendered rendered(const Request& request, const FindFile& find = as_named,
                  const std::function<void(const RenderBrief&)>& on_read = {});

/// The same short of rendering: reads flags and model, and aims the camera. Throws what rendered() would.
RenderBrief render_brief(const Request& request, const FindFile& find = as_named);

/// The same with the scene itself.
RenderJob render_job(const Request& request, const FindFile& find = as_named);

/// Makes what a request of `gradus render` with an output asks for, as the output's name says: a picture, or
/// with --why a figure. Throws what rendered() would, and WorkError.
void make_rendered(const Request& request, const Output& output, const FindFile& find,
                   const std::function<void(const RenderBrief&)>& on_read);

/// What a model or a scene is called: its file's name.
std::string scene_name(const RenderBrief& brief);

/// Refuses an output that can't be what such a request makes: another ending, a folder, a terminal. Throws
/// UsageError.
void check_rendered_output(const Request& request, const std::string& output);

}  // namespace gradus::cli
