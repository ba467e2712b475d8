// Worksheets: inputs alike and for the hand, answers those of the run, points that sum up, blanks large
// enough to write into, documents that other programs can read.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <set>

#include "figure/text/metrics.hpp"
#include "support/example_traces.hpp"
#include "support/sheets.hpp"
#include "text/text_output.hpp"
#include "worksheet/latex_document.hpp"
#include "worksheet/moodle_quiz.hpp"
#include "worksheet/pages.hpp"
#include "worksheet/similar_input.hpp"
#include "worksheet/variants.hpp"

namespace gradus::worksheet {
namespace {

using gradus::test::expect_texts_apart;
using gradus::test::find_text;
using gradus::test::texts_of;
using gradus::test::topic;

Search search_of(std::size_t wanted, std::uint64_t seed = 1) {
  Search search;
  search.seed = seed;
  search.wanted = wanted;
  search.wording = Wording().with(Numbers::fractions);
  return search;
}

Variants variants_of_topic(std::string_view name, const Search& search) {
  return variants_of(topic(name), arguments_of(topic(name), {}), search);
}

/// A table as CSV has it (RFC 4180), without its first line.
std::vector<std::vector<std::string>> csv_rows(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& cell = rows.back().back();
    if (quoted && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      cell += csv[++i];
    } else if (csv[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && csv[i] == ',') {
      rows.back().emplace_back();
    } else if (!quoted && csv[i] == '\r') {
      rows.push_back({""});
      ++i;
    } else {
      cell += csv[i];
    }
  }
  rows.pop_back();
  rows.erase(rows.begin());
  return rows;
}

std::string with_plain_minus(std::string text) { return std::regex_replace(text, std::regex("−"), "-"); }

/// The answers are the cells that the table of the run has, told anew.
void expect_answers_of_the_run(const TopicEntry& entry, const Variant& variant, const Wording& wording) {
  const Trace again = entry.run(variant.arguments, {0, 4000, wording});
  const auto rows = csv_rows(csv_of(again));
  const Exercise& exercise = variant.exercise;
  ASSERT_GE(rows.size(), exercise.rows.size());
  for (std::size_t r = 0; r < exercise.rows.size(); ++r) {
    for (std::size_t c = 0; c < exercise.trace->columns.size(); ++c) {
      EXPECT_EQ(with_plain_minus(exercise.rows[r].cells[c]), rows[r][c + 3]) << entry.name << " row " << r;
    }
  }
}

// --- Numbers for the hand ----------------------------------------------------------------------------------

TEST(WorksheetNumbers, WholeOnesShortFractionsAndTwoDecimalsAreForTheHand) {
  for (const char* cell : {"", "7", "−120", "7/12", "(3, −1)", "0.25", "p < 0", "E", "v6", "0101", "1010",
                           "000001", "f0e0c000", "8 → 1", "a: left", "1/2 … 3/4", "∞", "–"}) {
    EXPECT_TRUE(can_be_had(cell, Reckoning::by_hand)) << cell;
  }
  for (const char* cell : {"1200", "7/125", "0.583", "(3, 0.001)", "≈ 2", "1e-05", "1/1000", "x 0.1234"}) {
    EXPECT_FALSE(can_be_had(cell, Reckoning::by_hand)) << cell;
  }
  EXPECT_TRUE(can_be_had("0.583", Reckoning::calculator));
  EXPECT_TRUE(can_be_had("7/125", Reckoning::calculator));
  EXPECT_FALSE(can_be_had("0.5833", Reckoning::calculator));
  EXPECT_FALSE(can_be_had("1200", Reckoning::calculator));
}

// --- Inputs
// --------------------------------------------------------------------------------------------------

/// How often each kind of branch was taken, by the steps themselves: a second count, for whole runs whose
/// rows each tell one decision.
std::map<std::string, int> branches_in(const Trace& trace) {
  std::map<std::string, int> count;
  for (const TraceStep& step : trace.steps) {
    if (step.decision && step.number.fine != 0) ++count[step.decision->branch];
  }
  return count;
}

TEST(WorksheetInputs, AllStudentsOfALineHaveTheSameStepsAndKindsOfBranch) {
  const Variants variants = variants_of_topic("bresenham_line", search_of(24));
  ASSERT_EQ(variants.found.size(), 24u);
  const auto model = branches_in(*variants.model.trace);
  std::set<std::string> answers{variants.model.answers()};
  for (const Variant& variant : variants.found) {
    EXPECT_EQ(variant.exercise.trace->last, variants.model.trace->last);
    EXPECT_EQ(variant.exercise.rows.size(), variants.model.rows.size());
    const auto branches = branches_in(*variant.exercise.trace);
    ASSERT_EQ(branches.size(), model.size());
    for (const auto& [kind, count] : model) EXPECT_LE(std::abs(branches.at(kind) - count), 1) << kind;
    EXPECT_TRUE(answers.insert(variant.exercise.answers()).second) << "two students have the same answers";
    expect_answers_of_the_run(topic("bresenham_line"), variant, search_of(1).wording);
  }
}

TEST(WorksheetInputs, ASeedDrawsTheSameInputsAndMoreStudentsKeepTheFirst) {
  for (const char* name : {"bresenham_line", "liang_barsky", "flood_fill"}) {
    const Variants few = variants_of_topic(name, search_of(3)), more = variants_of_topic(name, search_of(6));
    const Variants other = variants_of_topic(name, search_of(3, 2));
    ASSERT_EQ(few.found.size(), 3u) << name;
    ASSERT_EQ(more.found.size(), 6u) << name;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(few.found[i].exercise.answers(), more.found[i].exercise.answers()) << name;
    }
    ASSERT_EQ(other.found.size(), 3u) << name;
    EXPECT_NE(few.found[0].exercise.answers(), other.found[0].exercise.answers()) << name;
  }
}

TEST(WorksheetInputs, OfCirclesTheBeginningsOfLongerRunsServe) {
  const Variants variants = variants_of_topic("bresenham_circle", search_of(2));
  ASSERT_EQ(variants.found.size(), 2u);
  for (const Variant& variant : variants.found) {
    EXPECT_EQ(variant.exercise.rows.size(), variants.model.rows.size());
    EXPECT_GE(variant.exercise.rows_of_run, variant.exercise.rows.size());
    expect_answers_of_the_run(topic("bresenham_circle"), variant, search_of(1).wording);
  }
}

/// A corner of the frustum is 4/√3 = 2.309… up: with two decimals it looks like a number for the hand.
TEST(WorksheetInputs, ARoundedNumberIsKnown) {
  const TopicEntry& entry = topic("liang_barsky");
  const auto rounded_rows = [&](const char* line) {
    const Argument given[] = {{"line", line}, {"window", "0,0,10,10"}};
    const Trace trace = entry.run(arguments_of(entry, given), {0, 4000, Wording()});
    const Exercise exercise = exercise_of(std::make_shared<const Trace>(trace), 12);
    return std::ranges::count_if(exercise.rows, &ExerciseRow::rounded);
  };
  EXPECT_EQ(rounded_rows("-4,3,6,15"), 1) << "t = 7/12, shown as 0.583";
  EXPECT_EQ(rounded_rows("-4,4,6,12"), 0) << "0.4, 0.75 and the like";
}

/// "-3√2/4" as a number, read by itself.
double value_of_root(const std::string& text) {
  static const std::regex form("(-?)([0-9.]*)(?:√([0-9]+))?(?:/([0-9]+))?");
  std::smatch part;
  EXPECT_TRUE(std::regex_match(text, part, form)) << text;
  const auto number = [&](std::size_t i) { return part[i].length() > 0 ? std::stod(part[i].str()) : 1.0; };
  return (part[1].length() > 0 ? -1 : 1) * number(2) * std::sqrt(number(3)) / number(4);
}

/// Of a sphere, in fractions: 60 and 30 degrees give way to angles of the same kind, whose coordinates are
/// roots, and none of them is rounded.
TEST(WorksheetInputs, CoordinatesOfASphereAreRootsForTheHand) {
  const Variants variants = variants_of_topic("parametric_surface", search_of(30));
  EXPECT_EQ(variants.found.size(), 30u);
  int roots = 0;
  for (const Variant& variant : variants.found) {
    const Exercise& exercise = variant.exercise;
    for (const ExerciseRow& row : exercise.rows) {
      const auto step = std::ranges::find(exercise.trace->steps, row.step, &TraceStep::number);
      ASSERT_NE(step, exercise.trace->steps.end());
      for (std::size_t c = 1; c < row.cells.size(); ++c) {
        const std::string cell = with_plain_minus(row.cells[c]);
        roots += cell.find("√") != std::string::npos;
        const auto field = std::ranges::find(step->fields, std::string(1, "xyz"[c - 1]), &Field::name);
        if (field != step->fields.end())
          EXPECT_NEAR(value_of_root(cell), std::get<double>(field->value), 1e-12) << cell;
      }
    }
  }
  EXPECT_GT(roots, 200);
}

/// Every topic of the catalogue: what is found is fit, whatever the topic; where nothing is found nothing is
/// handed out.
TEST(WorksheetInputs, WhatIsFoundIsFitInEveryTopic) {
  std::size_t found = 0;
  for (const TopicEntry* entry : catalogue()) {
    SCOPED_TRACE(entry->name);
    Search search = search_of(1);
    search.patience = 1;
    const Variants variants = variants_of(*entry, arguments_of(*entry, {}), search);
    for (const Variant& variant : variants.found) {
      ++found;
      const Exercise& exercise = variant.exercise;
      EXPECT_EQ(exercise.rows.size(), variants.model.rows.size());
      EXPECT_LE(exercise.rows.size(), search.most_rows);
      EXPECT_GT(exercise.blanks(), 0);
      EXPECT_EQ(exercise.rows.front().blanks(), 0) << "the first row is given";
      EXPECT_NE(exercise.answers(), variants.model.answers());
      for (const ExerciseRow& row : exercise.rows) {
        for (std::size_t c = 0; c < row.cells.size(); ++c) {
          EXPECT_TRUE(can_be_had(row.cells[c], search.reckoning)) << row.cells[c];
          EXPECT_FALSE(row.asked[c] && row.cells[c].empty());
        }
      }
      expect_answers_of_the_run(*entry, variant, search.wording);
    }
  }
  EXPECT_GE(found, 4u);
}

TEST(WorksheetInputs, OnlyWhatTheMethodReadsIsVaried) {
  const TopicEntry& entry = topic("perspective");
  const Arguments arguments = arguments_of(entry, {});
  const auto read = read_parameters(entry, arguments);
  SimilarInputs inputs(read, arguments, Random(7));
  int drawn = 0;
  for (int i = 0; i < 200; ++i) {
    const auto next = inputs.next(arguments);
    if (!next) continue;
    ++drawn;
    for (const Arguments::Entry& each : next->entries()) {
      const bool changed = each.text != (arguments.has(each.name) ? arguments.text(each.name) : "");
      const bool is_read =
          std::ranges::any_of(read, [&](const Parameter* parameter) { return parameter->name == each.name; });
      EXPECT_TRUE(!changed || is_read) << each.name;
    }
  }
  EXPECT_GT(drawn, 100);
}

// --- Points
// --------------------------------------------------------------------------------------------------

TEST(WorksheetPoints, SumUpExactlyAndNoPartIsWorthNothing) {
  const Variants line = variants_of_topic("bresenham_line", search_of(1));
  const Variants clip = variants_of_topic("liang_barsky", search_of(1));
  const std::vector<const Exercise*> both{&line.found[0].exercise, &clip.found[0].exercise};
  const std::vector<const Exercise*> one{both[0]};
  for (const auto& exercises : {one, both}) {
    for (const bool drawings : {true, false}) {
      const int least = fewest_halves(exercises, drawings);
      EXPECT_TRUE(worths_of(exercises, least - 1, drawings).empty());
      for (int halves = least; halves <= 200; ++halves) {
        const std::vector<Worth> worths = worths_of(exercises, halves, drawings);
        ASSERT_EQ(worths.size(), exercises.size());
        double sum = 0;
        for (std::size_t i = 0; i < worths.size(); ++i) {
          for (std::size_t r = 0; r < worths[i].rows.size(); ++r) {
            const Points& points = worths[i].rows[r];
            EXPECT_EQ(points.parts > 0, exercises[i]->rows[r].blanks() > 0);
            sum += static_cast<double>(points.parts) / points.of_one;
          }
          EXPECT_EQ(worths[i].drawing.parts > 0, drawings);
          sum += static_cast<double>(worths[i].drawing.parts) / worths[i].drawing.of_one;
        }
        EXPECT_EQ(sum, halves / 2.0);
      }
    }
  }
}

// --- Pages
// -----------------------------------------------------------------------------------------------------

/// Sheets of some students, with all that they need to live.
struct Class {
  Variants line, clip;
  std::vector<StudentSheet> sheets;

