#pragma once
// Pictures of the same scene beside each other, with a part of each magnified below it: more and more samples
// a pixel, one filter after the other, and one ray or several.

#include "stories/antialiasing/supersampling_subject.hpp"

namespace gradus::supersampling {

/// What a picture is made with.
struct Way {
  int n;
  Filter filter;
};

/// A picture is done.
struct PictureDone {
  std::size_t number;
  std::vector<dvec3> values;  ///< row by row
  Taken taken;
};

/// Each of some ways to make a picture of a scene of light.
template <class Scene, class Observer = Unobserved>
std::vector<dvec3> picture_of(const Scene& scene, Way way, Taken& taken, Observer&& observer = {}) {
  std::vector<dvec3> values;
  const auto light = [&](dvec2 place) { return dvec3(scene(place)); };
  taken = supersample(
      {{0, 0}, scene.size - 1}, way.n, way.filter, light,
      [&](ivec2, const dvec3& value) { values.push_back(value); }, observer);
  return values;
}

/// Root mean square of the differences of two pictures, over pixels and colours.
inline double difference(const std::vector<dvec3>& a, const std::vector<dvec3>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += glm::dot(a[i] - b[i], a[i] - b[i]) / 3;
  return std::sqrt(squares / static_cast<double>(a.size()));
}

/// What is told of a set of pictures.
struct Shelf {
  std::string_view started, done, finished;  ///< texts
  bool filters = false;                      ///< the ways differ in their filters
  ivec2 size{}, crop_at{}, crop{};           ///< of a picture; its part that is shown magnified
  int magnified = 4;
  std::vector<Way> ways{};
};

class PicturesStory {
 public:
  PicturesStory(const Words& words, const Shelf& shelf, const std::vector<std::vector<dvec3>>& references)
      : words_(words), shelf_(shelf), references_(references) {
    for (std::size_t k = 0; k < shelf_.ways.size(); ++k) {
      put_name(k);
      base_.add({fmt::format("a frame {}", k), Role::past, round_cells(corner(k), shelf_.size)});
      base_.add({fmt::format("a crop {}", k), Role::current, round_cells(crop_corner(k), large_crop())});
    }
  }

  ivec2 cells() const {
    const int many = static_cast<int>(shelf_.ways.size());
    return {many * column() + (many - 1) * gap() + 2, crop_corner(0).y + large_crop().y + 1};
  }

  void show(Board& board, const steps::Started&) { board.milestone(base_); }
  Event say(const steps::Started&) const {
    return {.text = shelf_.started, .words = {{"columns", shelf_.size.x}, {"rows", shelf_.size.y}}};
  }
  void show(Board& board, const PictureDone& p) {
    off_.push_back(difference(p.values, references_[p.number]));
    const auto value = [&](ivec2 at) {
      return p.values[static_cast<std::size_t>(at.y * shelf_.size.x + at.x)];
    };
    put_values(base_, corner(p.number), shelf_.size, 1, value);
    put_values(base_, crop_corner(p.number), shelf_.crop, shelf_.magnified,
               [&](ivec2 at) { return value(at + shelf_.crop_at); });
    base_.add({fmt::format("b part {}", p.number), Role::current,
               round_cells(corner(p.number) + shelf_.crop_at, shelf_.crop)});
    board.milestone(base_);
  }
  Event say(const PictureDone& p) const {
    const Way way = shelf_.ways[p.number];
    const std::int64_t samples = std::int64_t{way.n} * way.n;
    Event event{.text = shelf_.done,
                .facts = {{"samples", samples}, {"asked", p.taken.asked}, {"off", off_.back()}},
                .words = {{"name", name(p.number)},
                          {"asked", p.taken.asked},
                          {"kept", p.taken.kept},
                          {"shades", samples + 1},
                          {"off", off_.back()}},
                .row = {name(p.number), p.taken.asked, p.taken.kept, off_.back()},
                .key = fmt::format("{} {}", way.n, static_cast<int>(way.filter))};
    event.phase = name(p.number);
    if (!shelf_.filters) event.count = samples;
    return event;
  }
  void show(Board& board, const steps::Finished&) { board.milestone(base_); }
  Event say(const steps::Finished&) const {
    return {.text = shelf_.finished, .words = {{"first", off_.front()}, {"last", off_.back()}}};
  }
  double off(std::size_t k) const { return off_[k]; }

