// The exact area of a triangle in each pixel, as bytes.
#include <antialiasing/area_sampling/area_sampling.hpp>
#include <cstdio>
#include <vector>

int main() {
  using namespace gradus::area_sampling;
  using gradus::triangle_coverage::snap;
  const std::vector<glm::ivec2> corners{snap({1, 3}), snap({4, 1}), snap({2, 5})};
  const auto print = [](glm::ivec2 p, int byte) { std::printf("(%d,%d)%d ", p.x, p.y, byte); };
  pixel_bytes(corners, {{0, 0}, {7, 7}}, print);
  std::printf("\n");
}
// prints: (2,1)21 (3,1)106 (1,2)85 (2,2)234 (3,2)64 (1,3)191 (2,3)191 (1,4)64 (2,4)64
