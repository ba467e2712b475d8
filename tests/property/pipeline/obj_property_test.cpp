// Broken OBJ and MTL files: whatever is done to a good one, it is read as a sound mesh or refused with file
// and line.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "core/image.hpp"
#include "core/random.hpp"
#include "scene/models/obj.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::pipeline::obj_property_test {
namespace {

std::string contents(const std::string& name) {
  std::ifstream file(std::string(GRADUS_SOURCE_DIR) + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Changes bytes, words and lines.
std::string spoilt(Random& random, std::string text) {
  const char* words[]{
      "nan",    "inf",  "1e999",      "-1", "0", "//",     "1//", "99999999999",    "f", "1/1/", "t",
      "v",      "\\\n", "\r",         "\n", "#", "usemtl", "s",   "mtllib l.mtl\n", "-", "+",    ".",
      "1e-999", "\xFF", "newmtl a\n", "Kd"};
  const auto place = [&] {
    return static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(text.size())));
  };
  for (std::int64_t n = random.uniform_int(1, 3); n > 0; --n) {
    const std::size_t at = place();
    switch (random.uniform_int(0, 6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random.uniform_int(0, 255));
        break;
      case 1:
        text.insert(at, words[random.uniform_int(0, std::ssize(words) - 1)]);
        break;
      case 2:
        text.erase(at, static_cast<std::size_t>(random.uniform_int(1, 30)));
        break;
      case 4:  // other digits
        for (char& c : std::span(text).subspan(at).first(std::min<std::size_t>(text.size() - at, 3))) {
          if ('0' <= c && c <= '9') c = static_cast<char>('0' + random.uniform_int(0, 9));
        }
        break;
      case 5:  // blanks and comments, which change nothing between words
        text.insert(at, random.uniform_int(0, 1) ? " \t" : "\n# f 1 2\n");
        break;
      case 3: {  // a stretch comes again elsewhere
        const std::string piece = text.substr(at, 40);
        text.insert(place(), piece);
        break;
      }
      default:  // a word is replaced
        text.replace(at, std::min<std::size_t>(text.size() - at, 3),
                     words[random.uniform_int(0, std::ssize(words) - 1)]);
    }
  }
  return text;
}

void expect_sound(const ModelFile& model) {
  const Mesh& mesh = model.mesh;
  const auto finite = [](double x) { return std::isfinite(x) && std::abs(x) <= 1e30; };
  ASSERT_FALSE(mesh.faces.empty());
  for (const dvec3 p : mesh.positions) ASSERT_TRUE(finite(p.x) && finite(p.y) && finite(p.z));
  for (const dvec3 n : mesh.normals) ASSERT_TRUE(n == dvec3{0} || std::abs(glm::length(n) - 1) < 1e-14);
  for (const MeshFace& face : mesh.faces) {
    ASSERT_GE(face.count, 3);
    ASSERT_LT(static_cast<std::size_t>(face.material), mesh.materials.size());
    ASSERT_GE(face.line, 1);
    for (const Corner& corner : corners_of(mesh, face)) {
      ASSERT_LT(static_cast<std::size_t>(corner.position), mesh.positions.size());
      ASSERT_LT(static_cast<std::size_t>(corner.normal), mesh.normals.size());
      ASSERT_TRUE(corner.texture == -1 || static_cast<std::size_t>(corner.texture) < mesh.textures.size());
    }
  }
  for (const Material& m : mesh.materials) {
    for (const LinearRgb c : {m.ambient, m.diffuse, m.specular, m.emission}) {
      ASSERT_TRUE(finite(c.r) && finite(c.g) && finite(c.b) && std::min({c.r, c.g, c.b}) >= 0);
    }
  }
}

TEST(ObjProperty, SpoiltFilesAreReadSoundlyOrRefusedByName) {
  Random random(test::seed());
  const std::string good[]{contents("examples/models/letter_f.obj"),
                           contents("tests/support/models/tinyobj/cornell_box.obj"),
                           contents("tests/support/models/tinyobj/cube.obj"),
                           contents("tests/support/models/tinyobj/issue-138.obj")};
  const std::string library = contents("tests/support/models/tinyobj/issue-138.mtl");
  for (const std::string& text : good) ASSERT_GT(text.size(), 300u);
  ASSERT_GT(library.size(), 100u);
  const std::int64_t wanted = test::cases(20'000, 1'000'000);
  std::int64_t read = 0, refused = 0, in_library = 0;
  for (std::int64_t i = 0; i < wanted; ++i) {
    const std::string text = spoilt(random, good[random.uniform_int(0, 3)]);
    try {
      expect_sound(parse_obj(text, "m.obj", [&](const std::string&) -> std::optional<LibraryText> {
        const auto kind = random.uniform_int(0, 3);
        if (kind == 0) return std::nullopt;
        return kind == 1 ? spoilt(random, library) : library;
      }));
      ++read;
    } catch (const InputError& e) {
      const std::string what = e.what();
      ASSERT_EQ(what.find('\n'), std::string::npos) << what;
      in_library += what.substr(0, 6) != "m.obj:";
      ++refused;
    }
    if (testing::Test::HasFatalFailure())
      FAIL() << "case " << i << ", seed " << test::seed() << ":\n" << text;
  }
  std::printf("%lld read, %lld refused, %lld of them for their library\n", static_cast<long long>(read),
              static_cast<long long>(refused), static_cast<long long>(in_library));
  EXPECT_GT(read, wanted / 20);
  EXPECT_GT(refused, wanted / 10);
  EXPECT_GT(in_library, wanted / 100);
}

}  // namespace
}  // namespace gradus::pipeline::obj_property_test
