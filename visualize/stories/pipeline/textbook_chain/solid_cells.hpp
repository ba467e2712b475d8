#pragma once
// A solid in the fine cells of the paper, in the colours of its materials: the nearest face at each cell.

#include <array>
#include <optional>
#include <vector>

#include "stories/paper.hpp"

namespace gradus::textbook_chain {

/// A convex part of a face, as the reader has it.
struct SolidPart {
  int face = 0;
  std::vector<dvec3> ring;  ///< to the right, up, towards the reader
  bool followed = false;
};

class SolidCells {
 public:
  /// frame: of the paper; what lies beyond it is cut off.
  SolidCells(const Panel& panel, const Extent& frame);

  /// colour: of its light.
  void add(const std::vector<dvec3>& ring, dvec3 colour);
  /// The cells whose middle is covered.
  void put(View& view) const;

 private:
  struct Nearest {
    double towards;  ///< of the face
    Rgba8 tone;
  };

  void add_triangle(const std::array<dvec3, 3>& corners, dvec3 colour);

  const Panel& panel_;
  ivec2 lower_, size_;  ///< cells
  std::vector<std::optional<Nearest>> nearest_;
};

}  // namespace gradus::textbook_chain
