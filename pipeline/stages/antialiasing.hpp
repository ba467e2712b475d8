#pragma once
// Antialiasing in the chain: stages 6 and 7 again, with the light of a pixel from more than its centre. What
// is averaged is linear light, before stage 8.

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "antialiasing/a_buffer/a_buffer_picture.hpp"
#include "antialiasing/adaptive/adaptive.hpp"
#include "antialiasing/area_sampling/visible_picture.hpp"
#include "antialiasing/jittered/jittered.hpp"
#include "antialiasing/poisson_disc/poisson_disc.hpp"
#include "core/colour.hpp"
#include "core/image.hpp"
#include "core/random.hpp"
#include "core/raster.hpp"
#include "core/refusal.hpp"
#include "scene/scene.hpp"
#include "stages/6_rasterization.hpp"
#include "stages/7_visibility_and_shading.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// The light of a pixel: of its objects the sum of share times colour, and the share that they cover.
struct PixelLight {
  dvec3 sum{0};
  double share = 0;
};
/// Of the pixels of a window, whose upper left one is cell (0, 0).
using LightPicture = Raster<PixelLight>;

/// The picture of a window, nothing in it yet.
inline LightPicture empty_picture(const Window& window) {
  return {static_cast<int>(window.width()), static_cast<int>(window.height())};
}

// --- What the methods are given ------------------------------------------------------------------

/// The triangles of stage 5 in the picture. One that stage 6 would not draw keeps its number, without area.
inline std::vector<triangle_coverage::ScreenTriangle> screen_triangles(const Triangles& triangles,
                                                                       Size size) {
  std::vector<triangle_coverage::ScreenTriangle> all;
  all.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const triangle_coverage::Triangle grid = on_grid(snapped(in_picture(t, size)));
    all.push_back(keeps_side(t, area_of(grid)) ? on_screen(grid, t) : triangle_coverage::ScreenTriangle{});
  }
  return all;
}

/// How a fragment gets its colour where it is not stage 7 itself that gives it.
using Colouring = std::function<LinearRgb(SceneLight&, const Fragment&, const Triangle&)>;

/// Stage 7's colour of a triangle, at the place of a pixel that has these weights.
class FragmentColour {
 public:
  /// colouring: another way to the colours of `shaded`, with their bits.
  FragmentColour(const Scene& scene, const Triangles& triangles, Size size, const Plan* plan = nullptr,
                 const LinearTextures* decoded = nullptr, Colouring colouring = {})
      : triangles_(triangles), light_(scene, size, plan, decoded), colouring_(std::move(colouring)) {}

  const ShadingCount& count() const { return light_.count(); }

  /// How much a triangle covers of what lies behind it.
  double opacity(int triangle) const {
    const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
    if (!draws_opacity(light_.scene())) return 1;
    return double{light_.material({t.id, triangle}).opacity};
  }

  dvec3 operator()(int triangle, ivec2 pixel, const triangle_coverage::Weights& at) {
    const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
    // A place on an edge may have been rounded to beyond it
    const triangle_coverage::Weights within{
        std::max<std::int64_t>(at[0], 0), std::max<std::int64_t>(at[1], 0), std::max<std::int64_t>(at[2], 0)};
    const Fragment f{t.id, triangle, pixel, 0, shares_of(within, over_w_of(t))};
    return dvec3(colouring_ ? colouring_(light_, f, t) : shaded(light_, f, t).colour);
  }

 private:
  const Triangles& triangles_;
  SceneLight light_;
  Colouring colouring_;
};

/// Who watches a picture being made.
struct PictureWatch {
  ShadingCount count{};                   ///< what shading did
  std::int64_t without_area = 0;          ///< triangles that stage 6 does not draw
  std::function<void(double)> reached{};  ///< told of the share that is done, from 0 to 1
};

/// Everything a method needs.
struct Shot {
  std::vector<triangle_coverage::ScreenTriangle> triangles;
  Window picture, window;  ///< all of it, and the part that is asked for
  FragmentColour colour;
  int samples;
  LinearRgb background;
  std::function<void(double)> reached;  ///< PictureWatch's

  /// So many of so many are done.
  void tell(std::int64_t done, std::int64_t all) const {
    if (reached) reached(static_cast<double>(done) / static_cast<double>(all));
  }
};

// --- Patterns ------------------------------------------------------------------------------------

/// Where pixels are sampled, in 1/256 pixel: a sheet of side x side patterns, which repeats.
struct Pattern {
  int side = 1, count = 1;
  std::vector<ivec2> places{{128, 128}};  ///< pixel by pixel

  ivec2 at(ivec2 pixel, int sample) const {
    const int which = pixel.y % side * side + pixel.x % side;
    return places[static_cast<std::size_t>(which * count + sample)];
  }
};

