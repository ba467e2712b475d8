// A camera that moves: what it is at its keys and between them, and what of a scene's file is no path.

#include "scene/camera/camera_path.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "core/arithmetic/elementary.hpp"
#include "core/refusal.hpp"
#include "scene/scene_file.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::camera_path_test {
namespace {

using enum Interpolation;
using testing::HasSubstr;

/// So many keys at random distances.
Track<double> random_track(std::mt19937_64& random, std::size_t keys) {
  Track<double> track;
  int frame = static_cast<int>(random() % 10);
  for (std::size_t i = 0; i < keys; ++i) {
    track.push_back({frame, std::uniform_real_distribution<double>(-5, 5)(random)});
    frame += 1 + static_cast<int>(random() % 40);
  }
  return track;
}

/// Calls it with many tracks.
template <class Judge>
void on_tracks(const Judge& judge) {
  const std::uint64_t start = test::seed();
  SCOPED_TRACE("GRADUS_SEED=" + std::to_string(start));
  std::mt19937_64 random(start);
  for (int i = 0; i < 300; ++i) judge(random_track(random, 1 + random() % 8), random);
}

/// The same run backwards: frame f becomes 1000 - f.
Track<double> reversed(Track<double> track) {
  std::ranges::reverse(track);
  for (auto& key : track) key.frame = 1000 - key.frame;
  return track;
}

/// Barry and Goldman's pyramid, by which the curve is defined: each line goes straight between two knots. In
/// long double. Beyond the ends stands a key as far away as the neighbour is, on a straight line.
long double pyramid_at(const Track<double>& track, long double frame) {
  std::vector<std::pair<long double, long double>> keys;
  for (const auto& [at, value] : track) keys.emplace_back(at, value);
  const auto beyond = [](auto end, auto next) {
    return std::pair(2 * end.first - next.first, 2 * end.second - next.second);
  };
  keys.insert(keys.begin(), beyond(keys[0], keys[1]));
  keys.push_back(beyond(keys[keys.size() - 1], keys[keys.size() - 2]));
  std::size_t k = 1;
  while (k + 3 < keys.size() && keys[k + 1].first <= frame) ++k;
  const auto between = [&](std::size_t a, std::size_t b, long double p, long double q) {
    const long double from = keys[a].first, to = keys[b].first;
    return ((to - frame) * p + (frame - from) * q) / (to - from);
  };
  const long double left = between(k - 1, k, keys[k - 1].second, keys[k].second),
                    middle = between(k, k + 1, keys[k].second, keys[k + 1].second),
                    right = between(k + 1, k + 2, keys[k + 1].second, keys[k + 2].second);
  return between(k, k + 1, between(k - 1, k + 1, left, middle), between(k, k + 2, middle, right));
}

TEST(Keyframes, KeysAreMetExactlyAndHeldBeyondTheEnds) {
  on_tracks([](const Track<double>& track, std::mt19937_64&) {
    for (const Interpolation how : {linear, smooth}) {
      for (const auto& [frame, value] : track) ASSERT_EQ(value_at(track, frame, how), value);
      ASSERT_EQ(value_at(track, track.front().frame - 3.5, how), track.front().value);
      ASSERT_EQ(value_at(track, track.back().frame + 1e6, how), track.back().value);
    }
  });
}

TEST(Keyframes, LinearIsTheLine) {
  on_tracks([](const Track<double>& track, std::mt19937_64& random) {
    for (std::size_t k = 0; k + 1 < track.size(); ++k) {
      const long double from = track[k].frame, to = track[k + 1].frame;
      const double frame = std::uniform_real_distribution<double>(track[k].frame, track[k + 1].frame)(random);
      const long double line =
          ((to - frame) * track[k].value + (frame - from) * track[k + 1].value) / (to - from);
      ASSERT_NEAR(value_at(track, frame, linear), static_cast<double>(line), 4e-15);
    }
  });
  // Where numbers are exact, so is the line
  const Track<dvec3> track{{0, {0, 8, -4}}, {8, {16, 0, 4}}};
  for (int frame = 0; frame <= 8; ++frame)
    EXPECT_EQ(value_at(track, frame, linear), (dvec3(2.0 * frame, 8.0 - frame, frame - 4.0)));
}

/// What the accuracy is told in: the largest of both keys around and of slope times distance.
double size_at(const Track<double>& track, std::size_t k) {
  const double distance = track[k + 1].frame - track[k].frame;
  return std::max({std::abs(track[k].value), std::abs(track[k + 1].value),
                   std::abs(smooth_pace(track, k)) * distance,
                   std::abs(smooth_pace(track, k + 1)) * distance});
}

TEST(Keyframes, SmoothIsBarryAndGoldmansCurve) {
  double worst = 0;
  on_tracks([&](const Track<double>& track, std::mt19937_64& random) {
    for (std::size_t k = 0; k + 1 < track.size(); ++k) {
      for (int i = 0; i < 10; ++i) {
        const double frame =
            std::uniform_real_distribution<double>(track[k].frame, track[k + 1].frame)(random);
        const long double off = value_at(track, frame, smooth) - pyramid_at(track, frame);
        worst = std::max(worst, std::abs(static_cast<double>(off)) / size_at(track, k));
      }
    }
  });
  RecordProperty("ulp", fmt::format("{:.2f}", worst / 0x1p-52));
  EXPECT_LT(worst, 8 * 0x1p-52);
}

TEST(Keyframes, SmoothKeepsLinesAndInnerParabolas) {
  const auto along = [](double at) { return 3 * at - 7; };
  const auto parabola = [](double at) { return 0.25 * at * at - 3 * at; };
  Track<double> line, curve;
  for (const int frame : {0, 3, 4, 20, 29}) {
    line.push_back({frame, along(frame)});
    curve.push_back({frame, parabola(frame)});
  }
  for (double at = 0; at <= 29; at += 0.5) {
    EXPECT_NEAR(value_at(line, at, smooth), along(at), 1e-13);
    if (3 <= at && at <= 20) EXPECT_NEAR(value_at(curve, at, smooth), parabola(at), 1e-12);
  }
}

TEST(Keyframes, SmoothHasNoJumpOfSlopeAtAnyKey) {
  on_tracks([](const Track<double>& track, std::mt19937_64&) {
    constexpr double step = 1e-5;
    for (std::size_t k = 1; k + 1 < track.size(); ++k) {
      const auto at = [&](double d) { return value_at(track, track[k].frame + d, smooth); };
      // One-sided slopes of second order
      const double before = (3 * at(0) - 4 * at(-step) + at(-2 * step)) / (2 * step);
      const double behind = (-3 * at(0) + 4 * at(step) - at(2 * step)) / (2 * step);
      ASSERT_NEAR(before, behind, 1e-7) << k;
    }
  });
}

TEST(Keyframes, AReversedPathIsTheMirroredOne) {
  on_tracks([](const Track<double>& track, std::mt19937_64& random) {
    const Track<double> back = reversed(track);
    for (int i = 0; i < 20; ++i) {
      const double frame =
          std::uniform_real_distribution<double>(track.front().frame, track.back().frame + 1)(random);
      for (const Interpolation how : {linear, smooth})
        ASSERT_NEAR(value_at(track, frame, how), value_at(back, 1000 - frame, how), 1e-12);
    }
  });
}

TEST(Keyframes, WhatTwoKeysShareIsHeldWithoutASwing) {
  const Track<dvec3> track{{0, {1, 1, 1}}, {10, {0.1, 0.2, 0.3}}, {20, {0.1, 0.2, 0.3}}, {25, {9, 8, 7}}};
  for (double at = 10; at <= 20; at += 0.25) EXPECT_EQ(value_at(track, at, smooth), (dvec3{0.1, 0.2, 0.3}));
  // It comes to rest and starts from rest
  EXPECT_NEAR(value_at(track, 9.999, smooth).x, 0.1, 1e-7);
  EXPECT_NEAR(value_at(track, 20.001, smooth).x, 0.1, 1e-6);
}

// --- Cameras ---------------------------------------------------------------------------------------

TEST(CameraPath, EachQuantityHasItsOwnKeys) {
  CameraPath path{0, 40, linear};
  path.eye = {{0, {0, 0, 0}}, {40, {40, 0, 0}}};
  path.vertical_radians = {{10, 0.5}, {20, 1}};
  View beside;
  beside.target = dvec3{1, 2, 3};
  const View at15 = view_at(path, beside, 15);
  EXPECT_EQ(at15.eye, (dvec3{15, 0, 0}));
  EXPECT_EQ(at15.target, (dvec3{1, 2, 3})) << "what stands beside the path stays";
  EXPECT_FALSE(at15.up);
  EXPECT_EQ(at15.vertical_radians, 0.75);
  EXPECT_EQ(view_at(path, beside, 5).vertical_radians, 0.5);
  EXPECT_EQ(view_at(path, beside, 40).vertical_radians, 1);
  EXPECT_EQ(view_at(path, beside, 12.5).eye, (dvec3{12.5, 0, 0})) << "between two frames";
}

TEST(CameraPath, AnAngleOfViewThatSwingsTooFarStaysOne) {
  CameraPath path{0, 30, smooth};
  const double wide = radians_from_degrees(179), narrow = radians_from_degrees(0.01);
  path.vertical_radians = {{0, wide}, {9, narrow}, {10, narrow + 1e-9}, {30, wide}};
  for (double at = 0; at <= 30; at += 0.125) {
    const double radians = view_at(path, {}, at).vertical_radians;
    EXPECT_GE(radians, radians_from_degrees(least_degrees));
    EXPECT_LE(radians, radians_from_degrees(most_degrees));
  }
}

SceneFile scene_in(const std::string& camera) {
  const ModelFinder find = [](const std::string&) -> std::optional<FoundModel> {
    return FoundModel{std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "m.obj",
                      [](const std::string&) { return std::nullopt; }};
  };
  return parse_scene(fmt::format("{{\"objects\": [{{\"model\": \"m.obj\"}}],\n\"camera\": {{{}}}}}", camera),
                     "s.json", find, {});
}

TEST(CameraPath, IsReadFromAScenesCamera) {
  const SceneFile file = scene_in(R"("target": [0, 1, 0], "fov": 30, "interpolation": "smooth", "path": [
    {"frame": 5, "eye": [1, 2, 3], "up": [0, 1, 0]}, {"frame": 9}, {"frame": 12, "eye": [4, 5, 6]}])");
  ASSERT_TRUE(file.path);
  EXPECT_EQ(file.path->first, 5);
  EXPECT_EQ(file.path->last, 12);
  EXPECT_EQ(file.path->interpolation, smooth);
  ASSERT_EQ(file.path->eye.size(), 2u);
  EXPECT_EQ(file.path->eye[1].frame, 12);
  EXPECT_EQ(file.path->eye[1].value, (dvec3{4, 5, 6}));
  EXPECT_EQ(file.path->up.size(), 1u);
  EXPECT_TRUE(file.path->target.empty());
  EXPECT_EQ(file.view.target, (dvec3{0, 1, 0}));
  EXPECT_FALSE(file.view.eye);
  const SceneFile turning =
      scene_in(R"("eye": [0, 0, 5], "path": [{"frame": 0, "fov": 20}, {"frame": 1, "fov": 40}])");
  EXPECT_EQ(turning.path->interpolation, linear) << "the default";
  EXPECT_NEAR(view_at(*turning.path, turning.view, 0.5).vertical_radians, radians_from_degrees(30), 1e-15);
  EXPECT_FALSE(scene_in(R"("eye": [0, 0, 5])").path);
}

