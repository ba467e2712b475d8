#pragma once
// Exhibits: two ways of lecture notes to mix the fragments of a pixel, and the source's estimate of which
// surface is in front, kept so that a figure can show where they go wrong. Never use them to draw;
// a_buffer.hpp has the right one.

#include "antialiasing/a_buffer/a_buffer.hpp"

namespace gradus::a_buffer {

/// A fragment's area was added.
struct Summed {
  std::size_t number;
  Fragment fragment;
  double area, total;
};
/// The sum of colours is divided by that of areas.
struct Divided {
  std::size_t fragments;
  double total;
};

/// The fragments' weights, each by the total; nothing where that is 0.
constexpr double shares_of(std::span<const Fragment> list, std::span<const double> weights, double total,
                           const auto& take) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0) take(list[i], weights[i] / total);
  }
  return total > 0 ? 1 : 0;
}

/// FAULTY: the areas of all fragments count, whether anything hides them or not (errata E001-57). Opaque red
/// in front of opaque blue, each over the whole pixel, has a total area of 2 and comes out (.5, 0, .5). That
/// they are sorted changes nothing.
///
/// list, take: as for resolve.
///
/// Domain: as resolve.
/// Steps: Sorted Summed* Divided.
/// Accuracy: right where no two fragments overlap and all together fill the pixel.
/// Cost: sorting, a popcount a fragment; a list of weights.
/// Errors: none.
template <std::invocable<const Fragment&, double> Take, Observer<Sorted, Summed, Divided> O = Unobserved>
constexpr double sum_of_areas(std::vector<Fragment>& list, Take&& take, O&& observer = {}) {
  std::ranges::sort(list, nearer);
  if constexpr (observed<O>) observer(Sorted{list});
  double total = 0;
  std::vector<double> areas;
  for (const Fragment& f : list) {
    // Hidden or not, it counts
    const double area = area_of(f.mask);
    areas.push_back(area);
    total += area;
    if constexpr (observed<O>) observer(Summed{areas.size() - 1, f, area, total});
  }
  if constexpr (observed<O>) observer(Divided{list.size(), total});
  return shares_of(list, areas, total, take);
}

/// FAULTY: what is seen is divided by the area that is covered (errata E001-58), so that the background gets
/// nothing: one red fragment of area .25 over black comes out as full red, and silhouettes are as jagged as
/// without antialiasing.
///
/// list, take: as for resolve; opacities count as 1.
///
/// Domain: as resolve.
/// Steps: Sorted (Masked Summed)* Divided.
/// Accuracy: right where the fragments fill the pixel.
/// Cost: as resolve; a list of weights.
/// Errors: none.
template <std::invocable<const Fragment&, double> Take,
          Observer<Sorted, Masked, Summed, Divided> O = Unobserved>
constexpr double divided_by_covered(std::vector<Fragment>& list, Take&& take, O&& observer = {}) {
  std::ranges::sort(list, nearer);
  if constexpr (observed<O>) observer(Sorted{list});
  Mask covered = 0;
  std::vector<double> areas;
  for (const Fragment& f : list) {
    // What nothing nearer hides
    const Mask visible = f.mask & ~covered;
    if constexpr (observed<O>) observer(Masked{areas.size(), f, covered, visible});
    areas.push_back(area_of(visible));
    covered |= visible;
    if constexpr (observed<O>) observer(Summed{areas.size() - 1, f, areas.back(), area_of(covered)});
  }
  // The covered part counts as the whole
  const double total = area_of(covered);
  if constexpr (observed<O>) observer(Divided{list.size(), total});
  return shares_of(list, areas, total, take);
}

// --- The source's estimate ---------------------------------------

/// Where two surfaces are taken to pass through each other, and the share of the front one there.
struct Crossing {
  Mask mask = 0;
  double front = 1;
};

/// Carpenter's estimate: of two fragments whose depths overlap neither is taken to hide the other. The one
/// that begins in front is seen to the share (back's z_far - front's z_near) / (sum of both extents), which
/// is above 0 and below 1. Of several behind the first counts.
constexpr Crossing crossing(std::span<const Fragment> sorted, std::size_t number) {
  const Fragment& front = sorted[number];
  for (const Fragment& back : sorted.subspan(number + 1)) {
    if (back.z_near >= front.z_far) break;
    if (back.surface == front.surface || (back.mask & front.mask) == 0) continue;
    const double extents = (front.z_far - front.z_near) + (back.z_far - back.z_near);
    return {back.mask & front.mask, (back.z_far - front.z_near) / extents};
  }
  return {};
}

/// What a fragment takes of the light where another is taken to pass through it, and elsewhere.
constexpr double taken(Light& light, const Fragment& f, Mask visible, const Crossing& crossed) {
  return light.take(visible & ~crossed.mask, f.opacity) +
         light.take(visible & crossed.mask, f.opacity * crossed.front);
}

/// A fragment has got its share, by the estimate where depths overlap.
struct Estimated {
  std::size_t number;
  Fragment fragment;
  Mask visible;
  Crossing crossed;  ///< what is taken to pass through it
  double weight;
  Mask covered;
  double left;  ///< for what is behind
};

/// FAULTY: knows of each fragment how near and how far it reaches, and takes two whose depths overlap for
/// surfaces that cross. Right for planes with opposite slopes along one direction; a wall that is slanted
/// like the poster before it overlaps it in depth without meeting it, and shines through. Carpenter 1984, p.
/// 106, whose fragments keep no planes.
///
/// list, take: as for resolve.
///
/// Domain: as resolve.
/// Steps: Sorted Merged (Masked Estimated)* Finished.
/// Accuracy: right where no depths overlap.
/// Cost: as resolve without comparisons.
/// Errors: none.
template <std::invocable<const Fragment&, double> Take,
          Observer<Sorted, Merged, Masked, Estimated, Finished> O = Unobserved>
constexpr double by_ranges(std::vector<Fragment>& list, Take&& take, O&& observer = {}) {
  std::ranges::sort(list, nearer);
  if constexpr (observed<O>) observer(Sorted{list});
  merge(list);
  if constexpr (observed<O>) observer(Merged{list});
  Light light;
  std::size_t used = 0;
  for (const Fragment& f : list) {
    const Mask covered = light.covered();
    const Mask visible = f.mask & ~covered;
    if constexpr (observed<O>) observer(Masked{used, f, covered, visible});
    // Overlapping depths count as a crossing
    const auto c = crossing(list, used);
    auto w = taken(light, f, visible, c);
    if constexpr (observed<O>) observer(Estimated{used, f, visible, c, w, light.covered(), light.left()});
    if (w > 0) take(f, w);
    used += 1;
    if (light.covered() == full) break;
  }
  const double left = light.left();
  if constexpr (observed<O>) observer(Finished{used, list.size(), left});
  return 1 - left;
}

}  // namespace gradus::a_buffer