/// A place in the unit square on the grid of 1/256.
inline ivec2 on_sample_grid(dvec2 place) {
  return glm::min(ivec2(place * double{triangle_coverage::subpixels}),
                  ivec2(triangle_coverage::subpixels - 1));
}

/// The middles of side x side cells, row by row. Domain: samples is a square.
inline Pattern grid_pattern(int samples) {
  const int side = grid_side(samples);
  Pattern pattern{1, samples, {}};
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      pattern.places.push_back((2 * ivec2{i, j} + 1) * triangle_coverage::subpixels / (2 * side));
  return pattern;
}

/// A pattern of its own for each of side x side pixels: `draw` puts samples into a span, from the random
/// numbers of that pixel.
template <class Draw>
Pattern random_pattern(int side, int samples, const Draw& draw) {
  constexpr std::uint64_t seed = 1;
  Pattern pattern{side, samples, {}};
  std::vector<dvec2> places(static_cast<std::size_t>(samples));
  for (std::uint64_t pixel = 0; pixel < static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
       ++pixel) {
    draw(std::span<dvec2>(places), Random(seed).split(pixel));
    for (const dvec2 place : places) pattern.places.push_back(on_sample_grid(place));
  }
  return pattern;
}
/// One sample in each of so many cells, anywhere in it.
inline Pattern jittered_pattern(int samples) {
  return random_pattern(64, samples, [](auto places, Random random) { jittered::jittered(places, random); });
}
/// Samples that keep their distance, also from those of the pixels beside it. Patterns of many samples are
/// dear, and there are fewer of them.
inline Pattern poisson_disc_pattern(int samples) {
  return random_pattern(samples <= 16   ? 32
                        : samples <= 64 ? 8
                                        : 4,
                        samples, [](auto places, Random random) {
                          poisson_disc::best_candidate(places, places.size() <= 64 ? 4 : 1, random);
                        });
}

// --- Point samples -------------------------------------------------------------------------------

/// One sample of each pixel through the z-buffer: stage 6 at a place of the pixel's own.
inline Raster<z_buffer::Cell<double, int>> pass_of(const std::vector<adaptive::Prepared>& triangles,
                                                   const Window& window, const Pattern& pattern, int sample) {
  Raster<z_buffer::Cell<double, int>> kept(static_cast<int>(window.width()),
                                           static_cast<int>(window.height()));
  int i = -1;
  for (const auto& t : triangles) {
    ++i;
    const auto [lower, upper] = t.box;
    for (int y = lower.y; y <= upper.y; ++y) {
      for (int x = lower.x; x <= upper.x; ++x) {
        const ivec2 p{x, y};
        const ivec2 place = adaptive::place_in(p, pattern.at(p, sample));
        const auto w = weights_at_place(t.edges, place);
        if (holds(t.edges, w)) z_buffer::keep_nearest(kept, p - window.lower, t.depth.at(place, w), i);
      }
    }
  }
  return kept;
}

/// The accumulation buffer: a picture per sample, one after the other, each added to the sum.
inline LightPicture passes(Shot& shot, const Pattern& pattern) {
  LightPicture sum = empty_picture(shot.window);
  Raster<int> covered(sum.width(), sum.height());
  const auto triangles = adaptive::prepare(shot.triangles, shot.window);
  const double share = 1.0 / pattern.count;
  for (int s = 0; s < pattern.count; ++s) {
    // 6 Rasterization at shifted places, 7 Hidden surface removal
    shot.tell(s, pattern.count);
    const auto kept = pass_of(triangles, shot.window, pattern, s);
    for (int y = 0; y < sum.height(); ++y) {
      for (int x = 0; x < sum.width(); ++x) {
        const ivec2 cell{x, y}, p = shot.window.lower + cell;
        if (!kept[cell].taken) continue;
        // 7 Shading, at the sample
        const auto& t = triangles[static_cast<std::size_t>(kept[cell].key)];
        const auto w = weights_at_place(t.edges, adaptive::place_in(p, pattern.at(p, s)));
        sum[cell].sum = sum[cell].sum + share * shot.colour(kept[cell].key, p, w);
        sum[cell].share = static_cast<double>(++covered[cell]) / pattern.count;
      }
    }
  }
  return sum;
}

