// The story of a segment in space and its region codes: which end moves to which face, and when it is
// settled.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include <array>
#include <optional>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "stories/clipping/box_view.hpp"
#include "stories/paper.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::cohen_sutherland_3d {
namespace {

using fmt::arg;
using glm::dvec4;

constexpr std::string_view folder = "algorithms/clipping/cohen_sutherland_3d/";
constexpr int paper_width = 26, paper_height = 34;
constexpr std::array<std::string_view, 6> face_names{"left", "right", "bottom", "top", "near", "far"};
constexpr std::string_view view_volume_name = "view_volume";

std::string_view name_of(Border face) { return face_names[static_cast<std::size_t>(face)]; }

const Parameter& order_parameter() {
  static const Parameter parameter{.name = "order",
                                   .type = ParameterType::order,
                                   .default_value = "left,right,bottom,top,near,far",
                                   .example = "top,bottom,far,near,right,left",
                                   .help = "which face an end beyond several is cut at first",
                                   .choices = {"left", "right", "bottom", "top", "near", "far"}};
  return parameter;
}

/// What a run is about.
struct Run {
  std::string method;
  Segment<3, double> line;  ///< of the box
  AxisBox<3, double> box;
  Segment<4, double> seen;  ///< of the view volume
  Order order;
  int plane;        ///< of the view volume: the axis that is drawn against w
  bool left_first;  ///< whether a code begins with the bit of the left face, not that of the far one

  bool homogeneous() const { return method == view_volume_name; }
};

/// The plane that shows the first cut; x against w where there is none.
int plane_of(const Run& run) {
  std::optional<int> axis;
  const auto watch = [&axis]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Cut<4, double>>) {
      if (!axis) axis = axis_of(step.face);
    }
  };
  correctly_rounded(run.seen, ViewVolume{}, run.order, watch);
  return axis.value_or(0);
}

Run run_of(const Arguments& arguments) {
  const auto line = arguments.numbers("line"), box = arguments.numbers("box");
  const auto seen = arguments.numbers("homogeneous");
  Run run{arguments.text("method"),
          {{line[0], line[1], line[2]}, {line[3], line[4], line[5]}},
          {{box[0], box[1], box[2]}, {box[3], box[4], box[5]}},
          {{seen[0], seen[1], seen[2], seen[3]}, {seen[4], seen[5], seen[6], seen[7]}},
          {},
          0,
          arguments.text("code_bits") == "LRBTNF"};
  const auto order = arguments.order(order_parameter());
  for (std::size_t i = 0; i < order.size(); ++i) run.order[i] = static_cast<Border>(order[i]);
  for (const dvec4 end : {run.seen.a, run.seen.b}) {
    if (end == dvec4(0)) throw ArgumentError("homogeneous", "0,0,0,0 is no point");
  }
  if (opposite(run.seen.a, run.seen.b)) {
    throw ArgumentError("homogeneous", "the ends are opposite each other: 0,0,0,0 lies between them");
  }
  run.plane = plane_of(run);
  return run;
}

// --- Drawing ---------------------------------------------------------------------------------------------

/// What is known after a step, for a segment of N coordinates.
template <int N>
struct State {
  struct Move {
    bool of_a;
    Border face;
    glm::vec<N, double> from, to;
  };
  Segment<N, double> line;  ///< as it came
  Segment<N, double> rest;  ///< what is left
  Code code_a = 0, code_b = 0;
  std::vector<Move> moves;
  bool accepted = false, rejected = false;
};

/// The test that sets a face's bit: "x < 0", "y > w".
std::string test_of(const Wording& words, const Run& run, Border face) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  const std::string axis = words.symbol(axes[static_cast<std::size_t>(axis_of(face))]);
  std::string border = figure_real(coordinate(run.box, face));
  if (run.homogeneous()) {
    border = face == Border::near ? "0" : is_upper(face) ? words.symbol("w") : "−" + words.symbol("w");
  }
  return fmt::format("{} {} {}", axis, is_upper(face) ? ">" : "<", border);
}

std::string face_name(const Wording& words, Border face) {
  return words.say("cohen_sutherland_3d.face." + std::string(name_of(face)));
}

