#pragma once
// From the flags of a command line to the arguments of a run: defaults filled in, files read.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stories/topic.hpp"

namespace gradus::cli {

struct Inputs {
  Arguments arguments;
  std::vector<std::string> files;  ///< paths that were read
};

/// Where a file that an argument names is to be looked for. `flag` is for errors: "--image".
using FindFile = std::function<std::string(const std::string& name, const std::string& flag)>;

/// The name as it stands.
std::string as_named(const std::string& name, const std::string& flag);

/// The material library that a model names: beside the model, where the name says; else, for a path on
/// another disk, under its last part. Nothing when there is none.
std::optional<std::string> find_library(const std::string& model, std::string name);

/// Throws UsageError, ArgumentError or InputError: wrong spelling, unreadable file, no PNG.
Inputs read_inputs(const TopicEntry& topic, const std::map<std::string, std::string>& given,
                   const FindFile& find = as_named);

/// What a command says of an argument that it can't take: "--from: expected …".
std::string complaint_of(const ArgumentError& error);

/// The fingerprints of all files that the arguments stand for, in the order of the parameters; "" without
/// files.
std::string input_hash(const Arguments& arguments);

/// "gradus figure <topic>" and every argument that is not told by the defaults of the topic alone.
std::string command_of(std::string_view command, const TopicEntry& topic, const Arguments& arguments);

}  // namespace gradus::cli
