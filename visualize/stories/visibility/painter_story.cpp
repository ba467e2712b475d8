// The story of the painter: which polygon comes next, which test lets it, and what is moved or cut before.

#include "visibility/painter/painter.hpp"

#include "stories/checking.hpp"
#include "stories/listing.hpp"
#include "stories/past.hpp"
#include "stories/visibility/painter/drawing.hpp"
#include "visibility/painter/painter_notes.hpp"

namespace gradus::painter {
namespace {

/// What a method sorts by.
struct KeyKind {
  std::string_view caption;  ///< the key of its text
  std::function<double(const Subject&, dvec3)> of_place;
  bool of_mean = true;  ///< of the mean of the corners; else the largest of the corners
  bool tests = false, distances = false;
};

double depth_of(const Subject& subject, dvec3 p) { return subject.depth(p); }
double distance_of(const Subject& subject, dvec3 p) {
  return subject.distant() ? subject.depth(p) : glm::length(subject.from_eye(p));
}
double z_of(const Subject&, dvec3 p) { return p.z; }

class OrderStory : public Past<Sorted<double>, Taken<double>, Compared<double>, Moved<double>, Cut<double>,
                               Inserted<double>, Drawn<double>, Finished> {
 public:
  /// pieces: so many will be drawn.
  OrderStory(const Words& words, const Subject& subject, KeyKind key, std::size_t pieces)
      : words_(words),
        subject_(subject),
        key_(std::move(key)),
        names_(subject.parts),
        picture_(subject),
        plan_(subject, beside_place),
        order_(subject, std::min(pieces, most_cards)) {}

  template <class Step>
  void take(const Step& step) {
    Past::take(step);
    follow(step);
  }

  const Picture& picture() const { return picture_; }
  /// What is marked where pieces are put back, by a function that isn't listed.
  void putting_back(int line) { putting_back_ = line; }
  /// The first step at which one may cover the other, or does.
  std::optional<StepNumber> telling() const {
    const auto& compared = all<Compared<double>>();
    const auto failed = std::ranges::find(compared, Test::failed, &Compared<double>::passed);
    if (failed != compared.end()) return number<Compared<double>>(failed - compared.begin());
    const auto wrong = wrong_now();
    return wrong ? std::optional(number<Drawn<double>>(wrong->number)) : std::nullopt;
  }

  Event say(const Sorted<double>& s) const {
    return {.text = key_.of_mean ? "sorted.mean" : "sorted",
            .facts = {{"comparisons", static_cast<std::int64_t>(s.comparisons)}},
            .words = {{"order", order_text()}},
            .count = std::ssize(s.order),
            .begins = true,
            .level = Level::idea};
  }
  Event say(const Taken<double>& t) const {
    return {.text = t.others == 0            ? "taken.alone"
                    : has_moved(names_(t.p)) ? "taken.moved"
                                             : "taken",
            .facts = {so_far(), {"others", static_cast<std::int64_t>(t.others)}},
            .words = {{"p", names_(t.p)}, {"key", key_of(t.p).key}},
            .key = place(),
            .phase = phase()};
  }
  Event say(const Compared<double>& c) const {
    constexpr std::array<std::string_view, 7> texts{"depths",   "across", "upright", "behind",
                                                    "in_front", "apart",  "none"};
    constexpr std::array<const char*, 7> branches{"depths",   "across", "upright",    "behind",
                                                  "in front", "apart",  "none passed"};
    const auto test = static_cast<std::size_t>(c.passed);
    std::vector<std::string> answers;
    for (std::size_t i = 0; i < 7; ++i) answers.push_back(words_.say(fmt::format("test.{}", i)));
    const bool last = c.last && c.passed == Test::depths;
    return {.text = last ? "compared.depths.last" : fmt::format("compared.{}", texts[test]),
            .facts = {so_far(), {"test", static_cast<std::int64_t>(test)}},
            .words = {{"p", names_(c.p)},
                      {"q", names_(c.q)},
                      {"near", nearest(c.p)},
                      {"far", farthest(c.q)},
                      {"corners", c.passed == Test::behind ? c.p.corners.size() : c.q.corners.size()},
                      {"beyond", beyond(c.q, c.p)}},
            .row = {names_(c.p), names_(c.q), answers[test]},
            .key = place(),
            .phase = phase(),
            .decides = Decision{words_.say("question", {{"p", names_(c.p)}, {"q", names_(c.q)}}), answers,
                                test, branches[test]}};
  }
  Event say(const Moved<double>& m) const {
    return {.text = "moved",
            .facts = {so_far()},
            .words = {{"p", names_(m.p)}, {"q", names_(m.q)}, {"number", painted().size() + 1}},
            .key = place(),
            .phase = phase()};
  }
  Event say(const Cut<double>& c) const {
    const std::string& q = names_(last<Compared<double>>()->q);
    return {.text = names_(c.whole) != q ? "cut.cycle"
                    : has_moved(q)       ? "cut.again"
                                         : "cut",
            .facts = {so_far(),
                      {"corners_in_front", std::ssize(c.in_front.corners)},
                      {"corners_behind", std::ssize(c.behind.corners)}},
            .words = {{"p", names_(c.p)},
                      {"q", q},
                      {"whole", names_(c.whole)},
                      {"front", names_(c.in_front)},
                      {"behind", names_(c.behind)}},
            .key = place(),
            .phase = phase()};
  }
  Event say(const Inserted<double>&) const {
    return {.text = "sorted.again",
            .facts = {so_far()},
            .words = {{"order", order_text()}},
            .key = place(),
            .phase = phase(),
            .line = putting_back_};
  }
  Event say(const Drawn<double>& d) const {
    const std::int64_t number = std::ssize(painted());
    const std::string& name = names_(d.polygon);
    Event event{.text = waiting_.empty() ? "drawn.last" : "drawn",
                .facts = {so_far(), {"number", number}, {"polygon", name}},
                .words = {{"p", name}},
                .key = place(),
                .phase = phase()};
    if (key_.tests) return event;
    const double key = key_of(d.polygon).key;
    const auto wrong = wrong_now();
    event.text = wrong ? "drawn.wrong" : "drawn.untested";
    event.words.push_back({"key", key});
    if (wrong) add_wrong(event, *wrong);
    event.row = {number, name, key};
    event.decides = yes_or_no(words_, "question.order", {{"p", name}}, !wrong, "in order", "out of order");
    return event;
  }
  Event say(const Finished&) const {
    const auto wrong = wrong_now();
    Event event{.text = key_.tests ? "done"
                        : wrong    ? "done.wrong"
                                   : "done.right",
                .facts = {{"polygons", std::ssize(painted())},
                          {"tests", std::ssize(all<Compared<double>>())},
                          {"cuts", std::ssize(all<Cut<double>>())}}};
    if (wrong) add_wrong(event, *wrong);
    return event;
  }

  Drawing draw() const {
    Drawing drawing;
    const bool done = now<Finished>();
    const Role last = done ? Role::result : p() ? Role::input : Role::current;
    picture_.add_painted(drawing, painted(), names_, done ? Role::result : Role::input, last, waiting_);
    for (std::size_t i = 0; i < waiting_.size(); ++i)
      picture_.add_outline(drawing, i, role_of(waiting_[i]), names_(waiting_[i]), waiting_);
    if (compared()) add_test(drawing, *compared());
    for (const Wrong& wrong : all_wrong_now())
      picture_.add_common(drawing, wrong.late, wrong.early, Role::rejected);
    add_order(drawing);
    add_beside(drawing);
    return drawing;
  }

 private:
  // --- What was told so far

  void follow(const auto&) {}
  void follow(const Sorted<double>& s) { waiting_ = s.order; }
  void follow(const Moved<double>& m) {
    no_longer_waits(m.q);
    waiting_.insert(waiting_.begin(), m.q);
  }
  void follow(const Cut<double>& c) {
    names_.cut(c.whole, c.in_front, c.behind);
    const auto at = std::ranges::find_if(waiting_, same_as(c.whole));
    *at = c.in_front;
    waiting_.insert(at + 1, c.behind);
  }
  void follow(const Inserted<double>& i) {
    for (const auto& [polygon, before] : i.places) no_longer_waits(polygon);
    for (const auto& [polygon, before] : i.places)
      waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(before), polygon);
  }
  void follow(const Drawn<double>& d) { no_longer_waits(d.polygon); }
  void no_longer_waits(const DPolygon& polygon) { std::erase_if(waiting_, same_as(polygon)); }