/// The bits of both codes with what they mean, a face a row, in the order in which codes are written.
void add_bits(View& view, const Wording& words, const Run& run, Code code_a, Code code_b,
              std::optional<Border> cut) {
  constexpr double name = 0.7, test = 7.9, a = 16.8, b = 18.9, top = 16, row = 2.45;
  view.add({"bits a", Role::guide, Text{{a, top}, "a"}});
  view.add({"bits b", Role::guide, Text{{b, top}, "b"}});
  for (int i = 0; i < 6; ++i) {
    const Border face = static_cast<Border>(run.left_first ? i : 5 - i);
    const double y = top - row * (i + 1);
    const std::string id = fmt::format("bits {}", name_of(face));
    const Role role = cut == face ? Role::current : Role::guide;
    view.add({id + " name", role, Text{{name, y}, face_name(words, face), Align::left}});
    view.add({id + " test", role, Text{{test, y}, test_of(words, run, face), Align::left}});
    const auto digit = [&](std::string_view end, double x, Code code) {
      const bool set = (code & bit(face)) != 0;
      view.add(
          {fmt::format("{} {}", id, end), set ? Role::rejected : Role::guide, Text{{x, y}, set ? "1" : "0"}});
    };
    digit("a", a, code_a);
    digit("b", b, code_b);
  }
}

/// The segment in one picture: what is left, what was cut off (dashed), the cuts with their numbers, both
/// ends with their codes. at(p): a point's place on the paper.
template <int N, class At>
void add_segment(View& view, std::string_view prefix, const State<N>& state, At at, const std::string& a,
                 const std::string& b) {
  const auto id = [&](std::string_view what) { return fmt::format("{} {}", prefix, what); };
  for (std::size_t i = 0; i < state.moves.size(); ++i) {
    const auto& move = state.moves[i];
    const std::string number = std::to_string(i + 1);
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
    const auto end = of_a ? state.line.a : state.line.b, now = of_a ? state.rest.a : state.rest.b;
    const std::string which = of_a ? "a" : "b";
    view.add({id("end " + which), Role::input, Dot{at(end), end != now}});
    std::string text = of_a ? a : b;
    for (std::size_t i = state.moves.size(); i-- > 0;) {
      if (state.moves[i].of_a != of_a) continue;
      text = fmt::format("{}: {}", i + 1, text);
      break;
    }
    const bool moved_now = !state.moves.empty() && state.moves.back().of_a == of_a && !state.accepted;
    view.add({id("name " + which),
              state.accepted ? Role::result
              : moved_now    ? Role::current
                             : Role::input,
              Label{at(now), text}});
  }
}

void add_face(View& view, std::string_view id, const SpaceView& space, const std::vector<dvec3>& corners) {
  std::vector<dvec2> outline;
  for (const dvec3 p : corners) outline.push_back(space.at(p));
  view.add({fmt::format("{} area", id), Role::current, Area{{outline}}});
  view.add({fmt::format("{} outline", id), Role::current, Path{outline, true}});
}

std::string code_text(Code code, bool left_first) {
  std::string text;
  for (int i = 0; i < 6; ++i) text += (code >> (left_first ? i : 5 - i) & 1) != 0 ? '1' : '0';
  return text;
}

View view_of(const Wording& words, const Run& run, const State<3>& state) {
  View view;
  const SpaceView space({{2, 18.2}, {24, 32.3}},
                        {run.box.lower, box_corner(run.box, 1), box_corner(run.box, 2),
                         box_corner(run.box, 3), box_corner(run.box, 4), box_corner(run.box, 5),
                         box_corner(run.box, 6), run.box.upper, run.line.a, run.line.b});
  add_box(view, space, run.box);
  add_directions(view, {21.4, 3}, {words.symbol("x"), words.symbol("y"), words.symbol("z")});
  std::optional<Border> cut;
  if (!state.moves.empty() && !state.accepted && !state.rejected) cut = state.moves.back().face;
  if (cut) add_face(view, "face", space, box_face(run.box, *cut));
  add_segment(
      view, "line", state, [&](dvec3 p) { return space.at(p); },
      "a " + code_text(state.code_a, run.left_first), "b " + code_text(state.code_b, run.left_first));
  add_bits(view, words, run, state.code_a, state.code_b, cut);
  return view;
}

