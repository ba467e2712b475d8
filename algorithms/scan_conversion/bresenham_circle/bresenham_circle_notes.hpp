#pragma once
// Exhibits: the listing of lecture notes that leaves the circle, kept as printed so that a figure can show
// where, and its way of plotting alone. Never use them to draw; bresenham_circle.hpp has the right one.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

namespace gradus::bresenham_circle {

/// All eight mirror images of (x, y), as the notes plot them: pixels on an axis and on a diagonal come twice,
/// and those of a place past the diagonal once more (errata E001-06).
template <class Plot>
constexpr void plot_eight(ivec2 center, Whole x, Whole y, Plot& plot) {
  for (const Octant& octant : octants) plot(pixel_of(center, octant, x, y));
}

/// FAULTY: moves x and y first and then updates p with the new values, for which 4 x + 2 and
/// 4 (x - y) + 2 would be right. p grows by 4 too much at E and by 8 at SE, so the octant turns inwards too
/// soon. The notes' listing (errata E001-05), and its way of plotting (E001-06).
///
/// center, radius: as for decision_parameter (the arithmetic is widened; the printed int
///   overflows from radius 536894085 on).
///
/// Domain: as decision_parameter. Radius 0 to 3 come out right, 4 is the first that does not.
/// Steps: Started (Compared Stepped)* Finished; Finished.pixels counts calls of plot.
/// Accuracy: no useful bound: 0.757 pixels off at radius 5, and 1.351 at radius 1429, the worst up to 2000.
/// Cost: as decision_parameter, with up to 12 pixels plotted twice.
/// Errors: ContractViolation outside the domain.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void late_update(ivec2 center, int radius, Plot&& plot, O&& observer = {}) {
  expects(radius >= 0, "a circle has a radius of 0 or more, not {}", radius);
  expects(fits_plane(center, radius), "the circle round ({}, {}) with radius {} leaves int32", center.x,
          center.y, radius);
  Whole x = 0, y = radius;
  Whole p = 3 - 2 * y;
  if constexpr (observed<O>) observer(Started{center, radius, p});
  plot_eight(center, x, y, plot);
  while (x < y) {
    ++x;
    if (p < 0) {
      if constexpr (observed<O>) observer(Compared{place(x - 1, y), p, true});
      p += 4 * x + 6;  // E
      if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * x - 6, p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{place(x - 1, y), p, false});
      --y;
      p += 4 * (x - y) + 10;  // SE
      if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * (x - y) - 10, p, false});
    }
    plot_eight(center, x, y, plot);
  }
  if constexpr (observed<O>) observer(Finished{8 * (x + 1)});
}

/// FAULTY: the right places, plotted as the notes plot them (errata E001-06): eight pixels a place, while
/// x < y. Pixels on an axis and on the diagonal are set twice, and those of a place past the diagonal, which
/// every second radius or so walks to, are set again. Blending counts such a pixel twice, XOR erases it.
///
/// center, radius: as for decision_parameter.
///
/// Domain: as decision_parameter.
/// Steps: Started (Compared Stepped)* Finished; Finished.pixels counts calls of plot.
/// Accuracy: the pixels of decision_parameter; 64 plots for the 56 of radius 10, 8 for the one of radius 0.
/// Cost: as decision_parameter, with up to 12 pixels plotted twice, and 8 times the one of radius 0.
/// Errors: ContractViolation outside the domain.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void eight_plots(ivec2 center, int radius, Plot&& plot, O&& observer = {}) {
  expects(radius >= 0, "a circle has a radius of 0 or more, not {}", radius);
  expects(fits_plane(center, radius), "the circle round ({}, {}) with radius {} leaves int32", center.x,
          center.y, radius);
  Whole x = 0, y = radius;
  Whole p = 3 - 2 * y;
  if constexpr (observed<O>) observer(Started{center, radius, p});
  plot_eight(center, x, y, plot);
  while (x < y) {
    if (p < 0) {
      if constexpr (observed<O>) observer(Compared{place(x, y), p, true});
      p += 4 * x + 6;
      ++x;  // E
      if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * x - 2, p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{place(x, y), p, false});
      p += 4 * (x - y) + 10;
      ++x;
      --y;  // SE
      if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * (x - y) - 2, p, false});
    }
    // On axis and diagonal, too
    plot_eight(center, x, y, plot);
  }
  if constexpr (observed<O>) observer(Finished{8 * (x + 1)});
}

}  // namespace gradus::bresenham_circle
