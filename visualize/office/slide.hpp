#pragma once
// A laid out figure as the shapes of one slide.

#include <string>
#include <vector>

#include "office/presentation.hpp"

namespace gradus {

struct Slide {
  std::string xml;                     ///< the part ppt/slides/slideN.xml
  std::vector<PictureBytes> pictures;  ///< in the order of their relations: see picture_relation
};

/// What a slide's XML calls its i-th picture as pixels and as vectors: "rIdPng0", "rIdSvg0".
std::string png_relation(std::size_t i);
std::string svg_relation(std::size_t i);

Slide slide_of(const PresentedStep& step, const DrawPart& draw, const Theme& theme);

/// Pixels of a figure as the units of an Office file: 914,400 per inch of 96 pixels.
long long emu(double pixels);

}  // namespace gradus
