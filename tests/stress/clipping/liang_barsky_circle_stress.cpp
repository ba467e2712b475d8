// The promises of clipping a segment to a circle.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/contract.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using liang_barsky_circle::Circle;
using liang_barsky_circle::Segment;

/// From, to, centre, radius.
Input generate(Kind kind, Random& random) {
  Input input(7);
  for (double& x : input) x = kind == Kind::refused ? number(Kind::random, random) : number(kind, random);
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
  } else if (kind == Kind::refused) {
    const auto at = static_cast<std::size_t>(random.uniform_int(0, 6));
    input[at] = at == 6 && random.unit() < 0.5 ? -1 : random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

double error(const Input& i) {
  const bool taken = all_finite(i) && i[6] >= 0;
  std::optional<Segment<double>> found;
  try {
    found = liang_barsky_circle::exact_decision(Segment<double>{{i[0], i[1]}, {i[2], i[3]}},
                                                Circle<double>{{i[4], i[5]}, i[6]});
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken) return wrong;
  const std::optional<EndsInCircle> right = ends_in_circle(i);
  if (found.has_value() != right.has_value()) return wrong;
  if (!found) return 0;
  return std::max(right->from.error(found->from), right->to.error(found->to));
}

}  // namespace

Domain liang_barsky_circle() {
  const double one_up = 1 + 0x1p-52, one_down = 1 - 0x1p-53;
  return {"liang_barsky_circle",
          {{.name = "exact_decision",
            .states = "accepts and rejects exactly; ends within 0.63 ulp of max(|coordinate|, r)",
            .unit = "ulp",
            .bound = 0.63,
            .numbers = 7,
            .generate = generate,
            .error = error,
            .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
              return {{"method", "exact_decision"},
                      {"line", fmt::format("{},{},{},{}", i[0], i[1], i[2], i[3])},
                      {"circle", fmt::format("{},{},{}", i[4], i[5], i[6])}};
            },
            .traps = {{"starts on the rim", {1, 0, 2, 0, 0, 0, 1}},
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
                      {"the line, not the segment, meets the circle", {0, 0, 0.5, 0, 0, 0, 1}}}}}};
}

}  // namespace gradus::stress
