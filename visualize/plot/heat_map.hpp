#pragma once
// A picture with an amount for each of its pixels, coloured over it.

#include <string>

#include "core/image.hpp"
#include "core/raster.hpp"
#include "figure/sheet.hpp"

namespace gradus::plot {

/// Amounts over a picture in up to 7 classes, light to dark, and 0: classes that double (1, 2 to 3, 4 to 7
/// …), or of one width where all amounts are alike.
struct HeatMap {
  std::string title, subtitle;
  Image picture;        ///< drawn in grey
  Raster<int> amounts;  ///< of its size, >= 0
  std::string unit;     ///< heads the legend
  std::string sentence;
};

/// The heat map laid out; texts no smaller than 1/36 of the height.
/// Domain: picture and amounts of one size, at least a pixel (ContractViolation otherwise).
Sheet sheet_of(const HeatMap& map, double width = 1280, double height = 720);

}  // namespace gradus::plot
