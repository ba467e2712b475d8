// What the stories of light draw: pictures that stand upright, with their marks where they belong.

#include <gtest/gtest.h>

#include <string>

#include "support/example_traces.hpp"

namespace gradus {
namespace {

const Mark& mark_in(const std::map<std::string, Mark>& marks, const std::string& id) {
  const auto found = marks.find(id);
  if (found == marks.end()) throw std::invalid_argument("no mark " + id);
  return found->second;
}

TEST(ShadingStory, TheLineGoesThroughTheBrightestPixelOfThePicture) {
  // The lamp stands high above one corner of the square, so nothing is bright in the others
  for (const std::string light : {"3,3,2", "-3,-2,2", "2,-3,2"}) {
    SCOPED_TRACE(light);
    const Trace trace = test::trace_of("polygon_shading", {{"method", "all_three"},
                                                           {"faces", "-5,-5,0 5,-5,0 5,5,0 -5,5,0"},
                                                           {"light", light},
                                                           {"eye", light}});
    Playhead playhead(trace);
    const auto& marks = playhead.at(trace.steps.size() - 1).marks();
    const auto& picture = std::get<Picture>(mark_in(marks, "b 2").shape);
    const auto& line = std::get<Stroke>(mark_in(marks, "m 2 row").shape);
    ivec2 brightest{0, 0};
    const Image& image = *picture.image;
    for (ivec2 p{0, 0}; p.y < image.height(); ++p.y) {
      for (p.x = 0; p.x < image.width(); ++p.x)
        if (image[p].g > image[brightest].g) brightest = p;
    }
    const dvec2 size = picture.upper - picture.lower;
    const double pixel = size.y / image.height();
    // Tones of a highlight are even over some pixels: the first of them is not the very brightest
    EXPECT_NEAR(picture.upper.y - (brightest.y + 0.5) * pixel, line.a.y, 12 * pixel);
    // Below the lamp; 10 units and a margin make up the picture
    const double x = std::stod(light), y = std::stod(light.substr(light.find(',') + 1));
    EXPECT_NEAR((brightest.x + 0.5) / image.width(), 0.5 + x / 10.43, 0.05);
    EXPECT_NEAR(1 - (brightest.y + 0.5) / image.height(), 0.5 + y / 10.43, 0.05);
  }
}

TEST(ShadingStory, ASpotPointsToItsAim) {
  // All lies in the plane of y and z, and the lamp at y = 3 is drawn at the left
  for (const double aim : {9.0, 4.0, 2.0, 1.0, -4.0}) {
    SCOPED_TRACE(aim);
    const Trace trace = test::trace_of(
        "illumination", {{"lights", "0,3,4"}, {"kind", "spot"}, {"aim", "0," + std::to_string(aim) + ",0"}});
    Playhead playhead(trace);
    const auto& marks = playhead.at(trace.steps.size() - 2).marks();  // the lamp's
    const auto& axis = std::get<Stroke>(mark_in(marks, "c axis").shape);
    const dvec2 drawn = glm::normalize(axis.b - axis.a), meant = glm::normalize(dvec2{3 - aim, -4});
    EXPECT_NEAR(drawn.x, meant.x, 1e-9);
    EXPECT_NEAR(drawn.y, meant.y, 1e-9);
  }
}

}  // namespace
}  // namespace gradus
