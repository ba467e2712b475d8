// The errata gallery: every wrong form that can be run is, beside the right one, and is told apart from it.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "cli/errata.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "stories/topic.hpp"

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
            exhibits(), [&](const Exhibit& e) { return shows(e, erratum) && e.wrong_name == method.name; }))
            << erratum.id << " " << method.name;
      }
    }
  }
}

TEST(ErrataGallery, EveryExhibitBelongsToAnEntryAndDiffers) {
  const std::vector<Erratum> errata = wrong_and_fragile();
  EXPECT_GE(exhibits().size(), 20u);
  for (const Exhibit& exhibit : exhibits()) {
    SCOPED_TRACE(exhibit.id + " " + exhibit.wrong_name);
    EXPECT_EQ(std::ranges::count_if(errata, [&](const Erratum& e) { return shows(exhibit, e); }), 1);
    EXPECT_NE(exhibit.wrong_picture, exhibit.right_picture);
    // What is fragile may take the very steps of what is right, at another cost
    if (exhibit.parting == "Every step is the same.") EXPECT_FALSE(exhibit.outcome.empty());
    EXPECT_THAT(exhibit.difference, Not(HasSubstr("differ in 0.")));
    EXPECT_THAT(exhibit.wrong_command, HasSubstr("--method " + exhibit.wrong_name));
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
  EXPECT_EQ(exhibit->parting, "Every step is the same.");
  EXPECT_EQ(exhibit->outcome, "The same result, but peak_calls = 64.") << "a call a cell of 8 x 8";
  EXPECT_EQ(exhibit->difference, "Pixels: 64, of which 0 wrong; 0 of the right ones missing.");
}

TEST(ErrataGallery, ARefusalIsTheRightOnesOutcome) {
  const auto exhibit = std::ranges::find(exhibits(), "E001-08", &Exhibit::id);
  ASSERT_NE(exhibit, exhibits().end());
  EXPECT_THAT(exhibit->refusal, testing::StartsWith("--at: expected a pixel inside the 8 × 4 picture"));
  EXPECT_EQ(exhibit->right_picture, "");
  EXPECT_NE(exhibit->wrong_picture, "");
  EXPECT_EQ(exhibit->difference, "Pixels: 11, all of them wrong.");
  const std::string page = errata_page(wrong_and_fragile(), exhibits());
  EXPECT_THAT(page, HasSubstr("<p class=\"refusal\">refused: --at: expected a pixel inside"));
  EXPECT_THAT(page, Not(HasSubstr("base64,\""))) << "no picture without one";
  // Nothing else is refused
  EXPECT_EQ(std::ranges::count_if(exhibits(), [](const Exhibit& e) { return !e.refusal.empty(); }), 1);
}

TEST(ErrataGallery, ThePageHasEveryEntryWithItsTest) {
  const std::vector<Erratum> errata = wrong_and_fragile();
  const std::string page = errata_page(errata, exhibits());
  for (const Erratum& erratum : errata) {
    if (erratum.id != "part 4") EXPECT_THAT(page, HasSubstr("<h3>" + erratum.id));
    const std::string test = erratum.test.substr(1, erratum.test.find('`', 1) - 1);
    EXPECT_THAT(page, HasSubstr("<code>" + test + "</code>"));
  }
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  // Every picture is inside the page
  EXPECT_THAT(page, Not(testing::ContainsRegex("src=\"[^d]")));
}

TEST(ErrataGallery, NamesInCellsStayText) {
  const std::vector<Erratum> one{{"E<1>", "W", "<script>", "a `b`", "c", "", "`T.t`", "S"}};
  const std::string page = errata_page(one, {});
  EXPECT_THAT(page, HasSubstr("E&lt;1&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<p><b>The notes:</b> <script>")));
  EXPECT_THAT(page, HasSubstr("a <code>b</code>"));
}

}  // namespace
}  // namespace gradus
