#pragma once
// What culling saves: a model's triangles rasterized all, those that turn away alone, and those that are
// drawn, beside each other, and below each picture what it took.

#include <array>
#include <map>

#include "figure/tone_of.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "stories/given_model.hpp"
#include "stories/listing.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/visibility/back_face_culling/methods.hpp"

namespace gradus::back_face_culling {

/// The model where none is given: closed.
inline constexpr std::string_view own_model = "spot.obj";
/// The most triangles that come as a figure in a moment.
inline constexpr std::int64_t most_triangles = 20'000;

/// The model in a ball of this radius round the origin, where the eye finds it whatever its size was.
inline constexpr double placed_radius = 1.5;

/// Faces as a rasterizer takes them, in their place: flat, so that each has one side. turned: by a quarter,
/// for the own model, which else looks away from the eye.
inline std::vector<NamedFace> placed_triangles(const Mesh& mesh, bool turned) {
  const Bounds bounds = bounds_of(mesh);
  const double scale = bounds.radius() > 0 ? placed_radius / bounds.radius() : 1;
  std::vector<NamedFace> triangles;
  for (const MeshFace& face : mesh.faces) {
    Ring ring;
    for (const Corner& corner : corners_of(mesh, face)) {
      const dvec3 p = scale * (position_of(mesh, corner) - bounds.centre());
      ring.push_back(turned ? dvec3{-p.z, p.y, p.x} : p);
    }
    for (const Ring& triangle : triangles_of(ring)) triangles.push_back({.name = {}, .points = triangle});
  }
  return triangles;
}

/// Whether triangles are the skin of bodies: each side is another one's as well, the other way round, and in
/// all they hold a volume, seen from outside.
inline bool are_closed(const std::vector<Ring>& triangles) {
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, Place>, int> sides;
  double volume = 0;
  for (const Ring& ring : triangles) {
    volume += glm::dot(ring[0], glm::cross(ring[1], ring[2]));
    for (const auto& [a, b] : sides_of(ring)) {
      const Place from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
      if (from < to)
        ++sides[{from, to}];
      else
        --sides[{to, from}];
    }
  }
  return volume > 0 && std::ranges::all_of(sides, [](const auto& side) { return side.second == 0; });
}

/// Triangles rasterized with a depth buffer, rows upwards. A pixel has 3 x 3 samples; the middle one is its
/// centre, by which it is covered or not.
class Raster {
 public:
  explicit Raster(int side) : side_(side), samples_(static_cast<std::size_t>(9 * side * side)) {}

  /// corners: in pixels. nearness: of each corner, linear in the picture. light: what its samples show.
  void add(const std::array<dvec2, 3>& corners, dvec3 nearness, LinearRgb light, bool front) {
    const int across = 3 * side_;
    const auto triangle = static_cast<std::int32_t>(lights_.size());
    lights_.push_back(light);
    fronts_.push_back(front);
    triangle_coverage::Triangle snapped;
    for (std::size_t i = 0; i < 3; ++i) snapped[i] = triangle_coverage::snap(3.0 * corners[i]);
    triangle_coverage::cover(snapped, {{0, 0}, ivec2(across - 1)}, [&](ivec2 p, const auto& weights) {
      if (p.x % 3 == 1 && p.y % 3 == 1) ++written_;
      Sample& sample = samples_[static_cast<std::size_t>(p.y * across + p.x)];
      const double near = glm::dot(triangle_coverage::barycentric(weights), nearness);
      if (near > sample.nearness) {
        sample.nearness = near;
        sample.triangle = triangle;
      }
    });
  }

