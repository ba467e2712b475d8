// The story of samples that keep their distance: which place was tried, how far its nearest neighbour is, and
// whether that is far enough.

#include "antialiasing/poisson_disc/poisson_disc.hpp"

#include "stories/antialiasing/poisson_disc/drawing.hpp"
#include "stories/antialiasing/poisson_disc/pictures.hpp"
#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::poisson_disc {
namespace {

constexpr auto drop = [](dvec2) {};

/// Samples between one and two radii from another, or anywhere.
class DiscStory {
 public:
  DiscStory(const Words& words, const Area& area, double radius, bool beside)
      : words_(words),
        area_(area),
        radius_(radius),
        beside_(beside),
        grid_(area, radius),
        sheet_(area, area.wraps ? 0.6 * radius : 0) {}

  const Panel& panel() const { return sheet_.panel(); }
  StepNumber telling() const { return telling_; }
  const std::vector<dvec2>& samples() const { return samples_; }

  void show(Board& board, const Started&) { put(board, true); }
  Event say(const Started& s) const {
    return {.text = beside_ ? "started" : "started.darts",
            .facts = {{"columns", s.cells.x}, {"rows", s.cells.y}, {"radius", s.radius}},
            .words = {{"radius", radius_}}};
  }

  void show(Board&, const Chosen& c) { chosen_ = c.sample; }
  Event say(const Chosen&) const { return {}; }

  void show(Board& board, const Tried& t) {
    tried_ = t;
    if (t.kept) {
      samples_.push_back(t.place);
      active_.push_back(t.place);
      refused_ = 0;
    } else {
      ++refused_;
    }
    ++tries_;
    note_gaps();
    note_telling(t);
    put(board, t.kept);
  }
  Event say(const Tried& t) const {
    const bool alone = t.nearest == std::numeric_limits<double>::infinity();
    Event event{.text = key_of(t),
                .facts = {{"x", t.place.x}, {"y", t.place.y}, {"inside", t.inside}, {"kept", t.kept}},
                .words = {{"place", t.place}, {"radius", radius_}, {"n", std::ssize(samples_)}},
                .row = {std::ssize(samples_), t.place, "", words_.shared("words", t.kept ? "yes" : "no")},
                .key = figure_number(tries_),
                .phase = phase()};
    if (!alone) {
      event.facts.push_back({"nearest", t.nearest});
      event.words.push_back({"nearest", t.nearest});
      event.row[2] = t.nearest;
    }
    if (tries_ > 1 && t.inside)
      event.decides = yes_or_no(words_, "question", {{"radius", radius_}}, t.kept, "kept", "refused");
    return event;
  }

  void show(Board& board, const Retired& r) {
    std::erase(active_, r.sample);
    tried_.reset();
    retired_ = r.sample;
    note_gaps();
    put(board, true);
    retired_.reset();
    refused_ = 0;
  }
  Event say(const Retired& r) const {
    return {.text = "retired",
            .facts = {{"x", r.sample.x}, {"y", r.sample.y}, {"active", std::ssize(active_)}},
            .words = {{"place", r.sample}},
            .count = refused_before_,
            .phase = phase()};
  }

  void show(Board& board, const Finished&) {
    tried_.reset();
    chosen_.reset();
    finished_ = true;
    put(board, true);
  }
  Event say(const Finished&) const {
    Event event{.text = "finished.alone",
                .facts = {{"samples", std::ssize(samples_)}, {"tries", tries_}},
                .words = {{"radius", radius_}, {"n", std::ssize(samples_)}}};
    if (samples_.size() > 1) {
      event.text = "finished";
      event.words.push_back({"least", least_distance(area_, samples_)});
    }
    return event;
  }

 private:
  /// At first there is room beside most samples, or for most darts; then gaps are filled.
  std::string phase() const { return words_.say(gaps_ ? "phase.gaps" : "phase.growing"); }
  std::string_view key_of(const Tried& t) const {
    if (!t.inside) return "outside";
    if (!t.kept) return "refused";
    if (tries_ == 1) return "first";
    return t.nearest == std::numeric_limits<double>::infinity() ? "kept.alone" : "kept";
  }

