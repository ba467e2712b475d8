#pragma once
// The arguments of a run from the flags of a command line, and back; files are read from the disk.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "request/inputs.hpp"

namespace gradus::cli {

/// Where a file that an argument names lies.
struct FoundFile {
  std::string path;
  bool quotable = true;  ///< GivenFile's

  // NOLINTNEXTLINE(google-explicit-constructor): most files are the user's own
  FoundFile(std::string where, bool may_be_quoted = true) : path(std::move(where)), quotable(may_be_quoted) {}
};

/// Where a file that an argument names is to be looked for. `flag` is for errors: "--image".
using FindFile = std::function<FoundFile(const std::string& name, const std::string& flag)>;

/// The name as it stands; where there is no such file, what comes with the program under that name.
FoundFile as_named(const std::string& name, const std::string& flag);

/// The arguments with files from the disk, or from standard input for "-". Throws UsageError, ArgumentError
/// or InputError: wrong spelling, unreadable file, no PNG.
Inputs read_inputs(const TopicEntry& topic, const GivenTexts& given, const FindFile& find = as_named);

/// "gradus figure <topic>" and every argument, but for the default method and what a notation may have
/// otherwise.
std::string command_of(std::string_view command, const TopicEntry& topic, const Arguments& arguments);

}  // namespace gradus::cli
