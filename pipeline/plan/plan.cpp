#include "plan/plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <map>

#include "core/camera.hpp"
#include "core/contract.hpp"
#include "core/mesh.hpp"
#include "stages/3_perspective.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"

namespace gradus::pipeline {
namespace {

/// What a few dozen roundings of a sum may be off, in shares of the sizes of its terms.
constexpr double slack = 0x1p-44;

/// A point and, number by number, the sizes of the terms that it is the sum of.
struct Bounded {
  glm::dvec4 at, terms;
};

/// A transformation, and the sizes of its terms through all its factors.
struct Way {
  glm::dmat4 matrix, terms;

  Bounded operator()(dvec3 point) const {
    const glm::dvec4 p(point, 1);
    return {matrix * p, terms * glm::abs(p)};
  }
};

glm::dmat4 sizes(const glm::dmat4& m) {
  return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])};
}

Way operator*(const Way& second, const Way& first) {
  return {second.matrix * first.matrix, second.terms * first.terms};
}

Way way_of(const glm::dmat4& matrix) { return {matrix, sizes(matrix)}; }

/// From view space to clip space.
Way through_lens(const SceneLens& lens) {
  if (!lens.rays) return way_of(projection_matrix(lens.perspective));
  // (x + (d - z) a, y + (d - z) b, z - near, 1), each in its measure
  const auto& [height, slant, plane, near, far] = *lens.rays;
  const double y = 2 / height, x = y / lens.aspect, z = 1 / (far - near);
  return way_of({{x, 0, 0, 0},
                 {0, y, 0, 0},
                 {-x * slant.a, -y * slant.b, z, 0},
                 {x * slant.a * plane, y * slant.b * plane, -z * near, 1}});
}

/// From the world to clip space.
Way to_clip_space(const SceneCamera& camera, double aspect) {
  const Frame<double>& frame = camera.frame;
  Way view = way_of(view_matrix(frame));
  const dvec3 eye = glm::abs(frame.eye);
  view.terms[3] = {glm::dot(glm::abs(frame.right), eye), glm::dot(glm::abs(frame.up), eye),
                   glm::dot(glm::abs(frame.forward), eye), 1};
  return through_lens(lens_of(camera, aspect)) * view;
}

using Box = std::array<dvec3, 8>;
using Seen = std::array<Bounded, 8>;

Seen through(const Way& way, const Box& box) {
  Seen seen;
  std::ranges::transform(box, seen.begin(), way);
  return seen;
}

/// A half-space of clip space: where the product with this vector is at least 0.
using Half = glm::dvec4;

double distance_of(const Half& half, const Bounded& p) { return glm::dot(half, p.at); }
double error_of(const Half& half, const Bounded& p) { return slack * glm::dot(glm::abs(half), p.terms); }

/// Beyond doubt no point of the box lies in it.
bool all_outside(const Half& half, const Seen& seen) {
  return std::ranges::all_of(seen,
                             [&](const Bounded& p) { return distance_of(half, p) < -error_of(half, p); });
}
/// Beyond doubt every point does.
bool all_inside(const Half& half, const Seen& seen) {
  return std::ranges::all_of(seen,
                             [&](const Bounded& p) { return distance_of(half, p) > error_of(half, p); });
}

/// The six sides of what a window of the picture shows, in the order of Side. The window is a pixel wider:
/// corners are snapped.
std::array<Half, 6> sides_of(const Window& window, Size size) {
  const double left = 2.0 * (window.lower.x - 1) / size.width - 1,
               right = 2.0 * (window.upper.x + 2) / size.width - 1;
  const double upper = 1 - 2.0 * (window.lower.y - 1) / size.height,
               lower = 1 - 2.0 * (window.upper.y + 2) / size.height;
  return {Half{1, 0, 0, -left},  Half{-1, 0, 0, right}, Half{0, 1, 0, -lower},
          Half{0, -1, 0, upper}, Half{0, 0, 1, 0},      Half{0, 0, -1, 1}};
}

/// Of several the depth's: what lies behind the eye may be beside it, too.
std::optional<Side> side_beyond(const std::array<Half, 6>& sides, const Seen& seen) {
  using enum Side;
  for (const Side side : {near, far, left, right, lower, upper})
    if (all_outside(sides[static_cast<std::size_t>(side)], seen)) return side;
  return std::nullopt;
}

/// Whether nothing of the box meets a plane that stage 5 clips at.
bool needs_no_clipping(const Seen& seen, Size size) {
  return std::ranges::all_of(guard_volume(size), [&](const auto& plane) {
    Half half{0, 0, 0, plane.bound};
    half[plane.axis] = plane.sign;
    return all_inside(half, seen);
  });
}

/// The pixels from the smaller to the larger of these places, within a window.
Window pixels_between(dvec2 lower, dvec2 upper, const Window& window) {
  const auto pixel = [](double place, int least, int most) {
    return static_cast<int>(std::floor(std::clamp(place, double(least) - 1, double(most) + 1)));
  };
  const auto& [first, last] = window;
  return {
      {std::max(pixel(lower.x, first.x, last.x), first.x),
       std::max(pixel(lower.y, first.y, last.y), first.y)},
      {std::min(pixel(upper.x, first.x, last.x), last.x), std::min(pixel(upper.y, first.y, last.y), last.y)}};
}

