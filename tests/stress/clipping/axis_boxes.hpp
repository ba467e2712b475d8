#pragma once
// Segments against windows (N = 2) and boxes (N = 3) along the axes: what the promises of all their clippers
// share. An input is the ends a and b, then the lower and the upper corner.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <vector>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/clip_oracle.hpp"

namespace gradus::stress::axis_boxes {

template <int N>
struct Clip {
  Segment<N, double> line;
  AxisBox<N, double> box;
};

template <int N>
Clip<N> clip_of(const Input& input) {
  Clip<N> clip{};
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i), n = static_cast<std::size_t>(N);
    clip.line.a[i] = input[k];
    clip.line.b[i] = input[n + k];
    clip.box.lower[i] = input[2 * n + k];
    clip.box.upper[i] = input[3 * n + k];
  }
  return clip;
}

template <int N>
void put_corners_in_order(Input& input) {
  constexpr auto n = static_cast<std::size_t>(N);
  for (std::size_t i = 0; i < n; ++i) put_in_order(input[2 * n + i], input[3 * n + i]);
}

template <int N>
Input shape(Kind kind, Random& random) {
  Input input(4 * std::size_t{N});
  constexpr auto n = static_cast<std::size_t>(N);
  for (double& x : input) x = kind == Kind::refused ? number(Kind::random, random) : number(kind, random);
  put_corners_in_order<N>(input);
  if (kind == Kind::near_degenerate) {
    // Nearly level, or nearly a point
    const auto axis = static_cast<std::size_t>(random.uniform_int(0, N - 1));
    for (std::size_t i = 0; i < n; ++i) {
      if (i == axis || random.unit() < 0.2) input[n + i] = nudged(input[i], random);
    }
    if (random.unit() < 0.3) input[2 * n + axis] = input[3 * n + axis];
  } else if (kind == Kind::grazing) {
    // Through a corner, or a few units beside it
    const double t = random.unit();
    for (std::size_t i = 0; i < n; ++i) {
      const double corner = random.unit() < 0.5 ? input[2 * n + i] : input[3 * n + i];
      input[n + i] = nudged((corner - input[i] * (1 - t)) / t, random);
    }
  } else if (kind == Kind::refused) {
    const auto at = static_cast<std::size_t>(random.uniform_int(0, 4 * N - 1));
    if (random.unit() < 0.3) {
      // Inside out
      std::swap(input[2 * n], input[3 * n]);
      if (input[2 * n] <= input[3 * n]) input[2 * n] = input[3 * n] + 1;
    } else {
      input[at] = random.unit() < 0.5 ? std::numeric_limits<double>::quiet_NaN() : wrong;
    }
  }
  return input;
}

template <int N>
Input generate(Kind kind, Random& random) {
  static const Generator all = at_every_scale(shape<N>, {}, put_corners_in_order<N>);
  return all(kind, random);
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

/// The worst end of what a clipper leaves, in ulp of the exact place; with `of_one`, of a place no smaller
/// than 1, for methods whose ends are not near enough to 0 to be measured there.
template <int N, class Method>
double error(const Input& input, Method method, bool of_one = false) {
  const Clip<N> clip = clip_of<N>(input);
  std::optional<Segment<N, double>> found;
  try {
    found = method(clip.line, clip.box);
  } catch (const ContractViolation&) {
    return is_taken<N>(input) ? wrong : 0;
  }
  if (!is_taken<N>(input)) return wrong;
  const auto exact = test::exact_clip(clip.line, clip.box);
  if (found.has_value() != exact.has_value()) return wrong;
  double worst = 0;
  for (int i = 0; found && i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto off = [&](double x, const test::Rational& right) {
      if (of_one && abs(right) < 1) return std::abs(x - static_cast<double>(right)) * 0x1p52;
      return test::error_in_ulp(x, right);
    };
    worst = std::max({worst, off(found->a[i], exact->a[k]), off(found->b[i], exact->b[k])});
  }
  return worst;
}

/// A batch as a method for one line: the line there and back fills all lanes and leaves a rest, the results
/// must have the scalar method's bits, and a line that misses must be left as it is.
template <int N, class Batch, class Scalar>
auto in_every_lane(Batch batch, Scalar scalar) {
  using Line = Segment<N, double>;
  return [batch, scalar](const Line& line, const AxisBox<N, double>& box) -> std::optional<Line> {
    std::vector<Line> given(11, line);
    for (std::size_t i = 0; i < given.size(); i += 3) given[i] = test::reversed(line);
    std::vector<Line> clipped(given.size());
    std::vector<std::uint8_t> accepted(given.size());
    batch(given, box, clipped, accepted);
    const std::array right{scalar(test::reversed(line), box), scalar(line, box)};
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::optional<Line>& one = right[i % 3 == 0 ? 0 : 1];
      if (accepted[i] != one.has_value() || !test::same_bits(clipped[i], one ? *one : given[i])) {
        // No clipper leaves this
        Line impossible{};
        impossible.a[0] = wrong;
        return impossible;
      }
    }
    return right[1];
  };
}

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

}  // namespace gradus::stress::axis_boxes
