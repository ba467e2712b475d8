#pragma once
// Work that may crash, or take all memory, in a process of its own: what it does to itself, it does to nobody
// else.

#include <cstddef>
#include <functional>
#include <string>

namespace gradus::cli {

/// What such a process may take.
struct ProcessLimits {
  std::size_t seconds;  ///< of a processor's time
  std::size_t bytes;    ///< of memory, beside what this process has
};

/// What came of it.
struct ProcessResult {
  enum class End {
    whole,     ///< the bytes are what the work has returned
    crashed,   ///< by a signal, or by an exception
    too_much,  ///< it has used up its time, or the system's memory
  };
  End end = End::whole;
  std::string bytes;
};

/// Does the work in a copy of this process and hands over what it returns. The copy has this thread alone, no
/// standard streams, and ends with this process.
///
/// Domain: work that needs no other thread. Cost: that of a process, and of copying the result twice.
/// Errors: WorkError when there can be no other process.
ProcessResult in_own_process(const std::function<std::string()>& work, const ProcessLimits& limits);

}  // namespace gradus::cli