  explicit Class(const std::vector<std::string>& students, const Wording& wording = {}) {
    Search search = search_of(students.size());
    search.wording = wording.with(Numbers::fractions);
    line = variants_of_topic("bresenham_line", search);
    clip = variants_of_topic("liang_barsky", search);
    for (std::size_t i = 0; i < students.size(); ++i) {
      const Variant &first = line.found.at(i), &second = clip.found.at(i);
      auto worths = worths_of({&first.exercise, &second.exercise}, 20, true);
      sheets.push_back({students[i],
                        {{&topic("bresenham_line"), &first, line.parameters, worths[0]},
                         {&topic("liang_barsky"), &second, clip.parameters, worths[1]}}});
    }
  }
};

TEST(WorksheetPages, BlanksAreEmptyAndHighEnoughToWriteInto) {
  for (const Language& language : languages()) {
    const Class students({"", "Ada Lovelace"}, Wording(language));
    for (const Paper& paper : papers()) {
      PageStyle style;
      style.paper = paper;
      for (const StudentSheet& sheet : students.sheets) {
        for (std::size_t t = 0; t < sheet.tasks.size(); ++t) {
          const Sheet page = page_of(sheet, t, Part::sheet, style, "foot", t, 2);
          const Sheet key = page_of(sheet, t, Part::key, style, "foot", t, 2);
          EXPECT_EQ(page.width, paper.width);
          EXPECT_EQ(page.height, paper.height);
          EXPECT_FALSE(missing_glyph(page).has_value());
          const Exercise& exercise = sheet.tasks[t].variant->exercise;
          for (std::size_t r = 0; r < exercise.rows.size(); ++r) {
            for (std::size_t c = 0; c < exercise.trace->columns.size(); ++c) {
              const std::string id = fmt::format("cell {} {}", r, exercise.trace->columns[c].id);
              const ExerciseRow& row = exercise.rows[r];
              const TextShape* shown = find_text(page, id);
              EXPECT_EQ(shown != nullptr, !row.asked[c] && !row.cells[c].empty()) << id;
              const TextShape* answer = find_text(key, id);
              EXPECT_EQ(answer ? answer->text : "", row.cells[c]) << id;
            }
          }
          for (const Shape& shape : page.shapes) {
            if (!shape.id.ends_with(" box") || !shape.id.starts_with("cell ")) continue;
            EXPECT_GE(std::get<RectShape>(shape.what).box.height, 7 / 25.4 * 96);
            EXPECT_GE(std::get<RectShape>(shape.what).box.width, 11 / 25.4 * 96);
          }
          for (const Sheet* each : {&page, &key}) {
            expect_texts_apart(*each);
            for (const TextShape* text : texts_of(*each)) {
              EXPECT_GE(text->size, 7.0 * 4 / 3 - 1e-9) << text->text;
              const Box box = text->box();
              EXPECT_TRUE(box.x >= 0 && box.right() <= page.width && box.bottom() <= page.height)
                  << text->text;
            }
          }
        }
      }
    }
  }
}

TEST(WorksheetPages, TheDrawingOfASheetIsTheInputAndThatOfTheKeyTheResult) {
  const Class students({"Ada"});
  const Task& task = students.sheets[0].tasks[0];
  const auto plotted = [&](Part part) {
    std::size_t count = 0;
    for (const Shape& shape : drawing_of(task, part, 640, 340).shapes) {
      count += shape.id.starts_with("cell ") && std::holds_alternative<RectShape>(shape.what);
    }
    return count;
  };
  EXPECT_GT(plotted(Part::key), plotted(Part::sheet));
}

// --- LaTeX
// -----------------------------------------------------------------------------------------------------

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size()))
    ++count;
  return count;
}

