// The story of a polygon in a circle: where its edges pass, in which order, and the arcs between.

#include "clipping/polygon_circle/polygon_circle.hpp"
#include "core/geometry.hpp"

#include "clipping/polygon_circle/polygon_circle_notes.hpp"
#include "stories/clipping/polygon_circle/covered_area.hpp"
#include "stories/clipping/polygon_circle/crossing_table.hpp"
#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::polygon_circle {
namespace {

constexpr int width = 37, height = 27;
constexpr dvec2 table_corner{width - 1.5, height - 1};  ///< beside the plane

/// What all steps are drawn from.
struct Subject {
  std::vector<dvec2> polygon;
  Disc circle;
  std::optional<double> tolerance;
  Panel panel;
  Covered right;  ///< the area that is kept
};

/// The polygon and the circle; what lies far from the circle is cut off the picture.
Extent world_of(const std::vector<dvec2>& polygon, const Disc& c) {
  Extent all;
  all.add(c.centre - c.radius);
  all.add(c.centre + c.radius);
  const double far = c.radius > 0 ? 3 * c.radius : 1e300;
  for (const dvec2 p : polygon) all.add(glm::clamp(p, c.centre - far, c.centre + far));
  return widened(all, 0.004);  // for half of a line
}

std::int64_t count(std::size_t n) { return static_cast<std::int64_t>(n); }

/// How an edge runs, as far as it is asked for.
enum class Way : std::uint8_t { outside, inside, enters, leaves, both };

Way way_of(const Tested& t) {
  if (t.enters && t.leaves) return Way::both;
  if (t.enters) return Way::enters;
  if (t.leaves) return Way::leaves;
  return t.run.inside ? Way::inside : Way::outside;
}
Way way_of(const Looked& l) {
  if (l.from_inside) return l.to_inside ? Way::inside : Way::leaves;
  return l.to_inside ? Way::enters : Way::outside;
}

/// The branch that a way is, and how it is told: by the method, by the notes' listing, and what that keeps.
struct WayTexts {
  std::string_view branch, tested, looked, puts;
};
constexpr WayTexts texts_of(Way way) {
  constexpr std::array<WayTexts, 5> all{{{"outside", "tested.outside", "looked.outside", "none"},
                                         {"inside", "tested.inside", "looked.inside", "puts.end"},
                                         {"enters", "tested.enters", "looked.enters", "puts.both"},
                                         {"leaves", "tested.leaves", "looked.leaves", "puts.start"},
                                         {"both", "tested.both", "looked.skipped", "none"}}};
  return all[static_cast<std::size_t>(way)];
}

// --- The steps

class Story {
 public:
  Story(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}

  template <class Step>
  void show(Board& board, const Step& step) {
    draw(step);
    board.milestone(view_);
  }
  void draw(const Oriented& o) { add_input(o.corners); }
  Event say(const Oriented& o) const {
    return {.text = o.corners.empty() ? "started_empty" : "started",
            .facts = {{"corners", count(o.corners.size())}},
            .phase = words_.shared("words", "set_up"),
            .level = Level::idea};
  }

  // The method

  void draw(const Tested& t) {
    follow_edge(t.edge, t.run.edge);
    found_.clear();
    if (t.enters) add_crossing(t.edge, *t.enters, "enters", false);
    if (t.leaves) add_crossing(t.edge, *t.leaves, "leaves", true);
    put_table(found_);
  }
  Event say(const Tested& t) const {
    const Way way = way_of(t);
    const bool crosses = t.enters || t.leaves;
    return {.text = texts_of(way).tested,
            .facts = {{"edge", count(t.edge)},
                      {"inside", t.run.inside},
                      {"from", t.run.from, "side"},
                      {"to", t.run.to, "side"}},
            .words = {{"edge", t.edge + 1},
                      {"at", t.enters ? *t.enters : t.leaves.value_or(dvec2{})},
                      {"enters", t.enters.value_or(dvec2{})},
                      {"leaves", t.leaves.value_or(dvec2{})}},
            .row = {t.edge + 1, side_text(t.run.from), side_text(t.run.to), crossings_text(t),
                    words_.say(!t.run.inside ? "none"
                               : crosses     ? "part"
                                             : "whole")},
            .phase = words_.say("phase.edges"),
            .decides = run_of_edge("question.edge", t.edge, way)};
  }

