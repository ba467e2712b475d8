// Every method of parametric_surface as a function of its own; see machine_code_test.py.
#include "modeling/parametric_surface/parametric_surface.hpp"

#include "modeling/parametric_surface/parametric_surface_notes.hpp"

using namespace gradus;
using namespace gradus::parametric_surface;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_point(double r, const Turn<double>& s, const Turn<double>& t,
                                         SurfacePoint<double>& found) {
  found = point(r, s, t);
}
[[gnu::flatten]] void machine_code_normal_by_tangents(double r, const Turn<double>& s, const Turn<double>& t,
                                                      SurfacePoint<double>& found) {
  found = normal_by_tangents(r, s, t);
}
[[gnu::flatten]] void machine_code_patches(double r, int n, int m, Patches<double>& made) {
  made = patches(r, n, m);
}
[[gnu::flatten]] void machine_code_seam_twice(double r, int n, int m, Patches<double>& made) {
  made = seam_twice(r, n, m);
}
[[gnu::flatten]] void machine_code_lookup(const Patches<double>& mesh, double s, double t,
                                          LookedUp<double>& found) {
  found = lookup(mesh, s, t);
}
}
