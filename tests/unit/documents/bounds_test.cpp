// Bounds that headers claim and that are no promise of a topic, each held to by random inputs against numbers
// of 34 digits. Every constant is the header's: docs/claims.csv says which.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"
#include "antialiasing/jittered/jittered.hpp"
#include "antialiasing/poisson_disc/poisson_disc.hpp"
#include "antialiasing/sampling_theorem/sampling_theorem.hpp"
#include "antialiasing/supersampling/supersampling.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"
#include "projection/parallel/parallel.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewport/viewport.hpp"
#include "scan_conversion/antialiased_line/antialiased_line.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"
#include "scene/camera/movement.hpp"
#include "scene/camera/turntable.hpp"
#include "scene/road/circular_road.hpp"
#include "shading/illumination/illumination.hpp"
#include "shading/polygon_shading/mixed_along.hpp"
#include "shading/texture_mapping/texture_mapping.hpp"
#include "support/documented.hpp"
#include "transformation/affine_2d/affine_2d.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_quad;

constexpr double u = 0x1p-53, ulp = 0x1p-52;
constexpr int cases = 2000;
constexpr std::uint64_t seed = 20240611;

Wide size(const Wide& x) { return x < 0 ? Wide(-x) : x; }
double off(double found, const Wide& right) { return static_cast<double>(size(found - right)); }
double near(const Wide& x) { return static_cast<double>(x); }
/// The distance to the next double.
double ulp_of(const Wide& x) {
  const double at = std::abs(near(x));
  return std::nextafter(at, HUGE_VAL) - at;
}

/// Numbers of both signs and of sizes from 2^-8 to 2^8.
struct Numbers {
  Random random{seed};
  double operator()() {
    return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform_int(-8, 8)));
  }
  dvec2 two() { return {(*this)(), (*this)()}; }
  dvec3 three() { return {(*this)(), (*this)(), (*this)()}; }
  dvec3 direction() {
    const dvec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    return unit_vector(v);
  }
};

TEST(Bounds, TransformationsInThePlane) {
  using namespace affine_2d;
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    const Factor<double> f{{next.two(), next.two()}, next.two(), next.two()};
    const dvec2 p = next.two(), c = f.pivot;
    const Matrix<double> m = matrix(f);
    std::vector<dvec2> moved{p};
    const std::vector<Factor<double>> factors{f};
    factor_by_factor(std::span<const Factor<double>>(factors), std::span(moved));
    for (int i = 0; i < 2; ++i) {
      const Wide x = f.linear[0][i], y = f.linear[1][i];
      const Wide column = c[i] - (c.x * x + c.y * y) + f.shift[i];
      const Wide terms = size(c[i]) + size(c.x * x) + size(c.y * y) + size(f.shift[i]);
      EXPECT_LE(off(m[2][i], column), near(4 * u * (1 + 4 * u) * terms));
      const Wide dx = Wide(p.x) - c.x, dy = Wide(p.y) - c.y, place = dx * x + dy * y + c[i] + f.shift[i];
      const Wide parts = size(dx * x) + size(dy * y) + size(c[i]) + size(f.shift[i]);
      EXPECT_LE(off(moved[0][i], place), near(5 * u * (1 + 5 * u) * parts));
    }
    const Wide ad = Wide(m[0].x) * m[1].y, bc = Wide(m[1].x) * m[0].y;
    EXPECT_LE(off(determinant(m), ad - bc), near(2 * ulp * std::max(size(ad), size(bc))));
    const Matrix<double> second = matrix(Factor<double>{{next.two(), next.two()}, next.two(), next.two()});
    const Matrix<double> both = compose(second, m);
    for (int k = 0; k < 9; ++k) {
      Wide sum = 0, terms = 0;
      for (int j = 0; j < 3; ++j) {
        const Wide product = Wide(second[j][k % 3]) * m[k / 3][j];
        sum += product, terms += size(product);
      }
      EXPECT_LE(off(both[k / 3][k % 3], sum), near(4 * ulp * terms));
    }
  }
}

