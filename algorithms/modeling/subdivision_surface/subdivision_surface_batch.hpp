#pragma once
// Many levels of catmull_clark at once. From the first level on all faces are quadrilaterals, and what lies
// beside what in the next level follows from numbers alone: half k of edge e becomes edge 2 e + k, corner i
// of face f becomes face 4 f + i, and one more edge leads from the i-th edge's point to the face's. Nothing
// is sorted or looked up; faces add what they have to their edges and vertices.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "modeling/subdivision_surface/subdivision_surface.hpp"

namespace gradus::subdivision_surface {

/// A level whose faces are quadrilaterals, with the arrays that make the next one.
class QuadLevel {
 public:
  /// mesh: a level of catmull_clark, without creases and corners.
  explicit QuadLevel(Surface<double> mesh) : points_(std::move(mesh.points)) {
    mesh.points = points_;
    const Links net(mesh);
    for (const Edge& e : net.edges()) {
      ends_.push_back({e.a, e.b});
      border_.push_back(e.border() ? 1 : 0);
    }
    const auto before = static_cast<std::int32_t>(points_.size());
    for (const auto ring : net.rings()) {
      for (std::size_t i = 0; i < 4; ++i) edges_.push_back(net.quad(ring, i)[1] - before);
    }
    vertices_ = std::move(mesh.faces.corners);
  }

  /// The next one. whole: with edges, for one more.
  QuadLevel next(bool whole) const {
    QuadLevel next;
    next.points_ = refined_points();
    next.vertices_.resize(4 * vertices_.size());
    const std::int32_t edge_points = count(points_), face_points = edge_points + count(ends_);
    for (std::size_t c = 0; c < vertices_.size(); ++c) {
      const std::size_t p = before(c);
      const auto f = static_cast<std::int32_t>(c / 4);
      const std::array<std::int32_t, 4> quad{vertices_[c], edge_points + edges_[c], face_points + f,
                                             edge_points + edges_[p]};
      std::ranges::copy(quad, next.vertices_.begin() + static_cast<std::ptrdiff_t>(4 * c));
    }
    if (whole) add_edges(next);
    return next;
  }

  Surface<double> surface() && {
    Surface<double> made{std::move(points_), {}};
    made.faces.first.resize(vertices_.size() / 4 + 1);
    for (std::size_t f = 0; f < made.faces.first.size(); ++f)
      made.faces.first[f] = static_cast<std::int32_t>(4 * f);
    made.faces.corners = std::move(vertices_);
    return made;
  }

 private:
  using Pair = std::array<std::int32_t, 2>;

  QuadLevel() = default;
  static std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }
  static std::int32_t count(const auto& all) { return static_cast<std::int32_t>(all.size()); }
  /// The corner before this one in its face.
  static std::size_t before(std::size_t c) { return c % 4 == 0 ? c + 3 : c - 1; }
  /// The half of an edge that ends in this vertex.
  std::int32_t half(std::int32_t edge, std::int32_t vertex) const {
    return 2 * edge + (ends_[at(edge)][0] == vertex ? 0 : 1);
  }

  void add_edges(QuadLevel& next) const {
    const std::int32_t edge_points = count(points_), face_points = edge_points + count(ends_);
    const std::int32_t inner = 2 * count(ends_);
    next.ends_.resize(2 * ends_.size() + vertices_.size());
    next.border_.resize(next.ends_.size());
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      const auto middle = edge_points + static_cast<std::int32_t>(e);
      next.ends_[2 * e] = {ends_[e][0], middle};
      next.ends_[2 * e + 1] = {middle, ends_[e][1]};
      next.border_[2 * e] = next.border_[2 * e + 1] = border_[e];
    }
    next.edges_.resize(next.vertices_.size());
    for (std::size_t c = 0; c < vertices_.size(); ++c) {
      const std::size_t p = before(c);
      const auto corner = static_cast<std::int32_t>(c);
      next.ends_[at(inner) + c] = {edge_points + edges_[c], face_points + corner / 4};
      const std::array<std::int32_t, 4> quad{half(edges_[c], vertices_[c]), inner + corner,
                                             inner + static_cast<std::int32_t>(p),
                                             half(edges_[p], vertices_[c])};
      std::ranges::copy(quad, next.edges_.begin() + static_cast<std::ptrdiff_t>(4 * c));
    }
  }

  /// Points of vertices, edges and faces. Q and R of a vertex are summed up as their sum Q + 2 R.
  Points<double> refined_points() const {
    const std::size_t V = points_.size(), E = ends_.size(), F = vertices_.size() / 4;
    Points<double> made(V + E + F, Point<double>(0));
    std::vector<std::int32_t> valence(V, 0);
    for (std::size_t f = 0; f < F; ++f) {
      const std::int32_t* v = &vertices_[4 * f];
      const Point<double> p =
          0.25 * ((points_[at(v[0])] + points_[at(v[1])]) + (points_[at(v[2])] + points_[at(v[3])]));
      made[V + E + f] = p;
      for (std::size_t i = 0; i < 4; ++i) {
        made[at(v[i])] += p;
        made[V + at(edges_[4 * f + i])] += p;
      }
    }
    for (std::size_t e = 0; e < E; ++e) {
      const auto [a, b] = ends_[e];
      const Point<double> sum = points_[at(a)] + points_[at(b)];
      made[V + e] = border_[e] != 0 ? 0.5 * sum : 0.25 * (sum + made[V + e]);
      made[at(a)] += sum;
      made[at(b)] += sum;
      ++valence[at(a)];
      ++valence[at(b)];
    }
    for (std::size_t v = 0; v < V; ++v) {
      const double n = valence[v];
      made[v] = (made[v] / n + (n - 3) * points_[v]) / n;
    }
    round_border(made);
    return made;
  }
  /// Vertices of the border: 3/4 of themselves, 1/8 of both neighbours on it.
  void round_border(Points<double>& made) const {
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (border_[e] == 0) continue;
      for (const std::int32_t v : ends_[e]) made[at(v)] = 0.75 * points_[at(v)];
    }
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (border_[e] == 0) continue;
      const auto [a, b] = ends_[e];
      made[at(a)] += 0.125 * points_[at(b)];
      made[at(b)] += 0.125 * points_[at(a)];
    }
  }

  Points<double> points_{};
  std::vector<std::int32_t> vertices_{}, edges_{};  ///< of each face, four behind each other
  std::vector<Pair> ends_{};                        ///< of each edge
  std::vector<char> border_{};                      ///< whether it has one face
};

/// As catmull_clark, in a fraction of its time: the same faces in the same order, with the same corners but
/// for roundings. From the third level on the points of edges have other numbers.
///
/// mesh, levels: as for catmull_clark. With creases or corners it is catmull_clark.
///
/// Domain, Errors: as catmull_clark.
/// Accuracy: corners within 1e-14 M of catmull_clark's after five levels, M the largest coordinate.
/// Cost: linear in the faces of the last level; sorts the edges of the first two alone.
inline Surface<double> catmull_clark_batch(const Surface<double>& mesh, int levels) {
  if (levels < 2 || !mesh.creases.empty() || !mesh.corners.empty()) return catmull_clark(mesh, levels);
  expect_surface(mesh, levels);
  QuadLevel level(catmull_clark(mesh, 1));
  for (int k = 2; k <= levels; ++k) level = level.next(k < levels);
  return std::move(level).surface();
}

}  // namespace gradus::subdivision_surface
