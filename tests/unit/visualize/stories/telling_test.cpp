// Of every story: each sentence is said with what its text asks for, and each step that decides says what.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "stories/topic.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

// --- Sentences

/// The English texts, each with its key in front: "‹bresenham_line.started›Start at {from}".
Language marked() {
  std::string catalogue;
  for (const auto& [key, text] : languages().front().texts())
    catalogue += fmt::format("{0} = ‹{0}›{1}\n", key, text);
  return Language("en", catalogue);
}

void collect(std::string_view text, std::set<std::string>& keys) {
  constexpr std::string_view open = "‹", close = "›";
  for (std::size_t at = text.find(open); at != std::string_view::npos; at = text.find(open, at + 1)) {
    const std::size_t first = at + open.size();
    keys.insert(std::string(text.substr(first, text.find(close, first) - first)));
  }
}

void collect(const Mark& mark, std::set<std::string>& keys) {
  if (const Text* text = std::get_if<Text>(&mark.shape)) collect(text->text, keys);
  if (const Label* label = std::get_if<Label>(&mark.shape)) collect(label->text, keys);
}

/// The keys of all that a trace says.
void collect(const Trace& trace, std::set<std::string>& keys) {
  for (const std::string* text : {&trace.title, &trace.subtitle, &trace.method_title, &trace.faulty,
                                  &trace.goal, &trace.grid.x_name, &trace.grid.y_name}) {
    collect(*text, keys);
  }
  for (const Column& column : trace.columns) collect(column.name, keys);
  for (const LegendEntry& entry : trace.legend) collect(entry.text, keys);
  for (const std::string& count : trace.counts) collect(count, keys);
  for (const Mark& mark : trace.backdrop) collect(mark, keys);
  for (const TraceStep& step : trace.steps) {
    collect(step.sentence, keys);
    collect(step.note, keys);
    collect(step.phase, keys);
    for (const std::string& cell : step.read) collect(cell, keys);
    for (const std::string& cell : step.row) collect(cell, keys);
    for (const CellChange& change : step.delta.cells) {
      if (change.look) collect(change.look->text, keys);
    }
    for (const Mark& mark : step.delta.set) collect(mark, keys);
    if (!step.decision) continue;
    collect(step.decision->question, keys);
    for (const std::string& answer : step.decision->answers) collect(answer, keys);
  }
}

/// Asked for by what a topic's entry says; what a faulty method's note says is in its title.
bool asked_for_by_rule(std::string_view own) {
  return own == "title" || own == "symbols" || own.starts_with("method.") || own.starts_with("note.") ||
         own.starts_with("column.");
}

/// A run whose words are of its own: a topic with arguments, and what its model's file holds, if it has one.
struct Rare {
  std::string topic;
  std::vector<Argument> given;
  std::string model{};
};

/// Two triangles, one before and one behind an eye between them.
const std::string before_and_behind =
    "v -1 0 -2\nv 1 0 -2\nv 0 1 -2\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 1 2 3\nf 4 5 6\n";

