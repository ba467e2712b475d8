#pragma once
// Faces in space as people write them: "front: 0,0,4 4,0,4 4,3,4; back #cc79a7: 0,0,1 4,0,1 4,3,1".

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.hpp"
#include "stories/point_text.hpp"

namespace gradus {

/// A face as written.
struct FaceText {
  std::string name;
  std::string color{};        ///< "#rrggbb"; empty: none was given
  std::vector<Tuple> points;  ///< its corners, three numbers each
};

/// A face as topics take it.
struct NamedFace {
  std::string name;
  std::string color{};
  std::vector<dvec3> points;
};

/// What a face may be called: one to 24 bytes without ':', ';', ',', '#' and control characters, no white
/// space at its ends.
bool is_face_name(std::string_view text);

/// Faces with ";" between them: the name, a colour if it has one, ":", and its corners x,y,z with white space
/// between them. A face without name is called by its number. Errors say which face and which point. At least
/// one face of at least three corners each, every name once.
Read<std::vector<FaceText>> read_faces(std::string_view text);

/// The canonical spelling.
std::string text_of(const std::vector<FaceText>& faces);

}  // namespace gradus
