// The story of the painter: which polygon comes next, which test lets it, and what is moved or cut before.

#include "visibility/painter/painter.hpp"

#include <set>

#include "stories/checking.hpp"
#include "stories/visibility/painter_drawing.hpp"
#include "visibility/painter/painter_notes.hpp"

namespace gradus::painter {
namespace {

/// What a method sorts by.
struct KeyKind {
  std::string_view caption;  ///< the key of its text
  std::function<double(const Task&, dvec3)> of_place;
  bool of_mean = true;  ///< of the mean of the corners; else the largest of the corners
  bool tests = false, distances = false;
};

double depth_of(const Task& task, dvec3 p) { return task.depth(p); }
double distance_of(const Task& task, dvec3 p) {
  return task.distant() ? task.depth(p) : glm::length(task.from_eye(p));
}
double z_of(const Task&, dvec3 p) { return p.z; }

class OrderStory {
 public:
  /// pieces: so many will be drawn.
  OrderStory(const Words& words, const Task& task, KeyKind key, std::size_t pieces)
      : words_(words),
        task_(task),
        key_(std::move(key)),
        names_(task.parts),
        beside_place_(place_below(pieces)),
        picture_(task),
        plan_(task, beside_place_),
        order_(keys_of_all()) {}

  const Picture& picture() const { return picture_; }
  /// The first step at which one may cover the other, or does.
  std::optional<StepNumber> telling() const { return telling_; }

  void show(Board& board, const Sorted<double>& s) {
    forget();
    waiting_ = s.order;
    put(board);
  }
  Event say(const Sorted<double>& s) const {
    return {.text = key_.of_mean ? "sorted.mean" : "sorted",
            .facts = {{"comparisons", static_cast<std::int64_t>(s.comparisons)}},
            .words = {{"order", order_text()}},
            .count = std::ssize(s.order),
            .begins = true,
            .level = Level::idea};
  }

  void show(Board& board, const Taken<double>& t) {
    forget();
    p_ = t.p;
    put(board);
  }
  Event say(const Taken<double>& t) const {
    return {.text = t.others == 0               ? "taken.alone"
                    : moved_.contains(p_name()) ? "taken.moved"
                                                : "taken",
            .facts = {{"others", static_cast<std::int64_t>(t.others)}},
            .words = {{"p", p_name()}, {"key", key_of(t.p).key}},
            .key = p_name()};
  }

  void show(Board& board, const Compared<double>& c) {
    p_ = c.p;
    q_ = c.q;
    passed_ = c.passed;
    ++tests_;
    put(board);
  }
  Event say(const Compared<double>& c) const {
    constexpr std::array<std::string_view, 7> texts{
        "compared.depths",   "compared.across", "compared.upright", "compared.behind",
        "compared.in_front", "compared.apart",  "compared.none"};
    constexpr std::array<const char*, 7> branches{"depths",   "across", "upright",    "behind",
                                                  "in front", "apart",  "none passed"};
    const auto test = static_cast<std::size_t>(c.passed);
    std::vector<std::string> answers;
    for (std::size_t i = 0; i < 7; ++i) answers.push_back(words_.say(fmt::format("test.{}", i)));
    return {.text = c.last && c.passed == Test::depths ? "compared.depths.last" : texts[test],
            .facts = {{"test", static_cast<std::int64_t>(test)}},
            .words = {{"p", p_name()},
                      {"q", q_name()},
                      {"near", nearest(c.p)},
                      {"far", farthest(c.q)},
                      {"corners", c.passed == Test::behind ? c.p.corners.size() : c.q.corners.size()},
                      {"beyond", beyond(c.q, c.p)}},
            .row = {p_name(), q_name(), answers[test]},
            .key = p_name(),
            .decides = Decision{words_.say("question", {{"p", p_name()}, {"q", q_name()}}), answers, test,
                                branches[test]}};
  }

  void show(Board& board, const Moved<double>& m) {
    moved_.insert(names_(m.q));
    std::erase_if(waiting_, [&](const DPolygon& polygon) { return bsp_tree::same(polygon, m.q); });
    waiting_.insert(waiting_.begin(), m.q);
    put(board);
  }
  Event say(const Moved<double>& m) const {
    return {.text = "moved",
            .words = {{"p", p_name()}, {"q", names_(m.q)}, {"number", painted_.size() + 1}},
            .key = p_name()};
  }

