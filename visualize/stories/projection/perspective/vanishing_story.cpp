// The lines of a box, and where those of one direction run together.

#include "projection/perspective/perspective_notes.hpp"
#include "stories/past.hpp"
#include "stories/projection/perspective/stories.hpp"

namespace gradus::perspective {
namespace {

/// An edge of the box, or a line through it.
struct Line {
  std::string id, goes_on;  ///< of the marks: its own, and that of what leads on to the vanishing point
  dvec2 a, b;
  bool hidden;
};

/// All that run along one direction.
struct Lines {
  std::string id, name;
  dvec3 direction;
  std::vector<Line> all{};
  std::optional<dvec2> point{};  ///< where they vanish, as far as the method has found
};

/// The box and its picture.
struct TurnedBox {
  double d = 1;
  solids::Solid solid{};
  std::vector<dvec2> images{};
  solids::Facing facing{};
  std::array<dvec3, 3> axes{};
  dvec3 own{0};  ///< a direction along its axes; 0: none
};

TurnedBox box_of(const Arguments& arguments) {
  TurnedBox box{.d = distance_of(arguments)};
  box.axes = axes_of(arguments);
  box.solid = placed(solids::box(), box.axes, vector_of(arguments, "at"));
  box.facing = facing_origin(box.solid);
  box.own = vector_of(arguments, "direction");
  for (const dvec3 p : box.solid.corners) {
    const std::optional<dvec3> image = project(box.d, p);
    if (!image)
      refuse(arguments, {"at", "turn"}, "expected a place where the whole box is in front of the eye");
    box.images.emplace_back(image->x, image->y);
  }
  return box;
}

/// Corners 0 1 2 3 and 4 5 6 7 go round; 1 - 0 runs along x, 3 - 0 along y, 4 - 0 along z.
int axis_of(const solids::Edge& edge) {
  const std::size_t a = edge.a, b = edge.b;
  if (b == a + 4) return 2;
  const bool level = (a % 4 == 0 && b % 4 == 1) || (a % 4 == 2 && b % 4 == 3);
  return level ? 0 : 1;
}

Lines edges_along(const Words& words, const TurnedBox& box, int axis) {
  constexpr std::string_view names[] = {"x", "y", "z"};
  const auto place = static_cast<std::size_t>(axis);
  Lines lines{std::string(names[place]), words.symbol(names[place]), box.axes[place]};
  for (std::size_t i = 0; i < box.solid.edges.size(); ++i) {
    const solids::Edge& edge = box.solid.edges[i];
    if (axis_of(edge) != axis) continue;
    lines.all.push_back({fmt::format("c edge {:02}", i), fmt::format("b line {:02}", i), box.images[edge.a],
                         box.images[edge.b], box.facing.hidden[i]});
  }
  return lines;
}

/// Lines of the direction that is none of the box's: from each corner from where it leads into the box, to
/// where it leaves it.
Lines lines_inside(const TurnedBox& box) {
  const dvec3 own = box.own;
  Lines lines{"direction", place_text(own), own.x * box.axes[0] + own.y * box.axes[1] + own.z * box.axes[2]};
  const std::vector<dvec3> own_corners = solids::box().corners;
  for (std::size_t k = 0; k < own_corners.size(); ++k) {
    const dvec3 p = own_corners[k];
    if (!glm::all(glm::lessThanEqual(own * p, dvec3{0}))) continue;
    double length = 1e300;
    for (int i = 0; i < 3; ++i) {
      if (own[i] != 0) length = std::min(length, 2 * std::abs(p[i] / own[i]));
    }
    const std::optional<dvec3> end = project(box.d, box.solid.corners[k] + length * lines.direction);
    const std::string id = fmt::format("d own {}", k);
    if (end) lines.all.push_back({id, "b " + id, box.images[k], dvec2(*end), false});
  }
  return lines;
}

class VanishingStory : public Past<steps::Started, Finer<TakenToInfinity<double>>, Vanished<double>,
                                   StaysParallel<double>, steps::Finished> {
 public:
  /// by_plane: the line of the rule's listing that calls vanishing_point, of which it lists no more.
  VanishingStory(const Words& words, const TurnedBox& box, std::optional<int> by_plane)
      : words_(words), box_(box), matrix_(matrix_onto(box.d)), by_plane_(by_plane) {
    for (const int axis : {0, 1, 2}) lines_.push_back(edges_along(words, box, axis));
    if (box.own != dvec3{0}) lines_.push_back(lines_inside(box));
    Extent shown;
    for (const dvec2 p : box.images) shown.add(p);
    const double reach = 6 * std::max(shown.size().x, shown.size().y);
    const dvec2 middle = shown.centre();
    for (const Lines& lines : lines_) {
      const std::optional<dvec2> point = vanishing_point(matrix_, lines.direction);
      if (point && glm::distance(*point, middle) <= reach) shown.add(*point);
    }
    panel_ = Panel({{1, 1}, {35, 23}}, widened(shown, 0.02));
  }

  std::size_t count() const { return lines_.size(); }
  const Lines& lines() const { return lines_[turn()]; }
  const Panel& panel() const { return panel_; }
  const glm::dmat4& matrix() const { return matrix_; }
  std::int64_t vanishing_axes() const {
    return std::ranges::count_if(lines_.begin(), lines_.begin() + 3,
                                 [](const Lines& lines) { return lines.point.has_value(); });
  }

  template <class Step>
  void take(const Step& step) {
    Past::take(step);
    if constexpr (std::same_as<Step, Vanished<double>>) lines_[turn()].point = step.point;
  }
  Event say(const steps::Started&) const {
    return {.text = by_plane_ ? "started.parallel_by_plane" : "started.vanishing_points",
            .words = {{"d", real(box_.d)}},
            .level = Level::idea};
  }

  Event say(const TakenToInfinity<double>& t) const {
    return {.text = "taken_to_infinity",
            .facts = {{"axis", lines().id}, {"w", w()}},
            .words = {{"axis", lines().name}, {"direction", place_text(t.direction)}, {"w", real(w())}},
            .key = lines().id,
            .decides = divisible(),
            .line = by_plane_};
  }

  Event say(const Vanished<double>& v) const {
    return {.text = "vanished",
            .facts = {{"axis", lines().id}, {"x", v.point.x}, {"y", v.point.y}},
            .words = {{"axis", lines().name}, {"w", w()}, {"point", place_text(v.point)}},
            .row = {lines().name, place_text(v.direction), w(), place_text(v.point)},
            .key = lines().id,
            .decides = divisible(),
            .line = by_plane_};
  }

  Event say(const StaysParallel<double>& s) const {
    const bool by_rule = by_plane_ && s.direction.y == 0;
    const std::optional<dvec2> missed_point = missed(lines());
    Event event{.text = missed_point ? "said_to_stay"
                        : by_rule    ? "stays_by_rule"
                                     : "stays_parallel",
                .facts = {{"axis", lines().id}},
                .words = {{"axis", lines().name},
                          {"direction", place_text(s.direction)},
                          {"point", missed_point ? place_text(*missed_point) : ""}},
                .row = {lines().name, place_text(s.direction), by_rule ? Said("") : w(), words_.say("none")},
                .key = lines().id};
    if (by_rule) {
      event.decides = yes_or_no(words_, "question.by_plane", {}, true, "parallel");
      return event;
    }
    event.decides = divisible();
    event.line = by_plane_;
    return event;
  }

  Event say(const steps::Finished&) const {
    constexpr std::string_view keys[] = {"done.points.none", "done.points.one", "done.points.two",
                                         "done.points.three"};
    if (!by_plane_) return {.text = keys[vanishing_axes()]};
    std::string names;
    for (const Lines& lines : lines_) {
      if (missed(lines)) names += (names.empty() ? "" : ", ") + lines.name;
    }
    return {.text = names.empty() ? "done.rule_holds" : "done.parallel_by_plane", .words = {{"axes", names}}};
  }

  View draw() const {
    View view = box(now<steps::Finished>() ? Role::result : Role::input);
    if (now<steps::Started>()) return view;
    if (now<steps::Finished>()) {
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        lead_on(view, i, Role::past);
        if (missed(lines_[i])) add_lines(view, lines_[i], Role::rejected);
      }
      return view;
    }
    for (std::size_t i = 0; i < turn(); ++i) lead_on(view, i, Role::past);
    lead_on(view, turn(), Role::current);
    const bool wrongly = now<StaysParallel<double>>() && missed(lines());
    add_lines(view, lines(), wrongly ? Role::rejected : Role::current);
    return view;
  }

