// The order of an octree's cells: nothing hides what came before it, whatever the eye.

#include "visibility/octree_order/octree_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "core/random.hpp"
#include "core/record.hpp"
#include "support/sanitized.hpp"

namespace gradus::octree_order {
namespace {

using C = Cell<double>;
constexpr C root{{-4, -4, -4}, 8};

/// All cells of this depth.
auto until(int depth) {
  return [depth](const C& cell) { return cell.depth < depth; };
}
/// A split that depends on the place alone: some branches are deep, others are not.
bool uneven(const C& cell) {
  if (cell.depth >= 5) return false;
  const dvec3 m = middle_of(cell);
  return cell.depth < 1 || (static_cast<int>(m.x * 3 + m.y * 5 + m.z * 7) & 3) != 0;
}

template <class Split>
std::vector<C> order_of(dvec3 at, double w, const Split& split) {
  std::vector<C> order;
  front_to_back(root, Eye<double>(at, w), split, [&](const C& cell) { order.push_back(cell); });
  return order;
}

TEST(OctreeOrder, TheEyesOctantComesFirstAndTheOneAcrossLast) {
  const auto order = order_of({3, 9, -7}, 1, until(1));
  ASSERT_EQ(order.size(), 8u);
  EXPECT_EQ(order.front(), (C{{0, 0, -4}, 4, 1}));
  EXPECT_EQ(order.back(), (C{{-4, -4, 0}, 4, 1}));
}

TEST(OctreeOrder, InsideTheEyesOwnCellIsFirst) {
  const dvec3 eye{0.3, -1.7, 2.6};
  const auto order = order_of(eye, 1, until(4));
  EXPECT_EQ(order.size(), 4096u);
  const C first = order.front();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(first.lower[axis], eye[axis]);
    EXPECT_LE(eye[axis], first.lower[axis] + first.side);
  }
}

/// Where the ray eye + t way is inside a cell: t from and to; nothing where it misses, or only touches.
std::optional<std::pair<double, double>> inside(const C& cell, dvec3 eye, dvec3 way) {
  double from = 0, to = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (cell.lower[axis] - eye[axis]) / way[axis],
                 b = (cell.lower[axis] + cell.side - eye[axis]) / way[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (to - from < 1e-9) return std::nullopt;
  return std::pair(from, to);
}

TEST(OctreeOrder, AlongEveryRayCellsComeInTheirOrder) {
  const std::uint64_t seed = 20261124;
  SCOPED_TRACE(seed);
  Random random(seed);
  int met = 0;
  for (int run = 0; run < (test::sanitized ? 15 : 60); ++run) {
    // Outside, inside, and on planes of the tree
    dvec3 eye{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    if (run % 3 == 0) eye = glm::floor(eye);
    if (run % 5 == 0) eye = eye / 4.0;
    const auto order = order_of(eye, 1, uneven);
    for (int k = 0; k < 40; ++k) {
      const dvec3 way{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      double reached = -1;
      for (const C& cell : order) {
        const auto span = inside(cell, eye, way);
        if (!span) continue;
        ++met;
        EXPECT_GE(span->first, reached - 1e-9);
        reached = span->second;
      }
    }
  }
  EXPECT_GT(met, test::sanitized ? 1250 : 5000);
}

TEST(OctreeOrder, FromFarAwayAnEyeIsADirection) {
  // The order along a direction is that for an eye far out in it
  const dvec3 way{0.3, -0.9, 0.2};
  EXPECT_EQ(order_of(way, 0, uneven), order_of(1e6 * way, 1, uneven));
}

TEST(OctreeOrder, BackToFrontIsTheOtherWayRound) {
  for (const dvec3 eye : {dvec3{3, 9, -7}, {0.1, 0.2, 0.3}, {0, 0, 0}}) {
    auto order = order_of(eye, 1, uneven);
    std::vector<C> back;
    back_to_front(root, Eye<double>(eye, 1), uneven, [&](const C& cell) { back.push_back(cell); });
    std::ranges::reverse(order);
    EXPECT_EQ(order, back);
  }
}

TEST(OctreeOrder, EveryLeafOnceAndNoneLeftOut) {
  const auto order = order_of({1, 2, 30}, 1, uneven);
  double volume = 0;
  std::set<std::array<double, 3>> lowers;
  for (const C& cell : order) {
    volume += cell.side * cell.side * cell.side;
    EXPECT_TRUE(lowers.insert({cell.lower.x, cell.lower.y, cell.lower.z}).second);
  }
  EXPECT_EQ(volume, 512);
}

TEST(OctreeOrder, StepsTellTheWalk) {
  std::vector<C> entered, visited;
  Finished done{};
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Entered<double>>) entered.push_back(s.cell);
    if constexpr (std::same_as<Step, Visited<double>>) {
      visited.push_back(s.cell);
      EXPECT_EQ(s.number, std::ssize(visited));
    }
    if constexpr (std::same_as<Step, Finished>) done = s;
  };
  std::vector<C> order;
  front_to_back(root, Eye<double>(1, 2, 30, 1), uneven, [&](const C& cell) { order.push_back(cell); }, watch);
  EXPECT_EQ(order, visited);
  EXPECT_EQ(order, order_of({1, 2, 30}, 1, uneven));
  EXPECT_EQ(done.cells, std::ssize(visited));
  // Each cell with children adds seven leaves
  EXPECT_EQ(done.cells, 7 * std::ssize(entered) + 1);
  EXPECT_EQ(done.compared, 3 * std::ssize(entered));
}

TEST(OctreeOrder, CellsThatAreNeverDoneEnd) {
  int deep = 0;
  const auto split = [&](const C& cell) {
    deep = std::max(deep, cell.depth);
    return cell.lower == root.lower;  // one branch without an end
  };
  EXPECT_EQ(order_of({9, 9, 9}, 1, split).size(), 7u * deepest + 1);
  EXPECT_EQ(deep, deepest - 1);
}

TEST(OctreeOrder, RefusesWhatIsNoCube) {
  const auto drop = [](const C&) {};
  EXPECT_THROW(front_to_back(C{{0, 0, 0}, 0}, Eye<double>(1, 1, 1, 1), uneven, drop), ContractViolation);
  EXPECT_THROW(front_to_back(C{{0, 0, 0}, -1}, Eye<double>(1, 1, 1, 1), uneven, drop), ContractViolation);
  EXPECT_THROW(back_to_front(root, Eye<double>(1, 1, 1, 2), uneven, drop), ContractViolation);
}

}  // namespace
}  // namespace gradus::octree_order
