#pragma once
// The same faces shaded flat, by Gouraud and by Phong, beside each other.

#include "stories/shading/polygon_shading_subject.hpp"
#include "stories/telling.hpp"

namespace gradus::polygon_shading {

/// A picture is done by one of the methods.
struct PictureShaded {
  std::size_t method;
  Picture picture;
  std::int64_t lights;
};

/// Three pictures of the same faces.
class ThreeStory {
 public:
  ThreeStory(const Words& words, const Subject& subject, const Picture& right)
      : words_(words), subject_(subject), right_(right) {}

  /// Of the drawing, whose units are pixels.
  static constexpr dvec2 first_corner{1, 1};  ///< of the pictures' lower left ones

  static Window paper(const Subject& subject) {
    return {{0, 0}, {3 * subject.size.x + 2 * gap + 1, subject.size.y + heading}};
  }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    return {.text = "three",
            .words = {{"vertices", subject_.places.size()}},
            .count = std::ssize(subject_.rings)};
  }
  void show(Board& board, const PictureShaded& p) {
    done_.push_back(p);
    worst_.push_back(worst_of(p.picture, right_));
    put(board);
  }
  Event say(const PictureShaded& p) const {
    constexpr std::array<std::string_view, 3> keys{"three.flat", "three.gouraud", "three.phong"};
    const double difference = worst_.back().difference;
    Event event{.text = keys[p.method],
                .facts = {{"lights", p.lights}, {"worst", difference}},
                .words = {{"lights", p.lights}, {"difference", difference}},
                .row = {name(p.method), p.lights, difference},
                .key = std::string(keys[p.method].substr(6)),
                .phase = std::string(keys[p.method].substr(6))};
    if (p.method == 0) event.count = p.lights;
    return event;
  }
  void show(Board& board, const steps::Finished&) { put(board); }
  Event say(const steps::Finished&) const {
    return {
        .text = "three.finished",
        .words = {{"faces", done_[0].lights}, {"vertices", done_[1].lights}, {"pixels", done_[2].lights}}};
  }

 private:
  static constexpr int gap = 2, heading = 3;

  std::string name(std::size_t method) const {
    constexpr std::array<std::string_view, 3> keys{"method.flat", "method.gouraud", "method.phong"};
    return words_.say(keys[method]);
  }
  void put(Board& board) const {
    View view;
    for (std::size_t m = 0; m < 3; ++m) {
      const dvec2 corner = first_corner + dvec2(static_cast<double>(m) * (subject_.size.x + gap), 0);
      view.add({fmt::format("t {}", m), Role::guide,
                Text{corner + dvec2(0.5 * subject_.size.x - 0.5, subject_.size.y + 0.6), name(m)}});
      if (m < done_.size()) put_picture(view, done_[m].picture, ivec2(corner));
      if (m >= done_.size()) put_outlines(view, m, corner);
    }
    board.milestone(std::move(view));
  }
  static void put_picture(View& view, const Picture& picture, ivec2 corner) {
    for (const auto& [at, colour] : picture)
      view.cells.insert_or_assign({at.second + corner.y, at.first + corner.x},
                                  CellLook{Role::result, "", tone_of(colour)});
  }
  void put_outlines(View& view, std::size_t method, dvec2 corner) const {
    for (std::size_t f = 0; f < subject_.rings.size(); ++f) {
      if (subject_.looks_away(f)) continue;
      Path path{{}, true};
      for (const dvec3 p : subject_.named[f].points)
        path.points.push_back(corner + subject_.on_screen(p) - 0.5);
      view.add({fmt::format("o {} {:03}", method, f), Role::past, path});
    }
  }

  const Words& words_;
  const Subject& subject_;
  const Picture& right_;
  std::vector<PictureShaded> done_{};
  std::vector<Worst> worst_{};
};

inline void tell_three(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Picture right = phong_picture(subject);
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(subject.rings),
                                                     {{"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.grid(ThreeStory::paper(subject));
  narrator.trace().grid.whole = true;
  narrator.trace().grid.axes = false;
  narrator.columns({{"method", false}, {"lights"}, {"worst"}});
  narrator.legend({{Role::past, "faces"}});
  ThreeStory story(narrator.words(), subject, right);
  narrator.handles("faces", [&](dvec3 p) { return ThreeStory::first_corner + subject.on_screen(p) - 0.5; });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::int64_t faces = 0;
  const auto count = [&](dvec3 place, dvec3 normal) {
    ++faces;
    return subject.lamp(place, normal);
  };
  const Picture once = picture_of(subject, [&](std::size_t f, const auto& plot) {
    const std::vector<Smooth> corners = subject.smooth(f);
    flat(std::span<const Smooth>(corners), subject.picture(), count, plot);
  });
  watch(PictureShaded{0, once, faces}, 0);
  const std::vector<double> colours = subject.vertex_colours();
  const Picture mixed = picture_of(subject, [&](std::size_t f, const auto& plot) {
    const std::vector<Lit> corners = subject.lit(f, colours);
    gouraud(std::span<const Lit>(corners), subject.picture(), plot);
  });
  watch(PictureShaded{1, mixed, std::ssize(colours)}, 0);
  watch(PictureShaded{2, right, std::ssize(right)}, 0);
  watch(steps::Finished{}, 0);
  narrator.telling({4, 0});
  narrator.result(
      {{"lights_flat", faces}, {"lights_gouraud", std::ssize(colours)}, {"lights_phong", std::ssize(right)}});
}

}  // namespace gradus::polygon_shading
