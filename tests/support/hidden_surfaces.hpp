#pragma once
// What methods for hidden surfaces are compared by: seeded scenes, a camera, the picture that each method
// makes of them, and rays through the pixels' centres, which share no step with any.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "core/raster.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"
#include "visibility/painter/painter.hpp"
#include "visibility/z_buffer/z_buffer.hpp"

namespace gradus::test {

using Polygons = std::vector<bsp_tree::Polygon<double>>;

/// The number of the face that each pixel shows.
using Picture = Raster<int>;
inline constexpr int nobody = -1;

// --- Scenes: x to the right, y down, z away from the viewer, everything in front of him

/// Every corner is a multiple of this: sums and turned boxes are exact, so that faces are flat.
inline constexpr double grid = 0x1p-16;
inline dvec3 on_grid(dvec3 p) { return glm::floor(p / grid + 0.5) * grid; }

/// A place of what is seen.
inline dvec3 anywhere(Random& random) {
  return on_grid({random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(5, 9)});
}

/// Half the edges of a box about a middle.
struct Box {
  dvec3 middle;
  std::array<dvec3, 3> half;
};

/// A box with edges of twice these lengths, about, turned by a rotation of whole numbers over one.
inline Box turned(dvec3 middle, dvec3 half, glm::dquat whole) {
  const double k = glm::dot(whole, whole);
  const glm::dmat3 turn = glm::mat3_cast(whole / std::sqrt(k));
  Box box{middle, {}};
  for (int i = 0; i < 3; ++i) {
    const double length = std::floor(half[i] / k / grid + 0.5) * grid;
    box.half[static_cast<std::size_t>(i)] = glm::floor(turn[i] * k + 0.5) * length;
  }
  return box;
}
inline glm::dquat any_turn(Random& random) {
  const auto number = [&] { return static_cast<double>(random.uniform_int(-3, 3)); };
  return {number(), number(), number(), 1};
}
/// Turned a little away from facing the viewer.
inline glm::dquat slight_turn(Random& random) {
  const auto sign = [&] { return static_cast<double>(random.uniform_int(-1, 1)); };
  return {static_cast<double>(random.uniform_int(9, 20)), sign(), sign(), 0};
}

inline void add_face(Polygons& scene, std::vector<dvec3> corners) {
  scene.push_back({std::move(corners), scene.size()});
}
/// The face of a box across one of its axes, counter-clockwise seen from outside.
inline void add_side(Polygons& scene, const Box& box, std::size_t axis, double sign) {
  const dvec3 at = box.middle + sign * box.half[axis];
  const dvec3 u = box.half[(axis + 1) % 3], v = sign * box.half[(axis + 2) % 3];
  add_face(scene, {at - u - v, at + u - v, at + u + v, at - u + v});
}
/// A box, or the sheet in the middle of it.
inline void add(Polygons& scene, const Box& box, bool solid) {
  if (!solid) return add_side(scene, {box.middle, {box.half[0], box.half[1], dvec3(0)}}, 2, 1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) add_side(scene, box, axis, sign);
  }
}

