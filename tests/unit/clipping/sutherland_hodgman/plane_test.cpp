// In the plane: known polygons, separate pieces, the step grammar, exact arithmetic, and the notes' faults.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_notes.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/record.hpp"

namespace gradus::sutherland_hodgman {
namespace {

using Points = std::vector<dvec2>;
constexpr Rectangle<double> square{{0, 0}, {10, 10}};

Points clipped(const Points& points, std::vector<int> order = {0, 1, 2, 3}) {
  Points result;
  for (const auto& v : clip_to_window(points, square, order)) result.push_back(v.at);
  return result;
}
double area_of(const Points& ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}
template <class T>
double area_of(const std::vector<Vertex<T>>& ring) {
  Points points;
  for (const auto& v : ring) points.emplace_back(static_cast<double>(v.at.x), static_cast<double>(v.at.y));
  return area_of(points);
}
Points places(const std::vector<Vertex<double>>& ring) {
  Points points;
  for (const auto& v : ring) points.push_back(v.at);
  return points;
}
std::vector<Piece<double>> pieces(std::vector<Points> rings, std::vector<int> order = {0, 1, 2, 3}) {
  return separate_pieces(rings, square, order);
}
Points outline(const Piece<double>& piece) {
  Points points;
  for (const auto& v : piece.outline) points.push_back(v.at);
  return points;
}
/// The same ring, from whichever vertex on.
testing::AssertionResult same_ring(Points a, const Points& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a == b) return testing::AssertionSuccess();
    std::rotate(a.begin(), a.begin() + 1, a.end());
  }
  return testing::AssertionFailure() << testing::PrintToString(a.size()) << " vertices of area "
                                     << area_of(a);
}

const Points contains_window_points{{-10, -10}, {30, -10}, {10, 40}};                       // G001-54
const Points enters{{-5, 2}, {5, 2}, {5, 8}};                                               // G001-55
const Points letter_u{{2, -4}, {8, -4}, {8, 4}, {6, 4}, {6, -2}, {4, -2}, {4, 4}, {2, 4}};  // G001-57

