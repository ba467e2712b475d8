// The promises of Liang and Barsky's clipping to a window and to a box.

#include "clipping/liang_barsky/liang_barsky.hpp"

#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "stress/clipping/axis_boxes.hpp"

namespace gradus::stress {

Domain liang_barsky() {
  using axis_boxes::list;
  return {"liang_barsky",
          {{.name = "correctly_rounded",
            .states = "accepts and rejects exactly; every end is the nearest double",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 8,
            .generate = axis_boxes::generate<2>,
            .error =
                [](const Input& input) {
                  return axis_boxes::error<2>(input, [](const auto& line, const auto& window) {
                    return liang_barsky::correctly_rounded(line, window);
                  });
                },
            .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
              return {{"method", "correctly_rounded"}, {"line", list(i, 0, 4)}, {"window", list(i, 4, 4)}};
            },
            .traps = axis_boxes::window_traps()},
           {.name = "box_correctly_rounded",
            .states = "accepts and rejects exactly; every end is the nearest double",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 12,
            .generate = axis_boxes::generate<3>,
            .error = [](const Input& input) {
              return axis_boxes::error<3>(input, [](const auto& line, const auto& box) {
                return liang_barsky::box_correctly_rounded(line, box);
              });
            }}}};
}

}  // namespace gradus::stress
