#include "engine/tile_shader.hpp"

#include <algorithm>
#include <type_traits>

namespace gradus::pipeline::engine {
namespace {

constexpr std::size_t full = block_cells;

}  // namespace

TileShader::TileShader(const FrameShading& shading)
    : shading_(shading),
      surfaces_(shading.scene(), shading.buffers(), shading.plan(), shading.frame()),
      background_(packed(shading.scene().background)),
      table_(256, -1),
      share_of_group_(shading.groups().size(), -1) {}

void TileShader::Share::clear() {
  blocks.clear();
  triangles = 0;
  pixels = 0;
}

/// Adds one of the triangles of a block. Blocks come one after the other.
void TileShader::Share::add(const ShownBlock& shown, std::size_t which) {
  const std::int32_t id = shown.ids[which], slot = shown.slots[which];
  if (blocks.empty() || blocks.back().block != shown.block || blocks.back().triangles == 3) {
    blocks.push_back({shown.block, 1, {id, id, id}, {}, {slot, slot, slot}});
    return;
  }
  ShownBlock& last = blocks.back();
  const auto next = static_cast<std::size_t>(last.triangles++);
  last.slots[next] = slot;
  last.ids[next] = id;
}

/// The place of a triangle among those that are seen.
std::int32_t TileShader::slot_of(std::int32_t id) {
  const std::size_t mask = table_.size() - 1;
  // Fibonacci hashing, then the next free place
  std::size_t at = static_cast<std::size_t>(static_cast<std::uint32_t>(id) * 2654435769U >> 12) & mask;
  while (table_[at] >= 0 && seen_[static_cast<std::size_t>(table_[at])].id != id) at = (at + 1) & mask;
  if (table_[at] < 0) {
    table_[at] = static_cast<std::int32_t>(seen_.size());
    seen_.push_back({id, 0, 0, false});
    if (2 * seen_.size() > table_.size()) grow_table();
    return static_cast<std::int32_t>(seen_.size()) - 1;
  }
  return table_[at];
}

void TileShader::grow_table() {
  const std::vector<Seen> seen = std::move(seen_);
  seen_.clear();
  table_.assign(2 * table_.size(), -1);
  for (const Seen& one : seen) slot_of(one.id);
  seen_ = seen;
}

/// Records of all triangles that are seen. squares: they were asked for by the squares of pixels.
void TileShader::describe_all(const Window& pixels, bool squares) {
  // A part of a picture has the bits of the whole
  const AskedPixels asked{
      pixels.lower, intersection(square_with(pixels.lower), picture_window(shading_.plan().size)), squares};
  records_.resize((seen_.size() + full - 1) / full);
  for (std::size_t i = 0; i < seen_.size(); i += full) describe(asked, i, records_[i / full]);
}

/// What the triangle of a slot is, ever more of it the nearer its turn.
void TileShader::fetch_ahead(std::size_t slot) const {
  const auto ahead = [&](std::size_t by, const auto& fetch) {
    if (slot + by < seen_.size()) fetch(seen_[slot + by].id);
  };
  ahead(12, [&](std::int32_t id) { __builtin_prefetch(&shading_.frame().triangle(id)); });
  ahead(8, [&](std::int32_t id) { shading_.fetch_face(id); });
  ahead(4, [&](std::int32_t id) { shading_.fetch_corners(id); });
}

/// Up to sixteen of them, from a slot on.
void TileShader::describe(const AskedPixels& asked, std::size_t slot, RecordBlock& records) {
  const std::span some = std::span(seen_).subspan(slot, std::min(full, seen_.size() - slot));
  triangles_.count = some.size();
  for (std::size_t k = 0; k < some.size(); ++k) {
    fetch_ahead(slot + k);
    some[k].group = shading_.put(some[k].id, k, triangles_);
  }
  if (shading_.scene().shading == Shading::flat) put_light_of_faces(some);
  const std::uint32_t careful = engine::describe(shading_, asked, triangles_, records);
  for (std::size_t k = 0; k < some.size(); ++k) {
    some[k].careful = (careful >> k & 1) != 0;
    add_to_share(some[k]);
  }
}

void TileShader::add_to_share(const Seen& seen) {
  std::int32_t& number = share_of_group_[static_cast<std::size_t>(seen.group)];
  if (number < 0) {
    number = static_cast<std::int32_t>(groups_here_.size());
    groups_here_.push_back(seen.group);
    if (shares_.size() < groups_here_.size()) shares_.emplace_back();
    shares_[static_cast<std::size_t>(number)].clear();
  }
  Share& share = shares_[static_cast<std::size_t>(number)];
  ++share.triangles;
  share.pixels += seen.pixels;
}

/// Flat: light of whole faces. Without a texture both kinds are one.
void TileShader::put_light_of_faces(std::span<const Seen> some) {
  for (std::size_t k = 0; k < some.size(); ++k) {
    const Parts light = surfaces_.of_face(some[k].id);
    const bool apart = shading_.groups()[static_cast<std::size_t>(some[k].group)].has_texture();
    const dvec3 scattered = light.ambient + light.diffuse,
                first = apart ? scattered : scattered + light.specular;
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<std::size_t>(axis);
      triangles_.face_light[value][k] = static_cast<float>(first[axis]);
      triangles_.face_light[value + 3][k] = static_cast<float>(light.specular[axis]);
    }
  }
}

