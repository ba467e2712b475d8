#pragma once
// Adaptive antialiasing: coverage and depth at every sample, colour once per fragment and pixel, and all
// samples only where they can differ: in pixels that an edge crosses or in which the nearest surface changes.
//
// Sample places (sample_places.hpp) count from the upper left corner of a pixel in 1/256 pixel, as snapped
// corners do; coverage is decided by exact integers.

#include <algorithm>
#include <cmath>
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

/// Samples a pixel, at most.
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
  bool refined;     ///< whether it takes a colour a sample
};
/// Everything was plotted.
struct Finished {
  std::int64_t pixels, crossed;  ///< of the window; those that took all samples
  std::int64_t samples;          ///< tests of a triangle at a sample
  std::int64_t colours;          ///< colours asked for
};

/// Finds the pixels that take all samples. Of every other pixel it finds the one triangle that all its
/// samples show.
/// Steps: (Classified Compared?)*. Accuracy: exact. Cost: three edge functions a pixel of each box.
template <Observer<Classified, Compared> O = Unobserved>
void mark_crossed(Survey& survey, O&& observer = {}) {
  using enum Cover;
  using enum Order;
  int i = -1;
  for (const auto& t : survey.triangles()) {
    ++i;
    for (const ivec2 p : PixelsOf(t.box)) {
      auto& pixel = survey[p];
      // Does an edge run through it?
      const auto cover = cover_of(t.edges, p);
      if constexpr (observed<O>) observer(Classified{i, p, cover});
      if (cover == outside)  // not touched
        continue;
      pixel.crossed |= cover == crossed;
      if (pixel.crossed) continue;
      // Covered whole: who is nearer?
      const int old = pixel.front;
      auto order = survey.order(i, old, p);
      if constexpr (observed<O>) observer(Compared{i, p, old, order});
      if (order == nearer) pixel.front = i;
      pixel.crossed = order == changing;
    }
  }
}

// --- The samples -------------------------------------------------

/// Tests every triangle at the samples of the pixels that have some.
/// Steps: Sampled*. Accuracy: coverage exact, depths as of triangle_coverage::Depth; the least
/// (depth, triangle) is kept. Cost: three edge functions a sample of each box. Returns the tests.
template <Observer<Sampled> O = Unobserved>
std::int64_t take_samples(Survey& survey, O&& observer = {}) {
  std::int64_t tests = 0;
  int i = -1;
  for (const auto& t : survey.triangles()) {
    ++i;
    for (const ivec2 p : PixelsOf(t.box)) {
      int s = -1;
      for (auto& sample : survey.samples(p)) {
        ++s;
        ++tests;
        // Is it in the triangle?
        auto w = survey.weights(i, p, s);
        const bool in = holds(t.edges, w);
        // Nearer than what is there?
        auto at = survey.place(p, s);
        const auto z = t.depth.at(at, w);
        const int old = sample.triangle;
        bool nearer = in && z < sample.depth;
        if constexpr (observed<O>) observer(Sampled{i, p, s, in, z, old, nearer});
        if (nearer) sample = {z, i};
      }
    }
  }
  return tests;
}

// --- The colours -------------------------------------------------

/// A triangle and how many samples of a pixel show it.
struct Fragment {
  int triangle, samples;
};

