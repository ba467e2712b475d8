// Scenes from JSON: where objects come to stand, what cameras and lights are told, and which line and key a
// mistake is blamed on. tests/golden/scene_test.py has the scenes that are shipped and their schema.

#include "scene/scene_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <random>

#include "core/colour.hpp"
#include "core/refusal.hpp"
#include "scene/files.hpp"
#include "support/seed.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::scene_file_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// Finds body.obj and sheet.obj, and counts how often each is asked for.
struct Shelf {
  std::map<std::string, int> asked;

  ModelFinder finder() {
    return [this](const std::string& name) -> std::optional<FoundModel> {
      ++asked[name];
      const FileReader none = [](const std::string&) { return std::nullopt; };
      if (name == "body.obj") return FoundModel{std::string(tetrahedron), "shelf/body.obj", none};
      if (name == "sheet.obj")
        return FoundModel{std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "shelf/sheet.obj", none};
      if (name == "bad.obj") return FoundModel{std::string("v 1\n"), "shelf/bad.obj", none};
      return std::nullopt;
    };
  }
};

SceneFile scene_in(const std::string& text) { return parse_scene(text, "s.json", Shelf().finder(), {}); }

/// A scene with these members beside its objects.
SceneFile scene_with(const std::string& members) {
  return scene_in(fmt::format(R"({{"objects": [{{"model": "body.obj"}}], {}}})", members));
}

std::string complaint(const std::string& text) {
  try {
    scene_in(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(no complaint)";
}
std::string complaint_of_object(const std::string& members) {
  return complaint(fmt::format(
      "{{\"objects\": [\n{{\"model\": \"body.obj\"}},\n{{\"model\": \"body.obj\", {}}}]}}", members));
}

glm::dmat4 placement(const std::string& place) {
  return scene_in(fmt::format(R"({{"objects": [{{"model": "body.obj", "place": {}}}]}})", place))
      .scene.objects.at(0)
      .placement;
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double most = 0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) most = std::max(most, std::abs(a[c][r] - b[c][r]));
  }
  return most;
}

TEST(SceneFile, TransformationsActOneAfterTheOther) {
  const glm::dmat4 m = placement(
      R"([{"scale": [1, 2, 3]}, {"rotate": {"axis": [1, 1, 0], "degrees": 50}}, {"translate": [4, 5, 6]}])");
  const glm::dmat4 one(1);
  const glm::dmat4 expected = glm::translate(one, dvec3{4, 5, 6}) *
                              glm::rotate(one, glm::radians(50.0), glm::normalize(dvec3{1, 1, 0})) *
                              glm::scale(one, dvec3{1, 2, 3});
  EXPECT_LT(difference(m, expected), 1e-14);
}

TEST(SceneFile, RandomPlacesAreGlmsProducts) {
  const std::uint64_t start = test::seed();
  SCOPED_TRACE("GRADUS_SEED=" + std::to_string(start));
  std::mt19937_64 random(start);
  std::uniform_real_distribution<double> real(-2, 2);
  for (int i = 0; i < 300; ++i) {
    glm::dmat4 expected(1);
    std::string place;
    const int count = static_cast<int>(random() % 5);
    for (int k = 0; k < count; ++k) {
      const dvec3 v{real(random), real(random), real(random)};
      const std::string list = fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
      place += place.empty() ? "" : ", ";
      const glm::dmat4 one(1);
      if (random() % 3 == 0) {
        place += fmt::format(R"({{"translate": {}}})", list);
        expected = glm::translate(one, v) * expected;
      } else if (random() % 2 == 0) {
        place += fmt::format(R"({{"scale": {}}})", list);
        expected = glm::scale(one, v) * expected;
      } else {
        const double degrees = 200 * real(random);
        place += fmt::format(R"({{"rotate": {{"axis": {}, "degrees": {}}}}})", list, degrees);
        expected = glm::rotate(one, glm::radians(degrees), glm::normalize(v)) * expected;
      }
    }
    ASSERT_LT(difference(placement("[" + place + "]"), expected), 1e-12) << place;
  }
}

