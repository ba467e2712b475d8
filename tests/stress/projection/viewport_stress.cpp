// The promises of the way from the camera plane to pixels, and back.

#include "projection/viewport/viewport.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

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

/// Whether the picture has a size.
bool has_picture(const Input& i) {
  return std::ranges::all_of(std::array{i[4], i[5]}, [](double n) {
    return n >= 1 && n <= viewport::most_pixels && n == std::floor(n);
  });
}

/// Whether the window has a size, a finite one.
bool has_window(const Input& i) {
  return i[0] < i[2] && i[1] < i[3] && all_finite({i[0], i[1], i[2] - i[0], i[3] - i[1]});
}

bool in_domain(const Input& i) { return has_window(i) && has_picture(i); }

Mapping<double> map_of(const Input& i) {
  const ivec2 picture{static_cast<int>(i[4]), static_cast<int>(i[5])};
  return viewport::stretched<double>({{i[0], i[1]}, {i[2], i[3]}}, picture);
}

boost::multiprecision::cpp_int floor_of(const Rational& x) {
  const auto quotient = numerator(x) / denominator(x);  // rounds towards 0
  return x < 0 && Rational(quotient) != x ? quotient - 1 : quotient;
}

/// From |x| to the next double; from the largest down.
double ulp_of(double x) {
  const double size = std::min(std::abs(x), std::nextafter(std::numeric_limits<double>::max(), 0.0));
  return std::nextafter(size, wrong) - size;
}

/// The exact place of the point, in pixels.
std::array<Rational, 2> exact_place(const Input& i) {
  const auto share = [](double from, double to, double at) {
    return Rational((Rational(at) - Rational(from)) / (Rational(to) - Rational(from)));
  };
  return {share(i[0], i[2], i[6]) * Rational(i[4]), (1 - share(i[1], i[3], i[7])) * Rational(i[5])};
}

/// Whether windows that the header's domain lacks are refused.
double refusal_error(const Input& i) {
  try {
    map_of(i);
  } catch (const ContractViolation&) {
    return 0;
  }
  return wrong;
}

double place_error(const Input& i) {
  if (!in_domain(i)) return has_picture(i) ? refusal_error(i) : 0;
  const Mapping<double> map = map_of(i);
  if (!all_finite(i)) return viewport::rasterize(map, dvec2{i[6], i[7]}) ? wrong : 0;
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
  if (!in_domain(i) || !all_finite(i)) return 0;
  const Mapping<double> map = map_of(i);
  const dvec2 place = viewport::place_at(map.viewport, viewport::fraction_of(map, {i[6], i[7]}));
  const dvec2 back = viewport::to_plane(map, place);
  const auto exact = exact_place(i);
  double worst = 0;
  if (!all_finite({place.x, place.y, back.x, back.y})) {
    return exact[0] < 0 || exact[0] > Rational(i[4]) || exact[1] < 0 || exact[1] > Rational(i[5]) ? 0 : wrong;
  }
  for (int k : {0, 1}) {
    const auto at = static_cast<std::size_t>(k);
    if (exact[at] < 0 || exact[at] > Rational(i[4 + at])) return 0;  // places in the viewport
    const double largest = std::max(std::abs(i[at]), std::abs(i[at + 2]));
    const Rational off = abs(Rational(back[k]) - Rational(i[6 + at])) / Rational(ulp_of(largest));
    worst = std::max(worst, static_cast<double>(off));
  }
  return worst;
}

// --- The centre of a pixel: a window, the picture's size, then how far across and down the pixel lies ----

/// Windows whose pixels measure from one to 2^20 ulp of their largest coordinate, near the origin and far.
Input centre_input(Kind kind, Random& random) {
  Input input = generate(kind == Kind::near_degenerate ? Kind::random : kind, random);
  for (std::size_t k : {0U, 1U}) {
    input[4 + k] = std::floor(std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(0, 12))));
    if (kind == Kind::near_degenerate || kind == Kind::grazing) {
      const double far = sized(random, -20, 60),
                   pixel = std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(2, 20)));
      input[k] = far;
      input[k + 2] = far + pixel * ulp_of(std::abs(far)) * input[4 + k];
    }
    input[6 + k] = random.unit();
  }
  return input;
}

double centre_error(const Input& i) {
  if (!in_domain(i)) return 0;
  for (std::size_t k : {0U, 1U}) {
    const Rational pixel = (Rational(i[k + 2]) - Rational(i[k])) / Rational(i[4 + k]);
    if (pixel < 9 * Rational(ulp_of(std::max(std::abs(i[k]), std::abs(i[k + 2]))))) return 0;
    if (!(0 <= i[6 + k] && i[6 + k] < 1)) return 0;
  }
  const Mapping<double> map = map_of(i);
  const ivec2 pixel{static_cast<int>(i[6] * i[4]), static_cast<int>(i[7] * i[5])};
  const dvec2 centre = viewport::pixel_centre(map, pixel);
  return viewport::rasterize(map, centre) == std::optional(pixel) ? 0 : wrong;
}

}  // namespace

Domain viewport() {
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
                                Kind::ties,   Kind::denormal,        Kind::extremes};
  const auto in_order = [](Input& input) {
    put_in_order(input[0], input[2]);
    put_in_order(input[1], input[3]);
  };
  const std::vector<std::size_t> lengths{0, 1, 2, 3, 6, 7};
  const std::vector<Trap> traps{
      {"the last column's right side", {0, 0, 1, 1, 640, 480, 1, 0.5}},
      {"half a pixel", {-1, -1, 1, 1, 640, 480, 0.0015625, 0}},
      {"a window of the smallest doubles", {0, 0, 0x1p-1073, 0x1p-1074, 640, 480, 0x1p-1074, 0}},
      {"a window whose size overflows", {-1e308, 0, 1e308, 1, 640, 480, 0, 0}},
      {"a window of one unit in the last place", {1, 1, 1 + 0x1p-52, 2, 3, 3, 1, 1}}};
  return {"viewport",
          {{.name = "rasterize",
            .states = "the place within 5/2 ulp of the width, and the pixel that has it",
            .unit = "ulp",
            .bound = 2.5,
            .numbers = 8,
            .kinds = kinds,
            .generate = at_every_scale(generate, lengths, in_order),
            .error = place_error,
            .traps = traps},
           {.name = "to_plane",
            .states = "there and back within 4 ulp of the window's largest coordinate",
            .unit = "ulp",
            .bound = 4,
            .numbers = 8,
            .kinds = kinds,
            .generate = at_every_scale(generate, lengths, in_order),
            .error = back_error,
            .traps = traps},
           {.name = "pixel_centre",
            .states = "lies in its pixel where that measures 9 ulp of the window's largest coordinate",
            .unit = "pixels",
            .bound = 0,
            .numbers = 8,
            .kinds = kinds,
            .generate = at_every_scale(centre_input, {0, 1, 2, 3}, in_order),
            .error = centre_error,
            .traps = {{"pixels of half an ulp", {1e9, 0, 1e9 + 1e-4, 1, 1920, 1080, 0.3, 0.7}},
                      {"pixels of 9 ulp, from a power of two on",
                       {0x1p30, 0, 0x1p30 + 9 * 1920 * 0x1p-22, 1, 1920, 1080, 0.9999, 0.7}},
                      {"pixels of 9 ulp, up to a power of two",
                       {0x1p30 - 9 * 1920 * 0x1p-23, 0, 0x1p30 - 0x1p-23, 1, 1919, 1080, 0.9999, 0.7}}}}}};
}

}  // namespace gradus::stress
