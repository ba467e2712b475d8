#pragma once
// What goes wrong where areas are added up and nothing is hidden: the weights of a pixel add up to more
// than 1. And where an area, which is a share of the light, is taken for a tone of the screen.

#include <span>

#include "antialiasing/area_sampling/area_sampling.hpp"
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

/// A pixel has got a tone.
struct ToneTaken {
  ivec2 pixel;
  double area;
  int tone;  ///< 0 to 255, as the screen is told
};

/// Faulty: 255 times the area as the tone of a white polygon on black. The scale of tones (sRGB) follows the
/// eye, not the light: half a pixel gets 128, which is 0.216 of the light, where 188 is half. So edges come
/// out too dark, and a slanted line looks like a rope.
///
/// corners, window: as of pixel_areas. plot(ivec2, int) is called with each pixel's tone.
///
/// Steps: ToneTaken*.
/// Accuracy: the tones are the nearest to 255 times the area; wrong for every area but 0 and 1.
template <class Plot, Observer<ToneTaken> O = Unobserved>
void area_as_tone(std::span<const ivec2> corners, const Window& window, Plot&& plot, O&& observer = {}) {
  const auto set = [&](ivec2 p, double area) {
    // A share of the light is no tone
    const int tone = byte_of(area);
    if constexpr (observed<O>) observer(ToneTaken{p, area, tone});
    plot(p, tone);
  };
  pixel_areas(corners, window, set);
}

}  // namespace gradus::area_sampling