  /// What a step is about is how far the order is filled: so runs are compared place by place, whatever each
  /// of them asks before it paints the next polygon.
  std::string place() const { return fmt::format("{}", all<Drawn<double>>().size()); }
  Field so_far() const { return {"painted", std::ssize(all<Drawn<double>>())}; }
  std::vector<DPolygon> painted() const { return mapped(all<Drawn<double>>(), &Drawn<double>::polygon); }
  /// Which place in the order is being filled.
  std::string phase() const {
    return words_.say("phase.place", {{"number", painted().size() + (now<Drawn<double>>() ? 0 : 1)}});
  }
  bool has_moved(const std::string& name) const {
    return std::ranges::any_of(all_since<Moved<double>, Inserted<double>>(),
                               [&](const Moved<double>& m) { return names_(m.q) == name; });
  }
  /// The polygon at hand.
  const DPolygon* p() const {
    if (const auto* taken = now<Taken<double>>()) return &taken->p;
    if (const auto* cut = now<Cut<double>>()) return &cut->p;
    return compared() ? &compared()->p : nullptr;
  }
  /// The test at hand.
  const Compared<double>* compared() const {
    return now<Compared<double>>() || now<Moved<double>>() ? last<Compared<double>>() : nullptr;
  }
  bool has_passed(Test test) const { return compared() && compared()->passed == test; }
  template <class Step>
  StepNumber number(std::integral auto i) const {
    return {static_cast<std::int64_t>(number_of<Step>(static_cast<std::size_t>(i))), 0};
  }

