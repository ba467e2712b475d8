#pragma once
// A surface of too many faces for a drawing of lines: a picture of it, lit as drawings of space are, to stand
// in a figure.

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "core/faces.hpp"
#include "core/image.hpp"
#include "stories/space_drawing.hpp"

namespace gradus {

/// How a surface is looked at: by a reader far away, who sees this rectangle of the plane across his way.
struct SurfaceLook {
  dvec3 right, up, towards;          ///< of length 1, across each other
  Extent shown;                      ///< by right and up
  int width = 320;                   ///< of the picture in pixels; its height follows from what is shown
  bool faceted = false;              ///< faces are flat, with lines between them; else the surface is smooth
  std::span<const dvec3> normals{};  ///< of the points, where they are known; else means of their faces'
  /// Not 0: dark bands of equal angle between the normals and this direction, as the reader has it; the
  /// longer it is, the narrower they are. Where the surface has a crease they break, where its curvature
  /// jumps they have a corner.
  dvec3 bands{0};
  /// Of faces in rows of `columns`, as a grid has them: lines every so many faces, along rows and across; 0:
  /// none.
  int columns = 0, every = 0;
  std::span<const std::int32_t> marked{};  ///< faces that stand out, ascending: lighter than the others
};

/// The nearest face in each pixel, in light from the upper left in front; where there is none the picture is
/// transparent. Faces that look away are drawn as their other side, darker.
/// points, faces: of the surface; a face is taken as triangles from its first corner.
/// Cost: 10 ms for 10,000 small faces.
std::shared_ptr<const Image> rendered_surface(std::span<const dvec3> points, const Faces& faces,
                                              const SurfaceLook& look);

}  // namespace gradus
