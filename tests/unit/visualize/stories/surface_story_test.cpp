// What the stories of surfaces show: pictures that the light tells, and numbers said as they are drawn.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "stories/rendered_surface.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

using testing::HasSubstr;

/// The texts of a drawing's weights: beside a star's vertices, and in its middle.
std::vector<std::string> weights_in(const std::map<std::string, Mark>& marks) {
  std::vector<std::string> texts;
  for (const auto& [id, mark] : marks) {
    if (!id.starts_with("x ")) continue;
    if (const Text* text = std::get_if<Text>(&mark.shape)) texts.push_back(text->text);
    if (const Label* label = std::get_if<Label>(&mark.shape)) texts.push_back(label->text);
  }
  return texts;
}

TEST(SurfaceStory, WeightsAreSaidAsTheyAreDrawn) {
  using Inputs = std::map<std::string, std::string>;
  for (const Inputs& given :
       {Inputs{}, Inputs{{"shape", "cube"}, {"vertex", "8"}}, Inputs{{"shape", "pencil"}, {"vertex", "1"}},
        Inputs{{"shape", "cube"}, {"vertex", "7"}, {"creases", "5,6,2 6,8,2 8,7,2 7,5,2"}},
        Inputs{{"method", "limit"}}}) {
    const Trace trace = test::trace_of("subdivision_surface", given);
    Playhead playhead(trace);
    const std::size_t at = index_of(trace, trace.telling);
    const std::vector<std::string> drawn = weights_in(playhead.at(at).marks());
    const std::string& said = trace.steps[at].sentence;
    ASSERT_FALSE(drawn.empty());
    const auto is_fraction = [](const std::string& text) { return text.find('/') != text.npos; };
    EXPECT_EQ(std::ranges::count_if(drawn, is_fraction) % std::ssize(drawn), 0)
        << testing::PrintToString(drawn) << ": some are fractions, some are not";
    EXPECT_THAT(said, HasSubstr(drawn.back() + " of ")) << "the vertex's own";
    if (said.find("each neighbour") == said.npos) continue;
    for (const std::string& weight : drawn) EXPECT_THAT(said, HasSubstr(weight + " of "));
  }
}

TEST(SurfaceStory, EveryStepOfAJoinMarksALine) {
  for (const char* order : {"C0", "C2"}) {
    const Trace trace = test::trace_of("bezier_patch", {{"method", "join"}, {"order", order}});
    for (const TraceStep& step : trace.steps) {
      if (step.number.step > 0) EXPECT_NE(step.line, 0) << order << ", step " << text_of(step.number);
    }
  }
}

TEST(SurfaceStory, FewerOrdersHaveLargerPictures) {
  std::vector<double> widths;
  for (const char* order : {"C0", "G1", "C2"}) {
    const Trace trace = test::trace_of("bezier_patch", {{"method", "join"}, {"order", order}});
    Playhead playhead(trace);
    for (const auto& [id, mark] : playhead.at(trace.steps.size() - 1).marks()) {
      const Picture* picture = std::get_if<Picture>(&mark.shape);
      if (picture && id.ends_with("a 1")) widths.push_back(picture->upper.x - picture->lower.x);
    }
  }
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_GT(widths[0], 1.5 * widths[2]);
  EXPECT_GE(widths[1], widths[2]);
}

TEST(SurfaceStory, ATransposedPatchShowsByHowMuchItMisses) {
  const Trace trace = test::trace_of("bezier_patch", {{"method", "transposed"}});
  Playhead playhead(trace);
  const std::size_t at = index_of(trace, trace.telling);
  EXPECT_TRUE(playhead.at(at).marks().contains("x missed"));
  EXPECT_THAT(trace.steps[at].sentence, HasSubstr("away"));
}

// --- Pictures ----------------------------------------------------------------------------------------------

/// A square that faces its reader, in 4 x 4 faces; it fills the picture.
struct Square {
  std::vector<dvec3> points;
  Faces faces;
  SurfaceLook look{
      .right = {1, 0, 0}, .up = {0, 1, 0}, .towards = {0, 0, 1}, .shown = {{0, 0}, {4, 4}}, .width = 40};

  Square() {
    for (int y = 0; y <= 4; ++y) {
      for (int x = 0; x <= 4; ++x) points.emplace_back(x, y, 0);
    }
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        const int at = 5 * y + x;
        faces.add(std::array{at, at + 1, at + 6, at + 5});
      }
    }
  }
  /// Where the plane has this place.
  Rgba8 at(double x, double y) const {
    const auto image = rendered_surface(points, faces, look);
    return (*image)[{static_cast<int>(10 * x), static_cast<int>(10 * (4 - y))}];
  }
};

TEST(SolidStory, ARayTooShortForItsSectionIsRefused) {
  for (const char* method : {"along_ray", "exchanged", "cracked", "edit"}) {
    std::string said;
    try {
      test::trace_of("csg_tree",
                     {{"method", method}, {"ray", "-0.0869,-0.0869 -0.08689999999999999,-0.0869"}});
    } catch (const ArgumentError& refusal) {
      said = refusal.parameter + ": " + refusal.what();
    }
    EXPECT_THAT(said,
                testing::StartsWith("ray: expected two points that lie apart in a drawing as large as "))
        << method;
  }
}

TEST(RenderedSurface, FacesThatStandOutAreLighter) {
  Square square;
  const std::array<std::int32_t, 1> marked{5};
  square.look.marked = marked;
  EXPECT_GT(square.at(1.5, 1.5).r, square.at(2.5, 1.5).r + 30);
  EXPECT_EQ(square.at(0.5, 0.5), square.at(2.5, 1.5));
}

TEST(RenderedSurface, AGridHasLinesEverySoManyFaces) {
  Square square;
  const Rgba8 face = square.at(1.5, 1.5);
  EXPECT_EQ(square.at(1.95, 1.5), face);
  square.look.columns = 4;
  square.look.every = 2;
  EXPECT_LT(square.at(1.95, 1.5).r, face.r) << "between the second and the third column";
  EXPECT_LT(square.at(0.5, 1.95).r, face.r) << "between the second and the third row";
  EXPECT_EQ(square.at(0.95, 1.5), face) << "between the first and the second column";
  EXPECT_EQ(square.at(0.5, 0.95), face);
}

TEST(RenderedSurface, EverySampleOfASquareIsCovered) {
  // Turned faces: their sides cross rows of samples at all angles
  Square square;
  for (dvec3& p : square.points) {
    const double bend = 0.3 * (p.x * (4 - p.x) * p.y * (4 - p.y)) / 16;
    p += dvec3{bend, -bend, 0};
  }
  const auto image = rendered_surface(square.points, square.faces, square.look);
  for (ivec2 p{0, 0}; p.y < image->height(); ++p.y) {
    for (p.x = 0; p.x < image->width(); ++p.x) ASSERT_EQ((*image)[p].a, 255) << p.x << ", " << p.y;
  }
}

}  // namespace
}  // namespace gradus
