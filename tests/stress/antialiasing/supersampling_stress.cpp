// The promises of supersampling: exact means of shapes, the bits of the larger picture, one colour stays, and
// how far the box is from the area of a half-plane.

#include "antialiasing/supersampling/supersampling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "stress/numbers.hpp"
#include "support/random_edges.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::supersampling;

constexpr int largest = 12;  // samples along an axis that are tried

/// n, filter, the pixel, and a half-plane: the angle of its normal and the distance from the pixel's middle.
Input task(Kind kind, Random& random) {
  const auto whole = [&](double lower, double upper) { return std::floor(random.uniform(lower, upper + 1)); };
  Input input{whole(1, largest),          whole(0, 2), whole(-20, 20), whole(-20, 20), random.uniform(0, 6.3),
              random.uniform(-0.75, 0.75)};
  switch (kind) {
    case Kind::ties:  // through places and corners of cells
      input[4] = whole(0, 8) * 0.78539816339744831;
      input[5] = whole(-8, 8) / 16;
      break;
    case Kind::huge:
      input[2] = whole(-farthest, farthest - 1), input[3] = whole(-farthest, farthest - 1);
      break;
    case Kind::extremes:
      input[2] = random.unit() < 0.5 ? -farthest : farthest - 1;
      input[0] = random.unit() < 0.5 ? 1 : largest;
      break;
    case Kind::refused:
      (random.unit() < 0.5 ? input[0] : input[2]) = random.unit() < 0.5 ? 0x1p21 : -0x1p22;
      break;
    default:
      break;
  }
  return input;
}

bool is_task(const Input& i) {
  const auto is_whole = [&](std::size_t k, double lower, double upper) {
    return i[k] == std::floor(i[k]) && lower <= i[k] && i[k] <= upper;
  };
  return all_finite(i) && is_whole(0, 1, largest) && is_whole(1, 0, 2) &&
         is_whole(2, -farthest + 2, farthest - 3) && is_whole(3, -farthest + 2, farthest - 3) &&
         std::abs(i[4]) < 100 && std::abs(i[5]) < 100;
}
/// A window of four pixels.
Window window_of(const Input& i) {
  const ivec2 pixel(static_cast<int>(i[2]), static_cast<int>(i[3]));
  return {pixel, pixel + 1};
}
int samples_of(const Input& i) { return static_cast<int>(i[0]); }
Filter filter_of(const Input& i) { return static_cast<Filter>(static_cast<int>(i[1])); }

/// The half-plane, about the first pixel's middle.
test::StraightEdge edge_of(const Input& i) {
  const dvec2 normal{gradus::cos(i[4]), gradus::sin(i[4])};
  return {normal, glm::dot(normal, dvec2(0.5)) + i[5]};
}

/// How far the mean of a shape is from the exact one, in units of a rounding: counted in whole numbers, with
/// the weights of box and tent. Of the Gaussian, from a sum in extended precision.
double means_error(const Input& i) {
  if (!is_task(i)) {
    const bool refused =
        i.size() == 6 && all_finite(i) && i[0] == std::floor(i[0]) && i[0] > most && i[0] < 1e9;
    if (!refused) return 0;
    try {
      supersample(
          {{0, 0}, {0, 0}}, samples_of(i), Filter::box, [](dvec2) { return 1.0; }, [](ivec2, double) {});
    } catch (const ContractViolation&) {
      return 0;
    }
    return wrong;
  }
  const int n = samples_of(i);
  const Filter filter = filter_of(i);
  const Window window = window_of(i);
  const test::StraightEdge edge = edge_of(i);
  const dvec2 origin(window.lower);
  const auto scene = [&](dvec2 p) { return edge.holds(p - origin) ? 1.0 : 0.0; };
  double worst = 0;
  supersample(window, n, filter, scene, [&](ivec2 pixel, double mean) {
    long double sum = 0, total = 0;
    for (int y = -2 * n; y < 3 * n; ++y) {
      for (int x = -2 * n; x < 3 * n; ++x) {
        const auto weight = [&](int cell) -> long double {
          const long double d = std::abs((2 * cell + 1 - n) / (2.0L * n));  // in pixels from the middle
          if (d >= radius_of(filter)) return 0;
          if (filter == Filter::box) return 1;
          return filter == Filter::tent ? 1 - d : std::exp(-2 * d * d);
        };
        const long double w = weight(x) * weight(y);
        total += w;
        // Asked where the method asks: places of cells are rounded once
        if (w > 0 && scene(place_of(pixel * n + ivec2(x, y), n)) > 0.5) sum += w;
      }
    }
    worst = std::max(worst, std::abs(static_cast<double>(mean - sum / total)));
  });
  return worst / 0x1p-52;
}

