// The promises of B-splines: points, new control points and pieces within their roundings of the exact ones,
// which come from Cox and de Boor's recursion in rationals.

#include "modeling/b_spline/b_spline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace b_spline;

constexpr std::size_t points = 5, degree = 3, knots = points + degree + 1;

/// x, y of the control points; the knots; t as a part of what there is, or which knot it is.
Input generate(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 2 * points + knots + 1);
  const auto begin = input.begin() + 2 * points, end = input.end() - 1;
  if (kind == Kind::ties || random.unit() < 0.4) {
    for (auto u = begin; u != end; ++u) *u = static_cast<double>(random.uniform_int(0, 3));
  }
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // One place but for the last digits, far from 0
    const double far = number(kind, random);
    for (auto u = begin; u != end; ++u) *u = random.unit() < 0.5 ? nudged(far, random) : far;
  }
  std::sort(begin, end);
  const double places[] = {0, 1, 2, 3, random.unit(), random.unit(), std::ldexp(random.unit(), -40)};
  input.back() = places[random.uniform_int(0, 6)];
  return input;
}

template <class T>
struct Given {
  Points<2, T> control;
  std::vector<T> u;
  T t{};

  Spline<2, T> spline() const { return {control, u}; }
};
template <class T>
Given<T> given_in(const std::vector<T>& numbers) {
  Given<T> given;
  for (std::size_t k = 0; k < points; ++k) given.control.push_back({numbers[2 * k], numbers[2 * k + 1]});
  given.u.assign(numbers.begin() + 2 * points, numbers.end() - 1);
  const T a = given.u[degree], b = given.u[points], part = numbers.back();
  // 2 and 3: the inner knot, and the number before it
  given.t = part <= 1   ? a + part * (b - a)
            : part == 2 ? given.u[points - 1]
                        : std::nextafter(given.u[points - 1], a);
  if (part == 1) given.t = b;
  return given;
}
/// Whether these numbers are an input; others must be refused.
template <class T>
bool taken(const std::vector<T>& numbers) {
  const Given<T> g = given_in(numbers);
  const T most = std::numeric_limits<T>::max() / 4;
  if (!std::all_of(numbers.begin(), numbers.end(), [&](T x) { return std::abs(x) <= most; })) return false;
  for (std::size_t i = degree + 1; i < knots; ++i)
    if (g.u[i] == g.u[i - degree - 1]) return false;
  return std::ranges::is_sorted(g.u) && g.u[degree] < g.u[points] && g.u[degree] <= g.t && g.t <= g.u[points];
}

/// N_i of degree d at t, by its definition; where the curve ends, from the left.
Exact cox(const std::vector<Exact>& u, std::size_t i, std::size_t d, const Exact& t, bool at_end) {
  if (d == 0) return (at_end ? u[i] < t && t <= u[i + 1] : u[i] <= t && t < u[i + 1]) ? Exact(1) : Exact(0);
  Exact sum(0);
  if (u[i] < u[i + d]) sum += (t - u[i]) / (u[i + d] - u[i]) * cox(u, i, d - 1, t, at_end);
  if (u[i + 1] < u[i + d + 1])
    sum += (u[i + d + 1] - t) / (u[i + d + 1] - u[i + 1]) * cox(u, i + 1, d - 1, t, at_end);
  return sum;
}
template <class T>
Point<2, Exact> right_of(const Points<2, T>& control, const std::vector<T>& knots_of_it, const Exact& t) {
  const std::vector<Exact> u(knots_of_it.begin(), knots_of_it.end());
  Point<2, Exact> sum(Exact(0));
  for (std::size_t i = 0; i < control.size(); ++i) {
    const Exact w = cox(u, i, u.size() - control.size() - 1, t, t == u[control.size()]);
    if (sign(w) != 0) sum += w * Point<2, Exact>(Exact(control[i].x), Exact(control[i].y));
  }
  return sum;
}

template <class T>
T largest_in(const Points<2, T>& control) {
  T most(0);
  for (const auto& p : control) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  return most;
}
/// What is allowed: so many u M, and so many of the smallest numbers.
template <class T>
Exact allowed(const Points<2, T>& control, std::size_t roundings, std::size_t smallest) {
  return Exact(roundings) * rounding_unit<T>() * Exact(largest_in(control)) +
         Exact(smallest) * Exact(std::numeric_limits<T>::denorm_min());
}
template <class P>
double off(const P& found, const Point<2, Exact>& right, const Exact& bound) {
  return std::max(in_bounds(abs(Exact(found.x) - right.x), bound),
                  in_bounds(abs(Exact(found.y) - right.y), bound));
}
const auto drop = [](const auto&) {};

