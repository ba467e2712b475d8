// The story of a view: three axes at the eye, the matrix made of them, and what the viewer sees.

#include "projection/viewing/viewing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "projection/viewing/viewing_notes.hpp"
#include "scene/obj.hpp"
#include "stories/paper.hpp"
#include "stories/topic.hpp"
#include "stories/wireframe.hpp"
#include "stories/words.hpp"

namespace gradus::viewing {
namespace {

using fmt::arg;
using DFrame = Frame<double>;

constexpr std::string_view folder = "algorithms/projection/viewing/";
constexpr std::array<std::string_view, 3> axis_names{"right", "up", "forward"};

/// Two panels on a paper of 36 x 27: the world, and what the viewer makes of it.
const Extent world_place{{0.8, 0.8}, {20.2, 24.2}};
const Extent seen_place{{21.9, 5.8}, {35.3, 19.2}};

/// For given axes, on a paper of 21 x 30: the axes, and below them the letter along them and in the world.
const Extent axes_place{{4.4, 15.6}, {16.6, 28.4}};
const Extent along_place{{0.8, 1}, {9.4, 11.6}};
const Extent back_place{{11.8, 1}, {20.2, 11.6}};

/// Of coordinates: farther away the letter is a dot, and numbers don't fit.
constexpr Sizes coordinate_sizes{1e-100, 1e6};

/// Axes that are much shorter or longer don't fit into a drawing with the letter.
constexpr double longest_axis = 1000;

/// What is made of a hint for up along the view.
enum class Along { refused, replaced, divided };

struct Scene {
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

Mesh shipped_letter() {
  const auto open = [](const std::string& name) { return std::optional(std::string(shipped_model(name))); };
  return pipeline::parse_obj(shipped_model("letter_f.obj"), "letter_f.obj", open).mesh;
}

/// An eye with three axes of any lengths and angles.
Scene scene_of_axes(const Arguments& arguments) {
  const dvec3 eye = *arguments.place("eye");
  const auto axes = arguments.places("axes");
  const auto expected = [&](std::string_view what) {
    return ArgumentError("axes", fmt::format("{} expected, found {}", what, arguments.text("axes")));
  };
  for (const dvec3 axis : axes) {
    const double length = length_of(axis);
    if (length < 1 / longest_axis || length > longest_axis)
      throw expected(fmt::format("axes of lengths from {} to {}", 1 / longest_axis, longest_axis));
  }
  const Rescaled<double> x(axes[0]), y(axes[1]), z(axes[2]);
  if (std::abs(glm::dot(x.axis, glm::cross(y.axis, z.axis))) <= 1e-6)
    throw expected("three axes that don't lie in one plane");
  const dvec3 middle{0.4, 0.6, 0};  // of the letter
  return {eye,
          middle,
          {0, 1, 0},
          std::max(1.0, length_of(middle - eye)),
          shipped_letter(),
          DFrame{eye, axes[0], axes[1], axes[2]}};
}

Scene scene_of(const Arguments& arguments, Along along) {
  Scene scene{*arguments.place("eye"), *arguments.place("target"), *arguments.place("up"), 0, {}};
  scene.along = along;
  if (scene.eye == scene.target)
    refuse(arguments, {"target", "eye"}, "a target apart from the eye expected, found both in one point");
  if (scene.up == dvec3{0})
    refuse(arguments, {"up"}, "a direction expected, found 0,0,0, which points nowhere");
  const double sine = sine_between(scene.target - scene.eye, scene.up);
  if (along == Along::divided && !is_finite(scene.frame().right))
    refuse(arguments, {"up", "target", "eye"},
           "a hint for up that leaves something to divide by expected, this one gives 0 / 0");
  if (along == Along::refused && !(sine >= least_sine<double>)) {
    refuse(arguments, {"up", "target", "eye"},
           fmt::format("an up apart from the view direction expected, found {}, which is parallel to it",
                       arguments.text("up")));
  }
  scene.distance = length_of(scene.target - scene.eye);
  scene.letter = shipped_letter();
  return scene;
}

/// What a matrix makes of a point.
dvec3 through(const glm::dmat4& matrix, dvec3 p) { return dvec3(matrix * glm::dvec4(p, 1)); }

/// A number without what rounding has left where exact arithmetic says 0: below 2^-40 of `size`.
double neat(double x, double size) { return std::abs(x) < 0x1p-40 * size ? 0 : x; }
dvec3 neat(dvec3 v, double size) { return {neat(v.x, size), neat(v.y, size), neat(v.z, size)}; }

/// The size of the largest term of a product of two vectors.
double largest_product(dvec3 a, dvec3 b) {
  return std::max({std::abs(a.x * b.x), std::abs(a.y * b.y), std::abs(a.z * b.z)});
}

/// A product of two vectors with its numbers: "0.8·2.8 + 0·3.6 + (−0.6)·3.2".
std::string product_text(dvec3 a, dvec3 b) {
  const auto factor = [](double x) { return x < 0 ? "(" + figure_real(x) + ")" : figure_real(x); };
  return fmt::format("{}·{} + {}·{} + {}·{}", factor(a.x), factor(b.x), factor(a.y), factor(b.y), factor(a.z),
                     factor(b.z));
}

/// The drawings of a run. What is known grows from step to step.
class Drawing {
 public:
  Drawing(const Scene& scene, const Wording& words)
      : scene_(scene),
        words_(words),
        wires_(scene.letter),
        world_(scene.axes ? axes_place : world_place, world_extent()) {}

