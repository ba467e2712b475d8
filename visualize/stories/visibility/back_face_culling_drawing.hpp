#pragma once
// What stories of culling draw: the faces in space with the normal and the view vector, what the eye sees of
// them, and one face's plane edge-on, where the angle is true.

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "projection/viewing/viewing.hpp"
#include "stories/visibility/faces_task.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

namespace gradus::back_face_culling {

using Ring = std::vector<dvec3>;
using Ring2 = std::vector<dvec2>;

/// What a run is about: faces, and their viewer.
struct Task {
  std::vector<NamedFace> faces;
  bool distant;  ///< the eye is infinitely far away
  Eye<double> eye;
  Frame<double> frame;       ///< of the eye, or of a place before the faces
  std::vector<Ring> view{};  ///< right, up, forward
  dvec3 middle{0};
  double radius = 1;

  std::vector<Face<double>> world() const {
    std::vector<Face<double>> all;
    for (const NamedFace& face : faces) all.push_back(face.points);
    return all;
  }
  dvec3 in_view(dvec3 p) const { return viewing::to_view(frame, p); }
  /// (x, y, w) of a lens of 90 degrees.
  std::vector<Ring> clip() const {
    std::vector<Ring> all = view;
    for (Ring& ring : all) {
      for (dvec3& p : ring) p.z = distant ? 1 : p.z;
    }
    return all;
  }
  /// The picture. Domain: no corner has w = 0.
  std::vector<Ring2> outlines() const {
    std::vector<Ring2> all;
    for (const Ring& ring : clip()) {
      all.emplace_back();
      for (const dvec3 p : ring) all.back().push_back(dvec2(p) / p.z);
    }
    return all;
  }
  /// A place inside a face, for its name.
  dvec3 inside(std::size_t face) const {
    const Ring& ring = faces[face].points;
    const Ring part = faces_task::is_flat(ring) ? convex_parts(ring)[0] : ring;
    dvec3 place{0};
    for (const dvec3 p : part) place += p / static_cast<double>(part.size());
    return place;
  }
  /// Whether a corner has no place in the picture.
  bool reaches_behind() const {
    const auto behind = [](const Ring& ring) {
      return std::ranges::any_of(ring, [](dvec3 p) { return p.z <= 0; });
    };
    return std::ranges::any_of(clip(), behind);
  }
  /// Towards the eye from the middle of all.
  dvec3 way() const {
    if (distant) return unit_vector(dvec3(eye));
    const dvec3 way = dvec3(eye) - middle;
    return length_of(way) > 1e-3 * radius ? unit_vector(way) : -frame.forward;
  }
  bool eye_is_near() const { return !distant && length_between(dvec3(eye), middle) <= 4.5 * radius; }
};

template <class Vec>
std::vector<std::span<const Vec>> spans_of(const std::vector<std::vector<Vec>>& rings) {
  return {rings.begin(), rings.end()};
}

inline Task task_of(const Arguments& arguments) {
  Task task{faces_task::faces_of(arguments), arguments.place("towards").has_value(), {}, {}};
  Bounds bounds;
  for (const NamedFace& face : task.faces) {
    for (const dvec3 p : face.points) bounds.add(p);
  }
  task.middle = bounds.centre();
  task.radius = bounds.radius();
  if (task.distant) {
    const faces_task::Reader reader = faces_task::reader_of(arguments);
    task.eye = {*arguments.place("towards"), 0};
    task.frame = {dvec3{0}, reader.right, reader.up, -reader.towards};
  } else {
    const dvec3 eye = *arguments.place("eye"), target = *arguments.place("target");
    if (eye == target) refuse(arguments, {"target", "eye"}, "a target away from the eye expected");
    task.eye = {eye, 1};
    task.frame = viewing::spare_up(eye, target, dvec3{0, 1, 0});
  }
  for (const NamedFace& face : task.faces) {
    task.view.emplace_back();
    for (const dvec3 p : face.points) task.view.back().push_back(task.in_view(p));
  }
  return task;
}

/// How a face looks by now.
struct Look {
  Role role = Role::past;
  bool filled = false, dashed = false, named = true;
  int rank = 0;  ///< of two faces, the higher one draws the edge between them
};

/// An edge of a face, and the face that draws it.
template <class Vec>
struct DrawnEdge {
  std::size_t face;
  Vec a, b;
};

/// All edges of some faces, each once, those of the least rank first.
template <class Vec>
std::vector<DrawnEdge<Vec>> edges_by_rank(const std::vector<std::vector<Vec>>& rings,
                                          const std::vector<Look>& looks) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < rings.size(); ++i) order.push_back(i);
  std::ranges::stable_sort(order,
                           [&](std::size_t i, std::size_t k) { return looks[i].rank > looks[k].rank; });
  std::vector<DrawnEdge<Vec>> edges;
  for (const std::size_t i : order) {
    for (std::size_t k = 0; k < rings[i].size(); ++k) {
      const Vec a = rings[i][k], b = rings[i][(k + 1) % rings[i].size()];
      const auto same = [&](const DrawnEdge<Vec>& e) {
        return (e.a == a && e.b == b) || (e.a == b && e.b == a);
      };
      if (std::ranges::none_of(edges, same)) edges.push_back({i, a, b});
    }
  }
  std::ranges::reverse(edges);
  return edges;
}

