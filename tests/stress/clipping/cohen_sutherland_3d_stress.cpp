// The promises of Cohen and Sutherland's clipping to a box.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include "stress/clipping/axis_boxes.hpp"

namespace gradus::stress {

Domain cohen_sutherland_3d() {
  using axis_boxes::list;
  return {"cohen_sutherland_3d",
          {{.name = "correctly_rounded",
            .states = "accepts and rejects exactly; every end is the nearest double",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 12,
            .generate = axis_boxes::generate<3>,
            .error =
                [](const Input& input) {
                  return axis_boxes::error<3>(input, [](const auto& line, const auto& box) {
                    return cohen_sutherland_3d::correctly_rounded(line, box);
                  });
                },
            .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
              return {{"method", "correctly_rounded"}, {"line", list(i, 0, 6)}, {"box", list(i, 6, 6)}};
            },
            .traps = {{"a difference overflows", {-1e308, 0, 0, 1e308, 10, 10, 0, 0, 0, 10, 10, 10}},
                      {"through two corners", {-1, -1, -1, 11, 11, 11, 0, 0, 0, 10, 10, 10}},
                      {"touches a corner", {-1, 1, 0, 1, -1, 0, 0, 0, 0, 10, 10, 10}}}}}};
}

}  // namespace gradus::stress
