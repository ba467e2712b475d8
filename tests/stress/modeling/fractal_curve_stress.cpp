// The promises of fractal curves: corners in the plane are off by a few roundings at every level, boxes are
// those of brute force, and texts walk the same way.

#include "modeling/fractal_curve/fractal_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "modeling/fractal_curve/box_count.hpp"
#include "modeling/fractal_curve/l_system.hpp"
#include "stress/core/integers.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace fractal_curve;

__extension__ typedef __int128 Wide;

constexpr int most_level = 7;

/// A number meant to be whole, in this range.
int whole_in(double x, int least, int most) {
  return std::isfinite(x) ? static_cast<int>(std::clamp(std::round(x), double(least), double(most))) : least;
}

// --- Corners in the plane

/// Two ends of a base, a level, and which corner, from 0 to 1.
Input base_and_corner(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 6);
  if (kind == Kind::near_degenerate)
    for (std::size_t axis = 0; axis < 2; ++axis) input[2 + axis] = nudged(input[axis], random);
  input[4] = static_cast<double>(random.uniform_int(0, most_level));
  input[5] = random.unit();
  return input;
}

const Corners& snowflake(int level) {
  static const auto all = [] {
    std::array<Corners, most_level + 1> ways;
    for (int k = 0; k <= most_level; ++k) ways[static_cast<Index>(k)] = koch(base_of(Shape::snowflake), k);
    return ways;
  }();
  return all[static_cast<Index>(level)];
}

/// In parts of 14 u M and two of the smallest numbers.
double placed_error(const Input& i) {
  constexpr double largest = 0x1p1020;
  double size = 0;
  for (std::size_t k = 0; k < 4; ++k) size = std::max(size, std::abs(i[k]));
  if (!all_finite(i) || size > largest) return 0;
  const int level = whole_in(i[4], 0, most_level);
  const Corners& way = snowflake(level);
  const auto which = std::clamp(i[5], 0.0, 1.0) * static_cast<double>(way.size() - 1);
  const Corner c = way[static_cast<Index>(which)];
  const Segment<2, double> base{{i[0], i[1]}, {i[2], i[3]}};
  const dvec2 found = in_plane(c, level, base);

  constexpr unsigned bits = 200;
  static const Integer root_of_3 = boost::multiprecision::sqrt(Integer(3) << (2 * bits));
  const Integer whole = 2 * power(3, level);
  const std::int64_t along = 2 * c.x + c.y;
  const Integer allowed = ((14 * fixed(size) * whole) << bits >> 53) + ((2 * whole) << bits);
  double most = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const Integer aside = axis == 0 ? fixed(base.a.y) - fixed(base.b.y) : fixed(base.b.x) - fixed(base.a.x);
    const Integer right =
        ((whole - along) * fixed(base.a[axis]) + along * fixed(base.b[axis])) * (Integer(1) << bits) +
        root_of_3 * c.y * aside;
    const Integer off = abs(Integer(fixed(found[axis]) * whole * (Integer(1) << bits) - right));
    most = std::max(most, Integer(off * 1000 / allowed).convert_to<double>() / 1000);
  }
  const bool at_end = along == 0 && c.y == 0;
  return at_end && found != base.a ? wrong : most;
}

// --- The lattice

/// A corner to end at, small or near the bound of its level, and the level.
Input corner_and_level(Kind kind, Random& random) {
  const auto level = random.uniform_int(0, most_level);
  const std::int64_t most = (std::int64_t{1} << 28) / power(3, static_cast<int>(level));
  const auto coordinate = [&] {
    if (kind == Kind::extremes) return (random.unit() < 0.5 ? -most : most) + random.uniform_int(-1, 1);
    return random.uniform_int(-9, 9);
  };
  return {static_cast<double>(coordinate()), static_cast<double>(coordinate()), static_cast<double>(level)};
}

