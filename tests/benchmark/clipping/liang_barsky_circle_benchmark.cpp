// Segments against a circle. OpenCV's and Boost.Geometry's clippers know no circle, so the rivals are the
// notes' listings.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "core/elementary.hpp"

namespace gradus::bench {
namespace {

namespace lbc = gradus::liang_barsky_circle;
using Ends = Segment<2, double>;
using Kept = std::optional<Ends>;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>>;

constexpr Circle<double> circle{{0.3, -0.2}, 5};

/// The answer in 400 bits, rounded once.
Kept reference(const Ends& s) {
  const Wide dx = Wide(s.b.x) - s.a.x, dy = Wide(s.b.y) - s.a.y;
  const Wide fx = Wide(s.a.x) - circle.centre.x, fy = Wide(s.a.y) - circle.centre.y;
  const Wide r(circle.radius), A = dx * dx + dy * dy, B = fx * dx + fy * dy, C = fx * fx + fy * fy - r * r;
  const Wide D = B * B - A * C;
  if (D < 0) return std::nullopt;
  const Wide root = sqrt(D), enters = (-B - root) / A, leaves = (-B + root) / A;
  if (enters > 1 || leaves < 0) return std::nullopt;
  Ends kept = s;
  const auto at = [&](const Wide& t) {
    return dvec2(Wide(s.a.x + t * dx).convert_to<double>(), Wide(s.a.y + t * dy).convert_to<double>());
  };
  if (enters > 0) kept.a = at(enters);
  if (leaves < 1) kept.b = at(leaves);
  return kept;
}

/// Segments, and what is left of them.
struct Segments {
  std::vector<Ends> segments;
  std::vector<Kept> right;
};

/// So many of a mix: wholly inside; cut at one end or both; outside; passing the rim within 1e-12.
const Segments& segments(const std::string& mix, std::size_t count) {
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
  while (set.segments.size() < count) {
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
    const Kept kept = reference(s);
    const char* is = !kept ? "outside" : *kept == s ? "inside" : "crossing";
    if (mix != "grazing" && mix != is) continue;
    set.segments.push_back(s);
    set.right.push_back(kept);
  }
  return set;
}

/// In the last place of a double of the size of the coordinate, but at least of the radius.
double ulps(double got, double right) {
  if (!std::isfinite(got)) return 1e18;
  const double size = std::max(std::abs(right), circle.radius);
  return std::abs(got - right) / (std::nextafter(size, 1e300) - size);
}

struct Clipped {
  std::vector<Ends> segments;
  std::vector<std::uint8_t> accepted;
};

Error error_of(const Clipped& got, const Segments& set) {
  Error::Sum sum;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Kept& right = set.right[i];
    if ((got.accepted[i] != 0) != right.has_value()) sum.wrong_decision();
    if (!got.accepted[i] || !right) continue;
    const Ends& s = got.segments[i];
    sum.add(std::max(ulps(s.a.x, right->a.x), ulps(s.a.y, right->a.y)));
    sum.add(std::max(ulps(s.b.x, right->b.x), ulps(s.b.y, right->b.y)));
  }
  return sum.error();
}

void add_cases(std::vector<Case>& cases, const Segments& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto clip) {
    const auto out = std::make_shared<Clipped>();
    out->segments.resize(set.segments.size());
    out->accepted.resize(set.segments.size());
    clip(set.segments, *out);
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = workload,
                     .items = static_cast<std::int64_t>(set.segments.size()),
                     .run = [clip, out, &set] { clip(set.segments, *out); },
                     .error = error_of(*out, set)});
  };
  const auto each = [](auto one) {
    return [one](const std::vector<Ends>& from, Clipped& out) {
      for (std::size_t i = 0; i < from.size(); ++i) {
        const Kept kept = one(from[i]);
        if (kept) out.segments[i] = *kept;
        out.accepted[i] = kept.has_value();
      }
    };
  };
  add("half_chord", Standing::taught, each([](const Ends& s) { return lbc::half_chord(s, circle); }));
  add("exact_decision", Standing::robust, each([](const Ends& s) { return lbc::exact_decision(s, circle); }));
  add("clip_batch", Standing::batch, [](const std::vector<Ends>& from, Clipped& out) {
    lbc::clip_batch(from, circle, out.segments, out.accepted);
  });
  add("without_empty_test", Standing::faulty,
      each([](const Ends& s) { return lbc::without_empty_test(s, circle); }));
  add("discriminant_equals_zero", Standing::faulty,
      each([](const Ends& s) { return lbc::discriminant_equals_zero(s, circle); }));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* mix : {"inside", "crossing", "outside", "grazing"}) {
    add_cases(all, segments(mix, 4096), {mix});
  }
  for (const std::size_t count : {64u, 512u, 4096u, 32768u}) {
    add_cases(all, segments("crossing", count),
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
          .cases = cases};
}

}  // namespace gradus::bench
