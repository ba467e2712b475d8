// The story of CSG trees: where a ray is in each leaf and in each node, whether a point is inside, and what
// is computed again when a leaf changes.

#include "modeling/csg_tree/csg_tree.hpp"

#include "modeling/csg_tree/csg_tree_notes.hpp"
#include "stories/modeling/csg_tree/checking.hpp"
#include "stories/modeling/csg_tree/edit_story.hpp"
#include "stories/modeling/csg_tree/membership_story.hpp"
#include "stories/parameters.hpp"

namespace gradus::csg_tree {
namespace {

enum class Kind { right, exchanged, cracked };

/// The method, watched.
template <class Watch>
void run(Kind kind, const DNodes& tree, const DRay& ray, Watch&& watch) {
  if (kind == Kind::exchanged)
    exchanged<double>(tree, ray, watch);
  else if (kind == Kind::cracked)
    cracked<double>(tree, ray, watch);
  else
    along_ray<double>(tree, ray, watch);
}
/// The tree that a method evaluates.
DNodes made_by(Kind kind, DNodes tree) {
  for (Node<double>& node : tree) {
    if (kind == Kind::exchanged) std::swap(node.a, node.b);
  }
  return tree;
}
/// The ends of all nodes.
auto along(Kind kind) {
  return [kind](const DNodes& tree, const DRay& ray) {
    std::vector<DEnds> on;
    run(kind, tree, ray, [&](const auto& step) { on.push_back(step.ends); });
    return on;
  };
}

class RayStory : public Past<steps::Started, LeafHit<double>, NodeMerged<double>, steps::Finished> {
 public:
  RayStory(const Words& words, const Subject& subject, Kind kind)
      : words_(words),
        subject_(subject),
        kind_(kind),
        drawing_(subject, made_by(kind, subject.tree), extent_of(subject), along(kind)) {}

  const RayDrawing& drawing() const { return drawing_; }

  Event say(const steps::Started&) const {
    const auto leaves = subject_.leaves().size();
    return {.text = "started",
            .words = {{"leaves", leaves}, {"operations", subject_.tree.size() - leaves}},
            .level = Level::idea};
  }
  Event say(const LeafHit<double>& l) const {
    Event event = event_of(l.node, l.ends);
    event.text = l.ends.empty() ? "leaf_hit.none" : "leaf_hit";
    return event;
  }
  Event say(const NodeMerged<double>& m) const {
    Event event = event_of(m.node, m.ends);
    const auto& [op, a, b, solid] = subject_.tree[m.node];
    event.text = op == Op::unite       ? "merged.unite"
                 : op == Op::intersect ? "merged.intersect"
                                       : "merged.subtract";
    if (m.ends.empty()) event.text = "merged.none";
    const bool turned = kind_ == Kind::exchanged && op == Op::subtract;
    if (turned) event.text = "merged.exchanged";
    const std::optional<double> crack = crack_in(m.ends);
    if (crack) {
      event.text = "merged.cracked";
      event.words.push_back({"crack", *crack});
    }
    event.words.push_back({"a", name_of(subject_.tree, a)});
    event.words.push_back({"b", name_of(subject_.tree, b)});
    event.decides = parts(m);
    return event;
  }
  Event say(const steps::Finished&) const {
    const DEnds ends = known().back();
    return {.text = kind_ == Kind::right ? "finished" : "finished.wrong",
            .words = {{"length", length_in(ends)}, {"last", subject_.ray().last}, {"ends", text_of(ends)}}};
  }
  /// The root, above all that it is made of.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, NodeMerged<double>>)
      return static_cast<double>(step.node);
    return 0;
  }

  View draw() const {
    View view;
    const std::vector<DEnds> ends = known();
    const bool done = now<steps::Finished>();
    const Index shown = ends.empty() || done ? subject_.root() : ends.size() - 1;
    const Role role = done || ends.empty() ? Role::result : Role::current;
    drawing_.add_picture(view);
    drawing_.section().add_region(view, "a region", role, shown);
    drawing_.section().add_leaves(view);
    drawing_.section().add_ray(view, words_.symbol("t"));
    const Node<double>& node = subject_.tree[shown];
    for (Index i = 0; i < subject_.tree.size(); ++i) {
      const bool is_known = i < ends.size();
      const bool read = !ends.empty() && !done && !is_leaf(node) && (i == node.a || i == node.b);
      const Role its = !is_known ? Role::guide : i == shown ? role : read ? Role::candidate : Role::past;
      drawing_.rows().add_name(view, i, its, row_name(subject_.tree, i));
      if (is_known) drawing_.add_bar(view, i, its, ends[i]);
    }
    if (!ends.empty()) {
      drawing_.section().add_inside(view, role, ends[shown]);
      drawing_.add_drops(view, shown, role, ends[shown]);
    }
    drawing_.add_scale(view, words_.symbol("t"));
    return view;
  }

