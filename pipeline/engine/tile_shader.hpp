#pragma once
// The colours of a tile: its pixels sorted by what lights them alike, and lit sixteen at once.

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/image.hpp"
#include "engine/describe_batch.hpp"
#include "engine/samples_batch.hpp"
#include "engine/shading_batch.hpp"
#include "engine/shown_batch.hpp"
#include "engine/surfaces.hpp"
#include "engine/visibility_batch.hpp"

namespace gradus::pipeline::engine {

/// Colours one tile after the other. One per thread: it keeps its memory.
class TileShader {
 public:
  explicit TileShader(const FrameShading& shading);

  /// Writes the pixels of a tile. buffer: from find_nearest. image: that of the plan's window.
  /// Returns how many show a triangle.
  /// Accuracy: as light_blocks. Cost: describe for what is seen in the tile, and light_blocks; a triangle
  /// whose texture repeats very often has the textbook's arithmetic.
  std::int64_t colour(const Window& pixels, const TileBuffer& buffer, Image& image);
  /// The same of what the samples of each pixel show. buffer: from find_samples, with these places,
  /// of which the first is nearest to the centre. Each
  /// triangle has one colour in a pixel, where the textbook's `adaptive` asks for it, and counts for as many
  /// samples as show it.
  std::int64_t mix(const Window& pixels, const SampleBuffer& buffer, std::span<const ivec2> places,
                   Image& image);
  /// Writes the background to tiles that have no triangle.
  void clear(const Window& pixels, Image& image) const;
  /// What it has done so far.
  ShadingCount count() const;

 private:
  /// A triangle that is seen in the tile.
  struct Seen {
    std::int32_t id, group;
    std::int32_t pixels;  ///< that show it
    bool careful;         ///< single precision would not do
  };
  /// What is seen of a group, as light_blocks takes it.
  struct Share {
    std::int64_t triangles = 0;
    std::vector<ShownBlock> blocks;  ///< where the tile shows several groups
    std::int64_t pixels = 0;

    void clear();
    void add(const ShownBlock& shown, std::size_t which);
  };

  /// A triangle in a pixel that shows several, or not one alone.
  struct Fragment {
    std::int32_t slot, samples;
    std::size_t cell;
    ivec2 place;        ///< in the pixel, in 1/256
    float column, row;  ///< the place in the tile
  };

  std::int64_t find_fragments(const Window& pixels, const SampleBuffer& buffer,
                              std::span<const ivec2> places);
  void light_fragments(ivec2 origin);
  void list_fragments();
  void light_group(std::int32_t number, bool alone, ivec2 origin);
  void mix_fragments(std::size_t samples);
  void begin();
  void describe_all(const Window& box, bool squares);
  void light_whole_pixels(const TileBuffer& buffer, ivec2 origin);
  void grow_table();
  std::int32_t slot_of(std::int32_t id);
  std::int64_t find_seen(const TileBuffer& buffer);
  Share& share_of(std::int32_t group) {
    return shares_[static_cast<std::size_t>(share_of_group_[static_cast<std::size_t>(group)])];
  }
  void fetch_ahead(std::size_t slot) const;
  void describe(const AskedPixels& asked, std::size_t slot, RecordBlock& records);
  void add_to_share(const Seen& seen);
  void put_light_of_faces(std::span<const Seen> some);
  bool is_of_one_kind() const;
  std::int32_t group_of(const ShownBlock& shown) const;
  void sort(const TileBuffer& buffer);
  void sort(const ShownBlock& shown, std::size_t which, const TileBuffer& buffer);
  void leave_to_care(const ShownBlock& shown, std::size_t which, const TileBuffer& buffer);
  std::span<const ShownBlock> in_blocks() const { return std::span(in_blocks_).first(in_blocks_count_); }
  void take_doubtful(const TileBuffer& buffer);
  void colour_carefully(const TileBuffer& buffer, ivec2 origin);
  void count_light(const Share& share, const ShadingGroup& group);
  TileRows rows_of(const Window& pixels, Image& image) const;
  void write(const Window& pixels, Image& image) const;

  const FrameShading& shading_;
  Surfaces surfaces_;
  std::uint32_t background_;
  ShadingCount count_{};
  std::vector<std::int32_t> table_;  ///< slots by a hash of ids
  std::vector<Seen> seen_;
  SeenTriangles triangles_;  ///< sixteen at a time
  std::vector<RecordBlock> records_;
  std::vector<std::int32_t> share_of_group_;
  std::vector<Share> shares_;
  std::vector<std::int32_t> groups_here_;
  std::vector<std::size_t> careful_cells_;
  std::vector<float> light_;
  std::array<ShownBlock, most_shown_blocks> in_blocks_;
  std::size_t in_blocks_count_ = 0;
  std::vector<ShownTriangle> shown_;
  std::vector<Fragment> fragments_;  ///< those of a pixel beside one another
  std::vector<LinearRgb> fragment_light_;
  std::vector<std::vector<std::int32_t>> fragments_of_;  ///< by share
  std::vector<float> columns_, rows_;
  std::vector<std::int32_t> fragment_slots_;
  std::vector<std::size_t> mixed_cells_;
  std::vector<std::uint32_t> packed_;
  TileBuffer whole_;  ///< of the pixels that show one triangle alone
  alignas(64) std::array<std::uint32_t, TileBuffer::cells> colours_;
};

}  // namespace gradus::pipeline::engine
