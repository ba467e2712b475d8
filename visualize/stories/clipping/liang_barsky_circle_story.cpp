// The story of a segment in a circle: the foot of the perpendicular, half the chord, and what t they are.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "stories/clipping/liang_barsky_circle/drawing.hpp"
#include "stories/parameters.hpp"

namespace gradus::liang_barsky_circle {
namespace {

using circle_drawing::real;

std::string factor(double x) { return figure_factor(real(x)); }
std::string range_text(double a, double b) { return a == b ? real(a) : real(a) + " … " + real(b); }
std::string number_text(double x) { return std::isfinite(x) ? real(x) : "0/0"; }

/// Two different numbers, with all their digits where fewer look the same.
std::pair<std::string, std::string> told_apart(double a, double b) {
  std::pair texts(real(a), real(b));
  if (texts.first == texts.second) texts = {fmt::format("{}", a), fmt::format("{}", b)};
  return texts;
}

// --- The steps

class Story {
 public:
  /// asks_for_rest: whether the method tests that the values of t it is left with are in order.
  Story(const Words& words, const Subject& subject, bool faulty, bool asks_for_rest)
      : words_(words),
        subject_(subject),
        faulty_(faulty),
        asks_for_rest_(asks_for_rest),
        drawing_(words, subject) {}

  template <class Step>
  void show(Board& board, const Step& step) {
    draw(step);
    board.milestone(drawing_.view());
  }

  Event say(const Started<double>& s) const {
    return {.text = "started",
            .facts = {{"radius", s.circle.radius}},
            .words = {{"from", s.segment.a}, {"to", s.segment.b}},
            .row = {words_.symbol("r"), real(s.circle.radius), ""},
            .level = Level::idea};
  }

  Event say(const Measured<double>& m) const {
    const double distance = std::abs(m.k) / std::sqrt(m.A);
    const std::string near = real(distance), radius = real(subject_.circle.radius);
    // D tells apart what looks the same here
    const bool alike = without_notes(near) == without_notes(radius);
    const char* than = alike ? (m.D == 0 ? "=" : "≈") : m.D == 0 ? "≈" : m.D > 0 ? "<" : ">";
    Event event{.text = "point",
                .facts = {{"A", m.A}, {"k", m.k}, {"D", m.D}},
                .words = {{"from", subject_.segment.a},
                          {"k", real(std::abs(m.k))},
                          {"root", real(std::sqrt(m.A))},
                          {"distance", near},
                          {"than", than},
                          {"r", radius},
                          {"D", real(m.D)}},
                .row = {words_.symbol("D"), real(m.D), ""},
                .phase = words_.say("phase.quadratic")};
    if (!(m.A > 0)) return event;
    event.text = m.D > 0 ? "measured.crosses" : m.D < 0 ? "measured.misses" : "measured.touches";
    event.row.back() = test_of(m.D);
    event.decides = nearness("test.", m.D);
    return event;
  }

  Event say(const Discriminant<double>& d) const {
    return {.text = "discriminant",
            .facts = {{"A", d.A}, {"B", d.B}, {"C", d.C}, {"D", d.D}},
            .words = {{"A", real(d.A)}, {"B", factor(d.B)}, {"C", factor(d.C)}, {"D", real(d.D)}},
            .row = {words_.symbol("D"), real(d.D), words_.say("test.notes." + of_sign(d.D))},
            .phase = words_.say("phase.quadratic"),
            .decides = nearness("test.notes.", d.D)};
  }

  Event say(const Crossed<double>& c) const {
    return {.text = c.half == 0 ? "touched" : "crossed",
            .facts = {{"foot", c.foot, "t"},
                      {"half", c.half, "t"},
                      {"enters", c.enters, "t"},
                      {"leaves", c.leaves, "t"}},
            .words = {{"foot", real(c.foot)},
                      {"half", real(c.half)},
                      {"enters", real(c.enters)},
                      {"leaves", real(c.leaves)}},
            .row = {words_.symbol("t"), range_text(c.enters, c.leaves), words_.say("test.line")},
            .phase = words_.say("phase.values")};
  }

