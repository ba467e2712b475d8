// The story of perspective: a solid's picture and its vanishing points, the transformation that keeps depth
// and the one that bends it, what may be divided and what becomes of the rest, and how finely depth is
// stored.

#include "projection/perspective/perspective.hpp"

#include "projection/perspective/perspective_notes.hpp"
#include "stories/projection/solids.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::perspective {
namespace {

using fmt::arg;
using solids::place_text;
using solids::real;
using solids::short_real;
using solids::vector_of;

constexpr std::string_view folder = "algorithms/projection/perspective/";

/// What all tellers of this topic do: each step is a whole view.
class ViewTeller {
 public:
  explicit ViewTeller(TraceWriter& writer) : writer_(writer), words_(writer.wording()) {}

 protected:
  template <class Describe>
  void show(View seen, int line, Describe describe) {
    writer_.step(shown_.change_to(std::move(seen)), {}, line, describe);
  }
  template <class Describe>
  void fine(View seen, int line, Describe describe) {
    writer_.fine(shown_.change_to(std::move(seen)), {}, line, describe);
  }

  TraceWriter& writer_;
  const Wording& words_;

 private:
  Shown shown_;
};

double distance_of(const Arguments& arguments) {
  const double d = *arguments.number("distance");
  if (!(d > 0)) refuse(arguments, {"distance"}, fmt::format("expected a distance above 0, not {}", d));
  return d;
}

std::array<dvec3, 3> axes_of(const Arguments& arguments) {
  const std::vector<double> turn = arguments.numbers("turn");
  return solids::turned_axes(turn[0], turn[1]);
}

solids::Solid solid_of(const Arguments& arguments) {
  const solids::Solid solid = arguments.text("solid") == "house" ? solids::house() : solids::box();
  return solids::placed(solid, axes_of(arguments), vector_of(arguments, "at"));
}

solids::Scenery::Images images_of(const solids::Solid& solid, double d) {
  solids::Scenery::Images images;
  for (const dvec3 p : solid.corners) images.push_back(project(d, p));
  return images;
}

// --- The projection to a plane -----------------------------------

class ProjectionTeller : public ViewTeller {
 public:
  ProjectionTeller(TraceWriter& writer, const Arguments& arguments)
      : ViewTeller(writer),
        d_(distance_of(arguments)),
        scenery_(words_, solid_of(arguments), {{0, 0, d_}, {1, 0, 0}, {0, 1, 0}},
                 solids::hidden_from_origin(solid_of(arguments)), dvec3{0},
                 images_of(solid_of(arguments), d_)),
        images_(scenery_.solid().corners.size()) {
    writer.trace().columns = {{"corner"}, {"point", false}, {"factor"}, {"image", false}};
  }

  void tell() {
    show(view(), 0, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.level = Level::idea;
      step.sentence = words_.say("perspective.started.projection", arg("d", real(d_)));
    });
    for (corner_ = 0; corner_ < images_.size(); ++corner_)
      project(d_, scenery_.solid().corners[corner_], *this);
    View seen = scenery_.empty();
    scenery_.add_images(seen, images_, Role::result);
    show(std::move(seen), 0, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = unseen_ == 0 ? words_.say("perspective.done.projection")
                                   : words_.count("perspective.done.unseen", unseen_);
    });
    writer_.trace().result = {{"images", static_cast<std::int64_t>(images_.size()) - unseen_}};
  }

  void operator()(const Scaled<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    factor_ = s.factor;
    View seen = view();
    scenery_.point_at(seen, corner_, {});
    fine(std::move(seen), line, [&](TraceStep& step) {
      describe(step, "Scaled");
      step.fields.push_back({"factor", s.factor});
      step.sentence =
          words_.say("perspective.scaled", arg("corner", number()), arg("z", figure_real(s.point.z)),
                     arg("d", real(d_)), arg("factor", real(s.factor)));
    });
  }
  void operator()(const Projected<double>& p, int line = __builtin_LINE(), const char* = nullptr) {
    images_[corner_] = p.image;
    View seen = view();
    scenery_.point_at(seen, corner_, p.image);
    show(std::move(seen), line, [&](TraceStep& step) {
      describe(step, "Projected");
      step.fields.insert(step.fields.end(), {{"x", p.image.x}, {"y", p.image.y}, {"z", p.image.z}});
      step.sentence =
          words_.say("perspective.projected", arg("x", real(p.point.x)), arg("y", real(p.point.y)),
                     arg("factor", real(factor_)), arg("image_x", real(p.image.x)),
                     arg("image_y", real(p.image.y)), arg("corner", number()));
      step.row = {figure_number(number()), place_text(p.point), real(factor_), place_text(p.image)};
    });
  }
  void operator()(const Unseen<double>& u, int line = __builtin_LINE(), const char* = nullptr) {
    ++unseen_;
    View seen = view();
    scenery_.point_at(seen, corner_, {});
    show(std::move(seen), line, [&](TraceStep& step) {
      describe(step, "Unseen");
      step.sentence = words_.say("perspective.unseen", arg("corner", number()), arg("z", real(u.point.z)));
      step.row = {figure_number(number()), place_text(u.point), "", words_.say("perspective.no_image")};
    });
  }

 private:
  std::int64_t number() const { return static_cast<std::int64_t>(corner_) + 1; }
  void describe(TraceStep& step, std::string type) const {
    step.type = std::move(type);
    step.phase = words_.say("words.main_loop");
    step.key = fmt::format("{}", corner_);
    step.fields = {{"corner", number()}};
  }
  View view() const {
    View seen = scenery_.empty();
    scenery_.add_images(seen, images_, Role::past);
    return seen;
  }

  double d_;
  solids::Scenery scenery_;
  solids::Scenery::Images images_;
  std::size_t corner_ = 0;
  std::int64_t unseen_ = 0;
  double factor_ = 0;
};

// --- Vanishing points --------------------------------------------

/// The part of the ray from a towards b that lies in a rectangle that holds a.
dvec2 last_inside(const Extent& box, dvec2 a, dvec2 way) {
  double t = 1e300;
  for (const int i : {0, 1}) {
    if (way[i] > 0) t = std::min(t, (box.upper[i] - a[i]) / way[i]);
    if (way[i] < 0) t = std::min(t, (box.lower[i] - a[i]) / way[i]);
  }
  return a + std::max(0.0, t) * way;
}

class VanishingTeller : public ViewTeller {
 public:
  VanishingTeller(TraceWriter& writer, const Arguments& arguments, bool by_plane)
      : ViewTeller(writer),
        by_plane_(by_plane),
        d_(distance_of(arguments)),
        solid_(solids::placed(solids::box(), axes_of(arguments), vector_of(arguments, "at"))),
        hidden_(solids::hidden_from_origin(solid_)) {
    const std::array<dvec3, 3> axes = axes_of(arguments);
    directions_.assign(axes.begin(), axes.end());
    own_ = vector_of(arguments, "direction");
    if (own_ != dvec3{0}) directions_.push_back(own_.x * axes[0] + own_.y * axes[1] + own_.z * axes[2]);
    points_.resize(directions_.size());
    for (const dvec3 p : solid_.corners) {
      const std::optional<dvec3> image = project(d_, p);
      if (!image) refuse(arguments, {"at", "turn"}, "expected a place where the whole box is before the eye");
      images_.emplace_back(image->x, image->y);
    }
    Extent shown;
    for (const dvec2 p : images_) shown.add(p);
    const double reach = 6 * std::max(shown.size().x, shown.size().y);
    const dvec2 middle = shown.centre();
    for (const dvec3 direction : directions_) {
      const std::optional<dvec2> point = vanishing_point(matrix_onto(d_), direction);
      if (point && glm::distance(*point, middle) <= reach) shown.add(*point);
    }
    panel_ = Panel({{1.5, 2}, {34.5, 25}}, widened(shown, 0.08));
    writer.trace().columns = {{"axis", false}, {"direction", false}, {"w"}, {"vanishing_point", false}};
  }

