// The story of an octree's order: which child comes first, and what each leaf may be drawn over.

#include "visibility/octree_order/octree_order.hpp"

#include "stories/past.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::octree_order {
namespace {

using Cube = Cell<double>;

constexpr int paper_width = 36, paper_height = 27;
constexpr Extent place{{6.5, 1}, {35, 26}};

bool holds(const Cube& cell, dvec3 p) {
  const dvec3 to = p - cell.lower;
  return glm::clamp(to, 0.0, cell.side) == to;
}

/// What a run is about.
struct Subject {
  Cube root;
  std::vector<dvec3> points;
  int deepest;
  Eye<double> eye;
  faces_subject::Reader reader;

  /// Whether so many points lie in a cell that it has children.
  bool splits(const Cube& cell) const {
    const auto is_here = [&](dvec3 p) { return holds(cell, p); };
    return cell.depth < deepest && (cell.depth == 0 || std::ranges::count_if(points, is_here) > 1);
  }
};

Subject subject_of(const Arguments& arguments) {
  const double side = *arguments.number("side");
  if (!(side > 0)) refuse("side", "expected a side above 0, found {}", side);
  const dvec3 eye = *arguments.place("eye");
  const bool far = arguments.flag("far");
  if (far && eye == dvec3{0})
    refuse(arguments, {"eye"}, "a direction expected, found 0,0,0, which points nowhere");
  Subject subject{{dvec3{0}, side},
                  arguments.places("points"),
                  static_cast<int>(arguments.integer("depth")),
                  Eye<double>(eye, far ? 0 : 1),
                  faces_subject::reader_of(arguments)};
  for (const dvec3 p : subject.points) {
    if (glm::clamp(p, 0.0, side) != p)
      refuse(arguments, {"points", "side"},
             fmt::format("expected points within 0 and {} on each axis, found ({}, {}, {})", side, p.x, p.y,
                         p.z));
  }
  if (!far && (std::abs(eye.x) > 8 * side || std::abs(eye.y) > 8 * side || std::abs(eye.z) > 8 * side))
    refuse(
        arguments, {"eye", "side"},
        "expected an eye within 8 sides of the origin, where a figure shows both; --far takes a direction");
  return subject;
}

/// "+x −y +z": on which side of its parent's middle a child lies.
std::string octant_text(int child) {
  return fmt::format("{}x {}y {}z", (child & 1) != 0 ? "+" : "−", (child & 2) != 0 ? "+" : "−",
                     (child & 4) != 0 ? "+" : "−");
}

class OrderStory : public Past<steps::Started, Entered<double>, Visited<double>, Finished> {
 public:
  OrderStory(const Words& words, const Subject& subject, bool from_front, std::vector<Cube> order)
      : words_(words),
        subject_(subject),
        from_front_(from_front),
        order_(std::move(order)),
        panel_(place, {}) {
    Extent extent;
    for (const Cube& cell : order_) {
      for (const dvec3 p : corners_of(cell)) extent.add(subject.reader.flat(p));
    }
    extent.add(subject.reader.flat(shown_eye(dvec3(subject.eye))));
    panel_ = Panel(place, extent);
  }

  /// Where a point of the cube or the eye is drawn.
  dvec2 at(dvec3 p) const { return panel_.at(subject_.reader.flat(spread(p))); }
  dvec2 eye_at(dvec3 eye) const { return panel_.at(subject_.reader.flat(shown_eye(eye))); }
  /// The last cell with children: by then the table has rows.
  double tells(const auto& step) const {
    return std::same_as<std::decay_t<decltype(step)>, Entered<double>>
               ? static_cast<double>(all<Visited<double>>().size() + 1)
               : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = subject_.eye.w == 1 ? "started" : "started.far",
            .words = {{"eye", dvec3(subject_.eye)}, {"side", subject_.root.side}},
            .count = std::ssize(subject_.points),
            .begins = true,
            .level = Level::idea};
  }
  Event say(const Entered<double>& e) const {
    std::vector<std::string> octants;
    for (int child = 0; child < 8; ++child) octants.push_back(octant_text(child));
    const dvec3 middle = middle_of(e.cell);
    return {.text = from_front_ ? "entered.front" : "entered.back",
            .facts = {{"depth", e.cell.depth}, {"nearest", e.nearest}},
            .words = {{"middle", middle},
                      {"nearest", octant_text(e.nearest)},
                      {"across", octant_text(7 - e.nearest)}},
            .key = octant_text(e.nearest),
            .decides = Decision{words_.say("question", {{"middle", middle}}), octants,
                                static_cast<std::size_t>(e.nearest), "nearest"}};
  }
  Event say(const Visited<double>& v) const {
    return {.text = v.number == 1 ? "visited.first"
                    : from_front_ ? "visited.front"
                                  : "visited.back",
            .facts = {{"number", v.number}},
            .words = {{"cell", v.cell.lower}, {"side", v.cell.side}},
            .row = {v.number, figure_place(v.cell.lower), v.cell.side},
            .key = figure_number(v.number)};
  }
  Event say(const Finished& f) const {
    return {.text = "finished", .facts = {{"cells", f.cells}, {"compared", f.compared}}};
  }

