// All methods for hidden surfaces show the same picture: the z-buffer, the z-buffer by rows, the BSP tree's
// order painted from back to front, and a ray through the centre of each pixel, on scenes with cycles and
// piercing faces.

#include "support/hidden_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::test {
namespace {

/// No edge and no line where faces meet is seen so close to a pixel that is compared.
constexpr long double margin = 1;

/// What was compared, of which scenes.
struct Count {
  std::int64_t scenes = 0, cuts = 0, painter_cuts = 0, cycles = 0, piercings = 0;
  std::int64_t covered = 0, compared = 0;  ///< pixels
  std::int64_t on_seams = 0, open = 0;     ///< of these, where parts meet, and where a seam is open
};

/// The pixels on which a picture is wrong, of those that are sure.
std::vector<ivec2> wrong(const Picture& picture, const Raster<Verdict>& right) {
  std::vector<ivec2> found;
  for (int y = 0; y < right.height(); ++y) {
    for (int x = 0; x < right.width(); ++x) {
      const ivec2 pixel{x, y};
      if (right[pixel].sure && picture[pixel] != right[pixel].face) found.push_back(pixel);
    }
  }
  return found;
}

/// A picture painted part by part is right but where two parts meet and snapping has opened the seam.
void expect_painted(const Polygons& order, const Camera& camera, const Raster<Verdict>& right,
                    const std::string& which, Count& count) {
  const auto seam = seams(order, camera);
  const auto off = wrong(painted(order, camera), right);
  EXPECT_TRUE(std::ranges::all_of(off, [&](ivec2 pixel) { return seam[pixel] != 0; })) << which;
  count.open += std::ssize(off);
  for (std::size_t i = 0; i < right.cells().size(); ++i) {
    const Verdict& verdict = right.cells()[i];
    count.on_seams += seam.cells()[i] != 0 && verdict.sure && verdict.face != nobody;
  }
}

void count_pixels(const Raster<Verdict>& verdicts, Count& count) {
  for (const Verdict& verdict : verdicts.cells()) {
    if (verdict.face == nobody) continue;
    ++count.covered;
    count.compared += verdict.sure;
  }
}

void compare(const Polygons& scene, const Camera& camera, const std::string& which, Count& count) {
  const auto right = by_rays(scene, camera, margin);
  const Polygons tree = bsp_order(scene, camera), list = painter_order(scene, camera);
  EXPECT_TRUE(wrong(by_z_buffer(scene, camera), right).empty()) << "z-buffer, " << which;
  EXPECT_TRUE(wrong(by_scanline(scene, camera), right).empty()) << "by rows, " << which;
  expect_painted(tree, camera, right, "BSP tree, " + which, count);
  expect_painted(list, camera, right, "painter, " + which, count);
  count_pixels(right, count);
  const Hides pairs = hides(scene, camera);
  ++count.scenes;
  count.cuts += std::ssize(tree) - std::ssize(scene);
  count.painter_cuts += std::ssize(list) - std::ssize(scene);
  count.cycles += cyclic(pairs);
  count.piercings += piercings(pairs);
}

class HiddenSurfaces : public testing::TestWithParam<Kind> {};

TEST_P(HiddenSurfaces, AllMethodsShowWhatRaysMeet) {
  const Kind kind = GetParam();
  Count count;
  const std::int64_t runs = cases(8, 100);
  for (std::int64_t i = 0; i < runs; ++i) {
    Random random(seed(), static_cast<std::uint64_t>(i));
    const Polygons scene = scene_of(kind, random, i % 4 == 3);
    for (const bool perspective : {true, false}) {
      compare(scene, {160, perspective},
              fmt::format("{}, scene {}, {}", name_of(kind), i, perspective ? "perspective" : "orthographic"),
              count);
    }
  }
  fmt::print(
      "{}: {} scenes, {} cuts by the tree and {} by the painter, {} with a cycle, {} pairs that pierce, {} "
      "of {} pixels compared, "
      "{} on seams, {} open\n",
      name_of(kind), count.scenes, count.cuts, count.painter_cuts, count.cycles, count.piercings,
      count.compared, count.covered, count.on_seams, count.open);
  EXPECT_EQ(count.scenes, 2 * runs);
  EXPECT_GT(count.cuts, 0);
  EXPECT_GT(count.painter_cuts, 0);
  EXPECT_GT(count.piercings, 0);
  if (kind == Kind::cyclic) EXPECT_GT(count.cycles, 0);
  EXPECT_GE(static_cast<double>(count.compared), 0.6 * static_cast<double>(count.covered));
  EXPECT_LE(count.on_seams, count.compared / 20);
}

INSTANTIATE_TEST_SUITE_P(Kinds, HiddenSurfaces, testing::ValuesIn(kinds), [](const auto& kind) {
  std::string name = name_of(kind.param);
  std::ranges::replace(name, ' ', '_');
  return name;
});

}  // namespace
}  // namespace gradus::test
