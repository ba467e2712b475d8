// What themes promise where contrast is lost: on a bad projector, on a black-and-white printer.

#include "theme/theme.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "cairo/shapes.hpp"
#include "support/example_traces.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

/// On a projector that shows half the range from paper to ink: each channel half way to the middle.
Rgb faded(Rgb color, const Theme& theme) {
  const Rgb paper = theme[Tone::paper], ink = theme[Tone::ink];
  std::uint32_t hex = 0;
  for (const int shift : {16, 8, 0}) {
    const auto channel = [shift](Rgb c) { return (c.hex >> shift) & 255; };
    const double middle = (channel(paper) + channel(ink)) / 2.0;
    hex |= static_cast<std::uint32_t>(std::lround((channel(color) + middle) / 2)) << shift;
  }
  return {hex};
}
double faded_contrast(Rgb a, Rgb b, const Theme& theme) { return contrast(faded(a, theme), faded(b, theme)); }

/// CIE lightness, 0 to 100, which counts how different greys look.
double lightness(Rgb color) {
  const double y = 1.05 / contrast(color, {0xffffff}) - 0.05;
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

/// Letters are 20 px of 720 or more: what WCAG calls large asks for 3:1. The letters of the current row are
/// bold where they have changed, and lie on a tint: 2.5:1. Marks 2:1. Black on white has 5.7:1 there, and 7:1
/// becomes 3:1.
TEST(Theme, ReadsHalfWayToTheMiddle) {
  for (const Theme& theme : themes()) {
    SCOPED_TRACE(theme.name);
    const auto expect = [&](Rgb a, Rgb ground, double least) {
      EXPECT_GE(faded_contrast(a, ground, theme), least) << std::hex << a.hex << " on " << ground.hex;
    };
    const Rgb paper = theme[Tone::paper];
    for (const Tone ground : {Tone::paper, Tone::panel, Tone::header, Tone::weak, Tone::strong}) {
      const bool plain = ground == Tone::paper || ground == Tone::panel;
      expect(theme[Tone::ink], theme[ground], 3);
      for (const Rgb quantity : theme.quantity) expect(quantity, theme[ground], plain ? 3 : 2.5);
      if (plain) expect(theme[Tone::muted], theme[ground], 3);
    }
    expect(theme[Tone::accent], paper, 2);
    for (const Role role : all_roles) {
      expect(theme[role].text, paper, 3);
      expect(theme[role].mark, paper, 2);
    }
  }
}

// --- Legends ---------------------------------------------------------------------------------------------

/// What is left of a mark without colour: its form, dashes, hatching, and as a grey how light it is.
struct WithoutColour {
  std::string form;
  double light = 0;
  double width = 0;  ///< of a line
};

WithoutColour look_of(const Shape& shape, const Theme& theme) {
  const auto light = [&](Paint paint) { return lightness(faded(color_of(paint, theme), theme)); };
  if (const auto* line = std::get_if<LineShape>(&shape.what)) {
    const std::string_view form = line->closed ? "outline" : line->arrow ? "arrow" : "line";
    return {fmt::format("{} {}", form, line->dashed), light(line->stroke), line->width};
  }
  if (const auto* disc = std::get_if<DiscShape>(&shape.what)) {
    const bool ring = disc->fill == Paint::of(Tone::paper);
    return {ring ? "ring" : "dot", light(ring ? disc->stroke : disc->fill)};
  }
  const auto hatched = [&](const auto& ground, std::string_view name) {
    return fmt::format("{} {} {}", name, static_cast<int>(ground.hatch),
                       ground.hatch == Hatch::none ? 0 : ground.hatch_gap);
  };
  if (const auto* area = std::get_if<AreaShape>(&shape.what)) {
    const AreaShape shown = shown_in(theme, *area);
    return {hatched(shown, "area"), light(shown.fill)};
  }
  if (const auto* rect = std::get_if<RectShape>(&shape.what)) {
    const RectShape shown = shown_in(theme, *rect, 1);
    const bool filled = shown.fill.part != Paint::Part::none;
    return {fmt::format("{} {}", hatched(shown, "cell"), shown.dashed),
            light(filled ? shown.fill : shown.stroke), shown.stroke_width};
  }
  return {"picture", 0};
}

/// By a step of the scale of line widths, 3, 4, 5.
bool heavier(double a, double b) { return a != b && std::max(a, b) >= 1.25 * std::min(a, b) - 1e-9; }

bool differ(const std::vector<WithoutColour>& a, const std::vector<WithoutColour>& b) {
  if (a.size() != b.size()) return true;
  // Dots and rings have their names beside them in the drawing
  if (a.size() == 1 && (a[0].form == "dot" || a[0].form == "ring")) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].form != b[i].form || heavier(a[i].width, b[i].width) || std::abs(a[i].light - b[i].light) >= 5)
      return true;
  }
  return false;
}

