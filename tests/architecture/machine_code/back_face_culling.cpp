// Every method of back_face_culling as a function of its own; see machine_code_test.py.
#include "visibility/back_face_culling/back_face_culling.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

using namespace gradus::back_face_culling;
using Faces = std::span<const Face<double>>;
using Outlines = std::span<const Outline<double>>;

void draw_face(std::size_t face);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] int machine_code_facing(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  return static_cast<int>(facing(a, b, c));
}
[[gnu::flatten]] int machine_code_facing_after_division(const glm::dvec4& a, const glm::dvec4& b,
                                                        const glm::dvec4& c) {
  return static_cast<int>(facing_after_division(a, b, c));
}
[[gnu::flatten]] void machine_code_normal_and_view(const Faces& faces, const Eye<double>& eye) {
  normal_and_view<double>(faces, eye, draw_face);
}
[[gnu::flatten]] void machine_code_screen_area(const Outlines& faces) {
  screen_area<double>(faces, draw_face);
}
[[gnu::flatten]] void machine_code_homogeneous(const Faces& faces) { homogeneous<double>(faces, draw_face); }
[[gnu::flatten]] void machine_code_first_three_corners(const Faces& faces, const Eye<double>& eye) {
  first_three_corners<double>(faces, eye, draw_face);
}
[[gnu::flatten]] void machine_code_eye_space_normal(const Faces& faces) {
  eye_space_normal<double>(faces, draw_face);
}
[[gnu::flatten]] void machine_code_after_division(const Faces& faces) {
  after_division<double>(faces, draw_face);
}
[[gnu::flatten]] void machine_code_misprinted_shoelace(const Outlines& faces) {
  misprinted_shoelace<double>(faces, draw_face);
}
[[gnu::flatten]] void machine_code_six_products(const Outlines& faces) {
  six_products<double>(faces, draw_face);
}
}
