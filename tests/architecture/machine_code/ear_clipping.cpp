// Every method of ear_clipping as a function of its own; see machine_code_test.py.
#include "modeling/ear_clipping/ear_clipping.hpp"
#include "modeling/ear_clipping/ear_clipping_notes.hpp"
#include "modeling/ear_clipping/join_holes.hpp"
#include "modeling/ear_clipping/widest_ear.hpp"

void add_triangle(const gradus::ear_clipping::Triangle& triangle);  // defined nowhere: it must be called

extern "C" {
// In space, which has the cutting of the flattened polygon within
[[gnu::flatten]] void machine_code_triangulate(const glm::dvec3* polygon, std::size_t count) {
  gradus::ear_clipping::triangulate(std::span<const glm::dvec3>(polygon, count), add_triangle);
}
[[gnu::flatten]] void machine_code_widest_ear(const glm::dvec2* polygon, std::size_t count) {
  gradus::ear_clipping::widest_ear(std::span<const glm::dvec2>(polygon, count), add_triangle);
}
[[gnu::flatten]] void machine_code_convex_only(const glm::dvec2* polygon, std::size_t count) {
  gradus::ear_clipping::convex_only(std::span<const glm::dvec2>(polygon, count), add_triangle);
}
[[gnu::flatten]] void machine_code_bridge(const gradus::ear_clipping::GrowingRing<double>& ring,
                                          const std::vector<gradus::ear_clipping::Hole>& holes,
                                          gradus::ear_clipping::Join& join) {
  join = gradus::ear_clipping::bridge(ring, holes);
}
[[gnu::flatten]] void machine_code_join_holes(const glm::dvec2* points, std::size_t count,
                                              const gradus::Faces& rings, std::vector<int>& ring) {
  ring = gradus::ear_clipping::join_holes(std::span<const glm::dvec2>(points, count), rings);
}
}
