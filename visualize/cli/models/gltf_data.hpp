#pragma once
// What the buffers of glTF files hold.

#include <optional>
#include <string>
#include <string_view>

#include "scene/located_json.hpp"
#include "scene/models/obj.hpp"

namespace gradus::cli {

/// Refuses data of a glTF file that are not there: buffers shorter than they say, views beyond their buffer,
/// accessors beyond their view, attributes of fewer vertices than there are, numbers of vertices that are not
/// there, pictures in the file that are empty.
///
/// root: the JSON. file: how mistakes call it. binary: the binary part of a GLB file. open: gives the files
/// of
///   buffers; one that is not there is not checked.
///
/// Errors: InputError "file:line: expected …, found …".
void check_gltf_data(const pipeline::JsonNode& root, const std::string& file,
                     std::optional<std::string_view> binary, const pipeline::FileReader& open);

/// A name that stands in a URI: "my%20wood.png" is "my wood.png".
std::string name_in_uri(std::string_view uri);

}  // namespace gradus::cli
