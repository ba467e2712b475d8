// What `gradus bench` says of what it measured: which methods are the best, the table, the JSON, the charts.

#include "benchmark/report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "core/contract.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

Result result(std::string method, Standing standing, Workload workload, double nanoseconds,
              std::optional<Error> error) {
  Result result;
  result.of = {std::move(method), standing, std::move(workload), 100};
  result.of.error = error;
  result.nanoseconds = nanoseconds;
  result.cpu_nanoseconds = nanoseconds / 2;
  result.spread = 0.25;
  result.iterations = 3;
  result.repetitions = 5;
  return result;
}

const Subject subject{.topic = "a_topic",
                      .title = "Things done",
                      .item = "thing",
                      .unit = "ulp",
                      .measure = "things",
                      .telling = "mixed",
                      .cases = nullptr,
                      .choice = {"slow and right", "it is right"}};

Findings findings() {
  return {&subject,
          {result("slow and right", Standing::robust, {"mixed"}, 40, Error{0, 0, 0}),
           result("fast and wrong", Standing::faulty, {"mixed"}, 10, Error{8, 2, 3}),
           result("slower and wrong", Standing::taught, {"mixed"}, 20, Error{8, 2, 3}),
           result("slow and right", Standing::robust, {"10 things", 10}, 40, std::nullopt),
           result("slow and right", Standing::robust, {"100 things", 100}, 400, std::nullopt)}};
}

TEST(Report, ParetoOptimalIsWhatNoOtherBeatsInAll) {
  Random random(1);
  std::size_t kept_count = 0, beaten = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Result> results;
    for (int i = 0; i < 10; ++i) {
      const auto some = [&] { return static_cast<double>(random.uniform_int(1, 4)); };
      const double error = some(), time = some();
      const auto wrong = random.uniform_int(0, 2);
      results.push_back(result("m", Standing::taught, {random.uniform_int(0, 1) ? "a" : "b"}, time,
                               Error{error, error, static_cast<std::int64_t>(wrong)}));
    }
    const std::vector<bool> kept = pareto_optimal(results);
    for (std::size_t i = 0; i < results.size(); ++i) {
      // By the differences' signs: somebody is nowhere worse and somewhere better
      bool is_beaten = false;
      for (const Result& other : results) {
        if (other.of.workload.name != results[i].of.workload.name) continue;
        const double less[] = {results[i].nanoseconds - other.nanoseconds,
                               results[i].of.error->max - other.of.error->max,
                               static_cast<double>(results[i].of.error->wrong - other.of.error->wrong)};
        is_beaten |= *std::ranges::min_element(less) >= 0 && *std::ranges::max_element(less) > 0;
      }
      EXPECT_EQ(kept[i], !is_beaten);
      (is_beaten ? beaten : kept_count)++;
    }
  }
  EXPECT_GT(kept_count, 200u);
  EXPECT_GT(beaten, 200u);
}

TEST(Report, TableMarksTheBestAndSortsByTime) {
  const std::string table = table_of(findings());
  const auto at = [&](const char* text) {
    EXPECT_NE(table.find(text), std::string::npos) << text << " in\n" << table;
    return table.find(text);
  };
  EXPECT_LT(at("* fast and wrong"), at("  slower and wrong"));
  EXPECT_LT(at("  slower and wrong"), at("* slow and right"));
  EXPECT_LT(at("* slow and right"), at("10 things"));
  at("25%");
  at("max ulp");
}

TEST(Report, ColumnsStandBelowOneAnotherWhateverTheNamesAre) {
  Findings long_names = findings();
  for (Result& result : long_names.results) result.of.workload.name += std::string(30, 'x');
  const std::string table = table_of(long_names);
  std::set<std::size_t> heads, units;
  for (std::size_t begin = 0; begin < table.size(); begin = table.find('\n', begin) + 1) {
    const std::string line = table.substr(begin, table.find('\n', begin) - begin);
    if (line.ends_with("wrong")) heads.insert(line.find(" ns ") + 3);
    if (line.find('%') != std::string::npos) units.insert(line.find('%') + 1);
  }
  EXPECT_EQ(heads.size(), 1u) << table;
  EXPECT_EQ(units.size(), 1u) << table;
}

