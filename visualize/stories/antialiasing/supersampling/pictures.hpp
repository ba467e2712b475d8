#pragma once
// Pictures of the same plane beside each other: more and more samples per pixel, or one filter after the
// other with a part of each magnified below it.

#include "stories/antialiasing/chequered_plane.hpp"
#include "stories/antialiasing/supersampling/subject.hpp"
#include "stories/picture_shelf.hpp"

namespace gradus::supersampling {

/// What a picture is made with.
struct Way {
  int n;
  Filter filter;
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
struct Told {
  std::string_view started, done, finished;  ///< texts
  std::vector<Way> ways;
  bool filters = false;  ///< the ways differ in their filters
};

/// Each picture against one with 32 x 32 samples and the same filter.
inline void tell_pictures(Narrator& narrator, const Told& told) {
  const ChequeredPlane scene;
  const Words& words = narrator.words();
  narrator.columns({{told.filters ? "filter" : "samples", false}, {"asked"}, {"kept"}, {"off"}});
  if (told.filters) narrator.add_to_legend(Role::current, "magnified");
  std::vector<std::string> names;
  for (const Way& way : told.ways)
    names.push_back(told.filters ? filter_name(words, way.filter) : fmt::format("{0} × {0}", way.n));
  PictureShelf::Look look{
      .size = scene.size, .names = names, .row = told.filters ? 0 : 2, .gap = 4, .heading = 7};
  if (told.filters) look.part = {{18, 12}, {12, 9}, 4};
  PictureShelf shelf(narrator, std::move(look));
  shelf.frame(Role::past);
  shelf.start({.text = told.started, .words = {{"columns", scene.size.x}, {"rows", scene.size.y}}});
  std::vector<double> off;
  std::vector<dvec3> right;
  for (std::size_t k = 0; k < told.ways.size(); ++k) {
    const Way way = told.ways[k];
    Taken taken;
    if (k == 0 || way.filter != told.ways[k - 1].filter) right = picture_of(scene, {32, way.filter}, taken);
    LineOf<Filtered<dvec3>> mean;
    const std::vector<dvec3> values = picture_of(scene, way, taken, mean);
    off.push_back(difference(values, right));
    const std::int64_t samples = std::int64_t{way.n} * way.n;
    Event event{.text = told.done,
                .facts = {{"samples", samples}, {"asked", taken.asked}, {"off", off.back()}},
                .words = {{"name", names[k]}, {"kept", taken.kept}, {"shades", samples + 1}},
                .row = {names[k], taken.asked, taken.kept, off.back()},
                .key = fmt::format("{} {}", way.n, static_cast<int>(way.filter)),
                .phase = names[k]};
    if (!told.filters) event.count = samples;
    shelf.show(
        "PictureDone", mean.line,
        [&](ivec2 p) { return tone_of(values[static_cast<std::size_t>(p.y * scene.size.x + p.x)]); }, event);
  }
  shelf.finish({.text = told.finished, .words = {{"first", off.front()}, {"last", off.back()}}});
  narrator.result({{"first", off.front()}, {"last", off.back()}});
}

inline void tell_more_samples(Narrator& narrator) {
  narrator.subtitle("more.subtitle", {});
  tell_pictures(narrator, {"more.started",
                           "more.done",
                           "more.finished",
                           {{1, Filter::box}, {2, Filter::box}, {4, Filter::box}, {8, Filter::box}}});
}

inline void tell_filters(Narrator& narrator) {
  narrator.list("weight_at");
  narrator.list_below("draw");
  const int n = subject_of(narrator.arguments()).n;
  narrator.subtitle("filters.subtitle", {{"n", fmt::format("{0} × {0}", n)}});
  tell_pictures(narrator, {"filters.started",
                           "filters.done",
                           "filters.finished",
                           {{n, Filter::box}, {n, Filter::tent}, {n, Filter::gaussian}},
                           true});
}

}  // namespace gradus::supersampling
