#pragma once
// What a view is about, and how it is drawn: the world with the viewer's axes, and beside it what they see.

#include "core/geometry.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewing/viewing_notes.hpp"
#include "scene/models/obj.hpp"
#include "stories/rings.hpp"
#include "stories/space_drawing.hpp"
#include "stories/telling.hpp"

namespace gradus::viewing {

using DFrame = Frame<double>;

// block_story.cpp
void tell_block(Narrator& narrator);

constexpr std::array<std::string_view, 3> axis_names{"right", "up", "forward"};
constexpr std::array world_axes{std::pair{"x", dvec3{1, 0, 0}}, std::pair{"y", dvec3{0, 1, 0}},
                                std::pair{"z", dvec3{0, 0, 1}}};

/// What the reader calls the directions right, up and forward.
inline std::string direction_name(const Words& words, int number) {
  const std::string own = words.say(fmt::format("name.{}", axis_names[static_cast<std::size_t>(number)]));
  return number == 2 ? words.notation().forward_name(own) : words.notation().axis_name(number, own);
}
/// The same of the axes of view space: the third one may point backward.
inline std::string axis_name(const Words& words, int number) {
  const std::string own = words.say(fmt::format("name.{}", axis_names[static_cast<std::size_t>(number)]));
  return words.notation().axis_name(number, own);
}

/// Of coordinates: farther away the letter is a dot, and numbers don't fit.
constexpr Sizes coordinate_sizes{1e-100, 1e6};

/// Axes that are much shorter or longer don't fit into a drawing with the letter.
constexpr double longest_axis = 1000;

/// What is made of a hint for up along the view.
enum class Along { refused, replaced, divided };

struct Subject {
  dvec3 eye, target, up;
  double distance;  ///< from the eye to the target
  Mesh letter;
  std::optional<DFrame> axes{};  ///< given ones, of any lengths and angles, instead of target and up
  Along along = Along::refused;

