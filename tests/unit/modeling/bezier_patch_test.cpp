// Known results, the step grammar, degenerate patches, seams against closed forms, refusals, and what the
// page counts and measures. What holds for every input is a promise: tests/stress.

#include "modeling/bezier_patch/bezier_patch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/bezier_patch/bezier_patch_notes.hpp"
#include "support/documented.hpp"

namespace gradus::bezier_patch {
namespace {

using Net = Patch<double>;
using Long = long double;

constexpr const char* page = "docs/topics/modeling/bezier_patch.md";

/// 3 x 3, the example by hand.
const Net roof{
    3, {{0, 0, 4}, {2, 4, 4}, {4, 0, 4}, {0, 2, 2}, {2, 6, 2}, {4, 2, 2}, {0, 0, 0}, {2, 4, 0}, {4, 0, 0}}};

Net random_net(Random& random, double behind = 0) {
  Net net{4, {}};
  for (int i = 0; i < 16; ++i)
    net.points.push_back({i % 4 + random.uniform(-0.2, 0.2), random.uniform(-1, 1), -i / 4 - behind});
  return net;
}

/// Bernstein's polynomials of degree 3 and their derivatives.
std::array<Long, 4> weights(Long t, int derivative) {
  const Long s = 1 - t;
  if (derivative == 0) return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  if (derivative == 1) return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
  return {6 * s, 6 * t - 12 * s, 6 * s - 12 * t, 6 * t};
}
using Vec = glm::vec<3, Long>;
Vec sum_of(const Net& net, Long u, Long v, int along_u, int along_v) {
  const auto a = weights(u, along_u), b = weights(v, along_v);
  Vec sum{0};
  for (Index j = 0; j < 4; ++j) {
    for (Index i = 0; i < 4; ++i) sum += a[i] * b[j] * Vec(net(j, i));
  }
  return sum;
}
/// The curvature of the section across a border by the surface's two fundamental forms.
Long curvature_across(const Net& net, Long u, Long v) {
  const Vec a = sum_of(net, u, v, 1, 0), b = sum_of(net, u, v, 0, 1), n = glm::normalize(glm::cross(a, b));
  const Long E = glm::dot(a, a), F = glm::dot(a, b), G = glm::dot(b, b),
             L = glm::dot(sum_of(net, u, v, 2, 0), n), M = glm::dot(sum_of(net, u, v, 1, 1), n),
             N = glm::dot(sum_of(net, u, v, 0, 2), n);
  return (L * F * F - 2 * M * E * F + N * E * E) / (E * (E * G - F * F));
}

TEST(BezierPatch, APointByHand) {
  const Frame<double> f = de_casteljau(roof, 0.5, 0.5);
  EXPECT_EQ(f.point, (dvec3{2, 3, 2}));
  EXPECT_EQ(f.along_u, (dvec3{4, 0, 0}));
  EXPECT_EQ(f.along_v, (dvec3{0, 0, -4}));
  EXPECT_EQ(f.normal, (dvec3{0, 16, 0}));
  EXPECT_EQ(de_casteljau(roof, 0.0, 1.0).point, roof(2, 0));
}

TEST(BezierPatch, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<RowReduced<double>, Reached<double>, TangentsFound<double>, NormalFound<double>, RowSet<double>,
           SeamMeasured<double>>
      seen;
  std::vector<std::size_t> types;
  EXPECT_EQ(de_casteljau(roof, 0.4, 0.6, seen).normal, de_casteljau(roof, 0.4, 0.6).normal);
  EXPECT_EQ(join(roof, roof, Continuity::C2, 0.5, seen).points, join(roof, roof, Continuity::C2, 0.5).points);
  EXPECT_EQ(measure(roof, roof, 4, seen).gap, measure(roof, roof, 4).gap);
  for (const auto& event : seen.events()) types.push_back(event.step.index());
  EXPECT_EQ(types, (std::vector<std::size_t>{0, 0, 0, 1, 2, 3, 4, 4, 4, 5}));
  for (const RowReduced<double>& r : all<RowReduced<double>>(seen)) EXPECT_EQ(r.control, roof.row(r.row));
}

TEST(BezierPatch, AMeshHasThePointsOfTheSurfaceAndFacesTheNormals) {
  const auto [points, faces] = on_grid(roof, 6, 5);
  EXPECT_EQ(points.size(), 42u);
  EXPECT_EQ(faces.size(), 30u);
  expect_faces(faces, points.size());
  EXPECT_EQ(points[3 * 7 + 2], de_casteljau(roof, 2.0 / 6, 3.0 / 5).point);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(faces[f][i])]; };
    const dvec2 cell(f % 6, f / 6), middle = (cell + 0.5) / dvec2(6, 5);
    const dvec3 normal = de_casteljau(roof, middle.x, middle.y).normal;
    EXPECT_GT(glm::dot(glm::cross(at(2) - at(0), at(3) - at(1)), normal), 0);
  }
}

