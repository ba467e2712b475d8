// Of every story: each sentence is said with what its text asks for, and each step that decides says what.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "stories/topic.hpp"
#include "support/example_traces.hpp"

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
  for (const Mark& mark : trace.backdrop) collect(mark, keys);
  for (const TraceStep& step : trace.steps) {
    collect(step.sentence, keys);
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

/// Texts that only inputs say which are not among the telling ones. The list may only become shorter.
std::set<std::string> said_elsewhere() {
  std::ifstream file(std::string(GRADUS_SOURCE_DIR) + "/tests/unit/visualize/said_elsewhere.txt");
  std::set<std::string> keys;
  for (std::string key; std::getline(file, key);) keys.insert(key);
  return keys;
}

// A text that asks for a value which its story does not give ends the run that says it.
TEST(Telling, EverySentenceIsSaid) {
  const Language language = marked();
  std::set<std::string> said;
  for (const Trace& trace : test::telling_traces(Wording(language))) collect(trace, said);
  std::set<std::string> unsaid;
  for (const auto& [key, text] : language.texts()) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos || !find_entry(key.substr(0, dot)) || asked_for_by_rule(key.substr(dot + 1)))
      continue;
    if (!said.contains(key)) unsaid.insert(key);
  }
  if (std::getenv("GRADUS_UPDATE_GOLDEN")) {
    std::ofstream file(std::string(GRADUS_SOURCE_DIR) + "/tests/unit/visualize/said_elsewhere.txt");
    for (const std::string& key : unsaid) file << key << "\n";
  }
  EXPECT_EQ(unsaid, said_elsewhere());
}

// --- Decisions

/// Methods that decide nothing: they compute.
const std::set<std::string> deciding_nothing{"affine_2d factor_by_factor",   "affine_2d local_coordinates",
                                             "affine_2d one_matrix",         "affine_3d constant_offset",
                                             "affine_3d one_matrix",         "affine_3d row_vectors",
                                             "affine_3d turn_vector",        "parallel along",
                                             "parallel keep_x_and_y",        "parallel oblique",
                                             "parallel orthographic",        "perspective depth_precision",
                                             "perspective divide_untested",  "viewing cross_products",
                                             "viewing inverse_of_any_frame", "viewing minus_position",
                                             "viewing transposed",           "viewing view_to_world",
                                             "viewing world_to_view"};

TEST(Telling, DecisionsAreWhole) {
  for (const Language& language : languages()) {
    std::map<std::string, std::int64_t> decisions;
    for (const Trace& trace : test::telling_traces(Wording(language))) {
      const std::string method = trace.topic + " " + trace.method;
      SCOPED_TRACE(language.code() + " " + method + " " + trace.subtitle);
      std::int64_t& count = decisions[method];
      for (const TraceStep& step : trace.steps) {
        if (!step.decision) continue;
        ++count;
        EXPECT_NE(step.decision->question, "");
        EXPECT_GE(step.decision->answers.size(), 2u);
        EXPECT_LT(step.decision->answer, step.decision->answers.size());
        EXPECT_THAT(step.decision->branch, testing::MatchesRegex("[a-z][a-z ]*"));
        const std::set<std::string> different(step.decision->answers.begin(), step.decision->answers.end());
        EXPECT_EQ(different.size(), step.decision->answers.size()) << step.decision->question;
      }
    }
    for (const auto& [method, count] : decisions) {
      EXPECT_EQ(count == 0, deciding_nothing.contains(method)) << method;
    }
  }
}

/// "p_before" is a value of p, "code_a" one of code.
TEST(Telling, ValuesNameTheirQuantity) {
  for (const Trace& trace : test::telling_traces()) {
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
