#include "engine/shading_batch.hpp"

#include <array>
#include <bit>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/shading_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "core/colour.hpp"
#include "engine/mask_bits-inl.hpp"
#include "engine/phong_lanes-inl.hpp"
#include "engine/shading_lanes-inl.hpp"
#include "engine/visibility_batch.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Squares of the length of a mean of normals from here on down
constexpr float unsure_normal = 0x1p-8f;

// --- Pixels --------------------------------------------------------------------------------------

// The records of some pixels: of each its own, or one of all. Numbers of a record stand block_cells apart
struct OwnRecords {
  const float* all;
  I begins;
  HWY_INLINE F operator()(int place) const { return hn::GatherIndex(D(), all + place * block_cells, begins); }
};
struct OneRecord {
  const float* one;
  HWY_INLINE F operator()(int place) const { return set(one[place * block_cells]); }
};

// Those of up to three triangles, of each pixel one
struct BlendedRecords {
  OneRecord first, second, third;
  M of_second, of_third;
  HWY_INLINE F operator()(int place) const {
    return hn::IfThenElse(of_third, third(place), hn::IfThenElse(of_second, second(place), first(place)));
  }
};

// What is linear on the surfaces that some pixels show
template <class Records>
struct Planes {
  const Records& records;
  F x, y;  // from the pixel that planes count from

  HWY_INLINE F operator()(int place) const {
    return hn::Add(hn::Add(records(place), hn::Mul(records(place + 1), x)), hn::Mul(records(place + 2), y));
  }
  HWY_INLINE Vec3 three(int place) const {
    return {operator()(place), operator()(place + 3), operator()(place + 6)};
  }
  // Light by its planes; grey light by its first
  HWY_INLINE Vec3 light(int place, bool grey, F w) const {
    if (!grey) return scaled(three(place), w);
    const F one = hn::Mul(operator()(place), w);
    return {one, one, one};
  }
};

// By Phong's model in each pixel
template <class Records>
HWY_INLINE Light3 lit_there(const LitCells& lit_cells, const Planes<Records>& plane, F w) {
  const Vec3 place = scaled(plane.three(record::values), w), normal = plane.three(record::values + 9);
  const bool parallel = lit_cells.towards != glm::vec3(0);
  const Vec3 viewer = parallel ? set(lit_cells.towards) : unit(minus(set(glm::vec3(0)), place));
  const F square = dot(normal, normal);
  Light3 light = lit(*lit_cells.group, place, scaled(normal, over_length(square)), viewer);
  // Normals that nearly cancel out lose digits
  const M short_normal = hn::Lt(hn::Mul(hn::Mul(w, w), square), set(unsure_normal));
  light.doubtful = hn::Or(light.doubtful, short_normal);
  return light;
}

template <class Records>
HWY_INLINE Vec3 texel_of(const TextureLevels& texture, const Planes<Records>& plane, F w) {
  const Records& records = plane.records;
  const Uv at{hn::Mul(plane(record::texture), w), hn::Mul(plane(record::texture + 3), w),
              records(record::base), records(record::base + 1)};
  if (texture.levels == 1) return bilinear(texture, at);
  // How far (u, v) goes from a pixel to the next, in texels
  const auto square = [&](int step) {
    const F growth = records(record::over_w + step);
    const auto along = [&](int place, F coordinate, std::int32_t count) {
      const F way = hn::Mul(hn::Sub(records(place + step), hn::Mul(growth, coordinate)), w);
      return hn::Mul(way, set(static_cast<float>(count)));
    };
    const F u = along(record::texture, at.u, texture.columns[0]),
            v = along(record::texture + 3, at.v, texture.rows[0]);
    return hn::Add(hn::Mul(u, u), hn::Mul(v, v));
  };
  return mip_mapped(texture, hn::Max(square(1), square(2)), at);
}

