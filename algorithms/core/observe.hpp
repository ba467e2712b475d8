#pragma once
// Watching an algorithm: it tells an optional observer what it has just done.
//
//   if constexpr (observed<O>) observer(Cut{from, to, edge});
//
// always in this form, on a line of its own right after the statement it reports. With no observer the
// line vanishes and the machine code is that of a copy without it (tests/architecture).

#include <concepts>
#include <functional>
#include <type_traits>
#include <utility>

#include "core/language.hpp"

namespace gradus {

/// The default observer: ignores every step and compiles to nothing.
struct Unobserved {
  template <class Step>
  constexpr void operator()(const Step&) const noexcept {}
};

/// O can be told each of these steps. A forgotten step type is a compile error at the call.
template <class O, class... Steps>
concept Observer = (std::invocable<O&, const Steps&> && ...);

/// False for Unobserved, so that an `if constexpr` removes the observer line altogether.
template <class O>
inline constexpr bool observed = !std::same_as<std::remove_cvref_t<O>, Unobserved>;

/// Hands a step to an observer together with the line that reported it. An observer that wants the line takes
/// (step, line, file); a plain lambda takes the step alone.
template <class O, class Step>
constexpr void tell(O& observer, const Step& step, int line, const char* file) {
  if constexpr (std::invocable<O&, const Step&, int, const char*>) {
    observer(step, line, file);
  } else {
    observer(step);
  }
}

/// Both observers see every step, first `a`, then `b`, with the line of the algorithm that reported it.
/// Holds references: both must outlive the run.
template <class A, class B>
auto tee(A& a, B& b) {
  return
      [&a, &b]<class Step>(const Step& step, int line = __builtin_LINE(), const char* file = __builtin_FILE())
    requires Observer<A, Step> && Observer<B, Step>
  {
    tell(a, step, line, file);
    tell(b, step, line, file);
  };
}

/// Passes on the named step types and drops every other one.
template <class... Steps, class O>
auto only(O& observer) {
  return [&observer]<class Step>(const Step& step, int line = __builtin_LINE(),
                                 const char* file = __builtin_FILE()) {
    if constexpr ((std::same_as<Step, Steps> || ...)) tell(observer, step, line, file);
  };
}

/// Passes every step on after `change(step)`, keeping the line: for one algorithm that runs inside another
/// (in other coordinates, say). Without `change` it is the observer by reference.
template <class O, class Change = std::identity>
auto forward(O& observer, Change change = {}) {
  return [&observer, change]<class Step>(const Step& step, int line = __builtin_LINE(),
                                         const char* file = __builtin_FILE()) {
    tell(observer, std::invoke(change, step), line, file);
  };
}

}  // namespace gradus
