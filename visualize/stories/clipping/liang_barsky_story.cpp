// The story of a segment and the values of t at which it enters and leaves.

#include "clipping/liang_barsky/liang_barsky.hpp"

#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "stories/clipping/clip_checking.hpp"
#include "stories/clipping/liang_barsky/drawing.hpp"
#include "stories/parameters.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::liang_barsky {
namespace {

constexpr std::array<std::string_view, 4> crossing_names{"inside", "outside", "enters", "leaves"};
constexpr std::array<std::string_view, 4> crossing_texts{"crossing.inside", "crossing.outside",
                                                         "crossing.enters", "crossing.leaves"};
constexpr std::array<std::string_view, 4> emptying_texts{"", "", "crossing.enters_late",
                                                         "crossing.leaves_early"};
constexpr std::array<std::string_view, 4> ordered_texts{"ordered.inside", "ordered.outside", "ordered.enters",
                                                        "ordered.leaves"};

std::size_t index(Crossing crossing) { return static_cast<std::size_t>(crossing); }

template <int N>
class Story {
  using Start = std::conditional_t<N == 2, Started<double>, BoxStarted<double>>;
  using Accept = std::conditional_t<N == 2, Accepted<double>, BoxAccepted<double>>;

 public:
  Story(const Words& words, const Subject<N>& subject) : words_(words), subject_(subject) {}

  void show(Board& board, const Start&) { draw(board); }
  Event say(const Start& s) const {
    Event event{.text = "started",
                .words = {{"a", s.line.a}, {"d", s.d}},
                .row = {"", "", "", "", "", enter_, leave_},
                .key = "start",
                .begins = true};
    for (int i = 0; i < N; ++i) event.facts.push_back({std::string("d") + "xyz"[i], s.d[i]});
    return event;
  }

  void show(Board& board, const Tested<double>& t) {
    // The run's figure is of the last step that changes the interval, rather its end
    const double worth = leave_ != t.leave ? 2 : enter_ != t.enter ? 1 : 0;
    if (worth > 0) board.tells(worth + 0.01 * static_cast<double>(crossed_.size()));
    enter_ = t.enter;
    leave_ = t.leave;
    crossed_.push_back({t.border, t.crossing, t.t});
    draw(board);
  }
  Event say(const Tested<double>& t) const {
    const Crossed& now = crossed_.back();
    const bool nothing_left = now.crosses() && t.enter > t.leave;
    return {.text = (nothing_left ? emptying_texts : crossing_texts)[index(t.crossing)],
            .facts = {{"border", std::string(name_of(t.border))},
                      {"p", t.p},
                      {"q", t.q},
                      {"t", t.t},
                      {"enter", t.enter},
                      {"leave", t.leave}},
            .words = {{"border", name(t.border)},
                      {"q", now.crosses() ? figure_factor(t.q) : figure_real(t.q)},
                      {"pq", figure_factor(t.p)},
                      {"value", now.enters() ? t.enter : t.leave}},
            .row = {name(t.border), t.p, t.q, now.crosses() ? figure_real(t.t) : "", kind(t.crossing),
                    t.enter, t.leave},
            .key = std::string(name_of(t.border)),
            .phase = name(t.border),
            .decides = crossing(t.border, t.crossing)};
  }

  void show(Board& board, const Accept& a) { accept(board, a.line); }
  Event say(const Accept& a) const { return accepted(a.line, anything_left(true)); }
  void show(Board& board, const Rejected<double>&) { draw(board, Role::rejected); }
  Event say(const Rejected<double>&) const { return rejected(anything_left(false)); }

  const std::vector<Field>& result() const { return result_; }
  const Ground<N>& ground() const { return ground_; }

 protected:
  std::string name(Border border) const { return words_.say(fmt::format("border.{}", name_of(border))); }
  std::string kind(Crossing c) const { return words_.say(fmt::format("kind.{}", crossing_names[index(c)])); }

  Decision crossing(Border border, Crossing c) const {
    Decision decision{words_.say("question", {{"border", name(border)}}), {}, index(c)};
    for (const Crossing each : {Crossing::inside, Crossing::outside, Crossing::enters, Crossing::leaves}) {
      decision.answers.push_back(kind(each));
    }
    decision.branch = crossing_names[decision.answer];
    return decision;
  }
  Decision anything_left(bool is) const {
    return yes_or_no(words_, "question_left", {{"enter", enter_}, {"leave", leave_}}, is, "accepted",
                     "rejected");
  }

