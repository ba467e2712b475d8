// Antialiased tiles: colours of triangles that share a pixel, mixed by the samples that show them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "engine/tile_shader.hpp"

namespace gradus::pipeline::engine {
/// Tells pixels that show one triangle alone, in whole_, from those that are mixed. Returns how many show
/// something.
std::int64_t TileShader::find_fragments(const Window& pixels, const SampleBuffer& buffer,
                                        std::span<const ivec2> places) {
  whole_.ids = buffer.whole;
  for (const std::int32_t cell : buffer.sampled_cells)
    whole_.ids[static_cast<std::size_t>(cell)] = no_triangle;
  fragments_.clear();
  shown_.clear();
  find_shown(shading_.frame(), pixels, places, buffer, shown_);
  std::int64_t covered = 0;
  // Pixels beside one another show the same triangles
  std::array<std::int32_t, 4> ids, slots;
  ids.fill(no_triangle);
  for (const ShownTriangle& shown : shown_) {
    if (shown.samples == std::ssize(places) && shown.place == pixel_middle) {
      whole_.ids[shown.cell] = shown.id;
      continue;
    }
    covered += fragments_.empty() || fragments_.back().cell != shown.cell;
    Fragment& fragment = fragments_.emplace_back();
    const std::size_t known = static_cast<std::uint32_t>(shown.id) % ids.size();
    if (ids[known] != shown.id) {
      ids[known] = shown.id;
      slots[known] = slot_of(shown.id);
    }
    fragment.slot = slots[known];
    fragment.samples = shown.samples;
    fragment.cell = shown.cell;
    fragment.place = shown.place;
    const ivec2 at = TileBuffer::place(shown.cell), from_middle = shown.place - pixel_middle;
    fragment.column =
        static_cast<float>(at.x) + static_cast<float>(from_middle.x) / triangle_coverage::subpixels;
    fragment.row =
        static_cast<float>(at.y) + static_cast<float>(from_middle.y) / triangle_coverage::subpixels;
    ++seen_[static_cast<std::size_t>(fragment.slot)].pixels;
  }
  return covered + find_seen(whole_);
}

/// The light of fragments of one group: of all, or of those listed.
void TileShader::light_group(std::int32_t number, bool alone, ivec2 origin) {
  const auto& of = fragments_of_[static_cast<std::size_t>(share_of_group_[static_cast<std::size_t>(number)])];
  const std::size_t some = alone ? fragments_.size() : of.size();
  if (some == 0) return;
  const std::size_t count = (some + block_cells - 1) / block_cells * block_cells;
  columns_.resize(count);
  rows_.resize(count);
  fragment_slots_.resize(count);
  light_.resize(3 * count);
  const auto nth = [&](std::size_t i) { return alone ? i : static_cast<std::size_t>(of[i]); };
  for (std::size_t i = 0; i < count; ++i) {
    const Fragment& fragment = fragments_[nth(std::min(i, some - 1))];
    columns_[i] = fragment.column;
    rows_[i] = fragment.row;
    fragment_slots_[i] = fragment.slot;
  }
  const ShadingGroup& group = shading_.groups()[static_cast<std::size_t>(number)];
  const LitCells lit{&group, records_.data(), shading_.scene().shading == Shading::phong, shading_.towards()};
  light_places(lit, {columns_, rows_, fragment_slots_, light_});
  for (std::size_t i = 0; i < some; ++i) {
    const Fragment& fragment = fragments_[nth(i)];
    LinearRgb& light = fragment_light_[nth(i)];
    light = {light_[i], light_[count + i], light_[2 * count + i]};
    const Seen& seen = seen_[static_cast<std::size_t>(fragment.slot)];
    if (!(light.r < 0 || seen.careful)) continue;
    const ivec2 pixel = origin + TileBuffer::place(fragment.cell);
    light = surfaces_.colour(seen.id, pixel, pixel * triangle_coverage::subpixels + fragment.place);
  }
}

void TileShader::light_fragments(ivec2 origin) {
  fragment_light_.resize(fragments_.size());
  fragments_of_.resize(std::max(fragments_of_.size(), groups_here_.size()));
  const bool alone = groups_here_.size() == 1;
  if (!alone) list_fragments();
  for (const std::int32_t number : groups_here_) light_group(number, alone, origin);
}

/// Sorts the fragments by groups.
void TileShader::list_fragments() {
  for (auto& list : fragments_of_) list.clear();
  for (std::size_t i = 0; i < fragments_.size(); ++i) {
    const std::int32_t group = seen_[static_cast<std::size_t>(fragments_[i].slot)].group;
    fragments_of_[static_cast<std::size_t>(share_of_group_[static_cast<std::size_t>(group)])].push_back(
        static_cast<std::int32_t>(i));
  }
}

/// Mixes the fragments of each pixel, and the background where samples show none.
void TileShader::mix_fragments(std::size_t samples) {
  const std::size_t most = (fragments_.size() + block_cells - 1) / block_cells * block_cells;
  mixed_cells_.clear();
  light_.assign(3 * most, 0);
  const LinearRgb background = shading_.scene().background;
  const float one = 1 / static_cast<float>(samples);
  for (std::size_t i = 0; i < fragments_.size();) {
    const std::size_t cell = fragments_[i].cell;
    LinearRgb sum{0};
    auto left = static_cast<std::int32_t>(samples);
    for (; i < fragments_.size() && fragments_[i].cell == cell; ++i) {
      sum += static_cast<float>(fragments_[i].samples) * fragment_light_[i];
      left -= fragments_[i].samples;
    }
    sum += static_cast<float>(left) * background;
    for (int axis = 0; axis < 3; ++axis)
      light_[static_cast<std::size_t>(axis) * most + mixed_cells_.size()] = one * sum[axis];
    mixed_cells_.push_back(cell);
  }
  packed_.resize(most);
  pack(light_, packed_);
  for (std::size_t i = 0; i < mixed_cells_.size(); ++i) colours_[mixed_cells_[i]] = packed_[i];
}

std::int64_t TileShader::mix(const Window& pixels, const SampleBuffer& buffer, std::span<const ivec2> places,
                             Image& image) {
  begin();
  const std::int64_t covered = find_fragments(pixels, buffer, places);
  if (covered > 0) {
    describe_all(pixels, true);
    light_whole_pixels(whole_, pixels.lower);
    light_fragments(pixels.lower);
    mix_fragments(places.size());
  }
  write(pixels, image);
  return covered;
}

}  // namespace gradus::pipeline::engine
