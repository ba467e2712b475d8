#pragma once
// Where each file format keeps the colophon.

#include <cairo.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/image.hpp"
#include "figure/colophon.hpp"

namespace gradus {

/// What ids in a file may end in, so that files that share a page don't name each other's title.
std::string name_suffix(const Colophon& colophon);

/// <title>, <desc> and <metadata>, the first elements of an SVG; the ids are title-… and desc-….
std::string svg_head(const Colophon& colophon, const std::string& suffix);

std::vector<PngText> png_texts_of(const Colophon& colophon);

void set_pdf_metadata(cairo_surface_t* surface, const Colophon& colophon);

}  // namespace gradus
