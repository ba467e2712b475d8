// The story of a segment in a circle: the foot of the perpendicular, half the chord, and what t they are.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <cmath>

#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "stories/clipping/circle_drawing.hpp"
#include "stories/paper.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::liang_barsky_circle {
namespace {

using fmt::arg;
using Ends = Segment<2, double>;
using Disc = Circle<double>;

constexpr std::string_view folder = "algorithms/clipping/liang_barsky_circle/";
constexpr int width = 36, height = 27;

/// What all steps are drawn from.
struct Scene {
  Ends segment;
  Disc circle;
  bool has_line;              ///< the method knows values of t
  Panel panel;                ///< the plane
  NumberLine line;            ///< t
  double least, most;         ///< of the number line
  std::optional<Ends> right;  ///< what is really kept
};

/// The plane: the circle, and the segment where that is not much larger.
Extent world_of(const Ends& s, const Disc& c) {
  Extent around;
  around.add(c.centre - c.radius);
  around.add(c.centre + c.radius);
  Extent all = around;
  all.add(s.a);
  all.add(s.b);
  const bool fits = c.radius == 0 || std::max(all.size().x, all.size().y) <= 12 * c.radius;
  return widened(fits ? all : widened(around, 0.5), 0.12);
}

/// The values of t to show, moderate ones.
Extent scale_of(const Ends& s, const Disc& c) {
  const Quadratic<double> q = quadratic(s, c);
  Extent t;
  t.add({0, 0});
  t.add({1, 0});
  if (q.A > 0) {
    const double foot = -q.B / q.A, half = std::sqrt(std::max(0.0, q.D)) / q.A;
    for (const double value : {foot - half, foot, foot + half}) {
      if (std::isfinite(value)) t.add({std::clamp(value, -1.0, 2.0), 0});
    }
  }
  return {t.lower - 0.15, t.upper + 0.15};
}

Scene scene_of(const Ends& s, const Disc& c, bool has_line) {
  const Extent t = scale_of(s, c);
  const Panel panel({{3, has_line ? 8.5 : 3}, {width - 2, height - 1.5}}, world_of(s, c));
  return {s,
          c,
          has_line,
          panel,
          NumberLine({2, 3}, {width - 3.5, 3}, t.lower.x, t.upper.x),
          t.lower.x,
          t.upper.x,
          exact_decision(s, c)};
}

/// Tells the steps of every method.
class Teller {
 public:
  Teller(TraceWriter& writer, const Scene& scene, bool faulty)
      : writer_(writer), words_(writer.wording()), scene_(scene), faulty_(faulty) {
    writer.trace().columns = {{"number", false}, {"value"}, {"test", false}};
  }

  void operator()(const Started<double>& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    base();
    milestone("Started", words_.say("words.set_up"), source_line,
              words_.say("liang_barsky_circle.started", arg("from", figure_place(s.segment.a)),
                         arg("to", figure_place(s.segment.b))),
              {{"radius", s.circle.radius}}, {words_.symbol("r"), figure_real(s.circle.radius), ""});
  }

  void operator()(const Measured<double>& m, int source_line = __builtin_LINE(), const char* = nullptr) {
    const double distance = std::abs(m.k) / std::sqrt(m.A);
    const std::string near = figure_real(distance), radius = figure_real(scene_.circle.radius);
    // D tells apart what looks the same here
    const std::string than = near == radius ? (m.D == 0 ? "=" : "≈") : m.D == 0 ? "≈" : m.D > 0 ? "<" : ">";
    std::string sentence =
        words_.say("liang_barsky_circle.point", arg("from", figure_place(scene_.segment.a)));
    if (m.A > 0) {
      add_perpendicular();
      sentence =
          words_.say("liang_barsky_circle.measured." + of_sign(m.D), arg("k", figure_real(std::abs(m.k))),
                     arg("root", figure_real(std::sqrt(m.A))), arg("distance", near), arg("than", than),
                     arg("r", radius), arg("D", figure_real(m.D)));
    }
    milestone("Measured", words_.say("liang_barsky_circle.phase.quadratic"), source_line, sentence,
              {{"A", m.A}, {"k", m.k}, {"D", m.D}},
              {words_.symbol("D"), figure_real(m.D), m.A > 0 ? test_of(m.D) : ""});
  }

