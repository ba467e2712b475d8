#pragma once
// How the faces of a surface hang together: its edges with the faces on both sides, the star of each vertex
// in counter-clockwise order, and which rule keeps what is sharp.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "core/faces.hpp"

namespace gradus::subdivision_surface {

template <class T>
using Point = glm::vec<3, T>;
template <class T>
using Points = std::vector<Point<T>>;

/// The sharpness of what stays sharp at every level.
inline constexpr double for_ever = std::numeric_limits<double>::infinity();

/// An edge that stays sharp for so many levels; a fraction is a blend of sharp and smooth.
struct Crease {
  std::int32_t a, b;
  double sharpness = for_ever;
  friend bool operator==(const Crease&, const Crease&) = default;
};
/// A vertex that stays where it is for so many levels.
struct SharpVertex {
  std::int32_t vertex;
  double sharpness = for_ever;
  friend bool operator==(const SharpVertex&, const SharpVertex&) = default;
};

/// What is subdivided. Edges with one face are its border, which is sharp for ever.
template <class T>
struct Surface {
  Points<T> points;
  Faces faces;
  std::vector<Crease> creases{};
  std::vector<SharpVertex> corners{};

  friend bool operator==(const Surface&, const Surface&) = default;
};

/// An edge, as the first of its faces runs along it.
struct Edge {
  std::int32_t a, b;
  std::int32_t f, g;  ///< the faces left and right of it; on the border twice the same
  std::int32_t c, d;  ///< the corners of the faces where it begins there: at a, at b; on the border c twice
  double sharpness;   ///< for_ever on the border

  bool border() const { return c == d; }
  /// How much of its point is the midpoint.
  double sharp() const { return std::min(sharpness, 1.0); }
};

/// A vertex with what is round it, counter-clockwise: face i lies between the edges i and i + 1. On the
/// border there is one edge more than faces.
struct Star {
  std::int32_t vertex;
  std::span<const std::int32_t> edges, faces;

  bool border() const { return edges.size() != faces.size(); }
  double valence() const { return static_cast<double>(edges.size()); }
};

/// What a vertex point is made of; the parts add up to 1.
struct Rule {
  double smooth = 1, crease = 0, corner = 0;
  std::int32_t a, b;  ///< where its crease leads, or twice the vertex itself

  /// The point of these three.
  template <class T>
  Point<T> blend(const Point<T>& as_smooth, const Point<T>& on_crease, const Point<T>& there) const {
    return T(smooth) * as_smooth + T(crease) * on_crease + T(corner) * there;
  }
};

class Links {
 public:
  /// Errors: ContractViolation that names the place if an edge has more than two faces or two that run along
  /// it the same way, if the faces at a vertex are no single fan or there are none, if a crease is no edge,
  /// and for sharpness below 0. The surface must outlive it.
  /// Cost: sorts the edges; memory linear.
  template <class T>
  explicit Links(const Surface<T>& surface) : faces_(surface.faces), count_(surface.points.size()) {
    join_sides();
    collect_stars();
    sharpen(surface.creases, surface.corners);
  }

  const std::vector<Edge>& edges() const { return edges_; }
  std::span<const std::int32_t> ring(std::int32_t face) const { return faces_[at(face)]; }
  /// Those of all faces.
  std::vector<std::span<const std::int32_t>> rings() const {
    std::vector<std::span<const std::int32_t>> rings;
    for (std::size_t f = 0; f < faces_.size(); ++f) rings.push_back(faces_[f]);
    return rings;
  }
  /// The stars of all vertices.
  std::vector<Star> stars() const {
    std::vector<Star> stars;
    for (std::size_t v = 0; v < count_; ++v) stars.push_back(star(static_cast<std::int32_t>(v)));
    return stars;
  }
  Star star(std::int32_t vertex) const {
    const std::size_t v = at(vertex);
    const auto f = begin(first_face_, v), e = begin(first_edge_, v);
    return {vertex, std::span(star_edges_).subspan(e, begin(first_edge_, v + 1) - e),
            std::span(star_faces_).subspan(f, begin(first_face_, v + 1) - f)};
  }
  /// The vertex across from an edge in the triangle of this corner, where the edge begins or ends.
  std::int32_t opposite(std::int32_t corner) const { return faces_.corners[at(previous(corner))]; }
  /// What the next level has at the i-th corner of a face of this mesh: numbers of the points of the vertex,
  /// the edge behind it, the face and the edge before it. Behind the last corner the first comes again.
  std::array<std::int32_t, 4> quad(std::span<const std::int32_t> ring, std::size_t i) const {
    const std::int32_t c = first_of(ring) + static_cast<std::int32_t>(i % ring.size());
    const auto face_point = static_cast<std::int32_t>(count_ + edges_.size()) + face_of_[at(c)];
    return {faces_.corners[at(c)], edge_point(c), face_point, edge_point(previous(c))};
  }
  /// The same of a triangle's part at a corner; i = 3: the one in its middle.
  std::array<std::int32_t, 3> fourth(std::span<const std::int32_t> ring, std::size_t i) const {
    const std::int32_t first = first_of(ring), c = first + static_cast<std::int32_t>(i % 3);
    if (i == 3) return {edge_point(first), edge_point(first + 1), edge_point(first + 2)};
    return {faces_.corners[at(c)], edge_point(c), edge_point(previous(c))};
  }
  /// The other end of an edge at a vertex.
  std::int32_t across(std::int32_t edge, std::int32_t v) const {
    return edges_[at(edge)].a == v ? edges_[at(edge)].b : edges_[at(edge)].a;
  }

