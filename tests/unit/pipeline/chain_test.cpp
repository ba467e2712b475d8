// The eight stages: their steps, their ids, what reaches the picture.

#include <gtest/gtest.h>

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "core/random.hpp"
#include "core/record.hpp"
#include "pipeline_notes.hpp"
#include "scene/camera/framing.hpp"
#include "scene/files.hpp"
#include "support/change_mesh.hpp"
#include "support/seed.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::chain_test {
namespace {

using Record = Recorder<VertexRead, FaceRead, Placed, Turned, Projected, Faced, Clipped, Snapped, Covered,
                        DepthTested, Shaded, Written>;

Mesh model(const std::string& text) {
  return parse_obj(text, "m.obj", [](const std::string&) { return std::nullopt; }).mesh;
}

Mesh letter() { return load_obj(std::string(GRADUS_SOURCE_DIR) + "/examples/models/letter_f.obj").mesh; }

/// A scene without lights: every surface has the colour of its material's own light. The camera looks along
/// -z.
Scene glowing(std::vector<std::pair<std::string, LinearRgb>> models) {
  Scene scene;
  scene.background = LinearRgb{0};
  scene.ambient = LinearRgb{0};
  scene.camera.lens = {radians_from_degrees(90), 1, 100};
  for (const auto& [text, colour] : models) {
    scene.objects.push_back(object_of(model(text)));
    test::change_materials(scene.objects.back(), [&](Material& m) { m.emission = colour; });
  }
  return scene;
}

constexpr Rgba8 red{255, 0, 0, 255}, green{0, 255, 0, 255}, black{0, 0, 0, 255};

TEST(Chain, TheLetterReadsAsF) {
  // From straight ahead, in 16 x 12 pixels
  Scene scene = scene_of(letter(), 16.0 / 12);
  const auto picture = [&](dvec3 side) {
    std::vector<dvec3> points = scene.objects[0].mesh->positions;
    scene.camera = framed(std::span<const dvec3>(points), 16.0 / 12, side);
    const Image image = render(scene, {16, 12});
    std::string text;
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 16; ++x) text += image[{x, y}] == Rgba8{255, 255, 255, 255} ? '.' : '#';
      text += '\n';
    }
    return text;
  };
  EXPECT_EQ(picture({0, 0, 1}),
            "................\n"
            ".....######.....\n"
            ".....######.....\n"
            ".....##.........\n"
            ".....##.........\n"
            ".....#####......\n"
            ".....#####......\n"
            ".....##.........\n"
            ".....##.........\n"
            ".....##.........\n"
            ".....##.........\n"
            "................\n");
  // From behind it is a mirrored one: the same chain, no trick
  std::istringstream front(picture({0, 0, 1})), back(picture({0, 0, -1}));
  for (std::string a, b; std::getline(front, a) && std::getline(back, b);) {
    std::ranges::reverse(b);
    const auto last = [](const std::string& row) { return row.find_last_of('#'); };
    EXPECT_LE(std::abs(static_cast<int>(last(a)) - static_cast<int>(last(b))), 1) << a << ' ' << b;
  }
}

