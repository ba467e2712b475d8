// The story of Bézier curves: de Casteljau's triangle of points and what it is good for - a point with its
// tangent, two halves, chords - and the weights behind it.

#include "modeling/bezier_curve/bezier_curve.hpp"

#include "modeling/bezier_curve/bezier_curve_notes.hpp"
#include "modeling/bezier_curve/compensated.hpp"
#include "stories/modeling/bezier_curve/checking.hpp"
#include "stories/modeling/bezier_curve/chords_story.hpp"
#include "stories/modeling/bezier_curve/drawing.hpp"
#include "stories/modeling/bezier_curve/raised_story.hpp"
#include "stories/modeling/bezier_curve/roundings_drawing.hpp"
#include "stories/modeling/bezier_curve/weights_story.hpp"
#include "stories/parameters.hpp"
#include "stories/past.hpp"

namespace gradus::bezier_curve {
namespace {

using PointMixed = Mixed<2, double>;

constexpr Extent above_slider{{2, 6}, {34, 25.5}}, beside_plot{{0.5, 6}, {20.5, 26.5}},
    whole_paper{{2, 1.5}, {34, 25.5}};

Subject subject_of(const Arguments& arguments) {
  const Subject subject{arguments.points("control"), arguments.number("t").value_or(0),
                        arguments.number("tolerance").value_or(1),
                        static_cast<int>(arguments.integer("times"))};
  if (!(0 <= subject.t && subject.t <= 1)) refuse("t", "expected t from 0 to 1, found {}", subject.t);
  return subject;
}

// --- Rounds: a point, or both halves

class RoundsStory : public Past<steps::Started, PointMixed, Reached<2, double>, Halves<2, double>> {
 public:
  enum class Kind { point, halves, overwritten, compensated };

  RoundsStory(const Words& words, const Subject& subject, const CurveDrawing& drawing, Kind kind)
      : words_(words), subject_(subject), drawing_(drawing), kind_(kind) {
    if (kind == Kind::compensated) roundings_.emplace(subject);
  }

  /// What the roundings took up to the point that is told next.
  void keep(dvec2 lost) { lost_ = lost; }

  /// Of few points a round is a row of the table.
  bool by_round() const { return subject_.degree() <= most_by_round && kind_ != Kind::overwritten; }

  Event say(const steps::Started&) const {
    Event event{
        .text = kind_ == Kind::halves ? "started.split" : "started",
        .words = {{"points", subject_.control.size()}, {"degree", subject_.degree()}, {"t", subject_.t}}};
    if (by_round()) event.row = row_of(0);
    return event;
  }
  Event say(const PointMixed& m) const {
    const bool last = m.round == subject_.degree(), wrong = kind_ == Kind::overwritten;
    const std::string name = name_of(m.round, m.i);
    Event event{.text = "mixed",
                .facts = {{"round", static_cast<std::int64_t>(m.round)},
                          {"i", static_cast<std::int64_t>(m.i)},
                          {"x", m.point.x},
                          {"y", m.point.y}},
                .words = {{"name", name},
                          {"first", name_of(m.round - 1, m.i)},
                          {"second", second_of(m)},
                          {"t", subject_.t},
                          {"s", 1 - subject_.t},
                          {"a", shown(m.a)},
                          {"c", shown(m.c)},
                          {"point", shown(m.point)}},
                .note = fmt::format("{} = {}", name, figure_place(shown(m.point))),
                .key = name,
                .phase = words_.say("phase.round", {{"round", m.round}}),
                .decides = nearer(m, name)};
    if (wrong && !(last && m.i == 0) && is_of_the_round(m)) event.text = "mixed.overwritten";
    if (last) {
      event.text = wrong                   ? "mixed.missed"
                   : kind_ == Kind::halves ? "mixed.split"
                   : m.a == m.c            ? "mixed.still"
                                           : "mixed.last";
      if (wrong) event.words.push_back({"right", right_point()});
      if (wrong) event.words.push_back({"off", length_between(m.point, right_point())});
    }
    if (kind_ == Kind::compensated) {
      event.text = last ? "mixed.compensated.last" : "mixed.compensated";
      event.words.push_back({"lost", lost_});
    }
    if (last && kind_ == Kind::halves) {
      event.words.push_back({"part", names_of_parts().first});
      event.words.push_back({"rest", names_of_parts().second});
    }
    put_row(event, m, name);
    return event;
  }
  /// Which weight belongs to which point is what is mixed up.
  Decision nearer(const PointMixed& m, const std::string& name) const {
    const std::size_t answer = subject_.t < 0.5 ? 0 : subject_.t > 0.5 ? 1 : 2;
    return {words_.say("question.nearer", {{"name", name}}),
            {name_of(m.round - 1, m.i), second_of(m), words_.say("neither")},
            answer,
            std::array{"first", "second", "middle"}[answer]};
  }
  Event say(const Reached<2, double>& r) const {
    Event event{.text = kind_ == Kind::overwritten   ? "reached.missed"
                        : kind_ == Kind::compensated ? "reached.compensated"
                                                     : "reached",
                .words = {{"point", shown(r.point)}, {"t", subject_.t}}};
    if (kind_ == Kind::overwritten) event.words.push_back({"right", right_point()});
    event.ends = true;
    return event;
  }
  Event say(const Halves<2, double>& h) const {
    return {.text = "halves", .words = {{"point", shown(h.rest.front())}}, .ends = true};
  }

