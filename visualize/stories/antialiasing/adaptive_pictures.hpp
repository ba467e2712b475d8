#pragma once
// Whole pictures beside each other: without antialiasing, adaptive, and with a colour a sample; and a needle
// that loses its area with few samples.

#include "stories/antialiasing/adaptive_subject.hpp"
#include "stories/paper.hpp"

namespace gradus::adaptive {

/// A picture is done.
struct PictureDone {
  std::size_t which;
  std::string name;
  int samples;
  std::int64_t tests, colours;
  double error;  ///< of the light against a picture of many samples: the root of the mean square
  double area;   ///< of what was covered
};

/// The light of each pixel, before white.
using Sheet = std::vector<Light<dvec3>>;

/// Pictures of one size, left to right.
class PicturesStory {
 public:
  PicturesStory(const Words& words, ivec2 size, std::vector<std::string> names, double area)
      : words_(words), size_(size), names_(std::move(names)), area_(area) {}

  Window paper() const {
    const int count = static_cast<int>(names_.size());
    return {{0, 0}, {count * size_.x + (count - 1) * gap() + 1, size_.y + heading() + 1}};
  }
  void put(std::size_t which, const Sheet& sheet) {
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        const auto& light = sheet[static_cast<std::size_t>(y * size_.x + x)];
        const ivec2 at = corner(which) + ivec2{x, y};
        view_.cells.insert_or_assign({at.y, at.x},
                                     CellLook{Role::result, "", on_white(light.sum, light.share)});
      }
    }
  }
  /// The outlines that all pictures are of.
  void outline(std::vector<std::vector<dvec2>> rings) { rings_ = std::move(rings); }

  /// Where the first picture has a place, if it reaches as far.
  std::optional<dvec2> shown_at(dvec2 place) const {
    const bool shown = Extent{{0, 0}, dvec2(size_)}.holds(place);
    return shown ? std::optional(dvec2(corner(0)) - 0.5 + place) : std::nullopt;
  }

  void show(Board& board, const steps::Started&) {
    view_.plane = true;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const dvec2 at = dvec2(corner(i)) - 0.5;
      view_.add({fmt::format("a {}", i), Role::past,
                 Path{{at, at + dvec2{size_.x, 0}, at + dvec2(size_), at + dvec2{0, size_.y}}, true}});
      view_.add({fmt::format("t {}", i), Role::guide,
                 Text{at + dvec2{0.5 * size_.x, -0.45 * heading()}, names_[i]}});
      for (std::size_t k = 0; k < rings_.size(); ++k) {
        Path path{{}, true};
        for (const dvec2 p : within({0, 0}, dvec2(size_), rings_[k])) path.points.push_back(at + p);
        if (path.points.size() > 2) view_.add({fmt::format("o {} {}", i, k), Role::input, path});
      }
    }
    board.milestone(View(view_));
  }
  Event say(const steps::Started&) const {
    if (area_ > 0) return {.text = "thin", .words = {{"area", area_}}};
    return {.text = "pictures", .words = {{"columns", size_.x}, {"rows", size_.y}}};
  }
  void show(Board& board, const PictureDone& p) {
    // The outline gives way to the picture
    for (std::size_t k = 0; k < rings_.size(); ++k) view_.marks.erase(fmt::format("o {} {}", p.which, k));
    board.milestone(View(view_));
  }
  Event say(const PictureDone& p) const {
    const double lost = area_ > 0 ? 1 - p.area / area_ : 0;
    Event event{.facts = {{"samples", p.samples}, {"tests", p.tests}, {"colours", p.colours}},
                .words = {{"samples", p.samples},
                          {"tests", p.tests},
                          {"colours", p.colours},
                          {"error", p.error},
                          {"covered", p.area},
                          {"area", area_},
                          {"percent", figure_real(std::round(1000 * std::abs(lost)) / 10)}},
                .key = fmt::format("{}", p.which),
                .phase = words_.say("phase.pictures")};
    if (area_ > 0) {
      event.text = lost > 0 ? "thin.lost" : "thin.gained";
      event.row = {p.samples, p.area, area_, Said(std::round(1000 * lost) / 10).text + " %"};
      event.facts.push_back({"area", p.area});
    } else {
      constexpr std::array<std::string_view, 3> texts{"pictures.none", "pictures.adaptive", "pictures.full"};
      event.text = texts[p.which];
      event.row = {p.name, p.samples, p.colours, p.error};
      event.facts.push_back({"error", p.error});
    }
    return event;
  }
  void show(Board& board, const steps::Finished&) { board.detail(View(view_)); }
  Event say(const steps::Finished&) const {
    return {.text = area_ > 0 ? "thin.finished" : "pictures.finished"};
  }

 private:
  int gap() const { return std::max(1, size_.x / 8); }
  int heading() const { return std::max(2, size_.y / 7); }
  ivec2 corner(std::size_t which) const {
    return {1 + static_cast<int>(which) * (size_.x + gap()), heading()};
  }

  const Words& words_;
  ivec2 size_;
  std::vector<std::string> names_;
  double area_;
  std::vector<std::vector<dvec2>> rings_{};
  View view_{};
};

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

