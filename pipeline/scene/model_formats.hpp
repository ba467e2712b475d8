#pragma once
// Models of all formats: OBJ by our own reader, others by whoever is there to import them.

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "scene/obj.hpp"

namespace gradus::pipeline {

/// What the names of models end in that are imported, in small letters.
inline constexpr std::array<std::string_view, 35> imported_endings{
    "3ds",  "3mf", "ac",   "amf", "ase", "b3d", "blend",   "cob", "dae", "dxf", "fbx",     "glb",
    "gltf", "ifc", "iqm",  "lwo", "lws", "lxo", "irrmesh", "md2", "md3", "mdl", "md5mesh", "ms3d",
    "nff",  "off", "ogex", "ply", "pmx", "q3o", "smd",     "stl", "x",   "x3d", "xgl"};

/// What stands behind the last dot of a file's name, in small letters.
std::string ending_of(std::string_view name);
/// Whether a model of this name is imported: by its ending. All others are OBJ files.
bool is_imported(std::string_view name);

/// Reads a model that is imported. As parse_obj, but that its faces know no lines.
using ModelImporter =
    std::function<ModelFile(std::string_view bytes, const TextFile& file, const FileReader& open)>;

/// The model in a file's bytes.
///
/// file: decides by its name who reads it. open: as for parse_obj. import: nobody where there is no library
///   for it.
///
/// Errors: InputError as parse_obj and the importer throw it, and for a model that nobody can import.
ModelFile read_model(std::string_view bytes, const TextFile& file, const FileReader& open,
                     const ModelImporter& import);

}  // namespace gradus::pipeline
