// What can be chosen for a picture: projection, hidden surfaces, culling, wireframe, and all of it at once.

#include "scene/choices.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/camera/view.hpp"
#include "scene/files.hpp"
#include "support/change_mesh.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "why/why_text.hpp"

namespace gradus::pipeline::choices_test {
namespace {

Mesh model(const std::string& text) {
  return parse_obj(text, "m.obj", [](const std::string&) { return std::nullopt; }).mesh;
}

Mesh shipped(const std::string& name) {
  return load_obj(std::string(GRADUS_SOURCE_DIR) + "/examples/models/" + name).mesh;
}

/// The scene as a view sees it, one colour per face.
Scene seen_by(Scene scene, const View& view, Size size) {
  const double aspect = static_cast<double>(size.width) / size.height;
  scene.camera = camera_of(aim_of(scene.objects, view, aspect), view, scene.objects, aspect);
  scene.shading = Shading::flat;
  scene.antialiasing = Antialiasing::none;
  return scene;
}

View parallel_view(Projection3d projection) {
  View view;
  view.projection = projection;
  return view;
}

std::int64_t differing(const Image& a, const Image& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.cells().size(); ++i) count += a.cells()[i] != b.cells()[i];
  return count;
}

constexpr const char* cube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// --- Projection

TEST(Projections, ParallelRaysMeetThePlaneWhereExactNumbersSay) {
  Random random(test::seed());
  int leaning = 0;
  for (int i = 0; i < 2000; ++i) {
    SceneCamera camera;
    ParallelRays& rays = camera.rays.emplace();
    rays = {random.uniform(0.1, 50), {}, random.uniform(1, 9), -3, random.uniform(10, 20)};
    if (i % 2) rays.slant = {random.uniform(-2, 2), random.uniform(-2, 2)};
    leaning += i % 2;
    const dvec3 view{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const double aspect = random.uniform(0.3, 3);
    const glm::dvec4 clip = transform(lens_of(camera, aspect), view);
    // Along the rays onto the plane, by the topic's general method without rounding
    const auto exact = [](dvec3 v) { return parallel::Point<Exact>{Exact(v.x), Exact(v.y), Exact(v.z)}; };
    const auto image = parallel::along<Exact>({exact({0, 0, 1}), Exact(rays.plane)},
                                              exact({rays.slant.a, rays.slant.b, 1}), exact(view));
    const double y = to_double(image.y * Exact(2) / Exact(rays.height));
    const double x = to_double(image.x * Exact(2) / Exact(rays.height) / Exact(aspect));
    const double bound = 0x1p-48 * (20 / rays.height) * std::max(1.0, 1 / aspect) * 4;
    EXPECT_NEAR(clip.x, x, bound);
    EXPECT_NEAR(clip.y, y, bound);
    EXPECT_NEAR(clip.z, (view.z - rays.near) / (rays.far - rays.near), 1e-14);
    EXPECT_EQ(clip.w, 1);
  }
  EXPECT_EQ(leaning, 1000);
}

TEST(Projections, PerspectiveFromFarAwayIsOrthographic) {
  const Size size{96, 72};
  const Scene scene = scene_of(shipped("letter_f.obj"), 4.0 / 3);
  const Scene flat = seen_by(scene, parallel_view(Projection3d::orthographic), size);
  const Image straight = render(flat, size);
  std::int64_t last = 96 * 72;
  for (const double away : {10.0, 1e3, 1e6}) {
    // The same direction from farther and farther, as high in the middle of the model
    Scene far = flat;
    Camera camera = flat.camera;
    const dvec3 middle = camera.frame.eye + flat.camera.rays->plane * camera.frame.forward;
    camera.frame.eye = middle - away * camera.frame.forward;
    camera.lens.vertical_radians = 2 * atan2(flat.camera.rays->height / 2, away);
    far.camera = with_depths(camera, bounds_of(scene));
    const std::int64_t count = differing(render(far, size), straight);
    EXPECT_LE(count, last);
    last = count;
  }
  EXPECT_LE(last, 3) << "near-ties at the borders";
}

TEST(Projections, FacingIsThatOfTheRays) {
  Random random(test::seed());
  int fronts = 0, backs = 0, against_the_view = 0;
  for (int i = 0; i < 3000; ++i) {
    SceneCamera camera;
    camera.rays = ParallelRays{4, {random.uniform(-2, 2), random.uniform(-2, 2)}, 2, 0, 10};
    const auto place = [&] {
      return dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    const std::array<dvec3, 3> corners{place(), place(), place()};
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double towards = glm::dot(normal, towards_viewer(camera.frame, camera.rays->slant));
    if (std::abs(towards) < 1e-9) continue;
    Model<WorldPoint> world;
    Piece piece;
    for (int k = 0; k < 3; ++k) {
      world.add({0, k}, {corners[static_cast<std::size_t>(k)]});
      piece.corners[static_cast<std::size_t>(k)].vertex = k;
    }
    const auto side = facing(to_clip(camera, 1.5, world), piece);
    EXPECT_EQ(side == back_face_culling::Facing::front, towards > 0);
    (towards > 0 ? fronts : backs) += 1;
    against_the_view += towards > 0 && glm::dot(normal, -camera.frame.forward) < 0;
  }
  EXPECT_GT(std::min({fronts, backs, against_the_view}), 100) << "the slant decides for some";
}

TEST(Projections, TheLetterReadsAsF) {
  // Its upper right corner is there and its lower right one is not; the stem is on the left
  for (const Projection3d projection : {Projection3d::orthographic, Projection3d::oblique}) {
    View view = parallel_view(projection);
    view.eye = dvec3{0.5, 0.7, 9};
    view.target = dvec3{0.5, 0.7, 0};
    view.foreshortening = 0.1;
    const Scene scene = seen_by(scene_of(shipped("letter_f.obj"), 1), view, {60, 60});
    const auto covered = [](const PixelLight& p) { return p.share > 0; };
    const LightPicture picture = antialiased(scene, {60, 60});
    const auto count = [&](int left, int top) {
      int sum = 0;
      for (int y = top; y < top + 30; ++y)
        for (int x = left; x < left + 30; ++x) sum += covered(picture[{x, y}]);
      return sum;
    };
    const int upper_right = count(30, 0), lower_right = count(30, 30), lower_left = count(0, 30);
    EXPECT_GT(lower_left, lower_right);
    EXPECT_GT(upper_right, 2 * lower_right);
  }
}

TEST(Projections, ParallelPicturesFrameTheirModel) {
  for (const char* name : {"letter_f.obj", "spot.obj"}) {
    for (const Projection3d projection : {Projection3d::orthographic, Projection3d::oblique}) {
      for (const Size size : {Size{120, 60}, Size{60, 120}}) {
        const Scene scene = seen_by(scene_of(shipped(name), 1), parallel_view(projection), size);
        const LightPicture picture = antialiased(scene, size);
        ivec2 lower{1 << 20}, upper{-1};
        for (int y = 0; y < size.height; ++y) {
          for (int x = 0; x < size.width; ++x) {
            if (!(picture[{x, y}].share > 0)) continue;
            lower = glm::min(lower, ivec2{x, y});
            upper = glm::max(upper, ivec2{x, y});
          }
        }
        // Margins of a twentieth of the model, in the direction that fills the picture
        const ivec2 margin = glm::min(lower, ivec2{size.width - 1, size.height - 1} - upper);
        EXPECT_GE(std::min(margin.x * 22 / size.width, margin.y * 22 / size.height), 0) << name;
        const bool fills = margin.x <= size.width / 22 + 2 || margin.y <= size.height / 22 + 2;
        EXPECT_TRUE(fills) << name << " " << margin.x << " " << margin.y;
      }
    }
  }
}

// --- Hidden surfaces

/// Triangles apart from each other: each within a ball of its own. Without light but their own.
Scene apart(Random& random, int count) {
  Scene scene;
  scene.background = LinearRgb{0};
  scene.ambient = LinearRgb{0};
  for (int i = 0; i < count; ++i) {
    const dvec3 middle = 2.0 * dvec3{i % 4, i / 4 % 4, i / 16} - dvec3{3, 3, 14};
    std::string text;
    for (int k = 0; k < 3; ++k) {
      const dvec3 way{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      const dvec3 at = middle + 0.95 * unit_vector(way);
      text += fmt::format("v {} {} {}\n", at.x, at.y, at.z);
    }
    scene.objects.push_back(object_of(model(text + "f 1 2 3\n")));
    const auto part = static_cast<float>(i + 1) / static_cast<float>(count + 1);
    test::change_materials(scene.objects.back(), [&](Material& m) {
      m.emission = {part, 1 - part, static_cast<float>(i % 3) / 2};
    });
  }
  scene.camera.lens = {radians_from_degrees(50), 1, 100};
  return scene;
}

/// How far a place lies from the nearest edge of any triangle in the picture, snapped.
double distance_to_edges(const Triangles& triangles, Size size, dvec2 place) {
  double nearest = 1e9;
  for (const Triangle& t : triangles) {
    const auto corners = snapped(in_picture(t, size));
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec2 a = dvec2(corners[i].at) / 256.0, b = dvec2(corners[(i + 1) % 3].at) / 256.0;
      const dvec2 way = b - a;
      const double length = glm::dot(way, way);
      const double along = length > 0 ? std::clamp(glm::dot(place - a, way) / length, 0.0, 1.0) : 0;
      nearest = std::min(nearest, glm::length(place - a - along * way));
    }
  }
  return nearest;
}

/// So many triangles more by cuts.
std::int64_t cuts_where_pictures_are_alike(HiddenSurfaces method) {
  Random random(test::seed());
  const Size size{120, 90};
  std::int64_t ties = 0, pixels = 0, overlaps = 0, cuts = 0;
  for (int round = 0; round < 24; ++round) {
    Scene scene = apart(random, 96);
    scene.camera.frame =
        viewing::look_at(dvec3{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(0, 3)},
                         dvec3{0, 0, -11}, {0, 1, 0});
    if (round % 3 == 2)
      scene.camera.rays = ParallelRays{9, {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)}, 11, 0, 60};
    const Image z_buffer = render(scene, size);
    scene.hidden_surfaces = method;
    const Image tree = render(scene, size);
    ties += differing(tree, z_buffer);
    for (const Rgba8 pixel : z_buffer.cells()) pixels += pixel != Rgba8{0, 0, 0, 255};
    // The hard path: parts, and pixels that several triangles cover
    const auto world = to_world(scene, input(scene));
    const auto facing = cull(scene, to_clip(scene.camera, 4.0 / 3, world));
    Triangles parts = clip(world, facing, size);
    const std::size_t whole = parts.size();
    std::int64_t covered = 0;
    rasterize(parts, size, [&](const Fragment&) { ++covered; });
    arrange(scene, facing, size, parts);
    cuts += static_cast<std::int64_t>(parts.size() - whole);
    overlaps += covered;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (tree[ivec2(x, y)] == z_buffer[ivec2(x, y)]) continue;
        const double off = distance_to_edges(parts, size, dvec2(x, y) + 0.5);
        EXPECT_LT(off, 1.0 / 256) << "round " << round << ", pixel " << x << ", " << y;
      }
    }
  }
  fmt::print("{} of {} covered pixels differ; {} fragments, {} more triangles by cuts\n", ties, pixels,
             overlaps, cuts);
  EXPECT_GT(overlaps, pixels + pixels / 20);
  EXPECT_LE(ties, pixels / 500) << "centres within 1/256 pixel of a cut";
  return cuts;
}

