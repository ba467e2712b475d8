// OBJ and MTL: all forms that are read, all that is refused with file and line, the conformance models, and
// tinyobjloader as oracle on well-formed files.

#include "scene/obj.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "core/image.hpp"
#include "scene/materials.hpp"

namespace gradus::pipeline {
namespace {

using Files = std::map<std::string, std::string>;

ModelFile parse(const std::string& text, const Files& files = {}) {
  return parse_obj(text, "m.obj", [&files](const std::string& name) -> std::optional<std::string> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  });
}

/// What is said of a broken file; empty when it is read.
std::string refusal(const std::string& text, const Files& files = {}) {
  try {
    parse(text, files);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";

std::vector<Corner> corners(const ModelFile& model, std::size_t face) {
  const auto found = corners_of(model.mesh, model.mesh.faces[face]);
  return {found.begin(), found.end()};
}

TEST(Obj, AllFourIndexForms) {
  const ModelFile m = parse(square + "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 3/3/1\n");
  ASSERT_EQ(m.mesh.faces.size(), 4u);
  EXPECT_EQ(corners(m, 0)[1].position, 1);
  EXPECT_EQ(corners(m, 0)[1].texture, -1);
  EXPECT_EQ(corners(m, 1)[2].texture, 2);
  EXPECT_EQ(corners(m, 2)[2], (Corner{2, -1, 0}));
  EXPECT_EQ(corners(m, 3)[2], (Corner{2, 2, 0}));
  EXPECT_EQ(m.normals_in_file, 1);
  EXPECT_GE(corners(m, 0)[0].normal, 1);  // made
  EXPECT_EQ(m.mesh.faces[3].line, 12);
  EXPECT_EQ(m.mesh.files, std::vector<std::string>{"m.obj"});
}

TEST(Obj, NegativeIndicesCountBackFromWhereTheyStand) {
  const ModelFile m = parse(square + "f -4 -3 -2\nv 5 5 5\nf -1/-1/-1 -5/-2/-1 -4/-3/-1\n");
  EXPECT_EQ(corners(m, 0)[0].position, 0);
  EXPECT_EQ(corners(m, 1)[0], (Corner{4, 2, 0}));
  EXPECT_EQ(corners(m, 1)[2], (Corner{1, 0, 0}));
}

TEST(Obj, PositiveIndicesMayReachForward) {
  EXPECT_EQ(corners(parse("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"), 0)[2].position, 2);
}

TEST(Obj, LineEndsBlanksCommentsAndContinuations) {
  const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto same = [&](const std::string& text, int line) {
    const ModelFile m = parse(text);
    EXPECT_EQ(m.mesh.positions, parse(plain).mesh.positions) << text;
    ASSERT_EQ(m.mesh.faces.size(), 1u);
    EXPECT_EQ(m.mesh.faces[0].line, line) << text;
  };
  same("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", 4);
  same("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3", 4);
  same("\xEF\xBB\xBFv 0 0 0\n\n\n  v\t1 0 0 # one\n#\n   # two \\\nv 0 1 0\n f  1   2 3 #4\n", 8);
  same("v 0 0 0\nv 1 \\\n0 0\nv 0 \\  \r\n 1\\\n 0\nf 1 \\\n\\\n 2 3\n", 7);
  same("v +0 0. .0e5\nv 1e0 0E-7 -0\nv 0 1.0 0 1.0\nf +1 2 3", 4);
}

TEST(Obj, FacesOfAnySizeAndEverythingBeside) {
  std::string text, face = "f";
  for (int i = 0; i < 500; ++i) {
    text += fmt::format("v {} {} 0\n", std::cos(i * 0.0125), std::sin(i * 0.0125));
    face += fmt::format(" {}", i + 1);
  }
  const ModelFile m = parse("o a body\ng one two\ns 1\nlod 3\nmg 1 2\n" + text +
                            "p 1 2\nl 1 2 3\nl 4/1 5/1\nvt 0\n" + face + "\n");
  EXPECT_EQ(triangle_count(m.mesh), 498);
  EXPECT_EQ(m.points, 1);
  EXPECT_EQ(m.lines, 2);
  // Weights and colours are checked and not used
  EXPECT_EQ(parse("v 0 0 0 2\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1 1\nf 1 2 3\n").mesh.positions[0], dvec3{0});
}

TEST(Obj, MissingNormalsAreMadeByGroups) {
  const std::string bent = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 0 1 2\n";
  const std::string floor = "f 1 2 3 4\n", wall = "f 1 4 6 5\n";  // normals +z and +x, areas 1 and 2
  const auto at_edge = [](const ModelFile& m, std::size_t face) {
    return m.mesh.normals[static_cast<std::size_t>(corners(m, face)[0].normal)];
  };
  const ModelFile smooth = parse(bent + floor + wall);
  EXPECT_NEAR(glm::distance(at_edge(smooth, 0), unit_vector(dvec3{2, 0, 1})), 0, 1e-15);
  EXPECT_EQ(at_edge(smooth, 1), at_edge(smooth, 0));
  const ModelFile flat = parse(bent + "s off\n" + floor + wall);
  EXPECT_EQ(at_edge(flat, 0), (dvec3{0, 0, 1}));
  EXPECT_EQ(at_edge(flat, 1), (dvec3{1, 0, 0}));
  const ModelFile apart = parse(bent + "s 1\n" + floor + "s 2\n" + wall);
  EXPECT_EQ(at_edge(apart, 0), (dvec3{0, 0, 1}));
  const ModelFile together = parse(bent + "s 3\n" + floor + wall);
  EXPECT_EQ(at_edge(together, 0), at_edge(smooth, 0));
  // A normal of length 0 is none
  const ModelFile zero = parse(bent + "vn 0 0 0\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(at_edge(zero, 0), (dvec3{0, 0, 1}));
}

TEST(Obj, MaterialsWithBlanksFromSeveralLibraries) {
  const Files files{
      {"a b.mtl", "newmtl dark red  \r\nKd 0.5 0 0\r\n"},
      {"c.mtl", "newmtl blue\nKd 0 0 1\n\tKs .5\nNs 7\nTr 0.25\nmap_Kd -s 1 1 -o 0 0 0 my wood.png\n"}};
  const std::string faces =
      square + "f 1 2 3\nusemtl  dark red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl none\nf 1 2 3\n";
  const ModelFile m = parse("mtllib a b.mtl\nmtllib gone.mtl c.mtl\n" + faces, files);
  const auto& of = [&](std::size_t face) -> const Material& {
    return m.mesh.materials[static_cast<std::size_t>(m.mesh.faces[face].material)];
  };
  EXPECT_EQ(of(0).name, "default");
  EXPECT_EQ(of(1).diffuse, (LinearRgb{0.5f, 0, 0}));
  EXPECT_EQ(of(1).ambient, (LinearRgb{0.5f, 0, 0}));  // no Ka: Kd
  EXPECT_EQ(of(2).specular, LinearRgb{0.5f});
  EXPECT_EQ(of(2).shininess, 7);
  EXPECT_EQ(of(2).opacity, 0.75f);
  EXPECT_EQ(of(2).diffuse_map.file, "my wood.png");
  EXPECT_EQ(of(3).diffuse, Material{}.diffuse);
  EXPECT_THAT(m.notes,
              testing::ElementsAre("m.obj:2: no file 'gone.mtl': its materials are the default",
                                   "m.obj:16: no material 'none' was read: it is drawn like the default"));
  // A library may come after the first use
  EXPECT_EQ(parse(square + "usemtl blue\nf 1 2 3\nmtllib c.mtl\n", files).mesh.materials[1].diffuse,
            (LinearRgb{0, 0, 1}));
}

TEST(Obj, WhatIsBrokenIsToldWithItsPlace) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {v + "f 1 2\n", "m.obj:4: expected a face of at least 3 corners, found 2"},
      {v + "f\n", "m.obj:4: expected a face of at least 3 corners, found 0"},
      {v + "f 0 1 2\n",
       "m.obj:4: expected a vertex index that counts from 1, or from -1 backwards, found 0 in '0'"},
      {v + "f 1 2 4\n", "m.obj:4: expected one of the 3 vertices of the file (v), found 4"},
      {v + "f 1 2 -4\n", "m.obj:4: expected one of the 3 vertices so far (v), found -4 in '-4'"},
      {v + "f 1/1 2/1 3/1\n", "m.obj:4: expected one of the 0 texture coordinates of the file (vt), found 1"},
      {v + "f 1//1 2//1 3//2\nvn 0 0 1\n", "m.obj:4: expected one of the 1 normal of the file (vn), found 2"},
      {v + "f 1 2 2147483648\n",
       "m.obj:4: expected a vertex index from -1073741823 to 1073741823, found '2147483648'"},
      {v + "f 1 2 99999999999999999999\n",
       "m.obj:4: expected a vertex index from -1073741823 to 1073741823, found '99999999999999999999'"},
      {v + "f 1 2 -99999999999999999999\n",
       "m.obj:4: expected a vertex index from -1073741823 to 1073741823, found '-99999999999999999999'"},
      {v + "f 1 2 3.5\n",
       "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '3.5'"},
      {v + "f 1 2 x\n", "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found 'x'"},
      {v + "f 1/ 2/ 3/\n",
       "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '1/'"},
      {v + "f 1// 2// 3//\n",
       "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '1//'"},
      {v + "f 1/1/1/1 2 3\n",
       "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '1/1/1/1'"},
      {v + "vn 0 0 1\nf 1//1 2 3\n",
       "m.obj:5: expected corner 2 of the face in the form of the first, found '2'"},
      {"v 0 0\n", "m.obj:1: expected a number for the vertex, found none"},
      {"v 0 0 nan\n", "m.obj:1: expected a finite number for the vertex, found 'nan'"},
      {"v 0 0 -inf\n", "m.obj:1: expected a finite number for the vertex, found '-inf'"},
      {"v 0 0 1e400\n", "m.obj:1: expected a number of at most 1e+30 for the vertex, found '1e400'"},
      {"v 0 0 1e31\n", "m.obj:1: expected a number of at most 1e+30 for the vertex, found '1e31'"},
      {"v 0 0 1,5\n", "m.obj:1: expected a number for the vertex, found '1,5'"},
      {"v 0 0 0x10\n", "m.obj:1: expected a number for the vertex, found '0x10'"},
      {"v 0 0 +-1\n", "m.obj:1: expected a number for the vertex, found '+-1'"},
      {"v 0 0 0 1 1\n", "m.obj:1: expected a vertex of 3, 4, 6 or 7 numbers, found 5"},
      {"vn 0 0 1 0\n", "m.obj:1: expected nothing after a normal, found '0'"},
      {"vt 0 0 0 0\n", "m.obj:1: expected nothing after a texture coordinate, found '0'"},
      {"vt inf\n", "m.obj:1: expected a finite number for the texture coordinate, found 'inf'"},
      {"\n\ncurv 0 1\n", "m.obj:3: expected faces alone, found 'curv' of a free-form curve or surface"},
      {"hello\n", "m.obj:1: expected a statement of an OBJ file, found 'hello'"},
      {"s one\n", "m.obj:1: expected a smoothing group, a whole number or off, found 'one'"},
      {"s -1\n", "m.obj:1: expected a smoothing group, a whole number or off, found '-1'"},
      {"mtllib\n", "m.obj:1: expected a file's name after mtllib, found none"},
      {"p\n", "m.obj:1: expected a point of at least 1 vertices, found 0"},
      {v + "l 1\n", "m.obj:4: expected a line of at least 2 vertices, found 1"},
      {v + "f 1 2 3\nl 1 9\n", "m.obj:5: expected one of the 3 vertices of the file (v), found 9"},
      {"", "m.obj: expected at least one face, found none (0 vertices, 0 points, 0 lines)"},
      {v + "p 1\n", "m.obj: expected at least one face, found none (3 vertices, 1 points, 0 lines)"},
      {std::string("v 0 0 0\0", 8), "m.obj: expected text, found a zero at byte 7"},
      {"\xFF\xFEv", "m.obj: expected text in UTF-8 or ASCII, found UTF-16"},
      {"\x1B[31mboo\n", "m.obj:1: expected a statement of an OBJ file, found '\\x1b[31mboo'"},
      {std::string(100, 'x') + "\n",
       "m.obj:1: expected a statement of an OBJ file, found '" + std::string(80, 'x') + "…'"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(refusal(text), expected);
}

TEST(Obj, BrokenLibrariesAreToldWithTheirPlace) {
  const auto said = [](const std::string& library) {
    return refusal(square + "mtllib l.mtl\nf 1 2 3\n", {{"l.mtl", library}});
  };
  EXPECT_EQ(said("Kd 1 1 1\n"), "l.mtl:1: expected newmtl first, found 'Kd'");
  EXPECT_EQ(said("newmtl a\nKd 1 nan 1\n"), "l.mtl:2: expected a finite number for Kd, found 'nan'");
  EXPECT_EQ(said("newmtl a\nKd 1 -1 1\n"), "l.mtl:2: expected Kd of 0 or more, found -1");
  EXPECT_EQ(said("newmtl a\nKd 1 1\n"), "l.mtl:2: expected a number for Kd, found none");
  EXPECT_EQ(said("newmtl a\nKd spectral f.rfl\n"), "l.mtl:2: expected Kd as r g b, found spectral");
  EXPECT_EQ(said("newmtl a\nNs\n"), "l.mtl:2: expected a number for Ns, found none");
  EXPECT_EQ(said("newmtl a\nd 1.5\n"), "l.mtl:2: expected d from 0 to 1, found 1.5");
  EXPECT_EQ(said("newmtl a\nnewmtl a\n"),
            "l.mtl:2: expected another name for each material, found 'a' again");
  EXPECT_EQ(said("newmtl a\nmap_Kd -frob x.png\n"), "l.mtl:2: expected an option of a map, found '-frob'");
  EXPECT_EQ(said("newmtl a\nillum 2\nNi 1.5\nTf 1 1 1\nbump -bm 2 b.png\nsharpness 60\nd -halo 0.5\n"), "");
  EXPECT_EQ(load_obj(std::string(GRADUS_SOURCE_DIR) + "/examples/models/letter_f.obj").notes,
            std::vector<std::string>{});
  EXPECT_THROW(load_obj("/no/such/file.obj"), InputError);
  EXPECT_THROW(load_obj("/"), InputError);
}

// Found by tests/fuzz: names of files, materials and statements that a terminal would act on
TEST(Obj, MessagesSpellOutWhatATerminalWouldActOn) {
  EXPECT_EQ(refusal("\u202eboo\n"),
            "m.obj:1: expected a statement of an OBJ file, found '\\xe2\\x80\\xaeboo'");
  EXPECT_EQ(refusal("\xff\n"), "m.obj:1: expected a statement of an OBJ file, found '\\xff'");
  EXPECT_EQ(refusal(square + "mtllib \x1b[1m.mtl\nf 1 2 3\n", {{"\x1b[1m.mtl", "Kd 1 1 1\n"}}),
            "'\\x1b[1m.mtl':1: expected newmtl first, found 'Kd'");
  EXPECT_THAT(parse(square + "usemtl \u2066\"<b>\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("no material '\\xe2\\x81\\xa6\"<b>' was read")));
  EXPECT_THAT(parse(square + "mtllib \x9b.mtl\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("no file '\\x9b.mtl'")));
  try {
    parse_obj("boo\n", "\x1b]0;x\x07.obj", [](const std::string&) { return std::optional<std::string>(); });
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "'\\x1b]0;x\\x07.obj':1: expected a statement of an OBJ file, found 'boo'");
  }
}

// --- The conformance models
// ---------------------------------------------------------------------------------

/// The models that are refused, and a part of the reason. All others are read.
const std::map<std::string, std::string>& refused() {
  static const std::map<std::string, std::string> reasons{
      {"tinyobj/catmark_torus_creases0.obj", ":94: expected a statement of an OBJ file, found 't'"},
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
      {"tinyobj/skin-weight.obj", ":13: expected a statement of an OBJ file, found 'vw'"},
      {"tinyobj/smoothing-group-two-squares.obj",
       ":21: expected one of the 0 normals of the file (vn), found 1"},
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
          if (index.normal_index >= 0) ASSERT_EQ(ours[i].normal, index.normal_index);
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
}  // namespace gradus::pipeline
