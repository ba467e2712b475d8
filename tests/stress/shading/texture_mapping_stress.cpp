// The promises of texture mapping: places and footprints against exact rationals, the nearest texel without a
// rounding, four texels against the formula, levels whose mean stays, and one colour that stays that colour.

#include "shading/texture_mapping/texture_mapping.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/arithmetic/exact_scalar.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace texture_mapping;

constexpr double unit = 0x1p-53;
constexpr Window picture{{0, 0}, {31, 31}};

// --- Triangles

constexpr std::size_t numbers_of_corner = 5;

/// x, y, w, u and v of three corners.
Input triangle(Kind kind, Random& random) {
  Input input;
  for (int k = 0; k < 3; ++k) {
    const double steep =
        kind == Kind::grazing ? std::ldexp(1, static_cast<int>(random.uniform_int(-20, 20))) : 1;
    input.insert(input.end(),
                 {random.uniform(-8, 40), random.uniform(-8, 40), steep * random.uniform(0.5, 16),
                  random.uniform(-4, 4), random.uniform(-4, 4)});
  }
  if (kind == Kind::ties) {
    for (double& x : input) x = std::ceil(x);
    for (std::size_t k = 2; k < input.size(); k += numbers_of_corner) input[k] = std::max(input[k], 1.0);
  }
  if (kind == Kind::near_degenerate) {
    // The third corner lies almost on the way from the first to the second
    const double t = random.uniform(0, 1);
    for (const std::size_t k : {0U, 1U})
      input[10 + k] = nudged(input[k] + t * (input[5 + k] - input[k]), random);
  }
  return input;
}

bool is_triangle(const Input& i) {
  for (std::size_t k = 0; k < i.size(); ++k) {
    const bool depth = k % numbers_of_corner == 2;
    if (depth ? !(0x1p-40 <= i[k] && i[k] <= 0x1p40) : !(std::abs(i[k]) <= 4096)) return false;
  }
  return true;
}

struct Drawn {
  Triangle triangle;
  Corners<double> corners;
};
Drawn drawn(const Input& i) {
  Drawn d{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = numbers_of_corner * k;
    d.triangle[k] = triangle_coverage::snap({i[at], i[at + 1]});
    d.corners[k] = {1 / i[at + 2], {i[at + 3], i[at + 4]}};
  }
  return d;
}
double largest_coordinate(const Corners<double>& corners) {
  double most = 0;
  for (const auto& c : corners) most = std::max({most, std::abs(c.uv.x), std::abs(c.uv.y)});
  return most;
}

/// What each corner has a share of: twice the area that the place makes with the others.
std::array<Exact, 3> exact_shares(const Triangle& t, const Exact& x, const Exact& y) {
  std::array<Exact, 3> shares;
  for (std::size_t k = 0; k < 3; ++k) {
    const ivec2 a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    shares[k] = (Exact(a.x) - x) * (Exact(b.y) - y) - (Exact(a.y) - y) * (Exact(b.x) - x);
  }
  return shares;
}
/// (u, v) where the picture has the place (x, y), in 1/256 pixel.
glm::vec<2, Exact> exact_place(const Drawn& d, const Exact& x, const Exact& y) {
  const std::array<Exact, 3> shares = exact_shares(d.triangle, x, y);
  Exact u(0), v(0), all(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Exact share = shares[k] * Exact(d.corners[k].over_w);
    all = all + share;
    u = u + share * Exact(d.corners[k].uv.x);
    v = v + share * Exact(d.corners[k].uv.y);
  }
  return {u / all, v / all};
}

/// Every so many pixels: rationals are dear.
template <class Look>
void look_at_some(const Drawn& d, const Look& look) {
  int pixels = 0;
  const ExactScope scope;
  perspective_correct(d.triangle, d.corners, picture, [&](ivec2 pixel, dvec2 uv, const auto& footprint) {
    if (pixels++ % 31 == 0) look(pixel, uv, footprint);
  });
}

double place_error(const Input& i) {
  if (!is_triangle(i)) return 0;
  const Drawn d = drawn(i);
  const double size = largest_coordinate(d.corners);
  if (size == 0) return 0;
  double worst = 0;
  look_at_some(d, [&](ivec2 pixel, dvec2 uv, const auto&) {
    const ivec2 centre = triangle_coverage::centre_of(pixel);
    const auto right = exact_place(d, Exact(centre.x), Exact(centre.y));
    for (const int axis : {0, 1})
      worst = std::max(worst, std::abs(to_double(Exact(uv[axis]) - right[axis])) / (unit * size));
  });
  return worst;
}