 private:
  /// Of the last point at infinity that was taken through the matrix.
  double w() const { return last<TakenToInfinity<double>>()->image.w; }
  Decision divisible() const {
    return yes_or_no(words_, "question.divisible", {{"w", w()}}, w() != 0, "vanishes", "parallel");
  }
  /// Where lines vanish although the rule has them stay parallel.
  std::optional<dvec2> missed(const Lines& lines) const {
    return lines.point ? std::nullopt : vanishing_point(matrix_, lines.direction);
  }

  View box(Role role) const {
    View view;
    const Extent shown = panel_.shown();
    if (shown.lower.y < 0 && shown.upper.y > 0) {
      const dvec2 left = panel_.at({shown.lower.x, 0}), right = panel_.at({shown.upper.x, 0});
      view.add({"a eye level", Role::guide, Stroke{left, right}});
      view.add({"z eye level name", Role::guide,
                Label{panel_.at({shown.lower.x + 0.25 * shown.size().x, 0}), words_.say("eye_level")}});
    }
    add_faces_of_box(view, role);
    for (int axis = 0; axis < 3; ++axis) add_lines(view, lines_[static_cast<std::size_t>(axis)], role);
    return view;
  }

  void add_faces_of_box(View& view, Role role) const {
    for (std::size_t i = 0; i < box_.solid.faces.size(); ++i) {
      if (!box_.facing.seen[i]) continue;
      std::vector<dvec2> ring;
      for (const std::size_t corner : box_.solid.faces[i]) ring.push_back(panel_.at(box_.images[corner]));
      view.add({fmt::format("a face {}", i), role,
                Area{{ring}, shade_of(solids::seen_by_viewer(outward(box_.solid, i)))}});
    }
  }