  Event say(const Solved<double>& s) const {
    const bool numbers = std::isfinite(s.enters) && std::isfinite(s.leaves);
    const std::string enters = number_text(s.enters), leaves = number_text(s.leaves);
    return {.text = numbers ? "solved" : "solved_nothing",
            .facts = {{"enters", enters, "t"}, {"leaves", leaves, "t"}},
            .row = {words_.symbol("t"), numbers ? range_text(s.enters, s.leaves) : "0/0",
                    words_.say("test.line")},
            .phase = words_.say("phase.values")};
  }

  Event say(const Limited<double>& l) const {
    const bool any = l.first <= l.last;
    const auto [first, last] = any ? std::pair(real(l.first), real(l.last)) : told_apart(l.first, l.last);
    Event event{.text = !any                ? "limited.nothing"
                        : l.first == l.last ? "limited.point"
                                            : "limited.some",
                .facts = {{"first", l.first, "t"}, {"last", l.last, "t"}},
                .words = {{"first", first}, {"last", last}},
                .row = {words_.symbol("t"), any ? range_text(l.first, l.last) : first + " … " + last,
                        words_.say(any ? "test.some" : "test.nothing")},
                .phase = words_.say("phase.values")};
    if (asks_for_rest_) {
      event.decides = {words_.say("question.rest", {{"first", first}, {"last", last}}),
                       {words_.say("test.some"), words_.say("test.nothing")},
                       any ? 0u : 1u,
                       any ? "accepted" : "rejected"};
    }
    return event;
  }

  Event say(const Placed& p) const {
    const std::size_t outside = (p.from > 0 ? 1u : 0u) + (p.to > 0 ? 1u : 0u);
    constexpr std::array<const char*, 3> branches{"inside", "cut", "outside"};
    return {.text = "placed",
            .facts = {{"from", p.from, "side"}, {"to", p.to, "side"}},
            .words = {{"from", side_text(p.from)}, {"to", side_text(p.to)}},
            .row = {words_.say("ends"), figure_number(p.from) + ", " + figure_number(p.to),
                    side_text(p.from) + ", " + side_text(p.to)},
            .phase = words_.say("phase.decision"),
            .decides = Decision{words_.say("question.ends"), {"0", "1", "2"}, outside, branches[outside]}};
  }

  Event say(const Reached& r) const {
    return {.text = !r.between    ? "reached.beside"
                    : r.sign < 0  ? "reached.misses"
                    : r.sign == 0 ? "reached.touches"
                                  : "reached.crosses",
            .facts = {{"between", r.between}, {"sign", r.sign}},
            .row = {words_.say("sign_of_D"), r.between ? figure_number(r.sign) : "",
                    r.between ? test_of(r.sign) : words_.say("test.beside")},
            .phase = words_.say("phase.decision"),
            .decides = Decision{words_.say("question.between"),
                                {test_of(1), test_of(0), test_of(-1), words_.say("test.beside")},
                                r.between ? answer_of(r.sign) : 3u,
                                r.between ? of_sign(r.sign) : "beside"}};
  }

  Event say(const Cut<double>& c) const {
    const char* text = c.leaves ? "cut.leaves" : "cut.enters";
    return {.text = drawing_.touches() ? "cut.touches" : text,
            .facts = {{"x", c.at.x}, {"y", c.at.y}, {"leaves", c.leaves}},
            .words = {{"from", c.from}, {"at", c.at}},
            .row = {words_.say(c.leaves ? "leaves" : "enters"), c.at, ""},
            .phase = words_.say("phase.cut")};
  }

