#include "cli/gallery/gallery.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <optional>

#include "cli/command_line/errors.hpp"
#include "cli/commands/figure.hpp"
#include "cli/files/files.hpp"
#include "cli/files/zip.hpp"
#include "cli/gallery/gallery_cards.hpp"
#include "cli/gallery/gallery_steps.hpp"
#include "request/fingerprint.hpp"
#include "stories/point_text.hpp"
#include "web/topic_page.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// A file to be written.
struct OutputFile {
  std::string name, bytes;
};

/// Steps in its zip, two pictures each, likewise.
constexpr std::int64_t most_zip_steps = 48;

/// The same figure with one flag set.
FigureSpec with_flag(FigureSpec spec, const std::string& flag, const std::string& value) {
  Request request;
  request.flags[flag] = value;
  apply_flags(spec, request);
  return spec;
}

// --- Files -------------------------------------------------------------------------------------------------

/// Collects the files of one figure or render under their names.
class Folder {
 public:
  Folder(const LecturePart& part, const fs::path& out, const ReplaceAt& replace)
      : part_(part), out_(out), replace_(replace) {
    std::error_code error;
    const fs::path folder = out / part.name;
    fs::create_directories(folder, error);
    if (error) {
      throw WorkError(fmt::format("can't make the folder {}: {}", shown(folder.string()), error.message()));
    }
  }
  /// A folder that stayed empty, because something failed, goes again.
  ~Folder() {
    std::error_code error;
    fs::remove(out_ / part_.name, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void add(const std::string& name, std::string_view bytes) {
    const std::string path = part_.name + "/" + name, full = (out_ / path).string();
    for (const std::string& input : part_.files) {
      if (!same_file(full, input)) continue;
      throw UsageError(fmt::format(
          "expected an output folder apart from the inputs, found the input file {} in it", shown(full)));
    }
    files_.add(full, bytes, replace_(path));
    paths_.push_back(path);
  }

  /// The inputs beside the figures, where `gradus again` looks for them. Of two with one name it finds the
  /// first, and says that it misses the other.
  void add_inputs() {
    for (const std::string& name : copied_names(part_)) {
      const auto path = std::ranges::find(part_.copies, name, base_of);
      add(name, read_input(*path, name));
    }
  }

  std::vector<ManifestFile> finish() {
    files_.commit();
    std::vector<ManifestFile> states;
    for (const std::string& path : paths_) states.push_back(file_state(out_, path));
    return states;
  }

 private:
  const LecturePart& part_;
  const fs::path& out_;
  const ReplaceAt& replace_;
  NewFiles files_;
  std::vector<std::string> paths_;
};

/// Pictures of a figure's steps, in one look. A step is laid out once for both its formats, and one that is
/// asked for again, for the zip, isn't drawn again.
class Pictures {
 public:
  explicit Pictures(Takes& takes) : takes_(takes) {}
  const std::string& bytes(const FigureSpec& figure, StepNumber step, Format format) {
    const FigureSpec spec = fitting(at_step(figure, step), format);
    const auto [picture, is_new] = drawn_.try_emplace({format, command_of(spec)});
    if (is_new) picture->second = picture_bytes(sheet(spec, step), spec, takes_, step, format);
    return picture->second;
  }

 private:
  const Sheet& sheet(const FigureSpec& spec, StepNumber step) {
    if (!sheet_ || sheet_->first != step) sheet_ = {step, sheet_of(spec, takes_, step)};
    return sheet_->second;
  }

  Takes& takes_;
  std::optional<std::pair<StepNumber, Sheet>> sheet_;
  std::map<std::pair<Format, std::string>, std::string> drawn_;  ///< by the commands that make them
};

/// SVG and PNG of each step, for taking them all.
std::string zip_bytes(const LectureFigure& figure, Takes& takes, Pictures& pictures) {
  const FigureSpec spec = paged(figure.spec, takes, most_zip_steps);
  const auto draw = [&](StepNumber step) {
    return StepPicture{pictures.bytes(spec, step, Format::svg), pictures.bytes(spec, step, Format::png)};
  };
  return zip_of(step_entries(figure.name, title_of(figure), short_command(figure), page_steps(spec, takes),
                             {takes.last(), 0}, draw));
}

// --- Renders -----------------------------------------------------------------------------------------------

/// The files have been found already.
Rendered rendered_again(const Request& request, const LectureRender& render) {
  return rendered(request, [&](const std::string&, const std::string&) {
    return FoundFile(render.files.front(), render.brief.quotable);
  });
}

/// The same picture, smaller.
Request thumbnail_of(const LectureRender& render) {
  const double factor = largest_thumbnail / 2.0 / std::max(render.brief.width, render.brief.height);
  const auto side = [factor](int pixels) { return std::max(1, static_cast<int>(pixels * factor)); };
  Request request = render.request;
  request.flags["size"] = fmt::format("{}x{}", side(render.brief.width), side(render.brief.height));
  return request;
}

}  // namespace

namespace {

/// The files of a figure in one format: the only place that knows which those are. Pictures show the most
/// telling step, "<stem>.svg"; of several chosen steps there is one file each, "<stem>-4.svg". A PDF has a
/// page per step; a player plays the stretch that the chosen steps span. Throws UsageError for steps that the
/// run has not.
std::vector<OutputFile> output_files(const FigureSpec& figure, Takes& takes, Pictures& pictures,
                                     Format format, const std::string& stem) {
  const FigureSpec spec = fitting(figure, format);
  const std::string ending = fmt::format(".{}", name_of(format));
  if (is_document(format)) {
    const FigureSpec pages = paged(spec, takes);
    const std::vector<StepNumber> steps = page_steps(pages, takes);
    return {{stem + ending,
             format == Format::pdf ? pages_bytes(pages, takes, steps) : slides_bytes(pages, takes, steps)}};
  }
  if (is_film(format)) {
    const FigureSpec shown = paged(spec, takes);
    return {{stem + ending, film_of(shown, takes, page_steps(shown, takes), format)}};
  }
  if (is_model(format)) return {{stem + ending, model_bytes(spec, takes.opening(), format)}};
  if (!is_picture(format)) {
    const FigureSpec text = told(spec, takes, format);
    const std::string page = topic_page_path(*spec.topic);
    return {{stem + ending, trace_bytes(text, shown_part(text, takes, format), format,
                                        page.empty() ? page : "../" + page, &takes)}};
  }
  std::vector<OutputFile> files;
  const std::vector<StepNumber> steps = picture_steps(spec, takes);
  for (const StepNumber step : steps) {
    const std::string number = steps.size() == 1 ? "" : "-" + text_of(step);
    files.push_back({stem + number + ending, pictures.bytes(figure, step, format)});
  }
  return files;
}

}  // namespace

std::string program_fingerprint() { return fingerprint(read_input("/proc/self/exe", "gradus")); }

void rehearse(const LectureFigure& figure) {
  const FigureSpec& spec = figure.spec;
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec));
  for (const Format format : figure.outputs) {
    if (is_film(format)) check_film(spec, format);
    if (is_document(format) || is_film(format)) {
      page_steps(paged(spec, takes), takes);
    } else if (is_model(format)) {
      model_bytes(spec, takes.opening(), format);
    } else if (!is_picture(format)) {
      shown_part(told(spec, takes, format), takes, format);
    }
  }
  sheet_of(spec, takes, thumbnail_step(spec, takes));
}

