// OBJ and MTL: all forms that are read, all that is refused with file and line, the conformance models, and
// tinyobjloader as oracle on well-formed files.

#include "scene/obj.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "core/refusal.hpp"
#include "scene/files.hpp"
#include "scene/materials.hpp"
#include "scene/obj_notes.hpp"

namespace gradus::pipeline {
namespace {

using Files = std::map<std::string, std::string>;

ModelFile parse(const std::string& text, const Files& files = {}) {
  return parse_obj(text, "m.obj", [&files](const std::string& name) -> std::optional<LibraryText> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional<LibraryText>(found->second);
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
      {v + "vt 0\nf 1/1 2/1 3/2\n",
       "m.obj:5: expected one of the 1 texture coordinate of the file (vt), found 2"},
      {v + "f 1/-1 2/-1 3/-1\nvt 0\n",
       "m.obj:4: expected one of the 0 texture coordinates so far (vt), found -1 in '1/-1'"},
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
      {v + "f 1/// 2 3\n",
       "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '1///'"},
      {v + "f /1 2 3\n", "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '/1'"},
      {v + "f // 2 3\n", "m.obj:4: expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found '//'"},
      {v + "f 1/0 2 3\n",
       "m.obj:4: expected a texture coordinate index that counts from 1, or from -1 backwards, found 0 in "
       "'1/0'"},
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
      {"\n\ncall other.obj\n", "m.obj:3: expected a model in one file, found 'call' of another file"},
      {"hello\n", "m.obj: expected at least one face, found none (0 vertices, 0 points, 0 lines)"},
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
      {"v 0 0 \x1B[31mboo\n", "m.obj:1: expected a number for the vertex, found '\\x1b[31mboo'"},
      {"v 0 0 " + std::string(100, 'x') + "\n",
       "m.obj:1: expected a number for the vertex, found '" + std::string(80, 'x') + "…'"},
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

// --- What a model may name -----------------------------------------------------------------------

/// A folder of its own with a model's folder in it, removed at the end.
class ObjFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "gradus_obj_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
    std::filesystem::create_directory(root_ / "models");
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(root_ / name, std::ios::binary) << text;
  }
  /// What the reader says of a model with these lines before its faces: its refusal, else its notes.
  std::string said(const std::string& lines) {
    write("models/m.obj", lines + "\n" + square + "usemtl red\nf 1 2 3\n");
    try {
      const ModelFile m = load_obj((root_ / "models/m.obj").string());
      std::string all = m.mesh.materials.at(1).diffuse == LinearRgb{1, 0, 0} ? "red" : "default";
      for (const std::string& note : m.notes) all += "; " + note;
      return without_folder(all);
    } catch (const InputError& error) {
      return without_folder(error.what());
    }
  }
  std::string without_folder(std::string text) const {
    for (std::size_t at; (at = text.find(root_.string() + "/")) != std::string::npos;)
      text.erase(at, root_.string().size() + 1);
    return text;
  }

  std::filesystem::path root_;
};

constexpr const char* red = "newmtl red\nKd 1 0 0\n";

TEST_F(ObjFiles, LibrariesWithBlanksInTheirNames) {
  write("models/a b.mtl", red);
  std::filesystem::create_directory(root_ / "models/a");
  EXPECT_EQ(said("mtllib a b.mtl"), "red");
  EXPECT_EQ(said("mtllib a\\ b.mtl"), "red");
  EXPECT_EQ(said("mtllib c.mtl a\\ b.mtl d.mtl"),
            "red; models/m.obj:1: no file 'c.mtl': its materials are the default; "
            "models/m.obj:1: no file 'd.mtl': its materials are the default");
  EXPECT_THAT(said("mtllib a\\ c.mtl"),
              testing::HasSubstr("models/m.obj:1: no file 'a c.mtl': its materials are the default"));
}

TEST_F(ObjFiles, AFolderIsNoLibrary) {
  std::filesystem::create_directory(root_ / "models/textures");
  const std::string material = "; models/m.obj:10: no material 'red' was read: it is drawn like the default";
  EXPECT_EQ(said("mtllib textures"),
            "default; models/m.obj:1: no file 'textures': its materials are the default" + material);
  EXPECT_EQ(said("mtllib ."),
            "default; models/m.obj:1: no file '.': its materials are the default" + material);
  EXPECT_EQ(said("mtllib .."),
            "default; models/m.obj:1: no file '..': its materials are the default" + material);
}

TEST_F(ObjFiles, OnlyRegularFilesOfAStatedSizeAreRead) {
  ASSERT_EQ(mkfifo((root_ / "models/pipe.mtl").c_str(), 0600), 0);
  EXPECT_EQ(said("mtllib pipe.mtl"),
            "models/m.obj:1: expected a regular file, found the pipe 'models/pipe.mtl'");
  EXPECT_EQ(said("mtllib /dev/zero"),
            "models/m.obj:1: expected a regular file, found the device '/dev/zero'");
  write("models/large.mtl", "");
  std::filesystem::resize_file(root_ / "models/large.mtl", most_library_bytes + 1);
  EXPECT_EQ(said("mtllib large.mtl"),
            "models/m.obj:1: expected a file of at most 16 MiB, found 'models/large.mtl'");
  std::string many = "mtllib";
  for (int i = 0; i <= 100; ++i) {
    write(fmt::format("models/{}.mtl", i), "");
    many += fmt::format(" {}.mtl", i);
  }
  EXPECT_EQ(said(many), "models/m.obj:1: expected at most 100 material libraries, found one more");
  // The model itself
  const auto refused = [&](const std::string& name) {
    try {
      load_obj((root_ / name).string());
    } catch (const InputError& error) {
      return without_folder(error.what());
    }
    return std::string("read");
  };
  EXPECT_EQ(refused("models/pipe.mtl"), "expected a regular file, found the pipe 'models/pipe.mtl'");
  EXPECT_EQ(refused("models"), "expected a regular file, found the folder 'models'");
  EXPECT_EQ(refused("models/none.obj"),
            "expected a readable file, found 'models/none.obj' (No such file or directory)");
  std::filesystem::resize_file(root_ / "models/large.mtl", most_file_bytes + 1);
  EXPECT_EQ(refused("models/large.mtl"), "expected a file of at most 256 MiB, found 'models/large.mtl'");
}

TEST_F(ObjFiles, LinesOfFilesOutsideTheModelsFolderAreNeverQuoted) {
  const std::string secret = "topsecret";
  const std::string forms[]{"topsecret:x:0:0",
                            "newmtl topsecret\nnewmtl topsecret",
                            "newmtl a\nKd topsecret",
                            "newmtl a\nKd -7777 0 0",
                            "newmtl a\nd 7777",
                            "newmtl a\nKd 1 0 0 topsecret",
                            "newmtl a\nmap_Kd -topsecret x",
                            "newmtl a\ntopsecret 1 2",
                            "newmtl a\nKd 1e7777"};
  const std::vector<std::string> names{"../secret.txt", "link.mtl", (root_ / "secret.txt").string(),
                                       "..\\secret.txt"};
  std::filesystem::create_symlink("../secret.txt", root_ / "models/link.mtl");
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    write("secret.txt", form + "\n");
    for (const std::string& name : names) {
      const std::string what = said("mtllib " + name);
      EXPECT_THAT(what, testing::AllOf(testing::Not(testing::HasSubstr(secret)),
                                       testing::Not(testing::HasSubstr("7777"))));
      EXPECT_THAT(what, testing::ContainsRegex("secret.txt:[0-9]: |link.mtl:[0-9]: |secret.txt':[0-9]: "))
          << name;
    }
    // Beside the model the user may see what is wrong
    write("models/own.mtl", form + "\n");
    EXPECT_THAT(said("mtllib own.mtl"), testing::ContainsRegex("topsecret|7777"));
  }
  write("secret.txt", red);
  EXPECT_EQ(said("mtllib ../secret.txt"), "red") << "it is read all the same";
}

TEST(Obj, AModelThatOthersNamedIsNotQuoted) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", f = "f 1 2 3\n";
  const auto said = [](const std::string& text) {
    LibraryText broken(std::string("topsecret\n"));
    try {
      const ModelFile m = parse_obj(text, {"far.obj", false}, [&](const std::string& name) {
        return name == "topsecret.mtl" ? std::optional(broken) : std::nullopt;
      });
      std::string all;
      for (const std::string& note : m.notes) all += note + "\n";
      return all;
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  for (const std::string text :
       {"v topsecret", "topsecret", "vt 7777e7777", "s topsecret", "f 1 2 topsecret", "f 1 2 7777",
        "f 1 2 -7777", "f 1 2 7777777777777", "l 1 7777", "usemtl topsecret", "mtllib topsecret",
        "mtllib topsecret.mtl", "curv topsecret"}) {
    const std::string what = said(v + text + "\n" + f);
    EXPECT_THAT(what, testing::StartsWith("far.obj:4: ")) << text;
    EXPECT_THAT(what, testing::Not(testing::ContainsRegex("topsecret|7777"))) << text;
  }
}

// Found by tests/fuzz: names of files, materials and statements that a terminal would act on
TEST(Obj, MessagesSpellOutWhatATerminalWouldActOn) {
  EXPECT_EQ(refusal("v \u202eboo\n"),
            "m.obj:1: expected a number for the vertex, found '\\xe2\\x80\\xaeboo'");
  EXPECT_EQ(refusal("v \xff\n"), "m.obj:1: expected a number for the vertex, found '\\xff'");
  EXPECT_THAT(parse(square + "\u202eboo\n\xff\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("'\\xe2\\x80\\xaeboo' is no known statement"),
                                   testing::HasSubstr("'\\xff' is no known statement")));
  EXPECT_EQ(refusal(square + "mtllib \x1b[1m.mtl\nf 1 2 3\n", {{"\x1b[1m.mtl", "Kd 1 1 1\n"}}),
            "'\\x1b[1m.mtl':1: expected newmtl first, found 'Kd'");
  EXPECT_THAT(parse(square + "usemtl \u2066\"<b>\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("no material '\\xe2\\x81\\xa6\"<b>' was read")));
  EXPECT_THAT(parse(square + "mtllib \x9b.mtl\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("no file '\\x9b.mtl'")));
  try {
    parse_obj("v boo\n", "\x1b]0;x\x07.obj", [](const std::string&) { return std::optional<LibraryText>(); });
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "'\\x1b]0;x\\x07.obj':1: expected a number for the vertex, found 'boo'");
  }
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
          // It keeps indices into normals that the file has none of
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

// What the loader of lecture notes makes of what ours reads: each fault alone, beside the right one.

const std::string triangle_and_normal = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
const std::string one_face = "f 1//1 2//1 3//1\n";

/// The name and the colour of the last face's material, or why there is none.
std::string material_of_notes(const std::string& text, const std::string& library) {
  const std::vector<NotesFace> faces = notes_faces(triangle_and_normal + text, library);
  if (faces.empty()) return "no face";
  const NotesFace& face = faces.back();
  return face.failure.empty() ? fmt::format("{} {}", face.material, face.colour.x) : face.failure;
}
std::string material_of_ours(const std::string& text, const std::string& library) {
  const ModelFile m = parse("mtllib m.mtl\n" + triangle_and_normal + text, {{"m.mtl", library}});
  const Material& material = m.mesh.materials[static_cast<std::size_t>(m.mesh.faces.back().material)];
  return fmt::format("{} {}", material.name, material.diffuse.r);
}

TEST(ObjNotes, NamesOfMaterialsKeepTheirLineEnds) {
  // E002-16
  const std::string use = "usemtl red\n" + one_face;
  EXPECT_EQ(material_of_notes(use, red), "red\n 1") << "both have the same line end";
  EXPECT_EQ(material_of_ours(use, red), "red 1");
  struct {
    std::string use, library, notes, ours;
  } cases[] = {
      {"usemtl red \n", red, "there is no material 'red'", "red 1"},
      {"usemtl red\n", "newmtl red \nKd 1 0 0\n", "there is no material 'red\\n'", "red 1"},
      {"usemtl  red\n", red, "there is no material ''", "red 1"},
      {"usemtl dark red\n", "newmtl dark red\nKd 1 0 0\n", "there is no material 'dark'", "dark red 1"},
      {"usemtl red\n", "newmtl dark red\nKd 1 0 0\n", "red\n 1", "red 0.7"}};  // found: it is another
  for (const auto& c : cases) {
    EXPECT_EQ(material_of_notes(c.use + one_face, c.library), c.notes) << c.use << c.library;
    EXPECT_EQ(material_of_ours(c.use + one_face, c.library), c.ours) << c.use << c.library;
  }
  // Opened as text, CR LF is hidden
  EXPECT_EQ(material_of_notes("usemtl red\r\n" + one_face, red), "red\n 1");
  EXPECT_EQ(material_of_ours("usemtl red\r\n" + one_face, red), "red 1");
}

TEST(ObjNotes, TheDefaultMaterialIsNeverTheCurrentOne) {
  // E002-17
  EXPECT_EQ(material_of_notes(one_face, ""), "there is no material ''");
  EXPECT_EQ(material_of_ours(one_face, ""), "default 0.7");
  // It is registered, under a name that is found only with nothing behind it, line end included
  EXPECT_EQ(material_of_notes("usemtl default \n" + one_face, ""), "default 1");
}

TEST(ObjNotes, CornersOfOneFormOnly) {
  // E002-18
  const std::string five = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.5 1.5 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
  const auto made = [&](const std::string& face) {
    return notes_faces(five + "usemtl red\n" + face, "newmtl red\nKd 1 0 0\n").back();
  };
  const auto ours = [&](const std::string& face) {
    std::vector<int> positions;
    for (const Corner& c : corners(parse(five + face), 0)) positions.push_back(c.position);
    return positions;
  };
  using Triangles = std::vector<std::array<int, 3>>;
  using Vertices = std::vector<int>;
  EXPECT_EQ(made("f 1//1 2//1 3//1\n").triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(made("f 1/1/1 2/1/1 3/1/1\n").triangles, (Triangles{{0, 1, 2}}));
  // G002-15: a quad is two triangles
  EXPECT_EQ(made("f 1//1 2//1 3//1 5//1\n").triangles, (Triangles{{0, 1, 2}, {2, 4, 0}}));
  // No third field
  for (const char* face : {"f 1 2 3\n", "f 1/1 2/1 3/1\n"}) {
    EXPECT_EQ(made(face).failure, "a corner has no third field") << face;
    EXPECT_EQ(ours(face), (Vertices{0, 1, 2})) << face;
  }
  // -5 is the first of five; it becomes -6
  EXPECT_EQ(made("f -5//1 -4//1 -3//1\n").triangles, (Triangles{{-6, -5, -4}}));
  EXPECT_EQ(ours("f -5//1 -4//1 -3//1\n"), (Vertices{0, 1, 2}));
  EXPECT_EQ(made("f 1//-1 2//-1 3//-1\n").failure, "there is no normal '-1'");
  EXPECT_EQ(ours("f 1//-1 2//-1 3//-1\n"), (Vertices{0, 1, 2}));
  // More than four corners
  const NotesFace dropped = made("f 1//1 2//1 3//1 4//1 5//1\n");
  EXPECT_TRUE(dropped.triangles.empty());
  EXPECT_EQ(dropped.failure, "") << "without a word";
  EXPECT_EQ(ours("f 1//1 2//1 3//1 4//1 5//1\n"), (Vertices{0, 1, 2, 3, 4}));
}

TEST(ObjNotes, EndsAtTheFirstFailure) {
  const auto faces = notes_faces(triangle_and_normal + "usemtl red\n" + one_face + "f 1 2 3\n" + one_face,
                                 "newmtl red\nKd 1 0 0\n");
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_EQ(faces[0].line, 6);
  EXPECT_EQ(faces[1].line, 7);
  EXPECT_TRUE(notes_faces("", "").empty());
}

}  // namespace
}  // namespace gradus::pipeline