  void show(Board& board, const Cut<double>& c) {
    whole_ = names_(c.whole);
    names_.cut(c.whole, c.in_front, c.behind);
    const auto at = std::ranges::find_if(
        waiting_, [&](const DPolygon& polygon) { return bsp_tree::same(polygon, c.whole); });
    *at = c.in_front;
    waiting_.insert(at + 1, c.behind);
    parts_ = {c.in_front, c.behind};
    p_ = c.p;
    q_.reset();
    ++cuts_;
    put(board);
  }
  Event say(const Cut<double>& c) const {
    const bool again = moved_.contains(q_name_);
    return {.text = whole_ != q_name_ ? "cut.cycle"
                    : again           ? "cut.again"
                                      : "cut",
            .facts = {{"corners_in_front", std::ssize(c.in_front.corners)},
                      {"corners_behind", std::ssize(c.behind.corners)}},
            .words = {{"p", p_name()},
                      {"q", q_name_},
                      {"whole", whole_},
                      {"front", names_(c.in_front)},
                      {"behind", names_(c.behind)}},
            .key = p_name()};
  }

  void show(Board& board, const Inserted<double>& i) {
    forget();
    moved_.clear();
    for (const auto& [polygon, before] : i.places)
      std::erase_if(waiting_, [&](const DPolygon& other) { return bsp_tree::same(polygon, other); });
    for (const auto& [polygon, before] : i.places)
      waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(before), polygon);
    put(board);
  }
  Event say(const Inserted<double>&) const {
    return {.text = "sorted.again", .words = {{"order", order_text()}}};
  }

  void show(Board& board, const Drawn<double>& d) {
    forget();
    if (!key_.tests) wrong_ = wrongly_covered_by(d.polygon);
    painted_.push_back(d.polygon);
    std::erase_if(waiting_, [&](const DPolygon& polygon) { return bsp_tree::same(polygon, d.polygon); });
    put(board);
  }
  Event say(const Drawn<double>& d) const {
    Event event{.text = waiting_.empty() ? "drawn.last" : "drawn",
                .facts = {{"number", std::ssize(painted_)}},
                .words = {{"p", names_(d.polygon)}, {"number", painted_.size()}},
                .key = names_(d.polygon)};
    if (key_.tests) return event;
    const double key = key_of(d.polygon).key;
    event.text = wrong_ ? "drawn.wrong" : "drawn.untested";
    event.words.push_back({"key", key});
    if (wrong_) add_wrong(event);
    event.row = {painted_.size(), names_(d.polygon), key};
    event.decides =
        yes_or_no(words_, "question.order", {{"p", names_(d.polygon)}}, !wrong_, "in order", "out of order");
    return event;
  }

  void show(Board& board, const Finished&) {
    forget();
    done_ = true;
    wrong_ = first_wrong_;
    put(board);
  }
  Event say(const Finished&) const {
    Event event{.text = key_.tests ? "done"
                        : wrong_   ? "done.wrong"
                                   : "done.right",
                .facts = {{"polygons", std::ssize(painted_)}, {"tests", tests_}, {"cuts", cuts_}}};
    if (wrong_) add_wrong(event);
    return event;
  }

 private:
  std::string p_name() const { return names_(*p_); }
  std::string q_name() const { return names_(*q_); }

  // --- Keys

  /// Of a polygon's corners, from the least to the most.
  std::pair<double, double> keys_of(const DPolygon& polygon) const {
    std::vector<double> keys;
    for (const dvec3 p : polygon.corners) keys.push_back(key_.of_place(task_, p));
    const auto [least, most] = std::ranges::minmax(keys);
    return {least, most};
  }
  std::pair<double, double> keys_of_all() const {
    auto [least, most] = keys_of(task_.polygons.front());
    for (const DPolygon& polygon : task_.polygons) {
      const auto [its_least, its_most] = keys_of(polygon);
      least = std::min(least, its_least);
      most = std::max(most, its_most);
    }
    return {least, most};
  }
  Entry key_of(const DPolygon& polygon) const {
    const auto [least, most] = keys_of(polygon);
    const double key = key_.of_mean ? key_.of_place(task_, mean(polygon)) : most;
    return {names_(polygon), least, most, key, role_of(polygon)};
  }
  double nearest(const DPolygon& polygon) const { return keys_of(polygon).first; }
  double farthest(const DPolygon& polygon) const { return keys_of(polygon).second; }

