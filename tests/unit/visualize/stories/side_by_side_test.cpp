// Float, double and exact arithmetic side by side: every number is told with its error, and the first
// decision that rounding changes is found.

#include "stories/side_by_side.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

using boost::multiprecision::cpp_rational;

const Value* field_of(const std::vector<Field>& fields, std::string_view name) {
  for (const Field& field : fields) {
    if (field.name == name) return &field.value;
  }
  return nullptr;
}
double number_of(const TraceStep& step, std::string_view name) {
  return std::get<double>(*field_of(step.fields, name));
}
std::string result_of(const Trace& trace, std::string_view name) {
  return std::get<std::string>(*field_of(trace.result, name));
}

/// The topics with this table, and the methods that have it.
std::vector<std::pair<std::string, std::string>> numeric_methods() {
  std::vector<std::pair<std::string, std::string>> found;
  for (const TopicEntry* topic : catalogue()) {
    const auto& parameters = topic->parameters;
    if (std::ranges::find(parameters, "exact", &Parameter::name) == parameters.end()) continue;
    for (const Method& method : topic->methods) {
      try {
        test::trace_of(topic->name, {{"method", method.name}, {"exact", "yes"}});
        found.emplace_back(topic->name, method.name);
      } catch (const ArgumentError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("expected one of the methods"));
      }
    }
  }
  return found;
}

/// |value - exact| in ulp of the exact value, by rationals.
double error_of(double value, const cpp_rational& exact, int digits) {
  const double near = exact.convert_to<double>();
  const double ulp = std::ldexp(1.0, std::ilogb(near) + 1 - digits);
  const cpp_rational off = abs(cpp_rational(value) - exact) / cpp_rational(ulp);
  return off.convert_to<double>();
}

TEST(SideBySide, EveryNumberHasItsExactValueAndItsErrors) {
  const auto methods = numeric_methods();
  EXPECT_GE(methods.size(), 16u);
  for (const auto& [topic, method] : methods) {
    SCOPED_TRACE(topic + " " + method);
    const Trace trace = test::trace_of(topic, {{"method", method}, {"exact", "yes"}});
    EXPECT_EQ(trace.columns.size(), 6u);
    int numbers = 0;
    const StepNumber* last = nullptr;
    for (const TraceStep& step : trace.steps) {
      if (last) EXPECT_LT(*last, step.number);
      last = &step.number;
      if (step.row.empty()) continue;
      ++numbers;
      ASSERT_EQ(step.row.size(), 6u);
      const cpp_rational exact(std::get<std::string>(*field_of(step.fields, "exactly")));
      if (exact == 0) continue;  // no ulp to speak of
      const double in_double = number_of(step, "in_double"), in_float = number_of(step, "in_float");
      EXPECT_DOUBLE_EQ(number_of(step, "double_ulp"), error_of(in_double, exact, 53)) << step.row[0];
      EXPECT_DOUBLE_EQ(number_of(step, "float_ulp"), error_of(in_float, exact, 24)) << step.row[0];
      EXPECT_LT(number_of(step, "double_ulp"), 1000) << step.row[0];
    }
    EXPECT_GE(numbers, 5);
  }
}

TEST(SideBySide, EveryNumberOfEveryStepIsTold) {
  // Two differences and four times t, enter and leave; then the ends
  const Trace line =
      test::trace_of("liang_barsky", {{"line", "-1,2,11,7"}, {"window", "0,0,10,10"}, {"exact", "yes"}});
  std::vector<std::string> names;
  for (const TraceStep& step : line.steps) {
    if (!step.row.empty()) names.push_back(step.row[0]);
  }
  EXPECT_THAT(names,
              testing::ElementsAre("d.x", "d.y", "t", "enter", "leave", "t", "enter", "leave", "t", "enter",
                                   "leave", "t", "enter", "leave", "a.x", "a.y", "b.x", "b.y"));
  // 1/12 in float: 1/12 = 1.0101…b / 16, its float 11184811 / 2^27
  const auto t =
      std::ranges::find_if(line.steps, [](const TraceStep& s) { return !s.row.empty() && s.row[0] == "t"; });
  EXPECT_EQ(t->row, (Row{"t", "0.0833333", "0.33", "0.083333", "0.33", "0.083333"}));
  EXPECT_EQ(std::get<std::string>(*field_of(t->fields, "exactly")), "1/12");
  EXPECT_EQ(std::next(t)->sentence,
            "enter = 1/12; float has 0.0833333358, off by 0.33 ulp, double has 0.083333333333333329, off by "
            "0.33 ulp.");
}

