// Half-edges three ways: neighbours found by walking, orientation spread, a step as a figure.
// Writes mesh_structures.svg into the current folder.

#include "modeling/mesh_structures/mesh_structures.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "modeling/mesh_structures/counts.hpp"
#include "modeling/mesh_structures/orientation.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::mesh_structures;
  const Faces faces = faces_of({{0, 1, 2}, {1, 3, 2}, {2, 3, 5}, {3, 4, 5}});

  // The faces at a vertex, and along the boundary
  if (const auto mesh = half_edges(faces, 6)) {
    faces_at(*mesh, 2, [](Index f) { fmt::print("face {}\n", f); });
    edges_round(*mesh, mesh->loops[0],
                [&](Index h) { fmt::print("{} to {}\n", (*mesh)[h].from, mesh->to(h)); });
  }
  fmt::print("Euler number {}\n", counts_of(faces, 6).euler());

  // A Möbius strip can't be oriented: the last demand says where
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Demanded>) fmt::print("from face {} to face {}\n", step.from, step.to);
  };
  orientation(faces_of({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}), 5, watch);

  // A turn round v3 as a figure
  const Trace trace = trace_of(*find_entry("mesh_structures"), {{"number", "3"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {16, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/mesh_structures", ""};
  std::ofstream file("mesh_structures.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