  /// How many axes of the frame are drawn, which of them is new (-1: none), and how much of the matrix.
  struct Known {
    std::array<bool, 3> axes{};
    int newest = -1;
    int rows = 0;       ///< of the matrix, from above
    bool seen = false;  ///< the model is drawn as the matrix has it
  };

  View world(const Known& known, const DFrame& frame) const {
    View view;
    caption(view, "world", {world_place.centre().x, 26});
    add_world_axes(view);
    letter(
        view, "world", Role::past, parallel_sight({0.42, 0.3, 1}),
        [&](dvec3 p) { return std::optional(world_.at(oblique(p))); }, world_place);
    const double size = 0.3 * scene_.distance;
    hidden_aware(view, "sight", Role::guide, scene_.eye, scene_.target);
    if (!known.axes[1]) {
      arrow(view, "hint", Role::candidate, scene_.eye, scene_.eye + size * unit_vector(scene_.up),
            words_.say("viewing.hint"), true);
    }
    for (int i = 0; i < 3; ++i) {
      if (!known.axes[static_cast<std::size_t>(i)]) continue;
      const std::string name(axis_names[static_cast<std::size_t>(i)]);
      arrow(view, "axis " + name, i == known.newest ? Role::current : Role::accepted, scene_.eye,
            scene_.eye + size * axis_of(frame, i), words_.say("viewing.name." + name), false);
    }
    point(view, "eye", Role::input, scene_.eye, words_.say("viewing.name.eye"));
    point(view, "target", Role::input, scene_.target, words_.say("viewing.name.target"));
    return view;
  }

  /// The picture: x / depth to the right, y / depth up; the letter in it once the matrix is whole.
  void add_picture(View& view, const Known& known, const glm::dmat4& matrix) const {
    caption(view, "picture", {seen_place.centre().x, 26});
    frame_of(view);
    const Panel panel(seen_place, picture_extent(matrix));
    const dvec2 middle = seen_place.centre();
    if (known.rows >= 1) {
      guide_line(view, "no right", {middle.x, seen_place.lower.y}, {middle.x, seen_place.upper.y});
    }
    if (known.rows >= 2) {
      guide_line(view, "no up", {seen_place.lower.x, middle.y}, {seen_place.upper.x, middle.y});
    }
    if (known.rows >= 3) {
      const dvec3 target = through(matrix, scene_.target);
      view.add({"seen target", Role::accepted, Dot{panel.at(dvec2(target) / target.z)}});
      view.add({"seen target name", Role::accepted,
                Label{panel.at(dvec2(target) / target.z), words_.say("viewing.name.target")}});
    }
    if (!known.seen) return;
    const auto seen = [&](dvec3 p) -> std::optional<dvec2> {
      const dvec3 v = through(matrix, p);
      if (v.z <= 0) return std::nullopt;
      return panel.at(dvec2(v) / v.z);
    };
    letter(view, "picture", Role::result, central_sight(scene_.eye), seen, seen_place);
  }