  void tell() {
    show(box(Role::input), 0, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.level = Level::idea;
      step.sentence = words_.say(
          by_plane_ ? "perspective.started.parallel_by_plane" : "perspective.started.vanishing_points",
          arg("d", real(d_)));
    });
    const glm::dmat4 matrix = matrix_onto(d_);
    for (axis_ = 0; axis_ < directions_.size(); ++axis_) {
      if (by_plane_) {
        parallel_by_plane(matrix, directions_[axis_], *this);
      } else {
        vanishing_point(matrix, directions_[axis_], *this);
      }
    }
    View seen = box(Role::result);
    for (axis_ = 0; axis_ < directions_.size(); ++axis_) {
      add_lines(seen, Role::past);
      if (missed()) add_edges(seen, Role::rejected);
    }
    const std::int64_t count = std::ranges::count_if(points_.begin(), points_.begin() + 3,
                                                     [](const auto& point) { return point.has_value(); });
    show(std::move(seen), 0, [&](TraceStep& step) {
      constexpr std::string_view keys[] = {"perspective.done.points.none", "perspective.done.points.one",
                                           "perspective.done.points.two", "perspective.done.points.three"};
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = by_plane_ ? missed_text() : words_.say(keys[count]);
    });
    writer_.trace().result = {{"vanishing_points", count}};
    if (own_ == dvec3{0}) return;
    writer_.trace().result.push_back({"direction_vanishes", points_[3].has_value()});
  }

  void operator()(const TakenToInfinity<double>& t, int line = __builtin_LINE(), const char* = nullptr) {
    taken_ = t;
    View seen = before();
    add_edges(seen, Role::current);
    fine(std::move(seen), listed(line), [&](TraceStep& step) {
      describe(step, "TakenToInfinity");
      step.fields.push_back({"w", t.image.w});
      step.sentence = words_.say("perspective.taken_to_infinity", arg("axis", name()),
                                 arg("direction", place_text(t.direction)), arg("w", real(t.image.w)));
    });
  }
  void operator()(const Vanished<double>& v, int line = __builtin_LINE(), const char* = nullptr) {
    points_[axis_] = v.point;
    View seen = before();
    add_lines(seen, Role::current);
    add_edges(seen, Role::current);
    show(std::move(seen), listed(line), [&](TraceStep& step) {
      describe(step, "Vanished");
      step.fields.insert(step.fields.end(), {{"x", v.point.x}, {"y", v.point.y}});
      step.sentence = words_.say("perspective.vanished", arg("axis", name()),
                                 arg("w", figure_real(taken_.image.w)), arg("point", place_text(v.point)));
      step.row = {name(), place_text(v.direction), figure_real(taken_.image.w), place_text(v.point)};
    });
  }
  void operator()(const StaysParallel<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    const bool unasked = by_plane_ && taken_.direction != s.direction;
    View seen = before();
    add_edges(seen, missed() ? Role::rejected : Role::current);
    show(std::move(seen), unasked ? line : listed(line), [&](TraceStep& step) {
      describe(step, "StaysParallel");
      step.sentence = words_.say(missed()  ? "perspective.said_to_stay"
                                 : unasked ? "perspective.stays_by_rule"
                                           : "perspective.stays_parallel",
                                 arg("axis", name()), arg("direction", place_text(s.direction)),
                                 arg("point", missed() ? place_text(*missed()) : std::string()));
      step.row = {name(), place_text(s.direction), unasked ? "" : figure_real(taken_.image.w),
                  words_.say("perspective.none")};
    });
  }

 private:
  static constexpr std::string_view names[] = {"x", "y", "z"};
  /// The rule's listing ends with its call of vanishing_point, of which it lists no more.
  int listed(int line) const { return by_plane_ ? writer_.trace().listing.back().number : line; }
  std::string name() const { return axis_ < 3 ? words_.symbol(names[axis_]) : place_text(own_); }
  void describe(TraceStep& step, std::string type) const {
    const std::string axis(axis_ < 3 ? names[axis_] : "direction");
    step.type = std::move(type);
    step.phase = words_.say("words.main_loop");
    step.key = axis;
    step.fields = {{"axis", axis}};
  }
  /// Where the lines of this direction vanish although the rule has them stay parallel.
  std::optional<dvec2> missed() const {
    return points_[axis_] ? std::nullopt : vanishing_point(matrix_onto(d_), directions_[axis_]);
  }
  std::string missed_text() const {
    std::string list;
    VanishingTeller every = *this;
    for (every.axis_ = 0; every.axis_ < directions_.size(); ++every.axis_) {
      if (every.missed()) list += (list.empty() ? "" : ", ") + every.name();
    }
    return list.empty() ? words_.say("perspective.done.rule_holds")
                        : words_.say("perspective.done.parallel_by_plane", arg("axes", list));
  }

  /// Corners 0 1 2 3 and 4 5 6 7 go round; 1 - 0 runs along x, 3 - 0 along y, 4 - 0 along z.
  static bool runs_along(const solids::Edge& edge, std::size_t axis) {
    const std::size_t a = edge.a, b = edge.b;
    if (axis == 2) return b == a + 4;
    if (b == a + 4) return false;
    const bool level = (a % 4 == 0 && b % 4 == 1) || (a % 4 == 2 && b % 4 == 3);
    return (axis == 0) == level;
  }

  View box(Role role) const {
    View seen;
    const Extent shown = panel_.shown();
    if (shown.lower.y < 0 && shown.upper.y > 0) {
      seen.add(
          {"a eye level", Role::guide, Stroke{panel_.at({shown.lower.x, 0}), panel_.at({shown.upper.x, 0})}});
      seen.add({"z eye level name", Role::guide,
                Label{panel_.at({shown.lower.x + 0.25 * shown.size().x, 0}),
                      words_.say("perspective.eye_level")}});
    }
    for (std::size_t i = 0; i < solid_.edges.size(); ++i) {
      const solids::Edge& edge = solid_.edges[i];
      seen.add({fmt::format("c edge {:02}", i), role,
                Stroke{panel_.at(images_[edge.a]), panel_.at(images_[edge.b]), false, hidden_[i]}});
    }
    return seen;
  }

  /// The box and the lines of the axes before this one.
  View before() const {
    View seen = box(Role::input);
    VanishingTeller earlier = *this;
    for (earlier.axis_ = 0; earlier.axis_ < axis_; ++earlier.axis_) earlier.add_lines(seen, Role::past);
    return seen;
  }

  /// The edges of this axis.
  void add_edges(View& seen, Role role) const {
    for (std::size_t i = 0; i < solid_.edges.size(); ++i) {
      const solids::Edge& edge = solid_.edges[i];
      if (axis_ == 3 || !runs_along(edge, axis_)) continue;
      seen.add({fmt::format("c edge {:02}", i), role,
                Stroke{panel_.at(images_[edge.a]), panel_.at(images_[edge.b]), false, hidden_[i]}});
    }
    if (axis_ != 3) return;
    for (const auto& [id, a, b] : lines_inside()) seen.add({id, role, Stroke{panel_.at(a), panel_.at(b)}});
  }

  /// Lines of the direction that is none of the box's: from each corner from where it leads into the box, to
  /// where it leaves it.
  std::vector<std::tuple<std::string, dvec2, dvec2>> lines_inside() const {
    std::vector<std::tuple<std::string, dvec2, dvec2>> lines;
    const std::vector<dvec3> own_corners = solids::box().corners;
    for (std::size_t k = 0; k < own_corners.size(); ++k) {
      const dvec3 p = own_corners[k];
      if (!glm::all(glm::lessThanEqual(own_ * p, dvec3{0}))) continue;
      double length = 1e300;
      for (int i = 0; i < 3; ++i) {
        if (own_[i] != 0) length = std::min(length, 2 * std::abs(p[i] / own_[i]));
      }
      const std::optional<dvec3> end = project(d_, solid_.corners[k] + length * directions_[3]);
      if (end) lines.emplace_back(fmt::format("d own {}", k), images_[k], dvec2(*end));
    }
    return lines;
  }

  /// They go on to the vanishing point, or to the border of the drawing on the way there.
  void add_lines(View& seen, Role role) const {
    const std::optional<dvec2> point = points_[axis_];
    if (!point) return;
    const Extent shown = panel_.shown();
    const bool inside = glm::all(glm::lessThanEqual(shown.lower, *point)) &&
                        glm::all(glm::lessThanEqual(*point, shown.upper));
    const auto add_line = [&](std::string id, dvec2 a, dvec2 b) {
      const dvec2 from = glm::distance(a, *point) < glm::distance(b, *point) ? a : b;
      const dvec2 to = inside ? *point : last_inside(shown, from, *point - from);
      seen.add({std::move(id), role == Role::current ? Role::current : Role::guide,
                Stroke{panel_.at(from), panel_.at(to), false, true}});
    };
    for (std::size_t i = 0; i < solid_.edges.size(); ++i) {
      const solids::Edge& edge = solid_.edges[i];
      if (axis_ == 3 || !runs_along(edge, axis_)) continue;
      add_line(fmt::format("b line {:02}", i), images_[edge.a], images_[edge.b]);
    }
    if (axis_ == 3) {
      for (const auto& [id, a, b] : lines_inside()) {
        add_line("b " + id, a, b);
        if (role != Role::current) seen.add({id, Role::past, Stroke{panel_.at(a), panel_.at(b)}});
      }
    }
    if (!inside) return;
    const std::string id = fmt::format("e point {}", axis_);
    seen.add({id, role == Role::current ? Role::current : Role::result, Dot{panel_.at(*point)}});
    seen.add({"f name " + id, role == Role::current ? Role::current : Role::result,
              Label{panel_.at(*point), words_.say("perspective.vanishing_point_of", arg("axis", name()))}});
  }

  bool by_plane_;
  double d_;
  std::vector<dvec3> directions_;  ///< the box's x, y, z, and the one given, in view space
  dvec3 own_{0};                   ///< the one given, along the box's axes; 0: none
  solids::Solid solid_;
  std::vector<bool> hidden_;
  std::vector<dvec2> images_;
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
  std::size_t axis_ = 0;
  TakenToInfinity<double> taken_{};
  std::vector<std::optional<dvec2>> points_;
};

