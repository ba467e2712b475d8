#pragma once
// One run of the textbook chain, kept stage by stage for its story: what each stage told, by vertex and
// piece.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/record.hpp"
#include "pipeline_notes.hpp"
#include "stories/topic.hpp"

namespace gradus::textbook_chain {

/// A pixel that a faulty stage 6 gives to a triangle that does not cover it, or leaves out of one that does.
struct Misjudged {
  pipeline::PieceId id;
  int triangle;
  ivec2 pixel;
  bool covered;  ///< though it should not be
};

/// Everything all eight stages told, of a scene with one object.
struct Run {
  pipeline::Fault fault = pipeline::Fault::none;
  pipeline::Scene scene;
  pipeline::Size size;
  std::vector<pipeline::VertexRead> read;    ///< by vertex
  std::vector<pipeline::FaceRead> faces;     ///< by face
  std::vector<pipeline::Piece> pieces;       ///< of all faces, in order
  std::vector<pipeline::Placed> placed;      ///< by vertex
  std::vector<pipeline::Projected> clip;     ///< by vertex
  std::vector<pipeline::Faced> faced;        ///< by piece
  std::vector<pipeline::Clipped> clipped;    ///< of the pieces that stage 4 kept
  std::vector<pipeline::Snapped> snapped;    ///< by triangle
  std::vector<pipeline::Fragment> covered;   ///< in the order of drawing
  std::vector<pipeline::DepthTested> tests;  ///< likewise
  std::vector<pipeline::Shaded> shaded;
  std::map<std::uint64_t, std::size_t> shaded_places;  ///< in `shaded`, by the key of their pixel
  std::vector<pipeline::Written> written;
  Image image;
  double noise = 0;  ///< lengths below it are rounding errors beside the model and the eye
  std::map<std::string, int, std::less<>> lines;  ///< by step type: the stage's source line that reported it

  std::vector<back_face_culling::Facing> right_facing;  ///< by piece, for a faulty stage 4
  std::vector<Misjudged> misjudged;                     ///< by a faulty stage 6

  /// Whether stage 4 has found the wrong side of a piece.
  bool wrongly_faced(std::size_t piece) const;
  const pipeline::Clipped* clipped_of(pipeline::PieceId id) const;
  const pipeline::Shaded* shaded_at(ivec2 pixel) const;
};

/// Of the corners' x, y and w, with the sign that the stage finds, which decides exactly.
double exact_determinant(const std::array<glm::dvec4, 3>& corners);

/// The model where none is given.
inline constexpr std::string_view own_model = "house.obj";

/// The most triangles a model may have for its tour.
inline constexpr std::int64_t most_triangles = 2000;

/// The scene that the arguments ask for: the model turned, and the camera that is placed for it or given.
/// The project's own model is looked at along its roof.
/// Where culling after the division is to be shown, the camera is placed so near that parts lie behind the
/// eye. Refuses a model too large, or an eye or near plane that sees nothing.
pipeline::Scene scene_of(const Arguments& arguments, pipeline::Fault fault = pipeline::Fault::none);

/// Runs the chain.
Run run_of(pipeline::Scene scene, pipeline::Size size, pipeline::Fault fault = pipeline::Fault::none);

/// The piece and the pixel that are followed.
struct Followed {
  std::size_t piece = 0;  ///< place in Run::pieces
  ivec2 pixel{0};
  std::optional<int> seen{};  ///< the face that is seen at the pixel
};

/// The piece of this face that covers most pixels; without a face the piece that has coloured this pixel;
/// without either, or where nothing covers the pixel, one that a fault concerns, of all faces one that is
/// clipped and seen, else the one that is nearer than others at most pixels. The pixel: this one, or of the
/// piece's pixels at which most pieces meet the middle one. Refuses a face or a pixel that doesn't exist.
Followed followed_in(const Run& run, const Arguments& arguments);

}  // namespace gradus::textbook_chain
