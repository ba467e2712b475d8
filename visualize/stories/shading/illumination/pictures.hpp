#pragma once
// A ball and a block on a floor, seen by one camera and lit by one kind of light after the other.

#include "core/raster.hpp"
#include "figure/tone_of.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/shading/illumination/subject.hpp"

namespace gradus::illumination {

struct PictureLit {
  Raster<LinearRgb> picture;  ///< row 0 below
  std::int64_t soft;          ///< pixels that part of the light reaches
  std::int64_t dark;          ///< pixels that nothing of it reaches
};

/// What there is to see.
class Room {
 public:
  static constexpr int fine = 6;  ///< pixels a cell of the drawing
  static constexpr int columns = 50 * fine, rows = 28 * fine;

  struct Hit {
    double t;
    dvec3 place, normal;
    bool floor;
  };

  /// The nearest thing along a ray, before `last`.
  static std::optional<Hit> along(const dvec3& from, const dvec3& way, double last) {
    std::optional<Hit> best;
    const auto take = [&](double t, const dvec3& normal, bool floor) {
      if (t > 1e-6 && t < last && (!best || t < best->t)) best = Hit{t, from + t * way, normal, floor};
    };
    if (way.z < 0) take(-from.z / way.z, {0, 0, 1}, true);
    const double b = glm::dot(from - ball, way), c = glm::dot(from - ball, from - ball) - radius * radius;
    if (b * b > c) {
      const double t = -b - std::sqrt(b * b - c);
      take(t, unit_vector(from + t * way - ball), false);
    }
    take_block(from, way, take);
    return best;
  }

  /// Through the middle of a pixel, of length 1.
  static dvec3 ray(int column, int row) {
    const dvec3 forward = unit_vector(target - eye), right = unit_vector(glm::cross(forward, dvec3{0, 0, 1}));
    const dvec3 up = glm::cross(right, forward);
    const double scale = 2 * 0.33 / columns;
    return unit_vector(forward +
                       scale * ((column + 0.5 - 0.5 * columns) * right + (row + 0.5 - 0.5 * rows) * up));
  }

  static constexpr dvec3 eye{1.2, -11, 6.2};

 private:
  template <class Take>
  static void take_block(const dvec3& from, const dvec3& way, const Take& take) {
    double enter = 0, leave = 1e9;
    dvec3 normal{0};
    for (int k = 0; k < 3; ++k) {
      if (way[k] == 0 && (from[k] < lower[k] || from[k] > upper[k])) return;
      if (way[k] == 0) continue;
      double a = (lower[k] - from[k]) / way[k], b = (upper[k] - from[k]) / way[k];
      const bool turned = a > b;
      if (turned) std::swap(a, b);
      if (a > enter) {
        enter = a;
        normal = dvec3{0};
        normal[k] = turned ? 1 : -1;
      }
      leave = std::min(leave, b);
    }
    if (enter < leave && normal != dvec3{0}) take(enter, normal, false);
  }

  static constexpr dvec3 target{0.35, 0.2, 0.75};
  static constexpr dvec3 ball{-1.15, 0, 1};
  static constexpr double radius = 1;
  static constexpr dvec3 lower{0.9, -0.6, 0}, upper{2.1, 0.8, 1.7};
};

/// The four kinds, one after the other.
inline constexpr std::array<const char*, 4> picture_kinds{"ambient", "point", "spot", "area"};

inline std::vector<Light> lights_of(const Arguments& arguments, std::size_t kind) {
  if (kind == 0) return {};
  Light light = lamp_of(arguments);
  constexpr std::array kinds{Light::Kind::point, Light::Kind::point, Light::Kind::spot, Light::Kind::area};
  light.kind = kinds[kind];
  light.position = {-3.2, -2.6, 5.6};
  light.direction = dvec3{-0.7, -0.1, 0.7} - light.position;
  if (light.kind == Light::Kind::area) {
    spread(light, share(arguments, "side"));
    light.constant = light.linear = 0;
    light.quadratic =
        1 / glm::dot(light.direction, light.direction);  // in the middle as strong as the others
  }
  return {light};
}

inline PictureLit lit_picture(const Arguments& arguments, std::size_t kind) {
  const std::vector<Light> lights = lights_of(arguments, kind);
  const Surface surface = surface_of(arguments);
  const dvec3 ambient{kind == 0 ? 4.0 : 1.0};
  const auto visible = [](const dvec3& place, const dvec3& l, double d) {
    return !Room::along(place + 1e-6 * l, l, d);
  };
  PictureLit result{{Room::columns, Room::rows}, 0, 0};
  for (int row = 0; row < Room::rows; ++row) {
    for (int column = 0; column < Room::columns; ++column) {
      const auto hit = Room::along(Room::eye, Room::ray(column, row), 1e9);
      LinearRgb colour{0.0f};
      int seen = 0, hidden = 0;
      if (hit) {
        Surface here = surface;
        if (hit->floor) here.specular = dvec3{0};
        const auto count = [&]<class Step>(const Step& step) {
          if constexpr (std::same_as<Step, LightAdded<double>>) {
            if (step.n_dot_l > 0) ++(step.arrival.seen ? seen : hidden);
          }
        };
        colour = LinearRgb(phong(hit->place, hit->normal, Room::eye, here, std::span<const Light>(lights),
                                 ambient, visible, count)
                               .sum());
        if (hit->floor) {
          result.soft += seen > 0 && hidden > 0;
          result.dark += seen == 0 && hidden > 0;
        }
      }
      result.picture[{column, row}] = colour;
    }
  }
  return result;
}

inline void tell_lights(Narrator& narrator) {
  constexpr std::array<std::string_view, 4> texts{"room.ambient", "room.point", "room.spot", "room.area"};
  narrator.subtitle("room.subtitle", {{"samples", narrator.arguments().integer("samples")}});
  narrator.columns({{"kind", false}, {"dark"}, {"soft"}});
  narrator.legend({{Role::past, "waiting"}});
  std::vector<std::string> names;
  for (const char* kind : picture_kinds) names.push_back(narrator.words().say(fmt::format("kind.{}", kind)));
  PictureShelf shelf(narrator, {.size = ivec2{Room::columns, Room::rows} / Room::fine,
                                .names = names,
                                .row = 2,
                                .heading = 7,
                                .y_up = true,
                                .fine = Room::fine});
  for (std::size_t k = 0; k < names.size(); ++k) shelf.wait(k);
  shelf.start({.text = "room", .words = {{"count", names.size()}}});
  std::vector<Field> results;
  std::int64_t soft = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const PictureLit lit = lit_picture(narrator.arguments(), k);
    soft = lit.soft;
    results.push_back({fmt::format("soft_{}", picture_kinds[k]), lit.soft});
    shelf.show("PictureLit", 0, [&](ivec2 p) { return tone_of(dvec3(lit.picture[p])); },
               {.text = texts[k],
                .facts = {{"soft", lit.soft}, {"dark", lit.dark}},
                .row = {names[k], lit.dark, lit.soft},
                .key = picture_kinds[k],
                .phase = names[k]});
  }
  shelf.finish({.text = soft > 0 ? "room.finished" : "room.finished.hard", .words = {{"soft", soft}}});
  narrator.result(results);
}

}  // namespace gradus::illumination
