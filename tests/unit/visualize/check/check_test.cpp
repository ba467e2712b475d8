// Others' answers: cases, and what is judged of them. Oracles: pixels by exact comparison of distances,
// decision variables by trying all of them.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/cases.hpp"
#include "check/judge.hpp"
#include "check/own_run.hpp"
#include "core/random.hpp"
#include "json/json.hpp"
#include "live/files.hpp"
#include "request/inputs.hpp"
#include "support/seed.hpp"

namespace gradus::check {
namespace {

const TopicEntry& topic_of(std::string_view name) { return *find_entry(name); }

Arguments read(const TopicEntry& topic, const GivenTexts& given) {
  live::OpenedFiles none;
  return read_inputs(topic, given, none).arguments;
}

Cases cases_of(const TopicEntry& topic, std::uint64_t seed = 1, GivenTexts fixed = {}) {
  return {topic, std::move(fixed), seed, [&topic](const GivenTexts& given) { return read(topic, given); }};
}

/// The verdict on the first answer of a file.
Judgement judged(const TopicEntry& topic, const GivenTexts& given, const std::string& file,
                 bool hints = true) {
  const Arguments arguments = read(topic, given);
  const Trace ours = topic.run(arguments, {});
  std::function<Trace(const std::string&)> other;
  if (hints) {
    other = [&](const std::string& method) {
      GivenTexts texts = given;
      texts["method"] = method;
      return topic.run(read(topic, texts), {});
    };
  }
  const OwnAnswers answers = read_answers(topic, file, "results.json");
  return judge({topic, arguments, ours, other}, answers, answers.answers.front());
}

std::string json_of(const std::vector<ivec2>& pixels) {
  std::vector<std::string> texts;
  for (const ivec2 p : pixels) texts.push_back(fmt::format("[{}, {}]", p.x, p.y));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string answer(const std::vector<ivec2>& pixels, std::string_view conventions = "{}") {
  return fmt::format(
      R"({{"conventions": {}, "answers": [{{"arguments": {{}}, "result": {{"pixels": {}}}}}]}})", conventions,
      json_of(pixels));
}

// --- All topics --------------------------------------------------------------------------------------------

TEST(CheckTest, OurOwnAnswersAreRight) {
  std::size_t count = 0;
  for (const TopicEntry* topic : catalogue()) {
    Cases cases = cases_of(*topic);
    for (const CaseKind kind : {CaseKind::easy, CaseKind::nasty}) {
      for (const Case& one : cases.of_kind(kind, 1)) {
        const std::string file = run_json(topic->run(read(*topic, one.arguments), {}));
        const Judgement judgement = judged(*topic, one.arguments, file);
        EXPECT_EQ(judgement.verdict, Verdict::right)
            << topic->name << " " << one.id << ": " << judgement.what;
        ++count;
      }
    }
  }
  EXPECT_EQ(count, 2 * catalogue().size());
}

TEST(CheckTest, AnotherNumberInAResultIsWrong) {
  for (const TopicEntry* topic : catalogue()) {
    const Trace ours = topic->run(read(*topic, {}), {});
    for (const Field& field : ours.result) {
      std::string value;
      if (const auto* whole = std::get_if<std::int64_t>(&field.value)) value = fmt::format("{}", *whole + 1);
      if (const auto* real = std::get_if<double>(&field.value))
        value = fmt::format("{}", *real * 1.01 + 0.25);
      if (value.empty()) continue;
      const std::string file =
          fmt::format(R"({{"answers": [{{"arguments": {{}}, "result": {{"{}": {}}}}}]}})", field.name, value);
      EXPECT_EQ(judged(*topic, {}, file, false).verdict, Verdict::wrong) << topic->name << " " << field.name;
      break;
    }
  }
}

TEST(CheckTest, CasesDependOnTheSeedAlone) {
  const TopicEntry& topic = topic_of("bresenham_line");
  for (const CaseKind kind : case_kinds) {
    Cases few = cases_of(topic), many = cases_of(topic), others = cases_of(topic, 2);
    const auto two = few.of_kind(kind, 2), five = many.of_kind(kind, 5), other = others.of_kind(kind, 5);
    ASSERT_EQ(five.size(), 5U) << name_of(kind);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(two[i].arguments, five[i].arguments) << five[i].id;
    EXPECT_EQ(many.find(five[3].id)->arguments, five[3].arguments);
    EXPECT_NE(other.back().arguments, five.back().arguments) << "another seed";
  }
  Cases all = cases_of(topic);
  EXPECT_FALSE(all.find("easy-0") || all.find("easy") || all.find("hard-1") || all.find("easy-51"));
}

TEST(CheckTest, WhatIsFixedStays) {
  const TopicEntry& topic = topic_of("liang_barsky");
  Cases cases = cases_of(topic, 1, {{"window", "0,0,4,4"}});
  for (const CaseKind kind : case_kinds) {
    for (const Case& one : cases.of_kind(kind, 3)) EXPECT_EQ(one.arguments.at("window"), "0,0,4,4") << one.id;
  }
}

// --- Lines -------------------------------------------------------------------------------------------------

struct OracleLine {
  ivec2 from, to;
  bool steep() const { return std::abs(to.y - from.y) > std::abs(to.x - from.x); }
  int lead() const { return steep() ? 1 : 0; }
  int length() const { return std::abs(to[lead()] - from[lead()]); }
  GivenTexts arguments() const {
    return {{"from", fmt::format("{},{}", from.x, from.y)}, {"to", fmt::format("{},{}", to.x, to.y)}};
  }
  /// Those nearest in the k-th column: one, or two.
  std::vector<ivec2> nearest(int k) const {
    if (from == to) return {from};
    const int aside = 1 - lead(), sign = to[lead()] < from[lead()] ? -1 : 1;
    std::vector<ivec2> best;
    int least = INT32_MAX;
    for (int offset = -length() - 1; offset <= length() + 1; ++offset) {
      ivec2 pixel = from;
      pixel[lead()] += sign * k;
      pixel[aside] += offset;
      // The distance times the length
      const int distance = std::abs(offset * length() - k * (to[aside] - from[aside]));
      if (distance < least) best.clear();
      if (distance <= least) best.push_back(pixel);
      least = std::min(least, distance);
    }
    return best;
  }
};

OracleLine random_line(Random& random) {
  const auto place = [&] { return static_cast<int>(random.uniform_int(-9, 9)); };
  return {{place(), place()}, {place(), place()}};
}

TEST(CheckTest, LinesByAnyChoiceOfTies) {
  const std::uint64_t seed = test::seed();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  Random random(seed);
  std::size_t tied = 0;
  const TopicEntry& topic = topic_of("bresenham_line");
  for (int i = 0; i < 80; ++i) {
    const OracleLine line = random_line(random);
    const Trace ours = topic.run(read(topic, line.arguments()), {});
    std::vector<ivec2> pixels;
    std::size_t otherwise = 0;
    for (int k = 0; k <= line.length(); ++k) {
      const auto nearest = line.nearest(k);
      pixels.push_back(nearest[static_cast<std::size_t>(random.uniform_int(0, std::ssize(nearest) - 1))]);
      otherwise += pixels.back() != ours.pixels[static_cast<std::size_t>(k)];
    }
    const Judgement judgement = judged(topic, line.arguments(), answer(pixels));
    EXPECT_EQ(judgement.verdict, otherwise == 0 ? Verdict::right : Verdict::other_tie) << json_of(pixels);
    EXPECT_EQ(judgement.ties, otherwise) << json_of(pixels);
    tied += otherwise > 0;
    const Verdict strict = judged(topic, line.arguments(), answer(pixels, R"({"ties": "ours"})")).verdict;
    EXPECT_EQ(strict, otherwise == 0 ? Verdict::right : Verdict::wrong) << json_of(pixels);
  }
  EXPECT_GT(tied, 10U);
}

TEST(CheckTest, TheFirstPixelThatIsNotNearest) {
  const std::uint64_t seed = test::seed();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  Random random(seed);
  const TopicEntry& topic = topic_of("bresenham_line");
  for (int i = 0; i < 40; ++i) {
    const OracleLine line = random_line(random);
    if (line.length() < 3) continue;
    std::vector<ivec2> pixels = topic.run(read(topic, line.arguments()), {}).pixels;
    const auto k = static_cast<std::size_t>(random.uniform_int(1, line.length()));
    pixels[k][1 - line.lead()] += 2;
    const Judgement judgement = judged(topic, line.arguments(), answer(pixels));
    EXPECT_EQ(judgement.verdict, Verdict::wrong) << json_of(pixels);
    EXPECT_EQ(judgement.step, static_cast<std::int64_t>(k)) << json_of(pixels);
    EXPECT_EQ(judgement.later, k + 1 < pixels.size() ? Follows::yes : Follows::untold)
        << judgement.later_text;
    EXPECT_EQ(judgement.wrong_cells, std::vector<ivec2>{pixels[k]});
  }
}

/// A run with a value of p of one's own, and moves turned round from a step on: what is right of it is known.
std::vector<ivec2> own_run_of(const OracleLine& line, int p, int turned_at) {
  const int lead = line.lead(), aside = 1 - lead;
  const int dx = line.length(), dy = std::abs(line.to[aside] - line.from[aside]);
  std::vector<ivec2> pixels{line.from};
  for (int k = 1; k <= dx; ++k) {
    const bool diagonal = (p >= 0) != (k == turned_at);
    ivec2 pixel = pixels.back();
    pixel[lead] += line.to[lead] < line.from[lead] ? -1 : 1;
    if (diagonal) pixel[aside] += line.to[aside] < line.from[aside] ? -1 : 1;
    pixels.push_back(pixel);
    p += diagonal ? 2 * (dy - dx) : 2 * dy;
  }
  return pixels;
}

/// Whether some value of p at pixel k gives all moves behind it, ties either way: all values are tried.
bool some_value_gives(const OracleLine& line, const std::vector<ivec2>& pixels, std::size_t k) {
  const int aside = 1 - line.lead(), dx = line.length(), dy = std::abs(line.to[aside] - line.from[aside]);
  for (int start = -8 * dx; start <= 8 * dx; ++start) {
    int p = start;
    bool good = true;
    for (std::size_t i = k + 1; i < pixels.size() && good; ++i) {
      const bool diagonal = pixels[i][aside] != pixels[i - 1][aside];
      good = diagonal ? p >= 0 : p <= 0;
      p += diagonal ? 2 * (dy - dx) : 2 * dy;
    }
    if (good) return true;
  }
  return false;
}

TEST(CheckTest, WhetherLaterPixelsFollow) {
  const std::uint64_t seed = test::seed();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  Random random(seed);
  const TopicEntry& topic = topic_of("bresenham_line");
  std::size_t follow = 0, do_not = 0;
  for (int i = 0; i < 120; ++i) {
    const OracleLine line = random_line(random);
    if (line.length() < 4) continue;
    const int wrong = static_cast<int>(random.uniform_int(-2 * line.length(), 2 * line.length()));
    const bool turned = random.uniform_int(0, 1) == 1;
    const int turn = turned ? static_cast<int>(random.uniform_int(2, line.length())) : 0;
    const std::vector<ivec2> pixels = own_run_of(line, wrong, turn);
    const Judgement judgement = judged(topic, line.arguments(), answer(pixels));
    if (judgement.verdict != Verdict::wrong || judgement.later == Follows::untold) continue;
    // The report names a step; pixel k of a line is step k
    const auto k = static_cast<std::size_t>(*judgement.step);
    const Trace ours = topic.run(read(topic, line.arguments()), {});
    std::size_t moved = k;
    while (moved < pixels.size() && pixels[moved] - ours.pixels[moved] == pixels[k] - ours.pixels[k]) ++moved;
    const bool again = std::equal(pixels.begin() + static_cast<std::ptrdiff_t>(k) + 1, pixels.end(),
                                  ours.pixels.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    const bool follows = again || moved == pixels.size() || some_value_gives(line, pixels, k);
    EXPECT_EQ(judgement.later == Follows::yes, follows) << json_of(pixels) << judgement.later_text;
    ++(follows ? follow : do_not);
  }
  EXPECT_GT(follow, 10U);
  EXPECT_GT(do_not, 2U);
}

TEST(CheckTest, StepsByTheirOwnVariable) {
  // p begins with 2 dy instead of 2 dy - dx; all moves are by its sign
  const std::string steps = R"({"answers": [{"arguments": {}, "steps": [
    {"x": 0, "y": 0, "p": 6}, {"x": 1, "y": 1, "p": -2}, {"x": 2, "y": 1, "p": 4}, {"x": 3, "y": 2, "p": -4}]}]})";
  const Judgement judgement = judged(topic_of("bresenham_line"), {}, steps);
  EXPECT_EQ(judgement.verdict, Verdict::wrong);
  EXPECT_EQ(judgement.step, 0);
  EXPECT_EQ(judgement.what, "p is 6, ours -1");
  EXPECT_EQ(judgement.later, Follows::yes) << judgement.later_text;
  std::string broken = steps;
  broken.replace(broken.find("\"p\": 4"), 6, "\"p\": 5");
  EXPECT_EQ(judged(topic_of("bresenham_line"), {}, broken).later, Follows::no);
}

