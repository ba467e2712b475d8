// Known bodies, exact signs, goldens that break other tests.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>

#include "core/geometry.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

namespace gradus::back_face_culling {
namespace {

using V = glm::dvec4;

/// Corners in view space, seen through a lens of 90 degrees: x and y stay, w is the depth.
V clip(dvec3 view) { return {view.x, view.y, 0, view.z}; }

TEST(BackFaceCulling, ACubeShowsUpToThreeFaces) {
  // G001-74: the cube [-1,1]^3
  const std::array<std::array<dvec3, 3>, 6> faces{{{{{1, -1, -1}, {1, 1, -1}, {1, 1, 1}}},
                                                   {{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}}},
                                                   {{{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}}},
                                                   {{{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}}},
                                                   {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}}},
                                                   {{{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}}}}};
  const auto visible = [&](dvec3 eye, dvec3 target) {
    const Frame<double> frame = viewing::look_at(eye, target, dvec3{0.1, 0.2, 1});
    int count = 0;
    for (const auto& [a, b, c] : faces) {
      const auto at = [&](dvec3 p) { return clip(viewing::to_view(frame, p)); };
      count += facing(at(a), at(b), at(c)) == Facing::front;
    }
    return count;
  };
  EXPECT_EQ(visible({5, 0, 0}, {0, 0, 0}), 1);
  EXPECT_EQ(visible({5, 5, 0}, {0, 0, 0}), 2);
  EXPECT_EQ(visible({3, 4, 5}, {0, 0, 0}), 3);
  EXPECT_EQ(visible({0, 0, 0}, {1, 0, 0}), 0);  // from the inside, also those behind the viewer
  EXPECT_EQ(visible({3, 4, 5}, {9, 9, 9}), 3);  // looking away changes nothing
}

TEST(BackFaceCulling, CornersBehindTheEyeDoNotTurnItRound) {
  // N.V0 of these is +2 and -2; the notes call the positive ones back faces, for their corners run clockwise.
  // G001-92: the area in the picture has the other sign
  EXPECT_EQ(facing(clip({0, 0, 2}), clip({1, 0, 2}), clip({0, 1, -2})), Facing::front);
  // G001-91, E001-39: the normal's z has the other sign
  EXPECT_EQ(facing(clip({4, 0, 2}), clip({4, 1, 2}), clip({5, 0, 3})), Facing::front);
  EXPECT_EQ(facing(clip({-4, 0, 2}), clip({-4, 1, 2}), clip({-5, 0, 3})), Facing::back);
}

TEST(BackFaceCulling, FrontIsCounterClockwiseWithYUp) {
  EXPECT_EQ(facing(V{0, 0, 0, 1}, V{1, 0, 0, 1}, V{0, 1, 0, 1}), Facing::front);
  EXPECT_EQ(facing(V{0, 0, 0, 1}, V{0, 1, 0, 1}, V{1, 0, 0, 1}), Facing::back);
  EXPECT_EQ(facing(V{0, 0, 0, 1}, V{1, 1, 0, 1}, V{2, 2, 0, 1}), Facing::edge_on);
  EXPECT_EQ(facing(V{0, 0, 0, 0}, V{1, 1, 0, 1}, V{2, 0, 0, 1}), Facing::edge_on);
}

TEST(BackFaceCulling, FromInsideAClosedBodyAllFacesAreBacks) {
  // The face ahead of the eye, counter-clockwise from outside, turned to the six sides of a cube
  const dvec3 corners[] = {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      V face[3];
      for (int i = 0; i < 3; ++i) {
        const dvec3 p{side * corners[i].x, corners[i].y, side * corners[i].z};
        face[i] = V{p[axis], p[(axis + 1) % 3], 0, p[(axis + 2) % 3]};
      }
      EXPECT_EQ(facing(face[0], face[1], face[2]), Facing::back) << axis << ' ' << side;
    }
  }
}

TEST(BackFaceCulling, FarFromTheOriginNothingCancels) {
  // E002-12: six products of coordinates near 1e8 leave 0 of a doubled area of 0.825
  const double far = 1e8;
  const auto at = [&](double x, double y) { return V{far + x, far + y, 0, 1}; };
  EXPECT_EQ(facing(at(0, 0), at(1, 0.25), at(0.5, 0.875)), Facing::front);
  EXPECT_EQ(facing(at(0, 0), at(0.5, 0.875), at(1, 0.25)), Facing::back);
}

