// The story of adaptive antialiasing: which pixels take all samples, whose each sample is, and how a pixel is
// mixed of its fragments.

#include "antialiasing/adaptive/adaptive.hpp"

#include "stories/antialiasing/adaptive/drawing.hpp"
#include "stories/antialiasing/adaptive/pictures.hpp"
#include "stories/antialiasing/adaptive/subject.hpp"

namespace gradus::adaptive {
namespace {

double square_pixels(std::int64_t value) {
  return static_cast<double>(value) / (double{subpixels} * subpixels);
}

/// The whole picture is to be mixed: adaptive, or with all samples everywhere.
class Story {
 public:
  Story(const Words& words, const Subject& subject, const Paper& paper, bool everywhere)
      : words_(words), subject_(subject), paper_(paper), everywhere_(everywhere) {}

  std::optional<StepNumber> telling() const { return telling_; }

  void show(Board& board, const steps::Started&) {
    paper_.put_frames(base_, words_.say("picture.tinted", {{"samples", subject_.count}}));
    if (everywhere_) {
      open_large();
      for (const ivec2 p : pixels(subject_.picture())) paper_.put_tint(base_, p);
    }
    next(board, base_);
  }
  Event say(const steps::Started&) const {
    return {.text = everywhere_ ? "started.each" : "started",
            .words = {{"samples", subject_.count}, {"pixels", subject_.size.x * subject_.size.y}},
            .count = std::ssize(subject_.triangles)};
  }

  void show(Board& board, const Classified& c) {
    if (c.cover != Cover::crossed) return;
    paper_.put_tint(base_, c.pixel);
    View view = base_;
    paper_.put_large(view, words_, c.pixel);
    paper_.mark_range(view, crossing(c), range_over(crossing(c), c.pixel));
    paper_.mark_pixel(view, c.pixel, Role::current);
    next(board, std::move(view));
  }
  Event say(const Classified& c) const {
    const Range range = range_over(crossing(c), c.pixel);
    return {.text = "crossed",
            .facts = {{"pixel", c.pixel}, {"triangle", c.triangle}, {"crossed", true}},
            .words = {{"face", subject_.name(c.triangle)},
                      {"least", square_pixels(range.least)},
                      {"most", square_pixels(range.most)},
                      {"samples", subject_.count}},
            .row = {subject_.name(c.triangle), c.pixel.x, c.pixel.y, "–", "–", words_.say("case.crossed")},
            .key = pixel_key(c.pixel),
            .phase = words_.say("phase.decide"),
            .decides = yes_or_no(words_, "question.crossed",
                                 {{"face", subject_.name(c.triangle)}, {"pixel", c.pixel}}, true, "crossed",
                                 "one look")};
  }

  void show(Board& board, const Compared& c) {
    if (c.order == Order::changing)
      paper_.put_tint(base_, c.pixel);
    else
      paper_.put_number(base_, c.pixel, 1);
    if (c.order == Order::nearer) paper_.put_pixel(base_, c.pixel, subject_.color(c.triangle));
    View view = base_;
    paper_.put_large(view, words_, c.pixel);
    paper_.mark_pixel(view, c.pixel, c.order == Order::behind ? Role::rejected : Role::current);
    next(board, std::move(view));
  }
  Event say(const Compared& c) const {
    constexpr std::array<std::string_view, 3> cases{"case.nearer", "case.behind", "case.pierced"};
    const bool first = c.before == nobody;
    return {.text = first                        ? "whole.first"
                    : c.order == Order::nearer   ? "whole.nearer"
                    : c.order == Order::changing ? "whole.pierced"
                                                 : "whole.behind",
            .facts = {{"pixel", c.pixel}, {"triangle", c.triangle}, {"crossed", c.order == Order::changing}},
            .words = {{"face", subject_.name(c.triangle)},
                      {"other", first ? "" : subject_.name(c.before)},
                      {"samples", subject_.count}},
            .row = {subject_.name(c.triangle), c.pixel.x, c.pixel.y, "–", "–",
                    words_.say(first ? "case.whole" : cases[static_cast<std::size_t>(c.order)])},
            .key = pixel_key(c.pixel),
            .phase = words_.say("phase.decide"),
            .decides =
                first ? yes_or_no(words_, "question.crossed",
                                  {{"face", subject_.name(c.triangle)}, {"pixel", c.pixel}}, false, "crossed",
                                  "one look")
                      : yes_or_no(words_, "question.pierced",
                                  {{"face", subject_.name(c.triangle)}, {"other", subject_.name(c.before)}},
                                  c.order == Order::changing, "pierced", "one is in front")};
  }

