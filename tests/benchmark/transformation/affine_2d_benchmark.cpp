// Points under a chain of three transformations about a centre, beside GLM's matrices.

#include "transformation/affine_2d/affine_2d.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/matrix_transform_2d.hpp>

#include "benchmark/answers.hpp"
#include "stress/transformation/affine_2d.hpp"

namespace gradus::bench {
namespace {

using namespace answers;
using Points = Set<dvec2, 2>;

constexpr double degrees = 30;
const dvec2 factors_of_scaling{1.5, 0.75}, shift{3, -2};

/// Scaled and turned about `centre`, then moved.
std::vector<affine_2d::Factor<double>> chain(dvec2 centre) {
  return {affine_2d::scaling(factors_of_scaling, centre), affine_2d::rotation(turn_degrees(degrees), centre),
          affine_2d::translation(shift)};
}

/// As seen from the centre.
std::array<Wide, 2> reference(dvec2 p, dvec2 centre) {
  struct Place {
    Wide x, y;
  };
  const Place from_centre{Wide(p.x) - centre.x, Wide(p.y) - centre.y}, origin{0, 0};
  const Place larger = stress::scaled(from_centre, {factors_of_scaling.x, factors_of_scaling.y}, origin);
  const auto [x, y] = stress::turned(larger, Wide(1) / 2, Wide(sqrt(Wide(3)) / 2), origin);
  return {x + shift.x, y + shift.y};
}

/// So many points round a centre that lies `away` from the origin.
const Points& points(double away, std::size_t count) {
  const auto make = [away](Random& random) {
    const double x = random.uniform(-1, 1);
    return dvec2(away) + dvec2(x, random.uniform(-1, 1));
  };
  return made_once<dvec2, 2>(away, count, make, [away](dvec2 p) { return reference(p, dvec2(away)); });
}

/// Errors are those of the way from the centre, to which subtracting it adds none.
void add_cases(std::vector<Case>& cases, double away, const Points& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto transform, bool from_centre = false) {
    const auto found = std::make_shared<std::vector<dvec2>>(set.inputs.size());
    const auto run = [transform, found, &set, factors = chain(dvec2(away))] {
      *found = set.inputs;
      transform(factors, *found);
    };
    run();
    std::vector<dvec2> seen = *found;
    for (dvec2& p : seen) p -= from_centre ? dvec2(0) : dvec2(away);
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = workload,
                     .items = static_cast<std::int64_t>(set.inputs.size()),
                     .run = run,
                     .error = error_of(seen, set.right)});
  };
  using Factors = std::span<const affine_2d::Factor<double>>;
  using Span = std::span<dvec2>;
  add("one_matrix", Standing::taught, [](Factors f, Span p) { affine_2d::one_matrix(f, p); });
  add("factor_by_factor", Standing::taught, [](Factors f, Span p) { affine_2d::factor_by_factor(f, p); });
  add(
      "local_coordinates", Standing::robust,
      [away](Factors f, Span p) { affine_2d::local_coordinates(dvec2(away), f, p); }, true);
  add("GLM's matrices", Standing::peer, [away](Factors, Span p) {
    const dvec2 centre(away);
    glm::dmat3 m = glm::translate(glm::dmat3(1), shift + centre);
    m = glm::rotate(m, glm::radians(degrees));
    m = glm::scale(m, factors_of_scaling);
    m = glm::translate(m, -centre);
    for (dvec2& point : p) point = dvec2(m * dvec3(point, 1));
  });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, 0, points(0, 4096), {"about the origin"});
  add_cases(all, 1048576, points(1048576, 4096), {"a million away"});
  for (const std::size_t count : {16u, 256u, 4096u, 65536u}) {
    add_cases(all, 10, points(10, count), {fmt::format("{} points", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject affine_2d() {
  return {.topic = "affine_2d",
          .title = "Points scaled, turned and moved",
          .item = "point",
          .unit = "ulp",
          .measure = "points",
          .telling = "a million away",
          .cases = cases,
          .choice = {"local_coordinates", "nothing is lost far from the origin; near it one_matrix will do"}};
}

}  // namespace gradus::bench
