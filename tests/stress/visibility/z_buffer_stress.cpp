// The promises of the z-buffer: the nearest of all, whatever their order.

#include "visibility/z_buffer/z_buffer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

constexpr std::size_t count = 4;

/// Four depths, then their keys.
Input generate(Kind kind, Random& random) {
  Input input(2 * count);
  for (double& x : input) x = number(kind, random);
  for (std::size_t k = 0; k < count; ++k) {
    if (kind == Kind::near_degenerate) input[k] = nudged(input[0], random);
    if (kind == Kind::grazing && k % 2) input[k] = input[k - 1];
    input[count + k] = static_cast<double>(random.uniform_int(0, 3));
  }
  return input;
}

/// A key that is no number is beyond the promise. In every order the cell must end with the least depth, of
/// equal ones the one with the least key.
double error(const Input& i) {
  if (std::any_of(i.begin() + count, i.end(), [](double key) { return std::isnan(key); })) return 0;
  std::optional<std::pair<double, double>> least;
  for (std::size_t k = 0; k < count; ++k) {
    const std::pair candidate(i[k], i[count + k]);
    if (!std::isnan(i[k]) && (!least || candidate < *least)) least = candidate;
  }
  std::array<std::size_t, count> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    Raster<z_buffer::Cell<double, double>> buffer(2, 1);
    for (const std::size_t k : order) z_buffer::keep_nearest(buffer, {1, 0}, i[k], i[count + k]);
    const auto& cell = buffer[{1, 0}];
    if (cell.taken != least.has_value() || buffer[{0, 0}].taken) return wrong;
    if (least && (cell.depth != least->first || cell.key != least->second)) return wrong;
  } while (std::next_permutation(order.begin(), order.end()));
  return 0;
}

// --- Faces

constexpr std::size_t faces = 3;
constexpr int size = 8;

/// Three sloped rectangles: left, top, right and bottom in eighths of a pixel, then the depths of three
/// corners.
Input generate_faces(Kind kind, Random& random) {
  Input input;
  for (std::size_t k = 0; k < faces; ++k) {
    const auto place = [&] { return static_cast<double>(random.uniform_int(-8, 8 * size + 8)); };
    const auto depth = [&] { return static_cast<double>(random.uniform_int(0, 40)) / 8; };
    Input face{place(), place(), place(), place(), depth(), depth(), depth()};
    if (kind == Kind::ties && k > 0) std::copy_n(input.end() - 3, 3, face.begin() + 4);
    if (kind == Kind::grazing) face[2] = face[0] + 1;
    input.insert(input.end(), face.begin(), face.end());
  }
  return input;
}

/// A face as whole numbers say it, and what the oracle knows of it without Newell's normal or edges.
struct Sloped {
  std::array<double, 7> n;
  std::array<dvec3, 4> corners() const {
    const double left = n[0] / 8, top = n[1] / 8, right = n[2] / 8, bottom = n[3] / 8;
    return {dvec3{left, top, n[4]},
            {right, top, n[5]},
            {right, bottom, n[5] + n[6] - n[4]},
            {left, bottom, n[6]}};
  }
  /// Centres on a left or an upper side belong to it.
  bool holds(ivec2 p) const {
    const double x = 8 * p.x + 4, y = 8 * p.y + 4;
    return std::min(n[0], n[2]) <= x && x < std::max(n[0], n[2]) && std::min(n[1], n[3]) <= y &&
           y < std::max(n[1], n[3]);
  }
  double depth(ivec2 p) const {
    const double s = (8 * p.x + 4 - n[0]) / (n[2] - n[0]), t = (8 * p.y + 4 - n[1]) / (n[3] - n[1]);
    return n[4] + s * (n[5] - n[4]) + t * (n[6] - n[4]);
  }
};

bool is_scene(const Input& i) {
  return std::ranges::all_of(i, [](double x) { return x == std::floor(x * 8) / 8 && std::abs(x) <= 80; });
}
std::array<Sloped, faces> faces_of(const Input& i) {
  std::array<Sloped, faces> all{};
  for (std::size_t k = 0; k < faces; ++k)
    std::copy_n(i.begin() + static_cast<std::ptrdiff_t>(7 * k), 7, all[k].n.begin());
  return all;
}

using Depths = Raster<z_buffer::Cell<double, z_buffer::Id>>;

