// Draws a line and watches it with a lambda of its own.
#include <cstdio>
#include <scan_conversion/bresenham_line/bresenham_line.hpp>
#include <type_traits>

int main() {
  namespace line = gradus::bresenham_line;
  int diagonal = 0;
  line::decision_parameter(
      {0, 0}, {7, 3}, [](glm::ivec2 p) { std::printf("(%d,%d)", p.x, p.y); },
      [&](const auto& step) {
        if constexpr (std::is_same_v<decltype(step), const line::Stepped&>) diagonal += !step.straight;
      });
  std::printf(" %d\n", diagonal);
}
// prints: (0,0)(1,0)(2,1)(3,1)(4,2)(5,2)(6,3)(7,3) 3
