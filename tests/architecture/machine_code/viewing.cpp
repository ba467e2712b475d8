// Every method of viewing as a function of its own; see machine_code_test.py.
#include "projection/viewing/viewing.hpp"

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
}
