#pragma once
// Of a run of many steps a story tells those that say something new.

namespace gradus {

/// An observer that hands on the steps for which tells(step) holds. Both must outlive it.
template <class Watch, class Tells>
auto some_steps(const Watch& watch, const Tells& tells) {
  return [&]<class Step>(const Step& step, int line = __builtin_LINE(), const char* file = __builtin_FILE()) {
    if (tells(step)) watch(step, line, file);
  };
}

}  // namespace gradus