/// Three bars, each over the next as in the notes, a fourth of their size.
inline void add_cycle(Polygons& scene, dvec3 at, bool solid) {
  const std::array<dvec3, 3> ends{dvec3{0, 0, 0}, {2.5, 0, 0}, {1.25, 2, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 from = ends[i], to = ends[(i + 1) % 3] + dvec3{0, 0, 0.5};
    const dvec3 way = to - from, aside{-way.y, way.x, 0};
    const Box bar{on_grid(at + (from + to) / 2.0),
                  {on_grid(way * 0.625), on_grid(aside * (0.25 / glm::length(aside))), {0, 0, 0.0625}}};
    add(scene, bar, solid);
  }
}

enum class Kind { few_large, many_small, heavy_overdraw, cyclic };
inline constexpr std::array kinds{Kind::few_large, Kind::many_small, Kind::heavy_overdraw, Kind::cyclic};
constexpr const char* name_of(Kind kind) {
  constexpr const char* names[]{"few large", "many small", "heavy overdraw", "cyclic"};
  return names[static_cast<std::size_t>(kind)];
}

/// Sheets, which pierce each other; or closed boxes, of which back faces can be left out.
inline Polygons scene_of(Kind kind, Random& random, bool solid = false) {
  Polygons scene;
  const auto any_box = [&](double least, double most) {
    const glm::dquat turn = any_turn(random);
    const dvec3 half{random.uniform(least, most), random.uniform(least, most), random.uniform(least, most)};
    return turned(anywhere(random), half, turn);
  };
  switch (kind) {
    case Kind::few_large:
      for (int i = 0; i < (solid ? 4 : 9); ++i) add(scene, any_box(0.7, 1.8), solid);
      break;
    case Kind::many_small:
      for (int i = 0; i < (solid ? 40 : 80); ++i) add(scene, any_box(0.25, 0.6), solid);
      break;
    case Kind::heavy_overdraw:
      for (int i = 0; i < 20; ++i) {
        const dvec3 middle = on_grid({random.uniform(-1, 1), random.uniform(-1, 1), 5 + 0.2 * (7 * i % 20)});
        const dvec3 half{random.uniform(1.2, 2.2), random.uniform(1.2, 2.2), 0.05};
        add(scene, turned(middle, half, slight_turn(random)), solid);
      }
      break;
    case Kind::cyclic:
      for (const dvec2 at : {dvec2{-2.9, -2.7}, {0.3, -2.6}, {-1.4, 0.4}})
        add_cycle(scene, on_grid({at, random.uniform(5, 7)}), solid);
      for (int i = 0; i < 2; ++i) add(scene, any_box(0.5, 1.2), solid);
  }
  return scene;
}

/// Closed boxes of this kind, always the same: what is measured.
inline Polygons boxes(Kind kind) {
  Random random(7, static_cast<std::uint64_t>(kind));
  return scene_of(kind, random, true);
}
/// So many small ones.
inline Polygons small_boxes(int count) {
  Random random(7, static_cast<std::uint64_t>(count));
  Polygons scene;
  for (int i = 0; i < count; ++i) {
    const double size = random.uniform(0.1, 0.3);
    const glm::dquat turn = any_turn(random);
    add(scene, turned(anywhere(random), {size, size, size}, turn), true);
  }
  return scene;
}

// --- The camera

/// At (0, 0, 0) it looks along +z, by central rays or by parallel ones.
struct Camera {
  int size;  ///< of the picture, in pixels
  bool perspective;
  z_buffer::Range range{2, 12};  ///< that holds all depths

  bsp_tree::Eye<double> eye() const { return perspective ? glm::dvec4{0, 0, 0, 1} : glm::dvec4{0, 0, -1, 0}; }
  painter::View<double> view() const { return painter::view_along(eye(), dvec3{0, 0, 1}, dvec3{0, -1, 0}); }
  /// Where a point is seen, and a depth that is linear in the picture.
  dvec3 image(dvec3 p) const {
    const double middle = size / 2.0, scale = perspective ? size / p.z : size / 7.0;
    const double depth = perspective ? z_buffer::perspective_depth(p.z, range) : p.z;
    return {middle + scale * p.x, middle + scale * p.y, depth};
  }
  std::vector<dvec3> image(const std::vector<dvec3>& corners) const {
    std::vector<dvec3> seen;
    for (const dvec3 corner : corners) seen.push_back(image(corner));
    return seen;
  }
};

// --- The pictures

/// Faces as the z-buffer takes them.
struct Projected {
  std::vector<std::vector<dvec3>> corners{};
  std::vector<z_buffer::Face> faces{};

  Projected(const Polygons& scene, const Camera& camera) {
    for (const auto& face : scene) corners.push_back(camera.image(face.corners));
    for (std::size_t i = 0; i < scene.size(); ++i)
      faces.push_back({corners[i], {0, static_cast<int>(scene[i].face)}});
  }
};

inline Picture by_z_buffer(const Polygons& scene, const Camera& camera) {
  const Projected projected(scene, camera);
  Raster<z_buffer::Cell<double, z_buffer::Id>> buffer(camera.size, camera.size);
  z_buffer::per_polygon<double>(projected.faces, buffer);
  Picture picture(camera.size, camera.size, nobody);
  for (std::size_t i = 0; i < buffer.cells().size(); ++i) {
    const auto& cell = buffer.cells()[i];
    if (cell.taken) picture.cells()[i] = cell.key.face;
  }
  return picture;
}

inline Picture by_scanline(const Polygons& scene, const Camera& camera) {
  const Projected projected(scene, camera);
  Picture picture(camera.size, camera.size, nobody);
  std::vector<z_buffer::Cell<double, z_buffer::Id>> line(static_cast<std::size_t>(camera.size));
  z_buffer::scanline<double>(projected.faces, picture.window(), std::span(line), z_buffer::Exactly{},
                             [&](ivec2 p, z_buffer::Id id) { picture[p] = id.face; });
  return picture;
}

/// Paints a face over all that is there.
inline void paint(Picture& picture, const bsp_tree::Polygon<double>& face, const Camera& camera) {
  const auto corners = camera.image(face.corners);
  const z_buffer::Outline outline({corners, {}}, picture.window());
  for (const ivec2 pixel : outline.pixels()) picture[pixel] = static_cast<int>(face.face);
}
inline Picture painted(const Polygons& order, const Camera& camera) {
  Picture picture(camera.size, camera.size, nobody);
  for (const auto& face : order) paint(picture, face, camera);
  return picture;
}

/// The faces that show their front.
inline Polygons fronts(const Polygons& scene, const Camera& camera) {
  std::vector<std::span<const dvec3>> faces;
  for (const auto& face : scene) faces.emplace_back(face.corners);
  Polygons shown;
  back_face_culling::normal_and_view<double>(faces, camera.eye(),
                                             [&](std::size_t i) { shown.push_back(scene[i]); });
  return shown;
}

/// A scene's faces and parts in the order of its BSP tree.
inline Polygons bsp_order(const Polygons& scene, const Camera& camera) {
  Polygons order;
  bsp_tree::back_to_front(bsp_tree::build(scene), camera.eye(),
                          [&](const auto& part) { order.push_back(part); });
  return order;
}

/// The same by the painter's order.
inline Polygons painter_order(const Polygons& scene, const Camera& camera) {
  Polygons order;
  painter::newell(scene, camera.view(), [&](const auto& part) { order.push_back(part); });
  return order;
}

// --- The referee

/// A face along the rays of the picture: how near it is, greater is nearer, and how far a place lies inside
/// it. Both are linear; they are the face's own plane met by a ray in space, not a depth of corners
/// between them.
class Sighted {
 public:
  using Real = long double;
  using Place = std::array<Real, 2>;
  Sighted(const bsp_tree::Polygon<double>& face, const Camera& camera) {
    const auto& p = face.corners;
    const auto corner = [&](std::size_t i) { return std::array<Real, 3>{p[i].x, p[i].y, p[i].z}; };
    std::array<Real, 3> normal{};
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        normal[k] += (corner(i)[l] - corner(0)[l]) * (corner(i + 1)[m] - corner(0)[m]) -
                     (corner(i)[m] - corner(0)[m]) * (corner(i + 1)[l] - corner(0)[l]);
      }
    }
    Real height = 0;
    for (std::size_t k = 0; k < 3; ++k) height += normal[k] * corner(0)[k];
    const Real size = camera.size, middle = size / 2;
    if (camera.perspective) {
      // 1 / z where the ray ((x - middle) / size, (y - middle) / size, 1) z meets the plane
      right_ = normal[0] / size / height;
      down_ = normal[1] / size / height;
      at_middle_ = normal[2] / height;
    } else {
      right_ = normal[0] * 7 / size / normal[2];
      down_ = normal[1] * 7 / size / normal[2];
      at_middle_ = -height / normal[2];
    }
    middle_ = middle;
    seen_ = std::isfinite(right_) && std::isfinite(down_) && std::isfinite(at_middle_);
    const auto scale = [&](std::size_t i) { return camera.perspective ? size / Real{p[i].z} : size / 7; };
    for (std::size_t i = 0; i < p.size(); ++i)
      outline_.push_back({middle + scale(i) * p[i].x, middle + scale(i) * p[i].y});
    Real area = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto &a = outline_[i], &b = outline_[(i + 1) % p.size()];
      area += a[0] * b[1] - a[1] * b[0];
    }
    if (area < 0) std::ranges::reverse(outline_);
    seen_ = seen_ && area != 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto along = [k](const Place& place) { return place[k]; };
      const auto [lower, upper] = std::ranges::minmax(std::views::transform(outline_, along));
      lower_[k] = lower, upper_[k] = upper;
    }
  }

  bool seen() const { return seen_; }
  Window box() const {
    return {{int(std::floor(lower_[0])), int(std::floor(lower_[1]))},
            {int(std::floor(upper_[0])), int(std::floor(upper_[1]))}};
  }
  Real nearness(Real x, Real y) const { return at_middle_ + right_ * (x - middle_) + down_ * (y - middle_); }
  /// How fast two faces' nearness parts, per pixel.
  friend Real slope_between(const Sighted& a, const Sighted& b) {
    return std::hypot(a.right_ - b.right_, a.down_ - b.down_);
  }
  /// The distance to the nearest edge's line; negative outside.
  Real inside(Real x, Real y) const {
    const Real off = std::max({lower_[0] - x, x - upper_[0], lower_[1] - y, y - upper_[1]});
    if (off > 1) return -off;  // far from the box about it
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const auto &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
      const Real dx = b[0] - a[0], dy = b[1] - a[1];
      least = std::min(least, (dx * (y - a[1]) - dy * (x - a[0])) / std::hypot(dx, dy));
    }
    return least;
  }

 private:
  Real right_ = 0, down_ = 0, at_middle_ = 0, middle_ = 0;
  std::vector<Place> outline_;
  Place lower_{}, upper_{};
  bool seen_ = false;
};