TEST(SceneFile, RotationsAboutAPointLeaveItWhereItIs) {
  const glm::dmat4 m = placement(R"({"rotate": {"axis": [0, 0, 1], "degrees": 90, "about": [1, 2, 0]}})");
  EXPECT_LT(length_of(affine_3d::transform(m, {1, 2, 5}) - dvec3(1, 2, 5)), 1e-15);
  EXPECT_LT(length_of(affine_3d::transform(m, {2, 2, 5}) - dvec3(1, 3, 5)), 1e-15);
}

TEST(SceneFile, MatricesAreRowsAsPrinted) {
  const std::string rows = "[[1, 2, 3, 4], [0, 1, 5, 6], [0, 0, 1, 7]";
  const glm::dmat4 three = placement("{\"matrix\": " + rows + "]}");
  EXPECT_EQ(affine_3d::transform(three, dvec3{1, 1, 1}), (dvec3{10, 12, 8}));
  EXPECT_EQ(placement("{\"matrix\": " + rows + ", [0, 0, 0, 1]]}"), three);
}

TEST(SceneFile, InstancesStandAtTheirPlacesAfterTheObjects) {
  Shelf shelf;
  const SceneFile file = parse_scene(
      R"({"objects": [{"name": "n", "model": "body.obj", "place": {"scale": 2},
           "instances": [{"translate": [1, 0, 0]}, []]}, {"model": "body.obj"}, {"model": "sheet.obj"}]})",
      "s.json", shelf.finder(), {});
  const std::vector<Object>& objects = file.scene.objects;
  ASSERT_EQ(objects.size(), 4u);
  EXPECT_EQ(affine_3d::transform(objects[0].placement, dvec3{1, 1, 1}), (dvec3{3, 2, 2}));
  EXPECT_EQ(affine_3d::transform(objects[1].placement, dvec3{1, 1, 1}), (dvec3{2, 2, 2}));
  EXPECT_EQ(objects[1].name, "n");
  EXPECT_EQ(objects[2].name, "body.obj");
  EXPECT_EQ(shelf.asked["body.obj"], 1) << "each model is read once";
  EXPECT_EQ(objects[0].mesh, objects[2].mesh) << "and shared";
  EXPECT_FALSE(objects[0].two_sided) << "a body";
  EXPECT_TRUE(objects[3].two_sided) << "a sheet";
}

TEST(SceneFile, MirroredBodiesKeepTheirOutsides) {
  const SceneFile file = scene_in(R"({"objects": [{"model": "body.obj", "place": {"scale": [1, 1, -1]}}]})");
  EXPECT_TRUE(affine_3d::mirrors(file.scene.objects[0].placement));
  EXPECT_FALSE(file.scene.objects[0].two_sided);
}

