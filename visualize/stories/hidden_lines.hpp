#pragma once
// Which parts of a line faces hide from a viewer.

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/geometry.hpp"

namespace gradus {

/// A viewer: an eye, w = 1; or at w = 0 the direction towards a reader who is infinitely far away.
using Viewer = glm::dvec4;

/// All sight lines are parallel: a drawing of parallel projection.
inline Viewer distant_viewer(dvec3 towards) { return {towards, 0}; }
/// All sight lines end in one eye.
inline Viewer viewer_at(dvec3 eye) { return {eye, 1}; }

/// From a point towards the viewer, of any length.
inline dvec3 towards(const Viewer& viewer, dvec3 point) { return dvec3(viewer) - viewer.w * point; }

/// A part of a segment, from the fraction `from` to the fraction `to` of its length.
struct SightPiece {
  double from, to;
  bool hidden;
};

/// A flat polygon in space with the length of its doubled area; Newell's method.
dvec3 area_vector(std::span<const dvec3> ring);

/// The convex parts of a flat polygon: itself, or triangles.
std::vector<std::vector<dvec3>> convex_parts(const std::vector<dvec3>& ring);

/// A flat polygon's triangles.
std::vector<std::vector<dvec3>> triangles_of(const std::vector<dvec3>& ring);

/// What faces hide. The shadow of a convex face, its viewer the lamp, lies behind its plane and within the
/// planes through its edges and the viewer; the part of a segment in it is an interval, found as Cyrus and
/// Beck clip. So there are no samples, and faces may be concave, open, touch and pierce each other.
class HiddenLines {
 public:
  /// faces: flat polygons. size: of all that is drawn; what is nearer than a billionth of it touches.
  HiddenLines(std::span<const std::vector<dvec3>> faces, const Viewer& viewer, double size);

  /// The segment from a to b, cut where it goes behind a face or comes out; pieces in order, the first from
  /// 0, the last to 1. One that lies in a face is in front of it. Pieces below a millionth are left out.
  std::vector<SightPiece> pieces(dvec3 a, dvec3 b) const;

 private:
  /// Points with a negative product lie on the shadow's side.
  struct HalfSpace {
    dvec3 normal, at;
  };
  using Shadow = std::vector<HalfSpace>;

  void add_shadow(const std::vector<dvec3>& part, const Viewer& viewer);

  std::vector<Shadow> shadows_;
  double margin_;
};

}  // namespace gradus