  View draw() const {
    View view;
    SpaceDrawing drawing(subject_.reader.look(panel_));
    std::vector<std::vector<dvec3>> rings;
    for (std::size_t i = 0; i < shown_cells(); ++i) {
      const std::vector<dvec3> corners = corners_of(order_[i]);
      add_cell(drawing, fmt::format("b {:03}", i), role_of(i), corners);
      std::ranges::move(rings_of_box(corners), std::back_inserter(rings));
    }
    drawing.add_to(view, "a");
    for (std::size_t i = 0; i < subject_.points.size() && now<steps::Started>(); ++i)
      view.add({fmt::format("p {:02}", i), Role::input, Dot{at(subject_.points[i])}});
    const dvec2 eye = eye_at(dvec3(subject_.eye));
    if (const auto* entered = now<Entered<double>>()) {
      const Cube& cell = entered->cell;
      const dvec2 from = panel_.at(subject_.reader.flat(spread(middle_of(cell), cell.depth)));
      view.add({"d way", Role::measure, Stroke{from, eye, true}});
      view.add({"d middle", Role::measure, Dot{from}});
    }
    add_numbers(view, rings);
    view.add_named("e eye", Role::measure, eye, words_.say(subject_.eye.w == 1 ? "eye" : "eye.far"));
    add_axes(view);
    return view;
  }

 private:
  /// Children stand apart, so that each is seen; by so much of their middles' distance, and a little smaller
  /// than they are.
  static constexpr double apart = 1.75, size = 0.86;
  /// As far from the middle of the cube as an eye is drawn, in sides.
  static constexpr double farthest_eye = 1.5;
  /// Of more cells those to come are left away.
  static constexpr std::size_t most_cells = 64;

  /// Where a place is drawn: apart from the middles of the cells that hold it, down to this depth.
  dvec3 spread(dvec3 p, int depth = std::numeric_limits<int>::max()) const {
    dvec3 moved = p;
    Cube cell = subject_.root;
    while (cell.depth < depth && subject_.splits(cell) && (cell.depth == 0 || holds(cell, p))) {
      const dvec3 middle = middle_of(cell);
      cell =
          child_of(cell, (p.x >= middle.x ? 1 : 0) + (p.y >= middle.y ? 2 : 0) + (p.z >= middle.z ? 4 : 0));
      moved += (apart - 1) * (middle_of(cell) - middle);
    }
    return moved;
  }
  /// The eye, or a place in its direction where it is too far away.
  dvec3 shown_eye(dvec3 eye) const {
    const dvec3 middle = middle_of(subject_.root);
    const double most = farthest_eye * subject_.root.side;
    if (subject_.eye.w == 0) return spread(middle + most * unit_vector(eye));
    const double distance = length_between(eye, middle);
    return spread(distance > most ? middle + most / distance * (eye - middle) : eye);
  }
  /// The corners of a cell as it is drawn.
  std::vector<dvec3> corners_of(const Cube& cell) const {
    const dvec3 middle = spread(middle_of(cell), cell.depth), half(0.5 * size * cell.side);
    return corners_of_box(middle - half, middle + half);
  }
  /// A cell to come is pale and has thin edges.
  static void add_cell(SpaceDrawing& drawing, const std::string& id, Role role,
                       const std::vector<dvec3>& corners) {
    if (role != Role::guide) return drawing.add_box(id, role, corners);
    std::size_t number = 0;
    for (const std::vector<dvec3>& ring : rings_of_box(corners)) {
      drawing.add(SpaceFace{.id = id, .role = role, .ring = ring, .shade = 1});
      for (const auto& [a, b] : sides_of(ring))
        drawing.add(SpaceEdge{.id = fmt::format("{} {:02}", id, number++),
                              .role = role,
                              .a = a,
                              .b = b,
                              .thin = true,
                              .behind = false});
    }
  }
  std::size_t shown_cells() const {
    return order_.size() > most_cells ? all<Visited<double>>().size() : order_.size();
  }
  Role role_of(std::size_t i) const {
    if (now<Finished>()) return Role::result;
    const std::size_t visited = all<Visited<double>>().size();
    if (i < visited) return now<Visited<double>>() && i + 1 == visited ? Role::current : Role::past;
    const auto* entered = now<Entered<double>>();
    if (!entered || !holds(entered->cell, middle_of(order_[i]))) return Role::guide;
    const Cube nearest = child_of(entered->cell, entered->nearest);
    return holds(nearest, middle_of(order_[i])) ? Role::accepted : Role::candidate;
  }

