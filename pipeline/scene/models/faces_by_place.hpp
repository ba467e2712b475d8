#pragma once
// What readers of formats share whose faces name places instead of numbers, or number the same place twice.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "core/mesh.hpp"
#include "scene/models/obj.hpp"

namespace gradus::pipeline {

/// The positions of a mesh, one for all corners that stand at one place: of what formats cut into single
/// triangles a body becomes again.
class Places {
 public:
  explicit Places(Mesh& mesh) : mesh_(mesh) {}

  /// The number of the position at this place.
  int number_of(dvec3 place) {
    const dvec3 at = place + 0.0;  // no zero is negative
    const auto [known, is_new] = numbers_.try_emplace(at, static_cast<int>(mesh_.positions.size()));
    if (is_new) mesh_.positions.push_back(at);
    return known->second;
  }

 private:
  struct Hash {
    std::size_t operator()(dvec3 p) const {
      std::uint64_t hash = 0;
      for (int i = 0; i < 3; ++i) hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(p[i]);
      return static_cast<std::size_t>(hash);
    }
  };

  Mesh& mesh_;
  std::unordered_map<dvec3, int, Hash> numbers_;
};

/// The model, complete: missing normals are made. groups: the smoothing group of each face; none:
/// all faces are in one.
/// Errors: InputError for a model without a face.
ModelFile finished(ModelFile model, const TextFile& file, std::span<const int> groups = {});

}  // namespace gradus::pipeline
