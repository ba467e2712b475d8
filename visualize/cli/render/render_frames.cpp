#include "cli/render/render_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>

#include "cairo/image_file.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/commands/explain.hpp"
#include "cli/files/files.hpp"
#include "cli/files/leftovers.hpp"
#include "cli/film/film.hpp"
#include "cli/film/frames_ahead.hpp"
#include "cli/render/render_shot.hpp"
#include "cli/terminal/progress.hpp"
#include "plan/unchanged.hpp"
#include "request/names.hpp"
#include "scene/camera/framing.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

std::string output_of(const Request& request) { return request.flags.at("output"); }
bool is_film_name(const std::string& output) {
  return folded(fs::path(output).extension().string()) == ".mp4";
}
bool has_mark(const std::string& output) { return output.find(frame_mark) != std::string::npos; }

/// Frames that were asked for, how each is seen, and whose picture it has.
struct Run {
  Shot shot;
  FrameRange range;
  std::vector<int> frames;
  std::vector<pipeline::View> views;
  std::vector<std::size_t> pictures;  ///< of each frame the place in the list of the one that is drawn for it

  std::size_t size() const { return frames.size(); }
  Colophon colophon(std::size_t i) const {
    return colophon_of(shot, FrameRange{frames[i], frames[i]}, *views[i].eye);
  }
};

Run run_of(const Request& request) {
  const ArrayPart part = read_array(request.flags);
  Run run{read_shot(request, as_named), {}, {}, {}, {}};
  const Wish& wish = run.shot.wish;
  if (!wish.path)
    refuse_flag("frames", "a scene whose camera has a path", shown(run.shot.name) + " without one");
  run.range = wish.frames.value_or(FrameRange{wish.path->first, wish.path->last});
  run.frames = frames_of(run.range, part);
  for (const int frame : run.frames) run.views.push_back(view_of_frame(run.shot, frame));
  run.pictures = pipeline::pictures_of(run.views);
  if (!wish.plan.rules.has(pipeline::Rule::unchanged))
    for (std::size_t i = 0; i < run.size(); ++i) run.pictures[i] = i;
  return run;
}

// --- What is there already ---------------------------------------------------------------------------------

/// Whether a file is a whole PNG that says it was made just so, by this release.
bool is_made(const std::string& path, const Colophon& colophon) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;  // nobody waits for what a pipe may hold
  try {
    return is_png_of(read_input(path, "-o"), colophon);
  } catch (const std::exception&) {
    return false;  // unreadable, or a damaged one
  }
}

// --- Drawing -----------------------------------------------------------------------------------------------

/// Draws frames from any thread, and sums up what was done.
class Drawing {
 public:
  explicit Drawing(const Run& run) : run_(run), artist_(run.shot, 1) {
    sum_.reading = run.shot.reading, sum_.preparing = artist_.preparing();
  }

  /// frames: how many have this picture in this run.
  Image picture(std::size_t i, std::size_t frames) {
    pipeline::Scene scene = run_.shot.scene;
    scene.camera = camera_of(run_.shot, run_.views[i]);
    if (run_.shot.lights_go_along) scene.lights = pipeline::default_lights(scene.camera);
    pipeline::Ledger ledger;
    Picture picture = artist_.paint(scene, ledger);
    const std::lock_guard lock(mutex_);
    pipeline::add(ledger, sum_);
    for (std::size_t again = 1; again < frames; ++again) pipeline::add_unchanged(ledger, sum_);
    unchanged_ += frames - 1;
    if (picture.covered == 0) empty_ += frames;
    return std::move(picture.image);
  }

  /// The picture as the file of a frame.
  std::string png(const Image& image, std::size_t i) {
    double seconds = 0;
    std::string bytes =
        pipeline::timed(seconds_now, seconds, [&] { return png_of(image, run_.colophon(i)); });
    const std::lock_guard lock(mutex_);
    sum_.encoding += seconds;
    return bytes;
  }

  /// What the user should know of the frames that were drawn.
  void tell() const {
    if (empty_ > 0)
      note(fmt::format("render: {} show the background alone",
                       counted(static_cast<std::int64_t>(empty_), "frame")));
  }
  void report(std::size_t drawn) const {
    const std::string name = fmt::format(
        "{}, {}{}", scene_name(run_.shot.brief), counted(static_cast<std::int64_t>(drawn), "frame"),
        unchanged_ > 0 ? fmt::format(" of which {} unchanged", unchanged_) : "");
    write_stream(Stream::out, ledger_text(name, sum_, artist_.drawn_by()));
  }

 private:
  const Run& run_;
  ShotArtist artist_;
  std::mutex mutex_{};
  pipeline::Ledger sum_{};
  std::size_t unchanged_ = 0, empty_ = 0;
};

/// Frames with one picture, in the order of the run.
using Alike = std::vector<std::size_t>;

