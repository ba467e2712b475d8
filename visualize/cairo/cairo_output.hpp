#pragma once
// Sheets as files' bytes. The same sheet, finish and colophon give the same bytes, in any process and thread.
// Every function throws std::runtime_error when Cairo reports a failure, or its fonts are missing.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/image.hpp"
#include "figure/colophon.hpp"
#include "figure/sheet.hpp"
#include "theme/finish.hpp"

namespace gradus {

/// For slides, style sheets and reveals, the file is grouped by what things are:
///
///     <rect id="paper" class="tone-paper">         the ground; absent when transparent
///     <g id="drawing" class="slot-drawing">        a slot: title, drawing, listing, table, sentence, footer
///       <g id="drawing-current" class="role-current">  in it what has one role (see Role) …
///       <g id="drawing-rule" class="tone-rule">        … or belongs to the furniture (see Tone)
///         <rect data-id="cell 3,2">                the figure's name of a shape or text, once per part
///
/// Groups don't change the drawing order: one that is interrupted goes on as drawing-current-2, -3, …, so an
/// id names one stretch and a class all. `.slot-drawing .role-current { visibility: hidden }` hides the
/// current mark, `#sentence` is the sentence. Letters are shapes in <defs>, or with SvgText::text <text>
/// elements with fonts of their own.
std::string svg_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon);

/// The pixels of a sheet, drawn at `finish.scale`: opaque, or with alpha where no ground is painted.
/// Throws std::runtime_error when a side is no pixel or more than `longest_side`.
Image image_of(const Sheet& sheet, const Finish& finish);
inline constexpr int longest_side = 32767;  ///< Cairo's limit

std::string png_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon);

/// One page of its own size per sheet; page(i) is asked for when its turn comes, so that no more than one is
/// held at a time.
std::string pdf_of(std::size_t pages, const std::function<Sheet(std::size_t)>& page, const Finish& finish,
                   const Colophon& colophon);

/// The first character of a text in any script, in UTF-8, that no installed font has; nothing when all can be
/// drawn.
std::optional<char32_t> character_without_font(std::string_view text);

/// The versions of Cairo and of Pango, which draws such texts, that this was compiled with: to ask them
/// themselves would be to load them.
std::string_view cairo_version();
std::string_view pango_version();

}  // namespace gradus
