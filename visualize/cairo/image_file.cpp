#include "cairo/image_file.hpp"

#include "cairo/metadata.hpp"

namespace gradus {

std::string png_of(const Image& image, const Colophon& colophon) {
  const std::vector<std::uint8_t> bytes = encode_png(image, png_texts_of(colophon));
  return {bytes.begin(), bytes.end()};
}

}  // namespace gradus
