// Variables in italics, quantities in their colours, in whole figures.

#include "figure/text/typesetting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "figure/figure.hpp"
#include "figure/text/metrics.hpp"
#include "support/example_traces.hpp"
#include "support/sheets.hpp"
#include "theme/theme.hpp"

namespace gradus {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (const Token& token : tokens_of(text))
    words.push_back(text.substr(token.begin, token.end - token.begin));
  return words;
}

TEST(Typesetting, TokensAreNames) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(words_of("p = 3·dx − 2x₀ < x′"), (Words{"p", "dx", "x₀", "x′"}));
  EXPECT_EQ(words_of("on NE's side"), (Words{"on", "NE", "side"}));
  EXPECT_EQ(words_of("1e-8 or 2e"), (Words{"or", "e"}));
  EXPECT_EQ(words_of("größer als a.code_b"), (Words{"größer", "als", "a", "code_b"}));
}

TEST(Typesetting, VariablesAreShort) {
  for (const char* name : {"p", "x", "dx", "x′", "t₀", "y1", "α"}) EXPECT_TRUE(is_variable(name)) << name;
  for (const char* name : {"E", "NE", "M", "enter", "is", "", "A1"}) EXPECT_FALSE(is_variable(name)) << name;
}

Sheet drawn(const Trace& trace, StepNumber number) {
  Playhead playhead(trace);
  return lay_out(figure_of(trace, playhead, number), {});
}

/// The pieces of a shape's text that are not as the rest, by their words.
std::map<std::string, TextPiece> special_pieces(const Sheet& sheet, Slot slot, std::string_view id) {
  std::map<std::string, TextPiece> found;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (!text || shape.slot != slot || !shape.id.starts_with(id)) continue;
    for (const TextPiece& piece : pieces_of(*text)) {
      if (piece.face != text->face || piece.paint != text->paint) found.emplace(piece.text, piece);
    }
  }
  return found;
}

TEST(Typesetting, OneQuantityLooksTheSameEverywhere) {
  const Trace trace = test::trace_of("bresenham_line", {{"from", "0,0"}, {"to", "7,3"}});
  ASSERT_GE(trace.quantities.size(), 3u);
  EXPECT_EQ(trace.quantities[0], "p");
  const Sheet sheet = drawn(trace, {4, 0});
  const Paint first = Paint::quantity(0);
  const auto sentence = special_pieces(sheet, Slot::sentence, "sentence");
  ASSERT_TRUE(sentence.contains("p"));
  EXPECT_EQ(sentence.at("p").face, Face::italic);
  EXPECT_EQ(sentence.at("p").paint, first);
  EXPECT_TRUE(sentence.contains("NE"));
  EXPECT_EQ(sentence.at("NE").face, Face::sans);
  const auto listing = special_pieces(sheet, Slot::listing, "line");
  ASSERT_TRUE(listing.contains("p"));
  EXPECT_EQ(listing.at("p").paint, first);
  const auto heading = special_pieces(sheet, Slot::table, "heading p");
  ASSERT_TRUE(heading.contains("p"));
  EXPECT_EQ(heading.at("p").face, Face::bold_italic);
  EXPECT_EQ(heading.at("p").paint, first);
  const auto chosen = special_pieces(sheet, Slot::drawing, "");
  ASSERT_TRUE(chosen.contains("NE"));
  EXPECT_EQ(chosen.at("NE").paint, sentence.at("NE").paint);
  std::size_t cells = 0;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (!text || !shape.id.starts_with("cell ") || !shape.id.ends_with(" p")) continue;
    ++cells;
    EXPECT_EQ(text->paint, first);
  }
  EXPECT_GE(cells, 2u);
}

/// The paints of all that a mark is drawn with, by the shape's id.
std::vector<Paint> paints_of(const Sheet& sheet, std::string_view id) {
  std::vector<Paint> paints;
  for (const Shape& shape : sheet.shapes) {
    if (shape.id != id) continue;
    if (const auto* disc = std::get_if<DiscShape>(&shape.what))
      paints.push_back(disc->fill == Paint::of(Tone::paper) ? disc->stroke : disc->fill);
    if (const auto* text = std::get_if<TextShape>(&shape.what); text && !text->is_rim())
      paints.push_back(text->paint);
  }
  return paints;
}

TEST(Typesetting, AnEndAndItsCodeHaveOneColour) {
  const Trace trace =
      test::trace_of("cohen_sutherland_2d", {{"line", "-3,-8,13,16"}, {"window", "0,0,10,10"}});
  const Paint a = Paint::quantity(0), b = Paint::quantity(2);
  const Sheet sheet = drawn(trace, {1, 0});
  const auto only = [&](std::string_view id) {
    const std::vector<Paint> paints = paints_of(sheet, id);
    EXPECT_EQ(paints.size(), 1u) << id;
    return paints.empty() ? std::optional<int>() : std::optional(paints.front().number);
  };
  const auto is_quantity = [&](std::string_view id) {
    for (const Paint paint : paints_of(sheet, id)) EXPECT_EQ(paint.part, Paint::Part::quantity) << id;
  };
  for (const char* id : {"end a", "end a name", "cut now", "cut now name", "region 04", "heading code_a"}) {
    is_quantity(id);
    EXPECT_EQ(only(id), 0) << id;
  }
  for (const char* id : {"end b", "end b name", "heading code_b"}) {
    is_quantity(id);
    EXPECT_EQ(only(id), 2) << id;
  }
  const auto sentence = special_pieces(sheet, Slot::sentence, "sentence");
  for (const char* word : {"a", "0101", "0100"}) {
    ASSERT_TRUE(sentence.contains(word)) << word;
    EXPECT_EQ(sentence.at(word).paint, a) << word;
  }
  const auto listing = special_pieces(sheet, Slot::listing, "line");
  ASSERT_TRUE(listing.contains("a") && listing.contains("b"));
  EXPECT_EQ(listing.at("a").paint, a);
  EXPECT_EQ(listing.at("b").paint, b);
  // A region that neither end lies in
  for (const Paint paint : paints_of(sheet, "region 01")) EXPECT_EQ(paint, Paint::text(Role::guide));
}

