#pragma once
// The order front to back of fragments that overlap in depth, at all sub-samples at once: a queue for each,
// of which every fragment comes out whole where an order of whole fragments will do.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "antialiasing/a_buffer/fragment.hpp"

namespace gradus::a_buffer {

/// The sub-samples that several fragments cover.
constexpr Mask shared(std::span<const Fragment> fragments) {
  Mask once = 0, twice = 0;
  for (const Fragment& f : fragments) {
    twice |= once & f.mask;
    once |= f.mask;
  }
  return twice;
}

/// Fragments that have no place in a list as yet: at each sub-sample a queue of those that cover it, front to
/// back, and one of those that cover none.
template <class Depths>
class Queues {
 public:
  /// sorted: by nearest depths.
  constexpr Queues(std::span<const Fragment> sorted, Depths& depths)
      : rest_(sorted.begin(), sorted.end()), open_(sorted.size()) {
    make_room();
    const Mask asked = shared(sorted);
    for (std::size_t i = 0; i < rest_.size(); ++i) line_up(i, asked, depths(rest_[i]));
    for (const Queue& queue : std::span(queues_).first(samples)) {
      std::ranges::sort(waiting_.begin() + queue.first, waiting_.begin() + queue.end,
                        [this](const Waiting& a, const Waiting& b) { return before(a, b); });
    }
    for (int sample = 0; sample < samples; ++sample) open_first(sample);
  }
  /// Takes the first off that no other lies before at any sub-sample. Where there is none, for surfaces
  /// cross, it is the part of the first that is open in part.
  constexpr Fragment taken() {
    const std::size_t i = next();
    Fragment part = rest_[i];
    part.mask = std::exchange(open_[i], 0);
    rest_[i].mask &= ~part.mask;
    if (part.mask == 0) ++queues_[samples].first;
    for (Mask left = part.mask; left != 0; left &= left - 1) {
      ++queues_[static_cast<std::size_t>(last_of(left))].first;
      open_first(last_of(left));
    }
    return part;
  }

  constexpr bool empty() const { return std::ranges::all_of(queues_, &Queue::empty); }

 private:
  using Depth = std::invoke_result_t<std::invoke_result_t<Depths&, const Fragment&>, int>;
  struct Waiting {
    std::size_t number = 0;  ///< of a fragment
    Depth depth{};           ///< at the sub-sample, if others are there
  };
  struct Queue {
    std::ptrdiff_t first = 0, end = 0;
    constexpr bool empty() const { return first == end; }
  };

  constexpr void make_room() {
    std::ptrdiff_t all = 0;
    for (int s = 0; s < samples; ++s) {
      queues_[static_cast<std::size_t>(s)] = {all, all};
      all += std::ranges::count_if(rest_, [s](const Fragment& f) { return (f.mask & bit_of(s)) != 0; });
    }
    queues_[samples] = {all, all};
    waiting_.resize(static_cast<std::size_t>(all + std::ranges::count(rest_, Mask{0}, &Fragment::mask)));
  }
  constexpr Waiting& last_place(std::size_t queue) {
    return waiting_[static_cast<std::size_t>(queues_[queue].end++)];
  }
  constexpr void line_up(std::size_t i, Mask asked, auto&& depth) {
    if (rest_[i].mask == 0) last_place(samples).number = i;
    for (Mask left = rest_[i].mask; left != 0; left &= left - 1) {
      const int s = last_of(left);
      last_place(static_cast<std::size_t>(s)) = {i, (asked & bit_of(s)) != 0 ? depth(s) : Depth{}};
    }
  }
  constexpr bool before(const Waiting& a, const Waiting& b) const {
    const Fragment &f = rest_[a.number], &g = rest_[b.number];
    return std::tie(a.depth, f.surface, f.source, a.number) <
           std::tie(b.depth, g.surface, g.source, b.number);
  }
  /// Whose turn it is in a queue.
  constexpr std::size_t foremost(const Queue& queue) const {
    return waiting_[static_cast<std::size_t>(queue.first)].number;
  }
  constexpr void open_first(int sample) {
    const Queue& queue = queues_[static_cast<std::size_t>(sample)];
    if (!queue.empty()) open_[foremost(queue)] |= bit_of(sample);
  }
  constexpr std::size_t next() const {
    const std::size_t none = rest_.size();
    std::size_t whole = none, in_part = none;
    for (const Queue& queue : queues_) {
      if (queue.empty()) continue;
      const std::size_t i = foremost(queue);
      in_part = std::min(in_part, i);
      if (open_[i] == rest_[i].mask) whole = std::min(whole, i);
    }
    return whole != none ? whole : in_part;
  }

  std::vector<Fragment> rest_;    ///< what is left of each
  std::vector<Mask> open_;        ///< where each is foremost
  std::vector<Waiting> waiting_;  ///< queue by queue
  std::array<Queue, samples + 1> queues_{};
};

}  // namespace gradus::a_buffer