  /// How many corners of one lie beyond the other's plane; those that a cut has put into it don't.
  std::int64_t beyond(const DPolygon& one, const DPolygon& other) const {
    const auto& plane = other.plane;
    const dvec3 a = plane.a;
    const int eye = bsp_tree::side_of_eye(plane, task_.view.eye);
    const dvec3 normal = unit_vector(glm::cross(plane.b - a, plane.c - a));
    return std::ranges::count_if(
        one.corners, [&](dvec3 p) { return eye * glm::dot(normal, p - a) < -1e-9 * length_between(p, a); });
  }

  std::string order_text() const {
    std::vector<std::string> names;
    for (const DPolygon& polygon : waiting_) names.push_back(names_(polygon));
    return fmt::format("{}", fmt::join(names, ", "));
  }

  // --- What is wrong

  /// The first that one is painted over though it lies behind it.
  std::optional<Wrong> wrongly_covered_by(const DPolygon& late) const {
    for (const DPolygon& early : painted_) {
      if (wrongly_over(task_, late, early)) return Wrong{late, early};
    }
    return std::nullopt;
  }
  void add_wrong(Event& event) const {
    const auto& [late, early] = *wrong_;
    event.words.push_back({"late", names_(late)});
    event.words.push_back({"early", names_(early)});
    event.words.push_back({"late_key", key_of(late).key});
    event.words.push_back({"early_key", key_of(early).key});
  }

  // --- The drawing

  void forget() {
    p_.reset();
    q_.reset();
    passed_.reset();
    wrong_.reset();
    parts_.clear();
  }
  Role role_of(const DPolygon& polygon) const {
    const auto is = [&](const auto& other) { return other && bsp_tree::same(*other, polygon); };
    if (done_) return Role::result;
    if (is(p_)) return Role::current;
    if (is(q_)) return passed_ == Test::failed ? Role::rejected : Role::accepted;
    if (std::ranges::any_of(parts_, [&](const DPolygon& part) { return bsp_tree::same(part, polygon); }))
      return Role::candidate;
    const bool painted =
        std::ranges::any_of(painted_, [&](const DPolygon& other) { return bsp_tree::same(other, polygon); });
    return painted ? Role::input : Role::past;
  }

