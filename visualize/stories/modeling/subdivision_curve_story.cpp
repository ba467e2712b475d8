// The story of corner cutting: which part of each edge stays, round by round, and the curve that all rounds
// have.

#include "modeling/subdivision_curve/subdivision_curve.hpp"

#include "stories/parameters.hpp"
#include "stories/past.hpp"
#include "stories/telling.hpp"

namespace gradus::subdivision_curve {
namespace {

constexpr int paper_width = 36, paper_height = 27;
constexpr Extent place{{2, 1.5}, {34, 25.5}};

using Polygon = Points<double>;

/// What a run is about.
struct Subject {
  Polygon polygon;
  int rounds;
  Ends ends;

  bool closed() const { return ends == Ends::closed; }
};

Subject subject_of(const Arguments& arguments) {
  return {arguments.points("polygon"), static_cast<int>(arguments.integer("rounds")),
          arguments.flag("closed") ? Ends::closed : Ends::open};
}

/// What both stories draw: the polygon that was given, and the curve that its rounds tend to.
class CurveDrawing {
 public:
  explicit CurveDrawing(const Subject& subject) : subject_(subject), panel_(place, {}) {
    Extent extent;
    for (const dvec2 p : subject.polygon) extent.add(p);
    panel_ = Panel(place, extent);
    limit<double>(subject.polygon, subject.ends, [&](const Parabola<double>& arc) { arcs_.push_back(arc); });
  }

  const Panel& panel() const { return panel_; }
  dvec2 at(dvec2 p) const { return panel_.at(p); }
  Path path(const Polygon& points, bool closed, bool dashed = false) const {
    return {panel_.at(points), closed, dashed};
  }

  void add_polygon(View& view) const {
    view.add({"a polygon", Role::input, path(subject_.polygon, subject_.closed())});
    for (std::size_t i = 0; i < subject_.polygon.size(); ++i)
      view.add_named(fmt::format("a corner {:02}", i), Role::input, at(subject_.polygon[i]), name(i), true);
  }
  /// The first so many arcs of the limit.
  void add_limit(View& view, Role role, std::size_t count) const {
    for (std::size_t i = 0; i < std::min(count, arcs_.size()); ++i) {
      Polygon points;
      for (int k = 0; k <= pieces; ++k) points.push_back(arcs_[i].at(static_cast<double>(k) / pieces));
      view.add({fmt::format("g arc {:02}", i), role, Path{panel_.at(points), false, role == Role::measure}});
    }
  }
  std::size_t arcs() const { return arcs_.size(); }
  static std::string name(std::size_t corner) { return fmt::format("P{}", corner); }

 private:
  static constexpr int pieces = 16;

  const Subject& subject_;
  Panel panel_;
  std::vector<Parabola<double>> arcs_{};
};

// --- Cutting corners

class CutStory : public Past<steps::Started, EdgeCut<double>, RoundDone, Finished> {
 public:
  CutStory(const Words& words, const Subject& subject, const CurveDrawing& drawing)
      : words_(words), subject_(subject), drawing_(drawing) {}

  Event say(const steps::Started&) const {
    return {.text = subject_.closed() ? "started.closed" : "started.open",
            .words = {{"rounds", subject_.rounds}, {"corners", subject_.polygon.size()}}};
  }
  Event say(const EdgeCut<double>& e) const {
    return {.text = "edge_cut",
            .facts = {{"round", e.round},
                      {"edge", static_cast<std::int64_t>(e.edge)},
                      {"length", 0.5 * length(e)}},
            .words = {{"a", e.whole.a}, {"b", e.whole.b}, {"q", e.q}, {"r", e.r}},
            .row = {e.round, e.edge + 1, figure_place(e.q), figure_place(e.r)},
            .key = fmt::format("{}.{}", e.round, e.edge + 1),
            .phase = words_.say("phase.round", {{"round", e.round}})};
  }
  Event say(const RoundDone& d) const {
    const double before = off(d.round - 1), now = off(d.round);
    return {.text = before > 0 ? "round_done" : "round_done.straight",
            .facts = {{"round", d.round}, {"points", d.points}, {"off", now}},
            .words = {{"before", before}},
            .key = fmt::format("{}", d.round),
            .phase = words_.say("phase.round", {{"round", d.round}})};
  }
  Event say(const Finished& f) const {
    return {.text = "finished",
            .facts = {{"points", f.points}},
            .words = {{"corners", subject_.polygon.size()}, {"off", off(subject_.rounds)}}};
  }

