// Every method of affine_3d as a function of its own; see machine_code_test.py.
#include "transformation/affine_3d/affine_3d.hpp"

extern "C" {
[[gnu::flatten]] void machine_code_transform(const glm::dmat4& m, glm::dvec3* points, int count) {
  for (int i = 0; i < count; ++i) points[i] = gradus::affine_3d::transform(m, points[i]);
}
}