  void accept(Board& board, const Segment<N, double>& piece) {
    draw(board, Role::result);
    result_ = {{"accepted", true}};
    if constexpr (N == 2) {
      if (const auto right = correctly_rounded(subject_.line, subject_.box))
        off_ = window_view::off_by(piece, *right);
      result_.push_back({"off_by", off_.doubles});
    }
  }
  Event accepted(const Segment<N, double>& piece, Decision decision) const {
    Event event{.text = "accepted_box", .words = {{"from", piece.a}, {"to", piece.b}}, .ends = true};
    if constexpr (N == 2) event = window_view::accepted(piece, off_);
    event.decides = std::move(decision);
    return event;
  }
  static Event rejected(Decision decision) {
    return {.text = N == 2 ? "rejected" : "rejected_box", .ends = true, .decides = std::move(decision)};
  }

  /// The whole drawing: the box and the line above, its values of t below.
  void draw(Board& board, Role left_over = Role::current) const {
    View view;
    ground_.add_box_and_ends(view, words_);
    ground_.add_prolonged(view);
    scale_.add_to(view, words_.symbol("t"));
    add_line(view, left_over);
    for (const Crossed& c : crossed_) {
      // As what is left is shown; where nothing is, as what it does
      const bool now = &c == &crossed_.back() && left_over == Role::current && enter_ <= leave_;
      if (c.crosses()) add_crossing(view, c, now ? Role::current : c.enters() ? Role::candidate : Role::past);
    }
    if (!crossed_.empty() && left_over == Role::current) ground_.add_border(view, crossed_.back().border);
    board.milestone(std::move(view));
  }
  /// What is left of the line by now, dashed before and behind.
  void add_line(View& view, Role left_over) const {
    // In space a line along a face, outside it, counts as left until it is rejected
    const bool outside = N == 2 && !crossed_.empty() && crossed_.back().crossing == Crossing::outside;
    if (left_over == Role::rejected || enter_ > leave_ || outside) {
      const Role role = left_over == Role::rejected ? left_over : Role::input;
      return ground_.add_part(view, "line", role, 0, 1, true);
    }
    ground_.add_part(view, "line before", Role::input, 0, enter_, true);
    ground_.add_part(view, "left over", left_over, enter_, leave_, false);
    ground_.add_part(view, "line after", Role::input, leave_, 1, true);
    const dvec2 up{0, 0.45};
    view.add({"allowed", left_over, Stroke{scale_.at(enter_) + up, scale_.at(leave_) + up}});
  }
  void add_crossing(View& view, const Crossed& c, Role role) const {
    const double t = subject_.value_at(c.border);
    const std::string text = mark(c.border, c.enters(), t);
    const auto [height, align] = rows_.of(text);
    const dvec2 foot = scale_.at(t), head = foot + dvec2{0, height};
    view.add({c.id() + " stem", Role::guide, Stroke{foot, head - dvec2{0, 0.8}}});
    const std::string bound = c.enters() ? "enter" : "leave";
    view.add({c.id() + " dot", role, Dot{foot, c.leaves()}, bound});
    view.add({c.id() + " text", role, Text{head, text, align, true}, bound});
    ground_.add_crossing(view, c, role, name(c.border), bound);
  }
  /// "in: left"; of a value beyond the scale the number, too.
  std::string mark(Border border, bool enters, double t) const {
    std::string text = words_.say(enters ? "mark.enters" : "mark.leaves", {{"border", name(border)}});
    return scale_.holds(t) ? text : fmt::format("{} {}", text, figure_real(t));
  }
  /// The values at all borders that the line crosses.
  static std::vector<double> values_of(const Subject<N>& subject) {
    std::vector<double> values;
    for (const Border border : usual_order<N>()) {
      if (subject.crosses(border)) values.push_back(subject.value_at(border));
    }
    return values;
  }
  static Scale scale_of(const Subject<N>& subject) {
    double least = -0.05, most = 1.05;
    const std::vector<double> values = values_of(subject);
    for (const double t : values) {
      if (t < Ground<N>::least || t > Ground<N>::most) continue;
      least = std::min(least, t - 0.05);
      most = std::max(most, t + 0.05);
    }
    return {least, most, values};
  }
  std::vector<Rows::Entry> entries() const {
    std::vector<Rows::Entry> entries;
    for (const Border border : usual_order<N>()) {
      if (!subject_.crosses(border)) continue;
      const double t = subject_.value_at(border);
      entries.push_back({scale_.at(t).x, mark(border, subject_.enters(border), t)});
    }
    return entries;
  }

