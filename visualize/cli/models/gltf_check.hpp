#pragma once
// What is looked at in glTF files before another library reads them.

#include <string_view>

#include "scene/models/obj.hpp"

namespace gradus::cli {

/// Refuses a glTF 2.0 or GLB file that says of itself more than it holds: nodes that are no trees, as its
/// specification wants them, would be multiplied out without end; what of buffers, vertices and pictures is
/// not there, the other library leaves out or makes up; and an extension that is required changes what data
/// mean.
///
/// bytes: the file's. file: how mistakes call it, and whether they may quote it. open: gives its buffers'
/// files;
///   one that is not there is left to the other library.
///
/// Domain: any bytes. Cost: reads the JSON part and all numbers of vertices.
/// Errors: InputError "file:line: expected …, found …" for such a file and for a JSON part that is none; the
/// line is the JSON
///   part's. A file that is no GLB at all is left to the other library.
void check_gltf(std::string_view bytes, const pipeline::TextFile& file, const pipeline::FileReader& open);

}  // namespace gradus::cli
