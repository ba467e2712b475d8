// OFF, PLY and STL: what such files say is read, told in one remark, or refused with file and place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "core/refusal.hpp"
#include "scene/models/model_formats.hpp"

namespace gradus::pipeline::model_readers_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

ModelFile model_in(const std::string& bytes, const TextFile& file) {
  const FileReader nothing = [](const std::string&) -> std::optional<LibraryText> { return std::nullopt; };
  return read_model(bytes, file, nothing, {});  // nobody imports
}

std::string refusal_of(const std::string& bytes, const TextFile& file) {
  try {
    model_in(bytes, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The numbers of the positions of a face's corners.
std::vector<int> positions(const ModelFile& m, std::size_t face) {
  std::vector<int> numbers;
  for (const Corner& corner : corners_of(m.mesh, m.mesh.faces.at(face))) numbers.push_back(corner.position);
  return numbers;
}
dvec3 normal(const ModelFile& m, std::size_t face, std::size_t corner) {
  const int number = corners_of(m.mesh, m.mesh.faces.at(face))[corner].normal;
  return m.mesh.normals.at(static_cast<std::size_t>(number));
}

/// The bytes of numbers, the first byte the least significant one.
template <class... Numbers>
std::string bytes_of(Numbers... numbers) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes;
  const auto add = [&bytes](auto number) {
    std::array<char, sizeof number> raw;
    std::memcpy(raw.data(), &number, sizeof number);
    bytes.append(raw.data(), raw.size());
  };
  (add(numbers), ...);
  return bytes;
}

std::string replaced(std::string text, const std::string& from, const std::string& by) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), by);
}

