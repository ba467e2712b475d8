// The story of a segment and the values of t at which it enters and leaves.

#include "clipping/liang_barsky/liang_barsky.hpp"

#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "stories/clipping/box_view.hpp"
#include "stories/clipping/window_view.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::liang_barsky {
namespace {

using fmt::arg;

constexpr std::string_view folder = "algorithms/clipping/liang_barsky/";

struct Task {
  Segment<2, double> line;
  Rectangle<double> window;
  Order order;
};

/// What a border has said by now.
struct Value {
  Border border;
  Crossing crossing;
  double t;
};

class Teller {
 public:
  Teller(TraceWriter& writer, const Task& task)
      : writer_(writer),
        words_(writer.wording()),
        task_(task),
        scene_(task.line, task.window, {{3.2, 9.8}, {35, 26}}),
        scale_({3.5, 2.3}, {32.5, 2.3}, least(task), most(task)) {}

  void operator()(const Started<double>& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    show(drawing(), source_line, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.key = "start";
      step.fields = {{"dx", s.d.x}, {"dy", s.d.y}};
      step.sentence =
          words_.say("liang_barsky.started", arg("a", figure_place(s.line.a)), arg("d", figure_place(s.d)));
      step.row = writer_.trace().method == "parametric" ? row("", "", "", "", "") : Row{"", "", "", "a", "b"};
    });
  }

  void operator()(const Tested<double>& t, int source_line = __builtin_LINE(), const char* = nullptr) {
    enter_ = t.enter;
    leave_ = t.leave;
    values_.push_back({t.border, t.crossing, t.t});
    show(drawing(), source_line, [&](TraceStep& step) {
      step.type = "Tested";
      step.phase = words_.say("words.main_loop");
      step.key = std::string(name_of(t.border));
      step.fields = {{"border", std::string(name_of(t.border))},
                     {"p", t.p},
                     {"q", t.q},
                     {"t", t.t},
                     {"enter", t.enter},
                     {"leave", t.leave}};
      const bool parallel = t.crossing == Crossing::inside || t.crossing == Crossing::outside;
      step.sentence =
          parallel ? words_.say(fmt::format("liang_barsky.crossing.{}", name_of(t.crossing)),
                                arg("border", name(t.border)), arg("q", figure_real(t.q)))
                   : words_.say(fmt::format("liang_barsky.crossing.{}", name_of(t.crossing)),
                                arg("border", name(t.border)), arg("p", figure_real(t.p)),
                                arg("q", window_view::factor(t.q)), arg("pq", window_view::factor(t.p)),
                                arg("t", figure_real(t.t)),
                                arg("value", figure_real(t.crossing == Crossing::enters ? enter_ : leave_)));
      step.row = row(name(t.border), figure_real(t.p), figure_real(t.q), parallel ? "" : figure_real(t.t),
                     words_.say(fmt::format("liang_barsky.kind.{}", name_of(t.crossing))));
    });
  }

  void operator()(const Ordered<double>& o, int source_line = __builtin_LINE(), const char* = nullptr) {
    values_.push_back({o.border, o.crossing, value_of(o.border, o.crossing)});
    enter_ = o.span.enter ? value_of(*o.span.enter, Crossing::enters) : 0;
    leave_ = o.span.leave ? value_of(*o.span.leave, Crossing::leaves) : 1;
    const auto named = [&](const std::optional<Border>& border, std::string_view end) {
      return border ? name(*border) : std::string(end);
    };
    show(drawing(), source_line, [&](TraceStep& step) {
      step.type = "Ordered";
      step.phase = words_.say("words.main_loop");
      step.key = std::string(name_of(o.border));
      step.fields = {{"border", std::string(name_of(o.border))}, {"beyond", o.beyond}};
      const std::string key =
          o.beyond && o.crossing != Crossing::outside ? "missed" : std::string(name_of(o.crossing));
      step.sentence =
          words_.say("liang_barsky.ordered." + key, arg("border", name(o.border)),
                     arg("first", named(o.span.enter, "a")), arg("last", named(o.span.leave, "b")));
      const bool parallel = o.crossing == Crossing::inside || o.crossing == Crossing::outside;
      step.row = {name(o.border), words_.say(fmt::format("liang_barsky.kind.{}", name_of(o.crossing))),
                  parallel ? "" : "≈ " + figure_real(values_.back().t), named(o.span.enter, "a"),
                  named(o.span.leave, "b")};
    });
  }