TEST(HiddenSurfaces, TheTreeShowsWhatTheZBufferShows) {
  EXPECT_GT(cuts_where_pictures_are_alike(HiddenSurfaces::bsp_tree), 500);
}

TEST(HiddenSurfaces, ThePainterShowsWhatTheZBufferShows) {
  cuts_where_pictures_are_alike(HiddenSurfaces::painter);
}

/// Three bars, each before the next: no order of whole triangles is right.
Scene cycle() {
  Scene scene;
  scene.background = LinearRgb{0};
  scene.ambient = LinearRgb{0};
  constexpr std::array<LinearRgb, 3> colours{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < 3; ++i) {
    std::string text;
    const double turn = 2.0943951023931953 * static_cast<double>(i);
    for (const dvec3 p : {dvec3{-2, 0.6, -6.5}, dvec3{2, 0.6, -5.5}, dvec3{2, 1.1, -5.5}}) {
      const double s = sin(turn), c = cos(turn);
      text += fmt::format("v {} {} {}\n", c * p.x - s * p.y, s * p.x + c * p.y, p.z);
    }
    scene.objects.push_back(object_of(model(text + "f 1 2 3\n")));
    test::change_materials(scene.objects.back(), [&](Material& m) { m.emission = colours[i]; });
  }
  scene.camera.lens = {radians_from_degrees(40), 1, 100};
  return scene;
}

