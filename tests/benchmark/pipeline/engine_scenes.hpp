#pragma once
// Scenes that the engine is measured with.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/mesh.hpp"
#include "core/random.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/camera/framing.hpp"
#include "scene/camera/view.hpp"
#include "scene/files.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::bench::engine_scenes {

inline void add_triangle(Mesh& mesh, int a, int b, int c) {
  const Corner corners[]{{a, -1, a}, {b, -1, b}, {c, -1, c}};
  add_face(mesh, corners);
}

/// A closed sphere of 2 n (n - 1) triangles along circles of longitude and latitude.
inline Mesh sphere(int n) {
  constexpr double pi = 0x1.921fb54442d18p1;
  Mesh mesh;
  const auto add_place = [&](int i, int j) {
    const SinCos a = sin_cos(pi * i / n), b = sin_cos(2 * pi * j / n);
    mesh.positions.push_back({a.sin * b.cos, a.cos, -a.sin * b.sin});
    mesh.normals.push_back(unit_vector(mesh.positions.back()));
  };
  add_place(0, 0);
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < n; ++j) add_place(i, j);
  add_place(n, 0);
  // A circle of latitude has its first vertex again behind its last; a pole is one vertex
  const auto vertex = [n](int i, int j) {
    return i == 0 ? 0 : i == n ? 1 + (n - 1) * n : 1 + (i - 1) * n + j % n;
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i + 1 < n) add_triangle(mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      if (i > 0) add_triangle(mesh, vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return mesh;
}

/// One lamp beside the camera.
inline void light(pipeline::Scene& scene) {
  const Frame<double>& frame = scene.camera.frame;
  Light lamp;
  lamp.position = frame.eye + 2.0 * frame.right + 2.0 * frame.up;
  lamp.intensity = LinearRgb{0.6f};
  scene.lights = {lamp};
}

/// One sphere of so many circles, which nearly fills the height of the picture.
inline pipeline::Scene spheres(int n) {
  pipeline::Scene scene;
  Mesh mesh = sphere(n);
  mesh.materials[0].specular = LinearRgb{0.4f};
  scene.objects.push_back(pipeline::object_of(std::move(mesh)));
  scene.camera.frame = viewing::look_at(dvec3{0.4, 0.6, 2.6}, dvec3{0}, dvec3{0, 1, 0});
  scene.camera.lens = {0.8, 0.1, 20};
  return scene;
}

inline Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  for (const auto& f :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    const Corner corners[]{{f[0]}, {f[1]}, {f[2]}, {f[3]}};
    add_face(mesh, corners);
  }
  return mesh;
}

/// Ten thousand, half of them behind the eye, most of the others behind one another.
inline pipeline::Scene cubes() {
  pipeline::Scene scene;
  Random random(1);
  Mesh mesh = cube();
  mesh.materials[0].specular = LinearRgb{0.3f};
  const pipeline::Object object = pipeline::object_of(std::move(mesh));
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-10, 10), y = random.uniform(-5, 5), z = random.uniform(-10, 10);
    const double radians = random.uniform(0, 6);
    scene.objects.push_back(object);
    scene.objects.back().placement = affine_3d::translation(dvec3{x, y, z}) *
                                     affine_3d::rotation(dvec3{1, 2, 3}, radians) *
                                     affine_3d::scaling(dvec3{0.25});
  }
  scene.camera.frame = viewing::look_at(dvec3{0, 0, 0.01}, dvec3{0, 0, -5}, dvec3{0, 1, 0});
  scene.camera.lens = {1.2, 0.1, 40};
  return scene;
}

inline Image decode(const std::string& bytes, const std::string& name, std::int64_t most) {
  return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name, most);
}

inline pipeline::Scene shipped(const std::string& name, double aspect) {
  pipeline::SceneFile file =
      pipeline::load_scene(fmt::format("{}/examples/scenes/{}.json", GRADUS_SOURCE_DIR, name), decode);
  const pipeline::Aim aim = pipeline::aim_of(file.scene.objects, file.view, aspect);
  file.scene.camera = pipeline::camera_of(aim, file.view, file.scene.objects, aspect);
  return std::move(file.scene);
}

/// A scene that the engine is measured with, and what it is called.
struct SceneMaker {
  std::string name;
  pipeline::Scene (*scene)(double aspect);
};
inline const std::vector<SceneMaker>& workloads() {
  static const std::vector<SceneMaker> all{
      {"sphere of 1,000 triangles", [](double) { return spheres(23); }},
      {"sphere of 100,000 triangles", [](double) { return spheres(224); }},
      {"sphere of 1,000,000 triangles", [](double) { return spheres(708); }},
      {"10,000 cubes", [](double) { return cubes(); }},
      {"spot, textured", [](double aspect) { return shipped("spot", aspect); }},
      {"inside a closed room", [](double aspect) { return shipped("closed_room", aspect); }},
  };
  return all;
}

}  // namespace gradus::bench::engine_scenes
