#pragma once
// Adaptive antialiasing: coverage and depth at every sample, colour once per fragment and pixel, and all
// samples only where they can differ: in pixels that an edge crosses or in which the nearest surface changes.
//
// Sample places (sample_places.hpp) count from the upper left corner of a pixel in 1/256 pixel, as snapped
// corners do; coverage is decided by exact integers.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "antialiasing/adaptive/pixel_survey.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/raster.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::adaptive {

/// Samples per pixel, at most.
inline constexpr int most_samples = 1024;

// --- Steps -------------------------------------------------------

/// A pixel of a triangle's box was held against the three edges.
struct Classified {
  int triangle;
  ivec2 pixel;
  Cover cover;
};
/// A triangle that covers the pixel whole was compared with the nearest one before it.
struct Compared {
  int triangle;
  ivec2 pixel;
  int before;  ///< `nobody` when it is the first
  Order order;
};
/// A triangle was tested at a sample.
struct Sampled {
  int triangle;
  ivec2 pixel;
  int sample;
  bool covered;
  double depth;  ///< of the triangle, where it covers the sample
  int before;    ///< whose the sample was
  bool nearer;   ///< whether it is the triangle's now
};
/// A fragment has its colour.
struct Coloured {
  int triangle;
  ivec2 pixel;
  ivec2 place;  ///< where the colour was computed, in 1/256 pixel
  int samples;  ///< how many show it
  double share;
};
/// A pixel was held against its neighbours.
struct Contrasted {
  ivec2 pixel;
  double contrast;  ///< the greatest to a neighbour
  bool refined;     ///< whether it takes a colour per sample
};
/// Everything was plotted.
struct Finished {
  std::int64_t pixels, crossed;  ///< of the window; those that took all samples
  std::int64_t samples;          ///< tests of a triangle at a sample
  std::int64_t colours;          ///< colours asked for
};

/// How a triangle that covers a pixel whole lies to the nearest one before it, which stays where both are as
/// deep.
inline Order order_of(const Survey& all, const Prepared& t, ivec2 p) {
  using enum Order;
  const int old = all[p].front;
  if (old == nobody) return nearer;
  auto& front = all.triangle(old);
  int before = 0;
  for (ivec2 s : all.places()) {
    const auto at = place_in(p, s);
    before += t.z(at) < front.z(at);
  }
  if (before == 0) return behind;
  // At some samples: they pierce
  const int n = all.samples();
  if (before < n) return changing;
  return nearer;
}

/// Finds the pixels that take all samples. Of every other pixel it finds the one triangle that all its
/// samples show.
/// Steps: (Classified Compared?)*. Accuracy: exact. Cost: three edge functions per pixel of each box.
template <Observer<Classified, Compared> O = Unobserved>
void mark_crossed(Survey& all, O&& observer = {}) {
  using enum Cover;
  using enum Order;
  for (auto& t : all.triangles()) {
    for (ivec2 p : pixels(t)) {
      auto& pixel = all[p];
      // Does an edge cross it?
      const auto c = cover_of(t, p);
      if constexpr (observed<O>) observer(Classified{t.id, p, c});
      if (c == outside) continue;
      if (c == crossed) {
        pixel.crossed = true;
      }
      if (pixel.crossed) continue;
      // Covered whole: who is seen?
      auto o = order_of(all, t, p);
      if constexpr (observed<O>) observer(Compared{t.id, p, pixel.front, o});
      if (o == nearer) {
        pixel.front = t.id;
      }
      pixel.crossed = o == changing;
    }
  }
}

// --- The samples -------------------------------------------------

