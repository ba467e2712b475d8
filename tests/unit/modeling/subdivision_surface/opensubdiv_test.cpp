// Subdivision surfaces beside OpenSubdiv's: the points of every level, with borders, creases and corners that
// are sharp for some levels, and limits.

#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/random.hpp"
#include "unit/modeling/subdivision_surface/shapes.hpp"

namespace gradus::subdivision_surface {
namespace {

using namespace OpenSubdiv;
using Mesh = Surface<double>;
constexpr double bound = 1e-6;

/// A point as OpenSubdiv adds up weights.
struct Theirs {
  dvec3 p{0};
  void Clear() { p = dvec3{0}; }
  void AddWithWeight(const Theirs& other, double weight) { p += weight * other.p; }
};

/// Their vertices of all levels, the last one's neighbours included.
std::unique_ptr<Far::TopologyRefiner> refined(const Mesh& mesh, Sdc::SchemeType scheme, int levels) {
  std::vector<int> sizes, pairs, sharp;
  std::vector<float> weights, corner_weights;
  const auto of = [](double sharpness) { return static_cast<float>(std::min(sharpness, 10.0)); };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) sizes.push_back(static_cast<int>(mesh.faces[f].size()));
  for (const auto& [a, b, sharpness] : mesh.creases) {
    pairs.insert(pairs.end(), {a, b});
    weights.push_back(of(sharpness));
  }
  for (const auto& [v, sharpness] : mesh.corners) {
    sharp.push_back(v);
    corner_weights.push_back(of(sharpness));
  }
  Far::TopologyDescriptor given;
  given.numVertices = static_cast<int>(mesh.points.size());
  given.numFaces = static_cast<int>(sizes.size());
  given.numVertsPerFace = sizes.data();
  given.vertIndicesPerFace = mesh.faces.corners.data();
  given.numCreases = static_cast<int>(weights.size());
  given.creaseVertexIndexPairs = pairs.data();
  given.creaseWeights = weights.data();
  given.numCorners = static_cast<int>(sharp.size());
  given.cornerVertexIndices = sharp.data();
  given.cornerWeights = corner_weights.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(given, Factory::Options(scheme, options)));
  Far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  return refiner;
}

std::vector<Theirs> their_points(const Far::TopologyRefiner& refiner, const Mesh& mesh, int levels) {
  const Far::PrimvarRefinerReal<double> interpolate(refiner);
  std::vector<Theirs> now;
  for (const dvec3 p : mesh.points) now.push_back({p});
  for (int k = 1; k <= levels; ++k) {
    std::vector<Theirs> next(static_cast<std::size_t>(refiner.GetLevel(k).GetNumVertices()));
    interpolate.Interpolate(k, now, next);
    now = std::move(next);
  }
  return now;
}

double apart(dvec3 a, dvec3 b) {
  const dvec3 off = glm::abs(a - b);
  return std::max({off.x, off.y, off.z});
}

/// How far the worst of our points lies from the nearest of theirs; as many must there be.
double off(const Mesh& mesh, Sdc::SchemeType scheme, int levels) {
  const auto refiner = refined(mesh, scheme, levels);
  const auto theirs = their_points(*refiner, mesh, levels);
  const Mesh ours = scheme == Sdc::SCHEME_LOOP ? loop(mesh, levels) : catmull_clark(mesh, levels);
  EXPECT_EQ(ours.points.size(), theirs.size());
  EXPECT_EQ(ours.faces.size(), static_cast<std::size_t>(refiner->GetLevel(levels).GetNumFaces()));
  double worst = 0;
  for (const dvec3 p : ours.points) {
    double nearest = 1e9;
    for (const Theirs& q : theirs) nearest = std::min(nearest, apart(p, q.p));
    worst = std::max(worst, nearest);
  }
  return worst;
}

/// Some of its edges and vertices sharp for up to 3.5 levels, some for ever; its points moved at random.
Mesh sharpened(Mesh mesh, Random& random) {
  const std::vector<Edge> edges = Links(mesh).edges();
  const auto sharpness = [&] { return random.uniform_int(0, 4) == 0 ? for_ever : random.uniform(0, 3.5); };
  for (const Edge& e : edges) {
    if (random.uniform_int(0, 2) == 0) mesh.creases.push_back({e.a, e.b, sharpness()});
  }
  for (std::int32_t v = 0; v < std::ssize(mesh.points); ++v) {
    if (random.uniform_int(0, 7) == 0) mesh.corners.push_back({v, sharpness()});
  }
  for (dvec3& p : mesh.points)
    p += dvec3{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
  return mesh;
}

TEST(SubdivisionSurfaceBesideOpenSubdiv, PointsOfLevelsAreTheSame) {
  Random random(17);
  double worst = 0;
  for (int turn = 0; turn < 12; ++turn) {
    for (const Mesh& shape : {cube(), open_cube(), pencil(), arch_of_quads()}) {
      const Mesh mesh = sharpened(shape, random);
      for (const int levels : {1, 3}) worst = std::max(worst, off(mesh, Sdc::SCHEME_CATMARK, levels));
    }
    Mesh open = tetrahedron();
    open.faces = faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}});
    for (const Mesh& shape : {tetrahedron(), open})
      worst = std::max(worst, off(sharpened(shape, random), Sdc::SCHEME_LOOP, 3));
  }
  EXPECT_LE(worst, bound);
}

TEST(SubdivisionSurfaceBesideOpenSubdiv, LimitsAndNormalsAreTheSame) {
  for (const Mesh& mesh : {cube(), open_cube(), pencil(), arch_of_quads()}) {
    const auto refiner = refined(mesh, Sdc::SCHEME_CATMARK, 1);
    const auto points = their_points(*refiner, mesh, 1);
    std::vector<Theirs> ends(points.size()), s(points.size()), t(points.size());
    Far::PrimvarRefinerReal<double>(*refiner).Limit(points, ends, s, t);
    const Mesh ours = catmull_clark(mesh, 1);
    for (std::int32_t v = 0; v < std::ssize(mesh.points); ++v) {
      const dvec3 moved = ours.points[static_cast<std::size_t>(v)];
      const auto same =
          std::ranges::find_if(points, [&](const Theirs& p) { return apart(p.p, moved) < 1e-9; });
      ASSERT_NE(same, points.end());
      const auto i = static_cast<std::size_t>(same - points.begin());
      const auto [point, normal] = limit(mesh, v);
      EXPECT_LE(apart(point, ends[i].p), bound) << v;
      const dvec3 theirs = glm::cross(s[i].p, t[i].p);
      EXPECT_LE(apart(normal / length_of(normal), theirs / length_of(theirs)), bound) << v;
    }
  }
}

}  // namespace
}  // namespace gradus::subdivision_surface
