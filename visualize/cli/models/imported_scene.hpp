#pragma once
// From a scene as Assimp reads it to a model of ours.

#include "scene/models/obj.hpp"

struct aiScene;

namespace gradus::cli {

/// What the format says that Assimp's scene does not.
struct ImportedFormat {
  bool flat = false;  ///< faces without normals are flat
  bool uris = false;  ///< names of pictures are URIs: a blank is %20
};

/// The model in such a scene, checked. file: how mistakes call it, and whether they may quote it.
/// Errors: as model_importer says.
pipeline::ModelFile model_of(const aiScene& scene, const pipeline::TextFile& file,
                             const ImportedFormat& format);

}  // namespace gradus::cli