/// Adds to the pixels that are done with care those that batches left in doubt.
void TileShader::take_doubtful(const TileBuffer& buffer) {
  for (std::size_t cell = 0; cell < TileBuffer::cells; ++cell)
    if (buffer.ids[cell] != no_triangle && colours_[cell] == 0) careful_cells_.push_back(cell);
}

/// By the textbook's arithmetic.
void TileShader::colour_carefully(const TileBuffer& buffer, ivec2 origin) {
  for (const std::size_t cell : careful_cells_)
    colours_[cell] = packed(surfaces_.colour(buffer.ids[cell], origin + TileBuffer::place(cell)));
}

/// Whether batches light all that is seen alike.
bool TileShader::is_of_one_kind() const {
  return groups_here_.size() == 1 && std::ranges::none_of(seen_, &Seen::careful);
}

/// The group of all that a block shows, or -1: there are several, or batches do not light all.
std::int32_t TileShader::group_of(const ShownBlock& shown) const {
  const auto seen = [&](std::size_t k) -> const Seen& {
    return seen_[static_cast<std::size_t>(shown.slots[k])];
  };
  const std::int32_t group = seen(0).group;
  for (std::size_t k = 0; k < static_cast<std::size_t>(shown.triangles); ++k)
    if (seen(k).group != group || seen(k).careful) return -1;
  return group;
}

/// Sorts what blocks show by groups.
void TileShader::sort(const TileBuffer& buffer) {
  for (const ShownBlock& shown : in_blocks()) {
    if (const std::int32_t group = group_of(shown); group >= 0)
      share_of(group).blocks.push_back(shown);
    else
      for (std::size_t k = 0; k < static_cast<std::size_t>(shown.triangles); ++k) sort(shown, k, buffer);
  }
}

/// One of the triangles of a block.
void TileShader::sort(const ShownBlock& shown, std::size_t which, const TileBuffer& buffer) {
  const Seen& seen = seen_[static_cast<std::size_t>(shown.slots[which])];
  Share& share = share_of(seen.group);
  if (!seen.careful) {
    share.add(shown, which);
    return;
  }
  leave_to_care(shown, which, buffer);
  share.pixels -= shown.cells[which];  // the textbook's arithmetic counts its own
}

/// Single precision would not do for a triangle in a block.
void TileShader::leave_to_care(const ShownBlock& shown, std::size_t which, const TileBuffer& buffer) {
  const std::size_t first = static_cast<std::size_t>(shown.block) * full;
  for (std::size_t cell = first; cell < first + full; ++cell)
    if (buffer.ids[cell] == shown.ids[which]) careful_cells_.push_back(cell);
}