 private:
  /// Of the nodes so far.
  std::vector<DEnds> known() const {
    std::vector<DEnds> on(all<LeafHit<double>>().size() + all<NodeMerged<double>>().size());
    for (const auto& l : all<LeafHit<double>>()) on[l.node] = l.ends;
    for (const auto& m : all<NodeMerged<double>>()) on[m.node] = m.ends;
    return on;
  }
  static std::optional<double> crack_in(const DEnds& ends) {
    const auto twice = std::ranges::adjacent_find(ends);
    return twice == ends.end() ? std::nullopt : std::optional(*twice);
  }
  Decision parts(const NodeMerged<double>& m) const {
    const Index most = std::max<Index>(3, m.ends.size() / 2);
    std::vector<std::string> answers;
    for (Index k = 0; k <= most; ++k) answers.push_back(fmt::format("{}", k));
    return {words_.say("question.parts", {{"name", name_of(subject_.tree, m.node)}}), answers,
            m.ends.size() / 2,
            m.ends.empty()       ? "none"
            : m.ends.size() == 2 ? "one"
                                 : "several"};
  }
  Event event_of(Index node, const DEnds& ends) const {
    const std::string name = name_of(subject_.tree, node), what = what_of(words_, subject_, node);
    return {.facts = {{"parts", static_cast<std::int64_t>(ends.size() / 2)}, {"length", length_in(ends)}},
            .words = {{"name", name}, {"what", what}, {"ends", text_of(ends)}},
            .note = row_name(subject_.tree, node),
            .row = {name, what, text_of(ends)},
            .key = name};
  }

  const Words& words_;
  const Subject& subject_;
  const Kind kind_;
  RayDrawing drawing_;
};

/// A ray may be too short for its section, too: its bars would have no place there.
void require_length(const Subject& subject, const Section& section) {
  const Extent shown = section.panel().shown();
  const dvec2 far = glm::max(glm::abs(shown.lower), glm::abs(shown.upper));
  const double reach = std::max(far.x, far.y), length = subject.ray().last;
  if (!can_be_told_apart(reach, reach + length))
    refuse("ray", "expected two points that lie apart in a drawing as large as {}, found {} between them",
           reach, length);
}

void set_up(Narrator& narrator, const Subject& subject, const Section& section) {
  require_scale(section.panel(), narrator.arguments(), {"ray"});
  require_length(subject, section);
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle",
                    {{"shape", narrator.words().say("shape." + narrator.arguments().text("shape"))},
                     {"leaves", subject.leaves().size()}});
}

template <Kind kind>
void tell_ray(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  RayStory story(narrator.words(), subject, kind);
  set_up(narrator, subject, story.drawing().section());
  narrator.handles("ray", shown_in(story.drawing().section().panel()));
  narrator.columns({{"node", false}, {"what", false}, {"ends", false}});
  narrator.legend({{Role::current, "node"},
                   {Role::candidate, "operands"},
                   {Role::past, "before"},
                   {Role::input, "leaves"},
                   {Role::measure, "ray"},
                   {Role::result, "solid"}});
  if (kind == Kind::cracked) {
    narrator.list("singly");
    narrator.list_below("cracked");
  }
  DEnds ends;
  narrator.tell_whole(story, [&](const auto& watch) {
    run(kind, subject.tree, subject.ray(),
        [&]<class Step>(const Step& step, int line = __builtin_LINE(), const char* file = __builtin_FILE()) {
          ends = step.ends;
          watch(step, line, file);
        });
  });
  narrator.result({{"parts", static_cast<std::int64_t>(ends.size() / 2)}, {"length", length_in(ends)}});
}

void tell_membership(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const dvec2 point = narrator.arguments().points("point").front();
  MembershipStory story(narrator.words(), subject, point, along(Kind::right));
  set_up(narrator, subject, story.section());
  narrator.handles("point", shown_in(story.section().panel()));
  narrator.columns({{"node", false}, {"what", false}, {"in", false}});
  narrator.legend({{Role::current, "node"},
                   {Role::accepted, "in"},
                   {Role::rejected, "out"},
                   {Role::input, "leaves"},
                   {Role::measure, "point"},
                   {Role::result, "solid"}});
  bool in = false;
  narrator.tell_whole(
      story, [&](const auto& watch) { in = contains<double>(subject.tree, dvec3(point, 0), watch); });
  narrator.result({{"in", in}});
}

