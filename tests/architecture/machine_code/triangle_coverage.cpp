// Every method of triangle_coverage as a function of its own; see machine_code_test.py.
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"

namespace coverage = gradus::triangle_coverage;

void set_pixel(gradus::ivec2 p, const coverage::Weights& weights);  // defined nowhere: it must be called

extern "C" {
[[gnu::flatten]] void machine_code_cover(const coverage::Triangle& triangle, const gradus::Window& window) {
  coverage::cover(triangle, window, set_pixel);
}
[[gnu::flatten]] void machine_code_closed_half_planes(const coverage::Triangle& triangle,
                                                      const gradus::Window& window) {
  coverage::closed_half_planes(triangle, window, set_pixel);
}
[[gnu::flatten]] void machine_code_expanded_edges(const coverage::Triangle& triangle, gradus::dvec2 origin,
                                                  const gradus::Window& window) {
  coverage::expanded_edges(triangle, origin, window, set_pixel);
}
}
