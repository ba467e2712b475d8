#pragma once
// A sine, its samples, and the slowest sine that has the same ones; and samples at exactly twice its
// frequency.

#include "antialiasing/sampling_theorem/sampling_theorem_notes.hpp"
#include "stories/telling.hpp"

namespace gradus::sampling_theorem {

/// What is sampled, and how.
struct Subject {
  double f, fs, phase;  ///< Hz, samples a second, turns
  std::int64_t count;

  double value(double t) const { return wave(f, t); }
  /// The sine of another frequency with the same start.
  double wave(double frequency, double t) const {
    return sin_cos_half_turns(2 * (std::remainder(frequency * t, 1) + phase)).sin;
  }
  double seconds() const { return static_cast<double>(count) / fs; }
};

/// With `rate`, that one instead of the one given.
inline Subject subject_of(const Arguments& given, std::optional<double> rate = {}) {
  const Subject subject{*given.number("frequency"), rate ? *rate : *given.number("rate"),
                        *given.number("phase") / 360, given.integer("samples")};
  if (!(subject.fs > 0)) refuse(given, {"rate", "frequency"}, "expected a number above 0");
  if (std::abs(subject.f) * subject.seconds() > 60)
    refuse(given, {"frequency", "samples", "rate"}, "expected at most 60 cycles in all samples");
  return subject;
}

/// A curve over a panel's whole width, fine enough for so many cycles.
template <class Curve>
Path path_of(const Panel& panel, double from, double to, double cycles, const Curve& curve) {
  const int steps = std::clamp(static_cast<int>(std::ceil(32 * std::abs(cycles))), 96, 1920);
  Path path;
  for (int i = 0; i <= steps; ++i) {
    const double t = from + (to - from) * i / steps;
    path.points.push_back(panel.at(dvec2{t, curve(t)}));
  }
  return path;
}

/// No rounding errors among the numbers of a figure.
inline double told(double value) { return std::abs(value) < 1e-12 ? 0 : value; }

class SineStory {
 public:
  SineStory(const Words& words, const Subject& subject)
      : words_(words),
        subject_(subject),
        panel_({{2.6, 13}, {39.4, 25}}, {{0, -1}, {subject.seconds(), 1}}, Panel::Fit::stretched) {}

  static constexpr int width = 42, height = 26;

  /// The frequency, and the end of the band for the rate.
  void let_drag(Narrator& narrator) const {
    const NumberLine line = frequencies();
    const dvec2 along = line.at(1) - line.at(0);
    narrator.handle("frequency", 0, line.at(subject_.f), along);
    narrator.handle("rate", 0, line.at(0.5 * subject_.fs), 0.5 * along);
  }

  void show(Board& board, const steps::Started&) { board.milestone(drawing()); }
  Event say(const steps::Started&) const {
    return {.text = "sine.started",
            .words = {{"f", subject_.f}, {"fs", subject_.fs}, {"count", subject_.count}}};
  }

  void show(Board& board, const Sampled<double>& s) {
    taken_.push_back(s);
    board.milestone(drawing());
  }
  Event say(const Sampled<double>& s) const {
    const double value = told(s.value);
    return {.text = "sine.sampled",
            .facts = {{"k", s.k}, {"t", s.time}, {"value", value}},
            .words = {{"fs", subject_.fs}},
            .row = {s.k, s.time, value},
            .key = figure_number(s.k),
            .phase = words_.say("phase.samples")};
  }

  void show(Board& board, const Folded<double>& f) {
    folded_ = f;
    board.milestone(drawing());
  }
  Event say(const Folded<double>& f) const {
    const bool enough = is_enough(f.f, f.fs);
    Event event{.text = enough  ? "sine.enough"
                        : f.tie ? "sine.tie"
                                : "sine.folded",
                .facts = {{"alias", f.alias}, {"tie", f.tie}},
                .words = {{"f", f.f},
                          {"twice", 2 * std::abs(f.f)},
                          {"fs", f.fs},
                          {"rates", rates()},
                          {"half", 0.5 * f.fs},
                          {"left", told(std::abs(subject_.value(0)))}},
                .phase = words_.say("phase.alias")};
    event.decides = yes_or_no(words_, "question.enough", {{"fs", f.fs}, {"twice", 2 * std::abs(f.f)}}, enough,
                              "the sine itself", "an alias");
    return event;
  }

  void show(Board& board, const steps::Finished&) {
    ended_ = true;
    board.milestone(drawing());
  }
  Event say(const steps::Finished&) const {
    const bool same = folded_->alias == folded_->f;
    return {.text = same ? "sine.finished" : "sine.finished_alias",
            .facts = {{"most", most()}},
            .words = {{"f", subject_.f}, {"alias", folded_->alias}, {"count", subject_.count}}};
  }

