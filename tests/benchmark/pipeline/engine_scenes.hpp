#pragma once
// Scenes that the engine is measured with.

#include "core/arithmetic/elementary.hpp"
#include "core/mesh.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/scene.hpp"

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

}  // namespace gradus::bench::engine_scenes
