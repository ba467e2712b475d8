// What the story of a circle shows: which pixels, in which roles, in whose words.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "stories/topic.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

using Pixels = std::set<std::pair<int, int>>;
using Given = std::map<std::string, std::string>;

Pixels with_role(const Canvas& canvas, const Window& cells, Role role) {
  Pixels found;
  for (int y = cells.lower.y; y <= cells.upper.y; ++y) {
    for (int x = cells.lower.x; x <= cells.upper.x; ++x) {
      const auto look = canvas.at({x, y});
      if (look && look->role == role) found.emplace(x, y);
    }
  }
  return found;
}

/// The drawing after a step of a circle.
struct ShownCircle {
  Trace trace;
  Playhead playhead;

  explicit ShownCircle(const Given& given, Recording recording = {})
      : trace(test::trace_of("bresenham_circle", given, std::move(recording))), playhead(trace) {}

  const TraceStep& step(StepNumber number) { return trace.steps[index_of(trace, number)]; }
  Pixels role(StepNumber number, Role role) {
    return with_role(playhead.at(index_of(trace, number)), trace.grid.cells, role);
  }
  std::string label(StepNumber number, const std::string& id) {
    const auto& marks = playhead.at(index_of(trace, number)).marks();
    const auto found = marks.find(id);
    return found == marks.end() ? "" : std::get<Label>(found->second.shape).text;
  }
  dvec2 place_of(StepNumber number, const std::string& id) {
    return std::get<Dot>(playhead.at(index_of(trace, number)).marks().at(id).shape).at;
  }
};

TEST(CircleStory, EightPixelsAStep) {
  ShownCircle shown(Given{{"radius", "8"}});
  EXPECT_EQ(shown.trace.title, "Bresenham circle");
  EXPECT_TRUE(shown.trace.grid.y_up);
  EXPECT_EQ(shown.trace.last, 6);
  EXPECT_EQ(shown.role({0, 0}, Role::current), (Pixels{{0, 8}}));
  EXPECT_EQ(shown.role({0, 0}, Role::accepted), (Pixels{{8, 0}, {0, -8}, {-8, 0}}));
  EXPECT_EQ(shown.role({3, 1}, Role::candidate), (Pixels{{4, 7}, {4, 6}}));
  EXPECT_EQ(shown.role({4, 0}, Role::current), (Pixels{{4, 7}}));
  EXPECT_EQ(shown.role({4, 0}, Role::rejected), (Pixels{{4, 6}}));
  EXPECT_EQ(shown.role({4, 0}, Role::accepted),
            (Pixels{{7, 4}, {7, -4}, {4, -7}, {-4, -7}, {-7, -4}, {-7, 4}, {-4, 7}}));
  EXPECT_EQ(shown.role({4, 0}, Role::past).size(), 4u + 3 * 8u);
  EXPECT_EQ(shown.step({3, 1}).sentence,
            "x² + y² − r² is 1 at E and −12 at SE. The sum is p = −11 < 0, so the midpoint M lies inside "
            "the circle and E is nearer.");
  EXPECT_EQ(shown.step({4, 0}).sentence,
            "p = −11 < 0: the midpoint M lies inside the circle, so go E to (x, y) = (4, 7); p = −11 + 4·3 + "
            "6 = 7.");
  EXPECT_EQ(
      shown.step({3, 0}).sentence,
      "p = 3 > 0: the midpoint M lies outside the circle, so go SE to (x, y) = (3, 7); p = 3 + 4·(2 − 8) "
      "+ 10 = −11.");
  EXPECT_EQ(shown.label({4, 0}, "error name"), "error 0.062");
  // The midpoint that the sentence speaks of
  EXPECT_EQ(shown.label({4, 0}, "midpoint name"), "M");
  EXPECT_EQ(shown.place_of({4, 0}, "midpoint"), dvec2(4, 6.5));
  // The last step lies past the diagonal and draws nothing; the result is all
  EXPECT_TRUE(shown.role({6, 0}, Role::current).empty());
  EXPECT_EQ(shown.role({6, 0}, Role::accepted), (Pixels{{6, 5}}));
  EXPECT_EQ(shown.role({6, 1}, Role::result).size(), 44u);
  EXPECT_EQ(shown.trace.pixels.size(), 44u);
}

