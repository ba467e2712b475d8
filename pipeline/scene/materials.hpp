#pragma once
// Material libraries (MTL files).

#include <string>
#include <string_view>
#include <vector>

#include "core/surface.hpp"
#include "scene/statements.hpp"

namespace gradus::pipeline {

/// The materials of an MTL file.
/// Source: Wavefront, The Advanced Visualizer, MTL material format 4.2, 1995.
///
/// text: the file's contents. file: how mistakes call it, and whether they may quote it. notes: gets a line
/// for
///   each kind of thing that was left out.
///
/// Read: newmtl (names may hold blanks), Ka, Kd, Ks, Ke, Ns, d, Tr, illum (0 and 1 have no highlight), map_Kd
/// (its file name; options are skipped). Numbers of other known statements are checked and not used. A
/// material without Ka has its Kd there. Colours are taken as linear.
/// Domain: any bytes.
/// Cost: O(length).
/// Errors: InputError with file and line: statements before newmtl, a second newmtl of one name, numbers that
///   are none, negative or not finite, spectral curves.
std::vector<Material> parse_mtl(std::string_view text, const TextFile& file, std::vector<std::string>& notes);

}  // namespace gradus::pipeline
