// What the stories of circles that clip show at every magnitude their flags take: numbers throughout, places
// on the paper, and sentences that their own numbers bear out.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <string>
#include <variant>

#include "stories/topic.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

using Given = std::map<std::string, std::string>;

/// What is refused: "flag: what was expected", or nothing.
std::string mistake(const std::string& topic, const Given& given) {
  try {
    test::trace_of(topic, given);
  } catch (const ArgumentError& error) {
    return fmt::format("{}: {}", error.parameter, error.what());
  }
  return "";
}

void expect_number(const std::string& text, const std::string& where) {
  for (const char* word : {"nan", "NaN", "inf"}) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      const auto letter = [&](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i]));
      };
      EXPECT_TRUE((at > 0 && letter(at - 1)) || letter(at + 3)) << where << ": " << text;
    }
  }
}

void expect_on_paper(const Mark& mark) {
  const auto place = [&](dvec2 p) {
    EXPECT_TRUE(std::abs(p.x) < 1e4 && std::abs(p.y) < 1e4) << mark.id << " at " << p.x << ", " << p.y;
  };
  if (const auto* dot = std::get_if<Dot>(&mark.shape)) place(dot->at);
  if (const auto* stroke = std::get_if<Stroke>(&mark.shape)) place(stroke->a), place(stroke->b);
  if (const auto* text = std::get_if<Text>(&mark.shape)) place(text->at), expect_number(text->text, mark.id);
  if (const auto* label = std::get_if<Label>(&mark.shape))
    place(label->at), expect_number(label->text, mark.id);
  if (const auto* path = std::get_if<Path>(&mark.shape)) std::ranges::for_each(path->points, place);
  if (const auto* area = std::get_if<Area>(&mark.shape)) {
    for (const auto& ring : area->rings) std::ranges::for_each(ring, place);
  }
}

void expect_field(const Field& field) {
  if (const double* x = std::get_if<double>(&field.value)) EXPECT_TRUE(std::isfinite(*x)) << field.name;
}

/// "… = 3 < 5, so …": whether that is so. The number of such claims.
int expect_true(std::string sentence) {
  for (std::size_t at; (at = sentence.find("−")) != std::string::npos;) sentence.replace(at, 3, "-");
  for (std::size_t at; (at = sentence.find("≈")) != std::string::npos;) sentence.replace(at, 3, "~");
  static const std::regex claim("[=~] ([-0-9.e+]+) ([<=>~]) ([-0-9.e+]+)(, so| vom)");
  std::smatch found;
  if (!std::regex_search(sentence, found, claim)) return 0;
  const double a = std::strtod(found[1].str().c_str(), nullptr),
               b = std::strtod(found[3].str().c_str(), nullptr);
  switch (found[2].str()[0]) {
    case '<':
      EXPECT_LT(a, b) << sentence;
      break;
    case '>':
      EXPECT_GT(a, b) << sentence;
      break;
    case '=':
      EXPECT_EQ(a, b) << sentence;
      break;
    default:
      EXPECT_NEAR(a, b, 1e-3 * std::abs(b)) << sentence;
  }
  return 1;
}

/// Runs it in both languages; the number of claims in its sentences, -1 where it is refused.
int expect_sound(const std::string& topic, const Given& given) {
  std::string told = topic;
  for (const auto& [name, value] : given) told += fmt::format(" --{}={}", name, value);
  SCOPED_TRACE(told);
  int claims = 0;
  for (const Language& language : languages()) {
    Recording recording;
    recording.wording = Wording(language);
    try {
      const Trace trace = test::trace_of(topic, given, recording);
      expect_number(trace.subtitle, "subtitle");
      for (const TraceStep& step : trace.steps) {
        expect_number(step.sentence, step.type);
        claims += expect_true(step.sentence);
        for (const std::string& cell : step.row) expect_number(cell, "row");
        for (const Field& field : step.fields) expect_field(field);
        for (const Mark& mark : step.delta.set) expect_on_paper(mark);
      }
      for (const Field& field : trace.result) expect_field(field);
    } catch (const ArgumentError& error) {
      EXPECT_TRUE(given.contains(error.parameter)) << error.parameter << ": " << error.what();
      expect_number(error.what(), "refusal");
      return -1;
    }
  }
  return claims;
}

