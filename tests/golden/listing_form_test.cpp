// Every method's listing reads like a textbook's, whatever the options make it list: lines that fit a panel
// beside two drawings and are never broken, a heading for each function where there are several, nothing
// after a return, no comment that splits a statement; and its pseudocode has no bracket or comment for a
// value. No two methods of a topic show the same listing, but for those that differ in nothing that a listing
// could say.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "figure/listing/pseudocode.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"

namespace gradus {
namespace {

/// What fits beside two drawings.
constexpr std::size_t widest = 34;

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// In characters, not in bytes.
std::size_t length_of(std::string_view line) {
  return static_cast<std::size_t>(
      std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

void expect_narrow(const std::vector<SourceLine>& listing) {
  for (const SourceLine& line : listing) EXPECT_LE(length_of(line.text), widest) << line.text;
}

/// A return that is not in a branch ends its block: a line as deep as it must begin another function or
/// branch.
void expect_nothing_after_return(const std::vector<SourceLine>& listing) {
  for (std::size_t i = 0; i + 1 < listing.size(); ++i) {
    const std::string_view text = listing[i].text,
                           before = i == 0 ? "" : std::string_view(listing[i - 1].text);
    if (!text.substr(indent_of(text)).starts_with("return")) continue;
    // The one statement of a question above it
    if (i > 0 && indent_of(before) < indent_of(text) && !before.ends_with("{")) continue;
    // It goes on below
    std::size_t end = i;
    while (end + 1 < listing.size() && listing[end].text.find(';') == std::string::npos) ++end;
    if (end + 1 == listing.size()) continue;
    const std::string& next = listing[end + 1].text;
    const bool ends =
        indent_of(next) < indent_of(text) || is_heading(next) || next.find("case ") != std::string::npos;
    EXPECT_TRUE(ends) << text << "\n" << next;
  }
}

/// A comment behind an operator or "(" that keeps the rest of its statement on a line of its own.
void expect_no_comment_inside(const std::vector<SourceLine>& listing) {
  for (const SourceLine& line : listing) {
    const std::size_t comment = line.text.find("//");
    if (comment == std::string::npos || comment <= indent_of(line.text)) continue;
    const std::size_t last = line.text.find_last_not_of(' ', comment - 1);
    EXPECT_NE(std::string_view(";{}").find(line.text[last]), std::string::npos) << line.text;
  }
}

/// "x ← (0)", "f ← (p) →" or one that ends on another line: not the brackets of "t ← (b - r) / a".
bool is_bracketed_value(std::string_view text) {
  const std::string_view sign = "← (";
  std::size_t at = text.find(sign);
  if (at == std::string_view::npos) return false;
  at += sign.size();
  for (int depth = 1; depth > 0 && at < text.size(); ++at)
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
  const std::string_view rest = text.substr(at);
  return rest.empty() || rest.starts_with(",") || rest.starts_with("  //") || rest.starts_with(" →");
}

void expect_textbook_pseudocode(const std::vector<SourceLine>& listing) {
  for (const SourceLine& line : pseudocode(listing)) {
    EXPECT_FALSE(is_bracketed_value(line.text)) << line.text;
    EXPECT_EQ(line.text.find("← //"), std::string::npos) << line.text;
    EXPECT_LE(length_of(line.text), widest + 8) << line.text;
  }
}

/// As shown, with what a fault strikes out.
std::string text_of(const Trace& trace) {
  std::string text;
  for (const SourceLine& line : shown_listing(trace))
    text += fmt::format("{}{}\n", line.change == Change::struck ? "- " : "", line.text);
  return text;
}

/// The trace of a run; nothing where it is refused, as some options are by some methods.
std::optional<Trace> trace_if_any(const TopicEntry& topic, const std::map<std::string, std::string>& given) {
  try {
    return test::trace_of(topic.name, given, {0, 1});
  } catch (const ArgumentError&) {
    return std::nullopt;
  } catch (const ContractViolation&) {
    return std::nullopt;
  }
}

/// What may have a listing of its own: each method, with each choice and flag that it takes, and the runs
/// that say what such a run leaves unsaid.
std::vector<std::map<std::string, std::string>> runs_with_options(const TopicEntry& topic) {
  std::vector<std::map<std::string, std::string>> runs;
  for (test::Run& run : test::runs_of(topic)) runs.push_back(std::move(run.given));
  for (const Method& method : topic.methods) {
    for (const Parameter& parameter : topic.parameters) {
      std::vector<std::string> values;
      if (parameter.type == ParameterType::choice) values = parameter.choices;
      if (parameter.type == ParameterType::flag) values = {"yes"};
      for (const std::string& value : values)
        runs.push_back({{"method", method.name}, {parameter.name, value}});
    }
  }
  return runs;
}

TEST(ListingForm, IsThatOfATextbook) {
  std::set<std::string> judged, of_methods;
  int next = 0;
  for (const TopicEntry* entry : catalogue()) {
    for (const auto& given : runs_with_options(*entry)) {
      if (test::sanitized && next++ % 4 != 0) continue;  // golden/trace_hash runs them there
      SCOPED_TRACE(fmt::format("{} {}", entry->name, fmt::join(given, " ")));
      const auto trace = trace_if_any(*entry, given);
      if (!trace) continue;
      if (given.size() == 1) of_methods.insert(text_of(*trace));
      if (!judged.insert(text_of(*trace)).second) continue;
      expect_narrow(trace->listing);
      expect_nothing_after_return(trace->listing);
      expect_no_comment_inside(trace->listing);
      expect_textbook_pseudocode(trace->listing);
    }
  }
  EXPECT_GT(judged.size(), of_methods.size()) << "options list something else, too";
}

/// Methods that show the same listing, and why that is right.
struct Shared {
  std::string methods, why;
};
const std::vector<Shared>& shared_listings() {
  static const std::vector<Shared> all{
      {"accumulation_buffer/accumulate accumulation_buffer/passes_side_by_side",
       "the same method, with more and more passes"},
      {"adaptive/pictures adaptive/thin", "the same method on two scenes, one of them thin"},
      {"antialiased_line/side_by_side antialiased_line/continued",
       "the same methods side by side, on a star of lines or on the one given"},
      {"area_sampling/pixel_areas area_sampling/moving",
       "the same method on a shape, at one place or several"},
      {"back_face_culling/normal_and_view back_face_culling/of_a_model",
       "the same method on a whole model: its test tells the pictures apart"},
      {"back_face_culling/screen_area back_face_culling/by_cost",
       "the cheapest of the methods whose costs it shows"},
      {"cohen_sutherland_3d/correctly_rounded cohen_sutherland_3d/view_volume",
       "the same method on two kinds of region: it asks both the same questions"},
      {"illumination/phong illumination/lights_side_by_side illumination/highlight_lobes",
       "the same method with other lamps, or with other exponents"},
      {"poisson_disc/bridson poisson_disc/pictures", "the method whose samples the pictures are made with"},
      {"subdivision_surface/catmull_clark subdivision_surface/levels",
       "the same method, told at one vertex or as whole levels"},
      {"supersampling/more_samples supersampling/rays",
       "the same method, on other scenes and numbers of samples"},
      {"supersampling/supersample supersampling/filters",
       "the same method for every filter: their weights are listed above it"},
  };
  return all;
}

TEST(ListingForm, IsSharedOnlyWhereMethodsDifferInTheirInput) {
  std::set<std::string> found, known;
  for (const TopicEntry* entry : catalogue()) {
    std::map<std::string, std::vector<std::string>> methods;  // by listing
    for (const Method& method : entry->methods) {
      const Trace trace = test::trace_of(entry->name, {{"method", method.name}}, {0, 1});
      methods[text_of(trace)].push_back(fmt::format("{}/{}", entry->name, method.name));
    }
    for (const auto& [listing, names] : methods) {
      if (names.size() > 1) found.insert(fmt::format("{}", fmt::join(names, " ")));
    }
  }
  for (const Shared& shared : shared_listings()) {
    EXPECT_GE(shared.why.size(), 20u) << shared.methods;
    known.insert(shared.methods);
  }
  EXPECT_EQ(found, known);
}

}  // namespace
}  // namespace gradus
