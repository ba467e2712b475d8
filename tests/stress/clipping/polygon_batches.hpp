#pragma once
// Many polygons at a rectangle, in doubles and in floats: inputs, and what differs from one at a time and
// from fractions.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "stress/clipping/clipped_polygons.hpp"
#include "stress/clipping/floats.hpp"

namespace gradus::stress::polygon_batches {

using namespace clipped_polygons;

template <class T>
using PointsOf = std::vector<glm::vec<2, T>>;

// --- Inputs in floats: a window and a polygon ---

inline constexpr std::size_t float_numbers = 4 + 2 * corners;

/// Numbers from end to end of what floats are.
inline double any_float(Random& random) {
  constexpr double largest = std::numeric_limits<float>::max();
  constexpr double some[] = {largest, -largest, 0x1p-126, -0x1p-126, 0x1p-149, -0x1p-149, 0, -0.0, 1, -1};
  if (random.unit() < 0.5) return some[random.uniform_int(0, 9)];
  return sized(random, -149, 126);
}

/// Edges that cross the left border half-way, or a unit in the last place beside that: their crossings lie
/// midway between two floats, or nearly so.
inline Input midway_input(Random& random) {
  const auto ordinate = [&] { return static_cast<double>(random.uniform_int(-0xFFFFFF, 0xFFFFFF)); };
  Input input{0, ordinate(), 4, 0};
  input[3] = random.unit() < 0.5 ? input[1] + 0xFFFFFF : 0xFFFFFF;
  for (std::size_t i = 0; i < corners; ++i) {
    const double size =
        random.unit() < 0.8 ? 1 : 1 + std::ldexp(1, -static_cast<int>(random.uniform_int(20, 23)));
    input.push_back(i % 2 == 0 ? -1 : size);
    input.push_back(ordinate());
  }
  return input;
}

inline Input floats_input(Kind kind, Random& random) {
  Input input(float_numbers);
  if (kind == Kind::extremes) {
    for (double& x : input) x = any_float(random);
  } else if (kind == Kind::ties && random.unit() < 0.5) {
    input = midway_input(random);
  } else {
    const auto shape = [](Kind of, Random& numbers) {
      Input made = rectangle_input(of, numbers);
      made.pop_back();  // the order
      return made;
    };
    input = at_every_scale_of_floats(shape)(kind, random);
  }
  // Some a few floats further, so that what touched may miss
  const bool moved = random.unit() < 0.3;
  for (double& x : input) {
    if (!moved || kind == Kind::refused || random.unit() < 0.5) continue;
    const bool up = random.unit() < 0.5;
    x = double{std::nextafter(static_cast<float>(x), up ? 1e30f : -1e30f)};
  }
  if (kind != Kind::refused) mend_rectangle(input);
  return input;
}

// --- Batches ---

/// The polygon, others beside it, and none.
template <class T>
Polygons<T> batch_of(const Input& i) {
  PointsOf<T> points;
  for (const dvec2& p : points_in(i, 4, corners)) points.emplace_back(p);
  PointsOf<T> half = points;
  for (auto& p : half) p = T(0.5) * p + T(0.5) * points[0];
  const PointsOf<T> back(points.rbegin(), points.rend()), triangle(points.begin(), points.begin() + 3);
  Polygons<T> given;
  for (const PointsOf<T>& one : {points, back, PointsOf<T>{}, half, points, triangle}) given.add(one);
  return given;
}
template <class T>
Rectangle<T> window_of(const Input& i) {
  const Rectangle<double> window = rectangle_of(i);
  return {glm::vec<2, T>(window.lower), glm::vec<2, T>(window.upper)};
}

template <class T>
bool same_bits(const glm::vec<2, T>& p, const glm::vec<2, T>& q) {
  return p == q && std::signbit(p.x) == std::signbit(q.x) && std::signbit(p.y) == std::signbit(q.y);
}

/// How many vertices of a batch differ from those of clip_to_window.
template <class T>
double batch_error(const Input& i) {
  const Polygons<T> given = batch_of<T>(i);
  Polygons<T> clipped;
  BatchClipper<T> clip;
  BatchCount count;
  try {
    // What an earlier batch left in buffers and result must not show
    Polygons<T> earlier;
    for (const T size : {T(3), T(0.25)}) {
      earlier.add(PointsOf<T>{{-size, -size}, {size, -size / 2}, {size / 3, size}, {-size, size / 5}});
    }
    clip(earlier, {{-1, -1}, {1, 1}}, clipped);
    count = clip(given, window_of<T>(i), clipped);
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  if (!rectangle_is_taken(i)) return wrong;
  if (clipped.size() != given.size() || clipped.points.size() != clipped.ends.back()) return wrong;
  if (count.copied + count.dropped + count.clipped != given.size()) return wrong;
  double differ = 0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const auto right = clip_to_window(given[k], window_of<T>(i));
    if (clipped[k].size() != right.size()) return wrong;
    for (std::size_t v = 0; v < right.size(); ++v) differ += !same_bits(clipped[k][v], right[v].at);
  }
  return differ;
}

/// The nearest float, ties to even.
inline float nearest_float(const Fraction& exact) {
  const float guess = static_cast<float>(test::nearest(exact));
  for (const float way : {-HUGE_VALF, HUGE_VALF}) {
    const float beside = std::nextafter(guess, way);
    if (!test::is_nearest(guess, exact) && test::is_nearest(beside, exact)) return beside;
  }
  return guess;
}

/// Without what repeats the one before it, all round.
inline PointsOf<float> without_repeats(const PointsOf<float>& ring) {
  PointsOf<float> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != ring[(i + 1) % ring.size()]) kept.push_back(ring[i]);
  }
  return kept;
}

/// Whether a clipped polygon is the one in fractions, each vertex the nearest float, but for those that round
/// to one place; either may begin anywhere.
inline bool is_nearest_polygon(std::span<const glm::vec2> clipped, const Points& points,
                               const Rectangle<double>& window) {
  PointsOf<float> rounded;
  for (const ExactPoint& p : window_polygons::exact_part(points, window, all_borders(window))) {
    rounded.emplace_back(nearest_float(p.x), nearest_float(p.y));
  }
  const PointsOf<float> right = without_repeats(rounded);
  PointsOf<float> found = without_repeats({clipped.begin(), clipped.end()});
  if (clipped.empty()) return right.size() < 3;
  if (found.size() != right.size()) return false;
  for (std::size_t turns = 0; turns <= found.size(); ++turns) {
    if (found == right) return true;
    std::rotate(found.begin(), found.begin() + 1, found.end());
  }
  return false;
}

/// The same for floats, and the first polygon beside the one in fractions.
inline double float_batch_error(const Input& given) {
  const Input i = rounded_to_floats(given);
  const double error = batch_error<float>(i);
  if (error != 0 || !rectangle_is_taken(i)) return error;
  Polygons<float> clipped;
  BatchClipper<float>{}(batch_of<float>(i), window_of<float>(i), clipped);
  return is_nearest_polygon(clipped[0], points_in(i, 4, corners), rectangle_of(i)) ? 0 : wrong;
}

/// A share of what becomes of batches.
template <class T>
Share batch_share(const char* of, double least, std::size_t BatchCount::* part) {
  return {of, least, [part](const Input& i) {
            if (!rectangle_is_taken(i)) return false;
            Polygons<T> clipped;
            return BatchClipper<T>{}(batch_of<T>(i), window_of<T>(i), clipped).*part > 0;
          }};
}

}  // namespace gradus::stress::polygon_batches
