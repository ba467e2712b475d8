#include "cli/render/render_input.hpp"

#include <filesystem>
#include <utility>

#include "cairo/image_file.hpp"
#include "cli/files/files.hpp"
#include "cli/models/imported_model.hpp"
#include "request/fingerprint.hpp"
#include "scene/files.hpp"
#include "scene/located_json.hpp"
#include "scene/models/model_formats.hpp"
#include "scene/models/textures.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

pipeline::SceneFile scene_in(const std::string& text, const std::string& called, bool quotable,
                             const pipeline::ModelFinder& find, const pipeline::PictureDecoder& decode) {
  try {
    return pipeline::parse_scene(text, called, find, decode, model_importer());
  } catch (const InputError&) {
    if (quotable) throw;
    throw InputError(called + ": expected a scene, found something else");
  }
}

}  // namespace

RenderInput read_render_input(const std::string& operand, const FindFile& find, bool textures) {
  RenderInput input;
  const bool from_stdin = operand == dash;
  const FoundFile file = from_stdin ? FoundFile(operand) : find(operand, "MODEL");
  const auto take = [&input](const std::string& path, const std::string& bytes) {
    input.hashes += (input.hashes.empty() ? "" : " ") + fingerprint(bytes);
    input.files.push_back(path);
  };
  const std::string text = read_input(file.path, "MODEL");
  take(file.path, text);
  input.name = from_stdin ? operand : fs::path(operand).filename().string();
  input.quotable = file.quotable;
  input.is_scene =
      !pipeline::is_other_format(file.path) && pipeline::begins_as_json(text);  // no OBJ file does
  const auto took = [&](const std::string&, const std::string& path, const pipeline::LibraryText& library) {
    take(path, library.text);
  };
  const std::string called = from_stdin ? "standard input" : file.path, place = from_stdin ? "" : file.path;
  const pipeline::PictureDecoder decode = textures ? decode_picture : pipeline::PictureDecoder();
  if (input.is_scene) {
    input.scene = scene_in(text, called, file.quotable, pipeline::models_beside(place, took), decode);
    return input;
  }
  const auto beside = pipeline::libraries_beside(place, took);
  pipeline::ModelFile model = pipeline::read_model(text, {called, file.quotable}, beside, model_importer());
  if (textures) pipeline::load_textures(model, beside, decode_picture, called);
  input.scene.notes = std::move(model.notes);
  input.scene.scene.objects.push_back(pipeline::object_of(std::move(model.mesh), input.name));
  return input;
}

}  // namespace gradus::cli
