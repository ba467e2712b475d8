// What figures show in a notation is right there: told again from the code's numbers, by other means.

#include "figure/text/notation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "cli/files/notation_file.hpp"
#include "core/refusal.hpp"
#include "figure/text/wording.hpp"
#include "stories/notations.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"
#include "support/share.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

Trace told(std::string_view topic, const Notation& notation, std::initializer_list<Argument> given = {},
           std::string_view language = "en") {
  return trace_of(test::topic(topic), given, {.wording = Wording(*find_language(language)).with(notation)});
}

/// The texts of one mark of the drawing at the end, by its id.
std::map<std::string, std::string> drawn_texts(const Trace& trace) {
  std::map<std::string, std::string> texts;
  for (const TraceStep& step : trace.steps) {
    for (const std::string& id : step.delta.removed) texts.erase(id);
    for (const Mark& mark : step.delta.set) {
      if (const Text* text = std::get_if<Text>(&mark.shape)) texts[mark.id] = text->text;
      if (const Label* label = std::get_if<Label>(&mark.shape)) texts[mark.id] = label->text;
    }
  }
  return texts;
}

std::vector<Row> rows_of(const Trace& trace) {
  std::vector<Row> rows;
  for (const TraceStep& step : trace.steps) {
    if (!step.row.empty()) rows.push_back(step.row);
  }
  return rows;
}

bool same_result(const Trace& a, const Trace& b) {
  return std::ranges::equal(a.result, b.result, {}, &Field::name, &Field::name) &&
         std::ranges::equal(a.result, b.result, {}, &Field::value, &Field::value);
}

double number_in(std::string text) {
  for (const std::string_view sign : {"−", "≈"}) {
    for (std::size_t at = text.find(sign); at != text.npos; at = text.find(sign))
      text.replace(at, sign.size(), sign == "−" ? "-" : "");
  }
  return std::stod(text);
}

// --- The value

TEST(Notation, WithoutOneNothingChanges) {
  const Notation none;
  EXPECT_EQ(none.depth_of(0.25), 0.25);
  EXPECT_EQ(none.clip_depth_of(-3, 2), -3);
  EXPECT_EQ(none.third(4), 4);
  EXPECT_EQ(none.axis_name(2, "forward"), "forward");
  EXPECT_EQ(none.forward_name("forward"), "forward");
}

TEST(Notation, TurnsAxesAndDepths) {
  const Notation backward{.handedness = Handedness::right, .depth = {{-1, 1}}};
  for (const double z : {0.0, 0.25, 1.0, -2.0}) EXPECT_DOUBLE_EQ(backward.depth_of(z), 2 * z - 1);
  EXPECT_DOUBLE_EQ(backward.clip_depth_of(3, 4), 2 * 3 - 4);
  EXPECT_EQ(backward.third(2.5), -2.5);
  EXPECT_FALSE(std::signbit(backward.third(0)));
  EXPECT_EQ(backward.axis_name(2, "forward"), "−forward");
  const Notation uvn{.handedness = Handedness::right, .axes = {"u", "v", "n"}};
  EXPECT_EQ(uvn.axis_name(2, "forward"), "n");
  EXPECT_EQ(uvn.forward_name("forward"), "−n");
  const Notation suf{.handedness = Handedness::right, .axes = {"s", "u", "−f"}};
  EXPECT_EQ(suf.forward_name("forward"), "f");
}

TEST(Notation, ALabelGivenBesidesWins) {
  const Notation book{.symbols = {{"bresenham_line", {{"p", "d"}}}}};
  const Wording words = Wording().with(book);
  EXPECT_EQ(words.symbol("p"), "p");  // of no topic yet
  EXPECT_EQ(words.about("bresenham_line").symbol("p"), "d");
  EXPECT_EQ(words.about("liang_barsky").symbol("p"), "p");
  const Wording labelled = words.with(std::vector<SymbolLabel>{{"p", "P"}}).about("bresenham_line");
  EXPECT_EQ(labelled.symbol("p"), "P");
  EXPECT_EQ(labelled.renamed(), (std::vector<SymbolLabel>{{"p", "P"}}));
  EXPECT_TRUE(words.with(std::vector<SymbolLabel>{{"p", "p"}}).about("bresenham_line").renamed().empty());
}