// --- The transformation, right and bent --------------------------

/// A line from above, before and after the transformation; a wall stands behind its middle.
class BendTeller : public ViewTeller {
 public:
  BendTeller(TraceWriter& writer, const Arguments& arguments, bool bent)
      : ViewTeller(writer),
        bent_(bent),
        near_(distance_of(arguments)),
        far_(*arguments.number("far")),
        wall_(*arguments.number("wall")),
        from_(vector_of(arguments, "from")),
        to_(vector_of(arguments, "to")),
        samples_(arguments.integer("samples")) {
    if (!(far_ > near_)) {
      refuse(arguments, {"far", "distance"},
             fmt::format("expected a far plane beyond the distance {}, not at {}", near_, far_));
    }
    const auto between = [&](std::string_view name, double z) {
      if (near_ <= z && z <= far_) return;
      refuse(arguments, {name, "distance", "far"},
             fmt::format("expected a depth z of {} from the distance {} to the far plane {}, not {}", name,
                         near_, far_, z));
    };
    between("from", from_.z);
    between("to", to_.z);
    between("wall", wall_);
    a_ = image_of(from_);
    b_ = image_of(to_);
    if (std::abs(a_.x - b_.x) < 1e-6 * (std::abs(a_.x) + std::abs(b_.x))) {
      refuse(arguments, {"to", "from"}, "expected a line whose ends are seen at two different x");
    }
    Extent space, image;
    for (const dvec3 p : {from_, to_}) space.add({p.x, p.z});
    space.add({0, 0});
    space.add({0, std::min(far_, std::max({from_.z, to_.z, wall_}) * 1.1)});
    space_ = Panel({{4, 3}, {17, 22.5}}, widened(space, 0.06));
    const double least = std::min(a_.x, b_.x), most = std::max(a_.x, b_.x), margin = 0.12 * (most - least);
    image.add({least - margin, std::min({a_.z, b_.z, depth_of_wall()})});
    image.add({most + margin, std::max({a_.z, b_.z, depth_of_wall()})});
    image.lower.y -= 0.1 * image.size().y;
    image.upper.y += 0.1 * image.size().y;
    image_ = Panel({{22.5, 3}, {35, 22.5}}, image, Panel::Fit::stretched);
    require_scale(image_, arguments, {"from", "to", "wall", "distance", "far"});
    writer.trace().columns = {{"point", false}, {"x_image"}, {"z_image"}, {"interpolated"}, {"error"}};
  }

