// The story of a polygon and a convex window: what each border takes off, and what hangs together then.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_notes.hpp"
#include "stories/checking.hpp"
#include "stories/clipping/sutherland_hodgman/border_story.hpp"
#include "stories/clipping/sutherland_hodgman/clip_space_story.hpp"
#include "stories/clipping/sutherland_hodgman/pieces_story.hpp"
#include "stories/parameters.hpp"
#include "stories/point_text.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::sutherland_hodgman {
namespace {

// --- What is given

/// Of coordinates: squares of their differences neither overflow nor underflow.
constexpr Sizes plane_sizes{1e-100, 1e100};

const std::vector<Parameter>& parameters() {
  using namespace parameters;
  static const std::vector<Parameter> all{
      points(3, 200, "polygon", "-4,3 3,-4 6,-3 13,5 7,8 6,-1 4,-1 4,7",
             "2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4", "the polygon's corners, in either direction", xy,
             plane_sizes),
      {.name = "hole",
       .type = ParameterType::rings,
       .default_value = "",
       .example = "7,1 9,1 9,3 7,3; 4,1 5,1 5,2",
       .help = "holes in it, none in another; they may touch (separate_pieces alone)",
       .least = 3,
       .most = 200,
       .parts = xy,
       .sizes = plane_sizes},
      bounds("window", "0,0,10,10", "0,0,10,10", "the rectangle to clip at, its borders included",
             {"xmin", "ymin", "xmax", "ymax"}, plane_sizes),
      instead_of(
          "window",
          points(3, 50,

                 "window_polygon", "", "5,-3 12,3 8,10 -2,7",
                 "a convex window instead: its corners in order; cut at in that order, counter-clockwise", xy,
                 plane_sizes)),
      points(3, 50, "homogeneous", "-2,-1,2.75,3 1.5,-1.5,1.65,2 1.5,2,-1.65,-1",
             "-2,-1,2.75,3 1.5,-1.5,1.65,2 1.5,2,-1.65,-1",
             "method homogeneous: the corners in clip space, not divided by w yet", {"x", "y", "z", "w"}),
      {.name = "order",
       .type = ParameterType::order,
       .default_value = "left,right,bottom,top",
       .example = "bottom,left,top,right",
       .help = "in which order the borders are cut at; those of window_polygon by their numbers, as 3,1,2",
       .choices = {"left", "right", "bottom", "top"},
       .numbered = true},
      exact_parameter()};
  return all;
}
const Parameter& order_parameter() {
  return *std::ranges::find(parameters(), ParameterType::order, &Parameter::type);
}

/// The order of an oblique window's borders: as they come, unless their numbers say otherwise.
std::vector<int> order_of(const Arguments& arguments, const ConvexWindow<double>& window) {
  std::vector<int> order = all_borders(window);
  const std::string& text = arguments.text("order");
  if (text == order_parameter().default_value) return order;
  const auto numbers = arguments.numbered_order("order");
  if (!numbers || numbers->size() != order.size()) {
    refuse("order",
           "expected the numbers 1 to {} of the window's borders, each once in any order, found '{}'",
           order.size(), text);
  }
  std::ranges::transform(*numbers, order.begin(), [](std::size_t n) { return static_cast<int>(n); });
  return order;
}

/// What a method takes besides a polygon and a rectangle.
struct Takes {
  bool holes = false, oblique_windows = false;
};

Subject subject_of(const Arguments& arguments, Takes takes) {
  Subject subject{.rings = {arguments.points("polygon")}};
  for (Points& hole : arguments.rings("hole")) {
    if (!takes.holes) refuse("hole", "holes are cut by --method separate_pieces alone");
    subject.rings.push_back(std::move(hole));
  }
  if (const Points points = arguments.points("window_polygon"); !points.empty()) {
    if (!takes.oblique_windows) refuse("window_polygon", "this method clips at rectangles alone");
    subject.oblique = convex_window(points);
    if (!subject.oblique)
      refuse("window_polygon", "corners of a convex window with an area expected, in order");
    subject.order = order_of(arguments, *subject.oblique);
    return subject;
  }
  const std::vector<double> bounds = arguments.numbers("window");
  subject.rectangle = {{bounds[0], bounds[1]}, {bounds[2], bounds[3]}};
  if (arguments.numbered_order("order")) {
    refuse(
        "order",
        "expected left,right,bottom,top, each once in any order, found '{}': numbers are for the borders of "
        "--window-polygon",
        arguments.text("order"));
  }
  for (const std::size_t border : arguments.order("order")) subject.order.push_back(static_cast<int>(border));
  return subject;
}

/// Corners in clip space, as they were given.
std::vector<Point<double>> homogeneous_of(const Arguments& arguments) {
  std::vector<Point<double>> corners;
  for (const Tuple& p : arguments.tuples("homogeneous")) {
    corners.push_back({{p[0].value, p[1].value, p[2].value, p[3].value}});
    const auto& at = corners.back().at;
    if (at == dvec4(0)) refuse("homogeneous", "point {}: 0,0,0,0 is no point", corners.size());
    for (int i = 0; i < 4; ++i) {
      const double size = std::abs(at[i]);
      if (size == 0 || (1e-6 <= size && size <= 1e6)) continue;
      refuse("homogeneous",
             "point {}: expected numbers that are 0 or from 0.000001 to 1000000 in size, found '{}'",
             corners.size(), text_of(p));
    }
  }
  return corners;
}

// --- The methods in the plane

/// What the steps of the textbook's passes hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const VertexTested<T>& v) const {
    to.point("vertex", v.vertex.at);
    to.decision(v.side);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const EdgeCut<T>& c) const {
    to.point("cut", c.vertex.at);
  }
  template <class T>
  void operator()(NumericStep<T>&, const VertexKept<T>&) const {}
  template <class T>
  void operator()(NumericStep<T>&, const BorderPassed<T>&) const {}
};

