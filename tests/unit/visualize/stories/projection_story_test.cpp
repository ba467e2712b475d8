// What the stories of projections tell: numbers, hidden lines, vanishing points, the bend; and what they
// refuse.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "support/example_traces.hpp"

namespace gradus {
namespace {

using Given = std::map<std::string, std::string>;

double result(const Trace& trace, std::string_view name) {
  for (const Field& field : trace.result) {
    if (field.name != name) continue;
    if (const double* value = std::get_if<double>(&field.value)) return *value;
    return static_cast<double>(std::get<std::int64_t>(field.value));
  }
  throw std::invalid_argument("no such result");
}

const std::map<std::string, Mark>& last_marks(const Trace& trace) {
  static std::vector<std::unique_ptr<Playhead>> kept;
  kept.push_back(std::make_unique<Playhead>(trace));
  return kept.back()->at(trace.steps.size() - 1).marks();
}

/// How many strokes whose ids begin so are drawn, and how many of those are dashed.
std::pair<int, int> strokes(const std::map<std::string, Mark>& marks, std::string_view id) {
  std::pair<int, int> count{0, 0};
  for (const auto& [name, mark] : marks) {
    if (!name.starts_with(id)) continue;
    const Stroke* stroke = std::get_if<Stroke>(&mark.shape);
    if (!stroke) continue;
    ++count.first;
    count.second += stroke->dashed;
  }
  return count;
}

TEST(ProjectionStory, AStepACornerAndTheHiddenEdgesDashed) {
  const Trace box = test::trace_of("parallel", {{"solid", "box"}, {"receding", "45,0.5"}});
  EXPECT_EQ(box.last, 9);
  // Of a box seen at a slant three faces are seen: 9 edges, and 3 behind them
  EXPECT_EQ(strokes(last_marks(box), "d picture"), (std::pair{12, 3}));
  const Trace house = test::trace_of("perspective", {{"solid", "house"}});
  EXPECT_EQ(house.last, 11);
  EXPECT_EQ(result(house, "images"), 10);
  EXPECT_EQ(strokes(last_marks(house), "d picture").first, 15);
  // Straight from the front, all that is not the front's outline lies behind it
  const Trace front = test::trace_of("parallel", {{"solid", "box"}, {"method", "orthographic"}});
  EXPECT_EQ(strokes(last_marks(front), "d picture"), (std::pair{12, 8}));
}

TEST(ProjectionStory, CornersBehindTheEyeHaveNoImage) {
  const Trace trace = test::trace_of("perspective", {{"solid", "box"}, {"at", "0,0,0"}, {"turn", "0,0"}});
  EXPECT_EQ(result(trace, "images"), 4);
  EXPECT_EQ(strokes(last_marks(trace), "d picture edge").first, 0);
  EXPECT_EQ(strokes(last_marks(trace), "d picture behind").first, 4) << "the far face, seen from inside";
}

TEST(ProjectionStory, OneTwoAndThreeVanishingPoints) {
  const auto count = [](std::string turn) {
    return result(test::trace_of("perspective", {{"method", "vanishing_points"}, {"turn", turn}}),
                  "vanishing_points");
  };
  EXPECT_EQ(count("0,0"), 1);
  EXPECT_EQ(count("90,0"), 1);
  EXPECT_EQ(count("35,0"), 2);
  EXPECT_EQ(count("0,25"), 2);
  EXPECT_EQ(count("35,25"), 3);
}

TEST(ProjectionStory, TheBendIsMeasured) {
  const Given line{{"distance", "1"}, {"from", "0,0,1"}, {"to", "2,0,3"},
                   {"wall", "2.2"},   {"far", "4"},      {"samples", "1"}};
  const auto with = [&line](std::string method) {
    Given given = line;
    given["method"] = std::move(method);
    return test::trace_of("perspective", given);
  };
  const Trace bent = with("keep_z");
  EXPECT_NEAR(result(bent, "largest_error"), 0.5, 1e-15);
  EXPECT_FALSE(bent.faulty.empty());
  EXPECT_NE(bent.steps.back().sentence.find("wrong surface"), std::string::npos);
  const Trace straight = with("transformation");
  EXPECT_NEAR(result(straight, "largest_error"), 0, 1e-15);
  EXPECT_TRUE(straight.faulty.empty());
}

TEST(ProjectionStory, WhatLiesBehindTheEyeIsDividedOrNot) {
  const Given segment{{"points", "1,0,2 1,0,-2"}, {"zoom", "0"}};
  const auto with = [&segment](std::string method) {
    Given given = segment;
    given["method"] = std::move(method);
    return test::trace_of("perspective", given);
  };
  const Trace wrong = with("divide_untested"), right = with("divide_tested");
  EXPECT_FALSE(wrong.faulty.empty());
  EXPECT_TRUE(right.faulty.empty());
  EXPECT_EQ(result(wrong, "A.x"), 0.5);
  EXPECT_EQ(result(wrong, "B.x"), -0.5);
  EXPECT_EQ(result(right, "A.x"), 0.5);
  EXPECT_THROW(result(right, "B.x"), std::invalid_argument);
  // What the wrong one joins through the middle of the picture runs out of it to the right, with a head
  const auto line = [](const Trace& trace) {
    return std::get<Stroke>(last_marks(trace).at("d image line 0").shape);
  };
  const double middle = line(wrong).a.x + 0.5 * (line(wrong).b.x - line(wrong).a.x);
  EXPECT_LT(line(wrong).b.x, middle);
  EXPECT_FALSE(line(wrong).arrow);
  EXPECT_EQ(line(right).a, line(wrong).a);
  EXPECT_GT(line(right).b.x, line(right).a.x);
  EXPECT_TRUE(line(right).arrow);
}

TEST(ProjectionStory, TheWireframeScreenBesideTheRightOne) {
  const auto with = [](std::string method, std::string points) {
    return test::trace_of("perspective", {{"method", method},
                                          {"points", points},
                                          {"centre", "400,300"},
                                          {"scales", "500,500"},
                                          {"zoom", "1000"}});
  };
  const std::string points = "600,300,500 600,300,900 600,300,0 600,300,999 600,300,1001";
  const Trace wrong = with("zoom_minus_z", points), right = with("divide_tested", points);
  const double wrongs[]{600, 1400, 600, 100400, -99600};
  const double depths[]{1500, 1900, 1000, 1999, 2001};
  for (int i = 0; i < 5; ++i) {
    const std::string name = std::string(1, static_cast<char>('A' + i)) + ".x";
    EXPECT_EQ(result(wrong, name), wrongs[i]) << name;
    EXPECT_NEAR(result(right, name), 400 + 500 * 200 / depths[i], 1e-9) << name;
  }
  // Images that fly off have arrows at the border, the others dots
  const auto& marks = last_marks(wrong);
  EXPECT_TRUE(std::holds_alternative<Dot>(marks.at("e image 1").shape));
  EXPECT_TRUE(std::holds_alternative<Stroke>(marks.at("e image 3").shape));
  EXPECT_EQ(
      test::trace_of("perspective", {{"method", "divide_untested"}, {"points", "0,0,0 1,0,0"}, {"zoom", "0"}})
          .result.size(),
      0u);  // no numbers
}

TEST(ProjectionStory, TheRuleOfThePlaneBesideTheVanishingPoints) {
  const Given given{{"turn", "-45,0"}, {"direction", "1,0,1"}};
  const auto with = [&given](std::string method) {
    Given all = given;
    all["method"] = std::move(method);
    return test::trace_of("perspective", all);
  };
  const auto vanishes = [](const Trace& trace) {
    return std::get<bool>(std::ranges::find(trace.result, "direction_vanishes", &Field::name)->value);
  };
  const Trace right = with("vanishing_points"), wrong = with("parallel_by_plane");
  EXPECT_EQ(result(right, "vanishing_points"), 2);
  EXPECT_EQ(result(wrong, "vanishing_points"), 0);
  EXPECT_TRUE(vanishes(right));
  EXPECT_FALSE(vanishes(wrong));
  const TraceStep& step = *(right.steps.end() - 2);
  EXPECT_EQ(step.row.back(), "(0,\u00a00)");
  // The direction is drawn in the box: a line in the floor and one in the roof
  EXPECT_EQ(strokes(last_marks(right), "d own").first, 2);
}

TEST(ProjectionStory, UpAlongTheViewIsReplacedRefusedOrLeftToChance) {
  const Given down{{"eye", "0.4,5,0"}, {"target", "0.4,0.6,0"}, {"up", "1e-17,1,0"}};
  const auto with = [&down](std::string method) {
    Given given = down;
    given["method"] = std::move(method);
    return test::trace_of("viewing", given);
  };
  const Trace spare = with("spare_up"), chance = with("cross_products");
  EXPECT_EQ(result(spare, "m00"), 1);
  EXPECT_EQ(result(spare, "m12"), -1);
  EXPECT_EQ(result(chance, "m02"), 1);
  EXPECT_EQ(result(chance, "m10"), 1);
  EXPECT_FALSE(chance.faulty.empty());
  EXPECT_NE(chance.steps.back().sentence.find("1e-17"), std::string::npos);
  EXPECT_THROW(with("world_to_view"), ArgumentError);
}

TEST(ProjectionStory, TheNotesMatrixIsOffByTheSlant) {
  const Trace trace =
      test::trace_of("parallel", {{"method", "keep_x_and_y"}, {"receding", "45,0.5"}, {"at", "2,2,4"}});
  EXPECT_NEAR(result(trace, "largest_error"), 5.5 / 2, 1e-12);
}

TEST(ProjectionStory, StepsOfStoredDepthInTheTable) {
  const Trace trace = test::trace_of("perspective", {{"method", "depth_precision"}});
  EXPECT_NEAR(result(trace, "step_at_far"), 59604.58872345619, 1e-6);
  std::vector<Row> rows;
  for (const TraceStep& step : trace.steps) {
    if (!step.row.empty()) rows.push_back(step.row);
  }
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1], (Row{"1/z, 24 bits", "5.96·10⁻⁴", "0.0596", "596", "59605"}));
  EXPECT_EQ(trace.columns[1].name, "at 100");
}