TEST(HiddenSurfaces, FarthestVerticesGoWrongWhereTheOthersDoNot) {
  const Size size{160, 160};
  Scene scene = cycle();
  const Image z_buffer = render(scene, size);
  for (const HiddenSurfaces method : {HiddenSurfaces::bsp_tree, HiddenSurfaces::painter}) {
    scene.hidden_surfaces = method;
    EXPECT_LE(differing(render(scene, size), z_buffer), 4);
  }
  scene.hidden_surfaces = HiddenSurfaces::farthest_vertex;
  EXPECT_GT(differing(render(scene, size), z_buffer), 20) << "depth sort of a cycle";
}

TEST(HiddenSurfaces, WhatIsDrawnLastIsNotCalledTheNearest) {
  Scene scene = cycle();
  int last = 0, wrong = 0;
  const Size size{32, 32};
  const Image z_buffer = render(scene, size);
  scene.hidden_surfaces = HiddenSurfaces::farthest_vertex;
  const Image sorted = render(scene, size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::string text = why_text("cycle", scene, size, why(scene, size, {x, y}));
      EXPECT_EQ(text.find("nearest"), text.npos);
      last += text.find("2 triangles cover its centre; the one drawn last is seen.") != text.npos;
      wrong += z_buffer[ivec2(x, y)] != sorted[ivec2(x, y)];
    }
  }
  EXPECT_GT(last, 0);
  EXPECT_GT(wrong, 0);
}

