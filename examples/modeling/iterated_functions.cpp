// Barnsley's fern two ways, its dimension at most, and a piece that a map lays smaller, as a figure.
// Writes iterated_functions.svg into the current folder.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "modeling/iterated_functions/similarity_dimension.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::iterated_functions;
  const Maps<double> maps = fern;

  // All pieces: how large the largest one is on each level
  deterministic(maps, 5, []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, LevelDone>)
      fmt::print("level {}: {} pieces, stretched by {:.3f} at most\n", step.level, step.pieces, step.largest);
  });

  // One point: how far up it comes
  double highest = 0;
  const auto plot = [&](dvec2 p) { highest = std::max(highest, p.y); };
  chaos_game(maps, shares_by_area(maps), Game<double>{{0, 0}, 20, 10'000, 1}, plot);
  fmt::print("the highest of 10,000 points lies at {:.3f}\n", highest);

  std::vector<double> ratios;
  for (const DMap& f : maps) ratios.push_back(stretch(f));
  fmt::print("dimension at most {:.2f}\n", similarity_dimension(ratios, 30));

  const Trace trace = trace_of(*find_entry("iterated_functions"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/iterated_functions", ""};
  std::ofstream file("iterated_functions.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
