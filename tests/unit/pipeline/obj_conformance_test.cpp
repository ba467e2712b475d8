// Models that other readers are tested with, and tinyobjloader as oracle on well-formed files and on forgiven
// ones.

#include "scene/models/obj.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "core/refusal.hpp"
#include "scene/files.hpp"
#include "scene/models/materials.hpp"
#include "support/obj_text.hpp"

namespace gradus::pipeline::obj_conformance_test {
namespace {

// --- What is forgiven ----------------------------------------------------------------------------

/// The faces of a text as tinyobjloader reads them, as "position/texture/normal" words.
std::vector<std::string> theirs(const std::string& text) {
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  tinyobj::ObjReader reader;
  EXPECT_TRUE(reader.ParseFromString(text, "", config)) << reader.Error();
  std::vector<std::string> faces;
  for (const auto& shape : reader.GetShapes()) {
    std::size_t at = 0;
    for (const auto count : shape.mesh.num_face_vertices) {
      std::string& face = faces.emplace_back();
      for (std::size_t i = 0; i < count; ++i, ++at) {
        const auto& index = shape.mesh.indices[at];
        face += fmt::format("{}/{}/{} ", index.vertex_index, index.texcoord_index, index.normal_index);
      }
    }
  }
  return faces;
}

/// The same of ours, without the normals that were made.
std::vector<std::string> ours(const ModelFile& m) {
  std::vector<std::string> faces;
  for (const MeshFace& face : m.mesh.faces) {
    std::string& words = faces.emplace_back();
    for (const Corner& c : corners_of(m.mesh, face)) {
      words += fmt::format("{}/{}/{} ", c.position, c.texture, c.normal < m.normals_in_file ? c.normal : -1);
    }
  }
  return faces;
}

TEST(Obj, NumbersTooSmallForADoubleAreZeroOrTheNearestOne) {
  const ModelFile m = parse(
      "v 1e-400 0 0\nv 2e-324 1 -1e-400\nv 3e-324 2.5e-324 1e-310\n"
      "v 0.0000001e-320 1e-99999999999999999999 -2e-324\nv 1 1000000e-330 0e999\nf 1 2 3 4 5\n");
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(m.mesh.positions,
            (std::vector<dvec3>{{0, 0, 0}, {0, 1, 0}, {least, least, 1e-310}, {0, 0, 0}, {1, 0, 0}}));
  EXPECT_TRUE(std::signbit(m.mesh.positions[1].z));
  // Zeros before the point do not make a number small, nor digits behind it a large one
  EXPECT_EQ(refusal("v 0.0001e400 0 0\n"),
            "m.obj:1: expected a number of at most 1e+30 for the vertex, found '0.0001e400'");
  EXPECT_EQ(refusal("v 1e99999999999999999999 0 0\n"),
            "m.obj:1: expected a number of at most 1e+30 for the vertex, found '1e99999999999999999999'");
  EXPECT_EQ(refusal("v 0" + std::string(400, '9') + "e-2 0 0\n").substr(0, 50),
            "m.obj:1: expected a number of at most 1e+30 for th");
  EXPECT_EQ(parse("v 0." + std::string(400, '0') + "1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.positions[0],
            dvec3{0});
}

TEST(Mtl, NumbersTooSmallForADoubleAreZero) {
  std::vector<std::string> notes;
  const Material m =
      parse_mtl("newmtl a\nKd 1e-400 2e-324 1\nNs 1e-999\nd 1e-400\nNi 1e-400\nmap_Kd -s 1e-400 x.png\n",
                "a.mtl", notes)
          .at(0);
  EXPECT_EQ(m.diffuse, (LinearRgb{0, 0, 1}));
  EXPECT_EQ(m.shininess, 0);
  EXPECT_EQ(m.opacity, 0);
  EXPECT_EQ(m.diffuse_map.file, "x.png");
  EXPECT_THAT(notes, testing::IsEmpty());
}

TEST(Obj, AnEmptyLastIndexIsNone) {
  const ModelFile m =
      parse(square + "f 1// 2// 3//\nf 1/1/ 2/2/ 3/3/\nf 1/ 2/ 3/\nf 1/ 2// 3\nf -4/-3/ -3/-2/ -2/-1/\n");
  EXPECT_EQ(ours(m), theirs(square + "f 1 2 3\nf 1/1 2/2 3/3\nf 1 2 3\nf 1 2 3\nf 1/1 2/2 3/3\n"));
  EXPECT_THAT(m.notes, testing::IsEmpty());
  // Points and lines too
  EXPECT_EQ(parse(square + "f 1 2 3\nl 1/1/ 2/\np 3//\n").lines, 1);
  // Corners of one face have one form
  EXPECT_EQ(refusal(square + "f 1/1/ 2// 3/3/\n"),
            "m.obj:9: expected corner 2 of the face in the form of the first, found '2//'");
}

TEST(Obj, IndicesIntoDataThatTheFileHasNoneOfAreLeftOut) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const ModelFile m = parse(v + "f 1 2 3\nf 1/1/1 2/7/7 3/1/-1\n");
  EXPECT_EQ(ours(m)[1], "0/-1/-1 1/-1/-1 2/-1/-1 ");
  EXPECT_GE(corners(m, 1)[0].normal, 0) << "normals are made";
  EXPECT_THAT(m.notes,
              testing::ElementsAre(
                  "m.obj:5: there are no texture coordinates (vt) in the file: their indices are left out",
                  "m.obj:5: there are no normals (vn) in the file: their indices are left out"));
  // One kind alone, and what stands behind the faces counts
  EXPECT_EQ(parse(v + "vt 0 0\nf 1/1/1 2/1/1 3/1/1\n").notes.size(), 1u);
  EXPECT_EQ(parse(v + "f 1/1/1 2/1/1 3/1/1\nvt 0\nvn 0 0 1\n").notes.size(), 0u);
  // As tinyobjloader has them where there are such data
  const std::string whole = square + "f 1/1/1 2/2/1 3/3/1\n";
  EXPECT_EQ(ours(parse(whole)), theirs(whole));
  EXPECT_EQ(refusal(v + "f 1/0 2/0 3/0\n"),
            "m.obj:4: expected a texture coordinate index that counts from 1, or from -1 backwards, found 0 "
            "in '1/0'");
}

TEST(Obj, UnknownStatementsAreLeftOutWithARemarkAKind) {
  const std::string text =
      square + "t crease 2/1/0 1 2 4.7\nf 1 2 3\nvw 0 0 1\nvw 1 0 1\nhello \\\nthere\nvw 2 1\n";
  const ModelFile m = parse(text);
  EXPECT_EQ(ours(m), theirs(text));
  EXPECT_THAT(m.notes, testing::ElementsAre(
                           "m.obj:9: 't' is no known statement of an OBJ file and is left out",
                           "m.obj:11: 'vw' is no known statement of an OBJ file and is left out (3 times)",
                           "m.obj:13: 'hello' is no known statement of an OBJ file and is left out"));
  // A text of something else: few lines are said of it, and it has no face
  std::string prose;
  for (int i = 0; i < 1000; ++i) prose += fmt::format("word{} and more\n", i);
  EXPECT_EQ(parse(square + prose + "f 1 2 3\n").notes.size(), 17u);
  EXPECT_THAT(parse(square + prose + "f 1 2 3\n").notes.back(),
              testing::Eq("984 more unknown statements of other kinds are left out"));
  EXPECT_THAT(refusal(prose), testing::HasSubstr("expected at least one face, found none"));
  // The same in a library
  const ModelFile with =
      parse(square + "mtllib l.mtl\nf 1 2 3\n", {{"l.mtl", "newmtl a\nfoo 1\nfoo 2\nbar\n"}});
  EXPECT_THAT(with.notes, testing::ElementsAre(
                              "l.mtl:2: 'foo' is no known statement of an MTL file and is left out (2 times)",
                              "l.mtl:4: 'bar' is no known statement of an MTL file and is left out"));
}

// --- The conformance models ----------------------------------------------------------------------

/// The models that are refused, and a part of the reason. All others are read.
const std::map<std::string, std::string>& refused() {
  static const std::map<std::string, std::string> reasons{
      {"tinyobj/invalid-face-definition.obj", ":15: expected a face of at least 3 corners"},
      {"tinyobj/invalid-relative-texture-index.obj",
       ":2: expected one of the 1 texture coordinate so far (vt), found -2 in '1/-2'"},
      {"tinyobj/invalid-relative-vertex-index.obj",
       ":1: expected one of the 0 vertices so far (v), found -4 in '-4'"},
      {"tinyobj/issue-140-zero-face-idx.obj",
       ":16: expected a vertex index that counts from 1, or from -1 backwards, found 0 in '0/0/0'"},
      {"tinyobj/issue-356-leading-spaces-newmtl.obj", "expected at least one face, found none"},
      {"tinyobj/line-prim.obj", "expected at least one face, found none (8 vertices, 0 points, 2 lines)"},
      {"tinyobj/points-prim.obj", "expected at least one face, found none (8 vertices, 1 points, 0 lines)"},
      {"tinyobj/test-nan.obj", ":12: expected a finite number for the vertex, found 'nan'"},
      {"assimp/box_UTF16BE.obj", "UTF-16"},
      {"assimp/invalid_empty.obj", "expected at least one face, found none (0 vertices"},
      {"assimp/invalid_malformed.obj", ":28: expected a vertex index that counts from 1"},
      {"assimp/invalid_malformed2.obj", ":23: expected a face of at least 3 corners, found 0"},
      {"assimp/number_formats.obj", ":11: expected a number for the vertex, found '3.1+e2'"},
      {"assimp/point_cloud.obj", "expected at least one face, found none (3 vertices"},
      {"assimp/testline.obj", "expected at least one face, found none (8 vertices, 0 points, 6 lines)"},
      {"assimp/testpoints.obj", "expected at least one face, found none (8 vertices, 6 points, 0 lines)"},
  };
  return reasons;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// How many lines begin with this word, after joining continued lines.
std::size_t lines_with(std::string text, const std::string& word) {
  for (std::size_t at; (at = text.find("\\\n")) != std::string::npos;) text.replace(at, 2, " ");
  for (std::size_t at; (at = text.find("\\\r\n")) != std::string::npos;) text.replace(at, 3, " ");
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line, first; std::getline(lines, line);) {
    std::istringstream words(line);
    count += static_cast<bool>(words >> first) && first == word;
  }
  return count;
}

TEST(ObjConformance, EveryModelIsReadWithItsCountsOrRefusedWithAReason) {
  const std::filesystem::path folder = std::filesystem::path(GRADUS_SOURCE_DIR) / "tests/support/models";
  int read = 0, reasons = 0, compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    const std::string name = std::filesystem::relative(entry.path(), folder).generic_string();
    const auto reason = refused().find(name);
    if (reason != refused().end()) {
      try {
        load_obj(entry.path().string());
        ADD_FAILURE() << name << " was read";
      } catch (const InputError& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr(reason->second)) << name;
        EXPECT_THAT(e.what(), testing::HasSubstr(entry.path().filename().string())) << name;
      }
      ++reasons;
      continue;
    }
    SCOPED_TRACE(name);
    ModelFile m;
    ASSERT_NO_THROW(m = load_obj(entry.path().string()));
    const std::string text = contents(entry.path());
    EXPECT_EQ(m.mesh.positions.size(), lines_with(text, "v"));
    EXPECT_EQ(m.mesh.faces.size(), lines_with(text, "f"));
    EXPECT_EQ(m.mesh.textures.size(), lines_with(text, "vt"));
    EXPECT_EQ(static_cast<std::size_t>(m.normals_in_file), lines_with(text, "vn"));
    for (const Corner& corner : m.mesh.corners) ASSERT_GE(corner.normal, 0);
    ++read;

