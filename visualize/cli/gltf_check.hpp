#pragma once
// What is looked at in glTF files before another library reads them.

#include <string_view>

#include "scene/statements.hpp"

namespace gradus::cli {

/// Refuses a glTF 2.0 or GLB file that says of itself more than it can hold: nodes that are no trees, as its
/// specification wants them, would be multiplied out without end, and accessors may count what is not there.
///
/// bytes: the file's. file: how mistakes call it, and whether they may quote it.
///
/// Domain: any bytes. Cost: reads the JSON part.
/// Errors: InputError "file:line: expected …, found …" for such a file and for a JSON part that is none; the
/// line is the JSON
///   part's. A file that is no GLB at all is left to the other library.
void check_gltf(std::string_view bytes, const pipeline::TextFile& file);

}  // namespace gradus::cli
