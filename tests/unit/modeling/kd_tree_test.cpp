// Known trees and searches, brute force as the oracle, points that can't be parted, the step grammar,
// refusals.

#include "modeling/kd_tree/kd_tree.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/kd_tree/kd_tree_batch.hpp"
#include "modeling/kd_tree/kd_tree_notes.hpp"
#include "support/documented.hpp"

namespace gradus::kd_tree {
namespace {

using Plane = std::vector<dvec2>;
using Space = std::vector<glm::vec3>;

/// The figures' own: A to L.
const Plane twelve{{5, 6},  {10, 4}, {1, 7}, {9, 8},  {8, 10}, {6, 2},
                   {7, 12}, {7, 5},  {9, 1}, {5, 11}, {2, 10}, {10, 12}};
const dvec2 query{2, 4};
constexpr const char* page = "docs/topics/modeling/kd_tree.md";

/// All of them sorted, nearest first: nothing is left out, and nothing of the header is used.
template <class P>
std::vector<Index> sorted(const std::vector<P>& points, const P& q, std::size_t k) {
  std::vector<std::pair<typename P::value_type, Index>> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const P off = points[i] - q;
    auto sum = unfused(off[0] * off[0]);
    for (int axis = 1; axis < P::length(); ++axis) sum += unfused(off[axis] * off[axis]);
    all.emplace_back(sum, static_cast<Index>(i));
  }
  std::ranges::sort(all);
  std::vector<Index> first;
  for (std::size_t i = 0; i < std::min(k, all.size()); ++i) first.push_back(all[i].second);
  return first;
}
template <class T>
std::vector<Index> indices(const Neighbours<T>& found) {
  std::vector<Index> all;
  for (const Neighbour<T>& n : found) all.push_back(n.point);
  return all;
}

/// As deep as the nodes of a cell go.
std::size_t depth_of(std::size_t nodes) { return nodes == 0 ? 0 : 1 + depth_of(nodes / 2); }

/// The searches of both trees are those of the oracle.
template <int N, class T>
void expect_the_same(const std::vector<Point<N, T>>& points, const std::vector<Point<N, T>>& queries) {
  const auto tree = build<N, T>(points);
  const Buckets<N, T> buckets(points);
  for (const Point<N, T>& q : queries) {
    for (const std::size_t k : {1u, 3u, 8u, 1000u}) {
      const auto right = sorted(points, q, k);
      EXPECT_EQ(indices(nearest<N, T>(tree, q, k)), right);
      EXPECT_EQ(indices(brute_force<N, T>(points, q, k)), right);
      Neighbours<T> found(right.size());
      if (!found.empty()) buckets.nearest(q, found);
      EXPECT_EQ(indices(found), right);
    }
  }
}

TEST(KdTree, TheTreeIsTheKnownOne) {
  const auto tree = build<2, double>(twelve);
  std::string order, axes;
  for (const Node& node : tree.nodes) {
    order += static_cast<char>('A' + static_cast<char>(node.point));
    axes += "xy"[node.axis];
  }
  EXPECT_EQ(order, "FACHIBDKJGEL");
  EXPECT_EQ(axes, "xyxxxyyxxxyy");
  EXPECT_EQ(tree.box, (Rectangle<double>{{1, 1}, {10, 12}}));
}

TEST(KdTree, FiveDistancesAreEnoughForTheNearestOfTwelve) {
  const auto tree = build<2, double>(twelve);
  Recorder<Entered<2, double>, CutOff<2, double>, Measured<double>, Finished> seen;
  const auto found = nearest<2, double>(tree, query, 1, seen);
  EXPECT_EQ(found, (Neighbours<double>{{10, 2}}));
  const auto& done = std::get<Finished>(seen.events().back().step);
  EXPECT_EQ(done.distances, 5);
  EXPECT_EQ(done.cells, 7);
  std::vector<double> measured, cut;
  for (const auto& m : all<Measured<double>>(seen)) measured.push_back(m.found.distance);
  for (const auto& c : all<CutOff<2, double>>(seen)) cut.push_back(c.distance);
  EXPECT_EQ(measured, (std::vector<double>{65, 26, 13, 20, 10}));
  EXPECT_EQ(cut, (std::vector<double>{25, 16}));
}

TEST(KdTree, FindsWhatBruteForceFinds) {
  Random random(1);
  const auto some = [&]<class P>(P, std::size_t count, bool whole) {
    std::vector<P> points(count);
    for (P& p : points) {
      for (int axis = 0; axis < P::length(); ++axis) {
        const double x = random.uniform(-4, 5);
        p[axis] = static_cast<typename P::value_type>(whole ? std::floor(x) : x);
      }
    }
    return points;
  };
  for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 9u, 100u, 700u}) {
    for (const bool whole : {true, false}) {  // whole: many are as near
      expect_the_same<2, double>(some(dvec2{}, count, whole), some(dvec2{}, 12, whole));
      expect_the_same<3, float>(some(glm::vec3{}, count, whole), some(glm::vec3{}, 12, whole));
    }
  }
}

