// Models by Assimp: what becomes of hierarchies, normals, texture coordinates and materials, and what is
// refused.

#include "cli/models/imported_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "cli/models/gltf_data.hpp"
#include "core/refusal.hpp"

namespace gradus::cli {
namespace {

using pipeline::LibraryText;
using pipeline::ModelFile;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Files beside a model, and which of them were asked for.
struct Shelf {
  std::map<std::string, std::string> files;
  std::vector<std::string> asked;

  pipeline::FileReader reader() {
    return [this](const std::string& name) -> std::optional<LibraryText> {
      asked.push_back(name);
      const auto found = files.find(name);
      return found == files.end() ? std::nullopt : std::optional(LibraryText(found->second));
    };
  }
};

ModelFile model_in(const std::string& text, const pipeline::TextFile& file, Shelf shelf = {}) {
  return read_model(text, file, shelf.reader(), model_importer());
}

std::string replaced_in(std::string text, const std::string& from, const std::string& by) {
  return text.replace(text.find(from), from.size(), by);
}

std::string refusal_of(const std::string& text, const pipeline::TextFile& file, Shelf shelf = {}) {
  try {
    model_in(text, file, std::move(shelf));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// DirectX text without normals: two squares that share an edge.
const std::string two_squares =
    "xof 0303txt 0032\nMesh m {\n6;\n0;0;0;,\n1;0;0;,\n1;1;0;,\n0;1;0;,\n1;0;-1;,\n1;1;-1;;\n"
    "2;\n4;0,1,2,3;,\n4;1,4,5,2;;\n}\n";

/// A glTF file of a triangle, (0, 0, 0), (1, 0, 0), (0, 1, 0), with texture coordinates as they are, and
/// these nodes and further keys.
std::string gltf(const std::string& nodes, const std::string& more = R"(, "materials": [{}])") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + nodes + R"(],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "buffers": [{"byteLength": 60, "uri": "b.bin"}])" +
         more + "}";
}
Shelf buffer() {
  const float numbers[15]{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0, 1, 1};
  return {{{"b.bin", {reinterpret_cast<const char*>(numbers), sizeof numbers}}}, {}};
}

dvec3 corner(const ModelFile& m, std::size_t face, std::size_t i) {
  return position_of(m.mesh, corners_of(m.mesh, m.mesh.faces[face])[i]);
}

TEST(ImportedModel, PolygonsStayAndSharedPlacesAreOne) {
  const ModelFile m = model_in(two_squares, "m.x");
  ASSERT_EQ(m.mesh.faces.size(), 2u);
  EXPECT_EQ(m.mesh.faces[1].count, 4);
  EXPECT_EQ(m.mesh.positions.size(), 6u);
  EXPECT_THAT(m.mesh.files, ElementsAre("m.x"));
  EXPECT_EQ(m.mesh.faces[0].line, 0) << "nobody knows it";
  // Smooth: at the shared edge the mean of both
  const Corner& shared = corners_of(m.mesh, m.mesh.faces[0])[1];
  EXPECT_NEAR(m.mesh.normals[static_cast<std::size_t>(shared.normal)].x, std::sqrt(0.5), 1e-12);
}

TEST(ImportedModel, NodesAreMultipliedOut) {
  const std::string nodes =
      R"({"children": [1, 2], "translation": [1, 0, 0]}, {"mesh": 0, "scale": [2, 2, 2]}, {"mesh": 0, "scale": [1, 1, -1], "translation": [0, 5, 0]})";
  const ModelFile m = model_in(gltf(nodes), "m.gltf", buffer());
  ASSERT_EQ(m.mesh.faces.size(), 2u);
  EXPECT_EQ(corner(m, 0, 1), (dvec3{3, 0, 0}));
  // Mirrored in z, so that it is seen from -z and its corners run the other way
  EXPECT_EQ(corner(m, 1, 1), (dvec3{1, 6, 0}));
  EXPECT_EQ(corner(m, 1, 2), (dvec3{2, 5, 0}));
  const auto normal = [&](std::size_t face) {
    return m.mesh.normals[static_cast<std::size_t>(corners_of(m.mesh, m.mesh.faces[face])[0].normal)];
  };
  EXPECT_EQ(normal(0), (dvec3{0, 0, 1}));
  EXPECT_EQ(normal(1), (dvec3{0, 0, -1}));
}

TEST(ImportedModel, TextureCoordinatesGoUp) {
  const ModelFile m = model_in(gltf(R"({"mesh": 0})"), "m.gltf", buffer());
  const Corner& second = corners_of(m.mesh, m.mesh.faces[0])[1];
  EXPECT_EQ(m.mesh.textures[static_cast<std::size_t>(second.texture)], (dvec2{0.25, 1}));
}

const Material& worn(const ModelFile& m) {
  return m.mesh.materials[static_cast<std::size_t>(m.mesh.faces[0].material)];
}

TEST(ImportedModel, MaterialsAndPicturesInside) {
  const std::string look =
      R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 0.75], "baseColorTexture": {"index": 0}})";
  const std::string more =
      R"(, "textures": [{"source": 0}], "images": [{"uri": "data:image/png;base64,R3JhZHVz"}], "materials": [{"name": "glass", "alphaMode": "BLEND", )" +
      look + "}]";
  const ModelFile m = model_in(gltf(R"({"mesh": 0})", more), "m.gltf", buffer());
  EXPECT_EQ(worn(m).name, "glass");
  EXPECT_EQ(worn(m).diffuse, (LinearRgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(worn(m).ambient, worn(m).diffuse);
  EXPECT_EQ(worn(m).specular, LinearRgb{0});
  EXPECT_EQ(worn(m).opacity, 0.75f);
  ASSERT_EQ(m.pictures.size(), 1u);
  EXPECT_EQ(m.pictures.at(worn(m).diffuse_map.file), "Gradus");
  const std::string opaque =
      R"(, "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]}}])";
  EXPECT_EQ(worn(model_in(gltf(R"({"mesh": 0})", opaque), "m.gltf", buffer())).opacity, 1) << "no BLEND";
}

