// `gradus render`: a picture of a model or a scene.

#include "cli/commands/render.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "cairo/image_file.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/commands/explain.hpp"
#include "cli/files/files.hpp"
#include "cli/render/picture_page.hpp"
#include "cli/render/render_frames.hpp"
#include "cli/render/render_shot.hpp"
#include "cli/render/why.hpp"
#include "cli/system/threads.hpp"
#include "cli/terminal/progress.hpp"
#include "plan/unchanged.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// Why there is nothing to be seen.
std::string empty_remark(const pipeline::Scene& scene) {
  return lies_behind(scene)
             ? "render: the whole model lies behind the eye: the picture shows the background alone"
             : "render: no pixel shows the model: the picture shows the background alone";
}

/// The shot of one picture.
Shot shot_of(const Request& request, const FindFile& find) {
  if (const auto frames = read_frames(request.flags); frames && !frames->is_one())
    refuse_flag("frames", "one frame like 17 for one picture", shown(text_of(*frames)));
  return read_shot(request, find);
}

/// The frames of the shot's path.
std::optional<PathFacts> path_facts(const Shot& shot) {
  const Wish& wish = shot.wish;
  if (!wish.path) return std::nullopt;
  PathFacts facts{wish.path->first, wish.path->last,
                  wish.frames.value_or(FrameRange{wish.path->first}).first};
  if (!wish.plan.rules.has(pipeline::Rule::unchanged)) return facts;
  for (int frame = facts.first + 1; frame <= facts.last; ++frame) {
    if (same_view(view_at(*wish.path, wish.view, frame - 1), view_at(*wish.path, wish.view, frame)))
      facts.unchanged.push_back(frame);
  }
  return facts;
}

}  // namespace

RenderBrief render_brief(const Request& request, const FindFile& find) {
  return shot_of(request, find).brief;
}

std::string scene_name(const RenderBrief& brief) {
  const std::string& file = brief.files.front();
  return file == dash ? "standard input" : fs::path(file).filename().string();
}

RenderJob render_job(const Request& request, const FindFile& find) {
  Shot shot = shot_of(request, find);
  const auto path = path_facts(shot);
  return {std::move(shot.scene), shot.wish.size, std::move(shot.wish.plan), std::move(shot.brief), path};
}

Rendered rendered(const Request& request, const FindFile& find,
                  const std::function<void(const RenderBrief&)>& on_read) {
  Shot shot = shot_of(request, find);
  if (on_read) on_read(shot.brief);
  Rendered result{std::move(shot.brief), "", {}};
  const ShotArtist artist(shot, usable_cores());
  const Picture picture = artist.paint(shot.scene, result.ledger, Working::reached);
  result.drawn_by = artist.drawn_by();
  Working::reached(0);  // what comes is no part of it
  if (picture.covered == 0) result.remarks.push_back(empty_remark(shot.scene));
  pipeline::Ledger& ledger = result.ledger;
  ledger.reading = shot.reading, ledger.preparing = artist.preparing();
  result.png =
      pipeline::timed(seconds_now, ledger.encoding, [&] { return png_of(picture.image, result.colophon); });
  return result;
}

void check_rendered_output(const Request& request, const std::string& output) {
  check_output(output, {}, Replace::anything);
  if (request.has("why")) return check_why_output(output);
  if (output == dash && is_terminal(Stream::out)) {
    throw UsageError("-o: expected a file or a pipe for png, found a terminal");
  }
  if (output != dash && !is_page(output) && folded(fs::path(output).extension().string()) != ".png")
    throw UsageError(fmt::format("-o: expected a name that ends in .png or .html, found {}", shown(output)));
}

void make_rendered(const Request& request, const Output& output, const FindFile& find,
                   const std::function<void(const RenderBrief&)>& on_read) {
  if (request.has("why")) return draw_why(request, output, find, on_read);
  if (is_page(output.path)) return write_picture_page(request, output, find, on_read);
  const Rendered picture = rendered(request, find, on_read);
  write_output(output.path, picture.png, output.replace);
  if (!output.quiet) {
    for (const std::string& remark : picture.remarks) note(remark);
    if (output.path != dash) note(shown_name(output.path));
  }
  if (!request.has("report")) return;
  const Stream stream = output.path == dash ? Stream::err : Stream::out;
  write_stream(stream, ledger_text(scene_name(picture), picture.ledger, picture.drawn_by));
}

int render(const Request& request) {
  const auto wanted = request.flags.find("output");
  if (wanted == request.flags.end()) {
    if (request.has("why")) {
      print_why(request);
      return 0;
    }
    throw UsageError("-o: expected a file like model.png, or - for standard output, found none");
  }
  if (asks_for_frames(request)) return render_frames(request);
  const Output output{wanted->second, replaces(request.has("force")), request.quiet()};
  check_rendered_output(request, output.path);
  make_rendered(request, output, as_named, [&output](const RenderBrief& brief) {
    check_output(output.path, brief.files, output.replace);
  });
  return 0;
}

}  // namespace gradus::cli