  /// View space from aside, where a faulty matrix leaves the letter: right to the right, up up, depth to the
  /// back.
  void add_view_space(View& view, const Known& known, const glm::dmat4& wrong,
                      const glm::dmat4& right) const {
    caption(view, "view_space", {seen_place.centre().x, 26});
    const auto flat = [](dvec3 v) { return oblique({v.x, v.y, -v.z}); };
    Extent all;
    all.add(flat({0, 0, 0}));
    for (const dvec3 p : {scene_.eye, scene_.target}) all.add(flat(through(wrong, p)));
    const double size = 0.3 * scene_.distance;
    for (const dvec3 tip : {dvec3{size, 0, 0}, dvec3{0, size, 0}, dvec3{0, 0, scene_.distance}})
      all.add(flat(tip));
    const Extent place{{21.8, 1.5}, {35, 24}};
    const Panel panel(place, widened(all, 0.06));
    const auto at = [&](dvec3 v) { return panel.at(flat(v)); };
    const auto line = [&](std::string id, Role role, dvec3 tip, std::string_view name) {
      view.add({id, role, Stroke{at({0, 0, 0}), at(tip), true}});
      view.add({id + " name", role, Label{at(tip), words_.say("viewing.name." + std::string(name))}});
    };
    line("space right", Role::guide, {size, 0, 0}, "right");
    line("space up", Role::guide, {0, size, 0}, "up");
    line("space forward", Role::guide, {0, 0, scene_.distance}, "forward");
    view.add({"space eye", Role::input, Dot{at({0, 0, 0})}});
    if (!known.seen) return;
    const dvec3 there = through(wrong, scene_.target), here = through(right, scene_.target);
    const dvec3 eye = through(wrong, scene_.eye);
    view.add({"sight there", Role::rejected, Stroke{at(eye), at(there), false, true}});
    if (length_of(eye) > 1e-9 * scene_.distance) {
      view.add({"eye there", Role::rejected, Dot{at(eye)}});
      view.add({"eye there name", Role::rejected, Label{at(eye), words_.say("viewing.name.eye")}});
    }
    view.add({"target here", Role::accepted, Dot{at(here), true}});
    view.add({"target here name", Role::accepted, Label{at(here), words_.say("viewing.belongs")}});
    view.add({"target there", Role::rejected, Dot{at(there)}});
    view.add({"target there name", Role::rejected, Label{at(there), words_.say("viewing.name.target")}});
  }

  /// Given axes at the eye, and as many columns of the inverse as are known.
  View given_axes(const Known& known, const DFrame& frame) const {
    View view;
    const glm::dmat4 inverse = inverse_of_any_frame(frame);
    const double unit = arrow_unit(frame);
    for (int i = 0; i < 3; ++i) {
      const std::string name(axis_names[static_cast<std::size_t>(i)]);
      arrow(view, "axis " + name, Role::input, scene_.eye, scene_.eye + unit * axis_of(frame, i),
            words_.say("viewing.name." + name), false);
      if (i >= known.rows) continue;
      arrow(view, "column " + name, i == known.newest ? Role::current : Role::accepted, scene_.eye,
            scene_.eye + unit * dvec3(inverse[i]),
            words_.say("viewing.column_name", arg("axis", words_.say("viewing.name." + name))), true);
    }
    point(view, "eye", Role::input, scene_.eye, words_.say("viewing.name.eye"));
    return view;
  }

  /// The letter in coordinates along the axes, and in the world, where the inverse leads it back to.
  void add_there_and_back(View& view, const Known& known, const DFrame& frame) const {
    const glm::dmat4 matrix = world_to_view(frame), inverse = inverse_of_any_frame(frame);
    const auto along = [&](dvec3 p) { return through(matrix, p); };
    const auto back = [&](dvec3 p) { return known.seen ? through(inverse, through(matrix, p)) : p; };
    // Depth is positive along the axes, and to the back
    const auto to_the_back = [](dvec3 v) { return oblique({v.x, v.y, -v.z}); };
    view.add(
        {"caption coordinates", Role::guide,
         Text{{0.3, along_place.upper.y + 1.4}, words_.say("viewing.caption.coordinates"), Align::left}});
    caption(view, "world", {back_place.centre().x, back_place.upper.y + 1.4});
    add_wires(view, "along", Role::past, along_place, [&](dvec3 p) { return to_the_back(along(p)); });
    add_wires(view, "back", known.seen ? Role::result : Role::past, back_place,
              [&](dvec3 p) { return oblique(back(p)); });
    if (!known.seen) return;
    const double y = along_place.centre().y;
    view.add({"leads back", Role::result,
              Stroke{{along_place.upper.x + 0.2, y}, {back_place.lower.x - 0.2, y}, true}});
  }

 private:
  /// The letter, all its edges alike. flat(p): a point's place in the plane.
  template <class Flat>
  void add_wires(View& view, const std::string& name, Role role, const Extent& place, Flat flat) const {
    Extent all;
    for (const auto& [a, b] : wires_.edges()) {
      all.add(flat(a));
      all.add(flat(b));
    }
    const Panel panel(place, widened(all, 0.04));
    int number = 0;
    for (const auto& [a, b] : wires_.edges()) {
      view.add({fmt::format("letter {} {:02}", name, number++), role,
                Stroke{panel.at(flat(a)), panel.at(flat(b))}});
    }
  }
  /// Paper lengths of given axes and the inverse's columns have one scale.
  double arrow_unit(const DFrame& frame) const {
    const glm::dmat4 inverse = inverse_of_any_frame(frame);
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      longest = std::max({longest, length_of(axis_of(frame, i)), length_of(dvec3(inverse[i]))});
    }
    return 0.45 * scene_.distance / longest;
  }

