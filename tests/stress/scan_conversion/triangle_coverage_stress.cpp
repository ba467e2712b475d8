// The promises of triangles as pixels: the nearest grid place for a corner, every centre to one triangle, and
// what is linear on them.

#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

#include <optional>
#include <vector>

#include "stress/numbers.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace triangle_coverage;
__extension__ using Wide = __int128;

constexpr double limit = double{farthest} * subpixels;
constexpr int columns = 24, rows = 16;
constexpr Window sheet{{0, 0}, {columns - 1, rows - 1}};

using Hits = std::array<int, std::size_t{columns} * rows>;

/// Of each pixel of the sheet a number.
template <class Number>
Hits of_centres(Number number) {
  Hits all{};
  for (int i = 0; i < columns * rows; ++i) {
    all[static_cast<std::size_t>(i)] = number(centre_of({i % columns, i / columns}));
  }
  return all;
}

// --- The oracle, in 128 bits ---

int sign(Wide x) { return (x > 0) - (x < 0); }
Wide edge_function(ivec2 a, ivec2 b, ivec2 p) {
  return Wide{p.x} * (Wide{a.y} - b.y) + Wide{p.y} * (Wide{b.x} - a.x) + Wide{a.x} * b.y - Wide{a.y} * b.x;
}
/// The side of the line from a to b on which the centre lies when it is moved to the right by something
/// infinitely small, and down by something infinitely smaller: never 0 unless a == b. The top-left rule says
/// the same without moving anything.
int side(ivec2 a, ivec2 b, ivec2 centre) {
  const Wide on = edge_function(a, b, centre);
  if (on != 0) return sign(on);
  return a.y != b.y ? sign(Wide{a.y} - b.y) : sign(Wide{b.x} - a.x);
}
bool inside(const Triangle& t, ivec2 centre) {
  const int a = side(t[0], t[1], centre);
  return a != 0 && a == side(t[1], t[2], centre) && a == side(t[2], t[0], centre);
}
/// How often a closed polygon winds round a centre, moved as above: the crossings of a ray to the left.
int winding(const std::vector<ivec2>& polygon, ivec2 centre) {
  int number = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ivec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const bool a_below = a.y > centre.y, b_below = b.y > centre.y;  // at the same height: the centre is lower
    if (a_below == b_below) continue;
    if (b_below && side(a, b, centre) < 0) --number;  // the edge goes down, to the left of the centre
    if (a_below && side(a, b, centre) > 0) ++number;
  }
  return number;
}

// --- Triangles ---

/// A corner's coordinate in 1/256 pixel.
double coordinate(Kind kind, Random& random) {
  const double ends[] = {-limit, -limit + 128, 0, 128, limit - 128, limit};
  switch (kind) {
    case Kind::ties:
    case Kind::grazing:
      return 128 * whole(random, -2, 2 * columns + 2);  // centres, sides and corners of pixels
    case Kind::huge:
      return std::round(random.uniform(-limit, limit));
    case Kind::extremes:
      return ends[random.uniform_int(0, 5)];
    case Kind::tiny:
      return 128 + whole(random, -2, 2);
    default:
      return whole(random, -1000, columns * subpixels + 1000);
  }
}
Input corners(std::size_t count, Kind kind, Random& random) {
  Input input(2 * count);
  for (double& x : input) x = coordinate(kind, random);
  return input;
}

/// Three corners.
Input triangle(Kind kind, Random& random) {
  Input input = corners(3, kind, random);
  // Mixed now and then
  if (random.unit() < 0.25)
    input[4] = coordinate(Kind::huge, random), input[5] = coordinate(Kind::random, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third corner on the line of the others, or next to it
    const double t = kind == Kind::grazing ? whole(random, -2, 3) : random.uniform(-0.5, 1.5);
    for (std::size_t k = 0; k < 2; ++k) {
      const double on = std::round(input[k] + t * (input[2 + k] - input[k]));
      input[4 + k] = std::clamp(on + whole(random, -1, 1), -limit, limit);
    }
  }
  if (kind == Kind::refused) input[static_cast<std::size_t>(random.uniform_int(0, 5))] = limit + 1;
  return input;
}
Triangle triangle_of(const Input& i) { return {pixel(i, 0), pixel(i, 2), pixel(i, 4)}; }
bool is_triangle(const Input& i) { return are_whole(i, 6, -0x1p30, 0x1p30); }
Wide area(const Triangle& t) { return edge_function(t[0], t[1], t[2]); }

/// What is plotted; nothing where the weights aren't what they are said to be.
std::optional<Hits> covered(const Triangle& t) {
  Hits hits{};
  bool right = true;
  const Wide all = area(t) < 0 ? -area(t) : area(t);
  cover(t, sheet, [&](ivec2 p, const Weights& w) {
    ++hits[static_cast<std::size_t>(p.y * columns + p.x)];
    right = right && std::min({w[0], w[1], w[2]}) >= 0 && Wide{w[0]} + w[1] + w[2] == all;
  });
  return right ? std::optional(hits) : std::nullopt;
}

