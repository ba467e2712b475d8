// A cube three ways: which faces an eye sees from their front, the products watched by a lambda, one step as
// a figure. Writes back_face_culling.svg into the current folder.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::back_face_culling;
  const std::vector<std::vector<dvec3>> cube{
      {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, {{1, -1, -1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}},
      {{1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {1, 1, 1}}, {{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}},
      {{-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}}, {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}}};
  const std::vector<back_face_culling::Face<double>> faces(cube.begin(), cube.end());

  // Those that are drawn for an eye at (3, 4, 5)
  const Eye<double> eye{3, 4, 5, 1};
  normal_and_view<double>(faces, eye, [](std::size_t face) { fmt::print("face {} is drawn\n", face); });

  // What decides, as the algorithm reports it
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Judged<double>>) fmt::print("N.V = {}\n", step.value);
  };
  normal_and_view<double>(faces, eye, [](std::size_t) {}, watch);

  // Step 6 as a figure
  const Trace trace = trace_of(*find_entry("back_face_culling"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {6, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/visibility/back_face_culling", ""};
  std::ofstream("back_face_culling.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
