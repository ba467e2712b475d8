#pragma once
// A rim of paper below lines over the tones of a picture, so that they are seen on dark pixels, too.

#include "stories/rings.hpp"
#include "stories/telling.hpp"

namespace gradus {

/// Stands behind all steps, as lines that are added after it do. Each way from one point to another.
inline void add_casing(Narrator& narrator, const std::vector<std::pair<dvec2, dvec2>>& ways) {
  constexpr double half = 0.05;  // of a cell
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto [a, b] = ways[i];
    if (a == b) continue;
    const dvec2 along = half * glm::normalize(b - a), across{-along.y, along.x};
    const Ring2 rim{a - along - across, b + along - across, b + along + across, a - along + across};
    narrator.backdrop(fmt::format("casing {:02}", i), Role::guide, Area{{rim}});
  }
}

}  // namespace gradus