TEST(Bounds, TransformationsInSpace) {
  using namespace affine_3d;
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    const dvec3 axis = next.direction(), c = next.three();
    const Turn<double> t = turn(next());
    const Matrix<double> r = rodrigues(axis, t), around = about(c, r),
                         second = translation(next.three()) * around;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        const Wide square = Wide(t.versine) * axis[column] * axis[row];
        const int third = 3 - column - row;
        const bool plus = (row - column + 3) % 3 == 1;
        const Wide rest = row == column ? Wide(t.cos) : (plus ? 1 : -1) * Wide(t.sin) * axis[third];
        EXPECT_LE(off(r[column][row], square + rest),
                  near(3 * u * (1 + 2 * u) * (size(square) + size(rest))));
      }
    }
    for (int row = 0; row < 3; ++row) {
      Wide sum = c[row], terms = size(c[row]);
      for (int k = 0; k < 3; ++k) {
        const Wide product = Wide(c[k]) * r[k][row];
        sum -= product, terms += size(product);
      }
      EXPECT_LE(off(around[3][row], sum), near(5 * u * (1 + 4 * u) * terms));
    }
    const Matrix<double> both = compose(second, around);
    for (int k = 0; k < 16; ++k) {
      Wide sum = 0, terms = 0;
      for (int j = 0; j < 4; ++j) {
        const Wide product = Wide(second[j][k % 4]) * around[k / 4][j];
        sum += product, terms += size(product);
      }
      EXPECT_LE(off(both[k / 4][k % 4], sum), near(4 * u * (1 + 3 * u) * terms));
    }
    // Onto z: sines and cosines are ratios of the axis' coordinates
    const dvec3 any = next.three();
    const Alignment<double> align = alignment(any);
    const Wide across = sqrt(Wide(any.y) * any.y + Wide(any.z) * any.z),
               length = sqrt(across * across + Wide(any.x) * any.x);
    EXPECT_LE(std::max(off(align.x->sin, any.y / across), off(align.x->cos, any.z / across)), 4 * ulp);
    EXPECT_LE(std::max(off(align.y->sin, -any.x / length), off(align.y->cos, across / length)), 4 * ulp);
    // Products that cancel
    const dvec3 a = next.direction(), b = a + 0x1p-30 * next.direction();
    const dvec3 found = accurate_cross(a, b);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Wide right = Wide(a[j]) * b[k] - Wide(a[k]) * b[j];
      EXPECT_LE(off(found[i], right), 2 * ulp_of(right));
    }
    const Wide product = Wide(a.x) * b.x + Wide(a.y) * b.y + Wide(a.z) * b.z;
    EXPECT_LE(off(missing_product(a, b, 1), 1 - product), 1e-30 + ulp_of(1 - product));
  }
}

TEST(Bounds, FramesAndPictures) {
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    const auto frame = viewing::look_at(next.three(), next.three(), next.direction());
    const dvec3 axes[] = {frame.right, frame.up, frame.forward};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k <= i; ++k) {
        const Wide product =
            Wide(axes[i].x) * axes[k].x + Wide(axes[i].y) * axes[k].y + Wide(axes[i].z) * axes[k].z;
        if (i != k) EXPECT_LE(near(size(product)), 8 * ulp);
        if (i == k) EXPECT_LE(near(size(sqrt(product) - 1)), 8 * ulp);
      }
    }
    const auto matrix = viewing::world_to_view(frame);
    const dvec3 e = frame.eye;
    const double eye = near(sqrt(Wide(e.x) * e.x + Wide(e.y) * e.y + Wide(e.z) * e.z));
    for (int row = 0; row < 3; ++row) {
      const dvec3 a = axes[row];
      EXPECT_LE(off(matrix[3][row], -(Wide(a.x) * e.x + Wide(a.y) * e.y + Wide(a.z) * e.z)),
                3.0 / 2 * ulp * eye);
    }
    // A letterbox: the side with more room is as long as the other one's scale says
    const dvec2 lower = next.two(), upper = lower + dvec2{std::abs(next()), std::abs(next())};
    const ivec2 picture{static_cast<int>(next.random.uniform_int(100, 5000)),
                        static_cast<int>(next.random.uniform_int(100, 5000))};
    const auto map = viewport::letterboxed(Rectangle<double>{lower, upper}, picture);
    const Wide width = Wide(upper.x) - lower.x, height = Wide(upper.y) - lower.y;
    const Wide scale = std::min(Wide(picture.x / width), Wide(picture.y / height));
    const Wide sides[] = {width * scale, height * scale};
    const dvec2 ndc{next.random.uniform(-1, 1), next.random.uniform(-1, 1)};
    const dvec2 pixel = viewport::to_pixel(ndc, picture.x, picture.y);
    const Wide places[] = {(1 + Wide(ndc.x)) * picture.x / 2, (1 - Wide(ndc.y)) * picture.y / 2};
    for (int i = 0; i < 2; ++i) {
      EXPECT_LE(off(map.viewport.lower[i], (picture[i] - sides[i]) / 2), 2 * ulp_of(picture[i]));
      EXPECT_LE(off(map.viewport.upper[i], (picture[i] + sides[i]) / 2), 2 * ulp_of(picture[i]));
      EXPECT_LE(off(pixel[i], places[i]), 2 * ulp_of(picture[i]));
    }
    // One quotient, the nearest number
    const dvec3 way = next.three();
    const auto slant = parallel::slant_of(way);
    EXPECT_LE(off(slant.a, Wide(way.x) / way.z), 1.0 / 2 * ulp_of(Wide(way.x) / way.z));
    const glm::dvec4 clip{next.three(), std::abs(next())};
    const dvec3 divided = perspective::divide(clip);
    for (int i = 0; i < 3; ++i)
      EXPECT_LE(off(divided[i], Wide(clip[i]) / clip.w), 1.0 / 2 * ulp_of(Wide(clip[i]) / clip.w));
  }
}

