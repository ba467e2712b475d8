// Pictures of shipped and test models against committed ones, with a tolerance. GRADUS_UPDATE_GOLDEN=1 writes
// them anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/image.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/files.hpp"
#include "scene/models/textures.hpp"

namespace gradus::pipeline {
namespace {

struct Case {
  const char* name;
  const char* model;
};

Image decoded(const std::string& bytes, const std::string& name, std::int64_t most_pixels) {
  return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name, most_pixels);
}

class Render : public testing::TestWithParam<Case> {};

TEST_P(Render, LooksAsCommitted) {
  const std::string root = std::string(GRADUS_SOURCE_DIR) + "/";
  constexpr Size size{160, 120};
  const std::string model = root + GetParam().model;
  Mesh mesh = load_obj(model).mesh;
  load_textures(mesh, libraries_beside(model), decoded, model);
  const Scene scene = scene_of(std::move(mesh), 4.0 / 3);
  const Image image = render(scene, size);
  const std::string file = root + "tests/golden/renders/" + GetParam().name + ".png";
  if (std::getenv("GRADUS_UPDATE_GOLDEN")) {
    const auto bytes = encode_png(image);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  }
  const Image expected = read_png(file);
  ASSERT_EQ(image.window(), expected.window());
  int different = 0, drawn = 0;
  for (std::size_t i = 0; i < image.cells().size(); ++i) {
    const Rgba8 a = image.cells()[i], b = expected.cells()[i];
    different += std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > 2;
    drawn += b != Rgba8{255, 255, 255, 255};
  }
  EXPECT_LE(different, 10);
  EXPECT_GT(drawn, 2000);
}

INSTANTIATE_TEST_SUITE_P(
    Models, Render,
    testing::Values(Case{"letter_f", "examples/models/letter_f.obj"},
                    Case{"spot", "examples/models/spot.obj"}, Case{"room", "examples/models/room.obj"},
                    Case{"cornell_box", "tests/support/models/tinyobj/cornell_box.obj"},
                    Case{"polygons", "tests/support/models/tinyobj/issue-295-trianguation-failure.obj"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace gradus::pipeline
