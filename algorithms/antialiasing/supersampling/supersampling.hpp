#pragma once
// Supersampling: the scene is evaluated at n x n places per pixel, and a filter makes one value of them. The
// places are new samples of the scene; no finished picture can give them.
//
// Rows grow downwards; pixel (c, r) is the square [c, c + 1) x [r, r + 1). A pixel has n x n sub-cells, cell
// (0, 0) lies at the corner of pixel (0, 0), and the scene is asked at the cells' middles.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <ranges>
#include <span>
#include <type_traits>
#include <vector>

#include "antialiasing/supersampling/sample_rows.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/pixels.hpp"

namespace gradus::supersampling {

/// How samples are weighed by their distance from the pixel's middle, along each axis.
enum class Filter : std::uint8_t {
  box,       ///< all alike within 1/2 pixel: the pixel itself
  tent,      ///< falls to 0 within 1 pixel
  gaussian,  ///< a bell of standard deviation 1/2 pixel, cut off at 3/2 pixels
};

/// How far a filter reaches from a pixel's middle, in pixels.
constexpr double radius_of(Filter filter) {
  return filter == Filter::box ? 0.5 : filter == Filter::tent ? 1.0 : 1.5;
}

/// Of a value that is a number or a vector of numbers (light of three colours): the number.
template <class Value>
struct ScalarOf {
  using type = Value;
};
template <int N, class T>
struct ScalarOf<glm::vec<N, T>> {
  using type = T;
};

/// A filter's weight at a distance d/2 from the pixel's middle, in cells of 1/n pixel: d is |2 i + 1 - n| for
/// cell i, a whole number. Within the filter's reach positive.
template <class T>
T weight_at(Filter filter, int d, int n) {
  using enum Filter;
  if (filter == box) return T(1);
  // 0 a pixel away, times 2 n
  if (filter == tent) {
    return T(2 * n - d);
  }
  // A bell: sigma is 1/2 pixel
  const double x = d / (2.0 * n);
  return T(gradus::exp(-2 * x * x));
}

/// How many cells beyond a pixel, on each side, its filter takes.
constexpr int reach_of(Filter filter, int n) {
  return filter == Filter::box ? 0 : filter == Filter::tent ? n / 2 : n;
}

/// The cells that the pixels of a window need. Domain: a window that is not empty.
constexpr Window cells_of(const Window& window, int n, int reach) {
  return {window.lower * n - reach, (window.upper + 1) * n - 1 + reach};
}

/// A cell round a pixel, counted from the pixel's first, and what it counts.
template <class T>
struct Weighed {
  ivec2 at;
  T weight;
};

/// The cells that a pixel's filter takes, row by row, with the weights of a filter for n x n samples per
/// pixel: the product of those of both axes. Weights of box and tent are whole numbers and add up exactly.
/// Domain: 1 <= n <= most.
/// Accuracy: box and tent exact, Gaussian within 31 u of each weight, u = 2^-53.
template <class T>
struct Kernel {
  Filter filter;
  int n;      ///< cells per pixel
  int reach;  ///< cells beyond the pixel, on each side
  std::vector<Weighed<T>> cells;
  T total{0};  ///< of all weights

