// Every method of affine_3d as a function of its own; see machine_code_test.py.
#include "transformation/affine_3d/affine_3d.hpp"
#include "transformation/affine_3d/affine_3d_notes.hpp"

using Factors = std::span<const glm::dmat4>;
using Points = std::span<glm::dvec3>;

extern "C" {
[[gnu::flatten]] void machine_code_transform(const glm::dmat4& m, glm::dvec3* points, int count) {
  for (int i = 0; i < count; ++i) points[i] = gradus::affine_3d::transform(m, points[i]);
}
[[gnu::flatten]] void machine_code_one_matrix(Factors factors, Points points) {
  gradus::affine_3d::one_matrix(factors, points);
}
[[gnu::flatten]] void machine_code_decomposition(glm::dvec3 through,
                                                 const gradus::affine_3d::Alignment<double>& align,
                                                 const gradus::Turn<double>& turn, glm::dmat4& m) {
  m = gradus::affine_3d::decomposition(through, align, turn);
}
[[gnu::flatten]] void machine_code_turn_vector(glm::dvec3 n, glm::dvec3 through,
                                               const gradus::Turn<double>& turn, glm::dvec3* points,
                                               int count) {
  for (int i = 0; i < count; ++i) points[i] = gradus::affine_3d::turn_vector(n, through, turn, points[i]);
}
[[gnu::flatten]] void machine_code_row_vectors(Factors factors, Points points) {
  gradus::affine_3d::row_vectors(factors, points);
}
[[gnu::flatten]] void machine_code_constant_offset(glm::dvec3 n, glm::dvec3 car,
                                                   const gradus::Turn<double>& turn, glm::dvec3* cameras,
                                                   int count) {
  for (int i = 0; i < count; ++i) cameras[i] = gradus::affine_3d::constant_offset(n, car, turn, cameras[i]);
}
}
