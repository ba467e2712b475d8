#pragma once
// What stories of the painter draw: the picture as it is painted so far, the order with its keys, the faces
// from above, and a plane edge-on.

#include "stories/visibility/bsp_tree/drawing.hpp"
#include "stories/visibility/name_places.hpp"
#include "visibility/painter/painter.hpp"

namespace gradus::painter {

using bsp_tree::DPolygon;
using bsp_tree::EdgeOnPicture;
using bsp_tree::PartNames;
using bsp_tree::same_as;
using DView = painter::View<double>;
using Drawing = gradus::View;
using Rectangle = gradus::Extent;

inline constexpr int paper_width = 36, paper_height = 24;

/// What a run is about: polygons, and their viewer.
struct Subject : bsp_tree::Polygons {
  DView view{};
  dvec3 right{}, up{}, forward{};  ///< of the view, of length 1

  bool distant() const { return view.eye.w == 0; }
  /// From the eye; from the origin where it is infinitely far away.
  dvec3 from_eye(dvec3 p) const { return p - view.eye.w * dvec3(view.eye); }
  double depth(dvec3 p) const { return glm::dot(forward, from_eye(p)); }
  /// Seen from above: from side to side, and in depth.
  dvec2 from_above(dvec3 p) const { return {glm::dot(right, from_eye(p)), depth(p)}; }
  /// On the screen.
  dvec2 seen(dvec3 p) const {
    const dvec2 flat{glm::dot(right, from_eye(p)), glm::dot(up, from_eye(p))};
    return distant() ? flat : flat / depth(p);
  }
  Ring2 seen(const DPolygon& polygon) const {
    return mapped(polygon.corners, [&](dvec3 p) { return seen(p); });
  }
};

/// The eye must be outside, with all in front of it: 89 degrees aside at most.
inline void require_in_front(const Arguments& arguments, const Subject& subject) {
  for (const DPolygon& polygon : subject.polygons) {
    for (const dvec3 p : polygon.corners) {
      if (subject.depth(p) > 0.0175 * glm::length(subject.from_eye(p))) continue;
      refuse(arguments, {"eye", "faces"},
             fmt::format("an eye outside expected, with all faces in front of it; {} is beside or behind it",
                         subject.parts[polygon.face].name));
    }
  }
}

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{bsp_tree::polygons_of(arguments)};
  Bounds bounds;
  for (const dvec3 p : subject.points) bounds.add(p);
  const auto eye = arguments.place("eye");
  if (eye && *eye == bounds.centre())
    refuse(arguments, {"eye"}, "an eye outside expected, found it in the middle of all faces");
  const faces_subject::Reader reader =
      eye ? faces_subject::Reader(*eye - bounds.centre()) : faces_subject::reader_of(arguments);
  subject.right = reader.right;
  subject.up = reader.up;
  subject.forward = -reader.towards;
  subject.view = eye ? view_along(Eye<double>(*eye, 1), bounds.centre() - *eye, reader.up)
                     : distant_view(*arguments.place("towards"), reader.up);
  if (eye) require_in_front(arguments, subject);
  return subject;
}

/// Of the paper: the picture, and beside it the order above a second look at the faces.
inline constexpr Rectangle picture_place{{1.6, 2.2}, {19.6, 22.6}}, order_place{{21, 15.8}, {35.6, 23.6}},
    beside_place{{22, 1.2}, {34.6, 12.6}};

/// Cards of the order that are shown.
inline constexpr std::size_t most_cards = 5;

// --- The picture

/// Where two convex rings overlap.
inline Ring2 common_part(Ring2 ring, const Ring2& window) {
  const auto cross = [](dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; };
  double turn = 0;
  for (const auto& [a, b] : sides_of(window)) turn += cross(a, b);
  for (const auto& [a, b] : sides_of(window)) {
    const auto inside = [&](dvec2 p) { return turn * cross(b - a, p - a); };
    Ring2 kept;
    for (const auto& [p, q] : sides_of(ring)) {
      const double from = inside(p), to = inside(q);
      if (from >= 0) kept.push_back(p);
      if ((from < 0) != (to < 0)) kept.push_back(p + from / (from - to) * (q - p));
    }
    ring = std::move(kept);
  }
  return ring;
}

/// Whether a ring on the screen is more than a line.
inline bool has_inside(const Ring2& ring) {
  double area = 0, size = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    area += a.x * b.y - a.y * b.x;
    size = std::max({size, std::abs(a.x), std::abs(a.y)});
  }
  return std::abs(area) > 1e-6 * size * size;
}

/// One polygon painted over another that is in front of it.
struct Wrong {
  DPolygon late, early;
  std::size_t number;  ///< the late one's
};