const auto point_error = []<class T>(const std::vector<T>& numbers) -> double {
  const Given<T> g = given_in(numbers);
  const auto found = accepted([&] { return de_boor(g.spline(), g.t); });
  if (found.has_value() != taken(numbers)) return wrong;
  if (!found) return 0;
  if (de_boor(g.spline(), g.t, drop) != *found) return wrong;
  return off(*found, right_of(g.control, g.u, Exact(g.t)), allowed(g.control, 5 * degree, degree));
};
/// The same in ulp of the largest coordinate.
const auto ulp_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Given<T> g = given_in(numbers);
  const T most = largest_in(g.control);
  if (most == 0) return 0;
  return off(de_boor(g.spline(), g.t), right_of(g.control, g.u, Exact(g.t)), ulp_of<T>(Exact(most)));
};
const auto weights_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Given<T> g = given_in(numbers);
  return off(basis(g.spline(), g.t), right_of(g.control, g.u, Exact(g.t)),
             allowed(g.control, 6 * degree + 1, degree + 1));
};
/// Of the curve after a knot was inserted, at three places.
const auto inserted_error = []<class T>(const std::vector<T>& numbers) -> double {
  const Given<T> g = given_in(numbers);
  if (!taken(numbers) || times(g.u, g.t) > degree) return 0;
  const auto [q, v] = insert_knot(g.spline(), g.t);
  if (q.size() != points + 1 || !std::ranges::is_sorted(v)) return wrong;
  const Exact bound = allowed(g.control, 5, 1), a(g.u[degree]), b(g.u[points]);
  double most = 0;
  for (const double part : {0.0, 0.375, 1.0}) {
    const Exact t = a + (b - a) * Exact(part);
    most = std::max(most, off(right_of(q, v, t), right_of(g.control, g.u, t), bound));
  }
  return most;
};
/// All weights from 1/4 to 4, so that w is 16 at most.
const auto weighted_error = []<class T>(const std::vector<T>& numbers) -> double {
  const Given<T> g = given_in(numbers);
  if (!taken(numbers) || !(largest_in(g.control) <= std::numeric_limits<T>::max() / 4096)) return 0;
  const std::vector<T> weights{T(1), T(0.25), T(4), T(0.7), T(1)};
  const auto found = nurbs<2, T>(g.spline(), weights, g.t);
  const std::vector<Exact> u(g.u.begin(), g.u.end());
  Point<2, Exact> sum(Exact(0));
  Exact all(0);
  for (std::size_t i = 0; i < points; ++i) {
    const Exact w = Exact(weights[i]) * cox(u, i, degree, Exact(g.t), g.t == g.u[points]);
    sum += w * Point<2, Exact>(Exact(g.control[i].x), Exact(g.control[i].y));
    all += w;
  }
  return off(found, sum / all, allowed(g.control, (10 * degree + 4) * 16, 1024 * (degree + 1)));
};

/// Small fractions; the knots in order.
bool is_one_curve(const Input& input) {
  Given<Exact> g;
  for (std::size_t k = 0; k < points; ++k)
    g.control.push_back({Exact(input[2 * k]), Exact(input[2 * k + 1])});
  std::vector<double> sorted(input.begin() + 2 * points, input.begin() + 2 * points + knots);
  std::ranges::sort(sorted);
  g.u.assign(sorted.begin(), sorted.end());
  for (std::size_t i = degree + 1; i < knots; ++i)
    if (g.u[i] == g.u[i - degree - 1]) return true;
  if (g.u[degree] == g.u[points]) return true;
  const Exact a = g.u[degree], b = g.u[points];
  const auto pieces = bezier_pieces(g.spline());
  if (pieces.front().from != a || pieces.back().to != b) return false;
  for (const auto& piece : pieces) {
    for (const Exact& s : {Exact(0), Exact(2, 5), Exact(7, 8)}) {
      const Exact t = piece.from + (piece.to - piece.from) * s;
      const auto right = right_of(g.control, g.u, t);
      Points<2, Exact> rest = piece.b;  // de Casteljau's rounds
      for (std::size_t m = rest.size() - 1; m > 0; --m)
        for (std::size_t i = 0; i < m; ++i) rest[i] += s * (rest[i + 1] - rest[i]);
      if (rest[0] != right || de_boor(g.spline(), t) != right || basis(g.spline(), t) != right) return false;
      if (times(g.u, t) > degree) continue;
      const auto [q, v] = insert_knot(g.spline(), t);
      const Exact other = a + (b - a) * s;
      if (right_of(q, v, other) != right_of(g.control, g.u, other)) return false;
    }
  }
  return true;
}

}  // namespace

Domain b_spline() {
  const auto promise = [](std::string name, std::string states, std::string unit, double bound,
                          std::int64_t cases, auto judge) {
    return Property{
        .name = std::move(name),
        .states = std::move(states),
        .unit = std::move(unit),
        .bound = bound,
        .numbers = 2 * points + knots + 1,
        .generate = at_every_scale(generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}),
        .error = in_both(judge),
        .traps = {{"one span, clamped", {0, 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 0, 0, 0, 1, 2, 2, 2, 2, 0.3}},
                  {"the end of knots that go on",
                   {0, 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 1, 2, 3, 4, 5, 6, 7, 8, 1}},
                  {"a double knot at an end that goes on",
                   {0, 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 1, 2, 3, 5, 5, 6, 7, 8, 1}},
                  {"a jump", {0, 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2}},
                  {"no span", {0, 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 0, 0, 1, 1, 1, 2, 2, 2, 0.5}},
                  {"one knot five times", {0, 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 0, 0, 0, 0, 1, 2, 2, 2, 0.5}},
                  {"no number", {std::nan(""), 0, 1, 2, 3, 1, 4, 0, 5, 5, 0, 0, 0, 0, 1, 2, 2, 2, 2, 0.5}}},
        .cases = cases};
  };
  Property relation =
      exact_relation("one_curve", "points, weights, inserted knots and Bézier pieces are those of one curve",
                     2 * points + knots, is_one_curve);
  relation.cases = 500;
  return {"b_spline",
          {promise("points", "de Boor's point within 5 n u M of the exact one, M the largest coordinate",
                   "of the bound", 1, 600, point_error),
           promise("cubic", "of degree 3 within 4 ulp of M", "ulp", 4, 600, ulp_error),
           promise("weights", "the mean by Cox and de Boor's weights within (6 n + 1) u M", "of the bound", 1,
                   300, weights_error),
           promise("inserted", "with a knot more it is the curve within 5 u M", "of the bound", 1, 150,
                   inserted_error),
           promise("weighted", "a rational curve's point within (10 n + 4) u M w", "of the bound", 1, 200,
                   weighted_error),
           relation}};
}

}  // namespace gradus::stress
