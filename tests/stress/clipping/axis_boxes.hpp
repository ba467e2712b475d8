#pragma once
// Segments against windows (N = 2) and boxes (N = 3) along the axes: what the promises of all their clippers
// share. An input is the ends a and b, then the lower and the upper corner.

#include <fmt/format.h>

#include <array>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "stress/clipping/floats.hpp"
#include "stress/clipping/lanes.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/clip_oracle.hpp"

namespace gradus::stress::axis_boxes {

template <int N, class T = double>
struct Clip {
  Segment<N, T> line;
  AxisBox<N, T> box;
};

/// An input in numbers of type T, which hold it.
template <int N, class T = double>
Clip<N, T> clip_of(const Input& input) {
  Clip<N, T> clip{};
  for (int i = 0; i < N; ++i) {
    const auto n = [&](int first) { return T(input[static_cast<std::size_t>(first * N + i)]); };
    clip.line.a[i] = n(0);
    clip.line.b[i] = n(1);
    clip.box.lower[i] = n(2);
    clip.box.upper[i] = n(3);
  }
  return clip;
}

/// Whether the contract takes the input.
template <int N>
bool is_taken(const Input& input) {
  const Clip<N> clip = clip_of<N>(input);
  for (int i = 0; i < N; ++i) {
    if (clip.box.lower[i] > clip.box.upper[i]) return false;
  }
  return all_finite(input);
}

// --- Inputs ---

template <int N>
void put_corners_in_order(Input& input) {
  constexpr auto n = static_cast<std::size_t>(N);
  for (std::size_t i = 0; i < n; ++i) put_in_order(input[2 * n + i], input[3 * n + i]);
}

/// A border halfway along the segment, or a hair off, where another coordinate lies midway between two
/// doubles.
template <int N>
Input tied(Random& random) {
  constexpr auto n = static_cast<std::size_t>(N);
  Input input(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    input[i] = random.uniform(-9, 9);
    input[n + i] = random.uniform(-9, 9);
    input[2 * n + i] = -1e17;
    input[3 * n + i] = 1e17;
  }
  const auto across = static_cast<std::size_t>(random.uniform_int(0, N - 1)), along = (across + 1) % n;
  const std::int64_t low = std::int64_t{1} << 52, high = 2 * low - 1;
  const std::int64_t first = random.uniform_int(low, high), second = random.uniform_int(low, high);
  input[along] = static_cast<double>(first);
  input[n + along] = static_cast<double>(second - (first + second + 1) % 2);
  input[n + across] = random.uniform(1, 8);
  input[across] = -input[n + across];
  const double border = random.unit() < 0.5 ? 0 : sized(random, -200, -90);
  const bool is_lower = random.unit() < 0.5;
  input[2 * n + across] = is_lower ? border : -10;
  input[3 * n + across] = is_lower ? 10 : border;
  return input;
}

/// The end b so that the segment passes a corner of the box, or an edge of one in space, or does so but for a
/// few units.
template <int N>
void graze(Input& input, Random& random) {
  constexpr auto n = static_cast<std::size_t>(N);
  const double t = random.unit() < 0.4 ? 0.5 : random.unit();
  const std::size_t free =
      N == 3 && random.unit() < 0.7 ? static_cast<std::size_t>(random.uniform_int(0, 2)) : n;
  for (std::size_t i = 0; i < n; ++i) {
    const double corner = random.unit() < 0.5 ? input[2 * n + i] : input[3 * n + i];
    if (i != free) input[n + i] = nudged((corner - input[i] * (1 - t)) / t, random);
  }
}

/// Through a point of the box, and at both ends beyond a border of every axis.
template <int N>
void go_through(Input& input, Random& random) {
  constexpr auto n = static_cast<std::size_t>(N);
  for (std::size_t i = 0; i < n; ++i) {
    const double lower = input[2 * n + i], extent = input[3 * n + i] - lower;
    const double at = lower + random.unit() * extent;
    const double way = std::ldexp(extent, static_cast<int>(random.uniform_int(0, 4)));
    const double turn = random.unit() < 0.5 ? -1 : 1;
    input[i] = at - turn * way;
    input[n + i] = at + turn * way;
  }
}

template <int N>
Input shape(Kind kind, Random& random) {
  constexpr auto n = static_cast<std::size_t>(N);
  if (kind == Kind::ties && random.unit() < 0.3) return tied<N>(random);
  Input input(4 * n);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  put_corners_in_order<N>(input);
  const auto axis = static_cast<std::size_t>(random.uniform_int(0, N - 1));
  if (kind == Kind::near_degenerate) {
    // Nearly level, or nearly a point; a box without extent
    for (std::size_t i = 0; i < n; ++i) {
      if (i == axis || random.unit() < 0.2) input[n + i] = nudged(input[i], random);
    }
    if (random.unit() < 0.3) input[2 * n + axis] = input[3 * n + axis];
  } else if (kind == Kind::grazing) {
    graze<N>(input, random);
  } else if (kind == Kind::refused) {
    if (random.unit() < 0.3) {
      // Inside out
      std::swap(input[2 * n], input[3 * n]);
      if (input[2 * n] <= input[3 * n]) input[2 * n] = input[3 * n] + 1;
    } else {
      const auto at = static_cast<std::size_t>(random.uniform_int(0, 4 * N - 1));
      input[at] = random.unit() < 0.5 ? std::numeric_limits<double>::quiet_NaN() : wrong;
    }
  } else if (kind == Kind::random) {
    if (random.unit() < 0.3) go_through<N>(input, random);
  } else if (kind != Kind::ties && random.unit() < 0.5) {
    // Numbers of one size mostly miss: across the box
    for (std::size_t i = 0; i < n; ++i) {
      input[2 * n + i] = -std::abs(input[2 * n + i]);
      input[3 * n + i] = std::abs(input[3 * n + i]);
      if (random.unit() < 0.5) input[n + i] = -input[i];
    }
  }
  return input;
}

template <int N>
Input generate(Kind kind, Random& random) {
  static const Generator all = at_every_scale(shape<N>, {}, put_corners_in_order<N>);
  return all(kind, random);
}

// --- Promises ---

/// The worst end of what a clipper leaves, which should be the nearest numbers.
template <int N, class T, class Method>
double rounded_error(const Input& input, Method method) {
  const Clip<N, T> clip = clip_of<N, T>(input);
  std::optional<Segment<N, T>> found;
  try {
    found = method(clip.line, clip.box, usual_order<N>());
  } catch (const ContractViolation&) {
    return is_taken<N>(input) ? wrong : 0;
  }
  if (!is_taken<N>(input)) return wrong;
  return test::worst_end(found, test::exact_clip(clip.line, clip.box), test::rounding_error<T>);
}

/// The same of a method without a bound, in ulp of a place no smaller than 1; wrong decisions are infinite.
template <int N, class Method>
double measured_error(const Input& input, Method method) {
  const auto [line, box] = clip_of<N>(input);
  return test::worst_end(
      method(line, box, usual_order<N>()), test::exact_clip(line, box),
      [](double x, const test::Fraction& exact) { return test::error_in_ulp(x, exact, 1); });
}

template <int N, class T>
bool lies_in(const Segment<N, T>& line, const AxisBox<N, T>& box) {
  return glm::clamp(line.a, box.lower, box.upper) == line.a &&
         glm::clamp(line.b, box.lower, box.upper) == line.b;
}

/// 0 where the reverse gives the reverse and clipping again changes nothing, bit for bit, where all that is
/// left lies in the box, and the order of borders does not matter.
template <int N, class T, class Method>
double relations_error(const Input& input, Method method) {
  if (!is_taken<N>(input)) return 0;
  const auto [line, box] = clip_of<N, T>(input);
  auto order = usual_order<N>();
  const auto found = method(line, box, order), back = method(test::reversed(line), box, order);
  if (!test::same_bits(found, back ? std::optional(test::reversed(*back)) : std::nullopt)) return wrong;
  if (found && (!lies_in(*found, box) || !test::same_bits(method(*found, box, order), found))) return wrong;
  // The order decides only whether a zero is a border's -0 or the rounded +0
  for (int turn = 0; turn < 4 * N; ++turn) {
    std::ranges::rotate(order, order.begin() + 1);
    if (turn % 3 == 2) std::swap(order[0], order[1]);
    if (method(line, box, order) != found) return wrong;
  }
  return 0;
}

/// 0 where both methods in rationals are the definition, and the careful one in doubles is that, rounded.
template <int N, class Careful, class Taught>
double rationals_error(const Input& input, Careful careful, Taught taught) {
  if (!is_taken<N>(input)) return 0;
  const ExactScope scope;
  const auto exact = clip_of<N, Exact>(input);
  const auto [line, box] = clip_of<N>(input);
  const auto order = usual_order<N>();
  const auto right = careful(exact.line, exact.box, order);
  const auto rounded = careful(line, box, order);
  if (taught(exact.line, exact.box, order) != right || right.has_value() != rounded.has_value()) return wrong;
  for (int i = 0; right && i < N; ++i) {
    if (to_double(right->a[i]) != rounded->a[i] || to_double(right->b[i]) != rounded->b[i]) return wrong;
  }
  return 0;
}

/// 0 where a batch has the bits of the scalar method in every lane: the line there and back, a step beside
/// it, a point, halves.
template <int N, class Batch, class Scalar>
double batch_error(const Input& input, Batch batch, Scalar scalar) {
  const auto given = clip_of<N>(input);
  const auto& [line, box] = given;
  const auto clip = [&](const auto& lines, auto& clipped, auto& accepted) {
    return batch(lines, given.box, clipped, accepted);
  };
  if (!is_taken<N>(input)) return lanes::refusal_error<N>(line, clip);
  const auto middle = 0.5 * line.a + 0.5 * line.b, centre = 0.5 * box.lower + 0.5 * box.upper;
  lanes::Lines<N> lines{line,
                        test::reversed(line),
                        {line.a, line.a},
                        {line.a, middle},
                        {middle, line.b},
                        {line.a, box.lower},
                        {centre, line.b},
                        {line.b, box.upper}};
  // Mostly one coordinate alone, a step to a side
  for (int i = 0; i < N; ++i) {
    for (const double way : {-HUGE_VAL, HUGE_VAL}) {
      auto beside = line;
      beside.b[i] = std::nextafter(line.b[i], way);
      if (std::isfinite(beside.b[i])) lines.push_back(beside);
    }
  }
  lines.insert(lines.end(), 5, line);
  return lanes::error<N>(lines, clip,
                         [&](const auto& one) { return scalar(one, given.box, usual_order<N>()); });
}

// --- Situations ---

/// Whether the points, or the order of the borders that the segment really crosses, need exact arithmetic.
template <int N>
bool needs_exact_arithmetic(const Clip<N>& clip) {
  const auto& [line, box] = clip;
  for (const Border border : usual_order<N>()) {
    const int axis = axis_of(border);
    const double c = coordinate(box, border), a = line.a[axis], b = line.b[axis];
    if (outside(line.a, box, border) == outside(line.b, box, border)) continue;
    for (const Border other : usual_order<N>()) {
      const int i = axis_of(other);
      if (i == axis || outside(line.a, box, other) == outside(line.b, box, other)) continue;
      if (!orient2d_filtered({a, line.a[i]}, {b, line.b[i]}, {c, coordinate(box, other)})) return true;
    }
    for (int i = 0; i < N; ++i) {
      if (i == axis || line.a[i] == line.b[i] || c == a || c == b) continue;
      if (!cut_coordinate_filtered(a, b, line.a[i], line.b[i], c)) return true;
    }
  }
  return false;
}

template <int N, class Holds>
Share share(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) { return is_taken<N>(i) && holds(clip_of<N>(i)); }};
}

