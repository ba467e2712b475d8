#pragma once
// Pictures: an 8-bit sRGB raster with row 0 at the top, read from and written to PNG.
// The type is portable; reading and writing PNG is the target gradus::image, which needs libpng.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/raster.hpp"
#include "core/refusal.hpp"  // IWYU pragma: export

namespace gradus {

/// One 8-bit sRGB colour, not premultiplied; alpha 255 is opaque.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

using Image = Raster<Rgba8>;

/// A key and its text, stored with a picture (PNG iTXt).
struct PngText {
  std::string key, text;
};

inline constexpr std::int64_t most_png_pixels = std::int64_t{1} << 28;

/// The picture in a PNG file's bytes, of any bit depth and colour type, as 8-bit RGBA.
/// `name` is how errors call the file. Throws InputError when the bytes are no valid PNG.
/// Domain: width x height at most `most_pixels`, by default 2^28 (1 GiB), so that a hostile header asks for
/// no more: a few kilobytes can hold as many.
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name,
                 std::int64_t most_pixels = most_png_pixels);

/// The texts stored in a PNG. Throws InputError when the bytes are no valid PNG.
std::vector<PngText> png_texts(std::span<const std::uint8_t> bytes, const std::string& name);

/// The picture as PNG bytes: 8-bit RGB when every pixel is opaque, else RGBA; the same bytes for the same
/// input. Fast rather than small (deflate level 3 without filters: a third of the time of the usual setting).
std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts = {});

/// Reads a PNG file. Throws InputError naming the file when it can't be read or is no PNG.
Image read_png(const std::string& path);

}  // namespace gradus
