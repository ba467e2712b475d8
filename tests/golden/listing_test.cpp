// Which source lines a figure lists, and which one each kind of step marks: one golden file a topic and
// method. GRADUS_UPDATE_GOLDEN=1 writes the files anew; look at the difference before committing it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "figure/figure.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

std::string marked_line(const Figure& figure) {
  for (const Figure::ListingLine& line : figure.listing) {
    if (line.emphasis == Emphasis::strong) return line.line.text;
  }
  return "(none)";
}

/// The listing, and the line that every kind of step marks, without line numbers.
std::string listing_text(const Trace& trace) {
  std::string text = fmt::format("{}, {}\n\n", trace.topic, trace.method);
  for (const SourceLine& line : trace.listing) text += "  | " + line.text + "\n";
  text += "\n";
  std::set<std::string> seen;
  Playhead playhead(trace);
  for (const TraceStep& step : trace.steps) {
    const std::string line = marked_line(figure_of(trace, playhead, step.number));
    const std::string mark =
        fmt::format("{} marks: {}\n", step.type, line.substr(line.find_first_not_of(' ')));
    if (seen.insert(mark).second) text += mark;
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
  // An exhibit may be one wrong line and what it stands among, a method a loop of few
  EXPECT_GE(trace.listing.size(), method.standing == Standing::faulty ? 4u : 7u) << method.name;
  for (const SourceLine& line : trace.listing) {
    EXPECT_EQ(line.text.find("observe"), std::string::npos) << line.text;
    EXPECT_EQ(line.text.find("expect"), std::string::npos) << line.text;
    EXPECT_EQ(line.text.find("template"), std::string::npos) << line.text;
  }
}

TEST(Listing, ShowsAndMarksTheLinesOfTheGoldenFilesWithoutPlumbing) {
  const std::filesystem::path folder = std::filesystem::path(GRADUS_SOURCE_DIR) / "tests/golden/listings";
  std::size_t count = 0;
  for (const TopicEntry* entry : catalogue()) {
    for (const Method& method : entry->methods) {
      // Recorded once for both: that is what takes the time
      const Trace trace = test::trace_of(entry->name, {{"method", method.name}});
      expect_golden(listing_text(trace), folder / fmt::format("{}-{}.txt", entry->name, method.name));
      expect_no_plumbing(trace, method);
      ++count;
    }
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