  /// The last point of the triangle.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, PointMixed>)
      return step.round == subject_.degree() ? 1 : 0;
    return 0;
  }

  View draw() const {
    View view;
    drawing_.add_polygon(view);
    if (kind_ == Kind::halves && last_is_reached())
      add_halves(view);
    else
      drawing_.add_curve(view, "b curve", Role::accepted);
    if (!now<Halves<2, double>>()) add_rounds(view);
    if (const auto* m = now<PointMixed>()) add_mixed(view, *m);
    if (const auto* reached = now<Reached<2, double>>())
      view.add_named("g point", Role::result, drawing_.at(reached->point), last_name());
    if (kind_ == Kind::halves) add_outer(view);
    if (kind_ == Kind::overwritten && last_is_reached())
      view.add_named("i right", Role::accepted, drawing_.at(right_point()), words_.say("right"));
    if (roundings_) roundings_->add_to(view, words_);
    slider_.add_to(view, words_.symbol("t"));
    return view;
  }
  const Slider& slider() const { return slider_; }

 private:
  static constexpr Index most_by_round = 3;
  /// Of more the points of old rounds have no names.
  static constexpr Index most_names = 4;

  dvec2 shown(dvec2 p) const { return without_dust(p, subject_.control); }
  dvec2 right_point() const { return point_at(subject_.control, subject_.t); }
  std::string last_name() const { return name_of(subject_.degree(), 0); }
  bool last_is_reached() const {
    return last<PointMixed>() && last<PointMixed>()->round == subject_.degree();
  }
  /// In the faulty order the second neighbour has been overwritten, but for the last one.
  bool is_of_the_round(const PointMixed& m) const {
    return kind_ == Kind::overwritten && m.i + m.round < subject_.degree();
  }
  std::string second_of(const PointMixed& m) const {
    return name_of(is_of_the_round(m) ? m.round : m.round - 1, m.i + 1);
  }

  std::vector<Said> row_of(Index round) const {
    std::vector<Said> row{Said(round)};
    if (round == 0) {
      for (const dvec2 p : subject_.control) row.emplace_back(p);
    }
    for (const PointMixed& m : all<PointMixed>()) {
      if (m.round == round) row.emplace_back(shown(m.point));
    }
    return row;
  }
  void put_row(Event& event, const PointMixed& m, const std::string& name) const {
    if (!by_round())
      event.row = {name, fmt::format("{}, {}", name_of(m.round - 1, m.i), second_of(m)), shown(m.point)};
    else
      (m.i == 0 ? event.row : event.read) = row_of(m.round);
  }