  Event say(const Finished<double>& f) const {
    const bool right = is_right(f.kept);
    return {.text = faulty_ ? (right ? "done_right" : "done_wrong")
                    : right ? "done"
                            : "done_rounded",
            .facts = {{"kept", f.kept.has_value()}},
            .words = {{"kept", kept_text(f.kept)}, {"right", kept_text(subject_.right)}},
            .row = {words_.say("kept"), "", words_.shared("words", f.kept ? "yes" : "no")}};
  }

 private:
  void draw(const Started<double>&) { drawing_.add_input(); }
  void draw(const Measured<double>& m) {
    if (m.A > 0) drawing_.add_perpendicular();
  }
  void draw(const Discriminant<double>&) {}
  void draw(const Crossed<double>& c) {
    drawing_.add_chord(c.foot, c.half);
    drawing_.add_values(c.enters, c.leaves);
  }
  void draw(const Solved<double>& s) {
    if (std::isfinite(s.enters) && std::isfinite(s.leaves)) drawing_.add_values(s.enters, s.leaves);
  }
  void draw(const Limited<double>& l) {
    if (l.first <= l.last) drawing_.add_limits(l.first, l.last);
  }
  void draw(const Placed& p) {
    drawing_.add_end("from", subject_.segment.a, p.from, side_text(p.from));
    drawing_.add_end("to", subject_.segment.b, p.to, side_text(p.to));
  }
  void draw(const Reached&) { drawing_.add_perpendicular(); }
  void draw(const Cut<double>& c) { drawing_.add_cut(c); }
  void draw(const Finished<double>& f) { drawing_.add_result(f.kept, !is_right(f.kept)); }

  static std::string of_sign(double x) { return x > 0 ? "crosses" : x < 0 ? "misses" : "touches"; }
  static std::size_t answer_of(double x) { return x > 0 ? 0 : x < 0 ? 2 : 1; }
  std::string test_of(double x) const { return words_.say("test." + of_sign(x)); }
  std::string side_text(int side) const {
    return words_.say(side < 0 ? "side.inside" : side > 0 ? "side.outside" : "side.on");
  }
  std::string kept_text(const std::optional<Ends>& kept) const {
    if (!kept) return words_.say("nothing");
    if (kept->a == kept->b) return words_.say("one_point", {{"at", kept->a}});
    return words_.say("from_to", {{"from", kept->a}, {"to", kept->b}});
  }
  /// As far as the reader can see.
  bool is_right(const std::optional<Ends>& kept) const {
    return kept_text(kept) == kept_text(subject_.right);
  }

  /// What D decides, in answers of this kind.
  Decision nearness(const std::string& kind, double D) const {
    return {words_.say("question.near", {{"D", real(D)}}),
            {words_.say(kind + "crosses"), words_.say(kind + "touches"), words_.say(kind + "misses")},
            answer_of(D),
            of_sign(D)};
  }

