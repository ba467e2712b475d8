#pragma once
// From a depth image to points and back: each pixel's ray through the picture, as far as its depth.

#include "stories/modeling/point_cloud/subject.hpp"
#include "stories/past.hpp"

namespace gradus::point_cloud {

using Seen = BackProjected<double>;

/// Numbers of one row each: so many columns.
constexpr int columns = 6;

struct DepthImage {
  Raster<double> depth;
  Pinhole<double> camera;
};

inline DepthImage depth_image_of(const Arguments& arguments) {
  const std::vector<Tuple> rows = arguments.tuples("depths");
  Raster<double> depth(columns, static_cast<int>(rows.size()));
  for (int j = 0; j < depth.height(); ++j) {
    for (int i = 0; i < columns; ++i) {
      const double z = rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)].value;
      if (z < 0) refuse("depths", "expected depths above 0, or 0 for none, found {}", z);
      depth[{i, j}] = z;
    }
  }
  const double focal = *arguments.number("focal");
  if (!(focal > 0)) refuse("focal", "expected a focal length above 0, found {}", focal);
  return {std::move(depth), {focal, {0.5 * columns, 0.5 * static_cast<double>(rows.size())}}};
}

class DepthStory : public Past<steps::Started, Seen, Hole, Finished> {
 public:
  DepthStory(const Words& words, const DepthImage& image, const faces_subject::Reader& reader)
      : words_(words),
        image_(image),
        reader_(reader),
        points_(back_project(image.depth, image.camera)),
        panel_(space, {}) {
    Extent extent;
    extent.add(flat({0, 0, 0}));
    for (const dvec3 p : points_) extent.add(flat(p));
    for (const int i : {0, columns}) {
      for (const int j : {0, image.depth.height()}) extent.add(flat(in_picture({i, j})));
    }
    panel_ = Panel(space, extent);
  }

  const Panel& panel() const { return panel_; }

