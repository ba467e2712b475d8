// The middle row of a triangle whose corners have colours of their own.
#include <array>
#include <cstdio>
#include <shading/polygon_shading/polygon_shading.hpp>

int main() {
  using namespace gradus::polygon_shading;
  const std::array<Corner<double, double>, 3> triangle{{{{0, 0}, 0}, {{4, 0}, 1}, {{0, 4}, 0.5}}};
  const gradus::Window picture{{0, 1}, {3, 1}};
  gouraud<double, double>(triangle, picture,
                          [](glm::ivec2 p, double colour) { std::printf("%d:%.4f ", p.x, colour); });
  std::printf("\n");
}
// prints: 0:0.3125 1:0.5625
