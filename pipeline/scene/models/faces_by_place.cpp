#include "scene/models/faces_by_place.hpp"

#include <fmt/core.h>

#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::pipeline {

ModelFile finished(ModelFile model, const TextFile& file, std::span<const int> groups) {
  if (model.mesh.faces.empty()) {
    refuse_input(fmt::format("{}: expected at least one face, found none ({} vertices, {} points, {} lines)",
                             shown_name(file.name), model.mesh.positions.size(), model.points, model.lines));
  }
  model.normals_in_file = std::ssize(model.mesh.normals);
  add_missing_normals(model.mesh, groups);
  return model;
}

}  // namespace gradus::pipeline
