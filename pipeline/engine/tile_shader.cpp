#include "engine/tile_shader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace gradus::pipeline::engine {
namespace {

/// Lists of pixels end with some of their last one, to fill registers.
constexpr std::size_t full = block_cells;

template <class T>
void fill_up(std::vector<T>& list) {
  while (list.size() % full != 0) list.push_back(list.back());
}

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
      table_(2 * TileBuffer::cells, -1),
      share_of_group_(shading.groups().size(), -1) {}

void TileShader::Share::clear() {
  for (auto* list : {&cells, &cell_slots, &slots}) list->clear();
  blocks.clear();
  pixels = 0;
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
    for (std::size_t value = 0; value < 6; ++value) {
      const float* const at = &light_[value * count + 3 * i];
      makers_[slot].put(corners_[slot].over_w * dvec3{at[0], at[1], at[2]},
                        &records_[slot][record::values + 3 * value]);
    }
  }
}

/// Flat: light of whole faces.
void TileShader::put_light_of_faces() {
  for (std::size_t slot = 0; slot < seen_.size(); ++slot) {
    const Parts parts = surfaces_.of_face(seen_[slot].id);
    const dvec3 scattered = parts.ambient + parts.diffuse;
    for (int axis = 0; axis < 3; ++axis) {
      float* const into = &records_[slot][static_cast<std::size_t>(record::values + 3 * axis)];
      makers_[slot].put(corners_[slot].over_w * scattered[axis], into);
      makers_[slot].put(corners_[slot].over_w * parts.specular[axis], into + 9);
    }
  }
}

void TileShader::light_all_corners() {
  for (const std::int32_t number : groups_here_)
    light_corners_of(share_of(number), shading_.groups()[static_cast<std::size_t>(number)]);
}

/// Adds to the pixels that are done with care those that batches left in doubt.
void TileShader::take_doubtful() {
  for (std::size_t cell = 0; cell < TileBuffer::cells; ++cell) {
    if (slots_[cell] < 0 || colours_[cell] != 0) continue;
    careful_cells_.push_back(static_cast<std::int32_t>(cell));
    careful_slots_.push_back(slots_[cell]);
  }
}

/// By the textbook's arithmetic.
void TileShader::colour_carefully(ivec2 origin) {
  for (std::size_t i = 0; i < careful_cells_.size(); ++i) {
    const std::int32_t cell = careful_cells_[i], block = cell / block_cells, in_block = cell % block_cells;
    const ivec2 at{block % blocks_across * block_side + in_block % block_side,
                   block / blocks_across * block_side + in_block / block_side};
    const std::int32_t id = seen_[static_cast<std::size_t>(careful_slots_[i])].id;
    colours_[static_cast<std::size_t>(cell)] = packed(surfaces_.colour(id, origin + at));
  }
}

/// The different slots of a block, and how many they are, if at most so many; else 0.
template <std::size_t most>
std::size_t different(std::span<const std::int32_t> slots, std::array<std::int32_t, most>& found) {
  std::size_t count = 0;
  for (const std::int32_t slot : slots) {
    if (slot < 0 || std::ranges::find(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                                      slot) != found.begin() + static_cast<std::ptrdiff_t>(count))
      continue;
    if (count == most) return 0;
    found[count++] = slot;
  }
  return count;
}

/// Sorts pixels by their groups; blocks that show few triangles apart.
void TileShader::sort() {
  careful_cells_.clear();
  careful_slots_.clear();
  for (const auto& [block, slot] : blocks_of_one_) add_block(block, slot);
  for (const std::int32_t block : mixed_blocks_) {
    const auto own = std::span(slots_).subspan(static_cast<std::size_t>(block) * full, full);
    std::array<std::int32_t, 3> slots;
    if (const std::size_t few = different(own, slots); few > 0) {
      add_mixed_block(block, std::span(slots).first(few));
      continue;
    }
    for (std::size_t i = 0; i < full; ++i)
      if (own[i] >= 0) add_cell(block * block_cells + static_cast<std::int32_t>(i), own[i]);
  }
}

/// A block that shows up to three triangles.
void TileShader::add_mixed_block(std::int32_t block, std::span<const std::int32_t> slots) {
  const auto seen = [&](std::int32_t slot) -> const Seen& { return seen_[static_cast<std::size_t>(slot)]; };
  const bool alike = std::ranges::all_of(slots, [&](std::int32_t slot) {
    return !seen(slot).careful && seen(slot).group == seen(slots.front()).group;
  });
  if (alike)
    share_of(seen(slots.front()).group)
        .blocks.push_back({block, {slots.front(), slots[slots.size() > 1 ? 1 : 0], slots.back()}});
  else
    for (const std::int32_t slot : slots) add_block(block, slot);
}