TEST(WorksheetLatex, EnvironmentsCloseAndNamesAreEscaped) {
  const Class students({"A & B_{50%} #1 $x$ ~^\\end{document}", "Zoë"}, Wording(*find_language("de")));
  for (const Part part : {Part::sheet, Part::key}) {
    const std::string document = latex_document(students.sheets, part, {}, "sheet-figures.pdf");
    std::vector<std::string> open;
    const std::regex mark(R"(\\(begin|end)\{(\w+)\})");
    for (std::sregex_iterator at(document.begin(), document.end(), mark), end; at != end; ++at) {
      // A name that is escaped has \textbackslash{}end\{document\}: no mark of LaTeX's
      if ((*at)[1] == "begin") {
        open.push_back((*at)[2]);
      } else {
        ASSERT_FALSE(open.empty());
        EXPECT_EQ(open.back(), (*at)[2]);
        open.pop_back();
      }
    }
    EXPECT_TRUE(open.empty());
    EXPECT_EQ(count_of(document, "\\begin{document}"), 1u);
    EXPECT_EQ(count_of(document, "\\includegraphics[page="), 4u);
    EXPECT_NE(document.find("A \\& B\\_\\{50\\%\\} \\#1 \\$x\\$ \\textasciitilde{}"), std::string::npos);
    EXPECT_NE(document.find("ngerman"), std::string::npos);
    int blanks = 0;
    for (const StudentSheet& sheet : students.sheets) {
      for (const Task& task : sheet.tasks) blanks += task.variant->exercise.blanks();
    }
    const std::regex blank(R"(\\blank(?![a-z]))"), answer(R"(\\answer\{)");
    const auto shown = [&](const std::regex& what) {
      return std::distance(std::sregex_iterator(document.begin(), document.end(), what),
                           std::sregex_iterator());
    };
    EXPECT_EQ(shown(blank) - 1, part == Part::sheet ? blanks : 0) << "but for its definition";
    EXPECT_EQ(shown(answer), part == Part::key ? blanks : 0);
    // Each row has as many cells as its table has columns
    const std::regex table(R"(\\begin\{tabular\}\{(\w+)\}\n([\s\S]*?)\\end\{tabular\})");
    int tables = 0;
    for (std::sregex_iterator at(document.begin(), document.end(), table), end; at != end; ++at) {
      ++tables;
      const std::regex row(R"([^\n]* \\\\\n)");
      const std::string body = (*at)[2];
      for (std::sregex_iterator line(body.begin(), body.end(), row); line != end; ++line) {
        const std::string text = std::regex_replace(line->str(), std::regex(R"(\\&)"), "");
        EXPECT_EQ(count_of(text, "&") + 1, (*at)[1].str().size()) << text;
      }
    }
    EXPECT_EQ(tables, 4);
  }
}

