// What is told of a pixel is what the whole chain does there.

#include "why/why.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "core/record.hpp"
#include "pipeline.hpp"
#include "projection/viewing/viewing.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "transformation/affine_3d/affine_3d.hpp"
#include "why/why_text.hpp"

namespace gradus::pipeline::why_test {
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
    EXPECT_EQ(story.layers.size(), chain.shaded.size());
    EXPECT_EQ(story.written.colour, chain.written.at(0).colour);
    EXPECT_EQ(story.picture, (render_antialiased(scene, size)[pixel]));
    covered += !story.layers.empty();
    layers += story.fragments.size() > 1;
    if (story.layers.empty() || scene.shading == Shading::gouraud) continue;
    // What the lamps add is the pixel's diffuse part and highlight
    const auto& [lit, lamps, opacity, share] = story.layers.at(0);
    EXPECT_EQ(std::pair(opacity, share), std::pair(1.0, 1.0));
    EXPECT_EQ(lit.colour, chain.shaded.at(0).colour);
    dvec3 diffuse{0}, specular{0};
    for (const LampStory& lamp : lamps) diffuse += lamp.added.diffuse, specular += lamp.added.specular;
    EXPECT_EQ(diffuse, lit.diffuse);
    EXPECT_EQ(specular, lit.specular);
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
    scene.hidden_surfaces = static_cast<HiddenSurfaces>(i / 3 % 4);
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

/// A wall across the view, or a ball, with light of its own alone.
Object glowing(Random& random, bool wall, double depth) {
  Mesh mesh = wall ? test::wall(1, 0, random) : test::ball(6);
  Material material;
  material.ambient = material.diffuse = LinearRgb{0};
  for (int i = 0; i < 3; ++i) material.emission[i] = static_cast<float>(random.uniform(0, 1));
  material.opacity = random.uniform_int(0, 4) == 0 ? 1 : static_cast<float>(random.uniform(0, 1));
  mesh.materials = {material};
  Object object = object_of(std::move(mesh));
  const dvec3 place{wall ? 0 : random.uniform(-1, 1), 0, -depth};
  object.placement = affine_3d::translation(place) * affine_3d::scaling(dvec3{wall ? 2 * depth : 1});
  return object;
}

/// Walls of any opacity, and a ball among them or none, seen from the origin.
Scene glowing_scene(Random& random) {
  Scene scene;
  scene.camera.frame = viewing::look_at(dvec3{0}, dvec3{0, 0, -1}, dvec3{0, 1, 0});
  scene.camera.lens = {0.8, 0.5, 100};
  scene.background = LinearRgb(dvec3{0.2, 0.5, 0.1});
  scene.antialiasing = Antialiasing::a_buffer;
  const auto walls = random.uniform_int(1, 5), ball = random.uniform_int(0, 9);
  for (int i = 0; i < walls; ++i)
    scene.objects.push_back(glowing(random, true, 3.0 * (1 + i) + random.uniform(0, 0.5)));
  if (ball < walls)
    scene.objects.push_back(glowing(random, false, 3.0 * static_cast<double>(1 + ball) - 1.2));
  for (std::size_t i = scene.objects.size(); i-- > 1;)
    std::swap(scene.objects[i],
              scene.objects[static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(i)))]);
  return scene;
}

/// What is seen of a pixel's fragments, mixed from the farthest on.
dvec3 mixed_from_behind(const Scene& scene, std::vector<FragmentStory> fragments) {
  const auto depth = [](const FragmentStory& f) { return f.tested.fragment.depth; };
  std::ranges::sort(fragments, std::greater{}, depth);
  dvec3 light(scene.background);
  for (const FragmentStory& f : fragments) {
    const Material& m = object_at(scene, f.face.object).mesh->materials[0];
    light = double{m.opacity} * dvec3(m.emission) + (1 - double{m.opacity}) * light;
  }
  return light;
}

