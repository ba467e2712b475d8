// The promises of Cohen and Sutherland's clipping in the plane.

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"
#include "stress/clipping/axis_boxes.hpp"

namespace gradus::stress {
namespace {

using axis_boxes::list;
using Line = Segment<2, double>;
using Window = AxisBox<2, double>;

std::optional<Line> correctly_rounded(const Line& line, const Window& window) {
  return cohen_sutherland_2d::correctly_rounded(line, window);
}

void by_batch(std::span<const Line> lines, const Window& window, std::span<Line> clipped,
              std::span<std::uint8_t> accepted) {
  cohen_sutherland_2d::clip_batch(lines, window, clipped, accepted);
}

auto figure_with(const char* method) {
  return [method](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
    return {{"method", method}, {"line", list(i, 0, 4)}, {"window", list(i, 4, 4)}};
  };
}

}  // namespace

Domain cohen_sutherland_2d() {
  const auto of = [](auto method) {
    return [method](const Input& input) { return axis_boxes::error<2>(input, method); };
  };
  return {"cohen_sutherland_2d",
          {{.name = "correctly_rounded",
            .states = "accepts and rejects exactly; every end is the nearest double",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 8,
            .generate = axis_boxes::generate<2>,
            .error = of(correctly_rounded),
            .arguments = figure_with("correctly_rounded"),
            .traps = axis_boxes::window_traps()},
           {.name = "clip_batch",
            .states = "the bits of correctly_rounded, in every lane",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 8,
            .generate = axis_boxes::generate<2>,
            .error = of(axis_boxes::in_every_lane<2>(by_batch, correctly_rounded)),
            .arguments = figure_with("correctly_rounded"),
            .traps = axis_boxes::window_traps()},
           {.name = "cut_of_a_cut",
            .states = "no bound: each cut starts from a rounded point; wrong decisions are left out",
            .unit = "ulp",
            .bound = wrong,
            .numbers = 8,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::ties},
            .generate = axis_boxes::generate<2>,
            .error =
                [](const Input& input) {
                  const double error = axis_boxes::error<2>(
                      input,
                      [](const Line& line, const Window& window) {
                        return cohen_sutherland_2d::cut_of_a_cut(line, window);
                      },
                      true);
                  return std::isinf(error) ? 0 : error;
                },
            .arguments = figure_with("cut_of_a_cut")}}};
}

}  // namespace gradus::stress
