// The promises of exact areas: every pixel against rationals that integrate along edges, bytes, sums,
// polygons side by side, and what is seen in a pixel against slabs in which nothing changes its order.

#include "antialiasing/area_sampling/area_sampling.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <vector>

#include "antialiasing/area_sampling/area_sampling_batch.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "stress/numbers.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace area_sampling;

constexpr int columns_of_sheet = 6, rows_of_sheet = 5;
constexpr Window sheet{{0, 0}, {columns_of_sheet - 1, rows_of_sheet - 1}};
constexpr double far_out = double{farthest} * subpixels;

using Corners = std::vector<ivec2>;
using Pixel = std::pair<int, int>;

// --- The oracle ---

Exact least(Exact a, Exact b) { return a < b ? a : b; }
Exact greatest(Exact a, Exact b) { return a < b ? b : a; }

/// What lies on the right of an edge within a pixel, in 1/256 pixel: the edge goes down from `a` to `b`, and
/// what is asked is the integral of the width from it to the pixel's right side over the pixel's rows.
Exact right_of_edge(ivec2 a, ivec2 b, ivec2 pixel) {
  const Exact left = pixel.x * subpixels, right = left + Exact(subpixels);
  const Exact top = greatest(a.y, pixel.y * subpixels), bottom = least(b.y, (pixel.y + 1) * subpixels);
  if (top >= bottom) return 0;
  const Exact slope = Exact(std::int64_t{b.x} - a.x) / Exact(std::int64_t{b.y} - a.y);
  const auto x_at = [&](Exact y) { return Exact(a.x) + (y - Exact(a.y)) * slope; };
  // The rows at which it passes the pixel's sides part it into pieces where the width is linear
  std::vector<Exact> ys{top, bottom};
  if (a.x != b.x) {
    for (const Exact side : {left, right}) {
      const Exact y = Exact(a.y) + (side - Exact(a.x)) / slope;
      if (top < y && y < bottom) ys.push_back(y);
    }
  }
  std::ranges::sort(ys);
  Exact sum = 0;
  for (std::size_t i = 1; i < ys.size(); ++i) {
    const Exact x = x_at((ys[i - 1] + ys[i]) / Exact(2));
    sum += (ys[i] - ys[i - 1]) * (right - least(greatest(x, left), right));
  }
  return sum;
}
/// The area of a polygon in a pixel.
Exact exact_area(const Corners& polygon, ivec2 pixel) {
  Exact sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ivec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a.y < b.y) sum += right_of_edge(a, b, pixel);
    if (b.y < a.y) sum -= right_of_edge(b, a, pixel);
  }
  return abs(sum) / Exact(subpixels * subpixels);
}
/// The area of all of it, in square pixels.
Exact whole_area(const Corners& polygon) {
  Exact sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ivec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += Exact(a.x) * Exact(b.y) - Exact(a.y) * Exact(b.x);
  }
  return abs(sum) / Exact(2 * subpixels * subpixels);
}

// --- Triangles ---

double coordinate(Kind kind, Random& random) {
  const double ends[] = {-far_out, -256, 0, 128, 256, far_out};
  switch (kind) {
    case Kind::ties:
    case Kind::grazing:
      return 128 * whole(random, -2, 2 * columns_of_sheet + 2);  // corners and middles of pixels
    case Kind::huge:
      return std::round(random.uniform(-far_out, far_out));
    case Kind::extremes:
      return ends[random.uniform_int(0, 5)];
    case Kind::tiny:
      return 256 + whole(random, -2, 2);
    default:
      return whole(random, -300, columns_of_sheet * subpixels + 300);
  }
}
Input triangle(Kind kind, Random& random) {
  Input input(6);
  for (double& x : input) x = coordinate(kind, random);
  if (kind == Kind::near_degenerate) {
    // The third corner beside the line of the others
    const double t = random.uniform(-0.2, 1.2);
    for (std::size_t k = 0; k < 2; ++k)
      input[4 + k] = std::round(input[k] + t * (input[2 + k] - input[k])) + whole(random, -1, 1);
  }
  // An edge along an axis, moved by a little
  if (kind == Kind::grazing) input[2] = input[0] + whole(random, -1, 1);
  if (kind == Kind::refused) input[static_cast<std::size_t>(random.uniform_int(0, 5))] = far_out + 1;
  return input;
}
Corners corners_in(const Input& i, std::size_t first, std::size_t count) {
  Corners corners;
  for (std::size_t k = 0; k < count; ++k) corners.push_back(pixel(i, first + 2 * k));
  return corners;
}
bool is_triangle(const Input& i) { return are_whole(i, 6, -0x1p30, 0x1p30); }
bool is_taken(const Input& i) {
  return std::ranges::all_of(i, [](double x) { return std::abs(x) <= far_out; });
}

