#include "engine/buffers.hpp"

#include <algorithm>

#include "engine/mip_maps.hpp"
#include "stages/1_input.hpp"

namespace gradus::pipeline::engine {
namespace {

void add_pieces(const Mesh& mesh, std::int32_t number, MeshPieces& pieces) {
  const MeshFace& face = mesh.faces[static_cast<std::size_t>(number)];
  const auto corners = corners_of(mesh, face);
  const bool flat = std::ranges::any_of(corners, [](const Corner& corner) { return corner.normal < 0; });
  if (flat) pieces.flat_normals.push_back(flat_normal(mesh, face));
  const auto own_normal = -static_cast<std::int32_t>(std::ssize(pieces.flat_normals));
  std::int32_t piece = 0;
  triangulate(mesh, face, [&](const ear_clipping::Triangle& t) {
    const auto vertex = [&](int corner) { return corners[static_cast<std::size_t>(corner)].position; };
    pieces.vertices.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
    MeshPiece made{number, piece, face.material, {t[0], t[1], t[2]}, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& corner = corners[static_cast<std::size_t>(t[k])];
      made.normals[k] = corner.normal < 0 ? own_normal : corner.normal;
      made.textures[k] = corner.texture;
    }
    pieces.of_faces.push_back(made);
    ++piece;
  });
}

MeshPieces pieces_of(const Mesh& mesh) {
  MeshPieces pieces;
  const auto count = static_cast<std::size_t>(triangle_count(mesh));
  pieces.vertices.reserve(count);
  pieces.of_faces.reserve(count);
  for (std::int32_t face = 0; face < std::ssize(mesh.faces); ++face) add_pieces(mesh, face, pieces);
  pieces.shared = shared_planes(mesh.positions, pieces.vertices);
  return pieces;
}

}  // namespace

Buffers buffers_of(const Scene& scene) {
  Buffers buffers;
  std::map<const Mesh*, std::shared_ptr<const MeshPieces>> known;
  for (const Object& object : scene.objects) {
    auto& pieces = known[object.mesh.get()];
    if (!pieces) {
      pieces = std::make_shared<const MeshPieces>(pieces_of(*object.mesh));
      for (const Material& material : object.mesh->materials)
        if (const Image& texels = material.diffuse_map.texels; !texels.cells().empty())
          buffers.textures.emplace(&material, linear_texture(texels));
    }
    buffers.pieces.push_back(pieces);
  }
  return buffers;
}

}  // namespace gradus::pipeline::engine
