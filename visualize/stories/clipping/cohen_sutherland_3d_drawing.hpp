#pragma once
// A segment and its codes, drawn in a box, or in the view volume before the division by w.

#include <type_traits>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "stories/clipping/axis_arguments.hpp"
#include "stories/clipping/box_view.hpp"
#include "stories/telling.hpp"

namespace gradus::cohen_sutherland_3d {

using glm::dvec4;

inline constexpr int paper_width = 26, paper_height = 34;

/// A segment of three coordinates goes with a box, a homogeneous one with the view volume.
template <int N>
struct Task {
  Segment<N, double> line;
  std::conditional_t<N == 3, AxisBox<3, double>, ViewVolume> region;
  Order order;
  bool left_first;  ///< whether a code begins with the bit of the left face, not that of the far one
  int plane = 0;    ///< of the view volume: the axis that is drawn against w
};

/// What is known after a step.
template <int N>
struct State {
  struct Move {
    bool of_a;
    Border face;
    glm::vec<N, double> from, to;
  };
  Segment<N, double> rest;  ///< what is left
  Code code_a = 0, code_b = 0;
  std::vector<Move> moves{};
  bool accepted = false, rejected = false;

  /// The face that an end has just been moved to.
  std::optional<Border> cut() const {
    if (moves.empty() || accepted || rejected) return std::nullopt;
    return moves.back().face;
  }
};

inline std::string code_text(Code code, bool left_first) {
  std::string text;
  for (int i = 0; i < 6; ++i) text += (code >> (left_first ? i : 5 - i) & 1) != 0 ? '1' : '0';
  return text;
}

/// The test that sets a face's bit: "x < 0", "y > w".
inline std::string test_of(const Words& words, const AxisBox<3, double>& box, Border face) {
  return fmt::format("{} {} {}", words.axis(axis_of(face)), is_upper(face) ? ">" : "<",
                     figure_real(coordinate(box, face)));
}
inline std::string test_of(const Words& words, const ViewVolume&, Border face) {
  const std::string w = words.symbol("w"), lower = face == Border::near ? "0" : "−" + w;
  return fmt::format("{} {} {}", words.axis(axis_of(face)), is_upper(face) ? ">" : "<",
                     is_upper(face) ? w : lower);
}

inline std::string face_name(const Words& words, Border face) {
  return words.say(fmt::format("face.{}", name_of(face)));
}

/// The bits of both codes with what they mean, a face a row, in the order in which codes are written.
template <int N>
void add_bits(View& view, const Words& words, const Task<N>& task, const State<N>& state) {
  constexpr double name = 0.7, test = 7.9, a = 16.8, b = 18.9, top = 16, row = 2.45;
  view.add({"bits a", Role::guide, Text{{a, top}, "a"}});
  view.add({"bits b", Role::guide, Text{{b, top}, "b"}});
  for (int i = 0; i < 6; ++i) {
    const Border face = static_cast<Border>(task.left_first ? i : 5 - i);
    const double y = top - row * (i + 1);
    const std::string id = fmt::format("bits {}", name_of(face));
    const Role role = state.cut() == face ? Role::current : Role::guide;
    view.add({id + " name", role, Text{{name, y}, face_name(words, face), Align::left}});
    view.add({id + " test", role, Text{{test, y}, test_of(words, task.region, face), Align::left}});
    const auto add_digit = [&](std::string_view end, double x, Code code) {
      const bool set = (code & bit(face)) != 0;
      view.add(
          {fmt::format("{} {}", id, end), set ? Role::rejected : Role::guide, Text{{x, y}, set ? "1" : "0"}});
    };
    add_digit("a", a, state.code_a);
    add_digit("b", b, state.code_b);
  }
}

/// The segment in one picture: what is left, what was cut off (dashed), the cuts with their numbers, both
/// ends with their names. at(p): a point's place on the paper.
template <int N, class At>
void add_segment(View& view, std::string_view prefix, const Segment<N, double>& line, const State<N>& state,
                 At at, const std::string& a, const std::string& b) {
  const auto id = [&](std::string_view what) { return fmt::format("{} {}", prefix, what); };
  std::string names[] = {a, b};
  for (std::size_t i = 0; i < state.moves.size(); ++i) {
    const auto& move = state.moves[i];
    const std::string number = std::to_string(i + 1);
    names[move.of_a ? 0 : 1] = fmt::format("{}: {}", number, move.of_a ? a : b);
    view.add({id("off " + number), Role::rejected, Stroke{at(move.from), at(move.to), false, true}});
    const bool last = i + 1 == state.moves.size() && !state.accepted;
    const Role role = last ? Role::current : Role::past;
    view.add({id("cut " + number), role, Dot{at(move.to)}});
    // An end's last cut is told with its code
    const bool stands = move.to == (move.of_a ? state.rest.a : state.rest.b);
    if (!stands) view.add({id("number " + number), role, Label{at(move.to), number}});
  }
  const Role left = state.accepted ? Role::result : state.rejected ? Role::rejected : Role::input;
  view.add({id("rest"), left, Stroke{at(state.rest.a), at(state.rest.b), false, state.rejected}});
  for (const bool of_a : {true, false}) {
    const auto end = of_a ? line.a : line.b, now = of_a ? state.rest.a : state.rest.b;
    const std::string which = of_a ? "a" : "b";
    view.add({id("end " + which), Role::input, Dot{at(end), end != now}});
    const bool moved_now = !state.moves.empty() && state.moves.back().of_a == of_a;
    const Role role = state.accepted ? Role::result : moved_now ? Role::current : Role::input;
    view.add({id("name " + which), role, Label{at(now), names[of_a ? 0 : 1]}});
  }
}

inline View view_of(const Words& words, const Task<3>& task, const State<3>& state) {
  View view;
  std::vector<dvec3> shown{task.line.a, task.line.b};
  for (int corner = 0; corner < 8; ++corner) shown.push_back(box_corner(task.region, corner));
  const SpaceView space({{2, 18.2}, {24, 32.3}}, shown);
  add_box(view, space, task.region);
  add_directions(view, {21.4, 3}, {words.symbol("x"), words.symbol("y"), words.symbol("z")});
  if (const auto cut = state.cut()) add_face(view, space, box_face(task.region, *cut));
  const std::string a = code_text(state.code_a, task.left_first),
                    b = code_text(state.code_b, task.left_first);
  add_segment(view, "line", task.line, state, [&](dvec3 p) { return space.at(p); }, "a " + a, "b " + b);
  add_bits(view, words, task, state);
  return view;
}

/// A plane across the view volume: w to the right, a coordinate up, so that the volume is a wedge.
inline void add_plane(View& view, const Words& words, const Task<4>& task, const State<4>& state,
                      Extent place) {
  const int axis = task.plane;
  const auto flat = [axis](const dvec4& p) { return dvec2(p.w, p[axis]); };
  const bool depth = axis == 2;  // there the lower face is z = 0
  const auto& [a, b] = task.line;
  const double far = std::max({a.w, b.w, 0.0});
  Extent world;
  for (const dvec2 p : {dvec2(0), flat(a), flat(b), dvec2(far), dvec2(far, depth ? 0 : -far)}) world.add(p);
  const Panel panel({place.lower + dvec2(0.8, 1.6), place.upper - dvec2(0.8, 1.6)}, world);
  const Extent shown = panel.shown();
  const dvec2 eye = panel.at({0, 0});
  const std::string name = words.axis(axis), w = words.symbol("w");
  const std::string id = fmt::format("plane {} ", axis);
  // The axes through the eye
  view.add({id + "w", Role::guide, Stroke{{place.lower.x, eye.y}, {place.upper.x, eye.y}, true}});
  view.add({id + "w name", Role::guide, Text{{place.upper.x - 0.3, eye.y - 1.0}, w}});
  view.add({id + "axis", Role::guide, Stroke{{eye.x, place.lower.y}, {eye.x, place.upper.y}, true}});
  view.add({id + "axis name", Role::guide, Text{{eye.x, place.upper.y + 0.8}, name}});
  // The wedge between two faces
  const double reach = std::min({shown.upper.x, shown.upper.y, depth ? shown.upper.x : -shown.lower.y});
  const dvec2 upper = panel.at({reach, reach}), lower = panel.at({reach, depth ? 0 : -reach});
  view.add({id + "wedge", Role::accepted, Area{{{eye, upper, lower}}}});
  const auto add_side = [&](const std::string& side, dvec2 to, int face, const std::string& text) {
    const Role role = state.cut() == static_cast<Border>(face) ? Role::current : Role::boundary;
    view.add({side, role, Stroke{eye, to}});
    view.add({side + " name", role, Label{0.25 * eye + 0.75 * to, text}});
  };
  add_side(id + "upper", upper, 2 * axis + 1, fmt::format("{} = {}", name, w));
  add_side(id + "lower", lower, 2 * axis, fmt::format("{} = {}", name, depth ? "0" : "−" + w));
  const auto at = [&](const dvec4& p) { return panel.at(flat(p)); };
  add_segment(view, id + "line", task.line, state, at, "a", "b");
}

/// The pyramid of the volume's sides, its top at the eye; what its sides hide is dashed.
inline void add_pyramid(View& view, const SpaceView& space, const std::vector<dvec3>& corners,
                        std::optional<Border> cut) {
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec2 corner = space.at(corners[i]), next = space.at(corners[(i + 1) % 4]);
    const bool behind = i == 0;
    view.add({fmt::format("edge {}", i), Role::boundary, Stroke{space.at(dvec3(0)), corner, false, behind}});
    view.add({fmt::format("base {}", i), Role::boundary, Stroke{corner, next}});
  }
  view.add({"eye", Role::boundary, Dot{space.at(dvec3(0)), true}});
  if (!cut || axis_of(*cut) == 2) return;
  constexpr std::array<std::array<std::size_t, 2>, 4> sides{{{3, 0}, {1, 2}, {0, 1}, {2, 3}}};
  const auto [i, j] = sides[static_cast<std::size_t>(*cut)];
  add_face(view, space, {dvec3(0), corners[i], corners[j]});
}

inline View view_of(const Words& words, const Task<4>& task, const State<4>& state) {
  View view;
  // Seen from the side: w to the right, y up, x towards the reader
  const auto in_space = [](const dvec4& p) { return dvec3(p.w, p.y, -p.x); };
  const double far = std::max({task.line.a.w, task.line.b.w, 0.0});
  std::vector<dvec3> corners;
  for (const dvec2 side : {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)}) {
    corners.push_back(dvec3(1, side.y, -side.x) * far);
  }
  std::vector<dvec3> shown = corners;
  shown.insert(shown.end(), {dvec3(0), in_space(task.line.a), in_space(task.line.b)});
  const SpaceView space({{1.2, 19}, {12, 32}}, shown);
  add_pyramid(view, space, corners, state.cut());
  add_directions(view, {21.9, 4}, {words.symbol("w"), words.symbol("y"), words.symbol("x")}, true);
  const auto at = [&](const dvec4& p) { return space.at(in_space(p)); };
  add_segment(view, "line", task.line, state, at, "a", "b");
  add_bits(view, words, task, state);
  add_plane(view, words, task, state, {{13.6, 18}, {25.6, 32.4}});
  return view;
}

}  // namespace gradus::cohen_sutherland_3d
