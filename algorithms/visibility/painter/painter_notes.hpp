#pragma once
// Exhibits: orders of lecture notes, which take one number of a whole polygon for its depth, kept so that
// figures can show what comes of it. Never draw with them; painter.hpp has the right one.

#include <functional>

#include "core/merge_sort.hpp"
#include "visibility/painter/painter.hpp"

namespace gradus::painter {

/// The mean of a polygon's corners, which is no centroid where they crowd.
template <class T>
glm::vec<3, T> mean(const Polygon<T>& polygon) {
  glm::vec<3, T> sum(T{0});
  for (const auto& corner : polygon.corners) sum = sum + corner;
  return sum / T(static_cast<double>(polygon.corners.size()));
}

/// The square of a point's distance from the eye; its depth where the eye is infinitely far away.
template <class T>
T far_from(const Eye<T>& eye, const glm::vec<3, T>& point) {
  if (eye.w == T{0}) return -glm::dot(glm::vec<3, T>(eye), point);
  const glm::vec<3, T> way = point - glm::vec<3, T>(eye);
  return glm::dot(way, way);
}

/// Polygons in descending order of a key, and how many comparisons it took.
template <class T, class Key>
Sorted<T> sort_by(std::vector<Polygon<T>> polygons, const Key& key) {
  const std::size_t comparisons = merge_sort(polygons, [&](const Polygon<T>& a, const Polygon<T>& b) {
    return std::invoke(key, a) > std::invoke(key, b);
  });
  return {std::move(polygons), comparisons};
}

/// FAULTY: gives polygons to `draw` by the distances of their means of corners from the eye, the farthest
/// first. No cycle is needed for a wrong picture: a wide polygon in front has a far mean.
/// Source: lecture notes on hidden surface removal.
///
/// polygons, view, draw: as farthest_vertex.
///
/// Domain: as farthest_vertex. Steps: Sorted Drawn* Finished
/// Accuracy: no useful bound: the order is right where polygons are small beside their distances in depth.
/// Cost: n log n comparisons. Errors: none.
template <class T, class Draw, Observer<Sorted<T>, Drawn<T>, Finished> O = Unobserved>
void centroid(const std::vector<Polygon<T>>& polygons, const View<T>& view, Draw&& draw, O&& observer = {}) {
  const auto key = [&](const auto& p) {
    // The distance of the mean stands for all
    return far_from(view.eye, mean(p));
  };
  const auto list = sort_by(polygons, key);
  if constexpr (observed<O>) observer(list);
  for (const auto& p : list.order) {
    draw(p);
    if constexpr (observed<O>) observer(Drawn<T>{p});
  }
  if constexpr (observed<O>) observer(Finished{});
}

/// FAULTY: gives polygons to `draw` by their mean depths, the deepest first, which "ensures" the order.
/// Source: lecture notes on rendering an image.
///
/// polygons, view, draw: as farthest_vertex.
///
/// Domain: as farthest_vertex. Steps: Sorted Drawn* Finished
/// Accuracy: no useful bound, as centroid. Cost: n log n comparisons. Errors: none.
template <class T, class Draw, Observer<Sorted<T>, Drawn<T>, Finished> O = Unobserved>
void mean_depth(const std::vector<Polygon<T>>& polygons, const View<T>& view, Draw&& draw,
                O&& observer = {}) {
  const auto key = [&](const auto& p) {
    // The mean of the depths stands for all
    return glm::dot(view.forward, mean(p));
  };
  const auto list = sort_by(polygons, key);
  if constexpr (observed<O>) observer(list);
  for (const auto& p : list.order) {
    draw(p);
    if constexpr (observed<O>) observer(Drawn<T>{p});
  }
  if constexpr (observed<O>) observer(Finished{});
}

/// FAULTY: gives polygons to `draw` by their mean z, the largest first, and calls it a z-buffer. Whoever
/// looks along -z has the largest z nearest: it is drawn first, and all others over it. Source: lecture notes
/// on drawing a model's faces.
///
/// polygons, draw: as farthest_vertex. view: is not asked.
///
/// Domain: as farthest_vertex. Steps: Sorted Drawn* Finished
/// Accuracy: no useful bound: for an eye that looks along -z it is about the reverse of the right order.
/// Cost: n log n comparisons. Errors: none.
template <class T, class Draw, Observer<Sorted<T>, Drawn<T>, Finished> O = Unobserved>
void descending_mean_z(const std::vector<Polygon<T>>& polygons, const View<T>&, Draw&& draw,
                       O&& observer = {}) {
  const auto key = [](const auto& p) {
    // The largest z, wherever the eye is
    return mean(p).z;
  };
  const auto list = sort_by(polygons, key);
  if constexpr (observed<O>) observer(list);
  for (const auto& p : list.order) {
    draw(p);
    if constexpr (observed<O>) observer(Drawn<T>{p});
  }
  if constexpr (observed<O>) observer(Finished{});
}

}  // namespace gradus::painter
