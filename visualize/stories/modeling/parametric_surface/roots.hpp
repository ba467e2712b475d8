#pragma once
// Numbers as they are written on a blackboard: for angles of 30, 45 and 60 degrees and their like all
// coordinates are roots, or fractions, of the radius.

#include <cmath>

#include "stories/modeling/parametric_surface/drawing.hpp"

namespace gradus::parametric_surface {

/// Writes numbers of one run: as decimals, or where the reader wants fractions as exactly as they are.
class Roots {
 public:
  Roots(const Words& words, const Subject& subject)
      : exact_(words.wording().numbers() == Numbers::fractions && is_simple(subject.s) &&
               is_simple(subject.t)) {}

  /// A coordinate of a vector that is `size` times products of a sine or cosine of each angle: of those, 4
  /// times each is a root of a whole number.
  std::string text(double value, double size) const {
    const double quarters = 4 * value / size, square = std::round(quarters * quarters);
    constexpr double noise = 1e-9;
    if (!exact_ || square == 0 || std::abs(quarters * quarters - square) > noise) return figure_real(value);
    const auto [root, under] = simplest(static_cast<int>(square));
    if (under == 1) return figure_real(std::copysign(size * root / 4, value));
    return (value < 0 ? "−" : "") + times_root(size * root / 4, under, value);
  }
  std::string place(dvec3 p, double size) const {
    return figure_place(p, [&](double number) { return text(number, size); });
  }

 private:
  /// Quarter turns, and what is 30 or 45 degrees from them.
  static bool is_simple(double degrees) { return std::fmod(degrees, 30) == 0 || std::fmod(degrees, 45) == 0; }
  /// √12 is 2 √3.
  static std::pair<int, int> simplest(int square) {
    int root = 1;
    for (const int k : {2, 3}) {
      for (; square % (k * k) == 0; square /= k * k) root *= k;
    }
    return {root, square};
  }
  /// "√3/2", "3√2"; where the factor is no short fraction, the value.
  static std::string times_root(double factor, int under, double value) {
    for (const int below : {1, 2, 4, 8}) {
      const double above = factor * below;
      constexpr double most = 100;
      if (above != std::round(above) || above > most) continue;
      return fmt::format("{}√{}{}", above == 1 ? "" : fmt::format("{:g}", above), under,
                         below == 1 ? "" : fmt::format("/{}", below));
    }
    return figure_real(std::abs(value));
  }

  const bool exact_;
};

}  // namespace gradus::parametric_surface
