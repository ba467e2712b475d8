// The promises of Bézier curves: points, parts, polygons and chords within their roundings of the exact ones,
// the polynomial taken by differences and Horner's rule; and never a point outside the hull.

#include "modeling/bezier_curve/compensated.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace bezier_curve;

constexpr std::size_t count = 6, degree = count - 1;

/// x, y of the control points; t, or a tolerance in parts of the largest coordinate.
Input generate(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 2 * count + 1);
  if (kind == Kind::near_degenerate || kind == Kind::grazing || kind == Kind::ties) {
    // Coincident control points, or all on a line but for the last places
    for (std::size_t k = 2; k < count; ++k) {
      const double t =
          kind == Kind::ties ? static_cast<double>(random.uniform_int(0, 1)) : random.uniform(-2, 3);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double on_line = input[axis] + t * (input[2 + axis] - input[axis]);
        input[2 * k + axis] = kind == Kind::ties ? on_line : nudged(on_line, random);
      }
    }
  }
  const double places[] = {0, 1, 0.5, random.unit(), random.unit(), std::ldexp(random.unit(), -40)};
  input.back() = places[random.uniform_int(0, 5)];
  return input;
}

template <class T>
Points<2, T> control_in(const std::vector<T>& numbers) {
  Points<2, T> control;
  for (std::size_t k = 0; k < count; ++k) control.push_back({numbers[2 * k], numbers[2 * k + 1]});
  return control;
}

/// One coordinate of a curve at an exact place.
template <class T>
Exact right_of(const Points<2, T>& control, int axis, const Exact& t) {
  std::vector<Exact> rest;
  for (const auto& p : control) rest.emplace_back(p[axis]);
  std::vector<Exact> coefficients;
  Exact ways(1);
  const std::int64_t n = std::ssize(rest) - 1;
  for (std::int64_t k = 0; k <= n; ++k) {
    coefficients.push_back(ways * rest[0]);
    for (std::size_t i = 0; i + 1 < rest.size(); ++i) rest[i] = rest[i + 1] - rest[i];
    rest.pop_back();
    ways = ways * Exact(n - k) / Exact(k + 1);
  }
  Exact sum(0);
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * t + coefficients[k];
  return sum;
}

/// What is allowed: so many u M, and so many of the smallest numbers.
template <class T>
Exact allowed(const Points<2, T>& control, const Exact& roundings, std::size_t smallest) {
  return roundings * rounding_unit<T>() * Exact(largest_of<2, T>(control)) +
         Exact(smallest) * Exact(std::numeric_limits<T>::denorm_min());
}
template <class T>
double off(const glm::vec<2, T>& found, const Points<2, T>& control, const Exact& t, const Exact& bound) {
  double most = 0;
  for (int axis = 0; axis < 2; ++axis)
    most = std::max(most, in_bounds(abs(Exact(found[axis]) - right_of(control, axis, t)), bound));
  return most;
}
/// The worst of a curve that should be the other one from t = `from` to `to`.
template <class T>
double off_curve(const Points<2, T>& part, const Points<2, T>& whole, const Exact& from, const Exact& to,
                 const Exact& bound) {
  double most = 0;
  for (const double place : {0.0, 0.375, 0.5, 1.0}) {
    const Exact s(place);
    for (int axis = 0; axis < 2; ++axis)
      most = std::max(
          most,
          in_bounds(abs(right_of(part, axis, s) - right_of(whole, axis, from + (to - from) * s)), bound));
  }
  return most;
}

/// Whether these numbers are an input; others must be refused.
template <class T>
bool taken(const std::vector<T>& numbers) {
  const T most = std::numeric_limits<T>::max() / 4;
  return std::ranges::all_of(numbers, [&](T x) { return std::abs(x) <= most; }) && 0 <= numbers.back() &&
         numbers.back() <= 1;
}
const auto drop = [](const auto&) {};