TEST(BackFaceCulling, TheSignIsExact) {
  // Seen in plain doubles these two have no area
  const double u = 0x1p-53;
  EXPECT_EQ(determinant_sign(V{0.5 + 2 * u, 0.5 + u, 0, 1}, V{12, 12, 0, 1}, V{24, 24, 0, 1}), -1);
  EXPECT_EQ(determinant_sign(V{0.5 + u, 0.5 + 2 * u, 0, 1}, V{12, 12, 0, 1}, V{24, 24, 0, 1}), 1);
}

TEST(BackFaceCulling, StepsAndMistakes) {
  Recorder<Tested<double>> seen;
  EXPECT_EQ(facing(V{0, 0, 0, 1}, V{1, 0, 0, 1}, V{0, 1, 0, 1}, seen), Facing::front);
  ASSERT_EQ(seen.seen(), 1u);
  EXPECT_EQ(all<Tested<double>>(seen)[0].sign, 1);
  EXPECT_EQ(facing(glm::vec4{0, 0, 0, 1}, glm::vec4{1, 0, 0, 1}, glm::vec4{0, 1, 0, 1}), Facing::front);
  EXPECT_THROW(facing(V{std::numeric_limits<double>::quiet_NaN(), 0, 0, 1}, V{1, 0, 0, 1}, V{0, 1, 0, 1}),
               ContractViolation);
}

TEST(BackFaceCullingNotes, OneCornerBehindTheEyeTurnsTheAreaRound) {
  // E001-40, G001-92: N.V0 = 2, which is the determinant, and -0.25 in the picture
  const V a = clip({0, 0, 2}), b = clip({1, 0, 2}), c = clip({0, 1, -2});
  EXPECT_EQ(glm::dot(dvec3(a.x, a.y, a.w), glm::cross(dvec3(b.x, b.y, b.w), dvec3(c.x, c.y, c.w))), 2);
  EXPECT_EQ(area_after_division(a, b, c), -0.25);
  EXPECT_EQ(facing_after_division(a, b, c), Facing::back);
  EXPECT_EQ(facing(a, b, c), Facing::front);
  // And the other way round: a back face that would be kept
  EXPECT_EQ(facing_after_division(a, c, b), Facing::front);
  EXPECT_EQ(facing(a, c, b), Facing::back);
}

TEST(BackFaceCullingNotes, WrongWithAnOddNumberOfCornersBehindTheEye) {
  Random random(20240611);
  int wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto number = [&](std::uint64_t most) {
      return static_cast<double>(random() % (2 * most + 1)) - static_cast<double>(most);
    };
    const auto corner = [&] {
      const double w = number(8);
      return V{number(20), number(20), 0, w == 0 ? 1 : w};
    };
    const V a = corner(), b = corner(), c = corner();
    // Exact in doubles: whole numbers below 2^53. Areas round, and are left out where they are next to 0
    const double determinant =
        glm::dot(dvec3(a.x, a.y, a.w), glm::cross(dvec3(b.x, b.y, b.w), dvec3(c.x, c.y, c.w)));
    if (determinant == 0) continue;
    const bool odd = (a.w < 0) ^ (b.w < 0) ^ (c.w < 0);
    EXPECT_EQ(facing(a, b, c), determinant > 0 ? Facing::front : Facing::back);
    EXPECT_EQ(facing_after_division(a, b, c) != facing(a, b, c), odd);
    wrong += odd;
  }
  EXPECT_GT(wrong, 500);
}

TEST(BackFaceCullingNotes, WithoutAPlaceInThePictureThereIsNoSide) {
  EXPECT_EQ(facing_after_division(V{0, 0, 0, 0}, V{1, 0, 0, 1}, V{0, 1, 0, 1}), Facing::edge_on);
  EXPECT_EQ(facing_after_division(V{0, 0, 0, 1}, V{1, 1, 0, 1}, V{2, 2, 0, 1}), Facing::edge_on);
  Recorder<Tested<double>> seen;
  facing_after_division(V{0, 0, 0, 1}, V{0, 1, 0, 1}, V{1, 0, 0, 1}, seen);
  ASSERT_EQ(seen.seen(), 1u);
  EXPECT_EQ(all<Tested<double>>(seen)[0].sign, -1);
  EXPECT_EQ(all<Tested<double>>(seen)[0].facing, Facing::back);
}

}  // namespace
}  // namespace gradus::back_face_culling
