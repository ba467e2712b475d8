// Files of models that are written are read back equal, by the readers that other tests hold to their
// formats.

#include "scene/models/model_writers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "scene/models/model_formats.hpp"

namespace gradus::pipeline::model_writers_test {
namespace {

using Ring = std::vector<dvec3>;

Mesh read(const std::string& bytes, const std::string& name) {
  const FileReader nothing = [](const std::string&) -> std::optional<LibraryText> { return std::nullopt; };
  const ModelFile file = read_model(bytes, {name}, nothing, {});
  EXPECT_THAT(file.notes, testing::IsEmpty()) << name;
  return file.mesh;
}

/// A cube, one of its sides a pentagon that is not convex; places that no short decimals are.
Mesh house(bool normals) {
  Mesh mesh;
  Random random(7);
  const std::vector<dvec3> corners{{0, 0, 0}, {3, 0, 0}, {3, 2, 0},     {0, 2, 0}, {0, 0, 1},
                                   {3, 0, 1}, {3, 2, 1}, {1.5, 0.5, 1}, {0, 2, 1}};
  for (const dvec3& p : corners) mesh.positions.push_back(1e3 / 3 * p + random.uniform(0, 1e-9));
  const std::vector<std::vector<int>> rings{{0, 3, 2, 1},    {0, 1, 5, 4}, {1, 2, 6, 5}, {3, 0, 4, 8},
                                            {4, 5, 6, 7, 8}, {2, 3, 8},    {2, 8, 7},    {2, 7, 6}};
  const std::array<dvec3, 3> axes{{{0.6, 0.8, 0}, {0, 0, -1}, {0, 1, 0}}};
  if (normals) mesh.normals.assign(axes.begin(), axes.end());
  for (const std::vector<int>& ring : rings) {
    std::vector<Corner> all;
    for (const int i : ring) all.push_back({i, -1, normals ? (i + static_cast<int>(ring.size())) % 3 : -1});
    add_face(mesh, all);
  }
  return mesh;
}

Ring ring_of(const Mesh& mesh, const MeshFace& face) {
  Ring ring;
  for (const Corner& corner : corners_of(mesh, face)) ring.push_back(position_of(mesh, corner));
  return ring;
}
std::vector<Ring> rings_of(const Mesh& mesh) {
  std::vector<Ring> rings;
  for (const MeshFace& face : mesh.faces) rings.push_back(ring_of(mesh, face));
  return rings;
}
/// Readers give normals their length of 1 anew, which may move them by a last place.
void expect_near(const std::vector<dvec3>& found, const std::vector<dvec3>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LE(glm::distance(found[i], expected[i]), 4e-16) << i;
}
std::vector<dvec3> normals_of(const Mesh& mesh) {
  std::vector<dvec3> normals;
  for (const Corner& corner : mesh.corners)
    normals.push_back(mesh.normals[static_cast<std::size_t>(corner.normal)]);
  return normals;
}

TEST(ModelWriters, ObjIsReadBackEqual) {
  for (const bool normals : {false, true}) {
    const Mesh mesh = house(normals);
    const Mesh back = read(obj_of(mesh, "a house"), "a.obj");
    EXPECT_EQ(back.positions, mesh.positions);
    EXPECT_EQ(rings_of(back), rings_of(mesh));
    if (normals) expect_near(normals_of(back), normals_of(mesh));
  }
}

TEST(ModelWriters, PlyIsReadBackEqual) {
  for (const bool normals : {false, true}) {
    const Mesh mesh = house(normals);
    const Mesh back = read(ply_of(mesh, "a house"), "a.ply");
    if (!normals) EXPECT_EQ(back.positions, mesh.positions);
    EXPECT_EQ(rings_of(back), rings_of(mesh));
    if (normals) expect_near(normals_of(back), normals_of(mesh));
  }
}

/// Twice the area of a flat ring over its plane z.
double doubled_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

TEST(ModelWriters, StlIsReadBackAsTheFacesTriangles) {
  const Mesh mesh = house(false);
  const Mesh back = read(stl_of(mesh, "a house"), "a.stl");
  EXPECT_EQ(static_cast<std::int64_t>(back.faces.size()), triangle_count(mesh));
  const auto area = [](const Mesh& of) {
    double sum = 0;
    for (const Ring& ring : rings_of(of)) sum += std::abs(doubled_area(ring));
    return sum;
  };
  // Concave faces too are covered once; upright ones are nearly none from above
  EXPECT_NEAR(area(back), area(mesh), 1e-9 * area(mesh));
  for (const Ring& ring : rings_of(back)) {
    for (const dvec3& p : ring) EXPECT_TRUE(std::ranges::count(mesh.positions, p) == 1);
  }
}

TEST(ModelWriters, BeginWithTheirComment) {
  const Mesh mesh = house(true);
  EXPECT_THAT(obj_of(mesh, "made by hand"), testing::StartsWith("# made by hand\n"));
  EXPECT_THAT(ply_of(mesh, "made by hand"),
              testing::StartsWith("ply\nformat ascii 1.0\ncomment made by hand\n"));
  EXPECT_THAT(stl_of(mesh, "made by hand"), testing::StartsWith("solid made by hand\n"));
}

TEST(ModelWriters, RefuseWhatNoReaderTakes) {
  Mesh mesh;
  EXPECT_THROW(obj_of(mesh, ""), ContractViolation);
  mesh = house(false);
  mesh.positions[2].y = 2e30;
  EXPECT_THROW(obj_of(mesh, ""), ContractViolation);
  EXPECT_THROW(ply_of(mesh, ""), ContractViolation);
  EXPECT_THROW(stl_of(mesh, ""), ContractViolation);
}

}  // namespace
}  // namespace gradus::pipeline::model_writers_test
