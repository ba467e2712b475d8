#include "stories/space_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus {
namespace {

using Part = bsp_tree::Polygon<double>;
using Plane = bsp_tree::Plane<double>;

/// Faces are not quite flat where their corners were rounded: what is as near to a plane lies in it.
struct SideWithMargin {
  double margin;

  int operator()(const Plane& plane, dvec3 p) const {
    const dvec3 normal = glm::normalize(glm::cross(plane.b - plane.a, plane.c - plane.a));
    const double height = glm::dot(normal, p - plane.a);
    return (height > margin) - (height < -margin);
  }
};

bool faces_viewer(const std::vector<dvec3>& ring, const Viewer& viewer) {
  return glm::dot(area_vector(ring), towards(viewer, ring[0])) > 0;
}

/// The part of the line p + t way that lies in a convex ring of the same plane.
std::optional<std::pair<double, double>> span_inside(const std::vector<dvec3>& ring, dvec3 p, dvec3 way,
                                                     double margin) {
  const dvec3 normal = glm::normalize(area_vector(ring));
  double from = -1e300, to = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec3 edge = ring[(i + 1) % ring.size()] - ring[i];
    const dvec3 outward = glm::cross(edge, normal);
    const double length = glm::length(outward);
    if (!(length > 0)) continue;
    const double out = glm::dot(outward, p - ring[i]) / length + margin;
    const double slope = glm::dot(outward, way) / length;
    if (std::abs(slope) <= 1e-12 * glm::length(way)) {
      if (out >= 0) return std::nullopt;
    } else if (slope < 0) {
      from = std::max(from, -out / slope);
    } else {
      to = std::min(to, -out / slope);
    }
  }
  if (to <= from) return std::nullopt;
  return std::pair(from, to);
}

/// Where two convex rings pierce each other: a segment inside both, apart from their borders.
std::optional<std::pair<dvec3, dvec3>> piercing(const std::vector<dvec3>& a, const std::vector<dvec3>& b,
                                                double size) {
  const dvec3 n = glm::normalize(area_vector(a)), m = glm::normalize(area_vector(b));
  const dvec3 way = glm::cross(n, m);
  const double square = glm::dot(way, way);
  if (!(square > 1e-16)) return std::nullopt;
  // The point of both planes that is nearest to the origin
  const dvec3 p = (glm::dot(n, a[0]) * glm::cross(m, way) + glm::dot(m, b[0]) * glm::cross(way, n)) / square;
  const double margin = 1e-7 * size;
  const auto of_a = span_inside(a, p, way, margin), of_b = span_inside(b, p, way, margin);
  if (!of_a || !of_b) return std::nullopt;
  const double from = std::max(of_a->first, of_b->first), to = std::min(of_a->second, of_b->second);
  if ((to - from) * std::sqrt(square) <= 1e-6 * size) return std::nullopt;
  return std::pair(p + from * way, p + to * way);
}

/// Whether two boxes have some place in common.
bool meet(const Bounds& a, const Bounds& b) {
  return glm::all(glm::lessThanEqual(a.lower, b.upper)) && glm::all(glm::lessThanEqual(b.lower, a.upper));
}

// --- Lines and their gaps

/// Where a line passes another on the paper: fractions of both, and which is nearer to the viewer.
struct Passing {
  double of_first, of_second;
  bool first_nearer;
};

/// A line, and the normal of the plane through it and the viewer.
struct SightPlane {
  dvec3 a, b, normal;

  SightPlane(const SpaceEdge& edge, const Viewer& viewer)
      : a(edge.a), b(edge.b), normal(glm::cross(edge.b - edge.a, towards(viewer, edge.a))) {}
};

/// The plane through the viewer and one line cuts the other at its fraction.
std::optional<double> cut_by_sight(const SightPlane& cut, const SightPlane& through) {
  const double at_a = glm::dot(through.normal, cut.a - through.a),
               at_b = glm::dot(through.normal, cut.b - through.a);
  if (at_a * at_b >= 0) return std::nullopt;
  const double part = at_a / (at_a - at_b);
  return 0.004 < part && part < 0.996 ? std::optional(part) : std::nullopt;
}

