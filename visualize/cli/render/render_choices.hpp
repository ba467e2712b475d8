#pragma once
// The flags of `gradus render` that choose among ways to draw: projection, hidden surfaces, culling, shading.

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "scene/camera/view.hpp"
#include "scene/choices.hpp"

namespace gradus::cli {

using Flags = std::map<std::string, std::string>;
/// What a flag says; nothing where it was not given.
const std::string* given(const Flags& flags, const std::string& flag);

/// Is told each flag that was read in its canonical spelling, and whether it says what is the default.
using SayFlag = std::function<void(std::string_view flag, std::string_view value, bool is_default)>;

/// What draws: the engine wherever it can, or the textbook chain.
enum class DrawnBy { fast, textbook };
inline constexpr std::array<std::string_view, 2> drawn_by_names{"fast", "textbook"};

/// How surfaces are drawn; the first of each is the default.
struct DrawnSurfaces {
  pipeline::HiddenSurfaces hidden{};
  pipeline::Culling culling{};
  pipeline::Shading shading = pipeline::Shading::phong;
  DrawnBy by{};
};

/// --projection, --height, --receding, --foreshortening. Errors: UsageError for values that are none.
void read_projection(const Flags& flags, const SayFlag& say, pipeline::View& view);
/// --hidden-surfaces, --culling, --shading, --engine. Errors: UsageError for names that are none.
void read_surfaces(const Flags& flags, const SayFlag& say, DrawnSurfaces& surfaces);

/// Refuses flags that the projection has no use for, once flags and scene have said which it is.
/// Errors: UsageError.
void check_projection(const Flags& flags, pipeline::Projection3d projection);

}  // namespace gradus::cli
