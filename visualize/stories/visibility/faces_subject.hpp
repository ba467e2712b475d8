#pragma once
// The faces that the stories of hidden surfaces are about, and from where they are looked at.

#include <algorithm>
#include <string>
#include <vector>

#include "stories/outline.hpp"
#include "stories/parameters.hpp"
#include "stories/rings.hpp"
#include "stories/space_drawing.hpp"
#include "stories/telling.hpp"

namespace gradus::faces_subject {

/// Of coordinates: figures can show these.
inline constexpr Sizes modest_sizes{1e-6, 1e6};
/// Of directions, whose length does not count.
inline constexpr Sizes direction_sizes{1e-9, 1e9};

/// Faces of up to so many corners in all: more steps than a reader follows.
inline constexpr int most_corners = 200;

inline Parameter faces_parameter(std::string value, std::string example) {
  return parameters::faces(most_corners, "faces", std::move(value), std::move(example),
                           "what is looked at: flat faces, counter-clockwise seen from outside",
                           modest_sizes);
}
inline Parameter towards_parameter(std::string value) {
  return parameters::numbers("towards", std::move(value), "1,2,3",
                             "the direction towards the viewer, who is infinitely far away", parameters::xyz,
                             direction_sizes);
}

/// A reader far away: right and up are so that y points up where it can.
struct Reader {
  dvec3 right, up, towards;

  explicit Reader(dvec3 way) : towards(unit_vector(way)) {
    const bool upright = std::abs(towards.y) > 1 - 1e-9;
    const dvec3 hint = upright ? dvec3{0, 0, towards.y > 0 ? -1 : 1} : dvec3{0, 1, 0};
    right = unit_vector(glm::cross(hint, towards));
    up = glm::cross(towards, right);
  }
  dvec2 flat(dvec3 p) const { return {glm::dot(p, right), glm::dot(p, up)}; }
  SpaceLook look(const Panel& panel) const {
    return {.viewer = distant_viewer(towards),
            .at = [*this, &panel](dvec3 p) { return std::optional(panel.at(flat(p))); },
            .right = right,
            .up = up,
            .towards = towards};
  }
};

inline Reader reader_of(const Arguments& arguments) {
  const dvec3 towards = *arguments.place("towards");
  if (towards == dvec3{0})
    refuse(arguments, {"towards"}, "a direction expected, found 0,0,0, which points nowhere");
  return Reader(towards);
}

/// Within which all corners lie.
inline Bounds bounds_of(const std::vector<NamedFace>& faces) {
  Bounds bounds;
  for (const NamedFace& face : faces) {
    for (const dvec3 p : face.points) bounds.add(p);
  }
  return bounds;
}

/// The faces; each must have an inside that a figure can show.
inline std::vector<NamedFace> faces_of(const Arguments& arguments) {
  std::vector<NamedFace> faces = arguments.faces("faces");
  const double size = bounds_of(faces).radius();
  for (const NamedFace& face : faces) {
    if (glm::length(area_vector(face.points)) > 1e-6 * size * size) continue;
    refuse(arguments, {"faces"}, fmt::format("faces with an inside expected, found '{}' without", face.name));
  }
  return faces;
}

using gradus::is_flat;

/// A convex part of a face, with a name of its own.
struct NamedPart {
  std::string name;
  std::size_t face;
  std::vector<dvec3> ring;
};

/// The n-th part's name: "A1", "A2"; "3a", "3b" where the face's name ends with a digit.
inline std::string part_name(const std::string& whole, std::size_t n) {
  const bool digit = !whole.empty() && '0' <= whole.back() && whole.back() <= '9';
  return whole + (digit ? std::string(1, static_cast<char>('a' + n % 26)) : fmt::format("{}", n + 1));
}

/// Convex faces whole, others in convex parts, but for those without an inside. A bent face is refused: its
/// parts would be polygons that nobody gave.
inline std::vector<NamedPart> parts_of(const std::vector<NamedFace>& faces) {
  std::vector<NamedPart> parts;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!is_flat(faces[i].points)) {
      refuse("faces", "expected flat faces, found '{}' with corners in no one plane: triangles are flat",
             faces[i].name);
    }
    auto rings = convex_parts(faces[i].points);
    const double whole = glm::length(area_vector(faces[i].points));
    std::erase_if(rings, [&](const auto& ring) { return glm::length(area_vector(ring)) <= 1e-9 * whole; });
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const std::string name = rings.size() == 1 ? faces[i].name : part_name(faces[i].name, k);
      parts.push_back({name, i, std::move(rings[k])});
    }
  }
  return parts;
}

/// A place inside a convex ring where nothing hides it, for its name: the one with most round it that is
/// seen, of equals a clear one; nothing where all of it is hidden.
template <class IsClear>
std::optional<dvec3> seen_place(const std::vector<dvec3>& ring, const HiddenLines& lines, IsClear is_clear) {
  const dvec3 middle = middle_of(ring);
  const auto is_seen = [&](dvec3 p, dvec3 from) { return !lines.pieces(from, p).front().hidden; };
  std::optional<dvec3> best;
  int most = 0;
  const auto look_at = [&](dvec3 p) {
    if (!is_seen(p + 1e-3 * (ring[0] - p), p)) return;
    int seen = 2 + (is_clear(p) ? 1 : 0);
    for (const dvec3 corner : ring) {
      const dvec3 beside = p + 0.15 * (corner - middle);
      seen += is_seen(beside + 1e-3 * (p - beside), beside) ? 2 : 0;
    }
    if (seen > most) best = p;
    most = std::max(most, seen);
  };
  look_at(middle);
  for (const double part : {0.2, 0.35, 0.5, 0.65, 0.8}) {
    for (const auto& [a, b] : sides_of(ring)) {
      for (const dvec3 towards : {a, 0.5 * (a + b)}) look_at(middle + part * (towards - middle));
    }
  }
  return best;
}

}  // namespace gradus::faces_subject