/// error(pixel, area or 0 where nothing was plotted, exact area), the worst of all pixels of the sheet.
template <class Error>
double worst_of_pixels(const Corners& corners, Error error) {
  std::map<Pixel, double> found;
  pixel_areas(corners, sheet, [&](ivec2 p, double area) { found[{p.x, p.y}] += area; });
  double worst = 0;
  for (int k = 0; k < columns_of_sheet * rows_of_sheet; ++k) {
    const ExactScope scope;
    const ivec2 p{k % columns_of_sheet, k / columns_of_sheet};
    worst = std::max(worst, error(p, found[{p.x, p.y}], exact_area(corners, p)));
  }
  return worst;
}

/// How far the worst of a triangle's areas is off.
double area_error_of(const Input& i) {
  if (!is_triangle(i)) return 0;
  try {
    const Corners corners = corners_in(i, 0, 3);
    if (!is_taken(i)) {
      pixel_areas(corners, sheet, [](ivec2, double) {});
      return wrong;
    }
    return worst_of_pixels(
        corners, [](ivec2, double area, Exact exact) { return std::abs(to_double(Exact(area) - exact)); });
  } catch (const ContractViolation&) {
    return is_taken(i) ? wrong : 0;
  }
}
/// How many bytes are not those of the exact areas.
double bytes_off(const Corners& corners, const Raster<std::uint8_t>& bytes) {
  double off = 0;
  worst_of_pixels(corners, [&](ivec2 p, double, Exact exact) {
    off += bytes[p] != floor(Exact(255) * exact + Exact(1, 2));
    return 0.0;
  });
  return off;
}
double byte_error(const Input& i) {
  if (!is_triangle(i) || !is_taken(i)) return 0;
  Raster<std::uint8_t> bytes(columns_of_sheet, rows_of_sheet);
  pixel_bytes(corners_in(i, 0, 3), sheet, [&](ivec2 p, std::uint8_t byte) { bytes[p] = byte; });
  return bytes_off(corners_in(i, 0, 3), bytes);
}
/// The same by the scan of whole polygons.
double scan_error(const Input& i) {
  if (!is_triangle(i) || !is_taken(i)) return 0;
  Raster<std::uint8_t> bytes(columns_of_sheet, rows_of_sheet);
  AreaScan().draw(bytes, corners_in(i, 0, 3));
  return bytes_off(corners_in(i, 0, 3), bytes);
}
bool is_sliver(const Input& i) {
  const Wide doubled = doubled_area(corners_in(i, 0, 3));
  return doubled != 0 && -65536 < doubled && doubled < 65536;
}
bool has_edge_along_axis(const Input& i) { return i[0] == i[2] || i[1] == i[3]; }
bool has_tie(const Input& i) {
  bool tie = false;
  const ExactScope scope;
  for (int k = 0; k < columns_of_sheet * rows_of_sheet; ++k)
    tie = tie || exact_area(corners_in(i, 0, 3), {k % columns_of_sheet, k / columns_of_sheet}) == Exact(1, 2);
  return tie;
}
std::vector<std::pair<std::string, std::string>> polygon_argument(const Input& i) {
  if (!is_triangle(i)) return {};
  std::string text;
  for (std::size_t k = 0; k < 6; k += 2)
    text += fmt::format("{}{},{}", k == 0 ? "" : " ", i[k] / subpixels, i[k + 1] / subpixels);
  return {{"polygon", text}};
}

// --- Whole polygons ---

constexpr std::size_t most_corners = 8;

/// A middle, how many corners there are round it, and their distances.
Input star(Kind kind, Random& random) {
  Input input{whole(random, 400, 1100), whole(random, 400, 900), whole(random, 3, most_corners)};
  for (std::size_t k = 0; k < most_corners; ++k)
    input.push_back(kind == Kind::ties
                        ? 128 * whole(random, 1, 3)
                        : whole(random, kind == Kind::tiny ? 1 : 20, kind == Kind::tiny ? 4 : 390));
  return input;
}
/// How far the sum of a polygon's areas is from its own area, relatively.
double sum_error(const Input& i) {
  if (!are_whole(i, i.size(), -2000, 2000) || !is_whole(i[2], 3, most_corners)) return 0;
  const auto count = static_cast<std::size_t>(i[2]);
  if (std::any_of(i.begin() + 3, i.end(), [](double radius) { return radius < 0; })) return 0;
  Corners corners;
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = 6.283185307179586 * static_cast<double>(k) / i[2];
    corners.push_back(pixel(i, 0) + ivec2{static_cast<int>(std::lround(i[3 + k] * std::cos(turn))),
                                          static_cast<int>(std::lround(i[3 + k] * std::sin(turn)))});
  }
  const ExactScope scope;
  const Exact whole_of_it = whole_area(corners);
  if (whole_of_it == Exact(0)) return 0;
  double sum = 0;
  pixel_areas(corners, {{-8, -8}, {16, 16}}, [&](ivec2, double area) { sum += area; });
  return std::abs(to_double((Exact(sum) - whole_of_it) / whole_of_it));
}

