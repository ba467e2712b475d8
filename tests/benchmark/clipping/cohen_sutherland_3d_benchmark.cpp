// Segments against a box by the methods of both topics that clip them. OpenCV and Boost.Geometry clip
// segments in the plane alone, so there is no rival here.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "core/random.hpp"
#include "support/clip_oracle.hpp"

namespace gradus::bench {
namespace {

namespace cs = gradus::cohen_sutherland_3d;
using Line = Segment<3, double>;

const AxisBox<3, double> box{{0, 0, 0}, {1000, 1000, 1000}};

/// Segments, and what exact arithmetic leaves of each.
struct Lines {
  std::vector<Line> lines;
  std::vector<std::optional<test::ExactEnds<3>>> ends;
};

bool fits(const Line& line, const std::string& mix) {
  const int a = cs::region_code(line.a, box), b = cs::region_code(line.b, box);
  if (mix == "inside") return (a | b) == 0;
  if (mix == "outside") return (a & b) != 0;
  return (a & b) == 0 && (a | b) != 0;
}

/// So many segments of a mix, always the same.
const Lines& lines_of(const std::string& mix, std::size_t count) {
  static std::map<std::pair<std::string, std::size_t>, Lines> made;
  const auto [place, added] = made.try_emplace({mix, count});
  Lines& set = place->second;
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
    set.ends.push_back(test::exact_clip(line, box));
  }
  return set;
}

struct Clipped {
  std::vector<Line> lines;
  std::vector<std::uint8_t> accepted;
};

/// In the last place of a double there, but not of one below 1: an error is then one of 2^-52.
Error error_of(const Clipped& found, const Lines& set) {
  Error::Sum sum;
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const auto& ends = set.ends[i];
    if (ends.has_value() != (found.accepted[i] != 0)) sum.wrong_decision();
    if (!ends || !found.accepted[i]) continue;
    const Line& line = found.lines[i];
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      sum.add(test::error_in_ulp(line.a[axis], ends->a[k], 1));
      sum.add(test::error_in_ulp(line.b[axis], ends->b[k], 1));
    }
  }
  return sum.error();
}

void add_cases(std::vector<Case>& cases, const Lines& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto clip) {
    const auto out = std::make_shared<Clipped>();
    out->lines.resize(set.lines.size());
    out->accepted.resize(set.lines.size());
    clip(set.lines, *out);
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = workload,
                     .items = static_cast<std::int64_t>(set.lines.size()),
                     .run = [clip, out, &set] { clip(set.lines, *out); },
                     .error = error_of(*out, set)});
  };
  const auto each = [](auto one) {
    return [one](const std::vector<Line>& from, Clipped& out) {
      for (std::size_t i = 0; i < from.size(); ++i) {
        const std::optional<Line> line = one(from[i]);
        if (line) out.lines[i] = *line;
        out.accepted[i] = line.has_value();
      }
    };
  };
  add("cut_of_a_cut", Standing::taught, each([](const Line& line) { return cs::cut_of_a_cut(line, box); }));
  add("correctly_rounded", Standing::robust,
      each([](const Line& line) { return cs::correctly_rounded(line, box); }));
  add("box_parametric", Standing::taught,
      each([](const Line& line) { return liang_barsky::box_parametric(line, box); }));
  add("box_correctly_rounded", Standing::robust,
      each([](const Line& line) { return liang_barsky::box_correctly_rounded(line, box); }));
  add("clip_batch", Standing::batch, [](const std::vector<Line>& from, Clipped& out) {
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
          .cases = cases};
}

}  // namespace gradus::bench
