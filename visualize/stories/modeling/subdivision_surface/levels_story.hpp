#pragma once
// The levels of a surface: the one at hand large, those before it beside it, a step each.

#include <array>
#include <utility>
#include <vector>

#include "stories/modeling/subdivision_surface/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::subdivision_surface {

class LevelsStory : public Past<steps::Started, LevelDone> {
 public:
  LevelsStory(const Words& words, const Subject& subject, std::vector<Control> levels)
      : words_(words), levels_(std::move(levels)), pictures_(words, subject) {}

  const Control& last() const { return levels_.back(); }

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

  View draw() const {
    const std::size_t reached = all<LevelDone>().size();
    View view;
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
      const LevelPicture small{
          .id = fmt::format("{}", k), .place = small_places[k], .heading = heading(k), .aside = true};
      if (k < reached)
        pictures_.add(view, small, levels_[k]);
      else
        pictures_.add_heading(view, small);
    }
    pictures_.add(view, {.id = "large", .place = large_places[1], .heading = heading(reached)},
                  levels_[reached]);
    return view;
  }

 private:
  static constexpr std::array<Extent, 4> small_places{{{{0.2, 13.8}, {9.2, 27}},
                                                       {{9.6, 13.8}, {18.6, 27}},
                                                       {{0.2, 0.2}, {9.2, 13.4}},
                                                       {{9.6, 0.2}, {18.6, 13.4}}}};

  std::string heading(std::size_t k) const {
    return k == 0 ? words_.say("control") : words_.say("level", {{"level", k}});
  }

  const Words& words_;
  const std::vector<Control> levels_;
  const LevelPictures pictures_;
};

}  // namespace gradus::subdivision_surface