/// The fragments of a pixel that are seen, by triangle.
inline std::vector<Fragment> fragments_of(const Survey& survey, ivec2 p) {
  const auto& [front, crossed, first] = survey[p];
  if (!crossed && front == nobody) return {};
  if (!crossed) return {{front, survey.samples()}};
  std::vector<Fragment> all;
  for (const Sample& sample : survey.samples(p)) {
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
/// Steps: Coloured*. Cost: a colour a fragment.
template <class Colour, Observer<Coloured> O = Unobserved>
Light<Value<Colour>> mix(const Survey& survey, ivec2 p, std::span<const Fragment> fragments, Colour& colour,
                         O&& observer = {}) {
  Light<Value<Colour>> light;
  const int n = survey.samples();
  int covered = 0;
  for (const auto& [i, samples] : fragments) {
    // Once, where the triangle covers it
    const ivec2 at =  // in the centre?
        survey.colour_place(i, p);
    auto w = survey.weights_at(i, p, at);
    const auto c = colour(i, p, w);
    // By the samples that show it
    const double share = double(samples) / n;
    covered += samples;
    light.sum = light.sum + share * c;
    if constexpr (observed<O>) observer(Coloured{i, p, at, samples, share});
  }
  light.share = double(covered) / n;
  return light;
}

/// Mixes a pixel of its samples, each with a colour of its own.
/// Steps: Coloured*. Cost: a colour a covered sample.
template <class Colour, Observer<Coloured> O = Unobserved>
Light<Value<Colour>> mix_each(const Survey& survey, ivec2 p, Colour& colour, O&& observer = {}) {
  Light<Value<Colour>> light;
  const int n = survey.samples();
  int covered = 0;
  for (int s = 0; s < n; ++s) {
    // Whose is the sample?
    const int i = survey.shown(p, s);
    if (i == nobody) continue;
    // Its own colour
    const auto w = survey.weights(i, p, s);
    const auto c = colour(i, p, w);
    const double share = 1.0 / n;
    ++covered;
    light.sum = light.sum + share * c;
    if constexpr (observed<O>) observer(Coloured{i, p, survey.place(s), 1, share});
  }
  light.share = double(covered) / n;
  return light;
}
/// How many samples it was mixed of.
template <class V>
std::int64_t samples_of(const Light<V>& light, const Survey& survey) {
  return std::llround(light.share * survey.samples());
}

// --- The methods -------------------------------------------------

/// What all methods ask for.
inline void check(const Window& window, std::span<const ivec2> samples) {
  expects(triangle_coverage::near_enough(window), "the window reaches more than {} pixels out",
          triangle_coverage::farthest);
  expects(!samples.empty() && samples.size() <= most_samples, "a pixel takes 1 to {} samples, not {}",
          most_samples, samples.size());
  for (const ivec2 place : samples)
    expects(0 <= std::min(place.x, place.y) && std::max(place.x, place.y) < subpixels,
            "the sample at ({}, {}) lies outside its pixel of 256 x 256 places", place.x, place.y);
}

/// Mixes and plots every pixel, row by row. Returns the colours that were asked for.
template <class Colour, class Plot, Observer<Coloured> O = Unobserved>
std::int64_t plot_fragments(const Survey& survey, Colour& colour, Plot& plot, O&& observer = {}) {
  std::int64_t colours = 0;
  for (const ivec2 p : PixelsOf(survey.window())) {
    const auto seen = fragments_of(survey, p);
    if (seen.empty()) continue;
    const auto [sum, share] = mix(survey, p, seen, colour, observer);
    colours += std::ssize(seen);
    plot(p, sum, share);
  }
  return colours;
}

/// Draws triangles with all samples in pixels that edges cross, and in which the nearest surface changes;
/// one look is enough for every other pixel. Colour is asked for once per fragment and pixel.
/// Source: T. Whitted, An improved illumination model for shaded display, CACM 23(6), 1980, 343-349 (samples
/// where they are needed); K. Akeley, RealityEngine graphics, SIGGRAPH 1993, 109-116 (coverage and depth a
/// sample, colour a fragment).
///
/// triangles: snapped corners in either direction, with their depths; smaller is nearer, and of equals the
///   one that comes first is seen. window: the pixels that are asked for. samples: places in the pixel, in
///   1/256 pixel. colour(triangle, pixel, weights): asked once per fragment that is seen, in the pixel's
///   centre if the triangle covers it, else at the covered sample nearest to it; what it returns can be added
///   and multiplied by a double. plot(pixel, sum, share): the sum of share times colour, and the share of the
///   pixel that is covered; called for pixels that show something, row by row.
///
/// Domain: corners and window at most `farthest` pixels out, finite depths, 1 to 1024 samples in the pixel.
///   Triangles without area are not seen.
/// Steps: (Classified Compared?)* Sampled* Coloured* Finished.
/// Accuracy: the same bits as each_sample.
/// Cost: three edge functions a pixel of each box and a sample of a crossed one, a colour a fragment; memory
///   of 16 bytes a pixel and a sample.
/// Errors: ContractViolation outside the domain.
template <class Colour, class Plot,
          Observer<Classified, Compared, Sampled, Coloured, Finished> O = Unobserved>
void adaptive(std::span<const ScreenTriangle> triangles, const Window& window, std::span<const ivec2> samples,
              Colour&& colour, Plot&& plot, O&& observer = {}) {
  check(window, samples);
  const auto all = prepare(triangles, window);
  Survey survey(all, window, samples);
  // Where can samples differ?
  mark_crossed(survey, observer);
  // Only there take them all
  survey.make_samples();
  const auto tests =  // of the crossed
      take_samples(survey, observer);
  // A colour a fragment that is seen
  const auto colours =  // centre or sample
      plot_fragments(survey, colour, plot, observer);
  if constexpr (observed<O>) observer(Finished{survey.pixels(), survey.crossed(), tests, colours});
}

/// The textbook's way: all samples in every pixel.
/// Steps: Sampled* Coloured* Finished. The rest is as for adaptive; memory of 16 bytes a sample.
template <class Colour, class Plot, Observer<Sampled, Coloured, Finished> O = Unobserved>
void each_sample(std::span<const ScreenTriangle> triangles, const Window& window,
                 std::span<const ivec2> samples, Colour&& colour, Plot&& plot, O&& observer = {}) {
  check(window, samples);
  const auto all = prepare(triangles, window);
  Survey survey(all, window, samples);
  // Everywhere
  survey.cross_all();
  survey.make_samples();
  const auto tests =  // of all pixels
      take_samples(survey, observer);
  // A colour a fragment that is seen
  const auto colours =  // centre or sample
      plot_fragments(survey, colour, plot, observer);
  if constexpr (observed<O>) observer(Finished{survey.pixels(), survey.crossed(), tests, colours});
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
  auto plot() {
    return [this](ivec2 p, const V& sum, double share) { (*this)[p] = {sum, share}; };
  }

  /// The greatest contrast of a pixel to those left, right, above and below of it.
  template <class Contrast>
  double contrast_at(ivec2 p, Contrast& contrast) {
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

/// As adaptive; pixels that differ from a neighbour by more than a threshold take a colour at every sample
/// as well, so that what lies within a surface, textures and highlights, is antialiased too.
/// Source: D. P. Mitchell, Generating antialiased images at low sampling densities, SIGGRAPH 1987, 65-72.
///
/// contrast(const Light&, const Light&): how much two pixels differ. threshold: contrasts above it are
///   refined. The rest is as for adaptive.
///
/// Steps: (Classified Compared?)* Sampled* Coloured* (Contrasted Coloured*)* Finished.
/// Accuracy: the bits of adaptive where no contrast is above the threshold, those of a colour a sample where
///   one is; contrasts are those of adaptive's picture.
/// Cost: that of adaptive, and a colour a sample of a refined pixel.
/// Errors: ContractViolation outside the domain.
template <class Contrast, class Colour, class Plot,
          Observer<Classified, Compared, Sampled, Coloured, Contrasted, Finished> O = Unobserved>
void adaptive_contrast(std::span<const ScreenTriangle> triangles, const Window& window,
                       std::span<const ivec2> samples, Contrast&& contrast, double threshold, Colour&& colour,
                       Plot&& plot, O&& observer = {}) {
  check(window, samples);
  const auto all = prepare(triangles, window);
  Survey survey(all, window, samples);
  mark_crossed(survey, observer);
  survey.make_samples();
  const auto tests =  // of the crossed
      take_samples(survey, observer);
  // The picture of adaptive
  Picture<Value<Colour>> first(window);
  auto keep = first.plot();
  auto colours =  // one a fragment
      plot_fragments(survey, colour, keep, observer);
  for (const ivec2 p : PixelsOf(window)) {
    auto light = first[p];
    // Unlike one of its neighbours?
    const double most =  // of four
        first.contrast_at(p, contrast);
    bool refined = most > threshold;
    if constexpr (observed<O>) observer(Contrasted{p, most, refined});
    // Then a colour a sample
    if (refined && light.share > 0) {
      light = mix_each(survey, p, colour, observer);
      colours += samples_of(light, survey);
    }
    const auto [sum, share] = light;
    if (share > 0) plot(p, sum, share);
  }
  if constexpr (observed<O>) observer(Finished{survey.pixels(), survey.crossed(), tests, colours});
}

}  // namespace gradus::adaptive
