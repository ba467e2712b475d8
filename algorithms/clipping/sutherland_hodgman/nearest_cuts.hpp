#pragma once
// cut_coordinate for many edges: by loops without branches, of which a compiler makes two or four edges'
// arithmetic at a time, and which tell where they are not certain of the nearest number.

#include <array>
#include <cmath>
#include <cstddef>

#include "core/arithmetic/exact.hpp"
#include "core/axis_cut.hpp"

namespace gradus::sutherland_hodgman::detail {

/// Where some edges are cut: their ends along the axis of the border and along the other one, and the border.
template <class T>
struct Cuts {
  static constexpr std::size_t most = 32;
  std::array<T, most> a_axis, b_axis, a_other, b_other, c;

  T exact(std::size_t i) const { return cut_coordinate(a_axis[i], b_axis[i], a_other[i], b_other[i], c[i]); }
};

/// Cuts::exact for floats, from one division of doubles each. Doubles hold whatever these operations make of
/// floats: each rounds by at most u = 2^-53 of its result, so that the exact point lies within
/// 8u (|a_other| + |quotient|) of the sum. If both ends of that round to one float, so does the point.
///
/// doubts: 0 where that is certain.
inline void find_quickly(const Cuts<float>& cuts, std::size_t count, float* found, float* doubts) {
  for (std::size_t i = 0; i < count; ++i) {
    const double start = cuts.a_other[i], from = cuts.a_axis[i];
    const double quotient = (cuts.b_other[i] - start) * (cuts.c[i] - from) / (cuts.b_axis[i] - from);
    const double sum = start + quotient, bound = 0x1p-50 * (std::abs(start) + std::abs(quotient));
    const float low = static_cast<float>(sum - bound), high = static_cast<float>(sum + bound);
    found[i] = low + 0.0f;
    doubts[i] = high - low;
  }
}

/// The same for doubles, by what cut_coordinate_filtered does, without its branches.
inline void find_quickly(const Cuts<double>& cuts, std::size_t count, double* found, double* doubts) {
  for (std::size_t i = 0; i < count; ++i) {
    const double start = cuts.a_other[i];
    const Rounded way = two_difference(cuts.c[i], cuts.a_axis[i]);
    const Rounded rise = two_difference(cuts.b_other[i], start);
    const Rounded length = two_difference(cuts.b_axis[i], cuts.a_axis[i]);
    const double quotient = way.value * rise.value / length.value;
    const Rounded above = two_product(way.value, rise.value), below = two_product(quotient, length.value);
    const double left_over = ((above.value - below.value) + (above.error - below.error)) +
                             ((way.value * rise.error + way.error * rise.value) - quotient * length.error);
    const Rounded sum = two_sum(start, quotient);
    const double rest = sum.error + left_over / length.value;
    // Along the border nothing rounds
    const double x = std::abs(way.value), y = std::abs(rise.value), z = std::abs(length.value);
    const double least = y == 0 ? 0.0 : 0x1p-1060;
    const double bound = 0x1p-95 * std::abs(quotient) + 0x1p-100 * std::abs(sum.value) + least;
    const double highest = sum.value + (rest + bound), lowest = sum.value + (rest - bound);
    found[i] = highest + 0.0;
    // Where a number is too large or too small, that is no bound
    const bool fits = (0x1p-400 <= x) & (x <= 0x1p400) & ((0x1p-400 <= y) | (y == 0)) & (y <= 0x1p400) &
                      (0x1p-400 <= z) & (z <= 0x1p400);
    doubts[i] = (highest - lowest) + (fits ? 0.0 : 1.0);
  }
}

}  // namespace gradus::sutherland_hodgman::detail
