#pragma once
// Pictures in JPEG files.

#include <cstdint>
#include <span>
#include <string>

#include "core/image.hpp"

namespace gradus {

/// Whether bytes begin as a JPEG file does.
bool begins_as_jpeg(std::span<const std::uint8_t> bytes);

/// The picture in a JPEG file's bytes, grey or in colour, baseline or progressive, as 8-bit RGBA; the same
/// bytes for the same library. What else stands in the file, such as how the camera was held, is not used.
/// `name` is how errors call the file.
///
/// A file whose end marker is missing, or with bytes too many before a marker or behind its end, is read:
/// phones write such, and all of the picture is there.
///
/// Domain: any bytes. Accuracy: that of libjpeg-turbo's slow integer transform, chroma interpolated.
/// Errors: InputError for bytes that are no whole JPEG, for more than `most_pixels`, and for pictures in the
///   inks of a printer (CMYK), whose colours depend on the printer.
Image decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, std::int64_t most_pixels);

}  // namespace gradus
