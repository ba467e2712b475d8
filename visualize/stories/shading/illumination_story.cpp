// The story of illumination: what each lamp adds to the colour of one place, what lecture notes make of it,
// and what lamps of all kinds make of a room.

#include "core/arithmetic/elementary.hpp"
#include "shading/illumination/illumination.hpp"

#include "shading/illumination/illumination_notes.hpp"
#include "stories/parameters.hpp"
#include "stories/shading/highlight_lobes.hpp"
#include "stories/shading/illumination_drawing.hpp"
#include "stories/shading/lights_side_by_side.hpp"

namespace gradus::illumination {
namespace {

/// What a method does otherwise than Phong.
enum class Fault { none, unclamped, behind, tinted, minus_normal };

/// The lamps as Phong's model has them, for comparison.
struct Right {
  std::vector<LightAdded<double>> lamps;
  dvec3 sum;
};

/// A colour for programs; nothing where it is none.
std::vector<Field> facts_of(const dvec3& colour) {
  if (!std::isfinite(colour.x + colour.y + colour.z)) return {};
  return {{"red", colour.x}, {"green", colour.y}, {"blue", colour.z}};
}

class PlaceStory {
 public:
  PlaceStory(const Words& words, const Task& task, PlaceDrawing drawing, Mirror mirror, Fault fault,
             Right right)
      : words_(words),
        task_(task),
        drawing_(std::move(drawing)),
        mirror_(mirror),
        fault_(fault),
        right_(std::move(right)) {}

  const PlaceDrawing& drawing() const { return drawing_; }
  /// The first step whose figure shows the method's fault, or the first that adds something.
  StepNumber telling() const { return telling_.value_or(StepNumber{2, 0}); }

  void show(Board& board, const AmbientAdded<double>& a) {
    pieces_.push_back({Role::past, a.ambient, false});
    put(board);
  }
  Event say(const AmbientAdded<double>& a) const {
    return {.text = "ambient",
            .facts = {{"ambient", a.ambient.x}},
            .words = {{"ambient", short_colour(a.ambient)}},
            .count = std::ssize(task_.lights),
            .row = {words_.say("row.ambient"), "", "", "", "", "", short_colour(a.ambient)},
            .begins = true};
  }

  void show(Board& board, const LampTaken<double>& t) {
    taken_ = t;
    added_.reset();
    for (Piece& piece : pieces_) piece.fresh = false;
    put(board);
  }
  Event say(const LampTaken<double>& t) const {
    const Light& light = task_.lights[t.light];
    const Arrival<double>& a = t.arrival;
    Event event{.text = way_text(light, a),
                .facts = {{"distance", a.distance}, {"share", a.share()}},
                .words = {{"lamp", name(t)},
                          {"L", figure_place(a.to_light, short_real)},
                          {"d", a.distance},
                          {"f", short_real(a.share())},
                          {"range", light.range}},
                .key = key(t),
                .phase = words_.say("phase.lamps")};
    if (light.kind == Light::Kind::spot) {
      const double off = degrees_of(-glm::dot(unit_vector(light.direction), a.to_light));
      event.words.push_back({"off", LobeStory::degrees(off)});
      event.words.push_back({"outer", LobeStory::degrees(degrees_of(light.outer_cosine))});
    }
    if (light.kind == Light::Kind::spot || light.kind == Light::Kind::area || light.range < 1e300)
      event.decides =
          yes_or_no(words_, "question.arrives", {{"lamp", name(t)}}, a.share() > 0, "arrives", "lost");
    return event;
  }

  void show(Board& board, const LightAdded<double>& s) {
    added_ = s;
    pieces_.push_back({Role::accepted, s.diffuse, true});
    pieces_.push_back({Role::measure, s.specular, true});
    sum_ += s.diffuse + s.specular;
    ++looked_;
    put(board);
    const bool tells = fault_ == Fault::none ? s.specular != dvec3{0} : is_off(s);
    if (tells && !telling_) telling_ = {number_ - 1, 0};
  }
  Event say(const LightAdded<double>& s) const {
    const std::size_t answer = s.specular != dvec3{0} ? 2 : s.diffuse != dvec3{0} ? 1 : 0;
    constexpr std::array<const char*, 3> branches{"nothing", "scattered", "highlight"};
    return {
        .text = added_text(s),
        .facts = {{"n_dot_l", s.n_dot_l}, {"cosine", s.cosine}},
        .words = {{"lamp", name(s)},
                  {"NL", short_real(s.n_dot_l)},
                  {"RV", short_real(s.cosine)},
                  {"product", words_.say(mirror_ == Mirror::reflected ? "product.phong" : "product.blinn")},
                  {"n", task_.surface.shininess},
                  {"f", short_real(s.arrival.share())},
                  {"taken", short_colour(-s.diffuse)},
                  {"power", short_real(gradus::pow(s.cosine, task_.surface.shininess))},
                  {"diffuse", short_colour(s.diffuse)},
                  {"specular", short_colour(s.specular)},
                  {"right_NL", short_real(right_one().n_dot_l)},
                  {"right_specular", short_colour(right_one().specular)}},
        .row = {name(s), short_real(s.arrival.share()), short_real(s.n_dot_l), short_real(s.cosine),
                short_colour(s.diffuse), short_colour(s.specular), short_colour(so_far())},
        .key = key(s),
        .phase = words_.say("phase.parts"),
        .decides = Decision{
            words_.say("question.adds", {{"lamp", name(s)}}),
            {words_.say("answer.nothing"), words_.say("answer.scattered"), words_.say("answer.highlight")},
            answer,
            branches[answer]}};
  }

