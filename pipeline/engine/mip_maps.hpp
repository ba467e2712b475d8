#pragma once
// Textures in linear light and their levels, rows of texels shared among threads.

#include "core/image.hpp"
#include "stages/textures.hpp"

namespace gradus::pipeline::engine {

/// The texture of a picture in linear light, and its levels. Runs on the threads of the arena that it is
/// called in.
///
/// Domain: that of build_mip_chain.
/// Accuracy: the bits of LinearTexture's own.
/// Cost: some 3 nanoseconds per texel of the picture; 16 bytes each.
/// Errors: those of build_mip_chain.
LinearTexture linear_texture(const Image& texels);

}  // namespace gradus::pipeline::engine