// --- Moodle
// ----------------------------------------------------------------------------------------------------

TEST(WorksheetMoodle, AnswersAreOfTheTypesThatMoodleReads) {
  EXPECT_EQ(embedded_answer("5", 1), "{1:NUMERICAL:=5:0}");
  EXPECT_EQ(embedded_answer("−12", 3), "{3:NUMERICAL:=-12:0}");
  EXPECT_EQ(embedded_answer("0101", 1), "{1:SHORTANSWER:=0101}") << "a code keeps its zeros";
  EXPECT_EQ(embedded_answer("NE", 2), "{2:SHORTANSWER:=NE}");
  EXPECT_EQ(embedded_answer("7/12", 1), "{1:SHORTANSWER:=7/12~=0.583~=0,583}");
  EXPECT_EQ(embedded_answer("0.5", 1), "{1:SHORTANSWER:=0.5~=0,5}");
  EXPECT_EQ(embedded_answer("√3/2", 1), "{1:SHORTANSWER:=√3/2~=sqrt(3)/2~=0.866~=0,866}");
  EXPECT_EQ(embedded_answer("−3√2", 1), "{1:SHORTANSWER:=−3√2~=-3√2~=-3\\*sqrt(2)~=-4.243~=-4,243}");
  EXPECT_EQ(embedded_answer("(3, −1)", 1), "{1:SHORTANSWER:=(3, −1)~=(3, -1)~=(3,-1)~=(3,−1)}");
  EXPECT_EQ(embedded_answer("p < 0", 1), "{1:SHORTANSWER:=p &lt; 0~=p&lt;0}");
  EXPECT_EQ(embedded_answer("a}b~c#d*e", 1), "{1:SHORTANSWER:=a\\}b\\~c\\#d\\*e}");
}