  void operator()(const Discriminant<double>& d, int source_line = __builtin_LINE(), const char* = nullptr) {
    milestone(
        "Discriminant", words_.say("liang_barsky_circle.phase.quadratic"), source_line,
        words_.say("liang_barsky_circle.discriminant", arg("A", figure_real(d.A)),
                   arg("B", figure_factor_real(d.B)), arg("C", figure_factor_real(d.C)),
                   arg("D", figure_real(d.D))),
        {{"A", d.A}, {"B", d.B}, {"C", d.C}, {"D", d.D}},
        {words_.symbol("D"), figure_real(d.D), words_.say("liang_barsky_circle.test.notes." + of_sign(d.D))});
  }

  void operator()(const Crossed<double>& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    foot_ = c.foot;
    add_chord(c.foot, c.half);
    add_values(c.enters, c.leaves);
    milestone(
        "Crossed", words_.say("liang_barsky_circle.phase.values"), source_line,
        words_.say("liang_barsky_circle.crossed", arg("foot", figure_real(c.foot)),
                   arg("half", figure_real(c.half)), arg("enters", figure_real(c.enters)),
                   arg("leaves", figure_real(c.leaves))),
        {{"foot", c.foot}, {"half", c.half}, {"enters", c.enters}, {"leaves", c.leaves}},
        {words_.symbol("t"), range_text(c.enters, c.leaves), words_.say("liang_barsky_circle.test.line")});
  }

  void operator()(const Solved<double>& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    const bool number = std::isfinite(s.enters) && std::isfinite(s.leaves);
    if (number) add_values(s.enters, s.leaves);
    milestone("Solved", words_.say("liang_barsky_circle.phase.values"), source_line,
              number ? words_.say("liang_barsky_circle.solved", arg("enters", figure_real(s.enters)),
                                  arg("leaves", figure_real(s.leaves)))
                     : words_.say("liang_barsky_circle.solved_nothing"),
              {{"enters", number_text(s.enters)}, {"leaves", number_text(s.leaves)}},
              {words_.symbol("t"), number ? range_text(s.enters, s.leaves) : "0/0",
               words_.say("liang_barsky_circle.test.line")});
  }

  void operator()(const Limited<double>& l, int source_line = __builtin_LINE(), const char* = nullptr) {
    const bool any = l.first <= l.last;
    const auto [first, last] =
        any ? std::pair(figure_real(l.first), figure_real(l.last)) : told_apart(l.first, l.last);
    if (any) {
      add_band("c kept t", Role::accepted, scene_.line.at(l.first), scene_.line.at(l.last));
      add_part("d kept", Role::accepted, part(scene_.segment, l.first, l.last));
    }
    milestone("Limited", words_.say("liang_barsky_circle.phase.values"), source_line,
              words_.say(any ? "liang_barsky_circle.limited.some" : "liang_barsky_circle.limited.nothing",
                         arg("first", first), arg("last", last)),
              {{"first", l.first}, {"last", l.last}},
              {words_.symbol("t"), first + " … " + last,
               words_.say(any ? "liang_barsky_circle.test.some" : "liang_barsky_circle.test.nothing")});
  }

  void operator()(const Placed& p, int source_line = __builtin_LINE(), const char* = nullptr) {
    place("from", scene_.segment.a, p.from);
    place("to", scene_.segment.b, p.to);
    milestone(
        "Placed", words_.say("liang_barsky_circle.phase.decision"), source_line,
        words_.say("liang_barsky_circle.placed", arg("from", side_text(p.from)), arg("to", side_text(p.to))),
        {{"from", std::int64_t{p.from}}, {"to", std::int64_t{p.to}}},
        {words_.say("liang_barsky_circle.ends"), figure_number(p.from) + ", " + figure_number(p.to),
         side_text(p.from) + ", " + side_text(p.to)});
  }

