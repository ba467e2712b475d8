#pragma once
// How a view is drawn: the world with the viewer's axes, and beside it what they see and the matrix.

#include "stories/matrix_drawing.hpp"
#include "stories/projection/viewing/subject.hpp"
#include "stories/rings.hpp"
#include "stories/space_drawing.hpp"

namespace gradus::viewing {

// block_story.cpp
void tell_block(Narrator& narrator);

/// Three panels on a paper of 36 x 24: the world, what the viewer makes of it, and below that the matrix.
inline const Extent world_place{{0.4, 0.4}, {16.6, 22}};
inline const Extent seen_place{{20.2, 8.6}, {33.6, 22}}, matrix_place{{16.7, 0.4}, {35.3, 7}};

/// For given axes: these beside the letter in the world, or twice, for two hands; at last the letter along
/// them and in the world.
inline const Extent axes_place{{3, 0.8}, {20, 22}}, letter_place{{25, 1.6}, {35.2, 21}};
inline const Extent left_hand_place{{2.2, 0}, {15.4, 17}}, right_hand_place{{21.8, 0}, {35, 17}};
inline const Extent along_place{{0.8, 1}, {16, 21.6}}, back_place{{20, 1}, {35.2, 21.6}};

/// An axis of the viewer, its row of the matrix and its line in the picture have one colour.
inline Role axis_role(int number) {
  constexpr std::array roles{Role::measure, Role::accepted, Role::current};
  return roles[static_cast<std::size_t>(number)];
}

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
               world_extent()) {
    if (subject.axes) return;
    // A far eye is drawn nearer, so near that the model is large, wherever up points: the eye lies still when
    // that is turned
    for (const double distance : {2.2, 1.8, 1.5}) {
      if (large_letter * Panel(world_place, still_extent()).scale().y > large_on_paper) break;
      most_distance_ = distance;
    }
    world_ = Panel(world_place, world_extent());
  }

  /// Where the first drawing has a point of the world, the eye, the end of the hint for up, and that of a
  /// given axis.
  dvec2 at(dvec3 p) const { return world_.at(flat(p)); }
  dvec2 eye_at(dvec3 eye) const { return at(nearer(eye)); }
  dvec2 hint_at(dvec3 up) const { return at(shown_eye() + axis_size() * unit_vector(up)); }
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
    space.add(SpaceEdge{.id = "sight", .role = Role::guide, .a = shown_eye(), .b = subject_.target});
    add_camera(space);
    space.add_to(view, "a letter world");
    const double size = axis_size();
    if (!known.axes[1])
      arrow(view, "hint", Role::candidate, size * unit_vector(subject_.up), words_.say("hint"), true);
    for (int i = 0; i < 3; ++i) {
      if (!known.axes[static_cast<std::size_t>(i)]) continue;
      const std::string name(axis_names[static_cast<std::size_t>(i)]);
      arrow(view, "axis " + name, axis_role(i), size * shown_axis(frame, i), axis_name(words_, i), false);
    }
    point(view, "eye", Role::input, shown_eye(), words_.say("name.eye"));
    point(view, "target", Role::input, subject_.target, words_.say("name.target"));
    if (shown_distance() < subject_.distance) add_break(view);
    return view;
  }

  /// The matrix, its rows (or columns) in their axes' colours as far as they are known.
  void add_matrix_of(View& view, const Known& known, const glm::dmat4& m, bool columns) const {
    MatrixRows rows(4, std::vector<double>(4));
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 4; ++c) {
        const double x = m[static_cast<int>(c)][static_cast<int>(r)];
        rows[r][c] = std::abs(x) < 1e-9 ? 0 : x;
      }
    }
    rows = fitted(oriented(words_.wording(), std::move(rows)), matrix_place.size().x);
    const dvec2 size = matrix_size(rows), middle = matrix_place.centre();
    if (size.x > matrix_place.size().x) return;
    const bool by_columns = columns != words_.notation().rows;
    add_matrix(view, "n matrix", middle + dvec2{size.x / 2, 0}, "", rows, Role::input, true);
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < 4; ++c) {
        const int axis = by_columns ? c : r;
        const bool known_last = axis == 3 && known.seen;
        view.marks.at(fmt::format("n matrix entry {} {}", r, c)).role = known_last          ? Role::input
                                                                        : axis < known.rows ? axis_role(axis)
                                                                                            : Role::guide;
      }
    }
    if (known.newest < 0 || known.newest >= known.rows || by_columns) return;
    const double high = size.y / 4, top = middle.y + size.y / 2 - high * known.newest;
    const double left = middle.x - size.x / 2 + 0.35;
    view.add({"n matrix row", axis_role(known.newest),
              Path{{{left, top - high + 0.2}, {left, top - 0.2}}, false, false, true}});
  }

  /// The picture: x / depth to the right, y / depth up; the letter in it once the matrix is whole.
  void add_picture(View& view, const Known& known, const glm::dmat4& matrix) const {
    caption(view, "picture", {seen_place.centre().x, seen_place.upper.y + 1.2});
    frame_of(view);
    const Panel panel(seen_place, picture_extent(matrix));
    const dvec2 middle = seen_place.centre(), reach = 0.42 * seen_place.size();
    if (known.rows >= 1) picture_axis(view, 0, {reach.x, 0});
    if (known.rows >= 2) picture_axis(view, 1, {0, reach.y});
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
    const Panel panel({{19.6, 8.8}, {34.4, 21.5}}, widened(all, 0.02));
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
      add(shown_eye() + size * way);
    for (const dvec3 tip : {dvec3{1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, 0, 1}, dvec3{0}})
      add(axis_length() * tip);
    return widened(extent, 0.02);
  }
  /// Of what the drawing has for any up, with as much round the eye as its axes take most often.
  Extent still_extent() const {
    Extent extent;
    const auto add = [&](dvec3 p) { extent.add(flat(p)); };
    for (const auto& [a, b] : edges_) {
      add(a);
      add(b);
    }
    for (const auto& [name, axis] : world_axes) {
      add(axis_length() * axis);
      add(shown_eye() + 0.7 * axis_size() * axis);
      add(shown_eye() - 0.7 * axis_size() * axis);
    }
    add(subject_.target);
    return widened(extent, 0.02);
  }
  /// The picture's corners in the world, on the way to the target: so near the eye that a wide picture does
  /// not cover the model.
  std::vector<dvec3> picture_corners() const {
    const auto [eye, right, up, forward] = subject_.frame();
    const Extent picture = picture_extent(world_to_view(subject_.frame()));
    const double depth = std::min(0.4, 0.24 / picture.upper.x) * shown_distance();
    std::vector<dvec3> corners;
    for (const dvec2 p : picture.corners())
      corners.push_back(shown_eye() + depth * (forward + p.x * right + p.y * up));
    return corners;
  }
  /// The letter's height, and how many units of the paper make a large one.
  static constexpr double large_letter = 1.2, large_on_paper = 9;
  double shown_distance() const {
    return subject_.axes ? subject_.distance : std::min(subject_.distance, most_distance_);
  }
  dvec3 nearer(dvec3 eye) const {
    if (subject_.axes) return eye;
    const dvec3 way = eye - subject_.target;
    return subject_.target + std::min(1.0, most_distance_ / length_of(way)) * way;
  }
  dvec3 shown_eye() const { return nearer(subject_.eye); }
  /// Across the line of sight behind the camera: it is longer than it is drawn.
  void add_break(View& view) const {
    const dvec2 a = at(shown_eye()), b = at(subject_.target);
    gradus::add_break(view, "sight break", Role::guide, a + 0.7 * (b - a),
                      (b - a) / std::max(length_between(a, b), 1e-9));
  }
  /// The camera: from the eye through the picture's corners.
  void add_camera(SpaceDrawing& space) const {
    const std::vector<dvec3> corners = picture_corners();
    for (std::size_t i = 0; i < 8; ++i) {
      const auto [to, role] =
          i < 4 ? std::pair{shown_eye(), Role::guide} : std::pair{corners[(i + 1) % 4], Role::boundary};
      space.add(SpaceEdge{fmt::format("camera {}", i), role, corners[i % 4], to});
    }
    space.add(SpaceFace{"camera picture", Role::boundary, corners, false, true, 2});
  }
  /// Of the world's axes, and of the viewer's as they are drawn.
  double axis_length() const { return subject_.axes ? std::max(1.3, 0.25 * subject_.distance) : 1.15; }
  double axis_size() const {
    return subject_.axes ? 0.3 * subject_.distance : std::max(0.5, 0.3 * shown_distance());
  }

  /// An axis of the viewer in the picture, from its middle.
  void picture_axis(View& view, int number, dvec2 way) const {
    const std::string name(axis_names[static_cast<std::size_t>(number)]);
    const dvec2 from = seen_place.centre();
    add_arrow(view, "picture axis " + name, axis_role(number), from, from + way, axis_name(words_, number));
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
    const dvec2 from = world_.at(flat(shown_eye())), to = world_.at(flat(shown_eye() + way));
    view.add({id, role, Stroke{from, to, true, dashed}});
    view.add({id + " name", role, Label{to, std::move(name)}});
  }
  const Subject& subject_;
  const Words& words_;
  std::vector<std::pair<dvec3, dvec3>> edges_;  ///< of the letter
  const bool left_handed_;                      ///< the world's z runs away from the reader
  double most_distance_ = 2.6;                  ///< from the eye to the target as it is drawn
  Panel world_;
};

}  // namespace gradus::viewing