template <class Records>
HWY_INLINE Vec3 light_of(const LitCells& lit_cells, const Records& records, F column, F row, M& doubtful) {
  const Planes<Records> plane{records, hn::Sub(column, records(record::column)),
                              hn::Sub(row, records(record::row))};
  const ShadingGroup& group = *lit_cells.group;
  // Where rays are parallel it is 1 everywhere
  const bool parallel = lit_cells.towards != glm::vec3(0);
  const F w = parallel ? set(1) : hn::Div(set(1), plane(record::over_w));
  doubtful = never();
  Vec3 scattered, highlight;
  if (lit_cells.per_pixel) {
    const Light3 light = lit_there(lit_cells, plane, w);
    scattered = light.scattered;
    highlight = light.highlight;
    doubtful = light.doubtful;
  } else {
    scattered = plane.light(record::values, group.grey, w);
    // Without a texture both are one
    if (!group.has_texture()) return scattered;
    highlight = plane.light(record::values + 9, group.grey, w);
  }
  if (group.has_texture()) scattered = product(scattered, texel_of(group.texture, plane, w));
  return {hn::Add(scattered.x, highlight.x), hn::Add(scattered.y, highlight.y),
          hn::Add(scattered.z, highlight.z)};
}

// Light that waits for its bytes. Processors look a few hundred instructions ahead: what many registers wait
// for one after the other, light and then bytes, goes faster as all light first
class Waiting {
 public:
  explicit Waiting(bool grey) : grey_(grey) {}

  bool is_full() const { return count_ == most; }
  HWY_INLINE void put(const Vec3& light, std::uint32_t* to) {
    const D d;
    auto& [red, green, blue] = light_[count_];
    hn::Store(light.x, d, red.data());
    if (!grey_) {
      hn::Store(light.y, d, green.data());
      hn::Store(light.z, d, blue.data());
    }
    to_[count_++] = to;
  }
  // own: lanes that get a colour. doubtful: those that get 0
  HWY_INLINE void put(const Vec3& light, MI own, MI doubtful, std::uint32_t* to) {
    const DI di;
    hn::Store(hn::VecFromMask(di, own), di, own_[count_].data());
    hn::Store(hn::VecFromMask(di, hn::Not(doubtful)), di, sure_[count_].data());
    put(light, to);
  }

  // whole: own and sure are all lanes
  template <bool whole>
  HWY_INLINE void colour() {
    if (grey_)
      colour_by<whole>([](const Light& light) { return grey_of(hn::Load(D(), light[0].data())); });
    else
      colour_by<whole>([](const Light& light) {
        const D d;
        return packed_of(
            {hn::Load(d, light[0].data()), hn::Load(d, light[1].data()), hn::Load(d, light[2].data())});
      });
    count_ = 0;
  }

 private:
  static constexpr std::size_t most = 32;
  template <class T>
  using Lanes = std::array<T, hn::MaxLanes(D())>;
  using Light = std::array<Lanes<float>, 3>;

  template <bool whole, class Colour>
  HWY_INLINE void colour_by(const Colour& colour) {
    const DI di;
    const hn::RebindToUnsigned<DI> du;
    for (std::size_t i = 0; i < count_; ++i) {
      const I packed = colour(light_[i]);
      if constexpr (whole) {
        hn::Store(hn::BitCast(du, packed), du, to_[i]);
      } else {
        const I sure = hn::And(packed, hn::Load(di, sure_[i].data()));
        const MI own = hn::MaskFromVec(hn::Load(di, own_[i].data()));
        store_own(hn::BitCast(du, sure), hn::RebindMask(du, own), du, to_[i]);
      }
    }
  }

  alignas(64) std::array<Light, most> light_;
  alignas(64) std::array<Lanes<std::int32_t>, most> own_, sure_;
  std::array<std::uint32_t*, most> to_;
  std::size_t count_ = 0;
  bool grey_;
};

