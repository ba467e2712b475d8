// Frames with rational axes against look_at, matrices against rationals, inverses of huge and tiny frames.

#include "projection/viewing/viewing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "projection/viewing/viewing_notes.hpp"
#include "support/seed.hpp"

namespace gradus::viewing {
namespace {

using DFrame = Frame<double>;
constexpr double ulp = std::numeric_limits<double>::epsilon();

ExactVec3 exactly(dvec3 v) { return {Exact(v.x), Exact(v.y), Exact(v.z)}; }
Frame<Exact> exactly(const DFrame& f) {
  return {exactly(f.eye), exactly(f.right), exactly(f.up), exactly(f.forward)};
}
dvec3 whole(Random& random, int most) {
  const auto one = [&] { return static_cast<double>(random.uniform_int(-most, most)); };
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}
double largest(dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
/// The largest component of value - exact.
double miss(dvec3 value, const ExactVec3& exact) {
  dvec3 difference;
  for (int i = 0; i < 3; ++i) difference[i] = to_double(Exact(value[i]) - exact[i]);
  return largest(difference);
}

/// Axes of length 1 at right angles, all of them rational: the rotation of a quaternion of whole numbers
/// (each row is a Pythagorean quadruple over its norm), mirrored so that right = forward x up.
struct RationalFrame {
  std::int64_t norm;         ///< what all entries are divided by
  dvec3 right, up, forward;  ///< times norm: whole numbers
  ExactVec3 exact(dvec3 axis) const {
    return {Exact(axis.x) / Exact(norm), Exact(axis.y) / Exact(norm), Exact(axis.z) / Exact(norm)};
  }
};
std::optional<RationalFrame> rational_frame(Random& random, int most) {
  const auto one = [&] { return random.uniform_int(-most, most); };
  const std::int64_t a = one(), b = one(), c = one(), d = one();
  const std::int64_t norm = a * a + b * b + c * c + d * d;
  if (norm == 0) return std::nullopt;
  const auto whole_vector = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return dvec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  const dvec3 x = whole_vector(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c));
  const dvec3 y = whole_vector(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b));
  const dvec3 z = whole_vector(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d);
  return RationalFrame{norm, x, y, -z};
}

TEST(ViewingProperty, LookAtFindsRationalFrames) {
  Random random(test::seed());
  int cases = 0, slanted = 0, huge = 0;
  double worst_forward = 0, worst_right = 0, worst_up = 0;
  while (cases < 8000) {
    const ExactScope scope;
    const auto wanted = rational_frame(random, 40);
    if (!wanted) continue;
    ++cases;
    // A hint that leans towards or away from the target: up + k forward, of any size; a view of any size
    const int lean = random.uniform_int(0, 1) ? 0 : static_cast<int>(random.uniform_int(-1000, 1000));
    const double size = std::scalbn(1.0, static_cast<int>(random.uniform_int(-900, 900)));
    const double hint_size = std::scalbn(1.0, static_cast<int>(random.uniform_int(-900, 900)));
    slanted += lean != 0;
    huge += size > 1e100;
    const dvec3 eye = size * whole(random, 1000);
    const DFrame f =
        look_at(eye, eye + size * wanted->forward, hint_size * (wanted->up + double(lean) * wanted->forward));
    const double sine = 1 / std::sqrt(1 + double(lean) * lean);
    worst_forward = std::max(worst_forward, miss(f.forward, wanted->exact(wanted->forward)) / ulp);
    worst_right = std::max(worst_right, miss(f.right, wanted->exact(wanted->right)) / ulp * sine);
    worst_up = std::max(worst_up, miss(f.up, wanted->exact(wanted->up)) / ulp * sine);
  }
  std::printf(
      "%d frames, %d with a slanted hint, %d huge: forward %.3g ulp of 1, right %.3g and up %.3g / sine\n",
      cases, slanted, huge, worst_forward, worst_right, worst_up);
  EXPECT_EQ(cases, 8000);
  EXPECT_GT(slanted, 2000);
  EXPECT_GT(huge, 2000);
  EXPECT_LT(worst_forward, 1);
  EXPECT_LT(worst_right, 2);
  EXPECT_LT(worst_up, 2);
}

TEST(ViewingProperty, TheTargetLandsOnTheAxis) {
  Random random(test::seed());
  int cases = 0;
  double worst = 0;
  while (cases < 20000) {
    const auto any = [&](double size) {
      const double x = random.uniform(-size, size), y = random.uniform(-size, size),
                   z = random.uniform(-size, size);
      return dvec3{x, y, z};
    };
    const double size = std::scalbn(1.0, static_cast<int>(random.uniform_int(-300, 300)));
    const dvec3 eye = any(size), target = any(size), up = any(1);
    if (sine_between(target - eye, up) < 2 * least_sine<double>) continue;
    ++cases;
    const dvec3 seen = to_view(look_at(eye, target, up), target);
    const double distance = length_of(target - eye);
    worst = std::max(worst, largest(seen - dvec3{0, 0, distance}) / distance / ulp);
  }
  std::printf("%d targets, worst %.3g ulp of the distance\n", cases, worst);
  EXPECT_EQ(cases, 20000);
  EXPECT_LT(worst, 4);
}

TEST(ViewingProperty, PointsAndMatricesAgreeWithRationals) {
  Random random(test::seed());
  int cases = 0, elsewhere = 0, exact_inverses = 0;
  double worst_point = 0, worst_shift = 0, worst_product = 0;
  while (cases < 2000) {
    const ExactScope scope;
    const auto axes = rational_frame(random, 30);
    if (!axes) continue;
    ++cases;
    const Frame<Exact> exact{exactly(whole(random, 1000)), axes->exact(axes->right), axes->exact(axes->up),
                             axes->exact(axes->forward)};
    // In rationals: a true frame, its matrix inverted by its transpose, and both inverses the same
    const Matrix<Exact> there = world_to_view(exact), back = view_to_world(exact);
    ASSERT_TRUE(is_upright(exact));
    ASSERT_EQ(back * there, Matrix<Exact>(Exact(1)));
    ASSERT_EQ(back, inverse_of_any_frame(exact));
    ASSERT_EQ(glm::dot(exact.right, glm::cross(exact.up, exact.forward)), Exact(-1));
    ++exact_inverses;
    const dvec3 p = whole(random, 1000);
    const ExactVec3 seen = to_view(exact, exactly(p));
    ASSERT_EQ(ExactVec3(there * glm::vec<4, Exact>(exactly(p), Exact(1))), seen);
    const ExactVec3 aside = exactly(p) - exact.eye;
    ASSERT_EQ(glm::dot(seen, seen), glm::dot(aside, aside));  // distances are kept
    // The exhibits go wrong unless nothing is turned
    elsewhere += transposed(exact) != there && minus_position(exact) != there;

    // In doubles, against the rationals of the very same frame
    DFrame rounded;
    for (int i = 0; i < 3; ++i) {
      rounded.eye[i] = to_double(exact.eye[i]);
      rounded.right[i] = to_double(exact.right[i]);
      rounded.up[i] = to_double(exact.up[i]);
      rounded.forward[i] = to_double(exact.forward[i]);
    }
    const Frame<Exact> same = exactly(rounded);
    const double distance = glm::length(p - rounded.eye), reach = glm::length(rounded.eye);
    if (distance > 0) {
      worst_point =
          std::max(worst_point, miss(to_view(rounded, p), to_view(same, exactly(p))) / distance / ulp);
    }
    const glm::dmat4 matrix = world_to_view(rounded);
    if (reach > 0) {
      worst_shift =
          std::max(worst_shift, miss(dvec3(matrix[3]), ExactVec3(world_to_view(same)[3])) / reach / ulp);
    }
    const dvec3 by_matrix = dvec3(matrix * glm::dvec4(p, 1));
    worst_product =
        std::max(worst_product, miss(by_matrix, to_view(same, exactly(p))) / (reach + glm::length(p)) / ulp);
  }
  std::printf(
      "%d frames: points %.3g ulp of the distance, last column %.3g ulp of |eye|, by matrix %.3g ulp of "
      "|eye| + |point|\n",
      cases, worst_point, worst_shift, worst_product);
  EXPECT_EQ(cases, 2000);
  EXPECT_EQ(exact_inverses, 2000);
  EXPECT_GT(elsewhere, 1900);
  EXPECT_LT(worst_point, 2);
  EXPECT_LT(worst_shift, 1.5);
  EXPECT_LT(worst_product, 2);
}

TEST(ViewingProperty, FarFromTheOriginTheMatrixLosesWhatThePointKeeps) {
  // The same view 2^40 away: to_view subtracts the eye first and loses nothing, the matrix afterwards
  const dvec3 far = dvec3{0x1p40, -0x1p41, 0x1p40};
  const DFrame near = look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 1, 0});
  DFrame away = near;
  away.eye = far + near.eye;
  const dvec3 p{0.25, 1.5, -0.125};
  EXPECT_EQ(to_view(away, far + p), to_view(near, p));
  const double lost = largest(dvec3(world_to_view(away) * glm::dvec4(far + p, 1)) - to_view(near, p));
  std::printf("2^40 away the matrix is off by %.3g\n", lost);
  EXPECT_GT(lost, 1e-6);
  EXPECT_LT(lost, 0x1p41 * 4 * ulp);
}