  Kernel(Filter f, int samples) : filter(f), n(samples), reach(reach_of(f, samples)) {
    const auto along = [&](int i) { return weight_at<T>(filter, std::abs(2 * i + 1 - n), n); };
    for (int j = -reach; j < n + reach; ++j) {
      for (int i = -reach; i < n + reach; ++i) {
        cells.push_back({{i, j}, along(i) * along(j)});
        total += cells.back().weight;
      }
    }
  }
  auto begin() const { return cells.begin(); }
  auto end() const { return cells.end(); }
  /// The cells round the pixels of a window.
  Window round(const Window& window) const { return cells_of(window, n, reach); }
};

template <class T = double>
Kernel<T> kernel_of(Filter filter, int n) {
  return Kernel<T>(filter, n);
}

/// What `supersample` takes for the pixels of a window: the rows of samples that one row of pixels needs.
/// Domain: 1 <= n <= most.
constexpr Taken cost_of_band(const Window& window, int n, Filter filter) {
  if (window.empty()) return {};
  const int reach = reach_of(filter, n);
  const Window cells = cells_of(window, n, reach);
  return {cells.width() * cells.height(), cells.width() * (n + 2 * reach)};
}
/// What `large_picture` takes: all samples at once.
constexpr Taken cost_of_large_picture(const Window& window, int n, Filter filter) {
  const std::int64_t asked = cost_of_band(window, n, filter).asked;
  return {asked, asked};
}

// --- Steps -------------------------------------------------------

/// The weights are there.
struct Started {
  Window window;
  int n;
  Filter filter;
  int reach;  ///< cells beyond a pixel that its filter takes, on each side
};

/// A row of the larger picture is there.
template <class Value>
struct RowDrawn {
  int row;
  std::vector<Value> values;
};

/// A sample was added to a pixel.
template <class Value>
struct Added {
  ivec2 pixel, cell;
  typename ScalarOf<Value>::type weight, total;
  Value value, sum;  ///< of the sample; of weight times value so far
};

/// A pixel has its value.
template <class Value>
struct Filtered {
  ivec2 pixel;
  Value sum, value;
};

struct Finished {
  Taken taken;
};

// --- What both methods share -------------------------------------

/// Kernels have weights of the type of a value's numbers.
template <class Scene>
using KernelFor = Kernel<typename ScalarOf<ValueOf<Scene>>::type>;

inline void expect_task(const Window& window, int n) {
  expects(1 <= n && n <= most, "{} samples along an axis are not between 1 and {}", n, most);
  expects(window.empty() || (-farthest <= std::min(window.lower.x, window.lower.y) &&
                             std::max(window.upper.x, window.upper.y) < farthest),
          "the window reaches more than {} pixels out", farthest);
}

// --- The taught method -------------------------------------------

/// What supersample does with the kernel of its filter.
template <class T, class Scene, class Plot, class Value = ValueOf<Scene>,
          Observer<Started, Added<Value>, Filtered<Value>, Finished> O = Unobserved>
Taken draw(const Window& window, const Kernel<T>& kernel, const Scene& scene, Plot&& plot,
           O&& observer = {}) {
  Band band(window, kernel, scene);
  if constexpr (observed<O>) observer(Started{window, kernel.n, kernel.filter, kernel.reach});
  for (ivec2 p : pixels(window)) {
    // Each place is asked once
    band.ask_for(p);
    // Weigh the samples round p
    Value sum(0);
    for (auto& [at, w] : kernel) {
      auto cell = p * kernel.n + at;
      sum += w * band.at(cell);
      if constexpr (observed<O>) observer(Added<Value>{p, cell, w, kernel.total, band.at(cell), sum});
    }
    // All weights together count 1
    auto mean = sum / kernel.total;
    if constexpr (observed<O>) observer(Filtered<Value>{p, sum, mean});
    plot(p, mean);
  }
  if constexpr (observed<O>) observer(Finished{band.taken()});
  return band.taken();
}

/// Asks the scene at n x n places per pixel and plots the filtered values. Neighbouring pixels share the
/// samples that a filter wider than a pixel takes from beyond it: each place is asked once, and only the rows
/// of samples that a row of pixels needs are kept. Source: F. C. Crow, The aliasing problem in
/// computer-generated shaded images, CACM 20(11), 1977, 799-805; filters: D. P. Mitchell and A. N. Netravali,
/// Reconstruction filters in computer graphics, 1988, 221-228.
///
/// window: the pixels that are asked for. n: samples per pixel along each axis. filter: see Filter.
///   scene(dvec2): the light at any place, in pixels; a number, or a vector of numbers that are
///   proportional to light. plot(ivec2, value): called once per pixel, row by row.
///
/// Domain: 1 <= n <= most, the window at most `farthest` pixels from 0; an empty one plots nothing. Places
///   reach up to 3/2 pixels beyond the window.
/// Steps: Started (Added+ Filtered)+ Finished, none for an empty window; Added for each cell of a pixel's
///   filter, row by row.
/// Accuracy: of values 0 and 1, as of a shape, with box and tent: the exact mean, rounded once. Else within
///   (cells of the filter + 4) eps of the largest value. Against the exact area of a half-plane the box is
///   off by at most 1/n, and by nothing on average.
/// Cost: n^2 samples of the scene per pixel; each pixel n^2 (box), 4 n^2 (tent) or 9 n^2 (Gaussian) sums.
///   Memory: n, 2 n or 3 n rows of samples (cost_of_band).
/// Errors: ContractViolation outside the domain.
template <class Scene, class Plot, class Value = ValueOf<Scene>,
          Observer<Started, Added<Value>, Filtered<Value>, Finished> O = Unobserved>
Taken supersample(const Window& window, int n, Filter filter, const Scene& scene, Plot&& plot,
                  O&& observer = {}) {
  expect_task(window, n);
  if (window.empty()) return {};
  return draw(window, KernelFor<Scene>(filter, n), scene, plot, observer);
}

// --- The whole larger picture ------------------------------------

/// The textbook's three steps: draws a picture n times as wide and as high, filters it, and keeps one value
/// per pixel. The values are those of `supersample`, bit for bit; the memory is n x n as large.
/// Source: as for supersample.
///
/// window, n, filter, scene, plot: as for supersample.
///
/// Domain, Accuracy, Errors: as for supersample.
/// Steps: Started RowDrawn+ Filtered+ Finished; none for an empty window.
/// Cost: as for supersample; memory all samples (cost_of_large_picture).
template <class Scene, class Plot, class Value = ValueOf<Scene>,
          Observer<Started, RowDrawn<Value>, Filtered<Value>, Finished> O = Unobserved>
Taken large_picture(const Window& window, int n, Filter filter, const Scene& scene, Plot&& plot,
                    O&& observer = {}) {
  using K = KernelFor<Scene>;
  expect_task(window, n);
  if (window.empty()) return {};
  const K kernel(filter, n);
  auto cells = kernel.round(window);
  Samples<Value> large(cells, n);
  if constexpr (observed<O>) observer(Started{window, n, filter, kernel.reach});
  // Draw the larger picture
  for (int y : large.rows()) {
    large.ask(y, scene);
    if constexpr (observed<O>) observer(RowDrawn<Value>{y, large.row(y)});
  }
  // Filter it, at the pixels alone
  for (ivec2 p : pixels(window)) {
    Value sum(0);
    for (auto& [at, w] : kernel) {
      const auto cell = p * n + at;
      sum += w * large.at(cell);
    }
    auto mean = sum / kernel.total;
    if constexpr (observed<O>) observer(Filtered<Value>{p, sum, mean});
    plot(p, mean);
  }
  if constexpr (observed<O>) observer(Finished{large.taken()});
  return large.taken();
}

}  // namespace gradus::supersampling
