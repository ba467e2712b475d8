// What is told of a pixel is what the whole chain does there.

#include "why/why.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/contract.hpp"
#include "core/record.hpp"
#include "pipeline.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "why/why_text.hpp"

namespace gradus::pipeline {
namespace {

constexpr Size size{40, 30};

/// Everything that the chain tells of one pixel's depths and colour.
struct ChainWatcher {
  ivec2 pixel;
  std::vector<DepthTested> tests{};
  std::vector<Shaded> shaded{};
  std::vector<Written> written{};

  void operator()(const DepthTested& step) {
    if (step.fragment.pixel == pixel) tests.push_back(step);
  }
  void operator()(const Shaded& step) {
    if (step.fragment.pixel == pixel) shaded.push_back(step);
  }
  void operator()(const Written& step) {
    if (step.pixel == pixel) written.push_back(step);
  }
  template <class Step>
  void operator()(const Step&) {}
};

/// Twice the signed area of three places of the grid.
std::int64_t area(ivec2 a, ivec2 b, ivec2 c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

bool near(dvec3 a, dvec3 b) { return glm::length(a - b) < 1e-9 * (1 + glm::length(b)); }

void expect_same_tests(const PixelStory& story, const ChainWatcher& chain) {
  ASSERT_EQ(story.fragments.size(), chain.tests.size());
  for (std::size_t i = 0; i < chain.tests.size(); ++i) {
    const DepthTested &told = story.fragments[i].tested, &done = chain.tests[i];
    EXPECT_EQ(told.fragment.id, done.fragment.id);
    EXPECT_EQ(told.fragment.depth, done.fragment.depth);
    EXPECT_EQ(told.fragment.weights, done.fragment.weights);
    EXPECT_EQ(told.nearer, done.nearer);
  }
}

/// What a story says of a triangle hangs together.
void expect_whole(const Scene& scene, const FragmentStory& story, ivec2 pixel) {
  const PieceId id = story.tested.fragment.id;
  EXPECT_EQ((PieceId{story.face.object, story.face.face, id.piece}), id);
  EXPECT_EQ(story.faced.id, id);
  EXPECT_EQ(story.clipped.id, id);
  EXPECT_EQ(story.snapped.id, id);
  const glm::dmat4& placement = object_at(scene, id.object).placement;
  for (const CornerStory& corner : story.corners) {
    EXPECT_TRUE(near(corner.placed.to.at, dvec3(placement * glm::dvec4(corner.placed.from.at, 1))));
    EXPECT_EQ(corner.projected.world.at, corner.placed.to.at);
  }
  // The centre is inside, on an edge at least
  const ivec2 centre = 256 * pixel + 128;
  const auto& [a, b, c] = story.snapped.corners;
  const bool clockwise = area(a.at, b.at, c.at) > 0;
  for (const auto& [from, to] : {std::pair{a.at, b.at}, {b.at, c.at}, {c.at, a.at}})
    EXPECT_TRUE(clockwise ? area(from, to, centre) >= 0 : area(from, to, centre) <= 0);
}

TEST(Why, TellsWhatTheChainDoes) {
  const std::uint64_t seed = test::seed();
  int covered = 0, layers = 0, cut = 0;
  for (std::uint64_t i = 0; i < (test::sanitized ? 20 : 900); ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i);
    Random random(seed, i);
    Scene scene = i % 2 ? test::random_scene(random, 8) : test::random_screened_scene(random, 8);
    scene.shading = static_cast<Shading>(random.uniform_int(0, 2));
    if (i % 4 == 3) scene.hidden_surfaces = HiddenSurfaces::painter;
    if (i % 5 == 4) scene.camera.rays = ParallelRays{6, {0.3, -0.2}, 3, -2, 12};
    scene.samples = 4;
    const ivec2 pixel{static_cast<int>(random.uniform_int(0, size.width - 1)),
                      static_cast<int>(random.uniform_int(0, size.height - 1))};
    const PixelStory story = why(scene, size, pixel);
    ChainWatcher chain{pixel};
    render(scene, size, chain);
    expect_same_tests(story, chain);
    for (const FragmentStory& fragment : story.fragments) {
      expect_whole(scene, fragment, pixel);
      cut += fragment.clipped.changed;
    }
    EXPECT_EQ(story.shaded.has_value(), !chain.shaded.empty());
    EXPECT_EQ(story.written.colour, chain.written.at(0).colour);
    EXPECT_EQ(story.picture, (render_antialiased(scene, size)[pixel]));
    covered += story.shaded.has_value();
    layers += story.fragments.size() > 1;
    if (!story.shaded || scene.shading == Shading::gouraud) continue;
    // What the lamps add is the pixel's diffuse part and highlight
    EXPECT_EQ(story.shaded->colour, chain.shaded.at(0).colour);
    dvec3 diffuse{0}, specular{0};
    for (const LampStory& lamp : story.lamps) diffuse += lamp.added.diffuse, specular += lamp.added.specular;
    EXPECT_EQ(diffuse, story.shaded->diffuse);
    EXPECT_EQ(specular, story.shaded->specular);
  }
  if (test::sanitized) return;
  EXPECT_GT(covered, 100);
  EXPECT_GT(layers, 50);
  EXPECT_GT(cut, 5);
}

/// The stories of a part of the picture at once are those of its pixels one by one.
TEST(Why, AllPixelsAtOnceAreToldAsOneByOne) {
  int told = 0;
  for (std::uint64_t i = 0; i < (test::sanitized ? 4 : 12); ++i) {
    Random random(test::seed(), i);
    Scene scene = test::random_screened_scene(random, 5);
    scene.shading = static_cast<Shading>(i % 4);
    scene.hidden_surfaces = static_cast<HiddenSurfaces>(i % 3);
    scene.samples = 4;
    const Window window{{3, 2}, {36, 28}};
    PixelStories stories(scene, size, window);
    TriangleTexts known;
    for (int k = 0; k < 4; ++k) {
      const int x = static_cast<int>(random.uniform_int(window.lower.x, window.upper.x));
      const ivec2 pixel{x, static_cast<int>(random.uniform_int(window.lower.y, window.upper.y))};
      std::string joined;
      for (const StoryPart& part : why_parts("scene", scene, size, stories.of(pixel), known))
        joined += part.text;
      EXPECT_EQ(joined, why_text("scene", scene, size, why(scene, size, pixel)))
          << "seed " << test::seed() << ", case " << i;
      told += joined.find("covers its centre") == joined.npos;
    }
    EXPECT_EQ(stories.picture().width(), 34);
    EXPECT_THROW(stories.of({2, 2}), ContractViolation);
  }
  EXPECT_GT(told, 0) << "several triangles over a centre";
  Random random(1);
  const Scene scene = test::random_scene(random, 1);
  for (const Window& window : {Window{{0, 0}, {40, 29}}, {{-1, 0}, {3, 3}}, {{4, 4}, {3, 3}}})
    EXPECT_THROW(PixelStories(scene, size, window), ContractViolation);
}

TEST(Why, RefusesAPixelBesideThePicture) {
  Random random(1);
  const Scene scene = test::random_scene(random, 1);
  for (const ivec2 pixel : {ivec2{-1, 0}, ivec2{40, 0}, ivec2{0, 30}})
    EXPECT_THROW(why(scene, size, pixel), ContractViolation);
}

}  // namespace
}  // namespace gradus::pipeline