/// A plane across the view volume: w to the right, a coordinate up, so that the volume is a wedge.
void add_plane(View& view, const Wording& words, const State<4>& state, int axis, Extent place,
               std::optional<Border> cut) {
  const auto flat = [axis](const dvec4& p) { return dvec2(p.w, p[axis]); };
  const bool depth = axis == 2;  // there the lower face is z = 0
  const double far = std::max({state.line.a.w, state.line.b.w, 0.0});
  Extent world;
  for (const dvec2 p :
       {dvec2(0), flat(state.line.a), flat(state.line.b), dvec2(far), dvec2(far, depth ? 0 : -far)}) {
    world.add(p);
  }
  const Panel panel({place.lower + dvec2(0.8, 1.6), place.upper - dvec2(0.8, 1.6)}, world);
  const Extent shown = panel.shown();
  const dvec2 eye = panel.at({0, 0});
  const std::string name =
      words.symbol(std::array<std::string_view, 3>{"x", "y", "z"}[static_cast<std::size_t>(axis)]);
  const std::string w = words.symbol("w"), id = fmt::format("plane {} ", axis);
  // The axes through the eye
  view.add({id + "w", Role::guide, Stroke{{place.lower.x, eye.y}, {place.upper.x, eye.y}, true}});
  view.add({id + "w name", Role::guide, Text{{place.upper.x - 0.3, eye.y - 1.0}, w}});
  view.add({id + "axis", Role::guide, Stroke{{eye.x, place.lower.y}, {eye.x, place.upper.y}, true}});
  view.add({id + "axis name", Role::guide, Text{{eye.x, place.upper.y + 0.8}, name}});
  // The wedge between two faces
  const double reach = std::min({shown.upper.x, shown.upper.y, depth ? shown.upper.x : -shown.lower.y});
  const dvec2 upper = panel.at({reach, reach}), lower = panel.at({reach, depth ? 0 : -reach});
  view.add({id + "wedge", Role::accepted, Area{{{eye, upper, lower}}}});
  const auto face = [&](std::string_view which, dvec2 to, bool is_upper_face, const std::string& text) {
    const bool now = cut && axis_of(*cut) == axis && is_upper(*cut) == is_upper_face;
    const Role role = now ? Role::current : Role::boundary;
    view.add({fmt::format("{}{}", id, which), role, Stroke{eye, to}});
    view.add({fmt::format("{}{} name", id, which), role, Label{0.25 * eye + 0.75 * to, text}});
  };
  face("upper", upper, true, fmt::format("{} = {}", name, w));
  face("lower", lower, false, depth ? name + " = 0" : fmt::format("{} = −{}", name, w));
  add_segment(view, id + "line", state, [&](const dvec4& p) { return panel.at(flat(p)); }, "a", "b");
}

View view_of(const Wording& words, const Run& run, const State<4>& state) {
  View view;
  // Seen from the side: w to the right, y up, x towards the reader
  const auto in_space = [](const dvec4& p) { return dvec3(p.w, p.y, -p.x); };
  const double far = std::max({state.line.a.w, state.line.b.w, 0.0});
  std::vector<dvec3> corners;
  for (const dvec2 side : {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)}) {
    corners.push_back(dvec3(1, side.y, -side.x) * far);
  }
  std::vector<dvec3> shown = corners;
  shown.insert(shown.end(), {dvec3(0), in_space(run.seen.a), in_space(run.seen.b)});
  const SpaceView space({{1.2, 19}, {12, 32}}, shown);
  // The pyramid of the sides, its top at the eye; what its sides hide is dashed
  for (std::size_t i = 0; i < 4; ++i) {
    const bool behind = i == 0;
    const std::string number = std::to_string(i);
    view.add(
        {"edge " + number, Role::boundary, Stroke{space.at(dvec3(0)), space.at(corners[i]), false, behind}});
    view.add({"base " + number, Role::boundary,
              Stroke{space.at(corners[i]), space.at(corners[(i + 1) % 4]), false}});
  }
  view.add({"eye", Role::boundary, Dot{space.at(dvec3(0)), true}});
  add_directions(view, {21.9, 4}, {words.symbol("w"), words.symbol("y"), words.symbol("x")}, true);
  std::optional<Border> cut;
  if (!state.moves.empty() && !state.accepted && !state.rejected) cut = state.moves.back().face;
  if (cut && axis_of(*cut) < 2) {
    constexpr std::array<std::array<std::size_t, 2>, 4> sides{{{3, 0}, {1, 2}, {0, 1}, {2, 3}}};
    const auto [i, j] = sides[static_cast<std::size_t>(*cut)];
    add_face(view, "face", space, {dvec3(0), corners[i], corners[j]});
  }
  add_segment(view, "line", state, [&](const dvec4& p) { return space.at(in_space(p)); }, "a", "b");
  add_bits(view, words, run, state.code_a, state.code_b, cut);
  add_plane(view, words, state, run.plane, {{13.6, 18}, {25.6, 32.4}}, cut);
  return view;
}

