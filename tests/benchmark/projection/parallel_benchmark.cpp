// Points cast onto the plane z = d along a slanted direction, by every method that can.

#include "projection/parallel/parallel.hpp"

#include "benchmark/answers.hpp"
#include "projection/parallel/parallel_notes.hpp"
#include "stress/projection/parallel.hpp"

namespace gradus::bench {
namespace {

using namespace answers;
using Points = Set<dvec3, 3>;

constexpr double d = 0.7;
const dvec3 direction{0.3, -0.2, 0.9};

std::array<Wide, 3> reference(dvec3 p) {
  return stress::crossing_of<Wide>({0, 0, 1}, d, {direction.x, direction.y, direction.z}, {p.x, p.y, p.z});
}

/// So many points within `most` of the origin.
const Points& points(double most, std::size_t count) {
  const auto make = [most](Random& random) {
    const double x = random.uniform(-most, most), y = random.uniform(-most, most);
    return dvec3(x, y, random.uniform(-most, most));
  };
  return made_once<dvec3, 3>(most, count, make, reference);
}

void add_cases(std::vector<Case>& cases, const Points& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto one) {
    cases.push_back(case_of<dvec3>(name, standing, set, each(one), workload));
  };
  const auto slant = parallel::slant_of(direction);
  const parallel::Plane<double> plane{{0, 0, 1}, d};
  add("oblique", Standing::taught, [slant](dvec3 p) { return parallel::oblique(d, slant, p); });
  add("along", Standing::robust, [plane](dvec3 p) { return parallel::along(plane, direction, p); });
  add("matrix_of", Standing::taught, [m = parallel::matrix_of(plane, direction)](dvec3 p) {
    const glm::dvec4 image = m * glm::dvec4(p, 1);
    return dvec3(image) / image.w;
  });
  add("keep_x_and_y", Standing::faulty, [slant](dvec3 p) { return parallel::keep_x_and_y(d, slant, p); });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, points(1, 4096), {"a cube"});
  add_cases(all, points(1e6, 4096), {"a cube of two million"});
  for (const std::size_t count : {16u, 256u, 4096u, 65536u}) {
    add_cases(all, points(10, count), {fmt::format("{} points", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject parallel() {
  return {.topic = "parallel",
          .title = "Points cast onto a plane",
          .item = "point",
          .unit = "ulp",
          .measure = "points",
          .telling = "a cube",
          .cases = cases,
          .choice = {"oblique", "for planes z = d; along takes any plane and direction"}};
}

}  // namespace gradus::bench
