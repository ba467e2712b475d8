#pragma once
// What stage 7 asks the textures of a scene for: the colour that a fragment's surface has there.

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "core/colour.hpp"
#include "scene/scene.hpp"
#include "shading/texture_mapping/texture_mapping.hpp"
#include "stages/6_rasterization.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A texture in linear light, and its levels.
class LinearTexture {
 public:
  /// Its texels are to be written.
  explicit LinearTexture(ivec2 size)
      : size_(size),
        count_(texture_mapping::texels_of_chain(size)),
        texels_(std::make_unique_for_overwrite<LinearRgb[]>(count_ + 1)) {
    texels_[count_] = LinearRgb{0};
  }
  explicit LinearTexture(const Image& image) : LinearTexture(ivec2{image.width(), image.height()}) {
    const auto texel = [&](ivec2 at) { return linear_from_srgb8(image[at]); };
    texture_mapping::build_mip_chain(size_, texel, texels());
  }

  ivec2 size() const { return size_; }
  /// Those of all levels. After them is one more, so that registers of four numbers can load the last.
  std::span<LinearRgb> texels() { return {texels_.get(), count_}; }
  std::span<const LinearRgb> texels() const { return {texels_.get(), count_}; }
  texture_mapping::MipChain<LinearRgb> chain() const { return {size_, texels()}; }

 private:
  ivec2 size_;
  std::size_t count_;
  std::unique_ptr<LinearRgb[]> texels_;
};

/// Textures that are decoded, by the material that has them.
using LinearTextures = std::map<const Material*, LinearTexture>;

/// The texture of a material in linear light, decoded if it is not yet among the known; null for one without.
inline const LinearTexture* add_texture(LinearTextures& known, const Material& material) {
  const Image& texels = material.diffuse_map.texels;
  if (texels.cells().empty()) return nullptr;
  return &known.try_emplace(&material, texels).first->second;
}

/// The textures of a scene, each decoded when it is first asked for.
class Textures {
 public:
  /// decoded: those that are known already, if there are any; they must outlive it.
  Textures(TextureFilter filter, Size picture, const LinearTextures* decoded = nullptr)
      : filter_(filter), picture_(picture), decoded_(decoded) {}

  /// The colour of a fragment's texture at (u, v); nothing where its material lacks one.
  std::optional<LinearRgb> at(const Fragment& f, const Triangle& t, const Material& material, dvec2 uv) {
    const LinearTexture* texture = texture_of(material);
    if (!texture) return std::nullopt;
    const auto chain = texture->chain();
    const texture_mapping::Extent extent{texture->size()};
    if (filter_ == TextureFilter::nearest) return nearest(uv, extent, chain.level(0));
    if (filter_ == TextureFilter::bilinear) return bilinear(uv, extent, chain.level(0));
    return mip_mapped(uv, footprint(f, t, uv), chain);
  }

 private:
  const LinearTexture* texture_of(const Material& material) {
    if (!decoded_) return add_texture(known_, material);
    const auto known = decoded_->find(&material);
    return known == decoded_->end() ? add_texture(known_, material) : &known->second;
  }
  /// How far (u, v) goes from this pixel to the next.
  texture_mapping::Footprint<double> footprint(const Fragment& f, const Triangle& t, dvec2 uv) {
    if (f.triangle != triangle_) {
      const auto at = [](const TriangleCorner& c) {
        return texture_mapping::Corner<double>{c.over_w, c.texture};
      };
      const auto& [a, b, c] = t.corners;
      const auto over_w = texture_mapping::over_w<double>({at(a), at(b), at(c)});
      planes_.emplace(on_grid(snapped(in_picture(t, picture_))), over_w);
      triangle_ = f.triangle;
    }
    // The shares are those on the surface: 1/w is the harmonic mean
    const double w = glm::dot(f.weights, 1.0 / over_w_of(t));
    return planes_->area(1 / w, uv);
  }

  TextureFilter filter_;
  Size picture_;
  const LinearTextures* decoded_;
  LinearTextures known_{};
  int triangle_ = -1;  ///< whose planes are kept
  std::optional<texture_mapping::Planes<double>> planes_{};
};

}  // namespace gradus::pipeline
