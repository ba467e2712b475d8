// Faces that people get wrong: two in one place, and faces of which a part has no inside.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "core/random.hpp"
#include "figure/trace.hpp"
#include "support/example_traces.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

TEST(FacesStory, FacesInOnePlaceAreTwo) {
  // They were told apart by their corners alone, and the story wrote beside its own memory
  for (const char* method : {"build", "back_to_front", "uncut"}) {
    const Trace trace = test::trace_of(
        "bsp_tree",
        {{"method", method}, {"faces", "A: 0,0,0 4,0,0 4,3,0; B: 0,0,0 4,0,0 4,3,0; C: 1,1,-2 1,1,2 2,2,0"}});
    std::string told;
    for (const TraceStep& step : trace.steps) told += step.sentence;
    EXPECT_NE(told.find("A"), std::string::npos) << method;
    EXPECT_NE(told.find("B"), std::string::npos) << method;
  }
}

TEST(FacesStory, PartsWithoutAnInsideAreLeftOut) {
  // Twice the same corner, and a dent: one of the parts is a line
  const Trace trace =
      test::trace_of("bsp_tree", {{"faces", "0,0,0 4,0,0 4,0,0 4,3,0 2,1,0 0,3,0"}, {"towards", "1,1,1"}});
  EXPECT_FALSE(trace.steps.empty());
}

/// A box of any size, turned anyhow and moved, with corners of six decimals, as model files have them.
std::string rounded_box(Random& random) {
  const auto any = [&](double most) { return random.uniform(-most, most); };
  const glm::dquat turn = glm::normalize(glm::dquat(any(1), any(1), any(1), any(1) + 0.1));
  const dvec3 middle{any(3), any(3), 6 + any(1)}, half{random.uniform(0.01, 2), random.uniform(0.01, 2), 0.5};
  std::string text;
  for (const auto& face :
       {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    if (!text.empty()) text += "; ";
    for (const int corner : face) {
      const dvec3 sign{corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
      const dvec3 p = middle + glm::mat3_cast(turn) * (sign * half);
      text += fmt::format(" {:.6f},{:.6f},{:.6f}", p.x, p.y, p.z);
    }
  }
  return text;
}

TEST(FacesStory, FacesRoundedToSixDecimalsAreFlat) {
  for (std::uint64_t round = 0; round < 30; ++round) {
    Random random(test::seed(), round);
    const std::string box = rounded_box(random);
    SCOPED_TRACE(box);
    for (const char* topic : {"painter", "bsp_tree"})
      EXPECT_NO_THROW(test::trace_of(topic, {{"faces", box}, {"towards", "1,1,3"}})) << topic;
    EXPECT_TRUE(test::trace_of("back_face_culling", {{"faces", box}, {"towards", "1,1,3"}})
                    .steps.back()
                    .sentence.find("not flat") == std::string::npos);
  }
}

TEST(FacesStory, BentFacesAreRefusedOrSaid) {
  // Cut silently, the order of a face D2 named D2a1
  const auto run = [](const char* topic) {
    return test::trace_of(topic, {{"faces", "D2: 0,0,0 4,0,0 4,3,1 0,3,0"}, {"towards", "1,1,3"}});
  };
  for (const char* topic : {"painter", "bsp_tree"}) {
    try {
      run(topic);
      ADD_FAILURE() << topic;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find("expected flat faces, found 'D2'"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_NE(run("back_face_culling").steps.back().sentence.find("D2 is not flat"), std::string::npos);
}

/// The marks of a step whose ids begin so.
std::vector<Mark> marks_of(const Trace& trace, std::size_t step, std::string_view beginning) {
  std::vector<Mark> found;
  Playhead playhead(trace);
  for (const auto& [id, mark] : playhead.at(step).marks()) {
    if (id.starts_with(beginning)) found.push_back(mark);
  }
  return found;
}

TEST(FacesStory, ThePainterMarksAllThatIsWrong) {
  // Three bars, each over the next: any order paints two of them wrongly, or one
  const Trace trace =
      test::trace_of("painter", {{"method", "farthest_vertex"},
                                 {"faces",
                                  "A: -6.2,-3.6,-1.2 6.2,-3.6,1.2 6.2,-1.6,1.2 -6.2,-1.6,-1.2; "
                                  "B: 6.2,-3.6,-1.2 0,7.1,1.2 -1.7,6.1,1.2 4.5,-4.6,-1.2; "
                                  "C: 0,7.2,-1.2 -6.2,-3.5,1.2 -4.5,-4.5,1.2 1.7,6.2,-1.2"},
                                 {"towards", "0.2,-0.4,1"}});
  std::size_t areas = 0;
  for (const Mark& mark : marks_of(trace, trace.steps.size() - 1, "q common"))
    areas += std::holds_alternative<Area>(mark.shape);
  EXPECT_EQ(areas, 2u);
}

TEST(FacesStory, ANameStandsOnWhatIsSeenOfIt) {
  // B lies behind A but for its right end
  const std::string faces = "A: 0,0,1 6,0,1 6,2,1 0,2,1; B: 1,0.5,0 9,0.5,0 9,1.5,0 1,1.5,0";
  const Trace trace = test::trace_of("bsp_tree", {{"faces", faces}, {"towards", "0,0,1"}});
  double right_of_a = 0, name = 0;
  for (const Mark& mark : marks_of(trace, 0, "")) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text && text->text == "B") name = text->at.x;
    if (!text || text->text != "A") continue;
    right_of_a = text->at.x;
  }
  EXPECT_GT(name, right_of_a + 3);
  // C is behind A altogether
  const Trace hidden = test::trace_of(
      "bsp_tree", {{"faces", faces + "; C: 1,0.5,-1 5,0.5,-1 5,1.5,-1"}, {"towards", "0,0,1"}});
  for (const Mark& mark : marks_of(hidden, 0, "n ")) EXPECT_NE(std::get<Text>(mark.shape).text, "C");
}

}  // namespace
}  // namespace gradus
