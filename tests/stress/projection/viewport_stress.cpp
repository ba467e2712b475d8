// The promises of the way from the camera plane to pixels, and back.

#include "stress/projection/viewport.hpp"

#include <algorithm>
#include <array>

#include "projection/viewport/viewport_notes.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::viewport;

constexpr Rounding roundings[] = {Rounding::floor, Rounding::half_up, Rounding::half_even};

/// xmin, ymin, xmax, ymax, width, height, a point of the plane, and how the window is fitted in: 0 to 3.
constexpr std::size_t numbers = 9;

Input window_and_point(Kind kind, Random& random) {
  Input input(numbers);
  for (std::size_t k = 0; k < 4; ++k) input[k] = number(kind, random);
  for (std::size_t k : {4u, 5u}) {
    input[k] = random.unit() < 0.5 ? std::floor(std::ldexp(1.0, static_cast<int>(random.uniform_int(0, 30))))
                                   : static_cast<double>(random.uniform_int(1, 5000));
  }
  input[8] = static_cast<double>(random.uniform_int(0, 3));
  if (kind == Kind::huge) {
    for (double& x : input) x = x > 0x1p40 || x < -0x1p40 ? x / 4 : x;  // the window's size doesn't overflow
  }
  if (kind == Kind::near_degenerate) {  // a small window far away
    const double far = sized(random, 20, 60);
    for (std::size_t i = 0; i < 4; ++i) input[i] = far + std::ldexp(input[i], std::ilogb(far) - 45);
  }
  for (std::size_t i : {0u, 1u}) {
    put_in_order(input[i], input[i + 2]);
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

dvec2 point_in(const Input& i) { return {i[6], i[7]}; }

template <class T>
Mapping<T> map_in(const Input& i, bool boxed) {
  const Rectangle<T> window{{T(i[0]), T(i[1])}, {T(i[2]), T(i[3])}};
  const ivec2 picture{static_cast<int>(i[4]), static_cast<int>(i[5])};
  const RowZero row_zero = i[8] == 1 || i[8] == 3 ? RowZero::bottom : RowZero::top;
  return boxed ? letterboxed(window, picture, row_zero) : stretched(window, picture, row_zero);
}
bool is_boxed(const Input& i) { return i[8] >= 2; }

bool has_picture(const Input& i) {
  return std::ranges::all_of(std::array{i[4], i[5]},
                             [](double n) { return n >= 1 && n <= most_pixels && n == std::floor(n); });
}
bool has_window(const Input& i) {
  return i[0] < i[2] && i[1] < i[3] && gradus::all_finite(i[0], i[1], i[2] - i[0], i[3] - i[1]);
}
bool in_domain(const Input& i) { return has_window(i) && has_picture(i) && all_finite(i); }

/// A letterbox of less than a pixel.
bool is_thin(const Mapping<double>& map) {
  const dvec2 size = map.viewport.size();
  return !(size.x >= 1 && size.y >= 1);
}

template <class T>
glm::vec<2, T> place_of(const Mapping<T>& map, const glm::vec<2, T>& point) {
  return place_at(map.viewport, fraction_of(map, point));
}

/// How far a place is from the nearest one at which the pixel changes.
Exact from_a_border(const Exact& x, Rounding rounding) {
  const Exact shifted = rounding == Rounding::floor ? x : x + Exact(1, 2);
  const Exact part = shifted - Exact(floor(shifted));
  return std::min(part, Exact(1) - part);
}

double place_error(const Input& i) {
  if (!has_picture(i)) return 0;
  const auto map = accepted([&] { return map_in<double>(i, false); });
  if (map.has_value() != has_window(i)) return wrong;
  if (!map) return 0;
  const dvec2 point = point_in(i), place = place_of(*map, point);
  if (!all_finite(i)) return rasterize(*map, point) && !gradus::all_finite(point.x, point.y) ? wrong : 0;
  const ExactScope scope;
  const auto exact_map = map_in<Exact>(i, false);
  const ExactVec2 exact = exact_place(*map, point);
  if (place_of(exact_map, ExactVec2(point)) != exact) return wrong;
  double worst = 0;
  std::array<bool, 3> clear{true, true, true};  // of sides of pixels within the bound
  for (int k = 0; k < 2; ++k) {
    const Exact size(map->picture[k]), ulp = ulp_of<double>(size), bound = ulp * Exact(5, 2);
    if (abs(exact[k]) > Exact(2) * size) continue;
    if (Exact(0) <= exact[k] && exact[k] <= size) {
      worst = std::max(worst, in_bounds(abs(Exact(place[k]) - exact[k]), ulp));
    }
    for (std::size_t r = 0; r < 3; ++r) {
      clear[r] = clear[r] && from_a_border(exact[k], roundings[r]) > bound &&
                 from_a_border(exact[k], Rounding::floor) > bound;
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    const auto pixel = exact_pixel(exact, map->picture, roundings[r]);
    if (rasterize(exact_map, ExactVec2(point), roundings[r]) != pixel) return wrong;
    if (clear[r] && rasterize(*map, point, roundings[r]) != pixel) return wrong;
  }
  return worst;
}

bool is_inside(const Input& i) {
  return in_domain(i) && rasterize(map_in<double>(i, false), point_in(i)).has_value();
}

double back_error(const Input& i) {
  if (!in_domain(i)) return 0;
  const ExactScope scope;
  const auto map = map_in<double>(i, is_boxed(i));
  const auto exact_map = map_in<Exact>(i, is_boxed(i));
  const dvec2 point = point_in(i);
  const ExactVec2 exact = place_of(exact_map, ExactVec2(point));
  if (is_thin(map)) return 0;
  for (int k = 0; k < 2; ++k) {  // places in the viewport
    if (exact[k] < exact_map.viewport.lower[k] || exact[k] > exact_map.viewport.upper[k]) return 0;
  }
  const dvec2 back = to_plane(map, place_of(map, point));
  double worst = 0;
  for (int k = 0; k < 2; ++k) {
    if (!std::isfinite(back[k])) return wrong;
    const double largest = std::max(std::abs(map.window.lower[k]), std::abs(map.window.upper[k]));
    const Exact bars = Exact(map.picture[k]) / exact_map.viewport.size()[k];
    const Exact off = abs(Exact(back[k]) - Exact(point[k]));
    worst = std::max(worst, in_bounds(off, ulp_of<double>(Exact(largest)) * bars));
  }
  return worst;
}

// --- Pixels: instead of a point how far across and down one lies ------------------------------------------

/// Windows whose pixels measure from one to 2^20 ulp of their largest coordinate, near the origin and far.
Input window_and_pixel(Kind kind, Random& random) {
  Input input = window_and_point(kind == Kind::near_degenerate ? Kind::random : kind, random);
  for (std::size_t k : {0u, 1u}) {
    input[4 + k] = std::floor(std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(0, 12))));
    if (kind == Kind::near_degenerate || kind == Kind::grazing) {
      const double far = sized(random, -20, 60),
                   pixel = std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(2, 20)));
      input[k] = far;
      input[k + 2] = far + pixel * (std::nextafter(std::abs(far), wrong) - std::abs(far)) * input[4 + k];
    }
    input[6 + k] = random.unit();
  }
  return input;
}