TEST(SideBySide, TheFirstPixelThatFloatTakesWrongIsMarked) {
  constexpr unsigned seed = 20261122;
  SCOPED_TRACE(fmt::format("seed {}", seed));
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> length(1, 60);
  int differences = 0;
  for (int i = 0; i < (test::sanitized ? 30 : 200); ++i) {
    const ivec2 to{length(random), length(random)};
    std::vector<ivec2> rounded, exact;
    bresenham_line::dda<float>({0, 0}, to, [&](ivec2 p) { rounded.push_back(p); });
    bresenham_line::dda<Exact>({0, 0}, to, [&](ivec2 p) { exact.push_back(p); });
    const auto wrong = std::ranges::mismatch(rounded, exact).in1 - rounded.begin();
    const bool differs = wrong < static_cast<std::ptrdiff_t>(rounded.size());
    const Trace trace = test::trace_of(
        "bresenham_line", {{"to", fmt::format("{},{}", to.x, to.y)}, {"method", "dda"}, {"exact", "yes"}});
    EXPECT_EQ(result_of(trace, "float_differs_at"), differs ? fmt::format("{}", wrong) : "")
        << to.x << "," << to.y;
    if (!differs) continue;
    ++differences;
    const std::string in_double = result_of(trace, "double_differs_at");
    EXPECT_EQ(trace.telling.step,
              in_double.empty() ? wrong : std::min<std::ptrdiff_t>(wrong, std::stol(in_double)));
    const TraceStep& step = trace.steps[index_of(trace, {wrong, 0})];
    EXPECT_THAT(step.sentence, testing::HasSubstr("Wrong decision in"));
    EXPECT_TRUE(std::ranges::any_of(step.delta.set,
                                    [](const Mark& m) { return m.id.starts_with("first difference"); }));
  }
  EXPECT_GE(differences, 5);
}

/// A story of two steps, each with one number.
Trace trace_of_two() {
  TraceWriter writer({});
  writer.trace().grid.cells = {{0, 0}, {3, 3}};
  for (const char* type : {"Asked", "Answered"}) {
    writer.step({}, {1, 2}, 7, [&](TraceStep& step) {
      step.type = type;
      step.sentence = "A step.";
    });
  }
  return std::move(writer).finish();
}

template <class T>
NumericRun<T> small_run(T number, int decision, int line) {
  NumericRun<T> run;
  run.steps.push_back({"Asked", 7, {{"x", number}}, {decision}});
  run.steps.push_back({"Answered", line, {{"y", number}}, {}});
  return run;
}

TEST(SideBySide, ABranchOfItsOwnEndsTheComparison) {
  const ExactScope scope;
  Trace trace = trace_of_two();
  const NumericRuns runs{small_run(1.0F, 0, 9), small_run(1.5, 1, 8), small_run(Exact(3, 2), 1, 8)};
  put_side_by_side(trace, runs, ToldIn::doubles);
  EXPECT_EQ(trace.steps[0].row, (Row{"x", "1", "4.2e+06", "1.5", "0", "1.5"}));  // half of 2^23 ulp
  EXPECT_EQ(trace.steps[1].row, (Row{"y", "–", "–", "1.5", "0", "1.5"}));
  EXPECT_EQ(result_of(trace, "float_differs_at"), "0");
  EXPECT_EQ(result_of(trace, "double_differs_at"), "");
}

TEST(SideBySide, WhereAllAgreeNothingIsMarked) {
  const ExactScope scope;
  Trace trace = trace_of_two();
  put_side_by_side(trace, {small_run(0.5F, 1, 8), small_run(0.5, 1, 8), small_run(Exact(1, 2), 1, 8)},
                   ToldIn::doubles);
  EXPECT_EQ(result_of(trace, "float_differs_at"), "");
  for (const TraceStep& step : trace.steps) EXPECT_TRUE(step.delta.set.empty());
}

