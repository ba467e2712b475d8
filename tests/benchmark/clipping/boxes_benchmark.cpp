// Every way to clip a segment to a box, and to the view volume, on the same segments. Compare within one run:
// the ratios are the result, not the times. Next to each time stand the answer's errors against exact
// rationals: the worst in units in the last place, and how many segments are accepted or rejected wrongly.
// OpenCV and Boost.Geometry clip segments in the plane alone, so there is no rival here.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "core/random.hpp"
#include "support/clip_oracle.hpp"

namespace gradus {
namespace {

namespace codes = cohen_sutherland_3d;
using Space = Segment<3, double>;
using Homogeneous = Segment<4, double>;

const AxisBox<3, double> box{{0, 0, 0}, {1000, 1000, 1000}};
constexpr std::size_t count = 4096;

enum Mix : int { inside, crossing, outside };

const char* name(int mix) {
  const char* const names[] = {"inside", "crossing", "outside"};
  return names[mix];
}

/// The same segments for the box, and moved and scaled into the view volume (w from 0.5 to 1.5).
struct Lines {
  std::vector<Space> space;
  std::vector<Homogeneous> homogeneous;
};

bool fits(int a, int b, int mix) {
  if (mix == inside) return (a | b) == 0;
  if (mix == outside) return (a & b) != 0;
  return (a & b) == 0 && (a | b) != 0;
}

const Lines& lines_of(int mix) {
  static std::array<std::optional<Lines>, 3> made;
  auto& lines = made[static_cast<std::size_t>(mix)];
  if (lines) return *lines;
  lines.emplace();
  Random random(1);
  while (lines->space.size() < count || lines->homogeneous.size() < count) {
    Space line;
    for (int i = 0; i < 3; ++i)
      line.a[i] = random.uniform(-600, 1600), line.b[i] = random.uniform(-600, 1600);
    if (lines->space.size() < count &&
        fits(codes::region_code(line.a, box), codes::region_code(line.b, box), mix))
      lines->space.push_back(line);
    const double near = random.uniform(0.5, 1.5), far = random.uniform(0.5, 1.5);
    const auto seen = [](const glm::dvec3& p, double w) {
      return glm::dvec4(w * (p.x / 500 - 1), w * (p.y / 500 - 1), w * p.z / 1000, w);
    };
    const Homogeneous four{seen(line.a, near), seen(line.b, far)};
    const codes::ViewVolume volume;
    if (lines->homogeneous.size() < count &&
        fits(codes::region_code(four.a, volume), codes::region_code(four.b, volume), mix)) {
      lines->homogeneous.push_back(four);
    }
  }
  return *lines;
}

template <class Line, class One>
void time_each(benchmark::State& state, const std::vector<Line>& lines, One one) {
  std::vector<Line> clipped(count);
  std::int64_t accepted = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<Line> line = one(lines[i]);
      if (line) clipped[i] = *line;
      accepted += line.has_value();
    }
    benchmark::DoNotOptimize(clipped.data());
    benchmark::DoNotOptimize(accepted);
    benchmark::ClobberMemory();
  }
  state.SetLabel(name(static_cast<int>(state.range(0))));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

/// How far the answers of a method lie from exact ones.
struct Errors {
  double worst = 0;
  int wrong = 0;

  // Not inline: what is timed should be
  [[gnu::noinline]] void add(const std::optional<Space>& part, const Space& line) {
    const auto exact = test::exact_clip(line, box);
    wrong += part.has_value() != exact.has_value();
    for (std::size_t i = 0; part && exact && i < 3; ++i) {
      worst = std::max({worst, error(part->a[static_cast<int>(i)], exact->a[i]),
                        error(part->b[static_cast<int>(i)], exact->b[i])});
    }
  }
  /// In units in the last place of a double there, but not of one below 1: an error is then one of 2^-52.
  static double error(double x, const test::Rational& exact) {
    const double near = std::max(std::abs(static_cast<double>(exact)), 1.0);
    const test::Rational off = test::Rational(x) - exact;
    return std::abs(static_cast<double>(off)) / (std::nextafter(near, 1e300) - near);
  }
  void report(benchmark::State& state) const {
    state.counters["max_ulp"] = worst;
    state.counters["wrong"] = wrong;
  }
};

template <class One>
void time_box(benchmark::State& state, One one) {
  const std::vector<Space>& lines = lines_of(static_cast<int>(state.range(0))).space;
  Errors errors;
  for (const Space& line : lines) errors.add(one(line), line);
  time_each(state, lines, one);
  errors.report(state);
}

void BM_CohenSutherlandCutOfACut(benchmark::State& state) {
  time_box(state, [](const Space& line) { return codes::cut_of_a_cut(line, box); });
}
void BM_CohenSutherlandCorrectlyRounded(benchmark::State& state) {
  time_box(state, [](const Space& line) { return codes::correctly_rounded(line, box); });
}
void BM_LiangBarskyParametric(benchmark::State& state) {
  time_box(state, [](const Space& line) { return liang_barsky::box_parametric(line, box); });
}
void BM_LiangBarskyCorrectlyRounded(benchmark::State& state) {
  time_box(state, [](const Space& line) { return liang_barsky::box_correctly_rounded(line, box); });
}
void BM_Batch(benchmark::State& state) {
  const int mix = static_cast<int>(state.range(0));
  const std::vector<Space>& lines = lines_of(mix).space;
  std::vector<Space> clipped(count);
  std::vector<std::uint8_t> accepted(count);
  codes::clip_batch(lines, box, clipped, accepted);
  Errors errors;
  for (std::size_t i = 0; i < count; ++i) {
    errors.add(accepted[i] ? std::optional(clipped[i]) : std::nullopt, lines[i]);
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(codes::clip_batch(lines, box, clipped, accepted));
    benchmark::DoNotOptimize(clipped.data());
    benchmark::ClobberMemory();
  }
  state.SetLabel(name(mix));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  errors.report(state);
}
void BM_ViewVolumeCutOfACut(benchmark::State& state) {
  time_each(state, lines_of(static_cast<int>(state.range(0))).homogeneous,
            [](const Homogeneous& line) { return codes::cut_of_a_cut(line, codes::ViewVolume{}); });
}
void BM_ViewVolumeCorrectlyRounded(benchmark::State& state) {
  time_each(state, lines_of(static_cast<int>(state.range(0))).homogeneous,
            [](const Homogeneous& line) { return codes::correctly_rounded(line, codes::ViewVolume{}); });
}

BENCHMARK(BM_CohenSutherlandCutOfACut)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CohenSutherlandCorrectlyRounded)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_LiangBarskyParametric)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_LiangBarskyCorrectlyRounded)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Batch)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ViewVolumeCutOfACut)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ViewVolumeCorrectlyRounded)->DenseRange(inside, outside)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gradus
