// The promises of clipping a segment to a circle.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>

#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "core/contract.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using liang_barsky_circle::exact_decision;

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

Segment<2, double> segment_of(const Input& i) { return {{i[0], i[1]}, {i[2], i[3]}}; }
Circle<double> circle_of(const Input& i) { return {{i[4], i[5]}, i[6]}; }

// --- Promises ---

double error(const Input& i) {
  const bool taken = all_finite(i) && i[6] >= 0;
  std::optional<Segment<2, double>> found;
  try {
    found = exact_decision(segment_of(i), circle_of(i));
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken) return wrong;
  const std::optional<EndsInCircle> right = ends_in_circle(i);
  if (found.has_value() != right.has_value()) return wrong;
  if (!found) return 0;
  return std::max(right->from.error(found->a), right->to.error(found->b));
}

bool same_bits(const Segment<2, double>& a, const Segment<2, double>& b) {
  const auto bits = [](dvec2 p) {
    return std::pair(std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y));
  };
  return bits(a.a) == bits(b.a) && bits(a.b) == bits(b.b);
}

/// 0 where the segment turned round gives the reverse, bit for bit.
double reversed_error(const Input& i) {
  if (!all_finite(i) || i[6] < 0) return 0;
  const Segment<2, double> segment = segment_of(i);
  const auto there = exact_decision(segment, circle_of(i));
  const auto back = exact_decision(Segment<2, double>{segment.b, segment.a}, circle_of(i));
  if (there.has_value() != back.has_value()) return wrong;
  return !there || same_bits(*there, {back->b, back->a}) ? 0 : wrong;
}

/// 0 where a batch, with the segment in every lane and turned round, has the bits of exact_decision.
double batch_error(const Input& i) {
  if (!all_finite(i) || i[6] < 0) return 0;
  const Segment<2, double> segment = segment_of(i);
  std::vector<Segment<2, double>> segments(17, segment), clipped(17);
  for (std::size_t k = 0; k < segments.size(); k += 3) std::swap(segments[k].a, segments[k].b);
  std::vector<std::uint8_t> accepted(segments.size());
  liang_barsky_circle::clip_batch(segments, circle_of(i), clipped, accepted);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const auto right = exact_decision(segments[k], circle_of(i));
    if (accepted[k] != right.has_value() || !same_bits(clipped[k], right.value_or(segments[k]))) return wrong;
  }
  return 0;
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
      {"a small circle far away, met obliquely", {1, 0x3bp-1074, 0, -1, 1, 0, 0x3ap-1074}},
      {"halves added to whole numbers beyond 2^53",
       {0x1.0fc67f45a8d9ep-1020, 0x1.b23ad7dbd093p-1023, 0x1.bdb77a3e455c0p-1024, 0x1.4d0f4dbedc5d0p-1020, 0,
        0, 0x1.f98896254d7f2p-1021}}};
}

}  // namespace

Domain liang_barsky_circle() {
  return {"liang_barsky_circle",
          {{.name = "exact_decision",
            .states = "accepts and rejects exactly; ends within 0.63 ulp of max(|coordinate|, r)",
            .unit = "ulp",
            .bound = 0.63,
            .numbers = 7,
            .generate = generate,
            .error = error,
            .arguments = arguments,
            .traps = traps()},
           {.name = "reversed",
            .states = "the segment turned round gives the reverse, bit for bit",
            .unit = "wrong",
            .bound = 0,
            .numbers = 7,
            .generate = generate,
            .error = reversed_error,
            .arguments = arguments,
            .traps = traps()},
           {.name = "clip_batch",
            .states = "every lane has the bits of exact_decision",
            .unit = "wrong",
            .bound = 0,
            .numbers = 7,
            .generate = generate,
            .error = batch_error,
            .arguments = arguments,
            .traps = traps()}}};
}

}  // namespace gradus::stress