// --- Telling ---------------------------------------------------------------------------------------------

std::string place_text(const dvec3& p) { return figure_place(p); }
std::string place_text(const dvec4& p) {
  return fmt::format("({},\u00a0{},\u00a0{},\u00a0{})", figure_real(p.x), figure_real(p.y), figure_real(p.z),
                     figure_real(p.w));
}

template <int N>
class Teller {
 public:
  Teller(TraceWriter& writer, const Run& run) : writer_(writer), words_(writer.wording()), run_(run) {
    writer.trace().columns = {{"cut"}, {"code_a"}, {"code_b"}, {"and"}, {"decision", false}};
  }

  void operator()(const Classified<N, double>& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    state_.line = state_.rest = c.line;
    state_.code_a = c.code_a;
    state_.code_b = c.code_b;
    writer_.step(drawn(), {}, source_line, [&](TraceStep& step) {
      step.type = "Classified";
      step.phase = words_.say("words.set_up");
      step.fields = fields();
      step.sentence = words_.say("cohen_sutherland_3d.classified", arg("a", beyond(c.code_a)),
                                 arg("b", beyond(c.code_b)));
      step.row = row();
    });
  }

  void operator()(const Cut<N, double>& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    const Row read = read_row(words_.say("cohen_sutherland_3d.decision.cut", arg("end", c.of_a ? "a" : "b"),
                                         arg("face", name(c.face))));
    state_.moves.push_back({c.of_a, c.face, c.from, c.to()});
    state_.rest = c.line;
    state_.code_a = c.code_a;
    state_.code_b = c.code_b;
    writer_.step(drawn(), {}, source_line, [&](TraceStep& step) {
      step.type = "Cut";
      step.phase = words_.say("words.main_loop");
      step.key = c.of_a ? "a" : "b";
      step.fields = fields();
      step.fields.push_back({"face", std::string(name_of(c.face))});
      step.sentence = words_.say(c.of_a ? "cohen_sutherland_3d.cut.a" : "cohen_sutherland_3d.cut.b",
                                 arg("face", name(c.face)), arg("test", test_of(words_, run_, c.face)),
                                 arg("to", place_text(c.to())), arg("after", text(c.after())));
      step.read = read;
      step.row = row();
    });
  }

  void operator()(const Accepted<N, double>& accepted, int source_line = __builtin_LINE(),
                  const char* = nullptr) {
    state_.accepted = true;
    state_.rest = accepted.line;
    writer_.step(drawn(), {}, source_line, [&](TraceStep& step) {
      step.type = "Accepted";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = fields();
      step.sentence = ending(accepted.line);
      step.read = read_row(words_.say("cohen_sutherland_3d.decision.accept"));
    });
  }

  void operator()(const Rejected& rejected, int source_line = __builtin_LINE(), const char* = nullptr) {
    state_.rejected = true;
    writer_.step(drawn(), {}, source_line, [&](TraceStep& step) {
      step.type = "Rejected";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = fields();
      step.fields.push_back({"common", static_cast<std::int64_t>(rejected.common)});
      step.sentence = rejected.common == 0
                          ? words_.say("cohen_sutherland_3d.gave_up")
                          : words_.say("cohen_sutherland_3d.rejected", arg("faces", faces(rejected.common)));
      step.read = read_row(words_.say("cohen_sutherland_3d.decision.reject"));
    });
  }

