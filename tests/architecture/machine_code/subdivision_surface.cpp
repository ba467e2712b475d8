// Every method of subdivision_surface as a function of its own; see machine_code_test.py.
#include "modeling/subdivision_surface/subdivision_surface.hpp"

using namespace gradus::subdivision_surface;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_catmull_clark(const Surface<double>& mesh, int levels,
                                                 Surface<double>& last) {
  last = catmull_clark(mesh, levels);
}
[[gnu::flatten]] void machine_code_loop(const Surface<double>& mesh, int levels, Surface<double>& last) {
  last = loop(mesh, levels);
}
[[gnu::flatten]] void machine_code_limit(const Surface<double>& mesh, std::int32_t vertex,
                                         Limit<double>& end) {
  end = limit(mesh, vertex);
}
}