/// The depth at which a sight line meets a polygon's plane.
inline double depth_at(const Subject& subject, const DPolygon& polygon, dvec2 seen) {
  const dvec3 normal = unit_vector(area_vector(polygon.corners));
  const dvec3 aside = seen.x * subject.right + seen.y * subject.up;
  const double to_plane = glm::dot(normal, subject.from_eye(polygon.corners[0]));
  if (!subject.distant()) return to_plane / glm::dot(normal, aside + subject.forward);
  return (to_plane - glm::dot(normal, aside)) / glm::dot(normal, subject.forward);
}

/// Whether one that is painted over another lies behind it somewhere.
inline bool wrongly_over(const Subject& subject, const DPolygon& late, const DPolygon& early) {
  const Ring2 common = common_part(subject.seen(late), subject.seen(early));
  if (!has_inside(common)) return false;
  return std::ranges::any_of(common, [&](dvec2 place) {
    const double over = depth_at(subject, late, place), under = depth_at(subject, early, place);
    return over > under + 1e-6 * (std::abs(over) + std::abs(under));
  });
}

/// What is painted so far, over outlines of what is to come; and the two polygons at hand.
class Picture {
 public:
  explicit Picture(const Subject& subject)
      : subject_(subject),
        flat_(faces_subject::Reader(dvec3{0, 0, 1}), picture_place,
              mapped(subject.points, [&](dvec3 p) { return dvec3(subject.seen(p), 0); })) {}

  dvec2 at(dvec3 p) const { return flat_.at(dvec3(subject_.seen(p), 0)); }
  std::optional<dvec2> shown_at(dvec3 p) const {
    return subject_.distant() || subject_.depth(p) > 0 ? std::optional(at(p)) : std::nullopt;
  }
  Ring2 at(const DPolygon& polygon) const {
    return mapped(polygon.corners, [&](dvec3 p) { return at(p); });
  }

  void add_painted(Drawing& drawing, const std::vector<DPolygon>& painted, const PartNames& names, Role role,
                   Role last, const std::vector<DPolygon>& waiting) const {
    std::vector<ShownFace> faces;
    for (const DPolygon& polygon : painted) faces.push_back({names(polygon), on_screen(polygon), role});
    if (!faces.empty()) faces.back().role = last;
    flat_.add_painted(drawing, std::move(faces),
                      mapped(waiting, [&](const DPolygon& polygon) { return on_screen(polygon); }));
  }
  /// The outline of the one that waits in this place, with its name where it is in none of the others that
  /// wait; later ones lie below.
  void add_outline(Drawing& drawing, std::size_t place, Role role, const std::string& name,
                   const std::vector<DPolygon>& waiting) const {
    const DPolygon& polygon = waiting[place];
    const std::string id = fmt::format("p {:03} {}", waiting.size() - place, name);
    const Ring2 ring = at(polygon);
    std::vector<Ring2> others;
    for (const DPolygon& other : waiting) {
      if (Ring2 outline = at(other); outline != ring) others.push_back(std::move(outline));
    }
    if (role != Role::past) drawing.add({id + " inside", role, Area{{ring}, 1}});
    drawing.add({id, role, Path{ring, true}});
    drawing.add({id + " name", role, Text{clear_place(ring, others), name}});
  }
  /// Where one may cover the other.
  void add_common(Drawing& drawing, const DPolygon& p, const DPolygon& q, Role role) const {
    if (const Ring2 ring = common_part(at(p), at(q)); ring.size() >= 3)
      add_ring(drawing, fmt::format("q common {:03}", drawing.marks.size()), role, ring, 3);
  }
  /// A line that has p on one side and q on the other: level, upright, or along an edge.
  void add_parting(Drawing& drawing, const DPolygon& p, const DPolygon& q, Test passed) const {
    const Ring2 a = at(p), b = at(q);
    if (passed == Test::apart) {
      for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (add_parting_edge(drawing, one, other)) return;
      }
      return;
    }
    const int axis = passed == Test::across ? 0 : 1;
    const auto [least_a, most_a] = range(a, axis);
    const auto [least_b, most_b] = range(b, axis);
    const double middle = most_a <= least_b + 1e-9 ? (most_a + least_b) / 2 : (most_b + least_a) / 2;
    const auto& [lower, upper] = picture_place;
    const double foot = axis == 0 ? lower.y - 0.9 : lower.x - 0.9;
    const auto place = [&](double along, double across) {
      return axis == 0 ? dvec2{along, across} : dvec2{across, along};
    };
    drawing.add(
        {"m parting", Role::measure,
         Stroke{place(middle, foot - 0.5), place(middle, axis == 0 ? upper.y : upper.x), false, true}});
    drawing.add({"m extent p", Role::current, Stroke{place(least_a, foot), place(most_a, foot)}});
    drawing.add({"m extent q", Role::accepted, Stroke{place(least_b, foot), place(most_b, foot)}});
  }

 private:
  Ring on_screen(const DPolygon& polygon) const {
    return mapped(polygon.corners, [&](dvec3 p) { return dvec3(subject_.seen(p), 0); });
  }
  static std::pair<double, double> range(const Ring2& ring, int axis) {
    const Rectangle extent = extent_around(ring);
    return {extent.lower[axis], extent.upper[axis]};
  }
  static bool add_parting_edge(Drawing& drawing, const Ring2& ring, const Ring2& other) {
    for (const auto& [a, b] : sides_of(ring)) {
      const auto side = [&](dvec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
      double inside = 0;
      for (const dvec2 p : ring) inside += side(p);
      const double margin = 1e-6 * std::abs(inside);
      if (std::ranges::any_of(other, [&](dvec2 p) { return side(p) * inside > margin * margin; })) continue;
      const auto [from, to] = span_in(picture_place, a, b - a, -1e3, 1e3);
      drawing.add({"m parting", Role::measure, Stroke{a + from * (b - a), a + to * (b - a), false, true}});
      return true;
    }
    return false;
  }

  const Subject& subject_;
  FacesPicture flat_;
};

