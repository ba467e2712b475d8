#include "cli/gallery.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <set>

#include "cli/errors.hpp"
#include "cli/figure.hpp"
#include "cli/files.hpp"
#include "cli/names.hpp"
#include "cli/zip.hpp"
#include "stories/point_text.hpp"
#include "text/snippet.hpp"
#include "web/topic_page.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// Pages of a PDF whose steps nobody chose; longer runs show steps evenly spaced.
constexpr std::int64_t most_gallery_pages = 120;
/// Steps in its zip, two pictures each, likewise.
constexpr std::int64_t most_zip_steps = 48;
/// Links to single files of one format on a card.
constexpr std::size_t most_links = 12;

bool is_picture(Format format) { return format == Format::svg || format == Format::png; }

/// The same figure with one flag set.
FigureSpec with_flag(FigureSpec spec, const std::string& flag, const std::string& value) {
  Request request;
  request.flags[flag] = value;
  apply_flags(spec, request);
  return spec;
}

// --- Which steps -------------------------------------------------------------------------------------------

/// Every stride-th step, and the last: at most so many.
std::vector<StepRange> spaced_steps(std::int64_t last, std::int64_t most) {
  const std::int64_t stride = (last + most - 2) / (most - 1);
  if (stride <= 1) return {};
  const std::int64_t end = last / stride * stride;
  std::vector<StepRange> ranges{{{0, 0}, {end, 0}, stride}};
  if (end != last) ranges.push_back({{last, 0}, {last, 0}});
  return ranges;
}

bool is_cut(std::int64_t last) { return last + 1 > most_gallery_pages; }

/// Steps for the PDF: of a run that is not kept whole, those that are.
std::int64_t last_page(const Takes& takes) { return takes.opening().steps.back().number.step; }

/// The steps that the lecture chose, each of which must exist.
std::vector<StepNumber> chosen_steps(const FigureSpec& spec, const Takes& takes) {
  // Before they are listed: a range may be as long as its numbers are large
  if (count_in(spec.steps) > most_pages) {
    throw UsageError(
        fmt::format("--steps: expected at most {} steps, found {}", most_pages, count_in(spec.steps)));
  }
  return shown_steps(spec, takes);
}

/// One picture a step.
std::vector<StepNumber> picture_steps(const FigureSpec& spec, const Takes& takes) {
  if (!spec.chooses_steps()) return {telling_step(takes)};
  std::vector<StepNumber> steps = chosen_steps(spec, takes);
  std::set<StepNumber> seen;
  std::erase_if(steps, [&seen](StepNumber step) { return !seen.insert(step).second; });
  return steps;
}

/// The figure with the pages of its PDF as its steps.
FigureSpec paged(const FigureSpec& spec, const Takes& takes, std::int64_t most = most_gallery_pages) {
  const std::vector<StepRange> spaced =
      spec.chooses_steps() ? std::vector<StepRange>{} : spaced_steps(last_page(takes), most);
  return spaced.empty() ? spec : with_steps(spec, spaced);
}

std::vector<StepNumber> page_steps(const FigureSpec& pages, const Takes& takes) {
  return pages.chooses_steps() ? chosen_steps(pages, takes) : shown_steps(pages, takes);
}

/// The figure as a table or a player: for a player without gaps.
FigureSpec told(const FigureSpec& spec, const Takes& takes, Format format) {
  if (format != Format::html || !spec.chooses_steps()) return spec;
  const std::vector<StepNumber> steps = chosen_steps(spec, takes);
  const auto [first, last] = std::ranges::minmax(steps);
  // One step is nothing to play: it is shown among all others
  const bool among_others = first == last && has_step(takes.opening(), last);
  return with_steps(spec, {among_others ? StepRange{{0, 0}, {last_page(takes), 0}}
                                        : StepRange{{first.step, 0}, {last.step, 0}}});
}

/// What the card shows of it.
StepNumber thumbnail_step(const FigureSpec& spec, const Takes& takes) {
  const std::vector<StepNumber> steps = picture_steps(spec, takes);
  const StepNumber telling = telling_step(takes);
  return std::ranges::find(steps, telling) != steps.end() ? telling : steps.back();
}

// --- Files -------------------------------------------------------------------------------------------------

std::string base_of(const std::string& path) { return fs::path(path).filename().string(); }