  void tell() {
    show(view(), 0, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.level = Level::idea;
      step.sentence = words_.say(bent_ ? "perspective.started.keep_z" : "perspective.started.transformation",
                                 arg("wall", real(wall_)), arg("near", real(near_)), arg("far", real(far_)));
    });
    for (int i = 0; i <= samples_ + 1; ++i) {
      // The ends first, for the straight line runs between them
      const int place = i == 0 ? 0 : i == 1 ? static_cast<int>(samples_) + 1 : i - 1;
      const double share = static_cast<double>(place) / static_cast<double>(samples_ + 1);
      point_ = place == 0 ? from_ : place > samples_ ? to_ : from_ + share * (to_ - from_);
      name_ = place == 0 ? "A" : place > samples_ ? "B" : fmt::format("M{}", place);
      watch();
    }
    finish();
  }

  void operator()(const Multiplied<double>& m, int line = __builtin_LINE(), const char* = nullptr) {
    fine(pointed({}), line, [&](TraceStep& step) {
      describe(step, "Multiplied");
      step.fields.insert(step.fields.end(), {{"clip_z", m.clip.z}, {"w", m.clip.w}});
      step.sentence = words_.say("perspective.multiplied", arg("name", name_), arg("x", real(m.clip.x)),
                                 arg("z", real(m.clip.z)), arg("w", figure_real(m.clip.w)));
    });
  }
  void operator()(const Divided<double>& d, int line = __builtin_LINE(), const char* = nullptr) {
    arrived(d.ndc, "Divided", line);
  }
  void operator()(const Scaled<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    fine(pointed({}), line, [&](TraceStep& step) {
      describe(step, "Scaled");
      step.fields.push_back({"factor", s.factor});
      step.sentence = words_.say("perspective.scaled_point", arg("name", name_), arg("d", real(near_)),
                                 arg("z", figure_real(s.point.z)), arg("factor", real(s.factor)));
    });
  }
  void operator()(const Projected<double>& p, int line = __builtin_LINE(), const char* = nullptr) {
    arrived(p.image, "Projected", line);
  }
  void operator()(const Unseen<double>&) {}  // every point is before the eye

 private:
  static dvec3 transformed(const Projection<double>& p, dvec3 point) { return divide(transform(p, point)); }
  Projection<double> projection() const { return projection_of(near_, near_, near_, far_); }
  dvec3 image_of(dvec3 point) const {
    return bent_ ? *keep_z(near_, point) : transformed(projection(), point);
  }
  void watch() {
    if (bent_) {
      keep_z(near_, point_, *this);
    } else {
      divide(transform(projection(), point_, *this), *this);
    }
  }
  /// Beside rounding, which depths of this line's size have.
  bool is_off(double error) const {
    return std::abs(error) > 1e-9 * std::max({std::abs(a_.z), std::abs(b_.z), 1e-3});
  }
  double depth_of_wall() const { return image_of({0, 0, wall_}).z; }
  dvec2 in_space(dvec3 p) const { return space_.at({p.x, p.z}); }
  dvec2 in_image(dvec3 p) const { return image_.at({p.x, p.z}); }
  /// What stands between A and B at this x: a scan line's depth.
  dvec3 interpolated(double x) const { return {x, 0, interpolated_depth(a_, b_, x)}; }

  void describe(TraceStep& step, std::string type) const {
    step.type = std::move(type);
    step.phase = words_.say("words.main_loop");
    step.key = name_;
    step.fields = {{"point", name_}};
  }

  View view() const {
    View seen;
    seen.add({"z caption space", Role::guide, Text{{10, 25.4}, words_.say("perspective.from_above")}});
    seen.add({"z caption image", Role::guide, Text{{28.5, 25.4}, words_.say("perspective.transformed")}});
    add_axes(seen, space_, "space", {words_.symbol("x"), words_.symbol("z")}, 5);
    const std::string x = words_.symbol("x′"), z = words_.symbol("z′");
    add_axes(seen, image_, "image", {x, z}, 5);
    const Extent space = space_.shown(), image = image_.shown();
    const auto level = [&](double depth) {
      return Stroke{space_.at({space.lower.x, depth}), space_.at({space.upper.x, depth})};
    };
    seen.add({"a plane", Role::guide, level(near_)});
    seen.add({"b wall", Role::boundary, level(wall_)});
    seen.add({"c line", Role::input, Stroke{in_space(from_), in_space(to_)}});
    const double wall = depth_of_wall();
    seen.add({"b wall image", Role::boundary,
              Stroke{image_.at({image.lower.x, wall}), image_.at({image.upper.x, wall})}});
    seen.add(
        {"f wall name", Role::boundary,
         Label{image_.at({image.upper.x - 0.08 * image.size().x, wall}), words_.say("perspective.wall")}});
    seen.add(
        {"f wall name in space", Role::boundary,
         Label{space_.at({space.upper.x - 0.1 * space.size().x, wall_}), words_.say("perspective.wall")}});
    const dvec2 eye = space_.at({0, 0});
    seen.add({"e eye", Role::input, Dot{eye}});
    seen.add({"f eye name", Role::input, Label{eye, words_.say("projection.eye")}});
    if (names_.size() >= 2) {
      if (bent_) seen.add({"c chord", Role::candidate, Stroke{in_image(a_), in_image(b_)}});
      std::vector<dvec2> curve;
      constexpr int pieces = 64;
      for (int i = 0; i <= pieces; ++i) {
        curve.push_back(in_image(image_of(from_ + (static_cast<double>(i) / pieces) * (to_ - from_))));
      }
      if (bent_) seen.add({"d curve", Role::result, Path{curve, false}});
      if (!bent_) seen.add({"d curve", Role::result, Stroke{in_image(a_), in_image(b_)}});
    }
    for (std::size_t i = 0; i < names_.size(); ++i) {
      seen.add({"e space " + names_[i], Role::past, Dot{in_space(points_[i])}});
      seen.add({"e image " + names_[i], Role::past, Dot{in_image(images_[i])}});
      if (i >= 2) continue;
      seen.add({"f space name " + names_[i], Role::input, Label{in_space(points_[i]), names_[i]}});
      seen.add({"f image name " + names_[i], Role::input, Label{in_image(images_[i]), names_[i] + "′"}});
    }
    return seen;
  }

  View pointed(std::optional<dvec3> image) const {
    View seen = view();
    seen.add({"d ray", Role::current, Stroke{space_.at({0, 0}), in_space(point_), false, true}});
    seen.add({"e space " + name_, Role::current, Dot{in_space(point_)}});
    seen.add({"f space name " + name_, Role::current, Label{in_space(point_), name_}});
    if (!image) return seen;
    seen.add({"e image " + name_, Role::current, Dot{in_image(*image)}});
    seen.add({"f image name " + name_, Role::current, Label{in_image(*image), name_ + "′"}});
    if (names_.size() > 2) add_error(seen, *image);
    return seen;
  }

  void add_error(View& seen, dvec3 image) const {
    const dvec3 on_chord = interpolated(image.x);
    if (!is_off(on_chord.z - image.z)) return;
    seen.add({"d error", Role::measure, Stroke{in_image(image), in_image(on_chord)}});
    seen.add({"f error name", Role::measure,
              Label{0.5 * (in_image(image) + in_image(on_chord)),
                    words_.say("perspective.error", arg("error", real(on_chord.z - image.z)))}});
  }

  void arrived(dvec3 image, std::string type, int line) {
    names_.push_back(name_);
    points_.push_back(point_);
    images_.push_back(image);
    const bool end = names_.size() <= 2;
    const double guess = interpolated(image.x).z;
    const double error = guess - image.z;
    if (!end && std::abs(error) > std::abs(worst_)) {
      worst_ = error;
      worst_at_ = images_.size() - 1;
    }
    show(pointed(image), line, [&](TraceStep& step) {
      describe(step, std::move(type));
      step.fields.insert(step.fields.end(), {{"x", image.x}, {"z", image.z}});
      if (!end) step.fields.push_back({"error", error});
      const std::string before = fmt::format("({},\u00a0{})", short_real(point_.x), short_real(point_.z));
      if (end) {
        step.sentence = words_.say("perspective.end_point", arg("name", name_), arg("x", real(image.x)),
                                   arg("z", real(image.z)));
      } else {
        step.sentence = words_.say(is_off(error) ? "perspective.off_the_line" : "perspective.on_the_line",
                                   arg("name", name_), arg("x", real(image.x)), arg("z", real(image.z)),
                                   arg("guess", real(guess)));
      }
      step.row = {name_ + " " + before, real(image.x), real(image.z), end ? "" : real(guess),
                  end ? "" : real(error)};
    });
  }

  void finish() {
    View seen = view();
    if (worst_at_ >= 2) add_error(seen, images_[worst_at_]);
    const double wall = depth_of_wall();
    bool hidden_wrongly = false;
    for (std::size_t i = 2; i < images_.size(); ++i) {
      hidden_wrongly |= (images_[i].z < wall) != (interpolated(images_[i].x).z < wall);
    }
    show(std::move(seen), 0, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"largest_error", worst_}};
      if (!is_off(worst_)) {
        step.sentence = words_.say(bent_ ? "perspective.done.level" : "perspective.done.transformation");
      } else {
        step.sentence =
            words_.say(hidden_wrongly ? "perspective.done.wrong_surface" : "perspective.done.bent",
                       arg("error", real(worst_)), arg("wall", real(wall_)));
      }
    });
    writer_.trace().result = {{"largest_error", worst_}};
  }

  bool bent_;
  double near_, far_, wall_;
  dvec3 from_, to_, a_{}, b_{};
  std::int64_t samples_;
  Panel space_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}}, image_ = space_;
  dvec3 point_{};
  std::string name_;
  std::vector<std::string> names_;
  std::vector<dvec3> points_, images_;
  double worst_ = 0;
  std::size_t worst_at_ = 0;
};

// --- What is divided, and what should not be ---------------------

/// Points where the eye may be among them, from above and in the picture.
class DivisionTeller : public ViewTeller {
 public:
  DivisionTeller(TraceWriter& writer, const Arguments& arguments, std::string method)
      : ViewTeller(writer),
        method_(std::move(method)),
        zoom_minus_z_(method_ == "zoom_minus_z"),
        points_(arguments.places("points")),
        zoom_(*arguments.number("zoom")) {
    const std::vector<double> scales = arguments.numbers("scales");
    const std::vector<double> centre = arguments.numbers("centre");
    const std::vector<double> range = arguments.numbers("range");
    scales_ = {scales[0], zoom_minus_z_ ? scales[0] : scales[1]};
    centre_ = {centre[0], centre[1]};
    if (!(std::min(scales_.x, scales_.y) > 0))
      refuse(arguments, {"scales"}, fmt::format("expected scales above 0, not {},{}", scales[0], scales[1]));
    if (!(0 < range[0] && range[0] < range[1] && range[1] <= 1e12))
      throw ArgumentError("range", fmt::format("expected 0 < near < far, not {},{}", range[0], range[1]));
    projection_ = projection_of(scales_.x, scales_.y, range[0], range[1]);
    lay_out();
    writer.trace().columns = {{"point", false}, {"w"}, {"image", false}};
    if (!zoom_minus_z_) writer.trace().columns.push_back({"z_image"});
  }