  /// The frame at the eye.
  DFrame frame() const {
    return axes ? *axes : aimed([](const auto&) {});
  }
  /// The same, watched.
  template <class O>
  DFrame aimed(O&& observer) const {
    if (along == Along::replaced) return spare_up(eye, target, up, observer);
    if (along == Along::divided) return cross_products(eye, target, up, observer);
    return look_at(eye, target, up, observer);
  }
};

inline Mesh shipped_letter() {
  const auto open = [](const std::string& name) { return std::optional(std::string(shipped_model(name))); };
  return pipeline::parse_obj(shipped_model("letter_f.obj"), "letter_f.obj", open).mesh;
}

/// An eye with three axes of any lengths and angles.
inline Subject subject_of_axes(const Arguments& arguments) {
  const dvec3 eye = *arguments.place("eye");
  const auto axes = arguments.places("axes");
  const auto expect = [&](bool holds, const std::string& what) {
    if (!holds) refuse("axes", "{} expected, found {}", what, arguments.text("axes"));
  };
  for (const dvec3 axis : axes) {
    const double length = length_of(axis);
    expect(1 / longest_axis <= length && length <= longest_axis,
           fmt::format("axes of lengths from {} to {}", 1 / longest_axis, longest_axis));
  }
  const DFrame frame{eye, axes[0], axes[1], axes[2]};
  const auto [x, y, z] = Rescaled<double>(frame).scaled;
  expect(std::abs(glm::dot(x, glm::cross(y, z))) > 1e-6, "three axes that don't lie in one plane");
  const dvec3 middle{0.4, 0.6, 0};  // of the letter
  return {eye, middle, {0, 1, 0}, std::max(1.0, length_of(middle - eye)), shipped_letter(), frame};
}

inline Subject subject_of(const Arguments& arguments, Along along) {
  Subject subject{*arguments.place("eye"), *arguments.place("target"), *arguments.place("up"), 0, {}};
  subject.along = along;
  if (subject.eye == subject.target)
    refuse(arguments, {"target", "eye"}, "a target apart from the eye expected, found both in one point");
  if (subject.up == dvec3{0})
    refuse(arguments, {"up"}, "a direction expected, found 0,0,0, which points nowhere");
  const double sine = sine_between(subject.target - subject.eye, subject.up);
  if (along == Along::divided && !is_finite(subject.frame().right))
    refuse(arguments, {"up", "target", "eye"},
           "a hint for up that leaves something to divide by expected, this one gives 0 / 0");
  if (along == Along::refused && !(sine >= least_sine<double>)) {
    refuse(arguments, {"up", "target", "eye"},
           fmt::format("an up apart from the view direction expected, found {}, which is parallel to it",
                       arguments.text("up")));
  }
  subject.distance = length_of(subject.target - subject.eye);
  subject.letter = shipped_letter();
  return subject;
}

// --- The drawing

/// Two panels on a paper of 36 x 24: the world, and what the viewer makes of it.
inline const Extent world_place{{0.6, 0.4}, {19, 22}};
inline const Extent seen_place{{20.3, 4}, {35.3, 19}};

/// For given axes: these beside the letter in the world, or twice, for two hands; at last the letter along
/// them and in the world.
inline const Extent axes_place{{3, 0.8}, {20, 22}}, letter_place{{25, 1.6}, {35.2, 21}};
inline const Extent left_hand_place{{2.2, 0}, {15.4, 17}}, right_hand_place{{21.8, 0}, {35, 17}};
inline const Extent along_place{{0.8, 1}, {16, 21.6}}, back_place{{20, 1}, {35.2, 21.6}};

/// A direction's reverse along z: what is right-handed becomes left-handed.
inline dvec3 mirrored(dvec3 p) { return {p.x, p.y, 0 - p.z}; }

/// Whether right × up points forward, as in a world whose z runs away from the reader.
inline bool is_left_hand(const DFrame& frame) {
  const auto [right, up, forward] = Rescaled<double>(frame).scaled;
  return glm::dot(forward, glm::cross(right, up)) > 0;
}

/// What a matrix makes of a point.
inline dvec3 through(const glm::dmat4& matrix, dvec3 p) { return dvec3(matrix * glm::dvec4(p, 1)); }

/// The drawings of a run. What is known grows from step to step.
class Drawing {
 public:
  Drawing(const Subject& subject, const Words& words)
      : subject_(subject),
        words_(words),
        edges_(edges_of(subject.letter)),
        left_handed_(subject.axes && is_left_hand(*subject.axes)),
        world_(left_handed_   ? left_hand_place
               : subject.axes ? axes_place
                              : world_place,
               world_extent()) {}

  /// Where the first drawing has a point of the world, the end of the hint for up, and that of a given axis.
  dvec2 at(dvec3 p) const { return world_.at(flat(p)); }
  dvec2 hint_at(dvec3 up) const { return at(subject_.eye + axis_size() * unit_vector(up)); }
  dvec2 axis_at(dvec3 axis) const { return at(subject_.eye + arrow_unit(*subject_.axes) * axis); }

  /// How many axes of the frame are drawn, which of them is new (-1: none), and how much of the matrix.
  struct Known {
    std::array<bool, 3> axes{};
    int newest = -1;
    int rows = 0;       ///< of the matrix, from above
    bool seen = false;  ///< the model is drawn as the matrix has it
  };

  View world(const Known& known, const DFrame& frame) const {
    View view;
    caption(view, "world", {world_place.centre().x, world_place.upper.y + 1.2});
    SpaceDrawing space({.viewer = distant_viewer(towards_oblique),
                        .at = [this](dvec3 p) { return std::optional(world_.at(oblique(p))); },
                        .frame = world_place});
    space.add("letter world", Role::past, subject_.letter);
    add_world_axes(view, space);
    space.add(SpaceEdge{.id = "sight", .role = Role::guide, .a = subject_.eye, .b = subject_.target});
    add_camera(space);
    space.add_to(view, "a letter world");
    const double size = axis_size();
    if (!known.axes[1])
      arrow(view, "hint", Role::candidate, size * unit_vector(subject_.up), words_.say("hint"), true);
    for (int i = 0; i < 3; ++i) {
      if (!known.axes[static_cast<std::size_t>(i)]) continue;
      const std::string name(axis_names[static_cast<std::size_t>(i)]);
      arrow(view, "axis " + name, i == known.newest ? Role::current : Role::accepted,
            size * shown_axis(frame, i), axis_name(words_, i), false);
    }
    point(view, "eye", Role::input, subject_.eye, words_.say("name.eye"));
    point(view, "target", Role::input, subject_.target, words_.say("name.target"));
    return view;
  }

