#pragma once
// A model drawn by its edges, with the hidden parts told from the visible ones.

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh.hpp"

namespace gradus {

/// Where a viewer is, seen from a point: along `direction`, and not farther than `far` times it.
struct Sight {
  dvec3 direction;
  double far;
};
using SightFrom = std::function<Sight(dvec3 point)>;

/// All sight lines are parallel: a drawing of parallel projection.
SightFrom parallel_sight(dvec3 towards_viewer);
/// All sight lines end in one eye.
SightFrom central_sight(dvec3 eye);

/// A part of a segment, from the fraction `from` to the fraction `to` of its length.
struct SightPiece {
  double from, to;
  bool hidden;
};

/// What of a mesh a line drawing needs. Holds a reference: the mesh must outlive it.
class Wireframe {
 public:
  explicit Wireframe(const Mesh& mesh);

  /// Each edge once, by its two ends.
  const std::vector<std::pair<dvec3, dvec3>>& edges() const { return edges_; }
  /// Whether some face lies between the point and the viewer.
  bool hides(dvec3 point, const Sight& sight) const;
  /// The segment from a to b, cut where it goes behind a face or comes out: exactly of a convex solid; of
  /// other meshes parts shorter than 1/64 of it may be missed.
  std::vector<SightPiece> pieces(dvec3 a, dvec3 b, const SightFrom& sight) const;

 private:
  std::vector<SightPiece> pieces_of_convex(dvec3 a, dvec3 b, const SightFrom& sight) const;

  const Mesh& mesh_;
  std::vector<std::pair<dvec3, dvec3>> edges_;
  double size_;  ///< of the model: what is nearer than a millionth of it is the point's own face
  bool convex_;
};

}  // namespace gradus
