// The story of a BSP tree: how planes of polygons part space, and how the tree gives an order to any eye.

#include "visibility/bsp_tree/bsp_tree.hpp"

#include "stories/checking.hpp"
#include "stories/visibility/bsp_tree/walk_story.hpp"
#include "visibility/bsp_tree/bsp_tree_notes.hpp"

namespace gradus::bsp_tree {
namespace {

/// Of the paper: space, the plane at hand and the tree; all of that for a plan.
constexpr Extent space_place{{0.6, 0.6}, {18.4, 23.4}}, edge_on_place{{22.4, 1.4}, {35, 10.2}},
    tree_place{{20, 12.8}, {35, 22.8}}, whole_tree_place{{21.6, 3}, {33.9, 22.8}};

// --- The tree is built

class BuildStory : public Past<steps::Started, PlaneTaken<double>, Placed<double>, Split<double>, Built> {
 public:
  /// cut: polygons on both sides of a plane are.
  BuildStory(const Words& words, const Subject& subject, const DTree& tree, bool cut)
      : words_(words),
        subject_(subject),
        tree_(tree),
        cuts_(cut),
        names_(subject.parts),
        space_(subject.reader, space_place, subject.points),
        plan_(plan_of(subject, tree, picture_place)),
        drawing_(tree, plan_ ? whole_tree_place : tree_place),
        whole_(tree, whole_tree_place) {
    for (const DPolygon& polygon : subject.polygons) pieces_.push_back({polygon, none, false});
  }

  template <class Step>
  void take(const Step& step) {
    Past::take(step);
    follow(step);
  }

  dvec2 at(dvec3 p) const { return space_.at(p); }
  bool is_plan() const { return plan_.has_value(); }

  Event say(const steps::Started&) const {
    return {.text = "started", .count = std::ssize(pieces_), .level = Level::idea};
  }

  Event say(const PlaneTaken<double>& t) const {
    const bool root = t.parent == none;
    return {.text = std::string(t.others == 0 ? "alone." : "taken.") + (root         ? "root"
                                                                        : t.in_front ? "front"
                                                                                     : "behind"),
            .facts = {{"node", static_cast<std::int64_t>(t.node)},
                      {"others", static_cast<std::int64_t>(t.others)}},
            .words = {{"name", names_(t.polygon)}, {"parent", root ? "" : name_of(t.parent)}},
            .key = names_(t.polygon)};
  }

  Event say(const Placed<double>& p) const {
    constexpr std::array<const char*, 4> texts{"in_plane", "in_front", "behind", "both"};
    constexpr std::array<const char*, 4> branches{"in the plane", "in front", "behind", "both sides"};
    const auto side = static_cast<std::size_t>(p.side);
    const auto [front, behind] = counts(p.polygon);
    const bool torn = front > 0 && behind > 0 && p.side != Side::both;
    const std::string &name = names_(p.polygon), &plane = names_(plane_taken());
    std::vector<std::string> answers;
    for (int i = 0; i < 4; ++i) answers.push_back(words_.say(fmt::format("side.{}", i)));
    return {.text = std::string(torn ? "torn." : "placed.") + texts[side],
            .facts = {{"in_front", front}, {"behind", behind}},
            .words = {{"name", name}, {"plane", plane}},
            .row = {plane, name, front, behind, answers[side]},
            .key = name,
            .decides = Decision{words_.say("question", {{"name", name}, {"plane", plane}}), answers, side,
                                branches[side]}};
  }
  Event say(const Split<double>& s) const {
    const std::string name = names_(s.in_front);
    return {.text = "split",
            .facts = {{"corners_in_front", std::ssize(s.in_front.corners)},
                      {"corners_behind", std::ssize(s.behind.corners)}},
            .words = {{"whole", names_(last<Placed<double>>()->polygon)},
                      {"plane", names_(plane_taken())},
                      {"front", name},
                      {"behind", names_(s.behind)}},
            .key = name};
  }

  Event say(const Built& b) const {
    Event event{.text = "built",
                .facts = {{"nodes", static_cast<std::int64_t>(b.nodes)},
                          {"polygons", static_cast<std::int64_t>(b.polygons)}},
                .words = {{"faces", subject_.polygons.size()}},
                .ends = true};
    if (cuts_) return event;
    const auto wrong = wrongly_covered();
    event.text = wrong ? "built.wrong" : "built.right";
    if (wrong)
      event.words.insert(event.words.end(),
                         {{"over", names_(wrong->first)}, {"under", names_(wrong->second)}});
    return event;
  }

  /// The test by which most is on one side or the other tells most.
  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if (!std::same_as<Step, Placed<double>>) return 0;
    return static_cast<double>(
        std::ranges::count_if(pieces_, [](const Piece& p) { return p.side.has_value(); }));
  }

