// Every method of perspective as a function of its own; see machine_code_test.py.
#include "projection/perspective/perspective.hpp"

extern "C" {
[[gnu::flatten]] void machine_code_transform(const gradus::Projection<double>& projection,
                                             const glm::dvec3* view, glm::dvec4* clip, int count) {
  for (int i = 0; i < count; ++i) clip[i] = gradus::perspective::transform(projection, view[i]);
}
[[gnu::flatten]] void machine_code_divide(const glm::dvec4* clip, glm::dvec3* ndc, int count) {
  for (int i = 0; i < count; ++i) ndc[i] = gradus::perspective::divide(clip[i]);
}
}