TEST(Chain, EveryStageTellsItsStepsInOrder) {
  const Scene scene = scene_of(letter(), 1.5);
  Record seen;
  const Image image = render(scene, {60, 40}, seen);
  EXPECT_EQ(image, render(scene, {60, 40}));  // observed == unobserved
  ASSERT_TRUE(seen.complete());

  // Each stage after the one before, but rasterization and z-buffer alternate
  constexpr int stage[]{1, 1, 2, 2, 3, 4, 5, 6, 6, 6, 7, 8};
  int last = 0;
  for (const auto& event : seen.events()) {
    EXPECT_GE(stage[event.step.index()], last);
    last = stage[event.step.index()];
  }
  EXPECT_EQ(all<VertexRead>(seen).size(), 20u);
  EXPECT_EQ(all<FaceRead>(seen).size(), 12u);
  EXPECT_EQ(all<Placed>(seen).size(), 20u);
  EXPECT_EQ(all<Projected>(seen).size(), 20u);
  EXPECT_EQ(all<Faced>(seen).size(), 36u);
  EXPECT_EQ(all<Written>(seen).size(), 2400u);
  const auto clipped = all<Clipped>(seen);
  const auto facing = all<Faced>(seen);
  EXPECT_EQ(clipped.size(), static_cast<std::size_t>(std::ranges::count(facing, false, &Faced::removed)));
  EXPECT_EQ(all<Snapped>(seen).size(), clipped.size());
  EXPECT_EQ(all<Covered>(seen).size(), all<DepthTested>(seen).size());
  std::set<std::pair<int, int>> pixels;
  for (const Covered& c : all<Covered>(seen)) pixels.insert({c.fragment.pixel.x, c.fragment.pixel.y});
  EXPECT_EQ(all<Shaded>(seen).size(), pixels.size());

  // The front face, number 0 of the file's faces, stands in line 29 and has eight pieces
  const FaceRead front = all<FaceRead>(seen)[0];
  EXPECT_EQ(front.vertices.size(), 10u);
  ASSERT_EQ(front.pieces.size(), 8u);
  EXPECT_EQ(front.line, 29);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(front.pieces[static_cast<std::size_t>(i)].id, (PieceId{0, 0, i}));
  // Weights are shares, and the place they give lies on the face
  EXPECT_TRUE(every<Shaded>(seen, [&](const Shaded& s) {
    const dvec3 w = s.fragment.weights;
    return std::abs(w.x + w.y + w.z - 1) < 1e-15 &&
           (s.fragment.id.face != 0 || std::abs(s.place.at.z - 0.15) < 1e-15) &&
           glm::dot(s.normal, scene.camera.frame.eye - s.place.at) > 0 && s.fragment.depth >= 0 &&
           s.fragment.depth <= 1;
  }));
}

TEST(Chain, AFragmentLiesOnTheRayThroughItsPixel) {
  const Scene scene = scene_of(letter(), 1.5);
  Record seen;
  render(scene, {90, 60}, seen);
  const auto shaded = all<Shaded>(seen);
  ASSERT_GT(shaded.size(), 500u);
  for (const Shaded& s : shaded) {
    const Ray ray = ray_through(scene.camera, 90, 60, dvec2(s.fragment.pixel) + 0.5);
    const double depth = glm::dot(s.place.at - ray.origin, scene.camera.frame.forward);
    const double error = glm::distance(s.place.at, ray.origin + depth * ray.direction);
    // Corners were moved by up to 1/512 pixel per coordinate
    const double pixel = depth * glm::distance(ray_through(scene.camera, 90, 60, {1, 0}).direction,
                                               ray_through(scene.camera, 90, 60, {0, 0}).direction);
    EXPECT_LT(error, pixel / 256);
  }
}

TEST(Chain, AtEqualDepthTheLowestObjectAndFaceIsSeen) {
  const std::string wall = "v -9 -9 -5\nv 9 -9 -5\nv 9 9 -5\nv -9 9 -5\n";
  // The same triangle in two objects, with its corners in another order
  Scene scene = glowing({{wall + "f 1 2 3\n", {1, 0, 0}}, {wall + "f 3 1 2\n", {0, 1, 0}}});
  EXPECT_EQ((render(scene, {8, 8})[{6, 4}]), red);
  std::swap(scene.objects[0], scene.objects[1]);
  EXPECT_EQ((render(scene, {8, 8})[{6, 4}]), green);
  // Turned round, it is the same triangle still
  scene = glowing({{wall + "f 1 2 3\n", {1, 0, 0}}, {wall + "f 2 1 3\n", {0, 1, 0}}});
  EXPECT_EQ((render(scene, {8, 8})[{6, 4}]), red);
  // Two faces of one object
  scene = glowing({{wall + "usemtl a\nf 1 2 3\nusemtl b\nf 2 3 1\n", {1, 0, 0}}});
  test::change_mesh(scene.objects[0], [](Mesh& mesh) { mesh.materials[2].emission = {0, 1, 0}; });
  EXPECT_EQ((render(scene, {8, 8})[{6, 4}]), red);
}

