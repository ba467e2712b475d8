#include "cli/figures/figure_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "cairo/cairo_output.hpp"
#include "cairo/colophon_markup.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/figures/panel_sheets.hpp"
#include "cli/files/files.hpp"
#include "cli/files/own_files.hpp"
#include "cli/files/zip.hpp"
#include "figure/text/metrics.hpp"
#include "figure/transition.hpp"
#include "figure/which_steps.hpp"
#include "json/json.hpp"
#include "office/presentation.hpp"
#include "request/names.hpp"
#include "request/played_steps.hpp"
#include "scene/models/model_writers.hpp"
#include "stories/point_text.hpp"
#include "text/text_output.hpp"
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

Colophon colophon_at(const FigureSpec& spec, Takes& takes, StepNumber step) {
  if (spec.panels) return colophon_of_many(spec, takes.opening(), panel_steps(spec, takes));
  const Figure figure = takes.figure(step);
  return colophon_of(spec, *figure.trace, {&step, 1},
                     takes.beside() ? compared_caption(takes, step) : caption_of(figure));
}

/// The step with what a page for print says beneath its sheet.
Figure told_beneath(const FigureSpec& spec, Takes& takes, StepNumber step) {
  if (takes.beside()) {
    Takes& other = *takes.beside();
    const std::string beside = other.figure(pair_with(takes.alignment(), {step.step, 0}).b).sentence;
    Figure figure = takes.figure(step);
    figure.sentence = fmt::format("{} | {}", figure.sentence, beside);
    return figure;
  }
  Figure figure = takes.figure(step);
  if (spec.panels) {
    figure.position = panels_text(spec, takes);
    figure.phase.clear();
    figure.sentence = figure.trace->goal;
  }
  return figure;
}

}  // namespace

FilmFormat film_format(Format format) {
  return format == Format::gif ? FilmFormat::gif : format == Format::mp4 ? FilmFormat::mp4 : FilmFormat::webp;
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

StepNumber telling_step(const Takes& takes) {
  const StepNumber telling = takes.opening().telling;
  return has_step(takes.opening(), telling) ? telling : takes.opening().steps.back().number;
}

StepNumber shown_step(const FigureSpec& spec, const Takes& takes) {
  if (spec.step) return takes.named(*spec.step);
  if (spec.panels) return telling_step(takes);
  if (!spec.chooses_steps()) return takes.beside() ? compared_step(spec, takes) : telling_step(takes);
  if (spec.milestones || count_in(spec.steps) != 1) {
    throw UsageError(
        fmt::format("--steps: expected one step for one picture ({{step}} in the name of -o makes one "
                    "file per step), found {}",
                    shown(spec.said.at("steps"))));
  }
  const StepNumber step = numbers_in(spec.steps).front();
  takes.check(step, "--steps", text_of(spec.steps));
  return step;
}

std::vector<StepNumber> shown_steps(const FigureSpec& spec, const Takes& takes) {
  if (spec.panels) return {telling_step(takes)};
  if (spec.step) return {takes.named(*spec.step)};
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

Sheet sheet_in(const FigureSpec& spec, Takes& takes, StepNumber step, const Look& look) {
  if (spec.panels) return panels_sheet(spec, takes, look);
  if (takes.beside()) return compared_sheet(spec, takes, step, look);
  return lay_out(takes.figure(step), look);
}

Sheet sheet_of(const FigureSpec& spec, Takes& takes, StepNumber step) {
  Sheet sheet;
  try {
    sheet = sheet_in(spec, takes, step, spec.look);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--{}: {}", spec.look.view ? "view" : "size", error.what()));
  }
  if (const auto missing = missing_glyph(sheet)) {
    throw UsageError(fmt::format("figure: expected texts that can be drawn ({}), found {}",
                                 explained(*missing), shown(missing->text)));
  }
  return sheet;
}

std::string picture_bytes(const FigureSpec& spec, Takes& takes, StepNumber step, Format format) {
  return picture_bytes(sheet_of(spec, takes, step), spec, takes, step, format);
}

std::string picture_bytes(const Sheet& sheet, const FigureSpec& spec, Takes& takes, StepNumber step,
                          Format format) {
  const Colophon colophon = colophon_at(spec, takes, step);
  return format == Format::png ? png_of(sheet, finish_of(spec), colophon)
                               : svg_of(sheet, finish_of(spec), colophon);
}

std::string pages_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps,
                        const OnDrawn& on_drawn) {
  const Colophon colophon = colophon_of_many(spec, takes.opening(), steps);
  const auto figure = [&](std::size_t i) {
    if (on_drawn) on_drawn(i);
    return told_beneath(spec, takes, steps[i]);
  };
  if (spec.handout) {
    const Handout handout{
        spec.paper, *spec.handout, spec.look, colophon.command,
        [&](const Figure& shown, const Look& look) { return sheet_in(spec, takes, shown.number, look); }};
    const auto page = [&](std::size_t i) { return handout_page(handout, i, steps.size(), figure); };
    return pdf_of(handout_page_count(handout, steps.size()), page, finish_of(spec), colophon);
  }
  const auto page = [&](std::size_t i) {
    if (on_drawn) on_drawn(i);
    return sheet_of(spec, takes, steps[i]);
  };
  return pdf_of(steps.size(), page, finish_of(spec), colophon);
}

std::string slides_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps,
                         const OnDrawn& on_drawn) {
  const Colophon colophon = colophon_of_many(spec, takes.opening(), steps);
  Finish finish = finish_of(spec);
  const auto step = [&](std::size_t i) {
    if (on_drawn) on_drawn(i);
    const Figure figure = told_beneath(spec, takes, steps[i]);
    return PresentedStep{sheet_of(spec, takes, steps[i]), caption_of(figure), figure.sentence};
  };
  // The slide has the ground; the pixels are for who can't show the vectors, on a large screen, too
  finish.transparent = true;
  finish.scale = 2;
  const auto draw = [&finish](const Sheet& part) {
    return PictureBytes{svg_of(part, finish, {}), png_of(part, finish, {})};
  };
  std::vector<ZipEntry> entries;
  for (PackagePart& part :
       presentation_of(steps.size(), step, draw, finish.theme, {colophon, markup_of(colophon)})) {
    entries.push_back({std::move(part.name), std::move(part.bytes), part.stored});
  }
  return zip_of(entries);
}

