// `gradus worksheet`: exercises for print and for Moodle, and their key.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cairo/cairo_output.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/figures/figure_size.hpp"
#include "cli/figures/figure_spec.hpp"
#include "cli/files/files.hpp"
#include "cli/files/own_files.hpp"
#include "cli/files/students.hpp"
#include "cli/lecture/lecture.hpp"
#include "cli/terminal/progress.hpp"
#include "core/shown.hpp"
#include "figure/text/metrics.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"
#include "worksheet/latex_document.hpp"
#include "worksheet/moodle_quiz.hpp"
#include "worksheet/pages.hpp"
#include "worksheet/variants.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;
using worksheet::Part;
using worksheet::Reckoning;
using worksheet::StudentSheet;
using worksheet::Variants;

enum class SheetFormat { pdf, tex, xml };
const std::vector<std::string> sheet_formats{"pdf", "tex", "xml"};

// --- What is asked for -----------------------------------------------------------------------------------

/// A topic with the input that all sheets are like.
struct Model {
  const TopicEntry* topic = nullptr;
  FigureSpec spec;
};

struct WorksheetWish {
  std::vector<Model> models;
  /// One without a name where no file is given; in a PDF also where no font has it.
  std::vector<std::string> students;
  worksheet::PageStyle style;
  worksheet::Search search;
  int halves = 20;  ///< half points of a sheet
  SheetFormat format = SheetFormat::pdf;
  Output output;
  std::string key;                  ///< its file; empty: none
  std::vector<std::string> inputs;  ///< files that were read
  std::string command;              ///< that makes it again
};

std::int64_t read_whole(const Request& request, const std::string& flag, std::int64_t standard,
                        std::int64_t least, std::int64_t most) {
  const auto given = request.flags.find(flag);
  if (given == request.flags.end()) return standard;
  const auto value = whole_number(given->second);
  if (!value || *value < least || *value > most) {
    refuse_flag(flag, fmt::format("a whole number from {} to {}", least, most), shown(given->second));
  }
  return *value;
}

int read_halves(const Request& request) {
  const auto given = request.flags.find("points");
  if (given == request.flags.end()) return 20;
  constexpr double most_points = 1000;
  const auto value = decimal(given->second, 0.5, most_points);
  const int halves = value ? static_cast<int>(*value * 2) : 0;
  if (!value || halves != *value * 2) {
    refuse_flag("points", fmt::format("whole or half points up to {}", most_points), shown(given->second));
  }
  return halves;
}

SheetFormat read_sheet_format(const Request& request, const std::string& output) {
  if (const auto wanted = request.flags.find("format"); wanted != request.flags.end()) {
    return static_cast<SheetFormat>(choose_name("--format", wanted->second, sheet_formats));
  }
  const std::string ending = folded(fs::path(output).extension().string());
  const auto known =
      ending.empty() ? sheet_formats.end() : std::ranges::find(sheet_formats, ending.substr(1));
  if (known == sheet_formats.end()) {
    throw UsageError(fmt::format("-o: expected a name that ends in .{} (or --format), found {}",
                                 fmt::join(sheet_formats, ", ."), shown(output)));
  }
  return static_cast<SheetFormat>(known - sheet_formats.begin());
}

/// "exam/sheet.pdf" -> "exam/sheet-key.pdf".
std::string beside_named(const std::string& path, std::string_view what, const std::string& ending) {
  const fs::path file(path);
  return (file.parent_path() / fmt::format("{}-{}{}", file.stem().string(), what, ending)).string();
}

std::string read_key(const Request& request, const std::string& output, SheetFormat format) {
  const auto given = request.flags.find("key");
  if (format == SheetFormat::xml) {
    if (given == request.flags.end()) return "";
    throw UsageError("--key: expected pdf or tex, found xml, which has the answers in it");
  }
  if (given != request.flags.end()) return given->second;
  return output == dash ? "" : beside_named(output, "key", fs::path(output).extension().string());
}

/// The lecture's first figure of a topic: its input, and in whose words.
FigureSpec spec_in_lecture(const Request& request, const TopicEntry& topic,
                           std::vector<std::string>& inputs) {
  const std::string& path = request.flags.at("lecture");
  const Lecture lecture = read_lecture(lecture_at(path));
  if (!lecture.problems.empty()) {
    throw UsageError(
        fmt::format("--lecture: expected a lecture without mistakes (`gradus figures {} --check` "
                    "lists them), found {}",
                    shell_quoted(path), lecture.problems.front().text));
  }
  const auto found = std::ranges::find_if(
      lecture.figures, [&](const LectureFigure& figure) { return figure.spec.topic == &topic; });
  if (found == lecture.figures.end()) {
    throw UsageError(
        fmt::format("--lecture: expected a lecture with a figure of {}, found {}", topic.name, shown(path)));
  }
  inputs.push_back(path);
  return found->spec;
}

