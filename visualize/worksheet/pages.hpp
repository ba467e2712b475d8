#pragma once
// Worksheets and their keys as pages for print, a page per task.

#include <string>

#include "figure/handout.hpp"
#include "figure/sheet.hpp"
#include "worksheet/task.hpp"

namespace gradus::worksheet {

/// A sheet to be filled in, or the same with all that belongs there.
enum class Part { sheet, key };

struct PageStyle {
  Paper paper = papers().front();
  Reckoning reckoning = Reckoning::by_hand;
  bool drawing = true;
};

/// Of a row of the table to be filled in by hand, CSS pixels: 8 mm.
inline constexpr double blank_height = 8 / 25.4 * 96;

/// A task of a student on a page of its own: name and points, the idea and the input, the table with blanks,
/// the drawing as it is before the first step (in a key: after the last). `footer`: at the page's foot, at
/// the left; at the right stands which page of how many it is. Letters are no smaller than 7 pt.
Sheet page_of(const StudentSheet& sheet, std::size_t task, Part part, const PageStyle& style,
              const std::string& footer, std::size_t page, std::size_t pages);

/// The drawing alone on a sheet of this size, CSS pixels.
Sheet drawing_of(const Task& task, Part part, double width, double height);

}  // namespace gradus::worksheet
