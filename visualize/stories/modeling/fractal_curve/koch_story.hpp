#pragma once
// Segment by segment: which one gives way, and where the four that replace it lie.

#include "stories/modeling/fractal_curve/subject.hpp"

namespace gradus::fractal_curve {

class KochStory : public Past<steps::Started, Replaced, LevelDone, Finished> {
 public:
  KochStory(const Words& words, const Subject& subject, const Panel& panel)
      : words_(words), subject_(subject), panel_(panel) {}

  Event say(const steps::Started&) const {
    return {.text = subject_.closed() ? "started.snowflake" : "started.curve",
            .words = {{"levels", subject_.level}},
            .row = row(0, subject_.closed() ? 1 : 0)};
  }
  Event say(const Replaced& r) const {
    const Way way = places(r);
    const dvec2 tip = way[2];
    Event event{.text = subject_.inward ? "replaced.inside" : "replaced",
                .facts = {{"level", r.level},
                          {"segment", static_cast<std::int64_t>(r.segment)},
                          {"x", tip.x},
                          {"y", tip.y}},
                .words = {{"a", way[0]}, {"b", way[1]}, {"c", tip}, {"d", way[3]}, {"e", way[4]}},
                .key = fmt::format("{}.{}", r.level, r.segment + 1),
                .phase = phase(r.level),
                .decides = where_is_the_tip(r, tip)};
    // The level's row counts the segments until it is complete
    (r.segment == 0 ? event.row : event.read) = {r.level, 4 * (r.segment + 1)};
    return event;
  }
  Event say(const LevelDone& d) const {
    const std::int64_t whole = power(9, d.level), before = subject_.segments(d.level - 1);
    Event event{
        .text = "level_done",
        .facts = {{"level", d.level},
                  {"segments", d.segments},
                  {"length", static_cast<double>(power(4, d.level)) / static_cast<double>(power(3, d.level))},
                  {"area", static_cast<double>(d.triangles) / static_cast<double>(whole)}},
        .words = {{"before", before}, {"factor", length(d.level)}, {"part", fraction_of(d.triangles, whole)}},
        .note = words_.say("note.segments", {{"before", before}, {"segments", d.segments}}),
        .key = fmt::format("{}", d.level),
        .phase = phase(d.level)};
    (subject_.tells_segments(d.level) ? event.read : event.row) = row(d.level, d.triangles);
    return event;
  }
  Event say(const Finished& f) const {
    return {.text = subject_.inward     ? "finished.inside"
                    : subject_.closed() ? "finished.snowflake"
                                        : "finished.curve",
            .facts = {{"segments", f.segments}},
            .words = {{"factor", length(subject_.level)}, {"dimension", similarity_dimension(4, 3)}}};
  }

  /// A segment of the last level that is told, where about half of them have given way.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Replaced>) {
      const auto half = static_cast<Index>(subject_.segments(step.level - 1) * 5 / 12);
      return step.level == subject_.last_told() && step.segment == half ? 1 : 0;
    }
    return 0;
  }

  View draw() const {
    View view;
    if (subject_.inward)
      view.add({"a right", Role::candidate, Path{panel_.at(subject_.right_way()), false, true}});
    const Replaced* r = now<Replaced>();
    const int level = r ? r->level : last<LevelDone>() ? last<LevelDone>()->level : 0;
    if (level == 0) add(view, "b base", Role::input, subject_.way(0));
    if (level > 0 && !now<Finished>()) add(view, "b before", Role::past, subject_.way(level - 1));
    if (level > 0 && !r) add(view, "c after", Role::result, subject_.way(level));
    if (r)
      add_replaced(view, *r);
    else
      add_ends(view);
    return view;
  }

 private:
  Way places(const Replaced& r) const {
    Way way;
    for (const Corner c : r.way) way.push_back(subject_.at(c, r.level));
    return way;
  }
  std::string phase(int level) const { return words_.say("phase.level", {{"level", level}}); }
  static std::string length(int level) { return fraction_of(power(4, level), power(3, level)); }
  std::vector<Said> row(int level, std::int64_t triangles) const {
    return {level, subject_.segments(level), length(level), fraction_of(triangles, power(9, level))};
  }
  /// The tip, or its mirror image; the lower one first.
  std::optional<Decision> where_is_the_tip(const Replaced& r, dvec2 tip) const {
    const Corner third = r.way[1] - r.way[0];
    const Corner other = r.way[1] + (subject_.inward ? turned(third) : turned_back(third));
    const dvec2 mirrored = subject_.at(other, r.level);
    std::vector<std::string> answers{figure_place(tip), figure_place(mirrored)};
    if (answers[0] == answers[1]) return std::nullopt;
    const bool second = mirrored.y < tip.y || (mirrored.y == tip.y && mirrored.x < tip.x);
    if (second) std::swap(answers[0], answers[1]);
    return Decision{words_.say("question.tip"), answers, second ? 1u : 0u,
                    subject_.inward ? "right" : "left"};
  }
  void add(View& view, const std::string& id, Role role, const Way& way) const {
    view.add({id, role, Path{panel_.at(way)}});
  }
  /// Of the base: they stay where they are.
  void add_ends(View& view) const {
    for (const dvec2 end : {subject_.base.a, subject_.base.b}) {
      const std::string name = figure_place(end);
      view.add_named("d end " + name, Role::input, panel_.at(end), name);
    }
  }
  /// What has been replaced so far, and the one at hand with its names.
  void add_replaced(View& view, const Replaced& r) const {
    Way done = subject_.way(r.level);
    done.resize(4 * r.segment + 1);
    if (done.size() > 1) add(view, "c so far", Role::accepted, done);
    const Way way = places(r);
    view.add({"d old", Role::rejected, Stroke{panel_.at(way[0]), panel_.at(way[4])}});
    add(view, "e parts", Role::current, way);
    for (Index k = 0; k < way.size(); ++k) {
      const std::string name(1, static_cast<char>('A' + static_cast<char>(k)));
      view.add_named("f corner " + name, Role::current, panel_.at(way[k]), name);
    }
  }

  const Words& words_;
  const Subject& subject_;
  const Panel& panel_;
};

}  // namespace gradus::fractal_curve
