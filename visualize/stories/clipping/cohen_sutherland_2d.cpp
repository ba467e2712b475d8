// The story of a segment and the codes of its ends.

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_notes.hpp"
#include "stories/clipping/window_view.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::cohen_sutherland_2d {
namespace {

using fmt::arg;

constexpr std::string_view folder = "algorithms/clipping/cohen_sutherland_2d/";

struct Task {
  Segment<2, double> line;
  Rectangle<double> window;
  Order order;
  std::string bits;  ///< which border each digit stands for, the first to the left
  std::optional<Segment<2, double>> right;
  bool faulty = false;
  bool whole = false;       ///< whether any bit drops the whole segment
  bool right_line = false;  ///< whether cuts are computed from the original line
};

Task task_of(const Arguments& arguments) {
  if (arguments.text("method") != "correctly_rounded") {
    for (const auto* name : {"line", "window"}) require_sizes(arguments, name, window_view::rounded_sizes);
  }
  Task task{window_view::line_in(arguments),
            window_view::window_in(arguments),
            window_view::order_in(arguments),
            arguments.text("code_bits"),
            {}};
  task.right = correctly_rounded(task.line, task.window);
  window_view::require_scale(arguments, task.line, task.window);
  return task;
}

constexpr std::string_view letters = "LRBT";

Border border_of(char letter) { return static_cast<Border>(letters.find(letter)); }

/// The digits of a code in the order asked for: "1001".
std::string digits(const Task& task, Code code) {
  std::string text;
  for (const char letter : task.bits) text += code & bit(border_of(letter)) ? '1' : '0';
  return text;
}

class Teller {
 public:
  Teller(TraceWriter& writer, const Task& task)
      : writer_(writer),
        words_(writer.wording()),
        task_(task),
        scene_(task.line, task.window, {{3.2, 5}, {35, 26}}),
        now_(task.line) {
    writer.trace().columns = {{"cut"}, {"end", false},    {"border", false}, {"x"},
                              {"y"},   {"code_a", false}, {"code_b", false}};
  }

  void operator()(const Classified<double>& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    codes_ = {c.code_a, c.code_b};
    show(drawing(Role::current), source_line, [&](TraceStep& step) {
      step.type = "Classified";
      step.phase = words_.say("words.set_up");
      step.key = "codes";
      step.fields = {{"code_a", std::int64_t{c.code_a}}, {"code_b", std::int64_t{c.code_b}}};
      step.sentence = words_.say("cohen_sutherland_2d.classified", arg("a", figure_place(c.line.a)),
                                 arg("b", figure_place(c.line.b)), arg("code_a", code(0)),
                                 arg("code_b", code(1)), arg("verdict", verdict()));
      step.row = {"", "", "", "", "", code(0), code(1)};
    });
  }

  void operator()(const Cut<double>& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    cuts_.push_back({c.from, c.to()});
    const Segment<2, double> before = task_.right_line ? task_.line : now_;
    now_ = c.line;
    codes_ = {c.code_a, c.code_b};
    show(drawing(Role::current), source_line, [&](TraceStep& step) {
      step.type = "Cut";
      step.phase = words_.say("words.main_loop");
      step.key = fmt::format("cut {}", cuts_.size());
      step.fields = {
          {"of_a", c.of_a}, {"border", std::string(name_of(c.border))}, {"x", c.to().x},
          {"y", c.to().y},  {"code_a", std::int64_t{c.code_a}},         {"code_b", std::int64_t{c.code_b}}};
      step.sentence = words_.say(
          "cohen_sutherland_2d.cut", arg("end", end(c.of_a)), arg("border", beyond(c.border)),
          arg("code", digits(task_, c.before)), arg("axis", axis(c.border)),
          arg("at", figure_real(coordinate(task_.window, c.border))), arg("other", other_axis(c.border)),
          arg("formula", formula(before, c.border)), arg("value", figure_real(c.to()[1 - axis_of(c.border)])),
          arg("after", digits(task_, c.after())));
      step.row = {figure_number(static_cast<std::int64_t>(cuts_.size())),
                  end(c.of_a),
                  name(c.border),
                  figure_real(c.to().x),
                  figure_real(c.to().y),
                  code(0),
                  code(1)};
    });
  }

