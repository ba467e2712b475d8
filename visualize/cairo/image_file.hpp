#pragma once
// Pictures that were not drawn by Cairo as files that say what made them, like figures do.

#include <string>

#include "core/image.hpp"
#include "figure/colophon.hpp"

namespace gradus {

/// The picture as a PNG with the same texts in it as a figure's: `colophon_in` finds them there.
std::string png_of(const Image& image, const Colophon& colophon);

}  // namespace gradus