/// The footprint is the derivative: the quotient rule with rationals, from shares a pixel apart.
double footprint_error(const Input& i) {
  if (!is_triangle(i)) return 0;
  const Drawn d = drawn(i);
  const double size = largest_coordinate(d.corners);
  if (size == 0) return 0;
  double worst = 0;
  look_at_some(d, [&](ivec2 pixel, dvec2, const Footprint<double>& footprint) {
    const ivec2 c = triangle_coverage::centre_of(pixel);
    const auto here = exact_shares(d.triangle, Exact(c.x), Exact(c.y));
    const auto uv = exact_place(d, Exact(c.x), Exact(c.y));
    for (const bool down : {false, true}) {
      const auto there =
          exact_shares(d.triangle, Exact(c.x + (down ? 0 : 256)), Exact(c.y + (down ? 256 : 0)));
      Exact all(0), growth_u(0), growth_v(0), steps(0);
      for (std::size_t k = 0; k < 3; ++k) {
        const Exact q(d.corners[k].over_w), step = (there[k] - here[k]) * q;
        all = all + here[k] * q;
        growth_u = growth_u + step * (Exact(d.corners[k].uv.x) - uv.x);
        growth_v = growth_v + step * (Exact(d.corners[k].uv.y) - uv.y);
        steps = steps + (step < Exact(0) ? Exact(0) - step : step);
      }
      const dvec2 found = down ? footprint.along_y : footprint.along_x;
      const double allowed = unit * size * std::abs(to_double(steps / all));
      if (allowed == 0) continue;
      worst = std::max(worst, std::abs(to_double(Exact(found.x) - growth_u / all)) / allowed);
      worst = std::max(worst, std::abs(to_double(Exact(found.y) - growth_v / all)) / allowed);
    }
  });
  return worst;
}

// --- Filters

