// Two squares in a picture of the caller's: the nearer one is seen, in whatever order they come.
#include <cstdio>
#include <vector>
#include <visibility/z_buffer/z_buffer.hpp>

int main() {
  using namespace gradus::z_buffer;
  const std::vector<glm::dvec3> near{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}},
      far{{1, 0, 5}, {4, 0, 5}, {4, 2, 5}, {1, 2, 5}};
  const std::vector<Face> faces{{near, {0, 0}}, {far, {0, 1}}};
  gradus::Raster<Cell<double, Id>> picture(4, 2);
  per_polygon<double>(faces, picture);
  for (int x = 0; x < 4; ++x) std::printf("%d", picture[{x, 1}].key.face);
  std::printf("\n");
}
// prints: 0011
