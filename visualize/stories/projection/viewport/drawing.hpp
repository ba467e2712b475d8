#pragma once
// The drawing of a window's way into a picture: the camera plane and the picture with its pixels, their
// frames of one height, and below them the pixel at hand enlarged.

#include "projection/viewport/viewport.hpp"
#include "stories/telling.hpp"

namespace gradus::viewport {

struct Subject {
  Mapping<double> map;
  std::vector<dvec2> points;
  Rounding rounding;
  bool boxed;  ///< the window keeps its shape
};

/// What is known of a point so far.
struct Fate {
  std::optional<dvec2> fraction{}, place{};
  std::optional<ivec2> nearest{};  ///< before it was moved
  std::optional<ivec2> pixel{};
  bool outside = false;

  bool moved() const { return nearest && pixel != nearest; }
};

inline dvec2 centre(ivec2 pixel) { return dvec2(pixel) + 0.5; }

/// A coordinate in pixels; with all its digits where rounding it for the reader would name another pixel.
inline std::string pixels_text(double x) {
  const std::string shown = figure_real(x);
  const bool same = std::floor(x) == std::floor(std::round(x * 1000) / 1000);
  return same ? shown : (x < 0 ? "−" : "") + fmt::format("{:.17g}", std::abs(x));
}

/// A part of the picture on the paper. Rows are counted down where row 0 is at the top.
class PictureView {
 public:
  PictureView(const Extent& place, Extent pixels, bool rows_down)
      : pixels_(pixels), rows_down_(rows_down), panel_(place, turned(pixels)) {}

  dvec2 at(dvec2 pixel) const { return panel_.at({pixel.x, rows_down_ ? -pixel.y : pixel.y}); }
  Path box(dvec2 lower, dvec2 upper) const {
    return {{at(lower), at({upper.x, lower.y}), at(upper), at({lower.x, upper.y})}, true};
  }
  const Extent& pixels() const { return pixels_; }
  const Extent& place() const { return panel_.place(); }
  /// Paper units per pixel.
  double unit() const { return panel_.scale().x; }
  /// What is shown on the paper, no more than was asked for.
  Extent drawn() const {
    Extent all;
    all.add(at(pixels_.lower));
    all.add(at(pixels_.upper));
    return all;
  }

 private:
  Extent turned(const Extent& e) const {
    return rows_down_ ? Extent{{e.lower.x, -e.upper.y}, {e.upper.x, -e.lower.y}} : e;
  }

  Extent pixels_;
  bool rows_down_;
  Panel panel_;
};

class Drawing {
 public:
  /// clamps: room for the places outside, which decide what is drawn.
  Drawing(const Subject& subject, const Words& words, bool clamps)
      : subject_(subject),
        words_(words),
        near_(clamps ? dvec2{0.25, 0.2} : dvec2{0.16, 0.04}),
        places_(places_for()),
        plane_(places_.plane, plane_extent()),
        picture_(places_.picture, picture_extent(), rows_down()),
        fine_(picture_.unit() < least_pixel) {}

  /// current: the point of this step; points.size(): none. done: all pixels are results.
  View view(const std::vector<Fate>& fates, std::size_t current, bool done, bool clamped) const {
    View view;
    add_plane(view, fates, current);
    if (current < fates.size()) add_measures(view, subject_.points[current], fates[current]);
    add_picture(view);
    if (clamped) add_lines(view, fates);
    for (std::size_t i = 0; i < fates.size(); ++i) {
      if (fates[i].pixel) add_pixel(view, fates[i], letter(i), i == current, done);
      if (fates[i].place) add_place(view, fates[i], letter(i), i == current);
    }
    if (current < fates.size()) add_way(view, current, fates[current]);
    return view;
  }
  const Panel& plane() const { return plane_; }

 private:
  /// Three panels on a paper of 36 x 24.
  struct Places {
    Extent plane, picture;
  };
  static constexpr Extent upper_place{{3, 10.4}, {34, 21.2}}, enlarged_place{{20, 0}, {34, 5.8}};
  static constexpr double caption_gap = 2.1, least_height = 4, arrow_length = 1.6;
  /// Smaller pixels, in paper units, are enlarged with their neighbours.
  static constexpr double least_pixel = 0.5;

