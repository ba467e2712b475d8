#pragma once
// What a z-buffer is given: faces with colours, their order, a picture, and how depths are stored.

#include <bit>

#include "stories/outline.hpp"
#include "stories/rings.hpp"
#include "stories/telling.hpp"
#include "visibility/z_buffer/z_buffer.hpp"

namespace gradus::z_buffer {

/// The colours of faces that bring none, in turn: told apart by every eye and on grey paper.
inline constexpr std::array<Rgba8, 4> own_colors{Rgba8{86, 180, 233, 255}, Rgba8{240, 228, 66, 255},
                                                 Rgba8{213, 94, 0, 255}, Rgba8{0, 114, 178, 255}};

/// Depths between the near plane and the far one, and where a point is seen: straight on, or from an eye
/// before the picture, which lies in z = 0.
struct Sight {
  double near, far;
  std::optional<dvec3> eye{};

  /// From the eye to the near plane and to the far one.
  Range distances() const { return {near - eye->z, far - eye->z}; }
  /// What is stored as the least depth and as the greatest.
  Range depths() const { return eye ? Range{0, 1} : Range{near, far}; }
  dvec3 image(dvec3 p) const {
    if (!eye) return p;
    const double distance = p.z - eye->z;
    return {dvec2(*eye) - eye->z / distance * (dvec2(p) - dvec2(*eye)),
            perspective_depth(distance, distances())};
  }
  /// Where the depth of a pixel lies in space.
  double z_of(double depth) const {
    if (!eye) return depth;
    const auto [n, f] = distances();
    return eye->z + f * n / (f - depth * (f - n));
  }
  /// How far z moves a unit of depth.
  double z_per_depth(double z) const {
    if (!eye) return 1;
    const auto [n, f] = distances();
    return (z - eye->z) * (z - eye->z) * (f - n) / (f * n);
  }
};

struct Subject {
  std::vector<NamedFace> named;  ///< as they are seen: depths are linear in the picture
  ivec2 size;
  Sight sight;
  std::vector<Rgba8> colors{};                 ///< by face
  std::vector<Face> faces{};                   ///< in the order of drawing
  std::vector<std::vector<dvec3>> in_space{};  ///< the corners of faces before they are seen, by face

  const std::string& name(Id id) const { return named[static_cast<std::size_t>(id.face)].name; }
  Rgba8 color(Id id) const { return colors[static_cast<std::size_t>(id.face)]; }
  const std::vector<dvec3>& corners(Id id) const { return named[static_cast<std::size_t>(id.face)].points; }
  Window picture() const { return {{0, 0}, size - 1}; }
  /// Where the picture, with pixels' numbers at their centres, shows a place of space.
  std::optional<dvec2> shown_at(dvec3 p) const {
    if (sight.eye && p.z <= sight.eye->z) return std::nullopt;
    return as_it_is_in(picture())(dvec2(sight.image(p)) - 0.5);
  }
};

/// "#rrggbb" as a colour.
inline Rgba8 color_of(std::string_view text) {
  const auto channel = [&](std::size_t at) {
    const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
    return static_cast<std::uint8_t>(16 * digit(text[at]) + digit(text[at + 1]));
  };
  return {channel(1), channel(3), channel(5), 255};
}

/// Whether no corner lies on the wrong side of an edge, as one sees the face.
inline bool is_convex(const std::vector<dvec3>& c) {
  bool left = false, right = false;
  for (const auto& [a, b] : sides_of(c)) {
    const dvec2 way = dvec2(b) - dvec2(a);
    for (const dvec3& corner : c) {
      const dvec2 to = dvec2(corner) - dvec2(a);
      const double side = way.x * to.y - way.y * to.x;
      const double noise = 1e-12 * (std::abs(way.x * to.y) + std::abs(way.y * to.x));
      left = left || side > noise;
      right = right || side < -noise;
    }
  }
  return !(left && right);
}

/// Whether all corners lie in the plane of the face.
inline bool is_plane(const Face& face) {
  const auto plane = plane_of(face);
  if (!plane) return true;  // edge on: nothing of it is seen
  const double thick = 1e-6 * (1 + plane->farthest - plane->nearest);
  return std::ranges::all_of(face.corners, [&](const dvec3& c) {
    const dvec2 way = dvec2(c) - dvec2(plane->corner);
    return std::abs(plane->corner.z + plane->right * way.x + plane->down * way.y - c.z) <= thick;
  });
}

inline void require_face(const NamedFace& named, std::size_t number, const Sight& sight) {
  for (const dvec3& c : named.points) {
    if (sight.eye && c.z < sight.near)
      refuse("faces", "expected faces beyond the near plane, found '{}' before it: clip first", named.name);
    const dvec3 seen = sight.image(c);
    if (std::abs(seen.x) > farthest || std::abs(seen.y) > farthest)
      refuse("faces", "expected corners at most {} pixels out, found one of '{}' farther away", farthest,
             named.name);
  }
  if (!is_convex(named.points)) refuse("faces", "expected convex faces, found '{}' with a dent", named.name);
  if (!is_flat(named.points) && !is_plane({named.points, {0, static_cast<int>(number)}}))
    refuse("faces", "expected flat faces, found '{}' with corners in no one plane: triangles are flat",
           named.name);
}

inline Sight sight_of(const Arguments& arguments) {
  const Sight sight{arguments.number("near").value_or(0), arguments.number("far").value_or(10),
                    arguments.place("eye")};
  if (!(sight.near < sight.far)) {
    refuse(arguments, {"far", "near"}, "expected a far depth beyond the near one");
  }
  if (!sight.eye) return sight;
  if (sight.eye->z >= 0) refuse("eye", "expected an eye before the picture: its z below 0");
  if (sight.near <= sight.eye->z) {
    refuse(arguments, {"near", "eye"}, "expected a near plane in front of the eye, found it behind");
  }
  return sight;
}

/// The first face in whose plane all corners of a face lie, exactly: it gives the plane of both.
inline std::size_t first_in_plane(const std::vector<std::vector<dvec3>>& faces, std::size_t face) {
  const auto in_plane_of = [&](const std::vector<dvec3>& first) {
    // By three corners that lie on no line, which are in the plane that they are to give
    const std::vector<dvec3>& own = faces[face];
    const dvec3 a = first[0], b = first[1];
    for (std::size_t i = 2; i < first.size(); ++i) {
      if (glm::cross(b - a, first[i] - a) == dvec3(0)) continue;
      const auto lies = [&](const dvec3& p) { return orient3d(a, b, first[i], p) == 0; };
      return std::ranges::all_of(own, lies) && std::ranges::all_of(first, lies);
    }
    return false;
  };
  for (std::size_t i = 0; i < face; ++i)
    if (in_plane_of(faces[i])) return i;
  return face;
}

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{
      .named = arguments.faces("faces"),
      .size = {static_cast<int>(arguments.integer("columns")), static_cast<int>(arguments.integer("rows"))},
      .sight = sight_of(arguments)};
  for (std::size_t i = 0; i < subject.named.size(); ++i) {
    require_face(subject.named[i], i, subject.sight);
    subject.in_space.push_back(subject.named[i].points);
    for (dvec3& corner : subject.named[i].points) corner = subject.sight.image(corner);
    const std::string& color = subject.named[i].color;
    subject.colors.push_back(color.empty() ? own_colors[i % own_colors.size()] : color_of(color));
    const std::size_t first = first_in_plane(subject.in_space, i);
    subject.faces.push_back({subject.named[i].points, {0, static_cast<int>(i)}, subject.named[first].points});
  }
  if (arguments.text("order") == "given") return subject;
  const auto order = arguments.numbered_order("order");
  if (!order || order->size() != subject.faces.size()) {
    refuse("order", "expected the numbers 1 to {} of the faces, each once in any order",
           subject.faces.size());
  }
  const std::vector<Face> given = subject.faces;
  for (std::size_t i = 0; i < order->size(); ++i) subject.faces[i] = given[(*order)[i]];
  return subject;
}

