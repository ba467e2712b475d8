#pragma once
// How a mesh is drawn: its faces, half-edges as arrows inside along their borders, and names.

#include <map>
#include <set>
#include <tuple>

#include "stories/modeling/mesh_structures/subject.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::mesh_structures {

inline constexpr int paper_width = 36, paper_height = 27;

/// An arrow along a side of a face: inside it, or outside and the other way.
struct Arrow {
  Index corner;  ///< where the side begins
  bool outside = false;
  Role role = Role::guide;
  std::string name{};
  bool dashed = false;
};

/// What a drawing shows besides the mesh.
struct Marks {
  std::map<Index, Role> faces{}, vertices{};
  std::vector<Arrow> arrows{};
  std::vector<std::pair<Index, Role>> sides{};  ///< drawn strong, by their corners
  std::vector<Index> ways{};                    ///< arrows along sides: an edge that has a direction
  std::vector<std::pair<Index, std::string>> side_names{};
  std::map<Index, bool> senses{};  ///< of faces: an arrow that goes round, reversed or not
};

class MeshDrawing {
 public:
  MeshDrawing(const Subject& subject, const Edges& edges) : subject_(subject), edges_(edges) {
    std::vector<Ring> rings;
    Bounds bounds;
    for (Index f = 0; f < count_of(subject.faces); ++f) rings.push_back(subject.ring(f));
    for (const dvec3 p : subject.at) bounds.add(p);
    const int views = subject.closed ? 2 : 1;
    for (int k = 0; k < views; ++k) {
      readers_.emplace_back(k == 0 ? subject.towards : -subject.towards);
      Extent extent;
      for (const dvec3 p : subject.at) extent.add(readers_.back().flat(p));
      for (const auto& [v, p] : subject.loose) extent.add(readers_.back().flat(p));
      extent = widened(extent, subject.closed ? 0.04 : 0.12);
      const double left = k == 0 ? 1.5 : 19, right = views == 1 ? 34.5 : left + 15.5;
      panels_.emplace_back(Extent{{left, 1.8}, {right, 25.2}}, extent);
      lines_.emplace_back(rings, distant_viewer(readers_.back().towards), bounds.radius());
    }
  }

  /// A point's place in the first picture.
  dvec2 at(dvec3 p) const { return panels_[0].at(readers_[0].flat(p)); }
  /// Of more faces names and arrows would be dots.
  bool few_faces() const { return subject_.faces.size() <= 40; }
  const Panel& panel() const { return panels_[0]; }
  bool shows_all_arrows() const { return subject_.faces.size() <= 8; }

  View draw(const Marks& marks) const {
    View view;
    for (std::size_t k = 0; k < readers_.size(); ++k) add_picture(view, marks, k);
    return view;
  }

 private:
  void add_picture(View& view, const Marks& marks, std::size_t k) const {
    const std::string id = fmt::format("{} ", k);
    SpaceDrawing drawing(readers_[k].look(panels_[k]));
    for (Index f = 0; f < count_of(subject_.faces); ++f) {
      const auto found = marks.faces.find(f);
      const bool plain = found == marks.faces.end();
      const Ring ring = subject_.ring(f);
      for (const Ring& part : is_flat(ring) ? std::vector<Ring>{ring} : triangles_of(ring))
        drawing.add(SpaceFace{.id = fmt::format("{}a face {:03}", id, f),
                              .role = plain ? Role::guide : found->second,
                              .ring = part,
                              .one_sided = false,
                              .shade = plain                             ? 1
                                       : found->second == Role::rejected ? 3
                                                                         : 2});
    }
    for (Index e = 0; e < edges_.size(); ++e) {
      for (const Side& s : edges_[e].first(subject_.cut_open ? edges_[e].size() : 1))
        add_edge(drawing, fmt::format("{}b {:03} {}", id, e, s.corner), Role::boundary, s.corner);
    }
    for (const auto& [corner, role] : marks.sides)
      add_edge(drawing, fmt::format("{}c strong {:03}", id, corner), role, corner, true);
    for (const Index corner : marks.ways) {
      const auto [a, b] = side(corner);
      drawing.add(SpaceEdge{.id = fmt::format("{}c way {:03}", id, corner),
                            .role = Role::current,
                            .a = a + 0.08 * (b - a),
                            .b = b - 0.08 * (b - a),
                            .arrow = true,
                            .behind = false});
    }
    for (std::size_t i = 0; i < marks.arrows.size(); ++i)
      add_arrow(drawing, fmt::format("{}d arrow {:03}", id, i), marks.arrows[i]);
    for (const auto& [f, reversed] : few_faces() ? marks.senses : std::map<Index, bool>{})
      add_sense(drawing, fmt::format("{}e sense {:03}", id, f), f, reversed, marks);
    drawing.add_to(view, id + "a");
    add_names(view, id, k, marks);
  }