/// Supersampling: all samples of a pixel side by side, as in a picture of so many times the size, and their
/// mean. In bands of rows, so that only one of them is that large at a time.
inline LightPicture side_by_side(Shot& shot, const Pattern& pattern) {
  constexpr int rows = 32;
  LightPicture picture = empty_picture(shot.window);
  const auto& [lower, upper] = shot.window;
  for (int top = lower.y; top <= upper.y; top += rows) {
    shot.tell(top - lower.y, picture.height());
    const Window band{{lower.x, top}, {upper.x, std::min(top + rows - 1, upper.y)}};
    adaptive::Survey survey(shot.triangles, band, pattern.places);
    survey.cross_all();
    survey.make_samples();
    adaptive::take_samples(survey);
    for (int y = band.lower.y; y <= band.upper.y; ++y) {
      for (int x = band.lower.x; x <= band.upper.x; ++x) {
        const auto [sum, share] = adaptive::blend(survey, {x, y}, shot.colour);
        picture[ivec2{x, y} - lower] = {sum, share};
      }
    }
  }
  return picture;
}

// --- Fragments -----------------------------------------------------------------------------------

/// The light of a pixel before the background.
inline LinearRgb over(const PixelLight& light, const LinearRgb& background) {
  if (light.share == 1) return LinearRgb(light.sum);
  return LinearRgb(light.sum + (1 - light.share) * dvec3(background));
}