  void show(Board& board, const Sampled& s) {
    old_ = depths_[key(s)];
    if (s.nearer) depths_[key(s)] = s.depth;
    if (s.pixel != subject_.pixel) return;
    const bool first = !opened_;
    if (first) open_large();
    const auto sample = static_cast<std::size_t>(s.sample);
    if (s.nearer) paper_.put_sample(base_, sample, subject_.color(s.triangle));
    View view = base_;
    paper_.mark_sample(view, sample, s.nearer ? Role::current : Role::rejected);
    next(board, std::move(view));
    const int worth = s.before != nobody && s.covered ? (s.nearer ? 3 : 2) : s.covered ? 1 : 0;
    want(worth);
  }
  Event say(const Sampled& s) const {
    const bool taken = s.before != nobody;
    return {.text = !s.covered ? "sample.outside"
                    : !taken   ? "sample.free"
                    : s.nearer ? "sample.nearer"
                               : "sample.behind",
            .facts = {{"pixel", s.pixel},
                      {"triangle", s.triangle},
                      {"sample", s.sample + 1},
                      {"covered", s.covered},
                      {"nearer", s.nearer}},
            .words = {{"face", subject_.name(s.triangle)},
                      {"z", s.depth},
                      {"old", old_},
                      {"other", taken ? subject_.name(s.before) : ""}},
            .row = {subject_.name(s.triangle), s.pixel.x, s.pixel.y, s.sample + 1,
                    s.covered ? figure_real(s.depth) : "–",
                    words_.say(!s.covered ? "case.outside"
                               : s.nearer ? "case.takes"
                                          : "case.hidden")},
            .key = fmt::format("{} {}", pixel_key(s.pixel), s.sample + 1),
            .phase = words_.say("phase.samples"),
            .decides = s.covered ? yes_or_no(words_, "question.nearer",
                                             {{"z", s.depth}, {"old", taken ? figure_real(old_) : "∞"}},
                                             s.nearer, "nearer", "hidden")
                                 : yes_or_no(words_, "question.covered",
                                             {{"face", subject_.name(s.triangle)}, {"sample", s.sample + 1}},
                                             false, "covered", "outside")};
  }

  void show(Board& board, const Coloured& c) {
    auto& [sum, share] = light_[place(c.pixel)];
    const Edges edges = triangle_coverage::edges_of(subject_.triangle(c.triangle).corners);
    sum += c.share * subject_.colour(c.triangle, weights_at_place(edges, place_in(c.pixel, c.place)));
    share += c.share;
    paper_.clear_number(base_, c.pixel);
    paper_.put_pixel(base_, c.pixel, on_white(sum, share));
    if (c.pixel != subject_.pixel) return;
    if (!opened_) open_large();
    View view = base_;
    paper_.mark_place(view, c.place);
    next(board, std::move(view));
  }
  Event say(const Coloured& c) const {
    const bool centre = c.place == ivec2(subpixels / 2);
    return {
        .text = c.samples == subject_.count ? "coloured.whole"
                : centre                    ? "coloured.centre"
                                            : "coloured.aside",
        .facts = {{"pixel", c.pixel}, {"triangle", c.triangle}, {"samples", c.samples}, {"share", c.share}},
        .words = {{"face", subject_.name(c.triangle)}, {"shown", c.samples}, {"samples", subject_.count}},
        .row = {subject_.name(c.triangle), c.pixel.x, c.pixel.y,
                fmt::format("{}/{}", c.samples, subject_.count), "–", figure_real(c.share)},
        .key = fmt::format("{} {}", pixel_key(c.pixel), subject_.name(c.triangle)),
        .phase = words_.say("phase.mix")};
  }

