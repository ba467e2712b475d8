#pragma once
// A pyramid seen from a car on a circular road: the data of two demonstrations, and their cameras.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera.hpp"
#include "core/geometry.hpp"
#include "core/image.hpp"
#include "scene/camera/view.hpp"
#include "scene/road/circular_road.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// What a file says under one of its keys, as `gradus inspect` lists it.
struct DataEntry {
  std::string_view key, meaning;
  bool whole = false;              ///< whether all its numbers are whole ones
  std::vector<std::size_t> shape;  ///< rows and columns, or the length of a list; none: a single number
};

/// The data of the demonstrations: camera, car, film, and a model of triangles.
struct RoadDemo {
  CircularRoad road;
  dvec3 mount{0};                              ///< of the camera, in the car's axes
  dvec3 up{0, 0, 1};                           ///< a hint for what is up in the picture
  dvec3 target{0};                             ///< what one of the demonstrations looks at
  double focal = 1;                            ///< of the camera's lens, > 0
  double sensor_width = 1, sensor_height = 1;  ///< behind it, in the same unit, > 0
  int seconds = 1, fps = 25;                   ///< of the film
  std::vector<dvec3> positions;                ///< of the vertices
  std::vector<dvec2> uvs;                      ///< as many, v up
  std::vector<std::array<int, 3>> triangles;   ///< numbers of vertices, from 0
  std::vector<DataEntry> entries;              ///< what was read, in the order of the file
};

/// How many keys a file of such data has, each of them once.
inline constexpr std::size_t demo_keys = 14;
/// What such a file may ask for at most.
inline constexpr int most_demo_frames = 1000, most_demo_fps = 60;
inline constexpr std::size_t most_demo_vertices = 100'000;

/// The data in a JSON text: an object of exactly these keys.
///
/// | key | shape | what |
/// |---|---|---|
/// | k_cam_up | 3 x 1 | a hint for up |
/// | k_sensor_height, k_sensor_width, k_f | - | of the camera, > 0 |
/// | car_velocity, k_road_radius | - | > 0 |
/// | k_road_center, k_cam_car_rel_pos | 3 | place and mount |
/// | k_duration, k_fps | - | whole numbers > 0: seconds, frames a second |
/// | v_pos | 3 x N | a column per vertex |
/// | v_uvs | N x 2 | a row per vertex |
/// | t_pos_idx | M x 3 | a row per triangle, whole numbers from 0 to N - 1 |
/// | k_cam_target | 3 x 1 | a place |
///
/// text: the file's contents. name: how mistakes call it.
///
/// Domain: any bytes.
/// Accuracy: the nearest double to each number.
/// Cost: O(length).
/// Errors: InputError "file:line: key: expected …, found …" for keys that are missing or unknown, for other
///   shapes, numbers out of their range or beyond farthest_texture_coordinate, an `up` in the plane of the
///   road, and more than 1000 rounds, most_demo_frames, most_demo_fps, most_demo_vertices; "file:line: …" for
///   what is no JSON.
RoadDemo parse_road_demo(std::string_view text, const std::string& name);

/// Which way the camera on the car looks.
enum class Gaze {
  forward,  ///< along the tangent of the road
  target,   ///< at demo.target
};

/// How many frames the film has: frame i shows the time i / fps.
inline int frame_count(const RoadDemo& demo) { return demo.seconds * demo.fps; }
inline double moment_of(const RoadDemo& demo, int frame) { return static_cast<double>(frame) / demo.fps; }

/// Where the camera stands in a frame, and where it looks. It is a camera's only where leads_somewhere and
/// tells_upright say so. Errors: those of car_at.
Aim aim_at(const RoadDemo& demo, Gaze gaze, int frame);

/// The camera of that aim, with near and far plane round all that is in the scene.
/// Domain: an aim that is a camera's. Accuracy: that of viewing::look_at.
Camera camera_at(const RoadDemo& demo, Gaze gaze, int frame, const Bounds& bounds);

/// Width and height of a frame: 512 rows, and as many columns as the sensor's shape asks for.
ivec2 frame_size(const RoadDemo& demo);

/// The model in its texture, unlit, so that the texture's colours are those of the picture, on
/// the ground that the car's road lies on. The camera is to be set, one per frame.
Scene scene_of(const RoadDemo& demo, Image texture);

}  // namespace gradus::pipeline