Model read_sheet_model(const Request& request, const TopicEntry& topic, std::vector<std::string>& inputs) {
  Model model{&topic, {}};
  if (request.has("lecture")) {
    model.spec = spec_in_lecture(request, topic, inputs);
  } else {
    model.spec.wording = model.spec.wording.with(Numbers::fractions);
  }
  if (!request.has("lecture") || !request.arguments.empty()) {
    Inputs read = read_inputs(topic, request.arguments);
    model.spec.arguments = std::move(read.arguments);
    inputs.insert(inputs.end(), read.files.begin(), read.files.end());
  }
  model.spec.topic = &topic;
  model.spec.theme = find_theme("print");
  apply_flags(model.spec, request);
  return model;
}

std::vector<Model> read_models(const Request& request, std::vector<std::string>& inputs) {
  if (!request.operands.empty() && !request.arguments.empty()) {
    throw UsageError(fmt::format("--{}: expected one topic with inputs of its own, found {}",
                                 hyphened(request.arguments.begin()->first), 1 + request.operands.size()));
  }
  std::vector<Model> models{read_sheet_model(request, *request.topic, inputs)};
  for (const std::string& word : request.operands) {
    models.push_back(read_sheet_model(request, find_topic(word), inputs));
  }
  return models;
}

/// The command without its output; students are told by their file's name.
std::string recorded_command(const Request& request, const std::vector<Model>& models) {
  std::string line = models.size() == 1 ? command_of("worksheet", *models[0].topic, models[0].spec.arguments)
                                        : "gradus worksheet";
  for (const Model& model : models) {
    if (models.size() > 1) line += " " + model.topic->name;
  }
  for (const auto& [flag, value] : request.flags) {
    if (flag == "output" || flag == "key" || flag == "format" || flag == "force" || flag == "quiet" ||
        flag == "color")
      continue;
    const bool is_file = flag == "students" || flag == "lecture";
    line += value.empty() ? " --" + flag
                          : " " + flag_with(flag, is_file ? fs::path(value).filename().string() : value);
  }
  for (const std::string& label : request.labels) line += " --label " + shell_quoted(label);
  return line;
}

/// The names of a class. In a PDF one that no font can draw is left out, and told.
std::vector<std::string> read_students(const std::string& file, SheetFormat format, bool quiet) {
  std::vector<std::string> names, remarks;
  for (const Student& student : students_in(read_input(file, "--students"), "--students")) {
    const auto& [name, line] = student;
    const bool by_table = missing_characters(name, Face::sans).empty();
    const auto missing = by_table || format != SheetFormat::pdf ? std::nullopt : character_without_font(name);
    names.push_back(missing ? "" : name);
    if (!missing) continue;
    remarks.push_back(
        fmt::format("{}:{}: no installed font has U+{:04X} of {}, so the name's line stays empty",
                    file == dash ? "standard input" : shown_name(file), line,
                    static_cast<std::uint32_t>(*missing), shown(name)));
  }
  for (const std::string& remark : first_notes(remarks))
    if (!quiet) note(remark);
  return names;
}

WorksheetWish read_wish(const Request& request) {
  const auto wanted = request.flags.find("output");
  if (wanted == request.flags.end()) {
    throw UsageError("-o: expected a file like sheet.pdf, or - for standard output, found none");
  }
  WorksheetWish wish;
  wish.output = {wanted->second, replaces(request.has("force")), request.quiet()};
  wish.format = read_sheet_format(request, wish.output.path);
  wish.key = read_key(request, wish.output.path, wish.format);
  if (wish.output.path == dash && wish.format == SheetFormat::pdf && is_terminal(Stream::out)) {
    throw UsageError("-o: expected a file or a pipe for pdf, found a terminal");
  }
  wish.models = read_models(request, wish.inputs);
  wish.students = {""};
  if (const auto file = request.flags.find("students"); file != request.flags.end()) {
    wish.students = read_students(file->second, wish.format, request.quiet());
    wish.inputs.push_back(file->second);
  }
  wish.search.seed = static_cast<std::uint64_t>(read_whole(request, "seed", 1, 0, INT64_MAX));
  wish.search.most_rows = static_cast<std::size_t>(read_whole(request, "table-rows", 12, 2, 16));
  wish.search.wanted = wish.students.size();
  wish.search.reckoning = request.has("calculator") ? Reckoning::calculator : Reckoning::by_hand;
  wish.halves = read_halves(request);
  wish.style = {wish.models[0].spec.paper, wish.search.reckoning, !request.has("no-drawing")};
  wish.command = recorded_command(request, wish.models);
  return wish;
}