  void note_gaps() {
    gaps_ |= beside_ ? 2 * active_.size() < samples_.size() : tries_ > 2 * std::ssize(samples_);
  }
  /// A place that is refused for a neighbour, once there is something to see: of them one near the
  /// middle, as its ring is, where all of it is seen.
  void note_telling(const Tried& t) {
    details_ = t.kept ? 0 : details_ + 1;
    milestones_ += t.kept;
    if (t.kept || !t.inside || samples_.size() < 6) return;
    const dvec2 middle = 0.5 * area_.size;
    const double off = chosen_ ? glm::distance(*chosen_, middle) + glm::distance(t.place, middle) : 0;
    if (off >= least_off_) return;
    least_off_ = off;
    telling_ = {milestones_, static_cast<int>(details_)};
  }

  void put(Board& board, bool milestone) {
    if (retired_) ++milestones_, details_ = 0, refused_before_ = refused_;
    View view;
    sheet_.add_frame(view);
    sheet_.add_radius(view, words_, radius_);
    if (!finished_)
      sheet_.add_grid(view, grid_, tried_ && tried_->inside ? std::optional(tried_->place) : std::nullopt);
    sheet_.add_copies(view, samples_);
    if (chosen_ && beside_) add_ring(view, retired_ ? *retired_ : *chosen_);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const dvec2 p = samples_[i];
      const bool active = std::ranges::find(active_, p) != active_.end() && beside_;
      const std::string id = fmt::format("d sample {:03}", i);
      view.add({id, finished_ ? Role::result : active ? Role::input : Role::past, Dot{sheet_.at(p)}});
      if (!finished_) continue;
      view.add({"c disc" + id, Role::result, Path{sheet_.shown_circle(p, radius_ / 2), true}});
    }
    if (tried_) add_try(view, *tried_);
    if (milestone) {
      board.milestone(std::move(view));
    } else {
      board.detail(std::move(view));
    }
  }
  /// Between one and two radii from a sample.
  void add_ring(View& view, dvec2 middle) const {
    const auto inner = sheet_.shown_circle(middle, radius_), outer = sheet_.shown_circle(middle, 2 * radius_);
    const Role role = retired_ ? Role::rejected : Role::candidate;
    view.add({"a ring", role, gradus::Area{{inner, outer}, 1}});
    view.add({"c ring inner", role, Path{inner, true}});
    view.add({"c ring outer", role, Path{outer, true}});
    view.add({"e chosen", retired_ ? Role::rejected : Role::input, Dot{sheet_.at(middle)}});
  }
  void add_try(View& view, const Tried& t) const {
    const Role role = t.kept ? Role::accepted : Role::rejected;
    if (!t.inside) {
      view.add({"e way", role, sheet_.shown_way(*chosen_, t.place)});
      return;
    }
    view.add({"f tried", role, Dot{sheet_.at(t.place), !t.kept}});
    if (!beside_) view.add({"c near", role, Path{sheet_.shown_circle(t.place, radius_), true}});
    if (t.nearest == std::numeric_limits<double>::infinity()) return;
    const dvec2 neighbour = t.place + way_between(area_, t.place, t.neighbour);
    view.add({"e distance", Role::measure, Stroke{sheet_.at(t.place), sheet_.at(neighbour)}});
    view.add(
        {"g distance", Role::measure,
         Label{sheet_.at((t.place + neighbour) / 2.0),
               fmt::format("{} {} {}", figure_real(t.nearest), t.kept ? "≥" : "<", figure_real(radius_))}});
  }

