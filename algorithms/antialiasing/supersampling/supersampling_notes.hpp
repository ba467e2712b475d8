#pragma once
// Exhibits: supersampling as lecture notes have it, kept so that figures can show what comes of it. Both make
// the larger picture from the finished one, so that nothing is known of the scene that was not known before.
// Never use them; supersampling.hpp has the right form.

#include <cmath>
#include <utility>

#include "antialiasing/supersampling/supersampling.hpp"

namespace gradus::supersampling {

/// The finished picture n times as large: each pixel n x n times.
template <class Value>
struct Replicated {
  ivec2 size;
  std::vector<Value> values;  ///< row by row
};

/// The larger picture is blurred.
template <class Value>
struct Blurred {
  ivec2 size;
  std::vector<Value> values;
};

/// Of a pixel's n x n blurred values the first was taken.
template <class Value>
struct FirstTaken {
  ivec2 pixel, cell;
  Value value;
};

/// The weights of a Gaussian of standard deviation sigma, cut off at 4 sigma, from the middle outwards; with
/// the other side they add up to 1.
inline std::vector<double> bell(double sigma) {
  std::vector<double> weights{1};
  double sum = 1;
  const int radius = static_cast<int>(4 * sigma + 0.5);
  for (int i = 1; i <= radius; ++i) {
    weights.push_back(gradus::exp(-0.5 * i * i / (sigma * sigma)));
    sum += 2 * weights.back();
  }
  for (double& w : weights) w /= sum;
  return weights;
}

/// A number at any place of a line of `count` that is mirrored at its ends: c b a | a b c | c b a.
constexpr int mirrored(int i, int count) {
  const int place = ((i % (2 * count)) + 2 * count) % (2 * count);
  return place < count ? place : 2 * count - 1 - place;
}

/// One place of a blurred line: at(i) for all i of the line.
template <class At>
auto blurred_at(int i, int count, const std::vector<double>& weights, const At& at) {
  auto sum = weights[0] * at(i);
  for (int k = 1; std::cmp_less(k, weights.size()); ++k)
    sum += weights[static_cast<std::size_t>(k)] * (at(mirrored(i - k, count)) + at(mirrored(i + k, count)));
  return sum;
}

/// Each pixel of a finished picture n x n times.
template <class PixelAt>
auto replicas(ivec2 size, int n, const PixelAt& pixel_at) {
  std::vector<std::remove_cvref_t<decltype(pixel_at(ivec2{}))>> large;
  for (int y = 0; y < size.y * n; ++y) {
    for (int x = 0; x < size.x * n; ++x) large.push_back(pixel_at(ivec2{x / n, y / n}));
  }
  return large;
}

/// A picture blurred along rows, then along columns.
template <class Value>
std::vector<Value> blurred(const std::vector<Value>& picture, ivec2 size, double sigma) {
  const std::vector<double> weights = bell(sigma);
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * size.x + x); };
  std::vector<Value> rows(picture.size()), all(picture.size());
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x)
      rows[index(x, y)] = blurred_at(x, size.x, weights, [&](int i) { return picture[index(i, y)]; });
  }
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x)
      all[index(x, y)] = blurred_at(y, size.y, weights, [&](int i) { return rows[index(x, i)]; });
  }
  return all;
}

/// The three channels of a colour blurred into each other, as if they were three pixels of a line.
inline dvec3 mixed_channels(const dvec3& colour, double sigma) {
  const std::vector<double> weights = bell(sigma);
  const auto channel = [&](int i) { return colour[i]; };
  return {blurred_at(0, 3, weights, channel), blurred_at(1, 3, weights, channel),
          blurred_at(2, 3, weights, channel)};
}

/// FAULTY: makes the larger picture of the finished one (errata E001-52): n x n replicas of each pixel,
/// blurred with standard deviation n/2, of each n x n the first. Edges stay jagged, become blurred as well,
/// and move by (n - 1)/2 sub-cells, since the first of a block is not its middle.
///
/// size: of the finished picture. n: how many times larger. pixel_at(ivec2): its pixels, numbers or vectors
///   of numbers. plot(ivec2, value): called once a pixel, row by row.
///
/// Domain: size >= 1 each way, 1 <= n <= most.
/// Steps: Replicated Blurred FirstTaken+.
/// Accuracy: none; of a picture of one colour right.
/// Cost: n^2 (8 n + 4) products a pixel, memory three larger pictures.
/// Errors: ContractViolation outside of the domain.
template <class PixelAt, class Plot, class Value = std::remove_cvref_t<std::invoke_result_t<PixelAt, ivec2>>,
          Observer<Replicated<Value>, Blurred<Value>, FirstTaken<Value>> O = Unobserved>
void upsampled_image(ivec2 size, int n, const PixelAt& pixel_at, Plot&& plot, O&& observer = {}) {
  expects(size.x >= 1 && size.y >= 1, "a picture of {} x {} pixels", size.x, size.y);
  expects(1 <= n && n <= most, "{} times larger is not between 1 and {}", n, most);
  // Each finished pixel n x n times
  auto large = replicas(size, n, pixel_at);
  if constexpr (observed<O>) observer(Replicated<Value>{size * n, large});
  const ivec2 wide = size * n;
  const double sigma = 0.5 * n;
  auto smooth = blurred(large, wide, sigma);
  if constexpr (observed<O>) observer(Blurred<Value>{size * n, smooth});
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      // The first of n x n, not their mean
      const int at = n * (y * wide.x + x);
      auto value = smooth[std::size_t(at)];
      if constexpr (observed<O>) observer(FirstTaken<Value>{{x, y}, {x * n, y * n}, value});
      plot(ivec2{x, y}, value);
    }
  }
}

/// FAULTY: as upsampled_image, and blurs along the axis of the colours as well (errata E001-53), as a filter
/// does that is given one width for all axes of an array of rows, columns and channels. Red bleeds into green
/// and blue.
///
/// size, n, plot: as for upsampled_image. pixel_at(ivec2): its pixels' red, green and blue.
///
/// Domain, Steps, Cost, Errors: as for upsampled_image.
/// Accuracy: none; of a grey picture as upsampled_image.
template <class PixelAt, class Plot,
          Observer<Replicated<dvec3>, Blurred<dvec3>, FirstTaken<dvec3>> O = Unobserved>
void blurred_channels(ivec2 size, int n, const PixelAt& pixel_at, Plot&& plot, O&& observer = {}) {
  expects(size.x >= 1 && size.y >= 1, "a picture of {} x {} pixels", size.x, size.y);
  expects(1 <= n && n <= most, "{} times larger is not between 1 and {}", n, most);
  // Each finished pixel n x n times
  auto large = replicas(size, n, pixel_at);
  if constexpr (observed<O>) observer(Replicated<dvec3>{size * n, large});
  const ivec2 wide = size * n;
  const double sigma = 0.5 * n;
  auto smooth = blurred(large, wide, sigma);
  // One sigma for all axes: colours, too
  for (dvec3& colour : smooth)  // all of them
    colour = mixed_channels(colour, sigma);
  if constexpr (observed<O>) observer(Blurred<dvec3>{size * n, smooth});
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const int at = n * (y * wide.x + x);
      auto value = smooth[std::size_t(at)];
      if constexpr (observed<O>) observer(FirstTaken<dvec3>{{x, y}, {x * n, y * n}, value});
      plot(ivec2{x, y}, value);
    }
  }
}

}  // namespace gradus::supersampling
