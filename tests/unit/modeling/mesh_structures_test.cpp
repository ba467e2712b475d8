// Known meshes, walks that come back, the same answers from all three structures, orders that don't count,
// refusals by name.

#include "modeling/mesh_structures/mesh_structures.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/mesh_structures/counts.hpp"
#include "modeling/mesh_structures/face_vertex.hpp"
#include "modeling/mesh_structures/mesh_structures_notes.hpp"
#include "modeling/mesh_structures/orientation.hpp"
#include "modeling/mesh_structures/winged_edge.hpp"

namespace gradus::mesh_structures {
namespace {

using Set = std::multiset<Index>;

const Faces sample = faces_of({{0, 1, 2}, {1, 3, 2}, {2, 3, 5}, {3, 4, 5}});
const Faces moebius = faces_of({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
const Faces bow_tie = faces_of({{0, 1, 2}, {1, 3, 2}, {2, 5, 4}, {2, 6, 5}});
const Faces book = faces_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
const Faces cube =
    faces_of({{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});

/// A torus of n x m quadrilaterals; `twisted`: a Klein bottle. open: without its last row.
Faces grid(Index n, Index m, bool twisted = false, bool open = false) {
  Faces faces;
  const auto at = [&](Index x, Index y) { return (twisted && y == m ? n - x : x) % n + n * (y % m); };
  for (Index y = 0; y + (open ? 1 : 0) < m; ++y) {
    for (Index x = 0; x < n; ++x) {
      faces.add(std::vector{at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.add(std::vector{at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return faces;
}

template <class Ask>
Set set_of(const Ask& ask) {
  Set found;
  ask([&](Index i) { found.insert(i); });
  return found;
}
Set at_vertex(const HalfEdges& mesh, Index v) {
  return set_of([&](const auto& take) { faces_at(mesh, v, take); });
}

/// Faces in another order, each from another corner on.
Faces shuffled(const Faces& faces, Random& random) {
  std::vector<std::vector<Index>> rings;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    rings.emplace_back(faces[f].begin(), faces[f].end());
    std::ranges::rotate(rings.back(),
                        rings.back().begin() + random.uniform_int(0, static_cast<int>(faces[f].size()) - 1));
    std::swap(rings[static_cast<std::size_t>(random.uniform_int(0, static_cast<int>(f)))], rings.back());
  }
  return faces_of(rings);
}

TEST(MeshStructures, SampleMeshIsTheKnownOne) {  // G001-17
  const Counts counts = counts_of(sample, 6);
  EXPECT_EQ(counts, (Counts{6, 9, 4, 6, 0, 1, 1, 0, 0}));
  EXPECT_EQ(counts.euler(), 1);
  std::set<std::pair<Index, Index>> boundary;
  const Edges edges(sample);
  for (Index e = 0; e < edges.size(); ++e) {
    if (fit_of(edges[e]) == Fit::boundary) boundary.insert(edges[e][0].ends());
    EXPECT_LE(fit_of(edges[e]), Fit::twins);
  }
  EXPECT_EQ(boundary, (std::set<std::pair<Index, Index>>{{0, 1}, {0, 2}, {1, 3}, {2, 5}, {3, 4}, {4, 5}}));
  const auto found = orientation(sample, 6);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->turned, Turns(4, 0));
}

TEST(MeshStructures, FacesAtV3AreTheFirstThree) {
  const auto mesh = half_edges(sample, 6);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(at_vertex(*mesh, 2), (Set{0, 1, 2}));
  EXPECT_EQ(set_of([](const auto& take) { search_faces_at(sample, 2, take); }), (Set{0, 1, 2}));
}

TEST(MeshStructures, AWingedEdgeHasBothFacesAndFourWings) {
  const WingedEdges mesh = winged_edges(*half_edges(sample, 6));
  // v2 v3 is the third edge: v3 v1 and v1 v2 lie round f1, v2 v4 and v4 v3 round f2
  const WingedEdge& w = mesh[2];
  EXPECT_EQ((std::vector{w.from, w.to, w.left, w.right}), (std::vector<Index>{1, 2, 0, 1}));
  EXPECT_EQ((std::vector{w.left_before, w.left_next, w.right_before, w.right_next}),
            (std::vector<Index>{0, 1, 4, 3}));
  EXPECT_EQ(winged_face_across(mesh, 2, 0), 1);
  EXPECT_EQ(winged_face_across(mesh, 2, 1), 0);
}

TEST(MeshStructures, AMoebiusStripIsNotOrientable) {  // G001-18
  const Counts counts = counts_of(moebius, 5);
  EXPECT_EQ(counts, (Counts{5, 10, 5, 5, 0, 1, 1, 0, 0}));
  EXPECT_EQ(counts.euler(), 0);
  Recorder<Seeded, Demanded> seen;
  EXPECT_FALSE(orientation(moebius, 5, seen));
  EXPECT_EQ(std::get<Demanded>(seen.events().back().step).outcome, Outcome::conflicts);
  EXPECT_FALSE(half_edges(moebius, 5));
}

TEST(MeshStructures, AKleinBottleIsNotOrientable) {  // G001-19
  const Counts counts = counts_of(grid(4, 4, true), 16);
  EXPECT_EQ(counts, (Counts{16, 48, 32, 0, 0, 0, 1, 0, 0}));
  EXPECT_FALSE(orientation(grid(4, 4, true), 16));
  EXPECT_TRUE(orientation(grid(4, 4), 16));
}

/// A loop of an even number of triangles that is turned over once differs from an odd one only in the twist.
TEST(MeshStructures, ReversingAFaceIsFoundAndUndone) {
  Random random(3);
  for (const Faces& faces : {sample, cube, grid(5, 4), grid(4, 6, false, true), bow_tie}) {
    const auto vertices = static_cast<std::size_t>(*std::ranges::max_element(faces.corners)) + 1;
    Turns turns(count_of(faces), 0);
    for (Index& t : turns) t = static_cast<Index>(random.uniform_int(0, 1));
    const Faces mixed = turned_faces(faces, turns);
    const auto found = orientation(mixed, vertices);
    ASSERT_TRUE(found);
    EXPECT_TRUE(half_edges(turned_faces(mixed, found->turned), vertices));
  }
}

TEST(MeshStructures, NextAndTwinComeBack) {
  for (const Faces& faces : {sample, cube, grid(5, 4), grid(4, 6, false, true), bow_tie}) {
    const auto vertices = static_cast<std::size_t>(*std::ranges::max_element(faces.corners)) + 1;
    const auto mesh = half_edges(faces, vertices);
    ASSERT_TRUE(mesh);
    for (Index h = 0; h < mesh->size(); ++h) {
      const HalfEdge& half = (*mesh)[h];
      EXPECT_EQ((*mesh)[half.twin].twin, h);
      EXPECT_NE(half.twin, h);
      EXPECT_EQ((*mesh)[half.next].before, h);
      EXPECT_EQ((*mesh)[half.next].from, mesh->to(h));
      EXPECT_EQ((*mesh)[half.next].face, half.face);
    }
    for (Index f = 0; f < count_of(faces); ++f) {
      std::vector<Index> ring;
      edges_round(*mesh, mesh->of_face[f], [&](Index h) { ring.push_back((*mesh)[h].from); });
      EXPECT_TRUE(std::ranges::equal(ring, ring_of(faces, f)));
    }
    EXPECT_EQ(mesh->loops.size(), counts_of(faces, vertices).loops);
  }
}

TEST(MeshStructures, AllStructuresAnswerAlikeInEveryOrderOfFaces) {
  Random random(9);
  for (const Faces& whole : {sample, cube, grid(5, 4), grid(4, 6, false, true), bow_tie}) {
    const Faces faces = shuffled(whole, random);
    const auto vertices = static_cast<std::size_t>(*std::ranges::max_element(faces.corners)) + 1;
    EXPECT_EQ(counts_of(faces, vertices), counts_of(whole, vertices));
    const auto mesh = half_edges(faces, vertices);
    ASSERT_TRUE(mesh);
    const WingedEdges winged = winged_edges(*mesh);
    for (Index v = 0; v < static_cast<Index>(vertices); ++v) {
      const Set searched = set_of([&](const auto& take) { search_faces_at(faces, v, take); });
      EXPECT_EQ(at_vertex(*mesh, v), searched);
      EXPECT_EQ(set_of([&](const auto& take) { winged_faces_at(winged, v, take); }), searched);
    }
    const Edges edges(faces);
    for (Index e = 0; e < edges.size(); ++e) {
      for (const Side& s : edges[e]) {
        const Index across = search_face_across(faces, s.from, s.to, s.face);
        EXPECT_EQ(face_across(*mesh, s.corner), across);
        EXPECT_EQ(winged_face_across(winged, e, s.face), across);
      }
    }
    for (Index f = 0; f < count_of(faces); ++f) {
      const Set asked = set_of([&](const auto& take) { winged_edges_round(winged, f, take); });
      Set right;
      for (Index c = faces.first[static_cast<std::size_t>(f)];
           c < faces.first[static_cast<std::size_t>(f) + 1]; ++c)
        right.insert(edges.at(c));
      EXPECT_EQ(asked, right);
    }
  }
}

TEST(MeshStructures, APinchedVertexKeepsAllItsFans) {
  const Counts counts = counts_of(bow_tie, 8);
  EXPECT_EQ(counts, (Counts{8, 10, 4, 8, 0, 2, 2, 1, 1}));
  const auto mesh = half_edges(bow_tie, 8);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->fans[2].size(), 2u);
  EXPECT_EQ(at_vertex(*mesh, 2), (Set{0, 1, 2, 3}));
  EXPECT_EQ(at_vertex(*mesh, 7), Set{});
  Set fault;
  first_fan_only(*mesh, 2, [&](Index f) { fault.insert(f); });
  EXPECT_EQ(fault, (Set{0, 1}));
}

TEST(MeshStructures, AnEdgeOfThreeFacesIsRefusedByName) {  // E001-09
  Recorder<FacePlaced, EdgeJoined, LoopClosed> seen;
  EXPECT_FALSE(half_edges(book, 5, seen));
  const auto& last = std::get<EdgeJoined>(seen.events().back().step);
  EXPECT_EQ(last.fit, Fit::crowded);
  EXPECT_EQ(last.sides.size(), 3u);
  EXPECT_EQ(last.sides[0].ends(), std::pair(0, 1));
  EXPECT_FALSE(orientation(book, 5));
  EXPECT_EQ(counts_of(book, 5).loops, none);
  Ways ways(book);
  Turns turned(3, none);
  EXPECT_TRUE(any_number_of_faces(ways, 0, turned));
}

TEST(MeshStructures, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<FacePlaced, EdgeJoined, LoopClosed> built;
  const auto mesh = half_edges(sample, 6, built);
  EXPECT_EQ(mesh->all, half_edges(sample, 6)->all);
  EXPECT_EQ(all<FacePlaced>(built).size(), 4u);
  EXPECT_EQ(all<EdgeJoined>(built).size(), 9u);
  ASSERT_EQ(all<LoopClosed>(built).size(), 1u);
  EXPECT_EQ(all<LoopClosed>(built)[0].count, 6);
  Recorder<Turned> turned;
  faces_at(*mesh, 2, [](Index) {}, turned);
  EXPECT_EQ(turned.events().size(), 4u);
  EXPECT_TRUE(std::get<Turned>(turned.events().back().step).round);
  Recorder<Seeded, Demanded> spread;
  EXPECT_EQ(orientation(sample, 6, spread)->turned, orientation(sample, 6)->turned);
  EXPECT_EQ(all<Demanded>(spread).size(), 3u);
}

TEST(MeshStructures, MistakesAreNamed) {
  for (const Faces& faces : {faces_of({{0, 1}}), faces_of({{0, 1, 9}}), faces_of({{0, 1, 0}})}) {
    EXPECT_THROW(half_edges(faces, 3), ContractViolation);
    EXPECT_THROW(orientation(faces, 3), ContractViolation);
    EXPECT_THROW(counts_of(faces, 3), ContractViolation);
  }
  EXPECT_EQ(counts_of({}, 2), (Counts{2, 0, 0, 0, 0, 0, 2, 2, 0}));
}

}  // namespace
}  // namespace gradus::mesh_structures
