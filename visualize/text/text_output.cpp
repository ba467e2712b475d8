#include "text/text_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "figure/text/metrics.hpp"
#include "figure/text/number_text.hpp"
#include "text/escape.hpp"
#include "text/table.hpp"

namespace gradus {
namespace {

/// What the step's row looks like once its test has been read: the row that a later step completes.
std::vector<Row> completed_rows(const Trace& trace, std::vector<const TraceStep*>& owners) {
  std::vector<Row> rows;
  for (const TraceStep& step : trace.steps) {
    if (!step.read.empty() && !rows.empty()) rows.back() = step.read;
    if (step.row.empty()) continue;
    rows.push_back(step.row);
    owners.push_back(&step);
  }
  return rows;
}

/// Plain digits for programs: the typographic minus is for people.
std::string plain(std::string text) {
  constexpr std::string_view minus = "−";
  for (std::size_t at = text.find(minus); at != std::string::npos; at = text.find(minus, at + 1)) {
    text.replace(at, minus.size(), "-");
  }
  return text;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string value_text(const Value& value) {
  struct Visitor {
    std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
    std::string operator()(double v) const { return fmt::format("{}", v == 0 ? 0 : v); }  // -0, too
    std::string operator()(bool v) const { return v ? "yes" : "no"; }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(ivec2 v) const { return fmt::format("({}, {})", v.x, v.y); }
  };
  return std::visit(Visitor{}, value);
}

std::string text_of(const Trace& trace, bool color) {
  const auto bold = [color](const std::string& text) { return color ? "\033[1m" + text + "\033[0m" : text; };
  const auto dim = [color](const std::string& text) { return color ? "\033[2m" + text + "\033[0m" : text; };
  std::string out = fmt::format("{} {} · {}\n", bold(trace.title), trace.subtitle, trace.method_title);
  if (!trace.faulty.empty()) {
    out += trace.wording.say("figure.faulty", fmt::arg("what", trace.faulty)) + "\n";
  }

  std::vector<const TraceStep*> owners;
  const std::vector<Row> rows = completed_rows(trace, owners);
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < trace.columns.size(); ++c) {
    std::size_t width = columns(trace.columns[c].name);
    for (const Row& row : rows) width = std::max(width, c < row.size() ? columns(row[c]) : 0);
    widths.push_back(width);
  }
  out += "\n";
  std::string heading;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    heading += padded(trace.columns[c].name, widths[c], trace.columns[c].numeric) + "  ";
  }
  out += bold(heading.substr(0, heading.find_last_not_of(' ') + 1)) + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string line;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      line += padded(c < rows[i].size() ? rows[i][c] : "", widths[c], trace.columns[c].numeric) + "  ";
    }
    out += line + dim(owners[i]->sentence) + "\n";
  }
  out += "\n";
  for (const Field& field : trace.result) out += fmt::format("{}: {}\n", field.name, value_text(field.value));
  return out;
}

namespace {

/// A cell with a decimal point, in every language.
std::string for_programs(const std::string& cell, const Trace& trace) {
  return trace.wording.decimal_comma() ? with_decimal_points(cell) : cell;
}

}  // namespace

std::string csv_of(const Trace& trace) {
  std::vector<const TraceStep*> owners;
  const std::vector<Row> rows = completed_rows(trace, owners);
  std::string out = "number,type,line";
  for (const Column& column : trace.columns) out += "," + csv_cell(column.id);
  out += ",sentence\r\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += fmt::format("{},{},{}", text_of(owners[i]->number), csv_cell(owners[i]->type), owners[i]->line);
    for (std::size_t c = 0; c < trace.columns.size(); ++c) {
      out += "," + csv_cell(plain(c < rows[i].size() ? for_programs(rows[i][c], trace) : ""));
    }
    out += "," + csv_cell(owners[i]->sentence) + "\r\n";
  }
  return out;
}

std::string markdown_of(const Trace& trace) {
  std::vector<const TraceStep*> owners;
  std::string out = "|", rule = "|";
  for (const Column& column : trace.columns) {
    out += fmt::format(" {} |", markdown_escaped(column.name));
    rule += column.numeric ? " --: |" : " :-- |";
  }
  out += "\n" + rule + "\n";
  for (const Row& row : completed_rows(trace, owners)) {
    out += "|";
    for (std::size_t c = 0; c < trace.columns.size(); ++c) {
      out += fmt::format(" {} |", c < row.size() ? markdown_escaped(row[c]) : "");
    }
    out += "\n";
  }
  return out;
}

std::string latex_of(const Trace& trace) {
  std::vector<const TraceStep*> owners;
  std::vector<std::string> alignments, heading;
  for (const Column& column : trace.columns) {
    alignments.emplace_back(column.numeric ? "r" : "l");
    heading.push_back(latex_cell(column.name));
  }
  std::string out =
      fmt::format("% \\usepackage{{booktabs}}\n\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n",
                  fmt::join(alignments, ""), fmt::join(heading, " & "));
  for (const Row& row : completed_rows(trace, owners)) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < trace.columns.size(); ++c) {
      cells.push_back(c < row.size() ? latex_cell(row[c]) : "");
    }
    out += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  }
  return out + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace gradus