  /// Window and picture get one height, unless that makes both tiny, beside which there is room for points
  /// near them.
  Places places_for() const {
    const auto& [lower, upper] = subject_.map.window;
    const Extent plane = plane_extent(), picture = picture_extent();
    const double window = upper.y - lower.y, rows = subject_.map.picture.y, gap = 2;
    // In heights of the frames: sizes, and how far they reach below their frame's foot
    const dvec2 of_plane = plane.size() / window, of_picture = picture.size() / rows;
    const double below_plane = (lower.y - plane.lower.y) / window,
                 below_picture = (rows_down() ? picture.upper.y - rows : -picture.lower.y) / rows;
    const double below = std::max(below_plane, below_picture),
                 above = std::max(of_plane.y - below_plane, of_picture.y - below_picture);
    const auto [left, right] = std::pair{upper_place.lower, upper_place.upper};
    const double height = std::min((right.x - left.x - gap) / (of_plane.x + of_picture.x),
                                   (right.y - left.y) / (below + above));
    if (!(height >= least_height)) {
      const double middle = upper_place.centre().x;
      return {{left, {middle - gap / 2, right.y}}, {{middle + gap / 2, left.y}, right}};
    }
    const double spare = (right.x - left.x - gap - height * (of_plane.x + of_picture.x)) / 3;
    const double foot = right.y - height * above;
    const dvec2 at_plane{left.x + spare, foot - height * below_plane},
        at_picture{right.x - spare - height * of_picture.x, foot - height * below_picture};
    return {{at_plane, at_plane + height * of_plane}, {at_picture, at_picture + height * of_picture}};
  }

  Extent plane_extent() const {
    const auto& [lower, upper] = subject_.map.window;
    Extent seen{lower, upper};
    add_near(seen, subject_.points, (upper - lower) * near_.x);
    return widened(seen, 0.02);
  }
  Extent picture_extent() const {
    const dvec2 size(subject_.map.picture);
    Extent seen{{0, 0}, size};
    std::vector<dvec2> places;
    for (const dvec2 p : subject_.points)
      places.push_back(place_at(subject_.map.viewport, fraction_of(subject_.map, p)));
    add_near(seen, places, size * near_.y);
    return widened(seen, 0.02);
  }
  /// The extent reaches to those of the points that lie no farther beside it than `margin`.
  static void add_near(Extent& extent, const std::vector<dvec2>& points, dvec2 margin) {
    const Extent near{extent.lower - margin, extent.upper + margin};
    for (const dvec2 p : points) {
      if (near.holds(p)) extent.add(p);
    }
  }
  bool rows_down() const { return subject_.map.row_zero == RowZero::top; }

  /// Where a point is drawn: at its place, or, beyond its panel, at the nearest place of the border, and in
  /// which direction from there it lies.
  struct Spot {
    dvec2 at, outwards{0};
    bool here() const { return outwards == dvec2{0}; }
    /// Where what leads to it ends: before the arrow that points on.
    dvec2 end() const { return at - arrow_length * outwards; }
  };
  static Spot spot_in(const Extent& drawn, dvec2 at) {
    const dvec2 border = glm::clamp(at, drawn.lower, drawn.upper);
    return {border, border == at ? dvec2{0} : glm::normalize(glm::sign(at - border))};
  }
  Spot picture_spot(dvec2 place) const {
    return spot_in(widened(picture_.drawn(), 1e-9), picture_.at(place));
  }

