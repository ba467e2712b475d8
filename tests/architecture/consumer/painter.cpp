// Two triangles that pierce each other, cut and from back to front.
#include <cstdio>
#include <vector>
#include <visibility/painter/painter.hpp>

int main() {
  using namespace gradus::painter;
  const std::vector<Polygon<double>> two{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, 0},
                                         {{{1, 1, -1}, {1, 1, 1}, {3, 3, 1}}, 1}};
  const auto view = distant_view<double>({1, 2, 30}, {0, 1, 0});
  newell(two, view,
         [](const Polygon<double>& part) { std::printf("%zu:%zu ", part.face, part.corners.size()); });
  std::printf("\n");
}
// prints: 0:3 1:3 0:3
