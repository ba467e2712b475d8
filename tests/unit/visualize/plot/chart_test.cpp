// Charts of run time against error and size: fronts, slopes, styles, and that all of a chart can be read.

#include "plot/chart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "support/sheets.hpp"
#include "theme/theme.hpp"

namespace gradus::plot {
namespace {

TEST(Chart, FrontIsWhatNoOtherBeats) {
  const std::vector<dvec2> points{{1, 9}, {2, 4}, {3, 4}, {4, 0}, {5, 0}, {2, 4}, {1, 10}};
  // Two at the same place do not beat each other
  EXPECT_EQ(front(points), (std::vector<bool>{true, true, false, true, false, true, false}));
  EXPECT_TRUE(front({}).empty());
}

TEST(Chart, FrontHasASetOfLaws) {
  Random random(1);
  std::size_t beaten = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<dvec2> points;
    for (int i = 0; i < 12; ++i) {
      const auto x = static_cast<double>(random.uniform_int(1, 6));
      points.push_back({x, static_cast<double>(random.uniform_int(0, 6))});
    }
    const std::vector<bool> kept = front(points);
    // Sorted by both, a point is kept when it is lower than all before it that differ
    std::vector<dvec2> sorted = points;
    std::ranges::sort(sorted, [](dvec2 a, dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    for (std::size_t i = 0; i < points.size(); ++i) {
      double lowest = INFINITY;
      for (const dvec2 p : sorted) {
        if (p == points[i]) break;
        lowest = std::min(lowest, p.y);
      }
      EXPECT_EQ(kept[i], points[i].y < lowest);
      beaten += !kept[i];
    }
  }
  EXPECT_GT(beaten, 1000u);
}

TEST(Chart, SlopeOfAPowerIsItsExponent) {
  for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.0, 3.0}) {
    std::vector<dvec2> points;
    for (const double x : {1.0, 10.0, 30.0, 5000.0}) points.push_back({x, 7 * std::pow(x, exponent)});
    ASSERT_TRUE(slope(points));
    EXPECT_NEAR(*slope(points), exponent, 1e-12);
  }
  // By hand: logarithms to base 10 are (0, 0), (1, 0), (2, 3); their line climbs 3/2 per step
  EXPECT_NEAR(*slope(std::vector<dvec2>{{1, 1}, {10, 1}, {100, 1000}}), 1.5, 1e-12);
}

TEST(Chart, OnePlaceHasNoSlope) {
  EXPECT_FALSE(slope({}));
  EXPECT_FALSE(slope(std::vector<dvec2>{{2, 3}}));
  EXPECT_FALSE(slope(std::vector<dvec2>{{2, 3}, {2, 5}}));
}

/// So many methods, the first one chosen, the last one faulty.
std::vector<Style> styles(std::size_t count) {
  std::vector<Kind> kinds(count, Kind::usual);
  kinds.back() = Kind::faulty;
  kinds.front() = Kind::chosen;
  return styles_of(kinds);
}

TEST(Chart, EveryMethodHasAColourOfItsOwnAndTheChosenOneStandsOut) {
  for (std::size_t count = 2; count <= 13; ++count) {
    const std::vector<Style> all = styles(count);
    std::set<std::pair<Role, bool>> colours;
    for (const Style& style : all) colours.insert({style.role, style.open});
    EXPECT_EQ(colours.size(), count);
    EXPECT_EQ(std::ranges::count(all, Role::current, &Style::role), 1);
    EXPECT_EQ(std::ranges::count(all, true, &Style::chosen), 1);
    EXPECT_TRUE(all.front().chosen && all.front().role == Role::current);
    EXPECT_EQ(std::ranges::count(all, Marker::cross, &Style::marker), 1);
    EXPECT_EQ(all.back().marker, Marker::cross);
  }
  const std::vector<Style> faulty = styles_of(std::vector<Kind>(3, Kind::faulty));
  EXPECT_NE(faulty[0].role, faulty[1].role);
  EXPECT_NE(faulty[1].role, faulty[2].role);
}

TEST(Chart, NamesMoveApartNoFartherThanTheyMust) {
  EXPECT_EQ(moved_apart(std::vector<double>{10, 50, 90}, 20, 0, 100), (std::vector<double>{10, 50, 90}));
  EXPECT_EQ(moved_apart(std::vector<double>{50, 50}, 20, 0, 100), (std::vector<double>{40, 60}));
  EXPECT_EQ(moved_apart(std::vector<double>{99, 99}, 20, 0, 100), (std::vector<double>{80, 100}));
  EXPECT_EQ(moved_apart(std::vector<double>{5, 5, 5}, 200, 0, 100), (std::vector<double>{0, 50, 100}));
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const auto some = [&] { return static_cast<double>(random.uniform_int(0, 400)); };
    std::vector<double> wanted(8);
    std::ranges::generate(wanted, some);
    std::ranges::sort(wanted);
    const auto off = [&](const std::vector<double>& places) {
      double sum = 0;
      for (std::size_t i = 0; i < places.size(); ++i) sum += std::pow(places[i] - wanted[i], 2);
      return sum;
    };
    const std::vector<double> found = moved_apart(wanted, 30, 0, 400);
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GE(found[i] - found[i - 1], 30 - 1e-9);
    EXPECT_TRUE(found.front() >= 0 && found.back() <= 400);
    // No other places that keep the distance are nearer: seven gaps of 30 leave 190 to spread
    for (int other = 0; other < 50; ++other) {
      std::vector<double> places(8);
      for (double& place : places) place = static_cast<double>(random.uniform_int(0, 190));
      std::ranges::sort(places);
      for (std::size_t i = 0; i < places.size(); ++i) places[i] += 30 * static_cast<double>(i);
      EXPECT_GE(off(places), off(found) - 1e-9);
    }
  }
}

