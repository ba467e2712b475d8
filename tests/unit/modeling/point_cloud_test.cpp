// Planes and a ball of known normals, brute force for the neighbours, clouds that are moved and turned,
// every pixel of depth images there and back, dots against a search of each pixel, refusals.

#include "modeling/point_cloud/point_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/point_cloud/point_cloud_notes.hpp"
#include "support/documented.hpp"

namespace gradus::point_cloud {
namespace {

using Points = std::vector<dvec3>;
constexpr const char* page = "docs/topics/modeling/point_cloud.md";
constexpr double pi = 3.14159265358979323846;

/// Evenly over the ball of radius 1: the same height for each, a golden angle on from point to point.
Points on_ball(std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count),
                 r = std::sqrt(1 - y * y), turn = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
    points.emplace_back(r * gradus::cos(turn), y, r * gradus::sin(turn));
  }
  return points;
}
Points some(Random& random, std::size_t count) {
  Points points(count);
  for (dvec3& p : points) p = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return points;
}
Points moved(Points points, dvec3 way) {
  for (dvec3& p : points) p += way;
  return points;
}
Normal<double> normal_in(const Points& points, Index i, std::size_t k, dvec3 eye) {
  return normal(kd_tree::build<3, double>(points), i, k, eye);
}
/// Between two directions of length 1, in degrees.
double degrees(dvec3 a, dvec3 b) {
  return gradus::asin(std::min(1.0, length_of(glm::cross(a, b)))) * 180 / pi;
}

TEST(PointCloud, PlanesAcrossAnAxisHaveExactNormals) {
  Random random(1);
  for (const int axis : {0, 1, 2}) {
    for (const double height : {0.0, 0.1, 1e6, -3e-7, 0x1p300}) {
      Points flat = some(random, 60);
      for (dvec3& p : flat) p[axis] = height;
      dvec3 up{0};
      up[axis] = 1;
      const auto tree = kd_tree::build<3, double>(flat);
      for (Index i = 0; i < flat.size(); ++i) {
        const dvec3 far = dvec3(0x1p301) * up;
        EXPECT_EQ(normal(tree, i, 8, far).way, up);
        EXPECT_EQ(normal(tree, i, 8, -far).way, -up);
        EXPECT_EQ(normal(tree, i, 8, far).variance[0], 0);
      }
    }
  }
}

TEST(PointCloud, ASlantedPlaneHasItsNormalFarFromTheOrigin) {
  Random random(2);
  const dvec3 along = unit_vector(dvec3{2, 1, 3}), across = unit_vector(glm::cross(along, dvec3{0, 1, 0})),
              right = glm::cross(across, along);
  for (const double far : {0.0, 1.0, 1e3, 1e6}) {
    Points flat;
    for (const dvec3 p : some(random, 80)) flat.push_back(p.x * along + p.y * across + dvec3(far));
    double worst = 0;
    for (const auto& n : normals<double>(flat, 10, dvec3(far) + right)) {
      EXPECT_EQ(n.shape, Shape::surface);
      EXPECT_GT(glm::dot(n.way, right), 0);
      worst = std::max(worst, length_of(glm::cross(n.way, right)));
    }
    // The points themselves are as far off the plane as the rounding of their coordinates
    EXPECT_LT(worst, 1e-14 * (1 + 4 * far));
  }
}

TEST(PointCloud, ABallsNormalsAreThoseOfItsPoints) {
  const Points ball = on_ball(1000);
  std::array<double, 2> worst{};
  for (const std::size_t which : {0u, 1u}) {
    const auto found = normals<double>(ball, which == 0 ? 6 : 12, {0, 0, 0});
    for (std::size_t i = 0; i < ball.size(); ++i) {
      ASSERT_EQ(found[i].shape, Shape::surface);
      EXPECT_LT(glm::dot(found[i].way, ball[i]), 0);  // towards the eye in the middle
      worst[which] = std::max(worst[which], degrees(found[i].way, ball[i]));
    }
  }
  EXPECT_TRUE(test::states(
      page, "Of 1000 points spread over a ball normals of 6 neighbours are up to {}° off, of 12 up to {}°.",
      {worst[0], worst[1]}));
}

