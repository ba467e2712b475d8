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
  int columns() const { return window.upper.x - window.lower.x + 1; }
  int rows() const { return window.upper.y - window.lower.y + 1; }
  int size() const { return std::max(columns(), rows()); }
  /// Whether pixels have no room for texts, or triangles none for names.
  bool crowded() const { return size() > 8 || triangles.size() > 1; }
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

inline Triangle snapped(const std::vector<dvec2>& ring, std::size_t number, double shift) {
  if (ring.size() != 3) refuse("triangles", "triangle {}: expected 3 corners, found {}", number, ring.size());
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(ring[i].x) > farthest - 1 || std::abs(ring[i].y) > farthest - 1)
      refuse("triangles", "expected corners at most {} pixels out, found one of triangle {} farther away",
             farthest - 1, number);
    t[i] = snap(ring[i] + shift);
  }
  return t;
}

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{.triangles = {}, .window = *arguments.window("window")};
  if (arguments.text("samples") == "lattice") subject.samples = Samples::lattice;
  const auto& origin = arguments.numbers("origin");
  subject.origin = {origin[0], origin[1]};
  if (subject.size() > 16) refuse("window", "expected at most 16 columns and rows, found {}", subject.size());
  if (!near_enough(subject.window)) refuse("window", "expected pixels at most {} out", farthest);
  for (const auto& ring : arguments.rings("triangles"))
    subject.triangles.push_back(snapped(ring, subject.triangles.size() + 1, subject.shift()));
  return subject;
}

inline std::vector<Parameter> subject_parameters() {
  using namespace parameters;
  return {
      {.name = "triangles",
       .type = ParameterType::rings,
       .default_value = "1,3 4,1 2,5",
       .example = "0,0 6,0 6,6; 0,0 6,6 0,6",
       .help = "triangles of three corners each: x right and y down in pixels",
       .least = 3,
       .most = 12,
       .parts = xy,
       .sizes = {1e-6, 1e6}},
      {.name = "window",
       .type = ParameterType::window,
       .default_value = "0,0,5,5",
       .example = "0,0,7,7",
       .help = "the pixels that are asked for: xmin,ymin,xmax,ymax, both corners included"},
      choice("samples", {"centres", "lattice"}, "centres", "lattice",
             "where it is asked: at the pixels' centres, or at the points of whole numbers"),
      numbers("origin", "100000000,100000000", "0,0",
              "method expanded_edges: where the window lies in a huge picture, in pixels", xy, {1, 1e12})};
}

}  // namespace gradus::triangle_coverage
