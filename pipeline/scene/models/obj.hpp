#pragma once
// Models from the text of OBJ files. Files themselves are read elsewhere (scene/files.hpp): pages lack them.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mesh.hpp"
#include "scene/models/statements.hpp"

namespace gradus::pipeline {

/// A model that was read, and what there was in its file.
struct ModelFile {
  Mesh mesh;  ///< every corner has a normal; materials[0] is the default, for faces that name none
  std::int64_t normals_in_file = 0;
  std::int64_t points = 0, lines = 0;  ///< statements that a renderer of faces has no use for
  std::vector<std::string> notes;      ///< what was assumed or left out, "file:line: …"
  /// Picture files that stand in the model's own, by the names that its materials call them.
  std::map<std::string, std::string> pictures{};
};

/// A model may name so many material libraries.
inline constexpr std::size_t most_libraries = 100;

/// A file that a model names, as a FileReader finds it.
struct LibraryText {
  std::string text;
  bool quotable = true;  ///< whether messages may show what stands in it
  std::string problem;   ///< why it can't be read, "expected …, found …"; empty when it was

  LibraryText() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): most libraries are just their text
  LibraryText(std::string contents) : text(std::move(contents)) {}
};

/// Gives the file that a model names, or nothing when there is none.
using FileReader = std::function<std::optional<LibraryText>(const std::string& name)>;

/// The model in the text of an OBJ file: faces of any size, in file order.
/// Source: Wavefront, The Advanced Visualizer, Object files (.obj), version 3.0, 1995.
///
/// text: the file's contents. file: how mistakes call it, and whether they may quote it. open: how to get at
/// the
///   libraries it names; it is asked for the name as it stands in the file, then with each backslash before a
///   blank taken for the escape that it is.
///
/// Read: v (with a weight or a colour behind it, which are checked and not used), vt, vn, f in all four forms
/// (v, v/vt, v//vn, v/vt/vn, each also with slashes at its end) with positive and negative numbers, usemtl,
/// mtllib, s, o, g, p and l (counted). A positive number may refer to what comes later. Missing normals, and
/// those of length 0, are made: area-weighted means over a smoothing group; s off and s 0 are flat; a file
/// without s is one group. With a note: a library or a material that is not there gives the default material;
/// texture and normal indices in a file without any such data are left out, and so are colours of vertices
/// and statements that no reader of OBJ files knows.
///
/// Domain: any bytes.
/// Accuracy: the nearest double to each number; what is too small for a double is a zero.
/// Cost: more than a million triangles a second.
/// Errors: InputError "file:line: what is wrong" for all that is broken: free-form statements and those that
/// run
///   other files, numbers that are none, not finite or larger than 1e30, faces of less than 3 corners or of
///   mixed forms, index 0, indices out of range, a library that is broken or can't be read, more than
///   most_libraries of them, a model without a face. Then nothing is returned.
ModelFile parse_obj(std::string_view text, const TextFile& file, const FileReader& open);

}  // namespace gradus::pipeline
