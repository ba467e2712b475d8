#pragma once
// Marks that stand beside what a drawing is about: another picture for comparison, a part once more, larger.
// A panel among many, or a slide without room for them, shows the drawing without them, all the larger.

#include <string_view>

namespace gradus {

/// What the ids of such marks begin with.
inline constexpr std::string_view aside_prefix = "aside ";

inline bool is_aside(std::string_view id) { return id.starts_with(aside_prefix); }

}  // namespace gradus
