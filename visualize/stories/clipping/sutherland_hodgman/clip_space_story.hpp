#pragma once
// A polygon of homogeneous points and the planes of clip space, before the division by w: told for the story
// of polygon clipping. Above, the plane of w and the coordinate that is cut, where the sides of the view
// volume are lines through the eye; below it what the division makes of what is left.

#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "stories/clipping/sutherland_hodgman/drawing.hpp"
#include "stories/telling.hpp"

namespace gradus::sutherland_hodgman {

using glm::dvec4;

/// A point's coordinates, what rounding has left where exact arithmetic says 0 as 0.
inline std::string place_text(const dvec4& p) {
  const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(p.w)});
  return figure_place(p, [size](double number) { return figure_real(number, 0x1p-40 * size); });
}

/// A corner with what it is called.
struct NamedPoint {
  std::string name;
  dvec4 at;
};

/// Tells the steps of `clip` in clip space.
class ClipSpaceStory {
 public:
  static constexpr int paper_width = 21, paper_height = 30;

  ClipSpaceStory(const Words& words, const std::vector<Point<double>>& corners)
      : words_(words),
        side_(side_place, side_world(corners)),
        picture_(picture_place, picture_world(corners)),
        axis_(most_telling_axis(corners)),
        telling_axis_(axis_) {
    for (const Point<double>& corner : corners) {
      given_.push_back({fmt::format("{}", given_.size() + 1), corner.at});
    }
    rest_ = given_;
  }

