#pragma once
// What `gradus render` and `gradus explain` read: a model or a scene, with all that lies beside it.

#include <string>
#include <vector>

#include "cli/command_line/inputs.hpp"
#include "scene/scene_file.hpp"

namespace gradus::cli {

/// A model, or a scene of several, as its file says.
struct RenderInput {
  pipeline::SceneFile scene;
  bool is_scene = false;  ///< rather than a model alone
  std::string name;       ///< without folders
  std::string hashes;     ///< of all files that were read, in this order
  std::vector<std::string> files;
  bool quotable = true;  ///< the first of them
};

/// Reads a model or a scene with the models, materials and pictures that it names.
///
/// operand: its name, or "-" for standard input. find: where it lies. textures: whether the
///   pictures are read that materials name. Throws UsageError and InputError.
RenderInput read_render_input(const std::string& operand, const FindFile& find, bool textures);

}  // namespace gradus::cli
