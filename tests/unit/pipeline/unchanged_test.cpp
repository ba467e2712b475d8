// Frames that take the picture of the one before, and what is counted of them. That no bit differs is the
// property test's.

#include "plan/unchanged.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plan/rules.hpp"
#include "scene/camera/camera_path.hpp"
#include "scene/files.hpp"

namespace gradus::pipeline::unchanged_test {
namespace {

TEST(Unchanged, ABitIsAChange) {
  View view;
  view.eye = dvec3{1, 2, 3};
  EXPECT_TRUE(same_view(view, view));
  std::vector<View> others(10, view);
  others[0].eye = dvec3{1, 2, std::nextafter(3, 4)};
  others[1].eye.reset();
  others[2].target = dvec3{0};
  others[3].up = dvec3{0, 1, 0};
  others[4].vertical_radians = std::nextafter(view.vertical_radians, 0);
  others[5].projection = Projection3d::oblique;
  others[6].height = 2;
  others[7].receding_radians = 0;
  others[8].foreshortening = 1;
  others[9].eye = dvec3{1, 2, -3};
  for (const View& other : others) EXPECT_FALSE(same_view(view, other) || same_view(other, view));
  View zero = view, minus = view;
  zero.target = dvec3{0.0}, minus.target = dvec3{-0.0, 0, 0};
  EXPECT_FALSE(same_view(zero, minus)) << "a zero of another sign";
}

TEST(Unchanged, EachFrameTakesThePictureOfTheFirstThatIsLikeIt) {
  View a, b;
  a.eye = dvec3{1}, b.eye = dvec3{2};
  const std::vector<View> views{a, a, b, b, b, a, b};
  EXPECT_EQ(pictures_of(views), (std::vector<std::size_t>{0, 0, 2, 2, 2, 5, 6})) << "the frame before counts";
  EXPECT_TRUE(pictures_of({}).empty());
}

TEST(Unchanged, LedgersAddUp) {
  Ledger frame, sum;
  frame.input.total = 10, frame.input.done = 7;
  frame.input.skip("outside", 3);
  frame.output.total = frame.output.done = 100;
  frame.pixels = 0.5;
  add(frame, sum);
  add(frame, sum);
  add_unchanged(frame, sum);
  EXPECT_EQ(sum.input.total, 30);
  EXPECT_EQ(sum.input.done, 14);
  ASSERT_EQ(sum.input.skipped.size(), 2u);
  EXPECT_EQ(sum.input.skipped[0].count, 6);
  EXPECT_EQ(sum.input.skipped[1].why, name_of(Rule::unchanged));
  EXPECT_EQ(sum.input.skipped[1].count, 10);
  EXPECT_EQ(sum.output.done, 200);
  EXPECT_EQ(sum.pixels, 1.0);
  for (const LedgerRow* row : sum.rows()) EXPECT_EQ(row->done + row->skipped_in_all(), row->total);
}

TEST(Unchanged, TheShippedFlightRestsAtTheTower) {
  const SceneFile file = load_scene(GRADUS_SOURCE_DIR "/examples/scenes/town_flight.json");
  ASSERT_TRUE(file.path);
  std::vector<View> views;
  for (int frame = file.path->first; frame <= file.path->last; ++frame)
    views.push_back(view_at(*file.path, file.view, frame));
  ASSERT_EQ(views.size(), 125u);
  const std::vector<std::size_t> pictures = pictures_of(views);
  for (std::size_t i = 0; i < views.size(); ++i)
    EXPECT_EQ(pictures[i], 65 <= i && i <= 74 ? 64u : i) << "frame " << i;
}

}  // namespace
}  // namespace gradus::pipeline::unchanged_test