/// The centre of a pixel leads back to it where pixels measure 9 ulp of the window's largest coordinate (in a
/// letterbox, whose sides may pass through centres, 64), and within 4 of them.
double centre_error(const Input& i) {
  if (!in_domain(i)) return 0;
  const ExactScope scope;
  const auto map = map_in<double>(i, is_boxed(i));
  const dvec2 used = map.viewport.size();
  if (is_thin(map)) return 0;
  dvec2 ulps;  // of the largest coordinate in a pixel
  for (std::size_t k : {0u, 1u}) {
    const int axis = static_cast<int>(k);
    const double largest = std::max(std::abs(i[k]), std::abs(i[k + 2]));
    const Exact pixel = (Exact(i[k + 2]) - Exact(i[k])) / Exact(used[axis]);
    const Exact ulp = ulp_of<double>(Exact(largest));
    if (pixel < Exact(is_boxed(i) ? 64 : 9) * ulp) return 0;
    if (!(0 <= i[6 + k] && i[6 + k] < 1)) return 0;
    ulps[axis] = to_double(pixel / (ulp * Exact(i[4 + k]) / Exact(used[axis])));
  }
  const ivec2 pixel{static_cast<int>(i[6] * i[4]), static_cast<int>(i[7] * i[5])};
  const dvec2 centre = dvec2(pixel) + 0.5, point = pixel_centre(map, pixel);
  const auto again = rasterize(map, point);
  if (!holds(map.viewport, centre)) return again && *again != pixel ? wrong : 0;
  const dvec2 room = glm::min(centre - map.viewport.lower, map.viewport.upper - centre);
  if (again != pixel && (!is_boxed(i) || std::min(room.x, room.y) > 1e-9)) return wrong;
  const dvec2 off = glm::abs(place_of(map, point) - centre) * ulps;
  return std::max(off.x, off.y) / 4;
}

