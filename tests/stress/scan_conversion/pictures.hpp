#pragma once
// Pictures for fills. One is a few numbers: its size, a pattern, how much of the pattern is kept, and the
// number of the noise. Whether a cell is free depends on these and on its place alone, so that a smaller
// picture is a corner of the larger one.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "core/random.hpp"
#include "stress/domain.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {

/// What a picture is made of where nothing is left to chance.
enum Pattern { full, checkerboard, upright_comb, level_comb, rings, spiral, perfect_maze, patterns };

/// What is drawn, wherever it is looked at.
struct Picture {
  int pattern = full;
  double kept = 1;  ///< the share of cells that are as the pattern says
  std::uint64_t noise = 0;

  bool free(ivec2 p) const {
    const auto bits = static_cast<std::uint64_t>(p.y) << 32 ^ static_cast<std::uint32_t>(p.x);
    return of_pattern(p) == (kept == 1 || Random(noise).unit_at(bits) < kept);
  }

 private:
  bool of_pattern(ivec2 p) const {
    // The lowest bit, of negative numbers too
    const int x = p.x & 1, y = p.y & 1;
    const ivec2 tile{p.x % 32 - 16, p.y % 32 - 16};
    switch (pattern) {
      case checkerboard:
        return x == y;
      case upright_comb:
        return x == 0 || p.y % 16 == 0;
      case level_comb:
        return y == 0 || p.x % 64 == 0;
      case rings:
        return (std::max(std::abs(tile.x), std::abs(tile.y)) & 1) == 0;
      case spiral: {
        // Half rings round a cell, and below it half rings round its neighbour: each leads on to the next
        const int below = tile.y > 0;
        return (std::max(std::abs(tile.x - below), std::abs(tile.y)) & 1) == below;
      }
      case perfect_maze: {
        // From each room a door to the right or down
        if (x == y) return x == 1;
        const ivec2 room = p - (x == 0 ? ivec2(1, 0) : ivec2(0, 1));
        const auto bits = static_cast<std::uint64_t>(room.y) << 32 ^ static_cast<std::uint32_t>(room.x);
        return (Random(noise, 1).unit_at(bits) < 0.5) == (x == 0);
      }
      default:
        return true;
    }
  }
};

/// The three numbers from `first` on, if they are a picture's.
inline std::optional<Picture> picture_of(const Input& i, std::size_t first) {
  if (!is_whole(i[first], 0, patterns - 1) || !(0 <= i[first + 1] && i[first + 1] <= 1) ||
      !is_whole(i[first + 2], 0, 1e9)) {
    return std::nullopt;
  }
  return Picture{static_cast<int>(i[first]), i[first + 1], static_cast<std::uint64_t>(i[first + 2])};
}
inline void add_picture(Input& input, Kind kind, Random& random) {
  input.push_back(kind == Kind::random ? 0 : whole(random, 0, patterns - 1));
  const double all = kind == Kind::ties || random.unit() < 0.2 ? 1 : random.unit();
  input.push_back(kind == Kind::near_degenerate ? 1 - 0.02 * random.unit() : all);
  input.push_back(whole(random, 0, 1'000'000));
}

}  // namespace gradus::stress
