#include "antialiasing/area_sampling/area_sampling_batch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "core/contract.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::area_sampling {
namespace {

using triangle_coverage::farthest;
using triangle_coverage::subpixels;

__extension__ typedef __int128 Wide;
__extension__ typedef unsigned __int128 UnsignedWide;

constexpr bool near_enough(ivec2 p) {
  constexpr int limit = farthest * subpixels;
  return -limit <= p.x && p.x <= limit && -limit <= p.y && p.y <= limit;
}

/// Twice the area of all rings in 1/65536 pixel: its sign tells which way round they run.
Wide doubled_area(std::span<const AreaScan::Ring> rings) {
  Wide area = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ivec2 from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
      area += Wide{from.x} * to.y - Wide{from.y} * to.x;
    }
  }
  return area;
}

/// A fraction numerator / denominator, denominator > 0.
struct Fraction {
  Wide numerator;
  Wide denominator;
};

/// The area on the right of an edge within a pixel, in 1/65536: the integral of clamp(g, 0, 256) over its
/// rows, where g is the distance from the edge to the pixel's right side.
Fraction area_right_of(ivec2 top, ivec2 bottom, int row, std::ptrdiff_t column) {
  const std::int64_t right = (static_cast<std::int64_t>(column) + 1) * subpixels;
  const std::int64_t begin = std::max<std::int64_t>(top.y, std::int64_t{row} * subpixels);
  const std::int64_t end = std::min<std::int64_t>(bottom.y, (std::int64_t{row} + 1) * subpixels);
  const std::int64_t dx = std::int64_t{bottom.x} - top.x, dy = std::int64_t{bottom.y} - top.y;
  if (end <= begin) return {0, 1};
  if (dx == 0) {
    const std::int64_t width = std::clamp<std::int64_t>(right - top.x, 0, subpixels);
    return {Wide{width} * (end - begin), 1};
  }
  // g times dy at both ends, and what the integral of the clamped g is there, times 2 dy dy
  const auto integral = [&](std::int64_t y) -> Wide {
    const Wide g = Wide{right - top.x} * dy - Wide{y - top.y} * dx;
    const Wide whole = Wide{subpixels} * dy;
    if (g <= 0) return 0;
    return g < whole ? g * g : whole * (2 * g - whole);
  };
  const Wide difference = integral(begin) - integral(end);
  return dx > 0 ? Fraction{difference, 2 * Wide{dx} * dy} : Fraction{-difference, -2 * Wide{dx} * dy};
}

/// a / b and a mod b with 0 <= a mod b < b. Domain: b > 0.
struct Quotient {
  Wide whole, rest;
};
constexpr Quotient divided(Wide a, Wide b) {
  Wide whole = a / b, rest = a % b;
  if (rest < 0) whole -= 1, rest += b;
  return {whole, rest};
}

/// Whether a sum of fractions is 0 or more. Digit by digit of 64 bits: what is left of all fractions
/// together is below their number, so that a sum that far from 0 is told; one that stays as near for more
/// digits than the common denominator has is 0.
/// Domain: denominators below 2^62.
bool at_least_zero(std::span<const Fraction> terms) {
  Wide whole = 0;
  int denominator_bits = 0;
  std::vector<Fraction> rests;
  for (const auto& [numerator, denominator] : terms) {
    const auto [quotient, rest] = divided(numerator, denominator);
    whole += quotient;
    if (rest == 0) continue;
    rests.push_back({rest, denominator});
    denominator_bits += static_cast<int>(std::bit_width(static_cast<std::uint64_t>(denominator)));
  }
  const Wide count = static_cast<Wide>(rests.size());
  // The sum is whole + the rests, and these lie between 0 and their number
  for (int bits = 0; bits <= denominator_bits + 64; bits += 64) {
    if (whole >= 0) return true;
    if (whole + count <= 0) return false;
    whole <<= 64;
    for (auto& [rest, denominator] : rests) {
      const UnsignedWide scaled = static_cast<UnsignedWide>(rest) << 64;
      whole += static_cast<Wide>(scaled / static_cast<UnsignedWide>(denominator));
      rest = static_cast<Wide>(scaled % static_cast<UnsignedWide>(denominator));
    }
  }
  return true;
}