/// Counts what lights the pixels of a group. Flat light is counted where it is made.
void TileShader::count_light(const Share& share, const ShadingGroup& group) {
  const std::int64_t pixels = share.pixels;
  count_.places += pixels;
  count_.places_without_texture += group.has_texture() ? 0 : pixels;
  const Shading how = shading_.scene().shading;
  if (how == Shading::flat) return;
  const std::int64_t lit = how == Shading::phong ? pixels : 3 * share.triangles,
                     lamps = std::ssize(group.lamps);
  count_.lamps += lit * lamps;
  count_.lamps_out_of_range += lit * group.lamps_left_out;
  count_.lamps_without_highlight += group.spared ? lit * lamps : 0;
}

ShadingCount TileShader::count() const {
  ShadingCount sum = count_;
  sum.add(surfaces_.count());
  return sum;
}

/// Where the tile's pixels stand in a picture.
TileRows TileShader::rows_of(const Window& pixels, Image& image) const {
  static_assert(sizeof(Rgba8) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<Rgba8>);
  const ivec2 corner = pixels.lower - shading_.plan().window.lower;
  return {reinterpret_cast<std::uint32_t*>(image.row(corner.y).data() + corner.x),
          static_cast<std::size_t>(image.width()), static_cast<int>(pixels.width()),
          static_cast<int>(pixels.height())};
}

void TileShader::write(const Window& pixels, Image& image) const {
  copy_tile(colours_.data(), rows_of(pixels, image));
}

void TileShader::clear(const Window& pixels, Image& image) const {
  fill_tile(background_, rows_of(pixels, image));
}

/// Numbers the triangles that are seen. Returns the pixels that show some.
std::int64_t TileShader::find_seen(const TileBuffer& buffer) {
  in_blocks_count_ = list_shown(buffer, in_blocks_);
  std::int64_t covered = 0;
  std::int32_t last_id = no_triangle, slot = -1;
  for (ShownBlock& shown : std::span(in_blocks_).first(in_blocks_count_)) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(shown.triangles); ++k) {
      if (shown.ids[k] != last_id) slot = slot_of(shown.ids[k]);
      last_id = shown.ids[k];
      shown.slots[k] = slot;
      seen_[static_cast<std::size_t>(slot)].pixels += shown.cells[k];
      covered += shown.cells[k];
    }
    for (auto rest = static_cast<std::size_t>(shown.triangles); rest < 3; ++rest)
      shown.slots[rest] = shown.slots[0];
  }
  return covered;
}

/// For a new tile.
void TileShader::begin() {
  std::ranges::fill(table_, -1);
  seen_.clear();
  for (const std::int32_t number : groups_here_) share_of_group_[static_cast<std::size_t>(number)] = -1;
  groups_here_.clear();
  colours_.fill(background_);
}

/// Colours the pixels that show one triangle alone.
void TileShader::light_whole_pixels(const TileBuffer& buffer, ivec2 origin) {
  careful_cells_.clear();
  const bool sorted = !is_of_one_kind();
  if (sorted) sort(buffer);
  bool some_in_doubt = false;
  for (const std::int32_t number : groups_here_) {
    const ShadingGroup& group = shading_.groups()[static_cast<std::size_t>(number)];
    const Share& share = share_of(number);
    count_light(share, group);
    const LitCells lit{&group, records_.data(), shading_.scene().shading == Shading::phong,
                       shading_.towards()};
    some_in_doubt |= light_blocks(lit, sorted ? share.blocks : in_blocks(), buffer, colours_.data());
  }
  if (some_in_doubt) take_doubtful(buffer);
  colour_carefully(buffer, origin);
}

std::int64_t TileShader::colour(const Window& pixels, const TileBuffer& buffer, Image& image) {
  begin();
  const std::int64_t covered = find_seen(buffer);
  if (covered > 0) {
    describe_all(pixels, false);
    light_whole_pixels(buffer, pixels.lower);
  }
  write(pixels, image);
  return covered;
}

}  // namespace gradus::pipeline::engine
