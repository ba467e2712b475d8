#pragma once
// From the flags of a command line to the arguments of a run: defaults filled in, files read.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stories/topic.hpp"

namespace gradus::cli {

struct Inputs {
  Arguments arguments;
  std::vector<std::string> files;    ///< paths that were read
  std::vector<std::string> remarks;  ///< what models have that was left out, a line each
};

/// A file that an argument names.
struct FoundFile {
  std::string path;
  bool quotable = true;  ///< whether messages may show what stands in it: not where others have named it

  // NOLINTNEXTLINE(google-explicit-constructor): most files are the user's own
  FoundFile(std::string where, bool may_be_quoted = true) : path(std::move(where)), quotable(may_be_quoted) {}
};

/// Where a file that an argument names is to be looked for. `flag` is for errors: "--image".
using FindFile = std::function<FoundFile(const std::string& name, const std::string& flag)>;

/// The name as it stands; where there is no such file, what comes with the program under that name.
FoundFile as_named(const std::string& name, const std::string& flag);

/// The first few notes on a model, and how many more there are.
std::vector<std::string> first_notes(const std::vector<std::string>& notes);

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
