#pragma once
// What the story of patterns shows of two exhibits: samples that see a finished picture, and sums that are
// divided by what was asked for.

#include <string>
#include <vector>

#include "antialiasing/jittered/jittered_notes.hpp"
#include "stories/antialiasing/jittered/drawing.hpp"

namespace gradus::jittered {

/// A sample is put where it should be, and something else is made of it.
class FaultyStory {
 public:
  static constexpr Square pixel{{1, 23}, 22};

  FaultyStory(const Words& words, const Edge& edge, int asked, bool whole)
      : words_(words), edge_(edge), area_(edge.area()), asked_(asked), whole_(whole) {}

  double mean() const { return mean_; }
  double area() const { return area_; }
  /// The last sample.
  StepNumber telling() const { return {milestones_ - 1, 0}; }

  void show(Board& board, const Cut& c) {
    grid_ = c.grid;
    put(board);
  }
  Event say(const Cut& c) const {
    Event event{.text = whole_ ? "whole.cut" : "asked.cut",
                .facts = {{"columns", c.grid.x}, {"rows", c.grid.y}},
                .words = {{"area", area_}},
                .count = asked_};
    if (!whole_) event.words.push_back({"cells", c.grid.x * c.grid.y});
    event.begins = true;
    return event;
  }
  void show(Board&, const Placed& p) { placed_ = p; }
  Event say(const Placed&) const { return {}; }
  void show(Board& board, const Looked<double>& l) {
    samples_.push_back({placed_->place, l.colour > 0.5});
    sum_ += l.colour;
    mean_ = l.mean;
    put(board);
  }
  Event say(const Looked<double>& l) const {
    const bool inside = l.colour > 0.5;
    Event event{.text = whole_ ? "whole.looked" : "asked.looked",
                .facts = {{"index", l.index},
                          {"cell", placed_->cell},
                          {"x", l.place.x},
                          {"y", l.place.y},
                          {"inside", inside},
                          {"mean", l.mean}},
                .words = {{"k", l.index + 1}, {"place", placed_->place}},
                .row = {l.index + 1, placed_->cell, placed_->place,
                        words_.shared("words", inside ? "yes" : "no"), l.mean},
                .key = figure_number(l.index + 1)};
    if (whole_) {
      event.words.push_back({"pixel", ivec2(l.place)});
    } else {
      event.words.push_back({"side", words_.say(inside ? "side.inside" : "side.outside")});
      event.words.push_back({"hits", sum_});
      event.words.push_back({"asked", asked_});
    }
    return event;
  }
  void show(Board& board, const Finished&) {
    placed_.reset();
    put(board);
  }
  Event say(const Finished& f) const {
    Event event{.text = whole_               ? "whole.finished"
                        : f.samples < asked_ ? "asked.short"
                                             : "asked.finished",
                .facts = {{"samples", f.samples}, {"mean", mean_}, {"area", area_}},
                .count = f.samples};
    if (!whole_) {
      event.words.push_back({"asked", asked_});
      event.words.push_back({"right", sum_ / f.samples});
    }
    return event;
  }

 private:
  void put(Board& board) {
    ++milestones_;
    View view;
    pixel.put_scene(view, "a", edge_);
    // The finished picture has one colour here
    if (whole_) view.marks.erase("a0 scene");
    if (whole_ && edge_.holds({0.5, 0.5}))
      view.add({"a0 colour", Role::input, Area{{pixel.box({0, 0}, {1, 1})}, 1}});
    pixel.put_grid(view, "b grid", Role::guide, grid_, false);
    for (std::size_t i = 0; whole_ && i < samples_.size(); ++i)
      view.add({fmt::format("c way {:02}", i), Role::rejected,
                Stroke{pixel.at(samples_[i].place), pixel.at({0, 0}), true, true}});
    pixel.put_samples(view, "d sample", samples_);
    if (placed_) view.add({"e now", Role::current, Dot{pixel.at(placed_->place), !samples_.back().inside}});
    std::optional<double> mean;
    if (!samples_.empty()) mean = mean_;
    put_scale(view, words_, {25.6, 1}, 22, area_, mean);
    board.milestone(std::move(view));
  }

  const Words& words_;
  const Edge edge_;
  const double area_;
  const int asked_;
  const bool whole_;
  ivec2 grid_{1, 1};
  std::vector<Dropped> samples_;
  std::optional<Placed> placed_;
  std::int64_t milestones_ = -1;
  double sum_ = 0, mean_ = 0;
};

}  // namespace gradus::jittered