  void put(Board& board) {
    ++steps_;
    if (q_) q_name_ = q_name();
    if (passed_ == Test::failed && !telling_) telling_ = StepNumber{steps_ - 1, 0};
    if (wrong_ && !first_wrong_) {
      first_wrong_ = wrong_;
      telling_ = StepNumber{steps_ - 1, 0};
    }
    Drawing drawing;
    const Role last = done_ ? Role::result : p_ ? Role::input : Role::current;
    picture_.add_painted(drawing, painted_, names_, done_ ? Role::result : Role::input, last, waiting_);
    for (const DPolygon& polygon : waiting_)
      picture_.add_outline(drawing, polygon, role_of(polygon), names_(polygon), waiting_);
    if (q_ && passed_) add_test(drawing);
    if (wrong_) picture_.add_common(drawing, wrong_->late, wrong_->early, Role::rejected);
    add_order(drawing);
    add_beside(drawing);
    board.milestone(std::move(drawing));
  }
  void add_test(Drawing& drawing) const {
    if (passed_ == Test::across || passed_ == Test::upright || passed_ == Test::apart)
      picture_.add_parting(drawing, *p_, *q_, *passed_);
    if (passed_ == Test::failed) picture_.add_common(drawing, *p_, *q_, Role::rejected);
  }
  void add_order(Drawing& drawing) const {
    std::vector<DPolygon> all = painted_;
    all.insert(all.end(), waiting_.begin(), waiting_.end());
    const std::size_t rows = std::min(all.size(), most_rows);
    const std::size_t first = std::min(painted_.empty() ? 0 : painted_.size() - 1, all.size() - rows);
    std::vector<Entry> entries;
    for (std::size_t i = first; i < first + rows; ++i) entries.push_back(key_of(all[i]));
    order_.add(drawing, entries, first, words_.say(key_.caption));
    if (q_ && passed_ == Test::depths) order_.add_limit(drawing, nearest(*p_), rows);
  }
  void add_beside(Drawing& drawing) const {
    const bool plane =
        q_ && (passed_ == Test::behind || passed_ == Test::in_front || passed_ == Test::failed);
    if (plane || !parts_.empty()) return add_edge_on(drawing);
    int rank = 0;
    for (const bool at_hand : {false, true}) {
      for (const auto& list : {painted_, waiting_}) {
        for (const DPolygon& polygon : list) {
          const Role role = role_of(polygon);
          const bool is = role == Role::current || role == Role::accepted;
          if (is == at_hand) plan_.add_polygon(drawing, polygon, role, names_(polygon), rank);
        }
      }
      ++rank;
    }
    plan_.add_eye(drawing, words_.say("eye"));
    if (q_ && passed_ == Test::depths) plan_.add_depth(drawing, nearest(*p_));
    if (key_.distances) {
      for (const DPolygon& polygon : task_.polygons)
        plan_.add_distance(drawing, mean(polygon), Role::measure, names_(polygon),
                           figure_real(key_of(polygon).key));
    }
    add_caption(drawing, words_.say("caption.above"));
  }
  void add_edge_on(Drawing& drawing) const {
    const DPolygon& of = q_ && passed_ == Test::behind ? *q_ : *p_;
    std::vector<DPolygon> shown{of};
    if (q_) shown.push_back(bsp_tree::same(of, *p_) ? *q_ : *p_);
    shown.insert(shown.end(), parts_.begin(), parts_.end());
    const faces_task::Reader reader(-task_.forward);
    auto plane = of.plane;  // the eye's side above
    if (bsp_tree::side_of_eye(plane, task_.view.eye) < 0) std::swap(plane.b, plane.c);
    const EdgeOnPicture picture({beside_place_.lower + dvec2{0.4, 0}, beside_place_.upper - dvec2{0, 1.2}},
                                plane, reader, shown);
    picture.add_plane(drawing, words_.say("plane", {{"name", names_(of)}}));
    for (std::size_t i = 1; i < shown.size(); ++i)
      picture.add_polygon(drawing, shown[i], role_of(shown[i]), names_(shown[i]), true);
    add_caption(drawing, words_.say("caption.edge_on"));
  }
  void add_caption(Drawing& drawing, const std::string& text) const {
    drawing.add({"z caption", Role::guide,
                 Text{{beside_place_.centre().x, beside_place_.upper.y + 1}, text, Align::centre}});
  }

  const Words& words_;
  const Task& task_;
  const KeyKind key_;
  PartNames names_;
  const Rectangle beside_place_;
  Picture picture_;
  PlanPicture plan_;
  OrderPicture order_;
  std::vector<DPolygon> painted_{}, waiting_{}, parts_{};
  std::optional<DPolygon> p_{}, q_{};
  std::optional<Test> passed_{};
  std::optional<Wrong> wrong_{}, first_wrong_{};
  std::set<std::string> moved_{};
  std::string q_name_{}, whole_{};
  std::optional<StepNumber> telling_{};
  std::int64_t steps_ = 0;
  std::int64_t tests_ = 0, cuts_ = 0;
  bool done_ = false;
};

// --- The methods

constexpr auto drop = [](const DPolygon&) {};

const KeyKind farthest{.caption = "key.farthest", .of_place = depth_of, .of_mean = false};

template <class Method>
void tell_order(Narrator& narrator, const KeyKind& key, const Method& method) {
  const Task task = task_of(narrator.arguments());
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"count", task.polygons.size()}});
  std::size_t pieces = task.polygons.size();
  method(task.polygons, task.view,
         [&]<class Step>(const Step&) { pieces += std::same_as<Step, Cut<double>>; });
  OrderStory story(narrator.words(), task, key, pieces);
  narrator.handles("faces", [&](dvec3 p) { return story.picture().shown_at(p); });
  method(task.polygons, task.view, narrator.watcher(story));
  if (const auto telling = story.telling()) narrator.telling(*telling);
}