TEST(KdTree, EqualPointsAreFoundByIndexAtBoundedDepth) {
  const Space equal(1000, glm::vec3{1, 2, 3});
  Index deepest = 0;
  std::vector<Index> depth{};
  const auto tree = build<3, float>(equal, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Parted<3, float>>) {
      depth.resize(equal.size());
      const Index parent = step.cell.parent;
      deepest = std::max(deepest, depth[step.cell.middle()] = parent == none ? 1 : depth[parent] + 1);
    }
  });
  EXPECT_EQ(deepest, depth_of(1000));
  EXPECT_EQ(deepest, 10u);
  EXPECT_EQ(indices(nearest<3, float>(tree, {1, 2, 4}, 5)), (std::vector<Index>{0, 1, 2, 3, 4}));
  expect_the_same<3, float>(equal, {{1, 2, 3}, {0, 0, 0}});
}

TEST(KdTree, DistancesThatRoundToTheSameAreEqual) {
  // 1 + 2^-60 rounds to 1: B is nearer than A exactly, and as near as rounded
  const Plane points{{1, 0x1p-30}, {1, 0}, {-1, 0x1p-40}};
  EXPECT_EQ(indices(nearest<2, double>(build<2, double>(points), {0, 0}, 3)), (std::vector<Index>{0, 1, 2}));
  expect_the_same<2, double>(points, {{0, 0}, {0, 0x1p-31}, {0x1p-54, 0}});
}

TEST(KdTree, WhatIsCutOffHoldsNoneAsNear) {
  Random random(2);
  Plane points(300);
  for (dvec2& p : points) p = {random.uniform(-4, 4), random.uniform(-4, 4)};
  const auto tree = build<2, double>(points);
  for (const std::size_t k : {1u, 5u}) {
    Recorder<Entered<2, double>, CutOff<2, double>, Measured<double>, Finished> seen;
    const auto found = nearest<2, double>(tree, query, k, seen);
    EXPECT_EQ(found, (nearest<2, double>(tree, query, k)));
    Index held = 0;
    const auto holds_none = [&](const CutOff<2, double>& cut) {
      held += cut.cell.last - cut.cell.first;
      for (Index node = cut.cell.first; node < cut.cell.last; ++node) {
        const double its = distance<2, double>(tree.at(node), query);
        if (its < cut.distance || !(found.back().distance < its)) return false;
      }
      return true;
    };
    EXPECT_TRUE((every<CutOff<2, double>>(seen, holds_none)));
    // Each point is either measured or cut off
    const auto& done = std::get<Finished>(seen.events().back().step);
    EXPECT_EQ(done.distances + held, std::ssize(points));
    EXPECT_EQ(done.distances, std::ssize(all<Measured<double>>(seen)));
    EXPECT_EQ(done.distances, std::ssize(all<Entered<2, double>>(seen)));
  }
}

