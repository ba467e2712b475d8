// Antialiased tiles: colours of triangles that share a pixel, mixed by the samples that show them.

#include <algorithm>
#include <span>

#include "engine/tile_shader.hpp"

namespace gradus::pipeline::engine {
namespace {

constexpr ivec2 middle{triangle_coverage::subpixels / 2, triangle_coverage::subpixels / 2};

/// Where a triangle's colour in a pixel is asked for: adaptive::colour_place. places: nearest to the centre
/// first.
ivec2 colour_place(const triangle_coverage::Edges& edges, ivec2 pixel, std::span<const ivec2> places) {
  const auto covered = [&](ivec2 place) {
    return holds(edges, weights_at_place(edges, pixel * triangle_coverage::subpixels + place));
  };
  if (covered(middle)) return middle;
  const auto found = std::ranges::find_if(places, covered);
  return found == places.end() ? middle : *found;
}

}  // namespace

/// Tells pixels that show one triangle alone, in whole_, from those that are mixed. Returns how many show
/// something.
std::int64_t TileShader::find_fragments(const Window& pixels, const SampleBuffer& buffer,
                                        std::span<const ivec2> places) {
  const Frame& frame = shading_.frame();
  whole_.ids = buffer.whole;
  fragments_.clear();
  shown_.clear();
  found_.clear();
  find_shown(frame, pixels, places, buffer, shown_);
  for (std::size_t cell = 0; cell < TileBuffer::cells; ++cell)
    if (buffer.sampled[cell] >= 0) whole_.ids[cell] = no_triangle;
  for (const auto& [cell, id, samples] : shown_) {
    const auto edges = triangle_coverage::edges_of(frame.triangle(id).grid);
    const ivec2 place = colour_place(edges, pixels.lower + TileBuffer::place(cell), places);
    if (samples == std::ssize(places) && place == middle)
      whole_.ids[cell] = id;
    else
      found_.push_back({id, {0, samples, cell, place}});
  }
  std::int64_t covered = find_seen(whole_);
  for (auto& [id, fragment] : found_) {
    fragment.slot = slot_of(id);
    covered += fragments_.empty() || fragments_.back().cell != fragment.cell;
    ++seen_[static_cast<std::size_t>(fragment.slot)].pixels;
    fragments_.push_back(fragment);
  }
  return covered;
}

/// The light of fragments of one group.
void TileShader::light_group(std::int32_t number, ivec2 origin) {
  const auto& of = fragments_of_[static_cast<std::size_t>(share_of_group_[static_cast<std::size_t>(number)])];
  if (of.empty()) return;
  const std::size_t count = (of.size() + block_cells - 1) / block_cells * block_cells;
  columns_.resize(count);
  rows_.resize(count);
  fragment_slots_.resize(count);
  light_.resize(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Fragment& fragment = fragments_[static_cast<std::size_t>(of[std::min(i, of.size() - 1)])];
    const ivec2 at = TileBuffer::place(fragment.cell), from_middle = fragment.place - middle;
    columns_[i] = static_cast<float>(at.x) + static_cast<float>(from_middle.x) / triangle_coverage::subpixels;
    rows_[i] = static_cast<float>(at.y) + static_cast<float>(from_middle.y) / triangle_coverage::subpixels;
    fragment_slots_[i] = fragment.slot;
  }
  const ShadingGroup& group = shading_.groups()[static_cast<std::size_t>(number)];
  const LitCells lit{&group, records_.data(), shading_.scene().shading == Shading::phong, shading_.towards()};
  light_places(lit, {columns_, rows_, fragment_slots_, light_});
  for (std::size_t i = 0; i < of.size(); ++i) {
    const Fragment& fragment = fragments_[static_cast<std::size_t>(of[i])];
    const Seen& seen = seen_[static_cast<std::size_t>(fragment.slot)];
    const ivec2 pixel = origin + TileBuffer::place(fragment.cell);
    fragment_light_[static_cast<std::size_t>(of[i])] =
        light_[i] < 0 || seen.careful
            ? surfaces_.colour(seen.id, pixel, pixel * triangle_coverage::subpixels + fragment.place)
            : LinearRgb{light_[i], light_[count + i], light_[2 * count + i]};
  }
}

void TileShader::light_fragments(ivec2 origin) {
  fragment_light_.resize(fragments_.size());
  fragments_of_.resize(std::max(fragments_of_.size(), groups_here_.size()));
  for (auto& list : fragments_of_) list.clear();
  for (std::size_t i = 0; i < fragments_.size(); ++i) {
    const std::int32_t group = seen_[static_cast<std::size_t>(fragments_[i].slot)].group;
    fragments_of_[static_cast<std::size_t>(share_of_group_[static_cast<std::size_t>(group)])].push_back(
        static_cast<std::int32_t>(i));
  }
  for (const std::int32_t number : groups_here_) light_group(number, origin);
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