    // tinyobjloader, face by face; it counts a face's corners in a byte
    const auto corner_count = [](const MeshFace& f) { return f.count; };
    if (std::ranges::max(m.mesh.faces, {}, corner_count).count > 255) continue;
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    tinyobj::ObjReader oracle;
    ASSERT_TRUE(oracle.ParseFromFile(entry.path().string(), config)) << oracle.Error();
    ASSERT_EQ(oracle.GetAttrib().vertices.size(), 3 * m.mesh.positions.size());
    for (std::size_t i = 0; i < m.mesh.positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        // Its numbers may be off in the last places
        const double exact = m.mesh.positions[i][axis],
                     theirs = oracle.GetAttrib().vertices[3 * i + static_cast<std::size_t>(axis)];
        ASSERT_NEAR(exact, theirs, 1e-14 * std::abs(exact)) << i;
      }
    }
    std::size_t face = 0;
    for (const auto& shape : oracle.GetShapes()) {
      std::size_t at = 0;
      for (const auto count : shape.mesh.num_face_vertices) {
        const auto ours = corners_of(m.mesh, m.mesh.faces[face]);
        ASSERT_EQ(ours.size(), count) << "face " << face;
        for (std::size_t i = 0; i < count; ++i, ++at) {
          const auto& index = shape.mesh.indices[at];
          ASSERT_EQ(ours[i].position, index.vertex_index);
          ASSERT_EQ(ours[i].texture, index.texcoord_index);
          // It keeps indices into normals that the file lacks
          const bool has_normals = !oracle.GetAttrib().normals.empty();
          if (has_normals && index.normal_index >= 0) ASSERT_EQ(ours[i].normal, index.normal_index);
        }
        ++face;
        ++compared;
      }
    }
    EXPECT_EQ(face, m.mesh.faces.size());
  }
  EXPECT_EQ(static_cast<std::size_t>(reasons), refused().size());
  EXPECT_EQ(read + reasons, 71);
  EXPECT_GT(compared, 1500);
  std::printf("%d models read, %d refused, %d faces compared\n", read, reasons, compared);
}

}  // namespace
}  // namespace gradus::pipeline::obj_conformance_test
