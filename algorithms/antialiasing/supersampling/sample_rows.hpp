#pragma once
// The samples that supersampling keeps: rows of cells, so many that each place of a scene is asked once,
// however many pixels take its sample. The values are those of asking at each pixel anew.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <iterator>
#include <ranges>
#include <type_traits>
#include <vector>

#include "core/geometry.hpp"

namespace gradus::supersampling {

/// The most samples per pixel, along each axis.
inline constexpr int most = 64;
/// How far a pixel may lie from 0, in pixels.
inline constexpr int farthest = 1 << 20;

/// What the scene answers.
template <class Scene>
using ValueOf = std::remove_cvref_t<std::invoke_result_t<const Scene&, dvec2>>;

/// Where the scene is asked for a cell: its middle, (2 cell + 1) / (2 n). For n = 1, 2, 4 … 64 a multiple of
/// 1/128 pixel.
/// Accuracy: rounded once.
constexpr dvec2 place_of(ivec2 cell, int n) {
  return {static_cast<double>(2 * std::int64_t{cell.x} + 1) / (2 * n),
          static_cast<double>(2 * std::int64_t{cell.y} + 1) / (2 * n)};
}

/// What a run took.
struct Taken {
  std::int64_t asked = 0;  ///< samples of the scene
  std::int64_t kept = 0;   ///< values that were kept at once, at most
};

/// Samples of the scene in rows of cells. When all rows that are kept are taken, one that comes takes the
/// place of the one that came first.
template <class Value>
class Samples {
 public:
  Samples(const Window& cells, int n, std::int64_t kept_rows)
      : cells_(cells),
        n_(n),
        columns_(static_cast<std::size_t>(cells.width())),
        rows_(static_cast<std::size_t>(kept_rows)),
        values_(columns_ * rows_, Value(0)) {}
  /// With room for all rows.
  Samples(const Window& cells, int n) : Samples(cells, n, cells.height()) {}

  auto rows() const { return std::views::iota(cells_.lower.y, cells_.upper.y + 1); }
  /// Asks the scene for a row.
  template <class Scene>
  void ask(int row, const Scene& scene) {
    const std::size_t from = begin(row);
    for (std::size_t i = 0; i < columns_; ++i) {
      values_[from + i] = scene(place_of({cells_.lower.x + static_cast<int>(i), row}, n_));
    }
    asked_ += static_cast<std::int64_t>(columns_);
  }
  const Value& at(ivec2 cell) const {
    return values_[begin(cell.y) + static_cast<std::size_t>(cell.x - cells_.lower.x)];
  }
  std::vector<Value> row(int row) const {
    const auto from = values_.begin() + static_cast<std::ptrdiff_t>(begin(row));
    return {from, from + static_cast<std::ptrdiff_t>(columns_)};
  }
  Taken taken() const { return {asked_, std::ssize(values_)}; }

 private:
  static constexpr std::int64_t offset = std::int64_t{farthest} * most * 2;  // no row is below -offset

  std::size_t begin(int row) const { return static_cast<std::size_t>(row + offset) % rows_ * columns_; }

  Window cells_;
  int n_;
  std::size_t columns_, rows_;
  std::vector<Value> values_;
  std::int64_t asked_ = 0;
};

/// The rows of samples that one row of pixels needs, moving down the scene. Kernel: says how many cells a
/// pixel has (n), how far it reaches beyond it, and which cells a window's pixels need (round).
template <class Scene>
class Band {
 public:
  using Value = ValueOf<Scene>;

  template <class Kernel>
  Band(const Window& window, const Kernel& kernel, const Scene& scene)
      : scene_(scene),
        samples_(kernel.round(window), kernel.n, kernel.n + 2 * kernel.reach),
        next_(kernel.round(window).lower.y),
        n_(kernel.n),
        reach_(kernel.reach) {}

  /// Asks the scene for the rows of a pixel that are not there.
  void ask_for(ivec2 pixel) {
    for (const int end = (pixel.y + 1) * n_ + reach_; next_ < end; ++next_) samples_.ask(next_, scene_);
  }
  const Value& at(ivec2 cell) const { return samples_.at(cell); }
  Taken taken() const { return samples_.taken(); }

 private:
  const Scene& scene_;
  Samples<Value> samples_;
  int next_, n_, reach_;
};

}  // namespace gradus::supersampling