TEST(CircleStory, EverySumOfASentenceIsTrue) {
  // Read back from the words: before + change = after
  int sums = 0;
  for (const char* method : {"decision_parameter", "late_update", "eight_plots"}) {
    const Trace trace = test::trace_of("bresenham_circle", {{"radius", "40"}, {"method", method}});
    for (const TraceStep& step : trace.steps) {
      if (step.type != "Stepped") continue;
      std::string text = step.sentence;
      for (std::size_t at; (at = text.find("−")) != std::string::npos;) text.replace(at, 3, "-");
      for (std::size_t at; (at = text.find("·")) != std::string::npos;) text.replace(at, 2, "*");
      const std::size_t at = text.rfind("p = ");
      int before = 0, x = 0, y = 0, after = 0;
      if (std::sscanf(text.c_str() + at, "p = %d + 4*(%d - %d) + 10 = %d", &before, &x, &y, &after) == 4) {
        EXPECT_EQ(before + 4 * (x - y) + 10, after) << text;
        ++sums;
      } else if (std::sscanf(text.c_str() + at, "p = %d + 4*%d + 6 = %d", &before, &x, &after) == 3) {
        EXPECT_EQ(before + 4 * x + 6, after) << text;
        ++sums;
      }
    }
  }
  EXPECT_GT(sums, 50);
}

TEST(CircleStory, AWindowShowsOnlyItsPixels) {
  ShownCircle shown(Given{{"center", "3,-4"}, {"radius", "10"}, {"window", "0,0,14,6"}});
  Pixels expected;
  const Window window{{0, 0}, {14, 6}};
  bresenham_circle::decision_parameter({3, -4}, 10, [&](ivec2 p) {
    if (window.contains(p)) expected.emplace(p.x, p.y);
  });
  ASSERT_GT(expected.size(), 10u);
  EXPECT_EQ(shown.trace.grid.cells, window);
  EXPECT_EQ(with_role(shown.playhead.at(shown.trace.steps.size() - 1), window, Role::result), expected);
  EXPECT_EQ(shown.trace.last, static_cast<std::int64_t>(expected.size()));
  // Moves bear the names they have on the screen
  std::set<std::string> moves;
  for (const TraceStep& step : shown.trace.steps) {
    if (step.type == "Compared") moves.insert(step.read.at(5));
  }
  EXPECT_EQ(moves, (std::set<std::string>{"E", "SE", "N", "NW", "W"}));
  // Candidates never wipe out what another octant has drawn
  for (std::size_t i = 0; i < shown.trace.steps.size(); ++i) {
    std::size_t drawn = 0;
    for (const auto& [x, y] : expected) {
      const auto look = shown.playhead.at(i).at({x, y});
      drawn += look && look->role != Role::candidate && look->role != Role::rejected;
    }
    EXPECT_GE(drawn + 2, static_cast<std::size_t>(shown.trace.steps[i].number.step)) << i;
  }
}

TEST(CircleStory, TheLargestCircleIsJumpedInto) {
  const std::int64_t first = 1'000'000'000;
  ShownCircle shown(Given{{"radius", "2147483647"}}, {first, 40});
  EXPECT_EQ(shown.trace.steps.front().number.step, first);
  EXPECT_EQ(shown.trace.last, bresenham_circle::last_column(2147483647));
  EXPECT_EQ(shown.step({first + 5, 0}).key,
            fmt::format("{},{}", first + 5, bresenham_circle::height_at(2147483647, first + 5)));
  EXPECT_EQ(std::get<std::int64_t>(shown.trace.result.at(0).value), 12148001996);
}

