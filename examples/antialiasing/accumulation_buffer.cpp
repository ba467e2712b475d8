// The accumulation buffer three ways: its means alone, its passes watched by a lambda, one pass as a figure.
// Writes accumulation_buffer.svg into the current folder.

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::accumulation_buffer;

  // Three pixels in 2 x 2 passes; what lies left of x = 1.3 is white
  std::vector<double> means(3);
  const Sums<double> sums(means, {3, 1});
  const auto render = [](dvec2 place, const Sums<double>& plot) {
    for (int x = 0; x < 3; ++x) plot({x, 0}, x + place.x < 1.3 ? 1.0 : 0.0);
  };
  accumulate({2, 2}, render, sums);
  fmt::print("{} {} {}\n", means[0], means[1], means[2]);

  // The passes, as the algorithm reports them
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, PassAdded>)
      fmt::print("pass {} at ({}, {}): sum {}\n", step.pass, step.place.x, step.place.y, means[1]);
  };
  accumulate({2, 2}, render, sums, watch);

  // Pass 3 as a figure
  const TopicEntry& topic = *find_entry("accumulation_buffer");
  const Trace trace = trace_of(topic, {{"a", "2"}, {"b", "2"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 0});
  const std::string source = "examples/antialiasing/accumulation_buffer";
  const Colophon colophon{figure.title, caption_of(figure), source, ""};
  std::ofstream file("accumulation_buffer.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