/// Triangles that cross one another everywhere; the eye lies at (0, 0, 0).
std::vector<WorldPolygon> crossing_triangles(Random& random) {
  const auto corner = [&] {
    return dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(4, 6)};
  };
  std::vector<WorldPolygon> polygons;
  for (std::size_t i = 0; i < 30; ++i) polygons.push_back({{corner(), corner(), corner()}, i});
  return polygons;
}

/// Up to a limit that is nearly reached when they begin: whole models take seconds to reach it.
TEST(HiddenSurfaces, OrdersThatWouldTakeTooLongNameTheWayOut) {
  Random random(test::seed());
  const auto polygons = crossing_triangles(random);
  const auto expect_limit = [&](std::string_view method, const auto& ordered_from) {
    EXPECT_NO_THROW(ordered_from(ArrangingLimit{method, 30})) << method;
    try {
      ordered_from(ArrangingLimit{method, 30, ArrangingLimit::most - 500});
      FAIL() << method;
    } catch (const UsageError& error) {
      EXPECT_EQ(
          error.what(),
          fmt::format("--hidden-surfaces {}: expected triangles whose order takes at most 20000000 tests, "
                      "found 30 that take more; z_buffer needs no order, and draws the same",
                      method));
    }
  };
  expect_limit("bsp_tree", [&](const ArrangingLimit& limit) {
    bsp_tree::build(polygons, bsp_tree::ExactSide{}, TreeLimit{limit});
  });
  const painter::View<double> view = painter::view_along({0, 0, 0, 1}, dvec3{0, 0, 1}, dvec3{0, 1, 0});
  expect_limit("painter", [&](const ArrangingLimit& limit) {
    painter::newell(polygons, view, [](const auto&) {}, PainterLimit{limit});
  });
  // By planes alone, where rounding has closed a cycle
  expect_limit("painter", [&](const ArrangingLimit& limit) {
    auto list = painter::pieces_of(polygons, view);
    painter::draw_rest(list, view, LimitedDrawing{[](const auto&) {}, limit}, Unobserved{});
  });
}

TEST(HiddenSurfaces, ThePainterIsRightOnAConvexBody) {
  // Backs removed, nothing overlaps in the picture
  Scene scene = scene_of(model(cube), 1.5);
  scene.shading = Shading::flat;
  const Image z_buffer = render(scene, {90, 60});
  scene.hidden_surfaces = HiddenSurfaces::painter;
  EXPECT_EQ(differing(render(scene, {90, 60}), z_buffer), 0);
}

// --- Culling and wireframe

TEST(CullingChoice, DecidesOnlyWhereBacksAreSeen) {
  Scene body = scene_of(model(cube), 1.5);
  const Image closed = render(body, {60, 40});
  for (const Culling all : {Culling::none, Culling::back}) {
    body.culling = all;
    EXPECT_EQ(render(body, {60, 40}), closed) << "backs of a closed body are hidden anyway";
  }
  // A square that turns its back
  Scene square = scene_of(model("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 4 3 2 1\n"), 1.5);
  square.camera = framed(bounds_of(square), 1.5, {0, 0, 1});
  const auto covered = [&](Culling culling) {
    square.culling = culling;
    std::int64_t count = 0;
    const LightPicture picture = antialiased(square, {60, 40});
    for (const PixelLight& p : picture.cells()) count += p.share > 0;
    return count;
  };
  EXPECT_GT(covered(Culling::none), 500);
  EXPECT_EQ(covered(Culling::closed_bodies), covered(Culling::none)) << "it encloses no body";
  EXPECT_EQ(covered(Culling::back), 0);
}

