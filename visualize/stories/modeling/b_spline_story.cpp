// The story of B-splines: de Boor's triangle of points with the knots it uses, the weights behind it, knots
// inserted, and a circle of weighted points.

#include "modeling/b_spline/b_spline.hpp"

#include <fmt/ranges.h>

#include "modeling/b_spline/b_spline_notes.hpp"
#include "stories/modeling/b_spline/basis_story.hpp"
#include "stories/modeling/b_spline/checking.hpp"
#include "stories/modeling/b_spline/drawing.hpp"
#include "stories/modeling/b_spline/insert_story.hpp"
#include "stories/modeling/b_spline/triangle_story.hpp"
#include "stories/parameters.hpp"

namespace gradus::b_spline {
namespace {

constexpr Extent above_knots{{1.4, 7}, {34.8, 26}}, above_weights{{3, 16.6}, {33, 26}};

// --- What is asked for

/// From 0 to 3 in equal spans, both ends degree + 1 times.
Knots even_knots(Index points, Index degree) {
  Knots knots(degree, 0);
  const Index spans = points - degree;
  for (Index k = 0; k <= spans; ++k) knots.push_back(3 * static_cast<double>(k) / static_cast<double>(spans));
  knots.insert(knots.end(), degree, 3);
  return knots;
}

/// What is wrong with knots; nothing where they are right.
std::string wrong_with(const Knots& u, Index points, Index degree) {
  if (u.size() != points + degree + 1)
    return fmt::format("expected {} knots for {} control points of degree {}, found {}", points + degree + 1,
                       points, degree, u.size());
  for (Index i = 1; i < u.size(); ++i) {
    if (u[i] < u[i - 1])
      return fmt::format("expected knots in order, found {:g} behind {:g}", u[i], u[i - 1]);
    if (i > degree && u[i] == u[i - degree - 1])
      return fmt::format("expected a knot at most {} times, found {:g} more often", degree + 1, u[i]);
  }
  if (!(u[degree] < u[points]))
    return fmt::format("expected knots with a span for degree {}, found none", degree);
  if (!can_be_told_apart(u.front(), u.back()))
    return fmt::format("expected knots that a scale can show, found {:g} to {:g}", u.front(), u.back());
  return {};
}

/// The number of t, where there is a point of the curve.
double where(const Arguments& arguments, const Subject& subject) {
  const double t = arguments.number("t").value_or(0);
  const Spline<2, double> spline = subject.spline();
  if (!(spline.begin() <= t && t <= spline.end()))
    refuse(arguments, {"t", "knots"},
           fmt::format("expected t from {:g} to {:g}, found {:g}", spline.begin(), spline.end(), t));
  return t;
}

Subject spline_of(const Arguments& arguments) {
  Subject subject{arguments.points("control"), {}};
  const Index points = subject.control.size(), degree = static_cast<Index>(arguments.integer("degree"));
  if (points <= degree)
    refuse(arguments, {"control", "degree"},
           fmt::format("expected at least {} control points for degree {}, found {}", degree + 1, degree,
                       points));
  for (const Tuple& knot : arguments.tuples("knots")) subject.knots.push_back(knot[0].value);
  if (subject.knots.empty()) subject.knots = even_knots(points, degree);
  if (const std::string wrong = wrong_with(subject.knots, points, degree); !wrong.empty())
    refuse(arguments, {"knots", "control", "degree"}, wrong);
  subject.t = where(arguments, subject);
  return subject;
}

/// A polygon round the unit circle, and the points at which its sides touch that. Each arc goes from a whole
/// number to the next.
Subject circle_of(const Arguments& arguments) {
  const auto arcs = static_cast<Index>(arguments.integer("arcs"));
  const double half = 180 / static_cast<double>(arcs), corner = sin_cos_degrees(half).cos;
  Subject subject;
  for (Index i = 0; i <= 2 * arcs; ++i) {
    const SinCos turn = sin_cos_degrees(half * static_cast<double>(i));
    const double size = i % 2 == 0 ? 1 : corner;
    subject.control.push_back(dvec2{turn.cos, turn.sin} / size);
    subject.weights.push_back(i % 2 == 0 ? 1 : arguments.number("weight").value_or(corner));
  }
  subject.knots = {0, 0};
  for (Index k = 0; k <= arcs; ++k)
    for (int often = k == 0 || k == arcs ? 1 : 2; often > 0; --often)
      subject.knots.push_back(static_cast<double>(k));
  subject.knots.insert(subject.knots.end(), 2, static_cast<double>(arcs));
  subject.t = where(arguments, subject);
  if (const double w = subject.weights[1]; !(1.0 / most_weight <= w && w <= most_weight))
    refuse("weight", "expected a weight above 0, from 1/{} to {}, found {:g}", most_weight, most_weight, w);
  return subject;
}

void set_up(Narrator& narrator, const Subject& subject, const SplineDrawing& drawing) {
  require_scale(drawing.panel(), narrator.arguments(), {"control"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"points", subject.control.size()}, {"degree", subject.degree()}});
}

/// Knots that were not given follow from the other arguments; the trace has them all the same, so that a page
/// can let them be dragged.
void set_up_knots(Narrator& narrator, const Subject& subject) {
  std::vector<Argument>& arguments = narrator.trace().arguments;
  if (std::ranges::find(arguments, "knots", &Argument::name) == arguments.end())
    arguments.push_back({"knots", fmt::format("{}", fmt::join(subject.knots, " "))});
}

// --- A point

template <Kind kind>
void tell_triangle(Narrator& narrator) {
  const Subject subject = spline_of(narrator.arguments());
  const SplineDrawing drawing(subject, above_knots);
  set_up(narrator, subject, drawing);
  set_up_knots(narrator, subject);
  drawing.let_drag(narrator);
  narrator.columns({{"point", false}, {"knots", false}, {"share"}, {"place", false}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, "curve"},
                   {Role::boundary, "knots"},
                   {Role::past, "rounds"},
                   {Role::measure, "share"},
                   {Role::current, "edge"},
                   {Role::result, "point"}});
  TriangleStory<2> story(narrator.words(), subject, drawing, kind);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  dvec2 point{};
  if constexpr (kind == Kind::point)
    point = de_boor(subject.spline(), subject.t, watch);
  else
    point = own_span_only(subject.spline(), subject.t, watch);
  narrator.result({{"x", point.x}, {"y", point.y}});
}