TEST(Notation, OursNameSymbolsThatThereAre) {
  std::set<std::string> names;
  for (const Notation& notation : notations()) {
    EXPECT_TRUE(names.insert(notation.name).second);
    EXPECT_EQ(find_notation(notation.name), &notation);
    for (const auto& [topic, labels] : notation.symbols) {
      const auto symbols = topic_symbols(topic);
      for (const SymbolLabel& label : labels)
        EXPECT_TRUE(std::ranges::count(symbols, label.symbol)) << topic << " has no " << label.symbol;
    }
    EXPECT_TRUE(notation.bits.empty() || std::ranges::is_permutation(notation.bits, std::string("LRBT")));
    EXPECT_TRUE(notation.bits_in_space.empty() ||
                std::ranges::is_permutation(notation.bits_in_space, std::string("LRBTNF")));
  }
  EXPECT_EQ(find_notation("knuth"), nullptr);
}

// --- What runs show

TEST(Notation, DigitsOfCodesAreReordered) {
  const Trace code = told("cohen_sutherland_2d", {}), book = told("cohen_sutherland_2d", {.bits = "LRBT"});
  const auto code_rows = rows_of(code), book_rows = rows_of(book);
  ASSERT_EQ(code_rows.size(), book_rows.size());
  for (std::size_t i = 0; i < code_rows.size(); ++i) {
    for (const std::size_t column : {5u, 6u}) {
      const std::string& digits = code_rows[i][column];
      EXPECT_EQ(book_rows[i][column], std::string(digits.rbegin(), digits.rend()));
    }
  }
  const auto drawn = drawn_texts(book), plain = drawn_texts(code);
  EXPECT_EQ(drawn.at("bits"), "digits of a code: left · right · bottom · top");
  for (const auto& [id, digits] : plain) {
    if (id.starts_with("region")) EXPECT_EQ(drawn.at(id), std::string(digits.rbegin(), digits.rend())) << id;
  }
  EXPECT_TRUE(book.method_title.ends_with("in the code the digits of a code are top bottom right left"))
      << book.method_title;
  EXPECT_EQ(code.method_title.find("in the code"), std::string::npos);
  // An order asked for by the input goes before the notation's, as a label does
  EXPECT_EQ(rows_of(told("cohen_sutherland_2d", {.bits = "BTLR"}, {{"code_bits", "LRBT"}})), book_rows);
  const Trace asked = told("cohen_sutherland_2d", {.bits = "LRBT"}, {{"code_bits", "TBRL"}});
  EXPECT_EQ(rows_of(asked), code_rows) << "also the code's own";
  EXPECT_EQ(asked.method_title, code.method_title);
}

TEST(Notation, MatricesOfRowsAreTransposed) {
  const auto code = drawn_texts(told("affine_2d", {})), rows = drawn_texts(told("affine_2d", {.rows = true}));
  int entries = 0;
  const std::regex entry("(m\\d entry) (\\d) (\\d)");
  for (const auto& [id, text] : code) {
    std::smatch found;
    if (!std::regex_match(id, found, entry)) continue;
    ++entries;
    EXPECT_EQ(rows.at(found.str(1) + " " + found.str(3) + " " + found.str(2)), text);
  }
  EXPECT_GE(entries, 9);
  EXPECT_EQ(code.at("m0 heading"), "M = M2·M1 =");
  EXPECT_EQ(rows.at("m0 heading"), "M = M1·M2 =");
}

TEST(Notation, TheThirdAxisIsNegated) {
  const Trace code = told("viewing", {});
  const Trace book = told("viewing", {.handedness = Handedness::right, .axes = {"u", "v", "n"}});
  const auto expected = rows_of(code), found = rows_of(book);
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t k = 1; k < expected[i].size(); ++k) {
      const double sign = i == 2 ? -1 : 1;
      EXPECT_NEAR(number_in(found[i][k]), sign * number_in(expected[i][k]), 1e-12) << i << " " << k;
    }
  }
  EXPECT_EQ(found[2][0], "n");
  EXPECT_TRUE(book.method_title.ends_with("u = right, v = up, n = −forward in the code"))
      << book.method_title;
  EXPECT_TRUE(same_result(code, book));  // data for programs
}

TEST(Notation, DepthsRunAsTheBookHasThem) {
  const std::initializer_list<Argument> given{{"method", "transformation"}};
  const auto code = rows_of(told("perspective", {}, given));
  const auto book = rows_of(told("perspective", {.depth = {{-1, 1}}}, given));
  ASSERT_EQ(code.size(), book.size());
  for (std::size_t i = 0; i < code.size(); ++i)
    EXPECT_NEAR(number_in(book[i][2]), 2 * number_in(code[i][2]) - 1, 2e-3);
}