void set_up(Narrator& narrator, const Subject& subject) {
  const Panel panel = panel_of(subject);
  require_scale(panel, narrator.arguments(), {"polygon", "window", "window_polygon"});
  for (const std::string_view drawn : {"polygon", "hole", subject.oblique ? "window_polygon" : "window"})
    narrator.handles(drawn, shown_in(panel));
  narrator.paper(plane_width, plane_height);
  narrator.subtitle("subtitle", {{"corners", subject.outline().size()}, {"borders", subject.order.size()}});
  narrator.legend({Role::boundary, Role::past, Role::accepted, Role::measure, Role::current, Role::rejected,
                   Role::result, Role::candidate});
  narrator.key_by_type();
  if (!subject.oblique) return;
  // An order of borders that it hasn't got
  std::erase_if(narrator.trace().arguments, [&](const Argument& a) {
    return a.name == "order" && a.value == order_parameter().default_value;
  });
}

/// Runs `clip` at the window that was given, of whichever kind.
template <class Clip>
void at_window(const Subject& subject, Clip clip) {
  subject.oblique ? clip(*subject.oblique) : clip(subject.rectangle);
}

/// The first edge that is cut at another border than the first one: what an earlier border took off is seen.
void show_second_border(Narrator& narrator) {
  const auto& steps = narrator.trace().steps;
  const auto cut = std::ranges::find(steps, "EdgeCut", &TraceStep::type);
  const auto later = std::find_if(cut, steps.end(), [&](const TraceStep& step) {
    return step.type == "EdgeCut" && step.phase != cut->phase;
  });
  if (later != steps.end()) narrator.telling(later->number);
}

/// What comes out, for programs.
std::vector<Field> corners_of(std::span<const Vertex<double>> polygon) {
  std::vector<Field> fields;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    fields.push_back({fmt::format("corner_{}.x", i + 1), polygon[i].at.x});
    fields.push_back({fmt::format("corner_{}.y", i + 1), polygon[i].at.y});
  }
  return fields;
}

void tell_border_by_border(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), {.oblique_windows = true});
  set_up(narrator, subject);
  BorderStory story(narrator.words(), subject, std::nullopt);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  at_window(subject, [&](const auto& window) {
    const auto polygon = clip_to_window(subject.outline(), window, subject.order, watch);
    story.add_result(polygon);
    narrator.result(corners_of(polygon));
    bridges(polygon, subject.outline(), window, [&](const auto& bridge) { watch(bridge, 0); });
  });
  show_second_border(narrator);
  watch(steps::Finished{}, 0);
}

void tell_separate_pieces(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), {.holes = true, .oblique_windows = true});
  set_up(narrator, subject);
  narrator.columns({{"border", false}, {"out"}, {"in"}, {"rings"}});
  PiecesStory story(narrator.words(), subject);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  at_window(subject,
            [&](const auto& window) { separate_pieces(subject.rings, window, subject.order, watch); });
  watch(steps::Finished{}, 0);
}

/// The textbook's loop and the notes' listings, in plain arithmetic. clip: of a Task.
template <auto clip>
void tell_plain(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), {});
  set_up(narrator, subject);
  std::optional<double> right;
  if (narrator.method().standing == Standing::faulty) {
    const auto polygon = clip_to_window(subject.outline(), subject.rectangle);
    right = std::abs(area_of(places(polygon)));
  }
  BorderStory story(narrator.words(), subject, right);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  story.add_result(clip(Task<double>{subject.outline(), subject.rectangle, subject.order}, watch));
  watch(steps::Finished{}, 0);
}

/// Such a listing for one border, at one after the other.
template <auto pass>
void tell_passes(Narrator& narrator) {
  tell_plain<[](const auto& task, const auto& watch) {
    return by_passes(task, [&](auto rest, auto border) { return pass(rest, border, watch); });
  }>(narrator);
}

