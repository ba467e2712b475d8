// Every method of mesh_structures as a function of its own; see machine_code_test.py.
#include "modeling/mesh_structures/mesh_structures.hpp"

#include "modeling/mesh_structures/face_vertex.hpp"
#include "modeling/mesh_structures/mesh_structures_notes.hpp"
#include "modeling/mesh_structures/orientation.hpp"
#include "modeling/mesh_structures/winged_edge.hpp"

using namespace gradus;
using namespace gradus::mesh_structures;

void take(Index i);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_half_edges(const Faces& faces, std::size_t n, HalfEdges& mesh) {
  if (auto found = half_edges(faces, n)) mesh = std::move(*found);
}
[[gnu::flatten]] void machine_code_faces_at(const HalfEdges& mesh, Index v) { faces_at(mesh, v, take); }
[[gnu::flatten]] void machine_code_first_fan_only(const HalfEdges& mesh, Index v) {
  first_fan_only(mesh, v, take);
}
[[gnu::flatten]] void machine_code_edges_round(const HalfEdges& mesh, Index h) { edges_round(mesh, h, take); }
// One answer alone is too short to be compared
[[gnu::flatten]] Index machine_code_face_across(const HalfEdges& mesh, std::span<const Index> halves) {
  Index sum = 0;
  for (const Index h : halves) {
    const Index f = face_across(mesh, h);
    sum = f == none ? sum + h : f - sum;
  }
  return sum;
}
[[gnu::flatten]] void machine_code_winged_faces_at(const WingedEdges& mesh, Index v) {
  winged_faces_at(mesh, v, take);
}
[[gnu::flatten]] void machine_code_winged_edges_round(const WingedEdges& mesh, Index f) {
  winged_edges_round(mesh, f, take);
}
[[gnu::flatten]] Index machine_code_winged_face_across(const WingedEdges& mesh,
                                                       std::span<const Index> edges) {
  Index sum = 0;
  for (const Index e : edges) sum = winged_face_across(mesh, e, sum);
  return sum;
}
[[gnu::flatten]] void machine_code_search_faces_at(const Faces& faces, Index v) {
  search_faces_at(faces, v, take);
}
[[gnu::flatten]] Index machine_code_search_face_across(const Faces& faces, Index a, Index b, Index f) {
  return search_face_across(faces, a, b, f);
}
[[gnu::flatten]] bool machine_code_spread(Ways& ways, Index f, Turns& turned) {
  return spread(ways, f, turned);
}
[[gnu::flatten]] bool machine_code_any_number_of_faces(Ways& ways, Index f, Turns& turned) {
  return any_number_of_faces(ways, f, turned);
}
}
