// Every method of perspective as a function of its own; see machine_code_test.py.
#include "projection/perspective/perspective.hpp"
#include "projection/perspective/perspective_notes.hpp"

namespace perspective = gradus::perspective;
using gradus::dvec2;
using gradus::dvec3;

extern "C" {
[[gnu::flatten]] void machine_code_transform(const gradus::Projection<double>& projection,
                                             const glm::dvec3* view, glm::dvec4* clip, int count) {
  for (int i = 0; i < count; ++i) clip[i] = gradus::perspective::transform(projection, view[i]);
}
[[gnu::flatten]] void machine_code_divide(const glm::dvec4* clip, glm::dvec3* ndc, int count) {
  for (int i = 0; i < count; ++i) ndc[i] = gradus::perspective::divide(clip[i]);
}
[[gnu::flatten]] void machine_code_frustum_corners(double across, double up, double near, double far,
                                                   std::array<dvec3, 8>* corners) {
  *corners = perspective::frustum_corners(across, up, near, far);
}
[[gnu::flatten]] void machine_code_project(double d, const dvec3* point, std::optional<dvec3>* image,
                                           int count) {
  for (int i = 0; i < count; ++i) image[i] = perspective::project(d, point[i]);
}
[[gnu::flatten]] void machine_code_vanishing_point(const glm::dmat4& matrix, const dvec3* direction,
                                                   std::optional<dvec2>* point, int count) {
  for (int i = 0; i < count; ++i) point[i] = perspective::vanishing_point(matrix, direction[i]);
}
[[gnu::flatten]] double machine_code_separable_step(perspective::DepthCurve curve,
                                                    perspective::DepthFormat format, double near, double far,
                                                    double z) {
  return perspective::separable_step(curve, format, near, far, z);
}
[[gnu::flatten]] void machine_code_keep_z(double d, const dvec3* point, std::optional<dvec3>* image,
                                          int count) {
  for (int i = 0; i < count; ++i) image[i] = perspective::keep_z(d, point[i]);
}
[[gnu::flatten]] void machine_code_divide_tested(const gradus::Projection<double>& projection,
                                                 const dvec3* view, std::optional<dvec3>* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = perspective::divide_tested(projection, view[i]);
}
[[gnu::flatten]] void machine_code_divide_untested(const gradus::Projection<double>& projection,
                                                   const dvec3* view, dvec3* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = perspective::divide_untested(projection, view[i]);
}
[[gnu::flatten]] void machine_code_zoom_minus_z(const perspective::WireScreen<double>& screen,
                                                const dvec3* node, dvec2* image, int count) {
  for (int i = 0; i < count; ++i) image[i] = perspective::zoom_minus_z(screen, node[i]);
}
[[gnu::flatten]] void machine_code_parallel_by_plane(const glm::dmat4& matrix, const dvec3* direction,
                                                     std::optional<dvec2>* point, int count) {
  for (int i = 0; i < count; ++i) point[i] = perspective::parallel_by_plane(matrix, direction[i]);
}
}