/// Inputs that say what no telling one does: degenerate ones, those at a border, those of a single pixel.
std::vector<Rare> rare_runs() {
  std::vector<Rare> runs{
      {"affine_2d", {{"method", "centre_added"}}},
      {"affine_2d", {{"factors", "scale 2,0"}}},
      {"affine_2d", {{"factors", "reflect x"}}},
      {"affine_2d", {{"factors", "translate 2,0; rotate 90"}, {"orders", "both"}}},
      {"affine_2d", {{"factors", "translate 2,0; translate 0,1"}, {"orders", "both"}}},
      {"affine_2d", {{"method", "centre_added"}, {"factors", "shear 1,0 about 1,1"}}},
      {"affine_2d", {{"method", "centre_added"}, {"factors", "shear 1,0"}}},
      {"affine_3d", {{"orders", "one"}}},
      {"affine_3d", {{"factors", "rotate 30 about x; rotate 20 about x"}}},
      {"affine_3d", {{"method", "decomposition"}, {"axis", "1,2,3"}}},
      {"back_face_culling",
       {{"method", "of_a_model"}, {"towards", "0,0,-1"}},
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"bresenham_line", {{"to", "5,0"}}},
      {"bresenham_line", {{"to", "1,2"}}},
      {"bresenham_line", {{"method", "dda"}, {"to", "0,0"}}},
      {"bresenham_line", {{"method", "dda"}, {"to", "1001,334"}}},
      {"bresenham_line", {{"method", "run_length"}, {"to", "0,0"}}},
      {"bresenham_line", {{"method", "run_length"}, {"to", "5,0"}}},
      {"bresenham_line", {{"method", "run_length"}, {"to", "7,5"}}},
      {"bresenham_line", {{"method", "first_octant"}, {"to", "0,0"}}},
      {"bresenham_line", {{"method", "first_octant"}, {"to", "2,1"}}},
      {"bresenham_line", {{"window", "-9,-9,-5,-5"}}},
      {"cohen_sutherland_2d", {{"line", "-5,1,-3,5"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "1,1,5,5"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "-5,5,5,5"}, {"window", "0,0,10,10"}, {"method", "codes_only"}}},
      {"cohen_sutherland_2d", {{"line", "-2,7.5,6.4,18"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "-9.7,3.3,14.1,12.9"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "-0.1,-0.7,10.3,9.9"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "-7,3,14.1,12.7"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "-3.1,-8.3,13.7,16.9"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_2d", {{"line", "-1e15,-1e15,1e15,1.1e15"}, {"window", "0,0,10,10"}}},
      {"cohen_sutherland_3d", {{"line", "1,1,1,20,1,1"}}},
      {"cohen_sutherland_3d", {{"line", "-5,1,1,-3,5,5"}}},
      {"flood_fill", {{"maze", "."}, {"at", "0,0"}}},
      {"flood_fill", {{"maze", "."}, {"at", "0,0"}, {"method", "recursive"}}},
      {"flood_fill", {{"at", "11,0"}, {"method", "unchecked_seed"}}},
      {"flood_fill", {{"at", "100,100"}, {"method", "unchecked_seed"}}},
      {"jittered", {{"method", "divided_by_asked"}, {"samples", "3"}}},
      {"liang_barsky", {{"line", "-8,5,5,15"}, {"window", "0,0,10,10"}}},
      {"liang_barsky", {{"line", "-2,7.5,6.4,18"}, {"window", "0,0,10,10"}}},
      {"liang_barsky", {{"line", "-3.1,-8.3,13.7,16.9"}, {"window", "0,0,10,10"}}},
      {"liang_barsky", {{"method", "box_parametric"}, {"space_line", "-5,1,1,-3,5,5"}}},
      {"liang_barsky_circle",
       {{"line", "-100000000,0.5,100000000,0.5"},
        {"circle", "0,0,1"},
        {"method", "discriminant_equals_zero"}}},
      {"liang_barsky_circle", {{"line", "1,1,1,1"}, {"method", "discriminant_equals_zero"}}},
      {"liang_barsky_circle", {{"line", "-1e16,4,1e16,4"}}},
      {"liang_barsky_circle", {{"line", "-1,0,9,0"}, {"method", "exact_decision"}}},
      {"liang_barsky_circle", {{"line", "5,0,0,0"}, {"method", "exact_decision"}}},
      {"perspective", {{"method", "divide_tested"}, {"points", "1,0,2"}, {"zoom", "0"}}},
      {"perspective", {{"method", "keep_z"}, {"wall", "12"}}},
      {"perspective", {{"method", "parallel_by_plane"}, {"turn", "0,30"}}},
      {"perspective", {{"at", "0,0,2"}, {"turn", "40,30"}}},
      {"pipeline", {{"pixel", "0,0"}}},
      {"pipeline", {{"turn", "-30"}, {"face", "7"}, {"pixel", "18,7"}}},
      {"pipeline", {{"eye", "0,0,-5"}}, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"pipeline", {{"eye", "5,0,0"}, {"target", "0,0,0"}}, "v 0 0 0\nv 0 1 1\nv 1 0 0\nv 1 1 1\nf 1 2 3\n"},
      {"pipeline", {{"eye", "0,0,0.5"}, {"target", "0,0,-9"}, {"face", "1"}}, before_and_behind},
      {"pipeline",
       {{"eye", "0,0,0.5"}, {"target", "0,0,-9"}, {"columns", "8"}, {"rows", "8"}},
       "v 0 0 -2\nv 0.25 0 -2\nv 0.1 0.25 -2\nf 1 2 3\n"},
      {"polygon_circle", {{"polygon", "-8,-1 8,-1 8,1 1,1 1,8 -1,8 -1,1 -8,1"}}},
      {"polygon_circle", {{"polygon", "-8,-4 -3,-8 8,-8 8,8 -8,8 -8,4 4,4 4,-4"}, {"tolerance", "0.2"}}},
      {"polygon_circle", {{"polygon", "-4,-4 4,-4 4,4 -4,4"}, {"tolerance", "0.2"}}},
      {"polygon_circle", {{"polygon", "-1,-1 1,-1 0,1"}}},
      {"polygon_circle", {{"polygon", "-1,-1 1,-1 0,1"}, {"method", "first_crossing"}}},
      {"polygon_circle", {{"polygon", "8,8 9,8 8,9"}}},
      {"polygon_circle", {{"polygon", "5,0 9,-3 9,3"}}},
      {"polygon_circle", {{"polygon", "0,-3 5,0 0,3"}}},
      {"polygon_circle", {{"polygon", "-8,-4 8,-4 8,-3 -7,-3 -7,3 8,3 8,4 -8,4"}}},
      {"polygon_circle", {{"polygon", "0,0 3,4 3,9 -3,9 -3,4"}}},
      {"sutherland_hodgman", {{"polygon", "10,10 15,12 12,15"}}},
      {"sutherland_hodgman", {{"polygon", "-9,1 5,1 5,2 -5,2 -5,4 5,4 5,5 -5,5 -5,7 5,7 5,8 -9,8"}}},
      {"viewport", {{"row_zero", "bottom"}, {"fit", "letterbox"}}},
      {"viewport", {{"points", "2,0"}, {"method", "clamped"}}}};
  for (const std::string line : {"1,5,12,5", "1,15,12,15", "-8,5,5,15"}) {
    for (const std::string method : {"parametric", "correctly_rounded"})
      runs.push_back({"liang_barsky", {{"line", line}, {"window", "0,0,10,10"}, {"method", method}}});
  }
  for (const std::string line : {"6,0,9,0", "-9,1,9,1", "-9,5,9,5", "-9,6,9,6", "1,1,1,1"}) {
    for (const std::string method : {"half_chord", "exact_decision"})
      runs.push_back({"liang_barsky_circle", {{"line", line}, {"method", method}}});
  }
  for (const std::string corners :
       {"1,0,0.5,1 3,0.5,0.5,1 3,-0.5,0.5,1", "1,0,0.5,1 3,0.5,0.5,-1 3,-0.5,0.5,-1",
        "0,0,0,1 3,0.5,-0.5,-1 3,-0.5,-0.5,-1", "1,1,1,1 -1,-1,-1,-1 1,0,0.5,1"})
    runs.push_back({"sutherland_hodgman", {{"method", "homogeneous"}, {"homogeneous", corners}}});
  return runs;
}

Trace told(const Rare& run, const Wording& wording) {
  const TopicEntry& topic = test::topic(run.topic);
  Arguments arguments = arguments_of(topic, run.given);
  if (run.model.empty()) return topic.run(arguments, {.wording = wording});
  Arguments with_model;
  for (Arguments::Entry entry : arguments.entries()) {
    if (entry.name == "model") {
      entry.text = "model.obj";
      entry.content = run.model;
    }
    with_model.set(std::move(entry));
  }
  return topic.run(with_model, {.wording = wording});
}

/// Texts that only inputs say which are not among these. The list may only become shorter.
std::set<std::string> said_elsewhere() {
  std::ifstream file(std::string(GRADUS_SOURCE_DIR) + "/tests/unit/visualize/stories/said_elsewhere.txt");
  std::set<std::string> keys;
  for (std::string key; std::getline(file, key);) keys.insert(key);
  return keys;
}

// A text that asks for a value which its story does not give ends the run that says it.
TEST(Telling, EverySentenceIsSaid) {
  if (test::sanitized) GTEST_SKIP() << "one trace in three";
  const Language language = marked();
  std::set<std::string> said;
  for (const Trace& trace : test::telling_traces(Wording(language))) collect(trace, said);
  for (const Notation& notation : {Notation{.rows = true}, Notation{.depth = {{1, -1}}}}) {
    for (const Trace& trace : test::telling_traces(Wording(language).with(notation))) collect(trace, said);
  }
  for (const Rare& run : rare_runs()) collect(told(run, Wording(language)), said);
  std::set<std::string> unsaid;
  for (const auto& [key, text] : language.texts()) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos || !find_entry(key.substr(0, dot)) || asked_for_by_rule(key.substr(dot + 1)))
      continue;
    if (!said.contains(key)) unsaid.insert(key);
  }
  if (std::getenv("GRADUS_UPDATE_GOLDEN")) {
    std::ofstream file(std::string(GRADUS_SOURCE_DIR) + "/tests/unit/visualize/stories/said_elsewhere.txt");
    for (const std::string& key : unsaid) file << key << "\n";
  }
  EXPECT_EQ(unsaid, said_elsewhere());
}

// --- Decisions

TEST(Telling, DecisionsAreWhole) {
  if (test::sanitized) return;
  for (const Language& language : languages()) {
    for (const Trace& trace : test::telling_traces(Wording(language))) {
      SCOPED_TRACE(language.code() + " " + trace.topic + " " + trace.method + " " + trace.subtitle);
      for (const TraceStep& step : trace.steps) {
        if (!step.decision) continue;
        EXPECT_NE(step.decision->question, "");
        EXPECT_GE(step.decision->answers.size(), 2u);
        EXPECT_LT(step.decision->answer, step.decision->answers.size());
        EXPECT_THAT(step.decision->branch, testing::MatchesRegex("[a-z][a-z ]*"));
        const std::set<std::string> different(step.decision->answers.begin(), step.decision->answers.end());
        EXPECT_EQ(different.size(), step.decision->answers.size()) << step.decision->question;
      }
    }
  }
}

/// "p_before" is a value of p, "code_a" one of code.
TEST(Telling, ValuesNameTheirQuantity) {
  for (const Trace& trace : test::shared_traces()) {
    for (const TraceStep& step : trace.steps) {
      for (const Field& field : step.fields) {
        const std::string& quantity = field.quantity.empty() ? field.name : field.quantity;
        EXPECT_THAT(quantity, testing::Not(testing::ContainsRegex("_(before|after|a|b|x|y|z|w|from|to)$")))
            << trace.topic << " " << step.type << " " << field.name;
      }
    }
  }
}

}  // namespace
}  // namespace gradus