TEST(Chain, EqualDepthHoldsForSlantedTrianglesOfAnyNumbering) {
  Random random(test::seed());
  int cases = 0;
  std::int64_t pixels = 0;
  for (; cases < 300; ++cases) {
    std::string v;
    for (int i = 0; i < 3; ++i)
      v += fmt::format("v {} {} {}\n", random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, -2));
    const char* orders[]{"f 1 2 3\n", "f 2 3 1\n", "f 3 1 2\n", "f 1 3 2\n", "f 3 2 1\n", "f 2 1 3\n"};
    const Scene scene = glowing({{v + orders[random.uniform_int(0, 5)], {1, 0, 0}},
                                 {v + orders[random.uniform_int(0, 5)], {0, 1, 0}}});
    const Image image = render(scene, {40, 40});
    for (const Rgba8& pixel : image.cells()) {
      ASSERT_NE(pixel, green) << "case " << cases << ", seed " << test::seed();
      pixels += pixel == red;
    }
  }
  EXPECT_EQ(cases, 300);
  EXPECT_GT(pixels, 10000);
}

TEST(Chain, NearerHidesFartherAndPiercingPlanesMeet) {
  const std::string far = "v -99 -99 -9\nv 99 -99 -9\nv 99 99 -9\nv -99 99 -9\nf 1 2 3 4\n";
  const std::string slope =
      "v -99 -99 -3\nv 99 -99 -15\nv 99 99 -15\nv -99 99 -3\nf 1 2 3 4\n";  // meets it in the middle
  const Image image = render(glowing({{far, {1, 0, 0}}, {slope, {0, 1, 0}}}), {10, 4});
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 10; ++x) EXPECT_EQ((image[{x, y}]), (x < 5 ? green : red)) << x << ' ' << y;
  }
}

TEST(Chain, WhatLiesBehindTheEyeIsCutAway) {
  // A floor from far behind the viewer to far ahead: below the horizon in every column, nothing above
  const std::string floor = "v -9e5 -1 9e5\nv 9e5 -1 9e5\nv 9e5 -1 -9e5\nv -9e5 -1 -9e5\nf 1 2 3 4\n";
  Scene scene = glowing({{floor, {0, 1, 0}}});
  scene.camera.lens.far = 1e6;
  Record seen(5'000'000);
  const Image image = render(scene, {64, 64}, seen);
  for (int x = 0; x < 64; ++x) {
    EXPECT_EQ((image[{x, 31}]), black) << x;
    EXPECT_EQ((image[{x, 33}]), green) << x;
    EXPECT_EQ((image[{x, 63}]), green) << x;
  }
  EXPECT_TRUE(every<Clipped>(seen, [](const Clipped& c) { return c.changed && c.after.size() >= 3; }));
  for (const Clipped& c : all<Clipped>(seen)) {
    for (const NdcPoint& p : c.divided) {
      EXPECT_GE(p.at.z, 0);
      EXPECT_LE(p.at.z, 1 + 1e-15);
      EXPECT_LE(std::abs(p.at.x) * 32, guard_pixels * (1 + 1e-12));
    }
  }
}

TEST(Chain, GuardPlanesKeepNeighboursTogether) {
  // Fans of huge triangles round random hubs: the picture must be covered without a gap, once
  Random random(test::seed() + 7);
  int cases = 0;
  for (; cases < 150; ++cases) {
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3),
                 far = std::pow(10.0, random.uniform(1, 9));
    std::string text = fmt::format("v {} {} -4\n", x, y), faces;
    const int n = 7;
    for (int i = 0; i < n; ++i) {
      const double angle = (i + random.uniform(-0.3, 0.3)) * 6.283185307179586 / n;
      text += fmt::format("v {} {} {}\n", x + far * std::cos(angle), y + far * std::sin(angle),
                          -4 + random.uniform(-0.9, 0.9) * far * 0.01);
      faces += fmt::format("f 1 {} {}\n", i + 2, (i + 1) % n + 2);
    }
    Scene scene = glowing({{text + faces, {0, 1, 0}}});
    scene.camera.lens = {radians_from_degrees(60), 0.01, 1e9};
    Record seen(5'000'000);
    const Image image = render(scene, {24, 18}, seen);
    ASSERT_TRUE(seen.complete());
    std::map<std::pair<int, int>, int> hits;
    bool bent = false;
    for (const Covered& c : all<Covered>(seen)) ++hits[{c.fragment.pixel.x, c.fragment.pixel.y}];
    for (const Faced& f : all<Faced>(seen)) bent = bent || f.facing != back_face_culling::Facing::front;
    if (bent) continue;  // the fan folds over: some pixels are covered twice, and rightly
    for (const auto& [pixel, count] : hits)
      ASSERT_EQ(count, 1) << "case " << cases << ", seed " << test::seed();
  }
  EXPECT_EQ(cases, 150);
}