/// By how many of 255 steps two pixels of the finished picture differ, in the component that differs most.
inline double steps_between(const LinearRgb& a, const LinearRgb& b) {
  const Rgba8 p = srgb8_from_linear(a), q = srgb8_from_linear(b);
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

/// Neighbours that differ by more steps than this are refined.
inline constexpr double contrast_threshold = 16;

/// A method of fragments: draw(triangles, window, colour, plot).
template <class Draw>
LightPicture of_fragments(Shot& shot, const Window& window, const Draw& draw) {
  LightPicture picture = empty_picture(shot.window);
  draw(std::span<const triangle_coverage::ScreenTriangle>(shot.triangles), window, shot.colour,
       [&](ivec2 p, const dvec3& sum, double share) {
         if (p.x == window.lower.x) shot.tell(p.y - window.lower.y, window.height());
         if (shot.window.contains(p)) picture[p - shot.window.lower] = {sum, share};
       });
  return picture;
}
template <class Draw>
LightPicture of_fragments(Shot& shot, const Draw& draw) {
  return of_fragments(shot, shot.window, draw);
}

/// Exact areas may take the square of what is seen in a pixel and more: a picture that would take too long is
/// refused, in one line that names the way out.
struct CuttingLimit {
  static constexpr std::int64_t most = 10'000'000,  ///< some seconds
      more_a_pixel = 100;                           ///< ordinary pixels take fewer

  std::size_t triangles;
  std::int64_t left;  ///< of the cuts

  CuttingLimit(std::size_t count, const Window& window)
      : triangles(count), left(most + more_a_pixel * window.width() * window.height()) {}

  void add(std::size_t cuts) {
    left -= static_cast<std::int64_t>(cuts);
    if (left >= 0) return;
    refuse_usage(fmt::format(
        "--aa area_sampling: expected triangles whose areas take at most {} cuts and {} per pixel, "
        "found {} that take more; adaptive and a_buffer take samples, and draw any",
        most, more_a_pixel, triangles));
  }
};

/// The colour of fragments, and a limit of the work.
struct LimitedColour {
  FragmentColour& colour;
  CuttingLimit& limit;

  dvec3 operator()(int triangle, ivec2 pixel, const triangle_coverage::Weights& at) const {
    return colour(triangle, pixel, at);
  }
  void cuts(std::size_t pieces) const { limit.add(pieces); }
};

/// Exact areas of what is seen.
inline LightPicture by_areas(Shot& shot) {
  return of_fragments(shot, [](auto triangles, const Window& window, auto& colour, const auto& plot) {
    CuttingLimit limit(triangles.size(), window);
    area_sampling::visible_areas(triangles, window, LimitedColour{colour, limit}, plot);
  });
}
/// Masks of 32 sub-samples; what lets light through shows what is behind it.
inline LightPicture by_masks(Shot& shot) {
  return of_fragments(shot, [](auto triangles, const Window& window, auto& colour, const auto& plot) {
    const auto opacity = [&](int triangle) { return colour.opacity(triangle); };
    a_buffer::a_buffer(triangles, window, colour, plot, a_buffer::OwnSurface{}, opacity);
  });
}
/// Samples where edges cross a pixel, and one colour per fragment.
inline LightPicture adaptively(Shot& shot) {
  const auto places = adaptive::n_rooks(shot.samples);
  return of_fragments(shot, [&](auto triangles, const Window& window, auto& colour, const auto& plot) {
    adaptive::adaptive(triangles, window, places, colour, plot);
  });
}
/// The same, and a colour per sample where neighbours differ, also those beside the window.
inline LightPicture by_contrast(Shot& shot) {
  const auto& [lower, upper] = shot.window;
  const Window with_neighbours = intersection({lower - 1, upper + 1}, shot.picture);
  const auto places = adaptive::n_rooks(shot.samples);
  const auto contrast = [&](const auto& a, const auto& b) {
    return steps_between(over({a.sum, a.share}, shot.background), over({b.sum, b.share}, shot.background));
  };
  return of_fragments(
      shot, with_neighbours, [&](auto triangles, const Window& window, auto& colour, const auto& plot) {
        adaptive::adaptive_contrast(triangles, window, places, contrast, contrast_threshold, colour, plot);
      });
}

// --- The methods ---------------------------------------------------------------------------------

/// Where a method samples every pixel. Those that look at edges have no pattern: it is one of centres.
inline Pattern pattern_of(Antialiasing method, int samples) {
  if (takes_squares(method)) return grid_pattern(samples);
  if (method == Antialiasing::jittered) return jittered_pattern(samples);
  if (method == Antialiasing::poisson_disc) return poisson_disc_pattern(samples);
  return {};
}

/// The picture of a shot by one of the methods. pattern: of the method.
inline LightPicture by_method(Shot& shot, Antialiasing method, const Pattern& pattern) {
  switch (method) {
    case Antialiasing::supersampling:
      return side_by_side(shot, pattern);
    case Antialiasing::none:
    case Antialiasing::accumulation_buffer:
    case Antialiasing::jittered:
    case Antialiasing::poisson_disc:
      return passes(shot, pattern);
    case Antialiasing::area_sampling:
      return by_areas(shot);
    case Antialiasing::a_buffer:
      return by_masks(shot);
    case Antialiasing::adaptive:
      return adaptively(shot);
    case Antialiasing::adaptive_contrast:
      break;
  }
  return by_contrast(shot);
}

/// Refuses numbers of samples that a scene's method does not take.
inline void check_samples(const Scene& scene) {
  const Antialiasing method = scene.antialiasing;
  const int most = takes_squares(method) ? 1024 : 256;
  expects(1 <= scene.samples && scene.samples <= most, "a pixel takes 1 to {} samples, not {}", most,
          scene.samples);
  expects(!takes_squares(method) || grid_side(scene.samples) != 0,
          "samples in cells are a square like 16, not {}", scene.samples);
}

/// Stages 6 and 7 with the antialiasing that the scene asks for.
///
/// triangles: from stage 5. size: of the picture. plan: of the same scene; the picture is that of its window.
///   watch: told of the work, and what was done.
///
/// Domain: that of rasterize; 1 to 256 samples; a square of up to 1024 where takes_squares says so.
/// Accuracy: with Antialiasing::none the bits of rasterize, keep_nearest and shade.
/// Cost: colours: one per pixel (none), one per sample (supersampling, accumulation_buffer, jittered,
///   poisson_disc), one per fragment (the others); adaptive_contrast one per sample in some pixels.
/// Errors: ContractViolation for another number of samples.
inline LightPicture antialias(const Scene& scene, const Triangles& triangles, Size size,
                              const Plan* plan = nullptr, PictureWatch* watch = nullptr) {
  const Window picture = picture_window(size);
  Shot shot{screen_triangles(triangles, size), picture,       plan ? plan->window : picture,
            {scene, triangles, size, plan},    scene.samples, scene.background,
            watch ? watch->reached : nullptr};
  check_samples(scene);
  LightPicture light = by_method(shot, scene.antialiasing, pattern_of(scene.antialiasing, scene.samples));
  if (watch) {
    watch->count = shot.colour.count();
    watch->without_area =
        std::ranges::count_if(shot.triangles, [](const auto& t) { return area_of(t.corners) == 0; });
  }
  return light;
}

/// The light before the scene's background.
inline Raster<LinearRgb> over_background(const LightPicture& picture, const LinearRgb& background) {
  Raster<LinearRgb> light(picture.width(), picture.height(), background);
  for (std::size_t i = 0; i < picture.cells().size(); ++i)
    light.cells()[i] = over(picture.cells()[i], background);
  return light;
}

/// The picture with a transparent ground: the covered share as alpha, and the colour of what covers it, which
/// is not darker where it covers little.
/// Accuracy: the nearest bytes. Wherever alpha is 0 all is 0.
inline Image with_alpha(const LightPicture& picture) {
  Image image(picture.width(), picture.height(), Rgba8{0, 0, 0, 0});
  for (std::size_t i = 0; i < picture.cells().size(); ++i) {
    const PixelLight& light = picture.cells()[i];
    const auto alpha = static_cast<std::uint8_t>(std::floor(255 * light.share + 0.5));
    if (alpha == 0) continue;
    Rgba8& pixel = image.cells()[i];
    pixel = srgb8_from_linear(LinearRgb(light.sum / light.share));
    pixel.a = alpha;
  }
  return image;
}

}  // namespace gradus::pipeline