/// Where the picture has a box that lies behind the near plane; nothing for any other.
std::optional<ScreenBox> extent_of(const Seen& seen, Size size, const Window& window) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  dvec2 lower{infinity}, upper{-infinity};
  double depth = 1;
  for (const Bounded& p : seen) {
    const glm::dvec4 error = slack * p.terms;
    if (!(p.at.w > 2 * error.w) || !(p.at.z > error.z)) return std::nullopt;
    const dvec3 ndc = dvec3(p.at) / p.at.w;
    // Half of w is left at least
    const dvec3 off = 2.0 * (dvec3(error) + glm::abs(ndc) * error.w) / p.at.w;
    const dvec2 place{(ndc.x + 1) / 2 * size.width, (1 - ndc.y) / 2 * size.height};
    const dvec2 wide = dvec2(off) * dvec2(size.width, size.height) / 2.0 + 1.0;
    lower = glm::min(lower, place - wide);
    upper = glm::max(upper, place + wide);
    depth = std::min(depth, ndc.z - off.z);
  }
  return ScreenBox{pixels_between(lower, upper, window), depth};
}

/// How far a point lies from a box at least.
double distance_between(dvec3 point, const Bounds& box) {
  return glm::length(glm::max(glm::max(box.lower - point, point - box.upper), dvec3{0}));
}

/// Whether some of the light may arrive in a box.
bool reaches(const Light& light, const Bounds& box) {
  if (light.kind == Light::Kind::directional) return true;
  // An area shines from half a diagonal round its middle
  const double around =
      light.kind == Light::Kind::area ? (glm::length(light.across) + glm::length(light.along)) / 2 : 0;
  const dvec3 terms = glm::abs(light.position) + glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const double error = slack * (terms.x + terms.y + terms.z + around);
  return !(distance_between(light.position, box) - around - error > light.range);
}

std::vector<int> lights_that_reach(const Scene& scene, const Bounds& box, bool all) {
  std::vector<int> numbers;
  int number = 0;
  for (const Light& light : scene.lights) {
    if (all || reaches(light, box)) numbers.push_back(number);
    ++number;
  }
  return numbers;
}

/// The box of a box in another place, widened by what rounding may be off; all of space where it overflows.
Bounds moved(const Box& box, const glm::dmat4& placement) {
  const Way way = way_of(placement);
  Bounds bounds;
  for (const dvec3 corner : box) {
    const Bounded p = way(corner);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(glm::length(p.terms) < infinity)) return {dvec3{-infinity}, dvec3{infinity}};
    bounds.add(dvec3(p.at - slack * p.terms));
    bounds.add(dvec3(p.at + slack * p.terms));
  }
  return bounds;
}

/// All that is the same for all objects.
class Planner {
 public:
  Planner(const Scene& scene, const Plan& plan)
      : scene_(scene),
        plan_(plan),
        clip_(to_clip_space(scene.camera, static_cast<double>(plan.size.width) / plan.size.height)),
        picture_(sides_of(picture_window(plan.size), plan.size)),
        window_(sides_of(plan.window, plan.size)) {}

  ObjectPlan operator()(const Object& object) {
    ObjectPlan plan;
    const Bounds& bounds = bounds_of_mesh(*object.mesh);
    if (bounds.empty()) return plan;
    const Box box = bounds.corners();
    const Seen seen = through(clip_ * way_of(object.placement), box);
    skip_what_lies_beyond(seen, plan);
    plan.whole = has(Rule::inside) && needs_no_clipping(seen, plan_.size);
    plan.extent = extent_of(seen, plan_.size, plan_.window);
    plan.lights = lights_that_reach(scene_, moved(box, object.placement), !has(Rule::out_of_range));
    return plan;
  }

 private:
  bool has(Rule rule) const { return plan_.rules.has(rule); }

  void skip_what_lies_beyond(const Seen& seen, ObjectPlan& plan) const {
    const auto skip = [&](Rule rule, const std::array<Half, 6>& sides) {
      if (plan.skipped || !has(rule)) return;
      plan.beyond = side_beyond(sides, seen);
      if (plan.beyond) plan.skipped = rule;
    };
    skip(Rule::outside, picture_);
    skip(Rule::area_of_interest, window_);
  }

  const Bounds& bounds_of_mesh(const Mesh& mesh) {
    const auto [known, is_new] = bounds_.try_emplace(&mesh);
    if (is_new) known->second = bounds_of(mesh);
    return known->second;
  }

  const Scene& scene_;
  const Plan& plan_;
  Way clip_;
  std::array<Half, 6> picture_, window_;
  std::map<const Mesh*, Bounds> bounds_{};
};

}  // namespace

Rules sound_rules(const Scene& scene, Rules rules) {
  const bool edges = scene.shading == Shading::wireframe;
  if (edges || scene.hidden_surfaces != HiddenSurfaces::z_buffer) rules = rules.without(Rule::hidden);
  return !edges && cuts(scene.hidden_surfaces) ? rules.without(Rule::outside).without(Rule::area_of_interest)
                                               : rules;
}

Plan plan_of(const Scene& scene, Size size, Rules rules, std::optional<Window> window) {
  Plan plan{size, window.value_or(picture_window(size)), sound_rules(scene, rules), {}};
  const auto& [lower, upper] = plan.window;
  expects(0 <= lower.x && lower.x <= upper.x && upper.x < size.width && 0 <= lower.y && lower.y <= upper.y &&
              upper.y < size.height,
          "a part of a picture of {} x {} pixels, not ({}, {}) to ({}, {})", size.width, size.height, lower.x,
          lower.y, upper.x, upper.y);
  Planner planned(scene, plan);
  plan.objects.reserve(scene.objects.size());
  for (const Object& object : scene.objects) plan.objects.push_back(planned(object));
  return plan;
}

}  // namespace gradus::pipeline