  void operator()(const Accepted<double>& a, int source_line = __builtin_LINE(), const char* = nullptr) {
    const window_view::Off off = task_.right ? window_view::off_by(a.line, *task_.right) : window_view::Off{};
    View view = drawing(Role::result);
    const bool wrong = task_.faulty && task_.right && !(a.line == *task_.right);
    if (wrong) add_right(view);
    show(std::move(view), source_line, [&](TraceStep& step) {
      step.type = "Accepted";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"x0", a.line.a.x}, {"y0", a.line.a.y}, {"x1", a.line.b.x}, {"y1", a.line.b.y}};
      const bool unclipped = wrong || !task_.right;
      if (!unclipped && off.doubles > 0) {
        step.sentence = window_view::moved_by_rounding(words_, "cohen_sutherland_2d.accepted_off",
                                                       "cohen_sutherland_2d.accepted_far", a.line, off);
      } else {
        const char* key = unclipped ? "cohen_sutherland_2d.unclipped" : "cohen_sutherland_2d.accepted";
        step.sentence =
            words_.say(key, arg("from", figure_place(a.line.a)), arg("to", figure_place(a.line.b)));
      }
    });
    writer_.trace().result = {
        {"accepted", true}, {"cuts", static_cast<std::int64_t>(cuts_.size())}, {"off_by", off.doubles}};
  }

  void operator()(const Rejected& r, int source_line = __builtin_LINE(), const char* = nullptr) {
    View view = drawing(Role::rejected);
    if (task_.whole && task_.right) add_right(view);
    show(std::move(view), source_line, [&](TraceStep& step) {
      step.type = "Rejected";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"common", std::int64_t{r.common}}};
      const char* key = task_.whole ? "cohen_sutherland_2d.dropped" : "cohen_sutherland_2d.rejected";
      step.sentence = r.common ? words_.say(key, arg("code_a", code(0)), arg("code_b", code(1)),
                                            arg("border", beyond(first_of(task_.order, r.common))))
                               : words_.say("cohen_sutherland_2d.unsettled");
    });
    writer_.trace().result = {{"accepted", false}, {"cuts", static_cast<std::int64_t>(cuts_.size())}};
  }

  void operator()(const Recoded<double>& r, int source_line = __builtin_LINE(), const char* = nullptr) {
    codes_ = {r.code_a, r.code_b};
    ++rounds_;
    View view = drawing(Role::current);
    scene_.add_point(view, "computed", Role::candidate, r.at, r.at,
                     words_.say("cohen_sutherland_2d.computed"), true);
    show(std::move(view), source_line, [&](TraceStep& step) {
      step.type = "Recoded";
      step.phase = words_.say("words.main_loop");
      step.key = fmt::format("round {}", rounds_);
      step.fields = {{"of_a", r.of_a}, {"border", std::string(name_of(r.border))}};
      step.sentence = words_.say("cohen_sutherland_2d.recoded", arg("border", name(r.border)),
                                 arg("point", figure_place(r.at)), arg("code", code(r.of_a ? 0 : 1)),
                                 arg("end", end(r.of_a)));
      step.row = {figure_number(rounds_), end(r.of_a), name(r.border), figure_real(r.at.x),
                  figure_real(r.at.y),    code(0),     code(1)};
    });
  }

  void operator()(const GaveUp& g, int source_line = __builtin_LINE(), const char* = nullptr) {
    View view = drawing(Role::rejected);
    if (task_.right) add_right(view);
    show(std::move(view), source_line, [&](TraceStep& step) {
      step.type = "GaveUp";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"rounds", std::int64_t{g.rounds}}};
      step.sentence = words_.say("cohen_sutherland_2d.gave_up", arg("rounds", g.rounds));
    });
    writer_.trace().result = {{"accepted", false}, {"rounds", std::int64_t{g.rounds}}};
  }

 private:
  static std::string_view name_of(Border border) {
    constexpr std::string_view names[] = {"left", "right", "bottom", "top"};
    return names[static_cast<int>(border)];
  }
  std::string name(Border border) const {
    return words_.say(fmt::format("cohen_sutherland_2d.border.{}", name_of(border)));
  }
  std::string beyond(Border border) const {
    return words_.say(fmt::format("cohen_sutherland_2d.beyond.{}", name_of(border)));
  }
  static std::string end(bool of_a) { return of_a ? "a" : "b"; }
  std::string axis(Border border) const { return words_.symbol(axis_of(border) == 0 ? "x" : "y"); }
  std::string other_axis(Border border) const { return words_.symbol(axis_of(border) == 0 ? "y" : "x"); }
  std::string code(std::size_t which) const { return digits(task_, codes_[which]); }
  std::string verdict() const {
    const std::string key = (codes_[0] | codes_[1]) == 0   ? "inside"
                            : task_.whole                  ? "dropped"
                            : (codes_[0] & codes_[1]) != 0 ? "beyond"
                                                           : "undecided";
    return words_.say("cohen_sutherland_2d.verdict." + key);
  }
  /// The cut with its numbers put in: "8 + 12·5/8".
  std::string formula(const Segment<2, double>& line, Border border) const {
    const int i = axis_of(border), j = 1 - i;
    return fmt::format("{} + {}·{}/{}", figure_real(line.a[j]), window_view::factor(line.b[j] - line.a[j]),
                       window_view::factor(coordinate(task_.window, border) - line.a[i]),
                       window_view::factor(line.b[i] - line.a[i]));
  }

  void add_right(View& view) const { scene_.add_line(view, "right", Role::accepted, *task_.right); }

  /// The whole drawing: regions with their codes, what was cut off, what is left.
  View drawing(Role left_over) const {
    View view;
    scene_.add_window(view, words_);
    const auto [lower, upper] = scene_.shown();
    const auto [from, to] = task_.window;
    // In the upper left corner of each region
    const double xs[] = {lower.x, from.x, to.x}, ys[] = {from.y, to.y, upper.y};
    const Code across[] = {bit(Border::left), 0, bit(Border::right)};
    const Code up[] = {bit(Border::bottom), 0, bit(Border::top)};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Code region = static_cast<Code>(across[i] | up[k]);
        view.add(
            {fmt::format("region {:02}", region), Role::guide,
             Text{scene_.panel().at({xs[i], ys[k]}) + dvec2{0.4, -0.9}, digits(task_, region), Align::left}});
      }
    }
    // Which digit is which
    std::string bits;
    for (const char letter : task_.bits) bits += (bits.empty() ? "" : " · ") + name(border_of(letter));
    view.add(
        {"bits", Role::guide, Text{{18, 1.2}, words_.say("cohen_sutherland_2d.bits", arg("bits", bits))}});

    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const bool last = i + 1 == cuts_.size() && left_over == Role::current;
      scene_.add_line(view, fmt::format("cut off {}", i + 1), last ? Role::rejected : Role::past,
                      {cuts_[i].a, cuts_[i].b}, true);
      scene_.add_point(view, fmt::format("cut {}", i + 1), last ? Role::current : Role::past, cuts_[i].b,
                       cuts_[i].b, figure_number(static_cast<std::int64_t>(i + 1)));
    }
    scene_.add_line(view, "left over", left_over, now_, left_over == Role::rejected);
    const Segment<2, double>& line = task_.line;
    scene_.add_point(view, "end a", Role::input, line.a, line.b, named("a", line.a, now_.a, 0));
    scene_.add_point(view, "end b", Role::input, line.b, line.a, named("b", line.b, now_.b, 1));
    return view;
  }
  /// An end's name, with its code while it has not moved.
  std::string named(std::string_view symbol, dvec2 was, dvec2 is, std::size_t which) const {
    const std::string name(symbol);
    return was == is ? name + " " + code(which) : name;
  }

  template <class Describe>
  void show(View view, int line, Describe describe) {
    writer_.step(shown_.change_to(std::move(view)), {}, line, describe);
  }

  TraceWriter& writer_;
  const Wording& words_;
  Task task_;
  window_view::Scene scene_;
  Segment<2, double> now_;
  std::array<Code, 2> codes_{};
  std::vector<Segment<2, double>> cuts_;
  std::int64_t rounds_ = 0;
  Shown shown_;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("cohen_sutherland_2d", std::move(name), standing);
  };
  static const std::vector<Method> methods{
      method("cut_of_a_cut", Standing::taught), method("correctly_rounded", Standing::fast),
      method("codes_only", Standing::faulty), method("whole_or_nothing", Standing::faulty)};
  return methods;
}

