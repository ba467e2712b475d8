// Objects that are subdivided: what their faces inherit, and how fine they are.

#include "scene/models/subdivided.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/refusal.hpp"
#include "plan/decisions.hpp"
#include "plan/levels.hpp"
#include "plan/plan.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/scene_file.hpp"

namespace gradus::pipeline::subdivided_test {
namespace {

using testing::HasSubstr;

/// A cube from -1 to 1, its sides of two materials, each with the whole of a texture.
Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(dvec3{i & 1, (i >> 1) & 1, (i >> 2) & 1} * 2.0 - dvec3{1});
  mesh.textures = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.materials.resize(3);
  mesh.files = {"cube.obj"};
  const std::array<std::array<int, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (std::size_t side = 0; side < sides.size(); ++side) {
    std::vector<Corner> corners;
    for (int i = 0; i < 4; ++i) corners.push_back({sides[side][static_cast<std::size_t>(i)], i});
    add_face(mesh, corners, side < 2 ? 1 : 2, 0, side < 2 ? 1 : 2);
  }
  add_missing_normals(mesh);
  return mesh;
}

double texture_area(const Mesh& mesh, const MeshFace& face) {
  const auto corners = corners_of(mesh, face);
  double doubled = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = mesh.textures[static_cast<std::size_t>(corners[i].texture)];
    const dvec2 b = mesh.textures[static_cast<std::size_t>(corners[(i + 1) % corners.size()].texture)];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

TEST(Subdivided, FacesInheritMaterialAndTexture) {
  const Mesh fine = subdivided(cube(), 3);
  EXPECT_EQ(fine.faces.size(), 6u * 64);
  std::array<int, 3> of_material{};
  for (const MeshFace& face : fine.faces) {
    ++of_material[static_cast<std::size_t>(face.material)];
    EXPECT_EQ(texture_area(fine, face), 1.0 / 64);
    EXPECT_EQ(face.line, face.material) << "as the face that it is a part of";
  }
  EXPECT_EQ(of_material, (std::array{0, 128, 256}));
  EXPECT_TRUE(closed_outward(fine));
  for (const Corner& corner : fine.corners)
    EXPECT_NEAR(glm::length(fine.normals[static_cast<std::size_t>(corner.normal)]), 1, 1e-12);
}

TEST(Subdivided, ACubeOnceHasTheKnownPoints) {
  const Mesh fine = subdivided(cube(), 1);
  EXPECT_EQ(fine.positions.size(), 26u);
  for (std::size_t i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::abs(fine.positions[i][axis]), 5.0 / 9, 1e-15);
}

/// A cube in front of a camera.
Scene scene_with(double distance, int most) {
  Scene scene;
  Object object = object_of(cube(), "cube");
  object.subdivision = Subdivision{object.mesh, most};
  scene.objects.push_back(object);
  scene.camera.frame = viewing::look_at(dvec3{0, 0, distance}, dvec3{0}, dvec3{0, 1, 0});
  scene.camera.lens = {1.5707963267948966, 0.01, 1e4};  // a right angle
  return scene;
}
constexpr Size size{640, 480};

/// The longest side of a face in the picture by the camera's formulas: x = f right / depth.
double longest_side(const Scene& scene) {
  const double f = 0.5 * size.height;  // of a right angle
  const Mesh& mesh = *scene.objects[0].mesh;
  const auto at = [&](const Corner& corner) {
    const dvec3 p = position_of(mesh, corner);
    return f / (scene.camera.frame.eye.z - p.z) * dvec2(p);
  };
  double longest = 0;
  for (const MeshFace& face : mesh.faces) {
    const auto corners = corners_of(mesh, face);
    for (std::size_t i = 0; i < corners.size(); ++i)
      longest = std::max(longest, glm::distance(at(corners[i]), at(corners[(i + 1) % corners.size()])));
  }
  return longest;
}

TEST(Subdivided, AreAsFineAsThePictureNeeds) {
  int before = most_subdivisions;
  for (const double distance : {6.0, 12.0, 40.0, 100.0, 800.0}) {
    Scene scene = scene_with(distance, most_subdivisions);
    subdivide(scene, {&scene.camera, 1}, size);
    const int level = level_of(scene.objects[0]);
    EXPECT_LE(level, before) << distance;
    EXPECT_LE(longest_side(scene), fine_edge) << distance;
    before = level;
    if (level == 0) continue;
    Scene coarser = scene_with(distance, level - 1);
    subdivide(coarser, {&coarser.camera, 1}, size);
    EXPECT_GT(coarser.objects[0].subdivision->longest, std::ldexp(fine_edge, level - 1)) << distance;
  }
  EXPECT_EQ(before, 0);
}

TEST(Subdivided, TheNearestOfSeveralPicturesDecides) {
  Scene scene = scene_with(100, 6);
  const std::vector<SceneCamera> cameras{scene_with(100, 6).camera, scene_with(8, 6).camera};
  subdivide(scene, cameras, size);
  Scene near = scene_with(8, 6);
  subdivide(near, {&near.camera, 1}, size);
  EXPECT_EQ(level_of(scene.objects[0]), level_of(near.objects[0]));
}

TEST(Subdivided, AllLevelsWhereItReachesBehindTheEye) {
  Scene scene = scene_with(0.5, 4);
  subdivide(scene, {&scene.camera, 1}, size);
  EXPECT_EQ(level_of(scene.objects[0]), 4);
  EXPECT_THAT(decisions_on(scene, plan_of(scene, size), 0)[0].why,
              HasSubstr("subdivided to level 4 of 4: its edges may be longer than 4 pixels"));
}

TEST(Subdivided, ObjectsOfOneModelAndLevelShareAMesh) {
  Scene scene = scene_with(20, 6);
  scene.objects.push_back(scene.objects[0]);
  scene.objects.push_back(scene.objects[0]);
  scene.objects[2].placement[3] = {0, 0, -300, 1};
  subdivide(scene, {&scene.camera, 1}, size);
  EXPECT_EQ(scene.objects[0].mesh, scene.objects[1].mesh);
  EXPECT_LT(level_of(scene.objects[2]), level_of(scene.objects[0]));
  EXPECT_THAT(decisions_on(scene, plan_of(scene, size), 0)[0].why,
              HasSubstr("edges of some 4 pixels or less"));
}

// --- Scenes ----------------------------------------------------------------------------------------

SceneFile read(const std::string& model, const std::string& levels) {
  const ModelFinder find = [&](const std::string&) -> std::optional<FoundModel> {
    return FoundModel{model, "m.obj", {}};
  };
  return parse_scene("{\"objects\": [{\"model\": \"m.obj\", \"subdivide\": " + levels + "}]}", "s.json", find,
                     {});
}
std::string refusal_of(const std::string& model, const std::string& levels) {
  try {
    read(model, levels);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
const std::string two_faces = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";

TEST(Subdivided, ScenesSayHowOften) {
  const Scene scene = read(two_faces, "3").scene;
  ASSERT_TRUE(scene.objects[0].subdivision);
  EXPECT_EQ(scene.objects[0].subdivision->most, 3);
  EXPECT_THAT(refusal_of(two_faces, "7"),
              HasSubstr("s.json:1: /objects/0/subdivide: expected a whole number from 1 to 6, found 7"));
  EXPECT_THAT(refusal_of(two_faces + "f 1 3 5\n", "2"),
              HasSubstr("/objects/0/subdivide: expected a model that is a surface, to subdivide, found an "
                        "edge of 3 faces"));
  EXPECT_THAT(refusal_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n", "2"), testing::IsEmpty());
  EXPECT_THAT(refusal_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3 \n", "2"),
              HasSubstr("two faces that run along an edge the same way"));
  EXPECT_THAT(refusal_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 1 3\n", "2"),
              HasSubstr("a face that has a corner twice"));
  EXPECT_THAT(refusal_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n", "2"),
              HasSubstr("faces that meet in a corner alone"));
}

}  // namespace
}  // namespace gradus::pipeline::subdivided_test
