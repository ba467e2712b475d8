#pragma once
// A curve made of its samples: a kernel on each of them, added one by one.

#include "stories/antialiasing/sampling_theorem/sine_story.hpp"

namespace gradus::sampling_theorem {

class KernelStory {
 public:
  KernelStory(const Words& words, const Subject& subject, std::vector<double> samples, double place)
      : words_(words),
        subject_(subject),
        samples_(std::move(samples)),
        place_(place),
        panel_({{2.6, 3.4}, {39.4, 24.6}}, {{0, -1.25}, {static_cast<double>(subject.count), 1.25}},
               Panel::Fit::stretched) {}

  static constexpr int width = 42, height = 26;

  void show(Board& board, const steps::Started&) { board.milestone(drawing()); }
  Event say(const steps::Started&) const {
    return {.text = "kernels.started", .words = {{"x", place_}, {"count", subject_.count}}};
  }
  void show(Board& board, const KernelAdded& a) {
    added_ = a;
    ++kernels_;
    board.milestone(drawing());
  }
  Event say(const KernelAdded& a) const {
    const double sample = told(a.sample), sum = told(a.sum);
    return {.text = sample == 0 ? "kernels.none" : "kernels.added",
            .facts = {{"k", a.k}, {"sample", sample}, {"kernel", a.kernel}, {"sum", sum}},
            .words = {{"x", place_}},
            .row = {a.k, sample, a.kernel, sum},
            .key = figure_number(a.k),
            .phase = words_.say("phase.kernels")};
  }
  void show(Board& board, const steps::Finished&) {
    ended_ = true;
    board.milestone(drawing());
  }
  Event say(const steps::Finished&) const {
    const double right = told(subject_.value(place_ / subject_.fs)), sum = told(added_->sum);
    const bool enough = is_enough(subject_.f, subject_.fs);
    const double alias = alias_of(subject_.f, subject_.fs);
    return {.text = enough                     ? "kernels.right"
                    : 2 * alias == subject_.fs ? "kernels.half"
                                               : "kernels.wrong",
            .facts = {{"sum", sum}, {"right", right}},
            .words = {{"x", place_},
                      {"f", subject_.f},
                      {"fs", subject_.fs},
                      {"twice", 2 * std::abs(subject_.f)},
                      {"alias", alias}},
            .decides = yes_or_no(words_, "question.enough",
                                 {{"fs", subject_.fs}, {"twice", 2 * std::abs(subject_.f)}}, enough,
                                 "the sine itself", "an alias")};
  }

 private:
  /// The sum of the first kernels at a place.
  double partial(double x, std::int64_t kernels) const {
    std::vector<double> first = samples_;
    std::fill(first.begin() + static_cast<std::ptrdiff_t>(kernels), first.end(), 0.0);
    return reconstruct(std::span<const double>(first), x, Dirichlet{subject_.count});
  }
  View drawing() const {
    View view;
    const auto end = static_cast<double>(subject_.count);
    add_axes(view, panel_, "a", {words_.symbol("x"), ""}, 6);
    view.add({"b zero", Role::guide, Stroke{panel_.at({0, 0}), panel_.at({end, 0}), false, false, true}});
    Path sine = path_of(panel_, 0, end, subject_.f * subject_.seconds(),
                        [&](double x) { return subject_.value(x / subject_.fs); });
    sine.dashed = true;
    view.add({"c sine", Role::input, sine});
    for (std::int64_t k = 0; k < subject_.count; ++k) {
      const bool past = k < kernels_, now = past && !ended_ && k + 1 == kernels_;
      view.add({fmt::format("f sample {:02}", k), now ? Role::current : Role::accepted,
                Dot{panel_.at({static_cast<double>(k), samples_[static_cast<std::size_t>(k)]}), !past}});
    }
    const Stroke at{panel_.at({place_, -1.25}), panel_.at({place_, 1.25}), false, true, true};
    view.add({"g place", Role::measure, at});
    if (added_ && !ended_) {
      view.add({"d kernel", Role::candidate, path_of(panel_, 0, end, end, [&](double x) {
                  return added_->sample * Dirichlet{subject_.count}(x - static_cast<double>(added_->k));
                })});
    }
    if (added_) {
      view.add({"e sum", Role::result,
                path_of(panel_, 0, end, end, [&](double x) { return partial(x, kernels_); })});
      view.add({"h value", Role::measure, Dot{panel_.at({place_, added_->sum})}});
    }
    return view;
  }

  const Words& words_;
  const Subject subject_;
  const std::vector<double> samples_;
  const double place_;
  const Panel panel_;
  std::optional<KernelAdded> added_{};
  std::int64_t kernels_ = 0;
  bool ended_ = false;
};

inline void tell_reconstruction(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const Subject subject = subject_of(given);
  const double cycles = subject.f * static_cast<double>(subject.count) / subject.fs,
               place = *given.number("place");
  if (std::abs(cycles - std::round(cycles)) > 1e-9)
    refuse(given, {"frequency", "samples", "rate"},
           "expected whole cycles in all samples: samples times frequency / rate a whole number");
  if (!(0 <= place && place <= static_cast<double>(subject.count)))
    refuse("place", "expected a place from 0 to {}, found {}", subject.count, place);
  narrator.paper(KernelStory::width, KernelStory::height);
  narrator.subtitle("subtitle.sine", {{"f", subject.f}, {"fs", subject.fs}, {"phase", subject.phase * 360}});
  narrator.columns({{"k"}, {"value"}, {"kernel"}, {"sum"}});
  narrator.legend({{Role::input, "sine_dashed"},
                   {Role::accepted, "samples"},
                   {Role::candidate, "kernel"},
                   {Role::result, "sum"},
                   {Role::measure, "place"}});
  std::vector<double> samples(static_cast<std::size_t>(subject.count));
  sample([&](double t) { return subject.value(t); }, subject.fs, std::span(samples));
  KernelStory story(narrator.words(), subject, samples, place);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const double sum = reconstruct(std::span<const double>(samples), place, Dirichlet{subject.count}, watch);
  watch(steps::Finished{}, narrator.line());
  narrator.telling({subject.count + 1, 0});
  narrator.result({{"sum", told(sum)}});
}

}  // namespace gradus::sampling_theorem
