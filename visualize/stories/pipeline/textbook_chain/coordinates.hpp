#pragma once
// Coordinates of the chain as the reader's notation has them: view space, and depths after the projection.

#include <algorithm>
#include <string>
#include <utility>

#include "stories/telling.hpp"

namespace gradus::textbook_chain {

inline dvec3 shown_view(const Words& words, dvec3 p) { return {p.x, p.y, words.notation().third(p.z)}; }
inline glm::dvec4 shown_clip(const Words& words, glm::dvec4 p) {
  return {p.x, p.y, words.notation().clip_depth_of(p.z, p.w), p.w};
}
inline dvec3 shown_divided(const Words& words, dvec3 p) { return {p.x, p.y, words.notation().depth_of(p.z)}; }

/// "0", "w", "−w", "0.5·w".
inline std::string multiple_of_w(const Words& words, double factor) {
  const std::string w = words.symbol("w");
  if (factor == 0) return "0";
  return factor == 1 ? w : factor == -1 ? "−" + w : figure_real(factor) + "·" + w;
}

/// What holds in front of the near plane: "z < 0".
inline std::string before_near(const Words& words) {
  const double near = words.notation().depth_of(0), far = words.notation().depth_of(1);
  return fmt::format("{} {} {}", words.symbol("z"), near < far ? "<" : ">", multiple_of_w(words, near));
}

/// Between what a depth lies within the view: "0" and "w = 2".
inline std::pair<std::string, std::string> bounds_of_depth(const Words& words, double w,
                                                           const std::string& w_text) {
  const auto text = [&](double factor) {
    if (factor == 0) return multiple_of_w(words, factor);
    return fmt::format("{} = {}", multiple_of_w(words, factor),
                       factor == 1 ? w_text : figure_real(factor * w));
  };
  const auto [low, high] = std::minmax({words.notation().depth_of(0), words.notation().depth_of(1)});
  return {text(low), text(high)};
}

}  // namespace gradus::textbook_chain