/// The names of the copies of its inputs.
std::vector<std::string> copied_names(const LecturePart& part) {
  std::vector<std::string> names;
  for (const std::string& path : part.copies) {
    const std::string name = base_of(path);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

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

// --- Cards -------------------------------------------------------------------------------------------------

const Method& method_of(const LectureFigure& figure) {
  return *std::ranges::find(figure.spec.topic->methods, figure.spec.arguments.text("method"), &Method::name);
}

/// What is wrong with the method; empty where nothing is.
std::string fault_of(const LectureFigure& figure) {
  const Method& method = method_of(figure);
  return method.standing == Standing::faulty ? method.note : "";
}

/// "Flood fill: breadth first, queue", and what is wrong where something is.
std::string title_of(const LectureFigure& figure) {
  const std::string& given = figure.spec.look.title;
  const std::string title =
      given.empty() ? fmt::format("{}: {}", figure.spec.topic->title, method_of(figure).title) : given;
  const std::string fault = fault_of(figure);
  return fault.empty() ? title : fmt::format("{} (faulty: {})", title, fault);
}

/// What the lecturer calls the figure among those of its topic: its title, else its name without the topic's,
/// else the method's title.
std::string short_title_of(const LectureFigure& figure) {
  if (!figure.spec.look.title.empty()) return figure.spec.look.title;
  std::string_view name = figure.name;
  if (name.starts_with(figure.spec.topic->name)) name.remove_prefix(figure.spec.topic->name.size());
  std::string words(name.substr(std::min(name.find_first_not_of("_-"), name.size())));
  std::ranges::replace(words, '_', ' ');
  return words.empty() ? method_of(figure).title : words;
}

std::string title_of(const LectureRender& render) {
  return render.title.empty() ? render.brief.colophon.title : render.title;
}

/// The file that the card's command makes: a PDF, for it holds everything, else the first kind there is.
Format format_of_command(const LectureFigure& figure) {
  const bool has_pdf = std::ranges::find(figure.outputs, Format::pdf) != figure.outputs.end();
  return has_pdf ? Format::pdf : figure.outputs.front();
}

/// Whether the card's command has to say this flag.
bool figure_says(const LectureFigure& figure, const std::string& flag, Format format) {
  return flag != "caption" && fitting(figure.spec, format).said.contains(flag);
}

/// The shortest command for the same figure: what the lecture says of it. Files go without their folders, as
/// they lie beside the figure.
std::string short_command(const LectureFigure& figure) {
  const Request& request = figure.request;
  const Format format = format_of_command(figure);
  std::string line = fmt::format("gradus figure {}", figure.spec.topic->name);
  for (const Arguments::Entry& entry : figure.spec.arguments.entries()) {
    const auto given = request.arguments.find(entry.name);
    if (given == request.arguments.end()) continue;
    line += " " + flag_with(hyphened(entry.name), entry.hash.empty() ? given->second : entry.text);
  }
  for (const auto& [flag, value] : request.flags) {
    if (!figure_says(figure, flag, format)) continue;
    line += " " + (value.empty() ? "--" + flag : flag_with(flag, value));
  }
  for (const std::string& label : request.labels) line += " --label " + shell_quoted(label);
  const bool series = is_picture(format) && request.has("steps");
  return fmt::format(
      "{} -o {}", line,
      shell_quoted(fmt::format("{}{}.{}", figure.name, series ? "-{step}" : "", name_of(format))));
}

/// Lines for slides that show the figure's files: for each kind of lecture the files that suit it best.
std::vector<std::pair<std::string, std::string>> snippets_of(const LectureFigure& figure,
                                                             const Takes& takes) {
  const FigureSpec& spec = figure.spec;
  const Trace& trace = takes.opening();
  const std::string stem = figure.name + "/" + figure.name;
  const std::string title = spec.look.title.empty() ? trace.title : spec.look.title;
  const std::string alt = figure.caption.empty() ? trace.goal : figure.caption;
  std::vector<std::pair<std::string, std::string>> snippets;
  const auto add = [&](std::string name, SnippetKind kind, Format format,
                       const std::vector<StepNumber>& steps) {
    SnippetFigure shown{std::string(name_of(format)),
                        fmt::format("{} {}", title, trace.subtitle),
                        spec.look.slots.contains(Slot::title),
                        {}};
    const bool series = is_picture(format) && steps.size() > 1;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string number = series ? "-" + text_of(steps[i]) : "";
      shown.steps.push_back({fmt::format("{}{}.{}", stem, number, name_of(format)),
                             format == Format::pdf ? static_cast<int>(i) + 1 : 0, alt});
    }
    snippets.emplace_back(std::move(name), snippet_of(kind, shown));
  };
  const auto makes = [&figure](Format format) {
    return std::ranges::find(figure.outputs, format) != figure.outputs.end();
  };
  if (makes(Format::pdf) && !spec.handout) {
    add("Beamer", SnippetKind::beamer, Format::pdf, page_steps(paged(spec, takes), takes));
  }
  for (const Format format : {Format::html, Format::svg, Format::png}) {
    if (!makes(format)) continue;
    add("reveal.js", SnippetKind::reveal, format,
        is_picture(format) ? picture_steps(spec, takes) : std::vector{StepNumber{}});
    break;
  }
  for (const Format format : {Format::svg, Format::png}) {
    if (!makes(format)) continue;
    add("Markdown", SnippetKind::markdown, format, picture_steps(spec, takes));
    break;
  }
  return snippets;
}

/// SVG and PNG of each step, for whoever takes them all.
std::string zip_bytes(const LectureFigure& figure, Takes& takes) {
  const FigureSpec spec = paged(figure.spec, takes, most_zip_steps);
  const auto draw = [&](StepNumber step) {
    const auto picture = [&](Format format) {
      return picture_bytes(fitting(at_step(spec, step), format), takes, step, format);
    };
    return StepPicture{picture(Format::svg), picture(Format::png)};
  };
  return zip_of(step_entries(figure.name, title_of(figure), short_command(figure), page_steps(spec, takes),
                             {takes.last(), 0}, draw));
}

bool has_zip(const LectureFigure& figure) {
  return std::ranges::all_of(std::array{Format::svg, Format::png}, [&figure](Format format) {
    return std::ranges::find(figure.outputs, format) != figure.outputs.end();
  });
}

std::string_view label_of(Format format) {
  switch (format) {
    case Format::pdf:
      return "PDF, a page a step";
    case Format::pptx:
      return "PowerPoint, a slide a step";
    case Format::svg:
      return "SVG";
    case Format::png:
      return "PNG";
    case Format::csv:
      return "table (CSV)";
    case Format::json:
      return "data (JSON)";
    case Format::md:
      return "table (Markdown)";
    case Format::tex:
      return "table (LaTeX)";
    case Format::gif:
      return "film (GIF)";
    case Format::mp4:
      return "film (MP4)";
    case Format::webp:
      return "film (WebP)";
    default:
      return "text";
  }
}

/// Links to the copies of its inputs.
void add_inputs(Card& card, const LecturePart& part) {
  for (const std::string& name : copied_names(part)) {
    card.downloads.emplace_back("input " + name, part.name + "/" + name);
  }
}

/// Links to the figure's files of one format.
void add_downloads(Card& card, const LectureFigure& figure, std::span<const ManifestFile> files,
                   Format format) {
  const std::string stem = figure.name + "/" + figure.name, ending = fmt::format(".{}", name_of(format));
  std::vector<std::string> steps;
  for (const ManifestFile& file : files) {
    if (file.path == stem + ending) {
      card.downloads.emplace_back(label_of(format), file.path);
    } else if (file.path.starts_with(stem + "-") && file.path.ends_with(ending) &&
               file.path != card.thumbnail) {
      steps.push_back(file.path);
    }
  }
  if (steps.size() > most_links) {
    card.downloads.emplace_back(fmt::format("{} of {} steps", label_of(format), steps.size()),
                                figure.name + "/");
    return;
  }
  for (const std::string& path : steps) {
    const std::size_t start = stem.size() + 1;
    const std::string step = path.substr(start, path.size() - ending.size() - start);
    card.downloads.emplace_back(fmt::format("{}, step {}", label_of(format), step), path);
  }
}

// --- Renders -----------------------------------------------------------------------------------------------

/// Larger pictures have a smaller one for their card.
constexpr int largest_thumbnail = 1280;

bool has_thumbnail(const LectureRender& render) {
  return std::max(render.brief.width, render.brief.height) > largest_thumbnail;
}

std::string thumbnail_name(const LectureRender& render) {
  return render.name + (has_thumbnail(render) ? "-small.png" : ".png");
}

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

/// Lines for slides that show the picture.
std::vector<std::pair<std::string, std::string>> snippets_of(const LectureRender& render) {
  const std::string& alt = render.caption.empty() ? render.brief.colophon.description : render.caption;
  const SnippetFigure shown{
      "png", title_of(render), false, {{fmt::format("{0}/{0}.png", render.name), 0, alt}}};
  return {{"Beamer", snippet_of(SnippetKind::beamer, shown)},
          {"reveal.js", snippet_of(SnippetKind::reveal, shown)},
          {"Markdown", snippet_of(SnippetKind::markdown, shown)}};
}

}  // namespace

