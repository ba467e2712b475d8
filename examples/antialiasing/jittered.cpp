// A pixel's samples three ways: their places, the mean of what they see as the walk reports it, a step as a
// figure.
// Writes jittered.svg into the current folder.

#include "antialiasing/jittered/jittered.hpp"

#include <fmt/core.h>

#include <array>
#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::jittered;

  // The places alone
  std::array<dvec2, 9> samples;
  jittered::jittered(samples, numbers_of(7));
  for (const dvec2 p : samples) fmt::print("({:.3f}, {:.3f})\n", p.x, p.y);

  // What they see of a scene that is white below x + y = 1: half of the pixel
  const auto scene = [](dvec2 p) { return p.x + p.y < 1 ? 1.0 : 0.0; };
  const auto watch = [](const Looked<double>& step) {
    fmt::print("sample {} sees {}, mean {:.3f}\n", step.index, step.colour, step.mean);
  };
  sample_pixel({0, 0}, samples, scene, watch);

  // The step that decides as a figure
  const TopicEntry& topic = *find_entry("jittered");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/antialiasing/jittered", ""};
  std::ofstream file("jittered.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
