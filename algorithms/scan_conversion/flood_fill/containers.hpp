#pragma once
// A stack and a queue that know how full they were.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/language.hpp"

namespace gradus::flood_fill {

/// What both are made of: entries that come in at the back.
template <class Entries>
class Counted {
 public:
  using Entry = typename Entries::value_type;
  static constexpr std::size_t entry_bytes = sizeof(Entry);

  void push(const Entry& entry) {
    entries_.push_back(entry);
    peak_ = std::max(peak_, entries_.size());
    ++pushed_;
  }
  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  std::size_t peak() const { return peak_; }
  std::int64_t pushed() const { return pushed_; }

 protected:
  Entries entries_;

 private:
  std::size_t peak_ = 0;
  std::int64_t pushed_ = 0;
};

/// Last in, first out.
template <class Entry>
class Stack : public Counted<std::vector<Entry>> {
 public:
  Entry& top() { return this->entries_.back(); }
  void pop() { this->entries_.pop_back(); }
  Entry take() {
    const Entry entry = top();
    pop();
    return entry;
  }
};

/// First in, first out; gives its memory back as it empties.
template <class Entry>
class Queue : public Counted<std::deque<Entry>> {
 public:
  Entry take() {
    const Entry entry = this->entries_.front();
    this->entries_.pop_front();
    return entry;
  }
};

}  // namespace gradus::flood_fill
