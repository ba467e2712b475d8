// A poster before a wall, and walls that cross, by the A-buffer: against rays through 64 x 64 places of every
// pixel, with depths along them, that share no step with the chain.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "pipeline.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/models/obj.hpp"
#include "support/change_mesh.hpp"
#include "why/why.hpp"
#include "why/why_text.hpp"

namespace gradus::pipeline::near_sheets_test {
namespace {

constexpr Size size{60, 45};
const LinearRgb green{0, 1, 0}, red{1, 0, 0};

/// A rectangle that glows.
struct Sheet {
  dvec3 corner, across, along;
  LinearRgb light;
};

const dvec3 eye{3, 1, 4};
constexpr double half_height = 0.4;  ///< of the picture, at distance 1

Scene scene_of(const std::array<Sheet, 2>& sheets) {
  Scene scene;
  scene.ambient = LinearRgb{0};
  scene.antialiasing = Antialiasing::a_buffer;
  scene.shading = Shading::flat;
  scene.culling = Culling::none;
  scene.camera.frame = viewing::look_at(eye, dvec3{0}, dvec3{0, 1, 0});
  scene.camera.lens = {2 * std::atan(half_height), 1, 100};
  for (const Sheet& sheet : sheets) {
    std::string text;
    for (const dvec3 p : {sheet.corner, sheet.corner + sheet.across,
                          sheet.corner + sheet.across + sheet.along, sheet.corner + sheet.along})
      text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    const auto none = [](const std::string&) { return std::nullopt; };
    scene.objects.push_back(object_of(parse_obj(text + "f 1 2 3 4\n", "m.obj", none).mesh));
    test::change_materials(scene.objects.back(), [&](Material& m) { m.emission = sheet.light; });
  }
  return scene;
}

/// How far along a ray from the eye a sheet is met. Its sides are at right angles.
std::optional<double> met(const Sheet& sheet, dvec3 ray) {
  const dvec3 normal = glm::cross(sheet.across, sheet.along);
  const double t = glm::dot(sheet.corner - eye, normal) / glm::dot(ray, normal);
  const dvec3 from_corner = eye + t * ray - sheet.corner;
  const double u = glm::dot(from_corner, sheet.across) / glm::dot(sheet.across, sheet.across);
  const double v = glm::dot(from_corner, sheet.along) / glm::dot(sheet.along, sheet.along);
  if (t <= 0 || std::min(u, v) < 0 || std::max(u, v) > 1) return std::nullopt;
  return t;
}

/// The share of a pixel in which each sheet is nearest.
std::array<double, 2> shares_by_rays(const std::array<Sheet, 2>& sheets, ivec2 pixel) {
  constexpr int side = 64;
  const dvec3 forward = glm::normalize(-eye), right = glm::normalize(glm::cross(forward, dvec3{0, 1, 0})),
              up = glm::cross(right, forward);
  std::array<double, 2> shares{};
  for (int i = 0; i < side * side; ++i) {
    const dvec2 place = dvec2(pixel) + (dvec2(i % side, i / side) + 0.5) / double{side};
    // From -1 to 1 in the height
    const dvec2 at = (2.0 * place - dvec2(size.width, size.height)) / double{size.height};
    const dvec3 ray = forward + half_height * (at.x * right - at.y * up);
    const auto first = met(sheets[0], ray), second = met(sheets[1], ray);
    if (first || second) shares[!first || (second && *second < *first)] += 1.0 / (side * side);
  }
  return shares;
}

constexpr dvec3 corner_of_wall{-2, -2, 0};
const Sheet wall{corner_of_wall, {4, 0, 0}, {0, 4, 0}, green};

TEST(NearSheets, AWallBehindAnOpaquePosterIsNotSeen) {
  const std::array<Sheet, 2> sheets{wall, Sheet{{-1, -1, 0.005}, {2, 0, 0}, {0, 2, 0}, red}};
  const Scene scene = scene_of(sheets);
  const LightPicture chain = antialiased(scene, size);
  int inside = 0;
  double worst = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto [green_share, red_share] = shares_by_rays(sheets, {x, y});
      const PixelLight& found = chain[{x, y}];
      worst = std::max({worst, std::abs(found.sum.y - green_share), std::abs(found.sum.x - red_share)});
      if (red_share < 1) continue;
      ++inside;
      // All rays meet the poster first
      EXPECT_EQ(found.sum, (dvec3{1, 0, 0})) << x << " " << y;
      EXPECT_EQ(found.share, 1);
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_LT(worst, 0.13) << "a mask counts in 32nds";
}

TEST(NearSheets, WallsThatCrossShareByTheirLine) {
  // The second leans through the first along x = 0.3, y of any size
  const std::array<Sheet, 2> sheets{wall, Sheet{{-0.9, -1, 0.4}, {2.4, 0, -0.8}, {0, 2, 0}, red}};
  const LightPicture found = antialiased(scene_of(sheets), size);
  int mixed = 0;
  double squares = 0, worst = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto [green_share, red_share] = shares_by_rays(sheets, {x, y});
      const double off = std::abs((found[{x, y}].sum.x) - red_share);
      worst = std::max(worst, off);
      if (red_share == 0 || green_share == 0) continue;
      ++mixed;
      squares += off * off;
    }
  }
  EXPECT_GT(mixed, 50);
  EXPECT_LT(std::sqrt(squares / mixed), 0.04);
  EXPECT_LT(worst, 0.13);
}

TEST(NearSheets, WhyTellsWhatThePictureShows) {
  const std::array<Sheet, 2> sheets{wall, Sheet{{-1, -1, 0.005}, {2, 0, 0}, {0, 2, 0}, red}};
  const Scene scene = scene_of(sheets);
  const ivec2 middle{size.width / 2, size.height / 2};
  const PixelStory story = why(scene, size, middle);
  EXPECT_EQ(story.layers.size(), 1u);
  EXPECT_EQ(story.picture, story.written.colour);
  EXPECT_EQ(story.picture, (Rgba8{255, 0, 0, 255}));
  const std::string text = why_text("scene", scene, size, story);
  EXPECT_NE(text.find("hidden at the centre by what lets nothing through"), std::string::npos) << text;
  EXPECT_NE(text.find("the picture has #ff0000"), std::string::npos) << text;
}

}  // namespace
}  // namespace gradus::pipeline::near_sheets_test
