#pragma once
// Sheets as files' bytes. The same sheet, finish and colophon give the same bytes, in any process and thread.
// Every function throws std::runtime_error when Cairo reports a failure, or the DejaVu fonts are missing.

#include <functional>
#include <string>

#include "figure/colophon.hpp"
#include "figure/sheet.hpp"
#include "theme/finish.hpp"

namespace gradus {

std::string svg_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon);
std::string png_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon);
/// One page a sheet; page(i) is asked for when its turn comes, so that no more than one is held at a time.
std::string pdf_of(std::size_t pages, const std::function<Sheet(std::size_t)>& page, const Finish& finish,
                   const Colophon& colophon);

/// The width in pixels that Cairo draws a text with: what the layout's own table must agree with.
double drawn_width(const std::string& text, Face face, double size);

/// What a file made by the functions above, or a player page, says of itself; nothing when it says nothing.
std::optional<Colophon> colophon_in(std::string_view file_bytes);

}  // namespace gradus
