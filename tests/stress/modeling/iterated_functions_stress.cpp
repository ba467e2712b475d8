// The promises of iterated functions: what contracts is decided exactly, pieces and points are off by a few
// roundings, points lie as near to the attractor as is said, and a dimension makes the sum 1.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "modeling/iterated_functions/similarity_dimension.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace iterated_functions;

constexpr double u = 0x1p-53, largest_size = 0x1p1000;

/// A number meant to be whole, in this range.
int whole_in(double x, int least, int most) {
  return std::isfinite(x) ? static_cast<int>(std::clamp(std::round(x), double(least), double(most))) : least;
}

DMap map_in(const Input& i, std::size_t from) {
  return {i[from], i[from + 1], i[from + 2], i[from + 3], i[from + 4], i[from + 5]};
}

// --- Contractions

/// A matrix: of any kind, or a turn with a scale near 1, mirrored or not.
Input matrix(Kind kind, Random& random) {
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    const double angle = random.uniform(0, 7), s = std::sin(angle), c = std::cos(angle);
    const double mirror = random.unit() < 0.5 ? -1 : 1;
    const double thinner = kind == Kind::grazing ? random.unit() : 1;
    return {nudged(c, random), -mirror * thinner * nudged(s, random), nudged(s, random),
            mirror * thinner * nudged(c, random)};
  }
  Input input = numbers_of(kind, random, 4);
  if (kind == Kind::random)
    for (double& x : input) x /= 16;
  if (kind == Kind::ties)
    for (double& x : input) x = static_cast<double>(random.uniform_int(-2, 2)) / 2;
  return input;
}

/// The sum and the product of the squares of the singular values.
struct Squares {
  Exact sum, product;
  explicit Squares(const DMap& m) {
    const Exact a(m.a), b(m.b), c(m.c), d(m.d), det = a * d - b * c;
    sum = a * a + b * b + c * c + d * d;
    product = det * det;
  }
  /// Whether the larger one is below x^2, or equal.
  bool below(const Exact& x) const {
    const Exact square = x * x;
    return sign(square * Exact(2) - sum) >= 0 && sign(square * square - sum * square + product) >= 0;
  }
  bool contracts() const { return sign(Exact(2) - sum) > 0 && sign(Exact(1) - sum + product) > 0; }
};

double contracts_error(const Input& i) {
  if (!all_finite(i)) return 0;
  const ExactScope scope;
  const DMap m{i[0], i[1], i[2], i[3], 0, 0};
  return contracts(m) == Squares(m).contracts() ? 0 : wrong;
}

/// In u: how much wider the largest singular value must be taken for the exact one to lie there.
double stretch_error(const Input& i) {
  if (!all_finite(i) || std::ranges::any_of(i, [](double x) { return std::abs(x) > largest_size; })) return 0;
  const ExactScope scope;
  const DMap m{i[0], i[1], i[2], i[3], 0, 0};
  const Exact found(stretch(m)), unit = found * Exact(u), least(0x1p-1073);
  const Squares squares(m);
  constexpr int many = 64;
  for (int k = 0; k < many; ++k) {
    const Exact off = unit * Exact(k) + least, low = found - off;
    if (squares.below(found + off) && (sign(low) <= 0 || !squares.below(low))) return k;
  }
  return wrong;
}

// --- Pieces

/// Two maps, a point, two whole numbers from 0 to 1000.
Input maps_and_point(Kind kind, Random& random) {
  Input input;
  for (int map = 0; map < 2; ++map) {
    const double size = kind == Kind::ties ? 0.5 : random.uniform(0.3, 0.7);
    for (int k = 0; k < 4; ++k)
      input.push_back(kind == Kind::ties
                          ? size * static_cast<double>(random.uniform_int(-1, 1)) * (k % 3 == 0)
                          : random.uniform(-size, size));
    for (int k = 0; k < 2; ++k) input.push_back(number(kind, random));
  }
  for (int k = 0; k < 2; ++k) input.push_back(number(kind, random));
  for (int k = 0; k < 2; ++k) input.push_back(static_cast<double>(random.uniform_int(0, 1000)));
  return input;
}

