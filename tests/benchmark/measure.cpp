#include "benchmark/measure.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>

namespace gradus::bench {
namespace {

/// Seconds per run, of every repetition.
struct Times {
  std::vector<double> real, cpu;
};

/// Keeps the times by the case's number, which is its name.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.iterations == 0) continue;
      Times& times = times_[std::stoul(run.run_name.function_name)];
      times.real.push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
      times.cpu.push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
  }
  Times times(std::size_t number) {
    Times sorted = times_[number];
    std::ranges::sort(sorted.real);
    std::ranges::sort(sorted.cpu);
    return sorted;
  }

 private:
  std::map<std::size_t, Times> times_;
};

struct Took {
  double runs = 0, whole = 0;  ///< seconds: of the runs, and with their preparation
};

Took seconds_of(const Case& of, std::int64_t runs) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  Took took;
  const auto first = Clock::now();
  for (std::int64_t i = 0; i < runs; ++i) {
    if (of.prepare) of.prepare();
    const auto start = Clock::now();
    of.run();
    took.runs += since(start);
  }
  took.whole = since(first);
  return took;
}

/// So much longer than asked for a repetition may last with its preparation: a fill of ten cells needs a
/// fresh canvas of a million.
constexpr double most_preparation = 4;

/// Runs that take about so long together.
std::int64_t runs_for(const Case& of, double seconds) {
  std::int64_t runs = 1;
  for (;;) {
    const Took took = seconds_of(of, runs);
    if (took.runs >= seconds / 8 || took.whole >= seconds || runs > (1 << 24)) {
      const double repetitions = std::min(seconds / took.runs, most_preparation * seconds / took.whole);
      return std::max<std::int64_t>(1, static_cast<std::int64_t>(repetitions * static_cast<double>(runs)));
    }
    runs *= 4;
  }
}

void time_case(benchmark::State& state, const Case& of) {
  for (auto _ : state) {
    if (of.prepare) {
      state.PauseTiming();
      of.prepare();
      state.ResumeTiming();
    }
    of.run();
    benchmark::ClobberMemory();
  }
}

}  // namespace

std::vector<Result> measure(std::vector<Case> cases, const Effort& effort,
                            const std::function<void()>& told) {
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Result> results;
  for (Case& of : cases) results.push_back({std::move(of)});
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].repetitions = effort.repetitions;
    results[i].iterations = runs_for(results[i].of, effort.seconds);
    benchmark::RegisterBenchmark(std::to_string(i).c_str(),
                                 [&of = results[i].of, &told](benchmark::State& state) {
                                   time_case(state, of);
                                   told();
                                 })
        ->Iterations(results[i].iterations)
        ->Repetitions(effort.repetitions)
        ->UseRealTime();
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto [real, cpu] = collector.times(i);
    if (real.empty()) continue;
    const std::size_t half = real.size() / 2, quarter = real.size() / 4;
    const double an_item = 1e9 / static_cast<double>(results[i].of.items);
    results[i].nanoseconds = real[half] * an_item;
    results[i].cpu_nanoseconds = cpu[half] * an_item;
    results[i].spread = (real[real.size() - 1 - quarter] - real[quarter]) / real[half];
  }
  benchmark::ClearRegisteredBenchmarks();
  return results;
}

}  // namespace gradus::bench
