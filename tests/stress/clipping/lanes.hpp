#pragma once
// Batches of segments: the bits of the scalar method in every lane, on every kind of machine.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/contract.hpp"
#include "stress/domain.hpp"
#include "support/clip_oracle.hpp"
#include "support/every_target.hpp"

namespace gradus::stress::lanes {

template <int N>
using Lines = std::vector<Segment<N, double>>;

/// 0 where a batch leaves of every segment what the scalar method leaves, bit for bit, and of the others the
/// segment itself; clipped in place, too. batch(lines, clipped, accepted) returns how many are accepted.
template <int N, class Batch, class Scalar>
double error(const Lines<N>& lines, Batch batch, Scalar scalar) {
  std::vector<std::optional<Segment<N, double>>> right;
  std::ranges::transform(lines, std::back_inserter(right), scalar);
  double worst = 0;
  test::on_every_target([&] {
    Lines<N> clipped(lines.size()), in_place = lines;
    std::vector<std::uint8_t> accepted(lines.size()), again(lines.size());
    const std::size_t kept = batch(lines, clipped, accepted);
    batch(in_place, in_place, again);
    if (kept != static_cast<std::size_t>(std::ranges::count(accepted, 1)) || again != accepted) worst = wrong;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool same = accepted[i] == right[i].has_value() &&
                        test::same_bits(clipped[i], right[i].value_or(lines[i])) &&
                        test::same_bits(in_place[i], clipped[i]);
      if (!same) worst = wrong;
    }
  });
  return worst;
}

/// 0 where a batch refuses a segment wherever it stands among others.
template <int N, class Batch>
double refusal_error(const Segment<N, double>& line, Batch batch) {
  double worst = 0;
  test::on_every_target([&] {
    for (const std::size_t at : {0u, 5u, 8u}) {
      Lines<N> lines(9), clipped(9);
      std::vector<std::uint8_t> accepted(9);
      lines[at] = line;
      try {
        batch(lines, clipped, accepted);
        worst = wrong;
      } catch (const ContractViolation&) {
        continue;
      }
    }
  });
  return worst;
}

}  // namespace gradus::stress::lanes
