// A Bézier curve three ways: a point of it, chords for it, and the rounds that lead to a point, as a figure.
// Writes bezier_curve.svg into the current folder.

#include "modeling/bezier_curve/bezier_curve.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::bezier_curve;
  const std::vector<dvec2> control{{0, 0}, {5, 15}, {15, 0}, {20, 15}};

  const dvec2 point = de_casteljau<2, double>(control, 0.5);
  fmt::print("in the middle: ({}, {})\n", point.x, point.y);

  // Chords within a tolerance, each told
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Flattened<2, double>>)
      fmt::print("a chord from t = {} to {}\n", step.piece.from, step.piece.to);
  };
  flatten<2, double>(control, 1.0, watch);

  // The last of the rounds as a figure
  const Trace trace = trace_of(*find_entry("bezier_curve"), {{"t", "1/2"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/bezier_curve", ""};
  std::ofstream file("bezier_curve.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