  Extent world_extent() const {
    Extent extent;
    const double size = 0.3 * scene_.distance;
    const auto add = [&](dvec3 p) { extent.add(oblique(p)); };
    const DFrame frame = scene_.frame();
    if (scene_.axes) {
      const glm::dmat4 inverse = inverse_of_any_frame(frame);
      const double unit = arrow_unit(frame);
      add(scene_.eye);
      for (int i = 0; i < 3; ++i) {
        add(scene_.eye + unit * axis_of(frame, i));
        add(scene_.eye + unit * dvec3(inverse[i]));
      }
      return widened(extent, 0.06);
    }
    for (const auto& [a, b] : wires_.edges()) {
      add(a);
      add(b);
    }
    add(scene_.target);
    for (const dvec3 way : {frame.right, frame.up, frame.forward, unit_vector(scene_.up), dvec3{0}})
      add(scene_.eye + size * way);
    for (const dvec3 tip : {dvec3{1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, 0, 1}, dvec3{0}})
      add(axis_length() * tip);
    return widened(extent, 0.06);
  }
  double axis_length() const { return std::max(1.6, 0.25 * scene_.distance); }

  /// What the picture shows round its middle, the target: the letter, where it is in front.
  Extent picture_extent(const glm::dmat4& matrix) const {
    double half = 0.05;
    for (const auto& [a, b] : wires_.edges()) {
      for (const dvec3 p : {a, b}) {
        const dvec3 v = through(matrix, p);
        if (v.z > 0) half = std::max({half, std::abs(v.x / v.z), std::abs(v.y / v.z)});
      }
    }
    half = std::min(1.2 * half, 1.5);
    return {{-half, -half}, {half, half}};
  }

  void caption(View& view, std::string_view key, dvec2 at) const {
    view.add({fmt::format("caption {}", key), Role::guide,
              Text{at, words_.say("viewing.caption." + std::string(key))}});
  }
  void frame_of(View& view) const {
    const auto& [lower, upper] = seen_place;
    view.add({"picture frame", Role::boundary,
              Path{{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}, true}});
  }
  static void guide_line(View& view, std::string id, dvec2 a, dvec2 b) {
    view.add({std::move(id), Role::guide, Stroke{a, b, false, true}});
  }
  void add_world_axes(View& view) const {
    for (const auto& [name, way] :
         {std::pair{"x", dvec3{1, 0, 0}}, {"y", dvec3{0, 1, 0}}, {"z", dvec3{0, 0, 1}}}) {
      const dvec2 tip = world_.at(oblique(axis_length() * way));
      view.add({fmt::format("world {}", name), Role::guide, Stroke{world_.at({0, 0}), tip, true}});
      view.add({fmt::format("world {} name", name), Role::guide, Label{tip, words_.symbol(name)}});
    }
  }
  void point(View& view, const std::string& id, Role role, dvec3 at, std::string name) const {
    view.add({id, role, Dot{world_.at(oblique(at))}});
    view.add({id + " name", role, Label{world_.at(oblique(at)), std::move(name)}});
  }
  void arrow(View& view, const std::string& id, Role role, dvec3 from, dvec3 to, std::string name,
             bool dashed) const {
    view.add({id, role, Stroke{world_.at(oblique(from)), world_.at(oblique(to)), true, dashed}});
    view.add({id + " name", role, Label{world_.at(oblique(to)), std::move(name)}});
  }
  /// A segment of the world, dashed where the letter hides it.
  void hidden_aware(View& view, const std::string& id, Role role, dvec3 a, dvec3 b) const {
    int number = 0;
    for (const auto& [from, to, hidden] : wires_.pieces(a, b, parallel_sight({0.42, 0.3, 1}))) {
      view.add({fmt::format("{} {}", id, number++), role,
                Stroke{world_.at(oblique(a + from * (b - a))), world_.at(oblique(a + to * (b - a))), false,
                       hidden}});
    }
  }
  template <class At>
  void letter(View& view, const std::string& name, Role role, const SightFrom& sight, At at,
              const Extent& place) const {
    int edge = 0;
    for (const auto& [a, b] : wires_.edges()) {
      int number = 0;
      for (const auto& [from, to, hidden] : wires_.pieces(a, b, sight)) {
        const auto p = at(a + from * (b - a)), q = at(a + to * (b - a));
        if (!p || !q) continue;
        if (auto part = shown_part(place, *p, *q)) {
          part->dashed = hidden;
          view.add({fmt::format("letter {} {:02} {}", name, edge, number), role, *part});
        }
        ++number;
      }
      ++edge;
    }
  }

