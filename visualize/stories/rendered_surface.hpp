#pragma once
// A surface of too many faces for a drawing of lines: a picture of it, lit as drawings of space are, to stand
// in a figure.

#include <array>
#include <memory>
#include <span>

#include "core/faces.hpp"
#include "core/image.hpp"
#include "stories/space_drawing.hpp"

namespace gradus {

/// How a surface is looked at: by a reader far away, who sees this rectangle of the plane across his way.
struct SurfaceLook {
  dvec3 right, up, towards;  ///< of length 1, across each other
  Extent shown;              ///< by right and up
  int width = 320;           ///< of the picture in pixels; its height follows from what is shown
  bool faceted = false;      ///< faces are flat, with lines between them; else the surface is smooth
};

/// The nearest face in each pixel, in light from the upper left in front; where there is none the picture is
/// transparent. Faces that look away are drawn as their other side, darker.
/// points, faces: of the surface; a face is taken as triangles from its first corner.
/// Cost: 10 ms for 10,000 small faces.
std::shared_ptr<const Image> rendered_surface(std::span<const dvec3> points, const Faces& faces,
                                              const SurfaceLook& look);

}  // namespace gradus
