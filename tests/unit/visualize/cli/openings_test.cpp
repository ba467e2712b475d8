// What runs of faulty methods start with where nothing is given: an input that shows what is wrong.

#include <gtest/gtest.h>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/compare.hpp"
#include "request/names.hpp"
#include "request/openings.hpp"
#include "support/example_traces.hpp"
#include "text/text_output.hpp"

namespace gradus {
namespace {

GivenTexts opened_by(std::string_view topic, GivenTexts given) {
  return opened(test::topic(topic), std::move(given));
}

TEST(Openings, AFaultyMethodOpensWhereItFails) {
  const GivenTexts opening = opened_by("liang_barsky_circle", {{"method", "without_empty_test"}});
  EXPECT_EQ(opening.at("line"), "2,0,3,0");
  EXPECT_EQ(opening.at("circle"), "0,0,1");
}

TEST(Openings, AMethodOpensWhereItsIdeaIsSeen) {
  EXPECT_EQ(opened_by("mesh_structures", {{"method", "winged_edge"}}).at("query"), "edge");
  const GivenTexts given{{"method", "winged_edge"}, {"mesh", "cube"}};
  EXPECT_EQ(opened_by("mesh_structures", given), given);
}

TEST(Openings, EveryOpeningIsAnInputThatItsMethodReads) {
  for (const TopicEntry* topic : catalogue()) {
    for (const Method& method : topic->methods) {
      if (method.opening.empty()) continue;
      const GivenTexts opening = opened(*topic, {{"method", method.name}});
      EXPECT_FALSE(topic->run(cli::read_inputs(*topic, opening).arguments, {}).steps.empty()) << method.name;
      for (const auto& [name, text] : method.opening)
        EXPECT_EQ(std::ranges::count(method.unread, name), 0) << method.name << " " << name;
    }
  }
}

TEST(Openings, OthersOpenWithTheDefaults) {
  const GivenTexts right{{"method", "exact_decision"}};
  EXPECT_EQ(opened_by("liang_barsky_circle", right), right);
  EXPECT_EQ(opened_by("liang_barsky_circle", {}), GivenTexts{});
}

TEST(Openings, AnInputThatIsGivenStays) {
  const GivenTexts given{{"method", "without_empty_test"}, {"circle", "0,0,2"}};
  EXPECT_EQ(opened_by("liang_barsky_circle", given), given);
}

TEST(Openings, AMethodThatThereIsNotIsRefused) {
  EXPECT_THROW(opened_by("liang_barsky_circle", {{"method", "nothing"}}), UsageError);
}

TEST(Openings, BothSidesOfAComparisonOpenAlike) {
  for (const std::string line : {"--method half_chord --compare without_empty_test",
                                 "--method without_empty_test --compare half_chord"}) {
    const cli::Request request = cli::read_request(*shell_words("figure liang_barsky_circle " + line));
    const Arguments arguments = cli::read_inputs(*request.topic, cli::opened(request)).arguments;
    const OtherSide other = cli::other_side(*request.topic, arguments, request.flags.at("compare"));
    EXPECT_EQ(arguments.text("line"), "2,0,3,0") << line;
    EXPECT_EQ(other.arguments.text("line"), "2,0,3,0") << line;
    EXPECT_EQ(other.arguments.text("circle"), arguments.text("circle")) << line;
  }
}

/// What a run comes to: "wrong 0 shown 56".
std::string outcome(const TopicEntry& topic, GivenTexts given, const std::string& method) {
  given["method"] = method;
  std::string text;
  for (const Field& field : topic.run(cli::read_inputs(topic, given).arguments, {}).result)
    text += field.name + " " + value_text(field.value) + " ";
  return text;
}

TEST(Openings, ShowWhatTheDefaultsDoNot) {
  const auto shown_by_opening = [](const char* name, const char* wrong, const char* right) {
    const TopicEntry& topic = test::topic(name);
    const GivenTexts opening = opened(topic, {{"method", wrong}});
    EXPECT_EQ(outcome(topic, {}, wrong), outcome(topic, {}, right)) << wrong;
    EXPECT_NE(outcome(topic, opening, wrong), outcome(topic, opening, right)) << wrong;
  };
  shown_by_opening("z_buffer", "first_come", "per_polygon");
  shown_by_opening("back_face_culling", "eye_space_normal", "normal_and_view");
  shown_by_opening("liang_barsky_circle", "without_empty_test", "half_chord");
  shown_by_opening("mesh_structures", "first_fan_only", "half_edge");
}

}  // namespace
}  // namespace gradus
