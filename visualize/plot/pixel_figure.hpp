#pragma once
// Why a pixel has its colour, as a drawing: where it is, what covers its centre, and the light that it shows.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "core/surface.hpp"
#include "figure/sheet.hpp"

namespace gradus::plot {

/// A triangle over the pixel's centre.
struct Cover {
  std::string name;
  std::array<dvec2, 3> corners;  ///< in the picture: (0, 0) is its upper left corner
  double depth = 0;              ///< the least is seen
  std::string depth_text;
  bool seen = false;
};

/// What a share of light is multiplied with, of one place or from the least to the most of several.
struct Factor {
  std::string name;  ///< "N·L"
  double least = 0, most = 0;
};

/// A part of the light.
struct LightShare {
  std::string name;  ///< "diffuse"
  LinearRgb light;
  std::optional<Factor> factor{};
};

/// Where light comes from, and the shares it has.
struct LightSource {
  std::string name;  ///< "light 1 (directional)"; none stands above its share alone
  std::vector<LightShare> shares;
  std::optional<Factor> factor{};  ///< of all of them
};

/// The story of a pixel, as plain values.
struct PixelFigure {
  std::string title, subtitle, sentence;
  Image picture;
  ivec2 pixel{0};
  std::vector<Cover> covers;
  std::string depth_name;            ///< heads them: "depth"
  std::string empty;                 ///< stands in place of covers where there are none
  std::string light_name;            ///< heads the light
  std::vector<LightSource> sources;  ///< their shares add up to the light
  Rgba8 colour;                      ///< and that to the colour
  std::string colour_text;
  std::vector<std::string> colour_notes{};  ///< below it, a line each, two at most
};

/// The figure laid out; texts no smaller than 1/36 of the height. Of many triangles the nearest have their
/// names, of many sources the strongest; the others are counted.
/// Domain: the pixel lies in the picture (ContractViolation otherwise).
Sheet sheet_of(const PixelFigure& figure, double width = 1280, double height = 720);

}  // namespace gradus::plot
