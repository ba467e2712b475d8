#include "cairo/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>

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

bool is_png_of(std::string_view bytes, const Colophon& colophon) {
  constexpr std::string_view end("IEND\xae\x42\x60\x82", 8);
  if (!bytes.ends_with(end)) return false;
  const auto same = [](const PngText& a, const PngText& b) { return a.key == b.key && a.text == b.text; };
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return std::ranges::equal(png_texts({data, bytes.size()}, "frame"), png_texts_of(colophon), same);
}

}  // namespace gradus
