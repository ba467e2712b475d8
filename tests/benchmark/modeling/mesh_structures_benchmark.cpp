// Neighbours in meshes: the faces at vertices by walking and by searching, and what building takes.

#include "modeling/mesh_structures/mesh_structures.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "modeling/mesh_structures/face_vertex.hpp"
#include "modeling/mesh_structures/orientation.hpp"
#include "modeling/mesh_structures/winged_edge.hpp"

namespace gradus::bench {
namespace {

using namespace mesh_structures;

constexpr int questions = 64;

/// A torus of triangles, and vertices that are asked about. What a run finds is summed.
struct Mesh {
  Faces faces{};
  std::size_t vertices;
  std::vector<Index> asked{};
  std::optional<HalfEdges> halves{};
  WingedEdges winged{};
  std::int64_t sum = 0;

  explicit Mesh(int side) : vertices(static_cast<std::size_t>(side * side)) {
    const auto at = [&](Index x, Index y) { return x % side + side * (y % side); };
    for (Index y = 0; y < side; ++y) {
      for (Index x = 0; x < side; ++x) {
        faces.add(std::vector{at(x, y), at(x + 1, y), at(x + 1, y + 1)});
        faces.add(std::vector{at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      }
    }
    Random random(5);
    for (int i = 0; i < questions; ++i)
      asked.push_back(static_cast<Index>(random.uniform_int(0, side * side - 1)));
    halves = half_edges(faces, vertices);
    winged = winged_edges(*halves);
  }

  template <class Ask>
  std::int64_t sum_of(const Ask& ask) const {
    std::int64_t total = 0;
    for (const Index v : asked) ask(v, [&](Index f) { total += f + 1; });
    return total;
  }
  /// The definition.
  std::int64_t right() const {
    return sum_of([&](Index v, const auto& take) {
      for (std::size_t c = 0; c < faces.corners.size(); ++c) {
        if (faces.corners[c] == v) take(static_cast<Index>(c / 3));
      }
    });
  }
};

template <class Ask>
Case asking(const char* method, Standing standing, const std::shared_ptr<Mesh>& mesh, const Ask& ask) {
  const auto run = [mesh, ask] {
    mesh->sum = mesh->sum_of([&](Index v, const auto& take) { ask(*mesh, v, take); });
  };
  run();
  Error::Sum error;
  error.add(static_cast<double>(std::abs(mesh->sum - mesh->right())));
  const auto faces = static_cast<double>(mesh->faces.size());
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} faces", mesh->faces.size()), faces},
          .items = questions,
          .run = run,
          .error = error.error()};
}

template <class Build>
Case building(const char* method, Standing standing, const std::shared_ptr<Mesh>& mesh, const Build& build) {
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("building, {} faces", mesh->faces.size())},
          .items = std::ssize(mesh->faces.first) - 1,
          .run = [mesh, build] { mesh->sum = build(*mesh); },
          .error = Error::Sum().error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int side : {8, 16, 32, 64, 128}) {
    const auto mesh = std::make_shared<Mesh>(side);
    all.push_back(asking("half_edge", Standing::taught, mesh,
                         [](const Mesh& m, Index v, const auto& take) { faces_at(*m.halves, v, take); }));
    all.push_back(asking("winged_edge", Standing::robust, mesh, [](const Mesh& m, Index v, const auto& take) {
      winged_faces_at(m.winged, v, take);
    }));
    all.push_back(asking("face_vertex", Standing::robust, mesh, [](const Mesh& m, Index v, const auto& take) {
      search_faces_at(m.faces, v, take);
    }));
    if (side < 128) continue;
    const auto halves = [](const Mesh& m) { return half_edges(m.faces, m.vertices)->size(); };
    const auto wings = [](const Mesh& m) {
      return winged_edges(*half_edges(m.faces, m.vertices)).all.size();
    };
    const auto spreads = [](const Mesh& m) { return orientation(m.faces, m.vertices)->pieces; };
    all.push_back(building("half_edge", Standing::taught, mesh, halves));
    all.push_back(building("winged_edge", Standing::robust, mesh, wings));
    all.push_back(building("orientation", Standing::robust, mesh, spreads));
  }
  return all;
}

}  // namespace

Subject mesh_structures() {
  return {.topic = "mesh_structures",
          .title = "The faces at a vertex",
          .item = "question",
          .unit = "faces",
          .measure = "faces",
          .telling = "8192 faces",
          .cases = cases,
          .choice = {"half_edge", "walks to every neighbour, also along boundaries"}};
}

}  // namespace gradus::bench
