#include "cli/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cairo/image_file.hpp"
#include "cli/errors.hpp"
#include "cli/faces_file.hpp"
#include "cli/files.hpp"
#include "cli/names.hpp"
#include "cli/shipped.hpp"
#include "scene/files.hpp"
#include "scene/obj.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

/// A maze up to this long is written out in a figure's command, so that the figure needs no file to be made
/// again.
constexpr std::size_t longest_inline_maze = 1024;
/// The same of faces.
constexpr std::size_t longest_inline_faces = 4096;

bool is_flag(const TopicEntry& topic, std::string_view name) {
  const auto known = std::ranges::find(topic.parameters, name, &Parameter::name);
  return known != topic.parameters.end() && known->type == ParameterType::flag;
}

std::string flag_of(const Parameter& parameter) { return "--" + hyphened(parameter.name); }

class InputReader {
 public:
  InputReader(const TopicEntry& topic, const std::map<std::string, std::string>& given, const FindFile& find)
      : topic_(topic), given_(given), find_(find) {}

  Inputs read() {
    inputs_.arguments.set({.name = "method", .text = method()});
    for (const Parameter& parameter : topic_.parameters) {
      const auto text = text_for(parameter);
      if (!text) continue;
      Arguments::Entry read = entry(parameter, *text);
      read.given = given_.contains(parameter.name);
      inputs_.arguments.set(std::move(read));
    }
    return std::move(inputs_);
  }

 private:
  std::string method() const {
    const auto wanted = given_.find("method");
    if (wanted == given_.end()) return topic_.default_method;
    std::vector<std::string> names;
    for (const Method& known : topic_.methods) names.push_back(known.name);
    return names[choose_name("--method", wanted->second, names)];
  }

  /// What the user gave, else the default, unless another parameter stands in its place.
  std::optional<std::string> text_for(const Parameter& parameter) const {
    const auto rival = std::ranges::find_if(topic_.parameters, [&](const Parameter& other) {
      return other.instead_of == parameter.name && given_.contains(other.name);
    });
    if (const auto known = given_.find(parameter.name); known != given_.end()) {
      if (rival != topic_.parameters.end()) {
        throw UsageError(
            fmt::format("{}: expected either this or {}, found both", flag_of(*rival), flag_of(parameter)));
      }
      return known->second;
    }
    if (parameter.default_value.empty() || rival != topic_.parameters.end()) return std::nullopt;
    return parameter.default_value;
  }

  Arguments::Entry entry(const Parameter& parameter, const std::string& text) {
    switch (parameter.type) {
      case ParameterType::picture:
        return picture(parameter, text);
      case ParameterType::maze:
        return maze(parameter, text);
      case ParameterType::model:
        return model(parameter, text);
      case ParameterType::faces:
        return faces(parameter, text);
      case ParameterType::choice: {
        const std::size_t chosen = choose_name(flag_of(parameter), text, parameter.choices);
        return {.name = parameter.name, .text = parameter.choices[chosen]};
      }
      default:
        return read_argument(parameter, text);
    }
  }

  Arguments::Entry picture(const Parameter& parameter, const std::string& text) {
    const std::string name = canonical(parameter, text), bytes = file_bytes(parameter, text).bytes;
    const std::string called =
        fmt::format("{}: {}", flag_of(parameter), text == dash ? "standard input" : shown(text));
    return {.name = parameter.name,
            .text = name,
            .image = std::make_shared<const Image>(
                decode_picture(bytes, called, std::min(parameter.most, most_png_pixels))),
            .hash = fingerprint(bytes)};
  }

  Arguments::Entry maze(const Parameter& parameter, const std::string& text) {
    const std::string name = canonical(parameter, text);
    if (text != dash && is_maze_rows(trimmed(text))) {
      std::string rows = name + "\n";
      std::ranges::replace(rows, '/', '\n');
      return {.name = parameter.name, .text = name, .content = rows};
    }
    const auto [bytes, quotable] = file_bytes(parameter, text);
    std::string rows = plain_lines(bytes), joined(trimmed(rows));
    std::ranges::replace(joined, '\n', '/');
    if (joined.size() <= longest_inline_maze && is_maze_rows(joined)) {
      if (even(joined)) return {.name = parameter.name, .text = joined, .content = rows};
    }
    return {.name = parameter.name,
            .text = name,
            .content = rows,
            .hash = fingerprint(bytes),
            .quotable = quotable};
  }

  /// Finds the libraries that lie beside a model, and keeps them with the entry.
  pipeline::FileReader libraries_of(const std::string& path, Arguments::Entry& entry) {
    const auto took = [&](const std::string& library, const std::string& file,
                          const pipeline::LibraryText& found) {
      if (std::ranges::find(inputs_.files, file) == inputs_.files.end()) inputs_.files.push_back(file);
      if (entry.libraries.emplace(library, found.text).second) entry.hash += " " + fingerprint(found.text);
    };
    const auto none = [](const std::string&) { return std::optional<pipeline::LibraryText>(); };
    return path == dash ? pipeline::FileReader(none) : pipeline::libraries_beside(path, took);
  }