  /// Each piece of a mesh that is drawn cut open has its own copy.
  void add_edge(SpaceDrawing& drawing, const std::string& id, Role role, Index corner,
                bool strong = false) const {
    const auto [a, b] = side(corner);
    drawing.add(SpaceEdge{
        .id = id, .role = role, .a = a, .b = b, .thin = !strong, .behind = strong && !subject_.closed});
  }
  void add_arrow(SpaceDrawing& drawing, const std::string& id, const Arrow& arrow) const {
    const auto [a, b] = arrow_ends(arrow);
    drawing.add(SpaceEdge{.id = id,
                          .role = arrow.role,
                          .a = a,
                          .b = b,
                          .arrow = true,
                          .dashed = arrow.dashed,
                          .thin = arrow.role == Role::measure,
                          .behind = false});
  }

  Index face_of(Index corner) const {
    for (const Side& s : edges_[edges_.at(corner)]) {
      if (s.corner == corner) return s.face;
    }
    return none;
  }
  std::pair<dvec3, dvec3> side(Index corner) const {
    const Ring ring = subject_.ring(face_of(corner));
    const auto k =
        static_cast<std::size_t>(corner - subject_.faces.first[static_cast<std::size_t>(face_of(corner))]);
    return {ring[k], ring[(k + 1) % ring.size()]};
  }
  std::pair<dvec3, dvec3> arrow_ends(const Arrow& arrow) const {
    const dvec3 middle = middle_of(subject_.ring(face_of(arrow.corner)));
    auto [a, b] = side(arrow.corner);
    if (!arrow.outside) return {middle + 0.7 * (a - middle), middle + 0.7 * (b - middle)};
    // As far from the edge as those inside
    const dvec3 along = unit_vector(b - a), out = 0.5 * (a + b) - middle;
    const dvec3 off = 0.3 * (out - glm::dot(out, along) * along);
    return {b + off - 0.12 * (b - a), a + off + 0.12 * (b - a)};
  }

  dvec2 flat(dvec3 p, std::size_t k) const { return panels_[k].at(readers_[k].flat(p)); }
  /// Whether the middle of a face, or a place between it and this one, is seen from its front or its back.
  bool is_seen(dvec3 p, dvec3 middle, std::size_t k) const {
    return !lines_[k].pieces(p + 0.01 * (middle - p), p + 0.02 * (middle - p)).front().hidden;
  }
  /// A place for a face's name, if there is one; those seen nearly edge-on have no room.
  std::optional<dvec3> name_place(Index f, std::size_t k) const {
    const Ring ring = subject_.ring(f);
    if (std::abs(glm::dot(unit_vector(area_vector(ring)), readers_[k].towards)) < 0.35) return {};
    if (!subject_.closed) return faces_subject::seen_place(ring, lines_[k], [](dvec3) { return true; });
    const dvec3 middle = middle_of(ring);
    return is_seen(ring[0], middle, k) && is_seen(ring[1], middle, k) ? std::optional(middle) : std::nullopt;
  }

