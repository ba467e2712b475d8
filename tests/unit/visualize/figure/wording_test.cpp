// Languages say the same, labels stand wherever a symbol does and nowhere else, and nothing is drawn as a
// box.

#include "figure/text/wording.hpp"

#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <set>

#include "cli/lecture/lecture.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/number_text.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/share.hpp"
#include "support/sheets.hpp"
#include "text/text_output.hpp"

namespace gradus {
namespace {

using Names = std::set<std::string>;

const Language& language(std::string_view code) {
  const Language* found = find_language(code);
  if (!found) throw std::invalid_argument("no language of that code");
  return *found;
}

Wording labelled(std::vector<SymbolLabel> labels, std::string_view code = "en") {
  return Wording(language(code), std::move(labels));
}

// --- Filling in ----------------------------------------------------------------------------------

TEST(Wording, PutsInValuesSymbolsAndCounts) {
  const Wording plain, own = labelled({{"p", "d"}});
  EXPECT_EQ(plain.say("bresenham_line.test.zero", fmt::arg("p", "5")), "p = 5");
  EXPECT_EQ(own.say("bresenham_line.test.zero", fmt::arg("p", "5")), "d = 5");
  EXPECT_EQ(own.symbol("p"), "d");
  EXPECT_EQ(own.symbol("NE"), "NE");
  EXPECT_EQ(plain.count("bresenham_line.in_runs", 1), "in 1 run");
  EXPECT_EQ(plain.count("bresenham_line.in_runs", 0), "in 0 runs");
  EXPECT_EQ(labelled({}, "de").count("bresenham_line.in_runs", 2), "in 2 Läufen");
  EXPECT_THROW(plain.say("bresenham_line.nothing"), std::logic_error);
  EXPECT_THROW(plain.say("bresenham_line.test.zero"), std::logic_error) << "a value is missing";
}

TEST(Wording, OnlyNamesInBracketsAreSymbols) {
  EXPECT_EQ(symbols_in("[p] in [0, 1], [NE] [x′] a[1] [] [p] [a b] [open"),
            (std::vector<std::string>{"p", "NE", "x′"}));
  EXPECT_EQ(values_in("{a} {b:>3} {{c}} {a}"), (std::vector<std::string>{"a", "b"}));
}

TEST(Wording, ALabelIsTakenLiterally) {
  for (const std::string label :
       {"{p}", "{", "}}", "[NE]", "\"'", "<b>p</b>", "&amp;", "\\", "%s", "\u200f", "δ′", "p = {0}", "p"}) {
    const Wording own = labelled({{"p", label}, {"NE", "wrong"}});
    EXPECT_EQ(own.say("bresenham_line.test.negative", fmt::arg("p", "−1")), label + " = −1 < 0");
    const Trace trace = test::trace_of("bresenham_line", {}, {.wording = own});
    EXPECT_EQ(trace.columns[3].name, label);
    EXPECT_EQ(trace.steps.front().row[4], "");
    EXPECT_EQ(trace.steps[1].read[4], label + " < 0");
    EXPECT_NE(trace.steps.front().sentence.find("so " + label + " = 2·3 − 7 = −1."), std::string::npos);
  }
}

TEST(Wording, AnyLabelAndAnyValueAreTakenLiterally) {
  constexpr std::string_view alphabet = "{}[]pxNE<>&\"'\\%: 0";
  std::mt19937 random(test::seed());
  const auto text = [&] {
    std::string out;
    for (auto n = random() % 8; n > 0; --n) out += alphabet[random() % alphabet.size()];
    return out;
  };
  for (int i = 0; i < 2000; ++i) {
    const std::string label = text(), value = text();
    EXPECT_EQ(labelled({{"p", label}}).say("bresenham_line.test.zero", fmt::arg("p", value)),
              label + " = " + value);
  }
}

TEST(Wording, ATopicsSymbolsAreThoseOfItsSection) {
  EXPECT_EQ(topic_symbols("bresenham_line"),
            (std::vector<std::string>{"E", "M", "N", "NE", "NW", "S", "SE", "SW", "W", "count", "dx", "dy",
                                      "k", "offset", "p", "row", "x", "y"}));
  EXPECT_EQ(topic_symbols("flood_fill"), (std::vector<std::string>{"n"}));
  EXPECT_TRUE(topic_symbols("bresenham").empty());
  EXPECT_TRUE(topic_symbols("").empty());
}

// --- Runs told in other words --------------------------------------------------------------------

/// Words of letters, digits and "_"; letters of other scripts are letters.
std::vector<std::string> words_in(std::string_view text) {
  // A no-break space, a product's dot and an exponent end a word as any sign does
  const auto letter = [](char32_t c) {
    constexpr std::u32string_view signs = U"\u00a0·²¹⁻";
    return c < 0x80 ? std::isalnum(static_cast<int>(c)) || c == U'_' : signs.find(c) == signs.npos;
  };
  std::vector<std::string> words(1);
  for (const char32_t c : code_points(text)) {
    if (letter(c)) words.back() += utf8_of({&c, 1});
    if (!letter(c) && !words.back().empty()) words.emplace_back();
  }
  return words;
}

/// Without "d = p in the code", which says what the listing calls it.
std::string without_names_in_code(const std::string& text) {
  static const std::regex note(" · [^·]* (in the code|im Code)");
  return std::regex_replace(text, note, "");
}

/// Whether a text says something in words; a formula alone is the same in every language.
bool has_words(std::string_view text) {
  return std::ranges::any_of(words_in(text), [](const std::string& word) {
    return word.size() >= 3 &&
           std::ranges::all_of(word, [](char c) { return std::isalpha(static_cast<unsigned char>(c)); });
  });
}

/// Every text of a trace that a person reads, but for the listing.
std::vector<std::string> texts_of(const Trace& trace) {
  std::vector<std::string> texts{trace.title, trace.subtitle,    trace.method_title, trace.faulty,
                                 trace.goal,  trace.grid.x_name, trace.grid.y_name};
  const auto add_label = [&texts](const Mark& mark) {
    if (const Label* label = std::get_if<Label>(&mark.shape)) texts.push_back(label->text);
    if (const Text* text = std::get_if<Text>(&mark.shape)) texts.push_back(text->text);
  };
  for (const Column& column : trace.columns) texts.push_back(column.name);
  for (const LegendEntry& entry : trace.legend) texts.push_back(entry.text);
  for (const Mark& mark : trace.backdrop) add_label(mark);
  for (const TraceStep& step : trace.steps) {
    texts.insert(texts.end(), {step.sentence, step.phase});
    for (const Row* row : {&step.read, &step.row}) texts.insert(texts.end(), row->begin(), row->end());
    for (const Mark& mark : step.delta.set) add_label(mark);
  }
  return texts;
}

/// Calls see(sheet, figure) for some steps of each trace; an ordinary run of one trace in `parts`.
template <class See>
void for_each_sheet(const std::vector<Trace>& traces, See see, std::size_t parts = 1) {
  std::size_t next = 0;
  for (const Trace& trace : traces) {
    if (!test::in_share(next++, parts)) continue;
    SCOPED_TRACE(fmt::format("{} {} {}", trace.topic, trace.method, trace.subtitle));
    Playhead playhead(trace);
    const std::size_t stride = std::max<std::size_t>(1, trace.steps.size() / test::thinned(12, 3));
    for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
      SCOPED_TRACE("step " + text_of(trace.steps[i].number));
      const Figure figure = figure_of(trace, playhead, trace.steps[i].number);
      see(lay_out(figure, {}), figure);
    }
  }
}

TEST(Labels, StandForTheSymbolEverywhereButInTheListing) {
  const std::vector<Trace>& plain = test::shared_traces();
  std::size_t next = 0;
  for (const std::string_view code : {"en", "de"}) {
    if (test::sanitized ? code == "en" : !test::in_share(next++, 2)) continue;
    const std::vector<Trace> traces = test::telling_traces(labelled({{"p", "d"}, {"NE", "T"}}, code));
    const Names old{"p", "NE"}, fresh{"d", "T"};
    std::size_t labels = 0;
    const auto check = [&](const std::string& text) {
      for (const std::string& word : words_in(without_names_in_code(text))) {
        EXPECT_FALSE(old.contains(word)) << text;
        labels += fresh.contains(word);
      }
    };
    for_each_sheet(traces, [&](const Sheet& sheet, const Figure& figure) {
      for (const Shape& shape : sheet.shapes) {
        const TextShape* text = std::get_if<TextShape>(&shape.what);
        if (text && shape.slot != Slot::listing) check(text->text);
      }
      check(caption_of(figure));
    });
    EXPECT_GT(labels, test::thinned(500, 3));
    ASSERT_EQ(traces.size(), plain.size());
    for (std::size_t i = 0; i < traces.size(); ++i) {
      for (const std::string& text : texts_of(traces[i])) check(text);
      EXPECT_TRUE(
          std::ranges::equal(traces[i].listing, plain[i].listing, {}, &SourceLine::text, &SourceLine::text));
    }
  }
}

TEST(Labels, EverySymbolOfATopicCanHaveOne) {
  if (test::sanitized) return;
  for (const TopicEntry* topic : catalogue()) {
    const std::vector<std::string> listed = topic_symbols(topic->name);
    const Names symbols(listed.begin(), listed.end());
    std::vector<SymbolLabel> labels;
    for (const std::string& symbol : symbols) labels.push_back({symbol, "_" + symbol});
    Names seen;
    std::size_t texts = 0;
    for (const Trace& trace : test::telling_traces(labelled(labels), topic->name)) {
      for (const std::string& text : texts_of(trace)) {
        ++texts;
        for (const std::string& word : words_in(without_names_in_code(text))) {
          EXPECT_FALSE(symbols.contains(word))
              << topic->name << ", " << trace.method << ": " << text << ": " << word << " has no label";
          if (word.starts_with("_")) seen.insert(word.substr(1));
        }
      }
    }
    EXPECT_GT(texts, 100u) << topic->name;
    // A label may have a suffix of its own: M1 is the first M
    EXPECT_TRUE(std::ranges::includes(seen, symbols)) << topic->name;
  }
}

/// Numbers in cells are the reader's: with a comma in German.
bool same_but_for_commas(std::optional<CellLook> a, std::optional<CellLook> b) {
  for (auto* look : {&a, &b}) {
    if (*look) std::ranges::replace((*look)->text, ',', '.');
  }
  return a == b;
}

TEST(Languages, TellTheSameRun) {
  if (test::sanitized) return;
  const std::vector<Trace>& english = test::shared_traces();
  for (const Language& other : languages()) {
    if (&other == &languages().front()) continue;
    const std::vector<Trace> told = test::telling_traces(Wording(other));
    ASSERT_EQ(told.size(), english.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
      const Trace &a = english[i], &b = told[i];
      SCOPED_TRACE(fmt::format("{} {} {}", a.topic, a.method, a.subtitle));
      EXPECT_EQ(&b.wording.language(), &other);
      EXPECT_EQ(a.topic + a.method, b.topic + b.method);
      for (const auto text : {&Trace::title, &Trace::subtitle, &Trace::method_title, &Trace::goal}) {
        EXPECT_NE(a.*text, b.*text);
      }
      EXPECT_EQ(a.faulty.empty(), b.faulty.empty());
      EXPECT_TRUE(a.legend.empty() ||
                  !std::ranges::equal(a.legend, b.legend, {}, &LegendEntry::text, &LegendEntry::text));
      EXPECT_TRUE(std::ranges::equal(a.legend, b.legend, {}, &LegendEntry::role, &LegendEntry::role));
      ASSERT_EQ(a.columns.size(), b.columns.size());
      for (std::size_t c = 0; c < a.columns.size(); ++c) {
        EXPECT_EQ(a.columns[c].id, b.columns[c].id);
        EXPECT_EQ(a.columns[c].numeric, b.columns[c].numeric);
        EXPECT_FALSE(b.columns[c].name.empty());
      }
      ASSERT_EQ(a.steps.size(), b.steps.size());
      for (std::size_t k = 0; k < a.steps.size(); ++k) {
        const TraceStep &x = a.steps[k], &y = b.steps[k];
        EXPECT_EQ(x.number, y.number);
        EXPECT_EQ(x.type + x.key, y.type + y.key);
        EXPECT_EQ(x.line, y.line);
        EXPECT_TRUE(x.sentence != y.sentence || !has_words(x.sentence)) << x.sentence;
        EXPECT_FALSE(y.sentence.empty());
        EXPECT_TRUE(std::ranges::equal(x.fields, y.fields, [](const Field& f, const Field& g) {
          return f.name == g.name && f.value == g.value;
        }));
        EXPECT_TRUE(std::ranges::equal(x.delta.cells, y.delta.cells, [](const auto& f, const auto& g) {
          return f.at == g.at && same_but_for_commas(f.look, g.look);
        }));
        EXPECT_EQ(x.delta.removed, y.delta.removed);
        EXPECT_TRUE(std::ranges::equal(x.delta.set, y.delta.set, {}, &Mark::id, &Mark::id));
        for (const auto row : {&TraceStep::read, &TraceStep::row}) {
          ASSERT_EQ((x.*row).size(), (y.*row).size());
          ASSERT_LE((x.*row).size(), a.columns.size());
          for (std::size_t c = 0; c < (x.*row).size(); ++c) {
            if (a.columns[c].numeric) EXPECT_EQ((x.*row)[c], with_decimal_points((y.*row)[c]));
          }
        }
      }
    }
  }
}

TEST(Languages, NumbersOfASentenceAreTheSame) {
  if (test::sanitized) return;
  // The digits of each word: "4-connected" is "4er-Nachbarschaft" in German
  const auto digits = [](const std::string& text) {
    std::multiset<std::string> found;
    for (std::string word : words_in(text)) {
      std::erase_if(word, [](char c) { return c < '0' || c > '9'; });
      if (!word.empty()) found.insert(word);
    }
    return found;
  };
  std::size_t sentences = 0;
  const std::vector<Trace>& english = test::shared_traces();
  for (const Language& other : languages().subspan(1)) {
    const std::vector<Trace> told = test::telling_traces(Wording(other));
    for (std::size_t i = 0; i < told.size(); ++i) {
      for (std::size_t k = 0; k < told[i].steps.size(); ++k, ++sentences) {
        EXPECT_EQ(digits(english[i].steps[k].sentence), digits(told[i].steps[k].sentence))
            << english[i].steps[k].sentence << "\n"
            << told[i].steps[k].sentence;
      }
    }
  }
  EXPECT_GT(sentences, 5000u);
}

TEST(Languages, TitlesAndCaptionsOfFilesAreToldToo) {
  const std::vector<StepNumber> one{{1, 0}}, some{{0, 0}, {2, 0}};
  const auto run = [](std::string_view code, std::string_view method) {
    return test::trace_of("bresenham_line", {{"method", std::string(method)}, {"to", "4,2"}},
                          {.wording = labelled({}, code)});
  };
  const Trace english = run("en", "decision_parameter"), german = run("de", "first_octant");
  EXPECT_EQ(heading_of(english, one), "Bresenham line, step 1 of 4");
  EXPECT_EQ(
      summary_of(english, some),
      "Bresenham line, steps 0 to 2 of 4, decision parameter. Draw the pixels nearest to a straight line, "
      "with integer additions only. Input: (0,\u00a00) to (4,\u00a02).");
  EXPECT_EQ(
      heading_of(german, some),
      "Bresenham-Linie (fehlerhaft: andere Steigungen als 0 bis 1 sind nicht vorgesehen: Die Linie endet "
      "anderswo), Schritte 0 bis 2 von 4");
  Playhead playhead(english);
  EXPECT_EQ(caption_of(figure_of(english, playhead, {0, 0})),
            "Bresenham line, decision parameter, step 0 of 4: " + english.steps.front().sentence +
                " Input: (0,\u00a00) to (4,\u00a02).");
}

TEST(Languages, TextAndCsvAreToldToo) {
  const Trace trace = test::trace_of("bresenham_line", {{"method", "first_octant"}, {"to", "2,4"}},
                                     {.wording = labelled({{"p", "d"}}, "de")});
  const std::string text = text_of(trace, false), csv = csv_of(trace);
  EXPECT_NE(text.find("fehlerhaft: andere Steigungen"), std::string::npos);
  EXPECT_NE(text.find("  d  Test   Schritt"), std::string::npos) << text;
  EXPECT_TRUE(csv.starts_with("number,type,line,k,x,y,p,test,step,sentence\r\n")) << "programs read these";
  EXPECT_NE(csv.find("d > 0"), std::string::npos);
}

TEST(Languages, EveryFigureHoldsItsTexts) {
  for (const Language& each : languages()) {
    for_each_sheet(
        test::telling_traces(Wording(each)),
        [](const Sheet& sheet, const Figure&) {
          EXPECT_FALSE(missing_glyph(sheet).has_value());
          for (const Shape& shape : sheet.shapes) {
            const TextShape* text = std::get_if<TextShape>(&shape.what);
            if (!text) continue;
            const Box box = text->box();
            EXPECT_TRUE(box.x >= 0 && box.right() <= sheet.width && box.bottom() <= sheet.height)
                << text->text;
            const bool must_be_whole = shape.id.starts_with("heading ") || shape.id == "faulty";
            if (must_be_whole) EXPECT_EQ(text->text.find("…"), std::string::npos) << text->text;
          }
          test::expect_texts_apart(sheet);
        },
        3);
  }
}

TEST(Languages, SentencesOfTheGalleryAreNotCutShort) {
  if (test::sanitized) return;
  std::size_t sentences = 0, next = 0;
  for (const Language& each : languages()) {
    for (const cli::LectureFigure& figure : cli::read_lecture(cli::gallery_lecture()).figures) {
      if (!test::in_share(next++, 2)) continue;
      const Trace trace = figure.spec.topic->run(figure.spec.arguments, {.wording = Wording(each)});
      Playhead playhead(trace);
      Look look;
      look.slots = {Slot::title, Slot::sentence};
      for (std::size_t i = 0; i < std::min<std::size_t>(trace.steps.size(), 500); ++i) {
        const Sheet sheet = lay_out(figure_of(trace, playhead, trace.steps[i].number), look);
        for (const Shape& shape : sheet.shapes) {
          const TextShape* text = std::get_if<TextShape>(&shape.what);
          if (!text || shape.slot != Slot::sentence) continue;
          ++sentences;
          EXPECT_EQ(text->text.find("…"), std::string::npos) << each.code() << ": " << text->text;
        }
      }
    }
  }
  EXPECT_GT(sentences, test::share_of(1000, 2));
}

// --- Glyphs -----------------------------------------------------------------------------------------------

TEST(Glyphs, AMissingOneIsFound) {
  Sheet sheet;
  const auto add = [&sheet](std::string text, Face face) {
    sheet.shapes.push_back({Slot::drawing, "t", TextShape{{0, 0}, std::move(text), face}});
  };
  add("äöüßÄÖÜ „p₀“ Δx′ − ½ → ∑ ⌈ẋ⌉ Ж", Face::bold);
  EXPECT_FALSE(missing_glyph(sheet));
  add("p 中 国", Face::sans);
  const auto missing = missing_glyph(sheet);
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->text, "p 中 国");
  EXPECT_EQ(missing->character, U'中');
  EXPECT_EQ(explained(*missing), "the figures' fonts have no glyph for U+4E2D");
}

