// A triangle's shares of four pixels, with 16 samples where an edge crosses.
#include <antialiasing/adaptive/adaptive.hpp>
#include <cstdio>
#include <vector>

int main() {
  using namespace gradus::adaptive;
  const std::vector<ScreenTriangle> scene{{{glm::ivec2{128, 0}, {1024, 0}, {128, 1024}}, {1, 1, 1}}};
  const auto white = [](int, glm::ivec2, const Weights&) { return 1.0; };
  const auto print = [](glm::ivec2 p, double, double share) { std::printf("%d:%.4f ", p.x, share); };
  adaptive(scene, {{0, 1}, {3, 1}}, n_rooks(16), white, print);
  std::printf("\n");
}
// prints: 0:0.5000 1:1.0000 2:0.6875
