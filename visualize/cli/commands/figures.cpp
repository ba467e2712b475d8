// `gradus figures`: all figures of a lecture, several at a time, only what has changed.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/errata.hpp"
#include "cli/files/files.hpp"
#include "cli/files/zip.hpp"
#include "cli/gallery/gallery.hpp"
#include "cli/gallery/topic_pages.hpp"
#include "cli/system/threads.hpp"
#include "cli/terminal/progress.hpp"
#include "core/image.hpp"
#include "request/fingerprint.hpp"
#include "request/names.hpp"
#include "scene/files.hpp"
#include "stories/point_text.hpp"
#include "web/topic_page.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = ".gradus-manifest.json";
constexpr const char* index_name = "index.html";
constexpr const char* topics_folder = "topics/";
constexpr const char* errata_name = "errata.html";

/// What lies in the output folder, as far as it was made here. Remembered in a file of the folder, which is
/// written anew from time to time: each time costs as much as there is to remember.
class Album {
 public:
  explicit Album(fs::path out) : out_(std::move(out)) {
    const pipeline::FileRead file = pipeline::read_regular_file((out_ / manifest_name).string());
    if (file.problem.empty()) manifest_ = parse_manifest(file.bytes);
  }

  /// Whose figures these are: LectureFile::owner. Nobody's while there are none.
  bool belongs_to(const std::string& owner) const {
    return manifest_.jobs.empty() || manifest_.owner == owner;
  }
  /// The owner as people call him.
  std::string owner() const {
    const std::size_t end = manifest_.owner.rfind(' ');
    return manifest_.owner.empty() ? "the built-in gallery"
                                   : "the lecture " + shown(manifest_.owner.substr(0, end));
  }
  void give_to(const std::string& owner) {
    changed_ = changed_ || manifest_.owner != owner;
    manifest_.owner = owner;
  }

  bool has(const std::string& slug, const std::string& key) const {
    const auto known = manifest_.jobs.find(slug);
    if (known == manifest_.jobs.end() || known->second.first != key) return false;
    return std::ranges::all_of(known->second.second,
                               [this](const ManifestFile& file) { return is_as_made(file); });
  }
  bool knows(const std::string& slug) const { return manifest_.jobs.contains(slug); }
  /// Whether the job made a file of this name the last time. From any thread.
  bool made(const std::string& slug, const std::string& path) const {
    const std::lock_guard lock(mutex_);
    const auto known = manifest_.jobs.find(slug);
    return known != manifest_.jobs.end() &&
           std::ranges::find(known->second.second, path, &ManifestFile::path) != known->second.second.end();
  }
  const std::string& key(const std::string& slug) const { return manifest_.jobs.at(slug).first; }
  const std::vector<ManifestFile>& files(const std::string& slug) const {
    return manifest_.jobs.at(slug).second;
  }

  /// Paths of everything that lies here, sorted.
  std::vector<std::string> paths() const {
    std::vector<std::string> all;
    for (const auto& [slug, job] : manifest_.jobs) {
      for (const ManifestFile& file : job.second) all.push_back(file.path);
    }
    std::ranges::sort(all);
    return all;
  }

  /// From any thread. What the job made earlier and no longer does is removed.
  void put(const std::string& slug, const std::string& key, std::vector<ManifestFile> files) {
    const std::lock_guard lock(mutex_);
    auto& job = manifest_.jobs[slug];
    for (const ManifestFile& old : job.second) {
      if (std::ranges::find(files, old.path, &ManifestFile::path) == files.end()) remove(slug, old);
    }
    job = {key, std::move(files)};
    changed_ = true;
    if (std::chrono::steady_clock::now() >= next_save_) save();
  }

  /// Forgets jobs that no longer exist, with their files. Returns how many there were.
  std::size_t keep_only(const std::vector<AnyPart>& parts) {
    std::set<std::string> names{index_name};
    for (const AnyPart& part : parts) names.insert(part_of(part).name);
    const auto gone = [&names](const auto& known) { return !names.contains(known.first); };
    for (const auto& known : manifest_.jobs) {
      if (!gone(known)) continue;
      for (const ManifestFile& file : known.second.second) remove(known.first, file);
      std::error_code error;
      if (fs::path(known.first).filename() == known.first) fs::remove(out_ / known.first, error);  // if empty
    }
    const std::size_t count = std::erase_if(manifest_.jobs, gone);
    changed_ = changed_ || count > 0;
    save();
    return count;
  }

