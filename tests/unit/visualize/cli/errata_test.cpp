// The errata gallery: every wrong form that can be run is, beside the right one, and is told apart from it.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <set>
#include <span>

#include "cli/commands/errata.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "stories/topic.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<Exhibit>& exhibits() {
  static const std::vector<Exhibit> all = cli::run_exhibits();
  return all;
}

TEST(ErrataGallery, EveryWrongFormWithAMethodIsShown) {
  const std::vector<Erratum> errata = wrong_and_fragile();
  EXPECT_GE(errata.size(), 40u);
  for (const TopicEntry* topic : catalogue()) {
    for (const Method& method : topic->methods) {
      if (method.standing != Standing::faulty) continue;
      for (const Erratum& erratum : errata) {
        if (erratum.exhibit.find("`--method " + method.name + "`") == std::string::npos) continue;
        EXPECT_TRUE(std::ranges::any_of(
            exhibits(), [&](const Exhibit& e) { return shows(e, erratum) && e.wrong.name == method.name; }))
            << erratum.id << " " << method.name;
      }
    }
  }
}

const std::vector<Reading>& readings() {
  static const std::vector<Reading> all = cli::run_readings();
  return all;
}

TEST(ErrataGallery, WhatIsNotShownHasItsReason) {
  // Entries of the notes, not those of numbers too large or too small: run, read, or not yet in a story
  for (const Erratum& erratum : wrong_and_fragile()) {
    if (erratum.id == "part 4") continue;
    const auto shown = [&](const auto& one) { return shows(one, erratum); };
    if (std::ranges::any_of(exhibits(), shown) || std::ranges::any_of(readings(), shown)) continue;
    const bool elsewhere = erratum.exhibit.starts_with("under ");
    const bool not_yet = erratum.exhibit.starts_with("with the chapter on ");
    EXPECT_TRUE(elsewhere || not_yet || erratum.exhibit == "docs page of the topic")
        << erratum.id << ": " << erratum.exhibit;
  }
}

TEST(ErrataGallery, EveryExhibitBelongsToAnEntryAndDiffers) {
  const std::vector<Erratum> errata = wrong_and_fragile();
  EXPECT_GE(exhibits().size(), 20u);
  for (const Exhibit& exhibit : exhibits()) {
    SCOPED_TRACE(exhibit.id + " " + exhibit.wrong.name);
    EXPECT_EQ(std::ranges::count_if(errata, [&](const Erratum& e) { return shows(exhibit, e); }), 1);
    // What is fragile may take the very steps of what is right, at another cost
    if (exhibit.wrong.picture == exhibit.right.picture) EXPECT_FALSE(exhibit.outcome.empty());
    EXPECT_THAT(exhibit.difference, Not(HasSubstr("differ in 0 ")));
    EXPECT_THAT(exhibit.wrong.command, HasSubstr("--method " + exhibit.wrong.name));
  }
}

TEST(ErrataGallery, PixelsAreCountedAsSets) {
  // The circle of radius 5, by the notes' listing and by the right one
  std::set<std::pair<int, int>> wrong, right;
  bresenham_circle::late_update({0, 0}, 5, [&](ivec2 p) { wrong.emplace(p.x, p.y); });
  bresenham_circle::decision_parameter({0, 0}, 5, [&](ivec2 p) { right.emplace(p.x, p.y); });
  const auto without = [](const auto& a, const auto& b) {
    return std::ranges::count_if(a, [&](const auto& p) { return !b.contains(p); });
  };
  const auto exhibit = std::ranges::find(exhibits(), "E001-05", &Exhibit::id);
  ASSERT_NE(exhibit, exhibits().end());
  EXPECT_THAT(exhibit->difference,
              HasSubstr(fmt::format("Pixels: {}, of which {} wrong; {} of the right ones missing",
                                    wrong.size(), without(wrong, right), without(right, wrong))));
  EXPECT_GT(without(wrong, right), 0);
}

TEST(ErrataGallery, TheSameStepsAtTheCostOfOpenCalls) {
  const auto exhibit = std::ranges::find(exhibits(), "E001-07", &Exhibit::id);
  ASSERT_NE(exhibit, exhibits().end());
  EXPECT_EQ(exhibit->parting, "Every step tells the same; the results are shown.");
  EXPECT_EQ(exhibit->outcome, "The same result, but peak calls = 64.") << "a call per cell of 8 x 8";
  EXPECT_EQ(exhibit->difference, "Pixels: 64, of which 0 wrong; 0 of the right ones missing.");
}