  View draw() const {
    View view;
    if (plan_ && (cuts_ || !now<Built>()))
      add_plan(view);
    else
      add_space(view);
    add_tree(view);
    return view;
  }

 private:
  /// A polygon or a part of one, and where it belongs by now.
  struct Piece {
    DPolygon polygon;
    std::size_t parent;  ///< the node below which it belongs
    bool in_front;
    std::size_t node = none;  ///< that it lies in
    bool here = true;         ///< it lies in the subspace that is parted now
    std::optional<Side> side{};
  };

  void follow(const auto&) {}
  void follow(const PlaneTaken<double>& t) {
    for (Piece& piece : pieces_) {
      if (same(piece.polygon, t.polygon)) piece.node = t.node;
      piece.here = piece.node == none && piece.parent == t.parent &&
                   (t.parent == none || piece.in_front == t.in_front);
      piece.side = std::nullopt;
    }
  }
  void follow(const Placed<double>& p) {
    Piece& piece = *std::ranges::find_if(
        pieces_, [&](const Piece& other) { return same(other.polygon, p.polygon) && other.node == none; });
    piece.side = p.side;
    if (p.side == Side::in_plane) piece.node = p.node;
    if (p.side != Side::in_front && p.side != Side::behind) return;
    piece.parent = p.node;
    piece.in_front = p.side == Side::in_front;
  }
  void follow(const Split<double>& s) {
    const DPolygon& whole = last<Placed<double>>()->polygon;
    names_.cut(whole, s.in_front, s.behind);
    std::erase_if(pieces_, [&](const Piece& piece) { return same(piece.polygon, whole); });
    pieces_.push_back({s.in_front, s.node, true, none, true, Side::in_front});
    pieces_.push_back({s.behind, s.node, false, none, true, Side::behind});
  }

  const DPolygon& plane_taken() const { return last<PlaneTaken<double>>()->polygon; }
  const std::string& name_of(std::size_t node) const {
    return names_(all<PlaneTaken<double>>()[node].polygon);
  }
  /// Where the cut at hand goes through.
  std::optional<std::pair<dvec3, dvec3>> cut() const {
    const auto* split = now<Split<double>>();
    if (!split) return std::nullopt;
    std::vector<dvec3> common;
    for (const dvec3 p : split->in_front.corners) {
      if (std::ranges::find(split->behind.corners, p) != split->behind.corners.end()) common.push_back(p);
    }
    return common.size() < 2 ? std::nullopt : std::optional(std::pair(common[0], common[1]));
  }
  /// Of corners in front of the plane at hand and behind it.
  std::pair<std::int64_t, std::int64_t> counts(const DPolygon& polygon) const {
    const auto all = sides(plane_taken().plane, polygon, ExactSide{});
    return {std::ranges::count(all, 1), std::ranges::count(all, -1)};
  }

  std::vector<DPolygon> painted() const {
    std::vector<DPolygon> order;
    back_to_front(tree_, Eye<double>(subject_.reader.towards, 0),
                  [&](const DPolygon& p) { order.push_back(p); });
    return order;
  }
  /// A polygon that is painted over one in front of it, and that one.
  std::optional<std::pair<DPolygon, DPolygon>> wrongly_covered() const {
    const std::vector<DPolygon> order = painted();
    for (std::size_t late = 0; late < order.size(); ++late) {
      for (std::size_t early = 0; early < late; ++early) {
        if (covers(order[early], order[late])) return std::pair(order[late], order[early]);
      }
    }
    return std::nullopt;
  }
  /// Whether the first hides some of the other's border.
  bool covers(const DPolygon& first, const DPolygon& other) const {
    const std::vector<std::vector<dvec3>> rings{first.corners};
    const HiddenLines lines(rings, distant_viewer(subject_.reader.towards),
                            length_between(first.corners[0], first.corners[2]));
    return std::ranges::any_of(sides_of(other.corners), [&](const auto& side) {
      return std::ranges::any_of(lines.pieces(side.first, side.second), &SightPiece::hidden);
    });
  }

  static Role side_role(bool in_front) { return in_front ? Role::accepted : Role::rejected; }
  Role role_of(const Piece& piece) const {
    if (now<Built>()) return Role::result;
    if (const auto* taken = last<PlaneTaken<double>>(); taken && piece.node == taken->node)
      return Role::boundary;
    if (const auto* placed = now<Placed<double>>(); placed && same(piece.polygon, placed->polygon))
      return Role::current;
    if (!piece.here || piece.node != none) return Role::past;
    if (piece.side == Side::in_front) return Role::accepted;
    if (piece.side == Side::behind) return Role::rejected;
    return Role::input;
  }

