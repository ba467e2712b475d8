// OBJ and MTL: all forms that are read, and all that is refused with file and line.

#include "scene/models/obj.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/files.hpp"
#include "scene/models/materials.hpp"
#include "scene/models/obj_notes.hpp"
#include "support/obj_text.hpp"

namespace gradus::pipeline::obj_test {
namespace {

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
  // Weights and colours are checked and not used, colours told
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
}  // namespace gradus::pipeline::obj_test