Drawn draw(const LectureFigure& figure, const fs::path& out, const ReplaceAt& replace) {
  const FigureSpec& spec = figure.spec;
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec));
  Pictures pictures(takes);
  Folder folder(figure, out, replace);
  for (const Format format : figure.outputs) {
    for (const OutputFile& file : output_files(spec, takes, pictures, format, figure.name)) {
      folder.add(file.name, file.bytes);
    }
  }
  const StepNumber telling = thumbnail_step(spec, takes);
  const FigureSpec thumbnail =
      fitting(with_flag(with_flag(at_step(spec, telling), "slots", "drawing"), "crop", "true"), Format::svg);
  folder.add(figure.name + "-drawing.svg", picture_bytes(thumbnail, takes, telling, Format::svg));
  if (has_zip(figure)) folder.add(figure.name + "-steps.zip", zip_bytes(figure, takes, pictures));
  folder.add_inputs();
  std::vector<ManifestFile> files = folder.finish();
  GalleryEntry entry = entry_of(figure, files, takes);
  return {std::move(files), figure.remarks, std::move(entry)};
}

void rehearse(const LectureRender&) {}

Drawn draw(const LectureRender& render, const fs::path& out, const ReplaceAt& replace) {
  Rendered picture = rendered_again(render.request, render);
  Folder folder(render, out, replace);
  folder.add(render.name + ".png", picture.png);
  if (has_thumbnail(render)) {
    folder.add(thumbnail_name(render), rendered_again(thumbnail_of(render), render).png);
  }
  folder.add_inputs();
  return {folder.finish(), std::move(picture.remarks), entry_of(render)};
}

ManifestFile file_state(const fs::path& out, const std::string& path) {
  constexpr std::int64_t second = 1'000'000'000;
  struct stat state{};
  if (stat((out / path).c_str(), &state) != 0 || !S_ISREG(state.st_mode)) return {path, UINT64_MAX, 0};
  return {path, static_cast<std::uint64_t>(state.st_size),
          state.st_mtim.tv_sec * second + state.st_mtim.tv_nsec};
}

}  // namespace gradus::cli