TEST(ProjectionStory, WhatCannotBeProjectedIsRefused) {
  const auto refused = [](std::string topic, Given given, std::string parameter) {
    std::vector<Argument> arguments;
    for (const auto& [name, value] : given) arguments.push_back({name, value});
    try {
      const TopicEntry& entry = test::topic(topic);
      entry.run(arguments_of(entry, arguments), {});
    } catch (const ArgumentError& error) {
      return error.parameter == parameter;
    }
    return false;
  };
  EXPECT_TRUE(refused("parallel", {{"direction", "1,2,0"}}, "direction"));
  EXPECT_TRUE(refused("parallel", {{"direction", "1,0,1e-300"}}, "direction"));
  EXPECT_TRUE(refused("parallel", {{"receding", "45,-1"}}, "receding"));
  EXPECT_TRUE(refused("parallel", {{"method", "along"}, {"plane", "0,0,0,1"}}, "plane"));
  EXPECT_TRUE(
      refused("parallel", {{"method", "along"}, {"plane", "1,1,1,0"}, {"direction", "1,-1,0"}}, "direction"));
  EXPECT_TRUE(refused("perspective", {{"distance", "0"}}, "distance"));
  EXPECT_TRUE(refused("perspective", {{"distance", "-1"}}, "distance"));
  EXPECT_TRUE(refused("perspective", {{"method", "vanishing_points"}, {"at", "0,0,0"}}, "at"));
  EXPECT_TRUE(refused("perspective", {{"method", "divide_tested"}, {"points", "1,1,2e6"}}, "points"));
  EXPECT_TRUE(refused("perspective", {{"method", "divide_tested"}, {"scales", "0,1"}}, "scales"));
  EXPECT_TRUE(refused("perspective", {{"method", "divide_untested"}, {"zoom", "1e7"}}, "zoom"));
  EXPECT_TRUE(refused("perspective", {{"method", "divide_untested"}, {"range", "1,1"}}, "range"));
  EXPECT_TRUE(refused("viewing", {{"method", "cross_products"}, {"eye", "0.4,5,0"}, {"target", "0.4,0.6,0"}},
                      "target"))
      << "nobody gave the up that lies along the view";
  EXPECT_TRUE(refused("perspective", {{"method", "keep_z"}, {"far", "3"}}, "far"));
  EXPECT_TRUE(refused("perspective", {{"method", "keep_z"}, {"from", "0,0,1"}}, "from"));
  EXPECT_TRUE(
      refused("perspective", {{"method", "transformation"}, {"from", "1,0,4"}, {"to", "2,0,8"}}, "to"));
  for (const std::string range : {"0,10", "10,1", "1,1", "-1,5"}) {
    EXPECT_TRUE(refused("perspective", {{"method", "depth_precision"}, {"range", range}}, "range")) << range;
  }
}

}  // namespace
}  // namespace gradus
