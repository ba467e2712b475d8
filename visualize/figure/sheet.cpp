#include "figure/sheet.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

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

/// Of points, with so much air round them.
class Extents {
 public:
  void add(dvec2 point) {
    lower_ = {std::min(lower_.x, point.x), std::min(lower_.y, point.y)};
    upper_ = {std::max(upper_.x, point.x), std::max(upper_.y, point.y)};
  }
  Box with(double air) const {
    return {lower_.x - air, lower_.y - air, upper_.x - lower_.x + 2 * air, upper_.y - lower_.y + 2 * air};
  }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  dvec2 lower_{far, far}, upper_{-far, -far};
};

Box widened(const Box& box, double by) {
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

Box extents(const RectShape& s) { return widened(s.box, s.stroke_width / 2); }
Box extents(const AreaShape& s) {
  Extents all;
  for (const auto& ring : s.rings) {
    for (const dvec2& point : ring) all.add(point);
  }
  return all.with(0);
}
Box extents(const LineShape& s) {
  Extents all;
  for (const dvec2& point : s.points) all.add(point);
  return all.with(s.arrow ? 3 * s.width : s.width / 2);
}
Box extents(const StrokesShape& s) {
  Extents all;
  for (const auto& [a, b] : s.segments) all.add(a), all.add(b);
  return all.with(s.width / 2);
}
Box extents(const DiscShape& s) {
  const double radius = s.radius + s.stroke_width / 2;
  return {s.centre.x - radius, s.centre.y - radius, 2 * radius, 2 * radius};
}
Box extents(const TextShape& s) { return s.box(); }
Box extents(const ImageShape& s) { return s.box; }

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

Box extents_of(const Shape& shape) {
  return std::visit([](const auto& what) { return extents(what); }, shape.what);
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
