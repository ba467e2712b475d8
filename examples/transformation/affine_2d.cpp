// A turn and a scaling about one point: the matrix, the way of a corner, one step as a figure.
// Writes affine_2d.svg into the current folder.

#include "transformation/affine_2d/affine_2d.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::affine_2d;

  // Turn by 30 degrees, then scale by 2, both about (1, 1)
  const dvec2 centre{1, 1};
  const std::vector<Factor<double>> factors{rotation(turn_degrees(30.0), centre),
                                            scaling(dvec2{2, 2}, centre)};
  std::vector<dvec2> shape{{1, 1}, {3, 1}, {3, 2}};

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Moved<double>>) fmt::print("({}, {})\n", step.to.x, step.to.y);
  };
  const Matrix<double> m = one_matrix(std::span<const Factor<double>>(factors), std::span(shape), watch);
  fmt::print("areas grow by {}\n", determinant(m));

  // Step 2 of the same as a figure
  const Trace trace =
      trace_of(*find_entry("affine_2d"), {{"factors", "rotate 30 about 1,1; scale 2 about 1,1"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/transformation/affine_2d", ""};
  std::ofstream("affine_2d.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
