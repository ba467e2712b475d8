// Bounds that headers claim, held to where they are hard to keep: a search goes from random inputs to what
// uses most of a bound. The right numbers are fractions without rounding, or have 34 digits. Every constant
// is the header's: docs/claims.csv says which.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "antialiasing/area_sampling/visible_picture.hpp"
#include "core/camera.hpp"
#include "projection/parallel/parallel.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewport/viewport.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"
#include "scene/camera/projection_keys.hpp"
#include "shading/illumination/illumination.hpp"
#include "shading/polygon_shading/polygon_shading.hpp"
#include "shading/texture_mapping/texture_mapping.hpp"
#include "stages/3_perspective.hpp"
#include "stages/5_clipping.hpp"
#include "support/documented.hpp"
#include "support/hard_inputs.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus {
namespace {

using namespace test;
using Wide = boost::multiprecision::cpp_bin_float_quad;

constexpr double u = 0x1p-53;

double off(double found, const Wide& right, double unit) {
  return static_cast<double>(abs(found - right) / unit);
}

/// The distance to the next double.
double ulp_of(double x) { return std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x); }
double ulp_of(const Fraction& x) { return ulp_of(static_cast<double>(x)); }

TEST(HardBounds, CrossProductsDownToTheSmallest) {
  // A direction, and a multiple of it with a little more, so that products cancel; down to 2^-1000
  const auto draw = [](Random& random) {
    Numbers n = numbers(random, 6, 0);
    const int small = -static_cast<int>(random.uniform_int(0, 1000));
    const int less = -static_cast<int>(random.uniform_int(0, 60));
    for (std::size_t i = 0; i < 3; ++i) n[i + 3] = std::ldexp(n[i] + std::ldexp(n[i + 3], less), small);
    return n;
  };
  int smallest = 0;
  const auto judge = [&](const Numbers& n) {
    const dvec3 a = three(n, 0), b = three(n, 3), found = affine_3d::accurate_cross(a, b);
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Fraction right = Fraction(a[j]) * Fraction(b[k]) - Fraction(a[k]) * Fraction(b[j]);
      if (abs(right) < Fraction(0x1p-1000)) continue;
      smallest += abs(right) < Fraction(0x1p-969);
      most = std::max(most, off(found[i], right, ulp_of(right)));
    }
    return most;
  };
  EXPECT_LE(worst(8000, draw, judge), 2);
  EXPECT_GT(smallest, 100) << "where products lose their errors below the subnormals";
}

TEST(HardBounds, PlacesInThePicture) {
  // In float the width is rounded, too, from 2^24 on
  const auto worst_in = [](auto one) {
    using T = decltype(one);
    const auto draw = [](Random& random) {
      const double at = number(random, 3);
      return Numbers{at, whole_number(random, 1, 0x1p31)};
    };
    const auto judge = [](const Numbers& n) {
      if (!(1 <= n[1] && n[1] < 0x1p31)) return not_in_domain;
      const T at = static_cast<T>(n[0]);
      const int width = static_cast<int>(n[1]);
      const Fraction right = (Fraction(1) + Fraction(at)) * Fraction(width) / Fraction(2);
      if (right.sign() == 0) return not_in_domain;
      const T found = viewport::to_pixel(glm::vec<2, T>(at, 0), width, 1).x;
      return off(found, right, abs(right) * Fraction(std::numeric_limits<T>::epsilon() / 2));
    };
    return worst(4000, draw, judge);
  };
  EXPECT_LE(worst_in(1.0), 2.001);
  EXPECT_LE(worst_in(1.0f), 3.001) << "3 roundings";
}

TEST(HardBounds, WaysOfOrthographicRays) {
  const auto judge = [](const Numbers& n) {
    double t = 0;
    parallel::orthographic(parallel::Axis::x, n[0], dvec3{n[1], 1, 2}, [&](const auto& step) {
      if constexpr (requires { step.t; }) t = step.t;
    });
    const Fraction right = Fraction(n[0]) - Fraction(n[1]);
    return off(t, right, ulp_of(right));
  };
  const auto draw = [](Random& random) { return numbers(random, 2); };
  EXPECT_LE(worst(4000, draw, judge), 1.0 / 2);
}