TEST(PointCloud, NeighboursAreThoseOfBruteForce) {
  Random random(3);
  for (const bool whole : {true, false}) {  // whole: many are as near
    Points points = some(random, 200);
    for (dvec3& p : points) {
      if (whole) p = glm::floor(3.0 * p);
    }
    const auto tree = kd_tree::build<3, double>(points);
    for (Index i = 0; i < points.size(); i += 7) {
      for (const std::size_t k : {1u, 3u, 8u, 300u}) {
        Recorder<Gathered<double>, Centred<double>, Fitted<double>, Turned<double>> seen;
        normal(tree, i, k, {9, 9, 9}, seen);
        EXPECT_EQ(all<Gathered<double>>(seen).at(0).near,
                  (kd_tree::brute_force<3, double>(points, points[i], k)));
      }
    }
  }
}

TEST(PointCloud, StepsFollowTheGrammarAndObserversOnlyLook) {
  const Points ball = on_ball(100);
  const auto tree = kd_tree::build<3, double>(ball);
  Recorder<Gathered<double>, Centred<double>, Fitted<double>, Turned<double>> seen;
  const auto watched = normal(tree, 5, 8, {3, 3, 3}, seen), alone = normal(tree, 5, 8, {3, 3, 3});
  EXPECT_EQ(watched.way, alone.way);
  EXPECT_EQ(watched.variance, alone.variance);
  ASSERT_EQ(seen.seen(), 4u);
  for (std::size_t step = 0; step < 4; ++step) EXPECT_EQ(seen.events()[step].step.index(), step);
  const auto fitted = all<Fitted<double>>(seen)[0];
  const auto turned = all<Turned<double>>(seen)[0];
  EXPECT_EQ(turned.normal, turned.turned ? -fitted.ways[0] : fitted.ways[0]);
  EXPECT_GE(glm::dot(turned.normal, dvec3(3) - ball[5]), 0);
  // The middle is that of the offsets, and the axes lie across each other
  const auto D = offsets(tree, all<Gathered<double>>(seen)[0].near, ball[5]);
  EXPECT_EQ(all<Centred<double>>(seen)[0].mean, mean(D));
  for (const std::size_t i : {0u, 1u, 2u}) {
    EXPECT_NEAR(glm::dot(fitted.ways[i], fitted.ways[i]), 1, 1e-15);
    EXPECT_NEAR(glm::dot(fitted.ways[i], fitted.ways[(i + 1) % 3]), 0, 1e-15);
    // The variance along each is the mean square of what they have of it
    double sum = 0;
    for (const dvec3 d : D) sum += std::pow(glm::dot(d - mean(D), fitted.ways[i]), 2) / 8;
    EXPECT_NEAR(sum, fitted.variance[i], 1e-16);
  }
}

TEST(PointCloud, WhatHasNoNormalIsSaidByName) {
  const auto shape = [](const Points& points, std::size_t k = 99) {
    const auto n = normal_in(points, 0, k, {5, 6, 7});
    EXPECT_EQ(n.way == dvec3{0}, n.shape != Shape::surface);
    return n.shape;
  };
  const Points cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (const double far : {0.0, 0.1, 1e5}) {
    for (const double size : {1.0, 0.1, 1e-3}) {
      const auto at = [&](Points points) {
        for (dvec3& p : points) p = size * p + dvec3(far);
        return points;
      };
      EXPECT_EQ(shape(at({{1, 2, 3}})), Shape::one_place);
      EXPECT_EQ(shape(at(Points(20, {1, 2, 3}))), Shape::one_place);
      EXPECT_EQ(shape(at({{1, 2, 3}, {3, 2, 1}})), Shape::in_line);
      EXPECT_EQ(shape(at(cube), 1), Shape::one_place);
      EXPECT_EQ(shape(at({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}})), Shape::surface);
    }
  }
  // Exact on a line, and as near to it as coordinates are to tenths
  EXPECT_EQ(shape({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {5, 10, 15}}), Shape::in_line);
  EXPECT_EQ(shape({{0, 0, 0}, {0.1, 0.3, 0.7}, {0.2, 0.6, 1.4}, {0.3, 0.9, 2.1}}), Shape::in_line);
  // A cube spreads alike in all directions, a long box of squares in two
  EXPECT_EQ(shape(cube), Shape::alike);
  Points rod = cube;
  for (dvec3& p : rod) p.z *= 9;
  EXPECT_EQ(shape(rod), Shape::alike);
  for (dvec3& p : rod) p.x *= 1.0001;
  EXPECT_EQ(shape(rod), Shape::surface);
}