  void add_caption(View& view, std::string_view id, std::string text, const Extent& place) const {
    view.add({fmt::format("caption {}", id), Role::guide,
              Text{{place.centre().x, place.upper.y + caption_gap}, std::move(text)}});
  }
  /// A dot, or an arrow to where the point lies beyond the panel.
  static void add_point(View& view, std::string id, Role role, const Spot& spot) {
    if (spot.here()) return view.add({std::move(id), role, Dot{spot.at}});
    view.add({std::move(id), role, Stroke{spot.end(), spot.at, true}});
  }
  Spot plane_spot(std::size_t i) const {
    const Extent shown = plane_.shown();
    Extent drawn;
    drawn.add(plane_.at(shown.lower));
    drawn.add(plane_.at(shown.upper));
    return spot_in(widened(drawn, 1e-9), plane_.at(subject_.points[i]));
  }
  void add_plane(View& view, const std::vector<Fate>& fates, std::size_t current) const {
    view.add({"caption plane", Role::guide,
              Text{{plane_.place().centre().x, upper_place.upper.y + caption_gap},
                   words_.say("caption.plane"),
                   Align::centre,
                   true}});
    add_axes(view, plane_, "plane", {words_.symbol("x"), words_.symbol("y")}, 4);
    const auto& [lower, upper] = subject_.map.window;
    view.add({"window", Role::boundary, Path{plane_.at(Extent{lower, upper}.corners()), true}});
    for (std::size_t i = 0; i < subject_.points.size(); ++i) {
      const Spot spot = plane_spot(i);
      const Role role = i == current ? Role::current : fates[i].outside ? Role::rejected : Role::input;
      add_point(view, "point " + letter(i), role, spot);
      view.add({"point name " + letter(i), role, Label{spot.at, letter(i)}});
    }
  }

  /// How far from the window's sides the point at hand is, and how far from the picture's.
  void add_measures(View& view, dvec2 p, const Fate& fate) const {
    if (!fate.fraction || !plane_.shown().holds(p)) return;
    const auto& [lower, upper] = subject_.map.window;
    const dvec2 from{lower.x, rows_down() ? upper.y : lower.y};
    add_measure(view, "across", plane_.at(from), plane_.at({p.x, from.y}), std::abs(p.x - from.x));
    add_measure(view, "down", plane_.at({p.x, from.y}), plane_.at(p), std::abs(p.y - from.y));
    if (!fate.place) return;
    const Spot to = picture_spot(*fate.place);
    if (!to.here()) return;
    add_measure(view, "column", picture_.at({0, 0}), picture_.at({fate.place->x, 0}), fate.place->x);
    add_measure(view, "row", picture_.at({fate.place->x, 0}), to.at, fate.place->y);
  }
  static void add_measure(View& view, std::string id, dvec2 from, dvec2 to, double value) {
    view.add({id, Role::measure, Stroke{from, to}});
    // On a side it says nothing
    const std::string text = figure_real(value);
    if (text != "0") view.add({id + " name", Role::measure, Label{(from + to) * 0.5, text}});
  }

  void add_picture(View& view) const {
    const std::string rows = rows_down() ? "rows_down" : "rows_up";
    view.add({"caption " + rows, Role::guide,
              Text{{picture_.place().centre().x, upper_place.upper.y + caption_gap},
                   words_.say("caption." + rows),
                   Align::centre,
                   true}});
    add_grid_lines(view, picture_, "picture", {{0, 0}, dvec2(subject_.map.picture)});
    view.add({"picture", Role::boundary, picture_.box({0, 0}, dvec2(subject_.map.picture))});
    if (!subject_.boxed) return;
    const auto& [lower, upper] = subject_.map.viewport;
    view.add({"viewport", Role::candidate, picture_.box(lower, upper)});
  }

