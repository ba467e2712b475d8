#pragma once
// The frame of a viewer in numbers of many digits: what the promises and the benchmark of viewing judge by.

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

namespace gradus::stress {

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// b - a.
template <class Number, class T>
Triple<Number> way_from(const glm::vec<3, T>& a, const glm::vec<3, T>& b) {
  return {Number(b.x) - Number(a.x), Number(b.y) - Number(a.y), Number(b.z) - Number(a.z)};
}
template <class Number>
Number length_of(const Triple<Number>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}
template <class Number>
Triple<Number> unit(const Triple<Number>& v) {
  const Number length = length_of(v);
  return {v[0] / length, v[1] / length, v[2] / length};
}

template <class Number>
struct Axes {
  Triple<Number> right, up, forward;
  Number sine;  ///< of the angle between the view and the hint for up
};

/// Domain: eye and target apart, a hint of any length but 0, not along the view.
template <class Number, class T>
Axes<Number> axes_of(const glm::vec<3, T>& eye, const glm::vec<3, T>& target, const glm::vec<3, T>& up) {
  const Triple<Number> forward = unit(way_from<Number>(eye, target));
  const Triple<Number> across = cross(forward, unit(way_from<Number>(glm::vec<3, T>(0), up)));
  const Triple<Number> right = unit(across);
  return {right, cross(right, forward), forward, length_of(across)};
}

}  // namespace gradus::stress
