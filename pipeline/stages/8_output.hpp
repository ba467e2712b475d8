#pragma once
// Stage 8, output: light becomes the 8-bit sRGB of an image file.

#include "core/colour.hpp"
#include "core/image.hpp"
#include "core/observe.hpp"
#include "core/pixels.hpp"
#include "core/raster.hpp"
#include "core/surface.hpp"

namespace gradus::pipeline {

/// A pixel is written.
struct Written {
  ivec2 pixel;
  LinearRgb light;
  Rgba8 colour;
  bool cut_off;  ///< more light than white has: a component was above 1
};

/// Whether there is more light than white has.
inline bool too_bright(const LinearRgb& light) { return light.r > 1 || light.g > 1 || light.b > 1; }

/// The picture. What is brighter than white becomes white.
///
/// Domain: everything.
/// Steps: Written*, row by row.
/// Accuracy: the nearest 8-bit value.
/// Cost: three look-ups per pixel.
/// Errors: none.
template <Observer<Written> O = Unobserved>
Image output(const Raster<LinearRgb>& light, O&& observer = {}) {
  const int width = light.width();
  const int height = light.height();
  Image image(width, height);
  const auto all = light.window();
  for (ivec2 p : pixels(all)) {
    // By sRGB's curve, in 8 bits
    const LinearRgb& c = light[p];
    image[p] = srgb8_from_linear(c);
    if constexpr (observed<O>) observer(Written{p, c, image[p], too_bright(c)});
  }
  return image;
}

}  // namespace gradus::pipeline
