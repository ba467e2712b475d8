#include "cli/figure_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "cairo/cairo_output.hpp"
#include "cli/errors.hpp"
#include "cli/files.hpp"
#include "cli/inputs.hpp"
#include "cli/names.hpp"
#include "stories/point_text.hpp"
#include "text/text_output.hpp"
#include "web/json.hpp"
#include "web/player.hpp"

namespace gradus::cli {
namespace {

// --- Flags
// -------------------------------------------------------------------------------------------------------

std::set<Slot> read_slots(std::string_view text) {
  std::vector<std::string> names;
  for (const Slot slot : all_slots) names.emplace_back(name_of(slot));
  std::set<Slot> slots;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    slots.insert(all_slots[choose_name("--slots", trimmed(text.substr(at, end - at)), names)]);
    at = end + 1;
  }
  return slots;
}

const Theme& read_theme(std::string_view text) {
  std::vector<std::string> names;
  for (const Theme& theme : themes()) names.push_back(theme.name);
  return themes()[choose_name("--theme", text, names)];
}

/// "1280x720".
std::pair<double, double> read_size(std::string_view text) {
  constexpr std::int64_t least = 160, most = 8192;
  const std::string word = folded(text);
  const std::size_t cross = word.find('x');
  const auto side = [](std::string_view digits) -> std::optional<std::int64_t> {
    const auto value = whole_number(digits);
    return value && least <= *value && *value <= most ? value : std::nullopt;
  };
  const auto width = side(std::string_view(word).substr(0, cross));
  const auto height =
      cross == std::string::npos ? std::nullopt : side(std::string_view(word).substr(cross + 1));
  if (!width || !height) {
    throw UsageError(
        fmt::format("--size: expected a width and a height of {} to {} pixels like 1280x720, found {}", least,
                    most, shown(text)));
  }
  return {static_cast<double>(*width), static_cast<double>(*height)};
}

// --- Texts
// -------------------------------------------------------------------------------------------------------

std::string titled(const Trace& trace, const std::string& steps) {
  const std::string fault = trace.faulty.empty() ? "" : fmt::format(" (faulty: {})", trace.faulty);
  return fmt::format("{}{}, {}", trace.title, fault, steps);
}

Colophon colophon_of(const FigureSpec& spec, const Trace& trace, const std::string& steps,
                     const std::string& caption) {
  return {titled(trace, steps), caption, command_of(spec), input_hash(spec.arguments)};
}

std::string steps_text(const std::vector<StepNumber>& steps, std::int64_t last) {
  if (steps.size() == 1) return fmt::format("step {} of {}", text_of(steps.front()), last);
  return fmt::format("steps {} to {} of {}", text_of(steps.front()), text_of(steps.back()), last);
}

Colophon colophon_of_many(const FigureSpec& spec, const Trace& trace, const std::string& steps) {
  return colophon_of(spec, trace, steps,
                     fmt::format("{}, {}. {} Input: {}.", titled(trace, steps), trace.method_title,
                                 trace.goal, trace.subtitle));
}

}  // namespace

std::span<const std::string> format_names() {
  static const std::vector<std::string> names{"svg", "png", "pdf", "html", "csv", "json", "txt"};
  return names;
}

std::string_view name_of(Format format) { return format_names()[static_cast<std::size_t>(format)]; }

std::optional<Format> format_by_ending(std::string_view path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string_view::npos || path[dot] == '/') return std::nullopt;
  const std::string ending = folded(path.substr(dot + 1));
  const auto found = std::ranges::find(format_names(), ending);
  if (found == format_names().end()) return std::nullopt;
  return static_cast<Format>(found - format_names().begin());
}

std::optional<Format> format_by_content(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return Format::png;
  if (bytes.starts_with("%PDF")) return Format::pdf;
  const std::string start = folded(bytes.substr(0, 512));
  if (start.find("<!doctype html") != std::string::npos || start.find("<html") != std::string::npos) {
    return Format::html;
  }
  if (start.find("<svg") != std::string::npos) return Format::svg;
  return std::nullopt;
}

void apply_flags(FigureSpec& spec, const Request& request) {
  const auto value = [&request](const char* name) -> const std::string* {
    const auto found = request.flags.find(name);
    return found == request.flags.end() ? nullptr : &found->second;
  };
  if (value("step") && value("steps"))
    throw UsageError("--step: expected either this or --steps, found both");
  if (const std::string* text = value("step")) {
    spec.step = read_step(*text);
    spec.steps.clear();
  }
  if (const std::string* text = value("steps")) {
    spec.steps = read_steps(*text);
    spec.step.reset();
  }
  if (const std::string* text = value("slots")) spec.look.slots = read_slots(*text);
  if (const std::string* text = value("theme")) spec.theme = &read_theme(*text);
  if (const std::string* text = value("size")) std::tie(spec.look.width, spec.look.height) = read_size(*text);
}

FigureSpec read_spec(const Request& request, const Arguments& arguments) {
  FigureSpec spec;
  spec.topic = request.topic;
  spec.arguments = arguments;
  spec.theme = &themes().front();
  apply_flags(spec, request);
  return spec;
}

