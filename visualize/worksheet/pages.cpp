#include "worksheet/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "figure/figure.hpp"
#include "figure/text/metrics.hpp"

namespace gradus::worksheet {
namespace {

// CSS pixels
constexpr double margin = 48, foot = 30;
constexpr double least_letters = 7.0 * 4 / 3, letters = 12, small = 10;
constexpr double line_of = 1.36;  ///< height of a line, in letters
constexpr double cell_padding = 7, least_blank = 44;

/// Writes from the top of a page downwards.
class Writer {
 public:
  Writer(Sheet& page, double width) : page_(page), width_(width) {}

  double y = margin;
  double width() const { return width_; }

  void text(const std::string& id, dvec2 baseline, std::string text, Face face, double size,
            Align align = Align::left, Paint paint = Paint::of(Tone::ink), Slot slot = Slot::sentence) {
    page_.shapes.push_back({slot, id, TextShape{baseline, std::move(text), face, size, align, paint}});
  }
  /// A student's name, or a text that ends with one: in the figures' letters where they have all of them.
  void name(const std::string& id, double baseline, const std::string& before, const std::string& name,
            double size, double room, Tone tone, Slot slot) {
    const std::string all = before + name;
    if (missing_characters(name, Face::sans).empty()) {
      return text(id, {margin, baseline}, elided(all, Face::sans, size, room), Face::sans, size, Align::left,
                  Paint::of(tone), slot);
    }
    const double begin = text_width(before, Face::sans, size);
    if (!before.empty())
      text(id + " before", {margin, baseline}, before, Face::sans, size, Align::left, Paint::of(tone), slot);
    TextShape shape{{margin + begin, baseline}, name, Face::sans, size, Align::left, Paint::of(tone)};
    shape.any_script_within = room - begin;
    page_.shapes.push_back({slot, id, std::move(shape)});
  }
  void line(const std::string& id, dvec2 from, dvec2 to, Tone tone = Tone::rule, double width = 1) {
    page_.shapes.push_back({Slot::title, id, LineShape{{from, to}, Paint::of(tone), width}});
  }
  void box(Slot slot, const std::string& id, const Box& box, Paint fill) {
    page_.shapes.push_back(
        {slot, id, RectShape{box, fill, Paint::of(Tone::muted), 0.75, 0, false, Hatch::none, {}}});
  }
  /// A paragraph.
  void paragraph(const std::string& id, const std::string& text_in_lines, Face face, double size,
                 Tone tone = Tone::ink) {
    int number = 0;
    for (std::string& each : wrapped(text_in_lines, face, size, width_)) {
      y += size * line_of;
      const dvec2 baseline{margin, y - 0.28 * size};
      text(fmt::format("{} {}", id, ++number), baseline, elided(each, face, size, width_), face, size,
           Align::left, Paint::of(tone));
    }
  }

 private:
  Sheet& page_;
  double width_;
};

// --- The table -------------------------------------------------------------------------------------------

/// The table's columns, and in a key what stands behind them.
struct TableShape {
  std::vector<double> widths;  ///< of the run's columns
  double decision = 0, points = 0;
  double size = letters;  ///< of a letter
};

double widest_cell(const Exercise& exercise, std::size_t column, double size) {
  double widest = text_width(exercise.trace->columns[column].name, Face::bold, size);
  for (const ExerciseRow& row : exercise.rows) {
    widest = std::max(widest, text_width(row.cells[column], Face::mono_bold, size));
  }
  return widest + 2 * cell_padding;
}

/// As wide as the page, or as the letters need where that is more: then they are smaller.
TableShape table_shape(const Task& task, Part part, double width) {
  const Exercise& exercise = task.variant->exercise;
  const Wording& wording = wording_of(task);
  TableShape shape;
  for (;; shape.size -= 0.5) {
    shape.widths.clear();
    for (std::size_t c = 0; c < exercise.trace->columns.size(); ++c) {
      shape.widths.push_back(std::max(least_blank, widest_cell(exercise, c, shape.size)));
    }
    if (part == Part::key) {
      shape.points = text_width(wording.say("worksheet.points_heading"), Face::bold, shape.size) + 14;
      shape.decision = 0;
      for (const ExerciseRow& row : exercise.rows) {
        shape.decision = std::max(shape.decision, text_width(row.decision, Face::sans, shape.size) + 14);
      }
      if (shape.decision > 0) {
        const double heading =
            text_width(wording.say("worksheet.decision_heading"), Face::bold, shape.size) + 14;
        shape.decision = std::clamp(shape.decision, heading, 0.34 * width);
      }
    }
    const double rest = width - shape.points - shape.decision;
    const double sum = std::accumulate(shape.widths.begin(), shape.widths.end(), 0.0);
    if (sum <= rest) {
      // More room for writing, but no column wider than three times what it needs
      const double gain = std::min((rest - sum) / static_cast<double>(shape.widths.size()), 90.0);
      for (double& each : shape.widths) each += gain;
      return shape;
    }
    if (shape.size <= least_letters) {
      for (double& each : shape.widths) each *= rest / sum;
      return shape;
    }
  }
}

class TablePrinter {
 public:
  TablePrinter(Writer& to, const Task& task, Part part)
      : to_(to), task_(task), part_(part), shape_(table_shape(task, part, to.width())) {}

