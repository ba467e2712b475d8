#pragma once
// Models from OBJ files.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh.hpp"

namespace gradus::pipeline {

/// A model that was read, and what there was in its file.
struct ModelFile {
  Mesh mesh;  ///< every corner has a normal; materials[0] is the default, for faces that name none
  std::int64_t normals_in_file = 0;
  std::int64_t points = 0, lines = 0;  ///< statements that a renderer of faces has no use for
  std::vector<std::string> notes;      ///< what was assumed or left out, "file:line: …"
};

/// Gives the contents of a file that a model names, or nothing when there is none. Throws InputError for one
/// that can't be read.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

/// Reads an OBJ file and the material libraries it names.
///
/// path: of the file; libraries are looked for beside it. Domain and errors: as parse_obj; InputError also
/// for a file that can't be read.
ModelFile load_obj(const std::string& path);

/// The model in the text of an OBJ file: faces of any size, in file order.
/// Source: Wavefront, The Advanced Visualizer, Object files (.obj), version 3.0, 1995.
///
/// text: the file's contents. file: how mistakes call it. open: how to get at the libraries it names; it is
///   asked for the name as it stands in the file.
///
/// Read: v (with a weight or a colour behind it, which are checked and not used), vt, vn, f in all four forms
/// (v, v/vt, v//vn, v/vt/vn) with positive and negative numbers, usemtl, mtllib, s, o, g, p and l (counted).
/// A positive number may refer to what comes later. Missing normals, and those of length 0, are made:
/// area-weighted means over a smoothing group; s off and s 0 are flat; a file without s is one group. A
/// library or a material that is not there gives the default material and a note.
///
/// Domain: any bytes.
/// Accuracy: the nearest double to each number.
/// Cost: more than a million triangles a second.
/// Errors: InputError "file:line: what is wrong" for all that is broken: unknown and free-form statements,
///   numbers that are none, not finite or larger than 1e30, faces of less than 3 corners or of mixed forms,
///   index 0, indices out of range, a broken library, a model without a face. Then nothing is returned.
ModelFile parse_obj(std::string_view text, const std::string& file, const FileReader& open);

}  // namespace gradus::pipeline