  void operator()(const Reached& r, int source_line = __builtin_LINE(), const char* = nullptr) {
    add_perpendicular();
    const std::string key = !r.between    ? "liang_barsky_circle.reached.beside"
                            : r.sign < 0  ? "liang_barsky_circle.reached.misses"
                            : r.sign == 0 ? "liang_barsky_circle.reached.touches"
                                          : "liang_barsky_circle.reached.crosses";
    milestone("Reached", words_.say("liang_barsky_circle.phase.decision"), source_line, words_.say(key),
              {{"between", r.between}, {"sign", std::int64_t{r.sign}}},
              {words_.say("liang_barsky_circle.sign_of_D"), r.between ? figure_number(r.sign) : "",
               r.between ? test_of(r.sign) : words_.say("liang_barsky_circle.test.beside")});
  }

  void operator()(const Cut<double>& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    circle_drawing::add_point(
        view_, scene_.panel, c.leaves ? "g leaves" : "g enters", Role::current, c.at,
        words_.say(c.leaves ? "liang_barsky_circle.leaves" : "liang_barsky_circle.enters"));
    milestone("Cut", words_.say("liang_barsky_circle.phase.cut"), source_line,
              words_.say(c.leaves ? "liang_barsky_circle.cut.leaves" : "liang_barsky_circle.cut.enters",
                         arg("from", figure_place(c.from)), arg("at", figure_place(c.at))),
              {{"x", c.at.x}, {"y", c.at.y}, {"leaves", c.leaves}},
              {words_.say(c.leaves ? "liang_barsky_circle.leaves" : "liang_barsky_circle.enters"),
               figure_place(c.at), ""});
  }

  void operator()(const Finished<double>& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    std::erase_if(view_.marks, [](const auto& mark) {
      return mark.first.starts_with("d ") || mark.first.starts_with("e ");
    });
    if (!scene_.has_line) {
      view_.marks.erase("b from name");
      view_.marks.erase("b to name");
    }
    if (f.kept) add_part("h result", Role::result, *f.kept);
    if (scene_.right && kept_text(f.kept) != kept_text(scene_.right)) {
      circle_drawing::add_stroke(view_, scene_.panel, "e right", Role::measure, scene_.right->a,
                                 scene_.right->b);
      circle_drawing::add_point(view_, scene_.panel, "e right at", Role::measure, scene_.right->b,
                                words_.say("liang_barsky_circle.right"), true);
    }
    milestone("Finished", words_.say("words.result"), source_line, ending(f.kept),
              {{"kept", f.kept.has_value()}},
              {words_.say("liang_barsky_circle.kept"), "",
               f.kept ? words_.say("words.yes") : words_.say("words.no")});
    kept_ = f.kept;
  }

  std::optional<Ends> kept_;

 private:
  /// The drawing of the input, without what steps add.
  void base() {
    const Panel& panel = scene_.panel;
    view_.add({"a circle", Role::boundary, Path{panel.at(circle_drawing::whole(scene_.circle)), true}});
    circle_drawing::add_point(view_, panel, "a centre", Role::boundary, scene_.circle.centre,
                              words_.say("liang_barsky_circle.centre"));
    circle_drawing::add_stroke(view_, panel, "b segment", Role::input, scene_.segment.a, scene_.segment.b,
                               true);
    circle_drawing::add_point(view_, panel, "b from", Role::input, scene_.segment.a,
                              words_.say("liang_barsky_circle.from"));
    if (scene_.segment.a != scene_.segment.b) {
      circle_drawing::add_point(view_, panel, "b to", Role::input, scene_.segment.b,
                                words_.say("liang_barsky_circle.to"));
    }
    add_axes(view_, panel, "plane", {words_.symbol("x"), words_.symbol("y")});
    if (!scene_.has_line) return;
    scene_.line.add_to(view_, "t", words_.symbol("t"));
    view_.add({"c segment t", Role::input, Stroke{scene_.line.at(0), scene_.line.at(1)}});
    view_.add({"c from t", Role::input, Dot{scene_.line.at(0)}});
    view_.add({"c to t", Role::input, Dot{scene_.line.at(1)}});
  }