TEST(CircleStory, TheIdealCircleIsRound) {
  for (const char* radius : {"1", "8", "1000"}) {
    const Trace trace = test::trace_of("bresenham_circle", {{"center", "5,-3"}, {"radius", radius}});
    const auto circle = std::ranges::find(trace.backdrop, "ideal circle", &Mark::id);
    ASSERT_NE(circle, trace.backdrop.end());
    const Path& path = std::get<Path>(circle->shape);
    EXPECT_TRUE(path.closed);
    const double r = std::stod(radius);
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const dvec2 a = path.points[i] - dvec2{5, -3},
                  b = path.points[(i + 1) % path.points.size()] - dvec2{5, -3};
      EXPECT_NEAR(std::hypot(a.x, a.y), r, 1e-9);
      EXPECT_NEAR(std::hypot((a.x + b.x) / 2, (a.y + b.y) / 2), r, 0.02);  // chords hug it
    }
  }
}

TEST(CircleStory, TheLateUpdateSaysSo) {
  ShownCircle shown(Given{{"radius", "5"}, {"method", "late_update"}});
  EXPECT_EQ(shown.trace.faulty, "x and y move before p is updated: the pixels leave the circle");
  EXPECT_EQ(shown.role({2, 0}, Role::accepted), (Pixels{{2, 5}}));
  EXPECT_EQ(shown.role({2, 0}, Role::current), (Pixels{{2, 4}}));
  EXPECT_EQ(shown.label({3, 0}, "error name"), "error 0.757");
  EXPECT_EQ(
      shown.step({3, 1}).sentence,
      "The method plots 32 times to draw 24 pixels; the worst of them lies 0.757 pixels from the circle.");
  EXPECT_EQ(shown.trace.telling, (StepNumber{3, 0}));
}

TEST(CircleStory, EightPlotsShowWhatIsSetAgain) {
  ShownCircle shown(Given{{"radius", "10"}, {"method", "eight_plots"}});
  EXPECT_EQ(shown.trace.faulty, "pixels on the axes, on the diagonals and past them are set again");
  // Picture: what is set twice, by a plain walk over the ring
  const Pixels axes{{-10, 0}, {0, -10}, {0, 10}, {10, 0}}, diagonals{{-7, -7}, {-7, 7}, {7, -7}, {7, 7}};
  EXPECT_EQ(shown.role({0, 0}, Role::rejected), axes);
  EXPECT_EQ(shown.role({6, 0}, Role::rejected), axes) << "they stay marked";
  Pixels both = axes;
  both.insert(diagonals.begin(), diagonals.end());
  EXPECT_EQ(shown.role({7, 1}, Role::rejected), both);
  // Table: how many of the eight come again
  EXPECT_EQ(shown.step({0, 0}).row.at(4), "4");
  EXPECT_EQ(shown.step({1, 0}).row.at(4), "0");
  EXPECT_EQ(shown.step({1, 0}).read.at(4), "4") << "the row that is completed";
  EXPECT_EQ(shown.step({7, 0}).row.at(4), "4");
  // Sentences
  EXPECT_EQ(shown.step({7, 0}).sentence,
            "p = 11 > 0: go SE to (x, y) = (7, 7); p = 11 + 4·(6 − 8) + 10 = 13. Eight plots, but 4 fall on "
            "pixels that are already set.");
  EXPECT_EQ(shown.step({7, 1}).sentence,
            "64 plots for 56 pixels: 8 of them are repeats. Blending counts such a pixel twice, and XOR "
            "erases it.");
  EXPECT_EQ(shown.trace.telling, (StepNumber{7, 0}));
  // Radius 0: one pixel, eight times
  ShownCircle point(Given{{"radius", "0"}, {"method", "eight_plots"}});
  EXPECT_EQ(point.role({0, 0}, Role::rejected), (Pixels{{0, 0}}));
  EXPECT_EQ(point.step({0, 0}).row.at(4), "7");
  EXPECT_EQ(point.step({0, 1}).sentence,
            "8 plots for 1 pixel: it is set again 7 times. Blending counts each of them, and XOR erases it.");
}

