// The walk from back to front, judged along rays in rational numbers.

#include "core/arithmetic/exact_scalar.hpp"

#include "visibility/bsp_tree/bsp_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::bsp_tree {
namespace {

template <class T>
Polygon<T> in_scalar(const Polygon<double>& polygon) {
  std::vector<glm::vec<3, T>> corners;
  for (const dvec3 p : polygon.corners) corners.emplace_back(T(p.x), T(p.y), T(p.z));
  return {std::move(corners), polygon.face};
}

template <class T>
std::vector<Polygon<T>> in_scalar(const std::vector<Polygon<double>>& polygons) {
  std::vector<Polygon<T>> others;
  for (const auto& polygon : polygons) others.push_back(in_scalar<T>(polygon));
  return others;
}

template <class T>
std::vector<Polygon<T>> drawn(const Tree<T>& tree, const Eye<T>& eye) {
  std::vector<Polygon<T>> order;
  back_to_front(tree, eye, [&](const Polygon<T>& polygon) { order.push_back(polygon); });
  return order;
}

/// Where the ray from `from` along `way` meets a convex polygon, as a multiple of `way`; nothing where it
/// misses it or runs along it.
std::optional<Exact> hit(const Polygon<Exact>& polygon, const ExactVec3& from, const ExactVec3& way) {
  const auto& p = polygon.corners;
  const ExactVec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const Exact along = glm::dot(normal, way);
  if (along == Exact{0}) return std::nullopt;
  const Exact t = glm::dot(normal, p[0] - from) / along;
  const ExactVec3 at = from + t * way;
  int turn = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const int side = sign(glm::dot(normal, glm::cross(p[(i + 1) % p.size()] - p[i], at - p[i])));
    if (side == 0 || side == -turn) return std::nullopt;
    turn = side;
  }
  return t;
}

/// Three corners with small whole coordinates, not on a line.
Polygon<double> random_triangle(Random& random, std::size_t face) {
  while (true) {
    std::vector<dvec3> p;
    for (int i = 0; i < 3; ++i) {
      const auto number = [&] { return static_cast<double>(random.uniform_int(-6, 6)); };
      p.emplace_back(number(), number(), number());
    }
    if (glm::cross(p[1] - p[0], p[2] - p[0]) != dvec3(0)) return {p, face};
  }
}

std::vector<Polygon<double>> random_scene(Random& random, int count) {
  std::vector<Polygon<double>> scene;
  for (int i = 0; i < count; ++i) scene.push_back(random_triangle(random, static_cast<std::size_t>(i)));
  return scene;
}

/// Three bars round a triangle, each over the next: G001-77.
std::vector<Polygon<double>> three_bars() {
  const std::array<dvec3, 6> ends{{{0, 0, 0}, {10, 0, 2}, {10, 0, 0}, {5, 8, 2}, {5, 8, 0}, {0, 0, 2}}};
  std::vector<Polygon<double>> bars;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 a = ends[2 * i], b = ends[2 * i + 1], way = b - a;
    // Half a unit to either side, and a little beyond the ends, where they cross the others
    const dvec3 aside = dvec3{-way.y, way.x, 0} / 16.0, ahead = way / 8.0;
    bars.push_back(
        Polygon<double>({a - ahead - aside, b + ahead - aside, b + ahead + aside, a - ahead + aside}, i));
  }
  return bars;
}

TEST(BspTree, ThreeBarsInACycleAreCut) {
  // G001-77: B over A at (10, 0), C over B at (5, 8), A over C at (0, 0), seen from below
  const Tree<double> tree = build(three_bars());
  const auto order = drawn(tree, {0, 0, -1, 0});
  EXPECT_GT(order.size(), 3U);
  const auto last_at = [&](dvec2 place) {
    std::size_t last = none;
    for (const auto& polygon : order) {
      if (hit(in_scalar<Exact>(polygon), {Exact(place.x), Exact(place.y), Exact(0)},
              {Exact(0), Exact(0), Exact(1)}))
        last = polygon.face;
    }
    return last;
  };
  EXPECT_EQ(last_at({10, 0}), 1U);
  EXPECT_EQ(last_at({5, 8}), 2U);
  EXPECT_EQ(last_at({0, 0}), 0U);
}

