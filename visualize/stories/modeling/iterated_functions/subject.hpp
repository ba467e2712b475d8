#pragma once
// What runs on iterated functions are about: the maps, where their attractor lies, and its pixels.

#include <cmath>

#include "modeling/iterated_functions/iterated_functions.hpp"
#include "modeling/iterated_functions/iterated_functions_notes.hpp"
#include "stories/past.hpp"
#include "stories/telling.hpp"

namespace gradus::iterated_functions {

constexpr int paper_width = 36, paper_height = 27;

using Ring = std::vector<dvec2>;
using DPieces = Pieces<double>;

/// "f₂" for the map with number 1.
inline std::string name_of_map(Index map) {
  constexpr std::array<std::string_view, 8> digits{"₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈"};
  return fmt::format("f{}", digits[map % digits.size()]);
}

/// The point that a map leaves where it is.
inline dvec2 fixed_point(const DMap& m) {
  const double det = (1 - m.a) * (1 - m.d) - m.b * m.c;
  return {((1 - m.d) * m.e + m.b * m.f) / det, ((1 - m.a) * m.f + m.c * m.e) / det};
}

inline Ring placed(const DMap& piece, const Ring& shape) {
  Ring ring;
  for (const dvec2 p : shape) ring.push_back(piece(p));
  return ring;
}

struct Subject {
  std::vector<DMap> maps;
  double c = 0;      ///< the maps' contraction
  Extent attractor;  ///< all of it but what is too small to be seen

  Maps<double> all() const { return maps; }
  /// The most levels, if they have so few pieces; at most `most`.
  int levels_of(Whole pieces, int most) const {
    int levels = 0;
    for (Whole n = std::ssize(maps); levels < most && n <= pieces; n *= std::ssize(maps)) ++levels;
    return levels;
  }
  /// Where one point is in all pieces of a level.
  Ring points(int level) const {
    const dvec2 fixed = fixed_point(maps[0]);
    Ring points;
    for (const DMap& p : deterministic(all(), level)) points.push_back(p(fixed));
    return points;
  }
};

inline Subject subject_of(const Arguments& arguments) {
  Subject subject;
  for (const Tuple& t : arguments.tuples("maps"))
    subject.maps.push_back({t[0].value, t[1].value, t[2].value, t[3].value, t[4].value, t[5].value});
  const std::string& name = arguments.text("system");
  const auto take = [&](std::string_view known, Maps<double> maps) {
    if (subject.maps.empty() && name == known) subject.maps.assign(maps.begin(), maps.end());
  };
  take("sierpinski", sierpinski);
  take("carpet", carpet);
  take("koch", koch);
  take("dragon", dragon);
  take("fern", fern);
  for (Index i = 0; i < subject.maps.size(); ++i) {
    if (!contracts(subject.maps[i]))
      refuse("maps", "expected maps that make all lengths smaller, map {} stretches some by {}", i + 1,
             stretch(subject.maps[i]));
  }
  subject.c = contraction(subject.all());
  if (subject.c >= 1) refuse("maps", "expected maps that make lengths smaller by more than a rounding error");
  // A point of the attractor stays there; those that stay where they are may be its corners
  const Game<double> game{fixed_point(subject.maps[0]), 0, 20'000};
  const std::vector<double> shares = shares_by_area(subject.all());
  chaos_game(subject.all(), shares, game, [&](dvec2 p) { subject.attractor.add(p); });
  for (const DMap& f : subject.maps) subject.attractor.add(fixed_point(f));
  return subject;
}

/// All that the frames need of the plane.
inline Extent with_frames(const Subject& subject) {
  Extent extent = subject.attractor;
  for (const DMap& f : subject.maps)
    for (const dvec2 corner : placed(f, subject.attractor.corners())) extent.add(corner);
  return extent;
}

/// The attractor's frame, and where each map lays it.
inline void add_frames(View& view, const Subject& subject, const Panel& panel) {
  const Ring frame = subject.attractor.corners();
  const auto add = [&](const Ring& ring, Index number) {
    for (Index k = 0; k < ring.size(); ++k) {
      const dvec2 from = panel.at(ring[k]), to = panel.at(ring[(k + 1) % ring.size()]);
      if (from != to)
        view.add(
            {fmt::format("b frame {} {}", number, k), Role::boundary, Stroke{from, to, false, true, true}});
    }
  };
  add(frame, 0);
  for (Index i = 0; i < subject.maps.size(); ++i) {
    const Ring image = placed(subject.maps[i], frame);
    add(image, i + 1);
    view.add({fmt::format("h frame {}", i + 1), Role::boundary, Label{panel.at(image[3]), name_of_map(i)}});
  }
}

// --- Pixels

/// The pixels of the attractor's frame that points have reached.
class Pixels {
 public:
  static constexpr int most = 200;  ///< along the longer side

  explicit Pixels(const Extent& frame)
      : frame_(frame), pixel_(std::max(frame.size().x, frame.size().y) / most) {
    if (!(pixel_ > 0)) pixel_ = 1;
    const ivec2 size = cell_of(frame.upper) + 1;
    image_ = Image(size.x, size.y, Rgba8{0, 0, 0, 0});
  }
  double pixel() const { return pixel_; }
  Whole reached() const { return reached_; }

  void plot(dvec2 p) {
    const ivec2 cell = cell_of(p), at{cell.x, image_.height() - 1 - cell.y};
    if (!image_.contains(at) || image_[at].a != 0) return;
    image_[at] = ink;
    ++reached_;
  }
  /// So few of them that each is drawn as a dot.
  bool few() const { return reached_ <= 16; }
  void add_to(View& view, const Panel& panel) const {
    const dvec2 size{image_.width(), image_.height()};
    view.add({"a pixels", Role::guide,
              Picture{panel.at(frame_.lower), panel.at(frame_.lower + pixel_ * size),
                      std::make_shared<const Image>(image_)}});
  }

 private:
  static constexpr Rgba8 ink{0x1f, 0x86, 0x74, 255};  // told from white as well as from black

  ivec2 cell_of(dvec2 p) const {
    const dvec2 cell = glm::clamp((p - frame_.lower) / pixel_, -1.0, double(most));
    return {static_cast<int>(std::floor(cell.x)), static_cast<int>(std::floor(cell.y))};
  }

  Extent frame_;
  double pixel_;
  Image image_;
  Whole reached_ = 0;
};

}  // namespace gradus::iterated_functions
