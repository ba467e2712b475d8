// All methods for hidden surfaces show the same picture: the z-buffer, the z-buffer by rows, the BSP tree's
// order painted from back to front, and a ray through the centre of each pixel, on scenes with cycles and
// piercing faces.

#include "support/hidden_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
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

class HiddenSurfacesAgree : public testing::TestWithParam<Kind> {};

TEST_P(HiddenSurfacesAgree, AllMethodsShowWhatRaysMeet) {
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

INSTANTIATE_TEST_SUITE_P(Kinds, HiddenSurfacesAgree, testing::ValuesIn(kinds), [](const auto& kind) {
  std::string name = name_of(kind.param);
  std::ranges::replace(name, ' ', '_');
  return name;
});

// --- How much work the methods make of the same boxes

/// Of one method on a scene.
struct Effort {
  std::int64_t tests = 0;    ///< depths compared, or polygons held against planes or against each other
  std::int64_t parts = 0;    ///< faces and parts that were drawn
  std::int64_t writes = 0;   ///< pixels written
  std::int64_t covered = 0;  ///< pixels that show a face in the end: all other writes were for nothing
  friend bool operator==(const Effort&, const Effort&) = default;
};
std::ostream& operator<<(std::ostream& out, const Effort& e) {
  return out << fmt::format("{{{}, {}, {}, {}}}", e.tests, e.parts, e.writes, e.covered);
}

constexpr Camera measured{256, true};

Effort z_buffer_effort(const Polygons& scene) {
  Effort effort{.parts = std::ssize(scene)};
  const Projected projected(scene, measured);
  Raster<z_buffer::Cell<double, z_buffer::Id>> buffer(measured.size, measured.size);
  z_buffer::per_polygon<double>(projected.faces, buffer, z_buffer::Exactly{}, [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, z_buffer::Finished>) effort.tests = s.compared, effort.writes = s.kept;
  });
  effort.covered = std::ranges::count_if(buffer.cells(), [](const auto& cell) { return cell.taken; });
  return effort;
}

/// Of painting these, which took so many tests to order.
Effort painted_effort(const Polygons& order, std::int64_t tests) {
  Effort effort{.tests = tests, .parts = std::ssize(order)};
  for (const auto& part : order) {
    const auto corners = measured.image(part.corners);
    const z_buffer::Outline outline({corners, {}}, {{0, 0}, {measured.size - 1, measured.size - 1}});
    for ([[maybe_unused]] const ivec2 pixel : outline.pixels()) ++effort.writes;
  }
  const Picture picture = painted(order, measured);
  effort.covered = std::ranges::count_if(picture.cells(), [](int face) { return face != nobody; });
  return effort;
}
Effort bsp_effort(const Polygons& scene) {
  std::int64_t tests = 0;
  bsp_tree::build(scene, bsp_tree::ExactSide{},
                  [&]<class Step>(const Step&) { tests += std::same_as<Step, bsp_tree::Placed<double>>; });
  return painted_effort(bsp_order(scene, measured), tests);
}
Effort painter_effort(const Polygons& scene) {
  std::int64_t tests = 0;
  painter::newell(
      scene, measured.view(), [](const auto&) {},
      [&]<class Step>(const Step&) { tests += std::same_as<Step, painter::Compared<double>>; });
  return painted_effort(painter_order(scene, measured), tests);
}

/// What the benchmark's scenes cost beside time.
struct Efforts {
  Kind kind;
  std::int64_t faces, fronts;
  Effort z_buffer, z_buffer_of_fronts, bsp, painter, painter_of_fronts;
};

TEST(HiddenSurfaces, TheirWorkOnTheBenchmarksScenes) {
  const Efforts known[]{
      {Kind::few_large,
       24,
       11,
       {75068, 24, 53148, 36260},
       {37534, 11, 36939, 36260},
       {214, 65, 75070, 36261},
       {1532, 42, 75067, 36260},
       {162, 17, 37533, 36259}},
      {Kind::many_small,
       240,
       112,
       {110208, 240, 60822, 32731},
       {55104, 112, 42128, 32731},
       {6101, 1517, 110203, 32731},
       {106741, 563, 110210, 32731},
       {8055, 174, 55103, 32731}},
      {Kind::heavy_overdraw,
       120,
       22,
       {714506, 120, 67461, 50422},
       {357253, 22, 64371, 50422},
       {9001, 2030, 714502, 50422},
       {31766, 532, 714500, 50423},
       {446, 55, 357251, 50422}},
      {Kind::cyclic,
       66,
       27,
       {78158, 66, 40080, 31312},
       {39079, 27, 34699, 31312},
       {1474, 377, 78152, 31309},
       {3391, 139, 78154, 31311},
       {469, 54, 39076, 31310}},
  };
  for (const Efforts& right : known) {
    SCOPED_TRACE(name_of(right.kind));
    const Polygons scene = boxes(right.kind), shown = fronts(scene, measured);
    EXPECT_EQ(std::ssize(scene), right.faces);
    EXPECT_EQ(std::ssize(shown), right.fronts);
    EXPECT_EQ(z_buffer_effort(scene), right.z_buffer);
    EXPECT_EQ(z_buffer_effort(shown), right.z_buffer_of_fronts);
    EXPECT_EQ(bsp_effort(scene), right.bsp);
    EXPECT_EQ(painter_effort(scene), right.painter);
    EXPECT_EQ(painter_effort(shown), right.painter_of_fronts);
  }
}

}  // namespace
}  // namespace gradus::test
