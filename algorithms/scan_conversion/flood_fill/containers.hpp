#pragma once
// A stack and a queue that know how full they were.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/language.hpp"

namespace gradus::flood_fill {

/// Last in, first out.
template <class Entry>
class Stack {
 public:
  static constexpr std::size_t entry_bytes = sizeof(Entry);

  void push(const Entry& entry) {
    entries_.push_back(entry);
    peak_ = std::max(peak_, entries_.size());
    ++pushed_;
  }
  void pop() { entries_.pop_back(); }
  Entry take() {
    const Entry entry = entries_.back();
    entries_.pop_back();
    return entry;
  }
  Entry& top() { return entries_.back(); }
  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  std::size_t peak() const { return peak_; }
  std::int64_t pushed() const { return pushed_; }

 private:
  std::vector<Entry> entries_;
  std::size_t peak_ = 0;
  std::int64_t pushed_ = 0;
};

/// First in, first out; gives its memory back as it empties.
template <class Entry>
class Queue {
 public:
  static constexpr std::size_t entry_bytes = sizeof(Entry);

  void push(const Entry& entry) {
    entries_.push_back(entry);
    peak_ = std::max(peak_, entries_.size());
    ++pushed_;
  }
  Entry take() {
    const Entry entry = entries_.front();
    entries_.pop_front();
    return entry;
  }
  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  std::size_t peak() const { return peak_; }
  std::int64_t pushed() const { return pushed_; }

 private:
  std::deque<Entry> entries_;
  std::size_t peak_ = 0;
  std::int64_t pushed_ = 0;
};

}  // namespace gradus::flood_fill