inline std::vector<Sighted> sighted(const Polygons& scene, const Camera& camera) {
  std::vector<Sighted> all;
  for (const auto& face : scene) all.emplace_back(face, camera);
  return all;
}

/// What a pixel shows, and whether everything within a margin of its centre shows the same: no border of a
/// face and no line where two meet is seen there.
struct Verdict {
  int face = nobody;
  bool sure = true;
};

inline Verdict verdict_at(const std::vector<Sighted>& faces, ivec2 pixel, long double margin) {
  const long double x = pixel.x + 0.5L, y = pixel.y + 0.5L;
  Verdict verdict;
  std::vector<std::size_t> close;  // faces within the margin
  long double nearest = 0, inside_it = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!faces[i].seen()) continue;
    const long double inside = faces[i].inside(x, y);
    if (inside > -margin) close.push_back(i);
    const long double near = faces[i].nearness(x, y);
    if (inside <= 0 || (verdict.face != nobody && near <= nearest)) continue;
    verdict.face = static_cast<int>(i);
    nearest = near;
    inside_it = inside;
  }
  if (verdict.face == nobody) return {nobody, close.empty()};
  const auto shown = static_cast<std::size_t>(verdict.face);
  const auto stays_behind = [&](std::size_t i) {
    return i == shown || nearest - faces[i].nearness(x, y) > margin * slope_between(faces[shown], faces[i]);
  };
  verdict.sure = inside_it >= margin && std::ranges::all_of(close, stays_behind);
  return verdict;
}