std::optional<Passing> passing(const SightPlane& first, const SightPlane& second, const Viewer& viewer,
                               double size) {
  const auto of_first = cut_by_sight(first, second);
  if (!of_first) return std::nullopt;
  const auto of_second = cut_by_sight(second, first);
  if (!of_second) return std::nullopt;
  const dvec3 p = first.a + *of_first * (first.b - first.a);
  const dvec3 q = second.a + *of_second * (second.b - second.a);
  if (glm::length(p - q) <= 1e-6 * size) return std::nullopt;  // they meet
  return Passing{*of_first, *of_second, glm::dot(p - q, towards(viewer, q)) > 0};
}

using Spans = SpaceDrawing::Spans;

bool holds(const Spans& spans, double t) {
  return std::ranges::any_of(spans, [t](const auto& s) { return s.first < t && t < s.second; });
}

/// The spans without what lies nearer than `reach` to t.
Spans without(const Spans& spans, double t, double reach) {
  Spans left;
  for (const auto& [from, to] : spans) {
    if (const double end = std::min(to, t - reach); from < end) left.emplace_back(from, end);
    if (const double start = std::max(from, t + reach); start < to) left.emplace_back(start, to);
  }
  return left;
}

}  // namespace

int shade_of(dvec3 normal) {
  constexpr dvec3 light{-0.35, 0.8, 0.5};
  const double length = length_between(dvec3(0), normal);
  const double facing = length > 0 ? glm::dot(normal / length, light) : 0;
  return facing > 0.6 ? 1 : facing > 0.25 ? 2 : 3;
}

std::vector<std::pair<dvec3, dvec3>> edges_of(const Mesh& mesh) {
  std::set<std::pair<int, int>> known;
  std::vector<std::pair<dvec3, dvec3>> edges;
  for (const MeshFace& face : mesh.faces) {
    const auto corners = corners_of(mesh, face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (known.insert(std::minmax(a.position, b.position)).second)
        edges.emplace_back(position_of(mesh, a), position_of(mesh, b));
    }
  }
  return edges;
}

std::vector<dvec3> corners_of_box(dvec3 lower, dvec3 upper) {
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({((i & 1) != 0 ? upper : lower).x, ((i & 2) != 0 ? upper : lower).y,
                       ((i & 4) != 0 ? upper : lower).z});
  return corners;
}

std::vector<std::vector<dvec3>> rings_of_box(const std::vector<dvec3>& corners) {
  std::vector<std::vector<dvec3>> rings;
  for (const Corners& numbers : faces_of_box()) {
    rings.emplace_back();
    for (const std::size_t i : numbers) rings.back().push_back(corners[i]);
  }
  return rings;
}

void SpaceDrawing::add_box(const std::string& id, Role role, const std::vector<dvec3>& corners) {
  std::size_t number = 0;
  for (auto& ring : rings_of_box(corners)) {
    for (std::size_t k = 0; k < 4; ++k)
      add(SpaceEdge{.id = fmt::format("{} {} {}", id, number, k),
                    .role = role,
                    .a = ring[k],
                    .b = ring[(k + 1) % 4],
                    .behind = false});
    add(SpaceFace{.id = fmt::format("{} {}", id, number++), .role = role, .ring = std::move(ring)});
  }
}

void SpaceDrawing::add_frame(const std::string& id, Role role, const std::vector<dvec3>& corners) {
  for (std::size_t i = 0; i < 8; ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((i & bit) == 0)
        add(SpaceEdge{
            .id = fmt::format("{} {} {}", id, i, bit), .role = role, .a = corners[i], .b = corners[i | bit]});
    }
  }
}

