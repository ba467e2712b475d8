#include "stories/pipeline/textbook_chain/readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "projection/viewing/viewing_notes.hpp"
#include "scene/decimal.hpp"
#include "scene/models/obj.hpp"
#include "scene/models/obj_notes.hpp"
#include "stories/point_text.hpp"

namespace gradus {
namespace {

// --- Faces and materials of an OBJ file

/// What becomes of a face: "triangle 0 1 2, colour 1 0 0".
template <class Corners>
std::string face_text(const Corners& corners, dvec3 colour) {
  return fmt::format("{} {}, colour {:g} {:g} {:g}", std::ssize(corners) == 3 ? "triangle" : "face",
                     fmt::join(corners, " "), colour.x, colour.y, colour.z);
}

std::string wrong_face(const ReadingInput& input) {
  const auto faces = pipeline::notes_faces(input.text, input.library);
  if (faces.empty()) return "nothing";
  const pipeline::NotesFace& face = faces.back();
  if (!face.failure.empty()) return fmt::format("ends: {}", face.failure);
  std::vector<std::string> triangles;
  for (const auto& triangle : face.triangles) triangles.push_back(face_text(triangle, face.colour));
  return triangles.empty() ? "nothing" : fmt::format("{}", fmt::join(triangles, "; "));
}

std::string right_face(const ReadingInput& input) {
  const auto open = [&](const std::string&) -> std::optional<pipeline::LibraryText> { return input.library; };
  const Mesh mesh = pipeline::parse_obj(input.text, "model.obj", open).mesh;
  const MeshFace& face = mesh.faces.back();
  std::vector<int> vertices;
  for (const Corner& corner : corners_of(mesh, face)) vertices.push_back(corner.position);
  const Material& material = mesh.materials[static_cast<std::size_t>(face.material)];
  return face_text(vertices, dvec3(material.diffuse));
}

// --- Points

/// A camera at (1,1,1) that is turned about z: the report's.
constexpr Frame<double> report_camera{{1, 1, 1}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};

std::string places_seen(const std::vector<dvec3>& points) {
  std::vector<std::string> places;
  for (const dvec3 p : points) {
    const dvec3 at = viewing::to_view(report_camera, p);
    places.push_back(fmt::format("({:g}, {:g}, {:g})", at.x, at.y, at.z));
  }
  return fmt::format("seen at {}", fmt::join(places, ", "));
}

/// Whole numbers row by row.
std::vector<std::vector<double>> number_rows(std::string_view text) {
  std::vector<std::vector<double>> rows;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    rows.emplace_back();
    while (!line.empty()) {
      const std::string_view word = line.substr(0, line.find(' '));
      line.remove_prefix(std::min(word.size() + 1, line.size()));
      double number = 0;
      pipeline::read_decimal(word.data(), word.data() + word.size(), number);
      rows.back().push_back(number);
    }
  }
  return rows;
}

std::string wrong_points(const ReadingInput& input) {
  return places_seen(viewing::points_of_block(number_rows(input.text)));
}

/// A point per line, as the flags of the command take points.
std::string right_points(const ReadingInput& input) {
  std::string text = input.text;
  std::ranges::replace(text, ' ', ',');
  std::ranges::replace(text, '\n', ' ');
  const std::array<std::string, 3> parts{"x", "y", "z"};
  const auto read = read_tuples(text, {parts.begin(), parts.end()});
  if (const auto* misread = std::get_if<Misread>(&read)) return fmt::format("refused: {}", misread->what);
  std::vector<dvec3> points;
  for (const Tuple& t : std::get<std::vector<Tuple>>(read)) {
    points.push_back({t[0].value, t[1].value, t[2].value});
  }
  return places_seen(points);
}

constexpr std::array all_readers{Readers{"notes_faces", wrong_face, right_face},
                                 Readers{"points_of_block", wrong_points, right_points}};

}  // namespace

const Readers* find_readers(std::string_view name) {
  const auto found = std::ranges::find(all_readers, name, &Readers::name);
  return found == all_readers.end() ? nullptr : &*found;
}

}  // namespace gradus
