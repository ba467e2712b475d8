#pragma once
// A model of a text for the tests of the reader.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/refusal.hpp"
#include "scene/models/obj.hpp"

namespace gradus::pipeline {

using Files = std::map<std::string, std::string>;

inline ModelFile parse(const std::string& text, const Files& files = {}) {
  return parse_obj(text, "m.obj", [&files](const std::string& name) -> std::optional<LibraryText> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional<LibraryText>(found->second);
  });
}

/// What is said of a broken file; empty when it is read.
inline std::string refusal(const std::string& text, const Files& files = {}) {
  try {
    parse(text, files);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";

inline std::vector<Corner> corners(const ModelFile& model, std::size_t face) {
  const auto found = corners_of(model.mesh, model.mesh.faces[face]);
  return {found.begin(), found.end()};
}

inline constexpr const char* red = "newmtl red\nKd 1 0 0\n";

}  // namespace gradus::pipeline
