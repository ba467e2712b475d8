// The figure of a pixel: its numbers are those of the pixel's story, and all of it can be read.

#include "plot/pixel_figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/render/why.hpp"
#include "core/contract.hpp"
#include "figure/text/metrics.hpp"
#include "pipeline.hpp"
#include "support/random_scenes.hpp"
#include "support/seed.hpp"
#include "support/sheets.hpp"
#include "why/why_text.hpp"

namespace gradus {
namespace {

using plot::PixelFigure;

PixelFigure figure_of(ivec2 pixel, std::size_t covers, std::size_t lights) {
  PixelFigure figure;
  figure.title = "spot.json: why pixel 3,2 is #ffede0";
  figure.subtitle = "seen of 2 triangles over its centre: Spot, face 143 (spot.obj:600)";
  figure.sentence =
      "Ambient (0.1, 0.1, 0.1) + diffuse (0.5, 0.4, 0.3) + highlight (0, 0, 0) = (0.6, 0.5, 0.4).";
  figure.picture = Image(40, 20, {90, 120, 80});
  figure.pixel = pixel;
  for (std::size_t i = 0; i < covers; ++i) {
    const double x = pixel.x - static_cast<double>(i), y = pixel.y;
    figure.covers.push_back({"thing, face " + std::to_string(i + 1),
                             {dvec2{x, y - 2}, {x - 3, y + 3}, {x + 30, y + 4}},
                             0.9 - 0.01 * static_cast<double>(i),
                             "0.9",
                             i + 1 == covers});
  }
  figure.depth_name = "depth, nearest first";
  figure.empty = "no triangle: the background";
  figure.light_name = "light, Phong: at the pixel";
  figure.sources.push_back({"", {{"ambient", LinearRgb{0.1f}}}});
  for (std::size_t i = 0; i < lights; ++i) {
    const float strength = 0.01f * static_cast<float>(i + 1);
    figure.sources.push_back({"light " + std::to_string(i + 1) + " (directional)",
                              {{"diffuse", LinearRgb{strength}, plot::Factor{"N·L", 0.705, 0.705}},
                               {"highlight", LinearRgb{0.001f}, plot::Factor{"R·V", -0.61, 0.724}}},
                              plot::Factor{"arrives", 1, 1}});
  }
  figure.colour = {255, 237, 224};
  figure.colour_text = "#ffeee0";
  figure.colour_notes = {"cut off at white", "all samples #ffede0"};
  return figure;
}

std::vector<std::string> words_of(const Sheet& sheet, const std::string& begins, const std::string& ends) {
  std::vector<std::string> words;
  for (const Shape& shape : sheet.shapes)
    if (shape.id.starts_with(begins) && shape.id.ends_with(ends))
      words.push_back(std::get<TextShape>(shape.what).text);
  return words;
}

TEST(PixelFigure, EverythingIsLargeEnoughAndOnTheSheetAndNoTextsOverlap) {
  for (const ivec2 pixel : {ivec2{20, 10}, {0, 0}, {39, 19}}) {
    for (const auto& [covers, lights] :
         {std::pair<std::size_t, std::size_t>{0, 0}, {1, 1}, {2, 2}, {5, 3}, {40, 40}}) {
      const Sheet sheet = plot::sheet_of(figure_of(pixel, covers, lights));
      for (const Shape& shape : sheet.shapes) {
        const Box box = extents_of(shape);
        EXPECT_TRUE(0 <= box.x && box.right() <= 1280 && 0 <= box.y && box.bottom() <= 720) << shape.id;
      }
      const auto texts = test::texts_of(sheet);
      for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_GE(texts[i]->size, 20) << texts[i]->text;
        EXPECT_FALSE(missing_glyph(texts[i]->text, texts[i]->face)) << texts[i]->text;
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_FALSE(test::overlap(texts[i]->box(), texts[j]->box()))
              << covers << " triangles, " << lights << " lights: " << texts[i]->text << " | "
              << texts[j]->text;
      }
    }
  }
}

TEST(PixelFigure, OddPicturesHaveTheirPlace) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {3000, 20}, {5, 7}}) {
    PixelFigure figure = figure_of({0, 0}, 2, 1);
    figure.picture = Image(width, height, {10, 20, 30});
    const Sheet sheet = plot::sheet_of(figure);
    for (const Shape& shape : sheet.shapes) {
      const Box box = extents_of(shape);
      EXPECT_TRUE(0 <= box.x && box.right() <= 1280 && 0 <= box.y && box.bottom() <= 720)
          << width << " x " << height << ": " << shape.id;
    }
  }
}

TEST(PixelFigure, TheNearestTrianglesHaveNamesAndTheOthersAreCounted) {
  EXPECT_EQ(words_of(plot::sheet_of(figure_of({20, 10}, 3, 1)), "cover depth ", "").size(), 3u);
  const Sheet sheet = plot::sheet_of(figure_of({20, 10}, 12, 1));
  EXPECT_EQ(words_of(sheet, "cover 0", ""), (std::vector<std::string>{"thing, face 12"})) << "the one seen";
  EXPECT_EQ(words_of(sheet, "others", ""), (std::vector<std::string>{"and 8 more"}));
}