  /// Pixels that were written, again wherever a triangle covers one that another has covered.
  std::int64_t written() const { return written_; }
  /// Pixels where the nearest triangle turns its back; near the rim of a closed model it may by rounding.
  std::int64_t inside() const {
    std::int64_t count = 0;
    for (ivec2 p{0, 0}; p.y < side_; ++p.y) {
      for (p.x = 0; p.x < side_; ++p.x) {
        const Sample& sample = this->sample(3 * p + 1);
        count += sample.covered() && !fronts_[static_cast<std::size_t>(sample.triangle)];
      }
    }
    return count;
  }
  /// The mean of its covered samples, opaque by how many they are.
  std::optional<Rgba8> tone(ivec2 pixel) const {
    LinearRgb sum{0};
    int covered = 0;
    for (int i = 0; i < 9; ++i) {
      const Sample& sample = this->sample(3 * pixel + ivec2{i % 3, i / 3});
      if (!sample.covered()) continue;
      sum += lights_[static_cast<std::size_t>(sample.triangle)];
      ++covered;
    }
    if (covered == 0) return std::nullopt;
    return in_share(tone_of(dvec3(sum) / double(covered)), covered / 9.0);
  }

 private:
  struct Sample {
    double nearness = -std::numeric_limits<double>::infinity();
    std::int32_t triangle = -1;  ///< the nearest one
    bool covered() const { return triangle >= 0; }
  };
  const Sample& sample(ivec2 p) const { return samples_[static_cast<std::size_t>(p.y * 3 * side_ + p.x)]; }

  int side_;
  std::vector<Sample> samples_;
  std::vector<LinearRgb> lights_{};  ///< by triangle
  std::vector<bool> fronts_{};
  std::int64_t written_ = 0;
};

class ModelStory {
 public:
  explicit ModelStory(Narrator& narrator)
      : narrator_(narrator),
        names_{narrator.words().say("picture.all"), narrator.words().say("picture.away"),
               narrator.words().say("picture.drawn")},
        subject_(subject_of(narrator.arguments(), given_triangles(narrator.arguments()))),
        signs_(exact_signs(subject_)),
        shelf_(narrator, {.size = ivec2(side),
                          .names = names_,
                          .gap = 3,
                          .heading = 7,
                          .y_up = true,
                          .plot = 12,
                          .fine = fine}) {
    if (!subject_.distant) require_places(narrator.arguments(), subject_, "model", false);
    outlines_ = subject_.outlines();
    const Extent extent = extent_around(std::views::join(outlines_));
    const double across = std::max(extent.size().x, extent.size().y);
    scale_ = (side - 2) * fine / (across > 0 ? across : 1);
    corner_ = extent.centre() - 0.5 * side * fine / scale_;
  }

  void tell() {
    const std::string model = name_of_model(narrator_.arguments(), own_model);
    narrator_.subtitle("subtitle.model", {{"model", model}, {"side", side * fine}});
    narrator_.columns({{"picture", false}, {"triangles"}, {"pixels"}});
    for (std::size_t k = 0; k < names_.size(); ++k) shelf_.wait(k);
    shelf_.start({.text = "model", .words = {{"model", model}, {"all", signs_.size()}}});
    const Taken all = take(0, "for (auto i : numbers_of(faces))", [](int) { return true; });
    const Taken away = take(1, "int sign = sign_of(dot", [](int sign) { return sign <= 0; });
    const Taken drawn = take(2, "int sign = sign_of(dot", [](int sign) { return sign > 0; });
    const double saved =
        static_cast<double>(away.pixels) / static_cast<double>(std::max(all.pixels, std::int64_t{1}));
    shelf_.finish({.text = all.inside > 0 ? "model.finished.open" : "model.finished",
                   .words = {{"away", away.triangles},
                             {"all", all.triangles},
                             {"share", std::round(100 * saved)},
                             {"inside", all.inside}}});
    narrator_.telling({4, 0});  // all three beside each other, in one sentence
    narrator_.result({{"tests", all.triangles},
                      {"drawn", drawn.triangles},
                      {"pixels", all.pixels},
                      {"pixels_saved", away.pixels},
                      {"pixels_inside", all.inside}});
  }

 private:
  static constexpr int side = 48, fine = 8;  ///< of a picture, in cells, and pixels a cell