// --- Side by side ---

/// A rectangle of 4 x 3 pixels, cut in two from its upper side over a place in it to its lower side.
Input cut_rectangle(Kind kind, Random& random) {
  const int step = kind == Kind::ties ? 128 : kind == Kind::grazing ? 256 : 1;
  Input input;
  for (const int most : {1024, 1024, 1024, 768}) input.push_back(step * whole(random, 0, most / step));
  if (kind == Kind::tiny) input[1] = input[2] = input[0] + whole(random, -1, 1);
  for (double& x : input) x = std::clamp(x, 0.0, 1024.0);
  return input;
}
double abutting_error(const Input& i) {
  if (!are_whole(i, 4, 0, 1024) || i[3] > 768) return 0;
  const ivec2 p(i[0], 0), q(i[1], 768), r(i[2], i[3]);
  const Corners one{{0, 0}, p, r, q, {0, 768}}, other{p, {1024, 0}, {1024, 768}, q, r};
  std::map<Pixel, double> areas;
  std::map<Pixel, std::vector<int>> bytes;
  for (const Corners& half : {one, other}) {
    pixel_areas(half, sheet, [&](ivec2 at, double area) { areas[{at.x, at.y}] += area; });
    pixel_bytes(half, sheet, [&](ivec2 at, std::uint8_t byte) { bytes[{at.x, at.y}].push_back(byte); });
  }
  double worst = areas.size() == 12 ? 0 : wrong;
  for (const auto& [at, area] : areas) worst = std::max(worst, std::abs(area - 1));
  for (const auto& [at, both] : bytes) {
    int sum = 0;
    for (const int byte : both) sum += byte;
    if (sum != 255 && !(sum == 256 && both.size() == 2)) return wrong;
  }
  return worst;
}

// --- What is seen in a pixel ---

constexpr std::size_t fragments_in_pixel = 3;

