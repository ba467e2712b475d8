// The promises of clipping a segment to a circle.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <optional>

#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "stress/clipping/lanes.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::liang_barsky_circle;

// --- Inputs: from, to, centre, radius ---

/// Moderate numbers.
Input shape(Kind kind, Random& random) {
  Input input(7);
  for (double& x : input) x = kind == Kind::ties ? number(kind, random) : number(Kind::random, random);
  input[6] = std::abs(input[6]);
  if (kind == Kind::near_degenerate) {
    // Nearly a point, perhaps on the rim
    input[2] = nudged(input[0], random);
    input[3] = nudged(input[1], random);
    if (random.unit() < 0.5) input[6] = nudged(std::hypot(input[0] - input[4], input[1] - input[5]), random);
  } else if (kind == Kind::grazing) {
    // A line at the distance of the radius, or a few units beside it
    const double t = random.uniform(0, 6.283), c = std::cos(t), s = std::sin(t);
    const double before = random.uniform(0, 20), after = random.uniform(0, 20);
    const double x = input[4] + input[6] * c, y = input[5] + input[6] * s;
    input[0] = nudged(x + before * s, random);
    input[1] = y - before * c;
    input[2] = x - after * s;
    input[3] = nudged(y + after * c, random);
  }
  return input;
}

Input generate(Kind kind, Random& random) {
  switch (kind) {
    case Kind::huge:
    case Kind::tiny:
    case Kind::denormal: {
      if (random.unit() < 0.5) break;
      constexpr Kind shapes[] = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
      Input input = shape(shapes[random.uniform_int(0, 3)], random);
      scale(input, scale_of(kind, random));
      return input;
    }
    case Kind::extremes:
      if (random.unit() < 0.25) break;
      // As often of sizes that lanes of a batch take
      return of_mixed_sizes(random, random.unit() < 0.5 ? Sizes{} : Sizes{-700, 148});
    case Kind::refused: {
      Input input = shape(Kind::random, random);
      const auto at = static_cast<std::size_t>(random.uniform_int(0, 6));
      input[at] = at == 6 && random.unit() < 0.5 ? -1 : random.unit() < 0.5 ? std::nan("") : wrong;
      return input;
    }
    default:
      return shape(kind, random);
  }
  Input input(7);
  for (double& x : input) x = number(kind, random);
  input[6] = std::abs(input[6]);
  return input;
}

/// What of an input are segment and circle, in numbers of type T.
template <class T>
struct Case {
  Segment<2, T> segment;
  Circle<T> circle;
};
template <class T = double>
Case<T> case_of(const Input& i) {
  const auto n = [&](std::size_t k) { return static_cast<T>(i[k]); };
  return {{{n(0), n(1)}, {n(2), n(3)}}, {{n(4), n(5)}, n(6)}};
}
bool is_taken(const Input& i) { return all_finite(i) && i[6] >= 0; }

template <class T>
Segment<2, T> reversed(const Segment<2, T>& s) {
  return {s.b, s.a};
}

// --- Promises ---

template <class T>
double error(const Input& i) {
  const auto [segment, circle] = case_of<T>(i);
  std::optional<Segment<2, T>> found;
  try {
    found = exact_decision(segment, circle);
  } catch (const ContractViolation&) {
    return is_taken(i) ? wrong : 0;
  }
  if (!is_taken(i)) return wrong;
  const auto right = ends_in_circle<T>(i);
  if (found.has_value() != right.has_value()) return wrong;
  if (!found) return 0;
  // Ends in the disc are copied, cut ones lie in the segment's box
  if (right->from_is_given && found->a != segment.a) return wrong;
  if (right->to_is_given && found->b != segment.b) return wrong;
  for (const glm::vec<2, T>& p : {found->a, found->b}) {
    if (glm::clamp(p, glm::min(segment.a, segment.b), glm::max(segment.a, segment.b)) != p) return wrong;
  }
  return std::max(right->from.error(found->a), right->to.error(found->b));
}

/// 0 where the segment turned round gives the reverse, bit for bit.
template <class T>
double reversed_error(const Input& i) {
  if (!is_taken(i)) return 0;
  const auto [segment, circle] = case_of<T>(i);
  const auto there = exact_decision(segment, circle), back = exact_decision(reversed(segment), circle);
  return test::same_bits(there, back ? std::optional(reversed(*back)) : std::nullopt) ? 0 : wrong;
}

