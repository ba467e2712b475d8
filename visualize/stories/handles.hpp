#pragma once
// Which places of a drawing the numbers of an argument move.

#include <functional>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "figure/trace.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// Of an argument with more points than this none can be dragged: they would hide the drawing.
inline constexpr std::size_t most_handles = 60;

/// A handle for each point of an argument that `at` draws. dimensions: 2 to 4, of its points; coordinates
/// beyond them come as 0. Of windows and of bounds of the plane all four corners are
/// points; of a tuple with numbers to spare, as the radius after a centre, those at its end are none. What a
/// handle goes along is measured by moving the point, by `step` or a little: exact where `at` is affine.
std::vector<Handle> handles_of(const Arguments::Entry& argument, int dimensions, bool bounds,
                               const std::function<std::optional<dvec2>(const glm::dvec4&)>& at,
                               std::optional<double> step = {});

}  // namespace gradus
