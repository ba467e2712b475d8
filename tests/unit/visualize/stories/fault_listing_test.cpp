// The listing of a fault that is written as a difference: the taught one, in which lines are struck out and
// others put in.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "figure/listing/pseudocode.hpp"
#include "json/json.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view faulty_source = R"(void first(int a) {
  int i = 0;
  //- while (i < a) {
  //-   if constexpr (observed<O>) observer(Told{i});
  for (; i <= a;) {  //+
    if constexpr (observed<O>) observer(Told{i + 1});
    ++i;
    //- expects(i <= a, "{}",
    //-         i);
    // And no more  //+
  }
}
)";

std::vector<std::string> changed_rows(const std::vector<SourceLine>& lines) {
  std::vector<std::string> rows;
  for (const SourceLine& line : lines) {
    const std::string_view sign = line.change == Change::struck  ? "-"
                                  : line.change == Change::added ? "+"
                                                                 : " ";
    rows.push_back(fmt::format("{}{} {}", line.number, sign, line.text));
  }
  return rows;
}

TEST(FaultListing, HasWhatIsStruckOutApart) {
  EXPECT_THAT(
      changed_rows(listing_of(faulty_source, "first")),
      ElementsAre("2  int i = 0;", "5+ for (; i <= a;) {", "7    ++i;", "10+   // And no more", "11  }"));
  EXPECT_THAT(changed_rows(struck_of(faulty_source, "first")), ElementsAre("3- while (i < a) {"));
}

Trace changed_trace() {
  Trace trace;
  trace.listing = listing_of(faulty_source, "first");
  trace.struck = struck_of(faulty_source, "first");
  return trace;
}

TEST(FaultListing, IsShownInTheOrderOfItsFile) {
  EXPECT_THAT(changed_rows(shown_listing(changed_trace())),
              ElementsAre("2  int i = 0;", "3- while (i < a) {", "5+ for (; i <= a;) {", "7    ++i;",
                          "10+   // And no more", "11  }"));
}

TEST(FaultListing, IsWrittenAsPseudocodeOnBothSides) {
  Trace trace = changed_trace();
  write_pseudocode(trace);
  EXPECT_THAT(changed_rows(trace.struck), ElementsAre("3- while i < a do"));
  EXPECT_THAT(changed_rows(trace.listing),
              ElementsAre("2  i ← 0", "5+ while i ≤ a do", "7    i ← i + 1", "10+   // And no more"));
}

/// What stands in a file of the project.
std::string file_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> plain_texts(const std::vector<SourceLine>& lines) {
  std::vector<std::string> texts;
  for (const SourceLine& line : lines) texts.push_back(line.text);
  return texts;
}

// Every entry [fault] of function: without what is put in, and with what is struck out, it is the listing of
// the function, as the taught header has it.
TEST(FaultListing, IsTheTaughtOneOnceTheChangesAreTakenBack) {
  const std::filesystem::path root = std::filesystem::path(GRADUS_SOURCE_DIR) / "algorithms";
  const std::regex entry(R"(\[(\w+)\] of (\w+)\n)"), include("#include \"([^\"]+)\"");
  std::size_t found = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(root)) {
    if (file.path().extension() != ".faults") continue;
    const std::string faults = file_text(file.path());
    std::string made = (file.path().parent_path() / file.path().stem()).string() + "_notes.hpp";
    made = made.substr(std::string(GRADUS_SOURCE_DIR).size() + 1);
    for (std::sregex_iterator at(faults.begin(), faults.end(), entry), end; at != end; ++at) {
      SCOPED_TRACE(made + ": " + (*at)[1].str());
      Trace trace;
      trace.listing = listing_of(source_text(made), (*at)[1].str());
      trace.struck = struck_of(source_text(made), (*at)[1].str());
      std::vector<SourceLine> before = shown_listing(trace);
      EXPECT_TRUE(std::ranges::any_of(before, [](const auto& l) { return l.change != Change::none; }));
      std::erase_if(before, [](const SourceLine& line) { return line.change == Change::added; });
      std::vector<std::string> taught;
      for (std::sregex_iterator in(faults.begin(), faults.end(), include); in != end && taught.empty(); ++in)
        taught = plain_texts(listing_of(file_text(root / (*in)[1].str()), (*at)[2].str()));
      EXPECT_EQ(plain_texts(before), taught);
      ++found;
    }
  }
  EXPECT_GE(found, 30u);
}

/// Of a line that this sheet shows: its sign, a number where it runs, and a line through it where it doesn't.
void expect_signed(const Sheet& sheet, const SourceLine& line) {
  const bool struck = line.change == Change::struck;
  const TextShape* sign = test::find_text(sheet, fmt::format("change {}", line.number));
  const std::string drawn = sign ? sign->text : "";
  EXPECT_EQ(drawn, struck ? "−" : line.change == Change::added ? "+" : "") << line.text;
  EXPECT_EQ(test::find_text(sheet, fmt::format("number {}", line.number)) == nullptr, struck) << line.text;
  const std::string id = fmt::format("strike {} row 1", line.number);
  EXPECT_EQ(std::ranges::count(sheet.shapes, id, &Shape::id), struck ? 1 : 0) << line.text;
}

// No step marks what is struck out, and each figure shows some of what is changed.
TEST(FaultListing, ShowsItsChangesAtEveryStep) {
  std::size_t looked = 0;
  for (const Trace& trace : test::shared_traces()) {
    if (trace.struck.empty()) continue;
    SCOPED_TRACE(trace.topic + " " + trace.method);
    Playhead playhead(trace);
    for (const StepNumber step : {trace.steps.front().number, trace.telling, trace.steps.back().number}) {
      const Figure figure = figure_of(trace, playhead, step);
      const Sheet sheet = lay_out(figure, Look{});
      std::size_t changes = 0;
      for (const auto& [line, emphasis] : figure.listing) {
        if (line.change == Change::struck) EXPECT_EQ(emphasis, Emphasis::none) << line.text;
        if (!test::find_text(sheet, fmt::format("line {}", line.number))) continue;
        expect_signed(sheet, line);
        changes += line.change != Change::none;
      }
      EXPECT_GT(changes, 0u) << text_of(step);
      ++looked;
    }
  }
  EXPECT_GT(looked, 60u);
}

TEST(FaultListing, IsToldToProgramsBesideTheLinesThatRan) {
  const Trace trace = test::trace_of("z_buffer", {{"method", "first_come"}});
  ASSERT_EQ(trace.struck.size(), 1u);
  const SourceLine& struck = trace.struck.front();
  std::vector<int> added;
  for (const SourceLine& line : trace.listing) {
    if (line.change == Change::added) added.push_back(line.number);
  }
  ASSERT_EQ(added.size(), 8u);
  EXPECT_EQ(added.front(), struck.number + 1);
  const std::string expected = fmt::format(R"("difference":{{"struck":[[{},"{}"]],"added":[{}]}})",
                                           struck.number, struck.text, fmt::join(added, ","));
  EXPECT_THAT(trace_json(trace), HasSubstr(expected));
  EXPECT_THAT(trace_json(test::trace_of("z_buffer")), Not(HasSubstr("difference")));
}

}  // namespace
}  // namespace gradus