/// 0 where the signs that decide are exact.
double signs_error(const Input& i) {
  if (!is_taken(i)) return 0;
  const auto [segment, circle] = case_of(i);
  const WholeQuadratic right(i);
  const bool same = side(segment.a, circle) == right.C.sign() &&
                    side(segment.b, circle) == right.end.sign() &&
                    past_foot(segment.a, segment, circle.centre) == right.B.sign() &&
                    (right.A == 0 || reach(segment, circle) == right.D.sign());
  return same ? 0 : wrong;
}

/// 0 where the quadratic in rationals has the same signs.
double rationals_error(const Input& i) {
  if (!is_taken(i)) return 0;
  const ExactScope scope;
  const auto [segment, circle] = case_of(i);
  const auto exact = [](dvec2 p) { return ExactVec2(Exact(p.x), Exact(p.y)); };
  const auto q = quadratic(Segment<2, Exact>{exact(segment.a), exact(segment.b)},
                           Circle<Exact>{exact(circle.centre), Exact(circle.radius)});
  const bool same = sign(q.D) == (q.A == Exact{} ? 0 : reach(segment, circle)) &&
                    sign(q.C) == side(segment.a, circle) &&
                    sign(q.B) == past_foot(segment.a, segment, circle.centre) && q.B * q.B - q.A * q.C == q.D;
  return same ? 0 : wrong;
}

/// The sign of the discriminant in plain arithmetic.
int plain_sign(const Input& i) {
  const auto [s, c] = case_of(i);
  const dvec2 d = s.b - s.a;
  const double B = 2 * (s.a.x * d.x + s.a.y * d.y), A = d.x * d.x + d.y * d.y;
  const double D = B * B - 4 * A * (s.a.x * s.a.x + s.a.y * s.a.y - c.radius * c.radius);
  return (D > 0) - (D < 0);
}
/// A tangent by construction, at (x, y) of a circle round the origin: rounding says anything of it.
Input tangent(Kind, Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
  const double a = random.uniform(1, 3), b = random.uniform(1, 3);
  return {x - a * y, y + a * x, x + b * y, y - b * x, 0, 0, std::sqrt(x * x + y * y)};
}

// --- Many at once ---

/// The segment, others that share an end with it, points, and the segment in a register of its own.
lanes::Lines<2> lanes_of(const Case<double>& of) {
  const auto [a, b] = of.segment;
  const dvec2 c = of.circle.centre, up{a.x, std::nextafter(a.y, HUGE_VAL)}, middle = 0.5 * a + 0.5 * b;
  lanes::Lines<2> lines{{a, b}, {b, a}, {a, a}, {b, b}, {up, b}, {a, c}, {c, b}, {a, middle}, {{0, 0}, b}};
  lines.insert(lines.end(), 8, of.segment);
  std::erase_if(lines, [](const auto& s) { return !is_finite(s.a) || !is_finite(s.b); });
  return lines;
}

double batch_error(const Input& i) {
  const auto given = case_of(i);
  const auto batch = [&](const auto& lines, auto& clipped, auto& accepted) {
    return clip_batch(lines, given.circle, clipped, accepted).accepted;
  };
  if (!is_taken(i)) return lanes::refusal_error<2>(given.segment, batch);
  return lanes::error<2>(lanes_of(given), batch,
                         [&](const auto& s) { return exact_decision(s, given.circle); });
}

/// How many of so many lines went one by one.
std::size_t one_by_one(const Case<double>& of, const lanes::Lines<2>& lines) {
  lanes::Lines<2> clipped(lines.size());
  std::vector<std::uint8_t> accepted(lines.size());
  return clip_batch(lines, of.circle, clipped, accepted).one_by_one;
}

/// Segments about a circle, as a program would have them; about one far away; and with ends far away.
Input ordinary(Kind kind, Random& random) {
  const Circle<double> circle =
      kind == Kind::huge ? Circle<double>{{1e6, -3e7}, 0.01} : Circle<double>{{0.3, -0.2}, 5};
  const double far =
      kind == Kind::extremes ? std::ldexp(1.0, static_cast<int>(random.uniform_int(5, 60))) : 3;
  const auto point = [&] {
    const double x = random.uniform(-1, 1);
    return circle.centre + far * circle.radius * dvec2(x, random.uniform(-1, 1));
  };
  const dvec2 a = point(), b = point();
  return {a.x, a.y, b.x, b.y, circle.centre.x, circle.centre.y, circle.radius};
}
/// How many of a register's lanes have no certificate.
double uncertified(const Input& i) {
  if (!is_taken(i)) return 0;
  const auto given = case_of(i);
  return static_cast<double>(one_by_one(given, lanes::Lines<2>(8, given.segment)));
}
bool has_far_ends(const Input& i) {
  return std::abs(i[0]) + std::abs(i[1]) > 0x1p4 * (std::abs(i[4]) + std::abs(i[5]) + i[6]);
}