  const Words& words_;
  const Subject& subject_;
  const bool faulty_, asks_for_rest_;
  ChordDrawing drawing_;
};

// --- The methods

/// Refuses what the textbook's squares of squares can't hold: then there would be no numbers to show.
void expect_computable(const Ends& s, const Disc& c) {
  const Quadratic<double> q = quadratic(s, c);
  const auto size = [](dvec2 v) { return std::max(std::abs(v.x), std::abs(v.y)); };
  const auto fits = [](double x) { return x == 0 || (0x1p-200 <= x && x <= 0x1p200); };
  const auto wanted = [](std::string_view parameter, std::string_view what, double found) {
    refuse(parameter,
           "{} from 6.3e-61 to 1.6e60 expected, for this method squares squares (exact_decision takes any), "
           "found {}",
           what, found);
  };
  if (!fits(size(q.d))) wanted("line", "a segment", size(q.d));
  if (!fits(c.radius)) wanted("circle", "a radius", c.radius);
  if (size(q.f) > 0x1p200) {
    wanted(size(s.a) >= size(c.centre) ? "line" : "circle", "a distance from the centre", size(q.f));
  }
  // A point beside the line by so little that the square of it is none
  if (c.radius == 0 && q.k != 0 && q.k * q.k < 1e-290) {
    refuse("circle",
           "a larger radius expected: the square of the line's distance from the centre has no number "
           "(exact_decision needs none)");
  }
}

void set_up(Narrator& narrator, const Subject& subject) {
  require_scale(subject.panel, narrator.arguments(), {"circle"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"from", subject.segment.a},
                                 {"to", subject.segment.b},
                                 {"centre", subject.circle.centre},
                                 {"radius", real(subject.circle.radius)}});
  narrator.quantities({"enters", "t", "leaves", "D"});
  narrator.legend({Role::boundary, Role::input, Role::candidate, Role::past, Role::measure, Role::accepted,
                   Role::result});
  narrator.key_by_type();
  circle_drawing::let_drag(narrator, "line", subject.circle, subject.panel, true);
}

enum class Numbers { rounded, none };  ///< of t: whether the method computes them

template <Numbers numbers, bool asks_for_rest, auto clip>
void tell(Narrator& narrator) {
  const std::vector<double> line = narrator.arguments().numbers("line");
  const Disc circle = circle_drawing::circle_in(narrator.arguments());
  const Ends segment{{line[0], line[1]}, {line[2], line[3]}};
  circle_drawing::expect_coordinates("line", {segment.a, segment.b});
  if (numbers == Numbers::rounded) expect_computable(segment, circle);
  const Subject subject = subject_of(segment, circle, numbers == Numbers::rounded);
  set_up(narrator, subject);
  Story story(narrator.words(), subject, narrator.method().standing == Standing::faulty, asks_for_rest);
  const std::optional<Ends> kept = clip(segment, circle, narrator.watcher(story));
  // The parameters of the circle meet those of the segment
  if (const auto& steps = narrator.trace().steps; asks_for_rest && !steps.empty()) {
    const auto limited = std::ranges::find(steps, "Limited", &TraceStep::type);
    if (limited != steps.end()) narrator.telling(limited->number);
  }
  if (!kept) return narrator.result({{"kept", false}});
  narrator.result({{"kept", true},
                   {"from_x", kept->a.x, "x"},
                   {"from_y", kept->a.y, "y"},
                   {"to_x", kept->b.x, "x"},
                   {"to_y", kept->b.y, "y"}});
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "liang_barsky_circle",
       .chapter = "clipping",
       .aliases = {"segment circle", "line circle", "circle clipping"},
       .summary = "the part of a segment that lies in a circle, decided exactly",
       .methods =
           {{.name = "half_chord",
             .standing = Standing::taught,
             .tell = tell<Numbers::rounded, true, [](auto... run) { return half_chord(run...); }>},
            {.name = "exact_decision",
             .standing = Standing::fast,
             .tell = tell<Numbers::none, false, [](auto... run) { return exact_decision(run...); }>},
            {.name = "without_empty_test",
             .standing = Standing::faulty,
             .tell = tell<Numbers::rounded, false, [](auto... run) { return without_empty_test(run...); }>},
            {.name = "discriminant_equals_zero",
             .standing = Standing::faulty,
             .tell =
                 tell<Numbers::rounded, true, [](auto... run) { return discriminant_equals_zero(run...); }>}},
       .columns = {{"number", false}, {"value"}, {"test", false}},
       .parameters = {numbers("line", "-9,-3,-1,3", "-9,-3,-1,3", "the segment's ends",
                              {"x0", "y0", "x1", "y1"}),
                      numbers("circle", "0,0,5", "0,0,5", "the circle: centre and radius",
                              {"cx", "cy", "r"})},
       .examples = {"--line=-9,-3,-1,3 --circle 0,0,5",
                    "--line=-3,4,9,4 --circle 0,0,5 --method exact_decision",
                    "--line=-100000000,0.5,100000000,0.5 --circle 0,0,1 --method discriminant_equals_zero"}});
  return topic;
}

}  // namespace gradus::liang_barsky_circle