 private:
  /// What the step changes: the difference of two whole drawings.
  Delta drawn() { return shown_.change_to(view_of(words_, run_, state_)); }
  std::string name(Border face) const { return face_name(words_, face); }
  std::string ending(const Segment<N, double>& part) const {
    const std::string from = place_text(part.a), to = place_text(part.b);
    if constexpr (N == 4) {
      return words_.say("cohen_sutherland_3d.accepted.volume", arg("from", from), arg("to", to),
                        arg("divided_from", figure_place(dvec3(part.a) / part.a.w)),
                        arg("divided_to", figure_place(dvec3(part.b) / part.b.w)));
    } else {
      return words_.say("cohen_sutherland_3d.accepted.box", arg("from", from), arg("to", to));
    }
  }
  std::string text(Code code) const { return code_text(code, run_.left_first); }
  std::string faces(Code code) const {
    std::string list;
    for (const Border face : usual_order<3>()) {
      if ((code & bit(face)) != 0) list += (list.empty() ? "" : ", ") + name(face);
    }
    return list;
  }
  std::string beyond(Code code) const {
    if (code == 0) return words_.say("cohen_sutherland_3d.inside", arg("code", text(code)));
    return words_.say("cohen_sutherland_3d.beyond", arg("code", text(code)), arg("faces", faces(code)));
  }
  Row row() const {
    return {std::to_string(state_.moves.size()), text(state_.code_a), text(state_.code_b),
            text(static_cast<Code>(state_.code_a & state_.code_b)), ""};
  }
  Row read_row(const std::string& decision) const {
    Row read = row();
    read.back() = decision;
    return read;
  }
  std::vector<Field> fields() const {
    std::vector<Field> fields{{"code_a", static_cast<std::int64_t>(state_.code_a)},
                              {"code_b", static_cast<std::int64_t>(state_.code_b)}};
    constexpr std::array<const char*, 4> axes{"x", "y", "z", "w"};
    for (const bool of_a : {true, false}) {
      for (int i = 0; i < N; ++i) {
        fields.push_back({std::string(of_a ? "a_" : "b_") + axes[static_cast<std::size_t>(i)],
                          (of_a ? state_.rest.a : state_.rest.b)[i]});
      }
    }
    return fields;
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Run& run_;
  State<N> state_;
  Shown shown_;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("cohen_sutherland_3d", std::move(name), standing);
  };
  static const std::vector<Method> methods{method("cut_of_a_cut", Standing::taught),
                                           method("correctly_rounded", Standing::fast),
                                           method(std::string(view_volume_name), Standing::plain)};
  return methods;
}

/// What the steps of the taught method hold.
struct Numbers {
  template <int N, class T>
  void operator()(NumericStep<T>& to, const Classified<N, T>& c) const {
    to.type = "Classified";
    to.point("a", c.line.a);
    to.point("b", c.line.b);
    to.decision(c.code_a);
    to.decision(c.code_b);
  }
  template <int N, class T>
  void operator()(NumericStep<T>& to, const Cut<N, T>& c) const {
    to.type = "Cut";
    to.point(c.of_a ? "a" : "b", c.to());
    to.decision(c.face);
    to.decision(c.after());
  }
  template <int N, class T>
  void operator()(NumericStep<T>& to, const Accepted<N, T>&) const {
    to.type = "Accepted";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rejected&) const {
    to.type = "Rejected";
  }
};

