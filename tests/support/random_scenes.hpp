#pragma once
// Scenes of boxes, walls and meshes of many small faces, anywhere round a camera. Each number is drawn in a
// statement or a pair of braces of its own: operands have no order, and compilers would make other scenes of
// a seed.

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh.hpp"
#include "core/random.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/scene.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::test {

inline void add_face(Mesh& mesh, std::initializer_list<int> positions) {
  std::vector<Corner> corners;
  for (int position : positions) corners.push_back({position});
  gradus::add_face(mesh, corners);
}

/// The cube from -1 to 1, closed, of 6 squares.
inline Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  for (const auto& f :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    add_face(mesh, {f[0], f[1], f[2], f[3]});
  return mesh;
}

/// The square from -1 to 1 in z = 0 as n x n smaller ones, open, its corners moved by up to `uneven` of a
/// small one.
inline Mesh wall(int n, double uneven, Random& random) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const auto moved = [&] { return n > 1 ? random.uniform(-1, 1) * uneven / n : 0.0; };
      mesh.positions.push_back({2.0 * i / n - 1 + moved(), 2.0 * j / n - 1 + moved(), moved()});
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      add_face(mesh, {a, a + 1, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

/// A ball of radius 1, closed, of 2 n squares and triangles a belt.
inline Mesh ball(int n) {
  Mesh mesh;
  const double pi = 3.141592653589793;
  mesh.positions.push_back({0, -1, 0});
  for (int j = 1; j < n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      const double polar = pi * j / n, around = pi * i / n;
      mesh.positions.push_back(
          {std::sin(polar) * std::cos(around), -std::cos(polar), -std::sin(polar) * std::sin(around)});
    }
  }
  mesh.positions.push_back({0, 1, 0});
  const int top = static_cast<int>(mesh.positions.size()) - 1;
  const auto at = [&](int j, int i) { return 1 + (j - 1) * 2 * n + i % (2 * n); };
  for (int i = 0; i < 2 * n; ++i) {
    add_face(mesh, {0, at(1, i + 1), at(1, i)});
    for (int j = 1; j + 1 < n; ++j) add_face(mesh, {at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)});
    add_face(mesh, {at(n - 1, i), at(n - 1, i + 1), top});
  }
  return mesh;
}

inline dvec3 random_point(Random& random, double size) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
  return {x, y, z};
}

inline Material random_material(Random& random) {
  Material material;
  const auto share = [&] { return static_cast<float>(random.unit()); };
  material.diffuse = {share(), share(), share()};
  if (random.unit() < 0.5) material.specular = LinearRgb{share()};
  material.shininess = 1 + 30 * share();
  return material;
}

/// A texture of random texels, half of the time with powers of two of columns and rows.
inline Image random_texture(Random& random) {
  const bool powers = random.unit() < 0.5;
  const auto count = [&] {
    return static_cast<int>(powers ? 1 << random.uniform_int(0, 6) : random.uniform_int(1, 40));
  };
  const auto width = count(), height = count();
  Image texels(width, height);
  for (Rgba8& texel : texels.cells()) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random.uniform_int(0, 255)); };
    const auto r = byte(), g = byte(), b = byte();
    texel = {r, g, b, 255};
  }
  return texels;
}

/// Random texture coordinates for each corner, and a texture.
inline Mesh textured(Mesh mesh, Random& random) {
  for (Corner& corner : mesh.corners) {
    corner.texture = static_cast<int>(mesh.textures.size());
    const double u = random.uniform(-2, 2), v = random.uniform(-2, 2);
    mesh.textures.push_back({u, v});
  }
  mesh.materials[0].diffuse_map.texels = random_texture(random);
  return mesh;
}

