#pragma once
// Pixels by the textbook's arithmetic: one triangle after the other.

#include "engine/geometry.hpp"
#include "engine/pixel_colours.hpp"
#include "engine/visibility_batch.hpp"
#include "stages/7_visibility_and_shading.hpp"

namespace gradus::pipeline::engine {

/// The surface of one triangle after the other. One per thread: it keeps what stage 7 keeps.
class Surfaces {
 public:
  Surfaces(const Scene& scene, const Buffers& buffers, const Plan& plan, const Frame& frame)
      : frame_(frame), light_(scene, plan.size, &plan, &buffers.textures) {}

  /// The colour that a triangle has in the centre of a pixel. Accuracy: the bits of `shade`.
  LinearRgb colour(std::int32_t id, ivec2 pixel) {
    return colour(id, pixel, triangle_coverage::centre_of(pixel));
  }
  /// The same at a place of the picture that the triangle covers, in 1/256 pixel.
  LinearRgb colour(std::int32_t id, ivec2 pixel, ivec2 place) {
    turn_to(id);
    const auto w = weights_at_place(edges_, place);
    return colours_(light_, {triangle_.id, id, pixel, 0, shares_of(w, over_w_)}, triangle_);
  }
  /// The light of a triangle's whole face, before its texture: of flat shading.
  Parts of_face(std::int32_t id) {
    turn_to(id);
    return light_.at({triangle_.id, id}, triangle_, Surface{});
  }
  const ShadingCount& count() const { return light_.count(); }

 private:
  void turn_to(std::int32_t id) {
    if (id == id_) return;
    id_ = id;
    triangle_ = whole_triangle(light_.scene(), frame_, id);
    edges_ = triangle_coverage::edges_of(frame_.triangle(id).grid);
    over_w_ = over_w_of(triangle_);
  }

  const Frame& frame_;
  SceneLight light_;
  PixelColours colours_;
  std::int32_t id_ = no_triangle;
  Triangle triangle_;
  triangle_coverage::Edges edges_;
  dvec3 over_w_{0};
};

}  // namespace gradus::pipeline::engine
