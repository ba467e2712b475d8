// Faces to pixels: a z-buffer of samples, several to a pixel.

#include "stories/rendered_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/raster.hpp"
#include "figure/tone_of.hpp"

namespace gradus {
namespace {

constexpr double tones = 60;                       ///< of a surface, from black to white
constexpr int fine = 3;                            ///< samples to a pixel, either way
constexpr dvec3 surface_colour{0.32, 0.47, 0.6};   ///< of the surface, light
constexpr dvec3 marked_colour{0.66, 0.84, 0.96};   ///< of faces that stand out
constexpr dvec3 to_light{-0.35, 0.8, 0.5};         ///< as the reader has it: see shade_of
constexpr double ambient = 0.3, line_light = 0.2;  ///< parts of the colour
constexpr double in_band = 0.3;                    ///< part of the light in a dark band
constexpr double half_line = 1.4;                  ///< of a line in a picture of 320 pixels, in samples

struct Sample {
  float depth = -1e30f;  ///< towards the reader
  float light = -1;      ///< below 0: nothing is here
  bool marked = false;
};

/// A corner as the picture has it: samples from the lower left, how near, its normal.
struct Seen {
  dvec3 at, normal;
};

class SurfacePicture {
 public:
  SurfacePicture(std::span<const dvec3> points, const Faces& faces, const SurfaceLook& look)
      : faces_(faces), look_(look) {
    const dvec2 size = look.shown.size();
    scale_ = look.width * fine / size.x;
    const int height = std::max(1, static_cast<int>(std::lround(look.width * size.y / size.x)));
    samples_ = Raster<Sample>(look.width * fine, height * fine);
    for (const dvec3 p : points) {
      const dvec2 flat{glm::dot(p, look.right), glm::dot(p, look.up)};
      seen_.push_back({dvec3((flat - look.shown.lower) * scale_, glm::dot(p, look.towards) * scale_), {}});
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const dvec3 area = area_of(f);
      for (const auto v : faces[f]) of(v).normal += area;
    }
    for (std::size_t i = 0; i < look.normals.size(); ++i) {
      const dvec3 n = look.normals[i];
      seen_[i].normal = {glm::dot(n, look.right), glm::dot(n, look.up), glm::dot(n, look.towards)};
    }
  }

