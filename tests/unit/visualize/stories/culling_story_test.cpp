// What culling saves, of whole models: triangles against the normals of their faces, pixels against what
// sight lines do, and against a square's area.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/models/obj.hpp"
#include "stories/checking.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

/// Of the pictures "all", "away", "drawn": what they took, and the picture.
struct Shown {
  std::int64_t triangles, pixels;
  Image image;
};

struct Told {
  std::vector<Shown> shown;
  std::string result;
};

Told told(const std::string& model, const std::string& file, const Argument& viewer) {
  const TopicEntry& topic = test::topic("back_face_culling");
  const std::vector<Argument> given{{"method", "of_a_model"}, viewer};
  const Arguments without_model = arguments_of(topic, given);
  Arguments arguments;
  for (Arguments::Entry entry : without_model.entries()) {
    if (entry.name == "model") {
      entry.text = model;
      entry.content = file;
    }
    arguments.set(std::move(entry));
  }
  const Trace trace = topic.run(arguments, {});
  Told told;
  Playhead playhead(trace);
  const auto& marks = playhead.at(trace.steps.size() - 1).marks();
  for (const TraceStep& step : trace.steps) {
    if (step.type != "PictureDrawn") continue;
    const std::string id = fmt::format("b {}", told.shown.size());
    told.shown.push_back({*value_as<std::int64_t>(step.fields, "triangles"),
                          *value_as<std::int64_t>(step.fields, "pixels"),
                          *std::get<Picture>(marks.at(id).shape).image});
  }
  told.result = trace.steps.back().sentence;
  return told;
}

Told told_of_shipped(const std::string& model, const Argument& viewer) {
  return told(model, std::string(shipped_model(model)), viewer);
}

TEST(CullingStory, TrianglesThatTurnAwayAreThoseOfFacesWhoseNormalsDo) {
  for (const std::string model : {"letter_f.obj", "icosphere.obj", "house.obj"}) {
    const auto none = [](const std::string&) { return std::optional<std::string>(); };
    const Mesh mesh = pipeline::parse_obj(shipped_model(model), model, none).mesh;
    for (const dvec3 towards : {dvec3{1, 2, 3}, dvec3{-3, 1, 2}, dvec3{5, -4, -7}}) {
      const std::string text = fmt::format("{},{},{}", towards.x, towards.y, towards.z);
      SCOPED_TRACE(model + " " + text);
      std::int64_t all = 0, drawn = 0;
      for (const MeshFace& face : mesh.faces) {
        all += face.count - 2;
        drawn += glm::dot(area_vector(mesh, face), towards) > 0 ? face.count - 2 : 0;
      }
      const Told culled = told_of_shipped(model, {"towards", text});
      EXPECT_EQ(culled.shown.at(0).triangles, all);
      EXPECT_EQ(culled.shown.at(1).triangles, all - drawn);
      EXPECT_EQ(culled.shown.at(2).triangles, drawn);
    }
  }
}

// A sight line leaves a closed body as often as it enters it: each pixel has as many backs as fronts.
TEST(CullingStory, OfAClosedModelHalfThePixelsAreSaved) {
  for (const std::string model : {"spot.obj", "icosphere.obj", "house.obj", "letter_f.obj"}) {
    for (const Argument& viewer : {Argument{"eye", "20,18,29"}, Argument{"eye", "-9,4,12"},
                                   Argument{"towards", "3,1,-2"}, Argument{"towards", "0,1,0"}}) {
      SCOPED_TRACE(model + " " + viewer.name + " " + viewer.value);
      const Told culled = told_of_shipped(model, viewer);
      const auto &all = culled.shown.at(0), &away = culled.shown.at(1), &drawn = culled.shown.at(2);
      EXPECT_GT(drawn.pixels, 10'000);
      EXPECT_EQ(away.pixels, drawn.pixels);
      EXPECT_EQ(all.pixels, away.pixels + drawn.pixels);
      EXPECT_NE(culled.result.find("50 %"), std::string::npos) << culled.result;
      EXPECT_NE(culled.result.find("the same"), std::string::npos) << culled.result;
      // The same places are covered, and as much of them
      for (ivec2 p{0, 0}; p.y < all.image.height(); ++p.y) {
        for (p.x = 0; p.x < all.image.width(); ++p.x) {
          ASSERT_EQ(all.image[p].a, drawn.image[p].a) << p.x << ", " << p.y;
          ASSERT_EQ(all.image[p].a, away.image[p].a) << p.x << ", " << p.y;
        }
      }
    }
  }
}

TEST(CullingStory, ASquareFillsItsPictureOnceAndIsGoneFromBehind) {
  const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
  constexpr std::int64_t pixels = 368 * 368;  // 48 cells of 8 pixels, less a cell at each side
  const Told front = told("square.obj", square, {"towards", "0,0,1"});
  EXPECT_EQ(front.shown.at(0).pixels, pixels);
  EXPECT_EQ(front.shown.at(1).pixels, 0);
  EXPECT_EQ(front.shown.at(2).pixels, pixels);
  const Told back = told("square.obj", square, {"towards", "0,0,-1"});
  EXPECT_EQ(back.shown.at(1).pixels, pixels);
  EXPECT_EQ(back.shown.at(2).pixels, 0);
  EXPECT_NE(back.result.find("135424 show the inside of an open model"), std::string::npos) << back.result;
}

// It has as many backs as fronts in each pixel, as any closed body, but the backs are nearer.
TEST(CullingStory, ABodyTurnedInsideOutDoesNotKeepItsPicture) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const Told outward =
      told("body.obj", corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", {"towards", "1,2,3"});
  EXPECT_NE(outward.result.find("the same"), std::string::npos) << outward.result;
  const Told inward =
      told("body.obj", corners + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n", {"towards", "1,2,3"});
  EXPECT_NE(inward.result.find("show the inside"), std::string::npos) << inward.result;
}

}  // namespace
}  // namespace gradus
