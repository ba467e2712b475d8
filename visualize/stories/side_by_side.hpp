#pragma once
// A numeric topic in float, in double and without rounding: the same method three times. The story keeps its
// steps and its drawing; its table becomes one of numbers, how far off each is, and the first decision that
// rounding changes is marked.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "stories/telling.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// What a step holds: numbers, which rounding spoils a little, and decisions, which it must not change.
template <class T>
struct NumericStep {
  std::string type;  ///< the step type's name, as in the trace
  int line = 0;      ///< the source line that reported it
  std::vector<std::pair<std::string, T>> numbers{};
  std::vector<std::int64_t> decisions{};

  void number(std::string name, T value) { numbers.emplace_back(std::move(name), value); }
  /// "a.x", "a.y" …
  template <glm::length_t N>
  void point(const std::string& name, const glm::vec<N, T>& p) {
    for (glm::length_t i = 0; i < N; ++i) number(name + "." + "xyzw"[i], p[i]);
  }
  /// Of an integer, a bool or an enumeration.
  template <class Decision>
  void decision(Decision value) {
    decisions.push_back(static_cast<std::int64_t>(value));
  }
};

/// The method's steps in T, as far as it came.
template <class T>
struct NumericRun {
  std::vector<NumericStep<T>> steps;
  bool refused = false;  ///< T can't hold a number that comes up
};

struct NumericRuns {
  NumericRun<float> in_float;
  NumericRun<double> in_double;
  NumericRun<Exact> exact;
};

/// The arithmetic that the story itself was told in.
enum class ToldIn { floats, doubles };

/// Replaces the table of a whole trace: a row per number. Trace steps and numeric steps of one type
/// correspond in order; a step with several numbers becomes several finer ones. Trace.telling becomes the
/// first step that float or double decides otherwise than exact arithmetic, if there is one.
void put_side_by_side(Trace& trace, const NumericRuns& runs, ToldIn told_in);

/// Runs `method(T(), observer)` for the three T. `Numbers` has, for each type of step that the method
/// reports, `void operator()(NumericStep<T>&, const Step&)`, which fills in numbers and decisions, and the
/// type where it is told by another name than the step's own.
template <class Numbers, class Method>
void show_side_by_side(Trace& trace, Method method, ToldIn told_in = ToldIn::doubles) {
  const ExactScope scope;
  const auto watch = [&]<class T>(NumericRun<T>& run) {
    const auto observer = [&]<class Step>(const Step& step, int line = __builtin_LINE(),
                                          const char* = nullptr) {
      run.steps.push_back({.type = std::string(Narrator::step_name<Step>()), .line = line});
      Numbers{}(run.steps.back(), step);
    };
    run.refused = !keeps_contracts([&] { method(T{}, observer); });
  };
  NumericRuns runs;
  watch(runs.in_float);
  watch(runs.in_double);
  watch(runs.exact);
  put_side_by_side(trace, runs, told_in);
}

/// The parameter of a topic that has such a table, and whether it is asked for.
Parameter exact_parameter();
inline bool side_by_side(const Arguments& arguments) { return arguments.flag("exact"); }

/// Where it is asked for, the table becomes that of `run` in the three T once all is told. Till then `run` is
/// kept: it must hold what it needs.
template <class Numbers, class Run>
void tell_side_by_side(Narrator& narrator, Run run, ToldIn told_in = ToldIn::doubles) {
  if (!side_by_side(narrator.arguments())) return;
  narrator.afterwards([=](Trace& trace) { show_side_by_side<Numbers>(trace, run, told_in); });
}

/// The same vector, box … in another scalar.
template <class T, glm::length_t N>
glm::vec<N, T> in_scalar(const glm::vec<N, double>& p) {
  glm::vec<N, T> result{};
  for (glm::length_t i = 0; i < N; ++i) result[i] = T(p[i]);
  return result;
}

template <class T, int N>
Segment<N, T> in_scalar(const Segment<N, double>& line) {
  return {in_scalar<T>(line.a), in_scalar<T>(line.b)};
}
template <class T, int N>
AxisBox<N, T> in_scalar(const AxisBox<N, double>& box) {
  return {in_scalar<T>(box.lower), in_scalar<T>(box.upper)};
}

}  // namespace gradus
