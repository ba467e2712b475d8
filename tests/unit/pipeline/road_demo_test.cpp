#include "scene/road/road_demo.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/contract.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/files.hpp"
#include "stages/3_perspective.hpp"

namespace gradus::pipeline::road_demo_test {
namespace {

using LongVec = glm::vec<3, long double>;

const RoadDemo& shipped() {
  static const RoadDemo demo = [] {
    const FileRead file =
        read_regular_file(std::string(GRADUS_SOURCE_DIR) + "/examples/demos/pyramid_demo.json");
    EXPECT_EQ(file.problem, "");
    return parse_road_demo(file.bytes, "pyramid_demo.json");
  }();
  return demo;
}

Bounds bounds_of_demo() { return bounds_of(scene_of(shipped(), Image(1, 1))); }

/// Where the camera of a frame shows a point, in pixels from the upper left corner.
dvec2 pixel_of(const Camera& camera, dvec3 point, ivec2 size) {
  const auto lens = lens_of(camera, static_cast<double>(size.x) / size.y);
  const dvec3 ndc = perspective::divide(transform(lens, viewing::to_view(camera.frame, point)));
  return {(ndc.x + 1) / 2 * size.x, (1 - ndc.y) / 2 * size.y};
}

/// Angle of the car in long double, with the C library's functions.
long double angle_of(const RoadDemo& demo, int frame) {
  return static_cast<long double>(demo.road.speed) / demo.road.radius * frame / demo.fps;
}

TEST(CircularRoad, AngularSpeedIsSpeedOverRadius) {
  EXPECT_EQ(angular_speed({{}, 20, 10}), 0.5) << "G000-17";
  // After a second the arc gone along is as long as the speed: angle times radius
  const Car car = car_at({{}, 20, 10}, 1);
  EXPECT_NEAR(std::atan2(car.out.y, car.out.x) * 20, 10, 1e-12);
}

TEST(CircularRoad, PlaceIsCentreAndRadiusTimesCosineAndSine) {
  const CircularRoad road{{3, -2, 7}, 20, 10};
  for (int i = -50; i <= 500; ++i) {
    const double t = i / 25.0;
    const long double angle = 0.5L * t;
    const Car car = car_at(road, t);
    EXPECT_NEAR(car.place.x, 3 + 20 * static_cast<double>(std::cos(angle)), 1e-13);
    EXPECT_NEAR(car.place.y, -2 + 20 * static_cast<double>(std::sin(angle)), 1e-13);
    EXPECT_EQ(car.place.z, 7);
  }
}

/// The velocity from places alone: central differences, Richardson's extrapolation of two.
dvec3 velocity_at(const CircularRoad& road, double t) {
  const auto slope = [&](double h) {
    return (car_at(road, t + h).place - car_at(road, t - h).place) / (2 * h);
  };
  const double h = 1.0 / 64;
  return (4.0 * slope(h / 2) - slope(h)) / 3.0;
}

TEST(CircularRoad, SpeedIsTheDerivativeOfThePlace) {
  for (const CircularRoad& road : {CircularRoad{{3, -2, 7}, 20, 10}, shipped().road}) {
    for (int i = 0; i < 125; ++i) {
      const double t = i / 25.0;
      const dvec3 velocity = velocity_at(road, t);
      EXPECT_NEAR(glm::length(velocity), road.speed, 1e-8 * road.speed);
      EXPECT_NEAR(glm::dot(velocity / road.speed, car_at(road, t).ahead), 1, 1e-8);
    }
  }
}

TEST(CircularRoad, AQuarterTurnTurnsTheMountToo) {
  // Radius 1, speed pi / 2: a quarter in a second
  const CircularRoad road{{}, 1, std::numbers::pi / 2};
  const auto offset_after = [&road](double t) {
    const Car car = car_at(road, t);
    return mounted_on(car, {1, 0, 2}) - car.place;
  };
  EXPECT_EQ(offset_after(0), (dvec3{1, 0, 2}));
  EXPECT_LT(glm::length(offset_after(1) - dvec3{0, 1, 2}), 1e-12) << "G000-18, not (1, 0, 2)";
  EXPECT_LT(glm::length(offset_after(2) - dvec3{-1, 0, 2}), 1e-12);
}

TEST(CircularRoad, NeedsARadiusAndASpeed) {
  EXPECT_THROW(car_at({{}, 0, 1}, 0), ContractViolation);
  EXPECT_THROW(car_at({{}, 1, -1}, 0), ContractViolation);
}

TEST(RoadDemo, IsTheReportsDictionary) {
  struct Expected {
    std::string_view key;
    bool whole;
    std::vector<std::size_t> shape;
  };
  const std::array<Expected, 14> expected{{{"k_cam_up", false, {3, 1}},
                                           {"k_sensor_height", true, {}},
                                           {"k_sensor_width", true, {}},
                                           {"k_f", true, {}},
                                           {"car_velocity", false, {}},
                                           {"k_road_radius", false, {}},
                                           {"k_road_center", false, {3}},
                                           {"k_cam_car_rel_pos", false, {3}},
                                           {"k_duration", true, {}},
                                           {"k_fps", true, {}},
                                           {"v_pos", false, {3, 16}},
                                           {"v_uvs", false, {16, 2}},
                                           {"t_pos_idx", true, {6, 3}},
                                           {"k_cam_target", false, {3, 1}}}};
  ASSERT_EQ(shipped().entries.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(shipped().entries[i].key, expected[i].key);
    EXPECT_EQ(shipped().entries[i].whole, expected[i].whole) << expected[i].key;
    EXPECT_EQ(shipped().entries[i].shape, expected[i].shape) << expected[i].key;
  }
}

TEST(RoadDemo, ThePyramidHasFourSidesAndASquareOfTwoTriangles) {
  // G000-14, and G000-13 for the film
  const RoadDemo& demo = shipped();
  ASSERT_EQ(demo.positions.size(), 16u);
  ASSERT_EQ(demo.uvs.size(), 16u);
  ASSERT_EQ(demo.triangles.size(), 6u);
  double volume = 0;
  int level = 0;
  for (const auto& [a, b, c] : demo.triangles) {
    const auto at = [&](int i) { return demo.positions[static_cast<std::size_t>(i)]; };
    const dvec3 normal = glm::cross(at(b) - at(a), at(c) - at(a));
    level += normal.x == 0 && normal.y == 0 && normal.z < 0;
    volume += glm::dot(at(a), glm::cross(at(b), at(c))) / 6;
  }
  EXPECT_EQ(level, 2) << "the base, seen from below";
  EXPECT_NEAR(volume, 9.0 * 9 * 6 / 3, 1e-9) << "closed, its outside outside: side 9, height 6";
  EXPECT_EQ(frame_count(demo), 125);
  EXPECT_EQ(moment_of(demo, 124), 4.96);
}

TEST(RoadDemo, LookingForwardIsLookingAlongTheVelocity) {
  const RoadDemo& demo = shipped();
  const Bounds bounds = bounds_of_demo();
  for (int i = 0; i < frame_count(demo); ++i) {
    const long double angle = angle_of(demo, i);
    const LongVec velocity{-std::sin(angle), std::cos(angle), 0};
    const Camera camera = camera_at(demo, Gaze::forward, i, bounds);
    EXPECT_NEAR(static_cast<double>(glm::dot(LongVec(camera.frame.forward), velocity)), 1, 1e-12);
    EXPECT_LT(glm::length(LongVec(camera.frame.forward) - velocity), 1e-12L);
  }
}

TEST(RoadDemo, TheMountIsRigid) {
  const RoadDemo& demo = shipped();
  const Bounds bounds = bounds_of_demo();
  dvec3 first{0};
  for (const Gaze gaze : {Gaze::forward, Gaze::target}) {
    for (int i = 0; i < frame_count(demo); ++i) {
      // The car's axes and place by the C library
      const long double angle = angle_of(demo, i), c = std::cos(angle), s = std::sin(angle);
      const LongVec offset = LongVec(camera_at(demo, gaze, i, bounds).frame.eye) -
                             static_cast<long double>(demo.road.radius) * LongVec(c, s, 0);
      EXPECT_LT(glm::length(LongVec(c * offset.x + s * offset.y, c * offset.y - s * offset.x, offset.z) -
                            LongVec(demo.mount)),
                1e-12L)
          << "in the car's axes it stays";
      if (i == 0) first = dvec3(offset);
      if (i == 124) {
        EXPECT_GT(glm::length(dvec3(offset) - first), 0.2) << "in the world it turns";
      }
    }
  }
}

TEST(RoadDemo, TheTargetIsTheMiddleOfEveryFrame) {
  const RoadDemo& demo = shipped();
  const Bounds bounds = bounds_of_demo();
  const ivec2 size = frame_size(demo);
  EXPECT_EQ(size, (ivec2{512, 512}));
  for (int i = 0; i < frame_count(demo); ++i) {
    const Camera camera = camera_at(demo, Gaze::target, i, bounds);
    const dvec2 pixel = pixel_of(camera, demo.target, size);
    EXPECT_NEAR(pixel.x, 256, 1e-9) << "G000-19, frame " << i;
    EXPECT_NEAR(pixel.y, 256, 1e-9);
    // Without our projection: what is left of the way to the target beside the axis
    const LongVec way = LongVec(demo.target) - LongVec(camera.frame.eye);
    EXPECT_LT(glm::length(glm::cross(way, LongVec(camera.frame.forward))) / glm::length(way), 1e-14L);
  }
}

TEST(RoadDemo, LookingForwardThePyramidDriftsFromTheMiddle) {
  const RoadDemo& demo = shipped();
  const Bounds bounds = bounds_of_demo();
  const ivec2 size = frame_size(demo);
  const auto seen = [&](int i) {
    return pixel_of(camera_at(demo, Gaze::forward, i, bounds), demo.target, size);
  };
  EXPECT_NEAR(seen(0).x, 256, 1e-9);
  EXPECT_NEAR(seen(0).y, 256, 1e-9);
  for (int i = 1; i < frame_count(demo); ++i) EXPECT_GT(seen(i).x, seen(i - 1).x + 0.1);
  EXPECT_GT(seen(124).x, 300);
}

// --- Mistakes in files
// ---------------------------------------------------------------------------------------

std::string text_of_shipped() {
  return read_regular_file(std::string(GRADUS_SOURCE_DIR) + "/examples/demos/pyramid_demo.json").bytes;
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = text_of_shipped();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
  try {
    parse_road_demo(text, "d.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(RoadDemo, MistakesAreNamed) {
  EXPECT_EQ(complaint(text_of_shipped()), "none");
  EXPECT_EQ(complaint("[1]"), "d.json:1: expected an object with the keys of a demo, found a list");
  EXPECT_EQ(complaint("{}"), "d.json: expected a key k_cam_up, found none");
  EXPECT_EQ(complaint(changed("\"k_f\": 20,", "")), "d.json: expected a key k_f, found none");
  EXPECT_EQ(complaint(changed("k_f", "k_g")).substr(0, 63),
            "d.json:5: expected one of the keys k_cam_up, k_sensor_height, k");
  EXPECT_EQ(complaint(changed("[[0.0], [0.0], [1.0]]", "[0, 0, 1]")),
            "d.json:2: k_cam_up: expected 3 rows of one number, found 0");
  EXPECT_EQ(complaint(changed("[[0.0], [0.0], [1.0]]", "[[1], [0], [0]]")),
            "d.json:2: k_cam_up: expected a direction out of the road's plane like [[0], [0], [1]], found "
            "(1, 0, 0)");
  EXPECT_EQ(complaint(changed("\"k_f\": 20", "\"k_f\": 0")),
            "d.json:5: k_f: expected a number above 0, found 0");
  EXPECT_EQ(complaint(changed("\"k_f\": 20", "\"k_f\": \"20\"")),
            "d.json:5: k_f: expected a number, found '20'");
  EXPECT_EQ(complaint(changed("\"k_fps\": 25", "\"k_fps\": 2.5")),
            "d.json:11: k_fps: expected a whole number from 1 to 60, found 2.5");
  EXPECT_EQ(complaint(changed("\"k_duration\": 5", "\"k_duration\": 41")),
            "d.json:10: k_duration: expected at most 1000 frames in all, found 1025");
  EXPECT_EQ(complaint(changed("\"car_velocity\": 1.8", "\"car_velocity\": 1e5")),
            "d.json:6: car_velocity: expected at most 1000 rounds of the road in all, found 1592");
  EXPECT_EQ(complaint(changed("[0, 1, 2]", "[0, 1, 16]")),
            "d.json:35: t_pos_idx: expected whole numbers of vertices from 0 to 15, found 16");
  EXPECT_EQ(complaint(changed("[0, 1, 2]", "[0, 1]")),
            "d.json:36: t_pos_idx: expected rows of 3 numbers, found a list of 2");
  EXPECT_EQ(complaint(changed("    [0.0, 0.5],\n", "")),
            "d.json:17: v_uvs: expected 16 rows, one per vertex, found 15");
  EXPECT_EQ(complaint(changed("[0.0, 0.0, 0.0]", "[0.0, 0.0, 1e9]")),
            "d.json:8: k_road_center: expected numbers of at most 524288 in size, found 1e9");
}

}  // namespace
}  // namespace gradus::pipeline::road_demo_test
