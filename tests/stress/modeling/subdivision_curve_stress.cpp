// The promises of corner cutting: every point is the exact one but for roundings, and rounds never leave the
// curve.

#include "modeling/subdivision_curve/subdivision_curve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "stress/core/integers.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace subdivision_curve;

constexpr std::size_t corners = 4;
constexpr int most_rounds = 6;

/// x, y of four corners; rounds, below 0 for a closed polygon.
Input generate(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 2 * corners + 1);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The corners on a line, but for the last places, or one on another
    const std::size_t from = kind == Kind::grazing ? 1 : 2;
    const double t = kind == Kind::grazing ? 0 : random.uniform(-2, 2);
    for (std::size_t k = 0; k < 2; ++k)
      input[2 * from + k] = nudged(input[k] + t * (input[2 + k] - input[k]), random);
  }
  const auto rounds = static_cast<double>(random.uniform_int(1, most_rounds));
  input.back() = random.unit() < 0.5 ? rounds : -rounds;
  return input;
}

struct Given {
  std::vector<dvec2> polygon;
  int rounds;
  Ends ends;
};
Given given_in(const Input& i) {
  Given given{{}, 0, i.back() < 0 ? Ends::closed : Ends::open};
  for (std::size_t k = 0; k < corners; ++k) given.polygon.push_back({i[2 * k], i[2 * k + 1]});
  given.rounds = static_cast<int>(std::clamp(std::abs(std::round(i.back())), 1.0, double{most_rounds}));
  return given;
}

/// One coordinate of the points after so many rounds, times 4^rounds, in whole numbers of fixed().
std::vector<Integer> exact_rounds(std::vector<Integer> points, int rounds, bool closed) {
  for (; rounds > 0; --rounds) {
    std::vector<Integer> next;
    for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k) {
      const Integer &a = points[k], &b = points[(k + 1) % points.size()];
      next.push_back(3 * a + b);
      next.push_back(a + 3 * b);
    }
    points = std::move(next);
  }
  return points;
}

/// In parts of 2 u M per round and the smallest positive number.
double points_error(const Input& i) {
  if (!std::isfinite(i.back())) return 0;
  const auto [polygon, rounds, ends] = given_in(i);
  const bool taken = all_finite(i);
  std::vector<dvec2> found;
  try {
    found = chaikin<double>(polygon, rounds, ends);
    if (!taken || chaikin<double>(polygon, rounds, ends, [](const auto&) {}) != found) return wrong;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  double size = 0, most = 0;
  for (std::size_t k = 0; k < 2 * corners; ++k) size = std::max(size, std::abs(i[k]));
  const Integer scale = Integer(1) << static_cast<unsigned>(2 * rounds);
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<Integer> exact;
    for (const dvec2 p : polygon) exact.push_back(fixed(p[axis]));
    exact = exact_rounds(exact, rounds, ends == Ends::closed);
    if (exact.size() != found.size()) return wrong;
    // 2 u M k, and one of the smallest numbers per round: fixed() counts in these
    const Integer allowed = (fixed(size) * rounds * scale >> 52) + Integer(rounds) * scale;
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Integer off = abs(Integer(fixed(found[k][axis]) * scale - exact[k]));
      most = std::max(most, (Integer(off * 1000) / allowed).convert_to<double>() / 1000);
    }
  }
  return most;
}

/// A parabola's three points, and t.
Input arc(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 7);
  const double parts[] = {0, 1, 0.5, random.unit(), random.unit(), std::ldexp(random.unit(), -40)};
  input.back() = parts[random.uniform_int(0, 5)];
  return input;
}

