// Rotations about any axis, as matrices, by every method, beside GLM's rotate.

#include "transformation/affine_3d/affine_3d.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <map>

#include "benchmark/answers.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace answers;

struct Rotation {
  dvec3 axis;
  double radians;
};
using Rotations = Set<Rotation, 9>;

/// cos I + (1 - cos) n n^T + sin [n]x, column by column.
std::array<Wide, 9> reference(const Rotation& r) {
  const Wide x = r.axis.x, y = r.axis.y, z = r.axis.z, length = sqrt(x * x + y * y + z * z);
  const Wide n[] = {x / length, y / length, z / length}, s = sin(Wide(r.radians)), c = cos(Wide(r.radians));
  const Wide across[3][3] = {{0, n[2], -n[1]}, {-n[2], 0, n[0]}, {n[1], -n[0], 0}};
  std::array<Wide, 9> m;
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      m[3 * column + row] =
          (row == column ? c : Wide(0)) + (1 - c) * n[row] * n[column] + s * across[column][row];
    }
  }
  return m;
}

/// So many rotations by angles up to `most`.
const Rotations& rotations(double most, std::size_t count) {
  static std::map<std::pair<double, std::size_t>, Rotations> made;
  const auto [place, added] = made.try_emplace({most, count});
  Rotations& set = place->second;
  if (!added) return set;
  Random random(1);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    set.inputs.push_back({{x, y, random.uniform(-1, 1)}, random.uniform(-most, most)});
    set.right.push_back(reference(set.inputs.back()));
  }
  return set;
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
          .cases = cases};
}

}  // namespace gradus::bench