  /// Writes down all that has been put. Not while other threads put.
  void save() {
    if (!changed_) return;
    const auto start = std::chrono::steady_clock::now();
    write_output((out_ / manifest_name).string(), manifest_json(manifest_), Replace::anything);
    const auto end = std::chrono::steady_clock::now();
    changed_ = false;
    // A killed run has little to do again, and a long one spends a small part of its time here
    next_save_ =
        end + std::max<std::chrono::steady_clock::duration>(std::chrono::seconds(1), 20 * (end - start));
  }

 private:
  bool is_as_made(const ManifestFile& file) const {
    const ManifestFile now = file_state(out_, file.path);
    return now.size == file.size && now.modified == file.modified;
  }

  /// Only what was made here and not touched since, and only inside the job's own folder.
  void remove(const std::string& slug, const ManifestFile& file) const {
    const fs::path path(file.path);
    const bool own = path == fs::path(slug) / path.filename() && !slug.empty() && !slug.starts_with('.');
    const bool page = slug == index_name && path.lexically_normal() == path &&
                      (file.path.starts_with(topics_folder) || file.path == errata_name);
    if (!(own || page) || !is_as_made(file)) return;
    std::error_code error;
    fs::remove(out_ / path, error);
  }

  fs::path out_;
  Manifest manifest_;
  mutable std::mutex mutex_;
  bool changed_ = false;  ///< since it was written down
  std::chrono::steady_clock::time_point next_save_{};
};

/// A figure or render, and its fingerprint: another one when the program, the input or the lecture's words
/// differ.
struct Job {
  AnyPart part;
  std::string key;

  const std::string& name() const { return part_of(part).name; }
};

/// What a pattern of --only can name beside the figure's own name.
std::string kind_of(const LectureFigure& figure) { return figure.spec.topic->name; }
std::string kind_of(const LectureRender&) { return "render"; }

std::vector<Job> selected(const Lecture& lecture, const std::string& program, const Request& request) {
  const auto only = request.flags.find("only");
  std::vector<Job> wanted;
  for (const AnyPart& any : lecture.parts()) {
    std::visit(
        [&](const auto* part) {
          const bool matches = only == request.flags.end() || matches_glob(only->second, part->name) ||
                               matches_glob(only->second, kind_of(*part));
          if (matches) wanted.push_back({part, fingerprint(program + "\n" + part->contents())});
        },
        any);
  }
  if (wanted.empty() && only != request.flags.end()) {
    throw WorkError(fmt::format("--only: expected a pattern that matches a figure or a topic, found {}",
                                shown(only->second)));
  }
  return wanted;
}

fs::path folder_name(const Request& request) {
  const auto wanted = request.flags.find("output");
  const std::string name = wanted == request.flags.end() ? "out" : wanted->second;
  std::error_code error;
  if (name == dash || (fs::exists(name, error) && !fs::is_directory(name, error))) {
    throw UsageError(fmt::format("-o: expected a folder, found {}", shown(name)));
  }
  return name;
}

void make_gallery_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw WorkError(fmt::format("can't make the folder {}: {}", shown(folder.string()), error.message()));
}

/// Refuses a folder with the figures of another lecture.
void check_owner(const Album& album, const LectureFile& file, const fs::path& out) {
  if (album.belongs_to(file.owner)) return;
  throw UsageError(
      fmt::format("-o: expected a folder without the figures of another lecture, found {} with those of {} "
                  "(--force removes them)",
                  shown(out.string()), album.owner()));
}

/// The paths of the pages that a lecture has beside its figures' folders.
std::set<std::string> page_paths(const Lecture& lecture, bool built_in) {
  std::set<std::string> paths{index_name};
  if (built_in) paths.insert(errata_name);
  for (const LectureFigure& figure : lecture.figures) {
    const std::string page = topic_page_path(*figure.spec.topic);
    if (!page.empty()) paths.insert(page);
  }
  return paths;
}

/// Refuses a folder where a page would take the place of somebody's own, also one that came after ours.
void check_pages(const std::set<std::string>& pages, const fs::path& out) {
  for (const std::string& page : pages) check_replaced((out / page).string(), "-o");
}