TEST(Bounds, WeightsOfTriangles) {
  using namespace triangle_coverage;
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    Triangle corners;
    for (ivec2& p : corners)
      p = {static_cast<int>(next.random.uniform_int(0, 1 << 20)),
           static_cast<int>(next.random.uniform_int(0, 1 << 20))};
    if (doubled_area(corners) == 0) continue;
    Weights w;
    for (auto& weight : w) weight = next.random.uniform_int(0, std::int64_t{1} << 50);
    const dvec3 values = next.three(), over{std::abs(next()), std::abs(next()), std::abs(next())};
    const Wide all = Wide(w[0]) + w[1] + w[2];
    const Wide seen = w[0] * Wide(over.x) + w[1] * Wide(over.y) + w[2] * Wide(over.z);
    const dvec3 shares = barycentric(w), surface = perspective_correct(w, over);
    Wide value = 0;
    for (int i = 0; i < 3; ++i) {
      const Wide share = w[static_cast<std::size_t>(i)] / all,
                 part = w[static_cast<std::size_t>(i)] * Wide(over[i]) / seen;
      EXPECT_LE(off(shares[i], share), 2 * ulp_of(share));
      EXPECT_LE(off(surface[i], part), 8 * ulp_of(part));
      value += share * values[i];
    }
    EXPECT_LE(off(surface.x + surface.y + surface.z, 1), 4 * ulp);
    const double largest = std::max({std::abs(values.x), std::abs(values.y), std::abs(values.z)});
    EXPECT_LE(off(Linear(corners, values).at(w), value), 6 * ulp_of(largest));
  }
}

TEST(Bounds, LightAndTextures) {
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    Light light;
    light.constant = std::abs(next()), light.linear = std::abs(next()), light.quadratic = std::abs(next());
    const double d = std::abs(next());
    const Wide weakened = light.constant + d * (Wide(light.linear) + Wide(d) * light.quadratic);
    const Wide left = weakened > 1 ? Wide(1 / weakened) : Wide(1);
    EXPECT_LE(off(illumination::attenuation(light, d), left), 3 * ulp_of(left));
    // Places whose differences are exact
    const double from = static_cast<double>(next.random.uniform_int(-99, 0)),
                 to = static_cast<double>(next.random.uniform_int(1, 99));
    const double at = next.random.uniform(from, to), first = next(), second = next();
    const Wide part = (Wide(at) - from) / (Wide(to) - from), mixed = first + part * (Wide(second) - first);
    const double found = polygon_shading::mixed_along(polygon_shading::Along::x, dvec2{from, 0}, dvec2{to, 0},
                                                      first, second, at);
    EXPECT_LE(off(found, mixed), 4 * u * std::max(std::abs(first), std::abs(second)));
    const ivec2 texels{static_cast<int>(next.random.uniform_int(1, 4096)),
                       static_cast<int>(next.random.uniform_int(1, 4096))};
    const texture_mapping::Footprint<double> footprint{next.two(), next.two()};
    const auto length = [&](dvec2 v) -> Wide {
      const Wide x = Wide(v.x) * texels.x, y = Wide(v.y) * texels.y;
      return sqrt(x * x + y * y);
    };
    const Wide side = std::max(length(footprint.along_x), length(footprint.along_y));
    EXPECT_LE(off(texture_mapping::longer_side(footprint, texels), side), near(4 * u * side));
    const double texel_side = 1 + std::abs(next());
    const auto level = texture_mapping::level_of(texel_side, 13);
    EXPECT_LE(off(level.lower + level.part, log2(Wide(texel_side))), 0x1p-50 + ulp_of(level.lower));
  }
}

