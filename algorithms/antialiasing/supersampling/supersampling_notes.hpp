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

/// A picture in memory, row by row.
template <class Value>
struct Picture {
  ivec2 size;
  std::vector<Value> values;

  std::size_t index(ivec2 p) const { return static_cast<std::size_t>(p.y * size.x + p.x); }
  const Value& at(ivec2 p) const { return values[index(p)]; }
};
constexpr Pixels pixels(ivec2 size) { return Pixels({{0, 0}, size - 1}); }

/// Each pixel of a finished picture n x n times.
template <class Image>
auto grown(ivec2 size, int n, const Image& image) {
  Picture<std::remove_cvref_t<std::invoke_result_t<const Image&, ivec2>>> large{size * n, {}};
  for (const ivec2 p : pixels(large.size)) large.values.push_back(image(p / n));
  return large;
}

/// A picture blurred along rows, then along columns.
template <class Value>
Picture<Value> blurred(const Picture<Value>& picture, double sigma) {
  const std::vector<double> weights = bell(sigma);
  Picture<Value> rows = picture, all = picture;
  for (const ivec2 p : pixels(picture.size)) {
    const auto along = [&](int i) { return picture.at({i, p.y}); };
    rows.values[rows.index(p)] = blurred_at(p.x, picture.size.x, weights, along);
  }
  for (const ivec2 p : pixels(picture.size)) {
    const auto along = [&](int i) { return rows.at({p.x, i}); };
    all.values[all.index(p)] = blurred_at(p.y, picture.size.y, weights, along);
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
/// size: of the finished picture. n: how many times larger. image(ivec2): its pixels, numbers or vectors of
///   numbers. plot(ivec2, value): called once per pixel, row by row.
///
/// Domain: size >= 1 each way, 1 <= n <= most.
/// Steps: Replicated Blurred FirstTaken+.
/// Accuracy: none; of a picture of one colour right.
/// Cost: n^2 (8 n + 4) products per pixel, memory three larger pictures.
/// Errors: ContractViolation outside the domain.
template <class Image, class Plot, class Value = std::remove_cvref_t<std::invoke_result_t<Image, ivec2>>,
          Observer<Replicated<Value>, Blurred<Value>, FirstTaken<Value>> O = Unobserved>
void upsampled_image(ivec2 size, int n, const Image& image, Plot&& plot, O&& observer = {}) {
  expects(size.x >= 1 && size.y >= 1, "a picture of {} x {} pixels", size.x, size.y);
  expects(1 <= n && n <= most, "{} times larger is not between 1 and {}", n, most);
  // Each finished pixel n x n times
  auto wide = grown(size, n, image);
  if constexpr (observed<O>) observer(Replicated<Value>{wide.size, wide.values});
  const double sigma = 0.5 * n;
  auto soft = blurred(wide, sigma);
  if constexpr (observed<O>) observer(Blurred<Value>{soft.size, soft.values});
  for (ivec2 p : pixels(size)) {
    // The first of n x n, no mean
    auto value = soft.at(p * n);
    if constexpr (observed<O>) observer(FirstTaken<Value>{p, p * n, value});
    plot(p, value);
  }
}

/// FAULTY: as upsampled_image, and blurs along the axis of the colours as well (errata E001-53), as a filter
/// does that is given one width for all axes of an array of rows, columns and channels. Red bleeds into green
/// and blue.
///
/// size, n, plot: as for upsampled_image. image(ivec2): its pixels' red, green and blue.
///
/// Domain, Steps, Cost, Errors: as for upsampled_image.
/// Accuracy: none; of a grey picture as upsampled_image.
template <class Image, class Plot,
          Observer<Replicated<dvec3>, Blurred<dvec3>, FirstTaken<dvec3>> O = Unobserved>
void blurred_channels(ivec2 size, int n, const Image& image, Plot&& plot, O&& observer = {}) {
  expects(size.x >= 1 && size.y >= 1, "a picture of {} x {} pixels", size.x, size.y);
  expects(1 <= n && n <= most, "{} times larger is not between 1 and {}", n, most);
  // Each finished pixel n x n times
  auto wide = grown(size, n, image);
  if constexpr (observed<O>) observer(Replicated<dvec3>{wide.size, wide.values});
  const double sigma = 0.5 * n;
  auto soft = blurred(wide, sigma);
  // One sigma for colours, too
  for (dvec3& c : soft.values) {
    c = mixed_channels(c, sigma);
  }
  if constexpr (observed<O>) observer(Blurred<dvec3>{soft.size, soft.values});
  for (ivec2 p : pixels(size)) {
    auto value = soft.at(p * n);
    if constexpr (observed<O>) observer(FirstTaken<dvec3>{p, p * n, value});
    plot(p, value);
  }
}

}  // namespace gradus::supersampling
