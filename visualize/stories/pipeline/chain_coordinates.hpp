#pragma once
// Coordinates of the chain as the reader's notation has them: view space, and depths after the projection.

#include <algorithm>
#include <string>
#include <utility>

#include "stories/telling.hpp"

namespace gradus::textbook_chain {

class ChainCoordinates {
 public:
  explicit ChainCoordinates(const Words& words) : words_(words) {}

  dvec3 view(dvec3 p) const { return {p.x, p.y, notation().third(p.z)}; }
  glm::dvec4 clip(glm::dvec4 p) const { return {p.x, p.y, notation().clip_depth_of(p.z, p.w), p.w}; }
  dvec3 divided(dvec3 p) const { return {p.x, p.y, notation().depth_of(p.z)}; }

  /// What holds before the near plane: "z < 0".
  std::string before_near() const {
    const double near = notation().depth_of(0);
    return fmt::format("{} {} {}", words_.symbol("z"), near < notation().depth_of(1) ? "<" : ">",
                       multiple(near));
  }
  /// Between what a depth lies within the view: "0" and "w = 2".
  std::pair<std::string, std::string> bounds(double w, const std::string& w_text) const {
    const auto text = [&](double depth) {
      if (depth == 0) return multiple(depth);
      return fmt::format("{} = {}", multiple(depth), depth == 1 ? w_text : figure_real(depth * w));
    };
    const auto [low, high] = std::minmax({notation().depth_of(0), notation().depth_of(1)});
    return {text(low), text(high)};
  }

 private:
  const Notation& notation() const { return words_.notation(); }
  /// Of w: "0", "w", "−w", "0.5·w".
  std::string multiple(double factor) const {
    const std::string w = words_.symbol("w");
    if (factor == 0) return "0";
    return factor == 1 ? w : factor == -1 ? "−" + w : figure_real(factor) + "·" + w;
  }

  const Words& words_;
};

}  // namespace gradus::textbook_chain