TEST(Report, JsonHasTheLayoutOfGoogleBenchmark) {
  const std::vector<Findings> all{findings()};
  const nlohmann::json json = nlohmann::json::parse(json_of(all));
  EXPECT_TRUE(json.at("context").contains("num_cpus"));
  const nlohmann::json& runs = json.at("benchmarks");
  ASSERT_EQ(runs.size(), 5u);
  const nlohmann::json& fast = runs[1];
  EXPECT_EQ(fast.at("run_name"), "a_topic/mixed/fast and wrong");
  EXPECT_TRUE(fast.at("name").get<std::string>().starts_with("a_topic/mixed/fast and wrong"));
  EXPECT_EQ(fast.at("time_unit"), "ns");
  EXPECT_NEAR(fast.at("real_time").get<double>(), 10, 1e-9);
  EXPECT_NEAR(fast.at("cpu_time").get<double>(), 5, 1e-9);
  EXPECT_EQ(fast.at("error_max"), 8);
  EXPECT_EQ(fast.at("error_rms"), 2);
  EXPECT_EQ(fast.at("error_wrong"), 3);
  EXPECT_EQ(fast.at("label"), "faulty");
  // Nothing is said of errors where there is no oracle
  EXPECT_FALSE(runs[3].contains("error_max"));
  EXPECT_EQ(runs[3].at("size"), 10);
}

TEST(Report, ErrorChartShowsTheTellingWorkload) {
  const auto chart = error_chart(findings());
  ASSERT_TRUE(chart);
  ASSERT_EQ(chart->dots.size(), 3u);
  EXPECT_EQ(chart->dots[1].name, "fast and wrong, 3 wrong");
  EXPECT_EQ(chart->dots[1].at, dvec2(10, 8));
  EXPECT_TRUE(chart->dots[0].on_front && chart->dots[1].on_front);
  EXPECT_FALSE(chart->dots[2].on_front);
  EXPECT_EQ(chart->x.label, "time a thing, in ns");
  EXPECT_EQ(chart->y.label, "worst error, in ulp");
  Findings without = findings();
  without.results.erase(without.results.begin(), without.results.begin() + 3);
  EXPECT_FALSE(error_chart(without));
}

TEST(Report, SizeChartShowsTheSeriesWithItsSlope) {
  const auto chart = size_chart(findings());
  ASSERT_TRUE(chart);
  ASSERT_EQ(chart->curves.size(), 1u);
  // 100 items per run: 4 and 40 microseconds
  EXPECT_EQ(chart->curves[0].points, (std::vector<dvec2>{{10, 4}, {100, 40}}));
  EXPECT_EQ(chart->curves[0].name, "slow and right, slope 1.00");
  Findings without = findings();
  without.results.resize(3);
  EXPECT_FALSE(size_chart(without));
}

TEST(Report, ChartsMarkTheMethodToChooseAndKeepItsStyle) {
  const auto errors = error_chart(findings()), sizes = size_chart(findings());
  EXPECT_EQ(errors->advice, "Choose slow and right: it is right.");
  EXPECT_EQ(sizes->advice, errors->advice);
  EXPECT_TRUE(errors->dots[0].style.chosen && sizes->curves[0].style.chosen);
  EXPECT_EQ(sizes->curves[0].style.role, errors->dots[0].style.role);
  EXPECT_EQ(errors->dots[1].style.marker, plot::Marker::cross);
  Subject other = subject;
  other.choice.method = "nobody's";
  Findings wrong = findings();
  wrong.subject = &other;
  EXPECT_THROW(error_chart(wrong), ContractViolation);
  other.choice = {"slow and right", std::string(200, 'w')};  // no slide has room for it
  EXPECT_THROW(error_chart(wrong), ContractViolation);
}

TEST(Report, WhereNothingButDecisionsCanBeWrongTheyAreCounted) {
  Subject sides = subject;
  sides.unit = "wrong sides";
  Findings counted = findings();
  counted.subject = &sides;
  for (Result& result : counted.results) {
    if (result.of.error) result.of.error->max = 0;
  }
  const auto chart = error_chart(counted);
  EXPECT_EQ(chart->y.label, "number of wrong sides");
  EXPECT_EQ(chart->dots[1].name, "fast and wrong");
  EXPECT_EQ(chart->dots[1].at, dvec2(10, 3));
  EXPECT_EQ(chart->dots[0].at, dvec2(40, 0));
}

