#include "stories/side_by_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "figure/recording.hpp"

namespace gradus {
namespace {

using fmt::arg;

/// A column's room in characters, and so many digits that count. Eight show what is wrong with a float; what
/// is wrong with a double takes more than a table has room for.
struct Room {
  int digits;
  std::size_t characters;
};
constexpr Room float_room{8, 9}, other_room{6, 8};

std::string short_number(double value, int digits) {
  const std::string sign = value < 0 ? "−" : "";
  return sign + fmt::format("{:.{}g}", std::abs(value), digits);
}

/// As many of the digits as there is room for.
std::string fitted(double value, Room room) {
  for (int digits = room.digits; digits > 2; --digits) {
    std::string text = short_number(value, digits);
    const bool negative = text.starts_with("−");
    if (text.size() - (negative ? std::string_view("−").size() - 1 : 0) <= room.characters) return text;
  }
  return short_number(value, 2);
}

/// "= 1/12", or the first digits where the fraction is long: "≈ 1.7320508075688772".
std::string exact_text(Exact value) {
  std::string text = to_string(value);
  if (text.size() > 16) return "≈ " + short_number(to_double(value), 17);
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return "= " + text;
}

/// The distance between the numbers of T next to x, at its size.
template <class T>
double ulp_at(double x) {
  const int exponent = x == 0 ? std::numeric_limits<T>::min_exponent : std::ilogb(x) + 1;
  return std::ldexp(
      1.0, std::max(exponent, std::numeric_limits<T>::min_exponent) - std::numeric_limits<T>::digits);
}

/// |value - exact| in ulp of T at the exact value; 0 for a value that has left T's range.
template <class T>
double error_in_ulp(T value, Exact exact) {
  if (!std::isfinite(value)) return 0;
  return to_double(abs(Exact(value) - exact) / Exact(ulp_at<T>(to_double(exact))));
}

std::string ulp_text(double ulp) {
  return ulp < 100 ? fmt::format("{:.2g}", ulp) : fmt::format("{:.1e}", ulp);
}

/// A number in one of the arithmetics, beside the exact one.
struct Inexact {
  double value, error;
  bool in_range() const { return std::isfinite(value); }
};

/// A run in T beside the exact one.
template <class T>
class Beside {
 public:
  Beside(const NumericRun<T>& run, const NumericRun<Exact>& exact) : run_(run), exact_(exact) {
    const std::size_t both = std::min(run.steps.size(), exact.steps.size());
    together_ = 0;
    while (together_ < both && same_branch(together_)) ++together_;
    std::size_t agreed = 0;
    while (agreed < together_ && run.steps[agreed].decisions == exact.steps[agreed].decisions) ++agreed;
    if (agreed < std::max(run.steps.size(), exact.steps.size())) differs_at_ = agreed;
  }

  /// The first numeric step whose decision is another, if any.
  std::optional<std::size_t> differs_at() const { return differs_at_; }

  /// Whether both runs reported this step from the same branch, and all before it.
  bool together(std::size_t step) const { return step < together_; }

  /// The n-th number of a step; nothing where the two have parted before.
  std::optional<Inexact> number(std::size_t step, std::size_t n) const {
    if (!together(step)) return std::nullopt;
    const T value = run_.steps[step].numbers[n].second;
    return Inexact{double{value}, error_in_ulp(value, exact_.steps[step].numbers[n].second)};
  }

 private:
  bool same_branch(std::size_t i) const {
    const auto& a = run_.steps[i];
    const auto& b = exact_.steps[i];
    return a.type == b.type && a.line == b.line && a.numbers.size() == b.numbers.size();
  }

  const NumericRun<T>& run_;
  const NumericRun<Exact>& exact_;
  std::size_t together_;  ///< steps that come from the same branches, whatever they decided
  std::optional<std::size_t> differs_at_;
};

/// For each type of step, where in a run its steps are.
template <class T>
std::map<std::string, std::vector<std::size_t>> places_by_type(const NumericRun<T>& run) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < run.steps.size(); ++i) places[run.steps[i].type].push_back(i);
  return places;
}

class Retelling {
 public:
  Retelling(Trace& trace, const NumericRuns& runs, ToldIn told_in)
      : trace_(trace),
        words_(trace.wording),
        runs_(runs),
        floats_(runs.in_float, runs.exact),
        doubles_(runs.in_double, runs.exact),
        told_in_(told_in),
        places_(told_in == ToldIn::floats ? places_by_type(runs.in_float) : places_by_type(runs.in_double)) {}

