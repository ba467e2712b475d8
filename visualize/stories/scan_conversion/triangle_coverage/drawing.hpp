#pragma once
// Where a triangle, its edges' lines and the regions between them lie in the drawing.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "stories/scan_conversion/triangle_coverage/subject.hpp"

namespace gradus::triangle_coverage {

/// The pixels of a window, row by row.
inline std::vector<ivec2> pixels_of(const Window& window) {
  std::vector<ivec2> pixels;
  for (const int y : rows(window)) {
    for (const int x : columns(window)) pixels.push_back({x, y});
  }
  return pixels;
}

/// Those whose centres lie on an edge.
inline std::vector<ivec2> on_edges(const Subject& subject) {
  std::vector<ivec2> ties;
  for (const Triangle& t : subject.triangles) {
    if (doubled_area(t) == 0) continue;
    for (const ivec2 p : pixels_of(subject.window)) {
      if (std::ranges::min(weights_at(edges_of(t), p)) == 0) ties.push_back(p);
    }
  }
  return ties;
}

/// White light through three sheets of glass, each on a half-plane: what reaches a centre with these weights.
inline Rgba8 seen_through(const Weights& weights) {
  constexpr std::array<Rgba8, 3> glass{Rgba8{248, 215, 235}, Rgba8{255, 238, 190}, Rgba8{205, 238, 225}};
  int red = 255, green = 255, blue = 255;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights[i] <= 0) continue;
    red = red * glass[i].r / 255;
    green = green * glass[i].g / 255;
    blue = blue * glass[i].b / 255;
  }
  return {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), static_cast<std::uint8_t>(blue)};
}

class TriangleDrawing {
 public:
  TriangleDrawing(const Subject& subject, const Triangle& triangle)
      : frame_(subject.frame()), window_(subject.window), far_(0.05 * subject.size()) {
    for (std::size_t i = 0; i < 3; ++i) ring_[i] = subject.at(triangle[i]);
    // As edges_of has them: the inside on the positive side
    const bool turned = doubled_area(triangle) < 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sides_[i] = {ring_[(i + 1) % 3], ring_[(i + 2) % 3]};
      if (turned) std::swap(sides_[i].from, sides_[i].to);
    }
  }

  /// What is seen of the triangle.
  std::vector<dvec2> outline() const { return within(frame_, {ring_.begin(), ring_.end()}); }
  /// A place for a corner's name, outside the triangle.
  std::optional<dvec2> beside_corner(std::size_t i) const {
    if (!frame_.holds(ring_[i])) return std::nullopt;
    const dvec2 way = ring_[i] - (ring_[0] + ring_[1] + ring_[2]) / 3.0;
    const dvec2 at = ring_[i] + far_ / std::max(length_between({0, 0}, way), 1e-9) * way;
    return glm::clamp(at, frame_.lower + 0.5 * far_, frame_.upper - 0.5 * far_);
  }
  /// The same for an edge, beside the middle of what is seen of it; and whether that is to its left.
  std::optional<std::pair<dvec2, bool>> beside_edge(std::size_t i) const {
    const auto side = shown_part(frame_, sides_[i].from, sides_[i].to);
    if (!side || side->a == side->b) return std::nullopt;
    const dvec2 way = sides_[i].way(), outwards = dvec2{way.y, -way.x} / length_between({0, 0}, way);
    dvec2 at = 0.5 * (side->a + side->b) + far_ * outwards;
    // Room for a value to the left of the line
    if (outwards.x < 0) at.x = std::max(at.x, frame_.lower.x + 5 * far_);
    return std::pair{at, outwards.x < 0};
  }
  /// The line of an edge as far as the frame goes.
  std::optional<Stroke> line(std::size_t i) const {
    const auto [from, to] = sides_[i];
    const auto [first, last] = span_in(frame_, from, to - from, -0x1p40, 0x1p40);
    if (first > last) return std::nullopt;
    return Stroke{from + first * (to - from), from + last * (to - from)};
  }
  /// The part of the frame where an edge function is above 0.
  std::vector<dvec2> above(std::size_t i) const {
    return above_0(frame_.corners(), [&](dvec2 p) { return sides_[i].at(p); });
  }
  /// Of each combination of signs a place for it, far from all lines, between a centre and its pixel's
  /// border.
  std::map<std::string, dvec2> regions() const {
    std::map<std::string, std::pair<double, dvec2>> best;
    for (const ivec2 pixel : pixels_of(window_)) {
      for (const double aside : {-0.26, 0.26}) {
        const dvec2 at = dvec2(pixel) + dvec2{0, aside};
        const auto [signs, far] = signs_at(at);
        const dvec2 border = glm::min(at - frame_.lower, frame_.upper - at);
        const double room = std::min({far, border.x + 0.2, border.y + 0.2});
        if (auto& found = best[signs]; room > found.first) found = {room, at};
      }
    }
    std::map<std::string, dvec2> places;
    for (const auto& [signs, found] : best) {
      if (found.first > 0.3) places.emplace(signs, found.second);
    }
    return places;
  }

 private:
  struct Side {
    dvec2 from, to;
    dvec2 way() const { return to - from; }
    double at(dvec2 p) const { return way().x * (p.y - from.y) - way().y * (p.x - from.x); }
  };
  /// The signs of the three edge functions at a place, and how far it is from their lines.
  std::pair<std::string, double> signs_at(dvec2 at) const {
    std::string signs;
    double least = std::numeric_limits<double>::max();
    for (const Side& side : sides_) {
      signs += fmt::format("{}{}", signs.empty() ? "" : " ", side.at(at) < 0 ? "−" : "+");
      least = std::min(least, std::abs(side.at(at)) / length_between({0, 0}, side.way()));
    }
    return {signs, least};
  }

  Extent frame_;
  Window window_;
  double far_;  ///< of names from what they name
  std::array<dvec2, 3> ring_;
  std::array<Side, 3> sides_;
};

}  // namespace gradus::triangle_coverage