void tell_newell(Narrator& narrator) {
  narrator.legend({{Role::current, "p"},
                   {Role::accepted, "safe"},
                   {Role::rejected, "covered"},
                   {Role::measure, "parting"},
                   {Role::candidate, "parts"},
                   {Role::input, "painted"},
                   {Role::past, "waiting"},
                   {Role::result, "done"}});
  KeyKind key = farthest;
  key.tests = true;
  tell_order(narrator, key, [](const auto& polygons, const auto& view, const auto& watch) {
    newell(polygons, view, drop, watch);
  });
}

void tell_sorting(Narrator& narrator) {
  narrator.columns({{"number"}, {"polygon", false}, {"key"}});
  narrator.legend({{Role::current, "now"},
                   {Role::input, "painted"},
                   {Role::past, "waiting"},
                   {Role::rejected, "wrong"},
                   {Role::result, "done"}});
}

void tell_farthest(Narrator& narrator) {
  tell_sorting(narrator);
  tell_order(narrator, farthest, [](const auto& polygons, const auto& view, const auto& watch) {
    farthest_vertex(polygons, view, drop, watch);
  });
}
void tell_centroid(Narrator& narrator) {
  tell_sorting(narrator);
  tell_order(narrator, {.caption = "key.centroid", .of_place = distance_of, .distances = true},
             [](const auto& polygons, const auto& view, const auto& watch) {
               centroid(polygons, view, drop, watch);
             });
}
void tell_mean_depth(Narrator& narrator) {
  tell_sorting(narrator);
  tell_order(narrator, {.caption = "key.mean_depth", .of_place = depth_of},
             [](const auto& polygons, const auto& view, const auto& watch) {
               mean_depth(polygons, view, drop, watch);
             });
}
void tell_mean_z(Narrator& narrator) {
  tell_sorting(narrator);
  tell_order(narrator, {.caption = "key.mean_z", .of_place = z_of},
             [](const auto& polygons, const auto& view, const auto& watch) {
               descending_mean_z(polygons, view, drop, watch);
             });
}

const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "order", .same = SameList::order, .type = "Drawn", .fields = {"key"}}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic = completed<entry>(
      {.name = "painter",
       .chapter = "visibility",
       .aliases = {"painter's algorithm", "depth sort", "Newell"},
       .summary = "polygons from back to front, moved and cut until none covers what comes later",
       .methods = {{.name = "newell", .standing = Standing::taught, .tell = tell_newell},
                   {.name = "farthest_vertex", .tell = tell_farthest},
                   {.name = "centroid", .standing = Standing::faulty, .tell = tell_centroid},
                   {.name = "mean_depth", .standing = Standing::faulty, .tell = tell_mean_depth},
                   {.name = "descending_mean_z", .standing = Standing::faulty, .tell = tell_mean_z}},
       .default_method = "newell",
       .columns = {{"p", false}, {"q", false}, {"passed", false}},
       .parameters = {faces_task::faces_parameter(
                          "A: -6,-3,-5 6,-3,3 6,0,3 -6,0,-5; B: -5,-5,-1 -1,-5,-1 -1,3,-1 -5,3,-1; "
                          "C: 2,-5,-4 5,-5,-4 5,4,-4 2,4,-4; D: -6,-10,-13 7,-10,-13 7,5,-13 -6,5,-13",
                          "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 3,1,-1 3,1,2 1,1,2"),
                      faces_task::towards_parameter("0.3,0.4,1"),
                      parameters::instead_of("towards",
                                             parameters::numbers("eye", "", "3,4,20", "where the eye is",
                                                                 parameters::xyz, faces_task::modest_sizes))},
       .examples = {"--method centroid", "--eye 3,4,20",
                    "--faces 'A: 0,0,0 4,0,0 4,3,0 0,3,0; B: 1,1,-2 3,1,-2 3,1,2 1,1,2' --towards 1,2,3"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::painter