std::string large(std::string text) {
  for (char& c : text)
    if ('a' <= c && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// --- STL

const std::string two_facets =
    "solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1e0\nvertex 1 0 0\nendloop\nendfacet\n"
    "endsolid s\n";

/// Triangles as binary STL has them, each with its normal and 16 bits.
std::string binary_stl(std::uint32_t told, const std::string& header = "gradus") {
  std::string bytes = header;
  bytes.resize(80);
  bytes += bytes_of(told);
  bytes += bytes_of(0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, std::uint16_t{0});
  return bytes + bytes_of(0.f, -1.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, std::uint16_t{0});
}

void expect_two_facets(const ModelFile& m) {
  ASSERT_EQ(m.mesh.faces.size(), 2u);
  EXPECT_THAT(m.mesh.positions, ElementsAre(dvec3{0, 0, 0}, dvec3{1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, 0, 1}));
  EXPECT_THAT(positions(m, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(positions(m, 1), ElementsAre(0, 3, 1)) << "the common edge stands there twice";
  EXPECT_EQ(normal(m, 0, 0), (dvec3{0, 0, 1})) << "made: it had none";
  EXPECT_EQ(normal(m, 1, 2), (dvec3{0, -1, 0}));
}

TEST(Stl, TextInLettersOfAnySize) {
  for (const std::string& text : {two_facets, large(two_facets), "\n  " + two_facets}) {
    const ModelFile m = model_in(text, "m.stl");
    expect_two_facets(m);
    EXPECT_THAT(m.notes, IsEmpty());
  }
  EXPECT_EQ(model_in(two_facets, "m.stl").mesh.faces[1].line, 9);
}

TEST(Stl, BlanksPartWordsAsLineEndsDo) {
  std::string line = two_facets;
  std::ranges::replace(line, '\n', ' ');
  for (const std::string& text : {line, large(line), replaced(line, "solid s", "solid s of a facet plate"),
                                  replaced(line, "solid s", "solid")})
    expect_two_facets(model_in(text, "m.stl"));
  expect_two_facets(model_in(replaced(two_facets, "solid s", "solid #1 s"), "m.stl"));
  const ModelFile two = model_in(line + line, "m.stl");
  EXPECT_EQ(two.mesh.faces.size(), 4u);
  EXPECT_THAT(two.notes, IsEmpty());
  EXPECT_EQ(refusal_of("\n" + replaced(line, "1e0", "1e0x"), "m.stl"),
            "m.stl:2: expected a number for the vertex, found '1e0x'");
}

TEST(Stl, SeveralSolidsLargerLoopsAndNormalsThatAreNone) {
  const std::string square =
      "facet normal nan -nan 1.#QNAN outer loop vertex 0 0 5 vertex 1 0 5 vertex 1 1 5 vertex 0 1 5 endloop "
      "endfacet endsolid\n";
  const ModelFile m = model_in(two_facets + "solid\n" + square, "m.stl");
  ASSERT_EQ(m.mesh.faces.size(), 3u);
  EXPECT_EQ(m.mesh.faces[2].count, 4);
  EXPECT_EQ(normal(m, 2, 0), (dvec3{0, 0, 1}));
}

TEST(Stl, BinaryAlsoWhereItBeginsAsText) {
  expect_two_facets(model_in(binary_stl(2), "m.stl"));
  expect_two_facets(model_in(binary_stl(2, "solid of a program"), "m.STL"));
}

TEST(Stl, BytesBehindTheLastTriangleAreTold) {
  const ModelFile m = model_in(binary_stl(2) + "some more", "m.stl");
  expect_two_facets(m);
  EXPECT_THAT(m.notes, ElementsAre("m.stl: 9 bytes behind its 2 triangles are left out"));
  EXPECT_EQ(model_in(binary_stl(1), "m.stl").mesh.faces.size(), 1u);
}

TEST(Stl, AttributesAndAMissingEndAreTold) {
  std::string coloured = binary_stl(2);
  coloured.back() = 'x';
  EXPECT_THAT(model_in(coloured, "m.stl").notes,
              ElementsAre("m.stl: attributes of triangles, such as their colours, are not used"));
  EXPECT_THAT(model_in(replaced(two_facets, "endsolid s\n", ""), "m.stl").notes,
              ElementsAre("m.stl: it ends without endsolid: something may be missing"));
}

TEST(Stl, RefusedWithItsPlace) {
  EXPECT_EQ(refusal_of(replaced(two_facets, "1e0", "1e0x"), "m.stl"),
            "m.stl:12: expected a number for the vertex, found '1e0x'");
  EXPECT_EQ(refusal_of(replaced(two_facets, "1e0", "nan"), "m.stl"),
            "m.stl:12: expected a finite number for the vertex, found 'nan'");
  EXPECT_EQ(refusal_of(replaced(two_facets, "vertex 0 1 0\n", ""), "m.stl"),
            "m.stl:6: expected a loop of at least 3 vertices, found 2");
  EXPECT_EQ(refusal_of(replaced(two_facets, "endfacet", "endfact"), "m.stl"),
            "m.stl:8: expected endfacet, found 'endfact'");
  EXPECT_EQ(refusal_of(two_facets.substr(0, 77), "m.stl"),
            "m.stl: expected vertex or endloop, found the end of the file");
  EXPECT_EQ(refusal_of("solid empty\nendsolid\n", "m.stl"),
            "m.stl: expected at least one face, found none (0 vertices, 0 points, 0 lines)");
  EXPECT_EQ(refusal_of(binary_stl(3), "m.stl"),
            "m.stl: expected an STL file, a text of solids or binary and whole, found one that tells of 3 "
            "triangles and has 184 bytes");
  std::string far = binary_stl(2);
  far.replace(84 + 50 + 12, 4, bytes_of(1e31f));
  EXPECT_EQ(refusal_of(far, "m.stl"),
            "m.stl: expected coordinates within 1e30 of 0 in triangle 2, found others");
  EXPECT_EQ(refusal_of("topsecret", {"m.stl", false}),
            "m.stl: expected an STL file, a text of solids or binary and whole, found something else");
}

// --- OFF

/// Two squares that share an edge, one with a colour.
const std::string off =
    "OFF # two squares\n6 2 7\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 -1\n1 1 -1\n4 0 1 2 3\n4 1 4 5 2 0.5 0 1\n";

TEST(Off, FacesByTheirVertices) {
  for (const std::string& text : {off, replaced(off, "OFF # two squares\n", "OFF "),
                                  replaced(off, "OFF # two squares\n", "OFF"), replaced(off, "OFF", "")}) {
    const ModelFile m = model_in(text, "m.off");
    ASSERT_EQ(m.mesh.faces.size(), 2u);
    EXPECT_THAT(positions(m, 1), ElementsAre(1, 4, 5, 2));
    EXPECT_NEAR(normal(m, 0, 1).x, std::sqrt(0.5), 1e-12) << "smooth";
    EXPECT_THAT(m.notes, ElementsAre("m.off: colours of vertices and faces are not used"));
  }
  EXPECT_EQ(model_in(off, "m.off").mesh.faces[1].line, 11);
}

TEST(Off, NormalsAndTexturesAsTheHeaderSays) {
  const ModelFile m = model_in(
      "STCNOFF\n3 1 0\n0 0 0 0 1 0 1 0 0 1 0.25 0.5\n1 0 0 0 2 0 1 0 0 1 1 0\n"
      "0 0 1 0 1 0 1 0 0 1 0 1\n3 0 1 2\n",
      "m.off");
  EXPECT_EQ(normal(m, 0, 1), (dvec3{0, 1, 0}));
  EXPECT_EQ(m.mesh.textures.at(0), (dvec2{0.25, 0.5}));
  EXPECT_EQ(corners_of(m.mesh, m.mesh.faces[0])[2].texture, 2);
}

TEST(Off, VerticesThatAreNotThereAreRefusedWithTheirLine) {
  EXPECT_EQ(refusal_of(replaced(off, "4 0 1 2 3", "4 0 1 2 77"), "m.off"),
            "m.off:10: expected one of the 6 vertices, a whole number from 0 to 5, found '77'");
  EXPECT_EQ(refusal_of(replaced(off, "4 0 1 2 3", "4 0 1 2 -1"), "m.off"),
            "m.off:10: expected one of the 6 vertices, a whole number from 0 to 5, found '-1'");
  EXPECT_EQ(refusal_of(replaced(off, "4 0 1 2 3", "4 0 1 2"), "m.off"),
            "m.off:10: expected one of the 6 vertices, a whole number from 0 to 5, found none");
}

TEST(Off, ShortFilesAreRefusedAndLongOnesTold) {
  EXPECT_EQ(refusal_of(replaced(off, "6 2 7", "6 3 7"), "m.off"), "m.off: expected 3 faces, found 2");
  EXPECT_EQ(refusal_of("OFF\n3 1 0\n0 0 0\n", "m.off"), "m.off: expected 3 vertices, found 1");
  EXPECT_EQ(refusal_of("OFF\n", "m.off"),
            "m.off:1: expected the numbers of vertices, faces and edges, found the end of the file");
  EXPECT_EQ(model_in(replaced(off, "6 2 7", "6 1 7"), "m.off").notes.back(),
            "m.off:11: what stands behind the last face is left out");
  for (const char* head : {"4OFF\n", "nOFF\n", "coff\n", "ply\n"})
    EXPECT_THAT(refusal_of(head + off.substr(18), "m.off"), StartsWith("m.off:1: expected an OFF file"));
  EXPECT_THAT(refusal_of("OFF BINARY\n", "m.off"), HasSubstr("found 'BINARY'"));
  EXPECT_EQ(refusal_of("topsecret", {"m.off", false}).find("topsecret"), std::string::npos);
}

// --- PLY

const std::string vertex_rows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 -1\n1 1 -1\n";

std::string ply_head(const std::string& form, const std::string& more_of_vertex = "",
                     const std::string& more_of_face = "", int faces = 2) {
  return "ply\nformat " + form + " 1.0\ncomment made by hand\nelement vertex 6\nproperty float x\n" +
         "property float y\nproperty float32 z\n" + more_of_vertex + "element face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\n" + more_of_face + "end_header\n";
}
const std::string text_ply = ply_head("ascii") + vertex_rows + "4 0 1 2 3\n4 1 4 5 2\n";

void expect_two_squares(const ModelFile& m) {
  ASSERT_EQ(m.mesh.faces.size(), 2u);
  EXPECT_EQ(m.mesh.positions.size(), 6u);
  EXPECT_EQ(m.mesh.positions.at(4), (dvec3{1, 0, -1}));
  EXPECT_EQ(m.mesh.faces[0].material, 0) << "the default";
  EXPECT_THAT(positions(m, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(positions(m, 1), ElementsAre(1, 4, 5, 2));
  EXPECT_NEAR(normal(m, 0, 1).x, std::sqrt(0.5), 1e-12) << "smooth: at the shared edge the mean of both";
}

/// The same in bytes. first: whether the least significant one comes first.
std::string binary_ply(bool first) {
  std::string rows;
  const auto add = [&](auto number) {
    std::string raw = bytes_of(number);
    if (!first) std::ranges::reverse(raw);
    rows += raw;
  };
  for (const auto& p :
       std::vector<std::array<float, 3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, -1}, {1, 1, -1}})
    for (const float part : p) add(part);
  for (const auto& face : {std::array{0, 1, 2, 3}, {1, 4, 5, 2}}) {
    rows += '\4';
    for (const int corner : face) add(corner);
  }
  return ply_head(first ? "binary_little_endian" : "binary_big_endian") + rows;
}

TEST(Ply, TextAndBothBinaryForms) {
  const ModelFile text = model_in(text_ply, "m.ply");
  expect_two_squares(text);
  EXPECT_EQ(text.mesh.faces[1].line, 18);
  for (const bool first : {true, false}) expect_two_squares(model_in(binary_ply(first), "m.ply"));
  std::string returns = text_ply;
  for (std::size_t at = 0; (at = returns.find('\n', at)) != std::string::npos; at += 2)
    returns.replace(at, 1, "\r\n");
  expect_two_squares(model_in(returns, "m.ply"));
}

TEST(Ply, NumbersOfAllTypes) {
  const std::string types =
      "property char a\nproperty uint8 b\nproperty short c\nproperty uint16 d\nproperty int e\nproperty "
      "uint32 "
      "f\nproperty double g\nproperty list uint8 int16 h\n";
  std::string head = ply_head("binary_little_endian", types, "", 1);
  head = replaced(head, "element vertex 6", "element vertex 3");
  head = replaced(head, "list uchar int vertex_indices", "list int32 ushort vertex_index");
  const std::string skipped = bytes_of(std::int8_t{-1}, std::uint8_t{1}, std::int16_t{1}, std::uint16_t{1}, 1,
                                       1u, 1.0, std::uint8_t{2}, std::int16_t{7}, std::int16_t{8});
  std::string rows;
  for (const auto& [x, y] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {0.f, 1.f}})
    rows += bytes_of(x, y, 0.f) + skipped;
  rows += bytes_of(3, std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{2});
  const ModelFile m = model_in(head + rows, "m.ply");
  EXPECT_THAT(positions(m, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(m.notes, ElementsAre("m.ply: 'a' of vertices, 'b' of vertices, 'c' of vertices, 'd' of "
                                   "vertices, 'e' of vertices, 'f' of vertices, 'g' of vertices, 'h' of "
                                   "vertices are not used"));
}

TEST(Ply, IndicesOfVerticesThatAreNotThere) {
  EXPECT_EQ(refusal_of(replaced(text_ply, "4 0 1 2 3", "255 0 1 2"), "m.ply"),
            "m.ply:17: expected the number of a vertex, a whole number from 0 to 5, found none");
  EXPECT_EQ(refusal_of(replaced(text_ply, "4 0 1 2 3", "4 0 1 2 77"), "m.ply"),
            "m.ply:17: expected the number of a vertex, a whole number from 0 to 5, found '77'");
  EXPECT_EQ(refusal_of(replaced(text_ply, "4 0 1 2 3", "4 0 1 2 -1"), "m.ply"),
            "m.ply:17: expected the number of a vertex, a whole number from 0 to 5, found '-1'");
  for (const bool first : {true, false}) {
    std::string far = binary_ply(first);
    far[far.size() - 17 - (first ? 4 : 1)] = 77;  // the last corner of the first face
    EXPECT_EQ(refusal_of(far, "m.ply"),
              "m.ply: row 1 of face: expected the number of a vertex, a whole number from 0 to 5, found 77");
  }
}

TEST(Ply, RowsThatAreTooShortOrTooLong) {
  EXPECT_EQ(refusal_of(replaced(text_ply, "\n1 1 0\n", "\n1 1\n"), "m.ply"),
            "m.ply:13: expected a number for z, found none");
  EXPECT_EQ(refusal_of(replaced(text_ply, "\n1 1 0\n", "\n1 1 0 0\n"), "m.ply"),
            "m.ply:13: expected nothing after the properties that the header tells of, found '0'");
  EXPECT_EQ(refusal_of(replaced(text_ply, "element face 2", "element face 3"), "m.ply"),
            "m.ply: expected 3 rows of face, found 2");
  EXPECT_EQ(model_in(replaced(text_ply, "element face 2", "element face 1"), "m.ply").notes.back(),
            "m.ply:18: what stands behind the last row is left out");
  const std::string binary = binary_ply(true);
  EXPECT_EQ(refusal_of(binary.substr(0, binary.size() - 1), "m.ply"),
            "m.ply: row 2 of face: expected 2 rows of it, found the end of the file");
  EXPECT_THAT(model_in(binary + "??", "m.ply").notes,
              ElementsAre("m.ply: 2 bytes behind the last row are left out"));
}

TEST(Ply, NumbersThatAreNone) {
  EXPECT_EQ(refusal_of(replaced(text_ply, "\n1 1 0\n", "\n1 nan 0\n"), "m.ply"),
            "m.ply:13: expected a finite number of at most 1e+30 for y, found one that is not finite");
  EXPECT_EQ(refusal_of(replaced(text_ply, "\n1 1 0\n", "\n1 2e30 0\n"), "m.ply"),
            "m.ply:13: expected a number of at most 1e+30 for y, found '2e30'");
  std::string far = binary_ply(true);
  far.replace(far.find("end_header\n") + 11, 4, bytes_of(-1e31f));
  EXPECT_EQ(refusal_of(far, "m.ply"),
            "m.ply: row 1 of vertex: expected a finite number of at most 1e+30 for x, found a larger one");
}

TEST(Ply, NormalsTexturesAndAPicture) {
  const std::string head =
      replaced(ply_head("ascii",
                        "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty "
                        "float t\n",
                        "property list uchar float texcoord\n"),
               "comment made by hand", "comment TextureFile my wood.png");
  const std::string text = head +
                           "0 0 0 0 0 2 0 0\n1 0 0 nan nan nan 1 0\n1 1 0 0 0 2 1 1\n0 1 0 0 0 2 0 1\n"
                           "1 0 -1 0 0 2 0 0\n1 1 -1 0 0 2 0 0\n4 0 1 2 3 0\n4 1 4 5 2 8 0 0 .5 0 .5 1 0 1\n";
  const ModelFile m = model_in(text, "m.ply");
  EXPECT_EQ(normal(m, 0, 0), (dvec3{0, 0, 1}));
  EXPECT_NEAR(normal(m, 0, 1).x, std::sqrt(0.5), 1e-12) << "made";
  const auto texture = [&m](std::size_t face, std::size_t corner) {
    const int number = corners_of(m.mesh, m.mesh.faces[face])[corner].texture;
    return m.mesh.textures.at(static_cast<std::size_t>(number));
  };
  EXPECT_EQ(texture(0, 2), (dvec2{1, 1}));
  EXPECT_EQ(texture(1, 1), (dvec2{0.5, 0})) << "a corner's own";
  const Material& worn = m.mesh.materials.at(static_cast<std::size_t>(m.mesh.faces[0].material));
  EXPECT_EQ(worn.diffuse_map.file, "my wood.png");
  EXPECT_EQ(worn.diffuse_map.place, "m.ply:3: TextureFile 'my wood.png'");
  EXPECT_THAT(m.notes, IsEmpty());
  EXPECT_EQ(refusal_of(replaced(text, "8 0 0 .5 0 .5 1 0 1", "6 0 0 .5 0 .5 1"), "m.ply"),
            "m.ply:24: expected texcoord of 4 pairs, found 3");
}

TEST(Ply, StripsTurnRoundEverySecondTime) {
  const std::string text = replaced(ply_head("ascii", "", "", 1), "element face", "element tristrips") +
                           vertex_rows + "9 0 1 3 2 -1 1 4 2 5\n";
  const ModelFile m = model_in(text, "m.ply");
  ASSERT_EQ(m.mesh.faces.size(), 4u);
  EXPECT_THAT(positions(m, 0), ElementsAre(0, 1, 3));
  EXPECT_THAT(positions(m, 1), ElementsAre(3, 1, 2));
  EXPECT_THAT(positions(m, 2), ElementsAre(1, 4, 2));
  EXPECT_THAT(positions(m, 3), ElementsAre(2, 4, 5));
}

TEST(Ply, WhatIsNotUsedIsToldInOneRemark) {
  const std::string head = ply_head(
      "ascii", "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float confidence\n",
      "property int flags\n");
  std::string rows;
  for (std::size_t at = 0; at < vertex_rows.size(); at += vertex_rows.find('\n', at) - at + 1)
    rows += vertex_rows.substr(at, vertex_rows.find('\n', at) - at) + " 255 0 0 nan\n";
  const std::string camera = "element camera 1\nproperty float view\nend_header\n";
  EXPECT_THAT(
      model_in(replaced(head, "end_header\n", camera) + rows + "4 0 1 2 3 9\n4 1 4 5 2 9\n1\n", "m.ply")
          .notes,
      ElementsAre("m.ply: colours of vertices, 'confidence' of vertices, 'flags' of faces, element "
                  "'camera' are not used"));
}

TEST(Ply, HeadersThatAreNone) {
  EXPECT_EQ(refusal_of("", "m.ply"),
            "m.ply: expected a PLY file, which begins with ply, found something else");
  EXPECT_EQ(refusal_of("ply\nformat ascii 1.0\n", "m.ply"),
            "m.ply: expected the line end_header, found the end of the file");
  EXPECT_EQ(
      refusal_of(replaced(text_ply, "ascii", "ebcdic"), "m.ply"),
      "m.ply:2: expected ascii 1.0, binary_little_endian 1.0, binary_big_endian 1.0, found 'ebcdic 1.0'");
  EXPECT_EQ(refusal_of(replaced(text_ply, "float32", "single"), "m.ply"),
            "m.ply:7: expected a type of numbers like float, found 'single'");
  EXPECT_EQ(refusal_of(replaced(text_ply, "float32 z", "float x"), "m.ply"),
            "m.ply:7: expected each property once, found 'x' again");
  EXPECT_EQ(refusal_of(replaced(text_ply, "float32 z", "float w"), "m.ply"),
            "m.ply: expected the properties x, y and z of vertex, found less than these");
  EXPECT_EQ(refusal_of(replaced(text_ply, "vertex_indices", "corners"), "m.ply"),
            "m.ply: expected the list vertex_indices of face, found none");
  EXPECT_EQ(refusal_of(replaced(text_ply, "list uchar", "list float"), "m.ply"),
            "m.ply:9: expected a list that is counted by whole numbers, found one counted by others");
  EXPECT_EQ(refusal_of(replaced(text_ply, "element vertex 6", "element vertices 6"), "m.ply"),
            "m.ply: expected an element vertex, found none");
  EXPECT_EQ(
      refusal_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
                 "float z\nend_header\n0 0 0\n",
                 "m.ply"),
      "m.ply: expected at least one face, found none (1 vertices, 0 points, 0 lines)");
  std::string many = "ply\nformat ascii 1.0\nelement vertex 6\n";
  for (int i = 0; i < 1001; ++i) many += "property float p" + std::to_string(i) + "\n";
  EXPECT_EQ(refusal_of(many + "end_header\n", "m.ply"),
            "m.ply:1004: expected at most 1000 properties of an element, found one more");
  EXPECT_EQ(refusal_of("ply\ntopsecret", {"m.ply", false}).find("topsecret"), std::string::npos);
}

}  // namespace
}  // namespace gradus::pipeline::model_readers_test
