// `gradus figure`: steps of a topic as files.

#include "cli/figure.hpp"

#include <fmt/format.h>

#include "cli/errors.hpp"
#include "cli/files.hpp"
#include "cli/inputs.hpp"
#include "cli/progress.hpp"
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

bool is_drawn(Format format) {
  return format == Format::svg || format == Format::png || format == Format::pdf;
}

void refuse_binary_in_terminal(Format format) {
  if ((format == Format::png || format == Format::pdf) && is_terminal(Stream::out)) {
    throw UsageError(fmt::format("-o: expected a file or a pipe for {}, found a terminal", name_of(format)));
  }
}

std::string bytes_at(const FigureSpec& spec, Takes& takes, StepNumber step, Format format) {
  return format == Format::pdf ? pages_bytes(spec, takes, {step}) : picture_bytes(spec, takes, step, format);
}

void write_series(const FigureSpec& spec, Takes& takes, Format format, const std::string& output,
                  std::span<const std::string> inputs, bool quiet) {
  if (!is_drawn(format)) {
    throw UsageError(
        fmt::format("-o: expected {} for svg, png or pdf only, found {}", step_mark, shown(output)));
  }
  const std::vector<StepNumber> steps = shown_steps(spec, takes);
  if (const std::string remark = cut_remark(takes.opening());
      !remark.empty() && !spec.step && spec.steps.empty() && !quiet) {
    note(remark);
  }
  for (const StepNumber step : steps) check_output(name_for(output, step), inputs);
  NewFiles files;
  Progress progress(steps.size(), quiet);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string name = name_for(output, steps[i]);
    files.add(name, bytes_at(at_step(spec, steps[i]), takes, steps[i], format));
    progress.finished(i, name);
  }
  files.commit();
}

/// All steps as pages, or the first of them when they are too many for one file.
std::string document(FigureSpec spec, Takes& takes, bool quiet) {
  if (count_in(spec.steps) > most_pages) {
    throw UsageError(
        fmt::format("--steps: expected at most {} steps for one PDF ({{step}} in the name of -o makes one "
                    "file a step), found {}",
                    most_pages, count_in(spec.steps)));
  }
  std::vector<StepNumber> steps = shown_steps(spec, takes);
  if (static_cast<std::int64_t>(steps.size()) > most_pages) {
    steps.resize(static_cast<std::size_t>(most_pages));
    spec.steps = {{steps.front(), steps.back()}};
    if (!quiet) {
      note(fmt::format("steps {} of 0-{}: one PDF has at most {} pages; --steps A-B takes others",
                       text_of(spec.steps), takes.last(), most_pages));
    }
  }
  return pages_bytes(spec, takes, steps);
}

std::string table_or_player(const FigureSpec& spec, Takes& takes, Format format, bool quiet) {
  const Trace trace = shown_part(spec, takes, format);
  const bool chosen = spec.step || !spec.steps.empty();
  if (const std::string remark = cut_remark(trace); !chosen && !remark.empty() && !quiet) note(remark);
  return trace_bytes(spec, trace, format);
}

std::string one_file(const FigureSpec& spec, Takes& takes, Format format, bool quiet) {
  if (format == Format::pdf) return document(spec, takes, quiet);
  if (!is_drawn(format)) return table_or_player(spec, takes, format, quiet);
  return picture_bytes(spec, takes, shown_step(spec, takes), format);
}

}  // namespace

void refuse_idle_flags(const Request& request, Format format) {
  if (is_drawn(format)) return;
  for (const char* flag : {"slots", "theme", "size"}) {
    if (!request.has(flag)) continue;
    throw UsageError(fmt::format("--{}: expected svg, png or pdf to draw, found {}", flag, name_of(format)));
  }
}

void write_figure(FigureSpec spec, Format format, const std::string& output,
                  std::span<const std::string> inputs, bool quiet) {
  if (!is_drawn(format)) spec.look = {}, spec.theme = &themes().front();
  const bool series = output.find(step_mark) != std::string::npos;
  if (!series) check_output(output, inputs);
  if (output == dash) refuse_binary_in_terminal(format);
  Takes takes(*spec.topic, spec.arguments);
  if (series) return write_series(spec, takes, format, output, inputs, quiet);
  write_output(output, one_file(spec, takes, format, quiet));
  if (output != dash && !quiet) note(output);
}

int figure(const Request& request) {
  const auto output = request.flags.find("output");
  if (output == request.flags.end()) {
    throw UsageError("-o: expected a file like line.svg, or - for standard output, found none");
  }
  const Format format = read_format(request, output->second);
  refuse_idle_flags(request, format);
  const Inputs inputs = read_inputs(*request.topic, request.arguments);
  write_figure(read_spec(request, inputs.arguments), format, output->second, inputs.files, request.quiet());
  return 0;
}

}  // namespace gradus::cli
