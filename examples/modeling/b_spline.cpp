// A B-spline three ways: a point of it, its pieces as Bézier curves, and the rounds that lead to a point, as
// a figure. Writes b_spline.svg into the current folder.

#include "modeling/b_spline/b_spline.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::b_spline;
  const std::vector<dvec2> control{{10, 7}, {20, 4}, {30, 12}, {0, 17}, {0, 3}, {30, 0}};
  const std::vector<double> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  const Spline<2, double> spline{control, knots};

  const dvec2 point = de_boor(spline, 2.4);
  fmt::print("at 2.4: ({:.4g}, {:.4g})\n", point.x, point.y);

  for (const auto& piece : bezier_pieces(spline))
    fmt::print("a Bézier curve from t = {} to {}\n", piece.from, piece.to);

  // The last of the rounds as a figure
  const Trace trace = trace_of(*find_entry("b_spline"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/b_spline", ""};
  std::ofstream file("b_spline.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
