#pragma once
// Vectors of numbers of many digits.

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
/// Of length 1; of the zero vector itself.
template <class Number>
Triple<Number> unit(const Triple<Number>& v) {
  const Number length = length_of(v);
  return length == 0 ? v : Triple<Number>{v[0] / length, v[1] / length, v[2] / length};
}
/// The same vector in such numbers.
template <class Number, class T>
Triple<Number> triple(const glm::vec<3, T>& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}

}  // namespace gradus::stress