namespace {

/// Neighbouring sheets of a film, each laid out but once while it is needed.
class TwoSheets {
 public:
  explicit TwoSheets(std::function<Sheet(std::size_t)> make) : make_(std::move(make)) {}
  const Sheet& at(std::size_t i) {
    auto& [number, sheet] = kept_[i % 2];
    if (number != i) {
      sheet = make_(i);
      number = i;
    }
    return sheet;
  }

 private:
  std::function<Sheet(std::size_t)> make_;
  std::array<std::pair<std::optional<std::size_t>, Sheet>, 2> kept_;
};

}  // namespace

void check_film(const FigureSpec& spec, Format format) {
  check_film(film_format(format), spec.film, spec.transparent);
  constexpr double most_pixels = 3840.0 * 2160;
  const double width = spec.look.width * spec.scale, height = spec.look.height * spec.scale;
  if (width * height <= most_pixels) return;
  throw UsageError(
      fmt::format("-o: expected frames of at most {:.0f} pixels, as 3840 x 2160 has, for a film (--size, "
                  "--scale), found {:.0f} x {:.0f}",
                  most_pixels, width, height));
}

std::string film_of(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps, Format format,
                    const OnDrawn& on_drawn) {
  check_film(spec, format);
  const Finish finish = finish_of(spec);
  std::size_t drawn = 0;
  const auto picture_of = [&](const Sheet& sheet) {
    Image image = image_of(sheet, finish);
    if (on_drawn) on_drawn(drawn++);
    return image;
  };
  TwoSheets sheets([&](std::size_t i) { return sheet_of(spec, takes, steps[i]); });
  const auto frame = [&](std::size_t i) { return picture_of(sheets.at(i)); };
  const auto between = [&](std::size_t i, double share) {
    return picture_of(in_between(sheets.at(i), sheets.at(i + 1), share));
  };
  return film_bytes(film_format(format), steps.size(), frame, spec.film,
                    colophon_of_many(spec, takes.opening(), steps), between);
}

