#pragma once
// What stories of culling draw: the faces in space with the normal and the view vector, what the eye sees of
// them, and one face's plane edge-on, where the angle is true.

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "projection/viewing/viewing.hpp"
#include "stories/visibility/faces_subject.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

namespace gradus::back_face_culling {

template <class Vec>
std::vector<std::span<const Vec>> spans_of(const std::vector<std::vector<Vec>>& rings) {
  return {rings.begin(), rings.end()};
}

/// What a run is about: faces, and their viewer.
struct Subject {
  std::vector<NamedFace> faces;
  std::vector<Ring> rings = mapped(faces, &NamedFace::points);
  bool distant = false;  ///< the eye is infinitely far away
  Eye<double> eye{};
  Frame<double> frame{};     ///< of the eye, or of a place before the faces
  std::vector<Ring> view{};  ///< right, up, forward
  dvec3 middle = faces_subject::bounds_of(faces).centre();
  double radius = faces_subject::bounds_of(faces).radius();

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
    return mapped(clip(),
                  [](const Ring& ring) { return mapped(ring, [](dvec3 p) { return dvec2(p) / p.z; }); });
  }
  /// A place inside a face, for its name.
  dvec3 inside(std::size_t face) const {
    return middle_of(faces_subject::is_flat(rings[face]) ? convex_parts(rings[face])[0] : rings[face]);
  }
  /// Whether all corners have such a depth.
  template <class Is>
  bool depths_are(const Is& such) const {
    return std::ranges::all_of(clip(),
                               [&](const Ring& ring) { return std::ranges::all_of(ring, such, &dvec3::z); });
  }
  bool eye_is_near() const { return !distant && length_between(dvec3(eye), middle) <= 4.5 * radius; }
};

inline Subject subject_of(const Arguments& arguments, std::vector<NamedFace> faces) {
  Subject subject{std::move(faces)};
  if (const auto towards = arguments.place("towards")) {
    const faces_subject::Reader reader = faces_subject::reader_of(arguments);
    subject.distant = true;
    subject.eye = {*towards, 0};
    subject.frame = {dvec3{0}, reader.right, reader.up, -reader.towards};
  } else {
    const dvec3 eye = *arguments.place("eye"), target = *arguments.place("target");
    if (eye == target) refuse(arguments, {"target", "eye"}, "a target away from the eye expected");
    subject.eye = {eye, 1};
    subject.frame = viewing::spare_up(eye, target, dvec3{0, 1, 0});
  }
  for (const Ring& ring : subject.rings)
    subject.view.push_back(mapped(ring, [&](dvec3 p) { return subject.in_view(p); }));
  return subject;
}
inline Subject subject_of(const Arguments& arguments) {
  return subject_of(arguments, faces_subject::faces_of(arguments));
}

/// Every corner must have its place in the picture; behind the eye it has one, too.
inline void require_places(const Arguments& arguments, const Subject& subject, std::string_view what,
                           bool behind_too) {
  if (subject.depths_are([&](double w) { return behind_too ? w != 0 : w > 1e-6 * subject.radius; })) return;
  refuse(arguments, {"eye", "target", what},
         behind_too ? "corners in front of the eye or behind it expected, found one beside it"
                    : "corners in front of the eye expected, found one behind it: clip first");
}

/// How a face looks by now.
struct Look {
  Role role = Role::past;
  bool dashed = false, at_hand = false;
  int rank = 0;  ///< of two faces, the higher one draws the edge between them
};

/// An edge as the face that draws it looks.
template <class Vec>
struct DrawnEdge {
  Look look;
  Vec a, b;
};

/// All edges of some faces, each once, those of the least rank first.
template <class Vec>
std::vector<DrawnEdge<Vec>> edges_by_rank(const std::vector<std::vector<Vec>>& rings,
                                          const std::vector<Look>& looks) {
  std::vector<DrawnEdge<Vec>> all, edges;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (const auto& [a, b] : sides_of(rings[i])) all.push_back({looks[i], a, b});
  }
  std::ranges::stable_sort(all, std::greater{}, [](const auto& edge) { return edge.look.rank; });
  for (const DrawnEdge<Vec>& edge : all) {
    const auto same = [&](const DrawnEdge<Vec>& e) {
      return (e.a == edge.a && e.b == edge.b) || (e.a == edge.b && e.b == edge.a);
    };
    if (std::ranges::none_of(edges, same)) edges.push_back(edge);
  }
  std::ranges::reverse(edges);
  return edges;
}

