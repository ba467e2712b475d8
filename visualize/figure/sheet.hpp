#pragma once
// A figure laid out: shapes at pixel positions, in drawing order, each still with its role instead of a
// colour and with the slot and id it belongs to. What Cairo draws, what the overlap and contrast tests
// measure.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/geometry.hpp"
#include "core/image.hpp"
#include "figure/align.hpp"
#include "figure/role.hpp"

namespace gradus {

/// Pixels of the figure; y down.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

/// The furniture's own roles, beside those of marks.
enum class Tone : std::uint8_t {
  paper,   ///< the ground
  panel,   ///< the ground of listing, table and sentence
  header,  ///< the ground of a table's heading
  weak,    ///< ground of the previous line and the row that was read
  strong,  ///< ground of the current line and row
  rule,    ///< grid lines, borders
  ink,     ///< text
  muted,   ///< secondary text
  accent,  ///< the bar beside what is current
};

/// What colours a shape: a tone of the furniture, or one part of a role's look.
struct Paint {
  enum class Part : std::uint8_t {
    none,
    tone,
    role_mark,
    role_fill,
    role_text,
    on_role,
    role_tint,
    quantity
  };
  Part part = Part::none;
  Tone tone = Tone::ink;
  Role role = Role::input;
  int shade = 0;   ///< of a tint
  int number = 0;  ///< of a quantity

  static constexpr Paint of(Tone tone) { return {Part::tone, tone, Role::input}; }
  static constexpr Paint mark(Role role) { return {Part::role_mark, Tone::ink, role}; }
  static constexpr Paint fill(Role role) { return {Part::role_fill, Tone::ink, role}; }
  static constexpr Paint text(Role role) { return {Part::role_text, Tone::ink, role}; }
  /// Text on the role's fill.
  static constexpr Paint on(Role role) { return {Part::on_role, Tone::ink, role}; }
  /// The paper with a little of the role's mark in it; shade: 1 to 3, light to dark.
  static constexpr Paint tint(Role role, int shade) { return {Part::role_tint, Tone::ink, role, shade}; }
  /// A name or value of the trace's quantity of this number, below quantity_colors; a mark keeps its role.
  static constexpr Paint quantity(int number, Role role = Role::input) {
    return {Part::quantity, Tone::ink, role, 0, number};
  }
  friend bool operator==(const Paint&, const Paint&) = default;
};
inline constexpr int quantity_colors = 4;

enum class Slot : std::uint8_t { title, drawing, listing, table, sentence, footer };
inline constexpr std::array all_slots{Slot::title, Slot::drawing,  Slot::listing,
                                      Slot::table, Slot::sentence, Slot::footer};
constexpr std::string_view name_of(Slot slot) {
  constexpr std::array<std::string_view, 6> names{"title", "drawing",  "listing",
                                                  "table", "sentence", "footer"};
  return names[static_cast<std::size_t>(slot)];
}

struct RectShape {
  Box box;
  Paint fill, stroke;
  double stroke_width = 0, radius = 0;
  bool dashed = false;
  Hatch hatch = Hatch::none;  ///< over the fill
  Paint hatch_paint;
  double hatch_gap = 10;  ///< units
};
/// What rings enclose, an odd number of times.
struct AreaShape {
  std::vector<std::vector<dvec2>> rings;
  Paint fill;
  Hatch hatch = Hatch::none;  ///< over the fill
  Paint hatch_paint;
  double hatch_gap = 10;  ///< units
};
struct LineShape {
  std::vector<dvec2> points;
  Paint stroke;
  double width = 1;
  bool dashed = false, closed = false, arrow = false;
};
/// Many strokes of one look as a single path: a grid, or, with round ends and no length, its dots.
struct StrokesShape {
  std::vector<Segment<2, double>> segments;
  Paint stroke;
  double width = 1;
  bool round = false;
};
struct DiscShape {
  dvec2 centre;
  double radius;
  Paint fill, stroke;
  double stroke_width = 0;
};

enum class Face : std::uint8_t { sans, bold, italic, mono, mono_bold, bold_italic };
inline constexpr std::array all_faces{Face::sans, Face::bold,      Face::italic,
                                      Face::mono, Face::mono_bold, Face::bold_italic};

/// A stretch of a text that is set otherwise: a variable, a quantity.
struct TextSpan {
  std::size_t begin = 0, end = 0;  ///< bytes
  Face face = Face::sans;
  Paint paint{};
};

struct TextShape {
  dvec2 baseline;  ///< of the text's left end, centre or right end, by `align`
  std::string text;
  Face face = Face::sans;
  double size = 20;
  Align align = Align::left;
  Paint paint;
  bool halo = false;                      ///< a rim in the paper's colour, where it crosses lines
  Paint ground = Paint::of(Tone::paper);  ///< what it stands on: the halo's colour, and for the contrast test
  std::vector<TextSpan> spans{};          ///< in order, none over another
  /// Above 0: in any script, from the left, within this width. What fonts are installed tells how it looks,
  /// not the table; drawn in PDF files and pixels alone.
  double any_script_within = 0;
  Box box() const;  ///< ascent to descent, by the metrics table
  /// Whether it is another text's rim alone, which lies further down: it has no paint of its own.
  bool is_rim() const { return paint.part == Paint::Part::none; }
};
/// A raster of cells drawn as squares without smoothing, or `smooth`, as a picture.
struct ImageShape {
  Box box;
  Image image;
  Raster<std::uint8_t>
      roles{};  ///< empty, or of the image's size: 1 + a role paints that role's mark over it
  bool smooth = false;
};

struct Shape {
  Slot slot;
  std::string id;
  std::variant<RectShape, AreaShape, LineShape, StrokesShape, DiscShape, TextShape, ImageShape> what;
  double opacity = 1;  ///< below 1 only between steps, in films
};

/// The role that a shape shows, by what it is painted with; none for the furniture: axes, grid, texts of the
/// table.
std::optional<Role> role_of(const Shape& shape);

struct Sheet {
  double width = 1280, height = 720;
  std::vector<Shape> shapes;
  double unit = 1;  ///< pixels for one of a slide of 720 lines: halos, hatches and arrow heads keep to it
};

/// What a shape covers, its stroke included.
Box extents_of(const Shape& shape);
/// The shape, moved.
Shape moved(Shape shape, dvec2 by);
/// The part of a sheet in a box, as a sheet of its own; the box must hold all shapes that shall be seen.
Sheet cropped(Sheet sheet, const Box& box);

}  // namespace gradus