TEST(Report, AMethodWithANumberIsOneCurve) {
  Subject sampled = subject;
  sampled.choice = {"samples", "the more the better"};
  Findings found{&sampled, {}};
  for (const int n : {16, 4, 64}) {
    found.results.push_back(
        result(fmt::format("samples {}", n), Standing::taught, {"mixed"}, n, Error{1.0 / n, 0, 0}));
  }
  found.results.push_back(result("levels 2", Standing::robust, {"mixed"}, 5, Error{1, 0, 0}));
  const auto chart = error_chart(found);
  ASSERT_EQ(chart->curves.size(), 1u);  // a number of its own makes no family
  EXPECT_EQ(chart->curves[0].points, (std::vector<dvec2>{{4, 1.0 / 4}, {16, 1.0 / 16}, {64, 1.0 / 64}}));
  std::vector<std::string> names;
  for (const plot::Dot& dot : chart->dots) names.push_back(dot.name);
  EXPECT_EQ(names, (std::vector<std::string>{"16", "4", "samples 64", "levels 2"}));
  EXPECT_TRUE(chart->dots[0].style.chosen && chart->dots[2].style.chosen && !chart->dots[3].style.chosen);
}

TEST(Report, FallingTimesHaveANegativeSlope) {
  Findings falling = findings();
  falling.results[4].nanoseconds = 4;
  EXPECT_EQ(size_chart(falling)->curves[0].name, "slow and right, slope −1.00");
}

TEST(Report, WhatIsSavedIsReadAgain) {
  const Subject duelling{.topic = "a_drawer", .title = "A picture", .item = "picture"};
  Findings duels{&duelling, {}};
  duels.peer = "somebody 1.0";
  duels.duels = {{"cubes, Phong", 3, 12.0, 7, 42}, {"cubes, Gouraud", 5, std::nullopt}};
  const std::vector<Findings> all{findings(), duels};
  const std::vector<Subject> subjects{subject, duelling};
  const std::vector<Findings> again = findings_in(json_of(all), subjects);
  ASSERT_EQ(again.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(table_of(again[i]), table_of(all[i]));
  const auto errors = error_chart(again[0]), sizes = size_chart(again[0]);
  ASSERT_TRUE(errors && sizes);
  EXPECT_NEAR(errors->dots[1].at.x, 10, 1e-12);
  EXPECT_EQ(errors->dots[1].at.y, 8);
  ASSERT_EQ(sizes->curves[0].points.size(), 2u);
  EXPECT_NEAR(sizes->curves[0].points[1].y, 40, 1e-12);
  EXPECT_EQ(errors->footer, machine());
  for (const char* other : {"", "{", "{}", R"({"context": {"machine": "m"}, "benchmarks": [{}]})",
                            R"({"context": {"machine": "m"}, "benchmarks": [{"run_name": "a/b/c"}]})"}) {
    EXPECT_THROW(findings_in(other, subjects), std::invalid_argument) << other;
  }
}

TEST(Report, RefinementChartShowsWhatSmallerErrorsTake) {
  Findings finer = findings();
  EXPECT_FALSE(refinement_chart(finer));  // its series promises nothing of errors
  Subject refined = *finer.subject;
  refined.refined = true;
  finer.subject = &refined;
  for (Result& result : finer.results) result.of.error = Error{.max = 1 / (1 + result.of.workload.size)};
  const auto chart = refinement_chart(finer);
  ASSERT_TRUE(chart);
  ASSERT_EQ(chart->curves.size(), 1u);
  EXPECT_EQ(chart->curves[0].points, (std::vector<dvec2>{{40, 1.0 / 11}, {400, 1.0 / 101}}));
  // Named once, at its end
  ASSERT_EQ(chart->dots.size(), 1u);
  EXPECT_EQ(chart->dots[0].name, "slow and right");
  EXPECT_EQ(chart->dots[0].at, chart->curves[0].points.back());
}

TEST(Report, ErrorsAddUp) {
  Error::Sum sum;
  for (const double off : {3.0, 4.0, 0.0, 0.0}) sum.add(off);
  sum.wrong_decision();
  EXPECT_EQ(sum.error().max, 4);
  EXPECT_EQ(sum.error().rms, 2.5);
  EXPECT_EQ(sum.error().wrong, 1);
  EXPECT_EQ(Error::Sum().error().rms, 0);
}

TEST(Report, DuelsTellBothTimesTheirRatioAndHowPicturesDiffer) {
  const Subject duelling{.topic = "a_drawer", .title = "A picture", .item = "picture"};
  Findings found{&duelling, {}};
  found.peer = "somebody 1.0";
  found.duels = {{"cubes, Phong", 3, 12.0, 7, 42}, {"cubes, Gouraud", 5, std::nullopt}};
  const std::vector<Findings> all{found};
  const nlohmann::json runs = nlohmann::json::parse(json_of(all)).at("benchmarks");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].at("run_name"), "a_drawer/cubes, Phong");
  EXPECT_EQ(runs[0].at("time_unit"), "ms");
  EXPECT_NEAR(runs[0].at("real_time").get<double>(), 3, 1e-9);
  EXPECT_EQ(runs[0].at("ms"), 3);
  EXPECT_EQ(runs[0].at("peer_ms"), 12);
  EXPECT_EQ(runs[0].at("ratio"), 0.25);
  EXPECT_EQ(runs[0].at("max_pixel_difference"), 7);
  EXPECT_EQ(runs[0].at("pixels_off"), 42);
  const std::string table = table_of(found);
  EXPECT_NE(table.find("beside somebody 1.0"), std::string::npos) << table;
  EXPECT_NE(table.find("3.00     12.00   0.25        7       42"), std::string::npos) << table;
}

