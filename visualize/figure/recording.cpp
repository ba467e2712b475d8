#include "figure/recording.hpp"

#include <algorithm>

namespace gradus {
namespace {

void widen(std::vector<std::string>& widest, const Row& row) {
  for (std::size_t c = 0; c < std::min(widest.size(), row.size()); ++c) {
    if (row[c].size() > widest[c].size()) widest[c] = row[c];
  }
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
  trace_.widest.assign(trace_.columns.size(), "");
  for (const TraceStep& step : trace_.steps) {
    widen(trace_.widest, step.read);
    widen(trace_.widest, step.row);
    if (step.sentence.size() > trace_.longest_sentence.size()) trace_.longest_sentence = step.sentence;
    const auto place = std::ranges::lower_bound(trace_.lines, step.line);
    if (step.line > 0 && (place == trace_.lines.end() || *place != step.line))
      trace_.lines.insert(place, step.line);
  }
  return std::move(trace_);
}

}  // namespace gradus
