// `gradus figures`: the whole gallery, in parallel, only what has changed.

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <thread>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/files.hpp"
#include "cli/gallery.hpp"
#include "cli/names.hpp"
#include "cli/progress.hpp"
#include "cli/topic_pages.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = ".gradus-manifest.json";
constexpr const char* index_name = "index.html";
constexpr const char* topics_folder = "topics/";

/// The cores this process may use: what the scheduler grants, within what the machine allows.
std::size_t usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  const bool known = sched_getaffinity(0, sizeof set, &set) == 0;
  const std::size_t allowed = known ? static_cast<std::size_t>(CPU_COUNT(&set)) : 1;
  const char* granted = std::getenv("SLURM_CPUS_PER_TASK");
  const auto count = granted ? whole_number(granted) : std::nullopt;
  return count && *count > 0 ? std::min(allowed, static_cast<std::size_t>(*count)) : allowed;
}

std::size_t read_jobs(const Request& request) {
  const auto text = request.flags.find("jobs");
  if (text == request.flags.end()) return usable_cores();
  const auto count = whole_number(text->second);
  if (!count || *count < 1 || *count > 1024) {
    throw UsageError(
        fmt::format("--jobs: expected a whole number from 1 to 1024, found {}", shown(text->second)));
  }
  return static_cast<std::size_t>(*count);
}

/// What lies in the output folder, as far as it was made here.
class Album {
 public:
  explicit Album(fs::path out) : out_(std::move(out)) {
    std::ifstream file(out_ / manifest_name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (file) manifest_ = parse_manifest(text.str());
  }

  bool has(const std::string& slug, const std::string& key) const {
    const auto known = manifest_.jobs.find(slug);
    if (known == manifest_.jobs.end() || known->second.first != key) return false;
    return std::ranges::all_of(known->second.second,
                               [this](const ManifestFile& file) { return is_as_made(file); });
  }
  bool knows(const std::string& slug) const { return manifest_.jobs.contains(slug); }
  const std::string& key(const std::string& slug) const { return manifest_.jobs.at(slug).first; }

  /// From any thread. What the job made earlier and no longer does is removed.
  void put(const std::string& slug, const std::string& key, std::vector<ManifestFile> files) {
    const std::lock_guard lock(mutex_);
    auto& job = manifest_.jobs[slug];
    for (const ManifestFile& old : job.second) {
      if (std::ranges::find(files, old.path, &ManifestFile::path) == files.end()) remove(slug, old);
    }
    job = {key, std::move(files)};
    write_output((out_ / manifest_name).string(), manifest_json(manifest_));
  }

  /// Forgets jobs that no longer exist, with their files. Returns how many there were.
  std::size_t keep_only(const std::vector<Job>& jobs) {
    const auto gone = [&jobs](const auto& known) {
      return known.first != index_name && std::ranges::none_of(jobs, [&known](const Job& job) {
               return job.showcase->slug == known.first;
             });
    };
    for (const auto& known : manifest_.jobs) {
      if (!gone(known)) continue;
      for (const ManifestFile& file : known.second.second) remove(known.first, file);
      std::error_code error;
      if (fs::path(known.first).filename() == known.first) fs::remove(out_ / known.first, error);  // if empty
    }
    const std::size_t count = std::erase_if(manifest_.jobs, gone);
    if (count > 0) write_output((out_ / manifest_name).string(), manifest_json(manifest_));
    return count;
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
    const bool page =
        slug == index_name && path.lexically_normal() == path && file.path.starts_with(topics_folder);
    if (!(own || page) || !is_as_made(file)) return;
    std::error_code error;
    fs::remove(out_ / path, error);
  }

  fs::path out_;
  Manifest manifest_;
  std::mutex mutex_;
};

/// Calls do_one(i) for every i < count, on several threads.
template <class DoOne>
void in_parallel(std::size_t count, std::size_t threads, DoOne do_one) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) do_one(i);
  };
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < std::min(threads, count); ++i) others.emplace_back(work);
  work();
}

std::vector<const Job*> selected(const std::vector<Job>& jobs, const Request& request) {
  const auto only = request.flags.find("only");
  std::vector<const Job*> wanted;
  for (const Job& job : jobs) {
    const bool matches = only == request.flags.end() || matches_glob(only->second, job.showcase->slug) ||
                         matches_glob(only->second, job.topic->name);
    if (matches) wanted.push_back(&job);
  }
  if (wanted.empty() && only != request.flags.end()) {
    throw WorkError(fmt::format("--only: expected a pattern that matches a figure or a topic, found {}",
                                shown(only->second)));
  }
  return wanted;
}