  /// The picture: x / depth to the right, y / depth up; the letter in it once the matrix is whole.
  void add_picture(View& view, const Known& known, const glm::dmat4& matrix) const {
    caption(view, "picture", {seen_place.centre().x, seen_place.upper.y + 1.2});
    frame_of(view);
    const Panel panel(seen_place, picture_extent(matrix));
    const dvec2 middle = seen_place.centre(), reach = 0.42 * seen_place.size();
    if (known.rows >= 1) picture_axis(view, known, 0, {reach.x, 0});
    if (known.rows >= 2) picture_axis(view, known, 1, {0, reach.y});
    if (known.rows >= 1)
      guide_line(view, "no right", {middle.x, seen_place.lower.y}, {middle.x, seen_place.upper.y});
    if (known.rows >= 2)
      guide_line(view, "no up", {seen_place.lower.x, middle.y}, {seen_place.upper.x, middle.y});
    if (known.rows >= 3) {
      const dvec3 target = through(matrix, subject_.target);
      view.add_named("seen target", Role::accepted, panel.at(dvec2(target) / target.z),
                     words_.say("name.target"));
    }
    const auto seen = [&](dvec3 p) -> std::optional<dvec2> {
      const dvec3 v = through(matrix, p);
      if (v.z <= 0) return std::nullopt;
      return panel.at(dvec2(v) / v.z);
    };
    const DFrame frame = subject_.frame();
    SpaceDrawing picture({.viewer = viewer_at(subject_.eye),
                          .at = seen,
                          .right = frame.right,
                          .up = frame.up,
                          .towards = -frame.forward,
                          .frame = seen_place});
    picture.add("letter picture", known.seen ? Role::result : Role::past, subject_.letter);
    picture.add_to(view, "a letter picture");
  }

  /// View space from aside, where a faulty matrix leaves the letter: right to the right, up up, depth to the
  /// back.
  void add_view_space(View& view, const Known& known, const glm::dmat4& wrong,
                      const glm::dmat4& right) const {
    caption(view, "view_space", {seen_place.centre().x, world_place.upper.y + 1.2});
    const auto flat = [](dvec3 v) { return oblique({v.x, v.y, -v.z}); };
    Extent all;
    all.add(flat({0, 0, 0}));
    for (const dvec3 p : {subject_.eye, subject_.target}) all.add(flat(through(wrong, p)));
    const double size = axis_size();
    for (const dvec3 tip : {dvec3{size, 0, 0}, dvec3{0, size, 0}, dvec3{0, 0, subject_.distance}})
      all.add(flat(tip));
    const Extent place{{21, 1}, {34.5, 21.5}};
    const Panel panel(place, widened(all, 0.02));
    const auto at = [&](dvec3 v) { return panel.at(flat(v)); };
    const auto line = [&](const std::string& id, dvec3 tip, int axis) {
      add_arrow(view, id, Role::guide, at({0, 0, 0}), at(tip), direction_name(words_, axis));
    };
    line("space right", {size, 0, 0}, 0);
    line("space up", {0, size, 0}, 1);
    line("space forward", {0, 0, subject_.distance}, 2);
    view.add({"space eye", Role::input, Dot{at({0, 0, 0})}});
    if (!known.seen) return;
    const dvec3 there = through(wrong, subject_.target), here = through(right, subject_.target);
    const dvec3 eye = through(wrong, subject_.eye);
    view.add({"sight there", Role::rejected, Stroke{at(eye), at(there), false, true}});
    if (length_of(eye) > 1e-9 * subject_.distance)
      view.add_named("eye there", Role::rejected, at(eye), words_.say("name.eye"));
    view.add_named("target here", Role::accepted, at(here), words_.say("belongs"), true);
    view.add_named("target there", Role::rejected, at(there), words_.say("name.target"));
  }