TEST(SutherlandHodgmanPlane, GoldenPolygons) {
  EXPECT_TRUE(same_ring(clipped(contains_window_points), {{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  EXPECT_EQ(clipped(enters), (Points{{0, 5}, {0, 2}, {5, 2}, {5, 8}}));
  // G001-56
  const Points letter_c{{-5, 1}, {9, 1}, {9, 9}, {-5, 9}, {-5, 7}, {7, 7}, {7, 3}, {-5, 3}};
  EXPECT_TRUE(same_ring(clipped(letter_c), {{0, 1}, {9, 1}, {9, 9}, {0, 9}, {0, 7}, {7, 7}, {7, 3}, {0, 3}}));
  EXPECT_EQ(area_of(clipped(letter_c)), 44);
  EXPECT_TRUE(same_ring(clipped(letter_u), {{2, 0}, {8, 0}, {8, 4}, {6, 4}, {6, 0}, {4, 0}, {4, 4}, {2, 4}}));
  // G001-58
  const Points octagon{{0, 1}, {1, 0}, {9, 0}, {10, 1}, {10, 9}, {9, 10}, {1, 10}, {0, 9}};
  EXPECT_TRUE(same_ring(clipped({{5, -4}, {14, 5}, {5, 14}, {-4, 5}}), octagon));
}

TEST(SutherlandHodgmanPlane, CornersComeOnce) {
  // A diamond whose edges pass through the window's corners
  const Points diamond{{5, -5}, {15, 5}, {5, 15}, {-5, 5}};
  std::vector<int> order{0, 1, 2, 3};
  do {
    const Points ring = clipped(diamond, order);
    EXPECT_EQ(ring.size(), 4u);
    EXPECT_EQ(area_of(ring), 100);
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(outline(pieces({diamond}).at(0)).size(), 4u);
}

bool same_bits(const Points& a, const Points& b) {
  return std::ranges::equal(a, b, [](const dvec2& p, const dvec2& q) {
    return p == q && std::signbit(p.x) == std::signbit(q.x) && std::signbit(p.y) == std::signbit(q.y);
  });
}

TEST(SutherlandHodgmanPlane, TheSignOfZeroDoesNotTellTheOrderOfBorders) {
  // Windows without thickness at 0, whose two borders are zeros of different signs
  const Points zigzag{{-3, -2}, {4, -1}, {-3, 1}, {4, 5}};
  for (const int signs : {0, 1, 2, 3}) {
    const double a = signs & 1 ? -0.0 : 0.0, b = signs & 2 ? -0.0 : 0.0;
    const Rectangle<double> windows[]{
        {{a, -9}, {b, 9}}, {{-9, a}, {9, b}}, {{a, a}, {b, b}}, {{a, b}, {9, 9}}};
    for (const auto& window : windows) {
      std::vector<int> order{0, 1, 2, 3};
      const Points first = places(clip_to_window(zigzag, window, order));
      while (std::ranges::next_permutation(order).found) {
        // Where the ring starts may depend on the order
        Points ring = places(clip_to_window(zigzag, window, order));
        const auto start = std::ranges::find(ring, first.empty() ? dvec2(0) : first.front());
        if (start != ring.end()) std::ranges::rotate(ring, start);
        ASSERT_TRUE(same_bits(ring, first)) << signs;
      }
    }
  }
}

TEST(SutherlandHodgmanPlane, OutsideInsideAndAround) {
  const Points inside{{1, 1}, {9, 1}, {5, 9}};
  EXPECT_EQ(clipped(inside), inside);
  EXPECT_TRUE(clipped({{11, 1}, {19, 1}, {15, 9}}).empty());
  // Around a corner, but outside: no border alone has all of it outside
  EXPECT_TRUE(clipped({{-3, 2}, {-4, -4}, {2, -3}}).empty());
  // Through the corner itself: a point has no area
  EXPECT_TRUE(clipped({{-3, 3}, {-4, -4}, {3, -3}}).empty());
  EXPECT_TRUE(clipped({}).empty());
  // Nothing hangs on the direction
  const Points backwards(contains_window_points.rbegin(), contains_window_points.rend());
  EXPECT_EQ(area_of(clipped(backwards)), -100);
  EXPECT_TRUE(same_ring(outline(pieces({backwards}).at(0)), {{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
}

TEST(SutherlandHodgmanPlane, VerticesRememberWhatMadeThem) {
  const std::vector<int> order{0, 1, 2, 3};
  const auto ring = clip_to_window(std::span<const dvec2>(enters), square, std::span<const int>(order));
  ASSERT_EQ(ring.size(), 4u);
  EXPECT_EQ(ring[0].edge, EdgeName::polygon(2));
  EXPECT_EQ(ring[0].border, EdgeName::window(0));
  EXPECT_EQ(ring[0].after, EdgeName::window(0));  // along the left border
  EXPECT_EQ(ring[1].edge, EdgeName::polygon(0));
  EXPECT_EQ(ring[1].after, EdgeName::polygon(0));
  EXPECT_EQ(ring[2].input, 1);
  // A corner is made by two borders, and copied
  const auto corner = clip_to_window(std::span<const dvec2>(contains_window_points), square);
  for (const auto& v : corner) EXPECT_TRUE(v.edge.of_window() && v.border.of_window());
}

TEST(SutherlandHodgmanPlane, StepsFollowTheGrammar) {
  Recorder<VertexTested<double>, EdgeCut<double>, VertexKept<double>, BorderPassed<double>> seen;
  const std::vector<int> order{2, 0, 3, 1};
  const std::span<const dvec2> given(letter_u);
  const auto watched = clip_to_window(given, square, std::span<const int>(order), seen);
  std::size_t passed = 0, tested = 0, corners = letter_u.size();
  bool may_cut = false, may_keep = false;
  for (const auto& event : seen.events()) {
    if (const auto* t = std::get_if<VertexTested<double>>(&event.step)) {
      EXPECT_EQ(t->number, tested++);
      EXPECT_EQ(t->border, order[passed]);
      may_cut = true;
      may_keep = t->side >= 0;
    } else if (std::holds_alternative<EdgeCut<double>>(event.step)) {
      EXPECT_TRUE(may_cut);  // at most once for a corner, and before it is kept
      may_cut = false;
    } else if (std::holds_alternative<VertexKept<double>>(event.step)) {
      EXPECT_TRUE(may_keep);
      may_cut = may_keep = false;
    } else {
      EXPECT_EQ(tested, corners);
      tested = 0;
      corners = std::get<BorderPassed<double>>(event.step).polygon.size();
      may_cut = false;
      ++passed;
    }
  }
  EXPECT_EQ(passed, 4u);
  // No watcher changes anything
  const auto unwatched = clip_to_window(given, square, std::span<const int>(order));
  ASSERT_EQ(watched.size(), unwatched.size());
  for (std::size_t i = 0; i < watched.size(); ++i) EXPECT_EQ(watched[i].at, unwatched[i].at);
}

TEST(SutherlandHodgmanPlane, BridgesAreNamed) {
  const std::span<const dvec2> given(letter_u);
  const auto ring = clip_to_window(given, square);
  Recorder<BridgeFound<double>> seen;
  const auto found = bridges(std::span<const Vertex<double>>(ring), given, square, seen);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].border, 2);
  EXPECT_EQ(found[0].from.at, dvec2(4, 0));
  EXPECT_EQ(found[0].to.at, dvec2(6, 0));
  EXPECT_EQ(seen.seen(), 1u);
  // What is run once is no bridge
  const auto window_itself = clip_to_window(std::span<const dvec2>(contains_window_points), square);
  EXPECT_TRUE(bridges(std::span<const Vertex<double>>(window_itself),
                      std::span<const dvec2>(contains_window_points), square)
                  .empty());
}

TEST(SutherlandHodgmanPlane, PiecesComeApart) {
  const auto both = pieces({letter_u});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_TRUE(same_ring(outline(both[0]), {{6, 0}, {8, 0}, {8, 4}, {6, 4}}));
  EXPECT_TRUE(same_ring(outline(both[1]), {{2, 0}, {4, 0}, {4, 4}, {2, 4}}));
  EXPECT_TRUE(pieces({{{11, 1}, {19, 1}, {15, 9}}}).empty());
  EXPECT_TRUE(pieces({}).empty());
  // It touches the border from outside, in an edge and in a vertex
  EXPECT_TRUE(pieces({{{2, 0}, {5, -3}, {8, 0}}}).empty());
  EXPECT_TRUE(pieces({{{2, -4}, {8, -4}, {5, 0}}}).empty());
  // A notch that ends on the border: two pieces that touch there
  const auto notched = pieces({{{1, -2}, {5, 0}, {9, -2}, {9, 3}, {1, 3}}});
  ASSERT_EQ(notched.size(), 1u);
  const auto split = pieces({{{1, 0}, {9, 0}, {9, 3}, {5, 0}, {1, 3}}});
  ASSERT_EQ(split.size(), 2u);
  EXPECT_EQ(area_of(outline(split[0])) + area_of(outline(split[1])), 12);
}

TEST(SutherlandHodgmanPlane, HolesAreCutToo) {
  const Points outer{{-5, 2}, {15, 2}, {15, 8}, {-5, 8}};
  // Wholly inside: it stays a hole
  const auto whole = pieces({outer, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}});
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_EQ(whole[0].holes.size(), 1u);
  EXPECT_EQ(area_of(outline(whole[0])) + area_of(whole[0].holes[0]), 56);
  // Across the left border: it becomes a bay
  const auto bay = pieces({outer, {{-2, 4}, {6, 4}, {6, 6}, {-2, 6}}});
  ASSERT_EQ(bay.size(), 1u);
  EXPECT_TRUE(bay[0].holes.empty());
  EXPECT_EQ(area_of(outline(bay[0])), 48);
  // Through both: it parts the polygon
  EXPECT_EQ(pieces({outer, {{-2, 4}, {12, 4}, {12, 6}, {-2, 6}}}).size(), 2u);
  // The window lies in the hole
  EXPECT_TRUE(
      pieces({{{-9, -9}, {19, -9}, {19, 19}, {-9, 19}}, {{-1, -1}, {11, -1}, {11, 11}, {-1, 11}}}).empty());
  // The hole is the window
  EXPECT_TRUE(
      pieces({{{-9, -9}, {19, -9}, {19, 19}, {-9, 19}}, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}}).empty());
  // Each piece gets its own hole
  const Points wide_u{{0, -4}, {10, -4}, {10, 9}, {6, 9}, {6, -2}, {4, -2}, {4, 9}, {0, 9}};
  const auto two = pieces({wide_u, {{1, 3}, {2, 3}, {2, 4}, {1, 4}}, {{8, 3}, {9, 3}, {9, 4}, {8, 4}}});
  ASSERT_EQ(two.size(), 2u);
  for (const auto& piece : two) {
    ASSERT_EQ(piece.holes.size(), 1u);
    EXPECT_EQ(piece.holes[0][0].at.x < 5, piece.outline[0].at.x < 5);
  }
}

/// Outline less holes: their areas have signs.
double area_of(const Piece<double>& piece) {
  double area = area_of(piece.outline);
  for (const auto& hole : piece.holes) area += area_of(hole);
  return area;
}

TEST(SutherlandHodgmanPlane, AHoleThatTouchesTheOutlineStays) {
  Points outer{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{2, 4}, {1, 2}, {3, 2}};
  // From whichever vertex on, either way round
  for (int turn = 0; turn < 12; ++turn) {
    const auto all = pieces({outer, hole});
    ASSERT_EQ(all.size(), 1u);
    ASSERT_EQ(all[0].holes.size(), 1u);
    EXPECT_EQ(area_of(all[0]), 14);
    // The outline is the one that was given, without the point of the hole
    EXPECT_TRUE(same_ring(outline(all[0]), {{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
    EXPECT_EQ(area_of(all[0].holes[0]), -2);
    std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    if (turn % 3 == 2) std::rotate(outer.begin(), outer.begin() + 1, outer.end());
    if (turn == 5) std::reverse(hole.begin(), hole.end());
  }
  // In a corner, and on the border of the window
  EXPECT_EQ(area_of(pieces({outer, {{0, 0}, {3, 1}, {1, 3}}}).at(0)), 12);
  const auto on_border = pieces({{{-5, -5}, {15, -5}, {15, 15}, {-5, 15}}, {{5, 10}, {3, 6}, {7, 6}}});
  ASSERT_EQ(on_border.size(), 1u);
  EXPECT_EQ(on_border[0].holes.size(), 1u);
  EXPECT_EQ(area_of(on_border[0]), 92);
  EXPECT_TRUE(same_ring(outline(on_border[0]), {{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
}

TEST(SutherlandHodgmanPlane, PartsThatMeetInAPointAreTwoPieces) {
  // An outline that touches itself, in a vertex of both ways and in the middle of an edge
  const Points bow{{1, 1}, {4, 4}, {7, 1}, {7, 7}, {4, 4}, {1, 7}};
  const auto two = pieces({bow});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(area_of(two[0]), 9);
  EXPECT_EQ(area_of(two[1]), 9);
  const auto other =
      pieces({{{1, 1}, {8, 1}, {4, 1}, {6, 3}, {2, 3}, {4, 1}, {1, 1}, {1, 0}, {8, 0}, {8, 1}}});
  ASSERT_EQ(other.size(), 2u);
  EXPECT_EQ(area_of(other[0]) + area_of(other[1]), 11);
  // Holes that touch the outline and each other part the inside
  const Points outer{{0, 0}, {6, 0}, {6, 2}, {0, 2}};
  const auto parted = pieces({outer, {{3, 0}, {4, 1}, {2, 1}}, {{3, 1}, {4, 2}, {2, 2}}});
  ASSERT_EQ(parted.size(), 2u);
  EXPECT_EQ(area_of(parted[0]), 5);
  EXPECT_EQ(area_of(parted[1]), 5);
  // A hole that touches itself lets a part of the inside be in it
  const auto island =
      pieces({{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
              {{4, 1}, {7, 1}, {7, 7}, {1, 7}, {1, 1}, {4, 1}, {2, 2}, {2, 6}, {6, 6}, {6, 2}}});
  ASSERT_EQ(island.size(), 2u);
  EXPECT_EQ(area_of(island[0]) + area_of(island[1]), 64 - 36 + 18);
}

TEST(SutherlandHodgmanPlane, EdgesRunBothWaysBoundNothing) {
  const Points outer{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  // A hole with an edge on the outline is a bay; a slit and a line are nothing
  const auto bay = pieces({outer, {{2, 6}, {2, 3}, {4, 3}, {4, 6}}});
  ASSERT_EQ(bay.size(), 1u);
  EXPECT_TRUE(bay[0].holes.empty());
  EXPECT_EQ(area_of(bay[0]), 30);
  const auto slit = pieces({{{1, 1}, {4, 1}, {4, 5}, {4, 1}, {7, 1}, {7, 7}, {1, 7}}, {{2, 2}, {3, 3}}});
  ASSERT_EQ(slit.size(), 1u);
  EXPECT_EQ(slit[0].outline.size(), 5u);
  EXPECT_EQ(area_of(slit[0]), 36);
  EXPECT_TRUE(pieces({{{1, 1}, {5, 5}, {3, 3}}}).empty());
  EXPECT_TRUE(pieces({{{1, 1}}}).empty());
}

TEST(SutherlandHodgmanPlane, RingsThatCrossKeepTheirArea) {
  // A bow-tie of area 0, its left half in the window: clockwise, as it is given
  const auto tie = pieces({{{2, 8}, {18, 2}, {18, 8}, {2, 2}}});
  ASSERT_EQ(tie.size(), 1u);
  EXPECT_EQ(std::abs(area_of(tie[0])), 24);
  const auto back = pieces({{{2, 2}, {18, 8}, {18, 2}, {2, 8}}});
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(area_of(back[0]), -area_of(tie[0]));
}

TEST(SutherlandHodgmanPlane, PieceStepsFollowTheGrammar) {
  Recorder<RingTested<double>, CrossingsOrdered<double>, CrossingsJoined<double>, BorderSplit<double>,
           PieceTraced<double>>
      seen;
  const std::vector<Points> rings{letter_u};
  const std::vector<int> order{0, 1, 2, 3};
  separate_pieces(Rings<double>(std::span<const Points>(rings)), square, std::span<const int>(order), seen);
  const auto ordered = all<CrossingsOrdered<double>>(seen);
  ASSERT_EQ(ordered.size(), 4u);
  ASSERT_EQ(ordered[2].crossings.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(ordered[2].crossings[i].vertex.at.x, 2.0 + 2.0 * static_cast<double>(i));
    EXPECT_EQ(ordered[2].crossings[i].enters, i % 2 == 1);
  }
  const auto joined = all<CrossingsJoined<double>>(seen);
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].leaves.vertex.at.x, 2);
  EXPECT_EQ(joined[0].enters.vertex.at.x, 4);
  EXPECT_EQ(all<PieceTraced<double>>(seen).size(), 2u);
  EXPECT_EQ(all<BorderSplit<double>>(seen).size(), 4u);
}

TEST(SutherlandHodgmanPlane, ConvexWindows) {
  const auto window_of = [](Points p) { return convex_window(std::span<const dvec2>(p)); };
  // Either way round, corners that are none left out
  const auto triangle = window_of({{0, 0}, {4, 8}, {8, 0}, {4, 0}, {4, 0}});
  ASSERT_TRUE(triangle);
  EXPECT_TRUE(same_ring(triangle->corners, {{0, 0}, {8, 0}, {4, 8}}));
  // No window: concave, crossing itself, five-pointed star, without area
  EXPECT_FALSE(window_of({{0, 0}, {8, 0}, {2, 2}, {0, 8}}));
  EXPECT_FALSE(window_of({{0, 0}, {8, 8}, {8, 0}, {0, 8}}));
  EXPECT_FALSE(window_of({{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}));
  EXPECT_FALSE(window_of({{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_FALSE(window_of({{0, 0}, {1, 1}}));
  const Points square_points{{1, 1}, {7, 1}, {7, 3}, {1, 3}};
  const auto ring = clip_to_window(std::span<const dvec2>(square_points), *triangle);
  EXPECT_EQ(area_of(ring), 11.5);
  const Points around{{-50, -50}, {50, -50}, {0, 90}};
  const auto itself = clip_to_window(std::span<const dvec2>(around), *triangle);
  EXPECT_EQ(area_of(itself), 32);
  for (const auto& v : itself) {
    EXPECT_NE(std::find(triangle->corners.begin(), triangle->corners.end(), v.at), triangle->corners.end());
  }
}

TEST(SutherlandHodgmanPlane, AVanishingPieceTakesNoOtherWithIt) {
  // A ring outside the outline, along an edge of it: what it has in the window is 3 ulp wide
  const dvec2 far{-0x1.12648ebcbf2d6p+3, -0x1.7bd18fdc974cp+3},
      near{-0x1.4e342f8bc1dbdp+1, -0x1.4ad26fa3b1873p+3};
  const Points outline{{0, 0}, far, near}, beside{far, near, {-6, -12}};
  const Rectangle<double> narrow{{-0x1.4e342f8bc1dcp+1, -16}, {0, 0}};
  const auto alone = separate_pieces(outline, narrow);
  const auto both = separate_pieces({outline, beside}, narrow, std::vector<int>{2, 3, 0, 1});
  ASSERT_EQ(alone.size(), 1u);
  ASSERT_EQ(both.size(), 1u);
  EXPECT_NEAR(area_of(both[0].outline), area_of(alone[0].outline), 1e-13);
  EXPECT_GT(area_of(alone[0].outline), 8);
}

TEST(SutherlandHodgmanPlane, TakesPointsAsProgramsHaveThem) {
  const Points vector{{-5, 2}, {5, 2}, {5, 8}};
  const std::array<dvec2, 3> array{vector[0], vector[1], vector[2]};
  const dvec2 plain[]{{-5, 2}, {5, 2}, {5, 8}};
  Points changeable = vector;
  const std::vector<glm::vec2> floats{{-5, 2}, {5, 2}, {5, 8}};
  const std::vector<int> order{0, 1, 2, 3};
  const auto right = places(clip_to_window(std::span<const dvec2>(vector), square));
  ASSERT_EQ(right.size(), 4u);
  EXPECT_EQ(places(clip_to_window(vector, square)), right);
  EXPECT_EQ(places(clip_to_window(array, square)), right);
  EXPECT_EQ(places(clip_to_window(plain, square, order)), right);
  EXPECT_EQ(places(clip_to_window(std::span(changeable), square)), right);
  EXPECT_EQ(places(clip_to_window(std::span(plain), square)), right);
  EXPECT_EQ(places(clip_to_window({{-5, 2}, {5, 2}, {5, 8}}, {{0, 0}, {10, 10}})), right);
  static_assert(std::same_as<decltype(clip_to_window(floats, {{0, 0}, {10, 10}})), Ring<float>>);
  static_assert(std::same_as<decltype(clip_to_window({{0, 0}}, {{0, 0}, {10, 10}})), Ring<double>>);
  Recorder<VertexTested<double>, EdgeCut<double>, VertexKept<double>, BorderPassed<double>> seen;
  EXPECT_EQ(places(clip_to_window(vector, square, order, seen)), right);
  EXPECT_EQ(all<BorderPassed<double>>(seen).size(), 4u);
  // What takes the result, and what makes a window
  const Points u{{2, -4}, {8, -4}, {8, 4}, {6, 4}, {6, -2}, {4, -2}, {4, 4}, {2, 4}};
  EXPECT_EQ(bridges(clip_to_window(u, square), u, square).size(), 1u);
  const auto half = convex_window({{0, 0}, {10, 0}, {0, 10}});
  ASSERT_TRUE(half);
  EXPECT_EQ(area_of(clip_to_window(vector, *half)), 19.6875);
}

TEST(SutherlandHodgmanPlane, TakesRingsAsProgramsHaveThem) {
  const Points around{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
  const std::vector<Points> rings{around, hole};
  const auto area = [](const std::vector<Piece<double>>& parts) {
    double sum = 0;
    for (const auto& part : parts) {
      sum += area_of(part.outline);
      for (const auto& ring : part.holes) sum += area_of(ring);
    }
    return sum;
  };
  EXPECT_EQ(area(separate_pieces(Rings<double>(std::span<const Points>(rings)), square)), 12);
  EXPECT_EQ(area(separate_pieces(Rings(rings), square)), 12);
  EXPECT_EQ(area(separate_pieces(Rings({around, hole}), square)), 12);
  EXPECT_EQ(area(separate_pieces(rings, square)), 12);
  EXPECT_EQ(area(separate_pieces(std::array{around, hole}, square)), 12);
  EXPECT_EQ(area(separate_pieces({around, hole}, {{0, 0}, {2, 4}})), 6);
  EXPECT_EQ(area(separate_pieces(Rings(around), square)), 16);
  EXPECT_EQ(area(separate_pieces(around, {{0, 0}, {2, 4}})), 8);
  EXPECT_EQ(area(separate_pieces({{0, 0}, {4, 0}, {4, 4}}, square)), 8);
  // With an order and an observer
  Recorder<RingTested<double>, CrossingsOrdered<double>, CrossingsJoined<double>, BorderSplit<double>,
           PieceTraced<double>>
      seen;
  EXPECT_EQ(area(separate_pieces(rings, square, all_borders(square), seen)), 12);
  EXPECT_EQ(all<PieceTraced<double>>(seen).size(), 1u);
}

template <class T>
std::vector<Vertex<T>> in_scalar(const Points& points, const ConvexWindow<double>& around) {
  std::vector<glm::vec<2, T>> given;
  ConvexWindow<T> oblique;
  for (const dvec2 p : points) given.push_back({T(p.x), T(p.y)});
  for (const dvec2 p : around.corners) oblique.corners.push_back({T(p.x), T(p.y)});
  const std::vector<std::vector<glm::vec<2, T>>> rings{given};
  const std::vector<int> order = all_borders(oblique);
  const auto apart = separate_pieces(Rings<T>(std::span<const std::vector<glm::vec<2, T>>>(rings)), oblique,
                                     std::span<const int>(order));
  EXPECT_EQ(apart.size(), 2u);
  return clip_to_window(std::span<const glm::vec<2, T>>(given), oblique);
}

TEST(SutherlandHodgmanPlane, FloatDoubleAndExactAgree) {
  const ExactScope scope;
  const ConvexWindow<double> around{{{-1, -1}, {9, 1}, {5, 12}}};
  const auto exact = in_scalar<Exact>(letter_u, around);
  const auto doubles = in_scalar<double>(letter_u, around);
  const auto floats = in_scalar<float>(letter_u, around);
  ASSERT_EQ(exact.size(), doubles.size());
  ASSERT_EQ(exact.size(), floats.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(to_double(exact[i].at[axis]), doubles[i].at[axis]);
      EXPECT_EQ(static_cast<float>(to_double(exact[i].at[axis])), floats[i].at[axis]);
    }
  }
}

// --- The notes ----------------------------------------------------------------------------------

template <class Pass>
double area_by(Pass pass, const Points& points) {
  const std::vector<int> order{0, 1, 2, 3};
  return area_of(by_passes(Task<double>{points, square, order}, pass));
}

TEST(SutherlandHodgmanNotes, WrongAsPrinted) {
  const auto entering = [](auto polygon, auto border) { return entering_not_cut(polygon, border); };
  const auto previous = [](auto polygon, auto border) { return previous_left_behind(polygon, border); };
  const auto marked = [](auto polygon, auto border) { return marked_by_window(polygon, border); };
  const auto plain = [](auto polygon, auto border) { return cut_of_a_cut(polygon, border); };
  EXPECT_EQ(area_by(entering, enters), 15);
  EXPECT_EQ(area_by(previous, enters), 7.5);
  EXPECT_EQ(area_by(marked, contains_window_points), 0);
  EXPECT_EQ(area_by(plain, contains_window_points), 100);
  EXPECT_EQ(area_by(plain, enters), 22.5);
  EXPECT_EQ(area_by(plain, letter_u), 16);
  const std::vector<int> order{0, 1, 2, 3};
  EXPECT_EQ(area_of(containing_left_whole(Task<double>{contains_window_points, square, order})), 1000);
  EXPECT_EQ(area_of(containing_left_whole(Task<double>{enters, square, order})), 22.5);
}

}  // namespace
}  // namespace gradus::sutherland_hodgman