  const Words& words_;
  Area area_;
  double radius_;
  bool beside_;
  Grid grid_;
  Sheet sheet_;
  std::vector<dvec2> samples_, active_;
  std::optional<dvec2> chosen_, retired_;
  std::optional<Tried> tried_;
  std::int64_t tries_ = 0, refused_ = 0, refused_before_ = 0, milestones_ = 0, details_ = 0;
  StepNumber telling_{0, 0};
  double least_off_ = std::numeric_limits<double>::infinity();
  bool gaps_ = false, finished_ = false;
};

/// Of several candidates the farthest.
class CandidateStory {
 public:
  /// half: how many samples there are when the figure that tells most is drawn.
  CandidateStory(const Words& words, int half) : words_(words), sheet_({dvec2(1), true}, 0.05), half_(half) {}

  /// The best of all candidates in the middle of the run.
  StepNumber telling() const { return telling_; }

  void show(Board& board, const Started&) { put(board, true); }
  Event say(const Started&) const { return {.text = "candidates.started"}; }

  void show(Board& board, const Compared& c) {
    compared_.push_back(c);
    if (c.best && std::ssize(samples_) == half_) telling_ = {half_, static_cast<int>(compared_.size())};
    put(board, false);
  }
  Event say(const Compared& c) const {
    const bool first = samples_.empty();
    Event event{.text = first    ? "candidates.first"
                        : c.best ? "candidates.best"
                                 : "candidates.nearer",
                .facts = {{"x", c.place.x}, {"y", c.place.y}, {"best", c.best}},
                .words = {{"place", c.place}},
                .key = figure_number(std::ssize(compared_)),
                .phase = phase(std::ssize(samples_))};
    if (first) return event;
    event.facts.push_back({"nearest", c.nearest});
    event.words.push_back({"nearest", c.nearest});
    event.decides = yes_or_no(words_, "candidates.question", {{"place", c.place}}, c.best, "best", "nearer");
    return event;
  }

  void show(Board& board, const Taken& t) {
    samples_.push_back(t.sample);
    if (samples_.size() > 1) least_ = std::min(least_, t.nearest);
    put(board, true);
    compared_.clear();
  }
  Event say(const Taken& t) const {
    const bool first = samples_.size() == 1;
    Event event{.text = first ? "candidates.one" : "candidates.taken",
                .facts = {{"x", t.sample.x}, {"y", t.sample.y}, {"candidates", t.candidates}},
                .words = {{"place", t.sample}, {"number", std::ssize(samples_)}},
                .count = t.candidates,
                .row = {std::ssize(samples_), t.sample, "", t.candidates},
                .key = figure_number(std::ssize(samples_)),
                .phase = phase(std::ssize(samples_) - 1)};
    if (first) return event;
    event.facts.push_back({"nearest", t.nearest});
    event.words.push_back({"nearest", t.nearest});
    event.row[2] = t.nearest;
    return event;
  }

  void show(Board& board, const Finished&) {
    finished_ = true;
    put(board, true);
  }
  Event say(const Finished& f) const {
    Event event{.text = "candidates.alone", .facts = {{"samples", f.samples}}, .words = {{"n", f.samples}}};
    if (f.samples > 1) {
      event.text = "candidates.finished";
      event.words.push_back({"least", least_});
    }
    return event;
  }