  void retell() {
    std::vector<TraceStep> told = std::exchange(trace_.steps, {});
    set_columns();
    for (TraceStep& step : told) {
      const auto place = place_of(step.type);
      step.read.clear();
      step.row.clear();
      number_it(step);
      if (place) mark_difference(step, *place);
      trace_.steps.push_back(std::move(step));
      if (place) tell_numbers(*place);
    }
    expect_all_told();
    sum_up();
    measure_texts(trace_);
  }

 private:
  void set_columns() {
    const auto named = [&](std::string id) {
      const std::string name = words_.say("side_by_side.heading." + id);
      return Column{std::move(id), true, name};
    };
    trace_.columns = {named("number"), named("float"),      named("float_ulp"),
                      named("double"), named("double_ulp"), named("exact")};
    trace_.columns.front().numeric = false;
  }

  /// The numeric step that the next trace step of this type tells.
  std::optional<std::size_t> place_of(const std::string& type) {
    const auto places = places_.find(type);
    if (places == places_.end()) return std::nullopt;
    const std::size_t ordinal = seen_[type]++;
    if (ordinal >= places->second.size()) return std::nullopt;
    return places->second[ordinal];
  }

  void number_it(TraceStep& step) {
    fine_ = step.number.fine == 0 ? 0 : fine_ + 1;
    step.number.fine = fine_;
  }

