#pragma once
// Scenes from JSON: objects and where they stand, camera, lights, and how all that is drawn. Files themselves
// are read elsewhere (scene/files.hpp): in a page there are none.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image.hpp"
#include "scene/camera/camera_path.hpp"
#include "scene/camera/view.hpp"
#include "scene/models/model_formats.hpp"
#include "scene/models/textures.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// What a scene file may hold at most.
inline constexpr std::size_t most_models = 1000, most_objects = 100'000, most_lights = 1000;

/// A scene that was read, still without a camera, whose place may depend on the picture's shape.
struct SceneFile {
  Scene scene;                     ///< objects, lights and how they are drawn
  bool lights_told = false;        ///< else default_lights are added with the camera
  std::optional<ivec2> size;       ///< of the picture, in pixels
  View view;                       ///< what is told of the camera
  std::optional<CameraPath> path;  ///< where it moves, if it does; its eye is told by path or view
  std::optional<dvec2> depths;     ///< near and far, 0 < near < far
  std::vector<std::string> notes;  ///< what was assumed or left out in models, "file:line: …"
};

/// A model that a scene names, as it was found.
struct FoundModel {
  LibraryText text;
  std::string called;  ///< how mistakes call it
  FileReader beside;   ///< gives what it names itself: material libraries and textures
};
/// Gives the model of a name, or nothing when there is none.
using ModelFinder = std::function<std::optional<FoundModel>(const std::string& name)>;

/// The scene in a JSON text; docs/scene.schema.json says which keys there are.
///
/// text: the file's contents. name: how mistakes call it. find: how to get at the models it names; each is
/// read
///   once. decode: makes textures of files; without it none are read. import: reads models that are no OBJ
///   files.
///
/// Placing: the transformations of an object's `place` act on it one after the other, the first one first; an
/// object with `instances` stands once for each of them, there first by `place`.
///
/// Domain: any bytes.
/// Accuracy: the nearest double to each number.
/// Cost: that of the models; objects that show the same model share its mesh.
/// Errors: InputError "file:line: /objects/0/place/1/scale: expected …, found …" for keys and values that the
///   schema refuses, numbers larger than 1e30 or, where they divide, below 1e-30, objects without an extent
///   left (a matrix that is not affine or that has no inverse), more than most_models, most_objects,
///   most_lights; "file:line: …" for what is no JSON and for what is wrong with a model.
SceneFile parse_scene(std::string_view text, const std::string& name, const ModelFinder& find,
                      const PictureDecoder& decode, const ModelImporter& import = {});

}  // namespace gradus::pipeline