/// How far the depths lie from the least one of those that hold the centre; `wrong` where the face is none of
/// them, or another order leaves anything else.
double error_of_faces(const Input& i) {
  if (!is_scene(i)) return 0;
  const auto sloped = faces_of(i);
  std::array<std::array<dvec3, 4>, faces> corners;
  std::vector<z_buffer::Face> all;
  for (std::size_t k = 0; k < faces; ++k) {
    corners[k] = sloped[k].corners();
    all.push_back({corners[k], {0, static_cast<int>(k)}});
  }
  Depths buffer(size, size);
  z_buffer::per_polygon<double>(all, buffer);
  double worst = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      std::optional<double> least;
      for (const Sloped& face : sloped) {
        if (face.holds({x, y})) least = std::min(least.value_or(1e9), face.depth({x, y}));
      }
      const auto& cell = buffer[{x, y}];
      if (cell.taken != least.has_value()) return wrong;
      if (!least) continue;
      const Sloped& shown = sloped[static_cast<std::size_t>(cell.key.face)];
      if (!shown.holds({x, y})) return wrong;
      worst = std::max({worst, std::abs(cell.depth - *least), std::abs(shown.depth({x, y}) - *least)});
    }
  }
  std::vector<z_buffer::Face> order = all;
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  do {
    Depths other(size, size);
    z_buffer::per_polygon<double>(order, other);
    for (std::size_t k = 0; k < buffer.cells().size(); ++k) {
      const auto &a = buffer.cells()[k], &b = other.cells()[k];
      if (a.taken != b.taken || a.depth != b.depth || a.key != b.key) return wrong;
    }
  } while (std::ranges::next_permutation(order, by_id).found);
  return worst;
}

/// Pixels whose face row by row is another than face by face, with depths of 24 bits.
double error_of_rows(const Input& i) {
  if (!is_scene(i)) return 0;
  const auto sloped = faces_of(i);
  std::array<std::array<dvec3, 4>, faces> corners;
  std::vector<z_buffer::Face> all;
  for (std::size_t k = 0; k < faces; ++k) {
    corners[k] = sloped[k].corners();
    all.push_back({corners[k], {0, static_cast<int>(k)}});
  }
  using Codes = z_buffer::Cell<std::int32_t, z_buffer::Id>;
  const z_buffer::AsFixed24 store{{-80, 160}};
  Raster<Codes> buffer(size, size);
  z_buffer::per_polygon<std::int32_t>(all, buffer, store);
  std::vector<Codes> line(size);
  std::ptrdiff_t right = 0;
  z_buffer::scanline<std::int32_t>(
      all, buffer.window(), std::span(line), store,
      [&](ivec2 p, z_buffer::Id id) { right += buffer[p].taken && buffer[p].key == id; });
  return static_cast<double>(std::ranges::count_if(buffer.cells(), &Codes::taken) - right);
}

// --- Faces in one plane

/// Left, top, right and bottom of three rectangles in eighths of a pixel, then a plane: its depth at the
/// picture's first corner and how it grows per pixel, in eighths.
Input generate_coplanar(Kind kind, Random& random) {
  Input input;
  for (std::size_t k = 0; k < 4 * faces; ++k)
    input.push_back(static_cast<double>(random.uniform_int(-8, 8 * size + 8)));
  // Rectangles that share a border, or all of it
  if (kind == Kind::grazing) input[4] = input[2];
  if (kind == Kind::ties) std::copy_n(input.begin(), 4, input.begin() + 8);
  for (const int most : {40, 16, 16}) {
    const auto eighths = random.uniform_int(kind == Kind::ties && most == 16 ? 0 : -most, most);
    input.push_back(static_cast<double>(eighths) / 8);
  }
  return input;
}

/// All depths of a centre are equal and exact: wherever rectangles overlap the first of them must be seen, in
/// every order and by both walks. Counts the pixels that show another.
double error_of_ties(const Input& i) {
  if (!is_scene(i)) return 0;
  const double depth = i[4 * faces], right = i[4 * faces + 1], down = i[4 * faces + 2];
  std::array<std::array<dvec3, 4>, faces> corners;
  std::array<Sloped, faces> sloped{};
  std::vector<z_buffer::Face> all;
  for (std::size_t k = 0; k < faces; ++k) {
    const auto at = [&](double x, double y) {
      return dvec3{x / 8, y / 8, depth + right * x / 8 + down * y / 8};
    };
    const double* n = &i[4 * k];
    corners[k] = {at(n[0], n[1]), at(n[2], n[1]), at(n[2], n[3]), at(n[0], n[3])};
    std::copy_n(n, 4, sloped[k].n.begin());
    all.push_back({corners[k], {0, static_cast<int>(k)}});
  }
  std::int64_t off = 0;
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  do {
    Depths buffer(size, size);
    z_buffer::per_polygon<double>(all, buffer);
    Raster<int> rows(size, size, -1);
    std::vector<z_buffer::Cell<double, z_buffer::Id>> line(size);
    z_buffer::scanline<double>(all, buffer.window(), std::span(line), z_buffer::Exactly{},
                               [&](ivec2 p, z_buffer::Id id) { rows[p] = id.face; });
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const ivec2 p{x, y};
        const auto first = std::ranges::find_if(sloped, [&](const Sloped& face) { return face.holds(p); });
        const int right_one = first == sloped.end() ? -1 : static_cast<int>(first - sloped.begin());
        const int shown = buffer[p].taken ? buffer[p].key.face : -1;
        off += (shown != right_one) + (rows[p] != right_one);
      }
    }
  } while (std::ranges::next_permutation(all, by_id).found);
  return static_cast<double>(off);
}

}  // namespace

