#pragma once
// Files that users and models name: regular files of a stated size, and nothing else.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "scene/models/obj.hpp"
#include "scene/scene_file.hpp"

namespace gradus::pipeline {

/// The most that a file may hold, and what an OBJ file names.
inline constexpr std::size_t most_file_bytes = std::size_t{256} << 20;
inline constexpr std::size_t most_library_bytes = std::size_t{16} << 20;

/// What became of reading a file.
struct FileRead {
  std::string bytes;
  std::string problem;  ///< why it can't be read: "expected a regular file, found the folder 'x'"; else empty
};

/// A whole file. Folders, pipes, devices and sockets are not even opened, so that nothing waits for a writer.
/// most: bytes, a whole number of MiB; a larger file is a problem.
FileRead read_regular_file(const std::string& path, std::size_t most = most_file_bytes);

/// Whether a file lies in a folder or deeper, wherever links lead. folder: "" is the current one.
bool lies_in(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Reads what a model names from where the model lies: where the name says, with / or, as on Windows,
/// \ between folders; else, for a path on another disk, under its last part. A folder of that name is no
/// file. What lies outside the model's folder is read but not quotable. What an OBJ file names may be as
/// large as most_library_bytes, what others name as most_file_bytes: the model itself stands there.
///
/// model: path of its file; "" for one in the current folder. took: is told of each file that was read.
using Took = std::function<void(const std::string& name, const std::string& path, const LibraryText& file)>;
FileReader libraries_beside(const std::string& model, Took took = {});

/// Reads the models that a scene names from where the scene lies, and what they name from where they lie.
/// scene, took: as for libraries_beside; a model may be as large as most_file_bytes.
ModelFinder models_beside(const std::string& scene, const Took& took = {});

/// Reads a scene file and the models it names. decode: as for parse_scene.
///
/// Domain and errors: as parse_scene; InputError also for what read_regular_file refuses.
SceneFile load_scene(const std::string& path, const PictureDecoder& decode = {});

/// Reads an OBJ file and the material libraries it names.
///
/// path: of the file; libraries are looked for beside it (libraries_beside). Domain and errors: as parse_obj;
/// InputError also for what read_regular_file refuses.
ModelFile load_obj(const std::string& path);

}  // namespace gradus::pipeline