  /// Given axes at the eye, and as many columns of the inverse as are known; at last where it leads.
  View given_axes(const Known& known, const DFrame& frame) const {
    View view;
    if (known.seen) {
      add_there_and_back(view, frame);
    } else if (left_handed_) {
      add_hands(view, known, frame);
    } else {
      caption(view, "axes", {axes_place.centre().x, axes_place.upper.y + 1.2});
      caption(view, "world", {letter_place.centre().x, axes_place.upper.y + 1.2});
      add_axes_and_columns(view, known, frame);
      add_letter(view, "world", Role::past, letter_place, [](dvec3 p) { return p; });
      add_tripod(view, "world", {letter_place.lower.x - 3, letter_place.lower.y + 1.2}, false);
    }
    return view;
  }

 private:
  /// The axes, the columns of the inverse, and between which axes the newest one is at right angles.
  void add_axes_and_columns(View& view, const Known& known, const DFrame& frame) const {
    const glm::dmat4 inverse = inverse_of_any_frame(frame);
    const double unit = arrow_unit(frame);
    if (known.newest >= 0) {
      const dvec3 a = unit * axis_of(frame, (known.newest + 1) % 3),
                  b = unit * axis_of(frame, (known.newest + 2) % 3);
      add_sheet(view, a, b);
    }
    for (int i = 0; i < 3; ++i) {
      const std::string name(axis_names[static_cast<std::size_t>(i)]);
      const dvec3 axis = axis_of(frame, i), column(inverse[i]);
      const Role found = i == known.newest ? Role::current : Role::accepted;
      const bool is_known = i < known.rows, is_both = is_known && length_between(axis, column) < 1e-9;
      arrow(view, "axis " + name, is_both ? found : Role::input, unit * axis, direction_name(words_, i),
            false);
      if (!is_known || is_both) continue;
      arrow(view, "column " + name, found, unit * column,
            words_.say("column_name", {{"axis", direction_name(words_, i)}}), true);
    }
    point(view, "eye", Role::input, subject_.eye, words_.say("name.eye"));
  }
  /// Part of the plane in which two directions from the eye lie.
  void add_sheet(View& view, dvec3 a, dvec3 b) const {
    std::vector<dvec2> ring;
    for (const dvec3 p : {dvec3{0}, a, a + b, b}) ring.push_back(world_.at(flat(subject_.eye + 0.8 * p)));
    view.add({"a sheet", Role::guide, Area{{ring}, 2}});
  }

  /// The same arrows in two worlds: in the one that is given z runs away from the reader.
  void add_hands(View& view, const Known& known, const DFrame& frame) const {
    add_axes_and_columns(view, known, frame);
    const double det = glm::dot(frame.forward, glm::cross(frame.right, frame.up));
    add_hand_caption(view, "left_handed", left_hand_place, frame.right, det);
    add_hand_caption(view, "right_handed", right_hand_place, mirrored(frame.right), 0 - det);
    const dvec2 aside = right_hand_place.lower - left_hand_place.lower;
    const dvec2 eye = world_.at(flat(subject_.eye)) + aside;
    for (int i = 0; i < 3; ++i) {
      const std::string name = fmt::format("twin {}", axis_names[static_cast<std::size_t>(i)]);
      const dvec3 axis = axis_of(frame, i);
      const dvec2 tip = world_.at(flat(subject_.eye + arrow_unit(frame) * axis)) + aside;
      add_arrow(view, name, Role::input, eye, tip, direction_name(words_, i));
    }
    view.add({"twin eye", Role::input, Dot{eye}});
  }
  /// Above one of the two: what it is, with the directions of its axes, and the numbers of right there.
  void add_hand_caption(View& view, const std::string& hand, const Extent& place, dvec3 right,
                        double det) const {
    const std::string lines[] = {words_.say("caption." + hand),
                                 words_.say("caption.determinant", {{"det", det}}),
                                 direction_name(words_, 0) + " = " + figure_place(right)};
    double y = axes_place.upper.y + 1.2;
    for (const std::string& line : lines) {
      view.add({fmt::format("caption {} {}", hand, y), Role::guide, Text{{place.centre().x, y}, line}});
      y -= 1.7;
    }
    add_tripod(view, hand, {place.upper.x - 3.6, place.upper.y - 4}, hand == "left_handed");
  }
  /// The directions of a world's axes.
  void add_tripod(View& view, const std::string& id, dvec2 origin, bool left_handed) const {
    constexpr double length = 2.6;
    for (const auto& [name, way] : world_axes) {
      const dvec2 tip = origin + length * oblique(left_handed ? mirrored(way) : way);
      add_arrow(view, fmt::format("{} {}", id, name), Role::guide, origin, tip, words_.symbol(name));
    }
  }

