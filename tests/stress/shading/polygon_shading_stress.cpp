// The promises of polygon shading: neighbours share no pixel and leave none, mixed colours are those of exact
// barycentric weights and stay within the corners', normals have length 1.

#include "shading/polygon_shading/polygon_shading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/arithmetic/exact_scalar.hpp"
#include "shading/polygon_shading/vertex_normals.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace polygon_shading;
using Lit = Corner<double, double>;

constexpr double unit = 0x1p-53;
constexpr Window picture{{-32, -32}, {31, 31}};

// --- Colours of a triangle

/// x, y and the colour of three corners.
Input triangle(Kind kind, Random& random) {
  Input input(9);
  for (std::size_t k = 0; k < 9; ++k) {
    const bool colour = k % 3 == 2;
    input[k] = colour ? random.uniform(0, 1) : random.uniform(-30, 30);
    if (kind == Kind::ties && !colour) input[k] = std::floor(2 * input[k]) / 2;
    if (kind == Kind::ties && colour) input[k] = std::floor(2 * input[k]);
  }
  if (kind == Kind::near_degenerate) {
    // The third corner lies almost on the way from the first to the second
    const double t = random.uniform(0, 1);
    for (std::size_t k = 0; k < 2; ++k)
      input[6 + k] = nudged(input[k] + t * (input[3 + k] - input[k]), random);
  }
  if (kind == Kind::grazing) {
    // A corner touches the line through the centres of a row
    input[7] = nudged(std::floor(input[7]) + 0.5, random);
  }
  return input;
}

bool is_triangle(const Input& i) {
  for (std::size_t k = 0; k < 9; ++k) {
    if (!(std::abs(i[k]) <= 1000)) return false;
  }
  return true;
}

std::vector<Lit> corners_of(const Input& i) {
  std::vector<Lit> corners;
  for (std::size_t k = 0; k + 2 < i.size(); k += 3) corners.push_back({{i[k], i[k + 1]}, i[k + 2]});
  return corners;
}

/// The colour that exact barycentric weights give the pixel's centre; nothing for corners in a line.
std::optional<Exact> exact_colour(const Input& i, ivec2 pixel) {
  const Exact x = Exact(pixel.x) + Exact(0.5), y = Exact(pixel.y) + Exact(0.5);
  const auto doubled = [](Exact ax, Exact ay, Exact bx, Exact by, Exact cx, Exact cy) {
    return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  };
  const Exact ax(i[0]), ay(i[1]), bx(i[3]), by(i[4]), cx(i[6]), cy(i[7]);
  const Exact all = doubled(ax, ay, bx, by, cx, cy);
  if (all == Exact(0)) return std::nullopt;
  const Exact a = doubled(x, y, bx, by, cx, cy), b = doubled(ax, ay, x, y, cx, cy);
  return (a * Exact(i[2]) + b * Exact(i[5]) + (all - a - b) * Exact(i[8])) / all;
}

double gouraud_error(const Input& i) {
  if (!is_triangle(i)) return 0;
  const std::vector<Lit> corners = corners_of(i);
  const double colour = std::max({std::abs(i[2]), std::abs(i[5]), std::abs(i[8])});
  const double far = std::max({std::abs(i[0]), std::abs(i[3]), std::abs(i[6])});
  if (colour == 0) return 0;
  const ExactScope scope;
  double worst = 0, width = 1;
  int looked_at = 0;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, RowBegun<double, double>>) {
      width = s.right.x - s.left.x;
      looked_at = 0;
    }
    if constexpr (std::same_as<Step, Shaded<double, double, double>>) {
      if (looked_at++ % 8 != 0) return;  // rationals are dear
      const auto right = exact_colour(i, s.pixel);
      if (!right) return;
      const double off = std::abs(to_double(Exact(s.colour) - *right));
      worst = std::max(worst, off / (unit * (1 + far / width) * colour));
    }
  };
  gouraud(std::span<const Lit>(corners), picture, [](ivec2, double) {}, watch);
  return worst;
}

double range_error(const Input& i) {
  if (!is_triangle(i)) return 0;
  const std::vector<Lit> corners = corners_of(i);
  const double least = std::min({i[2], i[5], i[8]}), most = std::max({i[2], i[5], i[8]});
  const double size = std::max(std::abs(least), std::abs(most));
  double worst = 0;
  gouraud(std::span<const Lit>(corners), picture, [&](ivec2, double colour) {
    const double beyond = std::max(least - colour, colour - most);
    if (beyond > 0) worst = std::max(worst, beyond / (unit * size));
    if (std::isnan(colour)) worst = wrong;
  });
  return worst;
}

// --- Pixels of neighbours

