// Segments in a window: both methods and the batch against rationals, in double and float.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <optional>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"
#include "clipping/liang_barsky/liang_barsky.hpp"
#include "support/clip_oracle.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

template <class T>
using Part = std::optional<Segment<2, T>>;

template <class T>
void compare(const Segment<2, T>& line, const AxisBox<2, T>& window, const BorderOrder<2>& order) {
  const Part<T> part = cohen_sutherland_2d::correctly_rounded(line, window);
  const auto exact = test::exact_clip(line, window);
  require(part.has_value() == exact.has_value(), "kept exactly when there is a common point");
  // The order decides only whether a zero is a border's -0 or the rounded +0
  require(cohen_sutherland_2d::correctly_rounded(line, window, order) == part,
          "the order of the borders does not matter");
  require(test::same_bits(liang_barsky::correctly_rounded(line, window), part), "both methods agree");
  require(liang_barsky::correctly_rounded(line, window, order) == part,
          "the order of the borders does not matter to Liang and Barsky");
  const Part<T> back = cohen_sutherland_2d::correctly_rounded(test::reversed(line), window);
  require(back.has_value() == part.has_value(), "the reverse is kept as well");
  if (!part) return;
  require(test::same_bits(test::reversed(*back), *part), "the reverse is the reverse");
  require(test::same_bits(cohen_sutherland_2d::correctly_rounded(*part, window), part),
          "clipping again changes nothing");
  for (std::size_t i = 0; i < 2; ++i) {
    const int axis = static_cast<int>(i);
    require(test::is_nearest(part->a[axis], exact->a[i]), "the first end is the nearest point");
    require(test::is_nearest(part->b[axis], exact->b[i]), "the last end is the nearest point");
  }
}

/// Domain: finite.
AxisBox<2, double> window_of(glm::dvec2 p, glm::dvec2 q) { return {glm::min(p, q), glm::max(p, q)}; }

bool fits_float(glm::dvec2 p) { return std::abs(p.x) < 0x1p127 && std::abs(p.y) < 0x1p127; }

void refused(test::FuzzInput& input) {
  const glm::dvec2 a{input.any_number(), input.any_number()}, b{input.any_number(), input.any_number()},
      low{input.any_number(), input.any_number()}, high{input.any_number(), input.any_number()};
  const bool fine =
      is_finite(a) && is_finite(b) && is_finite(low) && is_finite(high) && low.x <= high.x && low.y <= high.y;
  try {
    static_cast<void>(cohen_sutherland_2d::correctly_rounded(Segment<2, double>{a, b}, {low, high}));
    require(fine, "what is no segment or no window is refused");
  } catch (const ContractViolation&) {
    require(!fine, "only what is no segment or no window is refused");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  if (input.below(16) == 15) {
    refused(input);
    return 0;
  }
  BorderOrder<2> order = usual_order<2>();
  for (std::size_t i = order.size(); i-- > 1;) {
    std::swap(order[i], order[static_cast<std::size_t>(input.below(static_cast<int>(i) + 1))]);
  }
  // All sizes, or those at which fast arithmetic is taken
  const int reach = input.coin() ? 1074 : 60;
  const glm::dvec2 p = input.point(-reach, std::min(reach, 1023)),
                   q = input.point(-reach, std::min(reach, 1023));
  const AxisBox<2, double> window = window_of(p, q);
  std::array<Segment<2, double>, 11> lines;
  const int count = 1 + input.below(3);
  for (int i = 0; i < count; ++i) {
    Segment<2, double> line;
    line.a = input.point(-reach, std::min(reach, 1023));
    line.b = input.point(-reach, std::min(reach, 1023));
    // Often through a corner, or as near as rounding puts it
    if (input.below(4) == 0) line.b = p + (p - line.a) * input.number(-3, 3);
    if (!is_finite(line.b)) line.b = q;
    lines[static_cast<std::size_t>(i)] = line;
    compare(line, window, order);
    if (fits_float(line.a) && fits_float(line.b) && fits_float(p) && fits_float(q)) {
      compare(Segment<2, float>{glm::vec2(line.a), glm::vec2(line.b)},
              AxisBox<2, float>{glm::vec2(window.lower), glm::vec2(window.upper)}, order);
    }
  }
  // The batch, whole registers and a rest
  for (std::size_t i = static_cast<std::size_t>(count); i < lines.size(); ++i) {
    lines[i] = lines[i % static_cast<std::size_t>(count)];
    if (i % 2) lines[i] = test::reversed(lines[i]);
  }
  std::array<Segment<2, double>, 11> clipped;
  std::array<std::uint8_t, 11> accepted{};
  const std::size_t kept = cohen_sutherland_2d::clip_batch(lines, window, clipped, accepted);
  require(kept == static_cast<std::size_t>(std::count(accepted.begin(), accepted.end(), 1)),
          "the batch counts");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto part = cohen_sutherland_2d::correctly_rounded(lines[i], window);
    require(part.has_value() == (accepted[i] != 0), "the batch decides alike");
    require(test::same_bits(clipped[i], part ? *part : lines[i]), "the batch has the same bits");
  }
  return 0;
}
