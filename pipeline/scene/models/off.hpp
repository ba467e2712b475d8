#pragma once
// Models from OFF files (Object File Format, text).

#include <string_view>

#include "scene/models/obj.hpp"

namespace gradus::pipeline {

/// The model in the text of an OFF file.
/// Source: Geomview Manual, version 1.9.4, OFF: the file format.
///
/// text: the file's contents. file: how mistakes call it, and whether they may quote it.
///
/// Read: a vertex and a face per line, as all programs write them, after OFF, COFF, NOFF, STOFF and what
/// these letters make together; normals and texture coordinates. Missing normals are smooth. With a note:
/// colours, lines behind the last face.
///
/// Domain: any bytes.
/// Accuracy: the nearest double to each number.
/// Cost: O(length).
/// Errors: InputError "file:line: expected …, found …" for all else: four and n dimensions, binary files,
///   fewer lines than the file tells of, indices of what there is not, numbers that are none, not finite or
///   larger than 1e30, a model without a face.
ModelFile parse_off(std::string_view text, const TextFile& file);

}  // namespace gradus::pipeline