TEST(Wireframe, HasEachEdgeOfAFaceOnce) {
  Scene scene = scene_of(model(cube), 1.5);
  scene.camera.frame = viewing::look_at(dvec3{3, 4, 5}, dvec3{0.5}, {0, 1, 0});
  const auto edges = [&](Culling culling) {
    scene.culling = culling;
    const auto seen = to_clip(scene.camera, 1.5, to_world(scene, input(scene)));
    return face_edges(cull(scene, seen).pieces).size();
  };
  EXPECT_EQ(edges(Culling::none), 12u) << "without diagonals";
  EXPECT_EQ(edges(Culling::closed_bodies), 9u) << "those of the three faces that are seen";
}

TEST(Wireframe, LinesAreOnePixelWideAndStandOnTheGround) {
  // A square whose edges run through the middles of pixels
  Scene scene = scene_of(model("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"), 1);
  scene.camera.frame = {.eye = {0, 0, 5}};
  scene.camera.rays = ParallelRays{41.0 / 15, {}, 5, 1, 9};
  scene.shading = Shading::wireframe;
  for (const Antialiasing method : {Antialiasing::none, Antialiasing::area_sampling}) {
    scene.antialiasing = method;
    const LightPicture picture = antialiased(scene, {41, 41});
    std::int64_t full = 0, others = 0;
    for (const PixelLight& p : picture.cells()) (p.share > 0.99 ? full : others) += p.share > 0.01;
    EXPECT_EQ(full, 4 * 30) << name_of(method);
    EXPECT_EQ(others, 0) << name_of(method);
  }
  scene.background = LinearRgb{0};
  EXPECT_EQ(render(scene, {41, 41})[ivec2(20, 5)], (Rgba8{255, 255, 255, 255})) << "white on black";
}

// --- All of it at once

/// A cube with a texture, and half of a square that pierces it.
Scene small_scene() {
  std::string text = cube;
  text += "vt 0 0\nvt 1 0\nvt 1 1\n";
  Scene scene = scene_of(model(text), 4.0 / 3);
  Object sheet = object_of(
      model("v 0.5 -0.5 0.5\nv 1.5 0.5 0.5\nv 0.5 1.5 0.4\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n"));
  test::change_materials(sheet, [](Material& m) {
    m.diffuse_map.texels = Image(2, 2, Rgba8{255, 255, 255, 255});
    m.diffuse_map.texels[{0, 0}] = {200, 0, 0, 255};
  });
  scene.objects.push_back(std::move(sheet));
  scene.samples = 4;
  return scene;
}

TEST(Choices, EveryCombinationDraws) {
  const Size size{12, 9};
  const Scene plain = small_scene();
  std::int64_t drawn = 0;
  for (int projection = 0; projection < 3; ++projection) {
    const View view = parallel_view(static_cast<Projection3d>(projection));
    const Scene seen = seen_by(plain, view, size);
    // Under a sanitizer every fifth: each choice with each projection still
    for (int way = 0; way < 3 * 3 * 9; way += test::sanitized ? 5 : 1) {
      Scene scene = seen;
      scene.hidden_surfaces = static_cast<HiddenSurfaces>(way % 3);
      scene.culling = static_cast<Culling>(way / 3 % 3);
      scene.antialiasing = static_cast<Antialiasing>(way / 9);
      std::vector<double> shares;
      for (int look = 0; look < 4 * 3; ++look) {
        scene.shading = static_cast<Shading>(look / 3);
        scene.filter = static_cast<TextureFilter>(look % 3);
        const LightPicture picture = antialiased(scene, size);
        ++drawn;
        const std::string which = fmt::format("{} {} {} {} {}", projection, way % 3, way / 3 % 3, look,
                                              name_of(scene.antialiasing));
        std::vector<double> covered;
        for (const PixelLight& p : picture.cells()) {
          covered.push_back(p.share);
          EXPECT_TRUE(0 <= p.share && p.share <= 1 + 1e-12 && std::isfinite(p.sum.x + p.sum.y + p.sum.z))
              << which;
          if (p.share == 0) EXPECT_EQ(p.sum, dvec3{0}) << which;
        }
        // Nothing in the corners, something in the middle; what is covered is no matter of light
        EXPECT_EQ(covered.front(), 0) << which;
        EXPECT_EQ(covered.back(), 0) << which;
        EXPECT_GT(*std::ranges::max_element(covered), 0.2) << which;
        if (scene.shading == Shading::wireframe) continue;
        EXPECT_GT(covered[12 * 4 + 6], 0.9) << which;
        if (shares.empty()) shares = covered;
        EXPECT_EQ(covered, shares) << which;
      }
    }
  }
  EXPECT_EQ(drawn, 3 * (test::sanitized ? 17 : 3 * 3 * 9) * 4 * 3);
}

}  // namespace
}  // namespace gradus::pipeline::choices_test