// --- Others ------------------------------------------------------------------------------------------------

TEST(CheckTest, CirclesInAnyOrderAndSomePixelsAgain) {
  const TopicEntry& topic = topic_of("bresenham_circle");
  std::vector<ivec2> pixels = topic.run(read(topic, {}), {}).pixels;
  std::ranges::reverse(pixels);
  EXPECT_EQ(judged(topic, {}, answer(pixels)).verdict, Verdict::other_order);
  pixels.push_back(pixels.front());
  EXPECT_EQ(judged(topic, {}, answer(pixels)).what, "1 of its pixels more than once");
  pixels.push_back({3, 3});
  const Judgement judgement = judged(topic, {}, answer(pixels));
  EXPECT_EQ(judgement.verdict, Verdict::wrong);
  EXPECT_EQ(judgement.what, "pixel (3, 3) is none of ours");
}

TEST(CheckTest, CirclesOneStepOff) {
  const TopicEntry& topic = topic_of("bresenham_circle");
  // The update of SE forgets y, so p is wrong from the first SE on, which is step 3
  const std::string steps = R"({"answers": [{"arguments": {}, "steps": [
    {"x": 0, "y": 8, "p": -13}, {"x": 1, "y": 8, "p": -7}, {"x": 2, "y": 8, "p": 3}, {"x": 3, "y": 7, "p": 21},
    {"x": 4, "y": 6, "p": 15}]}]})";
  const Judgement judgement = judged(topic, {}, steps);
  EXPECT_EQ(judgement.step, 3);
  EXPECT_EQ(judgement.what, "p is 21, ours -11");
  EXPECT_EQ(judgement.later, Follows::yes) << judgement.later_text;
}