  void add_plan(View& view) const {
    const auto* taken = last<PlaneTaken<double>>();
    if (now<Built>()) {
      for (std::size_t i = 0; const auto& [node, in_front] : whole_.leaves())
        plan_->add_region(view, node, in_front, side_role(in_front), fmt::format("{}", ++i));
    } else if (taken) {
      for (const bool in_front : {true, false})
        plan_->add_region(view, taken->node, in_front, side_role(in_front));
    }
    plan_->add_border(view);
    for (const PlaneTaken<double>& t : all<PlaneTaken<double>>()) {
      const bool at_hand = &t == taken && !now<Built>();
      plan_->add_line(view, t.node,
                      at_hand        ? Role::boundary
                      : now<Built>() ? Role::result
                                     : Role::past,
                      at_hand);
    }
    for (const Piece& piece : pieces_) {
      const Role role = role_of(piece);
      plan_->add_wall(view, piece.polygon, role, names_(piece.polygon), role == Role::current);
    }
    if (const auto edge = cut()) plan_->add_dot(view, "s cut", Role::measure, edge->first);
  }
  void add_space(View& view) const {
    const auto face = [&](const DPolygon& polygon, Role role) {
      return ShownFace{names_(polygon), polygon.corners, role};
    };
    if (now<Built>() && !cuts_) {
      space_.add_painted(view, mapped(painted(), [&](const DPolygon& p) { return face(p, Role::result); }));
    } else {
      std::vector<SpaceEdge> lines;
      if (const auto edge = cut())
        lines.push_back(
            {.id = "c cut", .role = Role::measure, .a = edge->first, .b = edge->second, .behind = false});
      space_.add(view,
                 mapped(pieces_, [&](const Piece& piece) { return face(piece.polygon, role_of(piece)); }),
                 lines);
    }
    if (last<PlaneTaken<double>>() && !now<Built>()) add_edge_on(view);
  }
  void add_edge_on(View& view) const {
    std::vector<DPolygon> here;
    for (const Piece& piece : pieces_) {
      if (piece.here || piece.node == last<PlaneTaken<double>>()->node) here.push_back(piece.polygon);
    }
    const EdgeOnPicture picture(edge_on_place, plane_taken().plane, subject_.reader, here);
    picture.add_plane(view, words_.say("plane", {{"name", names_(plane_taken())}}));
    for (const Piece& piece : pieces_) {
      if (!piece.here || piece.node != none) continue;
      const Role role = role_of(piece);
      picture.add_polygon(view, piece.polygon, role, names_(piece.polygon), role == Role::current);
    }
    if (const auto edge = cut()) picture.add_cut(view, edge->first, edge->second);
    add_caption(view, "e caption", edge_on_place, words_.say("caption.edge_on"), 1, true);
  }
  void add_tree(View& view) const {
    const TreeDrawing& drawing = now<Built>() ? whole_ : drawing_;
    const auto lies_in = [](std::size_t node) {
      return [node](const Placed<double>& p) { return p.side == Side::in_plane && p.node == node; };
    };
    for (const PlaneTaken<double>& t : all<PlaneTaken<double>>()) {
      const bool last_one = &t == last<PlaneTaken<double>>();
      const Role role = now<Built>() ? Role::result : last_one ? Role::boundary : Role::past;
      const bool more = std::ranges::any_of(all<Placed<double>>(), lies_in(t.node));
      drawing.add_node(view, t.node, role, names_(t.polygon) + (more ? "…" : ""));
      if (t.parent != none) drawing.add_branch(view, t.parent, t.node, t.in_front, role);
    }
    // What waits on either side of a plane, coloured as in space
    std::map<std::pair<std::size_t, bool>, std::pair<Role, std::vector<std::string>>> waiting;
    for (const Piece& piece : pieces_) {
      if (piece.node != none || piece.parent == none) continue;
      if (piece.here && !piece.side) continue;
      auto& [role, names] = waiting[{piece.parent, piece.in_front}];
      role = piece.here ? side_role(piece.in_front) : Role::past;
      names.push_back(names_(piece.polygon));
    }
    for (const auto& [place, list] : waiting) {
      const auto& [parent, in_front] = place;
      const std::size_t child = in_front ? tree_[parent].in_front : tree_[parent].behind;
      drawing.add_branch(view, parent, child, in_front, list.first);
      drawing.add_waiting(view, child, list.first, list.second);
    }
    for (std::size_t i = 0; plan_ && cuts_ && now<Built>() && i < drawing.leaves().size(); ++i)
      drawing.add_leaf(view, i, side_role(drawing.leaves()[i].second), fmt::format("{}", i + 1));
  }

