#include "cli/gallery.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <stdexcept>

#include "cli/errors.hpp"
#include "cli/figure_file.hpp"
#include "cli/files.hpp"
#include "cli/names.hpp"
#include "cli/zip.hpp"
#include "stories/point_text.hpp"
#include "web/topic_page.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// Pages of a PDF in the gallery; longer runs show steps evenly spaced.
constexpr std::int64_t most_gallery_pages = 120;
/// Steps in its zip, two pictures each, likewise.
constexpr std::int64_t most_zip_steps = 48;

/// Input files of showcases are named from the project's root; the program lies somewhere below it.
std::string find_data(const std::string& name, const std::string& flag) {
  std::error_code error;
  if (fs::is_regular_file(name, error)) return name;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    for (const fs::path& candidate : {folder / name, folder / "share" / "gradus" / name}) {
      if (fs::is_regular_file(candidate, error)) return candidate.string();
    }
    if (folder == folder.root_path()) break;
  }
  throw WorkError(fmt::format("{}: expected the file {} here or in a folder above the program, found none",
                              flag, shown(name)));
}

FigureSpec spec_of(const Job& job) {
  FigureSpec spec;
  spec.topic = job.topic;
  spec.arguments = job.inputs.arguments;
  spec.theme = &themes().front();
  return spec;
}

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

StepNumber telling_step(const Takes& takes) {
  const StepNumber telling = takes.opening().telling;
  return has_step(takes.opening(), telling) ? telling : takes.opening().steps.back().number;
}