TEST(BezierPatch, ATipHasTheNormalThatItsNeighboursTendTo) {
  // Each border in turn is one point; the other rows don't spoil it
  Net tip = roof;
  for (Index i = 0; i < 3; ++i) tip(0, i) = {2, 1, 5};
  Net turned{3, Points<double>(9)}, back = turned;
  for (Index k = 0; k < 9; ++k) turned(k % 3, k / 3) = tip(k / 3, k % 3);
  for (Index k = 0; k < 9; ++k) back(2 - k / 3, k % 3) = tip(k / 3, k % 3);
  const auto expect_limit = [](const Net& net, dvec2 at, dvec2 beside) {
    const dvec3 limit = glm::normalize(de_casteljau(net, at.x, at.y).normal);
    EXPECT_LT(glm::distance(limit, glm::normalize(de_casteljau(net, beside.x, beside.y).normal)), 1e-5);
  };
  expect_limit(tip, {0.3, 0}, {0.3, 1e-7});
  expect_limit(turned, {0, 0.3}, {1e-7, 0.3});
  expect_limit(back, {0.3, 1}, {0.3, 1 - 1e-7});
  // All in one place, all on a line: none
  EXPECT_EQ(de_casteljau(Net{2, Points<double>(4, dvec3{1})}, 0.3, 0.7).normal, dvec3{0});
  EXPECT_EQ(de_casteljau(Net{2, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}, 0.5, 0.5).normal, dvec3{0});
  // Flat ones have that of their plane
  const Net flat{2, {{0, 0, 3}, {1, 0, 3}, {0, 2, 3}, {1, 2, 3}}};
  EXPECT_EQ(de_casteljau(flat, 0.25, 0.75).normal, (dvec3{0, 0, 2}));
}

TEST(BezierPatch, SeamsAreMeasuredAsClosedFormsHaveThem) {
  Random random(11);
  double worst = 0;
  for (int i = 0; i < 50; ++i) {
    const Net P = random_net(random), Q = random_net(random, 3);
    const Seam<double> seam = measure(P, Q, 8);
    std::array<Long, 4> right{};
    for (int k = 0; k <= 8; ++k) {
      const Long u = k / Long(8);
      const auto normal = [&](const Net& net, Long v) {
        return glm::normalize(glm::cross(sum_of(net, u, v, 1, 0), sum_of(net, u, v, 0, 1)));
      };
      const std::array<Long, 4> here{glm::distance(sum_of(P, u, 1, 0, 0), sum_of(Q, u, 0, 0, 0)),
                                     std::acos(glm::dot(normal(P, 1), normal(Q, 0))),
                                     glm::distance(sum_of(P, u, 1, 0, 1), sum_of(Q, u, 0, 0, 1)),
                                     std::abs(curvature_across(P, u, 1) - curvature_across(Q, u, 0))};
      for (std::size_t q = 0; q < 4; ++q) right[q] = std::max(right[q], here[q]);
    }
    const std::array found{seam.gap, seam.angle, seam.slope, seam.curvature};
    for (std::size_t q = 0; q < 4; ++q)
      worst = std::max(worst, static_cast<double>(std::abs(found[q] - right[q]) / right[q]));
  }
  EXPECT_LT(worst, 1e-12);
}

TEST(BezierPatch, EachOrderAsksForOneThingMore) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Net P = random_net(random), Q = random_net(random, 3);
    const auto seam = [&](Continuity order) { return measure(P, join(P, Q, order, 0.75), 16); };
    const auto [c0, g1, c1, c2] =
        std::array{seam(Continuity::C0), seam(Continuity::G1), seam(Continuity::C1), seam(Continuity::C2)};
    EXPECT_EQ(c0.gap, 0);
    EXPECT_GT(c0.angle, 1e-3);
    EXPECT_LT(g1.angle, 1e-13);
    EXPECT_GT(g1.slope, 1e-3);
    EXPECT_LT(c1.slope, 1e-13);
    EXPECT_GT(c1.curvature, 1e-3);
    EXPECT_LT(c2.curvature, 1e-11);
  }
}

