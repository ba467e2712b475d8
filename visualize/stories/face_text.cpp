#include "stories/face_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "stories/colors.hpp"

namespace gradus {
namespace {

const std::array<std::string, 3> coordinates{"x", "y", "z"};

/// What stands before the colon: a name, a colour, both or neither.
Read<FaceText> read_head(std::string_view head, std::size_t number) {
  FaceText face{.name = fmt::format("{}", number), .points = {}};
  const std::size_t hash = std::min(head.find('#'), head.size());
  if (const std::string_view color = trimmed(head.substr(hash)); !color.empty()) {
    face.color = hex_color(lowered(color));
    if (face.color.empty())
      return Misread{fmt::format("face {}: expected a colour #rrggbb, found {}", number, shown(color))};
  }
  const std::string_view name = trimmed(head.substr(0, hash));
  if (name.empty()) return face;
  if (!is_face_name(name)) {
    return Misread{fmt::format(
        "face {}: expected a name of at most 24 characters without ':', ';', ',' and '#', found {}", number,
        shown(name))};
  }
  face.name = name;
  return face;
}

Read<FaceText> read_face(std::string_view text, std::size_t number) {
  const std::size_t colon = text.find(':');
  const bool has_head = colon != std::string_view::npos;
  Read<FaceText> read = read_head(has_head ? text.substr(0, colon) : std::string_view(), number);
  if (std::holds_alternative<Misread>(read)) return read;
  auto& face = std::get<FaceText>(read);
  const auto named = [&](const std::string& what) {
    return Misread{fmt::format("face {}: {}", shown(face.name), what)};
  };
  auto points = read_tuples(has_head ? text.substr(colon + 1) : text, coordinates);
  if (const Misread* misread = std::get_if<Misread>(&points)) return named(misread->what);
  face.points = std::get<std::vector<Tuple>>(std::move(points));
  if (face.points.size() < 3)
    return named(fmt::format("expected at least 3 points, found {}", face.points.size()));
  return read;
}

}  // namespace

bool is_face_name(std::string_view text) {
  const auto separates = [](char c) {
    return std::string_view(":;,#").find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ';
  };
  return !text.empty() && text.size() <= 24 && text == trimmed(text) && !std::ranges::any_of(text, separates);
}

Read<std::vector<FaceText>> read_faces(std::string_view text) {
  std::vector<FaceText> faces;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end + 1;
    if (trimmed(word).empty()) continue;
    Read<FaceText> read = read_face(word, faces.size() + 1);
    if (const Misread* misread = std::get_if<Misread>(&read)) return *misread;
    FaceText& face = std::get<FaceText>(read);
    if (std::ranges::find(faces, face.name, &FaceText::name) != faces.end())
      return Misread{fmt::format("expected every name once, found {} twice", shown(face.name))};
    faces.push_back(std::move(face));
  }
  if (faces.empty()) {
    return Misread{fmt::format("expected faces like 'a: 0,0,0 4,0,0 4,3,0; b: 0,0,1 4,0,1 4,3,1', found {}",
                               shown(text))};
  }
  return faces;
}

std::string text_of(const std::vector<FaceText>& faces) {
  std::string text;
  for (const FaceText& face : faces) {
    text += (text.empty() ? "" : "; ") + face.name + (face.color.empty() ? "" : " " + face.color) + ": " +
            text_of(face.points);
  }
  return text;
}

}  // namespace gradus
