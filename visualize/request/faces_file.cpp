#include "request/faces_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "core/refusal.hpp"
#include "figure/tone_of.hpp"
#include "stories/face_text.hpp"

namespace gradus {
namespace {

using Kind = JsonNode::Kind;

/// One list of faces, read to its end whatever is wrong with some of them.
class FacesReader {
 public:
  explicit FacesReader(const ComplainOfLine& complain) : complain_(complain) {}

  std::optional<std::string> read(const JsonNode& list) {
    if (list.kind != Kind::list || list.elements.empty()) {
      wrong(list, "a list of faces like [{\"name\": \"a\", \"points\": [[0, 0, 0], [4, 0, 0], [4, 3, 0]]}]");
    } else {
      for (const JsonNode& face : list.elements) read_face(face);
    }
    return whole_ ? std::optional(fmt::format("{}", fmt::join(faces_, "; "))) : std::nullopt;
  }

 private:
  void wrong(const JsonNode& node, std::string_view expected) {
    whole_ = false;
    complain_(node.line, fmt::format("expected {}, found {}", expected, described(node)));
  }

  void read_face(const JsonNode& node) {
    const JsonMember* points = node.member("points");
    if (node.kind != Kind::object || !points)
      return wrong(node, "a face {\"name\": …, \"color\": …, \"points\": …} with points at least");
    std::string name = fmt::format("{}", faces_.size() + 1), color, corners;
    for (const auto& [key, line, value] : node.members) {
      if (key == "name") {
        name = text_of(value, "a name");
      } else if (key == "color") {
        color = " " + text_of(value, "a colour #rrggbb");
      } else if (key == "points") {
        corners = corners_of(value);
      } else {
        whole_ = false;
        complain_(line, fmt::format("expected name, color or points, found {}", shown(key)));
      }
    }
    if (whole_ && !is_face_name(name)) {
      return wrong(node.member("name")->value,
                   "a name of at most 24 characters without ':', ';', ',' and '#'");
    }
    const std::string face = name + color + ": " + corners;
    const auto read = read_faces(face);
    if (const Misread* misread = std::get_if<Misread>(&read); misread && whole_) {
      whole_ = false;
      complain_(node.line, misread->what);
    }
    faces_.push_back(face);
  }

  std::string text_of(const JsonNode& node, std::string_view expected) {
    if (node.kind != Kind::text) wrong(node, expected);
    return node.text;
  }

  std::string corners_of(const JsonNode& list) {
    std::string corners;
    if (list.kind != Kind::list) wrong(list, "a list of points");
    for (const JsonNode& point : list.elements) {
      const auto is_number = [](const JsonNode& node) { return node.kind == Kind::number; };
      if (point.kind != Kind::list || point.elements.size() != 3 ||
          !std::ranges::all_of(point.elements, is_number)) {
        wrong(point, "a point of three numbers like [4, 3, 0]");
        continue;
      }
      const auto& c = point.elements;
      corners += fmt::format("{}{},{},{}", corners.empty() ? "" : " ", c[0].text, c[1].text, c[2].text);
    }
    return corners;
  }

  const ComplainOfLine& complain_;
  std::vector<std::string> faces_;
  bool whole_ = true;
};

std::string color_text(const Material& material) {
  const Rgba8 color = tone_of(dvec3(material.diffuse));
  return fmt::format(" #{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

std::string faces_of_obj(std::string_view text, const pipeline::TextFile& file,
                         const pipeline::FileReader& open, std::int64_t most) {
  const Mesh mesh = pipeline::parse_obj(text, file, open).mesh;
  if (std::ssize(mesh.corners) > most) {
    refuse_input(fmt::format("{}: expected at most {} corners of faces in all, found {}", file.name, most,
                             mesh.corners.size()));
  }
  std::vector<std::string> faces;
  for (const MeshFace& face : mesh.faces) {
    std::vector<std::string> corners;
    for (const Corner& corner : gradus::corners_of(mesh, face)) {
      const dvec3 p = position_of(mesh, corner);
      corners.push_back(fmt::format("{},{},{}", p.x, p.y, p.z));
    }
    const std::string color =
        face.material == 0 ? "" : color_text(mesh.materials[static_cast<std::size_t>(face.material)]);
    faces.push_back(fmt::format("{}{}: {}", faces.size() + 1, color, fmt::join(corners, " ")));
  }
  return fmt::format("{}", fmt::join(faces, "; "));
}

}  // namespace

std::optional<std::string> faces_text(const JsonNode& faces, const ComplainOfLine& complain) {
  return FacesReader(complain).read(faces);
}

std::string faces_of_file(std::string_view text, const pipeline::TextFile& file,
                          const pipeline::FileReader& open, std::int64_t most) {
  if (!pipeline::begins_as_json(text)) return faces_of_obj(text, file, open, most);
  const ComplainOfLine refuse = [&](int line, const std::string& what) {
    refuse_input(fmt::format("{}:{}: {}", file.name, line, what));
  };
  return *faces_text(read_json(text, file.name), refuse);
}

}  // namespace gradus
