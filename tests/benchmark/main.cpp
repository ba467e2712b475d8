// gradus-bench: what `gradus bench` runs. Measures the registered methods, prints tables, draws charts.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "benchmark/report.hpp"
#include "cairo/cairo_output.hpp"
#include "cli/command_line/choices.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/guarded.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "cli/terminal/progress.hpp"
#include "request/inputs.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"
#include "theme/theme.hpp"

namespace gradus::bench {
namespace {

namespace fs = std::filesystem;

/// The subjects whose topics were named; all when none was.
std::vector<const Subject*> chosen(const cli::Request& request) {
  std::vector<const Subject*> wanted;
  for (const std::string& word : request.operands) {
    // Subjects that are no topics ("figures") by their whole name
    auto found = std::ranges::find(subjects(), folded(word), &Subject::topic);
    if (found != subjects().end()) {
      wanted.push_back(&*found);
      continue;
    }
    const std::string& topic = find_topic(word).name;
    found = std::ranges::find(subjects(), topic, &Subject::topic);
    if (found == subjects().end()) throw UsageError(fmt::format("TOPIC: {} has no benchmark", topic));
    wanted.push_back(&*found);
  }
  if (wanted.empty()) {
    for (const Subject& subject : subjects()) wanted.push_back(&subject);
  }
  return wanted;
}

double positive(const cli::Request& request, const std::string& flag, double usual, double most) {
  const auto given = request.flags.find(flag);
  if (given == request.flags.end()) return usual;
  const Read<Number> read = read_number(given->second);
  const Number* number = std::get_if<Number>(&read);
  if (!number || !(number->value > 0) || number->value > most) {
    throw UsageError(
        fmt::format("--{}: expected a number above 0, up to {}, found {}", flag, most, shown(given->second)));
  }
  return number->value;
}

const Theme& theme_of(const cli::Request& request) {
  const auto given = request.flags.find("theme");
  if (given == request.flags.end()) return themes().front();
  return themes()[choose_value("theme", given->second, cli::choices_of("theme"))];
}

/// The charts of some findings, as files' names and bytes.
void draw(const Findings& found, const Theme& theme, const fs::path& folder, cli::NewFiles& files,
          cli::Replace replace) {
  const auto draw_one = [&](const std::optional<plot::Chart>& chart, const char* kind) {
    if (!chart) return;
    const Sheet sheet = plot::sheet_of(*chart);
    const Colophon colophon{chart->title,
                            chart->subtitle + (chart->advice.empty() ? "" : " · " + chart->advice), "", ""};
    const std::string name = fmt::format("{}-{}", found.subject->topic, kind);
    files.add((folder / (name + ".svg")).string(), svg_of(sheet, theme, colophon), replace);
    files.add((folder / (name + ".png")).string(), png_of(sheet, theme, colophon), replace);
  };
  draw_one(error_chart(found), "error");
  draw_one(size_chart(found), "size");
  draw_one(refinement_chart(found), "refined");
}

/// Makes the folder, and refuses one with somebody's own files where ours would lie.
void prepare(const std::string& folder, const std::vector<const Subject*>& wanted, cli::Replace replace) {
  cli::make_folder(folder, "--output");
  if (replace == cli::Replace::anything) return;
  const auto check = [&](const std::string& name) {
    cli::check_replaced((fs::path(folder) / name).string(), "--output");
  };
  check("bench.json");
  for (const Subject* subject : wanted) {
    for (const char* kind : {"error", "size", "refined"}) {
      for (const char* form : {"svg", "png"}) check(fmt::format("{}-{}.{}", subject->topic, kind, form));
    }
  }
}

/// Measures a subject against its peer. Throws UsageError where that is missing and asked for.
Findings duels_of(const Subject& subject, const Effort& effort, const cli::Request& request) {
  const auto need = [&](bool there) {
    if (request.has("require-peers") && !there)
      throw UsageError(fmt::format("--require-peers: what {} is compared with is not there", subject.topic));
  };
  need(subject.peer_is_built);
  Findings found{&subject, {}};
  cli::Progress progress(subject.duel_count, request.quiet());
  std::size_t done = 0;
  found.duels = subject.duels(effort, [&] { progress.finished(done++, ""); }, found.peer);
  need(std::ranges::all_of(found.duels, [](const Duel& duel) { return duel.peer_ms.has_value(); }));
  return found;
}

/// Measures a subject's methods.
Findings methods_of(const Subject& subject, const Effort& effort, const cli::Request& request) {
  std::vector<Case> cases = subject.cases();
  cli::Progress progress(cases.size() * static_cast<std::size_t>(effort.repetitions), request.quiet());
  std::size_t done = 0;
  return {&subject, measure(std::move(cases), effort, [&] { progress.finished(done++, ""); })};
}

/// What a file of an earlier run says of the wanted subjects; of all that it has when none was named.
std::vector<Findings> saved(const cli::Request& request, const std::vector<const Subject*>& wanted) {
  for (const char* measuring : {"seconds", "repetitions", "json", "require-peers"}) {
    if (request.has(measuring))
      throw UsageError(fmt::format("--{}: nothing is measured with --from", measuring));
  }
  const std::string& path = request.flags.at("from");
  std::vector<Findings> all;
  try {
    all = findings_in(cli::read_input(path, "--from"), subjects());
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--from: expected a bench.json of gradus bench, found {} ({})", shown(path),
                                 error.what()));
  }
  if (request.operands.empty()) return all;
  std::vector<Findings> chosen;
  for (const Subject* subject : wanted) {
    const auto found = std::ranges::find(all, subject, &Findings::subject);
    if (found == all.end())
      throw UsageError(fmt::format("TOPIC: {} is not in {}", subject->topic, shown(path)));
    chosen.push_back(*found);
  }
  return chosen;
}