TEST(Bounds, SamplesAndKernels) {
  Numbers next;
  const Wide pi = boost::math::constants::pi<Wide>();
  for (int n = 0; n < cases; ++n) {
    const ivec2 grid{static_cast<int>(next.random.uniform_int(1, 1024)),
                     static_cast<int>(next.random.uniform_int(1, 1024))};
    const int i = static_cast<int>(next.random.uniform_int(0, grid.x - 1));
    const Wide place = (2 * Wide(i) + 1) / (2 * Wide(grid.x));
    EXPECT_LE(off(accumulation_buffer::place_of(i, 0, grid).x, place), 1.0 / 2 * ulp_of(place));
    const dvec2 way = next.two();
    const Wide square = Wide(way.x) * way.x + Wide(way.y) * way.y;
    EXPECT_LE(off(poisson_disc::squared(way), square), 3 * ulp_of(square));
    const double x = next();
    EXPECT_LE(off(sampling_theorem::sinc(x), sin(pi * x) / (pi * x)), 8 * u);
    // Lines: their length, and the cone beside them
    const bresenham_line::Extent extent{next.random.uniform_int(1, 1 << 30),
                                        next.random.uniform_int(0, 1 << 30)};
    const Wide long_ = sqrt(Wide(extent.dx) * extent.dx + Wide(extent.dy) * extent.dy);
    EXPECT_LE(off(antialiased_line::length_of(extent), long_), 2 * ulp_of(long_));
    const auto beside = [&](const Wide& t) -> Wide {
      const Wide v = std::min(Wide(1), size(t)), s = sqrt(1 - v * v);
      if (v == 0) return 0;
      const Wide volume = (2 * v * s + asin(v) - v * v * v * log((1 + s) / v)) / pi;
      return t < 0 ? Wide(-volume) : volume;
    };
    const double t = next.random.uniform(-1, 1), distance = next.random.uniform(0, 1.5);
    EXPECT_LE(off(antialiased_line::cone_beside(t), beside(t)), 1e-15);
    EXPECT_LE(off(antialiased_line::cone_share(distance),
                  beside(Wide(distance) + 0.5) - beside(Wide(distance) - 0.5)),
              2e-15);
  }
}

TEST(Bounds, WhatMovesInAScene) {
  using namespace pipeline;
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    const CircularRoad road{
        .centre = next.three(), .radius = 0.1 + std::abs(next()), .speed = 0.1 + std::abs(next())};
    const double seconds = next();
    const Car car = car_at(road, seconds);
    const Wide turned = angular_speed(road) * seconds, c = cos(turned), s = sin(turned);
    const double reach = length_of(road.centre) + road.radius;
    const Wide out[] = {c, s, 0}, ahead[] = {-s, c, 0};
    const dvec3 offset = next.three(), seat = mounted_on(car, offset);
    const Frame<double> frame{.eye = next.three(), .right = car.out, .up = car.ahead, .forward = car.up};
    const dvec3 stepped = moved(frame, offset).eye;
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(std::max(off(car.out[i], out[i]), off(car.ahead[i], ahead[i])), 2 * ulp);
      EXPECT_LE(off(car.place[i], road.centre[i] + road.radius * out[i]), 3 * ulp * reach);
      const Wide along =
          offset.x * Wide(car.out[i]) + offset.y * Wide(car.ahead[i]) + offset.z * Wide(car.up[i]);
      EXPECT_LE(off(seat[i], car.place[i] + along), 4 * ulp * (length_of(car.place) + length_of(offset)));
      EXPECT_LE(off(stepped[i], frame.eye[i] + along), 3 * ulp * (length_of(frame.eye) + length_of(offset)));
    }
    const Frame<double> round = orbited(frame, next.three(), next.three(), next());
    EXPECT_LE(std::abs(glm::dot(round.right, round.up)), 4 * ulp);
    EXPECT_LE(std::abs(glm::dot(round.up, round.forward)), 4 * ulp);
    EXPECT_LE(std::abs(glm::dot(round.forward, round.right)), 4 * ulp);
    // A ray that may run nearly beside the plane
    const dvec3 normal = next.three(),
                direction = glm::cross(normal, next.three()) + std::ldexp(1.0, -n % 30) * next.three();
    const Ray ray{next.three(), direction};
    const dvec3 place = next.three();
    Wide slope = 0, slopes = 0, rise = 0, rises = 0;
    for (int i = 0; i < 3; ++i) {
      const Wide a = Wide(direction[i]) * normal[i], b = (Wide(place[i]) - ray.origin[i]) * normal[i];
      slope += a, slopes += size(a), rise += b, rises += size(b);
    }
    const Wide t = rise / slope;
    if (const auto met = meets_plane(ray, place, normal); met && size(slope) > slopes * 0x1p-40) {
      EXPECT_LE(off(*met, t), near(5.1 * u * (rises + size(t) * slopes) / size(slope)));
    }
  }
}

