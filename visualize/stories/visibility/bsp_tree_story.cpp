// The story of a BSP tree: how planes of polygons part space, and how the tree gives an order to any eye.

#include "visibility/bsp_tree/bsp_tree.hpp"

#include "stories/checking.hpp"
#include "stories/visibility/bsp_tree_walk.hpp"
#include "visibility/bsp_tree/bsp_tree_notes.hpp"

namespace gradus::bsp_tree {
namespace {

/// Of the paper: space, the plane at hand and the tree.
constexpr Extent space_place{{0.6, 0.6}, {18.4, 23.4}}, edge_on_place{{22.4, 1.4}, {35, 10.2}},
    tree_place{{20, 12.8}, {35, 22.8}};

// --- The tree is built

class BuildStory {
 public:
  /// cut: polygons on both sides of a plane are.
  BuildStory(const Words& words, const Task& task, const DTree& tree, bool cut)
      : words_(words),
        task_(task),
        tree_(tree),
        cuts_(cut),
        names_(task.parts),
        space_(task.reader, space_place, task.points),
        drawing_(tree, tree_place) {
    for (const DPolygon& polygon : task.polygons) pieces_.push_back({polygon, none, false});
  }

  const FacesPicture& space() const { return space_; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    return {.text = "started", .count = std::ssize(pieces_), .begins = true, .level = Level::idea};
  }

  void show(Board& board, const PlaneTaken<double>& t) {
    forget();
    node_ = t.node;
    plane_ = t.polygon;
    nodes_.push_back({t.parent, t.in_front, {names_(t.polygon)}});
    for (Piece& piece : pieces_) {
      if (same(piece.polygon, t.polygon)) piece.node = t.node;
      piece.here = piece.node == none && piece.parent == t.parent &&
                   (t.parent == none || piece.in_front == t.in_front);
      piece.side = std::nullopt;
    }
    put(board);
  }
  Event say(const PlaneTaken<double>& t) const {
    const bool root = t.parent == none;
    std::string_view text = root ? "taken.root" : t.in_front ? "taken.front" : "taken.behind";
    if (t.others == 0) text = root ? "alone.root" : t.in_front ? "alone.front" : "alone.behind";
    return {.text = text,
            .facts = {{"node", static_cast<std::int64_t>(t.node)},
                      {"others", static_cast<std::int64_t>(t.others)}},
            .words = {{"name", names_(t.polygon)},
                      {"parent", root ? "" : nodes_[t.parent].names.front()},
                      {"others", t.others}},
            .key = names_(t.polygon)};
  }

  void show(Board& board, const Placed<double>& p) {
    forget();
    current_ = p.polygon;
    Piece& piece = piece_of(p.polygon);
    piece.side = p.side;
    if (p.side == Side::in_plane) {
      piece.node = p.node;
      nodes_[p.node].names.push_back(names_(p.polygon));
    }
    if (p.side == Side::in_front || p.side == Side::behind) move(piece, p.node, p.side == Side::in_front);
    put(board);
  }
  Event say(const Placed<double>& p) const {
    constexpr std::array<std::string_view, 4> texts{"placed.in_plane", "placed.in_front", "placed.behind",
                                                    "placed.both"};
    constexpr std::array<const char*, 4> branches{"in the plane", "in front", "behind", "both sides"};
    const auto side = static_cast<std::size_t>(p.side);
    const auto [front, behind] = counts(p.polygon);
    const bool torn = front > 0 && behind > 0 && p.side != Side::both;
    return {
        .text = !torn                      ? texts[side]
                : p.side == Side::in_front ? "torn.in_front"
                                           : "torn.behind",
        .facts = {{"in_front", front}, {"behind", behind}},
        .words = {{"name", names_(p.polygon)}, {"plane", names_(plane_)}},
        .row = {names_(plane_), names_(p.polygon), front, behind, words_.say(fmt::format("side.{}", side))},
        .key = names_(p.polygon),
        .decides =
            Decision{words_.say("question", {{"name", names_(p.polygon)}, {"plane", names_(plane_)}}),
                     {words_.say("side.0"), words_.say("side.1"), words_.say("side.2"), words_.say("side.3")},
                     side,
                     branches[side]}};
  }

  void show(Board& board, const Split<double>& s) {
    const DPolygon whole = *current_;
    names_.cut(whole, s.in_front, s.behind);
    std::erase_if(pieces_, [&](const Piece& piece) { return same(piece.polygon, whole); });
    for (const bool in_front : {true, false}) {
      pieces_.push_back({in_front ? s.in_front : s.behind, s.node, in_front});
      pieces_.back().here = true;
      pieces_.back().side = in_front ? Side::in_front : Side::behind;
    }
    cut_ = common_edge(s.in_front, s.behind);
    current_.reset();
    parts_ = {s.in_front, s.behind};
    put(board);
  }
  Event say(const Split<double>& s) const {
    const std::string name = names_(s.in_front);
    return {.text = "split",
            .facts = {{"corners_in_front", std::ssize(s.in_front.corners)},
                      {"corners_behind", std::ssize(s.behind.corners)}},
            .words = {{"plane", names_(plane_)}, {"front", name}, {"behind", names_(s.behind)}},
            .key = name};
  }