  /// The letter in coordinates along the axes, and in the world, where the inverse leads it back to.
  void add_there_and_back(View& view, const DFrame& frame) const {
    const glm::dmat4 matrix = world_to_view(frame), inverse = inverse_of_any_frame(frame);
    caption(view, "coordinates", {along_place.centre().x, axes_place.upper.y + 1.2});
    caption(view, "world", {back_place.centre().x, axes_place.upper.y + 1.2});
    // Depth is positive along the axes, and to the back
    add_letter(view, "along", Role::past, along_place, [&](dvec3 p) { return mirrored(through(matrix, p)); });
    add_letter(view, "back", Role::result, back_place,
               [&](dvec3 p) { return to_reader(through(inverse, through(matrix, p))); });
    const double y = along_place.centre().y;
    view.add({"leads back", Role::result,
              Stroke{{along_place.upper.x + 0.4, y}, {back_place.lower.x - 0.4, y}, true}});
  }

  /// The letter as a solid. at(p): where a point of it is drawn: right, up, towards the reader.
  template <class At>
  void add_letter(View& view, const std::string& name, Role role, const Extent& place, At at) const {
    Mesh letter = subject_.letter;
    Extent all;
    for (dvec3& p : letter.positions) {
      p = at(p);
      all.add(oblique(p));
    }
    if (mirrors(at)) turn_inside_out(letter);
    const Panel panel(place, widened(all, 0.02));
    SpaceDrawing space({.viewer = distant_viewer(towards_oblique),
                        .at = [&](dvec3 p) { return std::optional(panel.at(oblique(p))); }});
    space.add("letter " + name, role, letter);
    space.add_to(view, "a letter " + name);
  }
  template <class At>
  static bool mirrors(At at) {
    const dvec3 o = at(dvec3{0});
    const auto way = [&](dvec3 p) { return at(p) - o; };
    return glm::dot(way({1, 0, 0}), glm::cross(way({0, 1, 0}), way({0, 0, 1}))) < 0;
  }
  static void turn_inside_out(Mesh& mesh) {
    for (const MeshFace& face : mesh.faces) {
      const auto first = mesh.corners.begin() + static_cast<std::ptrdiff_t>(face.first);
      std::reverse(first, first + face.count);
    }
  }

  /// A point of the world as it is drawn: right, up, towards the reader.
  dvec3 to_reader(dvec3 p) const { return left_handed_ ? mirrored(p) : p; }
  dvec2 flat(dvec3 p) const { return oblique(to_reader(p)); }
  /// An axis of view space as the reader's notation has it.
  dvec3 shown_axis(const DFrame& frame, int number) const {
    const dvec3 axis = axis_of(frame, number);
    return number == 2 && words_.notation().looks_backward() ? dvec3(0) - axis : axis;
  }
  /// Paper lengths of given axes and the inverse's columns have one scale.
  double arrow_unit(const DFrame& frame) const {
    const glm::dmat4 inverse = inverse_of_any_frame(frame);
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      longest = std::max({longest, length_of(axis_of(frame, i)), length_of(dvec3(inverse[i]))});
    }
    return 0.45 * subject_.distance / longest;
  }