TEST(ErrataGallery, ARefusalIsTheRightOnesOutcome) {
  const auto exhibit = std::ranges::find(exhibits(), "E001-08", &Exhibit::id);
  ASSERT_NE(exhibit, exhibits().end());
  EXPECT_THAT(exhibit->refusal, testing::StartsWith("--at: expected a pixel inside the 8 × 4 picture"));
  EXPECT_EQ(exhibit->right.picture, "");
  EXPECT_NE(exhibit->wrong.picture, "");
  EXPECT_EQ(exhibit->difference, "Pixels: 11, all of them wrong.");
  const std::string page = errata_page(wrong_and_fragile(), exhibits());
  EXPECT_THAT(page, HasSubstr("<p class=\"refusal\">refused: --at: expected a pixel inside"));
  EXPECT_THAT(page, Not(HasSubstr("base64,\""))) << "no picture without one";
  // Nothing else is refused
  EXPECT_EQ(std::ranges::count_if(exhibits(), [](const Exhibit& e) { return !e.refusal.empty(); }), 1);
}

/// The exhibits of an erratum.
std::vector<Exhibit> exhibits_of(std::string_view id) {
  std::vector<Exhibit> found;
  std::ranges::copy_if(exhibits(), std::back_inserter(found), [&](const Exhibit& e) { return e.id == id; });
  return found;
}

std::string culprit_of(const Exhibit& exhibit) {
  const auto line = std::ranges::find(exhibit.source, true, &ExhibitLine::culprit);
  return line == exhibit.source.end() ? "" : line->text;
}

/// Exhibits whose marked line may stand in the right form, too: something is missing round it, or the fault
/// is the order of lines, a type or a rule that the line is given.
const std::set<std::string> alike_in_both{"divide_untested", "entering_not_cut",     "half_even",
                                          "late_update",     "previous_left_behind", "without_empty_test"};

// A line that stands in the right form as well can't be the fault.
TEST(ErrataGallery, EveryCulpritIsALineThatTheRightFormLacks) {
  for (const Exhibit& exhibit : exhibits()) {
    SCOPED_TRACE(exhibit.id + " " + exhibit.wrong.name);
    ASSERT_EQ(std::ranges::count(exhibit.source, true, &ExhibitLine::culprit), 1);
    if (alike_in_both.contains(exhibit.wrong.name)) continue;
    const TopicEntry* topic = nullptr;
    for (const TopicEntry* entry : catalogue()) {
      if (exhibit.wrong.command.find(" " + entry->name + " ") != std::string::npos) topic = entry;
    }
    ASSERT_NE(topic, nullptr);
    if (!exhibit.refusal.empty()) continue;  // the right form doesn't run
    const Trace right = test::trace_of(topic->name, {{"method", exhibit.right.name}});
    for (const SourceLine& line : right.listing) EXPECT_NE(line.text, culprit_of(exhibit));
  }
}

TEST(ErrataGallery, AFaultIsMarkedWhereItIsAndNotWhereItIsSeen) {
  EXPECT_THAT(culprit_of(exhibits_of("E001-01").at(0)), HasSubstr("p += 2 * dy - dx"));
  EXPECT_THAT(culprit_of(exhibits_of("E001-02").at(0)), HasSubstr("p += 2 * dy - 3 * dx"));
  EXPECT_THAT(culprit_of(exhibits_of("E001-05").at(0)), HasSubstr("p += 4 * x + 6"));
  EXPECT_THAT(culprit_of(exhibits_of("E001-13").at(0)), HasSubstr("g.shift + g.pivot"));
  EXPECT_THAT(culprit_of(exhibits_of("E001-56").at(0)), HasSubstr("sum / double(asked)"));
}