/// Charts like those that are measured, and worse.
std::vector<Chart> charts() {
  const std::vector<Style> look = styles(10);
  Chart apart{"Segments against a window",
              "crossing · low and left is better; no method beats a ringed one in both",
              {"time a segment, in ns"},
              {"worst error, in ulp", "0"}};
  apart.dots = {{"clip_batch", {11, 0}, look[0], true},
                {"cut_of_a_cut", {18, 480}, look[1]},
                {"correctly_rounded", {62, 0.5}, look[2]},
                {"OpenCV clipLine", {55, 4e6}, look[3]},
                {"without_empty_test, 17 wrong", {9, 1e15}, look[9], true}};
  apart.advice = "Choose clip_batch: decided exactly, ends rounded once, in the least time.";
  apart.footer = "A processor with quite a long name @ 2.50 GHz, 64 cores, one used; GCC 12.2";

  Chart zeros = apart;
  zeros.dots = {{"depth_first", {50, 0}, look[1]},
                {"breadth_first", {53, 0}, look[2]},
                {"span", {5.4, 0}, look[3]},
                {"fill_rows", {1.02, 0}, look[0], true},
                {"OpenCV floodFill", {2.6, 0}, look[4]}};

  Chart close = apart;
  close.dots.clear();
  for (std::size_t i = 0; i < 6; ++i) {
    const double k = static_cast<double>(i);
    close.dots.push_back({fmt::format("method number {}", i), {20 + 0.3 * k, 1 + 0.1 * k}, look[i]});
  }

  Chart row = apart;  // ten in a row, as far apart as lines into a picture are
  row.dots.clear();
  for (std::size_t i = 0; i < 10; ++i) {
    const double k = static_cast<double>(i);
    row.dots.push_back({fmt::format("line number {}, {} wrong", i, i * i), {std::pow(1.4, k), 0.5}, look[i]});
  }

  Chart one = apart;
  one.dots = {{"alone", {3, 2}, look[0], true}};

  Chart series{"Filling an area", "time against size", {"n: side of a picture"}, {"time a run, in µs"}};
  for (std::size_t i = 0; i < 10; ++i) {
    Curve curve{fmt::format("a method of name {}, slope 2.0{}", i, i), {}, look[i]};
    for (const double n : {64.0, 256.0, 1024.0, 4096.0})
      curve.points.push_back({n, n * n * (1 + 0.01 * static_cast<double>(i))});
    series.curves.push_back(curve);
  }
  series.footer = apart.footer;

  Chart two = series;
  two.curves.resize(2);
  two.advice = apart.advice;

  Chart points = series;
  for (Curve& curve : points.curves) curve.points.resize(1);

  Chart flat = series;
  flat.curves = {{"constant, slope 0.00", {{1, 5}, {10, 5}, {100, 5}}, look[0]}};
  return {apart, zeros, close, row, one, series, two, points, flat};
}

