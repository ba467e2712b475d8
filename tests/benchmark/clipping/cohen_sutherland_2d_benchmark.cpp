// Every way to clip a segment to a window on the same segments, beside OpenCV's clipLine and Boost.Geometry's
// clip_segment. Compare within one run: the ratios are the result, not the times. Next to each time stand the
// answer's errors against exact rationals: the worst and the root mean square in units in the last place, and
// how many of the segments it accepts or rejects wrongly.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <boost/geometry/algorithms/detail/overlay/clip_linestring.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"
#include "clipping/liang_barsky/liang_barsky.hpp"
#include "support/clip_oracle.hpp"

#ifdef GRADUS_HAS_OPENCV
#include <opencv2/imgproc.hpp>
#endif

namespace gradus {
namespace {

using Line = Segment<2, double>;

// A window of 2^20 by 2^20 pixels, corners included: OpenCV knows whole numbers only
constexpr std::int64_t side = 1 << 20;
const AxisBox<2, double> window{{0, 0}, {side - 1, side - 1}};
constexpr std::size_t count = 4096;

enum Mix : int { inside, crossing, outside, crossing_reals };

const char* name(int mix) {
  const char* const names[] = {"inside", "crossing", "outside", "crossing, not whole"};
  return names[mix];
}

/// What exact arithmetic says of a line.
struct Answer {
  bool accepted = false;
  std::array<test::Rational, 4> ends;
  std::array<double, 4>
      unit;  // in the last place of a double there, but not of one below 1: an error is then one of 2^-52
};

struct Lines {
  std::vector<Line> lines;
  std::vector<Answer> answers;
};

bool fits(const Line& line, int mix) {
  const int a = cohen_sutherland_2d::region_code(line.a, window);
  const int b = cohen_sutherland_2d::region_code(line.b, window);
  if (mix == inside) return (a | b) == 0;
  if (mix == outside) return (a & b) != 0;
  return (a & b) == 0 && (a | b) != 0;
}

const Lines& lines_of(int mix) {
  static std::array<std::optional<Lines>, 4> made;
  auto& lines = made[static_cast<std::size_t>(mix)];
  if (lines) return *lines;
  lines.emplace();
  std::mt19937_64 random(1);
  const auto coordinate = [&] {
    const double whole = static_cast<double>(random() % (3 * side)) - static_cast<double>(side);
    return mix == crossing_reals ? whole + static_cast<double>(random() >> 11) * 0x1p-53 : whole;
  };
  while (lines->lines.size() < count) {
    Line line;
    for (double* x : {&line.a.x, &line.a.y, &line.b.x, &line.b.y}) *x = coordinate();
    if (fits(line, mix)) lines->lines.push_back(line);
  }
  for (const Line& line : lines->lines) {
    Answer answer;
    if (const auto ends = test::exact_clip(line, window)) {
      answer = {true, {ends->a[0], ends->a[1], ends->b[0], ends->b[1]}, {}};
      for (std::size_t i = 0; i < 4; ++i) {
        const double near = std::abs(static_cast<double>(answer.ends[i]));
        answer.unit[i] = std::nextafter(std::max(near, 1.0), 1e300) - std::max(near, 1.0);
      }
    }
    lines->answers.push_back(answer);
  }
  return *lines;
}

/// Times `clip(lines, clipped, accepted)` over the lines of a mix, and says how far off its answers are.
template <class Clip>
void time_lines(benchmark::State& state, Clip clip) {
  const int mix = static_cast<int>(state.range(0));
  const Lines& set = lines_of(mix);
  std::vector<Line> clipped(count);
  std::vector<std::uint8_t> accepted(count);
  clip(set.lines, clipped, accepted);
  double worst = 0, squares = 0;
  int wrong = 0, compared = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Answer& answer = set.answers[i];
    if (answer.accepted != (accepted[i] != 0)) ++wrong;
    if (!answer.accepted || !accepted[i]) continue;
    const std::array<double, 4> found{clipped[i].a.x, clipped[i].a.y, clipped[i].b.x, clipped[i].b.y};
    for (std::size_t k = 0; k < 4; ++k) {
      const test::Rational off = test::Rational(found[k]) - answer.ends[k];
      const double ulp = std::abs(static_cast<double>(off)) / answer.unit[k];
      worst = std::max(worst, ulp);
      squares += ulp * ulp;
      ++compared;
    }
  }
  for (auto _ : state) {
    clip(set.lines, clipped, accepted);
    benchmark::DoNotOptimize(clipped.data());
    benchmark::DoNotOptimize(accepted.data());
    benchmark::ClobberMemory();
  }
  state.SetLabel(name(mix));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["max_ulp"] = worst;
  state.counters["rms_ulp"] = compared ? std::sqrt(squares / compared) : 0;
  state.counters["wrong"] = wrong;
}

/// The same for a method that takes one line.
template <class One>
void time_each(benchmark::State& state, One one) {
  time_lines(state, [&](const std::vector<Line>& lines, std::vector<Line>& clipped,
                        std::vector<std::uint8_t>& accepted) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<Line> line = one(lines[i]);
      if (line) clipped[i] = *line;
      accepted[i] = line.has_value();
    }
  });
}