  void show(Board& board, const Finished<double>&) {
    for (Piece& piece : pieces_) piece.fresh = false;
    ended_ = true;
    put(board);
  }
  Event say(const Finished<double>& f) const {
    const dvec3 sum = f.ambient + f.diffuse + f.specular;
    const bool off = !(glm::length(sum - right_.sum) <= 5e-4);
    return {.text = off ? "finished.off" : "finished",
            .facts = facts_of(sum),
            .words = {{"ambient", short_colour(f.ambient)},
                      {"diffuse", short_colour(f.diffuse)},
                      {"specular", short_colour(f.specular)},
                      {"sum", short_colour(sum)},
                      {"right", short_colour(right_.sum)}}};
  }

 private:
  template <class Step>
  std::string name(const Step& s) const {
    if (task_.lights[s.light].kind != Light::Kind::area) return fmt::format("{}", s.light + 1);
    return words_.say("point", {{"number", s.light + 1}, {"point", s.sample + 1}});
  }
  /// "2", "1.3" for a point of an area.
  template <class Step>
  std::string key(const Step& s) const {
    const bool area = task_.lights[s.light].kind == Light::Kind::area;
    return area ? fmt::format("{}.{}", s.light + 1, s.sample + 1) : fmt::format("{}", s.light + 1);
  }
  std::string_view way_text(const Light& light, const Arrival<double>& a) const {
    if (a.to_light == dvec3{0}) return "way.here";
    if (!(a.window > 0)) return "way.beyond";
    if (light.kind == Light::Kind::directional) return "way.directional";
    if (light.kind == Light::Kind::spot) return a.cone > 0 ? "way.inside" : "way.outside";
    if (light.kind == Light::Kind::area) return a.facing > 0 ? "way.area" : "way.averted";
    return fault_ == Fault::minus_normal ? "way.minus_normal" : light.range < 1e300 ? "way.within" : "way";
  }
  /// The lamp at hand, as Phong's model has it.
  const LightAdded<double>& right_one() const { return right_.lamps[looked_ - 1]; }
  bool is_off(const LightAdded<double>& s) const {
    const auto& right = right_one();
    return fault_ != Fault::none &&
           !(glm::length(s.diffuse - right.diffuse) + glm::length(s.specular - right.specular) <= 5e-4);
  }
  std::string_view added_text(const LightAdded<double>& s) const {
    const bool off = is_off(s);
    if (off && fault_ == Fault::tinted) return "fault.tinted";
    if (off && fault_ == Fault::minus_normal) return "fault.minus_normal";
    if (off && fault_ == Fault::behind) return s.cosine > 0 ? "fault.behind" : "fault.zero";
    if (off && !(s.specular.x == s.specular.x)) return "fault.nan";
    if (off && s.diffuse.x < -s.specular.x) return "fault.taken";
    if (off) return s.cosine < 0 ? "fault.power" : "fault.behind";
    if (!(s.arrival.share() > 0)) return "added.lost";
    if (!(s.n_dot_l > 0)) return "added.behind";
    if (s.specular == dvec3{0}) return s.cosine > 0 ? "added.scattered" : "added.away";
    return "added";
  }
  dvec3 so_far() const { return pieces_.front().value + sum_; }

  /// What Phong's model has by now, beside a faulty method's colour.
  std::optional<dvec3> right_so_far() const {
    if (fault_ == Fault::none || looked_ == 0) return std::nullopt;
    dvec3 sum = pieces_.front().value;
    for (std::size_t i = 0; i < looked_; ++i) sum += right_.lamps[i].diffuse + right_.lamps[i].specular;
    return sum;
  }