// --- Space

/// The faces from beside the eye.
class SpacePicture {
 public:
  SpacePicture(const Subject& subject, const Extent& place, bool of_clip_space)
      : subject_(subject),
        of_clip_space_(of_clip_space),
        reader_(unit_vector(-0.2 * subject.frame.forward - 0.9 * subject.frame.right +
                            (of_clip_space ? 0.65 : 0.4) * subject.frame.up)),
        panel_(place, {}) {
    Extent extent;
    for (const Ring& ring : subject.rings) {
      extent.add(reader_.flat(tip_of(ring[0], newell_normal<double>(ring))));
      extent.add(reader_.flat(ring[0] + view_arrow(ring[0])));
      for (const dvec3 p : ring) extent.add(reader_.flat(p));
    }
    if (subject.eye_is_near()) extent.add(reader_.flat(dvec3(subject.eye)));
    for (const dvec3 p : eye_plane()) extent.add(reader_.flat(p));
    panel_ = Panel(place, extent);
  }

  void add(View& view, const std::vector<Look>& looks) const {
    SpaceDrawing drawing(reader_.look(panel_));
    for (std::size_t i = 0; i < subject_.rings.size(); ++i) {
      add_face(drawing, fmt::format("b {:03}", i), looks[i].role, subject_.rings[i]);
    }
    std::size_t number = 0;
    for (const auto& [look, a, b] : edges_by_rank(subject_.rings, looks)) {
      drawing.add(SpaceEdge{.id = fmt::format("b edge {:03}", number++),
                            .role = look.role,
                            .a = a,
                            .b = b,
                            .dashed = look.dashed,
                            .thin = look.dashed,
                            .behind = look.at_hand});
    }
    number = 0;
    for (const auto& [a, b] : sides_of(eye_plane())) {
      drawing.add(SpaceEdge{.id = fmt::format("c plane {}", number++),
                            .role = Role::boundary,
                            .a = a,
                            .b = b,
                            .dashed = true,
                            .thin = true});
    }
    drawing.add_to(view, "a");
    // A name stands on what it names, where that is seen
    const HiddenLines lines(subject_.rings, distant_viewer(reader_.towards), subject_.radius);
    for (std::size_t i = 0; i < looks.size(); ++i) {
      const dvec3 p = subject_.inside(i);
      if (!lines.pieces(p, p + 1e-3 * (subject_.rings[i][0] - p)).front().hidden)
        view.add({fmt::format("n {:03}", i), looks[i].role, Text{at(p), subject_.faces[i].name}});
    }
    if (subject_.eye_is_near()) view.add_named("e eye", Role::boundary, at(dvec3(subject_.eye)), "E");
  }
  void add_normal(View& view, std::size_t face, dvec3 normal) const {
    const dvec3 p = subject_.rings[face][0];
    view.add_named("p corner", Role::current, at(p), "P");
    if (normal != dvec3{0}) add_arrow(view, "p normal", Role::input, at(p), at(tip_of(p, normal)), "N");
  }
  /// The sight line to a place.
  void add_sight(View& view, dvec3 place) const {
    view.add({"p sight", Role::measure, Stroke{at(place + view_arrow(place)), at(place)}});
    view.add({"p sight end", Role::measure, Dot{at(place)}});
  }
  void add_view(View& view, std::size_t face) const {
    const dvec3 p = subject_.rings[face][0], arrow = view_arrow(p);
    add_arrow(view, "p view", Role::measure, at(p), at(p + arrow), "V", at(p + 0.6 * arrow));
  }

  dvec2 at(dvec3 p) const { return panel_.at(reader_.flat(p)); }

