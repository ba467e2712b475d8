#pragma once
// What a run is about: points of a surface that is known, or the vertices of a model, one of them, and the
// eye that has seen them; and pictures of points that are drawn as dots.

#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "figure/tone_of.hpp"
#include "modeling/point_cloud/point_cloud.hpp"
#include "stories/given_model.hpp"
#include "stories/rendered_surface.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::point_cloud {

using Surface = Normal<double>;

constexpr int paper_width = 40, paper_height = 26;
constexpr double two_pi = 6.283185307179586;

inline std::string short_real(double value) {
  return figure_real(std::abs(value) < 0.0005 ? 0 : std::round(value * 1000) / 1000);
}
inline std::string short_place(dvec3 p) { return figure_place(p, short_real); }
/// With one digit behind the point.
inline std::string degrees(double angle) { return figure_real(std::round(angle * 10) / 10); }
/// 0.0123 is "1.2".
inline std::string percent(double part) { return figure_real(std::round(part * 1000) / 10); }

/// A ring of so many corners on a circle.
inline std::vector<dvec2> round_ring(dvec2 middle, double radius, int corners = 12) {
  std::vector<dvec2> ring;
  for (int i = 0; i < corners; ++i) {
    const double turn = two_pi * i / corners;
    ring.push_back(middle + radius * dvec2{gradus::cos(turn), gradus::sin(turn)});
  }
  return ring;
}

/// A place of a surface, and how the surface faces there.
struct Spot {
  dvec3 place, normal;
};
/// The surfaces that come with the topic as maps of a square.
inline Spot spot_of(const std::string& shape, double u, double v) {
  if (shape == "ball") {
    const double y = 1 - 2 * v, r = std::sqrt(std::max(0.0, 1 - y * y)), turn = two_pi * u;
    const dvec3 p{r * gradus::cos(turn), y, r * gradus::sin(turn)};
    return {p, p};
  }
  const double x = 2 * u - 1, y = 2 * v - 1;
  if (shape == "roof") return {{x, y, 0.7 * std::abs(x)}, unit_vector(dvec3{x < 0 ? -0.7 : 0.7, 0, -1})};
  if (shape == "plane") return {{x, y, 0.3 * x + 0.2 * y}, unit_vector(dvec3{-0.3, -0.2, 1})};
  // A saddle
  return {{1.2 * x, y, 0.45 * (x * x - y * y)}, unit_vector(dvec3{-0.75 * x, 0.9 * y, 1})};
}

struct Subject {
  std::vector<dvec3> points{}, normals{};  ///< the second where they are known
  std::vector<dvec3> corners{};            ///< of the surface
  Faces faces{};
  std::size_t k = 1;
  Index point = 0;
  dvec3 eye{0};
  faces_subject::Reader reader;
  Tree<double> tree{};

  dvec3 own() const { return points[point]; }
  bool closed = false;  ///< points that look away are hidden
  bool is_hidden(std::size_t i) const { return closed && glm::dot(normals[i], reader.towards) < 0; }
};

inline bool is_of_model(const Arguments& arguments) {
  const std::string shape = arguments.text("shape");
  return names_a_model(arguments) || shape == "spot" || shape == "fish" || shape == "icosphere";
}

inline void take_model(Subject& subject, const Arguments& arguments) {
  constexpr std::size_t most = 4000;  // as of other surfaces
  const Mesh mesh = given_model(arguments, arguments.text("shape") + ".obj");
  if (mesh.positions.size() > most)
    refuse(arguments, {"model"},
           fmt::format("expected a model of up to {} vertices, found {}", most, mesh.positions.size()));
  subject.points = subject.corners = mesh.positions;
  for (const MeshFace& face : mesh.faces) {
    std::vector<std::int32_t> ring;
    for (const Corner& corner : corners_of(mesh, face)) ring.push_back(corner.position);
    subject.faces.add(ring);
  }
}
/// So many points, as evenly as one by one they can be; each off its surface by up to `noise`.
inline void take_surface(Subject& subject, const Arguments& arguments) {
  const std::string shape = arguments.text("shape");
  const double noise = *arguments.number("noise");
  Random random(1);
  const auto part = [](double x) { return x - std::floor(x); };
  for (std::int64_t i = 0; i < arguments.integer("count"); ++i) {
    const auto n = static_cast<double>(i);
    // M. Roberts' sequence: steps of the plastic number
    const Spot spot = spot_of(shape, part(0.5 + 0.7548776662466927 * n), part(0.5 + 0.5698402909980532 * n));
    subject.points.push_back(spot.place + noise * (2 * random.unit() - 1) * spot.normal);
    subject.normals.push_back(spot.normal);
  }
  subject.closed = shape == "ball";
  constexpr std::int32_t pieces = 48, row = pieces + 1;
  for (std::int32_t i = 0; i < row * row; ++i)
    subject.corners.push_back(spot_of(shape, i % row * (1.0 / pieces), i / row * (1.0 / pieces)).place);
  for (std::int32_t i = 0; i < row * pieces; ++i) {
    if (i % row < pieces) subject.faces.add(std::array{i, i + 1, i + row + 1, i + row});
  }
}

/// The corners of a cube alone: they spread alike in all directions.
inline void take_cube(Subject& subject) {
  for (int i = 0; i < 8; ++i)
    subject.corners.emplace_back(i % 2 == 0 ? -1 : 1, i / 2 % 2 == 0 ? -1 : 1, i < 4 ? -1 : 1);
  subject.points = subject.corners;
  using Ring = std::array<std::int32_t, 4>;
  for (const Ring& ring : {Ring{0, 2, 3, 1}, Ring{4, 5, 7, 6}, Ring{0, 1, 5, 4}, Ring{2, 6, 7, 3},
                           Ring{0, 4, 6, 2}, Ring{1, 3, 7, 5}})
    subject.faces.add(ring);
}