  // --- Keys

  /// Of a polygon's corners, from the least to the most.
  std::pair<double, double> keys_of(const DPolygon& polygon) const {
    const auto [least, most] =
        std::ranges::minmax(mapped(polygon.corners, [&](dvec3 p) { return key_.of_place(subject_, p); }));
    return {least, most};
  }
  Entry key_of(const DPolygon& polygon) const {
    const double key = key_.of_mean ? key_.of_place(subject_, mean(polygon)) : farthest(polygon);
    return {names_(polygon), key, role_of(polygon)};
  }
  double nearest(const DPolygon& polygon) const { return keys_of(polygon).first; }
  double farthest(const DPolygon& polygon) const { return keys_of(polygon).second; }

  /// How many corners of one lie beyond the other's plane; those that a cut has put into it don't.
  std::int64_t beyond(const DPolygon& one, const DPolygon& other) const {
    const auto& plane = other.plane;
    const dvec3 a = plane.a;
    const int eye = bsp_tree::side_of_eye(plane, subject_.view.eye);
    const dvec3 normal = unit_vector(glm::cross(plane.b - a, plane.c - a));
    return std::ranges::count_if(
        one.corners, [&](dvec3 p) { return eye * glm::dot(normal, p - a) < -1e-9 * length_between(p, a); });
  }

  std::string order_text() const { return fmt::format("{}", fmt::join(mapped(waiting_, names_), ", ")); }

  // --- What is wrong

  /// What is painted by now over something that it lies behind: by the step at hand; in the end by any.
  std::vector<Wrong> all_wrong_now() const {
    std::vector<Wrong> wrong;
    if (key_.tests || !(now<Finished>() || now<Drawn<double>>())) return wrong;
    const auto& drawn = all<Drawn<double>>();
    for (std::size_t late = now<Finished>() ? 0 : drawn.size() - 1; late < drawn.size(); ++late) {
      for (std::size_t i = 0; i < late; ++i) {
        if (wrongly_over(subject_, drawn[late].polygon, drawn[i].polygon))
          wrong.push_back({drawn[late].polygon, drawn[i].polygon, late});
      }
    }
    return wrong;
  }
  std::optional<Wrong> wrong_now() const {
    const auto wrong = all_wrong_now();
    return wrong.empty() ? std::nullopt : std::optional(wrong.front());
  }
  void add_wrong(Event& event, const Wrong& wrong) const {
    event.words.insert(event.words.end(), {{"late", names_(wrong.late)},
                                           {"early", names_(wrong.early)},
                                           {"late_key", key_of(wrong.late).key},
                                           {"early_key", key_of(wrong.early).key}});
  }

