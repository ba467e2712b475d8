// The promise of the z-buffer: the nearest of all, whatever their order.

#include "visibility/z_buffer/z_buffer.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

constexpr std::size_t count = 4;

/// Four depths, then their keys.
Input generate(Kind kind, Random& random) {
  Input input(2 * count);
  for (double& x : input) x = number(kind, random);
  for (std::size_t k = 0; k < count; ++k) {
    if (kind == Kind::near_degenerate) input[k] = nudged(input[0], random);
    if (kind == Kind::grazing && k % 2) input[k] = input[k - 1];
    input[count + k] = static_cast<double>(random.uniform_int(0, 3));
  }
  return input;
}

/// A key that is no number is beyond the promise. In every order the cell must end with the least depth, of
/// equal ones the one with the least key.
double error(const Input& i) {
  if (std::any_of(i.begin() + count, i.end(), [](double key) { return std::isnan(key); })) return 0;
  std::optional<std::pair<double, double>> least;
  for (std::size_t k = 0; k < count; ++k) {
    const std::pair candidate(i[k], i[count + k]);
    if (!std::isnan(i[k]) && (!least || candidate < *least)) least = candidate;
  }
  std::array<std::size_t, count> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    Raster<z_buffer::Cell<double, double>> buffer(2, 1);
    for (const std::size_t k : order) z_buffer::keep_nearest(buffer, {1, 0}, i[k], i[count + k]);
    const auto& cell = buffer[{1, 0}];
    if (cell.taken != least.has_value() || buffer[{0, 0}].taken) return wrong;
    if (least && (cell.depth != least->first || cell.key != least->second)) return wrong;
  } while (std::next_permutation(order.begin(), order.end()));
  return 0;
}

}  // namespace

Domain z_buffer() {
  return {"z_buffer",
          {{.name = "keep_nearest",
            .states = "the least depth, of equal ones the least key, in every order; NaN is never kept",
            .unit = "decisions",
            .bound = 0,
            .numbers = 2 * count,
            .generate = at_every_scale(generate, {0, 1, 2, 3}),
            .error = error,
            .traps = {{"no number comes first", {std::nan(""), 1, 0.5, 1, 0, 1, 2, 3}},
                      {"nothing but what is no number",
                       {std::nan(""), std::nan(""), std::nan(""), std::nan(""), 0, 1, 2, 3}},
                      {"zeros of both signs", {0.0, -0.0, 0.0, -0.0, 3, 2, 1, 0}},
                      {"infinite depths", {wrong, -wrong, wrong, 0, 0, 1, 2, 3}},
                      {"depths that differ in the last place", {1, 1 + 0x1p-52, 1, 1 - 0x1p-53, 3, 0, 1, 2}}},
            .shares = {{"two depths are equal", 0.2, [](const Input& i) {
                          Input depths(i.begin(), i.begin() + count);
                          if (std::ranges::any_of(depths, [](double x) { return std::isnan(x); }))
                            return false;
                          std::ranges::sort(depths);
                          return std::ranges::adjacent_find(depths) != depths.end();
                        }}}}}};
}

}  // namespace gradus::stress
