// Segments against a box by the methods of both topics that clip them. OpenCV and Boost.Geometry clip
// segments in the plane alone, so there is no rival here.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "benchmark/clipping/segments.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

namespace cs = gradus::cohen_sutherland_3d;
using Line = Segment<3, double>;

const AxisBox<3, double> box{{0, 0, 0}, {1000, 1000, 1000}};

bool fits(const Line& line, const std::string& mix) {
  const int a = cs::region_code(line.a, box), b = cs::region_code(line.b, box);
  if (mix == "inside") return (a | b) == 0;
  if (mix == "outside") return (a & b) != 0;
  return (a & b) == 0 && (a | b) != 0;
}

/// So many segments of a mix, always the same.
const segments::Set<3>& lines_of(const std::string& mix, std::size_t count) {
  static std::map<std::pair<std::string, std::size_t>, segments::Set<3>> made;
  const auto [place, added] = made.try_emplace({mix, count});
  segments::Set<3>& set = place->second;
  if (!added) return set;
  Random random(1);
  while (set.lines.size() < count) {
    Line line;
    for (int i = 0; i < 3; ++i) {
      line.a[i] = random.uniform(-600, 1600);
      line.b[i] = random.uniform(-600, 1600);
    }
    if (!fits(line, mix)) continue;
    set.lines.push_back(line);
    set.right.push_back(test::exact_clip(line, box));
  }
  return set;
}

void add_cases(std::vector<Case>& cases, const segments::Set<3>& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto clip) {
    cases.push_back(segments::case_of(name, standing, set, clip, workload, segments::add_errors<3>));
  };
  using segments::each;
  add("cut_of_a_cut", Standing::taught, each([](const Line& line) { return cs::cut_of_a_cut(line, box); }));
  add("correctly_rounded", Standing::robust,
      each([](const Line& line) { return cs::correctly_rounded(line, box); }));
  add("box_parametric", Standing::taught,
      each([](const Line& line) { return liang_barsky::box_parametric(line, box); }));
  add("box_correctly_rounded", Standing::robust,
      each([](const Line& line) { return liang_barsky::box_correctly_rounded(line, box); }));
  add("clip_batch", Standing::batch, [](const std::vector<Line>& from, segments::Clipped<3>& out) {
    cs::clip_batch(from, box, out.lines, out.accepted);
  });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* mix : {"inside", "crossing", "outside"}) add_cases(all, lines_of(mix, 4096), {mix});
  for (const std::size_t count : {64u, 512u, 4096u, 32768u}) {
    add_cases(all, lines_of("crossing", count),
              {fmt::format("{} crossing", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject cohen_sutherland_3d() {
  return {.topic = "cohen_sutherland_3d",
          .title = "Segments against a box",
          .item = "segment",
          .unit = "ulp",
          .measure = "segments",
          .telling = "crossing",
          .cases = cases,
          .choice = {"clip_batch", "decided exactly, ends rounded once, in the least time"}};
}

}  // namespace gradus::bench