/// The larger picture, bit for bit.
double picture_error(const Input& i) {
  if (!is_task(i)) return 0;
  const auto scene = [](dvec2 p) {
    const double x = 1000 * gradus::sin(12.9898 * p.x + 78.233 * p.y);
    return x - std::floor(x);
  };
  std::vector<double> one, other;
  supersample(window_of(i), samples_of(i), filter_of(i), scene, [&](ivec2, double v) { one.push_back(v); });
  large_picture(window_of(i), samples_of(i), filter_of(i), scene,
                [&](ivec2, double v) { other.push_back(v); });
  return one.size() == 4 && one == other ? 0 : wrong;
}

/// One colour stays, within a rounding for each cell of the filter.
double colour_error(const Input& i) {
  if (!is_task(i)) return 0;
  const double colour = 0.1 + i[5];
  double worst = 0;
  supersample(
      window_of(i), samples_of(i), filter_of(i), [&](dvec2) { return colour; },
      [&](ivec2, double v) { worst = std::max(worst, std::abs(v - colour)); });
  const double cells = (radius_of(filter_of(i)) * 2 * i[0] + 2) * (radius_of(filter_of(i)) * 2 * i[0] + 2);
  return worst / (std::max(std::abs(colour), 1e-300) * 0x1p-52 * (cells + 4));
}

/// The box against the exact area of a half-plane, in parts of 1/n.
double area_error(const Input& i) {
  if (!is_task(i)) return 0;
  const test::StraightEdge edge = edge_of(i);
  double share = 0;
  supersample(
      {{0, 0}, {0, 0}}, samples_of(i), Filter::box, [&](dvec2 p) { return edge.holds(p) ? 1.0 : 0.0; },
      [&](ivec2, double v) { share = v; });
  return std::abs(share - edge.area()) * i[0];
}

}  // namespace

Domain supersampling() {
  const std::vector kinds{Kind::random, Kind::ties, Kind::huge, Kind::extremes, Kind::refused};
  const std::vector<Trap> traps{{"one sample", {1, 0, 0, 0, 0.3, 0.1}},
                                {"along the axis", {4, 0, 3, 3, 0, 0}},
                                {"tent of an odd number", {5, 1, 0, 0, 0.7, 0.2}},
                                {"three samples, no power of two", {3, 2, -7, 9, 2.2, -0.3}}};
  const auto property = [&](const char* name, const char* states, const char* unit, double bound,
                            auto error) {
    return Property{.name = name,
                    .states = states,
                    .unit = unit,
                    .bound = bound,
                    .numbers = 6,
                    .kinds = kinds,
                    .generate = task,
                    .error = error,
                    .traps = traps,
                    .cases = 1000};
  };
  return {"supersampling",
          {property("means", "weighted means of shapes", "roundings", 8, means_error),
           property("large_picture", "the bits of the whole larger picture", "", 0, picture_error),
           property("one_colour", "one colour stays", "(cells + 4) roundings", 1, colour_error),
           property("area", "the box is at most 1/n off the area of a half-plane", "1/n", 1, area_error)}};
}

}  // namespace gradus::stress
