#pragma once
// Picture files: those that users give, and pictures that were not drawn by Cairo as files that say what made
// them, like figures do.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/image.hpp"
#include "figure/colophon.hpp"

namespace gradus {

/// The picture as a PNG with the same texts in it as a figure's: `colophon_in` finds them there.
std::string png_of(const Image& image, const Colophon& colophon);

/// The picture in the bytes of a PNG or JPEG file; `name` is how errors call it. Throws InputError: as
/// decode_png and decode_jpeg do, and for bytes that are neither.
Image decode_picture(std::string_view bytes, const std::string& name,
                     std::int64_t most_pixels = most_png_pixels);

/// Whether a file's bytes are what png_of makes for this colophon, but for the picture, of which it is only
/// asked whether it is there to the end. Errors: InputError for bytes that are no PNG.
bool is_png_of(std::string_view bytes, const Colophon& colophon);

}  // namespace gradus