/// Tests every triangle at the samples of the pixels that have some.
/// Steps: Sampled*. Accuracy: coverage exact, depths as of triangle_coverage::Depth; the least
/// (depth, triangle) is kept. Cost: three edge functions per sample of each box.
template <Observer<Sampled> O = Unobserved>
void take_samples(Survey& all, O&& observer = {}) {
  for (auto& t : all.triangles()) {
    for (ivec2 p : pixels(t)) {
      for (Sample& s : all.at(p)) {
        // Is it in the triangle?
        auto at = all.place(p, s);
        auto w = weights(t, at);
        const bool in = holds(t, w);
        // Nearer than before?
        const auto z = t.z(at, w);
        bool nearer = in && z < s.z;
        if constexpr (observed<O>) observer(Sampled{t.id, p, all.number(p, s), in, z, s.triangle, nearer});
        if (nearer) s = {z, t.id};
      }
    }
  }
}

// --- The colours -------------------------------------------------

/// A triangle and how many samples of a pixel show it.
struct Fragment {
  int triangle, samples;
};

/// The fragments of a pixel that are seen, by triangle.
inline std::vector<Fragment> fragments_of(const Survey& survey, ivec2 p) {
  const Pixel& pixel = survey[p];
  if (!pixel.crossed && pixel.front == nobody) return {};
  if (!pixel.crossed) return {{pixel.front, survey.samples()}};
  std::vector<Fragment> all;
  for (const Sample& sample : survey.at(p)) {
    if (sample.triangle == nobody) continue;
    const auto at = std::ranges::lower_bound(all, sample.triangle, {}, &Fragment::triangle);
    if (at != all.end() && at->triangle == sample.triangle)
      ++at->samples;
    else
      all.insert(at, {sample.triangle, 1});
  }
  return all;
}

/// What a colour callable returns.
template <class Colour>
using Value = std::remove_cvref_t<std::invoke_result_t<Colour&, int, ivec2, const Weights&>>;

/// The light of a pixel: the sum of share times colour, and the share that is covered.
template <class V>
struct Light {
  V sum{};
  double share = 0;
};

/// Mixes a pixel of its fragments, each with one colour.
/// Steps: Coloured*. Cost: a colour per fragment.
template <class Colour, Observer<Coloured> O = Unobserved>
Light<Value<Colour>> mix(const Survey& all, ivec2 p, std::span<const Fragment> seen, Colour& colour,
                         O&& observer = {}) {
  Value<Colour> sum{};
  int covered = 0;
  const double N = all.samples();
  for (const auto& [i, n] : seen) {
    // Once, where it is covered
    auto at = all.colour_at(i, p);
    auto w = all.weights(i, p, at);
    const auto c = colour(i, p, w);
    // By the samples that show it
    const double share = n / N;
    sum = sum + share * c;
    if constexpr (observed<O>) observer(Coloured{i, p, at, n, share});
    covered += n;
  }
  return {sum, covered / N};
}

/// Mixes a pixel of its samples, each with a colour of its own.
/// Steps: Coloured*. Cost: a colour per covered sample.
template <class Colour, Observer<Coloured> O = Unobserved>
Light<Value<Colour>> blend(const Survey& all, ivec2 p, Colour& colour, O&& observer = {}) {
  Value<Colour> sum{};
  int covered = 0;
  const int N = all.samples();
  const double share = 1.0 / N;
  for (int s = 0; s < N; ++s) {
    // Whose is the sample?
    const int i = all.shown(p, s);
    if (i == nobody) continue;
    // Its own colour
    const auto at = all.place(s);
    auto w = all.weights(i, p, at);
    const auto c = colour(i, p, w);
    sum = sum + share * c;
    if constexpr (observed<O>) observer(Coloured{i, p, at, 1, share});
    ++covered;
  }
  return {sum, double(covered) / N};
}

/// How many colours are asked for: one per visible fragment, in refined pixels one per covered sample.
inline std::int64_t colours_of(const Survey& survey) {
  std::int64_t all = 0;
  for (const ivec2 p : pixels(survey.window())) {
    const auto seen = fragments_of(survey, p);
    all += std::ssize(seen);
    if (!survey[p].refined) continue;
    for (const Fragment& fragment : seen) all += fragment.samples;
  }
  return all;
}