std::string program_fingerprint() { return fingerprint(read_input("/proc/self/exe", "gradus")); }

std::vector<OutputFile> output_files(const FigureSpec& figure, Takes& takes, Format format,
                                     const std::string& stem) {
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
    files.push_back({stem + number + ending, picture_bytes(at_step(spec, step), takes, step, format)});
  }
  return files;
}

void rehearse(const LectureFigure& figure) {
  const FigureSpec& spec = figure.spec;
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec));
  for (const Format format : figure.outputs) {
    if (is_film(format)) check_film(film_format(format), spec.film, spec.transparent);
    if (is_document(format) || is_film(format)) {
      page_steps(paged(spec, takes), takes);
    } else if (!is_picture(format)) {
      shown_part(told(spec, takes, format), takes, format);
    }
  }
  sheet_of(spec, takes, thumbnail_step(spec, takes));
}

Drawn draw(const LectureFigure& figure, const fs::path& out, const ReplaceAt& replace) {
  const FigureSpec& spec = figure.spec;
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec));
  Folder folder(figure, out, replace);
  for (const Format format : figure.outputs) {
    for (const OutputFile& file : output_files(spec, takes, format, figure.name)) {
      folder.add(file.name, file.bytes);
    }
  }
  const StepNumber telling = thumbnail_step(spec, takes);
  const FigureSpec thumbnail = fitting(with_flag(at_step(spec, telling), "slots", "drawing"), Format::svg);
  folder.add(figure.name + "-drawing.svg", picture_bytes(thumbnail, takes, telling, Format::svg));
  if (has_zip(figure)) folder.add(figure.name + "-steps.zip", zip_bytes(figure, takes));
  folder.add_inputs();
  return {folder.finish(), figure.remarks};
}