  void operator()(const Accepted<double>& a, int source_line = __builtin_LINE(), const char* = nullptr) {
    kept(a.line, "Accepted", source_line);
  }
  void operator()(const Kept<double>& k, int source_line = __builtin_LINE(), const char* = nullptr) {
    kept(k.line, "Kept", source_line);
  }
  void operator()(const Rejected<double>&, int source_line = __builtin_LINE(), const char* = nullptr) {
    missed("Rejected", source_line);
  }
  void operator()(const Missed&, int source_line = __builtin_LINE(), const char* = nullptr) {
    missed("Missed", source_line);
  }

 private:
  static std::string_view name_of(Border border) {
    constexpr std::string_view names[] = {"left", "right", "bottom", "top"};
    return names[static_cast<int>(border)];
  }
  static std::string_view name_of(Crossing crossing) {
    constexpr std::string_view names[] = {"inside", "outside", "enters", "leaves"};
    return names[static_cast<int>(crossing)];
  }
  std::string name(Border border) const {
    return words_.say(fmt::format("liang_barsky.border.{}", name_of(border)));
  }

  /// Where the line crosses a border, for the drawing.
  static double value_at(const Task& task, Border border) {
    const int axis = axis_of(border);
    const double d = task.line.b[axis] * 0.5 - task.line.a[axis] * 0.5;
    const double way = coordinate(task.window, border) * 0.5 - task.line.a[axis] * 0.5;
    return d == 0 ? 0 : way / d;
  }
  double value_of(Border border, Crossing crossing) const {
    return crossing == Crossing::enters || crossing == Crossing::leaves ? value_at(task_, border) : 0;
  }
  static double least(const Task& task) {
    double value = -0.05;
    for (const Border border : usual_order<2>()) value = std::min(value, value_at(task, border) - 0.05);
    return std::max(value, -1.0);
  }
  static double most(const Task& task) {
    double value = 1.05;
    for (const Border border : usual_order<2>()) value = std::max(value, value_at(task, border) + 0.05);
    return std::min(value, 2.0);
  }

  Row row(std::string border, std::string p, std::string q, std::string t, std::string kind) const {
    return {std::move(border), std::move(p),        std::move(q),       std::move(t),
            std::move(kind),   figure_real(enter_), figure_real(leave_)};
  }

  dvec2 point(double t) const { return task_.line.a * (1 - t) + task_.line.b * t; }

  /// The whole drawing: the window and the line above, its values of t below.
  View drawing(Role left_over = Role::current) const {
    View view;
    scene_.add_window(view, words_);
    scale_.add_to(view, "t", words_.symbol("t"));
    const bool empty = left_over == Role::rejected || enter_ > leave_ ||
                       (!values_.empty() && values_.back().crossing == Crossing::outside);
    if (empty) {
      scene_.add_line(view, "line", left_over == Role::rejected ? Role::rejected : Role::input, task_.line,
                      true);
    } else {
      scene_.add_line(view, "line before", Role::input, {task_.line.a, point(enter_)}, true);
      scene_.add_line(view, "left over", left_over, {point(enter_), point(leave_)});
      scene_.add_line(view, "line after", Role::input, {point(leave_), task_.line.b}, true);
    }
    scene_.add_point(view, "end a", Role::input, task_.line.a, task_.line.b, "a");
    scene_.add_point(view, "end b", Role::input, task_.line.b, task_.line.a, "b");

    // Below: what is allowed by now, entering values above the scale, leaving ones too
    const double low = least(task_), high = most(task_);
    const auto clamped = [&](double t) { return scale_.at(std::clamp(t, low, high)); };
    if (!empty) {
      const dvec2 up{0, 0.45};
      view.add({"allowed", left_over == Role::current ? Role::current : left_over,
                Stroke{clamped(enter_) + up, clamped(leave_) + up}});
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto& [border, crossing, t] = values_[i];
      if (crossing != Crossing::enters && crossing != Crossing::leaves) continue;
      const bool last = i + 1 == values_.size() && left_over == Role::current;
      const bool enters = crossing == Crossing::enters;
      const Role role = last ? Role::current : enters ? Role::candidate : Role::past;
      const std::string id = fmt::format("value {}", name_of(border));
      view.add({id + " dot", role, Dot{clamped(t), !enters}});
      if (low <= t && t <= high) {
        scene_.add_point(view, id, role, point(t), point(t), name(border), !enters);
        // Two rows above the scale, entering below leaving, so that names don't meet
        view.add({id + " text", role,
                  Text{clamped(t) + dvec2{0, enters ? 1.7 : 3.8},
                       words_.say(enters ? "liang_barsky.mark.enters" : "liang_barsky.mark.leaves",
                                  arg("border", name(border)))}});
        view.add({id + " stem", Role::guide, Stroke{clamped(t), clamped(t) + dvec2{0, enters ? 1.0 : 3.1}}});
      }
    }
    return view;
  }

