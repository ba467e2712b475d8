// The functions of the report "A complete 3D graphics pipeline", by their names there: what takes their place
// here gives the goldens of docs/topics/pipeline_report.md, and the right value where the report errs.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "core/colour.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "pipeline.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewport/viewport.hpp"
#include "shading/polygon_shading/mixed_along.hpp"
#include "shading/polygon_shading/polygon_shading.hpp"
#include "shading/texture_mapping/texture_mapping_notes.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::report_test {
namespace {

using Rows = std::array<std::array<double, 4>, 4>;

void expect_rows(const glm::dmat4& found, const Rows& expected, double tolerance) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      EXPECT_NEAR(found[column][row],
                  expected[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], tolerance)
          << "row " << row << " column " << column;
    }
  }
}

constexpr double quarter = std::numbers::pi / 2;

TEST(Report, TranslateRotateCompose) {
  using namespace affine_3d;
  // G000-01
  expect_rows(translate(dvec3{1, 2, 3}), {{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}, {0, 0, 0, 1}}}, 0);
  // G000-02
  expect_rows(rotate({0, 0, 1}, quarter, {1, 0, 0}),
              {{{0, -1, 0, 1}, {1, 0, 0, -1}, {0, 0, 1, 0}, {0, 0, 0, 1}}}, 1e-15);
  // G000-03, G000-04: the right factor acts first
  const glm::dmat4 there = translate(dvec3{2, 3, 5}), turn = rotate({0, 0, 1}, quarter);
  expect_rows(compose(there, turn), {{{0, -1, 0, 2}, {1, 0, 0, 3}, {0, 0, 1, 5}, {0, 0, 0, 1}}}, 1e-15);
  expect_rows(compose(turn, there), {{{0, -1, 0, -3}, {1, 0, 0, 2}, {0, 0, 1, 5}, {0, 0, 0, 1}}}, 1e-15);
}

TEST(Report, World2view) {
  // G000-05: R (p - c0), the rows of R being the camera's axes
  const Frame<double> camera{{1, 1, 1}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(viewing::to_view(camera, dvec3{1, 4, 7}), (dvec3{-3, 0, 6}));
  EXPECT_EQ(viewing::to_view(camera, dvec3{2, 5, 8}), (dvec3{-4, 1, 7}));
  EXPECT_EQ(viewing::to_view(camera, dvec3{3, 6, 9}), (dvec3{-5, 2, 8}));
}

TEST(Report, LookatPutsTheTargetOnTheAxis) {
  // G000-07, G000-08, G000-09: not at (-2.937, -5.054, -1.957), as printed
  const Frame<double> frame = viewing::look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 1, 0});
  EXPECT_LT(glm::length(frame.right - dvec3{5, 0, -2} / std::sqrt(29.0)), 1e-15);
  EXPECT_LT(glm::length(frame.up - dvec3{-6, 29, -15} / std::sqrt(1102.0)), 1e-15);
  EXPECT_LT(glm::length(frame.forward - dvec3{-2, -3, -5} / std::sqrt(38.0)), 1e-15);
  EXPECT_LT(glm::length(viewing::to_view(frame, dvec3{0}) - dvec3{0, 0, 6.164414002968976}), 1e-12);
  EXPECT_NEAR(glm::dot(frame.right, glm::cross(frame.up, frame.forward)), -1, 1e-12);
}

TEST(Report, PerspectiveProject) {
  // G000-10: three points by their depths 7, 8, 9
  const dvec3 points[]{{1, 4, 7}, {2, 5, 8}, {3, 6, 9}};
  for (const dvec3 p : points) {
    const auto image = perspective::project(1.0, p);
    ASSERT_TRUE(image);
    EXPECT_NEAR(image->x, p.x / p.z, 1e-15);
    EXPECT_NEAR(image->y, p.y / p.z, 1e-15);
  }
  // E000-07: the report mirrors what lies behind the camera
  EXPECT_FALSE(perspective::project(1.0, dvec3{1, 1, -1}));
}

TEST(Report, Rasterize) {
  // G000-11, G000-12: row 0 is at the top; what lies outside is told, not moved to the border
  const auto map = viewport::stretched(Rectangle<double>{{-1, -0.75}, {1, 0.75}}, {640, 480});
  EXPECT_EQ(viewport::rasterize(map, dvec2{0, 0}), (ivec2{320, 240}));
  EXPECT_EQ(viewport::rasterize(map, dvec2{0.5, 0.3}), (ivec2{480, 144}));
  EXPECT_EQ(viewport::rasterize(map, dvec2{-0.5, -0.2}), (ivec2{160, 304}));
  for (const dvec2 outside : {dvec2{5, 0}, dvec2{2, 1}, dvec2{1, 0.75}})
    EXPECT_EQ(viewport::rasterize(map, outside), std::nullopt);
}

