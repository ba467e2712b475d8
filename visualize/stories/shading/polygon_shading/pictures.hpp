#pragma once
// The same faces shaded flat, by Gouraud and by Phong, beside each other, and below each picture the light
// along one line through the highlight.

#include "stories/listing.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/shading/polygon_shading/subject.hpp"

namespace gradus::polygon_shading {

class ThreeStory {
 public:
  explicit ThreeStory(Narrator& narrator)
      : narrator_(narrator),
        names_{narrator.words().say("method.flat"), narrator.words().say("method.gouraud"),
               narrator.words().say("method.phong")},
        subject_(subject_of(narrator.arguments(), ivec2(side * fine), fine)),
        right_(phong_picture(subject_)),
        row_(row_of_brightest()),
        shelf_(narrator, {.size = ivec2(side),
                          .names = names_,
                          .gap = 4,
                          .heading = 6,
                          .y_up = true,
                          .plot = high + 4,
                          .left = 8,
                          .fine = fine}) {}

  void tell() {
    set_scene();
    shelf_.start({.text = "three",
                  .words = {{"vertices", subject_.places.size()}},
                  .count = std::ssize(subject_.rings)});
    std::int64_t faces = 0;
    const Picture once = shaded_flat(faces);
    take(0, "three.flat", "lit(light, middle)", once, faces);
    const std::vector<double> colours = subject_.vertex_colours();
    const Picture mixed = picture_of(subject_, [&](std::size_t f, const auto& plot) {
      const std::vector<Lit> corners = subject_.lit(f, colours);
      gouraud(std::span<const Lit>(corners), subject_.picture(), plot);
    });
    take(1, "three.gouraud", "mix(il, ir, gamma)", mixed, std::ssize(colours));
    take(2, "three.phong", "lit(light, np)", right_, std::ssize(right_));
    shelf_.finish({.text = "three.finished",
                   .words = {{"flat", brightest_[0]}, {"gouraud", brightest_[1]}, {"phong", brightest_[2]}}});
    narrator_.telling({4, 0});  // all three beside each other, in one sentence
    narrator_.result({{"lights_flat", faces},
                      {"lights_gouraud", std::ssize(colours)},
                      {"lights_phong", std::ssize(right_)}});
  }

 private:
  static constexpr int side = 48, fine = 8;  ///< of a picture, in cells, and pixels a cell
  static constexpr int high = 24;            ///< of the plot below: light 1, in cells

  void set_scene() {
    narrator_.trace().subtitle = narrator_.words().count("three.subtitle", std::ssize(subject_.rings));
    narrator_.columns({{"method", false}, {"lights"}, {"worst"}});
    narrator_.legend({{Role::past, "faces"}, {Role::measure, "along"}, {Role::accepted, "by_phong"}});
    narrator_.handles("faces", [&](dvec3 p) { return shelf_.shown_at(in_picture(p)); });
    for (std::size_t k = 0; k < names_.size(); ++k) {
      for (std::size_t f = 0; f < subject_.rings.size(); ++f) {
        if (subject_.looks_away(f)) continue;
        std::vector<dvec2> ring;
        for (const dvec3 p : subject_.named[f].points) ring.push_back(in_picture(p));
        shelf_.wait(k, Role::past, ring);
      }
      add_axes(k);
    }
  }

  dvec2 in_picture(dvec3 place) const { return subject_.on_screen(place) / double(fine); }
  /// Where light has its place in the plot below a picture.
  dvec2 in_plot(std::size_t k, double column, double light) const {
    return shelf_.on_paper(k, {column / fine, high * (light - 1) - 3});
  }

  void add_axes(std::size_t k) {
    shelf_.mark(k, "a up", Role::guide, Stroke{in_plot(k, 0, 0), in_plot(k, 0, 1)});
    for (const double light : {0.0, 0.5, 1.0}) {
      const std::string id = fmt::format("a {}", light);
      shelf_.mark(k, id, Role::guide,
                  Stroke{in_plot(k, 0, light), in_plot(k, side * fine, light), false, false, light > 0});
      shelf_.mark(k, id + " number", Role::guide,
                  Text{in_plot(k, -fine, light), figure_real(light), Align::right});
    }
  }

  int row_of_brightest() const {
    const auto found = std::ranges::max_element(right_, {}, [](const auto& pixel) { return pixel.second; });
    return found == right_.end() ? 0 : found->first.second;
  }
  /// The light along the row.
  Path curve(std::size_t k, const Picture& picture, bool dashed) const {
    Path path{{}, false, dashed};
    for (int x = 0; x < side * fine; ++x) {
      const auto at = picture.find({x, row_});
      if (at != picture.end()) path.points.push_back(in_plot(k, x + 0.5, at->second));
    }
    return path;
  }

  Picture shaded_flat(std::int64_t& lights) const {
    const auto light = [&](dvec3 place, dvec3 normal) {
      ++lights;
      return subject_.lamp(place, normal);
    };
    return picture_of(subject_, [&](std::size_t f, const auto& plot) {
      const std::vector<Smooth> corners = subject_.smooth(f);
      flat(std::span<const Smooth>(corners), subject_.picture(), light, plot);
    });
  }

  /// The step of the k-th picture. decides: the line that makes its colours.
  void take(std::size_t k, std::string_view text, std::string_view decides, const Picture& picture,
            std::int64_t lights) {
    const double worst = worst_of(picture, right_).difference;
    for (int x = 0; x < side * fine; ++x) {
      const auto at = picture.find({x, row_});
      if (at != picture.end()) brightest_[k] = std::max(brightest_[k], at->second);
    }
    const double y = (row_ + 0.5) / fine;
    shelf_.mark(k, "row", Role::measure,
                Stroke{shelf_.on_paper(k, {0, y}), shelf_.on_paper(k, {side, y}), false, false, true});
    if (k < 2) shelf_.mark(k, "curve by Phong", Role::accepted, curve(k, right_, true));
    shelf_.mark(k, "curve own", Role::measure, curve(k, picture, false));
    const std::string key(text.substr(6));
    shelf_.show("PictureShaded", line_with(narrator_.trace().listing, decides), tones_in(picture),
                {.text = text,
                 .facts = {{"lights", lights}, {"worst", worst}},
                 .words = {{"difference", worst}},
                 .count = k == 0 ? std::optional(lights) : std::nullopt,
                 .row = {names_[k], lights, worst},
                 .key = key,
                 .phase = key});
  }

  Narrator& narrator_;
  const std::vector<std::string> names_;
  const Subject subject_;
  const Picture right_;  ///< light at every pixel
  const int row_;        ///< through its brightest pixel
  PictureShelf shelf_;
  std::array<double, 3> brightest_{};  ///< along the row
};

inline void tell_three(Narrator& narrator) {
  narrator.list_below("gouraud");
  narrator.list_below("phong");
  ThreeStory(narrator).tell();
}

}  // namespace gradus::polygon_shading
