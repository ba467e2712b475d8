#pragma once
// Exhibits: two ways of lecture notes to mix the fragments of a pixel, kept so that a figure can show where
// they go wrong. Never use them to draw; a_buffer.hpp has the right one.

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

}  // namespace gradus::a_buffer
