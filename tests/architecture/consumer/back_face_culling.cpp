// Which sides of a corner of a cube an eye sees.
#include <cstdio>
#include <vector>
#include <visibility/back_face_culling/back_face_culling.hpp>

int main() {
  using namespace gradus::back_face_culling;
  const std::vector<glm::dvec3> right{{1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {1, 1, 1}},
      left{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}};
  const std::vector<Face<double>> faces{right, left};
  normal_and_view<double>(faces, {5, 0, 0, 1}, [](std::size_t face) { std::printf("%zu\n", face); });
}
// prints: 0
