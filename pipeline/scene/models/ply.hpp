#pragma once
// Models from PLY files, text and binary.

#include <string_view>

#include "scene/models/obj.hpp"

namespace gradus::pipeline {

/// The model in a PLY file.
/// Source: G. Turk, The PLY polygon file format, 1994.
///
/// bytes: the file's contents. file: how mistakes call it, and whether they may quote it.
///
/// Read: text and both binary forms; of vertices x y z, nx ny nz and texture coordinates (u v, s t,
/// texture_u texture_v); faces by vertex_indices or vertex_index, with texcoord; triangle strips; the picture
/// that a comment TextureFile names. Missing normals are smooth. With a note: colours, other properties and
/// elements, what stands behind the last row.
///
/// Domain: any bytes.
/// Accuracy: the nearest double to each number of a text, the numbers of a binary file.
/// Cost: O(length).
/// Errors: InputError "file:line: expected …, found …" ("file: row 3 of face: …" for a binary one) for all
///   else: fewer numbers in a row than it tells of or more, fewer rows, indices of what there is not, numbers
///   that are none, not finite or larger than 1e30, a model without a face.
ModelFile parse_ply(std::string_view bytes, const TextFile& file);

}  // namespace gradus::pipeline
