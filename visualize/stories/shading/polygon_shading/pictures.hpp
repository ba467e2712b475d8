#pragma once
// The same faces shaded flat, by Gouraud and by Phong, beside each other.

#include "stories/listing.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/shading/polygon_shading/subject.hpp"

namespace gradus::polygon_shading {

inline void tell_three(Narrator& narrator) {
  const Words& words = narrator.words();
  narrator.list_below("gouraud");
  narrator.list_below("phong");
  const Subject subject = subject_of(narrator.arguments());
  narrator.trace().subtitle = words.count("subtitle", std::ssize(subject.rings),
                                          {{"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.columns({{"method", false}, {"lights"}, {"worst"}});
  narrator.legend({{Role::past, "faces"}});
  const std::vector<std::string> names{words.say("method.flat"), words.say("method.gouraud"),
                                       words.say("method.phong")};
  const Picture right = phong_picture(subject);
  const int up = 2 * subject.size.y / 3;  // of a curve: light 1
  PictureShelf shelf(narrator, {.size = subject.size, .names = names, .y_up = true, .plot = up + 2});
  for (std::size_t m = 0; m < names.size(); ++m) {
    for (std::size_t f = 0; f < subject.rings.size(); ++f) {
      if (subject.looks_away(f)) continue;
      std::vector<dvec2> ring;
      for (const dvec3 p : subject.named[f].points) ring.push_back(subject.on_screen(p));
      shelf.wait(m, Role::past, ring);
    }
  }
  // The row of the brightest pixel, and the light along it
  const auto brightest = std::ranges::max_element(right, {}, [](const auto& pixel) { return pixel.second; });
  const int row = brightest == right.end() ? 0 : brightest->first.second;
  const auto curve = [&](std::size_t m, const Picture& picture) {
    Path path;
    for (int x = 0; x < subject.size.x; ++x) {
      if (const auto at = picture.find({x, row}); at != picture.end())
        path.points.push_back(shelf.on_paper(m, {x + 0.5, up * at->second - up - 1}));
    }
    return path;
  };
  for (std::size_t m = 0; m < names.size(); ++m) {
    const auto across = [&](double y) {
      return Stroke{shelf.on_paper(m, {0, y}), shelf.on_paper(m, {subject.size.x, y}), false, false, true};
    };
    shelf.mark(m, "row", Role::measure, across(row + 0.5));
    shelf.mark(m, "none", Role::guide, across(-up - 1));
    shelf.mark(m, "all", Role::guide, across(-1));
  }
  narrator.handles("faces", [&](dvec3 p) { return shelf.shown_at(subject.on_screen(p)); });
  shelf.start(
      {.text = "three", .words = {{"vertices", subject.places.size()}}, .count = std::ssize(subject.rings)});
  // decides: the line that makes a way's colours
  auto take = [&, m = 0](std::string_view text, std::string_view decides, const Picture& picture,
                         std::int64_t lights) mutable {
    const double worst = worst_of(picture, right).difference;
    const std::string key(text.substr(6));
    shelf.mark(static_cast<std::size_t>(m), "curve", Role::measure,
               curve(static_cast<std::size_t>(m), picture));
    shelf.show("PictureShaded", line_with(narrator.trace().listing, decides), tones_in(picture),
               {.text = text,
                .facts = {{"lights", lights}, {"worst", worst}},
                .words = {{"difference", worst}},
                .count = m == 0 ? std::optional(lights) : std::nullopt,
                .row = {names[static_cast<std::size_t>(m)], lights, worst},
                .key = key,
                .phase = key});
    ++m;
    return lights;
  };
  std::int64_t faces = 0;
  const auto count = [&](dvec3 place, dvec3 normal) {
    ++faces;
    return subject.lamp(place, normal);
  };
  const Picture once = picture_of(subject, [&](std::size_t f, const auto& plot) {
    const std::vector<Smooth> corners = subject.smooth(f);
    flat(std::span<const Smooth>(corners), subject.picture(), count, plot);
  });
  take("three.flat", "lit(light, middle)", once, faces);
  const std::vector<double> colours = subject.vertex_colours();
  const Picture mixed = picture_of(subject, [&](std::size_t f, const auto& plot) {
    const std::vector<Lit> corners = subject.lit(f, colours);
    gouraud(std::span<const Lit>(corners), subject.picture(), plot);
  });
  const std::int64_t vertices = take("three.gouraud", "mix(il, ir, gamma)", mixed, std::ssize(colours));
  const std::int64_t pixels = take("three.phong", "lit(light, np)", right, std::ssize(right));
  shelf.finish(
      {.text = "three.finished", .words = {{"faces", faces}, {"vertices", vertices}, {"pixels", pixels}}});
  narrator.telling({4, 0});  // all three beside each other, in one sentence
  narrator.result({{"lights_flat", faces}, {"lights_gouraud", vertices}, {"lights_phong", pixels}});
}

}  // namespace gradus::polygon_shading
