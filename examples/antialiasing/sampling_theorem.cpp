// What samples tell: the alias of 9 Hz at 10 samples a second, a curve between its samples, a wheel on film;
// a step as a figure. Writes sampling_theorem.svg into the current folder.

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"

#include <fmt/core.h>

#include <array>
#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::sampling_theorem;

  // What the samples tell of
  fmt::print("9 Hz at 10 samples a second look like {} Hz\n", alias_of(9.0, 10.0));
  fmt::print("eight spokes, 2 revolutions at 24 frames: {}\n", apparent_speed(2.0, 24.0, 8));

  // A curve between its samples, kernel by kernel
  const std::array<double, 4> samples{0, 1, 0, -1};
  const auto watch = [](const KernelAdded& a) { fmt::print("kernel {:.4f}: sum {:.4f}\n", a.kernel, a.sum); };
  reconstruct(std::span<const double>(samples), 0.5, Dirichlet{4}, watch);

  // The alias as a figure
  const TopicEntry& topic = *find_entry("sampling_theorem");
  const Trace trace = trace_of(topic, {{"frequency", "9"}, {"rate", "10"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {11, 0});
  const std::string source = "examples/antialiasing/sampling_theorem";
  const Colophon colophon{figure.title, caption_of(figure), source, ""};
  std::ofstream file("sampling_theorem.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
