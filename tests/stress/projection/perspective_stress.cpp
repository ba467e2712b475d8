// The promises of the perspective projection onto a plane.

#include "projection/perspective/perspective.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// A plane and a point: d, x, y, z.
Input generate(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), number(kind, random), number(kind, random),
              number(kind, random)};
  if (random.unit() < 0.75) input[3] = std::abs(input[3]);
  if (kind == Kind::near_degenerate) {
    // Beside the plane, or nearly in the eye
    input[3] = random.unit() < 0.5 ? nudged(input[0], random) : std::ldexp(input[3], -1000);
  } else if (kind == Kind::grazing) {
    input[3] = random.unit() < 0.5 ? input[0] : 0;
  }
  return input;
}

/// How far an image is from x d / z, in roundings of it; 0 where that promises nothing.
double roundings(double image, double x, double d, double z) {
  const Rational exact = Rational(x) * Rational(d) / Rational(z);
  const double size = std::abs(static_cast<double>(exact));
  if (!std::isnormal(size) || !std::isnormal(d / z)) return x == 0 && image != 0 ? wrong : 0;
  return static_cast<double>(Rational(abs(Rational(image) - exact) / abs(exact))) * 0x1p53;
}

double error(const Input& i) {
  const double d = i[0], z = i[3];
  try {
    const auto image = perspective::project(d, {i[1], i[2], z});
    if (!(d > 0)) return wrong;  // was to be refused
    if (!(z > 0)) return image ? wrong : 0;
    const bool fits = all_finite({d / z, i[1] * (d / z), i[2] * (d / z)});
    if (!fits) return image ? wrong : 0;
    if (!image || image->z != d) return wrong;
    if (!all_finite(i)) return 0;  // infinitely far away, say
    if (z == d && (image->x != i[1] || image->y != i[2])) return wrong;
    return std::max(roundings(image->x, i[1], d, z), roundings(image->y, i[2], d, z));
  } catch (const ContractViolation&) {
    return d > 0 ? wrong : 0;
  }
}

/// Whether a product or a quotient is 0, or a normal number of double.
bool fits(const Rational& x) {
  return x == 0 || (Rational(0x1p-1022) <= abs(x) && abs(x) <= Rational(0x1p1022));
}

// --- Vanishing points: the plane's distance, a direction -------------------------------------------------

double vanishing_error(const Input& i) {
  if (!(i[0] > 0) || !all_finite(i) || (i[1] == 0 && i[2] == 0 && i[3] == 0)) return 0;
  const Rational d(i[0]), z(i[3]), over = Rational(1) / d;
  if (!fits(over) || !fits(z * over)) return 0;  // beyond the domain
  const auto found = perspective::vanishing_point(perspective::matrix_onto(i[0]), dvec3{i[1], i[2], i[3]});
  if (z == 0) return found ? wrong : 0;
  double worst = 0;
  const Rational u(0x1p-53), bound = 3 * u * (1 + 3 * u), largest(std::numeric_limits<double>::max());
  for (int k : {0, 1}) {
    const Rational exact = Rational(i[static_cast<std::size_t>(1 + k)]) * d / z;
    if (abs(exact) > largest * (1 + bound)) return found ? wrong : 0;
    if (!found && abs(exact) > largest * (1 - bound)) return 0;
  }
  if (!found) return wrong;
  for (int k : {0, 1}) {
    const Rational exact = Rational(i[static_cast<std::size_t>(1 + k)]) * d / z;
    if (!fits(exact)) continue;
    const Rational off = abs(Rational((*found)[k]) - exact);
    if (off > 0)
      worst = std::max(worst, exact == 0 ? wrong : static_cast<double>(Rational(off / (bound * abs(exact)))));
  }
  return worst;
}

// --- The transformation: scales, near, far, then a point of view space -----------------------------------

Input view_input(Kind kind, Random& random) {
  Input input(7);
  for (double& x : input) x = number(kind, random);
  for (std::size_t k = 0; k < 4; ++k) input[k] = std::abs(input[k]);
  if (kind == Kind::near_degenerate) input[3] = nudged(input[2], random);
  if (kind == Kind::grazing) input[6] = random.unit() < 0.5 ? input[2] : input[3];
  return input;
}
void put_planes_in_order(Input& i) {
  for (std::size_t k = 0; k < 4; ++k) i[k] = std::abs(i[k]);
  put_in_order(i[2], i[3]);
}

double transform_error(const Input& i) {
  if (!(0 < i[2] && i[2] < i[3]) || !all_finite(i)) return 0;
  const auto p = projection_of(i[0], i[1], i[2], i[3]);
  const Rational near(i[2]), scale(p.z_scale);
  if (!all_finite({p.z_scale, p.z_offset}) || !fits(scale * near)) return 0;
  const auto found = perspective::transform(p, dvec3{i[4], i[5], i[6]});
  if (found.w != i[6]) return wrong;
  if (i[6] == i[2] && found.z != 0) return wrong;
  const Rational x = Rational(i[0]) * Rational(i[4]), y = Rational(i[1]) * Rational(i[5]);
  const Rational product = scale * Rational(i[6]), z = product + Rational(p.z_offset);
  double worst = 0;
  const auto look_at = [&](double clip, const Rational& exact, const Rational& terms, const Rational& last) {
    if (!fits(terms) || !fits(exact)) return;
    const Rational off = abs(Rational(clip) - exact), bound = (abs(terms) + last) * Rational(0x1p-53);
    if (off > 0) worst = std::max(worst, bound == 0 ? wrong : static_cast<double>(Rational(off / bound)));
  };
  look_at(found.x, x, x, 0);
  look_at(found.y, y, y, 0);
  if (fits(product)) look_at(found.z, z, product, abs(z) * (1 + Rational(0x1p-52)));
  return worst;
}