  /// Where a step's mark stands: on a grid at the cell that it is about, on a paper at the first place that
  /// the step shows as its current one or its result. Nothing where it shows none.
  std::optional<dvec2> anchor_of(const TraceStep& step) const {
    if (trace_.grid.axes) return dvec2{step.focus.x, step.focus.y};
    for (const Mark& mark : step.delta.set) {
      if (mark.role != Role::current && mark.role != Role::result) continue;
      if (const Dot* dot = std::get_if<Dot>(&mark.shape)) return dot->at;
      if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) return stroke->a;
    }
    return std::nullopt;
  }

  /// Says and shows at this step whose decision is another one from here on.
  void mark_difference(TraceStep& step, std::size_t place) {
    const bool in_float = !float_told_ && floats_.differs_at() && *floats_.differs_at() <= place;
    const bool in_double = !double_told_ && doubles_.differs_at() && *doubles_.differs_at() <= place;
    if (!in_float && !in_double) return;
    if (in_float) float_told_ = step.number;
    if (in_double) double_told_ = step.number;
    const std::string who = in_float && in_double ? "both" : in_float ? "float" : "double";
    const std::string which = words_.say("side_by_side.who." + who);
    const bool refused = (in_float && runs_.in_float.refused) || (in_double && runs_.in_double.refused);
    step.sentence =
        words_.say(refused ? "side_by_side.refused" : "side_by_side.differs", arg("which", which)) + " " +
        step.sentence;
    if (const auto at = anchor_of(step)) {
      step.delta.set.push_back({"first difference " + who, Role::rejected,
                                Label{*at, words_.say("side_by_side.mark", arg("which", which))}});
    }
    if (!first_) first_ = step.number;
  }

  void tell_numbers(std::size_t place) {
    // Where the told run has parted from the exact one, its steps tell of other things
    if (!(told_in_ == ToldIn::floats ? floats_.together(place) : doubles_.together(place))) return;
    const auto& exact = runs_.exact.steps[place];
    for (std::size_t n = 0; n < exact.numbers.size(); ++n) {
      const auto in_float = floats_.number(place, n), in_double = doubles_.number(place, n);
      if (n == 0) {
        TraceStep& step = trace_.steps.back();
        put_number(step, exact.numbers[n], in_float, in_double);
      } else {
        TraceStep step = next_fine();
        put_number(step, exact.numbers[n], in_float, in_double);
        step.sentence = sentence_of(exact.numbers[n], in_float, in_double);
        trace_.steps.push_back(std::move(step));
      }
    }
  }

  TraceStep next_fine() {
    const TraceStep& last = trace_.steps.back();
    TraceStep step;
    step.number = {last.number.step, ++fine_};
    step.level = Level::arithmetic;
    step.type = "Number";
    step.phase = last.phase;
    step.line = last.line;
    step.focus = last.focus;
    return step;
  }

  /// With the reader's own names: "a.x" has two.
  std::string named(std::string_view number) const {
    const std::size_t dot = number.find('.');
    if (dot == number.npos) return words_.symbol(number);
    return words_.symbol(number.substr(0, dot)) + "." + words_.symbol(number.substr(dot + 1));
  }

  void put_number(TraceStep& step, const std::pair<std::string, Exact>& number,
                  const std::optional<Inexact>& in_float, const std::optional<Inexact>& in_double) const {
    const auto value = [](const std::optional<Inexact>& r, Room room) {
      return r && r->in_range() ? fitted(r->value, room) : "–";
    };
    const auto error = [](const std::optional<Inexact>& r) {
      return r && r->in_range() ? ulp_text(r->error) : "–";
    };
    step.row = {named(number.first), value(in_float, float_room),
                error(in_float),     value(in_double, other_room),
                error(in_double),    fitted(to_double(number.second), other_room)};
    step.fields.push_back({"number", number.first});
    if (in_float && in_float->in_range()) {
      step.fields.push_back({"in_float", in_float->value});
      step.fields.push_back({"float_ulp", in_float->error});
    }
    if (in_double && in_double->in_range()) {
      step.fields.push_back({"in_double", in_double->value});
      step.fields.push_back({"double_ulp", in_double->error});
    }
    step.fields.push_back({"exactly", to_string(number.second)});
  }

  std::string sentence_of(const std::pair<std::string, Exact>& number, const std::optional<Inexact>& in_float,
                          const std::optional<Inexact>& in_double) const {
    const auto said = [&](const std::string& key, const std::optional<Inexact>& r, int digits) {
      if (!r) return words_.say(key + "parted");
      if (!r->in_range()) return words_.say(key + "beyond");
      if (r->error == 0) return words_.say(key + "right");
      return words_.say(key + "off", arg("value", short_number(r->value, digits)),
                        arg("ulp", ulp_text(r->error)));
    };
    return words_.say("side_by_side.number", arg("number", named(number.first)),
                      arg("exact", exact_text(number.second)),
                      arg("float", said("side_by_side.float.", in_float, 9)),
                      arg("double", said("side_by_side.double.", in_double, 17)));
  }

  /// A story and its numbers must name their steps alike, or numbers would be lost in silence.
  template <class T>
  void expect_told(const NumericRun<T>& run) const {
    for (const auto& [type, places] : places_) {
      const auto seen = seen_.find(type);
      const std::size_t told = seen == seen_.end() ? 0 : seen->second;
      if (told < places.size() && !run.steps[places[told]].numbers.empty()) {
        contract_violated(fmt::format("{}: no trace step tells the numbers of {}", trace_.topic, type));
      }
    }
  }
  void expect_all_told() const {
    if (told_in_ == ToldIn::floats) return expect_told(runs_.in_float);
    expect_told(runs_.in_double);
  }

  void sum_up() {
    trace_.method_title = words_.say("side_by_side.method", arg("method", trace_.method_title));
    const auto field = [&](const std::string& name, const std::optional<StepNumber>& at) {
      trace_.result.push_back({name, at ? text_of(*at) : std::string()});
    };
    field("float_differs_at", float_told_);
    field("double_differs_at", double_told_);
    if (first_) trace_.telling = {first_->step, 0};
  }

  Trace& trace_;
  const Wording words_;
  const NumericRuns& runs_;
  Beside<float> floats_;
  Beside<double> doubles_;
  ToldIn told_in_;
  std::map<std::string, std::vector<std::size_t>> places_;
  std::map<std::string, std::size_t> seen_;
  int fine_ = 0;
  std::optional<StepNumber> float_told_, double_told_, first_;
};

}  // namespace

void put_side_by_side(Trace& trace, const NumericRuns& runs, ToldIn told_in) {
  if (runs.exact.refused) refuse("exact", "expected input that the method takes in every arithmetic");
  if (!trace.whole()) {
    refuse("exact", "expected a run of at most {} events, found a longer one", Recording::default_most);
  }
  Retelling(trace, runs, told_in).retell();
}

Parameter exact_parameter() {
  return {.name = "exact",
          .type = ParameterType::flag,
          .default_value = "",
          .example = "",
          .help = "float, double and exact arithmetic side by side"};
}

}  // namespace gradus