std::vector<std::pair<std::string, std::string>> arguments(const Input& i) {
  return {{"method", "exact_decision"},
          {"line", fmt::format("{},{},{},{}", i[0], i[1], i[2], i[3])},
          {"circle", fmt::format("{},{},{}", i[4], i[5], i[6])}};
}

std::vector<Trap> traps() {
  const double one_up = 1 + 0x1p-52, one_down = 1 - 0x1p-53;
  constexpr double largest = std::numeric_limits<double>::max();
  return {
      {"starts on the rim", {1, 0, 2, 0, 0, 0, 1}},
      {"ends on the rim", {2, 0, 1, 0, 0, 0, 1}},
      {"zero length inside", {0.5, 0, 0.5, 0, 0, 0, 1}},
      {"zero length outside", {2, 0, 2, 0, 0, 0, 1}},
      {"misses by an ulp", {-2, one_up, 2, one_up, 0, 0, 1}},
      {"half a chord of 1.49e-8", {-2, one_down, 2, one_down, 0, 0, 1}},
      {"tangent from inside", {-5, 0, 5, 0, 0, 3, 3}},
      {"the discriminant cancels", {-1e8, 0.5, 1e8, 0.5, 0, 0, 1}},
      {"is accepted although it misses", {-1e8, 1.0000001, 1e8, 1.0000001, 0, 0, 1}},
      {"a chord in a long line", {-1e6, 0.999, 1e6, 0.999, 0, 0, 1}},
      {"a point", {-1, 0, 1, 0, 0, 0, 0}},
      {"a radius that is no number", {-1, 0, 1, 0, 0, 0, std::nan("")}},
      {"a negative radius", {-1, 0, 1, 0, 0, 0, -1}},
      {"the line, not the segment, meets the circle", {0, 0, 0.5, 0, 0, 0, 1}},
      {"r squared underflows, the length is large", {-0x1p200, 0x1p-600, 0x1p200, 0x1p-600, 0, 0, 0x1p-540}},
      {"the length squared underflows, r is large", {-0x1p-540, 0x1p500, 0x1p-540, 0x1p500, 0, 0, 0x1p500}},
      {"the same in the lanes of a batch", {-0x1p-540, 0x1p150, 0x1p-540, 0x1p150, 0, 0, 0x1p150}},
      {"a sum of the largest circle overflows", {0, 0, largest, 0, -0x3p970, 0, largest}},
      {"half of the largest circle has no doubles", {-largest, 0, largest, 0, largest, 0, largest / 2}},
      {"a tangent at the largest number", {largest, -largest, largest, largest, largest / 2, 0, largest / 2}},
      {"the largest circle and the smallest", {-largest, 0, largest, 0, 0, 0, 0x1p-1074}},
      {"a tangent of the smallest circle", {-0x8p-1074, 0x1p-1074, 0x8p-1074, 0x1p-1074, 0, 0, 0x1p-1074}},
      {"the smallest circle, met at (0.6, -0.8)", {0x1p-1074, -0x1p-1074, -0x1p-1074, 0, 0, 0, 0x1p-1074}},
      {"the smallest circle, met at (9.95, -5.35)", {-0x4p-1074, 0, 30, -11.5, 0x4p-1074, 0, 0x8p-1074}},
      {"the smallest circle of 3-4-5", {0xap-1074, -0x5p-1074, -0xbp-1074, 0x2p-1074, 0, 0, 0x5p-1074}},
      {"a small circle far away, met obliquely", {1, 0x3bp-1074, 0, -1, 1, 0, 0x3ap-1074}},
      {"a small circle far away, met on the other side", {1, -0x1bp-1074, 3, -1, 1, 0, 0x40p-1074}},
      {"halves added to whole numbers beyond 2^53",
       {0x1.0fc67f45a8d9ep-1020, 0x1.b23ad7dbd093p-1023, 0x1.bdb77a3e455c0p-1024, 0x1.4d0f4dbedc5d0p-1020, 0,
        0, 0x1.f98896254d7f2p-1021}}};
}

/// A situation of inputs that the contract takes.
template <class Holds>
Share share(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) { return is_taken(i) && holds(case_of(i)); }};
}
bool is_cut(const Case<double>& of) {
  const auto kept = exact_decision(of.segment, of.circle);
  return kept && *kept != of.segment;
}
bool underflows(const Case<double>& of) {
  return of.circle.radius * of.circle.radius == 0 ||
         (of.segment.a != of.segment.b && quadratic(of.segment, of.circle).A == 0);
}

