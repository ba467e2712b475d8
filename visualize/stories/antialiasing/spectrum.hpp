#pragma once
// Power spectra of patterns of samples: what of a scene's frequencies comes back as something else.

#include <cstddef>
#include <span>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "figure/tone_of.hpp"

namespace gradus {

/// The mean power of some sets of samples at so many cycles a pixel either way along both axes, row by row.
class Spectrum {
 public:
  explicit Spectrum(int reach) : reach_(reach), power_(static_cast<std::size_t>(side() * side())) {}

  int side() const { return 2 * reach_ + 1; }

  /// Adds what these have at each frequency: |sum of exp(-2 pi i f s)|^2.
  void add(std::span<const dvec2> samples) {
    std::vector<dvec2> sums(power_.size(), dvec2(0));  // real and imaginary parts
    const auto times = [](dvec2 a, dvec2 b) { return dvec2{a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; };
    const auto turn = [](double part) {
      const SinCos at = sin_cos(-2 * 3.14159265358979323846 * part);
      return dvec2{at.cos, at.sin};
    };
    for (const dvec2 s : samples) {
      const dvec2 right = turn(s.x), up = turn(s.y);
      dvec2 row = turn(-reach_ * (s.x + s.y));
      for (std::size_t i = 0; i < sums.size(); row = times(row, up)) {
        dvec2 at = row;
        for (int x = 0; x < side(); ++x, at = times(at, right)) sums[i++] += at;
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) power_[i] += sums[i].x * sums[i].x + sums[i].y * sums[i].y;
    samples_ += static_cast<double>(samples.size());
  }
  /// Half the light is what independent samples have; frequency 0, which is their number, is dark. y down.
  Rgba8 tone(ivec2 p) const {
    const std::size_t i = static_cast<std::size_t>((side() - 1 - p.y) * side() + p.x);
    const double value = i == power_.size() / 2 ? 0 : power_[i] / samples_;
    return tone_of(value / (1 + value));
  }

 private:
  int reach_;
  std::vector<double> power_;
  double samples_ = 0;
};

}  // namespace gradus