  void print() {
    const Exercise& exercise = task_.variant->exercise;
    heading();
    for (std::size_t r = 0; r < exercise.rows.size(); ++r) row(r);
  }

 private:
  double baseline() const { return to_.y + blank_height / 2 + 0.36 * shape_.size; }

  void cell(const std::string& id, double x, double width, const std::string& text, Face face, Paint paint,
            Paint ground) {
    to_.box(Slot::table, id + " box", {x, to_.y, width, blank_height}, ground);
    if (text.empty()) return;
    to_.text(id, {x + width / 2, baseline()}, elided(text, face, shape_.size, width - 4), face, shape_.size,
             Align::centre, paint, Slot::table);
  }

  void heading() {
    double x = margin;
    const Paint ground = Paint::of(Tone::header), ink = Paint::of(Tone::ink);
    const std::vector<Column>& columns = task_.variant->exercise.trace->columns;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      cell("heading " + columns[c].id, x, shape_.widths[c], columns[c].name, Face::bold, ink, ground);
      x += shape_.widths[c];
    }
    if (part_ == Part::key) {
      const Wording& wording = wording_of(task_);
      side(x, wording.say("worksheet.decision_heading"), wording.say("worksheet.points_heading"), Face::bold,
           "heading");
    }
    to_.y += blank_height;
  }

  /// Behind the table, without boxes.
  void side(double x, const std::string& decision, const std::string& points, Face face,
            const std::string& id) {
    if (shape_.decision > 0 && !decision.empty()) decide(x + 8, decision, face, id + " decision");
    x += shape_.decision;
    to_.text(id + " points", {x + shape_.points - 2, baseline()}, points, face, shape_.size, Align::right,
             Paint::of(Tone::ink), Slot::table);
  }

  /// On one line, or in small letters on two.
  void decide(double x, const std::string& decision, Face face, const std::string& id) {
    const double room = shape_.decision - 10;
    const bool long_one = text_width(decision, face, shape_.size) > room;
    const double size = long_one ? least_letters : shape_.size;
    const std::vector<std::string> lines = wrapped(decision, face, size, room);
    const std::size_t shown = std::min<std::size_t>(lines.size(), 2);
    double y = baseline() - (shown == 2 ? 0.65 * size : 0);
    for (std::size_t i = 0; i < shown; ++i, y += 1.3 * size) {
      const bool cut = i + 1 == shown && shown < lines.size();
      to_.text(fmt::format("{} {}", id, i), {x, y}, elided(lines[i] + (cut ? " …" : ""), face, size, room),
               face, size, Align::left, Paint::of(Tone::muted), Slot::table);
    }
  }

  void row(std::size_t r) {
    const Exercise& exercise = task_.variant->exercise;
    const ExerciseRow& row = exercise.rows[r];
    double x = margin;
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      const std::string id = fmt::format("cell {} {}", r, exercise.trace->columns[c].id);
      const bool numeric = exercise.trace->columns[c].numeric;
      const Face given = numeric ? Face::mono : Face::sans, answer = numeric ? Face::mono_bold : Face::bold;
      const bool hidden = row.asked[c] && part_ == Part::sheet;
      cell(id, x, shape_.widths[c], hidden ? "" : row.cells[c], row.asked[c] ? answer : given,
           row.asked[c] ? Paint::text(Role::current) : Paint::of(Tone::ink), Paint::of(Tone::paper));
      if (row.cells[c].empty()) {
        const double inset = 0.28 * blank_height, middle = x + shape_.widths[c] / 2;
        to_.line(id + " stroke", {middle - inset, to_.y + blank_height - inset},
                 {middle + inset, to_.y + inset}, Tone::muted);
      }
      x += shape_.widths[c];
    }
    if (part_ == Part::key) {
      const Points points = task_.worth.rows[r];
      side(x, row.decision, points.parts > 0 ? text_of(points, wording_of(task_)) : "–", Face::sans,
           fmt::format("row {}", r));
    }
    to_.y += blank_height;
  }

  Writer& to_;
  const Task& task_;
  Part part_;
  TableShape shape_;
};

// --- The page ----------------------------------------------------------------------------------------------