struct Failures {
  std::size_t count = 0;
  std::vector<Problem> problems;
  bool about_input = false;  ///< at least one of them
};

/// Does `work(i)` for the i-th of all jobs; what goes wrong becomes a problem, in the jobs' order.
template <class Work>
Failures for_all(const std::vector<Job>& jobs, const Lecture& lecture, std::size_t threads, bool quiet,
                 Work work) {
  std::vector<Problem> problems(jobs.size());
  std::atomic<bool> about_input = false;
  Progress progress(jobs.size(), quiet);
  in_parallel(jobs.size(), threads, [&](std::size_t i) {
    try {
      work(i);
      progress.finished(i, jobs[i].name());
    } catch (const std::exception& error) {
      if (is_about_input(error)) about_input = true;
      problems[i] = problem_of(lecture, part_of(jobs[i].part), error);
      progress.finished(i, "");
    }
  });
  const auto fine = std::ranges::count(problems, Problem{});
  // What a default does wrong in several figures is said once
  std::set<Problem> known{{}};
  std::erase_if(problems, [&known](const Problem& problem) { return !known.insert(problem).second; });
  return {jobs.size() - static_cast<std::size_t>(fine), problems, about_input};
}

/// Writes the pages of the topics that have figures here; check_pages() has let them. Returns what was
/// written.
std::vector<ManifestFile> write_topics(const std::vector<TopicFigure>& figures, const fs::path& out) {
  std::vector<ManifestFile> written;
  for (const TopicPage& page : topic_pages(figures)) {
    const fs::path path = out / page.path;
    make_gallery_folder(path.parent_path());
    write_output(path.string(), page.html, Replace::anything);
    written.push_back(file_state(out, page.path));
  }
  return written;
}

/// What figures and renders say of themselves, by their names.
using Entries = std::map<std::string, GalleryEntry>;

GalleryEntry entry_of_part(const LectureFigure& figure, const Album& album) {
  return entry_of(figure, album.files(figure.name));
}
GalleryEntry entry_of_part(const LectureRender& render, const Album&) { return entry_of(render); }

/// The page of all figures that are there, and the pages of their topics; with the built-in gallery the
/// errata. `drawn`: the entries of those that have just been drawn.
void write_index(const Lecture& lecture, bool built_in, const fs::path& out, Album& album, Entries drawn,
                 const std::string& program, bool force) {
  std::string contents = program + "\n" + lecture.title;
  std::vector<AnyPart> present;
  for (const AnyPart& part : lecture.parts()) {
    const std::string& name = part_of(part).name;
    if (!album.knows(name)) continue;
    present.push_back(part);
    contents += "\n" + name + " " + album.key(name);
  }
  const std::string key = fingerprint(contents);
  if (!force && album.has(index_name, key)) return;
  std::vector<Card> cards;
  std::vector<TopicFigure> linked;
  for (const AnyPart& part : present) {
    const auto known = drawn.find(part_of(part).name);
    GalleryEntry entry =
        known != drawn.end()
            ? std::move(known->second)
            : std::visit([&album](const auto* one) { return entry_of_part(*one, album); }, part);
    cards.push_back(std::move(entry.card));
    if (entry.topic_figure) linked.push_back(std::move(*entry.topic_figure));
  }
  std::vector<ManifestFile> written = write_topics(linked, out);
  GalleryOptions options;
  if (!lecture.title.empty()) options.title = lecture.title;
  if (built_in) {
    write_output((out / errata_name).string(), errata_gallery(), Replace::anything);
    written.push_back(file_state(out, errata_name));
    options.errata = errata_name;
  }
  write_output((out / index_name).string(), gallery_page(cards, options), Replace::anything);
  written.push_back(file_state(out, index_name));
  album.put(index_name, key, std::move(written));
  album.save();
}

void complain(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) note("gradus: " + problem.text);
}

/// "3 figures, 1 render"
std::string counts_of(const Lecture& lecture) {
  std::string text;
  const auto count = [&text](std::size_t number, std::string_view what) {
    if (number == 0) return;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", number, what, number == 1 ? "" : "s");
  };
  count(lecture.figures.size(), "figure");
  count(lecture.renders.size(), "render");
  return text;
}