  const Scene& scene_;
  const Wording& words_;
  Wireframe wires_;
  Panel world_;
};

enum class Kind { rows, inverse, any_frame, faulty };

/// Tells the steps: the frame, the matrix, and what it makes of the target.
class Teller {
 public:
  Teller(TraceWriter& writer, const Scene& scene, Kind kind)
      : writer_(writer), words_(writer.wording()), scene_(scene), kind_(kind), drawing_(scene, words_) {
    writer.trace().columns = {{"axis", false}, {"x"}, {"y"}, {"z"}, {"last"}};
    frame_ = scene.frame();  // where axes will be, so that nothing jumps
    right_ = world_to_view(frame_);
  }

  void input() {
    if (kind_ == Kind::any_frame) {
      step(0, "Input", "eye", words_.say("words.set_up"),
           words_.say("viewing.input_axes", arg("right", figure_place(frame_.right)),
                      arg("up", figure_place(frame_.up)), arg("forward", figure_place(frame_.forward))),
           {}, {});
      return;
    }
    step(0, "Input", "eye", words_.say("words.set_up"),
         words_.say("viewing.input", arg("eye", figure_place(scene_.eye)),
                    arg("target", figure_place(scene_.target)), arg("up", figure_place(scene_.up))),
         {}, {});
  }

  void operator()(const Aimed<double>& a, int line = __builtin_LINE(), const char* = nullptr) {
    learn(2);
    const dvec3 along = a.target - a.eye;
    step(line, "Aimed", "forward", words_.say("viewing.phase.frame"),
         words_.say("viewing.aimed", arg("along", figure_place(along)),
                    arg("distance", figure_real(scene_.distance)),
                    arg("forward", figure_place(neat(a.forward, 1)))),
         fields("forward", a.forward), {});
  }
  void operator()(const HintReplaced<double>& h, int line = __builtin_LINE(), const char* = nullptr) {
    step(line, "HintReplaced", "hint", words_.say("viewing.phase.frame"),
         words_.say("viewing.hint_replaced", arg("up", figure_place(h.up_hint)),
                    arg("spare", figure_place(h.spare))),
         fields("hint", h.spare), {});
  }
  void operator()(const Levelled<double>& l, int line = __builtin_LINE(), const char* = nullptr) {
    learn(0);
    const dvec3 across = glm::cross(frame_.forward, l.up_hint);
    step(line, "Levelled", "right", words_.say("viewing.phase.frame"),
         words_.say("viewing.levelled", arg("across", figure_place(neat(across, length_of(across)))),
                    arg("length", figure_real(length_of(across))),
                    arg("right", figure_place(neat(l.right, 1)))),
         fields("right", l.right), {});
  }
  void operator()(const Framed<double>& f, int line = __builtin_LINE(), const char* = nullptr) {
    learn(1);
    step(line, "Framed", "up", words_.say("viewing.phase.frame"),
         words_.say("viewing.framed", arg("up", figure_place(neat(f.frame.up, 1)))), fields("up", f.frame.up),
         {});
  }
  void operator()(const RowWritten<double>& r, int line = __builtin_LINE(), const char* = nullptr) {
    known_.newest = r.row;
    ++known_.rows;
    const dvec3 axis = neat(r.axis, 1);
    // The sum of the products as they are shown
    const double along = neat(-glm::dot(axis, scene_.eye), largest_product(axis, scene_.eye));
    const bool faulty = method_ == "minus_position" || method_ == "transposed";
    const double shift = faulty ? r.shift : along;
    const std::string name(axis_names[static_cast<std::size_t>(r.row)]);
    std::string sentence;
    if (method_ == "minus_position") {
      sentence = words_.say("viewing.position_row", arg("axis", words_.say("viewing.name." + name)),
                            arg("shift", figure_real(shift)), arg("right", figure_real(along)));
    } else if (method_ == "transposed") {
      sentence = words_.say("viewing.transposed_row", arg("entries", figure_place(axis)),
                            arg("axis", figure_place(neat(axis_of(frame_, r.row), 1))));
    } else {
      sentence = words_.say("viewing.row", arg("axis", words_.say("viewing.name." + name)),
                            arg("product", product_text(axis, scene_.eye)), arg("shift", figure_real(shift)));
    }
    step(
        line, "RowWritten", name, words_.say("viewing.phase.matrix"), std::move(sentence),
        {{"row", std::int64_t{r.row}}, {"x", r.axis.x}, {"y", r.axis.y}, {"z", r.axis.z}, {"shift", r.shift}},
        {kind_ == Kind::faulty && method_ == "transposed"
             ? words_.say("viewing.row_number", arg("n", r.row + 1))
             : words_.say("viewing.name." + name),
         figure_real(axis.x), figure_real(axis.y), figure_real(axis.z), figure_real(shift)});
  }
  void operator()(const ColumnWritten<double>& c, int line = __builtin_LINE(), const char* = nullptr) {
    known_.newest = c.column < 3 ? c.column : -1;
    known_.rows = std::min(3, c.column + 1);
    const std::string name(c.column < 3 ? axis_names[static_cast<std::size_t>(c.column)] : "eye");
    const double size = kind_ == Kind::any_frame ? length_of(c.entries) : 1;
    const dvec3 entries = c.column < 3 ? neat(c.entries, size) : c.entries;
    std::string sentence = words_.say("viewing.eye_column", arg("eye", figure_place(entries)));
    if (c.column < 3) {
      sentence = kind_ == Kind::any_frame
                     ? reciprocal_sentence(c.column, entries)
                     : words_.say("viewing.column", arg("axis", words_.say("viewing.name." + name)),
                                  arg("entries", figure_place(entries)));
    }
    step(line, "ColumnWritten", name, words_.say("viewing.phase.matrix"), std::move(sentence),
         {{"column", std::int64_t{c.column}}, {"x", c.entries.x}, {"y", c.entries.y}, {"z", c.entries.z}},
         {words_.say("viewing.name." + name), figure_real(entries.x), figure_real(entries.y),
          figure_real(entries.z), c.column < 3 ? "0" : "1"});
  }

