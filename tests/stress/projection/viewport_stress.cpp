// The promises of the way from the camera plane to pixels, and back.

#include "projection/viewport/viewport.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using viewport::Mapping;

/// xmin, ymin, xmax, ymax, width, height, then a point of the plane.
Input generate(Kind kind, Random& random) {
  const auto pixels = [&] {
    return std::floor(std::ldexp(1.0, static_cast<int>(random.uniform_int(0, 30))));
  };
  Input input{number(kind, random),
              number(kind, random),
              number(kind, random),
              number(kind, random),
              pixels(),
              pixels(),
              0,
              0};
  if (kind == Kind::huge) {
    for (double& x : input) x = x > 0x1p40 || x < -0x1p40 ? x / 4 : x;  // the window's size doesn't overflow
  }
  if (kind == Kind::near_degenerate) {  // a small window far away
    const double far = sized(random, 20, 60);
    for (std::size_t i = 0; i < 4; ++i) input[i] = far + std::ldexp(input[i], std::ilogb(far) - 45);
  }
  for (std::size_t i : {0U, 1U}) {
    if (input[i] > input[i + 2]) std::swap(input[i], input[i + 2]);
    if (input[i] == input[i + 2]) input[i + 2] = std::nextafter(input[i], wrong);
    const double share = random.uniform(-0.25, 1.25);
    input[6 + i] = input[i] + share * (input[i + 2] - input[i]);
    if (kind == Kind::grazing) {  // on a side of a pixel, or beside it
      const double side = std::floor(random.unit() * input[4 + i]) / input[4 + i];
      input[6 + i] = nudged(input[i] + side * (input[i + 2] - input[i]), random);
    }
    if (kind == Kind::ties) input[6 + i] = number(kind, random);
  }
  return input;
}

/// What is asked: whether the header's domain has this input.
bool in_domain(const Input& i) {
  for (std::size_t k : {0U, 1U}) {
    if (!(i[k] < i[k + 2]) || !std::isfinite(i[k + 2] - i[k])) return false;
    if (!(i[4 + k] >= 1 && i[4 + k] <= viewport::most_pixels) || i[4 + k] != std::floor(i[4 + k]))
      return false;
  }
  return all_finite(i);
}

Mapping<double> map_of(const Input& i) {
  const ivec2 picture{static_cast<int>(i[4]), static_cast<int>(i[5])};
  return viewport::stretched<double>({{i[0], i[1]}, {i[2], i[3]}}, picture);
}

boost::multiprecision::cpp_int floor_of(const Rational& x) {
  const auto quotient = numerator(x) / denominator(x);  // rounds towards 0
  return x < 0 && Rational(quotient) != x ? quotient - 1 : quotient;
}

double ulp_of(double x) { return std::nextafter(x, wrong) - x; }

/// The exact place of the point, in pixels.
std::array<Rational, 2> exact_place(const Input& i) {
  const auto share = [](double from, double to, double at) {
    return Rational((Rational(at) - Rational(from)) / (Rational(to) - Rational(from)));
  };
  return {share(i[0], i[2], i[6]) * Rational(i[4]), (1 - share(i[1], i[3], i[7])) * Rational(i[5])};
}

double place_error(const Input& i) {
  if (!in_domain(i)) return 0;
  const Mapping<double> map = map_of(i);
  const dvec2 place = viewport::place_at(map.viewport, viewport::fraction_of(map, {i[6], i[7]}));
  const auto pixel = viewport::rasterize(map, dvec2{i[6], i[7]});
  const auto exact = exact_place(i);
  double worst = 0;
  bool inside = true, clear = true;  // clear: no side of a pixel within the bound
  for (std::size_t k : {0U, 1U}) {
    const Rational size(i[4 + k]), ulp(ulp_of(i[4 + k]));
    const bool within = exact[k] >= 0 && exact[k] < size;
    inside = inside && within;
    if (within || exact[k] == size) {
      const Rational off = abs(Rational(place[static_cast<int>(k)]) - exact[k]) / ulp;
      worst = std::max(worst, static_cast<double>(off));
    }
    const Rational bound = ulp * 5 / 2;
    const Rational nearest = Rational(floor_of(exact[k] + Rational(1, 2)));
    clear = clear && abs(exact[k] - nearest) > bound;
  }
  if (!clear) return worst;
  if (inside != pixel.has_value()) return wrong;
  if (!inside) return worst;
  const bool right = Rational(pixel->x) == Rational(floor_of(exact[0])) &&
                     Rational(pixel->y) == Rational(floor_of(exact[1]));
  return right ? worst : wrong;
}

double back_error(const Input& i) {
  if (!in_domain(i)) return 0;
  const Mapping<double> map = map_of(i);
  const dvec2 place = viewport::place_at(map.viewport, viewport::fraction_of(map, {i[6], i[7]}));
  const dvec2 back = viewport::to_plane(map, place);
  const auto exact = exact_place(i);
  double worst = 0;
  for (int k : {0, 1}) {
    const auto at = static_cast<std::size_t>(k);
    if (exact[at] < 0 || exact[at] > Rational(i[4 + at])) return 0;  // places in the viewport
    const double largest = std::max(std::abs(i[at]), std::abs(i[at + 2]));
    const Rational off = abs(Rational(back[k]) - Rational(i[6 + at])) / Rational(ulp_of(largest));
    worst = std::max(worst, static_cast<double>(off));
  }
  return worst;
}

}  // namespace

Domain viewport() {
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
                                Kind::ties,   Kind::denormal};
  const std::vector<Trap> traps{
      {"the last column's right side", {0, 0, 1, 1, 640, 480, 1, 0.5}},
      {"half a pixel", {-1, -1, 1, 1, 640, 480, 0.0015625, 0}},
      {"a window of one unit in the last place", {1, 1, 1 + 0x1p-52, 2, 3, 3, 1, 1}}};
  return {"viewport",
          {{.name = "rasterize",
            .states = "the place within 5/2 ulp of the width, and the pixel that has it",
            .unit = "ulp",
            .bound = 2.5,
            .numbers = 8,
            .kinds = kinds,
            .generate = generate,
            .error = place_error,
            .traps = traps},
           {.name = "to_plane",
            .states = "there and back within 4 ulp of the window's largest coordinate",
            .unit = "ulp",
            .bound = 4,
            .numbers = 8,
            .kinds = kinds,
            .generate = generate,
            .error = back_error,
            .traps = traps}}};
}

}  // namespace gradus::stress
