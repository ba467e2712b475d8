#pragma once
// Faces in space from JSON and OBJ files, in the form in which the command line has them.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "request/written_json.hpp"
#include "scene/models/obj.hpp"

namespace gradus {

/// Takes what is wrong with a line.
using ComplainOfLine = std::function<void(int line, const std::string& what)>;

/// A list of faces [{"name": "a", "color": "#cc79a7", "points": [[0, 0, 0], …]}, …] as read_faces takes it;
/// name and colour may be left out. Nothing where something had to be complained of.
std::optional<std::string> faces_text(const JsonNode& faces, const ComplainOfLine& complain);

/// The same of a file's contents: such a list, or an OBJ file, whose faces go by their numbers and have the
/// colours of their materials. open: finds the libraries of an OBJ file. Throws InputError "file:line:
/// expected …, found …", for more corners than `most`, too.
std::string faces_of_file(std::string_view text, const pipeline::TextFile& file,
                          const pipeline::FileReader& open, std::int64_t most);

}  // namespace gradus