/// Texels without a pattern, in [0, 1).
double texel_of(ivec2 at) {
  return ((at.x * 7919 + at.y * 104'729 + 17 * at.x * at.y) % 1009 + 1009) % 1009 / 1009.0;
}

/// u, v, columns and rows.
Input look_up(Kind kind, Random& random) {
  const double most = kind == Kind::grazing && random.unit() < 0.5 ? 1000 : 40;
  Input i{random.uniform(-3, 3), random.uniform(-3, 3), std::floor(random.uniform(1, most)),
          std::floor(random.uniform(1, most))};
  if (kind == Kind::ties || kind == Kind::grazing) {
    // A border or a middle of a texel, or beside it
    for (const std::size_t k : {0U, 1U}) {
      i[k] = std::floor(2 * i[k] * i[2 + k]) / (2 * i[2 + k]);
      if (kind == Kind::grazing) i[k] = nudged(i[k], random);
    }
  }
  if (kind == Kind::tiny) i[0] = sized(random, -1000, -300);
  return i;
}
bool is_look_up(const Input& i) {
  const auto count = [](double x) { return x == std::floor(x) && 1 <= x && x <= 1024; };
  return std::abs(i[0]) <= 1024 && std::abs(i[1]) <= 1024 && count(i[2]) && count(i[3]);
}
ivec2 size_in(const Input& i) { return {static_cast<int>(i[2]), static_cast<int>(i[3])}; }

/// Whether u times the columns is rounded to a whole number that u itself has not reached.
bool is_rounded_up(const Input& i) {
  const ExactScope scope;
  return is_look_up(i) && Exact(std::floor(i[0] * i[2])) > Exact(i[0]) * Exact(i[2]);
}

double nearest_error(const Input& i) {
  if (!is_look_up(i)) return 0;
  ivec2 found{};
  nearest({i[0], i[1]}, {size_in(i)}, [&](ivec2 at) {
    found = at;
    return 0.0;
  });
  const ExactScope scope;
  // The texel's cell, in some tile, holds the place
  const auto holds = [](double x, int count, int cell) {
    const Exact scaled = Exact(x) * Exact(count);
    const double tile = std::floor(x);
    for (const double t : {tile - 1, tile, tile + 1}) {
      const Exact first = Exact(t) * Exact(count) + Exact(cell);
      if (first <= scaled && scaled < first + Exact(1)) return true;
    }
    return false;
  };
  const ivec2 size = size_in(i);
  return holds(i[0], size.x, found.x) && holds(i[1], size.y, size.y - 1 - found.y) ? 0 : wrong;
}

double bilinear_error(const Input& i) {
  if (!is_look_up(i)) return 0;
  const Extent texture{size_in(i), i[2] < i[3] ? Wrap::repeat : Wrap::clamp};
  const ExactScope scope;
  const auto [columns, rows] = std::array{static_cast<int>(i[2]), static_cast<int>(i[3])};
  const Exact x = Exact(i[0]) * Exact(columns), y = Exact(i[1]) * Exact(rows);
  const auto first = [](double scaled) { return static_cast<std::int64_t>(std::floor(scaled)) - 2; };
  // A tent over the middle of each texel round about
  const auto tent = [](const Exact& from) {
    const Exact far = from < Exact(0) ? Exact(0) - from : from;
    return far < Exact(1) ? Exact(1) - far : Exact(0);
  };
  Exact sum(0);
  for (std::int64_t r = first(to_double(y)), row = r; row < r + 5; ++row) {
    for (std::int64_t c = first(to_double(x)), column = c; column < c + 5; ++column) {
      const Exact part = tent(x - Exact(column) - Exact(0.5)) * tent(y - Exact(row) - Exact(0.5));
      sum = sum + part * Exact(texel_of(texel_in(column, row, texture)));
    }
  }
  const double found = bilinear({i[0], i[1]}, texture, texel_of);
  return std::abs(to_double(Exact(found) - sum)) /
         (unit * (12 + 4 * (columns * std::abs(i[0]) + rows * std::abs(i[1]))));
}

// --- Levels

/// Columns, rows and a grey.
Input sizes(Kind kind, Random& random) {
  Input i{std::floor(random.uniform(1, 34)), std::floor(random.uniform(1, 34)), random.uniform(0, 1)};
  if (kind == Kind::ties) {
    for (const std::size_t k : {0U, 1U}) i[k] = std::ldexp(1, static_cast<int>(random.uniform_int(0, 5)));
  }
  return i;
}
bool is_size_and_grey(const Input& i) {
  const auto count = [](double x) { return x == std::floor(x) && 1 <= x && x <= 64; };
  return count(i[0]) && count(i[1]) && 0 <= i[2] && i[2] <= 1;
}
template <class Texel>
std::vector<double> chain_of(ivec2 size, const Texel& texel) {
  std::vector<double> chain(texels_of_chain(size));
  build_mip_chain(size, texel, std::span(chain));
  return chain;
}

/// In units of 16 u per level; for powers of two and 8-bit grey any difference is wrong.
double mean_error(const Input& i) {
  if (!is_size_and_grey(i)) return 0;
  const ivec2 size(i[0], i[1]);
  const auto texel = [](ivec2 at) { return std::floor(256 * texel_of(at)) / 256; };
  const std::vector<double> chain = chain_of(size, texel);
  const ExactScope scope;
  const auto mean = [&](int level) {
    Exact sum(0);
    const std::size_t first = begin_of_level(size, level), last = begin_of_level(size, level + 1);
    for (std::size_t k = first; k < last; ++k) sum = sum + Exact(chain[k]);
    return sum / Exact(static_cast<std::int64_t>(last - first));
  };
  const auto power = [](int x) { return (x & (x - 1)) == 0; };
  double worst = 0;
  for (int level = 1; level < levels_of(size); ++level) {
    const double off = std::abs(to_double(mean(level) - mean(0)));
    if (off > 0 && power(size.x) && power(size.y)) return wrong;
    worst = std::max(worst, off / (16 * unit * level));
  }
  return worst;
}

double constant_error(const Input& i) {
  if (!is_size_and_grey(i)) return 0;
  const ivec2 size(i[0], i[1]);
  const double grey = i[2];
  const std::vector<double> chain = chain_of(size, [&](ivec2) { return grey; });
  for (const double texel : chain) {
    if (texel != grey) return wrong;
  }
  const MipChain<double> levels(size, chain);
  if (bilinear({grey, -1.3}, {size}, [&](ivec2) { return grey; }) != grey) return wrong;
  for (const double stretch : {0.01, 0.1, 0.37, 1.0, 5.0}) {
    if (mip_mapped({grey, stretch}, {{stretch, grey}, {0, stretch}}, levels) != grey) return wrong;
  }
  return 0;
}

/// A length, and how many levels there are.
Input length_and_levels(Kind kind, Random& random) {
  double length = std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(-3, 18)));
  if (kind == Kind::ties) length = std::ldexp(1, static_cast<int>(random.uniform_int(-3, 18)));
  if (kind == Kind::grazing)
    length = nudged(std::ldexp(1, static_cast<int>(random.uniform_int(-3, 18))), random);
  if (kind == Kind::refused) length = number(kind, random);
  return {length, static_cast<double>(random.uniform_int(1, 16))};
}
/// In units of 2^-50.
double level_error(const Input& i) {
  if (!(i[1] == std::floor(i[1]) && 1 <= i[1] && i[1] <= 16) || i[0] < 0) return 0;
  const Level found = level_of(i[0], static_cast<int>(i[1]));
  const long double right =
      std::clamp(std::log2(static_cast<long double>(i[0])), 0.0L, static_cast<long double>(i[1] - 1));
  if (!(i[0] < 0x1p20)) return found.lower == static_cast<int>(i[1]) - 1 && found.part == 0 ? 0 : wrong;
  if (found.lower != static_cast<int>(std::floor(right)) || !(0 <= found.part && found.part <= 1))
    return wrong;
  return static_cast<double>(std::abs(found.lower + static_cast<long double>(found.part) - right) * 0x1p50L);
}

