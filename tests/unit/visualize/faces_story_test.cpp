// Faces that people get wrong: two in one place, and faces of which a part has no inside.

#include <gtest/gtest.h>

#include "support/example_traces.hpp"

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

}  // namespace
}  // namespace gradus
