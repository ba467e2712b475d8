// Frames of cameras from where they stand and what they look at, beside GLM's lookAtRH.

#include "projection/viewing/viewing.hpp"

#include <glm/ext/matrix_transform.hpp>

#include "benchmark/answers.hpp"
#include "stress/projection/viewing.hpp"

namespace gradus::bench {
namespace {

using namespace answers;

struct Look {
  dvec3 eye, target, up;
};
using Looks = Set<Look, 9>;

/// Right, up, forward.
std::array<Wide, 9> reference(const Look& look) {
  const auto [right, up, forward, sine] = stress::axes_of<Wide>(look.eye, look.target, look.up);
  return {right[0], right[1], right[2], up[0], up[1], up[2], forward[0], forward[1], forward[2]};
}

/// So many cameras, one unit or so from what they look at: near the origin, a million away, or looking up
/// along the hint but for 1e-6.
const Looks& looks(const std::string& kind, std::size_t count) {
  const auto make = [kind](Random& random) {
    const auto within = [&](double most) {
      const double x = random.uniform(-most, most), y = random.uniform(-most, most);
      return dvec3(x, y, random.uniform(-most, most));
    };
    Look look{within(kind == "a million away" ? 1e6 : 10), {}, {0, 1, 0}};
    look.target =
        look.eye + (kind == "nearly upwards" ? dvec3(0, 1, 0) + within(1e-6) : within(1) + dvec3(0, 0, 2));
    return look;
  };
  return made_once<Look, 9>(kind, count, make, reference);
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
          .cases = cases,
          .choice = {"look_at", "within its bounds for every view, nearly upwards too"}};
}

}  // namespace gradus::bench