/// Reads the lines and adds them up, in four sums: what no method can beat.
void BM_ReadingAlone(benchmark::State& state) {
  const Lines& set = lines_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    std::array<double, 4> sums{};
    for (const Line& line : set.lines) {
      sums[0] += line.a.x;
      sums[1] += line.a.y;
      sums[2] += line.b.x;
      sums[3] += line.b.y;
    }
    benchmark::DoNotOptimize(sums);
  }
  state.SetLabel(name(static_cast<int>(state.range(0))));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void BM_CohenSutherlandCutOfACut(benchmark::State& state) {
  time_each(state, [](const Line& line) { return cohen_sutherland_2d::cut_of_a_cut(line, window); });
}

void BM_CohenSutherlandCorrectlyRounded(benchmark::State& state) {
  time_each(state, [](const Line& line) { return cohen_sutherland_2d::correctly_rounded(line, window); });
}

void BM_LiangBarskyParametric(benchmark::State& state) {
  time_each(state, [](const Line& line) { return liang_barsky::parametric(line, window); });
}

void BM_LiangBarskyCorrectlyRounded(benchmark::State& state) {
  time_each(state, [](const Line& line) { return liang_barsky::correctly_rounded(line, window); });
}

void BM_Batch(benchmark::State& state) {
  time_lines(state, [](const std::vector<Line>& lines, std::vector<Line>& clipped,
                       std::vector<std::uint8_t>& accepted) {
    cohen_sutherland_2d::clip_batch(lines, window, clipped, accepted);
  });
}

void BM_BoostGeometry(benchmark::State& state) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  using Box = bg::model::box<Point>;
  const Box box(Point(window.lower.x, window.lower.y), Point(window.upper.x, window.upper.y));
  const bg::strategy::intersection::liang_barsky<Box, Point> strategy;
  time_each(state, [&](const Line& line) -> std::optional<Line> {
    Point a(line.a.x, line.a.y), b(line.b.x, line.b.y);
    bg::model::referring_segment<Point> piece(a, b);
    bool cut_a = false, cut_b = false;
    if (!strategy.clip_segment(box, piece, cut_a, cut_b)) return std::nullopt;
    return Line{{a.x(), a.y()}, {b.x(), b.y()}};
  });
}

#ifdef GRADUS_HAS_OPENCV
/// Whole numbers in, whole numbers out: its errors are those of cutting off what comes after the point.
void BM_OpenCv(benchmark::State& state) {
  const Lines& set = lines_of(static_cast<int>(state.range(0)));
  std::vector<cv::Point2l> from(2 * count), to(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Line& line = set.lines[i];
    from[2 * i] = {static_cast<std::int64_t>(line.a.x), static_cast<std::int64_t>(line.a.y)};
    from[2 * i + 1] = {static_cast<std::int64_t>(line.b.x), static_cast<std::int64_t>(line.b.y)};
  }
  const cv::Size2l size(side, side);
  bool first = true;
  time_lines(state,
             [&](const std::vector<Line>&, std::vector<Line>& clipped, std::vector<std::uint8_t>& accepted) {
               for (std::size_t i = 0; i < count; ++i) {
                 to[2 * i] = from[2 * i];
                 to[2 * i + 1] = from[2 * i + 1];
                 accepted[i] = cv::clipLine(size, to[2 * i], to[2 * i + 1]);
               }
               benchmark::DoNotOptimize(to.data());
               if (!first) return;
               first = false;
               for (std::size_t i = 0; i < count; ++i) {
                 const auto point = [](const cv::Point2l& p) {
                   return glm::dvec2(static_cast<double>(p.x), static_cast<double>(p.y));
                 };
                 clipped[i] = {point(to[2 * i]), point(to[2 * i + 1])};
               }
             });
}
BENCHMARK(BM_OpenCv)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
#endif

BENCHMARK(BM_ReadingAlone)->Arg(crossing)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BoostGeometry)->DenseRange(inside, crossing_reals)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CohenSutherlandCutOfACut)->DenseRange(inside, crossing_reals)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_LiangBarskyParametric)->DenseRange(inside, crossing_reals)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CohenSutherlandCorrectlyRounded)
    ->DenseRange(inside, crossing_reals)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_LiangBarskyCorrectlyRounded)->DenseRange(inside, crossing_reals)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Batch)->DenseRange(inside, crossing_reals)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gradus
