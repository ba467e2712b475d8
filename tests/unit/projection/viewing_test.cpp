// Known frames, their laws, refusals.

#include "projection/viewing/viewing.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "support/seed.hpp"

namespace gradus::viewing {
namespace {

using DFrame = Frame<double>;

TEST(Viewing, GoldenFrame) {
  // G000-07, G000-08, G000-09: eye (2,3,5), target 0
  const DFrame frame = look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 1, 0});
  EXPECT_NEAR(glm::distance(frame.right, dvec3{5, 0, -2} / std::sqrt(29.0)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(frame.up, dvec3{-6, 29, -15} / std::sqrt(1102.0)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(frame.forward, dvec3{-2, -3, -5} / std::sqrt(38.0)), 0, 1e-15);
  EXPECT_NEAR(glm::dot(frame.right, glm::cross(frame.up, frame.forward)), -1, 1e-15);
  EXPECT_NEAR(glm::distance(to_view(frame, dvec3{0}), dvec3{0, 0, std::sqrt(38.0)}), 0, 1e-14);
}

TEST(Viewing, TheEyeIsTheOriginAndAheadIsDepth) {
  // G004-01, G004-02, G004-03
  const DFrame frame{{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_EQ(to_view(frame, dvec3{1, 2, 3}), (dvec3{0}));
  EXPECT_EQ(to_view(frame, dvec3{6, 2, 3}), (dvec3{0, 0, 5}));
  const glm::dmat4 m = view_matrix(frame);
  EXPECT_EQ(dvec3(m[3]), (dvec3{3, -2, -1}));
  EXPECT_EQ(dvec3(m * glm::dvec4{6, 2, 3, 1}), (dvec3{0, 0, 5}));
}

TEST(Viewing, DefaultFrameReadsASheetOfPaper) {
  const DFrame frame = look_at(dvec3{0, 0, 4}, dvec3{0}, dvec3{0, 1, 0});
  EXPECT_EQ(to_view(frame, dvec3{1, 2, 0}), (dvec3{1, 2, 4}));
  EXPECT_EQ(to_view(DFrame{}, dvec3{1, 2, -3}), (dvec3{1, 2, 3}));
}

TEST(Viewing, FramesAreUprightForAnyInput) {
  Random random(test::seed());
  int cases = 0;
  for (; cases < 20000; ++cases) {
    const auto any = [&](double size) {
      return dvec3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    const dvec3 eye = any(10), target = any(10);
    dvec3 up = any(1e-100);
    if (random.uniform_int(0, 3) == 0) up = target - eye + any(1e-9);  // nearly parallel
    if (sine_between(target - eye, up) < 2 * least_sine<double>) continue;
    const DFrame f = look_at(eye, target, up);
    for (const dvec3 axis : {f.right, f.up, f.forward}) ASSERT_NEAR(glm::length(axis), 1, 2e-15);
    ASSERT_NEAR(glm::dot(f.right, f.up), 0, 2e-15);
    ASSERT_NEAR(glm::dot(f.right, f.forward), 0, 2e-15);
    ASSERT_NEAR(glm::dot(f.up, f.forward), 0, 2e-15);
    ASSERT_NEAR(glm::dot(f.right, glm::cross(f.up, f.forward)), -1, 4e-15);
    ASSERT_GT(glm::dot(f.up, up), 0);
    const dvec3 seen = to_view(f, target);
    ASSERT_NEAR(seen.x, 0, 1e-13);
    ASSERT_NEAR(seen.y, 0, 1e-13);
    ASSERT_GT(seen.z, 0);
  }
  EXPECT_EQ(cases, 20000);
}

TEST(Viewing, MistakesAreNamed) {
  const auto reason = [](dvec3 eye, dvec3 target, dvec3 up) -> std::string {
    try {
      look_at(eye, target, up);
    } catch (const ContractViolation& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(reason({0, 5, 0}, {0, 0, 0}, {0, 1, 0}), "up (0, 1, 0) is parallel to the view direction");
  EXPECT_NE(reason({0, 5, 0}, {0, 0, 0}, {1e-17, 1, 0}), "");  // rounding would decide where right is
  EXPECT_NE(reason({0, 5, 0}, {0, 0, 0}, {0, -3, 0}), "");
  EXPECT_EQ(reason({1, 2, 3}, {1, 2, 3}, {0, 1, 0}), "the eye and the target are the same point (1, 2, 3)");
  EXPECT_EQ(reason({0, 0, 5}, {0, 0, 0}, {0, 0, 0}), "up is the zero vector, which points nowhere");
  EXPECT_EQ(reason({0, 5, 0}, {0, 0, 0}, {1e-6, 1, 0}), "");
}

TEST(Viewing, StepsFollowTheGrammar) {
  Recorder<Aimed<double>, Levelled<double>, Framed<double>> seen;
  const DFrame frame = look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 2, 0}, seen);
  ASSERT_EQ(seen.events().size(), 3u);
  EXPECT_EQ(std::get<Aimed<double>>(seen.events()[0].step).forward, frame.forward);
  EXPECT_EQ(std::get<Levelled<double>>(seen.events()[1].step).right, frame.right);
  EXPECT_EQ(std::get<Framed<double>>(seen.events()[2].step).frame.up, frame.up);
  EXPECT_EQ(look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 2, 0}).up, frame.up);  // observed == unobserved

  Recorder<Viewed<double>> viewed;
  EXPECT_EQ(to_view(frame, dvec3{1, 1, 1}, viewed), to_view(frame, dvec3{1, 1, 1}));
  EXPECT_EQ(viewed.seen(), 1u);
}

TEST(Viewing, OneBodyForEveryScalar) {
  const Frame<float> f = look_at(glm::vec3{2, 3, 5}, glm::vec3{0}, glm::vec3{0, 1, 0});
  EXPECT_NEAR(to_view(f, glm::vec3{0}).z, std::sqrt(38.0f), 1e-5f);
  const ExactScope scope;
  const Frame<Exact> exact{{Exact(1, 3), Exact(0), Exact(0)},
                           {Exact(1), Exact(0), Exact(0)},
                           {Exact(0), Exact(1), Exact(0)},
                           {Exact(0), Exact(0), Exact(-1)}};
  EXPECT_EQ(to_view(exact, ExactVec3{Exact(1), Exact(2), Exact(3)}),
            (ExactVec3{Exact(2, 3), Exact(2), Exact(-3)}));
}

}  // namespace
}  // namespace gradus::viewing
