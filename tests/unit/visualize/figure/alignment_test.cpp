// Steps of two runs, set side by side.

#include "figure/alignment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/example_traces.hpp"

namespace gradus {
namespace {

TraceStep told(std::int64_t number, std::string key, std::string branch = "", std::int64_t p = 0) {
  TraceStep step;
  step.number = {number, 0};
  step.type = "Stepped";
  step.key = std::move(key);
  step.fields = {{"p", p}};
  if (!branch.empty()) step.decision = Decision{"?", {"yes"}, 0, branch};
  return step;
}
Trace run_of(std::vector<TraceStep> steps) {
  Trace trace;
  trace.last = steps.back().number.step;
  trace.steps = std::move(steps);
  return trace;
}
std::vector<std::string> text_of(const Alignment& alignment) {
  std::vector<std::string> texts;
  for (const StepPair& pair : alignment.pairs)
    texts.push_back(gradus::text_of(pair.a) + " " + gradus::text_of(pair.b));
  return texts;
}

TEST(Alignment, OfARunWithItselfIsWholeAndDoesNotPart) {
  for (const char* topic : {"bresenham_line", "sutherland_hodgman", "cohen_sutherland_2d", "flood_fill"}) {
    const Trace trace = test::trace_of(topic);
    const Alignment alignment = align(trace, trace);
    EXPECT_FALSE(alignment.parting) << topic;
    for (const StepPair& pair : alignment.pairs) EXPECT_EQ(pair.a, pair.b) << topic;
  }
}

TEST(Alignment, SetsStepsAboutTheSameSideBySide) {
  const Trace a = run_of({told(0, "start"), told(1, "left"), told(2, "right"), told(3, "top")});
  const Trace b = run_of({told(0, "start"), told(1, "right"), told(2, "bottom"), told(3, "top")});
  const Alignment alignment = align(a, b);
  EXPECT_THAT(text_of(alignment), testing::ElementsAre("0 0", "1 0", "2 1", "2 2", "3 3"));
}

TEST(Alignment, SetsStepsOfOtherKindsSideBySideAsTheyCome) {
  const Trace a = run_of({told(0, "a"), told(1, "b"), told(2, "c")});
  const Trace b = run_of({told(0, "u"), told(1, "v"), told(2, "w"), told(3, "x")});
  EXPECT_THAT(text_of(align(a, b)), testing::ElementsAre("0 0", "1 1", "2 2", "2 3"));
  EXPECT_EQ(align(a, b).parting, 1u);
}

TEST(Alignment, PartsAtTheFirstOtherValueOrBranchBehindTheInput) {
  const Trace a = run_of({told(0, "s", "", 1), told(1, "x", "E", 2), told(2, "y", "E", 3)});
  EXPECT_EQ(align(a, run_of({told(0, "s", "", 9), told(1, "x", "E", 2), told(2, "y", "E", 4)})).parting, 2u);
  EXPECT_EQ(align(a, run_of({told(0, "s", "", 9), told(1, "x", "NE", 2), told(2, "y", "E", 4)})).parting, 1u);
  EXPECT_EQ(align(a, run_of({told(0, "s", "", 9), told(1, "x", "E", 2), told(2, "y", "E", 3)})).parting,
            std::nullopt)
      << "another input is no parting";
}

TEST(Alignment, WhatOnlyOneKindOfStepAsksIsNoParting) {
  TraceStep asked = told(1, "first", "yes"), done = told(1, "first");
  asked.type = "Compared";
  const Trace a = run_of({told(0, "s"), asked, told(2, "second", "", 1)});
  EXPECT_EQ(align(a, run_of({told(0, "s"), done, told(2, "second", "", 1)})).parting, std::nullopt);
  EXPECT_EQ(align(a, run_of({told(0, "s"), done, told(2, "second", "", 2)})).parting, 2u);
}

TEST(Alignment, NeverGoesBackAndHasEveryWholeStep) {
  const std::vector<std::pair<Trace, Trace>> pairs = [] {
    std::vector<std::pair<Trace, Trace>> made;
    const auto add = [&made](std::string_view a, std::map<std::string, std::string> of_a, std::string_view b,
                             std::map<std::string, std::string> of_b) {
      made.emplace_back(test::trace_of(a, of_a), test::trace_of(b, of_b));
    };
    add("bresenham_line", {{"to", "3,9"}}, "bresenham_line", {{"to", "3,9"}, {"method", "first_octant"}});
    add("cohen_sutherland_2d", {}, "liang_barsky", {});
    add("sutherland_hodgman", {}, "sutherland_hodgman", {{"method", "entering_not_cut"}});
    add("flood_fill", {{"method", "depth_first"}}, "flood_fill", {{"method", "breadth_first"}});
    return made;
  }();
  for (const auto& [a, b] : pairs) {
    const Alignment alignment = align(a, b);
    std::set<StepNumber> of_a, of_b;
    StepPair before;
    for (const StepPair& pair : alignment.pairs) {
      EXPECT_LE(before.a, pair.a);
      EXPECT_LE(before.b, pair.b);
      before = pair;
      of_a.insert(pair.a);
      of_b.insert(pair.b);
    }
    EXPECT_EQ(std::ssize(of_a), a.last + 1) << a.topic;
    EXPECT_EQ(std::ssize(of_b), b.last + 1) << b.topic;
    EXPECT_EQ(pair_with(alignment, {a.last, 0}).b, (StepNumber{b.last, 0}));
    EXPECT_TRUE(alignment.parting) << a.topic;
  }
}

}  // namespace
}  // namespace gradus
