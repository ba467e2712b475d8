// The topics that promise exact results, on inputs where a wrong rounding shows, for own_flags_test.py:
// compiled by the copied files alone, with a user's flags. What is right is told by core's fixed-point
// numbers, which compute with integers only, so that no flag of floating-point arithmetic reaches them.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>

#include "architecture/own_flags/checks.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/sutherland_hodgman/crossing.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact_polynomial.hpp"
#include "core/arithmetic/two_doubles.hpp"
#include "core/random.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

namespace {

constexpr int rounds = 20000;

// Everything inlined, as in a user's inner loop: only there does a compiler see products and sums together
#define KERNEL [[gnu::flatten, gnu::noinline]]

// Nearly in line with a and b, in doubles
template <int N>
glm::vec<N, double> beside(glm::vec<N, double> a, glm::vec<N, double> b, Random& random) {
  return a + random.uniform(-1, 2) * (b - a);
}

// --- core -------------------------------------------------------------------------------------------------

KERNEL Rounded sum_of(double a, double b, double c) { return two_sum(a * b, c); }
KERNEL Rounded fast_sum_of(double a, double b, double c) { return fast_two_sum(64 * a * b, c); }
KERNEL Rounded product_of(double a, double b) { return two_product(a, b); }
KERNEL Expansion<16> area_of(double a, double b, double c) {
  return exact_difference(a, b) * exact_difference(c, a) + exact_product(b, c) * exact_product(a, 1);
}

void error_free_transforms() {
  Random random(1);
  for (int i = 0; i < rounds; ++i) {
    const double a = coordinate(random), b = coordinate(random), c = coordinate(random);
    // What is handed over may itself be a product, still in its register
    volatile double rounded_product = a * b;
    const Rounded sum = sum_of(a, b, c), product = product_of(a, b);
    SumOfProducts<2> rest;
    rest.add(double{rounded_product});
    rest.add(c);
    rest.subtract(sum.value);
    rest.subtract(sum.error);
    expect(rest.sign() == 0, "two_sum of a product", i);
    const double large = 64 * a * b;
    volatile double rounded_large = large;
    if (std::abs(rounded_large) >= std::abs(c)) {
      const Rounded fast = fast_sum_of(a, b, c);
      SumOfProducts<1> lost;
      lost.add(double{rounded_large});
      lost.add(c);
      lost.subtract(fast.value);
      lost.subtract(fast.error);
      expect(lost.sign() == 0, "fast_two_sum of a product", i);
    }
    SumOfProducts<2> left;
    left.add(a, b);
    left.subtract(product.value);
    left.subtract(product.error);
    expect(left.sign() == 0 && same(product.value, rounded_product), "two_product", i);
    const Expansion<16> area = area_of(a, b, c);
    SumOfProducts<3> exact;
    exact.add(a, c);
    exact.subtract(a, a);
    exact.subtract(b, c);
    exact.add(b, a);
    exact.add(b, c, a);
    expect(same(rounded(area), rounded(exact)), "Expansion", i);
  }
}

KERNEL Rounded pair_product(Rounded a, Rounded b) { return product_of_pairs(a, b); }
KERNEL Rounded pair_quotient(Rounded a, Rounded b) { return quotient_of_pairs(a, b); }
KERNEL Rounded pair_root(Rounded a) { return root_of_pair(a); }

// sum + a * b
void add_product(SumOfProducts<2>& sum, Rounded a, Rounded b) {
  for (const double x : {a.value, a.error}) {
    for (const double y : {b.value, b.error}) sum.add(x, y);
  }
}
void subtract(SumOfProducts<2>& sum, Rounded a) {
  sum.subtract(a.value);
  sum.subtract(a.error);
}

void pairs_of_doubles() {
  Random random(10);
  for (int i = 0; i < rounds; ++i) {
    const double a_one = coordinate(random), a_two = coordinate(random);
    const double b_one = coordinate(random), b_two = coordinate(random);
    const Rounded a = two_product(a_one, a_two), b = two_product(b_one, b_two);
    const Rounded product = pair_product(a, b), quotient = pair_quotient(a, b);
    SumOfProducts<2> lost;
    add_product(lost, a, b);
    subtract(lost, product);
    expect(std::abs(rounded(lost)) <= 0x1p-101 * std::abs(product.value), "product_of_pairs", i);
    SumOfProducts<2> rest;
    add_product(rest, quotient, b);
    subtract(rest, a);
    expect(std::abs(rounded(rest)) <= 0x1p-99 * std::abs(a.value), "quotient_of_pairs", i);
    const Rounded square = a.value < 0 ? negated(a) : a, root = pair_root(square);
    SumOfProducts<2> beside;
    add_product(beside, root, root);
    subtract(beside, square);
    expect(std::abs(rounded(beside)) <= 0x1p-98 * square.value, "root_of_pair", i);
  }
}

KERNEL int side_of_line(dvec2 a, dvec2 b, dvec2 c) { return orient2d(a, b, c); }
KERNEL int side_of_plane(dvec3 a, dvec3 b, dvec3 c, dvec3 d) { return orient3d(a, b, c, d); }
KERNEL int facing_of(glm::dvec4 a, glm::dvec4 b, glm::dvec4 c) {
  return back_face_culling::determinant_sign(a, b, c);
}

void signs() {
  Random random(2);
  for (int i = 0; i < rounds; ++i) {
    const dvec2 a = point(random), b = point(random), c = beside(a, b, random);
    expect(side_of_line(a, b, c) == orient2d_exact(a, b, c), "orient2d", i);
    const dvec3 p = point_in_space(random), q = point_in_space(random), r = point_in_space(random);
    const dvec3 s = beside(beside(p, q, random), r, random);
    expect(side_of_plane(p, q, r, s) == orient3d_exact(p, q, r, s), "orient3d", i);
    const glm::dvec4 u{p.x, p.y, 0, p.z}, v{q.x, q.y, 0, q.z};
    const dvec3 between = beside(p, q, random);
    const glm::dvec4 w{between.x, between.y, 0, between.z};
    expect(facing_of(u, v, w) == -orient3d_exact(p, q, between, dvec3(0)), "facing", i);
  }
}

// The same bits in every build
std::uint64_t hash_of_elementary() {
  Random random(3);
  std::uint64_t hash = 0;
  const auto add = [&hash](double x) { hash = (hash ^ bits(x)) * 0x9E3779B97F4A7C15 + (hash >> 29); };
  for (int i = 0; i < rounds; ++i) {
    const double x = random.uniform(-30, 30), y = random.uniform(-3, 3), part = random.uniform(-1, 1);
    for (const double result :
         {gradus::sin(x), gradus::cos(1e10 * x), gradus::tan(y), gradus::asin(part), gradus::acos(part),
          gradus::atan2(x, y), gradus::exp(x), gradus::log(std::abs(x)), gradus::pow(std::abs(x), y),
          sin_cos_degrees(x).sin}) {
      add(result);
    }
  }
  return hash;
}

// --- Segments in windows, boxes and the view volume -------------------------------------------------------

using Window2 = AxisBox<2, double>;
using Line2 = Segment<2, double>;

// Whether a segment and a window have a point in common
bool meets(const Line2& s, const Window2& w) {
  for (int i = 0; i < 2; ++i) {
    if (std::max(s.a[i], s.b[i]) < w.lower[i] || w.upper[i] < std::min(s.a[i], s.b[i])) return false;
  }
  int left = 0, right = 0;
  for (const double x : {w.lower.x, w.upper.x}) {
    for (const double y : {w.lower.y, w.upper.y}) {
      const int side = orient2d_exact(s.a, s.b, {x, y});
      left += side > 0;
      right += side < 0;
    }
  }
  return left < 4 && right < 4;
}

// Whether p, an end of what is left, is `end` itself or the nearest point to where the segment meets a border
bool well_rounded(dvec2 p, dvec2 end, const Line2& s, const Window2& w) {
  if (p == end) return true;
  for (int i = 0; i < 2; ++i) {
    if (p[i] != w.lower[i] && p[i] != w.upper[i]) continue;
    if (s.a[i] == s.b[i]) continue;
    const int j = 1 - i;
    if (same(p[j], cut_coordinate_exact(s.a[i], s.b[i], s.a[j], s.b[j], p[i]))) return true;
  }
  return false;
}

KERNEL std::optional<Line2> by_codes(const Line2& line, const Window2& window) {
  return cohen_sutherland_2d::correctly_rounded(line, window);
}
KERNEL std::optional<Line2> by_parameters(const Line2& line, const Window2& window) {
  return liang_barsky::correctly_rounded(line, window);
}
KERNEL float cut_of(float a, float b, float other_a, float other_b, float c) {
  return cut_coordinate(a, b, other_a, other_b, c);
}

void clip_line(const Line2& line, const Window2& window, int round) {
  const auto cohen = by_codes(line, window);
  const auto liang = by_parameters(line, window);
  expect(cohen.has_value() == meets(line, window), "cohen_sutherland_2d decides", round);
  expect(liang.has_value() == cohen.has_value(), "liang_barsky decides", round);
  if (!cohen || !liang) return;
  expect(same(cohen->a, liang->a) && same(cohen->b, liang->b), "both clip alike", round);
  expect(well_rounded(cohen->a, line.a, line, window) && well_rounded(cohen->b, line.b, line, window),
         "cohen_sutherland_2d rounds to nearest", round);
  const auto back = by_codes({line.b, line.a}, window);
  expect(back && same(back->a, cohen->b) && same(back->b, cohen->a), "and back", round);
}

void lines() {
  const Window2 window{{-3, -2}, {4, 5}};
  // This one ran for ever
  clip_line({{0x1.a1397af76720fp+3, -0x1.8da5f95643af9p+2}, {-0x1.4272f5eece41ep+2, 0x1.1b4bf2ac875f2p+1}},
            window, -1);
  Random random(4);
  for (int i = 0; i < 5 * rounds; ++i) {
    // Aimed at a corner
    const dvec2 corner{i % 2 == 0 ? window.lower.x : window.upper.x,
                       i / 2 % 2 == 0 ? window.lower.y : window.upper.y};
    const dvec2 a = point(random);
    clip_line({a, corner + random.uniform(0, 2) * (corner - a)}, window, i);
  }
  // Floats: the exact point, beside a double midway between two of them
  for (int i = 0; i < rounds; ++i) {
    const auto f = [&random] { return static_cast<float>(coordinate(random)); };
    const float a = f(), b = f(), other_a = f(), other_b = f(),
                c = static_cast<float>(a + random.unit() * (b - a));
    if (a == b || other_a == other_b) continue;
    const float cut = cut_of(a, b, other_a, other_b, c);
    // Which of the two neighbours is nearer: the sign of the exact point less the middle
    for (const float beside : {std::nextafter(cut, -INFINITY), std::nextafter(cut, INFINITY)}) {
      const double middle = (double{cut} + double{beside}) / 2;
      const int side = orient2d_exact({a, other_a}, {b, other_b}, {c, middle}) * (a < b ? -1 : 1);
      expect(beside < cut ? side >= 0 : side <= 0, "cut_coordinate in float", i);
    }
  }
}

using Box = AxisBox<3, double>;
using Line3 = Segment<3, double>;
using Line4 = Segment<4, double>;  // of homogeneous points
using Crossing = cohen_sutherland_3d::Crossing<double>;
using Depth = cohen_sutherland_3d::Depth<double>;
using cohen_sutherland_3d::depth, cohen_sutherland_3d::ViewVolume;

KERNEL std::optional<Line3> by_codes(const Line3& line, const Box& box) {
  return cohen_sutherland_3d::correctly_rounded(line, box);
}
std::optional<Line3> by_parameters(const Line3& line, const Box& box) {
  return liang_barsky::box_correctly_rounded(line, box);
}
std::optional<Line4> by_codes(const Line4& line) {
  return cohen_sutherland_3d::correctly_rounded(line, ViewVolume{});
}
KERNEL double coordinate_of(const Crossing& c, double a, double b) { return coordinate_at(c, a, b); }
KERNEL bool negative_of(const Crossing& c, const Depth& a, const Depth& b) { return negative_at(c, a, b); }

void boxes_and_view_volumes() {
  Random random(5);
  const Box box{{-3, -2, -1}, {4, 5, 6}};
  for (int i = 0; i < rounds; ++i) {
    // Aimed at an edge
    const dvec3 a = point_in_space(random);
    const dvec3 edge{box.lower.x, box.upper.y, random.uniform(-2, 7)};
    const Line3 line{a, edge + random.uniform(0, 2) * (edge - a)};
    const auto cohen = by_codes(line, box);
    const auto liang = by_parameters(line, box);
    expect(cohen.has_value() == liang.has_value() &&
               (!cohen || (same(cohen->a, liang->a) && same(cohen->b, liang->b))),
           "in a box both clip alike", i);

    const auto homogeneous = [&random] { return glm::dvec4{point_in_space(random), coordinate(random)}; };
    const glm::dvec4 p = homogeneous(), q = homogeneous();
    const Crossing there{depth(p, Border::left), depth(q, Border::left)};
    if (negative(there.a) != negative(there.b)) {
      expect(same(coordinate_of(there, p.y, q.y), coordinate_at_exact(there, p.y, q.y)), "coordinate_at", i);
      const auto u = depth(p, Border::top), v = depth(q, Border::top);
      expect(negative_of(there, u, v) == negative_at_exact(there, u, v), "negative_at", i);
    }
    const auto rest = by_codes(Line4{p, q});
    const auto back = by_codes(Line4{q, p});
    expect(
        rest.has_value() == back.has_value() && (!rest || (same(rest->a, back->b) && same(rest->b, back->a))),
        "in the view volume there and back", i);
  }
}

// --- Crossings and circles -----------------------------------------------------------------------

namespace sh = sutherland_hodgman;

KERNEL dvec2 crossing_of(const Segment<2, double>& a, const Segment<2, double>& b) {
  return sh::crossing_point(a, b);
}
KERNEL int side_of(const Segment<2, double>& line, const Segment<2, double>& a, const Segment<2, double>& b) {
  return sh::side_of_crossing(line, a, b);
}

void crossings_of_lines() {
  Random random(6);
  for (int i = 0; i < rounds; ++i) {
    const Segment<2, double> a{point(random), point(random)}, b{point(random), point(random)};
    // A third line through the point where they cross, as near as doubles come
    const dvec2 at = crossing_of(a, b);
    for (int axis = 0; axis < 2; ++axis) {
      expect(same(at[axis], sh::detail::crossing_exact(a, b, axis)), "crossing_point", i);
    }
    const Segment<2, double> third{at, point(random)};
    expect(side_of(third, a, b) == -sh::detail::mixed_sides_exact(third, a, b) * sh::detail::turn_exact(a, b),
           "side_of_crossing", i);
  }
}

namespace circles = liang_barsky_circle;
using Circle = gradus::Circle<double>;
using Chord = Segment<2, double>;

std::optional<Chord> in_circle(const Chord& s, const Circle& c) { return circles::exact_decision(s, c); }
KERNEL int side_of(dvec2 p, const Circle& circle) { return circles::side(p, circle); }
KERNEL int reach_of(const Chord& s, const Circle& circle) { return circles::reach(s, circle); }

void segments_in_circles() {
  Random random(8);
  for (int i = 0; i < rounds; ++i) {
    const Circle circle{point(random), random.uniform(0.1, 5)};
    // Nearly a tangent: the foot of the perpendicular lies on the circle, as near as doubles come
    const double angle = random.uniform(0, 6.28);
    const dvec2 out{gradus::cos(angle), gradus::sin(angle)}, along{-out.y, out.x};
    const dvec2 foot = circle.centre + circle.radius * out;
    const Chord s{foot + coordinate(random) * along, foot + coordinate(random) * along};
    const auto& [from, to] = s;
    const auto side = [&](dvec2 p) {
      const Form<1> x = form_difference(p.x, circle.centre.x), y = form_difference(p.y, circle.centre.y),
                    r(circle.radius);
      return (x * x + y * y - r * r).sign();
    };
    expect(side_of(from, circle) == side(from) && side_of(foot, circle) == side(foot), "side of a circle", i);
    const int reach = from == to ? 0 : circles::ExactLine(s, circle).D.sign();
    expect(reach_of(s, circle) == reach, "reach of a circle", i);
    const auto past_foot = [&](dvec2 p) {
      return (form_difference(p.x, circle.centre.x) * form_difference(to.x, from.x) +
              form_difference(p.y, circle.centre.y) * form_difference(to.y, from.y))
          .sign();
    };
    const bool inside =
        side(from) <= 0 || side(to) <= 0 || (past_foot(from) < 0 && past_foot(to) > 0 && reach >= 0);
    const auto kept = in_circle(s, circle);
    const auto back = in_circle({to, from}, circle);
    expect(kept.has_value() == inside && back.has_value() == inside, "exact_decision decides", i);
    if (!kept || !back) continue;
    const auto& [first, last] = *kept;
    const auto& [back_first, back_last] = *back;
    expect(same(first, back_last) && same(last, back_first), "exact_decision there and back", i);
    // The points lie on the circle, as near as doubles of their size come
    for (const dvec2 p : {first, last}) {
      const dvec2 f = p - circle.centre;
      expect(side(p) <= 0 || std::abs(std::sqrt(f.x * f.x + f.y * f.y) - circle.radius) < 1e-14,
             "a point on the circle", i);
    }
  }
}

}  // namespace

int main() {
  error_free_transforms();
  pairs_of_doubles();
  signs();
  lines();
  boxes_and_view_volumes();
  crossings_of_lines();
  segments_in_circles();
  std::printf("elementary %016llx\n", static_cast<unsigned long long>(hash_of_elementary()));
  return report();
}
