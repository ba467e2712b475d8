// Charts of run time against error and size: fronts, slopes, and that all of a chart can be read.

#include "plot/chart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "support/sheets.hpp"

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

/// Charts like those that are measured, and worse.
std::vector<Chart> charts() {
  Chart apart{"Segments against a window",
              "crossing · worst error against time per segment",
              {"ns per segment"},
              {"worst error in ulp", "0"}};
  apart.dots = {{"cut_of_a_cut", {18, 480}, Role::current, true},
                {"correctly_rounded", {62, 0.5}, Role::accepted, true},
                {"clip_batch", {11, 0}, Role::candidate, true},
                {"OpenCV clipLine", {55, 4e6}, Role::past},
                {"without_empty_test, 17 wrong", {9, 1e15}, Role::rejected}};
  apart.legend = {{Role::current, "taught"}, {Role::past, "peer"}, {Role::rejected, "faulty"}};
  apart.footer = "A processor with quite a long name @ 2.50 GHz, 64 cores, one used; GCC 12.2";

  Chart zeros = apart;
  zeros.dots = {{"depth_first", {50, 0}, Role::current},
                {"breadth_first", {53, 0}, Role::current},
                {"span", {5.4, 0}, Role::accepted},
                {"fill_rows", {1.02, 0}, Role::candidate, true},
                {"OpenCV floodFill", {2.6, 0}, Role::past}};

  Chart close = apart;
  close.dots.clear();
  for (int i = 0; i < 6; ++i) {
    close.dots.push_back({fmt::format("method number {}", i), {20 + 0.3 * i, 1 + 0.1 * i}, Role::current});
  }

  Chart one = apart;
  one.dots = {{"alone", {3, 2}, Role::current, true}};

  Chart series{"Filling an area", "time against size", {"n: side of a picture"}, {"microseconds per run"}};
  for (int i = 0; i < 6; ++i) {
    Curve curve{fmt::format("a method of name {}, slope 2.0{}", i, i), {}, Role::current};
    for (const double n : {64.0, 256.0, 1024.0, 4096.0}) curve.points.push_back({n, n * n * (1 + 0.01 * i)});
    series.curves.push_back(curve);
  }
  series.legend = apart.legend;
  series.footer = apart.footer;

  Chart flat = series;
  flat.curves = {{"constant, slope 0.00", {{1, 5}, {10, 5}, {100, 5}}, Role::accepted}};
  return {apart, zeros, close, one, series, flat};
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
  EXPECT_GT(texts, 300u);
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
  Chart chart = charts()[3];
  chart.dots[0].at = {0, 1};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.dots[0].at = {1, -1};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.dots[0].at = {1, INFINITY};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.dots.clear();
  EXPECT_THROW(sheet_of(chart), ContractViolation);
  chart.curves = {{"nothing takes no time", {{1, 0}}, Role::current}};
  EXPECT_THROW(sheet_of(chart), ContractViolation);
}

}  // namespace
}  // namespace gradus::plot
