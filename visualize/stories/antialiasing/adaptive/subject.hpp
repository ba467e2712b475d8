#pragma once
// What the story of adaptive antialiasing is given: triangles with depths, a small picture, samples.

#include "antialiasing/adaptive/adaptive.hpp"
#include "core/colour.hpp"
#include "figure/tone_of.hpp"
#include "stories/parameters.hpp"
#include "stories/point_text.hpp"
#include "stories/telling.hpp"

namespace gradus::adaptive {

/// The colours of faces that bring none, in turn: told apart by every eye and on grey paper.
inline constexpr std::array<Rgba8, 4> own_colors{Rgba8{86, 180, 233, 255}, Rgba8{240, 228, 66, 255},
                                                 Rgba8{204, 121, 167, 255}, Rgba8{0, 158, 115, 255}};

/// A colour before a white ground, as the screen has it.
inline Rgba8 on_white(const dvec3& sum, double share) { return tone_of(sum + (1 - share)); }

struct Subject {
  std::vector<NamedFace> named{};
  std::vector<ScreenTriangle> triangles{};
  std::vector<Rgba8> colors{};
  ivec2 size{8, 8};
  int count = 8;  ///< samples per pixel
  std::vector<ivec2> places{};
  ivec2 pixel{0, 0};       ///< the one that is drawn large
  bool chequered = false;  ///< the first face has a chequered surface
  double threshold = 16;
  double square = 1.6;  ///< of a chequered surface, in pixels

  Window picture() const { return {{0, 0}, size - 1}; }
  const std::string& name(int triangle) const { return named[static_cast<std::size_t>(triangle)].name; }
  Rgba8 color(int triangle) const { return colors[static_cast<std::size_t>(triangle)]; }
  const ScreenTriangle& triangle(int i) const { return triangles[static_cast<std::size_t>(i)]; }
  /// A triangle's corners in pixels.
  std::vector<dvec2> ring(int i) const {
    std::vector<dvec2> corners;
    for (const ivec2 c : triangle(i).corners) corners.push_back(dvec2(c) / double{subpixels});
    return corners;
  }
  /// The linear light of a triangle where it has these weights. Squares of a chequered surface are so large
  /// that a pixel of the picture sees few of them.
  dvec3 colour(int i, const Weights& w) const {
    const dvec3 plain(linear_from_srgb8(color(i)));
    if (!chequered || i != 0) return plain;
    const dvec3 shares = triangle_coverage::barycentric(w);
    const std::vector<dvec2> corners = ring(i);
    const dvec2 at = (shares.x * corners[0] + shares.y * corners[1] + shares.z * corners[2]) / square;
    const bool dark = (static_cast<int>(std::floor(at.x)) + static_cast<int>(std::floor(at.y))) % 2 != 0;
    return dark ? plain : dvec3(0.86);
  }
  auto colours() const {
    return [this](int i, ivec2, const Weights& w) { return colour(i, w); };
  }
};

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{
      .named = arguments.faces("faces"),
      .size = {static_cast<int>(arguments.integer("columns")), static_cast<int>(arguments.integer("rows"))},
      .count = static_cast<int>(*whole_number(arguments.text("samples"))),
      .pixel = arguments.cell("pixel"),
      .chequered = arguments.text("surface") == "chequered",
      .threshold = *arguments.number("threshold")};
  subject.places = n_rooks(subject.count);
  if (!subject.picture().contains(subject.pixel))
    refuse(arguments, {"pixel", "columns", "rows"},
           fmt::format("expected a pixel of the picture of {} x {}", subject.size.x, subject.size.y));
  for (std::size_t i = 0; i < subject.named.size(); ++i) {
    const NamedFace& face = subject.named[i];
    if (face.points.size() != 3)
      refuse("faces", "expected triangles, found '{}' with {} corners", face.name, face.points.size());
    ScreenTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 p = face.points[k];
      if (!triangle_coverage::can_snap(dvec2(p)))
        refuse("faces", "expected corners near the picture, found one of '{}' farther away", face.name);
      triangle.corners[k] = triangle_coverage::snap(dvec2(p));
      triangle.depth[static_cast<int>(k)] = p.z;
    }
    subject.triangles.push_back(triangle);
    subject.colors.push_back(own_colors[i % own_colors.size()]);
  }
  return subject;
}

/// The part of a convex polygon where a linear function is not below 0.
inline std::vector<dvec2> above_0(const std::vector<dvec2>& ring, const auto& function) {
  std::vector<dvec2> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double at_a = function(a), at_b = function(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}
/// The part of a polygon in a rectangle.
inline std::vector<dvec2> within(dvec2 lower, dvec2 upper, std::vector<dvec2> ring) {
  for (const int axis : {0, 1}) {
    ring = above_0(ring, [&](dvec2 p) { return p[axis] - lower[axis]; });
    ring = above_0(ring, [&](dvec2 p) { return upper[axis] - p[axis]; });
  }
  return ring;
}

}  // namespace gradus::adaptive