  void draw(const Sorted& s) {
    calm();
    erase("c ");
    table_.sort(s.crossings);
    sorted_ = true;
    put_table({});
  }
  Event say(const Sorted& s) const {
    const bool any = !s.crossings.empty();
    return {.text = any ? "sorted" : "sorted_none",
            .facts = {{"crossings", count(s.crossings.size())}},
            .phase = words_.say("phase.order"),
            .decides = yes_or_no(words_, "question.any", {}, any, "crosses", "misses")};
  }

  void draw(const Entered& e) {
    calm();
    if (chain_.empty() || chain_.back() != e.at) chain_.push_back(e.at);
    put_table({e.number});
    show_chain(e.at);
  }
  Event say(const Entered& e) const {
    return {.text = "entered",
            .facts = {{"ring", count(e.ring)}, {"crossing", count(e.number)}},
            .words = {{"piece", e.ring + 1}, {"number", table_.name(e.number)}, {"at", e.at}},
            .phase = words_.say("phase.rings")};
  }

  void draw(const Walked& w) {
    chain_.push_back(w.at);
    put_table({});
    show_chain(w.at);
  }
  Event say(const Walked& w) const {
    return {.text = "walked",
            .facts = {{"ring", count(w.ring)}, {"corner", count(w.corner)}},
            .words = {{"corner", w.corner + 1}, {"at", w.at}},
            .phase = words_.say("phase.rings"),
            .decides = yes_or_no(words_, "question.walk", {}, true, "inside")};
  }

  void draw(const Bent& b) {
    chain_.push_back(b.from);
    if (is_arc(b)) add_arc(b);
    put_table({b.exit, b.entry});
    show_chain(b.to);
  }
  Event say(const Bent& b) const {
    return {.text = is_arc(b) ? "bent.arc" : "bent.corner",
            .facts = {{"ring", count(b.ring)},
                      {"exit", count(b.exit), "crossing"},
                      {"entry", count(b.entry), "crossing"},
                      {"more_than_half", b.more_than_half}},
            .words = {{"exit", table_.name(b.exit)},
                      {"from", b.from},
                      {"entry", table_.name(b.entry)},
                      {"at", b.from}},
            .phase = words_.say("phase.rings"),
            .decides = yes_or_no(words_, "question.walk", {}, false, "", "leaves")};
  }

  void draw(const Closed& c) {
    erase("e ");
    put_table({});
    const std::string id = fmt::format("d piece {:03}", c.ring);
    view_.add({id, Role::accepted, Area{{subject_.panel.at(chain_)}}});
    view_.add({id + " line", Role::accepted, Path{subject_.panel.at(chain_), true}});
    chain_.clear();
  }
  Event say(const Closed& c) const {
    return {.text = "closed",
            .facts = {{"ring", count(c.ring)}, {"corners", count(c.corners)}},
            .words = {{"piece", c.ring + 1}},
            .phase = words_.say("phase.rings")};
  }

  void draw(const Finished<double>& f) {
    clear_result();
    add_rings(f.region);
    if (subject_.tolerance && !f.region.rings.empty()) add_flat(f.region);
  }
  Event say(const Finished<double>& f) const {
    const std::int64_t pieces = count(f.region.rings.size());
    const Covered covered = area_of(f.region);
    Event event{.text = "nothing",
                .facts = {{"pieces", pieces}, {"area", covered.field()}},
                .words = {{"area", covered.text()}}};
    if (pieces == 0) return event;
    event.text = subject_.tolerance ? "done_flat" : "done";
    event.count = pieces;
    if (subject_.tolerance) {
      event.words.insert(
          event.words.end(),
          {{"corners", flat_corners_}, {"tolerance", *subject_.tolerance}, {"flat", flat_area_.text()}});
    }
    return event;
  }

  // The listing of the notes

  void draw(const Looked& l) {
    follow_edge(l.edge, {l.from, l.to});
    leaves_ = way_of(l) == Way::leaves;
  }
  Event say(const Looked& l) const {
    const Way way = way_of(l);
    // The listing takes an edge that passes in and out for one outside
    const bool skipped = way == Way::outside && run_of({l.from, l.to}, subject_.circle).inside;
    const auto side = [&](bool inside) { return words_.say(inside ? "inside" : "outside"); };
    return {.text = texts_of(skipped ? Way::both : way).looked,
            .facts = {{"edge", count(l.edge)},
                      {"from_inside", l.from_inside, "inside"},
                      {"to_inside", l.to_inside, "inside"}},
            .words = {{"edge", l.edge + 1}},
            .row = {l.edge + 1, side(l.from_inside), side(l.to_inside), words_.say(texts_of(way).puts)},
            .phase = words_.say("phase.edges"),
            .decides = run_of_edge("question.looked", l.edge, way)};
  }

