#pragma once
// Keeping the steps an algorithm reports, for tests and for reading them all at once.

#include <cstddef>
#include <variant>
#include <vector>

#include "core/observe.hpp"

namespace gradus {

/// Records steps of the named types, in order, each with the source line that reported it.
///
/// Domain: keeps at most `cap` steps and counts the rest, so that a run of any length is safe to record;
/// `complete()` says whether any were dropped.
/// Cost: O(1) per step; the memory of `cap` variants at most.
template <class... Steps>
class Recorder {
 public:
  using Step = std::variant<Steps...>;
  struct Event {
    Step step;
    int line;          ///< line of the algorithm's source, from 1
    const char* file;  ///< its file, as the compiler was given it
  };
  static constexpr std::size_t default_cap = 1'000'000;

  explicit Recorder(std::size_t cap = default_cap) : cap_(cap) {}

  template <class S>
    requires(std::same_as<S, Steps> || ...)
  void operator()(const S& step, int line = __builtin_LINE(), const char* file = __builtin_FILE()) {
    ++seen_;
    if (events_.size() < cap_) events_.push_back({step, line, file});
  }

  const std::vector<Event>& events() const { return events_; }
  std::size_t seen() const { return seen_; }
  bool complete() const { return seen_ == events_.size(); }

 private:
  std::vector<Event> events_;
  std::size_t seen_ = 0;
  std::size_t cap_;
};

/// All recorded steps of one type, in order.
template <class S, class... Steps>
std::vector<S> all(const Recorder<Steps...>& recorder) {
  std::vector<S> found;
  for (const auto& event : recorder.events()) {
    if (const S* step = std::get_if<S>(&event.step)) found.push_back(*step);
  }
  return found;
}

/// Whether there is at least one step of type S and the law holds for every one of them (an empty record
/// proves nothing, so it is false).
template <class S, class Law, class... Steps>
bool every(const Recorder<Steps...>& recorder, Law law) {
  bool any = false;
  for (const auto& event : recorder.events()) {
    const S* step = std::get_if<S>(&event.step);
    if (!step) continue;
    any = true;
    if (!law(*step)) return false;
  }
  return any;
}

}  // namespace gradus