TEST(Theme, LegendEntriesStayApartWithoutColour) {
  std::size_t pairs = 0;
  std::set<std::string> alike;
  test::for_each_sheet(
      [&](const Trace& trace, const Sheet& sheet, std::size_t) {
        for (const Theme& theme : themes()) {
          std::map<std::string, std::vector<WithoutColour>> entries;
          for (const Shape& shape : sheet.shapes) {
            if (shape.slot == Slot::footer && shape.id.starts_with("legend ") &&
                !shape.id.starts_with("legend text"))
              entries[shape.id].push_back(look_of(shape, theme));
          }
          for (auto one = entries.begin(); one != entries.end(); ++one) {
            for (auto other = std::next(one); other != entries.end(); ++other) {
              ++pairs;
              if (!differ(one->second, other->second))
                alike.insert(fmt::format("{} {} {}: {}, {}", theme.name, trace.topic, trace.method,
                                         one->first, other->first));
            }
          }
        }
      },
      {}, 6);
  EXPECT_GT(pairs, test::thinned(1000, 5));
  for (const std::string& pair : alike) ADD_FAILURE() << pair;
}

// --- Print -----------------------------------------------------------------------------------------------

TEST(Theme, PrintHasNoTints) {
  const Theme* print = find_theme("print");
  ASSERT_NE(print, nullptr);
  const auto is_pure = [&](Paint paint) {
    const Rgb color = color_of(paint, *print);
    return paint.part == Paint::Part::none || color == Rgb{0} || color == Rgb{0xffffff};
  };
  std::size_t hatched = 0;
  test::for_each_sheet(
      [&](const Trace& trace, const Sheet& sheet, std::size_t) {
        for (const Shape& shape : sheet.shapes) {
          if (const auto* rect = std::get_if<RectShape>(&shape.what)) {
            EXPECT_TRUE(is_pure(rect->fill)) << trace.topic << " " << shape.id;
            if (shown_in(*print, *rect, 1).hatch != Hatch::none) ++hatched;
          } else if (const auto* area = std::get_if<AreaShape>(&shape.what)) {
            EXPECT_TRUE(is_pure(area->fill)) << trace.topic << " " << shape.id;
            if (shown_in(*print, *area).hatch != Hatch::none) ++hatched;
          }
        }
      },
      {}, 6);
  EXPECT_GT(hatched, 100u);
}

TEST(Theme, OnlyPrintChangesShapes) {
  const AreaShape area{{{{0, 0}, {9, 0}, {9, 9}}}, Paint::fill(Role::measure), Hatch::none, {}};
  const RectShape row{{0, 0, 9, 9}, Paint::of(Tone::strong), {}, 0, 0, false, Hatch::none, {}};
  for (const Theme& theme : themes()) {
    SCOPED_TRACE(theme.name);
    const bool is_print = theme.name == "print";
    EXPECT_EQ(theme.hatched, is_print);
    EXPECT_EQ(shown_in(theme, area).hatch != Hatch::none, is_print);
    EXPECT_EQ(shown_in(theme, row, 1).stroke_width > 0, is_print) << "a frame round the current row";
  }
}

}  // namespace
}  // namespace gradus
