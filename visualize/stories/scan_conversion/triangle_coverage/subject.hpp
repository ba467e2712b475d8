#pragma once
// What the story of a triangle's pixels is given: triangles, a window of pixels, and where they are sampled.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::triangle_coverage {

/// Where it is asked whether a triangle covers: at the pixels' centres, or at the points of whole numbers.
enum class Samples { centres, lattice };

constexpr double square_pixels(std::int64_t value) {
  return static_cast<double>(value) / double{subpixels * subpixels};
}

struct Subject {
  std::vector<Triangle> triangles;  ///< moved by half a pixel for samples on the lattice
  Window window;
  Samples samples = Samples::centres;
  dvec2 origin{};

  double shift() const { return samples == Samples::lattice ? 0.5 : 0; }
  /// A corner as it was given, on the grid of 1/256.
  dvec2 place(ivec2 corner) const { return dvec2(corner) / double{subpixels} - shift(); }
  /// The same in the drawing, where pixels have their numbers at their centres.
  dvec2 at(ivec2 corner) const { return dvec2(corner) / double{subpixels} - 0.5; }
  Extent frame() const { return {dvec2(window.lower) - 0.5, dvec2(window.upper) + 0.5}; }
  /// The same of a corner before it was put on that grid, as far as the drawing goes.
  std::optional<dvec2> shown_at(dvec2 given) const {
    const dvec2 place = at(snap(given + shift()));
    return frame().holds(place) ? std::optional(place) : std::nullopt;
  }
  /// The triangles' pixels and a rim of others.
  Window all_round() const {
    Extent all;
    for (const Triangle& triangle : triangles) {
      for (const ivec2 corner : triangle) all.add(at(corner));
    }
    return {ivec2(glm::floor(all.lower - 0.5)), ivec2(glm::ceil(all.upper + 0.5))};
  }
  int columns() const { return window.upper.x - window.lower.x + 1; }
  int rows() const { return window.upper.y - window.lower.y + 1; }
  int size() const { return std::max(columns(), rows()); }
  /// Whether pixels have no room for texts.
  bool crowded() const { return size() > 8; }
  std::string number(std::int64_t value) const { return figure_real(square_pixels(value)); }
  std::string corners_text(std::size_t triangle) const {
    const auto& [a, b, c] = triangles[triangle];
    return figure_place(place(a)) + ", " + figure_place(place(b)) + ", " + figure_place(place(c));
  }
};

/// The part of a polygon where a linear function is not below 0.
inline std::vector<dvec2> above_0(const std::vector<dvec2>& ring, const auto& function) {
  std::vector<dvec2> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double at_a = function(a), at_b = function(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// The part of a polygon in a rectangle.
inline std::vector<dvec2> within(const Extent& frame, std::vector<dvec2> ring) {
  for (const int axis : {0, 1}) {
    ring = above_0(ring, [&](dvec2 p) { return p[axis] - frame.lower[axis]; });
    ring = above_0(ring, [&](dvec2 p) { return frame.upper[axis] - p[axis]; });
  }
  return ring;
}

/// A ring's corners, snapped, as the triangles of a fan round its first one.
inline void add_fan(std::vector<Triangle>& triangles, const std::vector<dvec2>& ring, double shift) {
  std::vector<ivec2> corners;
  for (const dvec2 p : ring) {
    if (!can_snap(2.0 * p))
      refuse("triangles", "expected corners at most {} pixels out, found one farther away", farthest / 2);
    corners.push_back(snap(p + shift));
  }
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{.triangles = {}, .window = {}};
  if (arguments.text("samples") == "lattice") subject.samples = Samples::lattice;
  const auto& origin = arguments.numbers("origin");
  subject.origin = {origin[0], origin[1]};
  for (const auto& ring : arguments.rings("triangles")) add_fan(subject.triangles, ring, subject.shift());
  subject.window = arguments.window("window").value_or(subject.all_round());
  const ivec2 first = subject.window.lower;
  if (std::max(std::abs(dvec2(first).x), std::abs(dvec2(first).y)) > farthest - 16)
    refuse("window", "expected a first pixel at most {} out, found {},{}", farthest - 16, first.x, first.y);
  // What is larger than a drawing shows is seen from its first pixel on
  subject.window.upper = glm::min(subject.window.upper, first + 15);
  return subject;
}

inline std::vector<Parameter> subject_parameters() {
  using namespace parameters;
  return {
      {.name = "triangles",
       .type = ParameterType::rings,
       .default_value = "1,1 6,1 2,5; 6,1 7,5 2,5",
       .example = "0,0 6,0 6,6; 0,0 6,6 0,6",
       .help = "triangles, x right and y down in pixels; more than three corners make a fan of triangles",
       .least = 3,
       .most = 12,
       .parts = xy,
       .sizes = {1e-6, 1e6}},
      {.name = "window",
       .type = ParameterType::window,
       .default_value = "",
       .example = "0,0,7,7",
       .help =
           "the pixels that are asked for: xmin,ymin,xmax,ymax, both corners included, else all and a rim; "
           "of more than 16 columns or rows the first 16"},
      choice("samples", {"centres", "lattice"}, "centres", "lattice",
             "where it is asked: at the pixels' centres, or at the points of whole numbers"),
      numbers("origin", "100000000,100000000", "0,0",
              "method expanded_edges: where the window lies in a huge picture, in pixels", xy, {1e-6, 1e12})};
}

}  // namespace gradus::triangle_coverage
