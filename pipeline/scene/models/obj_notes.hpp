#pragma once
// An exhibit: how the loader of lecture notes takes the faces and materials of an OBJ file, kept so that the
// page of errata can show what becomes of them. Never use it to read; obj.hpp has the right one.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.hpp"

namespace gradus::pipeline {

/// What the notes' loader makes of a face.
struct NotesFace {
  int line = 0;                               ///< of the statement, from 1
  std::vector<std::array<int, 3>> triangles;  ///< vertices counted from 0, as they come out: also negative
  std::string material;                       ///< the name that is looked up, line end and all
  dvec3 colour{0};                            ///< that stands under it, 0 to 1
  std::string failure;                        ///< what the program ends with; empty: it goes on
};

/// FAULTY: the faces of an OBJ file by lines of fixed form.
/// Names are split at single blanks, line end included: the second piece of a usemtl line is looked up, the
///   last piece of a newmtl line is stored (errata E002-16).
/// The default material is registered as "default", but the current name is "" at first (E002-17).
/// The third field of every corner is its normal, every index is lowered by one, also a negative one, and a
///   face of more than four corners is none (E002-18).
///
/// text: of the OBJ file. library: of the MTL file; empty: there is none.
///
/// Domain: lines as the notes' own models have them: v//vn or v/vt/vn in three or four corners, a material
///   before the first face, names of one word and nothing behind them.
/// Accuracy: indices are whole numbers, colours the nearest doubles.
/// Cost: O(length).
/// Errors: none are raised: the face at which the program would end says so, and is the last.
std::vector<NotesFace> notes_faces(std::string_view text, std::string_view library);

}  // namespace gradus::pipeline
