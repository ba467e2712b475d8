#pragma once
// Changing what objects share with others.

#include <memory>
#include <utility>

#include "scene/scene.hpp"

namespace gradus::test {

/// Gives an object a mesh of its own, changed.
template <class Change>
void change_mesh(pipeline::Object& object, const Change& change) {
  Mesh mesh = *object.mesh;
  change(mesh);
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
}

/// Changes all materials of an object.
template <class Change>
void change_materials(pipeline::Object& object, const Change& change) {
  change_mesh(object, [&](Mesh& mesh) {
    for (Material& material : mesh.materials) change(material);
  });
}

}  // namespace gradus::test
