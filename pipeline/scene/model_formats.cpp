#include "scene/model_formats.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::pipeline {

std::string ending_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || name.find('/', dot) != std::string_view::npos) return "";
  std::string ending(name.substr(dot + 1));
  for (char& c : ending)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

bool is_imported(std::string_view name) {
  return std::ranges::find(imported_endings, ending_of(name)) != imported_endings.end();
}

ModelFile read_model(std::string_view bytes, const TextFile& file, const FileReader& open,
                     const ModelImporter& import) {
  if (!is_imported(file.name)) return parse_obj(bytes, file, open);
  if (!import) {
    refuse_input(
        fmt::format("{}: expected an OBJ file, for gradus was built without Assimp, which reads "
                    "others, found one of another format",
                    shown_name(file.name)));
  }
  return import(bytes, file, open);
}

}  // namespace gradus::pipeline
