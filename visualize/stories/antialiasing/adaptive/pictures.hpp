#pragma once
// Whole pictures beside each other: without antialiasing, adaptive, and with a colour per sample; and a
// needle that loses its area with few samples.

#include "stories/antialiasing/adaptive/subject.hpp"
#include "stories/picture_shelf.hpp"

namespace gradus::adaptive {

/// The light of each pixel, before white.
using Sheet = std::vector<Light<dvec3>>;

inline auto into(Sheet& sheet, ivec2 size) {
  return [&sheet, size](ivec2 p, const dvec3& sum, double share) {
    sheet[static_cast<std::size_t>(p.y * size.x + p.x)] = {sum, share};
  };
}
/// Takes note of what a run has asked for.
inline auto counting(Finished& done) {
  return [&done]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Finished>) done = step;
  };
}
inline double error_of(const Sheet& sheet, const Sheet& right) {
  double sum = 0;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const dvec3 off = sheet[i].sum - right[i].sum + dvec3(right[i].share - sheet[i].share);
    sum += glm::dot(off, off) / 3;
  }
  return std::sqrt(sum / static_cast<double>(sheet.size()));
}

/// The scene three times as fine, so that a picture has edges of some length.
inline constexpr int enlargement = 3;
inline Subject enlarged(Subject subject) {
  for (ScreenTriangle& t : subject.triangles)
    for (ivec2& corner : t.corners) corner *= enlargement;
  subject.size *= enlargement;
  subject.square *= enlargement;
  return subject;
}

/// The tone of each of a sheet's pixels.
inline auto tones_of(const Sheet& sheet, ivec2 size) {
  return [&sheet, size](ivec2 p) {
    const auto& light = sheet[static_cast<std::size_t>(p.y * size.x + p.x)];
    return on_white(light.sum, light.share);
  };
}

/// Pictures of this size under their names, with a gap and room for names that grow with them; until they
/// come, the outlines of what they are of.
inline PictureShelf shelf_of(Narrator& narrator, ivec2 size, const std::vector<std::string>& names,
                             const std::vector<std::vector<dvec2>>& rings) {
  PictureShelf shelf(
      narrator,
      {.size = size, .names = names, .gap = std::max(1, size.x / 8), .heading = std::max(2, size.y / 7)});
  shelf.frame(Role::past);
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const auto& ring : rings) {
      const std::vector<dvec2> part = within({0, 0}, dvec2(size), ring);
      if (part.size() > 2) shelf.wait(k, Role::input, part);
    }
  }
  narrator.legend({{Role::input, "input"}});
  return shelf;
}

