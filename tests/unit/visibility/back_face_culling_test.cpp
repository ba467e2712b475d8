// Known bodies, exact signs, goldens that break other tests.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/arithmetic/counted.hpp"
#include "core/arithmetic/exact_scalar.hpp"
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
  // E001-40, G001-92: N.V0 = 2, which is the determinant, and -0.25 in the picture. To the notes, whose front
  // faces run clockwise, it is hidden, and by its area in the picture seen
  const std::vector<dvec3> triangle{{0, 0, 2}, {1, 0, 2}, {0, 1, -2}};
  EXPECT_EQ(glm::dot(newell_normal<double>(triangle), triangle[0]), 2);
  const V a = clip({0, 0, 2}), b = clip({1, 0, 2}), c = clip({0, 1, -2});
  EXPECT_EQ(glm::dot(dvec3(a.x, a.y, a.w), glm::cross(dvec3(b.x, b.y, b.w), dvec3(c.x, c.y, c.w))), 2);
  EXPECT_EQ(divided_area(a, b, c), -0.25);
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

// --- Faces of any number of corners

using Ring = std::vector<dvec3>;
using Ring2 = std::vector<dvec2>;

std::vector<Face<double>> spans(const std::vector<Ring>& rings) { return {rings.begin(), rings.end()}; }

/// The numbers of the faces that a method draws.
template <class Method>
std::vector<std::size_t> drawn(const Method& method) {
  std::vector<std::size_t> faces;
  method([&](std::size_t i) { faces.push_back(i); });
  return faces;
}
std::vector<std::size_t> seen_from(const std::vector<Ring>& rings, const Eye<double>& eye) {
  return drawn([&](const auto& draw) { normal_and_view<double>(spans(rings), eye, draw); });
}
/// By the picture: the eye looks along -z of the world, from (0, 0, height), at a picture 1 away.
Ring2 seen_from_above(const Ring& ring, double height) {
  Ring2 outline;
  for (const dvec3 p : ring) outline.push_back(dvec2(p) / (height - p.z));
  return outline;
}
std::vector<std::size_t> by_area(const std::vector<Ring2>& rings) {
  const std::vector<Outline<double>> outlines(rings.begin(), rings.end());
  return drawn([&](const auto& draw) { screen_area<double>(outlines, draw); });
}

/// What a method says of its only face.
template <class T, class Method>
Judged<T> judged(const Method& method) {
  std::vector<Judged<T>> all;
  method([](std::size_t) {},
         [&]<class Step>(const Step& step) {
           if constexpr (std::same_as<Step, Judged<T>>) all.push_back(step);
         });
  return all.at(0);
}

/// Front and back of z, then of y, then of x.
std::vector<Ring> cube() {
  return {
      {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}},
      {{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}}, {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}},
      {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}, {{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}}};
}
/// (0,0) (3,0) (3,1) (1,1) (1,3) (0,3) in x and z, 1 deep. Face 3 is that over the step, at x = 1.
std::vector<Ring> l_prism() {
  const Ring2 outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  std::vector<Ring> faces;
  for (std::size_t i = 0; i < 6; ++i) {
    const dvec2 a = outline[i], b = outline[(i + 1) % 6];
    faces.push_back({{a.x, 0, a.y}, {a.x, 1, a.y}, {b.x, 1, b.y}, {b.x, 0, b.y}});
  }
  Ring near, far;
  for (const dvec2 p : outline) near.push_back({p.x, 0, p.y});
  for (std::size_t i = 6; i-- > 0;) far.push_back({outline[i].x, 1, outline[i].y});
  faces.push_back(near);
  faces.push_back(far);
  return faces;
}

TEST(BackFaceCulling, ACubeByNormalAndView) {
  // G001-74, and eyes that are infinitely far away
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(seen_from(cube(), {5, 0, 0, 1}), (Numbers{4}));
  EXPECT_EQ(seen_from(cube(), {5, 5, 0, 1}), (Numbers{2, 4}));
  EXPECT_EQ(seen_from(cube(), {3, 4, 5, 1}), (Numbers{0, 2, 4}));
  EXPECT_EQ(seen_from(cube(), {0, 0, 0, 1}), Numbers{});
  EXPECT_EQ(seen_from(cube(), {5, 0, 1, 1}), (Numbers{4}));  // in the plane of face 0
  EXPECT_EQ(seen_from(cube(), {0, -2, 0, 0}), (Numbers{3}));
  EXPECT_EQ(seen_from(cube(), {1, 2, 3, 0}), (Numbers{0, 2, 4}));
}