 private:
  void add_face(SpaceDrawing& drawing, const std::string& id, Role role, const Ring& ring) const {
    const auto parts = faces_subject::is_flat(ring) ? std::vector<Ring>{ring} : triangles_of(ring);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      // A triangle of what is not flat may have no area
      if (length_of(newell_normal<double>(parts[k])) <= 1e-9 * subject_.radius * subject_.radius) continue;
      drawing.add(
          SpaceFace{.id = fmt::format("{} {}", id, k), .role = role, .ring = parts[k], .one_sided = false});
    }
  }
  /// A part of the plane w = 0 through the eye, where that is to be seen.
  Ring eye_plane() const {
    if (!of_clip_space_ || !subject_.eye_is_near()) return {};
    const auto corner = [&](dvec2 to) {
      return dvec3(subject_.eye) +
             0.4 * subject_.radius * (to.x * subject_.frame.right + to.y * subject_.frame.up);
    };
    return mapped(Ring2{{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}, corner);
  }
  dvec3 tip_of(dvec3 p, dvec3 normal) const { return p + 0.4 * subject_.radius * unit_vector(normal); }
  /// The view vector where the drawing has room for it, else its beginning.
  dvec3 view_arrow(dvec3 p) const {
    const dvec3 whole = view_vector<double>(std::span(&p, 1), subject_.eye);
    return subject_.eye_is_near() ? whole : subject_.radius * unit_vector(whole);
  }

  const Subject& subject_;
  const bool of_clip_space_;
  faces_subject::Reader reader_;
  Panel panel_;
};

// --- The picture that the eye sees

/// Outlines in the picture, as they come out of the division.
class EyePicture {
 public:
  /// mirrored: also of corners behind the eye, which come out mirrored.
  EyePicture(const Subject& subject, const Extent& place, bool mirrored)
      : subject_(subject), panel_(place, {}) {
    if (!subject.depths_are([&](double w) { return mirrored ? w != 0 : w > 0; })) return;
    outlines_ = subject.outlines();
    panel_ = Panel(place, extent_around(std::views::join(outlines_)));
  }
  bool empty() const { return outlines_.empty(); }

  void add(View& view, const std::vector<Look>& looks) const {
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (looks[i].rank >= 2)
        view.add({fmt::format("q {:03} inside", i), looks[i].role, Area{{panel_.at(outlines_[i])}, 1}});
    }
    std::size_t number = 0;
    for (const auto& [look, a, b] : edges_by_rank(outlines_, looks)) {
      const Stroke stroke{panel_.at(a), panel_.at(b), false, look.dashed, look.dashed};
      view.add({fmt::format("q edge {:03}", number++), look.role, stroke});
    }
  }
  void add_names(View& view, const std::vector<Look>& looks) const {
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (looks[i].rank == 0) continue;
      const dvec3 place = subject_.in_view(subject_.inside(i));
      const dvec2 at = panel_.at(dvec2(place) / (subject_.distant ? 1 : place.z));
      view.add({fmt::format("r {:03} name", i), looks[i].role, Text{at, subject_.faces[i].name}});
    }
  }
  /// Which way a face turns: an arrow along each edge.
  void add_turn(View& view, std::size_t face, Role role, bool numbered) const {
    if (empty()) return;
    const Ring2 ring = panel_.at(outlines_[face]);
    std::size_t number = 0;
    for (const auto& [a, b] : sides_of(ring))
      view.add({fmt::format("t turn {:02}", number++), role, Stroke{a, a + 0.62 * (b - a), true}});
    for (std::size_t k = 0; k < (numbered ? ring.size() : 1); ++k)
      view.add_named(fmt::format("t corner {:02}", k), role, ring[k],
                     numbered ? fmt::format("{}", k + 1) : "P");
  }
  /// A triangle from the first corner on.
  void add_triangle(View& view, std::size_t face, std::size_t corner, Role role) const {
    const Ring2 ring = panel_.at(outlines_[face]);
    add_ring(view, "s triangle", role, {ring[0], ring[corner], ring[corner + 1]}, 2);
  }

 private:
  const Subject& subject_;
  std::vector<Ring2> outlines_{};
  Panel panel_;
};

// --- A section

