// The colour of one place: a lamp and a spot, each lamp watched, a soft shadow, a step as a figure.
// Writes illumination.svg into the current folder.

#include "shading/illumination/illumination.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::illumination;

  // A floor at the origin, seen from straight above
  const Reflectance<double> grey{
      .ambient = dvec3{0.1}, .diffuse = dvec3{0.7}, .specular = dvec3{0.2}, .shininess = 10};
  const dvec3 place{0}, up{0, 0, 1}, eye{0, 0, 5};
  const Light lamp{.position = {0, 3, 4}};
  const std::span<const Light> one(&lamp, 1);
  fmt::print("Phong: {:.4f}\n", phong(place, up, eye, grey, one, dvec3{1}).sum().x);

  // What each lamp adds
  const auto watch = []<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, LightAdded<double>>)
      fmt::print("N.L = {:.2f}, N.H = {:.2f}\n", s.n_dot_l, s.cosine);
  };
  blinn_phong(place, up, eye, grey, one, dvec3{1}, AllSeen{}, watch);

  // An area that a wall at y = 1 hides by half
  Light area{.kind = Light::Kind::area, .position = {0, 0, 4}, .across = {0, 2, 0}, .along = {2, 0, 0}};
  const auto visible = [](dvec3, dvec3 to_light, double) { return to_light.y < 0; };
  fmt::print("half hidden: {:.4f}\n",
             phong(place, up, eye, grey, std::span<const Light>(&area, 1), dvec3{0}, visible).sum().x);

  // The lamp as a figure
  const TopicEntry& topic = *find_entry("illumination");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/shading/illumination", ""};
  std::ofstream file("illumination.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
