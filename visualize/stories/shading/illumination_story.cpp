// The story of illumination: what each lamp adds to the colour of one place, what lecture notes make of it,
// and what lamps of all kinds make of a room.

#include "core/arithmetic/elementary.hpp"
#include "shading/illumination/illumination.hpp"

#include "shading/illumination/illumination_notes.hpp"
#include "stories/parameters.hpp"
#include "stories/past.hpp"
#include "stories/shading/illumination/drawing.hpp"
#include "stories/shading/illumination/lobe_story.hpp"
#include "stories/shading/illumination/pictures.hpp"

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

class PlaceStory
    : public Past<AmbientAdded<double>, LampTaken<double>, LightAdded<double>, Finished<double>> {
 public:
  PlaceStory(const Words& words, const Subject& subject, PlaceDrawing drawing, Balls balls, Mirror mirror,
             Fault fault, Right right)
      : words_(words),
        subject_(subject),
        drawing_(std::move(drawing)),
        balls_(std::move(balls)),
        mirror_(mirror),
        fault_(fault),
        right_(std::move(right)) {}

  const PlaceDrawing& drawing() const { return drawing_; }
  /// Where the method's fault shows; of Phong's model, where there is a highlight.
  bool tells(const LightAdded<double>& s) const {
    return fault_ == Fault::none ? s.specular != dvec3{0} : is_off(s);
  }

  Event say(const AmbientAdded<double>& a) const {
    return {.text = "ambient",
            .facts = {{"ambient", a.ambient.x}},
            .words = {{"ambient", short_colour(a.ambient)}},
            .count = std::ssize(subject_.lights),
            .row = {words_.say("row.ambient"), "", "", "", "", "", short_colour(a.ambient)},
            .begins = true};
  }
  Event say(const LampTaken<double>& t) const {
    const Light& light = subject_.lights[t.light];
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
      event.words.push_back({"off", degrees_text(off_axis(light, a))});
      event.words.push_back({"outer", degrees_text(degrees_of(light.outer_cosine))});
    }
    if (light.kind == Light::Kind::spot || light.kind == Light::Kind::area || light.range < 1e300)
      event.decides =
          yes_or_no(words_, "question.arrives", {{"lamp", name(t)}}, a.share() > 0, "arrives", "lost");
    return event;
  }
  Event say(const LightAdded<double>& s) const {
    const std::size_t answer = s.specular != dvec3{0} ? 2 : s.diffuse != dvec3{0} ? 1 : 0;
    constexpr std::array branches{"nothing", "scattered", "highlight"};
    std::vector<std::string> answers;
    for (const char* branch : branches) answers.push_back(words_.say(fmt::format("answer.{}", branch)));
    return {
        .text = added_text(s),
        .facts = {{"n_dot_l", s.n_dot_l}, {"cosine", s.cosine}},
        .words = {{"lamp", name(s)},
                  {"NL", short_real(s.n_dot_l)},
                  {"RV", short_real(s.cosine)},
                  {"product", words_.say(mirror_ == Mirror::reflected ? "product.phong" : "product.blinn")},
                  {"n", subject_.surface.shininess},
                  {"f", short_real(s.arrival.share())},
                  {"taken", short_colour(-s.diffuse)},
                  {"power", short_real(gradus::pow(s.cosine, subject_.surface.shininess))},
                  {"diffuse", short_colour(s.diffuse)},
                  {"specular", short_colour(s.specular)},
                  {"right_NL", short_real(right_one().n_dot_l)},
                  {"right_specular", short_colour(right_one().specular)}},
        .row = {name(s), short_real(s.arrival.share()), short_real(s.n_dot_l), short_real(s.cosine),
                short_colour(s.diffuse), short_colour(s.specular),
                short_colour(sum_of(all<LightAdded<double>>()))},
        .key = key(s),
        .phase = words_.say("phase.parts"),
        .decides = Decision{words_.say("question.adds", {{"lamp", name(s)}}), std::move(answers), answer,
                            branches[answer]}};
  }
  Event say(const Finished<double>& f) const {
    const dvec3 sum = f.ambient + f.diffuse + f.specular;
    const bool off = !(glm::length(sum - right_.sum) <= least_off);
    return {.text = off ? "finished.off" : "finished",
            .facts = facts_of(sum),
            .words = {{"ambient", short_colour(f.ambient)},
                      {"diffuse", short_colour(f.diffuse)},
                      {"specular", short_colour(f.specular)},
                      {"sum", short_colour(sum)},
                      {"right", short_colour(right_.sum)}}};
  }

  View draw() const { return drawing_.with_balls(vectors(), balls_); }

 private:
  View vectors() const {
    View view;
    const bool ended = now<Finished<double>>();
    const LampTaken<double>* taken = ended ? nullptr : last<LampTaken<double>>();
    const LightAdded<double>* added = now<LightAdded<double>>();
    drawing_.add_surface(view);
    drawing_.add_lamps(view, taken ? taken->light : ended ? subject_.lights.size() : PlaceDrawing::none);
    drawing_.add_colour(view, pieces(), right_so_far());
    if (!added) drawing_.add_viewer(view);
    if (!taken) return view;
    const Light& light = subject_.lights[taken->light];
    drawing_.add_way(view, *taken, light);
    if (fault_ == Fault::minus_normal)
      drawing_.add_right_way(view, towards(light, taken->sample, subject_.place).first);
    if (!added) return view;
    const bool scatters = !(added->diffuse.x < 0) && added->n_dot_l > 0, shines = added->specular != dvec3{0};
    drawing_.add_scattered(view, *added, scatters ? Role::accepted : Role::rejected);
    drawing_.add_mirrored(view, *added, shines ? Role::measure : Role::rejected, subject_.surface.shininess);
    return view;
  }

  /// Differences of colours that a figure shows.
  static constexpr double least_off = 5e-4;

  template <class Step>
  bool of_area(const Step& s) const {
    return subject_.lights[s.light].kind == Light::Kind::area;
  }
  template <class Step>
  std::string name(const Step& s) const {
    if (!of_area(s)) return fmt::format("{}", s.light + 1);
    return words_.say("point", {{"number", s.light + 1}, {"point", s.sample + 1}});
  }
  /// "2", "1.3" for a point of an area.
  template <class Step>
  std::string key(const Step& s) const {
    return of_area(s) ? fmt::format("{}.{}", s.light + 1, s.sample + 1) : fmt::format("{}", s.light + 1);
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
  const LightAdded<double>& right_one() const { return right_.lamps[all<LightAdded<double>>().size() - 1]; }
  bool is_off(const LightAdded<double>& s) const {
    const auto& right = right_one();
    return fault_ != Fault::none &&
           !(glm::length(s.diffuse - right.diffuse) + glm::length(s.specular - right.specular) <= least_off);
  }
  std::string_view added_text(const LightAdded<double>& s) const {
    if (is_off(s)) {
      if (fault_ == Fault::tinted) return "fault.tinted";
      if (fault_ == Fault::minus_normal) return "fault.minus_normal";
      if (fault_ == Fault::behind) return s.cosine > 0 ? "fault.behind" : "fault.zero";
      if (!(s.specular.x == s.specular.x)) return "fault.nan";
      if (s.diffuse.x < -s.specular.x) return "fault.taken";
      return s.cosine < 0 ? "fault.power" : "fault.behind";
    }
    if (!(s.arrival.share() > 0)) return "added.lost";
    if (!(s.n_dot_l > 0)) return "added.behind";
    if (s.specular == dvec3{0}) return s.cosine > 0 ? "added.scattered" : "added.away";
    return "added";
  }

  /// The ambient part and what these lamps add.
  dvec3 sum_of(std::span<const LightAdded<double>> lamps) const {
    dvec3 sum = last<AmbientAdded<double>>()->ambient;
    for (const auto& lamp : lamps) sum += lamp.diffuse + lamp.specular;
    return sum;
  }
  /// What Phong's model has by now, beside a faulty method's colour.
  std::optional<dvec3> right_so_far() const {
    const std::size_t looked = all<LightAdded<double>>().size();
    if (fault_ == Fault::none || looked == 0) return std::nullopt;
    return sum_of(std::span(right_.lamps).first(looked));
  }
  std::vector<Piece> pieces() const {
    std::vector<Piece> pieces{{Role::past, last<AmbientAdded<double>>()->ambient, false}};
    for (const auto& lamp : all<LightAdded<double>>()) {
      const bool fresh = &lamp == now<LightAdded<double>>();
      pieces.push_back({Role::accepted, lamp.diffuse, fresh});
      pieces.push_back({Role::measure, lamp.specular, fresh});
    }
    return pieces;
  }

  const Words& words_;
  const Subject& subject_;
  const PlaceDrawing drawing_;
  const Balls balls_;
  const Mirror mirror_;
  const Fault fault_;
  const Right right_;
};