TEST(SceneFile, AMaterialReplacesAllOthers) {
  const SceneFile file =
      scene_in(R"({"objects": [{"model": "body.obj", "material": {"diffuse": "#ff8000", "shininess": 7}}]})");
  const Mesh& mesh = *file.scene.objects[0].mesh;
  for (const MeshFace& face : mesh.faces) EXPECT_EQ(face.material, 1);
  const Material& material = mesh.materials.at(1);
  EXPECT_EQ(material.diffuse, linear_from_srgb8({255, 128, 0}));
  EXPECT_EQ(material.ambient, material.diffuse);
  EXPECT_EQ(material.shininess, 7.0f);
}

TEST(SceneFile, CamerasAreToldByAngleOrByLens) {
  const auto radians = [](const std::string& camera) {
    return scene_with("\"camera\": {" + camera + "}").view.vertical_radians;
  };
  EXPECT_DOUBLE_EQ(radians("\"fov\": 60"), glm::radians(60.0));
  EXPECT_DOUBLE_EQ(radians("\"focal\": 12, \"sensor\": 24"), glm::radians(90.0));
  EXPECT_DOUBLE_EQ(radians("\"eye\": [1, 2, 3]"), View{}.vertical_radians);
  const SceneFile file = scene_with(
      R"("camera": {"eye": [1, 2, 3], "target": [4, 5, 6], "up": [0, 0, 2], "near": 0.5, "far": 9})");
  EXPECT_EQ(file.view.eye, (dvec3{1, 2, 3}));
  EXPECT_EQ(file.view.target, (dvec3{4, 5, 6}));
  EXPECT_EQ(file.view.up, (dvec3{0, 0, 2}));
  EXPECT_EQ(file.depths, (dvec2{0.5, 9}));
}

TEST(SceneFile, LightsOfAllKinds) {
  const SceneFile file = scene_with(R"("lights": [
    {"kind": "point", "position": [1, 2, 3], "attenuation": [1, 0.5, 0.25], "range": 8, "intensity": [1, 2, 3]},
    {"kind": "directional", "direction": [0, -3, 0]},
    {"kind": "spot", "position": [1, 1, 1], "target": [1, 0, 1], "outer": 60, "inner": 30, "concentration": 2},
    {"kind": "area", "position": [0, 9, 0], "across": [1, 0, 0], "along": [0, 0, 1], "samples": 3}])");
  ASSERT_TRUE(file.lights_told);
  const std::vector<Light>& lights = file.scene.lights;
  ASSERT_EQ(lights.size(), 4u);
  EXPECT_EQ(lights[0].kind, Light::Kind::point);
  EXPECT_EQ(dvec3(lights[0].constant, lights[0].linear, lights[0].quadratic), dvec3(1, 0.5, 0.25));
  EXPECT_EQ(lights[0].range, 8);
  EXPECT_EQ(lights[0].intensity, LinearRgb(1, 2, 3));
  EXPECT_EQ(lights[1].direction, dvec3(0, -3, 0));
  EXPECT_EQ(lights[2].direction, dvec3(0, -1, 0));
  EXPECT_NEAR(lights[2].outer_cosine, 0.5, 1e-15);
  EXPECT_NEAR(lights[2].inner_cosine, std::sqrt(0.75), 1e-15);
  EXPECT_EQ(lights[2].concentration, 2);
  EXPECT_EQ(lights[3].samples, 3);
  EXPECT_FALSE(scene_with("\"samples\": 4").lights_told);
}

TEST(SceneFile, HowItIsDrawn) {
  const SceneFile file = scene_with(
      R"("size": [64, 48], "background": "#000000", "ambient": [0, 0.5, 1], "shading": "flat",
         "filter": "nearest", "aa": "supersampling", "samples": 9)");
  EXPECT_EQ(file.size, (ivec2{64, 48}));
  EXPECT_EQ(file.scene.background, LinearRgb(0));
  EXPECT_EQ(file.scene.ambient, LinearRgb(0, 0.5f, 1));
  EXPECT_EQ(file.scene.shading, Shading::flat);
  EXPECT_EQ(file.scene.filter, TextureFilter::nearest);
  EXPECT_EQ(file.scene.antialiasing, Antialiasing::supersampling);
  EXPECT_EQ(file.scene.samples, 9);
}

