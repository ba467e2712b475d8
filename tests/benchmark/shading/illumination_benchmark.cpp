// Places under a point, a spot and rectangles: what Phong's and Blinn's models take, and how far rectangles
// of 2 x 2, 4 x 4 and 8 x 8 points are from Lambert's integral.

#include "shading/illumination/illumination.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace illumination;

struct Places {
  std::vector<dvec3> at;
  std::vector<double> light;

  explicit Places(std::size_t count) : light(count) {
    Random random(1975);
    for (std::size_t i = 0; i < count; ++i) at.push_back({random.uniform(-2, 2), random.uniform(-2, 2), 0});
  }
};

constexpr dvec3 up{0, 0, 1}, eye{1, -4, 5};
const Reflectance<double> shiny{
    .ambient = dvec3{0}, .diffuse = dvec3{0.7}, .specular = dvec3{0.2}, .shininess = 32};
const Reflectance<double> matt{.ambient = dvec3{0}, .diffuse = dvec3{1}};

Light rectangle(int samples) {
  Light light{.kind = Light::Kind::area, .position = {0.5, 0.5, 3}, .constant = 0, .quadratic = 1};
  light.across = {0, 1.5, 0}, light.along = {1.5, 0, 0};
  light.samples = samples;
  return light;
}

/// Lambert's formula for the light of the whole rectangle.
long double lamberts(const dvec3& place) {
  using Vec = glm::vec<3, long double>;
  constexpr std::array<dvec2, 4> signs{{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}};
  const Light light = rectangle(1);
  std::array<Vec, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = Vec(light.position - place) + 0.5L * signs[k].x * Vec(light.across) +
                 0.5L * signs[k].y * Vec(light.along);
  }
  long double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec a = corners[k], b = corners[(k + 1) % 4], across = glm::cross(a, b);
    const long double size = std::sqrt(glm::dot(across, across));
    sum += std::atan2(size, glm::dot(a, b)) * across.z / size;
  }
  return 0.5L * std::abs(sum) / (1.5L * 1.5L);
}

/// The shaded light of a lamp in long double, by Phong or by Blinn.
long double shaded(const dvec3& place, bool halfway) {
  using Vec = glm::vec<3, long double>;
  const auto unit = [](const Vec& v) { return v / std::sqrt(glm::dot(v, v)); };
  const Vec l = unit(Vec(rectangle(1).position) - Vec(place)), v = unit(Vec(eye) - Vec(place));
  const Vec r = halfway ? unit(l + v) : Vec(-l.x, -l.y, l.z);
  const long double cosine = halfway ? r.z : glm::dot(r, v);
  return (long double)(0.7) * l.z + (long double)(0.2) * std::pow(std::max(cosine, 0.0L), 32.0L);
}

template <class Run, class Right>
Case case_of(std::size_t count, const char* name, Standing standing, Run light_at, Right right) {
  const auto places = std::make_shared<Places>(count);
  const auto run = [=] {
    for (std::size_t i = 0; i < places->at.size(); ++i) places->light[i] = light_at(places->at[i]);
  };
  run();
  Error::Sum sum;
  for (std::size_t i = 0; i < count; ++i)
    sum.add(std::abs(static_cast<double>(places->light[i] - right(places->at[i]))));
  return {.method = name,
          .standing = standing,
          .workload = {fmt::format("{} places", count), static_cast<double>(count)},
          .items = static_cast<std::int64_t>(count),
          .run = run,
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::size_t count : {64u, 256u, 1024u, 4096u}) {
    const auto point = [](auto method, const auto& surface) {
      return [=](const dvec3& place) {
        const Light light{.position = rectangle(1).position};
        return method(place, surface, std::span<const Light>(&light, 1));
      };
    };
    const auto by_phong = [](const dvec3& place, const auto& surface, std::span<const Light> lights) {
      return phong(place, up, eye, surface, lights, dvec3{0}).sum().x;
    };
    const auto by_blinn = [](const dvec3& place, const auto& surface, std::span<const Light> lights) {
      return blinn_phong(place, up, eye, surface, lights, dvec3{0}, AllSeen{}).sum().x;
    };
    all.push_back(case_of(count, "phong", Standing::taught, point(by_phong, shiny),
                          [](const dvec3& p) { return shaded(p, false); }));
    all.push_back(case_of(count, "blinn_phong", Standing::robust, point(by_blinn, shiny),
                          [](const dvec3& p) { return shaded(p, true); }));
    constexpr std::array<std::pair<int, const char*>, 3> areas{
        {{2, "area_2x2"}, {4, "area_4x4"}, {8, "area_8x8"}}};
    for (const auto& [samples, name] : areas) {
      const auto lit = [light = rectangle(samples), by_phong](const dvec3& place) {
        return by_phong(place, matt, std::span<const Light>(&light, 1));
      };
      all.push_back(case_of(count, name, Standing::robust, lit, lamberts));
    }
  }
  return all;
}

}  // namespace

Subject illumination() {
  return {.topic = "illumination",
          .title = "Illuminating places",
          .item = "place",
          .unit = "parts of full light",
          .measure = "places",
          .telling = "1024 places",
          .cases = cases,
          .choice = {"phong", "for lamps that are points; an area is a grid of such points"}};
}

}  // namespace gradus::bench
