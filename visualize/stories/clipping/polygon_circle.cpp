// The story of a polygon in a circle: where its edges pass, in which order, and the arcs between.

#include "clipping/polygon_circle/polygon_circle.hpp"

#include <cmath>

#include "clipping/polygon_circle/polygon_circle_notes.hpp"
#include "stories/clipping/circle_drawing.hpp"
#include "stories/paper.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::polygon_circle {
namespace {

using fmt::arg;
using Disc = Circle<double>;

constexpr std::string_view folder = "algorithms/clipping/polygon_circle/";
constexpr int width = 36, height = 27;

/// An area, which may lie beyond doubles: value * 2^exponent.
struct Covered {
  double value = 0;
  int exponent = 0;

  std::string text() const { return circle_drawing::scaled_real(value, exponent); }
  /// A number where that is one, else its text.
  Value field() const {
    const double number = std::ldexp(value, exponent);
    if (value == 0 || std::isnormal(number)) return number;
    return text();
  }
};

/// What all steps are drawn from.
struct Scene {
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
  return widened(all, 0.06);
}

/// The points along a ring, its arcs as chains.
std::vector<dvec2> chain_of(const Ring<double>& ring, const Disc& circle) {
  std::vector<dvec2> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    points.push_back(ring[i].at);
    if (!ring[i].arc) continue;
    const ArcEnds ends = ends_of_arc(ring, i, circle);
    const std::vector<dvec2> arc = circle_drawing::arc(circle, atan2(ends.from.y, ends.from.x), ends.radians);
    points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
  }
  return points;
}

Covered area_of(const Region<double>& region) {
  if (region.rings.empty()) return {};
  const Unit unit = unit_of(region.circle.radius);
  return {area_in(unit, region), 2 * std::ilogb(unit.size)};
}
/// Of polygons whose corners lie in the circle.
Covered area_of(const std::vector<std::vector<dvec2>>& polygons, const Disc& circle) {
  if (circle.radius == 0) return {};
  const Unit unit = unit_of(circle.radius);
  double doubled = 0;
  for (const std::vector<dvec2>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const dvec2 a = seen_from(circle.centre, polygon[i], unit);
      const dvec2 b = seen_from(circle.centre, polygon[(i + 1) % polygon.size()], unit);
      doubled += a.x * b.y - a.y * b.x;
    }
  }
  return {doubled / 2, 2 * std::ilogb(unit.size)};
}

/// Tells the steps of both methods.
class Teller {
 public:
  Teller(TraceWriter& writer, const Scene& scene, bool faulty)
      : writer_(writer), words_(writer.wording()), scene_(scene) {
    writer.trace().columns = {{"edge"}, {"from", false}, {"to", false}};
    if (!faulty) writer.trace().columns.push_back({"crossings", false});
    writer.trace().columns.push_back({"kept", false});
  }

  void operator()(const Oriented& o, int source_line = __builtin_LINE(), const char* = nullptr) {
    corners_ = o.corners;
    base();
    milestone("Oriented", words_.say("words.set_up"), source_line,
              corners_.empty() ? words_.say("polygon_circle.started_empty")
                               : words_.say("polygon_circle.started", arg("corners", corners_.size())),
              {{"corners", count(corners_.size())}}, {});
  }

  void operator()(const Tested& t, int source_line = __builtin_LINE(), const char* = nullptr) {
    follow_edge(t.edge, t.run.edge);
    std::string key = t.run.inside ? "inside" : "outside", crossings = words_.say("polygon_circle.none");
    std::string in, out;
    if (t.enters) {
      in = words_.say("polygon_circle.enters", arg("number", ++crossings_));
      add_point(*t.enters, crossings_, in);
      crossings = in, key = "enters";
    }
    if (t.leaves) {
      out = words_.say("polygon_circle.leaves", arg("number", ++crossings_));
      add_point(*t.leaves, crossings_, out);
      crossings = out, key = t.enters ? "both" : "leaves";
    }
    if (t.enters && t.leaves) {
      crossings = words_.say("polygon_circle.twice", arg("first", in), arg("second", out));
    }
    const dvec2 enters = t.enters.value_or(dvec2{}), leaves = t.leaves.value_or(dvec2{});
    const std::string edge = edge_name(t.edge);
    const std::string sentence =
        key == "both" ? words_.say("polygon_circle.tested.both", arg("edge", edge),
                                   arg("enters", figure_place(enters)), arg("leaves", figure_place(leaves)))
        : key == "enters"
            ? words_.say("polygon_circle.tested.enters", arg("edge", edge), arg("at", figure_place(enters)))
        : key == "leaves"
            ? words_.say("polygon_circle.tested.leaves", arg("edge", edge), arg("at", figure_place(leaves)))
            : words_.say("polygon_circle.tested." + key, arg("edge", edge));
    milestone("Tested", words_.say("polygon_circle.phase.edges"), source_line, sentence,
              {{"edge", count(t.edge)},
               {"inside", t.run.inside},
               {"from", std::int64_t{t.run.from}},
               {"to", std::int64_t{t.run.to}}},
              {edge, side_text(t.run.from), side_text(t.run.to), crossings,
               words_.say(!t.run.inside                                  ? "polygon_circle.none"
                          : t.enters.has_value() || t.leaves.has_value() ? "polygon_circle.part"
                                                                         : "polygon_circle.whole")});
  }

