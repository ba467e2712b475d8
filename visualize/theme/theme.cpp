#include "theme/theme.hpp"

#include <algorithm>
#include <cmath>

namespace gradus {
namespace {

// Marks are Okabe and Ito's colours (2002), darkened on light grounds until they reach 3:1.
// Order of tones: paper panel header weak strong rule ink muted accent.
// Order of roles: input boundary past current candidate accepted rejected result measure guide.
// A projector in a bright room halves the contrast: texts have 6:1 and marks 4:1, so that 3:1 and 2:1 are
// left. Drawn half way to the middle of paper and ink, texts keep 3:1, too: that asks for about 7:1.
const std::array<Theme, 5> all_themes{{
    {"light",
     {{{0xffffff},
       {0xf6f8fa},
       {0xe4e9ee},
       {0xe4e9ee},
       {0xcfe6f5},
       {0xd0d7de},
       {0x1b1f24},
       {0x404953},
       {0x0072b2}}},
     {{
         {{0x1b1f24}, {0xffffff}, {0x1b1f24}},
         {{0x1b1f24}, {0x59636e}, {0x1b1f24}},
         {{0x6f7c89}, {0xe8eef4}, {0x404953}},
         {{0x0072b2}, {0xcfe6f5}, {0x015787}},
         {{0xa8527f}, {0xf7e9f1}, {0x833760}},
         {{0x008a64}, {0xd2efe5}, {0x055d46}},
         {{0xac6f00}, {0xfff6e0}, {0x6c4907}},
         {{0x0072b2}, {0x9ccdeb}, {0x015787}},
         {{0xcd5a00}, {0xfbe3d3}, {0x863f08}},
         {{0x6f7c89}, {0xffffff}, {0x404953}},
     }},
     {{{0x7b2d5b}, {0x833801}, {0x00573b}, {0x004f7c}}},
     false},
    {"dark",
     {{{0x14181d},
       {0x1d2329},
       {0x2b343d},
       {0x2b343d},
       {0x12405e},
       {0x3c4650},
       {0xf0f3f6},
       {0xb8c2cb},
       {0x56b4e9}}},
     {{
         {{0xf0f3f6}, {0x14181d}, {0xf0f3f6}},
         {{0xf0f3f6}, {0x93a0ac}, {0xf0f3f6}},
         {{0x7d8a97}, {0x262e36}, {0xb8c2cb}},
         {{0x56b4e9}, {0x12405e}, {0x8fcdf3}},
         {{0xe08fbd}, {0x3a2131}, {0xeab0d0}},
         {{0x2cc998}, {0x0f3c2f}, {0x62dcb5}},
         {{0xe69f00}, {0x3a2c0a}, {0xf2bf4d}},
         {{0x56b4e9}, {0x1f6f9f}, {0x8fcdf3}},
         {{0xff8a3d}, {0x44240f}, {0xffa66b}},
         {{0x7d8a97}, {0x14181d}, {0xb8c2cb}},
     }},
     {{{0xeab2d1}, {0xffb27f}, {0x62dcb5}, {0x8fcdf3}}},
     false},
    {"greyscale",
     {{{0xffffff},
       {0xf5f5f5},
       {0xe6e6e6},
       {0xe6e6e6},
       {0xd2d2d2},
       {0xcfcfcf},
       {0x161616},
       {0x474747},
       {0x161616}}},
     {{
         {{0x161616}, {0xffffff}, {0x161616}},
         {{0x161616}, {0x4f4f4f}, {0x161616}},
         {{0x7c7c7c}, {0xececec}, {0x474747}},
         {{0x161616}, {0xd2d2d2}, {0x161616}},
         {{0x5a5a5a}, {0xffffff}, {0x3c3c3c}},
         {{0x333333}, {0xe0e0e0}, {0x333333}},
         {{0x5a5a5a}, {0xf7f7f7}, {0x3c3c3c}},
         {{0x333333}, {0xb8b8b8}, {0x333333}},
         {{0x161616}, {0xe6e6e6}, {0x161616}},
         {{0x7c7c7c}, {0xffffff}, {0x474747}},
     }},
     {{{0x161616}, {0x161616}, {0x161616}, {0x161616}}},
     true,
     false,
     true},
    {"high_contrast",
     {{{0xffffff},
       {0xffffff},
       {0xe8e8e8},
       {0xe8e8e8},
       {0xffe94d},
       {0x767676},
       {0x000000},
       {0x222222},
       {0x000000}}},
     {{
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0x000000}, {0x000000}},
         {{0x555555}, {0xe0e0e0}, {0x222222}},
         {{0x000000}, {0xffe94d}, {0x000000}},
         {{0x7a0050}, {0xffffff}, {0x7a0050}},
         {{0x00573b}, {0xc8f2e2}, {0x00573b}},
         {{0x8a3c00}, {0xffffff}, {0x8a3c00}},
         {{0x000000}, {0x8fd0ff}, {0x000000}},
         {{0xb30000}, {0xffffff}, {0xb30000}},
         {{0x555555}, {0xffffff}, {0x222222}},
     }},
     {{{0x7a0050}, {0x8a3c00}, {0x00573b}, {0x00308f}}},
     false},
    {"print",
     {{{0xffffff},
       {0xffffff},
       {0xffffff},
       {0xffffff},
       {0xffffff},
       {0x767676},
       {0x000000},
       {0x000000},
       {0x000000}}},
     {{
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0x000000}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
         {{0x000000}, {0xffffff}, {0x000000}},
     }},
     {{{0x000000}, {0x000000}, {0x000000}, {0x000000}}},
     true,
     true},
}};

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(Rgb c) {
  return 0.2126 * linear(c.red()) + 0.7152 * linear(c.green()) + 0.0722 * linear(c.blue());
}