alignas(64) constexpr float cell_columns[block_cells] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr float cell_rows[block_cells] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// Lights the cells of a block that are `own` of those from k on
template <class Records>
HWY_INLINE void light_block(const LitCells& lit_cells, const Records& records, std::int32_t block,
                            std::size_t k, MI own, std::uint32_t* colours, Waiting& waiting, MI& doubtful) {
  const D d;
  const auto column = static_cast<float>(block % blocks_across * block_side),
             row = static_cast<float>(block / blocks_across * block_side);
  const F x = hn::Add(set(column), hn::Load(d, cell_columns + k)),
          y = hn::Add(set(row), hn::Load(d, cell_rows + k));
  M unsure;
  const Vec3 light = light_of(lit_cells, records, x, y, unsure);
  const MI in_doubt = hn::RebindMask(DI(), unsure);
  waiting.put(light, own, in_doubt, colours + static_cast<std::size_t>(block * block_cells) + k);
  if (waiting.is_full()) waiting.colour<false>();
  doubtful = hn::Or(doubtful, hn::And(own, in_doubt));
}

// Registers hold whole rows of a block: what is computed of columns is the same in each
constexpr bool holds_rows = hn::MaxLanes(D()) % block_side == 0;

// As light_block, all cells of a block that shows one triangle, whose light without a texture is known by its
// planes
template <bool grey>
HWY_INLINE void light_whole_block(const LitCells& lit_cells, OneRecord record, std::int32_t block,
                                  std::uint32_t* colours, Waiting& waiting) {
  const D d;
  constexpr std::size_t values = grey ? 1 : 3;
  const bool parallel = lit_cells.towards != glm::vec3(0);
  const F column = set(static_cast<float>(block % blocks_across * block_side)),
          row = set(static_cast<float>(block / blocks_across * block_side)),
          x = hn::Sub(hn::Add(column, hn::Load(d, cell_columns)), record(record::column));
  const auto begun = [&](int place) { return hn::Add(record(place), hn::Mul(record(place + 1), x)); };
  const F over_w = begun(record::over_w);
  const auto place_of = [](std::size_t value) { return record::values + 3 * static_cast<int>(value); };
  F light[values];
  for (std::size_t i = 0; i < values; ++i) light[i] = begun(place_of(i));
  for (std::size_t k = 0; k < block_cells; k += hn::Lanes(d)) {
    const F y = hn::Sub(hn::Add(row, hn::Load(d, cell_rows + k)), record(record::row));
    const auto there = [&](F begin, int place) { return hn::Add(begin, hn::Mul(record(place + 2), y)); };
    const F w = parallel ? set(1) : hn::Div(set(1), there(over_w, record::over_w));
    const auto value = [&](std::size_t i) { return hn::Mul(there(light[i], place_of(i)), w); };
    const F red = value(0);
    std::uint32_t* const to = colours + static_cast<std::size_t>(block * block_cells) + k;
    if constexpr (grey)
      waiting.put({red, red, red}, to);
    else
      waiting.put({red, value(1), value(2)}, to);
  }
  if (waiting.is_full()) waiting.colour<true>();
}

bool light_some_blocks(const LitCells& lit_cells, const ShownBlock* blocks, std::size_t count,
                       const std::int32_t* ids_of_cells, std::uint32_t* colours) {
  const DI di;
  MI doubtful = hn::FirstN(di, 0);
  const ShadingGroup& group = *lit_cells.group;
  const bool grey = group.grey && !group.has_texture();
  Waiting of_whole(grey), of_parts(grey);
  const bool planes_alone = holds_rows && !lit_cells.per_pixel && !group.has_texture();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [block, triangles, ids, cells, slots] = blocks[i];
    const auto record = [&](std::size_t which) {
      const auto slot = static_cast<std::size_t>(slots[which]);
      return OneRecord{lit_cells.records[slot / block_cells].of(slot % block_cells)};
    };
    if (planes_alone && cells[0] == block_cells) {
      if (group.grey)
        light_whole_block<true>(lit_cells, record(0), block, colours, of_whole);
      else
        light_whole_block<false>(lit_cells, record(0), block, colours, of_whole);
      continue;
    }
    for (std::size_t k = 0; k < block_cells; k += hn::Lanes(di)) {
      const I cell_ids = hn::Load(di, ids_of_cells + static_cast<std::size_t>(block * block_cells) + k);
      const auto of = [&](std::size_t which) { return hn::Eq(cell_ids, whole(ids[which])); };
      const MI first = of(0);
      if (triangles == 1) {
        if (hn::AllFalse(di, first)) continue;
        light_block(lit_cells, record(0), block, k, first, colours, of_parts, doubtful);
        continue;
      }
      const MI second = of(1), third = of(2), own = hn::Or(first, hn::Or(second, third));
      if (hn::AllFalse(di, own)) continue;
      const D d;
      const BlendedRecords records{record(0), record(1), record(2), hn::RebindMask(d, second),
                                   hn::RebindMask(d, third)};
      light_block(lit_cells, records, block, k, own, colours, of_parts, doubtful);
    }
  }
  of_whole.colour<true>();
  of_parts.colour<false>();
  return !hn::AllFalse(di, doubtful);
}