  /// Lines between pixels where they can be told apart, with their numbers at the right, out of the way, and
  /// above, or below where rows are counted up.
  void add_grid_lines(View& view, const PictureView& pixels, const std::string& name,
                      const Extent& part) const {
    for (const int axis : {0, 1}) {
      const int first = static_cast<int>(std::ceil(part.lower[axis])),
                last = static_cast<int>(std::floor(part.upper[axis]));
      const int step = label_step(pixels, axis, first, last);
      const std::string which = axis == 0 ? "column" : "row";
      const dvec2 beside = axis == 1 ? dvec2{0.6, 0} : dvec2{0, rows_down() ? 0.9 : -0.9};
      for (int i = first; i <= last; ++i) {
        dvec2 a = part.lower, b = part.upper;
        a[axis] = b[axis] = i;
        if (pixels.unit() >= least_pixel)
          view.add({fmt::format("grid {} {} {:05}", name, which, i), Role::guide,
                    Stroke{pixels.at(a), pixels.at(b)}});
        if (i % step != 0) continue;
        view.add({fmt::format("grid value {} {} {:05}", name, which, i), Role::guide,
                  Text{pixels.at(axis == 1 ? b : a) + beside, figure_number(i),
                       axis == 1 ? Align::left : Align::centre}});
      }
    }
  }
  /// Every so many lines have their number: numbers need more room than lines.
  static int label_step(const PictureView& pixels, int axis, int first, int last) {
    const auto digits = static_cast<double>(figure_number(last).size());
    const double room = axis == 0 ? 0.9 * digits + 0.7 : 1.5;
    const int most = std::max(1, static_cast<int>((last - first) * pixels.unit() / room));
    return std::max(1, static_cast<int>(std::ceil(tick_distance(std::max(1, last - first), most))));
  }

  void add_pixel(View& view, const Fate& fate, const std::string& name, bool current, bool done) const {
    const Role role = fate.moved() ? Role::rejected
                      : done       ? Role::result
                      : current    ? Role::accepted
                                   : Role::past;
    const dvec2 corner(*fate.pixel), middle = picture_.at(centre(*fate.pixel));
    if (fine_) {
      if (!current) view.add_named("pixel " + name, role, middle, name);
    } else {
      const Path box = picture_.box(corner, corner + 1.0);
      view.add({"pixel " + name, role, gradus::Area{{box.points}}});
      view.add({"pixel " + name + " outline", role, box});
      if (!fate.place || done) view.add({"pixel name " + name, role, Label{middle, name}});
    }
    if (!fate.moved() || !current) return;
    const dvec2 from = picture_spot(dvec2(*fate.nearest)).at;
    view.add({"moved " + name, Role::rejected, Stroke{from, middle, true, true}});
  }

  void add_place(View& view, const Fate& fate, const std::string& name, bool current) const {
    if (fine_ && fate.pixel && !current) return;  // drawn as its pixel
    const Spot spot = picture_spot(*fate.place);
    const Role role = fate.outside ? Role::rejected : current ? Role::current : Role::input;
    add_point(view, "place " + name, role, spot);
    view.add({"place name " + name, role, Label{spot.at, name}});
  }

  // --- The point at hand, on its way

  /// From the camera plane to its place, and the pixel there enlarged.
  void add_way(View& view, std::size_t i, const Fate& fate) const {
    if (!fate.place) return;
    const Spot from = plane_spot(i), to = picture_spot(*fate.place);
    if (from.here()) view.add({"way", Role::current, Stroke{from.at, to.end(), to.here(), true}});
    if (!holds(subject_.map.viewport, *fate.place)) {
      if (fate.moved()) add_move(view, fate);
      return;
    }
    const ivec2 own = rounded(*fate.place, Rounding::floor);
    const dvec2 room = fine_ ? dvec2{3, 2} : dvec2{0};
    const Extent part{dvec2(own) - room - 0.3, dvec2(own) + room + 1.3};
    add_enlarged(view, PictureView(enlarged_place, part, rows_down()), fate, own);
  }