TEST(HardBounds, TheNearPlaneIsAtZero) {
  const auto draw = [](Random& random) {
    const double near = 0x1p-40 + std::abs(number(random, 30));
    return Numbers{near, near * (1 + std::abs(number(random, 20)))};
  };
  const auto judge = [](const Numbers& n) {
    const auto [near, far] = std::pair(n[0], n[1]);
    if (!(0 < near && near < far)) return not_in_domain;
    const auto p = projection_of(1.0, 1.0, near, far);
    if (!has_fma) EXPECT_EQ(perspective::transform(p, dvec3{0, 0, near}).z, 0);
    // As a compiler may have it
    const double fused = std::fma(p.z_scale, near, p.z_offset);
    return std::abs(fused) / (0x1p-53 * std::abs(p.z_offset));
  };
  EXPECT_LE(worst(4000, draw, judge), 1);
}

TEST(HardBounds, AnglesOfLenses) {
  // What a scene's file would give
  struct Lens {
    double focal, sensor;
    mutable bool refused = false;

    static std::optional<double> member(const Lens& at, std::string_view key) {
      return key == "focal"    ? std::optional(at.focal)
             : key == "sensor" ? std::optional(at.sensor)
                               : std::nullopt;
    }
    double needed(const Lens& at, std::string_view key) const { return *member(at, key); }
    double above_zero(double x) const { return x; }
    double number_in(double x, double, double, const std::string&) const { return x; }
    void refuse(double, const std::string&, const std::string&) const { refused = true; }
  };
  const auto draw = [](Random& random) {
    const double focal = std::abs(number(random, 10));
    return Numbers{focal, std::abs(number(random, 10))};
  };
  const auto judge = [](const Numbers& n) {
    const Lens lens{n[0], n[1]};
    pipeline::View view;
    pipeline::take_lens(lens, lens, view);
    if (lens.refused) return not_in_domain;
    const Wide right = 2 * atan(Wide(lens.sensor) / 2 / lens.focal);
    return off(view.vertical_radians, right, ulp_of(static_cast<double>(right)));
  };
  EXPECT_LE(worst(4000, draw, judge), 0.501);
}

TEST(HardBounds, ParallelRaysToClipSpace) {
  const auto draw = [](Random& random) {
    Numbers n = numbers(random, 8);
    n[3] = std::abs(n[3]), n[4] = std::abs(n[4]);
    return n;
  };
  const auto judge = [](const Numbers& n) {
    const dvec3 view = three(n, 0);
    const double height = n[3], aspect = n[4], near = n[5], far = n[6], plane = n[7];
    if (!(height > 0 && aspect > 0 && near < far)) return not_in_domain;
    const pipeline::SceneLens lens{
        {}, pipeline::ParallelRays{height, {0.5, -0.25}, plane, near, far}, aspect};
    const glm::dvec4 found = pipeline::transform(lens, view);
    const dvec3 image = parallel::oblique(plane, lens.rays->slant, view);
    const Fraction scale = Fraction(2) / Fraction(height);
    const std::array right{scale / Fraction(aspect) * Fraction(image.x), scale * Fraction(image.y),
                           (Fraction(view.z) - Fraction(near)) / (Fraction(far) - Fraction(near))};
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      const Fraction& is = right[static_cast<std::size_t>(i)];
      if (is.sign() != 0) most = std::max(most, off(found[i], is, abs(is) * Fraction(u)));
    }
    return most;
  };
  EXPECT_LE(worst(6000, draw, judge), 3.001) << "3 roundings";
}