  /// The number of each cell that has got one or gets it now, on a face of it that is seen: the first on
  /// which the digits lie on no edge, if there is one.
  void add_numbers(View& view, const std::vector<std::vector<dvec3>>& rings) const {
    const HiddenLines lines(rings, distant_viewer(subject_.reader.towards), subject_.root.side);
    const auto flat = [&](dvec3 p) { return panel_.at(subject_.reader.flat(p)); };
    for (std::size_t i = 0; i < shown_cells(); ++i) {
      if (role_of(i) == Role::guide) continue;
      const std::string number = fmt::format("{}", i + 1);
      std::optional<dvec2> written;
      bool is_clear = false;
      for (std::size_t k = 6 * i; k < 6 * i + 6 && !is_clear; ++k) {
        if (glm::dot(area_vector(rings[k]), subject_.reader.towards) <= 0) continue;
        const auto edges = strokes_in(view, extent_around(mapped(rings[k], flat)));
        const auto clear = [&](dvec3 p) { return is_free(edges, flat(p), number); };
        const auto seen = faces_subject::seen_place(rings[k], lines, clear);
        if (!seen) continue;
        is_clear = clear(*seen);
        if (is_clear || !written) written = flat(*seen);
      }
      if (written) view.add({fmt::format("n {:03}", i), role_of(i), Text{*written, number}});
    }
  }
  /// Those that reach into it.
  static std::vector<Stroke> strokes_in(const View& view, const Extent& extent) {
    std::vector<Stroke> strokes;
    for (const auto& [id, mark] : view.marks) {
      const Stroke* stroke = std::get_if<Stroke>(&mark.shape);
      if (stroke && reaches_into(*stroke, extent)) strokes.push_back(*stroke);
    }
    return strokes;
  }
  static bool reaches_into(const Stroke& stroke, const Extent& extent) {
    const auto [from, to] = span_in(extent, stroke.a, stroke.b - stroke.a, 0, 1);
    return from <= to;
  }
  static bool is_free(const std::vector<Stroke>& edges, dvec2 at, const std::string& number) {
    const dvec2 half{0.32 * static_cast<double>(number.size()) + 0.15, 0.55};
    return std::ranges::none_of(
        edges, [&](const Stroke& edge) { return reaches_into(edge, {at - half, at + half}); });
  }
  void add_axes(View& view) const {
    constexpr double length = 3;
    const dvec2 origin{3.5, 4};
    for (const int axis : {0, 1, 2}) {
      dvec3 way{0};
      way[axis] = length;
      add_arrow(view, fmt::format("x axis {}", axis), Role::boundary, origin,
                origin + subject_.reader.flat(way), std::string(1, "xyz"[axis]));
    }
  }

  const Words& words_;
  const Subject& subject_;
  const bool from_front_;
  const std::vector<Cube> order_;
  Panel panel_;
};

void set_up(Narrator& narrator, const Subject& subject) {
  narrator.paper(paper_width, paper_height);
  narrator.trace().subtitle =
      narrator.words().count("subtitle", std::ssize(subject.points), {{"side", subject.root.side}});
  narrator.columns({{"number"}, {"cell", false}, {"side"}});
  narrator.legend({{Role::candidate, "entered"},
                   {Role::accepted, "nearest"},
                   {Role::current, "current"},
                   {Role::past, "before"},
                   {Role::guide, "waiting"},
                   {Role::measure, "eye"},
                   {Role::input, "points"}});
}

template <bool from_front>
void tell_order(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject);
  const auto splits = [&](const Cube& cell) { return subject.splits(cell); };
  const auto walk = [&](const auto& visit, auto&&... watch) {
    if constexpr (from_front)
      front_to_back(subject.root, subject.eye, splits, visit, watch...);
    else
      back_to_front(subject.root, subject.eye, splits, visit, watch...);
  };
  std::vector<Cube> order;
  walk([&](const Cube& cell) { order.push_back(cell); });
  OrderStory story(narrator.words(), subject, from_front, order);
  narrator.handles("points", [&](dvec3 p) { return story.at(p); });
  if (subject.eye.w == 1) narrator.handles("eye", [&](dvec3 p) { return story.eye_at(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  walk([](const Cube&) {}, watch);
  narrator.result({{"cells", std::ssize(order)}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-3, 1e4};
  static const TopicEntry topic = completed<entry>(
      {.name = "octree_order",
       .chapter = "visibility",
       .aliases = {"octree", "front to back", "visibility order", "octant"},
       .summary =
           "an octree's cells from near to far or from far to near, by the side of each middle the eye is on",
       .methods = {{.name = "front_to_back",
                    .standing = Standing::taught,
                    .tell = tell_order<true>,
                    .function = "nearer_first"},
                   {.name = "back_to_front", .tell = tell_order<false>, .function = "farther_first"}},
       .default_method = "front_to_back",
       .counts = {"Visited"},
       .parameters = {points(1, 64, "points", "1,1,1 7,2,7 6,1,5 2,6,3", "1,1,1 5,5,5 6,6,6",
                             "what the cells hold: one with several is cut into eight", xyz, modest),
                      number("side", "8", "16", "of the whole cube, whose least corner is 0,0,0", modest),
                      integer(1, 4, "depth", "2", "3", "how often a cell is cut at most"),
                      numbers("eye", "12,10,2", "3,3,3", "where it is; inside the cube, too", xyz, modest),
                      flag("far", "the eye is infinitely far away, in the direction of --eye"),
                      faces_subject::towards_parameter("4,5,9")},
       .examples = {"--depth 1", "--eye 3,3,3", "--method back_to_front --far --eye 1,2,3"}});
  return topic;
}

}  // namespace gradus::octree_order
