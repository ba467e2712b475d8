// Draws a line by two pixels per column and adds up the areas of the same line as a rectangle.
#include <cstdio>
#include <scan_conversion/antialiased_line/antialiased_line.hpp>

int main() {
  namespace line = gradus::antialiased_line;
  line::wu({0, 0}, {3, 1},
           [](glm::ivec2 p, int intensity) { std::printf("(%d,%d)%d ", p.x, p.y, intensity); });
  double sum = 0;
  line::exact_area({0, 0}, {4, 3}, [&](glm::ivec2, double area) { sum += area; });
  std::printf("%.9f\n", sum);
}
// prints: (0,0)255 (3,1)255 (1,0)170 (1,1)85 (2,1)170 (2,0)85 5.000000000