  void draw(const Kept& k) {
    chain_.push_back(k.at);
    show_chain(k.at);
  }
  Event say(const Kept& k) const {
    return {.text = !k.cut    ? "kept.corner"
                    : leaves_ ? "kept.start"
                              : "kept.entry",
            .facts = {{"x", k.at.x}, {"y", k.at.y}, {"cut", k.cut}},
            .words = {{"at", k.at}},
            .phase = words_.say("phase.edges")};
  }

  void draw(const Joined<double>& j) {
    clear_result();
    add_right();  // behind what comes out
    const std::vector<dvec2> ring = subject_.panel.at(j.corners);
    if (ring.size() > 2) view_.add({"h area", Role::result, Area{{ring}}});
    if (ring.size() > 1) view_.add({"h line", Role::result, Path{ring, true}});
    for (std::size_t i = 0; i < ring.size(); ++i) {
      view_.add({fmt::format("h point {:03}", i), Role::result, Dot{ring[i]}});
    }
  }
  Event say(const Joined<double>& j) const {
    const Covered area = area_of({j.corners}, subject_.circle);
    return {.text = "joined",
            .facts = {{"corners", count(j.corners.size())}, {"area", area.field()}},
            .words = {{"area", area.text()}, {"right", subject_.right.text()}},
            .phase = words_.shared("words", "result"),
            .level = Level::idea};
  }

 private:
  std::string side_text(int side) const {
    return words_.say(side < 0 ? "inside" : side > 0 ? "outside" : "on");
  }
  /// "C in", "C in, D out": those that the edge has found.
  std::string crossings_text(const Tested& t) const {
    const auto text = [&](std::size_t i, const char* key) {
      return words_.say(key, {{"number", table_.name(found_[i])}});
    };
    if (t.enters && t.leaves)
      return words_.say("twice", {{"first", text(0, "enters")}, {"second", text(1, "leaves")}});
    return t.enters ? text(0, "enters") : t.leaves ? text(0, "leaves") : words_.say("none");
  }

  Decision run_of_edge(std::string_view question, std::size_t edge, Way way) const {
    Decision decision{words_.say(question, {{"edge", edge + 1}}), {}, static_cast<std::size_t>(way)};
    for (const Way each : {Way::outside, Way::inside, Way::enters, Way::leaves, Way::both})
      decision.answers.push_back(words_.say(fmt::format("question.edge.{}", texts_of(each).branch)));
    decision.branch = texts_of(way).branch;
    return decision;
  }

  // --- Drawing

  void erase(std::string_view start) {
    std::erase_if(view_.marks, [&](const auto& mark) { return mark.first.starts_with(start); });
  }
  void recolor(std::string_view start, Role role) {
    for (auto& [id, mark] : view_.marks) {
      if (id.starts_with(start)) mark.role = role;
    }
  }

  /// corners: none where the polygon has no area; then it is drawn as it was given.
  void add_input(const std::vector<dvec2>& corners) {
    const Panel& panel = subject_.panel;
    view_.add({"a circle", Role::boundary, Path{panel.at(circle_drawing::whole(subject_.circle)), true}});
    add_axes(view_, panel, "plane", {words_.symbol("x"), words_.symbol("y")});
    const std::vector<dvec2>& drawn = corners.empty() ? subject_.polygon : corners;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const dvec2 a = drawn[i], b = drawn[(i + 1) % drawn.size()];
      circle_drawing::add_stroke(view_, panel, fmt::format("b edge {:03}", i), Role::input, a, b);
      if (drawn.size() > 16 || corners.empty()) continue;
      const auto part = circle_drawing::shown_part(panel, a, b);
      if (!part) continue;
      view_.add({fmt::format("c edge {:03}", i), Role::input,
                 Text{beside(panel.at(part->first), panel.at(part->second)), fmt::format("{}", i + 1)}});
    }
  }