namespace {

/// The trace as the reader wants it in a player.
Trace turned(const FigureSpec& spec, Trace trace) {
  trace.grid.y_up = spec.look.y_up.value_or(trace.grid.y_up);
  if (!spec.look.title.empty()) trace.title = spec.look.title;
  return trace;
}

/// The trace on a grid that holds the other one's cells, too.
Trace widened(Trace trace, const Trace& other) {
  if (!trace.grid.axes || !other.grid.axes) return trace;
  Window& cells = trace.grid.cells;
  cells = {glm::min(cells.lower, other.grid.cells.lower), glm::max(cells.upper, other.grid.cells.upper)};
  return trace;
}

/// A run as a text, and whether a last line names the command that makes it.
struct TextWriter {
  Format format;
  std::string (*write)(const Trace& trace);
  bool names_command;
};

const TextWriter* writer_of(Format format) {
  static constexpr std::array<TextWriter, 5> writers{{
      {Format::csv, csv_of, false},
      {Format::md, markdown_of, true},
      {Format::tex, latex_of, true},
      {Format::json, run_json, false},
      {Format::txt, [](const Trace& trace) { return text_of(trace, false); }, true},
  }};
  const auto found = std::ranges::find(writers, format, &TextWriter::format);
  return found == writers.end() ? nullptr : &*found;
}

/// Both runs side by side: their drawings, for there is no room for listings and tables.
std::string players_page(const FigureSpec& spec, const Trace& trace, const Takes& takes,
                         const Colophon& colophon, PlayerOptions options) {
  const Trace& other = takes.beside()->opening();
  const Trace second = turned(spec, widened(other, trace));
  const PlayedBeside beside{second, command_of("figure", *spec.compare->topic, spec.compare->arguments),
                            takes.alignment()};
  options.slots.erase(Slot::listing);
  options.slots.erase(Slot::table);
  options.beside = &beside;
  return player_page(turned(spec, widened(trace, other)), colophon, options);
}

/// Throws UsageError for more steps than a page with the player takes, some 2 kB each.
void check_played(const FigureSpec& spec, const Takes& takes) {
  constexpr std::int64_t asked = 20'000;
  if (count_in(spec.steps) > asked) {
    throw UsageError(
        fmt::format("--steps: expected at most {} for a page, found {}", asked, count_in(spec.steps)));
  }
  if (spec.chooses_steps() || takes.last() < most_played) return;
  throw UsageError(fmt::format(
      "-o: expected at most {} steps for a page, found {} (--steps 0-{} takes the first of them, --steps A-B "
      "up to {})",
      most_played, takes.last() + 1, most_played - 1, asked));
}

}  // namespace

std::string model_bytes(const FigureSpec& spec, const Trace& trace, Format format) {
  if (!trace.mesh) {
    throw UsageError(fmt::format("-o: expected a topic whose result is a surface for {}, found {}",
                                 name_of(format), trace.topic));
  }
  const Mesh mesh = mesh_of(trace.mesh->points, trace.mesh->faces);
  const std::string comment = visible(command_of(spec));
  switch (format) {
    case Format::obj:
      return pipeline::obj_of(mesh, comment);
    case Format::ply:
      return pipeline::ply_of(mesh, comment);
    default:
      return pipeline::stl_of(mesh, comment);
  }
}

std::string trace_bytes(const FigureSpec& spec, const Trace& trace, Format format,
                        const std::string& topic_page, const Takes* takes) {
  if (const TextWriter* writer = writer_of(format)) {
    const std::string text = writer->write(trace);
    return writer->names_command ? text + closing_line(name_of(format), command_of(spec)) : text;
  }
  const std::vector<StepNumber> ends{{trace.steps.front().number.step, 0},
                                     {trace.steps.back().number.step, 0}};
  PlayerOptions options{.slots = spec.look.slots,
                        .theme = spec.said.contains("theme") ? spec.theme->name : "",
                        .topic_page = topic_page};
  const Colophon colophon = colophon_of_many(spec, trace, ends);
  if (takes && takes->beside()) return players_page(spec, trace, *takes, colophon, std::move(options));
  if (!spec.look.y_up && spec.look.title.empty()) return player_page(trace, colophon, options);
  return player_page(turned(spec, trace), colophon, options);
}

Trace shown_part(const FigureSpec& spec, const Takes& takes, Format format) {
  if (format == Format::html) check_played(spec, takes);
  const std::vector<StepRange> ranges = chosen_ranges(spec, takes);
  if (ranges.empty()) return takes.opening();
  const bool played = ranges.size() == 1 && ranges.front().stride == 1 && ranges.front().first.fine == 0;
  if (format == Format::html && !played) {
    throw UsageError(fmt::format("--steps: expected one range like 3-9 for a player, found {}",
                                 shown(spec.said.at(spec.step ? "step" : "steps"))));
  }
  return takes.part(ranges);
}

}  // namespace gradus::cli
