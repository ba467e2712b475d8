#pragma once
// Work on several threads at once.

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "cli/commands/commands.hpp"

namespace gradus::cli {

/// The cores this process may use: what the scheduler grants, within what the machine allows.
std::size_t usable_cores();

/// How many threads a request asks for with --jobs; else usable_cores. Throws UsageError.
std::size_t read_jobs(const Request& request);

/// Calls do_one(i) for every i < count, on several threads. The first exception ends the work and is thrown
/// here.
template <class DoOne>
void in_parallel(std::size_t count, std::size_t threads, DoOne do_one) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr problem;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) do_one(i);
    } catch (...) {
      next = count;
      const std::scoped_lock lock(mutex);
      if (!problem) problem = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads && i < count; ++i) others.emplace_back(work);
    work();
  }
  if (problem) std::rethrow_exception(problem);
}

}  // namespace gradus::cli
