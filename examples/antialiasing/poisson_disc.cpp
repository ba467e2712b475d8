// Samples that keep their distance three ways: how many and how near, the tries as the walk reports them, a
// step as a figure.
// Writes poisson_disc.svg into the current folder.

#include "antialiasing/poisson_disc/poisson_disc.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::poisson_disc;

  // The samples alone, in a tile 1 wide
  std::vector<dvec2> samples;
  bridson(tile, 0.1, 30, Random(1), [&](dvec2 p) { samples.push_back(p); });
  fmt::print("{} samples, the nearest two {:.4f} apart\n", samples.size(), least_distance(tile, samples));

  // How many places were tried for them
  int tried = 0, kept = 0;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Tried>) ++tried, kept += step.kept;
  };
  bridson(tile, 0.1, 30, Random(1), [](dvec2) {}, watch);
  fmt::print("{} of {} places kept\n", kept, tried);

  // A step as a figure
  const TopicEntry& topic = *find_entry("poisson_disc");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/antialiasing/poisson_disc", ""};
  std::ofstream file("poisson_disc.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
