// Surfaces that runs make, saved as files of models: what is read back is what was made.

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/mesh.hpp"
#include "scene/models/model_formats.hpp"
#include "scene/models/model_writers.hpp"
#include "support/example_traces.hpp"

namespace gradus::saved_surface_test {
namespace {

Mesh read(const std::string& bytes, const std::string& name) {
  const pipeline::FileReader nothing = [](const std::string&) -> std::optional<pipeline::LibraryText> {
    return std::nullopt;
  };
  return pipeline::read_model(bytes, {name}, nothing, {}).mesh;
}

std::vector<std::vector<dvec3>> rings_of(const Mesh& mesh) {
  std::vector<std::vector<dvec3>> rings;
  for (const MeshFace& face : mesh.faces) {
    rings.emplace_back();
    for (const Corner& corner : corners_of(mesh, face)) rings.back().push_back(position_of(mesh, corner));
  }
  return rings;
}

TEST(SavedSurface, OfEveryRunThatMakesOneIsReadBackEqual) {
  std::set<std::string> topics;
  for (const std::string topic :
       {"bezier_patch", "ear_clipping", "parametric_surface", "subdivision_surface"}) {
    for (const Trace& trace : test::telling_traces({}, topic)) {
      if (!trace.mesh) continue;
      topics.insert(topic);
      const Mesh made = mesh_of(trace.mesh->points, trace.mesh->faces);
      const Mesh obj = read(pipeline::obj_of(made, "a run"), "a.obj");
      EXPECT_EQ(obj.positions, made.positions) << topic << trace.method;
      EXPECT_EQ(rings_of(obj), rings_of(made)) << topic << trace.method;
      EXPECT_EQ(rings_of(read(pipeline::ply_of(made, "a run"), "a.ply")), rings_of(made)) << topic;
      const auto triangles = read(pipeline::stl_of(made, "a run"), "a.stl").faces.size();
      EXPECT_EQ(static_cast<std::int64_t>(triangles), triangle_count(made)) << topic << trace.method;
    }
  }
  EXPECT_EQ(topics.size(), 4u);
}

}  // namespace
}  // namespace gradus::saved_surface_test