TEST(PixelFigure, OfManyLightsTheStrongestHaveNames) {
  const Sheet sheet = plot::sheet_of(figure_of({20, 10}, 1, 40));
  EXPECT_EQ(words_of(sheet, "source ", " name"),
            (std::vector<std::string>{"light 40 (directional)", "39 other lights"}));
  const auto swatch = [&](const std::string& id) {
    for (const Shape& shape : sheet.shapes)
      if (shape.id == id) return std::get<ImageShape>(shape.what).image[{0, 0}];
    return Rgba8{};
  };
  EXPECT_EQ(swatch("colour"), (Rgba8{255, 237, 224}));
  EXPECT_EQ(words_of(sheet, "share 1", " factor"), (std::vector<std::string>{"N·L 0.705"}));
  EXPECT_EQ(words_of(sheet, "share 2", " factor"), (std::vector<std::string>{"R·V −0.61 … 0.72"}));
}

TEST(PixelFigure, TheCropShowsThePixelsRoundIt) {
  PixelFigure figure = figure_of({1, 18}, 0, 0);
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 20; ++y)
      figure.picture[{x, y}] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 0};
  for (const Shape& shape : plot::sheet_of(figure).shapes) {
    if (shape.id != "crop") continue;
    const Image& crop = std::get<ImageShape>(shape.what).image;
    EXPECT_EQ(crop.width(), 9);
    EXPECT_EQ((crop[{0, 0}]), (Rgba8{0, 11, 0})) << "as near to the corner as there are pixels";
    EXPECT_EQ((crop[{1, 7}]), (Rgba8{1, 18, 0}));
  }
}

TEST(PixelFigure, RefusesAPixelBesideThePicture) {
  EXPECT_THROW(plot::sheet_of(figure_of({40, 0}, 0, 0)), ContractViolation);
}

// --- Of a story ------------------------------------------------------------------------------------

dvec3 sum_of(const PixelFigure& figure) {
  dvec3 sum{0};
  for (const plot::LightSource& source : figure.sources)
    for (const plot::LightShare& share : source.shares) sum += dvec3(share.light);
  return sum;
}

/// The factor of a light's share, over all places where it was computed.
void expect_factor(const pipeline::PixelStory& story, std::size_t light, const plot::LightSource& source) {
  double least = INFINITY, most = -INFINITY;
  for (const pipeline::LampStory& lamp : story.layers.at(0).lamps) {
    if (lamp.added.light != light) continue;
    least = std::min(least, lamp.added.n_dot_l), most = std::max(most, lamp.added.n_dot_l);
  }
  EXPECT_EQ(source.shares[0].factor->least, least);
  EXPECT_EQ(source.shares[0].factor->most, most);
}

/// Its surfaces let light through, and are drawn so.
void let_light_through(pipeline::Scene& scene, Random& random) {
  scene.antialiasing = pipeline::Antialiasing::a_buffer;
  for (pipeline::Object& object : scene.objects) {
    Mesh mesh = *object.mesh;
    for (Material& material : mesh.materials) material.opacity = static_cast<float>(random.uniform(0.1, 0.9));
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.see_through = true;
  }
}

TEST(PixelFigure, NumbersAreThoseOfTheStory) {
  constexpr pipeline::Size size{40, 30};
  int shaded = 0, many = 0, empty = 0, mixed = 0;
  for (std::uint64_t i = 0; i < 90; ++i) {
    Random random(test::seed(), i);
    pipeline::Scene scene = test::random_screened_scene(random, 8);
    scene.shading = static_cast<pipeline::Shading>(i % 4);
    if (i % 3 == 1) scene.hidden_surfaces = pipeline::HiddenSurfaces::painter;
    scene.samples = 4;
    const bool through = i >= 60;
    if (through) let_light_through(scene, random);
    const ivec2 pixel{static_cast<int>(random.uniform_int(0, size.width - 1)),
                      static_cast<int>(random.uniform_int(0, size.height - 1))};
    SCOPED_TRACE(testing::Message() << "case " << i << ", pixel " << pixel.x << "," << pixel.y);
    const pipeline::PixelStory story = pipeline::why(scene, size, pixel);
    const PixelFigure figure =
        cli::pixel_figure("random", scene, story, pipeline::render_antialiased(scene, size));
    EXPECT_EQ((figure.picture[pixel]), story.picture);
    EXPECT_EQ(figure.colour, story.written.colour);
    ASSERT_EQ(figure.covers.size(), story.fragments.size());
    int seen = 0;
    for (std::size_t k = 0; k < figure.covers.size(); ++k) {
      const auto& fragment = story.fragments[k].tested.fragment;
      EXPECT_EQ(figure.covers[k].depth, fragment.depth);
      EXPECT_EQ(figure.covers[k].depth_text, pipeline::told_number(fragment.depth));
      EXPECT_EQ(figure.covers[k].corners[2], dvec2(story.fragments[k].snapped.corners[2].at) / 256.0);
      if (!figure.covers[k].seen) continue;
      ++seen;
      if (!through) EXPECT_EQ(fragment.id, story.layers.at(0).shaded.fragment.id);
    }
    EXPECT_EQ(seen, std::ssize(story.layers));
    const dvec3 light(story.written.light), sum = sum_of(figure);
    EXPECT_LT(glm::length(sum - light), 1e-5 * (1 + glm::length(light))) << "shares add up to the light";
    mixed += story.layers.size() > 1;
    if (!through && !story.layers.empty() && !story.layers[0].lamps.empty())
      for (std::size_t k = 0; k < scene.lights.size(); ++k) expect_factor(story, k, figure.sources[k + 1]);
    plot::sheet_of(figure);
    shaded += !story.layers.empty(), many += story.fragments.size() > 1, empty += story.fragments.empty();
  }
  EXPECT_GT(shaded, 15);
  EXPECT_GT(many, 5);
  EXPECT_GT(empty, 5);
  EXPECT_GT(mixed, 5);
}

}  // namespace
}  // namespace gradus