/// By a ray per pixel. margin: in pixels.
inline Raster<Verdict> by_rays(const Polygons& scene, const Camera& camera, long double margin) {
  const auto faces = sighted(scene, camera);
  Raster<Verdict> verdicts(camera.size, camera.size);
  for (int y = 0; y < camera.size; ++y) {
    for (int x = 0; x < camera.size; ++x) verdicts[{x, y}] = verdict_at(faces, {x, y}, margin);
  }
  return verdicts;
}

/// The pixels whose centres lie so close to an edge of a painted part that snapping its corners to 1/256
/// pixel may open a seam there: two parts of a face can have corners of others on their common edge.
inline Raster<std::uint8_t> seams(const Polygons& parts, const Camera& camera) {
  Raster<std::uint8_t> found(camera.size, camera.size);
  for (const auto& part : parts) {
    const Sighted sight(part, camera);
    const auto [lower, upper] = intersection(sight.box(), found.window());
    for (int y = lower.y; y <= upper.y; ++y) {
      for (int x = lower.x; x <= upper.x; ++x) {
        if (std::abs(sight.inside(x + 0.5L, y + 0.5L)) <= 1.0L / 128) found[{x, y}] = true;
      }
    }
  }
  return found;
}

// --- Which faces hide which

/// hides[a][b]: somewhere a is nearer than b.
using Hides = std::vector<std::vector<bool>>;

inline Hides hides(const Polygons& scene, const Camera& camera) {
  const auto faces = sighted(scene, camera);
  Hides found(scene.size(), std::vector<bool>(scene.size()));
  for (int y = 0; y < camera.size; ++y) {
    for (int x = 0; x < camera.size; ++x) {
      std::vector<std::pair<long double, std::size_t>> there;
      for (std::size_t i = 0; i < faces.size(); ++i) {
        if (faces[i].seen() && faces[i].inside(x + 0.5L, y + 0.5L) > 0)
          there.push_back({faces[i].nearness(x + 0.5L, y + 0.5L), i});
      }
      std::ranges::sort(there);
      for (std::size_t far = 0; far < there.size(); ++far) {
        for (std::size_t near = far + 1; near < there.size(); ++near)
          if (there[far].first < there[near].first) found[there[near].second][there[far].second] = true;
      }
    }
  }
  return found;
}

/// Pairs of which each hides something of the other: they pierce.
inline std::int64_t piercings(const Hides& hides) {
  std::int64_t count = 0;
  for (std::size_t a = 0; a < hides.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) count += hides[a][b] && hides[b][a];
  }
  return count;
}

/// Whether faces that don't pierce each other have no order: each of some hides another of them.
inline bool cyclic(const Hides& hides) {
  const std::size_t n = hides.size();
  std::vector<bool> ordered(n);
  const auto hides_nothing = [&](std::size_t a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (!ordered[b] && hides[a][b] && !hides[b][a]) return false;
    }
    return true;
  };
  for (std::size_t left = n; left > 0;) {
    const std::size_t before = left;
    for (std::size_t a = 0; a < n; ++a) {
      if (ordered[a] || !hides_nothing(a)) continue;
      ordered[a] = true;
      --left;
    }
    if (left == before) return true;
  }
  return false;
}

}  // namespace gradus::test
