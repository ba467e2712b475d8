#pragma once
// Subdivision surfaces: every level puts points into the faces and edges of a mesh and moves its vertices, by
// a few fixed weights; the meshes tend to a surface that is smooth wherever nothing is marked as sharp.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/observe.hpp"
#include "modeling/subdivision_surface/links.hpp"

namespace gradus::subdivision_surface {

/// As many faces, and as many levels, as one may ask for.
inline constexpr std::int64_t most_faces = std::int64_t{1} << 24;
inline constexpr int most_levels = 12;
/// Of coordinates: no sum overflows.
inline constexpr double largest = 0x1p1000;
inline constexpr double two_pi = 6.283185307179586;

// --- Steps -------------------------------------------------------

template <class T>
struct FacePointFound {
  int level;  ///< from 1 on
  std::int32_t face;
  Point<T> point;
};

template <class T>
struct EdgePointFound {
  int level;
  std::int32_t edge;
  Point<T> middle, point;
  double sharp;  ///< how much of the point is the middle
};

/// The means around a vertex, and what they make of it.
template <class T>
struct VertexPointFound {
  int level;
  std::int32_t vertex;
  Point<T> faces, middles;  ///< Q and R; for loop the mean of the neighbours twice
  Point<T> from, point;     ///< S and S'
  Rule rule;
};

struct LevelDone {
  int level;
  std::int64_t vertices, edges, faces;  ///< edges: of the mesh before
};

/// Where a vertex ends.
template <class T>
struct LimitFound {
  std::int32_t vertex;
  std::size_t valence;
  Point<T> vertex_point, edge_points, face_points;  ///< after one level, of the latter two the means
  Point<T> point;
};

/// What touches the surface there.
template <class T>
struct NormalFound {
  std::int32_t vertex;
  Point<T> s, t, normal;
};

// --- Points ------------------------------------------------------

/// Points by their numbers.
template <class T>
struct Row {
  Points<T> all{};