TEST(Why, TellsEverySurfaceThatLightGoesThrough) {
  int layers = 0, hidden = 0, backgrounds = 0, alike = 0;
  for (std::uint64_t i = 0; i < (test::sanitized ? 20 : 300); ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", case " << i);
    Random random(test::seed(), i);
    const Scene scene = glowing_scene(random);
    const ivec2 pixel{static_cast<int>(random.uniform_int(1, size.width - 2)),
                      static_cast<int>(random.uniform_int(1, size.height - 2))};
    PixelStories stories(scene, size, {pixel - 1, pixel + 1});
    const PixelStory story = stories.of(pixel);
    const dvec3 mixed = mixed_from_behind(scene, story.fragments);
    EXPECT_LT(glm::length(dvec3(story.written.light) - mixed), 1e-6) << "in single precision";
    double shares = story.background;
    for (const Layer& layer : story.layers) shares += layer.share;
    EXPECT_NEAR(shares, 1, 1e-12);
    for (const FragmentStory& fragment : story.fragments) hidden += fragment.share == 0;
    layers += story.layers.size() > 1, backgrounds += story.background > 0;
    // A pixel that all its surfaces fill has one colour
    bool filled = true;
    for (const ivec2 step : {ivec2{-1, -1}, {1, -1}, {-1, 1}, {1, 1}})
      filled &= stories.of(pixel + step).fragments.size() == story.fragments.size();
    if (!filled) continue;
    ++alike;
    for (const auto part : {&Rgba8::r, &Rgba8::g, &Rgba8::b})
      EXPECT_LE(std::abs(story.picture.*part - story.written.colour.*part), 1);
  }
  if (test::sanitized) return;
  EXPECT_GT(layers, 150);
  EXPECT_GT(hidden, 30);
  EXPECT_GT(backgrounds, 30);
  EXPECT_GT(alike, 150);
}

TEST(Why, SaysWhatIsSeenThroughWhat) {
  Random random(3);
  Scene scene = glowing_scene(random);
  scene.objects = {glowing(random, true, 3), glowing(random, true, 6), glowing(random, true, 9)};
  const std::array<float, 3> opacities{0.25f, 1, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    Mesh mesh = *scene.objects[i].mesh;
    mesh.materials[0].opacity = opacities[i];
    mesh.materials[0].emission = glm::vec<3, float>(i == 1);
    scene.objects[i].mesh = std::make_shared<const Mesh>(std::move(mesh));
    scene.objects[i].name = fmt::format("wall {}", i + 1);
    scene.objects[i].see_through = i == 0;
  }
  const std::string text = why_text("scene", scene, size, why(scene, size, {7, 6}));
  for (const char* said :
       {"3 triangles cover its centre; the 2 nearest are seen, for light goes through.",
        "seen, with a share of 0.25\n", "seen, with a share of 0.75\n",
        "hidden at the centre by what lets nothing through", "light of wall 1, face 1, triangle",
        "light of wall 2, face 1, triangle", "opacity 0.25\n",
        "seen through one another, from the eye on\n  0.25 of (0, 0, 0)\n  0.75 of (1, 1, 1)\n",
        "light (0.75, 0.75, 0.75)"})
    EXPECT_NE(text.find(said), std::string::npos) << said << " in\n" << text;
  EXPECT_EQ(text.find("light of wall 3"), std::string::npos);
  EXPECT_EQ(text.find("of the background"), std::string::npos);
  // Other methods draw what is nearest as if it let nothing through
  scene.antialiasing = Antialiasing::none;
  EXPECT_EQ(why(scene, size, {7, 6}).layers.size(), 1u);
}

TEST(Why, RefusesAPixelBesideThePicture) {
  Random random(1);
  const Scene scene = test::random_scene(random, 1);
  for (const ivec2 pixel : {ivec2{-1, 0}, ivec2{40, 0}, ivec2{0, 30}})
    EXPECT_THROW(why(scene, size, pixel), ContractViolation);
}

}  // namespace
}  // namespace gradus::pipeline::why_test