/// The window's corners are the picture's, exactly, and the clamp never says that a point is outside.
double corner_error(const Input& i) {
  if (!in_domain(i)) return 0;
  const auto map = map_in<double>(i, false);
  const auto& [lower, upper] = map.window;
  const bool top = map.row_zero == RowZero::top;
  const dvec2 first{lower.x, top ? upper.y : lower.y}, last{upper.x, top ? lower.y : upper.y};
  const bool kept = place_of(map, first) == dvec2(0) && place_of(map, last) == dvec2(map.picture) &&
                    rasterize(map, first) == ivec2(0) && !rasterize(map, last) &&
                    std::ranges::all_of(roundings, [&](Rounding rounding) {
                      return map.has(clamped(map, point_in(i), rounding));
                    });
  return kept ? 0 : wrong;
}

// --- In exact arithmetic ----------------------------------------------------------------------------------

Input small_picture(Kind kind, Random& random) {
  Input input = window_and_point(kind, random);
  for (std::size_t k : {4u, 5u}) input[k] = static_cast<double>(random.uniform_int(1, 5000));
  return input;
}

bool there_and_back(const Input& i) {
  if (!in_domain(i)) return true;
  const ExactVec2 point(point_in(i));
  for (const bool boxed : {false, true}) {
    const auto map = map_in<Exact>(i, boxed);
    const auto& [lower, upper] = map.window;
    const bool top = map.row_zero == RowZero::top;
    const ExactVec2 first{lower.x, top ? upper.y : lower.y}, last{upper.x, top ? lower.y : upper.y};
    if (to_plane(map, place_of(map, point)) != point || place_of(map, first) != map.viewport.lower ||
        place_of(map, last) != map.viewport.upper) {
      return false;
    }
  }
  // A letterbox scales both axes alike, fills one side and stands in the middle of the other
  const auto map = map_in<Exact>(i, true);
  const ExactVec2 used = map.viewport.size(), size = map.window.size(), picture(map.picture);
  if (used.x * size.y != used.y * size.x || (used.x != picture.x && used.y != picture.y) ||
      used.x > picture.x || used.y > picture.y || map.viewport.lower + map.viewport.upper != picture) {
    return false;
  }
  // In doubles, within 2 ulp of the picture
  const auto rounded = map_in<double>(i, true).viewport;
  for (int k = 0; k < 2; ++k) {
    const Exact bound = Exact(0x1p-51) * picture[k];
    if (abs(Exact(rounded.lower[k]) - map.viewport.lower[k]) > bound) return false;
    if (abs(Exact(rounded.upper[k]) - map.viewport.upper[k]) > bound) return false;
  }
  const Rectangle<Exact> square{ExactVec2(Exact(-1)), ExactVec2(Exact(1))};
  return to_pixel(point, map.picture.x, map.picture.y) == place_of(stretched(square, map.picture), point);
}

bool has_bars(const Input& i) { return (i[2] - i[0]) * i[5] != (i[3] - i[1]) * i[4]; }

/// A number, rounded.
Input any_number(Kind kind, Random& random) {
  double x = random.uniform(-1e6, 1e6);
  if (kind == Kind::ties || kind == Kind::grazing) x = std::floor(x) + 0.5;
  return {kind == Kind::grazing ? nudged(x, random) : x};
}

