// How long a figure takes from a recorded step to the bytes of its file.

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"
#include "web/player.hpp"

namespace gradus::bench {
namespace {

const Colophon colophon{"Benchmark", "A step", "gradus figure bresenham_line", ""};
constexpr std::size_t pages = 8;  // a run

/// One step after the other of a trace, again and again.
struct Steps {
  Trace trace;
  Playhead playhead;
  std::size_t next = 0;
  std::string bytes{};

  explicit Steps(Trace recorded) : trace(std::move(recorded)), playhead(trace) {}
  Sheet sheet() {
    return lay_out(figure_of(trace, playhead, trace.steps[next++ % trace.steps.size()].number), {});
  }
};

void add_cases(std::vector<Case>& cases, const char* workload, const char* topic,
               std::initializer_list<Argument> given = {}) {
  const auto add = [&](const char* name, auto render) {
    const auto steps = std::make_shared<Steps>(trace_of(*find_entry(topic), given));
    cases.push_back({.method = name,
                     .standing = Standing::taught,
                     .workload = {workload},
                     .items = pages,
                     .run = [steps, render] {
                       for (std::size_t i = 0; i < pages; ++i) steps->bytes = render(steps->sheet());
                     }});
  };
  add("layout alone", [](const Sheet& sheet) { return std::string(1, sheet.shapes.empty() ? '0' : '1'); });
  add("SVG", [](const Sheet& sheet) { return svg_of(sheet, themes()[0], colophon); });
  add("PNG 1280 x 720", [](const Sheet& sheet) { return png_of(sheet, themes()[0], colophon); });
  add("PDF", [](const Sheet& sheet) {
    return pdf_of(1, [&](std::size_t) { return sheet; }, themes()[0], colophon);
  });
}

/// Recording a fill of side x side pixels, watched but not kept.
Case recording(std::size_t side) {
  std::string maze;
  for (std::size_t y = 0; y < side; ++y) maze += (y ? "/" : "") + std::string(side, '.');
  const auto steps = std::make_shared<std::int64_t>();
  const auto record = [maze, steps] {
    *steps = trace_of(*find_entry("flood_fill"), {{"maze", maze}, {"at", "0,0"}, {"method", "breadth_first"}},
                      {INT64_MAX, 1})
                 .last;
  };
  record();
  return {.method = "recording, a step",
          .standing = Standing::taught,
          .workload = {"flood_fill of 256 x 256"},
          .items = *steps,
          .run = record};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, "bresenham_line", "bresenham_line");
  add_cases(all, "flood_fill", "flood_fill");
  add_cases(all, "a view that follows", "bresenham_line", {{"from", "0,0"}, {"to", "400,170"}});
  all.push_back(recording(256));
  return all;
}

}  // namespace

Subject figures() { return {.topic = "figures", .title = "Figures drawn", .item = "page", .cases = cases}; }

}  // namespace gradus::bench
