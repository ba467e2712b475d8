#pragma once
// What a surface looks like: plain data that illumination, shading, ray tracing and the loaders share. What
// lights it is in core/light.hpp. Colours are linear RGB; sRGB is the business of image files
// (core/colour.hpp).

#include <string>

#include "core/image.hpp"
#include "core/light.hpp"

namespace gradus {

/// A picture that is laid on a surface. Texture coordinates (0, 0) to (1, 1) cover it, v up.
struct Texture {
  std::string file;      ///< as the material names it
  Image texels{};        ///< row 0 at the top; empty until the file is read
  std::string place{};   ///< where it is named, as mistakes call it: "spot.mtl:3: map_Kd 'spot.png'"
  bool quotable = true;  ///< whether messages may show what stands there
};

/// How much of the light that arrives a surface sends on, in Phong's model. This one is what a face without
/// a material of its own has: a light grey without a highlight.
struct Material {
  std::string name = "default";
  LinearRgb ambient{0.7f};   ///< k_a: the share of the ambient light, >= 0
  LinearRgb diffuse{0.7f};   ///< k_d: the share that is scattered evenly, >= 0
  LinearRgb specular{0.0f};  ///< k_s: the share in the highlight, >= 0
  float shininess = 32;      ///< n: the exponent of the highlight, >= 0; larger is smaller and sharper
  LinearRgb emission{0.0f};  ///< light of its own, >= 0
  float opacity = 1;         ///< 1 covers all behind it, 0 nothing
  Texture diffuse_map{};     ///< multiplies ambient and diffuse part where its file was read
};

}  // namespace gradus