// The cells of a block that show a triangle, a bit each
HWY_INLINE std::uint32_t cells_with(const std::int32_t* ids, std::int32_t id) {
  const DI di;
  std::uint32_t cells = 0;
  for (std::size_t k = 0; k < block_cells; k += hn::Lanes(di))
    cells |= bits_of(di, hn::Eq(hn::Load(di, ids + k), whole(id))) << k;
  return cells;
}

// Whether all cells of a block show the same
HWY_INLINE bool is_uniform(const std::int32_t* ids) {
  const DI di;
  const I first = whole(ids[0]);
  MI same = hn::Eq(hn::Load(di, ids), first);
  for (std::size_t k = hn::Lanes(di); k < block_cells; k += hn::Lanes(di))
    same = hn::And(same, hn::Eq(hn::Load(di, ids + k), first));
  return hn::AllTrue(di, same);
}

std::size_t list_some_shown(const std::int32_t* ids, ShownBlock* shown) {
  std::size_t count = 0;
  for (std::int32_t block = 0; block < blocks_across * blocks_across; ++block, ids += block_cells) {
    const std::int32_t alone = ids[0];
    if (is_uniform(ids)) {
      if (alone != no_triangle) shown[count++] = {block, 1, {alone, alone, alone}, {block_cells, 0, 0}};
      continue;
    }
    std::uint32_t left = 0xffff ^ cells_with(ids, no_triangle);
    while (left != 0) {
      ShownBlock& some = shown[count++];
      some = {block, 0, {}, {}};
      while (left != 0 && some.triangles < 3) {
        const std::int32_t id = ids[std::countr_zero(left)];
        const std::uint32_t cells = cells_with(ids, id);
        const auto next = static_cast<std::size_t>(some.triangles++);
        some.ids[next] = id;
        some.cells[next] = std::popcount(cells);
        left ^= cells;
      }
      for (auto rest = static_cast<std::size_t>(some.triangles); rest < 3; ++rest)
        some.ids[rest] = some.ids[0];
    }
  }
  return count;
}

// --- Pictures ------------------------------------------------------------------------------------

using DU = hn::RebindToUnsigned<DI>;
using U = hn::Vec<DU>;

// Pixels of a row of a tile, from so many blocks beside one another as registers hold. Stores of whole
// registers: the fewer of them wait for memory, the more do so at once
template <std::size_t lanes>
HWY_INLINE auto row_of_blocks(const std::uint32_t* first) {
  const hn::CappedTag<std::uint32_t, lanes> d;
  if constexpr (lanes <= block_side)
    return hn::Load(d, first);
  else
    // Found by its arguments: targets of one lane do without
    return Combine(d, row_of_blocks<lanes / 2>(first + lanes / 2 / block_side * block_cells),
                   row_of_blocks<lanes / 2>(first));
}