  /// A vertex with a sharpness of its own or more than two sharp edges is a corner, one with two lies on a
  /// crease. Where a level from now another rule holds, because something was no sharper than 1, the two
  /// rules blend by how sharp that was on the average.
  Rule rule(const Star& star) const {
    Rule rule{.a = star.vertex, .b = star.vertex};
    const Kind now = kind(star, 0), then = kind(star, 1);
    if (now == Kind::smooth) return rule;
    const double part = now == then ? 1 : fading(star);
    rule.smooth = 0;
    share_of(now, rule) += part;
    share_of(then, rule) += 1 - part;
    if (rule.crease > 0) std::tie(rule.a, rule.b) = ends(star, now == Kind::crease ? 0 : 1);
    return rule;
  }
  /// Creases and corners of the next level, whose vertices behind those of this one are the edges' points.
  template <class T>
  void hand_down(Surface<T>& next) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto& [a, b, f, g, c, d, sharpness] = edges_[e];
      const auto middle = static_cast<std::int32_t>(count_ + e);
      if (c == d || !(sharpness > 1)) continue;
      next.creases.push_back({a, middle, sharpness - 1});
      next.creases.push_back({middle, b, sharpness - 1});
    }
    for (std::size_t v = 0; v < count_; ++v) {
      if (sharpness_[v] > 1) next.corners.push_back({static_cast<std::int32_t>(v), sharpness_[v] - 1});
    }
  }
  /// Whether anything at this vertex is sharp for some levels only.
  bool fades(const Star& star) const {
    const auto passing = [](double s) { return s > 0 && s < for_ever; };
    return passing(sharpness_[at(star.vertex)]) ||
           std::ranges::any_of(star.edges, [&](std::int32_t e) { return passing(edges_[at(e)].sharpness); });
  }

 private:
  enum class Kind : std::uint8_t { smooth, crease, corner };

  std::int32_t first_of(std::span<const std::int32_t> ring) const {
    return static_cast<std::int32_t>(ring.data() - faces_.corners.data());
  }
  std::int32_t edge_point(std::int32_t corner) const {
    return static_cast<std::int32_t>(count_) + edge_of_[at(corner)];
  }
  static std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }
  static std::size_t begin(const std::vector<std::int32_t>& first, std::size_t i) { return at(first[i]); }

  std::int32_t next(std::int32_t c) const {
    const std::size_t f = at(face_of_[at(c)]);
    return c + 1 == faces_.first[f + 1] ? faces_.first[f] : c + 1;
  }
  std::int32_t previous(std::int32_t c) const {
    const std::size_t f = at(face_of_[at(c)]);
    return (c == faces_.first[f] ? faces_.first[f + 1] : c) - 1;
  }

  /// Sides of faces that have the same two ends are one edge.
  void join_sides() {
    expect_faces(faces_, count_);
    struct Side {
      std::int32_t low, high, corner;
    };
    std::vector<Side> sides;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      face_of_.insert(face_of_.end(), faces_[f].size(), static_cast<std::int32_t>(f));
    for (std::int32_t c = 0; c < std::ssize(faces_.corners); ++c) {
      const auto [low, high] = std::minmax(faces_.corners[at(c)], faces_.corners[at(next(c))]);
      sides.push_back({low, high, c});
    }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.corner); });
    edge_of_.resize(sides.size());
    twin_.assign(sides.size(), -1);
    for (std::size_t i = 0, n = 0; i < sides.size(); i += n) {
      const Side& side = sides[i];
      n = 1;
      while (i + n < sides.size() && sides[i + n].low == side.low && sides[i + n].high == side.high) ++n;
      const std::int32_t c = side.corner, a = faces_.corners[at(c)], d = sides[i + n - 1].corner;
      const std::int32_t f = face_of_[at(c)], g = face_of_[at(d)];
      expects(n <= 2, "an edge has at most two faces, but from vertex {} to {} there are {}", side.low,
              side.high, n);
      expects(n == 1 || faces_.corners[at(d)] != a,
              "faces {} and {} run the same way along the edge from vertex {} to {}: turn one over", f, g,
              side.low, side.high);
      edge_of_[at(c)] = edge_of_[at(d)] = static_cast<std::int32_t>(edges_.size());
      if (n == 2) std::tie(twin_[at(c)], twin_[at(d)]) = std::pair(d, c);
      edges_.push_back({a, a == side.low ? side.high : side.low, f, g, c, d, n == 1 ? for_ever : 0.0});
    }
  }
  /// From the first side on the border, or the first face, always on to the face on the left.
  void collect_stars() {
    std::vector<std::int32_t> start(count_, -1), faces(count_, 0);
    for (std::int32_t c = 0; c < std::ssize(twin_); ++c) {
      const std::size_t v = at(faces_.corners[at(c)]);
      if (start[v] < 0 || twin_[at(c)] < 0) start[v] = c;
      ++faces[v];
    }
    for (std::size_t v = 0; v < count_; ++v) {
      expects(start[v] >= 0, "every vertex is a corner of some face, but vertex {} is not", v);
      first_edge_.push_back(static_cast<std::int32_t>(star_edges_.size()));
      first_face_.push_back(static_cast<std::int32_t>(star_faces_.size()));
      for (std::int32_t c = start[v]; c >= 0;) {
        star_edges_.push_back(edge_of_[at(c)]);
        star_faces_.push_back(face_of_[at(c)]);
        --faces[v];
        const std::int32_t p = previous(c);
        c = twin_[at(p)];
        if (c < 0) star_edges_.push_back(edge_of_[at(p)]);
        if (c == start[v]) break;
      }
      expects(faces[v] == 0, "the faces at vertex {} are several fans: give each a vertex of its own", v);
    }
    first_edge_.push_back(static_cast<std::int32_t>(star_edges_.size()));
    first_face_.push_back(static_cast<std::int32_t>(star_faces_.size()));
  }
  void sharpen(const std::vector<Crease>& creases, const std::vector<SharpVertex>& corners) {
    sharpness_.assign(count_, 0);
    const auto key = [](const Edge& e) { return std::minmax(e.a, e.b); };
    for (const Crease& crease : creases) {
      const std::pair<std::int32_t, std::int32_t> wanted = std::minmax(crease.a, crease.b);
      const auto edge = std::ranges::lower_bound(
          edges_, wanted, {}, [&](const Edge& e) { return std::pair<std::int32_t, std::int32_t>(key(e)); });
      expects(edge != edges_.end() && std::pair<std::int32_t, std::int32_t>(key(*edge)) == wanted,
              "a crease is an edge, but from vertex {} to {} there is none", crease.a, crease.b);
      expects(crease.sharpness >= 0, "a sharpness is at least 0, not {}", crease.sharpness);
      edge->sharpness = std::max(edge->sharpness, crease.sharpness);
    }
    for (const auto& [v, sharpness] : corners) {
      expects(v >= 0 && at(v) < count_, "a corner is a vertex, but there is no vertex {}", v);
      expects(sharpness >= 0, "a sharpness is at least 0, not {}", sharpness);
      sharpness_[at(v)] = std::max(sharpness_[at(v)], sharpness);
    }
  }

  /// The rule so many levels from now.
  Kind kind(const Star& star, double levels) const {
    const auto sharp =
        std::ranges::count_if(star.edges, [&](std::int32_t e) { return edges_[at(e)].sharpness > levels; });
    if (sharpness_[at(star.vertex)] > levels || sharp > 2) return Kind::corner;
    return sharp == 2 ? Kind::crease : Kind::smooth;
  }
  /// The mean sharpness of what is sharp now and not in a level.
  double fading(const Star& star) const {
    double sum = 0;
    int count = 0;
    const auto take = [&](double s) {
      if (!(s > 0 && s <= 1)) return;
      sum += s;
      ++count;
    };
    take(sharpness_[at(star.vertex)]);
    for (const std::int32_t e : star.edges) take(edges_[at(e)].sharpness);
    return sum / count;
  }
  std::pair<std::int32_t, std::int32_t> ends(const Star& star, double levels) const {
    std::array<std::int32_t, 2> ends{star.vertex, star.vertex};
    std::size_t found = 0;
    for (const std::int32_t e : star.edges) {
      if (edges_[at(e)].sharpness > levels) ends[found++] = across(e, star.vertex);
    }
    return {ends[0], ends[1]};
  }
  static double& share_of(Kind kind, Rule& rule) {
    return kind == Kind::smooth ? rule.smooth : kind == Kind::crease ? rule.crease : rule.corner;
  }

  const Faces& faces_;
  std::size_t count_;
  std::vector<std::int32_t> face_of_{}, edge_of_{}, twin_{};  ///< of each corner
  std::vector<Edge> edges_{};                                 ///< by their lower and higher ends
  std::vector<std::int32_t> first_edge_{}, first_face_{}, star_edges_{}, star_faces_{};
  std::vector<double> sharpness_{};  ///< of each vertex
};

}  // namespace gradus::subdivision_surface
