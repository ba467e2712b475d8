// Rotations about any axis, as matrices, by every method, beside GLM's rotate.

#include "transformation/affine_3d/affine_3d.hpp"

#include <glm/ext/matrix_transform.hpp>

#include "benchmark/answers.hpp"
#include "stress/transformation/affine_3d.hpp"

namespace gradus::bench {
namespace {

using namespace answers;

struct Rotation {
  dvec3 axis;
  double radians;
};
using Rotations = Set<Rotation, 9>;

/// So many rotations by angles up to `most`.
const Rotations& rotations(double most, std::size_t count) {
  const auto make = [most](Random& random) -> Rotation {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    return {{x, y, random.uniform(-1, 1)}, random.uniform(-most, most)};
  };
  return made_once<Rotation, 9>(
      most, count, make, [](const Rotation& r) { return stress::rotation_about<Wide>(r.axis, r.radians); });
}

void add_cases(std::vector<Case>& cases, const Rotations& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto one) {
    cases.push_back(case_of<glm::dmat3>(name, standing, set, each(one), workload));
  };
  add("rodrigues", Standing::taught, [](const Rotation& r) {
    return glm::dmat3(affine_3d::rodrigues(affine_3d::direction_of(r.axis), turn(r.radians)));
  });
  add("decomposition", Standing::taught, [](const Rotation& r) {
    return glm::dmat3(affine_3d::decomposition(dvec3(0), affine_3d::alignment(r.axis), turn(r.radians)));
  });
  add("rotation", Standing::robust,
      [](const Rotation& r) { return glm::dmat3(affine_3d::rotation(r.axis, r.radians)); });
  add("glm::rotate", Standing::peer,
      [](const Rotation& r) { return glm::dmat3(glm::rotate(glm::dmat4(1), r.radians, r.axis)); });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, rotations(7, 1024), {"up to a full turn"});
  add_cases(all, rotations(1e-8, 1024), {"up to 1e-8 radians"});
  add_cases(all, rotations(1e9, 1024), {"up to 1e9 radians"});
  for (const std::size_t count : {16u, 128u, 1024u}) {
    add_cases(all, rotations(7, count), {fmt::format("{} rotations", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject affine_3d() {
  return {.topic = "affine_3d",
          .title = "Rotations about any axis",
          .item = "rotation",
          .unit = "ulp",
          .measure = "rotations",
          .telling = "up to a full turn",
          .cases = cases,
          .choice = {"rotation", "the most nearly orthogonal matrix, made once for many points"}};
}

}  // namespace gradus::bench
