// Two triangles that pierce each other, from back to front.
#include <cstdio>
#include <vector>
#include <visibility/bsp_tree/bsp_tree.hpp>

int main() {
  using namespace gradus::bsp_tree;
  const std::vector<Polygon<double>> two{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, 0},
                                         {{{1, 1, -1}, {1, 1, 1}, {3, 3, 1}}, 1}};
  const Eye<double> eye{1, 2, 30, 1};
  back_to_front(build(two), eye,
                [](const Polygon<double>& part) { std::printf("%zu:%zu ", part.face, part.corners.size()); });
  std::printf("\n");
}
// prints: 1:3 0:3 1:4