TEST(Report, VectorInterp) {
  using namespace polygon_shading;
  // G000-15
  EXPECT_EQ(mixed_along(Along::x, dvec2{0, 0}, dvec2{10, 4}, dvec2{0, 0}, dvec2{1, 2}, 2.5),
            (dvec2{0.25, 0.5}));
  EXPECT_EQ(mixed_along(Along::y, dvec2{0, 4}, dvec2{10, 4}, dvec2{0, 0}, dvec2{1, 2}, 4.0), (dvec2{0, 0}))
      << "level: the first value, no division by zero";
}

// --- t_shading
// -----------------------------------------------------------------------------------------------

using Corner2 = polygon_shading::Corner<double, dvec3>;

TEST(Report, TShadingEndsOfEachRowLieOnTheEdges) {
  using namespace polygon_shading;
  const std::array<Corner2, 3> triangle{
      {{{1.5, 0.25}, {1, 0, 0}}, {{14.25, 4}, {0, 1, 0}}, {{5, 12.75}, {0, 0, 1}}}};
  int rows_told = 0, pixels = 0;
  Recorder<RowBegun<double, dvec3>> seen;
  gouraud(
      std::span<const Corner2>(triangle), Window{{0, 0}, {20, 20}}, [&](ivec2, dvec3) { ++pixels; },
      only<RowBegun<double, dvec3>>(seen));
  for (const auto& row : all<RowBegun<double, dvec3>>(seen)) {
    for (const bool is_left : {true, false}) {
      const End<double>& end = is_left ? row.left : row.right;
      // On the line through both corners of its edge, and between them
      const dvec2 a = triangle[end.lower].at, b = triangle[end.upper].at, at{end.x, row.row + 0.5};
      const dvec2 edge = b - a, way = at - a;
      EXPECT_NEAR(edge.x * way.y - edge.y * way.x, 0, 1e-12);
      EXPECT_TRUE(a.y <= at.y && at.y <= b.y);
      // Colours along it: the report's vector_interp along y
      const dvec3 colour =
          mixed_along(Along::y, a, b, triangle[end.lower].value, triangle[end.upper].value, at.y);
      EXPECT_LT(glm::length(colour - (is_left ? row.at_left : row.at_right)), 1e-14);
    }
    EXPECT_LE(row.left.x, row.right.x);
    ++rows_told;
  }
  EXPECT_EQ(rows_told, 13) << "rows whose centres lie between 0.25 and 12.75";
  EXPECT_GT(pixels, 60);
}

TEST(Report, TShadingKeepsTheCornersColours) {
  using namespace polygon_shading;
  // Corners at the centres of pixels: what is seen there is their own colour
  const std::array<Corner2, 3> triangle{
      {{{0.5, 0.5}, {1, 0, 0}}, {{8.5, 0.5}, {0, 1, 0}}, {{0.5, 8.5}, {0, 0, 1}}}};
  std::vector<std::pair<ivec2, dvec3>> plotted;
  gouraud(std::span<const Corner2>(triangle), Window{{0, 0}, {9, 9}},
          [&](ivec2 pixel, dvec3 colour) { plotted.emplace_back(pixel, colour); });
  for (const auto& [pixel, colour] : plotted) {
    const dvec3 exact{1 - (pixel.x + pixel.y) / 8.0, pixel.x / 8.0, pixel.y / 8.0};
    EXPECT_LT(glm::length(colour - exact), 1e-15) << "linear between";
  }
  EXPECT_EQ(plotted.front().first, (ivec2{0, 0}));
  EXPECT_EQ(plotted.front().second, (dvec3{1, 0, 0}));
  EXPECT_EQ(plotted.size(), 36u) << "8 + 7 + … + 1: right ends belong to the neighbour";
}

TEST(Report, TShadingIsNotPerspectiveCorrect) {
  // G000-16: an edge from z = 1 to z = 3, u from 0 to 1; in the middle of its picture
  const double u =
      polygon_shading::mixed_along(polygon_shading::Along::x, dvec2{0, 0}, dvec2{1, 0}, 0.0, 1.0, 0.5);
  const double over_z =
      polygon_shading::mixed_along(polygon_shading::Along::x, dvec2{0, 0}, dvec2{1, 0}, 1.0, 1.0 / 3, 0.5);
  const double u_over_z =
      polygon_shading::mixed_along(polygon_shading::Along::x, dvec2{0, 0}, dvec2{1, 0}, 0.0, 1.0 / 3, 0.5);
  EXPECT_EQ(u, 0.5) << "as the report mixes";
  EXPECT_NEAR(u_over_z / over_z, 0.25, 1e-15) << "as it calls it";
}