  const Words& words_;
  const Subject& subject_;
  const DTree& tree_;
  const bool cuts_;
  PartNames names_;
  FacesPicture space_;
  const std::optional<Plan> plan_;
  TreeDrawing drawing_, whole_;  ///< as it grows, and in the end
  std::vector<Piece> pieces_;
};

// --- The methods

void set_up(Narrator& narrator, const Subject& subject) {
  narrator.paper(paper_width, paper_height);
  narrator.subtitle(direction_of_walls(subject.polygons) ? "subtitle.plan" : "subtitle",
                    {{"count", subject.polygons.size()}});
}

template <bool cut>
void tell_build(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject);
  narrator.legend({{Role::boundary, "plane"},
                   {Role::current, "current"},
                   {Role::accepted, "in_front"},
                   {Role::rejected, "behind"}});
  if (cut) narrator.add_to_legend(Role::measure, "cut");
  narrator.add_to_legend(Role::past, "elsewhere");
  narrator.add_to_legend(Role::result, "done");
  const auto built = [&](auto&&... watch) {
    return cut ? build(subject.polygons, ExactSide{}, watch...)
               : build_uncut(subject.polygons, ExactSide{}, watch...);
  };
  const DTree tree = built();
  BuildStory story(narrator.words(), subject, tree, cut);
  // A wall moved by one corner stands no longer
  if (!story.is_plan()) narrator.handles("faces", [&](dvec3 p) { return story.at(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  built(watch);
  std::vector<Field> result{{"nodes", std::ssize(tree)}};
  if (cut) result.push_back({"polygons", static_cast<std::int64_t>(polygon_count(tree))});
  narrator.result(result);
}

/// The names that parts have got while the tree was built.
PartNames names_after(const Subject& subject) {
  PartNames names(subject.parts);
  DPolygon whole;
  build(subject.polygons, ExactSide{}, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Placed<double>>) whole = step.polygon;
    if constexpr (std::same_as<Step, Split<double>>) names.cut(whole, step.in_front, step.behind);
  });
  return names;
}

void tell_walk(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject);
  narrator.columns({{"number"}, {"polygon", false}, {"eye", false}});
  narrator.legend({{Role::current, "now"},
                   {Role::accepted, "first"},
                   {Role::candidate, "last"},
                   {Role::input, "drawn"},
                   {Role::past, "waiting"},
                   {Role::result, "whole"},
                   {Role::measure, "eye"}});
  const DTree tree = build(subject.polygons);
  WalkStory story(narrator.words(), subject, tree, names_after(subject));
  if (story.plan())
    narrator.handles("towards", [&](dvec3 p) { return story.plan()->eye_at(p); });
  else
    narrator.handles("faces", [&](dvec3 p) { return story.at(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  back_to_front(tree, Eye<double>(subject.reader.towards, 0), [](const DPolygon&) {}, watch);
  watch(steps::Finished{}, 0);
  narrator.result({{"polygons", static_cast<std::int64_t>(polygon_count(tree))}});
}

const Checking& checking() {
  static const Checking known{.asked = {{.name = "order",
                                         .same = SameList::order,
                                         .type = "Drawn",
                                         .fields = {"key"},
                                         .method = "back_to_front"}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic = completed<entry>(
      {.name = "bsp_tree",
       .chapter = "visibility",
       .aliases = {"bsp", "binary space partitioning"},
       .summary =
           "planes of polygons part space into a tree that gives every eye an order from back to front",
       .methods = {{.name = "build", .standing = Standing::taught, .tell = tell_build<true>},
                   {.name = "back_to_front", .tell = tell_walk},
                   {.name = "uncut",
                    .standing = Standing::faulty,
                    .tell = tell_build<false>,
                    .function = "build_uncut"}},
       .default_method = "build",
       .columns = {{"plane", false}, {"polygon", false}, {"in_front"}, {"behind"}, {"side", false}},
       .counts = {"Split", "Drawn"},
       .parameters = {faces_subject::faces_parameter(
                          "A: 7,0,8 6,0,5 6,3,5 7,3,8; B: 11,0,6 8,0,3 8,3,3 11,3,6; "
                          "C: 2,0,9 2,3,9 11,3,12 11,0,12",
                          "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 3,1,-1 3,1,2 1,1,2"),
                      faces_subject::towards_parameter("1,1,2")},
       .examples = {"--method back_to_front", "--method uncut",
                    "--faces 'A: 0,0,0 4,0,0 4,3,0 0,3,0; B: 1,1,-2 3,1,-2 3,1,2 1,1,2' --towards 1,2,3"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::bsp_tree
