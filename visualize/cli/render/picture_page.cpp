// `gradus render SCENE -o picture.html`: the picture as a page that tells of each of its pixels.

#include "cli/render/picture_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "cairo/image_file.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/terminal/progress.hpp"
#include "pipeline.hpp"
#include "request/names.hpp"
#include "web/picture_page.hpp"
#include "web/text_pack.hpp"
#include "why/why.hpp"
#include "why/why_text.hpp"

namespace gradus::cli {
namespace {

/// What would make of the page something else than the picture of a scene on its ground.
void refuse_beside_page(const Request& request) {
  for (const auto& [flag, spelled] : {std::pair{"report", "--report"}, {"part", "--part"}}) {
    if (request.has(flag))
      throw UsageError(fmt::format(
          "{0}: expected a .png, for a page shows all of the picture alone, found a .html", spelled));
  }
  const auto ground = request.flags.find("background");
  if (ground != request.flags.end() && folded(ground->second) == "none")
    throw UsageError("--background: expected a colour, for a page tells it of pixels, found 'none'");
}

/// The largest picture of this shape with so many pixels.
std::string size_within(const pipeline::Size& size, std::int64_t pixels) {
  const double shrink =
      std::sqrt(static_cast<double>(pixels) / (static_cast<double>(size.width) * size.height));
  const auto side = [&](int pixels_now) { return std::max(1, static_cast<int>(shrink * pixels_now)); };
  return fmt::format("{}x{}", side(size.width), side(size.height));
}

void check_size(const RenderJob& job) {
  const auto [width, height] = job.size;
  const std::int64_t pixels = std::int64_t{width} * height, lamps = pipeline::lamps_told(job.scene);
  const std::int64_t most = most_page_pixels(lamps);
  if (pixels <= most) return;
  throw UsageError(
      fmt::format("--size: expected at most {} pixels in a page that tells of {}, like {}, found {}x{}", most,
                  counted(lamps, "lamp"), size_within(job.size, most), width, height));
}

/// A part of a story of the pixel as the page packs it.
PartedText parted(const std::vector<pipeline::StoryPart>& story) {
  PartedText parts;
  for (const auto& [text, of_triangle] : story) parts.push_back({text, of_triangle});
  return parts;
}

PicturePage page_of(const RenderJob& job) {
  constexpr double start = 0.2;  // the picture's share of the work
  const auto [width, height] = job.size;
  const std::string name = scene_name(job.brief);
  pipeline::PixelStories stories(job.scene, job.size, pipeline::picture_window(job.size),
                                 [](double share) { Working::reached(start * share); });
  PicturePage page{
      job.brief.colophon, png_of(stories.picture(), job.brief.colophon), width, height, {}, {}, {}};
  pipeline::TriangleTexts known;
  TextPack pack;
  for (int y = 0; y < height; ++y) {
    Working::reached(start + (1 - start) * y / height);
    std::vector<PartedText> row;
    for (int x = 0; x < width; ++x)
      row.push_back(parted(why_parts(name, job.scene, job.size, stories.of({x, y}), known)));
    page.rows.push_back(pack.block(row));
  }
  Working::reached(0);  // what comes is no part of it
  page.shared = pack.shared_blocks();
  page.forms = pack.forms();
  return page;
}

}  // namespace

bool is_page(const std::string& output) {
  return folded(std::filesystem::path(output).extension().string()) == ".html";
}

void write_picture_page(const Request& request, const Output& output, const FindFile& find,
                        const std::function<void(const RenderBrief&)>& on_read) {
  refuse_beside_page(request);
  const RenderJob job = render_job(request, find);
  check_size(job);
  on_read(job.brief);
  if (!output.quiet)
    for (const std::string& remark : job.brief.remarks) note(remark);
  write_output(output.path, picture_page(page_of(job)), output.replace);
  if (!output.quiet) note(shown_name(output.path));
}

}  // namespace gradus::cli
