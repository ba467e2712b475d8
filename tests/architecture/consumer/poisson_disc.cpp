// Places in a tile that keep their distance: how many, and the least distance of any two.
#include <antialiasing/poisson_disc/poisson_disc.hpp>
#include <cstdio>

int main() {
  using namespace gradus::poisson_disc;
  const Area tile{{1, 1}, true};
  std::vector<gradus::dvec2> samples;
  bridson(tile, 0.1, 30, gradus::Random(1), [&](gradus::dvec2 p) { samples.push_back(p); });
  std::printf("%zu %d\n", samples.size(), least_distance(tile, samples) >= 0.1);
}
// prints: 63 1