TEST(CircleStory, SpeaksInTheReadersNotationAndLanguage) {
  Recording recording;
  recording.wording = Wording(*find_language("de"), {{"p", "d"}, {"SE", "S"}, {"x", "u"}, {"r", "R"}});
  ShownCircle shown(Given{{"radius", "8"}}, recording);
  EXPECT_EQ(shown.trace.title, "Bresenham-Kreis");
  EXPECT_EQ(shown.step({2, 1}).sentence,
            "u² + y² − R² ist 9 bei E und −6 bei S. Die Summe ist d = 3 > 0: Die Mitte M liegt außerhalb "
            "des Kreises, und S ist näher.");
  EXPECT_EQ(shown.step({3, 0}).sentence,
            "d = 3 > 0: Die Mitte M liegt außerhalb des Kreises, weiter nach S zu (u, y) = (3, 7); d = 3 + "
            "4·(2 − 8) + 10 = −11.");
  EXPECT_EQ(shown.step({3, 0}).read.at(4), "d > 0");
  EXPECT_EQ(shown.step({3, 0}).read.at(5), "S");
  EXPECT_EQ(shown.label({3, 0}, "chosen name"), "S gewählt");
  EXPECT_EQ(shown.label({2, 1}, "diagonal move name"), "S");
  const auto radius = std::ranges::find(shown.trace.backdrop, "radius name", &Mark::id);
  ASSERT_NE(radius, shown.trace.backdrop.end());
  EXPECT_EQ(std::get<Text>(radius->shape).text, "R = 8");
  // The source is the source
  EXPECT_TRUE(std::ranges::any_of(shown.trace.listing, [](const SourceLine& line) {
    return line.text.find("p += 4 * (x - y) + 10;") != std::string::npos;
  }));
}

TEST(CircleStory, BothLanguagesTellEveryKindOfStep) {
  for (const Language& language : languages()) {
    Recording recording;
    recording.wording = Wording(language);
    int steps = 0;
    for (const auto& given : std::vector<Given>{{{"radius", "0"}},
                                                {{"radius", "5"}},
                                                {{"radius", "5"}, {"method", "late_update"}},
                                                {{"radius", "5"}, {"method", "eight_plots"}},
                                                {{"radius", "0"}, {"method", "eight_plots"}},
                                                {{"radius", "9"}, {"window", "0,0,20,20"}},
                                                {{"radius", "9"}, {"window", "-2,-2,2,2"}}}) {
      const Trace trace = test::trace_of("bresenham_circle", given, recording);
      for (const TraceStep& step : trace.steps) {
        EXPECT_FALSE(step.sentence.empty());
        EXPECT_EQ(step.sentence.find_first_of("{}[]"), std::string::npos) << step.sentence;
        ++steps;
      }
    }
    EXPECT_GT(steps, 45);
  }
}

TEST(CircleStory, MistakesAreNamed) {
  const auto mistake = [](const Given& given) {
    try {
      test::trace_of("bresenham_circle", given);
    } catch (const ArgumentError& error) {
      return fmt::format("{}: {}", error.parameter, error.what());
    }
    return std::string();
  };
  EXPECT_EQ(
      mistake({{"center", "2147483640,0"}, {"radius", "8"}}),
      "radius: a radius of at most 7 round 2147483640,0 without a window, for pixels are int32, found 8");
  EXPECT_EQ(mistake({{"method", "late_update"}, {"window", "0,0,9,9"}}),
            "window: method late_update takes none: it walks to every pixel");
  EXPECT_EQ(mistake({{"method", "late_update"}, {"radius", "20001"}}),
            "radius: method late_update is watched from its start, so at most 20000, found 20001");
  EXPECT_EQ(mistake({{"radius", "2147483647"}, {"window", "-2147483648,-2147483648,2147483647,2147483647"}}),
            "window: at most 1000000 pixels of the circle can be watched, this window shows 12148001996");
  EXPECT_EQ(
      mistake({{"center", "2147483640,0"}, {"radius", "8"}, {"window", "2147483600,-20,2147483647,20"}}), "");
  EXPECT_THROW(canonical(test::topic("bresenham_circle").parameters.at(1), "-1"), ArgumentError);
}

}  // namespace
}  // namespace gradus