// --- The methods -------------------------------------------------

/// What all methods ask for.
inline void expect_drawable(const Window& window, std::span<const ivec2> samples) {
  expects(triangle_coverage::near_enough(window), "the window reaches more than {} pixels out",
          triangle_coverage::farthest);
  expects(!samples.empty() && samples.size() <= most_samples, "a pixel takes 1 to {} samples, not {}",
          most_samples, samples.size());
  for (const ivec2 place : samples)
    expects(0 <= std::min(place.x, place.y) && std::max(place.x, place.y) < subpixels,
            "the sample at ({}, {}) lies outside its pixel of 256 x 256 places", place.x, place.y);
}

/// Mixes and plots every pixel, row by row.
template <class Colour, class Plot, Observer<Coloured> O = Unobserved>
void plot_fragments(const Survey& all, Colour& colour, Plot& plot, O&& observer = {}) {
  for (const ivec2 p : pixels(all.window())) {
    const auto seen = fragments_of(all, p);
    if (seen.empty()) continue;
    const auto [sum, share] = mix(all, p, seen, colour, observer);
    plot(p, sum, share);
  }
}

/// Draws triangles with all samples in pixels that edges cross, and in which the nearest surface changes;
/// one look is enough for every other pixel. Colour is asked for once per fragment and pixel.
/// Source: T. Whitted, An improved illumination model for shaded display, CACM 23(6), 1980, 343-349 (samples
/// where they are needed); K. Akeley, RealityEngine graphics, SIGGRAPH 1993, 109-116 (coverage and depth per
/// sample, colour per fragment).
///
/// scene: snapped corners in either direction, with their depths; smaller is nearer, and of equals the
///   one that comes first is seen. window: the pixels that are asked for. places: of the samples in a pixel,
///   in 1/256 pixel. colour(triangle, pixel, weights): asked once per fragment that is seen, in the pixel's
///   centre if the triangle covers it, else at the covered sample nearest to it; what it returns can be added
///   and multiplied by a double. plot(pixel, sum, share): the sum of share times colour, and the share of the
///   pixel that is covered; called for pixels that show something, row by row.
///
/// Domain: corners and window at most `farthest` pixels out, finite depths, 1 to 1024 samples in the pixel.
///   Triangles without area are not seen.
/// Steps: (Classified Compared?)* Sampled* Coloured* Finished.
/// Accuracy: the same bits as each_sample.
/// Cost: three edge functions per pixel of each box and per sample of a crossed one, a colour per fragment;
///   memory of 16 bytes per pixel and sample.
/// Errors: ContractViolation outside the domain.
template <class Colour, class Plot,
          Observer<Classified, Compared, Sampled, Coloured, Finished> O = Unobserved>
void adaptive(std::span<const ScreenTriangle> scene, const Window& window, std::span<const ivec2> places,
              Colour&& colour, Plot&& plot, O&& observer = {}) {
  expect_drawable(window, places);
  Survey all(scene, window, places);
  // Where can samples differ?
  mark_crossed(all, observer);
  // Only there take them all
  all.make_samples();
  take_samples(all, observer);
  // A colour per fragment seen
  plot_fragments(all, colour, plot, observer);
  if constexpr (observed<O>) observer(Finished{all.pixels(), all.crossed(), all.tests(), colours_of(all)});
}

/// The textbook's way: all samples in every pixel.
/// Steps: Sampled* Coloured* Finished. The rest is as for adaptive; memory of 16 bytes per sample.
template <class Colour, class Plot, Observer<Sampled, Coloured, Finished> O = Unobserved>
void each_sample(std::span<const ScreenTriangle> scene, const Window& window, std::span<const ivec2> places,
                 Colour&& colour, Plot&& plot, O&& observer = {}) {
  expect_drawable(window, places);
  Survey all(scene, window, places);
  // Everywhere
  all.cross_all();
  all.make_samples();
  take_samples(all, observer);
  // A colour per fragment seen
  plot_fragments(all, colour, plot, observer);
  if constexpr (observed<O>) observer(Finished{all.pixels(), all.crossed(), all.tests(), colours_of(all)});
}

