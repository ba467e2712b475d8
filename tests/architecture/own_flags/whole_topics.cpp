// Topics whole, for own_flags_test.py: polygons, which come out right by what is never lost, their area, and
// plain formulas, whose bounds hold whether or not a compiler fuses a product with a sum.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "architecture/own_flags/checks.hpp"
#include "clipping/liang_barsky/liang_barsky.hpp"
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"
#include "projection/parallel/parallel.hpp"
#include "projection/perspective/perspective.hpp"
#include "transformation/affine_2d/affine_2d.hpp"

namespace {

// --- Polygons ---------------------------------------------------------------------------------------------

namespace sh = sutherland_hodgman;

// A star of n corners round the origin, which touches and crosses what lies there
std::vector<dvec2> star(Random& random, int n) {
  std::vector<dvec2> corners;
  for (int i = 0; i < n; ++i) {
    const SinCos direction = sin_cos_degrees(360.0 * (i + random.uniform(0, 0.9)) / n);
    corners.push_back(random.uniform(1, 9) * dvec2(direction.cos, direction.sin));
  }
  return corners;
}

double doubled_area(std::span<const dvec2> corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

// Where an edge between floats crosses x = c is the nearest float to the exact place: the sign of that less
// the middle between two floats tells
void expect_nearest(float y, glm::vec2 a, glm::vec2 b, float c, int round) {
  for (const float beside : {std::nextafter(y, -INFINITY), std::nextafter(y, INFINITY)}) {
    const double middle = (double{y} + double{beside}) / 2;
    const int side = orient2d_exact(dvec2(a), dvec2(b), {c, middle}) * (a.x < b.x ? -1 : 1);
    expect(beside < y ? side >= 0 : side <= 0, "a batch of floats rounds to nearest", round);
  }
}

// Triangles of floats whose first corner alone lies inside the left border, in a batch
void batches_of_floats() {
  Random random(11);
  const auto number = [&random](double least, double most) {
    return static_cast<float>(random.uniform(least, most));
  };
  const Rectangle<float> window{{-1, -10}, {10, 10}};
  sh::Polygons<float> given, clipped;
  for (int i = 0; i < 20000; ++i) {
    std::vector<glm::vec2> triangle;
    for (const double right : {9, -2, -2}) triangle.push_back({number(right - 7, right), number(-8, 8)});
    triangle[0].x = std::abs(triangle[0].x);
    given.add(triangle);
  }
  sh::BatchClipper<float> clip;
  clip(given, window, clipped);
  for (int i = 0; i < 20000; ++i) {
    const auto p = given[std::size_t(i)], found = clipped[std::size_t(i)];
    const auto right = sh::clip_to_window(p, window);
    expect(found.size() == right.size(), "a batch of floats", i);
    for (std::size_t k = 0; k < std::min(found.size(), right.size()); ++k) {
      expect(same(dvec2(found[k]), dvec2(right[k].at)), "a batch of floats", i);
    }
    if (found.size() != 3) continue;  // both cuts in one place
    expect_nearest(found[0].y, p[2], p[0], -1, i);
    expect_nearest(found[2].y, p[0], p[1], -1, i);
  }
}

void polygons() {
  Random random(7);
  const AxisBox<2, double> window{{-3, -2}, {4, 5}};
  const std::vector<int> order{0, 1, 2, 3};
  for (int i = 0; i < 1000; ++i) {
    const std::vector<dvec2> corners = star(random, 12);
    // One polygon and its pieces have the same area
    std::vector<dvec2> clipped;
    for (const auto& vertex :
         sh::clip_to_window(std::span<const dvec2>(corners), window, std::span<const int>(order))) {
      clipped.push_back(vertex.at);
    }
    double pieces = 0;
    const std::vector<std::vector<dvec2>> outline{corners};
    const sh::Rings<double> rings{std::span<const std::vector<dvec2>>(outline)};
    for (const auto& piece : sh::separate_pieces(rings, window, std::span<const int>(order))) {
      std::vector<dvec2> ring;
      for (const auto& vertex : piece.outline) ring.push_back(vertex.at);
      pieces += doubled_area(ring);
    }
    expect(std::abs(pieces - doubled_area(clipped)) < 1e-12, "pieces make up the polygon", i);

    // Ears cover the polygon once
    double ears = 0;
    int triangles = 0;
    ear_clipping::triangulate(std::span<const dvec2>(corners), [&](const ear_clipping::Triangle& t) {
      const std::array<dvec2, 3> ear{corners[std::size_t(t[0])], corners[std::size_t(t[1])],
                                     corners[std::size_t(t[2])]};
      expect(doubled_area(ear) > -1e-12, "an ear runs counter-clockwise", i);
      ears += doubled_area(ear);
      ++triangles;
    });
    expect(triangles == 10 && std::abs(ears - doubled_area(corners)) < 1e-11, "ears cover the polygon", i);

    // In a circle, by true arcs and by chords
    const auto region = polygon_circle::arcs(std::span<const dvec2>(corners), Circle<double>{{0, 0}, 5});
    double chords = 0;
    for (const auto& ring : polygon_circle::flatten(region, 1e-4)) chords += doubled_area(ring);
    const double area = polygon_circle::area(region);
    expect(chords / 2 <= area + 1e-12 && area - chords / 2 < 2 * 32 * 1e-4, "arcs and chords", i);
  }
}

// --- Plain formulas: their bounds count roundings, and a fused operation has one less ------------

constexpr double u = 0x1p-53;

void plain_formulas() {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    // affine_2d: 3 ulp of the sum of absolute terms
    const dvec2 x = point(random), y = point(random), shift = point(random), p = point(random);
    const glm::dmat3 m{x.x, x.y, 0, y.x, y.y, 0, shift.x, shift.y, 1};
    const dvec2 moved = affine_2d::transform(m, p);
    for (int k = 0; k < 2; ++k) {
      SumOfProducts<2> exact;
      exact.add(x[k], p.x);
      exact.add(y[k], p.y);
      exact.add(shift[k]);
      exact.subtract(moved[k]);
      const double terms = std::abs(x[k] * p.x) + std::abs(y[k] * p.y) + std::abs(shift[k]);
      expect(std::abs(rounded(exact)) <= 3 * 2 * u * terms, "affine_2d::transform", i);
    }
    // parallel: u (|x'| + 2 |t a|), and points of the plane stay where they are
    const double d = coordinate(random);
    const dvec3 place = point_in_space(random);
    const parallel::Slant<double> slant{random.uniform(-2, 2), random.uniform(-2, 2)};
    const dvec3 image = parallel::oblique(d, slant, place);
    SumOfProducts<2> exact;
    exact.add(place.x);
    exact.add(d, slant.a);
    exact.subtract(place.z, slant.a);
    exact.subtract(image.x);
    expect(std::abs(rounded(exact)) <= u * (std::abs(image.x) + 2.01 * std::abs((d - place.z) * slant.a)),
           "oblique", i);
    expect(parallel::oblique(place.z, slant, place) == place, "oblique, in the plane", i);
    // perspective: 2 roundings; where products are fused the near plane's z is 0 to half an ulp of its terms
    const double near = random.uniform(0.1, 1), far = random.uniform(2, 100);
    const Projection<double> projection = projection_of(1.0, 1.0, near, far);
    const double z = perspective::transform(projection, dvec3{place.x, place.y, near}).z;
    expect(std::abs(z) <= u * std::abs(projection.z_offset), "perspective, at the near plane", i);
    // liang_barsky: at one border the point is a + t d, five roundings
    const Segment<2, double> line{{-4 - random.unit(), coordinate(random)},
                                  {random.unit(), coordinate(random)}};
    const auto plain = liang_barsky::parametric(line, AxisBox<2, double>{{-3, -100}, {4, 100}});
    const auto nearest = liang_barsky::correctly_rounded(line, AxisBox<2, double>{{-3, -100}, {4, 100}});
    expect(plain && nearest && std::abs(plain->a.y - nearest->a.y) <= 5 * 2 * u * 20, "parametric", i);
  }
}

}  // namespace

int main() {
  polygons();
  batches_of_floats();
  plain_formulas();
  return report();
}