/// Two opposite corners of a ring that is a box with level and upright sides.
std::optional<std::array<ivec2, 2>> box_in(std::span<const AreaScan::Ring> rings) {
  if (rings.size() != 1 || rings[0].size() != 4) return std::nullopt;
  const auto& r = rings[0];
  const bool level_first = r[0].y == r[1].y && r[1].x == r[2].x && r[2].y == r[3].y && r[3].x == r[0].x;
  const bool upright_first = r[0].x == r[1].x && r[1].y == r[2].y && r[2].x == r[3].x && r[3].y == r[0].y;
  if (!level_first && !upright_first) return std::nullopt;
  return std::array{ivec2(std::min(r[0].x, r[2].x), std::min(r[0].y, r[2].y)),
                    ivec2(std::max(r[0].x, r[2].x), std::max(r[0].y, r[2].y))};
}

/// How much of a pixel's 256 parts along an axis lies between two coordinates.
constexpr int part_between(int lower, int upper, int pixel) {
  return std::min(upper, (pixel + 1) * subpixels) - std::max(lower, pixel * subpixels);
}

/// A box: the area of each pixel is a product of two whole numbers.
void draw_box(Raster<std::uint8_t>& picture, ivec2 lower, ivec2 upper) {
  const int left = std::max(lower.x, 0) >> 8, top = std::max(lower.y, 0) >> 8;
  const int right = std::min((upper.x - 1) >> 8, picture.width() - 1);
  const int bottom = std::min((upper.y - 1) >> 8, picture.height() - 1);
  if (left > right) return;
  const int begins = part_between(lower.x, upper.x, left), ends = part_between(lower.x, upper.x, right);
  for (int y = top; y <= bottom; ++y) {
    const int height = part_between(lower.y, upper.y, y);
    const auto byte = [height](int width) {
      return static_cast<std::uint8_t>((255 * width * height + 32768) >> 16);
    };
    const auto put = [row = picture.row(y)](int from, int to, std::uint8_t value) {
      if (from < to && value != 0) std::fill(row.begin() + from, row.begin() + to, value);
    };
    put(left, left + 1, byte(begins));
    put(left + 1, right, byte(subpixels));
    put(std::max(left + 1, right), right + 1, byte(ends));
  }
}

/// Where the i-th byte in memory lies within eight of them.
constexpr int shift_of(int i) { return std::endian::native == std::endian::little ? 8 * i : 56 - 8 * i; }

std::size_t at(std::ptrdiff_t index) { return static_cast<std::size_t>(index); }

}  // namespace

