#pragma once
// Marks that stand beside what a drawing is about: another picture for comparison, a part once more, larger.
// A panel among many, or a slide without room for them, shows the drawing without them, all the larger.

#include <string_view>
#include <variant>

#include "figure/drawing.hpp"

namespace gradus {

/// What the ids of such marks begin with.
inline constexpr std::string_view aside_prefix = "aside ";

inline bool is_aside(std::string_view id) { return id.starts_with(aside_prefix); }

/// By its id, or because its shape says so.
inline bool stands_aside(const Mark& mark) {
  const auto says_so = [](const auto& shape) {
    if constexpr (requires { shape.aside; }) return shape.aside;
    return false;
  };
  return is_aside(mark.id) || std::visit(says_so, mark.shape);
}

}  // namespace gradus
