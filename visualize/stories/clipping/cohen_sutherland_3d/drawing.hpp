#pragma once
// A segment and its codes, drawn in a box, or in the view volume before the division by w.

#include <type_traits>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "stories/clipping/axis_arguments.hpp"
#include "stories/clipping/box_view.hpp"
#include "stories/clipping/region_codes.hpp"
#include "stories/telling.hpp"

namespace gradus::cohen_sutherland_3d {

using glm::dvec4;

inline constexpr int paper_width = 36, paper_height = 24;

/// A segment of three coordinates goes with a box, a homogeneous one with the view volume.
template <int N>
struct Subject {
  Segment<N, double> line;
  std::conditional_t<N == 3, AxisBox<3, double>, ViewVolume> region;
  Order order;
  std::string bits;  ///< which face each digit of a code stands for, the first to the left
  int plane = 0;     ///< of the view volume: the axis that is drawn against w
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
  Code first_a = 0, first_b = 0;  ///< of the ends as they were given
  std::vector<Move> moves{};
  bool accepted = false, rejected = false;

  /// The face that an end has just been moved to.
  std::optional<Border> cut() const {
    if (moves.empty() || accepted || rejected) return std::nullopt;
    return moves.back().face;
  }
};

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

/// What holds on a face: "far: z = 6".
inline std::string place_of(const Words& words, const AxisBox<3, double>& box, Border face) {
  return fmt::format("{}: {} = {}", face_name(words, face), words.axis(axis_of(face)),
                     figure_real(coordinate(box, face)));
}
inline std::string place_of(const Words& words, const ViewVolume&, Border face) {
  const std::string w = words.symbol("w"), lower = face == Border::near ? "0" : "−" + w;
  return fmt::format("{}: {} = {}", face_name(words, face), words.axis(axis_of(face)),
                     is_upper(face) ? w : lower);
}

/// Which bit of a code is which face's.
template <int N>
void add_order_of_bits(View& view, const Words& words, const Subject<N>& subject, dvec2 at) {
  const std::string names = digit_names(subject.bits, " · ", [&words](std::size_t face) {
    return face_name(words, static_cast<Border>(face));
  });
  view.add({"z bits", Role::guide, Text{at, words.say("bits", {{"faces", names}}), Align::centre, true}});
}

/// What is left of the segment, and dashed what was cut off: add(id, role, a, b, dashed) for each part.
template <int N, class Add>
void each_part(const std::string& prefix, const State<N>& state, Add add) {
  for (std::size_t i = 0; i < state.moves.size(); ++i) {
    add(fmt::format("{} off {}", prefix, i + 1), Role::rejected, state.moves[i].from, state.moves[i].to,
        true);
  }
  const Role left = state.accepted ? Role::result : state.rejected ? Role::rejected : Role::input;
  add(prefix + " rest", left, state.rest.a, state.rest.b, state.rejected);
}

/// The ends as they were given, with their codes where `codes` says so, and the cuts with their faces.
template <int N, class At>
void add_ends(View& view, const std::string& prefix, const Words& words, const Subject<N>& subject,
              const State<N>& state, At at, bool codes) {
  for (const bool of_a : {true, false}) {
    const auto given = of_a ? subject.line.a : subject.line.b, now = of_a ? state.rest.a : state.rest.b;
    const std::string name = of_a ? "a" : "b";
    const Code code = of_a ? state.first_a : state.first_b;
    const std::string text = codes ? name + " " + code_text(code, subject.bits) : name;
    view.add_named(prefix + " t end " + name, prefix + " u end " + name, Role::input, at(given), text,
                   given != now, name);
  }
  for (std::size_t i = 0; i < state.moves.size(); ++i) {
    const auto& move = state.moves[i];
    const bool stands = move.to == (move.of_a ? state.rest.a : state.rest.b);
    const bool last = state.cut() && i + 1 == state.moves.size();
    const Role role = last ? Role::current : state.accepted && stands ? Role::result : Role::past;
    const std::string number = std::to_string(i + 1);
    view.add_named(prefix + " t cut " + number, prefix + " u cut " + number, role, at(move.to),
                   codes ? place_of(words, subject.region, move.face) : face_name(words, move.face), false,
                   move.of_a ? "a" : "b");
  }
}

/// The segment in space. in_space(p): a point's place there.
template <int N, class InSpace>
void add_segment(SpaceDrawing& drawing, const SpaceView& space, const State<N>& state, InSpace in_space) {
  each_part("line", state, [&](std::string id, Role role, const auto& a, const auto& b, bool dashed) {
    drawing.add(SpaceEdge{.id = std::move(id),
                          .role = role,
                          .a = space.turned(in_space(a)),
                          .b = space.turned(in_space(b)),
                          .dashed = dashed});
  });
}

inline std::vector<dvec3> shown_of(const Subject<3>& subject) {
  std::vector<dvec3> shown = corners_of(subject.region);
  shown.insert(shown.begin(), {subject.line.a, subject.line.b});
  return shown;
}
/// Whether a part of the paper is free of the box and the segment.
inline bool is_free(const AxisBox<2, double>& part, const SpaceView& space, const Subject<3>& subject) {
  const std::vector<dvec3> corners = corners_of(subject.region);
  for (const Corners& face : faces_of_box()) {
    std::vector<dvec2> ring;
    for (const std::size_t corner : face) ring.push_back(space.at(corners[corner]));
    if (sutherland_hodgman::clip_to_window(ring, part).size() >= 3) return false;
  }
  return !cohen_sutherland_2d::correctly_rounded({space.at(subject.line.a), space.at(subject.line.b)}, part);
}

/// Where space is drawn, and the foot of the arrows that say which way its axes go: in a corner that is free.
struct Arrangement {
  SpaceView space;
  dvec2 directions;
};
inline Arrangement arrangement_of(const Subject<3>& subject) {
  const std::vector<dvec3> shown = shown_of(subject);
  const SpaceView whole({{3, 2.2}, {33, 23.4}}, shown);
  constexpr dvec2 rim{0.5, 0.5}, room{4, 4};
  for (const dvec2 foot : {dvec2{1.2, 19}, {31, 2.6}, {1.2, 2.6}, {31, 19}}) {
    if (is_free({foot - rim, foot + room}, whole, subject)) return {whole, foot};
  }
  // A wide box leaves no corner free: they stand beside it
  return {SpaceView({{6.2, 2.2}, {33, 23.4}}, shown), {1.2, 2.6}};
}
inline SpaceView space_of(const Subject<3>& subject) { return arrangement_of(subject).space; }

inline View view_of(const Words& words, const Subject<3>& subject, const State<3>& state) {
  View view;
  const std::vector<dvec3> corners = corners_of(subject.region);
  const auto [space, directions] = arrangement_of(subject);
  const auto at = [&seen = space](dvec3 p) { return seen.at(p); };
  SpaceDrawing drawing = space.drawing();
  add_glass(drawing, space, corners, faces_of_box());
  if (const auto cut = state.cut()) add_face(view, space, box_face(subject.region, *cut));
  add_segment(drawing, space, state, [](dvec3 p) { return p; });
  drawing.add_to(view, "box");
  add_ends(view, "line", words, subject, state, at, true);
  add_directions(view, directions, {words.symbol("x"), words.symbol("y"), words.symbol("z")});
  add_order_of_bits(view, words, subject, {18, 0.8});
  return view;
}

/// A plane across the view volume: w to the right, a coordinate up, so that the volume is a wedge.
inline void add_plane(View& view, const Words& words, const Subject<4>& subject, const State<4>& state,
                      Extent place) {
  const int axis = subject.plane;
  const auto flat = [axis](const dvec4& p) { return dvec2(p.w, p[axis]); };
  const bool depth = axis == 2;  // there the lower face is z = 0
  const auto& [a, b] = subject.line;
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
  view.add({id + "wedge", Role::boundary, Area{{{eye, upper, lower}}, 2}});
  const auto add_side = [&](const std::string& side, dvec2 to, int face, const std::string& text) {
    const Role role = state.cut() == static_cast<Border>(face) ? Role::current : Role::boundary;
    view.add({side, role, Stroke{eye, to}});
    view.add({side + " name", role, Label{0.25 * eye + 0.75 * to, text}});
  };
  add_side(id + "upper", upper, 2 * axis + 1, fmt::format("{} = {}", name, w));
  add_side(id + "lower", lower, 2 * axis, fmt::format("{} = {}", name, depth ? "0" : "−" + w));
  const auto at = [&](const dvec4& p) { return panel.at(flat(p)); };
  each_part(id + "line", state,
            [&](std::string part, Role role, const auto& from, const auto& to, bool dashed) {
              view.add({std::move(part), role, Stroke{at(from), at(to), false, dashed}});
            });
  add_ends(view, id + "line", words, subject, state, at, false);
}

/// The pyramid of the volume's sides, its top at the eye, and the side at which something is cut.
inline void add_pyramid(View& view, SpaceDrawing& drawing, const SpaceView& space,
                        const std::vector<dvec3>& base, std::optional<Border> cut) {
  std::vector<dvec3> corners = base;
  corners.push_back(dvec3(0));
  add_glass(drawing, space, corners, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  view.add({"line t eye", Role::boundary, Dot{space.at(dvec3(0)), true}});
  if (!cut || axis_of(*cut) == 2) return;
  constexpr std::array<std::array<std::size_t, 2>, 4> sides{{{3, 0}, {1, 2}, {0, 1}, {2, 3}}};
  const auto [i, j] = sides[static_cast<std::size_t>(*cut)];
  add_face(view, space, {dvec3(0), base[i], base[j]});
}

/// Seen from the side: w to the right, y up, x towards the reader.
inline dvec3 in_space(const dvec4& p) { return {p.w, p.y, -p.x}; }
/// Of the pyramid.
inline std::vector<dvec3> base_of(const Subject<4>& subject) {
  const double far = std::max({subject.line.a.w, subject.line.b.w, 0.0});
  std::vector<dvec3> base;
  for (const dvec2 side : {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)}) {
    base.push_back(dvec3(1, side.y, -side.x) * far);
  }
  return base;
}
inline SpaceView space_of(const Subject<4>& subject) {
  std::vector<dvec3> shown = base_of(subject);
  shown.insert(shown.end(), {dvec3(0), in_space(subject.line.a), in_space(subject.line.b)});
  return {{{2, 3.4}, {16.4, 23}}, shown};
}

inline View view_of(const Words& words, const Subject<4>& subject, const State<4>& state) {
  View view;
  const std::vector<dvec3> base = base_of(subject);
  const SpaceView space = space_of(subject);
  const auto at = [&](const dvec4& p) { return space.at(in_space(p)); };
  SpaceDrawing drawing = space.drawing();
  add_pyramid(view, drawing, space, base, state.cut());
  add_segment(drawing, space, state, in_space);
  drawing.add_to(view, "box");
  add_ends(view, "line", words, subject, state, at, true);
  add_directions(view, {1.6, 2.4}, {words.symbol("w"), words.symbol("y"), words.symbol("x")}, true);
  add_order_of_bits(view, words, subject, {18, 0.8});
  add_plane(view, words, subject, state, {{19.4, 2.2}, {35.4, 22.8}});
  return view;
}

}  // namespace gradus::cohen_sutherland_3d