 private:
  std::int64_t rates() const {
    return static_cast<std::int64_t>(std::round((folded_->f - folded_->alias) / subject_.fs));
  }
  /// How far the two sines lie apart between the samples.
  double most() const {
    double most = 0;
    for (int i = 0; i <= 64 * subject_.count; ++i) {
      const double t = i / 64.0 / subject_.fs;
      most = std::max(most, std::abs(subject_.value(t) - subject_.wave(folded_->alias, t)));
    }
    return std::round(told(most) * 1e4) / 1e4;
  }
  View drawing() const {
    View view;
    add_axes(view, panel_, "a", {words_.symbol("t"), ""}, 6);
    view.add({"b zero", Role::guide,
              Stroke{panel_.at({0, 0}), panel_.at({subject_.seconds(), 0}), false, false, true}});
    view.add({"c sine", Role::input,
              path_of(panel_, 0, subject_.seconds(), subject_.f * subject_.seconds(),
                      [&](double t) { return subject_.value(t); })});
    if (folded_) {
      Path back = path_of(panel_, 0, subject_.seconds(), folded_->alias * subject_.seconds(),
                          [&](double t) { return subject_.wave(folded_->alias, t); });
      back.dashed = folded_->alias == folded_->f;  // over the sine itself
      view.add({"d back", Role::result, back});
    }
    for (const Sampled<double>& s : taken_) {
      const bool now = !folded_ && s.k + 1 == std::ssize(taken_);
      const Role role = now ? Role::current : Role::accepted;
      const std::string id = fmt::format("{:02}", s.k);
      view.add({"e stem " + id, role,
                Stroke{panel_.at({s.time, 0}), panel_.at({s.time, s.value}), false, !now, true}});
      view.add({"f sample " + id, role, Dot{panel_.at({s.time, s.value})}});
    }
    add_spectrum(view);
    return view;
  }
  /// As far as the frequency and a copy on each side of the band.
  double far() const { return std::max(1.3 * std::abs(subject_.f), 1.1 * subject_.fs); }
  NumberLine frequencies() const { return {{2.6, 2.4}, {39.4, 2.4}, -far(), far()}; }
  /// The spectrum: a sine has a line at f and one at -f, and samples repeat both at every whole rate. What
  /// lies in the band between minus and plus half the rate comes back.
  void add_spectrum(View& view) const {
    const double half = 0.5 * subject_.fs;
    const NumberLine line = frequencies();
    line.add_to(view, "g", words_.symbol("f"), 10);
    const dvec2 up{0, line_height};
    view.add({"h band", Role::guide,
              Area{{{line.at(-half), line.at(half), line.at(half) + up, line.at(-half) + up}}, 2}});
    const auto put = [&](const std::string& id, Role role, double f) {
      view.add({id, role, Stroke{line.at(f), line.at(f) + up, true, false, role == Role::candidate}});
    };
    for (const double f : {subject_.f, -subject_.f}) {
      const auto last = static_cast<int>(std::floor((far() - f) / subject_.fs));
      for (auto m = static_cast<int>(std::ceil((-far() - f) / subject_.fs)); m <= last; ++m)
        put(fmt::format("{} line {} {}", m == 0 ? "j" : "i", f < 0, m),
            m == 0 ? Role::input : Role::candidate, f + m * subject_.fs);
    }
    if (!folded_) return;
    put("k back", Role::result, folded_->alias);
    put("k back mirrored", Role::result, -folded_->alias);
    if (folded_->alias != folded_->f) add_way(view, line);
  }
  /// From the frequency into the band.
  void add_way(View& view, const NumberLine& line) const {
    const dvec2 above{0, line_height + 1};
    const dvec2 from = line.at(subject_.f) + above, to = line.at(folded_->alias) + above;
    view.add({"l way", Role::measure, Stroke{from, to, true}});
    view.add({"l way name", Role::measure,
              Text{0.5 * (from + to) + dvec2{0, 1},
                   words_.say(rates() > 0 ? "way" : "way_up",
                              {{"rates", std::abs(rates())}, {"fs", subject_.fs}})}});
    // The two frequencies beyond the arrow's ends
    const double side = subject_.f < 0 ? -0.7 : 0.7;
    const auto name = [&](const std::string& id, Role role, dvec2 at, double f, double way) {
      view.add(
          {id, role,
           Text{at + dvec2{way, 0}, words_.say("hertz", {{"f", f}}), way > 0 ? Align::left : Align::right}});
    };
    name("m frequency", Role::input, from, subject_.f, side);
    name("m alias", Role::result, to, folded_->alias, -side);
  }

  static constexpr double line_height = 5;

