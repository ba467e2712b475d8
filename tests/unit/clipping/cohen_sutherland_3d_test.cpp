// Known segments, the step grammar, hard input, refusals; the box and the view volume.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "core/record.hpp"

namespace gradus::cohen_sutherland_3d {
namespace {

using Cube = AxisBox<3, double>;
using Piece = Segment<3, double>;
using Homogeneous = Segment<4, double>;
using Classified3 = Classified<3, double>;
using Cut3 = Cut<3, double>;
using Cut4 = Cut<4, double>;
using Accepted3 = Accepted<3, double>;
using glm::dvec3;
using glm::dvec4;

template <int N, class T = double>
using Watcher = Recorder<Classified<N, T>, Cut<N, T>, Accepted<N, T>, Rejected>;

const Cube unit{{0, 0, 0}, {1, 1, 1}};
const Cube ten{{0, 0, 0}, {10, 10, 10}};
const ViewVolume volume;
const Order usual = usual_order<3>();

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// --- Region codes ----------------------------------------------------------------------------------------

TEST(CohenSutherland3d, CodesAreSixBits) {
  // One bit per face, in the order 1, 2, 4, 8, 16, 32; faces, edges and corners are inside
  EXPECT_EQ(region_code(dvec3(-1, 5, 5), ten), 1);
  EXPECT_EQ(region_code(dvec3(11, 5, 5), ten), 2);
  EXPECT_EQ(region_code(dvec3(5, -1, 5), ten), 4);
  EXPECT_EQ(region_code(dvec3(5, 11, 5), ten), 8);
  EXPECT_EQ(region_code(dvec3(5, 5, -1), ten), 16);
  EXPECT_EQ(region_code(dvec3(5, 5, 11), ten), 32);
  // G001-44 in the plane z = 5
  const std::pair<glm::ivec2, int> corners[] = {{{-1, -1}, 5},  {{5, -1}, 4}, {{11, -1}, 6}, {{-1, 5}, 1},
                                                {{5, 5}, 0},    {{11, 5}, 2}, {{-1, 11}, 9}, {{5, 11}, 8},
                                                {{11, 11}, 10}, {{0, 0}, 0},  {{10, 10}, 0}};
  for (const auto& [at, code] : corners) EXPECT_EQ(region_code(dvec3(at.x, at.y, 5), ten), code);
  // All 27 regions have different codes
  std::vector<int> codes;
  for (const int x : {-1, 5, 11})
    for (const int y : {-1, 5, 11})
      for (const int z : {-1, 5, 11}) codes.push_back(region_code(dvec3(x, y, z), ten));
  std::sort(codes.begin(), codes.end());
  EXPECT_EQ(std::unique(codes.begin(), codes.end()) - codes.begin(), 27);
  for (const int x : {0, 10})
    for (const int y : {0, 10})
      for (const int z : {0, 10}) EXPECT_EQ(region_code(dvec3(x, y, z), ten), 0);
}

TEST(CohenSutherland3d, CodesOfTheViewVolume) {
  EXPECT_EQ(region_code(dvec4(0, 0, 0.5, 1), volume), 0);
  EXPECT_EQ(region_code(dvec4(-2, 0, 0.5, 1), volume), 1);
  EXPECT_EQ(region_code(dvec4(2, 0, 0.5, 1), volume), 2);
  EXPECT_EQ(region_code(dvec4(0, -2, 0.5, 1), volume), 4);
  EXPECT_EQ(region_code(dvec4(0, 2, 0.5, 1), volume), 8);
  EXPECT_EQ(region_code(dvec4(0, 0, -0.5, 1), volume), 16);
  EXPECT_EQ(region_code(dvec4(0, 0, 1.5, 1), volume), 32);
  // The faces are inside
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {0, 1}) EXPECT_EQ(region_code(dvec4(x, y, z, 1), volume), 0);
  // Behind the eye everything is outside, on the axis left, right, bottom, top and far at once
  EXPECT_EQ(region_code(dvec4(0, 0, 0.5, -1), volume), 1 + 2 + 4 + 8 + 32);
  // Also where w = 0
  for (const dvec4 p : {dvec4(0, 0, 1, 0), dvec4(0, 0, -1, 0), dvec4(1, 0, 0, 0), dvec4(0, -1, 0, 0)}) {
    EXPECT_NE(region_code(p, volume), 0);
  }
  // Compared, not added: w + x would round to 0
  EXPECT_EQ(region_code(dvec4(-1, 0, 0.5, 1 - 0x1p-53), volume), 1);
  EXPECT_EQ(region_code(dvec4(1e308, 0, 1e308, 1e308), volume), 0);
}

// --- The box ---------------------------------------------------------------------------------------------

TEST(CohenSutherland3d, GoldenSegment) {
  // G001-53
  const Piece line{{-1, 0.5, 0.25}, {2, 0.5, 1}};
  EXPECT_EQ(region_code(line.a, unit), 1);
  EXPECT_EQ(region_code(line.b, unit), 2);
  for (const auto& part : {correctly_rounded(line, unit), cut_of_a_cut(line, unit)}) {
    ASSERT_TRUE(part);
    EXPECT_EQ(part->a, dvec3(0, 0.5, 0.5));
    EXPECT_EQ(part->b, dvec3(1, 0.5, 0.75));
  }
}

TEST(CohenSutherland3d, GoldenSegmentsOfThePlaneLaidIntoSpace) {
  // G001-45 … 52 at z = 5, then with the axes exchanged
  struct Known {
    double ax, ay, bx, by;
    bool kept;
    double cx, cy, dx, dy;
  };
  const Known known[] = {{-5, 5, 15, 5, true, 0, 5, 10, 5},    {5, 5, -5, 5, true, 5, 5, 0, 5},
                         {-5, -5, 15, 15, true, 0, 0, 10, 10}, {-4, 3, 6, 15, true, 0, 7.8, 11.0 / 6, 10},
                         {-3, 12, 5, 16, false, 0, 0, 0, 0},   {-5, 8, 3, 20, false, 0, 0, 0, 0},
                         {5, 5, 5, 20, true, 5, 5, 5, 10},     {-1, 1, 1, -1, true, 0, 0, 0, 0}};
  for (int turn = 0; turn < 3; ++turn) {
    const auto at = [turn](double x, double y) {
      dvec3 p;
      p[turn] = x;
      p[(turn + 1) % 3] = y;
      p[(turn + 2) % 3] = 5;
      return p;
    };
    for (const Known& k : known) {
      const auto part = correctly_rounded(Piece{at(k.ax, k.ay), at(k.bx, k.by)}, ten);
      ASSERT_EQ(part.has_value(), k.kept);
      if (!part) continue;
      EXPECT_EQ(part->a, at(k.cx, k.cy));
      EXPECT_EQ(part->b, at(k.dx, k.dy));
    }
  }
}

TEST(CohenSutherland3d, SixCutsAtMostAndSixHappen) {
  // A diagonal through the unit cube, outside three faces at each end
  const Piece line{{-1, -1.25, -1.5}, {2, 2.25, 2.5}};
  Watcher<3> seen;
  const auto part = correctly_rounded(line, unit, usual, seen);
  ASSERT_TRUE(part);
  EXPECT_EQ(all<Cut3>(seen).size(), 6u);
  EXPECT_EQ(all<Classified3>(seen).front().code_a, 1 + 4 + 16);
  EXPECT_EQ(all<Classified3>(seen).front().code_b, 2 + 8 + 32);
  // Each cut clears the bit of its face, and none comes back
  int code_a = 21, code_b = 42;
  for (const auto& cut : all<Cut3>(seen)) {
    int& before = cut.of_a ? code_a : code_b;
    EXPECT_NE(before & bit(cut.face), 0);
    EXPECT_EQ(cut.after() & bit(cut.face), 0);
    EXPECT_EQ(cut.after() & ~before, 0);
    EXPECT_EQ(cut.to()[axis_of(cut.face)], coordinate(unit, cut.face));
    before = cut.after();
  }
  EXPECT_EQ(code_a | code_b, 0);
  EXPECT_EQ(all<Accepted3>(seen).front().line, *part);
  EXPECT_EQ(correctly_rounded(line, unit), part);
  // Another order, other cuts, the same part
  Order order = usual;
  std::sort(order.begin(), order.end());
  do {
    ASSERT_EQ(correctly_rounded(line, unit, order), part);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(CohenSutherland3d, UndecidedCodesMayStillMiss) {
  // No common bit, yet nothing inside: E001-25 in space
  const Piece line{{-5, 8, 5}, {3, 20, 5}};
  Watcher<3> seen;
  EXPECT_FALSE(correctly_rounded(line, ten, usual, seen));
  EXPECT_EQ(all<Cut3>(seen).size(), 1u);
  ASSERT_EQ(all<Rejected>(seen).size(), 1u);
  EXPECT_EQ(all<Rejected>(seen).front().common, 8);
  EXPECT_TRUE(all<Accepted3>(seen).empty());
}

TEST(CohenSutherland3d, PointsAndFlatBoxes) {
  EXPECT_EQ(correctly_rounded(Piece{{5, 5, 5}, {5, 5, 5}}, ten), (Piece{{5, 5, 5}, {5, 5, 5}}));
  EXPECT_EQ(correctly_rounded(Piece{{10, 0, 10}, {10, 0, 10}}, ten), (Piece{{10, 0, 10}, {10, 0, 10}}));
  EXPECT_FALSE(correctly_rounded(Piece{{5, 5, 11}, {5, 5, 11}}, ten));
  // A square, a segment, a point
  const Piece through{{1, 1, -1}, {3, 5, 3}};
  EXPECT_EQ(correctly_rounded(through, Cube{{0, 0, 1}, {4, 4, 1}}), (Piece{{2, 3, 1}, {2, 3, 1}}));
  EXPECT_EQ(correctly_rounded(through, Cube{{2, 0, 1}, {2, 4, 1}}), (Piece{{2, 3, 1}, {2, 3, 1}}));
  EXPECT_EQ(correctly_rounded(through, Cube{{2, 3, 1}, {2, 3, 1}}), (Piece{{2, 3, 1}, {2, 3, 1}}));
  EXPECT_FALSE(correctly_rounded(through, Cube{{2, 3, 1.5}, {2, 3, 1.5}}));
  EXPECT_EQ(correctly_rounded(Piece{{-1, 2, 1}, {9, 2, 1}}, Cube{{0, 0, 1}, {4, 4, 1}}),
            (Piece{{0, 2, 1}, {4, 2, 1}}));
}

TEST(CohenSutherland3d, ZerosArePlusZero) {
  const auto part = correctly_rounded(Piece{{-1, -1, -1}, {1, 1, 1}}, ten);
  ASSERT_TRUE(part);
  EXPECT_FALSE(std::signbit(part->a.y) || std::signbit(part->a.z));
}

TEST(CohenSutherland3d, RefusesByName) {
  const Piece line{{-1, 5, 5}, {11, 5, 5}};
  const auto refused = [](const Piece& s, const Cube& box, const Order& order = usual) {
    try {
      correctly_rounded(s, box, order);
    } catch (const ContractViolation& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  for (int axis = 0; axis < 3; ++axis) {
    Piece broken = line;
    broken.b[axis] = infinity;
    EXPECT_THROW(cut_of_a_cut(broken, ten), ContractViolation);
    Cube inside_out = ten;
    inside_out.lower[axis] = 11;
    EXPECT_THAT(refused(line, inside_out), ::testing::HasSubstr("from 11 to 10"));
  }
  Order twice = usual;
  twice[0] = Border::far;
  EXPECT_THAT(refused(line, ten, twice), ::testing::HasSubstr("each of the six faces once"));
}

// --- The view volume -------------------------------------------------------------------------------------

TEST(CohenSutherland3dVolume, CutsBeforeTheDivision) {
  // From in front of the eye to behind it: the piece ends at the right face, with x = w
  const Homogeneous line{{0, 0, 0.5, 1}, {2, 0, 0, -1}};
  const auto part = correctly_rounded(line, volume);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->a, line.a);
  EXPECT_EQ(part->b, dvec4(0.5, 0, 0.375, 0.5));
  EXPECT_EQ(part->b.x, part->b.w);
  // Dividing first would draw from 0 to -2, the wrong way
  EXPECT_EQ(line.b.x / line.b.w, -2);
  EXPECT_EQ(part->b.x / part->b.w, 1);
}

TEST(CohenSutherland3dVolume, BehindTheEyeNothingIsLeft) {
  for (const dvec4 a : {dvec4(0, 0, 0.5, -1), dvec4(1, 0, 1, 0), dvec4(-3, 2, -1, -0.5)}) {
    for (const dvec4 b : {dvec4(0, 0, 0.25, -2), dvec4(0, 1, 1, 0), dvec4(5, 5, -1, -1)}) {
      EXPECT_FALSE(correctly_rounded(Homogeneous{a, b}, volume));
      EXPECT_FALSE(correctly_rounded(Homogeneous{b, a}, volume));
    }
  }
}

TEST(CohenSutherland3dVolume, OnePieceForASegmentPastTheEye) {
  // Both ends outside, on the two sides of the eye; the piece between lies wholly before it
  const Homogeneous line{{-3, 0, 1, 2}, {5, 0, -0.5, -1}};
  Watcher<4> seen;
  const auto part = correctly_rounded(line, volume, usual, seen);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->a.x, -part->a.w);
  EXPECT_EQ(part->b.x, part->b.w);
  EXPECT_GT(part->b.w, 0);
  EXPECT_LE(all<Cut4>(seen).size(), 6u);
  // By hand: w + x = 2 - 3t + (-3 + 8t) = 5t - 1, w - x = 5 - 11t
  EXPECT_EQ(part->a, dvec4(-1.4, 0, 0.7, 1.4));
  EXPECT_EQ(part->b.w, 7.0 / 11);
}

TEST(CohenSutherland3dVolume, CopiesTheCoordinateOfEveryFace) {
  const dvec4 middle{0.1, 0.2, 0.7, 1.3};
  const std::pair<dvec4, Border> beyond[] = {
      {{-7, 0.3, 0.5, 1.1}, Border::left},   {{7, 0.3, 0.5, 1.1}, Border::right},
      {{0.3, -7, 0.5, 1.1}, Border::bottom}, {{0.3, 7, 0.5, 1.1}, Border::top},
      {{0.3, 0.1, -7, 1.1}, Border::near},   {{0.3, 0.1, 7, 1.1}, Border::far}};
  for (const auto& [end, face] : beyond) {
    const auto part = correctly_rounded(Homogeneous{middle, end}, volume);
    ASSERT_TRUE(part);
    const double across = part->b[axis_of(face)];
    EXPECT_EQ(across, face == Border::near ? 0 : is_upper(face) ? part->b.w : -part->b.w);
    EXPECT_FALSE(std::signbit(across) && across == 0);
    EXPECT_EQ(region_code(part->b, volume), 0);
    EXPECT_EQ(correctly_rounded(*part, volume), part);
  }
}

// What lies between 0 and minus half the smallest float, too
TEST(CohenSutherland3dVolume, ZerosOfFloatsArePlusZero) {
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Segment<4, float> line{{0, -smallest, 0.5f, 1}, {4, 0, 0.5f, 1}};
  const auto part = correctly_rounded(line, volume);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->b, glm::vec4(1, -smallest, 0.5f, 1));  // -3/4 of it
  const auto half = correctly_rounded(Segment<4, float>{{0, -smallest, 0.5f, 1}, {2, 0, 0.5f, 1}}, volume);
  ASSERT_TRUE(half);
  EXPECT_EQ(half->b.y, 0);  // -1/2 of it, a tie
  EXPECT_FALSE(std::signbit(half->b.y));
}

TEST(CohenSutherland3dVolume, RefusesWhatIsNoPoint) {
  const dvec4 point{0.5, 0.25, 0.5, 1};
  const auto refused = [](dvec4 a, dvec4 b) {
    try {
      correctly_rounded(Homogeneous{a, b}, volume);
    } catch (const ContractViolation& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused(point, point), "");
  EXPECT_THAT(refused(point, dvec4(0)), ::testing::HasSubstr("no homogeneous point"));
  EXPECT_THAT(refused(point, -3.0 * point), ::testing::HasSubstr("opposite"));
  EXPECT_EQ(refused(point, 3.0 * point), "");
  EXPECT_EQ(refused(point, dvec4(-0.5, -0.25, -0.5, std::nextafter(-1, 0))), "");
  EXPECT_NE(refused(point, dvec4(nan, 0, 0, 1)), "");
  EXPECT_NE(refused(point, dvec4(0, 0, 0, infinity)), "");
}

// --- Steps -----------------------------------------------------------------------------------------------

TEST(CohenSutherland3d, StepsFollowTheGrammarAndWatchingChangesNothing) {
  const Piece lines[] = {{{-1, -1.25, -1.5}, {2, 2.25, 2.5}},
                         {{0.5, 0.5, 0.5}, {0.25, 1, 0}},
                         {{-1, 5, 5}, {-2, 5, 5}},
                         {{-0.5, 0.8, 0.5}, {0.3, 2, 0.5}},
                         {{0.5, 0.5, 0.5}, {0.5, 0.5, 7}}};
  for (const Piece& line : lines) {
    const auto check = [&](auto method) {
      Watcher<3> seen;
      const auto part = method(seen);
      ASSERT_GE(seen.events().size(), 2u);
      EXPECT_TRUE(std::holds_alternative<Classified3>(seen.events().front().step));
      for (std::size_t i = 1; i + 1 < seen.events().size(); ++i) {
        EXPECT_TRUE(std::holds_alternative<Cut3>(seen.events()[i].step));
      }
      EXPECT_EQ(std::holds_alternative<Accepted3>(seen.events().back().step), part.has_value());
      EXPECT_EQ(std::holds_alternative<Rejected>(seen.events().back().step), !part.has_value());
    };
    check([&](auto& o) {
      const auto part = correctly_rounded(line, unit, usual, o);
      EXPECT_EQ(part, correctly_rounded(line, unit));
      return part;
    });
    check([&](auto& o) {
      const auto part = cut_of_a_cut(line, unit, usual, o);
      EXPECT_EQ(part, cut_of_a_cut(line, unit));
      return part;
    });
  }
}

}  // namespace
}  // namespace gradus::cohen_sutherland_3d
