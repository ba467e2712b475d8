// The story of back-face culling: one test per face, by its normal and the view vector, by its area in the
// picture, or before the division.

#include "core/arithmetic/elementary.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

#include "stories/checking.hpp"
#include "stories/past.hpp"
#include "stories/visibility/back_face_culling/costs_story.hpp"
#include "stories/visibility/back_face_culling/drawing.hpp"
#include "stories/visibility/back_face_culling/methods.hpp"
#include "stories/visibility/back_face_culling/pictures.hpp"

namespace gradus::back_face_culling {
namespace {

constexpr int paper_width = 36, paper_height = 26;
/// Of the paper: space above, the picture and a plane below it; or a large picture, space beside it.
constexpr Extent space_place{{0.4, 10.4}, {16.8, 25}}, clip_place{{0.4, 10.4}, {35.6, 25}},
    picture_place{{0.4, 0.2}, {13, 7.4}}, lower_place{{19.6, 0.2}, {35.6, 7.8}},
    section_place{{18.4, 2}, {35.6, 21}}, large_place{{0.4, 0.4}, {21.4, 25.6}},
    beside_place{{23, 8}, {35.6, 22}};

class CullingStory : public Past<steps::Started, NormalFound<double>, Finer<ViewTaken<double>>,
                                 Finer<TriangleAdded<double>>, Judged<double>, Finished> {
 public:
  CullingStory(const Words& words, const Subject& subject, By by, bool faulty)
      : words_(words),
        subject_(subject),
        by_(by),
        faulty_(faulty),
        right_(faulty ? exact_signs(subject) : std::vector<int>{}),
        space_(subject, space_in(by), by == By::determinant),
        picture_(subject, in_space() ? picture_place : large_place, by == By::determinant) {}

  dvec2 at(dvec3 p) const { return space_.at(p); }

  /// Where a method is wrong; else fronts, and what stands among others that are told already.
  double tells(const Judged<double>& j) const {
    const double central = 1 / (1 + std::abs(static_cast<double>(j.face) -
                                             std::floor(0.5 * static_cast<double>(subject_.faces.size()))));
    const bool wrong = faulty_ && (j.sign > 0) != (right_[j.face] > 0);
    return central + (j.sign > 0 ? 1 : 0) + (wrong ? 2 : 0);
  }

  Event say(const steps::Started&) const {
    constexpr std::array<std::string_view, 4> texts{"started.product", "started.area", "started.determinant",
                                                    "started.depth"};
    return {.text = texts[static_cast<std::size_t>(by_)],
            .count = std::ssize(subject_.faces),
            .level = Level::idea};
  }
  Event say(const NormalFound<double>& n) const {
    return {.text = n.normal == dvec3{0} ? "normal.none"
                    : by_ == By::depth   ? "normal.view"
                    : faulty_            ? "normal.three"
                                         : "normal",
            .facts = fields_of(n.normal),
            .words = {{"name", name()}, {"N", n.normal}},
            .key = name(),
            .phase = name()};
  }
  Event say(const ViewTaken<double>& v) const {
    return {.text = subject_.distant ? "view.distant" : "view",
            .facts = fields_of(v.view),
            .words = {{"name", name()}, {"V", v.view}, {"E", dvec3(subject_.eye)}, {"P", v.at}},
            .key = name(),
            .phase = name()};
  }
  Event say(const TriangleAdded<double>& t) const {
    return {.text = t.corner == 1 ? "triangle.first" : "triangle",
            .facts = {{"area", t.area}, {"sum", t.sum}},
            .words = {{"name", name()}},
            .key = name(),
            .phase = name()};
  }
  Event say(const Judged<double>& j) const {
    constexpr std::array<const char*, 3> branches{"back", "edge on", "front"};
    constexpr std::array<const char*, 4> texts{"product.", "area.", "determinant.", "depth."};
    const std::vector<std::string> sides{"back", "edge_on", "front"};
    const auto side = static_cast<std::size_t>(j.sign + 1);
    const auto answers = mapped(sides, [&](const auto& key) { return words_.say("side." + key); });
    Event event{
        .text = detail::sign_of(j.value) != j.sign ? "rounded"
                                                   : texts[static_cast<std::size_t>(by_)] + sides[side],
        .facts = {{"value", j.value}, {"sign", j.sign}},
        .words = {{"name", name()}, {"answer", answers[side]}, {"what", faulty_ ? "2A" : "det"}},
        .row = {name(), j.value, answers[side]},
        .key = name(),
        .phase = name(),
        .decides = Decision{words_.say("question", {{"name", name()}}), answers, side, branches[side]}};
    if (by_ == By::product) {
      event.words.push_back({"terms", terms()});
      event.row.insert(event.row.begin() + 1, {normal(), taken_view().value_or(dvec3{0})});
    }
    if (by_ == By::depth) event.row.insert(event.row.begin() + 1, normal());
    return event;
  }
  Event say(const Finished& f) const {
    Event event{.text = "finished",
                .facts = {{"tests", static_cast<std::int64_t>(f.tests)},
                          {"drawn", static_cast<std::int64_t>(f.drawn)}},
                .words = {{"skipped", f.tests - f.drawn}}};
    const auto tell = [&](std::string_view text, std::size_t face) {
      event.text = text;
      event.words.push_back({"name", subject_.faces[face].name});
      return event;
    };
    for (std::size_t i = 0; i < right_.size(); ++i) {
      const bool draws = sign_of(i) > 0;
      if (draws != (right_[i] > 0))
        return tell(draws ? "finished.drawn_wrongly" : "finished.skipped_wrongly", i);
    }
    if (faulty_) return event;
    for (std::size_t i = 0; i < subject_.rings.size(); ++i) {
      if (!faces_subject::is_flat(subject_.rings[i])) return tell("finished.not_flat", i);
    }
    if (const auto hidden = hidden_front()) return tell("finished.hidden", hidden->first);
    return event;
  }

  View draw() const {
    View view;
    std::vector<Look> looks;
    for (std::size_t i = 0; i < subject_.faces.size(); ++i) looks.push_back(look_of(i));
    space_.add(view, looks);
    picture_.add(view, looks);
    if (by_ == By::area) picture_.add_names(view, looks);
    if (by_ == By::area || !picture_.empty())
      caption(view, "z caption", in_space() ? picture_place : beside_place,
              by_ == By::area          ? "caption.space"
              : by_ == By::determinant ? "caption.divided"
                                       : "caption.picture");
    if (now<Finished>() && in_space() && !faulty_) {
      if (const auto hidden = hidden_front()) space_.add_sight(view, hidden->second);
    }
    if (face() == none) return view;
    if (by_ == By::product || by_ == By::depth)
      add_plane(view, looks);
    else
      add_turn(view);
    if (by_ == By::determinant) add_depths(view);
    return view;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  static const Extent& space_in(By by) {
    if (by == By::area) return beside_place;
    return by == By::determinant ? clip_place : space_place;
  }
  bool in_space() const { return by_ != By::area; }

  // --- What was told so far: the faces come in turn

  const Judged<double>* judged() const { return now<Judged<double>>(); }
  std::size_t face() const {
    if (now<steps::Started>() || now<Finished>()) return none;
    return all<Judged<double>>().size() - (judged() ? 1 : 0);
  }
  const std::string& name() const { return subject_.faces[face()].name; }
  std::optional<int> sign_of(std::size_t face) const {
    const auto& judged = all<Judged<double>>();
    return face < judged.size() ? std::optional(judged[face].sign) : std::nullopt;
  }
  dvec3 normal() const { return last<NormalFound<double>>()->normal; }
  /// In the world.
  dvec3 drawn_normal() const {
    const dvec3 n = normal();
    // View space is mirrored: there the cross product points inwards
    if (by_ == By::depth)
      return -(n.x * subject_.frame.right + n.y * subject_.frame.up + n.z * subject_.frame.forward);
    return n;
  }
  std::optional<dvec3> taken_view() const {
    const auto* taken = since<ViewTaken<double>, NormalFound<double>>();
    return taken ? std::optional(taken->view) : std::nullopt;
  }
  /// "0·1 + 4·(−2) + 4·3".
  std::string terms() const {
    const dvec3 view = taken_view().value_or(dvec3{0});
    std::string sum;
    for (int k = 0; k < 3; ++k) {
      const std::string first = figure_real(normal()[k]);
      sum += (k > 0 ? " + " + figure_factor(first) : first) + "·" + figure_factor(view[k]);
    }
    return sum;
  }
  /// A face that is drawn, and a place on its border that another one hides from the eye.
  std::optional<std::pair<std::size_t, dvec3>> hidden_front() const {
    const HiddenLines lines(subject_.rings, subject_.eye, 2 * subject_.radius);
    for (std::size_t i = 0; i < subject_.rings.size(); ++i) {
      if (sign_of(i).value_or(0) <= 0) continue;
      for (const auto& [a, b] : sides_of(subject_.rings[i])) {
        for (const SightPiece& piece : lines.pieces(a, b)) {
          if (piece.hidden) return std::pair(i, a + 0.5 * (piece.from + piece.to) * (b - a));
        }
      }
    }
    return std::nullopt;
  }

  // --- The drawing

  /// Above a part of the paper; a panel among many has no room for it.
  void caption(View& view, const std::string& id, const Extent& below, std::string_view key) const {
    add_caption(view, id, below, words_.say(key), 1.1, true);
  }
  Look look_of(std::size_t i) const {
    const bool its = i == face();
    if (its && !judged()) return {Role::current, false, its, 3};
    if (!sign_of(i)) return {Role::past, false, its, 1};
    if (*sign_of(i) <= 0) return {Role::rejected, true, its, 0};
    return {now<Finished>() ? Role::result : Role::accepted, false, its, 2};
  }
  void add_turn(View& view) const {
    if (const auto* triangle = since<TriangleAdded<double>, Judged<double>>())
      picture_.add_triangle(view, face(), triangle->corner,
                            triangle->area < 0 ? Role::rejected : Role::accepted);
    const Role role = !judged() ? Role::current : judged()->sign > 0 ? Role::accepted : Role::rejected;
    picture_.add_turn(view, face(), role, by_ == By::determinant);
  }
  void add_plane(View& view, const std::vector<Look>& looks) const {
    const bool seen = by_ == By::depth ? judged() != nullptr : taken_view().has_value();
    space_.add_normal(view, face(), drawn_normal());
    if (seen) space_.add_view(view, face());
    add_section(view, section_place, subject_, looks, face(), drawn_normal(), seen,
                by_ == By::depth ? std::optional(-subject_.frame.forward) : std::nullopt);
    caption(view, "z caption plane", section_place, "caption.plane");
  }
  /// Where the corners of the face lie in front of the eye and behind it.
  void add_depths(View& view) const {
    const auto rings = subject_.clip();
    double least = 0, most = 0;
    for (const Ring& ring : rings) {
      for (const dvec3 p : ring) {
        least = std::min(least, p.z);
        most = std::max(most, p.z);
      }
    }
    const double y = lower_place.centre().y;
    const NumberLine line({lower_place.lower.x + 0.6, y}, {lower_place.upper.x - 0.6, y}, least, most);
    line.add_to(view, "w", "w");
    const Ring& ring = rings[face()];
    for (std::size_t k = 0; k < ring.size(); ++k)
      view.add_named(fmt::format("w corner {:02}", k), Role::current, line.at(ring[k].z),
                     fmt::format("{}", k + 1));
    caption(view, "z caption depth", lower_place, "caption.depth");
  }

  const Words& words_;
  const Subject& subject_;
  const By by_;
  const bool faulty_;
  const std::vector<int> right_;  ///< what the exact method says, where this one may be wrong
  SpacePicture space_;
  EyePicture picture_;
};

// --- The methods

void set_up(Narrator& narrator, const Subject& subject, By by, bool faulty) {
  narrator.paper(paper_width, paper_height);
  narrator.subtitle(by == By::area          ? "subtitle.image"
                    : by == By::determinant ? "subtitle.clip"
                                            : "subtitle.object",
                    {{"count", subject.faces.size()}});
  if (by == By::area) narrator.columns({{"face", false}, {"area"}, {"side", false}});
  if (by == By::determinant) narrator.columns({{"face", false}, {faulty ? "area" : "det"}, {"side", false}});
  if (by == By::depth) narrator.columns({{"face", false}, {"N"}, {"z"}, {"side", false}});
  narrator.legend({{Role::current, "current"},
                   {Role::accepted, "front"},
                   {Role::rejected, "back"},
                   {Role::past, "waiting"},
                   {Role::result, "result"}});
}

template <By by, auto method, bool faulty = false>
void tell_method(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  set_up(narrator, subject, by, faulty);
  // A determinant needs no division; by mistake it comes after one
  if (by == By::area || (by == By::determinant && faulty))
    require_places(narrator.arguments(), subject, "faces", by == By::determinant);
  CullingStory story(narrator.words(), subject, by, faulty);
  const auto at = [&](dvec3 p) { return story.at(p); };
  narrator.handles("faces", at);
  if (subject.eye_is_near()) narrator.handles("eye", at);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::int64_t drawn = 0;
  const auto draw = [&](std::size_t) { ++drawn; };
  const auto rings = seen_by<by>(subject);
  if constexpr (by == By::product)
    method(spans_of(rings), subject.eye, draw, watch);
  else
    method(spans_of(rings), draw, watch);
  narrator.result({{"tests", std::ssize(subject.faces)}, {"drawn", drawn}});
}

struct CountedTest {
  std::string_view method;
  std::int64_t (*operations)(const Subject&);
  std::vector<int> (*signs)(const Subject&);
};
template <By by, auto method, bool behind_too = false>
constexpr CountedTest counted_test(std::string_view name) {
  return {name, operations_by<by, method>, signs_by<by, method, behind_too>};
}
constexpr std::array counted_tests{counted_test<By::area, by_area>("screen_area"),
                                   counted_test<By::area, by_misprint>("misprinted_shoelace"),
                                   counted_test<By::area, by_six>("six_products"),
                                   counted_test<By::determinant, by_division, true>("after_division"),
                                   counted_test<By::product, by_three>("first_three_corners"),
                                   counted_test<By::depth, by_depth>("eye_space_normal"),
                                   counted_test<By::determinant, by_determinant>("homogeneous"),
                                   counted_test<By::product, by_product>("normal_and_view")};

void tell_costs(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  std::vector<Cost> costs;
  for (const CountedTest& test : counted_tests)
    costs.push_back({test.method, test.operations(subject), test.signs});
  std::ranges::stable_sort(costs, {}, &Cost::operations);
  const std::vector<int> right = exact_signs(subject);
  narrator.paper(CostsStory::width, CostsStory::height);
  narrator.subtitle("subtitle.costs", {{"count", subject.faces.size()}});
  narrator.columns({{"method", false}, {"operations"}, {"wrong"}});
  narrator.legend({{Role::current, "current"},
                   {Role::accepted, "cost_right"},
                   {Role::rejected, "cost_wrong"},
                   {Role::past, "waiting"}});
  CostsStory story(narrator.words(), subject, costs);
  narrator.tell_whole(story, [&](const auto& watch) {
    for (std::size_t i = 0; i < costs.size(); ++i) {
      const std::vector<int> signs = costs[i].signs(subject);
      std::optional<std::int64_t> wrong;
      for (std::size_t k = 0; k < signs.size(); ++k)
        wrong = wrong.value_or(0) + ((signs[k] > 0) != (right[k] > 0) ? 1 : 0);
      watch(MethodCounted{i, costs[i].operations, wrong}, 0);
    }
  });
  narrator.telling({std::ssize(costs) + 1, 0});
  narrator.result({{"faces", std::ssize(subject.faces)}});
}

const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "signs", .same = SameList::set, .type = "Judged", .fields = {"key", "sign"}}},
      // Seen from its edge
      .is_tie = [](const TraceStep& step) {
        return step.type == "Judged" && value_as<std::int64_t>(step.fields, "sign") == 0;
      }};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const Sizes sizes{1e-6, 1e9};
  static const auto faces = [] {
    Parameter parameter = faces_subject::faces_parameter(
        "+z: -1,-1,1 1,-1,1 1,1,1 -1,1,1; -z: 1,-1,-1 -1,-1,-1 -1,1,-1 1,1,-1; "
        "+x: 1,-1,1 1,-1,-1 1,1,-1 1,1,1; -x: -1,-1,-1 -1,-1,1 -1,1,1 -1,1,-1; "
        "+y: -1,1,1 1,1,1 1,1,-1 -1,1,-1; -y: -1,-1,-1 1,-1,-1 1,-1,1 -1,-1,1",
        "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 1,2,2 3,1,-1");
    parameter.help = "what is looked at: faces, counter-clockwise seen from outside";
    parameter.sizes = sizes;
    return parameter;
  }();
  static const TopicEntry topic = completed<entry>(
      {.name = "back_face_culling",
       .chapter = "visibility",
       .aliases = {"backface culling", "back-face removal", "facing"},
       .summary = "faces that turn their backs to the eye are skipped, one test each",
       .methods =
           {{.name = "normal_and_view",
             .standing = Standing::taught,
             .tell = tell_method<By::product, by_product>,
             .unread = {"model"}},
            {.name = "screen_area", .tell = tell_method<By::area, by_area>, .unread = {"model"}},
            {.name = "homogeneous",
             .tell = tell_method<By::determinant, by_determinant>,
             .unread = {"model"}},
            {.name = "of_a_model", .tell = tell_model, .function = "normal_and_view", .unread = {"faces"}},
            {.name = "by_cost", .tell = tell_costs, .function = "screen_area", .unread = {"model"}},
            {.name = "first_three_corners",
             .standing = Standing::faulty,
             .tell = tell_method<By::product, by_three, true>,
             .unread = {"model"}},
            {.name = "eye_space_normal",
             .standing = Standing::faulty,
             .tell = tell_method<By::depth, by_depth, true>,
             .unread = {"model"}},
            {.name = "after_division",
             .standing = Standing::faulty,
             .tell = tell_method<By::determinant, by_division, true>,
             .unread = {"model"}},
            {.name = "misprinted_shoelace",
             .standing = Standing::faulty,
             .tell = tell_method<By::area, by_misprint, true>,
             .unread = {"model"}},
            {.name = "six_products",
             .standing = Standing::faulty,
             .tell = tell_method<By::area, by_six, true>,
             .unread = {"model"}}},
       .default_method = "normal_and_view",
       .columns = {{"face", false}, {"N"}, {"V"}, {"product"}, {"side", false}},
       .counts = {"NormalFound", "ViewTaken", "Judged"},
       .parameters = {faces,
                      {"model", ParameterType::model, "", "MODEL.obj",
                       "what of_a_model culls, brought to a radius of 1.5 round 0,0,0; a cow if not given"},
                      parameters::numbers("eye", "2,1.8,2.9", "3,4,5", "where the eye is", parameters::xyz,
                                          sizes),
                      parameters::instead_of("eye", faces_subject::towards_parameter("")),
                      parameters::numbers("target", "0,0,0", "0,1,0",
                                          "what the eye looks at: the middle of its picture", parameters::xyz,
                                          sizes)},
       .examples = {"--eye 3,0,0.5", "--method screen_area", "--towards 1,2,3", "--method of_a_model"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::back_face_culling
