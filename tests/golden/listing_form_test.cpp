// Every method's listing reads like a textbook's: lines that fit a panel beside two drawings and are never
// broken, a heading for each function where there are several, nothing after a return, no comment that splits
// a statement; and its pseudocode has no bracket or comment for a value.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "figure/listing/pseudocode.hpp"
#include "support/example_traces.hpp"

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

TEST(ListingForm, IsThatOfATextbook) {
  for (const TopicEntry* entry : catalogue()) {
    for (const Method& method : entry->methods) {
      SCOPED_TRACE(fmt::format("{} {}", entry->name, method.name));
      const Trace trace = test::trace_of(entry->name, {{"method", method.name}}, {0, 1});
      expect_narrow(trace.listing);
      expect_nothing_after_return(trace.listing);
      expect_no_comment_inside(trace.listing);
      expect_textbook_pseudocode(trace.listing);
    }
  }
}

}  // namespace
}  // namespace gradus