/// The point whose surroundings a figure shows best: nearest to the middle of the picture, of those seen.
inline Index point_to_tell(const Subject& subject) {
  Extent extent;
  for (const dvec3 p : subject.points) extent.add(subject.reader.flat(p));
  const auto rank = [&](Index i) {
    const dvec2 middle = extent.lower + dvec2{0.5, 0.42} * extent.size();
    return std::pair(subject.is_hidden(i), length_between(subject.reader.flat(subject.points[i]), middle));
  };
  Index best = 0;
  for (Index i = 1; i < subject.points.size(); ++i) {
    if (rank(i) < rank(best)) best = i;
  }
  return best;
}

/// The cloud, moved with its eye. A tree refers to it: a subject stays where it is made.
inline void prepare(Subject& subject, const Arguments& arguments) {
  if (is_of_model(arguments))
    take_model(subject, arguments);
  else if (arguments.text("shape") == "cube")
    take_cube(subject);
  else
    take_surface(subject, arguments);
  const dvec3 at = *arguments.place("at");
  for (dvec3& p : subject.points) p += at;
  for (dvec3& p : subject.corners) p += at;
  subject.eye = *arguments.place("eye") + at;
  subject.k = static_cast<std::size_t>(arguments.integer("k"));
  subject.point = point_to_tell(subject);
  if (arguments.has("point") && !arguments.text("point").empty()) {
    const std::int64_t i = arguments.integer("point");
    if (i > std::ssize(subject.points))
      refuse("point", "expected a point up to {}, found {}", subject.points.size(), i);
    subject.point = static_cast<Index>(i - 1);
  }
  subject.tree = kd_tree::build<3, double>(subject.points);
}

// --- Pictures of dots ----------------------------------------------------------------------------------

/// Two colours in squares, as a scanner may have seen them on its way.
inline dvec3 colour_of(const Subject& subject, std::size_t i) {
  constexpr dvec3 light{0.75, 0.5, 0.16}, dark{0.1, 0.33, 0.6};
  const dvec3 p = 2.5 * (subject.points[i] - subject.points[0]);
  const auto sum = static_cast<std::int64_t>(std::floor(p.x) + std::floor(p.y) + std::floor(p.z));
  return sum % 2 == 0 ? light : dark;
}
/// Lit by a lamp where the eye is; a point without a normal gets no light of it.
inline Rgba8 lit(dvec3 colour, dvec3 normal, dvec3 to_lamp) {
  constexpr double ambient = 0.12, tones = 24;
  const double facing = std::max(0.0, glm::dot(normal, unit_vector(to_lamp)));
  return tone_of(std::round((ambient + (1 - ambient) * facing) * tones) / tones * colour);
}

/// Of what is shown; of one place alone any.
inline double longer_side(const Extent& shown) {
  const double longer = std::max(shown.size().x, shown.size().y);
  return longer > 1e-300 ? longer : 1;
}

/// How a square of the plane across the reader's way becomes pixels.
struct Screen {
  dvec2 lower;
  double side;
  int pixels;

  double scale() const { return pixels / side; }
  /// x, y and the depth of a point, as `draw` takes them.
  std::vector<dvec3> seen(const Subject& subject) const {
    return mapped(subject.points, [&](dvec3 p) {
      const dvec2 flat = (subject.reader.flat(p) - lower) * scale();
      return dvec3{flat.x, pixels - flat.y, -glm::dot(p, subject.reader.towards)};
    });
  }
};

/// Points as a picture: in each pixel the colour of the point that is seen there; each pixel so many wide.
template <class Colour>
std::shared_ptr<const Image> picture_of(const Raster<Index>& front, int wide, const Colour& colour) {
  Image image(front.width() * wide, front.height() * wide, {0, 0, 0, 0});
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) image[{x, y}] = colour(ivec2{x, y} / wide);
  }
  return std::make_shared<const Image>(std::move(image));
}

/// Keeps of each dot what lies in its circle: the same points, round.
inline Raster<Index> rounded(std::span<const dvec3> seen, const Screen& screen, int radius) {
  const auto within = [&](Index i, ivec2 pixel) {
    const ivec2 off = pixel - pixel_of(seen[i]);
    return off.x * off.x + off.y * off.y <= radius * (radius + 1);
  };
  Raster<Index> front = blank(ivec2(screen.pixels));
  for (Index i = 0; i < seen.size(); ++i) {
    for (const ivec2 pixel : dot_at(pixel_of(seen[i]), radius, front)) {
      if (within(i, pixel)) front[pixel] = nearer(seen, front[pixel], i);
    }
  }
  return front;
}

/// All points as dots in the light of their normals; without any, as they are.
inline std::shared_ptr<const Image> shaded(const Subject& subject, std::span<const dvec3> normals,
                                           const Screen& screen, int radius) {
  const std::vector<dvec3> seen = screen.seen(subject);
  const auto front = rounded(seen, screen, radius);
  return picture_of(front, 1, [&](ivec2 pixel) {
    const Index i = front[pixel];
    if (i == none) return Rgba8{0, 0, 0, 0};
    const dvec3 colour = colour_of(subject, i), to_eye = subject.eye - subject.points[i];
    return normals.empty() ? tone_of(0.6 * colour) : lit(colour, normals[i], to_eye);
  });
}

}  // namespace gradus::point_cloud