/// `--check`: every problem of the lecture, one per line.
int check(const Lecture& lecture, const Request& request, std::size_t threads) {
  std::vector<Job> jobs;
  for (const AnyPart& part : lecture.parts()) jobs.push_back({part, ""});
  const Failures failures = for_all(jobs, lecture, threads, true, [&](std::size_t i) {
    std::visit([](const auto* part) { rehearse(*part); }, jobs[i].part);
  });
  std::vector<Problem> all = lecture.problems;
  all.insert(all.end(), failures.problems.begin(), failures.problems.end());
  std::ranges::stable_sort(all, {}, &Problem::line);
  complain(all);
  if (!lecture.problems.empty() || failures.about_input) return 2;
  if (!all.empty()) return 1;
  if (!request.quiet()) {
    note(fmt::format("{}: {}, no problems", lecture.file, counts_of(lecture)));
  }
  return 0;
}

/// Flags that stand in the place of what a lecture says of its looks. Throws UsageError for a wrong one.
std::map<std::string, std::string> looks_of(const Request& request) {
  Request alone;
  for (const Flag& look : lecture_looks()) {
    if (request.has(look.name)) alone.flags[look.name] = request.flags.at(look.name);
  }
  read_spec(alone, {});
  return alone.flags;
}

/// "out/" -> "out.zip"
std::string zip_beside(const fs::path& out) {
  const fs::path whole = fs::absolute(out).lexically_normal();
  const fs::path folder = whole.has_filename() ? whole : whole.parent_path();
  return folder.string() + ".zip";
}

}  // namespace

int figures(const Request& request) {
  if (request.has("schema")) {
    write_stream(Stream::out, lecture_schema());
    return 0;
  }
  const std::size_t threads = read_jobs(request);
  const LectureFile file = request.operands.empty() ? gallery_lecture() : lecture_at(request.operands[0]);
  const Lecture lecture = read_lecture(file, looks_of(request));
  if (request.has("check")) return check(lecture, request, threads);
  if (!lecture.problems.empty()) throw InputError(lecture.problems.front().text);

  const std::string program = program_fingerprint();
  const std::vector<Job> wanted = selected(lecture, program, request);
  const fs::path out = folder_name(request);
  const bool force = request.has("force"), built_in = file.owner.empty();
  Album album(out);
  if (!force) {
    check_owner(album, file, out);
    check_pages(page_paths(lecture, built_in), out);
    if (request.has("zip")) check_replaced(zip_beside(out), "--zip");
  }
  load_page_maker();
  make_gallery_folder(out);
  album.give_to(file.owner);
  const std::size_t removed = album.keep_only(lecture.parts());
  std::vector<Job> due;
  for (const Job& job : wanted) {
    if (force || !album.has(job.name(), job.key)) due.push_back(job);
  }
  std::vector<std::vector<std::string>> remarks(due.size());
  std::vector<GalleryEntry> entries(due.size());
  const Failures failures = for_all(due, lecture, threads, request.quiet(), [&](std::size_t i) {
    const auto replace = [&](const std::string& path) {
      return replaces(force || album.made(due[i].name(), path));
    };
    Drawn drawn = std::visit([&](const auto* part) { return draw(*part, out, replace); }, due[i].part);
    album.put(due[i].name(), due[i].key, std::move(drawn.files));
    remarks[i] = std::move(drawn.remarks);
    entries[i] = std::move(drawn.entry);
  });
  album.save();
  Entries drawn;
  for (std::size_t i = 0; i < due.size(); ++i) {
    if (!entries[i].card.slug.empty()) drawn.emplace(due[i].name(), std::move(entries[i]));
  }
  write_index(lecture, built_in, out, album, std::move(drawn), program, force);

  if (request.has("zip")) {
    zip_folder(out, album.paths(), zip_beside(out), replaces(force));
    if (!request.quiet()) note(shown_name(zip_beside(out)));
  }
  complain(failures.problems);
  if (!request.quiet()) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      for (const std::string& remark : remarks[i]) note(fmt::format("{}: {}", due[i].name(), remark));
    }
    note(fmt::format("{} drawn, {} unchanged, {} removed", due.size() - failures.count,
                     wanted.size() - due.size(), removed));
  }
  if (!failures.problems.empty()) return failures.about_input ? 2 : 1;
  write_stream(Stream::out, (out / index_name).string() + "\n");
  return 0;
}

}  // namespace gradus::cli