// --- The order

/// A sheet of the order: what it is called, its key, and how it looks.
struct Entry {
  std::string name;
  double key;
  Role role;
};

/// The parts of a line, from 0 to 1, that are in none of some convex rings.
inline std::vector<std::pair<double, double>> uncovered(dvec2 a, dvec2 b, std::span<const Ring2> rings) {
  std::vector<std::pair<double, double>> parts{{0, 1}};
  for (const Ring2& ring : rings) {
    const double turn = std::copysign(1.0, doubled_area_of(ring));
    double enter = 0, leave = 1;
    for (const auto& [start, end] : sides_of(ring)) {
      const auto inside = [&, p = start, q = end](dvec2 x) {
        return turn * ((q.x - p.x) * (x.y - p.y) - (q.y - p.y) * (x.x - p.x)) - 1e-9;
      };
      const double from = inside(a), to = inside(b);
      if (from <= 0 && to <= 0) leave = -1;
      if (from <= 0 && to > 0) enter = std::max(enter, from / (from - to));
      if (from > 0 && to <= 0) leave = std::min(leave, from / (from - to));
    }
    if (enter >= leave) continue;
    std::vector<std::pair<double, double>> left;
    for (const auto& [from, to] : parts) {
      if (from < std::min(to, enter)) left.emplace_back(from, std::min(to, enter));
      if (std::max(from, leave) < to) left.emplace_back(std::max(from, leave), to);
    }
    parts = std::move(left);
  }
  return parts;
}

/// The order as a strip of cards: on each the canvas once its sheet is painted, over all that come before.
class OrderStrip {
 public:
  /// cards: so many at most.
  OrderStrip(const Subject& subject, std::size_t cards)
      : subject_(subject),
        extent_(extent_around(mapped(subject.points, [&](dvec3 p) { return subject.seen(p); }))),
        wide_(order_place.size().x / static_cast<double>(std::max<std::size_t>(cards, 3))) {}

  /// order: all sheets with their entries. first, count: those that have cards. caption: what the keys are.
  void add(Drawing& drawing, const std::vector<DPolygon>& order, const std::vector<Entry>& entries,
           std::size_t first, std::size_t count, const std::string& caption) const {
    std::vector<Sheet> sheets;
    for (std::size_t i = 0; i < first + count; ++i) {
      const Entry& entry = entries[i];
      sheets.push_back({subject_.seen(order[i]), entry.role});
      if (i >= first) add_card(drawing, i - first, i + 1, entry, sheets);
      if (entry.role != Role::past) sheets.back().role = Role::input;
    }
    const dvec2 below{order_place.lower.x + wide_ * static_cast<double>(count) / 2,
                      order_place.lower.y + 0.3};
    drawing.add({"l caption", Role::guide, aside(below, caption)});
  }