/// The part of the picture that the polygon may reach, and how many of its rows fit the nearest memory.
void AreaScan::place(const Raster<std::uint8_t>& picture, std::span<const Ring> rings) {
  constexpr int most = farthest * subpixels;
  ivec2 lower(most), upper(-most);
  for (const Ring& ring : rings) {
    for (const ivec2 p : ring) {
      expects(near_enough(p), "a corner lies at ({}, {})/256, more than {} pixels out", p.x, p.y, farthest);
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
  }
  farthest_ = std::max({-lower.x, -lower.y, upper.x, upper.y, 0}) / double{subpixels};
  const auto before = [](int x) { return std::max(x, 0) / subpixels; };
  const auto behind = [](int x, int size) { return std::clamp((x + subpixels - 1) / subpixels, 0, size); };
  corner_ = {before(lower.x), before(lower.y)};
  columns_ = std::max(behind(upper.x, picture.width()) - corner_.x, 0);
  rows_ = std::max(behind(upper.y, picture.height()) - corner_.y, 0);
  stride_ = at(columns_ + 2 * group) / group * group;
  groups_ = (stride_ / group + 7) / 8 * 8;
  band_rows_ = static_cast<int>(std::clamp<std::size_t>(2048 / stride_, 1, 64));
  if (changes_.size() < at(band_rows_) * stride_) changes_.resize(at(band_rows_) * stride_);
  if (touched_.size() < at(band_rows_) * groups_) touched_.resize(at(band_rows_) * groups_);
}

/// The edges, by the band in which they begin.
void AreaScan::collect(std::span<const Ring> rings) {
  edges_.clear();
  rounded_ = false;
  first_.assign(at((rows_ + band_rows_ - 1) / band_rows_), -1);
  for (const Ring& ring : rings) {
    ivec2 from = ring.empty() ? ivec2(0) : ring.back();
    for (const ivec2 to : ring) {
      add_edge(from, to);
      from = to;
    }
  }
}

void AreaScan::add_edge(ivec2 from, ivec2 to) {
  if (from.y == to.y) return;
  const bool down = from.y < to.y;
  const ivec2 top = down ? from : to, bottom = down ? to : from;
  const int row = std::max(top.y / subpixels - corner_.y, 0);
  if (bottom.y <= corner_.y * subpixels || row >= rows_) return;
  const double dx = static_cast<double>(bottom.x) - top.x, dy = static_cast<double>(bottom.y) - top.y;
  const int left = corner_.x * subpixels, right = left + columns_ * subpixels;
  auto& first = first_[at(row / band_rows_)];
  edges_.push_back({.top = top,
                    .bottom = bottom,
                    .x = (static_cast<double>(top.x) - left) / subpixels,
                    .across = dx / dy / subpixels,
                    .rise = dx == 0 ? 0 : std::abs(dy / dx),
                    .sign = down ? orientation_ : -orientation_,
                    .cut = std::min(top.x, bottom.x) < left || std::max(top.x, bottom.x) > right,
                    .next = first});
  rounded_ |= dx != 0 && std::abs(dx) != dy;
  first = static_cast<std::int32_t>(edges_.size() - 1);
}

/// How far 255 area may be off: ends of an edge and their differences by 2^-50 of the largest coordinate, and
/// each change by what is cut off.
std::int64_t AreaScan::doubt_of(std::size_t edges) const {
  const double off = static_cast<double>(edges) * 255 * (8 + farthest_ * 0x1p-7);
  return static_cast<std::int64_t>(std::min(off, static_cast<double>(whole / 2)));
}

/// What an edge changes in a row of the band, where it goes from `left` to `right` in so much of its height.
inline void AreaScan::add(const Edge& edge, int row, double left, double right, std::int64_t height) {
  const auto first = static_cast<std::ptrdiff_t>(left);
  const double border = static_cast<double>(first + 1);
  if (right > border + 1) return add_long(edge, row, left, right, height);
  // It lies in two columns, or one: the rows it takes within the first and beyond
  const double beyond = std::max(right - border, 0.0), within = (right - left) - beyond;
  const double rows_beyond = edge.rise * beyond,
               rows_within = static_cast<double>(height) / whole - rows_beyond;
  const double scale = static_cast<double>(whole * edge.sign);
  const auto begins = static_cast<std::int64_t>(scale * rows_within * (border - left - within / 2));
  const auto ends = static_cast<std::int64_t>(scale * rows_beyond * beyond / 2);
  std::int64_t* const changes = changes_.data() + at(row) * stride_ + first;
  changes[0] += begins;
  changes[1] += height * edge.sign - begins - ends;
  changes[2] += ends;
  std::uint8_t* const touched = touched_.data() + at(row) * groups_;
  touched[first / group] = touched[(first + 2) / group] = 1;
}

/// The same for three columns and more: a triangle in the first and one in the last, between them the area
/// grows evenly.
void AreaScan::add_long(const Edge& edge, int row, double left, double right, std::int64_t height) {
  const auto first = static_cast<std::ptrdiff_t>(left), last = static_cast<std::ptrdiff_t>(right);
  std::int64_t* const changes = changes_.data() + at(row) * stride_;
  const double scale = static_cast<double>(whole * edge.sign) * edge.rise;
  const double before = static_cast<double>(first + 1) - left, after = right - static_cast<double>(last);
  auto covered = static_cast<std::int64_t>(scale * before * before / 2);
  changes[first] += covered;
  for (std::ptrdiff_t i = first + 1; i < last; ++i) {
    const auto here = static_cast<std::int64_t>(scale * (static_cast<double>(i) + 0.5 - left));
    changes[i] += here - covered;
    covered = here;
  }
  const auto ends = static_cast<std::int64_t>(scale * after * after / 2);
  changes[last] += height * edge.sign - ends - covered;
  changes[last + 1] += ends;
  std::uint8_t* const touched = touched_.data() + at(row) * groups_;
  std::fill(touched + first / group, touched + (last + 1) / group + 1, std::uint8_t{1});
}

/// The same for an edge that leaves the picture at a side: what lies left of it covers all, what lies right
/// of it nothing.
void AreaScan::add_cut(const Edge& edge, int row, double left, double right, std::int64_t height) {
  const double width = columns_;
  const auto height_of = [&](double columns) {
    return std::min(height, static_cast<std::int64_t>(std::min(columns * edge.rise, 1.0) * whole));
  };
  if (left >= width) return;
  if (left < 0) {
    const std::int64_t outside = right <= 0 ? height : height_of(-left);
    changes_[at(row) * stride_] += outside * edge.sign;
    touched_[at(row) * groups_] = 1;
    height -= outside;
  }
  if (right > width) height -= height_of(right - width);
  if (right > 0) add(edge, row, std::max(left, 0.0), std::min(right, width), height);
}

/// All rows of the band that an edge crosses.
inline void AreaScan::scan(const Edge& edge, int band) {
  const int upper = (corner_.y + band * band_rows_) * subpixels;
  const int lower = (corner_.y + std::min((band + 1) * band_rows_, rows_)) * subpixels;
  const int end = std::min(edge.bottom.y, lower);
  int y = std::max(edge.top.y, upper);
  double x = edge.x + (y - edge.top.y) * edge.across;
  for (int row = (y - upper) / subpixels; y < end; ++row) {
    const int next = std::min(upper + (row + 1) * subpixels, end);
    const double to = edge.x + (next - edge.top.y) * edge.across;
    const std::int64_t height = (next - y) * (whole / subpixels);
    if (edge.cut) {
      add_cut(edge, row, std::min(x, to), std::max(x, to), height);
    } else {
      add(edge, row, std::min(x, to), std::max(x, to), height);
    }
    x = to;
    y = next;
  }
}

/// The byte floor(255 area + 1/2) of a pixel, which is that number or the one before.
std::uint8_t AreaScan::decide(int row, std::ptrdiff_t column, int in_doubt) {
  ++decided_exactly_;
  // 255 area + 1/2 >= in_doubt, in 1/65536
  std::vector<Fraction> terms{{-(2 * Wide{in_doubt} - 1) * 32768, 1}};
  for (const std::int32_t i : active_) {
    const Edge& e = edges_[at(i)];
    const auto [numerator, denominator] = area_right_of(e.top, e.bottom, corner_.y + row, corner_.x + column);
    terms.push_back({numerator * (255 * e.sign), denominator});
  }
  return static_cast<std::uint8_t>(at_least_zero(terms) ? in_doubt : in_doubt - 1);
}

/// The byte of an area, exactly.
inline std::uint8_t AreaScan::byte_of(std::int64_t area, int row, std::ptrdiff_t column) {
  const std::int64_t scaled = 255 * area + whole / 2, part = scaled & (whole - 1);
  const auto byte = static_cast<int>(scaled / whole);
  if (part >= doubt_ && part < whole - doubt_) return static_cast<std::uint8_t>(byte);
  return doubt_ == 0 ? static_cast<std::uint8_t>(byte)
                     : decide(row, column, part < whole / 2 ? byte : byte + 1);
}

/// Gives the pixels from begin to end, which no edge crosses, the byte of their area.
inline void AreaScan::fill(std::span<std::uint8_t> pixels, int row, std::ptrdiff_t begin, std::ptrdiff_t end,
                           std::int64_t area) {
  if (begin >= end) return;
  const std::int64_t scaled = 255 * area + whole / 2;
  if (((scaled + doubt_) & (whole - 1)) < 2 * doubt_) return fill_exactly(pixels, row, begin, end, area);
  if (scaled < whole) return;
  std::memset(pixels.data() + begin, static_cast<int>(scaled >> 40), at(end - begin));
}

/// The same in doubt: an edge may reach into the first or the last of them by less than doubles can tell.
void AreaScan::fill_exactly(std::span<std::uint8_t> pixels, int row, std::ptrdiff_t begin, std::ptrdiff_t end,
                            std::int64_t area) {
  const std::ptrdiff_t second = begin + 1, last = std::max(second, end - 1);
  for (const auto& [from, to] : {std::pair(begin, second), std::pair(second, last), std::pair(last, end)}) {
    if (from >= to) continue;
    const std::uint8_t byte = byte_of(area, row, from);
    if (byte != 0) std::fill(pixels.data() + from, pixels.data() + to, byte);
  }
}

/// The bytes of a group of columns, packed as they lie in memory. Takes their changes away and adds them to
/// the area.
inline std::uint64_t AreaScan::bytes_of(std::int64_t* changes, int row, std::ptrdiff_t first,
                                        std::int64_t& area) {
  const std::int64_t doubt = doubt_;
  std::array<std::int64_t, group> areas;
  std::uint64_t bytes = 0;
  std::int64_t open = 0;
  for (int i = 0; i < group; ++i) {
    areas[at(i)] = area += changes[i];
    changes[i] = 0;
    const std::int64_t scaled = 255 * area + whole / 2;
    bytes |= static_cast<std::uint64_t>(scaled >> 40) << shift_of(i);
    open |= ((scaled + doubt) & (whole - 1)) - 2 * doubt;  // below 0 where in doubt
  }
  if (open >= 0) return bytes;
  bytes = 0;
  for (int i = 0; i < group; ++i)
    bytes |= std::uint64_t{byte_of(areas[at(i)], row, first + i)} << shift_of(i);
  return bytes;
}

/// Gives pixels these packed bytes, but for those that are 0.
inline void AreaScan::put(std::span<std::uint8_t> pixels, std::uint64_t bytes) {
  if (pixels.size() < group) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const auto byte = static_cast<std::uint8_t>(bytes >> shift_of(static_cast<int>(i)));
      if (byte != 0) pixels[i] = byte;
    }
    return;
  }
  // All ones in bytes that are not 0
  constexpr std::uint64_t low = 0x7f7f7f7f7f7f7f7f;
  const std::uint64_t taken = ((((bytes & low) + low) | bytes) & ~low) / 0x80 * 0xff;
  std::uint64_t before;
  std::memcpy(&before, pixels.data(), group);
  bytes |= before & ~taken;
  std::memcpy(pixels.data(), &bytes, group);
}