  void kept(const Segment<2, double>& line, std::string type, int source_line) {
    const auto right = correctly_rounded(task_.line, task_.window);
    const window_view::Off off = right ? window_view::off_by(line, *right) : window_view::Off{};
    show(drawing(Role::result), source_line, [&](TraceStep& step) {
      step.type = std::move(type);
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"x0", line.a.x}, {"y0", line.a.y}, {"x1", line.b.x}, {"y1", line.b.y}};
      if (off.doubles > 0) {
        step.sentence = window_view::moved_by_rounding(words_, "liang_barsky.accepted_off",
                                                       "liang_barsky.accepted_far", line, off);
      } else {
        step.sentence = words_.say("liang_barsky.accepted", arg("from", figure_place(line.a)),
                                   arg("to", figure_place(line.b)));
      }
    });
    writer_.trace().result = {{"accepted", true}, {"off_by", off.doubles}};
  }
  void missed(std::string type, int source_line) {
    show(drawing(Role::rejected), source_line, [&](TraceStep& step) {
      step.type = std::move(type);
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = words_.say("liang_barsky.rejected");
    });
    writer_.trace().result = {{"accepted", false}};
  }

  template <class Describe>
  void show(View view, int line, Describe describe) {
    writer_.step(shown_.change_to(std::move(view)), {}, line, describe);
  }

  TraceWriter& writer_;
  const Wording& words_;
  Task task_;
  window_view::Scene scene_;
  NumberLine scale_;
  double enter_ = 0, leave_ = 1;
  std::vector<Value> values_;
  Shown shown_;
};

/// A segment in space and a box.
struct BoxTask {
  Segment<3, double> line;
  AxisBox<3, double> box;
};

/// The same in a box: the space above, the values of t below.
class BoxTeller {
 public:
  BoxTeller(TraceWriter& writer, const BoxTask& task)
      : writer_(writer), words_(writer.wording()), task_(task), space_(place(), shown(task)) {}

  void operator()(const BoxStarted<double>& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    show(source_line, [&](TraceStep& step) {
      step.type = "BoxStarted";
      step.phase = words_.say("words.set_up");
      step.key = "start";
      step.fields = {{"dx", s.d.x}, {"dy", s.d.y}, {"dz", s.d.z}};
      step.sentence =
          words_.say("liang_barsky.started", arg("a", figure_place(s.line.a)), arg("d", figure_place(s.d)));
      step.row = {"", "", "", "", "", figure_real(enter_), figure_real(leave_)};
    });
  }