  const Words& words_;
  const Subject<N>& subject_;
  const Ground<N> ground_{subject_};
  const Scale scale_ = scale_of(subject_);
  const Rows rows_{entries()};
  double enter_ = 0, leave_ = 1;
  std::vector<Crossed> crossed_;
  window_view::Off off_{};
  std::vector<Field> result_{{"accepted", false}};
};

/// The same where borders are compared, and no value of t is computed: those drawn are told as rough ones.
class OrderedStory : public Story<2> {
 public:
  using Story::Story, Story::show, Story::say;

  Event say(const Started<double>& s) const {
    Event event = Story::say(s);
    event.row = {"", "", "", "a", "b"};
    return event;
  }

  void show(Board& board, const Ordered<double>& o) {
    const auto& [enter, leave] = o.span;
    enter_ = enter ? subject_.value_at(*enter) : 0;
    leave_ = leave ? subject_.value_at(*leave) : 1;
    crossed_.push_back({o.border, o.crossing, 0});
    if (crossed_.back().crosses()) crossed_.back().t = subject_.value_at(o.border);
    draw(board);
  }
  Event say(const Ordered<double>& o) const {
    const Crossed& now = crossed_.back();
    const bool missed = o.beyond && o.crossing != Crossing::outside;
    return {.text = missed ? "ordered.missed" : ordered_texts[index(o.crossing)],
            .facts = {{"border", std::string(name_of(o.border))}, {"beyond", o.beyond}},
            .words = {{"border", name(o.border)}, {"first", first(o.span)}, {"last", last(o.span)}},
            .row = {name(o.border), kind(o.crossing), now.crosses() ? "≈ " + figure_real(now.t) : "",
                    first(o.span), last(o.span)},
            .key = std::string(name_of(o.border)),
            .phase = name(o.border),
            .decides = crossing(o.border, o.crossing)};
  }

  void show(Board& board, const Kept<double>& k) { accept(board, k.line); }
  Event say(const Kept<double>& k) const { return accepted(k.line, anything_between(k.span, true)); }
  void show(Board& board, const Missed&) { draw(board, Role::rejected); }
  Event say(const Missed& m) const { return rejected(anything_between(m.span, false)); }

 private:
  /// The last way in, the first way out.
  std::string first(const Span& span) const { return span.enter ? name(*span.enter) : "a"; }
  std::string last(const Span& span) const { return span.leave ? name(*span.leave) : "b"; }
  Decision anything_between(const Span& span, bool is) const {
    return yes_or_no(words_, "question_between", {{"first", first(span)}, {"last", last(span)}}, is,
                     "accepted", "rejected");
  }
};

// --- The methods

/// What the steps of the parametric methods hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Tested<T>& t) const {
    to.number("t", t.t);
    to.number("enter", t.enter);
    to.number("leave", t.leave);
    to.decision(t.crossing);
  }
  /// The first step has a direction, the last one two ends or none.
  template <class T, class Step>
  void operator()(NumericStep<T>& to, const Step& step) const {
    if constexpr (requires { step.d; }) {
      to.point("d", step.d);
    } else if constexpr (requires { step.line; }) {
      to.point("a", step.line.a);
      to.point("b", step.line.b);
    }
  }
};

template <int N, class Clip>
void tell(Narrator& narrator, const Subject<N>& subject, const Story<N>& story, Clip clip) {
  narrator.paper(window_view::paper_width, window_view::paper_height);
  narrator.subtitle("subtitle", {{"from", subject.line.a}, {"to", subject.line.b}});
  narrator.quantities({"enter", "t", "leave", "p"});
  narrator.legend({Role::boundary, Role::input, Role::current, Role::measure, Role::candidate, Role::past,
                   Role::rejected, Role::result});
  story.ground().let_drag(narrator);
  clip();
  narrator.result(story.result());
}