Domain z_buffer() {
  return {"z_buffer",
          {{.name = "keep_nearest",
            .states = "the least depth, of equal ones the least key, in every order; NaN is never kept",
            .unit = "decisions",
            .bound = 0,
            .numbers = 2 * count,
            .generate = at_every_scale(generate, {0, 1, 2, 3}),
            .error = error,
            .traps = {{"no number comes first", {std::nan(""), 1, 0.5, 1, 0, 1, 2, 3}},
                      {"nothing but what is no number",
                       {std::nan(""), std::nan(""), std::nan(""), std::nan(""), 0, 1, 2, 3}},
                      {"zeros of both signs", {0.0, -0.0, 0.0, -0.0, 3, 2, 1, 0}},
                      {"infinite depths", {wrong, -wrong, wrong, 0, 0, 1, 2, 3}},
                      {"depths that differ in the last place", {1, 1 + 0x1p-52, 1, 1 - 0x1p-53, 3, 0, 1, 2}}},
            .shares = {{"two depths are equal", 0.2,
                        [](const Input& i) {
                          Input depths(i.begin(), i.begin() + count);
                          if (std::ranges::any_of(depths, [](double x) { return std::isnan(x); }))
                            return false;
                          std::ranges::sort(depths);
                          return std::ranges::adjacent_find(depths) != depths.end();
                        }}}},
           {.name = "per_polygon",
            .states = "each pixel's least depth, the same in every order of the faces",
            .unit = "depths",
            .bound = 1e-12,
            .numbers = 7 * faces,
            .kinds = {Kind::random, Kind::ties, Kind::grazing},
            .generate = generate_faces,
            .error = error_of_faces,
            .traps = {{"faces in one plane",
                       {0, 0, 40, 40, 2, 3, 4, 0, 0, 40, 40, 2, 3, 4, 0, 0, 40, 40, 2, 3, 4}},
                      {"piercing", {0, 0, 64, 64, 0, 5, 0, 0, 0, 64, 64, 5, 0, 5, 0, 0, 64, 64, 0, 0, 5}},
                      {"no area", {8, 8, 8, 40, 1, 1, 1, 4, 4, 4, 4, 0, 0, 0, 0, 0, 64, 64, 3, 3, 3}}}},
           {.name = "coplanar",
            .states =
                "faces in one plane: where they overlap the first is seen, in every order and by both walks",
            .unit = "pixels",
            .bound = 0,
            .numbers = 4 * faces + 3,
            .kinds = {Kind::random, Kind::ties, Kind::grazing},
            .generate = generate_coplanar,
            .error = error_of_ties,
            .traps = {{"the same face three times, sloped",
                       {0, 0, 40, 40, 0, 0, 40, 40, 0, 0, 40, 40, 3, 0.125, -0.25}},
                      {"the same face turned round", {0, 0, 40, 40, 40, 0, 0, 40, 0, 40, 40, 0, 3, 2, 2}},
                      {"side by side along a centre", {0, 0, 20, 40, 20, 0, 40, 40, 4, 4, 36, 36, 1, 0, 0}}}},
           {.name = "scanline",
            .states = "row by row the same picture, with 24-bit depths",
            .unit = "pixels",
            .bound = 0,
            .numbers = 7 * faces,
            .kinds = {Kind::random, Kind::ties, Kind::grazing},
            .generate = generate_faces,
            .error = error_of_rows,
            .traps = {{"faces in one plane",
                       {0, 0, 40, 40, 2, 3, 4, 0, 0, 40, 40, 2, 3, 4, 0, 0, 40, 40, 2, 3, 4}}}}}};
}

}  // namespace gradus::stress