TEST(ErrataGallery, EightPlotsAPlaceAreShownByWhatTheySetAgain) {
  const auto found = exhibits_of("E001-06");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_THAT(found[0].wrong.sentence, HasSubstr("64 plots for 56 pixels: 8 of them are repeats."));
  EXPECT_EQ(found[0].outcome, "The same result, but plots = 64, plotted again = 8.");
  EXPECT_EQ(found[0].difference, "Pixels: 56, of which 0 wrong; 0 of the right ones missing.");
  EXPECT_NE(found[0].wrong.picture, found[0].right.picture);
  EXPECT_THAT(culprit_of(found[0]), HasSubstr("plot_eight"));
  // Radius 5 goes past the diagonal: four pixels on axes, the eight of its last place
  EXPECT_THAT(found[1].wrong.sentence, HasSubstr("40 plots for 28 pixels: 12 of them are repeats."));
}

TEST(ErrataGallery, StagesOfTheChainPartWhereOneIsExchanged) {
  const auto culled = exhibits_of("E001-40");
  ASSERT_EQ(culled.size(), 2u);  // the other one is that of the topic
  EXPECT_EQ(culled[0].parting, "The runs part at step 4.");
  EXPECT_THAT(culprit_of(culled[0]), HasSubstr("divided_area"));
  EXPECT_THAT(culled[0].outcome, HasSubstr("seen = nothing for 11")) << "a hole";
  const auto closed = exhibits_of("E001-42");
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].parting, "The runs part at step 6.");
  EXPECT_THAT(culprit_of(closed[0]), HasSubstr("none_negative"));
  EXPECT_EQ(closed[0].wrong.sentence,
            "The test gives 36 of the pixel centres to the triangle; all 2 triangles together make 72 "
            "fragments, 8 too many: an edge counts for both of its sides.");
  EXPECT_EQ(closed[0].right.sentence,
            "The triangle covers 28 pixel centres; all 2 triangles together make 64 fragments.");
  const auto expanded = exhibits_of("E001-43");
  ASSERT_EQ(expanded.size(), 1u);
  EXPECT_EQ(expanded[0].parting, "The runs part at step 6.");
  EXPECT_THAT(expanded[0].wrong.sentence, HasSubstr("huge terms nearly cancel"));
  EXPECT_NE(expanded[0].wrong.picture, expanded[0].right.picture);
}

/// What becomes of an input: of the notes' reader, and of ours.
std::pair<std::string, std::string> outcomes(std::string_view id, std::string_view input) {
  const auto reading = std::ranges::find(readings(), id, &Reading::id);
  if (reading == readings().end()) return {"no reading", ""};
  const auto row = std::ranges::find(reading->rows, input, &ReadingRow::input);
  return row == reading->rows.end() ? std::pair<std::string, std::string>{"no row", ""}
                                    : std::pair{row->wrong, row->right};
}

TEST(ErrataGallery, ReadersAreShownByWhatTheyMakeOfTexts) {
  using Both = std::pair<std::string, std::string>;
  const std::string red = "triangle 0 1 2, colour 1 0 0", face = "f 1//1 2//1 3//1\n";
  EXPECT_EQ(outcomes("E002-16", "usemtl red\n" + face), (Both{red, red}));
  EXPECT_EQ(outcomes("E002-16", "usemtl red␣\n" + face), (Both{"ends: there is no material 'red'", red}));
  EXPECT_EQ(outcomes("E002-16", "usemtl  red\n" + face), (Both{"ends: there is no material ''", red}));
  EXPECT_EQ(outcomes("E002-16", "usemtl dark blue\n" + face),
            (Both{"ends: there is no material 'dark'", "triangle 0 1 2, colour 0 0 0.5"}));
  EXPECT_EQ(outcomes("E002-17", face),
            (Both{"ends: there is no material ''", "triangle 0 1 2, colour 0.7 0.7 0.7"}));
  EXPECT_EQ(outcomes("E002-18", face), (Both{red, red}));
  EXPECT_EQ(outcomes("E002-18", "f 1 2 3\n"), (Both{"ends: a corner has no third field", red}));
  EXPECT_EQ(outcomes("E002-18", "f 1/1 2/1 3/1\n"), (Both{"ends: a corner has no third field", red}));
  EXPECT_EQ(outcomes("E002-18", "f -5//1 -4//1 -3//1\n"), (Both{"triangle -6 -5 -4, colour 1 0 0", red}));
  EXPECT_EQ(outcomes("E002-18", "f 1//1 2//1 3//1 4//1 5//1\n"),
            (Both{"nothing", "face 0 1 2 3 4, colour 1 0 0"}));
  EXPECT_EQ(outcomes("E000-06", "1 2 3\n4 5 6\n7 8 9"), (Both{"seen at (-3, 0, 6), (-4, 1, 7), (-5, 2, 8)",
                                                              "seen at (-1, 0, 2), (-4, 3, 5), (-7, 6, 8)"}));
  EXPECT_EQ(outcomes("E000-06", "1 2 3\n4 5 6"),
            (Both{"seen at (-1, 0, 2), (-4, 3, 5)", "seen at (-1, 0, 2), (-4, 3, 5)"}));
  EXPECT_THAT(outcomes("E000-06", "1 4\n2 5\n3 6").second, testing::StartsWith("refused: point 1: expected"));
}