std::vector<Alike> grouped(const Run& run, const std::vector<std::size_t>& frames) {
  std::vector<Alike> groups;
  for (const std::size_t i : frames) {
    if (groups.empty() || run.pictures[groups.back().front()] != run.pictures[i]) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

// --- A file per frame --------------------------------------------------------------------------------------

void check_name(const std::string& output) {
  const fs::path path(output);
  const bool as_it_should = has_mark(path.filename().string()) && folded(path.extension().string()) == ".png";
  if (as_it_should && !has_mark(path.parent_path().string())) return;
  throw UsageError(
      fmt::format("-o: expected a file per frame like f-{}.png, or a film like film.mp4, found {}",
                  frame_mark, shown(output)));
}

/// Refuses what stands in the way before anything is drawn. Returns the frames that are to be drawn.
std::vector<std::size_t> missing_frames(const Run& run, const std::vector<std::string>& paths,
                                        Replace replace, std::size_t threads) {
  std::vector<char> made(run.size(), 0);
  if (replace == Replace::own)  // else all anew
    in_parallel(run.size(), threads, [&](std::size_t i) { made[i] = is_made(paths[i], run.colophon(i)); });
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (made[i]) continue;
    check_output(paths[i], run.shot.brief.files, replace);
    missing.push_back(i);
  }
  return missing;
}

int frame_files(const Request& request, const Run& run) {
  const std::string output = output_of(request);
  const Replace replace = replaces(request.has("force"));
  const std::size_t threads = read_jobs(request);
  std::vector<std::string> paths;
  for (const int frame : run.frames) paths.push_back(frame_name(output, frame, *run.shot.wish.path));
  if (const fs::path folder = fs::path(output).parent_path(); !folder.empty())
    make_folder(folder.string(), "-o");
  const std::vector<std::size_t> missing = missing_frames(run, paths, replace, threads);
  remove_leftovers(output.substr(0, output.find_last_of('/') + 1));
  const std::vector<Alike> groups = grouped(run, missing);
  Drawing drawing(run);
  {
    Progress progress(missing.size(), request.quiet());
    in_parallel(groups.size(), threads, [&](std::size_t g) {
      const Image image = drawing.picture(groups[g].front(), groups[g].size());
      for (const std::size_t i : groups[g]) {
        write_output(paths[i], drawing.png(image, i), replace);
        progress.finished(static_cast<std::size_t>(std::ranges::lower_bound(missing, i) - missing.begin()),
                          "");
      }
    });
  }
  if (request.has("report")) drawing.report(missing.size());
  if (request.quiet()) return 0;
  drawing.tell();
  const std::size_t there = run.size() - missing.size();
  note(fmt::format("{}: {}{}", shown_name(output), counted(static_cast<std::int64_t>(run.size()), "frame"),
                   there > 0 ? fmt::format(", {} of them there already", there) : ""));
  return 0;
}

// --- A film ------------------------------------------------------------------------------------------------

int film_file(const Request& request, const Run& run) {
  const std::string output = output_of(request);
  const Replace replace = replaces(request.has("force"));
  if (request.has("array"))
    refuse_flag("array", "a file per frame, of which a part can be made", shown(output));
  check_output(output, run.shot.brief.files, replace);
  std::vector<std::size_t> all(run.size()), group_of(run.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const std::vector<Alike> groups = grouped(run, all);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t i : groups[g]) group_of[i] = g;
  Drawing drawing(run);
  std::string bytes;
  {
    Progress progress(groups.size(), request.quiet());
    FramesAhead<Image> ahead(groups.size(), read_jobs(request), [&](std::size_t g) {
      Image image = drawing.picture(groups[g].front(), groups[g].size());
      progress.finished(g, "");
      return image;
    });
    FilmOptions options;
    options.seconds_per_step = options.hold_last = 1.0 / options.fps;
    options.transition = 0;
    bytes = film_bytes(
        FilmFormat::mp4, run.size(), [&](std::size_t i) { return ahead.at(group_of[i]); }, options,
        colophon_of(run.shot, run.range, *run.views.front().eye));
  }
  write_output(output, bytes, replace);
  if (request.has("report")) drawing.report(run.size());
  if (request.quiet()) return 0;
  drawing.tell();
  note(fmt::format("{}: {}", shown_name(output), counted(static_cast<std::int64_t>(run.size()), "frame")));
  return 0;
}

}  // namespace

bool asks_for_frames(const Request& request) {
  const std::string output = output_of(request);
  const auto frames = read_frames(request.flags);
  if (has_mark(output) || is_film_name(output) || request.has("array") || (frames && !frames->is_one()))
    return true;
  if (request.has("jobs")) refuse_flag("jobs", "several frames", "one picture");
  return false;
}

int render_frames(const Request& request) {
  const std::string output = output_of(request);
  if (!is_film_name(output) || has_mark(output)) check_name(output);
  const Run run = run_of(request);
  if (!request.quiet())
    for (const std::string& remark : run.shot.brief.remarks) note(remark);
  if (run.frames.empty()) {  // a part of fewer frames than there are parts
    if (!request.quiet()) note(fmt::format("{}: no frame in this part", shown_name(output)));
    return 0;
  }
  return is_film_name(output) ? film_file(request, run) : frame_files(request, run);
}

}  // namespace gradus::cli