 private:
  /// The cards of a drawing among many are too small for it.
  static Text aside(dvec2 at, std::string text) { return {.at = at, .text = std::move(text), .aside = true}; }
  struct Sheet {
    Ring2 ring;  ///< on the screen
    Role role;
  };
  void add_card(Drawing& drawing, std::size_t at, std::size_t number, const Entry& entry,
                const std::vector<Sheet>& sheets) const {
    const double left = order_place.lower.x + wide_ * static_cast<double>(at), middle = left + wide_ / 2;
    const Rectangle card{{left + 0.2, order_place.lower.y + 2.3},
                         {left + wide_ - 0.2, order_place.upper.y - 1.2}};
    const std::string id = fmt::format("l {:03} ", number);
    drawing.add({id + "card", Role::guide, Path{card.corners(), true}});
    drawing.add({id + "name", entry.role,
                 aside({middle, order_place.upper.y - 0.4}, fmt::format("{}. {}", number, entry.name))});
    drawing.add({id + "value", entry.role, aside({middle, order_place.lower.y + 1.6}, brief(entry.key))});
    const Panel panel({card.lower + 0.25, card.upper - 0.25}, extent_);
    const std::vector<Ring2> rings = mapped(sheets, [&](const Sheet& sheet) { return panel.at(sheet.ring); });
    for (std::size_t i = 0; i < rings.size(); ++i) {
      const Role role = sheets[i].role;
      drawing.add({fmt::format("{}sheet {:03}", id, i), role, Area{{rings[i]}, 2}});
      std::size_t line = 0;
      for (const auto& [a, b] : sides_of(rings[i])) {
        for (const auto& [from, to] : uncovered(a, b, std::span(rings).subspan(i + 1)))
          drawing.add({fmt::format("{}side {:03} {:03}", id, i, line++), role,
                       Stroke{a + from * (b - a), a + to * (b - a), false, false, i + 1 < rings.size()}});
      }
    }
  }
  /// Three digits are enough to compare.
  static std::string brief(double key) {
    return figure_real(std::strtod(fmt::format("{:.3g}", key).c_str(), nullptr));
  }

  const Subject& subject_;
  const Rectangle extent_;
  const double wide_;
};

// --- From above

/// The faces seen along the screen's upright: depths go up, from the eye below.
class PlanPicture {
 public:
  PlanPicture(const Subject& subject, const Rectangle& place)
      : subject_(subject), place_(place), panel_(place, {}) {
    Rectangle extent = extent_around(mapped(subject.points, [&](dvec3 p) { return subject.from_above(p); }));
    if (shows_eye(extent)) extent.add(dvec2{0});
    panel_ = Panel({place_.lower + dvec2{0, 1.4}, place_.upper}, extent);
    if (shows_eye(extent)) eye_ = panel_.at(dvec2{0});
  }

  void add_polygon(Drawing& drawing, const DPolygon& polygon, Role role, const std::string& name,
                   int rank) const {
    const Ring2 ring = mapped(polygon.corners, [&](dvec3 p) { return panel_.at(subject_.from_above(p)); });
    drawing.add({fmt::format("v {} {}", rank, name), role, Path{ring, true}});
    drawing.add({"w " + name, role, Label{middle_of(ring), name}});
  }
  /// The eye, or the way to it.
  void add_eye(Drawing& drawing, const std::string& name) const {
    if (eye_) {
      drawing.add_named("u eye", Role::boundary, *eye_, name);
      return;
    }
    const dvec2 at{place_.centre().x, place_.lower.y + 0.2};
    drawing.add({"u eye", Role::boundary, Stroke{at + dvec2{0, 1.3}, at, true}});
    drawing.add({"u eye name", Role::boundary, Text{at + dvec2{0.7, 0.4}, name, Align::left}});
  }
  /// The depth at which one begins.
  void add_depth(Drawing& drawing, double depth) const {
    const double y = panel_.at(dvec2{0, depth}).y;
    drawing.add({"m depth", Role::measure, Stroke{{place_.lower.x, y}, {place_.upper.x, y}, false, true}});
  }
  /// The distance of a place from the eye.
  void add_distance(Drawing& drawing, dvec3 place, Role role, const std::string& name,
                    const std::string& text) const {
    if (!eye_) return;
    const dvec2 to = panel_.at(subject_.from_above(place));
    drawing.add({"x " + name, role, Stroke{*eye_, to, false, false, true}});
    drawing.add({"x " + name + " end", role, Dot{to}});
    drawing.add({"x " + name + " text", role, Label{0.5 * (*eye_ + to), text}});
  }

 private:
  /// It is not so far away that the faces become small.
  bool shows_eye(const Rectangle& extent) const {
    return !subject_.distant() && extent.lower.y <= 1.5 * std::max(extent.size().x, extent.size().y);
  }

  const Subject& subject_;
  const Rectangle place_;
  Panel panel_;
  std::optional<dvec2> eye_{};
};

}  // namespace gradus::painter