Format read_format(const Request& request, const std::string& output) {
  if (const auto wanted = request.flags.find("format"); wanted != request.flags.end()) {
    return static_cast<Format>(choose_name("--format", wanted->second, format_names()));
  }
  if (output == dash) return Format::svg;
  const auto format = format_by_ending(output);
  if (!format) {
    throw UsageError(fmt::format("-o: expected a name that ends in .{} (or --format), found {}",
                                 fmt::join(format_names(), ", ."), shown(output)));
  }
  return *format;
}

std::string command_of(const FigureSpec& spec) {
  std::string line = command_of("figure", *spec.topic, spec.arguments);
  if (spec.step) line += " --step " + text_of(*spec.step);
  if (!spec.steps.empty()) line += " --steps " + text_of(spec.steps);
  const Look standard;
  if (spec.look.slots != standard.slots) {
    std::vector<std::string_view> names;
    for (const Slot slot : spec.look.slots) names.push_back(name_of(slot));
    line += fmt::format(" --slots {}", fmt::join(names, ","));
  }
  if (spec.theme != &themes().front()) line += " --theme " + spec.theme->name;
  if (spec.look.width != standard.width || spec.look.height != standard.height) {
    line += fmt::format(" --size {:.0f}x{:.0f}", spec.look.width, spec.look.height);
  }
  return line;
}

FigureSpec at_step(FigureSpec spec, StepNumber step) {
  spec.step = step;
  spec.steps.clear();
  return spec;
}

StepNumber shown_step(const FigureSpec& spec, const Takes& takes) {
  if (spec.step) {
    takes.check(*spec.step, "--step", text_of(*spec.step));
    return *spec.step;
  }
  const std::vector<StepNumber> steps = spec.steps.empty()          ? std::vector{StepNumber{takes.last(), 0}}
                                        : count_in(spec.steps) == 1 ? numbers_in(spec.steps)
                                                                    : std::vector<StepNumber>{};
  if (steps.empty()) {
    throw UsageError(
        fmt::format("--steps: expected one step for one picture ({{step}} in the name of -o makes one "
                    "file a step), found {}",
                    shown(text_of(spec.steps))));
  }
  takes.check(steps.front(), "--steps", text_of(spec.steps));
  return steps.front();
}

std::vector<StepNumber> shown_steps(const FigureSpec& spec, const Takes& takes) {
  if (spec.step) return {shown_step(spec, takes)};
  // Checked before they are listed: a range may be as long as its numbers are large
  for (const StepRange& range : spec.steps) {
    for (const StepNumber end : {range.first, range.last}) takes.check(end, "--steps", text_of(spec.steps));
  }
  if (!spec.steps.empty()) return numbers_in(spec.steps);
  std::vector<StepNumber> steps;
  for (const TraceStep& step : takes.opening().steps) {
    if (step.number.fine == 0) steps.push_back(step.number);
  }
  return steps;
}

std::string picture_bytes(const FigureSpec& spec, Takes& takes, StepNumber step, Format format) {
  const Figure figure = takes.figure(step);
  const Sheet sheet = lay_out(figure, spec.look);
  const std::string steps = steps_text({step}, takes.last());
  const Colophon colophon = colophon_of(spec, *figure.trace, steps, caption_of(figure));
  return format == Format::png ? png_of(sheet, *spec.theme, colophon) : svg_of(sheet, *spec.theme, colophon);
}

std::string pages_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps) {
  const auto page = [&](std::size_t i) { return lay_out(takes.figure(steps[i]), spec.look); };
  return pdf_of(steps.size(), page, *spec.theme,
                colophon_of_many(spec, takes.opening(), steps_text(steps, takes.last())));
}

std::string trace_bytes(const FigureSpec& spec, const Trace& trace, Format format) {
  switch (format) {
    case Format::csv:
      return csv_of(trace);
    case Format::json:
      return run_json(trace);
    case Format::txt:
      return text_of(trace, false);
    default:
      break;
  }
  const std::vector<StepNumber> ends{{trace.steps.front().number.step, 0},
                                     {trace.steps.back().number.step, 0}};
  return player_page(trace, colophon_of_many(spec, trace, steps_text(ends, trace.last)));
}

Trace shown_part(const FigureSpec& spec, const Takes& takes, Format format) {
  std::vector<StepRange> ranges = spec.steps;
  if (spec.step) ranges = {{*spec.step, *spec.step}};
  if (ranges.empty()) return takes.opening();
  for (const StepRange& range : ranges) {
    for (const StepNumber end : {range.first, range.last}) {
      takes.check(end, spec.step ? "--step" : "--steps",
                  spec.step ? text_of(*spec.step) : text_of(spec.steps));
    }
  }
  const bool played = ranges.size() == 1 && ranges.front().stride == 1 && ranges.front().first.fine == 0;
  if (format == Format::html && !played) {
    throw UsageError(
        fmt::format("--steps: expected one range like 3-9 for a player, found {}", shown(text_of(ranges))));
  }
  return takes.part(ranges);
}

}  // namespace gradus::cli
