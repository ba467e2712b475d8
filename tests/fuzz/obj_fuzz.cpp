// Models: whatever the bytes are, they are read as a sound mesh or refused with file and line. What is read
// is read again from what a writer makes of it, and by tinyobjloader.

#include <fmt/format.h>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/image.hpp"
#include "scene/models/obj.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

void expect_sound(const Mesh& mesh) {
  require(!mesh.faces.empty(), "a model has a face");
  const auto finite = [](double x) { return std::isfinite(x) && std::abs(x) <= 1e30; };
  for (const dvec3& p : mesh.positions)
    require(finite(p.x) && finite(p.y) && finite(p.z), "positions are finite");
  for (const dvec2& t : mesh.textures) require(finite(t.x) && finite(t.y), "texture coordinates are finite");
  for (const dvec3& n : mesh.normals) {
    require(n == dvec3{0} || std::abs(glm::length(n) - 1) < 1e-14, "normals have length 1 or 0");
  }
  for (const MeshFace& face : mesh.faces) {
    require(face.count >= 3 && face.line >= 1, "a face has corners and a line");
    require(static_cast<std::size_t>(face.material) < mesh.materials.size(), "materials exist");
    for (const Corner& corner : corners_of(mesh, face)) {
      require(static_cast<std::size_t>(corner.position) < mesh.positions.size(), "positions exist");
      require(static_cast<std::size_t>(corner.normal) < mesh.normals.size(), "every corner has a normal");
      require(corner.texture == -1 || static_cast<std::size_t>(corner.texture) < mesh.textures.size(),
              "texture coordinates exist");
    }
  }
  for (const Material& m : mesh.materials) {
    for (const LinearRgb c : {m.ambient, m.diffuse, m.specular, m.emission}) {
      for (int i = 0; i < 3; ++i) require(finite(c[i]) && c[i] >= 0, "light is finite and not negative");
    }
    require(std::isfinite(m.shininess) && m.shininess >= 0, "a highlight has an exponent");
    require(0 <= m.opacity && m.opacity <= 1, "opacity lies between 0 and 1");
  }
}

std::string written(const Mesh& mesh) {
  std::string text;
  for (const dvec3& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const dvec2& t : mesh.textures) text += fmt::format("vt {} {}\n", t.x, t.y);
  for (const dvec3& n : mesh.normals) text += fmt::format("vn {} {} {}\n", n.x, n.y, n.z);
  for (const MeshFace& face : mesh.faces) {
    text += "f";
    bool textured = true;
    for (const Corner& c : corners_of(mesh, face)) textured = textured && c.texture >= 0;
    for (const Corner& c : corners_of(mesh, face)) {
      text += textured ? fmt::format(" {}/{}/{}", c.position + 1, c.texture + 1, c.normal + 1)
                       : fmt::format(" {}//{}", c.position + 1, c.normal + 1);
    }
    text += "\n";
  }
  return text;
}

/// Same positions, and the same corners face by face.
void expect_same(const Mesh& a, const Mesh& b) {
  require(a.positions == b.positions && a.textures == b.textures,
          "what was written is read back, bit for bit");
  require(a.faces.size() == b.faces.size(), "as many faces are read back");
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    const auto p = corners_of(a, a.faces[i]), q = corners_of(b, b.faces[i]);
    require(p.size() == q.size(), "faces keep their corners");
    for (std::size_t k = 0; k < p.size(); ++k)
      require(p[k].position == q[k].position, "corners keep their place");
  }
}

/// Ours, written plainly, is what tinyobjloader reads. It counts the corners of a face in a byte.
void expect_theirs(const Mesh& mesh, const std::string& plain) {
  for (const MeshFace& face : mesh.faces) {
    if (face.count > 255) return;
  }
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  tinyobj::ObjReader theirs;
  require(theirs.ParseFromString(plain, "", config), "tinyobjloader reads what we have read");
  require(theirs.GetAttrib().vertices.size() == 3 * mesh.positions.size(), "as many vertices as theirs");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double ours = mesh.positions[i][axis],
                   other = theirs.GetAttrib().vertices[3 * i + static_cast<std::size_t>(axis)];
      // Their numbers are off in the last places, and lost below the normal range
      require(std::abs(ours - other) <= 1e-13 * std::abs(ours) + 1e-290, "coordinates are theirs");
    }
  }
  std::size_t faces = 0, corners = 0;
  for (const auto& shape : theirs.GetShapes()) {
    faces += shape.mesh.num_face_vertices.size();
    corners += shape.mesh.indices.size();
  }
  require(faces == mesh.faces.size() && corners == mesh.corners.size(),
          "as many faces and corners as theirs");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Behind a file separator (0x1c) stands the material library, whatever its name
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t end = all.find('\x1c');
  const std::string_view text = all.substr(0, end);
  const std::string library(end == std::string_view::npos ? "" : all.substr(end + 1));
  const auto open = [&](const std::string&) {
    return end == std::string_view::npos ? std::nullopt : std::optional(library);
  };
  const auto nothing = [](const std::string&) { return std::optional<std::string>(); };
  pipeline::ModelFile model;
  try {
    model = pipeline::parse_obj(text, "m.obj", open);
  } catch (const InputError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
    return 0;
  }
  for (const std::string& note : model.notes) require(test::harmless(note), "a note is safe to show");
  expect_sound(model.mesh);
  const std::string plain = written(model.mesh);
  const Mesh again = pipeline::parse_obj(plain, "again.obj", nothing).mesh;
  expect_sound(again);
  expect_same(model.mesh, again);
  expect_theirs(model.mesh, plain);
  return 0;
}
