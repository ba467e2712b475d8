// The story of an octree's order: which child comes first, and what each leaf may be drawn over.

#include "visibility/octree_order/octree_order.hpp"

#include "stories/visibility/faces_task.hpp"

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
  faces_task::Reader reader;

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
                  faces_task::reader_of(arguments)};
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

class OrderStory {
 public:
  OrderStory(const Words& words, const Subject& subject, bool from_front)
      : words_(words), subject_(subject), from_front_(from_front), panel_(place, {}) {
    Extent extent;
    for (const dvec3 p : corners_of(subject.root, 1)) extent.add(subject.reader.flat(p));
    if (subject.eye.w == 1) extent.add(subject.reader.flat(dvec3(subject.eye)));
    panel_ = Panel(place, extent);
  }

  dvec2 at(dvec3 p) const { return panel_.at(subject_.reader.flat(p)); }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    return {.text = subject_.eye.w == 1 ? "started" : "started.far",
            .words = {{"eye", dvec3(subject_.eye)}, {"side", subject_.root.side}},
            .count = std::ssize(subject_.points),
            .begins = true,
            .level = Level::idea};
  }

  void show(Board& board, const Entered<double>& e) {
    entered_ = e.cell;
    nearest_ = e.nearest;
    current_.reset();
    put(board);
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

  void show(Board& board, const Visited<double>& v) {
    current_ = v.cell;
    entered_.reset();
    visited_.push_back(v.cell);
    put(board);
  }
  Event say(const Visited<double>& v) const {
    return {.text = v.number == 1 ? "visited.first"
                    : from_front_ ? "visited.front"
                                  : "visited.back",
            .facts = {{"number", v.number}},
            .words = {{"number", v.number}, {"cell", v.cell.lower}, {"side", v.cell.side}},
            .row = {v.number, figure_place(v.cell.lower), v.cell.side},
            .key = figure_number(v.number)};
  }

  void show(Board& board, const Finished&) {
    current_.reset();
    entered_.reset();
    put(board);
  }
  Event say(const Finished& f) const {
    return {.text = "finished",
            .facts = {{"cells", f.cells}, {"compared", f.compared}},
            .words = {{"cells", f.cells}, {"compared", f.compared}}};
  }

 private:
  /// The corners of a cube shrunk to this part of its side: bit 0 x, bit 1 y, bit 2 z.
  static std::vector<dvec3> corners_of(const Cube& cell, double part) {
    const dvec3 middle = middle_of(cell);
    std::vector<dvec3> corners;
    for (int i = 0; i < 8; ++i) {
      const dvec3 way{(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1};
      corners.push_back(middle + 0.5 * part * cell.side * way);
    }
    return corners;
  }

  /// The faces of a cube, counter-clockwise from outside.
  static std::vector<std::vector<dvec3>> faces_of(const Cube& cell, double part) {
    const std::vector<dvec3> corners = corners_of(cell, part);
    std::vector<std::vector<dvec3>> faces;
    for (const Corners& numbers : faces_of_box()) {
      faces.emplace_back();
      for (const std::size_t i : numbers) faces.back().push_back(corners[i]);
    }
    return faces;
  }
  /// Cubes stand apart a little, so that one sees how many there are.
  static constexpr double apart = 0.86;

  Role role_of(std::size_t i) const {
    if (current_ && i + 1 == visited_.size()) return Role::current;
    return current_ || entered_ ? Role::past : Role::result;
  }

  void put(Board& board) const {
    View view;
    SpaceDrawing drawing(subject_.reader.look(panel_));
    std::vector<std::vector<dvec3>> rings;
    for (std::size_t i = 0; i < visited_.size(); ++i) {
      const std::string id = fmt::format("b {:03}", i);
      add_cube(drawing, id, role_of(i), visited_[i], apart);
      for (auto& ring : faces_of(visited_[i], apart)) rings.push_back(std::move(ring));
    }
    add_frame(drawing, "a root", Role::boundary, subject_.root, 1);
    if (entered_) {
      add_frame(drawing, "c entered", Role::candidate, *entered_, 1);
      add_frame(drawing, "d nearest", Role::accepted, child_of(*entered_, nearest_), apart);
    }
    drawing.add_to(view, "a");
    add_numbers(view, rings);
    for (std::size_t i = 0; i < subject_.points.size() && visited_.empty(); ++i)
      view.add({fmt::format("p {:02}", i), Role::input, Dot{at(subject_.points[i])}});
    const dvec3 corner = subject_.root.lower + dvec3{0, 0, subject_.root.side};
    view.add({"o corner", Role::boundary, Label{at(corner), figure_place(corner)}});
    if (subject_.eye.w == 1)
      view.add_named("e eye", Role::measure, at(dvec3(subject_.eye)), words_.say("eye"));
    board.milestone(std::move(view));
  }
  static void add_cube(SpaceDrawing& drawing, const std::string& id, Role role, const Cube& cell,
                       double part) {
    std::size_t face = 0;
    for (auto& ring : faces_of(cell, part)) {
      for (std::size_t k = 0; k < 4; ++k)
        drawing.add(SpaceEdge{.id = fmt::format("{} {} {}", id, face, k),
                              .role = role,
                              .a = ring[k],
                              .b = ring[(k + 1) % 4],
                              .behind = false});
      drawing.add(SpaceFace{.id = fmt::format("{} {}", id, face++), .role = role, .ring = std::move(ring)});
    }
  }
  static void add_frame(SpaceDrawing& drawing, const std::string& id, Role role, const Cube& cell,
                        double part) {
    const std::vector<dvec3> corners = corners_of(cell, part);
    for (std::size_t i = 0; i < 8; ++i) {
      for (const std::size_t bit : {1u, 2u, 4u}) {
        if ((i & bit) != 0) continue;
        drawing.add(SpaceEdge{
            .id = fmt::format("{} {} {}", id, i, bit), .role = role, .a = corners[i], .b = corners[i | bit]});
      }
    }
  }
  /// The number of each cube on a face of it that is seen.
  void add_numbers(View& view, const std::vector<std::vector<dvec3>>& rings) const {
    const HiddenLines lines(rings, distant_viewer(subject_.reader.towards), subject_.root.side);
    for (std::size_t i = 0; i < visited_.size(); ++i) {
      for (std::size_t f = 0; f < 6; ++f) {
        const std::vector<dvec3>& ring = rings[6 * i + f];
        if (glm::dot(area_vector(ring), subject_.reader.towards) <= 0) continue;
        const dvec3 middle = 0.25 * (ring[0] + ring[1] + ring[2] + ring[3]);
        if (lines.pieces(middle, middle + 1e-3 * (ring[0] - middle)).front().hidden) continue;
        view.add({fmt::format("n {:03}", i), role_of(i), Text{at(middle), fmt::format("{}", i + 1)}});
        break;
      }
    }
  }

  const Words& words_;
  const Subject& subject_;
  const bool from_front_;
  Panel panel_;
  std::vector<Cube> visited_{};
  std::optional<Cube> current_{}, entered_{};
  int nearest_ = 0;
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

template <class Walk>
void tell_order(Narrator& narrator, bool from_front, const Walk& walk) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject);
  OrderStory story(narrator.words(), subject, from_front);
  narrator.handles("points", [&](dvec3 p) { return story.at(p); });
  if (subject.eye.w == 1) narrator.handles("eye", [&](dvec3 p) { return story.at(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::int64_t leaves = 0;
  walk(subject, [&](const Cube&) { ++leaves; }, watch);
  narrator.result({{"cells", leaves}});
}

void tell_front_to_back(Narrator& narrator) {
  tell_order(narrator, true, [](const Subject& s, const auto& visit, const auto& watch) {
    front_to_back(s.root, s.eye, [&](const Cube& cell) { return s.splits(cell); }, visit, watch);
  });
}
void tell_back_to_front(Narrator& narrator) {
  tell_order(narrator, false, [](const Subject& s, const auto& visit, const auto& watch) {
    back_to_front(s.root, s.eye, [&](const Cube& cell) { return s.splits(cell); }, visit, watch);
  });
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
                    .tell = tell_front_to_back,
                    .function = "nearer_first"},
                   {.name = "back_to_front", .tell = tell_back_to_front, .function = "farther_first"}},
       .default_method = "front_to_back",
       .parameters = {points(1, 64, "points", "1,1,1 7,6,7 6,7,5 2,6,3", "1,1,1 5,5,5 6,6,6",
                             "what the cells hold: one with several is cut into eight", xyz, modest),
                      number("side", "8", "16", "of the whole cube, whose least corner is 0,0,0", modest),
                      {.name = "depth",
                       .type = ParameterType::integer,
                       .default_value = "2",
                       .example = "3",
                       .help = "how often a cell is cut at most",
                       .least = 1,
                       .most = 4},
                      numbers("eye", "12,10,5", "3,3,3", "where it is; inside the cube, too", xyz, modest),
                      {.name = "far",
                       .type = ParameterType::flag,
                       .default_value = "",
                       .example = "yes",
                       .help = "the eye is infinitely far away, in the direction of --eye"},
                      faces_task::towards_parameter("4,5,9")},
       .examples = {"--depth 1", "--eye 3,3,3", "--method back_to_front --far --eye 1,2,3"}});
  return topic;
}

}  // namespace gradus::octree_order