constexpr const char* magnitudes[] = {"5e-324", "1e-310", "1e-290", "1e-200", "1e-154",
                                      "1e-100", "1e-60",  "1e-8",   "1",      "12345.6",
                                      "1e8",    "1e17",   "1e60",   "1e100",  "1e154",
                                      "1e200",  "1e290",  "1e300",  "1e308",  "1.7976931348623157e308"};

TEST(ClippingCircleStory, SegmentsOfAnyMagnitude) {
  int told = 0, claims = 0;
  for (const char* method :
       {"half_chord", "exact_decision", "without_empty_test", "discriminant_equals_zero"}) {
    for (const char* m : magnitudes) {
      const std::string x(m);
      const Given cases[] = {
          {{"line", x + ",-3,-1,3"}},
          {{"line", "-" + x + ",-3," + x + ",3"}},
          {{"line", "-" + x + "," + x + "," + x + "," + x}, {"circle", "0,0," + x}},
          {{"line", "0,0,0," + x}, {"circle", "0,0," + x}},
          {{"line", "-3," + x + ",3," + x}, {"circle", "0,0,5"}},
          {{"line", "-1," + x + ",1," + x}, {"circle", "0,0,0"}},
          {{"line", x + ",0," + x + ",0"}},
          {{"circle", x + ",0,5"}},
          {{"circle", "0,0," + x}},
          {{"circle", x + "," + x + "," + x}},
      };
      for (Given given : cases) {
        given["method"] = method;
        const int found = expect_sound("liang_barsky_circle", given);
        told += found >= 0;
        claims += std::max(0, found);
      }
    }
  }
  EXPECT_GE(told, 400);
  EXPECT_GE(claims, 60);
}

// D was no number, and the sentence said "3e+200/inf = 0 = 5 … and it touches"
TEST(ClippingCircleStory, WhatSquaresOfSquaresCannotHoldIsRefused) {
  EXPECT_EQ(mistake("liang_barsky_circle", {{"line", "1e200,-3,-1,3"}}),
            "line: a segment from 6.3e-61 to 1.6e60 expected, for this method squares squares "
            "(exact_decision takes "
            "any), found 1e+200");
  EXPECT_EQ(mistake("liang_barsky_circle", {{"circle", "0,0,1e-100"}}),
            "circle: a radius from 6.3e-61 to 1.6e60 expected, for this method squares squares "
            "(exact_decision takes "
            "any), found 1e-100");
  EXPECT_EQ(mistake("liang_barsky_circle", {{"line", "1e200,-3,-1,3"}, {"method", "exact_decision"}}), "");
  EXPECT_EQ(mistake("liang_barsky_circle", {{"line", "1e308,-3,-1,3"}, {"method", "exact_decision"}}),
            "line: coordinates up to 1e300 in size expected, found 1e+308");
  EXPECT_TRUE(mistake("liang_barsky_circle", {{"circle", "1e17,0,5"}})
                  .starts_with("circle: expected numbers that a scale can tell apart, found a scale from "));
  const Trace far =
      test::trace_of("liang_barsky_circle", {{"line", "1e200,-3,-1,3"}, {"method", "exact_decision"}});
  EXPECT_EQ(far.steps.back().sentence, "The circle keeps (4,\u00a03) to (−1,\u00a03).");
}