TEST(KdTree, EachCellIsPartedAcrossItsLongestSideByItsMedian) {
  Recorder<Parted<2, double>, Built> seen;
  const auto tree = build<2, double>(twelve, seen);
  EXPECT_EQ(tree.nodes, (build<2, double>(twelve).nodes));
  EXPECT_EQ(std::get<Built>(seen.events().back().step).nodes, 12u);
  const auto is_parted_rightly = [&](const Parted<2, double>& p) {
    const dvec2 size = p.cell.box.size();
    const int axis = p.middle.axis;
    bool right = axis == (size.y > size.x ? 1 : 0);
    for (Index node = p.cell.first; node < p.cell.last; ++node) {
      const double its = tree.at(node)[axis], middle = twelve[p.middle.point][axis];
      right = right && (node < p.cell.middle() ? its <= middle : its >= middle);
    }
    return right;
  };
  EXPECT_TRUE((every<Parted<2, double>>(seen, is_parted_rightly)));
}

TEST(KdTree, MistakesMissTheNearest) {
  const auto tree = build<2, double>(twelve);
  const auto lost = no_turning_back<2, double>(tree, query, 1), right = nearest<2, double>(tree, query, 1);
  EXPECT_EQ(lost, (Neighbours<double>{{13, 0}}));
  EXPECT_TRUE(test::states(page, "A is found, {} away, where C is {}.",
                           {std::sqrt(lost[0].distance), std::sqrt(right[0].distance)}));
  // Squares of numbers below 1 are less than they are; above, all is found, and more is searched
  Plane small;
  for (const dvec2 p : twelve) small.push_back(p / 8.0);
  EXPECT_EQ(indices(not_squared<2, double>(build<2, double>(small), query / 8.0, 1)),
            (std::vector<Index>{0}));
  EXPECT_EQ((not_squared<2, double>(tree, query, 1)), right);
}

TEST(KdTree, SearchesComputeAsFewDistancesAsThePageSays) {
  Random random(3);
  const auto place = [&] { return dvec3{random.unit(), random.unit(), random.unit()}; };
  std::vector<dvec3> points(10'000);
  for (dvec3& p : points) p = place();
  const auto tree = build<3, double>(points);
  std::array<double, 2> means{};
  for (int i = 0; i < 1000; ++i) {
    const dvec3 q = place();
    for (const std::size_t eight : {0u, 1u}) {
      const auto count = [&]<class Step>(const Step& step) {
        if constexpr (std::same_as<Step, Finished>)
          means[eight] += static_cast<double>(step.distances) / 1000;
      };
      nearest<3, double>(tree, q, eight == 0 ? 1 : 8, count);
    }
  }
  EXPECT_TRUE(test::states(
      page, "Of {} random points of space a search for one computes {} distances in the mean, for eight {};",
      {static_cast<double>(points.size()), means[0], means[1]}));
}

TEST(KdTree, ItTakesEightBytesForEachPoint) {
  EXPECT_EQ(sizeof(Node), 8u);
  EXPECT_EQ((build<2, double>(twelve).nodes.capacity()), 12u);
}

TEST(KdTree, MistakesAreNamed) {
  const auto refuses = [](const std::function<void()>& call) { EXPECT_THROW(call(), ContractViolation); };
  const auto tree = build<2, double>(twelve);
  constexpr double lost = std::numeric_limits<double>::quiet_NaN();
  refuses([&] { nearest<2, double>(tree, query, 0); });
  refuses([&] { nearest<2, double>(tree, {lost, 0}, 1); });
  refuses([&] { nearest<2, double>(tree, {0x1p510, 0}, 1); });
  refuses([&] { brute_force<2, double>(twelve, query, 0); });
  refuses([&] { build<2, double>(Plane{{0, lost}}); });
  refuses([&] { build<3, float>(Space{{0, 0, 0x1p62f}}); });
  refuses([&] { (Buckets<2, double>(Plane{{std::numeric_limits<double>::infinity(), 0}})); });
  Neighbours<double> room(13);
  refuses([&] { Buckets<2, double>(twelve).nearest(query, room); });
  refuses([&] { Buckets<2, double>(twelve).nearest(query, {}); });
}

}  // namespace
}  // namespace gradus::kd_tree