  /// The inverse is whole: the matrix times it, row by row.
  void products(const glm::dmat4& inverse) {
    const int line = writer_.trace().listing.back().number;  // the inverse is returned
    const glm::dmat4 product = right_ * inverse;
    known_.newest = -1;
    for (int row = 0; row < 3; ++row) {
      const std::string name(axis_names[static_cast<std::size_t>(row)]);
      const dvec3 axis = axis_of(frame_, row), column(inverse[row]);
      std::array<std::string, 4> entries;
      for (int k = 0; k < 4; ++k) {
        const double size = length_of(axis) * length_of(dvec3(inverse[k]));
        entries[static_cast<std::size_t>(k)] = figure_real(neat(product[k][row], size));
      }
      const auto& [x, y, z, last] = entries;
      step(line, "RowMultiplied", name, words_.say("viewing.phase.check"),
           words_.say(
               "viewing.product_row", arg("axis", words_.say("viewing.name." + name)),
               arg("product", product_text(neat(axis, length_of(axis)), neat(column, length_of(column)))),
               arg("value", entries[static_cast<std::size_t>(row)])),
           {{"row", std::int64_t{row}},
            {"right", product[0][row]},
            {"up", product[1][row]},
            {"forward", product[2][row]},
            {"eye", product[3][row]}},
           {words_.say("viewing.product_name", arg("axis", words_.say("viewing.name." + name))), x, y, z,
            last});
    }
    known_.seen = true;
    step(line, "Inverted", "product", words_.say("words.result"),
         is_upright(frame_) ? words_.say("viewing.inverted_upright") : transposed_sentence(), {}, {});
  }

  /// The matrix is whole: what it makes of the target, then of the letter.
  void result(const glm::dmat4& matrix) {
    known_.newest = -1;
    known_.rows = 3;
    known_.seen = true;
    const double size = length_of(scene_.eye) + length_of(scene_.target);
    const int line = writer_.trace().listing.back().number;  // the matrix is returned
    if (kind_ == Kind::inverse) {
      const dvec3 back = through(matrix, {0, 0, scene_.distance});
      step(line, "Viewed", "target", words_.say("words.result"),
           words_.say("viewing.led_back", arg("view", figure_place(dvec3{0, 0, scene_.distance})),
                      arg("target", figure_place(neat(back, size)))),
           fields("world", back), {});
      return;
    }
    matrix_ = matrix;
    const dvec3 seen = through(matrix, scene_.target);
    const double sine = sine_between(scene_.target - scene_.eye, scene_.up);
    const bool by_chance = scene_.along == Along::divided && sine < least_sine<double>;
    const std::string key = by_chance             ? "viewing.by_chance"
                            : kind_ == Kind::rows ? "viewing.viewed"
                                                  : "viewing.off_the_axis";
    step(line, "Viewed", "target", words_.say("words.result"),
         words_.say(key, arg("view", figure_place(neat(seen, size))), arg("sine", figure_real(sine)),
                    arg("right", figure_place(neat(frame_.right, 1))),
                    arg("distance", figure_real(scene_.distance))),
         fields("view", seen), {words_.say("viewing.last_row"), "0", "0", "0", "1"});
  }

  void set_method(std::string name) { method_ = std::move(name); }

