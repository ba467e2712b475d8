// The promises of mesh structures: every small mesh, however wild, is oriented or refused as trying all ways
// says, and every question is answered as the definition says.

#include "modeling/mesh_structures/mesh_structures.hpp"

#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "core/contract.hpp"
#include "modeling/mesh_structures/counts.hpp"
#include "modeling/mesh_structures/orientation.hpp"
#include "modeling/mesh_structures/winged_edge.hpp"
#include "stress/exactly.hpp"

namespace gradus::stress {
namespace {

using namespace mesh_structures;

constexpr std::size_t most_faces = 8, most_vertices = 9;

/// Three vertices for each triangle; below 0: none.
Input generate(Kind kind, Random& random) {
  Input input;
  // A strip, twisted or not, of which some triangles are turned over or changed; else any triangles
  const auto round = random.uniform_int(3, most_vertices - 1), many = random.uniform_int(1, most_faces);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(most_faces); ++i) {
    std::vector<double> ring;
    for (int k = 0; k < 3; ++k) {
      const bool strip = kind != Kind::random && random.unit() < 0.97;
      ring.push_back(static_cast<double>(strip ? (i + k) % round : random.uniform_int(0, most_vertices - 1)));
    }
    if (kind == Kind::ties && random.unit() < 0.5) std::swap(ring[0], ring[1]);
    for (const double v : ring) input.push_back(i < many ? v : -1);
  }
  return input;
}

/// Nothing where numbers are no vertices. Faces with a vertex twice are given as they are.
std::optional<Faces> faces_in(const Input& i) {
  Faces faces;
  for (std::size_t f = 0; 3 * f + 2 < i.size(); ++f) {
    std::vector<Index> ring;
    for (std::size_t k = 0; k < 3; ++k) {
      const double v = i[3 * f + k];
      if (!(v == std::floor(v) && -1 <= v && v < most_vertices)) return {};
      ring.push_back(static_cast<Index>(v));
    }
    if (std::ranges::count(ring, -1) == 0) faces.add(ring);
  }
  return faces;
}

using Directed = std::multiset<std::pair<Index, Index>>;
/// The sides of all faces, those of some reversed: bit f of `turned`.
Directed sides_of(const Faces& faces, unsigned turned) {
  Directed sides;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = faces[f][k], b = faces[f][(k + 1) % 3];
      sides.insert((turned >> f & 1) != 0 ? std::pair(b, a) : std::pair(a, b));
    }
  }
  return sides;
}
/// No side twice, so that an edge has at most two faces, in opposite directions.
bool agree(const Directed& sides) { return std::ranges::adjacent_find(sides) == sides.end(); }

/// 0 where the answers are those of the definitions.
template <class Judge>
double judged(const Input& i, const Judge& judge) {
  const auto faces = faces_in(i);
  if (!faces) return 0;
  bool taken = true;
  for (std::size_t f = 0; f < faces->size(); ++f)
    taken = taken && std::set((*faces)[f].begin(), (*faces)[f].end()).size() == 3;
  try {
    return judge(*faces) && taken ? 0 : wrong;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

/// Oriented where one of all ways to turn the faces suits, and not else.
double orientation_error(const Input& i) {
  return judged(i, [](const Faces& faces) {
    bool some = false;
    for (unsigned turned = 0; turned < 1u << faces.size(); ++turned)
      some = some || agree(sides_of(faces, turned));
    const auto found = orientation(faces, most_vertices);
    return found.has_value() == some && (!found || agree(sides_of(turned_faces(faces, found->turned), 0)));
  });
}

/// Half-edges and winged edges where the faces agree as they are; then the faces at each vertex are those
/// that have it, each once.
double answers_error(const Input& i) {
  return judged(i, [](const Faces& faces) {
    const auto mesh = half_edges(faces, most_vertices);
    if (mesh.has_value() != agree(sides_of(faces, 0))) return false;
    if (!mesh) return true;
    const WingedEdges winged = winged_edges(*mesh);
    for (Index v = 0; v < static_cast<Index>(most_vertices); ++v) {
      std::multiset<Index> right, halves, wings;
      for (Index f = 0; f < count_of(faces); ++f) {
        if (has(ring_of(faces, f), v)) right.insert(f);
      }
      faces_at(*mesh, v, [&](Index f) { halves.insert(f); });
      winged_faces_at(winged, v, [&](Index f) { wings.insert(f); });
      if (halves != right || wings != right) return false;
    }
    return mesh->loops.size() == counts_of(faces, most_vertices).loops;
  });
}

}  // namespace

Domain mesh_structures() {
  const std::vector<Kind> kinds{Kind::random, Kind::ties, Kind::grazing};
  const Input moebius{0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1}, book{0, 1, 2, 1, 0, 3, 0, 1, 4};
  return {
      "mesh_structures",
      {{.name = "orientation",
        .states = "faces are oriented exactly where some way to turn them suits, of all ways",
        .unit = "answers",
        .bound = 0,
        .numbers = 3 * most_faces,
        .kinds = kinds,
        .generate = generate,
        .error = orientation_error,
        .traps = {{"a Möbius strip", moebius}, {"three pages", book}, {"a vertex twice", {0, 1, 0}}}},
       {.name = "answers",
        .states =
            "half-edges and winged edges give the faces that have a vertex, each once, and all boundaries",
        .unit = "answers",
        .bound = 0,
        .numbers = 3 * most_faces,
        .kinds = kinds,
        .generate = generate,
        .error = answers_error,
        .traps = {{"a bow-tie", {0, 1, 2, 2, 3, 4}}, {"two sides of a sheet", {0, 1, 2, 2, 1, 0}}}}}};
}

}  // namespace gradus::stress