void write_head(Writer& to, const StudentSheet& sheet, std::size_t task, Part part) {
  const Task& told = sheet.tasks[task];
  const Wording& wording = wording_of(told);
  const double right = margin + to.width();
  const std::string worth = points_text(told.points(), wording);
  const std::string points = part == Part::key ? worth : scored_text(told.points(), wording);
  const double points_width = text_width(points, Face::sans, letters);
  to.y += 16;
  to.text("title", {margin, to.y},
          elided(task_title(sheet, task), Face::bold, 17, to.width() - 20 - points_width), Face::bold, 17,
          Align::left, Paint::of(Tone::ink), Slot::title);
  to.text("points", {right, to.y}, points, Face::sans, letters, Align::right, Paint::of(Tone::ink),
          Slot::title);
  to.y += 30;
  const std::string key = part == Part::key ? wording.say("worksheet.key") : "";
  const double room = to.width() - text_width(key, Face::bold, 13) - 20;
  const std::string before = name_text("", wording) + (sheet.student.empty() ? "" : " ");
  to.name("name", to.y, before, sheet.student, 13, room, Tone::ink, Slot::title);
  if (sheet.student.empty()) {
    const double from = margin + text_width(before, Face::sans, 13) + 8;
    to.line("name line", {from, to.y + 2}, {margin + 0.6 * to.width(), to.y + 2}, Tone::muted);
  }
  if (!key.empty()) {
    to.text("key", {right, to.y}, key, Face::bold, 13, Align::right, Paint::text(Role::current), Slot::title);
  }
  to.y += 10;
  to.line("head rule", {margin, to.y}, {right, to.y});
  to.y += 4;
}

void write_question(Writer& to, const Task& task, const PageStyle& style) {
  const Trace& trace = *task.variant->exercise.trace;
  const Wording& wording = trace.wording;
  to.paragraph("goal", trace.goal, Face::sans, letters);
  if (!trace.faulty.empty()) {
    to.paragraph("faulty", wording.say("figure.faulty", fmt::arg("what", trace.faulty)), Face::bold, letters);
  }
  to.y += 4;
  to.paragraph("input",
               wording.say("worksheet.input", fmt::arg("input", trace.subtitle),
                           fmt::arg("method", trace.method_title)),
               Face::bold, letters);
  to.paragraph("given", fmt::format("{}", fmt::join(given_arguments(task), " · ")), Face::mono, small,
               Tone::muted);
  to.y += 4;
  to.paragraph("fill", filling_text(task, style.reckoning), Face::sans, letters);
  to.y += 8;
}

void write_drawing(Sheet& page, Writer& to, const Task& task, Part part) {
  const Wording& wording = wording_of(task);
  const std::string worth = points_text(task.worth.drawing, wording);
  const std::string text = part == Part::key ? wording.say("worksheet.drawing_key", fmt::arg("points", worth))
                                             : drawing_text(task);
  to.y += 8;
  to.paragraph("draw", text, Face::sans, letters);
  to.y += 6;
  const Box box{margin, to.y, to.width(), page.height - margin - foot - to.y};
  Sheet inner = drawing_of(task, part, box.width, box.height);
  page.unit = inner.unit;
  page.shapes.push_back({Slot::drawing, "drawing box",
                         RectShape{box, {}, Paint::of(Tone::rule), 0.75, 4, false, Hatch::none, {}}});
  for (Shape& shape : inner.shapes) {
    page.shapes.push_back(moved(std::move(shape), {box.x, box.y}));
    page.shapes.back().id.insert(0, "drawing ");
  }
  to.y = box.bottom();
}

void write_foot(Sheet& page, Writer& to, const Wording& wording, const std::string& footer,
                std::size_t number, std::size_t pages) {
  const double baseline = page.height - margin;
  const std::string place =
      wording.say("figure.page", fmt::arg("page", number + 1), fmt::arg("pages", pages));
  const double room = to.width() - text_width(place, Face::sans, small) - 20;
  to.line("footer rule", {margin, baseline - 14}, {page.width - margin, baseline - 14});
  to.name("footer", baseline, "", footer, small, room, Tone::muted, Slot::footer);
  to.text("page", {page.width - margin, baseline}, place, Face::sans, small, Align::right,
          Paint::of(Tone::muted), Slot::footer);
}

}  // namespace

Sheet drawing_of(const Task& task, Part part, double width, double height) {
  const Exercise& exercise = task.variant->exercise;
  const Trace& trace = *exercise.trace;
  Playhead playhead(trace);
  const StepNumber shown = part == Part::sheet ? trace.steps.front().number : exercise.drawn_until;
  const Figure figure = figure_of(trace, playhead, shown);
  Look look;
  look.width = width;
  look.height = height;
  look.layout = Layout::handout;
  look.least_text = least_letters;
  look.slots = {Slot::drawing};
  return lay_out(figure, look);
}

Sheet page_of(const StudentSheet& sheet, std::size_t task, Part part, const PageStyle& style,
              const std::string& footer, std::size_t page, std::size_t pages) {
  const Task& told = sheet.tasks[task];
  Sheet out{style.paper.width, style.paper.height, {}};
  Writer to(out, out.width - 2 * margin);
  write_head(to, sheet, task, part);
  write_question(to, told, style);
  TablePrinter(to, told, part).print();
  if (style.drawing) write_drawing(out, to, told, part);
  write_foot(out, to, wording_of(told), footer, page, pages);
  return out;
}

}  // namespace gradus::worksheet
