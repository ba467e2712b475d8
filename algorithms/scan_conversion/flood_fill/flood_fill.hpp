#pragma once
// Filling: painting everything that is connected to a seed.
//
// The caller says what is inside and how it is painted: `inside(pixel)` asks, `paint(pixel)` paints, and
// painting a pixel makes inside false for it. That is all the memory the methods have of where they have
// been. Rows count downwards, as in every image: y + 1 is the row below.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/image.hpp"
#include "core/observe.hpp"
#include "core/raster.hpp"
#include "scan_conversion/flood_fill/containers.hpp"

namespace gradus::flood_fill {

/// How many pixels: int may be too short for it.
using Whole = std::int64_t;

/// Which pixels touch: those that share a side, or those that share a side or a corner.
enum class Connectivity { four = 4, eight = 8 };

enum class Method { depth_first, breadth_first, span };

/// From a pixel to its neighbours, in the order they are asked: right, left, down, up, then the corners.
inline constexpr std::array<ivec2, 8> directions{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

constexpr std::span<const ivec2> ways(Connectivity connectivity) {
  return std::span(directions).first(static_cast<std::size_t>(connectivity));
}

/// What a fill has done and the memory it took.
struct Filled {
  Whole painted = 0;             ///< pixels painted
  std::size_t peak_waiting = 0;  ///< most entries that its stack or queue held at once
  std::size_t peak_bytes = 0;    ///< the same in bytes, without the spare room that a container keeps
  std::size_t mask_bytes = 0;    ///< of the mask of visited pixels, where one was needed (fill_image)
  friend constexpr bool operator==(const Filled&, const Filled&) = default;
};

// --- Steps -------------------------------------------------------

/// The seed was asked for.
struct Started {
  ivec2 seed;
  Connectivity connectivity;
  bool inside;  ///< false ends the fill with nothing painted
};

/// A pixel was painted and put on the stack (depth_first: the path) or into the queue (breadth_first).
struct Painted {
  ivec2 from;  ///< the neighbour it was reached from; the seed itself for the seed
  ivec2 pixel;
  std::size_t waiting;  ///< entries on the stack or in the queue, this one included
};

/// A neighbour was asked for. Not inside means wall, other colour, or painted already.
struct Examined {
  ivec2 from, pixel;
  bool inside;
};

/// depth_first: `pixel` has no neighbours left, it was taken off the path.
struct Retreated {
  ivec2 pixel;
  std::size_t waiting;  ///< entries left on the path; its last one goes on
};

/// breadth_first: the pixel that has waited longest was taken out; its neighbours come next.
struct Dequeued {
  ivec2 pixel;
  std::size_t waiting;  ///< entries left in the queue
};

/// Painted pixels left .. right of a row, whose neighbours in the row beside it, row + way, are still to be
/// asked for. The pixels at left - 1 and right + 1 are not inside (painted, or something else).
struct Span {
  int row, left, right;
  int way;  ///< +1: towards the row below, -1: towards the row above

  /// The row beside it, which is looked along.
  constexpr int beyond() const { return row + way; }
  constexpr Whole length() const { return Whole{right} - left + 1; }
  /// The same, looking the other way.
  constexpr Span turned() const { return {row, left, right, -way}; }
  /// The same, longer by so many pixels at both ends.
  constexpr Span widened(int by) const { return {row, left - by, right + by, way}; }
  /// What sticks out to the left (right) of s, looking back to the row of s.
  constexpr Span left_of(const Span& s) const { return {row, left, s.left - 1, -way}; }
  constexpr Span right_of(const Span& s) const { return {row, s.right + 1, right, -way}; }
};

/// span: pixels left .. right of a row were painted in one go; both their ends are stopped.
struct SpanFilled {
  Span span;    ///< .way is the way it was reached: from row - way (the seed's: +1)
  ivec2 found;  ///< the pixel it was grown from, to the left and to the right
};

/// span: a span was put on the stack.
struct SpanQueued {
  Span span;
  std::size_t waiting;  ///< entries on the stack, this one included
};

/// span: the span on top was taken off the stack; the row beside it is scanned next.
struct SpanTaken {
  Span span;
  std::size_t waiting;  ///< entries left on the stack
};

/// Nothing waits any more.
struct Finished {
  Filled filled;
};

/// What a fill reports at its end.
template <class Container>
Filled tally(const Container& waiting, Whole painted) {
  return {painted, waiting.peak(), waiting.peak() * Container::entry_bytes, 0};
}
/// The same of a container that every painted pixel has been in, once.
template <class Container>
Filled tally(const Container& waiting) {
  return tally(waiting, waiting.pushed());
}

// --- depth_first -------------------------------------------------

/// A pixel on the path and how many of its neighbours have been asked for: what a recursive call keeps.
struct Frame {
  ivec2 pixel;
  std::uint32_t asked = 0;
};

/// Fills by going on from every newly painted pixel at once, and back when there is nowhere to go. The stack
/// holds the path from the seed, exactly the calls that the textbook's recursion would have open, in the heap
/// instead of on the machine's stack (which overflows: see flood_fill_notes.hpp).
/// A. R. Smith, Tint fill, SIGGRAPH 1979, 276-283; the recursion is the lecture notes'.
///
/// seed: where to start. inside(ivec2) -> bool: to be filled, and not painted yet. paint(ivec2): paints.
///
/// Domain: paint(p) makes inside(p) false; inside holds for finitely many pixels, none within two of the
///   ends of int32. A seed that is not inside paints nothing.
/// Steps: Started (Painted (Examined Painted? | Retreated)*)? Finished
/// Accuracy: paints every pixel connected to the seed through inside ones, once, and asks for
///   no others but their neighbours.
/// Cost: one question and one paint per pixel, and 4 (8) questions for its neighbours; the path may be as
///   long as the area has pixels (on an empty canvas of W x H from a corner it is W H), 12 bytes each.
/// Errors: none.
template <class Inside, class Paint, Observer<Started, Painted, Examined, Retreated, Finished> O = Unobserved>
Filled depth_first(ivec2 seed, Inside&& inside, Paint&& paint, Connectivity connectivity = Connectivity::four,
                   O&& observer = {}) {
  auto moves = ways(connectivity);
  Stack<Frame> path;
  bool free = inside(seed);
  if constexpr (observed<O>) observer(Started{seed, connectivity, free});
  if (free) {
    paint(seed);
    path.push({seed});
    if constexpr (observed<O>) observer(Painted{seed, seed, path.size()});
  }
  while (!path.empty()) {
    auto [p, asked] = path.top();
    // All neighbours asked: go back
    if (asked == moves.size()) {
      path.pop();
      if constexpr (observed<O>) observer(Retreated{p, path.size()});
      continue;
    }
    // Go to the next one if free
    ivec2 next = p + moves[asked];
    ++path.top().asked;
    free = inside(next);
    if constexpr (observed<O>) observer(Examined{p, next, free});
    if (!free) continue;
    paint(next);
    path.push({next});
    if constexpr (observed<O>) observer(Painted{p, next, path.size()});
  }
  if constexpr (observed<O>) observer(Finished{tally(path)});
  return tally(path);
}

// --- breadth_first -----------------------------------------------

/// Fills in waves: the pixel that has waited longest is taken from a queue and its free neighbours are
/// painted and put in. Painting on the way in, not on the way out, is what keeps a pixel from waiting twice.
/// E. F. Moore, The shortest path through a maze, 1959, on the graph of pixels.
///
/// Parameters, Domain, Accuracy and Errors: as for depth_first.
/// Steps: Started (Painted (Dequeued (Examined Painted?)*)*)? Finished
/// Cost: as many questions as depth_first; the queue holds one wave, at most a small multiple of W + H on an
///   empty canvas of W x H (8 bytes each).
template <class Inside, class Paint, Observer<Started, Painted, Dequeued, Examined, Finished> O = Unobserved>
Filled breadth_first(ivec2 seed, Inside&& inside, Paint&& paint,
                     Connectivity connectivity = Connectivity::four, O&& observer = {}) {
  auto moves = ways(connectivity);
  Queue<ivec2> waiting;
  bool free = inside(seed);
  if constexpr (observed<O>) observer(Started{seed, connectivity, free});
  if (free) {
    paint(seed);
    waiting.push(seed);
    if constexpr (observed<O>) observer(Painted{seed, seed, waiting.size()});
  }
  while (!waiting.empty()) {
    // The one that waited longest
    ivec2 pixel = waiting.take();
    if constexpr (observed<O>) observer(Dequeued{pixel, waiting.size()});
    // Its free neighbours wait, too
    for (ivec2 move : moves) {
      ivec2 next = pixel + move;
      free = inside(next);
      if constexpr (observed<O>) observer(Examined{pixel, next, free});
      if (!free) continue;
      paint(next);
      waiting.push(next);
      if constexpr (observed<O>) observer(Painted{pixel, next, waiting.size()});
    }
  }
  if constexpr (observed<O>) observer(Finished{tally(waiting)});
  return tally(waiting);
}

// --- span --------------------------------------------------------

/// How far a span reaches beyond its ends: 1 when pixels that touch only by a corner are neighbours, else 0.
constexpr int corners(Connectivity connectivity) { return connectivity == Connectivity::eight ? 1 : 0; }

/// The whole run of inside pixels in the row of `pixel`, grown from it to both sides; it looks that way.
/// Domain: inside(pixel).
template <class Inside>
Span grow(ivec2 pixel, int way, Inside& inside) {
  constexpr ivec2 step{1, 0};
  ivec2 left = pixel, right = pixel;
  while (inside(left - step)) left -= step;
  while (inside(right + step)) right += step;
  return {pixel.y, left.x, right.x, way};
}
/// The same, looking the way of the span that it was reached from.
template <class Inside>
Span grow(ivec2 pixel, const Span& from, Inside& inside) {
  return grow(pixel, from.way, inside);
}

/// Paints a run; returns how many pixels it has.
template <class Paint>
Whole fill_run(const Span& run, Paint& paint) {
  ivec2 pixel{run.left, run.row};
  for (; pixel.x <= run.right; ++pixel.x) paint(pixel);
  return run.length();
}

/// Fills a whole run of a row at a time, and remembers runs instead of pixels: from each it looks along the
/// row beyond and, where the run sticks out beyond the one it was reached from, back along that one's row.
/// P. S. Heckbert, A seed fill algorithm, Graphics Gems, 1990, 275-277, here for both connectivities.
///
/// Parameters, Domain, Accuracy and Errors: as for depth_first.
/// Steps: Started (SpanFilled SpanQueued SpanQueued (SpanTaken (Examined (SpanFilled SpanQueued+)?)*)*)?
///   Finished; Examined is reported for the row that is scanned, not for the pixels that a run grows over.
/// Cost: about one question per pixel on an empty canvas, on noise about 2.3 (eight-connected: 4), never more
///   than depth_first. Every run is put on the stack once, and once more for each end that sticks out, 16
///   bytes each: on an empty canvas the stack never holds more than 2, at any size and wherever the
///   seed, as each run covers its row and nothing sticks out.
template <class Inside, class Paint,
          Observer<Started, Examined, SpanFilled, SpanQueued, SpanTaken, Finished> O = Unobserved>
Filled span(ivec2 seed, Inside&& inside, Paint&& paint, Connectivity connectivity = Connectivity::four,
            O&& observer = {}) {
  int c = corners(connectivity);
  Stack<Span> stack;
  Whole count = 0;
  bool free = inside(seed);
  if constexpr (observed<O>) observer(Started{seed, connectivity, free});
  if (free) {
    Span s = grow(seed, 1, inside);
    count += fill_run(s, paint);
    if constexpr (observed<O>) observer(SpanFilled{s, seed});
    stack.push(s.turned());
    if constexpr (observed<O>) observer(SpanQueued{s.turned(), stack.size()});
    stack.push(s);
    if constexpr (observed<O>) observer(SpanQueued{s, stack.size()});
  }
  while (!stack.empty()) {
    // Look along the row beside it
    const Span s = stack.take();
    if constexpr (observed<O>) observer(SpanTaken{s, stack.size()});
    Span row = s.widened(c);
    Span stop = s.widened(1 - c);
    ivec2 p{row.left, s.beyond()};
    while (p.x <= row.right) {
      free = inside(p);
      if constexpr (observed<O>) observer(Examined{ivec2{std::clamp(p.x, s.left, s.right), s.row}, p, free});
      if (!free) {
        ++p.x;
        continue;
      }
      Span run = grow(p, s, inside);
      count += fill_run(run, paint);
      if constexpr (observed<O>) observer(SpanFilled{run, p});
      // Go on, and back where wider
      stack.push(run);
      if constexpr (observed<O>) observer(SpanQueued{run, stack.size()});
      if (run.left < stop.left) {
        stack.push(run.left_of(s));
        if constexpr (observed<O>) observer(SpanQueued{run.left_of(s), stack.size()});
      }
      if (run.right > stop.right) {
        stack.push(run.right_of(s));
        if constexpr (observed<O>) observer(SpanQueued{run.right_of(s), stack.size()});
      }
      // Past what stops it
      p.x = run.right + 2;
    }
  }
  if constexpr (observed<O>) observer(Finished{tally(stack, count)});
  return tally(stack, count);
}

// --- All of them -------------------------------------------------

/// Can watch a fill by any method.
template <class O>
concept FillObserver =
    Observer<O, Started, Painted, Examined, Retreated, Dequeued, SpanFilled, SpanQueued, SpanTaken, Finished>;

/// Fills by the method named. All methods paint the same pixels.
template <class Inside, class Paint, FillObserver O = Unobserved>
Filled fill(Method method, ivec2 seed, Inside&& inside, Paint&& paint,
            Connectivity connectivity = Connectivity::four, O&& observer = {}) {
  if (method == Method::depth_first) return depth_first(seed, inside, paint, connectivity, observer);
  if (method == Method::breadth_first) return breadth_first(seed, inside, paint, connectivity, observer);
  return span(seed, inside, paint, connectivity, observer);
}

/// The pixels whose neighbours' neighbours are all in the int32 plane.
inline constexpr Window room{{INT32_MIN + 2, INT32_MIN + 2}, {INT32_MAX - 2, INT32_MAX - 2}};

/// Fills what is connected to the seed within a window: the fill of the picture cut to the window.
/// Pixels outside are never asked for nor painted, and connect nothing: a region that leaves the window and
/// comes back in another place is painted only where the seed is.
///
/// window: both corners included. The other parameters are those of fill.
///
/// Domain: an empty window, or a seed outside it, paints nothing.
/// Steps: those of the method.
/// Accuracy: exactly the pixels of the cut picture's fill.
/// Cost: O(cells of the window), however large the region.
/// Errors: ContractViolation when the window comes within two cells of the ends of int32.
template <class Inside, class Paint, FillObserver O = Unobserved>
Filled in_window(Method method, ivec2 seed, const Window& window, Inside&& inside, Paint&& paint,
                 Connectivity connectivity = Connectivity::four, O&& observer = {}) {
  expects(window.empty() || (room.contains(window.lower) && room.contains(window.upper)),
          "a window to fill stays two cells away from the ends of int32, unlike {},{} to {},{}",
          window.lower.x, window.lower.y, window.upper.x, window.upper.y);
  const auto inside_window = [&](ivec2 p) { return window.contains(p) && inside(p); };
  return fill(method, seed, inside_window, paint, connectivity, observer);
}

// --- Rasters and images ------------------------------------------

/// What every fill of a raster asks first: a seed outside is a ContractViolation.
template <class Cell>
void expects_inside(const Raster<Cell>& raster, ivec2 seed) {
  expects(raster.contains(seed),
          "the seed {},{} lies outside the {} x {} cells (columns 0 to {}, rows 0 to {})", seed.x, seed.y,
          raster.width(), raster.height(), raster.width() - 1, raster.height() - 1);
}

/// Gives every cell that is connected to the seed through cells of the seed's value a new value.
///
/// seed: column, row. value: the new one; when it is the seed's own, nothing is painted.
///
/// Domain: rasters narrower and lower than 2^31 - 3 cells.
/// Errors: ContractViolation when the seed lies outside the raster.
template <class Cell, FillObserver O = Unobserved>
Filled fill_raster(Raster<Cell>& raster, ivec2 seed, const Cell& value, Method method = Method::span,
                   Connectivity connectivity = Connectivity::four, O&& observer = {}) {
  expects_inside(raster, seed);
  const Cell old = raster[seed];
  const bool nothing_to_do = old == value;
  const auto inside = [&](ivec2 p) { return !nothing_to_do && raster.contains(p) && raster[p] == old; };
  const auto paint = [&](ivec2 p) { raster[p] = value; };
  return fill(method, seed, inside, paint, connectivity, observer);
}

/// How an image is filled.
struct Options {
  int tolerance = 0;  ///< 0 .. 255: by how much each channel, alpha too, may differ from the seed's
  Connectivity connectivity = Connectivity::four;
  Method method = Method::span;
};

/// Whether no channel of the two colours differs by more than `tolerance`.
constexpr bool alike(Rgba8 a, Rgba8 b, int tolerance) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance &&
         std::abs(a.b - b.b) <= tolerance && std::abs(a.a - b.a) <= tolerance;
}

/// Paints the region of an image that a pixel belongs to: the pixels connected to it whose colour is like its
/// own, within the tolerance. They are compared with the seed, never with their neighbours, so that a soft
/// shade cannot lead across the whole picture.
///
/// image: row 0 at the top. seed: column, row. color: 8-bit sRGB, replaces the pixel's colour and alpha.
///
/// Domain: a color equal to the seed's with tolerance 0 changes nothing and returns at once.
/// Steps: those of the method.
/// Accuracy: exactly the region, for every color: when the new colour is itself within the tolerance, a mask
///   of visited pixels (one byte each) keeps apart what is painted.
/// Cost: as the method's; see docs/topics/scan_conversion/flood_fill.md.
/// Errors: ContractViolation when the seed lies outside the image or the tolerance outside 0 .. 255.
template <FillObserver O = Unobserved>
Filled fill_image(Image& image, ivec2 seed, Rgba8 color, const Options& options = {}, O&& observer = {}) {
  const auto [tolerance, connectivity, method] = options;
  expects(0 <= tolerance && tolerance <= 255, "a tolerance is 0 to 255, not {}", options.tolerance);
  expects(image.contains(seed),
          "the seed {},{} lies outside the image of {} x {} pixels (columns 0 to {}, rows 0 to {})", seed.x,
          seed.y, image.width(), image.height(), image.width() - 1, image.height() - 1);
  if (tolerance == 0) return fill_raster(image, seed, color, method, connectivity, observer);
  const Rgba8 old = image[seed];
  const auto in_region = [&, limit = tolerance](ivec2 p) {
    return image.contains(p) && alike(image[p], old, limit);
  };
  // The new colour is unlike the old: painting a pixel takes it out of the region
  if (!alike(color, old, tolerance)) {
    return fill(method, seed, in_region, [&](ivec2 p) { image[p] = color; }, connectivity, observer);
  }
  Raster<std::uint8_t> visited(image.width(), image.height());
  const auto inside = [&](ivec2 p) { return in_region(p) && !visited[p]; };
  const auto paint = [&](ivec2 p) {
    image[p] = color;
    visited[p] = 1;
  };
  Filled filled = fill(method, seed, inside, paint, connectivity, observer);
  filled.mask_bytes = visited.cells().size();
  return filled;
}

}  // namespace gradus::flood_fill
