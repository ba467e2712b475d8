#pragma once
// How a sheet is brought to paper or screen: colours, ground, sharpness.

#include <cstdint>

#include "theme/theme.hpp"

namespace gradus {

/// Letters in SVG files: as shapes, the same everywhere, or as text that can be searched and edited.
enum class SvgText : std::uint8_t { outlines, text };

struct Finish {
  Theme theme;               ///< a ground of one's own is a theme with another paper
  bool transparent = false;  ///< no ground is painted (halos keep the theme's paper)
  double scale = 1;          ///< PNG: pixels of the file for a pixel of the figure, 0.1 to 8
  SvgText svg_text = SvgText::outlines;

  Finish(const Theme& colors) : theme(colors) {}  // NOLINT: a theme alone is a finish
};

}  // namespace gradus