void copy_some(const std::uint32_t* colours, const TileRows& rows) {
  constexpr std::size_t lanes = hn::MaxLanes(DU());
  const auto width = static_cast<std::size_t>(rows.width);
  for (int y = 0; y < rows.height; ++y) {
    std::uint32_t* const to = rows.first + static_cast<std::size_t>(y) * rows.stride;
    const auto from = [&](std::size_t x) { return colours + TileBuffer::cell({static_cast<int>(x), y}); };
    std::size_t x = 0;
    for (; x + lanes <= width; x += lanes) hn::StoreU(row_of_blocks<lanes>(from(x)), DU(), to + x);
    for (; x < width; ++x) to[x] = *from(x);
  }
}

void fill_some(std::uint32_t colour, const TileRows& rows) {
  const auto width = static_cast<std::size_t>(rows.width);
  for (int y = 0; y < rows.height; ++y) {
    std::uint32_t* const to = rows.first + static_cast<std::size_t>(y) * rows.stride;
    std::size_t x = 0;
    for (; x + hn::Lanes(DU()) <= width; x += hn::Lanes(DU()))
      hn::StoreU(hn::Set(DU(), colour), DU(), to + x);
    for (; x < width; ++x) to[x] = colour;
  }
}

// --- Places --------------------------------------------------------------------------------------

void light_some_places(const LitCells& lit_cells, const LitPlaces& places) {
  const D d;
  const DI di;
  const std::size_t count = places.slots.size();
  const float* const all = lit_cells.records->of(0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const I slots = hn::LoadU(di, places.slots.data() + i), last = whole(block_cells - 1);
    const OwnRecords records{
        all, hn::Add(hn::Mul(hn::AndNot(last, slots), whole(record::size)), hn::And(slots, last))};
    M doubtful;
    const F column = hn::LoadU(d, places.columns.data() + i), row = hn::LoadU(d, places.rows.data() + i);
    const Vec3 light = light_of(lit_cells, records, column, row, doubtful);
    hn::StoreU(hn::IfThenElse(doubtful, set(-1), light.x), d, places.light.data() + i);
    hn::StoreU(light.y, d, places.light.data() + count + i);
    hn::StoreU(light.z, d, places.light.data() + 2 * count + i);
  }
}

void pack_some(const float* light, std::size_t count, std::uint32_t* colours) {
  const D d;
  const hn::RebindToUnsigned<DI> du;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto load = [&](std::size_t k) { return hn::LoadU(d, light + k * count + i); };
    hn::StoreU(hn::BitCast(du, packed_of({load(0), load(1), load(2)})), du, colours + i);
  }
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(list_some_shown);
HWY_EXPORT(light_some_blocks);
HWY_EXPORT(light_some_places);
HWY_EXPORT(pack_some);
HWY_EXPORT(copy_some);
HWY_EXPORT(fill_some);

std::size_t list_shown(const TileBuffer& buffer, std::span<ShownBlock, most_shown_blocks> shown) {
  return HWY_DYNAMIC_DISPATCH(list_some_shown)(buffer.ids.data(), shown.data());
}

bool light_blocks(const LitCells& lit, std::span<const ShownBlock> blocks, const TileBuffer& buffer,
                  std::uint32_t* colours) {
  return HWY_DYNAMIC_DISPATCH(light_some_blocks)(lit, blocks.data(), blocks.size(), buffer.ids.data(),
                                                 colours);
}

void light_places(const LitCells& lit, const LitPlaces& places) {
  HWY_DYNAMIC_DISPATCH(light_some_places)(lit, places);
}

void pack(std::span<const float> light, std::span<std::uint32_t> colours) {
  HWY_DYNAMIC_DISPATCH(pack_some)(light.data(), colours.size(), colours.data());
}

void copy_tile(const std::uint32_t* colours, const TileRows& rows) {
  HWY_DYNAMIC_DISPATCH(copy_some)(colours, rows);
}

void fill_tile(std::uint32_t colour, const TileRows& rows) { HWY_DYNAMIC_DISPATCH(fill_some)(colour, rows); }

std::uint32_t packed(const LinearRgb& colour) {
  return std::bit_cast<std::uint32_t>(srgb8_from_linear(colour));
}

}  // namespace gradus::pipeline::engine
#endif