  void show(Board& board, const Finished&) { next(board, base_); }
  Event say(const Finished& f) const {
    return {.text = everywhere_ ? "finished.each" : "finished",
            .facts = {{"crossed", f.crossed}, {"samples", f.samples}, {"colours", f.colours}},
            .words = {{"pixels", f.pixels}, {"samples", subject_.count}, {"tests", f.samples}}};
  }

 private:
  static std::pair<int, int> place(ivec2 p) { return {p.y, p.x}; }
  static std::array<int, 3> key(const Sampled& s) { return {s.pixel.x, s.pixel.y, s.sample}; }
  void next(Board& board, View view) {
    board.milestone(std::move(view));
    ++milestones_;
  }
  void want(int worth) {
    if (worth < worth_) return;
    worth_ = worth;
    telling_ = {milestones_, 0};
  }
  void open_large() {
    opened_ = true;
    paper_.put_large(base_, words_, subject_.pixel);
    paper_.put_seen(base_, subject_.pixel);
    paper_.put_samples(base_);
  }
  /// The edge that crosses.
  Edge crossing(const Classified& c) const {
    const Edges edges = triangle_coverage::edges_of(subject_.triangle(c.triangle).corners);
    return *std::ranges::find_if(edges, [&](const Edge& edge) {
      return !triangle_coverage::belongs(edge, range_over(edge, c.pixel).least);
    });
  }

  const Words& words_;
  const Subject& subject_;
  const Paper& paper_;
  const bool everywhere_;
  View base_{};
  bool opened_ = false;
  double old_ = 0;
  std::map<std::array<int, 3>, double> depths_{};
  std::map<std::pair<int, int>, Light<dvec3>> light_{};
  std::int64_t milestones_ = -1;
  int worth_ = 0;
  std::optional<StepNumber> telling_{};
};

/// Which pixels take a colour per sample.
class ContrastStory {
 public:
  ContrastStory(const Words& words, const Subject& subject, const Paper& paper)
      : words_(words), subject_(subject), paper_(paper) {}

  std::optional<StepNumber> telling() const { return telling_; }
  /// The picture of adaptive.
  void plot(ivec2 p, const dvec3& sum, double share) { paper_.put_pixel(base_, p, on_white(sum, share)); }

  void show(Board& board, const steps::Started&) {
    paper_.put_frames(base_, words_.say("picture"));
    next(board, base_);
  }
  Event say(const steps::Started&) const {
    return {.text = "started.contrast", .words = {{"threshold", subject_.threshold}}};
  }
  void show(Board& board, const Contrasted& c) {
    if (c.refined) {
      refined_ += 1;
      paper_.put_number(base_, c.pixel, subject_.count);
    }
    View view = base_;
    paper_.put_large(view, words_, c.pixel);
    const auto shown = shown_at(c.pixel);
    paper_.put_samples(view);
    for (std::size_t s = 0; s < shown.size(); ++s)
      if (shown[s] != white) paper_.put_sample(view, s, shown[s]);
    paper_.mark_pixel(view, c.pixel, c.refined ? Role::current : Role::rejected);
    next(board, std::move(view));
    std::vector<Rgba8> different;
    for (const Rgba8 color : shown)
      if (std::ranges::find(different, color) == different.end()) different.push_back(color);
    const bool within = std::ranges::find(shown, white) == shown.end();
    const std::size_t worth = 2 * different.size() + within;
    if (c.refined && worth >= most_different_) {
      most_different_ = worth;
      telling_ = {milestones_, 0};
    }
  }
  Event say(const Contrasted& c) const {
    return {.text = c.refined ? "contrast.refined" : "contrast.enough",
            .facts = {{"pixel", c.pixel}, {"contrast", c.contrast}, {"refined", c.refined}},
            .words = {{"threshold", subject_.threshold}, {"samples", subject_.count}},
            .row = {c.pixel.x, c.pixel.y, c.contrast, words_.shared("words", c.refined ? "yes" : "no")},
            .key = pixel_key(c.pixel),
            .phase = words_.say("phase.contrast"),
            .decides = yes_or_no(words_, "question.contrast",
                                 {{"contrast", c.contrast}, {"threshold", subject_.threshold}}, c.refined,
                                 "refined", "enough")};
  }
  void show(Board& board, const Finished&) { next(board, base_); }
  Event say(const Finished& f) const {
    return {.text = "finished.contrast",
            .facts = {{"refined", refined_}, {"colours", f.colours}},
            .words = {{"pixels", f.pixels}, {"samples", subject_.count}}};
  }