/// `share` of the second in the first.
Rgb mixed(Rgb a, Rgb b, double share) {
  const auto channel = [&](int shift) {
    const double from = (a.hex >> shift) & 255, to = (b.hex >> shift) & 255;
    return static_cast<std::uint32_t>(std::lround(from + share * (to - from))) << shift;
  };
  return {channel(16) | channel(8) | channel(0)};
}

/// What limits is glass in the accent's colour, so that it never looks like a solid in the same ink.
Rgb tint_of(Role role, int shade, const Theme& theme) {
  if (theme.hatched) return theme[Tone::paper];
  constexpr std::array<double, 3> shares{0.05, 0.09, 0.15};
  const Rgb mark = role == Role::boundary ? theme[Tone::accent] : theme[role].mark;
  return mixed(theme[Tone::paper], mark, shares[static_cast<std::size_t>(std::clamp(shade, 1, 3) - 1)]);
}

}  // namespace

std::span<const Theme> themes() { return all_themes; }

const Theme* find_theme(std::string_view name) {
  const auto found = std::ranges::find(all_themes, name, &Theme::name);
  return found == all_themes.end() ? nullptr : &*found;
}

double contrast(Rgb a, Rgb b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

Tone text_on(Rgb ground, const Theme& theme) {
  return contrast(theme[Tone::ink], ground) >= contrast(theme[Tone::paper], ground) ? Tone::ink : Tone::paper;
}

Theme with_paper(Theme theme, Rgb paper) {
  const Rgb old = theme[Tone::paper];
  std::ranges::replace(theme.tone, old, paper);
  for (RoleLook& look : theme.role) {
    if (look.fill == old) look.fill = paper;
  }
  return theme;
}

std::optional<LowContrast> low_contrast(const Theme& theme) {
  std::optional<LowContrast> worst;
  const auto compare = [&worst](std::string_view what, double least, Rgb a, Rgb b) {
    const double found = contrast(a, b);
    if (found >= least || (worst && found / least >= worst->found / worst->least)) return;
    worst = {what, least, found};
  };
  const Rgb paper = theme[Tone::paper];
  for (const Tone ground : {Tone::paper, Tone::panel, Tone::header, Tone::weak, Tone::strong}) {
    compare("texts", 4.5, theme[Tone::ink], theme[ground]);
  }
  for (const Tone ground : {Tone::paper, Tone::panel})
    compare("texts", 4.5, theme[Tone::muted], theme[ground]);
  for (const Rgb quantity : theme.quantity) {
    for (const Tone ground : {Tone::paper, Tone::panel, Tone::header, Tone::weak, Tone::strong})
      compare("texts", 4.5, quantity, theme[ground]);
  }
  compare("marks", 3, theme[Tone::accent], paper);
  for (const RoleLook& look : theme.role) {
    compare("texts", 4.5, look.text, paper);
    compare("texts", 4.5, theme[text_on(look.fill, theme)], look.fill);
    compare("marks", 3, look.mark, paper);
  }
  return worst;
}

HatchLook hatch_on(Paint ground, Hatch own, const Theme& theme) {
  if (!theme.hatched) return {own};
  if (ground.part == Paint::Part::role_tint) {  // glass, and faces from light to dark
    if (ground.role == Role::boundary) return {Hatch::falling, 14};
    constexpr std::array<HatchLook, 3> shades{{{Hatch::none}, {Hatch::rising, 12}, {Hatch::rising, 6}}};
    return shades[static_cast<std::size_t>(std::clamp(ground.shade, 1, 3) - 1)];
  }
  if (ground.part != Paint::Part::role_fill) return {own};
  switch (ground.role) {
    case Role::past:
      return {Hatch::rising, 14};
    case Role::current:
      return {Hatch::rising, 7};
    case Role::accepted:
      return {Hatch::falling, 10};
    case Role::result:
      return {Hatch::cross, 10};
    case Role::measure:
      return {Hatch::falling, 14};
    case Role::input:
    case Role::boundary:
    case Role::candidate:
    case Role::rejected:
      return {own, 20};
    case Role::guide:
      break;
  }
  return {};
}

Rgb color_of(Paint paint, const Theme& theme) {
  switch (paint.part) {
    case Paint::Part::role_mark:
      return theme[paint.role].mark;
    case Paint::Part::role_fill:
      return theme[paint.role].fill;
    case Paint::Part::role_text:
      return theme[paint.role].text;
    case Paint::Part::on_role:
      return theme[text_on(theme[paint.role].fill, theme)];
    case Paint::Part::quantity:
      return theme.quantity[static_cast<std::size_t>(paint.number)];
    case Paint::Part::role_tint:
      return tint_of(paint.role, paint.shade, theme);
    case Paint::Part::tone:
    case Paint::Part::none:
      break;
  }
  return theme[paint.tone];
}

}  // namespace gradus
