#pragma once
// The same fan of slivers with 1, 4, 16 and 64 passes beside each other.

#include "stories/antialiasing/accumulation_subject.hpp"

namespace gradus::accumulation_buffer {

/// A picture is done.
struct PictureAccumulated {
  std::int64_t passes;
  Picture picture;
};

/// Slivers from one corner of a picture to the other two sides.
struct Fan {
  static constexpr ivec2 size{15, 15};
  static constexpr int slivers = 6;

  static Corners sliver(int k) {
    const dvec2 hub{0.4, 14.6};
    const auto rim = [&](double part) {
      const double turn = 1.5707963267948966 * part;
      return hub + 16.0 * dvec2{gradus::cos(turn), -gradus::sin(turn)};
    };
    const double from = (k + 0.4) / slivers;
    return {hub, rim(from), rim(from + 0.22 / slivers)};
  }
  static double colour(dvec2 place) {
    for (int k = 0; k < slivers; ++k) {
      if (holds(sliver(k), place)) return 1;
    }
    return 0;
  }
  /// The exact area of the slivers in a pixel: they touch in the hub alone.
  static double area(ivec2 pixel) {
    double area = 0;
    for (int k = 0; k < slivers; ++k) area += area_of(part_in(sliver(k), pixel));
    return area;
  }
  static PictureAccumulated accumulated(int side) {
    PictureAccumulated done{std::int64_t{side} * side, Picture{size}};
    const auto render = [&](dvec2 place, const Sums<double>& plot) { draw(size, place, colour, plot); };
    accumulate({side, side}, render, done.picture.sums());
    return done;
  }
};

class SideBySideStory {
 public:
  explicit SideBySideStory(const Words& words) : words_(words) {}

  static constexpr ivec2 paper{34, 35};

  void show(Board& board, const steps::Started&) { board.milestone(drawing()); }
  Event say(const steps::Started&) const {
    return {.text = "pictures.started", .words = {{"slivers", Fan::slivers}}, .key = "started"};
  }
  void show(Board& board, const PictureAccumulated& p) {
    done_.push_back(p);
    judge(p.picture);
    board.milestone(drawing());
  }
  Event say(const PictureAccumulated& p) const {
    return {.text = p.passes == 1 ? "pictures.one" : "pictures.more",
            .facts = {{"passes", p.passes}, {"worst", worst_}, {"mean_error", mean_.back()}},
            .words = {{"passes", p.passes},
                      {"greys", p.passes + 1},
                      {"error", mean_.back()},
                      {"before", mean_.size() < 2 ? 0.0 : mean_[mean_.size() - 2]}},
            .row = {p.passes, p.passes + 1, worst_, mean_.back()},
            .key = fmt::format("{} passes", p.passes),
            .phase = words_.say("phase.pictures")};
  }
  void show(Board& board, const steps::Finished&) { board.milestone(drawing()); }
  Event say(const steps::Finished&) const {
    return {.text = "pictures.finished",
            .words = {{"first", mean_.front()}, {"last", mean_.back()}},
            .key = "finished"};
  }
  double mean() const { return mean_.back(); }

 private:
  static Frame frame(std::size_t k) {
    return {{1 + 17 * static_cast<int>(k % 2), 2 + 17 * static_cast<int>(k / 2)}, Fan::size};
  }
  View drawing() const {
    View view;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t passes = std::int64_t{1} << (2 * k);
      frame(k).put(view, fmt::format("a {}", k), words_.count("heading.passes", passes));
      if (k < done_.size()) frame(k).put_picture(view, done_[k].picture);
      for (int s = 0; k >= done_.size() && s < Fan::slivers; ++s) {
        Path outline{{}, true};
        for (const dvec2 p : inside(Fan::sliver(s))) outline.points.push_back(frame(k).on_paper(p));
        view.add({fmt::format("o {} {}", k, s), Role::past, outline});
      }
    }
    return view;
  }
  /// What of a sliver lies in the picture.
  static std::vector<dvec2> inside(const Corners& sliver) {
    std::vector<dvec2> scaled;
    for (const dvec2 p : sliver) scaled.push_back(p / dvec2(Fan::size));
    std::vector<dvec2> part = ring_within(scaled, dvec2(0), dvec2(1));
    for (dvec2& p : part) p *= dvec2(Fan::size);
    return part;
  }
  void judge(const Picture& picture) {
    double sum = 0;
    worst_ = 0;
    for (int y = 0; y < Fan::size.y; ++y) {
      for (int x = 0; x < Fan::size.x; ++x) {
        const double off = std::abs(picture.at({x, y}) - Fan::area({x, y}));
        sum += off;
        worst_ = std::max(worst_, off);
      }
    }
    mean_.push_back(sum / static_cast<double>(picture.values.size()));
  }

  const Words& words_;
  std::vector<PictureAccumulated> done_{};
  std::vector<double> mean_{};
  double worst_ = 0;
};

inline void tell_side_by_side(Narrator& narrator) {
  narrator.subtitle("pictures.subtitle", {{"columns", Fan::size.x}, {"rows", Fan::size.y}});
  set_paper(narrator, SideBySideStory::paper);
  narrator.columns({{"passes"}, {"greys"}, {"worst"}, {"mean_error"}});
  narrator.legend({{Role::past, "slivers"}});
  SideBySideStory story(narrator.words());
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (const int side : {1, 2, 4, 8}) watch(Fan::accumulated(side), 0);
  watch(steps::Finished{}, 0);
  narrator.telling({4, 0});
  narrator.result({{"mean_error", story.mean()}});
}

}  // namespace gradus::accumulation_buffer