 private:
  ivec2 large_crop() const { return shelf_.crop * shelf_.magnified; }
  int column() const { return std::max(shelf_.size.x, large_crop().x); }
  int line() const { return std::max(4, shelf_.size.y / 7); }
  static int gap() { return 4; }
  ivec2 corner(std::size_t k) const {
    return {1 + static_cast<int>(k) * (column() + gap()) + (column() - shelf_.size.x) / 2, line() + 1};
  }
  ivec2 crop_corner(std::size_t k) const {
    return {1 + static_cast<int>(k) * (column() + gap()) + (column() - large_crop().x) / 2,
            corner(k).y + shelf_.size.y + gap()};
  }
  std::string name(std::size_t k) const {
    if (shelf_.filters) return filter_name(words_, shelf_.ways[k].filter);
    return fmt::format("{0} × {0}", shelf_.ways[k].n);
  }
  void put_name(std::size_t k) {
    const dvec2 at{corner(k).x + 0.5 * shelf_.size.x - 0.5, 0.45 * line()};
    base_.add({fmt::format("a name {}", k), Role::guide, Text{at, name(k)}});
  }

  const Words& words_;
  const Shelf& shelf_;
  const std::vector<std::vector<dvec3>>& references_;
  View base_{};
  std::vector<double> off_{};
};

/// Each picture against one with 32 x 32 samples and the same filter.
template <class Scene>
void tell_pictures(Narrator& narrator, const Scene& scene, const Shelf& shelf) {
  std::vector<std::vector<dvec3>> references;
  for (std::size_t k = 0; k < shelf.ways.size(); ++k) {
    Taken taken;
    const bool again = k > 0 && shelf.ways[k].filter == shelf.ways[k - 1].filter;
    references.push_back(again ? references[k - 1] : picture_of(scene, {32, shelf.ways[k].filter}, taken));
  }
  PicturesStory story(narrator.words(), shelf, references);
  set_cells(narrator, story.cells());
  narrator.columns({{shelf.filters ? "filter" : "samples", false}, {"asked"}, {"kept"}, {"off"}});
  narrator.legend({{Role::current, "magnified"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (std::size_t k = 0; k < shelf.ways.size(); ++k) {
    Taken taken;
    LineOf<Filtered<dvec3>> mean;
    const std::vector<dvec3> values = picture_of(scene, shelf.ways[k], taken, mean);
    watch(PictureDone{k, values, taken}, mean.line);
  }
  watch(steps::Finished{}, 0);
  narrator.telling({static_cast<std::int64_t>(shelf.ways.size()), 0});
  narrator.result({{"first", story.off(0)}, {"last", story.off(shelf.ways.size() - 1)}});
}

inline void tell_more_samples(Narrator& narrator) {
  const ShapesScene scene{ivec2(40)};
  const Shelf shelf{.started = "more.started",
                    .done = "more.done",
                    .finished = "more.finished",
                    .size = scene.size,
                    .crop_at = {15, 28},
                    .crop = {10, 10},
                    .ways = {{1, Filter::box}, {2, Filter::box}, {4, Filter::box}, {8, Filter::box}}};
  narrator.subtitle("more.subtitle", {});
  tell_pictures(narrator, scene, shelf);
}

inline void tell_filters(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const ShapesScene scene{ivec2(40)};
  const Shelf shelf{
      .started = "filters.started",
      .done = "filters.done",
      .finished = "filters.finished",
      .filters = true,
      .size = scene.size,
      .crop_at = {15, 28},
      .crop = {10, 10},
      .ways = {{subject.n, Filter::box}, {subject.n, Filter::tent}, {subject.n, Filter::gaussian}}};
  narrator.subtitle("filters.subtitle", {{"n", fmt::format("{0} × {0}", subject.n)}});
  tell_pictures(narrator, scene, shelf);
}

}  // namespace gradus::supersampling
