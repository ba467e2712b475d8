#include "engine/tile_shader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace gradus::pipeline::engine {
namespace {

/// Lists of corners end with some more, to fill registers.
constexpr std::size_t full = block_cells;

/// A number of few binary digits from 0 to 1, at or below the part of x behind the point.
double rounded_part(double x, std::int32_t texels) {
  const double part = x - std::floor(x), digits = 0x1p23 / std::bit_ceil(static_cast<unsigned>(texels));
  return std::floor(part * digits) / digits;
}

}  // namespace

TileShader::TileShader(const FrameShading& shading)
    : shading_(shading),
      surfaces_(shading.scene(), shading.buffers(), shading.plan(), shading.frame()),
      background_(packed(shading.scene().background)),
      table_(256, -1),
      share_of_group_(shading.groups().size(), -1) {}

void TileShader::Share::clear() {
  slots.clear();
  blocks.clear();
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

/// Writes what is linear on the texture. Returns whether single precision will do.
bool TileShader::describe_texture(const TextureLevels& texture, const SeenCorners& corners,
                                  const PlaneMaker& planes, TriangleRecord& record) const {
  const dvec3& q = corners.over_w;
  const ivec2 texels{texture.columns[0], texture.rows[0]};
  double farthest = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const auto& [a, b, c] = corners.texture;
    dvec3 at{a[axis], b[axis], c[axis]};
    const double here = planes.there(q * at) / planes.there(q), base = rounded_part(here, texels[axis]);
    at -= std::floor(here) + base;
    record[static_cast<std::size_t>(record::base + axis)] = static_cast<float>(base);
    planes.put(q * at, &record[static_cast<std::size_t>(record::texture + 3 * axis)]);
    farthest = std::max({farthest, std::abs(at.x) * texels[axis], std::abs(at.y) * texels[axis],
                         std::abs(at.z) * texels[axis]});
  }
  // Where there are levels, texels are as large as pixels, and so there are few of them in a tile
  return texture.levels > 1 || farthest <= 1024;
}

/// Returns whether single precision will do.
bool TileShader::describe(const Seen& seen, ivec2 origin, const Window& square, bool squares,
                          TriangleRecord& record) {
  const auto& grid = shading_.frame().triangle(seen.id).grid;
  SeenCorners& corners = corners_.emplace_back(shading_.corners_of(seen.id));
  corners.over_w /= std::max({corners.over_w.x, corners.over_w.y, corners.over_w.z});
  const dvec3& q = corners.over_w;
  const Window box = squares ? squares_of(grid, square) : triangle_coverage::centres(grid, square);
  const PlaneMaker& planes = makers_.emplace_back(grid, box, q);
  record[record::column] = static_cast<float>(planes.pixel().x - origin.x);
  record[record::row] = static_cast<float>(planes.pixel().y - origin.y);
  planes.put(q, &record[record::over_w]);
  const auto& [a, b, c] = corners.places;
  if (shading_.scene().shading == Shading::phong) {
    const auto& [n, m, o] = corners.normals;
    for (int axis = 0; axis < 3; ++axis) {
      float* const into = &record[static_cast<std::size_t>(record::values + 3 * axis)];
      planes.put(q * dvec3{a[axis], b[axis], c[axis]}, into);
      planes.put(q * dvec3{n[axis], m[axis], o[axis]}, into + 9);
    }
  }
  const TextureLevels& texture = shading_.groups()[static_cast<std::size_t>(seen.group)].texture;
  const bool texture_will_do = texture.levels == 0 || describe_texture(texture, corners, planes, record);
  return texture_will_do && !planes.is_thin();
}

/// Records of all triangles that are seen. squares: they were asked for by the squares of pixels.
void TileShader::describe_all(const Window& pixels, bool squares) {
  records_.resize(seen_.size());
  corners_.clear();
  makers_.clear();
  // A part of a picture has the bits of the whole
  const Window square = intersection(square_with(pixels.lower), picture_window(shading_.plan().size));
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    Seen& seen = seen_[i];
    seen.group = shading_.group_of(seen.id);
    seen.careful = !describe(seen, pixels.lower, square, squares, records_[i]);
    std::int32_t& share = share_of_group_[static_cast<std::size_t>(seen.group)];
    if (share < 0) {
      share = static_cast<std::int32_t>(groups_here_.size());
      groups_here_.push_back(seen.group);
      if (shares_.size() < groups_here_.size()) shares_.emplace_back();
      shares_[static_cast<std::size_t>(share)].clear();
    }
    shares_[static_cast<std::size_t>(share)].slots.push_back(static_cast<std::int32_t>(i));
    shares_[static_cast<std::size_t>(share)].pixels += seen.pixels;
  }
  const Shading how = shading_.scene().shading;
  if (how == Shading::flat) put_light_of_faces();
  if (how == Shading::gouraud) light_all_corners();
}

