// How many figures a second: at least 200 SVG and 25 PNG (1280 x 720) steps on one core are asked for.

#include <benchmark/benchmark.h>

#include <initializer_list>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"
#include "web/player.hpp"

namespace gradus {
namespace {

const Colophon colophon{"Benchmark", "A step", "gradus figure bresenham_line", ""};

/// One step after the other, from the recorded trace to the file's bytes.
template <class Render>
void draw_steps(benchmark::State& state, const char* topic, Render render,
                std::initializer_list<Argument> given = {}) {
  const Trace trace = trace_of(*find_entry(topic), given);
  Playhead playhead(trace);
  std::size_t next = 0, bytes = 0;
  for (auto _ : state) {
    const StepNumber number = trace.steps[next++ % trace.steps.size()].number;
    bytes += render(lay_out(figure_of(trace, playhead, number), {})).size();
  }
  state.counters["steps/s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["bytes"] = double(bytes) / double(state.iterations());
}

void svg(benchmark::State& state, const char* topic) {
  draw_steps(state, topic, [](const Sheet& sheet) { return svg_of(sheet, themes()[0], colophon); });
}
void png(benchmark::State& state, const char* topic) {
  draw_steps(state, topic, [](const Sheet& sheet) { return png_of(sheet, themes()[0], colophon); });
}
void pdf(benchmark::State& state, const char* topic) {
  draw_steps(state, topic, [](const Sheet& sheet) {
    return pdf_of(1, [&](std::size_t) { return sheet; }, themes()[0], colophon);
  });
}
void layout_alone(benchmark::State& state, const char* topic) {
  draw_steps(state, topic, [](const Sheet& sheet) { return std::string(sheet.shapes.size(), ' '); });
}
BENCHMARK_CAPTURE(svg, line, "bresenham_line");
BENCHMARK_CAPTURE(svg, fill, "flood_fill");
/// A view that follows the step, with an overview.
void svg_following(benchmark::State& state) {
  draw_steps(state, "bresenham_line", [](const Sheet& sheet) { return svg_of(sheet, themes()[0], colophon); },
             {{"from", "0,0"}, {"to", "400,170"}});
}
BENCHMARK(svg_following);
BENCHMARK_CAPTURE(png, line, "bresenham_line");
BENCHMARK_CAPTURE(png, fill, "flood_fill");
BENCHMARK_CAPTURE(pdf, line, "bresenham_line");
BENCHMARK_CAPTURE(layout_alone, line, "bresenham_line");
BENCHMARK_CAPTURE(layout_alone, fill, "flood_fill");

/// Recording a fill of size x size pixels, watched but not kept.
void count_steps(benchmark::State& state) {
  const auto side = static_cast<std::size_t>(state.range(0));
  std::string maze;
  for (std::size_t y = 0; y < side; ++y) maze += (y ? "/" : "") + std::string(side, '.');
  std::int64_t steps = 0;
  for (auto _ : state) {
    const Trace trace =
        trace_of(*find_entry("flood_fill"), {{"maze", maze}, {"at", "0,0"}, {"method", "breadth_first"}},
                 {INT64_MAX, 1});
    steps = trace.last;
  }
  state.counters["steps/s"] =
      benchmark::Counter(double(steps) * double(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(count_steps)->Arg(256)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gradus