/// Three triangles with corners near the pixel 0,0 and depths.
Input layers(Kind kind, Random& random) {
  Input input;
  const bool coarse = kind == Kind::ties;
  for (std::size_t k = 0; k < fragments_in_pixel; ++k) {
    for (int c = 0; c < 6; ++c)
      input.push_back(coarse ? 64 * whole(random, -2, 6) : whole(random, -128, 384));
    for (int c = 0; c < 3; ++c) input.push_back(coarse ? whole(random, 0, 4) / 4 : random.unit());
    if (kind != Kind::near_degenerate) continue;
    for (std::size_t axis = 0; axis < 2; ++axis)
      input[9 * k + 4 + axis] =
          std::round((input[9 * k + axis] + input[9 * k + 2 + axis]) / 2) + whole(random, -3, 3);
  }
  return input;
}
ScreenTriangle layer(const Input& i, std::size_t k) {
  return {{pixel(i, 9 * k), pixel(i, 9 * k + 2), pixel(i, 9 * k + 4)},
          {i[9 * k + 6], i[9 * k + 7], i[9 * k + 8]}};
}
template <class T>
std::vector<Fragment<T>> fragments_of(const Input& i) {
  std::vector<Fragment<T>> fragments;
  for (std::size_t k = 0; k < fragments_in_pixel; ++k) {
    if (auto f = fragment_in<T>(layer(i, k), {0, 0}, static_cast<int>(k))) fragments.push_back(*f);
  }
  return fragments;
}
/// A y + B x = C
struct Straight {
  Exact a, b, c;
};
/// What is seen of each fragment, by slabs: between neighbouring columns in which corners, crossings of edges
/// or of edges with lines of equal depth lie, nothing changes its order, and all lengths are linear.
std::map<int, Exact> seen_by_slabs(const std::vector<Fragment<Exact>>& fragments) {
  std::vector<Straight> lines;
  std::set<Exact> columns;
  for (const auto& f : fragments) {
    for (std::size_t k = 0; k < f.outline.size(); ++k) {
      const auto &p = f.outline[k], &q = f.outline[(k + 1) % f.outline.size()];
      columns.insert(p.x);
      const Exact a = q.x - p.x, b = p.y - q.y;
      lines.push_back({a, b, a * p.y + b * p.x});
    }
    for (const auto& g : fragments) {
      if (g.key <= f.key) continue;
      const auto &d = f.depth, &e = g.depth;
      lines.push_back({d.per_row - e.per_row, d.per_column - e.per_column, e.at_corner - d.at_corner});
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Exact det = lines[i].a * lines[k].b - lines[k].a * lines[i].b;
      if (det == Exact(0)) continue;
      const Exact x = (lines[i].a * lines[k].c - lines[k].a * lines[i].c) / det;
      if (Exact(0) < x && x < Exact(1)) columns.insert(x);
    }
  }
  std::map<int, Exact> seen;
  for (auto it = columns.begin(); it != columns.end() && std::next(it) != columns.end(); ++it) {
    const Exact x = (*it + *std::next(it)) / Exact(2), wide = *std::next(it) - *it;
    std::set<Exact> ys;
    for (const Straight& line : lines) {
      if (line.a == Exact(0)) continue;
      const Exact y = (line.c - line.b * x) / line.a;
      if (Exact(0) <= y && y <= Exact(1)) ys.insert(y);
    }
    for (auto y = ys.begin(); y != ys.end() && std::next(y) != ys.end(); ++y) {
      const glm::vec<2, Exact> p{x, (*y + *std::next(y)) / Exact(2)};
      const Fragment<Exact>* nearest = nullptr;
      for (const auto& f : fragments) {
        bool in = true;
        for (std::size_t k = 0; k < f.outline.size() && in; ++k)
          in = doubled_area(f.outline[k], f.outline[(k + 1) % f.outline.size()], p) > Exact(0);
        if (in && (!nearest || f.depth.at(p) < nearest->depth.at(p))) nearest = &f;
      }
      if (!nearest) continue;
      const Exact area = wide * (*std::next(y) - *y);
      const auto [place, is_new] = seen.emplace(nearest->key, area);
      if (!is_new) place->second += area;
    }
  }
  return seen;
}
bool are_layers(const Input& i) {
  for (std::size_t k = 0; k < fragments_in_pixel; ++k) {
    for (std::size_t c = 0; c < 6; ++c) {
      if (!is_whole(i[9 * k + c], -4096, 4096)) return false;
    }
    for (std::size_t c = 6; c < 9; ++c) {
      if (!(0 <= i[9 * k + c] && i[9 * k + c] <= 1)) return false;
    }
  }
  return true;
}
/// How many fragments are seen otherwise than by slabs, in rationals.
double visible_error(const Input& i) {
  if (!are_layers(i)) return 0;
  const ExactScope scope;
  std::vector<Fragment<Exact>> fragments = fragments_of<Exact>(i);
  const std::map<int, Exact> right = seen_by_slabs(fragments);
  std::map<int, Exact> found;
  visible_areas(std::span(fragments),
                [&](const auto& f, const auto&, Exact area) { found.emplace(f.key, area); });
  return found == right ? 0 : 1;
}
/// Whether two planes differ by a thousandth of their depths at some corner of the pixel: then the line where
/// they are equally deep is known in double.
bool are_apart(const Fragment<double>& f, const Fragment<double>& g) {
  double apart = 0, deep = 0;
  for (const dvec2 p : {dvec2(0, 0), dvec2(1, 0), dvec2(1, 1), dvec2(0, 1)}) {
    apart = std::max(apart, std::abs(f.depth.at(p) - g.depth.at(p)));
    deep = std::max({deep, std::abs(f.depth.at(p)), std::abs(g.depth.at(p))});
  }
  return apart >= 1e-3 * deep;
}
/// The same in double: how far an area is off.
double rounded_error(const Input& i) {
  if (!are_layers(i)) return 0;
  const ExactScope scope;
  std::vector<Fragment<Exact>> exact = fragments_of<Exact>(i);
  std::vector<Fragment<double>> fragments = fragments_of<double>(i);
  for (const auto& f : fragments) {
    for (const auto& g : fragments) {
      if (&f != &g && !are_apart(f, g)) return 0;
    }
  }
  std::array<double, fragments_in_pixel> off{};
  visible_areas(std::span(exact), [&](const auto& f, const auto&, Exact area) {
    off[static_cast<std::size_t>(f.key)] -= to_double(area);
  });
  visible_areas(std::span(fragments), [&](const auto& f, const auto&, double area) {
    off[static_cast<std::size_t>(f.key)] += area;
  });
  double worst = 0;
  for (const double x : off) worst = std::max(worst, std::abs(x));
  return worst;
}
bool planes_cross(const Input& i) {
  bool cross = false;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Compared<double>>)
      cross = cross || (!step.before.empty() && !step.behind.empty());
  };
  std::vector<Fragment<double>> fragments = fragments_of<double>(i);
  visible_areas(std::span(fragments), [](const auto&, const auto&, double) {}, watch);
  return cross;
}

}  // namespace