int bench(const cli::Request& request) {
  const std::vector<const Subject*> wanted = chosen(request);
  Effort effort;
  effort.seconds = positive(request, "seconds", effort.seconds, 60);
  effort.repetitions = static_cast<int>(positive(request, "repetitions", effort.repetitions, 1000));
  const Theme& theme = theme_of(request);
  // Before hours of measuring could be lost
  const cli::Replace replace = cli::replaces(request.has("force"));
  if (request.has("output")) prepare(request.flags.at("output"), wanted, replace);
  const auto tell = [&](const Findings& found) {
    if (!request.has("json")) cli::write_stream(cli::Stream::out, table_of(found) + "\n");
  };
  std::vector<Findings> all;
  if (request.has("from")) {
    all = saved(request, wanted);
    std::ranges::for_each(all, tell);
  } else {
    // A duel forks, and a child waits for ever for the threads of a peer's library that its parent has run:
    // so these come before all that is measured in this process
    std::vector<const Subject*> in_turn = wanted;
    std::ranges::stable_partition(in_turn, [](const Subject* subject) { return subject->duels != nullptr; });
    for (const Subject* subject : in_turn) {
      all.push_back(subject->duels ? duels_of(*subject, effort, request)
                                   : methods_of(*subject, effort, request));
      tell(all.back());
    }
  }
  if (request.has("json")) cli::write_stream(cli::Stream::out, json_of(all));
  if (!request.has("output")) return 0;
  const fs::path folder = request.flags.at("output");
  cli::NewFiles files;
  for (const Findings& found : all) draw(found, theme, folder, files, replace);
  if (!request.has("from")) files.add((folder / "bench.json").string(), json_of(all), replace);
  files.commit();
  return 0;
}

}  // namespace
}  // namespace gradus::bench

int main(int argc, char** argv) {
  gradus::cli::prepare_process();
  std::vector<std::string> words{"bench"};
  words.insert(words.end(), argv + std::min(argc, 1), argv + argc);
  return gradus::cli::guarded("gradus bench", [&] {
    const gradus::cli::Request request = gradus::cli::read_request(words);
    if (request.has("help")) return gradus::cli::help(request);
    return gradus::bench::bench(request);
  });
}