  const Words& words_;
  const Subject subject_;
  const Panel panel_;
  std::vector<Sampled<double>> taken_{};
  std::optional<Folded<double>> folded_{};
  bool ended_ = false;
};

inline void tell_sine(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.paper(SineStory::width, SineStory::height);
  narrator.subtitle("subtitle.sine", {{"f", subject.f}, {"fs", subject.fs}, {"phase", subject.phase * 360}});
  narrator.list("sample");
  narrator.list_below("alias_of");
  narrator.columns({{"k"}, {"t"}, {"value"}});
  narrator.legend({{Role::input, "sine"},
                   {Role::current, "sample"},
                   {Role::accepted, "samples"},
                   {Role::candidate, "copies"},
                   {Role::guide, "band"},
                   {Role::result, "back"}});
  for (const std::size_t on_a_stem : {std::size_t{1}, std::size_t{2}})
    narrator.trace().legend[on_a_stem].sample = Sample::dot;
  narrator.trace().legend[4].sample = Sample::area;
  SineStory story(narrator.words(), subject);
  story.let_drag(narrator);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::vector<double> samples(static_cast<std::size_t>(subject.count));
  sample([&](double t) { return subject.value(t); }, subject.fs, std::span(samples), watch);
  const double alias = alias_of(subject.f, subject.fs, watch);
  watch(steps::Finished{}, 0);
  narrator.telling({subject.count + 1, 0});
  narrator.result({{"alias", alias}, {"enough", is_enough(subject.f, subject.fs)}});
}

// --- At exactly twice the frequency -----------------------------------------------------------------------

/// What the samples give back is drawn.
struct CameBack {
  double size;
};

class TwiceStory {
 public:
  TwiceStory(const Words& words, const Subject& subject)
      : words_(words),
        subject_(subject),
        panel_({{2.6, 3.4}, {39.4, 24.4}}, {{0, -1}, {subject.seconds(), 1}}, Panel::Fit::stretched) {}

  static constexpr int width = 42, height = 26;

  void show(Board& board, const RateJudged<double>&) {
    judged_ = true;
    board.milestone(drawing());
  }
  Event say(const RateJudged<double>& j) const {
    return {.text = "twice.judged",
            .facts = {{"accepted", j.enough}, {"right", is_enough(j.f, j.fs)}},
            .words = {{"f", subject_.f}, {"fs", subject_.fs}},
            .phase = words_.say("phase.rule"),
            .decides = yes_or_no(words_, "question.twice", {{"fs", subject_.fs}, {"f", subject_.f}}, j.enough,
                                 "accepted")};
  }
  void show(Board& board, const Sampled<double>& s) {
    taken_.push_back(s);
    board.milestone(drawing());
  }
  Event say(const Sampled<double>& s) const {
    const double value = told(s.value);
    return {.text = value == 0 ? "twice.zero" : "twice.sampled",
            .facts = {{"k", s.k}, {"t", s.time}, {"value", value}},
            .row = {s.k, s.time, value},
            .key = figure_number(s.k),
            .phase = words_.say("phase.samples")};
  }
  void show(Board& board, const CameBack&) { board.milestone(drawing()); }
  Event say(const CameBack& b) const {
    return {.text = b.size == 0 ? "twice.nothing" : "twice.smaller",
            .facts = {{"size", b.size}},
            .words = {{"f", subject_.f}, {"fs", subject_.fs}, {"count", subject_.count}},
            .phase = words_.say("phase.back")};
  }

 private:
  View drawing() const {
    View view;
    add_axes(view, panel_, "a", {words_.symbol("t"), ""}, 6);
    view.add({"b zero", Role::guide,
              Stroke{panel_.at({0, 0}), panel_.at({subject_.seconds(), 0}), false, false, true}});
    const double cycles = subject_.f * subject_.seconds();
    view.add({"c sine", Role::input,
              path_of(panel_, 0, subject_.seconds(), cycles, [&](double t) { return subject_.value(t); })});
    if (judged_) {
      const double first = subject_.value(0);
      view.add({"d back", Role::rejected, path_of(panel_, 0, subject_.seconds(), cycles, [&](double t) {
                  return told(first) * sin_cos_half_turns(t * subject_.fs).cos;
                })});
    }
    for (const Sampled<double>& s : taken_) {
      const bool now = !judged_ && s.k + 1 == std::ssize(taken_);
      view.add({fmt::format("f sample {:02}", s.k), now ? Role::current : Role::accepted,
                Dot{panel_.at({s.time, told(s.value)})}});
    }
    return view;
  }

  const Words& words_;
  const Subject subject_;
  const Panel panel_;
  std::vector<Sampled<double>> taken_{};
  bool judged_ = false;
};

inline void tell_at_least_twice(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const double f = *given.number("frequency");
  const Subject subject = subject_of(given, 2 * std::abs(f));
  narrator.paper(TwiceStory::width, TwiceStory::height);
  narrator.subtitle("subtitle.sine", {{"f", subject.f}, {"fs", subject.fs}, {"phase", subject.phase * 360}});
  narrator.columns({{"k"}, {"t"}, {"value"}});
  narrator.legend({{Role::input, "sine"},
                   {Role::current, "sample"},
                   {Role::accepted, "samples"},
                   {Role::rejected, "back"}});
  for (const std::size_t on_a_stem : {std::size_t{1}, std::size_t{2}})
    narrator.trace().legend[on_a_stem].sample = Sample::dot;
  TwiceStory story(narrator.words(), subject);
  const auto watch = narrator.watcher(story);
  std::vector<double> samples(static_cast<std::size_t>(subject.count));
  sample([&](double t) { return subject.value(t); }, subject.fs, std::span(samples),
         [&](const Sampled<double>& s) { watch(s, 0); });
  at_least_twice(subject.f, subject.fs, watch);
  const double left = std::abs(told(subject.value(0)));
  watch(CameBack{left}, 0);
  narrator.telling({subject.count, 0});
  narrator.result({{"size", left}});
}

}  // namespace gradus::sampling_theorem
