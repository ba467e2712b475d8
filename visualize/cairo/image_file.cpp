#include "cairo/image_file.hpp"

#include <algorithm>
#include <cstdint>

#include "cairo/metadata.hpp"

namespace gradus {

std::string png_of(const Image& image, const Colophon& colophon) {
  const std::vector<std::uint8_t> bytes = encode_png(image, png_texts_of(colophon));
  return {bytes.begin(), bytes.end()};
}

bool is_png_of(std::string_view bytes, const Colophon& colophon) {
  constexpr std::string_view end("IEND\xae\x42\x60\x82", 8);
  if (!bytes.ends_with(end)) return false;
  const auto same = [](const PngText& a, const PngText& b) { return a.key == b.key && a.text == b.text; };
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return std::ranges::equal(png_texts({data, bytes.size()}, "frame"), png_texts_of(colophon), same);
}

}  // namespace gradus