struct ExactPoint {
  Exact x, y;
};
ExactPoint moved(const DMap& m, const ExactPoint& p) {
  return {Exact(m.a) * p.x + Exact(m.b) * p.y + Exact(m.e), Exact(m.c) * p.x + Exact(m.d) * p.y + Exact(m.f)};
}
/// The distance as far as doubles tell it.
double distance(const ExactPoint& a, const ExactPoint& b) {
  return length_of(dvec2{to_double(a.x - b.x), to_double(a.y - b.y)});
}
double size_of(const DMap& m) { return length_of(dvec2{m.e, m.f}); }

/// Whether maps are taken, and lie in the promises' sizes.
bool taken(const std::array<DMap, 2>& maps, const Input& i) {
  const ExactScope scope;
  if (!all_finite(i)) return false;
  if (std::ranges::any_of(i, [](double x) { return std::abs(x) > largest_size; })) return false;
  return std::ranges::all_of(maps, [](const DMap& m) { return Squares(m).contracts(); });
}

/// In parts of 6 n u (|p| + M).
double placed_error(const Input& i) {
  const std::array maps{map_in(i, 0), map_in(i, 6)};
  if (!taken(maps, i)) return 0;
  const int level = whole_in(i[14], 0, 1000) % 9;
  const auto which = static_cast<Index>(whole_in(i[15], 0, 1000)) % (Index{1} << level);
  const DMap piece = deterministic<double>(maps, level)[which];
  const ExactScope scope;
  const dvec2 p{i[12], i[13]};
  // The highest digit is the map applied first
  ExactPoint right{Exact(p.x), Exact(p.y)}, origin{Exact(0), Exact(0)};
  double largest = std::max(size_of(maps[0]), size_of(maps[1]));
  for (int k = level - 1; k >= 0; --k) {
    const DMap& f = maps[which >> k & 1];
    right = moved(f, right);
    origin = moved(f, origin);
    largest = std::max(largest, distance(origin, {Exact(0), Exact(0)}));
  }
  const double off = distance(moved(piece, {Exact(p.x), Exact(p.y)}), right);
  const double bound = 6.0 * level * (u * (length_of(p) + largest) + 0x1p-1074);
  return off == 0 ? 0 : off / bound;
}

// --- Points

/// In parts of c^k R + 6 u M / (1 - c), against the same moves of a point of the attractor.
double game_error(const Input& i) {
  const std::array maps{map_in(i, 0), map_in(i, 6)};
  if (!taken(maps, i)) return 0;
  const Maps<double> all = maps;
  const double c = contraction(all);
  if (!(c < 1)) return 0;
  const Whole moves = 1 + whole_in(i[14], 0, 1000) % 40;
  const std::array begin{dvec2{i[12], i[13]}};
  const double far = reach<double>(all, begin, c);
  const Game<double> game{begin[0], 0, moves, static_cast<std::uint64_t>(whole_in(i[15], 0, 1000))};
  const std::array<double, 2> shares{1, 1};

  const ExactScope scope;
  // The first map's fixed point belongs to the attractor, and so does whatever the maps make of it
  const DMap& f = maps[0];
  const Exact one(1), a(f.a), b(f.b), cc(f.c), d(f.d), e(f.e), ff(f.f);
  const Exact det = (one - a) * (one - d) - b * cc;
  ExactPoint right{((one - d) * e + b * ff) / det, ((one - a) * ff + cc * e) / det};
  double most = 0, shrunk = far,
         largest = std::max({size_of(maps[0]), size_of(maps[1]), length_of(begin[0])});
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Moved<double>>) {
      right = moved(maps[step.map], right);
      shrunk *= c;
      largest = std::max(largest, length_of(step.to));
      const double off = distance({Exact(step.to.x), Exact(step.to.y)}, right);
      const double bound = (shrunk + 6 * u * largest / (1 - c)) * (1 + 0x1p-40) + 64 * 0x1p-1074 / (1 - c);
      if (off > 0 && bound < std::numeric_limits<double>::infinity()) most = std::max(most, off / bound);
    }
  };
  chaos_game(all, shares, game, [](dvec2) {}, watch);
  return most;
}

// --- Dimension

