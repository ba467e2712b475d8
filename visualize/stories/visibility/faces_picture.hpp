#pragma once
// Faces as a distant reader sees them, with their names; and what becomes of them when they are painted over
// each other in some order.

#include "stories/visibility/faces_subject.hpp"
#include "stories/visibility/name_places.hpp"

namespace gradus {

/// A convex face as it is shown now.
struct ShownFace {
  std::string name;
  std::vector<dvec3> ring;
  Role role;
};

class FacesPicture {
 public:
  /// points: all that must have room in the place.
  FacesPicture(const faces_subject::Reader& reader, const Extent& place, const std::vector<dvec3>& points)
      : reader_(reader),
        panel_(place, extent_around(mapped(points, [&](dvec3 p) { return reader.flat(p); }))) {}

  dvec2 at(dvec3 p) const { return panel_.at(reader_.flat(p)); }

  /// The faces as they stand in space; `more`: lines there.
  void add(View& view, const std::vector<ShownFace>& faces, const std::vector<SpaceEdge>& more = {}) const {
    SpaceDrawing drawing(reader_.look(panel_));
    for (const SpaceEdge& edge : more) drawing.add(edge);
    draw(view, std::move(drawing), faces);
  }

  /// Each face over all that come before it, wherever it stands: they are laid on a pile, the first below.
  /// ground: outlines below all of them, of what is still to come.
  void add_painted(View& view, std::vector<ShownFace> faces,
                   const std::vector<std::vector<dvec3>>& ground = {}) const {
    double size = 1e-9;
    for (const ShownFace& face : faces) {
      for (const dvec3 p : face.ring) size = std::max(size, glm::length(reader_.flat(p)));
    }
    const double sheet = size / static_cast<double>(faces.size() + 1);
    SpaceDrawing drawing(reader_.look(panel_));
    for (std::size_t i = 0; i < ground.size(); ++i) {
      std::size_t number = 0;
      for (const auto& [a, b] : sides_of(ground[i])) {
        drawing.add(SpaceEdge{.id = fmt::format("a ground {:03} {:02}", i, number++),
                              .role = Role::past,
                              .a = lifted(a, 0),
                              .b = lifted(b, 0),
                              .thin = true,
                              .behind = false});
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (dvec3& p : faces[i].ring) p = lifted(p, sheet * static_cast<double>(i + 1));
    }
    draw(view, std::move(drawing), faces, ground);
  }

 private:
  /// On a sheet of this height over the paper.
  dvec3 lifted(dvec3 p, double height) const {
    const dvec2 flat = reader_.flat(p);
    return flat.x * reader_.right + flat.y * reader_.up + height * reader_.towards;
  }

  /// Names keep out of the outlines of what is still to come, where they can.
  void draw(View& view, SpaceDrawing drawing, const std::vector<ShownFace>& faces,
            const std::vector<std::vector<dvec3>>& ground = {}) const {
    std::vector<std::vector<dvec3>> rings;
    double size = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto& [name, ring, role] = faces[i];
      const std::string id = fmt::format("b {:03}", i);
      drawing.add(SpaceFace{.id = id, .role = role, .ring = ring, .one_sided = false, .shade = 2});
      std::size_t number = 0;
      for (const auto& [a, b] : sides_of(ring)) {
        drawing.add(SpaceEdge{
            .id = fmt::format("{} {:02}", id, number++), .role = role, .a = a, .b = b, .behind = false});
        size = std::max(size, length_between(a, faces[0].ring[0]));
      }
      rings.push_back(ring);
    }
    drawing.add_to(view, "a");
    const HiddenLines lines(rings, distant_viewer(reader_.towards), size);
    const auto flat = [&](dvec3 p) { return reader_.flat(p); };
    const std::vector<Ring2> waiting = mapped(ground, [&](const Ring& ring) { return mapped(ring, flat); });
    // A name is as wide as this: so far it keeps away from their outlines
    const double aside = 0.05 * size;
    const auto is_clear = [&](dvec3 p) {
      return std::ranges::all_of(
          waiting, [&](const Ring2& ring) { return depth_inside(ring, reader_.flat(p)) < -aside; });
    };
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (const auto place = faces_subject::seen_place(faces[i].ring, lines, is_clear))
        view.add({fmt::format("n {:03}", i), faces[i].role, Text{at(*place), faces[i].name}});
    }
  }

  faces_subject::Reader reader_;
  Panel panel_;
};

}  // namespace gradus
