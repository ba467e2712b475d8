// A pixel whose left two fifths are white: half of its 4 x 4 places.
#include <antialiasing/accumulation_buffer/accumulation_buffer.hpp>
#include <cstdio>

int main() {
  using namespace gradus::accumulation_buffer;
  double sum = 0;
  const auto render = [](glm::dvec2 place, const auto& plot) { plot({0, 0}, place.x < 0.4 ? 1.0 : 0.0); };
  accumulate({4, 4}, render, Sums<double>({&sum, 1}, {1, 1}));
  std::printf("%.3f\n", sum);
}
// prints: 0.500
