#include "scene/models/textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "shading/texture_mapping/texture_mapping.hpp"

namespace gradus::pipeline {
namespace {

class TextureLoader {
 public:
  TextureLoader(const FileReader& open, const PictureDecoder& decode) : open_(open), decode_(decode) {}

  void load(Texture& texture) {
    const auto [known, is_new] = read_.try_emplace(texture.file);
    if (is_new) known->second = read(texture);
    texture.texels = known->second;
  }

 private:
  Image read(const Texture& texture) {
    const auto fail = [&](std::string_view what) {
      refuse_input(fmt::format("{}: {}", texture.place, what));
    };
    const auto file = open_(texture.file);
    if (!file) fail("expected a PNG or JPEG file of that name beside the model, found none");
    const bool quotable = file->quotable && texture.quotable;
    if (!file->problem.empty()) fail(quotable ? file->problem : "expected a file that can be read");
    Image image = decode_(file->text, texture.place, left_);
    const int side = std::max(image.width(), image.height());
    if (side > texture_mapping::largest)
      fail(fmt::format("expected at most {} pixels per side, found {}", texture_mapping::largest, side));
    left_ -= static_cast<std::int64_t>(image.width()) * image.height();
    return image;
  }

  const FileReader& open_;
  const PictureDecoder& decode_;
  std::int64_t left_ = most_texels;
  std::map<std::string, Image> read_;
};

void check_coordinates(const Mesh& mesh, const MeshFace& face, const std::string& name) {
  for (const Corner& corner : corners_of(mesh, face)) {
    if (corner.texture < 0) continue;
    const dvec2 uv = mesh.textures[static_cast<std::size_t>(corner.texture)];
    const auto near = [](double x) { return std::abs(x) <= farthest_texture_coordinate; };
    if (near(uv.x) && near(uv.y)) continue;
    refuse_input(fmt::format("{}: expected texture coordinates within {} of 0 on faces with a texture",
                             shown_name(name), farthest_texture_coordinate));
  }
}

}  // namespace

void load_textures(Mesh& mesh, const FileReader& open, const PictureDecoder& decode,
                   const std::string& name) {
  TextureLoader loader(open, decode);
  std::set<int> loaded;
  for (const MeshFace& face : mesh.faces) {
    Texture& texture = mesh.materials[static_cast<std::size_t>(face.material)].diffuse_map;
    if (texture.file.empty()) continue;
    check_coordinates(mesh, face, name);
    if (loaded.insert(face.material).second) loader.load(texture);
  }
}

void load_textures(ModelFile& model, const FileReader& open, const PictureDecoder& decode,
                   const std::string& name) {
  const FileReader inside_first = [&](const std::string& file) -> std::optional<LibraryText> {
    const auto found = model.pictures.find(file);
    return found == model.pictures.end() ? open(file) : LibraryText(found->second);
  };
  load_textures(model.mesh, inside_first, decode, name);
}

}  // namespace gradus::pipeline
