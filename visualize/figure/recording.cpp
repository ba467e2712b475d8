#include "figure/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "figure/legend.hpp"
#include "figure/text/metrics.hpp"
#include "figure/text/typesetting.hpp"

namespace gradus {
namespace {

void widen(Trace& trace, const Row& row) {
  for (std::size_t c = 0; c < std::min(trace.widest.size(), row.size()); ++c) {
    const Face face = trace.columns[c].numeric ? Face::mono_bold : Face::bold;
    std::string& widest = trace.widest[c];
    if (text_width(row[c], face, 1) > text_width(widest, face, 1)) widest = row[c];
  }
}

/// A row's texts, and how often each has changed so far.
void count_changes(std::vector<int>& changes, Row& last, const Row& row) {
  last.resize(changes.size());
  for (std::size_t c = 0; c < std::min(changes.size(), row.size()); ++c) {
    if (row[c].empty() || row[c] == last[c]) continue;
    ++changes[c];
    last[c] = row[c];
  }
}

std::string heading(const Trace& trace, const Column& column) {
  const std::string key = fmt::format("{}.column.{}", trace.topic, column.id);
  return trace.wording.language().has(key) ? trace.wording.say(key) : trace.wording.symbol(column.id);
}

/// The symbols that decisions ask about or answer with, in the order of their appearance.
std::vector<std::string> decided_quantities(const Trace& trace) {
  std::map<std::string, std::string> symbols;  // by what the reader calls them
  for (const std::string& symbol : topic_symbols(trace.topic)) symbols[trace.wording.symbol(symbol)] = symbol;
  std::vector<std::string> found;
  std::set<std::string> looked_at;
  const auto look_at = [&](const std::string& text) {
    if (!looked_at.insert(text).second) return;
    for (const Token& token : tokens_of(text)) {
      const auto symbol = symbols.find(text.substr(token.begin, token.end - token.begin));
      if (symbol != symbols.end() && std::ranges::find(found, symbol->second) == found.end())
        found.push_back(symbol->second);
    }
  };
  constexpr std::size_t enough = 500;  // of a long run: what it asks is known by then
  for (const TraceStep& step : std::span(trace.steps).first(std::min(trace.steps.size(), enough))) {
    if (!step.decision) continue;
    look_at(step.decision->question);
    for (const std::string& answer : step.decision->answers) look_at(answer);
  }
  return found;
}

std::string joined(const std::string& list, const std::string& more) {
  return list.empty() ? more : list + ", " + more;
}

/// "d = p in the code; there vectors are columns": the reader's names for what the listing calls otherwise,
/// and what else the figure shows otherwise; empty where there is nothing to say.
std::string told_of_the_code(const Trace& trace) {
  std::set<std::string> listed;
  for (const SourceLine& line : trace.listing) {
    for (const Token& token : tokens_of(line.text))
      listed.insert(line.text.substr(token.begin, token.end - token.begin));
  }
  std::string names, what;
  for (const auto& [symbol, text] : trace.wording.renamed()) {
    if (listed.contains(symbol)) names = joined(names, fmt::format("{} = {}", text, symbol));
  }
  for (const auto& [symbol, text] : trace.named_in_the_code)
    names = joined(names, fmt::format("{} = {}", text, symbol));
  for (const std::string& difference : trace.in_the_code) what = joined(what, difference);
  if (names.empty() && what.empty()) return "";
  const std::string_view key = what.empty()    ? "figure.in_the_code"
                               : names.empty() ? "figure.otherwise_in_the_code"
                                               : "figure.named_and_otherwise_in_the_code";
  const std::vector<NamedText> values{{"names", names}, {"what", what}};
  return trace.wording.fill(key, values);
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
  settle_numbers(trace_);
  if (const std::string others = told_of_the_code(trace_); !others.empty())
    trace_.method_title += " · " + others;
  if (trace_.quantities.empty()) trace_.quantities = decided_quantities(trace_);
  measure_texts(trace_);
  return std::move(trace_);
}

void measure_texts(Trace& trace) {
  trace.lines.clear();
  trace.longest_sentence.clear();
  trace.widest.assign(trace.columns.size(), "");
  trace.changes.assign(trace.columns.size(), 0);
  trace.content = content_of(trace);
  trace.legends = legends_of(trace);
  Row last;
  double longest = 0;
  for (const TraceStep& step : trace.steps) {
    widen(trace, step.read);
    widen(trace, step.row);
    count_changes(trace.changes, last, step.read);
    count_changes(trace.changes, last, step.row);
    if (const double width = text_width(step.sentence, Face::sans, 1); width > longest) {
      longest = width;
      trace.longest_sentence = step.sentence;
    }
    const auto place = std::ranges::lower_bound(trace.lines, step.line);
    if (step.line > 0 && (place == trace.lines.end() || *place != step.line))
      trace.lines.insert(place, step.line);
  }
}

}  // namespace gradus