const auto point_error = []<class T>(const std::vector<T>& numbers) -> double {
  const Points<2, T> control = control_in(numbers);
  const T t = numbers.back();
  const auto found = accepted([&] { return de_casteljau<2, T>(control, t); });
  if (found.has_value() != taken(numbers)) return wrong;
  if (!found) return 0;
  if (de_casteljau<2, T>(control, t, drop) != *found) return wrong;
  return off(*found, control, Exact(t), allowed(control, Exact(5, 2) * Exact(degree), degree));
};
/// In double alone; in parts of what a coordinate itself may lose, and of the little that may be lost
/// besides.
const auto compensated_error = []<class T>(const std::vector<T>& given) -> double {
  const Input numbers(given.begin(), given.end());
  const Points<2, double> control = control_in(numbers);
  const double t = numbers.back();
  const auto found = accepted([&] { return compensated<2>(control, t); });
  if (found.has_value() != (taken(numbers) && largest_of<2, double>(control) <= largest_compensated))
    return wrong;
  if (!found) return 0;
  if (compensated<2>(control, t, drop) != *found) return wrong;
  const Exact unit = rounding_unit<double>(), squares(degree * degree);
  double most = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const Exact right = right_of(control, axis, Exact(t));
    const Exact bound = unit * abs(right) +
                        Exact(20) * squares * unit * unit * Exact(largest_of<2, double>(control)) +
                        squares * Exact(0x1p-960);
    most = std::max(most, in_bounds(abs(Exact((*found)[axis]) - right), bound));
  }
  return most;
};
const auto weights_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Points<2, T> control = control_in(numbers);
  const T t = numbers.back();
  const auto found = bernstein<2, T>(control, t);
  return off(found, control, Exact(t), allowed(control, Exact(3 * degree + 4), degree + 1));
};
const auto halves_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Points<2, T> control = control_in(numbers);
  const T t = numbers.back();
  const auto [first, rest] = split<2, T>(control, t);
  const bool meet =
      first.front() == control.front() && first.back() == rest.front() && rest.back() == control.back();
  if (!meet || rest.front() != de_casteljau<2, T>(control, t)) return wrong;
  const Exact bound = allowed(control, Exact(5, 2) * Exact(degree), degree), at(t);
  return std::max(off_curve(first, control, Exact(0), at, bound),
                  off_curve(rest, control, at, Exact(1), bound));
};
const auto raised_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Points<2, T> control = control_in(numbers), raised = raise_degree<2, T>(control);
  return off_curve(raised, control, Exact(0), Exact(1), allowed(control, Exact(3), 1));
};
/// In parts of the tolerance with its roundings, at three places of each piece.
const auto chords_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Points<2, T> control = control_in(numbers);
  const T part = std::max(numbers.back(), T(1) / 256), least = std::numeric_limits<T>::min();
  const T tolerance = std::max(part * largest_of<2, T>(control), least);
  double most = 0;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Flattened<2, T>>) {
      const auto& [from, to, b] = step.piece;
      const Exact cuts(-std::ilogb(to - from));
      const Exact bound =
          Exact(tolerance) + Exact(2) * allowed(control, Exact(5, 2) * Exact(degree) * cuts, 100);
      for (const double place : {0.25, 0.5, 0.75}) {
        const Exact s(place), t = Exact(from) + (Exact(to) - Exact(from)) * s;
        Exact square(0);
        for (int axis = 0; axis < 2; ++axis) {
          const Exact chord = (Exact(1) - s) * Exact(b.front()[axis]) + s * Exact(b.back()[axis]);
          const Exact apart = right_of(control, axis, t) - chord;
          square += apart * apart;
        }
        most = std::max(most, in_bounds(square, bound * bound));
      }
    }
  };
  const auto line = flatten<2, T>(control, tolerance, watch);
  return line.front() == control.front() && line.back() == control.back() ? most : wrong;
};

// --- Exact relations