TEST(HardBounds, DepthsOfPlanes) {
  constexpr pipeline::Size size{640, 480};
  // Places in the picture at all depths; every other time nearly on a line there
  const auto draw = [](Random& random) {
    Numbers n;
    const dvec2 from{random.uniform(-1, 1), random.uniform(-1, 1)},
        way{random.uniform(-1, 1), random.uniform(-1, 1)};
    const double wide =
        random.unit() < 0.5 ? 1 : std::ldexp(1.0, -static_cast<int>(random.uniform_int(1, 20)));
    for (int i = 0; i < 3; ++i) {
      const double w = std::exp2(random.uniform(0, 10)), along = random.uniform(-1, 1);
      for (int k = 0; k < 2; ++k)
        n.push_back(w * std::clamp(from[k] + along * way[k] + wide * random.uniform(-1, 1), -1.0, 1.0));
      n.push_back(w);
    }
    n.push_back(std::exp2(random.uniform(-10, 0)));
    return n;
  };
  const auto judge = [&](const Numbers& n) {
    const auto in_picture = [&](const glm::dvec4& p) { return std::abs(p.x) <= p.w && std::abs(p.y) <= p.w; };
    const double near = n[9], far = 2048;
    if (!(0 < near && near < 1)) return not_in_domain;
    std::array<glm::dvec4, 3> places;
    for (std::size_t i = 0; i < 3; ++i)
      places[i] = perspective::transform(projection_of(1.0, 1.0, near, far), three(n, 3 * i));
    const auto plane = pipeline::plane_depth(places, size);
    if (!plane || !std::ranges::all_of(places, in_picture)) return not_in_domain;
    constexpr double grid = triangle_coverage::subpixels;
    const double gain = grid * (std::abs(plane->right) * size.width + std::abs(plane->down) * size.height);
    // The least height of the triangle in the picture
    const auto side = [&](std::size_t k, std::size_t m) {
      const auto along = [&](int axis) {
        return static_cast<double>(Fraction(places[m][axis]) / Fraction(places[m].w) -
                                   Fraction(places[k][axis]) / Fraction(places[k].w));
      };
      return dvec2{along(0), along(1)};
    };
    const dvec2 first = side(0, 1), second = side(0, 2);
    const double longest = std::max({glm::length(first), glm::length(second), glm::length(side(1, 2))}),
                 height = std::abs(first.x * second.y - first.y * second.x) / longest,
                 bound = 0x1p-50 * (1 + gain) / height;
    if (!std::isfinite(bound)) return not_in_domain;  // edge-on, but for roundings: nothing is promised
    double most = 0;
    for (const glm::dvec4& p : places) {
      const Fraction w = p.w, half_grid = grid / 2;
      const Fraction x = (Fraction(1) + Fraction(p.x) / w) * half_grid * Fraction(size.width),
                     y = (Fraction(1) - Fraction(p.y) / w) * half_grid * Fraction(size.height);
      const Fraction found = Fraction(plane->depth) + Fraction(plane->right) * (x - Fraction(plane->from.x)) +
                             Fraction(plane->down) * (y - Fraction(plane->from.y));
      most = std::max(most, off(found, Fraction(p.z) / w, bound));
    }
    return most;
  };
  EXPECT_LE(worst(4000, draw, judge), 1);
}

TEST(HardBounds, EndsOfRows) {
  using polygon_shading::Corner;
  const auto draw = [](Random& random) {
    Numbers n = numbers(random, 4, static_cast<int>(random.uniform_int(0, 23)));
    n.push_back(whole_number(random, std::min(n[1], n[3]), std::max(n[1], n[3])));
    return n;
  };
  const auto judge = [](const Numbers& n) {
    dvec2 a{n[0], n[1]}, b{n[2], n[3]};
    if (b.y < a.y) std::swap(a, b);
    const int row = static_cast<int>(n[4]);
    const double y = row + 0.5, largest = std::max(std::abs(a.x), std::abs(b.x));
    if (!(a.y <= y && y < b.y) || largest > polygon_shading::farthest) return not_in_domain;
    const std::array<Corner<double, double>, 3> polygon{{{a, 0}, {b, 0}, {{a.x, b.y}, 0}}};
    const auto [left, right] = polygon_shading::ends(std::span<const Corner<double, double>>(polygon), row);
    const double found = left.lower == 0 && left.upper == 1 ? left.x : right.x;
    const Fraction part = (Fraction(y) - Fraction(a.y)) / (Fraction(b.y) - Fraction(a.y));
    return off(found, Fraction(a.x) + (Fraction(b.x) - Fraction(a.x)) * part, u * largest);
  };
  EXPECT_LE(worst(20000, draw, judge), 8);
}

TEST(HardBounds, RangesOfLights) {
  const auto draw = [](Random& random) {
    Numbers n = numbers(random, 6, 3);
    n.push_back(std::abs(number(random, 4)));
    return n;
  };
  const auto judge = [](const Numbers& n) {
    Light light;
    light.position = three(n, 0), light.range = n[6];
    if (!(light.range > 0)) return not_in_domain;
    illumination::AllSeen seen;
    const double found = illumination::arriving(light, 0, three(n, 3), seen).window;
    Wide square = 0;
    for (std::size_t i = 0; i < 3; ++i) square += (Wide(n[i]) - n[i + 3]) * (Wide(n[i]) - n[i + 3]);
    const Wide part = square / (Wide(light.range) * light.range),
               left = part < 1 ? Wide(1 - part * part) : Wide(0);
    return off(found, left * left, u);
  };
  EXPECT_LE(worst(8000, draw, judge), 20);
}

