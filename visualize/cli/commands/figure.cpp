// `gradus figure`: steps of a topic as files.

#include "cli/commands/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/figures/compare.hpp"
#include "cli/files/files.hpp"
#include "cli/files/own_answers.hpp"
#include "cli/terminal/progress.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

constexpr std::string_view step_mark = "{step}";

std::string name_for(std::string output, StepNumber step) {
  const std::string number = text_of(step);
  for (std::size_t at = output.find(step_mark); at != std::string::npos; at = output.find(step_mark, at)) {
    output.replace(at, step_mark.size(), number);
  }
  return output;
}

/// "PDF", "PPTX".
std::string document_name(Format format) {
  std::string name(name_of(format));
  std::ranges::transform(name, name.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
  return name;
}

void refuse_binary_in_terminal(Format format) {
  const bool binary = facts_of(format).pixels || is_document(format);
  if (binary && is_terminal(Stream::out)) {
    throw UsageError(fmt::format("-o: expected a file or a pipe for {}, found a terminal", name_of(format)));
  }
}

// --- Which flags say something about which formats ---------------------------------------------------------

bool drawn_or_played(Format format) { return is_drawn(format) || format == Format::html; }
bool drawn_at_once(Format format) { return is_drawn(format) && !is_film(format); }
bool not_a_model(Format format) { return !is_model(format); }
bool made_of_pixels(Format format) { return facts_of(format).pixels; }

struct FlagUse {
  const char* flag;
  bool (*serves)(Format format);
  const char* expected;
};
constexpr const char* any_picture = "svg, png, pdf, pptx or a film to draw";
constexpr const char* any_figure = "svg, png, pdf, pptx, html or a film";
constexpr const char* any_step = "a format that shows steps";
constexpr const char* any_film = "gif, mp4 or webp";
constexpr FlagUse uses[] = {
    {"panels", drawn_at_once, "svg, png, pdf or pptx"},
    {"compare", drawn_or_played, any_figure},
    {"trace", drawn_or_played, any_figure},
    {"slots", drawn_or_played, any_figure},
    {"no-title", drawn_or_played, any_figure},
    {"theme", drawn_or_played, any_figure},
    {"y", drawn_or_played, any_figure},
    {"title", drawn_or_played, any_figure},
    {"caption", drawn_or_played, any_figure},
    {"size", is_drawn, any_picture},
    {"layout", is_drawn, any_picture},
    {"listing", drawn_or_played, any_figure},
    {"line-numbers", is_drawn, any_picture},
    {"crop", is_drawn, any_picture},
    {"view", is_drawn, any_picture},
    {"background", is_drawn, any_picture},
    {"scale", made_of_pixels, "png, gif, mp4 or webp"},
    {"svg-text", [](Format format) { return format == Format::svg; }, "svg"},
    {"handout", [](Format format) { return format == Format::pdf; }, "pdf"},
    {"paper", [](Format format) { return format == Format::pdf; }, "pdf"},
    {"seconds-per-step", is_film, any_film},
    {"hold-last", is_film, any_film},
    {"transition", is_film, any_film},
    {"fps", [](Format format) { return format == Format::mp4; }, "mp4"},
    {"step", not_a_model, any_step},
    {"steps", not_a_model, any_step},
    {"loop", [](Format format) { return format == Format::gif || format == Format::webp; }, "gif or webp"},
};

/// What a reader who chose no steps should know of a run too long to be kept whole.
void remark_cut(const FigureSpec& spec, const Trace& trace, bool quiet) {
  const std::string remark = cut_remark(trace);
  if (!spec.chooses_steps() && !remark.empty() && !quiet) note(remark);
}

std::string bytes_at(const FigureSpec& spec, Takes& takes, StepNumber step, Format format) {
  return format == Format::pdf ? pages_bytes(spec, takes, {step}) : picture_bytes(spec, takes, step, format);
}

/// How many steps are put into files or frames: of a run without being asked to, and for who asks with
/// --steps.
struct Limit {
  std::string_view of;
  std::int64_t unasked, asked;
};
constexpr Limit most_files{"files", 1000, 100'000};
constexpr Limit most_frames{"frames", 1000, 10'000};

/// The steps to show, refused where they are more than anybody can mean. Throws UsageError.
std::vector<StepNumber> steps_within(const Limit& limit, const FigureSpec& spec, const Takes& takes) {
  if (count_in(spec.steps) > limit.asked) {
    throw UsageError(fmt::format("--steps: expected at most {} {}, found {}", limit.asked, limit.of,
                                 count_in(spec.steps)));
  }
  const std::int64_t last = takes.last();
  if (!spec.chooses_steps() && last >= limit.unasked) {
    throw UsageError(
        fmt::format("-o: expected at most {} {}, found {} steps (--steps 0-{}/{} takes some of them, "
                    "--steps A-B up to {})",
                    limit.unasked, limit.of, last + 1, last, last / limit.unasked + 1, limit.asked));
  }
  return shown_steps(spec, takes);
}

void write_series(const FigureSpec& spec, Takes& takes, Format format, const Output& output,
                  std::span<const std::string> inputs) {
  if (!is_drawn(format) || is_film(format) || format == Format::pptx) {
    throw UsageError(
        fmt::format("-o: expected {} for svg, png or pdf only, found {}", step_mark, shown(output.path)));
  }
  if (spec.panels) {
    throw UsageError(fmt::format("--panels: expected a name without {} for one sheet, found {}", step_mark,
                                 shown(output.path)));
  }
  const std::vector<StepNumber> steps = steps_within(most_files, spec, takes);
  remark_cut(spec, takes.opening(), output.quiet);
  for (const StepNumber step : steps) check_output(name_for(output.path, step), inputs, output.replace);
  NewFiles files;
  Progress progress(steps.size(), output.quiet, Telling::as_a_whole);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string name = name_for(output.path, steps[i]);
    files.add(name, bytes_at(at_step(spec, steps[i]), takes, steps[i], format), output.replace);
    progress.finished(i, name);
  }
  files.commit();
  progress.kept();
}

/// All steps as pages, or the first of them when they are too many for one file. Throws UsageError.
std::vector<StepNumber> pages_of(const FigureSpec& spec, const Takes& takes, Format format) {
  if (count_in(spec.steps) > most_pages) {
    throw UsageError(
        fmt::format("--steps: expected at most {} steps for one {} ({{step}} in the name of -o makes one "
                    "file per step), found {}",
                    most_pages, document_name(format), count_in(spec.steps)));
  }
  std::vector<StepNumber> steps = shown_steps(spec, takes);
  if (static_cast<std::int64_t>(steps.size()) > most_pages)
    steps.resize(static_cast<std::size_t>(most_pages));
  return steps;
}

std::string document(FigureSpec spec, Takes& takes, Format format, bool quiet) {
  const std::vector<StepNumber> steps = pages_of(spec, takes, format);
  if (steps.size() < shown_steps(spec, takes).size()) {
    spec = with_steps(spec, {{steps.front(), steps.back()}});
    if (!quiet) {
      note(fmt::format("steps {} of 0-{}: one {} has at most {} pages; --steps A-B takes others",
                       text_of(spec.steps), takes.last(), document_name(format), most_pages));
    }
  }
  Progress progress(steps.size(), quiet);
  const auto on_drawn = [&progress](std::size_t i) { progress.finished(i, ""); };
  return format == Format::pdf ? pages_bytes(spec, takes, steps, on_drawn)
                               : slides_bytes(spec, takes, steps, on_drawn);
}

std::string table_or_player(const FigureSpec& spec, Takes& takes, Format format, bool quiet) {
  const Trace trace = shown_part(spec, takes, format);
  remark_cut(spec, trace, quiet);
  return trace_bytes(spec, trace, format, "", &takes);
}

std::string film(const FigureSpec& spec, Takes& takes, Format format, bool quiet) {
  const std::vector<StepNumber> steps = steps_within(most_frames, spec, takes);
  remark_cut(spec, takes.opening(), quiet);
  Progress progress(pictures_drawn(film_format(format), steps.size(), spec.film), quiet);
  return film_of(spec, takes, steps, format, [&progress](std::size_t i) { progress.finished(i, ""); });
}

std::string one_file(const FigureSpec& spec, Takes& takes, Format format, bool quiet) {
  if (is_film(format)) return film(spec, takes, format, quiet);
  if (is_document(format)) return document(spec, takes, format, quiet);
  if (is_model(format)) return model_bytes(spec, takes.opening(), format);
  if (!is_drawn(format)) return table_or_player(spec, takes, format, quiet);
  return picture_bytes(spec, takes, shown_step(spec, takes), format);
}

/// The lines that put the written files into a lecture.
std::string snippet_for(SnippetKind kind, const FigureSpec& spec, Takes& takes, Format format,
                        const std::string& output) {
  const Trace& trace = takes.opening();
  const std::string title = spec.look.title.empty() ? trace.title : spec.look.title;
  SnippetFigure figure{std::string(name_of(format)),
                       fmt::format("{} {}", title, trace.subtitle),
                       spec.look.slots.contains(Slot::title),
                       {}};
  const std::string caption = spec.caption.empty() ? "" : spec.caption + " ";
  const auto alt = [&](const std::string& text) { return caption + text; };
  const bool series = output.find(step_mark) != std::string::npos;
  if (!series && format != Format::pdf) {
    const bool one_step = format == Format::svg || format == Format::png;
    figure.steps = {{output, 0, alt(one_step ? takes.figure(shown_step(spec, takes)).sentence : trace.goal)}};
    return snippet_of(kind, figure);
  }
  const std::vector<StepNumber> steps = series ? shown_steps(spec, takes) : pages_of(spec, takes, format);
  if (spec.handout && !series) {
    const std::size_t a_page = spec.handout->figures();
    for (std::size_t at = 0; at < steps.size(); at += a_page) {
      const auto on_page = std::span(steps).subspan(at, std::min(a_page, steps.size() - at));
      const int page = static_cast<int>(figure.steps.size()) + 1;
      figure.steps.push_back({output, page, alt(summary_of(trace, on_page))});
    }
    return snippet_of(kind, figure);
  }
  for (const StepNumber step : steps) {
    const int page = format == Format::pdf ? (series ? 1 : static_cast<int>(figure.steps.size()) + 1) : 0;
    figure.steps.push_back({name_for(output, step), page, alt(takes.figure(step).sentence)});
  }
  return snippet_of(kind, figure);
}

}  // namespace

FigureSpec fitting(FigureSpec spec, Format format) {
  for (const FlagUse& use : uses) {
    if (!use.serves(format)) spec.said.erase(use.flag);
  }
  return spec;
}

void refuse_idle_flags(const Request& request, Format format) {
  for (const FlagUse& use : uses) {
    if (!request.has(use.flag) || use.serves(format)) continue;
    throw UsageError(fmt::format("--{}: expected {}, found {}", use.flag, use.expected, name_of(format)));
  }
}

void write_figure(FigureSpec spec, Format format, const Output& output, std::span<const std::string> inputs,
                  std::optional<SnippetKind> snippet) {
  spec = fitting(std::move(spec), format);
  if (spec.said.contains("paper") && !spec.handout) {
    throw UsageError(fmt::format("--paper: expected --handout with it, found {} alone", spec.paper.name));
  }
  const bool series = output.path.find(step_mark) != std::string::npos;
  if (!series) check_output(output.path, inputs, output.replace);
  if (output.path == dash) refuse_binary_in_terminal(format);
  if (is_film(format)) check_film(spec, format);
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec));
  if (series) {
    write_series(spec, takes, format, output, inputs);
  } else {
    write_output(output.path, one_file(spec, takes, format, output.quiet), output.replace);
    if (output.path != dash && !output.quiet) note(shown_name(output.path));
  }
  if (snippet) write_stream(Stream::out, snippet_for(*snippet, spec, takes, format, output.path));
}