// --- Space

/// The faces from beside the eye.
class SpacePicture {
 public:
  SpacePicture(const Task& task, const Extent& place, bool of_clip_space)
      : task_(task),
        of_clip_space_(of_clip_space),
        reader_(unit_vector(-0.55 * task.frame.forward + 0.8 * task.frame.right +
                            (of_clip_space ? 0.65 : 0.3) * task.frame.up)),
        panel_(place, {}) {
    for (const NamedFace& face : task.faces) rings_.push_back(face.points);
    Extent extent;
    for (const NamedFace& face : task.faces) {
      const dvec3 normal = unit_vector(newell_normal<double>(face.points));
      extent.add(reader_.flat(face.points[0] + 0.4 * task.radius * normal));
      extent.add(reader_.flat(face.points[0] + view_arrow(face.points[0])));
      for (const dvec3 p : face.points) extent.add(reader_.flat(p));
    }
    if (task.eye_is_near()) extent.add(reader_.flat(dvec3(task.eye)));
    for (std::size_t k = 0; shows_eye_plane() && k < 4; ++k) extent.add(reader_.flat(corner_at_eye(k)));
    panel_ = Panel(place, extent);
  }

  void add(View& view, const std::vector<Look>& looks) const {
    SpaceDrawing drawing(reader_.look(panel_));
    for (std::size_t i = 0; i < task_.faces.size(); ++i) {
      const auto& ring = task_.faces[i].points;
      const std::string id = fmt::format("b {:03}", i);
      if (!looks[i].filled) continue;
      const auto parts = faces_task::is_flat(ring) ? std::vector<Ring>{ring} : triangles_of(ring);
      for (std::size_t k = 0; k < parts.size(); ++k) {
        // A triangle of what is not flat may have no area
        if (length_of(newell_normal<double>(parts[k])) <= 1e-9 * task_.radius * task_.radius) continue;
        const std::string part = fmt::format("{} {}", id, k);
        drawing.add(SpaceFace{.id = part, .role = looks[i].role, .ring = parts[k], .one_sided = false});
      }
    }
    const auto edges = edges_by_rank(rings_, looks);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Look& look = looks[edges[k].face];
      drawing.add(SpaceEdge{.id = fmt::format("b edge {:03}", k),
                            .role = look.role,
                            .a = edges[k].a,
                            .b = edges[k].b,
                            .dashed = look.dashed,
                            .thin = look.dashed});
    }
    for (std::size_t k = 0; shows_eye_plane() && k < 4; ++k) {
      drawing.add(SpaceEdge{.id = fmt::format("c plane {}", k),
                            .role = Role::boundary,
                            .a = corner_at_eye(k),
                            .b = corner_at_eye((k + 1) % 4),
                            .dashed = true,
                            .thin = true});
    }
    drawing.add_to(view, "a");
    for (std::size_t i = 0; i < task_.faces.size(); ++i) {
      if (!looks[i].named) continue;
      view.add({fmt::format("n {:03}", i), looks[i].role, Text{at(task_.inside(i)), task_.faces[i].name}});
    }
    if (task_.eye_is_near()) view.add_named("e eye", "e eye name", Role::boundary, at(dvec3(task_.eye)), "E");
  }
  void add_normal(View& view, std::size_t face, dvec3 normal) const {
    const dvec3 p = task_.faces[face].points[0];
    view.add({"p corner", Role::current, Dot{at(p)}});
    view.add({"p corner name", Role::current, Label{at(p), "P"}});
    if (normal == dvec3{0}) return;
    const dvec3 tip = p + 0.4 * task_.radius * unit_vector(normal);
    view.add({"p normal", Role::input, Stroke{at(p), at(tip), true}});
    view.add({"p normal name", Role::input, Label{at(tip), "N"}});
  }
  /// The sight line to a place.
  void add_sight(View& view, dvec3 place) const {
    view.add({"p sight", Role::measure, Stroke{at(place + view_arrow(place)), at(place)}});
    view.add({"p sight end", Role::measure, Dot{at(place)}});
  }
  void add_view(View& view, std::size_t face) const {
    const dvec3 p = task_.faces[face].points[0], arrow = view_arrow(p);
    view.add({"p view", Role::measure, Stroke{at(p), at(p + arrow), true}});
    view.add({"p view name", Role::measure, Label{at(p + 0.6 * arrow), "V"}});
  }

  dvec2 at(dvec3 p) const { return panel_.at(reader_.flat(p)); }

 private:
  /// The plane w = 0 through the eye.
  bool shows_eye_plane() const { return of_clip_space_ && task_.eye_is_near(); }
  dvec3 corner_at_eye(std::size_t i) const {
    const double x = i == 1 || i == 2 ? 1 : -1, y = i < 2 ? 1 : -1;
    return dvec3(task_.eye) + 0.4 * task_.radius * (x * task_.frame.right + y * task_.frame.up);
  }
  /// The view vector where the drawing has room for it, else its beginning.
  dvec3 view_arrow(dvec3 p) const {
    const dvec3 whole = view_vector<double>(std::span(&p, 1), task_.eye);
    return task_.eye_is_near() ? whole : task_.radius * unit_vector(whole);
  }

  const Task& task_;
  const bool of_clip_space_;
  std::vector<Ring> rings_{};
  faces_task::Reader reader_;
  Panel panel_;
};

