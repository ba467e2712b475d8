#pragma once
// The z-buffer: for every pixel the nearest thing seen so far, whatever the order in which things come.

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/arithmetic/rounding.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/raster.hpp"

namespace gradus::z_buffer {

/// A depth was compared with what the pixel held.
template <class T, class Key>
struct Compared {
  ivec2 pixel;
  T depth;
  Key key;
  std::optional<T> before;  ///< the depth that the pixel held; nothing when it was free
  bool nearer;              ///< whether the newcomer takes its place
};

/// What a pixel holds: its depth and who it is. Free while `taken` is false.
template <class T, class Key>
struct Cell {
  T depth{};
  Key key{};
  bool taken = false;
};

/// The depth that a cell holds, nothing when it is free.
template <class T, class Key>
constexpr std::optional<T> held(const Cell<T, Key>& cell) {
  return cell.taken ? std::optional<T>(cell.depth) : std::nullopt;
}

/// Whether (depth, key) goes before what the cell holds: it is nearer, or as near with the lower key. A depth
/// that is no number goes before nothing.
template <class T, class Key>
constexpr bool beats(const Cell<T, Key>& cell, T depth, const Key& key) {
  if (!(depth == depth)) return false;
  if (!cell.taken) return true;
  if (depth < cell.depth) return true;
  return depth == cell.depth && key < cell.key;
}

/// Tests a depth at a pixel and keeps it when it is the nearest so far. Returns whether it was kept.
/// Source: W. Straßer, Schnelle Kurven- und Flächendarstellung auf grafischen Sichtgeräten, 1974; E. Catmull,
/// A subdivision algorithm for computer display of curved surfaces, 1974.
///
/// buffer: a cell a pixel. pixel: in the buffer. depth: smaller is nearer. key: who it is, e.g. (object,
///   face); at equal depth the lower one is kept.
///
/// Domain: buffer.contains(pixel), not checked. A NaN depth is never kept.
/// Steps: Compared.
/// Accuracy: exact. The result is the least (depth, key) of all that were tested, in any order.
/// Cost: two or three comparisons; the memory is the buffer's, however much is drawn.
/// Errors: none.
template <class T, class Key, Observer<Compared<T, Key>> O = Unobserved>
constexpr bool keep_nearest(Raster<Cell<T, Key>>& buffer, ivec2 pixel, T depth, const Key& key,
                            O&& observer = {}) {
  auto& cell = buffer[pixel];
  const bool nearer = beats(cell, depth, key);
  if constexpr (observed<O>) observer(Compared<T, Key>{pixel, depth, key, held(cell), nearer});
  if (nearer) cell = {depth, key, true};
  return nearer;
}

}  // namespace gradus::z_buffer