/// What the steps of the taught method hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Classified<T>& c) const {
    to.type = "Classified";
    to.point("a", c.line.a);
    to.point("b", c.line.b);
    to.decision(c.code_a);
    to.decision(c.code_b);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Cut<T>& c) const {
    to.type = "Cut";
    to.point(c.of_a ? "a" : "b", c.to());
    to.decision(c.border);
    to.decision(c.after());
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Accepted<T>&) const {
    to.type = "Accepted";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rejected&) const {
    to.type = "Rejected";
  }
};

Trace run(const Arguments& arguments, Recording recording) {
  Task task = task_of(arguments);
  const std::string& method = arguments.text("method");
  task.whole = method == "whole_or_nothing";
  task.faulty = task.whole || method == "codes_only";
  task.right_line = method == "correctly_rounded";
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = writer.wording();
  introduce(trace, "cohen_sutherland_2d", arguments, task.faulty);
  trace.subtitle = words.say("cohen_sutherland_2d.subtitle", arg("from", figure_place(task.line.a)),
                             arg("to", figure_place(task.line.b)));
  trace.source_file =
      std::string(folder) + (task.faulty ? "cohen_sutherland_2d_notes.hpp" : "cohen_sutherland_2d.hpp");
  trace.listing = listing_of(source_text(trace.source_file), method);
  trace.grid = paper_grid(window_view::paper_width, window_view::paper_height);
  trace.legend = {{Role::input, words.say("cohen_sutherland_2d.legend.input")},
                  {Role::boundary, words.say("cohen_sutherland_2d.legend.boundary")},
                  {Role::current, words.say("cohen_sutherland_2d.legend.current")},
                  {Role::past, words.say("cohen_sutherland_2d.legend.past")},
                  {Role::rejected, words.say("cohen_sutherland_2d.legend.rejected")},
                  {Role::result, words.say("cohen_sutherland_2d.legend.result")}};
  if (task.faulty) {
    trace.legend.push_back({Role::accepted, words.say("cohen_sutherland_2d.legend.right")});
    trace.legend.push_back({Role::candidate, words.say("cohen_sutherland_2d.legend.candidate")});
  }
  Teller teller(writer, task);
  if (method == "cut_of_a_cut") cut_of_a_cut(task.line, task.window, task.order, teller);
  if (method == "correctly_rounded") correctly_rounded(task.line, task.window, task.order, teller);
  if (method == "codes_only") codes_only(task.line, task.window, task.order, 8, teller);
  if (method == "whole_or_nothing") whole_or_nothing(task.line, task.window, teller);
  Trace told = std::move(writer).finish();
  told.telling = told.whole() ? StepNumber{told.last, 0} : middle_step(told);
  if (side_by_side(arguments)) {
    require_method(arguments, {"cut_of_a_cut"});
    show_side_by_side<Numbers>(told, [&]<class T>(T, const auto& observer) {
      cut_of_a_cut(in_scalar<T>(task.line), in_scalar<T>(task.window), task.order, observer);
    });
  }
  return told;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "cohen_sutherland_2d",
      .title = Wording().say("cohen_sutherland_2d.title"),
      .chapter = "clipping",
      .aliases = {"cohen sutherland", "line clipping", "region codes", "outcodes"},
      .summary = "the part of a segment that lies in a window, by region codes",
      .methods = all_methods(),
      .default_method = "cut_of_a_cut",
      .parameters = {window_view::line_parameter("-3,-8,13,16"),
                     window_view::window_parameter(),
                     window_view::order_parameter(),
                     {.name = "code_bits",
                      .type = ParameterType::choice,
                      .default_value = "TBRL",
                      .example = "LRBT",
                      .help =
                          "which border each digit of a code stands for: T top, B bottom, R right, L left",
                      .choices = {"TBRL", "LRBT"}},
                     exact_parameter()},
      .examples = {"--line -3,-8,13,16", "--window 0,0,10,10 --line -5,8,3,20",
                   "--line 5,5,-5,5 --method codes_only"},
      .run = run};
  return topic;
}

}  // namespace gradus::cohen_sutherland_2d