  void operator()(const Sorted& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    calm();
    std::erase_if(view_.marks, [](const auto& mark) {
      return mark.first.starts_with("g ") || mark.first.starts_with("c ");
    });
    for (std::size_t i = 0; i < s.crossings.size(); ++i) {
      const Crossing& c = s.crossings[i];
      add_point(c.at, i + 1,
                words_.say(c.leaves ? "polygon_circle.out" : "polygon_circle.in", arg("number", i + 1)),
                Role::current);
    }
    milestone("Sorted", words_.say("polygon_circle.phase.order"), source_line,
              s.crossings.empty() ? words_.say("polygon_circle.sorted_none")
                                  : words_.say("polygon_circle.sorted", arg("crossings", s.crossings.size())),
              {{"crossings", count(s.crossings.size())}}, {});
    for (auto& [id, mark] : view_.marks) {
      if (id.starts_with("g ")) mark.role = Role::past;
    }
  }

  void operator()(const Entered& e, int source_line = __builtin_LINE(), const char* = nullptr) {
    if (chain_.empty() || chain_.back() != e.at) chain_.push_back(e.at);
    show_chain(e.at);
    milestone("Entered", words_.say("polygon_circle.phase.rings"), source_line,
              words_.say("polygon_circle.entered", arg("piece", e.ring + 1), arg("number", e.number + 1),
                         arg("at", figure_place(e.at))),
              {{"ring", count(e.ring)}, {"crossing", count(e.number)}}, {});
  }

  void operator()(const Walked& w, int source_line = __builtin_LINE(), const char* = nullptr) {
    chain_.push_back(w.at);
    show_chain(w.at);
    milestone("Walked", words_.say("polygon_circle.phase.rings"), source_line,
              words_.say("polygon_circle.walked", arg("corner", w.corner + 1), arg("at", figure_place(w.at))),
              {{"ring", count(w.ring)}, {"corner", count(w.corner)}}, {});
  }

  void operator()(const Bent& b, int source_line = __builtin_LINE(), const char* = nullptr) {
    chain_.push_back(b.from);
    const bool arc = b.from != b.to || b.more_than_half;
    if (arc) {
      const Unit unit = unit_of(scene_.circle.radius);
      const dvec2 from = seen_from(scene_.circle.centre, b.from, unit) / unit.radius;
      const dvec2 to = seen_from(scene_.circle.centre, b.to, unit) / unit.radius;
      const std::vector<dvec2> points =
          circle_drawing::arc(scene_.circle, atan2(from.y, from.x), sweep(from, to, b.more_than_half));
      chain_.insert(chain_.end(), points.begin() + 1, points.end());
      chain_.back() = b.to;
      view_.add({"e now", Role::current, Path{scene_.panel.at(points)}});
    }
    show_chain(b.to);
    milestone("Bent", words_.say("polygon_circle.phase.rings"), source_line,
              arc ? words_.say("polygon_circle.bent.arc", arg("exit", b.exit + 1),
                               arg("from", figure_place(b.from)), arg("entry", b.entry + 1))
                  : words_.say("polygon_circle.bent.corner", arg("at", figure_place(b.from))),
              {{"ring", count(b.ring)},
               {"exit", count(b.exit)},
               {"entry", count(b.entry)},
               {"more_than_half", b.more_than_half}},
              {});
    view_.marks.erase("e now");
  }

