// The story of a tree over points: what a search looks at and what it cuts off, how the tree is built, and
// what brute force takes instead.

#include "modeling/kd_tree/kd_tree.hpp"

#include "modeling/kd_tree/kd_tree_notes.hpp"
#include "stories/checking.hpp"
#include "stories/modeling/kd_tree/build_story.hpp"
#include "stories/modeling/kd_tree/drawing.hpp"
#include "stories/parameters.hpp"
#include "stories/past.hpp"

namespace gradus::kd_tree {
namespace {

using Into = Entered<2, double>;
using Off = CutOff<2, double>;
using Seen = Measured<double>;
using Found = Neighbours<double>;

Subject subject_of(const Arguments& arguments) {
  const std::vector<double> query = arguments.numbers("query");
  const std::int64_t k = arguments.has("k") ? arguments.integer("k") : 1;
  Subject subject{arguments.points("points"), {query[0], query[1]}, static_cast<std::size_t>(k), {}};
  subject.tree = build<2, double>(subject.points);
  return subject;
}

/// "A, C": those found, the nearest first.
std::string names_of(const Found& found) {
  std::vector<std::string> names;
  for (const Neighbour<double>& n : found) names.push_back(name_of(n.point));
  return fmt::format("{}", fmt::join(names, ", "));
}

class SearchStory : public Past<steps::Started, Into, Off, Seen, Finished> {
 public:
  enum class Kind { tree, down_only, unsquared, brute_force };

  SearchStory(const Words& words, const Subject& subject, const PlaneDrawing& plane, const TreeDrawing& tree,
              Kind kind)
      : words_(words),
        subject_(subject),
        plane_(plane),
        tree_(tree),
        kind_(kind),
        right_(brute_force<2, double>(subject.points, subject.query, subject.k)) {}

  Event say(const steps::Started&) const {
    return {.text = kind_ == Kind::brute_force ? "brute_force.started" : "started",
            .words = {{"query", subject_.query},
                      {"k", subject_.k},
                      {"levels", std::bit_width(subject_.points.size())}},
            .count = std::ssize(subject_.points)};
  }
  Event say(const Into& e) const {
    const std::string name = name_of(subject_.tree.middle(e.cell));
    Event event = of_cell(e.cell, e.distance, found());
    event.row = {name, e.distance};
    event.key = name;
    if (e.cell.parent == none) {
      event.text = "entered.whole";
    } else if (is_near(e.cell)) {
      event.text = "entered.near";
      event.decides = side_of_query(e.cell);
    } else if (!is_full(found())) {
      event.text = "entered.wanted";
    } else {
      event.text = "entered.far";
      event.decides = may_hold(e.cell, true);
    }
    return event;
  }
  Event say(const Off& c) const {
    const std::string name = name_of(subject_.tree.middle(c.cell));
    const std::optional<Neighbour<double>> missed = missed_in(c.cell);
    Event event = of_cell(c.cell, c.distance, found());
    event.text = missed ? "cut_off.wrong" : "cut_off";
    event.count = std::int64_t{c.cell.last - c.cell.first};
    if (missed) {
      event.words.push_back({"missed", name_of(missed->point)});
      event.words.push_back({"its", length(*missed)});
    }
    event.row = {name, c.distance, words_.say("cut"), names_of(found())};
    event.key = name;
    event.decides = may_hold(c.cell, false);
    return event;
  }
  Event say(const Seen& m) const {
    const std::string name = name_of(m.found.point);
    const dvec2 off = glm::abs(subject_.points[m.found.point] - subject_.query);
    const Found before = found_before();
    const bool full = is_full(before);
    Event event{.text = m.rank == 0 ? "measured.farther"
                        : full      ? "measured.nearer"
                                    : "measured.first",
                .facts = {{"point", name},
                          {"distance", m.found.distance},
                          {"rank", static_cast<std::int64_t>(m.rank)}},
                .words = {{"name", name},
                          {"across", off.x},
                          {"up", off.y},
                          {"square", m.found.distance},
                          {"length", length(m.found)}},
                .key = name};
    if (full) {
      event.words.push_back({"last", name_of(before.back().point)});
      event.words.push_back({"worst", before.back().distance});
      event.decides =
          yes_or_no(words_, "question.nearer", {{"name", name}, {"last", name_of(before.back().point)}},
                    m.rank > 0, "kept", "not kept");
    }
    if (kind_ == Kind::brute_force)
      event.row = {name, m.found.distance, names_of(found())};
    else
      event.read = {name, last<Into>()->distance, m.found.distance, names_of(found())};
    return event;
  }
  Event say(const Finished& f) const {
    const bool wrong = found() != right_;
    Event event{.text = wrong ? "finished.wrong" : "finished",
                .facts = {{"distances", f.distances}, {"cells", f.cells}},
                .words = {{"names", names_of(found())},
                          {"length", length(found().back())},
                          {"points", subject_.points.size()}},
                .count = std::ssize(found())};
    if (wrong) {
      const auto [ours, theirs] = std::ranges::mismatch(found(), right_);
      event.decides =
          yes_or_no(words_, "question.right", {{"names", names_of(found())}}, false, "right", "wrong");
      event.words.push_back({"right", name_of(theirs->point)});
      event.words.push_back({"its", length(*theirs)});
    }
    return event;
  }

