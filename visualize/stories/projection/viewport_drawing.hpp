#pragma once
// The drawing of a window's way into a picture: the camera plane to the left, the picture with its pixels to
// the right.

#include "projection/viewport/viewport.hpp"
#include "stories/telling.hpp"

namespace gradus::viewport {

struct Input {
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

class Drawing {
 public:
  Drawing(const Input& input, const Words& words)
      : input_(input),
        words_(words),
        plane_(plane_place, plane_extent(input)),
        picture_(picture_place, picture_extent(input)) {}

  /// current: the point of this step; points.size(): none. done: all pixels are results.
  View view(const std::vector<Fate>& fates, std::size_t current, bool done, bool clamped) const {
    View view;
    add_plane(view, fates, current);
    if (current < fates.size()) add_measures(view, input_.points[current], fates[current]);
    add_grid(view);
    if (clamped) add_lines(view, fates);
    for (std::size_t i = 0; i < fates.size(); ++i) {
      if (fates[i].pixel) add_pixel(view, fates[i], letter(i), i == current, done);
      if (fates[i].place) add_place(view, fates[i], letter(i), i == current);
    }
    return view;
  }
  const Panel& plane() const { return plane_; }

 private:
  /// Two panels on a paper of 36 x 27: the camera plane, and the picture; of that, what isn't too near its
  /// border.
  static constexpr Extent plane_place{{3.2, 6}, {17, 19.8}}, picture_place{{20.2, 6}, {35.3, 19.8}};
  static constexpr Extent inner_picture{{20.2 + 0.3, 6 + 0.3}, {35.3 - 0.3, 19.8 - 0.3}};
  /// Up to so many lines the whole grid of pixels is drawn.
  static constexpr int most_lines = 40;

  static Extent plane_extent(const Input& input) {
    const auto& [lower, upper] = input.map.window;
    const dvec2 margin = (upper - lower) * 0.2;
    return {lower - margin, upper + margin};
  }
  static Extent picture_extent(const Input& input) {
    const dvec2 size(input.map.picture);
    const double margin = 0.18 * std::max(size.x, size.y);
    const dvec2 lower{-margin, input.map.row_zero == RowZero::top ? -size.y - margin : -margin};
    return {lower, lower + size + 2 * margin};
  }
  bool rows_down() const { return input_.map.row_zero == RowZero::top; }
  /// A place of the picture on the paper: rows are counted down where row 0 is at the top.
  dvec2 on_paper(dvec2 place) const { return picture_.at({place.x, rows_down() ? -place.y : place.y}); }
  Path box_on_paper(dvec2 lower, dvec2 upper) const {
    return {{on_paper(lower), on_paper({upper.x, lower.y}), on_paper(upper), on_paper({lower.x, upper.y})},
            true};
  }
  /// Whether the panel shows this place, and where; of others the nearest place that it shows.
  std::pair<bool, dvec2> shown_at(dvec2 place) const {
    const dvec2 at = on_paper(place);
    return {inner_picture.holds(at), glm::clamp(at, inner_picture.lower, inner_picture.upper)};
  }

  void add_caption(View& view, std::string_view id, std::string text, const Extent& place) const {
    view.add({fmt::format("caption {}", id), Role::guide, Text{{place.centre().x, 23}, std::move(text)}});
  }
  /// A dot, or where the panel doesn't reach as far an arrow to its border.
  static void add_point(View& view, std::string id, Role role, const Extent& panel, bool inside, dvec2 at) {
    if (inside) return view.add({std::move(id), role, Dot{at}});
    const dvec2 inwards = glm::normalize(panel.centre() - at);
    view.add({std::move(id), role, Stroke{at + 1.6 * inwards, at, true}});
  }

  void add_plane(View& view, const std::vector<Fate>& fates, std::size_t current) const {
    add_caption(view, "plane", words_.say("caption.plane"), plane_place);
    add_axes(view, plane_, "plane", {words_.symbol("x"), words_.symbol("y")}, 4);
    const auto& [lower, upper] = input_.map.window;
    view.add({"window", Role::boundary, Path{plane_.at(Extent{lower, upper}.corners()), true}});
    const Extent shown = plane_.shown();
    for (std::size_t i = 0; i < input_.points.size(); ++i) {
      const dvec2 p = input_.points[i];
      const bool here = shown.holds(p);
      const dvec2 at = plane_.at(here ? p : glm::clamp(p, shown.lower, shown.upper));
      const Role role = i == current ? Role::current : fates[i].outside ? Role::rejected : Role::input;
      add_point(view, "point " + letter(i), role, plane_place, here, at);
      view.add({"point name " + letter(i), role, Label{at, letter(i)}});
    }
  }