Subject<2> window_subject(const Arguments& arguments) {
  const Subject<2> subject{window_view::line_in(arguments), window_view::window_in(arguments)};
  window_view::require_scale(arguments, subject.line, subject.box);
  return subject;
}

void tell_parametric(Narrator& narrator) {
  const auto subject = window_subject(narrator.arguments());
  const auto order = order_in<2>(narrator.arguments());
  Story<2> story(narrator.words(), subject);
  tell(narrator, subject, story,
       [&] { parametric(subject.line, subject.box, order, narrator.watcher(story)); });
  tell_side_by_side<Numbers>(narrator, [subject, order]<class T>(T, const auto& observer) {
    parametric(in_scalar<T>(subject.line), in_scalar<T>(subject.box), order, observer);
  });
}

void tell_correctly_rounded(Narrator& narrator) {
  const auto subject = window_subject(narrator.arguments());
  const auto order = order_in<2>(narrator.arguments());
  narrator.columns({{"border", false}, {"kind", false}, {"t"}, {"first", false}, {"last", false}});
  OrderedStory story(narrator.words(), subject);
  tell(narrator, subject, story,
       [&] { correctly_rounded(subject.line, subject.box, order, narrator.watcher(story)); });
}

void tell_box_parametric(Narrator& narrator) {
  const Arguments& arguments = narrator.arguments();
  const Subject<3> subject{segment_in<3>(arguments, "space_line"), box_in<3>(arguments, "box")};
  const auto order = usual_order<3>();
  Story<3> story(narrator.words(), subject);
  tell(narrator, subject, story,
       [&] { box_parametric(subject.line, subject.box, order, narrator.watcher(story)); });
  tell_side_by_side<Numbers>(narrator, [subject, order]<class T>(T, const auto& observer) {
    box_parametric(in_scalar<T>(subject.line), in_scalar<T>(subject.box), order, observer);
  });
}

const Checking& checking() {
  static const Checking known{.asked = {{.name = "segment",
                                         .same = SameList::segments,
                                         .type = "Accepted",
                                         .fields = {"x0", "y0", "x1", "y1"}}},
                              .is_tie = is_tie_in_table_of_t,
                              .follows = follows_in_table_of_t};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "liang_barsky",
       .chapter = "clipping",
       .aliases = {"liang barsky", "parametric line clipping"},
       .summary = "the part of a segment that lies in a window, by the values of t that its borders allow",
       .methods = {{.name = "parametric",
                    .standing = Standing::taught,
                    .tell = tell_parametric,
                    .sizes = {{"line", window_view::rounded_sizes}, {"window", window_view::rounded_sizes}},
                    .unread = {"space_line", "box"},
                    .exact = true},
                   {.name = "correctly_rounded",
                    .standing = Standing::fast,
                    .tell = tell_correctly_rounded,
                    .unread = {"space_line", "box"}},
                   {.name = "box_parametric",
                    .tell = tell_box_parametric,
                    .file = "liang_barsky_box.hpp",
                    .unread = {"line", "window", "order"},
                    .exact = true}},
       .columns = {{"border", false}, {"p"}, {"q"}, {"t"}, {"kind", false}, {"enter"}, {"leave"}},
       .counts = {"Tested", "Ordered"},
       .parameters = {window_view::line_parameter(), window_view::window_parameter(),
                      window_view::order_parameter(),
                      numbers("space_line", "-2,1,2,12,11,9", "-2,1,2,12,11,9",
                              "method box_parametric: the segment's ends x0,y0,z0,x1,y1,z1",
                              {"x0", "y0", "z0", "x1", "y1", "z1"}, window_view::rounded_sizes),
                      bounds(
                          "box", "0,0,0,10,8,6", "0,0,0,10,8,6",
                          "method box_parametric: the box xmin,ymin,zmin,xmax,ymax,zmax, its faces included",
                          {"xmin", "ymin", "zmin", "xmax", "ymax", "zmax"}, window_view::rounded_sizes),
                      exact_parameter()},
       .examples = {"--line -4,3,6,15 --window 0,0,10,10", "--window 0,0,10,10 --line -5,8,3,20",
                    "--line -3,-8,13,16"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::liang_barsky