/// The way of a turned segment is the turned way, and each level's corners stay on the next.
double turned_error(const Input& i) {
  const int level = whole_in(i[2], 0, most_level);
  constexpr int far = 1 << 29;
  const Corner end{whole_in(i[0], -far, far), whole_in(i[1], -far, far)};
  const std::int64_t most = (std::int64_t{1} << 28) / power(3, level);
  const auto taken = [&](Corner c) { return std::abs(c.x) <= most && std::abs(c.y) <= most; };
  const auto way = accepted([&] { return koch({{0, 0}, end}, level); });
  if (way.has_value() != taken(end)) return wrong;
  if (!way || !taken(turned(end))) return 0;
  const Corners other = koch({{0, 0}, turned(end)}, level);
  const Corners before = koch({{0, 0}, end}, std::max(level - 1, 0));
  for (Index k = 0; k < way->size(); ++k)
    if (turned((*way)[k]) != other[k]) return wrong;
  for (Index k = 0; level > 0 && k < before.size(); ++k)
    if ((*way)[4 * k] != 3 * before[k]) return wrong;
  return 0;
}

// --- Boxes

/// Two ends and a side, so that some dozens of boxes lie between the ends: also on walls and in corners.
Input segment_and_side(Kind kind, Random& random) {
  constexpr std::int64_t most = std::int64_t{1} << 30;
  const bool small = kind == Kind::ties || kind == Kind::tiny;
  const std::int64_t side = small ? random.uniform_int(1, 4) : random.uniform_int(1, most / 8);
  const auto coordinate = [&]() -> double {
    const std::int64_t wall = random.uniform_int(-7, 7) * side;
    if (kind == Kind::ties || (kind == Kind::grazing && random.unit() < 0.5))
      return static_cast<double>(wall);
    if (kind == Kind::grazing || kind == Kind::near_degenerate)
      return static_cast<double>(wall + random.uniform_int(-1, 1));
    return static_cast<double>(random.uniform_int(-7 * side, 7 * side));
  };
  Input input(4);
  for (double& x : input) x = coordinate();
  input.push_back(static_cast<double>(side));
  return input;
}

/// Whether a segment meets a half-open box: what each axis leaves of it, as fractions of 128 bits.
bool meets(const Line& l, Box box, Whole side) {
  struct End {
    Wide above, below;
    bool open;
  };
  End first{0, 1, false}, last{1, 1, false};
  const auto before = [](const End& a, const End& b) { return a.above * b.below < b.above * a.below; };
  const auto same = [](const End& a, const End& b) { return a.above * b.below == b.above * a.below; };
  for (int axis = 0; axis < 2; ++axis) {
    const Wide a = l.a[axis], way = l.b[axis] - a, low = Wide{box[axis]} * side, high = low + side;
    if (way == 0) {
      if (a < low || high <= a) return false;
      continue;
    }
    const Wide size = way > 0 ? way : -way;
    const End in{way > 0 ? low - a : a - high, size, way < 0},
        out{way > 0 ? high - a : a - low, size, way > 0};
    if (before(first, in) || (same(first, in) && in.open)) first = in;
    if (before(out, last) || (same(out, last) && out.open)) last = out;
  }
  return before(first, last) || (same(first, last) && !first.open && !last.open);
}

double boxes_error(const Input& i) {
  constexpr double most = 0x1p30;
  if (!all_finite(i) || std::ranges::any_of(i, [](double x) { return x != std::round(x); })) return 0;
  if (std::ranges::any_of(i, [](double x) { return std::abs(x) > most; }) || i[4] < 1) return 0;
  const auto at = [&](std::size_t k) { return static_cast<Whole>(i[k]); };
  const Line line{{at(0), at(1)}, {at(2), at(3)}};
  const Whole side = at(4);
  Box lower{floor_div(std::min(line.a.x, line.b.x), side), floor_div(std::min(line.a.y, line.b.y), side)};
  Box upper{floor_div(std::max(line.a.x, line.b.x), side), floor_div(std::max(line.a.y, line.b.y), side)};
  constexpr Whole few = 64;
  if (upper.x - lower.x > few || upper.y - lower.y > few) return 0;
  Boxes right, found;
  for (Whole c = lower.x - 1; c <= upper.x + 1; ++c)
    for (Whole r = lower.y - 1; r <= upper.y + 1; ++r)
      if (meets(line, {c, r}, side)) right.push_back({c, r});
  cover(line, side, found);
  sort_unique(found);
  return found == right ? 0 : wrong;
}