TEST(ImportedModel, NamesInUris) {
  EXPECT_EQ(name_in_uri("my%20wood%2epng"), "my wood.png");
  EXPECT_EQ(name_in_uri("100%"), "100%");
  EXPECT_EQ(name_in_uri("%zz%2"), "%zz%2");
  EXPECT_EQ(name_in_uri("a%00b%0a"), "a%00b%0a") << "nothing that ends a name or a line";
}

TEST(ImportedModel, FilesBesideAreAskedForByTheirNames) {
  Shelf shelf = buffer();
  read_model(gltf(R"({"mesh": 0})"), "some/folder/m.gltf", shelf.reader(), model_importer());
  EXPECT_THAT(shelf.asked, ElementsAre("b.bin"));
  EXPECT_EQ(refusal_of(gltf(R"({"mesh": 0})"), "m.gltf"),
            "m.gltf: expected the file 'b.bin' beside it, found none");
  Shelf broken = buffer();
  broken.files.at("b.bin").resize(30);
  EXPECT_EQ(refusal_of(gltf(R"({"mesh": 0})"), "m.gltf", broken),
            "m.gltf:6: expected a buffer of 60 bytes, found one of 30");
}

TEST(ImportedModel, RefusedInOneLine) {
  for (const char* name : {"m.ply", "m.stl", "m.glb", "m.fbx", "m.dae", "m.3ds", "m.x"}) {
    for (const std::string text : {"", "This is\nno \x1b[31mmodel", "\x01\x02\x03"}) {
      const std::string problem = refusal_of(text, name);
      EXPECT_THAT(problem, StartsWith(std::string(name) + ":"));
      EXPECT_THAT(problem, HasSubstr(": expected a"));
      EXPECT_EQ(problem.find_first_of("\n\x1b"), std::string::npos) << problem;
    }
  }
  EXPECT_THAT(refusal_of(replaced_in(two_squares, "1;0;-1", "2e30;0;-1"), "m.x"),
              HasSubstr(": expected coordinates within 1e30 of 0, found 2"));
  EXPECT_EQ(refusal_of("topsecret", {"m.fbx", false}),
            "m.fbx: expected a model of this format, found another or a damaged one");
}

}  // namespace
}  // namespace gradus::cli
