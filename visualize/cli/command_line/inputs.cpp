#include "cli/command_line/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cairo/image_file.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/files/files.hpp"
#include "cli/files/shipped.hpp"
#include "request/names.hpp"
#include "scene/files.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// Whether the value is a default that a reader's notation may have otherwise: said, it would be asked for.
bool is_left_to_notations(const TopicEntry& topic, const Arguments::Entry& entry) {
  const auto found = std::ranges::find(topic.parameters, entry.name, &Parameter::name);
  return !entry.given && found != topic.parameters.end() && found->noted;
}

bool is_flag(const TopicEntry& topic, std::string_view name) {
  const auto known = std::ranges::find(topic.parameters, name, &Parameter::name);
  return known != topic.parameters.end() && known->type == ParameterType::flag;
}

/// Files of the disk, looked for by a function; and standard input, once.
class FoundFiles : public Files {
 public:
  explicit FoundFiles(const FindFile& find) : find_(find) {}

  GivenFile open(const std::string& name, const std::string& flag) override {
    if (name == dash) {
      if (stdin_taken_) throw UsageError(fmt::format("{}: expected a file, found - for a second time", flag));
      stdin_taken_ = true;
      return {name, read_input(name, flag)};
    }
    const FoundFile found = find_(file_name_in(name), flag);
    return {found.path, read_input(found.path, flag), found.quotable};
  }

  pipeline::FileReader beside(const GivenFile& model, Took took) override {
    if (model.path != dash) return pipeline::libraries_beside(model.path, std::move(took));
    return [](const std::string&) { return std::optional<pipeline::LibraryText>(); };
  }

  Image picture(const GivenFile& file, const std::string& called, std::int64_t most_pixels) override {
    return decode_picture(file.bytes, called, most_pixels);
  }

 private:
  const FindFile& find_;
  bool stdin_taken_ = false;
};

}  // namespace

FoundFile as_named(const std::string& name, const std::string&) {
  std::error_code error;
  if (fs::exists(name, error)) return name;
  const std::string example = shipped_example(name);
  return example.empty() ? name : example;
}

Inputs read_inputs(const TopicEntry& topic, const GivenTexts& given, const FindFile& find) {
  FoundFiles files(find);
  return gradus::read_inputs(topic, given, files);
}

std::string command_of(std::string_view command, const TopicEntry& topic, const Arguments& arguments) {
  std::string line = fmt::format("gradus {} {}", command, topic.name);
  for (const Arguments::Entry& entry : arguments.entries()) {
    if (entry.name == "method" && entry.text == topic.default_method) continue;
    if (is_left_to_notations(topic, entry)) continue;
    if (is_flag(topic, entry.name)) {
      if (!entry.text.empty()) line += " --" + hyphened(entry.name);
    } else {
      line += " " + flag_with(hyphened(entry.name), entry.text);
    }
  }
  return line;
}

}  // namespace gradus::cli