  void operator()(const Tested<double>& t, int source_line = __builtin_LINE(), const char* = nullptr) {
    enter_ = t.enter;
    leave_ = t.leave;
    values_.push_back({t.border, t.crossing, t.t});
    const std::string kind(kind_of(t.crossing)), face(name_of(t.border));
    const bool parallel = t.crossing == Crossing::inside || t.crossing == Crossing::outside;
    show(source_line, [&](TraceStep& step) {
      step.type = "Tested";
      step.phase = words_.say("words.main_loop");
      step.key = face;
      step.fields = {{"border", face}, {"p", t.p},         {"q", t.q},
                     {"t", t.t},       {"enter", t.enter}, {"leave", t.leave}};
      step.sentence =
          parallel ? words_.say(fmt::format("liang_barsky.crossing.{}", kind), arg("border", name(t.border)),
                                arg("q", figure_real(t.q)))
                   : words_.say(fmt::format("liang_barsky.crossing.{}", kind), arg("border", name(t.border)),
                                arg("p", figure_real(t.p)), arg("q", window_view::factor(t.q)),
                                arg("pq", window_view::factor(t.p)), arg("t", figure_real(t.t)),
                                arg("value", figure_real(t.crossing == Crossing::enters ? enter_ : leave_)));
      step.row = {name(t.border),
                  figure_real(t.p),
                  figure_real(t.q),
                  parallel ? "" : figure_real(t.t),
                  words_.say("liang_barsky.kind." + kind),
                  figure_real(enter_),
                  figure_real(leave_)};
    });
  }

  void operator()(const BoxAccepted<double>& a, int source_line = __builtin_LINE(), const char* = nullptr) {
    left_over_ = Role::result;
    show(source_line, [&](TraceStep& step) {
      step.type = "BoxAccepted";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = words_.say("liang_barsky.accepted_box", arg("from", figure_place(a.line.a)),
                                 arg("to", figure_place(a.line.b)));
    });
    writer_.trace().result = {{"accepted", true}};
  }

  void operator()(const Rejected<double>&, int source_line = __builtin_LINE(), const char* = nullptr) {
    left_over_ = Role::rejected;
    show(source_line, [&](TraceStep& step) {
      step.type = "Rejected";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = words_.say("liang_barsky.rejected_box");
    });
    writer_.trace().result = {{"accepted", false}};
  }

 private:
  static Extent place() { return {{3, 9}, {33, 26}}; }
  static std::vector<dvec3> shown(const BoxTask& task) {
    std::vector<dvec3> points{task.line.a, task.line.b};
    for (int corner = 0; corner < 8; ++corner) points.push_back(box_corner(task.box, corner));
    return points;
  }
  static std::string_view name_of(Border face) {
    constexpr std::string_view names[] = {"left", "right", "bottom", "top", "near", "far"};
    return names[static_cast<int>(face)];
  }
  static std::string_view kind_of(Crossing crossing) {
    constexpr std::string_view names[] = {"inside", "outside", "enters", "leaves"};
    return names[static_cast<int>(crossing)];
  }
  std::string name(Border face) const {
    return words_.say("liang_barsky.border." + std::string(name_of(face)));
  }
  dvec2 point(double t) const { return space_.at(task_.line.a * (1 - t) + task_.line.b * t); }

  /// The whole drawing.
  View drawing() const {
    View view;
    add_box(view, space_, task_.box);
    add_directions(view, {1.2, 22.4}, {words_.symbol("x"), words_.symbol("y"), words_.symbol("z")});
    const NumberLine scale({3.5, 2.3}, {32.5, 2.3}, least, most);
    scale.add_to(view, "t", words_.symbol("t"));
    const bool empty = left_over_ == Role::rejected || enter_ > leave_;
    if (empty) {
      view.add({"line", left_over_ == Role::rejected ? Role::rejected : Role::input,
                Stroke{point(0), point(1), false, true}});
    } else {
      view.add({"line before", Role::input, Stroke{point(0), point(enter_), false, true}});
      view.add({"left over", left_over_, Stroke{point(enter_), point(leave_)}});
      view.add({"line after", Role::input, Stroke{point(leave_), point(1), false, true}});
      const dvec2 up{0, 0.45};
      view.add({"allowed", left_over_, Stroke{scale.at(enter_) + up, scale.at(leave_) + up}});
    }
    view.add({"end a", Role::input, Dot{point(0)}});
    view.add({"end b", Role::input, Dot{point(1)}});
    view.add({"end a name", Role::input, Label{point(0), "a"}});
    view.add({"end b name", Role::input, Label{point(1), "b"}});
    for (std::size_t i = 0; i < values_.size(); ++i)
      add_value(view, scale, values_[i], i + 1 == values_.size());
    if (!values_.empty() && left_over_ == Role::current) {
      std::vector<dvec2> outline;
      for (const dvec3 p : box_face(task_.box, values_.back().border)) outline.push_back(space_.at(p));
      view.add({"face area", Role::current, Area{{outline}}});
      view.add({"face outline", Role::current, Path{outline, true}});
    }
    return view;
  }

