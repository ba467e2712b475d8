#pragma once
// A mistake that is often made, to be run beside the right method.

#include "scan_conversion/antialiased_line/antialiased_line.hpp"

namespace gradus::antialiased_line {

/// FAULTY: looks the cone up at the distance along the column, which is at hand, rather than at right angles
/// to the axis. A line of slope m comes out thinner by sqrt(1 + m^2): a diagonal has 0.71 of its ink.
/// from, to, plot, Domain, Steps, Cost, Errors: as gupta_sproull.
/// Accuracy: right for level and upright lines only; up to 0.2 off near a diagonal.
template <class Plot, Observer<Started, Measured, Finished> O = Unobserved>
void distance_along_column(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  expects(has_room(from, to), "the line comes nearer than {} pixels to the end of int32", margin);
  const auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  const ivec2 aside = side_of(go);
  const ConeTable& cone = cone_table();
  const Whole span = dx == 0 ? 1 : dx;
  // FAULTY: dx in place of the length
  const double unit = 1 / double(span);
  if constexpr (observed<O>) observer(Started{from, to, dx, dy, go});
  ivec2 nearest = from;
  Whole height = 0;
  for (Whole k = 0; k <= dx; ++k) {
    for (int row = -2; row <= 2; ++row) {
      const Whole apart = height - row * span;
      const double d = unit * double(apart);
      const int part = cone.at(std::abs(d));
      auto pixel = nearest + row * aside;
      if constexpr (observed<O>) observer(Measured{k, row, nearest, pixel, d, part});
      if (part > none) plot(pixel, part);
    }
    nearest += go.straight;
    height += dy;
    const Whole past = 2 * height - dx;
    if (past > 0 || (past == 0 && !go.tie)) {
      nearest += aside;
      height -= dx;
    }
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

}  // namespace gradus::antialiased_line
