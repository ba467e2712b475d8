// A concave polygon three ways: what remains of it in a window, the pieces it really has, one step as a
// figure. Writes sutherland_hodgman.svg into the current folder.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::sutherland_hodgman;

  // One polygon, with a bridge between its parts
  const std::vector<dvec2> letter_u{{2, -4}, {8, -4}, {8, 4}, {6, 4}, {6, -2}, {4, -2}, {4, 4}, {2, 4}};
  const Rectangle<double> window{{0, 0}, {10, 10}};
  for (const auto& v : clip_to_window(letter_u, window)) fmt::print("({}, {}) ", v.at.x, v.at.y);
  fmt::print("\n");

  // Two pieces, and the borders that had a part in them, as the algorithm reports it
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, CrossingsJoined<double>>)
      fmt::print("joined at border {}\n", step.border);
  };
  fmt::print("{} pieces\n", separate_pieces(letter_u, window, all_borders(window), watch).size());

  // The last step as a figure
  const Trace trace =
      trace_of(*find_entry("sutherland_hodgman"), {{"polygon", "2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {trace.last, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/clipping/sutherland_hodgman", ""};
  std::ofstream("sutherland_hodgman.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
