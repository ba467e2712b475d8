#pragma once
// The coordinates that transformations of the plane give, by the formulas of textbooks: what the promises and
// the benchmark of affine_2d judge by. V is any vector with x and y.

namespace gradus::stress {

template <class V>
V scaled(const V& p, const V& factors, const V& about) {
  return {about.x + factors.x * (p.x - about.x), about.y + factors.y * (p.y - about.y)};
}

template <class V, class Number>
V turned(const V& p, const Number& sin, const Number& cos, const V& about) {
  const Number x = p.x - about.x, y = p.y - about.y;
  return {about.x + cos * x - sin * y, about.y + sin * x + cos * y};
}

template <class V>
V sheared(const V& p, const V& factors, const V& about) {
  return {p.x + factors.x * (p.y - about.y), p.y + factors.y * (p.x - about.x)};
}

}  // namespace gradus::stress
