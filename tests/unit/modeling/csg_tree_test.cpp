// Known results, the step grammar, refusals, volumes against closed forms, and what the page counts. What
// holds for every tree is a promise: tests/stress.

#include "modeling/csg_tree/csg_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/csg_tree/csg_tree_notes.hpp"
#include "modeling/csg_tree/skipping.hpp"
#include "support/documented.hpp"
#include "support/sanitized.hpp"

namespace gradus::csg_tree {
namespace {

using Solids = std::vector<Solid<double>>;
using test::states;
using DNodes = Nodes<double>;
using DEnds = Ends<double>;

constexpr const char* page = "docs/topics/modeling/csg_tree.md";

const Ray<double> along_x{{0, 4, 0}, {1, 0, 0}, 20};

DNodes two(Op op, const Solid<double>& a, const Solid<double>& b) {
  DNodes tree;
  add_leaf(tree, a);
  add_leaf(tree, b);
  add_node(tree, op, 0, 1);
  return tree;
}
/// ((plate or head) without hole) and what lies beyond a slanted plane: the page's lever.
DNodes lever() {
  DNodes tree;
  const Index plate = add_leaf<double>(tree, Box<double>{{2, 2, -1}, {13, 6, 1}});
  const Index head = add_leaf<double>(tree, Ball<double>{{14, 4, 0}, 4});
  const Index whole = add_node(tree, Op::unite, plate, head);
  const Index hole = add_leaf<double>(tree, Cylinder<double>{{14, 4, 0}, 2, 2});
  const Index drilled = add_node(tree, Op::subtract, whole, hole);
  const Index plane = add_leaf<double>(tree, HalfSpace<double>{{-2, -1, 0}, {4, 4, 0}});
  add_node(tree, Op::intersect, drilled, plane);
  return tree;
}

TEST(CsgTree, TheLeverByHand) {
  const DNodes tree = lever();
  Recorder<LeafHit<double>, NodeMerged<double>> seen;
  EXPECT_EQ(along_ray<double>(tree, along_x, seen), (DEnds{4, 12, 16, 18}));
  EXPECT_EQ(along_ray<double>(tree, along_x), (DEnds{4, 12, 16, 18}));
  const auto leaves = all<LeafHit<double>>(seen);
  const auto merges = all<NodeMerged<double>>(seen);
  ASSERT_EQ(leaves.size(), 4u);
  ASSERT_EQ(merges.size(), 3u);
  EXPECT_EQ(leaves[0].ends, (DEnds{2, 13}));
  EXPECT_EQ(leaves[1].ends, (DEnds{10, 18}));
  EXPECT_EQ(merges[0].ends, (DEnds{2, 18}));
  EXPECT_EQ(merges[1].ends, (DEnds{2, 12, 16, 18}));
  EXPECT_EQ(leaves[3].ends, (DEnds{4, 20}));
}

TEST(CsgTree, PointsOfTheLever) {
  const DNodes tree = lever();
  Recorder<LeafTested, Combined> seen;
  EXPECT_FALSE(contains<double>(tree, {13, 5, 0}, seen));
  EXPECT_TRUE(contains<double>(tree, {8, 4, 0}));
  EXPECT_EQ(all<LeafTested>(seen).size(), 4u);
  EXPECT_TRUE(every<Combined>(seen, [](const Combined& c) { return c.in == apply(c.op, c.a, c.b); }));
  // Where the hole begins the plate ends, where it ends the head begins again
  EXPECT_FALSE(contains<double>(tree, {12, 4, 0}));
  EXPECT_TRUE(contains<double>(tree, {16, 4, 0}));
}

TEST(CsgTree, FlushBoxesMeetWithoutACrackInBothOrders) {
  const Box<double> left{{3, 0, 0}, {10, 8, 8}}, right{{10, 0, 0}, {17, 8, 8}};
  for (const bool turned : {false, true}) {
    const Solid<double> a = turned ? right : left, b = turned ? left : right;
    EXPECT_EQ(along_ray<double>(two(Op::unite, a, b), along_x), (DEnds{3, 17}));
    EXPECT_EQ(along_ray<double>(two(Op::intersect, a, b), along_x), DEnds{});
    const auto rest = along_ray<double>(two(Op::subtract, a, b), along_x);
    EXPECT_EQ(rest, turned ? (DEnds{10, 17}) : (DEnds{3, 10}));
    // Each point of the common face belongs to one of them
    EXPECT_TRUE(contains<double>(two(Op::unite, a, b), {10, 4, 4}));
    EXPECT_FALSE(contains<double>(two(Op::intersect, a, b), {10, 4, 4}));
    EXPECT_EQ(contains<double>(two(Op::subtract, a, b), {10, 4, 4}), turned);
  }
  // A ray in the common face is in one of the boxes, too
  const Ray<double> in_face{{10, 4, -1}, {0, 0, 1}, 20};
  EXPECT_EQ(along_ray<double>(two(Op::unite, left, right), in_face), (DEnds{1, 9}));
  EXPECT_EQ(along_ray<double>(two(Op::intersect, left, right), in_face), DEnds{});
}

TEST(CsgTree, AHalfSpaceAndABoxShareAFace) {
  const Box<double> box{{3, 0, 0}, {10, 8, 8}};
  const HalfSpace<double> beyond{{-1, 0, 0}, {10, 0, 0}};
  EXPECT_EQ(along_ray<double>(two(Op::unite, box, beyond), along_x), (DEnds{3, 20}));
  EXPECT_EQ(along_ray<double>(two(Op::subtract, box, beyond), along_x), (DEnds{3, 10}));
  EXPECT_EQ(along_ray<double>(two(Op::subtract, beyond, box), along_x), (DEnds{10, 20}));
}

TEST(CsgTree, EmptyAndWholeResults) {
  const Ball<double> ball{{8, 4, 0}, 4}, far{{8, 40, 0}, 4}, none{{8, 4, 0}, 0};
  EXPECT_EQ(along_ray<double>(two(Op::subtract, ball, ball), along_x), DEnds{});
  EXPECT_EQ(along_ray<double>(two(Op::intersect, ball, far), along_x), DEnds{});
  EXPECT_EQ(along_ray<double>(two(Op::unite, none, none), along_x), DEnds{});
  EXPECT_FALSE(contains<double>(two(Op::unite, none, none), {8, 4, 0}));
  // Touched in a point: no part of the ray is inside
  EXPECT_EQ(along_ray<double>(two(Op::unite, Ball<double>{{8, 8, 0}, 4}, none), along_x), DEnds{});
  // Along a cylinder's axis all or nothing is inside
  EXPECT_EQ(along_ray<double>(two(Op::unite, Cylinder<double>{{0, 4, 1}, 2, 0}, none), along_x),
            (DEnds{0, 20}));
  EXPECT_EQ(along_ray<double>(two(Op::unite, Cylinder<double>{{0, 8, 1}, 2, 0}, none), along_x), DEnds{});
}

/// V(A), V(B), V(A or B), V(A and B) of two solids in a box.
struct Volumes {
  double a, b, either, both;
};
Volumes volumes_of(const Solid<double>& a, const Solid<double>& b, const Box<double>& box, int n) {
  const DNodes one = two(Op::unite, a, a), other = two(Op::unite, b, b);
  return {volume<double>(one, box, n), volume<double>(other, box, n),
          volume<double>(two(Op::unite, a, b), box, n), volume<double>(two(Op::intersect, a, b), box, n)};
}

TEST(CsgTree, ALensHasTheVolumeOfItsFormula) {
  const double r = 5, d = 6;
  const Solid<double> a = Ball<double>{{0, 0, 0}, r}, b = Ball<double>{{0, d, 0}, r};
  const Volumes v = volumes_of(a, b, {{-12, -12, -12}, {12, 12, 12}}, 200);
  const double lens = std::numbers::pi / 12 * (4 * r + d) * (2 * r - d) * (2 * r - d);
  EXPECT_NEAR(v.both / lens, 1, 1e-3);
  EXPECT_NEAR((v.a + v.b) / (v.either + v.both), 1, 1e-12);
  EXPECT_TRUE(states(page, "lens of two balls within {} ‰", {1e3 * std::abs(v.both / lens - 1)}));
}

TEST(CsgTree, VolumesAddUpWhereFacesCoincide) {
  const Box<double> whole{{0, 0, 0}, {8, 8, 8}};
  const Solid<double> left = Box<double>{{1, 1, 1}, {4, 7, 7}}, right = Box<double>{{4, 1, 1}, {7, 7, 7}};
  const Volumes v = volumes_of(left, right, whole, 64);
  EXPECT_EQ(v.both, 0);
  EXPECT_NEAR(v.a + v.b, v.either, 1e-12 * v.either);
  EXPECT_NEAR(v.either, 216, 1e-9);
  EXPECT_EQ(volume<double>(two(Op::subtract, left, right), whole, 64), v.a);
  EXPECT_EQ(volume<double>(two(Op::subtract, right, left), whole, 64), v.b);
}

TEST(CsgTree, AChangedLeafRenewsItsWayToTheRootAlone) {
  Evaluation<double> e = evaluated<double>(lever(), along_x);
  const std::vector<DEnds> before = e.on;
  Recorder<Reused, Renewed<double>, Restored<double>> seen;
  const Undo<double> undo = change<double>(e, 3, Cylinder<double>{{14, 4, 0}, 3, 2}, seen);
  const auto renewed = all<Renewed<double>>(seen);
  ASSERT_EQ(renewed.size(), 3u);
  EXPECT_EQ(all<Reused>(seen).size(), 4u);
  EXPECT_EQ(renewed[0].node, 3u);
  EXPECT_EQ(renewed[1].node, 4u);
  EXPECT_EQ(renewed[2].node, 6u);
  EXPECT_EQ(e.on.back(), (DEnds{4, 11, 17, 18}));
  EXPECT_EQ(e.on, evaluated<double>(e.tree, along_x).on);
  restore<double>(e, undo, seen);
  EXPECT_EQ(e.on, before);
  EXPECT_EQ(all<Restored<double>>(seen).size(), 3u);
  EXPECT_TRUE(states(page, "of the {} nodes of the example a larger hole asks for {}",
                     {static_cast<double>(e.tree.size()), static_cast<double>(renewed.size())}));
}

TEST(CsgTree, WhatComesOutAlikeRenewsNothingAbove) {
  Evaluation<double> e = evaluated<double>(lever(), along_x);
  Recorder<Reused, Renewed<double>> seen;
  // The plate's end within the head moves
  change<double>(e, 0, Box<double>{{2, 2, -1}, {15, 6, 1}}, seen);
  const auto renewed = all<Renewed<double>>(seen);
  ASSERT_EQ(renewed.size(), 2u);
  EXPECT_EQ(renewed[1].before, renewed[1].now);
  EXPECT_EQ(e.on.back(), (DEnds{4, 12, 16, 18}));
}

/// A picture: of each of 24 x 24 rays along x its ends.
std::vector<DEnds> picture_of(const DNodes& tree) {
  std::vector<DEnds> picture;
  for (int i = 0; i < 24; ++i) {
    for (int k = 0; k < 24; ++k)
      picture.push_back(along_ray<double>(tree, {{0, i / 3.0, (k - 12) / 8.0}, {1, 0, 0}, 20}));
  }
  return picture;
}

TEST(CsgTree, WithoutTheLastNodeThePictureIsTheEarlierOne) {
  DNodes tree = lever();
  tree.resize(5);
  const std::vector<DEnds> earlier = picture_of(tree);
  add_leaf<double>(tree, HalfSpace<double>{{-2, -1, 0}, {4, 4, 0}});
  add_node(tree, Op::intersect, 4, 5);
  EXPECT_NE(picture_of(tree), earlier);
  tree.resize(5);
  EXPECT_EQ(picture_of(tree), earlier);
}

TEST(CsgTree, UndoingAChangeRestoresThePicture) {
  DNodes tree = lever();
  const std::vector<DEnds> earlier = picture_of(tree);
  Evaluation<double> e = evaluated<double>(tree, along_x);
  const Undo<double> undo = change<double>(e, 3, Cylinder<double>{{14, 4, 0}, 3, 2});
  EXPECT_NE(picture_of(e.tree), earlier);
  restore<double>(e, undo);
  EXPECT_EQ(picture_of(e.tree), earlier);
}

TEST(CsgTree, AMillionPointsAreWhereTheFormulaHasThem) {
  const DNodes tree = lever();
  Random random(20261130);
  int wrong = 0;
  const int points = test::sanitized ? 50'000 : 1'000'000;
  for (int k = 0; k < points; ++k) {
    // Every second one on a lattice that the faces lie on; all numbers are whole, times 1/64
    const int grid = k % 2 == 0 ? 64 : 1;
    const auto x = grid * random.uniform_int(0, 20 * 64 / grid),
               y = grid * random.uniform_int(0, 8 * 64 / grid),
               z = grid * random.uniform_int(-5 * 64 / grid, 5 * 64 / grid);
    const auto round = [&](std::int64_t r, bool is_ball) {
      const std::int64_t dx = x - 14 * 64, dy = y - 4 * 64, dz = is_ball ? z : 0;
      const std::int64_t off = dx * dx + dy * dy + dz * dz - r * r * 64 * 64;
      const std::int64_t first = dx != 0 ? dx : dy != 0 ? dy : dz;
      return off < 0 || (off == 0 && first < 0);
    };
    const bool plate = 2 * 64 <= x && x < 13 * 64 && 2 * 64 <= y && y < 6 * 64 && -64 <= z && z < 64;
    const bool plane = 2 * (x - 4 * 64) + (y - 4 * 64) >= 0;
    const bool formula = (plate || round(4, true)) && !round(2, false) && plane;
    const dvec3 p = dvec3(x, y, z) / 64.0;
    wrong += contains<double>(tree, p) != formula;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(states(page, "half of them on the lattice of the faces, {} are told wrong", {1.0 * wrong}));
}

template <class T>
Nodes<T> lens() {
  Nodes<T> tree;
  add_leaf<T>(tree, Ball<T>{{T(0), T(0), T(0)}, T(5)});
  add_leaf<T>(tree, Ball<T>{{T(6), T(0), T(0)}, T(5)});
  add_node<T>(tree, Op::intersect, 0, 1);
  return tree;
}
TEST(CsgTree, OneRuleForPointsOnSurfacesInEveryArithmetic) {
  const ExactScope scope;
  const auto in = []<class T>(Tree<T> tree, int x, int y) {
    return contains<T>(tree, Point<T>(T(x), T(y), T(0)));
  };
  // On the first ball where it is left, on the second where it is entered, and where both meet
  for (const auto& [x, y, right] : {std::tuple{5, 0, false}, {1, 0, true}, {3, 4, false}, {3, -4, false}}) {
    EXPECT_EQ(in(Tree<double>(lens<double>()), x, y), right);
    EXPECT_EQ(in(Tree<float>(lens<float>()), x, y), right);
    EXPECT_EQ(in(Tree<Exact>(lens<Exact>()), x, y), right);
  }
  const Ray<float> ray{{-6, 0, 0}, {1, 0, 0}, 20};
  EXPECT_EQ(along_ray<float>(lens<float>(), ray), (Ends<float>{7, 11}));
}

TEST(CsgTree, SkippingGivesTheSameEnds) {
  const DNodes tree = lever();
  const Boxes<double> boxes = boxes_of<double>(tree);
  for (int i = -4; i <= 20; ++i) {
    const Ray<double> ray{{0, i / 2.0, 0}, {1, 0, 0}, 20};
    EXPECT_EQ((skipping<double>(tree, boxes, ray)), (along_ray<double>(tree, ray))) << i;
  }
}

TEST(CsgTree, ExhibitsAreAsWrongAsThePageSays) {
  const Box<double> left{{3, 0, 0}, {10, 8, 8}}, right{{10, 0, 0}, {17, 8, 8}};
  EXPECT_EQ(cracked<double>(two(Op::unite, left, right), along_x), (DEnds{3, 10, 10, 17}));
  EXPECT_EQ(cracked<double>(two(Op::intersect, left, right), along_x), DEnds{});
  EXPECT_EQ(cracked<double>(two(Op::intersect, right, left), along_x), (DEnds{10, 10}));
  const DNodes drilled = two(Op::subtract, Box<double>{{2, 2, -1}, {13, 6, 1}}, Ball<double>{{12, 4, 0}, 4});
  EXPECT_EQ(along_ray<double>(drilled, along_x), (DEnds{2, 8}));
  EXPECT_EQ(exchanged<double>(drilled, along_x), (DEnds{13, 16}));
}

TEST(CsgTree, MistakesAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](const Solid<double>& solid) {
    DNodes tree;
    add_leaf(tree, solid);
    EXPECT_THROW(contains<double>(tree, {0, 0, 0}), ContractViolation);
    EXPECT_THROW(along_ray<double>(tree, along_x), ContractViolation);
  };
  refuses(Ball<double>{{0, 0, 0}, -1});
  refuses(Ball<double>{{nan, 0, 0}, 1});
  refuses(Box<double>{{1, 0, 0}, {0, 1, 1}});
  refuses(HalfSpace<double>{{0, 0, 0}, {0, 0, 0}});
  refuses(Cylinder<double>{{0, 0, 0}, 1, 3});
  refuses(Ball<double>{{1e308, 0, 0}, 1});
  EXPECT_THROW(contains<double>({}, {0, 0, 0}), ContractViolation);
  DNodes tree = lever();
  EXPECT_THROW(contains<double>(tree, {nan, 0, 0}), ContractViolation);
  EXPECT_THROW(along_ray<double>(tree, {{0, 0, 0}, {0, 0, 0}, 1}), ContractViolation);
  EXPECT_THROW(along_ray<double>(tree, {{0, 0, 0}, {1, 0, 0}, 0}), ContractViolation);
  EXPECT_THROW(skipping<double>(tree, {}, along_x), ContractViolation);
  Evaluation<double> e = evaluated<double>(tree, along_x);
  EXPECT_THROW(change<double>(e, 2, Ball<double>{{0, 0, 0}, 1}), ContractViolation);
  tree[2].b = 2;
  EXPECT_THROW(contains<double>(tree, {0, 0, 0}), ContractViolation);
}

}  // namespace
}  // namespace gradus::csg_tree