  void tell() {
    show(view(), 0, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.level = Level::idea;
      step.sentence = words_.say("perspective.started." + method_, arg("zoom", real(zoom_)));
    });
    for (current_ = 0; current_ < points_.size(); ++current_) {
      const dvec3 point = points_[current_];
      if (method_ == "divide_tested") divide_tested(projection_, in_view(point), *this);
      if (method_ == "divide_untested") divide_untested(projection_, in_view(point), *this);
      if (zoom_minus_z_) zoom_minus_z(WireScreen<double>{centre_, scales_.x, zoom_}, point, *this);
    }
    finish();
  }

  void operator()(const Multiplied<double>& m, int line = __builtin_LINE(), const char* = nullptr) {
    // The exhibit lists its call of transform, not transform itself
    const int shown = method_ == "divide_untested" ? writer_.trace().listing.front().number : line;
    fine(pointed(), shown, [&](TraceStep& step) {
      describe(step, "Multiplied");
      step.fields.insert(step.fields.end(), {{"clip_z", m.clip.z}, {"w", m.clip.w}});
      step.sentence = words_.say("perspective.multiplied", arg("name", name()), arg("x", real(m.clip.x)),
                                 arg("z", real(m.clip.z)), arg("w", figure_real(m.clip.w)));
    });
  }
  void operator()(const Divided<double>& d, int line = __builtin_LINE(), const char* = nullptr) {
    const double w = d.clip.w;
    if (zoom_minus_z_) {
      const double depth = zoom_ + points_[current_].z;
      arrived(dvec2(d.ndc), w, {}, "Divided", line,
              words_.say(depth > 0 ? "perspective.zoomed" : "perspective.zoomed_behind", arg("name", name()),
                         arg("zoom", real(zoom_)), arg("w", figure_real(w)),
                         arg("image", image_text(dvec2(d.ndc))), arg("depth", real(depth)),
                         arg("right", image_text(right_image(points_[current_])))));
      return;
    }
    const dvec2 image = dvec2(d.ndc) + centre_;
    const std::string_view key = w > 0    ? "perspective.divided"
                                 : w == 0 ? "perspective.divided_by_zero"
                                          : "perspective.divided_behind";
    arrived(image, w, d.ndc.z, "Divided", line,
            words_.say(key, arg("name", name()), arg("w", figure_real(w)), arg("image", image_text(image))));
  }
  void operator()(const LeftUndivided<double>& l, int line = __builtin_LINE(), const char* = nullptr) {
    images_.push_back(std::nullopt);
    show(pointed(), line, [&](TraceStep& step) {
      describe(step, "LeftUndivided");
      step.fields.push_back({"w", l.clip.w});
      step.sentence =
          words_.say("perspective.left_undivided", arg("name", name()), arg("w", figure_real(l.clip.w)));
      step.row = {point_text(), figure_real(l.clip.w), words_.say("perspective.no_image"), ""};
    });
  }
  void operator()(const LeftAlone<double>& l, int line = __builtin_LINE(), const char* = nullptr) {
    const dvec2 image(l.node);
    arrived(image, std::nullopt, {}, "LeftAlone", line,
            words_.say("perspective.left_alone", arg("name", name()), arg("image", image_text(image)),
                       arg("right", image_text(right_image(l.node)))));
  }

 private:
  static bool finite(dvec2 p) { return gradus::perspective::finite(p.x) && gradus::perspective::finite(p.y); }
  static std::string name_of(std::size_t i) { return std::string(1, static_cast<char>('A' + i)); }

  std::string name() const { return name_of(current_); }
  std::string point_text() const { return name() + " " + figure_place(points_[current_]); }
  std::string image_text(dvec2 p) const {
    return finite(p) ? place_text(p) : words_.say("perspective.no_number");
  }
  /// From a point as it is given, with the eye `zoom` before z = 0, to view space.
  dvec3 in_view(dvec3 p) const { return p - dvec3{centre_, -zoom_}; }
  dvec2 right_image(dvec3 p) const { return dvec2(divide_untested(projection_, in_view(p))) + centre_; }
  dvec2 image_of(dvec3 p) const {
    return zoom_minus_z_ ? zoom_minus_z(WireScreen<double>{centre_, scales_.x, zoom_}, p) : right_image(p);
  }
  bool behind(dvec3 p) const { return !(zoom_ + p.z > 0); }

  /// Where the formula has the eye, from above; it looks towards the plane.
  dvec2 eye() const { return {centre_.x, zoom_minus_z_ ? zoom_ : -zoom_}; }
  double plane() const { return eye().y + (zoom_minus_z_ ? -scales_.x : scales_.x); }

  /// The picture has room for all images but those that fly off.
  void lay_out() {
    const double scale = std::max(scales_.x, scales_.y);
    double half = 0.3 * scale;
    for (const dvec3 p : points_) {
      const dvec2 away = glm::abs(image_of(p) - centre_);
      const double most = std::max(away.x, away.y);
      if (finite(away) && most <= 2.2 * scale) half = std::max(half, 1.5 * most);
    }
    half_ = half;
    Extent space;
    for (const dvec3 p : points_) space.add({p.x, p.z});
    space.add(eye());
    for (const double side : {-half, half}) space.add({centre_.x + side, plane()});
    space_ = Panel({{4, 3}, {17, 22.5}}, widened(space, 0.05), Panel::Fit::stretched);
    picture_ = Panel({{22.5, 6}, {35, 18.5}}, {centre_ - half, centre_ + half});
  }

  void describe(TraceStep& step, std::string type) const {
    step.type = std::move(type);
    step.phase = words_.say("words.main_loop");
    step.key = name();
    step.fields = {{"point", name()}};
  }

  void arrived(dvec2 image, std::optional<double> w, std::optional<double> z, std::string type, int line,
               std::string sentence) {
    images_.emplace_back(image);
    show(pointed(), line, [&](TraceStep& step) {
      describe(step, std::move(type));
      if (w) step.fields.push_back({"w", *w});
      if (finite(image)) step.fields.insert(step.fields.end(), {{"x", image.x}, {"y", image.y}});
      if (z && gradus::perspective::finite(*z)) step.fields.push_back({"z", *z});
      step.sentence = std::move(sentence);
      step.row = {point_text(), w ? figure_real(*w) : "", image_text(image)};
      if (!zoom_minus_z_) step.row.push_back(z && gradus::perspective::finite(*z) ? real(*z) : "");
    });
  }

  void finish() {
    std::int64_t behind_eye = 0;
    for (const dvec3 p : points_) behind_eye += behind(p);
    show(view(), 0, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = zoom_minus_z_ ? words_.say("perspective.done.zoom_minus_z")
                      : behind_eye == 0
                          ? words_.say("perspective.done.before_the_eye")
                          : words_.count(method_ == "divide_tested" ? "perspective.done.divide_tested"
                                                                    : "perspective.done.divide_untested",
                                         behind_eye);
    });
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (!images_[i] || !finite(*images_[i])) continue;
      writer_.trace().result.push_back({name_of(i) + ".x", images_[i]->x});
      writer_.trace().result.push_back({name_of(i) + ".y", images_[i]->y});
    }
  }

  // --- The drawing

  void stroke(View& view, const Panel& panel, std::string id, Role role, dvec2 a, dvec2 b,
              bool dashed) const {
    const std::optional<Stroke> part = shown_part(panel.shown(), a, b);
    if (part) view.add({std::move(id), role, Stroke{panel.at(part->a), panel.at(part->b), false, dashed}});
  }

  /// The whole projector of a point: it, the eye and the image, as far as the drawing reaches.
  void projector(View& view, std::size_t i, Role role) const {
    const dvec2 point{points_[i].x, points_[i].z};
    if (!images_[i] || !finite(*images_[i]) || point == eye()) return;
    if (zoom_minus_z_ && points_[i].z == 0) return;  // left alone
    const dvec2 image{images_[i]->x, plane()};
    std::array<dvec2, 3> line{eye(), point, image};
    std::ranges::sort(line, {}, [](dvec2 p) { return std::pair(p.y, p.x); });
    stroke(view, space_, fmt::format("b projector {}", i), role, line[0], line[2], true);
  }

  /// A point's image: a dot, or where it lies outside an arrow to the border.
  void image(View& view, std::size_t i, Role role) const {
    if (!images_[i] || !finite(*images_[i])) return;
    const dvec2 at = *images_[i], away = at - centre_;
    const std::string name = name_of(i) + "′";
    const double most = std::max(std::abs(away.x), std::abs(away.y));
    if (most <= half_) {
      view.add({fmt::format("e image {}", i), role, Dot{picture_.at(at)}});
      view.add({fmt::format("f image name {}", i), role, Label{picture_.at(at), name}});
      return;
    }
    const dvec2 border = centre_ + away * (half_ / most);
    view.add({fmt::format("e image {}", i), role,
              Stroke{picture_.at(centre_ + away * (0.85 * half_ / most)), picture_.at(border), true}});
    view.add({fmt::format("f image name {}", i), role, Label{picture_.at(border), name}});
  }

  /// The picture of the line between two points that follow each other.
  void line(View& view, std::size_t i, Role role) const {
    const std::string id = fmt::format("d image line {}", i);
    if (images_[i] && images_[i + 1]) {
      if (finite(*images_[i]) && finite(*images_[i + 1]))
        stroke(view, picture_, id, role, *images_[i], *images_[i + 1], false);
      return;
    }
    if (!images_[i] && !images_[i + 1]) return;
    // It runs to infinity, towards where it passes beside the eye
    const std::size_t seen = images_[i] ? i : i + 1, other = images_[i] ? i + 1 : i;
    const glm::dvec4 a = transform(projection_, in_view(points_[seen]));
    const glm::dvec4 b = transform(projection_, in_view(points_[other]));
    const dvec2 from = *images_[seen], way = dvec2(a + a.w / (a.w - b.w) * (b - a));
    const Extent shown{centre_ - half_, centre_ + half_};
    const bool inside = glm::all(glm::lessThanEqual(glm::abs(from - centre_), dvec2{half_}));
    if (!inside || way == dvec2{0}) return;
    view.add({id, role, Stroke{picture_.at(from), picture_.at(last_inside(shown, from, way)), true}});
  }

  View view() const {
    View seen;
    seen.add({"z caption space", Role::guide, Text{{10, 25.4}, words_.say("perspective.from_above")}});
    seen.add({"z caption image", Role::guide, Text{{28.5, 25.4}, words_.say("projection.picture")}});
    add_axes(seen, space_, "space", {words_.symbol("x"), words_.symbol("z")}, 4);
    add_axes(seen, picture_, "picture", {words_.symbol("x′"), words_.symbol("y′")}, 4);
    stroke(seen, space_, "a plane", Role::boundary, {centre_.x - half_, plane()},
           {centre_.x + half_, plane()}, false);
    seen.add({"e eye", Role::input, Dot{space_.at(eye())}});
    seen.add({"f eye name", Role::input, Label{space_.at(eye()), words_.say("projection.eye")}});
    const auto above = [&](std::size_t i) { return dvec2{points_[i].x, points_[i].z}; };
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
      stroke(seen, space_, fmt::format("c line {}", i), Role::input, above(i), above(i + 1), false);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      seen.add({fmt::format("e point {}", i), Role::input, Dot{space_.at(above(i))}});
      seen.add({fmt::format("f point name {}", i), Role::input, Label{space_.at(above(i)), name_of(i)}});
    }
    const bool done = current_ == points_.size();
    for (std::size_t i = 0; i < images_.size(); ++i) {
      const bool wrong = method_ != "divide_tested" && (zoom_minus_z_ || behind(points_[i]));
      const Role role = wrong ? Role::rejected : done ? Role::result : Role::past;
      projector(seen, i, Role::guide);
      image(seen, i, role);
      if (i == 0) continue;
      const bool crosses = zoom_minus_z_ || behind(points_[i]) || behind(points_[i - 1]);
      const bool bad = method_ != "divide_tested" && crosses;
      line(seen, i - 1, bad ? Role::rejected : done ? Role::result : Role::past);
    }
    return seen;
  }

  /// With the point at hand.
  View pointed() const {
    View seen = view();
    const dvec2 at = space_.at({points_[current_].x, points_[current_].z});
    seen.add({fmt::format("e point {}", current_), Role::current, Dot{at}});
    seen.add({fmt::format("f point name {}", current_), Role::current, Label{at, name()}});
    if (current_ < images_.size()) projector(seen, current_, Role::current);
    return seen;
  }

  std::string method_;
  bool zoom_minus_z_;
  std::vector<dvec3> points_;
  double zoom_, half_ = 1;
  dvec2 scales_{1, 1}, centre_{0, 0};
  Projection<double> projection_{};
  Panel space_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}}, picture_ = space_;
  std::size_t current_ = 0;
  std::vector<std::optional<dvec2>> images_;
};

