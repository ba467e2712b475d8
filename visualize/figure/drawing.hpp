#pragma once
// The drawing slot as plain data: cells of a grid and marks over them, in the algorithm's own coordinates.
// Everything has a stable id (a cell: its coordinates), so that a step is told as what it changes.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "core/geometry.hpp"
#include "core/image.hpp"
#include "figure/align.hpp"
#include "figure/role.hpp"

namespace gradus {

/// A round marker.
struct Dot {
  dvec2 at;
  bool ring = false;  ///< hollow: looked at, not taken
  friend bool operator==(const Dot&, const Dot&) = default;
};

/// A straight line between two points; with `arrow`, a head at b; `dashed` in any role: hidden, or only
/// thought.
struct Stroke {
  dvec2 a, b;
  bool arrow = false;
  bool dashed = false;
  bool thin = false;  ///< in any role: it lies behind, or only leads from one thing to another
  friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// A chain of points, closed or not; `dashed` as for a stroke.
struct Path {
  std::vector<dvec2> points;
  bool closed = false;
  bool dashed = false;
  bool aside = false;  ///< as for a text
  friend bool operator==(const Path&, const Path&) = default;
};

/// The inside of rings (what an odd number of them goes round), in the ground of its role, below all lines.
/// It has no outline of its own.
struct Area {
  std::vector<std::vector<dvec2>> rings;
  int shade = 0;  ///< 1 to 3: a face of a solid or a sheet of glass, in a tint of its role, light to dark
  friend bool operator==(const Area&, const Area&) = default;
};

/// A picture that is looked at as a whole, not pixel by pixel: drawn smoothly in its rectangle, below all
/// lines, row 0 at the top. Copies share the pixels.
struct Picture {
  dvec2 lower, upper;
  std::shared_ptr<const Image> image;
  bool aside = false;  ///< as for a text
  friend bool operator==(const Picture& a, const Picture& b) {
    return a.lower == b.lower && a.upper == b.upper && a.aside == b.aside &&
           (a.image == b.image || *a.image == *b.image);
  }
};

/// Text at its place: the number of a tick, a region's code, a caption. `at` is its left end, middle or right
/// end at half height. Where it would lie on a text that is there already it is left out; the first by id
/// stays.
struct Text {
  dvec2 at;
  std::string text;
  Align align = Align::centre;
  bool aside = false;  ///< explains the whole drawing: left out where it is one of many
  int line = 0;        ///< of a paragraph: so many lines of text below the place, above it where negative
  friend bool operator==(const Text&, const Text&) = default;
};

/// Text beside a point. The layout finds a free place near it and draws a leader when that is not adjacent.
struct Label {
  dvec2 at;
  std::string text;
  friend bool operator==(const Label&, const Label&) = default;
};

/// One thing drawn over the grid.
struct Mark {
  std::string id;  ///< stable over all steps; setting a mark with a known id replaces it
  Role role;
  std::variant<Dot, Stroke, Path, Area, Text, Label, Picture> shape;
  std::string quantity{};  ///< whose value a dot or text shows: its colour goes before the role's
  friend bool operator==(const Mark&, const Mark&) = default;
};

/// How a cell of the grid looks: its role, and a short text in it (drawn where the cell is large enough).
struct CellLook {
  Role role;
  std::string text;
  std::optional<Rgba8> color{};  ///< a pixel of a picture that comes out: drawn in this instead of the role
  friend bool operator==(const CellLook&, const CellLook&) = default;
};

/// A cell as one number, another for each.
constexpr std::uint64_t key_of(ivec2 p) {
  return (std::uint64_t{static_cast<std::uint32_t>(p.y)} << 32) | static_cast<std::uint32_t>(p.x);
}

/// A cell that changes its look; nothing: back to the bare grid.
struct CellChange {
  ivec2 at;
  std::optional<CellLook> look;
};

/// What one step changes in the drawing, in this order: marks go, cells change (later entries win), marks
/// come.
struct Delta {
  /// From now on the drawing is a plane without cells (true), or the grid again (false). On a plane the
  /// grid's lines, centres and axes are not drawn; marks keep their coordinates.
  std::optional<bool> plane{};
  std::vector<std::string> removed;  ///< ids of marks that go
  std::vector<CellChange> cells;
  std::vector<Mark> set;  ///< marks that are new or replaced, by id
  std::size_t size() const { return cells.size() + set.size() + removed.size(); }
};

/// What the drawing shows after some step: how each cell looks, and the marks by id.
/// Memory: a byte per cell for grids of up to 2^26 cells; for larger ones as much as has been changed.
class Canvas {
 public:
  Canvas() = default;
  explicit Canvas(const Window& cells);

  void apply(const Delta& delta);

  /// How the cell looks, if it is not bare. Any cell may be asked for.
  std::optional<CellLook> at(ivec2 p) const;
  const std::map<std::string, Mark>& marks() const { return marks_; }
  /// Whether the drawing is a plane without cells.
  bool plane() const { return plane_; }
  /// Roughly what a copy costs, in units of one change.
  std::size_t size() const;

  friend bool operator==(const Canvas& a, const Canvas& b);

 private:
  static constexpr std::uint8_t bare = 0xff;
  void put(ivec2 p, std::uint8_t role);

  Window window_;
  std::vector<std::uint8_t> dense_;  ///< a role per cell, or bare; empty for a huge grid
  std::unordered_map<std::uint64_t, std::uint8_t> sparse_;  ///< the same where cells are too many
  std::unordered_map<std::uint64_t, std::string> texts_;
  std::unordered_map<std::uint64_t, Rgba8> colors_;
  bool plane_ = false;
  std::map<std::string, Mark> marks_;
};

/// The grid a drawing stands on. Cell (x, y) is the unit square whose centre is the point (x, y) of the
/// marks' coordinates: integers lie at cell centres.
struct Grid {
  Window cells;      ///< the cells there are; all of int32 is allowed
  bool y_up = true;  ///< lines and circles: up; anything with an image: row 0 at the top
  std::string x_name = "x", y_name = "y";
  bool whole = false;            ///< all cells are always shown, however small: no view that follows the step
  bool on_lines = false;         ///< numbers stand at the lines: cell (x, y) reaches from x to x + 1
  std::optional<Window> part{};  ///< of a slide: these cells are shown, and the whole beside them
  bool axes = true;              ///< false: a paper, whose drawings bring scales of their own
  double lines = 0;  ///< of a paper with lines of text: in units of a slide, how large a cell they ask for
  int shelf = 0;  ///< so many rows, those of the least numbers, are no part of the grid but room beside it:
                  ///< cells that a story puts there are drawn, without lines, centres and numbers
  /// The input picture, if there is one: one texel per cell, from cells.lower, row 0 first. Copies share it.
  std::shared_ptr<const Image> picture;

  /// The cells that are the grid's own: those of a shelf are not.
  Window own() const { return {{cells.lower.x, cells.lower.y + shelf}, cells.upper}; }
};

}  // namespace gradus
