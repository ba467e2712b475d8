#pragma once
// On which side of an edge a centre lies, in whole numbers of 128 bits.

#include <cstdint>

#include "core/geometry.hpp"

namespace gradus::test {

__extension__ typedef __int128 int128_t;

inline int sign(int128_t x) { return (x > 0) - (x < 0); }

/// The side of the line from a to b on which the centre lies when it is moved to the right by something
/// infinitely small, and down by something infinitely smaller: never 0 unless a == b. The top-left rule says
/// the same without moving anything.
inline int side(ivec2 a, ivec2 b, ivec2 centre, std::int64_t& ties) {
  const int128_t x = centre.x, y = centre.y;
  const int128_t on =
      x * (int128_t{a.y} - b.y) + y * (int128_t{b.x} - a.x) + int128_t{a.x} * b.y - int128_t{a.y} * b.x;
  if (on != 0) return sign(on);
  ++ties;
  return a.y != b.y ? sign(int128_t{a.y} - b.y) : sign(int128_t{b.x} - a.x);
}

}  // namespace gradus::test
