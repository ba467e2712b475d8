#pragma once
// A figure as a file's bytes: what it shows, in which format, and the command that makes it again.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/takes.hpp"
#include "figure/colophon.hpp"
#include "figure/figure.hpp"
#include "theme/theme.hpp"

namespace gradus::cli {

enum class Format { svg, png, pdf, html, csv, json, txt };
std::string_view name_of(Format format);
/// The names of all formats, in their order.
std::span<const std::string> format_names();
/// By the file name's ending; nothing for an unknown one.
std::optional<Format> format_by_ending(std::string_view path);
/// By the file's first bytes; nothing for a file that holds no command.
std::optional<Format> format_by_content(std::string_view bytes);

/// A figure has one page a step in PDF; more than this are not put into one file.
inline constexpr std::int64_t most_pages = 1000;

/// All that a figure's canonical command says, but the topic's arguments.
struct FigureSpec {
  const TopicEntry* topic = nullptr;
  Arguments arguments;
  std::optional<StepNumber> step;
  std::vector<StepRange> steps;
  Look look;
  const Theme* theme = nullptr;
};

/// Takes --step, --steps, --slots, --theme and --size from the request; what it does not name stays. Throws
/// UsageError.
void apply_flags(FigureSpec& spec, const Request& request);
FigureSpec read_spec(const Request& request, const Arguments& arguments);
/// --format, or the ending of the output's name; SVG for standard output. Throws UsageError.
Format read_format(const Request& request, const std::string& output);

/// "gradus figure <topic> --from 0,0 --to 7,3 --step 4 --theme dark": all arguments, and what differs from
/// the defaults of a figure.
std::string command_of(const FigureSpec& spec);

/// The spec of one step of it.
FigureSpec at_step(FigureSpec spec, StepNumber step);

/// The one step that an SVG or PNG shows: --step, else the last. Throws UsageError when there is none.
StepNumber shown_step(const FigureSpec& spec, const Takes& takes);
/// The steps that a document or a series of files has: --steps or --step, else all whole ones that are
/// recorded.
std::vector<StepNumber> shown_steps(const FigureSpec& spec, const Takes& takes);

/// SVG or PNG.
std::string picture_bytes(const FigureSpec& spec, Takes& takes, StepNumber step, Format format);
/// PDF, one page a step.
std::string pages_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps);
/// HTML, CSV, JSON, text: made from a trace. It is the opening of the run, or the part that the spec wants.
std::string trace_bytes(const FigureSpec& spec, const Trace& trace, Format format);
/// The trace that those show; throws UsageError for steps that the run, or the format, has not.
Trace shown_part(const FigureSpec& spec, const Takes& takes, Format format);

}  // namespace gradus::cli