 private:
  std::string phase(std::int64_t before) const {
    return words_.say(before < half_ ? "phase.growing" : "phase.gaps");
  }
  void put(Board& board, bool milestone) {
    View view;
    sheet_.add_frame(view);
    view.add({"h caption", Role::guide, Text{{0.5 * width, 0.4}, words_.say("candidates.tile")}});
    sheet_.add_copies(view, samples_);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      view.add({fmt::format("d sample {:03}", i), finished_ ? Role::result : Role::past,
                Dot{sheet_.at(samples_[i])}});
      if (finished_ && samples_.size() > 1)
        view.add({fmt::format("c disc {:03}", i), Role::result,
                  Path{sheet_.shown_circle(samples_[i], least_ / 2), true}});
    }
    std::size_t best = 0;
    for (std::size_t i = 0; i < compared_.size(); ++i) {
      if (compared_[i].best) best = i;
    }
    for (std::size_t i = 0; i < compared_.size(); ++i) {
      const Compared& c = compared_[i];
      const Role role = i == best ? Role::accepted : Role::candidate;
      view.add({fmt::format("f candidate {:03}", i), role, Dot{sheet_.at(c.place), i != best}});
      if (c.nearest == std::numeric_limits<double>::infinity()) continue;
      const dvec2 neighbour = c.place + way_between({dvec2(1), true}, c.place, c.neighbour);
      view.add({fmt::format("e way {:03}", i), i == best ? Role::measure : Role::candidate,
                Stroke{sheet_.at(c.place), sheet_.at(neighbour), false, i != best, i != best}});
      if (i == best)
        view.add({"g distance", Role::measure,
                  Label{sheet_.at((c.place + neighbour) / 2.0), figure_real(c.nearest)}});
    }
    if (milestone) {
      board.milestone(std::move(view));
    } else {
      board.detail(std::move(view));
    }
  }

  const Words& words_;
  Sheet sheet_;
  const int half_;
  StepNumber telling_{};
  std::vector<dvec2> samples_;
  std::vector<Compared> compared_;
  double least_ = std::numeric_limits<double>::infinity();
  bool finished_ = false;
};

Random numbers_of(const Arguments& given) {
  return Random(static_cast<std::uint64_t>(given.integer("seed")));
}

/// The area and the radius, which must leave room for no more than some hundred samples.
std::pair<Area, double> subject_of(const Arguments& given) {
  const std::vector<double> size = given.numbers("area");
  const Area area{{size[0], size[1]}, given.flag("tile")};
  const double radius = *given.number("radius");
  if (!(area.size.x > 0 && area.size.y > 0)) refuse("area", "expected a width and a height above 0");
  const double shorter = std::min(area.size.x, area.size.y), longer = std::max(area.size.x, area.size.y);
  if (longer > 20 * shorter) refuse("area", "expected a side at most 20 times as long as the other");
  if (!(radius > 0)) refuse("radius", "expected a radius above 0");
  if (area.size.x / radius * (area.size.y / radius) > 400)
    refuse(given, {"radius", "area"},
           fmt::format(
               "expected room for no more than some 300 samples, in this area a radius of at least {:.3g}",
               1.006 * std::sqrt(area.size.x * area.size.y / 400)));  // the third digit may be cut
  if (radius > 2 * longer)
    refuse(given, {"radius", "area"},
           fmt::format("expected a radius of at most twice the area’s longer side, {}", 2 * longer));
  if (area.wraps && 2 * radius > shorter)
    refuse(given, {"radius", "area", "tile"},
           fmt::format("expected a tile of at least two radii per side, so a radius of at most {}",
                       shorter / 2));
  return {area, radius};
}