Card card_of(const LectureFigure& figure, std::span<const ManifestFile> files, const Takes& takes) {
  const auto makes = [&figure](Format format) {
    return std::ranges::find(figure.outputs, format) != figure.outputs.end();
  };
  const std::string stem = figure.name + "/" + figure.name;
  Card card;
  card.slug = figure.name;
  card.title = title_of(figure);
  card.chapter = figure.spec.topic->chapter;
  card.caption = figure.caption;
  if (makes(Format::pdf) && !figure.spec.chooses_steps() && is_cut(takes.last())) {
    card.caption += fmt::format("{}(The PDF shows at most {} of the {} steps, evenly spaced.)",
                                card.caption.empty() ? "" : " ", most_gallery_pages, takes.last() + 1);
  }
  card.command = short_command(figure);
  card.thumbnail = stem + "-drawing.svg";
  if (makes(Format::html)) card.player = stem + ".html";
  // The most useful first, whatever the order in the lecture
  for (const Format format :
       {Format::pdf, Format::pptx, Format::svg, Format::png, Format::gif, Format::mp4, Format::webp,
        Format::csv, Format::md, Format::tex, Format::json, Format::txt}) {
    if (makes(format)) add_downloads(card, figure, files, format);
  }
  add_inputs(card, figure);
  if (has_zip(figure)) card.zip = stem + "-steps.zip";
  const TopicEntry& topic = *figure.spec.topic;
  card.group = {topic.name, topic.title, topic_page_path(topic)};
  card.name = short_title_of(figure);
  card.faulty = fault_of(figure);
  const bool drawn = std::ranges::find(files, stem + ".svg", &ManifestFile::path) != files.end();
  if (drawn) card.slide = stem + ".svg";
  card.snippets = snippets_of(figure, takes);
  card.words = figure.spec.topic->aliases;
  card.words.insert(card.words.end(), {figure.spec.topic->name, figure.spec.arguments.text("method")});
  return card;
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
  return {folder.finish(), std::move(picture.remarks)};
}

Card card_of(const LectureRender& render) {
  const std::string folder = render.name + "/", picture = folder + render.name + ".png";
  Card card;
  card.slug = render.name;
  card.title = title_of(render);
  card.chapter = "pipeline";
  card.group = {"render", "Rendered models", ""};
  card.caption = render.caption;
  card.command = fmt::format("{} -o {}.png", render.brief.colophon.command, render.name);
  card.thumbnail = folder + thumbnail_name(render);
  card.opened = picture;
  card.downloads.emplace_back("PNG", picture);
  add_inputs(card, render);
  card.snippets = snippets_of(render);
  card.words = {"render", base_of(render.files.front())};
  return card;
}

ManifestFile file_state(const fs::path& out, const std::string& path) {
  constexpr std::int64_t second = 1'000'000'000;
  struct stat state{};
  if (stat((out / path).c_str(), &state) != 0 || !S_ISREG(state.st_mode)) return {path, UINT64_MAX, 0};
  return {path, static_cast<std::uint64_t>(state.st_size),
          state.st_mtim.tv_sec * second + state.st_mtim.tv_nsec};
}

}  // namespace gradus::cli
