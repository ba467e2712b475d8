#pragma once
// Models from STL files, text and binary.

#include <string_view>

#include "scene/models/obj.hpp"

namespace gradus::pipeline {

/// The model in an STL file: its triangles, flat, as one body where they share corners.
/// Source: 3D Systems, StereoLithography Interface Specification, 1989.
///
/// bytes: the file's contents. file: how mistakes call it, and whether they may quote it.
///
/// Read: text of keywords in any case, with any number of solids and of corners in a loop; binary files, also
/// those that begin with "solid", by the number of triangles that they tell. A facet's normal is the file's
/// own; one of length 0 or of what is no number is made from the corners. With a note: bytes behind the last
/// triangle, attributes of triangles (colours), text that ends before "endsolid".
///
/// Domain: any bytes, fewer than 2^32.
/// Accuracy: the nearest double to each number of a text, the floats of a binary file.
/// Cost: O(length).
/// Errors: InputError "file:line: expected …, found …" ("file: …" for a binary one, with the number of the
///   triangle) for all else: another keyword, coordinates that are not finite or larger than 1e30, a file
///   that ends before its last triangle, one without a face.
ModelFile parse_stl(std::string_view bytes, const TextFile& file);

}  // namespace gradus::pipeline