inline pipeline::Object random_object(Random& random) {
  using namespace affine_3d;
  const auto kind = random.uniform_int(0, 4);
  Mesh mesh = kind == 0   ? ball(5)
              : kind == 1 ? wall(static_cast<int>(random.uniform_int(1, 6)), 0.3, random)
              : kind == 2 ? wall(1, 0, random)
                          : cube();
  mesh.materials = {random_material(random)};
  pipeline::Object object = pipeline::object_of(std::move(mesh));
  const double size = kind == 2 ? 3 : random.uniform(0.1, 1.2);
  const auto factor = [&] {
    const double length = size * random.uniform(0.4, 1);
    return random.unit() < 0.1 ? -length : length;
  };
  const dvec3 factors{factor(), factor(), factor()};
  const dvec3 place = random_point(random, 6), axis = random_point(random, 1) + dvec3{0, 0, 0.01};
  object.placement = translation(place) * rotation(axis, random.uniform(0, 6)) * scaling(factors);
  return object;
}

inline Light random_light(Random& random) {
  Light light;
  light.kind = static_cast<Light::Kind>(random.uniform_int(0, 3));
  light.position = random_point(random, 6);
  light.direction = random_point(random, 1) + dvec3{0, 0, 0.01};
  light.intensity = LinearRgb{static_cast<float>(random.uniform(0.1, 0.6))};
  if (random.unit() < 0.7) light.range = random.uniform(1, 8);
  light.outer_cosine = 0.6, light.inner_cosine = 0.8;
  light.across = {1, 0, 0.2}, light.along = {0, 1, 0.1};
  light.samples = 2;
  return light;
}

/// So many objects in a cube with sides of 12, a camera among them.
inline pipeline::Scene random_scene(Random& random, int objects) {
  pipeline::Scene scene;
  for (int i = 0; i < objects; ++i) scene.objects.push_back(random_object(random));
  const auto lights = random.uniform_int(1, 3);
  for (int i = 0; i < lights; ++i) scene.lights.push_back(random_light(random));
  const dvec3 eye = random_point(random, 5);
  scene.camera.frame = viewing::look_at(eye, random_point(random, 2) + dvec3{0, 0, 0.01}, dvec3{0, 1, 0});
  scene.camera.lens = {random.uniform(0.4, 1.6), random.uniform(0.05, 1), random.uniform(4, 15)};
  scene.background = LinearRgb{0.2f, 0.4f, 0.6f};
  return scene;
}

/// The same with something large of many faces close before the camera, and most of the objects behind it.
inline pipeline::Scene random_screened_scene(Random& random, int objects) {
  pipeline::Scene scene = random_scene(random, objects);
  const Frame<double>& frame = scene.camera.frame;
  const auto before = [&](double depth, double aside) {
    const dvec2 slope{random.uniform(-aside, aside), random.uniform(-aside, aside)};
    return frame.eye + depth * (frame.forward + slope.x * frame.right + slope.y * frame.up);
  };
  scene.camera.lens.near = 0.05;
  scene.camera.lens.far = 20;
  for (pipeline::Object& object : scene.objects)
    object.placement[3] = {before(random.uniform(4, 15), 0.4), 1};
  const auto kind = random.uniform_int(0, 2);
  Mesh mesh = kind == 0 ? ball(12) : kind == 1 ? wall(12, 0.45, random) : cube();
  mesh.materials = {random_material(random)};
  pipeline::Object screen = pipeline::object_of(std::move(mesh));
  // A wall stands across the view
  const glm::dmat4 across{{frame.right, 0}, {frame.up, 0}, {-frame.forward, 0}, {0, 0, 0, 1}};
  const dvec3 middle = before(random.uniform(1.5, 3), 0.2);
  const double radians = random.uniform(-0.5, 0.5), size = random.uniform(0.5, 2);
  screen.placement = affine_3d::translation(middle) * across * affine_3d::rotation(dvec3{1, 2, 3}, radians) *
                     affine_3d::scaling(dvec3{size});
  const auto place = random.uniform_int(0, std::ssize(scene.objects));
  scene.objects.insert(scene.objects.begin() + place, std::move(screen));
  return scene;
}

}  // namespace gradus::test
