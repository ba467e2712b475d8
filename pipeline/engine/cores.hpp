#pragma once
// Work that several cores do at once.

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <thread>
#include <vector>

namespace gradus::pipeline::engine {

/// Something that each thread has for itself.
template <class Own>
using OfEachThread = tbb::enumerable_thread_specific<Own>;

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define GRADUS_THREADS_ARE_WATCHED
#endif
#endif

#ifdef GRADUS_THREADS_ARE_WATCHED
// The thread sanitizer does not see how TBB, a library that is compiled without it, hands work from thread to
// thread; what our work does with its data it sees like this, too.

/// work(begin, end) for parts of the numbers from 0 to count - 1, of `grain` numbers or more.
template <class Work>
void in_parts(std::size_t count, std::size_t grain, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const auto work_on = [&] {
    // Relaxed, for a counter that orders threads would hide their races
    for (std::size_t begin; (begin = next.fetch_add(grain, std::memory_order_relaxed)) < count;)
      work(begin, std::min(count, begin + grain));
  };
  std::vector<std::jthread> others;
  for (int i = 0; i < 3; ++i) others.emplace_back(work_on);
  work_on();
}

/// work(i) for the numbers i from 0 to count - 1, in any order.
template <std::integral Number, class Work>
void for_each_of(Number count, const Work& work) {
  in_parts(static_cast<std::size_t>(count), 1,
           [&work](std::size_t i, std::size_t) { work(static_cast<Number>(i)); });
}

/// Calls work(), which shares what it has to do among so many threads; 0: as many as there are cores.
template <class Work>
void on_threads(int, const Work& work) {
  work();
}

#else

/// work(begin, end) for parts of the numbers from 0 to count - 1, of `grain` numbers or more.
template <class Work>
void in_parts(std::size_t count, std::size_t grain, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&work](const auto& part) { work(part.begin(), part.end()); });
}

/// work(i) for the numbers i from 0 to count - 1, in any order.
template <std::integral Number, class Work>
void for_each_of(Number count, const Work& work) {
  tbb::parallel_for(Number{0}, count, work);
}

/// Calls work(), which shares what it has to do among so many threads; 0: as many as there are cores.
template <class Work>
void on_threads(int threads, const Work& work) {
  const int workers = threads == 0 ? tbb::this_task_arena::max_concurrency() : threads;
  // Also more than there are cores, where that is asked for
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(workers));
  tbb::task_arena(workers).execute(work);
}

#endif

}  // namespace gradus::pipeline::engine