// --- How finely depth is stored ----------------------------------

struct Kind {
  DepthCurve curve;
  DepthFormat format;
  std::string_view name;  ///< of its texts
};
constexpr std::array kinds{Kind{DepthCurve::linear, DepthFormat::fixed24, "linear_fixed"},
                           Kind{DepthCurve::inverse, DepthFormat::fixed24, "inverse_fixed"},
                           Kind{DepthCurve::inverse, DepthFormat::float32, "inverse_float"},
                           Kind{DepthCurve::reversed, DepthFormat::float32, "reversed_float"}};

/// log10, rounded where it is as good as a whole number.
double decade(double value) {
  const double exact = gradus::log(value) / gradus::log(10.0);
  const double whole = std::round(exact);
  return std::abs(exact - whole) < 1e-9 ? whole : exact;
}

/// "100", "0.01", "10⁵".
std::string power_text(int exponent, int plain = 3) {
  if (-plain <= exponent && exponent <= plain) {
    return exponent < 0 ? "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + "1"
                        : "1" + std::string(static_cast<std::size_t>(exponent), '0');
  }
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : fmt::format("{}", std::abs(exponent))) text += digits[c - '0'];
  return text;
}

/// A power of ten as one, all else as figures show it.
std::string short_depth(double z) {
  if (!(z > 0)) return figure_real(z);
  const double exponent = decade(z);
  return exponent == std::round(exponent) ? power_text(static_cast<int>(exponent)) : figure_real(z);
}

/// Three significant digits: "5.96·10⁻⁸", "0.0596", "596", "59605".
std::string step_text(double step) {
  if (step >= 1000) return step < 1e7 ? fmt::format("{:.0f}", step) : figure_real(step);
  if (step >= 1e-3) return fmt::format("{:.3g}", step);
  const std::string text = fmt::format("{:.2e}", step);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.ends_with('.')) mantissa.pop_back();
  int power = 0;
  for (const char c : text.substr(e + 2)) power = 10 * power + (c - '0');
  return (mantissa == "1" ? "" : mantissa + "·") + power_text(-power, 0);
}

class PrecisionTeller : public ViewTeller {
 public:
  static constexpr int fine_points = 7, curve_points = 241;
  static constexpr std::array table_places{2, 3, 5, 6};  ///< of the fine points

  PrecisionTeller(TraceWriter& writer, const Arguments& arguments) : ViewTeller(writer) {
    const std::vector<double> planes = arguments.numbers("range");
    near_ = planes[0];
    far_ = planes[1];
    if (!(0 < near_ && 10 * near_ <= far_ && far_ <= 1e12 * near_)) {
      throw ArgumentError(
          "range",
          fmt::format("expected 0 < near and a far plane 10 to 1e12 times as far, not {},{}", near_, far_));
    }
    const double left = decade(near_), right = decade(far_);
    // Right at its 0 a float curve is finer than any scale shows
    const double bottom = decade(step_at(kinds[1], near_)), top = decade(step_at(kinds[1], far_));
    panel_ = Panel({{4, 3.6}, {35, 24}}, {{left, std::floor(bottom)}, {right, std::ceil(top)}},
                   Panel::Fit::stretched);
    writer.trace().columns = {{"stored", false}};
    for (const int i : table_places) {
      const std::string depth = short_depth(place(i, fine_points));
      writer.trace().columns.push_back(
          {fmt::format("step_{}", i), true, words_.say("perspective.at_depth", arg("z", depth))});
    }
  }