TEST(CheckTest, CentresOnEdgesMayBeInOrOut) {
  const TopicEntry& topic = topic_of("triangle_coverage");
  const GivenTexts given{{"triangles", "0.5,0.5 4.5,0.5 0.5,4.5"}};
  std::vector<ivec2> closed, open;
  for (int y = 0; y <= 5; ++y) {
    for (int x = 0; x <= 5; ++x) {
      if (x + y <= 4) closed.push_back({x, y});
      if (x > 0 && y > 0 && x + y < 4) open.push_back({x, y});
    }
  }
  const Judgement all = judged(topic, given, answer(closed)), none = judged(topic, given, answer(open));
  EXPECT_EQ(all.verdict, Verdict::other_tie) << all.what;
  EXPECT_EQ(all.tie_rule, "all of them in");
  EXPECT_EQ(none.verdict, Verdict::other_tie) << none.what;
  EXPECT_EQ(none.tie_rule, "all of them out");
  open.erase(std::ranges::find(open, ivec2(1, 1)));
  EXPECT_EQ(judged(topic, given, answer(open)).what, "pixel (1, 1) is missing");
}

TEST(CheckTest, PolygonsFromAnotherCornerOn) {
  const TopicEntry& topic = topic_of("sutherland_hodgman");
  const GivenTexts given{{"polygon", "-2,2 4,2 4,6 -2,6"}};
  const auto corners = [](std::string_view list) {
    return fmt::format(R"({{"answers": [{{"arguments": {{}}, "result": {{"corners": {}}}}}]}})", list);
  };
  EXPECT_NE(judged(topic, given, corners("[[4, 2], [4, 6], [0, 6], [0, 2]]")).verdict, Verdict::wrong);
  EXPECT_NE(judged(topic, given, corners("[[0, 6], [4, 6], [4, 2], [0, 2]]")).verdict, Verdict::wrong);
  EXPECT_EQ(judged(topic, given, corners("[[4, 6], [4, 2], [0, 6], [0, 2]]")).verdict, Verdict::wrong);
  EXPECT_EQ(judged(topic, given, corners("[[4, 2], [4, 6], [0, 6]]")).verdict, Verdict::wrong);
}

