#include "json/drawing_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "figure/text/markup.hpp"

namespace gradus::json {
namespace {

int index_of(Role role) { return static_cast<int>(role); }

/// Of a place in a drawing what can be seen: a ten-thousandth of a cell. With all their digits, drawings were
/// most of a page that plays a run.
double seen(double x) {
  const double rounded = std::round(x * 1e4) / 1e4;
  return std::isfinite(rounded) ? rounded : x;
}
Json places_json(std::vector<dvec2> places) {
  for (dvec2& p : places) p = {seen(p.x), seen(p.y)};
  return points_json(places);
}

}  // namespace

Json points_json(const std::vector<dvec2>& points) {
  Json out = Json::array();
  for (const dvec2& p : points) out.insert(out.end(), {p.x, p.y});
  return out;
}

Json picture_json(const Image& image) {
  std::unordered_map<std::uint32_t, std::size_t> index;
  Json palette = Json::array();
  std::string indices, rgba;
  for (const Rgba8& c : image.cells()) {
    const std::array<std::uint8_t, 4> bytes{c.r, c.g, c.b, c.a};
    for (const std::uint8_t b : bytes) rgba += static_cast<char>(b);
    if (index.size() > 256) continue;
    const std::uint32_t color =
        std::uint32_t{c.r} << 24 | std::uint32_t{c.g} << 16 | std::uint32_t{c.b} << 8 | c.a;
    const auto [found, is_new] = index.try_emplace(color, index.size());
    if (is_new) palette.push_back(Json(bytes));
    indices += static_cast<char>(found->second);
  }
  Json out{{"width", image.width()}, {"height", image.height()}};
  if (index.size() <= 256) {
    out["palette"] = std::move(palette);
    out["indices"] = base64(indices);
  } else {
    out["rgba"] = base64(rgba);
  }
  return out;
}

Json mark_json(const Mark& mark) {
  Json out = Json::array({mark.id, index_of(mark.role)});
  if (const auto* dot = std::get_if<Dot>(&mark.shape)) {
    out.insert(out.end(), {dot->ring ? "ring" : "dot", seen(dot->at.x), seen(dot->at.y)});
  } else if (const auto* stroke = std::get_if<Stroke>(&mark.shape)) {
    out.push_back(stroke->arrow ? "arrow" : "stroke");
    out.insert(out.end(), {seen(stroke->a.x), seen(stroke->a.y), seen(stroke->b.x), seen(stroke->b.y)});
    if (stroke->dashed) out.push_back("dashed");
    if (stroke->thin) out.push_back("thin");
  } else if (const auto* path = std::get_if<Path>(&mark.shape)) {
    out.push_back(path->closed ? "polygon" : "path");
    out.push_back(places_json(path->points));
    if (path->dashed) out.push_back("dashed");
  } else if (const auto* area = std::get_if<Area>(&mark.shape)) {
    out.push_back("area");
    for (const auto& ring : area->rings) out.push_back(places_json(ring));
    if (area->shade > 0) out.push_back(area->shade);
  } else if (const auto* text = std::get_if<Text>(&mark.shape)) {
    constexpr std::array<std::string_view, 3> aligns{"left", "centre", "right"};
    out.insert(out.end(), {"text", seen(text->at.x), seen(text->at.y), text->text,
                           aligns[static_cast<std::size_t>(text->align)]});
    if (text->line != 0) out.push_back(text->line);
  } else if (const auto* label = std::get_if<Label>(&mark.shape)) {
    out.insert(out.end(), {"label", seen(label->at.x), seen(label->at.y), label->text});
  } else if (const auto* picture = std::get_if<Picture>(&mark.shape)) {
    out.insert(out.end(), {"picture", seen(picture->lower.x), seen(picture->lower.y), seen(picture->upper.x),
                           seen(picture->upper.y), picture_json(*picture->image)});
  }
  if (!mark.quantity.empty()) out.push_back({{"quantity", mark.quantity}});
  return out;
}

std::string hex(Rgba8 color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const int part : {color.r, color.g, color.b}) {
    text += digits[static_cast<std::size_t>(part / 16)];
    text += digits[static_cast<std::size_t>(part % 16)];
  }
  return text;
}

Json run_json(ivec2 start, std::int64_t count, const std::optional<CellLook>& look) {
  Json run = Json::array({start.x, start.y, count, look ? index_of(look->role) : -1});
  if (look && (look->color || !look->text.empty())) run.push_back(look->text);
  if (look && look->color) run.push_back(hex(*look->color));
  return run;
}

}  // namespace gradus::json
