// Segments against a circle. OpenCV's and Boost.Geometry's clippers know no circle, so the rivals are the
// notes' listings.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "benchmark/clipping/segments.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "core/arithmetic/elementary.hpp"
#include "stress/clipping/circle_ends.hpp"

namespace gradus::bench {
namespace {

namespace lbc = gradus::liang_barsky_circle;
using Ends = Segment<2, double>;
constexpr Circle<double> circle{{0.3, -0.2}, 5};

using Right = stress::EndsInCircle<double>;
using Segments = segments::Set<2, Right>;

/// In ulp of max(|coordinate|, radius); what is no number is as far away as can be, but comparable.
void add_errors(Error::Sum& sum, const Ends& found, const Right& right) {
  constexpr double most = 1e18;
  sum.add(std::min(right.from.error(found.a), most));
  sum.add(std::min(right.to.error(found.b), most));
}

/// So many of a mix: wholly inside; cut at one end or both; outside; passing the rim within 1e-12.
const Segments& segments_of(const std::string& mix, std::size_t count) {
  static std::map<std::pair<std::string, std::size_t>, Segments> made;
  const auto [at, added] = made.try_emplace({mix, count});
  Segments& set = at->second;
  if (!added) return set;
  std::mt19937_64 random(1);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const auto point = [&] {
    const double x = 20 * unit() - 10;
    return dvec2(x, 20 * unit() - 10);
  };
  while (set.lines.size() < count) {
    Ends s;
    if (mix == "grazing") {
      const SinCos turn = sin_cos(6.2832 * unit());
      const dvec2 n(turn.cos, turn.sin), along(-n.y, n.x);
      const dvec2 foot = circle.centre + (circle.radius + 1e-12 * (unit() - 0.5)) * n;
      const double before = 1 + 5 * unit(), after = 1 + 5 * unit();
      s = {foot - before * along, foot + after * along};
    } else {
      s.a = point();
      s.b = point();
    }
    const auto right =
        stress::ends_in_circle({s.a.x, s.a.y, s.b.x, s.b.y, circle.centre.x, circle.centre.y, circle.radius});
    const bool is_whole = right && right->from_is_given && right->to_is_given;
    const char* is = !right ? "outside" : is_whole ? "inside" : "crossing";
    if (mix != "grazing" && mix != is) continue;
    set.lines.push_back(s);
    set.right.push_back(right);
  }
  return set;
}

void add_cases(std::vector<Case>& cases, const Segments& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto clip) {
    cases.push_back(segments::case_of(name, standing, set, clip, workload, add_errors));
  };
  using segments::each;
  add("half_chord", Standing::taught, each([](const Ends& s) { return lbc::half_chord(s, circle); }));
  add("exact_decision", Standing::robust, each([](const Ends& s) { return lbc::exact_decision(s, circle); }));
  add("clip_batch", Standing::batch, [](const std::vector<Ends>& from, segments::Clipped<2>& out) {
    lbc::clip_batch(from, circle, out.lines, out.accepted);
  });
  add("without_empty_test", Standing::faulty,
      each([](const Ends& s) { return lbc::without_empty_test(s, circle); }));
  add("discriminant_equals_zero", Standing::faulty,
      each([](const Ends& s) { return lbc::discriminant_equals_zero(s, circle); }));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* mix : {"inside", "crossing", "outside", "grazing"}) {
    add_cases(all, segments_of(mix, 4096), {mix});
  }
  for (const std::size_t count : {64u, 512u, 4096u, 32768u}) {
    add_cases(all, segments_of("crossing", count),
              {fmt::format("{} crossing", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject liang_barsky_circle() {
  return {.topic = "liang_barsky_circle",
          .title = "Segments against a circle",
          .item = "segment",
          .unit = "ulp",
          .measure = "segments",
          .telling = "crossing",
          .cases = cases,
          .choice = {"clip_batch", "decided exactly, many times as fast as exact_decision"}};
}

}  // namespace gradus::bench