template <class Run>
void tell_discs(Narrator& narrator, bool beside, Run run) {
  const Arguments& given = narrator.arguments();
  const auto [area, radius] = subject_of(given);
  narrator.paper(width, height);
  narrator.subtitle(
      area.wraps ? "subtitle.tile" : "subtitle",
      {{"width", area.size.x}, {"height", area.size.y}, {"radius", radius}, {"seed", given.integer("seed")}});
  narrator.columns({{"samples"}, {"place", false}, {"nearest"}, {"kept", false}});
  if (beside)
    narrator.legend({{Role::input, "active"},
                     {Role::past, "retired"},
                     {Role::candidate, "ring"},
                     {Role::current, "asked"},
                     {Role::accepted, "kept"},
                     {Role::rejected, "refused"},
                     {Role::result, "disc"}});
  else
    narrator.legend({{Role::past, "sample"},
                     {Role::current, "asked"},
                     {Role::accepted, "kept"},
                     {Role::rejected, "refused"},
                     {Role::result, "disc"}});
  DiscStory story(narrator.words(), area, radius, beside);
  narrator.handles("area", [&](dvec2 size) { return story.panel().at(size); });
  require_scale(story.panel(), given, {"area"});
  run(area, radius, narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result({{"samples", std::ssize(story.samples())}});
}

void tell_bridson(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const int tries = static_cast<int>(given.integer("tries"));
  tell_discs(narrator, true, [&](const Area& area, double radius, const auto& watch) {
    bridson(area, radius, tries, numbers_of(given), drop, watch);
  });
}
void tell_darts(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const int misses = static_cast<int>(given.integer("tries"));
  tell_discs(narrator, false, [&](const Area& area, double radius, const auto& watch) {
    dart_throwing(area, radius, misses, numbers_of(given), drop, watch);
  });
}
void tell_candidates(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  std::vector<dvec2> samples(static_cast<std::size_t>(given.integer("samples")));
  const int candidates = static_cast<int>(given.integer("candidates"));
  const int half = static_cast<int>(samples.size()) / 2;
  narrator.paper(width, height);
  narrator.trace().subtitle =
      narrator.words().count("candidates.subtitle", std::ssize(samples),
                             {{"candidates", candidates}, {"seed", given.integer("seed")}});
  narrator.columns({{"samples"}, {"place", false}, {"nearest"}, {"candidates"}});
  narrator.legend({{Role::past, "sample"},
                   {Role::candidate, "candidate"},
                   {Role::accepted, "farthest"},
                   {Role::result, "disc"}});
  CandidateStory story(narrator.words(), half);
  best_candidate(samples, candidates, numbers_of(given), narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result({{"samples", std::ssize(samples)}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const auto whole = [](std::string name, std::string value, std::string example, std::string help, int least,
                        int most) {
    return Parameter{.name = std::move(name),
                     .type = ParameterType::integer,
                     .default_value = std::move(value),
                     .example = std::move(example),
                     .help = std::move(help),
                     .least = least,
                     .most = most};
  };
  const std::vector<std::string> of_area{"radius", "area", "tile", "tries"},
      of_pattern{"samples", "candidates"};
  static const TopicEntry topic = completed<entry>(
      {.name = "poisson_disc",
       .chapter = "antialiasing",
       .aliases = {"poisson disk", "blue noise", "bridson", "dart throwing", "best candidate", "mitchell",
                   "stochastic sampling"},
       .summary = "random samples of which no two are nearer than a radius",
       .methods =
           {{.name = "bridson", .standing = Standing::taught, .tell = tell_bridson, .unread = of_pattern},
            {.name = "dart_throwing", .tell = tell_darts, .unread = of_pattern},
            {.name = "best_candidate", .tell = tell_candidates, .unread = of_area},
            {.name = "pictures",
             .tell = tell_pictures,
             .function = "bridson",
             .unread = {"area", "tile", "tries", "samples", "candidates"}}},
       .default_method = "bridson",
       .columns = {{"samples"}, {"place", false}, {"nearest"}, {"kept", false}},
       .counts = {"Tried", "Compared"},
       .parameters = {number("radius", "0.2", "0.15", "the distance of any two samples", {1e-9, 1e9}),
                      numbers("area", "1.2,0.8", "1,1", "width and height of the area", {"width", "height"},
                              {1e-9, 1e9}),
                      {"tile", ParameterType::flag, "", "",
                       "the area is a tile: distances go on at the opposite side"},
                      whole("tries", "8", "30",
                            "places that are tried beside a sample, or darts in a row that must miss", 1,
                            100),
                      whole("samples", "12", "16", "how many samples the pattern has", 1, 64),
                      whole("candidates", "2", "4",
                            "candidates for each sample, times the number of those before", 1, 8),
                      whole("seed", "5", "7", "of the random numbers", 0, INT32_MAX)},
       .examples = {"--radius 0.15 --seed 7", "--tile", "--method dart_throwing --tries 20",
                    "--method best_candidate --samples 16", "--method pictures"}});
  return topic;
}

}  // namespace gradus::poisson_disc