  /// An arrow round a face, with one side left open.
  void add_sense(SpaceDrawing& drawing, const std::string& id, Index f, bool reversed,
                 const Marks& marks) const {
    Ring ring = subject_.ring(f);
    if (reversed) std::ranges::reverse(ring);
    const dvec3 middle = middle_of(ring);
    for (dvec3& p : ring) p = middle + (subject_.cut_open ? 0.75 : 0.6) * (p - middle);
    const Role role = marks.faces.contains(f) ? marks.faces.at(f) : Role::guide;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const bool last = i + 1 == ring.size();
      const dvec3 to = last ? ring[i] + 0.7 * (ring[0] - ring[i]) : ring[i + 1];
      drawing.add(SpaceEdge{.id = fmt::format("{} {}", id, i),
                            .role = role,
                            .a = ring[i],
                            .b = to,
                            .arrow = last,
                            .behind = false});
    }
  }

  void add_names(View& view, const std::string& id, std::size_t k, const Marks& marks) const {
    for (Index f = 0; few_faces() && f < count_of(subject_.faces); ++f) {
      const auto place = name_place(f, k);
      if (!place) continue;
      const auto role = marks.faces.contains(f) ? marks.faces.at(f) : Role::guide;
      view.add({fmt::format("{}f name {:03}", id, f), role, Text{flat(*place, k), face_name(f)}});
    }
    std::set<std::tuple<Index, double, double>> named;
    for (Index c = 0; c < std::ssize(subject_.faces.corners); ++c) {
      const Index v = subject_.faces.corners[static_cast<std::size_t>(c)];
      const dvec3 p = subject_.at[static_cast<std::size_t>(c)];
      const dvec2 at = flat(p, k);
      if (subject_.vertices > 26 && !marks.vertices.contains(v)) continue;
      if (!is_seen(p, middle_of(subject_.ring(face_of(c))), k) || !named.insert({v, at.x, at.y}).second)
        continue;
      const auto role = marks.vertices.contains(v) ? marks.vertices.at(v) : Role::input;
      const bool at_hand = std::ranges::any_of(marks.sides, [&](const auto& s) {
        const auto [a, b] = side(s.first);
        return a == p || b == p;
      });
      add_vertex(view, fmt::format("{}g vertex {:03} {}", id, v, c), role, at, v, k, at_hand);
    }
    for (const auto& [v, p] : subject_.loose) {
      if (subject_.vertices <= 26 || marks.vertices.contains(v))
        view.add_named(fmt::format("{}g vertex {:03}", id, v),
                       marks.vertices.contains(v) ? marks.vertices.at(v) : Role::input, flat(p, k),
                       vertex_name(v), true);
    }
    for (std::size_t i = 0; i < marks.arrows.size(); ++i) {
      const auto [a, b] = arrow_ends(marks.arrows[i]);
      add_label(view, fmt::format("{}h arrow {:03}", id, i), marks.arrows[i].role, marks.arrows[i].corner,
                0.5 * (a + b), marks.arrows[i].name, k);
    }
    for (const auto& [corner, name] : marks.side_names) {
      const auto [a, b] = side(corner);
      add_label(view, fmt::format("{}i side {:03}", id, corner), Role::measure, corner, 0.5 * (a + b), name,
                k);
    }
  }
  /// Of what is cut open, names stand outside; inside only those at hand are named: others would cover faces'
  /// names.
  void add_vertex(View& view, const std::string& id, Role role, dvec2 at, Index v, std::size_t k,
                  bool at_hand) const {
    if (!subject_.cut_open) return view.add_named(id, role, at, vertex_name(v));
    view.add({id, role, Dot{at}});
    Extent whole;
    for (const dvec3 p : subject_.at) whole.add(flat(p, k));
    const dvec2 out{at.x < whole.lower.x + 0.1   ? -1
                    : at.x > whole.upper.x - 0.1 ? 1
                                                 : 0,
                    at.y < whole.lower.y + 0.1   ? -1
                    : at.y > whole.upper.y - 0.1 ? 1
                                                 : 0};
    if (out == dvec2{0} && at_hand) view.add({id + " name", role, Label{at, vertex_name(v)}});
    if (out != dvec2{0}) view.add({id + " name", role, Text{at + dvec2{1.4, 1} * out, vertex_name(v)}});
  }
  void add_label(View& view, const std::string& id, Role role, Index corner, dvec3 at,
                 const std::string& name, std::size_t k) const {
    if (name.empty() || !is_seen(at, middle_of(subject_.ring(face_of(corner))), k)) return;
    view.add({id, role, Label{flat(at, k), name}});
  }

  const Subject& subject_;
  const Edges& edges_;
  std::vector<faces_subject::Reader> readers_;
  std::vector<Panel> panels_;
  std::vector<HiddenLines> lines_;
};

}  // namespace gradus::mesh_structures
