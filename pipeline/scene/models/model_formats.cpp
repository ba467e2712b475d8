#include "scene/models/model_formats.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/models/letters.hpp"
#include "scene/models/off.hpp"
#include "scene/models/ply.hpp"
#include "scene/models/stl.hpp"

namespace gradus::pipeline {

std::string ending_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || name.find('/', dot) != std::string_view::npos) return "";
  return in_small_letters(name.substr(dot + 1));
}

bool is_other_format(std::string_view name) {
  const std::string ending = ending_of(name);
  return std::ranges::find(own_endings, ending) != own_endings.end() ||
         std::ranges::find(imported_endings, ending) != imported_endings.end();
}

ModelFile read_model(std::string_view bytes, const TextFile& file, const FileReader& open,
                     const ModelImporter& import) {
  if (!is_other_format(file.name)) return parse_obj(bytes, file, open);
  const std::string ending = ending_of(file.name);
  if (ending == "off") return parse_off(bytes, file);
  if (ending == "ply") return parse_ply(bytes, file);
  if (ending == "stl") return parse_stl(bytes, file);
  if (!import) {
    refuse_input(
        fmt::format("{}: expected an OBJ, OFF, PLY or STL file, for gradus was built without Assimp, which "
                    "reads others, found one of another format",
                    shown_name(file.name)));
  }
  return import(bytes, file, open);
}

}  // namespace gradus::pipeline