TEST(SceneFile, MistakesAreBlamedOnTheirLineAndKey) {
  EXPECT_EQ(complaint("[]"),
            "s.json:1: /: expected an object with $schema, size, background, ambient, shading, "
            "hidden_surfaces, culling, "
            "filter, aa, samples, camera, lights, objects, found an empty list");
  EXPECT_EQ(complaint("{\n}"), "s.json:1: /: expected a key 'objects', found none");
  EXPECT_THAT(complaint("{\"objects\": []}"), HasSubstr("/objects: expected a list of at least one object"));
  EXPECT_THAT(complaint("{\n\"objetcs\": []}"),
              StartsWith("s.json:2: /: expected one of the keys $schema, "));
  EXPECT_EQ(complaint("{\"objects\": [\n{\"model\": \"none.obj\"}]}"),
            "s.json:2: /objects/0/model: expected the name of a file that is there, found 'none.obj'");
  EXPECT_THAT(complaint("{\"objects\": [{\"model\": \"bad.obj\"}]}"), StartsWith("shelf/bad.obj:1: "));
  EXPECT_EQ(complaint_of_object("\"place\": [{\"scale\": 1},\n{\"translate\": [1, \"2\", 3]}]"),
            "s.json:4: /objects/1/place/1/translate/1: expected a number of at most 1e30 in size, found '2'");
  EXPECT_EQ(complaint_of_object("\"place\": {\"scale\": 0}"),
            "s.json:3: /objects/1/place/scale: expected factors of at least 1e-30 in size, found 0");
  EXPECT_THAT(complaint_of_object("\"place\": {\"scale\": 1, \"translate\": [1, 2, 3]}"),
              HasSubstr("expected one of translate, rotate, scale, matrix alone, found 2 of them"));
  EXPECT_THAT(complaint_of_object("\"place\": {\"matrix\": [[1, 0, 0, 0], [2, 0, 0, 0], [0, 0, 1, 0]]}"),
              HasSubstr("/objects/1: expected a place with an inverse"));
  EXPECT_THAT(complaint_of_object(
                  "\"place\": {\"matrix\": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]}"),
              HasSubstr("expected the last row [0, 0, 0, 1]"));
  EXPECT_THAT(
      complaint_of_object("\"instances\": [[], [{\"scale\": 1e400}]]"),
      HasSubstr("/objects/1/instances/1/0/scale: expected a number of at most 1e30 in size, found 1e400"));
  EXPECT_THAT(complaint_of_object("\"material\": {\"shininess\": -2}"),
              HasSubstr("an exponent from 0 on, found -2"));
}