/// The faces cut by a plane through the eye and a face's middle, along that face's normal, which points
/// upwards: there the angle is true, and the eye is above the face that it sees.
/// along_z: from the face against the view direction, where that is taken for the view vector.
inline void add_section(View& view, const Extent& place, const Subject& subject,
                        const std::vector<Look>& looks, std::size_t face, dvec3 normal, bool with_view,
                        std::optional<dvec3> along_z) {
  if (normal == dvec3{0}) return;
  const dvec3 middle = subject.inside(face), up = unit_vector(normal);
  const dvec3 whole = view_vector<double>(std::span(&middle, 1), subject.eye);
  const dvec3 to_eye = subject.eye_is_near() ? whole : 1.5 * subject.radius * unit_vector(whole);
  const double cosine = std::clamp(glm::dot(up, unit_vector(whole)), -1.0, 1.0);
  dvec3 across = to_eye - glm::dot(to_eye, up) * up;
  if (length_of(across) < 1e-6 * length_of(to_eye))
    across = glm::cross(
        up, std::abs(glm::dot(up, subject.frame.up)) < 0.9 ? subject.frame.up : subject.frame.right);
  across = unit_vector(across);
  const dvec3 aside = glm::cross(up, across);
  const auto flat = [&](dvec3 way) { return dvec2{glm::dot(way, across), glm::dot(way, up)}; };

  struct Piece {
    std::size_t face;
    dvec2 a, b;
  };
  std::vector<Piece> pieces;
  Extent extent;
  const double tip = 0.45 * subject.radius;
  for (const dvec2 p : {flat(to_eye), dvec2{0, tip}, dvec2{-tip, 0}, dvec2{tip, 0}}) extent.add(p);
  for (std::size_t i = 0; i < subject.rings.size(); ++i) {
    Ring2 cuts;
    for (const auto& [a, b] : sides_of(subject.rings[i])) {
      const double from = glm::dot(a - middle, aside), to = glm::dot(b - middle, aside);
      if ((from > 0) != (to > 0)) cuts.push_back(flat(a + from / (from - to) * (b - a) - middle));
    }
    if (cuts.empty()) continue;
    const dvec2 start = cuts[0], way = cuts[1] - cuts[0];
    std::ranges::sort(cuts, {}, [&](dvec2 p) { return glm::dot(p - start, way); });
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) pieces.push_back({i, cuts[k], cuts[k + 1]});
    for (const dvec2 p : cuts) extent.add(p);
  }
  const Panel panel(place, widened(extent, 0.08));
  const auto at = [&](dvec2 p) { return panel.at(p); };
  std::size_t number = 0;
  for (const auto& [i, a, b] : pieces) {
    const std::string id = fmt::format("e cut {:03}", number++);
    const bool its = i == face;
    view.add({id, its ? Role::current : looks[i].role, Stroke{at(a), at(b), false, false, !its}});
    if (!its) view.add({id + " name", looks[i].role, Label{at(0.5 * (a + b)), subject.faces[i].name}});
    const dvec2 out = flat(unit_vector(newell_normal<double>(subject.rings[i])));
    if (!its && length_of(out) > 0.2)
      view.add({id + " normal", looks[i].role,
                Stroke{at(0.5 * (a + b)), at(0.5 * (a + b) + 0.6 * tip * out), true, false, true}});
  }
  view.add({"e plane", Role::guide,
            Stroke{at({panel.shown().lower.x, 0}), at({panel.shown().upper.x, 0}), false, true, true}});
  view.add({"e front", Role::guide, Text{at({panel.shown().lower.x, 0}) + dvec2{0.5, 0.8}, "+"}});
  view.add({"e behind", Role::guide, Text{at({panel.shown().lower.x, 0}) + dvec2{0.5, -0.8}, "−"}});
  view.add({"e point", Role::current, Dot{at({0, 0})}});
  add_arrow(view, "e normal", Role::input, at({0, 0}), at({0, tip}), "N");
  if (subject.eye_is_near()) view.add_named("e the eye", Role::boundary, at(flat(to_eye)), "E");
  if (!with_view) return;
  add_arrow(view, "e view", Role::measure, at({0, 0}), at(flat(to_eye)), "V", at(0.7 * flat(to_eye)));
  if (along_z) add_arrow(view, "e z", Role::rejected, at({0, 0}), at(2 * tip * flat(*along_z)), "−z");
  const double turn = gradus::acos(cosine);
  const auto on_arc = [&](double radius, double angle) {
    return at({0, 0}) + radius * dvec2{gradus::sin(angle), gradus::cos(angle)};
  };
  Ring2 arc;
  for (int i = 0; i <= 16; ++i) arc.push_back(on_arc(1, turn * i / 16));
  view.add({"e angle", Role::measure, Path{arc, false}});
  // Of all places of a flat face the product is the same, and so is what it says
  const double product = glm::dot(normal, view_vector<double>(subject.rings[face], subject.eye));
  const std::string_view right_angle = product > 0 ? "< 90°" : product < 0 ? "> 90°" : "90°";
  view.add({"e angle text", Role::measure,
            Text{on_arc(2.8, product > 0 && turn >= 1 ? turn / 2 + 0.1 : -0.8), std::string(right_angle)}});
}

}  // namespace gradus::back_face_culling