TEST(BspTree, PiercingSquaresAreCut) {
  const std::vector<Polygon<double>> squares{
      Polygon<double>({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, 0),
      Polygon<double>({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, 1)};
  const Tree<double> tree = build(squares);
  ASSERT_EQ(tree.size(), 3U);
  EXPECT_EQ(polygon_count(tree), 3U);
  const auto order = drawn(tree, {0, 1, 1, 0});
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order[1].face, 0U) << "the halves of the other lie behind it and in front of it";
}

TEST(BspTree, WhatLiesInOnePlaneIsNotCut) {
  const std::vector<Polygon<double>> squares{
      Polygon<double>({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 0),
      Polygon<double>({{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}, 1),
      Polygon<double>({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 2)};
  const Tree<double> tree = build(squares);
  ASSERT_EQ(tree.size(), 1U);
  EXPECT_EQ(tree[0].polygons.size(), 3U);
}

TEST(BspTree, NothingGivesNoTree) {
  EXPECT_TRUE(build(std::vector<Polygon<double>>{}).empty());
  EXPECT_TRUE(drawn(Tree<double>{}, {0, 0, 1, 0}).empty());
}

TEST(BspTree, RefusesWhatHasNoInside) {
  EXPECT_THROW(Polygon<double>({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, 7), ContractViolation);
  EXPECT_THROW(Polygon<double>({{0, 0, 0}, {1, 1, 1}}, 7), ContractViolation);
}

TEST(BspTree, PartsThatRoundingHasClosedDoNoHarm) {
  // The plane cuts off a corner less than a last place long: all corners of that part round to one
  const std::vector<Polygon<double>> polygons{
      Polygon<double>({{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, 0),
      Polygon<double>({{0, 0, 0}, {1 + 0x1p-52, 0.3, 0.3}, {0, 0, 1}}, 1),
      Polygon<double>({{0, 0.2, 0}, {1 + 0x1p-52, 0.3, 0.3}, {0, 0, 1}}, 2)};
  const Tree<double> tree = build(polygons);
  EXPECT_EQ(drawn(tree, {1, 2, 3, 1}).size(), polygon_count(tree));
}

/// Along any ray, what comes later in the order is never farther from the eye.
TEST(BspTree, NothingCoversWhatComesLater) {
  Random random(test::seed());
  int hits = 0, cuts = 0;
  for (int round = 0; round < (test::sanitized ? 12 : 60); ++round) {
    const ExactScope scope;
    const auto scene = random_scene(random, 8);
    const Tree<Exact> tree = build(in_scalar<Exact>(scene));
    cuts += static_cast<int>(polygon_count(tree)) - 8;
    const bool distant = round % 2 == 0;
    const auto whole = [&](int most) { return Exact(random.uniform_int(-most, most)); };
    const ExactVec3 eye{whole(20), whole(20), Exact(random.uniform_int(7, 20))};
    const auto order = drawn(tree, Eye<Exact>{eye, distant ? Exact(0) : Exact(1)});
    for (int ray = 0; ray < 40; ++ray) {
      const ExactVec3 place{whole(60) / Exact(10), whole(60) / Exact(10), whole(60) / Exact(10)};
      const ExactVec3 from = distant ? place : eye, way = distant ? -eye : place - eye;
      std::optional<Exact> before;
      for (const auto& polygon : order) {
        const auto at = hit(polygon, from, way);
        if (!at || (!distant && *at <= Exact(0))) continue;
        if (before) EXPECT_LE(*at, *before);
        before = at;
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, test::sanitized ? 200 : 1000);
  EXPECT_GT(cuts, test::sanitized ? 40 : 200);
}

/// The parts of a polygon have its whole area, and its own normal.
TEST(BspTree, PartsMakeTheWhole) {
  Random random(test::seed());
  for (int round = 0; round < 60; ++round) {
    const ExactScope scope;
    const auto scene = in_scalar<Exact>(random_scene(random, 8));
    std::map<std::size_t, ExactVec3> areas;
    const auto area_of = [](const Polygon<Exact>& polygon) {
      ExactVec3 area{Exact(0), Exact(0), Exact(0)};
      const auto& p = polygon.corners;
      for (std::size_t i = 1; i + 1 < p.size(); ++i) area = area + glm::cross(p[i] - p[0], p[i + 1] - p[0]);
      return area;
    };
    for (const auto& node : build(scene)) {
      for (const auto& polygon : node.polygons) {
        auto [sum, first] = areas.try_emplace(polygon.face, ExactVec3{Exact(0), Exact(0), Exact(0)});
        sum->second = sum->second + area_of(polygon);
      }
    }
    for (const auto& polygon : scene) EXPECT_EQ(areas.at(polygon.face), area_of(polygon));
  }
}

TEST(BspTree, CutsHalfwayBetweenTwoDoublesAreRoundedToEven) {
  Random random(test::seed());
  for (int round = 0; round < 300; ++round) {
    // Any plane z = h of which the ends lie as far in front as behind; in x they are neighbours
    const double h = round % 2 == 0 ? 0 : static_cast<double>(random.uniform_int(-800, 800)) / 64,
                 step = std::ldexp(1, -round % 40);
    const dvec3 a{random.uniform(-9, 9), random.uniform(-9, 9), h}, b{a.x + 1, a.y, h}, c{a.x, a.y + 3, h};
    const double x = random.uniform(1, 1e6) * step, next = std::nextafter(x, 1e300);
    const double high = h + 4, low = h - (high - h);
    const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
    const double even = bits(x) % 2 == 0 ? x : next;
    const dvec3 at = crossing(Plane<double>{a, b, c}, {x, next, low}, {next, -next, high});
    EXPECT_EQ(at, (dvec3{even, 0, h})) << "seed " << test::seed() << ", round " << round;
    // A last place off the half
    const double up = std::nextafter(low, -1e300);
    EXPECT_EQ(crossing(Plane<double>{a, b, c}, {x, 0, up}, {next, 0, high}).x, next);
    EXPECT_EQ(crossing(Plane<double>{a, b, c}, {next, 0, up}, {x, 0, high}).x, x);
  }
}

TEST(BspTree, HeightsAreWithinTheirBound) {
  Random random(test::seed());
  bool is_near_the_bound = false;
  for (int round = 0; round < 3000; ++round) {
    // Far from the origin in every other round, and near the plane, where most cancels
    const double size = std::ldexp(1, static_cast<int>(random.uniform_int(-60, 60)));
    const dvec3 middle = size * (round % 2 == 0 ? dvec3{0} : dvec3{1e6, -3e6, 2e6});
    const auto anywhere = [&] {
      return middle + size * dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    const dvec3 a = anywhere(), b = anywhere(), c = anywhere();
    const dvec3 p = round % 3 == 0 ? anywhere() : a + random.uniform(0, 1) * (b - a) + 0.25 * (c - a);
    const detail::Height found = detail::height_above(Plane<double>{a, b, c}, p);
    const auto in_exact = [](dvec3 v) { return ExactVec3{Exact(v.x), Exact(v.y), Exact(v.z)}; };
    const ExactVec3 from = in_exact(a);
    const Exact right = glm::dot(glm::cross(in_exact(b) - from, in_exact(c) - from), in_exact(p) - from);
    Exact off = Exact(found.value.value) + Exact(found.value.error) - right;
    if (sign(off) < 0) off = -off;
    EXPECT_LE(off, Exact(0x1p-97) * Exact(found.terms)) << "seed " << test::seed() << ", round " << round;
    is_near_the_bound |= off > Exact(0x1p-108) * Exact(found.terms);
  }
  EXPECT_TRUE(is_near_the_bound);
}

TEST(BspTree, ADistantEyeIsOnTheSideToWhichItLooks) {
  const Plane<double> plane{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  EXPECT_EQ(side_of_eye(plane, Eye<double>{5, -7, 1e-300, 0}), 1);
  EXPECT_EQ(side_of_eye(plane, Eye<double>{5, -7, -1e-300, 0}), -1);
  EXPECT_EQ(side_of_eye(plane, Eye<double>{5, -7, 0, 0}), 0);
  EXPECT_EQ(side_of_eye(plane, Eye<double>{5, -7, 1, 1}), 0);
  EXPECT_EQ(side_of_eye(plane, Eye<double>{5, -7, 2, 1}), 1);
}

// --- Faces off their own planes

using Areas = std::map<std::size_t, double>;

/// Half of what the corners' cross products add up to.
double area_of(const std::vector<dvec3>& p) {
  glm::vec<3, long double> sum(0);
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    sum += glm::cross(glm::vec<3, long double>(p[i] - p[0]), glm::vec<3, long double>(p[i + 1] - p[0]));
  return static_cast<double>(glm::length(sum) / 2);
}

/// What the parts of each face add up to, as a share of it.
Areas shares(const std::vector<Polygon<double>>& faces) {
  Areas shares;
  for (const auto& node : build(faces))
    for (const auto& part : node.polygons) shares[part.face] += area_of(part.corners);
  for (const auto& face : faces) shares[face.face] /= area_of(face.corners);
  return shares;
}

/// A regular polygon about (1000, 1000, 1000), whose corners rounding puts beside its plane.
std::vector<dvec3> regular(int corners, double radius, const glm::dmat3& turn) {
  std::vector<dvec3> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    outline.push_back(dvec3(1000) + turn * (radius * dvec3{std::cos(angle), std::sin(angle), 0}));
  }
  return outline;
}

glm::dmat3 any_turn(Random& random) {
  const auto number = [&] { return random.uniform(-1, 1); };
  return glm::mat3_cast(glm::normalize(glm::dquat{number(), number(), number(), number()}));
}

std::vector<dvec3> from_corner(std::vector<dvec3> outline, std::ptrdiff_t first) {
  std::ranges::rotate(outline, outline.begin() + first);
  return outline;
}

TEST(BspTree, AFaceGivenThreeTimesIsNotCut) {
  const std::uint64_t seed = test::seed();
  for (std::uint64_t i = 0; i < 200; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i);
    Random random(seed, i);
    const auto outline = regular(12, 100, any_turn(random));
    auto turned_round = from_corner(outline, 5);
    std::ranges::reverse(turned_round);
    const Tree<double> tree = build(std::vector<Polygon<double>>{
        {outline, 0}, {from_corner(outline, 3), 1}, {turned_round, 2}, {outline, 3}});
    ASSERT_EQ(tree.size(), 1U);
    EXPECT_EQ(tree[0].polygons.size(), 4U);
  }
}

/// Faces in almost one plane, among others that cut them all.
TEST(BspTree, AreasOfPartsAddUpToTheFaces) {
  const std::uint64_t seed = test::seed();
  std::size_t parts = 0;
  double most = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Random random(seed, i);
    const glm::dmat3 turn = any_turn(random);
    std::vector<std::vector<dvec3>> outlines;
    for (const int corners : {12, 12, 12, 7, 40})
      outlines.push_back(regular(corners, outlines.size() < 3 ? 100 : random.uniform(30, 100), turn));
    for (int k = 0; k < 3; ++k) outlines.push_back(regular(4, 90, any_turn(random)));
    for (std::size_t k = outlines.size(); k > 1; --k)
      std::swap(outlines[k - 1],
                outlines[static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(k) - 1))]);
    std::vector<Polygon<double>> faces;
    for (const auto& outline : outlines) faces.push_back({outline, faces.size()});
    parts += polygon_count(build(faces));
    for (const auto& [face, share] : shares(faces)) {
      EXPECT_NEAR(share, 1, 1e-12) << "seed " << seed << ", case " << i << ", face " << face;
      most = std::max(most, std::abs(share - 1));
    }
  }
  EXPECT_GT(parts, 60U * 20U);
  RecordProperty("most", std::to_string(most));
}

/// An edge on the floor whose three corners rounding has put behind, before and behind it: what stands on the
/// floor stands in front of it all the same.
TEST(BspTree, AnUnevenEdgeDecidesNothing) {
  constexpr double off = 0x1p-50;
  const Polygon<double> floor({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, 0);
  const Polygon<double> wall({{0, 0, -off}, {1, 0, off}, {2, 0, -off}, {3, 0, off}, {3, 0, 1}, {0, 0, 1}}, 1);
  EXPECT_EQ(side_of(sides(floor.plane, wall, ExactSide{})), Side::both);
  double in_front = 0;
  const Tree<double> tree = build(std::vector<Polygon<double>>{floor, wall});
  for (const auto& node : tree)
    for (const auto& part : node.polygons)
      if (&node != &tree[0] && &node == &tree[tree[0].in_front]) in_front += area_of(part.corners);
  EXPECT_NEAR(in_front, 3, 1e-12);
}

}  // namespace
}  // namespace gradus::bsp_tree
