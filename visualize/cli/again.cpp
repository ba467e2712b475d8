// `gradus again`: a figure made again from the command in its own metadata.

#include <fmt/format.h>

#include <filesystem>

#include "cairo/cairo_output.hpp"
#include "cli/errors.hpp"
#include "cli/figure.hpp"
#include "cli/files.hpp"
#include "cli/inputs.hpp"
#include "cli/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// Whether the fingerprint of a file is one of those that the figure carries.
bool is_listed(const std::string& hash, std::string_view hashes) {
  return hashes.find(hash) != std::string_view::npos;
}

/// An input file goes by its name without folders: it lies beside the figure, or in the current folder.
std::string find_input(const std::string& name, const std::string& flag, const fs::path& figure,
                       const std::string& hashes) {
  const std::string base = fs::path(name).filename().string();
  std::string changed;
  for (const fs::path& candidate : {figure.parent_path() / base, fs::path(base)}) {
    std::error_code error;
    if (!fs::is_regular_file(candidate, error)) continue;
    if (is_listed(fingerprint(read_input(candidate.string(), flag)), hashes)) return candidate.string();
    changed = candidate.string();
  }
  if (changed.empty()) {
    throw UsageError(
        fmt::format("{}: expected the file {} beside the figure or in the current folder, found none", flag,
                    shown(base)));
  }
  throw UsageError(fmt::format("{}: expected the file with which the figure was made ({}), found another {}",
                               flag, hashes, shown(changed)));
}

/// "some/line.svg" -> "some/line-again.svg".
std::string beside(const std::string& path) {
  const fs::path file(path);
  return (file.parent_path() / (file.stem().string() + "-again" + file.extension().string())).string();
}

/// The request that stands in the file. It says what to draw, never where to.
Request recorded_request(const Colophon& colophon, const std::string& path) {
  const auto refuse = [&path] {
    throw UsageError(
        fmt::format("again: expected a figure with a `gradus figure` command in it, found {}", shown(path)));
  };
  const auto words = shell_words(colophon.command);
  if (!words || words->size() < 3 || (*words)[0] != "gradus" || (*words)[1] != "figure") refuse();
  Request recorded = read_request({words->begin() + 1, words->end()});
  if (!recorded.topic || !recorded.operands.empty() || recorded.has("output") || recorded.has("format"))
    refuse();
  return recorded;
}

}  // namespace

int again(const Request& request) {
  const std::string& path = request.operands[0];
  const std::string bytes = read_input(path, "again");
  const auto content = format_by_content(bytes);
  const auto colophon = content ? colophon_in(bytes) : std::nullopt;
  if (!colophon) {
    throw UsageError(
        fmt::format("again: expected a figure made by gradus (SVG, PNG, PDF, player or film), found {}",
                    path == dash ? "something else" : shown(path)));
  }
  const Request recorded = recorded_request(*colophon, path);
  Inputs inputs =
      read_inputs(*recorded.topic, recorded.arguments, [&](const std::string& name, const std::string& flag) {
        return find_input(name, flag, path, colophon->input_hash);
      });
  if (input_hash(inputs.arguments) != colophon->input_hash) {
    throw UsageError(fmt::format("again: expected the input with which the figure was made ({}), found {}",
                                 colophon->input_hash, input_hash(inputs.arguments)));
  }
  FigureSpec spec = read_spec(recorded, inputs.arguments);
  apply_flags(spec, request);
  const bool named = request.has("output");
  const std::string output = named          ? request.flags.at("output")
                             : path == dash ? std::string(dash)
                                            : beside(path);
  const Format format =
      request.has("format") || (named && output != dash) ? read_format(request, output) : *content;
  refuse_idle_flags(request, format);
  inputs.files.push_back(path);
  write_figure(spec, format, output, inputs.files, request.quiet());
  return 0;
}

}  // namespace gradus::cli
