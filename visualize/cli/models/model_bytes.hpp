#pragma once
// A model on its way from one process of ours to another.

#include <optional>
#include <string>
#include <string_view>

#include "scene/models/obj.hpp"

namespace gradus::cli {

/// All of a model but the pictures that have been read. For a process of the same program alone: numbers are
/// as they stand in memory.
std::string bytes_of(const pipeline::ModelFile& model);

/// The model in such bytes, or nothing when they are none: cut off, or with numbers of corners, materials and
/// files that don't exist.
std::optional<pipeline::ModelFile> model_in_bytes(std::string_view bytes);

}  // namespace gradus::cli
