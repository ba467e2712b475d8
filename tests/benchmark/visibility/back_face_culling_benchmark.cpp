// Which side of a triangle an eye sees: by normal and view vector, by the area in the picture, before the
// division, and as the notes have it, each with the signs that it gets wrong.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

namespace gradus::bench {
namespace {

using namespace back_face_culling;

using Sides = std::vector<char>;

/// Triangles in view space, x, y, w; their outlines, and the side of each without rounding.
struct Scene {
  std::vector<std::vector<dvec3>> rings{};
  std::vector<std::vector<dvec2>> rings_in_picture{};
  std::vector<std::vector<dvec3>> rings_in_world{};  ///< right-handed, z towards the eye
  std::vector<Face<double>> faces{}, world{};
  std::vector<Outline<double>> outlines{};
  Sides front{};
};
using ScenePtr = std::shared_ptr<const Scene>;

/// thin: the eye lies in their planes but for the last places.
ScenePtr scene_of(int count, bool thin) {
  Random random(23, static_cast<std::uint64_t>(count));
  auto scene = std::make_shared<Scene>();
  for (int i = 0; i < count; ++i) {
    const auto corner = [&] {
      return dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 4)};
    };
    const dvec3 a = corner(), b = corner();
    dvec3 c = corner();
    if (thin) {
      const double s = random.uniform(0.2, 1), t = random.uniform(0.2, 1);
      for (int k = 0; k < 3; ++k)
        c[k] = (s * a[k] + t * b[k]) * (1 + double(random.uniform_int(-3, 3)) * 0x1p-52);
    }
    scene->rings.push_back({a, b, c});
  }
  for (const auto& ring : scene->rings) {
    scene->faces.push_back(ring);
    scene->rings_in_picture.emplace_back();
    scene->rings_in_world.emplace_back();
    for (const dvec3 p : ring) {
      scene->rings_in_picture.back().push_back(dvec2(p) / p.z);
      scene->rings_in_world.back().push_back({p.x, p.y, -p.z});
    }
    scene->front.push_back(orient3d(ring[0], ring[1], ring[2], dvec3{0}) < 0);
  }
  for (const auto& ring : scene->rings_in_picture) scene->outlines.push_back(ring);
  for (const auto& ring : scene->rings_in_world) scene->world.push_back(ring);
  return scene;
}

Error error_of(const Scene& scene, const Sides& drawn) {
  Error::Sum sum;
  for (std::size_t i = 0; i < scene.front.size(); ++i) {
    if (drawn[i] != scene.front[i]) sum.wrong_decision();
  }
  return sum.error();
}

void add_cases(std::vector<Case>& all, const Workload& workload, int count, bool thin) {
  const ScenePtr scene = scene_of(count, thin);
  const auto add = [&](const char* name, Standing standing, auto method) {
    const auto drawn = std::make_shared<Sides>(scene->front.size());
    const auto run = [scene, drawn, method] { method(*scene, [&](std::size_t i) { (*drawn)[i] = 1; }); };
    run();
    all.push_back({.method = name,
                   .standing = standing,
                   .workload = workload,
                   .items = count,
                   .run = run,
                   .error = error_of(*scene, *drawn)});
  };
  const Eye<double> eye{0, 0, 0, 1};
  add("normal_and_view", Standing::robust,
      [eye](const Scene& s, const auto& draw) { normal_and_view<double>(s.world, eye, draw); });
  add("first_three_corners", Standing::faulty,
      [eye](const Scene& s, const auto& draw) { first_three_corners<double>(s.world, eye, draw); });
  add("homogeneous", Standing::robust,
      [](const Scene& s, const auto& draw) { homogeneous<double>(s.faces, draw); });
  add("screen_area", Standing::taught,
      [](const Scene& s, const auto& draw) { screen_area<double>(s.outlines, draw); });
  add("after_division", Standing::faulty,
      [](const Scene& s, const auto& draw) { after_division<double>(s.faces, draw); });
  add("six_products", Standing::faulty,
      [](const Scene& s, const auto& draw) { six_products<double>(s.outlines, draw); });
  add("eye_space_normal", Standing::faulty,
      [](const Scene& s, const auto& draw) { eye_space_normal<double>(s.faces, draw); });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, {"random"}, 1024, false);
  add_cases(all, {"slivers"}, 1024, true);
  for (const int count : {64, 1024, 16384})
    add_cases(all, {fmt::format("{} triangles", count), static_cast<double>(count)}, count, false);
  return all;
}

}  // namespace

Subject back_face_culling() {
  return {.topic = "back_face_culling",
          .title = "Which side of a triangle is seen",
          .item = "triangle",
          .unit = "wrong sides",
          .measure = "triangles",
          .telling = "slivers",
          .cases = cases,
          .choice = {"normal_and_view", "right for every triangle, before any corner is transformed"}};
}

}  // namespace gradus::bench
