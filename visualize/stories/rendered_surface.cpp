// Faces to pixels: a z-buffer of samples, several to a pixel.

#include "stories/rendered_surface.hpp"

#include <cmath>

#include "core/raster.hpp"
#include "figure/tone_of.hpp"

namespace gradus {
namespace {

constexpr double tones = 60;                       ///< of a surface, from black to white
constexpr int fine = 3;                            ///< samples to a pixel, either way
constexpr dvec3 surface_colour{0.32, 0.47, 0.6};   ///< of the surface, light
constexpr dvec3 to_light{-0.35, 0.8, 0.5};         ///< as the reader has it: see shade_of
constexpr double ambient = 0.3, line_light = 0.2;  ///< parts of the colour
constexpr double in_band = 0.3;                    ///< part of the light in a dark band
constexpr double half_line = 1.4;                  ///< of a line between faces, in samples

struct Sample {
  float depth = -1e30f;  ///< towards the reader
  float light = -1;      ///< below 0: nothing is here
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
    for (std::size_t f = 0; f < faces_.size(); ++f) draw(f);
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
    const bool dark = std::fmod(std::floor(glm::dot(normal, look_.bands) / length), 2) != 0;
    return static_cast<float>((away ? 0.6 : 1) * (dark ? in_band : 1) * (ambient + (1 - ambient) * facing));
  }

  void draw(std::size_t f) {
    const auto ring = faces_[f];
    const dvec3 area = area_of(f);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      std::array<Seen, 3> corners{of(ring[0]), of(ring[i]), of(ring[i + 1])};
      for (Seen& corner : corners) {
        if (look_.faceted) corner.normal = area;
        // A fold of the surface: its own side is seen, whatever its neighbours' is
        if (glm::dot(corner.normal, area) < 0) corner.normal = area;
      }
      // The sides from the first corner are diagonals but for the first and the last
      draw(corners, {i == 1, true, i + 2 == ring.size()});
    }
  }
  /// sides: from corner k to the next one lies an edge of the face.
  void draw(const std::array<Seen, 3>& c, const std::array<bool, 3>& sides) {
    const auto across = [](dvec3 a, dvec3 b, dvec2 p) {
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const double whole = across(c[0].at, c[1].at, c[2].at);
    if (whole == 0) return;
    const dvec3 lower = glm::min(glm::min(c[0].at, c[1].at), c[2].at),
                upper = glm::max(glm::max(c[0].at, c[1].at), c[2].at);
    const ivec2 last{samples_.width() - 1, samples_.height() - 1};
    const ivec2 from = glm::max(ivec2(glm::ceil(dvec2(lower) - 0.5)), ivec2(0)),
                to = glm::min(ivec2(glm::floor(dvec2(upper) - 0.5)), last);
    for (ivec2 p = from; p.y <= to.y; ++p.y) {
      for (p.x = from.x; p.x <= to.x; ++p.x) {
        const dvec2 at = dvec2(p) + 0.5;
        const dvec3 part =
            dvec3{across(c[1].at, c[2].at, at), across(c[2].at, c[0].at, at), across(c[0].at, c[1].at, at)} /
            whole;
        if (part.x < 0 || part.y < 0 || part.z < 0) continue;
        Sample& sample = samples_[p];
        const auto depth = static_cast<float>(part.x * c[0].at.z + part.y * c[1].at.z + part.z * c[2].at.z);
        if (depth <= sample.depth) continue;
        sample = {depth, light_of(part.x * c[0].normal + part.y * c[1].normal + part.z * c[2].normal)};
        if (look_.faceted && on_a_side(c, sides, part, std::abs(whole)))
          sample.light = static_cast<float>(line_light);
      }
    }
  }
  static bool on_a_side(const std::array<Seen, 3>& c, const std::array<bool, 3>& sides, dvec3 part,
                        double whole) {
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const dvec2 side = c[(i + 1) % 3].at - c[i].at;
      if (sides[i] && part[(k + 2) % 3] * whole < half_line * std::sqrt(glm::dot(side, side))) return true;
    }
    return false;
  }

  Rgba8 mean_in(ivec2 corner) const {
    double light = 0;
    int here = 0;
    for (int i = 0; i < fine * fine; ++i) {
      const Sample& sample = samples_[corner + ivec2{i % fine, i / fine}];
      if (sample.light < 0) continue;
      light += sample.light;
      ++here;
    }
    if (here == 0) return {0, 0, 0, 0};
    // So few tones that a byte names one: pages hold pictures of at most 256 in a quarter of the room
    const double tone = std::round(light / here * tones) / tones,
                 share = std::ceil(here * 4.0 / (fine * fine)) / 4;
    return in_share(tone_of(tone * surface_colour), share);
  }

  const Faces& faces_;
  const SurfaceLook& look_;
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