// --- Inputs for all
// ------------------------------------------------------------------------------------------

Variants found_variants(const Model& model, const WorksheetWish& wish) {
  worksheet::Search search = wish.search;
  search.wording = model.spec.wording;
  Variants variants = worksheet::variants_of(*model.topic, model.spec.arguments, search);
  const std::string& name = model.topic->name;
  if (variants.tried == 0) {
    throw UsageError(
        fmt::format("worksheet: expected a topic and method with a table of at least two rows and numbers to "
                    "vary, found {}",
                    name));
  }
  if (variants.found.empty()) {
    const bool by_hand = search.reckoning == Reckoning::by_hand;
    throw UsageError(
        fmt::format("worksheet: expected an input of {} like its own with numbers for {}, found none "
                    "in {}{}",
                    name, by_hand ? "the hand" : "a calculator", variants.tried,
                    by_hand ? " (--calculator takes three decimals)" : ""));
  }
  if (variants.found.size() < wish.students.size() && !wish.output.quiet) {
    note(fmt::format("{}: {} different inputs found in {}, so that some of {} students share one", name,
                     variants.found.size(), variants.tried, wish.students.size()));
  }
  return variants;
}

std::vector<StudentSheet> sheets_of(const WorksheetWish& wish, const std::vector<Variants>& variants) {
  const bool drawings = wish.style.drawing && wish.format != SheetFormat::xml;
  std::vector<StudentSheet> sheets;
  for (std::size_t s = 0; s < wish.students.size(); ++s) {
    StudentSheet& sheet = sheets.emplace_back(StudentSheet{wish.students[s], {}});
    std::vector<const worksheet::Exercise*> exercises;
    for (std::size_t t = 0; t < variants.size(); ++t) {
      const worksheet::Variant& variant = variants[t].found[s % variants[t].found.size()];
      sheet.tasks.push_back({wish.models[t].topic, &variant, variants[t].parameters, {}});
      exercises.push_back(&variant.exercise);
    }
    std::vector<worksheet::Worth> worths = worksheet::worths_of(exercises, wish.halves, drawings);
    if (worths.empty()) {
      const double least = worksheet::fewest_halves(exercises, drawings) / 2.0;
      throw UsageError(
          fmt::format("--points: expected at least {} for this sheet, found {}", least, wish.halves / 2.0));
    }
    for (std::size_t t = 0; t < worths.size(); ++t) sheet.tasks[t].worth = std::move(worths[t]);
  }
  return sheets;
}

// --- Files
// ---------------------------------------------------------------------------------------------------

/// Every task of every student.
std::vector<std::pair<const StudentSheet*, std::size_t>> all_tasks(const std::vector<StudentSheet>& sheets) {
  std::vector<std::pair<const StudentSheet*, std::size_t>> tasks;
  for (const StudentSheet& sheet : sheets) {
    for (std::size_t i = 0; i < sheet.tasks.size(); ++i) tasks.emplace_back(&sheet, i);
  }
  return tasks;
}

/// The first character of a page that is drawn by no font.
std::optional<MissingGlyph> missing_on(const Sheet& sheet) {
  if (const auto missing = missing_glyph(sheet)) return missing;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (!text || text->any_script_within == 0) continue;
    if (const auto character = character_without_font(text->text))
      return MissingGlyph{text->text, *character};
  }
  return std::nullopt;
}

void check_letters(const Sheet& sheet) {
  const auto missing = missing_on(sheet);
  if (!missing) return;
  throw UsageError(fmt::format("worksheet: expected texts that can be drawn ({}), found {}",
                               explained(*missing), shown(missing->text)));
}

/// What the file says of itself. A sheet doesn't tell its seed: with that its reader could ask for the key.
Colophon sheet_colophon(const WorksheetWish& wish, Part part) {
  std::vector<std::string> names;
  for (const Model& model : wish.models) names.push_back(model.topic->name);
  const std::string title = fmt::format("{}", fmt::join(names, ", "));
  if (part == Part::key) return {title, title, wish.command, ""};
  return {title, title, fmt::format("gradus worksheet {}", fmt::join(names, " ")), ""};
}

const Finish& print_finish() {
  static const Finish finish(*find_theme("print"));
  return finish;
}