/// How many pixels of a window are covered although their centres are outside, or the other way round.
double cover_error(const Input& i) {
  if (!is_triangle(i)) return 0;
  const Triangle t = triangle_of(i);
  const bool taken = std::ranges::all_of(i, [](double x) { return std::abs(x) <= limit; });
  try {
    const std::optional<Hits> hits = covered(t);
    const bool same = covered({t[1], t[2], t[0]}) == hits && covered({t[2], t[1], t[0]}) == hits;
    if (!taken || !hits || !same) return wrong;
    const Hits right = of_centres([&](ivec2 centre) { return inside(t, centre) && area(t) != 0; });
    double error = 0;
    for (std::size_t k = 0; k < right.size(); ++k) error += std::abs((*hits)[k] - right[k]);
    return error;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}
bool is_sliver(const Input& i) {
  const Wide doubled = area(triangle_of(i));
  return doubled != 0 && -65536 < doubled && doubled < 65536;
}
bool is_far(const Input& i) {
  return std::ranges::any_of(i, [](double x) { return std::abs(x) > 100'000.0 * subpixels; });
}
/// A corner or the middle of a side lies on a centre.
bool has_tie(const Input& i) {
  const auto on_centre = [](double x) { return std::fmod(x, subpixels) == subpixels / 2; };
  return (on_centre(i[0]) && on_centre(i[1])) ||
         (on_centre((i[0] + i[2]) / 2) && on_centre((i[1] + i[3]) / 2));
}

// --- Meshes ---

constexpr std::size_t most_corners = 9;

/// A hub, how many corners there are round it, whether they are in order as in a mesh, and the corners.
Input fan(Kind kind, Random& random) {
  Input input = corners(1, kind == Kind::huge || kind == Kind::extremes ? Kind::ties : kind, random);
  input.push_back(whole(random, 3, most_corners));
  input.push_back(whole(random, 0, 1));
  const Input rim = corners(most_corners, kind, random);
  input.insert(input.end(), rim.begin(), rim.end());
  return input;
}

/// Triangles from a hub to the edges of a closed polygon share an edge each with the next. Counted with their
/// orientation they cover every pixel as often as the polygon winds round it, whatever the polygon.
double fan_error(const Input& i) {
  if (!are_whole(i, i.size(), -limit, limit) || !is_whole(i[2], 3, most_corners)) return 0;
  const ivec2 hub = pixel(i, 0);
  std::vector<ivec2> rim;
  for (std::size_t k = 0; k < static_cast<std::size_t>(i[2]); ++k) rim.push_back(pixel(i, 4 + 2 * k));
  if (i[3] != 0) {
    std::ranges::sort(rim, {}, [&](ivec2 p) { return std::atan2(p.y - double(hub.y), p.x - double(hub.x)); });
  }
  Hits sum{};
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Triangle t{hub, rim[k], rim[(k + 1) % rim.size()]};
    const int way = doubled_area(t) > 0 ? 1 : -1;
    cover(t, sheet,
          [&](ivec2 p, const Weights&) { sum[static_cast<std::size_t>(p.y * columns + p.x)] += way; });
  }
  return sum == of_centres([&](ivec2 centre) { return winding(rim, centre); }) ? 0 : wrong;
}

// --- What is linear ---

/// A triangle, and of each corner w, an attribute and a depth.
Input attributes(Kind kind, Random& random) {
  Input input = triangle(kind, random);
  for (int k = 0; k < 3; ++k) input.push_back(random.uniform(0.1, 4));
  for (int k = 0; k < 6; ++k) input.push_back(random.unit());
  return input;
}

/// How far attributes and depths are from those of the snapped corners, in long double; wrong where a depth
/// depends on the corners' numbers.
double attribute_error(const Input& i) {
  const bool taken = are_whole(i, 6, -limit, limit) &&
                     std::all_of(i.begin() + 6, i.begin() + 9, [](double w) { return 0.1 <= w && w <= 4; }) &&
                     std::all_of(i.begin() + 9, i.end(), [](double x) { return 0 <= x && x <= 1; });
  if (!taken) return 0;
  const Triangle t = triangle_of(i);
  const dvec3 w{i[6], i[7], i[8]}, a{i[9], i[10], i[11]}, z{i[12], i[13], i[14]};
  const Linear depth(t, z), turned({t[1], t[2], t[0]}, {z.y, z.z, z.x}),
      back({t[2], t[1], t[0]}, {z.z, z.y, z.x}), level(t, dvec3{z.x});
  long double worst = 0;
  cover(t, sheet, [&](ivec2 p, const Weights& weights) {
    std::array<long double, 3> l{};
    for (std::size_t k = 0; k < 3; ++k) {
      l[k] = static_cast<long double>(edge_function(t[(k + 1) % 3], t[(k + 2) % 3], centre_of(p))) /
             static_cast<long double>(area(t));
    }
    const long double over = l[0] / w.x + l[1] / w.y + l[2] / w.z;
    const long double attribute = (l[0] / w.x * a.x + l[1] / w.y * a.y + l[2] / w.z * a.z) / over;
    const double found = depth.at(weights);
    const auto [p0, p1, p2] = weights;
    const bool same =
        turned.at({p1, p2, p0}) == found && back.at({p2, p1, p0}) == found && level.at(weights) == z.x;
    worst = std::max({worst, std::abs(glm::dot(perspective_correct(weights, 1.0 / w), a) - attribute),
                      std::abs(found - (l[0] * z.x + l[1] * z.y + l[2] * z.z)),
                      std::abs(glm::dot(barycentric(weights), z) - (l[0] * z.x + l[1] * z.y + l[2] * z.z)),
                      static_cast<long double>(same ? 0 : wrong)});
  });
  return static_cast<double>(worst);
}

// --- Snapping ---

Input place(Kind kind, Random& random) {
  Input input{number(kind, random), number(kind, random)};
  if (kind != Kind::grazing && kind != Kind::ties) return input;
  // Midway, or a little beside it
  for (double& x : input) {
    x = (std::floor(random.uniform(-0x1p28, 0x1p28)) + 0.5) / subpixels;
    if (kind == Kind::grazing) x = nudged(x, random);
  }
  return input;
}
/// How far a place is moved, in 1/256 pixel; midway it must go to the smaller one.
double snap_error(const Input& i) {
  const bool taken = std::abs(i[0]) <= farthest && std::abs(i[1]) <= farthest;
  if (can_snap({i[0], i[1]}) != taken) return wrong;
  try {
    const ivec2 found = snap({i[0], i[1]});
    if (!taken) return wrong;
    double worst = 0;
    for (const int k : {0, 1}) {
      // Exact: both lie on the grid of the smaller one's last place, or the place is tiny
      const double moved = found[k] - i[static_cast<std::size_t>(k)] * subpixels;
      if (moved == 0.5) return wrong;
      worst = std::max(worst, std::abs(moved));
    }
    return worst;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

}  // namespace

Domain triangle_coverage() {
  const std::vector<Kind> taken{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
                                Kind::ties,   Kind::extremes};
  std::vector<Kind> with_refused = taken;
  with_refused.push_back(Kind::refused);
  return {
      "triangle_coverage",
      {{.name = "cover",
        .states = "exactly the pixels whose centres the triangle owns, by 128 bits, however its corners are "
                  "numbered; weights add up to its area",
        .unit = "pixels",
        .bound = 0,
        .numbers = 6,
        .kinds = with_refused,
        .generate = triangle,
        .error = cover_error,
        .traps = {{"a product of 2^31", {0, 0, 65536, 0, 0, 32768}},
                  {"products of 1e16 that cancel", {-1e8, -1e8, 1e8, 1e8, 1e8, -1e8}},
                  {"corners on pixel centres", {128, 128, 1152, 128, 128, 1152}},
                  {"one half of a square", {0, 0, 2048, 0, 2048, 2048}},
                  {"the other half of the square", {0, 0, 2048, 2048, 0, 2048}},
                  {"a corner on another's side", {0, 0, 1024, 1024, 2048, 0}},
                  {"clockwise", {0, 0, 0, 2048, 2048, 0}},
                  {"no area", {0, 0, 256, 256, 1024, 1024}},
                  {"a sliver", {0, 0, 4096, 1, 2048, 1}},
                  {"too far out", {0, 0, limit + 1, 0, 0, 2048}}},
        .shares = {{"is a sliver", 0.01, is_sliver}, {"is far", 0.25, is_far}, {"has a tie", 0.08, has_tie}},
        .cases = 100'000},
       {.name = "shared_edges",
        .states = "no gap and no double hit: triangles round a hub cover what their rim winds round",
        .unit = "fans",
        .bound = 0,
        .numbers = 4 + 2 * most_corners,
        .kinds = taken,
        .generate = fan,
        .error = fan_error,
        .cases = 20'000},
       {.name = "attributes",
        .states = "attributes in perspective, and depths, within 1e-15, however the corners are numbered",
        .unit = "",
        .bound = 1e-15,
        .numbers = 15,
        .kinds = taken,
        .generate = attributes,
        .error = attribute_error,
        .cases = 20'000},
       {.name = "snap",
        .states = "the nearest place on the grid, midway the smaller one",
        .unit = "of 1/256 pixel",
        .bound = 0.5,
        .numbers = 2,
        .generate = place,
        .error = snap_error,
        .traps = {{"midway", {0.5 / 256, -0.5 / 256}},
                  {"midway but for an ulp", {std::nextafter(0.5 / 256, 1), std::nextafter(0.5 / 256, 0)}},
                  {"a place that is no number", {std::nan(""), 0}},
                  {"as far as may be", {farthest, -farthest}}}}}};
}

}  // namespace gradus::stress