  /// A place for an edge's number: outside the polygon, near the edge's middle and off the circle.
  dvec2 beside(dvec2 from, dvec2 to) const {
    const dvec2 along = from == to ? dvec2{1, 0} : glm::normalize(to - from),
                centre = subject_.panel.at(subject_.circle.centre);
    const double radius = subject_.circle.radius * subject_.panel.scale().x;
    dvec2 best = (from + to) * 0.5;
    double most = -1;
    for (const double t : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9}) {
      const dvec2 at = from + t * (to - from) + 1.1 * dvec2{along.y, -along.x};
      const double off = std::min(1.5, std::abs(glm::length(at - centre) - radius));
      if (off > most) {
        most = off;
        best = at;
      }
    }
    return best;
  }

  void follow_edge(std::size_t i, const Segment<2, double>& edge) {
    calm();
    circle_drawing::add_stroke(view_, subject_.panel, "e edge", Role::current, edge.a, edge.b, true);
    recolor(fmt::format("c edge {:03}", i), Role::current);
  }
  /// What the last step pointed at stays, less loud.
  void calm() {
    erase("e edge");
    erase("e now");
    recolor("c edge", Role::input);
  }
  /// A dot where the boundary enters, a ring where it leaves.
  void add_crossing(std::size_t edge, dvec2 at, std::string_view key, bool leaves) {
    const std::string name = table_.add(edge, at, leaves, subject_.circle);
    found_.push_back(table_.size() - 1);
    circle_drawing::add_point(view_, subject_.panel, "g " + name, leaves ? Role::past : Role::candidate, at,
                              words_.say(key, {{"number", name}}), leaves);
  }
  void put_table(const std::vector<std::size_t>& marked) {
    erase("q ");
    table_.add_to(view_, "q", words_, sorted_ ? "table.sorted" : "table.found", table_corner, marked);
  }
  static bool is_arc(const Bent& b) { return b.from != b.to || b.more_than_half; }
  void add_arc(const Bent& b) {
    const Unit unit = unit_of(subject_.circle.radius);
    const dvec2 from = seen_from(subject_.circle.centre, b.from, unit) / unit.radius;
    const dvec2 to = seen_from(subject_.circle.centre, b.to, unit) / unit.radius;
    const std::vector<dvec2> points =
        circle_drawing::arc(subject_.circle, atan2(from.y, from.x), sweep(from, to, b.more_than_half));
    chain_.insert(chain_.end(), points.begin() + 1, points.end());
    chain_.back() = b.to;
    view_.add({"e now", Role::current, Path{subject_.panel.at(points)}});
  }
  void show_chain(dvec2 here) {
    if (chain_.size() > 1) view_.add({"e chain", Role::accepted, Path{subject_.panel.at(chain_)}});
    view_.add({"e here", Role::accepted, Dot{subject_.panel.at(here)}});
  }
  void clear_result() {
    calm();
    for (const std::string_view start : {"d ", "e ", "g ", "c "}) erase(start);
    put_table({});
  }
  void add_rings(const Region<double>& region) {
    for (std::size_t i = 0; i < region.rings.size(); ++i) {
      const std::vector<dvec2> points = subject_.panel.at(chain_of(region.rings[i], subject_.circle));
      const std::string id = fmt::format("h piece {:03}", i);
      view_.add({id, Role::result, Area{{points}}});
      view_.add({id + " line", Role::result, Path{points, true}});
    }
  }
  /// Chords for the arcs, and corners as far as they can be told apart.
  void add_flat(const Region<double>& region) {
    const auto flat = flatten(region, *subject_.tolerance);
    for (const auto& polygon : flat) {
      flat_corners_ += polygon.size();
      const std::string id = fmt::format("i flat {}", flat_corners_);
      view_.add({id, Role::measure, Path{subject_.panel.at(polygon), true}});
      if (flat_corners_ > 200) continue;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        view_.add({fmt::format("{} {:03}", id, k), Role::measure, Dot{subject_.panel.at(polygon[k])}});
      }
    }
    flat_area_ = area_of(flat, subject_.circle);
  }
  void add_right() {
    const Region<double> right = arcs(subject_.polygon, subject_.circle);
    for (std::size_t i = 0; i < right.rings.size(); ++i) {
      view_.add({fmt::format("f right {:03}", i), Role::measure,
                 Path{subject_.panel.at(chain_of(right.rings[i], subject_.circle)), true, true}});
    }
  }

  const Words& words_;
  const Subject& subject_;
  View view_;
  std::vector<dvec2> chain_;  ///< the piece so far
  CrossingTable table_;
  std::vector<std::size_t> found_;  ///< rows of the table, by the edge that is tested
  std::size_t flat_corners_ = 0;
  Covered flat_area_;
  bool sorted_ = false;
  bool leaves_ = false;  ///< the edge that the listing looks at
};

