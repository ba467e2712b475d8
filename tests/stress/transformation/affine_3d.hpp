#pragma once
// Rotations about any axis in numbers of many digits: what the promises and the benchmark of affine_3d judge
// by.

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace gradus::stress {

/// cos I + (1 - cos) n n^T + sin [n]x, column by column.
template <class Number>
std::array<Number, 9> rotation_about(const glm::dvec3& axis, double radians) {
  const Number x = axis.x, y = axis.y, z = axis.z, length = sqrt(Number(x * x + y * y + z * z));
  const Number n[] = {x / length, y / length, z / length};
  const Number s = sin(Number(radians)), c = cos(Number(radians));
  const Number across[3][3] = {{0, n[2], -n[1]}, {-n[2], 0, n[0]}, {n[1], -n[0], 0}};
  std::array<Number, 9> m;
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      m[3 * column + row] =
          (row == column ? c : Number(0)) + (1 - c) * n[row] * n[column] + s * across[column][row];
    }
  }
  return m;
}

}  // namespace gradus::stress
