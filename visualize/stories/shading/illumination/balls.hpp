#pragma once
// The terms of the model as rendered balls: each normal of a ball gets what the place would get with that
// normal, seen along the way to the eye. So the place's own normal shows the place's own colour.

#include <array>
#include <vector>

#include "figure/tone_of.hpp"
#include "stories/shading/illumination/subject.hpp"

namespace gradus::illumination {

/// Drawings with pictures in them have units of so many cells.
inline constexpr int cells_of_unit = 8;
inline dvec2 in_cells(dvec2 units) { return (units + 0.5) * double(cells_of_unit) - 0.5; }
inline View in_cells(View view) {
  const auto move = [](dvec2& p) { p = in_cells(p); };
  const auto move_all = [&](std::vector<dvec2>& points) {
    for (dvec2& p : points) move(p);
  };
  for (auto& [id, mark] : view.marks) {
    if (auto* stroke = std::get_if<Stroke>(&mark.shape)) {
      move(stroke->a);
      move(stroke->b);
    } else if (auto* path = std::get_if<Path>(&mark.shape)) {
      move_all(path->points);
    } else if (auto* area = std::get_if<Area>(&mark.shape)) {
      for (auto& ring : area->rings) move_all(ring);
    } else {
      std::visit(
          [&](auto& shape) {
            if constexpr (requires { shape.at; }) move(shape.at);
          },
          mark.shape);
    }
  }
  return view;
}

/// A paper of so many units.
inline void lay_paper(Narrator& narrator, int width, int height) {
  narrator.paper(width * cells_of_unit, height * cells_of_unit);
  // Its cells are fine pixels; where vectors had no room for their names, they are worth more than balls
  narrator.trace().grid.lines = 1.6;
}

class Balls {
 public:
  static constexpr int side = 54;          ///< of a picture, in cells
  static constexpr int pixels = 3 * side;  ///< of a picture, either way
  static constexpr std::size_t count = 4;

  /// parts(normal): ambient, scattered and highlight. left: what the drawing has there.
  template <class PartsOf>
  Balls(const Subject& subject, dvec3 left, const PartsOf& parts) {
    const dvec3 towards = unit_vector(subject.eye - subject.place);
    if (towards == dvec3{0}) return;
    dvec3 right = glm::dot(left, towards) * towards - left;
    if (glm::length(right) < 1e-6) right = glm::cross(towards, dvec3{towards.z, towards.x, -towards.y});
    right = unit_vector(right);
    const dvec3 up = glm::cross(towards, right);
    if (glm::dot(subject.normal, towards) > 0)
      own_ =
          0.5 * side + side * radius * dvec2{glm::dot(subject.normal, right), glm::dot(subject.normal, up)};
    std::array<Image, count> images;
    images.fill(Image(pixels, pixels));
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        const dvec2 at = (dvec2{x, pixels - 1 - y} + 0.5 - 0.5 * pixels) / (radius * pixels);
        const double part = covered({x, y});
        const dvec2 p = at / std::max(1.0, glm::length(at) / 0.999);
        const dvec3 normal = p.x * right + p.y * up + std::sqrt(1 - glm::dot(p, p)) * towards;
        const std::array<dvec3, count> terms =
            part > 0 ? terms_of(parts(normal)) : std::array<dvec3, count>{};
        for (std::size_t k = 0; k < count; ++k)
          images[k][{x, y}] = tone_of(part * terms[k] + (1 - part) * dvec3{ground});
      }
    }
    for (std::size_t k = 0; k < count; ++k)
      pictures_[k] = std::make_shared<const Image>(std::move(images[k]));
  }

  /// Nothing where the eye is in the place itself.
  bool empty() const { return !pictures_[0]; }
  /// The k-th picture, its lower left cell here. They explain the drawing: among many they are left out.
  void add(View& view, const std::string& id, std::size_t k, ivec2 corner) const {
    const dvec2 lower = dvec2(corner) - 0.5;
    view.add({id, Role::guide, Picture{lower, lower + double(side), pictures_[k], true}});
  }
  /// Where a picture shows the normal of the place, in cells from its corner, if it does.
  const std::optional<dvec2>& own() const { return own_; }

 private:
  static constexpr double radius = 0.46;  ///< of a side
  static constexpr double ground = 0.04;

  static std::array<dvec3, count> terms_of(const Parts<double>& parts) {
    std::array<dvec3, count> terms{parts.ambient, parts.diffuse, parts.specular, parts.sum()};
    for (dvec3& term : terms) {
      for (int k = 0; k < 3; ++k) term[k] = std::isfinite(term[k]) ? std::max(0.0, term[k]) : 0;
    }
    return terms;
  }
  /// How much of a pixel the ball covers.
  static double covered(ivec2 pixel) {
    constexpr int parts = 4;
    int inside = 0;
    for (int i = 0; i < parts * parts; ++i) {
      const dvec2 at = dvec2(pixel) + (dvec2{i % parts, i / parts} + 0.5) / double(parts) - 0.5 * pixels;
      inside += length_of(at) < radius * pixels;
    }
    return inside / double(parts * parts);
  }

  std::array<std::shared_ptr<const Image>, count> pictures_{};
  std::optional<dvec2> own_{};
};

}  // namespace gradus::illumination
