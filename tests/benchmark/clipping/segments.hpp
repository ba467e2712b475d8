#pragma once
// Methods that clip many segments, with what exact arithmetic leaves of each: what the benchmarks of the
// clippers of segments share.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/subject.hpp"
#include "support/clip_oracle.hpp"

namespace gradus::bench::segments {

template <int N>
using Lines = std::vector<Segment<N, double>>;

/// Segments, and what is right of each: nothing where nothing is left.
template <int N, class Right = test::ExactEnds<N>>
struct Set {
  Lines<N> lines;
  std::vector<std::optional<Right>> right;
};

/// What a method leaves of every line, and of which lines something is left.
template <int N>
struct Clipped {
  explicit Clipped(std::size_t count) : lines(count), accepted(count) {}
  Lines<N> lines;
  std::vector<std::uint8_t> accepted;
};

/// Clips all lines with a method that takes one; inlined into the loop.
template <class One>
auto each(One one) {
  return [one](const auto& lines, auto& clipped) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto line = one(lines[i]);
      if (line) clipped.lines[i] = *line;
      clipped.accepted[i] = line.has_value();
    }
  };
}

/// Both ends, in ulp of the exact coordinates, but not of one below 1.
template <int N>
void add_errors(Error::Sum& sum, const Segment<N, double>& found, const test::ExactEnds<N>& right) {
  for (int axis = 0; axis < N; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    sum.add(test::error_in_ulp(found.a[axis], right.a[k], 1));
    sum.add(test::error_in_ulp(found.b[axis], right.b[k], 1));
  }
}

/// clip(lines, clipped) is what is timed; add_errors(sum, line, right) judges a line.
template <int N, class Right, class Clip, class AddErrors>
Case case_of(std::string method, Standing standing, const Set<N, Right>& set, Clip clip, Workload workload,
             AddErrors add_errors) {
  const auto found = std::make_shared<Clipped<N>>(set.lines.size());
  const auto own = std::make_shared<Clip>(std::move(clip));  // one of its own for each set
  (*own)(set.lines, *found);
  Error::Sum sum;
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const auto& right = set.right[i];
    if (right.has_value() != (found->accepted[i] != 0)) sum.wrong_decision();
    if (right && found->accepted[i]) add_errors(sum, found->lines[i], *right);
  }
  return {.method = std::move(method),
          .standing = standing,
          .workload = std::move(workload),
          .items = static_cast<std::int64_t>(set.lines.size()),
          .run = [own, &set, found] { (*own)(set.lines, *found); },
          .error = sum.error()};
}

}  // namespace gradus::bench::segments
