// Every method of ear_clipping as a function of its own; see machine_code_test.py.
#include "modeling/ear_clipping/ear_clipping.hpp"

void add_triangle(const gradus::ear_clipping::Triangle& triangle);  // defined nowhere: it must be called

extern "C" {
// In space, which has the cutting of the flattened polygon within
[[gnu::flatten]] void machine_code_triangulate(const glm::dvec3* polygon, std::size_t count) {
  gradus::ear_clipping::triangulate(std::span<const glm::dvec3>(polygon, count), add_triangle);
}
}