  /// A place outside and the pixel that it is moved into, enlarged where they are near each other.
  void add_move(View& view, const Fate& fate) const {
    constexpr double farthest = 12;
    const dvec2 lower(*fate.pixel), size(subject_.map.picture);
    Extent part{lower, lower + 1.0};
    part.add(*fate.place);
    if (std::max(part.size().x, part.size().y) > farthest) return;
    const PictureView enlarged(enlarged_place, {part.lower - 0.3, part.upper + 0.3}, rows_down());
    const Extent& shown = enlarged.pixels();
    add_grid_lines(view, enlarged, "enlarged",
                   {glm::max(shown.lower, dvec2{0, 0}), glm::min(shown.upper, size)});
    const Path box = enlarged.box(lower, lower + 1.0);
    view.add({"aside enlarged pixel", Role::rejected, gradus::Area{{box.points}}});
    view.add({"aside enlarged pixel outline", Role::rejected, box});
    const dvec2 at = enlarged.at(*fate.place);
    view.add(
        {"aside enlarged move", Role::rejected, Stroke{at, enlarged.at(centre(*fate.pixel)), true, true}});
    view.add({"aside enlarged place", Role::current, Dot{at}});
    add_rule(view, enlarged, "caption.nearest", fate, *fate.pixel);
  }
  /// Above an enlarged part: what each coordinate becomes.
  void add_rule(View& view, const PictureView& enlarged, std::string_view rule, const Fate& fate,
                ivec2 pixel) const {
    add_caption(view, "enlarged",
                words_.say(rule, {{"px", pixels_text(fate.place->x)},
                                  {"py", pixels_text(fate.place->y)},
                                  {"column", pixel.x},
                                  {"row", pixel.y}}),
                enlarged.drawn());
  }
  void add_enlarged(View& view, const PictureView& enlarged, const Fate& fate, ivec2 own) const {
    const dvec2 size(subject_.map.picture), place = *fate.place;
    const Extent& part = enlarged.pixels();
    add_grid_lines(view, enlarged, "enlarged",
                   {glm::max(part.lower, dvec2{0, 0}), glm::min(part.upper, size)});
    if (fate.pixel && !fate.moved()) {
      const Path box = enlarged.box(dvec2(*fate.pixel), dvec2(*fate.pixel) + 1.0);
      if (part.holds(centre(*fate.pixel))) {
        view.add({"aside enlarged pixel", Role::accepted, gradus::Area{{box.points}}});
        view.add({"aside enlarged pixel outline", Role::accepted, box});
      }
    }
    const dvec2 at = enlarged.at(place), corner(own);
    add_measure(view, "aside enlarged across", enlarged.at({corner.x, place.y}), at, place.x - corner.x);
    add_measure(view, "aside enlarged down", enlarged.at({place.x, corner.y}), at, place.y - corner.y);
    if (fate.nearest && subject_.rounding != Rounding::floor && part.holds(dvec2(*fate.nearest)))
      view.add({"aside rounding", Role::accepted, Stroke{at, enlarged.at(dvec2(*fate.nearest)), true}});
    view.add({"aside enlarged place", Role::current, Dot{at}});
    if (!fate.nearest) return;
    const std::string_view rule = subject_.rounding == Rounding::floor ? "caption.floor" : "caption.nearest";
    add_rule(view, enlarged, rule, fate, *fate.nearest);
  }

  /// The line through the points as it is (dashed), and as it comes out between moved pixels.
  void add_lines(View& view, const std::vector<Fate>& fates) const {
    for (std::size_t i = 1; i < fates.size(); ++i) {
      if (!fates[i - 1].pixel || !fates[i].pixel) continue;
      const Spot from_here = picture_spot(*fates[i - 1].place);
      const dvec2 a = from_here.at;
      const dvec2 way = picture_.at(*fates[i].place) - a;
      // Only as far as the panel shows it
      const double most = span_in(picture_.place(), a, way, 0, 1).second;
      const std::string names = letter(i - 1) + letter(i);
      if (from_here.here() && most > 0) {
        view.add({"line " + names, Role::candidate, Stroke{a, a + most * way}});
      }
      const dvec2 from = picture_.at(centre(*fates[i - 1].pixel)), to = picture_.at(centre(*fates[i].pixel));
      view.add({"drawn " + names, Role::rejected, Stroke{from, to}});
    }
  }

  const Subject& subject_;
  const Words& words_;
  dvec2 near_;  ///< points no farther outside have room, in parts of window and picture; others are arrows
  Places places_;
  Panel plane_;
  PictureView picture_;
  bool fine_;  ///< the picture's pixels are too small to be seen
};

}  // namespace gradus::viewport