/// The fields of a question as Moodle finds them: mark, type, alternatives.
struct Field {
  int mark;
  std::string type, answers;
};
std::vector<Field> fields_in(const std::string& text) {
  static const std::regex field(R"(\{([0-9]+):(NUMERICAL|SHORTANSWER):((?:\\.|[^}\\])*)\})");
  std::vector<Field> fields;
  for (std::sregex_iterator at(text.begin(), text.end(), field), end; at != end; ++at) {
    fields.push_back({std::stoi((*at)[1]), (*at)[2], (*at)[3]});
  }
  return fields;
}

TEST(WorksheetMoodle, EachBlankIsAFieldAndMarksAreAsThePoints) {
  Class students({"Ada ]]> <b>", "Zoë & Co"});
  for (StudentSheet& sheet : students.sheets) {
    std::vector<const Exercise*> exercises;
    for (const Task& task : sheet.tasks) exercises.push_back(&task.variant->exercise);
    auto worths = worths_of(exercises, 20, false);
    for (std::size_t i = 0; i < worths.size(); ++i) sheet.tasks[i].worth = worths[i];
  }
  const std::string quiz = moodle_quiz(students.sheets, Reckoning::by_hand,
                                       [](const Task&) { return std::string("\x89PNG\0\xff", 6); });
  EXPECT_EQ(count_of(quiz, "<question type=\"category\">"), 2u);
  EXPECT_EQ(count_of(quiz, "<question type=\"cloze\">"), 4u);
  EXPECT_EQ(count_of(quiz, "encoding=\"base64\">iVBORwD/</file>"), 4u) << "six bytes in base64";
  EXPECT_NE(quiz.find("Ada ]]&gt; &lt;b&gt;"), std::string::npos);
  EXPECT_EQ(count_of(quiz, "<![CDATA["), count_of(quiz, "]]>"));
  std::vector<std::string> questions;
  for (std::size_t at = quiz.find("<questiontext"); at != std::string::npos;
       at = quiz.find("<questiontext", at + 1)) {
    questions.push_back(quiz.substr(at, quiz.find("</questiontext>", at) - at));
  }
  ASSERT_EQ(questions.size(), 4u);
  for (std::size_t q = 0; q < 4; ++q) {
    const Task& task = students.sheets[q % 2].tasks[q / 2];  // a category per topic, in it the students
    const Exercise& exercise = task.variant->exercise;
    const std::vector<Field> fields = fields_in(questions[q]);
    ASSERT_EQ(static_cast<int>(fields.size()), exercise.blanks());
    std::size_t next = 0;
    double mark_of_a_point = 0;
    for (std::size_t r = 0; r < exercise.rows.size(); ++r) {
      int marks = 0;
      for (std::size_t c = 0; c < exercise.rows[r].cells.size(); ++c) {
        if (!exercise.rows[r].asked[c]) continue;
        const Field& field = fields[next++];
        EXPECT_EQ(field.answers, embedded_answer(exercise.rows[r].cells[c], 1)
                                     .substr(4 + field.type.size(), std::string::npos)
                                     .substr(0, field.answers.size()));
        EXPECT_GE(field.mark, 1);
        marks += field.mark;
      }
      if (marks == 0) continue;
      const double point =
          marks / (static_cast<double>(task.worth.rows[r].parts) / task.worth.rows[r].of_one);
      if (mark_of_a_point == 0) mark_of_a_point = point;
      EXPECT_NEAR(point, mark_of_a_point, 1e-12);
    }
  }
}

}  // namespace
}  // namespace gradus::worksheet
