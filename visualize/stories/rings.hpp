#pragma once
// What drawings of polygons do alike: their sides, middles and extents, outlines with their inside, arrows
// with their names, captions.

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "stories/paper.hpp"

namespace gradus {

using Ring = std::vector<dvec3>;
using Ring2 = std::vector<dvec2>;

/// The sides of a ring, each from a corner to the next one.
template <class Vec>
std::vector<std::pair<Vec, Vec>> sides_of(const std::vector<Vec>& ring) {
  std::vector<std::pair<Vec, Vec>> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) sides.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  return sides;
}

/// The mean of the corners.
template <class Vec>
Vec middle_of(const std::vector<Vec>& ring) {
  Vec middle{0};
  for (const Vec& p : ring) middle += p / static_cast<double>(ring.size());
  return middle;
}

/// What `at` makes of each of some things.
template <class Thing, class At>
auto mapped(const std::vector<Thing>& things, const At& at) {
  std::vector<std::decay_t<std::invoke_result_t<At, const Thing&>>> places;
  for (const Thing& thing : things) places.push_back(std::invoke(at, thing));
  return places;
}

/// The extent of all places.
template <class Places>
Extent extent_around(Places&& places) {
  Extent extent;
  for (const dvec2 p : places) extent.add(p);
  return extent;
}

/// A ring and the area in it.
inline void add_ring(View& view, const std::string& id, Role role, const Ring2& ring, int shade = 1) {
  view.add({id + " inside", role, Area{{ring}, shade}});
  view.add({id, role, Path{ring, true}});
}

/// An arrow with its name, at its tip if at no other place.
inline void add_arrow(View& view, const std::string& id, Role role, dvec2 from, dvec2 to,
                      const std::string& name, std::optional<dvec2> name_at = {}) {
  view.add({id, role, Stroke{from, to, true}});
  view.add({id + " name", role, Label{name_at.value_or(to), name}});
}

/// A caption in the middle above a part of the paper.
inline void add_caption(View& view, const std::string& id, const Extent& below, const std::string& text,
                        double above = 1.1, bool aside = false) {
  view.add({id, Role::guide, Text{{below.centre().x, below.upper.y + above}, text, Align::centre, aside}});
}

}  // namespace gradus