using Flags = std::vector<std::pair<std::string, std::string>>;

Flags shown_place(const Input& i) {
  if (!is_triangle(i)) return {};
  std::string corners;
  for (const std::size_t k : {0U, 1U, 2U, 2U}) {
    const std::size_t at = numbers_of_corner * k;
    if (!(1e-3 <= i[at + 2] && i[at + 2] <= 4096)) return {};
    for (const std::size_t axis : {0U, 1U}) {
      if (i[at + axis] != 0 && std::abs(i[at + axis]) < 1e-3) return {};
    }
    corners +=
        fmt::format("{}{:.17g},{:.17g},{:.17g}", corners.empty() ? "" : " ", i[at], i[at + 1], i[at + 2]);
  }
  return {{"corners", corners}};
}

}  // namespace

Domain texture_mapping() {
  const std::vector<Kind> triangles{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
  return {
      "texture_mapping",
      {{.name = "place",
        .states = "(u, v) at a pixel is that of the surface, within 16 u of the largest corner coordinate",
        .unit = "of u times the largest coordinate",
        .bound = 16,
        .numbers = 15,
        .kinds = triangles,
        .generate = triangle,
        .error = place_error,
        .arguments = shown_place,
        .traps = {{"an edge from w = 1 to w = 3", {0, 0, 1, 0, 0, 31, 0, 3, 1, 0, 15, 31, 2, 0.5, 1}},
                  {"far away in a corner", {0, 0, 0x1p-40, 0, 0, 31, 0, 0x1p40, 1, 0, 0, 31, 0x1p40, 0, 1}}},
        .cases = 500},
       {.name = "footprint",
        .states = "the footprint is the derivative, within 64 u of what the weights grow by in a pixel",
        .unit = "of u times the growth of the weights",
        .bound = 64,
        .numbers = 15,
        .kinds = triangles,
        .generate = triangle,
        .error = footprint_error,
        .arguments = shown_place,
        .traps = {{"seen straight on", {0, 0, 1, 0, 0, 31, 0, 1, 1, 0, 0, 31, 1, 0, 1}}},
        .cases = 300},
       {.name = "nearest",
        .states = "the nearest texel's cell holds the place, whatever rounding would say",
        .unit = "texels",
        .bound = 0,
        .numbers = 4,
        .kinds = {Kind::random, Kind::grazing, Kind::ties, Kind::tiny},
        .generate = look_up,
        .error = nearest_error,
        .traps = {{"a product rounded up", {std::nextafter(1.0 / 3, 0.0), 0.5, 3, 3}},
                  {"just left of the texture", {-0x1p-60, 0, 7, 7}}},
        .shares = {{"the plain formula is wrong", 0.01, is_rounded_up}},
        .cases = 4'000},
       {.name = "bilinear",
        .states = "four texels mixed are the formula's, within u (12 + 4 (columns |u| + rows |v|))",
        .unit = "of that bound",
        .bound = 1,
        .numbers = 4,
        .kinds = {Kind::random, Kind::grazing, Kind::ties, Kind::tiny},
        .generate = look_up,
        .error = bilinear_error,
        .traps = {{"one texel", {0.3, 0.3, 1, 1}}, {"the middle of a texel", {0.5, 0.5, 5, 3}}},
        .cases = 500},
       {.name = "mean",
        .states = "levels keep the mean: exactly for powers of two, else within 16 u per level",
        .unit = "of 16 u per level",
        .bound = 1,
        .numbers = 3,
        .kinds = {Kind::random, Kind::ties},
        .generate = sizes,
        .error = mean_error,
        .traps = {{"a row of 5", {5, 1, 0}}, {"odd all the way", {31, 15, 0}}},
        .cases = 200},
       {.name = "constant",
        .states = "a texture of one colour has that colour everywhere, to the last bit",
        .unit = "colours",
        .bound = 0,
        .numbers = 3,
        .kinds = {Kind::random, Kind::ties},
        .generate = sizes,
        .error = constant_error,
        .traps = {{"a third", {7, 7, 1.0 / 3}}},
        .cases = 1'000},
       {.name = "level",
        .states =
            "the level is the logarithm of the footprint's side: its whole part exact, the rest within 2^-50",
        .unit = "of 2^-50",
        .bound = 1,
        .numbers = 2,
        .kinds = {Kind::random, Kind::grazing, Kind::ties, Kind::refused},
        .generate = length_and_levels,
        .error = level_error,
        .traps = {{"just below two texels", {std::nextafter(2.0, 0.0), 5}}, {"endless", {wrong, 5}}}}}};
}

}  // namespace gradus::stress
