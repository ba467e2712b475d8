// What the viewer can see: the eight corners of the frustum from both angles of view, and the box that the
// transformation makes of it.

#include "core/arithmetic/elementary.hpp"
#include "stories/past.hpp"
#include "stories/projection/perspective/stories.hpp"

namespace gradus::perspective {
namespace {

struct FrustumSubject {
  dvec2 degrees{}, tangents{};  ///< the angles of view; of half of them
  double near, far;

  std::array<dvec3, 8> corners() const { return frustum_corners(tangents.x, tangents.y, near, far); }
  dvec3 image(dvec3 corner) const {
    return *divide_tested(projection_of(1 / tangents.x, 1 / tangents.y, near, far), corner);
  }
};

/// The tangent of half an angle of view.
double half_tangent(double degrees) { return gradus::tan(radians_from_degrees(degrees / 2)); }

FrustumSubject subject_of(const Arguments& arguments) {
  const std::vector<double> fields = arguments.numbers("fields");
  FrustumSubject subject{
      .degrees = {fields[0], fields[1]}, .near = distance_of(arguments), .far = *arguments.number("far")};
  for (const int axis : {0, 1}) {
    if (!(1 <= subject.degrees[axis] && subject.degrees[axis] <= 160))
      refuse("fields", "expected angles of view from 1 to 160 degrees, found {}", subject.degrees[axis]);
    subject.tangents[axis] = half_tangent(subject.degrees[axis]);
  }
  if (!(subject.near < subject.far))
    refuse(arguments, {"far", "distance"}, "expected a far plane behind the near one");
  return subject;
}

class FrustumStory : public Past<steps::Started, CornerFound<double>, steps::Finished> {
 public:
  FrustumStory(const Words& words, const FrustumSubject& subject)
      : words_(words), subject_(subject), corners_(subject.corners()) {
    for (const dvec3 p : corners_) {
      frustum_.corners.push_back(p);
      const dvec3 image = subject.image(p);
      box_.corners.emplace_back(image.x, image.y, 2 * image.z);  // as deep as it is wide
    }
    for (solids::Solid* body : {&frustum_, &box_}) {
      body->faces = faces_of_box();
      *body = solids::with_edges(std::move(*body));
    }
    space_ = Panel({{1.2, 0.8}, {23.5, 21}}, extent_of(frustum_, true));
    beside_ = Panel({{26.5, 0.8}, {34.5, 21}}, extent_of(box_, false));
  }

  dvec2 in_space(dvec3 p) const { return space_.at(solids::from_right(p)); }

  Event say(const steps::Started&) const {
    return {.text = "started.frustum",
            .words = {{"across", real(subject_.degrees.x)},
                      {"up", real(subject_.degrees.y)},
                      {"near", real(subject_.near)},
                      {"far", real(subject_.far)}},
            .level = Level::idea};
  }

  Event say(const CornerFound<double>& c) const {
    const dvec3 image = subject_.image(c.corner);
    return {.text = "corner",
            .facts = {{"corner", c.number + 1}, {"x", c.corner.x}, {"y", c.corner.y}, {"z", c.corner.z}},
            .words = {{"z", real(c.corner.z)},
                      {"half_across", real(subject_.degrees.x / 2)},
                      {"half_up", real(subject_.degrees.y / 2)},
                      {"width", real(c.width)},
                      {"height", real(c.height)},
                      {"point", place_text(c.corner)}},
            .row = {c.number + 1, place_text(c.corner), place_text(image)},
            .key = fmt::format("{}", c.number)};
  }

  Event say(const steps::Finished&) const {
    return {.text = "done.frustum",
            .words = {{"times", real(subject_.far / subject_.near)},
                      {"x", real(subject_.near * subject_.tangents.x)},
                      {"y", real(subject_.near * subject_.tangents.y)}}};
  }

  View draw() const {
    View view;
    view.add({"caption space", Role::guide, Text{{12.4, 22.6}, words_.say("caption.frustum")}});
    view.add({"caption box", Role::guide, Text{{30.5, 22.6}, words_.say("caption.box")}});
    add_sight(view);
    add_body(view, "frustum", frustum_, space_);
    add_body(view, "box", box_, beside_);
    for (const bool far : {false, true}) add_depth(view, far);
    for (const auto& found : all<CornerFound<double>>())
      add_corner(view, static_cast<std::size_t>(found.number), &found == now<CornerFound<double>>());
    if (const auto* found = now<CornerFound<double>>()) add_halves(view, found->corner);
    return view;
  }

 private:
  static Extent extent_of(const solids::Solid& body, bool with_eye) {
    Extent extent;
    for (const dvec3 p : body.corners) extent.add(solids::from_right(p));
    if (with_eye) extent.add(solids::from_right(dvec3{0}));
    return extent;
  }
  dvec2 in_box(std::size_t i) const { return beside_.at(solids::from_right(box_.corners[i])); }

