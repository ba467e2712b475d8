// What a plan leaves out changes no bit of the light of any pixel, whatever the scene, the camera and the
// antialiasing; and each rule is used often enough to say so.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "pipeline.hpp"
#include "plan/planned.hpp"
#include "plan/unchanged.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::plan_property_test {
namespace {

bool same_light(const PixelLight& a, const PixelLight& b) { return a.sum == b.sum && a.share == b.share; }

/// How many pixels of the window differ between the picture and the planned part of it.
int differing(const LightPicture& whole, const LightPicture& part, const Window& window) {
  int count = 0;
  for (int y = window.lower.y; y <= window.upper.y; ++y)
    for (int x = window.lower.x; x <= window.upper.x; ++x)
      count += !same_light(whole[{x, y}], part[ivec2{x, y} - window.lower]);
  return count;
}

Window random_window(Random& random, Size size) {
  if (random.unit() < 0.5) return picture_window(size);
  const auto x = static_cast<int>(random.uniform_int(0, size.width - 1)),
             y = static_cast<int>(random.uniform_int(0, size.height - 1));
  return {{x, y},
          {static_cast<int>(random.uniform_int(x, size.width - 1)),
           static_cast<int>(random.uniform_int(y, size.height - 1))}};
}

/// How often each rule has left something out.
using Fired = std::map<Rule, std::int64_t>;

void count(const Plan& plan, const Scene& scene, const Ledger& ledger, Fired& fired) {
  for (const ObjectPlan& object : plan.objects) {
    if (object.skipped) ++fired[*object.skipped];
    fired[Rule::inside] += object.whole && !object.skipped;
    fired[Rule::out_of_range] += std::ssize(scene.lights) - std::ssize(object.lights);
  }
  fired[Rule::no_highlight] += ledger.highlights.skipped_in_all();
}

/// How it is seen and drawn: mostly by a z-buffer, in perspective, with surfaces.
void choose(Scene& scene, Random& random) {
  scene.shading = static_cast<Shading>(random.uniform_int(0, random.unit() < 0.2 ? 3 : 2));
  if (random.unit() < 0.2) scene.hidden_surfaces = static_cast<HiddenSurfaces>(random.uniform_int(0, 3));
  if (random.unit() < 0.2) scene.culling = static_cast<Culling>(random.uniform_int(0, 2));
  if (random.unit() >= 0.3) return;
  const auto slant = [&] { return random.unit() < 0.5 ? random.uniform(-1, 1) : 0.0; };
  const double a = slant(), b = slant();
  scene.camera.rays = ParallelRays{
      random.uniform(2, 9), {a, b}, random.uniform(1, 9), random.uniform(-3, 1), random.uniform(6, 15)};
}

/// Of every stage, done and skipped add up to the total.
void expect_balanced(const Ledger& ledger) {
  for (const LedgerRow* row : ledger.rows())
    EXPECT_EQ(row->done + row->skipped_in_all(), row->total) << row->stage << ' ' << row->name;
}

TEST(Plan, ChangesNoBitOfAnyPixel) {
  const std::uint64_t seed = test::seed();
  constexpr int cases = test::sanitized ? 30 : 1000;
  constexpr Size size{64, 48};
  constexpr std::array methods{Antialiasing::none,
                               Antialiasing::adaptive,
                               Antialiasing::jittered,
                               Antialiasing::supersampling,
                               Antialiasing::area_sampling,
                               Antialiasing::a_buffer,
                               Antialiasing::adaptive_contrast};
  Fired fired;
  int ran = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Scene scene = i % 2 == 0 ? test::random_scene(random, 12) : test::random_screened_scene(random, 12);
    scene.antialiasing = methods[static_cast<std::size_t>(i) / 2 % methods.size()];
    scene.samples = 4;
    choose(scene, random);
    const Window window = random_window(random, size);
    Plan plan = plan_of(scene, size, Rules::all(), window);
    Ledger ledger;
    const LightPicture part = antialiased_by_plan(scene, plan, ledger);
    ASSERT_EQ(differing(antialiased(scene, size), part, window), 0)
        << "seed " << seed << ", case " << i << ", " << name_of(scene.antialiasing);
    expect_balanced(ledger);
    count(plan, scene, ledger, fired);
    ++ran;
  }
  EXPECT_EQ(ran, cases);
  for (const Rule rule : all_rules) {
    if (rule == Rule::unchanged) continue;  // it takes more than one picture: the next test
    RecordProperty(std::string(name_of(rule)), static_cast<int>(fired[rule]));
    EXPECT_GE(fired[rule], test::sanitized ? 1 : 1000) << name_of(rule);
  }
}

/// Views of a film that stands still now and then.
std::vector<View> random_views(Random& random, int count) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    if (i > 0 && random.unit() < 0.9) {
      views.push_back(views.back());
      continue;
    }
    View view;
    view.eye = test::random_point(random, 8);
    view.target = test::random_point(random, 3);
    view.vertical_radians = random.uniform(0.3, 2);
    if (random.unit() < 0.3) view.projection = static_cast<Projection3d>(random.uniform_int(1, 2));
    views.push_back(view);
  }
  return views;
}

TEST(Plan, AFrameThatIsUnchangedHasEachBitOfThePictureThatItTakes) {
  const std::uint64_t seed = test::seed();
  constexpr int films = test::sanitized ? 3 : 40, frames = 30;
  constexpr Size size{6, 4};
  int taken = 0;
  for (int i = 0; i < films; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Scene scene = test::random_scene(random, 2);
    scene.antialiasing = i % 4 == 0   ? Antialiasing::adaptive
                         : i % 4 == 1 ? Antialiasing::jittered
                                      : Antialiasing::none;
    scene.samples = 4;
    choose(scene, random);
    const std::vector<View> views = random_views(random, frames);
    const std::vector<std::size_t> pictures = pictures_of(views);
    std::vector<LightPicture> drawn;
    for (std::size_t k = 0; k < views.size(); ++k) {
      const Aim aim = aim_of(scene.objects, views[k], 1.5);
      ASSERT_TRUE(leads_somewhere(aim) && tells_upright(aim));
      scene.camera = camera_of(aim, views[k], scene.objects, 1.5);
      drawn.push_back(antialiased(scene, size));
      ASSERT_EQ(differing(drawn.back(), drawn[pictures[k]], picture_window(size)), 0)
          << "seed " << seed << ", film " << i << ", frame " << k;
      taken += pictures[k] != k;
    }
  }
  RecordProperty(std::string(name_of(Rule::unchanged)), taken);
  EXPECT_GE(taken, test::sanitized ? 1 : 1000);
}

TEST(Plan, LightWithoutAHighlightIsPhongs) {
  const std::uint64_t seed = test::seed();
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Random random(seed, i);
    const std::vector<Light> lights{test::random_light(random), test::random_light(random),
                                    test::random_light(random)};
    Material material = test::random_material(random);
    material.specular = LinearRgb{0};
    material.emission = LinearRgb{0.1f};
    const dvec3 place = test::random_point(random, 6), eye = test::random_point(random, 6);
    const dvec3 normal = unit_vector(test::random_point(random, 1));
    const std::span<const Light> lamps(lights);
    const auto whole = illumination::phong(place, normal, eye, material, lamps, LinearRgb{0.3f});
    const auto matte = illumination::matte(place, normal, material, lamps, LinearRgb{0.3f});
    ASSERT_TRUE(matte.ambient == whole.ambient && matte.diffuse == whole.diffuse &&
                matte.specular == whole.specular)
        << "seed " << seed << ", case " << i;
  }
}

}  // namespace
}  // namespace gradus::pipeline::plan_property_test