  void show(Board& board, const Built&) {
    forget();
    done_ = true;
    put(board);
  }
  Event say(const Built& b) const {
    Event event{.text = "built",
                .facts = {{"nodes", static_cast<std::int64_t>(b.nodes)},
                          {"polygons", static_cast<std::int64_t>(b.polygons)}},
                .words = {{"nodes", b.nodes}, {"polygons", b.polygons}, {"faces", task_.polygons.size()}},
                .ends = true};
    if (cuts_) return event;
    event.text = "built.right";
    if (const auto wrong = wrongly_covered()) {
      event.text = "built.wrong";
      event.words.insert(event.words.end(),
                         {{"over", names_(wrong->first)}, {"under", names_(wrong->second)}});
    }
    return event;
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
  struct NodeShown {
    std::size_t parent;
    bool in_front;
    std::vector<std::string> names;
  };

  Piece& piece_of(const DPolygon& polygon) {
    return *std::ranges::find_if(
        pieces_, [&](const Piece& piece) { return same(piece.polygon, polygon) && piece.node == none; });
  }
  static void move(Piece& piece, std::size_t node, bool in_front) {
    piece.parent = node;
    piece.in_front = in_front;
  }
  void forget() {
    current_.reset();
    cut_.reset();
    parts_.clear();
  }
  static std::optional<std::pair<dvec3, dvec3>> common_edge(const DPolygon& a, const DPolygon& b) {
    std::vector<dvec3> common;
    for (const dvec3 p : a.corners) {
      if (std::ranges::find(b.corners, p) != b.corners.end()) common.push_back(p);
    }
    if (common.size() < 2) return std::nullopt;
    return std::pair(common[0], common[1]);
  }
  /// Of corners in front of the plane at hand and behind it.
  std::pair<std::int64_t, std::int64_t> counts(const DPolygon& polygon) const {
    const auto all = sides(plane_.plane, polygon, ExactSide{});
    return {std::ranges::count(all, 1), std::ranges::count(all, -1)};
  }

  std::vector<DPolygon> painted() const {
    std::vector<DPolygon> order;
    back_to_front(tree_, Eye<double>(task_.reader.towards, 0),
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
    const HiddenLines lines(rings, distant_viewer(task_.reader.towards),
                            length_between(first.corners[0], first.corners[2]));
    for (std::size_t i = 0; i < other.corners.size(); ++i) {
      const auto pieces = lines.pieces(other.corners[i], other.corners[(i + 1) % other.corners.size()]);
      if (std::ranges::any_of(pieces, &SightPiece::hidden)) return true;
    }
    return false;
  }

  Role role_of(const Piece& piece) const {
    if (done_) return Role::result;
    if (piece.node == node_ && node_ != none) return Role::boundary;
    if (current_ && same(piece.polygon, *current_)) return Role::current;
    if (!piece.here || piece.node != none) return Role::past;
    if (piece.side == Side::in_front) return Role::accepted;
    if (piece.side == Side::behind) return Role::rejected;
    return Role::input;
  }

  void put(Board& board) const {
    View view;
    std::vector<ShownFace> faces;
    for (const Piece& piece : pieces_)
      faces.push_back({names_(piece.polygon), piece.polygon.corners, role_of(piece)});
    std::vector<SpaceEdge> lines;
    if (cut_)
      lines.push_back(
          {.id = "c cut", .role = Role::measure, .a = cut_->first, .b = cut_->second, .behind = false});
    if (done_ && !cuts_) {
      std::vector<ShownFace> pile;
      for (const DPolygon& polygon : painted())
        pile.push_back({names_(polygon), polygon.corners, Role::result});
      space_.add_painted(view, std::move(pile));
    } else {
      space_.add(view, faces, lines);
    }
    if (node_ != none && !done_) add_edge_on(view);
    add_tree(view);
    board.milestone(std::move(view));
  }
  void add_edge_on(View& view) const {
    std::vector<DPolygon> here;
    for (const Piece& piece : pieces_) {
      if (piece.here || piece.node == node_) here.push_back(piece.polygon);
    }
    const EdgeOnPicture picture(edge_on_place, plane_.plane, task_.reader, here);
    picture.add_plane(view, words_.say("plane", {{"name", names_(plane_)}}));
    for (const Piece& piece : pieces_) {
      if (!piece.here || piece.node != none) continue;
      const Role role = role_of(piece);
      picture.add_polygon(view, piece.polygon, role, names_(piece.polygon), role == Role::current);
    }
    if (cut_) picture.add_cut(view, cut_->first, cut_->second);
    view.add({"e caption", Role::guide,
              Text{{edge_on_place.centre().x, edge_on_place.upper.y + 1}, words_.say("caption.edge_on")}});
  }
  void add_tree(View& view) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const NodeShown& node = nodes_[i];
      const Role role = done_ ? Role::result : i == node_ ? Role::boundary : Role::past;
      const std::string more = node.names.size() > 1 ? "…" : "";
      drawing_.add_node(view, i, role, node.names.front() + more);
      if (node.parent != none) drawing_.add_branch(view, node.parent, i, node.in_front, role);
    }
  }