// --- The picture that the eye sees

/// Outlines in the picture, as they come out of the division.
class EyePicture {
 public:
  /// mirrored: also of corners behind the eye, which come out mirrored.
  EyePicture(const Task& task, const Extent& place, bool mirrored) : task_(task), panel_(place, {}) {
    if (!mirrored && task.reaches_behind()) return;
    if (std::ranges::any_of(task.clip(), [](const Ring& ring) {
          return std::ranges::any_of(ring, [](dvec3 p) { return p.z == 0; });
        }))
      return;
    outlines_ = task.outlines();
    Extent extent;
    for (const Ring2& ring : outlines_) {
      for (const dvec2 p : ring) extent.add(p);
    }
    panel_ = Panel(place, extent);
  }
  bool empty() const { return outlines_.empty(); }

  void add(View& view, const std::vector<Look>& looks) const {
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      const std::vector<dvec2> ring = panel_.at(outlines_[i]);
      const std::string id = fmt::format("q {:03}", i);
      if (looks[i].filled) view.add({id + " inside", looks[i].role, Area{{ring}, 1}});
    }
    const auto edges = edges_by_rank(outlines_, looks);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Look& look = looks[edges[k].face];
      const Stroke stroke{panel_.at(edges[k].a), panel_.at(edges[k].b), false, look.dashed, look.dashed};
      view.add({fmt::format("q edge {:03}", k), look.role, stroke});
    }
  }
  void add_names(View& view, const std::vector<Look>& looks) const {
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (!looks[i].named) continue;
      const dvec3 place = task_.in_view(task_.inside(i));
      const dvec2 at = panel_.at(dvec2(place) / (task_.distant ? 1 : place.z));
      view.add({fmt::format("r {:03} name", i), looks[i].role, Text{at, task_.faces[i].name}});
    }
  }
  /// Which way a face turns: an arrow along each edge.
  void add_turn(View& view, std::size_t face, Role role, bool numbered) const {
    if (empty()) return;
    const std::vector<dvec2> ring = panel_.at(outlines_[face]);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const dvec2 a = ring[k], b = ring[(k + 1) % ring.size()];
      view.add({fmt::format("t turn {:02}", k), role, Stroke{a, a + 0.62 * (b - a), true}});
    }
    for (std::size_t k = 0; k < (numbered ? ring.size() : 1); ++k) {
      const std::string id = fmt::format("t corner {:02}", k);
      view.add_named(id, role, ring[k], numbered ? fmt::format("{}", k + 1) : "P");
    }
  }
  /// A triangle from the first corner on.
  void add_triangle(View& view, std::size_t face, std::size_t corner, Role role) const {
    const std::vector<dvec2> ring = panel_.at(outlines_[face]);
    const std::vector<dvec2> triangle{ring[0], ring[corner], ring[corner + 1]};
    view.add({"s triangle inside", role, Area{{triangle}, 2}});
    view.add({"s triangle", role, Path{triangle, true}});
  }

 private:
  const Task& task_;
  std::vector<Ring2> outlines_{};
  Panel panel_;
};

