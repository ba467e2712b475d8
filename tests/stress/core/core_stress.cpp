// The promises of what all topics stand on: lengths, turns and cuts along the axes.

#include <algorithm>
#include <array>

#include "core/arithmetic/turn.hpp"
#include "core/arithmetic/unbounded.hpp"
#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/core/digits.hpp"
#include "stress/core/exact_property.hpp"
#include "stress/core/integers.hpp"

namespace gradus::stress {
namespace {

// --- Lengths and directions ---

Input vector(Kind kind, Random& random) {
  Input input = any_numbers(3, kind, random);
  // Nearly along an axis
  if (kind == Kind::near_degenerate) input[static_cast<std::size_t>(random.uniform_int(0, 2))] *= 0x1p-600;
  if (kind == Kind::grazing) input[0] = nudged(input[1], random);
  return input;
}
Digits exact_length(dvec3 v) {
  const Digits x(v.x), y(v.y), z(v.z);
  return sqrt(Digits(x * x + y * y + z * z));
}

double length_error(const Input& i) {
  const dvec3 v{i[0], i[1], i[2]};
  if (!all_finite(i)) return std::isfinite(length_of(v)) ? wrong : 0;
  const Directed<double> both = directed(v);
  if (both.direction != unit_vector(v)) return wrong;
  const Digits exact = exact_length(v);
  // At the end of the range an ulp decides whether it is left
  const auto error = [&](double found) {
    return std::isinf(found) && exact >= Digits(0x1.ffffffffffffep1023) ? 0 : ulps(found, exact);
  };
  return std::max(error(length_of(v)), error(both.length));
}

double direction_error(const Input& i) {
  const dvec3 v{i[0], i[1], i[2]}, found = unit_vector(v);
  if (!all_finite(i)) return 0;
  if (v == dvec3{0}) return found == v ? 0 : wrong;
  const Digits length = exact_length(v);
  const auto error = [&](double part, double x) { return ulps(part, Digits(Digits(x) / length)); };
  return std::max({error(found.x, v.x), error(found.y, v.y), error(found.z, v.z)});
}

// --- Turns ---

Input angle(Kind kind, Random& random) {
  Input input{number(kind, random)};
  if (kind == Kind::near_degenerate) input[0] = sized(random, -40, 0);
  if (kind == Kind::grazing) input[0] = nudged(1.5707963267948966 * std::round(input[0]), random);
  return input;
}

/// Of the sine and the cosine, or of the versine.
double turn_error(const Input& i, bool of_versine) {
  Turn<double> found{};
  try {
    found = turn(i[0]);
  } catch (const ContractViolation&) {
    return std::isfinite(i[0]) ? wrong : 0;
  }
  if (!std::isfinite(i[0])) return wrong;
  if (of_versine) {
    const Digits angle = reduced(i[0]), half = sin(Digits(angle / 2));
    return ulps(found.versine, Digits(2 * half * half));
  }
  const Digits angle = reduced(i[0]);
  return std::max(ulps(found.sin, Digits(sin(angle))), ulps(found.cos, Digits(cos(angle))));
}

// --- Cuts ---

/// A cut to make: the ends along the border's axis, along the other, and the border between the ends.
template <class T>
struct Cut {
  T a, b, from, to, c;