/// A square of corners on a grid of sixteenths, each pushed about; the colours don't matter.
Input quad(Kind kind, Random& random) {
  Input input;
  const double size = random.uniform(2, 20);
  for (const dvec2 p : {dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    for (const int axis : {0, 1}) {
      const double x = size * (p[axis] + random.uniform(-0.4, 0.4));
      const double steps = kind == Kind::ties ? 2 : 16;
      input.push_back(std::floor(steps * x) / steps);
    }
    input.push_back(0);
  }
  return input;
}

/// Of such a grid, and so that both diagonals part it.
bool is_quad(const Input& i) {
  for (const double x : i) {
    if (!(std::abs(x) <= 1000 && 16 * x == std::floor(16 * x))) return false;
  }
  const auto at = [&](std::size_t k) { return dvec2{i[3 * (k % 4)], i[3 * (k % 4) + 1]}; };
  for (std::size_t k = 0; k < 4; ++k) {
    const dvec2 a = at(k + 1) - at(k), b = at(k + 2) - at(k);
    if (a.x * b.y - a.y * b.x <= 0) return false;
  }
  return true;
}

/// Pixels that are not plotted once: those of the quad whose centres lie inside, by its halves along each
/// diagonal, and by its parts round a point inside.
double partition_error(const Input& i) {
  if (!is_quad(i)) return 0;
  const std::vector<Lit> c = corners_of(i);
  const Lit middle{0.25 * (c[0].at + c[1].at + c[2].at + c[3].at), 0};
  std::map<std::pair<int, int>, int> whole, times;
  const auto shade = [&](const std::vector<Lit>& corners, auto& counts) {
    gouraud(std::span<const Lit>(corners), picture, [&](ivec2 p, double) { ++counts[{p.x, p.y}]; });
  };
  shade(c, whole);
  double errors = 0;
  for (const std::size_t k : {0U, 1U}) {
    times.clear();
    shade({c[k], c[k + 1], c[k + 2]}, times);
    shade({c[k + 2], c[(k + 3) % 4], c[k]}, times);
    errors += times != whole;
  }
  times.clear();
  for (std::size_t k = 0; k < 4; ++k) shade({c[k], c[(k + 1) % 4], middle}, times);
  errors += times != whole;
  // Whole sixteenths: nothing is rounded
  for (int y = picture.lower.y; y <= picture.upper.y; ++y) {
    for (int x = picture.lower.x; x <= picture.upper.x; ++x) {
      double inside = 1;
      for (std::size_t k = 0; k < 4; ++k) {
        const dvec2 way = c[(k + 1) % 4].at - c[k].at, to = dvec2(x, y) + 0.5 - c[k].at;
        inside = std::min(inside, way.x * to.y - way.y * to.x);
      }
      const auto found = whole.find({x, y});
      const int plotted = found == whole.end() ? 0 : found->second;
      errors += plotted > 1 || (inside != 0 && plotted != (inside > 0));
    }
  }
  return errors;
}

// --- Normals

/// The normals of three corners.
Input normals(Kind kind, Random& random) {
  Input input(9);
  for (double& x : input) x = random.uniform(-1, 1);
  for (std::size_t k = 2; k < 9; k += 3) input[k] = random.uniform(0.1, 1);  // on one side
  if (kind == Kind::ties) {
    for (double& x : input) x = std::ceil(2 * x);
  }
  return input;
}

double length_error(const Input& i) {
  std::vector<Corner<double, Surface<double>>> corners;
  constexpr std::array<dvec2, 3> at{dvec2{-9, -7}, {8, -5}, {1, 9}};
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec3 normal{i[3 * k], i[3 * k + 1], i[3 * k + 2]};
    if (!(normal.z > 0 && normal.z <= 1 && std::abs(normal.x) <= 1 && std::abs(normal.y) <= 1)) return 0;
    corners.push_back({at[k], {dvec3(at[k], 0), normal}});
  }
  double worst = 0;
  const auto light = [&](dvec3, dvec3 n) {
    // The length's distance from 1, without the rounding of a root
    const Exact squared = Exact(n.x) * Exact(n.x) + Exact(n.y) * Exact(n.y) + Exact(n.z) * Exact(n.z);
    worst = std::max(worst, std::abs(to_double(squared - Exact(1))) / (2 * unit));
    return 0.0;
  };
  const ExactScope scope;
  phong(std::span<const Corner<double, Surface<double>>>(corners), Window{{-2, -7}, {3, 8}}, light,
        [](ivec2, double) {});
  return worst;
}

/// A vertex at the origin and a ring round it, in turn nearer and farther.
Input fan(Kind kind, Random& random) {
  Input input;
  for (int k = 0; k < 5; ++k) {
    const double angle = 72 * k + random.uniform(-30, 30), reach = random.uniform(0.2, 3);
    const auto [s, c] = sin_cos_degrees(kind == Kind::ties ? 72 * k : angle);
    input.insert(input.end(), {reach * c, reach * s, random.uniform(-0.5, 0.5)});
  }
  return input;
}