inline void tell_pictures(Narrator& narrator) {
  const Words& words = narrator.words();
  const Subject subject = enlarged(subject_of(narrator.arguments()));
  const ivec2 size = subject.size;
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  narrator.subtitle("subtitle.pictures", {{"columns", size.x}, {"rows", size.y}});
  narrator.columns({{"picture", false}, {"samples"}, {"colours"}, {"error"}});
  std::vector<std::vector<dvec2>> rings;
  for (int i = 0; i < static_cast<int>(subject.triangles.size()); ++i) rings.push_back(subject.ring(i));
  const std::vector<std::string> names{words.say("picture.none"), words.say("picture.adaptive"),
                                       words.say("picture.full")};
  PictureShelf shelf = shelf_of(narrator, size, names, rings);
  const auto at = [&](dvec3 p) {
    return shelf.shown_at(dvec2(enlargement * triangle_coverage::snap(dvec2(p))) / double{subpixels});
  };
  narrator.handles("faces", at, 1);
  const auto colour = subject.colours();
  const auto all = [](const auto&, const auto&) { return 1.0; };
  Sheet right(pixels);
  adaptive_contrast(subject.triangles, subject.picture(), n_rooks(256), all, 0, colour, into(right, size));
  shelf.start({.text = "pictures", .words = {{"columns", size.x}, {"rows", size.y}}});
  const auto take = [&](std::size_t which, std::string_view text, int samples, const auto& run) {
    Sheet sheet(pixels);
    Finished done{};
    run(into(sheet, size), counting(done));
    const double error = error_of(sheet, right);
    shelf.show("PictureDone", 0, tones_of(sheet, size),
               {.text = text,
                .facts = {{"samples", samples},
                          {"tests", done.samples},
                          {"colours", done.colours},
                          {"error", error}},
                .row = {names[which], samples, done.colours, error},
                .key = fmt::format("{}", which),
                .phase = words.say("phase.pictures")});
    return done.colours;
  };
  const auto none = take(0, "pictures.none", 1, [&](const auto& plot, const auto& count) {
    each_sample(subject.triangles, subject.picture(), n_rooks(1), colour, plot, count);
  });
  const auto few = take(1, "pictures.adaptive", subject.count, [&](const auto& plot, const auto& count) {
    adaptive(subject.triangles, subject.picture(), subject.places, colour, plot, count);
  });
  const auto many = take(2, "pictures.full", subject.count, [&](const auto& plot, const auto& count) {
    adaptive_contrast(subject.triangles, subject.picture(), subject.places, all, 0, colour, plot, count);
  });
  shelf.finish({.text = "pictures.finished"});
  narrator.result({{"colours_none", none}, {"colours_adaptive", few}, {"colours_full", many}});
}

inline void tell_thin(Narrator& narrator) {
  const Words& words = narrator.words();
  const double thickness = *narrator.arguments().number("thickness");
  constexpr ivec2 size{9, 16};
  constexpr std::array<int, 4> counts{1, 4, 16, 64};
  using triangle_coverage::snap;
  const ScreenTriangle needle{{snap({1.4, 0.6}), snap({1.4 + thickness, 0.6}), snap({7.3, 15.5})},
                              dvec3(0.5)};
  const double area = std::abs(static_cast<double>(triangle_coverage::doubled_area(needle.corners))) /
                      (2.0 * subpixels * subpixels);
  if (area == 0) refuse("thickness", "expected a needle with an area, at least 1/256 thick");
  std::vector<std::string> names;
  for (const int count : counts) names.push_back(words.count("thin.picture", count));
  narrator.subtitle("subtitle.thin", {{"thickness", thickness}});
  narrator.columns({{"samples"}, {"covered"}, {"area"}, {"lost"}});
  std::vector<dvec2> ring;
  for (const ivec2 c : needle.corners) ring.push_back(dvec2(c) / double{subpixels});
  PictureShelf shelf = shelf_of(narrator, size, names, {ring});
  shelf.start({.text = "thin", .words = {{"area", area}}});
  std::vector<Field> found;
  for (const int count : counts) {
    Sheet sheet(static_cast<std::size_t>(size.x) * size.y);
    Finished done{};
    const auto black = [](int, ivec2, const Weights&) { return dvec3(0); };
    adaptive(std::vector{needle}, {{0, 0}, size - 1}, n_rooks(count), black, into(sheet, size),
             counting(done));
    double covered = 0;
    for (const auto& light : sheet) covered += light.share;
    const double lost = 1 - covered / area;
    shelf.show(
        "PictureDone", 0, tones_of(sheet, size),
        {.text = lost > 0 ? "thin.lost" : "thin.gained",
         .facts = {{"samples", count}, {"tests", done.samples}, {"colours", done.colours}, {"area", covered}},
         .words = {{"covered", covered},
                   {"area", area},
                   {"percent", figure_real(std::round(1000 * std::abs(lost)) / 10)}},
         .row = {count, covered, area, Said(std::round(1000 * lost) / 10).text + " %"},
         .key = fmt::format("{}", found.size()),
         .phase = words.say("phase.pictures")});
    found.push_back({fmt::format("area_{}", count), covered});
  }
  shelf.finish({.text = "thin.finished"});
  narrator.result(found);
}

}  // namespace gradus::adaptive
