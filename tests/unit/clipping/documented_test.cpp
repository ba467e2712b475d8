// The numbers that the pages of clipping claim of the methods that round, measured again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "clipping/liang_barsky/liang_barsky.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "stress/clipping/circle_polygons.hpp"
#include "support/circle_areas.hpp"
#include "support/clip_oracle.hpp"
#include "support/documented.hpp"
#include "support/every_target.hpp"

namespace gradus {
namespace {

using test::states;

constexpr const char* page_2d = "docs/topics/clipping/cohen_sutherland_2d.md";
constexpr const char* page_3d = "docs/topics/clipping/cohen_sutherland_3d.md";
constexpr const char* page_parametric = "docs/topics/clipping/liang_barsky.md";

template <int N>
struct Case {
  Segment<N, double> line;
  AxisBox<N, double> box;
};

/// Ends and corners of the box anywhere in ±1000.
template <int N>
Case<N> anywhere(Random& random) {
  Case<N> c;
  for (int i = 0; i < N; ++i) {
    c.line.a[i] = random.uniform(-1000, 1000);
    c.line.b[i] = random.uniform(-1000, 1000);
    const double p = random.uniform(-1000, 1000), q = random.uniform(-1000, 1000);
    c.box.lower[i] = std::min(p, q);
    c.box.upper[i] = std::max(p, q);
  }
  return c;
}

double nudged(double x, Random& random) {
  for (auto steps = random.uniform_int(0, 3); steps > 0; --steps)
    x = std::nextafter(x, random.unit() < 0.5 ? -2e3 : 2e3);
  return x;
}

/// Through a place where two borders meet, but for some steps of the last place.
template <int N>
Case<N> aimed(Random& random) {
  Case<N> c = anywhere<N>(random);
  for (int i = 0; i < N; ++i) {
    const bool border = i < 2;
    const double edge = border ? (random.unit() < 0.5 ? c.box.lower[i] : c.box.upper[i])
                               : random.uniform(c.box.lower[i], c.box.upper[i]);
    const double away = random.uniform(-500, 500);
    c.line.a[i] = nudged(edge - away, random);
    c.line.b[i] = nudged(edge + away, random);
  }
  return c;
}

/// Of segments that are kept after a cut: how many, the percentage of those with a coordinate more than an
/// ulp off, and the worst.
struct Errors {
  int kept = 0, above = 0;
  double worst = 0;
  double percent() const { return 100.0 * above / kept; }
};
template <int N, class Method>
Errors errors_of(Method method, int segments) {
  Random random(20240611);
  Errors all;
  for (int i = 0; i < segments; ++i) {
    const Case<N> c = anywhere<N>(random);
    const auto exact = test::exact_clip(c.line, c.box);
    const std::optional<Segment<N, double>> found = method(c.line, c.box);
    if (!exact || !found || (found->a == c.line.a && found->b == c.line.b)) continue;
    const double off = test::worst_end(
        found, exact, [](double x, const test::Fraction& right) { return test::error_in_ulp(x, right); });
    ++all.kept;
    all.above += off > 1;
    all.worst = std::max(all.worst, off);
  }
  return all;
}
template <int N, class Method>
int wrong_decisions(Method method, int segments) {
  Random random(20240611);
  int wrong = 0;
  for (int i = 0; i < segments; ++i) {
    const Case<N> c = aimed<N>(random);
    wrong += test::exact_clip(c.line, c.box).has_value() != method(c.line, c.box).has_value();
  }
  return wrong;
}

constexpr auto cuts_in_plane = [](const auto& line, const auto& box) {
  return cohen_sutherland_2d::cut_of_a_cut(line, box);
};
constexpr auto cuts_in_space = [](const auto& line, const auto& box) {
  return cohen_sutherland_3d::cut_of_a_cut(line, box);
};
constexpr auto parametric = [](const auto& line, const auto& box) {
  return liang_barsky::parametric(line, box);
};

TEST(DocumentedClipping, CutsOfCutsInThePlane) {
  const Errors all = errors_of<2>(cuts_in_plane, 30'000);
  EXPECT_TRUE(
      states(page_2d,
             "of {} that are kept after a cut {} % have a coordinate more than 1 ulp off, the worst {} ulp.",
             {double(all.kept), all.percent(), all.worst}));
  EXPECT_TRUE(states(page_2d, "Of 20,000 aimed at a corner it decides {} wrongly.",
                     {double(wrong_decisions<2>(cuts_in_plane, 20'000))}));
}

TEST(DocumentedClipping, ParametersInThePlane) {
  const Errors all = errors_of<2>(parametric, 30'000);
  EXPECT_TRUE(
      states(page_parametric,
             "of {} that are kept after a cut {} % have a coordinate more than 1 ulp off, the worst {} ulp;",
             {double(all.kept), all.percent(), all.worst}));
  Random random(20240611);
  int moved = 0;
  for (int i = 0; i < 30'000; ++i) {
    const Case<2> c = anywhere<2>(random);
    const auto once = parametric(c.line, c.box);
    if (!once || (once->a == c.line.a && once->b == c.line.b)) continue;
    const auto again = parametric(*once, c.box);
    moved += !again || again->a != once->a || again->b != once->b;
  }
  EXPECT_TRUE(states(page_parametric, "; {} % move once more when they are clipped again",
                     {100.0 * moved / all.kept}));
}

TEST(DocumentedClipping, CutsOfCutsInSpace) {
  const Errors all = errors_of<3>(cuts_in_space, 30'000);
  EXPECT_TRUE(states(
      page_3d,
      "Of {} segments with ends in ±1000 that it cut, {} % have a coordinate off by more than 1 ulp, the "
      "worst by {} ulp",
      {double(all.kept), all.percent(), all.worst}));
  EXPECT_TRUE(states(page_3d, "of 20,000 aimed within some steps of an edge it decided {} % wrongly.",
                     {wrong_decisions<3>(cuts_in_space, 20'000) / 200.0}));
}

/// Segments of homogeneous points in front of the eye, most of which cross the view volume's sides.
Segment<4, double> before_the_eye(Random& random) {
  const auto point = [&] {
    const double w = random.uniform(0.1, 100);
    return glm::dvec4{w * random.uniform(-2, 2), w * random.uniform(-2, 2), w * random.uniform(-1, 2), w};
  };
  return {point(), point()};
}
template <class Method>
double worst_projection(Method method) {
  Random random(20240611);
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const Segment<4, double> line = before_the_eye(random);
    const auto exact = test::exact_part(line);
    const std::optional<Segment<4, double>> found = method(line);
    if (!exact || !found) continue;
    for (const auto& [p, right] : {std::pair(found->a, exact->a), std::pair(found->b, exact->b)}) {
      for (int k = 0; k < 3; ++k) {
        worst =
            std::max(worst, test::error_in_ulp(p[k] / p.w, right[static_cast<std::size_t>(k)] / right[3]));
      }
    }
  }
  return worst;
}

TEST(DocumentedClipping, PartsOfTheViewVolumeDividedByW) {
  const double rounded = worst_projection([](const auto& line) {
    return cohen_sutherland_3d::correctly_rounded(line, cohen_sutherland_3d::ViewVolume{});
  });
  const double taught = worst_projection([](const auto& line) {
    return cohen_sutherland_3d::cut_of_a_cut(line, cohen_sutherland_3d::ViewVolume{});
  });
  EXPECT_LE(rounded, 3);
  EXPECT_TRUE(states(page_3d, "the worst of 5000 segments {}, after `cut_of_a_cut` {}.", {rounded, taught}));
}

TEST(DocumentedClipping, EndsOnCircles) {
  using test::Wide;
  Random random(20240611);
  double worst = 0;
  for (int n = 0; n < 5000; ++n) {
    double x[7];
    for (double& v : x) v = random.uniform(-10, 10);
    const dvec2 from{x[0], x[1]}, to{x[2], x[3]}, centre{x[4] / 2, x[5] / 2};
    const double radius = std::abs(x[6]);
    const auto kept =
        liang_barsky_circle::exact_decision(Segment<2, double>{from, to}, Circle<double>{centre, radius});
    if (!kept) continue;
    // The roots of the quadratic for t, in 200 bits
    const Wide dx = Wide(to.x) - from.x, dy = Wide(to.y) - from.y, fx = Wide(from.x) - centre.x,
               fy = Wide(from.y) - centre.y;
    const Wide a = dx * dx + dy * dy, b = dx * fx + dy * fy,
               root = sqrt(b * b - a * (fx * fx + fy * fy - Wide(radius) * radius));
    const Wide enter = std::max(Wide(0), Wide((-b - root) / a)),
               leave = std::min(Wide(1), Wide((-b + root) / a));
    for (const auto& [end, t] :
         {std::pair<dvec2, Wide>(kept->a, enter), std::pair<dvec2, Wide>(kept->b, leave)}) {
      const Wide right[] = {from.x + t * dx, from.y + t * dy};
      for (const int axis : {0, 1}) {
        const double size = std::max(std::abs(end[axis]), radius),
                     ulp = std::nextafter(size, HUGE_VAL) - size;
        worst = std::max(worst, static_cast<double>(Wide(abs(Wide(end[axis] - right[axis])) / ulp)));
      }
    }
  }
  EXPECT_LE(worst, 0.63);
  EXPECT_TRUE(states("docs/topics/clipping/liang_barsky_circle.md",
                     "the worst of 5,000 random segments is {} ulp.", {worst}));
}

TEST(DocumentedClipping, AreasOfPolygonsInCircles) {
  using stress::Kind;
  Random random(20240611);
  double worst = 0;
  for (int n = 0; n < 1600;) {
    constexpr Kind kinds[] = {Kind::random, Kind::grazing};
    const stress::Input input = stress::circle_polygons::star(kinds[n % 2], random);
    if (!stress::circle_polygons::is_simple(input)) continue;
    ++n;
    const auto polygon = stress::circle_polygons::points_of(input);
    const auto region = polygon_circle::arcs(polygon, stress::circle_polygons::circle_of(input));
    const test::Enclosed got = test::enclosed_by(region);
    const test::Wide right = test::exact_area(polygon, region.circle);
    double largest = 0;
    for (const dvec2 p : polygon) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    const dvec2 centre = region.circle.centre;
    const double radius = region.circle.radius,
                 reach = std::max(std::abs(centre.x), std::abs(centre.y)) + radius;
    const double size = std::max(radius, std::min(largest, reach)), unit = size - std::nextafter(size, 0.0);
    worst = std::max(worst, static_cast<double>(test::Wide(abs(test::Wide(got.area - right)) /
                                                           (4 * (radius + got.length) * unit))));
  }
  EXPECT_LE(worst, 1);
  EXPECT_TRUE(states("docs/topics/clipping/polygon_circle.md",
                     "of 1,600 random polygons the worst used {} of it.", {worst}));
}

TEST(DocumentedClipping, SignsOfDiscriminantsOfTangents) {
  using test::Fraction;
  Random random(20240611);
  int below = 0, zero = 0, above = 0, wrong = 0;
  for (int n = 0; n < 30'000; ++n) {
    const dvec2 centre{random.uniform(-5, 5), random.uniform(-5, 5)};
    const double radius = random.uniform(0.1, 10), turn = random.uniform(0, 6.283);
    const dvec2 away{gradus::cos(turn), gradus::sin(turn)}, along{-away.y, away.x},
        touches = centre + radius * away;
    const dvec2 from = touches - random.uniform(0.1, 10) * along,
                to = touches + random.uniform(0.1, 10) * along;
    // D = B² - 4AC as it stands, and of the same numbers exactly
    const auto discriminant = [&]<class T>(T) {
      const T dx = T(to.x) - T(from.x), dy = T(to.y) - T(from.y), fx = T(from.x) - T(centre.x),
              fy = T(from.y) - T(centre.y);
      const T a = dx * dx + dy * dy, b = T(2.0) * (dx * fx + dy * fy),
              c = fx * fx + fy * fy - T(radius) * T(radius);
      return b * b - T(4.0) * a * c;
    };
    const double rounded = discriminant(0.0);
    const int sign = (rounded > 0) - (rounded < 0);
    below += sign < 0, zero += sign == 0, above += sign > 0;
    wrong += sign != discriminant(Fraction(0)).sign();
  }
  EXPECT_TRUE(states("docs/topics/clipping/liang_barsky_circle.md",
                     "Of 30,000 lines tangent by construction doubles say D < 0 for {}, D = 0 for {} and D > "
                     "0 for {}; {} of these are "
                     "not what the very same input says exactly.",
                     {double(below), double(zero), double(above), double(wrong)}));
}

TEST(DocumentedClipping, TheSquareThatEdgesCrossTwice) {
  constexpr const char* page = "docs/topics/clipping/polygon_circle.md";
  const std::vector<dvec2> square{{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}};
  const double area = static_cast<double>(test::exact_area(square, Circle<double>{{0, 0}, 1}));
  EXPECT_TRUE(states(page, "loses the square [-0.8,0.8]² whole: 0, right is {}.", {area}));
  // With all crossings, at 0.6, an octagon: the square less four corners of 0.2 by 0.2
  EXPECT_TRUE(states(page, "for the same square {} even with all crossings.",
                     {area - (1.6 * 1.6 - 4 * 0.2 * 0.2 / 2)}));
}

TEST(DocumentedClipping, ALineThatLeavesBeforeItEnters) {
  // (-5, 8)-(3, 20) and the borders x = 0 and y = 10
  EXPECT_TRUE(states(page_parametric,
                     "(-5,8)-(3,20) crosses the left border at t = {} and the top one at {},",
                     {(0 + 5) / (3.0 + 5), (10 - 8) / (20.0 - 8)}));
}

/// How many of so many segments at the unit circle a batch certifies, and how many are cut.
struct Certified {
  double share = 0, cut = 0;
};
template <class Draw>
Certified certified_of(int count, Draw draw) {
  Random random(20240611);
  std::vector<Segment<2, double>> segments(static_cast<std::size_t>(count)), clipped = segments;
  std::vector<std::uint8_t> accepted(segments.size());
  for (auto& segment : segments) segment = draw(random);
  const auto [kept, one_by_one] =
      liang_barsky_circle::clip_batch(segments, Circle<double>{{0, 0}, 1}, clipped, accepted);
  int cut = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
    cut += accepted[i] && (clipped[i].a != segments[i].a || clipped[i].b != segments[i].b);
  return {1 - static_cast<double>(one_by_one) / count, static_cast<double>(cut) / count};
}

TEST(DocumentedClipping, SegmentsThatABatchCertifies) {
  const auto place = [](Random& random, double far) {
    const double x = random.uniform(-far, far);
    return dvec2{x, random.uniform(-far, far)};
  };
  const auto between = [&](double far) {
    return [=](Random& random) {
      const dvec2 from = place(random, far);
      return Segment<2, double>{from, place(random, far)};
    };
  };
  // Through a place of the disc, both ends so many radii away
  const auto from_afar = [&](double far) {
    return [=](Random& random) {
      const double angle = random.uniform(-3, 3);
      const dvec2 through = place(random, 0.7), way = far * dvec2{gradus::cos(angle), gradus::sin(angle)};
      return Segment<2, double>{through - way, through + way};
    };
  };
  const auto grazing = [](Random& random) {
    const double angle = random.uniform(-3, 3), off = 1 + random.uniform(-1e-12, 1e-12);
    const dvec2 out{gradus::cos(angle), gradus::sin(angle)}, along{-out.y, out.x};
    const double before = random.uniform(0.5, 2), after = random.uniform(0.5, 2);
    return Segment<2, double>{off * out - before * along, off * out + after * along};
  };
  const int targets = test::on_every_target([&] {
    const Certified anywhere = certified_of(16'384, between(2)), rim = certified_of(1000, grazing),
                    far = certified_of(4096, from_afar(0x1p20)),
                    farther = certified_of(4096, from_afar(0x1p29));
    EXPECT_EQ(anywhere.share, 1);
    EXPECT_EQ(far.share, 1);
    EXPECT_TRUE(states(
        "docs/topics/clipping/liang_barsky_circle.md",
        "Certified were all of 16,384 random segments ({} % of them cut), {} of 1000 within 1e-12 of a "
        "tangent and, of 4,096 with both ends 2²⁰ radii away, all; 2²⁹ away {} %.",
        {100 * anywhere.cut, 1000 * rim.share, 100 * farther.share}));
  });
  EXPECT_GT(targets, 0);
}

}  // namespace
}  // namespace gradus