  void put(Board& board) {
    board.milestone(view());
    ++number_;
  }
  View view() const {
    View view;
    drawing_.add_surface(view);
    const std::size_t at_hand = taken_ && !ended_ ? taken_->light
                                : ended_          ? task_.lights.size()
                                                  : PlaceDrawing::none;
    drawing_.add_lamps(view, at_hand);
    drawing_.add_colour(view, pieces_, right_so_far());
    if (!taken_ || ended_) {
      drawing_.add_viewer(view);
      return view;
    }
    drawing_.add_way(view, *taken_, task_.lights[taken_->light]);
    if (fault_ == Fault::minus_normal) {
      const dvec3 l = towards(task_.lights[taken_->light], taken_->sample, task_.place).first;
      drawing_.add_right_way(view, l);
    }
    if (!added_) {
      drawing_.add_viewer(view);
      return view;
    }
    drawing_.add_scattered(view, *added_,
                           added_->diffuse.x < 0 || !(added_->n_dot_l > 0) ? Role::rejected : Role::accepted);
    drawing_.add_mirrored(view, *added_, added_->specular == dvec3{0} ? Role::rejected : Role::measure,
                          task_.surface.shininess);
    return view;
  }

  const Words& words_;
  const Task& task_;
  const PlaceDrawing drawing_;
  const Mirror mirror_;
  const Fault fault_;
  const Right right_;
  std::vector<Piece> pieces_{};
  dvec3 sum_{0};
  std::optional<LampTaken<double>> taken_{};
  std::optional<LightAdded<double>> added_{};
  std::size_t looked_ = 0;
  std::int64_t number_ = 0;
  bool ended_ = false;
  std::optional<StepNumber> telling_{};
};

// --- The methods

constexpr auto phongs = [](const auto&... a) { return phong(a...); };
constexpr auto blinns = [](const auto&... a) { return blinn_phong(a...); };

/// Runs a method on the task, in white ambient light.
template <class Method, class Watch>
Parts<double> run(const Task& t, const Method& method, const Watch& watch) {
  return method(t.place, t.normal, t.eye, t.surface, t.lamps(), dvec3{1}, AllSeen{}, watch);
}

/// The same, recorded.
template <class Method>
Right recorded(const Task& task, const Method& method) {
  Right right{};
  const auto keep = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, LightAdded<double>>) right.lamps.push_back(step);
  };
  right.sum = run(task, method, keep).sum();
  return right;
}

/// The end of the bar: 1, or what the colour comes to.
double brightest_of(const Right& own, const Right& right) {
  double most = 1;
  for (int k = 0; k < 3; ++k) {
    for (const double sum : {own.sum[k], right.sum[k]}) {
      if (std::isfinite(sum)) most = std::max(most, sum);
    }
  }
  return most > 1 ? std::ceil(most * 2) / 2 : 1;
}

template <class Method>
void tell_place(Narrator& narrator, const Method& method, Mirror mirror = Mirror::reflected,
                Fault fault = Fault::none) {
  const Task task = task_of(narrator.arguments());
  const Right right = mirror == Mirror::reflected ? recorded(task, phongs) : recorded(task, blinns);
  const Right own = recorded(task, method);
  bool below = glm::dot(task.eye - task.place, task.normal) < 0;
  for (const Right* run : {&right, &own}) {
    for (const auto& lamp : run->lamps) below = below || lamp.n_dot_l < 0;
  }
  narrator.paper(place_paper_width, place_paper_height);
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(task.lights));
  narrator.columns({{"lamp", false},
                    {"f"},
                    {"NL"},
                    {mirror == Mirror::reflected ? "RV" : "NH"},
                    {"diffuse"},
                    {"specular"},
                    {"sum"}});
  narrator.legend({{Role::current, "current"},
                   {Role::past, "ambient"},
                   {Role::accepted, fault == Fault::none ? "scattered" : "scattered.right"},
                   {Role::measure, "highlight"},
                   {Role::rejected, "rejected"}});
  PlaceStory story(narrator.words(), task,
                   PlaceDrawing(narrator.words(), task, mirror, below, brightest_of(own, right)), mirror,
                   fault, right);
  narrator.handles("lights", [&](dvec3 position) {
    return story.drawing().lamp_at(moved_to(position, task.lights[0], narrator.arguments()));
  });
  narrator.handles("eye", [&](dvec3 eye) { return story.drawing().eye_at(eye); });
  run(task, method, narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result(facts_of(own.sum));
}

void tell_phong(Narrator& narrator) { tell_place(narrator, phongs); }
void tell_blinn_phong(Narrator& narrator) { tell_place(narrator, blinns, Mirror::halfway); }