/// Collects the files of one job under their names.
class Folder {
 public:
  Folder(const Job& job, const fs::path& out) : job_(job), out_(out) {
    std::error_code error;
    fs::create_directories(out / job.showcase->slug, error);
    if (error)
      throw WorkError(
          fmt::format("can't make the folder {}: {}", shown((out / slug()).string()), error.message()));
  }
  /// A folder that stayed empty, because something failed, goes again.
  ~Folder() {
    std::error_code error;
    fs::remove(out_ / slug(), error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::string& slug() const { return job_.showcase->slug; }

  void add(const std::string& name, std::string_view bytes) {
    const std::string path = slug() + "/" + name;
    files_.add((out_ / path).string(), bytes);
    paths_.push_back(path);
  }
  void add_figure(const std::string& ending, std::string_view bytes) { add(slug() + ending, bytes); }

  std::vector<ManifestFile> finish() {
    files_.commit();
    std::vector<ManifestFile> states;
    for (const std::string& path : paths_) states.push_back(file_state(out_, path));
    return states;
  }

 private:
  const Job& job_;
  const fs::path& out_;
  NewFiles files_;
  std::vector<std::string> paths_;
};

void add_inputs(Folder& folder, const Job& job) {
  // Beside the figures, where `gradus again` looks for them
  for (const Arguments::Entry& entry : job.inputs.arguments.entries()) {
    if (entry.hash.empty()) continue;
    const auto path = std::ranges::find_if(job.inputs.files, [&entry](const std::string& file) {
      return fs::path(file).filename() == entry.text;
    });
    if (path != job.inputs.files.end()) folder.add(entry.text, read_input(*path, entry.name));
  }
}

/// "Flood fill: breadth first, queue", and what is wrong where something is.
std::string title_of(const Job& job) {
  const std::string& name = job.inputs.arguments.text("method");
  const auto method = std::ranges::find(job.topic->methods, name, &Method::name);
  const std::string title = fmt::format("{}: {}", job.topic->title, method->title);
  return method->standing == Standing::faulty ? fmt::format("{} (faulty: {})", title, method->note) : title;
}

/// The shortest command for the same figure: what differs from the defaults.
std::string short_command(const Job& job) {
  std::string line = fmt::format("gradus figure {}", job.topic->name);
  for (const Argument& argument : job.showcase->arguments) {
    line += fmt::format(" --{} {}", argument.name, shell_quoted(argument.value));
  }
  return line + " -o " + job.showcase->slug + ".pdf";
}

std::string zip_bytes(const Job& job, FigureSpec spec, Takes& takes) {
  spec.steps = spaced_steps(last_page(takes), most_zip_steps);
  const auto draw = [&](StepNumber step) {
    const FigureSpec one = at_step(spec, step);
    return StepPicture{picture_bytes(one, takes, step, Format::svg),
                       picture_bytes(one, takes, step, Format::png)};
  };
  return zip_of(step_entries(job.showcase->slug, title_of(job), short_command(job), shown_steps(spec, takes),
                             {takes.last(), 0}, draw));
}

}  // namespace

std::string program_fingerprint() { return fingerprint(read_input("/proc/self/exe", "gradus")); }

std::vector<Job> gallery_jobs(const std::string& program) {
  std::vector<Job> jobs;
  for (const TopicEntry* topic : catalogue()) {
    for (const Showcase& showcase : topic->gallery) {
      std::map<std::string, std::string> given;
      for (const Argument& argument : showcase.arguments) given[argument.name] = argument.value;
      Job job{topic, &showcase, read_inputs(*topic, given, find_data), ""};
      job.key = fingerprint(fmt::format("{}\n{}\n{}\n{}\n{}", program, showcase.slug, showcase.caption,
                                        command_of("figure", *topic, job.inputs.arguments),
                                        input_hash(job.inputs.arguments)));
      const bool known = std::ranges::any_of(
          jobs, [&showcase](const Job& other) { return other.showcase->slug == showcase.slug; });
      if (known)
        throw std::logic_error(fmt::format("two figures of the gallery are called {}", showcase.slug));
      jobs.push_back(std::move(job));
    }
  }
  return jobs;
}

std::vector<ManifestFile> draw(const Job& job, const fs::path& out) {
  FigureSpec spec = spec_of(job);
  Takes takes(*job.topic, job.inputs.arguments);
  const StepNumber telling = telling_step(takes);
  Folder folder(job, out);

  FigureSpec one = at_step(spec, telling);
  folder.add_figure(".svg", picture_bytes(one, takes, telling, Format::svg));
  folder.add_figure(".png", picture_bytes(one, takes, telling, Format::png));
  one.look.slots = {Slot::drawing};
  folder.add_figure("-drawing.svg", picture_bytes(one, takes, telling, Format::svg));

  folder.add_figure(".html", trace_bytes(spec, takes.opening(), Format::html));
  folder.add_figure(".csv", trace_bytes(spec, takes.opening(), Format::csv));
  folder.add_figure(".json", trace_bytes(spec, takes.opening(), Format::json));

  FigureSpec pages = spec;
  pages.steps = spaced_steps(last_page(takes), most_gallery_pages);
  folder.add_figure(".pdf", pages_bytes(pages, takes, shown_steps(pages, takes)));
  folder.add_figure("-steps.zip", zip_bytes(job, spec, takes));
  add_inputs(folder, job);
  return folder.finish();
}

Card card_of(const Job& job, std::int64_t last) {
  const std::string& slug = job.showcase->slug;
  const auto path = [&slug](const std::string& ending) { return slug + "/" + slug + ending; };
  Card card;
  card.slug = slug;
  card.title = title_of(job);
  card.chapter = job.topic->chapter;
  card.caption = job.showcase->caption;
  if (is_cut(last)) {
    card.caption += fmt::format(" (The PDF shows at most {} of the {} steps, evenly spaced.)",
                                most_gallery_pages, last + 1);
  }
  card.command = short_command(job);
  card.thumbnail = path("-drawing.svg");
  card.player = path(".html");
  card.downloads = {{"PDF, a page a step", path(".pdf")},
                    {"SVG", path(".svg")},
                    {"PNG", path(".png")},
                    {"table (CSV)", path(".csv")},
                    {"data (JSON)", path(".json")}};
  card.zip = path("-steps.zip");
  card.topic_page = topic_page_path(*job.topic);
  card.words = job.topic->aliases;
  card.words.insert(card.words.end(), {job.topic->name, job.inputs.arguments.text("method")});
  for (const Arguments::Entry& entry : job.inputs.arguments.entries()) {
    if (!entry.hash.empty()) card.downloads.emplace_back("input " + entry.text, slug + "/" + entry.text);
  }
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
