#pragma once
// From role to look: the only place that knows colours.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "figure/role.hpp"
#include "figure/sheet.hpp"

namespace gradus {

/// An opaque sRGB colour, 0xrrggbb.
struct Rgb {
  std::uint32_t hex = 0;
  double red() const { return ((hex >> 16) & 255) / 255.0; }
  double green() const { return ((hex >> 8) & 255) / 255.0; }
  double blue() const { return (hex & 255) / 255.0; }
  friend bool operator==(Rgb, Rgb) = default;
};

/// A role's colours. (Its second channel, dash or hatch, is the same in every theme: see Channel.)
struct RoleLook {
  Rgb mark;  ///< outlines, dots, lines: at least 3:1 on the paper
  Rgb fill;  ///< the ground of a cell
  Rgb text;  ///< labels: at least 4.5:1 on the paper
};

struct Theme {
  std::string name;
  std::array<Rgb, 9> tone;                      ///< by Tone
  std::array<RoleLook, all_roles.size()> role;  ///< by Role
  /// Of the texts of quantities, in this order: at least 4.5:1 on every ground that texts stand on.
  std::array<Rgb, quantity_colors> quantity;
  bool quantities_underlined = false;  ///< where colours do not tell them apart
  bool hatched = false;  ///< grounds are hatched, not tinted: a printer makes dots of light grey
  bool grey = false;     ///< pictures lose their colours, too
  Rgb operator[](Tone t) const { return tone[static_cast<std::size_t>(t)]; }
  const RoleLook& operator[](Role r) const { return role[static_cast<std::size_t>(r)]; }
};

/// light (the default), dark, greyscale, high_contrast, print.
std::span<const Theme> themes();
/// The theme of that name, or nullptr.
const Theme* find_theme(std::string_view name);

/// A hatching, and the distance of its lines in units.
struct HatchLook {
  Hatch hatch = Hatch::none;
  double gap = 10;
};
/// What lies over a ground in a theme: the mark's own hatching, or, of a theme that hatches, its ground's.
HatchLook hatch_on(Paint ground, Hatch own, const Theme& theme);

/// What a paint looks like in a theme.
Rgb color_of(Paint paint, const Theme& theme);

/// The tone, ink or paper, that reads best on this ground.
Tone text_on(Rgb ground, const Theme& theme);

/// WCAG contrast of two colours, 1 to 21.
double contrast(Rgb a, Rgb b);

/// The theme on another ground. Panels and cells that had the old ground's colour get the new one.
Theme with_paper(Theme theme, Rgb paper);

/// What can't be read well enough, on the ground of the whole figure or of its cells.
struct LowContrast {
  std::string_view what;  ///< "texts", "marks"
  double least, found;    ///< contrast: 4.5 for texts, 3 for marks
};
/// The worst of what falls below its limit, or nothing.
std::optional<LowContrast> low_contrast(const Theme& theme);

}  // namespace gradus
