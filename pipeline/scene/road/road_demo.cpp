#include "scene/road/road_demo.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "projection/viewing/viewing.hpp"
#include "scene/camera/framing.hpp"

namespace gradus::pipeline {
namespace {

constexpr int picture_rows = 512;
constexpr int road_pieces = 120;
constexpr double road_share = 1.0 / 40;  ///< of the radius, to each side
constexpr double ground_share = 8;       ///< of the radius, to each side

/// Of its own colour, wherever light comes from.
Material unlit(std::string name, LinearRgb colour) {
  Material material;
  material.name = std::move(name);
  material.ambient = colour;
  material.diffuse = LinearRgb{0};
  return material;
}

Mesh model_of(const RoadDemo& demo, Image texture) {
  Mesh mesh;
  mesh.positions = demo.positions;
  mesh.textures = demo.uvs;
  mesh.materials.push_back(unlit("texture", LinearRgb{1}));
  mesh.materials.back().diffuse_map.texels = std::move(texture);
  for (const auto& [a, b, c] : demo.triangles)
    add_face(mesh, std::array{Corner{a, a}, Corner{b, b}, Corner{c, c}}, 1);
  return mesh;
}

/// A ring in pieces that are light and dark in turn, so that one sees the car move.
Mesh road_of(const CircularRoad& road) {
  Mesh mesh;
  mesh.materials.push_back(unlit("dark", LinearRgb{0.12f}));
  mesh.materials.push_back(unlit("light", LinearRgb{0.2f}));
  for (int i = 0; i < road_pieces; ++i) {
    const auto [s, c] = sin_cos_degrees(360.0 * i / road_pieces);
    for (const double side : {-road_share, road_share})
      mesh.positions.push_back(road.centre + road.radius * (1 + side) * dvec3{c, s, 0});
  }
  for (int i = 0; i < road_pieces; ++i) {
    const int next = (i + 1) % road_pieces;
    add_face(mesh, std::array{Corner{2 * i}, Corner{2 * i + 1}, Corner{2 * next + 1}, Corner{2 * next}},
             1 + i % 2);
  }
  return mesh;
}

/// A square under the road and the model, beyond both.
Mesh ground_of(const RoadDemo& demo) {
  Mesh mesh;
  mesh.materials.push_back(unlit("grass", LinearRgb{0.16f, 0.22f, 0.09f}));
  double height = demo.road.centre.z;
  for (const dvec3 position : demo.positions) height = std::min(height, position.z);
  const dvec3 middle{demo.road.centre.x, demo.road.centre.y, height - demo.road.radius / 1000};
  for (const dvec2 corner : {dvec2{-1, -1}, dvec2{1, -1}, dvec2{1, 1}, dvec2{-1, 1}})
    mesh.positions.push_back(middle + ground_share * demo.road.radius * dvec3(corner, 0));
  add_face(mesh, std::array{Corner{0}, Corner{1}, Corner{2}, Corner{3}}, 1);
  return mesh;
}

}  // namespace

Aim aim_at(const RoadDemo& demo, Gaze gaze, int frame) {
  const Car car = car_at(demo.road, moment_of(demo, frame));
  const dvec3 eye = mounted_on(car, demo.mount);
  return {eye, gaze == Gaze::forward ? eye + car.ahead : demo.target, demo.up};
}

Camera camera_at(const RoadDemo& demo, Gaze gaze, int frame, const Bounds& bounds) {
  const Aim aim = aim_at(demo, gaze, frame);
  Camera camera;
  camera.frame = viewing::look_at(aim.eye, aim.target, aim.up);
  camera.lens.vertical_radians = 2 * atan2(demo.sensor_height / 2, demo.focal);
  return with_depths(camera, bounds);
}

ivec2 frame_size(const RoadDemo& demo) {
  const double columns = std::round(picture_rows * demo.sensor_width / demo.sensor_height);
  return {static_cast<int>(columns), picture_rows};
}

Scene scene_of(const RoadDemo& demo, Image texture) {
  Scene scene;
  scene.objects.push_back(object_of(ground_of(demo), "ground"));
  scene.objects.push_back(object_of(road_of(demo.road), "road"));
  scene.objects.push_back(object_of(model_of(demo, std::move(texture)), "model"));
  scene.ambient = LinearRgb{1};
  scene.background = LinearRgb{0.55f, 0.72f, 0.85f};
  return scene;
}

}  // namespace gradus::pipeline