namespace {

/// --snippet; it goes to standard output, so the figure cannot. Throws UsageError.
std::optional<SnippetKind> read_snippet(const Request& request, Format format, const std::string& output) {
  const auto wanted = request.flags.find("snippet");
  if (wanted == request.flags.end()) return std::nullopt;
  const std::vector<std::string> names(std::begin(snippet_names), std::end(snippet_names));
  const auto kind = static_cast<SnippetKind>(choose_name("--snippet", wanted->second, names));
  const auto shown_there = snippet_formats(kind);
  if (std::ranges::find(shown_there, name_of(format)) == shown_there.end()) {
    throw UsageError(fmt::format("--snippet: expected {} to show in {}, found {}",
                                 fmt::join(shown_there, ", "), names[static_cast<std::size_t>(kind)],
                                 name_of(format)));
  }
  if (output == dash) throw UsageError("--snippet: expected a file after -o, found -");
  return kind;
}

/// --trace: our run, and beside it what somebody's own program answered. Its file says the inputs, unless
/// flags do.
int figure_of_answer(const Request& request, Format format, const Output& output,
                     std::optional<SnippetKind> snippet) {
  const NamedAnswer named = named_answer(request.flags.at("trace"));
  AskedRuns runs(*request.topic, read_own_answers(*request.topic, named.path, "--trace"), request.arguments);
  const check::OwnAnswer& answer = find_answer(runs.answers(), named.id);
  FigureSpec spec = read_spec(request, runs.arguments_of(answer));
  set_beside(spec, runs, answer);
  const std::vector<std::string> inputs{named.path};
  write_figure(spec, format, output, inputs, snippet);
  return 0;
}

}  // namespace

int figure(const Request& request) {
  const auto wanted = request.flags.find("output");
  if (wanted == request.flags.end()) {
    throw UsageError("-o: expected a file like line.svg, or - for standard output, found none");
  }
  const Output output{wanted->second, replaces(request.has("force")), request.quiet()};
  const Format format = read_format(request, output.path);
  refuse_idle_flags(request, format);
  const auto snippet = read_snippet(request, format, output.path);
  if (request.has("trace")) return figure_of_answer(request, format, output, snippet);
  const Inputs inputs = read_inputs(*request.topic, opened(request));
  const FigureSpec spec = read_spec(request, inputs.arguments);
  if (!output.quiet) std::ranges::for_each(inputs.remarks, note);
  write_figure(spec, format, output, inputs.files, snippet);
  return 0;
}

}  // namespace gradus::cli