TEST(BezierPatch, MistakesAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Points<double> four(4, dvec3{1});
  for (const Net& net :
       {Net{1, four}, Net{3, four}, Net{4, four}, Net{10, Points<double>(20)}, Net{2, Points<double>(20)},
        Net{2, {{0, 0, nan}, {}, {}, {}}}, Net{2, {{1e306, 0, 0}, {}, {}, {}}}}) {
    EXPECT_THROW(de_casteljau(net, 0.5, 0.5), ContractViolation);
    EXPECT_THROW(on_grid(net, 2, 2), ContractViolation);
    EXPECT_THROW(join(net, net, Continuity::C0, 1.0), ContractViolation);
  }
  for (const double t : {-0.1, 1.1, nan}) {
    EXPECT_THROW(de_casteljau(roof, t, 0.5), ContractViolation);
    EXPECT_THROW(de_casteljau(roof, 0.5, t), ContractViolation);
  }
  for (const double k : {0.0, -1.0, 17.0, nan})
    EXPECT_THROW(join(roof, roof, Continuity::G1, k), ContractViolation);
  EXPECT_THROW(join(Net{2, four}, Net{2, four}, Continuity::C2, 1.0), ContractViolation);
  EXPECT_THROW(join(roof, Net{2, four}, Continuity::C0, 1.0), ContractViolation);
  EXPECT_THROW(on_grid(roof, 0, 2), ContractViolation);
  EXPECT_THROW(measure(roof, roof, 0), ContractViolation);
  EXPECT_THROW(measure(Net{2, four}, Net{2, four}, 4), ContractViolation);
  EXPECT_THROW(transposed(Net{2, Points<double>(6)}, 0.5, 0.5), ContractViolation);
}

// --- What the page counts and measures

TEST(BezierPatch, ExhibitsAreAsWrongAsThePageSays) {
  const double off = glm::distance(de_casteljau(roof, 0.25, 0.75).point, transposed(roof, 0.25, 0.75).point);
  EXPECT_TRUE(test::states(page, "at (0.25, 0.75) the point of the example is missed by {}", {off}));
  EXPECT_EQ(transposed(roof, 0.5, 0.5).normal, -de_casteljau(roof, 0.5, 0.5).normal);
  const Net back = turned_back(roof, roof, Continuity::C1, 1.0);
  EXPECT_EQ(back.row(1), roof.row(1));
  EXPECT_NEAR(measure(roof, back, 16).angle, std::acos(-1.0), 1e-7);
}

TEST(BezierPatch, RoundingsAndMeshesAreAsThePageMeasuredThem) {
  Random random(7);
  double point = 0, tangent = 0;
  for (int i = 0; i < 4000; ++i) {
    const Net net = random_net(random);
    const double u = random.unit(), v = random.unit(), unit = largest_of(net.points) * 0x1p-53;
    const Frame<double> f = de_casteljau(net, u, v);
    const auto off = [&](dvec3 found, int du, int dv) {
      const Vec d = glm::abs(Vec(found) - sum_of(net, u, v, du, dv));
      return static_cast<double>(std::max({d.x, d.y, d.z}) / unit);
    };
    point = std::max(point, off(f.point, 0, 0));
    tangent = std::max({tangent, off(f.along_u, 1, 0), off(f.along_v, 0, 1)});
  }
  EXPECT_TRUE(test::states(
      page, "4000 random bicubic patches the points are off by {} u M at most, the tangents by {}",
      {point, tangent}));
  EXPECT_LE(point, 8);  // 4 ulp of the largest coordinate
  const auto off_mesh = [](int n) {
    const auto points = on_grid(roof, n, n).points;
    const dvec3 middle = 0.5 * points[0] + 0.5 * points[static_cast<std::size_t>(n + 2)];
    return glm::distance(middle, de_casteljau(roof, 0.5 / n, 0.5 / n).point);
  };
  EXPECT_TRUE(test::states(page, "the first face of the example is off by {} in its middle, of 16 × 16 by {}",
                           {off_mesh(8), off_mesh(16)}));
}

}  // namespace
}  // namespace gradus::bezier_patch
