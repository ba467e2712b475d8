// What a sine of 9 Hz looks like at 10 samples a second, and a wheel of eight spokes on film.
#include <antialiasing/sampling_theorem/sampling_theorem.hpp>
#include <array>
#include <cstdio>

int main() {
  using namespace gradus::sampling_theorem;
  const std::array<double, 4> samples{0, 1, 0, -1};
  const double between = reconstruct(std::span<const double>(samples), 0.5, Dirichlet{4});
  std::printf("%g Hz, %g rev/s, %.4f\n", alias_of(9.0, 10.0), apparent_speed(2.0, 24.0, 8), between);
}
// prints: -1 Hz, -1 rev/s, 0.7071