TEST(HardBounds, TexelsOfLevels) {
  using namespace texture_mapping;
  const auto draw = [](Random& random) {
    Numbers n = numbers(random, 9, 0);
    for (int k = 0; k < 2; ++k) n.push_back(random.unit() < 0.3 ? 32767 : whole_number(random, 1, 100));
    return n;
  };
  // Texel k of an axis' half covers the columns from k count / half on and before (k + 1) count / half, each
  // by what they overlap
  const auto overlap = [](int k, int count, int column) {
    const Fraction wide = Fraction(count) / Fraction(std::max(1, count / 2));
    const Fraction from = std::max(Fraction(k) * wide, Fraction(column)),
                   to = std::min(Fraction(k + 1) * wide, Fraction(column + 1));
    return from < to ? (to - from) / wide : Fraction(0);
  };
  const auto judge = [&](const Numbers& n) {
    if (!(1 <= n[9] && n[9] < 32768 && 1 <= n[10] && n[10] < 32768)) return not_in_domain;
    const ivec2 size{static_cast<int>(n[9]), static_cast<int>(n[10])}, at = size_of_level(size, 1) / 2,
                                                                       from = 2 * at;
    const auto texel = [&](ivec2 p) {
      return n[static_cast<std::size_t>(p.x - from.x + 3 * (p.y - from.y))];
    };
    Fraction right;
    double largest = 0;
    for (int y = from.y; y < std::min(from.y + 3, size.y); ++y) {
      for (int x = from.x; x < std::min(from.x + 3, size.x); ++x) {
        const Fraction part = overlap(at.x, size.x, x) * overlap(at.y, size.y, y);
        if (part.sign() == 0) continue;
        right += part * Fraction(texel({x, y}));
        largest = std::max(largest, std::abs(texel({x, y})));
      }
    }
    return off(covered_mean(at, size, texel), right, u * largest);
  };
  EXPECT_LE(worst(6000, draw, judge), 16);
}

TEST(HardBounds, LevelsMixed) {
  using namespace texture_mapping;
  constexpr ivec2 size{8, 8};
  const auto draw = [](Random& random) {
    const double finer = random.uniform(-1, 1), coarser = random.uniform(-1, 1);
    const double side = std::exp2(random.uniform(0, 1)) / size.x, angle = random.uniform(0, 1.5);
    return Numbers{finer, coarser, side * std::cos(angle), side * std::sin(angle)};
  };
  const auto judge = [&](const Numbers& n) {
    const Wide side = sqrt(Wide(n[2]) * n[2] + Wide(n[3]) * n[3]) * size.x;
    if (!(1 < side && side < 2)) return not_in_domain;
    // Levels of one colour each, which bilinear gives exactly
    std::vector<double> texels(texels_of_chain(size), n[0]);
    std::fill(texels.begin() + size.x * size.y, texels.end(), n[1]);
    const double found = mip_mapped<double>({0.3, 0.4}, {{n[2], n[3]}, {0, 0}}, {size, texels});
    const Wide right = n[0] + log2(side) * (Wide(n[1]) - n[0]);
    return off(found, right, u * std::max(std::abs(n[0]), std::abs(n[1])));
  };
  EXPECT_LE(worst(4000, draw, judge), 20);
}

TEST(HardBounds, ExpandedEdgesFarOut) {
  using namespace triangle_coverage;
  constexpr double pixels = 64;
  const auto draw = [](Random& random) {
    Numbers n;
    for (int i = 0; i < 6; ++i) n.push_back(whole_number(random, 0, pixels * subpixels));
    for (int i = 0; i < 2; ++i) n.push_back(whole_number(random, 0, pixels));
    return n;
  };
  const auto judge = [](const Numbers& n) {
    const auto point = [&](std::size_t i) {
      return ivec2{static_cast<int>(n[i]), static_cast<int>(n[i + 1])};
    };
    const Triangle triangle{point(0), point(2), point(4)};
    const ivec2 pixel = point(6);
    if (doubled_area(triangle) == 0) return not_in_domain;
    const Edges edges = edges_of(triangle);
    const dvec3 found = FarEdges(edges, {1e8, 1e8}).areas_at(pixel);
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      // Small whole numbers and halves: doubles have them exactly
      const dvec2 from(edges[static_cast<std::size_t>(i)].from), to(edges[static_cast<std::size_t>(i)].to);
      const dvec2 way = to - from, at = (dvec2(pixel) + 0.5) * double{subpixels} - from;
      most = std::max(most, off(found[i],
                                (Fraction(way.x) * Fraction(at.y) - Fraction(way.y) * Fraction(at.x)) /
                                    Fraction(subpixels * subpixels),
                                1));
    }
    return most;
  };
  EXPECT_TRUE(states("algorithms/scan_conversion/triangle_coverage/triangle_coverage.faults",
                     "a unit in the last place of |origin|^2: {} square pixels at 1e8.",
                     {worst(8000, draw, judge)}));
}