 private:
  std::string axis_name(int number) const {
    return words_.say("viewing.name." + std::string(axis_names[static_cast<std::size_t>(number % 3)]));
  }
  /// Where a column of the inverse comes from: a cross product, divided by the determinant.
  std::string reciprocal_sentence(int column, dvec3 entries) const {
    const dvec3 a = axis_of(frame_, (column + 1) % 3), b = axis_of(frame_, (column + 2) % 3);
    const dvec3 cross = glm::cross(a, b);
    const double det = glm::dot(axis_of(frame_, column), cross);
    return words_.say("viewing.reciprocal", arg("axis", axis_name(column)), arg("a", axis_name(column + 1)),
                      arg("b", axis_name(column + 2)),
                      arg("cross", figure_place(neat(cross, length_of(cross)))), arg("det", figure_real(det)),
                      arg("entries", figure_place(entries)));
  }
  /// What the transposed matrix would give in place of the identity, where it is wrong most.
  std::string transposed_sentence() const {
    int worst_row = 0, worst_column = 0;
    double worst = -1;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const double wanted = row == column ? 1 : 0;
        const double off = std::abs(glm::dot(axis_of(frame_, row), axis_of(frame_, column)) - wanted);
        if (off <= worst) continue;
        worst = off;
        worst_row = row;
        worst_column = column;
      }
    }
    const double value = glm::dot(axis_of(frame_, worst_row), axis_of(frame_, worst_column));
    return words_.say("viewing.inverted", arg("a", axis_name(worst_row)), arg("b", axis_name(worst_column)),
                      arg("value", figure_real(value)), arg("wanted", worst_row == worst_column ? 1 : 0));
  }
  void learn(int axis) {
    known_.axes[static_cast<std::size_t>(axis)] = true;
    known_.newest = axis;
  }
  static std::vector<Field> fields(const std::string& name, dvec3 v) {
    return {{name + ".x", v.x}, {name + ".y", v.y}, {name + ".z", v.z}};
  }
  void step(int line, std::string type, std::string key, std::string phase, std::string sentence,
            std::vector<Field> fields, Row row) {
    View view =
        kind_ == Kind::any_frame ? drawing_.given_axes(known_, frame_) : drawing_.world(known_, frame_);
    if (kind_ == Kind::any_frame) {
      drawing_.add_there_and_back(view, known_, frame_);
    } else if (kind_ == Kind::faulty) {
      drawing_.add_view_space(view, known_, known_.seen ? matrix_ : wrong_, right_);
    } else {
      drawing_.add_picture(view, known_, right_);
    }
    Delta delta = shown_.change_to(std::move(view));
    writer_.step(std::move(delta), {0, 0}, line, [&](TraceStep& told) {
      told.type = std::move(type);
      told.key = std::move(key);
      told.phase = std::move(phase);
      told.sentence = std::move(sentence);
      told.fields = std::move(fields);
      told.row = std::move(row);
    });
  }

 public:
  /// What the matrix will be, so that the drawing's place for it stays the same from the start.
  void foresee(const glm::dmat4& wrong) { wrong_ = wrong; }

 private:
  TraceWriter& writer_;
  const Wording& words_;
  const Scene& scene_;
  Kind kind_;
  Drawing drawing_;
  Drawing::Known known_;
  DFrame frame_;
  glm::dmat4 right_{1}, wrong_{1}, matrix_{1};
  std::string method_;
  Shown shown_;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("viewing", std::move(name), standing);
  };
  static const std::vector<Method> methods{
      method("world_to_view", Standing::taught),       method("view_to_world", Standing::plain),
      method("inverse_of_any_frame", Standing::plain), method("spare_up", Standing::plain),
      method("minus_position", Standing::faulty),      method("transposed", Standing::faulty),
      method("cross_products", Standing::faulty)};
  return methods;
}

const Method& method_named(std::string_view name) {
  for (const Method& method : all_methods()) {
    if (method.name == name) return method;
  }
  throw ArgumentError("method", "a method of viewing expected");
}

/// What makes the frame and, below it, what makes the matrix; both stand in one file, or one of them in the
/// notes', which then is listed alone.
void list_source(Trace& trace, const Method& method) {
  const bool notes = method.standing == Standing::faulty;
  trace.source_file = std::string(folder) + (notes ? "viewing_notes.hpp" : "viewing.hpp");
  const std::string_view source = source_text(trace.source_file);
  const bool given_axes = method.name == "inverse_of_any_frame";
  if (!notes && !given_axes) trace.listing = listing_of(source, "look_at");
  const auto add = [&](std::string_view function) {
    for (SourceLine& line : listing_of(source, function)) trace.listing.push_back(std::move(line));
  };
  add(method.name);
  if (method.name == "spare_up") add("world_to_view");
}

