// Several surfaces in one plane, and sheets side by side: which is seen, by every method of the chain and the
// engine. What each picture must be is put together from pictures of one surface alone, where nothing hides
// anything.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "pipeline.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/models/obj.hpp"
#include "stages/arrangement.hpp"
#include "support/seed.hpp"
#include "why/why.hpp"
#include "why/why_text.hpp"

namespace gradus::pipeline::coplanar_test {
namespace {

constexpr Size size{28, 21};

// --- Trees ---------------------------------------------------------------------------------------

/// A triangle in the world plane z = 0, round its corners from `first` on, maybe the other way round.
Triangle triangle_of(int face, std::size_t first, bool turned) {
  constexpr std::array<dvec3, 3> corners{dvec3{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  Triangle triangle{{0, face, 0}, {}, turned};
  for (std::size_t i = 0; i < 3; ++i)
    triangle.corners[turned ? 2 - i : i].world.at = corners[(first + i) % 3];
  return triangle;
}

TEST(Coplanar, ATreeDrawsTheLowestFaceOfAPlaneLast) {
  Triangles triangles;
  for (int face = 0; face < 12; ++face)
    triangles.push_back(triangle_of(face, static_cast<std::size_t>(face), face % 2 == 1));
  SceneCamera camera;
  for (const double side : {-5.0, 5.0}) {
    camera.frame.eye = {1, 1, side};
    const Triangles ordered = in_tree_order(camera, triangles);
    ASSERT_EQ(ordered.size(), 12U);
    for (int place = 0; place < 12; ++place)
      EXPECT_EQ(ordered[static_cast<std::size_t>(place)].id.face, 11 - place) << "eye at z = " << side;
  }
}

// --- Pictures ------------------------------------------------------------------------------------

/// A model of surfaces that glow: the red ones, which come first in the file, are to be seen wherever they
/// are, the green ones elsewhere.
struct Sheets {
  std::string name;
  std::string vertices, red, green;
};

std::vector<Sheets> all_sheets() {
  const std::string square = "v 0 0 0\nv 4.1 0 0\nv 4.1 3.3 0\nv 0 3.3 0\n";
  const std::string leaning = "v 0 0 0.25\nv 4 0 1.25\nv 4 3 2.75\nv 0 3 1.75\n";
  return {
      {"a triangle given twice, once turned round", "v 0 0 0\nv 4.1 0.3 1\nv 0.7 3.3 2\n", "f 1 2 3\n",
       "f 3 2 1\n"},
      {"a square given twice from another corner", square, "f 1 2 3 4\n", "f 2 3 4 1\n"},
      {"a leaning one, once turned round", leaning, "f 1 2 3 4\n", "f 3 2 1 4\n"},
      {"a decal in the corner of a square", square + "v 0 0 0\nv 1.3 0 0\nv 1.3 1.1 0\nv 0 1.1 0\n",
       "f 5 6 7 8\n", "f 1 2 3 4\n"},
      {"a decal across the diagonal", square + "v 1 1 0\nv 3 1.1 0\nv 3.2 2.5 0\nv 1.4 2.9 0\n",
       "f 5 8 7 6\n", "f 1 2 3 4\n"},
      {"a decal on a leaning wall", leaning + "v 1 1 1\nv 2 1 1.25\nv 2 2 1.75\nv 1 2 1.5\n", "f 5 6 7 8\n",
       "f 1 2 3 4\n"},
      {"a wall over a later decal", square + "v 1 1 0\nv 3 1.1 0\nv 3.2 2.5 0\nv 1.4 2.9 0\n", "f 1 2 3 4\n",
       "f 5 6 7 8\n"},
  };
}

Scene scene_of(const std::string& text, const glm::dmat4& placement) {
  const auto lights = [](const std::string&) {
    return LibraryText{
        "newmtl red\nKa 0 0 0\nKd 0 0 0\nKs 0 0 0\nKe 1 0 0\n"
        "newmtl green\nKa 0 0 0\nKd 0 0 0\nKs 0 0 0\nKe 0 1 0\n"};
  };
  Scene scene;
  scene.ambient = LinearRgb{0};
  scene.background = LinearRgb{0};
  scene.shading = Shading::flat;
  scene.culling = Culling::none;
  scene.samples = 4;
  scene.objects.push_back(object_of(parse_obj("mtllib m.mtl\n" + text, "m.obj", lights).mesh));
  scene.objects.back().placement = placement;
  return scene;
}

/// The scene with both, with the red ones alone and with the green ones alone.
struct Scenes {
  Scene both, red, green;

  Scenes(const Sheets& sheets, const glm::dmat4& placement)
      : both(scene_of(sheets.vertices + "usemtl red\n" + sheets.red + "usemtl green\n" + sheets.green,
                      placement)),
        red(scene_of(sheets.vertices + "usemtl red\n" + sheets.red, placement)),
        green(scene_of(sheets.vertices + "usemtl green\n" + sheets.green, placement)) {}

  template <class Change>
  void change(const Change& change_scene) {
    for (Scene* scene : {&both, &red, &green}) change_scene(*scene);
  }
};

/// Somewhere in space, turned anyhow.
glm::dmat4 random_placement(Random& random) {
  const auto any = [&](double most) { return random.uniform(-most, most); };
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), dvec3{any(9), any(9), any(9)});
  return glm::rotate(moved, any(3), dvec3{any(1), any(1), any(1) + 0.01});
}

/// Looks at the middle of the sheets from any side, but not along them.
SceneCamera random_camera(const glm::dmat4& placement, Random& random) {
  const dvec3 middle(placement * glm::dvec4(2, 1.5, 0.7, 1));
  const double side = random.uniform_int(0, 1) == 0 ? 1 : -1, height = side * random.uniform(1.5, 4);
  const dvec3 eye(placement * glm::dvec4{random.uniform(-3, 7), random.uniform(-3, 6), 0.7 + height, 1});
  SceneCamera camera;
  camera.frame = viewing::look_at(eye, middle, dvec3{0.01, 1, 0.02});
  camera.lens = {1.2, 0.1, 100};
  return camera;
}

/// How far a picture is from what it must be, at most.
double off(const LightPicture& both, const LightPicture& red, const LightPicture& green) {
  double worst = 0;
  for (std::size_t i = 0; i < both.cells().size(); ++i) {
    const double share = both.cells()[i].share, of_red = red.cells()[i].share,
                 of_green = green.cells()[i].share;
    const dvec3 way = glm::abs(both.cells()[i].sum - dvec3{of_red, share - of_red, 0});
    worst =
        std::max({worst, way.x, way.y, way.z, std::max(of_red, of_green) - share, share - of_red - of_green});
  }
  return worst;
}

int covered(const LightPicture& picture) {
  int count = 0;
  for (const PixelLight& pixel : picture.cells()) count += pixel.share > 0;
  return count;
}

/// Pixels of two pictures that are more than a step of 255 apart.
int apart(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const Rgba8 p = a.cells()[i], q = b.cells()[i];
    count += std::abs(p.r - q.r) > 1 || std::abs(p.g - q.g) > 1 || std::abs(p.b - q.b) > 1;
  }
  return count;
}

/// check(scenes, what) for sheets seen from everywhere, and every antialiasing.
template <class Check>
void for_all_sheets(const Check& check) {
  std::uint64_t round = 0;
  for (const Sheets& sheets : all_sheets()) {
    for (int view = 0; view < 3; ++view) {
      Random random(test::seed(), round++);
      const glm::dmat4 placement = view == 0 ? glm::dmat4(1) : random_placement(random);
      Scenes scenes(sheets, placement);
      const SceneCamera camera = random_camera(placement, random);
      for (std::size_t method = 0; method < antialiasing_names.size(); ++method) {
        scenes.change([&](Scene& scene) {
          scene.camera = camera;
          scene.antialiasing = static_cast<Antialiasing>(method);
        });
        check(scenes, fmt::format("{}, view {}, {}", sheets.name, view, antialiasing_names[method]));
      }
    }
  }
}

TEST(Coplanar, EveryMethodShowsTheLowestFaceOfAPlane) {
  int pixels = 0;
  for_all_sheets([&](Scenes& scenes, const std::string& what) {
    const LightPicture red = antialiased(scenes.red, size), green = antialiased(scenes.green, size);
    EXPECT_LT(off(antialiased(scenes.both, size), red, green), 1e-9) << what;
    pixels += covered(red);
    // The engine has the same bits, or bytes
    const engine::Buffers buffers = engine::buffers_of(scenes.both);
    const Plan plan = plan_of(scenes.both, size);
    EXPECT_LT(off(engine::light_of(scenes.both, buffers, plan, 1), red, green), 1e-9) << what << ", engine";
    if (!engine::draws_in_single_precision(scenes.both)) return;
    engine::Workspace workspace;
    const Image drawn = engine::picture_of(scenes.both, buffers, plan, workspace, 1).image;
    EXPECT_EQ(apart(drawn, render_antialiased(scenes.both, size)), 0) << what << ", engine, single precision";
  });
  EXPECT_GT(pixels, 10000);
}

TEST(Coplanar, SoDoOrdersFromBackToFront) {
  for_all_sheets([&](Scenes& scenes, const std::string& what) {
    // Others compare places in the order as these do
    const Antialiasing method = scenes.both.antialiasing;
    if (method != Antialiasing::none && method != Antialiasing::area_sampling &&
        method != Antialiasing::a_buffer)
      return;
    const LightPicture red = antialiased(scenes.red, size), green = antialiased(scenes.green, size);
    for (const auto hidden : {HiddenSurfaces::painter, HiddenSurfaces::bsp_tree}) {
      scenes.both.hidden_surfaces = hidden;
      EXPECT_LT(off(antialiased(scenes.both, size), red, green), 1e-9)
          << what << ", " << hidden_surface_names[static_cast<std::size_t>(hidden)];
    }
    scenes.both.hidden_surfaces = HiddenSurfaces::z_buffer;
  });
}

TEST(Coplanar, WhySaysWhichOfTwoAsDeepIsSeen) {
  Scenes scenes(all_sheets().front(), glm::dmat4(1));
  scenes.both.camera.frame = viewing::look_at(dvec3{2, 1, 4}, dvec3{1.5, 1, 1}, dvec3{0, 1, 0});
  scenes.both.antialiasing = Antialiasing::none;
  const std::string text = why_text("scene", scenes.both, size, why(scenes.both, size, {14, 10}));
  EXPECT_NE(text.find("as deep and of a higher face, thrown away"), std::string::npos) << text;
}

}  // namespace
}  // namespace gradus::pipeline::coplanar_test