  struct Taken {
    std::int64_t triangles, pixels, inside;
  };

  static std::vector<NamedFace> given_triangles(const Arguments& arguments) {
    const Mesh mesh = given_model(arguments, own_model);
    if (const std::int64_t count = triangle_count(mesh); count == 0 || count > most_triangles)
      refuse("model", "expected a model of 1 to {} triangles, found {}", most_triangles, count);
    return placed_triangles(mesh, !names_a_model(arguments));
  }

  dvec3 nearness(std::size_t i) const {
    const Ring& view = subject_.view[i];
    const auto of = [&](double depth) { return subject_.distant ? -depth : 1 / depth; };
    return {of(view[0].z), of(view[1].z), of(view[2].z)};
  }
  /// A tone of its picture, the lighter the straighter it is seen.
  LinearRgb light(std::size_t k, std::size_t i) const {
    // In grey, too, backs are lighter than fronts
    constexpr std::array<Rgba8, 3> inks{{{118, 128, 138, 255}, {232, 120, 30, 255}, {0, 105, 170, 255}}};
    constexpr std::array<float, 3> highlights{0.3F, 0.35F, 0.2F};
    const Ring& ring = subject_.rings[i];
    const dvec3 normal = unit_vector(newell_normal<double>(ring)),
                view = unit_vector(view_vector<double>(ring, subject_.eye));
    const auto cosine = static_cast<float>(std::abs(glm::dot(normal, view)));
    return linear_from_srgb8(inks[k]) * (0.35F + 0.65F * cosine) + LinearRgb(highlights[k] * cosine * cosine);
  }

  /// The step of the k-th picture, of all triangles with such a sign. decides: the line by which they are
  /// told.
  template <class Shows>
  Taken take(std::size_t k, std::string_view decides, const Shows& shows) {
    Raster raster(side * fine);
    Taken taken{0, 0, 0};
    for (std::size_t i = 0; i < signs_.size(); ++i) {
      if (!shows(signs_[i])) continue;
      ++taken.triangles;
      std::array<dvec2, 3> corners;
      for (std::size_t c = 0; c < 3; ++c) corners[c] = (outlines_[i][c] - corner_) * scale_;
      raster.add(corners, nearness(i), light(k, i), signs_[i] > 0);
    }
    taken.pixels = raster.written();
    taken.inside = are_closed(subject_.rings) ? 0 : raster.inside();
    const auto note = [&](std::string_view what, std::int64_t n, double below) {
      shelf_.mark(k, std::string(what), Role::guide,
                  Text{shelf_.on_paper(k, {0.5 * side, -below}),
                       narrator_.words().say(fmt::format("below.{}", what), {{"n", n}})});
    };
    note("triangles", taken.triangles, 3.2);
    note("pixels", taken.pixels, 8.8);
    constexpr std::array<std::string_view, 3> keys{"all", "away", "drawn"};
    shelf_.show("PictureDrawn", line_with(narrator_.trace().listing, decides),
                [&](ivec2 p) { return raster.tone(p); },
                {.text = fmt::format("model.{}", keys[k]),
                 .facts = {{"triangles", taken.triangles}, {"pixels", taken.pixels}},
                 .words = {{"n", taken.triangles}, {"all", signs_.size()}, {"pixels", taken.pixels}},
                 .row = {names_[k], taken.triangles, taken.pixels},
                 .key = std::string(keys[k]),
                 .phase = names_[k]});
    return taken;
  }

  Narrator& narrator_;
  const std::vector<std::string> names_;
  const Subject subject_;  ///< its faces are triangles
  const std::vector<int> signs_;
  PictureShelf shelf_;
  std::vector<Ring2> outlines_{};
  double scale_ = 1;
  dvec2 corner_{};  ///< of the pictures, as outlines have places
};

inline void tell_model(Narrator& narrator) { ModelStory(narrator).tell(); }

}  // namespace gradus::back_face_culling