TEST(CheckTest, CutsOnTheirOwnSegment) {
  const TopicEntry& topic = topic_of("cohen_sutherland_2d");
  const GivenTexts given{{"line", "-3,-8,13,16"}, {"window", "0,0,10,10"}};
  // The first cut has y off by one; the second is right on the line through it, or is ours
  const auto steps = [](double x) {
    return fmt::format(R"({{"answers": [{{"arguments": {{}}, "steps": [
      {{"type": "Cut", "of_a": true, "border": "left", "x": 0, "y": -2.5}},
      {{"type": "Cut", "of_a": true, "border": "bottom", "x": {}, "y": 0}}]}}]}})",
                       x);
  };
  // From (0, -2.5) to (13, 16): x = 2.5 * 13 / 18.5
  const Judgement follows = judged(topic, given, steps(2.5 * 13 / 18.5)),
                  ours = judged(topic, given, steps(7.0 / 3));
  EXPECT_EQ(follows.step, 1);
  EXPECT_EQ(follows.later, Follows::yes) << follows.later_text;
  EXPECT_EQ(ours.later, Follows::no);
}

TEST(CheckTest, TheFactorTimesTheirOwnMatrix) {
  const TopicEntry& topic = topic_of("affine_2d");
  const GivenTexts given{{"factors", "translate 2,0; scale 3; translate 0,1"}};
  // The scaling forgot the translation: x0 is 2 instead of 6, and stays so
  const std::string steps = R"({"answers": [{"arguments": {}, "steps": [
    {"type": "Multiplied", "xx": 1, "xy": 0, "x0": 2, "yx": 0, "yy": 1, "y0": 0},
    {"type": "Multiplied", "xx": 3, "xy": 0, "x0": 2, "yx": 0, "yy": 3, "y0": 0},
    {"type": "Multiplied", "xx": 3, "xy": 0, "x0": 2, "yx": 0, "yy": 3, "y0": 1}]}]})";
  const Judgement judgement = judged(topic, given, steps);
  EXPECT_EQ(judgement.step, 2);
  EXPECT_EQ(judgement.what, "x0 is 2, ours 6");
  EXPECT_EQ(judgement.later, Follows::yes) << judgement.later_text;
}

