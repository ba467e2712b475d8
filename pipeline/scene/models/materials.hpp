#pragma once
// Material libraries (MTL files).

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.hpp"
#include "core/surface.hpp"
#include "scene/models/statements.hpp"

namespace gradus::pipeline {

/// How a texture is laid on: at (u, v) stands its texel at scale * (u, v) + offset.
struct TexturePlacement {
  dvec2 scale{1}, offset{0};

  friend bool operator==(const TexturePlacement&, const TexturePlacement&) = default;
};

/// A material as a library has it.
struct LibraryMaterial : Material {
  TexturePlacement placement{};  ///< of diffuse_map
};

/// The materials of an MTL file.
/// Source: Wavefront, The Advanced Visualizer, MTL material format 4.2, 1995.
///
/// text: the file's contents. file: how mistakes call it, and whether they may quote it. notes: gets a line
/// for
///   each kind of thing that was left out.
///
/// Read, in letters of any size: newmtl (names may hold blanks), Ka, Kd, Ks, Ke, Ns, d, Tr, illum (0 and 1
/// have no highlight), map_Kd (its file name, -s and -o). Numbers of other known statements are checked. A
/// material without Ka has its Kd there. Colours are taken as linear. Told in one note: other maps and
/// options of map_Kd, illum above 2, and numbers that only other models of light than Phong's know.
///
/// Domain: any bytes.
/// Cost: O(length).
/// Errors: InputError with file and line: statements before newmtl, a second newmtl of one name, numbers that
///   are none, negative or not finite, spectral curves.
std::vector<LibraryMaterial> parse_mtl(std::string_view text, const TextFile& file,
                                       std::vector<std::string>& notes);

}  // namespace gradus::pipeline
