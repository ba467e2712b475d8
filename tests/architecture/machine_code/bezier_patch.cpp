// Every method of bezier_patch as a function of its own; see machine_code_test.py.
#include "modeling/bezier_patch/bezier_patch.hpp"

#include "modeling/bezier_patch/bezier_patch_notes.hpp"

using namespace gradus::bezier_patch;

using Net = Patch<double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_de_casteljau(const Net& net, double u, double v, Frame<double>& f) {
  f = de_casteljau(net, u, v);
}
[[gnu::flatten]] void machine_code_transposed(const Net& net, double u, double v, Frame<double>& f) {
  f = transposed(net, u, v);
}
[[gnu::flatten]] void machine_code_join(const Net& P, const Net& Q, double k, Net& joined) {
  joined = join(P, Q, Continuity::C2, k);
}
[[gnu::flatten]] void machine_code_turned_back(const Net& P, const Net& Q, double k, Net& joined) {
  joined = turned_back(P, Q, Continuity::C2, k);
}
[[gnu::flatten]] void machine_code_measure(const Net& P, const Net& Q, int places, Seam<double>& seam) {
  seam = measure(P, Q, places);
}
}