TEST(Chain, CoordinatesOfAnySizeAreClippedSoundly) {
  Random random(test::seed() + 8);
  int cases = 0;
  std::int64_t cut = 0, corners = 0;
  for (; cases < 2000; ++cases) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
      const auto any = [&] {
        return (random.uniform_int(0, 1) ? 1 : -1) * std::pow(10.0, random.uniform(-30, 29));
      };
      text += fmt::format("v {} {} {}\n", any(), any(), any());
    }
    Scene scene = glowing({{text + "f 1 2 3\n", {0, 1, 0}}});
    scene.camera.lens = {radians_from_degrees(random.uniform(1, 170)), 1e-3,
                         std::pow(10.0, random.uniform(-2, 9))};
    Record seen;
    ASSERT_NO_THROW(render(scene, {16, 9}, seen)) << "case " << cases << ", seed " << test::seed() << "\n"
                                                  << text;
    for (const Clipped& c : all<Clipped>(seen)) {
      cut += c.changed && !c.after.empty();
      for (const ClipPoint& p : c.after) ASSERT_GT(p.at.w, 0);
      for (const NdcPoint& p : c.divided) {
        ASSERT_LE(std::max(std::abs(p.at.x) * 8, std::abs(p.at.y) * 4.5), guard_pixels * (1 + 1e-9));
        ASSERT_GE(p.at.z, -1e-12);
        ASSERT_LE(p.at.z, 1 + 1e-12);
        ++corners;
      }
    }
  }
  EXPECT_EQ(cases, 2000);
  EXPECT_GT(cut, 100);
  std::printf("%lld pieces cut, %lld corners\n", static_cast<long long>(cut),
              static_cast<long long>(corners));
}

TEST(Chain, ClosedBodiesLoseTheirBacksAndNothingElse) {
  Scene scene = scene_of(letter(), 1.5);
  ASSERT_FALSE(scene.objects[0].two_sided);
  const Image culled = render(scene, {90, 60});
  scene.objects[0].two_sided = true;
  Record seen;
  EXPECT_EQ(render(scene, {90, 60}, seen), culled);
  EXPECT_TRUE(every<Faced>(
      seen, [](const Faced& f) { return !f.removed || f.facing == back_face_culling::Facing::edge_on; }));
}

TEST(Chain, PlacementsMoveTurnAndMirror) {
  Scene scene = scene_of(letter(), 1);
  const Image plain = render(scene, {48, 48});
  // Mirrored at x = 0 it still is a closed body with its outside out
  scene.objects[0].placement = affine_3d::scaling(dvec3{-1, 1, 1});
  scene.camera = framed(bounds_of(scene), 1);
  Record seen;
  const Image mirrored = render(scene, {48, 48}, seen);
  EXPECT_NE(mirrored, plain);
  EXPECT_TRUE(every<Turned>(seen, [](const Turned& t) { return t.mirrored; }));
  EXPECT_TRUE(every<Shaded>(
      seen, [&](const Shaded& s) { return glm::dot(s.normal, scene.camera.frame.eye - s.place.at) > 0; }));
  EXPECT_GT(all<Shaded>(seen).size(), 300u);
  // Moved together with the camera, it is the same picture
  Scene moved = scene_of(letter(), 1);
  moved.objects[0].placement = affine_3d::translation(dvec3{4, 8, -2});
  moved.camera.frame.eye += dvec3{4, 8, -2};
  const Image again = render(moved, {48, 48});
  int different = 0;
  for (std::size_t i = 0; i < plain.cells().size(); ++i) different += !(plain.cells()[i] == again.cells()[i]);
  EXPECT_LE(different, 5);  // rounding may move a corner by 1/256 pixel
}

TEST(Chain, NothingToSeeGivesTheBackground) {
  Scene scene;
  scene.background = {0, 1, 0};
  const Image image = render(scene, {3, 2});
  for (const Rgba8& pixel : image.cells()) EXPECT_EQ(pixel, green);
  EXPECT_THROW(render(scene, {0, 2}), ContractViolation);
  EXPECT_THROW(render(scene, {40000, 2}), ContractViolation);
  EXPECT_THROW(scene_of(Mesh{}, 1), ContractViolation);
  scene.camera.lens.near = 0;
  EXPECT_THROW(render(scene, {3, 2}), ContractViolation);
}

