// Known triangles, the step grammar, the rule for edges, snapping, refusals.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/random.hpp"
#include "core/record.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"

namespace gradus::triangle_coverage {
namespace {

using Pixels = std::vector<ivec2>;

Triangle pixels(dvec2 a, dvec2 b, dvec2 c) { return {snap(a), snap(b), snap(c)}; }

Pixels covered(const Triangle& triangle, const Window& window) {
  Pixels found;
  cover(triangle, window, [&](ivec2 p, const Weights&) { found.push_back(p); });
  return found;
}

constexpr Window sheet{{0, 0}, {15, 15}};

TEST(TriangleCoverage, NotesTriangleCoversFourCentres) {
  // G001-96, G001-97: (1,3), (4,1), (2,5); doubled area 8 pixels
  const Triangle t = pixels({1, 3}, {4, 1}, {2, 5});
  EXPECT_EQ(doubled_area(t), 8 * 65536);
  EXPECT_THAT(covered(t, sheet),
              testing::UnorderedElementsAre(ivec2{1, 3}, ivec2{2, 2}, ivec2{2, 3}, ivec2{3, 1}));
  const Triangle turned{t[0], t[2], t[1]};
  EXPECT_EQ(doubled_area(turned), -8 * 65536);
  EXPECT_EQ(covered(turned, sheet), covered(t, sheet));
}

TEST(TriangleCoverage, EdgeFunctionsOfTheNotesTriangle) {
  // G001-95, as a x + b y + c; edge i lies opposite corner i
  const Triangle t = pixels({1, 3}, {4, 1}, {2, 5});
  const Edges edges = edges_of(t);
  for (int x = -2; x < 7; ++x) {
    for (int y = -2; y < 7; ++y) {
      const ivec2 place{256 * x, 256 * y};
      EXPECT_EQ(edges[2].at(place), 65536 * (2 * x + 3 * y - 11));
      EXPECT_EQ(edges[0].at(place), 65536 * (-4 * x - 2 * y + 18));
      EXPECT_EQ(edges[1].at(place), 65536 * (2 * x - y + 1));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(edges[i].at(t[i]), 8 * 65536);
}

TEST(TriangleCoverage, CoefficientsOfTheNotesTriangle) {
  // G001-95: E1 is the edge c from A to B, E2 a, E3 b; (value at the origin, per column, per row)
  const Edges edges = edges_of(pixels({1, 3}, {4, 1}, {2, 5}));
  const auto coefficients = [](const Edge& edge) {
    const std::int64_t constant = edge.at({0, 0});
    return std::array{(edge.at({256, 0}) - constant) / 65536, (edge.at({0, 256}) - constant) / 65536,
                      constant / 65536};
  };
  EXPECT_EQ(coefficients(edges[2]), (std::array<std::int64_t, 3>{2, 3, -11}));
  EXPECT_EQ(coefficients(edges[0]), (std::array<std::int64_t, 3>{-4, -2, 18}));
  EXPECT_EQ(coefficients(edges[1]), (std::array<std::int64_t, 3>{2, -1, 1}));
  for (const Edge& edge : edges) EXPECT_EQ(edge.step() * 256, edge.at({65536, 0}) - edge.at({0, 0}));
}

TEST(TriangleCoverage, LatticePointsOfTheNotesTriangle) {
  // G001-97, with the lattice's points as places instead of centres
  const Edges edges = edges_of(pixels({1, 3}, {4, 1}, {2, 5}));
  Pixels all, strict, centres;
  for (int x = -1; x < 7; ++x) {
    for (int y = -1; y < 7; ++y) {
      const auto least_at = [&](ivec2 place) {
        return std::min({edges[0].at(place), edges[1].at(place), edges[2].at(place)});
      };
      if (least_at({256 * x, 256 * y}) >= 0) all.push_back({x, y});
      if (least_at({256 * x, 256 * y}) > 0) strict.push_back({x, y});
      if (least_at(centre_of({x, y})) >= 0) centres.push_back({x, y});
    }
  }
  EXPECT_EQ(all, (Pixels{{1, 3}, {2, 3}, {2, 4}, {2, 5}, {3, 2}, {3, 3}, {4, 1}}));
  EXPECT_EQ(strict, (Pixels{{2, 3}, {2, 4}, {3, 2}}));
  EXPECT_EQ(centres, (Pixels{{1, 3}, {2, 2}, {2, 3}, {3, 1}}));
  // Pick: inside + half of those on the border - 1 is the area
  EXPECT_EQ(2 * strict.size() + (all.size() - strict.size()) - 2, 8u);
}

TEST(TriangleCoverage, TheDiagonalOfASquareIsDrawnOnce) {
  // G001-98: closed half-planes draw 8 of 64 pixels twice
  const Pixels lower = covered(pixels({0, 0}, {8, 0}, {8, 8}), sheet);
  const Pixels upper = covered(pixels({0, 0}, {8, 8}, {0, 8}), sheet);
  EXPECT_EQ(lower.size() + upper.size(), 64u);
  for (const ivec2 p : lower) EXPECT_THAT(upper, testing::Not(testing::Contains(p)));
}

TEST(TriangleCoverage, TopAndLeftEdgesOwnTheirCentres) {
  // A square whose sides run through centres: the left column and the top row belong to it, the others don't
  const auto square = [](double x, double y) {
    Pixels all = covered(pixels({x, y}, {x + 2, y}, {x + 2, y + 2}), sheet);
    const Pixels other = covered(pixels({x, y}, {x + 2, y + 2}, {x, y + 2}), sheet);
    all.insert(all.end(), other.begin(), other.end());
    return all;
  };
  EXPECT_THAT(square(3.5, 4.5),
              testing::UnorderedElementsAre(ivec2{3, 4}, ivec2{4, 4}, ivec2{3, 5}, ivec2{4, 5}));
}

TEST(TriangleCoverage, StepsFollowTheGrammarAndWeightsAddUp) {
  const Triangle t = pixels({1, 3}, {4, 1}, {2, 5});
  Recorder<Prepared, Tested, Finished> seen;
  Pixels plotted;
  cover(t, sheet, [&](ivec2 p, const Weights&) { plotted.push_back(p); }, seen);
  EXPECT_EQ(plotted, covered(t, sheet));  // observed == unobserved
  ASSERT_GE(seen.events().size(), 2u);
  const auto* prepared = std::get_if<Prepared>(&seen.events().front().step);
  ASSERT_TRUE(prepared);
  EXPECT_EQ(prepared->box, (Window{{1, 1}, {3, 4}}));
  const auto* finished = std::get_if<Finished>(&seen.events().back().step);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->tested, 12);
  EXPECT_EQ(finished->covered, 4);
  EXPECT_EQ(all<Tested>(seen).size(), 12u);
  EXPECT_TRUE(every<Tested>(seen, [&](const Tested& step) {
    return step.weights[0] + step.weights[1] + step.weights[2] == 8 * 65536 &&
           step.weights[0] == prepared->edges[0].at(centre_of(step.pixel));
  }));
}

TEST(TriangleCoverage, WithoutAreaNothingIsCoveredOrTold) {
  Recorder<Prepared, Tested, Finished> seen;
  cover(pixels({1, 1}, {5, 5}, {9, 9}), sheet, [](ivec2, const Weights&) { FAIL(); }, seen);
  cover(pixels({1, 1}, {1, 1}, {9, 2}), sheet, [](ivec2, const Weights&) { FAIL(); }, seen);
  EXPECT_EQ(seen.seen(), 0u);
}

TEST(TriangleCoverage, NothingOutsideTheWindow) {
  EXPECT_THROW(covered(pixels({0, 0}, {1, 0}, {0, 1}), {{0, 0}, {1 << 30, 0}}), ContractViolation);
  const Triangle huge = pixels({-1e6, -1e6}, {1e6, -1e6}, {0, 1e6});
  EXPECT_EQ(covered(huge, {{3, 4}, {5, 5}}).size(), 6u);
  EXPECT_TRUE(covered(huge, {}).empty());
}

TEST(TriangleCoverage, SnapsToTheNearestMidwayToTheSmaller) {
  EXPECT_EQ(snap({0.0, 1.0}), (ivec2{0, 256}));
  EXPECT_EQ(snap({1 / 512.0, -1 / 512.0}), (ivec2{0, -1}));
  EXPECT_EQ(snap({3 / 512.0, 0x1.0000000000001p-9}), (ivec2{1, 1}));
  // Adding 1/2 before rounding down would round this one up
  EXPECT_EQ(snap({0x1.fffffffffffffp-10, 0}).x, 0);
  EXPECT_EQ(snap({farthest, -farthest}), (ivec2{farthest * 256, -farthest * 256}));
}

TEST(TriangleCoverage, PerspectiveCorrectMidpoint) {
  // G000-16: midway in the picture on an edge from depth 1 to 3, a quarter of the way on the surface
  const dvec3 shares = perspective_correct({1, 1, 0}, {1, 1.0 / 3, 1});
  EXPECT_DOUBLE_EQ(shares.y, 0.25);
  EXPECT_DOUBLE_EQ(barycentric({1, 1, 0}).y, 0.5);
  // Nearly all weight on a corner close to the eye: no 0/0
  EXPECT_NEAR(perspective_correct({1, 1, 0}, {1e8, 1, 1}).x, 1, 1e-7);
}

Pixels closed(const Triangle& triangle, const Window& window) {
  Pixels found;
  closed_half_planes(triangle, window, [&](ivec2 p, const Weights&) { found.push_back(p); });
  return found;
}

Pixels expanded_at(dvec2 origin, const Triangle& triangle, const Window& window) {
  Pixels found;
  expanded_edges(triangle, origin, window, [&](ivec2 p, const Weights&) { found.push_back(p); });
  return found;
}

TEST(TriangleCoverageNotes, ClosedHalfPlanesDrawTheDiagonalTwice) {
  // E001-42, G001-98: 36 + 36 for the 64 pixels of a square cut along its diagonal
  const Triangle right_half = pixels({0, 0}, {8, 0}, {8, 8}), left_half = pixels({0, 0}, {8, 8}, {0, 8});
  const Pixels first = closed(right_half, sheet), second = closed(left_half, sheet);
  EXPECT_EQ(first.size(), 36u);
  EXPECT_EQ(second.size(), 36u);
  Pixels twice;
  for (const ivec2 p : first) {
    if (std::ranges::find(second, p) != second.end()) twice.push_back(p);
  }
  Pixels diagonal;
  for (int i = 0; i < 8; ++i) diagonal.push_back({i, i});
  EXPECT_THAT(twice, testing::UnorderedElementsAreArray(diagonal));
  // By the rule for edges each comes once
  EXPECT_EQ(covered(right_half, sheet).size() + covered(left_half, sheet).size(), 64u);
}

/// The doubled area of three points, in 1/65536 pixel.
std::int64_t area_of(ivec2 a, ivec2 b, ivec2 c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

TEST(TriangleCoverageNotes, ClosedHalfPlanesAreTheClosedTriangle) {
  Random random(20240611);
  for (int i = 0; i < 300; ++i) {
    // Corners on centres and between them, so that edges run through centres
    const auto corner = [&] {
      return ivec2{static_cast<int>(random() % 25) * 128, static_cast<int>(random() % 25) * 128};
    };
    const Triangle t{corner(), corner(), corner()};
    Pixels expected;
    for (int y = 0; y <= 15 && doubled_area(t) != 0; ++y) {
      for (int x = 0; x <= 15; ++x) {
        const ivec2 p = centre_of({x, y});
        const std::int64_t whole = std::abs(doubled_area(t));
        const std::int64_t parts = std::abs(area_of(t[0], t[1], p)) + std::abs(area_of(t[1], t[2], p)) +
                                   std::abs(area_of(t[2], t[0], p));
        if (parts == whole) expected.push_back({x, y});
      }
    }
    EXPECT_EQ(closed(t, sheet), expected);
    // Of these the rule leaves out centres on edges only
    for (const ivec2 p : covered(t, sheet)) EXPECT_THAT(expected, testing::Contains(p));
  }
}

TEST(TriangleCoverageNotes, ExpandedEdgesCancelFarFromTheOrigin) {
  // E001-43: the place lies on the edge, 2 x 0.5 - 1 x 1 = 0
  const ExpandedEdge far = expanded({1e8 + 1, 1e8}, {1e8 + 3, 1e8 + 1});
  EXPECT_EQ(far.at({1e8 + 2, 1e8 + 0.5}), -1);
  const ExpandedEdge near = expanded({1, 0}, {3, 1});
  EXPECT_EQ(near.at({2, 0.5}), 0);
  // Differences first are exact
  const Edge edge{snap({1, 0}), snap({3, 1}), true};
  EXPECT_EQ(edge.at(snap({2, 0.5})), 0);
}

TEST(TriangleCoverageNotes, ExpandedEdgesMisjudgeOnlyFarAway) {
  Random random(20240611);
  int differ = 0;
  for (int i = 0; i < 200; ++i) {
    const auto corner = [&] {
      return ivec2{static_cast<int>(random() % 4096), static_cast<int>(random() % 4096)};
    };
    const Triangle t{corner(), corner(), corner()};
    EXPECT_EQ(expanded_at({0, 0}, t, sheet), covered(t, sheet)) << "there the products are exact";
    differ += expanded_at({1e8, 1e8}, t, sheet) != covered(t, sheet);
  }
  EXPECT_GT(differ, 100);
}

TEST(TriangleCoverageNotes, StepsAreThoseOfTheRightOne) {
  const Triangle t = pixels({1, 3}, {4, 1}, {2, 5});
  const auto nothing = [](ivec2, const Weights&) {};
  Recorder<Prepared, Tested, Finished> right, open, wide;
  cover(t, sheet, nothing, right);
  closed_half_planes(t, sheet, nothing, open);
  expanded_edges(t, {0, 0}, sheet, nothing, wide);
  const auto weights = [](const auto& seen) {
    std::vector<Weights> all_of_them;
    for (const Tested& step : all<Tested>(seen)) all_of_them.push_back(step.weights);
    return all_of_them;
  };
  EXPECT_EQ(weights(open), weights(right));
  EXPECT_EQ(weights(wide), weights(right));
  for (const auto* seen : {&open, &wide}) {
    EXPECT_EQ(all<Prepared>(*seen).size(), 1u);
    ASSERT_EQ(all<Finished>(*seen).size(), 1u);
    EXPECT_EQ(all<Finished>(*seen)[0].tested, 12);
  }
  EXPECT_EQ(all<Finished>(wide)[0].covered, 4);
  closed_half_planes(pixels({1, 1}, {5, 5}, {9, 9}), sheet, [](ivec2, const Weights&) { FAIL(); });
  expanded_edges(pixels({1, 1}, {5, 5}, {9, 9}), {0, 0}, sheet, [](ivec2, const Weights&) { FAIL(); });
}

}  // namespace
}  // namespace gradus::triangle_coverage
