#include "figure/transition.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <set>

namespace gradus {
namespace {

// --- One shape -------------------------------------------------------------------------------------------

double eased(double share) { return share * share * (3 - 2 * share); }

double mixed(double from, double to, double share) { return from + share * (to - from); }
dvec2 mixed(dvec2 from, dvec2 to, double share) { return from + share * (to - from); }
Box mixed(const Box& from, const Box& to, double share) {
  return {mixed(from.x, to.x, share), mixed(from.y, to.y, share), mixed(from.width, to.width, share),
          mixed(from.height, to.height, share)};
}

/// An open chain that the other one continues stands still at its end for as long as the other goes on.
std::vector<dvec2> as_long_as(const LineShape& other, const LineShape& line) {
  std::vector<dvec2> points = line.points;
  const bool goes_on = !line.closed && !other.closed && !points.empty() &&
                       points.size() < other.points.size() &&
                       std::equal(points.begin(), points.end(), other.points.begin());
  if (goes_on) points.resize(other.points.size(), line.points.back());
  return points;
}

// Each puts a shape, which is a copy of one of the two, between their places: moved by a share of the way.

void place(RectShape& shape, const RectShape& from, const RectShape& to, double share) {
  shape.box = mixed(from.box, to.box, share);
  shape.radius = mixed(from.radius, to.radius, share);
}
void place(AreaShape& shape, const AreaShape& from, const AreaShape& to, double share) {
  const auto same_size = [](const auto& a, const auto& b) { return a.size() == b.size(); };
  if (!std::ranges::equal(from.rings, to.rings, same_size)) return;
  for (std::size_t ring = 0; ring < shape.rings.size(); ++ring) {
    for (std::size_t i = 0; i < shape.rings[ring].size(); ++i)
      shape.rings[ring][i] = mixed(from.rings[ring][i], to.rings[ring][i], share);
  }
}
void place(LineShape& shape, const LineShape& from, const LineShape& to, double share) {
  const std::vector<dvec2> first = as_long_as(to, from), last = as_long_as(from, to);
  if (first.size() != last.size()) return;
  shape.points = first;
  for (std::size_t i = 0; i < first.size(); ++i) shape.points[i] = mixed(first[i], last[i], share);
}
void place(StrokesShape& shape, const StrokesShape& from, const StrokesShape& to, double share) {
  if (from.segments.size() != to.segments.size()) return;
  for (std::size_t i = 0; i < shape.segments.size(); ++i) {
    shape.segments[i] = {mixed(from.segments[i].a, to.segments[i].a, share),
                         mixed(from.segments[i].b, to.segments[i].b, share)};
  }
}
void place(DiscShape& shape, const DiscShape& from, const DiscShape& to, double share) {
  shape.centre = mixed(from.centre, to.centre, share);
  shape.radius = mixed(from.radius, to.radius, share);
}
void place(TextShape& shape, const TextShape& from, const TextShape& to, double share) {
  // Labels that change would meet halfway and be read as one
  if (from.align != to.align || from.text != to.text) return;
  shape.baseline = mixed(from.baseline, to.baseline, share);
  shape.size = mixed(from.size, to.size, share);
}
void place(ImageShape& shape, const ImageShape& from, const ImageShape& to, double share) {
  shape.box = mixed(from.box, to.box, share);
}

Shape moved_between(const Shape& from, const Shape& to, double share) {
  Shape shape = share < 0.5 ? from : to;
  std::visit(
      [&](auto& what) {
        using What = std::remove_cvref_t<decltype(what)>;
        place(what, std::get<What>(from.what), std::get<What>(to.what), eased(share));
      },
      shape.what);
  return shape;
}

// --- All of them -----------------------------------------------------------------------------------------

/// What a shape is called. Several may have one id: a cell's ground and its text, the strokes of a cross.
struct Name {
  Slot slot;
  std::size_t kind;
  std::string id;
  int count;  ///< of that slot, kind and id before it
  auto operator<=>(const Name&) const = default;
};
using Named = std::map<Name, const Shape*>;

std::vector<Name> names_of(const Sheet& sheet) {
  std::set<Name> known;
  std::vector<Name> names;
  for (const Shape& shape : sheet.shapes) {
    Name name{shape.slot, shape.what.index(), shape.id, 0};
    while (!known.insert(name).second) ++name.count;
    names.push_back(std::move(name));
  }
  return names;
}

Named by_name(const Sheet& sheet, const std::vector<Name>& names) {
  Named named;
  for (std::size_t i = 0; i < names.size(); ++i) named[names[i]] = &sheet.shapes[i];
  return named;
}

/// A text of the furniture: a number beside an axis, a line of the listing, a cell of the table.
const TextShape* furniture_text(const Shape& shape) {
  const auto* text = std::get_if<TextShape>(&shape.what);
  return text && !text->is_rim() && text->paint.part == Paint::Part::tone ? text : nullptr;
}

/// The slots in which a text of the furniture stands elsewhere.
std::set<Slot> slots_that_jump(const Named& from, const Named& to) {
  std::set<Slot> jumping;
  for (const auto& [name, shape] : from) {
    const auto other = to.find(name);
    if (other == to.end()) continue;
    const TextShape *before = furniture_text(*shape), *after = furniture_text(*other->second);
    if (before && after && before->baseline != after->baseline) jumping.insert(name.slot);
  }
  return jumping;
}

}  // namespace

Sheet in_between(const Sheet& from, const Sheet& to, double share) {
  if (share <= 0) return from;
  if (share >= 1) return to;
  const std::vector<Name> left = names_of(from), right = names_of(to);
  const Named before = by_name(from, left), after = by_name(to, right);
  const std::set<Slot> jumping = slots_that_jump(before, after);

  // Only shapes of the first sheet are seen in the first half, in its drawing order; then those of the second
  const bool early = share < 0.5;
  Sheet sheet = early ? from : to;
  const std::vector<Name>& names = early ? left : right;
  const Named& others = early ? after : before;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (jumping.contains(names[i].slot)) continue;
    Shape& shape = sheet.shapes[i];
    if (const auto other = others.find(names[i]); other != others.end()) {
      shape =
          early ? moved_between(shape, *other->second, share) : moved_between(*other->second, shape, share);
    } else {
      shape.opacity = std::abs(1 - 2 * share);
    }
  }
  return sheet;
}

}  // namespace gradus