  double tells(const auto& step) const {
    // What lies near, and to one side
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Seen>)
      return 1 / step.place.z + 0.03 * step.pixel.x + 0.001 * step.pixel.y;
    return 0;
  }

  Event say(const steps::Started&) const {
    return {.text = "depth.started",
            .words = {{"columns", columns}, {"rows", image_.depth.height()}, {"focal", image_.camera.focal}}};
  }
  Event say(const Seen& s) const {
    const auto& [focal, centre] = image_.camera;
    const dvec2 off{s.pixel.x + 0.5 - centre.x, centre.y - s.pixel.y - 0.5};
    const ivec2 again = project(image_.camera, s.place);
    return {.text = "depth.seen",
            .facts = {{"pixel", s.pixel}, {"x", s.place.x}, {"y", s.place.y}, {"z", s.place.z}},
            .words = {{"across", figure_real(off.x)},
                      {"up", figure_real(off.y)},
                      {"focal", focal},
                      {"x", short_real(s.place.x)},
                      {"y", short_real(s.place.y)},
                      {"z", s.place.z},
                      {"again", again}},
            .row = {s.pixel, s.place.z, short_real(s.place.x), short_real(s.place.y), again},
            .key = pixel_key(s.pixel),
            .decides = yes_or_no(words_, "question.depth", {{"pixel", s.pixel}}, true, "point", "hole")};
  }
  Event say(const Hole& h) const {
    return {.text = "depth.hole",
            .facts = {{"pixel", h.pixel}},
            .row = {h.pixel, 0},
            .key = pixel_key(h.pixel),
            .decides = yes_or_no(words_, "question.depth", {{"pixel", h.pixel}}, false, "point", "hole")};
  }
  Event say(const Finished& f) const {
    return {.text = "depth.finished",
            .facts = {{"points", static_cast<std::int64_t>(f.points)}},
            .words = {{"pixels", image_.depth.cells().size()}, {"holes", all<Hole>().size()}},
            .count = static_cast<std::int64_t>(f.points)};
  }

  View draw() const {
    View view;
    add_image(view);
    add_camera(view);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const bool done = i < all<Seen>().size();
      const Role role = now<Finished>() ? Role::result : done ? Role::past : Role::guide;
      view.add({fmt::format("p {:03}", i), role, Dot{at(points_[i]), !done}});
    }
    if (const auto* s = now<Seen>()) {
      const dvec3 crossing = in_picture(dvec2(s->pixel) + 0.5);
      view.add({"r far", Role::measure, Stroke{at(dvec3{0}), at(s->place)}});
      view.add({"s through", Role::measure, Dot{at(crossing)}});
      view.add_named("t point", Role::current, at(s->place), "P");
      add_numbers(view, *s);
    }
    return view;
  }

 private:
  static constexpr Extent space{{16.8, 1.2}, {38.4, 25}};
  static constexpr double cell = 2.15;
  static constexpr dvec2 corner{0.5, 20.4};  ///< of the depth image, its upper left one

  /// The camera's z is forward: the reader has it away from him.
  dvec2 flat(dvec3 p) const { return reader_.flat({p.x, p.y, -p.z}); }
  dvec2 at(dvec3 p) const { return panel_.at(flat(p)); }
  /// Of the picture in front of the eye, in pixels.
  dvec3 in_picture(dvec2 p) const {
    const auto& [focal, centre] = image_.camera;
    return {p.x - centre.x, centre.y - p.y, focal};
  }
  Role role_of(ivec2 pixel) const {
    if (now<Seen>() && now<Seen>()->pixel == pixel) return Role::current;
    if (now<Hole>() && now<Hole>()->pixel == pixel) return Role::rejected;
    const std::size_t number = static_cast<std::size_t>(pixel.y * columns + pixel.x);
    const bool done = number < all<Seen>().size() + all<Hole>().size();
    return !done ? Role::input : image_.depth[pixel] == 0 ? Role::rejected : Role::past;
  }
  /// The depths as squares with numbers.
  void add_image(View& view) const {
    const Raster<double>& depth = image_.depth;
    view.add({"a heading", Role::guide,
              Text{corner + dvec2{0.5 * columns * cell, 2.9}, words_.say("depth.image"), Align::centre}});
    for (int i = 0; i < columns; ++i)
      view.add({fmt::format("a column {}", i), Role::guide,
                Text{corner + dvec2{(i + 0.5) * cell, 0.9}, fmt::format("{}", i), Align::centre, true}});
    for (int j = 0; j < depth.height(); ++j) {
      view.add({fmt::format("a row {}", j), Role::guide,
                Text{corner + dvec2{columns * cell + 0.6, -(j + 0.5) * cell}, fmt::format("{}", j),
                     Align::centre, true}});
      for (int i = 0; i < columns; ++i) {
        const std::string id = fmt::format("b {} {}", j, i);
        const dvec2 lower = corner + cell * dvec2{i, -j - 1};
        const std::vector<dvec2> ring = Extent{lower, lower + cell}.corners();
        const Role role = role_of({i, j});
        const bool here = role == Role::current || (now<Hole>() && now<Hole>()->pixel == ivec2{i, j});
        if (here) view.add({id + " inside", role, Area{{ring}, 1}});
        view.add({id, here ? role : Role::boundary, Path{ring, true}});
        view.add(
            {id + " z", role, Text{lower + 0.5 * cell, figure_real(depth[{i, j}]), Align::centre, true}});
      }
    }
  }
  /// There and back, below the image.
  void add_numbers(View& view, const Seen& s) const {
    const auto& [focal, centre] = image_.camera;
    const dvec2 off{s.pixel.x + 0.5 - centre.x, centre.y - s.pixel.y - 0.5};
    const auto add = [&](int line, Role role, std::string text) {
      view.add({fmt::format("y {}", line), role,
                Text{{corner.x, 8 - 1.9 * line}, std::move(text), Align::left, true}});
    };
    const std::string z = figure_real(s.place.z), f = figure_real(focal);
    for (const int axis : {0, 1}) {
      const std::string name(1, "xy"[axis]), its = short_real(s.place[axis]);
      add(axis, Role::current,
          fmt::format("{} = {} · {} / {} = {}", name, figure_real(off[axis]), z, f, its));
      add(2 + axis, Role::measure,
          fmt::format("{} + ½ = {} {} {} · {} / {} = {}", "ij"[axis], figure_real(centre[axis]),
                      axis == 0 ? "+" : "−", f, figure_factor(its), z, figure_real(s.pixel[axis] + 0.5)));
    }
  }
  /// The eye, and its picture as a window with a pane for each pixel.
  void add_camera(View& view) const {
    const int rows = image_.depth.height();
    for (int i = 0; i <= columns; ++i)
      view.add({fmt::format("c column {}", i), Role::boundary,
                Stroke{at(in_picture({i, 0})), at(in_picture({i, rows})), false, false, true}});
    for (int j = 0; j <= rows; ++j)
      view.add({fmt::format("c row {}", j), Role::boundary,
                Stroke{at(in_picture({0, j})), at(in_picture({columns, j})), false, false, true}});
    for (const int i : {0, columns}) {
      for (const int j : {0, rows})
        view.add({fmt::format("d side {} {}", i, j), Role::boundary,
                  Stroke{at(dvec3{0}), at(in_picture({i, j})), false, false, true}});
    }
    if (const auto* s = now<Seen>()) {
      std::vector<dvec2> ring;
      for (const ivec2 off : {ivec2{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        ring.push_back(at(in_picture(dvec2(s->pixel + off))));
      view.add({"e pixel inside", Role::current, Area{{ring}, 1}});
      view.add({"e pixel", Role::current, Path{ring, true}});
    }
    view.add_named("z eye", Role::measure, at(dvec3{0}), words_.say("eye"));
  }

  const Words& words_;
  const DepthImage& image_;
  const faces_subject::Reader& reader_;
  const std::vector<dvec3> points_;
  Panel panel_;
};

}  // namespace gradus::point_cloud
