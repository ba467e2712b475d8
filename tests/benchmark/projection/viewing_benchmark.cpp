// Frames of cameras from where they stand and what they look at, beside GLM's lookAtRH.

#include "projection/viewing/viewing.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <map>

#include "benchmark/answers.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace answers;

struct Look {
  dvec3 eye, target, up;
};
using Looks = Set<Look, 9>;
using Wide3 = std::array<Wide, 3>;

Wide3 unit(const Wide3& v) {
  const Wide length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}
Wide3 cross(const Wide3& a, const Wide3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Right, up, forward.
std::array<Wide, 9> reference(const Look& look) {
  const Wide3 forward = unit(
      {Wide(look.target.x) - look.eye.x, Wide(look.target.y) - look.eye.y, Wide(look.target.z) - look.eye.z});
  const Wide3 right = unit(cross(forward, {look.up.x, look.up.y, look.up.z}));
  const Wide3 up = cross(right, forward);
  return {right[0], right[1], right[2], up[0], up[1], up[2], forward[0], forward[1], forward[2]};
}

/// So many cameras, one unit or so from what they look at: near the origin, a million away, or looking up
/// along the hint but for 1e-6.
const Looks& looks(const std::string& kind, std::size_t count) {
  static std::map<std::pair<std::string, std::size_t>, Looks> made;
  const auto [place, added] = made.try_emplace({kind, count});
  Looks& set = place->second;
  if (!added) return set;
  Random random(1);
  const auto within = [&](double most) {
    const double x = random.uniform(-most, most), y = random.uniform(-most, most);
    return dvec3(x, y, random.uniform(-most, most));
  };
  for (std::size_t i = 0; i < count; ++i) {
    Look look{within(kind == "a million away" ? 1e6 : 10), {}, {0, 1, 0}};
    look.target =
        look.eye + (kind == "nearly upwards" ? dvec3(0, 1, 0) + within(1e-6) : within(1) + dvec3(0, 0, 2));
    set.inputs.push_back(look);
    set.right.push_back(reference(look));
  }
  return set;
}

void add_cases(std::vector<Case>& cases, const Looks& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto one) {
    cases.push_back(case_of<glm::dmat3>(name, standing, set, each(one), workload));
  };
  add("look_at", Standing::taught, [](const Look& look) {
    const Frame<double> frame = viewing::look_at(look.eye, look.target, look.up);
    return glm::dmat3(frame.right, frame.up, frame.forward);
  });
  // GLM's third row points to the viewer
  add("glm::lookAtRH", Standing::peer, [](const Look& look) {
    const glm::dmat4 m = glm::lookAtRH(look.eye, look.target, look.up);
    return glm::dmat3(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], -m[0][2], -m[1][2], -m[2][2]);
  });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* kind : {"near the origin", "a million away", "nearly upwards"}) {
    add_cases(all, looks(kind, 1024), {kind});
  }
  for (const std::size_t count : {16u, 128u, 1024u}) {
    add_cases(all, looks("near the origin", count),
              {fmt::format("{} cameras", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject viewing() {
  return {.topic = "viewing",
          .title = "Frames of cameras",
          .item = "camera",
          .unit = "ulp",
          .measure = "cameras",
          .telling = "nearly upwards",
          .cases = cases};
}

}  // namespace gradus::bench