  /// What cuts most off, or where the mistake is seen.
  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if constexpr (std::same_as<Step, Off>)
      return (step.cell.last - step.cell.first) + (missed_in(step.cell) ? 1000 : 0);
    if constexpr (std::same_as<Step, Seen>)
      return kind_ == Kind::brute_force ? static_cast<double>(all<Seen>().size()) : 0;
    if constexpr (std::same_as<Step, Finished>) return found() != right_ ? 500 : 0;
    return 0;
  }

  View draw() const {
    View view;
    if (kind_ == Kind::brute_force)
      draw_all(view);
    else
      draw_search(view);
    if (is_full(found())) plane_.add_circle(view, length(found().back()), kind_ != Kind::brute_force);
    plane_.add_query(view, words_.symbol("q"));
    return view;
  }

 private:
  static double length(const Neighbour<double>& n) { return std::sqrt(n.distance); }
  /// What is compared of a cell is its square, but for a mistake.
  double plain(double compared) const { return kind_ == Kind::unsquared ? compared : std::sqrt(compared); }

  Found found_after(std::size_t measured) const {
    Nearest<double> best(subject_.k);
    for (std::size_t i = 0; i < measured; ++i)
      best.take(all<Seen>()[i].found.distance, all<Seen>()[i].found.point);
    return best.found();
  }
  Found found() const { return found_after(all<Seen>().size()); }
  Found found_before() const { return found_after(all<Seen>().size() - 1); }
  bool is_full(const Found& found) const { return found.size() == subject_.k; }

  int axis_of(const PlaneCell& cell) const { return subject_.tree.nodes[cell.parent].axis; }
  static bool is_above(const PlaneCell& cell) { return cell.first > cell.parent; }
  bool is_near(const PlaneCell& cell) const {
    const int axis = axis_of(cell);
    return (subject_.query[axis] >= subject_.tree.at(cell.parent)[axis]) == is_above(cell);
  }
  /// "left of", "above" a line.
  std::string side(int axis, bool above) const {
    if (axis == 0) return above ? words_.say("right") : words_.say("left");
    return above ? words_.say("above") : words_.say("below");
  }
  /// The nearest right one that is lost with a cell.
  std::optional<Neighbour<double>> missed_in(const PlaneCell& cell) const {
    for (const Neighbour<double>& n : right_) {
      for (Index node = cell.first; node < cell.last; ++node) {
        if (subject_.tree.nodes[node].point == n.point) return n;
      }
    }
    return std::nullopt;
  }