Property promise(const char* name, const char* states, double (*error)(const Input&)) {
  return {.name = name,
          .states = states,
          .unit = "wrong",
          .bound = 0,
          .numbers = 7,
          .generate = generate,
          .error = error,
          .arguments = arguments,
          .traps = traps()};
}

Property decisions() {
  Property it =
      promise("exact_decision", "accepts and rejects exactly; ends within 0.63 ulp of max(|coordinate|, r)",
              error<double>);
  it.unit = "ulp";
  it.bound = 0.63;
  it.cases = 26'000;
  it.shares = {share("inside", 0.05,
                     [](const auto& of) { return exact_decision(of.segment, of.circle) == of.segment; }),
               share("cut", 0.1, is_cut),
               share("missed", 0.1, [](const auto& of) { return !exact_decision(of.segment, of.circle); }),
               share("a point", 0.01,
                     [](const auto& of) {
                       const auto kept = exact_decision(of.segment, of.circle);
                       return kept && kept->a == kept->b;
                     }),
               share("cut in doubt", 0.02,
                     [](const auto& of) { return is_cut(of) && !line_by_pairs(of.segment, of.circle); }),
               share("squares underflow", 0.1, underflows)};
  return it;
}
Property floats() {
  Property it = promise("in_float", "the same in float", [](const Input& i) {
    return std::max(error<float>(rounded_to_floats(i)), reversed_error<float>(rounded_to_floats(i)));
  });
  it.unit = "ulp";
  it.bound = 0.63;
  it.cases = 20'000;
  // The ordinary shapes, and those at every scale of floats
  it.generate = [](Kind kind, Random& random) {
    constexpr Kind shapes[] = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
    Input input = kind == Kind::extremes ? of_mixed_sizes(random, {-149, 120})
                                         : shape(std::ranges::find(shapes, kind) != std::end(shapes)
                                                     ? kind
                                                     : shapes[random.uniform_int(0, 3)],
                                                 random);
    if (kind == Kind::huge) scale(input, static_cast<int>(random.uniform_int(20, 120)));
    if (kind == Kind::tiny || kind == Kind::denormal)
      scale(input, -static_cast<int>(random.uniform_int(20, 149)));
    return rounded_to_floats(input);
  };
  it.kinds.pop_back();
  return it;
}
Property tangents() {
  Property it = promise(
      "tangency", "the sign of the discriminant is exact where plain arithmetic says anything", signs_error);
  it.kinds = {Kind::grazing};
  it.generate = tangent;
  it.traps.clear();
  it.cases = 30'000;
  for (const int says : {-1, 0, 1}) {
    it.shares.push_back(share("said to be of each sign", 0.1, [](const auto&) { return true; }));
    it.shares.back().holds = [says](const Input& i) { return plain_sign(i) == says; };
  }
  it.shares.push_back(
      {"said wrongly", 0.25, [](const Input& i) { return plain_sign(i) != WholeQuadratic(i).D.sign(); }});
  return it;
}
Property rationals() {
  Property it = promise("in_rationals", "the quadratic in rationals decides the same", rationals_error);
  // Rationals of this size take long
  it.cases = 3'000;
  return it;
}
Property batches() {
  Property it = promise("clip_batch", "every lane has the bits of exact_decision, on every kind of machine",
                        batch_error);
  it.shares = {share("a lane is certified", 0.25,
                     [](const auto& of) {
                       const auto lines = lanes_of(of);
                       return one_by_one(of, lines) < lines.size();
                     }),
               share("cut", 0.125, is_cut)};
  return it;
}
Property certificates() {
  Property it = promise(
      "certified", "nearly every segment of a batch has a certificate, but for ends far away", uncertified);
  it.unit = "lanes";
  it.bound = 8;
  it.kinds = {Kind::random, Kind::huge, Kind::extremes};
  it.generate = ordinary;
  it.traps.clear();
  it.shares = {{"certified, or has ends far away", 0.999,
                [](const Input& i) { return uncertified(i) == 0 || has_far_ends(i); }},
               {"certified with ends far away", 0.13,
                [](const Input& i) { return uncertified(i) == 0 && has_far_ends(i); }}};
  return it;
}

}  // namespace

Domain liang_barsky_circle() {
  return {
      "liang_barsky_circle",
      {decisions(), floats(),
       promise("reversed", "the segment turned round gives the reverse, bit for bit", reversed_error<double>),
       promise("signs", "the signs that decide are exact", signs_error), tangents(), rationals(), batches(),
       certificates()}};
}

}  // namespace gradus::stress