template <Kind kind>
void tell_circle(Narrator& narrator) {
  Subject subject = circle_of(narrator.arguments());
  const std::vector<double> weights = subject.weights;
  if (kind == Kind::unweighted) subject.weights.assign(weights.size(), 1);
  const SplineDrawing drawing(subject, above_knots);
  set_up(narrator, subject, drawing);
  narrator.handle("t", 0, drawing.place_of_t(), drawing.along());
  if (kind == Kind::circle) narrator.list_below("nurbs");
  narrator.columns({{"point", false}, {"knots", false}, {"share"}, {"weighted", false}});
  narrator.legend({{Role::input, "weighted"},
                   {Role::candidate, "circle"},
                   {Role::accepted, "curve"},
                   {Role::boundary, "knots"},
                   {Role::past, "rounds"},
                   {Role::measure, "share_or_radius"},
                   {Role::current, "edge"},
                   {Role::result, "point"}});
  TriangleStory<3> story(narrator.words(), subject, drawing, kind);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  dvec2 point{};
  if constexpr (kind == Kind::circle)
    point = nurbs<2, double>(subject.spline(), weights, subject.t, watch);
  else
    point = unweighted<2, double>(subject.spline(), weights, subject.t, watch);
  narrator.result({{"x", point.x}, {"y", point.y}});
}

template <bool faulty>
void tell_basis(Narrator& narrator) {
  Subject subject = spline_of(narrator.arguments());
  const SplineDrawing drawing(subject, above_weights);
  set_up(narrator, subject, drawing);
  set_up_knots(narrator, subject);
  narrator.columns({{"degree"}, {"functions", false}, {"weights", false}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, "curve"},
                   {Role::boundary, "knots"},
                   {Role::guide, "zero"},
                   {Role::past, "counts"},
                   {Role::current, "weighing"},
                   {Role::measure, "here"},
                   {Role::result, "mean"}});
  BasisStory story(narrator.words(), subject, drawing, faulty);
  story.let_drag(narrator);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const dvec2 point =
      faulty ? half_open(subject.spline(), subject.t, watch) : basis(subject.spline(), subject.t, watch);
  narrator.result({{"x", point.x}, {"y", point.y}});
}