inline void paper_of(Narrator& narrator, const PicturesStory& story) {
  narrator.grid(story.paper());
  narrator.trace().grid.whole = true;
  narrator.trace().grid.axes = false;
  narrator.trace().grid.y_up = false;
}

inline void tell_pictures(Narrator& narrator) {
  const Words& words = narrator.words();
  const Subject subject = enlarged(subject_of(narrator.arguments()));
  const std::size_t pixels =
      static_cast<std::size_t>(subject.size.x) * static_cast<std::size_t>(subject.size.y);
  narrator.subtitle("subtitle.pictures", {{"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.columns({{"picture", false}, {"samples"}, {"colours"}, {"error"}});
  const std::vector<std::string> names{words.say("picture.none"), words.say("picture.adaptive"),
                                       words.say("picture.full")};
  PicturesStory story(words, subject.size, names, 0);
  std::vector<std::vector<dvec2>> rings;
  for (int i = 0; i < static_cast<int>(subject.triangles.size()); ++i) rings.push_back(subject.ring(i));
  story.outline(rings);
  const auto at = [&](dvec3 p) {
    return story.shown_at(dvec2(enlargement * triangle_coverage::snap(dvec2(p))) / double{subpixels});
  };
  narrator.handles("faces", at, 1);
  paper_of(narrator, story);
  narrator.legend({{Role::input, "input"}});
  const auto colour = subject.colours();
  const auto all = [](const auto&, const auto&) { return 1.0; };
  Sheet right(pixels);
  adaptive_contrast(subject.triangles, subject.picture(), n_rooks(256), all, 0, colour,
                    into(right, subject.size));
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto done = [&](std::size_t which, int samples, const auto& run) {
    Sheet sheet(pixels);
    Finished counted{};
    run(into(sheet, subject.size), counting(counted));
    story.put(which, sheet);
    watch(PictureDone{which, names[which], samples, counted.samples, counted.colours, error_of(sheet, right),
                      0},
          0);
    return counted.colours;
  };
  const auto none = done(0, 1, [&](const auto& plot, const auto& count) {
    each_sample(subject.triangles, subject.picture(), n_rooks(1), colour, plot, count);
  });
  const auto few = done(1, subject.count, [&](const auto& plot, const auto& count) {
    adaptive(subject.triangles, subject.picture(), subject.places, colour, plot, count);
  });
  const auto many = done(2, subject.count, [&](const auto& plot, const auto& count) {
    adaptive_contrast(subject.triangles, subject.picture(), subject.places, all, 0, colour, plot, count);
  });
  watch(steps::Finished{}, 0);
  narrator.telling({3, 0});
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
  PicturesStory story(words, size, names, area);
  std::vector<dvec2> ring;
  for (const ivec2 c : needle.corners) ring.push_back(dvec2(c) / double{subpixels});
  story.outline({ring});
  paper_of(narrator, story);
  narrator.legend({{Role::input, "input"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::vector<Field> found;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    Sheet sheet(static_cast<std::size_t>(size.x) * size.y);
    Finished done{};
    const auto black = [](int, ivec2, const Weights&) { return dvec3(0); };
    adaptive(std::vector{needle}, {{0, 0}, size - 1}, n_rooks(counts[i]), black, into(sheet, size),
             counting(done));
    double covered = 0;
    for (const auto& light : sheet) covered += light.share;
    story.put(i, sheet);
    watch(PictureDone{i, names[i], counts[i], done.samples, done.colours, 0, covered}, 0);
    found.push_back({fmt::format("area_{}", counts[i]), covered});
  }
  watch(steps::Finished{}, 0);
  narrator.telling({4, 0});
  narrator.result(found);
}

}  // namespace gradus::adaptive
