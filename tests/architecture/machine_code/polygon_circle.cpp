// Every method of polygon_circle as a function of its own; see machine_code_test.py.
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "clipping/polygon_circle/polygon_circle_notes.hpp"

namespace polygon = gradus::polygon_circle;
using Polygon = std::span<const gradus::dvec2>;
using Circle = gradus::Circle<double>;

void keep(const polygon::Region<double>& region);  // defined nowhere: the compiler must call it
void keep(const std::vector<gradus::dvec2>& corners);

extern "C" {
void machine_code_arcs(Polygon corners, const Circle& c) { keep(polygon::arcs<double>(corners, c)); }
void machine_code_first_crossing(Polygon corners, const Circle& c) {
  keep(polygon::first_crossing<double>(corners, c));
}
}
