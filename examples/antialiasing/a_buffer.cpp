// A pixel's list three ways: a triangle's mask as bits, the weights as the walk reports them, a step as a
// figure.
// Writes a_buffer.svg into the current folder.

#include "antialiasing/a_buffer/a_buffer.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::a_buffer;

  // The mask alone, four rows of eight bits
  const Mask mask = mask_of(edges_of({ivec2(-40, 330), ivec2(190, -70), ivec2(-40, -70)}), ivec2(0));
  for (int i = 0; i < samples; ++i)
    fmt::print("{}{}", (mask & bit_of(i)) != 0 ? '#' : '.', i % mask_columns == mask_columns - 1 ? "\n" : "");

  // Before a farther fragment that fills the pixel
  std::vector<Fragment> list{{gradus::a_buffer::full, 0.8, 0.9, 1, 1, 1}, {mask, 0.2, 0.3, 1, 0, 0}};
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Weighed>)
      fmt::print("fragment {}: {:08x} is seen, weight {}\n", step.number, step.visible, step.weight);
  };
  resolve(list, [](const Fragment&, double) {}, ByRange{}, watch);

  // A fragment that is hidden in part as a figure
  const TopicEntry& topic = *find_entry("a_buffer");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/antialiasing/a_buffer", ""};
  std::ofstream file("a_buffer.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