TEST(Report, WithoutThePeerThereIsNoRatio) {
  const Subject duelling{.topic = "a_drawer", .title = "A picture", .item = "picture"};
  Findings found{&duelling, {}};
  found.duels = {{"cubes, Gouraud", 5, std::nullopt}};
  const std::vector<Findings> all{found};
  const nlohmann::json run = nlohmann::json::parse(json_of(all)).at("benchmarks").at(0);
  EXPECT_EQ(run.at("ms"), 5);
  for (const char* of_both : {"peer_ms", "ratio", "max_pixel_difference", "pixels_off"})
    EXPECT_FALSE(run.contains(of_both)) << of_both;
  const std::string table = table_of(found);
  EXPECT_NE(table.find("the peer is not there"), std::string::npos) << table;
  EXPECT_TRUE(table.ends_with(" 5.00\n")) << table;
}

TEST(Measure, RunsAreTimedAndPreparationIsNot) {
  using namespace std::chrono_literals;
  std::size_t prepared = 0, ran = 0, told = 0;
  Case slow{"slow", Standing::taught, {"w"}, 2};
  slow.prepare = [&] {
    ++prepared;
    std::this_thread::sleep_for(20ms);
  };
  slow.run = [&] {
    EXPECT_GT(prepared, ran);  // a fresh canvas for each run
    ++ran;
    std::this_thread::sleep_for(2ms);
  };
  Case quick{"quick", Standing::taught, {"w"}};
  quick.run = [] {};
  const std::vector<Result> results = measure({slow, quick}, {3, 0.004}, [&] { ++told; });
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(told, 6u);
  EXPECT_EQ(prepared, ran);
  // 2 ms per run are 1 ms per item; preparing would be 10 more
  EXPECT_GE(results[0].nanoseconds, 0.9e6);
  EXPECT_LT(results[0].nanoseconds, 8e6);
  EXPECT_LT(results[1].nanoseconds, results[0].nanoseconds);
}

TEST(Measure, PreparationDoesNotMakeARepetitionEndless) {
  using namespace std::chrono_literals;
  Case quick{"quick", Standing::taught, {"w"}};
  quick.prepare = [] { std::this_thread::sleep_for(1ms); };
  quick.run = [] {};
  // Alone, so many runs would be a hundred thousand; each is prepared for 1 ms, of the 40 there are
  const std::vector<Result> results = measure({quick}, {3, 0.01}, [] {});
  EXPECT_GE(results[0].iterations, 1);
  EXPECT_LE(results[0].iterations, 40);
}

}  // namespace
}  // namespace gradus::bench