  // --- The drawing

  Role role_of(const DPolygon& polygon) const {
    const auto same = same_as(polygon);
    if (now<Finished>()) return Role::result;
    if (p() && same(*p())) return Role::current;
    if (compared() && same(compared()->q)) return has_passed(Test::failed) ? Role::rejected : Role::accepted;
    if (const auto* cut = now<Cut<double>>(); cut && (same(cut->in_front) || same(cut->behind)))
      return Role::candidate;
    return std::ranges::any_of(all<Drawn<double>>(), same, &Drawn<double>::polygon) ? Role::input
                                                                                    : Role::past;
  }

  void add_test(Drawing& drawing, const Compared<double>& c) const {
    if (c.passed == Test::across || c.passed == Test::upright || c.passed == Test::apart)
      picture_.add_parting(drawing, c.p, c.q, c.passed);
    if (c.passed == Test::failed) picture_.add_common(drawing, c.p, c.q, Role::rejected);
  }
  void add_order(Drawing& drawing) const {
    std::vector<DPolygon> polygons = painted();
    const std::size_t drawn = polygons.size();
    polygons.insert(polygons.end(), waiting_.begin(), waiting_.end());
    const std::size_t cards = std::min(polygons.size(), most_cards);
    const std::size_t first = std::min(drawn == 0 ? 0 : drawn - 1, polygons.size() - cards);
    const auto entries = mapped(polygons, [&](const DPolygon& polygon) { return key_of(polygon); });
    order_.add(drawing, polygons, entries, first, cards, words_.say(key_.caption));
  }
  void add_beside(Drawing& drawing) const {
    if (has_passed(Test::behind) || has_passed(Test::in_front) || has_passed(Test::failed) ||
        now<Cut<double>>())
      return add_edge_on(drawing);
    for (const bool at_hand : {false, true}) {
      for (const auto& list : {painted(), waiting_}) {
        for (const DPolygon& polygon : list) {
          const Role role = role_of(polygon);
          if ((role == Role::current || role == Role::accepted) == at_hand)
            plan_.add_polygon(drawing, polygon, role, names_(polygon), at_hand);
        }
      }
    }
    plan_.add_eye(drawing, words_.say("eye"));
    if (has_passed(Test::depths)) plan_.add_depth(drawing, nearest(*p()));
    if (key_.distances) {
      for (const DPolygon& polygon : subject_.polygons)
        plan_.add_distance(drawing, mean(polygon), Role::measure, names_(polygon),
                           figure_real(key_of(polygon).key));
    }
    add_caption(drawing, "z caption", beside_place, words_.say("caption.above"), 1, true);
  }
  void add_edge_on(Drawing& drawing) const {
    const DPolygon& of = has_passed(Test::behind) ? compared()->q : *p();
    std::vector<DPolygon> shown;
    if (compared()) shown.push_back(has_passed(Test::behind) ? *p() : compared()->q);
    if (const auto* cut = now<Cut<double>>()) shown = {cut->in_front, cut->behind};
    auto plane = of.plane;  // the eye's side above
    if (bsp_tree::side_of_eye(plane, subject_.view.eye) < 0) std::swap(plane.b, plane.c);
    std::vector<DPolygon> all_shown = shown;
    all_shown.push_back(of);
    const EdgeOnPicture picture({beside_place.lower + dvec2{0.4, 0}, beside_place.upper - dvec2{0, 1.2}},
                                plane, faces_subject::Reader(-subject_.forward), all_shown);
    picture.add_plane(drawing, words_.say("plane", {{"name", names_(of)}}));
    for (const DPolygon& polygon : shown)
      picture.add_polygon(drawing, polygon, role_of(polygon), names_(polygon), true);
    add_caption(drawing, "z caption", beside_place, words_.say("caption.edge_on"), 1, true);
  }