TEST(PointCloud, NeitherSizeNorPlaceMatters) {
  Random random(4);
  Points points = some(random, 60);
  for (dvec3& p : points) p = glm::round(64.0 * p);  // whole numbers: nothing is rounded below
  const auto own = normals<double>(points, 9, {500, 600, 700});
  for (const double size : {1.0, 0x1p-400, 0x1p400}) {
    for (const dvec3 way : {dvec3{0}, dvec3{4096, -1024, 8}, dvec3{0x1p40, 0, -0x1p40}}) {
      Points other = moved(points, way);
      for (dvec3& p : other) p *= size;
      const auto found = normals<double>(other, 9, size * (dvec3{500, 600, 700} + way));
      for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_EQ(found[i].way, own[i].way);
        EXPECT_EQ(found[i].shape, own[i].shape);
      }
    }
  }
}

// Their mean has no digits to spare: rounded, it lies beside the plane that they lie near.
TEST(PointCloud, TheSmallestNumbersHaveTheNormalsOfLargeOnes) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    Points large(7);
    for (dvec3& p : large)
      p = dvec3(random.uniform_int(-900, 900), random.uniform_int(-900, 900), random.uniform_int(-4, 4));
    Points small = large;
    for (dvec3& p : small) p *= smallest;
    const dvec3 eye{0.1, 0.2, 5000};
    const Normal<double> from = normal_in(large, 0, 7, eye), found = normal_in(small, 0, 7, eye);
    ASSERT_EQ(from.shape, Shape::surface);
    ASSERT_EQ(found.shape, Shape::surface);
    EXPECT_LE(degrees(from.way, found.way), 1e-9) << i;
  }
}

TEST(PointCloud, DepthsGoThereAndBack) {
  std::int64_t pixels = 0;
  const auto there_and_back = [&]<class T>(T, ivec2 size, glm::vec<2, T> centre, T focal, T z) {
    const Pinhole<T> camera{focal, centre};
    Raster<T> depth(size.x, size.y, z);
    Random random(5);
    for (T& one : depth.cells()) one = z * static_cast<T>(random.uniform(1, 2));
    const auto points = back_project(depth, camera);
    ASSERT_EQ(points.size(), depth.cells().size());
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i, ++pixels) {
        const auto& p = points[static_cast<std::size_t>(j * size.x + i)];
        ASSERT_EQ(p.z, (depth[{i, j}]));
        ASSERT_EQ(project(camera, p), (ivec2{i, j})) << focal << " " << z;
      }
    }
  };
  for (const ivec2 size : {ivec2{1, 1}, ivec2{7, 5}, ivec2{63, 31}, ivec2{3, 2049}}) {
    for (const double part : {0.5, 0.0, 1.0, 0.377}) {
      const dvec2 centre = part * dvec2(size);
      for (const int focal : {-40, -7, 0, 5, 39}) {
        for (const int z : {-40, 0, 3, 39}) {
          there_and_back(0.0f, size, glm::vec2(centre), std::ldexp(1.37f, focal), std::ldexp(1.0f, z));
          there_and_back(0.0, size, centre, std::ldexp(1.37, 10 * focal), std::ldexp(1.0, 10 * z));
        }
      }
    }
  }
  // The largest picture, its corners, with the centre at the other end
  Raster<float> wide(most_pixels, 1, 3.7f);
  const Pinhole<float> camera{0.1f, {-static_cast<float>(most_pixels), 0.5f}};
  const auto points = back_project(wide, camera);
  for (int i = 0; i < most_pixels; ++i, ++pixels)
    ASSERT_EQ(project(camera, points[static_cast<std::size_t>(i)]), (ivec2{i, 0}));
  EXPECT_TRUE(test::states(page, "came back as themselves for all of {} pixels of odd sizes",
                           {static_cast<double>(pixels)}));
}