double rounding_error(const Input& i) {
  if (!(std::abs(i[0]) < 0x7fffff80)) return 0;
  const ExactScope scope;
  const auto single = static_cast<float>(i[0]);
  for (const Rounding rounding : roundings) {
    const auto right = exactly_rounded(Exact(i[0]), rounding);
    if (rounded(i[0], rounding) != right || rounded(Exact(i[0]), rounding) != right) return wrong;
    if (rounded(single, rounding) != exactly_rounded(Exact(single), rounding)) return wrong;
  }
  return 0;
}

}  // namespace

Domain viewport() {
  const auto in_order = [](Input& input) {
    put_in_order(input[0], input[2]);
    put_in_order(input[1], input[3]);
  };
  const Generator generate = at_every_scale(window_and_point, {0, 1, 2, 3, 6, 7}, in_order);
  Property back =
      exact_relation("there_and_back", "it is the same point, and a letterbox keeps the window's shape",
                     numbers, there_and_back, small_picture);
  back.shares = {{"with bars", 0.9, has_bars}};
  const std::vector<Trap> traps{
      {"the last column's right side", {0, 0, 1, 1, 640, 480, 1, 0.5, 0}},
      {"half a pixel", {-1, -1, 1, 1, 640, 480, 0.0015625, 0, 0}},
      {"a window of the smallest doubles", {0, 0, 0x1p-1073, 0x1p-1074, 640, 480, 0x1p-1074, 0, 0}},
      {"a window whose size overflows", {-1e308, 0, 1e308, 1, 640, 480, 0, 0, 0}},
      {"a window of one unit in the last place", {1, 1, 1 + 0x1p-52, 2, 3, 3, 1, 1, 0}}};
  return {"viewport",
          {{.name = "rasterize",
            .states = "the place within 5/2 ulp of the width, and the pixel that has it by each rounding",
            .unit = "ulp",
            .bound = 2.5,
            .numbers = numbers,
            .generate = generate,
            .error = place_error,
            .traps = traps,
            .shares = {{"inside", 0.2, is_inside},
                       {"outside", 0.2, [](const Input& i) { return in_domain(i) && !is_inside(i); }}}},
           {.name = "to_plane",
            .states = "there and back within 4 ulp of the window's largest coordinate, times picture / "
                      "viewport in a letterbox",
            .unit = "ulp",
            .bound = 4,
            .numbers = numbers,
            .generate = generate,
            .error = back_error,
            .traps = traps},
           {.name = "pixel_centre",
            .states = "lies in its pixel where that measures 9 ulp of the window's largest coordinate, and "
                      "leads back within 4 of them",
            .unit = "bounds",
            .bound = 1,
            .numbers = numbers,
            .generate = at_every_scale(window_and_pixel, {0, 1, 2, 3}, in_order),
            .error = centre_error,
            .traps = {{"pixels of half an ulp", {1e9, 0, 1e9 + 1e-4, 1, 1920, 1080, 0.3, 0.7, 0}},
                      {"pixels of 9 ulp, from a power of two on",
                       {0x1p30, 0, 0x1p30 + 9 * 1920 * 0x1p-22, 1, 1920, 1080, 0.9999, 0.7, 0}},
                      {"pixels of 9 ulp, up to a power of two",
                       {0x1p30 - 9 * 1920 * 0x1p-23, 0, 0x1p30 - 0x1p-23, 1, 1919, 1080, 0.9999, 0.7, 0}}},
            .cases = 100'000},
           {.name = "corners",
            .states = "the window's corners are the picture's, and the clamp never says outside",
            .numbers = numbers,
            .generate = generate,
            .error = corner_error,
            .cases = 50'000},
           back,
           {.name = "rounded",
            .states = "each rounding is exact, of float, double and rationals",
            .numbers = 1,
            .kinds = {Kind::random, Kind::ties, Kind::grazing},
            .generate = any_number,
            .error = rounding_error,
            .cases = 20'000}}};
}

}  // namespace gradus::stress