TEST(ViewingProperty, InversesOfAnyFrame) {
  Random random(test::seed());
  int cases = 0, flat = 0, stretched = 0;
  double worst = 0;
  while (cases < 2500) {
    const ExactScope scope;
    const auto any = [&] {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
      return std::scalbn(1.0, static_cast<int>(random.uniform_int(-900, 900))) * dvec3{x, y, z};
    };
    DFrame f{whole(random, 1000), any(), any(), any()};
    const bool nearly = random.uniform_int(0, 3) == 0;
    if (nearly) {
      f.up = any();
      f.forward = f.right * random.uniform(-1, 1) +
                  length_of(f.right) * unit_vector(f.up) * random.uniform(-1, 1) +
                  random.uniform(-1e-6, 1e-6) * length_of(f.right) * unit_vector(any());
    }
    const dvec3 x = Scaled<double>(f.right).vector, y = Scaled<double>(f.up).vector,
                z = Scaled<double>(f.forward).vector;
    const double det = std::abs(glm::dot(x, glm::cross(y, z)));
    if (det < 2000 * ulp) {
      ++flat;
      continue;
    }
    ++cases;
    stretched += !is_upright(f);
    ASSERT_THROW(view_to_world(f), ContractViolation);
    const glm::dmat4 back = inverse_of_any_frame(f);
    const Matrix<Exact> truth = inverse_of_any_frame(exactly(f));
    ASSERT_EQ(truth * world_to_view(exactly(f)), Matrix<Exact>(Exact(1)));
    for (int column = 0; column < 3; ++column) {
      double size = 0, off = 0;
      for (int row = 0; row < 3; ++row) {
        size = std::max(size, std::abs(to_double(truth[column][row])));
        off = std::max(off, std::abs(to_double(Exact(back[column][row]) - truth[column][row])));
      }
      worst = std::max(worst, off / size * det / ulp);
    }
    ASSERT_EQ(dvec3(back[3]), f.eye);
  }
  std::printf("%d frames (%d too flat): worst %.3g ulp of the largest entry / determinant\n", cases, flat,
              worst);
  EXPECT_EQ(cases, 2500);
  EXPECT_EQ(stretched, 2500);
  EXPECT_LT(worst, 32);
}

}  // namespace
}  // namespace gradus::viewing