TEST(BackFaceCulling, OneTestAFace) {
  // R001-104
  for (const auto& body : {cube(), l_prism()}) {
    Recorder<NormalFound<double>, ViewTaken<double>, Judged<double>, Finished> seen;
    std::size_t count = 0;
    normal_and_view<double>(spans(body), {7, 8, 9, 1}, [&](std::size_t) { ++count; }, seen);
    EXPECT_EQ(all<Judged<double>>(seen).size(), body.size());
    EXPECT_EQ(all<NormalFound<double>>(seen).size(), body.size());
    EXPECT_EQ(all<ViewTaken<double>>(seen).size(), body.size());
    ASSERT_EQ(all<Finished>(seen).size(), 1u);
    EXPECT_EQ(all<Finished>(seen)[0].tests, body.size());
    EXPECT_EQ(all<Finished>(seen)[0].drawn, count);
  }
}

TEST(BackFaceCulling, NewellsNormalIsThatOfAllCorners) {
  // G001-75
  const Ring l{{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(newell_normal<double>(l), dvec3(0, 0, 6));
  // From whichever corner on
  Ring turned = l;
  for (std::size_t i = 0; i < l.size(); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    EXPECT_EQ(newell_normal<double>(turned), dvec3(0, 0, 6));
  }
  EXPECT_EQ(newell_normal<double>(Ring{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}}), dvec3(0, 0, 4));
  EXPECT_EQ(newell_normal<double>(Ring{{1, 1, 1}, {2, 2, 2}, {5, 5, 5}}), dvec3(0));
  EXPECT_EQ(newell_normal<float>(std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}),
            glm::vec3(0, 0, 4));
  EXPECT_THROW(newell_normal<double>(Ring{{1, 1, 1}, {2, 2, 2}}), ContractViolation);
}

TEST(BackFaceCulling, SpaceAndPictureAgreeOnFlatFaces) {
  // R001-132, G001-90: N'z z0 z1 z2 = N.V0 for the triangle in the picture, without rounding
  Random random(90);
  int fronts = 0;
  const ExactScope scope;
  for (int i = 0; i < 2000; ++i) {
    Ring ring(3);
    for (dvec3& p : ring)
      p = {double(random.uniform_int(-20, 20)), double(random.uniform_int(-20, 20)),
           double(random.uniform_int(-20, 9))};
    const std::vector<ExactVec3> rationals(ring.begin(), ring.end());
    std::vector<ExactVec2> outline;
    Exact depths(1);
    for (const ExactVec3& p : rationals) {
      const Exact depth = Exact(10) - p.z;
      outline.push_back(ExactVec2{p.x, p.y} / depth);
      depths *= depth;
    }
    const std::vector<Face<Exact>> faces{rationals};
    const std::vector<Outline<Exact>> outlines{outline};
    const Eye<Exact> eye{Exact(0), Exact(0), Exact(10), Exact(1)};
    const auto in_space =
        judged<Exact>([&](const auto&... with) { normal_and_view<Exact>(faces, eye, with...); });
    const auto in_picture =
        judged<Exact>([&](const auto&... with) { screen_area<Exact>(outlines, with...); });
    EXPECT_EQ(in_picture.value * depths, in_space.value);
    EXPECT_EQ(in_space.sign, in_picture.sign);
    EXPECT_EQ(seen_from({ring}, {0, 0, 10, 1}).size(), in_space.sign > 0 ? 1u : 0u);
    fronts += in_space.sign > 0;
  }
  EXPECT_GT(fronts, 800);
}

TEST(BackFaceCulling, AQuadThatIsNotFlatMayShowItsFrontInSpaceAndItsBackInThePicture) {
  const Ring quad{{-3, 2, 3}, {3, -2, 0}, {3, 3, 3}, {1, -3, 3}};
  EXPECT_EQ(seen_from({quad}, {0, 0, 6, 1}).size(), 1u);
  EXPECT_EQ(by_area({seen_from_above(quad, 6)}).size(), 0u);
}

TEST(BackFaceCulling, ASliverTurnsRoundWhenItsCornersAreSnapped) {
  // Counter-clockwise by a doubled area of 0.16; rounded to whole pixels, clockwise by 6
  const Ring2 sliver{{0.4, 0.4}, {4.4, 1.6}, {8.6, 2.9}};
  Ring2 snapped = sliver;
  for (dvec2& p : snapped) p = {std::floor(p.x + 0.5), std::floor(p.y + 0.5)};
  EXPECT_EQ(by_area({sliver}).size(), 1u);
  EXPECT_EQ(orient2d(snapped[0], snapped[1], snapped[2]), -1);
  EXPECT_EQ(by_area({snapped}).size(), 0u);
}