TEST(PointCloud, APixelsPlaceIsTheKnownOne) {
  Raster<double> depth(4, 3, 0);
  depth[{3, 0}] = 5;
  depth[{0, 2}] = 2;
  const Pinhole<double> camera{2, {2, 1.5}};
  Recorder<BackProjected<double>, Hole, Finished> seen;
  const auto points = back_project(depth, camera, seen);
  EXPECT_EQ(points, (Points{{3.75, 2.5, 5}, {-1.5, -1, 2}}));
  EXPECT_EQ(all<Hole>(seen).size(), 10u);
  EXPECT_EQ(all<BackProjected<double>>(seen)[0].pixel, (ivec2{3, 0}));
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).points, 2u);
}

TEST(PointCloud, DotsAreTheNearestPointsOfEachPixel) {
  Random random(6);
  Points points;
  for (int i = 0; i < 60; ++i)
    points.emplace_back(random.uniform(-3, 15), random.uniform(-3, 11), random.uniform_int(0, 4));
  for (const int radius : {0, 1, 3}) {
    std::size_t told = 0;
    const auto count = [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Drawn>) told += step.point == told ? 1u : 0u;
    };
    const auto front = draw<double>(points, {12, 8}, radius, count);
    EXPECT_EQ(told, points.size());
    EXPECT_EQ(front, (draw<double>(points, {12, 8}, radius)));
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 12; ++x) {
        Index nearest = none;
        for (Index i = 0; i < points.size(); ++i) {
          const ivec2 off = ivec2(glm::floor(dvec2(points[i]))) - ivec2{x, y};
          if (std::abs(off.x) > radius || std::abs(off.y) > radius) continue;
          if (nearest == none || points[i].z < points[nearest].z) nearest = i;
        }
        EXPECT_EQ((front[{x, y}]), nearest);
      }
    }
  }
  // Far away nothing is drawn, and nothing overflows
  const auto bare = draw<double>(Points{{1e300, 0, 0}, {0, -1e300, 0}}, {4, 4}, 1 << 20);
  EXPECT_EQ(std::ranges::count(bare.cells(), none), 16);
}

TEST(PointCloud, ZoomShowsGaps) {
  // A square of 64 x 64 points that fills 64 x 64 pixels; four times as near every second one each way is
  // bare
  Points grid;
  for (int i = 0; i < 64 * 64; ++i) grid.emplace_back(i % 64 + 0.5, i / 64 + 0.5, 1);
  const auto covered = [&](double zoom, int radius) {
    Points near = grid;
    for (dvec3& p : near) p = {zoom * (p.x - 32) + 32, zoom * (p.y - 32) + 32, 1};
    const auto front = draw<double>(near, {64, 64}, radius);
    return 64 * 64 - std::ranges::count(front.cells(), none);
  };
  EXPECT_EQ(covered(1, 0), 4096);
  EXPECT_EQ(covered(2, 0), 1024);
  EXPECT_EQ(covered(4, 0), 256);
  EXPECT_EQ(covered(2, 1), 4096);  // larger dots close them, until the next zoom
  EXPECT_EQ(covered(4, 1), 2304);
  EXPECT_TRUE(test::states(
      page, "leave {} of 4096 bare at zoom 2, {} at zoom 4;",
      {4096.0 - static_cast<double>(covered(2, 0)), 4096.0 - static_cast<double>(covered(4, 0))}));
}