/// A stored depth as a whole number that grows with it.
inline std::int64_t code_of(std::int32_t depth) { return depth; }
inline std::int64_t code_of(float depth) {
  const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(depth) & 0x7fffffff);
  return std::signbit(depth) ? -bits : bits;
}

/// How far two places lie apart in z, at least, to be stored as two depths, where the faces begin.
inline double distance_between_codes(const Subject&, Exactly) { return 0; }
inline double distance_between_codes(const Subject& subject, AsFixed24) {
  const auto [least, most] = subject.sight.depths();
  const double z = subject.sight.z_of(subject.faces.front().corners.front().z);
  return (most - least) / AsFixed24::most * subject.sight.z_per_depth(z);
}
template <class Store>
double distance_between_codes(const Subject& subject, const Store& store) {
  const auto [least, most] = subject.sight.depths();
  const double depth = subject.faces.front().corners.front().z;
  const float at = std::abs(store(depth));
  return (double{std::nextafter(at, 2.0f)} - double{at}) * (most - least) *
         subject.sight.z_per_depth(subject.sight.z_of(depth));
}

/// Depths as figures write them: as they are, or as codes from a round number on.
template <class T>
class DepthText {
 public:
  explicit DepthText(const Subject& subject, auto store) {
    if constexpr (!std::same_as<T, double>) {
      std::int64_t least = INT64_MAX, most = INT64_MIN;
      Raster<Cell<T, Id>> buffer(subject.size.x, subject.size.y);
      per_polygon<T>(subject.faces, buffer, store, [&]<class Step>(const Step& step) {
        if constexpr (std::same_as<Step, Compared<T, Id>>) {
          least = std::min(least, code_of(step.depth));
          most = std::max(most, code_of(step.depth));
        }
      });
      if (least > most || (least >= 0 && most < 1000)) return;
      // The last digits alone, from 1 on
      base_ = least - 1;
    }
  }
  std::string operator()(T depth) const {
    if constexpr (std::same_as<T, double>) {
      return figure_real(std::round(depth * 100) / 100);
    } else {
      return figure_number(code_of(depth) - base_);
    }
  }
  std::int64_t base() const { return base_; }

 private:
  std::int64_t base_ = 0;
};

// --- What the story writes and draws

/// As many digits as tell nearly coplanar faces apart.
inline std::string digits(double z) { return fmt::format("{}{:.9g}", z < 0 ? "−" : "", std::abs(z)); }
/// What sentences say of a place.
inline double rounded(double z) {
  return std::abs(z) >= 1 ? std::round(z * 100) / 100 : std::stod(fmt::format("{:.3g}", z));
}
inline Path square(ivec2 pixel) { return {Extent{dvec2(pixel) - 0.5, dvec2(pixel) + 0.5}.corners(), true}; }
/// What lies beyond `bound` along an axis, looked at in direction `sign`.
inline std::vector<dvec2> cut(const std::vector<dvec2>& ring, int axis, double sign, double bound) {
  std::vector<dvec2> kept;
  for (const auto& [a, b] : sides_of(ring)) {
    const double da = sign * a[axis] - bound, db = sign * b[axis] - bound;
    if (da >= 0) kept.push_back(a);
    if ((da < 0) != (db < 0)) kept.push_back(a + da / (da - db) * (b - a));
  }
  return kept;
}

}  // namespace gradus::z_buffer
