#pragma once
// Models of formats that our own readers don't read, by Assimp where it was there when gradus was built.

#include "scene/models/model_formats.hpp"

namespace gradus::cli {

/// What a model that is imported may have at most, with everything that stands in it several times.
inline constexpr std::size_t most_imported_corners = std::size_t{1} << 26;

/// Reads models by Assimp; empty where gradus was built without it.
///
/// Node hierarchies are multiplied out, polygons kept, positions that are the same made one. Of materials it
/// takes the diffuse or base colour, which is the ambient one, too, highlight, emission, opacity and the
/// diffuse picture, also one inside the file. Missing normals are made as the format has it: flat in glTF,
/// smooth in others. With a note: what else there is.
///
/// Domain: any bytes, as far as Assimp can be trusted with them; graphs of glTF's nodes that are no trees are
///   refused before it sees them.
/// Accuracy: Assimp has single precision; places are multiplied out in double.
/// Errors: InputError "file: what is wrong" for what Assimp can't read, with the name of a file beside it
/// that is not there;
///   numbers that are not finite or larger than 1e30, indices of what there is not, more than
///   most_imported_corners, a model without a face.
pipeline::ModelImporter model_importer();

}  // namespace gradus::cli
