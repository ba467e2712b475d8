#include "scene/models/model_writers.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "scene/models/triangles.hpp"

namespace gradus::pipeline {
namespace {

void expect_writable(const Mesh& mesh) {
  expects(!mesh.faces.empty(), "a file of a model has at least one face, not 0");
  for (const dvec3& p : mesh.positions) {
    expects(
        all_finite(p.x, p.y, p.z) && std::abs(p.x) <= 1e30 && std::abs(p.y) <= 1e30 && std::abs(p.z) <= 1e30,
        "a file of a model has coordinates up to 1e30, not ({}, {}, {})", p.x, p.y, p.z);
  }
}

class Text {
 public:
  template <class... Parts>
  void add(fmt::format_string<Parts...> format, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Parts>(parts)...);
  }
  void add_numbers(std::string_view before, const dvec3& p, std::string_view after) {
    // -0 is a direction's business; no place needs it
    add("{}{} {} {}{}", before, p.x + 0.0, p.y + 0.0, p.z + 0.0, after);
  }
  std::string taken() { return std::move(text_); }

 private:
  std::string text_;
};

bool has_normals(const Mesh& mesh) {
  return std::ranges::all_of(mesh.corners, [](const Corner& corner) { return corner.normal >= 0; });
}

const dvec3& normal_of(const Mesh& mesh, const Corner& corner) {
  return mesh.normals[static_cast<std::size_t>(corner.normal)];
}

/// The vertices of a PLY file: places, each with one normal.
class Vertices {
 public:
  Vertices(const Mesh& mesh, bool normals) : mesh_(mesh), normals_(normals) {
    if (normals) return;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) all_.push_back({static_cast<int>(i)});
  }

  int number_of(const Corner& corner) {
    if (!normals_) return corner.position;
    const auto [at, fresh] =
        numbers_.try_emplace({corner.position, corner.normal}, static_cast<int>(all_.size()));
    if (fresh) all_.push_back({corner.position, -1, corner.normal});
    return at->second;
  }
  void write(Text& text) const {
    for (const Corner& vertex : all_) {
      text.add_numbers("", position_of(mesh_, vertex), normals_ ? " " : "\n");
      if (normals_) text.add_numbers("", normal_of(mesh_, vertex), "\n");
    }
  }
  std::size_t size() const { return all_.size(); }

 private:
  const Mesh& mesh_;
  bool normals_;
  std::vector<Corner> all_{};
  std::map<std::pair<int, int>, int> numbers_{};
};

dvec3 flat_normal_of(const std::array<dvec3, 3>& triangle) {
  Mesh one;
  one.positions.assign(triangle.begin(), triangle.end());
  add_face(one, std::array{Corner{0}, Corner{1}, Corner{2}});
  return unit_vector(area_vector(one, one.faces[0], unit_scale(bounds_of(one))));
}

}  // namespace

std::string obj_of(const Mesh& mesh, std::string_view comment) {
  expect_writable(mesh);
  Text text;
  text.add("# {}\n", comment);
  const bool normals = has_normals(mesh);
  for (const dvec3& p : mesh.positions) text.add_numbers("v ", p, "\n");
  for (const dvec3& n : normals ? mesh.normals : std::vector<dvec3>{}) text.add_numbers("vn ", n, "\n");
  for (const MeshFace& face : mesh.faces) {
    text.add("f");
    for (const Corner& corner : corners_of(mesh, face)) {
      text.add(" {}", corner.position + 1);
      if (normals) text.add("//{}", corner.normal + 1);
    }
    text.add("\n");
  }
  return text.taken();
}

std::string ply_of(const Mesh& mesh, std::string_view comment) {
  expect_writable(mesh);
  Vertices vertices(mesh, has_normals(mesh));
  Text faces;
  for (const MeshFace& face : mesh.faces) {
    faces.add("{}", face.count);
    for (const Corner& corner : corners_of(mesh, face)) faces.add(" {}", vertices.number_of(corner));
    faces.add("\n");
  }
  Text text;
  text.add("ply\nformat ascii 1.0\ncomment {}\nelement vertex {}\n", comment, vertices.size());
  for (const char* name : {"x", "y", "z"}) text.add("property double {}\n", name);
  for (const char* name : {"nx", "ny", "nz"})
    if (has_normals(mesh)) text.add("property double {}\n", name);
  text.add("element face {}\nproperty list int int vertex_indices\nend_header\n", mesh.faces.size());
  vertices.write(text);
  return text.taken() + faces.taken();
}

std::string stl_of(const Mesh& mesh, std::string_view comment) {
  expect_writable(mesh);
  Text text;
  text.add("solid {}\n", comment);
  for (const MeshFace& face : mesh.faces) {
    const auto corners = corners_of(mesh, face);
    triangulate(mesh, face, [&](const ear_clipping::Triangle& t) {
      std::array<dvec3, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = position_of(mesh, corners[static_cast<std::size_t>(t[i])]);
      text.add_numbers("facet normal ", flat_normal_of(triangle), "\n outer loop\n");
      for (const dvec3& p : triangle) text.add_numbers("  vertex ", p, "\n");
      text.add(" endloop\nendfacet\n");
    });
  }
  text.add("endsolid\n");
  return text.taken();
}

}  // namespace gradus::pipeline
