#pragma once
// Where each file format keeps the colophon.

#include <cairo.h>

#include <string>
#include <vector>

#include "core/image.hpp"
#include "figure/colophon.hpp"

namespace gradus {

/// Cairo numbers the groups and images of SVGs through the whole process ("surface17", "image23"): numbers
/// them from 1 in every file.
std::string renumbered(const std::string& svg);

/// The SVG with <title>, <desc> and <metadata> as its first elements.
std::string with_colophon(const std::string& svg, const Colophon& colophon);

std::vector<PngText> png_texts_of(const Colophon& colophon);

void set_pdf_metadata(cairo_surface_t* surface, const Colophon& colophon);

}  // namespace gradus