  void add(const Point<T>& point) { all.push_back(point); }
  std::int32_t last() const { return static_cast<std::int32_t>(all.size()) - 1; }
  const Point<T>& operator()(std::int32_t i) const { return all[static_cast<std::size_t>(i)]; }
  Point<T> sum(std::span<const std::int32_t> which) const {
    Point<T> sum(T(0));
    for (const std::int32_t i : which) sum += (*this)(i);
    return sum;
  }
  Point<T> mean(std::span<const std::int32_t> which) const {
    return sum(which) / T(static_cast<double>(which.size()));
  }
};

/// The vertices at the other ends of its edges.
inline std::vector<std::int32_t> around(const Links& links, const Star& star) {
  std::vector<std::int32_t> all;
  for (const std::int32_t e : star.edges) all.push_back(links.across(e, star.vertex));
  return all;
}
/// The corners opposite to it in its faces, all quadrilaterals.
inline std::vector<std::int32_t> across(const Links& links, const Star& star) {
  std::vector<std::int32_t> all;
  for (const std::int32_t f : star.faces) {
    const auto ring = links.ring(f);
    const auto at = static_cast<std::size_t>(std::ranges::find(ring, star.vertex) - ring.begin());
    all.push_back(ring[(at + 2) % 4]);
  }
  return all;
}

/// The cosine of so many of n parts of a full turn.
template <class T>
T cosine(double parts, std::size_t n) {
  return T(gradus::cos(two_pi * parts / static_cast<double>(n)));
}
template <class T>
T sine(double parts, std::size_t n) {
  return T(gradus::sin(two_pi * parts / static_cast<double>(n)));
}
/// The weight of each of n neighbours. Source: Loop 1987.
template <class T>
T loop_weight(const T& n) {
  const T root = T(0.375) + T(0.25) * cosine<T>(1, static_cast<std::size_t>(static_cast<double>(n)));
  return (T(0.625) - root * root) / n;
}

template <class T>
void expect_surface(const Surface<T>& mesh, int levels) {
  expects(0 <= levels && levels <= most_levels, "0 to {} levels, not {}", most_levels, levels);
  for (const Point<T>& p : mesh.points) {
    for (int k = 0; k < 3; ++k)
      expects(all_finite(p[k]) && T(-largest) <= p[k] && p[k] <= T(largest),
              "coordinates are finite and at most 2^1000 in size");
  }
  // n faces of k corners become n k quads, then four times as many each time
  const auto first = static_cast<std::int64_t>(mesh.faces.corners.size());
  expects(levels == 0 || first << (2 * (levels - 1)) <= most_faces,
          "at most 2^24 faces in the end, not {} levels from {} corners", levels, first);
}

template <class T>
Point<T> cross_of(const Point<T>& s, const Point<T>& t) {
  return {s.y * t.z - s.z * t.y, s.z * t.x - s.x * t.z, s.x * t.y - s.y * t.x};
}

template <class T>
LevelDone level_done(int level, const Row<T>& E, const Surface<T>& mesh) {
  return {level, std::ssize(mesh.points), std::ssize(E.all), static_cast<std::int64_t>(mesh.faces.size())};
}

/// Where a vertex ends, and the normal there.
template <class T>
struct Limit {
  Point<T> point, normal;
};

/// Two directions that touch the limit surface at a vertex of a mesh of quadrilaterals: of the subdivision's
/// linear map the two eigenvectors behind the first one. Zero where there are none.
template <class T>
std::array<Point<T>, 2> tangents(const Links& net, const Row<T>& P, const Star& v) {
  const Rule rule = net.rule(v);
  const std::vector<std::int32_t> ring = around(net, v), far = across(net, v);
  std::array<Point<T>, 2> sums{Point<T>(T(0)), Point<T>(T(0))};
  auto& [s, t] = sums;
  const std::size_t n = v.faces.size();
  if (v.border() && rule.crease == 1) {
    // Along the border, and across by the sines of n parts of half a turn
    const auto sin = [&](std::size_t i) { return sine<T>(static_cast<double>(i), 2 * n); };
    const T c = cosine<T>(1, 2 * n), R = n == 1 ? T(0) : (c + T(1)) / sin(1);
    s = P(ring.front()) - P(ring.back());
    const T aside = n == 1 ? T(-1) : R * (T(1) + T(2) * c);
    t = (n == 1 ? T(-2) : T(4) * R * (c - T(1))) * P(v.vertex);
    t -= aside * (P(ring.front()) + P(ring.back()));
    for (std::size_t i = 0; n > 1 && i < n; ++i) {
      if (i > 0) t += T(4) * sin(i) * P(ring[i]);
      t += (sin(i) + sin(i + 1)) * P(far[i]);
    }
  } else if (!v.border() && rule.smooth == 1) {
    const double c = gradus::cos(two_pi / static_cast<double>(n)),
                 half = gradus::cos(two_pi / 2 / static_cast<double>(n));
    const T near(1 + c + half * std::sqrt(2 * (9 + c)));
    for (std::size_t i = 0; i < n; ++i) {
      const auto a = static_cast<double>(i);
      s += near * cosine<T>(a, n) * P(ring[i]) + (cosine<T>(a, n) + cosine<T>(a + 1, n)) * P(far[i]);
      t += near * sine<T>(a, n) * P(ring[i]) + (sine<T>(a, n) + sine<T>(a + 1, n)) * P(far[i]);
    }
  }
  return sums;
}

/// The next level: points of vertices, then of edges, then of faces.
template <class T>
Surface<T> joined(const Faces& faces, const Row<T>& V, const Row<T>& E, const Row<T>& F = {}) {
  Surface<T> next{V.all, faces};
  next.points.insert(next.points.end(), E.all.begin(), E.all.end());
  next.points.insert(next.points.end(), F.all.begin(), F.all.end());
  return next;
}

// --- The methods -------------------------------------------------

/// One level of catmull_clark. level: its number, for reports alone.
template <class T,
          Observer<FacePointFound<T>, EdgePointFound<T>, VertexPointFound<T>, LevelDone> O = Unobserved>
Surface<T> catmull_clark_level(const Surface<T>& mesh, [[maybe_unused]] int level = 1, O&& observer = {}) {
  const T h(0.5), one(1);
  const T two(2), three(3);
  const T six(6), eight(8);
  const Links net(mesh);
  const Row<T> P{mesh.points};
  Row<T> F, M;
  Row<T> E, V;
  // Face points: means of corners
  for (auto ring : net.rings()) {
    F.add(P.mean(ring));
    if constexpr (observed<O>) observer(FacePointFound<T>{level, F.last(), F.all.back()});
  }
  // Edge points
  for (Edge e : net.edges()) {
    auto m = h * (P(e.a) + P(e.b));
    auto g = h * (F(e.f) + F(e.g));
    auto p = h * (m + g);
    const T s(e.sharp());
    M.add(m);
    E.add(s * m + (one - s) * p);
    if constexpr (observed<O>) observer(EdgePointFound<T>{level, E.last(), m, E.all.back(), e.sharp()});
  }
  // Vertex points
  for (Star v : net.stars()) {
    auto S = P(v.vertex);
    // Where sharp edges meet
    const Rule r = net.rule(v);
    auto c = P(r.a) + P(r.b);
    c = (c + six * S) / eight;
    // And where none do
    auto Q = F.mean(v.faces);
    auto R = M.mean(v.edges);
    const T n(v.valence());
    auto p = Q + two * R;
    p = (p + (n - three) * S) / n;
    V.add(r.blend(p, c, S));
    if constexpr (observed<O>) observer(VertexPointFound<T>{level, v.vertex, Q, R, S, V.all.back(), r});
  }
  // A face of n corners: n quads
  Faces quads;
  for (auto ring : net.rings()) {
    const size_t n = ring.size();
    for (size_t i = 0; i < n; ++i) {
      quads.add(net.quad(ring, i));
    }
  }
  auto out = joined(quads, V, E, F);
  net.hand_down(out);
  if constexpr (observed<O>) observer(level_done(level, E, out));
  return out;
}

/// Subdivides a surface of any polygons: a face of n corners becomes n quadrilaterals. Returns the mesh of
/// the last level, whose first vertices are those that were given, moved.
/// Source: E. Catmull, J. Clark, Recursively generated B-spline surfaces on arbitrary topological meshes,
/// 1978; sharp edges by T. DeRose, M. Kass, T. Truong, Subdivision surfaces in character animation, 1998.
///
/// mesh: its points and faces, its creases and corners. levels: how often.
///
/// Domain: faces of a surface (core/faces.hpp): at most two at an edge, in one sense, one fan at a vertex;
/// every
///   vertex has faces. Coordinates of at most 2^1000; levels from 0 to 12 and at most 2^24 faces.
/// Steps: per level FacePointFound for each face, EdgePointFound for each edge, VertexPointFound for each
///   vertex, LevelDone.
/// Accuracy: each coordinate within 12 u M + m u M and as many of the smallest subnormal numbers per level,
/// where
///   M is the largest coordinate, m the most corners of a face and u = 2^-53 in double.
/// Cost: linear in the faces of the last level, but for sorting the edges of those before.
/// Errors: ContractViolation outside the domain.
template <class T,
          Observer<FacePointFound<T>, EdgePointFound<T>, VertexPointFound<T>, LevelDone> O = Unobserved>
Surface<T> catmull_clark(Surface<T> mesh, int levels, O&& observer = {}) {
  expect_surface(mesh, levels);
  for (int k = 1; k <= levels; ++k) {
    mesh = catmull_clark_level(mesh, k, observer);
  }
  return mesh;
}

/// One level of loop. level: its number, for reports alone.
template <class T, Observer<EdgePointFound<T>, VertexPointFound<T>, LevelDone> O = Unobserved>
Surface<T> loop_level(const Surface<T>& mesh, [[maybe_unused]] int level = 1, O&& observer = {}) {
  const T h(0.5), one(1);
  const T six(6), eight(8);
  const Links net(mesh);
  const Row<T> P{mesh.points};
  Row<T> E, V;
  // Edge points: 3/8 of both ends,
  // 1/8 of both corners across
  for (Edge e : net.edges()) {
    const int a = net.opposite(e.c);
    const int b = net.opposite(e.d);
    auto m = h * (P(e.a) + P(e.b));
    auto g = h * (P(a) + P(b));
    auto p = h * (m + h * (m + g));
    const T s(e.sharp());
    E.add(s * m + (one - s) * p);
    if constexpr (observed<O>) observer(EdgePointFound<T>{level, E.last(), m, E.all.back(), e.sharp()});
  }
  // Vertex points
  for (Star v : net.stars()) {
    auto S = P(v.vertex);
    // Where sharp edges meet
    const Rule r = net.rule(v);
    auto c = P(r.a) + P(r.b);
    c = (c + six * S) / eight;
    // And where none do
    auto N = P.mean(around(net, v));
    const T n(v.valence());
    const T w = loop_weight(n);
    auto p = n * w * N;
    p += (one - n * w) * S;
    V.add(r.blend(p, c, S));
    if constexpr (observed<O>) observer(VertexPointFound<T>{level, v.vertex, N, N, S, V.all.back(), r});
  }
  // Each triangle becomes four
  Faces four;
  for (auto ring : net.rings()) {
    for (size_t i = 0; i < 4; ++i) {
      four.add(net.fourth(ring, i));
    }
  }
  auto out = joined(four, V, E);
  net.hand_down(out);
  if constexpr (observed<O>) observer(level_done(level, E, out));
  return out;
}

/// Subdivides a surface of triangles: each becomes four.
/// Source: C. Loop, Smooth subdivision surfaces based on triangles, 1987; its creases as for catmull_clark.
///
/// mesh, levels: as for catmull_clark, of triangles alone.
///
/// Domain: as for catmull_clark; every face has three corners.
/// Steps: per level EdgePointFound for each edge, VertexPointFound for each vertex, LevelDone.
/// Accuracy: each coordinate within 16 u M + n u M and as many of the smallest subnormal numbers per level,
/// where n
///   is the most edges of a vertex.
/// Cost: as for catmull_clark.
/// Errors: ContractViolation outside the domain.
template <class T, Observer<EdgePointFound<T>, VertexPointFound<T>, LevelDone> O = Unobserved>
Surface<T> loop(Surface<T> mesh, int levels, O&& observer = {}) {
  expect_surface(mesh, levels);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    expects(mesh.faces[f].size() == 3, "triangles, but face {} has {} corners", f, mesh.faces[f].size());
  for (int k = 1; k <= levels; ++k) {
    mesh = loop_level(mesh, k, observer);
  }
  return mesh;
}

/// Where a vertex of catmull_clark ends after all levels, and the normal of the surface there, of any length:
/// 0 where there is none, at corners and at creases within the surface.
/// Source: M. Halstead, M. Kass, T. DeRose, Efficient, fair interpolation using Catmull-Clark surfaces, 1993;
/// borders by H. Biermann, A. Levin, D. Zorin, Piecewise smooth subdivision surfaces with normal control,
/// 2000.
///
/// mesh: as for catmull_clark. vertex: which.
///
/// Domain: as catmull_clark with 1 level; what is sharp at the vertex is so for ever.
/// Steps: LimitFound, NormalFound.
/// Accuracy: the point within 24 u M + m u M and as many of the smallest subnormal numbers; of the normal no
///   bound, since it can be a difference of nearly equal products.
/// Cost: a level of the whole mesh.
/// Errors: ContractViolation outside the domain.
template <class T, Observer<LimitFound<T>, NormalFound<T>> O = Unobserved>
Limit<T> limit(const Surface<T>& mesh, std::int32_t vertex, O&& observer = {}) {
  expects(vertex >= 0 && vertex < std::ssize(mesh.points), "there is no vertex {}", vertex);
  // One level leaves quads alone
  auto one = catmull_clark(mesh, 1);
  const Links net(one);
  const Star v = net.star(vertex);
  expects(!net.fades(v), "what is sharp at vertex {} is so for some levels only", vertex);
  const Row<T> P{one.points};
  const T n(v.valence());
  const T four(4), five(5), six(6);
  auto S = P(vertex);
  auto E = P.mean(around(net, v));
  auto F = P.mean(across(net, v));
  auto p = n * S + four * E + F;
  p = p / (n + five);
  // Where sharp edges meet
  const Rule r = net.rule(v);
  auto c = P(r.a) + P(r.b);
  c = (c + four * S) / six;
  p = r.blend(p, c, S);
  if constexpr (observed<O>) observer(LimitFound<T>{vertex, v.edges.size(), S, E, F, p});
  // Two directions that touch it
  auto ways = tangents(net, P, v);
  auto [s, t] = ways;
  auto N = cross_of(s, t);
  if constexpr (observed<O>) observer(NormalFound<T>{vertex, s, t, N});
  return {p, N};
}

}  // namespace gradus::subdivision_surface