TEST(Chart, IsLegibleWholeAndApart) {
  std::size_t texts = 0;
  for (const Chart& chart : charts()) {
    for (const dvec2 size : {dvec2(1280, 720), dvec2(960, 720), dvec2(1920, 1080), dvec2(640, 360)}) {
      SCOPED_TRACE(fmt::format("{} of {} dots on {} x {}", chart.title, chart.dots.size(), size.x, size.y));
      const Sheet sheet = sheet_of(chart, size.x, size.y);
      const std::vector<const TextShape*> all = test::texts_of(sheet);
      texts += all.size();
      for (const TextShape* text : all) EXPECT_GE(text->size, size.y / 36 * (1 - 1e-9)) << text->text;
      EXPECT_EQ(missing_glyph(sheet), std::nullopt);
      test::expect_texts_apart(sheet);
      for (const Shape& shape : sheet.shapes) {
        const Box box = test::extent_of(shape);
        EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= size.x && box.bottom() <= size.y) << shape.id;
      }
      for (const Dot& dot : chart.dots) EXPECT_TRUE(test::find_text(sheet, "name " + dot.name)) << dot.name;
      for (const Curve& curve : chart.curves)
        EXPECT_TRUE(test::find_text(sheet, "name " + curve.name)) << curve.name;
    }
  }
  EXPECT_GT(texts, 600u);
}

TEST(Chart, NamesStandOnNoMarker) {
  for (const Chart& chart : charts()) {
    const Sheet sheet = sheet_of(chart);
    for (const Shape& marker : sheet.shapes) {
      if (!marker.id.starts_with("dot ") || marker.id.ends_with(" rim")) continue;
      for (const Dot& dot : chart.dots) {
        const TextShape* name = test::find_text(sheet, "name " + dot.name);
        EXPECT_FALSE(test::overlap(name->box(), test::extent_of(marker))) << dot.name << " on " << marker.id;
      }
    }
  }
}

TEST(Chart, IsReadInEveryTheme) {
  for (const Theme& theme : themes()) {
    for (const Chart& chart : charts()) {
      const Sheet sheet = sheet_of(chart);
      for (const TextShape* text : test::texts_of(sheet)) {
        EXPECT_GE(contrast(color_of(text->paint, theme), theme[Tone::paper]), 4.5)
            << theme.name << text->text;
      }
      for (const Dot& dot : chart.dots)
        EXPECT_GE(contrast(theme[dot.style.role].mark, theme[Tone::paper]), 3) << theme.name << dot.name;
    }
  }
}

TEST(Chart, AxesNameAtLeastTwoPowersOfTen) {
  for (const Chart& chart : charts()) {
    const Sheet sheet = sheet_of(chart);
    const auto powers = [&](const std::string& axis) {
      return std::ranges::count_if(sheet.shapes, [&](const Shape& shape) {
        const TextShape* text = std::get_if<TextShape>(&shape.what);
        return text && shape.id.starts_with(axis) && text->text.starts_with("10");
      });
    };
    const bool errors = std::ranges::any_of(chart.dots, [](const Dot& dot) { return dot.at.y > 0; });
    EXPECT_GE(powers("x "), 2) << chart.title;
    EXPECT_GE(powers("y "), errors || chart.dots.empty() ? 2 : 0) << chart.title;
  }
  Chart small = charts()[4];
  small.dots[0].at.y = 2e-3;
  EXPECT_EQ(test::find_text(sheet_of(small), "y -3")->text, "10⁻³");
}

TEST(Chart, FasterIsFartherLeftAndWorseIsHigher) {
  const Sheet sheet = sheet_of(charts()[0]);
  const auto centre = [&](const char* id) {
    for (const Shape& shape : sheet.shapes) {
      const Box box = test::extent_of(shape);
      if (shape.id == id) return dvec2(box.x + box.width / 2, box.y + box.height / 2);
    }
    ADD_FAILURE() << id;
    return dvec2(0);
  };
  EXPECT_LT(centre("dot clip_batch").x, centre("dot cut_of_a_cut").x);
  EXPECT_LT(centre("dot cut_of_a_cut").x, centre("dot correctly_rounded").x);
  EXPECT_LT(centre("dot cut_of_a_cut").y, centre("dot correctly_rounded").y);
  EXPECT_LT(centre("dot correctly_rounded").y, centre("dot clip_batch").y);
}

TEST(Chart, RefusesWhatItCanNotDraw) {
  Chart chart = charts()[4];
  chart.dots[0].at = {0, 1};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.dots[0].at = {1, -1};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.dots[0].at = {1, INFINITY};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.dots.clear();
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.curves = {{"nothing takes no time", {{1, 0}}}};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
}

}  // namespace
}  // namespace gradus::plot
