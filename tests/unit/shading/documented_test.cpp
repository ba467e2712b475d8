// The numbers that the pages of shading claim, counted again.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "support/documented.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

TEST(DocumentedShading, LightsOfTheBallInTheGallery) {
  std::ifstream in(GRADUS_SOURCE_DIR "/examples/gallery.json");
  const auto gallery = nlohmann::json::parse(in);
  nlohmann::json ball;
  for (const auto& figure : gallery.at("figures")) {
    if (figure.at("name") == "polygon_shading_ball") ball = figure.at("input");
  }
  // Faces and their corners as the input has them; what is lit, as the program counts while it draws
  const std::string faces = ball.at("faces");
  const double count = 1 + static_cast<double>(std::ranges::count(faces, ';'));
  const std::regex corner("[^ ;]+");
  const std::set<std::string> corners(std::sregex_token_iterator(faces.begin(), faces.end(), corner), {});
  std::map<std::string, std::string> given{{"method", "phong"}};
  for (const auto& [flag, value] : ball.items())
    given[flag] = value.is_string() ? value.get<std::string>() : value.dump();
  const Trace trace = test::trace_of("polygon_shading", given);
  const auto lights = std::ranges::find(trace.result, "lights", &Field::name);
  ASSERT_NE(lights, trace.result.end());
  const double pixels = static_cast<double>(std::get<std::int64_t>(lights->value));
  EXPECT_TRUE(test::states(
      "docs/topics/shading/polygon_shading.md",
      "once per face, once per vertex, or once per pixel: {}, {} and {} times for the ball of the gallery.",
      {count, static_cast<double>(corners.size()), pixels}));
}

}  // namespace
}  // namespace gradus