// --- Stored depths: near, far, how far z lies between them, curve and format ------------------------------

Input depth_input(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), std::abs(number(kind, random)), random.unit(),
              static_cast<double>(random.uniform_int(0, 5))};
  if (kind == Kind::near_degenerate) input[1] = input[0] * (1 + std::ldexp(random.unit(), -40));
  if (kind == Kind::grazing) input[2] = random.unit() < 0.5 ? 0 : 1;
  if (kind == Kind::ties) input[2] = std::round(8 * input[2]) / 8;
  put_in_order(input[0], input[1]);
  return input;
}

/// In roundings: of depth_of at most 3 or 5; of separable_step, whose stored spacing is exact, at most 12.
double depth_error(const Input& i, bool of_step) {
  if (!(0x1p-400 <= i[0] && i[0] < i[1] && i[1] <= 0x1p400) || !(0 <= i[2] && i[2] <= 1)) return 0;
  const double n = i[0], f = i[1], z = std::clamp(n + i[2] * (f - n), n, f);
  const auto curve = static_cast<perspective::DepthCurve>(static_cast<int>(std::clamp(i[3], 0.0, 5.0)) % 3);
  const auto format = static_cast<perspective::DepthFormat>(static_cast<int>(std::clamp(i[3], 0.0, 5.0)) / 3);
  const Rational near(n), far(f), at(z), range = far - near;
  // What a double holds on the way
  for (const Rational& part :
       {range, Rational(near / at), Rational(far / at), Rational(at - near), Rational(far - at),
        Rational(near / at * (far / at)), Rational(1 / range), Rational(near * far / (at * at * range))}) {
    if (!fits(part)) return 0;
  }
  const bool linear = curve == perspective::DepthCurve::linear;
  const Rational inverse = far / at * (at - near) / range, reversed = near / at * (far - at) / range;
  const Rational exact = linear                                      ? Rational((at - near) / range)
                         : curve == perspective::DepthCurve::inverse ? inverse
                                                                     : reversed;
  const double depth = perspective::depth_of(curve, n, f, z);
  const auto roundings = [](double found, const Rational& right) {
    if (right == 0) return found == 0 ? 0 : wrong;
    return static_cast<double>(Rational(abs(Rational(found) - right) / right)) * 0x1p53;
  };
  if (!fits(exact)) return 0;
  if (!of_step) return roundings(depth, exact) / (linear ? 3 : 5);
  if (!(0 <= depth && depth <= 1)) return 0;
  const Rational slope = linear ? Rational(1 / range) : Rational(near * far / (at * at * range));
  const Rational step = Rational(perspective::spacing(format, depth)) / slope;
  if (!fits(step)) return 0;
  return roundings(perspective::separable_step(curve, format, n, f, z), step) / 12;
}

}  // namespace

Domain perspective() {
  const auto planes_in_order = [](Input& i) { put_in_order(i[0], i[1]); };
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
                                Kind::ties,   Kind::denormal,        Kind::extremes};
  return {"perspective",
          {{.name = "project",
            .states = "no image at or behind the eye; else x and y within two roundings",
            .unit = "roundings",
            .bound = 0x1.0000000000001p1,  // 2 (1 + 2^-53)
            .numbers = 4,
            .generate = at_every_scale(generate, {}, [](Input& i) { i[0] = std::abs(i[0]); }),
            .error = error,
            .traps = {{"in the eye", {1, 1, 1, 0}},
                      {"behind the eye", {1, 1, 1, -2}},
                      {"the eye from behind", {1, 1, 1, -0.0}},
                      {"nearly in the eye", {1, 1, 1, 1e-310}},
                      {"the plane itself", {0.1, 0.3, 0.7, 0.1}},
                      {"the axis, nearly in the eye", {1, 0, 0, 1e-310}},
                      {"no distance", {0, 1, 1, 1}},
                      {"a depth that is no number", {1, 1, 1, std::nan("")}}}},
           {.name = "vanishing_point",
            .states = "within three roundings, where it is finite",
            .unit = "bounds",
            .bound = 1,
            .numbers = 4,
            .kinds = kinds,
            .generate = at_every_scale(generate, {}, [](Input& i) { i[0] = std::abs(i[0]); }),
            .error = vanishing_error,
            .traps = {{"nearly parallel to the picture", {1, 1, 0, 1e-310}}}},
           {.name = "transform",
            .states = "x and y one rounding, z two, exactly 0 at the near plane, w exact",
            .unit = "bounds",
            .bound = 1,
            .numbers = 7,
            .kinds = kinds,
            .generate = at_every_scale(view_input, {}, put_planes_in_order),
            .error = transform_error,
            .traps = {{"the far plane an ulp behind the near one", {1, 1, 1, 1 + 0x1p-52, 1, 1, 1}}}},
           {.name = "depth_of",
            .states = "3 roundings for the linear curve, 5 for the others",
            .unit = "bounds",
            .bound = 1 + 0x1p-40,
            .numbers = 4,
            .kinds = kinds,
            .generate = at_every_scale(depth_input, {0, 1}, planes_in_order),
            .error = [](const Input& i) { return depth_error(i, false); }},
           {.name = "separable_step",
            .states = "12 roundings",
            .unit = "bounds",
            .bound = 1 + 0x1p-40,
            .numbers = 4,
            .kinds = kinds,
            .generate = at_every_scale(depth_input, {0, 1}, planes_in_order),
            .error = [](const Input& i) { return depth_error(i, true); }}}};
}

}  // namespace gradus::stress