  Event of_cell(const PlaneCell& cell, double distance, const Found& found) const {
    Event event{.facts = {{"point", name_of(subject_.tree.middle(cell))}, {"distance", distance}},
                .words = {{"name", name_of(subject_.tree.middle(cell))},
                          {"length", plain(distance)},
                          {"compared", distance}}};
    if (cell.parent != none) {
      event.words.push_back({"side", side(axis_of(cell), is_above(cell))});
      event.words.push_back({"parent", name_of(subject_.tree.nodes[cell.parent].point)});
    }
    if (is_full(found)) {
      event.words.push_back({"worst", found.back().distance});
      event.words.push_back({"last", name_of(found.back().point)});
    }
    return event;
  }
  Decision side_of_query(const PlaneCell& cell) const {
    const int axis = axis_of(cell);
    return {words_.say("question.side", {{"parent", name_of(subject_.tree.nodes[cell.parent].point)}}),
            {side(axis, false), side(axis, true)},
            is_above(cell) ? 1u : 0u,
            is_above(cell) ? "above" : "below"};
  }
  Decision may_hold(const PlaneCell& cell, bool yes) const {
    return yes_or_no(words_, "question.cell",
                     {{"side", side(axis_of(cell), is_above(cell))},
                      {"parent", name_of(subject_.tree.nodes[cell.parent].point)}},
                     yes, "search", "cut off");
  }

  /// Those measured, those nearest, the one at hand.
  void take_roles(Roles& roles) const {
    for (const Seen& m : all<Seen>()) roles[m.found.point] = Role::past;
    for (const Neighbour<double>& n : found()) roles[n.point] = Role::result;
    if (const Seen* m = now<Seen>(); m && m->rank == 0) roles[m->found.point] = Role::candidate;
  }
  void draw_all(View& view) const {
    Roles roles(subject_.points.size(), Role::input);
    take_roles(roles);
    plane_.add_scales(view);
    plane_.add_points(view, roles);
    for (const Seen& m : all<Seen>()) plane_.add_ray(view, m.found.point, roles[m.found.point]);
    if (const Seen* m = now<Seen>()) plane_.add_distance(view, subject_.points[m->found.point]);
  }
  void draw_search(View& view) const {
    const PlaneTree& tree = subject_.tree;
    Roles roles(subject_.points.size(), Role::input);
    for (const Off& c : all<Off>()) {
      plane_.add_cell(view, fmt::format("b cut {:02}", c.cell.middle()), c.cell, Role::rejected, false);
      for (Index node = c.cell.first; node < c.cell.last; ++node)
        roles[tree.nodes[node].point] = Role::rejected;
    }
    take_roles(roles);
    add_lines(view, tree.whole());
    plane_.add_border(view);
    const PlaneCell* cell = now<Into>() ? &now<Into>()->cell : now<Off>() ? &now<Off>()->cell : nullptr;
    if (cell) {
      if (now<Into>()) {
        plane_.add_cell(view, "c cell", *cell, Role::candidate, true);
        roles[tree.middle(*cell)] = Role::candidate;
      }
      plane_.add_distance(view, glm::clamp(subject_.query, cell->box.lower, cell->box.upper));
    }
    if (const Seen* m = now<Seen>()) plane_.add_distance(view, subject_.points[m->found.point]);
    if (now<Finished>() && found() != right_) {
      const auto [ours, theirs] = std::ranges::mismatch(found(), right_);
      roles[theirs->point] = Role::accepted;
      plane_.add_distance(view, subject_.points[theirs->point]);
    }
    plane_.add_points(view, roles);
    Roles nodes;
    for (const Node& node : tree.nodes) nodes.push_back(roles[node.point]);
    tree_.add(view, nodes, false);
    tree_.add_texts(view,
                    {words_.say("cost.distances", {{"n", all<Seen>().size()}, {"points", nodes.size()}}),
                     words_.say("cost.bytes", {{"tree", nodes.size() * sizeof(Node)},
                                               {"points", nodes.size() * sizeof(dvec2)}})});
  }
  /// That of the cell which gives way to the one at hand is strong.
  void add_lines(View& view, const PlaneCell& cell) const {
    if (cell.empty()) return;
    const PlaneCell* here = now<Into>() ? &now<Into>()->cell : now<Off>() ? &now<Off>()->cell : nullptr;
    plane_.add_line(view, cell, here && here->parent == cell.middle() ? Role::candidate : Role::boundary);
    add_lines(view, below(subject_.tree, cell));
    add_lines(view, above(subject_.tree, cell));
  }