  bool is_one() const {
    return std::isfinite(a) && std::isfinite(b) && std::isfinite(from) && std::isfinite(to) && a != b &&
           std::min(a, b) <= c && c <= std::max(a, b);
  }
  bool at_end() const { return c == a || c == b || from == to; }
  T made() const { return cut_coordinate(a, b, from, to, c); }
  Cut back() const { return {b, a, to, from, c}; }
  // from + (c - a) (to - from) / (b - a)
  Integer above() const {
    const Integer length = fixed(b) - fixed(a);
    return fixed(from) * length + (fixed(c) - fixed(a)) * (fixed(to) - fixed(from));
  }
  Integer below() const { return times_one(fixed(b) - fixed(a)); }
  bool needs_exact() const
    requires std::same_as<T, double>
  {
    return is_one() && !at_end() && !cut_coordinate_filtered(a, b, from, to, c);
  }
};
template <class T = double>
Cut<T> cut_of(const Input& i) {
  const auto at = [&](std::size_t k) { return static_cast<T>(i[k]); };
  return {at(0), at(1), at(2), at(3), at(4)};
}
bool same_bits(double x, double y) { return x == y && std::signbit(x) == std::signbit(y); }

void put_between(Input& i) { i[4] = std::clamp(i[4], std::min(i[0], i[1]), std::max(i[0], i[1])); }

/// Half way along, from an odd sum: midway between two doubles.
Input tied_cut(Random& random) {
  const double a = random.uniform(1, 8),
               size = std::ldexp(1.0, static_cast<int>(random.uniform_int(-40, 40)));
  const std::int64_t low = std::int64_t{1} << 52, high = 2 * low - 1;
  const std::int64_t first = random.uniform_int(low, high), second = random.uniform_int(low, high);
  const auto odd = static_cast<double>(second - (first + second + 1) % 2);
  return {-a, a, static_cast<double>(first) * size, odd * size, 0};
}
/// The end far away, the cut near zero: all digits of the sum cancel but a few.
Input cancelling_cut(Random& random) {
  const double a = -std::ldexp(random.uniform(1, 2), 20), b = std::ldexp(random.uniform(1, 2), 20);
  const double c = random.uniform(-1, 1), slope = random.uniform(-4, 4);
  return {a, b, slope * (a - c), slope * (b - c), c};
}
Input cut(Kind kind, Random& random) {
  Input input = any_numbers(5, kind, random);
  if (kind == Kind::near_degenerate && random.unit() < 0.5) {
    input[1] = nudged(input[0], random);
    input[3] = nudged(input[2], random);
  } else if (kind == Kind::near_degenerate) {
    input = tied_cut(random);
    input[4] = sized(random, -200, -90);
  } else if (kind == Kind::grazing && random.unit() < 0.5) {
    // Through 0, but for the last places
    input[1] = -input[0], input[3] = nudged(-input[2], random), input[4] = 0;
  } else if (kind == Kind::grazing) {
    input = cancelling_cut(random);
  } else if (kind == Kind::ties && random.unit() < 0.5) {
    input = tied_cut(random);
  }
  put_between(input);
  return input;
}
/// Numbers of like size, or mixed from 2^-299 to 2^299.
Input plain_cut(Kind kind, Random& random) {
  Input input(5);
  for (double& x : input) x = kind == Kind::random ? random.uniform(-1000, 1000) : sized(random, -299, 299);
  const double t = random.unit();
  input[4] = input[0] * (1 - t) + input[1] * t;
  put_between(input);
  return input;
}
/// Down to where floats underflow, up to where they end; or midway between two of them, a hair beside.
Input float_cut(Kind kind, Random& random) {
  if (random.unit() < 0.3) return {-1, 1, 0x1.000002p0, 0x1.000004p0, sized(random, -120, -60)};
  Input input = cut(kind, random);
  const auto exponent = static_cast<int>(random.uniform_int(-155, 122));
  for (double& x : input) {
    const double scaled = std::ldexp(x, random.unit() < 0.7 ? exponent : 0);
    constexpr double most = std::numeric_limits<float>::max();
    x = static_cast<double>(static_cast<float>(std::clamp(scaled, -most, most)));
  }
  put_between(input);
  return input;
}

double cut_error(const Input& i) {
  const Cut<double> cut = cut_of(i);
  if (!cut.is_one()) return 0;
  const double found = cut.made();
  const auto sure = cut_coordinate_filtered(cut.a, cut.b, cut.from, cut.to, cut.c);
  const bool same = same_bits(found, cut.back().made()) &&
                    same_bits(found, cut_coordinate_exact(cut.a, cut.b, cut.from, cut.to, cut.c)) &&
                    (!sure || *sure == found);
  const bool between = std::min(cut.from, cut.to) <= found && found <= std::max(cut.from, cut.to);
  const bool minus_zero = found == 0 && std::signbit(found);
  return same && between && !minus_zero && is_nearest(found, cut.above(), cut.below()) ? 0 : wrong;
}
double float_cut_error(const Input& i) {
  for (const double x : i) {
    if (!(std::abs(x) <= double{std::numeric_limits<float>::max()})) return 0;
  }
  const Cut<float> cut = cut_of<float>(i);
  if (!cut.is_one()) return 0;
  const float found = cut.made();
  const bool minus_zero = found == 0 && std::signbit(found);
  return found == cut.back().made() && !minus_zero && is_nearest(found, cut.above(), cut.below()) ? 0 : wrong;
}

bool is_tie(const Input& i) {
  const Cut<double> cut = cut_of(i);
  if (!cut.is_one()) return false;
  const Integer at = fixed(cut.made()) * cut.below(), exact = times_one(cut.above());
  const double next = std::nextafter(cut.made(), exact < at ? -wrong : wrong);
  return at != exact && at + fixed(next) * cut.below() == 2 * exact;
}

int sign_of(std::strong_ordering order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

/// Where a segment stands where it is cut, against borders there, a few steps beside it, and at its ends.
double place_error(const Input& i) {
  const Cut<double> cut = cut_of(i);
  if (!cut.is_one()) return 0;
  const Segment<2, double> segment{{cut.a, cut.from}, {cut.b, cut.to}};
  const double at = cut_point(segment, 0, cut.c).y;
  for (const double border : {at, std::nextafter(at, wrong), std::nextafter(at, -wrong), cut.from, cut.to}) {
    const Integer beyond = times_one(cut.above()) - fixed(border) * cut.below();
    const int right = cut.below() < 0 ? -beyond.sign() : beyond.sign();
    if (std::isfinite(border) && sign_of(compare_at_cut(segment, 0, cut.c, 1, border, at)) != right)
      return wrong;
  }
  return 0;
}

/// A segment from a to b and a corner: a.x, b.x, corner's x, then y. Often the corner lies on it or nearly
/// so.
Input corner(Kind kind, Random& random) {
  Input input = any_numbers(6, kind, random);
  if (kind != Kind::near_degenerate && kind != Kind::grazing) return input;
  const double t = kind == Kind::grazing ? 0.5 : random.unit();
  for (const std::size_t k : {0U, 3U}) {
    const double on = input[k] * (1 - t) + input[k + 1] * t;
    input[k + 2] = random.unit() < 0.5 ? on : nudged(on, random);
    if (kind == Kind::grazing) input[k + 1] = 2 * input[k + 2] - input[k];
  }
  return input;
}
double order_error(const Input& i) {
  if (!all_finite(i) || i[0] == i[1] || i[3] == i[4]) return 0;
  const auto x = [&](std::size_t k, std::size_t l) { return Integer(fixed(i[k]) - fixed(i[l])); };
  const Integer length = x(1, 0), height = x(4, 3);
  const int right = Integer(x(2, 0) * height - x(5, 3) * length).sign() * length.sign() * height.sign();
  const int found = sign_of(compare_cuts(i[0], i[1], i[2], i[3], i[4], i[5]));
  const int back = sign_of(compare_cuts(i[1], i[0], i[2], i[4], i[3], i[5]));
  const int other_axis = sign_of(compare_cuts(i[3], i[4], i[5], i[0], i[1], i[2]));
  return found == right && back == -right && other_axis == -right ? 0 : wrong;
}
bool divisions_mislead(const Input& i) {
  const double u = (i[2] - i[0]) / (i[1] - i[0]), v = (i[5] - i[3]) / (i[4] - i[3]);
  return (u > v) - (u < v) != sign_of(compare_cuts(i[0], i[1], i[2], i[3], i[4], i[5]));
}

// --- Numbers without bounds ---

/// Where plain arithmetic stays in range, numbers without bounds have its bits.
template <class T>
double unbounded_error(const Input& i) {
  constexpr int reach = std::numeric_limits<T>::max_exponent / 2 - 2;
  const T least = std::ldexp(T{1}, -reach), most = std::ldexp(T{2}, reach);
  for (const double x : i) {
    if (x != 0 && !(double{least} <= std::abs(x) && std::abs(x) < double{most})) return 0;
  }
  const T a = static_cast<T>(i[0]), b = static_cast<T>(i[1]);
  const Unbounded<T> p(a), q(b);
  const auto same = [](Unbounded<T> x, T y) { return same_bits(double{x.in_range()}, double{y}); };
  const bool right = same(p + q, a + b) && same(p - q, a - b) && same(p * q, a * b) &&
                     (b == 0 || same(p / q, a / b)) && (p < q) == (a < b) && (p > q) == (a > b);
  return right ? 0 : wrong;
}
Input unbounded_numbers(Kind kind, Random& random) {
  const int reach = random.unit() < 0.5 ? 62 : 510;
  Input input{sized(random, -reach, reach), sized(random, -reach, reach)};
  if (kind == Kind::ties)
    input[static_cast<std::size_t>(random.uniform_int(0, 1))] = random.unit() < 0.5 ? 0.0 : -0.0;
  if (kind == Kind::near_degenerate) input[1] = nudged(-input[0], random);
  return input;
}

/// The promises of cuts, which many stand on: tried more often than others.
std::vector<Property> cuts() {
  const auto needs_exact = [](const Input& i) { return cut_of(i).needs_exact(); };
  const auto is_subnormal = [](const Input& i) {
    const double x = cut_of(i).is_one() ? cut_of(i).made() : 0;
    return x != 0 && std::abs(x) < std::numeric_limits<double>::min();
  };
  const auto rounds_twice = [](const Input& i) {
    return cut_of<float>(i).is_one() && static_cast<float>(cut_of(i).made()) != cut_of<float>(i).made();
  };
  const auto underflows = [](const Input& i) {
    return cut_of<float>(i).is_one() && cut_of<float>(i).made() == 0 && cut_of<float>(i).above() != 0;
  };
  std::vector<Property> all{
      exact_property("cut_coordinate",
                     "the nearest double, in both directions, between the ends; a zero is +0", 5,
                     at_every_scale(cut, {}, put_between), cut_error,
                     {{"needs exact arithmetic", 0.1, needs_exact},
                      {"lies midway", 0.03, is_tie},
                      {"is subnormal", 0.001, is_subnormal}},
                     {{"a difference overflows", {-1e308, 1e308, 0, 10, 0}},
                      {"both differences overflow", {-1e200, 1e200, -1e200, 1e200, 10}},
                      {"the smallest numbers", {-0x1p-1074, 0x1p-1074, -0x1p-1074, 0x1p-1074, 0}},
                      {"misses 0 by a hair", {-1, 1.0000000000000002, 1, -1, 0}}}),
      exact_property("cut_coordinate_float", "the nearest float, in both directions; a zero is +0", 5,
                     float_cut, float_cut_error,
                     {{"must not be rounded to double first", 0.03, rounds_twice},
                      {"underflows to 0", 0.0007, underflows}},
                     {{"underflows to -0", {0, 4, -0x1p-149, 0, 3}},
                      {"half way to -0", {0, 2, -0x1p-149, 0, 1}},
                      {"three quarters of the smallest", {0, 4, -0x1p-149, 0, 1}}}),
      exact_property("fast_cut", "between 2^-299 and 2^299 fast arithmetic is enough, but for ties", 5,
                     plain_cut, cut_error,
                     {{"fast arithmetic is enough", 0.99, [=](const Input& i) { return !needs_exact(i); }}}),
      exact_property("compare_at_cut", "on which side of a border a segment is cut, exactly", 5,
                     at_every_scale(cut, {}, put_between), place_error, {}),
      exact_property("compare_cuts", "which of two borders a segment comes to first, exactly, in every order",
                     6, at_every_scale(corner), order_error,
                     {{"is in doubt", 0.1,
                       [](const Input& i) {
                         return all_finite(i) && !orient2d_filtered({i[0], i[3]}, {i[1], i[4]}, {i[2], i[5]});
                       }},
                      {"misleads quotients", 0.05, divisions_mislead}})};
  for (Property& each : all) each.cases = 20'000;
  all[0].cases = all[1].cases = 30'000;
  all[2].kinds = {Kind::random, Kind::tiny};
  return all;
}

}  // namespace

Domain core() {
  Domain domain{
      "core",
      {{.name = "length_of",
        .states = "within 2 ulp, also where squares overflow or vanish",
        .unit = "ulp",
        .bound = 2,
        .numbers = 3,
        .generate = at_every_scale(vector),
        .error = length_error,
        .traps = {{"squares underflow", {1e-200, 1e-200, 0}}, {"squares overflow", {1e200, -1e200, 0}}}},
       {.name = "unit_vector",
        .states = "each component within 4 ulp",
        .unit = "ulp",
        .bound = 4,
        .numbers = 3,
        .kinds = all_but_refused,
        .generate = at_every_scale(vector),
        .error = direction_error,
        .traps = {{"the smallest vector", {0, 0x1p-1074, 0}}, {"no vector", {0, 0, 0}}}},
       {.name = "turn",
        .states = "sine and cosine within 0.501 ulp, for every angle",
        .unit = "ulp",
        .bound = 0.501,
        .numbers = 1,
        .generate = at_every_scale(angle),
        .error = [](const Input& i) { return turn_error(i, false); }},
       {.name = "versine",
        .states = "1 - cosine within 3 ulp, for every angle",
        .unit = "ulp",
        .bound = 3,
        .numbers = 1,
        .generate = at_every_scale(angle),
        .error = [](const Input& i) { return turn_error(i, true); },
        .traps = {{"1 - cos is 0", {1e-9}}, {"underflows", {1e-170}}, {"a whole turn", {6.283185307179586}}}},
       {.name = "unbounded",
        .states =
            "numbers without bounds have the bits of plain arithmetic in its range, of double and float",
        .unit = "results",
        .bound = 0,
        .numbers = 2,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::ties},
        .generate = unbounded_numbers,
        .error = [](const Input& i) { return unbounded_error<double>(i) + unbounded_error<float>(i); },
        .cases = 40'000}}};
  for (Property& each : cuts()) domain.properties.push_back(std::move(each));
  return domain;
}

}  // namespace gradus::stress