/// The picture with this shading, and its visible fragments.
std::pair<Image, std::vector<Shaded>> shaded_as(Scene scene, Shading shading) {
  scene.shading = shading;
  Recorder<Shaded> seen;
  Image image = render(scene, {90, 60}, only<Shaded>(seen));
  return {std::move(image), all<Shaded>(seen)};
}

TEST(Chain, FlatShadingGivesEveryFaceOneColour) {
  const Mesh spot = load_obj(std::string(GRADUS_SOURCE_DIR) + "/examples/models/spot.obj").mesh;
  const Scene scene = scene_of(spot, 1.5);
  std::map<int, LinearRgb> colours;
  for (const Shaded& s : shaded_as(scene, Shading::flat).second) {
    const auto [known, is_new] = colours.try_emplace(s.fragment.id.face, s.colour);
    EXPECT_EQ(known->second, s.colour) << s.fragment.id.face;
  }
  EXPECT_GT(colours.size(), 40u);
}

TEST(Chain, ShadingsDifferWhereNormalsDo) {
  // Plane faces with normals of their own, scattered light from far away: nothing varies over a face
  const auto farthest_apart = [](const std::vector<Shaded>& a, const std::vector<Shaded>& b) {
    float most = 0;
    EXPECT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      most = std::max(most, glm::distance(a[i].colour, b[i].colour));
    return most;
  };
  Scene scene = scene_of(letter(), 1.5);
  test::change_materials(scene.objects[0], [](Material& m) { m.specular = LinearRgb{0}; });
  Light sun;
  sun.kind = Light::Kind::directional;
  sun.direction = {1, -2, -3};
  scene.lights = {sun};
  const auto light = shaded_as(scene, Shading::phong).second;
  EXPECT_LT(farthest_apart(light, shaded_as(scene, Shading::gouraud).second), 1e-6f);
  EXPECT_LT(farthest_apart(light, shaded_as(scene, Shading::flat).second), 1e-6f);
  // On a body with mixed normals they part, flat shading the most
  Scene body = scene_of(load_obj(std::string(GRADUS_SOURCE_DIR) + "/examples/models/spot.obj").mesh, 1.5);
  body.lights = {sun};
  const auto each = shaded_as(body, Shading::phong).second;
  const float gouraud = farthest_apart(each, shaded_as(body, Shading::gouraud).second);
  const float flat = farthest_apart(each, shaded_as(body, Shading::flat).second);
  EXPECT_GT(gouraud, 0.01f);
  EXPECT_GT(flat, 2 * gouraud);
}

TEST(Chain, TooMuchLightIsWhite) {
  Record seen;
  Scene scene = glowing({{"v -9 -9 -5\nv 9 -9 -5\nv 0 9 -5\nf 1 2 3\n", {20, 0.5f, 0}}});
  EXPECT_EQ((render(scene, {4, 4}, seen)[{2, 2}]), (Rgba8{255, 188, 0, 255}));
  const auto written = all<Written>(seen);
  EXPECT_TRUE(std::ranges::any_of(written, &Written::cut_off));
}

// The chain with one stage as lecture notes have it.

/// The letter seen from so near that parts of it lie behind the eye.
Scene letter_from_near() {
  Scene scene = scene_of(letter(), 40.0 / 28);
  const dvec3 from{-0.2, 0.6, 0.35}, to{0.1, 0.2, 0};
  scene.camera.frame = viewing::look_at(from, to, dvec3{0, 1, 0});
  scene.camera = with_depths(scene.camera, bounds_of(scene));
  scene.lights = default_lights(scene.camera);
  return scene;
}

/// A square that fills the picture, cut along the diagonal.
Scene filling_square() {
  Scene scene = scene_of(model("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"), 1);
  scene.camera.frame = viewing::look_at(dvec3{0, 0, 1}, dvec3{0, 0, 0}, dvec3{0, 1, 0});
  scene.camera.lens = {radians_from_degrees(90), 0.5, 10};
  scene.lights = default_lights(scene.camera);
  return scene;
}