TEST(ErrataGallery, EveryReadingBelongsToAnEntryAndDiffersSomewhere) {
  const std::vector<Erratum> errata = wrong_and_fragile();
  EXPECT_EQ(readings().size(), 4u);
  const std::string page = errata_page(errata, exhibits(), readings());
  for (const Reading& reading : readings()) {
    SCOPED_TRACE(reading.id);
    EXPECT_EQ(std::ranges::count_if(errata, [&](const Erratum& e) { return shows(reading, e); }), 1);
    EXPECT_TRUE(std::ranges::any_of(reading.rows, [](const ReadingRow& r) { return r.wrong != r.right; }));
    EXPECT_THAT(page, HasSubstr("<caption class=\"unseen\">" + reading.id + ": " + reading.title));
  }
  // Only what comes out otherwise counts as wrong
  EXPECT_THAT(page, HasSubstr("<td class=\"right\" data-head=\"the notes&#39; reader\">triangle 0 1 2"));
  EXPECT_THAT(page, HasSubstr("<td class=\"wrong\" data-head=\"the notes&#39; reader\">ends: there is no"));
}

TEST(ErrataGallery, TextsInReadingsStayText) {
  const std::vector<Erratum> one{{"E1", "W", "a", "b", "c", "reader `f`", "`T.t`", "S"}};
  const Reading hostile{"E1", "f", "<title>", "<before>", "<wrong>", "<right>", {{"<in>", "<x>", "<y>"}}};
  const std::string page = errata_page(one, {}, std::span(&hostile, 1));
  for (const char* text : {"before", "wrong", "right", "in", "x", "y"}) {
    EXPECT_THAT(page, HasSubstr(fmt::format("&lt;{}&gt;", text)));
    EXPECT_THAT(page, Not(HasSubstr(fmt::format("<{}>", text))));
  }
}

TEST(ErrataGallery, TheLineToBlameIsMarked) {
  const auto exhibit = std::ranges::find(exhibits(), "E001-05", &Exhibit::id);
  ASSERT_NE(exhibit, exhibits().end());
  const auto culprit = std::ranges::find(exhibit->source, true, &ExhibitLine::culprit);
  ASSERT_NE(culprit, exhibit->source.end());
  EXPECT_THAT(culprit->text, HasSubstr("p += 4 * x + 6")) << "with x and y that have moved";
  EXPECT_THAT(exhibit->parting, HasSubstr("part at step"));
  EXPECT_NE(exhibit->wrong.sentence, exhibit->right.sentence);
}

TEST(ErrataGallery, ThePageHasEveryEntryAndNoNameOfATest) {
  const std::vector<Erratum> errata = wrong_and_fragile();
  const std::string page = errata_page(errata, exhibits());
  for (const Erratum& erratum : errata) {
    if (erratum.id != "part 4") EXPECT_THAT(page, HasSubstr("<h3>" + erratum.id));
    const std::string test = erratum.test.substr(1, erratum.test.find('`', 1) - 1);
    EXPECT_THAT(page, Not(HasSubstr(test))) << "that is for whoever reads docs/errata.md";
  }
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  // Every picture is inside the page
  EXPECT_THAT(page, Not(testing::ContainsRegex("src=\"[^d]")));
}

TEST(ErrataGallery, NamesInCellsStayText) {
  const std::vector<Erratum> one{{"E<1>", "W", "<script>", "a `b`", "c", "", "`T.t`", "S"}};
  const std::string page = errata_page(one, {});
  EXPECT_THAT(page, HasSubstr("E&lt;1&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<p class=\"claim\"><script>")));
  EXPECT_THAT(page, HasSubstr("a <code>b</code>"));
}

}  // namespace
}  // namespace gradus
