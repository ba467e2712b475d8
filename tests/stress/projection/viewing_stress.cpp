// The promises of the viewer's frame, of coordinates in it, and of the way back.

#include "projection/viewing/viewing.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Float = boost::multiprecision::cpp_bin_float_100;
template <class T>
using Triple = std::array<T, 3>;
using Vec3 = glm::dvec3;

constexpr double one_ulp = 0x1p-52;
// The header's bounds. Forward: the difference, three roundings under the root (halved), root and quotient,
// each of half an ulp of 1 at most
constexpr double forward_ulps = 2.25, other_ulps = 2;

template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Triple<Float> unit(const Triple<Float>& v) {
  const Float length = sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}
template <class T>
Triple<T> triple(Vec3 v) {
  return {T(v.x), T(v.y), T(v.z)};
}
bool is_zero(const Triple<Float>& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Vec3 vec(const Input& i, std::size_t from) { return {i[from], i[from + 1], i[from + 2]}; }

// --- look_at: eye, target, up ---------------------------------------------------------------------------

Input look_input(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 9; ++i) input.push_back(number(kind, random));
  if (kind == Kind::near_degenerate) {  // up nearly along the view, the target nearly at the eye
    const bool close = random.unit() < 0.5;
    const double share = std::ldexp(1.0, static_cast<int>(random.uniform_int(-52, -4)));
    for (std::size_t k = 0; k < 3; ++k) {
      if (close) input[3 + k] = nudged(input[k], random);
      if (!close) input[6 + k] = input[3 + k] - input[k] + share * random.uniform(-1, 1);
    }
  } else if (kind == Kind::grazing) {  // along the axes
    for (std::size_t k = 0; k < 9; ++k) input[k] = static_cast<double>(random.uniform_int(-1, 1));
  }
  return input;
}

/// The largest distance of a component from the exact one, in ulp of 1.
double off(const Vec3& found, const Triple<Float>& exact) {
  if (!viewing::is_finite(found)) return wrong;
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    worst = std::max(worst, static_cast<double>(abs(Float(found[static_cast<int>(k)]) - exact[k])) / one_ulp);
  }
  return worst;
}

/// The largest share of what is promised that is used up.
double look_error(const Input& i) {
  Frame<double> frame;
  bool taken = true;
  try {
    frame = viewing::look_at(vec(i, 0), vec(i, 3), vec(i, 6));
  } catch (const ContractViolation&) {
    taken = false;
  }
  if (!all_finite(i)) return taken ? wrong : 0;
  const auto up = triple<Float>(vec(i, 6));
  Triple<Float> along;  // the difference exactly, then its first hundred digits
  for (std::size_t k = 0; k < 3; ++k) along[k] = Float(Rational(Rational(i[3 + k]) - Rational(i[k])));
  if (is_zero(along) || is_zero(up)) return taken ? wrong : 0;
  const Triple<Float> forward = unit(along), across = cross(forward, unit(up));
  const Float sine = sqrt(dot(across, across));
  // So near to the limit that rounding may decide
  const double margin = static_cast<double>(abs(sine - viewing::least_sine<double>)) / one_ulp;
  if (!taken) return sine < viewing::least_sine<double> || margin < 8 ? 0 : wrong;
  if (sine < viewing::least_sine<double> && margin > 8) return wrong;
  const Triple<Float> right = unit(across), above = cross(right, forward);
  const double other = other_ulps / static_cast<double>(sine);
  return std::max({off(frame.forward, forward) / forward_ulps, off(frame.right, right) / other,
                   off(frame.up, above) / other});
}

// --- to_view: a frame as look_at makes it, and a point ---------------------------------------------------

Input view_input(Kind kind, Random& random) {
  Input input = look_input(kind == Kind::near_degenerate ? Kind::random : kind, random);
  for (std::size_t k = 0; k < 3; ++k) {
    input.push_back(kind == Kind::near_degenerate ? nudged(input[k], random) : number(kind, random));
  }
  return input;
}

double view_error(const Input& i) {
  Frame<double> frame;
  try {
    frame = viewing::look_at(vec(i, 0), vec(i, 3), vec(i, 6));
  } catch (const ContractViolation&) {
    return 0;  // look_at's own promise
  }
  if (!all_finite({i[9], i[10], i[11]})) return 0;
  const Vec3 world = vec(i, 9), view = viewing::to_view(frame, world);
  const Triple<Rational> p = {Rational(i[9]) - Rational(i[0]), Rational(i[10]) - Rational(i[1]),
                              Rational(i[11]) - Rational(i[2])};
  const Triple<Rational> axes[] = {triple<Rational>(frame.right), triple<Rational>(frame.up),
                                   triple<Rational>(frame.forward)};
  const Float distance = sqrt(Float(dot(p, p)));
  if (distance > Float(std::numeric_limits<double>::max()) / 2) return 0;
  if (distance == 0) return view == Vec3(0) ? 0 : wrong;
  if (!viewing::is_finite(view)) return wrong;
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational error = abs(Rational(view[static_cast<int>(k)]) - dot(axes[k], p));
    // Two smallest numbers are as good as two ulp
    worst = std::max(worst, static_cast<double>(Float(error) / (distance * one_ulp + Float(0x1p-1074))));
  }
  return worst;
}

