// Every method of viewing as a function of its own; see machine_code_test.py.
#include "projection/viewing/viewing.hpp"
#include "projection/viewing/viewing_notes.hpp"

using gradus::dvec3;
using gradus::Frame;

extern "C" {
[[gnu::flatten]] void machine_code_look_at(const dvec3& eye, const dvec3& target, const dvec3& up,
                                           Frame<double>& frame) {
  frame = gradus::viewing::look_at(eye, target, up);
}
[[gnu::flatten]] void machine_code_to_view(const Frame<double>& frame, dvec3* points, int count) {
  for (int i = 0; i < count; ++i) points[i] = gradus::viewing::to_view(frame, points[i]);
}
[[gnu::flatten]] void machine_code_world_to_view(const Frame<double>* frames, int count,
                                                 glm::dmat4* matrices) {
  for (int i = 0; i < count; ++i) matrices[i] = gradus::viewing::world_to_view(frames[i]);
}
[[gnu::flatten]] void machine_code_view_to_world(const Frame<double>* frames, int count,
                                                 glm::dmat4* matrices) {
  for (int i = 0; i < count; ++i) matrices[i] = gradus::viewing::view_to_world(frames[i]);
}
[[gnu::flatten]] void machine_code_inverse_of_any_frame(const Frame<double>* frames, int count,
                                                        glm::dmat4* matrices) {
  for (int i = 0; i < count; ++i) matrices[i] = gradus::viewing::inverse_of_any_frame(frames[i]);
}
[[gnu::flatten]] void machine_code_minus_position(const Frame<double>* frames, int count,
                                                  glm::dmat4* matrices) {
  for (int i = 0; i < count; ++i) matrices[i] = gradus::viewing::minus_position(frames[i]);
}
[[gnu::flatten]] void machine_code_transposed(const Frame<double>* frames, int count, glm::dmat4* matrices) {
  for (int i = 0; i < count; ++i) matrices[i] = gradus::viewing::transposed(frames[i]);
}
[[gnu::flatten]] void machine_code_spare_up(const dvec3& eye, const dvec3& target, const dvec3& up,
                                            Frame<double>& frame) {
  frame = gradus::viewing::spare_up(eye, target, up);
}
[[gnu::flatten]] void machine_code_cross_products(const dvec3* eyes, const dvec3& target, const dvec3& up,
                                                  Frame<double>* frames, int count) {
  for (int i = 0; i < count; ++i) frames[i] = gradus::viewing::cross_products(eyes[i], target, up);
}
}