 private:
  void next(Board& board, View view) {
    board.milestone(std::move(view));
    ++milestones_;
  }
  static constexpr Rgba8 white{255, 255, 255, 255};

  /// What each sample of a pixel would have for its colour.
  std::vector<Rgba8> shown_at(ivec2 pixel) const {
    std::vector<Rgba8> all;
    for (const ivec2 place : subject_.places) {
      Rgba8 color = on_white({}, 0);
      const auto plot = [&](ivec2, const dvec3& sum, double share) { color = on_white(sum, share); };
      const auto always = [](const auto&, const auto&) { return 0.0; };
      adaptive_contrast(subject_.triangles, {pixel, pixel}, std::vector{place}, always, -1.0,
                        subject_.colours(), plot);
      all.push_back(color);
    }
    return all;
  }

  const Words& words_;
  const Subject& subject_;
  const Paper& paper_;
  View base_{};
  int refined_ = 0;
  std::int64_t milestones_ = -1;
  std::size_t most_different_ = 0;
  std::optional<StepNumber> telling_{};
};

// --- The methods

void subtitle(Narrator& narrator, const Subject& subject, bool everywhere = false) {
  narrator.trace().subtitle = narrator.words().count(
      everywhere ? "subtitle.each" : "subtitle", std::ssize(subject.triangles),
      {{"columns", subject.size.x}, {"rows", subject.size.y}, {"samples", subject.count}});
}

template <class Run>
void tell_mixing(Narrator& narrator, bool everywhere, const Run& run) {
  const Subject subject = subject_of(narrator.arguments());
  const Paper paper(subject);
  paper.set(narrator);
  subtitle(narrator, subject, everywhere);
  paper.let_drag(narrator);
  if (everywhere) paper.let_drag_pixel(narrator);
  Story story(narrator.words(), subject, paper, everywhere);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  double light = 0;
  const auto plot = [&](ivec2, const dvec3&, double share) { light += share; };
  run(subject, subject.colours(), plot, watch);
  if (story.telling()) narrator.telling(*story.telling());
  narrator.result({{"covered", light}});
}

void tell_adaptive(Narrator& narrator) {
  narrator.columns({{"face", false}, {"x"}, {"y"}, {"sample"}, {"z"}, {"case", false}});
  narrator.legend({{Role::current, "current"},
                   {Role::rejected, "rejected"},
                   {Role::measure, "measure"},
                   {Role::candidate, "equal"}});
  narrator.list("order_of");
  narrator.list_below("mark_crossed");
  narrator.list_below("take_samples");
  narrator.list_below("mix");
  tell_mixing(narrator, false, [](const Subject& s, const auto& colour, const auto& plot, const auto& watch) {
    adaptive(s.triangles, s.picture(), s.places, colour, plot, watch);
  });
}

void tell_each_sample(Narrator& narrator) {
  narrator.columns({{"face", false}, {"x"}, {"y"}, {"sample"}, {"z"}, {"case", false}});
  narrator.legend({{Role::current, "current"},
                   {Role::rejected, "rejected"},
                   {Role::measure, "measure"},
                   {Role::candidate, "equal"}});
  narrator.list("take_samples");
  narrator.list_below("mix");
  tell_mixing(narrator, true, [](const Subject& s, const auto& colour, const auto& plot, const auto& watch) {
    each_sample(s.triangles, s.picture(), s.places, colour, plot, watch);
  });
}

void tell_adaptive_contrast(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Paper paper(subject);
  paper.set(narrator);
  subtitle(narrator, subject);
  paper.let_drag(narrator);
  narrator.columns({{"x"}, {"y"}, {"contrast"}, {"refined", false}});
  narrator.legend({{Role::current, "current"}, {Role::rejected, "alike"}});
  ContrastStory story(narrator.words(), subject, paper);
  const auto keep = [&](ivec2 p, const dvec3& sum, double share) { story.plot(p, sum, share); };
  adaptive(subject.triangles, subject.picture(), subject.places, subject.colours(), keep);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto contrast = [](const auto& a, const auto& b) {
    const Rgba8 p = on_white(a.sum, a.share), q = on_white(b.sum, b.share);
    return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
  };
  std::int64_t pixels = 0;
  const auto plot = [&](ivec2, const dvec3&, double) { ++pixels; };
  const auto decide = only<Contrasted, Finished>(watch);
  adaptive_contrast(subject.triangles, subject.picture(), subject.places, contrast, subject.threshold,
                    subject.colours(), plot, decide);
  if (story.telling()) narrator.telling(*story.telling());
  narrator.result({{"pixels", pixels}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const std::vector<std::string> scene{"faces", "columns", "rows", "samples", "pixel", "surface"};
  static const TopicEntry topic = completed<entry>(
      {.name = "adaptive",
       .chapter = "antialiasing",
       .aliases = {"adaptive antialiasing", "multisampling", "MSAA", "adaptive supersampling"},
       .summary = "all samples where an edge crosses a pixel, one colour per fragment",
       .methods = {{.name = "adaptive",
                    .standing = Standing::taught,
                    .tell = tell_adaptive,
                    .unread = {"threshold", "thickness"}},
                   {.name = "each_sample", .tell = tell_each_sample, .unread = {"threshold", "thickness"}},
                   {.name = "adaptive_contrast",
                    .tell = tell_adaptive_contrast,
                    .unread = {"pixel", "thickness"}},
                   {.name = "pictures",
                    .tell = tell_pictures,
                    .function = "adaptive",
                    .unread = {"pixel", "threshold", "thickness"}},
                   {.name = "thin",
                    .tell = tell_thin,
                    .function = "adaptive",
                    .unread = {"faces", "columns", "rows", "samples", "pixel", "surface", "threshold"}}},
       .parameters = {faces(
                          60, "faces",
                          "A: 0.6,1.2,0.5 7.8,2.6,0.5 2.2,7.6,0.5; B: 4.4,0.5,0.15 7.6,6.9,0.66 2.9,5.2,0.56",
                          "A: 0,0,1 8,0,1 0,8,1; B: 2,1,2 7,3,0 3,7,0.5",
                          "triangles: x right and y down in pixels, z away from the viewer", {1e-6, 1e6}),
                      integer(1, 12, "columns", "8", "6", "how many pixels the picture is wide"),
                      integer(1, 12, "rows", "8", "6", "how many pixels it is high"),
                      choice("samples", {"4", "8", "16"}, "8", "16", "samples per pixel that takes all"),
                      {.name = "pixel",
                       .type = ParameterType::cell,
                       .default_value = "5,4",
                       .example = "3,2",
                       .help = "the pixel that is drawn large: column, row"},
                      choice("surface", {"plain", "chequered"}, "plain", "chequered",
                             "what the first triangle is coloured like"),
                      number("threshold", "16", "40",
                             "method adaptive_contrast: by how many of 255 steps neighbours may differ",
                             {1e-6, 1e6}),
                      number("thickness", "0.3",
                             "0.5", "method thin: how thick the needle is at its end, in pixels", {1e-3, 8})},
       .examples = {"--samples 16 --pixel 3,6", "--method adaptive_contrast --surface chequered",
                    "--method pictures --surface chequered"}});
  return topic;
}

}  // namespace gradus::adaptive