  const Words& words_;
  const Task& task_;
  const DTree& tree_;
  const bool cuts_;
  PartNames names_;
  FacesPicture space_;
  TreeDrawing drawing_;
  std::vector<Piece> pieces_;
  std::vector<NodeShown> nodes_{};
  std::size_t node_ = none;  ///< whose plane is at hand
  DPolygon plane_{};
  std::optional<DPolygon> current_{};
  std::vector<DPolygon> parts_{};
  std::optional<std::pair<dvec3, dvec3>> cut_{};
  bool done_ = false;
};

// --- The methods

void set_up(Narrator& narrator, const Task& task) {
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"count", task.polygons.size()}, {"towards", task.reader.towards}});
}

void let_drag(Narrator& narrator, const FacesPicture& picture) {
  narrator.handles("faces", [&](dvec3 p) { return picture.at(p); });
}

void tell_build(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  set_up(narrator, task);
  narrator.legend({{Role::boundary, "plane"},
                   {Role::current, "current"},
                   {Role::accepted, "in_front"},
                   {Role::rejected, "behind"},
                   {Role::measure, "cut"},
                   {Role::past, "elsewhere"},
                   {Role::result, "done"}});
  const DTree tree = build(task.polygons);
  BuildStory story(narrator.words(), task, tree, true);
  let_drag(narrator, story.space());
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  build(task.polygons, ExactSide{}, watch);
  narrator.result({{"nodes", static_cast<std::int64_t>(tree.size())},
                   {"polygons", static_cast<std::int64_t>(polygon_count(tree))}});
}

/// The names that parts have got while the tree was built.
PartNames names_after(const Task& task) {
  PartNames names(task.parts);
  DPolygon whole;
  build(task.polygons, ExactSide{}, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Placed<double>>) whole = step.polygon;
    if constexpr (std::same_as<Step, Split<double>>) names.cut(whole, step.in_front, step.behind);
  });
  return names;
}

void tell_walk(Narrator& narrator, const Task& task, const DTree& tree, PartNames names) {
  set_up(narrator, task);
  narrator.columns({{"number"}, {"polygon", false}, {"eye", false}});
  narrator.legend(
      {{Role::current, "now"}, {Role::input, "drawn"}, {Role::past, "waiting"}, {Role::result, "whole"}});
  WalkStory story(narrator.words(), task, tree, std::move(names));
  let_drag(narrator, story.picture());
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto drop = [](const DPolygon&) {};
  back_to_front(tree, Eye<double>(task.reader.towards, 0), drop, watch);
  watch(steps::Finished{}, 0);
  narrator.result({{"polygons", static_cast<std::int64_t>(polygon_count(tree))}});
}

void tell_back_to_front(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  tell_walk(narrator, task, build(task.polygons), names_after(task));
}

void tell_uncut(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  set_up(narrator, task);
  narrator.legend({{Role::boundary, "plane"},
                   {Role::current, "current"},
                   {Role::accepted, "in_front"},
                   {Role::rejected, "behind"},
                   {Role::past, "elsewhere"},
                   {Role::result, "done"}});
  const DTree tree = build_uncut(task.polygons);
  BuildStory story(narrator.words(), task, tree, false);
  let_drag(narrator, story.space());
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  build_uncut(task.polygons, ExactSide{}, watch);
  narrator.result({{"nodes", static_cast<std::int64_t>(tree.size())}});
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
       .methods =
           {{.name = "build", .standing = Standing::taught, .tell = tell_build},
            {.name = "back_to_front", .tell = tell_back_to_front},
            {.name = "uncut", .standing = Standing::faulty, .tell = tell_uncut, .function = "build_uncut"}},
       .default_method = "build",
       .columns = {{"plane", false}, {"polygon", false}, {"in_front"}, {"behind"}, {"side", false}},
       .parameters = {faces_task::faces_parameter(
                          "A: -6.2,-3.6,-1.2 6.2,-3.6,1.2 6.2,-1.6,1.2 -6.2,-1.6,-1.2; "
                          "B: 6.2,-3.6,-1.2 0,7.1,1.2 -1.7,6.1,1.2 4.5,-4.6,-1.2; "
                          "C: 0,7.2,-1.2 -6.2,-3.5,1.2 -4.5,-4.5,1.2 1.7,6.2,-1.2",
                          "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 3,1,-1 3,1,2 1,1,2"),
                      faces_task::towards_parameter("0.2,-0.4,1")},
       .examples = {"--method back_to_front", "--method uncut",
                    "--faces 'A: 0,0,0 4,0,0 4,3,0 0,3,0; B: 1,1,-2 3,1,-2 3,1,2 1,1,2' --towards 1,2,3"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::bsp_tree
