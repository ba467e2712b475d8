#include "scene/models/obj_notes.hpp"

#include <fmt/core.h>

#include <charconv>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "scene/decimal.hpp"

namespace gradus::pipeline {
namespace {

/// The lines with their ends, which are \n whatever the file has: it is opened as text.
std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (pair) continue;
    line += text[i] == '\r' ? '\n' : text[i];
    if (line.back() == '\n') lines.push_back(std::exchange(line, ""));
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Split at every one of these, empty pieces kept.
std::vector<std::string> split_at(const std::string& text, char mark) {
  std::vector<std::string> pieces{""};
  for (const char c : text) {
    if (c == mark) {
      pieces.emplace_back();
    } else {
      pieces.back() += c;
    }
  }
  return pieces;
}

/// Split at white space, without empty pieces.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool inside = false;
  for (const char c : line) {
    const bool blank = c == ' ' || c == '\t' || c == '\n';
    if (!blank && !inside) words.emplace_back();
    if (!blank) words.back() += c;
    inside = !blank;
  }
  return words;
}

std::optional<int> whole(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && at == end ? std::optional(number) : std::nullopt;
}

bool starts(const std::string& line, std::string_view key) { return line.starts_with(key); }

double number(const std::string& word) {
  double value = 0;
  read_decimal(word.data(), word.data() + word.size(), value);
  return value;
}

using Colours = std::map<std::string, dvec3>;

Colours colours_of(std::string_view library) {
  Colours colours;
  std::string name;
  for (const std::string& line : lines_of(library)) {
    if (starts(line, "newmtl")) name = split_at(line, ' ').back();
    if (!starts(line, "Kd")) continue;
    const auto words = words_of(line);
    if (words.size() >= 4) colours[name] = {number(words[1]), number(words[2]), number(words[3])};
  }
  return colours;
}

/// The corners of a face as the loader holds them: texts, until they are needed.
struct Fields {
  std::vector<std::string> vertices, normals;
  bool complete = true;  ///< whether every corner has a third field
};

Fields fields_of(const std::string& line) {
  Fields fields;
  for (const std::string& word : words_of(line)) {
    const auto parts = split_at(word, '/');
    if (parts[0] == "f") continue;
    fields.vertices.push_back(parts[0]);
    if (parts.size() < 3) {
      fields.complete = false;
      return fields;
    }
    fields.normals.push_back(parts[2]);
  }
  return fields;
}

/// A name whose line end can be seen.
std::string with_visible_ends(const std::string& name) {
  std::string shown;
  for (const char c : name) shown += c == '\n' ? std::string("\\n") : std::string(1, c);
  return shown;
}

/// Whether a list of so many entries can be asked for this index: from its end where it is negative.
bool can_index(int index, int size) { return -size <= index && index < size; }

class Loader {
 public:
  explicit Loader(std::string_view library) : colours_(colours_of(library)) {
    if (colours_.empty()) colours_["default"] = {1, 0, 0};
  }

  std::vector<NotesFace> faces(std::string_view text) {
    std::vector<NotesFace> found;
    int number = 0;
    for (const std::string& line : lines_of(text)) {
      ++number;
      if (starts(line, "vn")) ++normals_;
      if (line.find("usemtl") != std::string::npos) {
        const auto pieces = split_at(line, ' ');
        material_ = pieces.size() > 1 ? pieces[1] : "";
      } else if (starts(line, "f")) {
        found.push_back(face(line));
        found.back().line = number;
        if (!found.back().failure.empty()) break;
      }
    }
    return found;
  }

 private:
  NotesFace face(const std::string& line) const {
    NotesFace made;
    const Fields fields = fields_of(line);
    if (!fields.complete) {
      made.failure = "a corner has no third field";
      return made;
    }
    const std::size_t corners = fields.vertices.size();
    if (corners != 3 && corners != 4) return made;
    for (std::size_t i = 0; i < corners; ++i) {
      const auto normal = whole(fields.normals[i]);
      if (!normal || !can_index(*normal - 1, normals_)) {
        made.failure = fmt::format("there is no normal '{}'", fields.normals[i]);
        return made;
      }
    }
    made.material = material_;
    const auto colour = colours_.find(material_);
    if (colour == colours_.end()) {
      made.failure = fmt::format("there is no material '{}'", with_visible_ends(material_));
      return made;
    }
    made.colour = colour->second;
    const auto vertex = [&](std::size_t i) { return whole(fields.vertices[i]).value_or(0) - 1; };
    made.triangles.push_back({vertex(0), vertex(1), vertex(2)});
    if (corners == 4) made.triangles.push_back({vertex(2), vertex(3), vertex(0)});
    return made;
  }

  Colours colours_;
  std::string material_;
  int normals_ = 0;
};

}  // namespace

std::vector<NotesFace> notes_faces(std::string_view text, std::string_view library) {
  return Loader(library).faces(text);
}

}  // namespace gradus::pipeline