void tell_edit(Narrator& narrator) {
  const Subject before = subject_of(narrator.arguments());
  const std::vector<Index> leaves = before.leaves();
  const Arguments::Entry& letter = narrator.arguments().entry("leaf");
  auto number = static_cast<Index>(letter.text.front() - 'A');
  if (number >= leaves.size() && letter.given)
    refuse("leaf", "expected one of the {} leaves, found {}", leaves.size(), letter.text);
  number = std::min(number, leaves.size() - 1);
  const std::vector<double> move = narrator.arguments().numbers("move");
  const double factor = *narrator.arguments().number("factor");
  if (!(0 < factor && factor <= 4)) refuse("factor", "expected a factor above 0, up to 4, found {}", factor);
  const Index leaf = leaves[number];
  Subject after = before;
  after.tree[leaf].solid = edited(before.tree[leaf].solid, {move[0], move[1]}, factor);
  Evaluation<double> e = evaluated(before.tree, before.ray());
  EditStory story(narrator.words(), before, after, leaf, e.on, along(Kind::right));
  set_up(narrator, before, story.drawing().section());
  narrator.handles("ray", shown_in(story.drawing().section().panel()));
  narrator.columns({{"node", false}, {"what", false}, {"ends", false}, {"how", false}});
  narrator.legend({{Role::current, "node"},
                   {Role::candidate, "again"},
                   {Role::past, "kept"},
                   {Role::input, "leaves"},
                   {Role::rejected, "old"},
                   {Role::measure, "ray"},
                   {Role::accepted, "solid"}});
  narrator.list_below("restore");
  narrator.tell_whole(story, [&](const auto& watch) {
    const Undo<double> undo = change(e, leaf, after.tree[leaf].solid, watch);
    restore(e, undo, watch);
  });
  narrator.result(
      {{"parts", static_cast<std::int64_t>(e.on.back().size() / 2)}, {"length", length_in(e.on.back())}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const std::vector<std::string> of_edit{"leaf", "move", "factor"};
  const std::vector<std::string> of_ray{"point", "leaf", "move", "factor"};
  static const TopicEntry topic = completed<entry>(
      {.name = "csg_tree",
       .chapter = "modeling",
       .aliases = {"csg", "constructive solid geometry", "roth diagram", "boolean operations"},
       .summary = "solids made of simple ones by union, intersection and difference, asked leaf by leaf",
       .methods = {{.name = "along_ray",
                    .standing = Standing::taught,
                    .tell = tell_ray<Kind::right>,
                    .unread = of_ray},
                   {.name = "membership",
                    .tell = tell_membership,
                    .function = "contains",
                    .unread = {"ray", "leaf", "move", "factor"}},
                   {.name = "edit", .tell = tell_edit, .function = "change", .unread = {"point"}},
                   {.name = "exchanged",
                    .standing = Standing::faulty,
                    .tell = tell_ray<Kind::exchanged>,
                    .unread = of_ray,
                    .opening = {{"shape", "lens"}, {"root", "difference"}}},
                   {.name = "cracked",
                    .standing = Standing::faulty,
                    .tell = tell_ray<Kind::cracked>,
                    .unread = of_ray,
                    .opening = {{"shape", "flush"}}}},
       .parameters = {choice("shape", shape_names(), "lever", "dice", "the solid, with its tree"),
                      choice("root", root_names(), "given", "union", "the operation at the root"),
                      points(2, 2, "ray", "0,4 20,4", "0,2 20,7", "its begin and its end, in the plane z = 0",
                             xy, {1e-3, 1e3}),
                      points(1, 1, "point", "13,5", "12,4", "the point that is asked, in the plane z = 0", xy,
                             {1e-3, 1e3}),
                      choice("leaf", {"A", "B", "C", "D", "E"}, "C", "B", "the leaf that is changed"),
                      numbers("move", "0,0", "-3,0", "by how much it moves", xy, {1e-3, 1e3}),
                      number("factor", "1.5", "0.5", "how many times as large it becomes", {1e-3, 4})},
       .examples = {"--ray '0,2 20,7'", "--method membership --point 12,4",
                    "--method edit --leaf A --factor 0.5", "--shape dice --ray '2,4 18,4'"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::csg_tree