  void add_lines(View& view, const Lines& lines, Role role) const {
    for (const Line& line : lines.all) {
      Stroke stroke{panel_.at(line.a), panel_.at(line.b), false, line.hidden};
      stroke.thin = line.hidden;
      view.add({line.id, role, stroke});
    }
  }

  /// They go on to the vanishing point, or to the border of the drawing on the way there.
  void lead_on(View& view, std::size_t at, Role role) const {
    const Lines& lines = lines_[at];
    if (!lines.point) return;
    const dvec2 point = *lines.point;
    const bool current = role == Role::current, inside = panel_.shown().holds(point);
    for (const Line& line : lines.all) {
      const dvec2 from = glm::distance(line.a, point) < glm::distance(line.b, point) ? line.a : line.b;
      const dvec2 to = inside ? point : last_inside(panel_.shown(), from, point - from);
      Stroke stroke{panel_.at(from), panel_.at(to), false, true};
      stroke.thin = true;
      view.add({line.goes_on, current ? Role::current : Role::guide, stroke});
    }
    if (!current && lines.id == "direction") add_lines(view, lines, Role::past);
    if (!inside) return;
    const std::string id = fmt::format("e point {}", at);
    view.add_named(id, "f name " + id, current ? Role::current : Role::result, panel_.at(point),
                   words_.say("vanishing_point_of", {{"axis", lines.name}}));
  }

  const Words& words_;
  const TurnedBox& box_;
  const glm::dmat4 matrix_;
  const std::optional<int> by_plane_;
  std::vector<Lines> lines_;  ///< of x, y, z, and of the direction given
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
};

/// find(matrix, direction, observer): what the method does with a direction.
template <class Find>
void tell_directions(Narrator& narrator, std::optional<int> by_plane, const Find& find) {
  const TurnedBox box = box_of(narrator.arguments());
  say_turn(narrator, "subtitle.box");
  narrator.paper(solids::paper_width, paper_height);
  narrator.columns({{"axis", false}, {"direction", false}, {"w"}, {"vanishing_point", false}});
  narrator.legend({{Role::input, "box"}, {Role::current, "direction"}, Role::result});
  VanishingStory story(narrator.words(), box, by_plane);
  const dvec3 at = vector_of(narrator.arguments(), "at");
  const dvec3 nearest = *std::ranges::min_element(box.solid.corners, {}, &dvec3::z);
  narrator.handles("at", [&](dvec3 p) -> std::optional<dvec2> {
    const std::optional<dvec3> image = project(box.d, nearest + (p - at));
    return image ? std::optional(story.panel().at(dvec2(*image))) : std::nullopt;
  });
  narrator.tell_each(story, story.count(), [&](std::size_t, const auto& watch) {
    find(story.matrix(), story.lines().direction, watch);
  });
  std::vector<Field> result{{"vanishing_points", story.vanishing_axes()}};
  if (box.own != dvec3{0}) result.push_back({"direction_vanishes", story.lines().point.has_value()});
  narrator.result(std::move(result));
}

}  // namespace

void tell_vanishing_points(Narrator& narrator) {
  tell_directions(narrator, {}, [](const glm::dmat4& matrix, dvec3 direction, const auto& watch) {
    vanishing_point(matrix, direction, watch);
  });
}

void tell_parallel_by_plane(Narrator& narrator) {
  const int call = narrator.trace().listing.back().number;
  tell_directions(narrator, call, [](const glm::dmat4& matrix, dvec3 direction, const auto& watch) {
    parallel_by_plane(matrix, direction, watch);
  });
  narrator.add_to_legend(Role::rejected, "missed");
}

}  // namespace gradus::perspective
