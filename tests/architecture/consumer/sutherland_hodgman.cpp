// Many polygons of floats at one window, by the batch.
#include <clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp>
#include <cstdio>
#include <vector>

int main() {
  using namespace gradus::sutherland_hodgman;
  Polygons<float> given, clipped;
  given.add(std::vector<glm::vec2>{{-5, 2}, {5, 2}, {5, 8}});
  given.add(std::vector<glm::vec2>{{-10, -10}, {30, -10}, {10, 40}});
  BatchClipper<float> clip;
  clip(given, {{0, 0}, {10, 10}}, clipped);
  for (const glm::vec2 p : clipped.points) std::printf("%g,%g ", p.x, p.y);
  std::printf("\n");
}
// prints: 0,5 0,2 5,2 5,8 0,10 0,0 10,0 10,10
