#pragma once
// What goes wrong where areas are added up and nothing is hidden: the weights of a pixel add up to more
// than 1.

#include <span>

#include "antialiasing/area_sampling/visible_areas.hpp"
#include "core/observe.hpp"

namespace gradus::area_sampling {

/// Faulty: the areas of all fragments in a pixel, whatever lies before them, as the listing of the notes has
/// it. With it the colour of a hidden fragment is added to that of what hides it.
///
/// fragments, seen: as of visible_areas.
///
/// Steps: (FragmentTaken Seen)* AreasFinished.
/// Accuracy: of the areas as of visible_areas; wrong where fragments overlap.
template <class T, class See, Observer<FragmentTaken<T>, Seen<T>, AreasFinished<T>> O = Unobserved>
void areas_without_visibility(std::span<Fragment<T>> fragments, See&& seen, O&& observer = {}) {
  sort_by_depth(fragments);
  T covered{0};
  for (const Fragment<T>& mine : fragments) {
    Pieces<T> whole{mine.outline};
    if constexpr (observed<O>) observer(FragmentTaken<T>{mine});
    // Nothing is subtracted
    const T area = area_of(mine.outline);
    if constexpr (observed<O>) observer(Seen<T>{mine.key, whole, area});
    seen(mine, whole, area);
    covered = covered + area;
  }
  if constexpr (observed<O>) observer(AreasFinished<T>{covered});
}

}  // namespace gradus::area_sampling