TEST(ChainNotes, WithoutAFaultItIsTheChain) {
  const Scene scene = letter_from_near();
  EXPECT_EQ(render_with(Fault::none, scene, {40, 28}), render(scene, {40, 28}));
}

TEST(ChainNotes, CullingAfterTheDivisionMakesHoles) {
  // E001-40: wrong about exactly those with an odd number of corners behind the eye
  const Scene scene = letter_from_near();
  Record right(1'000'000), wrong(1'000'000);
  const Image whole = render(scene, {40, 28}, right);
  const Image holed = render_with(Fault::cull_after_division, scene, {40, 28}, wrong);
  const auto clip = all<Projected>(right);
  const auto pieces = [&] {
    std::vector<Piece> found;
    for (const FaceRead& face : all<FaceRead>(right)) {
      found.insert(found.end(), face.pieces.begin(), face.pieces.end());
    }
    return found;
  }();
  const auto faced = all<Faced>(right), divided = all<Faced>(wrong);
  ASSERT_EQ(faced.size(), pieces.size());
  ASSERT_EQ(divided.size(), pieces.size());
  int misjudged = 0, culled = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    int behind = 0;
    for (const PieceCorner& corner : pieces[i].corners) {
      behind += clip[static_cast<std::size_t>(corner.vertex)].clip.at.w < 0;
    }
    const bool edge_on = faced[i].facing == back_face_culling::Facing::edge_on;
    EXPECT_EQ(faced[i].facing != divided[i].facing, behind % 2 == 1 && !edge_on) << i;
    misjudged += faced[i].facing != divided[i].facing;
    culled += divided[i].removed && !faced[i].removed;
  }
  EXPECT_GT(misjudged, 0);
  EXPECT_GT(culled, 0) << "front faces";
  const auto background = [&](const Image& image) {
    int count = 0;
    for (int y = 0; y < 28; ++y) {
      for (int x = 0; x < 40; ++x) count += image[{x, y}] == Rgba8{255, 255, 255, 255};
    }
    return count;
  };
  EXPECT_GT(background(holed), background(whole)) << "holes";
}

TEST(ChainNotes, ClosedHalfPlanesMakeFragmentsTwice) {
  // E001-42: 36 + 36 fragments for 64 pixels. The depth buffer hides it: the pictures are the same
  const Scene scene = filling_square();
  Record right(10'000), wrong(10'000);
  const Image once = render(scene, {8, 8}, right);
  const Image twice = render_with(Fault::closed_half_planes, scene, {8, 8}, wrong);
  EXPECT_EQ(all<Covered>(right).size(), 64u);
  EXPECT_EQ(all<Covered>(wrong).size(), 72u);
  EXPECT_EQ(once, twice);
  std::map<std::pair<int, int>, int> times;
  for (const Covered& c : all<Covered>(wrong)) ++times[{c.fragment.pixel.x, c.fragment.pixel.y}];
  for (const auto& [pixel, count] : times) {
    EXPECT_EQ(count, pixel.first + pixel.second == 7 ? 2 : 1) << pixel.first << " " << pixel.second;
  }
}

TEST(ChainNotes, ExpandedEdgesLoseAndDoublePixels) {
  // E001-43: in a tile 1e8 columns and rows from the origin
  const Scene scene = scene_of(letter(), 40.0 / 28);
  Record right(1'000'000), wrong(1'000'000);
  render(scene, {40, 28}, right);
  render_with(Fault::expanded_edges, scene, {40, 28}, wrong);
  const auto pixels = [](const Record& record) {
    std::set<std::tuple<int, int, int>> found;
    for (const Covered& c : all<Covered>(record)) {
      found.emplace(c.fragment.triangle, c.fragment.pixel.y, c.fragment.pixel.x);
    }
    return found;
  };
  const auto exact = pixels(right), rounded = pixels(wrong);
  std::vector<std::tuple<int, int, int>> lost, extra;
  std::ranges::set_difference(exact, rounded, std::back_inserter(lost));
  std::ranges::set_difference(rounded, exact, std::back_inserter(extra));
  EXPECT_FALSE(lost.empty());
  EXPECT_FALSE(extra.empty());
}

}  // namespace
}  // namespace gradus::pipeline::chain_test
