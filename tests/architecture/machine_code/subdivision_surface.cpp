// Every method of subdivision_surface as a function of its own; see machine_code_test.py.
#include "modeling/subdivision_surface/subdivision_surface.hpp"
#include "modeling/subdivision_surface/subdivision_surface_notes.hpp"

using namespace gradus::subdivision_surface;

using Mesh = Surface<double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_catmull_clark_level(const Mesh& mesh, Mesh& next) {
  next = catmull_clark_level(mesh);
}
[[gnu::flatten]] void machine_code_always_four(const Mesh& mesh, Mesh& next) { next = always_four(mesh); }
[[gnu::flatten]] void machine_code_loop_level(const Mesh& mesh, Mesh& next) { next = loop_level(mesh); }
[[gnu::flatten]] void machine_code_limit(const Mesh& mesh, std::int32_t vertex, Limit<double>& end) {
  end = limit(mesh, vertex);
}
}