Input ratios_of(Kind kind, Random& random) {
  Input input(3);
  for (double& r : input) {
    r = random.unit();
    if (kind == Kind::near_degenerate)
      r = 1 - std::ldexp(random.unit(), -static_cast<int>(random.uniform_int(1, 50)));
    if (kind == Kind::tiny || kind == Kind::denormal || kind == Kind::extremes || kind == Kind::refused)
      r = std::abs(number(kind, random));
    if (kind == Kind::ties) r = std::ldexp(1.0, -static_cast<int>(random.uniform_int(1, 3)));
  }
  return input;
}

/// In parts of 2^-60 of the first interval and what 8 u of the sum are worth, against long doubles.
double dimension_error(const Input& i) {
  constexpr int halvings = 60;
  const auto s = accepted([&] { return similarity_dimension(i, halvings); });
  const bool valid = std::ranges::all_of(i, [](double r) { return 0 <= r && r < 1; });
  if (s.has_value() != valid) return wrong;
  if (!s) return 0;
  using Long = long double;
  const auto sum_at = [&](Long x) {
    Long sum = 0;
    for (const double r : i) sum += r > 0 ? std::exp(x * std::log(Long{r})) : x > 0 ? 0 : 1;
    return sum;
  };
  Long low = 0, high = 1;
  while (sum_at(high) > 1) high *= 2;
  const Long first = high;
  for (int k = 0; k < 110; ++k) {
    const Long middle = (low + high) / 2;
    (sum_at(middle) > 1 ? low : high) = middle;
  }
  Long slope = 0;
  for (const double r : i)
    if (r > 0) slope -= std::exp(high * std::log(Long{r})) * std::log(Long{r});
  const Long off = std::abs(*s - high);
  // Where powers fall steeply, a rounding of s itself is worth more
  const Long allowed = first * 0x1p-53L + 8 * u / std::max(slope, 1e-300L);
  return static_cast<double>(off / allowed);
}

}  // namespace

Domain iterated_functions() {
  return {"iterated_functions",
          {{.name = "contracts",
            .states = "what makes all lengths smaller is decided exactly",
            .unit = "wrong decisions",
            .bound = 0,
            .numbers = 4,
            .generate = at_every_scale(matrix),
            .error = contracts_error,
            .traps = {{"a turn", {0.6, -0.8, 0.8, 0.6}},
                      {"as it is", {1, 0, 0, 1}},
                      {"both values above 1", {2, 0, 0, 2}},
                      {"a shear", {0.5, 1, 0, 0.5}},
                      {"one huge, one tiny", {0x1p1000, 0, 0, 5e-324}},
                      {"the largest numbers", {0x1.fffffffffffffp1023, 1, -1, 0x1.fffffffffffffp1023}}},
            .cases = 3000},
           {.name = "stretch",
            .states = "a map's largest singular value within 8 u",
            .unit = "u",
            .bound = 8,
            .numbers = 4,
            .generate = at_every_scale(matrix),
            .error = stretch_error,
            .traps = {{"nothing", {0, 0, 0, 0}}, {"the smallest numbers", {5e-324, 0, 0, 5e-324}}},
            .cases = 1000},
           {.name = "placed",
            .states = "a piece of level n within 6 n u (|p| + M) of its place",
            .unit = "of the bound",
            .bound = 1,
            .numbers = 16,
            .generate = at_every_scale(maps_and_point, {4, 5, 10, 11, 12, 13}),
            .error = placed_error,
            .cases = 300},
           {.name = "near",
            .states = "after k moves a point within c^k R + 6 u M / (1 - c) of the attractor",
            .unit = "of the bound",
            .bound = 1,
            .numbers = 16,
            .generate = at_every_scale(maps_and_point, {4, 5, 10, 11, 12, 13}),
            .error = game_error,
            .cases = 100},
           {.name = "dimension",
            .states = "the sum of all powers is 1 at the dimension, within what 8 u of it are worth",
            .unit = "of the bound",
            .bound = 1,
            .numbers = 3,
            .generate = ratios_of,
            .error = dimension_error,
            .traps = {{"points", {0, 0, 0}}, {"one copy", {0, 0, 0.5}}, {"as large", {1, 0.5, 0.5}}},
            .cases = 500}}};
}

}  // namespace gradus::stress
