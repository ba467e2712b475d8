#pragma once
// The way of the followed triangle and of the followed pixel through the chain, number by number: what the
// run's own events hold, and what its stages computed them from.

#include <array>
#include <optional>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "shading/illumination/illumination.hpp"
#include "stories/pipeline/textbook_chain/run.hpp"

namespace gradus::textbook_chain {

/// What the followed pixel shows of the followed triangle, in the spaces before the picture.
struct PixelPlace {
  dvec3 shares;  ///< of the triangle's three corners, which add up to 1
  dvec3 object, world, view;
  glm::dvec4 clip;
  dvec3 divided;
};

/// The edge functions of a pixel, in whole pixels: the doubled areas between its centre and the edges.
struct EdgeValues {
  int triangle = 0;  ///< place in Run::snapped
  dvec3 values{0};   ///< edge i lies opposite corner i
  double doubled_area = 0;
  dvec3 weights{0};  ///< values over the doubled area: shares of the corners in the picture
  dvec3 corner_depths{0};
};

/// An edge that stage 5 has cut.
using EdgeCut = sutherland_hodgman::Cut<double>;

/// One lamp's light at the place that is seen at the followed pixel.
using LampLight = illumination::LightAdded<double>;

struct Way {
  std::optional<pipeline::Fragment> fragment;  ///< of the followed triangle at the followed pixel
  std::optional<PixelPlace> place;             ///< with it
  std::optional<EdgeValues> edges;             ///< with it
  std::vector<EdgeCut> cuts;                   ///< of the followed triangle
  std::vector<pipeline::DepthTested> tests;    ///< at the followed pixel
  const pipeline::Shaded* shaded = nullptr;    ///< what is seen there
  std::vector<LampLight> lamps;                ///< that light it
  double shininess = 0;                        ///< of what is seen there
  const pipeline::Written* written = nullptr;  ///< the followed pixel
};

/// Accuracy: shares to some ulp of the triangle's determinant; what is no mean of corners is bit for bit what
/// the chain computed.
Way way_of(const Run& run, const Followed& followed);

/// The edge functions of a snapped triangle at the centre of a pixel, exactly.
EdgeValues edge_values(const Run& run, int triangle, ivec2 pixel);

/// The sRGB value in [0, 1] of linear light in [0, 1]: what stage 8 rounds to a byte.
/// Source: IEC 61966-2-1. Accuracy: 1e-15.
double srgb_of_linear(double light);

}  // namespace gradus::textbook_chain