  /// Where a corner stands on the side of the current plane, at first the most telling one.
  dvec2 in_side(const dvec4& p) const { return side_.at({p.w, p[axis_]}); }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    Event event{.text = "space_started", .level = Level::idea};
    const auto behind = std::ranges::find_if(given_, [](const NamedPoint& p) { return p.at.w <= 0; });
    if (behind == given_.end()) return event;
    event.text = behind->at.w < 0 ? "space_started_behind" : "space_started_eye";
    event.words = {{"corner", behind->name}, {"value", behind->at.w}};
    if (behind->at.w < 0) event.words.push_back({"wrong", dvec2(behind->at) / behind->at.w});
    return event;
  }

  void show(Board& board, const Tested<double>& t) {
    if (!plane_ || passed_) enter(t.plane);
    tested_ = t;
    row_ = row_of(t);
    sides_.push_back(t.inside);
    here_ = t.at;
    put(board);
  }
  Event say(const Tested<double>& t) const {
    const std::string corner = rest_[t.corner].name, value = figure_real(distance(t.plane, t.at));
    return {.text = t.inside ? "plane_tested.inside" : "plane_tested.outside",
            .facts = fields(t.plane, t.at),
            .words = {{"corner", corner},
                      {"test", test_text(t.plane)},
                      {"numbers", numbers_text(t.plane, t.at)},
                      {"plane", plane_text(t.plane)}},
            .row = row_,
            .phase = phase_of(t.plane),
            .decides = yes_or_no(words_, "question.plane", {{"test", test_text(t.plane)}, {"value", value}},
                                 t.inside, "inside", "outside")};
  }

  void show(Board& board, const Cut<double>& c) {
    made_ = {letter(letters_++), c.at};
    kept_.push_back(made_);
    row_ = {plane_text(c.plane), made_.name, distance(c.plane, c.at), made_.name};
    edge_ = {c.inside, c.outside};
    here_ = c.at;
    put(board);
    edge_.reset();
  }
  Event say(const Cut<double>& c) const {
    const bool enters = tested_->inside;
    const std::size_t n = rest_.size();
    const std::string before = rest_[(tested_->corner + n - 1) % n].name, now = rest_[tested_->corner].name;
    const double to = distance(c.plane, c.outside);
    Event event{.text = "plane_cut",
                .facts = fields(c.plane, c.at),
                .words = {{"from", enters ? now : before},
                          {"to", enters ? before : now},
                          {"a", distance(c.plane, c.inside)},
                          {"b", to < 0 ? fmt::format("({})", figure_real(to)) : figure_real(to)},
                          {"t", c.t},
                          {"name", made_.name},
                          {"at", place_text(c.at)},
                          {"plane", plane_text(c.plane)}},
                .row = row_,
                .phase = phase_of(c.plane),
                .decides = yes_or_no(words_, "question.plane_cut",
                                     {{"from", before}, {"to", now}, {"plane", plane_text(c.plane)}}, true,
                                     enters ? "enters" : "leaves")};
    return event;
  }

  void show(Board& board, const CornerKept<double>& k) {
    const NamedPoint& corner = rest_[k.corner];
    kept_.push_back(corner);
    row_.back() = row_.back().text.empty() ? corner.name : row_.back().text + ", " + corner.name;
    here_ = corner.at;
    board.detail(view());
  }
  Event say(const CornerKept<double>& k) const {
    return {.text = "kept",
            .words = {{"corner", rest_[k.corner].name}},
            .count = std::ssize(kept_),
            .read = row_,
            .phase = phase_of(k.plane)};
  }

  void show(Board& board, const Passed<double>&) {
    const bool was_behind = any_behind(rest_);
    rest_ = std::exchange(kept_, {});
    came_to_front_ = was_behind && !any_behind(rest_);
    sides_.clear();
    here_.reset();
    passed_ = true;
    put(board);
  }
  Event say(const Passed<double>& p) const {
    const auto left = static_cast<std::int64_t>(p.corners);
    Event event{.text = "plane_empty",
                .facts = {{"corners", left}},
                .words = {{"plane", plane_text(p.plane)}},
                .phase = phase_of(p.plane),
                .level = Level::idea,
                .decides = yes_or_no(words_, "question.left", {}, left > 0, "accepted", "rejected")};
    if (left == 0) return event;
    event.text = came_to_front_ ? "plane_passed_front" : "plane_passed";
    event.count = left;
    return event;
  }

  /// The last step: the division.
  void show(Board& board, const steps::Finished&) {
    plane_.reset();
    here_.reset();
    done_ = true;
    axis_ = telling_axis_;
    put(board);
  }
  Event say(const steps::Finished&) const {
    if (rest_.empty()) return {.text = "divided_nothing"};
    const bool all_divide = std::ranges::none_of(given_, [](const NamedPoint& p) { return p.at.w == 0; });
    return {.text = any_behind(rest_)                  ? "divided_eye"
                    : any_behind(given_) && all_divide ? "divided_last"
                                                       : "divided",
            .count = std::ssize(rest_)};
  }

 private:
  static constexpr Extent side_place{{3.2, 17.2}, {17.6, 27.8}}, picture_place{{5, 2.2}, {18.6, 13}};

  // --- What is shown of which plane

  static Extent side_world(std::span<const Point<double>> corners) {
    Extent world;
    double most = 0;
    world.add({0, 0});
    for (const auto& [at] : corners) {
      for (int i = 0; i < 3; ++i) {
        world.add({at.w, at[i]});
        most = std::max(most, std::abs(at[i]));
      }
    }
    // All coordinates alike, so that nothing jumps when another one is cut
    const double reach = std::max(1.1 * most, 0.6 * world.upper.x);
    for (const double y : {-reach, reach}) world.add({0.5 * reach, y});
    return widened(world, 0.015);
  }
  /// The picture, and where dividing first puts the corners, as far as that is near it.
  static Extent picture_world(std::span<const Point<double>> corners) {
    Extent world;
    for (const double c : {-1.0, 1.0}) world.add({c, c});
    for (const auto& [at] : corners) {
      if (at.w == 0) continue;
      world.add(glm::clamp(dvec2(at) / at.w, dvec2(-2.5), dvec2(2.5)));
    }
    return widened(world, 0.03);
  }
  /// The coordinate of the first plane that cuts; x where none does.
  static int most_telling_axis(const std::vector<Point<double>>& corners) {
    std::optional<int> axis;
    const auto watch = [&axis]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Cut<double>>) {
        if (!axis) axis = step.plane.axis;
      }
    };
    const auto planes = view_volume(1.0, 1.0);
    clip(corners, std::span<const Plane<double>>(planes), watch);
    return axis.value_or(0);
  }
  static bool any_behind(std::span<const NamedPoint> polygon) {
    return std::ranges::any_of(polygon, [](const NamedPoint& p) { return p.at.w <= 0; });
  }

  // --- Words

  /// "x = −w", "z = 0".
  std::string plane_text(const Plane<double>& plane) const {
    const std::string limit = plane.bound == 0 ? "0" : (plane.sign > 0 ? "−" : "") + words_.symbol("w");
    return fmt::format("{} = {}", words_.axis(plane.axis), limit);
  }
  /// "w + x", "z".
  std::string test_text(const Plane<double>& plane) const {
    if (plane.bound == 0) return words_.axis(plane.axis);
    return fmt::format("{} {} {}", words_.symbol("w"), plane.sign > 0 ? "+" : "−", words_.axis(plane.axis));
  }
  /// " = −1 − 0.5" of "w − x = −1 − 0.5 = −1.5"; nothing where there is nothing to compute.
  std::string numbers_text(const Plane<double>& plane, const dvec4& p) const {
    if (plane.bound == 0) return "";
    return fmt::format(" = {} {} {}", figure_real(p.w), plane.sign > 0 ? "+" : "−",
                       figure_factor(p[plane.axis]));
  }
  std::string phase_of(const Plane<double>& plane) const {
    return words_.say("phase.plane", {{"plane", plane_text(plane)}});
  }
  /// What is kept of it is told when it is kept.
  std::vector<Said> row_of(const Tested<double>& t) const {
    return {plane_text(t.plane), rest_[t.corner].name, distance(t.plane, t.at), ""};
  }
  static std::vector<Field> fields(const Plane<double>& plane, const dvec4& p) {
    return {
        {"axis", plane.axis}, {"value", distance(plane, p)}, {"x", p.x}, {"y", p.y}, {"z", p.z}, {"w", p.w}};
  }

  // --- Drawing

  /// At a plane's first step.
  void enter(const Plane<double>& plane) {
    plane_ = plane;
    axis_ = plane.axis;
    passed_ = false;
  }
  View view() const {
    View drawn;
    add_side(drawn);
    add_picture(drawn);
    return drawn;
  }
  void put(Board& board) const { board.milestone(view()); }

  std::vector<dvec2> in_side(std::span<const NamedPoint> polygon) const {
    std::vector<dvec2> points;
    for (const NamedPoint& p : polygon) points.push_back(in_side(p.at));
    return points;
  }

  /// The plane of w and a coordinate: w to the right, the eye where the axes meet.
  void add_side(View& view) const {
    const Extent shown = side_.shown();
    const dvec2 eye = side_.at({0, 0}), lower = side_place.lower, upper = side_place.upper;
    const std::string w = words_.symbol("w"), name = words_.axis(axis_);
    if (lower.x < eye.x) {
      view.add({"a behind", Role::rejected, Area{{Extent{lower, {eye.x, upper.y}}.corners()}}});
      view.add(
          {"a behind name", Role::rejected, Text{{0.4, lower.y - 1}, words_.say("behind"), Align::left}});
    }
    view.add({"a w", Role::guide, Stroke{{lower.x, eye.y}, {upper.x + 0.9, eye.y}, true}});
    view.add({"a w name", Role::guide, Text{{upper.x + 1.6, eye.y}, w}});
    view.add({"a axis", Role::guide, Stroke{{eye.x, lower.y}, {eye.x, upper.y + 0.9}, true}});
    view.add({"a axis name", Role::guide, Text{{eye.x + 1.1, upper.y + 0.8}, name}});
    // The view volume between two lines through the eye
    const double far = shown.upper.x;
    const auto at_side = [&](const Plane<double>& p) { return dvec2{1, -p.sign * p.bound}; };
    std::vector<dvec2> wedge{eye};
    for (const Plane<double>& plane : view_volume(1.0, 1.0)) {
      if (plane.axis != axis_) continue;
      const bool now = plane_ && plane_->axis == plane.axis && plane_->sign == plane.sign && !passed_;
      const dvec2 way = at_side(plane);
      const double reach =
          way.y == 0 ? far : std::min(far, std::abs(way.y > 0 ? shown.upper.y : shown.lower.y));
      const dvec2 end = side_.at(reach * way);
      wedge.push_back(end);
      const std::string id = fmt::format("b plane {}", plane.sign > 0 ? "lower" : "upper");
      view.add({id, now ? Role::current : Role::boundary, Stroke{eye, end}});
      view.add({id + " name", now ? Role::current : Role::boundary,
                Label{0.12 * eye + 0.88 * end, plane_text(plane)}});
      if (!now) continue;
      // Behind the eye, too, the plane has an inside
      const double back = way.y == 0
                              ? -shown.lower.x
                              : std::min(-shown.lower.x, std::abs(way.y > 0 ? shown.lower.y : shown.upper.y));
      if (back > 0)
        view.add({id + " behind", Role::current, Stroke{eye, side_.at(-back * way), false, true}});
    }
    view.add({"a wedge", Role::accepted, Area{{wedge}}});
    add_polygon(view);
  }

  void add_polygon(View& view) const {
    view.add({"c given", Role::input, Path{in_side(given_), true, plane_ || done_}});
    if (!rest_.empty() && (plane_ || done_)) {
      const bool being_cut = plane_ && !passed_;
      view.add({"c rest",
                done_       ? Role::result
                : being_cut ? Role::past
                            : Role::accepted,
                Path{in_side(rest_), true}});
    }
    if (kept_.size() > 1) view.add({"d kept", Role::accepted, Path{in_side(kept_)}});
    if (edge_)
      view.add({"f edge", Role::current, Stroke{in_side(edge_->first), in_side(edge_->second), true}});
    const auto corner = [&](const NamedPoint& p, Role role, bool ring) {
      view.add({"e dot " + p.name, role, Dot{in_side(p.at), ring}});
      if (rest_.size() > 24) return;
      const bool now = here_ && *here_ == p.at;
      view.add({"g name " + p.name, now ? Role::current : role, Label{in_side(p.at), p.name}});
    };
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const bool tested = i < sides_.size();
      const Role role = done_                           ? Role::result
                        : !tested && plane_ && !passed_ ? Role::past
                        : !tested                       ? Role::accepted
                        : sides_[i]                     ? Role::accepted
                                                        : Role::rejected;
      corner(rest_[i], plane_ || done_ ? role : Role::input, tested && !sides_[i]);
    }
    for (const NamedPoint& p : kept_) corner(p, Role::accepted, false);
    if (here_) view.add({"h here", Role::current, Dot{in_side(*here_), !edge_}});
  }

  /// What can be divided, divided.
  std::vector<dvec2> divided(std::span<const Point<double>> polygon) const {
    std::vector<dvec2> points;
    for (const auto& [at] : polygon) {
      if (at.w > 0) points.push_back(picture_.at(dvec2(at) / at.w));
    }
    return points;
  }

  /// The picture: what the eye really sees of what is left, and what dividing first would draw.
  void add_picture(View& view) const {
    view.add({"p caption", Role::guide,
              Text{{0.5 * (picture_place.lower.x + picture_place.upper.x), picture_place.upper.y + 1.5},
                   words_.say("picture")}});
    const std::string w = words_.symbol("w");
    add_axes(view, picture_, "p axes", {words_.axis(0) + "/" + w, words_.axis(1) + "/" + w}, 4);
    view.add({"p window", Role::boundary, Path{picture_.at(Extent{{-1, -1}, {1, 1}}.corners()), true}});
    if (plane_ && !passed_ && plane_->axis < 2) {
      const Extent shown = picture_.shown();
      const int axis = plane_->axis;
      dvec2 from = shown.lower, to = shown.upper;
      from[axis] = to[axis] = -plane_->sign;
      view.add({"p plane", Role::current, Stroke{picture_.at(from), picture_.at(to), false, true}});
    }
    add_wrong_picture(view);
    // As much of the true picture as there is room for
    const Extent shown = picture_.shown();
    const std::array<Plane<double>, 4> room{
        {{0, 1, -shown.lower.x}, {0, -1, shown.upper.x}, {1, 1, -shown.lower.y}, {1, -1, shown.upper.y}}};
    std::vector<Point<double>> polygon;
    for (const NamedPoint& p : rest_) polygon.push_back({p.at});
    const auto seen = divided(clip(polygon, std::span<const Plane<double>>(room)));
    const Role role = done_ ? Role::result : Role::accepted;
    if (seen.size() >= 3) {
      view.add({"p seen", role, Area{{seen}}});
      const bool all_shown = std::ranges::all_of(rest_, [&shown](const NamedPoint& p) {
        const dvec2 at = dvec2(p.at) / p.at.w;
        return p.at.w > 0 && shown.holds(at);
      });
      if (all_shown) view.add({"p outline", role, Path{seen, true}});
    }
    for (const NamedPoint& p : rest_) {
      if (p.at.w <= 0 || rest_.size() > 24) continue;
      const dvec2 at = dvec2(p.at) / p.at.w;
      if (shown.holds(at))
        view.add_named("q dot " + p.name, "q name " + p.name, role, picture_.at(at), p.name);
    }
  }

  void add_wrong_picture(View& view) const {
    if (!any_behind(given_)) return;
    std::vector<dvec2> wrong;
    const Extent shown = picture_.shown();
    for (const NamedPoint& p : given_) {
      if (p.at.w == 0) return;
      const dvec2 at = dvec2(p.at) / p.at.w;
      wrong.push_back(picture_.at(glm::clamp(at, shown.lower, shown.upper)));
      if (p.at.w > 0 || !shown.holds(at)) continue;
      view.add_named("r wrong " + p.name, "r wrong name " + p.name, Role::rejected, wrong.back(),
                     words_.say("divided_first", {{"corner", p.name}}), true);
    }
    view.add({"r wrong", Role::rejected, Path{wrong, true, true}});
  }

  const Words& words_;
  const Panel side_, picture_;
  std::vector<NamedPoint> given_, rest_, kept_;
  std::vector<bool> sides_;  ///< of the corners tested so far at this plane
  std::optional<Plane<double>> plane_;
  std::optional<Tested<double>> tested_;  ///< the last one
  std::vector<Said> row_;                 ///< of it, or of its cut
  std::optional<dvec4> here_;
  std::optional<std::pair<dvec4, dvec4>> edge_;
  NamedPoint made_;
  std::size_t letters_ = 0;
  int axis_, telling_axis_;
  bool passed_ = false, done_ = false, came_to_front_ = false;
};

}  // namespace gradus::sutherland_hodgman