// --- The methods

Subject subject_of(const Arguments& arguments) {
  const std::vector<dvec2> polygon = arguments.points("polygon");
  const Disc circle = circle_drawing::circle_in(arguments);
  const std::optional<double> tolerance = arguments.number("tolerance");
  for (const dvec2 p : polygon) circle_drawing::expect_coordinates("polygon", {p});
  if (tolerance && !(*tolerance >= circle.radius * 1e-6 && *tolerance > 0)) {
    refuse("tolerance", "at least a millionth of the radius expected: a figure shows no more");
  }
  if (const auto meeting = meeting_edges(polygon)) {
    refuse("polygon", "a simple polygon expected, but its edges {} and {} meet", meeting->first + 1,
           meeting->second + 1);
  }
  // Beside the plane there is room for the crossings, if there are any
  const bool crossed = arguments.text("method") == "arcs" && any_crossing(polygon, circle);
  const double table = crossed ? CrossingTable::width : 0;
  const Panel panel =
      tight_panel({{2.7, 2.7}, {width - 2.5 - table, height - 1.3}}, world_of(polygon, circle));
  const Subject subject{polygon, circle, tolerance, panel, area_of(arcs(std::span(polygon), circle))};
  require_scale(panel, arguments, {"circle"});
  return subject;
}

void set_up(Narrator& narrator, const Subject& subject) {
  narrator.paper(width, height);
  narrator.subtitle("subtitle", {{"corners", subject.polygon.size()},
                                 {"centre", subject.circle.centre},
                                 {"radius", subject.circle.radius}});
  narrator.legend({Role::boundary, Role::input, Role::current, Role::candidate, Role::past, Role::accepted,
                   Role::result});
  narrator.key_by_type();
  circle_drawing::let_drag(narrator, "polygon", subject.circle, subject.panel, false);
}

void tell_arcs(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject);
  if (subject.tolerance) narrator.add_to_legend(Role::measure, "chords");
  // Where nothing crosses there is no table
  if (any_crossing(subject.polygon, subject.circle)) narrator.trace().grid.lines = CrossingTable::least_unit;
  Story story(narrator.words(), subject);
  const auto region = arcs(std::span(subject.polygon), subject.circle, narrator.watcher(story));
  // The first arc
  const auto& steps = narrator.trace().steps;
  const auto bent = std::ranges::find(steps, "Bent", &TraceStep::type);
  if (bent != steps.end()) narrator.telling(bent->number);
  narrator.result({{"area", subject.right.field()}, {"pieces", count(region.rings.size())}});
}

void tell_first_crossing(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject);
  narrator.add_to_legend(Role::measure, "right");
  narrator.columns({{"edge"}, {"from", false}, {"to", false}, {"kept", false}});
  Story story(narrator.words(), subject);
  first_crossing(std::span(subject.polygon), subject.circle, narrator.watcher(story));
  narrator.result({{"area", subject.right.field()}});
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "polygon_circle",
       .chapter = "clipping",
       .aliases = {"polygon in circle", "arcs"},
       .summary = "the part of a polygon that lies in a circle, with true arcs",
       .methods = {{.name = "arcs", .standing = Standing::taught, .tell = tell_arcs},
                   {.name = "first_crossing", .standing = Standing::faulty, .tell = tell_first_crossing}},
       .columns = {{"edge"}, {"from", false}, {"to", false}, {"crossings", false}, {"kept", false}},
       .parameters = {points(3, 1000, "polygon", "-7,-2 7,-3 2,0 6,6 -2,2 -3,7", "0,0 8,0 8,8 0,8",
                             "the polygon's corners; simple, convex or not, in either direction", xy),
                      numbers("circle", "0,0,5", "0,0,5", "the circle: centre and radius", {"cx", "cy", "r"}),
                      number("tolerance", "", "0.1",
                             "show chords for the arcs too, nowhere farther from them than this")},
       .examples = {"--polygon '-7,-2 7,-3 2,0 6,6 -2,2 -3,7' --circle 0,0,5",
                    "--polygon '-4,-4 4,-4 4,4 -4,4' --circle 0,0,5 --tolerance 0.2",
                    "--polygon '0,0 8,0 8,8 0,8' --circle 0,0,5 --method first_crossing"}});
  return topic;
}

}  // namespace gradus::polygon_circle
