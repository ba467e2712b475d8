// A triangle's shares of its pixels three ways: as text, with the pixels that take samples, a step as a
// figure. Writes adaptive.svg into the current folder.

#include "antialiasing/adaptive/adaptive.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using adaptive::each_sample, adaptive::n_rooks, adaptive::ScreenTriangle, adaptive::Weights;
  using triangle_coverage::snap;

  // The shares of sixteenths
  const std::vector<ScreenTriangle> scene{{{snap({1, 3}), snap({4, 1}), snap({2, 5})}, {}}};
  const Window window{{0, 0}, {5, 5}};
  std::string picture(36, '.');
  const auto white = [](int, ivec2, const Weights&) { return 1.0; };
  const auto plot = [&](ivec2 p, double, double share) {
    picture[static_cast<std::size_t>(6 * p.y + p.x)] = ".123456789abcdef#"[static_cast<int>(16 * share)];
  };
  adaptive::adaptive(scene, window, n_rooks(16), white, plot);
  for (std::size_t row = 0; row < 6; ++row) fmt::print("{}\n", picture.substr(6 * row, 6));

  // What it took, beside all samples everywhere
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, adaptive::Finished>)
      fmt::print("{} of {} pixels, {} tests, {} colours\n", step.crossed, step.pixels, step.samples,
                 step.colours);
  };
  adaptive::adaptive(scene, window, n_rooks(16), white, plot, watch);
  each_sample(scene, window, n_rooks(16), white, plot, watch);

  // The step that decides a sample by depth as a figure
  const TopicEntry& topic = *find_entry("adaptive");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/antialiasing/adaptive", ""};
  std::ofstream file("adaptive.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