/// In units of 8 (k + 2) u, against the same sums in long double.
double vertex_error(const Input& i) {
  using Long = long double;
  using LVec = glm::vec<3, Long>;
  for (const double x : i) {
    if (!(std::abs(x) <= 10)) return 0;
  }
  std::vector<dvec3> places{dvec3{0}};
  for (std::size_t k = 0; k < 5; ++k) places.emplace_back(i[3 * k], i[3 * k + 1], i[3 * k + 2]);
  std::vector<std::vector<int>> faces;
  for (int k = 1; k <= 5; ++k) faces.push_back({0, k, k % 5 + 1});
  double worst = 0;
  for (const Weighting how : {Weighting::plain, Weighting::area, Weighting::angle}) {
    std::vector<dvec3> found(6);
    vertex_normals(std::span<const dvec3>(places), faces, how, std::span(found));
    LVec sum{0};
    Long weights = 0;
    for (const auto& face : faces) {
      const LVec a(places[static_cast<std::size_t>(face[1])]), b(places[static_cast<std::size_t>(face[2])]);
      const LVec cross = glm::cross(a, b);
      const Long length = std::sqrt(glm::dot(cross, cross));
      // A face that is nearly a line has a normal that its own rounding decides
      if (length < 0.05L * std::sqrt(glm::dot(a, a) * glm::dot(b, b)) || length == 0) return 0;
      const Long w = how == Weighting::plain  ? 1
                     : how == Weighting::area ? length / 2
                                              : std::atan2(length, glm::dot(a, b));
      sum += w / length * cross;
      weights += w;
    }
    const Long size = std::sqrt(glm::dot(sum, sum));
    if (size < weights / 4) return 0;
    const LVec off = LVec(found[0]) - sum / size;
    worst = std::max(worst, static_cast<double>(std::sqrt(glm::dot(off, off)) / (8 * 7 * Long(unit))));
  }
  return worst;
}

using Flags = std::vector<std::pair<std::string, std::string>>;

Flags drawn(const Input& i) {
  if (!is_triangle(i)) return {};
  std::string faces, colours;
  for (std::size_t k = 0; k < 9; k += 3) {
    faces += fmt::format("{}{:.17g},{:.17g},0", k > 0 ? " " : "", i[k], i[k + 1]);
    colours += fmt::format("{}{:.17g}", k > 0 ? " " : "", i[k + 2]);
  }
  return {{"faces", faces}, {"intensities", colours}};
}

}  // namespace

Domain polygon_shading() {
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
  return {
      "polygon_shading",
      {{.name = "gouraud",
        .states =
            "a triangle's colours are the exact barycentric ones, within 20 u (1 + max|x| / w) max|colour|",
        .unit = "of u (1 + max|x| / w) max|colour|",
        .bound = 20,
        .numbers = 9,
        .kinds = kinds,
        .generate = triangle,
        .error = gouraud_error,
        .arguments = drawn,
        .traps = {{"a corner in a row of centres", {0, 0.5, 0, 9, 4.5, 1, 0, 9.5, 0.5}},
                  {"corners in a line", {0, 0, 0, 4, 4, 1, 8, 8, 0.5}}},
        .cases = 1'000},
       {.name = "range",
        .states = "no colour lies beyond the corners' by more than 4 u of the largest",
        .unit = "of u times the largest colour",
        .bound = 4,
        .numbers = 9,
        .kinds = kinds,
        .generate = triangle,
        .error = range_error,
        .arguments = drawn,
        .traps = {{"all corners alike", {-9, -9, 0.3, 9, -9, 0.3, 0, 9, 0.3}}}},
       {.name = "partition",
        .states =
            "a quad's pixels are those inside; cut along a diagonal or round a point, each is in one part",
        .unit = "pixels",
        .bound = 0,
        .numbers = 12,
        .kinds = {Kind::random, Kind::ties},
        .generate = quad,
        .error = partition_error,
        .traps = {{"a diagonal through centres", {-4.5, -4.5, 0, 4.5, -4.5, 0, 4.5, 4.5, 0, -4.5, 4.5, 0}}},
        .cases = 2'000},
       {.name = "unit_normals",
        .states = "the normals that light is computed with have length 1 within 6 u",
        .unit = "u",
        .bound = 6,
        .numbers = 9,
        .kinds = {Kind::random, Kind::ties},
        .generate = normals,
        .error = length_error,
        .traps = {{"normals that lean apart", {1, 0, 0.1, -1, 0, 0.1, 0, 1, 0.1}}},
        .cases = 500},
       {.name = "vertex_normals",
        .states = "the normal at a vertex is within 8 (k + 2) u of the sum of its k faces, however weighted",
        .unit = "of 8 (k + 2) u",
        .bound = 1,
        .numbers = 15,
        .kinds = {Kind::random, Kind::ties},
        .generate = fan,
        .error = vertex_error,
        .traps = {{"a plane", {1, 0, 0, 0.3, 1, 0, -0.8, 0.6, 0, -0.8, -0.6, 0, 0.3, -1, 0}}}}}};
}

}  // namespace gradus::stress
