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

/// The same line eight times, so that it is in every lane and in the rest.
std::optional<Line> by_batch(const Line& line, const Window& window) {
  std::vector<Line> lines(11, line);
  std::vector<std::uint8_t> accepted(lines.size());
  cohen_sutherland_2d::clip_batch(lines, window, lines, accepted);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!test::same_bits(lines[i], lines[0]) || accepted[i] != accepted[0])
      return Line{{wrong, wrong}, {wrong, wrong}};
  }
  return accepted[0] ? std::optional(lines[0]) : std::nullopt;
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
            .error = of(by_batch),
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