  /// One value of t: a dot on the scale, and on the line where it lies between its ends or near them.
  void add_value(View& view, const NumberLine& scale, const Value& value, bool last) const {
    const auto& [face, crossing, t] = value;
    if (crossing != Crossing::enters && crossing != Crossing::leaves) return;
    const bool enters = crossing == Crossing::enters;
    const Role role = last && left_over_ == Role::current ? Role::current
                      : enters                            ? Role::candidate
                                                          : Role::past;
    const std::string id = fmt::format("value {}", name_of(face));
    const dvec2 at = scale.at(std::clamp(t, least, most));
    view.add({id + " dot", role, Dot{at, !enters}});
    if (t < least || most < t) return;
    view.add({id + " text", role,
              Label{at, words_.say(enters ? "liang_barsky.mark.enters" : "liang_barsky.mark.leaves",
                                   arg("border", name(face)))}});
    if (t < 0 || 1 < t) return;
    view.add({id, role, Dot{point(t), !enters}});
    view.add({id + " name", role, Label{point(t), name(face)}});
  }

  template <class Describe>
  void show(int line, Describe describe) {
    View view = drawing();
    writer_.step(shown_.change_to(std::move(view)), {}, line, describe);
  }

  static constexpr double least = -0.5, most = 1.5;

  TraceWriter& writer_;
  const Wording& words_;
  BoxTask task_;
  SpaceView space_;
  double enter_ = 0, leave_ = 1;
  Role left_over_ = Role::current;
  std::vector<Value> values_;
  Shown shown_;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("liang_barsky", std::move(name), standing);
  };
  static const std::vector<Method> methods{method("parametric", Standing::taught),
                                           method("correctly_rounded", Standing::fast),
                                           method("box_parametric", Standing::plain)};
  return methods;
}

BoxTask space_of(const Arguments& arguments) {
  const auto line = arguments.numbers("space_line"), box = arguments.numbers("box");
  return {{{line[0], line[1], line[2]}, {line[3], line[4], line[5]}},
          {{box[0], box[1], box[2]}, {box[3], box[4], box[5]}}};
}

/// What the steps of the parametric methods hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Started<T>& s) const {
    to.type = "Started";
    to.point("d", s.d);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const BoxStarted<T>& s) const {
    to.type = "BoxStarted";
    to.point("d", s.d);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Tested<T>& t) const {
    to.type = "Tested";
    to.number("t", t.t);
    to.number("enter", t.enter);
    to.number("leave", t.leave);
    to.decision(t.crossing);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Accepted<T>& a) const {
    to.type = "Accepted";
    to.point("a", a.line.a);
    to.point("b", a.line.b);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const BoxAccepted<T>& a) const {
    to.type = "BoxAccepted";
    to.point("a", a.line.a);
    to.point("b", a.line.b);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rejected<T>&) const {
    to.type = "Rejected";
  }
};

void put_side_by_side(Trace& trace, const Task& task, const BoxTask& space, bool in_space) {
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    if (in_space) {
      box_parametric(in_scalar<T>(space.line), in_scalar<T>(space.box), usual_order<3>(), observer);
    } else {
      parametric(in_scalar<T>(task.line), in_scalar<T>(task.window), task.order, observer);
    }
  });
}

/// What the method can't be watched with is refused before it runs.
void require_watchable(const Arguments& arguments) {
  const std::string& method = arguments.text("method");
  if (method == "box_parametric") return;
  if (method == "parametric") {
    for (const auto* name : {"line", "window"}) require_sizes(arguments, name, window_view::rounded_sizes);
  }
  window_view::require_scale(arguments, window_view::line_in(arguments), window_view::window_in(arguments));
}