TEST(Glyphs, MarksThatTurnTheDirectionAreNotDrawn) {
  for (const char* mark : {"\u061c", "\u200f", "\u202e", "\u2066", "\ufeff"}) {
    const auto missing = missing_glyph(mark, Face::sans);
    ASSERT_TRUE(missing);
    EXPECT_NE(explained(*missing).find(" is a control character"), std::string::npos);
  }
}

TEST(Glyphs, DependOnTheFace) {
  EXPECT_FALSE(missing_glyph("Ǆ", Face::sans));
  EXPECT_TRUE(missing_glyph("Ǆ", Face::mono));
  for (const Face face : {Face::sans, Face::bold, Face::italic, Face::mono, Face::mono_bold}) {
    EXPECT_FALSE(missing_glyph("dx ≤ −½ αω", face));
    EXPECT_TRUE(missing_glyph("a\nb", face));
    EXPECT_TRUE(missing_glyph("\u200f", face)) << "a right-to-left mark";
    EXPECT_TRUE(missing_glyph("\U0001F600", face));
  }
  EXPECT_EQ(explained(missing_glyph("\xff", Face::sans).value()), "it is not UTF-8");
}

TEST(Glyphs, AMissingOneInALabelIsFoundInTheFigure) {
  const Trace trace = test::trace_of("bresenham_line", {}, {.wording = labelled({{"p", "中"}})});
  Playhead playhead(trace);
  const auto missing = missing_glyph(lay_out(figure_of(trace, playhead, {1, 0}), {}));
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->character, U'中');
}

}  // namespace
}  // namespace gradus