/// Adds the changes of a row up, and leaves none behind.
void AreaScan::sweep(std::span<std::uint8_t> pixels, int row, int row_of_band) {
  std::int64_t* const changes = changes_.data() + at(row_of_band) * stride_;
  std::uint8_t* const touched = touched_.data() + at(row_of_band) * groups_;
  std::int64_t area = 0;
  std::ptrdiff_t begin = 0;
  for (std::size_t eight = 0; eight < groups_; eight += 8) {
    std::uint64_t bits;
    std::memcpy(&bits, touched + eight, 8);
    if (bits == 0) continue;
    std::memset(touched + eight, 0, 8);
    for (; bits != 0; bits &= bits - 1) {
      const auto first = static_cast<std::ptrdiff_t>(eight + at(std::countr_zero(bits)) / 8) * group;
      fill(pixels, row, begin, std::min<std::ptrdiff_t>(first, columns_), area);
      const std::uint64_t bytes = bytes_of(changes + first, row, first, area);
      begin = std::min<std::ptrdiff_t>(first + group, columns_);
      if (first < columns_) put(pixels.subspan(at(first), at(begin - first)), bytes);
    }
  }
  fill(pixels, row, begin, columns_, area);
}

void AreaScan::draw(Raster<std::uint8_t>& picture, std::span<const Ring> rings) {
  const auto box = box_in(rings);
  if (!box && small_.draw(picture, rings)) return;
  const Wide area = doubled_area(rings);
  if (area == 0) return;
  place(picture, rings);
  if (columns_ == 0 || rows_ == 0) return;
  if (box) return draw_box(picture, (*box)[0], (*box)[1]);
  // What is covered lies right of edges that go up where the rings run clockwise, as one sees them
  orientation_ = area > 0 ? -1 : 1;
  collect(rings);
  active_.clear();
  for (int band = 0; band * band_rows_ < rows_; ++band) {
    const int begin = band * band_rows_, end = std::min(begin + band_rows_, rows_);
    for (std::int32_t i = first_[at(band)]; i >= 0; i = edges_[at(i)].next) active_.push_back(i);
    for (const std::int32_t i : active_) scan(edges_[at(i)], band);
    doubt_ = rounded_ ? doubt_of(active_.size()) : 0;
    for (int row = begin; row < end; ++row) {
      sweep(picture.row(corner_.y + row).subspan(at(corner_.x), at(columns_)), row, row - begin);
    }
    const int next = (corner_.y + end) * subpixels;
    std::erase_if(active_, [&](std::int32_t i) { return edges_[at(i)].bottom.y <= next; });
  }
}

}  // namespace gradus::area_sampling
