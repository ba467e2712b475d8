// Known frames, their laws, refusals.

#include "projection/viewing/viewing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"
#include "projection/viewing/viewing_notes.hpp"

namespace gradus::viewing {
namespace {

using DFrame = Frame<double>;

/// G004-01 to G004-03: along x, and what the report looks at.
const DFrame along_x{{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
const DFrame report = look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 1, 0});

TEST(Viewing, GoldenFrame) {
  // G000-07, G000-08, G000-09: eye (2,3,5), target 0
  EXPECT_NEAR(glm::distance(report.right, dvec3{5, 0, -2} / std::sqrt(29.0)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(report.up, dvec3{-6, 29, -15} / std::sqrt(1102.0)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(report.forward, dvec3{-2, -3, -5} / std::sqrt(38.0)), 0, 1e-15);
  EXPECT_NEAR(glm::dot(report.right, glm::cross(report.up, report.forward)), -1, 1e-15);
  EXPECT_NEAR(glm::distance(to_view(report, dvec3{0}), dvec3{0, 0, std::sqrt(38.0)}), 0, 1e-14);
}

TEST(Viewing, TheEyeIsTheOriginAndAheadIsDepth) {
  // G004-01, G004-02, G004-03
  EXPECT_EQ(to_view(along_x, dvec3{1, 2, 3}), (dvec3{0}));
  EXPECT_EQ(to_view(along_x, dvec3{6, 2, 3}), (dvec3{0, 0, 5}));
  const glm::dmat4 m = world_to_view(along_x);
  EXPECT_EQ(m, view_matrix(along_x));
  EXPECT_EQ(dvec3(m[3]), (dvec3{3, -2, -1}));
  EXPECT_EQ(dvec3(m * glm::dvec4{6, 2, 3, 1}), (dvec3{0, 0, 5}));
}

TEST(Viewing, DefaultFrameReadsASheetOfPaper) {
  const DFrame frame = look_at(dvec3{0, 0, 4}, dvec3{0}, dvec3{0, 1, 0});
  EXPECT_EQ(to_view(frame, dvec3{1, 2, 0}), (dvec3{1, 2, 4}));
  EXPECT_EQ(to_view(DFrame{}, dvec3{1, 2, -3}), (dvec3{1, 2, 3}));
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
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double bad : {infinity, -infinity, nan}) {
    EXPECT_EQ(reason({0, bad, 0}, {0, 0, 0}, {0, 1, 0}), "eye, target and up have finite coordinates");
    EXPECT_EQ(reason({0, 5, 0}, {bad, 0, 0}, {0, 1, 0}), "eye, target and up have finite coordinates");
    EXPECT_EQ(reason({0, 5, 0}, {0, 0, 0}, {1, 0, bad}), "eye, target and up have finite coordinates");
  }
}

TEST(Viewing, ATurnedCameraHasItsAxesAsRows) {
  // G000-05, G000-06: R = a quarter turn about z, c0 = (1,1,1). Read as rows of world to view it says
  // right = (0,-1,0): the camera is turned the other way. A list of points can't be read the wrong way round.
  const DFrame frame{{1, 1, 1}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const dvec3 columns[]{{1, 4, 7}, {2, 5, 8}, {3, 6, 9}};
  const dvec3 expected[]{{-3, 0, 6}, {-4, 1, 7}, {-5, 2, 8}};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(to_view(frame, columns[i]), expected[i]);
  const dvec3 rows[]{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const dvec3 instead[]{{-1, 0, 2}, {-4, 3, 5}, {-7, 6, 8}};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(to_view(frame, rows[i]), instead[i]);
}

TEST(ViewingNotes, ThreeByThreeHasTwoReadings) {
  // E000-06, G000-05, G000-06: three points in rows are taken for three in columns
  const DFrame frame{{1, 1, 1}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const auto seen = [&](const std::vector<dvec3>& points) {
    std::vector<dvec3> places;
    for (const dvec3 p : points) places.push_back(to_view(frame, p));
    return places;
  };
  const std::vector<std::vector<double>> square{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  EXPECT_EQ(seen(points_of_block(square)), (std::vector<dvec3>{{-3, 0, 6}, {-4, 1, 7}, {-5, 2, 8}}));
  // What was meant, point by point
  EXPECT_EQ(seen({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}),
            (std::vector<dvec3>{{-1, 0, 2}, {-4, 3, 5}, {-7, 6, 8}}));
  // Any other number of points can be told apart
  EXPECT_EQ(points_of_block<double>({{1, 4}, {2, 5}, {3, 6}}), (std::vector<dvec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(points_of_block<double>({{1, 2, 3}, {4, 5, 6}}), (std::vector<dvec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_THROW(points_of_block<double>({{1, 2}, {3, 4}}), ContractViolation);
  EXPECT_THROW(points_of_block<double>({}), ContractViolation);
}

TEST(Viewing, TheLastColumnIsNotThePosition) {
  // E000-04, G004-01: what is called a translation is the eye; the column is minus its products
  const glm::dmat4 right = world_to_view(along_x);
  const glm::dmat4 golden =
      glm::transpose(glm::dmat4{{0, 0, -1, 3}, {0, 1, 0, -2}, {1, 0, 0, -1}, {0, 0, 0, 1}});
  EXPECT_EQ(right, golden);
}

TEST(Viewing, TheHandOfTheRowsIsSaid) {
  // E000-02, G000-09: with right = forward x up the rows are no rotation but mirror; -forward would make one
  EXPECT_NEAR(glm::determinant(world_to_view(report)), -1, 1e-15);
  EXPECT_NEAR(glm::determinant(glm::dmat3(report.right, report.up, -report.forward)), 1, 1e-15);
  // Notes that draw a left hand: right x up is forward, the determinant +1
  EXPECT_EQ(glm::determinant(world_to_view(along_x)), 1);
  EXPECT_EQ(glm::cross(along_x.right, along_x.up), along_x.forward);
  EXPECT_NEAR(glm::distance(glm::cross(report.right, report.up), -report.forward), 0, 1e-15);
}

TEST(Viewing, TheInverseIsThePoseOfTheCamera) {
  const glm::dmat4 back = view_to_world(along_x);
  EXPECT_EQ(back * world_to_view(along_x), glm::dmat4(1));
  EXPECT_EQ(world_to_view(along_x) * back, glm::dmat4(1));
  EXPECT_EQ(dvec3(back[3]), along_x.eye);
  EXPECT_EQ(back, inverse_of_any_frame(along_x));
  EXPECT_EQ(glm::determinant(back), 1);
}

TEST(Viewing, TheTransposedMatrixInvertsOnlyUprightFrames) {
  // Part 4: axes that are not of length 1 or not at right angles
  DFrame stretched;
  stretched.right = {2, 0, 0};
  EXPECT_THROW(view_to_world(stretched), ContractViolation);
  DFrame sheared;
  sheared.up = {0.5, 1, 0};
  EXPECT_THROW(view_to_world(sheared), ContractViolation);
  DFrame tiny{{1, 2, 3}, {1e-200, 0, 0}, {1e-200, 1e-200, 0}, {0, 0, 1e200}};
  EXPECT_THROW(view_to_world(tiny), ContractViolation);
  const glm::dmat4 back = inverse_of_any_frame(tiny);
  EXPECT_EQ(dvec3(back[0]), (dvec3{1 / 1e-200, -1 / 1e-200, 0}));
  EXPECT_EQ(dvec3(back[1]), (dvec3{0, 1 / 1e-200, 0}));
  EXPECT_EQ(dvec3(back[2]), (dvec3{0, 0, 1 / 1e200}));
  EXPECT_EQ(dvec3(back[3]), tiny.eye);
  const DFrame flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_THROW(inverse_of_any_frame(flat), ContractViolation);
  const DFrame nothing{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_THROW(inverse_of_any_frame(nothing), ContractViolation);
}

TEST(Viewing, TheWorstInverseKnownIs37UlpOff) {
  // The number of the topic's page, by rationals; in float, for whose ulp the bound is the same
  const ExactScope scope;
  const Frame<float> frame{{0, 0, 0},
                           {0x1.a049c4p+0f, -0x1.bf3838p+0f, 0x1.9b23d6p+0f},
                           {0x1.483ef4p+0f, 0x1.11eb62p+0f, -0x1.84c224p+0f},
                           {0x1.896446p+0f, 0x1.ff5e58p+0f, 0x1.d01eaap+0f}};
  const glm::mat4 found = inverse_of_any_frame(frame);
  const glm::vec<3, Exact> axes[]{glm::vec<3, Exact>(frame.right), glm::vec<3, Exact>(frame.up),
                                  glm::vec<3, Exact>(frame.forward)};
  const Exact det = glm::dot(axes[0], glm::cross(axes[1], axes[2]));
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const auto column = glm::cross(axes[(i + 1) % 3], axes[(i + 2) % 3]) / det;
    double largest = 0, error = 0;
    for (int row = 0; row < 3; ++row) {
      largest = std::max(largest, std::abs(to_double(column[row])));
      error = std::max(error, std::abs(to_double(column[row] - Exact(found[i][row]))));
    }
    // In ulp of 1 times the largest entry / determinant
    worst = std::max(worst, error / largest * std::abs(to_double(det)) / 0x1p-23);
  }
  EXPECT_NEAR(worst, 36.7, 0.05);
}

TEST(Viewing, HugeAndTinyViewsHaveTheSameAxes) {
  for (const double size : {0x1p-1060, 0x1p-600, 0x1p600, 0x1p1020}) {
    const DFrame f = look_at(size * dvec3{2, 3, 5}, dvec3{0}, dvec3{0, size, 0});
    EXPECT_EQ(f.right, report.right);
    EXPECT_EQ(f.up, report.up);
    EXPECT_EQ(f.forward, report.forward);
  }
  // target - eye overflows
  const DFrame across = look_at(dvec3{-1e308, 0, 0}, dvec3{1e308, 0, 0}, dvec3{0, 1, 0});
  EXPECT_EQ(across.forward, (dvec3{1, 0, 0}));
  EXPECT_EQ(across.right, (dvec3{0, 0, 1}));
}

TEST(Viewing, FarFromTheOriginTheMatrixLosesWhatThePointKeeps) {
  // The same view 2^40 away: to_view subtracts the eye first and loses nothing, the matrix afterwards
  const dvec3 far{0x1p40, -0x1p41, 0x1p40}, p{0.25, 1.5, -0.125};
  DFrame away = report;
  away.eye = far + report.eye;
  EXPECT_EQ(to_view(away, far + p), to_view(report, p));
  const dvec3 lost = dvec3(world_to_view(away) * glm::dvec4(far + p, 1)) - to_view(report, p);
  EXPECT_GT(glm::length(lost), 1e-6);
  EXPECT_LT(glm::length(lost), 0x1p41 * 4 * 0x1p-52);
}

TEST(Viewing, StepsFollowTheGrammar) {
  Recorder<Aimed<double>, Levelled<double>, Framed<double>> seen;
  const DFrame frame = look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 2, 0}, seen);
  ASSERT_EQ(seen.events().size(), 3u);
  EXPECT_EQ(std::get<Aimed<double>>(seen.events()[0].step).forward, frame.forward);
  EXPECT_EQ(std::get<Levelled<double>>(seen.events()[1].step).right, frame.right);
  EXPECT_EQ(std::get<Framed<double>>(seen.events()[2].step).frame.up, frame.up);
  EXPECT_EQ(look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 2, 0}).up, frame.up);  // observed == unobserved

  Recorder<RowWritten<double>> rows;
  EXPECT_EQ(world_to_view(frame, rows), world_to_view(frame));
  ASSERT_EQ(rows.seen(), 3u);
  for (int i = 0; i < 3; ++i) {
    const RowWritten<double> row = all<RowWritten<double>>(rows)[static_cast<std::size_t>(i)];
    EXPECT_EQ(row.row, i);
    EXPECT_EQ(row.axis, axis_of(frame, i));
    EXPECT_EQ(row.shift, -glm::dot(row.axis, frame.eye));
  }
  Recorder<ColumnWritten<double>> columns;
  EXPECT_EQ(view_to_world(frame, columns), view_to_world(frame));
  EXPECT_EQ(inverse_of_any_frame(frame, columns), inverse_of_any_frame(frame));
  ASSERT_EQ(columns.seen(), 8u);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(all<ColumnWritten<double>>(columns)[static_cast<std::size_t>(i)].column, i % 4);
  }
  Recorder<Viewed<double>> viewed;
  EXPECT_EQ(to_view(frame, dvec3{1, 1, 1}, viewed), to_view(frame, dvec3{1, 1, 1}));
  EXPECT_EQ(viewed.seen(), 1u);
}

TEST(Viewing, ASpareUpForWhoLooksUpAndDown) {
  // As on a map: -z is up, x is right
  for (const dvec3 up : {dvec3{0, 1, 0}, {1e-17, 1, 0}, {0, -3, 0}, {0, 0, 0}}) {
    const DFrame down = spare_up(dvec3{0, 5, 0}, dvec3{0}, up);
    EXPECT_EQ(down.right, (dvec3{1, 0, 0}));
    EXPECT_EQ(down.up, (dvec3{0, 0, -1}));
    EXPECT_EQ(down.forward, (dvec3{0, -1, 0}));
    EXPECT_EQ(down.eye, (dvec3{0, 5, 0}));
  }
  EXPECT_EQ(spare_up(dvec3{0}, dvec3{0, 0, -2}, dvec3{0, 0, 1}).up, (dvec3{0, 1, 0}));
  EXPECT_THROW(spare_up(dvec3{1, 2, 3}, dvec3{1, 2, 3}, dvec3{0, 1, 0}), ContractViolation);
  EXPECT_THROW(spare_up(dvec3{0, 5, 0}, dvec3{0}, dvec3{std::nan(""), 1, 0}), ContractViolation);
  Recorder<HintReplaced<double>, Aimed<double>, Levelled<double>, Framed<double>> seen;
  spare_up(dvec3{0, 5, 0}, dvec3{0}, dvec3{0, 1, 0}, seen);
  spare_up(dvec3{0, 5, 0}, dvec3{0}, dvec3{1, 0, 0}, seen);
  ASSERT_EQ(seen.events().size(), 4u + 3u);
  EXPECT_EQ(std::get<HintReplaced<double>>(seen.events()[0].step).spare, (dvec3{0, 0, -1}));
  EXPECT_EQ(spare_up(glm::vec3{0, 5, 0}, glm::vec3{0}, glm::vec3{0, 1, 0}).right, (glm::vec3{1, 0, 0}));
}

// --- Exhibits ----------------------------------------------------

TEST(ViewingNotes, CrossProductsDivideWhatRoundingLeaves) {
  // E000-03: from above, right is decided by 1e-17, and turns round with its sign
  const auto right = [](dvec3 target, dvec3 up) { return cross_products(dvec3{0, 5, 0}, target, up).right; };
  EXPECT_EQ(right({0, 0, 0}, {1e-17, 1, 0}), (dvec3{0, 0, 1}));
  EXPECT_EQ(right({0, 0, 0}, {-1e-17, 1, 0}), (dvec3{0, 0, -1}));
  // So it does with a tilt of the view by 1e-9
  EXPECT_EQ(right({5e-9, 0, 0}, {0, 1, 0}), (dvec3{0, 0, 1}));
  EXPECT_EQ(right({-5e-9, 0, 0}, {0, 1, 0}), (dvec3{0, 0, -1}));
  // No direction at all
  EXPECT_TRUE(std::isnan(right({0, 0, 0}, {0, 1, 0}).x));
  EXPECT_TRUE(std::isnan(right({0, 5, 0}, {0, 1, 0}).x));
  // An up whose square is 0 says nothing here, and all to look_at
  EXPECT_FALSE(std::isfinite(right({1, 0, 0}, {0, 0, 1e-200}).x));
  EXPECT_EQ(look_at(dvec3{0, 5, 0}, dvec3{1, 0, 0}, dvec3{0, 0, 1e-200}).right.z, 0);
  // Far from there it is right
  const DFrame wrong = cross_products(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 1, 0});
  EXPECT_NEAR(glm::distance(wrong.right, report.right), 0, 1e-15);
  EXPECT_NEAR(glm::distance(wrong.up, report.up), 0, 1e-15);
  Recorder<Aimed<double>, Levelled<double>, Framed<double>> seen;
  cross_products(dvec3{0, 5, 0}, dvec3{0}, dvec3{1e-17, 1, 0}, seen);
  ASSERT_EQ(seen.events().size(), 3u);
  EXPECT_EQ(std::get<Levelled<double>>(seen.events()[1].step).sine, 1e-17);
}

TEST(ViewingNotes, MinusPositionSeesTheEyeElsewhere) {
  // E004-01: G004-01, G004-02, G004-03
  const glm::dmat4 printed =
      glm::transpose(glm::dmat4{{0, 0, -1, -1}, {0, 1, 0, -2}, {1, 0, 0, -3}, {0, 0, 0, 1}});
  EXPECT_EQ(minus_position(along_x), printed);
  EXPECT_EQ(minus_position(along_x) * glm::dvec4(1, 2, 3, 1), (glm::dvec4{-4, 0, -2, 1}));
  EXPECT_EQ(minus_position(along_x) * glm::dvec4(6, 2, 3, 1), (glm::dvec4{-4, 0, 3, 1}));
  // Right where nothing is turned, or the eye is the origin
  DFrame unturned{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(minus_position(unturned), world_to_view(unturned));
  const DFrame home = look_at(dvec3{0}, dvec3{1, 2, 3}, dvec3{0, 1, 0});
  EXPECT_EQ(minus_position(home), world_to_view(home));
  Recorder<RowWritten<double>> rows;
  EXPECT_EQ(minus_position(along_x, rows), printed);
  EXPECT_EQ(rows.seen(), 3u);
}

TEST(ViewingNotes, TransposedPutsTheTargetOffTheAxis) {
  // E000-01: the triple that the report prints
  const dvec3 seen = dvec3(transposed(report) * glm::dvec4(0, 0, 0, 1));
  EXPECT_NEAR(seen.x, -2.937, 5e-4);
  EXPECT_NEAR(seen.y, -5.054, 5e-4);
  EXPECT_NEAR(seen.z, -1.957, 5e-4);
  EXPECT_NEAR(seen.x, -2.93694, 5e-6);
  EXPECT_NEAR(glm::length(seen), std::sqrt(38.0), 1e-14);  // why nobody noticed
  EXPECT_NEAR(glm::length(dvec3(transposed(report) * glm::dvec4(2, 3, 5, 1))), 0, 1e-14);
  Recorder<RowWritten<double>> rows;
  EXPECT_EQ(transposed(report, rows), transposed(report));
  EXPECT_EQ(rows.seen(), 3u);
  const ExactScope scope;
  const Frame<Exact> exact{{Exact(1), Exact(2), Exact(3)},
                           {Exact(0), Exact(0), Exact(-1)},
                           {Exact(0), Exact(1), Exact(0)},
                           {Exact(1), Exact(0), Exact(0)}};
  EXPECT_EQ(minus_position(exact)[3][0], Exact(-1));
  EXPECT_EQ(transposed(exact)[3][0], Exact(3));
  const Frame<float> single{{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_EQ(minus_position(single)[3][0], -1);
  EXPECT_EQ(transposed(single)[3][0], 3);
}

}  // namespace
}  // namespace gradus::viewing
