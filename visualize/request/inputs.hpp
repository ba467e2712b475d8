#pragma once
// From texts, by the names of a topic's parameters, to the arguments of a run: defaults filled in, files
// read.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/image.hpp"
#include "scene/models/obj.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// A file that an argument names.
struct GivenFile {
  std::string path, bytes;
  bool quotable = true;  ///< whether messages may show what stands in it: not where others have named it
};

/// Where the files are that arguments name: on a disk, or in a page.
class Files {
 public:
  /// Told of each file that a model names: by that name, and by its path.
  using Took = std::function<void(const std::string& name, const std::string& path,
                                  const pipeline::LibraryText& file)>;

  Files() = default;
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  virtual ~Files() = default;

  /// The file that an argument names, as it was written: see file_name_in. `flag` is for errors: "--image".
  /// Throws UsageError for one that is not there.
  virtual GivenFile open(const std::string& name, const std::string& flag) = 0;
  /// What a model names, from where it lies.
  virtual pipeline::FileReader beside(const GivenFile& model, Took took) = 0;
  /// The picture in a file of at most so many pixels; `called` is its name in errors. Throws InputError.
  virtual Image picture(const GivenFile& file, const std::string& called, std::int64_t most_pixels) = 0;
};

/// The name that an argument says: "@maze.txt" is another way to say that a file is meant.
std::string file_name_in(const std::string& text);

/// What was written, by the names of parameters, and "method".
using GivenTexts = std::map<std::string, std::string>;

struct Inputs {
  Arguments arguments;
  std::vector<std::string> files;    ///< paths that were read
  std::vector<std::string> remarks;  ///< what models have that was left out, a line each
};

/// The topic of that name or alias: a unique beginning is enough. Throws UsageError.
const TopicEntry& find_topic(std::string_view word);

/// The topic's method of that name; a unique beginning is enough. Throws UsageError naming `flag`.
const Method& find_method(const TopicEntry& topic, std::string_view word, std::string_view flag = "--method");

/// What a flag without its value is told to have one like: "a value like 3,4".
std::string expected_value(const Parameter& parameter);

/// The arguments of a run. given: texts by the names of parameters, and "method". Throws UsageError,
/// ArgumentError or InputError: wrong spelling, a file that is not there or not of its kind.
Inputs read_inputs(const TopicEntry& topic, const GivenTexts& given, Files& files);

/// The first few notes on a model, and how many more there are.
std::vector<std::string> first_notes(const std::vector<std::string>& notes);

/// The fingerprints of all files that the arguments stand for, in the order of the parameters; "" without
/// files.
std::string input_hash(const Arguments& arguments);

}  // namespace gradus
