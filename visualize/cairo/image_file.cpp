#include "cairo/image_file.hpp"

#include <fmt/format.h>

#include "cairo/jpeg.hpp"
#include "cairo/metadata.hpp"
#include "core/shown.hpp"

namespace gradus {

std::string png_of(const Image& image, const Colophon& colophon) {
  const std::vector<std::uint8_t> bytes = encode_png(image, png_texts_of(colophon));
  return {bytes.begin(), bytes.end()};
}

Image decode_picture(std::string_view bytes, const std::string& name, std::int64_t most_pixels) {
  const std::span<const std::uint8_t> data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  if (begins_as_jpeg(data)) return decode_jpeg(data, name, most_pixels);
  if (bytes.starts_with("\x89PNG")) return decode_png(data, name, most_pixels);
  throw InputError(fmt::format("{}: expected a PNG or JPEG file, found {}", shown_name(name),
                               bytes.empty() ? "an empty one" : "something else"));
}

}  // namespace gradus
