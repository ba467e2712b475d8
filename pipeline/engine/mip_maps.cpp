#include "engine/mip_maps.hpp"

#include <array>
#include <cstdint>

#include "core/colour.hpp"
#include "engine/cores.hpp"

namespace gradus::pipeline::engine {
namespace {

using texture_mapping::covered_mean;

/// Texels that are worth a thread's while.
constexpr int texels_at_once = 1 << 14;

/// Calls write(y, row) for every row of a level.
template <class Write>
void write_rows(ivec2 size, LinearRgb* level, const Write& write) {
  const auto columns = static_cast<std::size_t>(size.x), grain = texels_at_once / columns + 1;
  in_parts(static_cast<std::size_t>(size.y), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) write(y, level + y * columns);
  });
}

void write_picture(const Image& texels, LinearRgb* level) {
  std::array<float, 256> light;
  for (std::size_t byte = 0; byte < light.size(); ++byte)
    light[byte] = linear_from_srgb8(static_cast<std::uint8_t>(byte));
  write_rows({texels.width(), texels.height()}, level, [&](std::size_t y, LinearRgb* row) {
    for (const Rgba8 texel : texels.row(static_cast<int>(y)))
      *row++ = {light[texel.r], light[texel.g], light[texel.b]};
  });
}

/// What covered_mean gives where columns and rows are even, in its order of operations.
LinearRgb mean_of_four(const LinearRgb* above, const LinearRgb* below, float parts, float all) {
  const LinearRgb first = above[0];
  const LinearRgb sum = parts * (above[1] - first) + parts * (below[0] - first) + parts * (below[1] - first);
  return first + sum / all;
}

/// Writes the level that comes after one of this size.
void write_next(ivec2 size, const LinearRgb* before, LinearRgb* next) {
  const ivec2 to = texture_mapping::size_of_level(size, 1);
  const auto columns = static_cast<std::size_t>(size.x);
  const auto parts = static_cast<float>(to.x * to.y), all = static_cast<float>(size.x * size.y);
  const auto texel = [&](ivec2 at) {
    return before[static_cast<std::size_t>(at.y) * columns + static_cast<std::size_t>(at.x)];
  };
  write_rows(to, next, [&](std::size_t y, LinearRgb* row) {
    if (size.x % 2 != 0 || size.y % 2 != 0) {
      for (int x = 0; x < to.x; ++x) row[x] = covered_mean(ivec2{x, static_cast<int>(y)}, size, texel);
      return;
    }
    const LinearRgb* const above = before + 2 * y * columns;
    for (std::size_t x = 0; x < columns / 2; ++x)
      row[x] = mean_of_four(above + 2 * x, above + columns + 2 * x, parts, all);
  });
}

}  // namespace

LinearTexture linear_texture(const Image& texels) {
  const ivec2 size{texels.width(), texels.height()};
  LinearTexture texture(size);
  LinearRgb* const levels = texture.texels().data();
  write_picture(texels, levels);
  for (int k = 1; k < texture_mapping::levels_of(size); ++k)
    write_next(texture_mapping::size_of_level(size, k - 1),
               levels + texture_mapping::begin_of_level(size, k - 1),
               levels + texture_mapping::begin_of_level(size, k));
  return texture;
}

}  // namespace gradus::pipeline::engine
