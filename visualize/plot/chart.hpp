#pragma once
// Charts for slides: points with their names between two logarithmic axes, and lines with their slopes.

#include <string>
#include <string_view>
#include <vector>

#include "figure/sheet.hpp"
#include "plot/series.hpp"

namespace gradus::plot {

/// A measured point, labelled where it has a name. A y of 0, which a logarithmic axis does not have, stands
/// on a row of its own below it.
struct Dot {
  std::string name;
  dvec2 at;
  Style style{};
  bool on_front = false;  ///< no other is better in both: ringed, and joined to the others on the front
};

/// Points of one name, joined; its name stands beside the last one. Without a name it may run anywhere.
struct Curve {
  std::string name;
  std::vector<dvec2> points;
  Style style{};
};

struct Axis {
  std::string label;
  std::string zero{};  ///< how the row of zeros is called
};

struct Chart {
  std::string title, subtitle;
  Axis x, y;
  std::vector<Dot> dots{};
  std::vector<Curve> curves{};
  std::string advice{};  ///< which method to take, and why: the sentence below
  std::string footer{};
};

/// Whether a slide shows the whole advice.
bool has_room_for(std::string_view advice);

/// The chart laid out; texts no smaller than 1/36 of the height.
/// Domain: x > 0 and y >= 0 for dots, x, y > 0 for curves, all finite (ContractViolation otherwise); at least
/// one dot or curve.
Sheet sheet_of(const Chart& chart, double width = 1280, double height = 720);

}  // namespace gradus::plot
