#pragma once
// The model that a story is about: the one given as `model`, or one that comes with the project.

#include <optional>
#include <string>
#include <string_view>

#include "scene/models/obj.hpp"
#include "stories/telling.hpp"

namespace gradus {

inline bool names_a_model(const Arguments& arguments) {
  return arguments.has("model") && !arguments.text("model").empty();
}

/// The model's file name. own: of the one that is shown where none is given.
inline std::string name_of_model(const Arguments& arguments, std::string_view own) {
  return names_a_model(arguments) ? arguments.text("model") : std::string(own);
}

inline Mesh given_model(const Arguments& arguments, std::string_view own) {
  if (!names_a_model(arguments)) {
    const auto open = [](const std::string& name) { return std::optional(std::string(shipped_model(name))); };
    return pipeline::parse_obj(shipped_model(own), std::string(own), open).mesh;
  }
  const Arguments::Entry& entry = arguments.entry("model");
  const auto open = [&](const std::string& name) {
    const auto found = entry.libraries.find(name);
    return found == entry.libraries.end() ? std::nullopt : std::optional(found->second);
  };
  return pipeline::parse_obj(entry.content, entry.text, open).mesh;
}

}  // namespace gradus