  /// The whole line, dashed, and the perpendicular from the centre.
  void add_perpendicular() {
    const dvec2 d = scene_.segment.b - scene_.segment.a;
    const double size = std::max(std::abs(d.x), std::abs(d.y));
    if (!(size > 0)) return;
    const Chord chord = chord_of(scene_.segment, {scene_.circle.centre, 0}, 0);
    const dvec2 foot = scene_.circle.centre + dvec2(chord.foot_x.value, chord.foot_y.value);
    const Extent shown = scene_.panel.shown();
    const dvec2 reach = (shown.size().x + shown.size().y) * glm::normalize(d / size);
    circle_drawing::add_stroke(view_, scene_.panel, "b line", Role::guide, foot - reach, foot + reach, false,
                               true);
    circle_drawing::add_stroke(view_, scene_.panel, "e perpendicular", Role::measure, scene_.circle.centre,
                               foot);
    circle_drawing::add_point(view_, scene_.panel, "e foot", Role::measure, foot,
                              words_.say("liang_barsky_circle.foot"), true);
  }

  void add_chord(double foot, double half) {
    const dvec2 d = scene_.segment.b - scene_.segment.a, middle = scene_.segment.a + foot * d;
    view_.marks.erase("b line");
    circle_drawing::add_stroke(view_, scene_.panel, "b line", Role::guide, middle - 1.4 * half * d,
                               middle + 1.4 * half * d, false, true);
    circle_drawing::add_stroke(view_, scene_.panel, "e half", Role::measure, middle, middle + half * d);
    if (const dvec2 name = middle + 0.5 * half * d; circle_drawing::shows(scene_.panel, name)) {
      view_.add({"e half name", Role::measure,
                 Label{scene_.panel.at(name), words_.say("liang_barsky_circle.half")}});
    }
    if (shown(foot)) {
      view_.add({"c foot t", Role::measure, Dot{scene_.line.at(foot), true}});
      view_.add({"c foot t name", Role::measure,
                 Text{scene_.line.at(foot) + name_up_, words_.say("liang_barsky_circle.foot")}});
    }
  }

  /// Where the line enters and leaves, in the plane and on the number line.
  void add_values(double enters, double leaves) {
    if (enters == leaves) {
      add_value("enters", enters, words_.say("liang_barsky_circle.touches"));
      return;
    }
    add_value("enters", enters, words_.say("liang_barsky_circle.enters"));
    add_value("leaves", leaves, words_.say("liang_barsky_circle.leaves"));
  }
  void add_value(const std::string& id, double t, const std::string& name) {
    const dvec2 at = scene_.segment.a + t * (scene_.segment.b - scene_.segment.a);
    circle_drawing::add_point(view_, scene_.panel, "g " + id, Role::current, at, name);
    if (!shown(t)) return;
    view_.add({"c " + id + " t", Role::current, Dot{scene_.line.at(t)}});
    view_.add({"c " + id + " t name", Role::current, Text{scene_.line.at(t) + name_up_, name}});
  }

  /// A part of the segment as a band, so that it is seen on the line.
  void add_part(const std::string& id, Role role, const Ends& kept) {
    const auto part = circle_drawing::shown_part(scene_.panel, kept.a, kept.b);
    if (!part) return;
    const dvec2 a = scene_.panel.at(part->first), b = scene_.panel.at(part->second);
    view_.add({id + " from", role, Dot{a}});
    if (a == b) return;
    view_.add({id, role, Stroke{a, b}});
    add_band(id, role, a, b);
    view_.add({id + " to", role, Dot{b}});
  }
  void add_band(const std::string& id, Role role, dvec2 a, dvec2 b) {
    if (a == b) return;
    const dvec2 along = glm::normalize(b - a), aside = 0.35 * dvec2{-along.y, along.x};
    const std::vector<dvec2> ring{a + aside, b + aside, b - aside, a - aside};
    view_.add({id + " band", role, Area{{ring}}});
    view_.add({id + " outline", role, Path{ring, true}});
  }

  void place(const std::string& id, dvec2 at, int side) {
    const Role role = side > 0 ? Role::rejected : Role::accepted;
    view_.marks.erase("b " + id);
    view_.marks.erase("b " + id + " name");
    circle_drawing::add_point(view_, scene_.panel, "b " + id, role, at, side_text(side));
  }