  Extent world_extent() const {
    Extent extent;
    const double size = axis_size();
    const auto add = [&](dvec3 p) { extent.add(flat(p)); };
    const DFrame frame = subject_.frame();
    if (subject_.axes) {
      const glm::dmat4 inverse = inverse_of_any_frame(frame);
      const double unit = arrow_unit(frame);
      add(subject_.eye);
      for (int i = 0; i < 3; ++i) {
        add(subject_.eye + unit * axis_of(frame, i));
        add(subject_.eye + unit * dvec3(inverse[i]));
      }
      return widened(extent, 0.02);
    }
    for (const auto& [a, b] : edges_) {
      add(a);
      add(b);
    }
    add(subject_.target);
    for (const dvec3 corner : picture_corners()) add(corner);
    for (const dvec3 way :
         {frame.right, frame.up, frame.forward, shown_axis(frame, 2), unit_vector(subject_.up), dvec3{0}})
      add(subject_.eye + size * way);
    for (const dvec3 tip : {dvec3{1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, 0, 1}, dvec3{0}})
      add(axis_length() * tip);
    return widened(extent, 0.02);
  }
  /// The picture's corners in the world, on the way to the target.
  std::vector<dvec3> picture_corners() const {
    const auto [eye, right, up, forward] = subject_.frame();
    std::vector<dvec3> corners;
    for (const dvec2 p : picture_extent(world_to_view(subject_.frame())).corners())
      corners.push_back(eye + 0.4 * subject_.distance * (forward + p.x * right + p.y * up));
    return corners;
  }
  /// The camera: from the eye through the picture's corners.
  void add_camera(SpaceDrawing& space) const {
    const std::vector<dvec3> corners = picture_corners();
    for (std::size_t i = 0; i < 8; ++i) {
      const auto [to, role] =
          i < 4 ? std::pair{subject_.eye, Role::guide} : std::pair{corners[(i + 1) % 4], Role::boundary};
      space.add(SpaceEdge{fmt::format("camera {}", i), role, corners[i % 4], to});
    }
    space.add(SpaceFace{"camera picture", Role::boundary, corners, false, true, 2});
  }
  /// Of the world's axes, and of the viewer's as they are drawn.
  double axis_length() const { return std::max(1.3, 0.25 * subject_.distance); }
  double axis_size() const { return 0.3 * subject_.distance; }

  /// An axis of the viewer in the picture, from its middle.
  void picture_axis(View& view, const Known& known, int number, dvec2 way) const {
    const std::string name(axis_names[static_cast<std::size_t>(number)]);
    const Role role = number == known.newest ? Role::current : Role::accepted;
    const dvec2 from = seen_place.centre();
    add_arrow(view, "picture axis " + name, role, from, from + way, axis_name(words_, number));
  }

  /// What the picture shows round its middle, the target: the letter, where it is in front.
  Extent picture_extent(const glm::dmat4& matrix) const {
    double half = 0.05;
    for (const auto& [a, b] : edges_) {
      for (const dvec3 p : {a, b}) {
        const dvec3 v = through(matrix, p);
        if (v.z > 0) half = std::max({half, std::abs(v.x / v.z), std::abs(v.y / v.z)});
      }
    }
    half = std::min(1.1 * half, 1.5);
    return {{-half, -half}, {half, half}};
  }

  void caption(View& view, std::string_view key, dvec2 at) const {
    view.add(
        {fmt::format("caption {}", key), Role::guide, Text{at, words_.say("caption." + std::string(key))}});
  }
  void frame_of(View& view) const {
    view.add({"picture frame", Role::boundary, Path{seen_place.corners(), true}});
  }
  static void guide_line(View& view, std::string id, dvec2 a, dvec2 b) {
    view.add({std::move(id), Role::guide, Stroke{a, b, false, true}});
  }
  void add_world_axes(View& view, SpaceDrawing& space) const {
    for (const auto& [name, way] : world_axes) {
      const dvec3 tip = axis_length() * way;
      space.add(SpaceEdge{
          .id = fmt::format("world {}", name), .role = Role::guide, .a = dvec3{0}, .b = tip, .arrow = true});
      view.add({fmt::format("world {} name", name), Role::guide,
                Label{world_.at(oblique(tip)), words_.symbol(name)}});
    }
  }
  void point(View& view, const std::string& id, Role role, dvec3 at, std::string name) const {
    view.add_named(id, role, world_.at(flat(at)), std::move(name));
  }
  /// From the eye.
  void arrow(View& view, const std::string& id, Role role, dvec3 way, std::string name, bool dashed) const {
    const dvec2 from = world_.at(flat(subject_.eye)), to = world_.at(flat(subject_.eye + way));
    view.add({id, role, Stroke{from, to, true, dashed}});
    view.add({id + " name", role, Label{to, std::move(name)}});
  }
  const Subject& subject_;
  const Words& words_;
  std::vector<std::pair<dvec3, dvec3>> edges_;  ///< of the letter
  const bool left_handed_;                      ///< the world's z runs away from the reader
  Panel world_;
};

}  // namespace gradus::viewing