  /// The points of each round so far, and the polygon through them.
  void add_rounds(View& view) const {
    for (Index round = 1; round <= subject_.degree(); ++round) {
      Control points;
      for (const PointMixed& m : all<PointMixed>()) {
        if (m.round != round || (now<PointMixed>() && &m == last<PointMixed>())) continue;
        points.push_back(m.point);
        const std::string id = fmt::format("d point {:02} {:02}", round, m.i);
        const dvec2 at = drawing_.at(m.point);
        const bool is_outer = m.i == 0 || m.i + m.round == subject_.degree();
        if (kind_ == Kind::halves && last_is_reached() && is_outer) continue;
        if (subject_.degree() > most_names)
          view.add({id, Role::past, Dot{at}});
        else
          view.add_named(id, Role::past, at, name_of(m.round, m.i));
      }
      if (points.size() > 1)
        view.add({fmt::format("c round {:02}", round), Role::past, drawing_.path(points)});
    }
  }
  /// The edge in two parts, t and 1 - t of it. The last one is the tangent.
  void add_mixed(View& view, const PointMixed& m) const {
    const dvec2 a = drawing_.at(m.a), c = drawing_.at(m.c), p = drawing_.at(m.point);
    const bool in_parts = kind_ != Kind::halves;
    if (m.round == subject_.degree() && kind_ == Kind::point && a != c) {
      const dvec2 way = tangent_reach / length_between(a, c) * (c - a);
      view.add({"d tangent", Role::current, Stroke{p - way, p + way, false, true}});
    }
    view.add({"e edge", Role::current, Stroke{in_parts ? p : a, c}});
    if (in_parts) view.add({"e share", Role::measure, Stroke{a, p, true}});
    if (in_parts && subject_.degree() > most_names && m.round > 1) {
      view.add({"f name 0", Role::current, Label{a, name_of(m.round - 1, m.i)}});
      view.add({"f name 1", Role::current, Label{c, second_of(m)}});
    }
    view.add_named("g point", in_parts ? Role::result : Role::current, p, name_of(m.round, m.i));
  }
  /// The outer points so far: the control points of both parts.
  void add_outer(View& view) const {
    Control first{subject_.control.front()}, rest{subject_.control.back()};
    for (const PointMixed& m : all<PointMixed>()) {
      if (m.i == 0) first.push_back(m.point);
      if (m.i + m.round == subject_.degree()) rest.push_back(m.point);
    }
    if (first.size() > 1) view.add({"d outer first", Role::result, drawing_.path(first, true)});
    if (rest.size() > 1) view.add({"d outer rest", Role::accepted, drawing_.path(rest, true)});
  }
  void add_halves(View& view) const {
    const auto [first, rest] = split<2, double>(subject_.control, subject_.t);
    drawing_.add_hull(view, "b first inside", Role::result, first);
    drawing_.add_hull(view, "b rest inside", Role::accepted, rest);
    drawing_.add_curve(view, "d first", Role::result, 0, subject_.t);
    drawing_.add_curve(view, "d rest", Role::accepted, subject_.t, 1);
    const Index n = subject_.degree();
    for (Index k = 1; k < n; ++k) {
      const dvec2 of_first = drawing_.at(first[k]), of_rest = drawing_.at(rest[k]);
      view.add_named(fmt::format("e first {:02}", k), Role::result, of_first, name_of(k, 0));
      view.add_named(fmt::format("e rest {:02}", k), Role::accepted, of_rest, name_of(n - k, k));
    }
    view.add_named("g point", Role::result, drawing_.at(rest.front()), last_name());
  }
  /// "P0 Q0 R0 S0", "S0 R1 Q2 P3": the control points of both parts.
  std::pair<std::string, std::string> names_of_parts() const {
    const Index n = subject_.degree();
    std::string first = name_of(0, 0), rest = name_of(n, 0);
    for (Index k = 1; k <= n && n <= most_names; ++k) {
      first += "\u00a0" + name_of(k, 0);
      rest += "\u00a0" + name_of(n - k, k);
    }
    if (n > most_names) first += " … " + name_of(n, 0), rest += " … " + name_of(0, n);
    return {first, rest};
  }

  static constexpr double tangent_reach = 9;

  const Words& words_;
  const Subject& subject_;
  const CurveDrawing& drawing_;
  const Kind kind_;
  dvec2 lost_{};
  std::optional<RoundingsDrawing> roundings_;
  const Slider slider_{subject_.t, kind_ == Kind::halves ? Role::input : Role::measure};
};

void set_up(Narrator& narrator, const Subject& subject, const CurveDrawing& drawing) {
  require_scale(drawing.panel(), narrator.arguments(), {"control"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"points", subject.control.size()}, {"degree", subject.degree()}});
  narrator.handles("control", shown_in(drawing.panel()));
}

/// A point is told as ever; what it has lost is in its sentence.
auto with_losses(RoundsStory& story, const auto& watch) {
  return [&story, &watch]<class Step>(const Step& step, int line = __builtin_LINE(),
                                      const char* file = __builtin_FILE()) {
    if constexpr (std::same_as<Step, Kept<2>>) {
      story.keep(step.lost);
      watch(step.mixed, line, file);
    } else {
      watch(step, line, file);
    }
  };
}