  void tell() {
    show(view({}), 0, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.level = Level::idea;
      step.sentence = words_.say("perspective.started.depth_precision", arg("near", short_depth(near_)),
                                 arg("far", short_depth(far_)));
    });
    for (kind_ = 0; kind_ < kinds.size(); ++kind_) {
      points_.clear();
      for (int i = 0; i < fine_points; ++i) {
        separable_step(kinds[kind_].curve, kinds[kind_].format, near_, far_, place(i, fine_points), *this);
      }
      milestone();
    }
    kind_ = kinds.size();
    show(view({}), 0, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = words_.say("perspective.done.depth_precision");
    });
    writer_.trace().result = {
        {"step_at_far", separable_step(DepthCurve::inverse, DepthFormat::fixed24, near_, far_, far_)}};
  }

  void operator()(const Resolved& r, int line = __builtin_LINE(), const char* = nullptr) {
    line_ = line;
    points_.push_back({r.z, r.step});
    View seen = view(points_);
    fine(std::move(seen), line, [&](TraceStep& step) {
      describe(step, "Resolved");
      step.fields.insert(step.fields.end(),
                         {{"z", r.z}, {"depth", r.depth}, {"spacing", r.spacing}, {"step", r.step}});
      step.sentence =
          words_.say("perspective.resolved", arg("z", short_depth(r.z)), arg("spacing", step_text(r.spacing)),
                     arg("slope", step_text(r.slope)), arg("step", step_text(r.step)));
    });
  }

 private:
  double place(int i, int count) const {
    if (i == 0) return near_;
    if (i == count - 1) return far_;
    const double share = static_cast<double>(i) / (count - 1);
    const double z = near_ * gradus::exp(share * gradus::log(far_ / near_));
    // A round number where it is meant to be one
    const double scale = decade(z);
    const double round = std::round(z);
    return scale == std::round(scale) && std::abs(round - z) < 1e-9 * z ? round : std::clamp(z, near_, far_);
  }
  /// Three digits; what lies below the scale is said to.
  std::string table_text(double step) const {
    const int bottom = static_cast<int>(panel_.shown().lower.y);
    return decade(step) < bottom ? "< " + power_text(bottom) : step_text(step);
  }

  double step_at(const Kind& kind, double z) const {
    return separable_step(kind.curve, kind.format, near_, far_, z);
  }

  dvec2 at(double z, double step) const {
    const Extent& shown = panel_.shown();
    return panel_.at({decade(z), std::clamp(decade(step), shown.lower.y, shown.upper.y)});
  }

  void describe(TraceStep& step, std::string type) const {
    step.type = std::move(type);
    step.phase = name_of_kind(kind_);
    step.key = kinds[kind_].name;
    step.fields = {{"stored", std::string(kinds[kind_].name)}};
  }
  std::string name_of_kind(std::size_t i) const {
    return words_.say("perspective.stored." + std::string(kinds[i].name));
  }

  void milestone() {
    const Kind& kind = kinds[kind_];
    show(view(points_), line_, [&](TraceStep& step) {
      describe(step, "Curve");
      const double first = step_at(kind, near_), last = step_at(kind, far_);
      step.sentence = words_.say("perspective.curve." + std::string(kind.name),
                                 arg("first", step_text(first)), arg("last", step_text(last)));
      step.row = {name_of_kind(kind_)};
      for (const int i : table_places) {
        step.row.push_back(table_text(step_at(kind, place(i, fine_points))));
      }
    });
  }

  void add_scales(View& seen) const {
    const Extent shown = panel_.shown(), place = panel_.place();
    const auto mark = [&](std::string id, auto shape) {
      seen.add({"a " + id, Role::guide, std::move(shape)});
    };
    mark("x", Stroke{place.lower, {place.upper.x, place.lower.y}});
    mark("y", Stroke{place.lower, {place.lower.x, place.upper.y}});
    const int left = static_cast<int>(std::ceil(shown.lower.x - 1e-9));
    const int right = static_cast<int>(std::floor(shown.upper.x + 1e-9));
    for (int e = left; e <= right; ++e) {
      const dvec2 foot = panel_.at({static_cast<double>(e), shown.lower.y});
      mark(fmt::format("x tick {}", e), Stroke{foot, foot - dvec2{0, 0.4}});
      if ((e - left) % ((right - left) / 7 + 1) == 0)
        mark(fmt::format("x value {}", e), Text{foot - dvec2{0, 1.3}, power_text(e)});
    }
    const int bottom = static_cast<int>(shown.lower.y), top = static_cast<int>(shown.upper.y);
    for (int e = bottom; e <= top; ++e) {
      const dvec2 foot = panel_.at({shown.lower.x, static_cast<double>(e)});
      mark(fmt::format("y tick {}", e), Stroke{foot, foot - dvec2{0.4, 0}});
      if ((e - bottom) % ((top - bottom) / 8 + 1) == 0)
        mark(fmt::format("y value {}", e), Text{foot - dvec2{0.7, 0}, power_text(e), Align::right});
    }
    mark("z name",
         Text{{place.upper.x, place.lower.y - 2.7}, words_.say("perspective.depth_axis"), Align::right});
    mark("step name", Text{{0.5, place.upper.y + 1.2}, words_.say("perspective.step_axis"), Align::left});
  }

  /// All curves up to this one; of this one the points given, and the curve through them.
  View view(const std::vector<dvec2>& points) const {
    View seen;
    add_scales(seen);
    for (std::size_t i = 0; i < kinds.size() && i <= kind_; ++i) {
      const bool current = i == kind_;
      if (current && points.empty()) break;
      const double end = current ? points.back().x : far_;
      std::vector<dvec2> curve;
      for (int k = 0; k < curve_points; ++k) {
        const double z = place(k, curve_points);
        if (z <= end) curve.push_back(at(z, step_at(kinds[i], z)));
      }
      const Role role = current ? Role::current : kind_ == kinds.size() ? Role::result : Role::past;
      seen.add(
          {fmt::format("c curve {}", i), role, Path{curve, false, kinds[i].format == DepthFormat::fixed24}});
      const double where = near_ * gradus::exp(name_places[i] * gradus::log(far_ / near_));
      if (!current || end == far_) {
        seen.add(
            {fmt::format("f name {}", i), role, Label{at(where, step_at(kinds[i], where)), name_of_kind(i)}});
      }
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      seen.add({fmt::format("e point {}", k), Role::current,
                Dot{at(points[k].x, points[k].y), k + 1 < points.size()}});
    }
    return seen;
  }

  /// Where along its curve a name stands, in parts of the scale.
  static constexpr std::array<double, 4> name_places{0.18, 0.75, 0.45, 0.6};

  double near_ = 1, far_ = 10;
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
  std::size_t kind_ = 0;
  std::vector<dvec2> points_;
  int line_ = 0;
};

// --- The entry ---------------------------------------------------

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("perspective", std::move(name), standing);
  };
  static const std::vector<Method> methods{
      method("projection", Standing::taught),       method("vanishing_points", Standing::plain),
      method("transformation", Standing::plain),    method("divide_tested", Standing::plain),
      method("depth_precision", Standing::plain),   method("keep_z", Standing::faulty),
      method("divide_untested", Standing::faulty),  method("zoom_minus_z", Standing::faulty),
      method("parallel_by_plane", Standing::faulty)};
  return methods;
}

bool is_faulty(std::string_view name) {
  return std::ranges::find(all_methods(), name, &Method::name)->standing == Standing::faulty;
}
bool divides(std::string_view method) {
  return method == "divide_tested" || method == "divide_untested" || method == "zoom_minus_z";
}
bool vanishes(std::string_view method) {
  return method == "vanishing_points" || method == "parallel_by_plane";
}

/// Only the methods of late parameters say them.
void leave_out_unread(Trace& trace, const std::string& method) {
  std::erase_if(trace.arguments, [&](const Argument& a) {
    const bool of_division =
        a.name == "points" || a.name == "scales" || a.name == "centre" || a.name == "zoom";
    return (of_division && !divides(method)) || (a.name == "direction" && !vanishes(method));
  });
}

void list_source(Trace& trace, std::string_view file, std::initializer_list<std::string_view> functions) {
  trace.source_file = std::string(folder) + std::string(file);
  for (const std::string_view function : functions) {
    const std::vector<SourceLine> lines = listing_of(source_text(trace.source_file), function);
    trace.listing.insert(trace.listing.end(), lines.begin(), lines.end());
  }
}

std::string subtitle_of(const Wording& words, const Arguments& arguments, const std::string& method) {
  if (method == "depth_precision") {
    const std::vector<double> range = arguments.numbers("range");
    return words.say("perspective.subtitle.range", arg("near", short_depth(range[0])),
                     arg("far", short_depth(range[1])));
  }
  if (method == "transformation" || method == "keep_z") {
    return words.say("perspective.subtitle.line", arg("from", place_text(vector_of(arguments, "from"))),
                     arg("to", place_text(vector_of(arguments, "to"))));
  }
  if (divides(method)) {
    std::string list;
    const std::vector<dvec3> points = arguments.places("points");
    for (const dvec3 p : points) list += (list.empty() ? "" : ", ") + figure_place(p);
    return words.count("perspective.subtitle.points", static_cast<std::int64_t>(points.size()),
                       arg("points", list));
  }
  const std::vector<double> turn = arguments.numbers("turn");
  const bool house = method == "projection" && arguments.text("solid") == "house";
  return words.say(house ? "perspective.subtitle.house" : "perspective.subtitle.box",
                   arg("yaw", real(turn[0])), arg("pitch", real(turn[1])));
}

