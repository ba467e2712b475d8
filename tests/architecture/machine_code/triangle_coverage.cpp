// Every method of triangle_coverage as a function of its own; see machine_code_test.py.
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace coverage = gradus::triangle_coverage;

void set_pixel(gradus::ivec2 p, const coverage::Weights& weights);  // defined nowhere: it must be called

extern "C" {
[[gnu::flatten]] void machine_code_cover(const coverage::Triangle& triangle, const gradus::Window& window) {
  coverage::cover(triangle, window, set_pixel);
}
}