  /// The first round cuts the largest corners.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, RoundDone>) return step.round == 1 ? 1 : 0;
    return 0;
  }

  View draw() const {
    View view;
    drawing_.add_polygon(view);
    const int round = static_cast<int>(all<RoundDone>().size());
    const EdgeCut<double>* edge = now<EdgeCut<double>>();
    const RoundDone* done = now<RoundDone>();
    const int shown = done ? round - 1 : round;
    if (shown > 0)
      view.add({"c points", now<Finished>() ? Role::result : Role::past,
                drawing_.path(points_of(shown), subject_.closed())});
    if (now<Finished>()) drawing_.add_limit(view, Role::measure, drawing_.arcs());
    const std::vector<EdgeCut<double>> cuts = cuts_of(edge ? edge->round : done ? done->round : 0);
    add_corners(view, cuts, done != nullptr);
    Polygon so_far;
    for (const EdgeCut<double>& e : cuts) {
      so_far.push_back(e.q);
      so_far.push_back(e.r);
    }
    if (!so_far.empty())
      view.add({"d so far", Role::result, drawing_.path(so_far, done && subject_.closed())});
    for (std::size_t i = 0; done && so_far.size() <= most_dots && i < so_far.size(); ++i)
      view.add({fmt::format("e point {:03}", i), Role::result, Dot{drawing_.at(so_far[i])}});
    if (!edge) return view;
    view.add({"e edge", Role::current,
              Stroke{drawing_.at(edge->whole.a), drawing_.at(edge->whole.b), false, true}});
    view.add_named("f q", Role::current, drawing_.at(edge->q), words_.symbol("Q"));
    view.add_named("f r", Role::current, drawing_.at(edge->r), words_.symbol("R"));
    return view;
  }

 private:
  /// More would hide the curve.
  static constexpr std::size_t most_dots = 32;

  std::vector<EdgeCut<double>> cuts_of(int round) const {
    std::vector<EdgeCut<double>> cuts;
    std::ranges::copy_if(all<EdgeCut<double>>(), std::back_inserter(cuts),
                         [&](const EdgeCut<double>& e) { return e.round == round; });
    return cuts;
  }
  /// What a round has cut off so far; whole: all of it.
  void add_corners(View& view, const std::vector<EdgeCut<double>>& cuts, bool whole) const {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const bool last = i + 1 == cuts.size();
      if (last && !(whole && subject_.closed())) continue;
      const EdgeCut<double>&before = cuts[i], &after = cuts[last ? 0 : i + 1];
      const Polygon corner = drawing_.path({before.r, before.whole.b, after.q}, true).points;
      const std::string id = fmt::format("b corner {:03}", i);
      view.add({id + " inside", Role::rejected, Area{{corner}}});
      view.add({id, Role::rejected, Path{corner, true}});
    }
    if (!whole || subject_.closed() || cuts.empty()) return;
    const auto &first = cuts.front(), &last = cuts.back();
    view.add({"b corner begin", Role::rejected, Stroke{drawing_.at(first.whole.a), drawing_.at(first.q)}});
    view.add({"b corner end", Role::rejected, Stroke{drawing_.at(last.r), drawing_.at(last.whole.b)}});
  }
  static double length(const EdgeCut<double>& e) { return length_between(e.whole.a, e.whole.b); }
  Polygon points_of(int round) const { return chaikin<double>(subject_.polygon, round, subject_.ends); }
  double off(int round) const { return distance_to_limit<double>(points_of(round), subject_.ends); }

  const Words& words_;
  const Subject& subject_;
  const CurveDrawing& drawing_;
};

// --- The limit

class LimitStory : public Past<steps::Started, ArcFound<double>, Finished> {
 public:
  explicit LimitStory(const CurveDrawing& drawing) : drawing_(drawing) {}

