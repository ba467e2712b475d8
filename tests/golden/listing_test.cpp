// Which line of the listing each kind of step marks, which inputs can be dragged, and whether a run decides
// anything: one golden file per topic. GRADUS_UPDATE_GOLDEN=1 writes the files anew; look at the difference
// before committing it.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "figure/figure.hpp"
#include "figure/listing/pseudocode.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

std::string marked_line(const Figure& figure) {
  for (const Figure::ListingLine& line : figure.listing) {
    if (line.emphasis == Emphasis::strong) return line.line.text;
  }
  return "(none)";
}

/// The inputs that can be dragged in the drawing of step 0.
std::string dragged(const Trace& trace) {
  std::vector<std::string> names;
  for (const Handle& handle : trace.handles) {
    if (std::ranges::find(names, handle.parameter) == names.end()) names.push_back(handle.parameter);
  }
  return names.empty() ? "" : fmt::format("  dragged: {}\n", fmt::join(names, ", "));
}

/// Some methods only compute.
std::string decided(const Trace& trace) {
  const bool any =
      std::ranges::any_of(trace.steps, [](const TraceStep& step) { return step.decision.has_value(); });
  return any ? "" : "  decides nothing\n";
}

/// What each kind of step marks: one row per line, with the steps that mark it, in the order of their first.
std::string marks_of(const Trace& trace) {
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;  // a line -> its steps
  Playhead playhead(trace);
  for (const TraceStep& step : trace.steps) {
    const std::string line = marked_line(figure_of(trace, playhead, step.number));
    const std::string text = line.substr(line.find_first_not_of(' '));
    auto row = std::ranges::find(rows, text, [](const auto& r) { return r.first; });
    if (row == rows.end()) row = rows.insert(rows.end(), {text, {}});
    if (std::ranges::find(row->second, step.type) == row->second.end()) row->second.push_back(step.type);
  }
  std::string text;
  for (const auto& [line, steps] : rows) text += fmt::format("  {}: {}\n", fmt::join(steps, ", "), line);
  return text;
}

/// The marks of a topic's methods; those that mark the same stand together.
std::string marks_text(const std::vector<std::pair<std::string, std::string>>& marks) {
  std::string text;
  std::set<std::string> written;
  for (const auto& [name, rows] : marks) {
    if (!written.insert(rows).second) continue;
    std::vector<std::string> names;
    for (const auto& [other, others] : marks) {
      if (others == rows) names.push_back(other);
    }
    text += fmt::format("{}\n{}", fmt::join(names, ", "), rows);
  }
  return text;
}

void expect_golden(const std::string& text, const std::filesystem::path& path) {
  if (std::getenv("GRADUS_UPDATE_GOLDEN")) std::ofstream(path, std::ios::binary) << text;
  std::ostringstream golden;
  golden << std::ifstream(path, std::ios::binary).rdbuf();
  EXPECT_EQ(text, golden.str()) << path;
}

void expect_no_plumbing(const Trace& trace, const Method& method) {
  // An exhibit may be one wrong line and what it stands among, or a method that is a loop of few
  EXPECT_GE(trace.listing.size(), method.standing == Standing::faulty ? 4u : 7u) << method.name;
  for (const SourceLine& line : trace.listing) {
    EXPECT_EQ(line.text.find("observe"), std::string::npos) << line.text;
    EXPECT_EQ(line.text.find("expect"), std::string::npos) << line.text;
    EXPECT_EQ(line.text.find("template"), std::string::npos) << line.text;
  }
}

/// The same lines as a textbook writes them.
void expect_nothing_of_the_sources_signs(const std::vector<SourceLine>& listing) {
  const auto lines = pseudocode(listing);
  EXPECT_GE(2 * lines.size(), listing.size());
  EXPECT_TRUE(std::ranges::is_sorted(lines, {}, &SourceLine::number));
  for (const SourceLine& line : lines) {
    const auto from = std::ranges::find(listing, line.number, &SourceLine::number);
    ASSERT_NE(from, listing.end()) << line.text;
    EXPECT_EQ(line.text.find_first_not_of(' '), from->text.find_first_not_of(' ')) << "the indentation stays";
    const std::string code = line.text.substr(0, line.text.find("//"));
    for (const char* sign : {";", "{", "}", "std::", "auto", "::", "&&", "||", "==", "!=", "++", "--", "->"})
      EXPECT_EQ(code.find(sign), std::string::npos) << line.text;
  }
}

TEST(Listing, MarksTheLinesOfTheGoldenFilesWithoutPlumbing) {
  const std::filesystem::path folder = std::filesystem::path(GRADUS_SOURCE_DIR) / "tests/golden/marks";
  std::size_t count = 0;
  for (const TopicEntry* entry : catalogue()) {
    std::vector<std::pair<std::string, std::string>> marks;
    for (const Method& method : entry->methods) {
      // Recorded once for both: that is what takes the time
      const Trace trace = test::trace_of(entry->name, {{"method", method.name}});
      marks.push_back({method.name, dragged(trace) + decided(trace) + marks_of(trace)});
      expect_no_plumbing(trace, method);
      SCOPED_TRACE(fmt::format("{} {}", entry->name, method.name));
      expect_nothing_of_the_sources_signs(trace.listing);
      ++count;
    }
    expect_golden(marks_text(marks), folder / fmt::format("{}.txt", entry->name));
  }
  EXPECT_GE(count, 8u);
}

TEST(Listing, NumbersAreThoseOfTheFile) {
  const Trace trace = test::trace_of("bresenham_line");
  std::ifstream file(std::string(GRADUS_SOURCE_DIR) + "/" + trace.source_file);
  std::vector<std::string> lines{""};
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  for (const SourceLine& line : trace.listing) {
    EXPECT_NE(lines.at(static_cast<std::size_t>(line.number)).find(line.text), std::string::npos)
        << line.text;
  }
}

TEST(Listing, FindsDefinitionsAmongCallsAndDeclarations) {
  constexpr std::string_view source = R"(int span(int);
template <class O>
int span(int a, O&& o = {}) {
  expects(a > 0, "a {} {}",
          a, a);
  expect_finite(a);
  kept.reserve(2);
  return std::span(a).size();  // span( in a comment
}
)";
  const auto listing = listing_of(source, "span");
  ASSERT_EQ(listing.size(), 1u);
  EXPECT_EQ(listing[0].number, 8);
  EXPECT_EQ(listing[0].text, "return std::span(a).size();  // span( in a comment");
  EXPECT_TRUE(listing_of(source, "other").empty());
}

}  // namespace
}  // namespace gradus
