#pragma once
// The drawing as JSON: compact, because a trace has many of these.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "figure/drawing.hpp"

namespace gradus::json {

using Json = nlohmann::ordered_json;

/// x and y in turn.
Json points_json(const std::vector<dvec2>& points);
/// Up to 256 colours: a palette and a byte per texel; else four bytes per texel.
Json picture_json(const Image& image);
/// [id, role, kind, numbers or text …]; the kind says what follows.
Json mark_json(const Mark& mark);
/// "#rrggbb".
std::string hex(Rgba8 color);
/// A run of cells with one look, side by side in a row: [x, y, count, role], [x, y, count, role, text] or
/// [x, y, count, role, text, colour]; role -1: bare.
Json run_json(ivec2 start, std::int64_t count, const std::optional<CellLook>& look);

}  // namespace gradus::json