// --- What all clippers promise ---

/// Numbers as a flag's value: as many digits as read back to the same.
inline std::string list(const Input& input, std::size_t first, std::size_t count) {
  std::string text;
  for (std::size_t i = first; i < first + count; ++i)
    text += fmt::format("{}{}", i > first ? "," : "", input[i]);
  return text;
}

/// The traps of clippers of windows that others have fallen into, {a, b, lower, upper}.
inline std::vector<Trap> window_traps() {
  const double above = std::nextafter(-1.0, -2.0), right = std::nextafter(9.0, 10.0);
  const double slope = 1.8e-15;
  return {{"a difference overflows", {-1e308, 0, 1e308, 10, 0, 0, 10, 10}},
          {"a product overflows", {-1e200, -1e200, 1e200, 1e200, 0, 0, 10, 10}},
          {"NaN has code 0", {std::nan(""), 5, 5, 5, 0, 0, 10, 10}},
          {"infinity", {-wrong, 5, 5, 5, 0, 0, 10, 10}},
          {"touches the corner", {-1, 1, 1, -1, 0, 0, 10, 10}},
          {"misses the lower corner by an ulp", {-1, 1, 1, above, 0, 0, 10, 10}},
          {"misses the upper corner by an ulp", {9, 11, 11, right, 0, 0, 10, 10}},
          {"nearly along the upper edge", {-1e6, 10 - slope, 1e6, 10 + slope, 0, 0, 10, 10}},
          {"a window without width", {-5, 5, 15, 5, 3, 0, 3, 10}},
          {"a window inside out", {-5, 5, 15, 5, 10, 0, 0, 10}},
          {"codes 1 and 8, and outside", {-5, 8, 3, 20, 0, 0, 10, 10}},
          {"left again and again", {5, 5, -5, 5, 0, 0, 10, 10}}};
}
inline std::vector<Trap> box_traps() {
  const double above = std::nextafter(-1.0, -2.0);
  return {{"a difference overflows", {-1e308, 0, 0, 1e308, 10, 10, 0, 0, 0, 10, 10, 10}},
          {"through two corners", {-1, -1, -1, 11, 11, 11, 0, 0, 0, 10, 10, 10}},
          {"touches a corner", {-1, 1, 0, 1, -1, 0, 0, 0, 0, 10, 10, 10}},
          {"misses an edge by an ulp", {-1, 1, 0, 1, above, 0, 0, 0, 0, 10, 10, 10}},
          {"a point of a flat box", {1, 1, -1, 3, 5, 3, 2, 3, 1, 2, 3, 1}}};
}

