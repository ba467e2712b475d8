// A disc with one and with 4 x 4 samples per pixel, as text; a pixel's samples as the walk reports them; a
// step as a figure.
// Writes supersampling.svg into the current folder.

#include "antialiasing/supersampling/supersampling.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::supersampling;

  // The pixels alone
  const auto disc = [](dvec2 p) { return (p.x - 6) * (p.x - 6) + (p.y - 4) * (p.y - 4) < 9 ? 1.0 : 0.0; };
  for (const int n : {1, 4}) {
    const auto plot = [](ivec2 p, double share) {
      fmt::print("{}{}", " .:-=+*#%@"[static_cast<std::size_t>(9 * share)], p.x == 11 ? "\n" : "");
    };
    supersample({{0, 0}, {11, 7}}, n, Filter::box, disc, plot);
  }

  // One pixel's samples, as they are added
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Added<double>>)
      fmt::print("cell ({}, {}): {}, sum {}\n", step.cell.x, step.cell.y, step.value, step.sum);
  };
  supersample({{3, 3}, {3, 3}}, 2, Filter::box, disc, [](ivec2, double) {}, watch);

  // The step that tells most as a figure
  const TopicEntry& topic = *find_entry("supersampling");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/antialiasing/supersampling", ""};
  std::ofstream file("supersampling.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