TEST(SideBySide, ARunThatFloatCannotHoldIsComparedAsFarAsItWent) {
  const Trace trace =
      test::trace_of("liang_barsky", {{"line", "-1e60,0,1e60,5"}, {"window", "0,0,10,10"}, {"exact", "yes"}});
  const auto row = std::ranges::find_if(trace.steps, [](const TraceStep& s) { return !s.row.empty(); });
  ASSERT_NE(row, trace.steps.end());
  EXPECT_EQ(row->row[1], "–");
  EXPECT_NE(row->row[3], "–");
  EXPECT_EQ(result_of(trace, "float_differs_at"), "0");
  EXPECT_THAT(trace.steps[0].sentence, testing::StartsWith("No run in float"));
}

TEST(SideBySide, WhereTheToldRunHasPartedNothingIsCompared) {
  const ExactScope scope;
  Trace trace = trace_of_two();
  put_side_by_side(trace, {small_run(1.5F, 1, 8), small_run(1.5, 0, 9), small_run(Exact(3, 2), 1, 8)},
                   ToldIn::doubles);
  EXPECT_FALSE(trace.steps[0].row.empty());
  EXPECT_TRUE(trace.steps[1].row.empty());
  EXPECT_EQ(result_of(trace, "double_differs_at"), "0");
}

TEST(SideBySide, NumbersThatNoStepTellsAreAMistake) {
  const ExactScope scope;
  Trace trace = trace_of_two();
  NumericRuns runs{small_run(1.5F, 1, 8), small_run(1.5, 1, 8), small_run(Exact(3, 2), 1, 8)};
  runs.in_double.steps[1].type = "Replied";
  EXPECT_THROW(put_side_by_side(trace, runs, ToldIn::doubles), std::logic_error);
}

TEST(SideBySide, TheEndsInSpaceAreTold) {
  const Trace box = test::trace_of("liang_barsky", {{"method", "box_parametric"}, {"exact", "yes"}});
  EXPECT_EQ(std::get<std::string>(*field_of(box.steps.back().fields, "number")), "b.z");
}

TEST(SideBySide, OnPaperTheMarkStandsAtAPlaceOfTheStep) {
  const Trace corner =
      test::trace_of("liang_barsky", {{"line", "-2,7.5,6.4,18"}, {"window", "0,0,10,10"}, {"exact", "yes"}});
  EXPECT_EQ(result_of(corner, "float_differs_at"), "5");
  bool marked = false;
  for (const TraceStep& step : corner.steps) {
    for (const Mark& mark : step.delta.set) {
      if (!mark.id.starts_with("first difference")) continue;
      marked = true;
      EXPECT_NE(std::get<Label>(mark.shape).at, dvec2(0, 0));
    }
  }
  EXPECT_TRUE(marked);
}

TEST(SideBySide, NumbersFitTheirColumns) {
  for (const auto& [topic, method] : numeric_methods()) {
    const Trace trace = test::trace_of(topic, {{"method", method}, {"exact", "yes"}});
    for (const TraceStep& step : trace.steps) {
      if (step.row.empty()) continue;
      // A minus takes three bytes and one place
      const auto places = [](const std::string& text) {
        return text.size() - (text.starts_with("−") ? 2 : 0);
      };
      EXPECT_LE(places(step.row[1]), 9u) << step.row[1];
      EXPECT_LE(places(step.row[3]), 8u) << step.row[3];
      EXPECT_LE(places(step.row[5]), 8u) << step.row[5];
    }
  }
}

TEST(SideBySide, OnlyMethodsInPlainArithmeticHaveIt) {
  try {
    test::trace_of("cohen_sutherland_2d", {{"method", "correctly_rounded"}, {"exact", "yes"}});
    FAIL() << "accepted";
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.parameter, "exact");
    EXPECT_STREQ(error.what(), "expected one of the methods cut_of_a_cut with it, found correctly_rounded");
  }
}

}  // namespace
}  // namespace gradus