  Event say(const steps::Started&) const {
    return {.text = "limit.started", .count = static_cast<std::int64_t>(drawing_.arcs())};
  }
  Event say(const ArcFound<double>& a) const {
    const auto& [from, control, to] = a.arc;
    return {
        .text = "arc_found",
        .facts = {{"corner", static_cast<std::int64_t>(a.corner)}},
        .words = {{"name", CurveDrawing::name(a.corner)}, {"from", from}, {"to", to}, {"top", a.arc.at(0.5)}},
        .row = {CurveDrawing::name(a.corner), figure_place(from), figure_place(control), figure_place(to)},
        .key = CurveDrawing::name(a.corner)};
  }
  Event say(const Finished& f) const { return {.text = "limit.finished", .count = f.points}; }

  View draw() const {
    View view;
    drawing_.add_polygon(view);
    const std::size_t count = all<ArcFound<double>>().size();
    const auto* found = now<ArcFound<double>>();
    drawing_.add_limit(view, Role::result, count);
    if (!found) return view;
    const auto& [from, control, to] = found->arc;
    view.add({"e legs", Role::current, drawing_.path({from, control, to}, false, true)});
    view.add({"f from", Role::current, Dot{drawing_.at(from)}});
    view.add({"f to", Role::current, Dot{drawing_.at(to)}});
    view.add({"f top", Role::measure, Dot{drawing_.at(found->arc.at(0.5))}});
    return view;
  }

 private:
  const CurveDrawing& drawing_;
};

// --- The methods

void set_up(Narrator& narrator, const Subject& subject, const CurveDrawing& drawing) {
  require_scale(drawing.panel(), narrator.arguments(), {"polygon"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle(subject.closed() ? "subtitle.closed" : "subtitle.open",
                    {{"corners", subject.polygon.size()}});
  narrator.handles("polygon", shown_in(drawing.panel()));
}

void tell_chaikin(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const CurveDrawing drawing(subject);
  set_up(narrator, subject, drawing);
  narrator.columns({{"round"}, {"edge"}, {"Q"}, {"R"}});
  narrator.legend({{Role::input, "polygon"},
                   {Role::current, "edge"},
                   {Role::past, "before"},
                   {Role::rejected, "corner"},
                   {Role::result, "cut"},
                   {Role::measure, "limit"}});
  CutStory story(narrator.words(), subject, drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Polygon points = chaikin<double>(subject.polygon, subject.rounds, subject.ends, watch);
  narrator.result({{"points", std::ssize(points)}, {"off", distance_to_limit<double>(points, subject.ends)}});
}

void tell_limit(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const CurveDrawing drawing(subject);
  set_up(narrator, subject, drawing);
  narrator.columns({{"corner", false}, {"from"}, {"control"}, {"to"}});
  narrator.legend(
      {{Role::input, "polygon"}, {Role::current, "legs"}, {Role::measure, "top"}, {Role::result, "arcs"}});
  LimitStory story(drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  limit<double>(subject.polygon, subject.ends, [](const auto&) {}, watch);
  narrator.result({{"arcs", static_cast<std::int64_t>(drawing.arcs())}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "subdivision_curve",
       .chapter = "modeling",
       .aliases = {"chaikin", "corner cutting", "quadratic b-spline"},
       .summary = "a polygon's corners are cut, round after round, until a smooth curve is left",
       .methods = {{.name = "chaikin", .standing = Standing::taught, .tell = tell_chaikin},
                   {.name = "limit", .tell = tell_limit, .unread = {"rounds"}}},
       .parameters = {points(3, 24, "polygon", "1,1 2,7 6,9 11,6 8,1", "0,0 4,0 4,4", "its corners, in order",
                             xy, {1e-6, 1e6}),
                      integer(1, 5, "rounds", "2", "3", "how often all corners are cut"),
                      flag("closed", "an edge leads from the last corner back to the first")},
       .examples = {"--polygon '0,0 4,0 4,4' --rounds 1", "--closed --rounds 3",
                    "--method limit --polygon '0,0 8,0 8,6 2,6'"}});
  return topic;
}

}  // namespace gradus::subdivision_curve
