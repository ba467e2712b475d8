// gradus-stress: what `gradus stress` runs. Attacks the registered promises, reports, draws the worst inputs.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/guarded.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/figures/figure_spec.hpp"
#include "cli/files/files.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"
#include "stress/attack.hpp"

namespace gradus::stress {
namespace {

namespace fs = std::filesystem;

std::vector<const Domain*> chosen(const cli::Request& request) {
  std::vector<const Domain*> wanted;
  for (const std::string& word : request.operands) {
    // Some parts of the pipeline make promises, too, and are no topics yet
    auto found = std::ranges::find(domains(), word, &Domain::topic);
    if (found == domains().end()) found = std::ranges::find(domains(), find_topic(word).name, &Domain::topic);
    if (found == domains().end()) {
      throw UsageError(fmt::format("TOPIC: {} has no stress test", find_topic(word).name));
    }
    wanted.push_back(&*found);
  }
  if (wanted.empty()) {
    for (const Domain& domain : domains()) wanted.push_back(&domain);
  }
  return wanted;
}

std::string number(double value) {
  if (std::isinf(value)) return "wrong";
  return fmt::format("{:.6g}", value);
}

/// `gradus figure` of an input, as the words of a command line.
std::vector<std::string> figure_words(const Domain& domain, const Property& property, const Input& input) {
  if (!property.arguments) return {};
  std::vector<std::string> words{"figure", domain.topic};
  for (const auto& [flag, value] : property.arguments(input))
    words.push_back(fmt::format("--{}={}", flag, value));
  return words;
}

void draw(const std::vector<std::string>& words, const fs::path& path, cli::NewFiles& files,
          cli::Replace replace) {
  try {
    const cli::Request request = cli::read_request(words);
    const Inputs inputs = cli::read_inputs(*request.topic, request.arguments, cli::as_named);
    const cli::FigureSpec spec = cli::read_spec(request, inputs.arguments);
    Takes takes(*spec.topic, spec.arguments);
    files.add(path.string(), cli::picture_bytes(spec, takes, cli::shown_step(spec, takes), cli::Format::svg),
              replace);
  } catch (const std::exception& error) {
    cli::note(fmt::format("gradus stress: {} is not drawn: {}", path.filename().string(), error.what()));
  }
}

void tell(const Domain& domain, const Finding& finding, const Input& small) {
  const Property& p = *finding.property;
  std::string line = fmt::format("{} {:<22} {:>10} cases  worst {:>10} {}", finding.broken() ? 'X' : ' ',
                                 p.name, finding.cases, number(finding.worst), p.unit);
  line += std::isinf(p.bound) ? "  (measured)" : fmt::format("  (at most {})", number(p.bound));
  line += fmt::format("\n    {}\n", p.states);
  if (!finding.input.empty()) {
    line += fmt::format("    {}: gradus stress {} --replay {}:{}\n", finding.origin, domain.topic, p.name,
                        text_of(small));
  }
  cli::write_stream(cli::Stream::out, line);
}

/// What is promised, and the largest error that keeps it.
int list(const std::vector<const Domain*>& wanted) {
  std::string lines;
  for (const Domain* domain : wanted) {
    lines += domain->topic + "\n";
    for (const Property& p : domain->properties) {
      const bool counted = p.bound > 0 && std::isfinite(p.bound);
      lines += fmt::format("  {:<22} {}", p.name, p.states);
      lines += counted ? fmt::format(" (at most {} {})\n", number(p.bound), p.unit) : "\n";
    }
  }
  cli::write_stream(cli::Stream::out, lines);
  return 0;
}

/// One property with one input: its numbers, or the name of a trap.
int replay(const std::vector<const Domain*>& wanted, const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  for (const Domain* domain : wanted) {
    const auto property = std::ranges::find(domain->properties, name, &Property::name);
    if (property == domain->properties.end()) continue;
    const auto trap = std::ranges::find(property->traps, rest, &Trap::name);
    const auto input = trap != property->traps.end() ? std::optional(trap->input) : input_in(rest);
    if (!input) continue;
    if (input->size() != property->numbers) {
      throw UsageError(
          fmt::format("--replay: {} takes {} numbers, found {}", name, property->numbers, input->size()));
    }
    const double error = property->error(*input);
    cli::write_stream(cli::Stream::out, fmt::format("{}: {} {} (at most {})\n", name, number(error),
                                                    property->unit, number(property->bound)));
    return error > property->bound ? 1 : 0;
  }
  throw UsageError(fmt::format(
      "--replay: expected PROPERTY:NUMBERS as a report prints it, or PROPERTY:TRAP, found {}", shown(text)));
}

fs::path figure_path(const fs::path& folder, const Domain& domain, const Property& property) {
  return folder / fmt::format("{}-{}.svg", domain.topic, property.name);
}

/// Makes the folder, and refuses one with somebody's own files where ours would lie.
void prepare(const std::string& folder, const std::vector<const Domain*>& wanted, cli::Replace replace) {
  cli::make_folder(folder, "--output");
  if (replace == cli::Replace::anything) return;
  for (const Domain* domain : wanted) {
    for (const Property& property : domain->properties) {
      cli::check_replaced(figure_path(folder, *domain, property).string(), "--output");
    }
  }
}

int stress(const cli::Request& request) {
  const std::vector<const Domain*> wanted = chosen(request);
  if (request.has("list")) return list(wanted);
  if (request.has("replay")) return replay(wanted, request.flags.at("replay"));
  const auto whole = [&](const char* flag, std::int64_t usual, std::int64_t least, std::int64_t most) {
    if (!request.has(flag)) return usual;
    const auto value = whole_number(request.flags.at(flag));
    if (!value || *value < least || *value > most) {
      throw UsageError(fmt::format("--{}: expected a whole number from {} to {}, found {}", flag, least, most,
                                   shown(request.flags.at(flag))));
    }
    return *value;
  };
  const auto seed = static_cast<std::uint64_t>(whole("random-seed", 1, 0, INT64_MAX));
  const std::int64_t seconds = whole("seconds", 10, 1, 1'000'000);
  std::size_t properties = 0;
  for (const Domain* domain : wanted) properties += domain->properties.size();
  const std::chrono::duration<double> share(static_cast<double>(seconds) / static_cast<double>(properties));

  const cli::Replace replace = cli::replaces(request.has("force"));
  if (request.has("output")) prepare(request.flags.at("output"), wanted, replace);
  std::uint64_t cases = 0, broken = 0;
  cli::NewFiles files;
  for (const Domain* domain : wanted) {
    cli::write_stream(cli::Stream::out, domain->topic + "\n");
    for (const Property& property : domain->properties) {
      const auto end = std::chrono::steady_clock::now() + share;
      // Sixteen cases at least, however long the traps took
      const auto more = [&](std::uint64_t i) {
        return i == 0 || i % 16 || std::chrono::steady_clock::now() < end;
      };
      const Finding finding = attack(property, seed, more);
      // A broken promise must stay broken, a worst error nearly as bad
      const double least = finding.broken() ? std::nextafter(property.bound, wrong) : 0.99 * finding.worst;
      const Input small = finding.input.empty() ? Input{} : shrunk(property, finding.input, least);
      tell(*domain, finding, small);
      cases += finding.cases;
      broken += finding.broken() ? 1u : 0u;
      if (!request.has("output") || small.empty()) continue;
      const std::vector<std::string> words = figure_words(*domain, property, small);
      const fs::path path = figure_path(request.flags.at("output"), *domain, property);
      if (!words.empty()) draw(words, path, files, replace);
    }
  }
  files.commit();
  cli::write_stream(cli::Stream::out, fmt::format("{} cases, {} of {} promises broken (--random-seed {})\n",
                                                  cases, broken, properties, seed));
  return broken ? 1 : 0;
}

}  // namespace
}  // namespace gradus::stress

int main(int argc, char** argv) {
  gradus::cli::prepare_process();
  std::vector<std::string> words{"stress"};
  words.insert(words.end(), argv + std::min(argc, 1), argv + argc);
  return gradus::cli::guarded("gradus stress", [&] {
    const gradus::cli::Request request = gradus::cli::read_request(words);
    if (request.has("help")) return gradus::cli::help(request);
    return gradus::stress::stress(request);
  });
}
