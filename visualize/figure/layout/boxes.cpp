#include "figure/layout/boxes.hpp"

namespace gradus::layout {

// Liang and Barsky's parameters
std::optional<Segment<2, double>> clipped(dvec2 a, dvec2 b, const Box& box) {
  // Most are far from it
  if (std::max(a.x, b.x) < box.x || std::min(a.x, b.x) > box.right() || std::max(a.y, b.y) < box.y ||
      std::min(a.y, b.y) > box.bottom()) {
    return std::nullopt;
  }
  double enter = 0, leave = 1;
  const dvec2 d = b - a;
  const auto side = [&](double p, double q) {
    if (p == 0) return q >= 0;
    const double t = q / p;
    if (p < 0) enter = std::max(enter, t);
    if (p > 0) leave = std::min(leave, t);
    return enter <= leave;
  };
  if (!side(-d.x, a.x - box.x) || !side(d.x, box.right() - a.x) || !side(-d.y, a.y - box.y) ||
      !side(d.y, box.bottom() - a.y)) {
    return std::nullopt;
  }
  return Segment{a + enter * d, a + leave * d};
}

bool cross(const Segment<2, double>& a, const Segment<2, double>& b) {
  const auto side = [](const Segment<2, double>& of, dvec2 p) {
    const dvec2 way = of.b - of.a, to = p - of.a;
    return way.x * to.y - way.y * to.x;
  };
  return side(a, b.a) * side(a, b.b) <= 0 && side(b, a.a) * side(b, a.b) <= 0 &&
         std::max(a.a.x, a.b.x) >= std::min(b.a.x, b.b.x) &&
         std::max(b.a.x, b.b.x) >= std::min(a.a.x, a.b.x) &&
         std::max(a.a.y, a.b.y) >= std::min(b.a.y, b.b.y) && std::max(b.a.y, b.b.y) >= std::min(a.a.y, a.b.y);
}

// Cut at one side after the other
std::vector<dvec2> inside_of(std::vector<dvec2> ring, const Box& box) {
  const auto cut = [&ring](int axis, double border, double sign) {
    std::vector<dvec2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double from = sign * (a[axis] - border), to = sign * (b[axis] - border);
      if (from >= 0) kept.push_back(a);
      if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + from / (from - to) * (b - a));
    }
    ring = std::move(kept);
  };
  cut(0, box.x, 1);
  cut(0, box.right(), -1);
  cut(1, box.y, 1);
  cut(1, box.bottom(), -1);
  return ring;
}

}  // namespace gradus::layout
