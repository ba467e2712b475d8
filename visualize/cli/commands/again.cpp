// `gradus again`: a figure or a rendered picture made again from the command in its own metadata.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cairo/cairo_output.hpp"
#include "cairo/colophon_markup.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/figure.hpp"
#include "cli/commands/render.hpp"
#include "cli/files/files.hpp"
#include "cli/files/shipped.hpp"
#include "request/fingerprint.hpp"
#include "request/names.hpp"
#include "request/notation_reader.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// Whether the fingerprint of a file is one of those that the figure carries.
bool is_listed(const std::string& hash, std::string_view hashes) {
  return hashes.find(hash) != std::string_view::npos;
}

/// An input file goes by its name without folders: it lies beside the figure, in the current folder, or came
/// with the program.
FoundFile find_input(const std::string& name, const std::string& flag, const fs::path& figure,
                     const std::string& hashes) {
  const std::string base = fs::path(name).filename().string();
  std::string changed;
  const auto is_it = [&](const fs::path& candidate) {
    std::error_code error;
    if (!fs::is_regular_file(candidate, error)) return false;
    if (is_listed(fingerprint(read_input(candidate.string(), flag)), hashes)) return true;
    changed = candidate.string();
    return false;
  };
  for (const fs::path& candidate : {figure.parent_path() / base, fs::path(base)}) {
    if (is_it(candidate)) return candidate.string();
  }
  const std::string example = shipped_example(base);
  if (changed.empty() && is_it(example)) return example;
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

/// Where it goes when nobody says where: beside the file.
Output output_for(const Request& request, const std::string& path) {
  const std::string usual = path == dash ? std::string(dash) : beside(path);
  return {request.has("output") ? request.flags.at("output") : usual, replaces(request.has("force")),
          request.quiet()};
}

/// Throws UsageError when the input is no longer what it was.
void check_hash(const std::string& found, const Colophon& colophon) {
  if (found == colophon.input_hash) return;
  throw UsageError(fmt::format("again: expected the input with which the figure was made ({}), found {}",
                               colophon.input_hash, found));
}

/// The request that stands in the file. It says what to draw, never where to.
Request recorded_request(const Colophon& colophon, const std::string& path) {
  const auto refuse = [&path] {
    throw UsageError(fmt::format(
        "again: expected a figure with a `gradus figure` or `gradus render` command in it, found {}",
        shown(path)));
  };
  const auto words = shell_words(colophon.command);
  if (!words || words->size() < 3 || (*words)[0] != "gradus") refuse();
  const bool is_figure = (*words)[1] == "figure";
  if (!is_figure && (*words)[1] != "render") refuse();
  Request recorded = read_request({words->begin() + 1, words->end()});
  if (is_figure ? !recorded.topic || !recorded.operands.empty() : recorded.operands.size() != 1) refuse();
  if (recorded.has("output") || recorded.has("format")) refuse();
  // A figure holds its notation itself
  if (recorded.has("notation") && is_notation_file(recorded.flags.at("notation"))) {
    throw UsageError(
        fmt::format("again: expected a figure that holds its notation, found one that names the file {}",
                    shown_name(recorded.flags.at("notation"))));
  }
  if (recorded.has("trace")) {
    throw UsageError(
        fmt::format("again: expected a figure of our own runs, found one with an answer beside them (`gradus "
                    "figure --trace "
                    "{}` makes it anew)",
                    shown_name(recorded.flags.at("trace"))));
  }
  return recorded;
}

/// A picture of a model: the flags that `gradus render` has too may change it.
int render_again(Request recorded, const Colophon& colophon, const Request& request,
                 const std::string& path) {
  if (recorded.operands[0] == dash) {
    throw UsageError("again: expected a picture of a model from a file, found one from standard input");
  }
  const std::vector<Flag>& known = recorded.command->flags;
  for (const auto& [flag, value] : request.flags) {
    const bool common = std::ranges::find(common_flags(), flag, &Flag::name) != common_flags().end();
    if (!common && std::ranges::find(known, flag, &Flag::name) == known.end()) {
      throw UsageError(
          fmt::format("--{}: expected a figure, found the rendered picture {}", flag, shown(path)));
    }
    recorded.flags[flag] = value;
  }
  if (!request.labels.empty()) {
    throw UsageError(fmt::format("--label: expected a figure, found the rendered picture {}", shown(path)));
  }
  const Output output = output_for(request, path);
  check_rendered_output(recorded, output.path);
  const auto find = [&](const std::string& name, const std::string& flag) {
    return find_input(name, flag, path, colophon.input_hash);
  };
  const auto check = [&](const RenderBrief& brief) {
    check_hash(brief.colophon.input_hash, colophon);
    std::vector<std::string> inputs = brief.files;
    inputs.push_back(path);
    check_output(output.path, inputs, output.replace);
  };
  make_rendered(recorded, output, find, check);
  return 0;
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
  if (!recorded.topic) return render_again(recorded, *colophon, request, path);
  Inputs inputs =
      read_inputs(*recorded.topic, recorded.arguments, [&](const std::string& name, const std::string& flag) {
        return find_input(name, flag, path, colophon->input_hash);
      });
  check_hash(input_hash(inputs.arguments), *colophon);
  FigureSpec spec = read_spec(recorded, inputs.arguments);
  apply_flags(spec, request);
  const bool named = request.has("output");
  const Output output = output_for(request, path);
  const Format format =
      request.has("format") || (named && output.path != dash) ? read_format(request, output.path) : *content;
  refuse_idle_flags(request, format);
  inputs.files.push_back(path);
  if (!output.quiet) std::ranges::for_each(inputs.remarks, note);
  write_figure(spec, format, output, inputs.files);
  return 0;
}

}  // namespace gradus::cli
