// A smooth surface as faces: levels of a control mesh, beside OpenSubdiv where it is there.

#include "modeling/subdivision_surface/subdivision_surface_batch.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/geometry.hpp"
#ifdef GRADUS_HAS_OPENSUBDIV
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#endif

namespace gradus::bench {
namespace {

using namespace subdivision_surface;
using Mesh = Surface<double>;

/// A cube with one face cut into triangles.
const Mesh& control() {
  static const Mesh mesh{
      {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
      faces_of({{0, 2, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})};
  return mesh;
}

/// How far vertices of a level lie from where they end: their limits, by the first few.
Error off_the_limit(const Mesh& level) {
  Error::Sum sum;
  const std::int32_t tried = 8;
  for (std::int32_t v = 0; v < tried; ++v)
    sum.add(length_of(limit(control(), v).point - level.points[static_cast<std::size_t>(v)]));
  return sum.error();
}

template <class Make>
Case case_of(const char* method, Standing standing, int levels, const Make& make) {
  const auto last = std::make_shared<Mesh>(catmull_clark(control(), levels));
  const Error error = off_the_limit(*last);
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} levels", levels), static_cast<double>(levels)},
          .items = static_cast<std::int64_t>(last->faces.size()),
          .run = [last, make] { make(*last); },
          .error = error};
}

#ifdef GRADUS_HAS_OPENSUBDIV
struct Theirs {
  dvec3 p{0};
  void Clear() { p = dvec3{0}; }
  void AddWithWeight(const Theirs& other, double weight) { p += weight * other.p; }
};

/// From the control mesh to the points of the last level: topology and points.
void opensubdiv(int levels, std::vector<Theirs>& last) {
  using namespace OpenSubdiv;
  std::vector<int> sizes;
  for (std::size_t f = 0; f < control().faces.size(); ++f)
    sizes.push_back(static_cast<int>(control().faces[f].size()));
  Far::TopologyDescriptor given;
  given.numVertices = static_cast<int>(control().points.size());
  given.numFaces = static_cast<int>(sizes.size());
  given.numVertsPerFace = sizes.data();
  given.vertIndicesPerFace = control().faces.corners.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(given, Factory::Options(Sdc::SCHEME_CATMARK)));
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(levels));
  const Far::PrimvarRefinerReal<double> interpolate(*refiner);
  std::vector<Theirs> now;
  for (const dvec3 p : control().points) now.push_back({p});
  for (int k = 1; k <= levels; ++k) {
    last.assign(static_cast<std::size_t>(refiner->GetLevel(k).GetNumVertices()), {});
    interpolate.Interpolate(k, now, last);
    std::swap(now, last);
  }
}
#endif

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int levels : {2, 3, 4, 5, 6, 7, 8}) {
    all.push_back(case_of("catmull_clark", Standing::taught, levels,
                          [levels](Mesh& last) { last = catmull_clark(control(), levels); }));
    all.push_back(case_of("catmull_clark_batch", Standing::batch, levels,
                          [levels](Mesh& last) { last = catmull_clark_batch(control(), levels); }));
#ifdef GRADUS_HAS_OPENSUBDIV
    const auto kept = std::make_shared<std::vector<Theirs>>();
    all.push_back(
        case_of("OpenSubdiv", Standing::peer, levels, [levels, kept](Mesh&) { opensubdiv(levels, *kept); }));
#endif
  }
  return all;
}

}  // namespace

Subject subdivision_surface() {
  return {.topic = "subdivision_surface",
          .title = "Smooth surfaces as faces",
          .item = "face",
          .unit = "units of length",
          .measure = "levels",
          .telling = "4 levels",
          .cases = cases,
          .choice = {"catmull_clark_batch", "nothing is sorted after the first level"}};
}

}  // namespace gradus::bench