TEST(CameraPath, MistakesAreBlamedOnTheirLineAndKey) {
  const auto complaint = [](const std::string& camera) -> std::string {
    try {
      scene_in(camera);
    } catch (const InputError& error) {
      return error.what();
    }
    return "(no complaint)";
  };
  const std::string a = R"({"frame": 0, "eye": [0, 0, 5]})", b = R"({"frame": 9, "eye": [0, 0, 5]})";
  const std::map<std::string, std::string> mistakes{
      {R"("path": [])", "s.json:2: /camera/path: expected a list of at least two keys, found an empty list"},
      {R"("path": [)" + a + "]", "s.json:2: /camera/path: expected a list of at least two keys"},
      {R"("path": 7)", "/camera/path: expected a list of at least two keys, found 7"},
      {R"("path": [)" + a + ", 7]", "/camera/path/1: expected an object with frame, eye, target, up, fov"},
      {R"("path": [)" + a + R"(, {"eye": [1, 2, 3]}])", "/camera/path/1: expected a key 'frame', found none"},
      {R"("path": [)" + b + ",\n" + a + "]",
       "s.json:3: /camera/path/1/frame: expected a frame after 9, that of the key before, found 0"},
      {R"("path": [)" + a + ", " + a + "]", "/camera/path/1/frame: expected a frame after 0"},
      {R"("path": [{"frame": -1, "eye": [0, 0, 5]}, )" + b + "]",
       "/camera/path/0/frame: expected a whole number from 0 to 999999, found -1"},
      {R"("path": [{"frame": 0.5, "eye": [0, 0, 5]}, )" + b + "]", "found 0.5"},
      {R"("path": [{"frame": 0}, {"frame": 9, "target": [0, 0, 0]}])",
       "/camera/path: expected an eye beside the path, or in at least one of its keys, found none"},
      {R"("eye": [1, 2, 3], "path": [)" + a + ", " + b + "]",
       "/camera/path/0/eye: expected no key \"eye\" in a path with one beside it, found one"},
      {R"("fov": 30, "path": [)" + a + R"(, {"frame": 9, "fov": 20}])",
       "/camera/path/1/fov: expected no key"},
      {R"("focal": 35, "sensor": 24, "path": [)" + a + R"(, {"frame": 9, "fov": 20}])",
       "/camera/path/1/fov: expected no key \"fov\" in a path with a focal length beside it"},
      {R"("projection": "oblique", "path": [)" + a + R"(, {"frame": 9, "fov": 20}])",
       "/camera/path/1/fov: expected no key \"fov\" beside the projection oblique, found one"},
      {R"("path": [)" + a + R"(, {"frame": 9, "fov": 180}])",
       "/camera/path/1/fov: expected the vertical angle"},
      {R"("path": [)" + a + R"(, {"frame": 9, "up": [0, 0, 0]}])", "/camera/path/1/up: expected a direction"},
      {R"("path": [)" + a + R"(, {"frame": 9, "roll": 5}])",
       "/camera/path/1: expected one of the keys frame, eye, target, up, fov, found 'roll'"},
      {R"("interpolation": "cubic", "path": [)" + a + ", " + b + "]",
       "/camera/interpolation: expected one of linear, smooth, found 'cubic'"},
      {R"("interpolation": "smooth")",
       "/camera/interpolation: expected no key \"interpolation\" without a path"}};
  for (const auto& [camera, expected] : mistakes)
    EXPECT_THAT(complaint(camera), HasSubstr(expected)) << camera;
}

}  // namespace
}  // namespace gradus::pipeline::camera_path_test