  /// How far across the window the point at hand is, until it has its place.
  void add_measures(View& view, dvec2 p, const Fate& fate) const {
    if (!fate.fraction || fate.place) return;
    const dvec2 fraction = *fate.fraction;
    if (!(std::abs(fraction.x) < 3 && std::abs(fraction.y) < 3)) return;
    const auto& [lower, upper] = input_.map.window;
    const auto measure = [&](std::string id, dvec2 from, double value) {
      view.add({id, Role::measure, Stroke{plane_.at(from), plane_.at(p)}});
      view.add({id + " name", Role::measure, Label{plane_.at((from + p) * 0.5), figure_real(value)}});
    };
    measure("across", {lower.x, p.y}, fraction.x);
    measure("down", {p.x, rows_down() ? upper.y : lower.y}, fraction.y);
  }

  void add_grid(View& view) const {
    const std::string rows = rows_down() ? "rows_down" : "rows_up";
    add_caption(view, rows, words_.say("caption." + rows), picture_place);
    add_grid_lines(view, 0, "column");
    add_grid_lines(view, 1, "row");
    view.add({"picture", Role::boundary, box_on_paper({0, 0}, dvec2(input_.map.picture))});
    if (!input_.boxed) return;
    const auto& [lower, upper] = input_.map.viewport;
    Path viewport = box_on_paper(lower, upper);
    viewport.dashed = true;
    view.add({"viewport", Role::boundary, std::move(viewport)});
  }
  void add_grid_lines(View& view, int axis, std::string_view name) const {
    const ivec2 size = input_.map.picture;
    const int count = size[axis];
    const int step = count <= most_lines ? 1 : std::max(1, static_cast<int>(tick_distance(count, 8)));
    const int labels = std::max(step, static_cast<int>(std::ceil(tick_distance(count, 8))));
    const dvec2 beside = axis == 1 ? dvec2{-0.7, 0} : dvec2{0, rows_down() ? 1.1 : -1.2};
    for (int i = 0; i <= count; i += step) {
      dvec2 a{0, 0}, b(size);
      a[axis] = b[axis] = i;
      view.add({fmt::format("grid {} {:05}", name, i), Role::guide, Stroke{on_paper(a), on_paper(b)}});
      if (i % labels != 0) continue;
      view.add({fmt::format("grid value {} {:05}", name, i), Role::guide,
                Text{on_paper(a) + beside, figure_real(i), axis == 1 ? Align::right : Align::centre}});
    }
  }

  void add_pixel(View& view, const Fate& fate, const std::string& name, bool current, bool done) const {
    const Role role = fate.moved() ? Role::rejected
                      : done       ? Role::result
                      : current    ? Role::accepted
                                   : Role::past;
    const dvec2 corner(*fate.pixel), middle = on_paper(centre(*fate.pixel));
    const Path box = box_on_paper(corner, corner + 1.0);
    view.add({"pixel " + name, role, gradus::Area{{box.points}}});
    view.add({"pixel " + name + " outline", role, box});
    if (current || done) view.add({"pixel name " + name, role, Label{middle, name}});
    if (!fate.moved() || !current) return;
    const dvec2 from = shown_at(dvec2(*fate.nearest)).second;
    view.add({"moved " + name, Role::rejected, Stroke{from, middle, true, true}});
  }

  void add_place(View& view, const Fate& fate, const std::string& name, bool current) const {
    const auto [inside, at] = shown_at(*fate.place);
    const Role role = fate.outside ? Role::rejected : current ? Role::current : Role::input;
    add_point(view, "place " + name, role, picture_place, inside, at);
    if (current && fate.pixel && input_.rounding != Rounding::floor && inside) {
      const auto [there, corner] = shown_at(dvec2(*fate.nearest));
      if (there) view.add({"rounding " + name, Role::measure, Stroke{at, corner, true}});
    }
    if (fate.outside || !fate.pixel) view.add({"place name " + name, role, Label{at, name}});
  }

  /// The line through the points as it is (dashed), and as it comes out between moved pixels.
  void add_lines(View& view, const std::vector<Fate>& fates) const {
    for (std::size_t i = 1; i < fates.size(); ++i) {
      if (!fates[i - 1].pixel || !fates[i].pixel) continue;
      const auto [in, a] = shown_at(*fates[i - 1].place);
      const dvec2 way = on_paper(*fates[i].place) - a;
      // Only as far as the panel shows it
      const double most = span_in(inner_picture, a, way, 0, 1).second;
      const std::string names = letter(i - 1) + letter(i);
      if (in && most > 0) {
        view.add({"line " + names, Role::measure, Stroke{a, a + most * way, false, true}});
      }
      const dvec2 from = on_paper(centre(*fates[i - 1].pixel)), to = on_paper(centre(*fates[i].pixel));
      view.add({"drawn " + names, Role::rejected, Stroke{from, to}});
    }
  }

  const Input& input_;
  const Words& words_;
  Panel plane_, picture_;
};

}  // namespace gradus::viewport
