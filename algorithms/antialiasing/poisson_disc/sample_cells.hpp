#pragma once
// The samples by cell in single precision, side by side: what poisson_disc_batch.cpp asks a register at a
// time.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "antialiasing/poisson_disc/poisson_disc.hpp"

namespace gradus::poisson_disc {

/// Each sample counted from its cell's corner, in radii. Round the cells there are others: of a tile with
/// the samples of its opposite side, of what doesn't wrap empty ones.
class SampleCells {
 public:
  /// What is tried beside a sample can be too near to samples up to three radii away. With as many cells
  /// as the fewest one is no narrower than 0.65 radii.
  static constexpr int reach = 5, fewest = 12;
  /// Numbers after a row that may be read with it.
  static constexpr std::size_t beyond = 64;

  SampleCells(const Area& area, double radius, ivec2 cells)
      : area_(area),
        radius_(radius),
        cells_(cells),
        cell_(area.size / dvec2(cells)),
        stride_(static_cast<std::size_t>(cells.x + 2 * reach) + beyond),
        x_(stride_ * static_cast<std::size_t>(cells.y + 2 * reach), nowhere),
        y_(x_) {}

  void put(dvec2 sample) {
    const ivec2 cell = cell_at(area_, cells_, sample);
    const dvec2 part = part_of(sample, cell);
    const int copies = area_.wraps ? 1 : 0;
    for (int y = -copies; y <= copies; ++y) {
      for (int x = -copies; x <= copies; ++x) {
        const ivec2 copy = cell + ivec2(x, y) * cells_;
        if (std::min(copy.x, copy.y) < -reach || copy.x >= cells_.x + reach || copy.y >= cells_.y + reach)
          continue;
        x_[index(copy)] = static_cast<float>(part.x);
        y_[index(copy)] = static_cast<float>(part.y);
      }
    }
  }

  /// The cells within the reach of a sample's, row by row from the lower left one on.
  struct Round {
    const float *x, *y;
    std::size_t stride;
    float right, up;  ///< the way from the sample to the first cell's corner, in radii
    glm::vec2 width;  ///< of a cell, in radii
  };
  Round round(dvec2 sample) const {
    const ivec2 cell = cell_at(area_, cells_, sample), first = cell - reach;
    const dvec2 width = cell_ / radius_, way = -double{reach} * width - part_of(sample, cell);
    return {x_.data() + index(first),  y_.data() + index(first),  stride_,
            static_cast<float>(way.x), static_cast<float>(way.y), glm::vec2(width)};
  }

 private:
  /// Where there is no sample: far from everything.
  static constexpr float nowhere = 1e18f;

  dvec2 part_of(dvec2 sample, ivec2 cell) const { return (sample - dvec2(cell) * cell_) / radius_; }
  std::size_t index(ivec2 cell) const {
    return static_cast<std::size_t>(cell.y + reach) * stride_ + static_cast<std::size_t>(cell.x + reach);
  }

  Area area_;
  double radius_;
  ivec2 cells_;
  dvec2 cell_;
  std::size_t stride_;
  std::vector<float> x_, y_;
};

/// The samples near one of them: the ways to them in radii, and room for a register more.
struct Neighbours {
  static constexpr std::size_t cells = 2 * SampleCells::reach + 1;
  alignas(64) std::array<float, cells*(cells + SampleCells::beyond) + SampleCells::beyond> x, y;
  std::size_t count = 0;
};

/// An area's borders from a sample, in radii, and a little farther away; infinite for a tile.
struct Borders {
  float left, bottom, right, top;
};

inline Borders borders_from(const Ring& ring, dvec2 sample) {
  constexpr float none = std::numeric_limits<float>::infinity();
  if (ring.area.wraps) return {-none, -none, none, none};
  const dvec2 low = -sample / ring.radius - 0x1p-10, high = (ring.area.size - sample) / ring.radius + 0x1p-10;
  return {static_cast<float>(low.x), static_cast<float>(low.y), static_cast<float>(high.x),
          static_cast<float>(high.y)};
}

/// Which of the next tries may become samples: a bit each, and one where nothing is too near for sure.
struct OpenTries {
  std::uint64_t bits, far;
  int count;

  /// Forgets those from a number on.
  void leave(int first) {
    if (first >= count) return;
    bits &= (std::uint64_t{1} << first) - 1;
    count = first;
  }
};

}  // namespace gradus::poisson_disc