Points<2, Exact> exact_control(const Input& input) {
  Points<2, Exact> control;
  for (std::size_t k = 0; k < count; ++k) control.push_back({Exact(input[2 * k]), Exact(input[2 * k + 1])});
  return control;
}

/// A line that leaves all control points on one side leaves the curve there.
bool stays_in_hull(const Input& input) {
  const Points<2, Exact> control = exact_control(input);
  Points<2, Exact> curve;
  for (const double t : {0.0, 0.25, 0.5, 0.875}) curve.push_back(de_casteljau<2, Exact>(control, Exact(t)));
  for (const auto& a : control) {
    for (const auto& b : control) {
      const auto left = [&](const auto& p) { return orient2d(a, b, p) >= 0; };
      if (a != b && std::ranges::all_of(control, left) && !std::ranges::all_of(curve, left)) return false;
    }
  }
  return true;
}
/// Both points, both parts and two degrees more.
bool is_one_polynomial(const Input& input) {
  const Points<2, Exact> control = exact_control(input);
  const Points<2, Exact> raised = raise_degree<2, Exact>(raise_degree<2, Exact>(control));
  const Exact t(3, 8);
  const auto [first, rest] = split<2, Exact>(control, t);
  for (const double place : {0.0, 0.4, 1.0}) {
    const Exact s(place), beyond = t + (Exact(1) - t) * s;
    for (int axis = 0; axis < 2; ++axis) {
      const Exact right = right_of(control, axis, s);
      if (de_casteljau<2, Exact>(control, s)[axis] != right ||
          bernstein<2, Exact>(control, s)[axis] != right || right_of(raised, axis, s) != right ||
          right_of(first, axis, s) != right_of(control, axis, t * s) ||
          right_of(rest, axis, s) != right_of(control, axis, beyond))
        return false;
    }
  }
  return true;
}

}  // namespace

Domain bezier_curve() {
  const auto promise = [](std::string name, std::string states, std::int64_t cases, auto judge) {
    return Property{
        .name = std::move(name),
        .states = std::move(states),
        .unit = "of the bound",
        .bound = 1,
        .numbers = 2 * count + 1,
        .generate = at_every_scale(generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}),
        .error = in_both(judge),
        .traps = {{"all control points one", {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0.3}},
                  {"a closed curve", {0, 0, 9, 9, 0, 9, 9, 0, 4, 4, 0, 0, 0.7}},
                  {"the largest numbers",
                   {4e307, 4e307, -4e307, 4e307, 4e307, -4e307, 0, 0, 4e307, 1, 4e307, 4e307, 0.9}},
                  {"the smallest numbers", {5e-324, 0, 0, 5e-324, 1e-323, 0, 0, 0, 0, 0, 0, 5e-324, 0.5}},
                  {"beyond the largest", {1e308, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5}},
                  {"no number", {std::nan(""), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5}}},
        .cases = cases};
  };
  const auto fewer = [](Property property) {
    property.cases = 1000;
    return property;
  };
  return {
      "bezier_curve",
      {promise("points", "de Casteljau's point within 2.5 n u M of the exact one, M the largest coordinate",
               1000, point_error),
       promise("compensated", "compensated points within u |p| + 20 n² u² M of the exact ones", 1000,
               compensated_error),
       promise("weights", "the mean by Bernstein polynomials within (3 n + 4) u M", 1000, weights_error),
       promise("halves", "both parts are the curve within 2.5 n u M, and meet bit for bit", 150,
               halves_error),
       promise("raised", "one degree higher it is the curve within 3 u M", 200, raised_error),
       promise("chords", "within the tolerance of the chord, but for 2.5 n u M per cut", 100, chords_error),
       fewer(exact_relation("polynomial", "points, parts and higher degrees are those of one polynomial",
                            2 * count, is_one_polynomial)),
       exact_relation("hull", "no line has all control points on one side and a point of the curve beyond",
                      2 * count, stays_in_hull)}};
}

}  // namespace gradus::stress