void SpaceDrawing::add(const std::string& id, Role role, const Mesh& mesh, EdgesShown edges) {
  const bool closed = closed_outward(mesh);
  for (const MeshFace& face : mesh.faces) {
    SpaceFace shown{fmt::format("{} {:03}", id, faces_.size()), role, {}, closed};
    for (const Corner& corner : corners_of(mesh, face)) shown.ring.push_back(position_of(mesh, corner));
    add(std::move(shown));
  }
  if (edges == EdgesShown::none) return;
  for (const auto& [a, b] : edges_of(mesh)) {
    add(SpaceEdge{.id = fmt::format("{} edge {:03}", id, edges_.size()),
                  .role = role,
                  .a = a,
                  .b = b,
                  .behind = edges == EdgesShown::all});
  }
}

double SpaceDrawing::size() const {
  Bounds bounds;
  for (const SpaceFace& face : faces_) {
    for (const dvec3 p : face.ring) bounds.add(p);
  }
  for (const SpaceEdge& edge : edges_) {
    bounds.add(edge.a);
    bounds.add(edge.b);
  }
  return bounds.empty() ? 1 : std::max(bounds.radius(), 1e-300);
}

void SpaceDrawing::add_to(View& view, const std::string& id) const {
  add_areas(view, id);
  add_lines(view);
}

/// The convex parts of all faces that can be seen.
std::vector<Part> SpaceDrawing::parts() const {
  const double least = 1e-12 * size() * size();
  std::vector<Part> parts;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (faces_[i].one_sided && !faces_viewer(faces_[i].ring, look_.viewer)) continue;
    for (auto& part : convex_parts(faces_[i].ring)) {
      if (glm::length(area_vector(part)) > least) parts.push_back({std::move(part), i});
    }
  }
  return parts;
}

/// A ring on the paper, within the frame; empty where some corner has no place there.
std::vector<dvec2> SpaceDrawing::on_paper(const std::vector<dvec3>& ring) const {
  std::vector<dvec2> places, shown;
  for (const dvec3 p : ring) {
    const auto at = look_.at(p);
    if (!at) return {};
    places.push_back(*at);
  }
  if (!look_.frame) return places;
  const AxisBox<2, double> window{look_.frame->lower, look_.frame->upper};
  for (const auto& corner : sutherland_hodgman::clip_to_window(places, window)) shown.push_back(corner.at);
  return shown;
}

/// Parts of one face that follow each other are one area, so that no seam shows between them.
void SpaceDrawing::add_areas(View& view, const std::string& id) const {
  std::vector<Mark> areas;
  std::size_t last = bsp_tree::none;
  const auto draw = [&](const Part& part) {
    std::vector<dvec2> ring = on_paper(part.corners);
    if (ring.size() < 3) return;
    if (areas.empty() || part.face != last) {
      const SpaceFace& face = faces_[part.face];
      const double turn = faces_viewer(face.ring, look_.viewer) ? 1 : -1;
      const int lit = shade_of(look_.turned(turn * area_vector(face.ring)));
      areas.push_back({fmt::format("{} {:04} {}", id, areas.size(), face.id), face.role,
                       Area{{}, face.shade > 0 ? face.shade : lit}, face.quantity});
    }
    last = part.face;
    std::get<Area>(areas.back().shape).rings.push_back(std::move(ring));
  };
  const auto tree = bsp_tree::build(parts(), SideWithMargin{1e-7 * size()});
  bsp_tree::back_to_front(tree, look_.viewer, draw);
  for (Mark& area : areas) view.add(std::move(area));
}

std::vector<SpaceEdge> SpaceDrawing::piercings() const {
  std::vector<SpaceEdge> lines;
  const double all = size();
  std::vector<std::vector<std::vector<dvec3>>> parts;
  std::vector<Bounds> boxes(faces_.size());
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    parts.push_back(faces_[i].glass ? std::vector<std::vector<dvec3>>{} : convex_parts(faces_[i].ring));
    for (const dvec3 p : faces_[i].ring) boxes[i].add(p);
  }
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (std::size_t k = i + 1; k < faces_.size(); ++k) {
      if (!meet(boxes[i], boxes[k])) continue;
      for (const auto& a : parts[i]) {
        for (const auto& b : parts[k]) {
          const auto line = piercing(a, b, all);
          if (!line) continue;
          lines.push_back({.id = fmt::format("{} meets {} {}", faces_[i].id, faces_[k].id, lines.size()),
                           .role = faces_[i].role,
                           .a = line->first,
                           .b = line->second,
                           .thin = true});
        }
      }
    }
  }
  return lines;
}

