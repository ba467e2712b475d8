// Every method of sutherland_hodgman as a function of its own; see machine_code_test.py.
#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

using gradus::sutherland_hodgman::Plane;
using gradus::sutherland_hodgman::Point;

extern "C" {
// By all planes, which has the cutting at one of them within
[[gnu::flatten]] void machine_code_clip(std::vector<Point<double>>& polygon, const Plane<double>* planes,
                                        std::size_t count) {
  polygon = gradus::sutherland_hodgman::clip(polygon, std::span<const Plane<double>>(planes, count));
}
}