  void operator()(const Closed& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    view_.marks.erase("e chain");
    view_.marks.erase("e here");
    const std::string id = fmt::format("d piece {:03}", c.ring);
    view_.add({id, Role::accepted, Area{{scene_.panel.at(chain_)}}});
    view_.add({id + " line", Role::accepted, Path{scene_.panel.at(chain_), true}});
    chain_.clear();
    milestone("Closed", words_.say("polygon_circle.phase.rings"), source_line,
              words_.say("polygon_circle.closed", arg("piece", c.ring + 1), arg("corners", c.corners)),
              {{"ring", count(c.ring)}, {"corners", count(c.corners)}}, {});
  }

  void operator()(const Finished<double>& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    clear_result();
    std::string sentence = words_.say("polygon_circle.nothing");
    const auto pieces = static_cast<std::int64_t>(f.region.rings.size());
    const Covered covered = area_of(f.region);
    add_rings(f.region);
    if (pieces > 0 && scene_.tolerance) {
      std::size_t corners = 0;
      const auto flat = flatten(f.region, *scene_.tolerance);
      for (const auto& polygon : flat) {
        corners += polygon.size();
        const std::string id = fmt::format("i flat {}", corners);
        view_.add({id, Role::measure, Path{scene_.panel.at(polygon), true}});
        if (corners > 200) continue;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
          view_.add({fmt::format("{} {:03}", id, k), Role::measure, Dot{scene_.panel.at(polygon[k])}});
        }
      }
      sentence = words_.count("polygon_circle.done_flat", pieces, arg("area", covered.text()),
                              arg("corners", corners), arg("tolerance", figure_real(*scene_.tolerance)),
                              arg("flat", area_of(flat, scene_.circle).text()));
    } else if (pieces > 0) {
      sentence = words_.count("polygon_circle.done", pieces, arg("area", covered.text()));
    }
    milestone("Finished", words_.say("words.result"), source_line, sentence,
              {{"pieces", pieces}, {"area", covered.field()}}, {});
    region_ = f.region;
  }

  void operator()(const Looked& l, int source_line = __builtin_LINE(), const char* = nullptr) {
    follow_edge(l.edge, {l.from, l.to});
    const bool crosses = run_of({l.from, l.to}, scene_.circle).inside;
    const std::string key = l.from_inside && l.to_inside ? "inside"
                            : l.from_inside              ? "leaves"
                            : l.to_inside                ? "enters"
                            : crosses                    ? "skipped"
                                                         : "outside";
    leaves_ = key == "leaves";
    const std::string puts = key == "inside"   ? "polygon_circle.puts.end"
                             : key == "enters" ? "polygon_circle.puts.both"
                             : leaves_         ? "polygon_circle.puts.start"
                                               : "polygon_circle.none";
    const auto side = [&](bool inside) {
      return words_.say(inside ? "polygon_circle.inside" : "polygon_circle.outside");
    };
    milestone("Looked", words_.say("polygon_circle.phase.edges"), source_line,
              words_.say("polygon_circle.looked." + key, arg("edge", edge_name(l.edge))),
              {{"edge", count(l.edge)}, {"from_inside", l.from_inside}, {"to_inside", l.to_inside}},
              {edge_name(l.edge), side(l.from_inside), side(l.to_inside), words_.say(puts)});
  }

  void operator()(const Kept& k, int source_line = __builtin_LINE(), const char* = nullptr) {
    chain_.push_back(k.at);
    show_chain(k.at);
    const std::string key = !k.cut ? "corner" : leaves_ ? "start" : "entry";
    milestone("Kept", words_.say("polygon_circle.phase.edges"), source_line,
              words_.say("polygon_circle.kept." + key, arg("at", figure_place(k.at))),
              {{"x", k.at.x}, {"y", k.at.y}, {"cut", k.cut}}, {});
  }

  void operator()(const Joined<double>& j, int source_line = __builtin_LINE(), const char* = nullptr) {
    clear_result();
    const std::vector<dvec2> corners(j.corners.begin(), j.corners.end());
    // What is right, behind what comes out
    add_right();
    if (corners.size() > 2) view_.add({"h area", Role::result, Area{{scene_.panel.at(corners)}}});
    if (corners.size() > 1) view_.add({"h line", Role::result, Path{scene_.panel.at(corners), true}});
    for (std::size_t i = 0; i < corners.size(); ++i) {
      view_.add({fmt::format("h point {:03}", i), Role::result, Dot{scene_.panel.at(corners[i])}});
    }
    const Covered area = area_of({corners}, scene_.circle);
    milestone("Joined", words_.say("words.result"), source_line,
              words_.say("polygon_circle.joined", arg("corners", corners.size()), arg("area", area.text()),
                         arg("right", scene_.right.text())),
              {{"corners", count(corners.size())}, {"area", area.field()}}, {});
  }

  Region<double> region_;

 private:
  static std::int64_t count(std::size_t n) { return static_cast<std::int64_t>(n); }
  std::string edge_name(std::size_t edge) const { return fmt::format("{}", edge + 1); }
  std::string side_text(int side) const {
    return words_.say(side < 0   ? "polygon_circle.inside"
                      : side > 0 ? "polygon_circle.outside"
                                 : "polygon_circle.on");
  }

  void base() {
    const Panel& panel = scene_.panel;
    view_.add({"a circle", Role::boundary, Path{panel.at(circle_drawing::whole(scene_.circle)), true}});
    add_axes(view_, panel, "plane", {words_.symbol("x"), words_.symbol("y")});
    const std::vector<dvec2>& corners = corners_.empty() ? scene_.polygon : corners_;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
      circle_drawing::add_stroke(view_, panel, fmt::format("b edge {:03}", i), Role::input, a, b);
      if (corners.size() > 16 || corners_.empty()) continue;
      const auto part = circle_drawing::shown_part(panel, a, b);
      if (!part) continue;
      view_.add({fmt::format("c edge {:03}", i), Role::input,
                 Text{beside(panel.at(part->first), panel.at(part->second)), edge_name(i)}});
    }
  }

  /// A place for an edge's number: outside of the polygon, near the edge's middle and off the circle.
  dvec2 beside(dvec2 from, dvec2 to) const {
    const dvec2 along = from == to ? dvec2{1, 0} : glm::normalize(to - from),
                centre = scene_.panel.at(scene_.circle.centre);
    const double radius = scene_.circle.radius * scene_.panel.scale().x;
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
    circle_drawing::add_stroke(view_, scene_.panel, "e edge", Role::current, edge.a, edge.b, true);
    if (const auto found = view_.marks.find(fmt::format("c edge {:03}", i)); found != view_.marks.end()) {
      found->second.role = Role::current;
    }
  }
  /// What the last step pointed at stays, less loud.
  void calm() {
    view_.marks.erase("e edge");
    for (auto& [id, mark] : view_.marks) {
      if (id.starts_with("g ")) mark.role = Role::past;
      if (id.starts_with("c edge")) mark.role = Role::input;
    }
  }
  void add_point(dvec2 at, std::size_t number, const std::string& name, Role role = Role::current) {
    circle_drawing::add_point(view_, scene_.panel, fmt::format("g {:03}", number), role, at, name);
  }
  void show_chain(dvec2 here) {
    if (chain_.size() > 1) view_.add({"e chain", Role::accepted, Path{scene_.panel.at(chain_)}});
    view_.add({"e here", Role::accepted, Dot{scene_.panel.at(here)}});
  }
  void clear_result() {
    calm();
    std::erase_if(view_.marks, [](const auto& mark) {
      return mark.first.starts_with("d ") || mark.first.starts_with("e ") || mark.first.starts_with("g ") ||
             mark.first.starts_with("c ");
    });
  }
  void add_rings(const Region<double>& region) {
    for (std::size_t i = 0; i < region.rings.size(); ++i) {
      const std::vector<dvec2> points = scene_.panel.at(chain_of(region.rings[i], scene_.circle));
      const std::string id = fmt::format("h piece {:03}", i);
      view_.add({id, Role::result, Area{{points}}});
      view_.add({id + " line", Role::result, Path{points, true}});
    }
  }
  void add_right() {
    const Region<double> right = arcs(std::span<const dvec2>(scene_.polygon), scene_.circle);
    for (std::size_t i = 0; i < right.rings.size(); ++i) {
      view_.add({fmt::format("f right {:03}", i), Role::measure,
                 Path{scene_.panel.at(chain_of(right.rings[i], scene_.circle)), true, true}});
    }
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
      if (type == "Oriented" || type == "Finished" || type == "Joined") step.level = Level::idea;
    });
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Scene& scene_;
  View view_;
  Shown before_;
  std::vector<dvec2> corners_, chain_;
  std::size_t crossings_ = 0;
  bool leaves_ = false;
};

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods{
      method_in_english("polygon_circle", "arcs", Standing::taught),
      method_in_english("polygon_circle", "first_crossing", Standing::faulty)};
  return methods;
}