// --- Texts

/// Which system of whole numbers, and how many generations.
Input system_and_rounds(Kind, Random& random) {
  return {static_cast<double>(random.uniform_int(0, 1)), static_cast<double>(random.uniform_int(0, 6))};
}

/// Of a walk in doubles against that on the lattice, in parts of n (e + u M).
double walked_error(const Input& i) {
  const System& system = whole_in(i[0], 0, 1) == 0 ? koch_system : arrowhead_system;
  const std::string text = rewrite(std::string(system.axiom), system.rules, whole_in(i[1], 0, 6));
  std::vector<Corner> exact;
  turtle<Corner>(text, lattice_way, [&](Corner, Corner to) { exact.push_back(to); });
  const ExactScope scope;
  // Of 101 bits, in two parts
  static const Integer root = boost::multiprecision::sqrt(Integer(3) << 200);
  const Integer upper = root >> 50, lower = root - (upper << 50);
  const Exact root_of_3 = Exact(upper.convert_to<std::int64_t>()) * Exact(0x1p-50) +
                          Exact(lower.convert_to<std::int64_t>()) * Exact(0x1p-100);
  double most = 0, largest = 1;
  Index n = 0;
  turtle<dvec2>(
      text, [](std::int64_t turns) { return plane_way(turns, 60); },
      [&](dvec2, dvec2 to) {
        const Corner c = exact[n++];
        largest = std::max({largest, std::abs(to.x), std::abs(to.y)});
        const Exact off_x = abs(Exact(to.x) - Exact(2 * c.x + c.y) * Exact(0.5));
        const Exact off_y = abs(Exact(to.y) - Exact(c.y) * root_of_3 * Exact(0.5));
        const Exact bound = Exact(static_cast<std::int64_t>(n)) * Exact(0x1p-53) * Exact(1 + largest);
        most = std::max({most, in_bounds(off_x, bound), in_bounds(off_y, bound)});
      });
  return n == exact.size() ? most : wrong;
}

}  // namespace

Domain fractal_curve() {
  return {
      "fractal_curve",
      {{.name = "placed",
        .states = "a corner in the plane within 14 u M at every level, M the base's largest coordinate",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 6,
        .generate = at_every_scale(base_and_corner, {0, 1, 2, 3}),
        .error = placed_error,
        .traps = {{"both ends one", {1, 1, 1, 1, 5, 0.3}},
                  {"the largest numbers", {0x1p1020, -0x1p1020, -0x1p1020, 0x1p1020, 7, 0.4}},
                  {"the smallest numbers", {5e-324, 0, 0, 5e-324, 7, 0.4}}}},
       {.name = "turned",
        .states = "a turned segment has the turned way, and each level keeps the corners of the one before",
        .unit = "wrong corners",
        .bound = 0,
        .numbers = 3,
        .kinds = {Kind::random, Kind::ties, Kind::extremes},
        .generate = corner_and_level,
        .error = turned_error,
        .traps = {{"a point", {0, 0, 6}}, {"beyond the lattice", {1e9, 0, 7}}},
        .cases = 300},
       {.name = "boxes",
        .states = "the boxes of a segment are those of brute force, also along walls and through corners",
        .unit = "wrong boxes",
        .bound = 0,
        .numbers = 5,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties, Kind::tiny},
        .generate = segment_and_side,
        .error = boxes_error,
        .traps = {{"along a wall", {0, 4, 12, 4, 4}},
                  {"through corners", {-8, 8, 8, -8, 4}},
                  {"a point in a corner", {4, 4, 4, 4, 4}},
                  {"the largest numbers", {-0x1p30, -0x1p30, 0x1p30, 0x1p30 - 1, 0x1p28}}},
        .cases = 2000},
       {.name = "walked",
        .states = "a turtle's place within n (e + u M) of the lattice's after n steps",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 2,
        .kinds = {Kind::random},
        .generate = system_and_rounds,
        .error = walked_error,
        .traps = {{"the largest text", {0, 6}}},
        .cases = 20}}};
}

}  // namespace gradus::stress