  bool shown(double t) const { return scene_.least <= t && t <= scene_.most; }
  static std::string of_sign(double x) { return x > 0 ? "crosses" : x < 0 ? "misses" : "touches"; }
  std::string test_of(double x) const { return words_.say("liang_barsky_circle.test." + of_sign(x)); }
  std::string side_text(int side) const {
    return words_.say(side < 0   ? "liang_barsky_circle.side.inside"
                      : side > 0 ? "liang_barsky_circle.side.outside"
                                 : "liang_barsky_circle.side.on");
  }
  static std::string figure_factor_real(double x) {
    return x < 0 ? "(" + figure_real(x) + ")" : figure_real(x);
  }
  static std::string number_text(double x) { return std::isfinite(x) ? figure_real(x) : "0/0"; }
  /// Two different numbers, with all their digits where fewer look the same.
  static std::pair<std::string, std::string> told_apart(double a, double b) {
    std::pair texts(figure_real(a), figure_real(b));
    if (texts.first == texts.second) texts = {fmt::format("{}", a), fmt::format("{}", b)};
    return texts;
  }
  static std::string range_text(double a, double b) { return figure_real(a) + " … " + figure_real(b); }
  std::string kept_text(const std::optional<Ends>& kept) const {
    if (!kept) return words_.say("liang_barsky_circle.nothing");
    if (kept->a == kept->b)
      return words_.say("liang_barsky_circle.one_point", arg("at", figure_place(kept->a)));
    return words_.say("liang_barsky_circle.from_to", arg("from", figure_place(kept->a)),
                      arg("to", figure_place(kept->b)));
  }
  std::string ending(const std::optional<Ends>& kept) const {
    const std::string got = kept_text(kept), right = kept_text(scene_.right);
    if (!faulty_ && got == right) return words_.say("liang_barsky_circle.done", arg("kept", got));
    if (!faulty_)
      return words_.say("liang_barsky_circle.done_rounded", arg("kept", got), arg("right", right));
    if (got == right) return words_.say("liang_barsky_circle.done_right", arg("kept", got));
    return words_.say("liang_barsky_circle.done_wrong", arg("kept", got), arg("right", right));
  }

  void milestone(std::string_view type, std::string phase, int source_line, std::string sentence,
                 std::vector<Field> fields, Row row) {
    writer_.step(before_.change_to(view_), {0, 0}, source_line, [&](TraceStep& step) {
      step.type = type;
      step.phase = std::move(phase);
      step.key = type;
      step.fields = std::move(fields);
      step.sentence = std::move(sentence);
      step.row = std::move(row);
      if (type == "Started" || type == "Finished") step.level = Level::idea;
    });
  }

  static constexpr dvec2 name_up_{0, 1.5};
  TraceWriter& writer_;
  const Wording& words_;
  const Scene& scene_;
  const bool faulty_;
  View view_;
  Shown before_;
  double foot_ = 0;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("liang_barsky_circle", std::move(name), standing);
  };
  static const std::vector<Method> methods{
      method("half_chord", Standing::taught), method("exact_decision", Standing::fast),
      method("without_empty_test", Standing::faulty), method("discriminant_equals_zero", Standing::faulty)};
  return methods;
}

/// Refuses what the textbook's squares of squares can't hold: then there would be no numbers to show.
void expect_computable(const Ends& s, const Disc& c) {
  const Quadratic<double> q = quadratic(s, c);
  const auto size = [](dvec2 v) { return std::max(std::abs(v.x), std::abs(v.y)); };
  const auto fits = [](double x) { return x == 0 || (0x1p-200 <= x && x <= 0x1p200); };
  constexpr auto wanted =
      "from 6.3e-61 to 1.6e60 expected, for this method squares squares (exact_decision takes any), found {}";
  if (!fits(size(q.d))) throw ArgumentError("line", "a segment " + fmt::format(wanted, size(q.d)));
  if (!fits(c.radius)) throw ArgumentError("circle", "a radius " + fmt::format(wanted, c.radius));
  if (size(q.f) > 0x1p200) {
    const bool far_line = size(s.a) >= size(c.centre);
    throw ArgumentError(far_line ? "line" : "circle",
                        "a distance from the centre " + fmt::format(wanted, size(q.f)));
  }
  // A point beside the line by so little that the square of it is none
  if (c.radius == 0 && q.k != 0 && q.k * q.k < 1e-290) {
    throw ArgumentError("circle",
                        "a larger radius expected: the square of the line's distance from the centre "
                        "has no number (exact_decision needs none)");
  }
}

