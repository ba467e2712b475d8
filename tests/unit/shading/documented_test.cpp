// The numbers that the pages of shading claim, counted again.

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/documented.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

/// Vertices as they are written, and triangles of their numbers from 1.
struct Model {
  std::vector<std::array<std::string, 3>> vertices{};
  std::vector<std::array<std::size_t, 3>> triangles{};

  std::string text() const {
    std::string text;
    for (const auto& triangle : triangles) {
      if (!text.empty()) text += "; ";
      for (const std::size_t v : triangle) text += fmt::format("{} ", fmt::join(vertices[v - 1], ","));
    }
    return text;
  }
  double looking_up() const {
    return static_cast<double>(std::ranges::count_if(triangles, [&](const auto& triangle) {
      std::array<std::array<double, 2>, 3> p{};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 2; ++k) p[i][k] = std::stod(vertices[triangle[i] - 1][k]);
      }
      return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) > (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    }));
  }
};

Model read_model(const std::string& path) {
  Model model;
  std::ifstream in(path);
  for (std::string line, kind; std::getline(in, line);) {
    std::istringstream words(line);
    words >> kind;
    if (kind == "v") {
      auto& [x, y, z] = model.vertices.emplace_back();
      words >> x >> y >> z;
    } else if (kind == "f") {
      auto& [a, b, c] = model.triangles.emplace_back();
      words >> a >> b >> c;
    }
  }
  return model;
}

TEST(DocumentedShading, LightsOfTheBallInTheGallery) {
  std::ifstream in(GRADUS_SOURCE_DIR "/examples/gallery.json");
  const auto gallery = nlohmann::json::parse(in);
  nlohmann::json ball;
  for (const auto& figure : gallery.at("figures")) {
    if (figure.at("name") == "polygon_shading_ball") ball = figure.at("input");
  }
  // Faces that look up and vertices as the model's text has them; what is lit, as the program counts while it
  // draws
  const Model model = read_model(GRADUS_SOURCE_DIR "/examples/" + ball.at("faces").get<std::string>());
  std::map<std::string, std::string> given{{"method", "all_three"}};
  for (const auto& [flag, value] : ball.items())
    given[flag] = value.is_string() ? value.get<std::string>() : value.dump();
  given["faces"] = model.text();
  const Trace trace = test::trace_of("polygon_shading", given);
  const auto lights = std::ranges::find(trace.result, "lights_phong", &Field::name);
  ASSERT_NE(lights, trace.result.end());
  const double pixels = static_cast<double>(std::get<std::int64_t>(lights->value));
  EXPECT_TRUE(test::states(
      "docs/topics/shading/polygon_shading.md",
      "once per face, once per vertex, or once per pixel: {}, {} and {} times for the ball of the gallery.",
      {model.looking_up(), static_cast<double>(model.vertices.size()), pixels}));
}

}  // namespace
}  // namespace gradus