Trace run(const Arguments& arguments, Recording recording) {
  if (arguments.text("method") == "cut_of_a_cut") {
    for (const auto* name : {"line", "box"}) require_sizes(arguments, name, {1e-75, 1e75});
  }
  const Run input = run_of(arguments);
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = trace.wording;
  introduce(trace, "cohen_sutherland_3d", arguments, false);
  trace.grid = paper_grid(paper_width, paper_height);
  trace.legend = {{Role::input, words.say("cohen_sutherland_3d.legend.input")},
                  {Role::current, words.say("cohen_sutherland_3d.legend.current")},
                  {Role::rejected, words.say("cohen_sutherland_3d.legend.rejected")},
                  {Role::result, words.say("cohen_sutherland_3d.legend.result")}};
  // Only what this method reads: the command that makes the trace again needs no more
  std::erase_if(trace.arguments, [&](const Argument& a) {
    return a.name == "homogeneous" ? !input.homogeneous()
                                   : input.homogeneous() && (a.name == "line" || a.name == "box");
  });
  const std::string listed = input.method == "cut_of_a_cut" ? "cut_of_a_cut" : "correctly_rounded";
  trace.source_file = std::string(folder) + "cohen_sutherland_3d.hpp";
  trace.listing = listing_of(source_text(trace.source_file), listed);
  std::int64_t inside = 0;
  if (input.homogeneous()) {
    trace.subtitle = words.say("cohen_sutherland_3d.subtitle", arg("from", place_text(input.seen.a)),
                               arg("to", place_text(input.seen.b)));
    Teller<4> teller(writer, input);
    inside = correctly_rounded(input.seen, ViewVolume{}, input.order, teller).has_value();
  } else {
    trace.subtitle = words.say("cohen_sutherland_3d.subtitle", arg("from", place_text(input.line.a)),
                               arg("to", place_text(input.line.b)));
    Teller<3> teller(writer, input);
    inside = (input.method == "cut_of_a_cut" ? cut_of_a_cut(input.line, input.box, input.order, teller)
                                             : correctly_rounded(input.line, input.box, input.order, teller))
                 .has_value();
  }
  Trace done = std::move(writer).finish();
  done.telling = middle_step(done);
  done.result = {{"inside", inside != 0}};
  if (side_by_side(arguments)) {
    require_method(arguments, {"cut_of_a_cut"});
    show_side_by_side<Numbers>(done, [&]<class T>(T, const auto& observer) {
      cut_of_a_cut(in_scalar<T>(input.line), in_scalar<T>(input.box), input.order, observer);
    });
  }
  return done;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "cohen_sutherland_3d",
      .title = Wording().say("cohen_sutherland_3d.title"),
      .chapter = "clipping",
      .aliases = {"clip segments in space", "six-bit region codes", "view volume"},
      .summary = "the part of a segment in a box or in the view volume, by region codes of six bits",
      .methods = all_methods(),
      .default_method = "cut_of_a_cut",
      .parameters =
          {{.name = "line",
            .type = ParameterType::numbers,
            .default_value = "-2,1,2,12,11,9",
            .example = "-2,1,2,12,11,9",
            .help = "the segment's ends: x0,y0,z0,x1,y1,z1",
            .parts = {"x0", "y0", "z0", "x1", "y1", "z1"},
            .sizes = {1e-300, 1e300}},
           {.name = "box",
            .type = ParameterType::bounds,
            .default_value = "0,0,0,10,8,6",
            .example = "0,0,0,10,8,6",
            .help = "the box: xmin,ymin,zmin,xmax,ymax,zmax; its faces belong to it",
            .parts = {"xmin", "ymin", "zmin", "xmax", "ymax", "zmax"},
            .sizes = {1e-300, 1e300}},
           {.name = "homogeneous",
            .type = ParameterType::numbers,
            .default_value = "-2.2,0.5,1.5,2,2,1,-1.5,-1",
            .example = "-2.2,0.5,1.5,2,2,1,-1.5,-1",
            .help = "method view_volume: the ends x0,y0,z0,w0,x1,y1,z1,w1, not divided by w yet",
            .parts = {"x0", "y0", "z0", "w0", "x1", "y1", "z1", "w1"},
            .sizes = {1e-100, 1e100}},
           order_parameter(),
           {.name = "code_bits",
            .type = ParameterType::choice,
            .default_value = "FNTBRL",
            .example = "LRBTNF",
            .help = "how codes are written: far first, as a binary number (FNTBRL), or left first (LRBTNF)",
            .choices = {"FNTBRL", "LRBTNF"}},
           exact_parameter()},
      .examples = {"--line -2,1,2,12,11,9", "--line -3,5,1,4,12,2 --order top,bottom,left,right,near,far",
                   "--method view_volume --homogeneous -2.2,0.5,1.5,2,2,1,-1.5,-1"},
      .run = run};
  return topic;
}

}  // namespace gradus::cohen_sutherland_3d