TEST(SceneFile, ContradictionsAreRefused) {
  const auto refused = [](const std::string& members) {
    return complaint(fmt::format(R"({{"objects": [{{"model": "body.obj"}}], {}}})", members));
  };
  const std::map<std::string, std::string> mistakes{
      {R"("camera": {"fov": 40, "focal": 35, "sensor": 24})",
       "/camera/focal: expected either an angle of view"},
      {R"("camera": {"focal": 35})", "/camera: expected a key 'sensor', found none"},
      {R"("camera": {"near": 2, "far": 1})",
       "/camera/far: expected a far plane behind the near one, found 1"},
      {R"("camera": {"up": [0, 0, 0]})", "/camera/up: expected a direction"},
      {R"("camera": {"fov": 180})", "/camera/fov: expected the vertical angle of view"},
      {R"("aa": "none", "samples": 4)", "/samples: expected no number of samples for none"},
      {R"("aa": "supersampling", "samples": 5)", "/samples: expected a square"},
      {R"("size": [0, 4])", "/size/0: expected a whole number from 1 to 8192, found 0"},
      {R"("size": [4.5, 4])", "/size/0: expected a whole number from 1 to 8192, found 4.5"},
      {R"("background": "red")", "/background: expected a colour like"},
      {R"("background": "#12345g")", "/background: expected a colour like"},
      {R"("ambient": [0, -1, 0])", "/ambient/1: expected an amount of light from 0 on, found -1"},
      {R"("lights": [{"kind": "lamp"}])", "/lights/0/kind: expected one of point, directional, spot, area"},
      {R"("lights": [{"kind": "point"}])", "/lights/0: expected a key 'position', found none"},
      {R"("lights": [{"kind": "directional", "direction": [0, 1, 0], "range": 2}])",
       "/lights/0/range: expected no key 'range' for a directional light"},
      {R"("lights": [{"kind": "spot", "position": [0, 1, 0], "direction": [0, 1, 0], "target": [0, 0, 0]}])",
       "/lights/0/target: expected either a direction or a target"},
      {R"("lights": [{"kind": "spot", "position": [0, 1, 0], "target": [0, 1, 0]}])",
       "expected another point than the light's"},
      {R"("lights": [{"kind": "spot", "position": [0, 1, 0], "target": [0, 0, 0], "outer": 20, "inner": 30}])",
       "/lights/0/inner: expected an inner cone within the outer one, at most 20 degrees, found 30"},
      {R"("lights": [{"kind": "area", "position": [0, 1, 0], "across": [0, 1, 0], "along": [0, 2, 0]}])",
       "/lights/0/along: expected another direction than that of across"},
      {R"("lights": [{"kind": "point", "position": [0, 1, 0], "attenuation": [0, 0, 0]}])",
       "one of them at least 1e-30"}};
  for (const auto& [members, expected] : mistakes)
    EXPECT_THAT(refused(members), HasSubstr(expected)) << members;
}

TEST(SceneFile, WhatDividesIsNotNearZero) {
  const auto with = [](const std::string& members) {
    return complaint(fmt::format(R"({{"objects": [{{"model": "body.obj"}}], {}}})", members));
  };
  const auto in_camera = [&](const std::string& members) {
    return with(fmt::format(R"("camera": {{{}}})", members));
  };
  const auto in_lamp = [&](const std::string& members) {
    return with(fmt::format(R"("lights": [{{"kind": "point", "position": [0, 1, 0], {}}}])", members));
  };
  for (const char* little : {"5e-324", "1e-300", "9.99e-31"}) {
    const auto height = fmt::format(R"("projection": "orthographic", "height": {})", little);
    EXPECT_THAT(in_camera(height),
                HasSubstr("/camera/height: expected a number above 0, from 1e-30 to 1e30, found "));
    EXPECT_THAT(in_camera(fmt::format(R"("focal": {}, "sensor": 1)", little)),
                HasSubstr("from 1e-30 to 1e30"));
    EXPECT_THAT(in_camera(fmt::format(R"("near": {}, "far": 1)", little)), HasSubstr("from 1e-30 to 1e30"));
    EXPECT_THAT(in_camera(fmt::format(R"("up": [0, -{}, 0])", little)), HasSubstr("at least 1e-30 in size"));
    EXPECT_THAT(in_lamp(fmt::format(R"("range": {})", little)), HasSubstr("from 1e-30 to 1e30"));
    EXPECT_THAT(in_lamp(fmt::format(R"("attenuation": [{}, 0, 0])", little)), HasSubstr("at least 1e-30"));
    EXPECT_THAT(complaint_of_object(fmt::format(R"("place": {{"scale": [1, -{}, 1]}})", little)),
                HasSubstr("factors of at least 1e-30 in size"));
  }
  EXPECT_EQ(in_camera(R"("projection": "orthographic", "height": 1e-30)"), "(no complaint)");
  EXPECT_EQ(in_camera(R"("up": [0, -1e-30, 5e-324])"), "(no complaint)");
}

TEST(SceneFile, NamesHaveNoNul) {
  EXPECT_THAT(
      complaint(R"({"objects": [{"model": "body.obj\u0000.png"}]})"),
      HasSubstr("/objects/0/model: expected a file's name like \"../models/spot.obj\", without NUL, found "));
  EXPECT_THAT(complaint_of_object(R"("name": "a\u0000b")"), HasSubstr("expected a name, without NUL"));
}

TEST(SceneFile, ShippedScenesAreRead) {
  for (const char* name : {"spot", "pasture", "koala", "cornell_box", "closed_room", "circular_road",
                           "street", "town", "town_flight", "wide_field"}) {
    SCOPED_TRACE(name);
    const SceneFile file = load_scene(fmt::format("{}/examples/scenes/{}.json", GRADUS_SOURCE_DIR, name));
    EXPECT_TRUE(file.notes.empty()) << file.notes.front();
    EXPECT_FALSE(bounds_of(file.scene).empty());
  }
  const SceneFile town = load_scene(GRADUS_SOURCE_DIR "/examples/scenes/town.json");
  EXPECT_GT(town.scene.objects.size(), 1000u);
  EXPECT_THROW(load_scene(GRADUS_SOURCE_DIR "/examples"), InputError);
}

}  // namespace
}  // namespace gradus::pipeline::scene_file_test