/// A promise that is kept or broken.
template <int N>
Property promise(std::string name, std::string states, const char* method,
                 std::function<double(const Input&)> error) {
  return {.name = std::move(name),
          .states = std::move(states),
          .unit = "wrong",
          .bound = 0,
          .numbers = 4 * std::size_t{N},
          .generate = generate<N>,
          .error = std::move(error),
          .arguments = [method](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
            constexpr std::size_t n = N;
            return {{"method", method},
                    {"line", list(i, 0, 2 * n)},
                    {N == 2 ? "window" : "box", list(i, 2 * n, 2 * n)}};
          },
          .traps = N == 2 ? window_traps() : box_traps()};
}

/// What a correctly rounded method and the one that is taught promise, `prefix` before all names. Both take a
/// line, a box and an order.
template <int N, class Careful, class Taught>
std::vector<Property> promises(const std::string& prefix, const char* careful_name, Careful careful,
                               const char* taught_name, Taught taught) {
  Property rounded =
      promise<N>(careful_name, "accepts and rejects exactly; every end is the nearest double, ties to even",
                 careful_name, [=](const Input& i) { return rounded_error<N, double>(i, careful); });
  rounded.unit = "ulp";
  rounded.bound = 0.5;
  rounded.cases = 20'000;
  const auto kept = [=](const Clip<N>& of) { return careful(of.line, of.box, usual_order<N>()); };
  rounded.shares = {share<N>("kept", 0.25, [=](const auto& of) { return kept(of).has_value(); }),
                    share<N>("cut", 0.15, [=](const auto& of) { return kept(of) && kept(of) != of.line; }),
                    share<N>("missed", 0.15, [=](const auto& of) { return !kept(of); }),
                    share<N>("needs exact arithmetic", 0.1, needs_exact_arithmetic<N>)};

  Property relations = promise<N>(
      prefix + "relations",
      "the reverse is the reverse and again changes nothing, bit for bit; no border need come first",
      careful_name, [=](const Input& i) { return relations_error<N, double>(i, careful); });

  Property floats = promise<N>(prefix + "in_float", "every end is the nearest float, and the same relations",
                               careful_name, [=](const Input& i) {
                                 const Input as = rounded_to_floats(i);
                                 return std::max(rounded_error<N, float>(as, careful),
                                                 relations_error<N, float>(as, careful));
                               });
  floats.generate = at_every_scale_of_floats(shape<N>, put_corners_in_order<N>);

  Property rationals =
      promise<N>(prefix + "in_rationals", "both methods in rationals are the definition", careful_name,
                 [=](const Input& i) { return rationals_error<N>(i, careful, taught); });
  // Rationals of this size take long
  rationals.cases = 2'000;

  const auto off = [=](const Input& i) { return is_taken<N>(i) ? measured_error<N>(i, taught) : 0; };
  Property measured =
      promise<N>(taught_name, "no bound: every step rounds; wrong decisions are left out", taught_name,
                 [=](const Input& i) { return std::isinf(off(i)) ? 0 : off(i); });
  measured.unit = "ulp";
  measured.bound = wrong;
  measured.cases = 30'000;
  measured.kinds = {Kind::random, Kind::grazing};
  measured.traps.clear();
  measured.shares = {
      {"more than an ulp off", 0.05, [=](const Input& i) { return std::isfinite(off(i)) && off(i) > 1; }},
      {"decided wrongly", 0.005, [=](const Input& i) { return std::isinf(off(i)); }}};
  return {rounded, relations, floats, rationals, measured};
}

template <int N, class Batch, class Scalar>
Property batch_promise(Batch batch, Scalar scalar) {
  return promise<N>("clip_batch", "the bits of correctly_rounded, in every lane, on every kind of machine",
                    "correctly_rounded", [=](const Input& i) { return batch_error<N>(i, batch, scalar); });
}

}  // namespace gradus::stress::axis_boxes