TEST(PointCloud, AttributesAreListed) {
  Cloud<float> cloud{.places = {{1, 2, 3}}};
  EXPECT_EQ(attributes(cloud), (std::vector<Attribute>{{"position", 12}}));
  cloud.colours = {{255, 0, 0}};
  cloud.normals = {{0, 0, 1}};
  EXPECT_EQ(attributes(cloud), (std::vector<Attribute>{{"position", 12}, {"colour", 4}, {"normal", 12}}));
}

TEST(PointCloud, MistakesTurnNormals) {
  const Points ball = on_ball(1000), away = moved(ball, {30, 0, 0});
  const auto tree = kd_tree::build<3, double>(away);
  const dvec3 eye{30, 0, 9};
  double right_angle = 0, mean_angle = 0;
  std::size_t turned = 0;
  for (Index i = 0; i < ball.size(); ++i) {
    const auto right = normal(tree, i, 10, eye);
    mean_angle += degrees(uncentred(tree, i, 10, eye).way, ball[i]) / 1000;
    right_angle += degrees(right.way, ball[i]) / 1000;
    turned += glm::dot(unturned(tree, i, 10, eye).way, right.way) < 0 ? 1u : 0u;
  }
  EXPECT_TRUE(test::states(
      page, "30 radii from the origin get normals {}° off in the mean, where right ones are {}° off.",
      {mean_angle, right_angle}));
  EXPECT_TRUE(
      test::states(page, "of 1000 normals {} point away from the eye.", {static_cast<double>(turned)}));
}

TEST(PointCloud, ASearchCostsAsMuchAsThePageSays) {
  const Points ball = on_ball(10'000);
  const auto tree = kd_tree::build<3, double>(ball);
  double distances = 0;
  for (Index i = 0; i < ball.size(); i += 10) {
    const auto count = [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, kd_tree::Finished>)
        distances += static_cast<double>(step.distances) / 1000;
    };
    kd_tree::nearest<3, double>(tree, ball[i], 10, count);
  }
  EXPECT_TRUE(test::states(
      page,
      "Of 10000 points of a ball a search for ten computes {} distances in the mean, brute force 10000.",
      {distances}));
  EXPECT_TRUE(test::states(page, "in double {} bytes a position, {} a normal, and {} for the tree's node.",
                           {double{sizeof(dvec3)}, double{sizeof(dvec3)}, double{sizeof(kd_tree::Node)}}));
}

TEST(PointCloud, MistakesAreNamed) {
  const auto refuses = [](const std::function<void()>& call) { EXPECT_THROW(call(), ContractViolation); };
  const Points ball = on_ball(20);
  const auto tree = kd_tree::build<3, double>(ball);
  constexpr double lost = std::numeric_limits<double>::quiet_NaN();
  refuses([&] { normal(tree, 20, 3, {0, 0, 0}); });
  refuses([&] { normal(tree, 0, 0, {0, 0, 0}); });
  refuses([&] { normal(tree, 0, 3, {lost, 0, 0}); });
  refuses([&] { normals<double>(Points{{0, 0, lost}}, 3, {0, 0, 0}); });
  const Pinhole<double> camera{2, {2, 2}};
  refuses([&] { back_project(Raster<double>(2, 2, -1), camera); });
  refuses([&] { back_project(Raster<double>(2, 2, lost), camera); });
  refuses([&] { back_project(Raster<double>(2, 2, 1), {0, {2, 2}}); });
  refuses([&] { back_project(Raster<double>(2, 2, 1), {1, {1e6, 2}}); });
  refuses([&] { back_project(Raster<double>(most_pixels + 1, 1, 1), camera); });
  refuses([&] { project(camera, dvec3{0, 0, -1}); });
  refuses([&] { draw<double>(Points{{0, lost, 0}}, {4, 4}, 0); });
  refuses([&] { draw<double>(ball, {4, 4}, -1); });
}

}  // namespace
}  // namespace gradus::point_cloud