template <class Method>
void tell_faulty(Narrator& narrator, const Method& method, Fault fault) {
  tell_place(narrator, method, Mirror::reflected, fault);
}
void tell_unclamped(Narrator& narrator) {
  tell_faulty(narrator, [](const auto&... a) { return unclamped(a...); }, Fault::unclamped);
}
void tell_light_behind(Narrator& narrator) {
  tell_faulty(narrator, [](const auto&... a) { return light_behind(a...); }, Fault::behind);
}
void tell_tinted_highlight(Narrator& narrator) {
  tell_faulty(narrator, [](const auto&... a) { return tinted_highlight(a...); }, Fault::tinted);
}
void tell_light_minus_normal(Narrator& narrator) {
  tell_faulty(narrator, [](const auto&... a) { return light_minus_normal(a...); }, Fault::minus_normal);
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-6, 1e6}, part{1e-6, 1e3};
  static const TopicEntry topic = completed<entry>(
      {.name = "illumination",
       .chapter = "shading",
       .aliases = {"phong illumination", "phong reflection", "blinn-phong", "lights", "lambert", "highlight"},
       .summary = "what each lamp adds to the colour of a place: scattered light and a highlight",
       .methods =
           {{.name = "phong", .standing = Standing::taught, .tell = tell_phong, .unread = {"exponents"}},
            {.name = "blinn_phong", .tell = tell_blinn_phong, .unread = {"exponents"}},
            {.name = "lights_side_by_side",
             .tell = tell_lights,
             .function = "phong",
             .unread = {"exponents", "lights", "kind", "aim", "place", "normal", "eye"}},
            {.name = "highlight_lobes",
             .tell = tell_lobes,
             .function = "phong",
             .unread = {"kind", "aim", "eye", "ka", "kd", "ks", "shininess", "colour", "attenuation", "range",
                        "cone", "concentration", "side", "samples"}},
            {.name = "unclamped",
             .standing = Standing::faulty,
             .tell = tell_unclamped,
             .unread = {"exponents"}},
            {.name = "light_behind",
             .standing = Standing::faulty,
             .tell = tell_light_behind,
             .unread = {"exponents"}},
            {.name = "tinted_highlight",
             .standing = Standing::faulty,
             .tell = tell_tinted_highlight,
             .unread = {"exponents"}},
            {.name = "light_minus_normal",
             .standing = Standing::faulty,
             .tell = tell_light_minus_normal,
             .unread = {"exponents"}}},
       .default_method = "phong",
       .parameters =
           {points(1, 8, "lights", "0,3,4", "0,3,4 0,-4,2 0,2,-1", "where the lamps stand", xyz, modest),
            numbers("place", "0,0,0", "100,0,0", "the place on the surface", xyz, modest),
            numbers("normal", "0,0,1", "0,1,0", "its normal, of any length", xyz, modest),
            numbers("eye", "0,-2,5", "0,-3,4", "where the viewer is", xyz, modest),
            number("ka", "0.1", "0.2", "the share of ambient light", part),
            number("kd", "0.7", "0.5", "the share that is scattered", part),
            number("ks", "0.2", "0.4", "the share in the highlight", part),
            number("shininess", "10", "40", "the exponent of the highlight", {1e-3, 1e4}),
            {.name = "colour",
             .type = ParameterType::color,
             .default_value = "#ffffff",
             .example = "red",
             .help = "of the surface; the highlight has the light's"},
            choice("kind", {"point", "directional", "spot", "area"}, "point", "spot", "what the lamps are"),
            numbers("aim", "", "1,0,0",
                    "where spots, areas and parallel light point to; without it the place", xyz, modest),
            numbers("attenuation", "1,0,0", "1,0.1,0.02",
                    "light is divided by constant + linear d + quadratic d^2",
                    {"constant", "linear", "quadratic"}, {1e-9, 1e6}),
            number("range", "", "8", "from where on a lamp adds nothing; without it there is no end", modest),
            numbers("cone", "20,40", "0,30",
                    "of a spot: where its edge begins and ends, in degrees from its axis", {"inner", "outer"},
                    {1e-3, 180}),
            number("concentration", "0", "8", "of a spot: the power that weakens it away from its axis",
                   {1e-3, 1e3}),
            number("side", "2.4", "1", "of an area: the side of its square", {1e-3, 1e3}),
            integer(1, 16, "samples", "4", "2", "of an area: how many points a side it is sampled with"),
            points(1, 6, "exponents", "1 5 20 100", "2 8 32", "whose highlights are drawn", {"n"},
                   {1e-3, 1e4})},
       .examples = {"--lights '0,3,4 0,-4,2 0,2,-1' --eye 0,-3,4",
                    "--kind spot --lights '0,3,4' --aim 0,2,0 --cone 15,30",
                    "--method lights_side_by_side --samples 6 --side 3"}});
  return topic;
}

}  // namespace gradus::illumination