  const Words& words_;
  const Subject& subject_;
  const KeyKind key_;
  PartNames names_;
  Picture picture_;
  PlanPicture plan_;
  OrderStrip order_;
  std::vector<DPolygon> waiting_{};  ///< the first is farthest
  int putting_back_ = 0;
};

// --- The methods

/// Its columns are its own where it sorts alone.
void set_up(Narrator& narrator, const Subject& subject, bool tests) {
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"count", subject.polygons.size()}});
  if (tests)
    return narrator.legend({{Role::current, "p"},
                            {Role::accepted, "safe"},
                            {Role::rejected, "covered"},
                            {Role::measure, "parting"},
                            {Role::candidate, "parts"},
                            {Role::input, "painted"},
                            {Role::past, "waiting"},
                            {Role::result, "done"}});
  narrator.columns({{"number"}, {"polygon", false}, {"key"}});
  narrator.legend({{Role::current, "now"},
                   {Role::input, "painted"},
                   {Role::past, "waiting"},
                   {Role::rejected, "wrong"},
                   {Role::result, "done"}});
}

template <const KeyKind& key, auto method>
void tell_order(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject, key.tests);
  if (key.tests) {
    narrator.list_below("covered");
    narrator.list_below("tested");
  }
  const auto drop = [](const DPolygon&) {};
  std::size_t pieces = subject.polygons.size();
  method(subject.polygons, subject.view, drop,
         [&]<class Step>(const Step&) { pieces += std::same_as<Step, Cut<double>>; });
  OrderStory story(narrator.words(), subject, key, pieces);
  story.putting_back(line_with(narrator.trace().listing, "put_back("));
  narrator.handles("faces", [&](dvec3 p) { return story.picture().shown_at(p); });
  method(subject.polygons, subject.view, drop, narrator.watcher(story));
  if (const auto telling = story.telling()) narrator.telling(*telling);
}

const KeyKind by_farthest{.caption = "key.farthest", .of_place = depth_of, .of_mean = false};
const KeyKind by_tests{.caption = "key.farthest", .of_place = depth_of, .of_mean = false, .tests = true};
const KeyKind by_distance{.caption = "key.centroid", .of_place = distance_of, .distances = true};
const KeyKind by_depth{.caption = "key.mean_depth", .of_place = depth_of};
const KeyKind by_z{.caption = "key.mean_z", .of_place = z_of};

constexpr auto by_newell = [](const auto&... with) { newell(with...); };
constexpr auto by_vertex = [](const auto&... with) { farthest_vertex(with...); };
constexpr auto by_centroid = [](const auto&... with) { centroid(with...); };
constexpr auto by_mean_depth = [](const auto&... with) { mean_depth(with...); };
constexpr auto by_mean_z = [](const auto&... with) { descending_mean_z(with...); };

const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "order", .same = SameList::order, .type = "Drawn", .fields = {"polygon"}}}};
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
       .methods =
           {{.name = "newell", .standing = Standing::taught, .tell = tell_order<by_tests, by_newell>},
            {.name = "farthest_vertex", .tell = tell_order<by_farthest, by_vertex>},
            {.name = "centroid", .standing = Standing::faulty, .tell = tell_order<by_distance, by_centroid>},
            {.name = "mean_depth", .standing = Standing::faulty, .tell = tell_order<by_depth, by_mean_depth>},
            {.name = "descending_mean_z", .standing = Standing::faulty, .tell = tell_order<by_z, by_mean_z>}},
       .default_method = "newell",
       .columns = {{"p", false}, {"q", false}, {"passed", false}},
       .counts = {"Compared", "Cut", "Drawn"},
       .parameters = {faces_subject::faces_parameter(
                          "A: -6,-3,-5 6,-3,3 6,0,3 -6,0,-5; B: -5,-5,-1 -1,-5,-1 -1,3,-1 -5,3,-1; "
                          "C: 2,-5,-4 5,-5,-4 5,4,-4 2,4,-4; D: -6,-10,-13 7,-10,-13 7,5,-13 -6,5,-13",
                          "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 3,1,-1 3,1,2 1,1,2"),
                      faces_subject::towards_parameter("0.3,0.4,1"),
                      parameters::instead_of(
                          "towards", parameters::numbers("eye", "", "3,4,20", "where the eye is",
                                                         parameters::xyz, faces_subject::modest_sizes))},
       .examples = {"--method centroid", "--eye 3,4,20",
                    "--faces 'A: 0,0,0 4,0,0 4,3,0 0,3,0; B: 1,1,-2 3,1,-2 3,1,2 1,1,2' --towards 1,2,3"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::painter
