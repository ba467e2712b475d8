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
#include "cli/own_files.hpp"
#include "figure/metrics.hpp"
#include "stories/point_text.hpp"
#include "text/text_output.hpp"
#include "web/json.hpp"
#include "web/player.hpp"

namespace gradus::cli {
namespace {

// --- Texts ---------------------------------------------------------------------------------------

Colophon colophon_of(const FigureSpec& spec, const Trace& trace, std::span<const StepNumber> steps,
                     const std::string& description) {
  std::string heading = heading_of(trace, steps);
  const std::size_t title = spec.look.title.empty() ? std::string::npos : heading.find(trace.title);
  if (title != std::string::npos) heading.replace(title, trace.title.size(), spec.look.title);
  const std::string caption = spec.caption.empty() ? "" : spec.caption + " ";
  return {heading, caption + description, command_of(spec), input_hash(spec.arguments)};
}

Colophon colophon_of_many(const FigureSpec& spec, const Trace& trace, std::span<const StepNumber> steps) {
  return colophon_of(spec, trace, steps, summary_of(trace, steps));
}

}  // namespace

bool is_film(Format format) {
  return format == Format::gif || format == Format::mp4 || format == Format::webp;
}

bool is_drawn(Format format) {
  return format == Format::svg || format == Format::png || format == Format::pdf || is_film(format);
}

std::span<const std::string> format_names() {
  static const std::vector<std::string> names{"svg", "png",  "pdf", "html", "csv", "md",
                                              "tex", "json", "txt", "gif",  "mp4", "webp"};
  return names;
}

FilmFormat film_format(Format format) {
  return format == Format::gif ? FilmFormat::gif : format == Format::mp4 ? FilmFormat::mp4 : FilmFormat::webp;
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
  if (bytes.starts_with("GIF8")) return Format::gif;
  if (bytes.starts_with("RIFF") && bytes.size() > 8 && bytes.substr(8).starts_with("WEBP"))
    return Format::webp;
  if (bytes.size() > 8 && bytes.substr(4).starts_with("ftyp")) return Format::mp4;
  const std::string start = folded(bytes.substr(0, 512));
  if (start.find("<!doctype html") != std::string::npos || start.find("<html") != std::string::npos) {
    return Format::html;
  }
  if (start.find("<svg") != std::string::npos) return Format::svg;
  return std::nullopt;
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

StepNumber shown_step(const FigureSpec& spec, const Takes& takes) {
  if (spec.step) {
    takes.check(*spec.step, "--step", text_of(*spec.step));
    return *spec.step;
  }
  if (!spec.chooses_steps()) return {takes.last(), 0};
  if (spec.milestones || count_in(spec.steps) != 1) {
    throw UsageError(
        fmt::format("--steps: expected one step for one picture ({{step}} in the name of -o makes one "
                    "file a step), found {}",
                    shown(spec.said.at("steps"))));
  }
  const StepNumber step = numbers_in(spec.steps).front();
  takes.check(step, "--steps", text_of(spec.steps));
  return step;
}

std::vector<StepNumber> shown_steps(const FigureSpec& spec, const Takes& takes) {
  if (spec.step) return {shown_step(spec, takes)};
  // Checked before they are listed: a range may be as long as its numbers are large
  for (const StepRange& range : spec.steps) {
    for (const StepNumber end : {range.first, range.last}) takes.check(end, "--steps", text_of(spec.steps));
  }
  if (!spec.steps.empty()) return numbers_in(spec.steps);
  if (spec.milestones) return milestones_of(takes.opening());
  std::vector<StepNumber> steps;
  for (const TraceStep& step : takes.opening().steps) {
    if (step.number.fine == 0) steps.push_back(step.number);
  }
  return steps;
}

Sheet sheet_of(const Figure& figure, const FigureSpec& spec) {
  Sheet sheet;
  try {
    sheet = lay_out(figure, spec.look);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--view: {}", error.what()));
  }
  if (const auto missing = missing_glyph(sheet)) {
    throw UsageError(fmt::format("figure: expected texts that can be drawn ({}), found {}",
                                 explained(*missing), shown(missing->text)));
  }
  return sheet;
}

std::string picture_bytes(const FigureSpec& spec, Takes& takes, StepNumber step, Format format) {
  const Figure figure = takes.figure(step);
  const Sheet sheet = sheet_of(figure, spec);
  const Colophon colophon = colophon_of(spec, *figure.trace, {&step, 1}, caption_of(figure));
  return format == Format::png ? png_of(sheet, finish_of(spec), colophon)
                               : svg_of(sheet, finish_of(spec), colophon);
}

std::string pages_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps,
                        const OnDrawn& on_drawn) {
  const Colophon colophon = colophon_of_many(spec, takes.opening(), steps);
  const auto figure = [&](std::size_t i) {
    if (on_drawn) on_drawn(i);
    return takes.figure(steps[i]);
  };
  if (spec.handout) {
    const Handout handout{spec.paper, *spec.handout, spec.look, colophon.command};
    const auto page = [&](std::size_t i) { return handout_page(handout, i, steps.size(), figure); };
    return pdf_of(handout_page_count(handout, steps.size()), page, finish_of(spec), colophon);
  }
  const auto page = [&](std::size_t i) { return sheet_of(figure(i), spec); };
  return pdf_of(steps.size(), page, finish_of(spec), colophon);
}

std::string film_of(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps, Format format,
                    const OnDrawn& on_drawn) {
  const Finish finish = finish_of(spec);
  std::size_t drawn = 0;
  const auto frame = [&](std::size_t i) {
    Image image = image_of(sheet_of(takes.figure(steps[i]), spec), finish);
    if (on_drawn) on_drawn(drawn++);
    return image;
  };
  return film_bytes(film_format(format), steps.size(), frame, spec.film,
                    colophon_of_many(spec, takes.opening(), steps));
}

std::string trace_bytes(const FigureSpec& spec, const Trace& trace, Format format,
                        const std::string& topic_page) {
  switch (format) {
    case Format::csv:
      return csv_of(trace);
    case Format::md:
      return markdown_of(trace) + closing_line("md", command_of(spec));
    case Format::tex:
      return latex_of(trace) + closing_line("tex", command_of(spec));
    case Format::json:
      return run_json(trace);
    case Format::txt:
      return text_of(trace, false) + closing_line("txt", command_of(spec));
    default:
      break;
  }
  const std::vector<StepNumber> ends{{trace.steps.front().number.step, 0},
                                     {trace.steps.back().number.step, 0}};
  const PlayerOptions options{spec.look.slots, spec.said.contains("theme") ? spec.theme->name : "",
                              topic_page};
  const Colophon colophon = colophon_of_many(spec, trace, ends);
  if (!spec.look.y_up && spec.look.title.empty()) return player_page(trace, colophon, options);
  Trace turned = trace;
  turned.grid.y_up = spec.look.y_up.value_or(trace.grid.y_up);
  if (!spec.look.title.empty()) turned.title = spec.look.title;
  return player_page(turned, colophon, options);
}

Trace shown_part(const FigureSpec& spec, const Takes& takes, Format format) {
  std::vector<StepRange> ranges = spec.steps;
  if (spec.step) ranges = {{*spec.step, *spec.step}};
  if (spec.milestones) {
    for (const StepNumber step : milestones_of(takes.opening())) ranges.push_back({step, step});
  }
  if (ranges.empty()) return takes.opening();
  for (const StepRange& range : ranges) {
    for (const StepNumber end : {range.first, range.last}) {
      takes.check(end, spec.step ? "--step" : "--steps",
                  spec.step ? text_of(*spec.step) : text_of(spec.steps));
    }
  }
  const bool played = ranges.size() == 1 && ranges.front().stride == 1 && ranges.front().first.fine == 0;
  if (format == Format::html && !played) {
    throw UsageError(fmt::format("--steps: expected one range like 3-9 for a player, found {}",
                                 shown(spec.said.at(spec.step ? "step" : "steps"))));
  }
  return takes.part(ranges);
}

}  // namespace gradus::cli