Trace run(const Arguments& arguments, Recording recording) {
  const Method& method = method_named(arguments.text("method"));
  const bool any_frame = method.name == "inverse_of_any_frame";
  const bool untested = method.name == "cross_products";
  const Along along = method.name == "spare_up" ? Along::replaced
                      : untested                ? Along::divided
                                                : Along::refused;
  const Scene scene = any_frame ? scene_of_axes(arguments) : scene_of(arguments, along);
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = trace.wording;
  trace.subtitle = any_frame ? words.say("viewing.subtitle_axes", arg("eye", figure_place(scene.eye)))
                             : words.say("viewing.subtitle", arg("eye", figure_place(scene.eye)),
                                         arg("target", figure_place(scene.target)));
  const bool faulty = method.standing == Standing::faulty;
  introduce(trace, "viewing", arguments, faulty);
  // Only what this method reads
  std::erase_if(trace.arguments, [&](const Argument& a) {
    return any_frame ? a.name == "target" || a.name == "up" : a.name == "axes";
  });
  trace.grid = any_frame ? paper_grid(21, 30) : paper_grid(36, 27);
  trace.legend = {{Role::input, words.say("viewing.legend.input")},
                  {Role::current, words.say("viewing.legend.current")},
                  {Role::accepted, words.say("viewing.legend.accepted")}};
  const bool other_matrix = faulty && !untested;
  trace.legend.push_back(other_matrix
                             ? LegendEntry{Role::rejected, words.say("viewing.legend.rejected")}
                             : LegendEntry{Role::result, words.say(any_frame ? "viewing.legend.result_axes"
                                                                             : "viewing.legend.result")});
  list_source(trace, method);

  const Kind kind = other_matrix                     ? Kind::faulty
                    : any_frame                      ? Kind::any_frame
                    : method.name == "view_to_world" ? Kind::inverse
                                                     : Kind::rows;
  Teller teller(writer, scene, kind);
  teller.set_method(method.name);
  const DFrame known = scene.frame();
  teller.foresee(method.name == "minus_position" ? minus_position(known) : transposed(known));
  teller.input();
  // The exhibits' listing has one of the two: the other is told without its lines
  const auto told_as = [&](bool listed) {
    return [&teller, listed]<class Step>(const Step& step, int line = __builtin_LINE(),
                                         const char* = nullptr) { teller(step, listed ? line : 0); };
  };
  const DFrame frame = any_frame ? known : scene.aimed(told_as(!other_matrix));
  glm::dmat4 matrix;
  if (kind == Kind::rows) matrix = world_to_view(frame, told_as(!untested));
  if (method.name == "view_to_world") matrix = view_to_world(frame, teller);
  if (method.name == "minus_position") matrix = minus_position(frame, teller);
  if (method.name == "transposed") matrix = transposed(frame, teller);
  if (any_frame) matrix = inverse_of_any_frame(frame, teller);
  any_frame ? teller.products(matrix) : teller.result(matrix);
  Trace done = std::move(writer).finish();
  done.telling = {done.last, 0};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      done.result.push_back({fmt::format("m{}{}", row, column), matrix[column][row] + 0.0});
    }
  }
  return done;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  const auto numbers = [](std::string name, std::string value, std::string example, std::string help) {
    Parameter parameter{std::move(name), ParameterType::numbers, std::move(value), std::move(example),
                        std::move(help)};
    parameter.parts = {"x", "y", "z"};
    parameter.sizes = coordinate_sizes;
    return parameter;
  };
  static const TopicEntry topic{
      .name = "viewing",
      .title = Wording().say("viewing.title"),
      .chapter = "projection",
      .aliases = {"look at", "lookat", "view matrix", "world to view", "camera"},
      .summary = "the frame of a viewer, and the matrix that takes the world to it",
      .methods = all_methods(),
      .default_method = "world_to_view",
      .parameters = {numbers("eye", "2.8,3.6,3.2", "3,2,5", "where the viewer is: x,y,z in world units"),
                     numbers("target", "0.4,0.6,0", "0,0,0", "what the viewer looks at"),
                     numbers("up", "0,1,0", "0,0,1",
                             "what points up in the picture: a direction of any length"),
                     {.name = "axes",
                      .type = ParameterType::points,
                      .default_value = "2,0,0 1,1,0 0,-0.5,-1",
                      .example = "1,0,0 0,2,0 0.5,0,-1",
                      .help = "method inverse_of_any_frame: right, up and forward, of any lengths and angles",
                      .least = 3,
                      .most = 3,
                      .parts = {"x", "y", "z"}}},
      .examples = {"--eye 2.8,3.6,3.2 --target 0.4,0.6,0", "--eye 3,2,5 --target 0,0,0 --up 0,1,0",
                   "--eye 2,3,5 --target 0,0,0 --method transposed",
                   "--eye 0.4,5,0 --target 0.4,0.6,0 --method spare_up"},
      .run = run};
  return topic;
}

}  // namespace gradus::viewing
