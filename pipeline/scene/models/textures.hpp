#pragma once
// The pictures that materials name. The caller knows how to read a PNG or a JPEG: pages that draw models have
// no decoders.

#include <functional>
#include <string>

#include "core/image.hpp"
#include "core/mesh.hpp"
#include "scene/models/obj.hpp"

namespace gradus::pipeline {

/// How far from 0 texture coordinates may lie where there is a texture.
inline constexpr double farthest_texture_coordinate = 1 << 19;
/// How many texels the textures of a model may have in all.
inline constexpr std::int64_t most_texels = std::int64_t{1} << 25;

/// The picture in a file's bytes, of at most so many pixels; errors call it `name`. Throws InputError.
using PictureDecoder =
    std::function<Image(const std::string& bytes, const std::string& name, std::int64_t most_pixels)>;

/// Reads the textures of all materials that faces have, each file once.
///
/// open: gives the file that a material names. decode: makes a picture of it. name: how mistakes call the
///   model.
///
/// Domain: everything.
/// Errors: InputError "file:line: what is wrong" for a texture that is not there, can't be read, is no
///   picture or larger than 2^15 per side, for more than most_texels in all, and for texture coordinates
///   beyond farthest_texture_coordinate where there is a texture.
void load_textures(Mesh& mesh, const FileReader& open, const PictureDecoder& decode, const std::string& name);
/// The same of a model, which may hold pictures itself.
void load_textures(ModelFile& model, const FileReader& open, const PictureDecoder& decode,
                   const std::string& name);

}  // namespace gradus::pipeline