// A scale of length 0, and 2.3e-290/1e+18 = 0
TEST(ClippingCircleStory, NumbersNearTheSmallestAreNot0) {
  const auto refused = testing::StartsWith("circle: expected numbers that a scale can tell apart");
  for (const char* method : {"half_chord", "exact_decision", "discriminant_equals_zero"}) {
    EXPECT_THAT(
        mistake("liang_barsky_circle",
                {{"method", method}, {"line", "-5e-324,-5e-324,-5e-324,-5e-324"}, {"circle", "0,0,0"}}),
        refused)
        << method;
  }
  EXPECT_THAT(
      mistake("polygon_circle",
              {{"polygon", "-7e-320,-7e-320 7e-320,-3e-320 2e-320,0 -3e-320,7e-320"}, {"circle", "0,0,0"}}),
      refused);
  const Trace near =
      test::trace_of("liang_barsky_circle", {{"line", "-9.32e-236,2.3e-308,-1e+18,-2.3e-308"}});
  EXPECT_NE(near.steps.at(1).sentence.find("= 2.3e-290/1e+18 = 2.3e-308 < 5, so"), std::string::npos)
      << near.steps.at(1).sentence;
}

TEST(ClippingCircleStory, NearTangentsAreToldByD) {
  // Four digits say that the line passes at the radius
  const Trace near = test::trace_of("liang_barsky_circle", {{"line", "-9,4.9999999,9,4.9999999"}});
  EXPECT_NE(near.steps.at(1).sentence.find("≈ 5 ≈ 5, so D = "), std::string::npos)
      << near.steps.at(1).sentence;
  EXPECT_NE(near.steps.at(1).sentence.find("> 0: it crosses"), std::string::npos);
  // Half the chord has lost its digits
  const Trace lost = test::trace_of("liang_barsky_circle", {{"line", "-1e16,4,1e16,4"}});
  EXPECT_NE(
      lost.steps.back().sentence.find("without rounding on the way it would be (−3,\u00a04) to (3,\u00a04)"),
      std::string::npos)
      << lost.steps.back().sentence;
}

TEST(ClippingCircleStory, PolygonsOfAnyMagnitude) {
  int told = 0;
  for (const char* method : {"arcs", "first_crossing"}) {
    for (const char* m : magnitudes) {
      const std::string x(m), n = "-" + x;
      const Given cases[] = {
          {{"polygon", fmt::format("{1},{1} {0},{1} {0},{0} {1},{0}", x, n)}},
          {{"polygon", fmt::format("{1},{1} {0},{1} {0},{0} {1},{0}", x, n)}, {"circle", "0,0," + x}},
          {{"polygon", fmt::format("0,0 {0},0 0,{0}", x)}, {"circle", "0,0," + x}, {"tolerance", x}},
          {{"polygon", fmt::format("{1},3 {0},3 0,{0}", x, n)}},
          {{"polygon", fmt::format("{1},3 {0},3 0,4", x, n)}, {"circle", "0,0,0"}},
          {{"circle", x + ",0,5"}},
          {{"circle", "0,0," + x}},
          {{"circle", x + "," + x + "," + x}},
      };
      for (Given given : cases) {
        given["method"] = method;
        told += expect_sound("polygon_circle", given) >= 0;
      }
    }
  }
  EXPECT_GE(told, 150);
}

TEST(ClippingCircleStory, AreasBeyondDoublesAreTold) {
  const auto last = [](const char* size) {
    return test::trace_of("polygon_circle", {{"polygon", fmt::format("0,0 {0},0 {0},{0} 0,{0}", size)},
                                             {"circle", fmt::format("0,0,{}", size)}});
  };
  EXPECT_EQ(last("2").steps.back().sentence, "1 piece is left, with an area of 3.142.");
  EXPECT_EQ(last("2e100").steps.back().sentence, "1 piece is left, with an area of 3.14e+200.");
  const Trace large = last("2e200"), small = last("2e-200");
  EXPECT_EQ(large.steps.back().sentence, "1 piece is left, with an area of 3.14e+400.");
  EXPECT_EQ(small.steps.back().sentence, "1 piece is left, with an area of 3.14e-400.");
  EXPECT_EQ(std::get<std::string>(large.result.at(0).value), "3.14e+400");
  EXPECT_EQ(std::get<std::string>(small.result.at(0).value), "3.14e-400");
}

}  // namespace
}  // namespace gradus
