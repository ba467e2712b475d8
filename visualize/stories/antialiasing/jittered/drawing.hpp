#pragma once
// One pixel drawn large: an edge of the scene across it, a grid or two, the samples that are there, and
// beside it a scale with the exact area and the mean.

#include <array>
#include <glm/common.hpp>
#include <optional>
#include <string>
#include <vector>

#include "antialiasing/jittered/jittered.hpp"
#include "core/arithmetic/exact.hpp"
#include "stories/paper.hpp"
#include "stories/telling.hpp"

namespace gradus::jittered {

/// The scene: all places on the right of the way from a to b, in a pixel's own coordinates.
struct Edge {
  dvec2 a, b;

  bool holds(dvec2 p) const { return orient2d(a, b, p) > 0; }

  /// The part of the pixel that it holds: cut off a square, corner by corner.
  std::vector<dvec2> region() const {
    constexpr std::array<dvec2, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::vector<dvec2> inside;
    for (std::size_t i = 0; i < 4; ++i) {
      const dvec2 from = corners[i], to = corners[(i + 1) % 4];
      if (holds(from)) inside.push_back(from);
      if (holds(from) != holds(to)) inside.push_back(crossing(from, to));
    }
    return inside;
  }
  double area() const {
    const std::vector<dvec2> ring = region();
    double doubled = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) doubled += cross(ring[i], ring[(i + 1) % ring.size()]);
    return glm::clamp(0.5 * doubled, 0.0, 1.0);
  }
  /// Whether it goes through this box.
  bool crosses(dvec2 lower, dvec2 upper) const {
    const bool first = holds(lower);
    return holds({upper.x, lower.y}) != first || holds(upper) != first || holds({lower.x, upper.y}) != first;
  }

 private:
  static double cross(dvec2 u, dvec2 v) { return u.x * v.y - u.y * v.x; }
  dvec2 crossing(dvec2 from, dvec2 to) const {
    const double f = cross(b - a, from - a), t = cross(b - a, to - a);
    return glm::mix(from, to, glm::clamp(f / (f - t), 0.0, 1.0));
  }
};

/// A sample as it is drawn.
struct Dropped {
  dvec2 place;
  bool inside;
};

/// The pixel on the paper; its y points down.
struct Square {
  dvec2 corner;  ///< upper left, on the paper
  double side;

  dvec2 at(dvec2 place) const { return {corner.x + side * place.x, corner.y - side * place.y}; }
  std::vector<dvec2> box(dvec2 lower, dvec2 upper) const {
    return {at(lower), at({upper.x, lower.y}), at(upper), at({lower.x, upper.y})};
  }

  /// The ends of the edge's line in the pixel move with the two places it goes through.
  void let_drag(Narrator& narrator, const Edge& edge) const {
    narrator.handles("edge", [&](dvec2 place) -> std::optional<dvec2> {
      const bool first = length_between(place, edge.a) <= length_between(place, edge.b);
      const auto line = shown_line({{0, 0}, {1, 1}}, first ? Edge{place, edge.b} : Edge{edge.a, place});
      return line ? std::optional(first ? line->a : line->b) : std::nullopt;
    });
  }

  void put_scene(View& view, const std::string& id, const Edge& edge) const {
    view.add({id + "1 pixel", Role::boundary, Path{box({0, 0}, {1, 1}), true}});
    std::vector<dvec2> ring;
    for (const dvec2 p : edge.region()) ring.push_back(at(p));
    if (ring.size() > 2) view.add({id + "0 scene", Role::input, Area{{ring}, 1}});
    // As much of the edge's line as lies in the pixel
    const Extent unit{{0, 0}, {1, 1}};
    if (const std::optional<Stroke> line = shown_line(unit, edge))
      view.add({id + "2 edge", Role::input, *line});
  }
  void put_grid(View& view, const std::string& id, Role role, ivec2 grid, bool dashed) const {
    for (int i = 1; i < grid.x; ++i) {
      const double x = double{1} * i / grid.x;
      view.add({fmt::format("{} x {:02}", id, i), role, Stroke{at({x, 0}), at({x, 1}), false, dashed, true}});
    }
    for (int i = 1; i < grid.y; ++i) {
      const double y = double{1} * i / grid.y;
      view.add({fmt::format("{} y {:02}", id, i), role, Stroke{at({0, y}), at({1, y}), false, dashed, true}});
    }
  }
  void put_samples(View& view, const std::string& id, const std::vector<Dropped>& samples) const {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Dropped& s = samples[i];
      view.add({fmt::format("{} {:03}", id, i), s.inside ? Role::result : Role::past,
                Dot{at(s.place), !s.inside}});
    }
  }

 private:
  std::optional<Stroke> shown_line(const Extent& unit, const Edge& edge) const {
    const dvec2 way = edge.b - edge.a;
    const auto [first, last] = span_in(unit, edge.a, way, -1e6, 1e6);
    if (!(first < last)) return std::nullopt;
    return Stroke{at(edge.a + first * way), at(edge.a + last * way)};
  }
};

/// The scale beside a pixel, 0 at its foot: where the exact area and the mean are.
inline void put_scale(View& view, const Words& words, dvec2 foot, double length, double area,
                      std::optional<double> mean) {
  const auto at = [&](double value) { return foot + dvec2{0, length * value}; };
  const dvec2 tick{0.6, 0}, beside{1.1, 0};
  view.add({"s line", Role::guide, Stroke{at(0), at(1)}});
  view.add({"s zero", Role::guide, Text{at(0) - beside, "0", Align::right}});
  view.add({"s one", Role::guide, Text{at(1) - beside, "1", Align::right}});
  view.add({"s exact", Role::input, Stroke{at(area) - tick, at(area) + tick}});
  view.add({"s exact name", Role::input,
            Text{at(area) + beside, words.say("scale.exact", {{"area", area}}), Align::left}});
  if (!mean) return;
  // The two names keep a line's distance
  constexpr double line = 1.4;
  double name = length * (*mean - area);
  if (std::abs(name) < line) name = name < 0 ? -line : line;
  if (length * area + name < 0) name = line;
  if (length * area + name > length) name = -line;
  view.add({"s mean", Role::current, Dot{at(*mean)}});
  view.add(
      {"s mean name", Role::current,
       Text{at(area) + beside + dvec2{0, name}, words.say("scale.mean", {{"mean", *mean}}), Align::left}});
}

}  // namespace gradus::jittered
