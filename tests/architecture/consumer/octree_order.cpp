// The eight children of a cube, the nearest first.
#include <cstdio>
#include <visibility/octree_order/octree_order.hpp>

int main() {
  using namespace gradus::octree_order;
  const auto once = [](const Cell<double>& cell) { return cell.depth < 1; };
  front_to_back(Cell<double>{{0, 0, 0}, 2}, Eye<double>{9, 0.5, 8, 1}, once, [](const Cell<double>& cell) {
    std::printf("%g%g%g ", cell.lower.x, cell.lower.y, cell.lower.z);
  });
  std::printf("\n");
}
// prints: 101 001 111 100 011 000 110 010