  const Words& words_;
  const Subject& subject_;
  const PlaneDrawing& plane_;
  const TreeDrawing& tree_;
  const Kind kind_;
  const Found right_;
};

// --- The methods

template <SearchStory::Kind kind>
void tell_search(Narrator& narrator) {
  using Kind = SearchStory::Kind;
  const Subject subject = subject_of(narrator.arguments());
  constexpr bool all = kind == Kind::brute_force;
  const PlaneDrawing plane(subject, all ? whole_paper : beside_tree, true);
  const TreeDrawing tree(subject);
  require_scale(plane.panel(), narrator.arguments(), {"points", "query"});
  narrator.paper(paper_width, paper_height);
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(subject.points),
                                                     {{"query", subject.query}, {"k", subject.k}});
  narrator.handles("points", shown_in(plane.panel()));
  narrator.handles("query", shown_in(plane.panel()));
  if (all)
    narrator.columns({{"point", false}, {"distance"}, {"nearest", false}});
  else
    narrator.columns({{"cell", false},
                      {kind == Kind::unsquared ? "of_cell_plain" : "of_cell"},
                      {"of_point", false},
                      {"nearest", false}});
  narrator.legend({{Role::input, "points"},
                   {Role::boundary, "lines"},
                   {Role::measure, "query"},
                   {Role::candidate, "here"},
                   {Role::past, "measured"},
                   {Role::result, "nearest"},
                   {Role::rejected, "cut_off"},
                   {Role::accepted, "right"}});
  SearchStory story(narrator.words(), subject, plane, tree, kind);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  Found found;
  if constexpr (kind == Kind::tree)
    found = nearest<2, double>(subject.tree, subject.query, subject.k, watch);
  else if constexpr (kind == Kind::down_only)
    found = no_turning_back<2, double>(subject.tree, subject.query, subject.k, watch);
  else if constexpr (kind == Kind::unsquared)
    found = not_squared<2, double>(subject.tree, subject.query, subject.k, watch);
  else
    found = brute_force<2, double>(subject.points, subject.query, subject.k, watch);
  narrator.result({{"nearest", names_of(found)}, {"distance", found.back().distance}});
}

void tell_building(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  tell_build(narrator, subject);
}

/// The points whose distances are computed, and the cells that are cut off, in their order.
const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "points", .same = SameList::order, .type = "Measured", .fields = {"point"}},
                {.name = "middles",
                 .same = SameList::order,
                 .type = "Parted",
                 .fields = {"point"},
                 .method = "build"}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-3, 1e4};
  static const TopicEntry topic = completed<entry>(
      {.name = "kd_tree",
       .chapter = "modeling",
       .aliases = {"k-d tree", "nearest neighbour", "nearest neighbor", "point search"},
       .summary = "the nearest points of many: a tree over them leaves out each cell that lies farther away",
       .methods =
           {{.name = "nearest", .standing = Standing::taught, .tell = tell_search<SearchStory::Kind::tree>},
            {.name = "build", .tell = tell_building, .unread = {"query", "k"}},
            {.name = "brute_force", .tell = tell_search<SearchStory::Kind::brute_force>},
            {.name = "no_turning_back",
             .standing = Standing::faulty,
             .tell = tell_search<SearchStory::Kind::down_only>},
            {.name = "not_squared",
             .standing = Standing::faulty,
             .tell = tell_search<SearchStory::Kind::unsquared>,
             .opening = {{"points",
                          "0.5,0.6 1,0.4 0.1,0.7 0.9,0.8 0.8,1 0.6,0.2 0.7,1.2 0.7,0.5 0.9,0.1 0.5,1.1 "
                          "0.2,1 1,1.2"},
                         {"query", "0.2,0.4"}}}},
       .default_method = "nearest",
       .counts = {"Measured", "CutOff"},
       .parameters = {points(1, 40, "points", "5,6 10,4 1,7 9,8 8,10 6,2 7,12 7,5 9,1 5,11 2,10 10,12",
                             "0,0 4,1 2,5 6,4", "among which is searched", xy, modest),
                      numbers("query", "2,4", "3,3", "the place near which points are looked for", xy,
                              modest),
                      integer(1, 8, "k", "1", "3", "how many points are looked for")},
       .examples = {"--query 6,9", "--k 3", "--method brute_force --query 6,9"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::kd_tree