TEST(Bounds, ConesBesideADiagonal) {
  // At its distance along the column instead of across the line: the exhibit's worst pixel
  double worst = 0;
  for (double slope = 0; slope <= 1; slope += 0.05) {
    for (double d = 0; d <= 2; d += 0.001) {
      const double across = d / std::sqrt(1 + slope * slope);
      worst =
          std::max(worst, std::abs(antialiased_line::cone_share(d) - antialiased_line::cone_share(across)));
    }
  }
  EXPECT_TRUE(test::states("algorithms/scan_conversion/antialiased_line/antialiased_line.faults",
                           "right for level and upright lines only; up to {} off near a diagonal.", {worst}));
}

TEST(Bounds, WeightsOfAGaussian) {
  // e^(-2 d²) along each axis; d² is up to 2.25 and rounded three times, each exponential once, and their
  // product
  for (int n = 1; n <= 16; ++n) {
    const auto kernel = supersampling::kernel_of(supersampling::Filter::gaussian, n);
    for (const auto& [cell, weight] : kernel.cells) {
      const Wide x = (2 * Wide(cell.x) + 1 - n) / (2 * Wide(n)),
                 y = (2 * Wide(cell.y) + 1 - n) / (2 * Wide(n));
      const Wide right = exp(-2 * (x * x + y * y));
      EXPECT_LE(off(weight, right), near(31 * u * right));
    }
  }
}

TEST(Bounds, MeansOfSamples) {
  Numbers next;
  for (int n = 0; n < cases; ++n) {
    const auto count = static_cast<std::size_t>(next.random.uniform_int(1, 64));
    std::vector<dvec2> places(count);
    for (dvec2& place : places) place = {next.random.unit(), next.random.unit()};
    const auto colour = [](dvec2 p) { return p.x + 3 * p.y; };
    Wide sum = 0;
    double largest = 0;
    for (const dvec2 p : places) sum += colour(p), largest = std::max(largest, colour(p));
    EXPECT_LE(off(jittered::sample_pixel({0, 0}, places, colour), sum / count),
              static_cast<double>(count) * 0x1p-53 * largest);
  }
}

TEST(Bounds, EyesOfATurntable) {
  using namespace pipeline;
  Numbers next;
  const Wide pi = boost::math::constants::pi<Wide>();
  for (int n = 0; n < 200; ++n) {
    View view;
    const dvec3 eye = next.three(), target = next.three();
    view.eye = eye, view.target = target, view.up = next.direction();
    const int frames = static_cast<int>(next.random.uniform_int(1, 90));
    const CameraPath path = turntable({}, view, 1.5, frames);
    const dvec3 axis = unit_vector(path.up[0].value);
    for (int k = 0; k < frames; ++k) {
      const Wide angle = 2 * pi * k / frames, c = cos(angle), s = sin(angle);
      Wide d[3], a[3] = {axis.x, axis.y, axis.z}, along = 0, length = 0, norm = 0;
      for (int i = 0; i < 3; ++i) norm += a[i] * a[i];
      for (int i = 0; i < 3; ++i)
        a[i] /= sqrt(norm), d[i] = Wide(eye[i]) - target[i], along += d[i] * a[i], length += d[i] * d[i];
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, m = (i + 2) % 3;
        const Wide right = target[i] + c * d[i] + s * (a[j] * d[m] - a[m] * d[j]) + (1 - c) * along * a[i];
        EXPECT_LE(off(path.eye[static_cast<std::size_t>(k)].value[i], right),
                  34 * ulp * near(sqrt(length)) + ulp * length_of(target));
      }
    }
  }
}

}  // namespace
}  // namespace gradus