// --- render_object
// -------------------------------------------------------------------------------------------

/// A triangle at depth 2 with a texture of four colours, seen along -z with an angle of 90 degrees.
Scene one_triangle() {
  Image texels(2, 2);
  texels[{0, 0}] = {255, 0, 0};
  texels[{1, 0}] = {0, 255, 0};
  texels[{0, 1}] = {0, 0, 255};
  texels[{1, 1}] = {255, 255, 255};
  Mesh mesh;
  mesh.positions = {{-1, -1, -2}, {1, -1, -2}, {-1, 1, -2}};
  mesh.textures = {{0, 0}, {1, 0}, {0, 1}};
  Material material;
  material.ambient = LinearRgb{1};
  material.diffuse_map.texels = texels;
  mesh.materials.push_back(material);
  add_face(mesh, std::array{gradus::Corner{0, 0}, gradus::Corner{1, 1}, gradus::Corner{2, 2}}, 1);
  Scene scene;
  scene.objects.push_back(object_of(std::move(mesh)));
  scene.camera.lens = {quarter, 1, 10};
  scene.ambient = LinearRgb{1};
  scene.background = LinearRgb{0};
  scene.filter = TextureFilter::nearest;
  return scene;
}

TEST(Report, RenderObjectDrawsWhatIsPredictedByHand) {
  // x/z and y/z reach from -1/2 to 1/2: columns and rows 2 to 6 of 8. The right angle is at the lower left;
  // on the long side lie the centres (2.5, 2.5) … (5.5, 5.5), which a right edge leaves to its neighbour
  const Image image = render(one_triangle(), {8, 8});
  std::string seen;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const Rgba8 p = image[{x, y}];
      seen += p.r && p.b ? 'w' : p.r ? 'r' : p.g ? 'g' : p.b ? 'b' : '.';
    }
    seen += '\n';
  }
  EXPECT_EQ(seen,
            "........\n"
            "........\n"
            "........\n"
            "..r.....\n"
            "..bb....\n"
            "..bbw...\n"
            "........\n"
            "........\n");
}

TEST(Report, RenderObjectMakes512By512) {
  const Image image = render(one_triangle(), {512, 512});
  EXPECT_EQ((std::array{image.width(), image.height()}), (std::array{512, 512}));
  // A quarter of the side squared, halved: 256 * 256 / 2, less half the pixels of the long side
  const auto lit = [](const Rgba8& p) { return p.r || p.g || p.b; };
  EXPECT_EQ(std::ranges::count_if(image.cells(), lit), 256 * 255 / 2);
}

TEST(Report, RenderObjectCarriesTheDepthOfEachVertex) {
  constexpr std::uint64_t seed = 20261125;
  SCOPED_TRACE(seed);
  Random random(seed);
  const auto place = [&random] {
    return dvec3{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
  };
  int vertices = 0, kept = 0;
  for (int i = 0; i < 200; ++i) {
    Scene scene = one_triangle();
    Mesh mesh = *scene.objects[0].mesh;
    for (dvec3& position : mesh.positions) position = place();
    scene.objects[0] = object_of(std::move(mesh));
    scene.camera.frame = viewing::look_at(place() + dvec3{0, 0, 12}, place(), dvec3{0, 1, 0});
    const Frame<double>& frame = scene.camera.frame;
    using Long = glm::vec<3, long double>;
    const auto depth = [&frame](dvec3 p) { return glm::dot(Long(frame.forward), Long(p) - Long(frame.eye)); };
    const auto projected = [&](const Projected& step) {
      EXPECT_EQ(step.clip.at.w, step.view.z);
      EXPECT_NEAR(step.view.z, static_cast<double>(depth(step.world.at)), 1e-13);
      ++vertices;
    };
    const auto model = to_clip(scene.camera, 1, to_world(scene, input(scene)), only<Projected>(projected));
    for (const Triangle& t : clip(to_world(scene, input(scene)), model, {64, 64})) {
      for (const TriangleCorner& corner : t.corners) {
        EXPECT_NEAR(1 / corner.over_w, static_cast<double>(depth(corner.world.at)), 1e-12);
        ++kept;
      }
    }
  }
  EXPECT_EQ(vertices, 600);
  EXPECT_GT(kept, 400);
}

}  // namespace
}  // namespace gradus::pipeline::report_test