std::string pages_bytes_of(const WorksheetWish& wish, const std::vector<StudentSheet>& sheets, Part part) {
  const auto tasks = all_tasks(sheets);
  const Colophon colophon = sheet_colophon(wish, part);
  const auto page = [&](std::size_t i) {
    const auto& [sheet, task] = tasks[i];
    const std::size_t of_student = sheet->tasks.size();
    Sheet drawn = worksheet::page_of(*sheet, task, part, wish.style,
                                     part == Part::key ? colophon.command : sheet->student, task, of_student);
    check_letters(drawn);
    return drawn;
  };
  return pdf_of(tasks.size(), page, print_finish(), colophon);
}

constexpr double drawing_width = 174 / 25.4 * 96, drawing_height = 92 / 25.4 * 96;  // CSS pixels

std::string drawings_bytes(const WorksheetWish& wish, const std::vector<StudentSheet>& sheets, Part part) {
  const auto tasks = all_tasks(sheets);
  const auto page = [&](std::size_t i) {
    return worksheet::drawing_of(tasks[i].first->tasks[tasks[i].second], part, drawing_width, drawing_height);
  };
  return pdf_of(tasks.size(), page, print_finish(), sheet_colophon(wish, part));
}

/// In a comment of XML two hyphens, as of a flag, may not stand.
std::string command_instruction(const std::string& command) {
  std::string line = visible(command);
  for (std::size_t at = line.find("?>"); at != std::string::npos; at = line.find("?>", at)) {
    line.replace(at, 2, "? >");
  }
  return fmt::format("<?gradus {}?>\n", line);
}

std::string quiz_bytes(const WorksheetWish& wish, const std::vector<StudentSheet>& sheets) {
  Finish finish = print_finish();
  finish.scale = 1.5;
  const worksheet::DrawPng draw = [&](const worksheet::Task& task) {
    return png_of(worksheet::drawing_of(task, Part::sheet, drawing_width, drawing_height), finish, {});
  };
  const std::string quiz =
      worksheet::moodle_quiz(sheets, wish.search.reckoning, wish.style.drawing ? draw : worksheet::DrawPng());
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + command_instruction(wish.command) + quiz;
}

/// The files of the sheets or of their key.
void add_part(NewFiles& files, const WorksheetWish& wish, const std::vector<StudentSheet>& sheets, Part part,
              const std::string& path) {
  const auto add = [&](const std::string& name, const std::string& bytes) {
    check_output(name, wish.inputs, wish.output.replace);
    files.add(name, bytes, wish.output.replace);
  };
  if (wish.format == SheetFormat::pdf) return add(path, pages_bytes_of(wish, sheets, part));
  if (wish.format == SheetFormat::xml) return add(path, quiz_bytes(wish, sheets));
  std::string figures;
  if (wish.style.drawing) {
    figures = beside_named(path, "figures", ".pdf");
    add(figures, drawings_bytes(wish, sheets, part));
  }
  const std::string document =
      worksheet::latex_document(sheets, part, wish.style, fs::path(figures).filename().string());
  add(path, document + closing_line("tex", sheet_colophon(wish, part).command));
}

/// To standard output: one file, and nothing beside it.
std::string only_file(const WorksheetWish& wish, const std::vector<StudentSheet>& sheets) {
  if (wish.format == SheetFormat::pdf) return pages_bytes_of(wish, sheets, Part::sheet);
  if (wish.format == SheetFormat::xml) return quiz_bytes(wish, sheets);
  if (wish.style.drawing)
    throw UsageError("-o: expected a file for tex with drawings (or --no-drawing), found -");
  return worksheet::latex_document(sheets, Part::sheet, wish.style, "") +
         closing_line("tex", sheet_colophon(wish, Part::sheet).command);
}

}  // namespace

int worksheet(const Request& request) {
  const WorksheetWish wish = read_wish(request);
  std::vector<std::string> outputs;
  for (const std::string& path : {wish.output.path, wish.key}) {
    if (path.empty() || path == dash) continue;
    check_output(path, wish.inputs, wish.output.replace);
    outputs.push_back(path);
  }
  if (outputs.size() == 2 && same_file(outputs[0], outputs[1])) {
    throw UsageError(fmt::format("--key: expected another file than -o, found {}", shown(wish.key)));
  }
  std::vector<Variants> variants;
  for (const Model& model : wish.models) variants.push_back(found_variants(model, wish));
  const std::vector<StudentSheet> sheets = sheets_of(wish, variants);
  NewFiles files;
  if (!wish.key.empty()) add_part(files, wish, sheets, Part::key, wish.key);
  if (wish.output.path == dash) {
    write_stream(Stream::out, only_file(wish, sheets));
  } else {
    add_part(files, wish, sheets, Part::sheet, wish.output.path);
  }
  files.commit();
  for (const std::string& path : outputs) {
    if (!wish.output.quiet) note(shown_name(path));
  }
  return 0;
}

}  // namespace gradus::cli