TEST(BackFaceCulling, WhatItCannotDoOnAConcaveBody) {
  // R001-105: from (20, 0.5, 0.9) the face at x = 1, z from 1 to 3, shows its front, and below z = 86/85 the
  // block before it covers it
  const auto prism = l_prism();
  EXPECT_EQ(seen_from(prism, {20, 0.5, 0.9, 1}), (std::vector<std::size_t>{1, 3}));
  const ExactScope scope;
  const Exact half = Exact(1) / Exact(2);
  // Where the sight line to (1, 1/2, z) passes x = 3, the edge of the block: above z = 1 or below
  const auto height_at_block = [&](const Exact& z) {
    const Exact eye_z = Exact(9) / Exact(10);
    return eye_z + (z - eye_z) * (Exact(17) / Exact(19));
  };
  const Exact bound = Exact(86) / Exact(85);
  EXPECT_EQ(height_at_block(bound), Exact(1));
  EXPECT_TRUE(height_at_block(bound - Exact(1) / Exact(1000)) < Exact(1));
  EXPECT_TRUE(height_at_block(bound + Exact(1) / Exact(1000)) > Exact(1));
  EXPECT_TRUE(Exact(1) < bound && bound < Exact(3) && half < Exact(1));
}

TEST(BackFaceCulling, BeforeTheDivisionPolygonsAsTriangles) {
  // G001-92: one corner behind the eye
  const std::vector<Ring> faces{{{0, 0, 2}, {1, 0, 2}, {0, 1, -2}},
                                {{0, 0, 2}, {0, 1, -2}, {1, 0, 2}},
                                {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};
  const auto all_spans = spans(faces);
  EXPECT_EQ(drawn([&](const auto& draw) { homogeneous<double>(all_spans, draw); }),
            (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(drawn([&](const auto& draw) { after_division<double>(all_spans, draw); }),
            (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(facing(clip(faces[0][0]), clip(faces[0][1]), clip(faces[0][2])), Facing::front);
}

TEST(BackFaceCulling, SignsDoNotDependOnRounding) {
  // Doubled areas of 1.3e-15, which plain doubles call 0
  const double u = 0x1p-53;
  EXPECT_EQ(
      by_area({{{0.5 + u, 0.5 + 2 * u}, {12, 12}, {24, 24}}, {{0.5 + 2 * u, 0.5 + u}, {12, 12}, {24, 24}}}),
      (std::vector<std::size_t>{0}));
  // The same in space, the eye straight above
  EXPECT_EQ(seen_from({{{0.5 + u, 0.5 + 2 * u, 0}, {12, 12, 0}, {24, 24, 0}},
                       {{0.5 + 2 * u, 0.5 + u, 0}, {12, 12, 0}, {24, 24, 0}}},
                      {0, 0, 1, 0}),
            (std::vector<std::size_t>{0}));
  // 1e8 from the origin
  EXPECT_EQ(by_area({{{1e8, 1e8}, {1e8 + 1, 1e8 + 0.25}, {1e8 + 0.5, 1e8 + 0.875}}}).size(), 1u);
}

TEST(BackFaceCulling, FacesThatCannotBe) {
  const auto drop = [](std::size_t) {};
  const std::vector<Ring> two{{{0, 0, 0}, {1, 0, 0}}};
  const std::vector<Ring2> two_flat{{{0, 0}, {1, 0}}};
  const std::vector<Ring> no_number{{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}};
  EXPECT_THROW(normal_and_view<double>(spans(two), {0, 0, 1, 0}, drop), ContractViolation);
  EXPECT_THROW(normal_and_view<double>(spans(no_number), {0, 0, 1, 0}, drop), ContractViolation);
  EXPECT_THROW(normal_and_view<double>(spans(cube()), {0, 0, 1, 0.5}, drop), ContractViolation);
  EXPECT_THROW(screen_area<double>(std::vector<Outline<double>>{two_flat[0]}, drop), ContractViolation);
  EXPECT_THROW(homogeneous<double>(spans(no_number), drop), ContractViolation);
}

// --- Exhibits of faces

TEST(BackFaceCullingNotes, TheFirstThreeCornersMayTurnTheNormalRound) {
  // E001-30, G001-75
  const Ring l{{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};
  Recorder<NormalFound<double>, ViewTaken<double>, Judged<double>, Finished> seen;
  const std::vector<Ring> rings{l, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}}};
  const Eye<double> above{1, 1, 5, 1};
  EXPECT_EQ(
      drawn([&](const auto& draw) { first_three_corners<double>(spans(rings), above, draw, seen); }).size(),
      0u);
  EXPECT_EQ(all<NormalFound<double>>(seen).at(0).normal, dvec3(0, 0, -1));
  EXPECT_EQ(all<NormalFound<double>>(seen).at(1).normal, dvec3(0));
  EXPECT_EQ(seen_from(rings, above).size(), 2u);
}

TEST(BackFaceCullingNotes, TheNormalInViewSpaceForgetsThePerspective) {
  // E001-39, G001-91: N = (1, 0, -1), N.V0 = 2; in the picture N'z = 1/6
  const std::vector<Ring> faces{{{4, 0, 2}, {4, 1, 2}, {5, 0, 3}}, {{-4, 0, 2}, {-4, 1, 2}, {-5, 0, 3}}};
  EXPECT_EQ(newell_normal<double>(faces[0]), dvec3(1, 0, -1));
  // To the notes, whose front faces run clockwise, it shows where N.V0 < 0: it is hidden, and by Nz seen
  EXPECT_EQ(glm::dot(newell_normal<double>(faces[0]), faces[0][0]), 2);
  EXPECT_LT(newell_normal<double>(faces[0]).z, 0);
  EXPECT_EQ(newell_normal<double>(faces[1]), dvec3(1, 0, 1));
  EXPECT_EQ(drawn([&](const auto& draw) { homogeneous<double>(spans(faces), draw); }),
            (std::vector<std::size_t>{0}));
  EXPECT_EQ(drawn([&](const auto& draw) { eye_space_normal<double>(spans(faces), draw); }),
            (std::vector<std::size_t>{1}));
  EXPECT_NEAR(divided_area(clip(faces[0][0]), clip(faces[0][1]), clip(faces[0][2])), 1.0 / 6, 1e-12);
}

TEST(BackFaceCullingNotes, TheShoelacesFirstTermIsMisprinted) {
  // E002-10, G002-08
  const Ring2 triangle{{1, 1}, {5, 2}, {2, 6}};
  const std::vector<Outline<double>> outlines{triangle};
  const auto right = [&](const auto&... with) { screen_area<double>(outlines, with...); };
  const auto wrong = [&](const auto&... with) { misprinted_shoelace<double>(outlines, with...); };
  EXPECT_EQ(judged<double>(right).value, 19);
  EXPECT_EQ(judged<double>(wrong).value, 18);
  // A thin one comes out with the wrong sign
  const Ring2 thin{{2, 1}, {6, 3}, {10, 5.25}};
  EXPECT_EQ(by_area({thin}).size(), 1u);
  EXPECT_TRUE(drawn([&](const auto& draw) {
                misprinted_shoelace<double>(std::vector<Outline<double>>{thin}, draw);
              }).empty());
}

TEST(BackFaceCullingNotes, SixProductsCancelFarFromTheOrigin) {
  // E002-12: a doubled area of 0.825; from 1e8 on 0 is left
  const auto value = [](double far) {
    const Ring2 t{{far, far}, {far + 1, far + 0.1}, {far + 0.5, far + 0.875}};
    const std::vector<Outline<double>> outlines{t};
    EXPECT_EQ(by_area({t}).size(), 1u);
    return judged<double>([&](const auto&... with) { six_products<double>(outlines, with...); }).value;
  };
  EXPECT_NEAR(value(0), 0.825, 1e-15);
  EXPECT_EQ(value(1e8), 0);
}

TEST(BackFaceCullingNotes, RowsCountedDownwardsTurnTheSignRound) {
  // G002-09: (0,0) (4,0) (0,3) with y down has 12, and its corners run clockwise on the screen: the notes'
  // code culls what is positive, their prose what is negative
  const Ring2 rows{{0, 0}, {4, 0}, {0, 3}};
  Ring2 upright = rows;
  for (dvec2& p : upright) p.y = -p.y;
  EXPECT_EQ(orient2d(rows[0], rows[1], rows[2]), 1);
  EXPECT_EQ(by_area({upright}).size(), 0u);
  EXPECT_EQ(by_area({rows}).size(), 1u);
}

TEST(BackFaceCulling, ATriangleTakesTheOperationsThatItsHeaderNames) {
  using Vec3 = glm::vec<3, Counted>;
  using Vec2 = glm::vec<2, Counted>;
  const std::array space{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}};
  const std::array picture{Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}};
  constexpr int triangles = 2;
  EXPECT_EQ(operations_of([&] { newell_normal<Counted>(space); }),
            (Operations{triangles * 12, triangles * 6, 0}));
  const std::array outlines{Outline<Counted>(picture)};
  const auto drop = [](std::size_t) {};
  EXPECT_EQ(operations_of([&] { screen_area<Counted>(outlines, drop); }),
            (Operations{triangles * 6, triangles * 2, 0}));
  const std::array faces{Face<Counted>(space)};
  EXPECT_EQ(operations_of([&] { after_division<Counted>(faces, drop); }),
            (Operations{triangles * 6, triangles * 2, 2 + triangles * 4}));
}

}  // namespace
}  // namespace gradus::back_face_culling