  std::shared_ptr<const Image> picture() {
    // What faces turned to the reader cover gets no light from those behind: a depth is cheaper than a light
    for (const bool away : {false, true}) {
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        if ((area_of(f).z < 0) == away) draw(f);
      }
    }
    Image image(samples_.width() / fine, samples_.height() / fine);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x)
        image[{x, image.height() - 1 - y}] = mean_in(fine * ivec2{x, y});
    }
    return std::make_shared<const Image>(std::move(image));
  }

 private:
  Seen& of(std::int32_t v) { return seen_[static_cast<std::size_t>(v)]; }

  /// Twice the area, along the normal.
  dvec3 area_of(std::size_t f) {
    dvec3 sum{0};
    const auto ring = faces_[f];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      sum += glm::cross(of(ring[i]).at - of(ring[0]).at, of(ring[i + 1]).at - of(ring[0]).at);
    return sum;
  }
  float light_of(dvec3 normal) const {
    const double length = std::sqrt(glm::dot(normal, normal));
    if (!(length > 0)) return static_cast<float>(ambient);
    const bool away = normal.z < 0;
    const double facing = std::max(0.0, glm::dot(normal, to_light) / length * (away ? -1 : 1));
    const bool dark =
        look_.bands != dvec3{0} && std::fmod(std::floor(glm::dot(normal, look_.bands) / length), 2) != 0;
    return static_cast<float>((away ? 0.6 : 1) * (dark ? in_band : 1) * (ambient + (1 - ambient) * facing));
  }

  void draw(std::size_t f) {
    const auto ring = faces_[f];
    marked_ = std::ranges::binary_search(look_.marked, static_cast<std::int32_t>(f));
    const dvec3 area = area_of(f);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      std::array<Seen, 3> corners{of(ring[0]), of(ring[i]), of(ring[i + 1])};
      for (Seen& corner : corners) {
        if (look_.faceted) corner.normal = area;
        // A fold of the surface: its own side is seen, whatever its neighbours' is
        if (glm::dot(corner.normal, area) < 0) corner.normal = area;
      }
      // The sides from the first corner are diagonals but for the first and the last
      draw(corners,
           {i == 1 && has_line(f, 0), has_line(f, i), i + 2 == ring.size() && has_line(f, ring.size() - 1)});
    }
  }
  /// Along the side of a face that begins in this corner.
  bool has_line(std::size_t f, std::size_t side) const {
    if (look_.faceted) return true;
    if (look_.every == 0) return false;
    const auto columns = static_cast<std::size_t>(look_.columns),
               every = static_cast<std::size_t>(look_.every);
    const std::array<std::size_t, 4> places{f / columns, f % columns + 1, f / columns + 1, f % columns};
    return places[side] % every == 0;
  }
  /// sides: from corner k to the next one lies an edge of the face.
  void draw(const std::array<Seen, 3>& c, const std::array<bool, 3>& sides) {
    // The side across from each corner: where samples beside it get the corner's part of the triangle
    const std::array<dvec2, 3> starts{c[1].at, c[2].at, c[0].at},
        ways{c[2].at - c[1].at, c[0].at - c[2].at, c[1].at - c[0].at};
    const double whole = ways[2].x * (c[2].at.y - c[0].at.y) - ways[2].y * (c[2].at.x - c[0].at.x),
                 sign = whole < 0 ? -1 : 1;
    if (whole == 0) return;
    const dvec3 line_parts = parts_of_lines(c, sides, std::abs(whole));
    const float flat_light = look_.faceted ? light_of(c[0].normal) : 0;
    const dvec3 lower = glm::min(glm::min(c[0].at, c[1].at), c[2].at),
                upper = glm::max(glm::max(c[0].at, c[1].at), c[2].at);
    const ivec2 last{samples_.width() - 1, samples_.height() - 1};
    const ivec2 from = glm::max(ivec2(glm::ceil(dvec2(lower) - 0.5)), ivec2(0)),
                to = glm::min(ivec2(glm::floor(dvec2(upper) - 0.5)), last);
    for (int y = from.y; y <= to.y; ++y) {
      dvec3 row;
      int x = from.x;
      for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        row[k] = ways[i].x * (y + 0.5 - starts[i].y);
        // Left of where this side is crossed there is nothing, but for a rounding
        if (sign * ways[i].y < 0)
          x = std::max(x,
                       static_cast<int>(std::clamp(starts[i].x + row[k] / ways[i].y - 2, 0.0, to.x + 1.0)));
      }
      for (bool inside = false; x <= to.x; ++x) {
        const dvec3 beside{row.x - ways[0].y * (x + 0.5 - starts[0].x),
                           row.y - ways[1].y * (x + 0.5 - starts[1].x),
                           row.z - ways[2].y * (x + 0.5 - starts[2].x)};
        if (sign * beside.x < 0 || sign * beside.y < 0 || sign * beside.z < 0) {
          if (inside) break;
          continue;
        }
        inside = true;
        const dvec3 part = beside / whole;
        Sample& sample = samples_[{x, y}];
        const auto depth = static_cast<float>(part.x * c[0].at.z + part.y * c[1].at.z + part.z * c[2].at.z);
        if (depth <= sample.depth) continue;
        const bool in_line = part.x < line_parts.x || part.y < line_parts.y || part.z < line_parts.z;
        const float light =
            in_line         ? static_cast<float>(line_light)
            : look_.faceted ? flat_light
                            : light_of(part.x * c[0].normal + part.y * c[1].normal + part.z * c[2].normal);
        sample = {depth, light, marked_};
      }
    }
  }
  /// Below these parts of the corners a sample lies in the line along the side across from each.
  dvec3 parts_of_lines(const std::array<Seen, 3>& c, const std::array<bool, 3>& sides, double whole) const {
    const double half = half_line * std::max(look_.width, 320) / 320;
    dvec3 parts{0};
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const dvec2 side = c[(i + 1) % 3].at - c[i].at;
      if (sides[i]) parts[(k + 2) % 3] = half * std::sqrt(glm::dot(side, side)) / whole;
    }
    return parts;
  }

  Rgba8 mean_in(ivec2 corner) const {
    double light = 0;
    int here = 0, marked = 0;
    for (int i = 0; i < fine * fine; ++i) {
      const Sample& sample = samples_[corner + ivec2{i % fine, i / fine}];
      if (sample.light < 0) continue;
      light += sample.light;
      ++here;
      marked += sample.marked ? 1 : 0;
    }
    if (here == 0) return {0, 0, 0, 0};
    // So few tones that a byte names one: pages hold pictures of at most 256 in a quarter of the room
    const double tone = std::round(light / here * tones) / tones,
                 share = std::ceil(here * 4.0 / (fine * fine)) / 4;
    return in_share(tone_of(tone * (2 * marked > here ? marked_colour : surface_colour)), share);
  }

  const Faces& faces_;
  const SurfaceLook& look_;
  bool marked_ = false;  ///< the face at hand
  double scale_;
  Raster<Sample> samples_;
  std::vector<Seen> seen_;
};

}  // namespace

std::shared_ptr<const Image> rendered_surface(std::span<const dvec3> points, const Faces& faces,
                                              const SurfaceLook& look) {
  return SurfacePicture(points, faces, look).picture();
}

}  // namespace gradus