template <RoundsStory::Kind kind>
void tell_rounds(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  constexpr bool halves = kind == RoundsStory::Kind::halves,
                 compensates = kind == RoundsStory::Kind::compensated;
  const CurveDrawing drawing(subject, compensates ? beside_plot : above_slider);
  set_up(narrator, subject, drawing);
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, halves        ? "curve_or_rest"
                                    : compensates ? "curve_or_compensated"
                                                  : "curve"},
                   {Role::past, "rounds"},
                   {Role::rejected, "plain"},
                   {Role::measure, "share"},
                   {Role::current, "edge"},
                   {Role::result, halves ? "first" : "point"}});
  RoundsStory story(narrator.words(), subject, drawing, kind);
  if (story.by_round()) {
    narrator.columns({{"round"}});
    for (Index i = 0; i <= subject.degree(); ++i)
      narrator.trace().columns.push_back({fmt::format("i{}", i), false});
  } else {
    narrator.columns({{"point", false}, {"between", false}, {"place", false}});
  }
  story.slider().let_drag(narrator);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Polygon<2, double> control(subject.control);
  dvec2 point{};
  if constexpr (kind == RoundsStory::Kind::point)
    point = de_casteljau<2, double>(control, subject.t, watch);
  else if constexpr (kind == RoundsStory::Kind::overwritten)
    point = overwritten<2, double>(control, subject.t, watch);
  else if constexpr (compensates)
    point = compensated<2>(control, subject.t, with_losses(story, watch));
  else
    point = split<2, double>(control, subject.t, watch).rest.front();
  narrator.result({{"x", point.x}, {"y", point.y}});
}

// --- The others

void tell_bernstein(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const CurveDrawing drawing(subject, {{1.5, 3}, {20.5, 25}});
  set_up(narrator, subject, drawing);
  tell_weights(narrator, subject, drawing);
}

void tell_raise_degree(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const CurveDrawing drawing(subject, whole_paper);
  set_up(narrator, subject, drawing);
  tell_raised(narrator, subject, drawing);
}

template <bool by_middle>
void tell_flatten(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const CurveDrawing drawing(subject, whole_paper);
  set_up(narrator, subject, drawing);
  tell_chords(narrator, subject, drawing, by_middle);
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  using Kind = RoundsStory::Kind;
  static const TopicEntry topic = completed<entry>(
      {.name = "bezier_curve",
       .chapter = "modeling",
       .aliases = {"bezier", "de casteljau", "bernstein polynomials", "degree elevation", "flattening"},
       .summary = "a polynomial curve from a few control points: its points, its halves, chords for it",
       .methods = {{.name = "de_casteljau",
                    .standing = Standing::taught,
                    .tell = tell_rounds<Kind::point>,
                    .unread = {"tolerance", "times"}},
                   {.name = "bernstein", .tell = tell_bernstein, .unread = {"tolerance", "times"}},
                   {.name = "split",
                    .tell = tell_rounds<Kind::halves>,
                    .function = "cut_at",
                    .unread = {"tolerance", "times"}},
                   {.name = "raise_degree",
                    .tell = tell_raise_degree,
                    .unread = {"t", "tolerance"},
                    .opening = {{"control", "0,0 2,14 13,16 20,2"}}},
                   {.name = "flatten", .tell = tell_flatten<false>, .unread = {"t", "times"}},
                   {.name = "compensated",
                    .tell = tell_rounds<Kind::compensated>,
                    .file = "compensated.hpp",
                    .unread = {"tolerance", "times"},
                    .opening = {{"control", "0,6 4,-6 8,6 12,-6 16,6 20,-6"}, {"t", "0.45"}}},
                   {.name = "overwritten",
                    .standing = Standing::faulty,
                    .tell = tell_rounds<Kind::overwritten>,
                    .unread = {"tolerance", "times"}},
                   {.name = "middle_only",
                    .standing = Standing::faulty,
                    .tell = tell_flatten<true>,
                    .unread = {"t", "times"}}},
       .parameters = {points(2, 11, "control", "0,0 5,15 15,0 20,15", "0,0 4,8 8,0", "its control points", xy,
                             {1e-6, 1e6}),
                      number("t", "0.4", "1/2", "where on the curve: from 0, its begin, to 1, its end",
                             {1e-6, 1}),
                      number("tolerance", "1.5", "0.1", "how far a chord may be from the curve", {1e-6, 1e6}),
                      integer(1, 6, "times", "1", "4", "how often the degree is raised")},
       .examples = {"--t 1/2", "--method split --control '0,0 4,8 8,0' --t 1/2",
                    "--method flatten --tolerance 0.1",
                    "--method compensated --control '0,6 4,-6 8,6 12,-6 16,6 20,-6' --t 0.49"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::bezier_curve