  /// A model and the material libraries that lie beside it.
  Arguments::Entry model(const Parameter& parameter, const std::string& text) {
    const std::string name = canonical(parameter, text);
    const auto [bytes, quotable] = file_bytes(parameter, text);
    const std::string path = inputs_.files.back();
    Arguments::Entry entry{
        .name = parameter.name, .text = name, .content = bytes, .hash = fingerprint(bytes)};
    // Reading it shows which libraries it names, and whether it can be read
    const pipeline::ModelFile model = pipeline::parse_obj(
        bytes, {path == dash ? "standard input" : path, quotable}, libraries_of(path, entry));
    for (std::string& remark : first_notes(model.notes)) inputs_.remarks.push_back(std::move(remark));
    return entry;
  }

  /// Faces as they are written, or those of a file.
  Arguments::Entry faces(const Parameter& parameter, const std::string& text) {
    if (text != dash && !text.starts_with('@') && text.find(',') != std::string::npos)
      return read_argument(parameter, text);
    const auto [bytes, quotable] = file_bytes(parameter, text);
    const std::string path = inputs_.files.back();
    Arguments::Entry file{.name = parameter.name,
                          .text = path == dash ? path : fs::path(path).filename().string(),
                          .hash = fingerprint(bytes)};
    Arguments::Entry entry =
        read_argument(parameter, faces_of_file(bytes, {path == dash ? "standard input" : path, quotable},
                                               libraries_of(path, file), parameter.most));
    if (entry.text.size() <= longest_inline_faces) return entry;
    file.value = std::move(entry.value);
    return file;
  }

  /// A maze with uneven rows keeps its file's name, for the message that the topic will have to give.
  static bool even(std::string_view rows) {
    const std::size_t width = std::min(rows.find('/'), rows.size());
    for (std::size_t at = 0; at <= rows.size(); at += width + 1) {
      if (std::min(rows.find('/', at), rows.size()) != at + width) return false;
    }
    return true;
  }

  /// Without a byte order mark and carriage returns.
  static std::string plain_lines(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    std::string lines(bytes);
    std::erase(lines, '\r');
    return lines;
  }

  struct Taken {
    std::string bytes;
    bool quotable;
  };

  Taken file_bytes(const Parameter& parameter, const std::string& text) {
    if (text == dash) {
      if (stdin_taken_) {
        throw UsageError(fmt::format("{}: expected a file, found - for a second time", flag_of(parameter)));
      }
      stdin_taken_ = true;
      inputs_.files.emplace_back(dash);
      return {read_input(text, flag_of(parameter)), true};
    }
    // "@maze.txt" is another way to say that a file is meant
    const FoundFile found = find_(text.starts_with('@') ? text.substr(1) : text, flag_of(parameter));
    inputs_.files.push_back(found.path);
    return {read_input(found.path, flag_of(parameter)), found.quotable};
  }

  const TopicEntry& topic_;
  const std::map<std::string, std::string>& given_;
  const FindFile& find_;
  Inputs inputs_;
  bool stdin_taken_ = false;
};

}  // namespace

FoundFile as_named(const std::string& name, const std::string&) {
  std::error_code error;
  if (fs::exists(name, error)) return name;
  const std::string example = shipped_example(name);
  return example.empty() ? name : example;
}

std::vector<std::string> first_notes(const std::vector<std::string>& notes) {
  constexpr std::size_t most = 5;
  const std::size_t count = std::min(notes.size(), most);
  std::vector<std::string> first(notes.begin(), notes.begin() + static_cast<std::ptrdiff_t>(count));
  if (notes.size() > count)
    first.push_back(fmt::format("and {} more remarks like these", notes.size() - count));
  return first;
}

Inputs read_inputs(const TopicEntry& topic, const std::map<std::string, std::string>& given,
                   const FindFile& find) {
  return InputReader(topic, given, find).read();
}

std::string complaint_of(const ArgumentError& error) {
  return fmt::format("--{}: {}", hyphened(error.parameter), error.what());
}

std::string input_hash(const Arguments& arguments) {
  std::string hashes;
  for (const Arguments::Entry& entry : arguments.entries()) {
    if (!entry.hash.empty()) hashes += (hashes.empty() ? "" : " ") + entry.hash;
  }
  return hashes;
}

std::string command_of(std::string_view command, const TopicEntry& topic, const Arguments& arguments) {
  std::string line = fmt::format("gradus {} {}", command, topic.name);
  for (const Arguments::Entry& entry : arguments.entries()) {
    if (entry.name == "method" && entry.text == topic.default_method) continue;
    if (is_flag(topic, entry.name)) {
      if (!entry.text.empty()) line += " --" + hyphened(entry.name);
    } else {
      line += " " + flag_with(hyphened(entry.name), entry.text);
    }
  }
  return line;
}

}  // namespace gradus::cli