// --- The methods

constexpr auto phongs = [](const auto&... a) { return phong(a...); };
constexpr auto blinns = [](const auto&... a) { return blinn_phong(a...); };

/// Runs a method on the subject, in white ambient light.
template <class Method, class Watch>
Parts<double> run(const Subject& t, const Method& method, const Watch& watch) {
  return method(t.place, t.normal, t.eye, t.surface, t.lamps(), dvec3{1}, AllSeen{}, watch);
}

/// The same, recorded.
template <class Method>
Right recorded(const Subject& subject, const Method& method) {
  Right right{};
  const auto keep = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, LightAdded<double>>) right.lamps.push_back(step);
  };
  right.sum = run(subject, method, keep).sum();
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

template <auto method, Fault fault = Fault::none, Mirror mirror = Mirror::reflected>
void tell_place(Narrator& narrator) {
  constexpr bool reflects = mirror == Mirror::reflected;
  const Subject subject = subject_of(narrator.arguments());
  const Right right = reflects ? recorded(subject, phongs) : recorded(subject, blinns);
  const Right own = recorded(subject, method);
  bool below = glm::dot(subject.eye - subject.place, subject.normal) < 0;
  for (const Right* run : {&right, &own}) {
    for (const auto& lamp : run->lamps) below = below || lamp.n_dot_l < 0;
  }
  lay_paper(narrator, place_paper_width, place_paper_height);
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(subject.lights));
  narrator.columns(
      {{"lamp", false}, {"f"}, {"NL"}, {reflects ? "RV" : "NH"}, {"diffuse"}, {"specular"}, {"sum"}});
  narrator.legend({{Role::current, "current"},
                   {Role::past, "ambient"},
                   {Role::accepted, fault == Fault::none ? "scattered" : "scattered.right"},
                   {Role::measure, "highlight"},
                   {Role::rejected, "rejected"}});
  const PlaceDrawing drawing(narrator.words(), subject, mirror, below, brightest_of(own, right));
  if (drawing.is_high()) narrator.trace().grid.lines = 0.75;  // its names have room between the vectors
  const Balls balls(subject, drawing.left(), [&](dvec3 normal) {
    Subject turned = subject;
    turned.normal = normal;
    return run(turned, method, Unobserved{});
  });
  PlaceStory story(narrator.words(), subject, drawing, balls, mirror, fault, right);
  narrator.handles("lights", [&](dvec3 position) {
    return story.drawing().lamp_at(moved_to(position, subject.lights[0], narrator.arguments()));
  });
  narrator.handles("eye", [&](dvec3 eye) { return story.drawing().eye_at(eye); });
  narrator.telling({2, 0});  // where no lamp tells more: the first
  run(subject, method, narrator.watcher(story));
  narrator.result(facts_of(own.sum));
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-6, 1e6}, part{1e-6, 1e3};
  const auto of_place = [](std::string name, Standing standing, void (*tell)(Narrator&)) {
    return Method{.name = std::move(name), .standing = standing, .tell = tell, .unread = {"exponents"}};
  };
  static const TopicEntry topic = completed<entry>(
      {.name = "illumination",
       .chapter = "shading",
       .aliases = {"phong illumination", "phong reflection", "blinn-phong", "lights", "lambert", "highlight"},
       .summary = "what each lamp adds to the colour of a place: scattered light and a highlight",
       .methods =
           {of_place("phong", Standing::taught, tell_place<phongs>),
            of_place("blinn_phong", Standing::plain, tell_place<blinns, Fault::none, Mirror::halfway>),
            {.name = "lights_side_by_side",
             .tell = tell_lights,
             .function = "phong",
             .unread = {"exponents", "lights", "kind", "aim", "place", "normal", "eye"}},
            {.name = "highlight_lobes",
             .tell = tell_lobes,
             .function = "phong",
             .unread = {"kind", "aim", "eye", "ka", "kd", "ks", "shininess", "colour", "attenuation", "range",
                        "cone", "concentration", "side", "samples"}},
            of_place("unclamped", Standing::faulty,
                     tell_place<[](const auto&... a) { return unclamped(a...); }, Fault::unclamped>),
            of_place("light_behind", Standing::faulty,
                     tell_place<[](const auto&... a) { return light_behind(a...); }, Fault::behind>),
            of_place("tinted_highlight", Standing::faulty,
                     tell_place<[](const auto&... a) { return tinted_highlight(a...); }, Fault::tinted>),
            of_place(
                "light_minus_normal", Standing::faulty,
                tell_place<[](const auto&... a) { return light_minus_normal(a...); }, Fault::minus_normal>)},
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
            integer(1, 16, "samples", "4", "2", "of an area: how many points per side it is sampled with"),
            points(1, 6, "exponents", "1 5 20 100", "2 8 32", "whose highlights are drawn", {"n"},
                   {1e-3, 1e4})},
       .examples = {"--lights '0,3,4 0,-4,2 0,2,-1' --eye 0,-3,4",
                    "--kind spot --lights '0,3,4' --aim 0,2,0 --cone 15,30",
                    "--method lights_side_by_side --samples 6 --side 3"}});
  return topic;
}

}  // namespace gradus::illumination
