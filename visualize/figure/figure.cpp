#include "figure/figure.hpp"

#include <algorithm>

#include "figure/which_steps.hpp"

namespace gradus {
namespace {

/// Rows a figure could ever show; older ones are only said to exist.
constexpr std::size_t most_rows = 40;

/// The step before this one at its own level: for a milestone the last milestone, for a finer event any.
const TraceStep* previous_step(const Trace& trace, std::size_t index) {
  const bool fine = trace.steps[index].number.fine != 0;
  while (index-- > 0) {
    if (fine || trace.steps[index].number.fine == 0) return &trace.steps[index];
  }
  return nullptr;
}

std::vector<Figure::ListingLine> listing_at(const Trace& trace, std::size_t index) {
  std::vector<Figure::ListingLine> lines;
  for (SourceLine& line : shown_listing(trace)) lines.push_back({std::move(line), Emphasis::none});
  const auto mark = [&](int line, Emphasis emphasis) {
    const auto marked = code_line(trace.listing, line);
    if (!marked) return;
    const int number = trace.listing[*marked].number;
    std::ranges::find(lines, number, [](const auto& l) { return l.line.number; })->emphasis = emphasis;
  };
  const TraceStep* previous = previous_step(trace, index);
  mark(previous ? previous->line : 0, Emphasis::weak);
  mark(trace.steps[index].line, Emphasis::strong);
  return lines;
}

void mark_changes(std::vector<Figure::TableRow>& rows) {
  Figure::TableRow& now = rows.back();
  now.changed.assign(now.cells.size(), false);
  if (rows.size() < 2) return;
  const Row& before = rows[rows.size() - 2].cells;
  for (std::size_t c = 1; c < now.cells.size(); ++c) {
    now.changed[c] = !now.cells[c].empty() && (c >= before.size() || now.cells[c] != before[c]);
  }
}

std::vector<Figure::TableRow> rows_at(const Trace& trace, std::size_t index) {
  // Back to the oldest step that can still be seen, then forward again
  std::size_t first = index, seen = 0;
  for (std::size_t i = index + 1; i-- > 0 && seen < most_rows;) {
    first = i;
    if (!trace.steps[i].row.empty()) ++seen;
  }
  std::vector<Figure::TableRow> rows;
  for (std::size_t i = first; i <= index; ++i) {
    const TraceStep& step = trace.steps[i];
    for (Figure::TableRow& row : rows) row.emphasis = Emphasis::none;
    if (!step.read.empty() && !rows.empty()) rows.back() = {step.read, Emphasis::weak, {}};
    if (step.row.empty()) continue;
    rows.push_back({step.row, Emphasis::strong, {}});
  }
  if (!rows.empty() && rows.back().emphasis == Emphasis::strong) mark_changes(rows);
  return rows;
}

/// The title, and what is wrong with the run where something is.
std::string full_title(const Trace& trace) {
  if (trace.faulty.empty()) return trace.title;
  return trace.wording.say("figure.faulty_title", fmt::arg("title", trace.title),
                           fmt::arg("what", trace.faulty));
}

}  // namespace

Figure figure_of(const Trace& trace, Playhead& playhead, StepNumber number) {
  const std::size_t index = index_of(trace, number);
  const TraceStep& step = trace.steps[index];
  Figure figure;
  figure.trace = &trace;
  figure.canvas = &playhead.at(index);
  figure.number = number;
  figure.focus = step.focus;
  figure.title = trace.title;
  figure.subtitle = trace.subtitle;
  figure.sentence = step.sentence;
  figure.position =
      trace.wording.say("figure.step", fmt::arg("number", text_of(number)), fmt::arg("last", trace.last));
  figure.phase = step.phase;
  figure.listing = listing_at(trace, index);
  figure.rows = rows_at(trace, index);
  return figure;
}

std::string steps_text(const Trace& trace, std::span<const StepNumber> steps) {
  const auto last = fmt::arg("last", trace.last);
  const std::string first = text_of(steps.front()), end = text_of(steps.back());
  if (steps.size() == 1) return trace.wording.say("figure.one_step", fmt::arg("number", first), last);
  return trace.wording.say("figure.some_steps", fmt::arg("first", first), fmt::arg("end", end), last);
}

std::string heading_of(const Trace& trace, std::span<const StepNumber> steps) {
  return trace.wording.say("figure.heading", fmt::arg("title", full_title(trace)),
                           fmt::arg("steps", steps_text(trace, steps)));
}

std::string summary_of(const Trace& trace, std::span<const StepNumber> steps) {
  return trace.wording.say("figure.summary", fmt::arg("heading", heading_of(trace, steps)),
                           fmt::arg("method", trace.method_title), fmt::arg("goal", trace.goal),
                           fmt::arg("input", trace.subtitle));
}

std::string caption_of(const Figure& figure) {
  const Trace& trace = *figure.trace;
  return trace.wording.say("figure.caption", fmt::arg("title", full_title(trace)),
                           fmt::arg("method", trace.method_title),
                           fmt::arg("steps", steps_text(trace, {&figure.number, 1})),
                           fmt::arg("sentence", figure.sentence), fmt::arg("input", trace.subtitle));
}

}  // namespace gradus