Trace run(const Arguments& arguments, Recording recording) {
  const std::vector<double> line = arguments.numbers("line");
  const Disc circle = circle_drawing::circle_in(arguments);
  const Ends segment{{line[0], line[1]}, {line[2], line[3]}};
  circle_drawing::expect_coordinates("line", {segment.a, segment.b});
  const std::string& name = arguments.text("method");
  const auto found = std::find_if(all_methods().begin(), all_methods().end(),
                                  [&](const Method& m) { return m.name == name; });
  const bool faulty = found->standing == Standing::faulty;
  if (name != "exact_decision") expect_computable(segment, circle);
  const Scene scene = scene_of(segment, circle, name != "exact_decision");
  require_scale(scene.panel, arguments, {"circle"});

  TraceWriter writer(recording);
  Trace& about = writer.trace();
  const Wording& words = about.wording;
  introduce(about, "liang_barsky_circle", arguments, faulty);
  about.subtitle = words.say("liang_barsky_circle.subtitle", arg("from", figure_place(segment.a)),
                             arg("to", figure_place(segment.b)), arg("centre", figure_place(circle.centre)),
                             arg("radius", figure_real(circle.radius)));
  about.grid = paper_grid(width, height);
  about.legend = {{Role::input, words.say("liang_barsky_circle.legend.input")},
                  {Role::boundary, words.say("liang_barsky_circle.legend.boundary")},
                  {Role::current, words.say("liang_barsky_circle.legend.current")},
                  {Role::measure, words.say("liang_barsky_circle.legend.measure")},
                  {Role::accepted, words.say("liang_barsky_circle.legend.accepted")},
                  {Role::result, words.say("liang_barsky_circle.legend.result")}};
  about.source_file =
      std::string(folder) + (faulty ? "liang_barsky_circle_notes.hpp" : "liang_barsky_circle.hpp");
  about.listing = listing_of(source_text(about.source_file), name);

  Teller teller(writer, scene, faulty);
  if (name == "half_chord") half_chord(segment, circle, teller);
  if (name == "exact_decision") exact_decision(segment, circle, teller);
  if (name == "without_empty_test") without_empty_test(segment, circle, teller);
  if (name == "discriminant_equals_zero") discriminant_equals_zero(segment, circle, teller);
  const std::optional<Ends> kept = teller.kept_;
  Trace trace = std::move(writer).finish();
  trace.telling = {trace.last, 0};
  trace.result = {{"kept", kept.has_value()}};
  if (kept) {
    for (const auto& [field, value] :
         {std::pair{"from_x", kept->a.x}, {"from_y", kept->a.y}, {"to_x", kept->b.x}, {"to_y", kept->b.y}}) {
      trace.result.push_back({field, value});
    }
  }
  return trace;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "liang_barsky_circle",
      .title = Wording().say("liang_barsky_circle.title"),
      .chapter = "clipping",
      .aliases = {"segment circle", "line circle", "circle clipping"},
      .summary = "the part of a segment that lies in a circle, decided exactly",
      .methods = all_methods(),
      .default_method = "half_chord",
      .parameters = {{.name = "line",
                      .type = ParameterType::numbers,
                      .default_value = "-9,-3,-1,3",
                      .example = "-9,-3,-1,3",
                      .help = "the segment's ends",
                      .parts = {"x0", "y0", "x1", "y1"}},
                     {.name = "circle",
                      .type = ParameterType::numbers,
                      .default_value = "0,0,5",
                      .example = "0,0,5",
                      .help = "the circle: centre and radius",
                      .parts = {"cx", "cy", "r"}}},
      .examples = {"--line=-9,-3,-1,3 --circle 0,0,5",
                   "--line=-3,4,9,4 --circle 0,0,5 --method exact_decision",
                   "--line=-100000000,0.5,100000000,0.5 --circle 0,0,1 --method discriminant_equals_zero"},
      .run = run};
  return topic;
}

}  // namespace gradus::liang_barsky_circle