// --- inverse_of_any_frame: eye and three axes -----------------------------------------------------------

Input inverse_input(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 12; ++i) input.push_back(number(kind, random));
  if (kind == Kind::near_degenerate) {  // the third axis nearly in the plane of the others
    const double a = random.uniform(-2, 2), b = random.uniform(-2, 2);
    const double share = std::ldexp(1.0, static_cast<int>(random.uniform_int(-48, -2)));
    for (std::size_t k = 0; k < 3; ++k) {
      input[9 + k] = a * input[3 + k] + b * input[6 + k] + share * random.uniform(-1, 1);
    }
  }
  return input;
}

/// A power of two that brings the largest component to [1, 2); 0 for the zero vector.
Rational power_that_fits(Vec3 v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0) return 0;
  const int exponent = -std::ilogb(largest);  // of a subnormal beyond what a double holds
  return Rational(std::ldexp(1.0, exponent / 2)) * Rational(std::ldexp(1.0, exponent - exponent / 2));
}

double inverse_error(const Input& i) {
  const Vec3 axes[] = {vec(i, 3), vec(i, 6), vec(i, 9)};
  Triple<Triple<Rational>> scaled;
  Triple<Rational> scales;
  for (std::size_t k = 0; k < 3; ++k) {
    scales[k] = power_that_fits(axes[k]);
    for (std::size_t c = 0; c < 3; ++c) scaled[k][c] = Rational(axes[k][static_cast<int>(c)]) * scales[k];
  }
  const Rational det = dot(scaled[0], cross(scaled[1], scaled[2]));
  const Rational size = abs(det), least(viewing::least_span<double>());
  glm::dmat4 matrix;
  try {
    matrix = viewing::inverse_of_any_frame(Frame<double>{vec(i, 0), axes[0], axes[1], axes[2]});
  } catch (const ContractViolation&) {
    return size > least * 2 ? wrong : 0;
  }
  if (det == 0) return wrong;
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Triple<Rational> column = cross(scaled[(k + 1) % 3], scaled[(k + 2) % 3]);
    Rational largest = 0, error = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      const Rational exact = column[row] / det * scales[k];
      const double found = matrix[static_cast<int>(k)][static_cast<int>(row)];
      if (!std::isfinite(found)) return abs(exact) < Rational(0x1p1023) ? wrong : 0;
      largest = std::max(largest, Rational(abs(exact)));
      error = std::max(error, Rational(abs(exact - Rational(found))));
    }
    if (largest < Rational(0x1p-1000) || largest == 0) continue;  // its ulp underflows
    worst = std::max(worst, static_cast<double>(Rational(error * size / largest)) / one_ulp);
  }
  return worst;
}

}  // namespace

Domain viewing() {
  return {
      "viewing",
      {{.name = "look_at",
        .states = "forward within 9/4 ulp of 1, right and up within 2 over the sine; parallel up is refused",
        .unit = "bounds",
        .bound = 1,
        .numbers = 9,
        .generate = at_every_scale(look_input),
        .error = look_error,
        .traps = {{"up along the view", {0, 5, 0, 0, 0, 0, 0, 1, 0}},
                  {"up along the view but for 1e-17", {0, 1, 0, 0, 0, 0, 1e-17, 1, 0}},
                  {"the target at the eye", {1, 2, 3, 1, 2, 3, 0, 1, 0}},
                  {"as far apart as doubles allow", {-1e308, 0, 0, 1e308, 1, 0, 0, 1, 0}},
                  {"squares underflow", {0, 0, 0, 1e-200, 0, 1e-200, 0, 1e-300, 0}}}},
       {.name = "to_view",
        .states = "each coordinate within 2 ulp of the distance",
        .unit = "ulp",
        .bound = 2,
        .numbers = 12,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                  Kind::denormal, Kind::extremes},
        .generate = at_every_scale(view_input),
        .error = view_error,
        .traps = {{"the eye itself", {2, 3, 5, 0, 0, 0, 0, 1, 0, 2, 3, 5}},
                  {"the target", {2, 3, 5, 0, 0, 0, 0, 1, 0, 0, 0, 0}},
                  {"far from the origin", {1e8, 1e8, 1e8, 0, 0, 1, 0, 1, 0, 1e8 + 1, 1e8, 1e8}}}},
       {.name = "inverse_of_any_frame",
        .states = "a column within 32 ulp of its largest entry over the determinant; flat frames are refused",
        .unit = "ulp",
        .bound = 32,
        .numbers = 12,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::tiny, Kind::huge, Kind::ties, Kind::denormal,
                  Kind::extremes},
        .generate = at_every_scale(inverse_input),
        .error = inverse_error,
        .traps = {{"in one plane", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}},
                  {"lengths far apart", {0, 0, 0, 1e-200, 0, 0, 0, 1, 0, 0, 0, 1e200}},
                  {"no axis", {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1}}}}}};
}

}  // namespace gradus::stress
