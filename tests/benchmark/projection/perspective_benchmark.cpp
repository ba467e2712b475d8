// Points of view space into normalized device coordinates, beside GLM's perspective matrix.

#include "projection/perspective/perspective.hpp"

#include <glm/ext/matrix_clip_space.hpp>

#include "benchmark/answers.hpp"
#include "stress/projection/perspective.hpp"

namespace gradus::bench {
namespace {

using namespace answers;
using Points = Set<dvec3, 3>;

const Lens lens{1, 0.1, 100};
constexpr double aspect = 1.5;

std::array<Wide, 3> reference(dvec3 p) {
  const Wide half = Wide(lens.vertical_radians) / 2, y_scale = cos(half) / sin(half);
  const Projection<Wide> exact{.x_scale = y_scale / aspect, .y_scale = y_scale, .z_scale = 0, .z_offset = 0};
  return stress::place_in_box<Wide>(exact, lens.near, lens.far, {p.x, p.y, p.z});
}

/// So many points that the camera sees, from `nearest` to `farthest`.
const Points& points(double nearest, double farthest, std::size_t count) {
  const auto make = [=](Random& random) {
    const double z = random.uniform(nearest, farthest), x = random.uniform(-0.8, 0.8);
    return dvec3(z * x, z * random.uniform(-0.5, 0.5), z);
  };
  return made_once<dvec3, 3>(std::pair(nearest, farthest), count, make, reference);
}

void add_cases(std::vector<Case>& cases, const Points& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto one) {
    cases.push_back(case_of<dvec3>(name, standing, set, each(one), workload));
  };
  const Projection<double> projection = projection_of(lens, aspect);
  add("transform, divide", Standing::taught,
      [projection](dvec3 p) { return perspective::divide(perspective::transform(projection, p)); });
  const auto by_matrix = [](const glm::dmat4& m) {
    return [m](dvec3 p) {
      const glm::dvec4 clip = m * glm::dvec4(p, 1);
      return dvec3(clip) / clip.w;
    };
  };
  add("projection_matrix", Standing::taught, by_matrix(projection_matrix(projection)));
  add("glm::perspectiveLH_ZO", Standing::peer,
      by_matrix(glm::perspectiveLH_ZO(lens.vertical_radians, aspect, lens.near, lens.far)));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, points(lens.near, lens.far, 4096), {"near to far"});
  add_cases(all, points(lens.near, 1.0001 * lens.near, 4096), {"at the near plane"});
  for (const std::size_t count : {16u, 256u, 4096u, 65536u}) {
    add_cases(all, points(1, lens.far, count), {fmt::format("{} points", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject perspective() {
  return {.topic = "perspective",
          .title = "Points in perspective",
          .item = "point",
          .unit = "ulp",
          .measure = "points",
          .telling = "near to far",
          .cases = cases,
          .choice = {"transform, divide", "as near as by a matrix, in the least time"}};
}

}  // namespace gradus::bench