fs::path make_folder(const Request& request) {
  const auto wanted = request.flags.find("output");
  const std::string name = wanted == request.flags.end() ? "out" : wanted->second;
  std::error_code error;
  if (name == dash || (fs::exists(name, error) && !fs::is_directory(name, error))) {
    throw UsageError(fmt::format("-o: expected a folder, found {}", shown(name)));
  }
  fs::create_directories(name, error);
  if (error) throw WorkError(fmt::format("can't make the folder {}: {}", shown(name), error.message()));
  return name;
}

/// Draws what is not there yet. Returns one line for each job that failed.
std::vector<std::string> draw_all(const std::vector<const Job*>& jobs, const fs::path& out, Album& album,
                                  std::size_t threads, bool quiet) {
  std::vector<std::string> failures(jobs.size());
  Progress progress(jobs.size(), quiet);
  in_parallel(jobs.size(), threads, [&](std::size_t i) {
    const Job& job = *jobs[i];
    try {
      album.put(job.showcase->slug, job.key, draw(job, out));
      progress.finished(i, job.showcase->slug);
    } catch (const std::exception& error) {
      failures[i] = fmt::format("{}: {}", job.showcase->slug, error.what());
      progress.finished(i, "");
    }
  });
  std::erase(failures, "");
  return failures;
}

/// "run lengths: (0, 0) to (14, 5)", for the topic's page.
TopicFigure topic_figure(const Job& job, const Card& card, const Trace& trace) {
  const std::string faulty = trace.faulty.empty() ? "" : " (faulty)";
  return {job.topic, fmt::format("{}{}: {}", trace.method_title, faulty, trace.subtitle), card.player};
}

/// Writes the pages of the topics that have figures here. Returns what was written.
std::vector<ManifestFile> write_topics(const std::vector<TopicFigure>& figures, const fs::path& out) {
  std::vector<ManifestFile> written;
  for (const TopicPage& page : topic_pages(figures)) {
    const fs::path path = out / page.path;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
      throw WorkError(
          fmt::format("can't make the folder {}: {}", shown(path.parent_path().string()), error.message()));
    }
    write_output(path.string(), page.html);
    written.push_back(file_state(out, page.path));
  }
  return written;
}

/// The gallery page, of all figures that are there, and the pages of their topics.
void write_index(const std::vector<Job>& jobs, const fs::path& out, Album& album, const std::string& program,
                 bool force) {
  std::string contents = program;
  std::vector<const Job*> present;
  for (const Job& job : jobs) {
    if (!album.knows(job.showcase->slug)) continue;
    present.push_back(&job);
    contents += "\n" + job.showcase->slug + " " + album.key(job.showcase->slug);
  }
  const std::string key = fingerprint(contents);
  if (!force && album.has(index_name, key)) return;
  std::vector<Card> cards;
  std::vector<TopicFigure> figures;
  for (const Job* job : present) {
    // Counting the steps and naming the input is all that this run is for
    const Trace trace = job->topic->run(job->inputs.arguments, {.first = 0, .most = 1});
    cards.push_back(card_of(*job, trace.last));
    figures.push_back(topic_figure(*job, cards.back(), trace));
  }
  std::vector<ManifestFile> written = write_topics(figures, out);
  write_output((out / index_name).string(), gallery_page(cards));
  written.push_back(file_state(out, index_name));
  album.put(index_name, key, std::move(written));
}

}  // namespace

int figures(const Request& request) {
  const std::size_t threads = read_jobs(request);
  const std::string program = program_fingerprint();
  const std::vector<Job> jobs = gallery_jobs(program);
  const std::vector<const Job*> wanted = selected(jobs, request);
  const fs::path out = make_folder(request);
  const bool force = request.has("force");

  Album album(out);
  const std::size_t removed = album.keep_only(jobs);
  std::vector<const Job*> due;
  for (const Job* job : wanted) {
    if (force || !album.has(job->showcase->slug, job->key)) due.push_back(job);
  }
  const std::vector<std::string> failures = draw_all(due, out, album, threads, request.quiet());
  write_index(jobs, out, album, program, force);

  for (const std::string& failure : failures) note("gradus: " + failure);
  if (!request.quiet()) {
    note(fmt::format("{} drawn, {} unchanged, {} removed", due.size() - failures.size(),
                     wanted.size() - due.size(), removed));
  }
  if (!failures.empty()) return 1;
  write_stream(Stream::out, (out / index_name).string() + "\n");
  return 0;
}

}  // namespace gradus::cli