Domain area_sampling() {
  const std::vector<Kind> taken{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
                                Kind::ties,   Kind::extremes};
  std::vector<Kind> with_refused = taken;
  with_refused.push_back(Kind::refused);
  const std::vector<Trap> slivers{{"a sliver of 1/256 across the sheet", {0, 300, 1536, 301, 0, 301}},
                                  {"a sliver through corners of pixels", {0, 0, 1280, 1280, 1280, 1279}},
                                  {"an edge along a border", {256, 0, 256, 1024, 512, 512}},
                                  {"an edge 1/256 before a border", {255, 0, 255, 1024, 0, 512}},
                                  {"halves of pixels, which are ties", {0, 0, 1024, 0, 0, 1024}},
                                  {"nothing but a corner of a pixel", {256, 256, 255, 256, 256, 255}},
                                  {"no area", {0, 0, 256, 256, 1024, 1024}},
                                  {"a corner given twice", {300, 300, 300, 300, 700, 400}},
                                  {"far corners, a thin strip", {-0x1p28, 300, 0x1p28, 301, 0x1p28, 302}}};
  std::vector<Trap> with_far = slivers;
  with_far.push_back({"too far out", {0, 0, far_out + 1, 0, 0, 2048}});
  const auto bytes = [&](const char* name, const char* states, double (*error)(const Input&)) {
    return Property{name,
                    states,
                    "pixels",
                    0,
                    6,
                    taken,
                    triangle,
                    error,
                    polygon_argument,
                    slivers,
                    {{"has a tie", 0.03, has_tie}},
                    2000};
  };
  return {
      "area_sampling",
      {{.name = "areas",
        .states = "the area of a triangle in every pixel within 2^-50 of the rational one; nothing vanishes",
        .unit = "pixels",
        .bound = 0x1p-50,
        .numbers = 6,
        .kinds = with_refused,
        .generate = triangle,
        .error = area_error_of,
        .arguments = polygon_argument,
        .traps = with_far,
        .shares = {{"is a sliver", 0.05, is_sliver}, {"has an edge along an axis", 0.1, has_edge_along_axis}},
        .cases = 2000},
       bytes("bytes", "floor(255 area + 1/2) of the rational area, at every pixel", byte_error),
       bytes("scan", "the same by the scan of whole polygons", scan_error),
       {.name = "sum",
        .states = "the areas of a polygon's pixels add up to its own area within 1e-12 of it",
        .unit = "of the area",
        .bound = 1e-12,
        .numbers = 3 + most_corners,
        .kinds = {Kind::random, Kind::ties, Kind::tiny},
        .generate = star,
        .error = sum_error,
        .cases = 5000},
       {.name = "abutting",
        .states =
            "two polygons that share a border: areas add up to 1 within 2^-50, bytes to 255, or 256 at a tie",
        .unit = "pixels",
        .bound = 0x1p-50,
        .numbers = 4,
        .kinds = {Kind::random, Kind::ties, Kind::grazing, Kind::tiny},
        .generate = cut_rectangle,
        .error = abutting_error,
        .traps = {{"along a border of pixels", {512, 512, 512, 300}},
                  {"1/256 beside it", {513, 511, 512, 300}},
                  {"through corners of pixels", {0, 768, 256, 256}},
                  {"halves", {128, 128, 128, 384}},
                  {"nothing on one side", {0, 0, 0, 0}}},
        .cases = 20'000},
       {.name = "visible",
        .states = "in rationals, what is seen of three triangles is what slabs of constant order say",
        .unit = "pixels",
        .bound = 0,
        .numbers = 9 * fragments_in_pixel,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::ties},
        .generate = layers,
        .error = visible_error,
        .shares = {{"planes cross", 0.2, planes_cross}},
        .cases = 100},
       {.name = "rounded",
        .states = "in double, what is seen of three triangles is within 1e-12 of that",
        .unit = "pixels",
        .bound = 1e-12,
        .numbers = 9 * fragments_in_pixel,
        .kinds = {Kind::random, Kind::near_degenerate},
        .generate = layers,
        .error = rounded_error,
        .shares = {{"planes cross", 0.2, planes_cross}},
        .cases = 1000}}};
}

}  // namespace gradus::stress
