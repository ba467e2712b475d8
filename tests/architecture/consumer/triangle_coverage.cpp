// The pixels whose centres a triangle covers.
#include <cstdio>
#include <scan_conversion/triangle_coverage/triangle_coverage.hpp>

int main() {
  using namespace gradus::triangle_coverage;
  const Triangle triangle{snap({1, 3}), snap({4, 1}), snap({2, 5})};
  cover(triangle, {{0, 0}, {7, 7}}, [](glm::ivec2 p, const Weights&) { std::printf("(%d,%d)", p.x, p.y); });
  std::printf("\n");
}
// prints: (3,1)(2,2)(1,3)(2,3)
