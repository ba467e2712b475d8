#pragma once
// Models of all formats: OBJ, OFF, PLY and STL by our own readers, others by an importer, if there is one.

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "scene/models/obj.hpp"

namespace gradus::pipeline {

/// What the names of models end in that our own readers read beside OBJ, in small letters.
inline constexpr std::array<std::string_view, 3> own_endings{"off", "ply", "stl"};
/// What the names of models end in that are imported, in small letters.
inline constexpr std::array<std::string_view, 32> imported_endings{
    "3ds",     "3mf",  "ac",  "amf",  "ase", "b3d", "blend", "cob",     "dae", "dxf", "fbx",
    "glb",     "gltf", "ifc", "iqm",  "lwo", "lws", "lxo",   "irrmesh", "md2", "md3", "mdl",
    "md5mesh", "ms3d", "nff", "ogex", "pmx", "q3o", "smd",   "x",       "x3d", "xgl"};

/// What stands behind the last dot of a file's name, in small letters.
std::string ending_of(std::string_view name);
/// Whether a model of this name is of another format than OBJ: by its ending.
bool is_other_format(std::string_view name);

/// Reads a model that is imported. As parse_obj, but that its faces know no lines.
using ModelImporter =
    std::function<ModelFile(std::string_view bytes, const TextFile& file, const FileReader& open)>;

/// The model in a file's bytes.
///
/// file: decides by its name who reads it. open: as for parse_obj. import: nobody where there is no library
///   for it.
///
/// Errors: InputError as parse_obj and the importer throw it, and for a model without an importer.
ModelFile read_model(std::string_view bytes, const TextFile& file, const FileReader& open,
                     const ModelImporter& import);

}  // namespace gradus::pipeline