void tell_cut_of_a_cut(Narrator& narrator) {
  tell_passes<[](auto... at) { return cut_of_a_cut(at...); }>(narrator);
  const auto run = [subject = subject_of(narrator.arguments(), {})]<class T>(T, const auto& observer) {
    std::vector<glm::vec<2, T>> corners;
    for (const dvec2 p : subject.outline()) corners.push_back(in_scalar<T>(p));
    const Rectangle<T> window = in_scalar<T>(subject.rectangle);
    by_passes(Task<T>{corners, window, subject.order},
              [&](auto rest, auto border) { return cut_of_a_cut(rest, border, observer); });
  };
  tell_side_by_side<Numbers>(narrator, run);
}

// --- The method before the division

void tell_homogeneous(Narrator& narrator) {
  const Arguments& arguments = narrator.arguments();
  if (!arguments.rings("hole").empty()) refuse("hole", "holes are cut by --method separate_pieces alone");
  if (!arguments.points("window_polygon").empty())
    refuse("window_polygon", "method homogeneous clips at the planes of clip space alone");
  const std::vector<Point<double>> corners = homogeneous_of(arguments);
  const auto planes = view_volume(1.0, 1.0);
  narrator.paper(ClipSpaceStory::paper_width, ClipSpaceStory::paper_height);
  narrator.subtitle("subtitle_space", {{"corners", corners.size()}, {"planes", planes.size()}});
  narrator.trace().goal = narrator.words().say("goal_space");
  narrator.legend({Role::input,
                   {Role::past, "past_plane"},
                   {Role::current, "current_space"},
                   Role::accepted,
                   {Role::rejected, "rejected_space"},
                   Role::result});
  narrator.columns({{"plane", false}, {"corner", false}, {"value"}, {"kept", false}});
  narrator.key_by_type();
  ClipSpaceStory story(narrator.words(), corners);
  narrator.handles("homogeneous", [&](const dvec4& p) { return story.in_side(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto polygon = clip(corners, std::span<const Plane<double>>(planes), watch);
  watch(steps::Finished{}, 0);
  narrator.result({{"corners", std::ssize(polygon)}});
}

const std::vector<Method>& all_methods() {
  const auto faulty = [](std::string name, void (*tell)(Narrator&)) {
    return Method{
        .name = std::move(name), .standing = Standing::faulty, .tell = tell, .unread = {"homogeneous"}};
  };
  static const std::vector<Method> methods{
      {.name = "border_by_border",
       .standing = Standing::taught,
       .tell = tell_border_by_border,
       .function = "cut_at_border",
       .unread = {"homogeneous"}},
      {.name = "separate_pieces",
       .tell = tell_separate_pieces,
       .function = "split_at",
       .file = "separate_pieces.hpp",
       .unread = {"homogeneous"}},
      {.name = "homogeneous",
       .tell = tell_homogeneous,
       .function = "clip",
       .file = "sutherland_hodgman_homogeneous.hpp",
       .unread = {"polygon", "hole", "window", "window_polygon", "order", "exact"}},
      {.name = "cut_of_a_cut",
       .tell = tell_cut_of_a_cut,
       .file = "plain_passes.hpp",
       .unread = {"homogeneous"},
       .exact = true},
      faulty("entering_not_cut", tell_passes<[](auto... at) { return entering_not_cut(at...); }>),
      faulty("previous_left_behind", tell_passes<[](auto... at) { return previous_left_behind(at...); }>),
      faulty("marked_by_window", tell_passes<[](auto... at) { return marked_by_window(at...); }>),
      faulty("containing_left_whole", tell_plain<[](auto... run) { return containing_left_whole(run...); }>)};
  return methods;
}

const Checking& checking() {
  static const Checking known{.asked = {{.name = "corners", .same = SameList::ring, .fields = {"x", "y"}}},
                              // A corner on a border
                              .is_tie = [](const TraceStep& step) {
                                return step.type == "VertexTested" &&
                                       value_as<std::int64_t>(step.fields, "side") == 0;
                              }};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  static const TopicEntry topic = completed<entry>(
      {.name = "sutherland_hodgman",
       .chapter = "clipping",
       .aliases = {"polygon clipping", "reentrant clipping", "weiler atherton"},
       .summary = "the part of a polygon that lies in a convex window, border by border",
       .methods = all_methods(),
       .columns = {{"edge", false}, {"was", false}, {"is", false}, {"kept", false}},
       .counts = {"EdgeCut", "Cut", "VertexTested", "Tested"},
       .parameters = parameters(),
       .examples = {"--polygon '2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4' --window 0,0,10,10",
                    "--polygon '2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4' --method separate_pieces",
                    "--window-polygon '5,-3 12,3 8,10 -2,7'",
                    "--method homogeneous --homogeneous '-2,-1,2.75,3 1.5,-1.5,1.65,2 1.5,2,-1.65,-1'"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::sutherland_hodgman