// --- One plane

/// A face's plane edge-on: its normal upwards, the view vector at its true angle.
/// along_z: from the face against the view direction, where that is taken for the view vector.
inline void add_edge_on(View& view, const Extent& place, dvec3 normal, std::optional<dvec3> to_eye,
                        std::optional<dvec3> along_z, const std::string& angle) {
  const Panel panel(place, {{-1.25, -1.1}, {1.25, 1.1}});
  const auto at = [&](double x, double y) { return panel.at(dvec2{x, y}); };
  view.add({"e plane", Role::current, Stroke{at(-1.25, 0), at(1.25, 0)}});
  view.add({"e point", Role::current, Dot{at(0, 0)}});
  view.add({"e point name", Role::current, Label{at(0, 0), "P"}});
  view.add({"e front", Role::guide, Text{at(-1.2, 0.22), "+"}});
  view.add({"e behind", Role::guide, Text{at(-1.2, -0.22), "−"}});
  if (normal == dvec3{0}) return;
  view.add({"e normal", Role::input, Stroke{at(0, 0), at(0, 1), true}});
  view.add({"e normal name", Role::input, Label{at(0, 1), "N"}});
  if (!to_eye || *to_eye == dvec3{0}) return;
  const double cosine = std::clamp(glm::dot(unit_vector(normal), unit_vector(*to_eye)), -1.0, 1.0);
  const double sine = std::sqrt(1 - cosine * cosine);
  view.add({"e view", Role::measure, Stroke{at(0, 0), at(sine, cosine), true}});
  view.add({"e view name", Role::measure, Label{at(sine, cosine), "V"}});
  if (along_z) {
    const dvec3 up = unit_vector(normal), across = unit_vector(unit_vector(*to_eye) - cosine * up);
    const dvec2 tip = at(glm::dot(*along_z, across), glm::dot(*along_z, up));
    view.add({"e z", Role::rejected, Stroke{at(0, 0), tip, true}});
    view.add({"e z name", Role::rejected, Label{tip, "−z"}});
  }
  std::vector<dvec2> arc;
  const double turn = gradus::acos(cosine);
  for (int i = 0; i <= 16; ++i)
    arc.push_back(at(0.36 * gradus::sin(turn * i / 16), 0.36 * gradus::cos(turn * i / 16)));
  view.add({"e angle", Role::measure, Path{arc, false}});
  view.add({"e angle text", Role::measure,
            Text{at(0.62 * gradus::sin(turn / 2), 0.62 * gradus::cos(turn / 2)), angle}});
}

}  // namespace gradus::back_face_culling
