// Every method of parallel as a function of its own; see machine_code_test.py.
#include "projection/parallel/parallel.hpp"
#include "projection/parallel/parallel_notes.hpp"

namespace parallel = gradus::parallel;
using gradus::dvec3;

extern "C" {
[[gnu::flatten]] void machine_code_orthographic(parallel::Axis axis, double d, const dvec3* point,
                                                dvec3* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = parallel::orthographic(axis, d, point[i]);
}
[[gnu::flatten]] void machine_code_oblique(double d, const parallel::Slant<double>& slant, const dvec3* point,
                                           dvec3* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = parallel::oblique(d, slant, point[i]);
}
[[gnu::flatten]] void machine_code_along(const parallel::Plane<double>& plane, const dvec3& v,
                                         const dvec3* point, dvec3* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = parallel::along(plane, v, point[i]);
}
[[gnu::flatten]] void machine_code_keep_x_and_y(double d, const parallel::Slant<double>& slant,
                                                const dvec3* point, dvec3* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = parallel::keep_x_and_y(d, slant, point[i]);
}
}