  /// The eye, and the way it looks.
  void add_sight(View& view) const {
    const dvec2 eye = in_space(dvec3{0});
    view.add({"a sight", Role::guide, Stroke{eye, in_space({0, 0, subject_.far}), false, true, true}});
    for (std::size_t i = 0; i < 4; ++i)
      view.add(
          {fmt::format("a ray {}", i), Role::guide, Stroke{eye, in_space(corners_[i]), false, true, true}});
    view.add({"e eye", Role::input, Dot{eye}});
    view.add({"e eye name", Role::input, Text{eye - dvec2{0, 1.3}, words_.shared("projection", "eye")}});
  }
  /// Faces that are seen, and edges, dashed where they are hidden.
  static void add_body(View& view, const std::string& id, const solids::Solid& body, const Panel& panel) {
    const solids::Facing facing = solids::facing_along(body, solids::looking_from_right);
    const auto at = [&](std::size_t i) { return panel.at(solids::from_right(body.corners[i])); };
    for (std::size_t i = 0; i < body.faces.size(); ++i) {
      if (!facing.seen[i]) continue;
      std::vector<dvec2> ring;
      for (const std::size_t corner : body.faces[i]) ring.push_back(at(corner));
      const dvec3 n = solids::outward(body, i);
      view.add({fmt::format("b {} face {}", id, i), Role::boundary, Area{{ring}, shade_of({n.z, n.y, n.x})}});
    }
    for (std::size_t i = 0; i < body.edges.size(); ++i) {
      Stroke stroke{at(body.edges[i].a), at(body.edges[i].b), false, facing.hidden[i]};
      stroke.thin = stroke.dashed;
      view.add({fmt::format("c {} edge {:02}", id, i), Role::boundary, stroke});
    }
  }
  /// The depth of a plane: far below its lowest corner, near above its highest.
  void add_depth(View& view, bool far) const {
    const std::string depth = real(far ? subject_.far : subject_.near);
    const std::string_view key = far ? "depth.far" : "depth.near";
    const dvec2 above{0.4, in_space(corners_[2]).y + 2}, below = in_space(corners_[5]) - dvec2{0, 1.1};
    view.add({fmt::format("g {}", key), Role::guide,
              Text{far ? below : above, words_.say(key, {{"z", depth}}), far ? Align::centre : Align::left}});
  }
  void add_corner(View& view, std::size_t i, bool current) const {
    const Role role = current ? Role::current : Role::result;
    const std::string name = fmt::format("{}", i + 1);
    view.add_named("f corner " + name, role, in_space(corners_[i]), name);
    view.add_named("f image " + name, role, in_box(i), name + "′");
  }
  /// Half the width and half the height of the corner's rectangle.
  void add_halves(View& view, dvec3 corner) const {
    const dvec2 middle = in_space({0, 0, corner.z}), side = in_space({corner.x, 0, corner.z}),
                end = in_space(corner);
    view.add({"d across", Role::measure, Stroke{middle, side}});
    view.add({"d up", Role::measure, Stroke{side, end}});
    view.add({"g across", Role::measure, Label{0.5 * (middle + side), real(std::abs(corner.x))}});
    view.add({"g up", Role::measure, Label{0.5 * (side + end), real(std::abs(corner.y))}});
  }

  const Words& words_;
  const FrustumSubject& subject_;
  std::array<dvec3, 8> corners_;
  solids::Solid frustum_, box_;
  Panel space_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}}, beside_ = space_;
};

/// A corner of each plane for its depth, and one for both angles.
void let_drag(Narrator& narrator, const FrustumSubject& subject, const FrustumStory& story) {
  const auto drag_depth = [&](std::string_view name, double depth, dvec3 corner) {
    narrator.handle(name, 0, story.in_space(corner),
                    story.in_space(corner / depth) - story.in_space(dvec3{0}));
  };
  const auto [across, up] = std::pair{subject.tangents.x, subject.tangents.y};
  drag_depth("distance", subject.near, subject.near * dvec3{across, up, 1});
  drag_depth("far", subject.far, subject.far * dvec3{across, -up, 1});
  narrator.handles("fields", [&](dvec2 degrees) {
    return story.in_space(subject.far * dvec3{half_tangent(degrees.x), half_tangent(degrees.y), 1});
  });
}

}  // namespace

void tell_frustum(Narrator& narrator) {
  const FrustumSubject subject = subject_of(narrator.arguments());
  narrator.subtitle("subtitle.frustum", {{"across", real(subject.degrees.x)},
                                         {"up", real(subject.degrees.y)},
                                         {"near", real(subject.near)},
                                         {"far", real(subject.far)}});
  narrator.trace().goal = narrator.words().say("goal.frustum");
  narrator.paper(solids::paper_width, solids::paper_height);
  narrator.columns({{"corner"}, {"point", false}, {"image", false}});
  narrator.legend({{Role::boundary, "frustum"},
                   {Role::current, "corner"},
                   {Role::result, "corners"},
                   {Role::measure, "halves"}});
  FrustumStory story(narrator.words(), subject);
  let_drag(narrator, subject, story);
  narrator.tell_whole(story, [&](const auto& watch) {
    frustum_corners(subject.tangents.x, subject.tangents.y, subject.near, subject.far, watch);
  });
  narrator.telling({8, 0});
  narrator.result({{"corners", 8}});
}

}  // namespace gradus::perspective
