// Near red covers the left half of a pixel, far blue all of it: the weights of both.
#include <antialiasing/a_buffer/a_buffer.hpp>
#include <cstdio>

int main() {
  using namespace gradus::a_buffer;
  const std::array<gradus::ivec2, 4> left{{{0, 0}, {128, 0}, {128, 256}, {0, 256}}};
  std::vector<Fragment> list{{full, 2, 2, 1, 1, 1}, {mask_of(left, gradus::ivec2(0)), 1, 1, 1, 0, 0}};
  resolve(list,
          [](const Fragment& f, double weight) { std::printf("%d %08x %.3f ", f.source, f.mask, weight); });
}
// prints: 0 f0f0f0f0 0.500 1 ffffffff 0.500
