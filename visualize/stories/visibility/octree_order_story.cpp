// The story of an octree's order: which child comes first, and what each leaf may be drawn over.

#include "visibility/octree_order/octree_order.hpp"

#include "stories/past.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::octree_order {
namespace {

using Cube = Cell<double>;

constexpr int paper_width = 36, paper_height = 27;
constexpr Extent place{{1, 1}, {35, 26}};

/// What a run is about.
struct Subject {
  Cube root;
  std::vector<dvec3> points;
  int deepest;
  Eye<double> eye;
  faces_subject::Reader reader;

  /// Whether so many points lie in a cell that it has children.
  bool splits(const Cube& cell) const {
    const auto holds = [&](dvec3 p) {
      const dvec3 to = p - cell.lower;
      return glm::clamp(to, 0.0, cell.side) == to;
    };
    return cell.depth < deepest && (cell.depth == 0 || std::ranges::count_if(points, holds) > 1);
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
    for (const dvec3 p : corners_of(subject.root)) extent.add(subject.reader.flat(p));
    if (subject.eye.w == 1) extent.add(subject.reader.flat(dvec3(subject.eye)));
    panel_ = Panel(place, extent);
  }

  dvec2 at(dvec3 p) const { return panel_.at(subject_.reader.flat(p)); }
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
    const auto& visited = all<Visited<double>>();
    std::vector<std::vector<dvec3>> rings;
    for (std::size_t i = 0; i < visited.size(); ++i) {
      const std::vector<dvec3> corners = corners_of(visited[i].cell, apart);
      drawing.add_box(fmt::format("b {:03}", i), role_of(i), corners);
      std::ranges::move(rings_of_box(corners), std::back_inserter(rings));
    }
    drawing.add_frame("a root", Role::boundary, corners_of(subject_.root));
    if (const auto* entered = now<Entered<double>>()) {
      drawing.add_frame("c entered", Role::candidate, corners_of(entered->cell));
      drawing.add_frame("d nearest", Role::accepted,
                        corners_of(child_of(entered->cell, entered->nearest), apart));
      for (int child = 0; child < 8; ++child) {
        const Cube cell = child_of(entered->cell, child);
        const auto turn = std::ranges::find(order_, cell);
        if (turn != order_.end())
          view.add({fmt::format("d turn {}", child),
                    child == entered->nearest ? Role::accepted : Role::candidate,
                    Text{at(middle_of(cell)), fmt::format("{}", turn - order_.begin() + 1)}});
      }
    }
    drawing.add_to(view, "a");
    add_numbers(view, rings);
    for (std::size_t i = 0; i < subject_.points.size() && visited.empty(); ++i)
      view.add({fmt::format("p {:02}", i), Role::input, Dot{at(subject_.points[i])}});
    const dvec3 corner = subject_.root.lower + dvec3{0, 0, subject_.root.side};
    view.add({"o corner", Role::boundary, Label{at(corner), figure_place(corner)}});
    if (subject_.eye.w == 1)
      view.add_named("e eye", Role::measure, at(dvec3(subject_.eye)), words_.say("eye"));
    return view;
  }

 private:
  /// Cubes stand apart a little, so that one sees how many there are.
  static constexpr double apart = 0.86;

  /// The corners of a cube shrunk to this part of its side.
  static std::vector<dvec3> corners_of(const Cube& cell, double part = 1) {
    const dvec3 middle = middle_of(cell), half(0.5 * part * cell.side);
    return corners_of_box(middle - half, middle + half);
  }
  Role role_of(std::size_t i) const {
    if (now<Finished>()) return Role::result;
    return now<Visited<double>>() && i + 1 == all<Visited<double>>().size() ? Role::current : Role::past;
  }

  /// The number of each cube on a face of it that is seen.
  void add_numbers(View& view, const std::vector<std::vector<dvec3>>& rings) const {
    const HiddenLines lines(rings, distant_viewer(subject_.reader.towards), subject_.root.side);
    for (std::size_t k = 0, last = none; k < rings.size(); ++k) {
      const std::vector<dvec3>& ring = rings[k];
      const std::size_t i = k / 6;
      if (i == last || glm::dot(area_vector(ring), subject_.reader.towards) <= 0) continue;
      const auto seen = faces_subject::seen_place(ring, lines, [](dvec3) { return true; });
      if (!seen) continue;
      view.add({fmt::format("n {:03}", i), role_of(i), Text{at(*seen), fmt::format("{}", i + 1)}});
      last = i;
    }
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

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
  if (subject.eye.w == 1) narrator.handles("eye", [&](dvec3 p) { return story.at(p); });
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