/// The pixels of a window before they are plotted.
template <class V>
class Picture {
 public:
  explicit Picture(const Window& window)
      : window_(window),
        cells_(static_cast<int>(std::max<std::int64_t>(0, window.width())),
               static_cast<int>(std::max<std::int64_t>(0, window.height()))) {}
  Light<V>& operator[](ivec2 p) { return cells_[p - window_.lower]; }

  /// The greatest contrast of a pixel to those left, right, above and below of it.
  template <class Contrast>
  double max(ivec2 p, Contrast& contrast) {
    double greatest = 0;
    for (const ivec2 way : {ivec2{-1, 0}, ivec2{1, 0}, ivec2{0, -1}, ivec2{0, 1}}) {
      if (!window_.contains(p + way)) continue;
      greatest = std::max<double>(greatest, contrast((*this)[p], (*this)[p + way]));
    }
    return greatest;
  }

 private:
  Window window_;
  Raster<Light<V>> cells_;
};

/// The picture of adaptive, kept.
/// Steps: Coloured*.
template <class Colour, Observer<Coloured> O = Unobserved>
Picture<Value<Colour>> picture(const Survey& all, Colour& colour, O&& observer = {}) {
  Picture<Value<Colour>> kept(all.window());
  const auto keep = [&](ivec2 p, const auto& sum, double share) { kept[p] = {sum, share}; };
  plot_fragments(all, colour, keep, observer);
  return kept;
}

/// As adaptive; pixels that differ from a neighbour by more than a threshold take a colour at every sample
/// as well, so that what lies within a surface, textures and highlights, is antialiased too.
/// Source: D. P. Mitchell, Generating antialiased images at low sampling densities, SIGGRAPH 1987, 65-72.
///
/// contrast(const Light&, const Light&): how much two pixels differ. threshold: contrasts above it are
///   refined. The rest is as for adaptive.
///
/// Steps: (Classified Compared?)* Sampled* Coloured* (Contrasted Coloured*)* Finished.
/// Accuracy: the bits of adaptive where no contrast is above the threshold, those of a colour per sample
///   where one is; contrasts are those of adaptive's picture.
/// Cost: that of adaptive, and a colour per sample of a refined pixel.
/// Errors: ContractViolation outside the domain.
template <class Contrast, class Colour, class Plot,
          Observer<Classified, Compared, Sampled, Coloured, Contrasted, Finished> O = Unobserved>
void adaptive_contrast(std::span<const ScreenTriangle> scene, const Window& window,
                       std::span<const ivec2> places, Contrast&& contrast, double threshold, Colour&& colour,
                       Plot&& plot, O&& observer = {}) {
  expect_drawable(window, places);
  Survey all(scene, window, places);
  mark_crossed(all, observer);
  all.make_samples();
  take_samples(all, observer);
  // As adaptive draws it
  auto first = picture(all, colour, observer);
  for (ivec2 p : pixels(window)) {
    auto light = first[p];
    // Unlike one of its neighbours?
    auto d = first.max(p, contrast);
    bool& refined = all[p].refined;
    refined = d > threshold;
    if constexpr (observed<O>) observer(Contrasted{p, d, refined});
    // Then a colour per sample
    if (refined) {
      light = blend(all, p, colour, observer);
    }
    auto& [sum, share] = light;
    if (share > 0) {
      plot(p, sum, share);
    }
  }
  if constexpr (observed<O>) observer(Finished{all.pixels(), all.crossed(), all.tests(), colours_of(all)});
}

}  // namespace gradus::adaptive