// --- Conventions -------------------------------------------------------------------------------------------

TEST(CheckTest, RowsFromTheTop) {
  const TopicEntry& topic = topic_of("bresenham_circle");
  const GivenTexts given{{"center", "3,4"}, {"radius", "3"}};
  const Trace ours = topic.run(read(topic, given), {});
  std::vector<ivec2> in_ten_rows, in_grid;
  const Window cells = ours.grid.cells;
  for (const ivec2 p : ours.pixels) {
    in_ten_rows.push_back({p.x, 9 - p.y});
    in_grid.push_back({p.x, cells.lower.y + cells.upper.y - p.y});
  }
  EXPECT_EQ(judged(topic, given, answer(in_ten_rows, R"({"y": "down", "height": 10})")).verdict,
            Verdict::right);
  EXPECT_EQ(judged(topic, given, answer(in_grid, R"({"y": "down"})")).verdict, Verdict::right);
  EXPECT_EQ(judged(topic, given, answer(ours.pixels, R"({"y": "up"})")).verdict, Verdict::right);
  EXPECT_EQ(judged(topic, given, answer(in_ten_rows)).verdict, Verdict::wrong);
}

TEST(CheckTest, DigitsOfCodesAndRowVectors) {
  const auto codes = [](std::string_view conventions, std::string_view a, std::string_view b) {
    return fmt::format(R"({{"conventions": {}, "answers": [{{"arguments": {{}}, "steps": [
      {{"type": "Classified", "code_a": {}, "code_b": {}}}]}}]}})",
                       conventions, a, b);
  };
  const TopicEntry& clip = topic_of("cohen_sutherland_2d");
  EXPECT_EQ(judged(clip, {}, codes("{}", "5", "\"1010\"")).verdict, Verdict::right);
  // Left and below; right and above
  EXPECT_EQ(judged(clip, {}, codes(R"({"bits": "LRBT"})", "\"1010\"", "\"0101\"")).verdict, Verdict::right);
  EXPECT_EQ(judged(clip, {}, codes("{}", "\"1010\"", "\"0101\"")).what, "code_a is 10, ours 5");
  const TopicEntry& turn = topic_of("affine_2d");
  const GivenTexts given{{"factors", "rotate 90"}};
  const auto matrix = [](std::string_view conventions) {
    return fmt::format(R"({{"conventions": {}, "answers": [{{"arguments": {{}}, "steps": [
      {{"type": "Multiplied", "xx": 0, "xy": 1, "yx": -1, "yy": 0}}]}}]}})",
                       conventions);
  };
  EXPECT_EQ(judged(turn, given, matrix(R"({"vectors": "rows"})")).verdict, Verdict::right);
  const Judgement columns = judged(turn, given, matrix("{}"));
  EXPECT_EQ(columns.verdict, Verdict::wrong);
  ASSERT_EQ(columns.hints.size(), 1U);
  EXPECT_NE(columns.hints.front().find("\"vectors\": \"rows\""), std::string::npos);
}

TEST(CheckTest, HintsNameAFaultyMethod) {
  const TopicEntry& topic = topic_of("bresenham_line");
  const GivenTexts given{{"from", "2,5"}, {"to", "-3,-4"}};
  GivenTexts faulty = given;
  faulty["method"] = "first_octant";
  const Judgement judgement = judged(topic, given, answer(topic.run(read(topic, faulty), {}).pixels));
  ASSERT_FALSE(judgement.hints.empty());
  EXPECT_EQ(judgement.hints.front().substr(0, 26), "method first_octant answer");
}

TEST(CheckTest, OwnRunsHaveAStepForEachOfOurs) {
  for (const TopicEntry* topic : catalogue()) {
    const Arguments arguments = read(*topic, {});
    const Trace ours = topic->run(arguments, {});
    const OwnAnswers answers = read_answers(*topic, run_json(ours), "own.json");
    const GivenRun own = own_run({*topic, arguments, ours, {}}, answers, answers.answers.front());
    EXPECT_EQ(own.trace.last, ours.last) << topic->name;
    EXPECT_FALSE(own.alignment.parting) << topic->name;
    Playhead playhead(own.trace);
    playhead.at(own.trace.steps.size() - 1);
  }
}

}  // namespace
}  // namespace gradus::check