/// A point of it, in parts of 8 u M and eight of the smallest numbers.
double arc_error(const Input& i) {
  if (!all_finite(i) || !(0 <= i[6] && i[6] <= 1)) return 0;
  const dvec2 found = Parabola<double>{{i[0], i[1]}, {i[2], i[3]}, {i[4], i[5]}}.at(i[6]);
  const ExactScope scope;
  const Exact t(i[6]), s = Exact(1) - t;
  double size = 0, most = 0;
  for (std::size_t k = 0; k < 6; ++k) size = std::max(size, std::abs(i[k]));
  const Exact bound = Exact(8) * (Exact(0x1p-53) * Exact(size) + Exact(0x1p-1074));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Bernstein's polynomials, not the rounds of dividing
    const Exact right =
        s * s * Exact(i[axis]) + Exact(2) * s * t * Exact(i[2 + axis]) + t * t * Exact(i[4 + axis]);
    most = std::max(most, in_bounds(abs(Exact(found[static_cast<int>(axis)]) - right), bound));
  }
  return most;
}

// --- Exact relations

using P = Point<Exact>;
std::vector<P> exact_polygon(const Input& i) {
  std::vector<P> polygon;
  for (std::size_t k = 0; k < corners; ++k) polygon.push_back({Exact(i[2 * k]), Exact(i[2 * k + 1])});
  return polygon;
}

/// The second differences of a round are a quarter of those before, each twice.
bool differences_fall(const Input& i) {
  const std::vector<P> before = exact_polygon(i), after = chaikin<Exact>(before, 1, Ends::closed);
  const auto second = [](const std::vector<P>& p, std::size_t k) {
    return p[(k + p.size() - 1) % p.size()] - Exact(2) * p[k] + p[(k + 1) % p.size()];
  };
  for (std::size_t k = 0; k < corners; ++k) {
    const P whole = second(before, k);
    for (const std::size_t near : {2 * k + 2 * corners - 1, 2 * k + 2 * corners}) {
      if (Exact(4) * second(after, near % after.size()) != whole) return false;
    }
  }
  return true;
}

/// The blending functions of a uniform quadratic B-spline: (1 - t)^2 / 2, 1/2 + t - t^2, t^2 / 2.
bool arcs_are_the_splines(const Input& i) {
  const std::vector<P> p = exact_polygon(i);
  bool same = true;
  std::size_t k = 1;
  limit<Exact>(p, Ends::open, [&](const Parabola<Exact>& arc) {
    for (const double part : {0.0, 0.25, 0.375, 1.0}) {
      const Exact t(part), s = Exact(1) - t, half(0.5);
      const P right = half * s * s * p[k - 1] + (half + t - t * t) * p[k] + half * t * t * p[k + 1];
      same = same && arc.at(t) == right;
    }
    ++k;
  });
  return same && k == corners - 1;
}

}  // namespace

Domain subdivision_curve() {
  return {
      "subdivision_curve",
      {{.name = "points",
        .states = "coordinates within 2 u M per round of the exact ones, M the largest, at every size",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 2 * corners + 1,
        .generate = at_every_scale(generate, {0, 1, 2, 3, 4, 5, 6, 7}),
        .error = points_error,
        .traps = {{"all corners one", {1, 1, 1, 1, 1, 1, 1, 1, 6}},
                  {"the largest numbers", {1.7e308, 1.7e308, -1.7e308, 1.7e308, 1.7e308, -1.7e308, 0, 0, -6}},
                  {"the smallest numbers", {5e-324, 0, 0, 5e-324, 1e-323, 0, 0, 0, 6}},
                  {"a corner that is no number", {std::nan(""), 0, 1, 1, 2, 0, 3, 1, 2}}}},
       {.name = "arcs",
        .states = "a point of a parabola within 8 u M of the exact one, M its largest coordinate",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 7,
        .generate = at_every_scale(arc, {0, 1, 2, 3, 4, 5}),
        .error = arc_error,
        .traps = {{"its end", {1, 2, 3, 4, 5, 6, 1}},
                  {"the largest numbers", {1.7e308, 0, -1.7e308, 0, 1.7e308, 0, 0.5}}}},
       exact_relation("differences", "second differences fall to a quarter, each twice", 2 * corners,
                      differences_fall),
       exact_relation("spline",
                      "arcs have the points that the blending functions of a quadratic B-spline give",
                      2 * corners, arcs_are_the_splines)}};
}

}  // namespace gradus::stress
