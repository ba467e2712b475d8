#pragma once
// The levels of a surface as pictures beside each other, a step each.

#include <utility>
#include <vector>

#include "stories/modeling/subdivision_surface/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::subdivision_surface {

class LevelsStory : public Past<steps::Started, LevelDone> {
 public:
  LevelsStory(const Words& words, const Subject& subject, std::vector<Control> levels)
      : words_(words), levels_(std::move(levels)), pictures_(words, subject) {
    for (std::size_t k = 0; k < levels_.size(); ++k) add(all_, k, true);
  }

  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, LevelDone>) return step.level;
    return 0;
  }
  Event say(const steps::Started&) const {
    return {.text = "levels.started",
            .words = {{"vertices", levels_[0].points.size()}, {"faces", levels_[0].faces.size()}},
            .row = {0, levels_[0].points.size(), levels_[0].faces.size()}};
  }
  Event say(const LevelDone& d) const {
    return {.text = d.level == 1 ? "levels.first" : "levels.done",
            .facts = {{"level", d.level}, {"vertices", d.vertices}, {"faces", d.faces}},
            .words = {{"before", levels_[static_cast<std::size_t>(d.level) - 1].faces.size()},
                      {"control", levels_[0].points.size()}},
            .row = {d.level, d.vertices, d.faces},
            .key = fmt::format("{}", d.level),
            .phase = words_.say("level", {{"level", d.level}})};
  }

  /// The names of all levels, and the pictures of those that were reached.
  View draw() const {
    const std::size_t reached = all<LevelDone>().size();
    if (reached + 1 == levels_.size()) return all_;
    View view;
    for (std::size_t k = 0; k < levels_.size(); ++k) add(view, k, k <= reached);
    return view;
  }

 private:
  /// Three above, the others below between them.
  static Extent place(std::size_t k) {
    const dvec2 below = k < 3 ? dvec2{0} : dvec2{6, -13.6};
    return {places[k % 3].lower + below, places[k % 3].upper + below};
  }
  void add(View& view, std::size_t k, bool whole) const {
    const std::string heading = k == 0 ? words_.say("control") : words_.say("level", {{"level", k}});
    pictures_.add(view, fmt::format("{}", k), place(k), heading, whole ? levels_[k] : Control{});
  }

  const Words& words_;
  const std::vector<Control> levels_;
  const LevelPictures pictures_;
  View all_{};
};

}  // namespace gradus::subdivision_surface
