#pragma once
// Times the cases of a subject with Google Benchmark: methods interleaved at random, the median of some
// repetitions.

#include <functional>
#include <vector>

#include "benchmark/subject.hpp"

namespace gradus::bench {

/// A case, measured.
struct Result {
  Case of;
  double nanoseconds = 0;  ///< an item, the median of the repetitions
  double cpu_nanoseconds = 0;
  double spread = 0;            ///< between the quartiles, as a part of the median
  std::int64_t iterations = 0;  ///< runs per repetition
  int repetitions = 0;
};

/// `told` is called after each repetition.
std::vector<Result> measure(std::vector<Case> cases, const Effort& effort, const std::function<void()>& told);

}  // namespace gradus::bench