/// Gouraud: light at the corners of the triangles of a group.
void TileShader::light_corners_of(Share& share, const ShadingGroup& group) {
  const std::size_t corners = 3 * share.slots.size(), count = (corners + full - 1) / full * full;
  places_.assign(3 * count, 1);
  normals_.assign(3 * count, 0);
  light_.resize(7 * count);
  for (std::size_t i = 0; i < corners; ++i) {
    const SeenCorners& of = corners_[static_cast<std::size_t>(share.slots[i / 3])];
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t at = static_cast<std::size_t>(axis) * count + i;
      places_[at] = static_cast<float>(of.places[i % 3][axis]);
      normals_[at] = static_cast<float>(of.normals[i % 3][axis]);
    }
  }
  light_corners(group, shading_.towards(), {places_, normals_, light_});
  for (std::size_t i = 0; i < share.slots.size(); ++i) {
    const auto slot = static_cast<std::size_t>(share.slots[i]);
    const float* const doubts = &light_[6 * count + 3 * i];
    seen_[slot].careful |= doubts[0] + doubts[1] + doubts[2] > 0;
    std::array<dvec3, 6> parts;
    for (std::size_t value = 0; value < 6; ++value) {
      const auto at = [&](std::size_t corner) { return double{light_[value * count + 3 * i + corner]}; };
      parts[value] = {at(0), at(1), at(2)};
    }
    put_light(slot, group, parts);
  }
}

/// Writes planes of light. parts: three colours of scattered light, then of highlights, at the corners.
void TileShader::put_light(std::size_t slot, const ShadingGroup& group, const std::array<dvec3, 6>& parts) {
  const dvec3& q = corners_[slot].over_w;
  const auto put = [&](std::size_t value, const dvec3& light) {
    makers_[slot].put(q * light, &records_[slot][record::values + 3 * value]);
  };
  for (std::size_t colour = 0; colour < 3; ++colour) {
    if (!group.has_texture()) {
      put(colour, parts[colour] + parts[colour + 3]);
      continue;
    }
    put(colour, parts[colour]);
    put(colour + 3, parts[colour + 3]);
  }
}

/// Flat: light of whole faces.
void TileShader::put_light_of_faces() {
  for (std::size_t slot = 0; slot < seen_.size(); ++slot) {
    const Parts light = surfaces_.of_face(seen_[slot].id);
    const dvec3 scattered = light.ambient + light.diffuse;
    std::array<dvec3, 6> parts;
    for (int axis = 0; axis < 3; ++axis) {
      parts[static_cast<std::size_t>(axis)] = dvec3(scattered[axis]);
      parts[static_cast<std::size_t>(axis + 3)] = dvec3(double{light.specular[axis]});
    }
    put_light(slot, shading_.groups()[static_cast<std::size_t>(seen_[slot].group)], parts);
  }
}

void TileShader::light_all_corners() {
  for (const std::int32_t number : groups_here_)
    light_corners_of(share_of(number), shading_.groups()[static_cast<std::size_t>(number)]);
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
  const std::int64_t lit = how == Shading::phong ? pixels : 3 * std::ssize(share.slots),
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

/// Copies the pixels of the tile from their cells.
void TileShader::write(const Window& pixels, Image& image) const {
  const ivec2 corner = pixels.lower - shading_.plan().window.lower;
  const auto width = static_cast<std::size_t>(pixels.width());
  constexpr std::size_t side = block_side;
  for (int y = 0; y < pixels.height(); ++y) {
    Rgba8* const row = image.row(corner.y + y).data() + corner.x;
    const std::uint32_t* from = &colours_[TileBuffer::cell({0, y})];
    std::size_t x = 0;
    for (; x + side <= width; x += side, from += full)
      std::memcpy(static_cast<void*>(row + x), from, side * sizeof(Rgba8));
    std::memcpy(static_cast<void*>(row + x), from, (width - x) * sizeof(Rgba8));
  }
}

void TileShader::clear(const Window& pixels, Image& image) const {
  const ivec2 corner = pixels.lower - shading_.plan().window.lower;
  for (int y = 0; y < pixels.height(); ++y)
    std::fill_n(image.row(corner.y + y).data() + corner.x, pixels.width(), std::bit_cast<Rgba8>(background_));
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
