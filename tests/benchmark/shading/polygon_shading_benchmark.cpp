// A bulge in faces of several sizes, shaded flat, by Gouraud and by Phong: how far each is from light on the
// bulge itself, and what it takes.

#include "shading/polygon_shading/polygon_shading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/raster.hpp"
#include "core/surface.hpp"
#include "shading/illumination/illumination.hpp"

namespace gradus::bench {
namespace {

using namespace polygon_shading;
using Smooth = Corner<double, Surface<double>>;
using Lit = Corner<double, double>;

constexpr int width = 128;
constexpr double radius = 80;  ///< of the sphere that the bulge is part of, in pixels
constexpr Window picture{{0, 0}, {width - 1, width - 1}};

/// The bulge above a place of the screen, and its normal.
Surface<double> bulge(dvec2 at) {
  const dvec2 from = at - 0.5 * width;
  const double z = std::sqrt(radius * radius - glm::dot(from, from) / 2);
  const dvec3 place(from / std::sqrt(2.0), z);
  return {{from, z}, place / radius};
}

double lamp(dvec3 place, dvec3 normal) {
  static const Light light{.position = {-60, 90, 200}};
  static const Material material{
      .ambient = LinearRgb{0.1f}, .diffuse = LinearRgb{0.6f}, .specular = LinearRgb{0.3f}, .shininess = 30};
  return illumination::phong(place, normal, dvec3{0, 0, 400}, material, std::span<const Light>(&light, 1),
                             LinearRgb{1})
      .sum()
      .x;
}

struct Scene {
  std::vector<std::vector<Smooth>> faces;
  std::vector<Surface<double>> vertices;
  std::vector<std::array<std::size_t, 4>> rings;

  explicit Scene(int side) {
    const double step = static_cast<double>(width) / side;
    for (int y = 0; y <= side; ++y) {
      for (int x = 0; x <= side; ++x) vertices.push_back(bulge({x * step, y * step}));
    }
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const auto first = static_cast<std::size_t>(y * (side + 1) + x),
                   across = static_cast<std::size_t>(side + 1);
        rings.push_back({first, first + 1, first + across + 1, first + across});
        faces.emplace_back();
        for (const std::size_t v : rings.back())
          faces.back().push_back({dvec2(vertices[v].place) + 0.5 * width, vertices[v]});
      }
    }
  }
};

using Picture = Raster<double>;

void shade_flat(const Scene& scene, Picture& out) {
  for (const auto& face : scene.faces)
    flat(std::span<const Smooth>(face), picture, lamp, [&](ivec2 p, double i) { out[p] = i; });
}
void shade_phong(const Scene& scene, Picture& out) {
  for (const auto& face : scene.faces)
    phong(std::span<const Smooth>(face), picture, lamp, [&](ivec2 p, double i) { out[p] = i; });
}
void shade_gouraud(const Scene& scene, Picture& out) {
  std::vector<double> lit(scene.vertices.size());
  light_vertices(std::span<const Surface<double>>(scene.vertices), lamp, std::span(lit));
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    std::array<Lit, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = {scene.faces[f][k].at, lit[scene.rings[f][k]]};
    gouraud(std::span<const Lit>(corners), picture, [&](ivec2 p, double i) { out[p] = i; });
  }
}

template <class Shade>
Case case_of(int side, const std::shared_ptr<Scene>& scene, const char* name, Standing standing,
             Shade shade) {
  const auto out = std::make_shared<Picture>(width, width);
  const auto run = [=] { shade(*scene, *out); };
  run();
  Error::Sum sum;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto [place, normal] = bulge(dvec2(x, y) + 0.5);
      sum.add(std::abs((*out)[{x, y}] - lamp(place, normal)));
    }
  }
  return {.method = name,
          .standing = standing,
          .workload = {fmt::format("{} faces", side * side), static_cast<double>(side * side)},
          .items = width * width,
          .run = run,
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int side : {2, 4, 8, 16, 32}) {
    const auto scene = std::make_shared<Scene>(side);
    all.push_back(case_of(side, scene, "flat", Standing::robust, shade_flat));
    all.push_back(case_of(side, scene, "gouraud", Standing::taught, shade_gouraud));
    all.push_back(case_of(side, scene, "phong", Standing::robust, shade_phong));
  }
  return all;
}

}  // namespace

Subject polygon_shading() {
  return {.topic = "polygon_shading",
          .title = "Shading a bulge of faces",
          .item = "pixel",
          .unit = "parts of full light",
          .measure = "faces",
          .telling = "64 faces",
          .cases = cases,
          .refined = true,
          .choice = {"phong", "highlights stay in place, however large the faces are"}};
}

}  // namespace gradus::bench