TEST(HardBounds, CornersInAPixel) {
  using namespace area_sampling;
  const auto draw = [](Random& random) {
    const double of = std::floor(std::exp2(random.uniform(1, 31)));
    const double rest = whole_number(random, 1, of);
    return Numbers{whole_number(random, 0, subpixels), rest, of};
  };
  const auto judge = [](const Numbers& n) {
    const double whole = std::floor(n[0]), rest = std::floor(n[1]), of = std::floor(n[2]);
    if (!(0 <= whole && whole < subpixels && 0 <= rest && rest < of && of < 0x1p31)) return not_in_domain;
    const Vertex v{{static_cast<int>(whole), 0}, {static_cast<int>(rest), 0}, {static_cast<int>(of), 1}, {}};
    const Fraction right = (Fraction(whole) + Fraction(rest) / Fraction(of)) / Fraction(subpixels);
    return off(place_in<double>(v, {0, 0}).x, right, 0x1p-54);
  };
  EXPECT_LE(worst(8000, draw, judge), 1.01);
}

/// Twice the area.
Fraction doubled(dvec2 a, dvec2 b, dvec2 c) {
  return (Fraction(b.x) - Fraction(a.x)) * (Fraction(c.y) - Fraction(a.y)) -
         (Fraction(b.y) - Fraction(a.y)) * (Fraction(c.x) - Fraction(a.x));
}

TEST(HardBounds, CentresOfMass) {
  for (const int m : {1, 2, 4, 16}) {
    // Slivers along a line through the pixel
    const auto draw = [m](Random& random) {
      Numbers n(static_cast<std::size_t>(6 * m));
      const dvec2 from{random.unit(), random.unit()}, way{random.uniform(-1, 1), random.uniform(-1, 1)};
      const double wide = std::exp2(random.uniform(-9, -2));
      for (std::size_t i = 0; i < n.size(); i += 2) {
        const double along = random.uniform(-1, 1);
        for (std::size_t k = 0; k < 2; ++k) {
          const int axis = static_cast<int>(k);
          n[i + k] = std::clamp(from[axis] + along * way[axis] + wide * random.uniform(-1, 1), 0.0, 1.0);
        }
      }
      return n;
    };
    const auto judge = [m](const Numbers& n) {
      if (!std::ranges::all_of(n, [](double x) { return 0 <= x && x <= 1; })) return not_in_domain;
      area_sampling::Pieces<double> pieces;
      Fraction area, x, y;
      for (std::size_t i = 0; i < n.size(); i += 6) {
        dvec2 a{n[i], n[i + 1]}, b{n[i + 2], n[i + 3]}, c{n[i + 4], n[i + 5]};
        if (doubled(a, b, c).sign() < 0) std::swap(b, c);
        const Fraction of = doubled(a, b, c) / Fraction(2);
        pieces.push_back({a, b, c});
        area += of;
        x += of * (Fraction(a.x) + Fraction(b.x) + Fraction(c.x)) / Fraction(3);
        y += of * (Fraction(a.y) + Fraction(b.y) + Fraction(c.y)) / Fraction(3);
      }
      if (area < Fraction(0x1p-10)) return not_in_domain;
      const dvec2 found = area_sampling::centroid_of(pieces);
      return std::max(off(found.x, x / area, m * 0x1p-41), off(found.y, y / area, m * 0x1p-41));
    };
    EXPECT_LE(worst(16000 / (4 + m), draw, judge), 1) << m << " triangles";
  }
}

}  // namespace
}  // namespace gradus
