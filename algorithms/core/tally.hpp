#pragma once
// Counts that reports alone tell, as how many pixels of a face were compared: they belong to the observer.
//
//   Tally<O, Work> tally(observer);
//   ...
//   keep_nearest(cells, p, z, id, tally);  // what it reports is counted on its way to the observer
//   if constexpr (observed<O>) observer(tally.count(FaceDone{id}));
//
// The line that declares one says nothing of the method, so that listings leave it out, and so is it where a
// tally is handed on.

#include <type_traits>

#include "core/observe.hpp"

namespace gradus {

/// Passes every step on as count(step) gives it: with what was counted filled in. Holds a reference.
template <class O, class Count>
class Tallied {
 public:
  constexpr explicit Tallied(O& observer) : observer_(observer) {}

  template <class Step>
  constexpr void operator()(const Step& step, int line = __builtin_LINE(),
                            const char* file = __builtin_FILE()) {
    tell(observer_, count(step), line, file);
  }

  Count count{};

 private:
  O& observer_;
};

/// Without an observer there is nothing to count for.
template <class O, class Count>
using Tally = std::conditional_t<observed<O>, Tallied<std::remove_reference_t<O>, Count>, Unobserved>;

}  // namespace gradus
