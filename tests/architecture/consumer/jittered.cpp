// The part of a pixel below its diagonal, by sixteen jittered samples.
#include <antialiasing/jittered/jittered.hpp>
#include <array>
#include <cstdio>

int main() {
  using namespace gradus::jittered;
  std::array<glm::dvec2, 16> samples;
  jittered(samples, numbers_of(1, {3, 2}));
  const auto below = [](glm::dvec2 p) { return p.y - 2 > p.x - 3 ? 1.0 : 0.0; };
  std::printf("%g\n", sample_pixel({3, 2}, samples, below));
}
// prints: 0.4375