TEST(Typesetting, ACodeThatBothEndsHaveBelongsToTheOneNamedBeforeIt) {
  const Trace trace = test::trace_of("cohen_sutherland_2d", {{"line", "-3,5,-5,6"}, {"window", "0,0,10,10"}});
  const std::string code = trace.steps.front().row[5];
  ASSERT_EQ(code, trace.steps.front().row[6]);
  Sheet sheet;
  const auto add = [&](std::string id, std::string text) {
    TextShape shape{.baseline = {0, 0}, .text = std::move(text), .paint = Paint::of(Tone::ink)};
    sheet.shapes.push_back({Slot::sentence, std::move(id), std::move(shape)});
  };
  add("sentence 1", "b has the code");
  add("sentence 2", code + " and 10.0001.");
  add("sentence 3", "a bit in " + code + ".");
  add("title", "The code " + code);
  const std::vector<Row> rows(1, trace.steps.front().row);
  typeset(sheet, trace, rows);
  const auto spans = [&](std::size_t i) { return std::get<TextShape>(sheet.shapes[i].what).spans; };
  ASSERT_EQ(spans(0).size(), 1u);
  ASSERT_EQ(spans(1).size(), 1u);
  EXPECT_EQ(spans(1)[0].paint, Paint::quantity(2));
  ASSERT_EQ(spans(2).size(), 1u) << "a bit: the article";
  EXPECT_EQ(spans(2)[0].begin, 9u);
  EXPECT_TRUE(spans(3).empty());
}

TEST(Typesetting, WhatComesInAndOutIsColouredInPictureAndTable) {
  const Trace trace = test::trace_of("liang_barsky");
  const Sheet sheet = drawn(trace, {3, 0});
  std::map<int, int> dots;
  for (const Shape& shape : sheet.shapes) {
    const auto* disc = std::get_if<DiscShape>(&shape.what);
    if (!disc || shape.slot != Slot::drawing || !shape.id.ends_with(" dot")) continue;
    const Paint paint = disc->fill.part == Paint::Part::quantity ? disc->fill : disc->stroke;
    EXPECT_EQ(paint.part, Paint::Part::quantity) << shape.id;
    ++dots[paint.number];
  }
  EXPECT_GT(dots[0], 0) << "enter";
  EXPECT_GT(dots[2], 0) << "leave";
}

TEST(Typesetting, AReadersNameIsColouredAndTheCodesOwnStays) {
  const Wording wording(languages().front(), {{"p", "d"}});
  const Trace trace = test::telling_traces(wording, "bresenham_line").front();
  const Sheet sheet = drawn(trace, trace.telling);
  EXPECT_TRUE(special_pieces(sheet, Slot::sentence, "sentence").contains("d"));
  EXPECT_TRUE(special_pieces(sheet, Slot::listing, "line").contains("p"));
}

TEST(Typesetting, ABoxIsAsWideAsItsPieces) {
  std::size_t with_spans = 0;
  for (const Trace& trace : test::shared_traces()) {
    for (const Shape& shape : drawn(trace, trace.telling).shapes) {
      const TextShape* text = std::get_if<TextShape>(&shape.what);
      if (!text || text->spans.empty()) continue;
      ++with_spans;
      std::string all;
      double width = 0;
      for (const TextPiece& piece : pieces_of(*text)) {
        EXPECT_NEAR(piece.x, width, 1e-9);
        EXPECT_NEAR(piece.width, text_width(piece.text, piece.face, text->size), 1e-9);
        all += piece.text;
        width += piece.width;
      }
      EXPECT_EQ(all, text->text);
      EXPECT_NEAR(text->box().width, width, 1e-9);
    }
  }
  EXPECT_GT(with_spans, test::thinned(300, 4));
}

TEST(Typesetting, TheEnglishArticleIsUpright) {
  const Trace trace = test::trace_of("bresenham_line");
  const auto slanted = [&](std::string text) {
    Sheet sheet;
    sheet.shapes.push_back(
        {Slot::sentence, "sentence 1", TextShape{.baseline = {0, 0}, .text = std::move(text)}});
    typeset(sheet, trace);
    return std::get<TextShape>(sheet.shapes[0].what).spans.size();
  };
  EXPECT_EQ(slanted("it takes a step to x"), 1u);
  EXPECT_EQ(slanted("x, y and t"), 3u);
}

TEST(Typesetting, GreyscaleTellsQuantitiesApartByLines) {
  const Theme* grey = find_theme("greyscale");
  ASSERT_NE(grey, nullptr);
  EXPECT_TRUE(grey->quantities_underlined);
  for (const Theme& theme : themes()) {
    if (theme.quantities_underlined) continue;
    for (std::size_t i = 1; i < theme.quantity.size(); ++i) EXPECT_NE(theme.quantity[i], theme.quantity[0]);
  }
}

}  // namespace
}  // namespace gradus