// --- More knots

template <bool all_knots>
void tell_insert(Narrator& narrator) {
  const Subject subject = spline_of(narrator.arguments());
  const SplineDrawing drawing(subject, above_knots);
  const auto often = times(subject.knots, subject.t);
  if (!all_knots && often > subject.degree())
    refuse(narrator.arguments(), {"t", "knots"},
           fmt::format("expected a knot that is there at most {} times, found {:g} {} times",
                       subject.degree(), subject.t, often));
  set_up(narrator, subject, drawing);
  set_up_knots(narrator, subject);
  drawing.let_drag(narrator);
  narrator.columns({{"point", false}, {"knots", false}, {"share"}, {"place", false}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::accepted, all_knots ? "curve_or_piece" : "curve"},
                   {Role::boundary, "knots"},
                   {Role::measure, "share"},
                   {Role::current, "edge"},
                   {Role::result, all_knots ? "points_or_piece" : "points"}});
  if (all_knots) narrator.list_below("bezier_pieces");
  InsertStory story(narrator.words(), subject, drawing, all_knots);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  Index points = 0;
  if constexpr (all_knots)
    points = bezier_pieces(subject.spline(), watch).size() * subject.degree() + 1;
  else
    points = insert_knot(subject.spline(), subject.t, watch).control.size();
  narrator.result({{"points", static_cast<std::int64_t>(points)}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Names of_circle{"arcs", "weight"}, of_spline{"control", "degree", "knots"};
  static const TopicEntry topic = completed<entry>(
      {.name = "b_spline",
       .chapter = "modeling",
       .aliases = {"b-spline", "de boor", "nurbs", "knot insertion", "boehm", "cox-de boor"},
       .summary =
           "a curve in pieces from control points and knots: its points, its weights, more knots, a circle",
       .methods =
           {{.name = "de_boor",
             .standing = Standing::taught,
             .tell = tell_triangle<Kind::point>,
             .unread = of_circle},
            {.name = "basis", .tell = tell_basis<false>, .unread = of_circle},
            {.name = "insert_knot", .tell = tell_insert<false>, .function = "with_knot", .unread = of_circle},
            {.name = "bezier_pieces",
             .tell = tell_insert<true>,
             .function = "with_knot",
             .unread = {"t", "arcs", "weight"}},
            {.name = "nurbs_circle",
             .tell = tell_circle<Kind::circle>,
             .function = "de_boor",
             .unread = of_spline},
            {.name = "own_span_only",
             .standing = Standing::faulty,
             .tell = tell_triangle<Kind::own_span_only>,
             .unread = of_circle},
            {.name = "half_open",
             .standing = Standing::faulty,
             .tell = tell_basis<true>,
             .unread = {"arcs", "weight"},
             .opening = {{"t", "3"}}},
            {.name = "unweighted",
             .standing = Standing::faulty,
             .tell = tell_circle<Kind::unweighted>,
             .unread = of_spline}},
       .parameters = {points(2, 12, "control", "10,7 20,4 30,12 0,17 0,3 30,0", "0,0 4,8 8,8 12,0 16,8",
                             "its control points", xy, {1e-6, 1e6}),
                      integer(1, 5, "degree", "3", "2", "of its pieces"),
                      points(4, 18, "knots", "", "0 0 0 0 1 2 3 3 3 3",
                             "degree + 1 more than control points, in order; not given: evenly from 0 to 3",
                             {"u"}, {1e-6, 1e6}),
                      number("t", "2.4", "2", "where on the curve, as its knots count", {1e-6, 1e6}),
                      integer(3, 6, "arcs", "4", "3", "of how many a circle is made"),
                      number("weight", "", "1",
                             "of a circle's corners; not given: the one that makes it a circle")},
       .examples = {"--t 2", "--method basis --degree 2", "--method nurbs_circle --arcs 3"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::b_spline