std::vector<LegendEntry> legend_of(const Wording& words, const std::string& method) {
  if (method == "depth_precision") return {{Role::current, words.say("perspective.legend.curve")}};
  if (method == "transformation" || method == "keep_z") {
    return {{Role::current, words.say("perspective.legend.point")},
            {Role::result, words.say("perspective.legend.true_line")},
            {Role::candidate, words.say("perspective.legend.interpolated")},
            {Role::measure, words.say("perspective.legend.error")}};
  }
  if (divides(method)) {
    std::vector<LegendEntry> legend{{Role::input, words.say("perspective.legend.points")},
                                    {Role::current, words.say("perspective.legend.point")},
                                    {Role::result, words.say("perspective.legend.result")}};
    if (method != "divide_tested") legend.push_back({Role::rejected, words.say("perspective.legend.wrong")});
    return legend;
  }
  if (vanishes(method)) {
    std::vector<LegendEntry> legend{{Role::input, words.say("perspective.legend.box")},
                                    {Role::current, words.say("perspective.legend.direction")},
                                    {Role::result, words.say("perspective.legend.result")}};
    if (method == "parallel_by_plane")
      legend.push_back({Role::rejected, words.say("perspective.legend.missed")});
    return legend;
  }
  return {{Role::input, words.say("perspective.legend.solid")},
          {Role::current, words.say("perspective.legend.current")},
          {Role::past, words.say("perspective.legend.past")},
          {Role::result, words.say("perspective.legend.result")}};
}

/// What the steps of a projection hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Scaled<T>& s) const {
    to.type = "Scaled";
    to.number("factor", s.factor);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Projected<T>& p) const {
    to.type = "Projected";
    to.point("image", p.image);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Unseen<T>&) const {
    to.type = "Unseen";
  }
};

void put_side_by_side(Trace& trace, const Arguments& arguments) {
  const double d = distance_of(arguments);
  const solids::Solid solid = solid_of(arguments);
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    for (const dvec3 corner : solid.corners) project(T(d), in_scalar<T>(corner), observer);
  });
}

Trace run(const Arguments& arguments, Recording recording) {
  const std::string& method = arguments.text("method");
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = writer.wording();
  introduce(trace, "perspective", arguments, is_faulty(method));
  leave_out_unread(trace, method);
  trace.subtitle = subtitle_of(words, arguments, method);
  trace.grid = paper_grid(solids::paper_width, method == "projection" ? solids::paper_height : 27);
  trace.legend = legend_of(words, method);
  if (method == "projection") {
    list_source(trace, "perspective.hpp", {"project"});
    ProjectionTeller(writer, arguments).tell();
  } else if (method == "vanishing_points") {
    list_source(trace, "perspective.hpp", {"vanishing_point"});
    VanishingTeller(writer, arguments, false).tell();
  } else if (method == "parallel_by_plane") {
    list_source(trace, "perspective_notes.hpp", {method});
    VanishingTeller(writer, arguments, true).tell();
  } else if (method == "divide_tested") {
    list_source(trace, "perspective.hpp", {"transform", "divide", method});
    DivisionTeller(writer, arguments, method).tell();
  } else if (divides(method)) {
    list_source(trace, "perspective_notes.hpp", {method});
    DivisionTeller(writer, arguments, method).tell();
  } else if (method == "depth_precision") {
    list_source(trace, "perspective.hpp", {"separable_step"});
    PrecisionTeller(writer, arguments).tell();
  } else if (method == "keep_z") {
    list_source(trace, "perspective_notes.hpp", {"keep_z"});
    BendTeller(writer, arguments, true).tell();
  } else {
    list_source(trace, "perspective.hpp", {"transform", "divide"});
    BendTeller(writer, arguments, false).tell();
  }
  Trace told = std::move(writer).finish();
  told.telling = told.whole() ? StepNumber{told.last, 0} : middle_step(told);
  if (side_by_side(arguments)) {
    require_method(arguments, {"projection"});
    put_side_by_side(told, arguments);
  }
  return told;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "perspective",
      .title = Wording().say("perspective.title"),
      .chapter = "projection",
      .aliases = {"perspective projection", "vanishing point", "depth buffer precision", "pinhole camera"},
      .summary = "what is farther looks smaller: projection, vanishing points, and what becomes of depth",
      .methods = all_methods(),
      .default_method = "projection",
      .parameters = {{.name = "distance",
                      .type = ParameterType::number,
                      .default_value = "3",
                      .example = "1",
                      .help = "the picture plane's distance d from the eye; methods transformation and "
                              "keep_z: the near plane",
                      .sizes = {1e-3, 1e6}},
                     {.name = "solid",
                      .type = ParameterType::choice,
                      .default_value = "house",
                      .example = "box",
                      .help = "method projection: what is projected, 2 wide, 2 high, 3 deep",
                      .choices = {"house", "box"}},
                     {.name = "at",
                      .type = ParameterType::numbers,
                      .default_value = "0.4,-0.8,5",
                      .example = "0,0,8",
                      .help = "where the solid's middle stands: x right, y up, z forward",
                      .parts = {"x", "y", "z"},
                      .sizes = solids::modest_sizes},
                     {.name = "turn",
                      .type = ParameterType::numbers,
                      .default_value = "35,0",
                      .example = "35,25",
                      .help = "degrees by which the solid is turned: round the upright, then round x",
                      .parts = {"yaw", "pitch"},
                      .sizes = solids::modest_sizes},
                     {.name = "from",
                      .type = ParameterType::numbers,
                      .default_value = "0,0,3",
                      .example = "0,0,1",
                      .help = "methods transformation and keep_z: where the line starts",
                      .parts = {"x", "y", "z"},
                      .sizes = solids::modest_sizes},
                     {.name = "to",
                      .type = ParameterType::numbers,
                      .default_value = "6,0,9",
                      .example = "2,0,3",
                      .help = "where it ends",
                      .parts = {"x", "y", "z"},
                      .sizes = solids::modest_sizes},
                     {.name = "wall",
                      .type = ParameterType::number,
                      .default_value = "6.6",
                      .example = "2.2",
                      .help = "the depth of a wall that the line crosses",
                      .sizes = solids::modest_sizes},
                     {.name = "far",
                      .type = ParameterType::number,
                      .default_value = "12",
                      .example = "4",
                      .help = "the far plane's depth",
                      .sizes = solids::modest_sizes},
                     {.name = "samples",
                      .type = ParameterType::integer,
                      .default_value = "3",
                      .example = "7",
                      .help = "points between the line's ends",
                      .least = 1,
                      .most = 15},
                     {.name = "range",
                      .type = ParameterType::numbers,
                      .default_value = "1,1000000",
                      .example = "0.1,1000",
                      .help = "methods depth_precision, divide_tested and divide_untested: the depths of the "
                              "near and the far plane",
                      .parts = {"near", "far"},
                      .sizes = {1e-9, 1e12}},
                     {.name = "points",
                      .type = ParameterType::points,
                      .default_value = "2,1,-2 2,1,2 2,1,-6",
                      .example = "1,0,2 1,0,-2",
                      .help = "methods divide_tested, divide_untested and zoom_minus_z: x right, y up, z "
                              "forward, and the lines from one to the next",
                      .least = 1,
                      .most = 6,
                      .parts = {"x", "y", "z"},
                      .sizes = {1e-9, 1e6}},
                     {.name = "scales",
                      .type = ParameterType::numbers,
                      .default_value = "1,1",
                      .example = "1,1.732",
                      .help = "of these methods: by what x and y are multiplied, the cotangents of half the "
                              "angles of view; zoom_minus_z takes the first for both",
                      .parts = {"across", "up"},
                      .sizes = {1e-3, 1e6}},
                     {.name = "centre",
                      .type = ParameterType::numbers,
                      .default_value = "0,0",
                      .example = "400,300",
                      .help = "of these methods: x and y straight ahead of the eye",
                      .parts = {"x", "y"},
                      .sizes = solids::modest_sizes},
                     {.name = "zoom",
                      .type = ParameterType::number,
                      .default_value = "4",
                      .example = "0",
                      .help = "of these methods: how far before z = 0 the eye stands",
                      .sizes = solids::modest_sizes},
                     {.name = "direction",
                      .type = ParameterType::numbers,
                      .default_value = "0,0,0",
                      .example = "1,0,1",
                      .help = "methods vanishing_points and parallel_by_plane: one direction more, along the "
                              "box's axes; 0,0,0: none",
                      .parts = {"x", "y", "z"},
                      .sizes = solids::modest_sizes},
                     exact_parameter()},
      .examples = {"--solid box --turn 0,0", "--method vanishing_points --turn 35,25",
                   "--method keep_z --distance 1 --from 0,0,1 --to 2,0,3 --wall 2.2 --far 4"},
      .run = run};
  return topic;
}

}  // namespace gradus::perspective
