// The share of a pixel that lies left of x = 0.4, from one sample and from eight by eight.
#include <antialiasing/supersampling/supersampling.hpp>
#include <cstdio>

int main() {
  using namespace gradus::supersampling;
  const auto shape = [](glm::dvec2 place) { return place.x < 0.4 ? 1.0 : 0.0; };
  for (const int n : {1, 8}) {
    supersample({{0, 0}, {0, 0}}, n, Filter::box, shape,
                [](glm::ivec2, double share) { std::printf("%.3f ", share); });
  }
}
// prints: 0.000 0.375