void TileShader::add_cell(std::int32_t cell, std::int32_t slot) {
  const Seen& seen = seen_[static_cast<std::size_t>(slot)];
  Share& share = share_of(seen.group);
  share.pixels -= seen.careful;  // the textbook's arithmetic counts its own
  (seen.careful ? careful_cells_ : share.cells).push_back(cell);
  (seen.careful ? careful_slots_ : share.cell_slots).push_back(slot);
}

void TileShader::add_block(std::int32_t block, std::int32_t slot) {
  const Seen& seen = seen_[static_cast<std::size_t>(slot)];
  if (!seen.careful) {
    share_of(seen.group).blocks.push_back({block, {slot, slot, slot}});
    return;
  }
  const std::int32_t first = block * block_cells;
  for (std::int32_t cell = first; cell < first + block_cells; ++cell)
    if (slots_[static_cast<std::size_t>(cell)] == slot) add_cell(cell, slot);
}

/// Counts what lights the pixels of a group. Flat light is counted where it is made.
void TileShader::count_light(const Share& share, const ShadingGroup& group) {
  const std::int64_t pixels = share.pixels;
  count_.places += pixels;
  count_.places_without_texture += group.texture.levels == 0 ? pixels : 0;
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
  const auto width = static_cast<int>(pixels.width()), whole = width / block_side * block_side;
  for (int y = 0; y < pixels.height(); ++y) {
    Rgba8* const row = image.row(corner.y + y).data() + corner.x;
    for (int x = 0; x < whole; x += block_side)
      std::memcpy(static_cast<void*>(row + x), &colours_[TileBuffer::cell({x, y})],
                  block_side * sizeof(Rgba8));
    for (int x = whole; x < width; ++x) row[x] = std::bit_cast<Rgba8>(colours_[TileBuffer::cell({x, y})]);
  }
}

void TileShader::clear(const Window& pixels, Image& image) const {
  const ivec2 corner = pixels.lower - shading_.plan().window.lower;
  for (int y = 0; y < pixels.height(); ++y)
    std::fill_n(image.row(corner.y + y).data() + corner.x, pixels.width(), std::bit_cast<Rgba8>(background_));
}

/// Numbers the triangles that are seen, and tells which blocks show one alone. Returns the pixels that show
/// some.
std::int64_t TileShader::find_seen(const TileBuffer& buffer) {
  blocks_of_one_.clear();
  mixed_blocks_.clear();
  std::int64_t covered = 0;
  std::int32_t last_id = no_triangle, last_slot = -1;
  const auto see = [&](std::int32_t id, std::int64_t pixels) {
    if (id != last_id) last_id = id, last_slot = id == no_triangle ? -1 : slot_of(id);
    if (last_slot < 0) return;
    covered += pixels;
    seen_[static_cast<std::size_t>(last_slot)].pixels += static_cast<std::int32_t>(pixels);
  };
  constexpr auto blocks = static_cast<std::int32_t>(TileBuffer::cells / full);
  for (std::int32_t block = 0; block < blocks; ++block) {
    const auto first = static_cast<std::size_t>(block) * full;
    const std::int32_t* const ids = &buffer.ids[first];
    std::int32_t differ = 0;
    for (std::size_t i = 1; i < full; ++i) differ |= ids[i] ^ ids[0];
    if (differ == 0) {
      see(ids[0], full);
      std::fill_n(&slots_[first], full, last_slot);
      if (last_slot >= 0) blocks_of_one_.emplace_back(block, last_slot);
      continue;
    }
    mixed_blocks_.push_back(block);
    for (std::size_t i = 0; i < full; ++i) {
      see(ids[i], 1);
      slots_[first + i] = last_slot;
    }
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
void TileShader::light_whole_pixels(ivec2 origin) {
  sort();
  bool some_in_doubt = false;
  for (const std::int32_t number : groups_here_) {
    const ShadingGroup& group = shading_.groups()[static_cast<std::size_t>(number)];
    Share& share = share_of(number);
    count_light(share, group);
    const LitCells lit{&group, records_.data(), shading_.scene().shading == Shading::phong,
                       shading_.towards()};
    some_in_doubt |= light_blocks(lit, share.blocks, slots_.data(), colours_.data());
    fill_up(share.cells);
    fill_up(share.cell_slots);
    some_in_doubt |= light_cells(lit, share.cells, share.cell_slots, colours_.data());
  }
  if (some_in_doubt) take_doubtful();
  colour_carefully(origin);
}

std::int64_t TileShader::colour(const Window& pixels, const TileBuffer& buffer, Image& image) {
  begin();
  const std::int64_t covered = find_seen(buffer);
  if (covered > 0) {
    describe_all(pixels, false);
    light_whole_pixels(pixels.lower);
  }
  write(pixels, image);
  return covered;
}

}  // namespace gradus::pipeline::engine