TEST(Notation, EveryMethodCanBeToldInEveryOne) {
  std::vector<Notation> all(notations().begin(), notations().end());
  all.push_back({.name = "own",
                 .bits = "LRBT",
                 .bits_in_space = "LRBTNF",
                 .rows = true,
                 .handedness = Handedness::right,
                 .depth = {{2, -0.5}}});
  const auto& code = test::shared_traces();
  std::size_t next = 0;
  for (const Notation& notation : all) {
    // Each is some of what the own one is
    const bool own = &notation == &all.back();
    if (!own && (test::sanitized || !test::in_share(next++, all.size() - 1))) continue;
    SCOPED_TRACE(notation.name);
    std::vector<std::vector<Trace>> told;  // in a language each
    for (std::size_t i = 0; i < languages().size(); ++i) {
      if (!test::in_share(next + i, languages().size())) continue;
      told.push_back(test::telling_traces(Wording(languages()[i]).with(notation)));
    }
    for (const std::vector<Trace>& traces : told) {
      ASSERT_EQ(traces.size(), code.size());
      for (std::size_t i = 0; i < code.size(); ++i) {
        SCOPED_TRACE(code[i].topic + " " + code[i].method);
        EXPECT_TRUE(same_result(traces[i], code[i]));
        EXPECT_EQ(traces[i].steps.size(), code[i].steps.size());
        EXPECT_EQ(traces[i].in_the_code.size(), told.front()[i].in_the_code.size());  // in every language
      }
    }
  }
}

// --- In JSON

Notation own(std::string_view json) { return cli::read_notation(std::string(json)); }

std::string refused(const std::string& text) {
  try {
    cli::read_notation(text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(NotationReader, TakesNamesAndJson) {
  EXPECT_EQ(own("foley"), *find_notation("foley"));
  EXPECT_EQ(own(" hea "), *find_notation("hearn"));
  const Notation read = own(R"({"symbols": {"dx": "Δx", "bresenham_line": {"p": "d"}},
    "bits": "LRBT", "bits_in_space": "NFLRBT", "vectors": "rows", "handedness": "right",
    "axes": ["u", "v", "n"], "depth": [-1, 1]})");
  EXPECT_EQ(read.symbols.at("bresenham_line"), (std::vector<SymbolLabel>{{"p", "d"}, {"dx", "Δx"}}));
  EXPECT_EQ(read.bits, "LRBT");
  EXPECT_EQ(read.bits_in_space, "NFLRBT");
  EXPECT_TRUE(read.rows);
  EXPECT_TRUE(read.looks_backward());
  EXPECT_EQ(read.axes, (std::vector<std::string>{"u", "v", "n"}));
  EXPECT_EQ(read.depth_of(0.5), 0);
  // Its name is all of it: the command of a figure needs no file
  EXPECT_EQ(read.name.find('\n'), std::string::npos);
  EXPECT_EQ(own(read.name), read);
}

TEST(NotationReader, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"foly",
       "--notation: expected one of foley, hearn, shirley, opengl, or a file like own.json, found "
       "'foly', did you mean 'foley'?"},
      {"", "--notation: expected one of foley"},
      {"none.json", "none.json"},
      {"{", "--notation: notation:1: "},
      {R"({"bits": "TBR"})",
       "bits: expected an order of the borders like \"TBRL\", the first digit to the left"},
      {R"({"bits": 3})", "bits: expected an order"},
      {R"({"bit": "TBRL"})", "bit: expected one of symbols, bits, "},
      {R"({"vectors": "row"})", "vectors: expected columns or rows, found 'row'"},
      {R"({"handedness": true})", "handedness: expected left or right, found true"},
      {R"({"axes": ["u", "v"]})", "axes: expected names of the three axes"},
      {R"({"depth": [1, 1]})", "depth: expected two different numbers"},
      {R"({"depth": [0, "1"]})", "depth: expected two different numbers"},
      {R"({"symbols": {"bresenham_lin": {"p": "d"}}})", "did you mean 'bresenham_line'?"},
      {R"({"symbols": {"bresenham_line": {"pp": "d"}}})",
       "symbols.bresenham_line.pp: expected one of the symbols"},
      {R"({"symbols": {"zzz": "d"}})", "symbols.zzz: expected a symbol of one of the topics"},
      {R"({"symbols": {"p": ""}})", "symbols.p: expected a text on one line"},
      {R"({"symbols": {"p": "☃"}})", "symbols.p: expected letters that can be drawn"},
      {R"({"symbols": []})", "symbols: expected an object"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_NE(refused(text).find(expected), std::string::npos) << text << ": " << refused(text);
}

}  // namespace
}  // namespace gradus