Trace run(const Arguments& arguments, Recording recording) {
  require_watchable(arguments);
  const Task task{window_view::line_in(arguments), window_view::window_in(arguments),
                  window_view::order_in(arguments)};
  const std::string& method = arguments.text("method");
  const bool in_space = method == "box_parametric";
  const BoxTask space = space_of(arguments);
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = writer.wording();
  introduce(trace, "liang_barsky", arguments, false);
  trace.subtitle = words.say("liang_barsky.subtitle",
                             arg("from", in_space ? figure_place(space.line.a) : figure_place(task.line.a)),
                             arg("to", in_space ? figure_place(space.line.b) : figure_place(task.line.b)));
  // Only what the method reads
  std::erase_if(trace.arguments, [&](const Argument& a) {
    const bool of_space = a.name == "space_line" || a.name == "box";
    return a.name != "method" && a.name != "exact" && of_space != in_space;
  });
  trace.source_file = std::string(folder) + (in_space ? "liang_barsky_box.hpp" : "liang_barsky.hpp");
  trace.listing = listing_of(source_text(trace.source_file), method);
  trace.grid = paper_grid(window_view::paper_width, window_view::paper_height);
  trace.columns =
      method != "correctly_rounded"
          ? std::vector<Column>{{"border", false}, {"p"}, {"q"}, {"t"}, {"kind", false}, {"enter"}, {"leave"}}
          : std::vector<Column>{{"border", false}, {"kind", false}, {"t"}, {"first", false}, {"last", false}};
  trace.legend = {{Role::input, words.say("liang_barsky.legend.input")},
                  {Role::boundary, words.say("liang_barsky.legend.boundary")},
                  {Role::current, words.say("liang_barsky.legend.current")},
                  {Role::candidate, words.say("liang_barsky.legend.candidate")},
                  {Role::past, words.say("liang_barsky.legend.past")},
                  {Role::rejected, words.say("liang_barsky.legend.rejected")},
                  {Role::result, words.say("liang_barsky.legend.result")}};
  Teller teller(writer, task);
  if (in_space) {
    BoxTeller box_teller(writer, space);
    box_parametric(space.line, space.box, usual_order<3>(), box_teller);
  } else if (method == "parametric") {
    parametric(task.line, task.window, task.order, teller);
  } else {
    correctly_rounded(task.line, task.window, task.order, teller);
  }
  Trace told = std::move(writer).finish();
  told.telling = told.whole() ? StepNumber{told.last, 0} : middle_step(told);
  if (side_by_side(arguments)) {
    require_method(arguments, {"parametric", "box_parametric"});
    put_side_by_side(told, task, space, in_space);
  }
  return told;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "liang_barsky",
      .title = Wording().say("liang_barsky.title"),
      .chapter = "clipping",
      .aliases = {"liang barsky", "parametric line clipping"},
      .summary = "the part of a segment that lies in a window, by the values of t that its borders allow",
      .methods = all_methods(),
      .default_method = "parametric",
      .parameters = {window_view::line_parameter("-4,3,6,15"),
                     window_view::window_parameter(),
                     window_view::order_parameter(),
                     {.name = "space_line",
                      .type = ParameterType::numbers,
                      .default_value = "-2,1,2,12,11,9",
                      .example = "-2,1,2,12,11,9",
                      .help = "method box_parametric: the segment's ends x0,y0,z0,x1,y1,z1",
                      .parts = {"x0", "y0", "z0", "x1", "y1", "z1"},
                      .sizes = window_view::rounded_sizes},
                     {.name = "box",
                      .type = ParameterType::bounds,
                      .default_value = "0,0,0,10,8,6",
                      .example = "0,0,0,10,8,6",
                      .help =
                          "method box_parametric: the box xmin,ymin,zmin,xmax,ymax,zmax, its faces included",
                      .parts = {"xmin", "ymin", "zmin", "xmax", "ymax", "zmax"},
                      .sizes = window_view::rounded_sizes},
                     exact_parameter()},
      .examples = {"--line -4,3,6,15", "--window 0,0,10,10 --line -5,8,3,20", "--line -3,-8,13,16"},
      .run = run};
  return topic;
}

}  // namespace gradus::liang_barsky
