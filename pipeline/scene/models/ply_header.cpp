#include "scene/models/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::pipeline {
namespace {

/// The bytes of the header, with the end of its last line.
std::size_t header_size(std::string_view bytes) {
  constexpr std::string_view last = "end_header";
  std::size_t at = bytes.find(last);
  // A comment may speak of it
  while (at != std::string_view::npos && at > 0 && bytes[at - 1] != '\n' && bytes[at - 1] != '\r')
    at = bytes.find(last, at + 1);
  if (at == std::string_view::npos) return bytes.size();
  at = bytes.find_first_of("\r\n", at);
  if (at == std::string_view::npos) return bytes.size();
  // A file of bare CR may have an LF as its first byte of data
  return bytes.starts_with("ply\r\n") && bytes.substr(at).starts_with("\r\n") ? at + 2 : at + 1;
}

PlyType type_of(Statement& s) {
  const std::string_view word = s.word();
  const auto found = std::ranges::find_if(
      ply_types, [word](const PlyType& type) { return word == type.name || word == type.other_name; });
  if (found == ply_types.end())
    s.fail(fmt::format("expected a type of numbers like float, found {}", s.quoted(word)));
  return *found;
}

std::string name_in(Statement& s, std::string_view what) {
  const std::string_view name = s.word();
  if (name.empty()) s.fail(fmt::format("expected the name of {}, found none", what));
  return std::string(name);
}

class HeaderReader {
 public:
  explicit HeaderReader(PlyHeader& header) : header_(header) {}

  /// Whether the header goes on behind this line.
  bool read(Statement& s) {
    const std::string_view key = s.word();
    if (key == "end_header") return false;
    if (key == "format") {
      form(s);
    } else if (key == "comment") {
      comment(s);
    } else if (key == "element") {
      if (header_.elements.size() == largest)
        s.fail(fmt::format("expected at most {} elements, found one more", largest));
      std::string name = name_in(s, "an element");
      header_.elements.push_back({std::move(name), s.whole("a number of rows", 0, std::int64_t{1} << 32)});
      s.end("an element");
    } else if (key == "property") {
      property(s);
    } else if (key != "obj_info") {
      s.fail(fmt::format("expected a line of a PLY header, found {}", s.quoted(key)));
    }
    return true;
  }

  bool formed() const { return formed_; }

 private:
  static constexpr std::size_t largest = 1000;  // of elements, and of the properties of each

  void form(Statement& s) {
    static constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian",
                                                           "binary_big_endian"};
    const std::string_view name = s.word(), version = s.word();
    const auto found = std::ranges::find(names, name);
    if (found == names.end() || version != "1.0")
      s.fail(fmt::format("expected {} 1.0, found {}", fmt::join(names, " 1.0, "),
                         s.quoted(std::string(name) + " " + std::string(version))));
    header_.form = static_cast<PlyHeader::Form>(found - names.begin());
    formed_ = true;
  }

  void comment(Statement& s) {
    if (s.word() != "TextureFile" || !header_.picture.empty()) return;
    header_.picture = s.rest();
    header_.picture_place = s.place(fmt::format("TextureFile {}", s.quoted(header_.picture)));
  }

  void property(Statement& s) {
    if (header_.elements.empty()) s.fail("expected an element before its properties, found a property");
    PlyProperty property;
    Statement ahead = s;
    if (ahead.word() == "list") {
      s.word();
      property.count = type_of(s);
      if (property.count->kind == PlyType::Kind::floating)
        s.fail("expected a list that is counted by whole numbers, found one counted by others");
    }
    property.type = type_of(s);
    property.name = name_in(s, "a property");
    s.end("a property");
    auto& known = header_.elements.back().properties;
    if (std::ranges::find(known, property.name, &PlyProperty::name) != known.end())
      s.fail(fmt::format("expected each property once, found {} again", s.quoted(property.name)));
    if (known.size() == largest)
      s.fail(fmt::format("expected at most {} properties of an element, found one more", largest));
    known.push_back(std::move(property));
  }

  PlyHeader& header_;
  bool formed_ = false;
};

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, const TextFile& file) {
  const auto refuse = [&file](std::string_view what) {
    refuse_input(fmt::format("{}: {}", shown_name(file.name), what));
  };
  if (!bytes.starts_with("ply\n") && !bytes.starts_with("ply\r"))
    refuse("expected a PLY file, which begins with ply, found something else");
  PlyHeader header;
  header.size = header_size(bytes);
  Statements lines(bytes.substr(0, header.size), file, Statements::Backslash::is_a_letter);
  lines.next();  // ply
  HeaderReader reader(header);
  while (std::optional<Statement> s = lines.next()) {
    header.lines = s->line();
    if (reader.read(*s)) continue;
    if (!reader.formed()) refuse("expected a line format, as ascii 1.0, found none");
    return header;
  }
  refuse("expected the line end_header, found the end of the file");
  return header;
}

}  // namespace gradus::pipeline
