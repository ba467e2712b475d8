#include "figure/sheet.hpp"

#include <initializer_list>

namespace gradus {
namespace {

std::optional<Role> role_among(std::initializer_list<Paint> paints) {
  for (const Paint& paint : paints) {
    if (paint.part != Paint::Part::none && paint.part != Paint::Part::tone) return paint.role;
  }
  return std::nullopt;
}

std::optional<Role> role_in(const RectShape& s) { return role_among({s.fill, s.stroke, s.hatch_paint}); }
std::optional<Role> role_in(const AreaShape& s) { return role_among({s.fill, s.hatch_paint}); }
std::optional<Role> role_in(const LineShape& s) { return role_among({s.stroke}); }
std::optional<Role> role_in(const StrokesShape& s) { return role_among({s.stroke}); }
std::optional<Role> role_in(const DiscShape& s) { return role_among({s.fill, s.stroke}); }
std::optional<Role> role_in(const TextShape& s) { return role_among({s.paint}); }
std::optional<Role> role_in(const ImageShape&) { return std::nullopt; }  // of as many roles as it has cells

void move(Box& box, dvec2 by) {
  box.x += by.x;
  box.y += by.y;
}
void move(RectShape& s, dvec2 by) { move(s.box, by); }
void move(AreaShape& s, dvec2 by) {
  for (auto& ring : s.rings) {
    for (dvec2& point : ring) point += by;
  }
}
void move(LineShape& s, dvec2 by) {
  for (dvec2& point : s.points) point += by;
}
void move(StrokesShape& s, dvec2 by) {
  for (auto& [a, b] : s.segments) a += by, b += by;
}
void move(DiscShape& s, dvec2 by) { s.centre += by; }
void move(TextShape& s, dvec2 by) { s.baseline += by; }
void move(ImageShape& s, dvec2 by) { move(s.box, by); }

}  // namespace

std::optional<Role> role_of(const Shape& shape) {
  return std::visit([](const auto& what) { return role_in(what); }, shape.what);
}

Shape moved(Shape shape, dvec2 by) {
  std::visit([by](auto& what) { move(what, by); }, shape.what);
  return shape;
}

Sheet cropped(Sheet sheet, const Box& box) {
  for (Shape& shape : sheet.shapes) shape = moved(std::move(shape), {-box.x, -box.y});
  sheet.width = box.width;
  sheet.height = box.height;
  return sheet;
}

}  // namespace gradus
