// What the middle of an edge that recedes from w = 1 to w = 3 shows, and a texel of the caller's.
#include <cstdio>
#include <shading/texture_mapping/texture_mapping.hpp>

int main() {
  using namespace gradus::texture_mapping;
  const Triangle triangle{{{0, 0}, {1280, 0}, {0, 1280}}};  // in 1/256 pixel
  const Corners<double> corners{{{1, {0, 0}}, {1.0 / 3, {1, 0}}, {1, {0, 1}}}};
  perspective_correct(triangle, corners, {{2, 0}, {2, 0}}, [](glm::ivec2, Uv<double> uv, const auto&) {
    const Extent chequered{{8, 8}};
    const int colour = nearest(uv, chequered, [](glm::ivec2 t) { return (t.x + t.y) % 2; });
    std::printf("%.3f %d\n", uv.x, colour);
  });
}
// prints: 0.250 0
