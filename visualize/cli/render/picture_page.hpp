#pragma once
// `gradus render SCENE -o picture.html`: the picture as a page that tells of each of its pixels.

#include <algorithm>
#include <cstdint>
#include <functional>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/render.hpp"
#include "cli/files/files.hpp"

namespace gradus::cli {

/// How many pixels the picture in such a page may have where so many lamps are told of at each: the page then
/// has some 40 MB at most.
constexpr std::int64_t most_page_pixels(std::int64_t lamps) {
  return std::min<std::int64_t>(1 << 19, (1 << 21) / (lamps + 2));
}

/// Whether an output is such a page by its name.
bool is_page(const std::string& output);

/// Writes the page. find, on_read: as for rendered(). Throws UsageError, InputError and WorkError.
void write_picture_page(const Request& request, const Output& output, const FindFile& find,
                        const std::function<void(const RenderBrief&)>& on_read);

}  // namespace gradus::cli
