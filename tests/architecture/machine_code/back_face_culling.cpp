// Every method of back_face_culling as a function of its own; see machine_code_test.py.
#include "visibility/back_face_culling/back_face_culling.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

extern "C" {
[[gnu::flatten]] int machine_code_facing(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  return static_cast<int>(gradus::back_face_culling::facing(a, b, c));
}
[[gnu::flatten]] int machine_code_facing_after_division(const glm::dvec4& a, const glm::dvec4& b,
                                                        const glm::dvec4& c) {
  return static_cast<int>(gradus::back_face_culling::facing_after_division(a, b, c));
}
}
