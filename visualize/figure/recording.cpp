#include "figure/recording.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gradus {
namespace {

void widen(std::vector<std::string>& widest, const Row& row) {
  for (std::size_t c = 0; c < std::min(widest.size(), row.size()); ++c) {
    if (row[c].size() > widest[c].size()) widest[c] = row[c];
  }
}

std::string heading(const Trace& trace, const Column& column) {
  const std::string key = fmt::format("{}.column.{}", trace.topic, column.id);
  return trace.wording.language().has(key) ? trace.wording.say(key) : trace.wording.symbol(column.id);
}

}  // namespace

bool TraceWriter::keep(StepNumber number, const Delta& delta) {
  if (trace_.steps.empty() && number == StepNumber{}) trace_.before = Canvas(trace_.grid.cells);
  if (number.step < recording_.first) {
    trace_.before.apply(delta);
    return false;
  }
  if (full()) return false;
  changes_ += delta.size();
  return true;
}

Trace TraceWriter::finish() && {
  trace_.last = next_ - 1;
  for (Column& column : trace_.columns) {
    if (column.name.empty()) column.name = heading(trace_, column);
  }
  measure_texts(trace_);
  return std::move(trace_);
}

void measure_texts(Trace& trace) {
  trace.lines.clear();
  trace.longest_sentence.clear();
  trace.widest.assign(trace.columns.size(), "");
  for (const TraceStep& step : trace.steps) {
    widen(trace.widest, step.read);
    widen(trace.widest, step.row);
    if (step.sentence.size() > trace.longest_sentence.size()) trace.longest_sentence = step.sentence;
    const auto place = std::ranges::lower_bound(trace.lines, step.line);
    if (step.line > 0 && (place == trace.lines.end() || *place != step.line))
      trace.lines.insert(place, step.line);
  }
}

}  // namespace gradus
