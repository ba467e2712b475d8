// Material libraries: keywords as programs write them, how textures are laid on, and what is told that no
// picture shows.

#include "scene/models/materials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/obj_text.hpp"

namespace gradus::pipeline::materials_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<LibraryMaterial> read(const std::string& text, std::vector<std::string>& notes) {
  return parse_mtl(text, "m.mtl", notes);
}
std::vector<std::string> notes_of(const std::string& text) {
  std::vector<std::string> notes;
  read("newmtl a\n" + text, notes);
  return notes;
}

TEST(Mtl, KeywordsInLettersOfAnySize) {
  std::vector<std::string> notes;
  const auto materials =
      read("NEWMTL a\nkd 1 0 0\nKS .5\nns 7\ntr .25\nMAP_KD Wood.png\nnewmtl b\nmap_kd wood.png\n", notes);
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0].diffuse, (LinearRgb{1, 0, 0}));
  EXPECT_EQ(materials[0].specular, LinearRgb{0.5f});
  EXPECT_EQ(materials[0].shininess, 7);
  EXPECT_EQ(materials[0].opacity, 0.75f);
  EXPECT_EQ(materials[0].diffuse_map.file, "Wood.png");
  EXPECT_EQ(materials[1].diffuse_map.file, "wood.png");
  EXPECT_THAT(notes, IsEmpty());
}

TEST(Mtl, ScaleAndOffsetOfATexture) {
  std::vector<std::string> notes;
  const auto placement = [&notes](const std::string& options) {
    return read("newmtl a\nmap_Kd " + options + " my wood.png\n", notes).at(0).placement;
  };
  EXPECT_EQ(placement(""), (TexturePlacement{{1, 1}, {0, 0}}));
  EXPECT_EQ(placement("-s 2 3 4 -o 0.5 -0.25 9"), (TexturePlacement{{2, 3}, {0.5, -0.25}}));
  EXPECT_EQ(placement("-O 0.5 -S 2"), (TexturePlacement{{2, 1}, {0.5, 0}}));
  EXPECT_EQ(read("newmtl a\nmap_Kd -s 2 -o 1 my wood.png\n", notes).at(0).diffuse_map.file, "my wood.png");
  EXPECT_THAT(notes, IsEmpty());
}

/// The texture coordinates of a face's corners.
std::vector<dvec2> textures(const ModelFile& m, std::size_t face) {
  std::vector<dvec2> found;
  for (const Corner& corner : corners(m, face))
    found.push_back(m.mesh.textures.at(static_cast<std::size_t>(corner.texture)));
  return found;
}

TEST(Mtl, FacesWearATextureAsItsMaterialLaysItOn) {
  const Files files{{"m.mtl", "newmtl a\nmap_Kd -s 2 4 -o 0.5 -1 p.png\nnewmtl b\nmap_Kd p.png\n"}};
  // The library may come behind the faces, and two materials may share texture coordinates
  const ModelFile m = parse(
      square + "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nmtllib m.mtl\nusemtl a\nf 3/3 4/1 1/1\n",
      files);
  EXPECT_THAT(textures(m, 0), ElementsAre(dvec2{0.5, -1}, dvec2{2.5, -1}, dvec2{2.5, 3}));
  EXPECT_THAT(textures(m, 1), ElementsAre(dvec2{0, 0}, dvec2{1, 0}, dvec2{1, 1}));
  EXPECT_THAT(textures(m, 2), ElementsAre(dvec2{2.5, 3}, dvec2{0.5, -1}, dvec2{0.5, -1}));
  EXPECT_EQ(m.mesh.textures.size(), 6u) << "the file's three, and three of material a";
}

TEST(Mtl, WhatIsNotDrawnIsToldInOneRemark) {
  EXPECT_THAT(notes_of("map_Kd -clamp on p.png\n"), ElementsAre("m.mtl:2: -clamp of map_Kd is not drawn"));
  EXPECT_THAT(
      notes_of("Kd 1 1 1\nillum 3\nmap_Kd -mm 0.1 2 -t 0.5 p.png\nbump -bm 1 b.png\nmap_Ks k.png\n"
               "Pr 0.5\nTf .5 .5 .5\nBump again.png\nbump a third.png\n"),
      ElementsAre("m.mtl:3: illum above 2, -mm of map_Kd, -t of map_Kd, bump, map_Ks, Pr, Tf, Bump are "
                  "not drawn"));
  EXPECT_THAT(
      notes_of("map_Kd -clamp off -blendu on -blendv ON -cc off -mm 0 1 -t 0 0 0 p.png\nNi 1.45\nTf 1 1 1\n"
               "Pr 0\nillum 2\nsharpness 60\n"),
      IsEmpty())
      << "what changes nothing";
  std::vector<std::string> notes;
  parse_mtl("newmtl a\nmap_topsecret x\n", {"m.mtl", false}, notes);
  EXPECT_THAT(notes, ElementsAre("m.mtl:2: another map is not drawn"));
}

TEST(Obj, ColoursOfVerticesAreToldOnce) {
  const std::string coloured = "v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
  EXPECT_THAT(parse(coloured).notes, ElementsAre("m.obj:2: colours of vertices are not used"));
  EXPECT_THAT(parse("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").notes, IsEmpty()) << "weights";
}

}  // namespace
}  // namespace gradus::pipeline::materials_test