Trace run(const Arguments& arguments, Recording recording) {
  const std::vector<dvec2> polygon = arguments.points("polygon");
  const Disc circle = circle_drawing::circle_in(arguments);
  const std::optional<double> tolerance = arguments.number("tolerance");
  for (const dvec2 p : polygon) circle_drawing::expect_coordinates("polygon", {p});
  if (tolerance && !(*tolerance >= circle.radius * 1e-6 && *tolerance > 0)) {
    throw ArgumentError("tolerance", "at least a millionth of the radius expected: a figure shows no more");
  }
  if (const auto meeting = meeting_edges(polygon)) {
    throw ArgumentError("polygon", fmt::format("a simple polygon expected, but its edges {} and {} meet",
                                               meeting->first + 1, meeting->second + 1));
  }
  const std::span<const dvec2> corners(polygon);
  const std::string& name = arguments.text("method");
  const bool faulty = name == "first_crossing";
  const Scene scene{polygon, circle, tolerance,
                    Panel({{3, 3}, {width - 2, height - 1.5}}, world_of(polygon, circle)),
                    area_of(arcs(corners, circle))};
  require_scale(scene.panel, arguments, {"circle"});

  TraceWriter writer(recording);
  Trace& about = writer.trace();
  const Wording& words = about.wording;
  introduce(about, "polygon_circle", arguments, faulty);
  about.subtitle =
      words.say("polygon_circle.subtitle", arg("corners", polygon.size()),
                arg("centre", figure_place(circle.centre)), arg("radius", figure_real(circle.radius)));
  about.grid = paper_grid(width, height);
  about.legend = {{Role::input, words.say("polygon_circle.legend.input")},
                  {Role::boundary, words.say("polygon_circle.legend.boundary")},
                  {Role::past, words.say("polygon_circle.legend.past")},
                  {Role::current, words.say("polygon_circle.legend.current")},
                  {Role::accepted, words.say("polygon_circle.legend.accepted")},
                  {Role::result, words.say("polygon_circle.legend.result")}};
  about.source_file = std::string(folder) + (faulty ? "polygon_circle_notes.hpp" : "polygon_circle.hpp");
  about.listing = listing_of(source_text(about.source_file), name);

  Teller teller(writer, scene, faulty);
  if (faulty) {
    first_crossing(corners, circle, teller);
  } else {
    arcs(corners, circle, teller);
  }
  const Region<double> region = teller.region_;
  Trace trace = std::move(writer).finish();
  trace.telling = {trace.last, 0};
  trace.result = {{"area", scene.right.field()}};
  if (!faulty) trace.result.push_back({"pieces", static_cast<std::int64_t>(region.rings.size())});
  return trace;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "polygon_circle",
      .title = Wording().say("polygon_circle.title"),
      .chapter = "clipping",
      .aliases = {"polygon in circle", "arcs"},
      .summary = "the part of a polygon that lies in a circle, with true arcs",
      .methods = all_methods(),
      .default_method = "arcs",
      .parameters = {{.name = "polygon",
                      .type = ParameterType::points,
                      .default_value = "-7,-2 7,-3 2,0 6,6 -2,2 -3,7",
                      .example = "0,0 8,0 8,8 0,8",
                      .help = "the polygon's corners; simple, convex or not, in either direction",
                      .least = 3,
                      .most = 1000,
                      .parts = {"x", "y"}},
                     {.name = "circle",
                      .type = ParameterType::numbers,
                      .default_value = "0,0,5",
                      .example = "0,0,5",
                      .help = "the circle: centre and radius",
                      .parts = {"cx", "cy", "r"}},
                     {.name = "tolerance",
                      .type = ParameterType::number,
                      .default_value = "",
                      .example = "0.1",
                      .help = "show chords for the arcs too, nowhere farther from them than this"}},
      .examples = {"--polygon '-7,-2 7,-3 2,0 6,6 -2,2 -3,7' --circle 0,0,5",
                   "--polygon '-4,-4 4,-4 4,4 -4,4' --circle 0,0,5 --tolerance 0.2",
                   "--polygon '0,0 8,0 8,8 0,8' --circle 0,0,5 --method first_crossing"},
      .run = run};
  return topic;
}

}  // namespace gradus::polygon_circle
