// The heat map: its legend names the colours that it has, and all of it can be read.

#include "plot/heat_map.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "figure/sheet.hpp"

namespace gradus {
namespace {

plot::HeatMap map_of(const std::vector<int>& amounts) {
  const int width = static_cast<int>(amounts.size());
  plot::HeatMap map{"town.json: what rendering it leaves out",
                    "fragments and lamps",
                    Image(width, 1, {90, 90, 90}),
                    Raster<int>(width, 1),
                    "left out",
                    "1134 of 1391 objects are left out."};
  for (int x = 0; x < width; ++x) map.amounts[{x, 0}] = amounts[static_cast<std::size_t>(x)];
  return map;
}

const ImageShape& picture_of(const Sheet& sheet) {
  for (const Shape& shape : sheet.shapes)
    if (shape.id == "heat map") return std::get<ImageShape>(shape.what);
  throw ContractViolation("no picture");
}

/// What the legend says of each class, by its number.
std::map<std::string, std::string> legend_of(const Sheet& sheet) {
  std::map<std::string, std::string> legend;
  for (const Shape& shape : sheet.shapes)
    if (shape.id.starts_with("class ")) legend[shape.id.substr(6)] = std::get<TextShape>(shape.what).text;
  return legend;
}

TEST(HeatMap, NamesItsClasses) {
  using Legend = std::map<std::string, std::string>;
  EXPECT_EQ(legend_of(plot::sheet_of(map_of({0, 1, 2, 3, 9}))),
            (Legend{{"0", "none"}, {"1", "1"}, {"2", "2 to 3"}, {"4", "8 to 9"}}));
  EXPECT_EQ(legend_of(plot::sheet_of(map_of({72, 75, 79, 85}))),
            (Legend{{"1", "72 to 73"}, {"2", "74 to 75"}, {"4", "78 to 79"}, {"7", "84 to 85"}}))
      << "amounts that are alike have classes of one width";
  EXPECT_EQ(legend_of(plot::sheet_of(map_of({0, 0}))), (Legend{{"0", "none"}}));
  EXPECT_EQ(legend_of(plot::sheet_of(map_of({5}))), (Legend{{"1", "5"}}));
}

/// Where the middle grey of the swatches is drawn, a class has its swatch's colour, and no two look alike.
TEST(HeatMap, ColoursAreThoseOfTheLegend) {
  plot::HeatMap map = map_of({0, 1, 2, 4, 8, 16, 32, 300});
  for (Rgba8& pixel : map.picture.cells()) pixel = {128, 128, 128, 255};
  const Sheet sheet = plot::sheet_of(map);
  std::set<std::vector<int>> colours;
  int swatches = 0;
  for (const Shape& shape : sheet.shapes) {
    if (!shape.id.starts_with("swatch ")) continue;
    const int number = std::stoi(shape.id.substr(7));
    const Rgba8 swatch = std::get<ImageShape>(shape.what).image[{0, 0}];
    EXPECT_EQ((picture_of(sheet).image[{number, 0}]), swatch) << number;
    colours.insert({swatch.r, swatch.g, swatch.b});
    ++swatches;
  }
  EXPECT_EQ(swatches, 8);
  EXPECT_EQ(colours.size(), 8u);
}

TEST(HeatMap, EverythingIsLargeEnoughAndOnTheSheet) {
  for (const auto& [width, height] : {std::pair{1280.0, 720.0}, {960.0, 720.0}, {720.0, 720.0}}) {
    plot::HeatMap map = map_of({0, 1, 2, 4, 8, 16, 32, 300});
    map.picture = Image(640, 360), map.amounts = Raster<int>(640, 360, 3);
    const Sheet sheet = plot::sheet_of(map, width, height);
    for (const Shape& shape : sheet.shapes) {
      const Box box = extents_of(shape);
      EXPECT_TRUE(0 <= box.x && box.right() <= width && 0 <= box.y && box.bottom() <= height) << shape.id;
      if (const auto* text = std::get_if<TextShape>(&shape.what))
        EXPECT_GE(text->size, 720 / 36.0) << shape.id;
    }
  }
}

TEST(HeatMap, RefusesAmountsOfAnotherSize) {
  plot::HeatMap map = map_of({1, 2});
  map.picture = Image(3, 1);
  EXPECT_THROW(plot::sheet_of(map), ContractViolation);
}

}  // namespace
}  // namespace gradus
