// Every method of affine_2d as a function of its own; see machine_code_test.py.
#include "transformation/affine_2d/affine_2d.hpp"
#include "transformation/affine_2d/affine_2d_notes.hpp"

using Factors = std::span<const gradus::affine_2d::Factor<double>>;
using Points = std::span<glm::dvec2>;

extern "C" {
[[gnu::flatten]] void machine_code_one_matrix(Factors factors, Points points) {
  gradus::affine_2d::one_matrix(factors, points);
}
[[gnu::flatten]] void machine_code_factor_by_factor(Factors factors, Points points) {
  gradus::affine_2d::factor_by_factor(factors, points);
}
[[gnu::flatten]] void machine_code_local_coordinates(glm::dvec2 origin, Factors factors, Points points) {
  gradus::affine_2d::local_coordinates(origin, factors, points);
}
[[gnu::flatten]] bool machine_code_undo(Factors factors, Points points) {
  return gradus::affine_2d::undo(factors, points);
}
[[gnu::flatten]] void machine_code_centre_added(Factors factors, Points points) {
  gradus::affine_2d::centre_added(factors, points);
}
}