/// A fraction's place on the paper, and how the line runs there: paper units per unit of the fraction.
std::optional<SpaceDrawing::Course> SpaceDrawing::course(const SpaceEdge& edge, double part) const {
  constexpr double step = 1e-3;
  const auto here = look_.at(edge.a + part * (edge.b - edge.a));
  const auto there = look_.at(edge.a + (part + step) * (edge.b - edge.a));
  if (!here || !there) return std::nullopt;
  return Course{*here, (*there - *here) / step};
}

/// How much of the line behind goes left and right of where the one in front passes, as a fraction; nothing
/// where they run alike.
std::optional<double> SpaceDrawing::gap(const SpaceEdge& behind, double part, const SpaceEdge& front,
                                        double part_of_front) const {
  constexpr double half = 0.4, most = 1.2;  // on the paper
  const auto far = course(behind, part), near = course(front, part_of_front);
  if (!far || !near) return std::nullopt;
  const double lengths = glm::length(far->way) * glm::length(near->way);
  const double sine = std::abs(far->way.x * near->way.y - far->way.y * near->way.x) / lengths;
  if (!(sine > 0.05)) return std::nullopt;
  return std::min(half / sine, most) / glm::length(far->way);
}

void SpaceDrawing::draw(View& view, const SpaceEdge& edge, const Spans& spans, bool behind) const {
  constexpr double shortest = 0.1;  // on the paper
  int number = 0;
  for (const auto& [from, to] : spans) {
    const auto a = look_.at(edge.a + from * (edge.b - edge.a)), b = look_.at(edge.a + to * (edge.b - edge.a));
    if (!a || !b || length_between(*a, *b) < shortest) continue;
    auto stroke = look_.frame ? shown_part(*look_.frame, *a, *b) : Stroke{*a, *b};
    if (!stroke) continue;
    stroke->arrow = edge.arrow && to == 1;
    stroke->dashed = edge.dashed || behind;
    stroke->thin = edge.thin || behind;
    view.add({fmt::format("{} {}{}", edge.id, behind ? "behind " : "", number++), edge.role, *stroke,
              edge.quantity});
  }
}

void SpaceDrawing::add_lines(View& view) const {
  const double all = size();
  std::vector<std::vector<dvec3>> rings, opaque;
  for (const SpaceFace& face : faces_) {
    rings.push_back(face.ring);
    if (!face.glass) opaque.push_back(face.ring);
  }
  const HiddenLines by_all(rings, look_.viewer, all), by_opaque(opaque, look_.viewer, all);
  std::vector<SpaceEdge> edges = edges_;
  std::ranges::move(piercings(), std::back_inserter(edges));
  std::vector<Spans> seen(edges.size()), unseen(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HiddenLines& hidden = edges[i].of_glass ? by_all : by_opaque;
    for (const auto& [from, to, behind] : hidden.pieces(edges[i].a, edges[i].b))
      (behind ? unseen : seen)[i].emplace_back(from, to);
  }
  // Gaps where a line passes behind one that is seen there
  std::vector<Spans> drawn = seen;
  std::vector<SightPlane> planes;
  for (const SpaceEdge& edge : edges) planes.emplace_back(edge, look_.viewer);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = 0; k < edges.size() && !drawn[i].empty(); ++k) {
      if (i == k || edges[k].thin || seen[k].empty()) continue;
      const auto pass = passing(planes[i], planes[k], look_.viewer, all);
      if (!pass || pass->first_nearer || !holds(seen[k], pass->of_second)) continue;
      if (const auto reach = gap(edges[i], pass->of_first, edges[k], pass->of_second))
        drawn[i] = without(drawn[i], pass->of_first, *reach);
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].behind) draw(view, edges[i], unseen[i], true);
    draw(view, edges[i], drawn[i], false);
  }
}

}  // namespace gradus
