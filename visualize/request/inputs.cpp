#include "request/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "request/faces_file.hpp"
#include "request/fingerprint.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus {
namespace {

/// A maze up to this long is written out in a figure's command, so that the figure needs no file to be made
/// again.
constexpr std::size_t longest_inline_maze = 1024;
/// The same of faces.
constexpr std::size_t longest_inline_faces = 4096;

std::string flag_of(const Parameter& parameter) { return "--" + hyphened(parameter.name); }

class InputReader {
 public:
  InputReader(const TopicEntry& topic, const GivenTexts& given, Files& files)
      : topic_(topic), given_(given), files_(files) {}

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
    return find_method(topic_, wanted->second).name;
  }

  /// What the user gave, else the default, unless another parameter stands in its place.
  std::optional<std::string> text_for(const Parameter& parameter) const {
    const auto rival = std::ranges::find_if(topic_.parameters, [&](const Parameter& other) {
      return other.instead_of == parameter.name && given_.contains(other.name);
    });
    if (const auto known = given_.find(parameter.name); known != given_.end()) {
      if (rival != topic_.parameters.end()) {
        refuse_usage(
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
    const std::string name = canonical(parameter, text);
    const GivenFile file = opened(parameter, text);
    const std::string called =
        fmt::format("{}: {}", flag_of(parameter), text == dash ? "standard input" : shown(text));
    return {.name = parameter.name,
            .text = name,
            .image = std::make_shared<const Image>(
                files_.picture(file, called, std::min(parameter.most, most_png_pixels))),
            .hash = fingerprint(file.bytes)};
  }

  Arguments::Entry maze(const Parameter& parameter, const std::string& text) {
    const std::string name = canonical(parameter, text);
    if (is_maze_rows(trimmed(text))) {
      std::string rows = name + "\n";
      std::ranges::replace(rows, '/', '\n');
      return {.name = parameter.name, .text = name, .content = rows};
    }
    const auto [path, bytes, quotable] = opened(parameter, text);
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
  pipeline::FileReader libraries_of(const GivenFile& model, Arguments::Entry& entry) {
    return files_.beside(
        model, [&](const std::string& library, const std::string& path, const pipeline::LibraryText& found) {
          if (std::ranges::find(inputs_.files, path) == inputs_.files.end()) inputs_.files.push_back(path);
          if (entry.libraries.emplace(library, found.text).second)
            entry.hash += " " + fingerprint(found.text);
        });
  }

  static pipeline::TextFile called(const GivenFile& file) {
    return {file.path == dash ? "standard input" : file.path, file.quotable};
  }

  /// A model and the material libraries that lie beside it.
  Arguments::Entry model(const Parameter& parameter, const std::string& text) {
    const std::string name = canonical(parameter, text);
    const GivenFile file = opened(parameter, text);
    Arguments::Entry entry{
        .name = parameter.name, .text = name, .content = file.bytes, .hash = fingerprint(file.bytes)};
    // Reading it shows which libraries it names, and whether it can be read
    const pipeline::ModelFile model =
        pipeline::parse_obj(file.bytes, called(file), libraries_of(file, entry));
    for (std::string& remark : first_notes(model.notes)) inputs_.remarks.push_back(std::move(remark));
    return entry;
  }

  /// Faces as they are written, or those of a file.
  Arguments::Entry faces(const Parameter& parameter, const std::string& text) {
    if (!text.starts_with('@') && text.find(',') != std::string::npos) return read_argument(parameter, text);
    const GivenFile file = opened(parameter, text);
    Arguments::Entry of_file{.name = parameter.name,
                             .text = file.path.substr(file.path.find_last_of('/') + 1),
                             .hash = fingerprint(file.bytes)};
    Arguments::Entry entry = read_argument(
        parameter, faces_of_file(file.bytes, called(file), libraries_of(file, of_file), parameter.most));
    if (entry.text.size() <= longest_inline_faces) return entry;
    of_file.value = std::move(entry.value);
    return of_file;
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

  GivenFile opened(const Parameter& parameter, const std::string& text) {
    GivenFile file = files_.open(text, flag_of(parameter));
    inputs_.files.push_back(file.path);
    return file;
  }

  const TopicEntry& topic_;
  const GivenTexts& given_;
  Files& files_;
  Inputs inputs_;
};

}  // namespace

const TopicEntry& find_topic(std::string_view word) {
  if (const TopicEntry* exactly = find_entry(word)) return *exactly;
  // All names and aliases in one list; each points back to its topic
  std::vector<std::string> names;
  std::vector<const TopicEntry*> owners;
  for (const TopicEntry* topic : catalogue()) {
    names.push_back(topic->name);
    owners.push_back(topic);
    for (const std::string& alias : topic->aliases) {
      names.push_back(alias);
      owners.push_back(topic);
    }
  }
  const std::vector<std::size_t> matches = matching_names(word, names);
  std::vector<std::string> meant;
  for (const std::size_t i : matches) {
    if (meant.empty() || meant.back() != owners[i]->name) meant.push_back(owners[i]->name);
  }
  if (meant.size() == 1) return *owners[matches.front()];
  if (meant.empty()) {
    refuse_usage(fmt::format("TOPIC: expected the name of a topic (`gradus list` shows all), found {}{}",
                             shown(word), suggestion(word, names)));
  }
  return *owners[matches[choose_name("TOPIC", word, meant)]];
}

const Method& find_method(const TopicEntry& topic, std::string_view word, std::string_view flag) {
  std::vector<std::string> names;
  for (const Method& known : topic.methods) names.push_back(known.name);
  return topic.methods[choose_name(flag, word, names)];
}

std::string expected_value(const Parameter& parameter) {
  return parameter.example.empty() ? "a value" : fmt::format("a value like {}", parameter.example);
}

std::string file_name_in(const std::string& text) { return text.starts_with('@') ? text.substr(1) : text; }

std::vector<std::string> first_notes(const std::vector<std::string>& notes) {
  constexpr std::size_t most = 5;
  const std::size_t count = std::min(notes.size(), most);
  std::vector<std::string> first(notes.begin(), notes.begin() + static_cast<std::ptrdiff_t>(count));
  if (notes.size() > count)
    first.push_back(fmt::format("and {} more remarks like these", notes.size() - count));
  return first;
}

Inputs read_inputs(const TopicEntry& topic, const GivenTexts& given, Files& files) {
  return InputReader(topic, given, files).read();
}

std::string input_hash(const Arguments& arguments) {
  std::string hashes;
  for (const Arguments::Entry& entry : arguments.entries()) {
    if (!entry.hash.empty()) hashes += (hashes.empty() ? "" : " ") + entry.hash;
  }
  return hashes;
}

}  // namespace gradus
